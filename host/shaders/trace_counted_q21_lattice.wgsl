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
    member: array<array<u32, 2>>,
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

struct type_33 {
    member: type_24,
    member_1: f32,
}

struct type_37 {
    member: array<type_25>,
}

struct type_39 {
    member: type_33,
    member_1: u32,
    member_2: u32,
}

struct type_41 {
    member: array<vec4<u32>, 2>,
}

struct type_45 {
    member: array<array<u32, 7>>,
}

struct type_50 {
    member: type_28,
    member_1: u32,
}

struct type_51 {
    member: array<vec4<f32>, 3>,
    member_1: type_50,
    member_2: type_50,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_1: type_12;
@group(0) @binding(1) 
var<uniform> global_2: type_41;
@group(0) @binding(4) 
var<storage> global_3: type_37;
@group(0) @binding(2) 
var<storage> global_4: type_45;
@group(0) @binding(3) 
var<storage> global_5: type_4;
@group(0) @binding(5) 
var<storage, read_write> global_6: type_20;

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
    var phi_1094_: type_39;
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
    var phi_1221_: type_39;
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
    var phi_2853_: type_24;
    var phi_2855_: type_24;
    var phi_2856_: bool;
    var phi_2860_: type_24;
    var phi_2861_: type_24;
    var phi_2862_: type_24;
    var phi_2863_: bool;
    var phi_2867_: type_24;
    var phi_2868_: bool;
    var phi_2869_: type_24;
    var phi_2870_: bool;
    var phi_2871_: bool;
    var phi_2872_: type_24;
    var phi_2873_: bool;
    var phi_2874_: bool;
    var phi_2882_: type_24;
    var phi_2883_: bool;
    var phi_2887_: type_24;
    var phi_2912_: bool;
    var phi_2913_: bool;
    var phi_2920_: type_39;
    var phi_2921_: type_39;
    var phi_2922_: type_39;
    var phi_1222_: type_39;
    var phi_4425_: bool;
    var phi_4636_: bool;
    var phi_4197_: type_39;
    var phi_4198_: bool;
    var phi_4199_: u32;
    var phi_4200_: type_50;
    var phi_4635_: bool;
    var phi_4201_: type_39;
    var phi_4202_: bool;
    var phi_4203_: u32;
    var phi_4204_: u32;
    var phi_4205_: type_50;
    var phi_4634_: bool;
    var phi_4206_: type_39;
    var phi_4207_: bool;
    var phi_4208_: u32;
    var phi_4209_: u32;
    var phi_4210_: type_50;
    var phi_4633_: bool;
    var phi_1095_: type_39;
    var phi_1098_: bool;
    var phi_1100_: u32;
    var phi_1102_: u32;
    var phi_1104_: type_50;
    var phi_4211_: bool;
    var phi_4632_: bool;
    var local_10: type_39;
    var local_11: type_39;
    var local_12: type_39;

