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
    member: array<array<u32, 2>>,
}

struct type_28 {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: u32,
}

struct type_29 {
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
    member: type_28,
    member_1: f32,
}

struct type_41 {
    member: array<type_29>,
}

struct type_43 {
    member: type_37,
    member_1: u32,
    member_2: u32,
}

struct type_45 {
    member: array<vec4<u32>, 2>,
}

struct type_50 {
    member: type_32,
    member_1: u32,
}

struct type_51 {
    member: array<vec4<f32>, 3>,
    member_1: type_50,
    member_2: type_50,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_1: type_16;
@group(0) @binding(1) 
var<uniform> global_2: type_45;
@group(0) @binding(2) 
var<storage> global_3: type_13;
@group(0) @binding(4) 
var<storage> global_4: type_41;
@group(0) @binding(3) 
var<storage> global_5: type_4;
@group(0) @binding(5) 
var<storage, read_write> global_6: type_24;

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
    var phi_404_: i32;
    var phi_405_: i32;
    var phi_415_: bool;
    var phi_425_: u32;
    var phi_426_: u32;
    var phi_428_: bool;
    var phi_433_: u32;
    var phi_446_: i32;
    var phi_466_: i32;
    var phi_484_: f32;
    var phi_490_: f32;
    var phi_530_: f32;
    var phi_536_: f32;
    var phi_588_: f32;
    var phi_600_: f32;
    var phi_609_: f32;
    var phi_615_: f32;
    var phi_655_: f32;
    var phi_661_: f32;
    var phi_713_: f32;
    var phi_725_: f32;
    var phi_734_: f32;
    var phi_740_: f32;
    var phi_780_: f32;
    var phi_786_: f32;
    var phi_838_: f32;
    var phi_850_: f32;
    var phi_905_: i32;
    var phi_927_: u32;
    var phi_928_: u32;
    var phi_965_: i32;
    var phi_987_: u32;
    var phi_988_: u32;
    var phi_996_: f32;
    var phi_997_: f32;
    var phi_4431_: bool;
    var phi_1094_: type_43;
    var phi_1097_: bool;
    var phi_1099_: u32;
    var phi_1101_: u32;
    var phi_1103_: type_50;
    var phi_1114_: bool;
    var phi_1200_: bool;
    var phi_1201_: u32;
    var phi_1202_: type_50;
    var phi_3429_: u32;
    var phi_3435_: u32;
    var phi_3689_: u32;
    var phi_3690_: u32;
    var phi_3700_: u32;
    var phi_3702_: u32;
    var phi_3703_: bool;
    var phi_3723_: u32;
    var phi_3724_: u32;
    var phi_3728_: type_51;
    var phi_4093_: type_50;
    var phi_4170_: type_50;
    var phi_4171_: u32;
    var phi_4172_: type_50;
    var phi_4174_: u32;
    var phi_4175_: type_50;
    var phi_4176_: bool;
    var phi_4185_: type_50;
    var phi_4190_: bool;
    var phi_4192_: type_50;
    var phi_1221_: type_43;
    var phi_1224_: type_8;
    var phi_1225_: type_8;
    var phi_1247_: type_8;
    var phi_1291_: u32;
    var phi_1297_: u32;
    var phi_1307_: u32;
    var phi_1323_: u32;
    var phi_1356_: u32;
    var phi_1362_: u32;
    var phi_1828_: u32;
    var phi_1846_: u32;
    var phi_1864_: u32;
    var phi_1887_: u32;
    var phi_1905_: u32;
    var phi_1923_: u32;
    var phi_1946_: u32;
    var phi_1964_: u32;
    var phi_1982_: u32;
    var phi_1536_: u32;
    var phi_1551_: u32;
    var phi_1561_: u32;
    var phi_1582_: u32;
    var phi_1603_: u32;
    var phi_1633_: u32;
    var phi_1648_: u32;
    var phi_1658_: u32;
    var phi_1679_: u32;
    var phi_1700_: u32;
    var phi_1730_: u32;
    var phi_1745_: u32;
    var phi_1755_: u32;
    var phi_1776_: u32;
    var phi_1797_: u32;
    var phi_1389_: u32;
    var phi_1438_: u32;
    var phi_1487_: u32;
    var phi_1988_: array<array<f32, 3>, 3>;
    var phi_2140_: bool;
    var phi_2169_: bool;
    var phi_2588_: f32;
    var phi_2589_: f32;
    var phi_2590_: f32;
    var phi_2591_: f32;
    var phi_2592_: vec3<f32>;
    var phi_2593_: vec3<f32>;
    var phi_2594_: vec3<f32>;
    var phi_2595_: vec3<f32>;
    var phi_2632_: bool;
    var phi_2641_: vec3<f32>;
    var phi_2806_: f32;
    var phi_2808_: f32;
    var phi_2809_: bool;
    var phi_2829_: f32;
    var phi_2830_: f32;
    var phi_2853_: type_28;
    var phi_2855_: type_28;
    var phi_2856_: bool;
    var phi_2860_: type_28;
    var phi_2861_: type_28;
    var phi_2862_: type_28;
    var phi_2863_: bool;
    var phi_2867_: type_28;
    var phi_2868_: bool;
    var phi_2869_: type_28;
    var phi_2870_: bool;
    var phi_2871_: bool;
    var phi_2872_: type_28;
    var phi_2873_: bool;
    var phi_2874_: bool;
    var phi_2882_: type_28;
    var phi_2883_: bool;
    var phi_2887_: type_28;
    var phi_2912_: bool;
    var phi_2913_: bool;
    var phi_2920_: type_43;
    var phi_2921_: type_43;
    var phi_2922_: type_43;
    var phi_1222_: type_43;
    var phi_4425_: bool;
    var phi_4636_: bool;
    var phi_4197_: type_43;
    var phi_4198_: bool;
    var phi_4199_: u32;
    var phi_4200_: type_50;
    var phi_4635_: bool;
    var phi_4201_: type_43;
    var phi_4202_: bool;
    var phi_4203_: u32;
    var phi_4204_: u32;
    var phi_4205_: type_50;
    var phi_4634_: bool;
    var phi_4206_: type_43;
    var phi_4207_: bool;
    var phi_4208_: u32;
    var phi_4209_: u32;
    var phi_4210_: type_50;
    var phi_4633_: bool;
    var phi_1095_: type_43;
    var phi_1098_: bool;
    var phi_1100_: u32;
    var phi_1102_: u32;
    var phi_1104_: type_50;
    var phi_4211_: bool;
    var phi_4632_: bool;
    var local_10: type_43;
    var local_11: type_43;
    var local_12: type_43;

