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

struct type_22 {
    member: array<type_20>,
}

struct type_24 {
    member: array<f32, 3>,
    member_1: f32,
    member_2: array<f32, 3>,
    member_3: f32,
}

struct type_28 {
    member: vec4<f32>,
    member_1: vec4<f32>,
}

struct type_33 {
    member: type_20,
    member_1: f32,
}

struct type_37 {
    member: array<type_24>,
}

struct type_40 {
    member: array<vec4<u32>, 2>,
}

struct type_44 {
    member: array<array<u32, 7>>,
}

struct type_49 {
    member: type_28,
    member_1: u32,
}

struct type_50 {
    member: array<vec4<f32>, 3>,
    member_1: type_49,
    member_2: type_49,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_1: type_12;
@group(0) @binding(1) 
var<uniform> global_2: type_40;
@group(0) @binding(4) 
var<storage> global_3: type_37;
@group(0) @binding(2) 
var<storage> global_4: type_44;
@group(0) @binding(3) 
var<storage> global_5: type_4;
@group(0) @binding(5) 
var<storage, read_write> global_6: type_22;

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
    var phi_1173_: type_33;
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
    var phi_1300_: type_33;
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
    var phi_2929_: type_20;
    var phi_2931_: type_20;
    var phi_2932_: bool;
    var phi_2936_: type_20;
    var phi_2937_: type_20;
    var phi_2938_: type_20;
    var phi_2939_: bool;
    var phi_2943_: type_20;
    var phi_2944_: bool;
    var phi_2945_: type_20;
    var phi_2946_: bool;
    var phi_2947_: bool;
    var phi_2948_: type_20;
    var phi_2949_: bool;
    var phi_2950_: bool;
    var phi_2958_: type_20;
    var phi_2959_: bool;
    var phi_2963_: type_20;
    var phi_2988_: bool;
    var phi_2989_: bool;
    var phi_2995_: type_33;
    var phi_2996_: type_33;
    var phi_2997_: type_33;
    var phi_1301_: type_33;
    var phi_4638_: bool;
    var phi_4849_: bool;
    var phi_4268_: type_33;
    var phi_4269_: bool;
    var phi_4270_: u32;
    var phi_4271_: type_49;
    var phi_4848_: bool;
    var phi_4272_: type_33;
    var phi_4273_: bool;
    var phi_4274_: u32;
    var phi_4275_: u32;
    var phi_4276_: type_49;
    var phi_4847_: bool;
    var phi_4277_: type_33;
    var phi_4278_: bool;
    var phi_4279_: u32;
    var phi_4280_: u32;
    var phi_4281_: type_49;
    var phi_4846_: bool;
    var phi_1174_: type_33;
    var phi_1177_: bool;
    var phi_1179_: u32;
    var phi_1181_: u32;
    var phi_1183_: type_49;
    var phi_4282_: bool;
    var phi_4845_: bool;
    var local_10: type_33;
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
    var phi_4358_: type_20;
    var local_11: type_33;

