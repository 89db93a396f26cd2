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
    var phi_4648_: bool;
    var phi_1173_: type_33;
    var phi_1176_: u32;
    var phi_1178_: bool;
    var phi_1180_: u32;
    var phi_1182_: type_49;
    var phi_1193_: bool;
    var phi_1279_: bool;
    var phi_1280_: u32;
    var phi_1281_: type_49;
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
    var phi_4642_: bool;
    var phi_4940_: bool;
    var phi_2998_: type_33;
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
    var phi_4276_: type_33;
    var phi_4277_: u32;
    var phi_4278_: bool;
    var phi_4279_: u32;
    var phi_4280_: type_49;
    var phi_4851_: bool;
    var phi_4281_: type_33;
    var phi_4282_: u32;
    var phi_4283_: bool;
    var phi_4284_: u32;
    var phi_4285_: type_49;
    var phi_4850_: bool;
    var phi_1174_: type_33;
    var phi_1177_: u32;
    var phi_1179_: bool;
    var phi_1181_: u32;
    var phi_1183_: type_49;
    var phi_4286_: bool;
    var phi_4849_: bool;
    var local_10: type_33;
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
    var phi_4362_: type_20;
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
                    phi_4648_ = false;
                    phi_1173_ = type_33(type_20(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e620);
                    phi_1176_ = ((3u * _e96) + 1u);
                    phi_1178_ = (_e622 <= _e620);
                    phi_1180_ = 0u;
                    phi_1182_ = type_49(type_28(vec4<f32>((f32(_e629) * _e147), (f32(_e635) * _e147), (f32(_e641) * _e147), 0f), vec4<f32>((f32(_e646) * _e147), (f32(_e650) * _e147), (f32(_e654) * _e147), 0f)), select(0u, 2147483648u, (_e96 == 0u)));
                    loop {
                        let _e664 = phi_4648_;
                        let _e666 = phi_1173_;
                        let _e668 = phi_1176_;
                        let _e670 = phi_1178_;
                        let _e672 = phi_1180_;
                        let _e674 = phi_1182_;
                        local_10 = _e666;
                        if _e670 {
                            phi_1193_ = true;
                        } else {
                            phi_1193_ = (_e672 > 0u);
                        }
                        let _e677 = phi_1193_;
                        if _e677 {
                            let _e678 = (_e668 > 0u);
                            if _e678 {
                                if _e670 {
                                    phi_1279_ = _e670;
                                    phi_1280_ = _e672;
                                    phi_1281_ = _e674;
                                } else {
                                    let _e679 = (_e672 - 1u);
                                    let _e680 = (_e679 % 128u);
                                    let _e681 = (_e680 < 128u);
                                    if _e681 {
                                    } else {
                                        phi_4849_ = true;
                                        break;
                                    }
                                    let _e683 = local_7[_e680];
                                    if _e681 {
                                    } else {
                                        phi_4849_ = true;
                                        break;
                                    }
                                    let _e685 = local_6[_e680];
                                    if _e681 {
                                    } else {
                                        phi_4849_ = true;
                                        break;
                                    }
                                    let _e687 = local_5[_e680];
                                    if _e681 {
                                    } else {
                                        phi_4849_ = true;
                                        break;
                                    }
                                    let _e689 = local_4[_e680];
                                    if _e681 {
                                    } else {
                                        phi_4849_ = true;
                                        break;
                                    }
                                    let _e691 = local_3[_e680];
                                    if _e681 {
                                    } else {
                                        phi_4849_ = true;
                                        break;
                                    }
                                    let _e693 = local_2[_e680];
                                    if _e681 {
                                    } else {
                                        phi_4849_ = true;
                                        break;
                                    }
                                    let _e698 = local_8[_e680];
                                    if _e681 {
                                    } else {
                                        phi_4849_ = true;
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
                                    let _e713 = ((_e709.member_1 & 2147483648u) != 0u);
                                    let _e714 = (_e709.member_1 & 268435455u);
                                    if _e713 {
                                        phi_1300_ = _e666;
                                        phi_1303_ = type_8(0u, ((_e709.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e721 = phi_1300_;
                                            let _e723 = phi_1303_;
                                            local_11 = _e721;
                                            if (_e723.member < _e723.member_1) {
                                                phi_1304_ = type_8((_e723.member + 1u), _e723.member_1);
                                                phi_1326_ = type_8(1u, _e723.member);
                                            } else {
                                                phi_1304_ = _e723;
                                                phi_1326_ = type_8(0u, type_8().member_1);
                                            }
                                            let _e736 = phi_1304_;
                                            let _e738 = phi_1326_;
                                            let _e742 = (bitcast<i32>(_e738.member) != 0i);
                                            if _e742 {
                                                let _e747 = (_e709.member.member_1.x - _e709.member.member.x);
                                                let _e750 = (_e709.member.member_1.y - _e709.member.member.y);
                                                let _e753 = (_e709.member.member_1.z - _e709.member.member.z);
                                                let _e755 = select(_e750, _e747, (_e747 > _e750));
                                                let _e757 = select(_e753, _e755, (_e755 > _e753));
                                                let _e759 = (_e757 < (1024f * _e147));
                                                if _e759 {
                                                    phi_1367_ = 0u;
                                                } else {
                                                    phi_1367_ = select(2u, 1u, (_e757 < (2097152f * _e147)));
                                                }
                                                let _e764 = phi_1367_;
                                                switch bitcast<i32>(_e764) {
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
                                                let _e767 = phi_1373_;
                                                switch bitcast<i32>(_e764) {
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
                                                let _e774 = phi_1383_;
                                                let _e776 = ((_e714 + (_e738.member_1 * ((3u * _e767) + 1u))) + (3u * _e774));
                                                let _e777 = (_e776 < _e99);
                                                if _e777 {
                                                    if _e777 {
                                                    } else {
                                                        phi_4642_ = true;
                                                        break;
                                                    }
                                                    let _e779 = global_5.member[_e776];
                                                    phi_1399_ = _e779;
                                                } else {
                                                    phi_1399_ = 4294967295u;
                                                }
                                                let _e781 = phi_1399_;
                                                if _e759 {
                                                    phi_1432_ = 0u;
                                                } else {
                                                    phi_1432_ = select(2u, 1u, (_e757 < (2097152f * _e147)));
                                                }
                                                let _e786 = phi_1432_;
                                                switch bitcast<i32>(_e786) {
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
                                                let _e789 = phi_1438_;
                                                let _e793 = (_e714 + (_e738.member_1 * ((3u * _e789) + 1u)));
                                                switch bitcast<i32>(_e786) {
                                                    case 0: {
                                                        let _e1068 = (_e793 < _e99);
                                                        if _e1068 {
                                                            if _e1068 {
                                                            } else {
                                                                phi_4642_ = true;
                                                                break;
                                                            }
                                                            let _e1070 = global_5.member[_e793];
                                                            phi_1465_ = _e1070;
                                                        } else {
                                                            phi_1465_ = 0u;
                                                        }
                                                        let _e1072 = phi_1465_;
                                                        let _e1074 = ((10u * _e267) & 31u);
                                                        let _e1084 = ((10u * _e266) & 31u);
                                                        let _e1094 = ((10u * _e268) & 31u);
                                                        let _e1104 = (_e793 + 1u);
                                                        let _e1105 = (_e1104 < _e99);
                                                        if _e1105 {
                                                            if _e1105 {
                                                            } else {
                                                                phi_4642_ = true;
                                                                break;
                                                            }
                                                            let _e1107 = global_5.member[_e1104];
                                                            phi_1514_ = _e1107;
                                                        } else {
                                                            phi_1514_ = 0u;
                                                        }
                                                        let _e1109 = phi_1514_;
                                                        let _e1135 = (_e793 + 2u);
                                                        let _e1136 = (_e1135 < _e99);
                                                        if _e1136 {
                                                            if _e1136 {
                                                            } else {
                                                                phi_4642_ = true;
                                                                break;
                                                            }
                                                            let _e1138 = global_5.member[_e1135];
                                                            phi_1563_ = _e1138;
                                                        } else {
                                                            phi_1563_ = 0u;
                                                        }
                                                        let _e1140 = phi_1563_;
                                                        phi_2064_ = array<array<f32, 3>, 3>(array<f32, 3>((_e709.member.member.x + ((bitcast<f32>((1258291200u | ((_e1072 >> bitcast<u32>(_e1074)) & 1023u))) - 8388608f) * _e147)), (_e709.member.member.y + ((bitcast<f32>((1258291200u | ((_e1072 >> bitcast<u32>(_e1084)) & 1023u))) - 8388608f) * _e147)), (_e709.member.member.z + ((bitcast<f32>((1258291200u | ((_e1072 >> bitcast<u32>(_e1094)) & 1023u))) - 8388608f) * _e147))), array<f32, 3>((_e709.member.member.x + ((bitcast<f32>((1258291200u | ((_e1109 >> bitcast<u32>(_e1074)) & 1023u))) - 8388608f) * _e147)), (_e709.member.member.y + ((bitcast<f32>((1258291200u | ((_e1109 >> bitcast<u32>(_e1084)) & 1023u))) - 8388608f) * _e147)), (_e709.member.member.z + ((bitcast<f32>((1258291200u | ((_e1109 >> bitcast<u32>(_e1094)) & 1023u))) - 8388608f) * _e147))), array<f32, 3>((_e709.member.member.x + ((bitcast<f32>((1258291200u | ((_e1140 >> bitcast<u32>(_e1074)) & 1023u))) - 8388608f) * _e147)), (_e709.member.member.y + ((bitcast<f32>((1258291200u | ((_e1140 >> bitcast<u32>(_e1084)) & 1023u))) - 8388608f) * _e147)), (_e709.member.member.z + ((bitcast<f32>((1258291200u | ((_e1140 >> bitcast<u32>(_e1094)) & 1023u))) - 8388608f) * _e147))));
                                                        break;
                                                    }
                                                    case 1: {
                                                        let _e882 = (_e793 < _e99);
                                                        if _e882 {
                                                            if _e882 {
                                                            } else {
                                                                phi_4642_ = true;
                                                                break;
                                                            }
                                                            let _e884 = global_5.member[_e793];
                                                            phi_1612_ = _e884;
                                                        } else {
                                                            phi_1612_ = 0u;
                                                        }
                                                        let _e886 = phi_1612_;
                                                        let _e887 = (_e793 + 1u);
                                                        let _e888 = (_e887 < _e99);
                                                        if _e888 {
                                                            if _e888 {
                                                            } else {
                                                                phi_4642_ = true;
                                                                break;
                                                            }
                                                            let _e890 = global_5.member[_e887];
                                                            phi_1627_ = _e890;
                                                        } else {
                                                            phi_1627_ = 0u;
                                                        }
                                                        let _e892 = phi_1627_;
                                                        let _e893 = (_e267 == 1u);
                                                        if _e893 {
                                                            phi_1637_ = ((_e886 >> bitcast<u32>(21i)) | (_e892 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1637_ = (_e892 >> bitcast<u32>(10i));
                                                        }
                                                        let _e902 = phi_1637_;
                                                        let _e910 = (_e266 == 1u);
                                                        if _e910 {
                                                            phi_1658_ = ((_e886 >> bitcast<u32>(21i)) | (_e892 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1658_ = (_e892 >> bitcast<u32>(10i));
                                                        }
                                                        let _e919 = phi_1658_;
                                                        let _e927 = (_e268 == 1u);
                                                        if _e927 {
                                                            phi_1679_ = ((_e886 >> bitcast<u32>(21i)) | (_e892 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1679_ = (_e892 >> bitcast<u32>(10i));
                                                        }
                                                        let _e936 = phi_1679_;
                                                        let _e945 = (_e793 + 2u);
                                                        let _e946 = (_e945 < _e99);
                                                        if _e946 {
                                                            if _e946 {
                                                            } else {
                                                                phi_4642_ = true;
                                                                break;
                                                            }
                                                            let _e948 = global_5.member[_e945];
                                                            phi_1709_ = _e948;
                                                        } else {
                                                            phi_1709_ = 0u;
                                                        }
                                                        let _e950 = phi_1709_;
                                                        let _e951 = (_e793 + 3u);
                                                        let _e952 = (_e951 < _e99);
                                                        if _e952 {
                                                            if _e952 {
                                                            } else {
                                                                phi_4642_ = true;
                                                                break;
                                                            }
                                                            let _e954 = global_5.member[_e951];
                                                            phi_1724_ = _e954;
                                                        } else {
                                                            phi_1724_ = 0u;
                                                        }
                                                        let _e956 = phi_1724_;
                                                        if _e893 {
                                                            phi_1734_ = ((_e950 >> bitcast<u32>(21i)) | (_e956 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1734_ = (_e956 >> bitcast<u32>(10i));
                                                        }
                                                        let _e965 = phi_1734_;
                                                        if _e910 {
                                                            phi_1755_ = ((_e950 >> bitcast<u32>(21i)) | (_e956 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1755_ = (_e956 >> bitcast<u32>(10i));
                                                        }
                                                        let _e981 = phi_1755_;
                                                        if _e927 {
                                                            phi_1776_ = ((_e950 >> bitcast<u32>(21i)) | (_e956 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1776_ = (_e956 >> bitcast<u32>(10i));
                                                        }
                                                        let _e997 = phi_1776_;
                                                        let _e1006 = (_e793 + 4u);
                                                        let _e1007 = (_e1006 < _e99);
                                                        if _e1007 {
                                                            if _e1007 {
                                                            } else {
                                                                phi_4642_ = true;
                                                                break;
                                                            }
                                                            let _e1009 = global_5.member[_e1006];
                                                            phi_1806_ = _e1009;
                                                        } else {
                                                            phi_1806_ = 0u;
                                                        }
                                                        let _e1011 = phi_1806_;
                                                        let _e1012 = (_e793 + 5u);
                                                        let _e1013 = (_e1012 < _e99);
                                                        if _e1013 {
                                                            if _e1013 {
                                                            } else {
                                                                phi_4642_ = true;
                                                                break;
                                                            }
                                                            let _e1015 = global_5.member[_e1012];
                                                            phi_1821_ = _e1015;
                                                        } else {
                                                            phi_1821_ = 0u;
                                                        }
                                                        let _e1017 = phi_1821_;
                                                        if _e893 {
                                                            phi_1831_ = ((_e1011 >> bitcast<u32>(21i)) | (_e1017 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1831_ = (_e1017 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1026 = phi_1831_;
                                                        if _e910 {
                                                            phi_1852_ = ((_e1011 >> bitcast<u32>(21i)) | (_e1017 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1852_ = (_e1017 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1042 = phi_1852_;
                                                        if _e927 {
                                                            phi_1873_ = ((_e1011 >> bitcast<u32>(21i)) | (_e1017 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1873_ = (_e1017 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1058 = phi_1873_;
                                                        phi_2064_ = array<array<f32, 3>, 3>(array<f32, 3>((_e709.member.member.x + ((bitcast<f32>((1258291200u | (select(_e902, _e886, _e306) & 2097151u))) - 8388608f) * _e147)), (_e709.member.member.y + ((bitcast<f32>((1258291200u | (select(_e919, _e886, _e375) & 2097151u))) - 8388608f) * _e147)), (_e709.member.member.z + ((bitcast<f32>((1258291200u | (select(_e936, _e886, _e443) & 2097151u))) - 8388608f) * _e147))), array<f32, 3>((_e709.member.member.x + ((bitcast<f32>((1258291200u | (select(_e965, _e950, _e306) & 2097151u))) - 8388608f) * _e147)), (_e709.member.member.y + ((bitcast<f32>((1258291200u | (select(_e981, _e950, _e375) & 2097151u))) - 8388608f) * _e147)), (_e709.member.member.z + ((bitcast<f32>((1258291200u | (select(_e997, _e950, _e443) & 2097151u))) - 8388608f) * _e147))), array<f32, 3>((_e709.member.member.x + ((bitcast<f32>((1258291200u | (select(_e1026, _e1011, _e306) & 2097151u))) - 8388608f) * _e147)), (_e709.member.member.y + ((bitcast<f32>((1258291200u | (select(_e1042, _e1011, _e375) & 2097151u))) - 8388608f) * _e147)), (_e709.member.member.z + ((bitcast<f32>((1258291200u | (select(_e1058, _e1011, _e443) & 2097151u))) - 8388608f) * _e147))));
                                                        break;
                                                    }
                                                    case 2: {
                                                        let _e795 = (_e793 + _e267);
                                                        let _e796 = (_e795 < _e99);
                                                        if _e796 {
                                                            if _e796 {
                                                            } else {
                                                                phi_4642_ = true;
                                                                break;
                                                            }
                                                            let _e798 = global_5.member[_e795];
                                                            phi_1904_ = _e798;
                                                        } else {
                                                            phi_1904_ = 0u;
                                                        }
                                                        let _e800 = phi_1904_;
                                                        let _e804 = (_e793 + _e266);
                                                        let _e805 = (_e804 < _e99);
                                                        if _e805 {
                                                            if _e805 {
                                                            } else {
                                                                phi_4642_ = true;
                                                                break;
                                                            }
                                                            let _e807 = global_5.member[_e804];
                                                            phi_1922_ = _e807;
                                                        } else {
                                                            phi_1922_ = 0u;
                                                        }
                                                        let _e809 = phi_1922_;
                                                        let _e813 = (_e793 + _e268);
                                                        let _e814 = (_e813 < _e99);
                                                        if _e814 {
                                                            if _e814 {
                                                            } else {
                                                                phi_4642_ = true;
                                                                break;
                                                            }
                                                            let _e816 = global_5.member[_e813];
                                                            phi_1940_ = _e816;
                                                        } else {
                                                            phi_1940_ = 0u;
                                                        }
                                                        let _e818 = phi_1940_;
                                                        let _e823 = (_e793 + 3u);
                                                        let _e824 = (_e823 + _e267);
                                                        let _e825 = (_e824 < _e99);
                                                        if _e825 {
                                                            if _e825 {
                                                            } else {
                                                                phi_4642_ = true;
                                                                break;
                                                            }
                                                            let _e827 = global_5.member[_e824];
                                                            phi_1963_ = _e827;
                                                        } else {
                                                            phi_1963_ = 0u;
                                                        }
                                                        let _e829 = phi_1963_;
                                                        let _e833 = (_e823 + _e266);
                                                        let _e834 = (_e833 < _e99);
                                                        if _e834 {
                                                            if _e834 {
                                                            } else {
                                                                phi_4642_ = true;
                                                                break;
                                                            }
                                                            let _e836 = global_5.member[_e833];
                                                            phi_1981_ = _e836;
                                                        } else {
                                                            phi_1981_ = 0u;
                                                        }
                                                        let _e838 = phi_1981_;
                                                        let _e842 = (_e823 + _e268);
                                                        let _e843 = (_e842 < _e99);
                                                        if _e843 {
                                                            if _e843 {
                                                            } else {
                                                                phi_4642_ = true;
                                                                break;
                                                            }
                                                            let _e845 = global_5.member[_e842];
                                                            phi_1999_ = _e845;
                                                        } else {
                                                            phi_1999_ = 0u;
                                                        }
                                                        let _e847 = phi_1999_;
                                                        let _e852 = (_e793 + 6u);
                                                        let _e853 = (_e852 + _e267);
                                                        let _e854 = (_e853 < _e99);
                                                        if _e854 {
                                                            if _e854 {
                                                            } else {
                                                                phi_4642_ = true;
                                                                break;
                                                            }
                                                            let _e856 = global_5.member[_e853];
                                                            phi_2022_ = _e856;
                                                        } else {
                                                            phi_2022_ = 0u;
                                                        }
                                                        let _e858 = phi_2022_;
                                                        let _e862 = (_e852 + _e266);
                                                        let _e863 = (_e862 < _e99);
                                                        if _e863 {
                                                            if _e863 {
                                                            } else {
                                                                phi_4642_ = true;
                                                                break;
                                                            }
                                                            let _e865 = global_5.member[_e862];
                                                            phi_2040_ = _e865;
                                                        } else {
                                                            phi_2040_ = 0u;
                                                        }
                                                        let _e867 = phi_2040_;
                                                        let _e871 = (_e852 + _e268);
                                                        let _e872 = (_e871 < _e99);
                                                        if _e872 {
                                                            if _e872 {
                                                            } else {
                                                                phi_4642_ = true;
                                                                break;
                                                            }
                                                            let _e874 = global_5.member[_e871];
                                                            phi_2058_ = _e874;
                                                        } else {
                                                            phi_2058_ = 0u;
                                                        }
                                                        let _e876 = phi_2058_;
                                                        phi_2064_ = array<array<f32, 3>, 3>(array<f32, 3>((f32(bitcast<i32>(_e800)) * _e147), (f32(bitcast<i32>(_e809)) * _e147), (f32(bitcast<i32>(_e818)) * _e147)), array<f32, 3>((f32(bitcast<i32>(_e829)) * _e147), (f32(bitcast<i32>(_e838)) * _e147), (f32(bitcast<i32>(_e847)) * _e147)), array<f32, 3>((f32(bitcast<i32>(_e858)) * _e147), (f32(bitcast<i32>(_e867)) * _e147), (f32(bitcast<i32>(_e876)) * _e147)));
                                                        break;
                                                    }
                                                    default: {
                                                        phi_2064_ = array<array<f32, 3>, 3>();
                                                        break;
                                                    }
                                                }
                                                let _e1168 = phi_2064_;
                                                let _e1176 = (_e1168[0][2] - _e468);
                                                let _e1179 = (((_e1168[0][0] - _e331) * _e507) - (_e1176 * _e371));
                                                let _e1182 = (((_e1168[0][1] - _e400) * _e507) - (_e1176 * _e439));
                                                let _e1189 = (_e1168[1][2] - _e468);
                                                let _e1192 = (((_e1168[1][0] - _e331) * _e507) - (_e1189 * _e371));
                                                let _e1195 = (((_e1168[1][1] - _e400) * _e507) - (_e1189 * _e439));
                                                let _e1202 = (_e1168[2][2] - _e468);
                                                let _e1205 = (((_e1168[2][0] - _e331) * _e507) - (_e1202 * _e371));
                                                let _e1208 = (((_e1168[2][1] - _e400) * _e507) - (_e1202 * _e439));
                                                let _e1209 = (_e1205 * _e1195);
                                                let _e1210 = (_e1208 * _e1192);
                                                let _e1211 = (_e1179 * _e1208);
                                                let _e1212 = (_e1182 * _e1205);
                                                let _e1213 = (_e1192 * _e1182);
                                                let _e1214 = (_e1195 * _e1179);
                                                let _e1219 = (((_e1209 >= _e1210) && (_e1211 >= _e1212)) && (_e1213 >= _e1214));
                                                if (_e1219 || (((_e1209 <= _e1210) && (_e1211 <= _e1212)) && (_e1213 <= _e1214))) {
                                                    let _e1226 = select(-1f, 1f, _e1219);
                                                    let _e1228 = ((_e1209 - _e1210) * _e1226);
                                                    let _e1230 = select(0f, _e1228, (_e1228 > 0f));
                                                    let _e1232 = ((_e1211 - _e1212) * _e1226);
                                                    let _e1234 = select(0f, _e1232, (_e1232 > 0f));
                                                    let _e1236 = ((_e1213 - _e1214) * _e1226);
                                                    let _e1238 = select(0f, _e1236, (_e1236 > 0f));
                                                    let _e1240 = ((_e1230 + _e1234) + _e1238);
                                                    if (_e1240 < 0.000000000000000000000000000000000000011754944f) {
                                                        phi_2948_ = type_20();
                                                        phi_2949_ = true;
                                                        phi_2950_ = false;
                                                    } else {
                                                        let _e1243 = select(_e1192, _e1179, (_e1179 < _e1192));
                                                        if (select(_e1205, _e1243, (_e1243 < _e1205)) > 0f) {
                                                            phi_2216_ = true;
                                                        } else {
                                                            let _e1248 = select(_e1192, _e1179, (_e1179 > _e1192));
                                                            phi_2216_ = (select(_e1205, _e1248, (_e1248 > _e1205)) < 0f);
                                                        }
                                                        let _e1253 = phi_2216_;
                                                        if _e1253 {
                                                            phi_2945_ = type_20();
                                                            phi_2946_ = true;
                                                            phi_2947_ = false;
                                                        } else {
                                                            let _e1255 = select(_e1195, _e1182, (_e1182 < _e1195));
                                                            if (select(_e1208, _e1255, (_e1255 < _e1208)) > 0f) {
                                                                phi_2245_ = true;
                                                            } else {
                                                                let _e1260 = select(_e1195, _e1182, (_e1182 > _e1195));
                                                                phi_2245_ = (select(_e1208, _e1260, (_e1260 > _e1208)) < 0f);
                                                            }
                                                            let _e1265 = phi_2245_;
                                                            if _e1265 {
                                                                phi_2943_ = type_20();
                                                                phi_2944_ = false;
                                                            } else {
                                                                let _e1267 = select(_e1168[1][0], _e1168[0][0], (_e1168[0][0] < _e1168[1][0]));
                                                                let _e1271 = select(_e1168[1][0], _e1168[0][0], (_e1168[0][0] > _e1168[1][0]));
                                                                let _e1275 = select(_e1168[1][1], _e1168[0][1], (_e1168[0][1] < _e1168[1][1]));
                                                                let _e1279 = select(_e1168[1][1], _e1168[0][1], (_e1168[0][1] > _e1168[1][1]));
                                                                let _e1283 = select(_e1168[1][2], _e1168[0][2], (_e1168[0][2] < _e1168[1][2]));
                                                                let _e1287 = select(_e1168[1][2], _e1168[0][2], (_e1168[0][2] > _e1168[1][2]));
                                                                let _e1292 = ((select(_e1168[2][0], _e1267, (_e1267 < _e1168[2][0])) - _e369) * _e374);
                                                                let _e1293 = ((select(_e1168[2][0], _e1271, (_e1271 > _e1168[2][0])) - _e370) * _e374);
                                                                let _e1296 = ((select(_e1168[2][1], _e1275, (_e1275 < _e1168[2][1])) - _e437) * _e442);
                                                                let _e1297 = ((select(_e1168[2][1], _e1279, (_e1279 > _e1168[2][1])) - _e438) * _e442);
                                                                let _e1300 = ((select(_e1168[2][2], _e1283, (_e1283 < _e1168[2][2])) - _e505) * _e510);
                                                                let _e1301 = ((select(_e1168[2][2], _e1287, (_e1287 > _e1168[2][2])) - _e506) * _e510);
                                                                let _e1303 = select(_e1301, _e1300, (_e1300 < _e1301));
                                                                let _e1305 = select(_e1301, _e1300, (_e1300 > _e1301));
                                                                let _e1307 = select(_e1293, _e1292, (_e1292 < _e1293));
                                                                let _e1309 = select(_e1297, _e1296, (_e1296 < _e1297));
                                                                let _e1311 = select(_e1309, _e1307, (_e1307 > _e1309));
                                                                let _e1313 = select(_e1303, _e1311, (_e1311 > _e1303));
                                                                let _e1315 = select(_e1293, _e1292, (_e1292 > _e1293));
                                                                let _e1317 = select(_e1297, _e1296, (_e1296 > _e1297));
                                                                let _e1319 = select(_e1317, _e1315, (_e1315 < _e1317));
                                                                let _e1321 = select(_e1305, _e1319, (_e1319 < _e1305));
                                                                let _e1322 = -(_e1303);
                                                                let _e1328 = select(_e622, _e1313, (_e1313 > _e622));
                                                                if (_e1328 > (_e1321 + (select(_e1322, _e1305, (_e1305 > _e1322)) * 0.0000019073523f))) {
                                                                    phi_2938_ = type_20();
                                                                    phi_2939_ = true;
                                                                } else {
                                                                    let _e1330 = (_e1328 > _e721.member_1);
                                                                    if _e1330 {
                                                                        phi_2937_ = type_20();
                                                                    } else {
                                                                        let _e1331 = vec3<f32>(_e1168[0][0], _e1168[0][1], _e1168[0][2]);
                                                                        let _e1332 = vec3<f32>(_e1168[1][0], _e1168[1][1], _e1168[1][2]);
                                                                        let _e1333 = vec3<f32>(_e1168[2][0], _e1168[2][1], _e1168[2][2]);
                                                                        let _e1334 = (_e1168[1][0] - _e1168[0][0]);
                                                                        let _e1335 = (_e1168[1][1] - _e1168[0][1]);
                                                                        let _e1336 = (_e1168[1][2] - _e1168[0][2]);
                                                                        let _e1337 = vec3<f32>(_e1334, _e1335, _e1336);
                                                                        let _e1338 = (_e1168[2][0] - _e1168[1][0]);
                                                                        let _e1339 = (_e1168[2][1] - _e1168[1][1]);
                                                                        let _e1340 = (_e1168[2][2] - _e1168[1][2]);
                                                                        let _e1341 = vec3<f32>(_e1338, _e1339, _e1340);
                                                                        let _e1342 = (_e1168[0][0] - _e1168[2][0]);
                                                                        let _e1343 = (_e1168[0][1] - _e1168[2][1]);
                                                                        let _e1344 = (_e1168[0][2] - _e1168[2][2]);
                                                                        let _e1345 = vec3<f32>(_e1342, _e1343, _e1344);
                                                                        let _e1348 = bitcast<f32>((bitcast<u32>(_e1334) & 2147483647u));
                                                                        let _e1351 = bitcast<f32>((bitcast<u32>(_e1335) & 2147483647u));
                                                                        let _e1353 = select(_e1351, _e1348, (_e1348 > _e1351));
                                                                        let _e1356 = bitcast<f32>((bitcast<u32>(_e1336) & 2147483647u));
                                                                        let _e1358 = select(_e1356, _e1353, (_e1353 > _e1356));
                                                                        let _e1361 = bitcast<f32>((bitcast<u32>(_e1338) & 2147483647u));
                                                                        let _e1364 = bitcast<f32>((bitcast<u32>(_e1339) & 2147483647u));
                                                                        let _e1366 = select(_e1364, _e1361, (_e1361 > _e1364));
                                                                        let _e1369 = bitcast<f32>((bitcast<u32>(_e1340) & 2147483647u));
                                                                        let _e1371 = select(_e1369, _e1366, (_e1366 > _e1369));
                                                                        let _e1374 = bitcast<f32>((bitcast<u32>(_e1342) & 2147483647u));
                                                                        let _e1377 = bitcast<f32>((bitcast<u32>(_e1343) & 2147483647u));
                                                                        let _e1379 = select(_e1377, _e1374, (_e1374 > _e1377));
                                                                        let _e1382 = bitcast<f32>((bitcast<u32>(_e1344) & 2147483647u));
                                                                        let _e1384 = select(_e1382, _e1379, (_e1379 > _e1382));
                                                                        let _e1386 = select(_e1371, _e1358, (_e1358 > _e1371));
                                                                        let _e1388 = select(_e1384, _e1386, (_e1386 > _e1384));
                                                                        if (_e1358 == _e1388) {
                                                                            phi_2664_ = _e1195;
                                                                            phi_2665_ = _e1192;
                                                                            phi_2666_ = _e1182;
                                                                            phi_2667_ = _e1179;
                                                                            phi_2668_ = _e1331;
                                                                            phi_2669_ = _e1345;
                                                                            phi_2670_ = _e1341;
                                                                            phi_2671_ = _e1337;
                                                                        } else {
                                                                            let _e1390 = (_e1371 == _e1388);
                                                                            let _e1395 = vec3(_e1390);
                                                                            phi_2664_ = select(_e1182, _e1208, _e1390);
                                                                            phi_2665_ = select(_e1179, _e1205, _e1390);
                                                                            phi_2666_ = select(_e1208, _e1195, _e1390);
                                                                            phi_2667_ = select(_e1205, _e1192, _e1390);
                                                                            phi_2668_ = select(_e1333, _e1332, _e1395);
                                                                            phi_2669_ = select(_e1341, _e1337, _e1395);
                                                                            phi_2670_ = select(_e1337, _e1345, _e1395);
                                                                            phi_2671_ = select(_e1345, _e1341, _e1395);
                                                                        }
                                                                        let _e1401 = phi_2664_;
                                                                        let _e1403 = phi_2665_;
                                                                        let _e1405 = phi_2666_;
                                                                        let _e1407 = phi_2667_;
                                                                        let _e1409 = phi_2668_;
                                                                        let _e1411 = phi_2669_;
                                                                        let _e1413 = phi_2670_;
                                                                        let _e1415 = phi_2671_;
                                                                        let _e1422 = ((_e1413.y * _e1411.z) - (_e1411.y * _e1413.z));
                                                                        let _e1427 = ((_e1413.z * _e1411.x) - (_e1411.z * _e1413.x));
                                                                        let _e1430 = ((_e1413.x * _e1411.y) - (_e1411.x * _e1413.y));
                                                                        if (_e1230 >= _e1234) {
                                                                            phi_2708_ = select(true, false, (_e1230 >= _e1238));
                                                                        } else {
                                                                            phi_2708_ = true;
                                                                        }
                                                                        let _e1435 = phi_2708_;
                                                                        if _e1435 {
                                                                            phi_2717_ = select(_e1333, _e1332, vec3((_e1234 >= _e1238)));
                                                                        } else {
                                                                            phi_2717_ = _e1331;
                                                                        }
                                                                        let _e1440 = phi_2717_;
                                                                        let _e1451 = (((_e1422 * (_e1440.x - _e331)) + (_e1427 * (_e1440.y - _e400))) + (_e1430 * (_e1440.z - _e468)));
                                                                        let _e1456 = (((_e1422 * _e371) + (_e1427 * _e439)) + (_e1430 * _e507));
                                                                        let _e1457 = (_e1403 - _e1407);
                                                                        let _e1458 = (_e1401 - _e1405);
                                                                        let _e1466 = (-(((_e1407 * _e1457) + (_e1405 * _e1458))) / ((_e1457 * _e1457) + (_e1458 * _e1458)));
                                                                        let _e1468 = select(1f, _e1466, (_e1466 < 1f));
                                                                        let _e1470 = select(0f, _e1468, (_e1468 > 0f));
                                                                        let _e1483 = ((_e1409.x + (_e1415.x * _e1470)) - _e331);
                                                                        let _e1484 = ((_e1409.y + (_e1415.y * _e1470)) - _e400);
                                                                        let _e1485 = ((_e1409.z + (_e1415.z * _e1470)) - _e468);
                                                                        let _e1486 = (_e1485 / _e507);
                                                                        let _e1498 = bitcast<f32>((bitcast<u32>(_e1483) & 2147483647u));
                                                                        let _e1501 = bitcast<f32>((bitcast<u32>(_e1484) & 2147483647u));
                                                                        let _e1503 = select(_e1501, _e1498, (_e1498 > _e1501));
                                                                        let _e1506 = bitcast<f32>((bitcast<u32>(_e1485) & 2147483647u));
                                                                        let _e1508 = select(_e1506, _e1503, (_e1503 > _e1506));
                                                                        let _e1514 = bitcast<f32>((bitcast<u32>(_e1422) & 2147483647u));
                                                                        let _e1517 = bitcast<f32>((bitcast<u32>(_e1427) & 2147483647u));
                                                                        let _e1519 = select(_e1517, _e1514, (_e1514 > _e1517));
                                                                        let _e1522 = bitcast<f32>((bitcast<u32>(_e1430) & 2147483647u));
                                                                        if (bitcast<f32>((bitcast<u32>(((((_e1422 * _e1483) + (_e1427 * _e1484)) + (_e1430 * _e1485)) - _e1451)) & 2147483647u)) <= ((0.0000009536743f * select(_e1388, _e1508, (_e1508 > _e1388))) * select(_e1522, _e1519, (_e1519 > _e1522)))) {
                                                                            let _e1532 = bitcast<f32>((bitcast<u32>(_e1413.x) & 2147483647u));
                                                                            let _e1535 = bitcast<f32>((bitcast<u32>(_e1413.y) & 2147483647u));
                                                                            let _e1537 = select(_e1535, _e1532, (_e1532 > _e1535));
                                                                            let _e1540 = bitcast<f32>((bitcast<u32>(_e1413.z) & 2147483647u));
                                                                            let _e1546 = bitcast<f32>((bitcast<u32>(_e1411.x) & 2147483647u));
                                                                            let _e1549 = bitcast<f32>((bitcast<u32>(_e1411.y) & 2147483647u));
                                                                            let _e1551 = select(_e1549, _e1546, (_e1546 > _e1549));
                                                                            let _e1554 = bitcast<f32>((bitcast<u32>(_e1411.z) & 2147483647u));
                                                                            let _e1558 = (bitcast<f32>((bitcast<u32>(_e1456) & 2147483647u)) > ((0.0000038146973f * select(_e1540, _e1537, (_e1537 > _e1540))) * select(_e1554, _e1551, (_e1551 > _e1554))));
                                                                            if _e1558 {
                                                                                phi_2882_ = (_e1451 / _e1456);
                                                                            } else {
                                                                                phi_2882_ = f32();
                                                                            }
                                                                            let _e1561 = phi_2882_;
                                                                            phi_2884_ = _e1561;
                                                                            phi_2885_ = select(true, false, _e1558);
                                                                        } else {
                                                                            phi_2884_ = f32();
                                                                            phi_2885_ = true;
                                                                        }
                                                                        let _e1564 = phi_2884_;
                                                                        let _e1566 = phi_2885_;
                                                                        if _e1566 {
                                                                            let _e1574 = (((_e1422 * (_e1483 - (_e371 * _e1486))) + (_e1427 * (_e1484 - (_e439 * _e1486)))) / _e1456);
                                                                            if (bitcast<f32>((bitcast<u32>(_e1574) & 2147483647u)) <= _e1388) {
                                                                                phi_2905_ = (_e1486 + _e1574);
                                                                            } else {
                                                                                phi_2905_ = _e1486;
                                                                            }
                                                                            let _e1581 = phi_2905_;
                                                                            phi_2906_ = _e1581;
                                                                        } else {
                                                                            phi_2906_ = _e1564;
                                                                        }
                                                                        let _e1583 = phi_2906_;
                                                                        let _e1585 = select(_e1321, _e1583, (_e1583 < _e1321));
                                                                        let _e1587 = select(_e1313, _e1585, (_e1585 > _e1313));
                                                                        if (_e1587 >= _e622) {
                                                                            let _e1589 = (_e1587 <= _e721.member_1);
                                                                            if _e1589 {
                                                                                let _e1590 = (1f / _e1240);
                                                                                phi_2929_ = type_20(_e1587, (_e1234 * _e1590), (_e1238 * _e1590), _e781);
                                                                            } else {
                                                                                phi_2929_ = type_20();
                                                                            }
                                                                            let _e1595 = phi_2929_;
                                                                            phi_2931_ = _e1595;
                                                                            phi_2932_ = select(true, false, _e1589);
                                                                        } else {
                                                                            phi_2931_ = type_20();
                                                                            phi_2932_ = true;
                                                                        }
                                                                        let _e1598 = phi_2931_;
                                                                        let _e1600 = phi_2932_;
                                                                        if _e1600 {
                                                                            phi_2936_ = type_20(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                        } else {
                                                                            phi_2936_ = _e1598;
                                                                        }
                                                                        let _e1602 = phi_2936_;
                                                                        phi_2937_ = _e1602;
                                                                    }
                                                                    let _e1604 = phi_2937_;
                                                                    phi_2938_ = _e1604;
                                                                    phi_2939_ = _e1330;
                                                                }
                                                                let _e1606 = phi_2938_;
                                                                let _e1608 = phi_2939_;
                                                                phi_2943_ = _e1606;
                                                                phi_2944_ = _e1608;
                                                            }
                                                            let _e1610 = phi_2943_;
                                                            let _e1612 = phi_2944_;
                                                            phi_2945_ = _e1610;
                                                            phi_2946_ = _e1265;
                                                            phi_2947_ = _e1612;
                                                        }
                                                        let _e1614 = phi_2945_;
                                                        let _e1616 = phi_2946_;
                                                        let _e1618 = phi_2947_;
                                                        phi_2948_ = _e1614;
                                                        phi_2949_ = _e1616;
                                                        phi_2950_ = _e1618;
                                                    }
                                                    let _e1620 = phi_2948_;
                                                    let _e1622 = phi_2949_;
                                                    let _e1624 = phi_2950_;
                                                    phi_2958_ = _e1620;
                                                    phi_2959_ = select(_e1624, true, _e1622);
                                                } else {
                                                    phi_2958_ = type_20();
                                                    phi_2959_ = true;
                                                }
                                                let _e1627 = phi_2958_;
                                                let _e1629 = phi_2959_;
                                                if _e1629 {
                                                    phi_2963_ = type_20(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                } else {
                                                    phi_2963_ = _e1627;
                                                }
                                                let _e1631 = phi_2963_;
                                                if (_e1631.member_3 != 4294967295u) {
                                                    if (_e781 != 4294967295u) {
                                                        if (_e1631.member < _e721.member.member) {
                                                            phi_2989_ = true;
                                                        } else {
                                                            if (_e1631.member == _e721.member.member) {
                                                                phi_2988_ = (_e1631.member_3 < _e721.member.member_3);
                                                            } else {
                                                                phi_2988_ = false;
                                                            }
                                                            let _e1644 = phi_2988_;
                                                            phi_2989_ = _e1644;
                                                        }
                                                        let _e1646 = phi_2989_;
                                                        if _e1646 {
                                                            phi_2995_ = type_33(_e1631, _e1631.member);
                                                        } else {
                                                            phi_2995_ = _e721;
                                                        }
                                                        let _e1649 = phi_2995_;
                                                        phi_2996_ = _e1649;
                                                    } else {
                                                        phi_2996_ = _e721;
                                                    }
                                                    let _e1651 = phi_2996_;
                                                    phi_2997_ = _e1651;
                                                } else {
                                                    phi_2997_ = _e721;
                                                }
                                                let _e1653 = phi_2997_;
                                                phi_1301_ = _e1653;
                                            } else {
                                                phi_1301_ = type_33();
                                            }
                                            let _e1655 = phi_1301_;
                                            continue;
                                            continuing {
                                                phi_1300_ = _e1655;
                                                phi_1303_ = _e736;
                                                phi_4642_ = _e664;
                                                break if !(_e742);
                                            }
                                        }
                                        let _e1658 = phi_4642_;
                                        phi_4849_ = _e1658;
                                        if _e1658 {
                                            break;
                                        }
                                        phi_4940_ = _e1658;
                                        let _e2445 = local_11;
                                        phi_2998_ = _e2445;
                                    } else {
                                        phi_4940_ = _e664;
                                        phi_2998_ = _e666;
                                    }
                                    let _e1660 = phi_4940_;
                                    let _e1662 = phi_2998_;
                                    if _e713 {
                                        phi_4263_ = bool();
                                        phi_4264_ = u32();
                                        phi_4265_ = type_49();
                                    } else {
                                        if (_e709.member_1 >= _e96) {
                                            phi_3799_ = type_50(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), type_49(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u), type_49(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u));
                                        } else {
                                            if (_e709.member_1 < _e96) {
                                            } else {
                                                phi_4849_ = true;
                                                break;
                                            }
                                            let _e1665 = (_e267 * 2u);
                                            let _e1667 = ((1u + _e1665) % 7u);
                                            if (_e1667 < 7u) {
                                            } else {
                                                phi_4849_ = true;
                                                break;
                                            }
                                            let _e1672 = global_4.member[_e709.member_1][_e1667];
                                            let _e1674 = ((_e1665 + 2u) % 7u);
                                            if (_e1674 < 7u) {
                                            } else {
                                                phi_4849_ = true;
                                                break;
                                            }
                                            let _e1679 = global_4.member[_e709.member_1][_e1674];
                                            let _e1680 = (_e266 * 2u);
                                            let _e1682 = ((1u + _e1680) % 7u);
                                            if (_e1682 < 7u) {
                                            } else {
                                                phi_4849_ = true;
                                                break;
                                            }
                                            let _e1687 = global_4.member[_e709.member_1][_e1682];
                                            let _e1689 = ((_e1680 + 2u) % 7u);
                                            if (_e1689 < 7u) {
                                            } else {
                                                phi_4849_ = true;
                                                break;
                                            }
                                            let _e1694 = global_4.member[_e709.member_1][_e1689];
                                            let _e1695 = (_e268 * 2u);
                                            let _e1697 = ((1u + _e1695) % 7u);
                                            if (_e1697 < 7u) {
                                            } else {
                                                phi_4849_ = true;
                                                break;
                                            }
                                            let _e1702 = global_4.member[_e709.member_1][_e1697];
                                            let _e1704 = ((_e1695 + 2u) % 7u);
                                            if (_e1704 < 7u) {
                                            } else {
                                                phi_4849_ = true;
                                                break;
                                            }
                                            let _e1709 = global_4.member[_e709.member_1][_e1704];
                                            let _e1732 = (bitcast<f32>((bitcast<u32>((_e709.member.member_1.x - _e709.member.member.x)) & 2139095040u)) * 0.0000009536743f);
                                            let _e1733 = (bitcast<f32>((bitcast<u32>((_e709.member.member_1.y - _e709.member.member.y)) & 2139095040u)) * 0.0000009536743f);
                                            let _e1734 = (bitcast<f32>((bitcast<u32>((_e709.member.member_1.z - _e709.member.member.z)) & 2139095040u)) * 0.0000009536743f);
                                            let _e1736 = select(_e147, _e1732, (_e1732 > _e147));
                                            let _e1738 = select(_e147, _e1733, (_e1733 > _e147));
                                            let _e1740 = select(_e147, _e1734, (_e1734 > _e147));
                                            let _e1771 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1672 & 2097151u))) - 8388608f) * _e1736));
                                            let _e1776 = (bitcast<i32>((_e1672 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e1779 = bitcast<f32>((_e1771 & bitcast<u32>(_e1776)));
                                            let _e1780 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1687 & 2097151u))) - 8388608f) * _e1738));
                                            let _e1785 = (bitcast<i32>((_e1687 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e1788 = bitcast<f32>((_e1780 & bitcast<u32>(_e1785)));
                                            let _e1789 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1702 & 2097151u))) - 8388608f) * _e1740));
                                            let _e1794 = (bitcast<i32>((_e1702 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e1797 = bitcast<f32>((_e1789 & bitcast<u32>(_e1794)));
                                            let _e1801 = bitcast<f32>((_e1771 & bitcast<u32>(~(_e1776))));
                                            let _e1805 = bitcast<f32>((_e1780 & bitcast<u32>(~(_e1785))));
                                            let _e1809 = bitcast<f32>((_e1789 & bitcast<u32>(~(_e1794))));
                                            let _e1810 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1679 & 2097151u))) - 8388608f) * _e1736));
                                            let _e1815 = (bitcast<i32>((_e1679 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e1818 = bitcast<f32>((_e1810 & bitcast<u32>(_e1815)));
                                            let _e1819 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1694 & 2097151u))) - 8388608f) * _e1738));
                                            let _e1824 = (bitcast<i32>((_e1694 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e1827 = bitcast<f32>((_e1819 & bitcast<u32>(_e1824)));
                                            let _e1828 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1709 & 2097151u))) - 8388608f) * _e1740));
                                            let _e1833 = (bitcast<i32>((_e1709 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e1836 = bitcast<f32>((_e1828 & bitcast<u32>(_e1833)));
                                            let _e1840 = bitcast<f32>((_e1810 & bitcast<u32>(~(_e1815))));
                                            let _e1844 = bitcast<f32>((_e1819 & bitcast<u32>(~(_e1824))));
                                            let _e1848 = bitcast<f32>((_e1828 & bitcast<u32>(~(_e1833))));
                                            let _e1849 = (_e709.member.member.x + _e1779);
                                            let _e1850 = (_e709.member.member.y + _e1788);
                                            let _e1851 = (_e709.member.member.z + _e1797);
                                            let _e1854 = (_e709.member.member_1.x - _e1818);
                                            let _e1855 = (_e709.member.member_1.y - _e1827);
                                            let _e1856 = (_e709.member.member_1.z - _e1836);
                                            let _e1875 = (_e1854 - _e1849);
                                            let _e1876 = (_e1855 - _e1850);
                                            let _e1877 = (_e1856 - _e1851);
                                            let _e1879 = select(_e1876, _e1875, (_e1875 > _e1876));
                                            let _e1881 = select(_e1877, _e1879, (_e1879 > _e1877));
                                            if (_e1881 < (1024f * _e147)) {
                                                phi_3500_ = 0u;
                                            } else {
                                                phi_3500_ = select(2u, 1u, (_e1881 < (2097152f * _e147)));
                                            }
                                            let _e1888 = phi_3500_;
                                            switch bitcast<i32>(_e1888) {
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
                                            let _e1891 = phi_3506_;
                                            let _e1897 = global_4.member[_e709.member_1][0u];
                                            let _e1901 = global_4.member[_e709.member_1][2u];
                                            let _e1905 = global_4.member[_e709.member_1][4u];
                                            let _e1909 = global_4.member[_e709.member_1][6u];
                                            let _e1921 = (((_e1901 >> bitcast<u32>(22i)) | ((_e1905 >> bitcast<u32>(22i)) << bitcast<u32>(10i))) | ((_e1909 >> bitcast<u32>(22i)) << bitcast<u32>(20i)));
                                            let _e1922 = (_e1897 & 268435455u);
                                            let _e1923 = (_e1921 & 268435455u);
                                            let _e1926 = ((_e1897 >> bitcast<u32>(28u)) & 7u);
                                            let _e1934 = ((_e1897 >> bitcast<u32>(31i)) | (((_e1921 >> bitcast<u32>(28u)) & 3u) << bitcast<u32>(1i)));
                                            let _e1935 = (_e1926 != 0u);
                                            if (_e1926 == 0u) {
                                                phi_3761_ = _e1922;
                                            } else {
                                                if (_e1926 == 7u) {
                                                    phi_3760_ = 2147483648u;
                                                } else {
                                                    phi_3760_ = ((2147483648u | (_e1926 << bitcast<u32>(28u))) | (_e1923 & 268435455u));
                                                }
                                                let _e1944 = phi_3760_;
                                                phi_3761_ = _e1944;
                                            }
                                            let _e1946 = phi_3761_;
                                            if _e1935 {
                                                let _e1947 = (_e1926 != 7u);
                                                if _e1947 {
                                                    phi_3771_ = (_e1923 + (_e1926 * ((3u * _e1891) + 1u)));
                                                } else {
                                                    phi_3771_ = u32();
                                                }
                                                let _e1951 = phi_3771_;
                                                phi_3773_ = _e1951;
                                                phi_3774_ = select(true, false, _e1947);
                                            } else {
                                                phi_3773_ = u32();
                                                phi_3774_ = true;
                                            }
                                            let _e1954 = phi_3773_;
                                            let _e1956 = phi_3774_;
                                            if (_e1934 == 0u) {
                                                phi_3795_ = (_e1922 + select(0u, 1u, !(_e1935)));
                                            } else {
                                                if (_e1934 == 7u) {
                                                    phi_3794_ = 2147483648u;
                                                } else {
                                                    phi_3794_ = ((2147483648u | (_e1934 << bitcast<u32>(28u))) | (select(_e1954, _e1923, _e1956) & 268435455u));
                                                }
                                                let _e1969 = phi_3794_;
                                                phi_3795_ = _e1969;
                                            }
                                            let _e1971 = phi_3795_;
                                            phi_3799_ = type_50(array<vec4<f32>, 3>(vec4<f32>(_e1849, (_e709.member.member.x + _e1801), _e1854, (_e709.member.member_1.x - _e1840)), vec4<f32>(_e1850, (_e709.member.member.y + _e1805), _e1855, (_e709.member.member_1.y - _e1844)), vec4<f32>(_e1851, (_e709.member.member.z + _e1809), _e1856, (_e709.member.member_1.z - _e1848))), type_49(type_28((_e709.member.member + vec4<f32>(_e1779, _e1788, _e1797, 0f)), (_e709.member.member_1 - vec4<f32>(_e1818, _e1827, _e1836, 0f))), _e1946), type_49(type_28((_e709.member.member + vec4<f32>(_e1801, _e1805, _e1809, 0f)), (_e709.member.member_1 - vec4<f32>(_e1840, _e1844, _e1848, 0f))), _e1971));
                                        }
                                        let _e1976 = phi_3799_;
                                        let _e1988 = ((_e1976.member[0].x - _e369) * _e374);
                                        let _e1989 = ((_e1976.member[0].y - _e369) * _e374);
                                        let _e1990 = ((_e1976.member[0].z - _e370) * _e374);
                                        let _e1991 = ((_e1976.member[0].w - _e370) * _e374);
                                        let _e2001 = ((_e1976.member[1].x - _e437) * _e442);
                                        let _e2002 = ((_e1976.member[1].y - _e437) * _e442);
                                        let _e2003 = ((_e1976.member[1].z - _e438) * _e442);
                                        let _e2004 = ((_e1976.member[1].w - _e438) * _e442);
                                        let _e2014 = ((_e1976.member[2].x - _e505) * _e510);
                                        let _e2015 = ((_e1976.member[2].y - _e505) * _e510);
                                        let _e2016 = ((_e1976.member[2].z - _e506) * _e510);
                                        let _e2017 = ((_e1976.member[2].w - _e506) * _e510);
                                        let _e2019 = select(_e2016, _e2014, (_e2014 < _e2016));
                                        let _e2021 = select(_e2017, _e2015, (_e2015 < _e2017));
                                        let _e2023 = select(_e2016, _e2014, (_e2014 > _e2016));
                                        let _e2025 = select(_e2017, _e2015, (_e2015 > _e2017));
                                        let _e2027 = select(_e1990, _e1988, (_e1988 < _e1990));
                                        let _e2029 = select(_e1991, _e1989, (_e1989 < _e1991));
                                        let _e2031 = select(_e2003, _e2001, (_e2001 < _e2003));
                                        let _e2033 = select(_e2004, _e2002, (_e2002 < _e2004));
                                        let _e2035 = select(_e2031, _e2027, (_e2027 > _e2031));
                                        let _e2037 = select(_e2033, _e2029, (_e2029 > _e2033));
                                        let _e2039 = select(_e2019, _e2035, (_e2035 > _e2019));
                                        let _e2041 = select(_e2021, _e2037, (_e2037 > _e2021));
                                        let _e2043 = select(_e1990, _e1988, (_e1988 > _e1990));
                                        let _e2045 = select(_e1991, _e1989, (_e1989 > _e1991));
                                        let _e2047 = select(_e2003, _e2001, (_e2001 > _e2003));
                                        let _e2049 = select(_e2004, _e2002, (_e2002 > _e2004));
                                        let _e2051 = select(_e2047, _e2043, (_e2043 < _e2047));
                                        let _e2053 = select(_e2049, _e2045, (_e2045 < _e2049));
                                        let _e2058 = -(_e2019);
                                        let _e2059 = -(_e2021);
                                        let _e2066 = (select(_e2023, _e2051, (_e2051 < _e2023)) + (select(_e2058, _e2023, (_e2023 > _e2058)) * 0.0000019073523f));
                                        let _e2067 = (select(_e2025, _e2053, (_e2053 < _e2025)) + (select(_e2059, _e2025, (_e2025 > _e2059)) * 0.0000019073523f));
                                        let _e2069 = select(_e622, _e2039, (_e2039 > _e622));
                                        let _e2071 = select(_e622, _e2041, (_e2041 > _e622));
                                        let _e2076 = (_e2069 <= select(_e1662.member_1, _e2066, (_e2066 < _e1662.member_1)));
                                        let _e2077 = (_e2071 <= select(_e1662.member_1, _e2067, (_e2067 < _e1662.member_1)));
                                        let _e2078 = (_e2069 <= _e2071);
                                        if _e2076 {
                                            if _e2077 {
                                                if _e2078 {
                                                    phi_4161_ = _e1976.member_2;
                                                } else {
                                                    phi_4161_ = _e1976.member_1;
                                                }
                                                let _e2082 = phi_4161_;
                                                let _e2103 = (_e707 % 128u);
                                                let _e2104 = (_e2103 < 128u);
                                                if _e2104 {
                                                } else {
                                                    phi_4849_ = true;
                                                    break;
                                                }
                                                local_8[_e2103] = _e2082.member_1;
                                                if _e2104 {
                                                } else {
                                                    phi_4849_ = true;
                                                    break;
                                                }
                                                local_7[_e2103] = _e2082.member.member.x;
                                                if _e2104 {
                                                } else {
                                                    phi_4849_ = true;
                                                    break;
                                                }
                                                local_6[_e2103] = _e2082.member.member.y;
                                                if _e2104 {
                                                } else {
                                                    phi_4849_ = true;
                                                    break;
                                                }
                                                local_5[_e2103] = _e2082.member.member.z;
                                                if _e2104 {
                                                } else {
                                                    phi_4849_ = true;
                                                    break;
                                                }
                                                local_4[_e2103] = _e2082.member.member_1.x;
                                                if _e2104 {
                                                } else {
                                                    phi_4849_ = true;
                                                    break;
                                                }
                                                local_3[_e2103] = _e2082.member.member_1.y;
                                                if _e2104 {
                                                } else {
                                                    phi_4849_ = true;
                                                    break;
                                                }
                                                local_2[_e2103] = _e2082.member.member_1.z;
                                                if _e2104 {
                                                } else {
                                                    phi_4849_ = true;
                                                    break;
                                                }
                                                local_9[_e2103] = select(_e2069, _e2071, _e2078);
                                                if _e2078 {
                                                    phi_4237_ = _e1976.member_1;
                                                } else {
                                                    phi_4237_ = _e1976.member_2;
                                                }
                                                let _e2117 = phi_4237_;
                                                phi_4238_ = (_e707 + 1u);
                                                phi_4239_ = _e2117;
                                            } else {
                                                phi_4238_ = u32();
                                                phi_4239_ = type_49();
                                            }
                                            let _e2119 = phi_4238_;
                                            let _e2121 = phi_4239_;
                                            phi_4241_ = _e2119;
                                            phi_4242_ = _e2121;
                                            phi_4243_ = select(true, false, _e2077);
                                        } else {
                                            phi_4241_ = u32();
                                            phi_4242_ = type_49();
                                            phi_4243_ = true;
                                        }
                                        let _e2124 = phi_4241_;
                                        let _e2126 = phi_4242_;
                                        let _e2128 = phi_4243_;
                                        if _e2128 {
                                            if _e2076 {
                                                phi_4252_ = _e1976.member_1;
                                            } else {
                                                phi_4252_ = _e1976.member_2;
                                            }
                                            let _e2132 = phi_4252_;
                                            phi_4257_ = select(_e2077, true, _e2076);
                                            phi_4259_ = _e2132;
                                        } else {
                                            phi_4257_ = _e705;
                                            phi_4259_ = _e2126;
                                        }
                                        let _e2135 = phi_4257_;
                                        let _e2137 = phi_4259_;
                                        phi_4263_ = _e2135;
                                        phi_4264_ = select(_e2124, _e707, _e2128);
                                        phi_4265_ = _e2137;
                                    }
                                    let _e2140 = phi_4263_;
                                    let _e2142 = phi_4264_;
                                    let _e2144 = phi_4265_;
                                    if _e713 {
                                        phi_4275_ = _e709;
                                    } else {
                                        phi_4275_ = _e2144;
                                    }
                                    let _e2146 = phi_4275_;
                                    phi_4852_ = _e1660;
                                    phi_4276_ = _e1662;
                                    phi_4277_ = (_e668 - 1u);
                                    phi_4278_ = select(_e2140, false, _e713);
                                    phi_4279_ = select(_e2142, _e707, _e713);
                                    phi_4280_ = _e2146;
                                } else {
                                    phi_4852_ = _e664;
                                    phi_4276_ = _e666;
                                    phi_4277_ = _e668;
                                    phi_4278_ = _e705;
                                    phi_4279_ = _e707;
                                    phi_4280_ = _e709;
                                }
                                let _e2150 = phi_4852_;
                                let _e2152 = phi_4276_;
                                let _e2154 = phi_4277_;
                                let _e2156 = phi_4278_;
                                let _e2158 = phi_4279_;
                                let _e2160 = phi_4280_;
                                phi_4851_ = _e2150;
                                phi_4281_ = _e2152;
                                phi_4282_ = _e2154;
                                phi_4283_ = _e2156;
                                phi_4284_ = _e2158;
                                phi_4285_ = _e2160;
                            } else {
                                phi_4851_ = _e664;
                                phi_4281_ = type_33();
                                phi_4282_ = u32();
                                phi_4283_ = bool();
                                phi_4284_ = u32();
                                phi_4285_ = type_49();
                            }
                            let _e2162 = phi_4851_;
                            let _e2164 = phi_4281_;
                            let _e2166 = phi_4282_;
                            let _e2168 = phi_4283_;
                            let _e2170 = phi_4284_;
                            let _e2172 = phi_4285_;
                            phi_4850_ = _e2162;
                            phi_1174_ = _e2164;
                            phi_1177_ = _e2166;
                            phi_1179_ = _e2168;
                            phi_1181_ = _e2170;
                            phi_1183_ = _e2172;
                            phi_4286_ = _e678;
                        } else {
                            phi_4850_ = _e664;
                            phi_1174_ = type_33();
                            phi_1177_ = u32();
                            phi_1179_ = bool();
                            phi_1181_ = u32();
                            phi_1183_ = type_49();
                            phi_4286_ = false;
                        }
                        let _e2174 = phi_4850_;
                        let _e2176 = phi_1174_;
                        let _e2178 = phi_1177_;
                        let _e2180 = phi_1179_;
                        let _e2182 = phi_1181_;
                        let _e2184 = phi_1183_;
                        let _e2186 = phi_4286_;
                        continue;
                        continuing {
                            phi_4648_ = _e2174;
                            phi_1173_ = _e2176;
                            phi_1176_ = _e2178;
                            phi_1178_ = _e2180;
                            phi_1180_ = _e2182;
                            phi_1182_ = _e2184;
                            phi_4849_ = _e2174;
                            break if !(_e2186);
                        }
                    }
                    let _e2189 = phi_4849_;
                    if _e2189 {
                        break;
                    }
                    let _e2191 = local_10;
                    if (_e2191.member.member_3 != 4294967295u) {
                        let _e2196 = -(_e524);
                        let _e2197 = bitcast<u32>(_e2191.member.member);
                        let _e2201 = (bitcast<i32>((_e2197 >> bitcast<u32>(23i))) & 255i);
                        let _e2202 = (_e2201 + _e2196);
                        if (_e2201 == 255i) {
                            phi_4345_ = _e2191.member.member;
                        } else {
                            if (_e2201 > 0i) {
                                if (_e2202 > 0i) {
                                    let _e2206 = (_e2202 < 255i);
                                    if _e2206 {
                                        phi_4324_ = bitcast<f32>((_e2197 + bitcast<u32>((_e2196 << bitcast<u32>(23i)))));
                                    } else {
                                        phi_4324_ = f32();
                                    }
                                    let _e2213 = phi_4324_;
                                    phi_4326_ = _e2213;
                                    phi_4327_ = select(true, false, _e2206);
                                } else {
                                    phi_4326_ = f32();
                                    phi_4327_ = true;
                                }
                                let _e2216 = phi_4326_;
                                let _e2218 = phi_4327_;
                                phi_4328_ = _e2216;
                                phi_4329_ = _e2218;
                            } else {
                                phi_4328_ = f32();
                                phi_4329_ = true;
                            }
                            let _e2220 = phi_4328_;
                            let _e2222 = phi_4329_;
                            if _e2222 {
                                let _e2223 = (_e2197 & 2147483648u);
                                let _e2230 = ((_e2197 & 8388607u) | (select(0u, 1u, ((_e2197 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                                let _e2234 = (_e2230 == 0u);
                                if _e2234 {
                                    phi_4600_ = bitcast<f32>(_e2223);
                                } else {
                                    let _e2239 = (select((bitcast<u32>(31i) - firstLeadingBit(_e2230)), 32u, _e2234) - 8u);
                                    let _e2242 = (_e2230 << bitcast<u32>((_e2239 & 31u)));
                                    let _e2244 = ((_e2202 + select(0i, 1i, (_e2201 == 0i))) - bitcast<i32>(_e2239));
                                    if (_e2244 >= 255i) {
                                        phi_4590_ = bitcast<f32>((_e2223 | 2139095040u));
                                        phi_4591_ = f32();
                                        phi_4592_ = true;
                                    } else {
                                        let _e2246 = (_e2244 > 0i);
                                        if _e2246 {
                                            phi_4584_ = bitcast<f32>(((_e2223 | (bitcast<u32>(_e2244) << bitcast<u32>(23i))) | (_e2242 & 8388607u)));
                                            phi_4585_ = f32();
                                        } else {
                                            if (_e2244 < -24i) {
                                                phi_4550_ = 26u;
                                            } else {
                                                phi_4550_ = bitcast<u32>((1i - _e2244));
                                            }
                                            let _e2251 = phi_4550_;
                                            let _e2252 = (_e2251 & 31u);
                                            let _e2254 = (_e2242 >> bitcast<u32>(_e2252));
                                            let _e2258 = (_e2242 & ((1u << bitcast<u32>(_e2252)) - 1u));
                                            let _e2262 = (1u << bitcast<u32>(((_e2251 - 1u) & 31u)));
                                            if (_e2258 > _e2262) {
                                                phi_4571_ = true;
                                            } else {
                                                if (_e2258 == _e2262) {
                                                    phi_4568_ = ((_e2254 & 1u) == 1u);
                                                } else {
                                                    phi_4568_ = false;
                                                }
                                                let _e2268 = phi_4568_;
                                                phi_4571_ = _e2268;
                                            }
                                            let _e2270 = phi_4571_;
                                            phi_4584_ = f32();
                                            phi_4585_ = bitcast<f32>((_e2223 | (_e2254 + select(0u, 1u, _e2270))));
                                        }
                                        let _e2283 = phi_4584_;
                                        let _e2285 = phi_4585_;
                                        phi_4590_ = _e2283;
                                        phi_4591_ = _e2285;
                                        phi_4592_ = _e2246;
                                    }
                                    let _e2289 = phi_4590_;
                                    let _e2291 = phi_4591_;
                                    let _e2293 = phi_4592_;
                                    phi_4600_ = select(_e2291, _e2289, _e2293);
                                }
                                let _e2297 = phi_4600_;
                                phi_4344_ = _e2297;
                            } else {
                                phi_4344_ = _e2220;
                            }
                            let _e2299 = phi_4344_;
                            phi_4345_ = _e2299;
                        }
                        let _e2301 = phi_4345_;
                        let _e2302 = bitcast<u32>(_e2301);
                        if ((_e2302 & 2147483647u) >= 2139095040u) {
                            phi_4357_ = bitcast<f32>(((_e2302 & 2147483648u) | 2139095039u));
                        } else {
                            phi_4357_ = _e2301;
                        }
                        let _e2309 = phi_4357_;
                        phi_4362_ = type_20(_e2309, _e2191.member.member_1, _e2191.member.member_2, _e2191.member.member_3);
                    } else {
                        phi_4362_ = type_20(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                    }
                    let _e2314 = phi_4362_;
                    if _e155 {
                    } else {
                        break;
                    }
                    global_6.member[_e153] = _e2314;
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
