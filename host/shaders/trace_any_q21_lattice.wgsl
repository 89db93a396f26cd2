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

struct type_34 {
    member: f32,
    member_1: bool,
}

struct type_36 {
    member: array<vec4<u32>, 2>,
}

struct type_40 {
    member: array<array<u32, 7>>,
}

struct type_45 {
    member: type_24,
    member_1: u32,
}

struct type_46 {
    member: array<vec4<f32>, 3>,
    member_1: type_45,
    member_2: type_45,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_1: type_12;
@group(0) @binding(1) 
var<uniform> global_2: type_36;
@group(0) @binding(4) 
var<storage> global_3: type_32;
@group(0) @binding(5) 
var<storage, read_write> global_4: type_4;
@group(0) @binding(2) 
var<storage> global_5: type_40;
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
    var phi_1087_: type_34;
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
    var phi_1214_: type_34;
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
    var phi_2843_: type_20;
    var phi_2845_: type_20;
    var phi_2846_: bool;
    var phi_2850_: type_20;
    var phi_2851_: type_20;
    var phi_2852_: type_20;
    var phi_2853_: bool;
    var phi_2857_: type_20;
    var phi_2858_: bool;
    var phi_2859_: type_20;
    var phi_2860_: bool;
    var phi_2861_: bool;
    var phi_2862_: type_20;
    var phi_2863_: bool;
    var phi_2864_: bool;
    var phi_2872_: type_20;
    var phi_2873_: bool;
    var phi_2877_: type_20;
    var phi_2888_: type_34;
    var phi_2889_: type_34;
    var phi_1215_: type_34;
    var phi_4388_: bool;
    var local_10: type_34;
    var phi_4596_: bool;
    var phi_4162_: type_34;
    var phi_4163_: bool;
    var phi_4164_: u32;
    var phi_4165_: type_45;
    var phi_4595_: bool;
    var phi_4166_: type_34;
    var phi_4167_: bool;
    var phi_4168_: u32;
    var phi_4169_: u32;
    var phi_4170_: type_45;
    var phi_4594_: bool;
    var phi_4171_: type_34;
    var phi_4172_: bool;
    var phi_4173_: u32;
    var phi_4174_: u32;
    var phi_4175_: type_45;
    var phi_4593_: bool;
    var phi_1088_: type_34;
    var phi_1091_: bool;
    var phi_1093_: u32;
    var phi_1095_: u32;
    var phi_1097_: type_45;
    var phi_4176_: bool;
    var phi_4592_: bool;
    var local_11: type_34;
    var local_12: type_34;

