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
    var phi_4397_: bool;
    var phi_1087_: type_38;
    var phi_1090_: u32;
    var phi_1092_: bool;
    var phi_1094_: u32;
    var phi_1096_: type_45;
    var phi_1107_: bool;
    var phi_1193_: bool;
    var phi_1194_: u32;
    var phi_1195_: type_45;
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
    var phi_4391_: bool;
    var phi_4686_: bool;
    var phi_2890_: type_38;
    var phi_3392_: u32;
    var phi_3398_: u32;
    var phi_3652_: u32;
    var phi_3653_: u32;
    var phi_3663_: u32;
    var phi_3665_: u32;
    var phi_3666_: bool;
    var phi_3686_: u32;
    var phi_3687_: u32;
    var phi_3691_: type_46;
    var phi_4053_: type_45;
    var phi_4129_: type_45;
    var phi_4130_: u32;
    var phi_4131_: type_45;
    var phi_4133_: u32;
    var phi_4134_: type_45;
    var phi_4135_: bool;
    var phi_4144_: type_45;
    var phi_4149_: bool;
    var phi_4151_: type_45;
    var phi_4155_: bool;
    var phi_4156_: u32;
    var phi_4157_: type_45;
    var phi_4167_: u32;
    var phi_4168_: type_45;
    var phi_4598_: bool;
    var phi_4169_: type_38;
    var phi_4170_: u32;
    var phi_4171_: bool;
    var phi_4172_: u32;
    var phi_4173_: type_45;
    var phi_4597_: bool;
    var phi_4174_: type_38;
    var phi_4175_: u32;
    var phi_4176_: bool;
    var phi_4177_: u32;
    var phi_4178_: type_45;
    var phi_4596_: bool;
    var phi_1088_: type_38;
    var phi_1091_: u32;
    var phi_1093_: bool;
    var phi_1095_: u32;
    var phi_1097_: type_45;
    var phi_4179_: bool;
    var phi_4595_: bool;
    var local_10: type_38;
    var local_11: type_38;

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
                    phi_4397_ = false;
                    phi_1087_ = type_38(_e620, false);
                    phi_1090_ = ((3u * _e96) + 1u);
                    phi_1092_ = (_e622 <= _e620);
                    phi_1094_ = 0u;
                    phi_1096_ = type_45(type_28(vec4<f32>((f32(_e629) * _e147), (f32(_e635) * _e147), (f32(_e641) * _e147), 0f), vec4<f32>((f32(_e646) * _e147), (f32(_e650) * _e147), (f32(_e654) * _e147), 0f)), select(0u, 2147483648u, (_e96 == 0u)));
                    loop {
                        let _e664 = phi_4397_;
                        let _e666 = phi_1087_;
                        let _e668 = phi_1090_;
                        let _e670 = phi_1092_;
                        let _e672 = phi_1094_;
                        let _e674 = phi_1096_;
                        local_10 = _e666;
                        if _e670 {
                            phi_1107_ = true;
                        } else {
                            phi_1107_ = (_e672 > 0u);
                        }
                        let _e677 = phi_1107_;
                        if _e677 {
                            let _e678 = (_e668 > 0u);
                            if _e678 {
                                if _e670 {
                                    phi_1193_ = _e670;
                                    phi_1194_ = _e672;
                                    phi_1195_ = _e674;
                                } else {
                                    let _e679 = (_e672 - 1u);
                                    let _e680 = (_e679 % 128u);
                                    let _e681 = (_e680 < 128u);
                                    if _e681 {
                                    } else {
                                        phi_4595_ = true;
                                        break;
                                    }
                                    let _e683 = local_7[_e680];
                                    if _e681 {
                                    } else {
                                        phi_4595_ = true;
                                        break;
                                    }
                                    let _e685 = local_6[_e680];
                                    if _e681 {
                                    } else {
                                        phi_4595_ = true;
                                        break;
                                    }
                                    let _e687 = local_5[_e680];
                                    if _e681 {
                                    } else {
                                        phi_4595_ = true;
                                        break;
                                    }
                                    let _e689 = local_4[_e680];
                                    if _e681 {
                                    } else {
                                        phi_4595_ = true;
                                        break;
                                    }
                                    let _e691 = local_3[_e680];
                                    if _e681 {
                                    } else {
                                        phi_4595_ = true;
                                        break;
                                    }
                                    let _e693 = local_2[_e680];
                                    if _e681 {
                                    } else {
                                        phi_4595_ = true;
                                        break;
                                    }
                                    let _e698 = local_8[_e680];
                                    if _e681 {
                                    } else {
                                        phi_4595_ = true;
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
                                    let _e713 = ((_e709.member_1 & 2147483648u) != 0u);
                                    let _e714 = (_e709.member_1 & 268435455u);
                                    if _e713 {
                                        phi_1214_ = _e666;
                                        phi_1217_ = type_8(0u, ((_e709.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e721 = phi_1214_;
                                            let _e723 = phi_1217_;
                                            local_11 = _e721;
                                            if (_e723.member < _e723.member_1) {
                                                phi_1218_ = type_8((_e723.member + 1u), _e723.member_1);
                                                phi_1240_ = type_8(1u, _e723.member);
                                            } else {
                                                phi_1218_ = _e723;
                                                phi_1240_ = type_8(0u, type_8().member_1);
                                            }
                                            let _e736 = phi_1218_;
                                            let _e738 = phi_1240_;
                                            let _e742 = (bitcast<i32>(_e738.member) != 0i);
                                            if _e742 {
                                                let _e747 = (_e709.member.member_1.x - _e709.member.member.x);
                                                let _e750 = (_e709.member.member_1.y - _e709.member.member.y);
                                                let _e753 = (_e709.member.member_1.z - _e709.member.member.z);
                                                let _e755 = select(_e750, _e747, (_e747 > _e750));
                                                let _e757 = select(_e753, _e755, (_e755 > _e753));
                                                let _e759 = (_e757 < (1024f * _e147));
                                                if _e759 {
                                                    phi_1281_ = 0u;
                                                } else {
                                                    phi_1281_ = select(2u, 1u, (_e757 < (2097152f * _e147)));
                                                }
                                                let _e764 = phi_1281_;
                                                switch bitcast<i32>(_e764) {
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
                                                let _e767 = phi_1287_;
                                                switch bitcast<i32>(_e764) {
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
                                                let _e774 = phi_1297_;
                                                let _e776 = ((_e714 + (_e738.member_1 * ((3u * _e767) + 1u))) + (3u * _e774));
                                                let _e777 = (_e776 < _e99);
                                                if _e777 {
                                                    if _e777 {
                                                    } else {
                                                        phi_4391_ = true;
                                                        break;
                                                    }
                                                    let _e779 = global_6.member[_e776];
                                                    phi_1313_ = _e779;
                                                } else {
                                                    phi_1313_ = 4294967295u;
                                                }
                                                let _e781 = phi_1313_;
                                                if _e759 {
                                                    phi_1346_ = 0u;
                                                } else {
                                                    phi_1346_ = select(2u, 1u, (_e757 < (2097152f * _e147)));
                                                }
                                                let _e786 = phi_1346_;
                                                switch bitcast<i32>(_e786) {
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
                                                let _e789 = phi_1352_;
                                                let _e793 = (_e714 + (_e738.member_1 * ((3u * _e789) + 1u)));
                                                switch bitcast<i32>(_e786) {
                                                    case 0: {
                                                        let _e1068 = (_e793 < _e99);
                                                        if _e1068 {
                                                            if _e1068 {
                                                            } else {
                                                                phi_4391_ = true;
                                                                break;
                                                            }
                                                            let _e1070 = global_6.member[_e793];
                                                            phi_1379_ = _e1070;
                                                        } else {
                                                            phi_1379_ = 0u;
                                                        }
                                                        let _e1072 = phi_1379_;
                                                        let _e1074 = ((10u * _e267) & 31u);
                                                        let _e1084 = ((10u * _e266) & 31u);
                                                        let _e1094 = ((10u * _e268) & 31u);
                                                        let _e1104 = (_e793 + 1u);
                                                        let _e1105 = (_e1104 < _e99);
                                                        if _e1105 {
                                                            if _e1105 {
                                                            } else {
                                                                phi_4391_ = true;
                                                                break;
                                                            }
                                                            let _e1107 = global_6.member[_e1104];
                                                            phi_1428_ = _e1107;
                                                        } else {
                                                            phi_1428_ = 0u;
                                                        }
                                                        let _e1109 = phi_1428_;
                                                        let _e1135 = (_e793 + 2u);
                                                        let _e1136 = (_e1135 < _e99);
                                                        if _e1136 {
                                                            if _e1136 {
                                                            } else {
                                                                phi_4391_ = true;
                                                                break;
                                                            }
                                                            let _e1138 = global_6.member[_e1135];
                                                            phi_1477_ = _e1138;
                                                        } else {
                                                            phi_1477_ = 0u;
                                                        }
                                                        let _e1140 = phi_1477_;
                                                        phi_1978_ = array<array<f32, 3>, 3>(array<f32, 3>((_e709.member.member.x + ((bitcast<f32>((1258291200u | ((_e1072 >> bitcast<u32>(_e1074)) & 1023u))) - 8388608f) * _e147)), (_e709.member.member.y + ((bitcast<f32>((1258291200u | ((_e1072 >> bitcast<u32>(_e1084)) & 1023u))) - 8388608f) * _e147)), (_e709.member.member.z + ((bitcast<f32>((1258291200u | ((_e1072 >> bitcast<u32>(_e1094)) & 1023u))) - 8388608f) * _e147))), array<f32, 3>((_e709.member.member.x + ((bitcast<f32>((1258291200u | ((_e1109 >> bitcast<u32>(_e1074)) & 1023u))) - 8388608f) * _e147)), (_e709.member.member.y + ((bitcast<f32>((1258291200u | ((_e1109 >> bitcast<u32>(_e1084)) & 1023u))) - 8388608f) * _e147)), (_e709.member.member.z + ((bitcast<f32>((1258291200u | ((_e1109 >> bitcast<u32>(_e1094)) & 1023u))) - 8388608f) * _e147))), array<f32, 3>((_e709.member.member.x + ((bitcast<f32>((1258291200u | ((_e1140 >> bitcast<u32>(_e1074)) & 1023u))) - 8388608f) * _e147)), (_e709.member.member.y + ((bitcast<f32>((1258291200u | ((_e1140 >> bitcast<u32>(_e1084)) & 1023u))) - 8388608f) * _e147)), (_e709.member.member.z + ((bitcast<f32>((1258291200u | ((_e1140 >> bitcast<u32>(_e1094)) & 1023u))) - 8388608f) * _e147))));
                                                        break;
                                                    }
                                                    case 1: {
                                                        let _e882 = (_e793 < _e99);
                                                        if _e882 {
                                                            if _e882 {
                                                            } else {
                                                                phi_4391_ = true;
                                                                break;
                                                            }
                                                            let _e884 = global_6.member[_e793];
                                                            phi_1526_ = _e884;
                                                        } else {
                                                            phi_1526_ = 0u;
                                                        }
                                                        let _e886 = phi_1526_;
                                                        let _e887 = (_e793 + 1u);
                                                        let _e888 = (_e887 < _e99);
                                                        if _e888 {
                                                            if _e888 {
                                                            } else {
                                                                phi_4391_ = true;
                                                                break;
                                                            }
                                                            let _e890 = global_6.member[_e887];
                                                            phi_1541_ = _e890;
                                                        } else {
                                                            phi_1541_ = 0u;
                                                        }
                                                        let _e892 = phi_1541_;
                                                        let _e893 = (_e267 == 1u);
                                                        if _e893 {
                                                            phi_1551_ = ((_e886 >> bitcast<u32>(21i)) | (_e892 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1551_ = (_e892 >> bitcast<u32>(10i));
                                                        }
                                                        let _e902 = phi_1551_;
                                                        let _e910 = (_e266 == 1u);
                                                        if _e910 {
                                                            phi_1572_ = ((_e886 >> bitcast<u32>(21i)) | (_e892 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1572_ = (_e892 >> bitcast<u32>(10i));
                                                        }
                                                        let _e919 = phi_1572_;
                                                        let _e927 = (_e268 == 1u);
                                                        if _e927 {
                                                            phi_1593_ = ((_e886 >> bitcast<u32>(21i)) | (_e892 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1593_ = (_e892 >> bitcast<u32>(10i));
                                                        }
                                                        let _e936 = phi_1593_;
                                                        let _e945 = (_e793 + 2u);
                                                        let _e946 = (_e945 < _e99);
                                                        if _e946 {
                                                            if _e946 {
                                                            } else {
                                                                phi_4391_ = true;
                                                                break;
                                                            }
                                                            let _e948 = global_6.member[_e945];
                                                            phi_1623_ = _e948;
                                                        } else {
                                                            phi_1623_ = 0u;
                                                        }
                                                        let _e950 = phi_1623_;
                                                        let _e951 = (_e793 + 3u);
                                                        let _e952 = (_e951 < _e99);
                                                        if _e952 {
                                                            if _e952 {
                                                            } else {
                                                                phi_4391_ = true;
                                                                break;
                                                            }
                                                            let _e954 = global_6.member[_e951];
                                                            phi_1638_ = _e954;
                                                        } else {
                                                            phi_1638_ = 0u;
                                                        }
                                                        let _e956 = phi_1638_;
                                                        if _e893 {
                                                            phi_1648_ = ((_e950 >> bitcast<u32>(21i)) | (_e956 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1648_ = (_e956 >> bitcast<u32>(10i));
                                                        }
                                                        let _e965 = phi_1648_;
                                                        if _e910 {
                                                            phi_1669_ = ((_e950 >> bitcast<u32>(21i)) | (_e956 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1669_ = (_e956 >> bitcast<u32>(10i));
                                                        }
                                                        let _e981 = phi_1669_;
                                                        if _e927 {
                                                            phi_1690_ = ((_e950 >> bitcast<u32>(21i)) | (_e956 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1690_ = (_e956 >> bitcast<u32>(10i));
                                                        }
                                                        let _e997 = phi_1690_;
                                                        let _e1006 = (_e793 + 4u);
                                                        let _e1007 = (_e1006 < _e99);
                                                        if _e1007 {
                                                            if _e1007 {
                                                            } else {
                                                                phi_4391_ = true;
                                                                break;
                                                            }
                                                            let _e1009 = global_6.member[_e1006];
                                                            phi_1720_ = _e1009;
                                                        } else {
                                                            phi_1720_ = 0u;
                                                        }
                                                        let _e1011 = phi_1720_;
                                                        let _e1012 = (_e793 + 5u);
                                                        let _e1013 = (_e1012 < _e99);
                                                        if _e1013 {
                                                            if _e1013 {
                                                            } else {
                                                                phi_4391_ = true;
                                                                break;
                                                            }
                                                            let _e1015 = global_6.member[_e1012];
                                                            phi_1735_ = _e1015;
                                                        } else {
                                                            phi_1735_ = 0u;
                                                        }
                                                        let _e1017 = phi_1735_;
                                                        if _e893 {
                                                            phi_1745_ = ((_e1011 >> bitcast<u32>(21i)) | (_e1017 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1745_ = (_e1017 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1026 = phi_1745_;
                                                        if _e910 {
                                                            phi_1766_ = ((_e1011 >> bitcast<u32>(21i)) | (_e1017 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1766_ = (_e1017 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1042 = phi_1766_;
                                                        if _e927 {
                                                            phi_1787_ = ((_e1011 >> bitcast<u32>(21i)) | (_e1017 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1787_ = (_e1017 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1058 = phi_1787_;
                                                        phi_1978_ = array<array<f32, 3>, 3>(array<f32, 3>((_e709.member.member.x + ((bitcast<f32>((1258291200u | (select(_e902, _e886, _e306) & 2097151u))) - 8388608f) * _e147)), (_e709.member.member.y + ((bitcast<f32>((1258291200u | (select(_e919, _e886, _e375) & 2097151u))) - 8388608f) * _e147)), (_e709.member.member.z + ((bitcast<f32>((1258291200u | (select(_e936, _e886, _e443) & 2097151u))) - 8388608f) * _e147))), array<f32, 3>((_e709.member.member.x + ((bitcast<f32>((1258291200u | (select(_e965, _e950, _e306) & 2097151u))) - 8388608f) * _e147)), (_e709.member.member.y + ((bitcast<f32>((1258291200u | (select(_e981, _e950, _e375) & 2097151u))) - 8388608f) * _e147)), (_e709.member.member.z + ((bitcast<f32>((1258291200u | (select(_e997, _e950, _e443) & 2097151u))) - 8388608f) * _e147))), array<f32, 3>((_e709.member.member.x + ((bitcast<f32>((1258291200u | (select(_e1026, _e1011, _e306) & 2097151u))) - 8388608f) * _e147)), (_e709.member.member.y + ((bitcast<f32>((1258291200u | (select(_e1042, _e1011, _e375) & 2097151u))) - 8388608f) * _e147)), (_e709.member.member.z + ((bitcast<f32>((1258291200u | (select(_e1058, _e1011, _e443) & 2097151u))) - 8388608f) * _e147))));
                                                        break;
                                                    }
                                                    case 2: {
                                                        let _e795 = (_e793 + _e267);
                                                        let _e796 = (_e795 < _e99);
                                                        if _e796 {
                                                            if _e796 {
                                                            } else {
                                                                phi_4391_ = true;
                                                                break;
                                                            }
                                                            let _e798 = global_6.member[_e795];
                                                            phi_1818_ = _e798;
                                                        } else {
                                                            phi_1818_ = 0u;
                                                        }
                                                        let _e800 = phi_1818_;
                                                        let _e804 = (_e793 + _e266);
                                                        let _e805 = (_e804 < _e99);
                                                        if _e805 {
                                                            if _e805 {
                                                            } else {
                                                                phi_4391_ = true;
                                                                break;
                                                            }
                                                            let _e807 = global_6.member[_e804];
                                                            phi_1836_ = _e807;
                                                        } else {
                                                            phi_1836_ = 0u;
                                                        }
                                                        let _e809 = phi_1836_;
                                                        let _e813 = (_e793 + _e268);
                                                        let _e814 = (_e813 < _e99);
                                                        if _e814 {
                                                            if _e814 {
                                                            } else {
                                                                phi_4391_ = true;
                                                                break;
                                                            }
                                                            let _e816 = global_6.member[_e813];
                                                            phi_1854_ = _e816;
                                                        } else {
                                                            phi_1854_ = 0u;
                                                        }
                                                        let _e818 = phi_1854_;
                                                        let _e823 = (_e793 + 3u);
                                                        let _e824 = (_e823 + _e267);
                                                        let _e825 = (_e824 < _e99);
                                                        if _e825 {
                                                            if _e825 {
                                                            } else {
                                                                phi_4391_ = true;
                                                                break;
                                                            }
                                                            let _e827 = global_6.member[_e824];
                                                            phi_1877_ = _e827;
                                                        } else {
                                                            phi_1877_ = 0u;
                                                        }
                                                        let _e829 = phi_1877_;
                                                        let _e833 = (_e823 + _e266);
                                                        let _e834 = (_e833 < _e99);
                                                        if _e834 {
                                                            if _e834 {
                                                            } else {
                                                                phi_4391_ = true;
                                                                break;
                                                            }
                                                            let _e836 = global_6.member[_e833];
                                                            phi_1895_ = _e836;
                                                        } else {
                                                            phi_1895_ = 0u;
                                                        }
                                                        let _e838 = phi_1895_;
                                                        let _e842 = (_e823 + _e268);
                                                        let _e843 = (_e842 < _e99);
                                                        if _e843 {
                                                            if _e843 {
                                                            } else {
                                                                phi_4391_ = true;
                                                                break;
                                                            }
                                                            let _e845 = global_6.member[_e842];
                                                            phi_1913_ = _e845;
                                                        } else {
                                                            phi_1913_ = 0u;
                                                        }
                                                        let _e847 = phi_1913_;
                                                        let _e852 = (_e793 + 6u);
                                                        let _e853 = (_e852 + _e267);
                                                        let _e854 = (_e853 < _e99);
                                                        if _e854 {
                                                            if _e854 {
                                                            } else {
                                                                phi_4391_ = true;
                                                                break;
                                                            }
                                                            let _e856 = global_6.member[_e853];
                                                            phi_1936_ = _e856;
                                                        } else {
                                                            phi_1936_ = 0u;
                                                        }
                                                        let _e858 = phi_1936_;
                                                        let _e862 = (_e852 + _e266);
                                                        let _e863 = (_e862 < _e99);
                                                        if _e863 {
                                                            if _e863 {
                                                            } else {
                                                                phi_4391_ = true;
                                                                break;
                                                            }
                                                            let _e865 = global_6.member[_e862];
                                                            phi_1954_ = _e865;
                                                        } else {
                                                            phi_1954_ = 0u;
                                                        }
                                                        let _e867 = phi_1954_;
                                                        let _e871 = (_e852 + _e268);
                                                        let _e872 = (_e871 < _e99);
                                                        if _e872 {
                                                            if _e872 {
                                                            } else {
                                                                phi_4391_ = true;
                                                                break;
                                                            }
                                                            let _e874 = global_6.member[_e871];
                                                            phi_1972_ = _e874;
                                                        } else {
                                                            phi_1972_ = 0u;
                                                        }
                                                        let _e876 = phi_1972_;
                                                        phi_1978_ = array<array<f32, 3>, 3>(array<f32, 3>((f32(bitcast<i32>(_e800)) * _e147), (f32(bitcast<i32>(_e809)) * _e147), (f32(bitcast<i32>(_e818)) * _e147)), array<f32, 3>((f32(bitcast<i32>(_e829)) * _e147), (f32(bitcast<i32>(_e838)) * _e147), (f32(bitcast<i32>(_e847)) * _e147)), array<f32, 3>((f32(bitcast<i32>(_e858)) * _e147), (f32(bitcast<i32>(_e867)) * _e147), (f32(bitcast<i32>(_e876)) * _e147)));
                                                        break;
                                                    }
                                                    default: {
                                                        phi_1978_ = array<array<f32, 3>, 3>();
                                                        break;
                                                    }
                                                }
                                                let _e1168 = phi_1978_;
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
                                                        phi_2862_ = type_24();
                                                        phi_2863_ = true;
                                                        phi_2864_ = false;
                                                    } else {
                                                        let _e1243 = select(_e1192, _e1179, (_e1179 < _e1192));
                                                        if (select(_e1205, _e1243, (_e1243 < _e1205)) > 0f) {
                                                            phi_2130_ = true;
                                                        } else {
                                                            let _e1248 = select(_e1192, _e1179, (_e1179 > _e1192));
                                                            phi_2130_ = (select(_e1205, _e1248, (_e1248 > _e1205)) < 0f);
                                                        }
                                                        let _e1253 = phi_2130_;
                                                        if _e1253 {
                                                            phi_2859_ = type_24();
                                                            phi_2860_ = true;
                                                            phi_2861_ = false;
                                                        } else {
                                                            let _e1255 = select(_e1195, _e1182, (_e1182 < _e1195));
                                                            if (select(_e1208, _e1255, (_e1255 < _e1208)) > 0f) {
                                                                phi_2159_ = true;
                                                            } else {
                                                                let _e1260 = select(_e1195, _e1182, (_e1182 > _e1195));
                                                                phi_2159_ = (select(_e1208, _e1260, (_e1260 > _e1208)) < 0f);
                                                            }
                                                            let _e1265 = phi_2159_;
                                                            if _e1265 {
                                                                phi_2857_ = type_24();
                                                                phi_2858_ = false;
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
                                                                    phi_2852_ = type_24();
                                                                    phi_2853_ = true;
                                                                } else {
                                                                    let _e1330 = (_e1328 > _e721.member);
                                                                    if _e1330 {
                                                                        phi_2851_ = type_24();
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
                                                                            phi_2578_ = _e1195;
                                                                            phi_2579_ = _e1192;
                                                                            phi_2580_ = _e1182;
                                                                            phi_2581_ = _e1179;
                                                                            phi_2582_ = _e1331;
                                                                            phi_2583_ = _e1345;
                                                                            phi_2584_ = _e1341;
                                                                            phi_2585_ = _e1337;
                                                                        } else {
                                                                            let _e1390 = (_e1371 == _e1388);
                                                                            let _e1395 = vec3(_e1390);
                                                                            phi_2578_ = select(_e1182, _e1208, _e1390);
                                                                            phi_2579_ = select(_e1179, _e1205, _e1390);
                                                                            phi_2580_ = select(_e1208, _e1195, _e1390);
                                                                            phi_2581_ = select(_e1205, _e1192, _e1390);
                                                                            phi_2582_ = select(_e1333, _e1332, _e1395);
                                                                            phi_2583_ = select(_e1341, _e1337, _e1395);
                                                                            phi_2584_ = select(_e1337, _e1345, _e1395);
                                                                            phi_2585_ = select(_e1345, _e1341, _e1395);
                                                                        }
                                                                        let _e1401 = phi_2578_;
                                                                        let _e1403 = phi_2579_;
                                                                        let _e1405 = phi_2580_;
                                                                        let _e1407 = phi_2581_;
                                                                        let _e1409 = phi_2582_;
                                                                        let _e1411 = phi_2583_;
                                                                        let _e1413 = phi_2584_;
                                                                        let _e1415 = phi_2585_;
                                                                        let _e1422 = ((_e1413.y * _e1411.z) - (_e1411.y * _e1413.z));
                                                                        let _e1427 = ((_e1413.z * _e1411.x) - (_e1411.z * _e1413.x));
                                                                        let _e1430 = ((_e1413.x * _e1411.y) - (_e1411.x * _e1413.y));
                                                                        if (_e1230 >= _e1234) {
                                                                            phi_2622_ = select(true, false, (_e1230 >= _e1238));
                                                                        } else {
                                                                            phi_2622_ = true;
                                                                        }
                                                                        let _e1435 = phi_2622_;
                                                                        if _e1435 {
                                                                            phi_2631_ = select(_e1333, _e1332, vec3((_e1234 >= _e1238)));
                                                                        } else {
                                                                            phi_2631_ = _e1331;
                                                                        }
                                                                        let _e1440 = phi_2631_;
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
                                                                                phi_2796_ = (_e1451 / _e1456);
                                                                            } else {
                                                                                phi_2796_ = f32();
                                                                            }
                                                                            let _e1561 = phi_2796_;
                                                                            phi_2798_ = _e1561;
                                                                            phi_2799_ = select(true, false, _e1558);
                                                                        } else {
                                                                            phi_2798_ = f32();
                                                                            phi_2799_ = true;
                                                                        }
                                                                        let _e1564 = phi_2798_;
                                                                        let _e1566 = phi_2799_;
                                                                        if _e1566 {
                                                                            let _e1574 = (((_e1422 * (_e1483 - (_e371 * _e1486))) + (_e1427 * (_e1484 - (_e439 * _e1486)))) / _e1456);
                                                                            if (bitcast<f32>((bitcast<u32>(_e1574) & 2147483647u)) <= _e1388) {
                                                                                phi_2819_ = (_e1486 + _e1574);
                                                                            } else {
                                                                                phi_2819_ = _e1486;
                                                                            }
                                                                            let _e1581 = phi_2819_;
                                                                            phi_2820_ = _e1581;
                                                                        } else {
                                                                            phi_2820_ = _e1564;
                                                                        }
                                                                        let _e1583 = phi_2820_;
                                                                        let _e1585 = select(_e1321, _e1583, (_e1583 < _e1321));
                                                                        let _e1587 = select(_e1313, _e1585, (_e1585 > _e1313));
                                                                        if (_e1587 >= _e622) {
                                                                            let _e1589 = (_e1587 <= _e721.member);
                                                                            if _e1589 {
                                                                                let _e1590 = (1f / _e1240);
                                                                                phi_2843_ = type_24(_e1587, (_e1234 * _e1590), (_e1238 * _e1590), _e781);
                                                                            } else {
                                                                                phi_2843_ = type_24();
                                                                            }
                                                                            let _e1595 = phi_2843_;
                                                                            phi_2845_ = _e1595;
                                                                            phi_2846_ = select(true, false, _e1589);
                                                                        } else {
                                                                            phi_2845_ = type_24();
                                                                            phi_2846_ = true;
                                                                        }
                                                                        let _e1598 = phi_2845_;
                                                                        let _e1600 = phi_2846_;
                                                                        if _e1600 {
                                                                            phi_2850_ = type_24(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                        } else {
                                                                            phi_2850_ = _e1598;
                                                                        }
                                                                        let _e1602 = phi_2850_;
                                                                        phi_2851_ = _e1602;
                                                                    }
                                                                    let _e1604 = phi_2851_;
                                                                    phi_2852_ = _e1604;
                                                                    phi_2853_ = _e1330;
                                                                }
                                                                let _e1606 = phi_2852_;
                                                                let _e1608 = phi_2853_;
                                                                phi_2857_ = _e1606;
                                                                phi_2858_ = _e1608;
                                                            }
                                                            let _e1610 = phi_2857_;
                                                            let _e1612 = phi_2858_;
                                                            phi_2859_ = _e1610;
                                                            phi_2860_ = _e1265;
                                                            phi_2861_ = _e1612;
                                                        }
                                                        let _e1614 = phi_2859_;
                                                        let _e1616 = phi_2860_;
                                                        let _e1618 = phi_2861_;
                                                        phi_2862_ = _e1614;
                                                        phi_2863_ = _e1616;
                                                        phi_2864_ = _e1618;
                                                    }
                                                    let _e1620 = phi_2862_;
                                                    let _e1622 = phi_2863_;
                                                    let _e1624 = phi_2864_;
                                                    phi_2872_ = _e1620;
                                                    phi_2873_ = select(_e1624, true, _e1622);
                                                } else {
                                                    phi_2872_ = type_24();
                                                    phi_2873_ = true;
                                                }
                                                let _e1627 = phi_2872_;
                                                let _e1629 = phi_2873_;
                                                if _e1629 {
                                                    phi_2877_ = type_24(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                } else {
                                                    phi_2877_ = _e1627;
                                                }
                                                let _e1631 = phi_2877_;
                                                if (_e1631.member_3 != 4294967295u) {
                                                    if (_e781 != 4294967295u) {
                                                        phi_2888_ = type_38(_e721.member, true);
                                                    } else {
                                                        phi_2888_ = _e721;
                                                    }
                                                    let _e1639 = phi_2888_;
                                                    phi_2889_ = _e1639;
                                                } else {
                                                    phi_2889_ = _e721;
                                                }
                                                let _e1641 = phi_2889_;
                                                phi_1215_ = _e1641;
                                            } else {
                                                phi_1215_ = type_38();
                                            }
                                            let _e1643 = phi_1215_;
                                            continue;
                                            continuing {
                                                phi_1214_ = _e1643;
                                                phi_1217_ = _e736;
                                                phi_4391_ = _e664;
                                                break if !(_e742);
                                            }
                                        }
                                        let _e1646 = phi_4391_;
                                        phi_4595_ = _e1646;
                                        if _e1646 {
                                            break;
                                        }
                                        phi_4686_ = _e1646;
                                        let _e2294 = local_11;
                                        phi_2890_ = _e2294;
                                    } else {
                                        phi_4686_ = _e664;
                                        phi_2890_ = _e666;
                                    }
                                    let _e1648 = phi_4686_;
                                    let _e1650 = phi_2890_;
                                    if _e713 {
                                        phi_4155_ = bool();
                                        phi_4156_ = u32();
                                        phi_4157_ = type_45();
                                    } else {
                                        if (_e709.member_1 >= _e96) {
                                            phi_3691_ = type_46(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), type_45(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u), type_45(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u));
                                        } else {
                                            if (_e709.member_1 < _e96) {
                                            } else {
                                                phi_4595_ = true;
                                                break;
                                            }
                                            let _e1654 = ((1u + _e267) % 4u);
                                            if (_e1654 < 4u) {
                                            } else {
                                                phi_4595_ = true;
                                                break;
                                            }
                                            let _e1659 = global_3.member[_e709.member_1][_e1654];
                                            let _e1661 = (_e1659 >> bitcast<u32>(11u));
                                            let _e1663 = ((1u + _e266) % 4u);
                                            if (_e1663 < 4u) {
                                            } else {
                                                phi_4595_ = true;
                                                break;
                                            }
                                            let _e1668 = global_3.member[_e709.member_1][_e1663];
                                            let _e1670 = (_e1668 >> bitcast<u32>(11u));
                                            let _e1672 = ((1u + _e268) % 4u);
                                            if (_e1672 < 4u) {
                                            } else {
                                                phi_4595_ = true;
                                                break;
                                            }
                                            let _e1677 = global_3.member[_e709.member_1][_e1672];
                                            let _e1679 = (_e1677 >> bitcast<u32>(11u));
                                            let _e1702 = (bitcast<f32>((bitcast<u32>((_e709.member.member_1.x - _e709.member.member.x)) & 2139095040u)) * 0.001953125f);
                                            let _e1703 = (bitcast<f32>((bitcast<u32>((_e709.member.member_1.y - _e709.member.member.y)) & 2139095040u)) * 0.001953125f);
                                            let _e1704 = (bitcast<f32>((bitcast<u32>((_e709.member.member_1.z - _e709.member.member.z)) & 2139095040u)) * 0.001953125f);
                                            let _e1706 = select(_e147, _e1702, (_e1702 > _e147));
                                            let _e1708 = select(_e147, _e1703, (_e1703 > _e147));
                                            let _e1710 = select(_e147, _e1704, (_e1704 > _e147));
                                            let _e1741 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1659 & 1023u))) - 8388608f) * _e1706));
                                            let _e1746 = (bitcast<i32>((_e1659 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e1749 = bitcast<f32>((_e1741 & bitcast<u32>(_e1746)));
                                            let _e1750 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1668 & 1023u))) - 8388608f) * _e1708));
                                            let _e1755 = (bitcast<i32>((_e1668 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e1758 = bitcast<f32>((_e1750 & bitcast<u32>(_e1755)));
                                            let _e1759 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1677 & 1023u))) - 8388608f) * _e1710));
                                            let _e1764 = (bitcast<i32>((_e1677 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e1767 = bitcast<f32>((_e1759 & bitcast<u32>(_e1764)));
                                            let _e1771 = bitcast<f32>((_e1741 & bitcast<u32>(~(_e1746))));
                                            let _e1775 = bitcast<f32>((_e1750 & bitcast<u32>(~(_e1755))));
                                            let _e1779 = bitcast<f32>((_e1759 & bitcast<u32>(~(_e1764))));
                                            let _e1780 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1661 & 1023u))) - 8388608f) * _e1706));
                                            let _e1785 = (bitcast<i32>((_e1661 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e1788 = bitcast<f32>((_e1780 & bitcast<u32>(_e1785)));
                                            let _e1789 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1670 & 1023u))) - 8388608f) * _e1708));
                                            let _e1794 = (bitcast<i32>((_e1670 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e1797 = bitcast<f32>((_e1789 & bitcast<u32>(_e1794)));
                                            let _e1798 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1679 & 1023u))) - 8388608f) * _e1710));
                                            let _e1803 = (bitcast<i32>((_e1679 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e1806 = bitcast<f32>((_e1798 & bitcast<u32>(_e1803)));
                                            let _e1810 = bitcast<f32>((_e1780 & bitcast<u32>(~(_e1785))));
                                            let _e1814 = bitcast<f32>((_e1789 & bitcast<u32>(~(_e1794))));
                                            let _e1818 = bitcast<f32>((_e1798 & bitcast<u32>(~(_e1803))));
                                            let _e1819 = (_e709.member.member.x + _e1749);
                                            let _e1820 = (_e709.member.member.y + _e1758);
                                            let _e1821 = (_e709.member.member.z + _e1767);
                                            let _e1824 = (_e709.member.member_1.x - _e1788);
                                            let _e1825 = (_e709.member.member_1.y - _e1797);
                                            let _e1826 = (_e709.member.member_1.z - _e1806);
                                            let _e1845 = (_e1824 - _e1819);
                                            let _e1846 = (_e1825 - _e1820);
                                            let _e1847 = (_e1826 - _e1821);
                                            let _e1849 = select(_e1846, _e1845, (_e1845 > _e1846));
                                            let _e1851 = select(_e1847, _e1849, (_e1849 > _e1847));
                                            if (_e1851 < (1024f * _e147)) {
                                                phi_3392_ = 0u;
                                            } else {
                                                phi_3392_ = select(2u, 1u, (_e1851 < (2097152f * _e147)));
                                            }
                                            let _e1858 = phi_3392_;
                                            switch bitcast<i32>(_e1858) {
                                                case 0: {
                                                    phi_3398_ = 1u;
                                                    break;
                                                }
                                                case 1: {
                                                    phi_3398_ = 2u;
                                                    break;
                                                }
                                                case 2: {
                                                    phi_3398_ = 3u;
                                                    break;
                                                }
                                                default: {
                                                    phi_3398_ = u32();
                                                    break;
                                                }
                                            }
                                            let _e1861 = phi_3398_;
                                            let _e1867 = global_3.member[_e709.member_1][0u];
                                            let _e1871 = global_3.member[_e709.member_1][1u];
                                            let _e1875 = global_3.member[_e709.member_1][2u];
                                            let _e1879 = global_3.member[_e709.member_1][3u];
                                            let _e1891 = (((_e1871 >> bitcast<u32>(22i)) | ((_e1875 >> bitcast<u32>(22i)) << bitcast<u32>(10i))) | ((_e1879 >> bitcast<u32>(22i)) << bitcast<u32>(20i)));
                                            let _e1892 = (_e1867 & 268435455u);
                                            let _e1893 = (_e1891 & 268435455u);
                                            let _e1896 = ((_e1867 >> bitcast<u32>(28u)) & 7u);
                                            let _e1904 = ((_e1867 >> bitcast<u32>(31i)) | (((_e1891 >> bitcast<u32>(28u)) & 3u) << bitcast<u32>(1i)));
                                            let _e1905 = (_e1896 != 0u);
                                            if (_e1896 == 0u) {
                                                phi_3653_ = _e1892;
                                            } else {
                                                if (_e1896 == 7u) {
                                                    phi_3652_ = 2147483648u;
                                                } else {
                                                    phi_3652_ = ((2147483648u | (_e1896 << bitcast<u32>(28u))) | (_e1893 & 268435455u));
                                                }
                                                let _e1914 = phi_3652_;
                                                phi_3653_ = _e1914;
                                            }
                                            let _e1916 = phi_3653_;
                                            if _e1905 {
                                                let _e1917 = (_e1896 != 7u);
                                                if _e1917 {
                                                    phi_3663_ = (_e1893 + (_e1896 * ((3u * _e1861) + 1u)));
                                                } else {
                                                    phi_3663_ = u32();
                                                }
                                                let _e1921 = phi_3663_;
                                                phi_3665_ = _e1921;
                                                phi_3666_ = select(true, false, _e1917);
                                            } else {
                                                phi_3665_ = u32();
                                                phi_3666_ = true;
                                            }
                                            let _e1924 = phi_3665_;
                                            let _e1926 = phi_3666_;
                                            if (_e1904 == 0u) {
                                                phi_3687_ = (_e1892 + select(0u, 1u, !(_e1905)));
                                            } else {
                                                if (_e1904 == 7u) {
                                                    phi_3686_ = 2147483648u;
                                                } else {
                                                    phi_3686_ = ((2147483648u | (_e1904 << bitcast<u32>(28u))) | (select(_e1924, _e1893, _e1926) & 268435455u));
                                                }
                                                let _e1939 = phi_3686_;
                                                phi_3687_ = _e1939;
                                            }
                                            let _e1941 = phi_3687_;
                                            phi_3691_ = type_46(array<vec4<f32>, 3>(vec4<f32>(_e1819, (_e709.member.member.x + _e1771), _e1824, (_e709.member.member_1.x - _e1810)), vec4<f32>(_e1820, (_e709.member.member.y + _e1775), _e1825, (_e709.member.member_1.y - _e1814)), vec4<f32>(_e1821, (_e709.member.member.z + _e1779), _e1826, (_e709.member.member_1.z - _e1818))), type_45(type_28((_e709.member.member + vec4<f32>(_e1749, _e1758, _e1767, 0f)), (_e709.member.member_1 - vec4<f32>(_e1788, _e1797, _e1806, 0f))), _e1916), type_45(type_28((_e709.member.member + vec4<f32>(_e1771, _e1775, _e1779, 0f)), (_e709.member.member_1 - vec4<f32>(_e1810, _e1814, _e1818, 0f))), _e1941));
                                        }
                                        let _e1946 = phi_3691_;
                                        let _e1958 = ((_e1946.member[0].x - _e369) * _e374);
                                        let _e1959 = ((_e1946.member[0].y - _e369) * _e374);
                                        let _e1960 = ((_e1946.member[0].z - _e370) * _e374);
                                        let _e1961 = ((_e1946.member[0].w - _e370) * _e374);
                                        let _e1971 = ((_e1946.member[1].x - _e437) * _e442);
                                        let _e1972 = ((_e1946.member[1].y - _e437) * _e442);
                                        let _e1973 = ((_e1946.member[1].z - _e438) * _e442);
                                        let _e1974 = ((_e1946.member[1].w - _e438) * _e442);
                                        let _e1984 = ((_e1946.member[2].x - _e505) * _e510);
                                        let _e1985 = ((_e1946.member[2].y - _e505) * _e510);
                                        let _e1986 = ((_e1946.member[2].z - _e506) * _e510);
                                        let _e1987 = ((_e1946.member[2].w - _e506) * _e510);
                                        let _e1989 = select(_e1986, _e1984, (_e1984 < _e1986));
                                        let _e1991 = select(_e1987, _e1985, (_e1985 < _e1987));
                                        let _e1993 = select(_e1986, _e1984, (_e1984 > _e1986));
                                        let _e1995 = select(_e1987, _e1985, (_e1985 > _e1987));
                                        let _e1997 = select(_e1960, _e1958, (_e1958 < _e1960));
                                        let _e1999 = select(_e1961, _e1959, (_e1959 < _e1961));
                                        let _e2001 = select(_e1973, _e1971, (_e1971 < _e1973));
                                        let _e2003 = select(_e1974, _e1972, (_e1972 < _e1974));
                                        let _e2005 = select(_e2001, _e1997, (_e1997 > _e2001));
                                        let _e2007 = select(_e2003, _e1999, (_e1999 > _e2003));
                                        let _e2009 = select(_e1989, _e2005, (_e2005 > _e1989));
                                        let _e2011 = select(_e1991, _e2007, (_e2007 > _e1991));
                                        let _e2013 = select(_e1960, _e1958, (_e1958 > _e1960));
                                        let _e2015 = select(_e1961, _e1959, (_e1959 > _e1961));
                                        let _e2017 = select(_e1973, _e1971, (_e1971 > _e1973));
                                        let _e2019 = select(_e1974, _e1972, (_e1972 > _e1974));
                                        let _e2021 = select(_e2017, _e2013, (_e2013 < _e2017));
                                        let _e2023 = select(_e2019, _e2015, (_e2015 < _e2019));
                                        let _e2028 = -(_e1989);
                                        let _e2029 = -(_e1991);
                                        let _e2036 = (select(_e1993, _e2021, (_e2021 < _e1993)) + (select(_e2028, _e1993, (_e1993 > _e2028)) * 0.0000019073523f));
                                        let _e2037 = (select(_e1995, _e2023, (_e2023 < _e1995)) + (select(_e2029, _e1995, (_e1995 > _e2029)) * 0.0000019073523f));
                                        let _e2039 = select(_e622, _e2009, (_e2009 > _e622));
                                        let _e2041 = select(_e622, _e2011, (_e2011 > _e622));
                                        let _e2046 = (_e2039 <= select(_e1650.member, _e2036, (_e2036 < _e1650.member)));
                                        let _e2047 = (_e2041 <= select(_e1650.member, _e2037, (_e2037 < _e1650.member)));
                                        let _e2048 = (_e2039 <= _e2041);
                                        if _e2046 {
                                            if _e2047 {
                                                if _e2048 {
                                                    phi_4053_ = _e1946.member_2;
                                                } else {
                                                    phi_4053_ = _e1946.member_1;
                                                }
                                                let _e2052 = phi_4053_;
                                                let _e2073 = (_e707 % 128u);
                                                let _e2074 = (_e2073 < 128u);
                                                if _e2074 {
                                                } else {
                                                    phi_4595_ = true;
                                                    break;
                                                }
                                                local_8[_e2073] = _e2052.member_1;
                                                if _e2074 {
                                                } else {
                                                    phi_4595_ = true;
                                                    break;
                                                }
                                                local_7[_e2073] = _e2052.member.member.x;
                                                if _e2074 {
                                                } else {
                                                    phi_4595_ = true;
                                                    break;
                                                }
                                                local_6[_e2073] = _e2052.member.member.y;
                                                if _e2074 {
                                                } else {
                                                    phi_4595_ = true;
                                                    break;
                                                }
                                                local_5[_e2073] = _e2052.member.member.z;
                                                if _e2074 {
                                                } else {
                                                    phi_4595_ = true;
                                                    break;
                                                }
                                                local_4[_e2073] = _e2052.member.member_1.x;
                                                if _e2074 {
                                                } else {
                                                    phi_4595_ = true;
                                                    break;
                                                }
                                                local_3[_e2073] = _e2052.member.member_1.y;
                                                if _e2074 {
                                                } else {
                                                    phi_4595_ = true;
                                                    break;
                                                }
                                                local_2[_e2073] = _e2052.member.member_1.z;
                                                if _e2074 {
                                                } else {
                                                    phi_4595_ = true;
                                                    break;
                                                }
                                                local_9[_e2073] = select(_e2039, _e2041, _e2048);
                                                if _e2048 {
                                                    phi_4129_ = _e1946.member_1;
                                                } else {
                                                    phi_4129_ = _e1946.member_2;
                                                }
                                                let _e2087 = phi_4129_;
                                                phi_4130_ = (_e707 + 1u);
                                                phi_4131_ = _e2087;
                                            } else {
                                                phi_4130_ = u32();
                                                phi_4131_ = type_45();
                                            }
                                            let _e2089 = phi_4130_;
                                            let _e2091 = phi_4131_;
                                            phi_4133_ = _e2089;
                                            phi_4134_ = _e2091;
                                            phi_4135_ = select(true, false, _e2047);
                                        } else {
                                            phi_4133_ = u32();
                                            phi_4134_ = type_45();
                                            phi_4135_ = true;
                                        }
                                        let _e2094 = phi_4133_;
                                        let _e2096 = phi_4134_;
                                        let _e2098 = phi_4135_;
                                        if _e2098 {
                                            if _e2046 {
                                                phi_4144_ = _e1946.member_1;
                                            } else {
                                                phi_4144_ = _e1946.member_2;
                                            }
                                            let _e2102 = phi_4144_;
                                            phi_4149_ = select(_e2047, true, _e2046);
                                            phi_4151_ = _e2102;
                                        } else {
                                            phi_4149_ = _e705;
                                            phi_4151_ = _e2096;
                                        }
                                        let _e2105 = phi_4149_;
                                        let _e2107 = phi_4151_;
                                        phi_4155_ = _e2105;
                                        phi_4156_ = select(_e2094, _e707, _e2098);
                                        phi_4157_ = _e2107;
                                    }
                                    let _e2110 = phi_4155_;
                                    let _e2112 = phi_4156_;
                                    let _e2114 = phi_4157_;
                                    if _e713 {
                                        phi_4167_ = select(_e707, 0u, _e1650.member_1);
                                        phi_4168_ = _e709;
                                    } else {
                                        phi_4167_ = _e2112;
                                        phi_4168_ = _e2114;
                                    }
                                    let _e2118 = phi_4167_;
                                    let _e2120 = phi_4168_;
                                    phi_4598_ = _e1648;
                                    phi_4169_ = _e1650;
                                    phi_4170_ = (_e668 - 1u);
                                    phi_4171_ = select(_e2110, false, _e713);
                                    phi_4172_ = _e2118;
                                    phi_4173_ = _e2120;
                                } else {
                                    phi_4598_ = _e664;
                                    phi_4169_ = _e666;
                                    phi_4170_ = _e668;
                                    phi_4171_ = _e705;
                                    phi_4172_ = _e707;
                                    phi_4173_ = _e709;
                                }
                                let _e2123 = phi_4598_;
                                let _e2125 = phi_4169_;
                                let _e2127 = phi_4170_;
                                let _e2129 = phi_4171_;
                                let _e2131 = phi_4172_;
                                let _e2133 = phi_4173_;
                                phi_4597_ = _e2123;
                                phi_4174_ = _e2125;
                                phi_4175_ = _e2127;
                                phi_4176_ = _e2129;
                                phi_4177_ = _e2131;
                                phi_4178_ = _e2133;
                            } else {
                                phi_4597_ = _e664;
                                phi_4174_ = type_38();
                                phi_4175_ = u32();
                                phi_4176_ = bool();
                                phi_4177_ = u32();
                                phi_4178_ = type_45();
                            }
                            let _e2135 = phi_4597_;
                            let _e2137 = phi_4174_;
                            let _e2139 = phi_4175_;
                            let _e2141 = phi_4176_;
                            let _e2143 = phi_4177_;
                            let _e2145 = phi_4178_;
                            phi_4596_ = _e2135;
                            phi_1088_ = _e2137;
                            phi_1091_ = _e2139;
                            phi_1093_ = _e2141;
                            phi_1095_ = _e2143;
                            phi_1097_ = _e2145;
                            phi_4179_ = _e678;
                        } else {
                            phi_4596_ = _e664;
                            phi_1088_ = type_38();
                            phi_1091_ = u32();
                            phi_1093_ = bool();
                            phi_1095_ = u32();
                            phi_1097_ = type_45();
                            phi_4179_ = false;
                        }
                        let _e2147 = phi_4596_;
                        let _e2149 = phi_1088_;
                        let _e2151 = phi_1091_;
                        let _e2153 = phi_1093_;
                        let _e2155 = phi_1095_;
                        let _e2157 = phi_1097_;
                        let _e2159 = phi_4179_;
                        continue;
                        continuing {
                            phi_4397_ = _e2147;
                            phi_1087_ = _e2149;
                            phi_1090_ = _e2151;
                            phi_1092_ = _e2153;
                            phi_1094_ = _e2155;
                            phi_1096_ = _e2157;
                            phi_4595_ = _e2147;
                            break if !(_e2159);
                        }
                    }
                    let _e2162 = phi_4595_;
                    if _e2162 {
                        break;
                    }
                    let _e2164 = local_10;
                    if _e155 {
                    } else {
                        break;
                    }
                    global_5.member[_e153] = select(0u, 1u, _e2164.member_1);
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
