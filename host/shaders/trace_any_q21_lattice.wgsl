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
    var phi_4397_: bool;
    var phi_1087_: type_34;
    var phi_1090_: u32;
    var phi_1092_: bool;
    var phi_1094_: u32;
    var phi_1096_: type_45;
    var phi_1107_: bool;
    var phi_1193_: bool;
    var phi_1194_: u32;
    var phi_1195_: type_45;
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
    var phi_4391_: bool;
    var phi_4686_: bool;
    var phi_2890_: type_34;
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
    var phi_4169_: type_34;
    var phi_4170_: u32;
    var phi_4171_: bool;
    var phi_4172_: u32;
    var phi_4173_: type_45;
    var phi_4597_: bool;
    var phi_4174_: type_34;
    var phi_4175_: u32;
    var phi_4176_: bool;
    var phi_4177_: u32;
    var phi_4178_: type_45;
    var phi_4596_: bool;
    var phi_1088_: type_34;
    var phi_1091_: u32;
    var phi_1093_: bool;
    var phi_1095_: u32;
    var phi_1097_: type_45;
    var phi_4179_: bool;
    var phi_4595_: bool;
    var local_10: type_34;
    var local_11: type_34;

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
                    phi_4397_ = false;
                    phi_1087_ = type_34(_e617, false);
                    phi_1090_ = ((3u * _e93) + 1u);
                    phi_1092_ = (_e619 <= _e617);
                    phi_1094_ = 0u;
                    phi_1096_ = type_45(type_24(vec4<f32>((f32(_e626) * _e144), (f32(_e632) * _e144), (f32(_e638) * _e144), 0f), vec4<f32>((f32(_e643) * _e144), (f32(_e647) * _e144), (f32(_e651) * _e144), 0f)), select(0u, 2147483648u, (_e93 == 0u)));
                    loop {
                        let _e661 = phi_4397_;
                        let _e663 = phi_1087_;
                        let _e665 = phi_1090_;
                        let _e667 = phi_1092_;
                        let _e669 = phi_1094_;
                        let _e671 = phi_1096_;
                        local_10 = _e663;
                        if _e667 {
                            phi_1107_ = true;
                        } else {
                            phi_1107_ = (_e669 > 0u);
                        }
                        let _e674 = phi_1107_;
                        if _e674 {
                            let _e675 = (_e665 > 0u);
                            if _e675 {
                                if _e667 {
                                    phi_1193_ = _e667;
                                    phi_1194_ = _e669;
                                    phi_1195_ = _e671;
                                } else {
                                    let _e676 = (_e669 - 1u);
                                    let _e677 = (_e676 % 128u);
                                    let _e678 = (_e677 < 128u);
                                    if _e678 {
                                    } else {
                                        phi_4595_ = true;
                                        break;
                                    }
                                    let _e680 = local_7[_e677];
                                    if _e678 {
                                    } else {
                                        phi_4595_ = true;
                                        break;
                                    }
                                    let _e682 = local_6[_e677];
                                    if _e678 {
                                    } else {
                                        phi_4595_ = true;
                                        break;
                                    }
                                    let _e684 = local_5[_e677];
                                    if _e678 {
                                    } else {
                                        phi_4595_ = true;
                                        break;
                                    }
                                    let _e686 = local_4[_e677];
                                    if _e678 {
                                    } else {
                                        phi_4595_ = true;
                                        break;
                                    }
                                    let _e688 = local_3[_e677];
                                    if _e678 {
                                    } else {
                                        phi_4595_ = true;
                                        break;
                                    }
                                    let _e690 = local_2[_e677];
                                    if _e678 {
                                    } else {
                                        phi_4595_ = true;
                                        break;
                                    }
                                    let _e695 = local_8[_e677];
                                    if _e678 {
                                    } else {
                                        phi_4595_ = true;
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
                                    let _e710 = ((_e706.member_1 & 2147483648u) != 0u);
                                    let _e711 = (_e706.member_1 & 268435455u);
                                    if _e710 {
                                        phi_1214_ = _e663;
                                        phi_1217_ = type_8(0u, ((_e706.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e718 = phi_1214_;
                                            let _e720 = phi_1217_;
                                            local_11 = _e718;
                                            if (_e720.member < _e720.member_1) {
                                                phi_1218_ = type_8((_e720.member + 1u), _e720.member_1);
                                                phi_1240_ = type_8(1u, _e720.member);
                                            } else {
                                                phi_1218_ = _e720;
                                                phi_1240_ = type_8(0u, type_8().member_1);
                                            }
                                            let _e733 = phi_1218_;
                                            let _e735 = phi_1240_;
                                            let _e739 = (bitcast<i32>(_e735.member) != 0i);
                                            if _e739 {
                                                let _e744 = (_e706.member.member_1.x - _e706.member.member.x);
                                                let _e747 = (_e706.member.member_1.y - _e706.member.member.y);
                                                let _e750 = (_e706.member.member_1.z - _e706.member.member.z);
                                                let _e752 = select(_e747, _e744, (_e744 > _e747));
                                                let _e754 = select(_e750, _e752, (_e752 > _e750));
                                                let _e756 = (_e754 < (1024f * _e144));
                                                if _e756 {
                                                    phi_1281_ = 0u;
                                                } else {
                                                    phi_1281_ = select(2u, 1u, (_e754 < (2097152f * _e144)));
                                                }
                                                let _e761 = phi_1281_;
                                                switch bitcast<i32>(_e761) {
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
                                                let _e764 = phi_1287_;
                                                switch bitcast<i32>(_e761) {
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
                                                let _e771 = phi_1297_;
                                                let _e773 = ((_e711 + (_e735.member_1 * ((3u * _e764) + 1u))) + (3u * _e771));
                                                let _e774 = (_e773 < _e96);
                                                if _e774 {
                                                    if _e774 {
                                                    } else {
                                                        phi_4391_ = true;
                                                        break;
                                                    }
                                                    let _e776 = global_6.member[_e773];
                                                    phi_1313_ = _e776;
                                                } else {
                                                    phi_1313_ = 4294967295u;
                                                }
                                                let _e778 = phi_1313_;
                                                if _e756 {
                                                    phi_1346_ = 0u;
                                                } else {
                                                    phi_1346_ = select(2u, 1u, (_e754 < (2097152f * _e144)));
                                                }
                                                let _e783 = phi_1346_;
                                                switch bitcast<i32>(_e783) {
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
                                                let _e786 = phi_1352_;
                                                let _e790 = (_e711 + (_e735.member_1 * ((3u * _e786) + 1u)));
                                                switch bitcast<i32>(_e783) {
                                                    case 0: {
                                                        let _e1065 = (_e790 < _e96);
                                                        if _e1065 {
                                                            if _e1065 {
                                                            } else {
                                                                phi_4391_ = true;
                                                                break;
                                                            }
                                                            let _e1067 = global_6.member[_e790];
                                                            phi_1379_ = _e1067;
                                                        } else {
                                                            phi_1379_ = 0u;
                                                        }
                                                        let _e1069 = phi_1379_;
                                                        let _e1071 = ((10u * _e264) & 31u);
                                                        let _e1081 = ((10u * _e263) & 31u);
                                                        let _e1091 = ((10u * _e265) & 31u);
                                                        let _e1101 = (_e790 + 1u);
                                                        let _e1102 = (_e1101 < _e96);
                                                        if _e1102 {
                                                            if _e1102 {
                                                            } else {
                                                                phi_4391_ = true;
                                                                break;
                                                            }
                                                            let _e1104 = global_6.member[_e1101];
                                                            phi_1428_ = _e1104;
                                                        } else {
                                                            phi_1428_ = 0u;
                                                        }
                                                        let _e1106 = phi_1428_;
                                                        let _e1132 = (_e790 + 2u);
                                                        let _e1133 = (_e1132 < _e96);
                                                        if _e1133 {
                                                            if _e1133 {
                                                            } else {
                                                                phi_4391_ = true;
                                                                break;
                                                            }
                                                            let _e1135 = global_6.member[_e1132];
                                                            phi_1477_ = _e1135;
                                                        } else {
                                                            phi_1477_ = 0u;
                                                        }
                                                        let _e1137 = phi_1477_;
                                                        phi_1978_ = array<array<f32, 3>, 3>(array<f32, 3>((_e706.member.member.x + ((bitcast<f32>((1258291200u | ((_e1069 >> bitcast<u32>(_e1071)) & 1023u))) - 8388608f) * _e144)), (_e706.member.member.y + ((bitcast<f32>((1258291200u | ((_e1069 >> bitcast<u32>(_e1081)) & 1023u))) - 8388608f) * _e144)), (_e706.member.member.z + ((bitcast<f32>((1258291200u | ((_e1069 >> bitcast<u32>(_e1091)) & 1023u))) - 8388608f) * _e144))), array<f32, 3>((_e706.member.member.x + ((bitcast<f32>((1258291200u | ((_e1106 >> bitcast<u32>(_e1071)) & 1023u))) - 8388608f) * _e144)), (_e706.member.member.y + ((bitcast<f32>((1258291200u | ((_e1106 >> bitcast<u32>(_e1081)) & 1023u))) - 8388608f) * _e144)), (_e706.member.member.z + ((bitcast<f32>((1258291200u | ((_e1106 >> bitcast<u32>(_e1091)) & 1023u))) - 8388608f) * _e144))), array<f32, 3>((_e706.member.member.x + ((bitcast<f32>((1258291200u | ((_e1137 >> bitcast<u32>(_e1071)) & 1023u))) - 8388608f) * _e144)), (_e706.member.member.y + ((bitcast<f32>((1258291200u | ((_e1137 >> bitcast<u32>(_e1081)) & 1023u))) - 8388608f) * _e144)), (_e706.member.member.z + ((bitcast<f32>((1258291200u | ((_e1137 >> bitcast<u32>(_e1091)) & 1023u))) - 8388608f) * _e144))));
                                                        break;
                                                    }
                                                    case 1: {
                                                        let _e879 = (_e790 < _e96);
                                                        if _e879 {
                                                            if _e879 {
                                                            } else {
                                                                phi_4391_ = true;
                                                                break;
                                                            }
                                                            let _e881 = global_6.member[_e790];
                                                            phi_1526_ = _e881;
                                                        } else {
                                                            phi_1526_ = 0u;
                                                        }
                                                        let _e883 = phi_1526_;
                                                        let _e884 = (_e790 + 1u);
                                                        let _e885 = (_e884 < _e96);
                                                        if _e885 {
                                                            if _e885 {
                                                            } else {
                                                                phi_4391_ = true;
                                                                break;
                                                            }
                                                            let _e887 = global_6.member[_e884];
                                                            phi_1541_ = _e887;
                                                        } else {
                                                            phi_1541_ = 0u;
                                                        }
                                                        let _e889 = phi_1541_;
                                                        let _e890 = (_e264 == 1u);
                                                        if _e890 {
                                                            phi_1551_ = ((_e883 >> bitcast<u32>(21i)) | (_e889 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1551_ = (_e889 >> bitcast<u32>(10i));
                                                        }
                                                        let _e899 = phi_1551_;
                                                        let _e907 = (_e263 == 1u);
                                                        if _e907 {
                                                            phi_1572_ = ((_e883 >> bitcast<u32>(21i)) | (_e889 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1572_ = (_e889 >> bitcast<u32>(10i));
                                                        }
                                                        let _e916 = phi_1572_;
                                                        let _e924 = (_e265 == 1u);
                                                        if _e924 {
                                                            phi_1593_ = ((_e883 >> bitcast<u32>(21i)) | (_e889 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1593_ = (_e889 >> bitcast<u32>(10i));
                                                        }
                                                        let _e933 = phi_1593_;
                                                        let _e942 = (_e790 + 2u);
                                                        let _e943 = (_e942 < _e96);
                                                        if _e943 {
                                                            if _e943 {
                                                            } else {
                                                                phi_4391_ = true;
                                                                break;
                                                            }
                                                            let _e945 = global_6.member[_e942];
                                                            phi_1623_ = _e945;
                                                        } else {
                                                            phi_1623_ = 0u;
                                                        }
                                                        let _e947 = phi_1623_;
                                                        let _e948 = (_e790 + 3u);
                                                        let _e949 = (_e948 < _e96);
                                                        if _e949 {
                                                            if _e949 {
                                                            } else {
                                                                phi_4391_ = true;
                                                                break;
                                                            }
                                                            let _e951 = global_6.member[_e948];
                                                            phi_1638_ = _e951;
                                                        } else {
                                                            phi_1638_ = 0u;
                                                        }
                                                        let _e953 = phi_1638_;
                                                        if _e890 {
                                                            phi_1648_ = ((_e947 >> bitcast<u32>(21i)) | (_e953 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1648_ = (_e953 >> bitcast<u32>(10i));
                                                        }
                                                        let _e962 = phi_1648_;
                                                        if _e907 {
                                                            phi_1669_ = ((_e947 >> bitcast<u32>(21i)) | (_e953 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1669_ = (_e953 >> bitcast<u32>(10i));
                                                        }
                                                        let _e978 = phi_1669_;
                                                        if _e924 {
                                                            phi_1690_ = ((_e947 >> bitcast<u32>(21i)) | (_e953 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1690_ = (_e953 >> bitcast<u32>(10i));
                                                        }
                                                        let _e994 = phi_1690_;
                                                        let _e1003 = (_e790 + 4u);
                                                        let _e1004 = (_e1003 < _e96);
                                                        if _e1004 {
                                                            if _e1004 {
                                                            } else {
                                                                phi_4391_ = true;
                                                                break;
                                                            }
                                                            let _e1006 = global_6.member[_e1003];
                                                            phi_1720_ = _e1006;
                                                        } else {
                                                            phi_1720_ = 0u;
                                                        }
                                                        let _e1008 = phi_1720_;
                                                        let _e1009 = (_e790 + 5u);
                                                        let _e1010 = (_e1009 < _e96);
                                                        if _e1010 {
                                                            if _e1010 {
                                                            } else {
                                                                phi_4391_ = true;
                                                                break;
                                                            }
                                                            let _e1012 = global_6.member[_e1009];
                                                            phi_1735_ = _e1012;
                                                        } else {
                                                            phi_1735_ = 0u;
                                                        }
                                                        let _e1014 = phi_1735_;
                                                        if _e890 {
                                                            phi_1745_ = ((_e1008 >> bitcast<u32>(21i)) | (_e1014 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1745_ = (_e1014 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1023 = phi_1745_;
                                                        if _e907 {
                                                            phi_1766_ = ((_e1008 >> bitcast<u32>(21i)) | (_e1014 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1766_ = (_e1014 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1039 = phi_1766_;
                                                        if _e924 {
                                                            phi_1787_ = ((_e1008 >> bitcast<u32>(21i)) | (_e1014 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1787_ = (_e1014 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1055 = phi_1787_;
                                                        phi_1978_ = array<array<f32, 3>, 3>(array<f32, 3>((_e706.member.member.x + ((bitcast<f32>((1258291200u | (select(_e899, _e883, _e303) & 2097151u))) - 8388608f) * _e144)), (_e706.member.member.y + ((bitcast<f32>((1258291200u | (select(_e916, _e883, _e372) & 2097151u))) - 8388608f) * _e144)), (_e706.member.member.z + ((bitcast<f32>((1258291200u | (select(_e933, _e883, _e440) & 2097151u))) - 8388608f) * _e144))), array<f32, 3>((_e706.member.member.x + ((bitcast<f32>((1258291200u | (select(_e962, _e947, _e303) & 2097151u))) - 8388608f) * _e144)), (_e706.member.member.y + ((bitcast<f32>((1258291200u | (select(_e978, _e947, _e372) & 2097151u))) - 8388608f) * _e144)), (_e706.member.member.z + ((bitcast<f32>((1258291200u | (select(_e994, _e947, _e440) & 2097151u))) - 8388608f) * _e144))), array<f32, 3>((_e706.member.member.x + ((bitcast<f32>((1258291200u | (select(_e1023, _e1008, _e303) & 2097151u))) - 8388608f) * _e144)), (_e706.member.member.y + ((bitcast<f32>((1258291200u | (select(_e1039, _e1008, _e372) & 2097151u))) - 8388608f) * _e144)), (_e706.member.member.z + ((bitcast<f32>((1258291200u | (select(_e1055, _e1008, _e440) & 2097151u))) - 8388608f) * _e144))));
                                                        break;
                                                    }
                                                    case 2: {
                                                        let _e792 = (_e790 + _e264);
                                                        let _e793 = (_e792 < _e96);
                                                        if _e793 {
                                                            if _e793 {
                                                            } else {
                                                                phi_4391_ = true;
                                                                break;
                                                            }
                                                            let _e795 = global_6.member[_e792];
                                                            phi_1818_ = _e795;
                                                        } else {
                                                            phi_1818_ = 0u;
                                                        }
                                                        let _e797 = phi_1818_;
                                                        let _e801 = (_e790 + _e263);
                                                        let _e802 = (_e801 < _e96);
                                                        if _e802 {
                                                            if _e802 {
                                                            } else {
                                                                phi_4391_ = true;
                                                                break;
                                                            }
                                                            let _e804 = global_6.member[_e801];
                                                            phi_1836_ = _e804;
                                                        } else {
                                                            phi_1836_ = 0u;
                                                        }
                                                        let _e806 = phi_1836_;
                                                        let _e810 = (_e790 + _e265);
                                                        let _e811 = (_e810 < _e96);
                                                        if _e811 {
                                                            if _e811 {
                                                            } else {
                                                                phi_4391_ = true;
                                                                break;
                                                            }
                                                            let _e813 = global_6.member[_e810];
                                                            phi_1854_ = _e813;
                                                        } else {
                                                            phi_1854_ = 0u;
                                                        }
                                                        let _e815 = phi_1854_;
                                                        let _e820 = (_e790 + 3u);
                                                        let _e821 = (_e820 + _e264);
                                                        let _e822 = (_e821 < _e96);
                                                        if _e822 {
                                                            if _e822 {
                                                            } else {
                                                                phi_4391_ = true;
                                                                break;
                                                            }
                                                            let _e824 = global_6.member[_e821];
                                                            phi_1877_ = _e824;
                                                        } else {
                                                            phi_1877_ = 0u;
                                                        }
                                                        let _e826 = phi_1877_;
                                                        let _e830 = (_e820 + _e263);
                                                        let _e831 = (_e830 < _e96);
                                                        if _e831 {
                                                            if _e831 {
                                                            } else {
                                                                phi_4391_ = true;
                                                                break;
                                                            }
                                                            let _e833 = global_6.member[_e830];
                                                            phi_1895_ = _e833;
                                                        } else {
                                                            phi_1895_ = 0u;
                                                        }
                                                        let _e835 = phi_1895_;
                                                        let _e839 = (_e820 + _e265);
                                                        let _e840 = (_e839 < _e96);
                                                        if _e840 {
                                                            if _e840 {
                                                            } else {
                                                                phi_4391_ = true;
                                                                break;
                                                            }
                                                            let _e842 = global_6.member[_e839];
                                                            phi_1913_ = _e842;
                                                        } else {
                                                            phi_1913_ = 0u;
                                                        }
                                                        let _e844 = phi_1913_;
                                                        let _e849 = (_e790 + 6u);
                                                        let _e850 = (_e849 + _e264);
                                                        let _e851 = (_e850 < _e96);
                                                        if _e851 {
                                                            if _e851 {
                                                            } else {
                                                                phi_4391_ = true;
                                                                break;
                                                            }
                                                            let _e853 = global_6.member[_e850];
                                                            phi_1936_ = _e853;
                                                        } else {
                                                            phi_1936_ = 0u;
                                                        }
                                                        let _e855 = phi_1936_;
                                                        let _e859 = (_e849 + _e263);
                                                        let _e860 = (_e859 < _e96);
                                                        if _e860 {
                                                            if _e860 {
                                                            } else {
                                                                phi_4391_ = true;
                                                                break;
                                                            }
                                                            let _e862 = global_6.member[_e859];
                                                            phi_1954_ = _e862;
                                                        } else {
                                                            phi_1954_ = 0u;
                                                        }
                                                        let _e864 = phi_1954_;
                                                        let _e868 = (_e849 + _e265);
                                                        let _e869 = (_e868 < _e96);
                                                        if _e869 {
                                                            if _e869 {
                                                            } else {
                                                                phi_4391_ = true;
                                                                break;
                                                            }
                                                            let _e871 = global_6.member[_e868];
                                                            phi_1972_ = _e871;
                                                        } else {
                                                            phi_1972_ = 0u;
                                                        }
                                                        let _e873 = phi_1972_;
                                                        phi_1978_ = array<array<f32, 3>, 3>(array<f32, 3>((f32(bitcast<i32>(_e797)) * _e144), (f32(bitcast<i32>(_e806)) * _e144), (f32(bitcast<i32>(_e815)) * _e144)), array<f32, 3>((f32(bitcast<i32>(_e826)) * _e144), (f32(bitcast<i32>(_e835)) * _e144), (f32(bitcast<i32>(_e844)) * _e144)), array<f32, 3>((f32(bitcast<i32>(_e855)) * _e144), (f32(bitcast<i32>(_e864)) * _e144), (f32(bitcast<i32>(_e873)) * _e144)));
                                                        break;
                                                    }
                                                    default: {
                                                        phi_1978_ = array<array<f32, 3>, 3>();
                                                        break;
                                                    }
                                                }
                                                let _e1165 = phi_1978_;
                                                let _e1173 = (_e1165[0][2] - _e465);
                                                let _e1176 = (((_e1165[0][0] - _e328) * _e504) - (_e1173 * _e368));
                                                let _e1179 = (((_e1165[0][1] - _e397) * _e504) - (_e1173 * _e436));
                                                let _e1186 = (_e1165[1][2] - _e465);
                                                let _e1189 = (((_e1165[1][0] - _e328) * _e504) - (_e1186 * _e368));
                                                let _e1192 = (((_e1165[1][1] - _e397) * _e504) - (_e1186 * _e436));
                                                let _e1199 = (_e1165[2][2] - _e465);
                                                let _e1202 = (((_e1165[2][0] - _e328) * _e504) - (_e1199 * _e368));
                                                let _e1205 = (((_e1165[2][1] - _e397) * _e504) - (_e1199 * _e436));
                                                let _e1206 = (_e1202 * _e1192);
                                                let _e1207 = (_e1205 * _e1189);
                                                let _e1208 = (_e1176 * _e1205);
                                                let _e1209 = (_e1179 * _e1202);
                                                let _e1210 = (_e1189 * _e1179);
                                                let _e1211 = (_e1192 * _e1176);
                                                let _e1216 = (((_e1206 >= _e1207) && (_e1208 >= _e1209)) && (_e1210 >= _e1211));
                                                if (_e1216 || (((_e1206 <= _e1207) && (_e1208 <= _e1209)) && (_e1210 <= _e1211))) {
                                                    let _e1223 = select(-1f, 1f, _e1216);
                                                    let _e1225 = ((_e1206 - _e1207) * _e1223);
                                                    let _e1227 = select(0f, _e1225, (_e1225 > 0f));
                                                    let _e1229 = ((_e1208 - _e1209) * _e1223);
                                                    let _e1231 = select(0f, _e1229, (_e1229 > 0f));
                                                    let _e1233 = ((_e1210 - _e1211) * _e1223);
                                                    let _e1235 = select(0f, _e1233, (_e1233 > 0f));
                                                    let _e1237 = ((_e1227 + _e1231) + _e1235);
                                                    if (_e1237 < 0.000000000000000000000000000000000000011754944f) {
                                                        phi_2862_ = type_20();
                                                        phi_2863_ = true;
                                                        phi_2864_ = false;
                                                    } else {
                                                        let _e1240 = select(_e1189, _e1176, (_e1176 < _e1189));
                                                        if (select(_e1202, _e1240, (_e1240 < _e1202)) > 0f) {
                                                            phi_2130_ = true;
                                                        } else {
                                                            let _e1245 = select(_e1189, _e1176, (_e1176 > _e1189));
                                                            phi_2130_ = (select(_e1202, _e1245, (_e1245 > _e1202)) < 0f);
                                                        }
                                                        let _e1250 = phi_2130_;
                                                        if _e1250 {
                                                            phi_2859_ = type_20();
                                                            phi_2860_ = true;
                                                            phi_2861_ = false;
                                                        } else {
                                                            let _e1252 = select(_e1192, _e1179, (_e1179 < _e1192));
                                                            if (select(_e1205, _e1252, (_e1252 < _e1205)) > 0f) {
                                                                phi_2159_ = true;
                                                            } else {
                                                                let _e1257 = select(_e1192, _e1179, (_e1179 > _e1192));
                                                                phi_2159_ = (select(_e1205, _e1257, (_e1257 > _e1205)) < 0f);
                                                            }
                                                            let _e1262 = phi_2159_;
                                                            if _e1262 {
                                                                phi_2857_ = type_20();
                                                                phi_2858_ = false;
                                                            } else {
                                                                let _e1264 = select(_e1165[1][0], _e1165[0][0], (_e1165[0][0] < _e1165[1][0]));
                                                                let _e1268 = select(_e1165[1][0], _e1165[0][0], (_e1165[0][0] > _e1165[1][0]));
                                                                let _e1272 = select(_e1165[1][1], _e1165[0][1], (_e1165[0][1] < _e1165[1][1]));
                                                                let _e1276 = select(_e1165[1][1], _e1165[0][1], (_e1165[0][1] > _e1165[1][1]));
                                                                let _e1280 = select(_e1165[1][2], _e1165[0][2], (_e1165[0][2] < _e1165[1][2]));
                                                                let _e1284 = select(_e1165[1][2], _e1165[0][2], (_e1165[0][2] > _e1165[1][2]));
                                                                let _e1289 = ((select(_e1165[2][0], _e1264, (_e1264 < _e1165[2][0])) - _e366) * _e371);
                                                                let _e1290 = ((select(_e1165[2][0], _e1268, (_e1268 > _e1165[2][0])) - _e367) * _e371);
                                                                let _e1293 = ((select(_e1165[2][1], _e1272, (_e1272 < _e1165[2][1])) - _e434) * _e439);
                                                                let _e1294 = ((select(_e1165[2][1], _e1276, (_e1276 > _e1165[2][1])) - _e435) * _e439);
                                                                let _e1297 = ((select(_e1165[2][2], _e1280, (_e1280 < _e1165[2][2])) - _e502) * _e507);
                                                                let _e1298 = ((select(_e1165[2][2], _e1284, (_e1284 > _e1165[2][2])) - _e503) * _e507);
                                                                let _e1300 = select(_e1298, _e1297, (_e1297 < _e1298));
                                                                let _e1302 = select(_e1298, _e1297, (_e1297 > _e1298));
                                                                let _e1304 = select(_e1290, _e1289, (_e1289 < _e1290));
                                                                let _e1306 = select(_e1294, _e1293, (_e1293 < _e1294));
                                                                let _e1308 = select(_e1306, _e1304, (_e1304 > _e1306));
                                                                let _e1310 = select(_e1300, _e1308, (_e1308 > _e1300));
                                                                let _e1312 = select(_e1290, _e1289, (_e1289 > _e1290));
                                                                let _e1314 = select(_e1294, _e1293, (_e1293 > _e1294));
                                                                let _e1316 = select(_e1314, _e1312, (_e1312 < _e1314));
                                                                let _e1318 = select(_e1302, _e1316, (_e1316 < _e1302));
                                                                let _e1319 = -(_e1300);
                                                                let _e1325 = select(_e619, _e1310, (_e1310 > _e619));
                                                                if (_e1325 > (_e1318 + (select(_e1319, _e1302, (_e1302 > _e1319)) * 0.0000019073523f))) {
                                                                    phi_2852_ = type_20();
                                                                    phi_2853_ = true;
                                                                } else {
                                                                    let _e1327 = (_e1325 > _e718.member);
                                                                    if _e1327 {
                                                                        phi_2851_ = type_20();
                                                                    } else {
                                                                        let _e1328 = vec3<f32>(_e1165[0][0], _e1165[0][1], _e1165[0][2]);
                                                                        let _e1329 = vec3<f32>(_e1165[1][0], _e1165[1][1], _e1165[1][2]);
                                                                        let _e1330 = vec3<f32>(_e1165[2][0], _e1165[2][1], _e1165[2][2]);
                                                                        let _e1331 = (_e1165[1][0] - _e1165[0][0]);
                                                                        let _e1332 = (_e1165[1][1] - _e1165[0][1]);
                                                                        let _e1333 = (_e1165[1][2] - _e1165[0][2]);
                                                                        let _e1334 = vec3<f32>(_e1331, _e1332, _e1333);
                                                                        let _e1335 = (_e1165[2][0] - _e1165[1][0]);
                                                                        let _e1336 = (_e1165[2][1] - _e1165[1][1]);
                                                                        let _e1337 = (_e1165[2][2] - _e1165[1][2]);
                                                                        let _e1338 = vec3<f32>(_e1335, _e1336, _e1337);
                                                                        let _e1339 = (_e1165[0][0] - _e1165[2][0]);
                                                                        let _e1340 = (_e1165[0][1] - _e1165[2][1]);
                                                                        let _e1341 = (_e1165[0][2] - _e1165[2][2]);
                                                                        let _e1342 = vec3<f32>(_e1339, _e1340, _e1341);
                                                                        let _e1345 = bitcast<f32>((bitcast<u32>(_e1331) & 2147483647u));
                                                                        let _e1348 = bitcast<f32>((bitcast<u32>(_e1332) & 2147483647u));
                                                                        let _e1350 = select(_e1348, _e1345, (_e1345 > _e1348));
                                                                        let _e1353 = bitcast<f32>((bitcast<u32>(_e1333) & 2147483647u));
                                                                        let _e1355 = select(_e1353, _e1350, (_e1350 > _e1353));
                                                                        let _e1358 = bitcast<f32>((bitcast<u32>(_e1335) & 2147483647u));
                                                                        let _e1361 = bitcast<f32>((bitcast<u32>(_e1336) & 2147483647u));
                                                                        let _e1363 = select(_e1361, _e1358, (_e1358 > _e1361));
                                                                        let _e1366 = bitcast<f32>((bitcast<u32>(_e1337) & 2147483647u));
                                                                        let _e1368 = select(_e1366, _e1363, (_e1363 > _e1366));
                                                                        let _e1371 = bitcast<f32>((bitcast<u32>(_e1339) & 2147483647u));
                                                                        let _e1374 = bitcast<f32>((bitcast<u32>(_e1340) & 2147483647u));
                                                                        let _e1376 = select(_e1374, _e1371, (_e1371 > _e1374));
                                                                        let _e1379 = bitcast<f32>((bitcast<u32>(_e1341) & 2147483647u));
                                                                        let _e1381 = select(_e1379, _e1376, (_e1376 > _e1379));
                                                                        let _e1383 = select(_e1368, _e1355, (_e1355 > _e1368));
                                                                        let _e1385 = select(_e1381, _e1383, (_e1383 > _e1381));
                                                                        if (_e1355 == _e1385) {
                                                                            phi_2578_ = _e1192;
                                                                            phi_2579_ = _e1189;
                                                                            phi_2580_ = _e1179;
                                                                            phi_2581_ = _e1176;
                                                                            phi_2582_ = _e1328;
                                                                            phi_2583_ = _e1342;
                                                                            phi_2584_ = _e1338;
                                                                            phi_2585_ = _e1334;
                                                                        } else {
                                                                            let _e1387 = (_e1368 == _e1385);
                                                                            let _e1392 = vec3(_e1387);
                                                                            phi_2578_ = select(_e1179, _e1205, _e1387);
                                                                            phi_2579_ = select(_e1176, _e1202, _e1387);
                                                                            phi_2580_ = select(_e1205, _e1192, _e1387);
                                                                            phi_2581_ = select(_e1202, _e1189, _e1387);
                                                                            phi_2582_ = select(_e1330, _e1329, _e1392);
                                                                            phi_2583_ = select(_e1338, _e1334, _e1392);
                                                                            phi_2584_ = select(_e1334, _e1342, _e1392);
                                                                            phi_2585_ = select(_e1342, _e1338, _e1392);
                                                                        }
                                                                        let _e1398 = phi_2578_;
                                                                        let _e1400 = phi_2579_;
                                                                        let _e1402 = phi_2580_;
                                                                        let _e1404 = phi_2581_;
                                                                        let _e1406 = phi_2582_;
                                                                        let _e1408 = phi_2583_;
                                                                        let _e1410 = phi_2584_;
                                                                        let _e1412 = phi_2585_;
                                                                        let _e1419 = ((_e1410.y * _e1408.z) - (_e1408.y * _e1410.z));
                                                                        let _e1424 = ((_e1410.z * _e1408.x) - (_e1408.z * _e1410.x));
                                                                        let _e1427 = ((_e1410.x * _e1408.y) - (_e1408.x * _e1410.y));
                                                                        if (_e1227 >= _e1231) {
                                                                            phi_2622_ = select(true, false, (_e1227 >= _e1235));
                                                                        } else {
                                                                            phi_2622_ = true;
                                                                        }
                                                                        let _e1432 = phi_2622_;
                                                                        if _e1432 {
                                                                            phi_2631_ = select(_e1330, _e1329, vec3((_e1231 >= _e1235)));
                                                                        } else {
                                                                            phi_2631_ = _e1328;
                                                                        }
                                                                        let _e1437 = phi_2631_;
                                                                        let _e1448 = (((_e1419 * (_e1437.x - _e328)) + (_e1424 * (_e1437.y - _e397))) + (_e1427 * (_e1437.z - _e465)));
                                                                        let _e1453 = (((_e1419 * _e368) + (_e1424 * _e436)) + (_e1427 * _e504));
                                                                        let _e1454 = (_e1400 - _e1404);
                                                                        let _e1455 = (_e1398 - _e1402);
                                                                        let _e1463 = (-(((_e1404 * _e1454) + (_e1402 * _e1455))) / ((_e1454 * _e1454) + (_e1455 * _e1455)));
                                                                        let _e1465 = select(1f, _e1463, (_e1463 < 1f));
                                                                        let _e1467 = select(0f, _e1465, (_e1465 > 0f));
                                                                        let _e1480 = ((_e1406.x + (_e1412.x * _e1467)) - _e328);
                                                                        let _e1481 = ((_e1406.y + (_e1412.y * _e1467)) - _e397);
                                                                        let _e1482 = ((_e1406.z + (_e1412.z * _e1467)) - _e465);
                                                                        let _e1483 = (_e1482 / _e504);
                                                                        let _e1495 = bitcast<f32>((bitcast<u32>(_e1480) & 2147483647u));
                                                                        let _e1498 = bitcast<f32>((bitcast<u32>(_e1481) & 2147483647u));
                                                                        let _e1500 = select(_e1498, _e1495, (_e1495 > _e1498));
                                                                        let _e1503 = bitcast<f32>((bitcast<u32>(_e1482) & 2147483647u));
                                                                        let _e1505 = select(_e1503, _e1500, (_e1500 > _e1503));
                                                                        let _e1511 = bitcast<f32>((bitcast<u32>(_e1419) & 2147483647u));
                                                                        let _e1514 = bitcast<f32>((bitcast<u32>(_e1424) & 2147483647u));
                                                                        let _e1516 = select(_e1514, _e1511, (_e1511 > _e1514));
                                                                        let _e1519 = bitcast<f32>((bitcast<u32>(_e1427) & 2147483647u));
                                                                        if (bitcast<f32>((bitcast<u32>(((((_e1419 * _e1480) + (_e1424 * _e1481)) + (_e1427 * _e1482)) - _e1448)) & 2147483647u)) <= ((0.0000009536743f * select(_e1385, _e1505, (_e1505 > _e1385))) * select(_e1519, _e1516, (_e1516 > _e1519)))) {
                                                                            let _e1529 = bitcast<f32>((bitcast<u32>(_e1410.x) & 2147483647u));
                                                                            let _e1532 = bitcast<f32>((bitcast<u32>(_e1410.y) & 2147483647u));
                                                                            let _e1534 = select(_e1532, _e1529, (_e1529 > _e1532));
                                                                            let _e1537 = bitcast<f32>((bitcast<u32>(_e1410.z) & 2147483647u));
                                                                            let _e1543 = bitcast<f32>((bitcast<u32>(_e1408.x) & 2147483647u));
                                                                            let _e1546 = bitcast<f32>((bitcast<u32>(_e1408.y) & 2147483647u));
                                                                            let _e1548 = select(_e1546, _e1543, (_e1543 > _e1546));
                                                                            let _e1551 = bitcast<f32>((bitcast<u32>(_e1408.z) & 2147483647u));
                                                                            let _e1555 = (bitcast<f32>((bitcast<u32>(_e1453) & 2147483647u)) > ((0.0000038146973f * select(_e1537, _e1534, (_e1534 > _e1537))) * select(_e1551, _e1548, (_e1548 > _e1551))));
                                                                            if _e1555 {
                                                                                phi_2796_ = (_e1448 / _e1453);
                                                                            } else {
                                                                                phi_2796_ = f32();
                                                                            }
                                                                            let _e1558 = phi_2796_;
                                                                            phi_2798_ = _e1558;
                                                                            phi_2799_ = select(true, false, _e1555);
                                                                        } else {
                                                                            phi_2798_ = f32();
                                                                            phi_2799_ = true;
                                                                        }
                                                                        let _e1561 = phi_2798_;
                                                                        let _e1563 = phi_2799_;
                                                                        if _e1563 {
                                                                            let _e1571 = (((_e1419 * (_e1480 - (_e368 * _e1483))) + (_e1424 * (_e1481 - (_e436 * _e1483)))) / _e1453);
                                                                            if (bitcast<f32>((bitcast<u32>(_e1571) & 2147483647u)) <= _e1385) {
                                                                                phi_2819_ = (_e1483 + _e1571);
                                                                            } else {
                                                                                phi_2819_ = _e1483;
                                                                            }
                                                                            let _e1578 = phi_2819_;
                                                                            phi_2820_ = _e1578;
                                                                        } else {
                                                                            phi_2820_ = _e1561;
                                                                        }
                                                                        let _e1580 = phi_2820_;
                                                                        let _e1582 = select(_e1318, _e1580, (_e1580 < _e1318));
                                                                        let _e1584 = select(_e1310, _e1582, (_e1582 > _e1310));
                                                                        if (_e1584 >= _e619) {
                                                                            let _e1586 = (_e1584 <= _e718.member);
                                                                            if _e1586 {
                                                                                let _e1587 = (1f / _e1237);
                                                                                phi_2843_ = type_20(_e1584, (_e1231 * _e1587), (_e1235 * _e1587), _e778);
                                                                            } else {
                                                                                phi_2843_ = type_20();
                                                                            }
                                                                            let _e1592 = phi_2843_;
                                                                            phi_2845_ = _e1592;
                                                                            phi_2846_ = select(true, false, _e1586);
                                                                        } else {
                                                                            phi_2845_ = type_20();
                                                                            phi_2846_ = true;
                                                                        }
                                                                        let _e1595 = phi_2845_;
                                                                        let _e1597 = phi_2846_;
                                                                        if _e1597 {
                                                                            phi_2850_ = type_20(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                        } else {
                                                                            phi_2850_ = _e1595;
                                                                        }
                                                                        let _e1599 = phi_2850_;
                                                                        phi_2851_ = _e1599;
                                                                    }
                                                                    let _e1601 = phi_2851_;
                                                                    phi_2852_ = _e1601;
                                                                    phi_2853_ = _e1327;
                                                                }
                                                                let _e1603 = phi_2852_;
                                                                let _e1605 = phi_2853_;
                                                                phi_2857_ = _e1603;
                                                                phi_2858_ = _e1605;
                                                            }
                                                            let _e1607 = phi_2857_;
                                                            let _e1609 = phi_2858_;
                                                            phi_2859_ = _e1607;
                                                            phi_2860_ = _e1262;
                                                            phi_2861_ = _e1609;
                                                        }
                                                        let _e1611 = phi_2859_;
                                                        let _e1613 = phi_2860_;
                                                        let _e1615 = phi_2861_;
                                                        phi_2862_ = _e1611;
                                                        phi_2863_ = _e1613;
                                                        phi_2864_ = _e1615;
                                                    }
                                                    let _e1617 = phi_2862_;
                                                    let _e1619 = phi_2863_;
                                                    let _e1621 = phi_2864_;
                                                    phi_2872_ = _e1617;
                                                    phi_2873_ = select(_e1621, true, _e1619);
                                                } else {
                                                    phi_2872_ = type_20();
                                                    phi_2873_ = true;
                                                }
                                                let _e1624 = phi_2872_;
                                                let _e1626 = phi_2873_;
                                                if _e1626 {
                                                    phi_2877_ = type_20(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                } else {
                                                    phi_2877_ = _e1624;
                                                }
                                                let _e1628 = phi_2877_;
                                                if (_e1628.member_3 != 4294967295u) {
                                                    if (_e778 != 4294967295u) {
                                                        phi_2888_ = type_34(_e718.member, true);
                                                    } else {
                                                        phi_2888_ = _e718;
                                                    }
                                                    let _e1636 = phi_2888_;
                                                    phi_2889_ = _e1636;
                                                } else {
                                                    phi_2889_ = _e718;
                                                }
                                                let _e1638 = phi_2889_;
                                                phi_1215_ = _e1638;
                                            } else {
                                                phi_1215_ = type_34();
                                            }
                                            let _e1640 = phi_1215_;
                                            continue;
                                            continuing {
                                                phi_1214_ = _e1640;
                                                phi_1217_ = _e733;
                                                phi_4391_ = _e661;
                                                break if !(_e739);
                                            }
                                        }
                                        let _e1643 = phi_4391_;
                                        phi_4595_ = _e1643;
                                        if _e1643 {
                                            break;
                                        }
                                        phi_4686_ = _e1643;
                                        let _e2309 = local_11;
                                        phi_2890_ = _e2309;
                                    } else {
                                        phi_4686_ = _e661;
                                        phi_2890_ = _e663;
                                    }
                                    let _e1645 = phi_4686_;
                                    let _e1647 = phi_2890_;
                                    if _e710 {
                                        phi_4155_ = bool();
                                        phi_4156_ = u32();
                                        phi_4157_ = type_45();
                                    } else {
                                        if (_e706.member_1 >= _e93) {
                                            phi_3691_ = type_46(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), type_45(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u), type_45(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u));
                                        } else {
                                            if (_e706.member_1 < _e93) {
                                            } else {
                                                phi_4595_ = true;
                                                break;
                                            }
                                            let _e1650 = (_e264 * 2u);
                                            let _e1652 = ((1u + _e1650) % 7u);
                                            if (_e1652 < 7u) {
                                            } else {
                                                phi_4595_ = true;
                                                break;
                                            }
                                            let _e1657 = global_5.member[_e706.member_1][_e1652];
                                            let _e1659 = ((_e1650 + 2u) % 7u);
                                            if (_e1659 < 7u) {
                                            } else {
                                                phi_4595_ = true;
                                                break;
                                            }
                                            let _e1664 = global_5.member[_e706.member_1][_e1659];
                                            let _e1665 = (_e263 * 2u);
                                            let _e1667 = ((1u + _e1665) % 7u);
                                            if (_e1667 < 7u) {
                                            } else {
                                                phi_4595_ = true;
                                                break;
                                            }
                                            let _e1672 = global_5.member[_e706.member_1][_e1667];
                                            let _e1674 = ((_e1665 + 2u) % 7u);
                                            if (_e1674 < 7u) {
                                            } else {
                                                phi_4595_ = true;
                                                break;
                                            }
                                            let _e1679 = global_5.member[_e706.member_1][_e1674];
                                            let _e1680 = (_e265 * 2u);
                                            let _e1682 = ((1u + _e1680) % 7u);
                                            if (_e1682 < 7u) {
                                            } else {
                                                phi_4595_ = true;
                                                break;
                                            }
                                            let _e1687 = global_5.member[_e706.member_1][_e1682];
                                            let _e1689 = ((_e1680 + 2u) % 7u);
                                            if (_e1689 < 7u) {
                                            } else {
                                                phi_4595_ = true;
                                                break;
                                            }
                                            let _e1694 = global_5.member[_e706.member_1][_e1689];
                                            let _e1717 = (bitcast<f32>((bitcast<u32>((_e706.member.member_1.x - _e706.member.member.x)) & 2139095040u)) * 0.0000009536743f);
                                            let _e1718 = (bitcast<f32>((bitcast<u32>((_e706.member.member_1.y - _e706.member.member.y)) & 2139095040u)) * 0.0000009536743f);
                                            let _e1719 = (bitcast<f32>((bitcast<u32>((_e706.member.member_1.z - _e706.member.member.z)) & 2139095040u)) * 0.0000009536743f);
                                            let _e1721 = select(_e144, _e1717, (_e1717 > _e144));
                                            let _e1723 = select(_e144, _e1718, (_e1718 > _e144));
                                            let _e1725 = select(_e144, _e1719, (_e1719 > _e144));
                                            let _e1756 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1657 & 2097151u))) - 8388608f) * _e1721));
                                            let _e1761 = (bitcast<i32>((_e1657 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e1764 = bitcast<f32>((_e1756 & bitcast<u32>(_e1761)));
                                            let _e1765 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1672 & 2097151u))) - 8388608f) * _e1723));
                                            let _e1770 = (bitcast<i32>((_e1672 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e1773 = bitcast<f32>((_e1765 & bitcast<u32>(_e1770)));
                                            let _e1774 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1687 & 2097151u))) - 8388608f) * _e1725));
                                            let _e1779 = (bitcast<i32>((_e1687 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e1782 = bitcast<f32>((_e1774 & bitcast<u32>(_e1779)));
                                            let _e1786 = bitcast<f32>((_e1756 & bitcast<u32>(~(_e1761))));
                                            let _e1790 = bitcast<f32>((_e1765 & bitcast<u32>(~(_e1770))));
                                            let _e1794 = bitcast<f32>((_e1774 & bitcast<u32>(~(_e1779))));
                                            let _e1795 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1664 & 2097151u))) - 8388608f) * _e1721));
                                            let _e1800 = (bitcast<i32>((_e1664 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e1803 = bitcast<f32>((_e1795 & bitcast<u32>(_e1800)));
                                            let _e1804 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1679 & 2097151u))) - 8388608f) * _e1723));
                                            let _e1809 = (bitcast<i32>((_e1679 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e1812 = bitcast<f32>((_e1804 & bitcast<u32>(_e1809)));
                                            let _e1813 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1694 & 2097151u))) - 8388608f) * _e1725));
                                            let _e1818 = (bitcast<i32>((_e1694 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e1821 = bitcast<f32>((_e1813 & bitcast<u32>(_e1818)));
                                            let _e1825 = bitcast<f32>((_e1795 & bitcast<u32>(~(_e1800))));
                                            let _e1829 = bitcast<f32>((_e1804 & bitcast<u32>(~(_e1809))));
                                            let _e1833 = bitcast<f32>((_e1813 & bitcast<u32>(~(_e1818))));
                                            let _e1834 = (_e706.member.member.x + _e1764);
                                            let _e1835 = (_e706.member.member.y + _e1773);
                                            let _e1836 = (_e706.member.member.z + _e1782);
                                            let _e1839 = (_e706.member.member_1.x - _e1803);
                                            let _e1840 = (_e706.member.member_1.y - _e1812);
                                            let _e1841 = (_e706.member.member_1.z - _e1821);
                                            let _e1860 = (_e1839 - _e1834);
                                            let _e1861 = (_e1840 - _e1835);
                                            let _e1862 = (_e1841 - _e1836);
                                            let _e1864 = select(_e1861, _e1860, (_e1860 > _e1861));
                                            let _e1866 = select(_e1862, _e1864, (_e1864 > _e1862));
                                            if (_e1866 < (1024f * _e144)) {
                                                phi_3392_ = 0u;
                                            } else {
                                                phi_3392_ = select(2u, 1u, (_e1866 < (2097152f * _e144)));
                                            }
                                            let _e1873 = phi_3392_;
                                            switch bitcast<i32>(_e1873) {
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
                                            let _e1876 = phi_3398_;
                                            let _e1882 = global_5.member[_e706.member_1][0u];
                                            let _e1886 = global_5.member[_e706.member_1][2u];
                                            let _e1890 = global_5.member[_e706.member_1][4u];
                                            let _e1894 = global_5.member[_e706.member_1][6u];
                                            let _e1906 = (((_e1886 >> bitcast<u32>(22i)) | ((_e1890 >> bitcast<u32>(22i)) << bitcast<u32>(10i))) | ((_e1894 >> bitcast<u32>(22i)) << bitcast<u32>(20i)));
                                            let _e1907 = (_e1882 & 268435455u);
                                            let _e1908 = (_e1906 & 268435455u);
                                            let _e1911 = ((_e1882 >> bitcast<u32>(28u)) & 7u);
                                            let _e1919 = ((_e1882 >> bitcast<u32>(31i)) | (((_e1906 >> bitcast<u32>(28u)) & 3u) << bitcast<u32>(1i)));
                                            let _e1920 = (_e1911 != 0u);
                                            if (_e1911 == 0u) {
                                                phi_3653_ = _e1907;
                                            } else {
                                                if (_e1911 == 7u) {
                                                    phi_3652_ = 2147483648u;
                                                } else {
                                                    phi_3652_ = ((2147483648u | (_e1911 << bitcast<u32>(28u))) | (_e1908 & 268435455u));
                                                }
                                                let _e1929 = phi_3652_;
                                                phi_3653_ = _e1929;
                                            }
                                            let _e1931 = phi_3653_;
                                            if _e1920 {
                                                let _e1932 = (_e1911 != 7u);
                                                if _e1932 {
                                                    phi_3663_ = (_e1908 + (_e1911 * ((3u * _e1876) + 1u)));
                                                } else {
                                                    phi_3663_ = u32();
                                                }
                                                let _e1936 = phi_3663_;
                                                phi_3665_ = _e1936;
                                                phi_3666_ = select(true, false, _e1932);
                                            } else {
                                                phi_3665_ = u32();
                                                phi_3666_ = true;
                                            }
                                            let _e1939 = phi_3665_;
                                            let _e1941 = phi_3666_;
                                            if (_e1919 == 0u) {
                                                phi_3687_ = (_e1907 + select(0u, 1u, !(_e1920)));
                                            } else {
                                                if (_e1919 == 7u) {
                                                    phi_3686_ = 2147483648u;
                                                } else {
                                                    phi_3686_ = ((2147483648u | (_e1919 << bitcast<u32>(28u))) | (select(_e1939, _e1908, _e1941) & 268435455u));
                                                }
                                                let _e1954 = phi_3686_;
                                                phi_3687_ = _e1954;
                                            }
                                            let _e1956 = phi_3687_;
                                            phi_3691_ = type_46(array<vec4<f32>, 3>(vec4<f32>(_e1834, (_e706.member.member.x + _e1786), _e1839, (_e706.member.member_1.x - _e1825)), vec4<f32>(_e1835, (_e706.member.member.y + _e1790), _e1840, (_e706.member.member_1.y - _e1829)), vec4<f32>(_e1836, (_e706.member.member.z + _e1794), _e1841, (_e706.member.member_1.z - _e1833))), type_45(type_24((_e706.member.member + vec4<f32>(_e1764, _e1773, _e1782, 0f)), (_e706.member.member_1 - vec4<f32>(_e1803, _e1812, _e1821, 0f))), _e1931), type_45(type_24((_e706.member.member + vec4<f32>(_e1786, _e1790, _e1794, 0f)), (_e706.member.member_1 - vec4<f32>(_e1825, _e1829, _e1833, 0f))), _e1956));
                                        }
                                        let _e1961 = phi_3691_;
                                        let _e1973 = ((_e1961.member[0].x - _e366) * _e371);
                                        let _e1974 = ((_e1961.member[0].y - _e366) * _e371);
                                        let _e1975 = ((_e1961.member[0].z - _e367) * _e371);
                                        let _e1976 = ((_e1961.member[0].w - _e367) * _e371);
                                        let _e1986 = ((_e1961.member[1].x - _e434) * _e439);
                                        let _e1987 = ((_e1961.member[1].y - _e434) * _e439);
                                        let _e1988 = ((_e1961.member[1].z - _e435) * _e439);
                                        let _e1989 = ((_e1961.member[1].w - _e435) * _e439);
                                        let _e1999 = ((_e1961.member[2].x - _e502) * _e507);
                                        let _e2000 = ((_e1961.member[2].y - _e502) * _e507);
                                        let _e2001 = ((_e1961.member[2].z - _e503) * _e507);
                                        let _e2002 = ((_e1961.member[2].w - _e503) * _e507);
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
                                        let _e2054 = select(_e619, _e2024, (_e2024 > _e619));
                                        let _e2056 = select(_e619, _e2026, (_e2026 > _e619));
                                        let _e2061 = (_e2054 <= select(_e1647.member, _e2051, (_e2051 < _e1647.member)));
                                        let _e2062 = (_e2056 <= select(_e1647.member, _e2052, (_e2052 < _e1647.member)));
                                        let _e2063 = (_e2054 <= _e2056);
                                        if _e2061 {
                                            if _e2062 {
                                                if _e2063 {
                                                    phi_4053_ = _e1961.member_2;
                                                } else {
                                                    phi_4053_ = _e1961.member_1;
                                                }
                                                let _e2067 = phi_4053_;
                                                let _e2088 = (_e704 % 128u);
                                                let _e2089 = (_e2088 < 128u);
                                                if _e2089 {
                                                } else {
                                                    phi_4595_ = true;
                                                    break;
                                                }
                                                local_8[_e2088] = _e2067.member_1;
                                                if _e2089 {
                                                } else {
                                                    phi_4595_ = true;
                                                    break;
                                                }
                                                local_7[_e2088] = _e2067.member.member.x;
                                                if _e2089 {
                                                } else {
                                                    phi_4595_ = true;
                                                    break;
                                                }
                                                local_6[_e2088] = _e2067.member.member.y;
                                                if _e2089 {
                                                } else {
                                                    phi_4595_ = true;
                                                    break;
                                                }
                                                local_5[_e2088] = _e2067.member.member.z;
                                                if _e2089 {
                                                } else {
                                                    phi_4595_ = true;
                                                    break;
                                                }
                                                local_4[_e2088] = _e2067.member.member_1.x;
                                                if _e2089 {
                                                } else {
                                                    phi_4595_ = true;
                                                    break;
                                                }
                                                local_3[_e2088] = _e2067.member.member_1.y;
                                                if _e2089 {
                                                } else {
                                                    phi_4595_ = true;
                                                    break;
                                                }
                                                local_2[_e2088] = _e2067.member.member_1.z;
                                                if _e2089 {
                                                } else {
                                                    phi_4595_ = true;
                                                    break;
                                                }
                                                local_9[_e2088] = select(_e2054, _e2056, _e2063);
                                                if _e2063 {
                                                    phi_4129_ = _e1961.member_1;
                                                } else {
                                                    phi_4129_ = _e1961.member_2;
                                                }
                                                let _e2102 = phi_4129_;
                                                phi_4130_ = (_e704 + 1u);
                                                phi_4131_ = _e2102;
                                            } else {
                                                phi_4130_ = u32();
                                                phi_4131_ = type_45();
                                            }
                                            let _e2104 = phi_4130_;
                                            let _e2106 = phi_4131_;
                                            phi_4133_ = _e2104;
                                            phi_4134_ = _e2106;
                                            phi_4135_ = select(true, false, _e2062);
                                        } else {
                                            phi_4133_ = u32();
                                            phi_4134_ = type_45();
                                            phi_4135_ = true;
                                        }
                                        let _e2109 = phi_4133_;
                                        let _e2111 = phi_4134_;
                                        let _e2113 = phi_4135_;
                                        if _e2113 {
                                            if _e2061 {
                                                phi_4144_ = _e1961.member_1;
                                            } else {
                                                phi_4144_ = _e1961.member_2;
                                            }
                                            let _e2117 = phi_4144_;
                                            phi_4149_ = select(_e2062, true, _e2061);
                                            phi_4151_ = _e2117;
                                        } else {
                                            phi_4149_ = _e702;
                                            phi_4151_ = _e2111;
                                        }
                                        let _e2120 = phi_4149_;
                                        let _e2122 = phi_4151_;
                                        phi_4155_ = _e2120;
                                        phi_4156_ = select(_e2109, _e704, _e2113);
                                        phi_4157_ = _e2122;
                                    }
                                    let _e2125 = phi_4155_;
                                    let _e2127 = phi_4156_;
                                    let _e2129 = phi_4157_;
                                    if _e710 {
                                        phi_4167_ = select(_e704, 0u, _e1647.member_1);
                                        phi_4168_ = _e706;
                                    } else {
                                        phi_4167_ = _e2127;
                                        phi_4168_ = _e2129;
                                    }
                                    let _e2133 = phi_4167_;
                                    let _e2135 = phi_4168_;
                                    phi_4598_ = _e1645;
                                    phi_4169_ = _e1647;
                                    phi_4170_ = (_e665 - 1u);
                                    phi_4171_ = select(_e2125, false, _e710);
                                    phi_4172_ = _e2133;
                                    phi_4173_ = _e2135;
                                } else {
                                    phi_4598_ = _e661;
                                    phi_4169_ = _e663;
                                    phi_4170_ = _e665;
                                    phi_4171_ = _e702;
                                    phi_4172_ = _e704;
                                    phi_4173_ = _e706;
                                }
                                let _e2138 = phi_4598_;
                                let _e2140 = phi_4169_;
                                let _e2142 = phi_4170_;
                                let _e2144 = phi_4171_;
                                let _e2146 = phi_4172_;
                                let _e2148 = phi_4173_;
                                phi_4597_ = _e2138;
                                phi_4174_ = _e2140;
                                phi_4175_ = _e2142;
                                phi_4176_ = _e2144;
                                phi_4177_ = _e2146;
                                phi_4178_ = _e2148;
                            } else {
                                phi_4597_ = _e661;
                                phi_4174_ = type_34();
                                phi_4175_ = u32();
                                phi_4176_ = bool();
                                phi_4177_ = u32();
                                phi_4178_ = type_45();
                            }
                            let _e2150 = phi_4597_;
                            let _e2152 = phi_4174_;
                            let _e2154 = phi_4175_;
                            let _e2156 = phi_4176_;
                            let _e2158 = phi_4177_;
                            let _e2160 = phi_4178_;
                            phi_4596_ = _e2150;
                            phi_1088_ = _e2152;
                            phi_1091_ = _e2154;
                            phi_1093_ = _e2156;
                            phi_1095_ = _e2158;
                            phi_1097_ = _e2160;
                            phi_4179_ = _e675;
                        } else {
                            phi_4596_ = _e661;
                            phi_1088_ = type_34();
                            phi_1091_ = u32();
                            phi_1093_ = bool();
                            phi_1095_ = u32();
                            phi_1097_ = type_45();
                            phi_4179_ = false;
                        }
                        let _e2162 = phi_4596_;
                        let _e2164 = phi_1088_;
                        let _e2166 = phi_1091_;
                        let _e2168 = phi_1093_;
                        let _e2170 = phi_1095_;
                        let _e2172 = phi_1097_;
                        let _e2174 = phi_4179_;
                        continue;
                        continuing {
                            phi_4397_ = _e2162;
                            phi_1087_ = _e2164;
                            phi_1090_ = _e2166;
                            phi_1092_ = _e2168;
                            phi_1094_ = _e2170;
                            phi_1096_ = _e2172;
                            phi_4595_ = _e2162;
                            break if !(_e2174);
                        }
                    }
                    let _e2177 = phi_4595_;
                    if _e2177 {
                        break;
                    }
                    let _e2179 = local_10;
                    if _e152 {
                    } else {
                        break;
                    }
                    global_4.member[_e150] = select(0u, 1u, _e2179.member_1);
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
