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

struct type_25 {
    member: array<f32, 3>,
    member_1: f32,
    member_2: array<f32, 3>,
    member_3: f32,
}

struct type_28 {
    member: vec4<f32>,
    member_1: vec4<f32>,
}

struct type_36 {
    member: array<type_25>,
}

struct type_38 {
    member: f32,
    member_1: bool,
}

struct type_40 {
    member: array<vec4<u32>, 2>,
}

struct type_45 {
    member: type_28,
    member_1: u32,
}

struct type_46 {
    member: array<vec4<f32>, 3>,
    member_1: type_45,
    member_2: type_45,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_1: type_16;
@group(0) @binding(1) 
var<uniform> global_2: type_40;
@group(0) @binding(2) 
var<storage> global_3: type_13;
@group(0) @binding(4) 
var<storage> global_4: type_36;
@group(0) @binding(5) 
var<storage, read_write> global_5: type_4;
@group(0) @binding(3) 
var<storage> global_6: type_4;

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
    var phi_391_: i32;
    var phi_392_: i32;
    var phi_402_: bool;
    var phi_412_: u32;
    var phi_413_: u32;
    var phi_415_: bool;
    var phi_420_: u32;
    var phi_432_: i32;
    var phi_452_: i32;
    var phi_470_: f32;
    var phi_476_: f32;
    var phi_516_: f32;
    var phi_522_: f32;
    var phi_574_: f32;
    var phi_585_: f32;
    var phi_594_: f32;
    var phi_600_: f32;
    var phi_640_: f32;
    var phi_646_: f32;
    var phi_698_: f32;
    var phi_709_: f32;
    var phi_718_: f32;
    var phi_724_: f32;
    var phi_764_: f32;
    var phi_770_: f32;
    var phi_822_: f32;
    var phi_833_: f32;
    var phi_888_: i32;
    var phi_910_: u32;
    var phi_911_: u32;
    var phi_948_: i32;
    var phi_970_: u32;
    var phi_971_: u32;
    var phi_979_: f32;
    var phi_980_: f32;
    var phi_4258_: bool;
    var phi_1069_: type_38;
    var phi_1072_: type_45;
    var phi_1074_: u32;
    var phi_1076_: bool;
    var phi_1078_: u32;
    var phi_1089_: bool;
    var phi_1175_: type_45;
    var phi_1176_: bool;
    var phi_1177_: u32;
    var phi_3283_: u32;
    var phi_3289_: u32;
    var phi_3543_: u32;
    var phi_3544_: u32;
    var phi_3554_: u32;
    var phi_3556_: u32;
    var phi_3557_: bool;
    var phi_3577_: u32;
    var phi_3578_: u32;
    var phi_3582_: type_46;
    var phi_3926_: type_45;
    var phi_4003_: type_45;
    var phi_4004_: type_45;
    var phi_4005_: u32;
    var phi_4007_: type_45;
    var phi_4008_: u32;
    var phi_4009_: bool;
    var phi_4018_: type_45;
    var phi_4023_: type_45;
    var phi_4024_: bool;
    var phi_1196_: type_38;
    var phi_1199_: type_8;
    var phi_1200_: type_8;
    var phi_1222_: type_8;
    var phi_1263_: u32;
    var phi_1269_: u32;
    var phi_1279_: u32;
    var phi_1295_: u32;
    var phi_1328_: u32;
    var phi_1334_: u32;
    var phi_1779_: u32;
    var phi_1797_: u32;
    var phi_1815_: u32;
    var phi_1835_: u32;
    var phi_1853_: u32;
    var phi_1871_: u32;
    var phi_1891_: u32;
    var phi_1909_: u32;
    var phi_1927_: u32;
    var phi_1496_: u32;
    var phi_1511_: u32;
    var phi_1521_: u32;
    var phi_1542_: u32;
    var phi_1563_: u32;
    var phi_1590_: u32;
    var phi_1605_: u32;
    var phi_1615_: u32;
    var phi_1636_: u32;
    var phi_1657_: u32;
    var phi_1684_: u32;
    var phi_1699_: u32;
    var phi_1709_: u32;
    var phi_1730_: u32;
    var phi_1751_: u32;
    var phi_1358_: u32;
    var phi_1404_: u32;
    var phi_1450_: u32;
    var phi_1933_: array<array<f32, 3>, 3>;
    var phi_2050_: bool;
    var phi_2079_: bool;
    var phi_2480_: f32;
    var phi_2481_: f32;
    var phi_2482_: f32;
    var phi_2483_: f32;
    var phi_2484_: vec3<f32>;
    var phi_2485_: vec3<f32>;
    var phi_2486_: vec3<f32>;
    var phi_2487_: vec3<f32>;
    var phi_2518_: bool;
    var phi_2527_: vec3<f32>;
    var phi_2692_: f32;
    var phi_2694_: f32;
    var phi_2695_: bool;
    var phi_2715_: f32;
    var phi_2716_: f32;
    var phi_2739_: type_24;
    var phi_2741_: type_24;
    var phi_2742_: bool;
    var phi_2746_: type_24;
    var phi_2747_: type_24;
    var phi_2748_: type_24;
    var phi_2749_: bool;
    var phi_2753_: type_24;
    var phi_2754_: bool;
    var phi_2755_: type_24;
    var phi_2756_: bool;
    var phi_2757_: bool;
    var phi_2758_: type_24;
    var phi_2759_: bool;
    var phi_2760_: bool;
    var phi_2768_: type_24;
    var phi_2769_: bool;
    var phi_2773_: type_24;
    var phi_2784_: type_38;
    var phi_2785_: type_38;
    var phi_1197_: type_38;
    var phi_4252_: bool;
    var local_10: type_38;
    var phi_4460_: bool;
    var phi_4026_: type_38;
    var phi_4027_: type_45;
    var phi_4028_: bool;
    var phi_4029_: u32;
    var phi_4459_: bool;
    var phi_4030_: type_38;
    var phi_4031_: type_45;
    var phi_4032_: u32;
    var phi_4033_: bool;
    var phi_4034_: u32;
    var phi_4458_: bool;
    var phi_4035_: type_38;
    var phi_4036_: type_45;
    var phi_4037_: u32;
    var phi_4038_: bool;
    var phi_4039_: u32;
    var phi_4457_: bool;
    var phi_1070_: type_38;
    var phi_1073_: type_45;
    var phi_1075_: u32;
    var phi_1077_: bool;
    var phi_1079_: u32;
    var phi_4040_: bool;
    var phi_4456_: bool;
    var local_11: type_38;
    var local_12: type_38;