    switch bitcast<i32>(0u) {
        default: {
            let _e91 = global;
            let _e93 = arrayLength((&global_4.member));
            let _e96 = arrayLength((&global_5.member));
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
                let _e152 = (_e150 < arrayLength((&global_6.member)));
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
                            phi_404_ = (bitcast<i32>((_e229 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_404_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e229)), 32u, (_e229 == 0u))));
                        }
                        let _e243 = phi_404_;
                        phi_405_ = _e243;
                    } else {
                        phi_405_ = 0i;
                    }
                    let _e245 = phi_405_;
                    let _e246 = (_e162 == _e201);
                    if _e246 {
                        phi_415_ = true;
                    } else {
                        phi_415_ = (_e169 == _e201);
                    }
                    let _e249 = phi_415_;
                    let _e250 = select(1u, 0u, _e246);
                    if _e249 {
                        let _e251 = (_e250 + 1u);
                        phi_425_ = _e251;
                        phi_426_ = _e251;
                        phi_428_ = select(true, false, (_e251 == 2u));
                    } else {
                        phi_425_ = u32();
                        phi_426_ = 0u;
                        phi_428_ = true;
                    }
                    let _e255 = phi_425_;
                    let _e257 = phi_426_;
                    let _e259 = phi_428_;
                    if _e259 {
                        phi_433_ = (_e257 + 1u);
                    } else {
                        phi_433_ = 0u;
                    }
                    let _e263 = phi_433_;
                    let _e264 = select(_e255, _e257, _e259);
                    let _e265 = select(_e250, select(2u, _e250, _e249), _e259);
                    if (_e132 < -126i) {
                        phi_446_ = -126i;
                    } else {
                        phi_446_ = select(_e132, 127i, (_e132 > 127i));
                    }
                    let _e270 = phi_446_;
                    let _e275 = bitcast<f32>((bitcast<u32>((_e270 + 127i)) << bitcast<u32>(23i)));
                    let _e281 = bitcast<f32>((bitcast<u32>(((_e132 - _e270) + 127i)) << bitcast<u32>(23i)));
                    let _e282 = -(_e245);
                    if (_e282 < -126i) {
                        phi_466_ = -126i;
                    } else {
                        phi_466_ = select(_e282, 127i, (_e282 > 127i));
                    }
                    let _e287 = phi_466_;
                    let _e292 = bitcast<f32>((bitcast<u32>((_e287 + 127i)) << bitcast<u32>(23i)));
                    let _e298 = bitcast<f32>((bitcast<u32>(((_e282 - _e287) + 127i)) << bitcast<u32>(23i)));
                    let _e302 = global_3.member[_e150].member;
                    let _e303 = (_e264 == 0u);
                    if _e303 {
                        phi_484_ = _e302[0];
                    } else {
                        phi_484_ = _e302[1];
                    }
                    let _e307 = phi_484_;
                    let _e308 = (_e264 == 2u);
                    if _e308 {
                        phi_490_ = _e302[2];
                    } else {
                        phi_490_ = _e307;
                    }
                    let _e311 = phi_490_;
                    let _e312 = bitcast<u32>(_e311);
                    let _e314 = ((_e312 & 2139095040u) != 0u);
                    let _e328 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e312 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e312 & 2147483648u))), _e311, _e314) * _e275) * select(0.00000011920929f, 1f, _e314)) * _e281);
                    let _e329 = global_3.member[_e150].member_2;
                    if _e303 {
                        phi_530_ = _e329[0];
                    } else {
                        phi_530_ = _e329[1];
                    }
                    let _e333 = phi_530_;
                    if _e308 {
                        phi_536_ = _e329[2];
                    } else {
                        phi_536_ = _e333;
                    }
                    let _e336 = phi_536_;
                    let _e337 = bitcast<u32>(_e336);
                    let _e339 = ((_e337 & 2139095040u) != 0u);
                    let _e353 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e337 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e337 & 2147483648u))), _e336, _e339) * _e292) * select(0.00000011920929f, 1f, _e339)) * _e298);
                    let _e357 = (bitcast<f32>((bitcast<u32>(_e353) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e357 {
                        let _e361 = (bitcast<f32>((bitcast<u32>(_e328) & 2147483647u)) * 0.00000011920929f);
                        phi_588_ = select(0.00000000000011368684f, _e361, (_e361 > 0.00000000000011368684f));
                    } else {
                        phi_588_ = 0f;
                    }
                    let _e365 = phi_588_;
                    let _e366 = (_e328 + _e365);
                    let _e367 = (_e328 - _e365);
                    let _e368 = select(_e353, 0f, _e357);
                    if _e357 {
                        phi_600_ = 38685626000000000000000000f;
                    } else {
                        phi_600_ = (1f / _e353);
                    }
                    let _e371 = phi_600_;
                    let _e372 = (_e263 == 0u);
                    if _e372 {
                        phi_609_ = _e302[0];
                    } else {
                        phi_609_ = _e302[1];
                    }
                    let _e376 = phi_609_;
                    let _e377 = (_e263 == 2u);
                    if _e377 {
                        phi_615_ = _e302[2];
                    } else {
                        phi_615_ = _e376;
                    }
                    let _e380 = phi_615_;
                    let _e381 = bitcast<u32>(_e380);
                    let _e383 = ((_e381 & 2139095040u) != 0u);
                    let _e397 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e381 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e381 & 2147483648u))), _e380, _e383) * _e275) * select(0.00000011920929f, 1f, _e383)) * _e281);
                    if _e372 {
                        phi_655_ = _e329[0];
                    } else {
                        phi_655_ = _e329[1];
                    }
                    let _e401 = phi_655_;
                    if _e377 {
                        phi_661_ = _e329[2];
                    } else {
                        phi_661_ = _e401;
                    }
                    let _e404 = phi_661_;
                    let _e405 = bitcast<u32>(_e404);
                    let _e407 = ((_e405 & 2139095040u) != 0u);
                    let _e421 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e405 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e405 & 2147483648u))), _e404, _e407) * _e292) * select(0.00000011920929f, 1f, _e407)) * _e298);
                    let _e425 = (bitcast<f32>((bitcast<u32>(_e421) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e425 {
                        let _e429 = (bitcast<f32>((bitcast<u32>(_e397) & 2147483647u)) * 0.00000011920929f);
                        phi_713_ = select(0.00000000000011368684f, _e429, (_e429 > 0.00000000000011368684f));
                    } else {
                        phi_713_ = 0f;
                    }
                    let _e433 = phi_713_;
                    let _e434 = (_e397 + _e433);
                    let _e435 = (_e397 - _e433);
                    let _e436 = select(_e421, 0f, _e425);
                    if _e425 {
                        phi_725_ = 38685626000000000000000000f;
                    } else {
                        phi_725_ = (1f / _e421);
                    }
                    let _e439 = phi_725_;
                    let _e440 = (_e265 == 0u);
                    if _e440 {
                        phi_734_ = _e302[0];
                    } else {
                        phi_734_ = _e302[1];
                    }
                    let _e444 = phi_734_;
                    let _e445 = (_e265 == 2u);
                    if _e445 {
                        phi_740_ = _e302[2];
                    } else {
                        phi_740_ = _e444;
                    }
                    let _e448 = phi_740_;
                    let _e449 = bitcast<u32>(_e448);
                    let _e451 = ((_e449 & 2139095040u) != 0u);
                    let _e465 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e449 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e449 & 2147483648u))), _e448, _e451) * _e275) * select(0.00000011920929f, 1f, _e451)) * _e281);
                    if _e440 {
                        phi_780_ = _e329[0];
                    } else {
                        phi_780_ = _e329[1];
                    }
                    let _e469 = phi_780_;
                    if _e445 {
                        phi_786_ = _e329[2];
                    } else {
                        phi_786_ = _e469;
                    }
                    let _e472 = phi_786_;
                    let _e473 = bitcast<u32>(_e472);
                    let _e475 = ((_e473 & 2139095040u) != 0u);
                    let _e489 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e473 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e473 & 2147483648u))), _e472, _e475) * _e292) * select(0.00000011920929f, 1f, _e475)) * _e298);
                    let _e493 = (bitcast<f32>((bitcast<u32>(_e489) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e493 {
                        let _e497 = (bitcast<f32>((bitcast<u32>(_e465) & 2147483647u)) * 0.00000011920929f);
                        phi_838_ = select(0.00000000000011368684f, _e497, (_e497 > 0.00000000000011368684f));
                    } else {
                        phi_838_ = 0f;
                    }
                    let _e501 = phi_838_;
                    let _e502 = (_e465 + _e501);
                    let _e503 = (_e465 - _e501);
                    let _e504 = select(_e489, 0f, _e493);
                    if _e493 {
                        phi_850_ = 38685626000000000000000000f;
                    } else {
                        phi_850_ = (1f / _e489);
                    }
                    let _e507 = phi_850_;
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
                            phi_905_ = 255i;
                        } else {
                            phi_905_ = (((_e534 + select(0i, 1i, (_e534 == 0i))) - _e541) + _e521);
                        }
                        let _e549 = phi_905_;
                        let _e559 = (_e549 <= 0i);
                        if _e559 {
                            phi_928_ = u32();
                        } else {
                            if _e538 {
                                phi_927_ = u32();
                            } else {
                                phi_927_ = select(((bitcast<u32>(_e549) << bitcast<u32>(23i)) | ((_e531 << bitcast<u32>(((_e541 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e549 >= 255i));
                            }
                            let _e563 = phi_927_;
                            phi_928_ = _e563;
                        }
                        let _e565 = phi_928_;
                        let _e577 = ((_e222 & 8388607u) | (select(0u, 1u, ((_e222 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                        let _e580 = bitcast<i32>((_e222 >> bitcast<u32>(23i)));
                        let _e584 = (_e577 == 0u);
                        let _e587 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e577)), 32u, _e584)) - 8i);
                        if (_e580 == 255i) {
                            phi_965_ = 255i;
                        } else {
                            phi_965_ = (((_e580 + select(0i, 1i, (_e580 == 0i))) - _e587) + _e521);
                        }
                        let _e595 = phi_965_;
                        let _e605 = (_e595 <= 0i);
                        if _e605 {
                            phi_988_ = u32();
                        } else {
                            if _e584 {
                                phi_987_ = u32();
                            } else {
                                phi_987_ = select(((bitcast<u32>(_e595) << bitcast<u32>(23i)) | ((_e577 << bitcast<u32>(((_e587 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e595 >= 255i));
                            }
                            let _e609 = phi_987_;
                            phi_988_ = _e609;
                        }
                        let _e611 = phi_988_;
                        phi_996_ = bitcast<f32>(((_e221 & 2147483648u) | select(_e611, 0u, select(_e584, true, _e605))));
                        phi_997_ = bitcast<f32>(((_e212 & 2147483648u) | select(_e565, 0u, select(_e538, true, _e559))));
                    } else {
                        phi_996_ = 0f;
                        phi_997_ = 1f;
                    }
                    let _e617 = phi_996_;
                    let _e619 = phi_997_;
                    local_8 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                    local_7 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_6 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_5 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_4 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_3 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_9 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    let _e624 = (_e264 % 3u);
                    let _e625 = (_e624 < 3u);
                    if _e625 {
                    } else {
                        break;
                    }
                    let _e627 = local_1[_e624];
                    let _e630 = (_e263 % 3u);
                    let _e631 = (_e630 < 3u);
                    if _e631 {
                    } else {
                        break;
                    }
                    let _e633 = local_1[_e630];
                    let _e636 = (_e265 % 3u);
                    let _e637 = (_e636 < 3u);
                    if _e637 {
                    } else {
                        break;
                    }
                    let _e639 = local_1[_e636];
                    if _e625 {
                    } else {
                        break;
                    }
                    let _e644 = local[_e624];
                    if _e631 {
                    } else {
                        break;
                    }
                    let _e648 = local[_e630];
                    if _e637 {
                    } else {
                        break;
                    }
                    let _e652 = local[_e636];
                    phi_4431_ = false;
                    phi_1094_ = type_39(type_33(type_24(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e617), 0u, 0u);
                    phi_1097_ = (_e619 <= _e617);
                    phi_1099_ = ((3u * _e93) + 1u);
                    phi_1101_ = 0u;
                    phi_1103_ = type_50(type_28(vec4<f32>((f32(_e627) * _e144), (f32(_e633) * _e144), (f32(_e639) * _e144), 0f), vec4<f32>((f32(_e644) * _e144), (f32(_e648) * _e144), (f32(_e652) * _e144), 0f)), select(0u, 2147483648u, (_e93 == 0u)));
                    loop {
                        let _e662 = phi_4431_;
                        let _e664 = phi_1094_;
                        let _e666 = phi_1097_;
                        let _e668 = phi_1099_;
                        let _e670 = phi_1101_;
                        let _e672 = phi_1103_;
                        local_10 = _e664;
                        local_11 = _e664;
                        if _e666 {
                            phi_1114_ = true;
                        } else {
                            phi_1114_ = (_e670 > 0u);
                        }
                        let _e675 = phi_1114_;
                        if _e675 {
                            let _e676 = (_e668 > 0u);
                            if _e676 {
                                if _e666 {
                                    phi_1200_ = _e666;
                                    phi_1201_ = _e670;
                                    phi_1202_ = _e672;
                                } else {
                                    let _e677 = (_e670 - 1u);
                                    let _e678 = (_e677 % 128u);
                                    let _e679 = (_e678 < 128u);
                                    if _e679 {
                                    } else {
                                        phi_4632_ = true;
                                        break;
                                    }
                                    let _e681 = local_7[_e678];
                                    if _e679 {
                                    } else {
                                        phi_4632_ = true;
                                        break;
                                    }
                                    let _e683 = local_6[_e678];
                                    if _e679 {
                                    } else {
                                        phi_4632_ = true;
                                        break;
                                    }
                                    let _e685 = local_5[_e678];
                                    if _e679 {
                                    } else {
                                        phi_4632_ = true;
                                        break;
                                    }
                                    let _e687 = local_4[_e678];
                                    if _e679 {
                                    } else {
                                        phi_4632_ = true;
                                        break;
                                    }
                                    let _e689 = local_3[_e678];
                                    if _e679 {
                                    } else {
                                        phi_4632_ = true;
                                        break;
                                    }
                                    let _e691 = local_2[_e678];
                                    if _e679 {
                                    } else {
                                        phi_4632_ = true;
                                        break;
                                    }
                                    let _e696 = local_8[_e678];
                                    if _e679 {
                                    } else {
                                        phi_4632_ = true;
                                        break;
                                    }
                                    let _e699 = local_9[_e678];
                                    phi_1200_ = (_e699 <= _e664.member.member_1);
                                    phi_1201_ = _e677;
                                    phi_1202_ = type_50(type_28(vec4<f32>(_e681, _e683, _e685, 0f), vec4<f32>(_e687, _e689, _e691, 0f)), _e696);
                                }
                                let _e704 = phi_1200_;
                                let _e706 = phi_1201_;
                                let _e708 = phi_1202_;
                                if _e704 {
                                    let _e713 = (_e708.member_1 & 268435455u);
                                    if ((_e708.member_1 & 2147483648u) != 0u) {
                                        phi_1221_ = _e664;
                                        phi_1224_ = type_8(0u, ((_e708.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e1204 = phi_1221_;
                                            let _e1206 = phi_1224_;
                                            local_12 = _e1204;
                                            if (_e1206.member < _e1206.member_1) {
                                                phi_1225_ = type_8((_e1206.member + 1u), _e1206.member_1);
                                                phi_1247_ = type_8(1u, _e1206.member);
                                            } else {
                                                phi_1225_ = _e1206;
                                                phi_1247_ = type_8(0u, type_8().member_1);
                                            }
                                            let _e1219 = phi_1225_;
                                            let _e1221 = phi_1247_;
                                            let _e1225 = (bitcast<i32>(_e1221.member) != 0i);
                                            if _e1225 {
                                                let _e1231 = type_39(_e1204.member, _e1204.member_1, (_e1204.member_2 + 1u));
                                                let _e1236 = (_e708.member.member_1.x - _e708.member.member.x);
                                                let _e1239 = (_e708.member.member_1.y - _e708.member.member.y);
                                                let _e1242 = (_e708.member.member_1.z - _e708.member.member.z);
                                                let _e1244 = select(_e1239, _e1236, (_e1236 > _e1239));
                                                let _e1246 = select(_e1242, _e1244, (_e1244 > _e1242));
                                                let _e1248 = (_e1246 < (1024f * _e144));
                                                if _e1248 {
                                                    phi_1291_ = 0u;
                                                } else {
                                                    phi_1291_ = select(2u, 1u, (_e1246 < (2097152f * _e144)));
                                                }
                                                let _e1253 = phi_1291_;
                                                switch bitcast<i32>(_e1253) {
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
                                                let _e1256 = phi_1297_;
                                                switch bitcast<i32>(_e1253) {
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
                                                let _e1263 = phi_1307_;
                                                let _e1265 = ((_e713 + (_e1221.member_1 * ((3u * _e1256) + 1u))) + (3u * _e1263));
                                                let _e1266 = (_e1265 < _e96);
                                                if _e1266 {
                                                    if _e1266 {
                                                    } else {
                                                        phi_4425_ = true;
                                                        break;
                                                    }
                                                    let _e1268 = global_5.member[_e1265];
                                                    phi_1323_ = _e1268;
                                                } else {
                                                    phi_1323_ = 4294967295u;
                                                }
                                                let _e1270 = phi_1323_;
                                                if _e1248 {
                                                    phi_1356_ = 0u;
                                                } else {
                                                    phi_1356_ = select(2u, 1u, (_e1246 < (2097152f * _e144)));
                                                }
                                                let _e1275 = phi_1356_;
                                                switch bitcast<i32>(_e1275) {
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
                                                let _e1278 = phi_1362_;
                                                let _e1282 = (_e713 + (_e1221.member_1 * ((3u * _e1278) + 1u)));
                                                switch bitcast<i32>(_e1275) {
                                                    case 0: {
                                                        let _e1557 = (_e1282 < _e96);
                                                        if _e1557 {
                                                            if _e1557 {
                                                            } else {
                                                                phi_4425_ = true;
                                                                break;
                                                            }
                                                            let _e1559 = global_5.member[_e1282];
                                                            phi_1389_ = _e1559;
                                                        } else {
                                                            phi_1389_ = 0u;
                                                        }
                                                        let _e1561 = phi_1389_;
                                                        let _e1563 = ((10u * _e264) & 31u);
                                                        let _e1573 = ((10u * _e263) & 31u);
                                                        let _e1583 = ((10u * _e265) & 31u);
                                                        let _e1593 = (_e1282 + 1u);
                                                        let _e1594 = (_e1593 < _e96);
                                                        if _e1594 {
                                                            if _e1594 {
                                                            } else {
                                                                phi_4425_ = true;
                                                                break;
                                                            }
                                                            let _e1596 = global_5.member[_e1593];
                                                            phi_1438_ = _e1596;
                                                        } else {
                                                            phi_1438_ = 0u;
                                                        }
                                                        let _e1598 = phi_1438_;
                                                        let _e1624 = (_e1282 + 2u);
                                                        let _e1625 = (_e1624 < _e96);
                                                        if _e1625 {
                                                            if _e1625 {
                                                            } else {
                                                                phi_4425_ = true;
                                                                break;
                                                            }
                                                            let _e1627 = global_5.member[_e1624];
                                                            phi_1487_ = _e1627;
                                                        } else {
                                                            phi_1487_ = 0u;
                                                        }
                                                        let _e1629 = phi_1487_;
                                                        phi_1988_ = array<array<f32, 3>, 3>(array<f32, 3>((_e708.member.member.x + ((bitcast<f32>((1258291200u | ((_e1561 >> bitcast<u32>(_e1563)) & 1023u))) - 8388608f) * _e144)), (_e708.member.member.y + ((bitcast<f32>((1258291200u | ((_e1561 >> bitcast<u32>(_e1573)) & 1023u))) - 8388608f) * _e144)), (_e708.member.member.z + ((bitcast<f32>((1258291200u | ((_e1561 >> bitcast<u32>(_e1583)) & 1023u))) - 8388608f) * _e144))), array<f32, 3>((_e708.member.member.x + ((bitcast<f32>((1258291200u | ((_e1598 >> bitcast<u32>(_e1563)) & 1023u))) - 8388608f) * _e144)), (_e708.member.member.y + ((bitcast<f32>((1258291200u | ((_e1598 >> bitcast<u32>(_e1573)) & 1023u))) - 8388608f) * _e144)), (_e708.member.member.z + ((bitcast<f32>((1258291200u | ((_e1598 >> bitcast<u32>(_e1583)) & 1023u))) - 8388608f) * _e144))), array<f32, 3>((_e708.member.member.x + ((bitcast<f32>((1258291200u | ((_e1629 >> bitcast<u32>(_e1563)) & 1023u))) - 8388608f) * _e144)), (_e708.member.member.y + ((bitcast<f32>((1258291200u | ((_e1629 >> bitcast<u32>(_e1573)) & 1023u))) - 8388608f) * _e144)), (_e708.member.member.z + ((bitcast<f32>((1258291200u | ((_e1629 >> bitcast<u32>(_e1583)) & 1023u))) - 8388608f) * _e144))));
                                                        break;
                                                    }
                                                    case 1: {
                                                        let _e1371 = (_e1282 < _e96);
                                                        if _e1371 {
                                                            if _e1371 {
                                                            } else {
                                                                phi_4425_ = true;
                                                                break;
                                                            }
                                                            let _e1373 = global_5.member[_e1282];
                                                            phi_1536_ = _e1373;
                                                        } else {
                                                            phi_1536_ = 0u;
                                                        }
                                                        let _e1375 = phi_1536_;
                                                        let _e1376 = (_e1282 + 1u);
                                                        let _e1377 = (_e1376 < _e96);
                                                        if _e1377 {
                                                            if _e1377 {
                                                            } else {
                                                                phi_4425_ = true;
                                                                break;
                                                            }
                                                            let _e1379 = global_5.member[_e1376];
                                                            phi_1551_ = _e1379;
                                                        } else {
                                                            phi_1551_ = 0u;
                                                        }
                                                        let _e1381 = phi_1551_;
                                                        let _e1382 = (_e264 == 1u);
                                                        if _e1382 {
                                                            phi_1561_ = ((_e1375 >> bitcast<u32>(21i)) | (_e1381 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1561_ = (_e1381 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1391 = phi_1561_;
                                                        let _e1399 = (_e263 == 1u);
                                                        if _e1399 {
                                                            phi_1582_ = ((_e1375 >> bitcast<u32>(21i)) | (_e1381 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1582_ = (_e1381 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1408 = phi_1582_;
                                                        let _e1416 = (_e265 == 1u);
                                                        if _e1416 {
                                                            phi_1603_ = ((_e1375 >> bitcast<u32>(21i)) | (_e1381 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1603_ = (_e1381 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1425 = phi_1603_;
                                                        let _e1434 = (_e1282 + 2u);
                                                        let _e1435 = (_e1434 < _e96);
                                                        if _e1435 {
                                                            if _e1435 {
                                                            } else {
                                                                phi_4425_ = true;
                                                                break;
                                                            }
                                                            let _e1437 = global_5.member[_e1434];
                                                            phi_1633_ = _e1437;
                                                        } else {
                                                            phi_1633_ = 0u;
                                                        }
                                                        let _e1439 = phi_1633_;
                                                        let _e1440 = (_e1282 + 3u);
                                                        let _e1441 = (_e1440 < _e96);
                                                        if _e1441 {
                                                            if _e1441 {
                                                            } else {
                                                                phi_4425_ = true;
                                                                break;
                                                            }
                                                            let _e1443 = global_5.member[_e1440];
                                                            phi_1648_ = _e1443;
                                                        } else {
                                                            phi_1648_ = 0u;
                                                        }
                                                        let _e1445 = phi_1648_;
                                                        if _e1382 {
                                                            phi_1658_ = ((_e1439 >> bitcast<u32>(21i)) | (_e1445 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1658_ = (_e1445 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1454 = phi_1658_;
                                                        if _e1399 {
                                                            phi_1679_ = ((_e1439 >> bitcast<u32>(21i)) | (_e1445 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1679_ = (_e1445 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1470 = phi_1679_;
                                                        if _e1416 {
                                                            phi_1700_ = ((_e1439 >> bitcast<u32>(21i)) | (_e1445 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1700_ = (_e1445 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1486 = phi_1700_;
                                                        let _e1495 = (_e1282 + 4u);
                                                        let _e1496 = (_e1495 < _e96);
                                                        if _e1496 {
                                                            if _e1496 {
                                                            } else {
                                                                phi_4425_ = true;
                                                                break;
                                                            }
                                                            let _e1498 = global_5.member[_e1495];
                                                            phi_1730_ = _e1498;
                                                        } else {
                                                            phi_1730_ = 0u;
                                                        }
                                                        let _e1500 = phi_1730_;
                                                        let _e1501 = (_e1282 + 5u);
                                                        let _e1502 = (_e1501 < _e96);
                                                        if _e1502 {
                                                            if _e1502 {
                                                            } else {
                                                                phi_4425_ = true;
                                                                break;
                                                            }
                                                            let _e1504 = global_5.member[_e1501];
                                                            phi_1745_ = _e1504;
                                                        } else {
                                                            phi_1745_ = 0u;
                                                        }
                                                        let _e1506 = phi_1745_;
                                                        if _e1382 {
                                                            phi_1755_ = ((_e1500 >> bitcast<u32>(21i)) | (_e1506 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1755_ = (_e1506 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1515 = phi_1755_;
                                                        if _e1399 {
                                                            phi_1776_ = ((_e1500 >> bitcast<u32>(21i)) | (_e1506 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1776_ = (_e1506 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1531 = phi_1776_;
                                                        if _e1416 {
                                                            phi_1797_ = ((_e1500 >> bitcast<u32>(21i)) | (_e1506 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1797_ = (_e1506 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1547 = phi_1797_;
                                                        phi_1988_ = array<array<f32, 3>, 3>(array<f32, 3>((_e708.member.member.x + ((bitcast<f32>((1258291200u | (select(_e1391, _e1375, _e303) & 2097151u))) - 8388608f) * _e144)), (_e708.member.member.y + ((bitcast<f32>((1258291200u | (select(_e1408, _e1375, _e372) & 2097151u))) - 8388608f) * _e144)), (_e708.member.member.z + ((bitcast<f32>((1258291200u | (select(_e1425, _e1375, _e440) & 2097151u))) - 8388608f) * _e144))), array<f32, 3>((_e708.member.member.x + ((bitcast<f32>((1258291200u | (select(_e1454, _e1439, _e303) & 2097151u))) - 8388608f) * _e144)), (_e708.member.member.y + ((bitcast<f32>((1258291200u | (select(_e1470, _e1439, _e372) & 2097151u))) - 8388608f) * _e144)), (_e708.member.member.z + ((bitcast<f32>((1258291200u | (select(_e1486, _e1439, _e440) & 2097151u))) - 8388608f) * _e144))), array<f32, 3>((_e708.member.member.x + ((bitcast<f32>((1258291200u | (select(_e1515, _e1500, _e303) & 2097151u))) - 8388608f) * _e144)), (_e708.member.member.y + ((bitcast<f32>((1258291200u | (select(_e1531, _e1500, _e372) & 2097151u))) - 8388608f) * _e144)), (_e708.member.member.z + ((bitcast<f32>((1258291200u | (select(_e1547, _e1500, _e440) & 2097151u))) - 8388608f) * _e144))));
                                                        break;
                                                    }
                                                    case 2: {
                                                        let _e1284 = (_e1282 + _e264);
                                                        let _e1285 = (_e1284 < _e96);
                                                        if _e1285 {
                                                            if _e1285 {
                                                            } else {
                                                                phi_4425_ = true;
                                                                break;
                                                            }
                                                            let _e1287 = global_5.member[_e1284];
                                                            phi_1828_ = _e1287;
                                                        } else {
                                                            phi_1828_ = 0u;
                                                        }
                                                        let _e1289 = phi_1828_;
                                                        let _e1293 = (_e1282 + _e263);
                                                        let _e1294 = (_e1293 < _e96);
                                                        if _e1294 {
                                                            if _e1294 {
                                                            } else {
                                                                phi_4425_ = true;
                                                                break;
                                                            }
                                                            let _e1296 = global_5.member[_e1293];
                                                            phi_1846_ = _e1296;
                                                        } else {
                                                            phi_1846_ = 0u;
                                                        }
                                                        let _e1298 = phi_1846_;
                                                        let _e1302 = (_e1282 + _e265);
                                                        let _e1303 = (_e1302 < _e96);
                                                        if _e1303 {
                                                            if _e1303 {
                                                            } else {
                                                                phi_4425_ = true;
                                                                break;
                                                            }
                                                            let _e1305 = global_5.member[_e1302];
                                                            phi_1864_ = _e1305;
                                                        } else {
                                                            phi_1864_ = 0u;
                                                        }
                                                        let _e1307 = phi_1864_;
                                                        let _e1312 = (_e1282 + 3u);
                                                        let _e1313 = (_e1312 + _e264);
                                                        let _e1314 = (_e1313 < _e96);
                                                        if _e1314 {
                                                            if _e1314 {
                                                            } else {
                                                                phi_4425_ = true;
                                                                break;
                                                            }
                                                            let _e1316 = global_5.member[_e1313];
                                                            phi_1887_ = _e1316;
                                                        } else {
                                                            phi_1887_ = 0u;
                                                        }
                                                        let _e1318 = phi_1887_;
                                                        let _e1322 = (_e1312 + _e263);
                                                        let _e1323 = (_e1322 < _e96);
                                                        if _e1323 {
                                                            if _e1323 {
                                                            } else {
                                                                phi_4425_ = true;
                                                                break;
                                                            }
                                                            let _e1325 = global_5.member[_e1322];
                                                            phi_1905_ = _e1325;
                                                        } else {
                                                            phi_1905_ = 0u;
                                                        }
                                                        let _e1327 = phi_1905_;
                                                        let _e1331 = (_e1312 + _e265);
                                                        let _e1332 = (_e1331 < _e96);
                                                        if _e1332 {
                                                            if _e1332 {
                                                            } else {
                                                                phi_4425_ = true;
                                                                break;
                                                            }
                                                            let _e1334 = global_5.member[_e1331];
                                                            phi_1923_ = _e1334;
                                                        } else {
                                                            phi_1923_ = 0u;
                                                        }
                                                        let _e1336 = phi_1923_;
                                                        let _e1341 = (_e1282 + 6u);
                                                        let _e1342 = (_e1341 + _e264);
                                                        let _e1343 = (_e1342 < _e96);
                                                        if _e1343 {
                                                            if _e1343 {
                                                            } else {
                                                                phi_4425_ = true;
                                                                break;
                                                            }
                                                            let _e1345 = global_5.member[_e1342];
                                                            phi_1946_ = _e1345;
                                                        } else {
                                                            phi_1946_ = 0u;
                                                        }
                                                        let _e1347 = phi_1946_;
                                                        let _e1351 = (_e1341 + _e263);
                                                        let _e1352 = (_e1351 < _e96);
                                                        if _e1352 {
                                                            if _e1352 {
                                                            } else {
                                                                phi_4425_ = true;
                                                                break;
                                                            }
                                                            let _e1354 = global_5.member[_e1351];
                                                            phi_1964_ = _e1354;
                                                        } else {
                                                            phi_1964_ = 0u;
                                                        }
                                                        let _e1356 = phi_1964_;
                                                        let _e1360 = (_e1341 + _e265);
                                                        let _e1361 = (_e1360 < _e96);
                                                        if _e1361 {
                                                            if _e1361 {
                                                            } else {
                                                                phi_4425_ = true;
                                                                break;
                                                            }
                                                            let _e1363 = global_5.member[_e1360];
                                                            phi_1982_ = _e1363;
                                                        } else {
                                                            phi_1982_ = 0u;
                                                        }
                                                        let _e1365 = phi_1982_;
                                                        phi_1988_ = array<array<f32, 3>, 3>(array<f32, 3>((f32(bitcast<i32>(_e1289)) * _e144), (f32(bitcast<i32>(_e1298)) * _e144), (f32(bitcast<i32>(_e1307)) * _e144)), array<f32, 3>((f32(bitcast<i32>(_e1318)) * _e144), (f32(bitcast<i32>(_e1327)) * _e144), (f32(bitcast<i32>(_e1336)) * _e144)), array<f32, 3>((f32(bitcast<i32>(_e1347)) * _e144), (f32(bitcast<i32>(_e1356)) * _e144), (f32(bitcast<i32>(_e1365)) * _e144)));
                                                        break;
                                                    }
                                                    default: {
                                                        phi_1988_ = array<array<f32, 3>, 3>();
                                                        break;
                                                    }
                                                }
                                                let _e1657 = phi_1988_;
                                                let _e1666 = (_e1657[0][2] - _e465);
                                                let _e1669 = (((_e1657[0][0] - _e328) * _e504) - (_e1666 * _e368));
                                                let _e1672 = (((_e1657[0][1] - _e397) * _e504) - (_e1666 * _e436));
                                                let _e1679 = (_e1657[1][2] - _e465);
                                                let _e1682 = (((_e1657[1][0] - _e328) * _e504) - (_e1679 * _e368));
                                                let _e1685 = (((_e1657[1][1] - _e397) * _e504) - (_e1679 * _e436));
                                                let _e1692 = (_e1657[2][2] - _e465);
                                                let _e1695 = (((_e1657[2][0] - _e328) * _e504) - (_e1692 * _e368));
                                                let _e1698 = (((_e1657[2][1] - _e397) * _e504) - (_e1692 * _e436));
                                                let _e1699 = (_e1695 * _e1685);
                                                let _e1700 = (_e1698 * _e1682);
                                                let _e1701 = (_e1669 * _e1698);
                                                let _e1702 = (_e1672 * _e1695);
                                                let _e1703 = (_e1682 * _e1672);
                                                let _e1704 = (_e1685 * _e1669);
                                                let _e1709 = (((_e1699 >= _e1700) && (_e1701 >= _e1702)) && (_e1703 >= _e1704));
                                                if (_e1709 || (((_e1699 <= _e1700) && (_e1701 <= _e1702)) && (_e1703 <= _e1704))) {
                                                    let _e1716 = select(-1f, 1f, _e1709);
                                                    let _e1718 = ((_e1699 - _e1700) * _e1716);
                                                    let _e1720 = select(0f, _e1718, (_e1718 > 0f));
                                                    let _e1722 = ((_e1701 - _e1702) * _e1716);
                                                    let _e1724 = select(0f, _e1722, (_e1722 > 0f));
                                                    let _e1726 = ((_e1703 - _e1704) * _e1716);
                                                    let _e1728 = select(0f, _e1726, (_e1726 > 0f));
                                                    let _e1730 = ((_e1720 + _e1724) + _e1728);
                                                    if (_e1730 < 0.000000000000000000000000000000000000011754944f) {
                                                        phi_2872_ = type_24();
                                                        phi_2873_ = true;
                                                        phi_2874_ = false;
                                                    } else {
                                                        let _e1733 = select(_e1682, _e1669, (_e1669 < _e1682));
                                                        if (select(_e1695, _e1733, (_e1733 < _e1695)) > 0f) {
                                                            phi_2140_ = true;
                                                        } else {
                                                            let _e1738 = select(_e1682, _e1669, (_e1669 > _e1682));
                                                            phi_2140_ = (select(_e1695, _e1738, (_e1738 > _e1695)) < 0f);
                                                        }
                                                        let _e1743 = phi_2140_;
                                                        if _e1743 {
                                                            phi_2869_ = type_24();
                                                            phi_2870_ = true;
                                                            phi_2871_ = false;
                                                        } else {
                                                            let _e1745 = select(_e1685, _e1672, (_e1672 < _e1685));
                                                            if (select(_e1698, _e1745, (_e1745 < _e1698)) > 0f) {
                                                                phi_2169_ = true;
                                                            } else {
                                                                let _e1750 = select(_e1685, _e1672, (_e1672 > _e1685));
                                                                phi_2169_ = (select(_e1698, _e1750, (_e1750 > _e1698)) < 0f);
                                                            }
                                                            let _e1755 = phi_2169_;
                                                            if _e1755 {
                                                                phi_2867_ = type_24();
                                                                phi_2868_ = false;
                                                            } else {
                                                                let _e1757 = select(_e1657[1][0], _e1657[0][0], (_e1657[0][0] < _e1657[1][0]));
                                                                let _e1761 = select(_e1657[1][0], _e1657[0][0], (_e1657[0][0] > _e1657[1][0]));
                                                                let _e1765 = select(_e1657[1][1], _e1657[0][1], (_e1657[0][1] < _e1657[1][1]));
                                                                let _e1769 = select(_e1657[1][1], _e1657[0][1], (_e1657[0][1] > _e1657[1][1]));
                                                                let _e1773 = select(_e1657[1][2], _e1657[0][2], (_e1657[0][2] < _e1657[1][2]));
                                                                let _e1777 = select(_e1657[1][2], _e1657[0][2], (_e1657[0][2] > _e1657[1][2]));
                                                                let _e1782 = ((select(_e1657[2][0], _e1757, (_e1757 < _e1657[2][0])) - _e366) * _e371);
                                                                let _e1783 = ((select(_e1657[2][0], _e1761, (_e1761 > _e1657[2][0])) - _e367) * _e371);
                                                                let _e1786 = ((select(_e1657[2][1], _e1765, (_e1765 < _e1657[2][1])) - _e434) * _e439);
                                                                let _e1787 = ((select(_e1657[2][1], _e1769, (_e1769 > _e1657[2][1])) - _e435) * _e439);
                                                                let _e1790 = ((select(_e1657[2][2], _e1773, (_e1773 < _e1657[2][2])) - _e502) * _e507);
                                                                let _e1791 = ((select(_e1657[2][2], _e1777, (_e1777 > _e1657[2][2])) - _e503) * _e507);
                                                                let _e1793 = select(_e1791, _e1790, (_e1790 < _e1791));
                                                                let _e1795 = select(_e1791, _e1790, (_e1790 > _e1791));
                                                                let _e1797 = select(_e1783, _e1782, (_e1782 < _e1783));
                                                                let _e1799 = select(_e1787, _e1786, (_e1786 < _e1787));
                                                                let _e1801 = select(_e1799, _e1797, (_e1797 > _e1799));
                                                                let _e1803 = select(_e1793, _e1801, (_e1801 > _e1793));
                                                                let _e1805 = select(_e1783, _e1782, (_e1782 > _e1783));
                                                                let _e1807 = select(_e1787, _e1786, (_e1786 > _e1787));
                                                                let _e1809 = select(_e1807, _e1805, (_e1805 < _e1807));
                                                                let _e1811 = select(_e1795, _e1809, (_e1809 < _e1795));
                                                                let _e1812 = -(_e1793);
                                                                let _e1818 = select(_e619, _e1803, (_e1803 > _e619));
                                                                if (_e1818 > (_e1811 + (select(_e1812, _e1795, (_e1795 > _e1812)) * 0.0000019073523f))) {
                                                                    phi_2862_ = type_24();
                                                                    phi_2863_ = true;
                                                                } else {
                                                                    let _e1820 = (_e1818 > _e1204.member.member_1);
                                                                    if _e1820 {
                                                                        phi_2861_ = type_24();
                                                                    } else {
                                                                        let _e1821 = vec3<f32>(_e1657[0][0], _e1657[0][1], _e1657[0][2]);
                                                                        let _e1822 = vec3<f32>(_e1657[1][0], _e1657[1][1], _e1657[1][2]);
                                                                        let _e1823 = vec3<f32>(_e1657[2][0], _e1657[2][1], _e1657[2][2]);
                                                                        let _e1824 = (_e1657[1][0] - _e1657[0][0]);
                                                                        let _e1825 = (_e1657[1][1] - _e1657[0][1]);
                                                                        let _e1826 = (_e1657[1][2] - _e1657[0][2]);
                                                                        let _e1827 = vec3<f32>(_e1824, _e1825, _e1826);
                                                                        let _e1828 = (_e1657[2][0] - _e1657[1][0]);
                                                                        let _e1829 = (_e1657[2][1] - _e1657[1][1]);
                                                                        let _e1830 = (_e1657[2][2] - _e1657[1][2]);
                                                                        let _e1831 = vec3<f32>(_e1828, _e1829, _e1830);
                                                                        let _e1832 = (_e1657[0][0] - _e1657[2][0]);
                                                                        let _e1833 = (_e1657[0][1] - _e1657[2][1]);
                                                                        let _e1834 = (_e1657[0][2] - _e1657[2][2]);
                                                                        let _e1835 = vec3<f32>(_e1832, _e1833, _e1834);
                                                                        let _e1838 = bitcast<f32>((bitcast<u32>(_e1824) & 2147483647u));
                                                                        let _e1841 = bitcast<f32>((bitcast<u32>(_e1825) & 2147483647u));
                                                                        let _e1843 = select(_e1841, _e1838, (_e1838 > _e1841));
                                                                        let _e1846 = bitcast<f32>((bitcast<u32>(_e1826) & 2147483647u));
                                                                        let _e1848 = select(_e1846, _e1843, (_e1843 > _e1846));
                                                                        let _e1851 = bitcast<f32>((bitcast<u32>(_e1828) & 2147483647u));
                                                                        let _e1854 = bitcast<f32>((bitcast<u32>(_e1829) & 2147483647u));
                                                                        let _e1856 = select(_e1854, _e1851, (_e1851 > _e1854));
                                                                        let _e1859 = bitcast<f32>((bitcast<u32>(_e1830) & 2147483647u));
                                                                        let _e1861 = select(_e1859, _e1856, (_e1856 > _e1859));
                                                                        let _e1864 = bitcast<f32>((bitcast<u32>(_e1832) & 2147483647u));
                                                                        let _e1867 = bitcast<f32>((bitcast<u32>(_e1833) & 2147483647u));
                                                                        let _e1869 = select(_e1867, _e1864, (_e1864 > _e1867));
                                                                        let _e1872 = bitcast<f32>((bitcast<u32>(_e1834) & 2147483647u));
                                                                        let _e1874 = select(_e1872, _e1869, (_e1869 > _e1872));
                                                                        let _e1876 = select(_e1861, _e1848, (_e1848 > _e1861));
                                                                        let _e1878 = select(_e1874, _e1876, (_e1876 > _e1874));
                                                                        if (_e1848 == _e1878) {
                                                                            phi_2588_ = _e1685;
                                                                            phi_2589_ = _e1682;
                                                                            phi_2590_ = _e1672;
                                                                            phi_2591_ = _e1669;
                                                                            phi_2592_ = _e1821;
                                                                            phi_2593_ = _e1835;
                                                                            phi_2594_ = _e1831;
                                                                            phi_2595_ = _e1827;
                                                                        } else {
                                                                            let _e1880 = (_e1861 == _e1878);
                                                                            let _e1885 = vec3(_e1880);
                                                                            phi_2588_ = select(_e1672, _e1698, _e1880);
                                                                            phi_2589_ = select(_e1669, _e1695, _e1880);
                                                                            phi_2590_ = select(_e1698, _e1685, _e1880);
                                                                            phi_2591_ = select(_e1695, _e1682, _e1880);
                                                                            phi_2592_ = select(_e1823, _e1822, _e1885);
                                                                            phi_2593_ = select(_e1831, _e1827, _e1885);
                                                                            phi_2594_ = select(_e1827, _e1835, _e1885);
                                                                            phi_2595_ = select(_e1835, _e1831, _e1885);
                                                                        }
                                                                        let _e1891 = phi_2588_;
                                                                        let _e1893 = phi_2589_;
                                                                        let _e1895 = phi_2590_;
                                                                        let _e1897 = phi_2591_;
                                                                        let _e1899 = phi_2592_;
                                                                        let _e1901 = phi_2593_;
                                                                        let _e1903 = phi_2594_;
                                                                        let _e1905 = phi_2595_;
                                                                        let _e1912 = ((_e1903.y * _e1901.z) - (_e1901.y * _e1903.z));
                                                                        let _e1917 = ((_e1903.z * _e1901.x) - (_e1901.z * _e1903.x));
                                                                        let _e1920 = ((_e1903.x * _e1901.y) - (_e1901.x * _e1903.y));
                                                                        if (_e1720 >= _e1724) {
                                                                            phi_2632_ = select(true, false, (_e1720 >= _e1728));
                                                                        } else {
                                                                            phi_2632_ = true;
                                                                        }
                                                                        let _e1925 = phi_2632_;
                                                                        if _e1925 {
                                                                            phi_2641_ = select(_e1823, _e1822, vec3((_e1724 >= _e1728)));
                                                                        } else {
                                                                            phi_2641_ = _e1821;
                                                                        }
                                                                        let _e1930 = phi_2641_;
                                                                        let _e1941 = (((_e1912 * (_e1930.x - _e328)) + (_e1917 * (_e1930.y - _e397))) + (_e1920 * (_e1930.z - _e465)));
                                                                        let _e1946 = (((_e1912 * _e368) + (_e1917 * _e436)) + (_e1920 * _e504));
                                                                        let _e1947 = (_e1893 - _e1897);
                                                                        let _e1948 = (_e1891 - _e1895);
                                                                        let _e1956 = (-(((_e1897 * _e1947) + (_e1895 * _e1948))) / ((_e1947 * _e1947) + (_e1948 * _e1948)));
                                                                        let _e1958 = select(1f, _e1956, (_e1956 < 1f));
                                                                        let _e1960 = select(0f, _e1958, (_e1958 > 0f));
                                                                        let _e1973 = ((_e1899.x + (_e1905.x * _e1960)) - _e328);
                                                                        let _e1974 = ((_e1899.y + (_e1905.y * _e1960)) - _e397);
                                                                        let _e1975 = ((_e1899.z + (_e1905.z * _e1960)) - _e465);
                                                                        let _e1976 = (_e1975 / _e504);
                                                                        let _e1988 = bitcast<f32>((bitcast<u32>(_e1973) & 2147483647u));
                                                                        let _e1991 = bitcast<f32>((bitcast<u32>(_e1974) & 2147483647u));
                                                                        let _e1993 = select(_e1991, _e1988, (_e1988 > _e1991));
                                                                        let _e1996 = bitcast<f32>((bitcast<u32>(_e1975) & 2147483647u));
                                                                        let _e1998 = select(_e1996, _e1993, (_e1993 > _e1996));
                                                                        let _e2004 = bitcast<f32>((bitcast<u32>(_e1912) & 2147483647u));
                                                                        let _e2007 = bitcast<f32>((bitcast<u32>(_e1917) & 2147483647u));
                                                                        let _e2009 = select(_e2007, _e2004, (_e2004 > _e2007));
                                                                        let _e2012 = bitcast<f32>((bitcast<u32>(_e1920) & 2147483647u));
                                                                        if (bitcast<f32>((bitcast<u32>(((((_e1912 * _e1973) + (_e1917 * _e1974)) + (_e1920 * _e1975)) - _e1941)) & 2147483647u)) <= ((0.0000009536743f * select(_e1878, _e1998, (_e1998 > _e1878))) * select(_e2012, _e2009, (_e2009 > _e2012)))) {
                                                                            let _e2022 = bitcast<f32>((bitcast<u32>(_e1903.x) & 2147483647u));
                                                                            let _e2025 = bitcast<f32>((bitcast<u32>(_e1903.y) & 2147483647u));
                                                                            let _e2027 = select(_e2025, _e2022, (_e2022 > _e2025));
                                                                            let _e2030 = bitcast<f32>((bitcast<u32>(_e1903.z) & 2147483647u));
                                                                            let _e2036 = bitcast<f32>((bitcast<u32>(_e1901.x) & 2147483647u));
                                                                            let _e2039 = bitcast<f32>((bitcast<u32>(_e1901.y) & 2147483647u));
                                                                            let _e2041 = select(_e2039, _e2036, (_e2036 > _e2039));
                                                                            let _e2044 = bitcast<f32>((bitcast<u32>(_e1901.z) & 2147483647u));
                                                                            let _e2048 = (bitcast<f32>((bitcast<u32>(_e1946) & 2147483647u)) > ((0.0000038146973f * select(_e2030, _e2027, (_e2027 > _e2030))) * select(_e2044, _e2041, (_e2041 > _e2044))));
                                                                            if _e2048 {
                                                                                phi_2806_ = (_e1941 / _e1946);
                                                                            } else {
                                                                                phi_2806_ = f32();
                                                                            }
                                                                            let _e2051 = phi_2806_;
                                                                            phi_2808_ = _e2051;
                                                                            phi_2809_ = select(true, false, _e2048);
                                                                        } else {
                                                                            phi_2808_ = f32();
                                                                            phi_2809_ = true;
                                                                        }
                                                                        let _e2054 = phi_2808_;
                                                                        let _e2056 = phi_2809_;
                                                                        if _e2056 {
                                                                            let _e2064 = (((_e1912 * (_e1973 - (_e368 * _e1976))) + (_e1917 * (_e1974 - (_e436 * _e1976)))) / _e1946);
                                                                            if (bitcast<f32>((bitcast<u32>(_e2064) & 2147483647u)) <= _e1878) {
                                                                                phi_2829_ = (_e1976 + _e2064);
                                                                            } else {
                                                                                phi_2829_ = _e1976;
                                                                            }
                                                                            let _e2071 = phi_2829_;
                                                                            phi_2830_ = _e2071;
                                                                        } else {
                                                                            phi_2830_ = _e2054;
                                                                        }
                                                                        let _e2073 = phi_2830_;
                                                                        let _e2075 = select(_e1811, _e2073, (_e2073 < _e1811));
                                                                        let _e2077 = select(_e1803, _e2075, (_e2075 > _e1803));
                                                                        if (_e2077 >= _e619) {
                                                                            let _e2079 = (_e2077 <= _e1204.member.member_1);
                                                                            if _e2079 {
                                                                                let _e2080 = (1f / _e1730);
                                                                                phi_2853_ = type_24(_e2077, (_e1724 * _e2080), (_e1728 * _e2080), _e1270);
                                                                            } else {
                                                                                phi_2853_ = type_24();
                                                                            }
                                                                            let _e2085 = phi_2853_;
                                                                            phi_2855_ = _e2085;
                                                                            phi_2856_ = select(true, false, _e2079);
                                                                        } else {
                                                                            phi_2855_ = type_24();
                                                                            phi_2856_ = true;
                                                                        }
                                                                        let _e2088 = phi_2855_;
                                                                        let _e2090 = phi_2856_;
                                                                        if _e2090 {
                                                                            phi_2860_ = type_24(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                        } else {
                                                                            phi_2860_ = _e2088;
                                                                        }
                                                                        let _e2092 = phi_2860_;
                                                                        phi_2861_ = _e2092;
                                                                    }
                                                                    let _e2094 = phi_2861_;
                                                                    phi_2862_ = _e2094;
                                                                    phi_2863_ = _e1820;
                                                                }
                                                                let _e2096 = phi_2862_;
                                                                let _e2098 = phi_2863_;
                                                                phi_2867_ = _e2096;
                                                                phi_2868_ = _e2098;
                                                            }
                                                            let _e2100 = phi_2867_;
                                                            let _e2102 = phi_2868_;
                                                            phi_2869_ = _e2100;
                                                            phi_2870_ = _e1755;
                                                            phi_2871_ = _e2102;
                                                        }
                                                        let _e2104 = phi_2869_;
                                                        let _e2106 = phi_2870_;
                                                        let _e2108 = phi_2871_;
                                                        phi_2872_ = _e2104;
                                                        phi_2873_ = _e2106;
                                                        phi_2874_ = _e2108;
                                                    }
                                                    let _e2110 = phi_2872_;
                                                    let _e2112 = phi_2873_;
                                                    let _e2114 = phi_2874_;
                                                    phi_2882_ = _e2110;
                                                    phi_2883_ = select(_e2114, true, _e2112);
                                                } else {
                                                    phi_2882_ = type_24();
                                                    phi_2883_ = true;
                                                }
                                                let _e2117 = phi_2882_;
                                                let _e2119 = phi_2883_;
                                                if _e2119 {
                                                    phi_2887_ = type_24(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                } else {
                                                    phi_2887_ = _e2117;
                                                }
                                                let _e2121 = phi_2887_;
                                                if (_e2121.member_3 != 4294967295u) {
                                                    if (_e1270 != 4294967295u) {
                                                        if (_e2121.member < _e1204.member.member.member) {
                                                            phi_2913_ = true;
                                                        } else {
                                                            if (_e2121.member == _e1204.member.member.member) {
                                                                phi_2912_ = (_e2121.member_3 < _e1204.member.member.member_3);
                                                            } else {
                                                                phi_2912_ = false;
                                                            }
                                                            let _e2136 = phi_2912_;
                                                            phi_2913_ = _e2136;
                                                        }
                                                        let _e2138 = phi_2913_;
                                                        if _e2138 {
                                                            phi_2920_ = type_39(type_33(_e2121, _e2121.member), _e1231.member_1, _e1231.member_2);
                                                        } else {
                                                            phi_2920_ = _e1231;
                                                        }
                                                        let _e2145 = phi_2920_;
                                                        phi_2921_ = _e2145;
                                                    } else {
                                                        phi_2921_ = _e1231;
                                                    }
                                                    let _e2147 = phi_2921_;
                                                    phi_2922_ = _e2147;
                                                } else {
                                                    phi_2922_ = _e1231;
                                                }
                                                let _e2149 = phi_2922_;
                                                phi_1222_ = _e2149;
                                            } else {
                                                phi_1222_ = type_39();
                                            }
                                            let _e2151 = phi_1222_;
                                            continue;
                                            continuing {
                                                phi_1221_ = _e2151;
                                                phi_1224_ = _e1219;
                                                phi_4425_ = _e662;
                                                break if !(_e1225);
                                            }
                                        }
                                        let _e2154 = phi_4425_;
                                        phi_4632_ = _e2154;
                                        if _e2154 {
                                            break;
                                        }
                                        phi_4636_ = _e2154;
                                        let _e2366 = local_12;
                                        phi_4197_ = _e2366;
                                        phi_4198_ = false;
                                        phi_4199_ = _e706;
                                        phi_4200_ = _e708;
                                    } else {
                                        if (_e708.member_1 >= _e93) {
                                            phi_3728_ = type_51(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), type_50(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u), type_50(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u));
                                        } else {
                                            if (_e708.member_1 < _e93) {
                                            } else {
                                                phi_4632_ = true;
                                                break;
                                            }
                                            let _e720 = (_e264 * 2u);
                                            let _e722 = ((1u + _e720) % 7u);
                                            if (_e722 < 7u) {
                                            } else {
                                                phi_4632_ = true;
                                                break;
                                            }
                                            let _e727 = global_4.member[_e708.member_1][_e722];
                                            let _e729 = ((_e720 + 2u) % 7u);
                                            if (_e729 < 7u) {
                                            } else {
                                                phi_4632_ = true;
                                                break;
                                            }
                                            let _e734 = global_4.member[_e708.member_1][_e729];
                                            let _e735 = (_e263 * 2u);
                                            let _e737 = ((1u + _e735) % 7u);
                                            if (_e737 < 7u) {
                                            } else {
                                                phi_4632_ = true;
                                                break;
                                            }
                                            let _e742 = global_4.member[_e708.member_1][_e737];
                                            let _e744 = ((_e735 + 2u) % 7u);
                                            if (_e744 < 7u) {
                                            } else {
                                                phi_4632_ = true;
                                                break;
                                            }
                                            let _e749 = global_4.member[_e708.member_1][_e744];
                                            let _e750 = (_e265 * 2u);
                                            let _e752 = ((1u + _e750) % 7u);
                                            if (_e752 < 7u) {
                                            } else {
                                                phi_4632_ = true;
                                                break;
                                            }
                                            let _e757 = global_4.member[_e708.member_1][_e752];
                                            let _e759 = ((_e750 + 2u) % 7u);
                                            if (_e759 < 7u) {
                                            } else {
                                                phi_4632_ = true;
                                                break;
                                            }
                                            let _e764 = global_4.member[_e708.member_1][_e759];
                                            let _e787 = (bitcast<f32>((bitcast<u32>((_e708.member.member_1.x - _e708.member.member.x)) & 2139095040u)) * 0.0000009536743f);
                                            let _e788 = (bitcast<f32>((bitcast<u32>((_e708.member.member_1.y - _e708.member.member.y)) & 2139095040u)) * 0.0000009536743f);
                                            let _e789 = (bitcast<f32>((bitcast<u32>((_e708.member.member_1.z - _e708.member.member.z)) & 2139095040u)) * 0.0000009536743f);
                                            let _e791 = select(_e144, _e787, (_e787 > _e144));
                                            let _e793 = select(_e144, _e788, (_e788 > _e144));
                                            let _e795 = select(_e144, _e789, (_e789 > _e144));
                                            let _e826 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e727 & 2097151u))) - 8388608f) * _e791));
                                            let _e831 = (bitcast<i32>((_e727 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e834 = bitcast<f32>((_e826 & bitcast<u32>(_e831)));
                                            let _e835 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e742 & 2097151u))) - 8388608f) * _e793));
                                            let _e840 = (bitcast<i32>((_e742 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e843 = bitcast<f32>((_e835 & bitcast<u32>(_e840)));
                                            let _e844 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e757 & 2097151u))) - 8388608f) * _e795));
                                            let _e849 = (bitcast<i32>((_e757 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e852 = bitcast<f32>((_e844 & bitcast<u32>(_e849)));
                                            let _e856 = bitcast<f32>((_e826 & bitcast<u32>(~(_e831))));
                                            let _e860 = bitcast<f32>((_e835 & bitcast<u32>(~(_e840))));
                                            let _e864 = bitcast<f32>((_e844 & bitcast<u32>(~(_e849))));
                                            let _e865 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e734 & 2097151u))) - 8388608f) * _e791));
                                            let _e870 = (bitcast<i32>((_e734 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e873 = bitcast<f32>((_e865 & bitcast<u32>(_e870)));
                                            let _e874 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e749 & 2097151u))) - 8388608f) * _e793));
                                            let _e879 = (bitcast<i32>((_e749 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e882 = bitcast<f32>((_e874 & bitcast<u32>(_e879)));
                                            let _e883 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e764 & 2097151u))) - 8388608f) * _e795));
                                            let _e888 = (bitcast<i32>((_e764 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e891 = bitcast<f32>((_e883 & bitcast<u32>(_e888)));
                                            let _e895 = bitcast<f32>((_e865 & bitcast<u32>(~(_e870))));
                                            let _e899 = bitcast<f32>((_e874 & bitcast<u32>(~(_e879))));
                                            let _e903 = bitcast<f32>((_e883 & bitcast<u32>(~(_e888))));
                                            let _e904 = (_e708.member.member.x + _e834);
                                            let _e905 = (_e708.member.member.y + _e843);
                                            let _e906 = (_e708.member.member.z + _e852);
                                            let _e909 = (_e708.member.member_1.x - _e873);
                                            let _e910 = (_e708.member.member_1.y - _e882);
                                            let _e911 = (_e708.member.member_1.z - _e891);
                                            let _e930 = (_e909 - _e904);
                                            let _e931 = (_e910 - _e905);
                                            let _e932 = (_e911 - _e906);
                                            let _e934 = select(_e931, _e930, (_e930 > _e931));
                                            let _e936 = select(_e932, _e934, (_e934 > _e932));
                                            if (_e936 < (1024f * _e144)) {
                                                phi_3429_ = 0u;
                                            } else {
                                                phi_3429_ = select(2u, 1u, (_e936 < (2097152f * _e144)));
                                            }
                                            let _e943 = phi_3429_;
                                            switch bitcast<i32>(_e943) {
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
                                            let _e946 = phi_3435_;
                                            let _e952 = global_4.member[_e708.member_1][0u];
                                            let _e956 = global_4.member[_e708.member_1][2u];
                                            let _e960 = global_4.member[_e708.member_1][4u];
                                            let _e964 = global_4.member[_e708.member_1][6u];
                                            let _e976 = (((_e956 >> bitcast<u32>(22i)) | ((_e960 >> bitcast<u32>(22i)) << bitcast<u32>(10i))) | ((_e964 >> bitcast<u32>(22i)) << bitcast<u32>(20i)));
                                            let _e977 = (_e952 & 268435455u);
                                            let _e978 = (_e976 & 268435455u);
                                            let _e981 = ((_e952 >> bitcast<u32>(28u)) & 7u);
                                            let _e989 = ((_e952 >> bitcast<u32>(31i)) | (((_e976 >> bitcast<u32>(28u)) & 3u) << bitcast<u32>(1i)));
                                            let _e990 = (_e981 != 0u);
                                            if (_e981 == 0u) {
                                                phi_3690_ = _e977;
                                            } else {
                                                if (_e981 == 7u) {
                                                    phi_3689_ = 2147483648u;
                                                } else {
                                                    phi_3689_ = ((2147483648u | (_e981 << bitcast<u32>(28u))) | (_e978 & 268435455u));
                                                }
                                                let _e999 = phi_3689_;
                                                phi_3690_ = _e999;
                                            }
                                            let _e1001 = phi_3690_;
                                            if _e990 {
                                                let _e1002 = (_e981 != 7u);
                                                if _e1002 {
                                                    phi_3700_ = (_e978 + (_e981 * ((3u * _e946) + 1u)));
                                                } else {
                                                    phi_3700_ = u32();
                                                }
                                                let _e1006 = phi_3700_;
                                                phi_3702_ = _e1006;
                                                phi_3703_ = select(true, false, _e1002);
                                            } else {
                                                phi_3702_ = u32();
                                                phi_3703_ = true;
                                            }
                                            let _e1009 = phi_3702_;
                                            let _e1011 = phi_3703_;
                                            if (_e989 == 0u) {
                                                phi_3724_ = (_e977 + select(0u, 1u, !(_e990)));
                                            } else {
                                                if (_e989 == 7u) {
                                                    phi_3723_ = 2147483648u;
                                                } else {
                                                    phi_3723_ = ((2147483648u | (_e989 << bitcast<u32>(28u))) | (select(_e1009, _e978, _e1011) & 268435455u));
                                                }
                                                let _e1024 = phi_3723_;
                                                phi_3724_ = _e1024;
                                            }
                                            let _e1026 = phi_3724_;
                                            phi_3728_ = type_51(array<vec4<f32>, 3>(vec4<f32>(_e904, (_e708.member.member.x + _e856), _e909, (_e708.member.member_1.x - _e895)), vec4<f32>(_e905, (_e708.member.member.y + _e860), _e910, (_e708.member.member_1.y - _e899)), vec4<f32>(_e906, (_e708.member.member.z + _e864), _e911, (_e708.member.member_1.z - _e903))), type_50(type_28((_e708.member.member + vec4<f32>(_e834, _e843, _e852, 0f)), (_e708.member.member_1 - vec4<f32>(_e873, _e882, _e891, 0f))), _e1001), type_50(type_28((_e708.member.member + vec4<f32>(_e856, _e860, _e864, 0f)), (_e708.member.member_1 - vec4<f32>(_e895, _e899, _e903, 0f))), _e1026));
                                        }
                                        let _e1031 = phi_3728_;
                                        let _e1050 = ((_e1031.member[0].x - _e366) * _e371);
                                        let _e1051 = ((_e1031.member[0].y - _e366) * _e371);
                                        let _e1052 = ((_e1031.member[0].z - _e367) * _e371);
                                        let _e1053 = ((_e1031.member[0].w - _e367) * _e371);
                                        let _e1063 = ((_e1031.member[1].x - _e434) * _e439);
                                        let _e1064 = ((_e1031.member[1].y - _e434) * _e439);
                                        let _e1065 = ((_e1031.member[1].z - _e435) * _e439);
                                        let _e1066 = ((_e1031.member[1].w - _e435) * _e439);
                                        let _e1076 = ((_e1031.member[2].x - _e502) * _e507);
                                        let _e1077 = ((_e1031.member[2].y - _e502) * _e507);
                                        let _e1078 = ((_e1031.member[2].z - _e503) * _e507);
                                        let _e1079 = ((_e1031.member[2].w - _e503) * _e507);
                                        let _e1081 = select(_e1078, _e1076, (_e1076 < _e1078));
                                        let _e1083 = select(_e1079, _e1077, (_e1077 < _e1079));
                                        let _e1085 = select(_e1078, _e1076, (_e1076 > _e1078));
                                        let _e1087 = select(_e1079, _e1077, (_e1077 > _e1079));
                                        let _e1089 = select(_e1052, _e1050, (_e1050 < _e1052));
                                        let _e1091 = select(_e1053, _e1051, (_e1051 < _e1053));
                                        let _e1093 = select(_e1065, _e1063, (_e1063 < _e1065));
                                        let _e1095 = select(_e1066, _e1064, (_e1064 < _e1066));
                                        let _e1097 = select(_e1093, _e1089, (_e1089 > _e1093));
                                        let _e1099 = select(_e1095, _e1091, (_e1091 > _e1095));
                                        let _e1101 = select(_e1081, _e1097, (_e1097 > _e1081));
                                        let _e1103 = select(_e1083, _e1099, (_e1099 > _e1083));
                                        let _e1105 = select(_e1052, _e1050, (_e1050 > _e1052));
                                        let _e1107 = select(_e1053, _e1051, (_e1051 > _e1053));
                                        let _e1109 = select(_e1065, _e1063, (_e1063 > _e1065));
                                        let _e1111 = select(_e1066, _e1064, (_e1064 > _e1066));
                                        let _e1113 = select(_e1109, _e1105, (_e1105 < _e1109));
                                        let _e1115 = select(_e1111, _e1107, (_e1107 < _e1111));
                                        let _e1120 = -(_e1081);
                                        let _e1121 = -(_e1083);
                                        let _e1128 = (select(_e1085, _e1113, (_e1113 < _e1085)) + (select(_e1120, _e1085, (_e1085 > _e1120)) * 0.0000019073523f));
                                        let _e1129 = (select(_e1087, _e1115, (_e1115 < _e1087)) + (select(_e1121, _e1087, (_e1087 > _e1121)) * 0.0000019073523f));
                                        let _e1131 = select(_e619, _e1101, (_e1101 > _e619));
                                        let _e1133 = select(_e619, _e1103, (_e1103 > _e619));
                                        let _e1138 = (_e1131 <= select(_e664.member.member_1, _e1128, (_e1128 < _e664.member.member_1)));
                                        let _e1139 = (_e1133 <= select(_e664.member.member_1, _e1129, (_e1129 < _e664.member.member_1)));
                                        let _e1140 = (_e1131 <= _e1133);
                                        if _e1138 {
                                            if _e1139 {
                                                if _e1140 {
                                                    phi_4093_ = _e1031.member_2;
                                                } else {
                                                    phi_4093_ = _e1031.member_1;
                                                }
                                                let _e1144 = phi_4093_;
                                                let _e1166 = (_e706 % 128u);
                                                let _e1167 = (_e1166 < 128u);
                                                if _e1167 {
                                                } else {
                                                    phi_4632_ = true;
                                                    break;
                                                }
                                                local_8[_e1166] = _e1144.member_1;
                                                if _e1167 {
                                                } else {
                                                    phi_4632_ = true;
                                                    break;
                                                }
                                                local_7[_e1166] = _e1144.member.member.x;
                                                if _e1167 {
                                                } else {
                                                    phi_4632_ = true;
                                                    break;
                                                }
                                                local_6[_e1166] = _e1144.member.member.y;
                                                if _e1167 {
                                                } else {
                                                    phi_4632_ = true;
                                                    break;
                                                }
                                                local_5[_e1166] = _e1144.member.member.z;
                                                if _e1167 {
                                                } else {
                                                    phi_4632_ = true;
                                                    break;
                                                }
                                                local_4[_e1166] = _e1144.member.member_1.x;
                                                if _e1167 {
                                                } else {
                                                    phi_4632_ = true;
                                                    break;
                                                }
                                                local_3[_e1166] = _e1144.member.member_1.y;
                                                if _e1167 {
                                                } else {
                                                    phi_4632_ = true;
                                                    break;
                                                }
                                                local_2[_e1166] = _e1144.member.member_1.z;
                                                if _e1167 {
                                                } else {
                                                    phi_4632_ = true;
                                                    break;
                                                }
                                                local_9[_e1166] = select(_e1133, _e1131, !(_e1140));
                                                if _e1140 {
                                                    phi_4170_ = _e1031.member_1;
                                                } else {
                                                    phi_4170_ = _e1031.member_2;
                                                }
                                                let _e1180 = phi_4170_;
                                                phi_4171_ = (_e706 + 1u);
                                                phi_4172_ = _e1180;
                                            } else {
                                                phi_4171_ = u32();
                                                phi_4172_ = type_50();
                                            }
                                            let _e1182 = phi_4171_;
                                            let _e1184 = phi_4172_;
                                            phi_4174_ = _e1182;
                                            phi_4175_ = _e1184;
                                            phi_4176_ = select(true, false, _e1139);
                                        } else {
                                            phi_4174_ = u32();
                                            phi_4175_ = type_50();
                                            phi_4176_ = true;
                                        }
                                        let _e1187 = phi_4174_;
                                        let _e1189 = phi_4175_;
                                        let _e1191 = phi_4176_;
                                        if _e1191 {
                                            if _e1138 {
                                                phi_4185_ = _e1031.member_1;
                                            } else {
                                                phi_4185_ = _e1031.member_2;
                                            }
                                            let _e1195 = phi_4185_;
                                            phi_4190_ = select(_e1139, true, _e1138);
                                            phi_4192_ = _e1195;
                                        } else {
                                            phi_4190_ = _e704;
                                            phi_4192_ = _e1189;
                                        }
                                        let _e1198 = phi_4190_;
                                        let _e1200 = phi_4192_;
                                        phi_4636_ = _e662;
                                        phi_4197_ = type_39(_e664.member, (_e664.member_1 + 1u), _e664.member_2);
                                        phi_4198_ = _e1198;
                                        phi_4199_ = select(_e1187, _e706, _e1191);
                                        phi_4200_ = _e1200;
                                    }
                                    let _e2156 = phi_4636_;
                                    let _e2158 = phi_4197_;
                                    let _e2160 = phi_4198_;
                                    let _e2162 = phi_4199_;
                                    let _e2164 = phi_4200_;
                                    phi_4635_ = _e2156;
                                    phi_4201_ = _e2158;
                                    phi_4202_ = _e2160;
                                    phi_4203_ = (_e668 - 1u);
                                    phi_4204_ = _e2162;
                                    phi_4205_ = _e2164;
                                } else {
                                    phi_4635_ = _e662;
                                    phi_4201_ = _e664;
                                    phi_4202_ = _e704;
                                    phi_4203_ = _e668;
                                    phi_4204_ = _e706;
                                    phi_4205_ = _e708;
                                }
                                let _e2166 = phi_4635_;
                                let _e2168 = phi_4201_;
                                let _e2170 = phi_4202_;
                                let _e2172 = phi_4203_;
                                let _e2174 = phi_4204_;
                                let _e2176 = phi_4205_;
                                phi_4634_ = _e2166;
                                phi_4206_ = _e2168;
                                phi_4207_ = _e2170;
                                phi_4208_ = _e2172;
                                phi_4209_ = _e2174;
                                phi_4210_ = _e2176;
                            } else {
                                phi_4634_ = _e662;
                                phi_4206_ = type_39();
                                phi_4207_ = bool();
                                phi_4208_ = u32();
                                phi_4209_ = u32();
                                phi_4210_ = type_50();
                            }
                            let _e2178 = phi_4634_;
                            let _e2180 = phi_4206_;
                            let _e2182 = phi_4207_;
                            let _e2184 = phi_4208_;
                            let _e2186 = phi_4209_;
                            let _e2188 = phi_4210_;
                            phi_4633_ = _e2178;
                            phi_1095_ = _e2180;
                            phi_1098_ = _e2182;
                            phi_1100_ = _e2184;
                            phi_1102_ = _e2186;
                            phi_1104_ = _e2188;
                            phi_4211_ = _e676;
                        } else {
                            phi_4633_ = _e662;
                            phi_1095_ = type_39();
                            phi_1098_ = bool();
                            phi_1100_ = u32();
                            phi_1102_ = u32();
                            phi_1104_ = type_50();
                            phi_4211_ = false;
                        }
                        let _e2190 = phi_4633_;
                        let _e2192 = phi_1095_;
                        let _e2194 = phi_1098_;
                        let _e2196 = phi_1100_;
                        let _e2198 = phi_1102_;
                        let _e2200 = phi_1104_;
                        let _e2202 = phi_4211_;
                        continue;
                        continuing {
                            phi_4431_ = _e2190;
                            phi_1094_ = _e2192;
                            phi_1097_ = _e2194;
                            phi_1099_ = _e2196;
                            phi_1101_ = _e2198;
                            phi_1103_ = _e2200;
                            phi_4632_ = _e2190;
                            break if !(_e2202);
                        }
                    }
                    let _e2205 = phi_4632_;
                    if _e2205 {
                        break;
                    }
                    let _e2207 = local_10;
                    let _e2210 = local_11;
                    if _e152 {
                    } else {
                        break;
                    }
                    global_6.member[_e150][0u] = _e2207.member_1;
                    global_6.member[_e150][1u] = _e2210.member_2;
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn trace_counted_q21_lattice(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