    switch bitcast<i32>(0u) {
        default: {
            let _e94 = global;
            let _e96 = arrayLength((&global_3.member));
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
            let _e154 = (_e153 < arrayLength((&global_4.member)));
            if _e154 {
                let _e155 = (_e153 < arrayLength((&global_6.member)));
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
                            phi_404_ = (bitcast<i32>((_e232 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_404_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e232)), 32u, (_e232 == 0u))));
                        }
                        let _e246 = phi_404_;
                        phi_405_ = _e246;
                    } else {
                        phi_405_ = 0i;
                    }
                    let _e248 = phi_405_;
                    let _e249 = (_e165 == _e204);
                    if _e249 {
                        phi_415_ = true;
                    } else {
                        phi_415_ = (_e172 == _e204);
                    }
                    let _e252 = phi_415_;
                    let _e253 = select(1u, 0u, _e249);
                    if _e252 {
                        let _e254 = (_e253 + 1u);
                        phi_425_ = _e254;
                        phi_426_ = _e254;
                        phi_428_ = select(true, false, (_e254 == 2u));
                    } else {
                        phi_425_ = u32();
                        phi_426_ = 0u;
                        phi_428_ = true;
                    }
                    let _e258 = phi_425_;
                    let _e260 = phi_426_;
                    let _e262 = phi_428_;
                    if _e262 {
                        phi_433_ = (_e260 + 1u);
                    } else {
                        phi_433_ = 0u;
                    }
                    let _e266 = phi_433_;
                    let _e267 = select(_e258, _e260, _e262);
                    let _e268 = select(_e253, select(2u, _e253, _e252), _e262);
                    if (_e135 < -126i) {
                        phi_446_ = -126i;
                    } else {
                        phi_446_ = select(_e135, 127i, (_e135 > 127i));
                    }
                    let _e273 = phi_446_;
                    let _e278 = bitcast<f32>((bitcast<u32>((_e273 + 127i)) << bitcast<u32>(23i)));
                    let _e284 = bitcast<f32>((bitcast<u32>(((_e135 - _e273) + 127i)) << bitcast<u32>(23i)));
                    let _e285 = -(_e248);
                    if (_e285 < -126i) {
                        phi_466_ = -126i;
                    } else {
                        phi_466_ = select(_e285, 127i, (_e285 > 127i));
                    }
                    let _e290 = phi_466_;
                    let _e295 = bitcast<f32>((bitcast<u32>((_e290 + 127i)) << bitcast<u32>(23i)));
                    let _e301 = bitcast<f32>((bitcast<u32>(((_e285 - _e290) + 127i)) << bitcast<u32>(23i)));
                    let _e305 = global_4.member[_e153].member;
                    let _e306 = (_e267 == 0u);
                    if _e306 {
                        phi_484_ = _e305[0];
                    } else {
                        phi_484_ = _e305[1];
                    }
                    let _e310 = phi_484_;
                    let _e311 = (_e267 == 2u);
                    if _e311 {
                        phi_490_ = _e305[2];
                    } else {
                        phi_490_ = _e310;
                    }
                    let _e314 = phi_490_;
                    let _e315 = bitcast<u32>(_e314);
                    let _e317 = ((_e315 & 2139095040u) != 0u);
                    let _e331 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e315 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e315 & 2147483648u))), _e314, _e317) * _e278) * select(0.00000011920929f, 1f, _e317)) * _e284);
                    let _e332 = global_4.member[_e153].member_2;
                    if _e306 {
                        phi_530_ = _e332[0];
                    } else {
                        phi_530_ = _e332[1];
                    }
                    let _e336 = phi_530_;
                    if _e311 {
                        phi_536_ = _e332[2];
                    } else {
                        phi_536_ = _e336;
                    }
                    let _e339 = phi_536_;
                    let _e340 = bitcast<u32>(_e339);
                    let _e342 = ((_e340 & 2139095040u) != 0u);
                    let _e356 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e340 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e340 & 2147483648u))), _e339, _e342) * _e295) * select(0.00000011920929f, 1f, _e342)) * _e301);
                    let _e360 = (bitcast<f32>((bitcast<u32>(_e356) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e360 {
                        let _e364 = (bitcast<f32>((bitcast<u32>(_e331) & 2147483647u)) * 0.00000011920929f);
                        phi_588_ = select(0.00000000000011368684f, _e364, (_e364 > 0.00000000000011368684f));
                    } else {
                        phi_588_ = 0f;
                    }
                    let _e368 = phi_588_;
                    let _e369 = (_e331 + _e368);
                    let _e370 = (_e331 - _e368);
                    let _e371 = select(_e356, 0f, _e360);
                    if _e360 {
                        phi_600_ = 38685626000000000000000000f;
                    } else {
                        phi_600_ = (1f / _e356);
                    }
                    let _e374 = phi_600_;
                    let _e375 = (_e266 == 0u);
                    if _e375 {
                        phi_609_ = _e305[0];
                    } else {
                        phi_609_ = _e305[1];
                    }
                    let _e379 = phi_609_;
                    let _e380 = (_e266 == 2u);
                    if _e380 {
                        phi_615_ = _e305[2];
                    } else {
                        phi_615_ = _e379;
                    }
                    let _e383 = phi_615_;
                    let _e384 = bitcast<u32>(_e383);
                    let _e386 = ((_e384 & 2139095040u) != 0u);
                    let _e400 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e384 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e384 & 2147483648u))), _e383, _e386) * _e278) * select(0.00000011920929f, 1f, _e386)) * _e284);
                    if _e375 {
                        phi_655_ = _e332[0];
                    } else {
                        phi_655_ = _e332[1];
                    }
                    let _e404 = phi_655_;
                    if _e380 {
                        phi_661_ = _e332[2];
                    } else {
                        phi_661_ = _e404;
                    }
                    let _e407 = phi_661_;
                    let _e408 = bitcast<u32>(_e407);
                    let _e410 = ((_e408 & 2139095040u) != 0u);
                    let _e424 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e408 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e408 & 2147483648u))), _e407, _e410) * _e295) * select(0.00000011920929f, 1f, _e410)) * _e301);
                    let _e428 = (bitcast<f32>((bitcast<u32>(_e424) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e428 {
                        let _e432 = (bitcast<f32>((bitcast<u32>(_e400) & 2147483647u)) * 0.00000011920929f);
                        phi_713_ = select(0.00000000000011368684f, _e432, (_e432 > 0.00000000000011368684f));
                    } else {
                        phi_713_ = 0f;
                    }
                    let _e436 = phi_713_;
                    let _e437 = (_e400 + _e436);
                    let _e438 = (_e400 - _e436);
                    let _e439 = select(_e424, 0f, _e428);
                    if _e428 {
                        phi_725_ = 38685626000000000000000000f;
                    } else {
                        phi_725_ = (1f / _e424);
                    }
                    let _e442 = phi_725_;
                    let _e443 = (_e268 == 0u);
                    if _e443 {
                        phi_734_ = _e305[0];
                    } else {
                        phi_734_ = _e305[1];
                    }
                    let _e447 = phi_734_;
                    let _e448 = (_e268 == 2u);
                    if _e448 {
                        phi_740_ = _e305[2];
                    } else {
                        phi_740_ = _e447;
                    }
                    let _e451 = phi_740_;
                    let _e452 = bitcast<u32>(_e451);
                    let _e454 = ((_e452 & 2139095040u) != 0u);
                    let _e468 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e452 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e452 & 2147483648u))), _e451, _e454) * _e278) * select(0.00000011920929f, 1f, _e454)) * _e284);
                    if _e443 {
                        phi_780_ = _e332[0];
                    } else {
                        phi_780_ = _e332[1];
                    }
                    let _e472 = phi_780_;
                    if _e448 {
                        phi_786_ = _e332[2];
                    } else {
                        phi_786_ = _e472;
                    }
                    let _e475 = phi_786_;
                    let _e476 = bitcast<u32>(_e475);
                    let _e478 = ((_e476 & 2139095040u) != 0u);
                    let _e492 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e476 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e476 & 2147483648u))), _e475, _e478) * _e295) * select(0.00000011920929f, 1f, _e478)) * _e301);
                    let _e496 = (bitcast<f32>((bitcast<u32>(_e492) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e496 {
                        let _e500 = (bitcast<f32>((bitcast<u32>(_e468) & 2147483647u)) * 0.00000011920929f);
                        phi_838_ = select(0.00000000000011368684f, _e500, (_e500 > 0.00000000000011368684f));
                    } else {
                        phi_838_ = 0f;
                    }
                    let _e504 = phi_838_;
                    let _e505 = (_e468 + _e504);
                    let _e506 = (_e468 - _e504);
                    let _e507 = select(_e492, 0f, _e496);
                    if _e496 {
                        phi_850_ = 38685626000000000000000000f;
                    } else {
                        phi_850_ = (1f / _e492);
                    }
                    let _e510 = phi_850_;
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
                            phi_905_ = 255i;
                        } else {
                            phi_905_ = (((_e537 + select(0i, 1i, (_e537 == 0i))) - _e544) + _e524);
                        }
                        let _e552 = phi_905_;
                        let _e562 = (_e552 <= 0i);
                        if _e562 {
                            phi_928_ = u32();
                        } else {
                            if _e541 {
                                phi_927_ = u32();
                            } else {
                                phi_927_ = select(((bitcast<u32>(_e552) << bitcast<u32>(23i)) | ((_e534 << bitcast<u32>(((_e544 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e552 >= 255i));
                            }
                            let _e566 = phi_927_;
                            phi_928_ = _e566;
                        }
                        let _e568 = phi_928_;
                        let _e580 = ((_e225 & 8388607u) | (select(0u, 1u, ((_e225 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                        let _e583 = bitcast<i32>((_e225 >> bitcast<u32>(23i)));
                        let _e587 = (_e580 == 0u);
                        let _e590 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e580)), 32u, _e587)) - 8i);
                        if (_e583 == 255i) {
                            phi_965_ = 255i;
                        } else {
                            phi_965_ = (((_e583 + select(0i, 1i, (_e583 == 0i))) - _e590) + _e524);
                        }
                        let _e598 = phi_965_;
                        let _e608 = (_e598 <= 0i);
                        if _e608 {
                            phi_988_ = u32();
                        } else {
                            if _e587 {
                                phi_987_ = u32();
                            } else {
                                phi_987_ = select(((bitcast<u32>(_e598) << bitcast<u32>(23i)) | ((_e580 << bitcast<u32>(((_e590 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e598 >= 255i));
                            }
                            let _e612 = phi_987_;
                            phi_988_ = _e612;
                        }
                        let _e614 = phi_988_;
                        phi_996_ = bitcast<f32>(((_e224 & 2147483648u) | select(_e614, 0u, select(_e587, true, _e608))));
                        phi_997_ = bitcast<f32>(((_e215 & 2147483648u) | select(_e568, 0u, select(_e541, true, _e562))));
                    } else {
                        phi_996_ = 0f;
                        phi_997_ = 1f;
                    }
                    let _e620 = phi_996_;
                    let _e622 = phi_997_;
                    local_8 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                    local_7 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_6 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_5 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_4 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_3 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_9 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    let _e627 = (_e267 % 3u);
                    let _e628 = (_e627 < 3u);
                    if _e628 {
                    } else {
                        break;
                    }
                    let _e630 = local_1[_e627];
                    let _e633 = (_e266 % 3u);
                    let _e634 = (_e633 < 3u);
                    if _e634 {
                    } else {
                        break;
                    }
                    let _e636 = local_1[_e633];
                    let _e639 = (_e268 % 3u);
                    let _e640 = (_e639 < 3u);
                    if _e640 {
                    } else {
                        break;
                    }
                    let _e642 = local_1[_e639];
                    if _e628 {
                    } else {
                        break;
                    }
                    let _e647 = local[_e627];
                    if _e634 {
                    } else {
                        break;
                    }
                    let _e651 = local[_e633];
                    if _e640 {
                    } else {
                        break;
                    }
                    let _e655 = local[_e639];
                    phi_4431_ = false;
                    phi_1094_ = type_43(type_37(type_28(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e620), 0u, 0u);
                    phi_1097_ = (_e622 <= _e620);
                    phi_1099_ = ((3u * _e96) + 1u);
                    phi_1101_ = 0u;
                    phi_1103_ = type_50(type_32(vec4<f32>((f32(_e630) * _e147), (f32(_e636) * _e147), (f32(_e642) * _e147), 0f), vec4<f32>((f32(_e647) * _e147), (f32(_e651) * _e147), (f32(_e655) * _e147), 0f)), select(0u, 2147483648u, (_e96 == 0u)));
                    loop {
                        let _e665 = phi_4431_;
                        let _e667 = phi_1094_;
                        let _e669 = phi_1097_;
                        let _e671 = phi_1099_;
                        let _e673 = phi_1101_;
                        let _e675 = phi_1103_;
                        local_10 = _e667;
                        local_11 = _e667;
                        if _e669 {
                            phi_1114_ = true;
                        } else {
                            phi_1114_ = (_e673 > 0u);
                        }
                        let _e678 = phi_1114_;
                        if _e678 {
                            let _e679 = (_e671 > 0u);
                            if _e679 {
                                if _e669 {
                                    phi_1200_ = _e669;
                                    phi_1201_ = _e673;
                                    phi_1202_ = _e675;
                                } else {
                                    let _e680 = (_e673 - 1u);
                                    let _e681 = (_e680 % 128u);
                                    let _e682 = (_e681 < 128u);
                                    if _e682 {
                                    } else {
                                        phi_4632_ = true;
                                        break;
                                    }
                                    let _e684 = local_7[_e681];
                                    if _e682 {
                                    } else {
                                        phi_4632_ = true;
                                        break;
                                    }
                                    let _e686 = local_6[_e681];
                                    if _e682 {
                                    } else {
                                        phi_4632_ = true;
                                        break;
                                    }
                                    let _e688 = local_5[_e681];
                                    if _e682 {
                                    } else {
                                        phi_4632_ = true;
                                        break;
                                    }
                                    let _e690 = local_4[_e681];
                                    if _e682 {
                                    } else {
                                        phi_4632_ = true;
                                        break;
                                    }
                                    let _e692 = local_3[_e681];
                                    if _e682 {
                                    } else {
                                        phi_4632_ = true;
                                        break;
                                    }
                                    let _e694 = local_2[_e681];
                                    if _e682 {
                                    } else {
                                        phi_4632_ = true;
                                        break;
                                    }
                                    let _e699 = local_8[_e681];
                                    if _e682 {
                                    } else {
                                        phi_4632_ = true;
                                        break;
                                    }
                                    let _e702 = local_9[_e681];
                                    phi_1200_ = (_e702 <= _e667.member.member_1);
                                    phi_1201_ = _e680;
                                    phi_1202_ = type_50(type_32(vec4<f32>(_e684, _e686, _e688, 0f), vec4<f32>(_e690, _e692, _e694, 0f)), _e699);
                                }
                                let _e707 = phi_1200_;
                                let _e709 = phi_1201_;
                                let _e711 = phi_1202_;
                                if _e707 {
                                    let _e716 = (_e711.member_1 & 268435455u);
                                    if ((_e711.member_1 & 2147483648u) != 0u) {
                                        phi_1221_ = _e667;
                                        phi_1224_ = type_8(0u, ((_e711.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e1189 = phi_1221_;
                                            let _e1191 = phi_1224_;
                                            local_12 = _e1189;
                                            if (_e1191.member < _e1191.member_1) {
                                                phi_1225_ = type_8((_e1191.member + 1u), _e1191.member_1);
                                                phi_1247_ = type_8(1u, _e1191.member);
                                            } else {
                                                phi_1225_ = _e1191;
                                                phi_1247_ = type_8(0u, type_8().member_1);
                                            }
                                            let _e1204 = phi_1225_;
                                            let _e1206 = phi_1247_;
                                            let _e1210 = (bitcast<i32>(_e1206.member) != 0i);
                                            if _e1210 {
                                                let _e1216 = type_43(_e1189.member, _e1189.member_1, (_e1189.member_2 + 1u));
                                                let _e1221 = (_e711.member.member_1.x - _e711.member.member.x);
                                                let _e1224 = (_e711.member.member_1.y - _e711.member.member.y);
                                                let _e1227 = (_e711.member.member_1.z - _e711.member.member.z);
                                                let _e1229 = select(_e1224, _e1221, (_e1221 > _e1224));
                                                let _e1231 = select(_e1227, _e1229, (_e1229 > _e1227));
                                                let _e1233 = (_e1231 < (1024f * _e147));
                                                if _e1233 {
                                                    phi_1291_ = 0u;
                                                } else {
                                                    phi_1291_ = select(2u, 1u, (_e1231 < (2097152f * _e147)));
                                                }
                                                let _e1238 = phi_1291_;
                                                switch bitcast<i32>(_e1238) {
                                                    case 0: {
                                                        phi_1297_ = 1u;
                                                        break;
                                                    }
                                                    case 1: {
                                                        phi_1297_ = 2u;
                                                        break;
                                                    }
                                                    case 2: {
                                                        phi_1297_ = 3u;
                                                        break;
                                                    }
                                                    default: {
                                                        phi_1297_ = u32();
                                                        break;
                                                    }
                                                }
                                                let _e1241 = phi_1297_;
                                                switch bitcast<i32>(_e1238) {
                                                    case 0: {
                                                        phi_1307_ = 1u;
                                                        break;
                                                    }
                                                    case 1: {
                                                        phi_1307_ = 2u;
                                                        break;
                                                    }
                                                    case 2: {
                                                        phi_1307_ = 3u;
                                                        break;
                                                    }
                                                    default: {
                                                        phi_1307_ = u32();
                                                        break;
                                                    }
                                                }
                                                let _e1248 = phi_1307_;
                                                let _e1250 = ((_e716 + (_e1206.member_1 * ((3u * _e1241) + 1u))) + (3u * _e1248));
                                                let _e1251 = (_e1250 < _e99);
                                                if _e1251 {
                                                    if _e1251 {
                                                    } else {
                                                        phi_4425_ = true;
                                                        break;
                                                    }
                                                    let _e1253 = global_5.member[_e1250];
                                                    phi_1323_ = _e1253;
                                                } else {
                                                    phi_1323_ = 4294967295u;
                                                }
                                                let _e1255 = phi_1323_;
                                                if _e1233 {
                                                    phi_1356_ = 0u;
                                                } else {
                                                    phi_1356_ = select(2u, 1u, (_e1231 < (2097152f * _e147)));
                                                }
                                                let _e1260 = phi_1356_;
                                                switch bitcast<i32>(_e1260) {
                                                    case 0: {
                                                        phi_1362_ = 1u;
                                                        break;
                                                    }
                                                    case 1: {
                                                        phi_1362_ = 2u;
                                                        break;
                                                    }
                                                    case 2: {
                                                        phi_1362_ = 3u;
                                                        break;
                                                    }
                                                    default: {
                                                        phi_1362_ = u32();
                                                        break;
                                                    }
                                                }
                                                let _e1263 = phi_1362_;
                                                let _e1267 = (_e716 + (_e1206.member_1 * ((3u * _e1263) + 1u)));
                                                switch bitcast<i32>(_e1260) {
                                                    case 0: {
                                                        let _e1542 = (_e1267 < _e99);
                                                        if _e1542 {
                                                            if _e1542 {
                                                            } else {
                                                                phi_4425_ = true;
                                                                break;
                                                            }
                                                            let _e1544 = global_5.member[_e1267];
                                                            phi_1389_ = _e1544;
                                                        } else {
                                                            phi_1389_ = 0u;
                                                        }
                                                        let _e1546 = phi_1389_;
                                                        let _e1548 = ((10u * _e267) & 31u);
                                                        let _e1558 = ((10u * _e266) & 31u);
                                                        let _e1568 = ((10u * _e268) & 31u);
                                                        let _e1578 = (_e1267 + 1u);
                                                        let _e1579 = (_e1578 < _e99);
                                                        if _e1579 {
                                                            if _e1579 {
                                                            } else {
                                                                phi_4425_ = true;
                                                                break;
                                                            }
                                                            let _e1581 = global_5.member[_e1578];
                                                            phi_1438_ = _e1581;
                                                        } else {
                                                            phi_1438_ = 0u;
                                                        }
                                                        let _e1583 = phi_1438_;
                                                        let _e1609 = (_e1267 + 2u);
                                                        let _e1610 = (_e1609 < _e99);
                                                        if _e1610 {
                                                            if _e1610 {
                                                            } else {
                                                                phi_4425_ = true;
                                                                break;
                                                            }
                                                            let _e1612 = global_5.member[_e1609];
                                                            phi_1487_ = _e1612;
                                                        } else {
                                                            phi_1487_ = 0u;
                                                        }
                                                        let _e1614 = phi_1487_;
                                                        phi_1988_ = array<array<f32, 3>, 3>(array<f32, 3>((_e711.member.member.x + ((bitcast<f32>((1258291200u | ((_e1546 >> bitcast<u32>(_e1548)) & 1023u))) - 8388608f) * _e147)), (_e711.member.member.y + ((bitcast<f32>((1258291200u | ((_e1546 >> bitcast<u32>(_e1558)) & 1023u))) - 8388608f) * _e147)), (_e711.member.member.z + ((bitcast<f32>((1258291200u | ((_e1546 >> bitcast<u32>(_e1568)) & 1023u))) - 8388608f) * _e147))), array<f32, 3>((_e711.member.member.x + ((bitcast<f32>((1258291200u | ((_e1583 >> bitcast<u32>(_e1548)) & 1023u))) - 8388608f) * _e147)), (_e711.member.member.y + ((bitcast<f32>((1258291200u | ((_e1583 >> bitcast<u32>(_e1558)) & 1023u))) - 8388608f) * _e147)), (_e711.member.member.z + ((bitcast<f32>((1258291200u | ((_e1583 >> bitcast<u32>(_e1568)) & 1023u))) - 8388608f) * _e147))), array<f32, 3>((_e711.member.member.x + ((bitcast<f32>((1258291200u | ((_e1614 >> bitcast<u32>(_e1548)) & 1023u))) - 8388608f) * _e147)), (_e711.member.member.y + ((bitcast<f32>((1258291200u | ((_e1614 >> bitcast<u32>(_e1558)) & 1023u))) - 8388608f) * _e147)), (_e711.member.member.z + ((bitcast<f32>((1258291200u | ((_e1614 >> bitcast<u32>(_e1568)) & 1023u))) - 8388608f) * _e147))));
                                                        break;
                                                    }
                                                    case 1: {
                                                        let _e1356 = (_e1267 < _e99);
                                                        if _e1356 {
                                                            if _e1356 {
                                                            } else {
                                                                phi_4425_ = true;
                                                                break;
                                                            }
                                                            let _e1358 = global_5.member[_e1267];
                                                            phi_1536_ = _e1358;
                                                        } else {
                                                            phi_1536_ = 0u;
                                                        }
                                                        let _e1360 = phi_1536_;
                                                        let _e1361 = (_e1267 + 1u);
                                                        let _e1362 = (_e1361 < _e99);
                                                        if _e1362 {
                                                            if _e1362 {
                                                            } else {
                                                                phi_4425_ = true;
                                                                break;
                                                            }
                                                            let _e1364 = global_5.member[_e1361];
                                                            phi_1551_ = _e1364;
                                                        } else {
                                                            phi_1551_ = 0u;
                                                        }
                                                        let _e1366 = phi_1551_;
                                                        let _e1367 = (_e267 == 1u);
                                                        if _e1367 {
                                                            phi_1561_ = ((_e1360 >> bitcast<u32>(21i)) | (_e1366 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1561_ = (_e1366 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1376 = phi_1561_;
                                                        let _e1384 = (_e266 == 1u);
                                                        if _e1384 {
                                                            phi_1582_ = ((_e1360 >> bitcast<u32>(21i)) | (_e1366 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1582_ = (_e1366 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1393 = phi_1582_;
                                                        let _e1401 = (_e268 == 1u);
                                                        if _e1401 {
                                                            phi_1603_ = ((_e1360 >> bitcast<u32>(21i)) | (_e1366 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1603_ = (_e1366 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1410 = phi_1603_;
                                                        let _e1419 = (_e1267 + 2u);
                                                        let _e1420 = (_e1419 < _e99);
                                                        if _e1420 {
                                                            if _e1420 {
                                                            } else {
                                                                phi_4425_ = true;
                                                                break;
                                                            }
                                                            let _e1422 = global_5.member[_e1419];
                                                            phi_1633_ = _e1422;
                                                        } else {
                                                            phi_1633_ = 0u;
                                                        }
                                                        let _e1424 = phi_1633_;
                                                        let _e1425 = (_e1267 + 3u);
                                                        let _e1426 = (_e1425 < _e99);
                                                        if _e1426 {
                                                            if _e1426 {
                                                            } else {
                                                                phi_4425_ = true;
                                                                break;
                                                            }
                                                            let _e1428 = global_5.member[_e1425];
                                                            phi_1648_ = _e1428;
                                                        } else {
                                                            phi_1648_ = 0u;
                                                        }
                                                        let _e1430 = phi_1648_;
                                                        if _e1367 {
                                                            phi_1658_ = ((_e1424 >> bitcast<u32>(21i)) | (_e1430 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1658_ = (_e1430 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1439 = phi_1658_;
                                                        if _e1384 {
                                                            phi_1679_ = ((_e1424 >> bitcast<u32>(21i)) | (_e1430 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1679_ = (_e1430 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1455 = phi_1679_;
                                                        if _e1401 {
                                                            phi_1700_ = ((_e1424 >> bitcast<u32>(21i)) | (_e1430 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1700_ = (_e1430 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1471 = phi_1700_;
                                                        let _e1480 = (_e1267 + 4u);
                                                        let _e1481 = (_e1480 < _e99);
                                                        if _e1481 {
                                                            if _e1481 {
                                                            } else {
                                                                phi_4425_ = true;
                                                                break;
                                                            }
                                                            let _e1483 = global_5.member[_e1480];
                                                            phi_1730_ = _e1483;
                                                        } else {
                                                            phi_1730_ = 0u;
                                                        }
                                                        let _e1485 = phi_1730_;
                                                        let _e1486 = (_e1267 + 5u);
                                                        let _e1487 = (_e1486 < _e99);
                                                        if _e1487 {
                                                            if _e1487 {
                                                            } else {
                                                                phi_4425_ = true;
                                                                break;
                                                            }
                                                            let _e1489 = global_5.member[_e1486];
                                                            phi_1745_ = _e1489;
                                                        } else {
                                                            phi_1745_ = 0u;
                                                        }
                                                        let _e1491 = phi_1745_;
                                                        if _e1367 {
                                                            phi_1755_ = ((_e1485 >> bitcast<u32>(21i)) | (_e1491 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1755_ = (_e1491 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1500 = phi_1755_;
                                                        if _e1384 {
                                                            phi_1776_ = ((_e1485 >> bitcast<u32>(21i)) | (_e1491 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1776_ = (_e1491 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1516 = phi_1776_;
                                                        if _e1401 {
                                                            phi_1797_ = ((_e1485 >> bitcast<u32>(21i)) | (_e1491 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1797_ = (_e1491 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1532 = phi_1797_;
                                                        phi_1988_ = array<array<f32, 3>, 3>(array<f32, 3>((_e711.member.member.x + ((bitcast<f32>((1258291200u | (select(_e1376, _e1360, _e306) & 2097151u))) - 8388608f) * _e147)), (_e711.member.member.y + ((bitcast<f32>((1258291200u | (select(_e1393, _e1360, _e375) & 2097151u))) - 8388608f) * _e147)), (_e711.member.member.z + ((bitcast<f32>((1258291200u | (select(_e1410, _e1360, _e443) & 2097151u))) - 8388608f) * _e147))), array<f32, 3>((_e711.member.member.x + ((bitcast<f32>((1258291200u | (select(_e1439, _e1424, _e306) & 2097151u))) - 8388608f) * _e147)), (_e711.member.member.y + ((bitcast<f32>((1258291200u | (select(_e1455, _e1424, _e375) & 2097151u))) - 8388608f) * _e147)), (_e711.member.member.z + ((bitcast<f32>((1258291200u | (select(_e1471, _e1424, _e443) & 2097151u))) - 8388608f) * _e147))), array<f32, 3>((_e711.member.member.x + ((bitcast<f32>((1258291200u | (select(_e1500, _e1485, _e306) & 2097151u))) - 8388608f) * _e147)), (_e711.member.member.y + ((bitcast<f32>((1258291200u | (select(_e1516, _e1485, _e375) & 2097151u))) - 8388608f) * _e147)), (_e711.member.member.z + ((bitcast<f32>((1258291200u | (select(_e1532, _e1485, _e443) & 2097151u))) - 8388608f) * _e147))));
                                                        break;
                                                    }
                                                    case 2: {
                                                        let _e1269 = (_e1267 + _e267);
                                                        let _e1270 = (_e1269 < _e99);
                                                        if _e1270 {
                                                            if _e1270 {
                                                            } else {
                                                                phi_4425_ = true;
                                                                break;
                                                            }
                                                            let _e1272 = global_5.member[_e1269];
                                                            phi_1828_ = _e1272;
                                                        } else {
                                                            phi_1828_ = 0u;
                                                        }
                                                        let _e1274 = phi_1828_;
                                                        let _e1278 = (_e1267 + _e266);
                                                        let _e1279 = (_e1278 < _e99);
                                                        if _e1279 {
                                                            if _e1279 {
                                                            } else {
                                                                phi_4425_ = true;
                                                                break;
                                                            }
                                                            let _e1281 = global_5.member[_e1278];
                                                            phi_1846_ = _e1281;
                                                        } else {
                                                            phi_1846_ = 0u;
                                                        }
                                                        let _e1283 = phi_1846_;
                                                        let _e1287 = (_e1267 + _e268);
                                                        let _e1288 = (_e1287 < _e99);
                                                        if _e1288 {
                                                            if _e1288 {
                                                            } else {
                                                                phi_4425_ = true;
                                                                break;
                                                            }
                                                            let _e1290 = global_5.member[_e1287];
                                                            phi_1864_ = _e1290;
                                                        } else {
                                                            phi_1864_ = 0u;
                                                        }
                                                        let _e1292 = phi_1864_;
                                                        let _e1297 = (_e1267 + 3u);
                                                        let _e1298 = (_e1297 + _e267);
                                                        let _e1299 = (_e1298 < _e99);
                                                        if _e1299 {
                                                            if _e1299 {
                                                            } else {
                                                                phi_4425_ = true;
                                                                break;
                                                            }
                                                            let _e1301 = global_5.member[_e1298];
                                                            phi_1887_ = _e1301;
                                                        } else {
                                                            phi_1887_ = 0u;
                                                        }
                                                        let _e1303 = phi_1887_;
                                                        let _e1307 = (_e1297 + _e266);
                                                        let _e1308 = (_e1307 < _e99);
                                                        if _e1308 {
                                                            if _e1308 {
                                                            } else {
                                                                phi_4425_ = true;
                                                                break;
                                                            }
                                                            let _e1310 = global_5.member[_e1307];
                                                            phi_1905_ = _e1310;
                                                        } else {
                                                            phi_1905_ = 0u;
                                                        }
                                                        let _e1312 = phi_1905_;
                                                        let _e1316 = (_e1297 + _e268);
                                                        let _e1317 = (_e1316 < _e99);
                                                        if _e1317 {
                                                            if _e1317 {
                                                            } else {
                                                                phi_4425_ = true;
                                                                break;
                                                            }
                                                            let _e1319 = global_5.member[_e1316];
                                                            phi_1923_ = _e1319;
                                                        } else {
                                                            phi_1923_ = 0u;
                                                        }
                                                        let _e1321 = phi_1923_;
                                                        let _e1326 = (_e1267 + 6u);
                                                        let _e1327 = (_e1326 + _e267);
                                                        let _e1328 = (_e1327 < _e99);
                                                        if _e1328 {
                                                            if _e1328 {
                                                            } else {
                                                                phi_4425_ = true;
                                                                break;
                                                            }
                                                            let _e1330 = global_5.member[_e1327];
                                                            phi_1946_ = _e1330;
                                                        } else {
                                                            phi_1946_ = 0u;
                                                        }
                                                        let _e1332 = phi_1946_;
                                                        let _e1336 = (_e1326 + _e266);
                                                        let _e1337 = (_e1336 < _e99);
                                                        if _e1337 {
                                                            if _e1337 {
                                                            } else {
                                                                phi_4425_ = true;
                                                                break;
                                                            }
                                                            let _e1339 = global_5.member[_e1336];
                                                            phi_1964_ = _e1339;
                                                        } else {
                                                            phi_1964_ = 0u;
                                                        }
                                                        let _e1341 = phi_1964_;
                                                        let _e1345 = (_e1326 + _e268);
                                                        let _e1346 = (_e1345 < _e99);
                                                        if _e1346 {
                                                            if _e1346 {
                                                            } else {
                                                                phi_4425_ = true;
                                                                break;
                                                            }
                                                            let _e1348 = global_5.member[_e1345];
                                                            phi_1982_ = _e1348;
                                                        } else {
                                                            phi_1982_ = 0u;
                                                        }
                                                        let _e1350 = phi_1982_;
                                                        phi_1988_ = array<array<f32, 3>, 3>(array<f32, 3>((f32(bitcast<i32>(_e1274)) * _e147), (f32(bitcast<i32>(_e1283)) * _e147), (f32(bitcast<i32>(_e1292)) * _e147)), array<f32, 3>((f32(bitcast<i32>(_e1303)) * _e147), (f32(bitcast<i32>(_e1312)) * _e147), (f32(bitcast<i32>(_e1321)) * _e147)), array<f32, 3>((f32(bitcast<i32>(_e1332)) * _e147), (f32(bitcast<i32>(_e1341)) * _e147), (f32(bitcast<i32>(_e1350)) * _e147)));
                                                        break;
                                                    }
                                                    default: {
                                                        phi_1988_ = array<array<f32, 3>, 3>();
                                                        break;
                                                    }
                                                }
                                                let _e1642 = phi_1988_;
                                                let _e1651 = (_e1642[0][2] - _e468);
                                                let _e1654 = (((_e1642[0][0] - _e331) * _e507) - (_e1651 * _e371));
                                                let _e1657 = (((_e1642[0][1] - _e400) * _e507) - (_e1651 * _e439));
                                                let _e1664 = (_e1642[1][2] - _e468);
                                                let _e1667 = (((_e1642[1][0] - _e331) * _e507) - (_e1664 * _e371));
                                                let _e1670 = (((_e1642[1][1] - _e400) * _e507) - (_e1664 * _e439));
                                                let _e1677 = (_e1642[2][2] - _e468);
                                                let _e1680 = (((_e1642[2][0] - _e331) * _e507) - (_e1677 * _e371));
                                                let _e1683 = (((_e1642[2][1] - _e400) * _e507) - (_e1677 * _e439));
                                                let _e1684 = (_e1680 * _e1670);
                                                let _e1685 = (_e1683 * _e1667);
                                                let _e1686 = (_e1654 * _e1683);
                                                let _e1687 = (_e1657 * _e1680);
                                                let _e1688 = (_e1667 * _e1657);
                                                let _e1689 = (_e1670 * _e1654);
                                                let _e1694 = (((_e1684 >= _e1685) && (_e1686 >= _e1687)) && (_e1688 >= _e1689));
                                                if (_e1694 || (((_e1684 <= _e1685) && (_e1686 <= _e1687)) && (_e1688 <= _e1689))) {
                                                    let _e1701 = select(-1f, 1f, _e1694);
                                                    let _e1703 = ((_e1684 - _e1685) * _e1701);
                                                    let _e1705 = select(0f, _e1703, (_e1703 > 0f));
                                                    let _e1707 = ((_e1686 - _e1687) * _e1701);
                                                    let _e1709 = select(0f, _e1707, (_e1707 > 0f));
                                                    let _e1711 = ((_e1688 - _e1689) * _e1701);
                                                    let _e1713 = select(0f, _e1711, (_e1711 > 0f));
                                                    let _e1715 = ((_e1705 + _e1709) + _e1713);
                                                    if (_e1715 < 0.000000000000000000000000000000000000011754944f) {
                                                        phi_2872_ = type_28();
                                                        phi_2873_ = true;
                                                        phi_2874_ = false;
                                                    } else {
                                                        let _e1718 = select(_e1667, _e1654, (_e1654 < _e1667));
                                                        if (select(_e1680, _e1718, (_e1718 < _e1680)) > 0f) {
                                                            phi_2140_ = true;
                                                        } else {
                                                            let _e1723 = select(_e1667, _e1654, (_e1654 > _e1667));
                                                            phi_2140_ = (select(_e1680, _e1723, (_e1723 > _e1680)) < 0f);
                                                        }
                                                        let _e1728 = phi_2140_;
                                                        if _e1728 {
                                                            phi_2869_ = type_28();
                                                            phi_2870_ = true;
                                                            phi_2871_ = false;
                                                        } else {
                                                            let _e1730 = select(_e1670, _e1657, (_e1657 < _e1670));
                                                            if (select(_e1683, _e1730, (_e1730 < _e1683)) > 0f) {
                                                                phi_2169_ = true;
                                                            } else {
                                                                let _e1735 = select(_e1670, _e1657, (_e1657 > _e1670));
                                                                phi_2169_ = (select(_e1683, _e1735, (_e1735 > _e1683)) < 0f);
                                                            }
                                                            let _e1740 = phi_2169_;
                                                            if _e1740 {
                                                                phi_2867_ = type_28();
                                                                phi_2868_ = false;
                                                            } else {
                                                                let _e1742 = select(_e1642[1][0], _e1642[0][0], (_e1642[0][0] < _e1642[1][0]));
                                                                let _e1746 = select(_e1642[1][0], _e1642[0][0], (_e1642[0][0] > _e1642[1][0]));
                                                                let _e1750 = select(_e1642[1][1], _e1642[0][1], (_e1642[0][1] < _e1642[1][1]));
                                                                let _e1754 = select(_e1642[1][1], _e1642[0][1], (_e1642[0][1] > _e1642[1][1]));
                                                                let _e1758 = select(_e1642[1][2], _e1642[0][2], (_e1642[0][2] < _e1642[1][2]));
                                                                let _e1762 = select(_e1642[1][2], _e1642[0][2], (_e1642[0][2] > _e1642[1][2]));
                                                                let _e1767 = ((select(_e1642[2][0], _e1742, (_e1742 < _e1642[2][0])) - _e369) * _e374);
                                                                let _e1768 = ((select(_e1642[2][0], _e1746, (_e1746 > _e1642[2][0])) - _e370) * _e374);
                                                                let _e1771 = ((select(_e1642[2][1], _e1750, (_e1750 < _e1642[2][1])) - _e437) * _e442);
                                                                let _e1772 = ((select(_e1642[2][1], _e1754, (_e1754 > _e1642[2][1])) - _e438) * _e442);
                                                                let _e1775 = ((select(_e1642[2][2], _e1758, (_e1758 < _e1642[2][2])) - _e505) * _e510);
                                                                let _e1776 = ((select(_e1642[2][2], _e1762, (_e1762 > _e1642[2][2])) - _e506) * _e510);
                                                                let _e1778 = select(_e1776, _e1775, (_e1775 < _e1776));
                                                                let _e1780 = select(_e1776, _e1775, (_e1775 > _e1776));
                                                                let _e1782 = select(_e1768, _e1767, (_e1767 < _e1768));
                                                                let _e1784 = select(_e1772, _e1771, (_e1771 < _e1772));
                                                                let _e1786 = select(_e1784, _e1782, (_e1782 > _e1784));
                                                                let _e1788 = select(_e1778, _e1786, (_e1786 > _e1778));
                                                                let _e1790 = select(_e1768, _e1767, (_e1767 > _e1768));
                                                                let _e1792 = select(_e1772, _e1771, (_e1771 > _e1772));
                                                                let _e1794 = select(_e1792, _e1790, (_e1790 < _e1792));
                                                                let _e1796 = select(_e1780, _e1794, (_e1794 < _e1780));
                                                                let _e1797 = -(_e1778);
                                                                let _e1803 = select(_e622, _e1788, (_e1788 > _e622));
                                                                if (_e1803 > (_e1796 + (select(_e1797, _e1780, (_e1780 > _e1797)) * 0.0000019073523f))) {
                                                                    phi_2862_ = type_28();
                                                                    phi_2863_ = true;
                                                                } else {
                                                                    let _e1805 = (_e1803 > _e1189.member.member_1);
                                                                    if _e1805 {
                                                                        phi_2861_ = type_28();
                                                                    } else {
                                                                        let _e1806 = vec3<f32>(_e1642[0][0], _e1642[0][1], _e1642[0][2]);
                                                                        let _e1807 = vec3<f32>(_e1642[1][0], _e1642[1][1], _e1642[1][2]);
                                                                        let _e1808 = vec3<f32>(_e1642[2][0], _e1642[2][1], _e1642[2][2]);
                                                                        let _e1809 = (_e1642[1][0] - _e1642[0][0]);
                                                                        let _e1810 = (_e1642[1][1] - _e1642[0][1]);
                                                                        let _e1811 = (_e1642[1][2] - _e1642[0][2]);
                                                                        let _e1812 = vec3<f32>(_e1809, _e1810, _e1811);
                                                                        let _e1813 = (_e1642[2][0] - _e1642[1][0]);
                                                                        let _e1814 = (_e1642[2][1] - _e1642[1][1]);
                                                                        let _e1815 = (_e1642[2][2] - _e1642[1][2]);
                                                                        let _e1816 = vec3<f32>(_e1813, _e1814, _e1815);
                                                                        let _e1817 = (_e1642[0][0] - _e1642[2][0]);
                                                                        let _e1818 = (_e1642[0][1] - _e1642[2][1]);
                                                                        let _e1819 = (_e1642[0][2] - _e1642[2][2]);
                                                                        let _e1820 = vec3<f32>(_e1817, _e1818, _e1819);
                                                                        let _e1823 = bitcast<f32>((bitcast<u32>(_e1809) & 2147483647u));
                                                                        let _e1826 = bitcast<f32>((bitcast<u32>(_e1810) & 2147483647u));
                                                                        let _e1828 = select(_e1826, _e1823, (_e1823 > _e1826));
                                                                        let _e1831 = bitcast<f32>((bitcast<u32>(_e1811) & 2147483647u));
                                                                        let _e1833 = select(_e1831, _e1828, (_e1828 > _e1831));
                                                                        let _e1836 = bitcast<f32>((bitcast<u32>(_e1813) & 2147483647u));
                                                                        let _e1839 = bitcast<f32>((bitcast<u32>(_e1814) & 2147483647u));
                                                                        let _e1841 = select(_e1839, _e1836, (_e1836 > _e1839));
                                                                        let _e1844 = bitcast<f32>((bitcast<u32>(_e1815) & 2147483647u));
                                                                        let _e1846 = select(_e1844, _e1841, (_e1841 > _e1844));
                                                                        let _e1849 = bitcast<f32>((bitcast<u32>(_e1817) & 2147483647u));
                                                                        let _e1852 = bitcast<f32>((bitcast<u32>(_e1818) & 2147483647u));
                                                                        let _e1854 = select(_e1852, _e1849, (_e1849 > _e1852));
                                                                        let _e1857 = bitcast<f32>((bitcast<u32>(_e1819) & 2147483647u));
                                                                        let _e1859 = select(_e1857, _e1854, (_e1854 > _e1857));
                                                                        let _e1861 = select(_e1846, _e1833, (_e1833 > _e1846));
                                                                        let _e1863 = select(_e1859, _e1861, (_e1861 > _e1859));
                                                                        if (_e1833 == _e1863) {
                                                                            phi_2588_ = _e1670;
                                                                            phi_2589_ = _e1667;
                                                                            phi_2590_ = _e1657;
                                                                            phi_2591_ = _e1654;
                                                                            phi_2592_ = _e1806;
                                                                            phi_2593_ = _e1820;
                                                                            phi_2594_ = _e1816;
                                                                            phi_2595_ = _e1812;
                                                                        } else {
                                                                            let _e1865 = (_e1846 == _e1863);
                                                                            let _e1870 = vec3(_e1865);
                                                                            phi_2588_ = select(_e1657, _e1683, _e1865);
                                                                            phi_2589_ = select(_e1654, _e1680, _e1865);
                                                                            phi_2590_ = select(_e1683, _e1670, _e1865);
                                                                            phi_2591_ = select(_e1680, _e1667, _e1865);
                                                                            phi_2592_ = select(_e1808, _e1807, _e1870);
                                                                            phi_2593_ = select(_e1816, _e1812, _e1870);
                                                                            phi_2594_ = select(_e1812, _e1820, _e1870);
                                                                            phi_2595_ = select(_e1820, _e1816, _e1870);
                                                                        }
                                                                        let _e1876 = phi_2588_;
                                                                        let _e1878 = phi_2589_;
                                                                        let _e1880 = phi_2590_;
                                                                        let _e1882 = phi_2591_;
                                                                        let _e1884 = phi_2592_;
                                                                        let _e1886 = phi_2593_;
                                                                        let _e1888 = phi_2594_;
                                                                        let _e1890 = phi_2595_;
                                                                        let _e1897 = ((_e1888.y * _e1886.z) - (_e1886.y * _e1888.z));
                                                                        let _e1902 = ((_e1888.z * _e1886.x) - (_e1886.z * _e1888.x));
                                                                        let _e1905 = ((_e1888.x * _e1886.y) - (_e1886.x * _e1888.y));
                                                                        if (_e1705 >= _e1709) {
                                                                            phi_2632_ = select(true, false, (_e1705 >= _e1713));
                                                                        } else {
                                                                            phi_2632_ = true;
                                                                        }
                                                                        let _e1910 = phi_2632_;
                                                                        if _e1910 {
                                                                            phi_2641_ = select(_e1808, _e1807, vec3((_e1709 >= _e1713)));
                                                                        } else {
                                                                            phi_2641_ = _e1806;
                                                                        }
                                                                        let _e1915 = phi_2641_;
                                                                        let _e1926 = (((_e1897 * (_e1915.x - _e331)) + (_e1902 * (_e1915.y - _e400))) + (_e1905 * (_e1915.z - _e468)));
                                                                        let _e1931 = (((_e1897 * _e371) + (_e1902 * _e439)) + (_e1905 * _e507));
                                                                        let _e1932 = (_e1878 - _e1882);
                                                                        let _e1933 = (_e1876 - _e1880);
                                                                        let _e1941 = (-(((_e1882 * _e1932) + (_e1880 * _e1933))) / ((_e1932 * _e1932) + (_e1933 * _e1933)));
                                                                        let _e1943 = select(1f, _e1941, (_e1941 < 1f));
                                                                        let _e1945 = select(0f, _e1943, (_e1943 > 0f));
                                                                        let _e1958 = ((_e1884.x + (_e1890.x * _e1945)) - _e331);
                                                                        let _e1959 = ((_e1884.y + (_e1890.y * _e1945)) - _e400);
                                                                        let _e1960 = ((_e1884.z + (_e1890.z * _e1945)) - _e468);
                                                                        let _e1961 = (_e1960 / _e507);
                                                                        let _e1973 = bitcast<f32>((bitcast<u32>(_e1958) & 2147483647u));
                                                                        let _e1976 = bitcast<f32>((bitcast<u32>(_e1959) & 2147483647u));
                                                                        let _e1978 = select(_e1976, _e1973, (_e1973 > _e1976));
                                                                        let _e1981 = bitcast<f32>((bitcast<u32>(_e1960) & 2147483647u));
                                                                        let _e1983 = select(_e1981, _e1978, (_e1978 > _e1981));
                                                                        let _e1989 = bitcast<f32>((bitcast<u32>(_e1897) & 2147483647u));
                                                                        let _e1992 = bitcast<f32>((bitcast<u32>(_e1902) & 2147483647u));
                                                                        let _e1994 = select(_e1992, _e1989, (_e1989 > _e1992));
                                                                        let _e1997 = bitcast<f32>((bitcast<u32>(_e1905) & 2147483647u));
                                                                        if (bitcast<f32>((bitcast<u32>(((((_e1897 * _e1958) + (_e1902 * _e1959)) + (_e1905 * _e1960)) - _e1926)) & 2147483647u)) <= ((0.0000009536743f * select(_e1863, _e1983, (_e1983 > _e1863))) * select(_e1997, _e1994, (_e1994 > _e1997)))) {
                                                                            let _e2007 = bitcast<f32>((bitcast<u32>(_e1888.x) & 2147483647u));
                                                                            let _e2010 = bitcast<f32>((bitcast<u32>(_e1888.y) & 2147483647u));
                                                                            let _e2012 = select(_e2010, _e2007, (_e2007 > _e2010));
                                                                            let _e2015 = bitcast<f32>((bitcast<u32>(_e1888.z) & 2147483647u));
                                                                            let _e2021 = bitcast<f32>((bitcast<u32>(_e1886.x) & 2147483647u));
                                                                            let _e2024 = bitcast<f32>((bitcast<u32>(_e1886.y) & 2147483647u));
                                                                            let _e2026 = select(_e2024, _e2021, (_e2021 > _e2024));
                                                                            let _e2029 = bitcast<f32>((bitcast<u32>(_e1886.z) & 2147483647u));
                                                                            let _e2033 = (bitcast<f32>((bitcast<u32>(_e1931) & 2147483647u)) > ((0.0000038146973f * select(_e2015, _e2012, (_e2012 > _e2015))) * select(_e2029, _e2026, (_e2026 > _e2029))));
                                                                            if _e2033 {
                                                                                phi_2806_ = (_e1926 / _e1931);
                                                                            } else {
                                                                                phi_2806_ = f32();
                                                                            }
                                                                            let _e2036 = phi_2806_;
                                                                            phi_2808_ = _e2036;
                                                                            phi_2809_ = select(true, false, _e2033);
                                                                        } else {
                                                                            phi_2808_ = f32();
                                                                            phi_2809_ = true;
                                                                        }
                                                                        let _e2039 = phi_2808_;
                                                                        let _e2041 = phi_2809_;
                                                                        if _e2041 {
                                                                            let _e2049 = (((_e1897 * (_e1958 - (_e371 * _e1961))) + (_e1902 * (_e1959 - (_e439 * _e1961)))) / _e1931);
                                                                            if (bitcast<f32>((bitcast<u32>(_e2049) & 2147483647u)) <= _e1863) {
                                                                                phi_2829_ = (_e1961 + _e2049);
                                                                            } else {
                                                                                phi_2829_ = _e1961;
                                                                            }
                                                                            let _e2056 = phi_2829_;
                                                                            phi_2830_ = _e2056;
                                                                        } else {
                                                                            phi_2830_ = _e2039;
                                                                        }
                                                                        let _e2058 = phi_2830_;
                                                                        let _e2060 = select(_e1796, _e2058, (_e2058 < _e1796));
                                                                        let _e2062 = select(_e1788, _e2060, (_e2060 > _e1788));
                                                                        if (_e2062 >= _e622) {
                                                                            let _e2064 = (_e2062 <= _e1189.member.member_1);
                                                                            if _e2064 {
                                                                                let _e2065 = (1f / _e1715);
                                                                                phi_2853_ = type_28(_e2062, (_e1709 * _e2065), (_e1713 * _e2065), _e1255);
                                                                            } else {
                                                                                phi_2853_ = type_28();
                                                                            }
                                                                            let _e2070 = phi_2853_;
                                                                            phi_2855_ = _e2070;
                                                                            phi_2856_ = select(true, false, _e2064);
                                                                        } else {
                                                                            phi_2855_ = type_28();
                                                                            phi_2856_ = true;
                                                                        }
                                                                        let _e2073 = phi_2855_;
                                                                        let _e2075 = phi_2856_;
                                                                        if _e2075 {
                                                                            phi_2860_ = type_28(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                        } else {
                                                                            phi_2860_ = _e2073;
                                                                        }
                                                                        let _e2077 = phi_2860_;
                                                                        phi_2861_ = _e2077;
                                                                    }
                                                                    let _e2079 = phi_2861_;
                                                                    phi_2862_ = _e2079;
                                                                    phi_2863_ = _e1805;
                                                                }
                                                                let _e2081 = phi_2862_;
                                                                let _e2083 = phi_2863_;
                                                                phi_2867_ = _e2081;
                                                                phi_2868_ = _e2083;
                                                            }
                                                            let _e2085 = phi_2867_;
                                                            let _e2087 = phi_2868_;
                                                            phi_2869_ = _e2085;
                                                            phi_2870_ = _e1740;
                                                            phi_2871_ = _e2087;
                                                        }
                                                        let _e2089 = phi_2869_;
                                                        let _e2091 = phi_2870_;
                                                        let _e2093 = phi_2871_;
                                                        phi_2872_ = _e2089;
                                                        phi_2873_ = _e2091;
                                                        phi_2874_ = _e2093;
                                                    }
                                                    let _e2095 = phi_2872_;
                                                    let _e2097 = phi_2873_;
                                                    let _e2099 = phi_2874_;
                                                    phi_2882_ = _e2095;
                                                    phi_2883_ = select(_e2099, true, _e2097);
                                                } else {
                                                    phi_2882_ = type_28();
                                                    phi_2883_ = true;
                                                }
                                                let _e2102 = phi_2882_;
                                                let _e2104 = phi_2883_;
                                                if _e2104 {
                                                    phi_2887_ = type_28(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                } else {
                                                    phi_2887_ = _e2102;
                                                }
                                                let _e2106 = phi_2887_;
                                                if (_e2106.member_3 != 4294967295u) {
                                                    if (_e1255 != 4294967295u) {
                                                        if (_e2106.member < _e1189.member.member.member) {
                                                            phi_2913_ = true;
                                                        } else {
                                                            if (_e2106.member == _e1189.member.member.member) {
                                                                phi_2912_ = (_e2106.member_3 < _e1189.member.member.member_3);
                                                            } else {
                                                                phi_2912_ = false;
                                                            }
                                                            let _e2121 = phi_2912_;
                                                            phi_2913_ = _e2121;
                                                        }
                                                        let _e2123 = phi_2913_;
                                                        if _e2123 {
                                                            phi_2920_ = type_43(type_37(_e2106, _e2106.member), _e1216.member_1, _e1216.member_2);
                                                        } else {
                                                            phi_2920_ = _e1216;
                                                        }
                                                        let _e2130 = phi_2920_;
                                                        phi_2921_ = _e2130;
                                                    } else {
                                                        phi_2921_ = _e1216;
                                                    }
                                                    let _e2132 = phi_2921_;
                                                    phi_2922_ = _e2132;
                                                } else {
                                                    phi_2922_ = _e1216;
                                                }
                                                let _e2134 = phi_2922_;
                                                phi_1222_ = _e2134;
                                            } else {
                                                phi_1222_ = type_43();
                                            }
                                            let _e2136 = phi_1222_;
                                            continue;
                                            continuing {
                                                phi_1221_ = _e2136;
                                                phi_1224_ = _e1204;
                                                phi_4425_ = _e665;
                                                break if !(_e1210);
                                            }
                                        }
                                        let _e2139 = phi_4425_;
                                        phi_4632_ = _e2139;
                                        if _e2139 {
                                            break;
                                        }
                                        phi_4636_ = _e2139;
                                        let _e2351 = local_12;
                                        phi_4197_ = _e2351;
                                        phi_4198_ = false;
                                        phi_4199_ = _e709;
                                        phi_4200_ = _e711;
                                    } else {
                                        if (_e711.member_1 >= _e96) {
                                            phi_3728_ = type_51(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), type_50(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u), type_50(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u));
                                        } else {
                                            if (_e711.member_1 < _e96) {
                                            } else {
                                                phi_4632_ = true;
                                                break;
                                            }
                                            let _e724 = ((1u + _e267) % 4u);
                                            if (_e724 < 4u) {
                                            } else {
                                                phi_4632_ = true;
                                                break;
                                            }
                                            let _e729 = global_3.member[_e711.member_1][_e724];
                                            let _e731 = (_e729 >> bitcast<u32>(11u));
                                            let _e733 = ((1u + _e266) % 4u);
                                            if (_e733 < 4u) {
                                            } else {
                                                phi_4632_ = true;
                                                break;
                                            }
                                            let _e738 = global_3.member[_e711.member_1][_e733];
                                            let _e740 = (_e738 >> bitcast<u32>(11u));
                                            let _e742 = ((1u + _e268) % 4u);
                                            if (_e742 < 4u) {
                                            } else {
                                                phi_4632_ = true;
                                                break;
                                            }
                                            let _e747 = global_3.member[_e711.member_1][_e742];
                                            let _e749 = (_e747 >> bitcast<u32>(11u));
                                            let _e772 = (bitcast<f32>((bitcast<u32>((_e711.member.member_1.x - _e711.member.member.x)) & 2139095040u)) * 0.001953125f);
                                            let _e773 = (bitcast<f32>((bitcast<u32>((_e711.member.member_1.y - _e711.member.member.y)) & 2139095040u)) * 0.001953125f);
                                            let _e774 = (bitcast<f32>((bitcast<u32>((_e711.member.member_1.z - _e711.member.member.z)) & 2139095040u)) * 0.001953125f);
                                            let _e776 = select(_e147, _e772, (_e772 > _e147));
                                            let _e778 = select(_e147, _e773, (_e773 > _e147));
                                            let _e780 = select(_e147, _e774, (_e774 > _e147));
                                            let _e811 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e729 & 1023u))) - 8388608f) * _e776));
                                            let _e816 = (bitcast<i32>((_e729 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e819 = bitcast<f32>((_e811 & bitcast<u32>(_e816)));
                                            let _e820 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e738 & 1023u))) - 8388608f) * _e778));
                                            let _e825 = (bitcast<i32>((_e738 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e828 = bitcast<f32>((_e820 & bitcast<u32>(_e825)));
                                            let _e829 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e747 & 1023u))) - 8388608f) * _e780));
                                            let _e834 = (bitcast<i32>((_e747 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e837 = bitcast<f32>((_e829 & bitcast<u32>(_e834)));
                                            let _e841 = bitcast<f32>((_e811 & bitcast<u32>(~(_e816))));
                                            let _e845 = bitcast<f32>((_e820 & bitcast<u32>(~(_e825))));
                                            let _e849 = bitcast<f32>((_e829 & bitcast<u32>(~(_e834))));
                                            let _e850 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e731 & 1023u))) - 8388608f) * _e776));
                                            let _e855 = (bitcast<i32>((_e731 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e858 = bitcast<f32>((_e850 & bitcast<u32>(_e855)));
                                            let _e859 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e740 & 1023u))) - 8388608f) * _e778));
                                            let _e864 = (bitcast<i32>((_e740 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e867 = bitcast<f32>((_e859 & bitcast<u32>(_e864)));
                                            let _e868 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e749 & 1023u))) - 8388608f) * _e780));
                                            let _e873 = (bitcast<i32>((_e749 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e876 = bitcast<f32>((_e868 & bitcast<u32>(_e873)));
                                            let _e880 = bitcast<f32>((_e850 & bitcast<u32>(~(_e855))));
                                            let _e884 = bitcast<f32>((_e859 & bitcast<u32>(~(_e864))));
                                            let _e888 = bitcast<f32>((_e868 & bitcast<u32>(~(_e873))));
                                            let _e889 = (_e711.member.member.x + _e819);
                                            let _e890 = (_e711.member.member.y + _e828);
                                            let _e891 = (_e711.member.member.z + _e837);
                                            let _e894 = (_e711.member.member_1.x - _e858);
                                            let _e895 = (_e711.member.member_1.y - _e867);
                                            let _e896 = (_e711.member.member_1.z - _e876);
                                            let _e915 = (_e894 - _e889);
                                            let _e916 = (_e895 - _e890);
                                            let _e917 = (_e896 - _e891);
                                            let _e919 = select(_e916, _e915, (_e915 > _e916));
                                            let _e921 = select(_e917, _e919, (_e919 > _e917));
                                            if (_e921 < (1024f * _e147)) {
                                                phi_3429_ = 0u;
                                            } else {
                                                phi_3429_ = select(2u, 1u, (_e921 < (2097152f * _e147)));
                                            }
                                            let _e928 = phi_3429_;
                                            switch bitcast<i32>(_e928) {
                                                case 0: {
                                                    phi_3435_ = 1u;
                                                    break;
                                                }
                                                case 1: {
                                                    phi_3435_ = 2u;
                                                    break;
                                                }
                                                case 2: {
                                                    phi_3435_ = 3u;
                                                    break;
                                                }
                                                default: {
                                                    phi_3435_ = u32();
                                                    break;
                                                }
                                            }
                                            let _e931 = phi_3435_;
                                            let _e937 = global_3.member[_e711.member_1][0u];
                                            let _e941 = global_3.member[_e711.member_1][1u];
                                            let _e945 = global_3.member[_e711.member_1][2u];
                                            let _e949 = global_3.member[_e711.member_1][3u];
                                            let _e961 = (((_e941 >> bitcast<u32>(22i)) | ((_e945 >> bitcast<u32>(22i)) << bitcast<u32>(10i))) | ((_e949 >> bitcast<u32>(22i)) << bitcast<u32>(20i)));
                                            let _e962 = (_e937 & 268435455u);
                                            let _e963 = (_e961 & 268435455u);
                                            let _e966 = ((_e937 >> bitcast<u32>(28u)) & 7u);
                                            let _e974 = ((_e937 >> bitcast<u32>(31i)) | (((_e961 >> bitcast<u32>(28u)) & 3u) << bitcast<u32>(1i)));
                                            let _e975 = (_e966 != 0u);
                                            if (_e966 == 0u) {
                                                phi_3690_ = _e962;
                                            } else {
                                                if (_e966 == 7u) {
                                                    phi_3689_ = 2147483648u;
                                                } else {
                                                    phi_3689_ = ((2147483648u | (_e966 << bitcast<u32>(28u))) | (_e963 & 268435455u));
                                                }
                                                let _e984 = phi_3689_;
                                                phi_3690_ = _e984;
                                            }
                                            let _e986 = phi_3690_;
                                            if _e975 {
                                                let _e987 = (_e966 != 7u);
                                                if _e987 {
                                                    phi_3700_ = (_e963 + (_e966 * ((3u * _e931) + 1u)));
                                                } else {
                                                    phi_3700_ = u32();
                                                }
                                                let _e991 = phi_3700_;
                                                phi_3702_ = _e991;
                                                phi_3703_ = select(true, false, _e987);
                                            } else {
                                                phi_3702_ = u32();
                                                phi_3703_ = true;
                                            }
                                            let _e994 = phi_3702_;
                                            let _e996 = phi_3703_;
                                            if (_e974 == 0u) {
                                                phi_3724_ = (_e962 + select(0u, 1u, !(_e975)));
                                            } else {
                                                if (_e974 == 7u) {
                                                    phi_3723_ = 2147483648u;
                                                } else {
                                                    phi_3723_ = ((2147483648u | (_e974 << bitcast<u32>(28u))) | (select(_e994, _e963, _e996) & 268435455u));
                                                }
                                                let _e1009 = phi_3723_;
                                                phi_3724_ = _e1009;
                                            }
                                            let _e1011 = phi_3724_;
                                            phi_3728_ = type_51(array<vec4<f32>, 3>(vec4<f32>(_e889, (_e711.member.member.x + _e841), _e894, (_e711.member.member_1.x - _e880)), vec4<f32>(_e890, (_e711.member.member.y + _e845), _e895, (_e711.member.member_1.y - _e884)), vec4<f32>(_e891, (_e711.member.member.z + _e849), _e896, (_e711.member.member_1.z - _e888))), type_50(type_32((_e711.member.member + vec4<f32>(_e819, _e828, _e837, 0f)), (_e711.member.member_1 - vec4<f32>(_e858, _e867, _e876, 0f))), _e986), type_50(type_32((_e711.member.member + vec4<f32>(_e841, _e845, _e849, 0f)), (_e711.member.member_1 - vec4<f32>(_e880, _e884, _e888, 0f))), _e1011));
                                        }
                                        let _e1016 = phi_3728_;
                                        let _e1035 = ((_e1016.member[0].x - _e369) * _e374);
                                        let _e1036 = ((_e1016.member[0].y - _e369) * _e374);
                                        let _e1037 = ((_e1016.member[0].z - _e370) * _e374);
                                        let _e1038 = ((_e1016.member[0].w - _e370) * _e374);
                                        let _e1048 = ((_e1016.member[1].x - _e437) * _e442);
                                        let _e1049 = ((_e1016.member[1].y - _e437) * _e442);
                                        let _e1050 = ((_e1016.member[1].z - _e438) * _e442);
                                        let _e1051 = ((_e1016.member[1].w - _e438) * _e442);
                                        let _e1061 = ((_e1016.member[2].x - _e505) * _e510);
                                        let _e1062 = ((_e1016.member[2].y - _e505) * _e510);
                                        let _e1063 = ((_e1016.member[2].z - _e506) * _e510);
                                        let _e1064 = ((_e1016.member[2].w - _e506) * _e510);
                                        let _e1066 = select(_e1063, _e1061, (_e1061 < _e1063));
                                        let _e1068 = select(_e1064, _e1062, (_e1062 < _e1064));
                                        let _e1070 = select(_e1063, _e1061, (_e1061 > _e1063));
                                        let _e1072 = select(_e1064, _e1062, (_e1062 > _e1064));
                                        let _e1074 = select(_e1037, _e1035, (_e1035 < _e1037));
                                        let _e1076 = select(_e1038, _e1036, (_e1036 < _e1038));
                                        let _e1078 = select(_e1050, _e1048, (_e1048 < _e1050));
                                        let _e1080 = select(_e1051, _e1049, (_e1049 < _e1051));
                                        let _e1082 = select(_e1078, _e1074, (_e1074 > _e1078));
                                        let _e1084 = select(_e1080, _e1076, (_e1076 > _e1080));
                                        let _e1086 = select(_e1066, _e1082, (_e1082 > _e1066));
                                        let _e1088 = select(_e1068, _e1084, (_e1084 > _e1068));
                                        let _e1090 = select(_e1037, _e1035, (_e1035 > _e1037));
                                        let _e1092 = select(_e1038, _e1036, (_e1036 > _e1038));
                                        let _e1094 = select(_e1050, _e1048, (_e1048 > _e1050));
                                        let _e1096 = select(_e1051, _e1049, (_e1049 > _e1051));
                                        let _e1098 = select(_e1094, _e1090, (_e1090 < _e1094));
                                        let _e1100 = select(_e1096, _e1092, (_e1092 < _e1096));
                                        let _e1105 = -(_e1066);
                                        let _e1106 = -(_e1068);
                                        let _e1113 = (select(_e1070, _e1098, (_e1098 < _e1070)) + (select(_e1105, _e1070, (_e1070 > _e1105)) * 0.0000019073523f));
                                        let _e1114 = (select(_e1072, _e1100, (_e1100 < _e1072)) + (select(_e1106, _e1072, (_e1072 > _e1106)) * 0.0000019073523f));
                                        let _e1116 = select(_e622, _e1086, (_e1086 > _e622));
                                        let _e1118 = select(_e622, _e1088, (_e1088 > _e622));
                                        let _e1123 = (_e1116 <= select(_e667.member.member_1, _e1113, (_e1113 < _e667.member.member_1)));
                                        let _e1124 = (_e1118 <= select(_e667.member.member_1, _e1114, (_e1114 < _e667.member.member_1)));
                                        let _e1125 = (_e1116 <= _e1118);
                                        if _e1123 {
                                            if _e1124 {
                                                if _e1125 {
                                                    phi_4093_ = _e1016.member_2;
                                                } else {
                                                    phi_4093_ = _e1016.member_1;
                                                }
                                                let _e1129 = phi_4093_;
                                                let _e1151 = (_e709 % 128u);
                                                let _e1152 = (_e1151 < 128u);
                                                if _e1152 {
                                                } else {
                                                    phi_4632_ = true;
                                                    break;
                                                }
                                                local_8[_e1151] = _e1129.member_1;
                                                if _e1152 {
                                                } else {
                                                    phi_4632_ = true;
                                                    break;
                                                }
                                                local_7[_e1151] = _e1129.member.member.x;
                                                if _e1152 {
                                                } else {
                                                    phi_4632_ = true;
                                                    break;
                                                }
                                                local_6[_e1151] = _e1129.member.member.y;
                                                if _e1152 {
                                                } else {
                                                    phi_4632_ = true;
                                                    break;
                                                }
                                                local_5[_e1151] = _e1129.member.member.z;
                                                if _e1152 {
                                                } else {
                                                    phi_4632_ = true;
                                                    break;
                                                }
                                                local_4[_e1151] = _e1129.member.member_1.x;
                                                if _e1152 {
                                                } else {
                                                    phi_4632_ = true;
                                                    break;
                                                }
                                                local_3[_e1151] = _e1129.member.member_1.y;
                                                if _e1152 {
                                                } else {
                                                    phi_4632_ = true;
                                                    break;
                                                }
                                                local_2[_e1151] = _e1129.member.member_1.z;
                                                if _e1152 {
                                                } else {
                                                    phi_4632_ = true;
                                                    break;
                                                }
                                                local_9[_e1151] = select(_e1118, _e1116, !(_e1125));
                                                if _e1125 {
                                                    phi_4170_ = _e1016.member_1;
                                                } else {
                                                    phi_4170_ = _e1016.member_2;
                                                }
                                                let _e1165 = phi_4170_;
                                                phi_4171_ = (_e709 + 1u);
                                                phi_4172_ = _e1165;
                                            } else {
                                                phi_4171_ = u32();
                                                phi_4172_ = type_50();
                                            }
                                            let _e1167 = phi_4171_;
                                            let _e1169 = phi_4172_;
                                            phi_4174_ = _e1167;
                                            phi_4175_ = _e1169;
                                            phi_4176_ = select(true, false, _e1124);
                                        } else {
                                            phi_4174_ = u32();
                                            phi_4175_ = type_50();
                                            phi_4176_ = true;
                                        }
                                        let _e1172 = phi_4174_;
                                        let _e1174 = phi_4175_;
                                        let _e1176 = phi_4176_;
                                        if _e1176 {
                                            if _e1123 {
                                                phi_4185_ = _e1016.member_1;
                                            } else {
                                                phi_4185_ = _e1016.member_2;
                                            }
                                            let _e1180 = phi_4185_;
                                            phi_4190_ = select(_e1124, true, _e1123);
                                            phi_4192_ = _e1180;
                                        } else {
                                            phi_4190_ = _e707;
                                            phi_4192_ = _e1174;
                                        }
                                        let _e1183 = phi_4190_;
                                        let _e1185 = phi_4192_;
                                        phi_4636_ = _e665;
                                        phi_4197_ = type_43(_e667.member, (_e667.member_1 + 1u), _e667.member_2);
                                        phi_4198_ = _e1183;
                                        phi_4199_ = select(_e1172, _e709, _e1176);
                                        phi_4200_ = _e1185;
                                    }
                                    let _e2141 = phi_4636_;
                                    let _e2143 = phi_4197_;
                                    let _e2145 = phi_4198_;
                                    let _e2147 = phi_4199_;
                                    let _e2149 = phi_4200_;
                                    phi_4635_ = _e2141;
                                    phi_4201_ = _e2143;
                                    phi_4202_ = _e2145;
                                    phi_4203_ = (_e671 - 1u);
                                    phi_4204_ = _e2147;
                                    phi_4205_ = _e2149;
                                } else {
                                    phi_4635_ = _e665;
                                    phi_4201_ = _e667;
                                    phi_4202_ = _e707;
                                    phi_4203_ = _e671;
                                    phi_4204_ = _e709;
                                    phi_4205_ = _e711;
                                }
                                let _e2151 = phi_4635_;
                                let _e2153 = phi_4201_;
                                let _e2155 = phi_4202_;
                                let _e2157 = phi_4203_;
                                let _e2159 = phi_4204_;
                                let _e2161 = phi_4205_;
                                phi_4634_ = _e2151;
                                phi_4206_ = _e2153;
                                phi_4207_ = _e2155;
                                phi_4208_ = _e2157;
                                phi_4209_ = _e2159;
                                phi_4210_ = _e2161;
                            } else {
                                phi_4634_ = _e665;
                                phi_4206_ = type_43();
                                phi_4207_ = bool();
                                phi_4208_ = u32();
                                phi_4209_ = u32();
                                phi_4210_ = type_50();
                            }
                            let _e2163 = phi_4634_;
                            let _e2165 = phi_4206_;
                            let _e2167 = phi_4207_;
                            let _e2169 = phi_4208_;
                            let _e2171 = phi_4209_;
                            let _e2173 = phi_4210_;
                            phi_4633_ = _e2163;
                            phi_1095_ = _e2165;
                            phi_1098_ = _e2167;
                            phi_1100_ = _e2169;
                            phi_1102_ = _e2171;
                            phi_1104_ = _e2173;
                            phi_4211_ = _e679;
                        } else {
                            phi_4633_ = _e665;
                            phi_1095_ = type_43();
                            phi_1098_ = bool();
                            phi_1100_ = u32();
                            phi_1102_ = u32();
                            phi_1104_ = type_50();
                            phi_4211_ = false;
                        }
                        let _e2175 = phi_4633_;
                        let _e2177 = phi_1095_;
                        let _e2179 = phi_1098_;
                        let _e2181 = phi_1100_;
                        let _e2183 = phi_1102_;
                        let _e2185 = phi_1104_;
                        let _e2187 = phi_4211_;
                        continue;
                        continuing {
                            phi_4431_ = _e2175;
                            phi_1094_ = _e2177;
                            phi_1097_ = _e2179;
                            phi_1099_ = _e2181;
                            phi_1101_ = _e2183;
                            phi_1103_ = _e2185;
                            phi_4632_ = _e2175;
                            break if !(_e2187);
                        }
                    }
                    let _e2190 = phi_4632_;
                    if _e2190 {
                        break;
                    }
                    let _e2192 = local_10;
                    let _e2195 = local_11;
                    if _e155 {
                    } else {
                        break;
                    }
                    global_6.member[_e153][0u] = _e2192.member_1;
                    global_6.member[_e153][1u] = _e2195.member_2;
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn trace_counted_q10_lattice(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
