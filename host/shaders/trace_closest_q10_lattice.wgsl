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
    var phi_4644_: bool;
    var phi_1173_: type_37;
    var phi_1176_: bool;
    var phi_1178_: u32;
    var phi_1180_: u32;
    var phi_1182_: type_49;
    var phi_1193_: bool;
    var phi_1279_: bool;
    var phi_1280_: u32;
    var phi_1281_: type_49;
    var phi_3504_: u32;
    var phi_3510_: u32;
    var phi_3764_: u32;
    var phi_3765_: u32;
    var phi_3775_: u32;
    var phi_3777_: u32;
    var phi_3778_: bool;
    var phi_3798_: u32;
    var phi_3799_: u32;
    var phi_3803_: type_50;
    var phi_4165_: type_49;
    var phi_4242_: type_49;
    var phi_4243_: u32;
    var phi_4244_: type_49;
    var phi_4246_: u32;
    var phi_4247_: type_49;
    var phi_4248_: bool;
    var phi_4257_: type_49;
    var phi_4262_: bool;
    var phi_4264_: type_49;
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
    var phi_4638_: bool;
    var phi_4849_: bool;
    var phi_4268_: type_37;
    var phi_4269_: bool;
    var phi_4270_: u32;
    var phi_4271_: type_49;
    var phi_4848_: bool;
    var phi_4272_: type_37;
    var phi_4273_: bool;
    var phi_4274_: u32;
    var phi_4275_: u32;
    var phi_4276_: type_49;
    var phi_4847_: bool;
    var phi_4277_: type_37;
    var phi_4278_: bool;
    var phi_4279_: u32;
    var phi_4280_: u32;
    var phi_4281_: type_49;
    var phi_4846_: bool;
    var phi_1174_: type_37;
    var phi_1177_: bool;
    var phi_1179_: u32;
    var phi_1181_: u32;
    var phi_1183_: type_49;
    var phi_4282_: bool;
    var phi_4845_: bool;
    var local_10: type_37;
    var phi_4320_: f32;
    var phi_4322_: f32;
    var phi_4323_: bool;
    var phi_4324_: f32;
    var phi_4325_: bool;
    var phi_4546_: u32;
    var phi_4564_: bool;
    var phi_4567_: bool;
    var phi_4580_: f32;
    var phi_4581_: f32;
    var phi_4586_: f32;
    var phi_4587_: f32;
    var phi_4588_: bool;
    var phi_4596_: f32;
    var phi_4340_: f32;
    var phi_4341_: f32;
    var phi_4353_: f32;
    var phi_4358_: type_24;
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
                    phi_4644_ = false;
                    phi_1173_ = type_37(type_24(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e623);
                    phi_1176_ = (_e625 <= _e623);
                    phi_1178_ = ((3u * _e99) + 1u);
                    phi_1180_ = 0u;
                    phi_1182_ = type_49(type_32(vec4<f32>((f32(_e632) * _e150), (f32(_e638) * _e150), (f32(_e644) * _e150), 0f), vec4<f32>((f32(_e649) * _e150), (f32(_e653) * _e150), (f32(_e657) * _e150), 0f)), select(0u, 2147483648u, (_e99 == 0u)));
                    loop {
                        let _e667 = phi_4644_;
                        let _e669 = phi_1173_;
                        let _e671 = phi_1176_;
                        let _e673 = phi_1178_;
                        let _e675 = phi_1180_;
                        let _e677 = phi_1182_;
                        local_10 = _e669;
                        if _e671 {
                            phi_1193_ = true;
                        } else {
                            phi_1193_ = (_e675 > 0u);
                        }
                        let _e680 = phi_1193_;
                        if _e680 {
                            let _e681 = (_e673 > 0u);
                            if _e681 {
                                if _e671 {
                                    phi_1279_ = _e671;
                                    phi_1280_ = _e675;
                                    phi_1281_ = _e677;
                                } else {
                                    let _e682 = (_e675 - 1u);
                                    let _e683 = (_e682 % 128u);
                                    let _e684 = (_e683 < 128u);
                                    if _e684 {
                                    } else {
                                        phi_4845_ = true;
                                        break;
                                    }
                                    let _e686 = local_7[_e683];
                                    if _e684 {
                                    } else {
                                        phi_4845_ = true;
                                        break;
                                    }
                                    let _e688 = local_6[_e683];
                                    if _e684 {
                                    } else {
                                        phi_4845_ = true;
                                        break;
                                    }
                                    let _e690 = local_5[_e683];
                                    if _e684 {
                                    } else {
                                        phi_4845_ = true;
                                        break;
                                    }
                                    let _e692 = local_4[_e683];
                                    if _e684 {
                                    } else {
                                        phi_4845_ = true;
                                        break;
                                    }
                                    let _e694 = local_3[_e683];
                                    if _e684 {
                                    } else {
                                        phi_4845_ = true;
                                        break;
                                    }
                                    let _e696 = local_2[_e683];
                                    if _e684 {
                                    } else {
                                        phi_4845_ = true;
                                        break;
                                    }
                                    let _e701 = local_8[_e683];
                                    if _e684 {
                                    } else {
                                        phi_4845_ = true;
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
                                    let _e717 = (_e712.member_1 & 268435455u);
                                    if ((_e712.member_1 & 2147483648u) != 0u) {
                                        phi_1300_ = _e669;
                                        phi_1303_ = type_8(0u, ((_e712.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e1183 = phi_1300_;
                                            let _e1185 = phi_1303_;
                                            local_11 = _e1183;
                                            if (_e1185.member < _e1185.member_1) {
                                                phi_1304_ = type_8((_e1185.member + 1u), _e1185.member_1);
                                                phi_1326_ = type_8(1u, _e1185.member);
                                            } else {
                                                phi_1304_ = _e1185;
                                                phi_1326_ = type_8(0u, type_8().member_1);
                                            }
                                            let _e1198 = phi_1304_;
                                            let _e1200 = phi_1326_;
                                            let _e1204 = (bitcast<i32>(_e1200.member) != 0i);
                                            if _e1204 {
                                                let _e1209 = (_e712.member.member_1.x - _e712.member.member.x);
                                                let _e1212 = (_e712.member.member_1.y - _e712.member.member.y);
                                                let _e1215 = (_e712.member.member_1.z - _e712.member.member.z);
                                                let _e1217 = select(_e1212, _e1209, (_e1209 > _e1212));
                                                let _e1219 = select(_e1215, _e1217, (_e1217 > _e1215));
                                                let _e1221 = (_e1219 < (1024f * _e150));
                                                if _e1221 {
                                                    phi_1367_ = 0u;
                                                } else {
                                                    phi_1367_ = select(2u, 1u, (_e1219 < (2097152f * _e150)));
                                                }
                                                let _e1226 = phi_1367_;
                                                switch bitcast<i32>(_e1226) {
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
                                                let _e1229 = phi_1373_;
                                                switch bitcast<i32>(_e1226) {
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
                                                let _e1236 = phi_1383_;
                                                let _e1238 = ((_e717 + (_e1200.member_1 * ((3u * _e1229) + 1u))) + (3u * _e1236));
                                                let _e1239 = (_e1238 < _e102);
                                                if _e1239 {
                                                    if _e1239 {
                                                    } else {
                                                        phi_4638_ = true;
                                                        break;
                                                    }
                                                    let _e1241 = global_5.member[_e1238];
                                                    phi_1399_ = _e1241;
                                                } else {
                                                    phi_1399_ = 4294967295u;
                                                }
                                                let _e1243 = phi_1399_;
                                                if _e1221 {
                                                    phi_1432_ = 0u;
                                                } else {
                                                    phi_1432_ = select(2u, 1u, (_e1219 < (2097152f * _e150)));
                                                }
                                                let _e1248 = phi_1432_;
                                                switch bitcast<i32>(_e1248) {
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
                                                let _e1251 = phi_1438_;
                                                let _e1255 = (_e717 + (_e1200.member_1 * ((3u * _e1251) + 1u)));
                                                switch bitcast<i32>(_e1248) {
                                                    case 0: {
                                                        let _e1530 = (_e1255 < _e102);
                                                        if _e1530 {
                                                            if _e1530 {
                                                            } else {
                                                                phi_4638_ = true;
                                                                break;
                                                            }
                                                            let _e1532 = global_5.member[_e1255];
                                                            phi_1465_ = _e1532;
                                                        } else {
                                                            phi_1465_ = 0u;
                                                        }
                                                        let _e1534 = phi_1465_;
                                                        let _e1536 = ((10u * _e270) & 31u);
                                                        let _e1546 = ((10u * _e269) & 31u);
                                                        let _e1556 = ((10u * _e271) & 31u);
                                                        let _e1566 = (_e1255 + 1u);
                                                        let _e1567 = (_e1566 < _e102);
                                                        if _e1567 {
                                                            if _e1567 {
                                                            } else {
                                                                phi_4638_ = true;
                                                                break;
                                                            }
                                                            let _e1569 = global_5.member[_e1566];
                                                            phi_1514_ = _e1569;
                                                        } else {
                                                            phi_1514_ = 0u;
                                                        }
                                                        let _e1571 = phi_1514_;
                                                        let _e1597 = (_e1255 + 2u);
                                                        let _e1598 = (_e1597 < _e102);
                                                        if _e1598 {
                                                            if _e1598 {
                                                            } else {
                                                                phi_4638_ = true;
                                                                break;
                                                            }
                                                            let _e1600 = global_5.member[_e1597];
                                                            phi_1563_ = _e1600;
                                                        } else {
                                                            phi_1563_ = 0u;
                                                        }
                                                        let _e1602 = phi_1563_;
                                                        phi_2064_ = array<array<f32, 3>, 3>(array<f32, 3>((_e712.member.member.x + ((bitcast<f32>((1258291200u | ((_e1534 >> bitcast<u32>(_e1536)) & 1023u))) - 8388608f) * _e150)), (_e712.member.member.y + ((bitcast<f32>((1258291200u | ((_e1534 >> bitcast<u32>(_e1546)) & 1023u))) - 8388608f) * _e150)), (_e712.member.member.z + ((bitcast<f32>((1258291200u | ((_e1534 >> bitcast<u32>(_e1556)) & 1023u))) - 8388608f) * _e150))), array<f32, 3>((_e712.member.member.x + ((bitcast<f32>((1258291200u | ((_e1571 >> bitcast<u32>(_e1536)) & 1023u))) - 8388608f) * _e150)), (_e712.member.member.y + ((bitcast<f32>((1258291200u | ((_e1571 >> bitcast<u32>(_e1546)) & 1023u))) - 8388608f) * _e150)), (_e712.member.member.z + ((bitcast<f32>((1258291200u | ((_e1571 >> bitcast<u32>(_e1556)) & 1023u))) - 8388608f) * _e150))), array<f32, 3>((_e712.member.member.x + ((bitcast<f32>((1258291200u | ((_e1602 >> bitcast<u32>(_e1536)) & 1023u))) - 8388608f) * _e150)), (_e712.member.member.y + ((bitcast<f32>((1258291200u | ((_e1602 >> bitcast<u32>(_e1546)) & 1023u))) - 8388608f) * _e150)), (_e712.member.member.z + ((bitcast<f32>((1258291200u | ((_e1602 >> bitcast<u32>(_e1556)) & 1023u))) - 8388608f) * _e150))));
                                                        break;
                                                    }
                                                    case 1: {
                                                        let _e1344 = (_e1255 < _e102);
                                                        if _e1344 {
                                                            if _e1344 {
                                                            } else {
                                                                phi_4638_ = true;
                                                                break;
                                                            }
                                                            let _e1346 = global_5.member[_e1255];
                                                            phi_1612_ = _e1346;
                                                        } else {
                                                            phi_1612_ = 0u;
                                                        }
                                                        let _e1348 = phi_1612_;
                                                        let _e1349 = (_e1255 + 1u);
                                                        let _e1350 = (_e1349 < _e102);
                                                        if _e1350 {
                                                            if _e1350 {
                                                            } else {
                                                                phi_4638_ = true;
                                                                break;
                                                            }
                                                            let _e1352 = global_5.member[_e1349];
                                                            phi_1627_ = _e1352;
                                                        } else {
                                                            phi_1627_ = 0u;
                                                        }
                                                        let _e1354 = phi_1627_;
                                                        let _e1355 = (_e270 == 1u);
                                                        if _e1355 {
                                                            phi_1637_ = ((_e1348 >> bitcast<u32>(21i)) | (_e1354 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1637_ = (_e1354 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1364 = phi_1637_;
                                                        let _e1372 = (_e269 == 1u);
                                                        if _e1372 {
                                                            phi_1658_ = ((_e1348 >> bitcast<u32>(21i)) | (_e1354 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1658_ = (_e1354 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1381 = phi_1658_;
                                                        let _e1389 = (_e271 == 1u);
                                                        if _e1389 {
                                                            phi_1679_ = ((_e1348 >> bitcast<u32>(21i)) | (_e1354 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1679_ = (_e1354 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1398 = phi_1679_;
                                                        let _e1407 = (_e1255 + 2u);
                                                        let _e1408 = (_e1407 < _e102);
                                                        if _e1408 {
                                                            if _e1408 {
                                                            } else {
                                                                phi_4638_ = true;
                                                                break;
                                                            }
                                                            let _e1410 = global_5.member[_e1407];
                                                            phi_1709_ = _e1410;
                                                        } else {
                                                            phi_1709_ = 0u;
                                                        }
                                                        let _e1412 = phi_1709_;
                                                        let _e1413 = (_e1255 + 3u);
                                                        let _e1414 = (_e1413 < _e102);
                                                        if _e1414 {
                                                            if _e1414 {
                                                            } else {
                                                                phi_4638_ = true;
                                                                break;
                                                            }
                                                            let _e1416 = global_5.member[_e1413];
                                                            phi_1724_ = _e1416;
                                                        } else {
                                                            phi_1724_ = 0u;
                                                        }
                                                        let _e1418 = phi_1724_;
                                                        if _e1355 {
                                                            phi_1734_ = ((_e1412 >> bitcast<u32>(21i)) | (_e1418 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1734_ = (_e1418 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1427 = phi_1734_;
                                                        if _e1372 {
                                                            phi_1755_ = ((_e1412 >> bitcast<u32>(21i)) | (_e1418 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1755_ = (_e1418 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1443 = phi_1755_;
                                                        if _e1389 {
                                                            phi_1776_ = ((_e1412 >> bitcast<u32>(21i)) | (_e1418 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1776_ = (_e1418 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1459 = phi_1776_;
                                                        let _e1468 = (_e1255 + 4u);
                                                        let _e1469 = (_e1468 < _e102);
                                                        if _e1469 {
                                                            if _e1469 {
                                                            } else {
                                                                phi_4638_ = true;
                                                                break;
                                                            }
                                                            let _e1471 = global_5.member[_e1468];
                                                            phi_1806_ = _e1471;
                                                        } else {
                                                            phi_1806_ = 0u;
                                                        }
                                                        let _e1473 = phi_1806_;
                                                        let _e1474 = (_e1255 + 5u);
                                                        let _e1475 = (_e1474 < _e102);
                                                        if _e1475 {
                                                            if _e1475 {
                                                            } else {
                                                                phi_4638_ = true;
                                                                break;
                                                            }
                                                            let _e1477 = global_5.member[_e1474];
                                                            phi_1821_ = _e1477;
                                                        } else {
                                                            phi_1821_ = 0u;
                                                        }
                                                        let _e1479 = phi_1821_;
                                                        if _e1355 {
                                                            phi_1831_ = ((_e1473 >> bitcast<u32>(21i)) | (_e1479 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1831_ = (_e1479 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1488 = phi_1831_;
                                                        if _e1372 {
                                                            phi_1852_ = ((_e1473 >> bitcast<u32>(21i)) | (_e1479 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1852_ = (_e1479 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1504 = phi_1852_;
                                                        if _e1389 {
                                                            phi_1873_ = ((_e1473 >> bitcast<u32>(21i)) | (_e1479 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1873_ = (_e1479 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1520 = phi_1873_;
                                                        phi_2064_ = array<array<f32, 3>, 3>(array<f32, 3>((_e712.member.member.x + ((bitcast<f32>((1258291200u | (select(_e1364, _e1348, _e309) & 2097151u))) - 8388608f) * _e150)), (_e712.member.member.y + ((bitcast<f32>((1258291200u | (select(_e1381, _e1348, _e378) & 2097151u))) - 8388608f) * _e150)), (_e712.member.member.z + ((bitcast<f32>((1258291200u | (select(_e1398, _e1348, _e446) & 2097151u))) - 8388608f) * _e150))), array<f32, 3>((_e712.member.member.x + ((bitcast<f32>((1258291200u | (select(_e1427, _e1412, _e309) & 2097151u))) - 8388608f) * _e150)), (_e712.member.member.y + ((bitcast<f32>((1258291200u | (select(_e1443, _e1412, _e378) & 2097151u))) - 8388608f) * _e150)), (_e712.member.member.z + ((bitcast<f32>((1258291200u | (select(_e1459, _e1412, _e446) & 2097151u))) - 8388608f) * _e150))), array<f32, 3>((_e712.member.member.x + ((bitcast<f32>((1258291200u | (select(_e1488, _e1473, _e309) & 2097151u))) - 8388608f) * _e150)), (_e712.member.member.y + ((bitcast<f32>((1258291200u | (select(_e1504, _e1473, _e378) & 2097151u))) - 8388608f) * _e150)), (_e712.member.member.z + ((bitcast<f32>((1258291200u | (select(_e1520, _e1473, _e446) & 2097151u))) - 8388608f) * _e150))));
                                                        break;
                                                    }
                                                    case 2: {
                                                        let _e1257 = (_e1255 + _e270);
                                                        let _e1258 = (_e1257 < _e102);
                                                        if _e1258 {
                                                            if _e1258 {
                                                            } else {
                                                                phi_4638_ = true;
                                                                break;
                                                            }
                                                            let _e1260 = global_5.member[_e1257];
                                                            phi_1904_ = _e1260;
                                                        } else {
                                                            phi_1904_ = 0u;
                                                        }
                                                        let _e1262 = phi_1904_;
                                                        let _e1266 = (_e1255 + _e269);
                                                        let _e1267 = (_e1266 < _e102);
                                                        if _e1267 {
                                                            if _e1267 {
                                                            } else {
                                                                phi_4638_ = true;
                                                                break;
                                                            }
                                                            let _e1269 = global_5.member[_e1266];
                                                            phi_1922_ = _e1269;
                                                        } else {
                                                            phi_1922_ = 0u;
                                                        }
                                                        let _e1271 = phi_1922_;
                                                        let _e1275 = (_e1255 + _e271);
                                                        let _e1276 = (_e1275 < _e102);
                                                        if _e1276 {
                                                            if _e1276 {
                                                            } else {
                                                                phi_4638_ = true;
                                                                break;
                                                            }
                                                            let _e1278 = global_5.member[_e1275];
                                                            phi_1940_ = _e1278;
                                                        } else {
                                                            phi_1940_ = 0u;
                                                        }
                                                        let _e1280 = phi_1940_;
                                                        let _e1285 = (_e1255 + 3u);
                                                        let _e1286 = (_e1285 + _e270);
                                                        let _e1287 = (_e1286 < _e102);
                                                        if _e1287 {
                                                            if _e1287 {
                                                            } else {
                                                                phi_4638_ = true;
                                                                break;
                                                            }
                                                            let _e1289 = global_5.member[_e1286];
                                                            phi_1963_ = _e1289;
                                                        } else {
                                                            phi_1963_ = 0u;
                                                        }
                                                        let _e1291 = phi_1963_;
                                                        let _e1295 = (_e1285 + _e269);
                                                        let _e1296 = (_e1295 < _e102);
                                                        if _e1296 {
                                                            if _e1296 {
                                                            } else {
                                                                phi_4638_ = true;
                                                                break;
                                                            }
                                                            let _e1298 = global_5.member[_e1295];
                                                            phi_1981_ = _e1298;
                                                        } else {
                                                            phi_1981_ = 0u;
                                                        }
                                                        let _e1300 = phi_1981_;
                                                        let _e1304 = (_e1285 + _e271);
                                                        let _e1305 = (_e1304 < _e102);
                                                        if _e1305 {
                                                            if _e1305 {
                                                            } else {
                                                                phi_4638_ = true;
                                                                break;
                                                            }
                                                            let _e1307 = global_5.member[_e1304];
                                                            phi_1999_ = _e1307;
                                                        } else {
                                                            phi_1999_ = 0u;
                                                        }
                                                        let _e1309 = phi_1999_;
                                                        let _e1314 = (_e1255 + 6u);
                                                        let _e1315 = (_e1314 + _e270);
                                                        let _e1316 = (_e1315 < _e102);
                                                        if _e1316 {
                                                            if _e1316 {
                                                            } else {
                                                                phi_4638_ = true;
                                                                break;
                                                            }
                                                            let _e1318 = global_5.member[_e1315];
                                                            phi_2022_ = _e1318;
                                                        } else {
                                                            phi_2022_ = 0u;
                                                        }
                                                        let _e1320 = phi_2022_;
                                                        let _e1324 = (_e1314 + _e269);
                                                        let _e1325 = (_e1324 < _e102);
                                                        if _e1325 {
                                                            if _e1325 {
                                                            } else {
                                                                phi_4638_ = true;
                                                                break;
                                                            }
                                                            let _e1327 = global_5.member[_e1324];
                                                            phi_2040_ = _e1327;
                                                        } else {
                                                            phi_2040_ = 0u;
                                                        }
                                                        let _e1329 = phi_2040_;
                                                        let _e1333 = (_e1314 + _e271);
                                                        let _e1334 = (_e1333 < _e102);
                                                        if _e1334 {
                                                            if _e1334 {
                                                            } else {
                                                                phi_4638_ = true;
                                                                break;
                                                            }
                                                            let _e1336 = global_5.member[_e1333];
                                                            phi_2058_ = _e1336;
                                                        } else {
                                                            phi_2058_ = 0u;
                                                        }
                                                        let _e1338 = phi_2058_;
                                                        phi_2064_ = array<array<f32, 3>, 3>(array<f32, 3>((f32(bitcast<i32>(_e1262)) * _e150), (f32(bitcast<i32>(_e1271)) * _e150), (f32(bitcast<i32>(_e1280)) * _e150)), array<f32, 3>((f32(bitcast<i32>(_e1291)) * _e150), (f32(bitcast<i32>(_e1300)) * _e150), (f32(bitcast<i32>(_e1309)) * _e150)), array<f32, 3>((f32(bitcast<i32>(_e1320)) * _e150), (f32(bitcast<i32>(_e1329)) * _e150), (f32(bitcast<i32>(_e1338)) * _e150)));
                                                        break;
                                                    }
                                                    default: {
                                                        phi_2064_ = array<array<f32, 3>, 3>();
                                                        break;
                                                    }
                                                }
                                                let _e1630 = phi_2064_;
                                                let _e1638 = (_e1630[0][2] - _e471);
                                                let _e1641 = (((_e1630[0][0] - _e334) * _e510) - (_e1638 * _e374));
                                                let _e1644 = (((_e1630[0][1] - _e403) * _e510) - (_e1638 * _e442));
                                                let _e1651 = (_e1630[1][2] - _e471);
                                                let _e1654 = (((_e1630[1][0] - _e334) * _e510) - (_e1651 * _e374));
                                                let _e1657 = (((_e1630[1][1] - _e403) * _e510) - (_e1651 * _e442));
                                                let _e1664 = (_e1630[2][2] - _e471);
                                                let _e1667 = (((_e1630[2][0] - _e334) * _e510) - (_e1664 * _e374));
                                                let _e1670 = (((_e1630[2][1] - _e403) * _e510) - (_e1664 * _e442));
                                                let _e1671 = (_e1667 * _e1657);
                                                let _e1672 = (_e1670 * _e1654);
                                                let _e1673 = (_e1641 * _e1670);
                                                let _e1674 = (_e1644 * _e1667);
                                                let _e1675 = (_e1654 * _e1644);
                                                let _e1676 = (_e1657 * _e1641);
                                                let _e1681 = (((_e1671 >= _e1672) && (_e1673 >= _e1674)) && (_e1675 >= _e1676));
                                                if (_e1681 || (((_e1671 <= _e1672) && (_e1673 <= _e1674)) && (_e1675 <= _e1676))) {
                                                    let _e1688 = select(-1f, 1f, _e1681);
                                                    let _e1690 = ((_e1671 - _e1672) * _e1688);
                                                    let _e1692 = select(0f, _e1690, (_e1690 > 0f));
                                                    let _e1694 = ((_e1673 - _e1674) * _e1688);
                                                    let _e1696 = select(0f, _e1694, (_e1694 > 0f));
                                                    let _e1698 = ((_e1675 - _e1676) * _e1688);
                                                    let _e1700 = select(0f, _e1698, (_e1698 > 0f));
                                                    let _e1702 = ((_e1692 + _e1696) + _e1700);
                                                    if (_e1702 < 0.000000000000000000000000000000000000011754944f) {
                                                        phi_2948_ = type_24();
                                                        phi_2949_ = true;
                                                        phi_2950_ = false;
                                                    } else {
                                                        let _e1705 = select(_e1654, _e1641, (_e1641 < _e1654));
                                                        if (select(_e1667, _e1705, (_e1705 < _e1667)) > 0f) {
                                                            phi_2216_ = true;
                                                        } else {
                                                            let _e1710 = select(_e1654, _e1641, (_e1641 > _e1654));
                                                            phi_2216_ = (select(_e1667, _e1710, (_e1710 > _e1667)) < 0f);
                                                        }
                                                        let _e1715 = phi_2216_;
                                                        if _e1715 {
                                                            phi_2945_ = type_24();
                                                            phi_2946_ = true;
                                                            phi_2947_ = false;
                                                        } else {
                                                            let _e1717 = select(_e1657, _e1644, (_e1644 < _e1657));
                                                            if (select(_e1670, _e1717, (_e1717 < _e1670)) > 0f) {
                                                                phi_2245_ = true;
                                                            } else {
                                                                let _e1722 = select(_e1657, _e1644, (_e1644 > _e1657));
                                                                phi_2245_ = (select(_e1670, _e1722, (_e1722 > _e1670)) < 0f);
                                                            }
                                                            let _e1727 = phi_2245_;
                                                            if _e1727 {
                                                                phi_2943_ = type_24();
                                                                phi_2944_ = false;
                                                            } else {
                                                                let _e1729 = select(_e1630[1][0], _e1630[0][0], (_e1630[0][0] < _e1630[1][0]));
                                                                let _e1733 = select(_e1630[1][0], _e1630[0][0], (_e1630[0][0] > _e1630[1][0]));
                                                                let _e1737 = select(_e1630[1][1], _e1630[0][1], (_e1630[0][1] < _e1630[1][1]));
                                                                let _e1741 = select(_e1630[1][1], _e1630[0][1], (_e1630[0][1] > _e1630[1][1]));
                                                                let _e1745 = select(_e1630[1][2], _e1630[0][2], (_e1630[0][2] < _e1630[1][2]));
                                                                let _e1749 = select(_e1630[1][2], _e1630[0][2], (_e1630[0][2] > _e1630[1][2]));
                                                                let _e1754 = ((select(_e1630[2][0], _e1729, (_e1729 < _e1630[2][0])) - _e372) * _e377);
                                                                let _e1755 = ((select(_e1630[2][0], _e1733, (_e1733 > _e1630[2][0])) - _e373) * _e377);
                                                                let _e1758 = ((select(_e1630[2][1], _e1737, (_e1737 < _e1630[2][1])) - _e440) * _e445);
                                                                let _e1759 = ((select(_e1630[2][1], _e1741, (_e1741 > _e1630[2][1])) - _e441) * _e445);
                                                                let _e1762 = ((select(_e1630[2][2], _e1745, (_e1745 < _e1630[2][2])) - _e508) * _e513);
                                                                let _e1763 = ((select(_e1630[2][2], _e1749, (_e1749 > _e1630[2][2])) - _e509) * _e513);
                                                                let _e1765 = select(_e1763, _e1762, (_e1762 < _e1763));
                                                                let _e1767 = select(_e1763, _e1762, (_e1762 > _e1763));
                                                                let _e1769 = select(_e1755, _e1754, (_e1754 < _e1755));
                                                                let _e1771 = select(_e1759, _e1758, (_e1758 < _e1759));
                                                                let _e1773 = select(_e1771, _e1769, (_e1769 > _e1771));
                                                                let _e1775 = select(_e1765, _e1773, (_e1773 > _e1765));
                                                                let _e1777 = select(_e1755, _e1754, (_e1754 > _e1755));
                                                                let _e1779 = select(_e1759, _e1758, (_e1758 > _e1759));
                                                                let _e1781 = select(_e1779, _e1777, (_e1777 < _e1779));
                                                                let _e1783 = select(_e1767, _e1781, (_e1781 < _e1767));
                                                                let _e1784 = -(_e1765);
                                                                let _e1790 = select(_e625, _e1775, (_e1775 > _e625));
                                                                if (_e1790 > (_e1783 + (select(_e1784, _e1767, (_e1767 > _e1784)) * 0.0000019073523f))) {
                                                                    phi_2938_ = type_24();
                                                                    phi_2939_ = true;
                                                                } else {
                                                                    let _e1792 = (_e1790 > _e1183.member_1);
                                                                    if _e1792 {
                                                                        phi_2937_ = type_24();
                                                                    } else {
                                                                        let _e1793 = vec3<f32>(_e1630[0][0], _e1630[0][1], _e1630[0][2]);
                                                                        let _e1794 = vec3<f32>(_e1630[1][0], _e1630[1][1], _e1630[1][2]);
                                                                        let _e1795 = vec3<f32>(_e1630[2][0], _e1630[2][1], _e1630[2][2]);
                                                                        let _e1796 = (_e1630[1][0] - _e1630[0][0]);
                                                                        let _e1797 = (_e1630[1][1] - _e1630[0][1]);
                                                                        let _e1798 = (_e1630[1][2] - _e1630[0][2]);
                                                                        let _e1799 = vec3<f32>(_e1796, _e1797, _e1798);
                                                                        let _e1800 = (_e1630[2][0] - _e1630[1][0]);
                                                                        let _e1801 = (_e1630[2][1] - _e1630[1][1]);
                                                                        let _e1802 = (_e1630[2][2] - _e1630[1][2]);
                                                                        let _e1803 = vec3<f32>(_e1800, _e1801, _e1802);
                                                                        let _e1804 = (_e1630[0][0] - _e1630[2][0]);
                                                                        let _e1805 = (_e1630[0][1] - _e1630[2][1]);
                                                                        let _e1806 = (_e1630[0][2] - _e1630[2][2]);
                                                                        let _e1807 = vec3<f32>(_e1804, _e1805, _e1806);
                                                                        let _e1810 = bitcast<f32>((bitcast<u32>(_e1796) & 2147483647u));
                                                                        let _e1813 = bitcast<f32>((bitcast<u32>(_e1797) & 2147483647u));
                                                                        let _e1815 = select(_e1813, _e1810, (_e1810 > _e1813));
                                                                        let _e1818 = bitcast<f32>((bitcast<u32>(_e1798) & 2147483647u));
                                                                        let _e1820 = select(_e1818, _e1815, (_e1815 > _e1818));
                                                                        let _e1823 = bitcast<f32>((bitcast<u32>(_e1800) & 2147483647u));
                                                                        let _e1826 = bitcast<f32>((bitcast<u32>(_e1801) & 2147483647u));
                                                                        let _e1828 = select(_e1826, _e1823, (_e1823 > _e1826));
                                                                        let _e1831 = bitcast<f32>((bitcast<u32>(_e1802) & 2147483647u));
                                                                        let _e1833 = select(_e1831, _e1828, (_e1828 > _e1831));
                                                                        let _e1836 = bitcast<f32>((bitcast<u32>(_e1804) & 2147483647u));
                                                                        let _e1839 = bitcast<f32>((bitcast<u32>(_e1805) & 2147483647u));
                                                                        let _e1841 = select(_e1839, _e1836, (_e1836 > _e1839));
                                                                        let _e1844 = bitcast<f32>((bitcast<u32>(_e1806) & 2147483647u));
                                                                        let _e1846 = select(_e1844, _e1841, (_e1841 > _e1844));
                                                                        let _e1848 = select(_e1833, _e1820, (_e1820 > _e1833));
                                                                        let _e1850 = select(_e1846, _e1848, (_e1848 > _e1846));
                                                                        if (_e1820 == _e1850) {
                                                                            phi_2664_ = _e1657;
                                                                            phi_2665_ = _e1654;
                                                                            phi_2666_ = _e1644;
                                                                            phi_2667_ = _e1641;
                                                                            phi_2668_ = _e1793;
                                                                            phi_2669_ = _e1807;
                                                                            phi_2670_ = _e1803;
                                                                            phi_2671_ = _e1799;
                                                                        } else {
                                                                            let _e1852 = (_e1833 == _e1850);
                                                                            let _e1857 = vec3(_e1852);
                                                                            phi_2664_ = select(_e1644, _e1670, _e1852);
                                                                            phi_2665_ = select(_e1641, _e1667, _e1852);
                                                                            phi_2666_ = select(_e1670, _e1657, _e1852);
                                                                            phi_2667_ = select(_e1667, _e1654, _e1852);
                                                                            phi_2668_ = select(_e1795, _e1794, _e1857);
                                                                            phi_2669_ = select(_e1803, _e1799, _e1857);
                                                                            phi_2670_ = select(_e1799, _e1807, _e1857);
                                                                            phi_2671_ = select(_e1807, _e1803, _e1857);
                                                                        }
                                                                        let _e1863 = phi_2664_;
                                                                        let _e1865 = phi_2665_;
                                                                        let _e1867 = phi_2666_;
                                                                        let _e1869 = phi_2667_;
                                                                        let _e1871 = phi_2668_;
                                                                        let _e1873 = phi_2669_;
                                                                        let _e1875 = phi_2670_;
                                                                        let _e1877 = phi_2671_;
                                                                        let _e1884 = ((_e1875.y * _e1873.z) - (_e1873.y * _e1875.z));
                                                                        let _e1889 = ((_e1875.z * _e1873.x) - (_e1873.z * _e1875.x));
                                                                        let _e1892 = ((_e1875.x * _e1873.y) - (_e1873.x * _e1875.y));
                                                                        if (_e1692 >= _e1696) {
                                                                            phi_2708_ = select(true, false, (_e1692 >= _e1700));
                                                                        } else {
                                                                            phi_2708_ = true;
                                                                        }
                                                                        let _e1897 = phi_2708_;
                                                                        if _e1897 {
                                                                            phi_2717_ = select(_e1795, _e1794, vec3((_e1696 >= _e1700)));
                                                                        } else {
                                                                            phi_2717_ = _e1793;
                                                                        }
                                                                        let _e1902 = phi_2717_;
                                                                        let _e1913 = (((_e1884 * (_e1902.x - _e334)) + (_e1889 * (_e1902.y - _e403))) + (_e1892 * (_e1902.z - _e471)));
                                                                        let _e1918 = (((_e1884 * _e374) + (_e1889 * _e442)) + (_e1892 * _e510));
                                                                        let _e1919 = (_e1865 - _e1869);
                                                                        let _e1920 = (_e1863 - _e1867);
                                                                        let _e1928 = (-(((_e1869 * _e1919) + (_e1867 * _e1920))) / ((_e1919 * _e1919) + (_e1920 * _e1920)));
                                                                        let _e1930 = select(1f, _e1928, (_e1928 < 1f));
                                                                        let _e1932 = select(0f, _e1930, (_e1930 > 0f));
                                                                        let _e1945 = ((_e1871.x + (_e1877.x * _e1932)) - _e334);
                                                                        let _e1946 = ((_e1871.y + (_e1877.y * _e1932)) - _e403);
                                                                        let _e1947 = ((_e1871.z + (_e1877.z * _e1932)) - _e471);
                                                                        let _e1948 = (_e1947 / _e510);
                                                                        let _e1960 = bitcast<f32>((bitcast<u32>(_e1945) & 2147483647u));
                                                                        let _e1963 = bitcast<f32>((bitcast<u32>(_e1946) & 2147483647u));
                                                                        let _e1965 = select(_e1963, _e1960, (_e1960 > _e1963));
                                                                        let _e1968 = bitcast<f32>((bitcast<u32>(_e1947) & 2147483647u));
                                                                        let _e1970 = select(_e1968, _e1965, (_e1965 > _e1968));
                                                                        let _e1976 = bitcast<f32>((bitcast<u32>(_e1884) & 2147483647u));
                                                                        let _e1979 = bitcast<f32>((bitcast<u32>(_e1889) & 2147483647u));
                                                                        let _e1981 = select(_e1979, _e1976, (_e1976 > _e1979));
                                                                        let _e1984 = bitcast<f32>((bitcast<u32>(_e1892) & 2147483647u));
                                                                        if (bitcast<f32>((bitcast<u32>(((((_e1884 * _e1945) + (_e1889 * _e1946)) + (_e1892 * _e1947)) - _e1913)) & 2147483647u)) <= ((0.0000009536743f * select(_e1850, _e1970, (_e1970 > _e1850))) * select(_e1984, _e1981, (_e1981 > _e1984)))) {
                                                                            let _e1994 = bitcast<f32>((bitcast<u32>(_e1875.x) & 2147483647u));
                                                                            let _e1997 = bitcast<f32>((bitcast<u32>(_e1875.y) & 2147483647u));
                                                                            let _e1999 = select(_e1997, _e1994, (_e1994 > _e1997));
                                                                            let _e2002 = bitcast<f32>((bitcast<u32>(_e1875.z) & 2147483647u));
                                                                            let _e2008 = bitcast<f32>((bitcast<u32>(_e1873.x) & 2147483647u));
                                                                            let _e2011 = bitcast<f32>((bitcast<u32>(_e1873.y) & 2147483647u));
                                                                            let _e2013 = select(_e2011, _e2008, (_e2008 > _e2011));
                                                                            let _e2016 = bitcast<f32>((bitcast<u32>(_e1873.z) & 2147483647u));
                                                                            let _e2020 = (bitcast<f32>((bitcast<u32>(_e1918) & 2147483647u)) > ((0.0000038146973f * select(_e2002, _e1999, (_e1999 > _e2002))) * select(_e2016, _e2013, (_e2013 > _e2016))));
                                                                            if _e2020 {
                                                                                phi_2882_ = (_e1913 / _e1918);
                                                                            } else {
                                                                                phi_2882_ = f32();
                                                                            }
                                                                            let _e2023 = phi_2882_;
                                                                            phi_2884_ = _e2023;
                                                                            phi_2885_ = select(true, false, _e2020);
                                                                        } else {
                                                                            phi_2884_ = f32();
                                                                            phi_2885_ = true;
                                                                        }
                                                                        let _e2026 = phi_2884_;
                                                                        let _e2028 = phi_2885_;
                                                                        if _e2028 {
                                                                            let _e2036 = (((_e1884 * (_e1945 - (_e374 * _e1948))) + (_e1889 * (_e1946 - (_e442 * _e1948)))) / _e1918);
                                                                            if (bitcast<f32>((bitcast<u32>(_e2036) & 2147483647u)) <= _e1850) {
                                                                                phi_2905_ = (_e1948 + _e2036);
                                                                            } else {
                                                                                phi_2905_ = _e1948;
                                                                            }
                                                                            let _e2043 = phi_2905_;
                                                                            phi_2906_ = _e2043;
                                                                        } else {
                                                                            phi_2906_ = _e2026;
                                                                        }
                                                                        let _e2045 = phi_2906_;
                                                                        let _e2047 = select(_e1783, _e2045, (_e2045 < _e1783));
                                                                        let _e2049 = select(_e1775, _e2047, (_e2047 > _e1775));
                                                                        if (_e2049 >= _e625) {
                                                                            let _e2051 = (_e2049 <= _e1183.member_1);
                                                                            if _e2051 {
                                                                                let _e2052 = (1f / _e1702);
                                                                                phi_2929_ = type_24(_e2049, (_e1696 * _e2052), (_e1700 * _e2052), _e1243);
                                                                            } else {
                                                                                phi_2929_ = type_24();
                                                                            }
                                                                            let _e2057 = phi_2929_;
                                                                            phi_2931_ = _e2057;
                                                                            phi_2932_ = select(true, false, _e2051);
                                                                        } else {
                                                                            phi_2931_ = type_24();
                                                                            phi_2932_ = true;
                                                                        }
                                                                        let _e2060 = phi_2931_;
                                                                        let _e2062 = phi_2932_;
                                                                        if _e2062 {
                                                                            phi_2936_ = type_24(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                        } else {
                                                                            phi_2936_ = _e2060;
                                                                        }
                                                                        let _e2064 = phi_2936_;
                                                                        phi_2937_ = _e2064;
                                                                    }
                                                                    let _e2066 = phi_2937_;
                                                                    phi_2938_ = _e2066;
                                                                    phi_2939_ = _e1792;
                                                                }
                                                                let _e2068 = phi_2938_;
                                                                let _e2070 = phi_2939_;
                                                                phi_2943_ = _e2068;
                                                                phi_2944_ = _e2070;
                                                            }
                                                            let _e2072 = phi_2943_;
                                                            let _e2074 = phi_2944_;
                                                            phi_2945_ = _e2072;
                                                            phi_2946_ = _e1727;
                                                            phi_2947_ = _e2074;
                                                        }
                                                        let _e2076 = phi_2945_;
                                                        let _e2078 = phi_2946_;
                                                        let _e2080 = phi_2947_;
                                                        phi_2948_ = _e2076;
                                                        phi_2949_ = _e2078;
                                                        phi_2950_ = _e2080;
                                                    }
                                                    let _e2082 = phi_2948_;
                                                    let _e2084 = phi_2949_;
                                                    let _e2086 = phi_2950_;
                                                    phi_2958_ = _e2082;
                                                    phi_2959_ = select(_e2086, true, _e2084);
                                                } else {
                                                    phi_2958_ = type_24();
                                                    phi_2959_ = true;
                                                }
                                                let _e2089 = phi_2958_;
                                                let _e2091 = phi_2959_;
                                                if _e2091 {
                                                    phi_2963_ = type_24(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                } else {
                                                    phi_2963_ = _e2089;
                                                }
                                                let _e2093 = phi_2963_;
                                                if (_e2093.member_3 != 4294967295u) {
                                                    if (_e1243 != 4294967295u) {
                                                        if (_e2093.member < _e1183.member.member) {
                                                            phi_2989_ = true;
                                                        } else {
                                                            if (_e2093.member == _e1183.member.member) {
                                                                phi_2988_ = (_e2093.member_3 < _e1183.member.member_3);
                                                            } else {
                                                                phi_2988_ = false;
                                                            }
                                                            let _e2106 = phi_2988_;
                                                            phi_2989_ = _e2106;
                                                        }
                                                        let _e2108 = phi_2989_;
                                                        if _e2108 {
                                                            phi_2995_ = type_37(_e2093, _e2093.member);
                                                        } else {
                                                            phi_2995_ = _e1183;
                                                        }
                                                        let _e2111 = phi_2995_;
                                                        phi_2996_ = _e2111;
                                                    } else {
                                                        phi_2996_ = _e1183;
                                                    }
                                                    let _e2113 = phi_2996_;
                                                    phi_2997_ = _e2113;
                                                } else {
                                                    phi_2997_ = _e1183;
                                                }
                                                let _e2115 = phi_2997_;
                                                phi_1301_ = _e2115;
                                            } else {
                                                phi_1301_ = type_37();
                                            }
                                            let _e2117 = phi_1301_;
                                            continue;
                                            continuing {
                                                phi_1300_ = _e2117;
                                                phi_1303_ = _e1198;
                                                phi_4638_ = _e667;
                                                break if !(_e1204);
                                            }
                                        }
                                        let _e2120 = phi_4638_;
                                        phi_4845_ = _e2120;
                                        if _e2120 {
                                            break;
                                        }
                                        phi_4849_ = _e2120;
                                        let _e2447 = local_11;
                                        phi_4268_ = _e2447;
                                        phi_4269_ = false;
                                        phi_4270_ = _e710;
                                        phi_4271_ = _e712;
                                    } else {
                                        if (_e712.member_1 >= _e99) {
                                            phi_3803_ = type_50(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), type_49(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u), type_49(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u));
                                        } else {
                                            if (_e712.member_1 < _e99) {
                                            } else {
                                                phi_4845_ = true;
                                                break;
                                            }
                                            let _e725 = ((1u + _e270) % 4u);
                                            if (_e725 < 4u) {
                                            } else {
                                                phi_4845_ = true;
                                                break;
                                            }
                                            let _e730 = global_3.member[_e712.member_1][_e725];
                                            let _e732 = (_e730 >> bitcast<u32>(11u));
                                            let _e734 = ((1u + _e269) % 4u);
                                            if (_e734 < 4u) {
                                            } else {
                                                phi_4845_ = true;
                                                break;
                                            }
                                            let _e739 = global_3.member[_e712.member_1][_e734];
                                            let _e741 = (_e739 >> bitcast<u32>(11u));
                                            let _e743 = ((1u + _e271) % 4u);
                                            if (_e743 < 4u) {
                                            } else {
                                                phi_4845_ = true;
                                                break;
                                            }
                                            let _e748 = global_3.member[_e712.member_1][_e743];
                                            let _e750 = (_e748 >> bitcast<u32>(11u));
                                            let _e773 = (bitcast<f32>((bitcast<u32>((_e712.member.member_1.x - _e712.member.member.x)) & 2139095040u)) * 0.001953125f);
                                            let _e774 = (bitcast<f32>((bitcast<u32>((_e712.member.member_1.y - _e712.member.member.y)) & 2139095040u)) * 0.001953125f);
                                            let _e775 = (bitcast<f32>((bitcast<u32>((_e712.member.member_1.z - _e712.member.member.z)) & 2139095040u)) * 0.001953125f);
                                            let _e777 = select(_e150, _e773, (_e773 > _e150));
                                            let _e779 = select(_e150, _e774, (_e774 > _e150));
                                            let _e781 = select(_e150, _e775, (_e775 > _e150));
                                            let _e812 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e730 & 1023u))) - 8388608f) * _e777));
                                            let _e817 = (bitcast<i32>((_e730 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e820 = bitcast<f32>((_e812 & bitcast<u32>(_e817)));
                                            let _e821 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e739 & 1023u))) - 8388608f) * _e779));
                                            let _e826 = (bitcast<i32>((_e739 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e829 = bitcast<f32>((_e821 & bitcast<u32>(_e826)));
                                            let _e830 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e748 & 1023u))) - 8388608f) * _e781));
                                            let _e835 = (bitcast<i32>((_e748 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e838 = bitcast<f32>((_e830 & bitcast<u32>(_e835)));
                                            let _e842 = bitcast<f32>((_e812 & bitcast<u32>(~(_e817))));
                                            let _e846 = bitcast<f32>((_e821 & bitcast<u32>(~(_e826))));
                                            let _e850 = bitcast<f32>((_e830 & bitcast<u32>(~(_e835))));
                                            let _e851 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e732 & 1023u))) - 8388608f) * _e777));
                                            let _e856 = (bitcast<i32>((_e732 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e859 = bitcast<f32>((_e851 & bitcast<u32>(_e856)));
                                            let _e860 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e741 & 1023u))) - 8388608f) * _e779));
                                            let _e865 = (bitcast<i32>((_e741 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e868 = bitcast<f32>((_e860 & bitcast<u32>(_e865)));
                                            let _e869 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e750 & 1023u))) - 8388608f) * _e781));
                                            let _e874 = (bitcast<i32>((_e750 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e877 = bitcast<f32>((_e869 & bitcast<u32>(_e874)));
                                            let _e881 = bitcast<f32>((_e851 & bitcast<u32>(~(_e856))));
                                            let _e885 = bitcast<f32>((_e860 & bitcast<u32>(~(_e865))));
                                            let _e889 = bitcast<f32>((_e869 & bitcast<u32>(~(_e874))));
                                            let _e890 = (_e712.member.member.x + _e820);
                                            let _e891 = (_e712.member.member.y + _e829);
                                            let _e892 = (_e712.member.member.z + _e838);
                                            let _e895 = (_e712.member.member_1.x - _e859);
                                            let _e896 = (_e712.member.member_1.y - _e868);
                                            let _e897 = (_e712.member.member_1.z - _e877);
                                            let _e916 = (_e895 - _e890);
                                            let _e917 = (_e896 - _e891);
                                            let _e918 = (_e897 - _e892);
                                            let _e920 = select(_e917, _e916, (_e916 > _e917));
                                            let _e922 = select(_e918, _e920, (_e920 > _e918));
                                            if (_e922 < (1024f * _e150)) {
                                                phi_3504_ = 0u;
                                            } else {
                                                phi_3504_ = select(2u, 1u, (_e922 < (2097152f * _e150)));
                                            }
                                            let _e929 = phi_3504_;
                                            switch bitcast<i32>(_e929) {
                                                case 0: {
                                                    phi_3510_ = 1u;
                                                    break;
                                                }
                                                case 1: {
                                                    phi_3510_ = 2u;
                                                    break;
                                                }
                                                case 2: {
                                                    phi_3510_ = 3u;
                                                    break;
                                                }
                                                default: {
                                                    phi_3510_ = u32();
                                                    break;
                                                }
                                            }
                                            let _e932 = phi_3510_;
                                            let _e938 = global_3.member[_e712.member_1][0u];
                                            let _e942 = global_3.member[_e712.member_1][1u];
                                            let _e946 = global_3.member[_e712.member_1][2u];
                                            let _e950 = global_3.member[_e712.member_1][3u];
                                            let _e962 = (((_e942 >> bitcast<u32>(22i)) | ((_e946 >> bitcast<u32>(22i)) << bitcast<u32>(10i))) | ((_e950 >> bitcast<u32>(22i)) << bitcast<u32>(20i)));
                                            let _e963 = (_e938 & 268435455u);
                                            let _e964 = (_e962 & 268435455u);
                                            let _e967 = ((_e938 >> bitcast<u32>(28u)) & 7u);
                                            let _e975 = ((_e938 >> bitcast<u32>(31i)) | (((_e962 >> bitcast<u32>(28u)) & 3u) << bitcast<u32>(1i)));
                                            let _e976 = (_e967 != 0u);
                                            if (_e967 == 0u) {
                                                phi_3765_ = _e963;
                                            } else {
                                                if (_e967 == 7u) {
                                                    phi_3764_ = 2147483648u;
                                                } else {
                                                    phi_3764_ = ((2147483648u | (_e967 << bitcast<u32>(28u))) | (_e964 & 268435455u));
                                                }
                                                let _e985 = phi_3764_;
                                                phi_3765_ = _e985;
                                            }
                                            let _e987 = phi_3765_;
                                            if _e976 {
                                                let _e988 = (_e967 != 7u);
                                                if _e988 {
                                                    phi_3775_ = (_e964 + (_e967 * ((3u * _e932) + 1u)));
                                                } else {
                                                    phi_3775_ = u32();
                                                }
                                                let _e992 = phi_3775_;
                                                phi_3777_ = _e992;
                                                phi_3778_ = select(true, false, _e988);
                                            } else {
                                                phi_3777_ = u32();
                                                phi_3778_ = true;
                                            }
                                            let _e995 = phi_3777_;
                                            let _e997 = phi_3778_;
                                            if (_e975 == 0u) {
                                                phi_3799_ = (_e963 + select(0u, 1u, !(_e976)));
                                            } else {
                                                if (_e975 == 7u) {
                                                    phi_3798_ = 2147483648u;
                                                } else {
                                                    phi_3798_ = ((2147483648u | (_e975 << bitcast<u32>(28u))) | (select(_e995, _e964, _e997) & 268435455u));
                                                }
                                                let _e1010 = phi_3798_;
                                                phi_3799_ = _e1010;
                                            }
                                            let _e1012 = phi_3799_;
                                            phi_3803_ = type_50(array<vec4<f32>, 3>(vec4<f32>(_e890, (_e712.member.member.x + _e842), _e895, (_e712.member.member_1.x - _e881)), vec4<f32>(_e891, (_e712.member.member.y + _e846), _e896, (_e712.member.member_1.y - _e885)), vec4<f32>(_e892, (_e712.member.member.z + _e850), _e897, (_e712.member.member_1.z - _e889))), type_49(type_32((_e712.member.member + vec4<f32>(_e820, _e829, _e838, 0f)), (_e712.member.member_1 - vec4<f32>(_e859, _e868, _e877, 0f))), _e987), type_49(type_32((_e712.member.member + vec4<f32>(_e842, _e846, _e850, 0f)), (_e712.member.member_1 - vec4<f32>(_e881, _e885, _e889, 0f))), _e1012));
                                        }
                                        let _e1017 = phi_3803_;
                                        let _e1029 = ((_e1017.member[0].x - _e372) * _e377);
                                        let _e1030 = ((_e1017.member[0].y - _e372) * _e377);
                                        let _e1031 = ((_e1017.member[0].z - _e373) * _e377);
                                        let _e1032 = ((_e1017.member[0].w - _e373) * _e377);
                                        let _e1042 = ((_e1017.member[1].x - _e440) * _e445);
                                        let _e1043 = ((_e1017.member[1].y - _e440) * _e445);
                                        let _e1044 = ((_e1017.member[1].z - _e441) * _e445);
                                        let _e1045 = ((_e1017.member[1].w - _e441) * _e445);
                                        let _e1055 = ((_e1017.member[2].x - _e508) * _e513);
                                        let _e1056 = ((_e1017.member[2].y - _e508) * _e513);
                                        let _e1057 = ((_e1017.member[2].z - _e509) * _e513);
                                        let _e1058 = ((_e1017.member[2].w - _e509) * _e513);
                                        let _e1060 = select(_e1057, _e1055, (_e1055 < _e1057));
                                        let _e1062 = select(_e1058, _e1056, (_e1056 < _e1058));
                                        let _e1064 = select(_e1057, _e1055, (_e1055 > _e1057));
                                        let _e1066 = select(_e1058, _e1056, (_e1056 > _e1058));
                                        let _e1068 = select(_e1031, _e1029, (_e1029 < _e1031));
                                        let _e1070 = select(_e1032, _e1030, (_e1030 < _e1032));
                                        let _e1072 = select(_e1044, _e1042, (_e1042 < _e1044));
                                        let _e1074 = select(_e1045, _e1043, (_e1043 < _e1045));
                                        let _e1076 = select(_e1072, _e1068, (_e1068 > _e1072));
                                        let _e1078 = select(_e1074, _e1070, (_e1070 > _e1074));
                                        let _e1080 = select(_e1060, _e1076, (_e1076 > _e1060));
                                        let _e1082 = select(_e1062, _e1078, (_e1078 > _e1062));
                                        let _e1084 = select(_e1031, _e1029, (_e1029 > _e1031));
                                        let _e1086 = select(_e1032, _e1030, (_e1030 > _e1032));
                                        let _e1088 = select(_e1044, _e1042, (_e1042 > _e1044));
                                        let _e1090 = select(_e1045, _e1043, (_e1043 > _e1045));
                                        let _e1092 = select(_e1088, _e1084, (_e1084 < _e1088));
                                        let _e1094 = select(_e1090, _e1086, (_e1086 < _e1090));
                                        let _e1099 = -(_e1060);
                                        let _e1100 = -(_e1062);
                                        let _e1107 = (select(_e1064, _e1092, (_e1092 < _e1064)) + (select(_e1099, _e1064, (_e1064 > _e1099)) * 0.0000019073523f));
                                        let _e1108 = (select(_e1066, _e1094, (_e1094 < _e1066)) + (select(_e1100, _e1066, (_e1066 > _e1100)) * 0.0000019073523f));
                                        let _e1110 = select(_e625, _e1080, (_e1080 > _e625));
                                        let _e1112 = select(_e625, _e1082, (_e1082 > _e625));
                                        let _e1117 = (_e1110 <= select(_e669.member_1, _e1107, (_e1107 < _e669.member_1)));
                                        let _e1118 = (_e1112 <= select(_e669.member_1, _e1108, (_e1108 < _e669.member_1)));
                                        let _e1119 = (_e1110 <= _e1112);
                                        if _e1117 {
                                            if _e1118 {
                                                if _e1119 {
                                                    phi_4165_ = _e1017.member_2;
                                                } else {
                                                    phi_4165_ = _e1017.member_1;
                                                }
                                                let _e1123 = phi_4165_;
                                                let _e1145 = (_e710 % 128u);
                                                let _e1146 = (_e1145 < 128u);
                                                if _e1146 {
                                                } else {
                                                    phi_4845_ = true;
                                                    break;
                                                }
                                                local_8[_e1145] = _e1123.member_1;
                                                if _e1146 {
                                                } else {
                                                    phi_4845_ = true;
                                                    break;
                                                }
                                                local_7[_e1145] = _e1123.member.member.x;
                                                if _e1146 {
                                                } else {
                                                    phi_4845_ = true;
                                                    break;
                                                }
                                                local_6[_e1145] = _e1123.member.member.y;
                                                if _e1146 {
                                                } else {
                                                    phi_4845_ = true;
                                                    break;
                                                }
                                                local_5[_e1145] = _e1123.member.member.z;
                                                if _e1146 {
                                                } else {
                                                    phi_4845_ = true;
                                                    break;
                                                }
                                                local_4[_e1145] = _e1123.member.member_1.x;
                                                if _e1146 {
                                                } else {
                                                    phi_4845_ = true;
                                                    break;
                                                }
                                                local_3[_e1145] = _e1123.member.member_1.y;
                                                if _e1146 {
                                                } else {
                                                    phi_4845_ = true;
                                                    break;
                                                }
                                                local_2[_e1145] = _e1123.member.member_1.z;
                                                if _e1146 {
                                                } else {
                                                    phi_4845_ = true;
                                                    break;
                                                }
                                                local_9[_e1145] = select(_e1112, _e1110, !(_e1119));
                                                if _e1119 {
                                                    phi_4242_ = _e1017.member_1;
                                                } else {
                                                    phi_4242_ = _e1017.member_2;
                                                }
                                                let _e1159 = phi_4242_;
                                                phi_4243_ = (_e710 + 1u);
                                                phi_4244_ = _e1159;
                                            } else {
                                                phi_4243_ = u32();
                                                phi_4244_ = type_49();
                                            }
                                            let _e1161 = phi_4243_;
                                            let _e1163 = phi_4244_;
                                            phi_4246_ = _e1161;
                                            phi_4247_ = _e1163;
                                            phi_4248_ = select(true, false, _e1118);
                                        } else {
                                            phi_4246_ = u32();
                                            phi_4247_ = type_49();
                                            phi_4248_ = true;
                                        }
                                        let _e1166 = phi_4246_;
                                        let _e1168 = phi_4247_;
                                        let _e1170 = phi_4248_;
                                        if _e1170 {
                                            if _e1117 {
                                                phi_4257_ = _e1017.member_1;
                                            } else {
                                                phi_4257_ = _e1017.member_2;
                                            }
                                            let _e1174 = phi_4257_;
                                            phi_4262_ = select(_e1118, true, _e1117);
                                            phi_4264_ = _e1174;
                                        } else {
                                            phi_4262_ = _e708;
                                            phi_4264_ = _e1168;
                                        }
                                        let _e1177 = phi_4262_;
                                        let _e1179 = phi_4264_;
                                        phi_4849_ = _e667;
                                        phi_4268_ = _e669;
                                        phi_4269_ = _e1177;
                                        phi_4270_ = select(_e1166, _e710, _e1170);
                                        phi_4271_ = _e1179;
                                    }
                                    let _e2122 = phi_4849_;
                                    let _e2124 = phi_4268_;
                                    let _e2126 = phi_4269_;
                                    let _e2128 = phi_4270_;
                                    let _e2130 = phi_4271_;
                                    phi_4848_ = _e2122;
                                    phi_4272_ = _e2124;
                                    phi_4273_ = _e2126;
                                    phi_4274_ = (_e673 - 1u);
                                    phi_4275_ = _e2128;
                                    phi_4276_ = _e2130;
                                } else {
                                    phi_4848_ = _e667;
                                    phi_4272_ = _e669;
                                    phi_4273_ = _e708;
                                    phi_4274_ = _e673;
                                    phi_4275_ = _e710;
                                    phi_4276_ = _e712;
                                }
                                let _e2132 = phi_4848_;
                                let _e2134 = phi_4272_;
                                let _e2136 = phi_4273_;
                                let _e2138 = phi_4274_;
                                let _e2140 = phi_4275_;
                                let _e2142 = phi_4276_;
                                phi_4847_ = _e2132;
                                phi_4277_ = _e2134;
                                phi_4278_ = _e2136;
                                phi_4279_ = _e2138;
                                phi_4280_ = _e2140;
                                phi_4281_ = _e2142;
                            } else {
                                phi_4847_ = _e667;
                                phi_4277_ = type_37();
                                phi_4278_ = bool();
                                phi_4279_ = u32();
                                phi_4280_ = u32();
                                phi_4281_ = type_49();
                            }
                            let _e2144 = phi_4847_;
                            let _e2146 = phi_4277_;
                            let _e2148 = phi_4278_;
                            let _e2150 = phi_4279_;
                            let _e2152 = phi_4280_;
                            let _e2154 = phi_4281_;
                            phi_4846_ = _e2144;
                            phi_1174_ = _e2146;
                            phi_1177_ = _e2148;
                            phi_1179_ = _e2150;
                            phi_1181_ = _e2152;
                            phi_1183_ = _e2154;
                            phi_4282_ = _e681;
                        } else {
                            phi_4846_ = _e667;
                            phi_1174_ = type_37();
                            phi_1177_ = bool();
                            phi_1179_ = u32();
                            phi_1181_ = u32();
                            phi_1183_ = type_49();
                            phi_4282_ = false;
                        }
                        let _e2156 = phi_4846_;
                        let _e2158 = phi_1174_;
                        let _e2160 = phi_1177_;
                        let _e2162 = phi_1179_;
                        let _e2164 = phi_1181_;
                        let _e2166 = phi_1183_;
                        let _e2168 = phi_4282_;
                        continue;
                        continuing {
                            phi_4644_ = _e2156;
                            phi_1173_ = _e2158;
                            phi_1176_ = _e2160;
                            phi_1178_ = _e2162;
                            phi_1180_ = _e2164;
                            phi_1182_ = _e2166;
                            phi_4845_ = _e2156;
                            break if !(_e2168);
                        }
                    }
                    let _e2171 = phi_4845_;
                    if _e2171 {
                        break;
                    }
                    let _e2173 = local_10;
                    if (_e2173.member.member_3 != 4294967295u) {
                        let _e2178 = -(_e527);
                        let _e2179 = bitcast<u32>(_e2173.member.member);
                        let _e2183 = (bitcast<i32>((_e2179 >> bitcast<u32>(23i))) & 255i);
                        let _e2184 = (_e2183 + _e2178);
                        if (_e2183 == 255i) {
                            phi_4341_ = _e2173.member.member;
                        } else {
                            if (_e2183 > 0i) {
                                if (_e2184 > 0i) {
                                    let _e2188 = (_e2184 < 255i);
                                    if _e2188 {
                                        phi_4320_ = bitcast<f32>((_e2179 + bitcast<u32>((_e2178 << bitcast<u32>(23i)))));
                                    } else {
                                        phi_4320_ = f32();
                                    }
                                    let _e2195 = phi_4320_;
                                    phi_4322_ = _e2195;
                                    phi_4323_ = select(true, false, _e2188);
                                } else {
                                    phi_4322_ = f32();
                                    phi_4323_ = true;
                                }
                                let _e2198 = phi_4322_;
                                let _e2200 = phi_4323_;
                                phi_4324_ = _e2198;
                                phi_4325_ = _e2200;
                            } else {
                                phi_4324_ = f32();
                                phi_4325_ = true;
                            }
                            let _e2202 = phi_4324_;
                            let _e2204 = phi_4325_;
                            if _e2204 {
                                let _e2205 = (_e2179 & 2147483648u);
                                let _e2212 = ((_e2179 & 8388607u) | (select(0u, 1u, ((_e2179 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                                let _e2216 = (_e2212 == 0u);
                                if _e2216 {
                                    phi_4596_ = bitcast<f32>(_e2205);
                                } else {
                                    let _e2221 = (select((bitcast<u32>(31i) - firstLeadingBit(_e2212)), 32u, _e2216) - 8u);
                                    let _e2224 = (_e2212 << bitcast<u32>((_e2221 & 31u)));
                                    let _e2226 = ((_e2184 + select(0i, 1i, (_e2183 == 0i))) - bitcast<i32>(_e2221));
                                    if (_e2226 >= 255i) {
                                        phi_4586_ = bitcast<f32>((_e2205 | 2139095040u));
                                        phi_4587_ = f32();
                                        phi_4588_ = true;
                                    } else {
                                        let _e2228 = (_e2226 > 0i);
                                        if _e2228 {
                                            phi_4580_ = bitcast<f32>(((_e2205 | (bitcast<u32>(_e2226) << bitcast<u32>(23i))) | (_e2224 & 8388607u)));
                                            phi_4581_ = f32();
                                        } else {
                                            if (_e2226 < -24i) {
                                                phi_4546_ = 26u;
                                            } else {
                                                phi_4546_ = bitcast<u32>((1i - _e2226));
                                            }
                                            let _e2233 = phi_4546_;
                                            let _e2234 = (_e2233 & 31u);
                                            let _e2236 = (_e2224 >> bitcast<u32>(_e2234));
                                            let _e2240 = (_e2224 & ((1u << bitcast<u32>(_e2234)) - 1u));
                                            let _e2244 = (1u << bitcast<u32>(((_e2233 - 1u) & 31u)));
                                            if (_e2240 > _e2244) {
                                                phi_4567_ = true;
                                            } else {
                                                if (_e2240 == _e2244) {
                                                    phi_4564_ = ((_e2236 & 1u) == 1u);
                                                } else {
                                                    phi_4564_ = false;
                                                }
                                                let _e2250 = phi_4564_;
                                                phi_4567_ = _e2250;
                                            }
                                            let _e2252 = phi_4567_;
                                            phi_4580_ = f32();
                                            phi_4581_ = bitcast<f32>((_e2205 | (_e2236 + select(0u, 1u, _e2252))));
                                        }
                                        let _e2265 = phi_4580_;
                                        let _e2267 = phi_4581_;
                                        phi_4586_ = _e2265;
                                        phi_4587_ = _e2267;
                                        phi_4588_ = _e2228;
                                    }
                                    let _e2271 = phi_4586_;
                                    let _e2273 = phi_4587_;
                                    let _e2275 = phi_4588_;
                                    phi_4596_ = select(_e2273, _e2271, _e2275);
                                }
                                let _e2279 = phi_4596_;
                                phi_4340_ = _e2279;
                            } else {
                                phi_4340_ = _e2202;
                            }
                            let _e2281 = phi_4340_;
                            phi_4341_ = _e2281;
                        }
                        let _e2283 = phi_4341_;
                        let _e2284 = bitcast<u32>(_e2283);
                        if ((_e2284 & 2147483647u) >= 2139095040u) {
                            phi_4353_ = bitcast<f32>(((_e2284 & 2147483648u) | 2139095039u));
                        } else {
                            phi_4353_ = _e2283;
                        }
                        let _e2291 = phi_4353_;
                        phi_4358_ = type_24(_e2291, _e2173.member.member_1, _e2173.member.member_2, _e2173.member.member_3);
                    } else {
                        phi_4358_ = type_24(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                    }
                    let _e2296 = phi_4358_;
                    if _e158 {
                    } else {
                        break;
                    }
                    global_6.member[_e156] = _e2296;
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