    switch bitcast<i32>(0u) {
        default: {
            let _e94 = global;
            let _e96 = arrayLength((&global_4.member));
            let _e99 = arrayLength((&global_5.member));
            let _e107 = global_2.member[0u][0u];
            let _e111 = global_2.member[0u][1u];
            let _e115 = global_2.member[0u][2u];
            let _e119 = global_2.member[0u][3u];
            let _e123 = global_2.member[1u][0u];
            let _e127 = global_2.member[1u][1u];
            let _e131 = global_2.member[1u][2u];
            let _e134 = global_1.member[0u];
            let _e135 = bitcast<i32>(_e134);
            let _e147 = bitcast<f32>((bitcast<u32>((bitcast<i32>(_e119) + 127i)) << bitcast<u32>(23i)));
            local_1 = array<i32, 3>(bitcast<i32>(_e107), bitcast<i32>(_e111), bitcast<i32>(_e115));
            local = array<i32, 3>(bitcast<i32>(_e123), bitcast<i32>(_e127), bitcast<i32>(_e131));
            let _e153 = (_e94.x + (_e94.y * 2097152u));
            let _e154 = (_e153 < arrayLength((&global_3.member)));
            if _e154 {
                let _e155 = (_e153 < arrayLength((&global_6.member)));
                if _e155 {
                    if _e154 {
                    } else {
                        break;
                    }
                    let _e163 = global_3.member[_e153].member_2[0u];
                    let _e165 = (bitcast<u32>(_e163) & 2147483647u);
                    let _e170 = global_3.member[_e153].member_2[1u];
                    let _e172 = (bitcast<u32>(_e170) & 2147483647u);
                    let _e177 = global_3.member[_e153].member_2[2u];
                    let _e179 = (bitcast<u32>(_e177) & 2147483647u);
                    let _e184 = global_3.member[_e153].member[0u];
                    let _e186 = (bitcast<u32>(_e184) & 2147483647u);
                    let _e191 = global_3.member[_e153].member[1u];
                    let _e193 = (bitcast<u32>(_e191) & 2147483647u);
                    let _e198 = global_3.member[_e153].member[2u];
                    let _e200 = (bitcast<u32>(_e198) & 2147483647u);
                    let _e202 = select(_e172, _e165, (_e172 < _e165));
                    let _e204 = select(_e179, _e202, (_e179 < _e202));
                    let _e206 = select(_e186, _e204, (_e186 < _e204));
                    let _e208 = select(_e193, _e206, (_e193 < _e206));
                    let _e210 = select(_e200, _e208, (_e200 < _e208));
                    let _e214 = global_3.member[_e153].member_1;
                    let _e215 = bitcast<u32>(_e214);
                    let _e216 = (_e215 & 2147483647u);
                    let _e223 = global_3.member[_e153].member_3;
                    let _e224 = bitcast<u32>(_e223);
                    let _e225 = (_e224 & 2147483647u);
                    let _e229 = (((select(_e216, _e210, (_e216 < _e210)) < 2139095040u) && (_e225 <= 2139095040u)) && (_e204 > 0u));
                    if _e229 {
                        let _e232 = (bitcast<u32>(bitcast<f32>(_e204)) & 2147483647u);
                        if (_e232 >= 8388608u) {
                            phi_484_ = (bitcast<i32>((_e232 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_484_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e232)), 32u, (_e232 == 0u))));
                        }
                        let _e246 = phi_484_;
                        phi_485_ = _e246;
                    } else {
                        phi_485_ = 0i;
                    }
                    let _e248 = phi_485_;
                    let _e249 = (_e165 == _e204);
                    if _e249 {
                        phi_495_ = true;
                    } else {
                        phi_495_ = (_e172 == _e204);
                    }
                    let _e252 = phi_495_;
                    let _e253 = select(1u, 0u, _e249);
                    if _e252 {
                        let _e254 = (_e253 + 1u);
                        phi_505_ = _e254;
                        phi_506_ = _e254;
                        phi_508_ = select(true, false, (_e254 == 2u));
                    } else {
                        phi_505_ = u32();
                        phi_506_ = 0u;
                        phi_508_ = true;
                    }
                    let _e258 = phi_505_;
                    let _e260 = phi_506_;
                    let _e262 = phi_508_;
                    if _e262 {
                        phi_513_ = (_e260 + 1u);
                    } else {
                        phi_513_ = 0u;
                    }
                    let _e266 = phi_513_;
                    let _e267 = select(_e258, _e260, _e262);
                    let _e268 = select(_e253, select(2u, _e253, _e252), _e262);
                    if (_e135 < -126i) {
                        phi_526_ = -126i;
                    } else {
                        phi_526_ = select(_e135, 127i, (_e135 > 127i));
                    }
                    let _e273 = phi_526_;
                    let _e278 = bitcast<f32>((bitcast<u32>((_e273 + 127i)) << bitcast<u32>(23i)));
                    let _e284 = bitcast<f32>((bitcast<u32>(((_e135 - _e273) + 127i)) << bitcast<u32>(23i)));
                    let _e285 = -(_e248);
                    if (_e285 < -126i) {
                        phi_546_ = -126i;
                    } else {
                        phi_546_ = select(_e285, 127i, (_e285 > 127i));
                    }
                    let _e290 = phi_546_;
                    let _e295 = bitcast<f32>((bitcast<u32>((_e290 + 127i)) << bitcast<u32>(23i)));
                    let _e301 = bitcast<f32>((bitcast<u32>(((_e285 - _e290) + 127i)) << bitcast<u32>(23i)));
                    let _e305 = global_3.member[_e153].member;
                    let _e306 = (_e267 == 0u);
                    if _e306 {
                        phi_564_ = _e305[0];
                    } else {
                        phi_564_ = _e305[1];
                    }
                    let _e310 = phi_564_;
                    let _e311 = (_e267 == 2u);
                    if _e311 {
                        phi_570_ = _e305[2];
                    } else {
                        phi_570_ = _e310;
                    }
                    let _e314 = phi_570_;
                    let _e315 = bitcast<u32>(_e314);
                    let _e317 = ((_e315 & 2139095040u) != 0u);
                    let _e331 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e315 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e315 & 2147483648u))), _e314, _e317) * _e278) * select(0.00000011920929f, 1f, _e317)) * _e284);
                    let _e332 = global_3.member[_e153].member_2;
                    if _e306 {
                        phi_610_ = _e332[0];
                    } else {
                        phi_610_ = _e332[1];
                    }
                    let _e336 = phi_610_;
                    if _e311 {
                        phi_616_ = _e332[2];
                    } else {
                        phi_616_ = _e336;
                    }
                    let _e339 = phi_616_;
                    let _e340 = bitcast<u32>(_e339);
                    let _e342 = ((_e340 & 2139095040u) != 0u);
                    let _e356 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e340 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e340 & 2147483648u))), _e339, _e342) * _e295) * select(0.00000011920929f, 1f, _e342)) * _e301);
                    let _e360 = (bitcast<f32>((bitcast<u32>(_e356) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e360 {
                        let _e364 = (bitcast<f32>((bitcast<u32>(_e331) & 2147483647u)) * 0.00000011920929f);
                        phi_668_ = select(0.00000000000011368684f, _e364, (_e364 > 0.00000000000011368684f));
                    } else {
                        phi_668_ = 0f;
                    }
                    let _e368 = phi_668_;
                    let _e369 = (_e331 + _e368);
                    let _e370 = (_e331 - _e368);
                    let _e371 = select(_e356, 0f, _e360);
                    if _e360 {
                        phi_680_ = 38685626000000000000000000f;
                    } else {
                        phi_680_ = (1f / _e356);
                    }
                    let _e374 = phi_680_;
                    let _e375 = (_e266 == 0u);
                    if _e375 {
                        phi_689_ = _e305[0];
                    } else {
                        phi_689_ = _e305[1];
                    }
                    let _e379 = phi_689_;
                    let _e380 = (_e266 == 2u);
                    if _e380 {
                        phi_695_ = _e305[2];
                    } else {
                        phi_695_ = _e379;
                    }
                    let _e383 = phi_695_;
                    let _e384 = bitcast<u32>(_e383);
                    let _e386 = ((_e384 & 2139095040u) != 0u);
                    let _e400 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e384 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e384 & 2147483648u))), _e383, _e386) * _e278) * select(0.00000011920929f, 1f, _e386)) * _e284);
                    if _e375 {
                        phi_735_ = _e332[0];
                    } else {
                        phi_735_ = _e332[1];
                    }
                    let _e404 = phi_735_;
                    if _e380 {
                        phi_741_ = _e332[2];
                    } else {
                        phi_741_ = _e404;
                    }
                    let _e407 = phi_741_;
                    let _e408 = bitcast<u32>(_e407);
                    let _e410 = ((_e408 & 2139095040u) != 0u);
                    let _e424 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e408 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e408 & 2147483648u))), _e407, _e410) * _e295) * select(0.00000011920929f, 1f, _e410)) * _e301);
                    let _e428 = (bitcast<f32>((bitcast<u32>(_e424) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e428 {
                        let _e432 = (bitcast<f32>((bitcast<u32>(_e400) & 2147483647u)) * 0.00000011920929f);
                        phi_793_ = select(0.00000000000011368684f, _e432, (_e432 > 0.00000000000011368684f));
                    } else {
                        phi_793_ = 0f;
                    }
                    let _e436 = phi_793_;
                    let _e437 = (_e400 + _e436);
                    let _e438 = (_e400 - _e436);
                    let _e439 = select(_e424, 0f, _e428);
                    if _e428 {
                        phi_805_ = 38685626000000000000000000f;
                    } else {
                        phi_805_ = (1f / _e424);
                    }
                    let _e442 = phi_805_;
                    let _e443 = (_e268 == 0u);
                    if _e443 {
                        phi_814_ = _e305[0];
                    } else {
                        phi_814_ = _e305[1];
                    }
                    let _e447 = phi_814_;
                    let _e448 = (_e268 == 2u);
                    if _e448 {
                        phi_820_ = _e305[2];
                    } else {
                        phi_820_ = _e447;
                    }
                    let _e451 = phi_820_;
                    let _e452 = bitcast<u32>(_e451);
                    let _e454 = ((_e452 & 2139095040u) != 0u);
                    let _e468 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e452 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e452 & 2147483648u))), _e451, _e454) * _e278) * select(0.00000011920929f, 1f, _e454)) * _e284);
                    if _e443 {
                        phi_860_ = _e332[0];
                    } else {
                        phi_860_ = _e332[1];
                    }
                    let _e472 = phi_860_;
                    if _e448 {
                        phi_866_ = _e332[2];
                    } else {
                        phi_866_ = _e472;
                    }
                    let _e475 = phi_866_;
                    let _e476 = bitcast<u32>(_e475);
                    let _e478 = ((_e476 & 2139095040u) != 0u);
                    let _e492 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e476 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e476 & 2147483648u))), _e475, _e478) * _e295) * select(0.00000011920929f, 1f, _e478)) * _e301);
                    let _e496 = (bitcast<f32>((bitcast<u32>(_e492) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e496 {
                        let _e500 = (bitcast<f32>((bitcast<u32>(_e468) & 2147483647u)) * 0.00000011920929f);
                        phi_918_ = select(0.00000000000011368684f, _e500, (_e500 > 0.00000000000011368684f));
                    } else {
                        phi_918_ = 0f;
                    }
                    let _e504 = phi_918_;
                    let _e505 = (_e468 + _e504);
                    let _e506 = (_e468 - _e504);
                    let _e507 = select(_e492, 0f, _e496);
                    if _e496 {
                        phi_930_ = 38685626000000000000000000f;
                    } else {
                        phi_930_ = (1f / _e492);
                    }
                    let _e510 = phi_930_;
                    let _e513 = bitcast<f32>((bitcast<u32>(_e331) & 2147483647u));
                    let _e516 = bitcast<f32>((bitcast<u32>(_e400) & 2147483647u));
                    let _e518 = select(_e516, _e513, (_e513 > _e516));
                    let _e521 = bitcast<f32>((bitcast<u32>(_e468) & 2147483647u));
                    let _e524 = (_e135 + _e248);
                    if (_e229 && (select(_e521, _e518, (_e518 > _e521)) <= 1099511600000f)) {
                        let _e534 = ((_e216 & 8388607u) | (select(0u, 1u, ((_e216 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                        let _e537 = bitcast<i32>((_e216 >> bitcast<u32>(23i)));
                        let _e541 = (_e534 == 0u);
                        let _e544 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e534)), 32u, _e541)) - 8i);
                        if (_e537 == 255i) {
                            phi_985_ = 255i;
                        } else {
                            phi_985_ = (((_e537 + select(0i, 1i, (_e537 == 0i))) - _e544) + _e524);
                        }
                        let _e552 = phi_985_;
                        let _e562 = (_e552 <= 0i);
                        if _e562 {
                            phi_1008_ = u32();
                        } else {
                            if _e541 {
                                phi_1007_ = u32();
                            } else {
                                phi_1007_ = select(((bitcast<u32>(_e552) << bitcast<u32>(23i)) | ((_e534 << bitcast<u32>(((_e544 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e552 >= 255i));
                            }
                            let _e566 = phi_1007_;
                            phi_1008_ = _e566;
                        }
                        let _e568 = phi_1008_;
                        let _e580 = ((_e225 & 8388607u) | (select(0u, 1u, ((_e225 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                        let _e583 = bitcast<i32>((_e225 >> bitcast<u32>(23i)));
                        let _e587 = (_e580 == 0u);
                        let _e590 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e580)), 32u, _e587)) - 8i);
                        if (_e583 == 255i) {
                            phi_1045_ = 255i;
                        } else {
                            phi_1045_ = (((_e583 + select(0i, 1i, (_e583 == 0i))) - _e590) + _e524);
                        }
                        let _e598 = phi_1045_;
                        let _e608 = (_e598 <= 0i);
                        if _e608 {
                            phi_1068_ = u32();
                        } else {
                            if _e587 {
                                phi_1067_ = u32();
                            } else {
                                phi_1067_ = select(((bitcast<u32>(_e598) << bitcast<u32>(23i)) | ((_e580 << bitcast<u32>(((_e590 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e598 >= 255i));
                            }
                            let _e612 = phi_1067_;
                            phi_1068_ = _e612;
                        }
                        let _e614 = phi_1068_;
                        phi_1076_ = bitcast<f32>(((_e224 & 2147483648u) | select(_e614, 0u, select(_e587, true, _e608))));
                        phi_1077_ = bitcast<f32>(((_e215 & 2147483648u) | select(_e568, 0u, select(_e541, true, _e562))));
                    } else {
                        phi_1076_ = 0f;
                        phi_1077_ = 1f;
                    }
                    let _e620 = phi_1076_;
                    let _e622 = phi_1077_;
                    local_8 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                    local_7 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_6 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_5 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_4 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_3 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_9 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    let _e626 = (_e267 % 3u);
                    let _e627 = (_e626 < 3u);
                    if _e627 {
                    } else {
                        break;
                    }
                    let _e629 = local_1[_e626];
                    let _e632 = (_e266 % 3u);
                    let _e633 = (_e632 < 3u);
                    if _e633 {
                    } else {
                        break;
                    }
                    let _e635 = local_1[_e632];
                    let _e638 = (_e268 % 3u);
                    let _e639 = (_e638 < 3u);
                    if _e639 {
                    } else {
                        break;
                    }
                    let _e641 = local_1[_e638];
                    if _e627 {
                    } else {
                        break;
                    }
                    let _e646 = local[_e626];
                    if _e633 {
                    } else {
                        break;
                    }
                    let _e650 = local[_e632];
                    if _e639 {
                    } else {
                        break;
                    }
                    let _e654 = local[_e638];
                    phi_4644_ = false;
                    phi_1173_ = type_33(type_20(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e620);
                    phi_1176_ = (_e622 <= _e620);
                    phi_1178_ = ((3u * _e96) + 1u);
                    phi_1180_ = 0u;
                    phi_1182_ = type_49(type_28(vec4<f32>((f32(_e629) * _e147), (f32(_e635) * _e147), (f32(_e641) * _e147), 0f), vec4<f32>((f32(_e646) * _e147), (f32(_e650) * _e147), (f32(_e654) * _e147), 0f)), select(0u, 2147483648u, (_e96 == 0u)));
                    loop {
                        let _e664 = phi_4644_;
                        let _e666 = phi_1173_;
                        let _e668 = phi_1176_;
                        let _e670 = phi_1178_;
                        let _e672 = phi_1180_;
                        let _e674 = phi_1182_;
                        local_10 = _e666;
                        if _e668 {
                            phi_1193_ = true;
                        } else {
                            phi_1193_ = (_e672 > 0u);
                        }
                        let _e677 = phi_1193_;
                        if _e677 {
                            let _e678 = (_e670 > 0u);
                            if _e678 {
                                if _e668 {
                                    phi_1279_ = _e668;
                                    phi_1280_ = _e672;
                                    phi_1281_ = _e674;
                                } else {
                                    let _e679 = (_e672 - 1u);
                                    let _e680 = (_e679 % 128u);
                                    let _e681 = (_e680 < 128u);
                                    if _e681 {
                                    } else {
                                        phi_4845_ = true;
                                        break;
                                    }
                                    let _e683 = local_7[_e680];
                                    if _e681 {
                                    } else {
                                        phi_4845_ = true;
                                        break;
                                    }
                                    let _e685 = local_6[_e680];
                                    if _e681 {
                                    } else {
                                        phi_4845_ = true;
                                        break;
                                    }
                                    let _e687 = local_5[_e680];
                                    if _e681 {
                                    } else {
                                        phi_4845_ = true;
                                        break;
                                    }
                                    let _e689 = local_4[_e680];
                                    if _e681 {
                                    } else {
                                        phi_4845_ = true;
                                        break;
                                    }
                                    let _e691 = local_3[_e680];
                                    if _e681 {
                                    } else {
                                        phi_4845_ = true;
                                        break;
                                    }
                                    let _e693 = local_2[_e680];
                                    if _e681 {
                                    } else {
                                        phi_4845_ = true;
                                        break;
                                    }
                                    let _e698 = local_8[_e680];
                                    if _e681 {
                                    } else {
                                        phi_4845_ = true;
                                        break;
                                    }
                                    let _e701 = local_9[_e680];
                                    phi_1279_ = (_e701 <= _e666.member_1);
                                    phi_1280_ = _e679;
                                    phi_1281_ = type_49(type_28(vec4<f32>(_e683, _e685, _e687, 0f), vec4<f32>(_e689, _e691, _e693, 0f)), _e698);
                                }
                                let _e705 = phi_1279_;
                                let _e707 = phi_1280_;
                                let _e709 = phi_1281_;
                                if _e705 {
                                    let _e714 = (_e709.member_1 & 268435455u);
                                    if ((_e709.member_1 & 2147483648u) != 0u) {
                                        phi_1300_ = _e666;
                                        phi_1303_ = type_8(0u, ((_e709.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e1198 = phi_1300_;
                                            let _e1200 = phi_1303_;
                                            local_11 = _e1198;
                                            if (_e1200.member < _e1200.member_1) {
                                                phi_1304_ = type_8((_e1200.member + 1u), _e1200.member_1);
                                                phi_1326_ = type_8(1u, _e1200.member);
                                            } else {
                                                phi_1304_ = _e1200;
                                                phi_1326_ = type_8(0u, type_8().member_1);
                                            }
                                            let _e1213 = phi_1304_;
                                            let _e1215 = phi_1326_;
                                            let _e1219 = (bitcast<i32>(_e1215.member) != 0i);
                                            if _e1219 {
                                                let _e1224 = (_e709.member.member_1.x - _e709.member.member.x);
                                                let _e1227 = (_e709.member.member_1.y - _e709.member.member.y);
                                                let _e1230 = (_e709.member.member_1.z - _e709.member.member.z);
                                                let _e1232 = select(_e1227, _e1224, (_e1224 > _e1227));
                                                let _e1234 = select(_e1230, _e1232, (_e1232 > _e1230));
                                                let _e1236 = (_e1234 < (1024f * _e147));
                                                if _e1236 {
                                                    phi_1367_ = 0u;
                                                } else {
                                                    phi_1367_ = select(2u, 1u, (_e1234 < (2097152f * _e147)));
                                                }
                                                let _e1241 = phi_1367_;
                                                switch bitcast<i32>(_e1241) {
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
                                                let _e1244 = phi_1373_;
                                                switch bitcast<i32>(_e1241) {
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
                                                let _e1251 = phi_1383_;
                                                let _e1253 = ((_e714 + (_e1215.member_1 * ((3u * _e1244) + 1u))) + (3u * _e1251));
                                                let _e1254 = (_e1253 < _e99);
                                                if _e1254 {
                                                    if _e1254 {
                                                    } else {
                                                        phi_4638_ = true;
                                                        break;
                                                    }
                                                    let _e1256 = global_5.member[_e1253];
                                                    phi_1399_ = _e1256;
                                                } else {
                                                    phi_1399_ = 4294967295u;
                                                }
                                                let _e1258 = phi_1399_;
                                                if _e1236 {
                                                    phi_1432_ = 0u;
                                                } else {
                                                    phi_1432_ = select(2u, 1u, (_e1234 < (2097152f * _e147)));
                                                }
                                                let _e1263 = phi_1432_;
                                                switch bitcast<i32>(_e1263) {
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
                                                let _e1266 = phi_1438_;
                                                let _e1270 = (_e714 + (_e1215.member_1 * ((3u * _e1266) + 1u)));
                                                switch bitcast<i32>(_e1263) {
                                                    case 0: {
                                                        let _e1545 = (_e1270 < _e99);
                                                        if _e1545 {
                                                            if _e1545 {
                                                            } else {
                                                                phi_4638_ = true;
                                                                break;
                                                            }
                                                            let _e1547 = global_5.member[_e1270];
                                                            phi_1465_ = _e1547;
                                                        } else {
                                                            phi_1465_ = 0u;
                                                        }
                                                        let _e1549 = phi_1465_;
                                                        let _e1551 = ((10u * _e267) & 31u);
                                                        let _e1561 = ((10u * _e266) & 31u);
                                                        let _e1571 = ((10u * _e268) & 31u);
                                                        let _e1581 = (_e1270 + 1u);
                                                        let _e1582 = (_e1581 < _e99);
                                                        if _e1582 {
                                                            if _e1582 {
                                                            } else {
                                                                phi_4638_ = true;
                                                                break;
                                                            }
                                                            let _e1584 = global_5.member[_e1581];
                                                            phi_1514_ = _e1584;
                                                        } else {
                                                            phi_1514_ = 0u;
                                                        }
                                                        let _e1586 = phi_1514_;
                                                        let _e1612 = (_e1270 + 2u);
                                                        let _e1613 = (_e1612 < _e99);
                                                        if _e1613 {
                                                            if _e1613 {
                                                            } else {
                                                                phi_4638_ = true;
                                                                break;
                                                            }
                                                            let _e1615 = global_5.member[_e1612];
                                                            phi_1563_ = _e1615;
                                                        } else {
                                                            phi_1563_ = 0u;
                                                        }
                                                        let _e1617 = phi_1563_;
                                                        phi_2064_ = array<array<f32, 3>, 3>(array<f32, 3>((_e709.member.member.x + ((bitcast<f32>((1258291200u | ((_e1549 >> bitcast<u32>(_e1551)) & 1023u))) - 8388608f) * _e147)), (_e709.member.member.y + ((bitcast<f32>((1258291200u | ((_e1549 >> bitcast<u32>(_e1561)) & 1023u))) - 8388608f) * _e147)), (_e709.member.member.z + ((bitcast<f32>((1258291200u | ((_e1549 >> bitcast<u32>(_e1571)) & 1023u))) - 8388608f) * _e147))), array<f32, 3>((_e709.member.member.x + ((bitcast<f32>((1258291200u | ((_e1586 >> bitcast<u32>(_e1551)) & 1023u))) - 8388608f) * _e147)), (_e709.member.member.y + ((bitcast<f32>((1258291200u | ((_e1586 >> bitcast<u32>(_e1561)) & 1023u))) - 8388608f) * _e147)), (_e709.member.member.z + ((bitcast<f32>((1258291200u | ((_e1586 >> bitcast<u32>(_e1571)) & 1023u))) - 8388608f) * _e147))), array<f32, 3>((_e709.member.member.x + ((bitcast<f32>((1258291200u | ((_e1617 >> bitcast<u32>(_e1551)) & 1023u))) - 8388608f) * _e147)), (_e709.member.member.y + ((bitcast<f32>((1258291200u | ((_e1617 >> bitcast<u32>(_e1561)) & 1023u))) - 8388608f) * _e147)), (_e709.member.member.z + ((bitcast<f32>((1258291200u | ((_e1617 >> bitcast<u32>(_e1571)) & 1023u))) - 8388608f) * _e147))));
                                                        break;
                                                    }
                                                    case 1: {
                                                        let _e1359 = (_e1270 < _e99);
                                                        if _e1359 {
                                                            if _e1359 {
                                                            } else {
                                                                phi_4638_ = true;
                                                                break;
                                                            }
                                                            let _e1361 = global_5.member[_e1270];
                                                            phi_1612_ = _e1361;
                                                        } else {
                                                            phi_1612_ = 0u;
                                                        }
                                                        let _e1363 = phi_1612_;
                                                        let _e1364 = (_e1270 + 1u);
                                                        let _e1365 = (_e1364 < _e99);
                                                        if _e1365 {
                                                            if _e1365 {
                                                            } else {
                                                                phi_4638_ = true;
                                                                break;
                                                            }
                                                            let _e1367 = global_5.member[_e1364];
                                                            phi_1627_ = _e1367;
                                                        } else {
                                                            phi_1627_ = 0u;
                                                        }
                                                        let _e1369 = phi_1627_;
                                                        let _e1370 = (_e267 == 1u);
                                                        if _e1370 {
                                                            phi_1637_ = ((_e1363 >> bitcast<u32>(21i)) | (_e1369 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1637_ = (_e1369 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1379 = phi_1637_;
                                                        let _e1387 = (_e266 == 1u);
                                                        if _e1387 {
                                                            phi_1658_ = ((_e1363 >> bitcast<u32>(21i)) | (_e1369 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1658_ = (_e1369 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1396 = phi_1658_;
                                                        let _e1404 = (_e268 == 1u);
                                                        if _e1404 {
                                                            phi_1679_ = ((_e1363 >> bitcast<u32>(21i)) | (_e1369 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1679_ = (_e1369 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1413 = phi_1679_;
                                                        let _e1422 = (_e1270 + 2u);
                                                        let _e1423 = (_e1422 < _e99);
                                                        if _e1423 {
                                                            if _e1423 {
                                                            } else {
                                                                phi_4638_ = true;
                                                                break;
                                                            }
                                                            let _e1425 = global_5.member[_e1422];
                                                            phi_1709_ = _e1425;
                                                        } else {
                                                            phi_1709_ = 0u;
                                                        }
                                                        let _e1427 = phi_1709_;
                                                        let _e1428 = (_e1270 + 3u);
                                                        let _e1429 = (_e1428 < _e99);
                                                        if _e1429 {
                                                            if _e1429 {
                                                            } else {
                                                                phi_4638_ = true;
                                                                break;
                                                            }
                                                            let _e1431 = global_5.member[_e1428];
                                                            phi_1724_ = _e1431;
                                                        } else {
                                                            phi_1724_ = 0u;
                                                        }
                                                        let _e1433 = phi_1724_;
                                                        if _e1370 {
                                                            phi_1734_ = ((_e1427 >> bitcast<u32>(21i)) | (_e1433 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1734_ = (_e1433 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1442 = phi_1734_;
                                                        if _e1387 {
                                                            phi_1755_ = ((_e1427 >> bitcast<u32>(21i)) | (_e1433 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1755_ = (_e1433 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1458 = phi_1755_;
                                                        if _e1404 {
                                                            phi_1776_ = ((_e1427 >> bitcast<u32>(21i)) | (_e1433 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1776_ = (_e1433 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1474 = phi_1776_;
                                                        let _e1483 = (_e1270 + 4u);
                                                        let _e1484 = (_e1483 < _e99);
                                                        if _e1484 {
                                                            if _e1484 {
                                                            } else {
                                                                phi_4638_ = true;
                                                                break;
                                                            }
                                                            let _e1486 = global_5.member[_e1483];
                                                            phi_1806_ = _e1486;
                                                        } else {
                                                            phi_1806_ = 0u;
                                                        }
                                                        let _e1488 = phi_1806_;
                                                        let _e1489 = (_e1270 + 5u);
                                                        let _e1490 = (_e1489 < _e99);
                                                        if _e1490 {
                                                            if _e1490 {
                                                            } else {
                                                                phi_4638_ = true;
                                                                break;
                                                            }
                                                            let _e1492 = global_5.member[_e1489];
                                                            phi_1821_ = _e1492;
                                                        } else {
                                                            phi_1821_ = 0u;
                                                        }
                                                        let _e1494 = phi_1821_;
                                                        if _e1370 {
                                                            phi_1831_ = ((_e1488 >> bitcast<u32>(21i)) | (_e1494 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1831_ = (_e1494 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1503 = phi_1831_;
                                                        if _e1387 {
                                                            phi_1852_ = ((_e1488 >> bitcast<u32>(21i)) | (_e1494 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1852_ = (_e1494 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1519 = phi_1852_;
                                                        if _e1404 {
                                                            phi_1873_ = ((_e1488 >> bitcast<u32>(21i)) | (_e1494 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1873_ = (_e1494 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1535 = phi_1873_;
                                                        phi_2064_ = array<array<f32, 3>, 3>(array<f32, 3>((_e709.member.member.x + ((bitcast<f32>((1258291200u | (select(_e1379, _e1363, _e306) & 2097151u))) - 8388608f) * _e147)), (_e709.member.member.y + ((bitcast<f32>((1258291200u | (select(_e1396, _e1363, _e375) & 2097151u))) - 8388608f) * _e147)), (_e709.member.member.z + ((bitcast<f32>((1258291200u | (select(_e1413, _e1363, _e443) & 2097151u))) - 8388608f) * _e147))), array<f32, 3>((_e709.member.member.x + ((bitcast<f32>((1258291200u | (select(_e1442, _e1427, _e306) & 2097151u))) - 8388608f) * _e147)), (_e709.member.member.y + ((bitcast<f32>((1258291200u | (select(_e1458, _e1427, _e375) & 2097151u))) - 8388608f) * _e147)), (_e709.member.member.z + ((bitcast<f32>((1258291200u | (select(_e1474, _e1427, _e443) & 2097151u))) - 8388608f) * _e147))), array<f32, 3>((_e709.member.member.x + ((bitcast<f32>((1258291200u | (select(_e1503, _e1488, _e306) & 2097151u))) - 8388608f) * _e147)), (_e709.member.member.y + ((bitcast<f32>((1258291200u | (select(_e1519, _e1488, _e375) & 2097151u))) - 8388608f) * _e147)), (_e709.member.member.z + ((bitcast<f32>((1258291200u | (select(_e1535, _e1488, _e443) & 2097151u))) - 8388608f) * _e147))));
                                                        break;
                                                    }
                                                    case 2: {
                                                        let _e1272 = (_e1270 + _e267);
                                                        let _e1273 = (_e1272 < _e99);
                                                        if _e1273 {
                                                            if _e1273 {
                                                            } else {
                                                                phi_4638_ = true;
                                                                break;
                                                            }
                                                            let _e1275 = global_5.member[_e1272];
                                                            phi_1904_ = _e1275;
                                                        } else {
                                                            phi_1904_ = 0u;
                                                        }
                                                        let _e1277 = phi_1904_;
                                                        let _e1281 = (_e1270 + _e266);
                                                        let _e1282 = (_e1281 < _e99);
                                                        if _e1282 {
                                                            if _e1282 {
                                                            } else {
                                                                phi_4638_ = true;
                                                                break;
                                                            }
                                                            let _e1284 = global_5.member[_e1281];
                                                            phi_1922_ = _e1284;
                                                        } else {
                                                            phi_1922_ = 0u;
                                                        }
                                                        let _e1286 = phi_1922_;
                                                        let _e1290 = (_e1270 + _e268);
                                                        let _e1291 = (_e1290 < _e99);
                                                        if _e1291 {
                                                            if _e1291 {
                                                            } else {
                                                                phi_4638_ = true;
                                                                break;
                                                            }
                                                            let _e1293 = global_5.member[_e1290];
                                                            phi_1940_ = _e1293;
                                                        } else {
                                                            phi_1940_ = 0u;
                                                        }
                                                        let _e1295 = phi_1940_;
                                                        let _e1300 = (_e1270 + 3u);
                                                        let _e1301 = (_e1300 + _e267);
                                                        let _e1302 = (_e1301 < _e99);
                                                        if _e1302 {
                                                            if _e1302 {
                                                            } else {
                                                                phi_4638_ = true;
                                                                break;
                                                            }
                                                            let _e1304 = global_5.member[_e1301];
                                                            phi_1963_ = _e1304;
                                                        } else {
                                                            phi_1963_ = 0u;
                                                        }
                                                        let _e1306 = phi_1963_;
                                                        let _e1310 = (_e1300 + _e266);
                                                        let _e1311 = (_e1310 < _e99);
                                                        if _e1311 {
                                                            if _e1311 {
                                                            } else {
                                                                phi_4638_ = true;
                                                                break;
                                                            }
                                                            let _e1313 = global_5.member[_e1310];
                                                            phi_1981_ = _e1313;
                                                        } else {
                                                            phi_1981_ = 0u;
                                                        }
                                                        let _e1315 = phi_1981_;
                                                        let _e1319 = (_e1300 + _e268);
                                                        let _e1320 = (_e1319 < _e99);
                                                        if _e1320 {
                                                            if _e1320 {
                                                            } else {
                                                                phi_4638_ = true;
                                                                break;
                                                            }
                                                            let _e1322 = global_5.member[_e1319];
                                                            phi_1999_ = _e1322;
                                                        } else {
                                                            phi_1999_ = 0u;
                                                        }
                                                        let _e1324 = phi_1999_;
                                                        let _e1329 = (_e1270 + 6u);
                                                        let _e1330 = (_e1329 + _e267);
                                                        let _e1331 = (_e1330 < _e99);
                                                        if _e1331 {
                                                            if _e1331 {
                                                            } else {
                                                                phi_4638_ = true;
                                                                break;
                                                            }
                                                            let _e1333 = global_5.member[_e1330];
                                                            phi_2022_ = _e1333;
                                                        } else {
                                                            phi_2022_ = 0u;
                                                        }
                                                        let _e1335 = phi_2022_;
                                                        let _e1339 = (_e1329 + _e266);
                                                        let _e1340 = (_e1339 < _e99);
                                                        if _e1340 {
                                                            if _e1340 {
                                                            } else {
                                                                phi_4638_ = true;
                                                                break;
                                                            }
                                                            let _e1342 = global_5.member[_e1339];
                                                            phi_2040_ = _e1342;
                                                        } else {
                                                            phi_2040_ = 0u;
                                                        }
                                                        let _e1344 = phi_2040_;
                                                        let _e1348 = (_e1329 + _e268);
                                                        let _e1349 = (_e1348 < _e99);
                                                        if _e1349 {
                                                            if _e1349 {
                                                            } else {
                                                                phi_4638_ = true;
                                                                break;
                                                            }
                                                            let _e1351 = global_5.member[_e1348];
                                                            phi_2058_ = _e1351;
                                                        } else {
                                                            phi_2058_ = 0u;
                                                        }
                                                        let _e1353 = phi_2058_;
                                                        phi_2064_ = array<array<f32, 3>, 3>(array<f32, 3>((f32(bitcast<i32>(_e1277)) * _e147), (f32(bitcast<i32>(_e1286)) * _e147), (f32(bitcast<i32>(_e1295)) * _e147)), array<f32, 3>((f32(bitcast<i32>(_e1306)) * _e147), (f32(bitcast<i32>(_e1315)) * _e147), (f32(bitcast<i32>(_e1324)) * _e147)), array<f32, 3>((f32(bitcast<i32>(_e1335)) * _e147), (f32(bitcast<i32>(_e1344)) * _e147), (f32(bitcast<i32>(_e1353)) * _e147)));
                                                        break;
                                                    }
                                                    default: {
                                                        phi_2064_ = array<array<f32, 3>, 3>();
                                                        break;
                                                    }
                                                }
                                                let _e1645 = phi_2064_;
                                                let _e1653 = (_e1645[0][2] - _e468);
                                                let _e1656 = (((_e1645[0][0] - _e331) * _e507) - (_e1653 * _e371));
                                                let _e1659 = (((_e1645[0][1] - _e400) * _e507) - (_e1653 * _e439));
                                                let _e1666 = (_e1645[1][2] - _e468);
                                                let _e1669 = (((_e1645[1][0] - _e331) * _e507) - (_e1666 * _e371));
                                                let _e1672 = (((_e1645[1][1] - _e400) * _e507) - (_e1666 * _e439));
                                                let _e1679 = (_e1645[2][2] - _e468);
                                                let _e1682 = (((_e1645[2][0] - _e331) * _e507) - (_e1679 * _e371));
                                                let _e1685 = (((_e1645[2][1] - _e400) * _e507) - (_e1679 * _e439));
                                                let _e1686 = (_e1682 * _e1672);
                                                let _e1687 = (_e1685 * _e1669);
                                                let _e1688 = (_e1656 * _e1685);
                                                let _e1689 = (_e1659 * _e1682);
                                                let _e1690 = (_e1669 * _e1659);
                                                let _e1691 = (_e1672 * _e1656);
                                                let _e1696 = (((_e1686 >= _e1687) && (_e1688 >= _e1689)) && (_e1690 >= _e1691));
                                                if (_e1696 || (((_e1686 <= _e1687) && (_e1688 <= _e1689)) && (_e1690 <= _e1691))) {
                                                    let _e1703 = select(-1f, 1f, _e1696);
                                                    let _e1705 = ((_e1686 - _e1687) * _e1703);
                                                    let _e1707 = select(0f, _e1705, (_e1705 > 0f));
                                                    let _e1709 = ((_e1688 - _e1689) * _e1703);
                                                    let _e1711 = select(0f, _e1709, (_e1709 > 0f));
                                                    let _e1713 = ((_e1690 - _e1691) * _e1703);
                                                    let _e1715 = select(0f, _e1713, (_e1713 > 0f));
                                                    let _e1717 = ((_e1707 + _e1711) + _e1715);
                                                    if (_e1717 < 0.000000000000000000000000000000000000011754944f) {
                                                        phi_2948_ = type_20();
                                                        phi_2949_ = true;
                                                        phi_2950_ = false;
                                                    } else {
                                                        let _e1720 = select(_e1669, _e1656, (_e1656 < _e1669));
                                                        if (select(_e1682, _e1720, (_e1720 < _e1682)) > 0f) {
                                                            phi_2216_ = true;
                                                        } else {
                                                            let _e1725 = select(_e1669, _e1656, (_e1656 > _e1669));
                                                            phi_2216_ = (select(_e1682, _e1725, (_e1725 > _e1682)) < 0f);
                                                        }
                                                        let _e1730 = phi_2216_;
                                                        if _e1730 {
                                                            phi_2945_ = type_20();
                                                            phi_2946_ = true;
                                                            phi_2947_ = false;
                                                        } else {
                                                            let _e1732 = select(_e1672, _e1659, (_e1659 < _e1672));
                                                            if (select(_e1685, _e1732, (_e1732 < _e1685)) > 0f) {
                                                                phi_2245_ = true;
                                                            } else {
                                                                let _e1737 = select(_e1672, _e1659, (_e1659 > _e1672));
                                                                phi_2245_ = (select(_e1685, _e1737, (_e1737 > _e1685)) < 0f);
                                                            }
                                                            let _e1742 = phi_2245_;
                                                            if _e1742 {
                                                                phi_2943_ = type_20();
                                                                phi_2944_ = false;
                                                            } else {
                                                                let _e1744 = select(_e1645[1][0], _e1645[0][0], (_e1645[0][0] < _e1645[1][0]));
                                                                let _e1748 = select(_e1645[1][0], _e1645[0][0], (_e1645[0][0] > _e1645[1][0]));
                                                                let _e1752 = select(_e1645[1][1], _e1645[0][1], (_e1645[0][1] < _e1645[1][1]));
                                                                let _e1756 = select(_e1645[1][1], _e1645[0][1], (_e1645[0][1] > _e1645[1][1]));
                                                                let _e1760 = select(_e1645[1][2], _e1645[0][2], (_e1645[0][2] < _e1645[1][2]));
                                                                let _e1764 = select(_e1645[1][2], _e1645[0][2], (_e1645[0][2] > _e1645[1][2]));
                                                                let _e1769 = ((select(_e1645[2][0], _e1744, (_e1744 < _e1645[2][0])) - _e369) * _e374);
                                                                let _e1770 = ((select(_e1645[2][0], _e1748, (_e1748 > _e1645[2][0])) - _e370) * _e374);
                                                                let _e1773 = ((select(_e1645[2][1], _e1752, (_e1752 < _e1645[2][1])) - _e437) * _e442);
                                                                let _e1774 = ((select(_e1645[2][1], _e1756, (_e1756 > _e1645[2][1])) - _e438) * _e442);
                                                                let _e1777 = ((select(_e1645[2][2], _e1760, (_e1760 < _e1645[2][2])) - _e505) * _e510);
                                                                let _e1778 = ((select(_e1645[2][2], _e1764, (_e1764 > _e1645[2][2])) - _e506) * _e510);
                                                                let _e1780 = select(_e1778, _e1777, (_e1777 < _e1778));
                                                                let _e1782 = select(_e1778, _e1777, (_e1777 > _e1778));
                                                                let _e1784 = select(_e1770, _e1769, (_e1769 < _e1770));
                                                                let _e1786 = select(_e1774, _e1773, (_e1773 < _e1774));
                                                                let _e1788 = select(_e1786, _e1784, (_e1784 > _e1786));
                                                                let _e1790 = select(_e1780, _e1788, (_e1788 > _e1780));
                                                                let _e1792 = select(_e1770, _e1769, (_e1769 > _e1770));
                                                                let _e1794 = select(_e1774, _e1773, (_e1773 > _e1774));
                                                                let _e1796 = select(_e1794, _e1792, (_e1792 < _e1794));
                                                                let _e1798 = select(_e1782, _e1796, (_e1796 < _e1782));
                                                                let _e1799 = -(_e1780);
                                                                let _e1805 = select(_e622, _e1790, (_e1790 > _e622));
                                                                if (_e1805 > (_e1798 + (select(_e1799, _e1782, (_e1782 > _e1799)) * 0.0000019073523f))) {
                                                                    phi_2938_ = type_20();
                                                                    phi_2939_ = true;
                                                                } else {
                                                                    let _e1807 = (_e1805 > _e1198.member_1);
                                                                    if _e1807 {
                                                                        phi_2937_ = type_20();
                                                                    } else {
                                                                        let _e1808 = vec3<f32>(_e1645[0][0], _e1645[0][1], _e1645[0][2]);
                                                                        let _e1809 = vec3<f32>(_e1645[1][0], _e1645[1][1], _e1645[1][2]);
                                                                        let _e1810 = vec3<f32>(_e1645[2][0], _e1645[2][1], _e1645[2][2]);
                                                                        let _e1811 = (_e1645[1][0] - _e1645[0][0]);
                                                                        let _e1812 = (_e1645[1][1] - _e1645[0][1]);
                                                                        let _e1813 = (_e1645[1][2] - _e1645[0][2]);
                                                                        let _e1814 = vec3<f32>(_e1811, _e1812, _e1813);
                                                                        let _e1815 = (_e1645[2][0] - _e1645[1][0]);
                                                                        let _e1816 = (_e1645[2][1] - _e1645[1][1]);
                                                                        let _e1817 = (_e1645[2][2] - _e1645[1][2]);
                                                                        let _e1818 = vec3<f32>(_e1815, _e1816, _e1817);
                                                                        let _e1819 = (_e1645[0][0] - _e1645[2][0]);
                                                                        let _e1820 = (_e1645[0][1] - _e1645[2][1]);
                                                                        let _e1821 = (_e1645[0][2] - _e1645[2][2]);
                                                                        let _e1822 = vec3<f32>(_e1819, _e1820, _e1821);
                                                                        let _e1825 = bitcast<f32>((bitcast<u32>(_e1811) & 2147483647u));
                                                                        let _e1828 = bitcast<f32>((bitcast<u32>(_e1812) & 2147483647u));
                                                                        let _e1830 = select(_e1828, _e1825, (_e1825 > _e1828));
                                                                        let _e1833 = bitcast<f32>((bitcast<u32>(_e1813) & 2147483647u));
                                                                        let _e1835 = select(_e1833, _e1830, (_e1830 > _e1833));
                                                                        let _e1838 = bitcast<f32>((bitcast<u32>(_e1815) & 2147483647u));
                                                                        let _e1841 = bitcast<f32>((bitcast<u32>(_e1816) & 2147483647u));
                                                                        let _e1843 = select(_e1841, _e1838, (_e1838 > _e1841));
                                                                        let _e1846 = bitcast<f32>((bitcast<u32>(_e1817) & 2147483647u));
                                                                        let _e1848 = select(_e1846, _e1843, (_e1843 > _e1846));
                                                                        let _e1851 = bitcast<f32>((bitcast<u32>(_e1819) & 2147483647u));
                                                                        let _e1854 = bitcast<f32>((bitcast<u32>(_e1820) & 2147483647u));
                                                                        let _e1856 = select(_e1854, _e1851, (_e1851 > _e1854));
                                                                        let _e1859 = bitcast<f32>((bitcast<u32>(_e1821) & 2147483647u));
                                                                        let _e1861 = select(_e1859, _e1856, (_e1856 > _e1859));
                                                                        let _e1863 = select(_e1848, _e1835, (_e1835 > _e1848));
                                                                        let _e1865 = select(_e1861, _e1863, (_e1863 > _e1861));
                                                                        if (_e1835 == _e1865) {
                                                                            phi_2664_ = _e1672;
                                                                            phi_2665_ = _e1669;
                                                                            phi_2666_ = _e1659;
                                                                            phi_2667_ = _e1656;
                                                                            phi_2668_ = _e1808;
                                                                            phi_2669_ = _e1822;
                                                                            phi_2670_ = _e1818;
                                                                            phi_2671_ = _e1814;
                                                                        } else {
                                                                            let _e1867 = (_e1848 == _e1865);
                                                                            let _e1872 = vec3(_e1867);
                                                                            phi_2664_ = select(_e1659, _e1685, _e1867);
                                                                            phi_2665_ = select(_e1656, _e1682, _e1867);
                                                                            phi_2666_ = select(_e1685, _e1672, _e1867);
                                                                            phi_2667_ = select(_e1682, _e1669, _e1867);
                                                                            phi_2668_ = select(_e1810, _e1809, _e1872);
                                                                            phi_2669_ = select(_e1818, _e1814, _e1872);
                                                                            phi_2670_ = select(_e1814, _e1822, _e1872);
                                                                            phi_2671_ = select(_e1822, _e1818, _e1872);
                                                                        }
                                                                        let _e1878 = phi_2664_;
                                                                        let _e1880 = phi_2665_;
                                                                        let _e1882 = phi_2666_;
                                                                        let _e1884 = phi_2667_;
                                                                        let _e1886 = phi_2668_;
                                                                        let _e1888 = phi_2669_;
                                                                        let _e1890 = phi_2670_;
                                                                        let _e1892 = phi_2671_;
                                                                        let _e1899 = ((_e1890.y * _e1888.z) - (_e1888.y * _e1890.z));
                                                                        let _e1904 = ((_e1890.z * _e1888.x) - (_e1888.z * _e1890.x));
                                                                        let _e1907 = ((_e1890.x * _e1888.y) - (_e1888.x * _e1890.y));
                                                                        if (_e1707 >= _e1711) {
                                                                            phi_2708_ = select(true, false, (_e1707 >= _e1715));
                                                                        } else {
                                                                            phi_2708_ = true;
                                                                        }
                                                                        let _e1912 = phi_2708_;
                                                                        if _e1912 {
                                                                            phi_2717_ = select(_e1810, _e1809, vec3((_e1711 >= _e1715)));
                                                                        } else {
                                                                            phi_2717_ = _e1808;
                                                                        }
                                                                        let _e1917 = phi_2717_;
                                                                        let _e1928 = (((_e1899 * (_e1917.x - _e331)) + (_e1904 * (_e1917.y - _e400))) + (_e1907 * (_e1917.z - _e468)));
                                                                        let _e1933 = (((_e1899 * _e371) + (_e1904 * _e439)) + (_e1907 * _e507));
                                                                        let _e1934 = (_e1880 - _e1884);
                                                                        let _e1935 = (_e1878 - _e1882);
                                                                        let _e1943 = (-(((_e1884 * _e1934) + (_e1882 * _e1935))) / ((_e1934 * _e1934) + (_e1935 * _e1935)));
                                                                        let _e1945 = select(1f, _e1943, (_e1943 < 1f));
                                                                        let _e1947 = select(0f, _e1945, (_e1945 > 0f));
                                                                        let _e1960 = ((_e1886.x + (_e1892.x * _e1947)) - _e331);
                                                                        let _e1961 = ((_e1886.y + (_e1892.y * _e1947)) - _e400);
                                                                        let _e1962 = ((_e1886.z + (_e1892.z * _e1947)) - _e468);
                                                                        let _e1963 = (_e1962 / _e507);
                                                                        let _e1975 = bitcast<f32>((bitcast<u32>(_e1960) & 2147483647u));
                                                                        let _e1978 = bitcast<f32>((bitcast<u32>(_e1961) & 2147483647u));
                                                                        let _e1980 = select(_e1978, _e1975, (_e1975 > _e1978));
                                                                        let _e1983 = bitcast<f32>((bitcast<u32>(_e1962) & 2147483647u));
                                                                        let _e1985 = select(_e1983, _e1980, (_e1980 > _e1983));
                                                                        let _e1991 = bitcast<f32>((bitcast<u32>(_e1899) & 2147483647u));
                                                                        let _e1994 = bitcast<f32>((bitcast<u32>(_e1904) & 2147483647u));
                                                                        let _e1996 = select(_e1994, _e1991, (_e1991 > _e1994));
                                                                        let _e1999 = bitcast<f32>((bitcast<u32>(_e1907) & 2147483647u));
                                                                        if (bitcast<f32>((bitcast<u32>(((((_e1899 * _e1960) + (_e1904 * _e1961)) + (_e1907 * _e1962)) - _e1928)) & 2147483647u)) <= ((0.0000009536743f * select(_e1865, _e1985, (_e1985 > _e1865))) * select(_e1999, _e1996, (_e1996 > _e1999)))) {
                                                                            let _e2009 = bitcast<f32>((bitcast<u32>(_e1890.x) & 2147483647u));
                                                                            let _e2012 = bitcast<f32>((bitcast<u32>(_e1890.y) & 2147483647u));
                                                                            let _e2014 = select(_e2012, _e2009, (_e2009 > _e2012));
                                                                            let _e2017 = bitcast<f32>((bitcast<u32>(_e1890.z) & 2147483647u));
                                                                            let _e2023 = bitcast<f32>((bitcast<u32>(_e1888.x) & 2147483647u));
                                                                            let _e2026 = bitcast<f32>((bitcast<u32>(_e1888.y) & 2147483647u));
                                                                            let _e2028 = select(_e2026, _e2023, (_e2023 > _e2026));
                                                                            let _e2031 = bitcast<f32>((bitcast<u32>(_e1888.z) & 2147483647u));
                                                                            let _e2035 = (bitcast<f32>((bitcast<u32>(_e1933) & 2147483647u)) > ((0.0000038146973f * select(_e2017, _e2014, (_e2014 > _e2017))) * select(_e2031, _e2028, (_e2028 > _e2031))));
                                                                            if _e2035 {
                                                                                phi_2882_ = (_e1928 / _e1933);
                                                                            } else {
                                                                                phi_2882_ = f32();
                                                                            }
                                                                            let _e2038 = phi_2882_;
                                                                            phi_2884_ = _e2038;
                                                                            phi_2885_ = select(true, false, _e2035);
                                                                        } else {
                                                                            phi_2884_ = f32();
                                                                            phi_2885_ = true;
                                                                        }
                                                                        let _e2041 = phi_2884_;
                                                                        let _e2043 = phi_2885_;
                                                                        if _e2043 {
                                                                            let _e2051 = (((_e1899 * (_e1960 - (_e371 * _e1963))) + (_e1904 * (_e1961 - (_e439 * _e1963)))) / _e1933);
                                                                            if (bitcast<f32>((bitcast<u32>(_e2051) & 2147483647u)) <= _e1865) {
                                                                                phi_2905_ = (_e1963 + _e2051);
                                                                            } else {
                                                                                phi_2905_ = _e1963;
                                                                            }
                                                                            let _e2058 = phi_2905_;
                                                                            phi_2906_ = _e2058;
                                                                        } else {
                                                                            phi_2906_ = _e2041;
                                                                        }
                                                                        let _e2060 = phi_2906_;
                                                                        let _e2062 = select(_e1798, _e2060, (_e2060 < _e1798));
                                                                        let _e2064 = select(_e1790, _e2062, (_e2062 > _e1790));
                                                                        if (_e2064 >= _e622) {
                                                                            let _e2066 = (_e2064 <= _e1198.member_1);
                                                                            if _e2066 {
                                                                                let _e2067 = (1f / _e1717);
                                                                                phi_2929_ = type_20(_e2064, (_e1711 * _e2067), (_e1715 * _e2067), _e1258);
                                                                            } else {
                                                                                phi_2929_ = type_20();
                                                                            }
                                                                            let _e2072 = phi_2929_;
                                                                            phi_2931_ = _e2072;
                                                                            phi_2932_ = select(true, false, _e2066);
                                                                        } else {
                                                                            phi_2931_ = type_20();
                                                                            phi_2932_ = true;
                                                                        }
                                                                        let _e2075 = phi_2931_;
                                                                        let _e2077 = phi_2932_;
                                                                        if _e2077 {
                                                                            phi_2936_ = type_20(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                        } else {
                                                                            phi_2936_ = _e2075;
                                                                        }
                                                                        let _e2079 = phi_2936_;
                                                                        phi_2937_ = _e2079;
                                                                    }
                                                                    let _e2081 = phi_2937_;
                                                                    phi_2938_ = _e2081;
                                                                    phi_2939_ = _e1807;
                                                                }
                                                                let _e2083 = phi_2938_;
                                                                let _e2085 = phi_2939_;
                                                                phi_2943_ = _e2083;
                                                                phi_2944_ = _e2085;
                                                            }
                                                            let _e2087 = phi_2943_;
                                                            let _e2089 = phi_2944_;
                                                            phi_2945_ = _e2087;
                                                            phi_2946_ = _e1742;
                                                            phi_2947_ = _e2089;
                                                        }
                                                        let _e2091 = phi_2945_;
                                                        let _e2093 = phi_2946_;
                                                        let _e2095 = phi_2947_;
                                                        phi_2948_ = _e2091;
                                                        phi_2949_ = _e2093;
                                                        phi_2950_ = _e2095;
                                                    }
                                                    let _e2097 = phi_2948_;
                                                    let _e2099 = phi_2949_;
                                                    let _e2101 = phi_2950_;
                                                    phi_2958_ = _e2097;
                                                    phi_2959_ = select(_e2101, true, _e2099);
                                                } else {
                                                    phi_2958_ = type_20();
                                                    phi_2959_ = true;
                                                }
                                                let _e2104 = phi_2958_;
                                                let _e2106 = phi_2959_;
                                                if _e2106 {
                                                    phi_2963_ = type_20(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                } else {
                                                    phi_2963_ = _e2104;
                                                }
                                                let _e2108 = phi_2963_;
                                                if (_e2108.member_3 != 4294967295u) {
                                                    if (_e1258 != 4294967295u) {
                                                        if (_e2108.member < _e1198.member.member) {
                                                            phi_2989_ = true;
                                                        } else {
                                                            if (_e2108.member == _e1198.member.member) {
                                                                phi_2988_ = (_e2108.member_3 < _e1198.member.member_3);
                                                            } else {
                                                                phi_2988_ = false;
                                                            }
                                                            let _e2121 = phi_2988_;
                                                            phi_2989_ = _e2121;
                                                        }
                                                        let _e2123 = phi_2989_;
                                                        if _e2123 {
                                                            phi_2995_ = type_33(_e2108, _e2108.member);
                                                        } else {
                                                            phi_2995_ = _e1198;
                                                        }
                                                        let _e2126 = phi_2995_;
                                                        phi_2996_ = _e2126;
                                                    } else {
                                                        phi_2996_ = _e1198;
                                                    }
                                                    let _e2128 = phi_2996_;
                                                    phi_2997_ = _e2128;
                                                } else {
                                                    phi_2997_ = _e1198;
                                                }
                                                let _e2130 = phi_2997_;
                                                phi_1301_ = _e2130;
                                            } else {
                                                phi_1301_ = type_33();
                                            }
                                            let _e2132 = phi_1301_;
                                            continue;
                                            continuing {
                                                phi_1300_ = _e2132;
                                                phi_1303_ = _e1213;
                                                phi_4638_ = _e664;
                                                break if !(_e1219);
                                            }
                                        }
                                        let _e2135 = phi_4638_;
                                        phi_4845_ = _e2135;
                                        if _e2135 {
                                            break;
                                        }
                                        phi_4849_ = _e2135;
                                        let _e2462 = local_11;
                                        phi_4268_ = _e2462;
                                        phi_4269_ = false;
                                        phi_4270_ = _e707;
                                        phi_4271_ = _e709;
                                    } else {
                                        if (_e709.member_1 >= _e96) {
                                            phi_3803_ = type_50(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), type_49(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u), type_49(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u));
                                        } else {
                                            if (_e709.member_1 < _e96) {
                                            } else {
                                                phi_4845_ = true;
                                                break;
                                            }
                                            let _e721 = (_e267 * 2u);
                                            let _e723 = ((1u + _e721) % 7u);
                                            if (_e723 < 7u) {
                                            } else {
                                                phi_4845_ = true;
                                                break;
                                            }
                                            let _e728 = global_4.member[_e709.member_1][_e723];
                                            let _e730 = ((_e721 + 2u) % 7u);
                                            if (_e730 < 7u) {
                                            } else {
                                                phi_4845_ = true;
                                                break;
                                            }
                                            let _e735 = global_4.member[_e709.member_1][_e730];
                                            let _e736 = (_e266 * 2u);
                                            let _e738 = ((1u + _e736) % 7u);
                                            if (_e738 < 7u) {
                                            } else {
                                                phi_4845_ = true;
                                                break;
                                            }
                                            let _e743 = global_4.member[_e709.member_1][_e738];
                                            let _e745 = ((_e736 + 2u) % 7u);
                                            if (_e745 < 7u) {
                                            } else {
                                                phi_4845_ = true;
                                                break;
                                            }
                                            let _e750 = global_4.member[_e709.member_1][_e745];
                                            let _e751 = (_e268 * 2u);
                                            let _e753 = ((1u + _e751) % 7u);
                                            if (_e753 < 7u) {
                                            } else {
                                                phi_4845_ = true;
                                                break;
                                            }
                                            let _e758 = global_4.member[_e709.member_1][_e753];
                                            let _e760 = ((_e751 + 2u) % 7u);
                                            if (_e760 < 7u) {
                                            } else {
                                                phi_4845_ = true;
                                                break;
                                            }
                                            let _e765 = global_4.member[_e709.member_1][_e760];
                                            let _e788 = (bitcast<f32>((bitcast<u32>((_e709.member.member_1.x - _e709.member.member.x)) & 2139095040u)) * 0.0000009536743f);
                                            let _e789 = (bitcast<f32>((bitcast<u32>((_e709.member.member_1.y - _e709.member.member.y)) & 2139095040u)) * 0.0000009536743f);
                                            let _e790 = (bitcast<f32>((bitcast<u32>((_e709.member.member_1.z - _e709.member.member.z)) & 2139095040u)) * 0.0000009536743f);
                                            let _e792 = select(_e147, _e788, (_e788 > _e147));
                                            let _e794 = select(_e147, _e789, (_e789 > _e147));
                                            let _e796 = select(_e147, _e790, (_e790 > _e147));
                                            let _e827 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e728 & 2097151u))) - 8388608f) * _e792));
                                            let _e832 = (bitcast<i32>((_e728 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e835 = bitcast<f32>((_e827 & bitcast<u32>(_e832)));
                                            let _e836 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e743 & 2097151u))) - 8388608f) * _e794));
                                            let _e841 = (bitcast<i32>((_e743 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e844 = bitcast<f32>((_e836 & bitcast<u32>(_e841)));
                                            let _e845 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e758 & 2097151u))) - 8388608f) * _e796));
                                            let _e850 = (bitcast<i32>((_e758 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e853 = bitcast<f32>((_e845 & bitcast<u32>(_e850)));
                                            let _e857 = bitcast<f32>((_e827 & bitcast<u32>(~(_e832))));
                                            let _e861 = bitcast<f32>((_e836 & bitcast<u32>(~(_e841))));
                                            let _e865 = bitcast<f32>((_e845 & bitcast<u32>(~(_e850))));
                                            let _e866 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e735 & 2097151u))) - 8388608f) * _e792));
                                            let _e871 = (bitcast<i32>((_e735 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e874 = bitcast<f32>((_e866 & bitcast<u32>(_e871)));
                                            let _e875 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e750 & 2097151u))) - 8388608f) * _e794));
                                            let _e880 = (bitcast<i32>((_e750 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e883 = bitcast<f32>((_e875 & bitcast<u32>(_e880)));
                                            let _e884 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e765 & 2097151u))) - 8388608f) * _e796));
                                            let _e889 = (bitcast<i32>((_e765 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e892 = bitcast<f32>((_e884 & bitcast<u32>(_e889)));
                                            let _e896 = bitcast<f32>((_e866 & bitcast<u32>(~(_e871))));
                                            let _e900 = bitcast<f32>((_e875 & bitcast<u32>(~(_e880))));
                                            let _e904 = bitcast<f32>((_e884 & bitcast<u32>(~(_e889))));
                                            let _e905 = (_e709.member.member.x + _e835);
                                            let _e906 = (_e709.member.member.y + _e844);
                                            let _e907 = (_e709.member.member.z + _e853);
                                            let _e910 = (_e709.member.member_1.x - _e874);
                                            let _e911 = (_e709.member.member_1.y - _e883);
                                            let _e912 = (_e709.member.member_1.z - _e892);
                                            let _e931 = (_e910 - _e905);
                                            let _e932 = (_e911 - _e906);
                                            let _e933 = (_e912 - _e907);
                                            let _e935 = select(_e932, _e931, (_e931 > _e932));
                                            let _e937 = select(_e933, _e935, (_e935 > _e933));
                                            if (_e937 < (1024f * _e147)) {
                                                phi_3504_ = 0u;
                                            } else {
                                                phi_3504_ = select(2u, 1u, (_e937 < (2097152f * _e147)));
                                            }
                                            let _e944 = phi_3504_;
                                            switch bitcast<i32>(_e944) {
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
                                            let _e947 = phi_3510_;
                                            let _e953 = global_4.member[_e709.member_1][0u];
                                            let _e957 = global_4.member[_e709.member_1][2u];
                                            let _e961 = global_4.member[_e709.member_1][4u];
                                            let _e965 = global_4.member[_e709.member_1][6u];
                                            let _e977 = (((_e957 >> bitcast<u32>(22i)) | ((_e961 >> bitcast<u32>(22i)) << bitcast<u32>(10i))) | ((_e965 >> bitcast<u32>(22i)) << bitcast<u32>(20i)));
                                            let _e978 = (_e953 & 268435455u);
                                            let _e979 = (_e977 & 268435455u);
                                            let _e982 = ((_e953 >> bitcast<u32>(28u)) & 7u);
                                            let _e990 = ((_e953 >> bitcast<u32>(31i)) | (((_e977 >> bitcast<u32>(28u)) & 3u) << bitcast<u32>(1i)));
                                            let _e991 = (_e982 != 0u);
                                            if (_e982 == 0u) {
                                                phi_3765_ = _e978;
                                            } else {
                                                if (_e982 == 7u) {
                                                    phi_3764_ = 2147483648u;
                                                } else {
                                                    phi_3764_ = ((2147483648u | (_e982 << bitcast<u32>(28u))) | (_e979 & 268435455u));
                                                }
                                                let _e1000 = phi_3764_;
                                                phi_3765_ = _e1000;
                                            }
                                            let _e1002 = phi_3765_;
                                            if _e991 {
                                                let _e1003 = (_e982 != 7u);
                                                if _e1003 {
                                                    phi_3775_ = (_e979 + (_e982 * ((3u * _e947) + 1u)));
                                                } else {
                                                    phi_3775_ = u32();
                                                }
                                                let _e1007 = phi_3775_;
                                                phi_3777_ = _e1007;
                                                phi_3778_ = select(true, false, _e1003);
                                            } else {
                                                phi_3777_ = u32();
                                                phi_3778_ = true;
                                            }
                                            let _e1010 = phi_3777_;
                                            let _e1012 = phi_3778_;
                                            if (_e990 == 0u) {
                                                phi_3799_ = (_e978 + select(0u, 1u, !(_e991)));
                                            } else {
                                                if (_e990 == 7u) {
                                                    phi_3798_ = 2147483648u;
                                                } else {
                                                    phi_3798_ = ((2147483648u | (_e990 << bitcast<u32>(28u))) | (select(_e1010, _e979, _e1012) & 268435455u));
                                                }
                                                let _e1025 = phi_3798_;
                                                phi_3799_ = _e1025;
                                            }
                                            let _e1027 = phi_3799_;
                                            phi_3803_ = type_50(array<vec4<f32>, 3>(vec4<f32>(_e905, (_e709.member.member.x + _e857), _e910, (_e709.member.member_1.x - _e896)), vec4<f32>(_e906, (_e709.member.member.y + _e861), _e911, (_e709.member.member_1.y - _e900)), vec4<f32>(_e907, (_e709.member.member.z + _e865), _e912, (_e709.member.member_1.z - _e904))), type_49(type_28((_e709.member.member + vec4<f32>(_e835, _e844, _e853, 0f)), (_e709.member.member_1 - vec4<f32>(_e874, _e883, _e892, 0f))), _e1002), type_49(type_28((_e709.member.member + vec4<f32>(_e857, _e861, _e865, 0f)), (_e709.member.member_1 - vec4<f32>(_e896, _e900, _e904, 0f))), _e1027));
                                        }
                                        let _e1032 = phi_3803_;
                                        let _e1044 = ((_e1032.member[0].x - _e369) * _e374);
                                        let _e1045 = ((_e1032.member[0].y - _e369) * _e374);
                                        let _e1046 = ((_e1032.member[0].z - _e370) * _e374);
                                        let _e1047 = ((_e1032.member[0].w - _e370) * _e374);
                                        let _e1057 = ((_e1032.member[1].x - _e437) * _e442);
                                        let _e1058 = ((_e1032.member[1].y - _e437) * _e442);
                                        let _e1059 = ((_e1032.member[1].z - _e438) * _e442);
                                        let _e1060 = ((_e1032.member[1].w - _e438) * _e442);
                                        let _e1070 = ((_e1032.member[2].x - _e505) * _e510);
                                        let _e1071 = ((_e1032.member[2].y - _e505) * _e510);
                                        let _e1072 = ((_e1032.member[2].z - _e506) * _e510);
                                        let _e1073 = ((_e1032.member[2].w - _e506) * _e510);
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
                                        let _e1125 = select(_e622, _e1095, (_e1095 > _e622));
                                        let _e1127 = select(_e622, _e1097, (_e1097 > _e622));
                                        let _e1132 = (_e1125 <= select(_e666.member_1, _e1122, (_e1122 < _e666.member_1)));
                                        let _e1133 = (_e1127 <= select(_e666.member_1, _e1123, (_e1123 < _e666.member_1)));
                                        let _e1134 = (_e1125 <= _e1127);
                                        if _e1132 {
                                            if _e1133 {
                                                if _e1134 {
                                                    phi_4165_ = _e1032.member_2;
                                                } else {
                                                    phi_4165_ = _e1032.member_1;
                                                }
                                                let _e1138 = phi_4165_;
                                                let _e1160 = (_e707 % 128u);
                                                let _e1161 = (_e1160 < 128u);
                                                if _e1161 {
                                                } else {
                                                    phi_4845_ = true;
                                                    break;
                                                }
                                                local_8[_e1160] = _e1138.member_1;
                                                if _e1161 {
                                                } else {
                                                    phi_4845_ = true;
                                                    break;
                                                }
                                                local_7[_e1160] = _e1138.member.member.x;
                                                if _e1161 {
                                                } else {
                                                    phi_4845_ = true;
                                                    break;
                                                }
                                                local_6[_e1160] = _e1138.member.member.y;
                                                if _e1161 {
                                                } else {
                                                    phi_4845_ = true;
                                                    break;
                                                }
                                                local_5[_e1160] = _e1138.member.member.z;
                                                if _e1161 {
                                                } else {
                                                    phi_4845_ = true;
                                                    break;
                                                }
                                                local_4[_e1160] = _e1138.member.member_1.x;
                                                if _e1161 {
                                                } else {
                                                    phi_4845_ = true;
                                                    break;
                                                }
                                                local_3[_e1160] = _e1138.member.member_1.y;
                                                if _e1161 {
                                                } else {
                                                    phi_4845_ = true;
                                                    break;
                                                }
                                                local_2[_e1160] = _e1138.member.member_1.z;
                                                if _e1161 {
                                                } else {
                                                    phi_4845_ = true;
                                                    break;
                                                }
                                                local_9[_e1160] = select(_e1127, _e1125, !(_e1134));
                                                if _e1134 {
                                                    phi_4242_ = _e1032.member_1;
                                                } else {
                                                    phi_4242_ = _e1032.member_2;
                                                }
                                                let _e1174 = phi_4242_;
                                                phi_4243_ = (_e707 + 1u);
                                                phi_4244_ = _e1174;
                                            } else {
                                                phi_4243_ = u32();
                                                phi_4244_ = type_49();
                                            }
                                            let _e1176 = phi_4243_;
                                            let _e1178 = phi_4244_;
                                            phi_4246_ = _e1176;
                                            phi_4247_ = _e1178;
                                            phi_4248_ = select(true, false, _e1133);
                                        } else {
                                            phi_4246_ = u32();
                                            phi_4247_ = type_49();
                                            phi_4248_ = true;
                                        }
                                        let _e1181 = phi_4246_;
                                        let _e1183 = phi_4247_;
                                        let _e1185 = phi_4248_;
                                        if _e1185 {
                                            if _e1132 {
                                                phi_4257_ = _e1032.member_1;
                                            } else {
                                                phi_4257_ = _e1032.member_2;
                                            }
                                            let _e1189 = phi_4257_;
                                            phi_4262_ = select(_e1133, true, _e1132);
                                            phi_4264_ = _e1189;
                                        } else {
                                            phi_4262_ = _e705;
                                            phi_4264_ = _e1183;
                                        }
                                        let _e1192 = phi_4262_;
                                        let _e1194 = phi_4264_;
                                        phi_4849_ = _e664;
                                        phi_4268_ = _e666;
                                        phi_4269_ = _e1192;
                                        phi_4270_ = select(_e1181, _e707, _e1185);
                                        phi_4271_ = _e1194;
                                    }
                                    let _e2137 = phi_4849_;
                                    let _e2139 = phi_4268_;
                                    let _e2141 = phi_4269_;
                                    let _e2143 = phi_4270_;
                                    let _e2145 = phi_4271_;
                                    phi_4848_ = _e2137;
                                    phi_4272_ = _e2139;
                                    phi_4273_ = _e2141;
                                    phi_4274_ = (_e670 - 1u);
                                    phi_4275_ = _e2143;
                                    phi_4276_ = _e2145;
                                } else {
                                    phi_4848_ = _e664;
                                    phi_4272_ = _e666;
                                    phi_4273_ = _e705;
                                    phi_4274_ = _e670;
                                    phi_4275_ = _e707;
                                    phi_4276_ = _e709;
                                }
                                let _e2147 = phi_4848_;
                                let _e2149 = phi_4272_;
                                let _e2151 = phi_4273_;
                                let _e2153 = phi_4274_;
                                let _e2155 = phi_4275_;
                                let _e2157 = phi_4276_;
                                phi_4847_ = _e2147;
                                phi_4277_ = _e2149;
                                phi_4278_ = _e2151;
                                phi_4279_ = _e2153;
                                phi_4280_ = _e2155;
                                phi_4281_ = _e2157;
                            } else {
                                phi_4847_ = _e664;
                                phi_4277_ = type_33();
                                phi_4278_ = bool();
                                phi_4279_ = u32();
                                phi_4280_ = u32();
                                phi_4281_ = type_49();
                            }
                            let _e2159 = phi_4847_;
                            let _e2161 = phi_4277_;
                            let _e2163 = phi_4278_;
                            let _e2165 = phi_4279_;
                            let _e2167 = phi_4280_;
                            let _e2169 = phi_4281_;
                            phi_4846_ = _e2159;
                            phi_1174_ = _e2161;
                            phi_1177_ = _e2163;
                            phi_1179_ = _e2165;
                            phi_1181_ = _e2167;
                            phi_1183_ = _e2169;
                            phi_4282_ = _e678;
                        } else {
                            phi_4846_ = _e664;
                            phi_1174_ = type_33();
                            phi_1177_ = bool();
                            phi_1179_ = u32();
                            phi_1181_ = u32();
                            phi_1183_ = type_49();
                            phi_4282_ = false;
                        }
                        let _e2171 = phi_4846_;
                        let _e2173 = phi_1174_;
                        let _e2175 = phi_1177_;
                        let _e2177 = phi_1179_;
                        let _e2179 = phi_1181_;
                        let _e2181 = phi_1183_;
                        let _e2183 = phi_4282_;
                        continue;
                        continuing {
                            phi_4644_ = _e2171;
                            phi_1173_ = _e2173;
                            phi_1176_ = _e2175;
                            phi_1178_ = _e2177;
                            phi_1180_ = _e2179;
                            phi_1182_ = _e2181;
                            phi_4845_ = _e2171;
                            break if !(_e2183);
                        }
                    }
                    let _e2186 = phi_4845_;
                    if _e2186 {
                        break;
                    }
                    let _e2188 = local_10;
                    if (_e2188.member.member_3 != 4294967295u) {
                        let _e2193 = -(_e524);
                        let _e2194 = bitcast<u32>(_e2188.member.member);
                        let _e2198 = (bitcast<i32>((_e2194 >> bitcast<u32>(23i))) & 255i);
                        let _e2199 = (_e2198 + _e2193);
                        if (_e2198 == 255i) {
                            phi_4341_ = _e2188.member.member;
                        } else {
                            if (_e2198 > 0i) {
                                if (_e2199 > 0i) {
                                    let _e2203 = (_e2199 < 255i);
                                    if _e2203 {
                                        phi_4320_ = bitcast<f32>((_e2194 + bitcast<u32>((_e2193 << bitcast<u32>(23i)))));
                                    } else {
                                        phi_4320_ = f32();
                                    }
                                    let _e2210 = phi_4320_;
                                    phi_4322_ = _e2210;
                                    phi_4323_ = select(true, false, _e2203);
                                } else {
                                    phi_4322_ = f32();
                                    phi_4323_ = true;
                                }
                                let _e2213 = phi_4322_;
                                let _e2215 = phi_4323_;
                                phi_4324_ = _e2213;
                                phi_4325_ = _e2215;
                            } else {
                                phi_4324_ = f32();
                                phi_4325_ = true;
                            }
                            let _e2217 = phi_4324_;
                            let _e2219 = phi_4325_;
                            if _e2219 {
                                let _e2220 = (_e2194 & 2147483648u);
                                let _e2227 = ((_e2194 & 8388607u) | (select(0u, 1u, ((_e2194 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                                let _e2231 = (_e2227 == 0u);
                                if _e2231 {
                                    phi_4596_ = bitcast<f32>(_e2220);
                                } else {
                                    let _e2236 = (select((bitcast<u32>(31i) - firstLeadingBit(_e2227)), 32u, _e2231) - 8u);
                                    let _e2239 = (_e2227 << bitcast<u32>((_e2236 & 31u)));
                                    let _e2241 = ((_e2199 + select(0i, 1i, (_e2198 == 0i))) - bitcast<i32>(_e2236));
                                    if (_e2241 >= 255i) {
                                        phi_4586_ = bitcast<f32>((_e2220 | 2139095040u));
                                        phi_4587_ = f32();
                                        phi_4588_ = true;
                                    } else {
                                        let _e2243 = (_e2241 > 0i);
                                        if _e2243 {
                                            phi_4580_ = bitcast<f32>(((_e2220 | (bitcast<u32>(_e2241) << bitcast<u32>(23i))) | (_e2239 & 8388607u)));
                                            phi_4581_ = f32();
                                        } else {
                                            if (_e2241 < -24i) {
                                                phi_4546_ = 26u;
                                            } else {
                                                phi_4546_ = bitcast<u32>((1i - _e2241));
                                            }
                                            let _e2248 = phi_4546_;
                                            let _e2249 = (_e2248 & 31u);
                                            let _e2251 = (_e2239 >> bitcast<u32>(_e2249));
                                            let _e2255 = (_e2239 & ((1u << bitcast<u32>(_e2249)) - 1u));
                                            let _e2259 = (1u << bitcast<u32>(((_e2248 - 1u) & 31u)));
                                            if (_e2255 > _e2259) {
                                                phi_4567_ = true;
                                            } else {
                                                if (_e2255 == _e2259) {
                                                    phi_4564_ = ((_e2251 & 1u) == 1u);
                                                } else {
                                                    phi_4564_ = false;
                                                }
                                                let _e2265 = phi_4564_;
                                                phi_4567_ = _e2265;
                                            }
                                            let _e2267 = phi_4567_;
                                            phi_4580_ = f32();
                                            phi_4581_ = bitcast<f32>((_e2220 | (_e2251 + select(0u, 1u, _e2267))));
                                        }
                                        let _e2280 = phi_4580_;
                                        let _e2282 = phi_4581_;
                                        phi_4586_ = _e2280;
                                        phi_4587_ = _e2282;
                                        phi_4588_ = _e2243;
                                    }
                                    let _e2286 = phi_4586_;
                                    let _e2288 = phi_4587_;
                                    let _e2290 = phi_4588_;
                                    phi_4596_ = select(_e2288, _e2286, _e2290);
                                }
                                let _e2294 = phi_4596_;
                                phi_4340_ = _e2294;
                            } else {
                                phi_4340_ = _e2217;
                            }
                            let _e2296 = phi_4340_;
                            phi_4341_ = _e2296;
                        }
                        let _e2298 = phi_4341_;
                        let _e2299 = bitcast<u32>(_e2298);
                        if ((_e2299 & 2147483647u) >= 2139095040u) {
                            phi_4353_ = bitcast<f32>(((_e2299 & 2147483648u) | 2139095039u));
                        } else {
                            phi_4353_ = _e2298;
                        }
                        let _e2306 = phi_4353_;
                        phi_4358_ = type_20(_e2306, _e2188.member.member_1, _e2188.member.member_2, _e2188.member.member_3);
                    } else {
                        phi_4358_ = type_20(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                    }
                    let _e2311 = phi_4358_;
                    if _e155 {
                    } else {
                        break;
                    }
                    global_6.member[_e153] = _e2311;
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn trace_closest_q21_lattice(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
