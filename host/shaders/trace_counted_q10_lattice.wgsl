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
    var phi_4437_: bool;
    var phi_1094_: type_43;
    var phi_1097_: u32;
    var phi_1099_: bool;
    var phi_1101_: u32;
    var phi_1103_: type_50;
    var phi_1114_: bool;
    var phi_1200_: bool;
    var phi_1201_: u32;
    var phi_1202_: type_50;
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
    var phi_4431_: bool;
    var phi_4729_: bool;
    var phi_2923_: type_43;
    var phi_3425_: u32;
    var phi_3431_: u32;
    var phi_3685_: u32;
    var phi_3686_: u32;
    var phi_3696_: u32;
    var phi_3698_: u32;
    var phi_3699_: bool;
    var phi_3719_: u32;
    var phi_3720_: u32;
    var phi_3724_: type_51;
    var phi_4089_: type_50;
    var phi_4165_: type_50;
    var phi_4166_: u32;
    var phi_4167_: type_50;
    var phi_4169_: u32;
    var phi_4170_: type_50;
    var phi_4171_: bool;
    var phi_4180_: type_50;
    var phi_4185_: bool;
    var phi_4187_: type_50;
    var phi_4192_: type_43;
    var phi_4193_: bool;
    var phi_4194_: u32;
    var phi_4195_: type_50;
    var phi_4203_: type_43;
    var phi_4206_: type_50;
    var phi_4641_: bool;
    var phi_4207_: type_43;
    var phi_4208_: u32;
    var phi_4209_: bool;
    var phi_4210_: u32;
    var phi_4211_: type_50;
    var phi_4640_: bool;
    var phi_4212_: type_43;
    var phi_4213_: u32;
    var phi_4214_: bool;
    var phi_4215_: u32;
    var phi_4216_: type_50;
    var phi_4639_: bool;
    var phi_1095_: type_43;
    var phi_1098_: u32;
    var phi_1100_: bool;
    var phi_1102_: u32;
    var phi_1104_: type_50;
    var phi_4217_: bool;
    var phi_4638_: bool;
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
                    phi_4437_ = false;
                    phi_1094_ = type_43(type_37(type_28(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e620), 0u, 0u);
                    phi_1097_ = ((3u * _e96) + 1u);
                    phi_1099_ = (_e622 <= _e620);
                    phi_1101_ = 0u;
                    phi_1103_ = type_50(type_32(vec4<f32>((f32(_e630) * _e147), (f32(_e636) * _e147), (f32(_e642) * _e147), 0f), vec4<f32>((f32(_e647) * _e147), (f32(_e651) * _e147), (f32(_e655) * _e147), 0f)), select(0u, 2147483648u, (_e96 == 0u)));
                    loop {
                        let _e665 = phi_4437_;
                        let _e667 = phi_1094_;
                        let _e669 = phi_1097_;
                        let _e671 = phi_1099_;
                        let _e673 = phi_1101_;
                        let _e675 = phi_1103_;
                        local_10 = _e667;
                        local_11 = _e667;
                        if _e671 {
                            phi_1114_ = true;
                        } else {
                            phi_1114_ = (_e673 > 0u);
                        }
                        let _e678 = phi_1114_;
                        if _e678 {
                            let _e679 = (_e669 > 0u);
                            if _e679 {
                                if _e671 {
                                    phi_1200_ = _e671;
                                    phi_1201_ = _e673;
                                    phi_1202_ = _e675;
                                } else {
                                    let _e680 = (_e673 - 1u);
                                    let _e681 = (_e680 % 128u);
                                    let _e682 = (_e681 < 128u);
                                    if _e682 {
                                    } else {
                                        phi_4638_ = true;
                                        break;
                                    }
                                    let _e684 = local_7[_e681];
                                    if _e682 {
                                    } else {
                                        phi_4638_ = true;
                                        break;
                                    }
                                    let _e686 = local_6[_e681];
                                    if _e682 {
                                    } else {
                                        phi_4638_ = true;
                                        break;
                                    }
                                    let _e688 = local_5[_e681];
                                    if _e682 {
                                    } else {
                                        phi_4638_ = true;
                                        break;
                                    }
                                    let _e690 = local_4[_e681];
                                    if _e682 {
                                    } else {
                                        phi_4638_ = true;
                                        break;
                                    }
                                    let _e692 = local_3[_e681];
                                    if _e682 {
                                    } else {
                                        phi_4638_ = true;
                                        break;
                                    }
                                    let _e694 = local_2[_e681];
                                    if _e682 {
                                    } else {
                                        phi_4638_ = true;
                                        break;
                                    }
                                    let _e699 = local_8[_e681];
                                    if _e682 {
                                    } else {
                                        phi_4638_ = true;
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
                                    let _e715 = ((_e711.member_1 & 2147483648u) != 0u);
                                    let _e716 = (_e711.member_1 & 268435455u);
                                    if _e715 {
                                        phi_1221_ = _e667;
                                        phi_1224_ = type_8(0u, ((_e711.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e723 = phi_1221_;
                                            let _e725 = phi_1224_;
                                            local_12 = _e723;
                                            if (_e725.member < _e725.member_1) {
                                                phi_1225_ = type_8((_e725.member + 1u), _e725.member_1);
                                                phi_1247_ = type_8(1u, _e725.member);
                                            } else {
                                                phi_1225_ = _e725;
                                                phi_1247_ = type_8(0u, type_8().member_1);
                                            }
                                            let _e738 = phi_1225_;
                                            let _e740 = phi_1247_;
                                            let _e744 = (bitcast<i32>(_e740.member) != 0i);
                                            if _e744 {
                                                let _e750 = type_43(_e723.member, _e723.member_1, (_e723.member_2 + 1u));
                                                let _e755 = (_e711.member.member_1.x - _e711.member.member.x);
                                                let _e758 = (_e711.member.member_1.y - _e711.member.member.y);
                                                let _e761 = (_e711.member.member_1.z - _e711.member.member.z);
                                                let _e763 = select(_e758, _e755, (_e755 > _e758));
                                                let _e765 = select(_e761, _e763, (_e763 > _e761));
                                                let _e767 = (_e765 < (1024f * _e147));
                                                if _e767 {
                                                    phi_1291_ = 0u;
                                                } else {
                                                    phi_1291_ = select(2u, 1u, (_e765 < (2097152f * _e147)));
                                                }
                                                let _e772 = phi_1291_;
                                                switch bitcast<i32>(_e772) {
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
                                                let _e775 = phi_1297_;
                                                switch bitcast<i32>(_e772) {
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
                                                let _e782 = phi_1307_;
                                                let _e784 = ((_e716 + (_e740.member_1 * ((3u * _e775) + 1u))) + (3u * _e782));
                                                let _e785 = (_e784 < _e99);
                                                if _e785 {
                                                    if _e785 {
                                                    } else {
                                                        phi_4431_ = true;
                                                        break;
                                                    }
                                                    let _e787 = global_5.member[_e784];
                                                    phi_1323_ = _e787;
                                                } else {
                                                    phi_1323_ = 4294967295u;
                                                }
                                                let _e789 = phi_1323_;
                                                if _e767 {
                                                    phi_1356_ = 0u;
                                                } else {
                                                    phi_1356_ = select(2u, 1u, (_e765 < (2097152f * _e147)));
                                                }
                                                let _e794 = phi_1356_;
                                                switch bitcast<i32>(_e794) {
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
                                                let _e797 = phi_1362_;
                                                let _e801 = (_e716 + (_e740.member_1 * ((3u * _e797) + 1u)));
                                                switch bitcast<i32>(_e794) {
                                                    case 0: {
                                                        let _e1076 = (_e801 < _e99);
                                                        if _e1076 {
                                                            if _e1076 {
                                                            } else {
                                                                phi_4431_ = true;
                                                                break;
                                                            }
                                                            let _e1078 = global_5.member[_e801];
                                                            phi_1389_ = _e1078;
                                                        } else {
                                                            phi_1389_ = 0u;
                                                        }
                                                        let _e1080 = phi_1389_;
                                                        let _e1082 = ((10u * _e267) & 31u);
                                                        let _e1092 = ((10u * _e266) & 31u);
                                                        let _e1102 = ((10u * _e268) & 31u);
                                                        let _e1112 = (_e801 + 1u);
                                                        let _e1113 = (_e1112 < _e99);
                                                        if _e1113 {
                                                            if _e1113 {
                                                            } else {
                                                                phi_4431_ = true;
                                                                break;
                                                            }
                                                            let _e1115 = global_5.member[_e1112];
                                                            phi_1438_ = _e1115;
                                                        } else {
                                                            phi_1438_ = 0u;
                                                        }
                                                        let _e1117 = phi_1438_;
                                                        let _e1143 = (_e801 + 2u);
                                                        let _e1144 = (_e1143 < _e99);
                                                        if _e1144 {
                                                            if _e1144 {
                                                            } else {
                                                                phi_4431_ = true;
                                                                break;
                                                            }
                                                            let _e1146 = global_5.member[_e1143];
                                                            phi_1487_ = _e1146;
                                                        } else {
                                                            phi_1487_ = 0u;
                                                        }
                                                        let _e1148 = phi_1487_;
                                                        phi_1988_ = array<array<f32, 3>, 3>(array<f32, 3>((_e711.member.member.x + ((bitcast<f32>((1258291200u | ((_e1080 >> bitcast<u32>(_e1082)) & 1023u))) - 8388608f) * _e147)), (_e711.member.member.y + ((bitcast<f32>((1258291200u | ((_e1080 >> bitcast<u32>(_e1092)) & 1023u))) - 8388608f) * _e147)), (_e711.member.member.z + ((bitcast<f32>((1258291200u | ((_e1080 >> bitcast<u32>(_e1102)) & 1023u))) - 8388608f) * _e147))), array<f32, 3>((_e711.member.member.x + ((bitcast<f32>((1258291200u | ((_e1117 >> bitcast<u32>(_e1082)) & 1023u))) - 8388608f) * _e147)), (_e711.member.member.y + ((bitcast<f32>((1258291200u | ((_e1117 >> bitcast<u32>(_e1092)) & 1023u))) - 8388608f) * _e147)), (_e711.member.member.z + ((bitcast<f32>((1258291200u | ((_e1117 >> bitcast<u32>(_e1102)) & 1023u))) - 8388608f) * _e147))), array<f32, 3>((_e711.member.member.x + ((bitcast<f32>((1258291200u | ((_e1148 >> bitcast<u32>(_e1082)) & 1023u))) - 8388608f) * _e147)), (_e711.member.member.y + ((bitcast<f32>((1258291200u | ((_e1148 >> bitcast<u32>(_e1092)) & 1023u))) - 8388608f) * _e147)), (_e711.member.member.z + ((bitcast<f32>((1258291200u | ((_e1148 >> bitcast<u32>(_e1102)) & 1023u))) - 8388608f) * _e147))));
                                                        break;
                                                    }
                                                    case 1: {
                                                        let _e890 = (_e801 < _e99);
                                                        if _e890 {
                                                            if _e890 {
                                                            } else {
                                                                phi_4431_ = true;
                                                                break;
                                                            }
                                                            let _e892 = global_5.member[_e801];
                                                            phi_1536_ = _e892;
                                                        } else {
                                                            phi_1536_ = 0u;
                                                        }
                                                        let _e894 = phi_1536_;
                                                        let _e895 = (_e801 + 1u);
                                                        let _e896 = (_e895 < _e99);
                                                        if _e896 {
                                                            if _e896 {
                                                            } else {
                                                                phi_4431_ = true;
                                                                break;
                                                            }
                                                            let _e898 = global_5.member[_e895];
                                                            phi_1551_ = _e898;
                                                        } else {
                                                            phi_1551_ = 0u;
                                                        }
                                                        let _e900 = phi_1551_;
                                                        let _e901 = (_e267 == 1u);
                                                        if _e901 {
                                                            phi_1561_ = ((_e894 >> bitcast<u32>(21i)) | (_e900 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1561_ = (_e900 >> bitcast<u32>(10i));
                                                        }
                                                        let _e910 = phi_1561_;
                                                        let _e918 = (_e266 == 1u);
                                                        if _e918 {
                                                            phi_1582_ = ((_e894 >> bitcast<u32>(21i)) | (_e900 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1582_ = (_e900 >> bitcast<u32>(10i));
                                                        }
                                                        let _e927 = phi_1582_;
                                                        let _e935 = (_e268 == 1u);
                                                        if _e935 {
                                                            phi_1603_ = ((_e894 >> bitcast<u32>(21i)) | (_e900 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1603_ = (_e900 >> bitcast<u32>(10i));
                                                        }
                                                        let _e944 = phi_1603_;
                                                        let _e953 = (_e801 + 2u);
                                                        let _e954 = (_e953 < _e99);
                                                        if _e954 {
                                                            if _e954 {
                                                            } else {
                                                                phi_4431_ = true;
                                                                break;
                                                            }
                                                            let _e956 = global_5.member[_e953];
                                                            phi_1633_ = _e956;
                                                        } else {
                                                            phi_1633_ = 0u;
                                                        }
                                                        let _e958 = phi_1633_;
                                                        let _e959 = (_e801 + 3u);
                                                        let _e960 = (_e959 < _e99);
                                                        if _e960 {
                                                            if _e960 {
                                                            } else {
                                                                phi_4431_ = true;
                                                                break;
                                                            }
                                                            let _e962 = global_5.member[_e959];
                                                            phi_1648_ = _e962;
                                                        } else {
                                                            phi_1648_ = 0u;
                                                        }
                                                        let _e964 = phi_1648_;
                                                        if _e901 {
                                                            phi_1658_ = ((_e958 >> bitcast<u32>(21i)) | (_e964 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1658_ = (_e964 >> bitcast<u32>(10i));
                                                        }
                                                        let _e973 = phi_1658_;
                                                        if _e918 {
                                                            phi_1679_ = ((_e958 >> bitcast<u32>(21i)) | (_e964 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1679_ = (_e964 >> bitcast<u32>(10i));
                                                        }
                                                        let _e989 = phi_1679_;
                                                        if _e935 {
                                                            phi_1700_ = ((_e958 >> bitcast<u32>(21i)) | (_e964 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1700_ = (_e964 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1005 = phi_1700_;
                                                        let _e1014 = (_e801 + 4u);
                                                        let _e1015 = (_e1014 < _e99);
                                                        if _e1015 {
                                                            if _e1015 {
                                                            } else {
                                                                phi_4431_ = true;
                                                                break;
                                                            }
                                                            let _e1017 = global_5.member[_e1014];
                                                            phi_1730_ = _e1017;
                                                        } else {
                                                            phi_1730_ = 0u;
                                                        }
                                                        let _e1019 = phi_1730_;
                                                        let _e1020 = (_e801 + 5u);
                                                        let _e1021 = (_e1020 < _e99);
                                                        if _e1021 {
                                                            if _e1021 {
                                                            } else {
                                                                phi_4431_ = true;
                                                                break;
                                                            }
                                                            let _e1023 = global_5.member[_e1020];
                                                            phi_1745_ = _e1023;
                                                        } else {
                                                            phi_1745_ = 0u;
                                                        }
                                                        let _e1025 = phi_1745_;
                                                        if _e901 {
                                                            phi_1755_ = ((_e1019 >> bitcast<u32>(21i)) | (_e1025 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1755_ = (_e1025 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1034 = phi_1755_;
                                                        if _e918 {
                                                            phi_1776_ = ((_e1019 >> bitcast<u32>(21i)) | (_e1025 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1776_ = (_e1025 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1050 = phi_1776_;
                                                        if _e935 {
                                                            phi_1797_ = ((_e1019 >> bitcast<u32>(21i)) | (_e1025 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1797_ = (_e1025 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1066 = phi_1797_;
                                                        phi_1988_ = array<array<f32, 3>, 3>(array<f32, 3>((_e711.member.member.x + ((bitcast<f32>((1258291200u | (select(_e910, _e894, _e306) & 2097151u))) - 8388608f) * _e147)), (_e711.member.member.y + ((bitcast<f32>((1258291200u | (select(_e927, _e894, _e375) & 2097151u))) - 8388608f) * _e147)), (_e711.member.member.z + ((bitcast<f32>((1258291200u | (select(_e944, _e894, _e443) & 2097151u))) - 8388608f) * _e147))), array<f32, 3>((_e711.member.member.x + ((bitcast<f32>((1258291200u | (select(_e973, _e958, _e306) & 2097151u))) - 8388608f) * _e147)), (_e711.member.member.y + ((bitcast<f32>((1258291200u | (select(_e989, _e958, _e375) & 2097151u))) - 8388608f) * _e147)), (_e711.member.member.z + ((bitcast<f32>((1258291200u | (select(_e1005, _e958, _e443) & 2097151u))) - 8388608f) * _e147))), array<f32, 3>((_e711.member.member.x + ((bitcast<f32>((1258291200u | (select(_e1034, _e1019, _e306) & 2097151u))) - 8388608f) * _e147)), (_e711.member.member.y + ((bitcast<f32>((1258291200u | (select(_e1050, _e1019, _e375) & 2097151u))) - 8388608f) * _e147)), (_e711.member.member.z + ((bitcast<f32>((1258291200u | (select(_e1066, _e1019, _e443) & 2097151u))) - 8388608f) * _e147))));
                                                        break;
                                                    }
                                                    case 2: {
                                                        let _e803 = (_e801 + _e267);
                                                        let _e804 = (_e803 < _e99);
                                                        if _e804 {
                                                            if _e804 {
                                                            } else {
                                                                phi_4431_ = true;
                                                                break;
                                                            }
                                                            let _e806 = global_5.member[_e803];
                                                            phi_1828_ = _e806;
                                                        } else {
                                                            phi_1828_ = 0u;
                                                        }
                                                        let _e808 = phi_1828_;
                                                        let _e812 = (_e801 + _e266);
                                                        let _e813 = (_e812 < _e99);
                                                        if _e813 {
                                                            if _e813 {
                                                            } else {
                                                                phi_4431_ = true;
                                                                break;
                                                            }
                                                            let _e815 = global_5.member[_e812];
                                                            phi_1846_ = _e815;
                                                        } else {
                                                            phi_1846_ = 0u;
                                                        }
                                                        let _e817 = phi_1846_;
                                                        let _e821 = (_e801 + _e268);
                                                        let _e822 = (_e821 < _e99);
                                                        if _e822 {
                                                            if _e822 {
                                                            } else {
                                                                phi_4431_ = true;
                                                                break;
                                                            }
                                                            let _e824 = global_5.member[_e821];
                                                            phi_1864_ = _e824;
                                                        } else {
                                                            phi_1864_ = 0u;
                                                        }
                                                        let _e826 = phi_1864_;
                                                        let _e831 = (_e801 + 3u);
                                                        let _e832 = (_e831 + _e267);
                                                        let _e833 = (_e832 < _e99);
                                                        if _e833 {
                                                            if _e833 {
                                                            } else {
                                                                phi_4431_ = true;
                                                                break;
                                                            }
                                                            let _e835 = global_5.member[_e832];
                                                            phi_1887_ = _e835;
                                                        } else {
                                                            phi_1887_ = 0u;
                                                        }
                                                        let _e837 = phi_1887_;
                                                        let _e841 = (_e831 + _e266);
                                                        let _e842 = (_e841 < _e99);
                                                        if _e842 {
                                                            if _e842 {
                                                            } else {
                                                                phi_4431_ = true;
                                                                break;
                                                            }
                                                            let _e844 = global_5.member[_e841];
                                                            phi_1905_ = _e844;
                                                        } else {
                                                            phi_1905_ = 0u;
                                                        }
                                                        let _e846 = phi_1905_;
                                                        let _e850 = (_e831 + _e268);
                                                        let _e851 = (_e850 < _e99);
                                                        if _e851 {
                                                            if _e851 {
                                                            } else {
                                                                phi_4431_ = true;
                                                                break;
                                                            }
                                                            let _e853 = global_5.member[_e850];
                                                            phi_1923_ = _e853;
                                                        } else {
                                                            phi_1923_ = 0u;
                                                        }
                                                        let _e855 = phi_1923_;
                                                        let _e860 = (_e801 + 6u);
                                                        let _e861 = (_e860 + _e267);
                                                        let _e862 = (_e861 < _e99);
                                                        if _e862 {
                                                            if _e862 {
                                                            } else {
                                                                phi_4431_ = true;
                                                                break;
                                                            }
                                                            let _e864 = global_5.member[_e861];
                                                            phi_1946_ = _e864;
                                                        } else {
                                                            phi_1946_ = 0u;
                                                        }
                                                        let _e866 = phi_1946_;
                                                        let _e870 = (_e860 + _e266);
                                                        let _e871 = (_e870 < _e99);
                                                        if _e871 {
                                                            if _e871 {
                                                            } else {
                                                                phi_4431_ = true;
                                                                break;
                                                            }
                                                            let _e873 = global_5.member[_e870];
                                                            phi_1964_ = _e873;
                                                        } else {
                                                            phi_1964_ = 0u;
                                                        }
                                                        let _e875 = phi_1964_;
                                                        let _e879 = (_e860 + _e268);
                                                        let _e880 = (_e879 < _e99);
                                                        if _e880 {
                                                            if _e880 {
                                                            } else {
                                                                phi_4431_ = true;
                                                                break;
                                                            }
                                                            let _e882 = global_5.member[_e879];
                                                            phi_1982_ = _e882;
                                                        } else {
                                                            phi_1982_ = 0u;
                                                        }
                                                        let _e884 = phi_1982_;
                                                        phi_1988_ = array<array<f32, 3>, 3>(array<f32, 3>((f32(bitcast<i32>(_e808)) * _e147), (f32(bitcast<i32>(_e817)) * _e147), (f32(bitcast<i32>(_e826)) * _e147)), array<f32, 3>((f32(bitcast<i32>(_e837)) * _e147), (f32(bitcast<i32>(_e846)) * _e147), (f32(bitcast<i32>(_e855)) * _e147)), array<f32, 3>((f32(bitcast<i32>(_e866)) * _e147), (f32(bitcast<i32>(_e875)) * _e147), (f32(bitcast<i32>(_e884)) * _e147)));
                                                        break;
                                                    }
                                                    default: {
                                                        phi_1988_ = array<array<f32, 3>, 3>();
                                                        break;
                                                    }
                                                }
                                                let _e1176 = phi_1988_;
                                                let _e1185 = (_e1176[0][2] - _e468);
                                                let _e1188 = (((_e1176[0][0] - _e331) * _e507) - (_e1185 * _e371));
                                                let _e1191 = (((_e1176[0][1] - _e400) * _e507) - (_e1185 * _e439));
                                                let _e1198 = (_e1176[1][2] - _e468);
                                                let _e1201 = (((_e1176[1][0] - _e331) * _e507) - (_e1198 * _e371));
                                                let _e1204 = (((_e1176[1][1] - _e400) * _e507) - (_e1198 * _e439));
                                                let _e1211 = (_e1176[2][2] - _e468);
                                                let _e1214 = (((_e1176[2][0] - _e331) * _e507) - (_e1211 * _e371));
                                                let _e1217 = (((_e1176[2][1] - _e400) * _e507) - (_e1211 * _e439));
                                                let _e1218 = (_e1214 * _e1204);
                                                let _e1219 = (_e1217 * _e1201);
                                                let _e1220 = (_e1188 * _e1217);
                                                let _e1221 = (_e1191 * _e1214);
                                                let _e1222 = (_e1201 * _e1191);
                                                let _e1223 = (_e1204 * _e1188);
                                                let _e1228 = (((_e1218 >= _e1219) && (_e1220 >= _e1221)) && (_e1222 >= _e1223));
                                                if (_e1228 || (((_e1218 <= _e1219) && (_e1220 <= _e1221)) && (_e1222 <= _e1223))) {
                                                    let _e1235 = select(-1f, 1f, _e1228);
                                                    let _e1237 = ((_e1218 - _e1219) * _e1235);
                                                    let _e1239 = select(0f, _e1237, (_e1237 > 0f));
                                                    let _e1241 = ((_e1220 - _e1221) * _e1235);
                                                    let _e1243 = select(0f, _e1241, (_e1241 > 0f));
                                                    let _e1245 = ((_e1222 - _e1223) * _e1235);
                                                    let _e1247 = select(0f, _e1245, (_e1245 > 0f));
                                                    let _e1249 = ((_e1239 + _e1243) + _e1247);
                                                    if (_e1249 < 0.000000000000000000000000000000000000011754944f) {
                                                        phi_2872_ = type_28();
                                                        phi_2873_ = true;
                                                        phi_2874_ = false;
                                                    } else {
                                                        let _e1252 = select(_e1201, _e1188, (_e1188 < _e1201));
                                                        if (select(_e1214, _e1252, (_e1252 < _e1214)) > 0f) {
                                                            phi_2140_ = true;
                                                        } else {
                                                            let _e1257 = select(_e1201, _e1188, (_e1188 > _e1201));
                                                            phi_2140_ = (select(_e1214, _e1257, (_e1257 > _e1214)) < 0f);
                                                        }
                                                        let _e1262 = phi_2140_;
                                                        if _e1262 {
                                                            phi_2869_ = type_28();
                                                            phi_2870_ = true;
                                                            phi_2871_ = false;
                                                        } else {
                                                            let _e1264 = select(_e1204, _e1191, (_e1191 < _e1204));
                                                            if (select(_e1217, _e1264, (_e1264 < _e1217)) > 0f) {
                                                                phi_2169_ = true;
                                                            } else {
                                                                let _e1269 = select(_e1204, _e1191, (_e1191 > _e1204));
                                                                phi_2169_ = (select(_e1217, _e1269, (_e1269 > _e1217)) < 0f);
                                                            }
                                                            let _e1274 = phi_2169_;
                                                            if _e1274 {
                                                                phi_2867_ = type_28();
                                                                phi_2868_ = false;
                                                            } else {
                                                                let _e1276 = select(_e1176[1][0], _e1176[0][0], (_e1176[0][0] < _e1176[1][0]));
                                                                let _e1280 = select(_e1176[1][0], _e1176[0][0], (_e1176[0][0] > _e1176[1][0]));
                                                                let _e1284 = select(_e1176[1][1], _e1176[0][1], (_e1176[0][1] < _e1176[1][1]));
                                                                let _e1288 = select(_e1176[1][1], _e1176[0][1], (_e1176[0][1] > _e1176[1][1]));
                                                                let _e1292 = select(_e1176[1][2], _e1176[0][2], (_e1176[0][2] < _e1176[1][2]));
                                                                let _e1296 = select(_e1176[1][2], _e1176[0][2], (_e1176[0][2] > _e1176[1][2]));
                                                                let _e1301 = ((select(_e1176[2][0], _e1276, (_e1276 < _e1176[2][0])) - _e369) * _e374);
                                                                let _e1302 = ((select(_e1176[2][0], _e1280, (_e1280 > _e1176[2][0])) - _e370) * _e374);
                                                                let _e1305 = ((select(_e1176[2][1], _e1284, (_e1284 < _e1176[2][1])) - _e437) * _e442);
                                                                let _e1306 = ((select(_e1176[2][1], _e1288, (_e1288 > _e1176[2][1])) - _e438) * _e442);
                                                                let _e1309 = ((select(_e1176[2][2], _e1292, (_e1292 < _e1176[2][2])) - _e505) * _e510);
                                                                let _e1310 = ((select(_e1176[2][2], _e1296, (_e1296 > _e1176[2][2])) - _e506) * _e510);
                                                                let _e1312 = select(_e1310, _e1309, (_e1309 < _e1310));
                                                                let _e1314 = select(_e1310, _e1309, (_e1309 > _e1310));
                                                                let _e1316 = select(_e1302, _e1301, (_e1301 < _e1302));
                                                                let _e1318 = select(_e1306, _e1305, (_e1305 < _e1306));
                                                                let _e1320 = select(_e1318, _e1316, (_e1316 > _e1318));
                                                                let _e1322 = select(_e1312, _e1320, (_e1320 > _e1312));
                                                                let _e1324 = select(_e1302, _e1301, (_e1301 > _e1302));
                                                                let _e1326 = select(_e1306, _e1305, (_e1305 > _e1306));
                                                                let _e1328 = select(_e1326, _e1324, (_e1324 < _e1326));
                                                                let _e1330 = select(_e1314, _e1328, (_e1328 < _e1314));
                                                                let _e1331 = -(_e1312);
                                                                let _e1337 = select(_e622, _e1322, (_e1322 > _e622));
                                                                if (_e1337 > (_e1330 + (select(_e1331, _e1314, (_e1314 > _e1331)) * 0.0000019073523f))) {
                                                                    phi_2862_ = type_28();
                                                                    phi_2863_ = true;
                                                                } else {
                                                                    let _e1339 = (_e1337 > _e723.member.member_1);
                                                                    if _e1339 {
                                                                        phi_2861_ = type_28();
                                                                    } else {
                                                                        let _e1340 = vec3<f32>(_e1176[0][0], _e1176[0][1], _e1176[0][2]);
                                                                        let _e1341 = vec3<f32>(_e1176[1][0], _e1176[1][1], _e1176[1][2]);
                                                                        let _e1342 = vec3<f32>(_e1176[2][0], _e1176[2][1], _e1176[2][2]);
                                                                        let _e1343 = (_e1176[1][0] - _e1176[0][0]);
                                                                        let _e1344 = (_e1176[1][1] - _e1176[0][1]);
                                                                        let _e1345 = (_e1176[1][2] - _e1176[0][2]);
                                                                        let _e1346 = vec3<f32>(_e1343, _e1344, _e1345);
                                                                        let _e1347 = (_e1176[2][0] - _e1176[1][0]);
                                                                        let _e1348 = (_e1176[2][1] - _e1176[1][1]);
                                                                        let _e1349 = (_e1176[2][2] - _e1176[1][2]);
                                                                        let _e1350 = vec3<f32>(_e1347, _e1348, _e1349);
                                                                        let _e1351 = (_e1176[0][0] - _e1176[2][0]);
                                                                        let _e1352 = (_e1176[0][1] - _e1176[2][1]);
                                                                        let _e1353 = (_e1176[0][2] - _e1176[2][2]);
                                                                        let _e1354 = vec3<f32>(_e1351, _e1352, _e1353);
                                                                        let _e1357 = bitcast<f32>((bitcast<u32>(_e1343) & 2147483647u));
                                                                        let _e1360 = bitcast<f32>((bitcast<u32>(_e1344) & 2147483647u));
                                                                        let _e1362 = select(_e1360, _e1357, (_e1357 > _e1360));
                                                                        let _e1365 = bitcast<f32>((bitcast<u32>(_e1345) & 2147483647u));
                                                                        let _e1367 = select(_e1365, _e1362, (_e1362 > _e1365));
                                                                        let _e1370 = bitcast<f32>((bitcast<u32>(_e1347) & 2147483647u));
                                                                        let _e1373 = bitcast<f32>((bitcast<u32>(_e1348) & 2147483647u));
                                                                        let _e1375 = select(_e1373, _e1370, (_e1370 > _e1373));
                                                                        let _e1378 = bitcast<f32>((bitcast<u32>(_e1349) & 2147483647u));
                                                                        let _e1380 = select(_e1378, _e1375, (_e1375 > _e1378));
                                                                        let _e1383 = bitcast<f32>((bitcast<u32>(_e1351) & 2147483647u));
                                                                        let _e1386 = bitcast<f32>((bitcast<u32>(_e1352) & 2147483647u));
                                                                        let _e1388 = select(_e1386, _e1383, (_e1383 > _e1386));
                                                                        let _e1391 = bitcast<f32>((bitcast<u32>(_e1353) & 2147483647u));
                                                                        let _e1393 = select(_e1391, _e1388, (_e1388 > _e1391));
                                                                        let _e1395 = select(_e1380, _e1367, (_e1367 > _e1380));
                                                                        let _e1397 = select(_e1393, _e1395, (_e1395 > _e1393));
                                                                        if (_e1367 == _e1397) {
                                                                            phi_2588_ = _e1204;
                                                                            phi_2589_ = _e1201;
                                                                            phi_2590_ = _e1191;
                                                                            phi_2591_ = _e1188;
                                                                            phi_2592_ = _e1340;
                                                                            phi_2593_ = _e1354;
                                                                            phi_2594_ = _e1350;
                                                                            phi_2595_ = _e1346;
                                                                        } else {
                                                                            let _e1399 = (_e1380 == _e1397);
                                                                            let _e1404 = vec3(_e1399);
                                                                            phi_2588_ = select(_e1191, _e1217, _e1399);
                                                                            phi_2589_ = select(_e1188, _e1214, _e1399);
                                                                            phi_2590_ = select(_e1217, _e1204, _e1399);
                                                                            phi_2591_ = select(_e1214, _e1201, _e1399);
                                                                            phi_2592_ = select(_e1342, _e1341, _e1404);
                                                                            phi_2593_ = select(_e1350, _e1346, _e1404);
                                                                            phi_2594_ = select(_e1346, _e1354, _e1404);
                                                                            phi_2595_ = select(_e1354, _e1350, _e1404);
                                                                        }
                                                                        let _e1410 = phi_2588_;
                                                                        let _e1412 = phi_2589_;
                                                                        let _e1414 = phi_2590_;
                                                                        let _e1416 = phi_2591_;
                                                                        let _e1418 = phi_2592_;
                                                                        let _e1420 = phi_2593_;
                                                                        let _e1422 = phi_2594_;
                                                                        let _e1424 = phi_2595_;
                                                                        let _e1431 = ((_e1422.y * _e1420.z) - (_e1420.y * _e1422.z));
                                                                        let _e1436 = ((_e1422.z * _e1420.x) - (_e1420.z * _e1422.x));
                                                                        let _e1439 = ((_e1422.x * _e1420.y) - (_e1420.x * _e1422.y));
                                                                        if (_e1239 >= _e1243) {
                                                                            phi_2632_ = select(true, false, (_e1239 >= _e1247));
                                                                        } else {
                                                                            phi_2632_ = true;
                                                                        }
                                                                        let _e1444 = phi_2632_;
                                                                        if _e1444 {
                                                                            phi_2641_ = select(_e1342, _e1341, vec3((_e1243 >= _e1247)));
                                                                        } else {
                                                                            phi_2641_ = _e1340;
                                                                        }
                                                                        let _e1449 = phi_2641_;
                                                                        let _e1460 = (((_e1431 * (_e1449.x - _e331)) + (_e1436 * (_e1449.y - _e400))) + (_e1439 * (_e1449.z - _e468)));
                                                                        let _e1465 = (((_e1431 * _e371) + (_e1436 * _e439)) + (_e1439 * _e507));
                                                                        let _e1466 = (_e1412 - _e1416);
                                                                        let _e1467 = (_e1410 - _e1414);
                                                                        let _e1475 = (-(((_e1416 * _e1466) + (_e1414 * _e1467))) / ((_e1466 * _e1466) + (_e1467 * _e1467)));
                                                                        let _e1477 = select(1f, _e1475, (_e1475 < 1f));
                                                                        let _e1479 = select(0f, _e1477, (_e1477 > 0f));
                                                                        let _e1492 = ((_e1418.x + (_e1424.x * _e1479)) - _e331);
                                                                        let _e1493 = ((_e1418.y + (_e1424.y * _e1479)) - _e400);
                                                                        let _e1494 = ((_e1418.z + (_e1424.z * _e1479)) - _e468);
                                                                        let _e1495 = (_e1494 / _e507);
                                                                        let _e1507 = bitcast<f32>((bitcast<u32>(_e1492) & 2147483647u));
                                                                        let _e1510 = bitcast<f32>((bitcast<u32>(_e1493) & 2147483647u));
                                                                        let _e1512 = select(_e1510, _e1507, (_e1507 > _e1510));
                                                                        let _e1515 = bitcast<f32>((bitcast<u32>(_e1494) & 2147483647u));
                                                                        let _e1517 = select(_e1515, _e1512, (_e1512 > _e1515));
                                                                        let _e1523 = bitcast<f32>((bitcast<u32>(_e1431) & 2147483647u));
                                                                        let _e1526 = bitcast<f32>((bitcast<u32>(_e1436) & 2147483647u));
                                                                        let _e1528 = select(_e1526, _e1523, (_e1523 > _e1526));
                                                                        let _e1531 = bitcast<f32>((bitcast<u32>(_e1439) & 2147483647u));
                                                                        if (bitcast<f32>((bitcast<u32>(((((_e1431 * _e1492) + (_e1436 * _e1493)) + (_e1439 * _e1494)) - _e1460)) & 2147483647u)) <= ((0.0000009536743f * select(_e1397, _e1517, (_e1517 > _e1397))) * select(_e1531, _e1528, (_e1528 > _e1531)))) {
                                                                            let _e1541 = bitcast<f32>((bitcast<u32>(_e1422.x) & 2147483647u));
                                                                            let _e1544 = bitcast<f32>((bitcast<u32>(_e1422.y) & 2147483647u));
                                                                            let _e1546 = select(_e1544, _e1541, (_e1541 > _e1544));
                                                                            let _e1549 = bitcast<f32>((bitcast<u32>(_e1422.z) & 2147483647u));
                                                                            let _e1555 = bitcast<f32>((bitcast<u32>(_e1420.x) & 2147483647u));
                                                                            let _e1558 = bitcast<f32>((bitcast<u32>(_e1420.y) & 2147483647u));
                                                                            let _e1560 = select(_e1558, _e1555, (_e1555 > _e1558));
                                                                            let _e1563 = bitcast<f32>((bitcast<u32>(_e1420.z) & 2147483647u));
                                                                            let _e1567 = (bitcast<f32>((bitcast<u32>(_e1465) & 2147483647u)) > ((0.0000038146973f * select(_e1549, _e1546, (_e1546 > _e1549))) * select(_e1563, _e1560, (_e1560 > _e1563))));
                                                                            if _e1567 {
                                                                                phi_2806_ = (_e1460 / _e1465);
                                                                            } else {
                                                                                phi_2806_ = f32();
                                                                            }
                                                                            let _e1570 = phi_2806_;
                                                                            phi_2808_ = _e1570;
                                                                            phi_2809_ = select(true, false, _e1567);
                                                                        } else {
                                                                            phi_2808_ = f32();
                                                                            phi_2809_ = true;
                                                                        }
                                                                        let _e1573 = phi_2808_;
                                                                        let _e1575 = phi_2809_;
                                                                        if _e1575 {
                                                                            let _e1583 = (((_e1431 * (_e1492 - (_e371 * _e1495))) + (_e1436 * (_e1493 - (_e439 * _e1495)))) / _e1465);
                                                                            if (bitcast<f32>((bitcast<u32>(_e1583) & 2147483647u)) <= _e1397) {
                                                                                phi_2829_ = (_e1495 + _e1583);
                                                                            } else {
                                                                                phi_2829_ = _e1495;
                                                                            }
                                                                            let _e1590 = phi_2829_;
                                                                            phi_2830_ = _e1590;
                                                                        } else {
                                                                            phi_2830_ = _e1573;
                                                                        }
                                                                        let _e1592 = phi_2830_;
                                                                        let _e1594 = select(_e1330, _e1592, (_e1592 < _e1330));
                                                                        let _e1596 = select(_e1322, _e1594, (_e1594 > _e1322));
                                                                        if (_e1596 >= _e622) {
                                                                            let _e1598 = (_e1596 <= _e723.member.member_1);
                                                                            if _e1598 {
                                                                                let _e1599 = (1f / _e1249);
                                                                                phi_2853_ = type_28(_e1596, (_e1243 * _e1599), (_e1247 * _e1599), _e789);
                                                                            } else {
                                                                                phi_2853_ = type_28();
                                                                            }
                                                                            let _e1604 = phi_2853_;
                                                                            phi_2855_ = _e1604;
                                                                            phi_2856_ = select(true, false, _e1598);
                                                                        } else {
                                                                            phi_2855_ = type_28();
                                                                            phi_2856_ = true;
                                                                        }
                                                                        let _e1607 = phi_2855_;
                                                                        let _e1609 = phi_2856_;
                                                                        if _e1609 {
                                                                            phi_2860_ = type_28(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                        } else {
                                                                            phi_2860_ = _e1607;
                                                                        }
                                                                        let _e1611 = phi_2860_;
                                                                        phi_2861_ = _e1611;
                                                                    }
                                                                    let _e1613 = phi_2861_;
                                                                    phi_2862_ = _e1613;
                                                                    phi_2863_ = _e1339;
                                                                }
                                                                let _e1615 = phi_2862_;
                                                                let _e1617 = phi_2863_;
                                                                phi_2867_ = _e1615;
                                                                phi_2868_ = _e1617;
                                                            }
                                                            let _e1619 = phi_2867_;
                                                            let _e1621 = phi_2868_;
                                                            phi_2869_ = _e1619;
                                                            phi_2870_ = _e1274;
                                                            phi_2871_ = _e1621;
                                                        }
                                                        let _e1623 = phi_2869_;
                                                        let _e1625 = phi_2870_;
                                                        let _e1627 = phi_2871_;
                                                        phi_2872_ = _e1623;
                                                        phi_2873_ = _e1625;
                                                        phi_2874_ = _e1627;
                                                    }
                                                    let _e1629 = phi_2872_;
                                                    let _e1631 = phi_2873_;
                                                    let _e1633 = phi_2874_;
                                                    phi_2882_ = _e1629;
                                                    phi_2883_ = select(_e1633, true, _e1631);
                                                } else {
                                                    phi_2882_ = type_28();
                                                    phi_2883_ = true;
                                                }
                                                let _e1636 = phi_2882_;
                                                let _e1638 = phi_2883_;
                                                if _e1638 {
                                                    phi_2887_ = type_28(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                } else {
                                                    phi_2887_ = _e1636;
                                                }
                                                let _e1640 = phi_2887_;
                                                if (_e1640.member_3 != 4294967295u) {
                                                    if (_e789 != 4294967295u) {
                                                        if (_e1640.member < _e723.member.member.member) {
                                                            phi_2913_ = true;
                                                        } else {
                                                            if (_e1640.member == _e723.member.member.member) {
                                                                phi_2912_ = (_e1640.member_3 < _e723.member.member.member_3);
                                                            } else {
                                                                phi_2912_ = false;
                                                            }
                                                            let _e1655 = phi_2912_;
                                                            phi_2913_ = _e1655;
                                                        }
                                                        let _e1657 = phi_2913_;
                                                        if _e1657 {
                                                            phi_2920_ = type_43(type_37(_e1640, _e1640.member), _e750.member_1, _e750.member_2);
                                                        } else {
                                                            phi_2920_ = _e750;
                                                        }
                                                        let _e1664 = phi_2920_;
                                                        phi_2921_ = _e1664;
                                                    } else {
                                                        phi_2921_ = _e750;
                                                    }
                                                    let _e1666 = phi_2921_;
                                                    phi_2922_ = _e1666;
                                                } else {
                                                    phi_2922_ = _e750;
                                                }
                                                let _e1668 = phi_2922_;
                                                phi_1222_ = _e1668;
                                            } else {
                                                phi_1222_ = type_43();
                                            }
                                            let _e1670 = phi_1222_;
                                            continue;
                                            continuing {
                                                phi_1221_ = _e1670;
                                                phi_1224_ = _e738;
                                                phi_4431_ = _e665;
                                                break if !(_e744);
                                            }
                                        }
                                        let _e1673 = phi_4431_;
                                        phi_4638_ = _e1673;
                                        if _e1673 {
                                            break;
                                        }
                                        phi_4729_ = _e1673;
                                        let _e2338 = local_12;
                                        phi_2923_ = _e2338;
                                    } else {
                                        phi_4729_ = _e665;
                                        phi_2923_ = _e667;
                                    }
                                    let _e1675 = phi_4729_;
                                    let _e1677 = phi_2923_;
                                    if _e715 {
                                        phi_4192_ = type_43();
                                        phi_4193_ = bool();
                                        phi_4194_ = u32();
                                        phi_4195_ = type_50();
                                    } else {
                                        if (_e711.member_1 >= _e96) {
                                            phi_3724_ = type_51(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), type_50(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u), type_50(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u));
                                        } else {
                                            if (_e711.member_1 < _e96) {
                                            } else {
                                                phi_4638_ = true;
                                                break;
                                            }
                                            let _e1681 = ((1u + _e267) % 4u);
                                            if (_e1681 < 4u) {
                                            } else {
                                                phi_4638_ = true;
                                                break;
                                            }
                                            let _e1686 = global_3.member[_e711.member_1][_e1681];
                                            let _e1688 = (_e1686 >> bitcast<u32>(11u));
                                            let _e1690 = ((1u + _e266) % 4u);
                                            if (_e1690 < 4u) {
                                            } else {
                                                phi_4638_ = true;
                                                break;
                                            }
                                            let _e1695 = global_3.member[_e711.member_1][_e1690];
                                            let _e1697 = (_e1695 >> bitcast<u32>(11u));
                                            let _e1699 = ((1u + _e268) % 4u);
                                            if (_e1699 < 4u) {
                                            } else {
                                                phi_4638_ = true;
                                                break;
                                            }
                                            let _e1704 = global_3.member[_e711.member_1][_e1699];
                                            let _e1706 = (_e1704 >> bitcast<u32>(11u));
                                            let _e1729 = (bitcast<f32>((bitcast<u32>((_e711.member.member_1.x - _e711.member.member.x)) & 2139095040u)) * 0.001953125f);
                                            let _e1730 = (bitcast<f32>((bitcast<u32>((_e711.member.member_1.y - _e711.member.member.y)) & 2139095040u)) * 0.001953125f);
                                            let _e1731 = (bitcast<f32>((bitcast<u32>((_e711.member.member_1.z - _e711.member.member.z)) & 2139095040u)) * 0.001953125f);
                                            let _e1733 = select(_e147, _e1729, (_e1729 > _e147));
                                            let _e1735 = select(_e147, _e1730, (_e1730 > _e147));
                                            let _e1737 = select(_e147, _e1731, (_e1731 > _e147));
                                            let _e1768 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1686 & 1023u))) - 8388608f) * _e1733));
                                            let _e1773 = (bitcast<i32>((_e1686 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e1776 = bitcast<f32>((_e1768 & bitcast<u32>(_e1773)));
                                            let _e1777 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1695 & 1023u))) - 8388608f) * _e1735));
                                            let _e1782 = (bitcast<i32>((_e1695 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e1785 = bitcast<f32>((_e1777 & bitcast<u32>(_e1782)));
                                            let _e1786 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1704 & 1023u))) - 8388608f) * _e1737));
                                            let _e1791 = (bitcast<i32>((_e1704 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e1794 = bitcast<f32>((_e1786 & bitcast<u32>(_e1791)));
                                            let _e1798 = bitcast<f32>((_e1768 & bitcast<u32>(~(_e1773))));
                                            let _e1802 = bitcast<f32>((_e1777 & bitcast<u32>(~(_e1782))));
                                            let _e1806 = bitcast<f32>((_e1786 & bitcast<u32>(~(_e1791))));
                                            let _e1807 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1688 & 1023u))) - 8388608f) * _e1733));
                                            let _e1812 = (bitcast<i32>((_e1688 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e1815 = bitcast<f32>((_e1807 & bitcast<u32>(_e1812)));
                                            let _e1816 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1697 & 1023u))) - 8388608f) * _e1735));
                                            let _e1821 = (bitcast<i32>((_e1697 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e1824 = bitcast<f32>((_e1816 & bitcast<u32>(_e1821)));
                                            let _e1825 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1706 & 1023u))) - 8388608f) * _e1737));
                                            let _e1830 = (bitcast<i32>((_e1706 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e1833 = bitcast<f32>((_e1825 & bitcast<u32>(_e1830)));
                                            let _e1837 = bitcast<f32>((_e1807 & bitcast<u32>(~(_e1812))));
                                            let _e1841 = bitcast<f32>((_e1816 & bitcast<u32>(~(_e1821))));
                                            let _e1845 = bitcast<f32>((_e1825 & bitcast<u32>(~(_e1830))));
                                            let _e1846 = (_e711.member.member.x + _e1776);
                                            let _e1847 = (_e711.member.member.y + _e1785);
                                            let _e1848 = (_e711.member.member.z + _e1794);
                                            let _e1851 = (_e711.member.member_1.x - _e1815);
                                            let _e1852 = (_e711.member.member_1.y - _e1824);
                                            let _e1853 = (_e711.member.member_1.z - _e1833);
                                            let _e1872 = (_e1851 - _e1846);
                                            let _e1873 = (_e1852 - _e1847);
                                            let _e1874 = (_e1853 - _e1848);
                                            let _e1876 = select(_e1873, _e1872, (_e1872 > _e1873));
                                            let _e1878 = select(_e1874, _e1876, (_e1876 > _e1874));
                                            if (_e1878 < (1024f * _e147)) {
                                                phi_3425_ = 0u;
                                            } else {
                                                phi_3425_ = select(2u, 1u, (_e1878 < (2097152f * _e147)));
                                            }
                                            let _e1885 = phi_3425_;
                                            switch bitcast<i32>(_e1885) {
                                                case 0: {
                                                    phi_3431_ = 1u;
                                                    break;
                                                }
                                                case 1: {
                                                    phi_3431_ = 2u;
                                                    break;
                                                }
                                                case 2: {
                                                    phi_3431_ = 3u;
                                                    break;
                                                }
                                                default: {
                                                    phi_3431_ = u32();
                                                    break;
                                                }
                                            }
                                            let _e1888 = phi_3431_;
                                            let _e1894 = global_3.member[_e711.member_1][0u];
                                            let _e1898 = global_3.member[_e711.member_1][1u];
                                            let _e1902 = global_3.member[_e711.member_1][2u];
                                            let _e1906 = global_3.member[_e711.member_1][3u];
                                            let _e1918 = (((_e1898 >> bitcast<u32>(22i)) | ((_e1902 >> bitcast<u32>(22i)) << bitcast<u32>(10i))) | ((_e1906 >> bitcast<u32>(22i)) << bitcast<u32>(20i)));
                                            let _e1919 = (_e1894 & 268435455u);
                                            let _e1920 = (_e1918 & 268435455u);
                                            let _e1923 = ((_e1894 >> bitcast<u32>(28u)) & 7u);
                                            let _e1931 = ((_e1894 >> bitcast<u32>(31i)) | (((_e1918 >> bitcast<u32>(28u)) & 3u) << bitcast<u32>(1i)));
                                            let _e1932 = (_e1923 != 0u);
                                            if (_e1923 == 0u) {
                                                phi_3686_ = _e1919;
                                            } else {
                                                if (_e1923 == 7u) {
                                                    phi_3685_ = 2147483648u;
                                                } else {
                                                    phi_3685_ = ((2147483648u | (_e1923 << bitcast<u32>(28u))) | (_e1920 & 268435455u));
                                                }
                                                let _e1941 = phi_3685_;
                                                phi_3686_ = _e1941;
                                            }
                                            let _e1943 = phi_3686_;
                                            if _e1932 {
                                                let _e1944 = (_e1923 != 7u);
                                                if _e1944 {
                                                    phi_3696_ = (_e1920 + (_e1923 * ((3u * _e1888) + 1u)));
                                                } else {
                                                    phi_3696_ = u32();
                                                }
                                                let _e1948 = phi_3696_;
                                                phi_3698_ = _e1948;
                                                phi_3699_ = select(true, false, _e1944);
                                            } else {
                                                phi_3698_ = u32();
                                                phi_3699_ = true;
                                            }
                                            let _e1951 = phi_3698_;
                                            let _e1953 = phi_3699_;
                                            if (_e1931 == 0u) {
                                                phi_3720_ = (_e1919 + select(0u, 1u, !(_e1932)));
                                            } else {
                                                if (_e1931 == 7u) {
                                                    phi_3719_ = 2147483648u;
                                                } else {
                                                    phi_3719_ = ((2147483648u | (_e1931 << bitcast<u32>(28u))) | (select(_e1951, _e1920, _e1953) & 268435455u));
                                                }
                                                let _e1966 = phi_3719_;
                                                phi_3720_ = _e1966;
                                            }
                                            let _e1968 = phi_3720_;
                                            phi_3724_ = type_51(array<vec4<f32>, 3>(vec4<f32>(_e1846, (_e711.member.member.x + _e1798), _e1851, (_e711.member.member_1.x - _e1837)), vec4<f32>(_e1847, (_e711.member.member.y + _e1802), _e1852, (_e711.member.member_1.y - _e1841)), vec4<f32>(_e1848, (_e711.member.member.z + _e1806), _e1853, (_e711.member.member_1.z - _e1845))), type_50(type_32((_e711.member.member + vec4<f32>(_e1776, _e1785, _e1794, 0f)), (_e711.member.member_1 - vec4<f32>(_e1815, _e1824, _e1833, 0f))), _e1943), type_50(type_32((_e711.member.member + vec4<f32>(_e1798, _e1802, _e1806, 0f)), (_e711.member.member_1 - vec4<f32>(_e1837, _e1841, _e1845, 0f))), _e1968));
                                        }
                                        let _e1973 = phi_3724_;
                                        let _e1992 = ((_e1973.member[0].x - _e369) * _e374);
                                        let _e1993 = ((_e1973.member[0].y - _e369) * _e374);
                                        let _e1994 = ((_e1973.member[0].z - _e370) * _e374);
                                        let _e1995 = ((_e1973.member[0].w - _e370) * _e374);
                                        let _e2005 = ((_e1973.member[1].x - _e437) * _e442);
                                        let _e2006 = ((_e1973.member[1].y - _e437) * _e442);
                                        let _e2007 = ((_e1973.member[1].z - _e438) * _e442);
                                        let _e2008 = ((_e1973.member[1].w - _e438) * _e442);
                                        let _e2018 = ((_e1973.member[2].x - _e505) * _e510);
                                        let _e2019 = ((_e1973.member[2].y - _e505) * _e510);
                                        let _e2020 = ((_e1973.member[2].z - _e506) * _e510);
                                        let _e2021 = ((_e1973.member[2].w - _e506) * _e510);
                                        let _e2023 = select(_e2020, _e2018, (_e2018 < _e2020));
                                        let _e2025 = select(_e2021, _e2019, (_e2019 < _e2021));
                                        let _e2027 = select(_e2020, _e2018, (_e2018 > _e2020));
                                        let _e2029 = select(_e2021, _e2019, (_e2019 > _e2021));
                                        let _e2031 = select(_e1994, _e1992, (_e1992 < _e1994));
                                        let _e2033 = select(_e1995, _e1993, (_e1993 < _e1995));
                                        let _e2035 = select(_e2007, _e2005, (_e2005 < _e2007));
                                        let _e2037 = select(_e2008, _e2006, (_e2006 < _e2008));
                                        let _e2039 = select(_e2035, _e2031, (_e2031 > _e2035));
                                        let _e2041 = select(_e2037, _e2033, (_e2033 > _e2037));
                                        let _e2043 = select(_e2023, _e2039, (_e2039 > _e2023));
                                        let _e2045 = select(_e2025, _e2041, (_e2041 > _e2025));
                                        let _e2047 = select(_e1994, _e1992, (_e1992 > _e1994));
                                        let _e2049 = select(_e1995, _e1993, (_e1993 > _e1995));
                                        let _e2051 = select(_e2007, _e2005, (_e2005 > _e2007));
                                        let _e2053 = select(_e2008, _e2006, (_e2006 > _e2008));
                                        let _e2055 = select(_e2051, _e2047, (_e2047 < _e2051));
                                        let _e2057 = select(_e2053, _e2049, (_e2049 < _e2053));
                                        let _e2062 = -(_e2023);
                                        let _e2063 = -(_e2025);
                                        let _e2070 = (select(_e2027, _e2055, (_e2055 < _e2027)) + (select(_e2062, _e2027, (_e2027 > _e2062)) * 0.0000019073523f));
                                        let _e2071 = (select(_e2029, _e2057, (_e2057 < _e2029)) + (select(_e2063, _e2029, (_e2029 > _e2063)) * 0.0000019073523f));
                                        let _e2073 = select(_e622, _e2043, (_e2043 > _e622));
                                        let _e2075 = select(_e622, _e2045, (_e2045 > _e622));
                                        let _e2080 = (_e2073 <= select(_e1677.member.member_1, _e2070, (_e2070 < _e1677.member.member_1)));
                                        let _e2081 = (_e2075 <= select(_e1677.member.member_1, _e2071, (_e2071 < _e1677.member.member_1)));
                                        let _e2082 = (_e2073 <= _e2075);
                                        if _e2080 {
                                            if _e2081 {
                                                if _e2082 {
                                                    phi_4089_ = _e1973.member_2;
                                                } else {
                                                    phi_4089_ = _e1973.member_1;
                                                }
                                                let _e2086 = phi_4089_;
                                                let _e2107 = (_e709 % 128u);
                                                let _e2108 = (_e2107 < 128u);
                                                if _e2108 {
                                                } else {
                                                    phi_4638_ = true;
                                                    break;
                                                }
                                                local_8[_e2107] = _e2086.member_1;
                                                if _e2108 {
                                                } else {
                                                    phi_4638_ = true;
                                                    break;
                                                }
                                                local_7[_e2107] = _e2086.member.member.x;
                                                if _e2108 {
                                                } else {
                                                    phi_4638_ = true;
                                                    break;
                                                }
                                                local_6[_e2107] = _e2086.member.member.y;
                                                if _e2108 {
                                                } else {
                                                    phi_4638_ = true;
                                                    break;
                                                }
                                                local_5[_e2107] = _e2086.member.member.z;
                                                if _e2108 {
                                                } else {
                                                    phi_4638_ = true;
                                                    break;
                                                }
                                                local_4[_e2107] = _e2086.member.member_1.x;
                                                if _e2108 {
                                                } else {
                                                    phi_4638_ = true;
                                                    break;
                                                }
                                                local_3[_e2107] = _e2086.member.member_1.y;
                                                if _e2108 {
                                                } else {
                                                    phi_4638_ = true;
                                                    break;
                                                }
                                                local_2[_e2107] = _e2086.member.member_1.z;
                                                if _e2108 {
                                                } else {
                                                    phi_4638_ = true;
                                                    break;
                                                }
                                                local_9[_e2107] = select(_e2073, _e2075, _e2082);
                                                if _e2082 {
                                                    phi_4165_ = _e1973.member_1;
                                                } else {
                                                    phi_4165_ = _e1973.member_2;
                                                }
                                                let _e2121 = phi_4165_;
                                                phi_4166_ = (_e709 + 1u);
                                                phi_4167_ = _e2121;
                                            } else {
                                                phi_4166_ = u32();
                                                phi_4167_ = type_50();
                                            }
                                            let _e2123 = phi_4166_;
                                            let _e2125 = phi_4167_;
                                            phi_4169_ = _e2123;
                                            phi_4170_ = _e2125;
                                            phi_4171_ = select(true, false, _e2081);
                                        } else {
                                            phi_4169_ = u32();
                                            phi_4170_ = type_50();
                                            phi_4171_ = true;
                                        }
                                        let _e2128 = phi_4169_;
                                        let _e2130 = phi_4170_;
                                        let _e2132 = phi_4171_;
                                        if _e2132 {
                                            if _e2080 {
                                                phi_4180_ = _e1973.member_1;
                                            } else {
                                                phi_4180_ = _e1973.member_2;
                                            }
                                            let _e2136 = phi_4180_;
                                            phi_4185_ = select(_e2081, true, _e2080);
                                            phi_4187_ = _e2136;
                                        } else {
                                            phi_4185_ = _e707;
                                            phi_4187_ = _e2130;
                                        }
                                        let _e2139 = phi_4185_;
                                        let _e2141 = phi_4187_;
                                        phi_4192_ = type_43(_e1677.member, (_e1677.member_1 + 1u), _e1677.member_2);
                                        phi_4193_ = _e2139;
                                        phi_4194_ = select(_e2128, _e709, _e2132);
                                        phi_4195_ = _e2141;
                                    }
                                    let _e2144 = phi_4192_;
                                    let _e2146 = phi_4193_;
                                    let _e2148 = phi_4194_;
                                    let _e2150 = phi_4195_;
                                    if _e715 {
                                        phi_4203_ = _e1677;
                                        phi_4206_ = _e711;
                                    } else {
                                        phi_4203_ = _e2144;
                                        phi_4206_ = _e2150;
                                    }
                                    let _e2152 = phi_4203_;
                                    let _e2154 = phi_4206_;
                                    phi_4641_ = _e1675;
                                    phi_4207_ = _e2152;
                                    phi_4208_ = (_e669 - 1u);
                                    phi_4209_ = select(_e2146, false, _e715);
                                    phi_4210_ = select(_e2148, _e709, _e715);
                                    phi_4211_ = _e2154;
                                } else {
                                    phi_4641_ = _e665;
                                    phi_4207_ = _e667;
                                    phi_4208_ = _e669;
                                    phi_4209_ = _e707;
                                    phi_4210_ = _e709;
                                    phi_4211_ = _e711;
                                }
                                let _e2158 = phi_4641_;
                                let _e2160 = phi_4207_;
                                let _e2162 = phi_4208_;
                                let _e2164 = phi_4209_;
                                let _e2166 = phi_4210_;
                                let _e2168 = phi_4211_;
                                phi_4640_ = _e2158;
                                phi_4212_ = _e2160;
                                phi_4213_ = _e2162;
                                phi_4214_ = _e2164;
                                phi_4215_ = _e2166;
                                phi_4216_ = _e2168;
                            } else {
                                phi_4640_ = _e665;
                                phi_4212_ = type_43();
                                phi_4213_ = u32();
                                phi_4214_ = bool();
                                phi_4215_ = u32();
                                phi_4216_ = type_50();
                            }
                            let _e2170 = phi_4640_;
                            let _e2172 = phi_4212_;
                            let _e2174 = phi_4213_;
                            let _e2176 = phi_4214_;
                            let _e2178 = phi_4215_;
                            let _e2180 = phi_4216_;
                            phi_4639_ = _e2170;
                            phi_1095_ = _e2172;
                            phi_1098_ = _e2174;
                            phi_1100_ = _e2176;
                            phi_1102_ = _e2178;
                            phi_1104_ = _e2180;
                            phi_4217_ = _e679;
                        } else {
                            phi_4639_ = _e665;
                            phi_1095_ = type_43();
                            phi_1098_ = u32();
                            phi_1100_ = bool();
                            phi_1102_ = u32();
                            phi_1104_ = type_50();
                            phi_4217_ = false;
                        }
                        let _e2182 = phi_4639_;
                        let _e2184 = phi_1095_;
                        let _e2186 = phi_1098_;
                        let _e2188 = phi_1100_;
                        let _e2190 = phi_1102_;
                        let _e2192 = phi_1104_;
                        let _e2194 = phi_4217_;
                        continue;
                        continuing {
                            phi_4437_ = _e2182;
                            phi_1094_ = _e2184;
                            phi_1097_ = _e2186;
                            phi_1099_ = _e2188;
                            phi_1101_ = _e2190;
                            phi_1103_ = _e2192;
                            phi_4638_ = _e2182;
                            break if !(_e2194);
                        }
                    }
                    let _e2197 = phi_4638_;
                    if _e2197 {
                        break;
                    }
                    let _e2199 = local_10;
                    let _e2202 = local_11;
                    if _e155 {
                    } else {
                        break;
                    }
                    global_6.member[_e153][0u] = _e2199.member_1;
                    global_6.member[_e153][1u] = _e2202.member_2;
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
