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
    var phi_4437_: bool;
    var phi_1094_: type_39;
    var phi_1097_: u32;
    var phi_1099_: bool;
    var phi_1101_: u32;
    var phi_1103_: type_50;
    var phi_1114_: bool;
    var phi_1200_: bool;
    var phi_1201_: u32;
    var phi_1202_: type_50;
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
    var phi_4431_: bool;
    var phi_4729_: bool;
    var phi_2923_: type_39;
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
    var phi_4192_: type_39;
    var phi_4193_: bool;
    var phi_4194_: u32;
    var phi_4195_: type_50;
    var phi_4203_: type_39;
    var phi_4206_: type_50;
    var phi_4641_: bool;
    var phi_4207_: type_39;
    var phi_4208_: u32;
    var phi_4209_: bool;
    var phi_4210_: u32;
    var phi_4211_: type_50;
    var phi_4640_: bool;
    var phi_4212_: type_39;
    var phi_4213_: u32;
    var phi_4214_: bool;
    var phi_4215_: u32;
    var phi_4216_: type_50;
    var phi_4639_: bool;
    var phi_1095_: type_39;
    var phi_1098_: u32;
    var phi_1100_: bool;
    var phi_1102_: u32;
    var phi_1104_: type_50;
    var phi_4217_: bool;
    var phi_4638_: bool;
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
                    phi_4437_ = false;
                    phi_1094_ = type_39(type_33(type_24(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e617), 0u, 0u);
                    phi_1097_ = ((3u * _e93) + 1u);
                    phi_1099_ = (_e619 <= _e617);
                    phi_1101_ = 0u;
                    phi_1103_ = type_50(type_28(vec4<f32>((f32(_e627) * _e144), (f32(_e633) * _e144), (f32(_e639) * _e144), 0f), vec4<f32>((f32(_e644) * _e144), (f32(_e648) * _e144), (f32(_e652) * _e144), 0f)), select(0u, 2147483648u, (_e93 == 0u)));
                    loop {
                        let _e662 = phi_4437_;
                        let _e664 = phi_1094_;
                        let _e666 = phi_1097_;
                        let _e668 = phi_1099_;
                        let _e670 = phi_1101_;
                        let _e672 = phi_1103_;
                        local_10 = _e664;
                        local_11 = _e664;
                        if _e668 {
                            phi_1114_ = true;
                        } else {
                            phi_1114_ = (_e670 > 0u);
                        }
                        let _e675 = phi_1114_;
                        if _e675 {
                            let _e676 = (_e666 > 0u);
                            if _e676 {
                                if _e668 {
                                    phi_1200_ = _e668;
                                    phi_1201_ = _e670;
                                    phi_1202_ = _e672;
                                } else {
                                    let _e677 = (_e670 - 1u);
                                    let _e678 = (_e677 % 128u);
                                    let _e679 = (_e678 < 128u);
                                    if _e679 {
                                    } else {
                                        phi_4638_ = true;
                                        break;
                                    }
                                    let _e681 = local_7[_e678];
                                    if _e679 {
                                    } else {
                                        phi_4638_ = true;
                                        break;
                                    }
                                    let _e683 = local_6[_e678];
                                    if _e679 {
                                    } else {
                                        phi_4638_ = true;
                                        break;
                                    }
                                    let _e685 = local_5[_e678];
                                    if _e679 {
                                    } else {
                                        phi_4638_ = true;
                                        break;
                                    }
                                    let _e687 = local_4[_e678];
                                    if _e679 {
                                    } else {
                                        phi_4638_ = true;
                                        break;
                                    }
                                    let _e689 = local_3[_e678];
                                    if _e679 {
                                    } else {
                                        phi_4638_ = true;
                                        break;
                                    }
                                    let _e691 = local_2[_e678];
                                    if _e679 {
                                    } else {
                                        phi_4638_ = true;
                                        break;
                                    }
                                    let _e696 = local_8[_e678];
                                    if _e679 {
                                    } else {
                                        phi_4638_ = true;
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
                                    let _e712 = ((_e708.member_1 & 2147483648u) != 0u);
                                    let _e713 = (_e708.member_1 & 268435455u);
                                    if _e712 {
                                        phi_1221_ = _e664;
                                        phi_1224_ = type_8(0u, ((_e708.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e720 = phi_1221_;
                                            let _e722 = phi_1224_;
                                            local_12 = _e720;
                                            if (_e722.member < _e722.member_1) {
                                                phi_1225_ = type_8((_e722.member + 1u), _e722.member_1);
                                                phi_1247_ = type_8(1u, _e722.member);
                                            } else {
                                                phi_1225_ = _e722;
                                                phi_1247_ = type_8(0u, type_8().member_1);
                                            }
                                            let _e735 = phi_1225_;
                                            let _e737 = phi_1247_;
                                            let _e741 = (bitcast<i32>(_e737.member) != 0i);
                                            if _e741 {
                                                let _e747 = type_39(_e720.member, _e720.member_1, (_e720.member_2 + 1u));
                                                let _e752 = (_e708.member.member_1.x - _e708.member.member.x);
                                                let _e755 = (_e708.member.member_1.y - _e708.member.member.y);
                                                let _e758 = (_e708.member.member_1.z - _e708.member.member.z);
                                                let _e760 = select(_e755, _e752, (_e752 > _e755));
                                                let _e762 = select(_e758, _e760, (_e760 > _e758));
                                                let _e764 = (_e762 < (1024f * _e144));
                                                if _e764 {
                                                    phi_1291_ = 0u;
                                                } else {
                                                    phi_1291_ = select(2u, 1u, (_e762 < (2097152f * _e144)));
                                                }
                                                let _e769 = phi_1291_;
                                                switch bitcast<i32>(_e769) {
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
                                                let _e772 = phi_1297_;
                                                switch bitcast<i32>(_e769) {
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
                                                let _e779 = phi_1307_;
                                                let _e781 = ((_e713 + (_e737.member_1 * ((3u * _e772) + 1u))) + (3u * _e779));
                                                let _e782 = (_e781 < _e96);
                                                if _e782 {
                                                    if _e782 {
                                                    } else {
                                                        phi_4431_ = true;
                                                        break;
                                                    }
                                                    let _e784 = global_5.member[_e781];
                                                    phi_1323_ = _e784;
                                                } else {
                                                    phi_1323_ = 4294967295u;
                                                }
                                                let _e786 = phi_1323_;
                                                if _e764 {
                                                    phi_1356_ = 0u;
                                                } else {
                                                    phi_1356_ = select(2u, 1u, (_e762 < (2097152f * _e144)));
                                                }
                                                let _e791 = phi_1356_;
                                                switch bitcast<i32>(_e791) {
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
                                                let _e794 = phi_1362_;
                                                let _e798 = (_e713 + (_e737.member_1 * ((3u * _e794) + 1u)));
                                                switch bitcast<i32>(_e791) {
                                                    case 0: {
                                                        let _e1073 = (_e798 < _e96);
                                                        if _e1073 {
                                                            if _e1073 {
                                                            } else {
                                                                phi_4431_ = true;
                                                                break;
                                                            }
                                                            let _e1075 = global_5.member[_e798];
                                                            phi_1389_ = _e1075;
                                                        } else {
                                                            phi_1389_ = 0u;
                                                        }
                                                        let _e1077 = phi_1389_;
                                                        let _e1079 = ((10u * _e264) & 31u);
                                                        let _e1089 = ((10u * _e263) & 31u);
                                                        let _e1099 = ((10u * _e265) & 31u);
                                                        let _e1109 = (_e798 + 1u);
                                                        let _e1110 = (_e1109 < _e96);
                                                        if _e1110 {
                                                            if _e1110 {
                                                            } else {
                                                                phi_4431_ = true;
                                                                break;
                                                            }
                                                            let _e1112 = global_5.member[_e1109];
                                                            phi_1438_ = _e1112;
                                                        } else {
                                                            phi_1438_ = 0u;
                                                        }
                                                        let _e1114 = phi_1438_;
                                                        let _e1140 = (_e798 + 2u);
                                                        let _e1141 = (_e1140 < _e96);
                                                        if _e1141 {
                                                            if _e1141 {
                                                            } else {
                                                                phi_4431_ = true;
                                                                break;
                                                            }
                                                            let _e1143 = global_5.member[_e1140];
                                                            phi_1487_ = _e1143;
                                                        } else {
                                                            phi_1487_ = 0u;
                                                        }
                                                        let _e1145 = phi_1487_;
                                                        phi_1988_ = array<array<f32, 3>, 3>(array<f32, 3>((_e708.member.member.x + ((bitcast<f32>((1258291200u | ((_e1077 >> bitcast<u32>(_e1079)) & 1023u))) - 8388608f) * _e144)), (_e708.member.member.y + ((bitcast<f32>((1258291200u | ((_e1077 >> bitcast<u32>(_e1089)) & 1023u))) - 8388608f) * _e144)), (_e708.member.member.z + ((bitcast<f32>((1258291200u | ((_e1077 >> bitcast<u32>(_e1099)) & 1023u))) - 8388608f) * _e144))), array<f32, 3>((_e708.member.member.x + ((bitcast<f32>((1258291200u | ((_e1114 >> bitcast<u32>(_e1079)) & 1023u))) - 8388608f) * _e144)), (_e708.member.member.y + ((bitcast<f32>((1258291200u | ((_e1114 >> bitcast<u32>(_e1089)) & 1023u))) - 8388608f) * _e144)), (_e708.member.member.z + ((bitcast<f32>((1258291200u | ((_e1114 >> bitcast<u32>(_e1099)) & 1023u))) - 8388608f) * _e144))), array<f32, 3>((_e708.member.member.x + ((bitcast<f32>((1258291200u | ((_e1145 >> bitcast<u32>(_e1079)) & 1023u))) - 8388608f) * _e144)), (_e708.member.member.y + ((bitcast<f32>((1258291200u | ((_e1145 >> bitcast<u32>(_e1089)) & 1023u))) - 8388608f) * _e144)), (_e708.member.member.z + ((bitcast<f32>((1258291200u | ((_e1145 >> bitcast<u32>(_e1099)) & 1023u))) - 8388608f) * _e144))));
                                                        break;
                                                    }
                                                    case 1: {
                                                        let _e887 = (_e798 < _e96);
                                                        if _e887 {
                                                            if _e887 {
                                                            } else {
                                                                phi_4431_ = true;
                                                                break;
                                                            }
                                                            let _e889 = global_5.member[_e798];
                                                            phi_1536_ = _e889;
                                                        } else {
                                                            phi_1536_ = 0u;
                                                        }
                                                        let _e891 = phi_1536_;
                                                        let _e892 = (_e798 + 1u);
                                                        let _e893 = (_e892 < _e96);
                                                        if _e893 {
                                                            if _e893 {
                                                            } else {
                                                                phi_4431_ = true;
                                                                break;
                                                            }
                                                            let _e895 = global_5.member[_e892];
                                                            phi_1551_ = _e895;
                                                        } else {
                                                            phi_1551_ = 0u;
                                                        }
                                                        let _e897 = phi_1551_;
                                                        let _e898 = (_e264 == 1u);
                                                        if _e898 {
                                                            phi_1561_ = ((_e891 >> bitcast<u32>(21i)) | (_e897 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1561_ = (_e897 >> bitcast<u32>(10i));
                                                        }
                                                        let _e907 = phi_1561_;
                                                        let _e915 = (_e263 == 1u);
                                                        if _e915 {
                                                            phi_1582_ = ((_e891 >> bitcast<u32>(21i)) | (_e897 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1582_ = (_e897 >> bitcast<u32>(10i));
                                                        }
                                                        let _e924 = phi_1582_;
                                                        let _e932 = (_e265 == 1u);
                                                        if _e932 {
                                                            phi_1603_ = ((_e891 >> bitcast<u32>(21i)) | (_e897 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1603_ = (_e897 >> bitcast<u32>(10i));
                                                        }
                                                        let _e941 = phi_1603_;
                                                        let _e950 = (_e798 + 2u);
                                                        let _e951 = (_e950 < _e96);
                                                        if _e951 {
                                                            if _e951 {
                                                            } else {
                                                                phi_4431_ = true;
                                                                break;
                                                            }
                                                            let _e953 = global_5.member[_e950];
                                                            phi_1633_ = _e953;
                                                        } else {
                                                            phi_1633_ = 0u;
                                                        }
                                                        let _e955 = phi_1633_;
                                                        let _e956 = (_e798 + 3u);
                                                        let _e957 = (_e956 < _e96);
                                                        if _e957 {
                                                            if _e957 {
                                                            } else {
                                                                phi_4431_ = true;
                                                                break;
                                                            }
                                                            let _e959 = global_5.member[_e956];
                                                            phi_1648_ = _e959;
                                                        } else {
                                                            phi_1648_ = 0u;
                                                        }
                                                        let _e961 = phi_1648_;
                                                        if _e898 {
                                                            phi_1658_ = ((_e955 >> bitcast<u32>(21i)) | (_e961 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1658_ = (_e961 >> bitcast<u32>(10i));
                                                        }
                                                        let _e970 = phi_1658_;
                                                        if _e915 {
                                                            phi_1679_ = ((_e955 >> bitcast<u32>(21i)) | (_e961 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1679_ = (_e961 >> bitcast<u32>(10i));
                                                        }
                                                        let _e986 = phi_1679_;
                                                        if _e932 {
                                                            phi_1700_ = ((_e955 >> bitcast<u32>(21i)) | (_e961 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1700_ = (_e961 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1002 = phi_1700_;
                                                        let _e1011 = (_e798 + 4u);
                                                        let _e1012 = (_e1011 < _e96);
                                                        if _e1012 {
                                                            if _e1012 {
                                                            } else {
                                                                phi_4431_ = true;
                                                                break;
                                                            }
                                                            let _e1014 = global_5.member[_e1011];
                                                            phi_1730_ = _e1014;
                                                        } else {
                                                            phi_1730_ = 0u;
                                                        }
                                                        let _e1016 = phi_1730_;
                                                        let _e1017 = (_e798 + 5u);
                                                        let _e1018 = (_e1017 < _e96);
                                                        if _e1018 {
                                                            if _e1018 {
                                                            } else {
                                                                phi_4431_ = true;
                                                                break;
                                                            }
                                                            let _e1020 = global_5.member[_e1017];
                                                            phi_1745_ = _e1020;
                                                        } else {
                                                            phi_1745_ = 0u;
                                                        }
                                                        let _e1022 = phi_1745_;
                                                        if _e898 {
                                                            phi_1755_ = ((_e1016 >> bitcast<u32>(21i)) | (_e1022 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1755_ = (_e1022 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1031 = phi_1755_;
                                                        if _e915 {
                                                            phi_1776_ = ((_e1016 >> bitcast<u32>(21i)) | (_e1022 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1776_ = (_e1022 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1047 = phi_1776_;
                                                        if _e932 {
                                                            phi_1797_ = ((_e1016 >> bitcast<u32>(21i)) | (_e1022 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1797_ = (_e1022 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1063 = phi_1797_;
                                                        phi_1988_ = array<array<f32, 3>, 3>(array<f32, 3>((_e708.member.member.x + ((bitcast<f32>((1258291200u | (select(_e907, _e891, _e303) & 2097151u))) - 8388608f) * _e144)), (_e708.member.member.y + ((bitcast<f32>((1258291200u | (select(_e924, _e891, _e372) & 2097151u))) - 8388608f) * _e144)), (_e708.member.member.z + ((bitcast<f32>((1258291200u | (select(_e941, _e891, _e440) & 2097151u))) - 8388608f) * _e144))), array<f32, 3>((_e708.member.member.x + ((bitcast<f32>((1258291200u | (select(_e970, _e955, _e303) & 2097151u))) - 8388608f) * _e144)), (_e708.member.member.y + ((bitcast<f32>((1258291200u | (select(_e986, _e955, _e372) & 2097151u))) - 8388608f) * _e144)), (_e708.member.member.z + ((bitcast<f32>((1258291200u | (select(_e1002, _e955, _e440) & 2097151u))) - 8388608f) * _e144))), array<f32, 3>((_e708.member.member.x + ((bitcast<f32>((1258291200u | (select(_e1031, _e1016, _e303) & 2097151u))) - 8388608f) * _e144)), (_e708.member.member.y + ((bitcast<f32>((1258291200u | (select(_e1047, _e1016, _e372) & 2097151u))) - 8388608f) * _e144)), (_e708.member.member.z + ((bitcast<f32>((1258291200u | (select(_e1063, _e1016, _e440) & 2097151u))) - 8388608f) * _e144))));
                                                        break;
                                                    }
                                                    case 2: {
                                                        let _e800 = (_e798 + _e264);
                                                        let _e801 = (_e800 < _e96);
                                                        if _e801 {
                                                            if _e801 {
                                                            } else {
                                                                phi_4431_ = true;
                                                                break;
                                                            }
                                                            let _e803 = global_5.member[_e800];
                                                            phi_1828_ = _e803;
                                                        } else {
                                                            phi_1828_ = 0u;
                                                        }
                                                        let _e805 = phi_1828_;
                                                        let _e809 = (_e798 + _e263);
                                                        let _e810 = (_e809 < _e96);
                                                        if _e810 {
                                                            if _e810 {
                                                            } else {
                                                                phi_4431_ = true;
                                                                break;
                                                            }
                                                            let _e812 = global_5.member[_e809];
                                                            phi_1846_ = _e812;
                                                        } else {
                                                            phi_1846_ = 0u;
                                                        }
                                                        let _e814 = phi_1846_;
                                                        let _e818 = (_e798 + _e265);
                                                        let _e819 = (_e818 < _e96);
                                                        if _e819 {
                                                            if _e819 {
                                                            } else {
                                                                phi_4431_ = true;
                                                                break;
                                                            }
                                                            let _e821 = global_5.member[_e818];
                                                            phi_1864_ = _e821;
                                                        } else {
                                                            phi_1864_ = 0u;
                                                        }
                                                        let _e823 = phi_1864_;
                                                        let _e828 = (_e798 + 3u);
                                                        let _e829 = (_e828 + _e264);
                                                        let _e830 = (_e829 < _e96);
                                                        if _e830 {
                                                            if _e830 {
                                                            } else {
                                                                phi_4431_ = true;
                                                                break;
                                                            }
                                                            let _e832 = global_5.member[_e829];
                                                            phi_1887_ = _e832;
                                                        } else {
                                                            phi_1887_ = 0u;
                                                        }
                                                        let _e834 = phi_1887_;
                                                        let _e838 = (_e828 + _e263);
                                                        let _e839 = (_e838 < _e96);
                                                        if _e839 {
                                                            if _e839 {
                                                            } else {
                                                                phi_4431_ = true;
                                                                break;
                                                            }
                                                            let _e841 = global_5.member[_e838];
                                                            phi_1905_ = _e841;
                                                        } else {
                                                            phi_1905_ = 0u;
                                                        }
                                                        let _e843 = phi_1905_;
                                                        let _e847 = (_e828 + _e265);
                                                        let _e848 = (_e847 < _e96);
                                                        if _e848 {
                                                            if _e848 {
                                                            } else {
                                                                phi_4431_ = true;
                                                                break;
                                                            }
                                                            let _e850 = global_5.member[_e847];
                                                            phi_1923_ = _e850;
                                                        } else {
                                                            phi_1923_ = 0u;
                                                        }
                                                        let _e852 = phi_1923_;
                                                        let _e857 = (_e798 + 6u);
                                                        let _e858 = (_e857 + _e264);
                                                        let _e859 = (_e858 < _e96);
                                                        if _e859 {
                                                            if _e859 {
                                                            } else {
                                                                phi_4431_ = true;
                                                                break;
                                                            }
                                                            let _e861 = global_5.member[_e858];
                                                            phi_1946_ = _e861;
                                                        } else {
                                                            phi_1946_ = 0u;
                                                        }
                                                        let _e863 = phi_1946_;
                                                        let _e867 = (_e857 + _e263);
                                                        let _e868 = (_e867 < _e96);
                                                        if _e868 {
                                                            if _e868 {
                                                            } else {
                                                                phi_4431_ = true;
                                                                break;
                                                            }
                                                            let _e870 = global_5.member[_e867];
                                                            phi_1964_ = _e870;
                                                        } else {
                                                            phi_1964_ = 0u;
                                                        }
                                                        let _e872 = phi_1964_;
                                                        let _e876 = (_e857 + _e265);
                                                        let _e877 = (_e876 < _e96);
                                                        if _e877 {
                                                            if _e877 {
                                                            } else {
                                                                phi_4431_ = true;
                                                                break;
                                                            }
                                                            let _e879 = global_5.member[_e876];
                                                            phi_1982_ = _e879;
                                                        } else {
                                                            phi_1982_ = 0u;
                                                        }
                                                        let _e881 = phi_1982_;
                                                        phi_1988_ = array<array<f32, 3>, 3>(array<f32, 3>((f32(bitcast<i32>(_e805)) * _e144), (f32(bitcast<i32>(_e814)) * _e144), (f32(bitcast<i32>(_e823)) * _e144)), array<f32, 3>((f32(bitcast<i32>(_e834)) * _e144), (f32(bitcast<i32>(_e843)) * _e144), (f32(bitcast<i32>(_e852)) * _e144)), array<f32, 3>((f32(bitcast<i32>(_e863)) * _e144), (f32(bitcast<i32>(_e872)) * _e144), (f32(bitcast<i32>(_e881)) * _e144)));
                                                        break;
                                                    }
                                                    default: {
                                                        phi_1988_ = array<array<f32, 3>, 3>();
                                                        break;
                                                    }
                                                }
                                                let _e1173 = phi_1988_;
                                                let _e1182 = (_e1173[0][2] - _e465);
                                                let _e1185 = (((_e1173[0][0] - _e328) * _e504) - (_e1182 * _e368));
                                                let _e1188 = (((_e1173[0][1] - _e397) * _e504) - (_e1182 * _e436));
                                                let _e1195 = (_e1173[1][2] - _e465);
                                                let _e1198 = (((_e1173[1][0] - _e328) * _e504) - (_e1195 * _e368));
                                                let _e1201 = (((_e1173[1][1] - _e397) * _e504) - (_e1195 * _e436));
                                                let _e1208 = (_e1173[2][2] - _e465);
                                                let _e1211 = (((_e1173[2][0] - _e328) * _e504) - (_e1208 * _e368));
                                                let _e1214 = (((_e1173[2][1] - _e397) * _e504) - (_e1208 * _e436));
                                                let _e1215 = (_e1211 * _e1201);
                                                let _e1216 = (_e1214 * _e1198);
                                                let _e1217 = (_e1185 * _e1214);
                                                let _e1218 = (_e1188 * _e1211);
                                                let _e1219 = (_e1198 * _e1188);
                                                let _e1220 = (_e1201 * _e1185);
                                                let _e1225 = (((_e1215 >= _e1216) && (_e1217 >= _e1218)) && (_e1219 >= _e1220));
                                                if (_e1225 || (((_e1215 <= _e1216) && (_e1217 <= _e1218)) && (_e1219 <= _e1220))) {
                                                    let _e1232 = select(-1f, 1f, _e1225);
                                                    let _e1234 = ((_e1215 - _e1216) * _e1232);
                                                    let _e1236 = select(0f, _e1234, (_e1234 > 0f));
                                                    let _e1238 = ((_e1217 - _e1218) * _e1232);
                                                    let _e1240 = select(0f, _e1238, (_e1238 > 0f));
                                                    let _e1242 = ((_e1219 - _e1220) * _e1232);
                                                    let _e1244 = select(0f, _e1242, (_e1242 > 0f));
                                                    let _e1246 = ((_e1236 + _e1240) + _e1244);
                                                    if (_e1246 < 0.000000000000000000000000000000000000011754944f) {
                                                        phi_2872_ = type_24();
                                                        phi_2873_ = true;
                                                        phi_2874_ = false;
                                                    } else {
                                                        let _e1249 = select(_e1198, _e1185, (_e1185 < _e1198));
                                                        if (select(_e1211, _e1249, (_e1249 < _e1211)) > 0f) {
                                                            phi_2140_ = true;
                                                        } else {
                                                            let _e1254 = select(_e1198, _e1185, (_e1185 > _e1198));
                                                            phi_2140_ = (select(_e1211, _e1254, (_e1254 > _e1211)) < 0f);
                                                        }
                                                        let _e1259 = phi_2140_;
                                                        if _e1259 {
                                                            phi_2869_ = type_24();
                                                            phi_2870_ = true;
                                                            phi_2871_ = false;
                                                        } else {
                                                            let _e1261 = select(_e1201, _e1188, (_e1188 < _e1201));
                                                            if (select(_e1214, _e1261, (_e1261 < _e1214)) > 0f) {
                                                                phi_2169_ = true;
                                                            } else {
                                                                let _e1266 = select(_e1201, _e1188, (_e1188 > _e1201));
                                                                phi_2169_ = (select(_e1214, _e1266, (_e1266 > _e1214)) < 0f);
                                                            }
                                                            let _e1271 = phi_2169_;
                                                            if _e1271 {
                                                                phi_2867_ = type_24();
                                                                phi_2868_ = false;
                                                            } else {
                                                                let _e1273 = select(_e1173[1][0], _e1173[0][0], (_e1173[0][0] < _e1173[1][0]));
                                                                let _e1277 = select(_e1173[1][0], _e1173[0][0], (_e1173[0][0] > _e1173[1][0]));
                                                                let _e1281 = select(_e1173[1][1], _e1173[0][1], (_e1173[0][1] < _e1173[1][1]));
                                                                let _e1285 = select(_e1173[1][1], _e1173[0][1], (_e1173[0][1] > _e1173[1][1]));
                                                                let _e1289 = select(_e1173[1][2], _e1173[0][2], (_e1173[0][2] < _e1173[1][2]));
                                                                let _e1293 = select(_e1173[1][2], _e1173[0][2], (_e1173[0][2] > _e1173[1][2]));
                                                                let _e1298 = ((select(_e1173[2][0], _e1273, (_e1273 < _e1173[2][0])) - _e366) * _e371);
                                                                let _e1299 = ((select(_e1173[2][0], _e1277, (_e1277 > _e1173[2][0])) - _e367) * _e371);
                                                                let _e1302 = ((select(_e1173[2][1], _e1281, (_e1281 < _e1173[2][1])) - _e434) * _e439);
                                                                let _e1303 = ((select(_e1173[2][1], _e1285, (_e1285 > _e1173[2][1])) - _e435) * _e439);
                                                                let _e1306 = ((select(_e1173[2][2], _e1289, (_e1289 < _e1173[2][2])) - _e502) * _e507);
                                                                let _e1307 = ((select(_e1173[2][2], _e1293, (_e1293 > _e1173[2][2])) - _e503) * _e507);
                                                                let _e1309 = select(_e1307, _e1306, (_e1306 < _e1307));
                                                                let _e1311 = select(_e1307, _e1306, (_e1306 > _e1307));
                                                                let _e1313 = select(_e1299, _e1298, (_e1298 < _e1299));
                                                                let _e1315 = select(_e1303, _e1302, (_e1302 < _e1303));
                                                                let _e1317 = select(_e1315, _e1313, (_e1313 > _e1315));
                                                                let _e1319 = select(_e1309, _e1317, (_e1317 > _e1309));
                                                                let _e1321 = select(_e1299, _e1298, (_e1298 > _e1299));
                                                                let _e1323 = select(_e1303, _e1302, (_e1302 > _e1303));
                                                                let _e1325 = select(_e1323, _e1321, (_e1321 < _e1323));
                                                                let _e1327 = select(_e1311, _e1325, (_e1325 < _e1311));
                                                                let _e1328 = -(_e1309);
                                                                let _e1334 = select(_e619, _e1319, (_e1319 > _e619));
                                                                if (_e1334 > (_e1327 + (select(_e1328, _e1311, (_e1311 > _e1328)) * 0.0000019073523f))) {
                                                                    phi_2862_ = type_24();
                                                                    phi_2863_ = true;
                                                                } else {
                                                                    let _e1336 = (_e1334 > _e720.member.member_1);
                                                                    if _e1336 {
                                                                        phi_2861_ = type_24();
                                                                    } else {
                                                                        let _e1337 = vec3<f32>(_e1173[0][0], _e1173[0][1], _e1173[0][2]);
                                                                        let _e1338 = vec3<f32>(_e1173[1][0], _e1173[1][1], _e1173[1][2]);
                                                                        let _e1339 = vec3<f32>(_e1173[2][0], _e1173[2][1], _e1173[2][2]);
                                                                        let _e1340 = (_e1173[1][0] - _e1173[0][0]);
                                                                        let _e1341 = (_e1173[1][1] - _e1173[0][1]);
                                                                        let _e1342 = (_e1173[1][2] - _e1173[0][2]);
                                                                        let _e1343 = vec3<f32>(_e1340, _e1341, _e1342);
                                                                        let _e1344 = (_e1173[2][0] - _e1173[1][0]);
                                                                        let _e1345 = (_e1173[2][1] - _e1173[1][1]);
                                                                        let _e1346 = (_e1173[2][2] - _e1173[1][2]);
                                                                        let _e1347 = vec3<f32>(_e1344, _e1345, _e1346);
                                                                        let _e1348 = (_e1173[0][0] - _e1173[2][0]);
                                                                        let _e1349 = (_e1173[0][1] - _e1173[2][1]);
                                                                        let _e1350 = (_e1173[0][2] - _e1173[2][2]);
                                                                        let _e1351 = vec3<f32>(_e1348, _e1349, _e1350);
                                                                        let _e1354 = bitcast<f32>((bitcast<u32>(_e1340) & 2147483647u));
                                                                        let _e1357 = bitcast<f32>((bitcast<u32>(_e1341) & 2147483647u));
                                                                        let _e1359 = select(_e1357, _e1354, (_e1354 > _e1357));
                                                                        let _e1362 = bitcast<f32>((bitcast<u32>(_e1342) & 2147483647u));
                                                                        let _e1364 = select(_e1362, _e1359, (_e1359 > _e1362));
                                                                        let _e1367 = bitcast<f32>((bitcast<u32>(_e1344) & 2147483647u));
                                                                        let _e1370 = bitcast<f32>((bitcast<u32>(_e1345) & 2147483647u));
                                                                        let _e1372 = select(_e1370, _e1367, (_e1367 > _e1370));
                                                                        let _e1375 = bitcast<f32>((bitcast<u32>(_e1346) & 2147483647u));
                                                                        let _e1377 = select(_e1375, _e1372, (_e1372 > _e1375));
                                                                        let _e1380 = bitcast<f32>((bitcast<u32>(_e1348) & 2147483647u));
                                                                        let _e1383 = bitcast<f32>((bitcast<u32>(_e1349) & 2147483647u));
                                                                        let _e1385 = select(_e1383, _e1380, (_e1380 > _e1383));
                                                                        let _e1388 = bitcast<f32>((bitcast<u32>(_e1350) & 2147483647u));
                                                                        let _e1390 = select(_e1388, _e1385, (_e1385 > _e1388));
                                                                        let _e1392 = select(_e1377, _e1364, (_e1364 > _e1377));
                                                                        let _e1394 = select(_e1390, _e1392, (_e1392 > _e1390));
                                                                        if (_e1364 == _e1394) {
                                                                            phi_2588_ = _e1201;
                                                                            phi_2589_ = _e1198;
                                                                            phi_2590_ = _e1188;
                                                                            phi_2591_ = _e1185;
                                                                            phi_2592_ = _e1337;
                                                                            phi_2593_ = _e1351;
                                                                            phi_2594_ = _e1347;
                                                                            phi_2595_ = _e1343;
                                                                        } else {
                                                                            let _e1396 = (_e1377 == _e1394);
                                                                            let _e1401 = vec3(_e1396);
                                                                            phi_2588_ = select(_e1188, _e1214, _e1396);
                                                                            phi_2589_ = select(_e1185, _e1211, _e1396);
                                                                            phi_2590_ = select(_e1214, _e1201, _e1396);
                                                                            phi_2591_ = select(_e1211, _e1198, _e1396);
                                                                            phi_2592_ = select(_e1339, _e1338, _e1401);
                                                                            phi_2593_ = select(_e1347, _e1343, _e1401);
                                                                            phi_2594_ = select(_e1343, _e1351, _e1401);
                                                                            phi_2595_ = select(_e1351, _e1347, _e1401);
                                                                        }
                                                                        let _e1407 = phi_2588_;
                                                                        let _e1409 = phi_2589_;
                                                                        let _e1411 = phi_2590_;
                                                                        let _e1413 = phi_2591_;
                                                                        let _e1415 = phi_2592_;
                                                                        let _e1417 = phi_2593_;
                                                                        let _e1419 = phi_2594_;
                                                                        let _e1421 = phi_2595_;
                                                                        let _e1428 = ((_e1419.y * _e1417.z) - (_e1417.y * _e1419.z));
                                                                        let _e1433 = ((_e1419.z * _e1417.x) - (_e1417.z * _e1419.x));
                                                                        let _e1436 = ((_e1419.x * _e1417.y) - (_e1417.x * _e1419.y));
                                                                        if (_e1236 >= _e1240) {
                                                                            phi_2632_ = select(true, false, (_e1236 >= _e1244));
                                                                        } else {
                                                                            phi_2632_ = true;
                                                                        }
                                                                        let _e1441 = phi_2632_;
                                                                        if _e1441 {
                                                                            phi_2641_ = select(_e1339, _e1338, vec3((_e1240 >= _e1244)));
                                                                        } else {
                                                                            phi_2641_ = _e1337;
                                                                        }
                                                                        let _e1446 = phi_2641_;
                                                                        let _e1457 = (((_e1428 * (_e1446.x - _e328)) + (_e1433 * (_e1446.y - _e397))) + (_e1436 * (_e1446.z - _e465)));
                                                                        let _e1462 = (((_e1428 * _e368) + (_e1433 * _e436)) + (_e1436 * _e504));
                                                                        let _e1463 = (_e1409 - _e1413);
                                                                        let _e1464 = (_e1407 - _e1411);
                                                                        let _e1472 = (-(((_e1413 * _e1463) + (_e1411 * _e1464))) / ((_e1463 * _e1463) + (_e1464 * _e1464)));
                                                                        let _e1474 = select(1f, _e1472, (_e1472 < 1f));
                                                                        let _e1476 = select(0f, _e1474, (_e1474 > 0f));
                                                                        let _e1489 = ((_e1415.x + (_e1421.x * _e1476)) - _e328);
                                                                        let _e1490 = ((_e1415.y + (_e1421.y * _e1476)) - _e397);
                                                                        let _e1491 = ((_e1415.z + (_e1421.z * _e1476)) - _e465);
                                                                        let _e1492 = (_e1491 / _e504);
                                                                        let _e1504 = bitcast<f32>((bitcast<u32>(_e1489) & 2147483647u));
                                                                        let _e1507 = bitcast<f32>((bitcast<u32>(_e1490) & 2147483647u));
                                                                        let _e1509 = select(_e1507, _e1504, (_e1504 > _e1507));
                                                                        let _e1512 = bitcast<f32>((bitcast<u32>(_e1491) & 2147483647u));
                                                                        let _e1514 = select(_e1512, _e1509, (_e1509 > _e1512));
                                                                        let _e1520 = bitcast<f32>((bitcast<u32>(_e1428) & 2147483647u));
                                                                        let _e1523 = bitcast<f32>((bitcast<u32>(_e1433) & 2147483647u));
                                                                        let _e1525 = select(_e1523, _e1520, (_e1520 > _e1523));
                                                                        let _e1528 = bitcast<f32>((bitcast<u32>(_e1436) & 2147483647u));
                                                                        if (bitcast<f32>((bitcast<u32>(((((_e1428 * _e1489) + (_e1433 * _e1490)) + (_e1436 * _e1491)) - _e1457)) & 2147483647u)) <= ((0.0000009536743f * select(_e1394, _e1514, (_e1514 > _e1394))) * select(_e1528, _e1525, (_e1525 > _e1528)))) {
                                                                            let _e1538 = bitcast<f32>((bitcast<u32>(_e1419.x) & 2147483647u));
                                                                            let _e1541 = bitcast<f32>((bitcast<u32>(_e1419.y) & 2147483647u));
                                                                            let _e1543 = select(_e1541, _e1538, (_e1538 > _e1541));
                                                                            let _e1546 = bitcast<f32>((bitcast<u32>(_e1419.z) & 2147483647u));
                                                                            let _e1552 = bitcast<f32>((bitcast<u32>(_e1417.x) & 2147483647u));
                                                                            let _e1555 = bitcast<f32>((bitcast<u32>(_e1417.y) & 2147483647u));
                                                                            let _e1557 = select(_e1555, _e1552, (_e1552 > _e1555));
                                                                            let _e1560 = bitcast<f32>((bitcast<u32>(_e1417.z) & 2147483647u));
                                                                            let _e1564 = (bitcast<f32>((bitcast<u32>(_e1462) & 2147483647u)) > ((0.0000038146973f * select(_e1546, _e1543, (_e1543 > _e1546))) * select(_e1560, _e1557, (_e1557 > _e1560))));
                                                                            if _e1564 {
                                                                                phi_2806_ = (_e1457 / _e1462);
                                                                            } else {
                                                                                phi_2806_ = f32();
                                                                            }
                                                                            let _e1567 = phi_2806_;
                                                                            phi_2808_ = _e1567;
                                                                            phi_2809_ = select(true, false, _e1564);
                                                                        } else {
                                                                            phi_2808_ = f32();
                                                                            phi_2809_ = true;
                                                                        }
                                                                        let _e1570 = phi_2808_;
                                                                        let _e1572 = phi_2809_;
                                                                        if _e1572 {
                                                                            let _e1580 = (((_e1428 * (_e1489 - (_e368 * _e1492))) + (_e1433 * (_e1490 - (_e436 * _e1492)))) / _e1462);
                                                                            if (bitcast<f32>((bitcast<u32>(_e1580) & 2147483647u)) <= _e1394) {
                                                                                phi_2829_ = (_e1492 + _e1580);
                                                                            } else {
                                                                                phi_2829_ = _e1492;
                                                                            }
                                                                            let _e1587 = phi_2829_;
                                                                            phi_2830_ = _e1587;
                                                                        } else {
                                                                            phi_2830_ = _e1570;
                                                                        }
                                                                        let _e1589 = phi_2830_;
                                                                        let _e1591 = select(_e1327, _e1589, (_e1589 < _e1327));
                                                                        let _e1593 = select(_e1319, _e1591, (_e1591 > _e1319));
                                                                        if (_e1593 >= _e619) {
                                                                            let _e1595 = (_e1593 <= _e720.member.member_1);
                                                                            if _e1595 {
                                                                                let _e1596 = (1f / _e1246);
                                                                                phi_2853_ = type_24(_e1593, (_e1240 * _e1596), (_e1244 * _e1596), _e786);
                                                                            } else {
                                                                                phi_2853_ = type_24();
                                                                            }
                                                                            let _e1601 = phi_2853_;
                                                                            phi_2855_ = _e1601;
                                                                            phi_2856_ = select(true, false, _e1595);
                                                                        } else {
                                                                            phi_2855_ = type_24();
                                                                            phi_2856_ = true;
                                                                        }
                                                                        let _e1604 = phi_2855_;
                                                                        let _e1606 = phi_2856_;
                                                                        if _e1606 {
                                                                            phi_2860_ = type_24(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                        } else {
                                                                            phi_2860_ = _e1604;
                                                                        }
                                                                        let _e1608 = phi_2860_;
                                                                        phi_2861_ = _e1608;
                                                                    }
                                                                    let _e1610 = phi_2861_;
                                                                    phi_2862_ = _e1610;
                                                                    phi_2863_ = _e1336;
                                                                }
                                                                let _e1612 = phi_2862_;
                                                                let _e1614 = phi_2863_;
                                                                phi_2867_ = _e1612;
                                                                phi_2868_ = _e1614;
                                                            }
                                                            let _e1616 = phi_2867_;
                                                            let _e1618 = phi_2868_;
                                                            phi_2869_ = _e1616;
                                                            phi_2870_ = _e1271;
                                                            phi_2871_ = _e1618;
                                                        }
                                                        let _e1620 = phi_2869_;
                                                        let _e1622 = phi_2870_;
                                                        let _e1624 = phi_2871_;
                                                        phi_2872_ = _e1620;
                                                        phi_2873_ = _e1622;
                                                        phi_2874_ = _e1624;
                                                    }
                                                    let _e1626 = phi_2872_;
                                                    let _e1628 = phi_2873_;
                                                    let _e1630 = phi_2874_;
                                                    phi_2882_ = _e1626;
                                                    phi_2883_ = select(_e1630, true, _e1628);
                                                } else {
                                                    phi_2882_ = type_24();
                                                    phi_2883_ = true;
                                                }
                                                let _e1633 = phi_2882_;
                                                let _e1635 = phi_2883_;
                                                if _e1635 {
                                                    phi_2887_ = type_24(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                } else {
                                                    phi_2887_ = _e1633;
                                                }
                                                let _e1637 = phi_2887_;
                                                if (_e1637.member_3 != 4294967295u) {
                                                    if (_e786 != 4294967295u) {
                                                        if (_e1637.member < _e720.member.member.member) {
                                                            phi_2913_ = true;
                                                        } else {
                                                            if (_e1637.member == _e720.member.member.member) {
                                                                phi_2912_ = (_e1637.member_3 < _e720.member.member.member_3);
                                                            } else {
                                                                phi_2912_ = false;
                                                            }
                                                            let _e1652 = phi_2912_;
                                                            phi_2913_ = _e1652;
                                                        }
                                                        let _e1654 = phi_2913_;
                                                        if _e1654 {
                                                            phi_2920_ = type_39(type_33(_e1637, _e1637.member), _e747.member_1, _e747.member_2);
                                                        } else {
                                                            phi_2920_ = _e747;
                                                        }
                                                        let _e1661 = phi_2920_;
                                                        phi_2921_ = _e1661;
                                                    } else {
                                                        phi_2921_ = _e747;
                                                    }
                                                    let _e1663 = phi_2921_;
                                                    phi_2922_ = _e1663;
                                                } else {
                                                    phi_2922_ = _e747;
                                                }
                                                let _e1665 = phi_2922_;
                                                phi_1222_ = _e1665;
                                            } else {
                                                phi_1222_ = type_39();
                                            }
                                            let _e1667 = phi_1222_;
                                            continue;
                                            continuing {
                                                phi_1221_ = _e1667;
                                                phi_1224_ = _e735;
                                                phi_4431_ = _e662;
                                                break if !(_e741);
                                            }
                                        }
                                        let _e1670 = phi_4431_;
                                        phi_4638_ = _e1670;
                                        if _e1670 {
                                            break;
                                        }
                                        phi_4729_ = _e1670;
                                        let _e2353 = local_12;
                                        phi_2923_ = _e2353;
                                    } else {
                                        phi_4729_ = _e662;
                                        phi_2923_ = _e664;
                                    }
                                    let _e1672 = phi_4729_;
                                    let _e1674 = phi_2923_;
                                    if _e712 {
                                        phi_4192_ = type_39();
                                        phi_4193_ = bool();
                                        phi_4194_ = u32();
                                        phi_4195_ = type_50();
                                    } else {
                                        if (_e708.member_1 >= _e93) {
                                            phi_3724_ = type_51(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), type_50(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u), type_50(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u));
                                        } else {
                                            if (_e708.member_1 < _e93) {
                                            } else {
                                                phi_4638_ = true;
                                                break;
                                            }
                                            let _e1677 = (_e264 * 2u);
                                            let _e1679 = ((1u + _e1677) % 7u);
                                            if (_e1679 < 7u) {
                                            } else {
                                                phi_4638_ = true;
                                                break;
                                            }
                                            let _e1684 = global_4.member[_e708.member_1][_e1679];
                                            let _e1686 = ((_e1677 + 2u) % 7u);
                                            if (_e1686 < 7u) {
                                            } else {
                                                phi_4638_ = true;
                                                break;
                                            }
                                            let _e1691 = global_4.member[_e708.member_1][_e1686];
                                            let _e1692 = (_e263 * 2u);
                                            let _e1694 = ((1u + _e1692) % 7u);
                                            if (_e1694 < 7u) {
                                            } else {
                                                phi_4638_ = true;
                                                break;
                                            }
                                            let _e1699 = global_4.member[_e708.member_1][_e1694];
                                            let _e1701 = ((_e1692 + 2u) % 7u);
                                            if (_e1701 < 7u) {
                                            } else {
                                                phi_4638_ = true;
                                                break;
                                            }
                                            let _e1706 = global_4.member[_e708.member_1][_e1701];
                                            let _e1707 = (_e265 * 2u);
                                            let _e1709 = ((1u + _e1707) % 7u);
                                            if (_e1709 < 7u) {
                                            } else {
                                                phi_4638_ = true;
                                                break;
                                            }
                                            let _e1714 = global_4.member[_e708.member_1][_e1709];
                                            let _e1716 = ((_e1707 + 2u) % 7u);
                                            if (_e1716 < 7u) {
                                            } else {
                                                phi_4638_ = true;
                                                break;
                                            }
                                            let _e1721 = global_4.member[_e708.member_1][_e1716];
                                            let _e1744 = (bitcast<f32>((bitcast<u32>((_e708.member.member_1.x - _e708.member.member.x)) & 2139095040u)) * 0.0000009536743f);
                                            let _e1745 = (bitcast<f32>((bitcast<u32>((_e708.member.member_1.y - _e708.member.member.y)) & 2139095040u)) * 0.0000009536743f);
                                            let _e1746 = (bitcast<f32>((bitcast<u32>((_e708.member.member_1.z - _e708.member.member.z)) & 2139095040u)) * 0.0000009536743f);
                                            let _e1748 = select(_e144, _e1744, (_e1744 > _e144));
                                            let _e1750 = select(_e144, _e1745, (_e1745 > _e144));
                                            let _e1752 = select(_e144, _e1746, (_e1746 > _e144));
                                            let _e1783 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1684 & 2097151u))) - 8388608f) * _e1748));
                                            let _e1788 = (bitcast<i32>((_e1684 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e1791 = bitcast<f32>((_e1783 & bitcast<u32>(_e1788)));
                                            let _e1792 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1699 & 2097151u))) - 8388608f) * _e1750));
                                            let _e1797 = (bitcast<i32>((_e1699 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e1800 = bitcast<f32>((_e1792 & bitcast<u32>(_e1797)));
                                            let _e1801 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1714 & 2097151u))) - 8388608f) * _e1752));
                                            let _e1806 = (bitcast<i32>((_e1714 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e1809 = bitcast<f32>((_e1801 & bitcast<u32>(_e1806)));
                                            let _e1813 = bitcast<f32>((_e1783 & bitcast<u32>(~(_e1788))));
                                            let _e1817 = bitcast<f32>((_e1792 & bitcast<u32>(~(_e1797))));
                                            let _e1821 = bitcast<f32>((_e1801 & bitcast<u32>(~(_e1806))));
                                            let _e1822 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1691 & 2097151u))) - 8388608f) * _e1748));
                                            let _e1827 = (bitcast<i32>((_e1691 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e1830 = bitcast<f32>((_e1822 & bitcast<u32>(_e1827)));
                                            let _e1831 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1706 & 2097151u))) - 8388608f) * _e1750));
                                            let _e1836 = (bitcast<i32>((_e1706 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e1839 = bitcast<f32>((_e1831 & bitcast<u32>(_e1836)));
                                            let _e1840 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1721 & 2097151u))) - 8388608f) * _e1752));
                                            let _e1845 = (bitcast<i32>((_e1721 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e1848 = bitcast<f32>((_e1840 & bitcast<u32>(_e1845)));
                                            let _e1852 = bitcast<f32>((_e1822 & bitcast<u32>(~(_e1827))));
                                            let _e1856 = bitcast<f32>((_e1831 & bitcast<u32>(~(_e1836))));
                                            let _e1860 = bitcast<f32>((_e1840 & bitcast<u32>(~(_e1845))));
                                            let _e1861 = (_e708.member.member.x + _e1791);
                                            let _e1862 = (_e708.member.member.y + _e1800);
                                            let _e1863 = (_e708.member.member.z + _e1809);
                                            let _e1866 = (_e708.member.member_1.x - _e1830);
                                            let _e1867 = (_e708.member.member_1.y - _e1839);
                                            let _e1868 = (_e708.member.member_1.z - _e1848);
                                            let _e1887 = (_e1866 - _e1861);
                                            let _e1888 = (_e1867 - _e1862);
                                            let _e1889 = (_e1868 - _e1863);
                                            let _e1891 = select(_e1888, _e1887, (_e1887 > _e1888));
                                            let _e1893 = select(_e1889, _e1891, (_e1891 > _e1889));
                                            if (_e1893 < (1024f * _e144)) {
                                                phi_3425_ = 0u;
                                            } else {
                                                phi_3425_ = select(2u, 1u, (_e1893 < (2097152f * _e144)));
                                            }
                                            let _e1900 = phi_3425_;
                                            switch bitcast<i32>(_e1900) {
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
                                            let _e1903 = phi_3431_;
                                            let _e1909 = global_4.member[_e708.member_1][0u];
                                            let _e1913 = global_4.member[_e708.member_1][2u];
                                            let _e1917 = global_4.member[_e708.member_1][4u];
                                            let _e1921 = global_4.member[_e708.member_1][6u];
                                            let _e1933 = (((_e1913 >> bitcast<u32>(22i)) | ((_e1917 >> bitcast<u32>(22i)) << bitcast<u32>(10i))) | ((_e1921 >> bitcast<u32>(22i)) << bitcast<u32>(20i)));
                                            let _e1934 = (_e1909 & 268435455u);
                                            let _e1935 = (_e1933 & 268435455u);
                                            let _e1938 = ((_e1909 >> bitcast<u32>(28u)) & 7u);
                                            let _e1946 = ((_e1909 >> bitcast<u32>(31i)) | (((_e1933 >> bitcast<u32>(28u)) & 3u) << bitcast<u32>(1i)));
                                            let _e1947 = (_e1938 != 0u);
                                            if (_e1938 == 0u) {
                                                phi_3686_ = _e1934;
                                            } else {
                                                if (_e1938 == 7u) {
                                                    phi_3685_ = 2147483648u;
                                                } else {
                                                    phi_3685_ = ((2147483648u | (_e1938 << bitcast<u32>(28u))) | (_e1935 & 268435455u));
                                                }
                                                let _e1956 = phi_3685_;
                                                phi_3686_ = _e1956;
                                            }
                                            let _e1958 = phi_3686_;
                                            if _e1947 {
                                                let _e1959 = (_e1938 != 7u);
                                                if _e1959 {
                                                    phi_3696_ = (_e1935 + (_e1938 * ((3u * _e1903) + 1u)));
                                                } else {
                                                    phi_3696_ = u32();
                                                }
                                                let _e1963 = phi_3696_;
                                                phi_3698_ = _e1963;
                                                phi_3699_ = select(true, false, _e1959);
                                            } else {
                                                phi_3698_ = u32();
                                                phi_3699_ = true;
                                            }
                                            let _e1966 = phi_3698_;
                                            let _e1968 = phi_3699_;
                                            if (_e1946 == 0u) {
                                                phi_3720_ = (_e1934 + select(0u, 1u, !(_e1947)));
                                            } else {
                                                if (_e1946 == 7u) {
                                                    phi_3719_ = 2147483648u;
                                                } else {
                                                    phi_3719_ = ((2147483648u | (_e1946 << bitcast<u32>(28u))) | (select(_e1966, _e1935, _e1968) & 268435455u));
                                                }
                                                let _e1981 = phi_3719_;
                                                phi_3720_ = _e1981;
                                            }
                                            let _e1983 = phi_3720_;
                                            phi_3724_ = type_51(array<vec4<f32>, 3>(vec4<f32>(_e1861, (_e708.member.member.x + _e1813), _e1866, (_e708.member.member_1.x - _e1852)), vec4<f32>(_e1862, (_e708.member.member.y + _e1817), _e1867, (_e708.member.member_1.y - _e1856)), vec4<f32>(_e1863, (_e708.member.member.z + _e1821), _e1868, (_e708.member.member_1.z - _e1860))), type_50(type_28((_e708.member.member + vec4<f32>(_e1791, _e1800, _e1809, 0f)), (_e708.member.member_1 - vec4<f32>(_e1830, _e1839, _e1848, 0f))), _e1958), type_50(type_28((_e708.member.member + vec4<f32>(_e1813, _e1817, _e1821, 0f)), (_e708.member.member_1 - vec4<f32>(_e1852, _e1856, _e1860, 0f))), _e1983));
                                        }
                                        let _e1988 = phi_3724_;
                                        let _e2007 = ((_e1988.member[0].x - _e366) * _e371);
                                        let _e2008 = ((_e1988.member[0].y - _e366) * _e371);
                                        let _e2009 = ((_e1988.member[0].z - _e367) * _e371);
                                        let _e2010 = ((_e1988.member[0].w - _e367) * _e371);
                                        let _e2020 = ((_e1988.member[1].x - _e434) * _e439);
                                        let _e2021 = ((_e1988.member[1].y - _e434) * _e439);
                                        let _e2022 = ((_e1988.member[1].z - _e435) * _e439);
                                        let _e2023 = ((_e1988.member[1].w - _e435) * _e439);
                                        let _e2033 = ((_e1988.member[2].x - _e502) * _e507);
                                        let _e2034 = ((_e1988.member[2].y - _e502) * _e507);
                                        let _e2035 = ((_e1988.member[2].z - _e503) * _e507);
                                        let _e2036 = ((_e1988.member[2].w - _e503) * _e507);
                                        let _e2038 = select(_e2035, _e2033, (_e2033 < _e2035));
                                        let _e2040 = select(_e2036, _e2034, (_e2034 < _e2036));
                                        let _e2042 = select(_e2035, _e2033, (_e2033 > _e2035));
                                        let _e2044 = select(_e2036, _e2034, (_e2034 > _e2036));
                                        let _e2046 = select(_e2009, _e2007, (_e2007 < _e2009));
                                        let _e2048 = select(_e2010, _e2008, (_e2008 < _e2010));
                                        let _e2050 = select(_e2022, _e2020, (_e2020 < _e2022));
                                        let _e2052 = select(_e2023, _e2021, (_e2021 < _e2023));
                                        let _e2054 = select(_e2050, _e2046, (_e2046 > _e2050));
                                        let _e2056 = select(_e2052, _e2048, (_e2048 > _e2052));
                                        let _e2058 = select(_e2038, _e2054, (_e2054 > _e2038));
                                        let _e2060 = select(_e2040, _e2056, (_e2056 > _e2040));
                                        let _e2062 = select(_e2009, _e2007, (_e2007 > _e2009));
                                        let _e2064 = select(_e2010, _e2008, (_e2008 > _e2010));
                                        let _e2066 = select(_e2022, _e2020, (_e2020 > _e2022));
                                        let _e2068 = select(_e2023, _e2021, (_e2021 > _e2023));
                                        let _e2070 = select(_e2066, _e2062, (_e2062 < _e2066));
                                        let _e2072 = select(_e2068, _e2064, (_e2064 < _e2068));
                                        let _e2077 = -(_e2038);
                                        let _e2078 = -(_e2040);
                                        let _e2085 = (select(_e2042, _e2070, (_e2070 < _e2042)) + (select(_e2077, _e2042, (_e2042 > _e2077)) * 0.0000019073523f));
                                        let _e2086 = (select(_e2044, _e2072, (_e2072 < _e2044)) + (select(_e2078, _e2044, (_e2044 > _e2078)) * 0.0000019073523f));
                                        let _e2088 = select(_e619, _e2058, (_e2058 > _e619));
                                        let _e2090 = select(_e619, _e2060, (_e2060 > _e619));
                                        let _e2095 = (_e2088 <= select(_e1674.member.member_1, _e2085, (_e2085 < _e1674.member.member_1)));
                                        let _e2096 = (_e2090 <= select(_e1674.member.member_1, _e2086, (_e2086 < _e1674.member.member_1)));
                                        let _e2097 = (_e2088 <= _e2090);
                                        if _e2095 {
                                            if _e2096 {
                                                if _e2097 {
                                                    phi_4089_ = _e1988.member_2;
                                                } else {
                                                    phi_4089_ = _e1988.member_1;
                                                }
                                                let _e2101 = phi_4089_;
                                                let _e2122 = (_e706 % 128u);
                                                let _e2123 = (_e2122 < 128u);
                                                if _e2123 {
                                                } else {
                                                    phi_4638_ = true;
                                                    break;
                                                }
                                                local_8[_e2122] = _e2101.member_1;
                                                if _e2123 {
                                                } else {
                                                    phi_4638_ = true;
                                                    break;
                                                }
                                                local_7[_e2122] = _e2101.member.member.x;
                                                if _e2123 {
                                                } else {
                                                    phi_4638_ = true;
                                                    break;
                                                }
                                                local_6[_e2122] = _e2101.member.member.y;
                                                if _e2123 {
                                                } else {
                                                    phi_4638_ = true;
                                                    break;
                                                }
                                                local_5[_e2122] = _e2101.member.member.z;
                                                if _e2123 {
                                                } else {
                                                    phi_4638_ = true;
                                                    break;
                                                }
                                                local_4[_e2122] = _e2101.member.member_1.x;
                                                if _e2123 {
                                                } else {
                                                    phi_4638_ = true;
                                                    break;
                                                }
                                                local_3[_e2122] = _e2101.member.member_1.y;
                                                if _e2123 {
                                                } else {
                                                    phi_4638_ = true;
                                                    break;
                                                }
                                                local_2[_e2122] = _e2101.member.member_1.z;
                                                if _e2123 {
                                                } else {
                                                    phi_4638_ = true;
                                                    break;
                                                }
                                                local_9[_e2122] = select(_e2088, _e2090, _e2097);
                                                if _e2097 {
                                                    phi_4165_ = _e1988.member_1;
                                                } else {
                                                    phi_4165_ = _e1988.member_2;
                                                }
                                                let _e2136 = phi_4165_;
                                                phi_4166_ = (_e706 + 1u);
                                                phi_4167_ = _e2136;
                                            } else {
                                                phi_4166_ = u32();
                                                phi_4167_ = type_50();
                                            }
                                            let _e2138 = phi_4166_;
                                            let _e2140 = phi_4167_;
                                            phi_4169_ = _e2138;
                                            phi_4170_ = _e2140;
                                            phi_4171_ = select(true, false, _e2096);
                                        } else {
                                            phi_4169_ = u32();
                                            phi_4170_ = type_50();
                                            phi_4171_ = true;
                                        }
                                        let _e2143 = phi_4169_;
                                        let _e2145 = phi_4170_;
                                        let _e2147 = phi_4171_;
                                        if _e2147 {
                                            if _e2095 {
                                                phi_4180_ = _e1988.member_1;
                                            } else {
                                                phi_4180_ = _e1988.member_2;
                                            }
                                            let _e2151 = phi_4180_;
                                            phi_4185_ = select(_e2096, true, _e2095);
                                            phi_4187_ = _e2151;
                                        } else {
                                            phi_4185_ = _e704;
                                            phi_4187_ = _e2145;
                                        }
                                        let _e2154 = phi_4185_;
                                        let _e2156 = phi_4187_;
                                        phi_4192_ = type_39(_e1674.member, (_e1674.member_1 + 1u), _e1674.member_2);
                                        phi_4193_ = _e2154;
                                        phi_4194_ = select(_e2143, _e706, _e2147);
                                        phi_4195_ = _e2156;
                                    }
                                    let _e2159 = phi_4192_;
                                    let _e2161 = phi_4193_;
                                    let _e2163 = phi_4194_;
                                    let _e2165 = phi_4195_;
                                    if _e712 {
                                        phi_4203_ = _e1674;
                                        phi_4206_ = _e708;
                                    } else {
                                        phi_4203_ = _e2159;
                                        phi_4206_ = _e2165;
                                    }
                                    let _e2167 = phi_4203_;
                                    let _e2169 = phi_4206_;
                                    phi_4641_ = _e1672;
                                    phi_4207_ = _e2167;
                                    phi_4208_ = (_e666 - 1u);
                                    phi_4209_ = select(_e2161, false, _e712);
                                    phi_4210_ = select(_e2163, _e706, _e712);
                                    phi_4211_ = _e2169;
                                } else {
                                    phi_4641_ = _e662;
                                    phi_4207_ = _e664;
                                    phi_4208_ = _e666;
                                    phi_4209_ = _e704;
                                    phi_4210_ = _e706;
                                    phi_4211_ = _e708;
                                }
                                let _e2173 = phi_4641_;
                                let _e2175 = phi_4207_;
                                let _e2177 = phi_4208_;
                                let _e2179 = phi_4209_;
                                let _e2181 = phi_4210_;
                                let _e2183 = phi_4211_;
                                phi_4640_ = _e2173;
                                phi_4212_ = _e2175;
                                phi_4213_ = _e2177;
                                phi_4214_ = _e2179;
                                phi_4215_ = _e2181;
                                phi_4216_ = _e2183;
                            } else {
                                phi_4640_ = _e662;
                                phi_4212_ = type_39();
                                phi_4213_ = u32();
                                phi_4214_ = bool();
                                phi_4215_ = u32();
                                phi_4216_ = type_50();
                            }
                            let _e2185 = phi_4640_;
                            let _e2187 = phi_4212_;
                            let _e2189 = phi_4213_;
                            let _e2191 = phi_4214_;
                            let _e2193 = phi_4215_;
                            let _e2195 = phi_4216_;
                            phi_4639_ = _e2185;
                            phi_1095_ = _e2187;
                            phi_1098_ = _e2189;
                            phi_1100_ = _e2191;
                            phi_1102_ = _e2193;
                            phi_1104_ = _e2195;
                            phi_4217_ = _e676;
                        } else {
                            phi_4639_ = _e662;
                            phi_1095_ = type_39();
                            phi_1098_ = u32();
                            phi_1100_ = bool();
                            phi_1102_ = u32();
                            phi_1104_ = type_50();
                            phi_4217_ = false;
                        }
                        let _e2197 = phi_4639_;
                        let _e2199 = phi_1095_;
                        let _e2201 = phi_1098_;
                        let _e2203 = phi_1100_;
                        let _e2205 = phi_1102_;
                        let _e2207 = phi_1104_;
                        let _e2209 = phi_4217_;
                        continue;
                        continuing {
                            phi_4437_ = _e2197;
                            phi_1094_ = _e2199;
                            phi_1097_ = _e2201;
                            phi_1099_ = _e2203;
                            phi_1101_ = _e2205;
                            phi_1103_ = _e2207;
                            phi_4638_ = _e2197;
                            break if !(_e2209);
                        }
                    }
                    let _e2212 = phi_4638_;
                    if _e2212 {
                        break;
                    }
                    let _e2214 = local_10;
                    let _e2217 = local_11;
                    if _e152 {
                    } else {
                        break;
                    }
                    global_6.member[_e150][0u] = _e2214.member_1;
                    global_6.member[_e150][1u] = _e2217.member_2;
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
