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
    var phi_1069_: type_34;
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
    var phi_1196_: type_34;
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
    var phi_2739_: type_20;
    var phi_2741_: type_20;
    var phi_2742_: bool;
    var phi_2746_: type_20;
    var phi_2747_: type_20;
    var phi_2748_: type_20;
    var phi_2749_: bool;
    var phi_2753_: type_20;
    var phi_2754_: bool;
    var phi_2755_: type_20;
    var phi_2756_: bool;
    var phi_2757_: bool;
    var phi_2758_: type_20;
    var phi_2759_: bool;
    var phi_2760_: bool;
    var phi_2768_: type_20;
    var phi_2769_: bool;
    var phi_2773_: type_20;
    var phi_2784_: type_34;
    var phi_2785_: type_34;
    var phi_1197_: type_34;
    var phi_4252_: bool;
    var local_10: type_34;
    var phi_4460_: bool;
    var phi_4026_: type_34;
    var phi_4027_: type_45;
    var phi_4028_: bool;
    var phi_4029_: u32;
    var phi_4459_: bool;
    var phi_4030_: type_34;
    var phi_4031_: type_45;
    var phi_4032_: u32;
    var phi_4033_: bool;
    var phi_4034_: u32;
    var phi_4458_: bool;
    var phi_4035_: type_34;
    var phi_4036_: type_45;
    var phi_4037_: u32;
    var phi_4038_: bool;
    var phi_4039_: u32;
    var phi_4457_: bool;
    var phi_1070_: type_34;
    var phi_1073_: type_45;
    var phi_1075_: u32;
    var phi_1077_: bool;
    var phi_1079_: u32;
    var phi_4040_: bool;
    var phi_4456_: bool;
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
                            phi_391_ = (bitcast<i32>((_e229 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_391_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e229)), 32u, (_e229 == 0u))));
                        }
                        let _e243 = phi_391_;
                        phi_392_ = _e243;
                    } else {
                        phi_392_ = 0i;
                    }
                    let _e245 = phi_392_;
                    let _e246 = (_e162 == _e201);
                    if _e246 {
                        phi_402_ = true;
                    } else {
                        phi_402_ = (_e169 == _e201);
                    }
                    let _e249 = phi_402_;
                    let _e250 = select(1u, 0u, _e246);
                    if _e249 {
                        let _e251 = (_e250 + 1u);
                        phi_412_ = _e251;
                        phi_413_ = _e251;
                        phi_415_ = select(true, false, (_e251 == 2u));
                    } else {
                        phi_412_ = u32();
                        phi_413_ = 0u;
                        phi_415_ = true;
                    }
                    let _e255 = phi_412_;
                    let _e257 = phi_413_;
                    let _e259 = phi_415_;
                    if _e259 {
                        phi_420_ = (_e257 + 1u);
                    } else {
                        phi_420_ = 0u;
                    }
                    let _e263 = phi_420_;
                    let _e264 = select(_e255, _e257, _e259);
                    let _e265 = select(_e250, select(2u, _e250, _e249), _e259);
                    if (_e132 < -126i) {
                        phi_432_ = -126i;
                    } else {
                        phi_432_ = select(_e132, 127i, (_e132 > 127i));
                    }
                    let _e270 = phi_432_;
                    let _e275 = bitcast<f32>((bitcast<u32>((_e270 + 127i)) << bitcast<u32>(23i)));
                    let _e281 = bitcast<f32>((bitcast<u32>(((_e132 - _e270) + 127i)) << bitcast<u32>(23i)));
                    let _e282 = -(_e245);
                    if (_e282 < -126i) {
                        phi_452_ = -126i;
                    } else {
                        phi_452_ = select(_e282, 127i, (_e282 > 127i));
                    }
                    let _e287 = phi_452_;
                    let _e292 = bitcast<f32>((bitcast<u32>((_e287 + 127i)) << bitcast<u32>(23i)));
                    let _e298 = bitcast<f32>((bitcast<u32>(((_e282 - _e287) + 127i)) << bitcast<u32>(23i)));
                    let _e302 = global_3.member[_e150].member;
                    let _e303 = (_e264 == 0u);
                    if _e303 {
                        phi_470_ = _e302[0];
                    } else {
                        phi_470_ = _e302[1];
                    }
                    let _e307 = phi_470_;
                    let _e308 = (_e264 == 2u);
                    if _e308 {
                        phi_476_ = _e302[2];
                    } else {
                        phi_476_ = _e307;
                    }
                    let _e311 = phi_476_;
                    let _e312 = bitcast<u32>(_e311);
                    let _e314 = ((_e312 & 2139095040u) != 0u);
                    let _e328 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e312 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e312 & 2147483648u))), _e311, _e314) * _e275) * select(0.00000011920929f, 1f, _e314)) * _e281);
                    let _e329 = global_3.member[_e150].member_2;
                    if _e303 {
                        phi_516_ = _e329[0];
                    } else {
                        phi_516_ = _e329[1];
                    }
                    let _e333 = phi_516_;
                    if _e308 {
                        phi_522_ = _e329[2];
                    } else {
                        phi_522_ = _e333;
                    }
                    let _e336 = phi_522_;
                    let _e337 = bitcast<u32>(_e336);
                    let _e339 = ((_e337 & 2139095040u) != 0u);
                    let _e353 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e337 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e337 & 2147483648u))), _e336, _e339) * _e292) * select(0.00000011920929f, 1f, _e339)) * _e298);
                    let _e357 = (bitcast<f32>((bitcast<u32>(_e353) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e357 {
                        let _e361 = (bitcast<f32>((bitcast<u32>(_e328) & 2147483647u)) * 0.00000011920929f);
                        phi_574_ = select(0.00000000000011368684f, _e361, (_e361 > 0.00000000000011368684f));
                    } else {
                        phi_574_ = 0f;
                    }
                    let _e365 = phi_574_;
                    let _e366 = (_e328 + _e365);
                    let _e367 = (_e328 - _e365);
                    let _e368 = select(_e353, 0f, _e357);
                    if _e357 {
                        phi_585_ = 38685626000000000000000000f;
                    } else {
                        phi_585_ = (1f / _e353);
                    }
                    let _e371 = phi_585_;
                    let _e372 = (_e263 == 0u);
                    if _e372 {
                        phi_594_ = _e302[0];
                    } else {
                        phi_594_ = _e302[1];
                    }
                    let _e376 = phi_594_;
                    let _e377 = (_e263 == 2u);
                    if _e377 {
                        phi_600_ = _e302[2];
                    } else {
                        phi_600_ = _e376;
                    }
                    let _e380 = phi_600_;
                    let _e381 = bitcast<u32>(_e380);
                    let _e383 = ((_e381 & 2139095040u) != 0u);
                    let _e397 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e381 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e381 & 2147483648u))), _e380, _e383) * _e275) * select(0.00000011920929f, 1f, _e383)) * _e281);
                    if _e372 {
                        phi_640_ = _e329[0];
                    } else {
                        phi_640_ = _e329[1];
                    }
                    let _e401 = phi_640_;
                    if _e377 {
                        phi_646_ = _e329[2];
                    } else {
                        phi_646_ = _e401;
                    }
                    let _e404 = phi_646_;
                    let _e405 = bitcast<u32>(_e404);
                    let _e407 = ((_e405 & 2139095040u) != 0u);
                    let _e421 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e405 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e405 & 2147483648u))), _e404, _e407) * _e292) * select(0.00000011920929f, 1f, _e407)) * _e298);
                    let _e425 = (bitcast<f32>((bitcast<u32>(_e421) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e425 {
                        let _e429 = (bitcast<f32>((bitcast<u32>(_e397) & 2147483647u)) * 0.00000011920929f);
                        phi_698_ = select(0.00000000000011368684f, _e429, (_e429 > 0.00000000000011368684f));
                    } else {
                        phi_698_ = 0f;
                    }
                    let _e433 = phi_698_;
                    let _e434 = (_e397 + _e433);
                    let _e435 = (_e397 - _e433);
                    let _e436 = select(_e421, 0f, _e425);
                    if _e425 {
                        phi_709_ = 38685626000000000000000000f;
                    } else {
                        phi_709_ = (1f / _e421);
                    }
                    let _e439 = phi_709_;
                    let _e440 = (_e265 == 0u);
                    if _e440 {
                        phi_718_ = _e302[0];
                    } else {
                        phi_718_ = _e302[1];
                    }
                    let _e444 = phi_718_;
                    let _e445 = (_e265 == 2u);
                    if _e445 {
                        phi_724_ = _e302[2];
                    } else {
                        phi_724_ = _e444;
                    }
                    let _e448 = phi_724_;
                    let _e449 = bitcast<u32>(_e448);
                    let _e451 = ((_e449 & 2139095040u) != 0u);
                    let _e465 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e449 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e449 & 2147483648u))), _e448, _e451) * _e275) * select(0.00000011920929f, 1f, _e451)) * _e281);
                    if _e440 {
                        phi_764_ = _e329[0];
                    } else {
                        phi_764_ = _e329[1];
                    }
                    let _e469 = phi_764_;
                    if _e445 {
                        phi_770_ = _e329[2];
                    } else {
                        phi_770_ = _e469;
                    }
                    let _e472 = phi_770_;
                    let _e473 = bitcast<u32>(_e472);
                    let _e475 = ((_e473 & 2139095040u) != 0u);
                    let _e489 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e473 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e473 & 2147483648u))), _e472, _e475) * _e292) * select(0.00000011920929f, 1f, _e475)) * _e298);
                    let _e493 = (bitcast<f32>((bitcast<u32>(_e489) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e493 {
                        let _e497 = (bitcast<f32>((bitcast<u32>(_e465) & 2147483647u)) * 0.00000011920929f);
                        phi_822_ = select(0.00000000000011368684f, _e497, (_e497 > 0.00000000000011368684f));
                    } else {
                        phi_822_ = 0f;
                    }
                    let _e501 = phi_822_;
                    let _e502 = (_e465 + _e501);
                    let _e503 = (_e465 - _e501);
                    let _e504 = select(_e489, 0f, _e493);
                    if _e493 {
                        phi_833_ = 38685626000000000000000000f;
                    } else {
                        phi_833_ = (1f / _e489);
                    }
                    let _e507 = phi_833_;
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
                            phi_888_ = 255i;
                        } else {
                            phi_888_ = (((_e534 + select(0i, 1i, (_e534 == 0i))) - _e541) + _e521);
                        }
                        let _e549 = phi_888_;
                        let _e559 = (_e549 <= 0i);
                        if _e559 {
                            phi_911_ = u32();
                        } else {
                            if _e538 {
                                phi_910_ = u32();
                            } else {
                                phi_910_ = select(((bitcast<u32>(_e549) << bitcast<u32>(23i)) | ((_e531 << bitcast<u32>(((_e541 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e549 >= 255i));
                            }
                            let _e563 = phi_910_;
                            phi_911_ = _e563;
                        }
                        let _e565 = phi_911_;
                        let _e577 = ((_e222 & 8388607u) | (select(0u, 1u, ((_e222 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                        let _e580 = bitcast<i32>((_e222 >> bitcast<u32>(23i)));
                        let _e584 = (_e577 == 0u);
                        let _e587 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e577)), 32u, _e584)) - 8i);
                        if (_e580 == 255i) {
                            phi_948_ = 255i;
                        } else {
                            phi_948_ = (((_e580 + select(0i, 1i, (_e580 == 0i))) - _e587) + _e521);
                        }
                        let _e595 = phi_948_;
                        let _e605 = (_e595 <= 0i);
                        if _e605 {
                            phi_971_ = u32();
                        } else {
                            if _e584 {
                                phi_970_ = u32();
                            } else {
                                phi_970_ = select(((bitcast<u32>(_e595) << bitcast<u32>(23i)) | ((_e577 << bitcast<u32>(((_e587 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e595 >= 255i));
                            }
                            let _e609 = phi_970_;
                            phi_971_ = _e609;
                        }
                        let _e611 = phi_971_;
                        phi_979_ = bitcast<f32>(((_e221 & 2147483648u) | select(_e611, 0u, select(_e584, true, _e605))));
                        phi_980_ = bitcast<f32>(((_e212 & 2147483648u) | select(_e565, 0u, select(_e538, true, _e559))));
                    } else {
                        phi_979_ = 0f;
                        phi_980_ = 1f;
                    }
                    let _e617 = phi_979_;
                    let _e619 = phi_980_;
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
                    phi_4258_ = false;
                    phi_1069_ = type_34(_e617, false);
                    phi_1072_ = type_45(type_24(vec4<f32>((f32(_e626) * _e144), (f32(_e632) * _e144), (f32(_e638) * _e144), 0f), vec4<f32>((f32(_e643) * _e144), (f32(_e647) * _e144), (f32(_e651) * _e144), 0f)), select(0u, 2147483648u, (_e93 == 0u)));
                    phi_1074_ = ((3u * _e93) + 1u);
                    phi_1076_ = (_e619 <= _e617);
                    phi_1078_ = 0u;
                    loop {
                        let _e661 = phi_4258_;
                        let _e663 = phi_1069_;
                        let _e665 = phi_1072_;
                        let _e667 = phi_1074_;
                        let _e669 = phi_1076_;
                        let _e671 = phi_1078_;
                        local_11 = _e663;
                        if _e669 {
                            phi_1089_ = true;
                        } else {
                            phi_1089_ = (_e671 > 0u);
                        }
                        let _e674 = phi_1089_;
                        if _e674 {
                            let _e675 = (_e667 > 0u);
                            if _e675 {
                                if _e669 {
                                    phi_1175_ = _e665;
                                    phi_1176_ = _e669;
                                    phi_1177_ = _e671;
                                } else {
                                    let _e676 = (_e671 - 1u);
                                    let _e677 = (_e676 % 128u);
                                    let _e678 = (_e677 < 128u);
                                    if _e678 {
                                    } else {
                                        phi_4456_ = true;
                                        break;
                                    }
                                    let _e680 = local_7[_e677];
                                    if _e678 {
                                    } else {
                                        phi_4456_ = true;
                                        break;
                                    }
                                    let _e682 = local_6[_e677];
                                    if _e678 {
                                    } else {
                                        phi_4456_ = true;
                                        break;
                                    }
                                    let _e684 = local_5[_e677];
                                    if _e678 {
                                    } else {
                                        phi_4456_ = true;
                                        break;
                                    }
                                    let _e686 = local_4[_e677];
                                    if _e678 {
                                    } else {
                                        phi_4456_ = true;
                                        break;
                                    }
                                    let _e688 = local_3[_e677];
                                    if _e678 {
                                    } else {
                                        phi_4456_ = true;
                                        break;
                                    }
                                    let _e690 = local_2[_e677];
                                    if _e678 {
                                    } else {
                                        phi_4456_ = true;
                                        break;
                                    }
                                    let _e695 = local_8[_e677];
                                    if _e678 {
                                    } else {
                                        phi_4456_ = true;
                                        break;
                                    }
                                    let _e698 = local_9[_e677];
                                    phi_1175_ = type_45(type_24(vec4<f32>(_e680, _e682, _e684, 0f), vec4<f32>(_e686, _e688, _e690, 0f)), _e695);
                                    phi_1176_ = (_e698 <= _e663.member);
                                    phi_1177_ = _e676;
                                }
                                let _e702 = phi_1175_;
                                let _e704 = phi_1176_;
                                let _e706 = phi_1177_;
                                if _e704 {
                                    let _e711 = (_e702.member_1 & 268435455u);
                                    if ((_e702.member_1 & 2147483648u) != 0u) {
                                        phi_1196_ = _e663;
                                        phi_1199_ = type_8(0u, ((_e702.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e1195 = phi_1196_;
                                            let _e1197 = phi_1199_;
                                            local_10 = _e1195;
                                            local_12 = _e1195;
                                            if (_e1197.member < _e1197.member_1) {
                                                phi_1200_ = type_8((_e1197.member + 1u), _e1197.member_1);
                                                phi_1222_ = type_8(1u, _e1197.member);
                                            } else {
                                                phi_1200_ = _e1197;
                                                phi_1222_ = type_8(0u, type_8().member_1);
                                            }
                                            let _e1210 = phi_1200_;
                                            let _e1212 = phi_1222_;
                                            let _e1216 = (bitcast<i32>(_e1212.member) != 0i);
                                            if _e1216 {
                                                let _e1221 = (_e702.member.member_1.x - _e702.member.member.x);
                                                let _e1224 = (_e702.member.member_1.y - _e702.member.member.y);
                                                let _e1227 = (_e702.member.member_1.z - _e702.member.member.z);
                                                let _e1229 = select(_e1224, _e1221, (_e1221 > _e1224));
                                                let _e1231 = select(_e1227, _e1229, (_e1229 > _e1227));
                                                let _e1233 = (_e1231 < (1024f * _e144));
                                                if _e1233 {
                                                    phi_1263_ = 0u;
                                                } else {
                                                    phi_1263_ = select(2u, 1u, (_e1231 < (2097152f * _e144)));
                                                }
                                                let _e1238 = phi_1263_;
                                                switch bitcast<i32>(_e1238) {
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
                                                let _e1241 = phi_1269_;
                                                switch bitcast<i32>(_e1238) {
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
                                                let _e1248 = phi_1279_;
                                                let _e1250 = ((_e711 + (_e1212.member_1 * ((3u * _e1241) + 1u))) + (3u * _e1248));
                                                let _e1251 = (_e1250 < _e96);
                                                if _e1251 {
                                                    if _e1251 {
                                                    } else {
                                                        phi_4252_ = true;
                                                        break;
                                                    }
                                                    let _e1253 = global_6.member[_e1250];
                                                    phi_1295_ = _e1253;
                                                } else {
                                                    phi_1295_ = 4294967295u;
                                                }
                                                let _e1255 = phi_1295_;
                                                if _e1233 {
                                                    phi_1328_ = 0u;
                                                } else {
                                                    phi_1328_ = select(2u, 1u, (_e1231 < (2097152f * _e144)));
                                                }
                                                let _e1260 = phi_1328_;
                                                switch bitcast<i32>(_e1260) {
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
                                                let _e1263 = phi_1334_;
                                                let _e1267 = (_e711 + (_e1212.member_1 * ((3u * _e1263) + 1u)));
                                                switch bitcast<i32>(_e1260) {
                                                    case 0: {
                                                        let _e1542 = (_e1267 < _e96);
                                                        if _e1542 {
                                                            if _e1542 {
                                                            } else {
                                                                phi_4252_ = true;
                                                                break;
                                                            }
                                                            let _e1544 = global_6.member[_e1267];
                                                            phi_1358_ = _e1544;
                                                        } else {
                                                            phi_1358_ = 0u;
                                                        }
                                                        let _e1546 = phi_1358_;
                                                        let _e1548 = ((10u * _e264) & 31u);
                                                        let _e1558 = ((10u * _e263) & 31u);
                                                        let _e1568 = ((10u * _e265) & 31u);
                                                        let _e1578 = (_e1267 + 1u);
                                                        let _e1579 = (_e1578 < _e96);
                                                        if _e1579 {
                                                            if _e1579 {
                                                            } else {
                                                                phi_4252_ = true;
                                                                break;
                                                            }
                                                            let _e1581 = global_6.member[_e1578];
                                                            phi_1404_ = _e1581;
                                                        } else {
                                                            phi_1404_ = 0u;
                                                        }
                                                        let _e1583 = phi_1404_;
                                                        let _e1609 = (_e1267 + 2u);
                                                        let _e1610 = (_e1609 < _e96);
                                                        if _e1610 {
                                                            if _e1610 {
                                                            } else {
                                                                phi_4252_ = true;
                                                                break;
                                                            }
                                                            let _e1612 = global_6.member[_e1609];
                                                            phi_1450_ = _e1612;
                                                        } else {
                                                            phi_1450_ = 0u;
                                                        }
                                                        let _e1614 = phi_1450_;
                                                        phi_1933_ = array<array<f32, 3>, 3>(array<f32, 3>((_e702.member.member.x + ((bitcast<f32>((1258291200u | ((_e1546 >> bitcast<u32>(_e1548)) & 1023u))) - 8388608f) * _e144)), (_e702.member.member.y + ((bitcast<f32>((1258291200u | ((_e1546 >> bitcast<u32>(_e1558)) & 1023u))) - 8388608f) * _e144)), (_e702.member.member.z + ((bitcast<f32>((1258291200u | ((_e1546 >> bitcast<u32>(_e1568)) & 1023u))) - 8388608f) * _e144))), array<f32, 3>((_e702.member.member.x + ((bitcast<f32>((1258291200u | ((_e1583 >> bitcast<u32>(_e1548)) & 1023u))) - 8388608f) * _e144)), (_e702.member.member.y + ((bitcast<f32>((1258291200u | ((_e1583 >> bitcast<u32>(_e1558)) & 1023u))) - 8388608f) * _e144)), (_e702.member.member.z + ((bitcast<f32>((1258291200u | ((_e1583 >> bitcast<u32>(_e1568)) & 1023u))) - 8388608f) * _e144))), array<f32, 3>((_e702.member.member.x + ((bitcast<f32>((1258291200u | ((_e1614 >> bitcast<u32>(_e1548)) & 1023u))) - 8388608f) * _e144)), (_e702.member.member.y + ((bitcast<f32>((1258291200u | ((_e1614 >> bitcast<u32>(_e1558)) & 1023u))) - 8388608f) * _e144)), (_e702.member.member.z + ((bitcast<f32>((1258291200u | ((_e1614 >> bitcast<u32>(_e1568)) & 1023u))) - 8388608f) * _e144))));
                                                        break;
                                                    }
                                                    case 1: {
                                                        let _e1356 = (_e1267 < _e96);
                                                        if _e1356 {
                                                            if _e1356 {
                                                            } else {
                                                                phi_4252_ = true;
                                                                break;
                                                            }
                                                            let _e1358 = global_6.member[_e1267];
                                                            phi_1496_ = _e1358;
                                                        } else {
                                                            phi_1496_ = 0u;
                                                        }
                                                        let _e1360 = phi_1496_;
                                                        let _e1361 = (_e1267 + 1u);
                                                        let _e1362 = (_e1361 < _e96);
                                                        if _e1362 {
                                                            if _e1362 {
                                                            } else {
                                                                phi_4252_ = true;
                                                                break;
                                                            }
                                                            let _e1364 = global_6.member[_e1361];
                                                            phi_1511_ = _e1364;
                                                        } else {
                                                            phi_1511_ = 0u;
                                                        }
                                                        let _e1366 = phi_1511_;
                                                        let _e1367 = (_e264 == 1u);
                                                        if _e1367 {
                                                            phi_1521_ = ((_e1360 >> bitcast<u32>(21i)) | (_e1366 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1521_ = (_e1366 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1376 = phi_1521_;
                                                        let _e1384 = (_e263 == 1u);
                                                        if _e1384 {
                                                            phi_1542_ = ((_e1360 >> bitcast<u32>(21i)) | (_e1366 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1542_ = (_e1366 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1393 = phi_1542_;
                                                        let _e1401 = (_e265 == 1u);
                                                        if _e1401 {
                                                            phi_1563_ = ((_e1360 >> bitcast<u32>(21i)) | (_e1366 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1563_ = (_e1366 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1410 = phi_1563_;
                                                        let _e1419 = (_e1267 + 2u);
                                                        let _e1420 = (_e1419 < _e96);
                                                        if _e1420 {
                                                            if _e1420 {
                                                            } else {
                                                                phi_4252_ = true;
                                                                break;
                                                            }
                                                            let _e1422 = global_6.member[_e1419];
                                                            phi_1590_ = _e1422;
                                                        } else {
                                                            phi_1590_ = 0u;
                                                        }
                                                        let _e1424 = phi_1590_;
                                                        let _e1425 = (_e1267 + 3u);
                                                        let _e1426 = (_e1425 < _e96);
                                                        if _e1426 {
                                                            if _e1426 {
                                                            } else {
                                                                phi_4252_ = true;
                                                                break;
                                                            }
                                                            let _e1428 = global_6.member[_e1425];
                                                            phi_1605_ = _e1428;
                                                        } else {
                                                            phi_1605_ = 0u;
                                                        }
                                                        let _e1430 = phi_1605_;
                                                        if _e1367 {
                                                            phi_1615_ = ((_e1424 >> bitcast<u32>(21i)) | (_e1430 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1615_ = (_e1430 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1439 = phi_1615_;
                                                        if _e1384 {
                                                            phi_1636_ = ((_e1424 >> bitcast<u32>(21i)) | (_e1430 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1636_ = (_e1430 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1455 = phi_1636_;
                                                        if _e1401 {
                                                            phi_1657_ = ((_e1424 >> bitcast<u32>(21i)) | (_e1430 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1657_ = (_e1430 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1471 = phi_1657_;
                                                        let _e1480 = (_e1267 + 4u);
                                                        let _e1481 = (_e1480 < _e96);
                                                        if _e1481 {
                                                            if _e1481 {
                                                            } else {
                                                                phi_4252_ = true;
                                                                break;
                                                            }
                                                            let _e1483 = global_6.member[_e1480];
                                                            phi_1684_ = _e1483;
                                                        } else {
                                                            phi_1684_ = 0u;
                                                        }
                                                        let _e1485 = phi_1684_;
                                                        let _e1486 = (_e1267 + 5u);
                                                        let _e1487 = (_e1486 < _e96);
                                                        if _e1487 {
                                                            if _e1487 {
                                                            } else {
                                                                phi_4252_ = true;
                                                                break;
                                                            }
                                                            let _e1489 = global_6.member[_e1486];
                                                            phi_1699_ = _e1489;
                                                        } else {
                                                            phi_1699_ = 0u;
                                                        }
                                                        let _e1491 = phi_1699_;
                                                        if _e1367 {
                                                            phi_1709_ = ((_e1485 >> bitcast<u32>(21i)) | (_e1491 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1709_ = (_e1491 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1500 = phi_1709_;
                                                        if _e1384 {
                                                            phi_1730_ = ((_e1485 >> bitcast<u32>(21i)) | (_e1491 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1730_ = (_e1491 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1516 = phi_1730_;
                                                        if _e1401 {
                                                            phi_1751_ = ((_e1485 >> bitcast<u32>(21i)) | (_e1491 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1751_ = (_e1491 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1532 = phi_1751_;
                                                        phi_1933_ = array<array<f32, 3>, 3>(array<f32, 3>((_e702.member.member.x + ((bitcast<f32>((1258291200u | (select(_e1376, _e1360, _e303) & 2097151u))) - 8388608f) * _e144)), (_e702.member.member.y + ((bitcast<f32>((1258291200u | (select(_e1393, _e1360, _e372) & 2097151u))) - 8388608f) * _e144)), (_e702.member.member.z + ((bitcast<f32>((1258291200u | (select(_e1410, _e1360, _e440) & 2097151u))) - 8388608f) * _e144))), array<f32, 3>((_e702.member.member.x + ((bitcast<f32>((1258291200u | (select(_e1439, _e1424, _e303) & 2097151u))) - 8388608f) * _e144)), (_e702.member.member.y + ((bitcast<f32>((1258291200u | (select(_e1455, _e1424, _e372) & 2097151u))) - 8388608f) * _e144)), (_e702.member.member.z + ((bitcast<f32>((1258291200u | (select(_e1471, _e1424, _e440) & 2097151u))) - 8388608f) * _e144))), array<f32, 3>((_e702.member.member.x + ((bitcast<f32>((1258291200u | (select(_e1500, _e1485, _e303) & 2097151u))) - 8388608f) * _e144)), (_e702.member.member.y + ((bitcast<f32>((1258291200u | (select(_e1516, _e1485, _e372) & 2097151u))) - 8388608f) * _e144)), (_e702.member.member.z + ((bitcast<f32>((1258291200u | (select(_e1532, _e1485, _e440) & 2097151u))) - 8388608f) * _e144))));
                                                        break;
                                                    }
                                                    case 2: {
                                                        let _e1269 = (_e1267 + _e264);
                                                        let _e1270 = (_e1269 < _e96);
                                                        if _e1270 {
                                                            if _e1270 {
                                                            } else {
                                                                phi_4252_ = true;
                                                                break;
                                                            }
                                                            let _e1272 = global_6.member[_e1269];
                                                            phi_1779_ = _e1272;
                                                        } else {
                                                            phi_1779_ = 0u;
                                                        }
                                                        let _e1274 = phi_1779_;
                                                        let _e1278 = (_e1267 + _e263);
                                                        let _e1279 = (_e1278 < _e96);
                                                        if _e1279 {
                                                            if _e1279 {
                                                            } else {
                                                                phi_4252_ = true;
                                                                break;
                                                            }
                                                            let _e1281 = global_6.member[_e1278];
                                                            phi_1797_ = _e1281;
                                                        } else {
                                                            phi_1797_ = 0u;
                                                        }
                                                        let _e1283 = phi_1797_;
                                                        let _e1287 = (_e1267 + _e265);
                                                        let _e1288 = (_e1287 < _e96);
                                                        if _e1288 {
                                                            if _e1288 {
                                                            } else {
                                                                phi_4252_ = true;
                                                                break;
                                                            }
                                                            let _e1290 = global_6.member[_e1287];
                                                            phi_1815_ = _e1290;
                                                        } else {
                                                            phi_1815_ = 0u;
                                                        }
                                                        let _e1292 = phi_1815_;
                                                        let _e1297 = (_e1267 + 3u);
                                                        let _e1298 = (_e1297 + _e264);
                                                        let _e1299 = (_e1298 < _e96);
                                                        if _e1299 {
                                                            if _e1299 {
                                                            } else {
                                                                phi_4252_ = true;
                                                                break;
                                                            }
                                                            let _e1301 = global_6.member[_e1298];
                                                            phi_1835_ = _e1301;
                                                        } else {
                                                            phi_1835_ = 0u;
                                                        }
                                                        let _e1303 = phi_1835_;
                                                        let _e1307 = (_e1297 + _e263);
                                                        let _e1308 = (_e1307 < _e96);
                                                        if _e1308 {
                                                            if _e1308 {
                                                            } else {
                                                                phi_4252_ = true;
                                                                break;
                                                            }
                                                            let _e1310 = global_6.member[_e1307];
                                                            phi_1853_ = _e1310;
                                                        } else {
                                                            phi_1853_ = 0u;
                                                        }
                                                        let _e1312 = phi_1853_;
                                                        let _e1316 = (_e1297 + _e265);
                                                        let _e1317 = (_e1316 < _e96);
                                                        if _e1317 {
                                                            if _e1317 {
                                                            } else {
                                                                phi_4252_ = true;
                                                                break;
                                                            }
                                                            let _e1319 = global_6.member[_e1316];
                                                            phi_1871_ = _e1319;
                                                        } else {
                                                            phi_1871_ = 0u;
                                                        }
                                                        let _e1321 = phi_1871_;
                                                        let _e1326 = (_e1267 + 6u);
                                                        let _e1327 = (_e1326 + _e264);
                                                        let _e1328 = (_e1327 < _e96);
                                                        if _e1328 {
                                                            if _e1328 {
                                                            } else {
                                                                phi_4252_ = true;
                                                                break;
                                                            }
                                                            let _e1330 = global_6.member[_e1327];
                                                            phi_1891_ = _e1330;
                                                        } else {
                                                            phi_1891_ = 0u;
                                                        }
                                                        let _e1332 = phi_1891_;
                                                        let _e1336 = (_e1326 + _e263);
                                                        let _e1337 = (_e1336 < _e96);
                                                        if _e1337 {
                                                            if _e1337 {
                                                            } else {
                                                                phi_4252_ = true;
                                                                break;
                                                            }
                                                            let _e1339 = global_6.member[_e1336];
                                                            phi_1909_ = _e1339;
                                                        } else {
                                                            phi_1909_ = 0u;
                                                        }
                                                        let _e1341 = phi_1909_;
                                                        let _e1345 = (_e1326 + _e265);
                                                        let _e1346 = (_e1345 < _e96);
                                                        if _e1346 {
                                                            if _e1346 {
                                                            } else {
                                                                phi_4252_ = true;
                                                                break;
                                                            }
                                                            let _e1348 = global_6.member[_e1345];
                                                            phi_1927_ = _e1348;
                                                        } else {
                                                            phi_1927_ = 0u;
                                                        }
                                                        let _e1350 = phi_1927_;
                                                        phi_1933_ = array<array<f32, 3>, 3>(array<f32, 3>((f32(bitcast<i32>(_e1274)) * _e144), (f32(bitcast<i32>(_e1283)) * _e144), (f32(bitcast<i32>(_e1292)) * _e144)), array<f32, 3>((f32(bitcast<i32>(_e1303)) * _e144), (f32(bitcast<i32>(_e1312)) * _e144), (f32(bitcast<i32>(_e1321)) * _e144)), array<f32, 3>((f32(bitcast<i32>(_e1332)) * _e144), (f32(bitcast<i32>(_e1341)) * _e144), (f32(bitcast<i32>(_e1350)) * _e144)));
                                                        break;
                                                    }
                                                    default: {
                                                        phi_1933_ = array<array<f32, 3>, 3>();
                                                        break;
                                                    }
                                                }
                                                let _e1642 = phi_1933_;
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
                                                        phi_2758_ = type_20();
                                                        phi_2759_ = true;
                                                        phi_2760_ = false;
                                                    } else {
                                                        let _e1717 = select(_e1666, _e1653, (_e1653 < _e1666));
                                                        if (select(_e1679, _e1717, (_e1717 < _e1679)) > 0f) {
                                                            phi_2050_ = true;
                                                        } else {
                                                            let _e1722 = select(_e1666, _e1653, (_e1653 > _e1666));
                                                            phi_2050_ = (select(_e1679, _e1722, (_e1722 > _e1679)) < 0f);
                                                        }
                                                        let _e1727 = phi_2050_;
                                                        if _e1727 {
                                                            phi_2755_ = type_20();
                                                            phi_2756_ = true;
                                                            phi_2757_ = false;
                                                        } else {
                                                            let _e1729 = select(_e1669, _e1656, (_e1656 < _e1669));
                                                            if (select(_e1682, _e1729, (_e1729 < _e1682)) > 0f) {
                                                                phi_2079_ = true;
                                                            } else {
                                                                let _e1734 = select(_e1669, _e1656, (_e1656 > _e1669));
                                                                phi_2079_ = (select(_e1682, _e1734, (_e1734 > _e1682)) < 0f);
                                                            }
                                                            let _e1739 = phi_2079_;
                                                            if _e1739 {
                                                                phi_2753_ = type_20();
                                                                phi_2754_ = false;
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
                                                                    phi_2748_ = type_20();
                                                                    phi_2749_ = true;
                                                                } else {
                                                                    let _e1804 = (_e1802 > _e1195.member);
                                                                    if _e1804 {
                                                                        phi_2747_ = type_20();
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
                                                                            phi_2480_ = _e1669;
                                                                            phi_2481_ = _e1666;
                                                                            phi_2482_ = _e1656;
                                                                            phi_2483_ = _e1653;
                                                                            phi_2484_ = _e1805;
                                                                            phi_2485_ = _e1819;
                                                                            phi_2486_ = _e1815;
                                                                            phi_2487_ = _e1811;
                                                                        } else {
                                                                            let _e1864 = (_e1845 == _e1862);
                                                                            let _e1869 = vec3(_e1864);
                                                                            phi_2480_ = select(_e1656, _e1682, _e1864);
                                                                            phi_2481_ = select(_e1653, _e1679, _e1864);
                                                                            phi_2482_ = select(_e1682, _e1669, _e1864);
                                                                            phi_2483_ = select(_e1679, _e1666, _e1864);
                                                                            phi_2484_ = select(_e1807, _e1806, _e1869);
                                                                            phi_2485_ = select(_e1815, _e1811, _e1869);
                                                                            phi_2486_ = select(_e1811, _e1819, _e1869);
                                                                            phi_2487_ = select(_e1819, _e1815, _e1869);
                                                                        }
                                                                        let _e1875 = phi_2480_;
                                                                        let _e1877 = phi_2481_;
                                                                        let _e1879 = phi_2482_;
                                                                        let _e1881 = phi_2483_;
                                                                        let _e1883 = phi_2484_;
                                                                        let _e1885 = phi_2485_;
                                                                        let _e1887 = phi_2486_;
                                                                        let _e1889 = phi_2487_;
                                                                        let _e1896 = ((_e1887.y * _e1885.z) - (_e1885.y * _e1887.z));
                                                                        let _e1901 = ((_e1887.z * _e1885.x) - (_e1885.z * _e1887.x));
                                                                        let _e1904 = ((_e1887.x * _e1885.y) - (_e1885.x * _e1887.y));
                                                                        if (_e1704 >= _e1708) {
                                                                            phi_2518_ = select(true, false, (_e1704 >= _e1712));
                                                                        } else {
                                                                            phi_2518_ = true;
                                                                        }
                                                                        let _e1909 = phi_2518_;
                                                                        if _e1909 {
                                                                            phi_2527_ = select(_e1807, _e1806, vec3((_e1708 >= _e1712)));
                                                                        } else {
                                                                            phi_2527_ = _e1805;
                                                                        }
                                                                        let _e1914 = phi_2527_;
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
                                                                                phi_2692_ = (_e1925 / _e1930);
                                                                            } else {
                                                                                phi_2692_ = f32();
                                                                            }
                                                                            let _e2035 = phi_2692_;
                                                                            phi_2694_ = _e2035;
                                                                            phi_2695_ = select(true, false, _e2032);
                                                                        } else {
                                                                            phi_2694_ = f32();
                                                                            phi_2695_ = true;
                                                                        }
                                                                        let _e2038 = phi_2694_;
                                                                        let _e2040 = phi_2695_;
                                                                        if _e2040 {
                                                                            let _e2048 = (((_e1896 * (_e1957 - (_e368 * _e1960))) + (_e1901 * (_e1958 - (_e436 * _e1960)))) / _e1930);
                                                                            if (bitcast<f32>((bitcast<u32>(_e2048) & 2147483647u)) <= _e1862) {
                                                                                phi_2715_ = (_e1960 + _e2048);
                                                                            } else {
                                                                                phi_2715_ = _e1960;
                                                                            }
                                                                            let _e2055 = phi_2715_;
                                                                            phi_2716_ = _e2055;
                                                                        } else {
                                                                            phi_2716_ = _e2038;
                                                                        }
                                                                        let _e2057 = phi_2716_;
                                                                        let _e2059 = select(_e1795, _e2057, (_e2057 < _e1795));
                                                                        let _e2061 = select(_e1787, _e2059, (_e2059 > _e1787));
                                                                        if (_e2061 >= _e619) {
                                                                            let _e2063 = (_e2061 <= _e1195.member);
                                                                            if _e2063 {
                                                                                let _e2064 = (1f / _e1714);
                                                                                phi_2739_ = type_20(_e2061, (_e1708 * _e2064), (_e1712 * _e2064), _e1255);
                                                                            } else {
                                                                                phi_2739_ = type_20();
                                                                            }
                                                                            let _e2069 = phi_2739_;
                                                                            phi_2741_ = _e2069;
                                                                            phi_2742_ = select(true, false, _e2063);
                                                                        } else {
                                                                            phi_2741_ = type_20();
                                                                            phi_2742_ = true;
                                                                        }
                                                                        let _e2072 = phi_2741_;
                                                                        let _e2074 = phi_2742_;
                                                                        if _e2074 {
                                                                            phi_2746_ = type_20(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                        } else {
                                                                            phi_2746_ = _e2072;
                                                                        }
                                                                        let _e2076 = phi_2746_;
                                                                        phi_2747_ = _e2076;
                                                                    }
                                                                    let _e2078 = phi_2747_;
                                                                    phi_2748_ = _e2078;
                                                                    phi_2749_ = _e1804;
                                                                }
                                                                let _e2080 = phi_2748_;
                                                                let _e2082 = phi_2749_;
                                                                phi_2753_ = _e2080;
                                                                phi_2754_ = _e2082;
                                                            }
                                                            let _e2084 = phi_2753_;
                                                            let _e2086 = phi_2754_;
                                                            phi_2755_ = _e2084;
                                                            phi_2756_ = _e1739;
                                                            phi_2757_ = _e2086;
                                                        }
                                                        let _e2088 = phi_2755_;
                                                        let _e2090 = phi_2756_;
                                                        let _e2092 = phi_2757_;
                                                        phi_2758_ = _e2088;
                                                        phi_2759_ = _e2090;
                                                        phi_2760_ = _e2092;
                                                    }
                                                    let _e2094 = phi_2758_;
                                                    let _e2096 = phi_2759_;
                                                    let _e2098 = phi_2760_;
                                                    phi_2768_ = _e2094;
                                                    phi_2769_ = select(_e2098, true, _e2096);
                                                } else {
                                                    phi_2768_ = type_20();
                                                    phi_2769_ = true;
                                                }
                                                let _e2101 = phi_2768_;
                                                let _e2103 = phi_2769_;
                                                if _e2103 {
                                                    phi_2773_ = type_20(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                } else {
                                                    phi_2773_ = _e2101;
                                                }
                                                let _e2105 = phi_2773_;
                                                if (_e2105.member_3 != 4294967295u) {
                                                    if (_e1255 != 4294967295u) {
                                                        phi_2784_ = type_34(_e1195.member, true);
                                                    } else {
                                                        phi_2784_ = _e1195;
                                                    }
                                                    let _e2113 = phi_2784_;
                                                    phi_2785_ = _e2113;
                                                } else {
                                                    phi_2785_ = _e1195;
                                                }
                                                let _e2115 = phi_2785_;
                                                phi_1197_ = _e2115;
                                            } else {
                                                phi_1197_ = type_34();
                                            }
                                            let _e2117 = phi_1197_;
                                            continue;
                                            continuing {
                                                phi_1196_ = _e2117;
                                                phi_1199_ = _e1210;
                                                phi_4252_ = _e661;
                                                break if !(_e1216);
                                            }
                                        }
                                        let _e2120 = phi_4252_;
                                        phi_4456_ = _e2120;
                                        if _e2120 {
                                            break;
                                        }
                                        let _e2122 = local_10;
                                        phi_4460_ = _e2120;
                                        let _e2328 = local_12;
                                        phi_4026_ = _e2328;
                                        phi_4027_ = _e702;
                                        phi_4028_ = false;
                                        phi_4029_ = select(_e706, 0u, _e2122.member_1);
                                    } else {
                                        if (_e702.member_1 >= _e93) {
                                            phi_3582_ = type_46(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), type_45(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u), type_45(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u));
                                        } else {
                                            if (_e702.member_1 < _e93) {
                                            } else {
                                                phi_4456_ = true;
                                                break;
                                            }
                                            let _e718 = (_e264 * 2u);
                                            let _e720 = ((1u + _e718) % 7u);
                                            if (_e720 < 7u) {
                                            } else {
                                                phi_4456_ = true;
                                                break;
                                            }
                                            let _e725 = global_5.member[_e702.member_1][_e720];
                                            let _e727 = ((_e718 + 2u) % 7u);
                                            if (_e727 < 7u) {
                                            } else {
                                                phi_4456_ = true;
                                                break;
                                            }
                                            let _e732 = global_5.member[_e702.member_1][_e727];
                                            let _e733 = (_e263 * 2u);
                                            let _e735 = ((1u + _e733) % 7u);
                                            if (_e735 < 7u) {
                                            } else {
                                                phi_4456_ = true;
                                                break;
                                            }
                                            let _e740 = global_5.member[_e702.member_1][_e735];
                                            let _e742 = ((_e733 + 2u) % 7u);
                                            if (_e742 < 7u) {
                                            } else {
                                                phi_4456_ = true;
                                                break;
                                            }
                                            let _e747 = global_5.member[_e702.member_1][_e742];
                                            let _e748 = (_e265 * 2u);
                                            let _e750 = ((1u + _e748) % 7u);
                                            if (_e750 < 7u) {
                                            } else {
                                                phi_4456_ = true;
                                                break;
                                            }
                                            let _e755 = global_5.member[_e702.member_1][_e750];
                                            let _e757 = ((_e748 + 2u) % 7u);
                                            if (_e757 < 7u) {
                                            } else {
                                                phi_4456_ = true;
                                                break;
                                            }
                                            let _e762 = global_5.member[_e702.member_1][_e757];
                                            let _e785 = (bitcast<f32>((bitcast<u32>((_e702.member.member_1.x - _e702.member.member.x)) & 2139095040u)) * 0.0000009536743f);
                                            let _e786 = (bitcast<f32>((bitcast<u32>((_e702.member.member_1.y - _e702.member.member.y)) & 2139095040u)) * 0.0000009536743f);
                                            let _e787 = (bitcast<f32>((bitcast<u32>((_e702.member.member_1.z - _e702.member.member.z)) & 2139095040u)) * 0.0000009536743f);
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
                                            let _e902 = (_e702.member.member.x + _e832);
                                            let _e903 = (_e702.member.member.y + _e841);
                                            let _e904 = (_e702.member.member.z + _e850);
                                            let _e907 = (_e702.member.member_1.x - _e871);
                                            let _e908 = (_e702.member.member_1.y - _e880);
                                            let _e909 = (_e702.member.member_1.z - _e889);
                                            let _e928 = (_e907 - _e902);
                                            let _e929 = (_e908 - _e903);
                                            let _e930 = (_e909 - _e904);
                                            let _e932 = select(_e929, _e928, (_e928 > _e929));
                                            let _e934 = select(_e930, _e932, (_e932 > _e930));
                                            if (_e934 < (1024f * _e144)) {
                                                phi_3283_ = 0u;
                                            } else {
                                                phi_3283_ = select(2u, 1u, (_e934 < (2097152f * _e144)));
                                            }
                                            let _e941 = phi_3283_;
                                            switch bitcast<i32>(_e941) {
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
                                            let _e944 = phi_3289_;
                                            let _e950 = global_5.member[_e702.member_1][0u];
                                            let _e954 = global_5.member[_e702.member_1][2u];
                                            let _e958 = global_5.member[_e702.member_1][4u];
                                            let _e962 = global_5.member[_e702.member_1][6u];
                                            let _e974 = (((_e954 >> bitcast<u32>(22i)) | ((_e958 >> bitcast<u32>(22i)) << bitcast<u32>(10i))) | ((_e962 >> bitcast<u32>(22i)) << bitcast<u32>(20i)));
                                            let _e975 = (_e950 & 268435455u);
                                            let _e976 = (_e974 & 268435455u);
                                            let _e979 = ((_e950 >> bitcast<u32>(28u)) & 7u);
                                            let _e987 = ((_e950 >> bitcast<u32>(31i)) | (((_e974 >> bitcast<u32>(28u)) & 3u) << bitcast<u32>(1i)));
                                            let _e988 = (_e979 != 0u);
                                            if (_e979 == 0u) {
                                                phi_3544_ = _e975;
                                            } else {
                                                if (_e979 == 7u) {
                                                    phi_3543_ = 2147483648u;
                                                } else {
                                                    phi_3543_ = ((2147483648u | (_e979 << bitcast<u32>(28u))) | (_e976 & 268435455u));
                                                }
                                                let _e997 = phi_3543_;
                                                phi_3544_ = _e997;
                                            }
                                            let _e999 = phi_3544_;
                                            if _e988 {
                                                let _e1000 = (_e979 != 7u);
                                                if _e1000 {
                                                    phi_3554_ = (_e976 + (_e979 * ((3u * _e944) + 1u)));
                                                } else {
                                                    phi_3554_ = u32();
                                                }
                                                let _e1004 = phi_3554_;
                                                phi_3556_ = _e1004;
                                                phi_3557_ = select(true, false, _e1000);
                                            } else {
                                                phi_3556_ = u32();
                                                phi_3557_ = true;
                                            }
                                            let _e1007 = phi_3556_;
                                            let _e1009 = phi_3557_;
                                            if (_e987 == 0u) {
                                                phi_3578_ = (_e975 + select(0u, 1u, !(_e988)));
                                            } else {
                                                if (_e987 == 7u) {
                                                    phi_3577_ = 2147483648u;
                                                } else {
                                                    phi_3577_ = ((2147483648u | (_e987 << bitcast<u32>(28u))) | (select(_e1007, _e976, _e1009) & 268435455u));
                                                }
                                                let _e1022 = phi_3577_;
                                                phi_3578_ = _e1022;
                                            }
                                            let _e1024 = phi_3578_;
                                            phi_3582_ = type_46(array<vec4<f32>, 3>(vec4<f32>(_e902, (_e702.member.member.x + _e854), _e907, (_e702.member.member_1.x - _e893)), vec4<f32>(_e903, (_e702.member.member.y + _e858), _e908, (_e702.member.member_1.y - _e897)), vec4<f32>(_e904, (_e702.member.member.z + _e862), _e909, (_e702.member.member_1.z - _e901))), type_45(type_24((_e702.member.member + vec4<f32>(_e832, _e841, _e850, 0f)), (_e702.member.member_1 - vec4<f32>(_e871, _e880, _e889, 0f))), _e999), type_45(type_24((_e702.member.member + vec4<f32>(_e854, _e858, _e862, 0f)), (_e702.member.member_1 - vec4<f32>(_e893, _e897, _e901, 0f))), _e1024));
                                        }
                                        let _e1029 = phi_3582_;
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
                                                    phi_3926_ = _e1029.member_2;
                                                } else {
                                                    phi_3926_ = _e1029.member_1;
                                                }
                                                let _e1135 = phi_3926_;
                                                let _e1157 = (_e706 % 128u);
                                                let _e1158 = (_e1157 < 128u);
                                                if _e1158 {
                                                } else {
                                                    phi_4456_ = true;
                                                    break;
                                                }
                                                local_8[_e1157] = _e1135.member_1;
                                                if _e1158 {
                                                } else {
                                                    phi_4456_ = true;
                                                    break;
                                                }
                                                local_7[_e1157] = _e1135.member.member.x;
                                                if _e1158 {
                                                } else {
                                                    phi_4456_ = true;
                                                    break;
                                                }
                                                local_6[_e1157] = _e1135.member.member.y;
                                                if _e1158 {
                                                } else {
                                                    phi_4456_ = true;
                                                    break;
                                                }
                                                local_5[_e1157] = _e1135.member.member.z;
                                                if _e1158 {
                                                } else {
                                                    phi_4456_ = true;
                                                    break;
                                                }
                                                local_4[_e1157] = _e1135.member.member_1.x;
                                                if _e1158 {
                                                } else {
                                                    phi_4456_ = true;
                                                    break;
                                                }
                                                local_3[_e1157] = _e1135.member.member_1.y;
                                                if _e1158 {
                                                } else {
                                                    phi_4456_ = true;
                                                    break;
                                                }
                                                local_2[_e1157] = _e1135.member.member_1.z;
                                                if _e1158 {
                                                } else {
                                                    phi_4456_ = true;
                                                    break;
                                                }
                                                local_9[_e1157] = select(_e1124, _e1122, (_e1122 > _e1124));
                                                if _e1131 {
                                                    phi_4003_ = _e1029.member_1;
                                                } else {
                                                    phi_4003_ = _e1029.member_2;
                                                }
                                                let _e1171 = phi_4003_;
                                                phi_4004_ = _e1171;
                                                phi_4005_ = (_e706 + 1u);
                                            } else {
                                                phi_4004_ = type_45();
                                                phi_4005_ = u32();
                                            }
                                            let _e1173 = phi_4004_;
                                            let _e1175 = phi_4005_;
                                            phi_4007_ = _e1173;
                                            phi_4008_ = _e1175;
                                            phi_4009_ = select(true, false, _e1130);
                                        } else {
                                            phi_4007_ = type_45();
                                            phi_4008_ = u32();
                                            phi_4009_ = true;
                                        }
                                        let _e1178 = phi_4007_;
                                        let _e1180 = phi_4008_;
                                        let _e1182 = phi_4009_;
                                        if _e1182 {
                                            if _e1129 {
                                                phi_4018_ = _e1029.member_1;
                                            } else {
                                                phi_4018_ = _e1029.member_2;
                                            }
                                            let _e1186 = phi_4018_;
                                            phi_4023_ = _e1186;
                                            phi_4024_ = select(_e1130, true, _e1129);
                                        } else {
                                            phi_4023_ = _e1178;
                                            phi_4024_ = _e704;
                                        }
                                        let _e1189 = phi_4023_;
                                        let _e1191 = phi_4024_;
                                        phi_4460_ = _e661;
                                        phi_4026_ = _e663;
                                        phi_4027_ = _e1189;
                                        phi_4028_ = _e1191;
                                        phi_4029_ = select(_e1180, _e706, _e1182);
                                    }
                                    let _e2126 = phi_4460_;
                                    let _e2128 = phi_4026_;
                                    let _e2130 = phi_4027_;
                                    let _e2132 = phi_4028_;
                                    let _e2134 = phi_4029_;
                                    phi_4459_ = _e2126;
                                    phi_4030_ = _e2128;
                                    phi_4031_ = _e2130;
                                    phi_4032_ = (_e667 - 1u);
                                    phi_4033_ = _e2132;
                                    phi_4034_ = _e2134;
                                } else {
                                    phi_4459_ = _e661;
                                    phi_4030_ = _e663;
                                    phi_4031_ = _e702;
                                    phi_4032_ = _e667;
                                    phi_4033_ = _e704;
                                    phi_4034_ = _e706;
                                }
                                let _e2136 = phi_4459_;
                                let _e2138 = phi_4030_;
                                let _e2140 = phi_4031_;
                                let _e2142 = phi_4032_;
                                let _e2144 = phi_4033_;
                                let _e2146 = phi_4034_;
                                phi_4458_ = _e2136;
                                phi_4035_ = _e2138;
                                phi_4036_ = _e2140;
                                phi_4037_ = _e2142;
                                phi_4038_ = _e2144;
                                phi_4039_ = _e2146;
                            } else {
                                phi_4458_ = _e661;
                                phi_4035_ = type_34();
                                phi_4036_ = type_45();
                                phi_4037_ = u32();
                                phi_4038_ = bool();
                                phi_4039_ = u32();
                            }
                            let _e2148 = phi_4458_;
                            let _e2150 = phi_4035_;
                            let _e2152 = phi_4036_;
                            let _e2154 = phi_4037_;
                            let _e2156 = phi_4038_;
                            let _e2158 = phi_4039_;
                            phi_4457_ = _e2148;
                            phi_1070_ = _e2150;
                            phi_1073_ = _e2152;
                            phi_1075_ = _e2154;
                            phi_1077_ = _e2156;
                            phi_1079_ = _e2158;
                            phi_4040_ = _e675;
                        } else {
                            phi_4457_ = _e661;
                            phi_1070_ = type_34();
                            phi_1073_ = type_45();
                            phi_1075_ = u32();
                            phi_1077_ = bool();
                            phi_1079_ = u32();
                            phi_4040_ = false;
                        }
                        let _e2160 = phi_4457_;
                        let _e2162 = phi_1070_;
                        let _e2164 = phi_1073_;
                        let _e2166 = phi_1075_;
                        let _e2168 = phi_1077_;
                        let _e2170 = phi_1079_;
                        let _e2172 = phi_4040_;
                        continue;
                        continuing {
                            phi_4258_ = _e2160;
                            phi_1069_ = _e2162;
                            phi_1072_ = _e2164;
                            phi_1074_ = _e2166;
                            phi_1076_ = _e2168;
                            phi_1078_ = _e2170;
                            phi_4456_ = _e2160;
                            break if !(_e2172);
                        }
                    }
                    let _e2175 = phi_4456_;
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
