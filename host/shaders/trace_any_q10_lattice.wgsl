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
    var phi_398_: i32;
    var phi_399_: i32;
    var phi_409_: bool;
    var phi_419_: u32;
    var phi_420_: u32;
    var phi_422_: bool;
    var phi_427_: u32;
    var phi_440_: i32;
    var phi_460_: i32;
    var phi_478_: f32;
    var phi_484_: f32;
    var phi_524_: f32;
    var phi_530_: f32;
    var phi_582_: f32;
    var phi_594_: f32;
    var phi_603_: f32;
    var phi_609_: f32;
    var phi_649_: f32;
    var phi_655_: f32;
    var phi_707_: f32;
    var phi_719_: f32;
    var phi_728_: f32;
    var phi_734_: f32;
    var phi_774_: f32;
    var phi_780_: f32;
    var phi_832_: f32;
    var phi_844_: f32;
    var phi_899_: i32;
    var phi_921_: u32;
    var phi_922_: u32;
    var phi_959_: i32;
    var phi_981_: u32;
    var phi_982_: u32;
    var phi_990_: f32;
    var phi_991_: f32;
    var phi_4394_: bool;
    var phi_1087_: type_38;
    var phi_1090_: bool;
    var phi_1092_: u32;
    var phi_1094_: u32;
    var phi_1096_: type_45;
    var phi_1107_: bool;
    var phi_1193_: bool;
    var phi_1194_: u32;
    var phi_1195_: type_45;
    var phi_3398_: u32;
    var phi_3404_: u32;
    var phi_3658_: u32;
    var phi_3659_: u32;
    var phi_3669_: u32;
    var phi_3671_: u32;
    var phi_3672_: bool;
    var phi_3692_: u32;
    var phi_3693_: u32;
    var phi_3697_: type_46;
    var phi_4059_: type_45;
    var phi_4136_: type_45;
    var phi_4137_: u32;
    var phi_4138_: type_45;
    var phi_4140_: u32;
    var phi_4141_: type_45;
    var phi_4142_: bool;
    var phi_4151_: type_45;
    var phi_4156_: bool;
    var phi_4158_: type_45;
    var phi_1214_: type_38;
    var phi_1217_: type_8;
    var phi_1218_: type_8;
    var phi_1240_: type_8;
    var phi_1281_: u32;
    var phi_1287_: u32;
    var phi_1297_: u32;
    var phi_1313_: u32;
    var phi_1346_: u32;
    var phi_1352_: u32;
    var phi_1818_: u32;
    var phi_1836_: u32;
    var phi_1854_: u32;
    var phi_1877_: u32;
    var phi_1895_: u32;
    var phi_1913_: u32;
    var phi_1936_: u32;
    var phi_1954_: u32;
    var phi_1972_: u32;
    var phi_1526_: u32;
    var phi_1541_: u32;
    var phi_1551_: u32;
    var phi_1572_: u32;
    var phi_1593_: u32;
    var phi_1623_: u32;
    var phi_1638_: u32;
    var phi_1648_: u32;
    var phi_1669_: u32;
    var phi_1690_: u32;
    var phi_1720_: u32;
    var phi_1735_: u32;
    var phi_1745_: u32;
    var phi_1766_: u32;
    var phi_1787_: u32;
    var phi_1379_: u32;
    var phi_1428_: u32;
    var phi_1477_: u32;
    var phi_1978_: array<array<f32, 3>, 3>;
    var phi_2130_: bool;
    var phi_2159_: bool;
    var phi_2578_: f32;
    var phi_2579_: f32;
    var phi_2580_: f32;
    var phi_2581_: f32;
    var phi_2582_: vec3<f32>;
    var phi_2583_: vec3<f32>;
    var phi_2584_: vec3<f32>;
    var phi_2585_: vec3<f32>;
    var phi_2622_: bool;
    var phi_2631_: vec3<f32>;
    var phi_2796_: f32;
    var phi_2798_: f32;
    var phi_2799_: bool;
    var phi_2819_: f32;
    var phi_2820_: f32;
    var phi_2843_: type_24;
    var phi_2845_: type_24;
    var phi_2846_: bool;
    var phi_2850_: type_24;
    var phi_2851_: type_24;
    var phi_2852_: type_24;
    var phi_2853_: bool;
    var phi_2857_: type_24;
    var phi_2858_: bool;
    var phi_2859_: type_24;
    var phi_2860_: bool;
    var phi_2861_: bool;
    var phi_2862_: type_24;
    var phi_2863_: bool;
    var phi_2864_: bool;
    var phi_2872_: type_24;
    var phi_2873_: bool;
    var phi_2877_: type_24;
    var phi_2888_: type_38;
    var phi_2889_: type_38;
    var phi_1215_: type_38;
    var phi_4388_: bool;
    var local_10: type_38;
    var phi_4596_: bool;
    var phi_4162_: type_38;
    var phi_4163_: bool;
    var phi_4164_: u32;
    var phi_4165_: type_45;
    var phi_4595_: bool;
    var phi_4166_: type_38;
    var phi_4167_: bool;
    var phi_4168_: u32;
    var phi_4169_: u32;
    var phi_4170_: type_45;
    var phi_4594_: bool;
    var phi_4171_: type_38;
    var phi_4172_: bool;
    var phi_4173_: u32;
    var phi_4174_: u32;
    var phi_4175_: type_45;
    var phi_4593_: bool;
    var phi_1088_: type_38;
    var phi_1091_: bool;
    var phi_1093_: u32;
    var phi_1095_: u32;
    var phi_1097_: type_45;
    var phi_4176_: bool;
    var phi_4592_: bool;
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
                            phi_398_ = (bitcast<i32>((_e232 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_398_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e232)), 32u, (_e232 == 0u))));
                        }
                        let _e246 = phi_398_;
                        phi_399_ = _e246;
                    } else {
                        phi_399_ = 0i;
                    }
                    let _e248 = phi_399_;
                    let _e249 = (_e165 == _e204);
                    if _e249 {
                        phi_409_ = true;
                    } else {
                        phi_409_ = (_e172 == _e204);
                    }
                    let _e252 = phi_409_;
                    let _e253 = select(1u, 0u, _e249);
                    if _e252 {
                        let _e254 = (_e253 + 1u);
                        phi_419_ = _e254;
                        phi_420_ = _e254;
                        phi_422_ = select(true, false, (_e254 == 2u));
                    } else {
                        phi_419_ = u32();
                        phi_420_ = 0u;
                        phi_422_ = true;
                    }
                    let _e258 = phi_419_;
                    let _e260 = phi_420_;
                    let _e262 = phi_422_;
                    if _e262 {
                        phi_427_ = (_e260 + 1u);
                    } else {
                        phi_427_ = 0u;
                    }
                    let _e266 = phi_427_;
                    let _e267 = select(_e258, _e260, _e262);
                    let _e268 = select(_e253, select(2u, _e253, _e252), _e262);
                    if (_e135 < -126i) {
                        phi_440_ = -126i;
                    } else {
                        phi_440_ = select(_e135, 127i, (_e135 > 127i));
                    }
                    let _e273 = phi_440_;
                    let _e278 = bitcast<f32>((bitcast<u32>((_e273 + 127i)) << bitcast<u32>(23i)));
                    let _e284 = bitcast<f32>((bitcast<u32>(((_e135 - _e273) + 127i)) << bitcast<u32>(23i)));
                    let _e285 = -(_e248);
                    if (_e285 < -126i) {
                        phi_460_ = -126i;
                    } else {
                        phi_460_ = select(_e285, 127i, (_e285 > 127i));
                    }
                    let _e290 = phi_460_;
                    let _e295 = bitcast<f32>((bitcast<u32>((_e290 + 127i)) << bitcast<u32>(23i)));
                    let _e301 = bitcast<f32>((bitcast<u32>(((_e285 - _e290) + 127i)) << bitcast<u32>(23i)));
                    let _e305 = global_4.member[_e153].member;
                    let _e306 = (_e267 == 0u);
                    if _e306 {
                        phi_478_ = _e305[0];
                    } else {
                        phi_478_ = _e305[1];
                    }
                    let _e310 = phi_478_;
                    let _e311 = (_e267 == 2u);
                    if _e311 {
                        phi_484_ = _e305[2];
                    } else {
                        phi_484_ = _e310;
                    }
                    let _e314 = phi_484_;
                    let _e315 = bitcast<u32>(_e314);
                    let _e317 = ((_e315 & 2139095040u) != 0u);
                    let _e331 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e315 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e315 & 2147483648u))), _e314, _e317) * _e278) * select(0.00000011920929f, 1f, _e317)) * _e284);
                    let _e332 = global_4.member[_e153].member_2;
                    if _e306 {
                        phi_524_ = _e332[0];
                    } else {
                        phi_524_ = _e332[1];
                    }
                    let _e336 = phi_524_;
                    if _e311 {
                        phi_530_ = _e332[2];
                    } else {
                        phi_530_ = _e336;
                    }
                    let _e339 = phi_530_;
                    let _e340 = bitcast<u32>(_e339);
                    let _e342 = ((_e340 & 2139095040u) != 0u);
                    let _e356 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e340 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e340 & 2147483648u))), _e339, _e342) * _e295) * select(0.00000011920929f, 1f, _e342)) * _e301);
                    let _e360 = (bitcast<f32>((bitcast<u32>(_e356) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e360 {
                        let _e364 = (bitcast<f32>((bitcast<u32>(_e331) & 2147483647u)) * 0.00000011920929f);
                        phi_582_ = select(0.00000000000011368684f, _e364, (_e364 > 0.00000000000011368684f));
                    } else {
                        phi_582_ = 0f;
                    }
                    let _e368 = phi_582_;
                    let _e369 = (_e331 + _e368);
                    let _e370 = (_e331 - _e368);
                    let _e371 = select(_e356, 0f, _e360);
                    if _e360 {
                        phi_594_ = 38685626000000000000000000f;
                    } else {
                        phi_594_ = (1f / _e356);
                    }
                    let _e374 = phi_594_;
                    let _e375 = (_e266 == 0u);
                    if _e375 {
                        phi_603_ = _e305[0];
                    } else {
                        phi_603_ = _e305[1];
                    }
                    let _e379 = phi_603_;
                    let _e380 = (_e266 == 2u);
                    if _e380 {
                        phi_609_ = _e305[2];
                    } else {
                        phi_609_ = _e379;
                    }
                    let _e383 = phi_609_;
                    let _e384 = bitcast<u32>(_e383);
                    let _e386 = ((_e384 & 2139095040u) != 0u);
                    let _e400 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e384 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e384 & 2147483648u))), _e383, _e386) * _e278) * select(0.00000011920929f, 1f, _e386)) * _e284);
                    if _e375 {
                        phi_649_ = _e332[0];
                    } else {
                        phi_649_ = _e332[1];
                    }
                    let _e404 = phi_649_;
                    if _e380 {
                        phi_655_ = _e332[2];
                    } else {
                        phi_655_ = _e404;
                    }
                    let _e407 = phi_655_;
                    let _e408 = bitcast<u32>(_e407);
                    let _e410 = ((_e408 & 2139095040u) != 0u);
                    let _e424 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e408 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e408 & 2147483648u))), _e407, _e410) * _e295) * select(0.00000011920929f, 1f, _e410)) * _e301);
                    let _e428 = (bitcast<f32>((bitcast<u32>(_e424) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e428 {
                        let _e432 = (bitcast<f32>((bitcast<u32>(_e400) & 2147483647u)) * 0.00000011920929f);
                        phi_707_ = select(0.00000000000011368684f, _e432, (_e432 > 0.00000000000011368684f));
                    } else {
                        phi_707_ = 0f;
                    }
                    let _e436 = phi_707_;
                    let _e437 = (_e400 + _e436);
                    let _e438 = (_e400 - _e436);
                    let _e439 = select(_e424, 0f, _e428);
                    if _e428 {
                        phi_719_ = 38685626000000000000000000f;
                    } else {
                        phi_719_ = (1f / _e424);
                    }
                    let _e442 = phi_719_;
                    let _e443 = (_e268 == 0u);
                    if _e443 {
                        phi_728_ = _e305[0];
                    } else {
                        phi_728_ = _e305[1];
                    }
                    let _e447 = phi_728_;
                    let _e448 = (_e268 == 2u);
                    if _e448 {
                        phi_734_ = _e305[2];
                    } else {
                        phi_734_ = _e447;
                    }
                    let _e451 = phi_734_;
                    let _e452 = bitcast<u32>(_e451);
                    let _e454 = ((_e452 & 2139095040u) != 0u);
                    let _e468 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e452 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e452 & 2147483648u))), _e451, _e454) * _e278) * select(0.00000011920929f, 1f, _e454)) * _e284);
                    if _e443 {
                        phi_774_ = _e332[0];
                    } else {
                        phi_774_ = _e332[1];
                    }
                    let _e472 = phi_774_;
                    if _e448 {
                        phi_780_ = _e332[2];
                    } else {
                        phi_780_ = _e472;
                    }
                    let _e475 = phi_780_;
                    let _e476 = bitcast<u32>(_e475);
                    let _e478 = ((_e476 & 2139095040u) != 0u);
                    let _e492 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e476 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e476 & 2147483648u))), _e475, _e478) * _e295) * select(0.00000011920929f, 1f, _e478)) * _e301);
                    let _e496 = (bitcast<f32>((bitcast<u32>(_e492) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e496 {
                        let _e500 = (bitcast<f32>((bitcast<u32>(_e468) & 2147483647u)) * 0.00000011920929f);
                        phi_832_ = select(0.00000000000011368684f, _e500, (_e500 > 0.00000000000011368684f));
                    } else {
                        phi_832_ = 0f;
                    }
                    let _e504 = phi_832_;
                    let _e505 = (_e468 + _e504);
                    let _e506 = (_e468 - _e504);
                    let _e507 = select(_e492, 0f, _e496);
                    if _e496 {
                        phi_844_ = 38685626000000000000000000f;
                    } else {
                        phi_844_ = (1f / _e492);
                    }
                    let _e510 = phi_844_;
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
                            phi_899_ = 255i;
                        } else {
                            phi_899_ = (((_e537 + select(0i, 1i, (_e537 == 0i))) - _e544) + _e524);
                        }
                        let _e552 = phi_899_;
                        let _e562 = (_e552 <= 0i);
                        if _e562 {
                            phi_922_ = u32();
                        } else {
                            if _e541 {
                                phi_921_ = u32();
                            } else {
                                phi_921_ = select(((bitcast<u32>(_e552) << bitcast<u32>(23i)) | ((_e534 << bitcast<u32>(((_e544 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e552 >= 255i));
                            }
                            let _e566 = phi_921_;
                            phi_922_ = _e566;
                        }
                        let _e568 = phi_922_;
                        let _e580 = ((_e225 & 8388607u) | (select(0u, 1u, ((_e225 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                        let _e583 = bitcast<i32>((_e225 >> bitcast<u32>(23i)));
                        let _e587 = (_e580 == 0u);
                        let _e590 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e580)), 32u, _e587)) - 8i);
                        if (_e583 == 255i) {
                            phi_959_ = 255i;
                        } else {
                            phi_959_ = (((_e583 + select(0i, 1i, (_e583 == 0i))) - _e590) + _e524);
                        }
                        let _e598 = phi_959_;
                        let _e608 = (_e598 <= 0i);
                        if _e608 {
                            phi_982_ = u32();
                        } else {
                            if _e587 {
                                phi_981_ = u32();
                            } else {
                                phi_981_ = select(((bitcast<u32>(_e598) << bitcast<u32>(23i)) | ((_e580 << bitcast<u32>(((_e590 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e598 >= 255i));
                            }
                            let _e612 = phi_981_;
                            phi_982_ = _e612;
                        }
                        let _e614 = phi_982_;
                        phi_990_ = bitcast<f32>(((_e224 & 2147483648u) | select(_e614, 0u, select(_e587, true, _e608))));
                        phi_991_ = bitcast<f32>(((_e215 & 2147483648u) | select(_e568, 0u, select(_e541, true, _e562))));
                    } else {
                        phi_990_ = 0f;
                        phi_991_ = 1f;
                    }
                    let _e620 = phi_990_;
                    let _e622 = phi_991_;
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
                    phi_4394_ = false;
                    phi_1087_ = type_38(_e620, false);
                    phi_1090_ = (_e622 <= _e620);
                    phi_1092_ = ((3u * _e96) + 1u);
                    phi_1094_ = 0u;
                    phi_1096_ = type_45(type_28(vec4<f32>((f32(_e629) * _e147), (f32(_e635) * _e147), (f32(_e641) * _e147), 0f), vec4<f32>((f32(_e646) * _e147), (f32(_e650) * _e147), (f32(_e654) * _e147), 0f)), select(0u, 2147483648u, (_e96 == 0u)));
                    loop {
                        let _e664 = phi_4394_;
                        let _e666 = phi_1087_;
                        let _e668 = phi_1090_;
                        let _e670 = phi_1092_;
                        let _e672 = phi_1094_;
                        let _e674 = phi_1096_;
                        local_11 = _e666;
                        if _e668 {
                            phi_1107_ = true;
                        } else {
                            phi_1107_ = (_e672 > 0u);
                        }
                        let _e677 = phi_1107_;
                        if _e677 {
                            let _e678 = (_e670 > 0u);
                            if _e678 {
                                if _e668 {
                                    phi_1193_ = _e668;
                                    phi_1194_ = _e672;
                                    phi_1195_ = _e674;
                                } else {
                                    let _e679 = (_e672 - 1u);
                                    let _e680 = (_e679 % 128u);
                                    let _e681 = (_e680 < 128u);
                                    if _e681 {
                                    } else {
                                        phi_4592_ = true;
                                        break;
                                    }
                                    let _e683 = local_7[_e680];
                                    if _e681 {
                                    } else {
                                        phi_4592_ = true;
                                        break;
                                    }
                                    let _e685 = local_6[_e680];
                                    if _e681 {
                                    } else {
                                        phi_4592_ = true;
                                        break;
                                    }
                                    let _e687 = local_5[_e680];
                                    if _e681 {
                                    } else {
                                        phi_4592_ = true;
                                        break;
                                    }
                                    let _e689 = local_4[_e680];
                                    if _e681 {
                                    } else {
                                        phi_4592_ = true;
                                        break;
                                    }
                                    let _e691 = local_3[_e680];
                                    if _e681 {
                                    } else {
                                        phi_4592_ = true;
                                        break;
                                    }
                                    let _e693 = local_2[_e680];
                                    if _e681 {
                                    } else {
                                        phi_4592_ = true;
                                        break;
                                    }
                                    let _e698 = local_8[_e680];
                                    if _e681 {
                                    } else {
                                        phi_4592_ = true;
                                        break;
                                    }
                                    let _e701 = local_9[_e680];
                                    phi_1193_ = (_e701 <= _e666.member);
                                    phi_1194_ = _e679;
                                    phi_1195_ = type_45(type_28(vec4<f32>(_e683, _e685, _e687, 0f), vec4<f32>(_e689, _e691, _e693, 0f)), _e698);
                                }
                                let _e705 = phi_1193_;
                                let _e707 = phi_1194_;
                                let _e709 = phi_1195_;
                                if _e705 {
                                    let _e714 = (_e709.member_1 & 268435455u);
                                    if ((_e709.member_1 & 2147483648u) != 0u) {
                                        phi_1214_ = _e666;
                                        phi_1217_ = type_8(0u, ((_e709.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e1180 = phi_1214_;
                                            let _e1182 = phi_1217_;
                                            local_10 = _e1180;
                                            local_12 = _e1180;
                                            if (_e1182.member < _e1182.member_1) {
                                                phi_1218_ = type_8((_e1182.member + 1u), _e1182.member_1);
                                                phi_1240_ = type_8(1u, _e1182.member);
                                            } else {
                                                phi_1218_ = _e1182;
                                                phi_1240_ = type_8(0u, type_8().member_1);
                                            }
                                            let _e1195 = phi_1218_;
                                            let _e1197 = phi_1240_;
                                            let _e1201 = (bitcast<i32>(_e1197.member) != 0i);
                                            if _e1201 {
                                                let _e1206 = (_e709.member.member_1.x - _e709.member.member.x);
                                                let _e1209 = (_e709.member.member_1.y - _e709.member.member.y);
                                                let _e1212 = (_e709.member.member_1.z - _e709.member.member.z);
                                                let _e1214 = select(_e1209, _e1206, (_e1206 > _e1209));
                                                let _e1216 = select(_e1212, _e1214, (_e1214 > _e1212));
                                                let _e1218 = (_e1216 < (1024f * _e147));
                                                if _e1218 {
                                                    phi_1281_ = 0u;
                                                } else {
                                                    phi_1281_ = select(2u, 1u, (_e1216 < (2097152f * _e147)));
                                                }
                                                let _e1223 = phi_1281_;
                                                switch bitcast<i32>(_e1223) {
                                                    case 0: {
                                                        phi_1287_ = 1u;
                                                        break;
                                                    }
                                                    case 1: {
                                                        phi_1287_ = 2u;
                                                        break;
                                                    }
                                                    case 2: {
                                                        phi_1287_ = 3u;
                                                        break;
                                                    }
                                                    default: {
                                                        phi_1287_ = u32();
                                                        break;
                                                    }
                                                }
                                                let _e1226 = phi_1287_;
                                                switch bitcast<i32>(_e1223) {
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
                                                let _e1233 = phi_1297_;
                                                let _e1235 = ((_e714 + (_e1197.member_1 * ((3u * _e1226) + 1u))) + (3u * _e1233));
                                                let _e1236 = (_e1235 < _e99);
                                                if _e1236 {
                                                    if _e1236 {
                                                    } else {
                                                        phi_4388_ = true;
                                                        break;
                                                    }
                                                    let _e1238 = global_6.member[_e1235];
                                                    phi_1313_ = _e1238;
                                                } else {
                                                    phi_1313_ = 4294967295u;
                                                }
                                                let _e1240 = phi_1313_;
                                                if _e1218 {
                                                    phi_1346_ = 0u;
                                                } else {
                                                    phi_1346_ = select(2u, 1u, (_e1216 < (2097152f * _e147)));
                                                }
                                                let _e1245 = phi_1346_;
                                                switch bitcast<i32>(_e1245) {
                                                    case 0: {
                                                        phi_1352_ = 1u;
                                                        break;
                                                    }
                                                    case 1: {
                                                        phi_1352_ = 2u;
                                                        break;
                                                    }
                                                    case 2: {
                                                        phi_1352_ = 3u;
                                                        break;
                                                    }
                                                    default: {
                                                        phi_1352_ = u32();
                                                        break;
                                                    }
                                                }
                                                let _e1248 = phi_1352_;
                                                let _e1252 = (_e714 + (_e1197.member_1 * ((3u * _e1248) + 1u)));
                                                switch bitcast<i32>(_e1245) {
                                                    case 0: {
                                                        let _e1527 = (_e1252 < _e99);
                                                        if _e1527 {
                                                            if _e1527 {
                                                            } else {
                                                                phi_4388_ = true;
                                                                break;
                                                            }
                                                            let _e1529 = global_6.member[_e1252];
                                                            phi_1379_ = _e1529;
                                                        } else {
                                                            phi_1379_ = 0u;
                                                        }
                                                        let _e1531 = phi_1379_;
                                                        let _e1533 = ((10u * _e267) & 31u);
                                                        let _e1543 = ((10u * _e266) & 31u);
                                                        let _e1553 = ((10u * _e268) & 31u);
                                                        let _e1563 = (_e1252 + 1u);
                                                        let _e1564 = (_e1563 < _e99);
                                                        if _e1564 {
                                                            if _e1564 {
                                                            } else {
                                                                phi_4388_ = true;
                                                                break;
                                                            }
                                                            let _e1566 = global_6.member[_e1563];
                                                            phi_1428_ = _e1566;
                                                        } else {
                                                            phi_1428_ = 0u;
                                                        }
                                                        let _e1568 = phi_1428_;
                                                        let _e1594 = (_e1252 + 2u);
                                                        let _e1595 = (_e1594 < _e99);
                                                        if _e1595 {
                                                            if _e1595 {
                                                            } else {
                                                                phi_4388_ = true;
                                                                break;
                                                            }
                                                            let _e1597 = global_6.member[_e1594];
                                                            phi_1477_ = _e1597;
                                                        } else {
                                                            phi_1477_ = 0u;
                                                        }
                                                        let _e1599 = phi_1477_;
                                                        phi_1978_ = array<array<f32, 3>, 3>(array<f32, 3>((_e709.member.member.x + ((bitcast<f32>((1258291200u | ((_e1531 >> bitcast<u32>(_e1533)) & 1023u))) - 8388608f) * _e147)), (_e709.member.member.y + ((bitcast<f32>((1258291200u | ((_e1531 >> bitcast<u32>(_e1543)) & 1023u))) - 8388608f) * _e147)), (_e709.member.member.z + ((bitcast<f32>((1258291200u | ((_e1531 >> bitcast<u32>(_e1553)) & 1023u))) - 8388608f) * _e147))), array<f32, 3>((_e709.member.member.x + ((bitcast<f32>((1258291200u | ((_e1568 >> bitcast<u32>(_e1533)) & 1023u))) - 8388608f) * _e147)), (_e709.member.member.y + ((bitcast<f32>((1258291200u | ((_e1568 >> bitcast<u32>(_e1543)) & 1023u))) - 8388608f) * _e147)), (_e709.member.member.z + ((bitcast<f32>((1258291200u | ((_e1568 >> bitcast<u32>(_e1553)) & 1023u))) - 8388608f) * _e147))), array<f32, 3>((_e709.member.member.x + ((bitcast<f32>((1258291200u | ((_e1599 >> bitcast<u32>(_e1533)) & 1023u))) - 8388608f) * _e147)), (_e709.member.member.y + ((bitcast<f32>((1258291200u | ((_e1599 >> bitcast<u32>(_e1543)) & 1023u))) - 8388608f) * _e147)), (_e709.member.member.z + ((bitcast<f32>((1258291200u | ((_e1599 >> bitcast<u32>(_e1553)) & 1023u))) - 8388608f) * _e147))));
                                                        break;
                                                    }
                                                    case 1: {
                                                        let _e1341 = (_e1252 < _e99);
                                                        if _e1341 {
                                                            if _e1341 {
                                                            } else {
                                                                phi_4388_ = true;
                                                                break;
                                                            }
                                                            let _e1343 = global_6.member[_e1252];
                                                            phi_1526_ = _e1343;
                                                        } else {
                                                            phi_1526_ = 0u;
                                                        }
                                                        let _e1345 = phi_1526_;
                                                        let _e1346 = (_e1252 + 1u);
                                                        let _e1347 = (_e1346 < _e99);
                                                        if _e1347 {
                                                            if _e1347 {
                                                            } else {
                                                                phi_4388_ = true;
                                                                break;
                                                            }
                                                            let _e1349 = global_6.member[_e1346];
                                                            phi_1541_ = _e1349;
                                                        } else {
                                                            phi_1541_ = 0u;
                                                        }
                                                        let _e1351 = phi_1541_;
                                                        let _e1352 = (_e267 == 1u);
                                                        if _e1352 {
                                                            phi_1551_ = ((_e1345 >> bitcast<u32>(21i)) | (_e1351 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1551_ = (_e1351 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1361 = phi_1551_;
                                                        let _e1369 = (_e266 == 1u);
                                                        if _e1369 {
                                                            phi_1572_ = ((_e1345 >> bitcast<u32>(21i)) | (_e1351 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1572_ = (_e1351 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1378 = phi_1572_;
                                                        let _e1386 = (_e268 == 1u);
                                                        if _e1386 {
                                                            phi_1593_ = ((_e1345 >> bitcast<u32>(21i)) | (_e1351 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1593_ = (_e1351 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1395 = phi_1593_;
                                                        let _e1404 = (_e1252 + 2u);
                                                        let _e1405 = (_e1404 < _e99);
                                                        if _e1405 {
                                                            if _e1405 {
                                                            } else {
                                                                phi_4388_ = true;
                                                                break;
                                                            }
                                                            let _e1407 = global_6.member[_e1404];
                                                            phi_1623_ = _e1407;
                                                        } else {
                                                            phi_1623_ = 0u;
                                                        }
                                                        let _e1409 = phi_1623_;
                                                        let _e1410 = (_e1252 + 3u);
                                                        let _e1411 = (_e1410 < _e99);
                                                        if _e1411 {
                                                            if _e1411 {
                                                            } else {
                                                                phi_4388_ = true;
                                                                break;
                                                            }
                                                            let _e1413 = global_6.member[_e1410];
                                                            phi_1638_ = _e1413;
                                                        } else {
                                                            phi_1638_ = 0u;
                                                        }
                                                        let _e1415 = phi_1638_;
                                                        if _e1352 {
                                                            phi_1648_ = ((_e1409 >> bitcast<u32>(21i)) | (_e1415 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1648_ = (_e1415 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1424 = phi_1648_;
                                                        if _e1369 {
                                                            phi_1669_ = ((_e1409 >> bitcast<u32>(21i)) | (_e1415 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1669_ = (_e1415 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1440 = phi_1669_;
                                                        if _e1386 {
                                                            phi_1690_ = ((_e1409 >> bitcast<u32>(21i)) | (_e1415 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1690_ = (_e1415 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1456 = phi_1690_;
                                                        let _e1465 = (_e1252 + 4u);
                                                        let _e1466 = (_e1465 < _e99);
                                                        if _e1466 {
                                                            if _e1466 {
                                                            } else {
                                                                phi_4388_ = true;
                                                                break;
                                                            }
                                                            let _e1468 = global_6.member[_e1465];
                                                            phi_1720_ = _e1468;
                                                        } else {
                                                            phi_1720_ = 0u;
                                                        }
                                                        let _e1470 = phi_1720_;
                                                        let _e1471 = (_e1252 + 5u);
                                                        let _e1472 = (_e1471 < _e99);
                                                        if _e1472 {
                                                            if _e1472 {
                                                            } else {
                                                                phi_4388_ = true;
                                                                break;
                                                            }
                                                            let _e1474 = global_6.member[_e1471];
                                                            phi_1735_ = _e1474;
                                                        } else {
                                                            phi_1735_ = 0u;
                                                        }
                                                        let _e1476 = phi_1735_;
                                                        if _e1352 {
                                                            phi_1745_ = ((_e1470 >> bitcast<u32>(21i)) | (_e1476 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1745_ = (_e1476 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1485 = phi_1745_;
                                                        if _e1369 {
                                                            phi_1766_ = ((_e1470 >> bitcast<u32>(21i)) | (_e1476 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1766_ = (_e1476 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1501 = phi_1766_;
                                                        if _e1386 {
                                                            phi_1787_ = ((_e1470 >> bitcast<u32>(21i)) | (_e1476 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1787_ = (_e1476 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1517 = phi_1787_;
                                                        phi_1978_ = array<array<f32, 3>, 3>(array<f32, 3>((_e709.member.member.x + ((bitcast<f32>((1258291200u | (select(_e1361, _e1345, _e306) & 2097151u))) - 8388608f) * _e147)), (_e709.member.member.y + ((bitcast<f32>((1258291200u | (select(_e1378, _e1345, _e375) & 2097151u))) - 8388608f) * _e147)), (_e709.member.member.z + ((bitcast<f32>((1258291200u | (select(_e1395, _e1345, _e443) & 2097151u))) - 8388608f) * _e147))), array<f32, 3>((_e709.member.member.x + ((bitcast<f32>((1258291200u | (select(_e1424, _e1409, _e306) & 2097151u))) - 8388608f) * _e147)), (_e709.member.member.y + ((bitcast<f32>((1258291200u | (select(_e1440, _e1409, _e375) & 2097151u))) - 8388608f) * _e147)), (_e709.member.member.z + ((bitcast<f32>((1258291200u | (select(_e1456, _e1409, _e443) & 2097151u))) - 8388608f) * _e147))), array<f32, 3>((_e709.member.member.x + ((bitcast<f32>((1258291200u | (select(_e1485, _e1470, _e306) & 2097151u))) - 8388608f) * _e147)), (_e709.member.member.y + ((bitcast<f32>((1258291200u | (select(_e1501, _e1470, _e375) & 2097151u))) - 8388608f) * _e147)), (_e709.member.member.z + ((bitcast<f32>((1258291200u | (select(_e1517, _e1470, _e443) & 2097151u))) - 8388608f) * _e147))));
                                                        break;
                                                    }
                                                    case 2: {
                                                        let _e1254 = (_e1252 + _e267);
                                                        let _e1255 = (_e1254 < _e99);
                                                        if _e1255 {
                                                            if _e1255 {
                                                            } else {
                                                                phi_4388_ = true;
                                                                break;
                                                            }
                                                            let _e1257 = global_6.member[_e1254];
                                                            phi_1818_ = _e1257;
                                                        } else {
                                                            phi_1818_ = 0u;
                                                        }
                                                        let _e1259 = phi_1818_;
                                                        let _e1263 = (_e1252 + _e266);
                                                        let _e1264 = (_e1263 < _e99);
                                                        if _e1264 {
                                                            if _e1264 {
                                                            } else {
                                                                phi_4388_ = true;
                                                                break;
                                                            }
                                                            let _e1266 = global_6.member[_e1263];
                                                            phi_1836_ = _e1266;
                                                        } else {
                                                            phi_1836_ = 0u;
                                                        }
                                                        let _e1268 = phi_1836_;
                                                        let _e1272 = (_e1252 + _e268);
                                                        let _e1273 = (_e1272 < _e99);
                                                        if _e1273 {
                                                            if _e1273 {
                                                            } else {
                                                                phi_4388_ = true;
                                                                break;
                                                            }
                                                            let _e1275 = global_6.member[_e1272];
                                                            phi_1854_ = _e1275;
                                                        } else {
                                                            phi_1854_ = 0u;
                                                        }
                                                        let _e1277 = phi_1854_;
                                                        let _e1282 = (_e1252 + 3u);
                                                        let _e1283 = (_e1282 + _e267);
                                                        let _e1284 = (_e1283 < _e99);
                                                        if _e1284 {
                                                            if _e1284 {
                                                            } else {
                                                                phi_4388_ = true;
                                                                break;
                                                            }
                                                            let _e1286 = global_6.member[_e1283];
                                                            phi_1877_ = _e1286;
                                                        } else {
                                                            phi_1877_ = 0u;
                                                        }
                                                        let _e1288 = phi_1877_;
                                                        let _e1292 = (_e1282 + _e266);
                                                        let _e1293 = (_e1292 < _e99);
                                                        if _e1293 {
                                                            if _e1293 {
                                                            } else {
                                                                phi_4388_ = true;
                                                                break;
                                                            }
                                                            let _e1295 = global_6.member[_e1292];
                                                            phi_1895_ = _e1295;
                                                        } else {
                                                            phi_1895_ = 0u;
                                                        }
                                                        let _e1297 = phi_1895_;
                                                        let _e1301 = (_e1282 + _e268);
                                                        let _e1302 = (_e1301 < _e99);
                                                        if _e1302 {
                                                            if _e1302 {
                                                            } else {
                                                                phi_4388_ = true;
                                                                break;
                                                            }
                                                            let _e1304 = global_6.member[_e1301];
                                                            phi_1913_ = _e1304;
                                                        } else {
                                                            phi_1913_ = 0u;
                                                        }
                                                        let _e1306 = phi_1913_;
                                                        let _e1311 = (_e1252 + 6u);
                                                        let _e1312 = (_e1311 + _e267);
                                                        let _e1313 = (_e1312 < _e99);
                                                        if _e1313 {
                                                            if _e1313 {
                                                            } else {
                                                                phi_4388_ = true;
                                                                break;
                                                            }
                                                            let _e1315 = global_6.member[_e1312];
                                                            phi_1936_ = _e1315;
                                                        } else {
                                                            phi_1936_ = 0u;
                                                        }
                                                        let _e1317 = phi_1936_;
                                                        let _e1321 = (_e1311 + _e266);
                                                        let _e1322 = (_e1321 < _e99);
                                                        if _e1322 {
                                                            if _e1322 {
                                                            } else {
                                                                phi_4388_ = true;
                                                                break;
                                                            }
                                                            let _e1324 = global_6.member[_e1321];
                                                            phi_1954_ = _e1324;
                                                        } else {
                                                            phi_1954_ = 0u;
                                                        }
                                                        let _e1326 = phi_1954_;
                                                        let _e1330 = (_e1311 + _e268);
                                                        let _e1331 = (_e1330 < _e99);
                                                        if _e1331 {
                                                            if _e1331 {
                                                            } else {
                                                                phi_4388_ = true;
                                                                break;
                                                            }
                                                            let _e1333 = global_6.member[_e1330];
                                                            phi_1972_ = _e1333;
                                                        } else {
                                                            phi_1972_ = 0u;
                                                        }
                                                        let _e1335 = phi_1972_;
                                                        phi_1978_ = array<array<f32, 3>, 3>(array<f32, 3>((f32(bitcast<i32>(_e1259)) * _e147), (f32(bitcast<i32>(_e1268)) * _e147), (f32(bitcast<i32>(_e1277)) * _e147)), array<f32, 3>((f32(bitcast<i32>(_e1288)) * _e147), (f32(bitcast<i32>(_e1297)) * _e147), (f32(bitcast<i32>(_e1306)) * _e147)), array<f32, 3>((f32(bitcast<i32>(_e1317)) * _e147), (f32(bitcast<i32>(_e1326)) * _e147), (f32(bitcast<i32>(_e1335)) * _e147)));
                                                        break;
                                                    }
                                                    default: {
                                                        phi_1978_ = array<array<f32, 3>, 3>();
                                                        break;
                                                    }
                                                }
                                                let _e1627 = phi_1978_;
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
                                                        phi_2862_ = type_24();
                                                        phi_2863_ = true;
                                                        phi_2864_ = false;
                                                    } else {
                                                        let _e1702 = select(_e1651, _e1638, (_e1638 < _e1651));
                                                        if (select(_e1664, _e1702, (_e1702 < _e1664)) > 0f) {
                                                            phi_2130_ = true;
                                                        } else {
                                                            let _e1707 = select(_e1651, _e1638, (_e1638 > _e1651));
                                                            phi_2130_ = (select(_e1664, _e1707, (_e1707 > _e1664)) < 0f);
                                                        }
                                                        let _e1712 = phi_2130_;
                                                        if _e1712 {
                                                            phi_2859_ = type_24();
                                                            phi_2860_ = true;
                                                            phi_2861_ = false;
                                                        } else {
                                                            let _e1714 = select(_e1654, _e1641, (_e1641 < _e1654));
                                                            if (select(_e1667, _e1714, (_e1714 < _e1667)) > 0f) {
                                                                phi_2159_ = true;
                                                            } else {
                                                                let _e1719 = select(_e1654, _e1641, (_e1641 > _e1654));
                                                                phi_2159_ = (select(_e1667, _e1719, (_e1719 > _e1667)) < 0f);
                                                            }
                                                            let _e1724 = phi_2159_;
                                                            if _e1724 {
                                                                phi_2857_ = type_24();
                                                                phi_2858_ = false;
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
                                                                    phi_2852_ = type_24();
                                                                    phi_2853_ = true;
                                                                } else {
                                                                    let _e1789 = (_e1787 > _e1180.member);
                                                                    if _e1789 {
                                                                        phi_2851_ = type_24();
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
                                                                            phi_2578_ = _e1654;
                                                                            phi_2579_ = _e1651;
                                                                            phi_2580_ = _e1641;
                                                                            phi_2581_ = _e1638;
                                                                            phi_2582_ = _e1790;
                                                                            phi_2583_ = _e1804;
                                                                            phi_2584_ = _e1800;
                                                                            phi_2585_ = _e1796;
                                                                        } else {
                                                                            let _e1849 = (_e1830 == _e1847);
                                                                            let _e1854 = vec3(_e1849);
                                                                            phi_2578_ = select(_e1641, _e1667, _e1849);
                                                                            phi_2579_ = select(_e1638, _e1664, _e1849);
                                                                            phi_2580_ = select(_e1667, _e1654, _e1849);
                                                                            phi_2581_ = select(_e1664, _e1651, _e1849);
                                                                            phi_2582_ = select(_e1792, _e1791, _e1854);
                                                                            phi_2583_ = select(_e1800, _e1796, _e1854);
                                                                            phi_2584_ = select(_e1796, _e1804, _e1854);
                                                                            phi_2585_ = select(_e1804, _e1800, _e1854);
                                                                        }
                                                                        let _e1860 = phi_2578_;
                                                                        let _e1862 = phi_2579_;
                                                                        let _e1864 = phi_2580_;
                                                                        let _e1866 = phi_2581_;
                                                                        let _e1868 = phi_2582_;
                                                                        let _e1870 = phi_2583_;
                                                                        let _e1872 = phi_2584_;
                                                                        let _e1874 = phi_2585_;
                                                                        let _e1881 = ((_e1872.y * _e1870.z) - (_e1870.y * _e1872.z));
                                                                        let _e1886 = ((_e1872.z * _e1870.x) - (_e1870.z * _e1872.x));
                                                                        let _e1889 = ((_e1872.x * _e1870.y) - (_e1870.x * _e1872.y));
                                                                        if (_e1689 >= _e1693) {
                                                                            phi_2622_ = select(true, false, (_e1689 >= _e1697));
                                                                        } else {
                                                                            phi_2622_ = true;
                                                                        }
                                                                        let _e1894 = phi_2622_;
                                                                        if _e1894 {
                                                                            phi_2631_ = select(_e1792, _e1791, vec3((_e1693 >= _e1697)));
                                                                        } else {
                                                                            phi_2631_ = _e1790;
                                                                        }
                                                                        let _e1899 = phi_2631_;
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
                                                                                phi_2796_ = (_e1910 / _e1915);
                                                                            } else {
                                                                                phi_2796_ = f32();
                                                                            }
                                                                            let _e2020 = phi_2796_;
                                                                            phi_2798_ = _e2020;
                                                                            phi_2799_ = select(true, false, _e2017);
                                                                        } else {
                                                                            phi_2798_ = f32();
                                                                            phi_2799_ = true;
                                                                        }
                                                                        let _e2023 = phi_2798_;
                                                                        let _e2025 = phi_2799_;
                                                                        if _e2025 {
                                                                            let _e2033 = (((_e1881 * (_e1942 - (_e371 * _e1945))) + (_e1886 * (_e1943 - (_e439 * _e1945)))) / _e1915);
                                                                            if (bitcast<f32>((bitcast<u32>(_e2033) & 2147483647u)) <= _e1847) {
                                                                                phi_2819_ = (_e1945 + _e2033);
                                                                            } else {
                                                                                phi_2819_ = _e1945;
                                                                            }
                                                                            let _e2040 = phi_2819_;
                                                                            phi_2820_ = _e2040;
                                                                        } else {
                                                                            phi_2820_ = _e2023;
                                                                        }
                                                                        let _e2042 = phi_2820_;
                                                                        let _e2044 = select(_e1780, _e2042, (_e2042 < _e1780));
                                                                        let _e2046 = select(_e1772, _e2044, (_e2044 > _e1772));
                                                                        if (_e2046 >= _e622) {
                                                                            let _e2048 = (_e2046 <= _e1180.member);
                                                                            if _e2048 {
                                                                                let _e2049 = (1f / _e1699);
                                                                                phi_2843_ = type_24(_e2046, (_e1693 * _e2049), (_e1697 * _e2049), _e1240);
                                                                            } else {
                                                                                phi_2843_ = type_24();
                                                                            }
                                                                            let _e2054 = phi_2843_;
                                                                            phi_2845_ = _e2054;
                                                                            phi_2846_ = select(true, false, _e2048);
                                                                        } else {
                                                                            phi_2845_ = type_24();
                                                                            phi_2846_ = true;
                                                                        }
                                                                        let _e2057 = phi_2845_;
                                                                        let _e2059 = phi_2846_;
                                                                        if _e2059 {
                                                                            phi_2850_ = type_24(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                        } else {
                                                                            phi_2850_ = _e2057;
                                                                        }
                                                                        let _e2061 = phi_2850_;
                                                                        phi_2851_ = _e2061;
                                                                    }
                                                                    let _e2063 = phi_2851_;
                                                                    phi_2852_ = _e2063;
                                                                    phi_2853_ = _e1789;
                                                                }
                                                                let _e2065 = phi_2852_;
                                                                let _e2067 = phi_2853_;
                                                                phi_2857_ = _e2065;
                                                                phi_2858_ = _e2067;
                                                            }
                                                            let _e2069 = phi_2857_;
                                                            let _e2071 = phi_2858_;
                                                            phi_2859_ = _e2069;
                                                            phi_2860_ = _e1724;
                                                            phi_2861_ = _e2071;
                                                        }
                                                        let _e2073 = phi_2859_;
                                                        let _e2075 = phi_2860_;
                                                        let _e2077 = phi_2861_;
                                                        phi_2862_ = _e2073;
                                                        phi_2863_ = _e2075;
                                                        phi_2864_ = _e2077;
                                                    }
                                                    let _e2079 = phi_2862_;
                                                    let _e2081 = phi_2863_;
                                                    let _e2083 = phi_2864_;
                                                    phi_2872_ = _e2079;
                                                    phi_2873_ = select(_e2083, true, _e2081);
                                                } else {
                                                    phi_2872_ = type_24();
                                                    phi_2873_ = true;
                                                }
                                                let _e2086 = phi_2872_;
                                                let _e2088 = phi_2873_;
                                                if _e2088 {
                                                    phi_2877_ = type_24(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                } else {
                                                    phi_2877_ = _e2086;
                                                }
                                                let _e2090 = phi_2877_;
                                                if (_e2090.member_3 != 4294967295u) {
                                                    if (_e1240 != 4294967295u) {
                                                        phi_2888_ = type_38(_e1180.member, true);
                                                    } else {
                                                        phi_2888_ = _e1180;
                                                    }
                                                    let _e2098 = phi_2888_;
                                                    phi_2889_ = _e2098;
                                                } else {
                                                    phi_2889_ = _e1180;
                                                }
                                                let _e2100 = phi_2889_;
                                                phi_1215_ = _e2100;
                                            } else {
                                                phi_1215_ = type_38();
                                            }
                                            let _e2102 = phi_1215_;
                                            continue;
                                            continuing {
                                                phi_1214_ = _e2102;
                                                phi_1217_ = _e1195;
                                                phi_4388_ = _e664;
                                                break if !(_e1201);
                                            }
                                        }
                                        let _e2105 = phi_4388_;
                                        phi_4592_ = _e2105;
                                        if _e2105 {
                                            break;
                                        }
                                        let _e2107 = local_10;
                                        phi_4596_ = _e2105;
                                        let _e2313 = local_12;
                                        phi_4162_ = _e2313;
                                        phi_4163_ = false;
                                        phi_4164_ = select(_e707, 0u, _e2107.member_1);
                                        phi_4165_ = _e709;
                                    } else {
                                        if (_e709.member_1 >= _e96) {
                                            phi_3697_ = type_46(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), type_45(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u), type_45(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u));
                                        } else {
                                            if (_e709.member_1 < _e96) {
                                            } else {
                                                phi_4592_ = true;
                                                break;
                                            }
                                            let _e722 = ((1u + _e267) % 4u);
                                            if (_e722 < 4u) {
                                            } else {
                                                phi_4592_ = true;
                                                break;
                                            }
                                            let _e727 = global_3.member[_e709.member_1][_e722];
                                            let _e729 = (_e727 >> bitcast<u32>(11u));
                                            let _e731 = ((1u + _e266) % 4u);
                                            if (_e731 < 4u) {
                                            } else {
                                                phi_4592_ = true;
                                                break;
                                            }
                                            let _e736 = global_3.member[_e709.member_1][_e731];
                                            let _e738 = (_e736 >> bitcast<u32>(11u));
                                            let _e740 = ((1u + _e268) % 4u);
                                            if (_e740 < 4u) {
                                            } else {
                                                phi_4592_ = true;
                                                break;
                                            }
                                            let _e745 = global_3.member[_e709.member_1][_e740];
                                            let _e747 = (_e745 >> bitcast<u32>(11u));
                                            let _e770 = (bitcast<f32>((bitcast<u32>((_e709.member.member_1.x - _e709.member.member.x)) & 2139095040u)) * 0.001953125f);
                                            let _e771 = (bitcast<f32>((bitcast<u32>((_e709.member.member_1.y - _e709.member.member.y)) & 2139095040u)) * 0.001953125f);
                                            let _e772 = (bitcast<f32>((bitcast<u32>((_e709.member.member_1.z - _e709.member.member.z)) & 2139095040u)) * 0.001953125f);
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
                                            let _e887 = (_e709.member.member.x + _e817);
                                            let _e888 = (_e709.member.member.y + _e826);
                                            let _e889 = (_e709.member.member.z + _e835);
                                            let _e892 = (_e709.member.member_1.x - _e856);
                                            let _e893 = (_e709.member.member_1.y - _e865);
                                            let _e894 = (_e709.member.member_1.z - _e874);
                                            let _e913 = (_e892 - _e887);
                                            let _e914 = (_e893 - _e888);
                                            let _e915 = (_e894 - _e889);
                                            let _e917 = select(_e914, _e913, (_e913 > _e914));
                                            let _e919 = select(_e915, _e917, (_e917 > _e915));
                                            if (_e919 < (1024f * _e147)) {
                                                phi_3398_ = 0u;
                                            } else {
                                                phi_3398_ = select(2u, 1u, (_e919 < (2097152f * _e147)));
                                            }
                                            let _e926 = phi_3398_;
                                            switch bitcast<i32>(_e926) {
                                                case 0: {
                                                    phi_3404_ = 1u;
                                                    break;
                                                }
                                                case 1: {
                                                    phi_3404_ = 2u;
                                                    break;
                                                }
                                                case 2: {
                                                    phi_3404_ = 3u;
                                                    break;
                                                }
                                                default: {
                                                    phi_3404_ = u32();
                                                    break;
                                                }
                                            }
                                            let _e929 = phi_3404_;
                                            let _e935 = global_3.member[_e709.member_1][0u];
                                            let _e939 = global_3.member[_e709.member_1][1u];
                                            let _e943 = global_3.member[_e709.member_1][2u];
                                            let _e947 = global_3.member[_e709.member_1][3u];
                                            let _e959 = (((_e939 >> bitcast<u32>(22i)) | ((_e943 >> bitcast<u32>(22i)) << bitcast<u32>(10i))) | ((_e947 >> bitcast<u32>(22i)) << bitcast<u32>(20i)));
                                            let _e960 = (_e935 & 268435455u);
                                            let _e961 = (_e959 & 268435455u);
                                            let _e964 = ((_e935 >> bitcast<u32>(28u)) & 7u);
                                            let _e972 = ((_e935 >> bitcast<u32>(31i)) | (((_e959 >> bitcast<u32>(28u)) & 3u) << bitcast<u32>(1i)));
                                            let _e973 = (_e964 != 0u);
                                            if (_e964 == 0u) {
                                                phi_3659_ = _e960;
                                            } else {
                                                if (_e964 == 7u) {
                                                    phi_3658_ = 2147483648u;
                                                } else {
                                                    phi_3658_ = ((2147483648u | (_e964 << bitcast<u32>(28u))) | (_e961 & 268435455u));
                                                }
                                                let _e982 = phi_3658_;
                                                phi_3659_ = _e982;
                                            }
                                            let _e984 = phi_3659_;
                                            if _e973 {
                                                let _e985 = (_e964 != 7u);
                                                if _e985 {
                                                    phi_3669_ = (_e961 + (_e964 * ((3u * _e929) + 1u)));
                                                } else {
                                                    phi_3669_ = u32();
                                                }
                                                let _e989 = phi_3669_;
                                                phi_3671_ = _e989;
                                                phi_3672_ = select(true, false, _e985);
                                            } else {
                                                phi_3671_ = u32();
                                                phi_3672_ = true;
                                            }
                                            let _e992 = phi_3671_;
                                            let _e994 = phi_3672_;
                                            if (_e972 == 0u) {
                                                phi_3693_ = (_e960 + select(0u, 1u, !(_e973)));
                                            } else {
                                                if (_e972 == 7u) {
                                                    phi_3692_ = 2147483648u;
                                                } else {
                                                    phi_3692_ = ((2147483648u | (_e972 << bitcast<u32>(28u))) | (select(_e992, _e961, _e994) & 268435455u));
                                                }
                                                let _e1007 = phi_3692_;
                                                phi_3693_ = _e1007;
                                            }
                                            let _e1009 = phi_3693_;
                                            phi_3697_ = type_46(array<vec4<f32>, 3>(vec4<f32>(_e887, (_e709.member.member.x + _e839), _e892, (_e709.member.member_1.x - _e878)), vec4<f32>(_e888, (_e709.member.member.y + _e843), _e893, (_e709.member.member_1.y - _e882)), vec4<f32>(_e889, (_e709.member.member.z + _e847), _e894, (_e709.member.member_1.z - _e886))), type_45(type_28((_e709.member.member + vec4<f32>(_e817, _e826, _e835, 0f)), (_e709.member.member_1 - vec4<f32>(_e856, _e865, _e874, 0f))), _e984), type_45(type_28((_e709.member.member + vec4<f32>(_e839, _e843, _e847, 0f)), (_e709.member.member_1 - vec4<f32>(_e878, _e882, _e886, 0f))), _e1009));
                                        }
                                        let _e1014 = phi_3697_;
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
                                                    phi_4059_ = _e1014.member_2;
                                                } else {
                                                    phi_4059_ = _e1014.member_1;
                                                }
                                                let _e1120 = phi_4059_;
                                                let _e1142 = (_e707 % 128u);
                                                let _e1143 = (_e1142 < 128u);
                                                if _e1143 {
                                                } else {
                                                    phi_4592_ = true;
                                                    break;
                                                }
                                                local_8[_e1142] = _e1120.member_1;
                                                if _e1143 {
                                                } else {
                                                    phi_4592_ = true;
                                                    break;
                                                }
                                                local_7[_e1142] = _e1120.member.member.x;
                                                if _e1143 {
                                                } else {
                                                    phi_4592_ = true;
                                                    break;
                                                }
                                                local_6[_e1142] = _e1120.member.member.y;
                                                if _e1143 {
                                                } else {
                                                    phi_4592_ = true;
                                                    break;
                                                }
                                                local_5[_e1142] = _e1120.member.member.z;
                                                if _e1143 {
                                                } else {
                                                    phi_4592_ = true;
                                                    break;
                                                }
                                                local_4[_e1142] = _e1120.member.member_1.x;
                                                if _e1143 {
                                                } else {
                                                    phi_4592_ = true;
                                                    break;
                                                }
                                                local_3[_e1142] = _e1120.member.member_1.y;
                                                if _e1143 {
                                                } else {
                                                    phi_4592_ = true;
                                                    break;
                                                }
                                                local_2[_e1142] = _e1120.member.member_1.z;
                                                if _e1143 {
                                                } else {
                                                    phi_4592_ = true;
                                                    break;
                                                }
                                                local_9[_e1142] = select(_e1109, _e1107, !(_e1116));
                                                if _e1116 {
                                                    phi_4136_ = _e1014.member_1;
                                                } else {
                                                    phi_4136_ = _e1014.member_2;
                                                }
                                                let _e1156 = phi_4136_;
                                                phi_4137_ = (_e707 + 1u);
                                                phi_4138_ = _e1156;
                                            } else {
                                                phi_4137_ = u32();
                                                phi_4138_ = type_45();
                                            }
                                            let _e1158 = phi_4137_;
                                            let _e1160 = phi_4138_;
                                            phi_4140_ = _e1158;
                                            phi_4141_ = _e1160;
                                            phi_4142_ = select(true, false, _e1115);
                                        } else {
                                            phi_4140_ = u32();
                                            phi_4141_ = type_45();
                                            phi_4142_ = true;
                                        }
                                        let _e1163 = phi_4140_;
                                        let _e1165 = phi_4141_;
                                        let _e1167 = phi_4142_;
                                        if _e1167 {
                                            if _e1114 {
                                                phi_4151_ = _e1014.member_1;
                                            } else {
                                                phi_4151_ = _e1014.member_2;
                                            }
                                            let _e1171 = phi_4151_;
                                            phi_4156_ = select(_e1115, true, _e1114);
                                            phi_4158_ = _e1171;
                                        } else {
                                            phi_4156_ = _e705;
                                            phi_4158_ = _e1165;
                                        }
                                        let _e1174 = phi_4156_;
                                        let _e1176 = phi_4158_;
                                        phi_4596_ = _e664;
                                        phi_4162_ = _e666;
                                        phi_4163_ = _e1174;
                                        phi_4164_ = select(_e1163, _e707, _e1167);
                                        phi_4165_ = _e1176;
                                    }
                                    let _e2111 = phi_4596_;
                                    let _e2113 = phi_4162_;
                                    let _e2115 = phi_4163_;
                                    let _e2117 = phi_4164_;
                                    let _e2119 = phi_4165_;
                                    phi_4595_ = _e2111;
                                    phi_4166_ = _e2113;
                                    phi_4167_ = _e2115;
                                    phi_4168_ = (_e670 - 1u);
                                    phi_4169_ = _e2117;
                                    phi_4170_ = _e2119;
                                } else {
                                    phi_4595_ = _e664;
                                    phi_4166_ = _e666;
                                    phi_4167_ = _e705;
                                    phi_4168_ = _e670;
                                    phi_4169_ = _e707;
                                    phi_4170_ = _e709;
                                }
                                let _e2121 = phi_4595_;
                                let _e2123 = phi_4166_;
                                let _e2125 = phi_4167_;
                                let _e2127 = phi_4168_;
                                let _e2129 = phi_4169_;
                                let _e2131 = phi_4170_;
                                phi_4594_ = _e2121;
                                phi_4171_ = _e2123;
                                phi_4172_ = _e2125;
                                phi_4173_ = _e2127;
                                phi_4174_ = _e2129;
                                phi_4175_ = _e2131;
                            } else {
                                phi_4594_ = _e664;
                                phi_4171_ = type_38();
                                phi_4172_ = bool();
                                phi_4173_ = u32();
                                phi_4174_ = u32();
                                phi_4175_ = type_45();
                            }
                            let _e2133 = phi_4594_;
                            let _e2135 = phi_4171_;
                            let _e2137 = phi_4172_;
                            let _e2139 = phi_4173_;
                            let _e2141 = phi_4174_;
                            let _e2143 = phi_4175_;
                            phi_4593_ = _e2133;
                            phi_1088_ = _e2135;
                            phi_1091_ = _e2137;
                            phi_1093_ = _e2139;
                            phi_1095_ = _e2141;
                            phi_1097_ = _e2143;
                            phi_4176_ = _e678;
                        } else {
                            phi_4593_ = _e664;
                            phi_1088_ = type_38();
                            phi_1091_ = bool();
                            phi_1093_ = u32();
                            phi_1095_ = u32();
                            phi_1097_ = type_45();
                            phi_4176_ = false;
                        }
                        let _e2145 = phi_4593_;
                        let _e2147 = phi_1088_;
                        let _e2149 = phi_1091_;
                        let _e2151 = phi_1093_;
                        let _e2153 = phi_1095_;
                        let _e2155 = phi_1097_;
                        let _e2157 = phi_4176_;
                        continue;
                        continuing {
                            phi_4394_ = _e2145;
                            phi_1087_ = _e2147;
                            phi_1090_ = _e2149;
                            phi_1092_ = _e2151;
                            phi_1094_ = _e2153;
                            phi_1096_ = _e2155;
                            phi_4592_ = _e2145;
                            break if !(_e2157);
                        }
                    }
                    let _e2160 = phi_4592_;
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