    switch bitcast<i32>(0u) {
        default: {
            let _e94 = global;
            let _e96 = arrayLength((&global_3.member));
            let _e99 = arrayLength((&global_6.member));
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
            let _e154 = (_e153 < arrayLength((&global_4.member)));
            if _e154 {
                let _e155 = (_e153 < arrayLength((&global_5.member)));
                if _e155 {
                    if _e154 {
                    } else {
                        break;
                    }
                    let _e163 = global_4.member[_e153].member_2[0u];
                    let _e165 = (bitcast<u32>(_e163) & 2147483647u);
                    let _e170 = global_4.member[_e153].member_2[1u];
                    let _e172 = (bitcast<u32>(_e170) & 2147483647u);
                    let _e177 = global_4.member[_e153].member_2[2u];
                    let _e179 = (bitcast<u32>(_e177) & 2147483647u);
                    let _e184 = global_4.member[_e153].member[0u];
                    let _e186 = (bitcast<u32>(_e184) & 2147483647u);
                    let _e191 = global_4.member[_e153].member[1u];
                    let _e193 = (bitcast<u32>(_e191) & 2147483647u);
                    let _e198 = global_4.member[_e153].member[2u];
                    let _e200 = (bitcast<u32>(_e198) & 2147483647u);
                    let _e202 = select(_e172, _e165, (_e172 < _e165));
                    let _e204 = select(_e179, _e202, (_e179 < _e202));
                    let _e206 = select(_e186, _e204, (_e186 < _e204));
                    let _e208 = select(_e193, _e206, (_e193 < _e206));
                    let _e210 = select(_e200, _e208, (_e200 < _e208));
                    let _e214 = global_4.member[_e153].member_1;
                    let _e215 = bitcast<u32>(_e214);
                    let _e216 = (_e215 & 2147483647u);
                    let _e223 = global_4.member[_e153].member_3;
                    let _e224 = bitcast<u32>(_e223);
                    let _e225 = (_e224 & 2147483647u);
                    let _e229 = (((select(_e216, _e210, (_e216 < _e210)) < 2139095040u) && (_e225 <= 2139095040u)) && (_e204 > 0u));
                    if _e229 {
                        let _e232 = (bitcast<u32>(bitcast<f32>(_e204)) & 2147483647u);
                        if (_e232 >= 8388608u) {
                            phi_391_ = (bitcast<i32>((_e232 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_391_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e232)), 32u, (_e232 == 0u))));
                        }
                        let _e246 = phi_391_;
                        phi_392_ = _e246;
                    } else {
                        phi_392_ = 0i;
                    }
                    let _e248 = phi_392_;
                    let _e249 = (_e165 == _e204);
                    if _e249 {
                        phi_402_ = true;
                    } else {
                        phi_402_ = (_e172 == _e204);
                    }
                    let _e252 = phi_402_;
                    let _e253 = select(1u, 0u, _e249);
                    if _e252 {
                        let _e254 = (_e253 + 1u);
                        phi_412_ = _e254;
                        phi_413_ = _e254;
                        phi_415_ = select(true, false, (_e254 == 2u));
                    } else {
                        phi_412_ = u32();
                        phi_413_ = 0u;
                        phi_415_ = true;
                    }
                    let _e258 = phi_412_;
                    let _e260 = phi_413_;
                    let _e262 = phi_415_;
                    if _e262 {
                        phi_420_ = (_e260 + 1u);
                    } else {
                        phi_420_ = 0u;
                    }
                    let _e266 = phi_420_;
                    let _e267 = select(_e258, _e260, _e262);
                    let _e268 = select(_e253, select(2u, _e253, _e252), _e262);
                    if (_e135 < -126i) {
                        phi_432_ = -126i;
                    } else {
                        phi_432_ = select(_e135, 127i, (_e135 > 127i));
                    }
                    let _e273 = phi_432_;
                    let _e278 = bitcast<f32>((bitcast<u32>((_e273 + 127i)) << bitcast<u32>(23i)));
                    let _e284 = bitcast<f32>((bitcast<u32>(((_e135 - _e273) + 127i)) << bitcast<u32>(23i)));
                    let _e285 = -(_e248);
                    if (_e285 < -126i) {
                        phi_452_ = -126i;
                    } else {
                        phi_452_ = select(_e285, 127i, (_e285 > 127i));
                    }
                    let _e290 = phi_452_;
                    let _e295 = bitcast<f32>((bitcast<u32>((_e290 + 127i)) << bitcast<u32>(23i)));
                    let _e301 = bitcast<f32>((bitcast<u32>(((_e285 - _e290) + 127i)) << bitcast<u32>(23i)));
                    let _e305 = global_4.member[_e153].member;
                    let _e306 = (_e267 == 0u);
                    if _e306 {
                        phi_470_ = _e305[0];
                    } else {
                        phi_470_ = _e305[1];
                    }
                    let _e310 = phi_470_;
                    let _e311 = (_e267 == 2u);
                    if _e311 {
                        phi_476_ = _e305[2];
                    } else {
                        phi_476_ = _e310;
                    }
                    let _e314 = phi_476_;
                    let _e315 = bitcast<u32>(_e314);
                    let _e317 = ((_e315 & 2139095040u) != 0u);
                    let _e331 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e315 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e315 & 2147483648u))), _e314, _e317) * _e278) * select(0.00000011920929f, 1f, _e317)) * _e284);
                    let _e332 = global_4.member[_e153].member_2;
                    if _e306 {
                        phi_516_ = _e332[0];
                    } else {
                        phi_516_ = _e332[1];
                    }
                    let _e336 = phi_516_;
                    if _e311 {
                        phi_522_ = _e332[2];
                    } else {
                        phi_522_ = _e336;
                    }
                    let _e339 = phi_522_;
                    let _e340 = bitcast<u32>(_e339);
                    let _e342 = ((_e340 & 2139095040u) != 0u);
                    let _e356 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e340 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e340 & 2147483648u))), _e339, _e342) * _e295) * select(0.00000011920929f, 1f, _e342)) * _e301);
                    let _e360 = (bitcast<f32>((bitcast<u32>(_e356) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e360 {
                        let _e364 = (bitcast<f32>((bitcast<u32>(_e331) & 2147483647u)) * 0.00000011920929f);
                        phi_574_ = select(0.00000000000011368684f, _e364, (_e364 > 0.00000000000011368684f));
                    } else {
                        phi_574_ = 0f;
                    }
                    let _e368 = phi_574_;
                    let _e369 = (_e331 + _e368);
                    let _e370 = (_e331 - _e368);
                    let _e371 = select(_e356, 0f, _e360);
                    if _e360 {
                        phi_585_ = 38685626000000000000000000f;
                    } else {
                        phi_585_ = (1f / _e356);
                    }
                    let _e374 = phi_585_;
                    let _e375 = (_e266 == 0u);
                    if _e375 {
                        phi_594_ = _e305[0];
                    } else {
                        phi_594_ = _e305[1];
                    }
                    let _e379 = phi_594_;
                    let _e380 = (_e266 == 2u);
                    if _e380 {
                        phi_600_ = _e305[2];
                    } else {
                        phi_600_ = _e379;
                    }
                    let _e383 = phi_600_;
                    let _e384 = bitcast<u32>(_e383);
                    let _e386 = ((_e384 & 2139095040u) != 0u);
                    let _e400 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e384 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e384 & 2147483648u))), _e383, _e386) * _e278) * select(0.00000011920929f, 1f, _e386)) * _e284);
                    if _e375 {
                        phi_640_ = _e332[0];
                    } else {
                        phi_640_ = _e332[1];
                    }
                    let _e404 = phi_640_;
                    if _e380 {
                        phi_646_ = _e332[2];
                    } else {
                        phi_646_ = _e404;
                    }
                    let _e407 = phi_646_;
                    let _e408 = bitcast<u32>(_e407);
                    let _e410 = ((_e408 & 2139095040u) != 0u);
                    let _e424 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e408 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e408 & 2147483648u))), _e407, _e410) * _e295) * select(0.00000011920929f, 1f, _e410)) * _e301);
                    let _e428 = (bitcast<f32>((bitcast<u32>(_e424) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e428 {
                        let _e432 = (bitcast<f32>((bitcast<u32>(_e400) & 2147483647u)) * 0.00000011920929f);
                        phi_698_ = select(0.00000000000011368684f, _e432, (_e432 > 0.00000000000011368684f));
                    } else {
                        phi_698_ = 0f;
                    }
                    let _e436 = phi_698_;
                    let _e437 = (_e400 + _e436);
                    let _e438 = (_e400 - _e436);
                    let _e439 = select(_e424, 0f, _e428);
                    if _e428 {
                        phi_709_ = 38685626000000000000000000f;
                    } else {
                        phi_709_ = (1f / _e424);
                    }
                    let _e442 = phi_709_;
                    let _e443 = (_e268 == 0u);
                    if _e443 {
                        phi_718_ = _e305[0];
                    } else {
                        phi_718_ = _e305[1];
                    }
                    let _e447 = phi_718_;
                    let _e448 = (_e268 == 2u);
                    if _e448 {
                        phi_724_ = _e305[2];
                    } else {
                        phi_724_ = _e447;
                    }
                    let _e451 = phi_724_;
                    let _e452 = bitcast<u32>(_e451);
                    let _e454 = ((_e452 & 2139095040u) != 0u);
                    let _e468 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e452 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e452 & 2147483648u))), _e451, _e454) * _e278) * select(0.00000011920929f, 1f, _e454)) * _e284);
                    if _e443 {
                        phi_764_ = _e332[0];
                    } else {
                        phi_764_ = _e332[1];
                    }
                    let _e472 = phi_764_;
                    if _e448 {
                        phi_770_ = _e332[2];
                    } else {
                        phi_770_ = _e472;
                    }
                    let _e475 = phi_770_;
                    let _e476 = bitcast<u32>(_e475);
                    let _e478 = ((_e476 & 2139095040u) != 0u);
                    let _e492 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e476 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e476 & 2147483648u))), _e475, _e478) * _e295) * select(0.00000011920929f, 1f, _e478)) * _e301);
                    let _e496 = (bitcast<f32>((bitcast<u32>(_e492) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e496 {
                        let _e500 = (bitcast<f32>((bitcast<u32>(_e468) & 2147483647u)) * 0.00000011920929f);
                        phi_822_ = select(0.00000000000011368684f, _e500, (_e500 > 0.00000000000011368684f));
                    } else {
                        phi_822_ = 0f;
                    }
                    let _e504 = phi_822_;
                    let _e505 = (_e468 + _e504);
                    let _e506 = (_e468 - _e504);
                    let _e507 = select(_e492, 0f, _e496);
                    if _e496 {
                        phi_833_ = 38685626000000000000000000f;
                    } else {
                        phi_833_ = (1f / _e492);
                    }
                    let _e510 = phi_833_;
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
                            phi_888_ = 255i;
                        } else {
                            phi_888_ = (((_e537 + select(0i, 1i, (_e537 == 0i))) - _e544) + _e524);
                        }
                        let _e552 = phi_888_;
                        let _e562 = (_e552 <= 0i);
                        if _e562 {
                            phi_911_ = u32();
                        } else {
                            if _e541 {
                                phi_910_ = u32();
                            } else {
                                phi_910_ = select(((bitcast<u32>(_e552) << bitcast<u32>(23i)) | ((_e534 << bitcast<u32>(((_e544 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e552 >= 255i));
                            }
                            let _e566 = phi_910_;
                            phi_911_ = _e566;
                        }
                        let _e568 = phi_911_;
                        let _e580 = ((_e225 & 8388607u) | (select(0u, 1u, ((_e225 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                        let _e583 = bitcast<i32>((_e225 >> bitcast<u32>(23i)));
                        let _e587 = (_e580 == 0u);
                        let _e590 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e580)), 32u, _e587)) - 8i);
                        if (_e583 == 255i) {
                            phi_948_ = 255i;
                        } else {
                            phi_948_ = (((_e583 + select(0i, 1i, (_e583 == 0i))) - _e590) + _e524);
                        }
                        let _e598 = phi_948_;
                        let _e608 = (_e598 <= 0i);
                        if _e608 {
                            phi_971_ = u32();
                        } else {
                            if _e587 {
                                phi_970_ = u32();
                            } else {
                                phi_970_ = select(((bitcast<u32>(_e598) << bitcast<u32>(23i)) | ((_e580 << bitcast<u32>(((_e590 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e598 >= 255i));
                            }
                            let _e612 = phi_970_;
                            phi_971_ = _e612;
                        }
                        let _e614 = phi_971_;
                        phi_979_ = bitcast<f32>(((_e224 & 2147483648u) | select(_e614, 0u, select(_e587, true, _e608))));
                        phi_980_ = bitcast<f32>(((_e215 & 2147483648u) | select(_e568, 0u, select(_e541, true, _e562))));
                    } else {
                        phi_979_ = 0f;
                        phi_980_ = 1f;
                    }
                    let _e620 = phi_979_;
                    let _e622 = phi_980_;
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
                    phi_4258_ = false;
                    phi_1069_ = type_38(_e620, false);
                    phi_1072_ = type_45(type_28(vec4<f32>((f32(_e629) * _e147), (f32(_e635) * _e147), (f32(_e641) * _e147), 0f), vec4<f32>((f32(_e646) * _e147), (f32(_e650) * _e147), (f32(_e654) * _e147), 0f)), select(0u, 2147483648u, (_e96 == 0u)));
                    phi_1074_ = ((3u * _e96) + 1u);
                    phi_1076_ = (_e622 <= _e620);
                    phi_1078_ = 0u;
                    loop {
                        let _e664 = phi_4258_;
                        let _e666 = phi_1069_;
                        let _e668 = phi_1072_;
                        let _e670 = phi_1074_;
                        let _e672 = phi_1076_;
                        let _e674 = phi_1078_;
                        local_11 = _e666;
                        if _e672 {
                            phi_1089_ = true;
                        } else {
                            phi_1089_ = (_e674 > 0u);
                        }
                        let _e677 = phi_1089_;
                        if _e677 {
                            let _e678 = (_e670 > 0u);
                            if _e678 {
                                if _e672 {
                                    phi_1175_ = _e668;
                                    phi_1176_ = _e672;
                                    phi_1177_ = _e674;
                                } else {
                                    let _e679 = (_e674 - 1u);
                                    let _e680 = (_e679 % 128u);
                                    let _e681 = (_e680 < 128u);
                                    if _e681 {
                                    } else {
                                        phi_4456_ = true;
                                        break;
                                    }
                                    let _e683 = local_7[_e680];
                                    if _e681 {
                                    } else {
                                        phi_4456_ = true;
                                        break;
                                    }
                                    let _e685 = local_6[_e680];
                                    if _e681 {
                                    } else {
                                        phi_4456_ = true;
                                        break;
                                    }
                                    let _e687 = local_5[_e680];
                                    if _e681 {
                                    } else {
                                        phi_4456_ = true;
                                        break;
                                    }
                                    let _e689 = local_4[_e680];
                                    if _e681 {
                                    } else {
                                        phi_4456_ = true;
                                        break;
                                    }
                                    let _e691 = local_3[_e680];
                                    if _e681 {
                                    } else {
                                        phi_4456_ = true;
                                        break;
                                    }
                                    let _e693 = local_2[_e680];
                                    if _e681 {
                                    } else {
                                        phi_4456_ = true;
                                        break;
                                    }
                                    let _e698 = local_8[_e680];
                                    if _e681 {
                                    } else {
                                        phi_4456_ = true;
                                        break;
                                    }
                                    let _e701 = local_9[_e680];
                                    phi_1175_ = type_45(type_28(vec4<f32>(_e683, _e685, _e687, 0f), vec4<f32>(_e689, _e691, _e693, 0f)), _e698);
                                    phi_1176_ = (_e701 <= _e666.member);
                                    phi_1177_ = _e679;
                                }
                                let _e705 = phi_1175_;
                                let _e707 = phi_1176_;
                                let _e709 = phi_1177_;
                                if _e707 {
                                    let _e714 = (_e705.member_1 & 268435455u);
                                    if ((_e705.member_1 & 2147483648u) != 0u) {
                                        phi_1196_ = _e666;
                                        phi_1199_ = type_8(0u, ((_e705.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e1180 = phi_1196_;
                                            let _e1182 = phi_1199_;
                                            local_10 = _e1180;
                                            local_12 = _e1180;
                                            if (_e1182.member < _e1182.member_1) {
                                                phi_1200_ = type_8((_e1182.member + 1u), _e1182.member_1);
                                                phi_1222_ = type_8(1u, _e1182.member);
                                            } else {
                                                phi_1200_ = _e1182;
                                                phi_1222_ = type_8(0u, type_8().member_1);
                                            }
                                            let _e1195 = phi_1200_;
                                            let _e1197 = phi_1222_;
                                            let _e1201 = (bitcast<i32>(_e1197.member) != 0i);
                                            if _e1201 {
                                                let _e1206 = (_e705.member.member_1.x - _e705.member.member.x);
                                                let _e1209 = (_e705.member.member_1.y - _e705.member.member.y);
                                                let _e1212 = (_e705.member.member_1.z - _e705.member.member.z);
                                                let _e1214 = select(_e1209, _e1206, (_e1206 > _e1209));
                                                let _e1216 = select(_e1212, _e1214, (_e1214 > _e1212));
                                                let _e1218 = (_e1216 < (1024f * _e147));
                                                if _e1218 {
                                                    phi_1263_ = 0u;
                                                } else {
                                                    phi_1263_ = select(2u, 1u, (_e1216 < (2097152f * _e147)));
                                                }
                                                let _e1223 = phi_1263_;
                                                switch bitcast<i32>(_e1223) {
                                                    case 0: {
                                                        phi_1269_ = 1u;
                                                        break;
                                                    }
                                                    case 1: {
                                                        phi_1269_ = 2u;
                                                        break;
                                                    }
                                                    case 2: {
                                                        phi_1269_ = 3u;
                                                        break;
                                                    }
                                                    default: {
                                                        phi_1269_ = u32();
                                                        break;
                                                    }
                                                }
                                                let _e1226 = phi_1269_;
                                                switch bitcast<i32>(_e1223) {
                                                    case 0: {
                                                        phi_1279_ = 1u;
                                                        break;
                                                    }
                                                    case 1: {
                                                        phi_1279_ = 2u;
                                                        break;
                                                    }
                                                    case 2: {
                                                        phi_1279_ = 3u;
                                                        break;
                                                    }
                                                    default: {
                                                        phi_1279_ = u32();
                                                        break;
                                                    }
                                                }
                                                let _e1233 = phi_1279_;
                                                let _e1235 = ((_e714 + (_e1197.member_1 * ((3u * _e1226) + 1u))) + (3u * _e1233));
                                                let _e1236 = (_e1235 < _e99);
                                                if _e1236 {
                                                    if _e1236 {
                                                    } else {
                                                        phi_4252_ = true;
                                                        break;
                                                    }
                                                    let _e1238 = global_6.member[_e1235];
                                                    phi_1295_ = _e1238;
                                                } else {
                                                    phi_1295_ = 4294967295u;
                                                }
                                                let _e1240 = phi_1295_;
                                                if _e1218 {
                                                    phi_1328_ = 0u;
                                                } else {
                                                    phi_1328_ = select(2u, 1u, (_e1216 < (2097152f * _e147)));
                                                }
                                                let _e1245 = phi_1328_;
                                                switch bitcast<i32>(_e1245) {
                                                    case 0: {
                                                        phi_1334_ = 1u;
                                                        break;
                                                    }
                                                    case 1: {
                                                        phi_1334_ = 2u;
                                                        break;
                                                    }
                                                    case 2: {
                                                        phi_1334_ = 3u;
                                                        break;
                                                    }
                                                    default: {
                                                        phi_1334_ = u32();
                                                        break;
                                                    }
                                                }
                                                let _e1248 = phi_1334_;
                                                let _e1252 = (_e714 + (_e1197.member_1 * ((3u * _e1248) + 1u)));
                                                switch bitcast<i32>(_e1245) {
                                                    case 0: {
                                                        let _e1527 = (_e1252 < _e99);
                                                        if _e1527 {
                                                            if _e1527 {
                                                            } else {
                                                                phi_4252_ = true;
                                                                break;
                                                            }
                                                            let _e1529 = global_6.member[_e1252];
                                                            phi_1358_ = _e1529;
                                                        } else {
                                                            phi_1358_ = 0u;
                                                        }
                                                        let _e1531 = phi_1358_;
                                                        let _e1533 = ((10u * _e267) & 31u);
                                                        let _e1543 = ((10u * _e266) & 31u);
                                                        let _e1553 = ((10u * _e268) & 31u);
                                                        let _e1563 = (_e1252 + 1u);
                                                        let _e1564 = (_e1563 < _e99);
                                                        if _e1564 {
                                                            if _e1564 {
                                                            } else {
                                                                phi_4252_ = true;
                                                                break;
                                                            }
                                                            let _e1566 = global_6.member[_e1563];
                                                            phi_1404_ = _e1566;
                                                        } else {
                                                            phi_1404_ = 0u;
                                                        }
                                                        let _e1568 = phi_1404_;
                                                        let _e1594 = (_e1252 + 2u);
                                                        let _e1595 = (_e1594 < _e99);
                                                        if _e1595 {
                                                            if _e1595 {
                                                            } else {
                                                                phi_4252_ = true;
                                                                break;
                                                            }
                                                            let _e1597 = global_6.member[_e1594];
                                                            phi_1450_ = _e1597;
                                                        } else {
                                                            phi_1450_ = 0u;
                                                        }
                                                        let _e1599 = phi_1450_;
                                                        phi_1933_ = array<array<f32, 3>, 3>(array<f32, 3>((_e705.member.member.x + ((bitcast<f32>((1258291200u | ((_e1531 >> bitcast<u32>(_e1533)) & 1023u))) - 8388608f) * _e147)), (_e705.member.member.y + ((bitcast<f32>((1258291200u | ((_e1531 >> bitcast<u32>(_e1543)) & 1023u))) - 8388608f) * _e147)), (_e705.member.member.z + ((bitcast<f32>((1258291200u | ((_e1531 >> bitcast<u32>(_e1553)) & 1023u))) - 8388608f) * _e147))), array<f32, 3>((_e705.member.member.x + ((bitcast<f32>((1258291200u | ((_e1568 >> bitcast<u32>(_e1533)) & 1023u))) - 8388608f) * _e147)), (_e705.member.member.y + ((bitcast<f32>((1258291200u | ((_e1568 >> bitcast<u32>(_e1543)) & 1023u))) - 8388608f) * _e147)), (_e705.member.member.z + ((bitcast<f32>((1258291200u | ((_e1568 >> bitcast<u32>(_e1553)) & 1023u))) - 8388608f) * _e147))), array<f32, 3>((_e705.member.member.x + ((bitcast<f32>((1258291200u | ((_e1599 >> bitcast<u32>(_e1533)) & 1023u))) - 8388608f) * _e147)), (_e705.member.member.y + ((bitcast<f32>((1258291200u | ((_e1599 >> bitcast<u32>(_e1543)) & 1023u))) - 8388608f) * _e147)), (_e705.member.member.z + ((bitcast<f32>((1258291200u | ((_e1599 >> bitcast<u32>(_e1553)) & 1023u))) - 8388608f) * _e147))));
                                                        break;
                                                    }
                                                    case 1: {
                                                        let _e1341 = (_e1252 < _e99);
                                                        if _e1341 {
                                                            if _e1341 {
                                                            } else {
                                                                phi_4252_ = true;
                                                                break;
                                                            }
                                                            let _e1343 = global_6.member[_e1252];
                                                            phi_1496_ = _e1343;
                                                        } else {
                                                            phi_1496_ = 0u;
                                                        }
                                                        let _e1345 = phi_1496_;
                                                        let _e1346 = (_e1252 + 1u);
                                                        let _e1347 = (_e1346 < _e99);
                                                        if _e1347 {
                                                            if _e1347 {
                                                            } else {
                                                                phi_4252_ = true;
                                                                break;
                                                            }
                                                            let _e1349 = global_6.member[_e1346];
                                                            phi_1511_ = _e1349;
                                                        } else {
                                                            phi_1511_ = 0u;
                                                        }
                                                        let _e1351 = phi_1511_;
                                                        let _e1352 = (_e267 == 1u);
                                                        if _e1352 {
                                                            phi_1521_ = ((_e1345 >> bitcast<u32>(21i)) | (_e1351 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1521_ = (_e1351 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1361 = phi_1521_;
                                                        let _e1369 = (_e266 == 1u);
                                                        if _e1369 {
                                                            phi_1542_ = ((_e1345 >> bitcast<u32>(21i)) | (_e1351 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1542_ = (_e1351 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1378 = phi_1542_;
                                                        let _e1386 = (_e268 == 1u);
                                                        if _e1386 {
                                                            phi_1563_ = ((_e1345 >> bitcast<u32>(21i)) | (_e1351 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1563_ = (_e1351 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1395 = phi_1563_;
                                                        let _e1404 = (_e1252 + 2u);
                                                        let _e1405 = (_e1404 < _e99);
                                                        if _e1405 {
                                                            if _e1405 {
                                                            } else {
                                                                phi_4252_ = true;
                                                                break;
                                                            }
                                                            let _e1407 = global_6.member[_e1404];
                                                            phi_1590_ = _e1407;
                                                        } else {
                                                            phi_1590_ = 0u;
                                                        }
                                                        let _e1409 = phi_1590_;
                                                        let _e1410 = (_e1252 + 3u);
                                                        let _e1411 = (_e1410 < _e99);
                                                        if _e1411 {
                                                            if _e1411 {
                                                            } else {
                                                                phi_4252_ = true;
                                                                break;
                                                            }
                                                            let _e1413 = global_6.member[_e1410];
                                                            phi_1605_ = _e1413;
                                                        } else {
                                                            phi_1605_ = 0u;
                                                        }
                                                        let _e1415 = phi_1605_;
                                                        if _e1352 {
                                                            phi_1615_ = ((_e1409 >> bitcast<u32>(21i)) | (_e1415 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1615_ = (_e1415 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1424 = phi_1615_;
                                                        if _e1369 {
                                                            phi_1636_ = ((_e1409 >> bitcast<u32>(21i)) | (_e1415 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1636_ = (_e1415 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1440 = phi_1636_;
                                                        if _e1386 {
                                                            phi_1657_ = ((_e1409 >> bitcast<u32>(21i)) | (_e1415 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1657_ = (_e1415 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1456 = phi_1657_;
                                                        let _e1465 = (_e1252 + 4u);
                                                        let _e1466 = (_e1465 < _e99);
                                                        if _e1466 {
                                                            if _e1466 {
                                                            } else {
                                                                phi_4252_ = true;
                                                                break;
                                                            }
                                                            let _e1468 = global_6.member[_e1465];
                                                            phi_1684_ = _e1468;
                                                        } else {
                                                            phi_1684_ = 0u;
                                                        }
                                                        let _e1470 = phi_1684_;
                                                        let _e1471 = (_e1252 + 5u);
                                                        let _e1472 = (_e1471 < _e99);
                                                        if _e1472 {
                                                            if _e1472 {
                                                            } else {
                                                                phi_4252_ = true;
                                                                break;
                                                            }
                                                            let _e1474 = global_6.member[_e1471];
                                                            phi_1699_ = _e1474;
                                                        } else {
                                                            phi_1699_ = 0u;
                                                        }
                                                        let _e1476 = phi_1699_;
                                                        if _e1352 {
                                                            phi_1709_ = ((_e1470 >> bitcast<u32>(21i)) | (_e1476 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1709_ = (_e1476 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1485 = phi_1709_;
                                                        if _e1369 {
                                                            phi_1730_ = ((_e1470 >> bitcast<u32>(21i)) | (_e1476 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1730_ = (_e1476 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1501 = phi_1730_;
                                                        if _e1386 {
                                                            phi_1751_ = ((_e1470 >> bitcast<u32>(21i)) | (_e1476 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1751_ = (_e1476 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1517 = phi_1751_;
                                                        phi_1933_ = array<array<f32, 3>, 3>(array<f32, 3>((_e705.member.member.x + ((bitcast<f32>((1258291200u | (select(_e1361, _e1345, _e306) & 2097151u))) - 8388608f) * _e147)), (_e705.member.member.y + ((bitcast<f32>((1258291200u | (select(_e1378, _e1345, _e375) & 2097151u))) - 8388608f) * _e147)), (_e705.member.member.z + ((bitcast<f32>((1258291200u | (select(_e1395, _e1345, _e443) & 2097151u))) - 8388608f) * _e147))), array<f32, 3>((_e705.member.member.x + ((bitcast<f32>((1258291200u | (select(_e1424, _e1409, _e306) & 2097151u))) - 8388608f) * _e147)), (_e705.member.member.y + ((bitcast<f32>((1258291200u | (select(_e1440, _e1409, _e375) & 2097151u))) - 8388608f) * _e147)), (_e705.member.member.z + ((bitcast<f32>((1258291200u | (select(_e1456, _e1409, _e443) & 2097151u))) - 8388608f) * _e147))), array<f32, 3>((_e705.member.member.x + ((bitcast<f32>((1258291200u | (select(_e1485, _e1470, _e306) & 2097151u))) - 8388608f) * _e147)), (_e705.member.member.y + ((bitcast<f32>((1258291200u | (select(_e1501, _e1470, _e375) & 2097151u))) - 8388608f) * _e147)), (_e705.member.member.z + ((bitcast<f32>((1258291200u | (select(_e1517, _e1470, _e443) & 2097151u))) - 8388608f) * _e147))));
                                                        break;
                                                    }
                                                    case 2: {
                                                        let _e1254 = (_e1252 + _e267);
                                                        let _e1255 = (_e1254 < _e99);
                                                        if _e1255 {
                                                            if _e1255 {
                                                            } else {
                                                                phi_4252_ = true;
                                                                break;
                                                            }
                                                            let _e1257 = global_6.member[_e1254];
                                                            phi_1779_ = _e1257;
                                                        } else {
                                                            phi_1779_ = 0u;
                                                        }
                                                        let _e1259 = phi_1779_;
                                                        let _e1263 = (_e1252 + _e266);
                                                        let _e1264 = (_e1263 < _e99);
                                                        if _e1264 {
                                                            if _e1264 {
                                                            } else {
                                                                phi_4252_ = true;
                                                                break;
                                                            }
                                                            let _e1266 = global_6.member[_e1263];
                                                            phi_1797_ = _e1266;
                                                        } else {
                                                            phi_1797_ = 0u;
                                                        }
                                                        let _e1268 = phi_1797_;
                                                        let _e1272 = (_e1252 + _e268);
                                                        let _e1273 = (_e1272 < _e99);
                                                        if _e1273 {
                                                            if _e1273 {
                                                            } else {
                                                                phi_4252_ = true;
                                                                break;
                                                            }
                                                            let _e1275 = global_6.member[_e1272];
                                                            phi_1815_ = _e1275;
                                                        } else {
                                                            phi_1815_ = 0u;
                                                        }
                                                        let _e1277 = phi_1815_;
                                                        let _e1282 = (_e1252 + 3u);
                                                        let _e1283 = (_e1282 + _e267);
                                                        let _e1284 = (_e1283 < _e99);
                                                        if _e1284 {
                                                            if _e1284 {
                                                            } else {
                                                                phi_4252_ = true;
                                                                break;
                                                            }
                                                            let _e1286 = global_6.member[_e1283];
                                                            phi_1835_ = _e1286;
                                                        } else {
                                                            phi_1835_ = 0u;
                                                        }
                                                        let _e1288 = phi_1835_;
                                                        let _e1292 = (_e1282 + _e266);
                                                        let _e1293 = (_e1292 < _e99);
                                                        if _e1293 {
                                                            if _e1293 {
                                                            } else {
                                                                phi_4252_ = true;
                                                                break;
                                                            }
                                                            let _e1295 = global_6.member[_e1292];
                                                            phi_1853_ = _e1295;
                                                        } else {
                                                            phi_1853_ = 0u;
                                                        }
                                                        let _e1297 = phi_1853_;
                                                        let _e1301 = (_e1282 + _e268);
                                                        let _e1302 = (_e1301 < _e99);
                                                        if _e1302 {
                                                            if _e1302 {
                                                            } else {
                                                                phi_4252_ = true;
                                                                break;
                                                            }
                                                            let _e1304 = global_6.member[_e1301];
                                                            phi_1871_ = _e1304;
                                                        } else {
                                                            phi_1871_ = 0u;
                                                        }
                                                        let _e1306 = phi_1871_;
                                                        let _e1311 = (_e1252 + 6u);
                                                        let _e1312 = (_e1311 + _e267);
                                                        let _e1313 = (_e1312 < _e99);
                                                        if _e1313 {
                                                            if _e1313 {
                                                            } else {
                                                                phi_4252_ = true;
                                                                break;
                                                            }
                                                            let _e1315 = global_6.member[_e1312];
                                                            phi_1891_ = _e1315;
                                                        } else {
                                                            phi_1891_ = 0u;
                                                        }
                                                        let _e1317 = phi_1891_;
                                                        let _e1321 = (_e1311 + _e266);
                                                        let _e1322 = (_e1321 < _e99);
                                                        if _e1322 {
                                                            if _e1322 {
                                                            } else {
                                                                phi_4252_ = true;
                                                                break;
                                                            }
                                                            let _e1324 = global_6.member[_e1321];
                                                            phi_1909_ = _e1324;
                                                        } else {
                                                            phi_1909_ = 0u;
                                                        }
                                                        let _e1326 = phi_1909_;
                                                        let _e1330 = (_e1311 + _e268);
                                                        let _e1331 = (_e1330 < _e99);
                                                        if _e1331 {
                                                            if _e1331 {
                                                            } else {
                                                                phi_4252_ = true;
                                                                break;
                                                            }
                                                            let _e1333 = global_6.member[_e1330];
                                                            phi_1927_ = _e1333;
                                                        } else {
                                                            phi_1927_ = 0u;
                                                        }
                                                        let _e1335 = phi_1927_;
                                                        phi_1933_ = array<array<f32, 3>, 3>(array<f32, 3>((f32(bitcast<i32>(_e1259)) * _e147), (f32(bitcast<i32>(_e1268)) * _e147), (f32(bitcast<i32>(_e1277)) * _e147)), array<f32, 3>((f32(bitcast<i32>(_e1288)) * _e147), (f32(bitcast<i32>(_e1297)) * _e147), (f32(bitcast<i32>(_e1306)) * _e147)), array<f32, 3>((f32(bitcast<i32>(_e1317)) * _e147), (f32(bitcast<i32>(_e1326)) * _e147), (f32(bitcast<i32>(_e1335)) * _e147)));
                                                        break;
                                                    }
                                                    default: {
                                                        phi_1933_ = array<array<f32, 3>, 3>();
                                                        break;
                                                    }
                                                }
                                                let _e1627 = phi_1933_;
                                                let _e1635 = (_e1627[0][2] - _e468);
                                                let _e1638 = (((_e1627[0][0] - _e331) * _e507) - (_e1635 * _e371));
                                                let _e1641 = (((_e1627[0][1] - _e400) * _e507) - (_e1635 * _e439));
                                                let _e1648 = (_e1627[1][2] - _e468);
                                                let _e1651 = (((_e1627[1][0] - _e331) * _e507) - (_e1648 * _e371));
                                                let _e1654 = (((_e1627[1][1] - _e400) * _e507) - (_e1648 * _e439));
                                                let _e1661 = (_e1627[2][2] - _e468);
                                                let _e1664 = (((_e1627[2][0] - _e331) * _e507) - (_e1661 * _e371));
                                                let _e1667 = (((_e1627[2][1] - _e400) * _e507) - (_e1661 * _e439));
                                                let _e1668 = (_e1664 * _e1654);
                                                let _e1669 = (_e1667 * _e1651);
                                                let _e1670 = (_e1638 * _e1667);
                                                let _e1671 = (_e1641 * _e1664);
                                                let _e1672 = (_e1651 * _e1641);
                                                let _e1673 = (_e1654 * _e1638);
                                                let _e1678 = (((_e1668 >= _e1669) && (_e1670 >= _e1671)) && (_e1672 >= _e1673));
                                                if (_e1678 || (((_e1668 <= _e1669) && (_e1670 <= _e1671)) && (_e1672 <= _e1673))) {
                                                    let _e1685 = select(-1f, 1f, _e1678);
                                                    let _e1687 = ((_e1668 - _e1669) * _e1685);
                                                    let _e1689 = select(0f, _e1687, (_e1687 > 0f));
                                                    let _e1691 = ((_e1670 - _e1671) * _e1685);
                                                    let _e1693 = select(0f, _e1691, (_e1691 > 0f));
                                                    let _e1695 = ((_e1672 - _e1673) * _e1685);
                                                    let _e1697 = select(0f, _e1695, (_e1695 > 0f));
                                                    let _e1699 = ((_e1689 + _e1693) + _e1697);
                                                    if (_e1699 < 0.000000000000000000000000000000000000011754944f) {
                                                        phi_2758_ = type_24();
                                                        phi_2759_ = true;
                                                        phi_2760_ = false;
                                                    } else {
                                                        let _e1702 = select(_e1651, _e1638, (_e1638 < _e1651));
                                                        if (select(_e1664, _e1702, (_e1702 < _e1664)) > 0f) {
                                                            phi_2050_ = true;
                                                        } else {
                                                            let _e1707 = select(_e1651, _e1638, (_e1638 > _e1651));
                                                            phi_2050_ = (select(_e1664, _e1707, (_e1707 > _e1664)) < 0f);
                                                        }
                                                        let _e1712 = phi_2050_;
                                                        if _e1712 {
                                                            phi_2755_ = type_24();
                                                            phi_2756_ = true;
                                                            phi_2757_ = false;
                                                        } else {
                                                            let _e1714 = select(_e1654, _e1641, (_e1641 < _e1654));
                                                            if (select(_e1667, _e1714, (_e1714 < _e1667)) > 0f) {
                                                                phi_2079_ = true;
                                                            } else {
                                                                let _e1719 = select(_e1654, _e1641, (_e1641 > _e1654));
                                                                phi_2079_ = (select(_e1667, _e1719, (_e1719 > _e1667)) < 0f);
                                                            }
                                                            let _e1724 = phi_2079_;
                                                            if _e1724 {
                                                                phi_2753_ = type_24();
                                                                phi_2754_ = false;
                                                            } else {
                                                                let _e1726 = select(_e1627[1][0], _e1627[0][0], (_e1627[0][0] < _e1627[1][0]));
                                                                let _e1730 = select(_e1627[1][0], _e1627[0][0], (_e1627[0][0] > _e1627[1][0]));
                                                                let _e1734 = select(_e1627[1][1], _e1627[0][1], (_e1627[0][1] < _e1627[1][1]));
                                                                let _e1738 = select(_e1627[1][1], _e1627[0][1], (_e1627[0][1] > _e1627[1][1]));
                                                                let _e1742 = select(_e1627[1][2], _e1627[0][2], (_e1627[0][2] < _e1627[1][2]));
                                                                let _e1746 = select(_e1627[1][2], _e1627[0][2], (_e1627[0][2] > _e1627[1][2]));
                                                                let _e1751 = ((select(_e1627[2][0], _e1726, (_e1726 < _e1627[2][0])) - _e369) * _e374);
                                                                let _e1752 = ((select(_e1627[2][0], _e1730, (_e1730 > _e1627[2][0])) - _e370) * _e374);
                                                                let _e1755 = ((select(_e1627[2][1], _e1734, (_e1734 < _e1627[2][1])) - _e437) * _e442);
                                                                let _e1756 = ((select(_e1627[2][1], _e1738, (_e1738 > _e1627[2][1])) - _e438) * _e442);
                                                                let _e1759 = ((select(_e1627[2][2], _e1742, (_e1742 < _e1627[2][2])) - _e505) * _e510);
                                                                let _e1760 = ((select(_e1627[2][2], _e1746, (_e1746 > _e1627[2][2])) - _e506) * _e510);
                                                                let _e1762 = select(_e1760, _e1759, (_e1759 < _e1760));
                                                                let _e1764 = select(_e1760, _e1759, (_e1759 > _e1760));
                                                                let _e1766 = select(_e1752, _e1751, (_e1751 < _e1752));
                                                                let _e1768 = select(_e1756, _e1755, (_e1755 < _e1756));
                                                                let _e1770 = select(_e1768, _e1766, (_e1766 > _e1768));
                                                                let _e1772 = select(_e1762, _e1770, (_e1770 > _e1762));
                                                                let _e1774 = select(_e1752, _e1751, (_e1751 > _e1752));
                                                                let _e1776 = select(_e1756, _e1755, (_e1755 > _e1756));
                                                                let _e1778 = select(_e1776, _e1774, (_e1774 < _e1776));
                                                                let _e1780 = select(_e1764, _e1778, (_e1778 < _e1764));
                                                                let _e1781 = -(_e1762);
                                                                let _e1787 = select(_e622, _e1772, (_e1772 > _e622));
                                                                if (_e1787 > (_e1780 + (select(_e1781, _e1764, (_e1764 > _e1781)) * 0.0000019073523f))) {
                                                                    phi_2748_ = type_24();
                                                                    phi_2749_ = true;
                                                                } else {
                                                                    let _e1789 = (_e1787 > _e1180.member);
                                                                    if _e1789 {
                                                                        phi_2747_ = type_24();
                                                                    } else {
                                                                        let _e1790 = vec3<f32>(_e1627[0][0], _e1627[0][1], _e1627[0][2]);
                                                                        let _e1791 = vec3<f32>(_e1627[1][0], _e1627[1][1], _e1627[1][2]);
                                                                        let _e1792 = vec3<f32>(_e1627[2][0], _e1627[2][1], _e1627[2][2]);
                                                                        let _e1793 = (_e1627[1][0] - _e1627[0][0]);
                                                                        let _e1794 = (_e1627[1][1] - _e1627[0][1]);
                                                                        let _e1795 = (_e1627[1][2] - _e1627[0][2]);
                                                                        let _e1796 = vec3<f32>(_e1793, _e1794, _e1795);
                                                                        let _e1797 = (_e1627[2][0] - _e1627[1][0]);
                                                                        let _e1798 = (_e1627[2][1] - _e1627[1][1]);
                                                                        let _e1799 = (_e1627[2][2] - _e1627[1][2]);
                                                                        let _e1800 = vec3<f32>(_e1797, _e1798, _e1799);
                                                                        let _e1801 = (_e1627[0][0] - _e1627[2][0]);
                                                                        let _e1802 = (_e1627[0][1] - _e1627[2][1]);
                                                                        let _e1803 = (_e1627[0][2] - _e1627[2][2]);
                                                                        let _e1804 = vec3<f32>(_e1801, _e1802, _e1803);
                                                                        let _e1807 = bitcast<f32>((bitcast<u32>(_e1793) & 2147483647u));
                                                                        let _e1810 = bitcast<f32>((bitcast<u32>(_e1794) & 2147483647u));
                                                                        let _e1812 = select(_e1810, _e1807, (_e1807 > _e1810));
                                                                        let _e1815 = bitcast<f32>((bitcast<u32>(_e1795) & 2147483647u));
                                                                        let _e1817 = select(_e1815, _e1812, (_e1812 > _e1815));
                                                                        let _e1820 = bitcast<f32>((bitcast<u32>(_e1797) & 2147483647u));
                                                                        let _e1823 = bitcast<f32>((bitcast<u32>(_e1798) & 2147483647u));
                                                                        let _e1825 = select(_e1823, _e1820, (_e1820 > _e1823));
                                                                        let _e1828 = bitcast<f32>((bitcast<u32>(_e1799) & 2147483647u));
                                                                        let _e1830 = select(_e1828, _e1825, (_e1825 > _e1828));
                                                                        let _e1833 = bitcast<f32>((bitcast<u32>(_e1801) & 2147483647u));
                                                                        let _e1836 = bitcast<f32>((bitcast<u32>(_e1802) & 2147483647u));
                                                                        let _e1838 = select(_e1836, _e1833, (_e1833 > _e1836));
                                                                        let _e1841 = bitcast<f32>((bitcast<u32>(_e1803) & 2147483647u));
                                                                        let _e1843 = select(_e1841, _e1838, (_e1838 > _e1841));
                                                                        let _e1845 = select(_e1830, _e1817, (_e1817 > _e1830));
                                                                        let _e1847 = select(_e1843, _e1845, (_e1845 > _e1843));
                                                                        if (_e1817 == _e1847) {
                                                                            phi_2480_ = _e1654;
                                                                            phi_2481_ = _e1651;
                                                                            phi_2482_ = _e1641;
                                                                            phi_2483_ = _e1638;
                                                                            phi_2484_ = _e1790;
                                                                            phi_2485_ = _e1804;
                                                                            phi_2486_ = _e1800;
                                                                            phi_2487_ = _e1796;
                                                                        } else {
                                                                            let _e1849 = (_e1830 == _e1847);
                                                                            let _e1854 = vec3(_e1849);
                                                                            phi_2480_ = select(_e1641, _e1667, _e1849);
                                                                            phi_2481_ = select(_e1638, _e1664, _e1849);
                                                                            phi_2482_ = select(_e1667, _e1654, _e1849);
                                                                            phi_2483_ = select(_e1664, _e1651, _e1849);
                                                                            phi_2484_ = select(_e1792, _e1791, _e1854);
                                                                            phi_2485_ = select(_e1800, _e1796, _e1854);
                                                                            phi_2486_ = select(_e1796, _e1804, _e1854);
                                                                            phi_2487_ = select(_e1804, _e1800, _e1854);
                                                                        }
                                                                        let _e1860 = phi_2480_;
                                                                        let _e1862 = phi_2481_;
                                                                        let _e1864 = phi_2482_;
                                                                        let _e1866 = phi_2483_;
                                                                        let _e1868 = phi_2484_;
                                                                        let _e1870 = phi_2485_;
                                                                        let _e1872 = phi_2486_;
                                                                        let _e1874 = phi_2487_;
                                                                        let _e1881 = ((_e1872.y * _e1870.z) - (_e1870.y * _e1872.z));
                                                                        let _e1886 = ((_e1872.z * _e1870.x) - (_e1870.z * _e1872.x));
                                                                        let _e1889 = ((_e1872.x * _e1870.y) - (_e1870.x * _e1872.y));
                                                                        if (_e1689 >= _e1693) {
                                                                            phi_2518_ = select(true, false, (_e1689 >= _e1697));
                                                                        } else {
                                                                            phi_2518_ = true;
                                                                        }
                                                                        let _e1894 = phi_2518_;
                                                                        if _e1894 {
                                                                            phi_2527_ = select(_e1792, _e1791, vec3((_e1693 >= _e1697)));
                                                                        } else {
                                                                            phi_2527_ = _e1790;
                                                                        }
                                                                        let _e1899 = phi_2527_;
                                                                        let _e1910 = (((_e1881 * (_e1899.x - _e331)) + (_e1886 * (_e1899.y - _e400))) + (_e1889 * (_e1899.z - _e468)));
                                                                        let _e1915 = (((_e1881 * _e371) + (_e1886 * _e439)) + (_e1889 * _e507));
                                                                        let _e1916 = (_e1862 - _e1866);
                                                                        let _e1917 = (_e1860 - _e1864);
                                                                        let _e1925 = (-(((_e1866 * _e1916) + (_e1864 * _e1917))) / ((_e1916 * _e1916) + (_e1917 * _e1917)));
                                                                        let _e1927 = select(1f, _e1925, (_e1925 < 1f));
                                                                        let _e1929 = select(0f, _e1927, (_e1927 > 0f));
                                                                        let _e1942 = ((_e1868.x + (_e1874.x * _e1929)) - _e331);
                                                                        let _e1943 = ((_e1868.y + (_e1874.y * _e1929)) - _e400);
                                                                        let _e1944 = ((_e1868.z + (_e1874.z * _e1929)) - _e468);
                                                                        let _e1945 = (_e1944 / _e507);
                                                                        let _e1957 = bitcast<f32>((bitcast<u32>(_e1942) & 2147483647u));
                                                                        let _e1960 = bitcast<f32>((bitcast<u32>(_e1943) & 2147483647u));
                                                                        let _e1962 = select(_e1960, _e1957, (_e1957 > _e1960));
                                                                        let _e1965 = bitcast<f32>((bitcast<u32>(_e1944) & 2147483647u));
                                                                        let _e1967 = select(_e1965, _e1962, (_e1962 > _e1965));
                                                                        let _e1973 = bitcast<f32>((bitcast<u32>(_e1881) & 2147483647u));
                                                                        let _e1976 = bitcast<f32>((bitcast<u32>(_e1886) & 2147483647u));
                                                                        let _e1978 = select(_e1976, _e1973, (_e1973 > _e1976));
                                                                        let _e1981 = bitcast<f32>((bitcast<u32>(_e1889) & 2147483647u));
                                                                        if (bitcast<f32>((bitcast<u32>(((((_e1881 * _e1942) + (_e1886 * _e1943)) + (_e1889 * _e1944)) - _e1910)) & 2147483647u)) <= ((0.0000009536743f * select(_e1847, _e1967, (_e1967 > _e1847))) * select(_e1981, _e1978, (_e1978 > _e1981)))) {
                                                                            let _e1991 = bitcast<f32>((bitcast<u32>(_e1872.x) & 2147483647u));
                                                                            let _e1994 = bitcast<f32>((bitcast<u32>(_e1872.y) & 2147483647u));
                                                                            let _e1996 = select(_e1994, _e1991, (_e1991 > _e1994));
                                                                            let _e1999 = bitcast<f32>((bitcast<u32>(_e1872.z) & 2147483647u));
                                                                            let _e2005 = bitcast<f32>((bitcast<u32>(_e1870.x) & 2147483647u));
                                                                            let _e2008 = bitcast<f32>((bitcast<u32>(_e1870.y) & 2147483647u));
                                                                            let _e2010 = select(_e2008, _e2005, (_e2005 > _e2008));
                                                                            let _e2013 = bitcast<f32>((bitcast<u32>(_e1870.z) & 2147483647u));
                                                                            let _e2017 = (bitcast<f32>((bitcast<u32>(_e1915) & 2147483647u)) > ((0.0000038146973f * select(_e1999, _e1996, (_e1996 > _e1999))) * select(_e2013, _e2010, (_e2010 > _e2013))));
                                                                            if _e2017 {
                                                                                phi_2692_ = (_e1910 / _e1915);
                                                                            } else {
                                                                                phi_2692_ = f32();
                                                                            }
                                                                            let _e2020 = phi_2692_;
                                                                            phi_2694_ = _e2020;
                                                                            phi_2695_ = select(true, false, _e2017);
                                                                        } else {
                                                                            phi_2694_ = f32();
                                                                            phi_2695_ = true;
                                                                        }
                                                                        let _e2023 = phi_2694_;
                                                                        let _e2025 = phi_2695_;
                                                                        if _e2025 {
                                                                            let _e2033 = (((_e1881 * (_e1942 - (_e371 * _e1945))) + (_e1886 * (_e1943 - (_e439 * _e1945)))) / _e1915);
                                                                            if (bitcast<f32>((bitcast<u32>(_e2033) & 2147483647u)) <= _e1847) {
                                                                                phi_2715_ = (_e1945 + _e2033);
                                                                            } else {
                                                                                phi_2715_ = _e1945;
                                                                            }
                                                                            let _e2040 = phi_2715_;
                                                                            phi_2716_ = _e2040;
                                                                        } else {
                                                                            phi_2716_ = _e2023;
                                                                        }
                                                                        let _e2042 = phi_2716_;
                                                                        let _e2044 = select(_e1780, _e2042, (_e2042 < _e1780));
                                                                        let _e2046 = select(_e1772, _e2044, (_e2044 > _e1772));
                                                                        if (_e2046 >= _e622) {
                                                                            let _e2048 = (_e2046 <= _e1180.member);
                                                                            if _e2048 {
                                                                                let _e2049 = (1f / _e1699);
                                                                                phi_2739_ = type_24(_e2046, (_e1693 * _e2049), (_e1697 * _e2049), _e1240);
                                                                            } else {
                                                                                phi_2739_ = type_24();
                                                                            }
                                                                            let _e2054 = phi_2739_;
                                                                            phi_2741_ = _e2054;
                                                                            phi_2742_ = select(true, false, _e2048);
                                                                        } else {
                                                                            phi_2741_ = type_24();
                                                                            phi_2742_ = true;
                                                                        }
                                                                        let _e2057 = phi_2741_;
                                                                        let _e2059 = phi_2742_;
                                                                        if _e2059 {
                                                                            phi_2746_ = type_24(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                        } else {
                                                                            phi_2746_ = _e2057;
                                                                        }
                                                                        let _e2061 = phi_2746_;
                                                                        phi_2747_ = _e2061;
                                                                    }
                                                                    let _e2063 = phi_2747_;
                                                                    phi_2748_ = _e2063;
                                                                    phi_2749_ = _e1789;
                                                                }
                                                                let _e2065 = phi_2748_;
                                                                let _e2067 = phi_2749_;
                                                                phi_2753_ = _e2065;
                                                                phi_2754_ = _e2067;
                                                            }
                                                            let _e2069 = phi_2753_;
                                                            let _e2071 = phi_2754_;
                                                            phi_2755_ = _e2069;
                                                            phi_2756_ = _e1724;
                                                            phi_2757_ = _e2071;
                                                        }
                                                        let _e2073 = phi_2755_;
                                                        let _e2075 = phi_2756_;
                                                        let _e2077 = phi_2757_;
                                                        phi_2758_ = _e2073;
                                                        phi_2759_ = _e2075;
                                                        phi_2760_ = _e2077;
                                                    }
                                                    let _e2079 = phi_2758_;
                                                    let _e2081 = phi_2759_;
                                                    let _e2083 = phi_2760_;
                                                    phi_2768_ = _e2079;
                                                    phi_2769_ = select(_e2083, true, _e2081);
                                                } else {
                                                    phi_2768_ = type_24();
                                                    phi_2769_ = true;
                                                }
                                                let _e2086 = phi_2768_;
                                                let _e2088 = phi_2769_;
                                                if _e2088 {
                                                    phi_2773_ = type_24(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                } else {
                                                    phi_2773_ = _e2086;
                                                }
                                                let _e2090 = phi_2773_;
                                                if (_e2090.member_3 != 4294967295u) {
                                                    if (_e1240 != 4294967295u) {
                                                        phi_2784_ = type_38(_e1180.member, true);
                                                    } else {
                                                        phi_2784_ = _e1180;
                                                    }
                                                    let _e2098 = phi_2784_;
                                                    phi_2785_ = _e2098;
                                                } else {
                                                    phi_2785_ = _e1180;
                                                }
                                                let _e2100 = phi_2785_;
                                                phi_1197_ = _e2100;
                                            } else {
                                                phi_1197_ = type_38();
                                            }
                                            let _e2102 = phi_1197_;
                                            continue;
                                            continuing {
                                                phi_1196_ = _e2102;
                                                phi_1199_ = _e1195;
                                                phi_4252_ = _e664;
                                                break if !(_e1201);
                                            }
                                        }
                                        let _e2105 = phi_4252_;
                                        phi_4456_ = _e2105;
                                        if _e2105 {
                                            break;
                                        }
                                        let _e2107 = local_10;
                                        phi_4460_ = _e2105;
                                        let _e2313 = local_12;
                                        phi_4026_ = _e2313;
                                        phi_4027_ = _e705;
                                        phi_4028_ = false;
                                        phi_4029_ = select(_e709, 0u, _e2107.member_1);
                                    } else {
                                        if (_e705.member_1 >= _e96) {
                                            phi_3582_ = type_46(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), type_45(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u), type_45(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u));
                                        } else {
                                            if (_e705.member_1 < _e96) {
                                            } else {
                                                phi_4456_ = true;
                                                break;
                                            }
                                            let _e722 = ((1u + _e267) % 4u);
                                            if (_e722 < 4u) {
                                            } else {
                                                phi_4456_ = true;
                                                break;
                                            }
                                            let _e727 = global_3.member[_e705.member_1][_e722];
                                            let _e729 = (_e727 >> bitcast<u32>(11u));
                                            let _e731 = ((1u + _e266) % 4u);
                                            if (_e731 < 4u) {
                                            } else {
                                                phi_4456_ = true;
                                                break;
                                            }
                                            let _e736 = global_3.member[_e705.member_1][_e731];
                                            let _e738 = (_e736 >> bitcast<u32>(11u));
                                            let _e740 = ((1u + _e268) % 4u);
                                            if (_e740 < 4u) {
                                            } else {
                                                phi_4456_ = true;
                                                break;
                                            }
                                            let _e745 = global_3.member[_e705.member_1][_e740];
                                            let _e747 = (_e745 >> bitcast<u32>(11u));
                                            let _e770 = (bitcast<f32>((bitcast<u32>((_e705.member.member_1.x - _e705.member.member.x)) & 2139095040u)) * 0.001953125f);
                                            let _e771 = (bitcast<f32>((bitcast<u32>((_e705.member.member_1.y - _e705.member.member.y)) & 2139095040u)) * 0.001953125f);
                                            let _e772 = (bitcast<f32>((bitcast<u32>((_e705.member.member_1.z - _e705.member.member.z)) & 2139095040u)) * 0.001953125f);
                                            let _e774 = select(_e147, _e770, (_e770 > _e147));
                                            let _e776 = select(_e147, _e771, (_e771 > _e147));
                                            let _e778 = select(_e147, _e772, (_e772 > _e147));
                                            let _e809 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e727 & 1023u))) - 8388608f) * _e774));
                                            let _e814 = (bitcast<i32>((_e727 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e817 = bitcast<f32>((_e809 & bitcast<u32>(_e814)));
                                            let _e818 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e736 & 1023u))) - 8388608f) * _e776));
                                            let _e823 = (bitcast<i32>((_e736 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e826 = bitcast<f32>((_e818 & bitcast<u32>(_e823)));
                                            let _e827 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e745 & 1023u))) - 8388608f) * _e778));
                                            let _e832 = (bitcast<i32>((_e745 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e835 = bitcast<f32>((_e827 & bitcast<u32>(_e832)));
                                            let _e839 = bitcast<f32>((_e809 & bitcast<u32>(~(_e814))));
                                            let _e843 = bitcast<f32>((_e818 & bitcast<u32>(~(_e823))));
                                            let _e847 = bitcast<f32>((_e827 & bitcast<u32>(~(_e832))));
                                            let _e848 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e729 & 1023u))) - 8388608f) * _e774));
                                            let _e853 = (bitcast<i32>((_e729 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e856 = bitcast<f32>((_e848 & bitcast<u32>(_e853)));
                                            let _e857 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e738 & 1023u))) - 8388608f) * _e776));
                                            let _e862 = (bitcast<i32>((_e738 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e865 = bitcast<f32>((_e857 & bitcast<u32>(_e862)));
                                            let _e866 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e747 & 1023u))) - 8388608f) * _e778));
                                            let _e871 = (bitcast<i32>((_e747 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e874 = bitcast<f32>((_e866 & bitcast<u32>(_e871)));
                                            let _e878 = bitcast<f32>((_e848 & bitcast<u32>(~(_e853))));
                                            let _e882 = bitcast<f32>((_e857 & bitcast<u32>(~(_e862))));
                                            let _e886 = bitcast<f32>((_e866 & bitcast<u32>(~(_e871))));
                                            let _e887 = (_e705.member.member.x + _e817);
                                            let _e888 = (_e705.member.member.y + _e826);
                                            let _e889 = (_e705.member.member.z + _e835);
                                            let _e892 = (_e705.member.member_1.x - _e856);
                                            let _e893 = (_e705.member.member_1.y - _e865);
                                            let _e894 = (_e705.member.member_1.z - _e874);
                                            let _e913 = (_e892 - _e887);
                                            let _e914 = (_e893 - _e888);
                                            let _e915 = (_e894 - _e889);
                                            let _e917 = select(_e914, _e913, (_e913 > _e914));
                                            let _e919 = select(_e915, _e917, (_e917 > _e915));
                                            if (_e919 < (1024f * _e147)) {
                                                phi_3283_ = 0u;
                                            } else {
                                                phi_3283_ = select(2u, 1u, (_e919 < (2097152f * _e147)));
                                            }
                                            let _e926 = phi_3283_;
                                            switch bitcast<i32>(_e926) {
                                                case 0: {
                                                    phi_3289_ = 1u;
                                                    break;
                                                }
                                                case 1: {
                                                    phi_3289_ = 2u;
                                                    break;
                                                }
                                                case 2: {
                                                    phi_3289_ = 3u;
                                                    break;
                                                }
                                                default: {
                                                    phi_3289_ = u32();
                                                    break;
                                                }
                                            }
                                            let _e929 = phi_3289_;
                                            let _e935 = global_3.member[_e705.member_1][0u];
                                            let _e939 = global_3.member[_e705.member_1][1u];
                                            let _e943 = global_3.member[_e705.member_1][2u];
                                            let _e947 = global_3.member[_e705.member_1][3u];
                                            let _e959 = (((_e939 >> bitcast<u32>(22i)) | ((_e943 >> bitcast<u32>(22i)) << bitcast<u32>(10i))) | ((_e947 >> bitcast<u32>(22i)) << bitcast<u32>(20i)));
                                            let _e960 = (_e935 & 268435455u);
                                            let _e961 = (_e959 & 268435455u);
                                            let _e964 = ((_e935 >> bitcast<u32>(28u)) & 7u);
                                            let _e972 = ((_e935 >> bitcast<u32>(31i)) | (((_e959 >> bitcast<u32>(28u)) & 3u) << bitcast<u32>(1i)));
                                            let _e973 = (_e964 != 0u);
                                            if (_e964 == 0u) {
                                                phi_3544_ = _e960;
                                            } else {
                                                if (_e964 == 7u) {
                                                    phi_3543_ = 2147483648u;
                                                } else {
                                                    phi_3543_ = ((2147483648u | (_e964 << bitcast<u32>(28u))) | (_e961 & 268435455u));
                                                }
                                                let _e982 = phi_3543_;
                                                phi_3544_ = _e982;
                                            }
                                            let _e984 = phi_3544_;
                                            if _e973 {
                                                let _e985 = (_e964 != 7u);
                                                if _e985 {
                                                    phi_3554_ = (_e961 + (_e964 * ((3u * _e929) + 1u)));
                                                } else {
                                                    phi_3554_ = u32();
                                                }
                                                let _e989 = phi_3554_;
                                                phi_3556_ = _e989;
                                                phi_3557_ = select(true, false, _e985);
                                            } else {
                                                phi_3556_ = u32();
                                                phi_3557_ = true;
                                            }
                                            let _e992 = phi_3556_;
                                            let _e994 = phi_3557_;
                                            if (_e972 == 0u) {
                                                phi_3578_ = (_e960 + select(0u, 1u, !(_e973)));
                                            } else {
                                                if (_e972 == 7u) {
                                                    phi_3577_ = 2147483648u;
                                                } else {
                                                    phi_3577_ = ((2147483648u | (_e972 << bitcast<u32>(28u))) | (select(_e992, _e961, _e994) & 268435455u));
                                                }
                                                let _e1007 = phi_3577_;
                                                phi_3578_ = _e1007;
                                            }
                                            let _e1009 = phi_3578_;
                                            phi_3582_ = type_46(array<vec4<f32>, 3>(vec4<f32>(_e887, (_e705.member.member.x + _e839), _e892, (_e705.member.member_1.x - _e878)), vec4<f32>(_e888, (_e705.member.member.y + _e843), _e893, (_e705.member.member_1.y - _e882)), vec4<f32>(_e889, (_e705.member.member.z + _e847), _e894, (_e705.member.member_1.z - _e886))), type_45(type_28((_e705.member.member + vec4<f32>(_e817, _e826, _e835, 0f)), (_e705.member.member_1 - vec4<f32>(_e856, _e865, _e874, 0f))), _e984), type_45(type_28((_e705.member.member + vec4<f32>(_e839, _e843, _e847, 0f)), (_e705.member.member_1 - vec4<f32>(_e878, _e882, _e886, 0f))), _e1009));
                                        }
                                        let _e1014 = phi_3582_;
                                        let _e1026 = ((_e1014.member[0].x - _e369) * _e374);
                                        let _e1027 = ((_e1014.member[0].y - _e369) * _e374);
                                        let _e1028 = ((_e1014.member[0].z - _e370) * _e374);
                                        let _e1029 = ((_e1014.member[0].w - _e370) * _e374);
                                        let _e1039 = ((_e1014.member[1].x - _e437) * _e442);
                                        let _e1040 = ((_e1014.member[1].y - _e437) * _e442);
                                        let _e1041 = ((_e1014.member[1].z - _e438) * _e442);
                                        let _e1042 = ((_e1014.member[1].w - _e438) * _e442);
                                        let _e1052 = ((_e1014.member[2].x - _e505) * _e510);
                                        let _e1053 = ((_e1014.member[2].y - _e505) * _e510);
                                        let _e1054 = ((_e1014.member[2].z - _e506) * _e510);
                                        let _e1055 = ((_e1014.member[2].w - _e506) * _e510);
                                        let _e1057 = select(_e1054, _e1052, (_e1052 < _e1054));
                                        let _e1059 = select(_e1055, _e1053, (_e1053 < _e1055));
                                        let _e1061 = select(_e1054, _e1052, (_e1052 > _e1054));
                                        let _e1063 = select(_e1055, _e1053, (_e1053 > _e1055));
                                        let _e1065 = select(_e1028, _e1026, (_e1026 < _e1028));
                                        let _e1067 = select(_e1029, _e1027, (_e1027 < _e1029));
                                        let _e1069 = select(_e1041, _e1039, (_e1039 < _e1041));
                                        let _e1071 = select(_e1042, _e1040, (_e1040 < _e1042));
                                        let _e1073 = select(_e1069, _e1065, (_e1065 > _e1069));
                                        let _e1075 = select(_e1071, _e1067, (_e1067 > _e1071));
                                        let _e1077 = select(_e1057, _e1073, (_e1073 > _e1057));
                                        let _e1079 = select(_e1059, _e1075, (_e1075 > _e1059));
                                        let _e1081 = select(_e1028, _e1026, (_e1026 > _e1028));
                                        let _e1083 = select(_e1029, _e1027, (_e1027 > _e1029));
                                        let _e1085 = select(_e1041, _e1039, (_e1039 > _e1041));
                                        let _e1087 = select(_e1042, _e1040, (_e1040 > _e1042));
                                        let _e1089 = select(_e1085, _e1081, (_e1081 < _e1085));
                                        let _e1091 = select(_e1087, _e1083, (_e1083 < _e1087));
                                        let _e1096 = -(_e1057);
                                        let _e1097 = -(_e1059);
                                        let _e1104 = (select(_e1061, _e1089, (_e1089 < _e1061)) + (select(_e1096, _e1061, (_e1061 > _e1096)) * 0.0000019073523f));
                                        let _e1105 = (select(_e1063, _e1091, (_e1091 < _e1063)) + (select(_e1097, _e1063, (_e1063 > _e1097)) * 0.0000019073523f));
                                        let _e1107 = select(_e622, _e1077, (_e1077 > _e622));
                                        let _e1109 = select(_e622, _e1079, (_e1079 > _e622));
                                        let _e1114 = (_e1107 <= select(_e666.member, _e1104, (_e1104 < _e666.member)));
                                        let _e1115 = (_e1109 <= select(_e666.member, _e1105, (_e1105 < _e666.member)));
                                        let _e1116 = (_e1107 <= _e1109);
                                        if _e1114 {
                                            if _e1115 {
                                                if _e1116 {
                                                    phi_3926_ = _e1014.member_2;
                                                } else {
                                                    phi_3926_ = _e1014.member_1;
                                                }
                                                let _e1120 = phi_3926_;
                                                let _e1142 = (_e709 % 128u);
                                                let _e1143 = (_e1142 < 128u);
                                                if _e1143 {
                                                } else {
                                                    phi_4456_ = true;
                                                    break;
                                                }
                                                local_8[_e1142] = _e1120.member_1;
                                                if _e1143 {
                                                } else {
                                                    phi_4456_ = true;
                                                    break;
                                                }
                                                local_7[_e1142] = _e1120.member.member.x;
                                                if _e1143 {
                                                } else {
                                                    phi_4456_ = true;
                                                    break;
                                                }
                                                local_6[_e1142] = _e1120.member.member.y;
                                                if _e1143 {
                                                } else {
                                                    phi_4456_ = true;
                                                    break;
                                                }
                                                local_5[_e1142] = _e1120.member.member.z;
                                                if _e1143 {
                                                } else {
                                                    phi_4456_ = true;
                                                    break;
                                                }
                                                local_4[_e1142] = _e1120.member.member_1.x;
                                                if _e1143 {
                                                } else {
                                                    phi_4456_ = true;
                                                    break;
                                                }
                                                local_3[_e1142] = _e1120.member.member_1.y;
                                                if _e1143 {
                                                } else {
                                                    phi_4456_ = true;
                                                    break;
                                                }
                                                local_2[_e1142] = _e1120.member.member_1.z;
                                                if _e1143 {
                                                } else {
                                                    phi_4456_ = true;
                                                    break;
                                                }
                                                local_9[_e1142] = select(_e1109, _e1107, (_e1107 > _e1109));
                                                if _e1116 {
                                                    phi_4003_ = _e1014.member_1;
                                                } else {
                                                    phi_4003_ = _e1014.member_2;
                                                }
                                                let _e1156 = phi_4003_;
                                                phi_4004_ = _e1156;
                                                phi_4005_ = (_e709 + 1u);
                                            } else {
                                                phi_4004_ = type_45();
                                                phi_4005_ = u32();
                                            }
                                            let _e1158 = phi_4004_;
                                            let _e1160 = phi_4005_;
                                            phi_4007_ = _e1158;
                                            phi_4008_ = _e1160;
                                            phi_4009_ = select(true, false, _e1115);
                                        } else {
                                            phi_4007_ = type_45();
                                            phi_4008_ = u32();
                                            phi_4009_ = true;
                                        }
                                        let _e1163 = phi_4007_;
                                        let _e1165 = phi_4008_;
                                        let _e1167 = phi_4009_;
                                        if _e1167 {
                                            if _e1114 {
                                                phi_4018_ = _e1014.member_1;
                                            } else {
                                                phi_4018_ = _e1014.member_2;
                                            }
                                            let _e1171 = phi_4018_;
                                            phi_4023_ = _e1171;
                                            phi_4024_ = select(_e1115, true, _e1114);
                                        } else {
                                            phi_4023_ = _e1163;
                                            phi_4024_ = _e707;
                                        }
                                        let _e1174 = phi_4023_;
                                        let _e1176 = phi_4024_;
                                        phi_4460_ = _e664;
                                        phi_4026_ = _e666;
                                        phi_4027_ = _e1174;
                                        phi_4028_ = _e1176;
                                        phi_4029_ = select(_e1165, _e709, _e1167);
                                    }
                                    let _e2111 = phi_4460_;
                                    let _e2113 = phi_4026_;
                                    let _e2115 = phi_4027_;
                                    let _e2117 = phi_4028_;
                                    let _e2119 = phi_4029_;
                                    phi_4459_ = _e2111;
                                    phi_4030_ = _e2113;
                                    phi_4031_ = _e2115;
                                    phi_4032_ = (_e670 - 1u);
                                    phi_4033_ = _e2117;
                                    phi_4034_ = _e2119;
                                } else {
                                    phi_4459_ = _e664;
                                    phi_4030_ = _e666;
                                    phi_4031_ = _e705;
                                    phi_4032_ = _e670;
                                    phi_4033_ = _e707;
                                    phi_4034_ = _e709;
                                }
                                let _e2121 = phi_4459_;
                                let _e2123 = phi_4030_;
                                let _e2125 = phi_4031_;
                                let _e2127 = phi_4032_;
                                let _e2129 = phi_4033_;
                                let _e2131 = phi_4034_;
                                phi_4458_ = _e2121;
                                phi_4035_ = _e2123;
                                phi_4036_ = _e2125;
                                phi_4037_ = _e2127;
                                phi_4038_ = _e2129;
                                phi_4039_ = _e2131;
                            } else {
                                phi_4458_ = _e664;
                                phi_4035_ = type_38();
                                phi_4036_ = type_45();
                                phi_4037_ = u32();
                                phi_4038_ = bool();
                                phi_4039_ = u32();
                            }
                            let _e2133 = phi_4458_;
                            let _e2135 = phi_4035_;
                            let _e2137 = phi_4036_;
                            let _e2139 = phi_4037_;
                            let _e2141 = phi_4038_;
                            let _e2143 = phi_4039_;
                            phi_4457_ = _e2133;
                            phi_1070_ = _e2135;
                            phi_1073_ = _e2137;
                            phi_1075_ = _e2139;
                            phi_1077_ = _e2141;
                            phi_1079_ = _e2143;
                            phi_4040_ = _e678;
                        } else {
                            phi_4457_ = _e664;
                            phi_1070_ = type_38();
                            phi_1073_ = type_45();
                            phi_1075_ = u32();
                            phi_1077_ = bool();
                            phi_1079_ = u32();
                            phi_4040_ = false;
                        }
                        let _e2145 = phi_4457_;
                        let _e2147 = phi_1070_;
                        let _e2149 = phi_1073_;
                        let _e2151 = phi_1075_;
                        let _e2153 = phi_1077_;
                        let _e2155 = phi_1079_;
                        let _e2157 = phi_4040_;
                        continue;
                        continuing {
                            phi_4258_ = _e2145;
                            phi_1069_ = _e2147;
                            phi_1072_ = _e2149;
                            phi_1074_ = _e2151;
                            phi_1076_ = _e2153;
                            phi_1078_ = _e2155;
                            phi_4456_ = _e2145;
                            break if !(_e2157);
                        }
                    }
                    let _e2160 = phi_4456_;
                    if _e2160 {
                        break;
                    }
                    let _e2162 = local_11;
                    if _e155 {
                    } else {
                        break;
                    }
                    global_5.member[_e153] = select(0u, 1u, _e2162.member_1);
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn trace_any_q10_lattice(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