    switch bitcast<i32>(0u) {
        default: {
            let _e91 = global;
            let _e93 = arrayLength((&global_5.member));
            let _e96 = arrayLength((&global_6.member));
            let _e104 = global_2.member[0u][0u];
            let _e108 = global_2.member[0u][1u];
            let _e112 = global_2.member[0u][2u];
            let _e116 = global_2.member[0u][3u];
            let _e120 = global_2.member[1u][0u];
            let _e124 = global_2.member[1u][1u];
            let _e128 = global_2.member[1u][2u];
            let _e131 = global_1.member[0u];
            let _e132 = bitcast<i32>(_e131);
            let _e144 = bitcast<f32>((bitcast<u32>((bitcast<i32>(_e116) + 127i)) << bitcast<u32>(23i)));
            local_1 = array<i32, 3>(bitcast<i32>(_e104), bitcast<i32>(_e108), bitcast<i32>(_e112));
            local = array<i32, 3>(bitcast<i32>(_e120), bitcast<i32>(_e124), bitcast<i32>(_e128));
            let _e150 = (_e91.x + (_e91.y * 2097152u));
            let _e151 = (_e150 < arrayLength((&global_3.member)));
            if _e151 {
                let _e152 = (_e150 < arrayLength((&global_4.member)));
                if _e152 {
                    if _e151 {
                    } else {
                        break;
                    }
                    let _e160 = global_3.member[_e150].member_2[0u];
                    let _e162 = (bitcast<u32>(_e160) & 2147483647u);
                    let _e167 = global_3.member[_e150].member_2[1u];
                    let _e169 = (bitcast<u32>(_e167) & 2147483647u);
                    let _e174 = global_3.member[_e150].member_2[2u];
                    let _e176 = (bitcast<u32>(_e174) & 2147483647u);
                    let _e181 = global_3.member[_e150].member[0u];
                    let _e183 = (bitcast<u32>(_e181) & 2147483647u);
                    let _e188 = global_3.member[_e150].member[1u];
                    let _e190 = (bitcast<u32>(_e188) & 2147483647u);
                    let _e195 = global_3.member[_e150].member[2u];
                    let _e197 = (bitcast<u32>(_e195) & 2147483647u);
                    let _e199 = select(_e169, _e162, (_e169 < _e162));
                    let _e201 = select(_e176, _e199, (_e176 < _e199));
                    let _e203 = select(_e183, _e201, (_e183 < _e201));
                    let _e205 = select(_e190, _e203, (_e190 < _e203));
                    let _e207 = select(_e197, _e205, (_e197 < _e205));
                    let _e211 = global_3.member[_e150].member_1;
                    let _e212 = bitcast<u32>(_e211);
                    let _e213 = (_e212 & 2147483647u);
                    let _e220 = global_3.member[_e150].member_3;
                    let _e221 = bitcast<u32>(_e220);
                    let _e222 = (_e221 & 2147483647u);
                    let _e226 = (((select(_e213, _e207, (_e213 < _e207)) < 2139095040u) && (_e222 <= 2139095040u)) && (_e201 > 0u));
                    if _e226 {
                        let _e229 = (bitcast<u32>(bitcast<f32>(_e201)) & 2147483647u);
                        if (_e229 >= 8388608u) {
                            phi_398_ = (bitcast<i32>((_e229 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_398_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e229)), 32u, (_e229 == 0u))));
                        }
                        let _e243 = phi_398_;
                        phi_399_ = _e243;
                    } else {
                        phi_399_ = 0i;
                    }
                    let _e245 = phi_399_;
                    let _e246 = (_e162 == _e201);
                    if _e246 {
                        phi_409_ = true;
                    } else {
                        phi_409_ = (_e169 == _e201);
                    }
                    let _e249 = phi_409_;
                    let _e250 = select(1u, 0u, _e246);
                    if _e249 {
                        let _e251 = (_e250 + 1u);
                        phi_419_ = _e251;
                        phi_420_ = _e251;
                        phi_422_ = select(true, false, (_e251 == 2u));
                    } else {
                        phi_419_ = u32();
                        phi_420_ = 0u;
                        phi_422_ = true;
                    }
                    let _e255 = phi_419_;
                    let _e257 = phi_420_;
                    let _e259 = phi_422_;
                    if _e259 {
                        phi_427_ = (_e257 + 1u);
                    } else {
                        phi_427_ = 0u;
                    }
                    let _e263 = phi_427_;
                    let _e264 = select(_e255, _e257, _e259);
                    let _e265 = select(_e250, select(2u, _e250, _e249), _e259);
                    if (_e132 < -126i) {
                        phi_440_ = -126i;
                    } else {
                        phi_440_ = select(_e132, 127i, (_e132 > 127i));
                    }
                    let _e270 = phi_440_;
                    let _e275 = bitcast<f32>((bitcast<u32>((_e270 + 127i)) << bitcast<u32>(23i)));
                    let _e281 = bitcast<f32>((bitcast<u32>(((_e132 - _e270) + 127i)) << bitcast<u32>(23i)));
                    let _e282 = -(_e245);
                    if (_e282 < -126i) {
                        phi_460_ = -126i;
                    } else {
                        phi_460_ = select(_e282, 127i, (_e282 > 127i));
                    }
                    let _e287 = phi_460_;
                    let _e292 = bitcast<f32>((bitcast<u32>((_e287 + 127i)) << bitcast<u32>(23i)));
                    let _e298 = bitcast<f32>((bitcast<u32>(((_e282 - _e287) + 127i)) << bitcast<u32>(23i)));
                    let _e302 = global_3.member[_e150].member;
                    let _e303 = (_e264 == 0u);
                    if _e303 {
                        phi_478_ = _e302[0];
                    } else {
                        phi_478_ = _e302[1];
                    }
                    let _e307 = phi_478_;
                    let _e308 = (_e264 == 2u);
                    if _e308 {
                        phi_484_ = _e302[2];
                    } else {
                        phi_484_ = _e307;
                    }
                    let _e311 = phi_484_;
                    let _e312 = bitcast<u32>(_e311);
                    let _e314 = ((_e312 & 2139095040u) != 0u);
                    let _e328 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e312 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e312 & 2147483648u))), _e311, _e314) * _e275) * select(0.00000011920929f, 1f, _e314)) * _e281);
                    let _e329 = global_3.member[_e150].member_2;
                    if _e303 {
                        phi_524_ = _e329[0];
                    } else {
                        phi_524_ = _e329[1];
                    }
                    let _e333 = phi_524_;
                    if _e308 {
                        phi_530_ = _e329[2];
                    } else {
                        phi_530_ = _e333;
                    }
                    let _e336 = phi_530_;
                    let _e337 = bitcast<u32>(_e336);
                    let _e339 = ((_e337 & 2139095040u) != 0u);
                    let _e353 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e337 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e337 & 2147483648u))), _e336, _e339) * _e292) * select(0.00000011920929f, 1f, _e339)) * _e298);
                    let _e357 = (bitcast<f32>((bitcast<u32>(_e353) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e357 {
                        let _e361 = (bitcast<f32>((bitcast<u32>(_e328) & 2147483647u)) * 0.00000011920929f);
                        phi_582_ = select(0.00000000000011368684f, _e361, (_e361 > 0.00000000000011368684f));
                    } else {
                        phi_582_ = 0f;
                    }
                    let _e365 = phi_582_;
                    let _e366 = (_e328 + _e365);
                    let _e367 = (_e328 - _e365);
                    let _e368 = select(_e353, 0f, _e357);
                    if _e357 {
                        phi_594_ = 38685626000000000000000000f;
                    } else {
                        phi_594_ = (1f / _e353);
                    }
                    let _e371 = phi_594_;
                    let _e372 = (_e263 == 0u);
                    if _e372 {
                        phi_603_ = _e302[0];
                    } else {
                        phi_603_ = _e302[1];
                    }
                    let _e376 = phi_603_;
                    let _e377 = (_e263 == 2u);
                    if _e377 {
                        phi_609_ = _e302[2];
                    } else {
                        phi_609_ = _e376;
                    }
                    let _e380 = phi_609_;
                    let _e381 = bitcast<u32>(_e380);
                    let _e383 = ((_e381 & 2139095040u) != 0u);
                    let _e397 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e381 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e381 & 2147483648u))), _e380, _e383) * _e275) * select(0.00000011920929f, 1f, _e383)) * _e281);
                    if _e372 {
                        phi_649_ = _e329[0];
                    } else {
                        phi_649_ = _e329[1];
                    }
                    let _e401 = phi_649_;
                    if _e377 {
                        phi_655_ = _e329[2];
                    } else {
                        phi_655_ = _e401;
                    }
                    let _e404 = phi_655_;
                    let _e405 = bitcast<u32>(_e404);
                    let _e407 = ((_e405 & 2139095040u) != 0u);
                    let _e421 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e405 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e405 & 2147483648u))), _e404, _e407) * _e292) * select(0.00000011920929f, 1f, _e407)) * _e298);
                    let _e425 = (bitcast<f32>((bitcast<u32>(_e421) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e425 {
                        let _e429 = (bitcast<f32>((bitcast<u32>(_e397) & 2147483647u)) * 0.00000011920929f);
                        phi_707_ = select(0.00000000000011368684f, _e429, (_e429 > 0.00000000000011368684f));
                    } else {
                        phi_707_ = 0f;
                    }
                    let _e433 = phi_707_;
                    let _e434 = (_e397 + _e433);
                    let _e435 = (_e397 - _e433);
                    let _e436 = select(_e421, 0f, _e425);
                    if _e425 {
                        phi_719_ = 38685626000000000000000000f;
                    } else {
                        phi_719_ = (1f / _e421);
                    }
                    let _e439 = phi_719_;
                    let _e440 = (_e265 == 0u);
                    if _e440 {
                        phi_728_ = _e302[0];
                    } else {
                        phi_728_ = _e302[1];
                    }
                    let _e444 = phi_728_;
                    let _e445 = (_e265 == 2u);
                    if _e445 {
                        phi_734_ = _e302[2];
                    } else {
                        phi_734_ = _e444;
                    }
                    let _e448 = phi_734_;
                    let _e449 = bitcast<u32>(_e448);
                    let _e451 = ((_e449 & 2139095040u) != 0u);
                    let _e465 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e449 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e449 & 2147483648u))), _e448, _e451) * _e275) * select(0.00000011920929f, 1f, _e451)) * _e281);
                    if _e440 {
                        phi_774_ = _e329[0];
                    } else {
                        phi_774_ = _e329[1];
                    }
                    let _e469 = phi_774_;
                    if _e445 {
                        phi_780_ = _e329[2];
                    } else {
                        phi_780_ = _e469;
                    }
                    let _e472 = phi_780_;
                    let _e473 = bitcast<u32>(_e472);
                    let _e475 = ((_e473 & 2139095040u) != 0u);
                    let _e489 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e473 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e473 & 2147483648u))), _e472, _e475) * _e292) * select(0.00000011920929f, 1f, _e475)) * _e298);
                    let _e493 = (bitcast<f32>((bitcast<u32>(_e489) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e493 {
                        let _e497 = (bitcast<f32>((bitcast<u32>(_e465) & 2147483647u)) * 0.00000011920929f);
                        phi_832_ = select(0.00000000000011368684f, _e497, (_e497 > 0.00000000000011368684f));
                    } else {
                        phi_832_ = 0f;
                    }
                    let _e501 = phi_832_;
                    let _e502 = (_e465 + _e501);
                    let _e503 = (_e465 - _e501);
                    let _e504 = select(_e489, 0f, _e493);
                    if _e493 {
                        phi_844_ = 38685626000000000000000000f;
                    } else {
                        phi_844_ = (1f / _e489);
                    }
                    let _e507 = phi_844_;
                    let _e510 = bitcast<f32>((bitcast<u32>(_e328) & 2147483647u));
                    let _e513 = bitcast<f32>((bitcast<u32>(_e397) & 2147483647u));
                    let _e515 = select(_e513, _e510, (_e510 > _e513));
                    let _e518 = bitcast<f32>((bitcast<u32>(_e465) & 2147483647u));
                    let _e521 = (_e132 + _e245);
                    if (_e226 && (select(_e518, _e515, (_e515 > _e518)) <= 1099511600000f)) {
                        let _e531 = ((_e213 & 8388607u) | (select(0u, 1u, ((_e213 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                        let _e534 = bitcast<i32>((_e213 >> bitcast<u32>(23i)));
                        let _e538 = (_e531 == 0u);
                        let _e541 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e531)), 32u, _e538)) - 8i);
                        if (_e534 == 255i) {
                            phi_899_ = 255i;
                        } else {
                            phi_899_ = (((_e534 + select(0i, 1i, (_e534 == 0i))) - _e541) + _e521);
                        }
                        let _e549 = phi_899_;
                        let _e559 = (_e549 <= 0i);
                        if _e559 {
                            phi_922_ = u32();
                        } else {
                            if _e538 {
                                phi_921_ = u32();
                            } else {
                                phi_921_ = select(((bitcast<u32>(_e549) << bitcast<u32>(23i)) | ((_e531 << bitcast<u32>(((_e541 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e549 >= 255i));
                            }
                            let _e563 = phi_921_;
                            phi_922_ = _e563;
                        }
                        let _e565 = phi_922_;
                        let _e577 = ((_e222 & 8388607u) | (select(0u, 1u, ((_e222 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                        let _e580 = bitcast<i32>((_e222 >> bitcast<u32>(23i)));
                        let _e584 = (_e577 == 0u);
                        let _e587 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e577)), 32u, _e584)) - 8i);
                        if (_e580 == 255i) {
                            phi_959_ = 255i;
                        } else {
                            phi_959_ = (((_e580 + select(0i, 1i, (_e580 == 0i))) - _e587) + _e521);
                        }
                        let _e595 = phi_959_;
                        let _e605 = (_e595 <= 0i);
                        if _e605 {
                            phi_982_ = u32();
                        } else {
                            if _e584 {
                                phi_981_ = u32();
                            } else {
                                phi_981_ = select(((bitcast<u32>(_e595) << bitcast<u32>(23i)) | ((_e577 << bitcast<u32>(((_e587 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e595 >= 255i));
                            }
                            let _e609 = phi_981_;
                            phi_982_ = _e609;
                        }
                        let _e611 = phi_982_;
                        phi_990_ = bitcast<f32>(((_e221 & 2147483648u) | select(_e611, 0u, select(_e584, true, _e605))));
                        phi_991_ = bitcast<f32>(((_e212 & 2147483648u) | select(_e565, 0u, select(_e538, true, _e559))));
                    } else {
                        phi_990_ = 0f;
                        phi_991_ = 1f;
                    }
                    let _e617 = phi_990_;
                    let _e619 = phi_991_;
                    local_8 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                    local_7 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_6 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_5 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_4 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_3 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_9 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    let _e623 = (_e264 % 3u);
                    let _e624 = (_e623 < 3u);
                    if _e624 {
                    } else {
                        break;
                    }
                    let _e626 = local_1[_e623];
                    let _e629 = (_e263 % 3u);
                    let _e630 = (_e629 < 3u);
                    if _e630 {
                    } else {
                        break;
                    }
                    let _e632 = local_1[_e629];
                    let _e635 = (_e265 % 3u);
                    let _e636 = (_e635 < 3u);
                    if _e636 {
                    } else {
                        break;
                    }
                    let _e638 = local_1[_e635];
                    if _e624 {
                    } else {
                        break;
                    }
                    let _e643 = local[_e623];
                    if _e630 {
                    } else {
                        break;
                    }
                    let _e647 = local[_e629];
                    if _e636 {
                    } else {
                        break;
                    }
                    let _e651 = local[_e635];
                    phi_4394_ = false;
                    phi_1087_ = type_34(_e617, false);
                    phi_1090_ = (_e619 <= _e617);
                    phi_1092_ = ((3u * _e93) + 1u);
                    phi_1094_ = 0u;
                    phi_1096_ = type_45(type_24(vec4<f32>((f32(_e626) * _e144), (f32(_e632) * _e144), (f32(_e638) * _e144), 0f), vec4<f32>((f32(_e643) * _e144), (f32(_e647) * _e144), (f32(_e651) * _e144), 0f)), select(0u, 2147483648u, (_e93 == 0u)));
                    loop {
                        let _e661 = phi_4394_;
                        let _e663 = phi_1087_;
                        let _e665 = phi_1090_;
                        let _e667 = phi_1092_;
                        let _e669 = phi_1094_;
                        let _e671 = phi_1096_;
                        local_11 = _e663;
                        if _e665 {
                            phi_1107_ = true;
                        } else {
                            phi_1107_ = (_e669 > 0u);
                        }
                        let _e674 = phi_1107_;
                        if _e674 {
                            let _e675 = (_e667 > 0u);
                            if _e675 {
                                if _e665 {
                                    phi_1193_ = _e665;
                                    phi_1194_ = _e669;
                                    phi_1195_ = _e671;
                                } else {
                                    let _e676 = (_e669 - 1u);
                                    let _e677 = (_e676 % 128u);
                                    let _e678 = (_e677 < 128u);
                                    if _e678 {
                                    } else {
                                        phi_4592_ = true;
                                        break;
                                    }
                                    let _e680 = local_7[_e677];
                                    if _e678 {
                                    } else {
                                        phi_4592_ = true;
                                        break;
                                    }
                                    let _e682 = local_6[_e677];
                                    if _e678 {
                                    } else {
                                        phi_4592_ = true;
                                        break;
                                    }
                                    let _e684 = local_5[_e677];
                                    if _e678 {
                                    } else {
                                        phi_4592_ = true;
                                        break;
                                    }
                                    let _e686 = local_4[_e677];
                                    if _e678 {
                                    } else {
                                        phi_4592_ = true;
                                        break;
                                    }
                                    let _e688 = local_3[_e677];
                                    if _e678 {
                                    } else {
                                        phi_4592_ = true;
                                        break;
                                    }
                                    let _e690 = local_2[_e677];
                                    if _e678 {
                                    } else {
                                        phi_4592_ = true;
                                        break;
                                    }
                                    let _e695 = local_8[_e677];
                                    if _e678 {
                                    } else {
                                        phi_4592_ = true;
                                        break;
                                    }
                                    let _e698 = local_9[_e677];
                                    phi_1193_ = (_e698 <= _e663.member);
                                    phi_1194_ = _e676;
                                    phi_1195_ = type_45(type_24(vec4<f32>(_e680, _e682, _e684, 0f), vec4<f32>(_e686, _e688, _e690, 0f)), _e695);
                                }
                                let _e702 = phi_1193_;
                                let _e704 = phi_1194_;
                                let _e706 = phi_1195_;
                                if _e702 {
                                    let _e711 = (_e706.member_1 & 268435455u);
                                    if ((_e706.member_1 & 2147483648u) != 0u) {
                                        phi_1214_ = _e663;
                                        phi_1217_ = type_8(0u, ((_e706.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e1195 = phi_1214_;
                                            let _e1197 = phi_1217_;
                                            local_10 = _e1195;
                                            local_12 = _e1195;
                                            if (_e1197.member < _e1197.member_1) {
                                                phi_1218_ = type_8((_e1197.member + 1u), _e1197.member_1);
                                                phi_1240_ = type_8(1u, _e1197.member);
                                            } else {
                                                phi_1218_ = _e1197;
                                                phi_1240_ = type_8(0u, type_8().member_1);
                                            }
                                            let _e1210 = phi_1218_;
                                            let _e1212 = phi_1240_;
                                            let _e1216 = (bitcast<i32>(_e1212.member) != 0i);
                                            if _e1216 {
                                                let _e1221 = (_e706.member.member_1.x - _e706.member.member.x);
                                                let _e1224 = (_e706.member.member_1.y - _e706.member.member.y);
                                                let _e1227 = (_e706.member.member_1.z - _e706.member.member.z);
                                                let _e1229 = select(_e1224, _e1221, (_e1221 > _e1224));
                                                let _e1231 = select(_e1227, _e1229, (_e1229 > _e1227));
                                                let _e1233 = (_e1231 < (1024f * _e144));
                                                if _e1233 {
                                                    phi_1281_ = 0u;
                                                } else {
                                                    phi_1281_ = select(2u, 1u, (_e1231 < (2097152f * _e144)));
                                                }
                                                let _e1238 = phi_1281_;
                                                switch bitcast<i32>(_e1238) {
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
                                                let _e1241 = phi_1287_;
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
                                                let _e1248 = phi_1297_;
                                                let _e1250 = ((_e711 + (_e1212.member_1 * ((3u * _e1241) + 1u))) + (3u * _e1248));
                                                let _e1251 = (_e1250 < _e96);
                                                if _e1251 {
                                                    if _e1251 {
                                                    } else {
                                                        phi_4388_ = true;
                                                        break;
                                                    }
                                                    let _e1253 = global_6.member[_e1250];
                                                    phi_1313_ = _e1253;
                                                } else {
                                                    phi_1313_ = 4294967295u;
                                                }
                                                let _e1255 = phi_1313_;
                                                if _e1233 {
                                                    phi_1346_ = 0u;
                                                } else {
                                                    phi_1346_ = select(2u, 1u, (_e1231 < (2097152f * _e144)));
                                                }
                                                let _e1260 = phi_1346_;
                                                switch bitcast<i32>(_e1260) {
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
                                                let _e1263 = phi_1352_;
                                                let _e1267 = (_e711 + (_e1212.member_1 * ((3u * _e1263) + 1u)));
                                                switch bitcast<i32>(_e1260) {
                                                    case 0: {
                                                        let _e1542 = (_e1267 < _e96);
                                                        if _e1542 {
                                                            if _e1542 {
                                                            } else {
                                                                phi_4388_ = true;
                                                                break;
                                                            }
                                                            let _e1544 = global_6.member[_e1267];
                                                            phi_1379_ = _e1544;
                                                        } else {
                                                            phi_1379_ = 0u;
                                                        }
                                                        let _e1546 = phi_1379_;
                                                        let _e1548 = ((10u * _e264) & 31u);
                                                        let _e1558 = ((10u * _e263) & 31u);
                                                        let _e1568 = ((10u * _e265) & 31u);
                                                        let _e1578 = (_e1267 + 1u);
                                                        let _e1579 = (_e1578 < _e96);
                                                        if _e1579 {
                                                            if _e1579 {
                                                            } else {
                                                                phi_4388_ = true;
                                                                break;
                                                            }
                                                            let _e1581 = global_6.member[_e1578];
                                                            phi_1428_ = _e1581;
                                                        } else {
                                                            phi_1428_ = 0u;
                                                        }
                                                        let _e1583 = phi_1428_;
                                                        let _e1609 = (_e1267 + 2u);
                                                        let _e1610 = (_e1609 < _e96);
                                                        if _e1610 {
                                                            if _e1610 {
                                                            } else {
                                                                phi_4388_ = true;
                                                                break;
                                                            }
                                                            let _e1612 = global_6.member[_e1609];
                                                            phi_1477_ = _e1612;
                                                        } else {
                                                            phi_1477_ = 0u;
                                                        }
                                                        let _e1614 = phi_1477_;
                                                        phi_1978_ = array<array<f32, 3>, 3>(array<f32, 3>((_e706.member.member.x + ((bitcast<f32>((1258291200u | ((_e1546 >> bitcast<u32>(_e1548)) & 1023u))) - 8388608f) * _e144)), (_e706.member.member.y + ((bitcast<f32>((1258291200u | ((_e1546 >> bitcast<u32>(_e1558)) & 1023u))) - 8388608f) * _e144)), (_e706.member.member.z + ((bitcast<f32>((1258291200u | ((_e1546 >> bitcast<u32>(_e1568)) & 1023u))) - 8388608f) * _e144))), array<f32, 3>((_e706.member.member.x + ((bitcast<f32>((1258291200u | ((_e1583 >> bitcast<u32>(_e1548)) & 1023u))) - 8388608f) * _e144)), (_e706.member.member.y + ((bitcast<f32>((1258291200u | ((_e1583 >> bitcast<u32>(_e1558)) & 1023u))) - 8388608f) * _e144)), (_e706.member.member.z + ((bitcast<f32>((1258291200u | ((_e1583 >> bitcast<u32>(_e1568)) & 1023u))) - 8388608f) * _e144))), array<f32, 3>((_e706.member.member.x + ((bitcast<f32>((1258291200u | ((_e1614 >> bitcast<u32>(_e1548)) & 1023u))) - 8388608f) * _e144)), (_e706.member.member.y + ((bitcast<f32>((1258291200u | ((_e1614 >> bitcast<u32>(_e1558)) & 1023u))) - 8388608f) * _e144)), (_e706.member.member.z + ((bitcast<f32>((1258291200u | ((_e1614 >> bitcast<u32>(_e1568)) & 1023u))) - 8388608f) * _e144))));
                                                        break;
                                                    }
                                                    case 1: {
                                                        let _e1356 = (_e1267 < _e96);
                                                        if _e1356 {
                                                            if _e1356 {
                                                            } else {
                                                                phi_4388_ = true;
                                                                break;
                                                            }
                                                            let _e1358 = global_6.member[_e1267];
                                                            phi_1526_ = _e1358;
                                                        } else {
                                                            phi_1526_ = 0u;
                                                        }
                                                        let _e1360 = phi_1526_;
                                                        let _e1361 = (_e1267 + 1u);
                                                        let _e1362 = (_e1361 < _e96);
                                                        if _e1362 {
                                                            if _e1362 {
                                                            } else {
                                                                phi_4388_ = true;
                                                                break;
                                                            }
                                                            let _e1364 = global_6.member[_e1361];
                                                            phi_1541_ = _e1364;
                                                        } else {
                                                            phi_1541_ = 0u;
                                                        }
                                                        let _e1366 = phi_1541_;
                                                        let _e1367 = (_e264 == 1u);
                                                        if _e1367 {
                                                            phi_1551_ = ((_e1360 >> bitcast<u32>(21i)) | (_e1366 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1551_ = (_e1366 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1376 = phi_1551_;
                                                        let _e1384 = (_e263 == 1u);
                                                        if _e1384 {
                                                            phi_1572_ = ((_e1360 >> bitcast<u32>(21i)) | (_e1366 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1572_ = (_e1366 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1393 = phi_1572_;
                                                        let _e1401 = (_e265 == 1u);
                                                        if _e1401 {
                                                            phi_1593_ = ((_e1360 >> bitcast<u32>(21i)) | (_e1366 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1593_ = (_e1366 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1410 = phi_1593_;
                                                        let _e1419 = (_e1267 + 2u);
                                                        let _e1420 = (_e1419 < _e96);
                                                        if _e1420 {
                                                            if _e1420 {
                                                            } else {
                                                                phi_4388_ = true;
                                                                break;
                                                            }
                                                            let _e1422 = global_6.member[_e1419];
                                                            phi_1623_ = _e1422;
                                                        } else {
                                                            phi_1623_ = 0u;
                                                        }
                                                        let _e1424 = phi_1623_;
                                                        let _e1425 = (_e1267 + 3u);
                                                        let _e1426 = (_e1425 < _e96);
                                                        if _e1426 {
                                                            if _e1426 {
                                                            } else {
                                                                phi_4388_ = true;
                                                                break;
                                                            }
                                                            let _e1428 = global_6.member[_e1425];
                                                            phi_1638_ = _e1428;
                                                        } else {
                                                            phi_1638_ = 0u;
                                                        }
                                                        let _e1430 = phi_1638_;
                                                        if _e1367 {
                                                            phi_1648_ = ((_e1424 >> bitcast<u32>(21i)) | (_e1430 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1648_ = (_e1430 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1439 = phi_1648_;
                                                        if _e1384 {
                                                            phi_1669_ = ((_e1424 >> bitcast<u32>(21i)) | (_e1430 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1669_ = (_e1430 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1455 = phi_1669_;
                                                        if _e1401 {
                                                            phi_1690_ = ((_e1424 >> bitcast<u32>(21i)) | (_e1430 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1690_ = (_e1430 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1471 = phi_1690_;
                                                        let _e1480 = (_e1267 + 4u);
                                                        let _e1481 = (_e1480 < _e96);
                                                        if _e1481 {
                                                            if _e1481 {
                                                            } else {
                                                                phi_4388_ = true;
                                                                break;
                                                            }
                                                            let _e1483 = global_6.member[_e1480];
                                                            phi_1720_ = _e1483;
                                                        } else {
                                                            phi_1720_ = 0u;
                                                        }
                                                        let _e1485 = phi_1720_;
                                                        let _e1486 = (_e1267 + 5u);
                                                        let _e1487 = (_e1486 < _e96);
                                                        if _e1487 {
                                                            if _e1487 {
                                                            } else {
                                                                phi_4388_ = true;
                                                                break;
                                                            }
                                                            let _e1489 = global_6.member[_e1486];
                                                            phi_1735_ = _e1489;
                                                        } else {
                                                            phi_1735_ = 0u;
                                                        }
                                                        let _e1491 = phi_1735_;
                                                        if _e1367 {
                                                            phi_1745_ = ((_e1485 >> bitcast<u32>(21i)) | (_e1491 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1745_ = (_e1491 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1500 = phi_1745_;
                                                        if _e1384 {
                                                            phi_1766_ = ((_e1485 >> bitcast<u32>(21i)) | (_e1491 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1766_ = (_e1491 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1516 = phi_1766_;
                                                        if _e1401 {
                                                            phi_1787_ = ((_e1485 >> bitcast<u32>(21i)) | (_e1491 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1787_ = (_e1491 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1532 = phi_1787_;
                                                        phi_1978_ = array<array<f32, 3>, 3>(array<f32, 3>((_e706.member.member.x + ((bitcast<f32>((1258291200u | (select(_e1376, _e1360, _e303) & 2097151u))) - 8388608f) * _e144)), (_e706.member.member.y + ((bitcast<f32>((1258291200u | (select(_e1393, _e1360, _e372) & 2097151u))) - 8388608f) * _e144)), (_e706.member.member.z + ((bitcast<f32>((1258291200u | (select(_e1410, _e1360, _e440) & 2097151u))) - 8388608f) * _e144))), array<f32, 3>((_e706.member.member.x + ((bitcast<f32>((1258291200u | (select(_e1439, _e1424, _e303) & 2097151u))) - 8388608f) * _e144)), (_e706.member.member.y + ((bitcast<f32>((1258291200u | (select(_e1455, _e1424, _e372) & 2097151u))) - 8388608f) * _e144)), (_e706.member.member.z + ((bitcast<f32>((1258291200u | (select(_e1471, _e1424, _e440) & 2097151u))) - 8388608f) * _e144))), array<f32, 3>((_e706.member.member.x + ((bitcast<f32>((1258291200u | (select(_e1500, _e1485, _e303) & 2097151u))) - 8388608f) * _e144)), (_e706.member.member.y + ((bitcast<f32>((1258291200u | (select(_e1516, _e1485, _e372) & 2097151u))) - 8388608f) * _e144)), (_e706.member.member.z + ((bitcast<f32>((1258291200u | (select(_e1532, _e1485, _e440) & 2097151u))) - 8388608f) * _e144))));
                                                        break;
                                                    }
                                                    case 2: {
                                                        let _e1269 = (_e1267 + _e264);
                                                        let _e1270 = (_e1269 < _e96);
                                                        if _e1270 {
                                                            if _e1270 {
                                                            } else {
                                                                phi_4388_ = true;
                                                                break;
                                                            }
                                                            let _e1272 = global_6.member[_e1269];
                                                            phi_1818_ = _e1272;
                                                        } else {
                                                            phi_1818_ = 0u;
                                                        }
                                                        let _e1274 = phi_1818_;
                                                        let _e1278 = (_e1267 + _e263);
                                                        let _e1279 = (_e1278 < _e96);
                                                        if _e1279 {
                                                            if _e1279 {
                                                            } else {
                                                                phi_4388_ = true;
                                                                break;
                                                            }
                                                            let _e1281 = global_6.member[_e1278];
                                                            phi_1836_ = _e1281;
                                                        } else {
                                                            phi_1836_ = 0u;
                                                        }
                                                        let _e1283 = phi_1836_;
                                                        let _e1287 = (_e1267 + _e265);
                                                        let _e1288 = (_e1287 < _e96);
                                                        if _e1288 {
                                                            if _e1288 {
                                                            } else {
                                                                phi_4388_ = true;
                                                                break;
                                                            }
                                                            let _e1290 = global_6.member[_e1287];
                                                            phi_1854_ = _e1290;
                                                        } else {
                                                            phi_1854_ = 0u;
                                                        }
                                                        let _e1292 = phi_1854_;
                                                        let _e1297 = (_e1267 + 3u);
                                                        let _e1298 = (_e1297 + _e264);
                                                        let _e1299 = (_e1298 < _e96);
                                                        if _e1299 {
                                                            if _e1299 {
                                                            } else {
                                                                phi_4388_ = true;
                                                                break;
                                                            }
                                                            let _e1301 = global_6.member[_e1298];
                                                            phi_1877_ = _e1301;
                                                        } else {
                                                            phi_1877_ = 0u;
                                                        }
                                                        let _e1303 = phi_1877_;
                                                        let _e1307 = (_e1297 + _e263);
                                                        let _e1308 = (_e1307 < _e96);
                                                        if _e1308 {
                                                            if _e1308 {
                                                            } else {
                                                                phi_4388_ = true;
                                                                break;
                                                            }
                                                            let _e1310 = global_6.member[_e1307];
                                                            phi_1895_ = _e1310;
                                                        } else {
                                                            phi_1895_ = 0u;
                                                        }
                                                        let _e1312 = phi_1895_;
                                                        let _e1316 = (_e1297 + _e265);
                                                        let _e1317 = (_e1316 < _e96);
                                                        if _e1317 {
                                                            if _e1317 {
                                                            } else {
                                                                phi_4388_ = true;
                                                                break;
                                                            }
                                                            let _e1319 = global_6.member[_e1316];
                                                            phi_1913_ = _e1319;
                                                        } else {
                                                            phi_1913_ = 0u;
                                                        }
                                                        let _e1321 = phi_1913_;
                                                        let _e1326 = (_e1267 + 6u);
                                                        let _e1327 = (_e1326 + _e264);
                                                        let _e1328 = (_e1327 < _e96);
                                                        if _e1328 {
                                                            if _e1328 {
                                                            } else {
                                                                phi_4388_ = true;
                                                                break;
                                                            }
                                                            let _e1330 = global_6.member[_e1327];
                                                            phi_1936_ = _e1330;
                                                        } else {
                                                            phi_1936_ = 0u;
                                                        }
                                                        let _e1332 = phi_1936_;
                                                        let _e1336 = (_e1326 + _e263);
                                                        let _e1337 = (_e1336 < _e96);
                                                        if _e1337 {
                                                            if _e1337 {
                                                            } else {
                                                                phi_4388_ = true;
                                                                break;
                                                            }
                                                            let _e1339 = global_6.member[_e1336];
                                                            phi_1954_ = _e1339;
                                                        } else {
                                                            phi_1954_ = 0u;
                                                        }
                                                        let _e1341 = phi_1954_;
                                                        let _e1345 = (_e1326 + _e265);
                                                        let _e1346 = (_e1345 < _e96);
                                                        if _e1346 {
                                                            if _e1346 {
                                                            } else {
                                                                phi_4388_ = true;
                                                                break;
                                                            }
                                                            let _e1348 = global_6.member[_e1345];
                                                            phi_1972_ = _e1348;
                                                        } else {
                                                            phi_1972_ = 0u;
                                                        }
                                                        let _e1350 = phi_1972_;
                                                        phi_1978_ = array<array<f32, 3>, 3>(array<f32, 3>((f32(bitcast<i32>(_e1274)) * _e144), (f32(bitcast<i32>(_e1283)) * _e144), (f32(bitcast<i32>(_e1292)) * _e144)), array<f32, 3>((f32(bitcast<i32>(_e1303)) * _e144), (f32(bitcast<i32>(_e1312)) * _e144), (f32(bitcast<i32>(_e1321)) * _e144)), array<f32, 3>((f32(bitcast<i32>(_e1332)) * _e144), (f32(bitcast<i32>(_e1341)) * _e144), (f32(bitcast<i32>(_e1350)) * _e144)));
                                                        break;
                                                    }
                                                    default: {
                                                        phi_1978_ = array<array<f32, 3>, 3>();
                                                        break;
                                                    }
                                                }
                                                let _e1642 = phi_1978_;
                                                let _e1650 = (_e1642[0][2] - _e465);
                                                let _e1653 = (((_e1642[0][0] - _e328) * _e504) - (_e1650 * _e368));
                                                let _e1656 = (((_e1642[0][1] - _e397) * _e504) - (_e1650 * _e436));
                                                let _e1663 = (_e1642[1][2] - _e465);
                                                let _e1666 = (((_e1642[1][0] - _e328) * _e504) - (_e1663 * _e368));
                                                let _e1669 = (((_e1642[1][1] - _e397) * _e504) - (_e1663 * _e436));
                                                let _e1676 = (_e1642[2][2] - _e465);
                                                let _e1679 = (((_e1642[2][0] - _e328) * _e504) - (_e1676 * _e368));
                                                let _e1682 = (((_e1642[2][1] - _e397) * _e504) - (_e1676 * _e436));
                                                let _e1683 = (_e1679 * _e1669);
                                                let _e1684 = (_e1682 * _e1666);
                                                let _e1685 = (_e1653 * _e1682);
                                                let _e1686 = (_e1656 * _e1679);
                                                let _e1687 = (_e1666 * _e1656);
                                                let _e1688 = (_e1669 * _e1653);
                                                let _e1693 = (((_e1683 >= _e1684) && (_e1685 >= _e1686)) && (_e1687 >= _e1688));
                                                if (_e1693 || (((_e1683 <= _e1684) && (_e1685 <= _e1686)) && (_e1687 <= _e1688))) {
                                                    let _e1700 = select(-1f, 1f, _e1693);
                                                    let _e1702 = ((_e1683 - _e1684) * _e1700);
                                                    let _e1704 = select(0f, _e1702, (_e1702 > 0f));
                                                    let _e1706 = ((_e1685 - _e1686) * _e1700);
                                                    let _e1708 = select(0f, _e1706, (_e1706 > 0f));
                                                    let _e1710 = ((_e1687 - _e1688) * _e1700);
                                                    let _e1712 = select(0f, _e1710, (_e1710 > 0f));
                                                    let _e1714 = ((_e1704 + _e1708) + _e1712);
                                                    if (_e1714 < 0.000000000000000000000000000000000000011754944f) {
                                                        phi_2862_ = type_20();
                                                        phi_2863_ = true;
                                                        phi_2864_ = false;
                                                    } else {
                                                        let _e1717 = select(_e1666, _e1653, (_e1653 < _e1666));
                                                        if (select(_e1679, _e1717, (_e1717 < _e1679)) > 0f) {
                                                            phi_2130_ = true;
                                                        } else {
                                                            let _e1722 = select(_e1666, _e1653, (_e1653 > _e1666));
                                                            phi_2130_ = (select(_e1679, _e1722, (_e1722 > _e1679)) < 0f);
                                                        }
                                                        let _e1727 = phi_2130_;
                                                        if _e1727 {
                                                            phi_2859_ = type_20();
                                                            phi_2860_ = true;
                                                            phi_2861_ = false;
                                                        } else {
                                                            let _e1729 = select(_e1669, _e1656, (_e1656 < _e1669));
                                                            if (select(_e1682, _e1729, (_e1729 < _e1682)) > 0f) {
                                                                phi_2159_ = true;
                                                            } else {
                                                                let _e1734 = select(_e1669, _e1656, (_e1656 > _e1669));
                                                                phi_2159_ = (select(_e1682, _e1734, (_e1734 > _e1682)) < 0f);
                                                            }
                                                            let _e1739 = phi_2159_;
                                                            if _e1739 {
                                                                phi_2857_ = type_20();
                                                                phi_2858_ = false;
                                                            } else {
                                                                let _e1741 = select(_e1642[1][0], _e1642[0][0], (_e1642[0][0] < _e1642[1][0]));
                                                                let _e1745 = select(_e1642[1][0], _e1642[0][0], (_e1642[0][0] > _e1642[1][0]));
                                                                let _e1749 = select(_e1642[1][1], _e1642[0][1], (_e1642[0][1] < _e1642[1][1]));
                                                                let _e1753 = select(_e1642[1][1], _e1642[0][1], (_e1642[0][1] > _e1642[1][1]));
                                                                let _e1757 = select(_e1642[1][2], _e1642[0][2], (_e1642[0][2] < _e1642[1][2]));
                                                                let _e1761 = select(_e1642[1][2], _e1642[0][2], (_e1642[0][2] > _e1642[1][2]));
                                                                let _e1766 = ((select(_e1642[2][0], _e1741, (_e1741 < _e1642[2][0])) - _e366) * _e371);
                                                                let _e1767 = ((select(_e1642[2][0], _e1745, (_e1745 > _e1642[2][0])) - _e367) * _e371);
                                                                let _e1770 = ((select(_e1642[2][1], _e1749, (_e1749 < _e1642[2][1])) - _e434) * _e439);
                                                                let _e1771 = ((select(_e1642[2][1], _e1753, (_e1753 > _e1642[2][1])) - _e435) * _e439);
                                                                let _e1774 = ((select(_e1642[2][2], _e1757, (_e1757 < _e1642[2][2])) - _e502) * _e507);
                                                                let _e1775 = ((select(_e1642[2][2], _e1761, (_e1761 > _e1642[2][2])) - _e503) * _e507);
                                                                let _e1777 = select(_e1775, _e1774, (_e1774 < _e1775));
                                                                let _e1779 = select(_e1775, _e1774, (_e1774 > _e1775));
                                                                let _e1781 = select(_e1767, _e1766, (_e1766 < _e1767));
                                                                let _e1783 = select(_e1771, _e1770, (_e1770 < _e1771));
                                                                let _e1785 = select(_e1783, _e1781, (_e1781 > _e1783));
                                                                let _e1787 = select(_e1777, _e1785, (_e1785 > _e1777));
                                                                let _e1789 = select(_e1767, _e1766, (_e1766 > _e1767));
                                                                let _e1791 = select(_e1771, _e1770, (_e1770 > _e1771));
                                                                let _e1793 = select(_e1791, _e1789, (_e1789 < _e1791));
                                                                let _e1795 = select(_e1779, _e1793, (_e1793 < _e1779));
                                                                let _e1796 = -(_e1777);
                                                                let _e1802 = select(_e619, _e1787, (_e1787 > _e619));
                                                                if (_e1802 > (_e1795 + (select(_e1796, _e1779, (_e1779 > _e1796)) * 0.0000019073523f))) {
                                                                    phi_2852_ = type_20();
                                                                    phi_2853_ = true;
                                                                } else {
                                                                    let _e1804 = (_e1802 > _e1195.member);
                                                                    if _e1804 {
                                                                        phi_2851_ = type_20();
                                                                    } else {
                                                                        let _e1805 = vec3<f32>(_e1642[0][0], _e1642[0][1], _e1642[0][2]);
                                                                        let _e1806 = vec3<f32>(_e1642[1][0], _e1642[1][1], _e1642[1][2]);
                                                                        let _e1807 = vec3<f32>(_e1642[2][0], _e1642[2][1], _e1642[2][2]);
                                                                        let _e1808 = (_e1642[1][0] - _e1642[0][0]);
                                                                        let _e1809 = (_e1642[1][1] - _e1642[0][1]);
                                                                        let _e1810 = (_e1642[1][2] - _e1642[0][2]);
                                                                        let _e1811 = vec3<f32>(_e1808, _e1809, _e1810);
                                                                        let _e1812 = (_e1642[2][0] - _e1642[1][0]);
                                                                        let _e1813 = (_e1642[2][1] - _e1642[1][1]);
                                                                        let _e1814 = (_e1642[2][2] - _e1642[1][2]);
                                                                        let _e1815 = vec3<f32>(_e1812, _e1813, _e1814);
                                                                        let _e1816 = (_e1642[0][0] - _e1642[2][0]);
                                                                        let _e1817 = (_e1642[0][1] - _e1642[2][1]);
                                                                        let _e1818 = (_e1642[0][2] - _e1642[2][2]);
                                                                        let _e1819 = vec3<f32>(_e1816, _e1817, _e1818);
                                                                        let _e1822 = bitcast<f32>((bitcast<u32>(_e1808) & 2147483647u));
                                                                        let _e1825 = bitcast<f32>((bitcast<u32>(_e1809) & 2147483647u));
                                                                        let _e1827 = select(_e1825, _e1822, (_e1822 > _e1825));
                                                                        let _e1830 = bitcast<f32>((bitcast<u32>(_e1810) & 2147483647u));
                                                                        let _e1832 = select(_e1830, _e1827, (_e1827 > _e1830));
                                                                        let _e1835 = bitcast<f32>((bitcast<u32>(_e1812) & 2147483647u));
                                                                        let _e1838 = bitcast<f32>((bitcast<u32>(_e1813) & 2147483647u));
                                                                        let _e1840 = select(_e1838, _e1835, (_e1835 > _e1838));
                                                                        let _e1843 = bitcast<f32>((bitcast<u32>(_e1814) & 2147483647u));
                                                                        let _e1845 = select(_e1843, _e1840, (_e1840 > _e1843));
                                                                        let _e1848 = bitcast<f32>((bitcast<u32>(_e1816) & 2147483647u));
                                                                        let _e1851 = bitcast<f32>((bitcast<u32>(_e1817) & 2147483647u));
                                                                        let _e1853 = select(_e1851, _e1848, (_e1848 > _e1851));
                                                                        let _e1856 = bitcast<f32>((bitcast<u32>(_e1818) & 2147483647u));
                                                                        let _e1858 = select(_e1856, _e1853, (_e1853 > _e1856));
                                                                        let _e1860 = select(_e1845, _e1832, (_e1832 > _e1845));
                                                                        let _e1862 = select(_e1858, _e1860, (_e1860 > _e1858));
                                                                        if (_e1832 == _e1862) {
                                                                            phi_2578_ = _e1669;
                                                                            phi_2579_ = _e1666;
                                                                            phi_2580_ = _e1656;
                                                                            phi_2581_ = _e1653;
                                                                            phi_2582_ = _e1805;
                                                                            phi_2583_ = _e1819;
                                                                            phi_2584_ = _e1815;
                                                                            phi_2585_ = _e1811;
                                                                        } else {
                                                                            let _e1864 = (_e1845 == _e1862);
                                                                            let _e1869 = vec3(_e1864);
                                                                            phi_2578_ = select(_e1656, _e1682, _e1864);
                                                                            phi_2579_ = select(_e1653, _e1679, _e1864);
                                                                            phi_2580_ = select(_e1682, _e1669, _e1864);
                                                                            phi_2581_ = select(_e1679, _e1666, _e1864);
                                                                            phi_2582_ = select(_e1807, _e1806, _e1869);
                                                                            phi_2583_ = select(_e1815, _e1811, _e1869);
                                                                            phi_2584_ = select(_e1811, _e1819, _e1869);
                                                                            phi_2585_ = select(_e1819, _e1815, _e1869);
                                                                        }
                                                                        let _e1875 = phi_2578_;
                                                                        let _e1877 = phi_2579_;
                                                                        let _e1879 = phi_2580_;
                                                                        let _e1881 = phi_2581_;
                                                                        let _e1883 = phi_2582_;
                                                                        let _e1885 = phi_2583_;
                                                                        let _e1887 = phi_2584_;
                                                                        let _e1889 = phi_2585_;
                                                                        let _e1896 = ((_e1887.y * _e1885.z) - (_e1885.y * _e1887.z));
                                                                        let _e1901 = ((_e1887.z * _e1885.x) - (_e1885.z * _e1887.x));
                                                                        let _e1904 = ((_e1887.x * _e1885.y) - (_e1885.x * _e1887.y));
                                                                        if (_e1704 >= _e1708) {
                                                                            phi_2622_ = select(true, false, (_e1704 >= _e1712));
                                                                        } else {
                                                                            phi_2622_ = true;
                                                                        }
                                                                        let _e1909 = phi_2622_;
                                                                        if _e1909 {
                                                                            phi_2631_ = select(_e1807, _e1806, vec3((_e1708 >= _e1712)));
                                                                        } else {
                                                                            phi_2631_ = _e1805;
                                                                        }
                                                                        let _e1914 = phi_2631_;
                                                                        let _e1925 = (((_e1896 * (_e1914.x - _e328)) + (_e1901 * (_e1914.y - _e397))) + (_e1904 * (_e1914.z - _e465)));
                                                                        let _e1930 = (((_e1896 * _e368) + (_e1901 * _e436)) + (_e1904 * _e504));
                                                                        let _e1931 = (_e1877 - _e1881);
                                                                        let _e1932 = (_e1875 - _e1879);
                                                                        let _e1940 = (-(((_e1881 * _e1931) + (_e1879 * _e1932))) / ((_e1931 * _e1931) + (_e1932 * _e1932)));
                                                                        let _e1942 = select(1f, _e1940, (_e1940 < 1f));
                                                                        let _e1944 = select(0f, _e1942, (_e1942 > 0f));
                                                                        let _e1957 = ((_e1883.x + (_e1889.x * _e1944)) - _e328);
                                                                        let _e1958 = ((_e1883.y + (_e1889.y * _e1944)) - _e397);
                                                                        let _e1959 = ((_e1883.z + (_e1889.z * _e1944)) - _e465);
                                                                        let _e1960 = (_e1959 / _e504);
                                                                        let _e1972 = bitcast<f32>((bitcast<u32>(_e1957) & 2147483647u));
                                                                        let _e1975 = bitcast<f32>((bitcast<u32>(_e1958) & 2147483647u));
                                                                        let _e1977 = select(_e1975, _e1972, (_e1972 > _e1975));
                                                                        let _e1980 = bitcast<f32>((bitcast<u32>(_e1959) & 2147483647u));
                                                                        let _e1982 = select(_e1980, _e1977, (_e1977 > _e1980));
                                                                        let _e1988 = bitcast<f32>((bitcast<u32>(_e1896) & 2147483647u));
                                                                        let _e1991 = bitcast<f32>((bitcast<u32>(_e1901) & 2147483647u));
                                                                        let _e1993 = select(_e1991, _e1988, (_e1988 > _e1991));
                                                                        let _e1996 = bitcast<f32>((bitcast<u32>(_e1904) & 2147483647u));
                                                                        if (bitcast<f32>((bitcast<u32>(((((_e1896 * _e1957) + (_e1901 * _e1958)) + (_e1904 * _e1959)) - _e1925)) & 2147483647u)) <= ((0.0000009536743f * select(_e1862, _e1982, (_e1982 > _e1862))) * select(_e1996, _e1993, (_e1993 > _e1996)))) {
                                                                            let _e2006 = bitcast<f32>((bitcast<u32>(_e1887.x) & 2147483647u));
                                                                            let _e2009 = bitcast<f32>((bitcast<u32>(_e1887.y) & 2147483647u));
                                                                            let _e2011 = select(_e2009, _e2006, (_e2006 > _e2009));
                                                                            let _e2014 = bitcast<f32>((bitcast<u32>(_e1887.z) & 2147483647u));
                                                                            let _e2020 = bitcast<f32>((bitcast<u32>(_e1885.x) & 2147483647u));
                                                                            let _e2023 = bitcast<f32>((bitcast<u32>(_e1885.y) & 2147483647u));
                                                                            let _e2025 = select(_e2023, _e2020, (_e2020 > _e2023));
                                                                            let _e2028 = bitcast<f32>((bitcast<u32>(_e1885.z) & 2147483647u));
                                                                            let _e2032 = (bitcast<f32>((bitcast<u32>(_e1930) & 2147483647u)) > ((0.0000038146973f * select(_e2014, _e2011, (_e2011 > _e2014))) * select(_e2028, _e2025, (_e2025 > _e2028))));
                                                                            if _e2032 {
                                                                                phi_2796_ = (_e1925 / _e1930);
                                                                            } else {
                                                                                phi_2796_ = f32();
                                                                            }
                                                                            let _e2035 = phi_2796_;
                                                                            phi_2798_ = _e2035;
                                                                            phi_2799_ = select(true, false, _e2032);
                                                                        } else {
                                                                            phi_2798_ = f32();
                                                                            phi_2799_ = true;
                                                                        }
                                                                        let _e2038 = phi_2798_;
                                                                        let _e2040 = phi_2799_;
                                                                        if _e2040 {
                                                                            let _e2048 = (((_e1896 * (_e1957 - (_e368 * _e1960))) + (_e1901 * (_e1958 - (_e436 * _e1960)))) / _e1930);
                                                                            if (bitcast<f32>((bitcast<u32>(_e2048) & 2147483647u)) <= _e1862) {
                                                                                phi_2819_ = (_e1960 + _e2048);
                                                                            } else {
                                                                                phi_2819_ = _e1960;
                                                                            }
                                                                            let _e2055 = phi_2819_;
                                                                            phi_2820_ = _e2055;
                                                                        } else {
                                                                            phi_2820_ = _e2038;
                                                                        }
                                                                        let _e2057 = phi_2820_;
                                                                        let _e2059 = select(_e1795, _e2057, (_e2057 < _e1795));
                                                                        let _e2061 = select(_e1787, _e2059, (_e2059 > _e1787));
                                                                        if (_e2061 >= _e619) {
                                                                            let _e2063 = (_e2061 <= _e1195.member);
                                                                            if _e2063 {
                                                                                let _e2064 = (1f / _e1714);
                                                                                phi_2843_ = type_20(_e2061, (_e1708 * _e2064), (_e1712 * _e2064), _e1255);
                                                                            } else {
                                                                                phi_2843_ = type_20();
                                                                            }
                                                                            let _e2069 = phi_2843_;
                                                                            phi_2845_ = _e2069;
                                                                            phi_2846_ = select(true, false, _e2063);
                                                                        } else {
                                                                            phi_2845_ = type_20();
                                                                            phi_2846_ = true;
                                                                        }
                                                                        let _e2072 = phi_2845_;
                                                                        let _e2074 = phi_2846_;
                                                                        if _e2074 {
                                                                            phi_2850_ = type_20(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                        } else {
                                                                            phi_2850_ = _e2072;
                                                                        }
                                                                        let _e2076 = phi_2850_;
                                                                        phi_2851_ = _e2076;
                                                                    }
                                                                    let _e2078 = phi_2851_;
                                                                    phi_2852_ = _e2078;
                                                                    phi_2853_ = _e1804;
                                                                }
                                                                let _e2080 = phi_2852_;
                                                                let _e2082 = phi_2853_;
                                                                phi_2857_ = _e2080;
                                                                phi_2858_ = _e2082;
                                                            }
                                                            let _e2084 = phi_2857_;
                                                            let _e2086 = phi_2858_;
                                                            phi_2859_ = _e2084;
                                                            phi_2860_ = _e1739;
                                                            phi_2861_ = _e2086;
                                                        }
                                                        let _e2088 = phi_2859_;
                                                        let _e2090 = phi_2860_;
                                                        let _e2092 = phi_2861_;
                                                        phi_2862_ = _e2088;
                                                        phi_2863_ = _e2090;
                                                        phi_2864_ = _e2092;
                                                    }
                                                    let _e2094 = phi_2862_;
                                                    let _e2096 = phi_2863_;
                                                    let _e2098 = phi_2864_;
                                                    phi_2872_ = _e2094;
                                                    phi_2873_ = select(_e2098, true, _e2096);
                                                } else {
                                                    phi_2872_ = type_20();
                                                    phi_2873_ = true;
                                                }
                                                let _e2101 = phi_2872_;
                                                let _e2103 = phi_2873_;
                                                if _e2103 {
                                                    phi_2877_ = type_20(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                } else {
                                                    phi_2877_ = _e2101;
                                                }
                                                let _e2105 = phi_2877_;
                                                if (_e2105.member_3 != 4294967295u) {
                                                    if (_e1255 != 4294967295u) {
                                                        phi_2888_ = type_34(_e1195.member, true);
                                                    } else {
                                                        phi_2888_ = _e1195;
                                                    }
                                                    let _e2113 = phi_2888_;
                                                    phi_2889_ = _e2113;
                                                } else {
                                                    phi_2889_ = _e1195;
                                                }
                                                let _e2115 = phi_2889_;
                                                phi_1215_ = _e2115;
                                            } else {
                                                phi_1215_ = type_34();
                                            }
                                            let _e2117 = phi_1215_;
                                            continue;
                                            continuing {
                                                phi_1214_ = _e2117;
                                                phi_1217_ = _e1210;
                                                phi_4388_ = _e661;
                                                break if !(_e1216);
                                            }
                                        }
                                        let _e2120 = phi_4388_;
                                        phi_4592_ = _e2120;
                                        if _e2120 {
                                            break;
                                        }
                                        let _e2122 = local_10;
                                        phi_4596_ = _e2120;
                                        let _e2328 = local_12;
                                        phi_4162_ = _e2328;
                                        phi_4163_ = false;
                                        phi_4164_ = select(_e704, 0u, _e2122.member_1);
                                        phi_4165_ = _e706;
                                    } else {
                                        if (_e706.member_1 >= _e93) {
                                            phi_3697_ = type_46(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), type_45(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u), type_45(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u));
                                        } else {
                                            if (_e706.member_1 < _e93) {
                                            } else {
                                                phi_4592_ = true;
                                                break;
                                            }
                                            let _e718 = (_e264 * 2u);
                                            let _e720 = ((1u + _e718) % 7u);
                                            if (_e720 < 7u) {
                                            } else {
                                                phi_4592_ = true;
                                                break;
                                            }
                                            let _e725 = global_5.member[_e706.member_1][_e720];
                                            let _e727 = ((_e718 + 2u) % 7u);
                                            if (_e727 < 7u) {
                                            } else {
                                                phi_4592_ = true;
                                                break;
                                            }
                                            let _e732 = global_5.member[_e706.member_1][_e727];
                                            let _e733 = (_e263 * 2u);
                                            let _e735 = ((1u + _e733) % 7u);
                                            if (_e735 < 7u) {
                                            } else {
                                                phi_4592_ = true;
                                                break;
                                            }
                                            let _e740 = global_5.member[_e706.member_1][_e735];
                                            let _e742 = ((_e733 + 2u) % 7u);
                                            if (_e742 < 7u) {
                                            } else {
                                                phi_4592_ = true;
                                                break;
                                            }
                                            let _e747 = global_5.member[_e706.member_1][_e742];
                                            let _e748 = (_e265 * 2u);
                                            let _e750 = ((1u + _e748) % 7u);
                                            if (_e750 < 7u) {
                                            } else {
                                                phi_4592_ = true;
                                                break;
                                            }
                                            let _e755 = global_5.member[_e706.member_1][_e750];
                                            let _e757 = ((_e748 + 2u) % 7u);
                                            if (_e757 < 7u) {
                                            } else {
                                                phi_4592_ = true;
                                                break;
                                            }
                                            let _e762 = global_5.member[_e706.member_1][_e757];
                                            let _e785 = (bitcast<f32>((bitcast<u32>((_e706.member.member_1.x - _e706.member.member.x)) & 2139095040u)) * 0.0000009536743f);
                                            let _e786 = (bitcast<f32>((bitcast<u32>((_e706.member.member_1.y - _e706.member.member.y)) & 2139095040u)) * 0.0000009536743f);
                                            let _e787 = (bitcast<f32>((bitcast<u32>((_e706.member.member_1.z - _e706.member.member.z)) & 2139095040u)) * 0.0000009536743f);
                                            let _e789 = select(_e144, _e785, (_e785 > _e144));
                                            let _e791 = select(_e144, _e786, (_e786 > _e144));
                                            let _e793 = select(_e144, _e787, (_e787 > _e144));
                                            let _e824 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e725 & 2097151u))) - 8388608f) * _e789));
                                            let _e829 = (bitcast<i32>((_e725 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e832 = bitcast<f32>((_e824 & bitcast<u32>(_e829)));
                                            let _e833 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e740 & 2097151u))) - 8388608f) * _e791));
                                            let _e838 = (bitcast<i32>((_e740 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e841 = bitcast<f32>((_e833 & bitcast<u32>(_e838)));
                                            let _e842 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e755 & 2097151u))) - 8388608f) * _e793));
                                            let _e847 = (bitcast<i32>((_e755 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e850 = bitcast<f32>((_e842 & bitcast<u32>(_e847)));
                                            let _e854 = bitcast<f32>((_e824 & bitcast<u32>(~(_e829))));
                                            let _e858 = bitcast<f32>((_e833 & bitcast<u32>(~(_e838))));
                                            let _e862 = bitcast<f32>((_e842 & bitcast<u32>(~(_e847))));
                                            let _e863 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e732 & 2097151u))) - 8388608f) * _e789));
                                            let _e868 = (bitcast<i32>((_e732 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e871 = bitcast<f32>((_e863 & bitcast<u32>(_e868)));
                                            let _e872 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e747 & 2097151u))) - 8388608f) * _e791));
                                            let _e877 = (bitcast<i32>((_e747 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e880 = bitcast<f32>((_e872 & bitcast<u32>(_e877)));
                                            let _e881 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e762 & 2097151u))) - 8388608f) * _e793));
                                            let _e886 = (bitcast<i32>((_e762 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e889 = bitcast<f32>((_e881 & bitcast<u32>(_e886)));
                                            let _e893 = bitcast<f32>((_e863 & bitcast<u32>(~(_e868))));
                                            let _e897 = bitcast<f32>((_e872 & bitcast<u32>(~(_e877))));
                                            let _e901 = bitcast<f32>((_e881 & bitcast<u32>(~(_e886))));
                                            let _e902 = (_e706.member.member.x + _e832);
                                            let _e903 = (_e706.member.member.y + _e841);
                                            let _e904 = (_e706.member.member.z + _e850);
                                            let _e907 = (_e706.member.member_1.x - _e871);
                                            let _e908 = (_e706.member.member_1.y - _e880);
                                            let _e909 = (_e706.member.member_1.z - _e889);
                                            let _e928 = (_e907 - _e902);
                                            let _e929 = (_e908 - _e903);
                                            let _e930 = (_e909 - _e904);
                                            let _e932 = select(_e929, _e928, (_e928 > _e929));
                                            let _e934 = select(_e930, _e932, (_e932 > _e930));
                                            if (_e934 < (1024f * _e144)) {
                                                phi_3398_ = 0u;
                                            } else {
                                                phi_3398_ = select(2u, 1u, (_e934 < (2097152f * _e144)));
                                            }
                                            let _e941 = phi_3398_;
                                            switch bitcast<i32>(_e941) {
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
                                            let _e944 = phi_3404_;
                                            let _e950 = global_5.member[_e706.member_1][0u];
                                            let _e954 = global_5.member[_e706.member_1][2u];
                                            let _e958 = global_5.member[_e706.member_1][4u];
                                            let _e962 = global_5.member[_e706.member_1][6u];
                                            let _e974 = (((_e954 >> bitcast<u32>(22i)) | ((_e958 >> bitcast<u32>(22i)) << bitcast<u32>(10i))) | ((_e962 >> bitcast<u32>(22i)) << bitcast<u32>(20i)));
                                            let _e975 = (_e950 & 268435455u);
                                            let _e976 = (_e974 & 268435455u);
                                            let _e979 = ((_e950 >> bitcast<u32>(28u)) & 7u);
                                            let _e987 = ((_e950 >> bitcast<u32>(31i)) | (((_e974 >> bitcast<u32>(28u)) & 3u) << bitcast<u32>(1i)));
                                            let _e988 = (_e979 != 0u);
                                            if (_e979 == 0u) {
                                                phi_3659_ = _e975;
                                            } else {
                                                if (_e979 == 7u) {
                                                    phi_3658_ = 2147483648u;
                                                } else {
                                                    phi_3658_ = ((2147483648u | (_e979 << bitcast<u32>(28u))) | (_e976 & 268435455u));
                                                }
                                                let _e997 = phi_3658_;
                                                phi_3659_ = _e997;
                                            }
                                            let _e999 = phi_3659_;
                                            if _e988 {
                                                let _e1000 = (_e979 != 7u);
                                                if _e1000 {
                                                    phi_3669_ = (_e976 + (_e979 * ((3u * _e944) + 1u)));
                                                } else {
                                                    phi_3669_ = u32();
                                                }
                                                let _e1004 = phi_3669_;
                                                phi_3671_ = _e1004;
                                                phi_3672_ = select(true, false, _e1000);
                                            } else {
                                                phi_3671_ = u32();
                                                phi_3672_ = true;
                                            }
                                            let _e1007 = phi_3671_;
                                            let _e1009 = phi_3672_;
                                            if (_e987 == 0u) {
                                                phi_3693_ = (_e975 + select(0u, 1u, !(_e988)));
                                            } else {
                                                if (_e987 == 7u) {
                                                    phi_3692_ = 2147483648u;
                                                } else {
                                                    phi_3692_ = ((2147483648u | (_e987 << bitcast<u32>(28u))) | (select(_e1007, _e976, _e1009) & 268435455u));
                                                }
                                                let _e1022 = phi_3692_;
                                                phi_3693_ = _e1022;
                                            }
                                            let _e1024 = phi_3693_;
                                            phi_3697_ = type_46(array<vec4<f32>, 3>(vec4<f32>(_e902, (_e706.member.member.x + _e854), _e907, (_e706.member.member_1.x - _e893)), vec4<f32>(_e903, (_e706.member.member.y + _e858), _e908, (_e706.member.member_1.y - _e897)), vec4<f32>(_e904, (_e706.member.member.z + _e862), _e909, (_e706.member.member_1.z - _e901))), type_45(type_24((_e706.member.member + vec4<f32>(_e832, _e841, _e850, 0f)), (_e706.member.member_1 - vec4<f32>(_e871, _e880, _e889, 0f))), _e999), type_45(type_24((_e706.member.member + vec4<f32>(_e854, _e858, _e862, 0f)), (_e706.member.member_1 - vec4<f32>(_e893, _e897, _e901, 0f))), _e1024));
                                        }
                                        let _e1029 = phi_3697_;
                                        let _e1041 = ((_e1029.member[0].x - _e366) * _e371);
                                        let _e1042 = ((_e1029.member[0].y - _e366) * _e371);
                                        let _e1043 = ((_e1029.member[0].z - _e367) * _e371);
                                        let _e1044 = ((_e1029.member[0].w - _e367) * _e371);
                                        let _e1054 = ((_e1029.member[1].x - _e434) * _e439);
                                        let _e1055 = ((_e1029.member[1].y - _e434) * _e439);
                                        let _e1056 = ((_e1029.member[1].z - _e435) * _e439);
                                        let _e1057 = ((_e1029.member[1].w - _e435) * _e439);
                                        let _e1067 = ((_e1029.member[2].x - _e502) * _e507);
                                        let _e1068 = ((_e1029.member[2].y - _e502) * _e507);
                                        let _e1069 = ((_e1029.member[2].z - _e503) * _e507);
                                        let _e1070 = ((_e1029.member[2].w - _e503) * _e507);
                                        let _e1072 = select(_e1069, _e1067, (_e1067 < _e1069));
                                        let _e1074 = select(_e1070, _e1068, (_e1068 < _e1070));
                                        let _e1076 = select(_e1069, _e1067, (_e1067 > _e1069));
                                        let _e1078 = select(_e1070, _e1068, (_e1068 > _e1070));
                                        let _e1080 = select(_e1043, _e1041, (_e1041 < _e1043));
                                        let _e1082 = select(_e1044, _e1042, (_e1042 < _e1044));
                                        let _e1084 = select(_e1056, _e1054, (_e1054 < _e1056));
                                        let _e1086 = select(_e1057, _e1055, (_e1055 < _e1057));
                                        let _e1088 = select(_e1084, _e1080, (_e1080 > _e1084));
                                        let _e1090 = select(_e1086, _e1082, (_e1082 > _e1086));
                                        let _e1092 = select(_e1072, _e1088, (_e1088 > _e1072));
                                        let _e1094 = select(_e1074, _e1090, (_e1090 > _e1074));
                                        let _e1096 = select(_e1043, _e1041, (_e1041 > _e1043));
                                        let _e1098 = select(_e1044, _e1042, (_e1042 > _e1044));
                                        let _e1100 = select(_e1056, _e1054, (_e1054 > _e1056));
                                        let _e1102 = select(_e1057, _e1055, (_e1055 > _e1057));
                                        let _e1104 = select(_e1100, _e1096, (_e1096 < _e1100));
                                        let _e1106 = select(_e1102, _e1098, (_e1098 < _e1102));
                                        let _e1111 = -(_e1072);
                                        let _e1112 = -(_e1074);
                                        let _e1119 = (select(_e1076, _e1104, (_e1104 < _e1076)) + (select(_e1111, _e1076, (_e1076 > _e1111)) * 0.0000019073523f));
                                        let _e1120 = (select(_e1078, _e1106, (_e1106 < _e1078)) + (select(_e1112, _e1078, (_e1078 > _e1112)) * 0.0000019073523f));
                                        let _e1122 = select(_e619, _e1092, (_e1092 > _e619));
                                        let _e1124 = select(_e619, _e1094, (_e1094 > _e619));
                                        let _e1129 = (_e1122 <= select(_e663.member, _e1119, (_e1119 < _e663.member)));
                                        let _e1130 = (_e1124 <= select(_e663.member, _e1120, (_e1120 < _e663.member)));
                                        let _e1131 = (_e1122 <= _e1124);
                                        if _e1129 {
                                            if _e1130 {
                                                if _e1131 {
                                                    phi_4059_ = _e1029.member_2;
                                                } else {
                                                    phi_4059_ = _e1029.member_1;
                                                }
                                                let _e1135 = phi_4059_;
                                                let _e1157 = (_e704 % 128u);
                                                let _e1158 = (_e1157 < 128u);
                                                if _e1158 {
                                                } else {
                                                    phi_4592_ = true;
                                                    break;
                                                }
                                                local_8[_e1157] = _e1135.member_1;
                                                if _e1158 {
                                                } else {
                                                    phi_4592_ = true;
                                                    break;
                                                }
                                                local_7[_e1157] = _e1135.member.member.x;
                                                if _e1158 {
                                                } else {
                                                    phi_4592_ = true;
                                                    break;
                                                }
                                                local_6[_e1157] = _e1135.member.member.y;
                                                if _e1158 {
                                                } else {
                                                    phi_4592_ = true;
                                                    break;
                                                }
                                                local_5[_e1157] = _e1135.member.member.z;
                                                if _e1158 {
                                                } else {
                                                    phi_4592_ = true;
                                                    break;
                                                }
                                                local_4[_e1157] = _e1135.member.member_1.x;
                                                if _e1158 {
                                                } else {
                                                    phi_4592_ = true;
                                                    break;
                                                }
                                                local_3[_e1157] = _e1135.member.member_1.y;
                                                if _e1158 {
                                                } else {
                                                    phi_4592_ = true;
                                                    break;
                                                }
                                                local_2[_e1157] = _e1135.member.member_1.z;
                                                if _e1158 {
                                                } else {
                                                    phi_4592_ = true;
                                                    break;
                                                }
                                                local_9[_e1157] = select(_e1124, _e1122, !(_e1131));
                                                if _e1131 {
                                                    phi_4136_ = _e1029.member_1;
                                                } else {
                                                    phi_4136_ = _e1029.member_2;
                                                }
                                                let _e1171 = phi_4136_;
                                                phi_4137_ = (_e704 + 1u);
                                                phi_4138_ = _e1171;
                                            } else {
                                                phi_4137_ = u32();
                                                phi_4138_ = type_45();
                                            }
                                            let _e1173 = phi_4137_;
                                            let _e1175 = phi_4138_;
                                            phi_4140_ = _e1173;
                                            phi_4141_ = _e1175;
                                            phi_4142_ = select(true, false, _e1130);
                                        } else {
                                            phi_4140_ = u32();
                                            phi_4141_ = type_45();
                                            phi_4142_ = true;
                                        }
                                        let _e1178 = phi_4140_;
                                        let _e1180 = phi_4141_;
                                        let _e1182 = phi_4142_;
                                        if _e1182 {
                                            if _e1129 {
                                                phi_4151_ = _e1029.member_1;
                                            } else {
                                                phi_4151_ = _e1029.member_2;
                                            }
                                            let _e1186 = phi_4151_;
                                            phi_4156_ = select(_e1130, true, _e1129);
                                            phi_4158_ = _e1186;
                                        } else {
                                            phi_4156_ = _e702;
                                            phi_4158_ = _e1180;
                                        }
                                        let _e1189 = phi_4156_;
                                        let _e1191 = phi_4158_;
                                        phi_4596_ = _e661;
                                        phi_4162_ = _e663;
                                        phi_4163_ = _e1189;
                                        phi_4164_ = select(_e1178, _e704, _e1182);
                                        phi_4165_ = _e1191;
                                    }
                                    let _e2126 = phi_4596_;
                                    let _e2128 = phi_4162_;
                                    let _e2130 = phi_4163_;
                                    let _e2132 = phi_4164_;
                                    let _e2134 = phi_4165_;
                                    phi_4595_ = _e2126;
                                    phi_4166_ = _e2128;
                                    phi_4167_ = _e2130;
                                    phi_4168_ = (_e667 - 1u);
                                    phi_4169_ = _e2132;
                                    phi_4170_ = _e2134;
                                } else {
                                    phi_4595_ = _e661;
                                    phi_4166_ = _e663;
                                    phi_4167_ = _e702;
                                    phi_4168_ = _e667;
                                    phi_4169_ = _e704;
                                    phi_4170_ = _e706;
                                }
                                let _e2136 = phi_4595_;
                                let _e2138 = phi_4166_;
                                let _e2140 = phi_4167_;
                                let _e2142 = phi_4168_;
                                let _e2144 = phi_4169_;
                                let _e2146 = phi_4170_;
                                phi_4594_ = _e2136;
                                phi_4171_ = _e2138;
                                phi_4172_ = _e2140;
                                phi_4173_ = _e2142;
                                phi_4174_ = _e2144;
                                phi_4175_ = _e2146;
                            } else {
                                phi_4594_ = _e661;
                                phi_4171_ = type_34();
                                phi_4172_ = bool();
                                phi_4173_ = u32();
                                phi_4174_ = u32();
                                phi_4175_ = type_45();
                            }
                            let _e2148 = phi_4594_;
                            let _e2150 = phi_4171_;
                            let _e2152 = phi_4172_;
                            let _e2154 = phi_4173_;
                            let _e2156 = phi_4174_;
                            let _e2158 = phi_4175_;
                            phi_4593_ = _e2148;
                            phi_1088_ = _e2150;
                            phi_1091_ = _e2152;
                            phi_1093_ = _e2154;
                            phi_1095_ = _e2156;
                            phi_1097_ = _e2158;
                            phi_4176_ = _e675;
                        } else {
                            phi_4593_ = _e661;
                            phi_1088_ = type_34();
                            phi_1091_ = bool();
                            phi_1093_ = u32();
                            phi_1095_ = u32();
                            phi_1097_ = type_45();
                            phi_4176_ = false;
                        }
                        let _e2160 = phi_4593_;
                        let _e2162 = phi_1088_;
                        let _e2164 = phi_1091_;
                        let _e2166 = phi_1093_;
                        let _e2168 = phi_1095_;
                        let _e2170 = phi_1097_;
                        let _e2172 = phi_4176_;
                        continue;
                        continuing {
                            phi_4394_ = _e2160;
                            phi_1087_ = _e2162;
                            phi_1090_ = _e2164;
                            phi_1092_ = _e2166;
                            phi_1094_ = _e2168;
                            phi_1096_ = _e2170;
                            phi_4592_ = _e2160;
                            break if !(_e2172);
                        }
                    }
                    let _e2175 = phi_4592_;
                    if _e2175 {
                        break;
                    }
                    let _e2177 = local_11;
                    if _e152 {
                    } else {
                        break;
                    }
                    global_4.member[_e150] = select(0u, 1u, _e2177.member_1);
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn trace_any_q21_lattice(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
