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

struct type_26 {
    member: array<type_24>,
}

struct type_28 {
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
    member: type_24,
    member_1: f32,
}

struct type_40 {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: bool,
}

struct type_42 {
    member: array<type_28>,
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
var<storage> global_4: type_42;
@group(0) @binding(3) 
var<storage> global_5: type_4;
@group(0) @binding(5) 
var<storage, read_write> global_6: type_26;

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
    var phi_504_: i32;
    var phi_505_: i32;
    var phi_515_: bool;
    var phi_525_: u32;
    var phi_526_: u32;
    var phi_528_: bool;
    var phi_533_: u32;
    var phi_546_: i32;
    var phi_566_: i32;
    var phi_584_: f32;
    var phi_590_: f32;
    var phi_630_: f32;
    var phi_636_: f32;
    var phi_709_: f32;
    var phi_715_: f32;
    var phi_755_: f32;
    var phi_761_: f32;
    var phi_834_: f32;
    var phi_840_: f32;
    var phi_880_: f32;
    var phi_886_: f32;
    var phi_1005_: i32;
    var phi_1027_: u32;
    var phi_1028_: u32;
    var phi_1065_: i32;
    var phi_1087_: u32;
    var phi_1088_: u32;
    var phi_1096_: f32;
    var phi_1097_: f32;
    var phi_4745_: bool;
    var phi_1193_: type_37;
    var phi_1196_: u32;
    var phi_1198_: bool;
    var phi_1200_: u32;
    var phi_1202_: type_50;
    var phi_1213_: bool;
    var phi_1299_: bool;
    var phi_1300_: u32;
    var phi_1301_: type_50;
    var phi_1320_: type_37;
    var phi_1323_: type_8;
    var phi_1324_: type_8;
    var phi_1346_: type_8;
    var phi_1387_: u32;
    var phi_1393_: u32;
    var phi_1403_: u32;
    var phi_1419_: u32;
    var phi_1452_: u32;
    var phi_1458_: u32;
    var phi_1924_: u32;
    var phi_1942_: u32;
    var phi_1960_: u32;
    var phi_1983_: u32;
    var phi_2001_: u32;
    var phi_2019_: u32;
    var phi_2042_: u32;
    var phi_2060_: u32;
    var phi_2078_: u32;
    var phi_1632_: u32;
    var phi_1647_: u32;
    var phi_1657_: u32;
    var phi_1678_: u32;
    var phi_1699_: u32;
    var phi_1729_: u32;
    var phi_1744_: u32;
    var phi_1754_: u32;
    var phi_1775_: u32;
    var phi_1796_: u32;
    var phi_1826_: u32;
    var phi_1841_: u32;
    var phi_1851_: u32;
    var phi_1872_: u32;
    var phi_1893_: u32;
    var phi_1485_: u32;
    var phi_1534_: u32;
    var phi_1583_: u32;
    var phi_2084_: array<array<f32, 3>, 3>;
    var phi_4306_: bool;
    var phi_4321_: bool;
    var phi_4336_: bool;
    var phi_4351_: bool;
    var phi_4366_: bool;
    var phi_4381_: bool;
    var phi_2626_: f32;
    var phi_2627_: f32;
    var phi_2628_: f32;
    var phi_2629_: f32;
    var phi_2630_: vec3<f32>;
    var phi_2631_: vec3<f32>;
    var phi_2632_: vec3<f32>;
    var phi_2633_: vec3<f32>;
    var phi_4396_: bool;
    var phi_4411_: bool;
    var phi_4426_: bool;
    var phi_4441_: bool;
    var phi_4456_: bool;
    var phi_4471_: bool;
    var phi_2841_: f32;
    var phi_2861_: type_40;
    var phi_2862_: type_40;
    var phi_2865_: type_40;
    var phi_2866_: type_40;
    var phi_2867_: bool;
    var phi_2871_: type_40;
    var phi_2880_: type_24;
    var phi_2905_: bool;
    var phi_2906_: bool;
    var phi_2912_: type_37;
    var phi_2913_: type_37;
    var phi_2914_: type_37;
    var phi_1321_: type_37;
    var phi_4739_: bool;
    var phi_5042_: bool;
    var phi_2915_: type_37;
    var phi_3417_: u32;
    var phi_3423_: u32;
    var phi_3677_: u32;
    var phi_3678_: u32;
    var phi_3688_: u32;
    var phi_3690_: u32;
    var phi_3691_: bool;
    var phi_3711_: u32;
    var phi_3712_: u32;
    var phi_3716_: type_51;
    var phi_4078_: type_50;
    var phi_4154_: type_50;
    var phi_4155_: u32;
    var phi_4156_: type_50;
    var phi_4158_: u32;
    var phi_4159_: type_50;
    var phi_4160_: bool;
    var phi_4169_: type_50;
    var phi_4174_: bool;
    var phi_4176_: type_50;
    var phi_4180_: bool;
    var phi_4181_: u32;
    var phi_4182_: type_50;
    var phi_4192_: type_50;
    var phi_4954_: bool;
    var phi_4193_: type_37;
    var phi_4194_: u32;
    var phi_4195_: bool;
    var phi_4196_: u32;
    var phi_4197_: type_50;
    var phi_4953_: bool;
    var phi_4198_: type_37;
    var phi_4199_: u32;
    var phi_4200_: bool;
    var phi_4201_: u32;
    var phi_4202_: type_50;
    var phi_4952_: bool;
    var phi_1194_: type_37;
    var phi_1197_: u32;
    var phi_1199_: bool;
    var phi_1201_: u32;
    var phi_1203_: type_50;
    var phi_4203_: bool;
    var phi_4951_: bool;
    var local_10: type_37;
    var phi_4241_: f32;
    var phi_4243_: f32;
    var phi_4244_: bool;
    var phi_4245_: f32;
    var phi_4246_: bool;
    var phi_4647_: u32;
    var phi_4665_: bool;
    var phi_4668_: bool;
    var phi_4681_: f32;
    var phi_4682_: f32;
    var phi_4687_: f32;
    var phi_4688_: f32;
    var phi_4689_: bool;
    var phi_4697_: f32;
    var phi_4261_: f32;
    var phi_4262_: f32;
    var phi_4274_: f32;
    var phi_4279_: type_24;
    var local_11: type_37;

    switch bitcast<i32>(0u) {
        default: {
            let _e97 = global;
            let _e99 = arrayLength((&global_3.member));
            let _e102 = arrayLength((&global_5.member));
            let _e110 = global_2.member[0u][0u];
            let _e114 = global_2.member[0u][1u];
            let _e118 = global_2.member[0u][2u];
            let _e122 = global_2.member[0u][3u];
            let _e126 = global_2.member[1u][0u];
            let _e130 = global_2.member[1u][1u];
            let _e134 = global_2.member[1u][2u];
            let _e137 = global_1.member[0u];
            let _e138 = bitcast<i32>(_e137);
            let _e150 = bitcast<f32>((bitcast<u32>((bitcast<i32>(_e122) + 127i)) << bitcast<u32>(23i)));
            local_1 = array<i32, 3>(bitcast<i32>(_e110), bitcast<i32>(_e114), bitcast<i32>(_e118));
            local = array<i32, 3>(bitcast<i32>(_e126), bitcast<i32>(_e130), bitcast<i32>(_e134));
            let _e156 = (_e97.x + (_e97.y * 2097152u));
            let _e157 = (_e156 < arrayLength((&global_4.member)));
            if _e157 {
                let _e158 = (_e156 < arrayLength((&global_6.member)));
                if _e158 {
                    if _e157 {
                    } else {
                        break;
                    }
                    let _e166 = global_4.member[_e156].member_2[0u];
                    let _e168 = (bitcast<u32>(_e166) & 2147483647u);
                    let _e173 = global_4.member[_e156].member_2[1u];
                    let _e175 = (bitcast<u32>(_e173) & 2147483647u);
                    let _e180 = global_4.member[_e156].member_2[2u];
                    let _e182 = (bitcast<u32>(_e180) & 2147483647u);
                    let _e187 = global_4.member[_e156].member[0u];
                    let _e189 = (bitcast<u32>(_e187) & 2147483647u);
                    let _e194 = global_4.member[_e156].member[1u];
                    let _e196 = (bitcast<u32>(_e194) & 2147483647u);
                    let _e201 = global_4.member[_e156].member[2u];
                    let _e203 = (bitcast<u32>(_e201) & 2147483647u);
                    let _e205 = select(_e175, _e168, (_e175 < _e168));
                    let _e207 = select(_e182, _e205, (_e182 < _e205));
                    let _e209 = select(_e189, _e207, (_e189 < _e207));
                    let _e211 = select(_e196, _e209, (_e196 < _e209));
                    let _e213 = select(_e203, _e211, (_e203 < _e211));
                    let _e217 = global_4.member[_e156].member_1;
                    let _e218 = bitcast<u32>(_e217);
                    let _e219 = (_e218 & 2147483647u);
                    let _e226 = global_4.member[_e156].member_3;
                    let _e227 = bitcast<u32>(_e226);
                    let _e228 = (_e227 & 2147483647u);
                    let _e232 = (((select(_e219, _e213, (_e219 < _e213)) < 2139095040u) && (_e228 <= 2139095040u)) && (_e207 > 0u));
                    if _e232 {
                        let _e235 = (bitcast<u32>(bitcast<f32>(_e207)) & 2147483647u);
                        if (_e235 >= 8388608u) {
                            phi_504_ = (bitcast<i32>((_e235 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_504_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e235)), 32u, (_e235 == 0u))));
                        }
                        let _e249 = phi_504_;
                        phi_505_ = _e249;
                    } else {
                        phi_505_ = 0i;
                    }
                    let _e251 = phi_505_;
                    let _e252 = (_e168 == _e207);
                    if _e252 {
                        phi_515_ = true;
                    } else {
                        phi_515_ = (_e175 == _e207);
                    }
                    let _e255 = phi_515_;
                    let _e256 = select(1u, 0u, _e252);
                    if _e255 {
                        let _e257 = (_e256 + 1u);
                        phi_525_ = _e257;
                        phi_526_ = _e257;
                        phi_528_ = select(true, false, (_e257 == 2u));
                    } else {
                        phi_525_ = u32();
                        phi_526_ = 0u;
                        phi_528_ = true;
                    }
                    let _e261 = phi_525_;
                    let _e263 = phi_526_;
                    let _e265 = phi_528_;
                    if _e265 {
                        phi_533_ = (_e263 + 1u);
                    } else {
                        phi_533_ = 0u;
                    }
                    let _e269 = phi_533_;
                    let _e270 = select(_e261, _e263, _e265);
                    let _e271 = select(_e256, select(2u, _e256, _e255), _e265);
                    if (_e138 < -126i) {
                        phi_546_ = -126i;
                    } else {
                        phi_546_ = select(_e138, 127i, (_e138 > 127i));
                    }
                    let _e276 = phi_546_;
                    let _e281 = bitcast<f32>((bitcast<u32>((_e276 + 127i)) << bitcast<u32>(23i)));
                    let _e287 = bitcast<f32>((bitcast<u32>(((_e138 - _e276) + 127i)) << bitcast<u32>(23i)));
                    let _e288 = -(_e251);
                    if (_e288 < -126i) {
                        phi_566_ = -126i;
                    } else {
                        phi_566_ = select(_e288, 127i, (_e288 > 127i));
                    }
                    let _e293 = phi_566_;
                    let _e298 = bitcast<f32>((bitcast<u32>((_e293 + 127i)) << bitcast<u32>(23i)));
                    let _e304 = bitcast<f32>((bitcast<u32>(((_e288 - _e293) + 127i)) << bitcast<u32>(23i)));
                    let _e308 = global_4.member[_e156].member;
                    let _e309 = (_e270 == 0u);
                    if _e309 {
                        phi_584_ = _e308[0];
                    } else {
                        phi_584_ = _e308[1];
                    }
                    let _e313 = phi_584_;
                    let _e314 = (_e270 == 2u);
                    if _e314 {
                        phi_590_ = _e308[2];
                    } else {
                        phi_590_ = _e313;
                    }
                    let _e317 = phi_590_;
                    let _e318 = bitcast<u32>(_e317);
                    let _e320 = ((_e318 & 2139095040u) != 0u);
                    let _e334 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e318 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e318 & 2147483648u))), _e317, _e320) * _e281) * select(0.00000011920929f, 1f, _e320)) * _e287);
                    let _e335 = global_4.member[_e156].member_2;
                    if _e309 {
                        phi_630_ = _e335[0];
                    } else {
                        phi_630_ = _e335[1];
                    }
                    let _e339 = phi_630_;
                    if _e314 {
                        phi_636_ = _e335[2];
                    } else {
                        phi_636_ = _e339;
                    }
                    let _e342 = phi_636_;
                    let _e343 = bitcast<u32>(_e342);
                    let _e345 = ((_e343 & 2139095040u) != 0u);
                    let _e359 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e343 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e343 & 2147483648u))), _e342, _e345) * _e298) * select(0.00000011920929f, 1f, _e345)) * _e304);
                    let _e363 = (bitcast<f32>((bitcast<u32>(_e359) & 2147483647u)) >= 0.00000000000000000086736174f);
                    let _e366 = bitcast<f32>((bitcast<u32>(_e334) & 2147483647u));
                    let _e367 = (_e366 * 0.00000011920929f);
                    let _e370 = select(select(0.00000000000011368684f, _e367, (_e367 > 0.00000000000011368684f)), 0f, _e363);
                    let _e371 = select(0f, _e359, _e363);
                    let _e372 = (_e334 + _e370);
                    let _e373 = (_e334 - _e370);
                    let _e375 = select(38685626000000000000000000f, (1f / _e359), _e363);
                    let _e376 = (_e269 == 0u);
                    if _e376 {
                        phi_709_ = _e308[0];
                    } else {
                        phi_709_ = _e308[1];
                    }
                    let _e380 = phi_709_;
                    let _e381 = (_e269 == 2u);
                    if _e381 {
                        phi_715_ = _e308[2];
                    } else {
                        phi_715_ = _e380;
                    }
                    let _e384 = phi_715_;
                    let _e385 = bitcast<u32>(_e384);
                    let _e387 = ((_e385 & 2139095040u) != 0u);
                    let _e401 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e385 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e385 & 2147483648u))), _e384, _e387) * _e281) * select(0.00000011920929f, 1f, _e387)) * _e287);
                    if _e376 {
                        phi_755_ = _e335[0];
                    } else {
                        phi_755_ = _e335[1];
                    }
                    let _e405 = phi_755_;
                    if _e381 {
                        phi_761_ = _e335[2];
                    } else {
                        phi_761_ = _e405;
                    }
                    let _e408 = phi_761_;
                    let _e409 = bitcast<u32>(_e408);
                    let _e411 = ((_e409 & 2139095040u) != 0u);
                    let _e425 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e409 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e409 & 2147483648u))), _e408, _e411) * _e298) * select(0.00000011920929f, 1f, _e411)) * _e304);
                    let _e429 = (bitcast<f32>((bitcast<u32>(_e425) & 2147483647u)) >= 0.00000000000000000086736174f);
                    let _e432 = bitcast<f32>((bitcast<u32>(_e401) & 2147483647u));
                    let _e433 = (_e432 * 0.00000011920929f);
                    let _e436 = select(select(0.00000000000011368684f, _e433, (_e433 > 0.00000000000011368684f)), 0f, _e429);
                    let _e437 = select(0f, _e425, _e429);
                    let _e438 = (_e401 + _e436);
                    let _e439 = (_e401 - _e436);
                    let _e441 = select(38685626000000000000000000f, (1f / _e425), _e429);
                    let _e442 = (_e271 == 0u);
                    if _e442 {
                        phi_834_ = _e308[0];
                    } else {
                        phi_834_ = _e308[1];
                    }
                    let _e446 = phi_834_;
                    let _e447 = (_e271 == 2u);
                    if _e447 {
                        phi_840_ = _e308[2];
                    } else {
                        phi_840_ = _e446;
                    }
                    let _e450 = phi_840_;
                    let _e451 = bitcast<u32>(_e450);
                    let _e453 = ((_e451 & 2139095040u) != 0u);
                    let _e467 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e451 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e451 & 2147483648u))), _e450, _e453) * _e281) * select(0.00000011920929f, 1f, _e453)) * _e287);
                    if _e442 {
                        phi_880_ = _e335[0];
                    } else {
                        phi_880_ = _e335[1];
                    }
                    let _e471 = phi_880_;
                    if _e447 {
                        phi_886_ = _e335[2];
                    } else {
                        phi_886_ = _e471;
                    }
                    let _e474 = phi_886_;
                    let _e475 = bitcast<u32>(_e474);
                    let _e477 = ((_e475 & 2139095040u) != 0u);
                    let _e491 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e475 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e475 & 2147483648u))), _e474, _e477) * _e298) * select(0.00000011920929f, 1f, _e477)) * _e304);
                    let _e495 = (bitcast<f32>((bitcast<u32>(_e491) & 2147483647u)) >= 0.00000000000000000086736174f);
                    let _e498 = bitcast<f32>((bitcast<u32>(_e467) & 2147483647u));
                    let _e499 = (_e498 * 0.00000011920929f);
                    let _e502 = select(select(0.00000000000011368684f, _e499, (_e499 > 0.00000000000011368684f)), 0f, _e495);
                    let _e503 = select(0f, _e491, _e495);
                    let _e504 = (_e467 + _e502);
                    let _e505 = (_e467 - _e502);
                    let _e507 = select(38685626000000000000000000f, (1f / _e491), _e495);
                    let _e509 = select(_e432, _e366, (_e366 > _e432));
                    let _e512 = (_e138 + _e251);
                    if (_e232 && (select(_e498, _e509, (_e509 > _e498)) <= 1099511600000f)) {
                        let _e522 = ((_e219 & 8388607u) | (select(0u, 1u, ((_e219 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                        let _e525 = bitcast<i32>((_e219 >> bitcast<u32>(23i)));
                        let _e529 = (_e522 == 0u);
                        let _e532 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e522)), 32u, _e529)) - 8i);
                        if (_e525 == 255i) {
                            phi_1005_ = 255i;
                        } else {
                            phi_1005_ = (((_e525 + select(0i, 1i, (_e525 == 0i))) - _e532) + _e512);
                        }
                        let _e540 = phi_1005_;
                        let _e550 = (_e540 <= 0i);
                        if _e550 {
                            phi_1028_ = u32();
                        } else {
                            if _e529 {
                                phi_1027_ = u32();
                            } else {
                                phi_1027_ = select(((bitcast<u32>(_e540) << bitcast<u32>(23i)) | ((_e522 << bitcast<u32>(((_e532 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e540 >= 255i));
                            }
                            let _e554 = phi_1027_;
                            phi_1028_ = _e554;
                        }
                        let _e556 = phi_1028_;
                        let _e568 = ((_e228 & 8388607u) | (select(0u, 1u, ((_e228 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                        let _e571 = bitcast<i32>((_e228 >> bitcast<u32>(23i)));
                        let _e575 = (_e568 == 0u);
                        let _e578 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e568)), 32u, _e575)) - 8i);
                        if (_e571 == 255i) {
                            phi_1065_ = 255i;
                        } else {
                            phi_1065_ = (((_e571 + select(0i, 1i, (_e571 == 0i))) - _e578) + _e512);
                        }
                        let _e586 = phi_1065_;
                        let _e596 = (_e586 <= 0i);
                        if _e596 {
                            phi_1088_ = u32();
                        } else {
                            if _e575 {
                                phi_1087_ = u32();
                            } else {
                                phi_1087_ = select(((bitcast<u32>(_e586) << bitcast<u32>(23i)) | ((_e568 << bitcast<u32>(((_e578 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e586 >= 255i));
                            }
                            let _e600 = phi_1087_;
                            phi_1088_ = _e600;
                        }
                        let _e602 = phi_1088_;
                        phi_1096_ = bitcast<f32>(((_e227 & 2147483648u) | select(_e602, 0u, select(_e575, true, _e596))));
                        phi_1097_ = bitcast<f32>(((_e218 & 2147483648u) | select(_e556, 0u, select(_e529, true, _e550))));
                    } else {
                        phi_1096_ = 0f;
                        phi_1097_ = 1f;
                    }
                    let _e608 = phi_1096_;
                    let _e610 = phi_1097_;
                    local_8 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                    local_7 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_6 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_5 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_4 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_3 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_9 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    let _e614 = (_e270 % 3u);
                    let _e615 = (_e614 < 3u);
                    if _e615 {
                    } else {
                        break;
                    }
                    let _e617 = local_1[_e614];
                    let _e620 = (_e269 % 3u);
                    let _e621 = (_e620 < 3u);
                    if _e621 {
                    } else {
                        break;
                    }
                    let _e623 = local_1[_e620];
                    let _e626 = (_e271 % 3u);
                    let _e627 = (_e626 < 3u);
                    if _e627 {
                    } else {
                        break;
                    }
                    let _e629 = local_1[_e626];
                    if _e615 {
                    } else {
                        break;
                    }
                    let _e634 = local[_e614];
                    if _e621 {
                    } else {
                        break;
                    }
                    let _e638 = local[_e620];
                    if _e627 {
                    } else {
                        break;
                    }
                    let _e642 = local[_e626];
                    phi_4745_ = false;
                    phi_1193_ = type_37(type_24(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e608);
                    phi_1196_ = ((3u * _e99) + 1u);
                    phi_1198_ = (_e610 <= _e608);
                    phi_1200_ = 0u;
                    phi_1202_ = type_50(type_32(vec4<f32>((f32(_e617) * _e150), (f32(_e623) * _e150), (f32(_e629) * _e150), 0f), vec4<f32>((f32(_e634) * _e150), (f32(_e638) * _e150), (f32(_e642) * _e150), 0f)), select(0u, 2147483648u, (_e99 == 0u)));
                    loop {
                        let _e652 = phi_4745_;
                        let _e654 = phi_1193_;
                        let _e656 = phi_1196_;
                        let _e658 = phi_1198_;
                        let _e660 = phi_1200_;
                        let _e662 = phi_1202_;
                        local_10 = _e654;
                        if _e658 {
                            phi_1213_ = true;
                        } else {
                            phi_1213_ = (_e660 > 0u);
                        }
                        let _e665 = phi_1213_;
                        if _e665 {
                            let _e666 = (_e656 > 0u);
                            if _e666 {
                                if _e658 {
                                    phi_1299_ = _e658;
                                    phi_1300_ = _e660;
                                    phi_1301_ = _e662;
                                } else {
                                    let _e667 = (_e660 - 1u);
                                    let _e668 = (_e667 % 128u);
                                    let _e669 = (_e668 < 128u);
                                    if _e669 {
                                    } else {
                                        phi_4951_ = true;
                                        break;
                                    }
                                    let _e671 = local_7[_e668];
                                    if _e669 {
                                    } else {
                                        phi_4951_ = true;
                                        break;
                                    }
                                    let _e673 = local_6[_e668];
                                    if _e669 {
                                    } else {
                                        phi_4951_ = true;
                                        break;
                                    }
                                    let _e675 = local_5[_e668];
                                    if _e669 {
                                    } else {
                                        phi_4951_ = true;
                                        break;
                                    }
                                    let _e677 = local_4[_e668];
                                    if _e669 {
                                    } else {
                                        phi_4951_ = true;
                                        break;
                                    }
                                    let _e679 = local_3[_e668];
                                    if _e669 {
                                    } else {
                                        phi_4951_ = true;
                                        break;
                                    }
                                    let _e681 = local_2[_e668];
                                    if _e669 {
                                    } else {
                                        phi_4951_ = true;
                                        break;
                                    }
                                    let _e686 = local_8[_e668];
                                    if _e669 {
                                    } else {
                                        phi_4951_ = true;
                                        break;
                                    }
                                    let _e689 = local_9[_e668];
                                    phi_1299_ = (_e689 <= _e654.member_1);
                                    phi_1300_ = _e667;
                                    phi_1301_ = type_50(type_32(vec4<f32>(_e671, _e673, _e675, 0f), vec4<f32>(_e677, _e679, _e681, 0f)), _e686);
                                }
                                let _e693 = phi_1299_;
                                let _e695 = phi_1300_;
                                let _e697 = phi_1301_;
                                if _e693 {
                                    let _e701 = ((_e697.member_1 & 2147483648u) != 0u);
                                    let _e702 = (_e697.member_1 & 268435455u);
                                    if _e701 {
                                        phi_1320_ = _e654;
                                        phi_1323_ = type_8(0u, ((_e697.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e709 = phi_1320_;
                                            let _e711 = phi_1323_;
                                            local_11 = _e709;
                                            if (_e711.member < _e711.member_1) {
                                                phi_1324_ = type_8((_e711.member + 1u), _e711.member_1);
                                                phi_1346_ = type_8(1u, _e711.member);
                                            } else {
                                                phi_1324_ = _e711;
                                                phi_1346_ = type_8(0u, type_8().member_1);
                                            }
                                            let _e724 = phi_1324_;
                                            let _e726 = phi_1346_;
                                            let _e730 = (bitcast<i32>(_e726.member) != 0i);
                                            if _e730 {
                                                let _e735 = (_e697.member.member_1.x - _e697.member.member.x);
                                                let _e738 = (_e697.member.member_1.y - _e697.member.member.y);
                                                let _e741 = (_e697.member.member_1.z - _e697.member.member.z);
                                                let _e743 = select(_e738, _e735, (_e735 > _e738));
                                                let _e745 = select(_e741, _e743, (_e743 > _e741));
                                                let _e747 = (_e745 < (1024f * _e150));
                                                if _e747 {
                                                    phi_1387_ = 0u;
                                                } else {
                                                    phi_1387_ = select(2u, 1u, (_e745 < (2097152f * _e150)));
                                                }
                                                let _e752 = phi_1387_;
                                                switch bitcast<i32>(_e752) {
                                                    case 0: {
                                                        phi_1393_ = 1u;
                                                        break;
                                                    }
                                                    case 1: {
                                                        phi_1393_ = 2u;
                                                        break;
                                                    }
                                                    case 2: {
                                                        phi_1393_ = 3u;
                                                        break;
                                                    }
                                                    default: {
                                                        phi_1393_ = u32();
                                                        break;
                                                    }
                                                }
                                                let _e755 = phi_1393_;
                                                switch bitcast<i32>(_e752) {
                                                    case 0: {
                                                        phi_1403_ = 1u;
                                                        break;
                                                    }
                                                    case 1: {
                                                        phi_1403_ = 2u;
                                                        break;
                                                    }
                                                    case 2: {
                                                        phi_1403_ = 3u;
                                                        break;
                                                    }
                                                    default: {
                                                        phi_1403_ = u32();
                                                        break;
                                                    }
                                                }
                                                let _e762 = phi_1403_;
                                                let _e764 = ((_e702 + (_e726.member_1 * ((3u * _e755) + 1u))) + (3u * _e762));
                                                let _e765 = (_e764 < _e102);
                                                if _e765 {
                                                    if _e765 {
                                                    } else {
                                                        phi_4739_ = true;
                                                        break;
                                                    }
                                                    let _e767 = global_5.member[_e764];
                                                    phi_1419_ = _e767;
                                                } else {
                                                    phi_1419_ = 4294967295u;
                                                }
                                                let _e769 = phi_1419_;
                                                if _e747 {
                                                    phi_1452_ = 0u;
                                                } else {
                                                    phi_1452_ = select(2u, 1u, (_e745 < (2097152f * _e150)));
                                                }
                                                let _e774 = phi_1452_;
                                                switch bitcast<i32>(_e774) {
                                                    case 0: {
                                                        phi_1458_ = 1u;
                                                        break;
                                                    }
                                                    case 1: {
                                                        phi_1458_ = 2u;
                                                        break;
                                                    }
                                                    case 2: {
                                                        phi_1458_ = 3u;
                                                        break;
                                                    }
                                                    default: {
                                                        phi_1458_ = u32();
                                                        break;
                                                    }
                                                }
                                                let _e777 = phi_1458_;
                                                let _e781 = (_e702 + (_e726.member_1 * ((3u * _e777) + 1u)));
                                                switch bitcast<i32>(_e774) {
                                                    case 0: {
                                                        let _e1056 = (_e781 < _e102);
                                                        if _e1056 {
                                                            if _e1056 {
                                                            } else {
                                                                phi_4739_ = true;
                                                                break;
                                                            }
                                                            let _e1058 = global_5.member[_e781];
                                                            phi_1485_ = _e1058;
                                                        } else {
                                                            phi_1485_ = 0u;
                                                        }
                                                        let _e1060 = phi_1485_;
                                                        let _e1062 = ((10u * _e270) & 31u);
                                                        let _e1072 = ((10u * _e269) & 31u);
                                                        let _e1082 = ((10u * _e271) & 31u);
                                                        let _e1092 = (_e781 + 1u);
                                                        let _e1093 = (_e1092 < _e102);
                                                        if _e1093 {
                                                            if _e1093 {
                                                            } else {
                                                                phi_4739_ = true;
                                                                break;
                                                            }
                                                            let _e1095 = global_5.member[_e1092];
                                                            phi_1534_ = _e1095;
                                                        } else {
                                                            phi_1534_ = 0u;
                                                        }
                                                        let _e1097 = phi_1534_;
                                                        let _e1123 = (_e781 + 2u);
                                                        let _e1124 = (_e1123 < _e102);
                                                        if _e1124 {
                                                            if _e1124 {
                                                            } else {
                                                                phi_4739_ = true;
                                                                break;
                                                            }
                                                            let _e1126 = global_5.member[_e1123];
                                                            phi_1583_ = _e1126;
                                                        } else {
                                                            phi_1583_ = 0u;
                                                        }
                                                        let _e1128 = phi_1583_;
                                                        phi_2084_ = array<array<f32, 3>, 3>(array<f32, 3>((_e697.member.member.x + ((bitcast<f32>((1258291200u | ((_e1060 >> bitcast<u32>(_e1062)) & 1023u))) - 8388608f) * _e150)), (_e697.member.member.y + ((bitcast<f32>((1258291200u | ((_e1060 >> bitcast<u32>(_e1072)) & 1023u))) - 8388608f) * _e150)), (_e697.member.member.z + ((bitcast<f32>((1258291200u | ((_e1060 >> bitcast<u32>(_e1082)) & 1023u))) - 8388608f) * _e150))), array<f32, 3>((_e697.member.member.x + ((bitcast<f32>((1258291200u | ((_e1097 >> bitcast<u32>(_e1062)) & 1023u))) - 8388608f) * _e150)), (_e697.member.member.y + ((bitcast<f32>((1258291200u | ((_e1097 >> bitcast<u32>(_e1072)) & 1023u))) - 8388608f) * _e150)), (_e697.member.member.z + ((bitcast<f32>((1258291200u | ((_e1097 >> bitcast<u32>(_e1082)) & 1023u))) - 8388608f) * _e150))), array<f32, 3>((_e697.member.member.x + ((bitcast<f32>((1258291200u | ((_e1128 >> bitcast<u32>(_e1062)) & 1023u))) - 8388608f) * _e150)), (_e697.member.member.y + ((bitcast<f32>((1258291200u | ((_e1128 >> bitcast<u32>(_e1072)) & 1023u))) - 8388608f) * _e150)), (_e697.member.member.z + ((bitcast<f32>((1258291200u | ((_e1128 >> bitcast<u32>(_e1082)) & 1023u))) - 8388608f) * _e150))));
                                                        break;
                                                    }
                                                    case 1: {
                                                        let _e870 = (_e781 < _e102);
                                                        if _e870 {
                                                            if _e870 {
                                                            } else {
                                                                phi_4739_ = true;
                                                                break;
                                                            }
                                                            let _e872 = global_5.member[_e781];
                                                            phi_1632_ = _e872;
                                                        } else {
                                                            phi_1632_ = 0u;
                                                        }
                                                        let _e874 = phi_1632_;
                                                        let _e875 = (_e781 + 1u);
                                                        let _e876 = (_e875 < _e102);
                                                        if _e876 {
                                                            if _e876 {
                                                            } else {
                                                                phi_4739_ = true;
                                                                break;
                                                            }
                                                            let _e878 = global_5.member[_e875];
                                                            phi_1647_ = _e878;
                                                        } else {
                                                            phi_1647_ = 0u;
                                                        }
                                                        let _e880 = phi_1647_;
                                                        let _e881 = (_e270 == 1u);
                                                        if _e881 {
                                                            phi_1657_ = ((_e874 >> bitcast<u32>(21i)) | (_e880 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1657_ = (_e880 >> bitcast<u32>(10i));
                                                        }
                                                        let _e890 = phi_1657_;
                                                        let _e898 = (_e269 == 1u);
                                                        if _e898 {
                                                            phi_1678_ = ((_e874 >> bitcast<u32>(21i)) | (_e880 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1678_ = (_e880 >> bitcast<u32>(10i));
                                                        }
                                                        let _e907 = phi_1678_;
                                                        let _e915 = (_e271 == 1u);
                                                        if _e915 {
                                                            phi_1699_ = ((_e874 >> bitcast<u32>(21i)) | (_e880 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1699_ = (_e880 >> bitcast<u32>(10i));
                                                        }
                                                        let _e924 = phi_1699_;
                                                        let _e933 = (_e781 + 2u);
                                                        let _e934 = (_e933 < _e102);
                                                        if _e934 {
                                                            if _e934 {
                                                            } else {
                                                                phi_4739_ = true;
                                                                break;
                                                            }
                                                            let _e936 = global_5.member[_e933];
                                                            phi_1729_ = _e936;
                                                        } else {
                                                            phi_1729_ = 0u;
                                                        }
                                                        let _e938 = phi_1729_;
                                                        let _e939 = (_e781 + 3u);
                                                        let _e940 = (_e939 < _e102);
                                                        if _e940 {
                                                            if _e940 {
                                                            } else {
                                                                phi_4739_ = true;
                                                                break;
                                                            }
                                                            let _e942 = global_5.member[_e939];
                                                            phi_1744_ = _e942;
                                                        } else {
                                                            phi_1744_ = 0u;
                                                        }
                                                        let _e944 = phi_1744_;
                                                        if _e881 {
                                                            phi_1754_ = ((_e938 >> bitcast<u32>(21i)) | (_e944 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1754_ = (_e944 >> bitcast<u32>(10i));
                                                        }
                                                        let _e953 = phi_1754_;
                                                        if _e898 {
                                                            phi_1775_ = ((_e938 >> bitcast<u32>(21i)) | (_e944 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1775_ = (_e944 >> bitcast<u32>(10i));
                                                        }
                                                        let _e969 = phi_1775_;
                                                        if _e915 {
                                                            phi_1796_ = ((_e938 >> bitcast<u32>(21i)) | (_e944 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1796_ = (_e944 >> bitcast<u32>(10i));
                                                        }
                                                        let _e985 = phi_1796_;
                                                        let _e994 = (_e781 + 4u);
                                                        let _e995 = (_e994 < _e102);
                                                        if _e995 {
                                                            if _e995 {
                                                            } else {
                                                                phi_4739_ = true;
                                                                break;
                                                            }
                                                            let _e997 = global_5.member[_e994];
                                                            phi_1826_ = _e997;
                                                        } else {
                                                            phi_1826_ = 0u;
                                                        }
                                                        let _e999 = phi_1826_;
                                                        let _e1000 = (_e781 + 5u);
                                                        let _e1001 = (_e1000 < _e102);
                                                        if _e1001 {
                                                            if _e1001 {
                                                            } else {
                                                                phi_4739_ = true;
                                                                break;
                                                            }
                                                            let _e1003 = global_5.member[_e1000];
                                                            phi_1841_ = _e1003;
                                                        } else {
                                                            phi_1841_ = 0u;
                                                        }
                                                        let _e1005 = phi_1841_;
                                                        if _e881 {
                                                            phi_1851_ = ((_e999 >> bitcast<u32>(21i)) | (_e1005 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1851_ = (_e1005 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1014 = phi_1851_;
                                                        if _e898 {
                                                            phi_1872_ = ((_e999 >> bitcast<u32>(21i)) | (_e1005 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1872_ = (_e1005 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1030 = phi_1872_;
                                                        if _e915 {
                                                            phi_1893_ = ((_e999 >> bitcast<u32>(21i)) | (_e1005 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1893_ = (_e1005 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1046 = phi_1893_;
                                                        phi_2084_ = array<array<f32, 3>, 3>(array<f32, 3>((_e697.member.member.x + ((bitcast<f32>((1258291200u | (select(_e890, _e874, _e309) & 2097151u))) - 8388608f) * _e150)), (_e697.member.member.y + ((bitcast<f32>((1258291200u | (select(_e907, _e874, _e376) & 2097151u))) - 8388608f) * _e150)), (_e697.member.member.z + ((bitcast<f32>((1258291200u | (select(_e924, _e874, _e442) & 2097151u))) - 8388608f) * _e150))), array<f32, 3>((_e697.member.member.x + ((bitcast<f32>((1258291200u | (select(_e953, _e938, _e309) & 2097151u))) - 8388608f) * _e150)), (_e697.member.member.y + ((bitcast<f32>((1258291200u | (select(_e969, _e938, _e376) & 2097151u))) - 8388608f) * _e150)), (_e697.member.member.z + ((bitcast<f32>((1258291200u | (select(_e985, _e938, _e442) & 2097151u))) - 8388608f) * _e150))), array<f32, 3>((_e697.member.member.x + ((bitcast<f32>((1258291200u | (select(_e1014, _e999, _e309) & 2097151u))) - 8388608f) * _e150)), (_e697.member.member.y + ((bitcast<f32>((1258291200u | (select(_e1030, _e999, _e376) & 2097151u))) - 8388608f) * _e150)), (_e697.member.member.z + ((bitcast<f32>((1258291200u | (select(_e1046, _e999, _e442) & 2097151u))) - 8388608f) * _e150))));
                                                        break;
                                                    }
                                                    case 2: {
                                                        let _e783 = (_e781 + _e270);
                                                        let _e784 = (_e783 < _e102);
                                                        if _e784 {
                                                            if _e784 {
                                                            } else {
                                                                phi_4739_ = true;
                                                                break;
                                                            }
                                                            let _e786 = global_5.member[_e783];
                                                            phi_1924_ = _e786;
                                                        } else {
                                                            phi_1924_ = 0u;
                                                        }
                                                        let _e788 = phi_1924_;
                                                        let _e792 = (_e781 + _e269);
                                                        let _e793 = (_e792 < _e102);
                                                        if _e793 {
                                                            if _e793 {
                                                            } else {
                                                                phi_4739_ = true;
                                                                break;
                                                            }
                                                            let _e795 = global_5.member[_e792];
                                                            phi_1942_ = _e795;
                                                        } else {
                                                            phi_1942_ = 0u;
                                                        }
                                                        let _e797 = phi_1942_;
                                                        let _e801 = (_e781 + _e271);
                                                        let _e802 = (_e801 < _e102);
                                                        if _e802 {
                                                            if _e802 {
                                                            } else {
                                                                phi_4739_ = true;
                                                                break;
                                                            }
                                                            let _e804 = global_5.member[_e801];
                                                            phi_1960_ = _e804;
                                                        } else {
                                                            phi_1960_ = 0u;
                                                        }
                                                        let _e806 = phi_1960_;
                                                        let _e811 = (_e781 + 3u);
                                                        let _e812 = (_e811 + _e270);
                                                        let _e813 = (_e812 < _e102);
                                                        if _e813 {
                                                            if _e813 {
                                                            } else {
                                                                phi_4739_ = true;
                                                                break;
                                                            }
                                                            let _e815 = global_5.member[_e812];
                                                            phi_1983_ = _e815;
                                                        } else {
                                                            phi_1983_ = 0u;
                                                        }
                                                        let _e817 = phi_1983_;
                                                        let _e821 = (_e811 + _e269);
                                                        let _e822 = (_e821 < _e102);
                                                        if _e822 {
                                                            if _e822 {
                                                            } else {
                                                                phi_4739_ = true;
                                                                break;
                                                            }
                                                            let _e824 = global_5.member[_e821];
                                                            phi_2001_ = _e824;
                                                        } else {
                                                            phi_2001_ = 0u;
                                                        }
                                                        let _e826 = phi_2001_;
                                                        let _e830 = (_e811 + _e271);
                                                        let _e831 = (_e830 < _e102);
                                                        if _e831 {
                                                            if _e831 {
                                                            } else {
                                                                phi_4739_ = true;
                                                                break;
                                                            }
                                                            let _e833 = global_5.member[_e830];
                                                            phi_2019_ = _e833;
                                                        } else {
                                                            phi_2019_ = 0u;
                                                        }
                                                        let _e835 = phi_2019_;
                                                        let _e840 = (_e781 + 6u);
                                                        let _e841 = (_e840 + _e270);
                                                        let _e842 = (_e841 < _e102);
                                                        if _e842 {
                                                            if _e842 {
                                                            } else {
                                                                phi_4739_ = true;
                                                                break;
                                                            }
                                                            let _e844 = global_5.member[_e841];
                                                            phi_2042_ = _e844;
                                                        } else {
                                                            phi_2042_ = 0u;
                                                        }
                                                        let _e846 = phi_2042_;
                                                        let _e850 = (_e840 + _e269);
                                                        let _e851 = (_e850 < _e102);
                                                        if _e851 {
                                                            if _e851 {
                                                            } else {
                                                                phi_4739_ = true;
                                                                break;
                                                            }
                                                            let _e853 = global_5.member[_e850];
                                                            phi_2060_ = _e853;
                                                        } else {
                                                            phi_2060_ = 0u;
                                                        }
                                                        let _e855 = phi_2060_;
                                                        let _e859 = (_e840 + _e271);
                                                        let _e860 = (_e859 < _e102);
                                                        if _e860 {
                                                            if _e860 {
                                                            } else {
                                                                phi_4739_ = true;
                                                                break;
                                                            }
                                                            let _e862 = global_5.member[_e859];
                                                            phi_2078_ = _e862;
                                                        } else {
                                                            phi_2078_ = 0u;
                                                        }
                                                        let _e864 = phi_2078_;
                                                        phi_2084_ = array<array<f32, 3>, 3>(array<f32, 3>((f32(bitcast<i32>(_e788)) * _e150), (f32(bitcast<i32>(_e797)) * _e150), (f32(bitcast<i32>(_e806)) * _e150)), array<f32, 3>((f32(bitcast<i32>(_e817)) * _e150), (f32(bitcast<i32>(_e826)) * _e150), (f32(bitcast<i32>(_e835)) * _e150)), array<f32, 3>((f32(bitcast<i32>(_e846)) * _e150), (f32(bitcast<i32>(_e855)) * _e150), (f32(bitcast<i32>(_e864)) * _e150)));
                                                        break;
                                                    }
                                                    default: {
                                                        phi_2084_ = array<array<f32, 3>, 3>();
                                                        break;
                                                    }
                                                }
                                                let _e1156 = phi_2084_;
                                                let _e1172 = (_e1156[0][2] - _e467);
                                                let _e1175 = (((_e1156[0][0] - _e334) * _e503) - (_e1172 * _e371));
                                                let _e1178 = (((_e1156[0][1] - _e401) * _e503) - (_e1172 * _e437));
                                                let _e1181 = (_e1156[1][2] - _e467);
                                                let _e1184 = (((_e1156[1][0] - _e334) * _e503) - (_e1181 * _e371));
                                                let _e1187 = (((_e1156[1][1] - _e401) * _e503) - (_e1181 * _e437));
                                                let _e1190 = (_e1156[2][2] - _e467);
                                                let _e1193 = (((_e1156[2][0] - _e334) * _e503) - (_e1190 * _e371));
                                                let _e1196 = (((_e1156[2][1] - _e401) * _e503) - (_e1190 * _e437));
                                                let _e1197 = (_e1193 * _e1187);
                                                let _e1198 = (_e1196 * _e1184);
                                                let _e1199 = (_e1175 * _e1196);
                                                let _e1200 = (_e1178 * _e1193);
                                                let _e1201 = (_e1184 * _e1178);
                                                let _e1202 = (_e1187 * _e1175);
                                                let _e1207 = (((_e1197 >= _e1198) && (_e1199 >= _e1200)) && (_e1201 >= _e1202));
                                                let _e1213 = (_e1207 || (((_e1197 <= _e1198) && (_e1199 <= _e1200)) && (_e1201 <= _e1202)));
                                                if _e1213 {
                                                    let _e1215 = select(-1f, 1f, _e1207);
                                                    let _e1217 = ((_e1197 - _e1198) * _e1215);
                                                    let _e1219 = select(0f, _e1217, (_e1217 > 0f));
                                                    let _e1221 = ((_e1199 - _e1200) * _e1215);
                                                    let _e1223 = select(0f, _e1221, (_e1221 > 0f));
                                                    let _e1225 = ((_e1201 - _e1202) * _e1215);
                                                    let _e1227 = select(0f, _e1225, (_e1225 > 0f));
                                                    let _e1229 = ((_e1219 + _e1223) + _e1227);
                                                    let _e1231 = select(_e1156[1][0], _e1156[0][0], (_e1156[0][0] < _e1156[1][0]));
                                                    let _e1235 = select(_e1156[1][0], _e1156[0][0], (_e1156[0][0] > _e1156[1][0]));
                                                    let _e1239 = select(_e1156[1][1], _e1156[0][1], (_e1156[0][1] < _e1156[1][1]));
                                                    let _e1243 = select(_e1156[1][1], _e1156[0][1], (_e1156[0][1] > _e1156[1][1]));
                                                    let _e1247 = select(_e1156[1][2], _e1156[0][2], (_e1156[0][2] < _e1156[1][2]));
                                                    let _e1251 = select(_e1156[1][2], _e1156[0][2], (_e1156[0][2] > _e1156[1][2]));
                                                    let _e1256 = ((select(_e1156[2][0], _e1231, (_e1231 < _e1156[2][0])) - _e372) * _e375);
                                                    let _e1257 = ((select(_e1156[2][0], _e1235, (_e1235 > _e1156[2][0])) - _e373) * _e375);
                                                    let _e1260 = ((select(_e1156[2][1], _e1239, (_e1239 < _e1156[2][1])) - _e438) * _e441);
                                                    let _e1261 = ((select(_e1156[2][1], _e1243, (_e1243 > _e1156[2][1])) - _e439) * _e441);
                                                    let _e1264 = ((select(_e1156[2][2], _e1247, (_e1247 < _e1156[2][2])) - _e504) * _e507);
                                                    let _e1265 = ((select(_e1156[2][2], _e1251, (_e1251 > _e1156[2][2])) - _e505) * _e507);
                                                    let _e1267 = select(_e1265, _e1264, (_e1264 < _e1265));
                                                    let _e1269 = select(_e1265, _e1264, (_e1264 > _e1265));
                                                    let _e1271 = select(_e1257, _e1256, (_e1256 < _e1257));
                                                    let _e1273 = select(_e1261, _e1260, (_e1260 < _e1261));
                                                    let _e1275 = select(_e1273, _e1271, (_e1271 > _e1273));
                                                    let _e1277 = select(_e1267, _e1275, (_e1275 > _e1267));
                                                    let _e1279 = select(_e1257, _e1256, (_e1256 > _e1257));
                                                    let _e1281 = select(_e1261, _e1260, (_e1260 > _e1261));
                                                    let _e1283 = select(_e1281, _e1279, (_e1279 < _e1281));
                                                    let _e1285 = select(_e1269, _e1283, (_e1283 < _e1269));
                                                    let _e1286 = -(_e1267);
                                                    let _e1292 = select(_e610, _e1277, (_e1277 > _e610));
                                                    let _e1296 = select(_e1184, _e1175, (_e1175 < _e1184));
                                                    let _e1301 = select(_e1184, _e1175, (_e1175 > _e1184));
                                                    let _e1308 = select(_e1187, _e1178, (_e1178 < _e1187));
                                                    let _e1313 = select(_e1187, _e1178, (_e1178 > _e1187));
                                                    let _e1322 = (((((_e1213 && (_e1229 >= 0.000000000000000000000000000000000000011754944f)) && ((select(_e1193, _e1296, (_e1296 < _e1193)) <= 0f) && (select(_e1193, _e1301, (_e1301 > _e1193)) >= 0f))) && ((select(_e1196, _e1308, (_e1308 < _e1196)) <= 0f) && (select(_e1196, _e1313, (_e1313 > _e1196)) >= 0f))) && (_e1292 <= (_e1285 + (select(_e1286, _e1269, (_e1269 > _e1286)) * 0.0000019073523f)))) && (_e1292 <= _e709.member_1));
                                                    if _e1322 {
                                                        let _e1327 = (_e1156[1][0] - _e1156[0][0]);
                                                        let _e1328 = (_e1156[1][1] - _e1156[0][1]);
                                                        let _e1329 = (_e1156[1][2] - _e1156[0][2]);
                                                        let _e1330 = vec3<f32>(_e1327, _e1328, _e1329);
                                                        let _e1331 = (_e1156[2][0] - _e1156[1][0]);
                                                        let _e1332 = (_e1156[2][1] - _e1156[1][1]);
                                                        let _e1333 = (_e1156[2][2] - _e1156[1][2]);
                                                        let _e1334 = vec3<f32>(_e1331, _e1332, _e1333);
                                                        let _e1335 = (_e1156[0][0] - _e1156[2][0]);
                                                        let _e1336 = (_e1156[0][1] - _e1156[2][1]);
                                                        let _e1337 = (_e1156[0][2] - _e1156[2][2]);
                                                        let _e1338 = vec3<f32>(_e1335, _e1336, _e1337);
                                                        let _e1339 = abs(_e1327);
                                                        let _e1340 = abs(_e1328);
                                                        if (_e1339 != _e1339) {
                                                            phi_4306_ = true;
                                                        } else {
                                                            phi_4306_ = (_e1340 >= _e1339);
                                                        }
                                                        let _e1344 = phi_4306_;
                                                        let _e1345 = select(_e1339, _e1340, _e1344);
                                                        let _e1346 = abs(_e1329);
                                                        if (_e1345 != _e1345) {
                                                            phi_4321_ = true;
                                                        } else {
                                                            phi_4321_ = (_e1346 >= _e1345);
                                                        }
                                                        let _e1350 = phi_4321_;
                                                        let _e1351 = select(_e1345, _e1346, _e1350);
                                                        let _e1352 = abs(_e1331);
                                                        let _e1353 = abs(_e1332);
                                                        if (_e1352 != _e1352) {
                                                            phi_4336_ = true;
                                                        } else {
                                                            phi_4336_ = (_e1353 >= _e1352);
                                                        }
                                                        let _e1357 = phi_4336_;
                                                        let _e1358 = select(_e1352, _e1353, _e1357);
                                                        let _e1359 = abs(_e1333);
                                                        if (_e1358 != _e1358) {
                                                            phi_4351_ = true;
                                                        } else {
                                                            phi_4351_ = (_e1359 >= _e1358);
                                                        }
                                                        let _e1363 = phi_4351_;
                                                        let _e1364 = select(_e1358, _e1359, _e1363);
                                                        let _e1365 = abs(_e1335);
                                                        let _e1366 = abs(_e1336);
                                                        if (_e1365 != _e1365) {
                                                            phi_4366_ = true;
                                                        } else {
                                                            phi_4366_ = (_e1366 >= _e1365);
                                                        }
                                                        let _e1370 = phi_4366_;
                                                        let _e1371 = select(_e1365, _e1366, _e1370);
                                                        let _e1372 = abs(_e1337);
                                                        if (_e1371 != _e1371) {
                                                            phi_4381_ = true;
                                                        } else {
                                                            phi_4381_ = (_e1372 >= _e1371);
                                                        }
                                                        let _e1376 = phi_4381_;
                                                        let _e1377 = select(_e1371, _e1372, _e1376);
                                                        let _e1379 = select(_e1364, _e1351, (_e1351 > _e1364));
                                                        let _e1381 = select(_e1377, _e1379, (_e1379 > _e1377));
                                                        if (_e1351 == _e1381) {
                                                            phi_2626_ = _e1187;
                                                            phi_2627_ = _e1184;
                                                            phi_2628_ = _e1178;
                                                            phi_2629_ = _e1175;
                                                            phi_2630_ = vec3<f32>(_e1156[0][0], _e1156[0][1], _e1156[0][2]);
                                                            phi_2631_ = _e1338;
                                                            phi_2632_ = _e1334;
                                                            phi_2633_ = _e1330;
                                                        } else {
                                                            let _e1383 = (_e1364 == _e1381);
                                                            let _e1388 = vec3(_e1383);
                                                            phi_2626_ = select(_e1178, _e1196, _e1383);
                                                            phi_2627_ = select(_e1175, _e1193, _e1383);
                                                            phi_2628_ = select(_e1196, _e1187, _e1383);
                                                            phi_2629_ = select(_e1193, _e1184, _e1383);
                                                            phi_2630_ = select(vec3<f32>(_e1156[2][0], _e1156[2][1], _e1156[2][2]), vec3<f32>(_e1156[1][0], _e1156[1][1], _e1156[1][2]), _e1388);
                                                            phi_2631_ = select(_e1334, _e1330, _e1388);
                                                            phi_2632_ = select(_e1330, _e1338, _e1388);
                                                            phi_2633_ = select(_e1338, _e1334, _e1388);
                                                        }
                                                        let _e1394 = phi_2626_;
                                                        let _e1396 = phi_2627_;
                                                        let _e1398 = phi_2628_;
                                                        let _e1400 = phi_2629_;
                                                        let _e1402 = phi_2630_;
                                                        let _e1404 = phi_2631_;
                                                        let _e1406 = phi_2632_;
                                                        let _e1408 = phi_2633_;
                                                        let _e1415 = ((_e1406.y * _e1404.z) - (_e1404.y * _e1406.z));
                                                        let _e1420 = ((_e1406.z * _e1404.x) - (_e1404.z * _e1406.x));
                                                        let _e1423 = ((_e1406.x * _e1404.y) - (_e1404.x * _e1406.y));
                                                        let _e1426 = ((_e1219 >= _e1223) && (_e1219 >= _e1227));
                                                        let _e1427 = (_e1223 >= _e1227);
                                                        let _e1441 = (((_e1415 * (select(select(_e1156[2][0], _e1156[1][0], _e1427), _e1156[0][0], _e1426) - _e334)) + (_e1420 * (select(select(_e1156[2][1], _e1156[1][1], _e1427), _e1156[0][1], _e1426) - _e401))) + (_e1423 * (select(select(_e1156[2][2], _e1156[1][2], _e1427), _e1156[0][2], _e1426) - _e467)));
                                                        let _e1446 = (((_e1415 * _e371) + (_e1420 * _e437)) + (_e1423 * _e503));
                                                        let _e1447 = (_e1396 - _e1400);
                                                        let _e1448 = (_e1394 - _e1398);
                                                        let _e1451 = ((_e1447 * _e1447) + (_e1448 * _e1448));
                                                        let _e1458 = (-(((_e1400 * _e1447) + (_e1398 * _e1448))) / select(0.000000000000000000000000000000000000011754944f, _e1451, (_e1451 > 0.000000000000000000000000000000000000011754944f)));
                                                        let _e1460 = select(1f, _e1458, (_e1458 < 1f));
                                                        let _e1462 = select(0f, _e1460, (_e1460 > 0f));
                                                        let _e1471 = ((_e1402.x + (_e1408.x * _e1462)) - _e334);
                                                        let _e1474 = ((_e1402.y + (_e1408.y * _e1462)) - _e401);
                                                        let _e1477 = ((_e1402.z + (_e1408.z * _e1462)) - _e467);
                                                        let _e1480 = bitcast<f32>((bitcast<u32>(_e1471) & 2147483647u));
                                                        let _e1483 = bitcast<f32>((bitcast<u32>(_e1474) & 2147483647u));
                                                        let _e1485 = select(_e1483, _e1480, (_e1480 > _e1483));
                                                        let _e1488 = bitcast<f32>((bitcast<u32>(_e1477) & 2147483647u));
                                                        let _e1490 = select(_e1488, _e1485, (_e1485 > _e1488));
                                                        let _e1494 = abs(_e1415);
                                                        let _e1495 = abs(_e1420);
                                                        if (_e1494 != _e1494) {
                                                            phi_4396_ = true;
                                                        } else {
                                                            phi_4396_ = (_e1495 >= _e1494);
                                                        }
                                                        let _e1499 = phi_4396_;
                                                        let _e1500 = select(_e1494, _e1495, _e1499);
                                                        let _e1501 = abs(_e1423);
                                                        if (_e1500 != _e1500) {
                                                            phi_4411_ = true;
                                                        } else {
                                                            phi_4411_ = (_e1501 >= _e1500);
                                                        }
                                                        let _e1505 = phi_4411_;
                                                        let _e1521 = abs(_e1406.x);
                                                        let _e1522 = abs(_e1406.y);
                                                        if (_e1521 != _e1521) {
                                                            phi_4426_ = true;
                                                        } else {
                                                            phi_4426_ = (_e1522 >= _e1521);
                                                        }
                                                        let _e1526 = phi_4426_;
                                                        let _e1527 = select(_e1521, _e1522, _e1526);
                                                        let _e1528 = abs(_e1406.z);
                                                        if (_e1527 != _e1527) {
                                                            phi_4441_ = true;
                                                        } else {
                                                            phi_4441_ = (_e1528 >= _e1527);
                                                        }
                                                        let _e1532 = phi_4441_;
                                                        let _e1535 = abs(_e1404.x);
                                                        let _e1536 = abs(_e1404.y);
                                                        if (_e1535 != _e1535) {
                                                            phi_4456_ = true;
                                                        } else {
                                                            phi_4456_ = (_e1536 >= _e1535);
                                                        }
                                                        let _e1540 = phi_4456_;
                                                        let _e1541 = select(_e1535, _e1536, _e1540);
                                                        let _e1542 = abs(_e1404.z);
                                                        if (_e1541 != _e1541) {
                                                            phi_4471_ = true;
                                                        } else {
                                                            phi_4471_ = (_e1542 >= _e1541);
                                                        }
                                                        let _e1546 = phi_4471_;
                                                        let _e1551 = ((bitcast<f32>((bitcast<u32>(((((_e1415 * _e1471) + (_e1420 * _e1474)) + (_e1423 * _e1477)) - _e1441)) & 2147483647u)) <= ((0.0000009536743f * select(_e1381, _e1490, (_e1490 > _e1381))) * select(_e1500, _e1501, _e1505))) && !((bitcast<f32>((bitcast<u32>(_e1446) & 2147483647u)) <= ((0.0000038146973f * select(_e1527, _e1528, _e1532)) * select(_e1541, _e1542, _e1546)))));
                                                        let _e1552 = (_e1441 / _e1446);
                                                        if (_e1322 && !(_e1551)) {
                                                            let _e1555 = (_e1477 / _e503);
                                                            let _e1563 = (((_e1415 * (_e1471 - (_e371 * _e1555))) + (_e1420 * (_e1474 - (_e437 * _e1555)))) / _e1446);
                                                            phi_2841_ = select(select(_e1555, (_e1555 + _e1563), (bitcast<f32>((bitcast<u32>(_e1563) & 2147483647u)) <= _e1381)), _e1552, _e1551);
                                                        } else {
                                                            phi_2841_ = _e1552;
                                                        }
                                                        let _e1572 = phi_2841_;
                                                        let _e1574 = select(_e1285, _e1572, (_e1572 < _e1285));
                                                        let _e1576 = select(_e1277, _e1574, (_e1574 > _e1277));
                                                        let _e1577 = (1f / _e1229);
                                                        phi_2861_ = type_40(_e1576, (_e1223 * _e1577), (_e1227 * _e1577), ((_e1322 && (_e1576 >= _e610)) && (_e1576 <= _e709.member_1)));
                                                        phi_2862_ = type_40();
                                                    } else {
                                                        phi_2861_ = type_40();
                                                        phi_2862_ = type_40(0f, 0f, 0f, _e1322);
                                                    }
                                                    let _e1586 = phi_2861_;
                                                    let _e1588 = phi_2862_;
                                                    phi_2865_ = _e1586;
                                                    phi_2866_ = _e1588;
                                                    phi_2867_ = select(true, false, _e1322);
                                                } else {
                                                    phi_2865_ = type_40();
                                                    phi_2866_ = type_40(0f, 0f, 0f, _e1213);
                                                    phi_2867_ = true;
                                                }
                                                let _e1591 = phi_2865_;
                                                let _e1593 = phi_2866_;
                                                let _e1595 = phi_2867_;
                                                if _e1595 {
                                                    phi_2871_ = _e1593;
                                                } else {
                                                    phi_2871_ = _e1591;
                                                }
                                                let _e1597 = phi_2871_;
                                                if _e1597.member_3 {
                                                    phi_2880_ = type_24(_e1597.member, _e1597.member_1, _e1597.member_2, _e769);
                                                } else {
                                                    phi_2880_ = type_24(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                }
                                                let _e1604 = phi_2880_;
                                                if (_e1604.member_3 != 4294967295u) {
                                                    if (_e769 != 4294967295u) {
                                                        if (_e1604.member < _e709.member.member) {
                                                            phi_2906_ = true;
                                                        } else {
                                                            if (_e1604.member == _e709.member.member) {
                                                                phi_2905_ = (_e1604.member_3 < _e709.member.member_3);
                                                            } else {
                                                                phi_2905_ = false;
                                                            }
                                                            let _e1617 = phi_2905_;
                                                            phi_2906_ = _e1617;
                                                        }
                                                        let _e1619 = phi_2906_;
                                                        if _e1619 {
                                                            phi_2912_ = type_37(_e1604, _e1604.member);
                                                        } else {
                                                            phi_2912_ = _e709;
                                                        }
                                                        let _e1622 = phi_2912_;
                                                        phi_2913_ = _e1622;
                                                    } else {
                                                        phi_2913_ = _e709;
                                                    }
                                                    let _e1624 = phi_2913_;
                                                    phi_2914_ = _e1624;
                                                } else {
                                                    phi_2914_ = _e709;
                                                }
                                                let _e1626 = phi_2914_;
                                                phi_1321_ = _e1626;
                                            } else {
                                                phi_1321_ = type_37();
                                            }
                                            let _e1628 = phi_1321_;
                                            continue;
                                            continuing {
                                                phi_1320_ = _e1628;
                                                phi_1323_ = _e724;
                                                phi_4739_ = _e652;
                                                break if !(_e730);
                                            }
                                        }
                                        let _e1631 = phi_4739_;
                                        phi_4951_ = _e1631;
                                        if _e1631 {
                                            break;
                                        }
                                        phi_5042_ = _e1631;
                                        let _e2387 = local_11;
                                        phi_2915_ = _e2387;
                                    } else {
                                        phi_5042_ = _e652;
                                        phi_2915_ = _e654;
                                    }
                                    let _e1633 = phi_5042_;
                                    let _e1635 = phi_2915_;
                                    if _e701 {
                                        phi_4180_ = bool();
                                        phi_4181_ = u32();
                                        phi_4182_ = type_50();
                                    } else {
                                        if (_e697.member_1 >= _e99) {
                                            phi_3716_ = type_51(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), type_50(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u), type_50(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u));
                                        } else {
                                            if (_e697.member_1 < _e99) {
                                            } else {
                                                phi_4951_ = true;
                                                break;
                                            }
                                            let _e1639 = ((1u + _e270) % 4u);
                                            if (_e1639 < 4u) {
                                            } else {
                                                phi_4951_ = true;
                                                break;
                                            }
                                            let _e1644 = global_3.member[_e697.member_1][_e1639];
                                            let _e1646 = (_e1644 >> bitcast<u32>(11u));
                                            let _e1648 = ((1u + _e269) % 4u);
                                            if (_e1648 < 4u) {
                                            } else {
                                                phi_4951_ = true;
                                                break;
                                            }
                                            let _e1653 = global_3.member[_e697.member_1][_e1648];
                                            let _e1655 = (_e1653 >> bitcast<u32>(11u));
                                            let _e1657 = ((1u + _e271) % 4u);
                                            if (_e1657 < 4u) {
                                            } else {
                                                phi_4951_ = true;
                                                break;
                                            }
                                            let _e1662 = global_3.member[_e697.member_1][_e1657];
                                            let _e1664 = (_e1662 >> bitcast<u32>(11u));
                                            let _e1687 = (bitcast<f32>((bitcast<u32>((_e697.member.member_1.x - _e697.member.member.x)) & 2139095040u)) * 0.001953125f);
                                            let _e1688 = (bitcast<f32>((bitcast<u32>((_e697.member.member_1.y - _e697.member.member.y)) & 2139095040u)) * 0.001953125f);
                                            let _e1689 = (bitcast<f32>((bitcast<u32>((_e697.member.member_1.z - _e697.member.member.z)) & 2139095040u)) * 0.001953125f);
                                            let _e1691 = select(_e150, _e1687, (_e1687 > _e150));
                                            let _e1693 = select(_e150, _e1688, (_e1688 > _e150));
                                            let _e1695 = select(_e150, _e1689, (_e1689 > _e150));
                                            let _e1726 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1644 & 1023u))) - 8388608f) * _e1691));
                                            let _e1731 = (bitcast<i32>((_e1644 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e1734 = bitcast<f32>((_e1726 & bitcast<u32>(_e1731)));
                                            let _e1735 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1653 & 1023u))) - 8388608f) * _e1693));
                                            let _e1740 = (bitcast<i32>((_e1653 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e1743 = bitcast<f32>((_e1735 & bitcast<u32>(_e1740)));
                                            let _e1744 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1662 & 1023u))) - 8388608f) * _e1695));
                                            let _e1749 = (bitcast<i32>((_e1662 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e1752 = bitcast<f32>((_e1744 & bitcast<u32>(_e1749)));
                                            let _e1756 = bitcast<f32>((_e1726 & bitcast<u32>(~(_e1731))));
                                            let _e1760 = bitcast<f32>((_e1735 & bitcast<u32>(~(_e1740))));
                                            let _e1764 = bitcast<f32>((_e1744 & bitcast<u32>(~(_e1749))));
                                            let _e1765 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1646 & 1023u))) - 8388608f) * _e1691));
                                            let _e1770 = (bitcast<i32>((_e1646 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e1773 = bitcast<f32>((_e1765 & bitcast<u32>(_e1770)));
                                            let _e1774 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1655 & 1023u))) - 8388608f) * _e1693));
                                            let _e1779 = (bitcast<i32>((_e1655 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e1782 = bitcast<f32>((_e1774 & bitcast<u32>(_e1779)));
                                            let _e1783 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1664 & 1023u))) - 8388608f) * _e1695));
                                            let _e1788 = (bitcast<i32>((_e1664 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e1791 = bitcast<f32>((_e1783 & bitcast<u32>(_e1788)));
                                            let _e1795 = bitcast<f32>((_e1765 & bitcast<u32>(~(_e1770))));
                                            let _e1799 = bitcast<f32>((_e1774 & bitcast<u32>(~(_e1779))));
                                            let _e1803 = bitcast<f32>((_e1783 & bitcast<u32>(~(_e1788))));
                                            let _e1804 = (_e697.member.member.x + _e1734);
                                            let _e1805 = (_e697.member.member.y + _e1743);
                                            let _e1806 = (_e697.member.member.z + _e1752);
                                            let _e1809 = (_e697.member.member_1.x - _e1773);
                                            let _e1810 = (_e697.member.member_1.y - _e1782);
                                            let _e1811 = (_e697.member.member_1.z - _e1791);
                                            let _e1830 = (_e1809 - _e1804);
                                            let _e1831 = (_e1810 - _e1805);
                                            let _e1832 = (_e1811 - _e1806);
                                            let _e1834 = select(_e1831, _e1830, (_e1830 > _e1831));
                                            let _e1836 = select(_e1832, _e1834, (_e1834 > _e1832));
                                            if (_e1836 < (1024f * _e150)) {
                                                phi_3417_ = 0u;
                                            } else {
                                                phi_3417_ = select(2u, 1u, (_e1836 < (2097152f * _e150)));
                                            }
                                            let _e1843 = phi_3417_;
                                            switch bitcast<i32>(_e1843) {
                                                case 0: {
                                                    phi_3423_ = 1u;
                                                    break;
                                                }
                                                case 1: {
                                                    phi_3423_ = 2u;
                                                    break;
                                                }
                                                case 2: {
                                                    phi_3423_ = 3u;
                                                    break;
                                                }
                                                default: {
                                                    phi_3423_ = u32();
                                                    break;
                                                }
                                            }
                                            let _e1846 = phi_3423_;
                                            let _e1852 = global_3.member[_e697.member_1][0u];
                                            let _e1856 = global_3.member[_e697.member_1][1u];
                                            let _e1860 = global_3.member[_e697.member_1][2u];
                                            let _e1864 = global_3.member[_e697.member_1][3u];
                                            let _e1876 = (((_e1856 >> bitcast<u32>(22i)) | ((_e1860 >> bitcast<u32>(22i)) << bitcast<u32>(10i))) | ((_e1864 >> bitcast<u32>(22i)) << bitcast<u32>(20i)));
                                            let _e1877 = (_e1852 & 268435455u);
                                            let _e1878 = (_e1876 & 268435455u);
                                            let _e1881 = ((_e1852 >> bitcast<u32>(28u)) & 7u);
                                            let _e1889 = ((_e1852 >> bitcast<u32>(31i)) | (((_e1876 >> bitcast<u32>(28u)) & 3u) << bitcast<u32>(1i)));
                                            let _e1890 = (_e1881 != 0u);
                                            if (_e1881 == 0u) {
                                                phi_3678_ = _e1877;
                                            } else {
                                                if (_e1881 == 7u) {
                                                    phi_3677_ = 2147483648u;
                                                } else {
                                                    phi_3677_ = ((2147483648u | (_e1881 << bitcast<u32>(28u))) | (_e1878 & 268435455u));
                                                }
                                                let _e1899 = phi_3677_;
                                                phi_3678_ = _e1899;
                                            }
                                            let _e1901 = phi_3678_;
                                            if _e1890 {
                                                let _e1902 = (_e1881 != 7u);
                                                if _e1902 {
                                                    phi_3688_ = (_e1878 + (_e1881 * ((3u * _e1846) + 1u)));
                                                } else {
                                                    phi_3688_ = u32();
                                                }
                                                let _e1906 = phi_3688_;
                                                phi_3690_ = _e1906;
                                                phi_3691_ = select(true, false, _e1902);
                                            } else {
                                                phi_3690_ = u32();
                                                phi_3691_ = true;
                                            }
                                            let _e1909 = phi_3690_;
                                            let _e1911 = phi_3691_;
                                            if (_e1889 == 0u) {
                                                phi_3712_ = (_e1877 + select(0u, 1u, !(_e1890)));
                                            } else {
                                                if (_e1889 == 7u) {
                                                    phi_3711_ = 2147483648u;
                                                } else {
                                                    phi_3711_ = ((2147483648u | (_e1889 << bitcast<u32>(28u))) | (select(_e1909, _e1878, _e1911) & 268435455u));
                                                }
                                                let _e1924 = phi_3711_;
                                                phi_3712_ = _e1924;
                                            }
                                            let _e1926 = phi_3712_;
                                            phi_3716_ = type_51(array<vec4<f32>, 3>(vec4<f32>(_e1804, (_e697.member.member.x + _e1756), _e1809, (_e697.member.member_1.x - _e1795)), vec4<f32>(_e1805, (_e697.member.member.y + _e1760), _e1810, (_e697.member.member_1.y - _e1799)), vec4<f32>(_e1806, (_e697.member.member.z + _e1764), _e1811, (_e697.member.member_1.z - _e1803))), type_50(type_32((_e697.member.member + vec4<f32>(_e1734, _e1743, _e1752, 0f)), (_e697.member.member_1 - vec4<f32>(_e1773, _e1782, _e1791, 0f))), _e1901), type_50(type_32((_e697.member.member + vec4<f32>(_e1756, _e1760, _e1764, 0f)), (_e697.member.member_1 - vec4<f32>(_e1795, _e1799, _e1803, 0f))), _e1926));
                                        }
                                        let _e1931 = phi_3716_;
                                        let _e1943 = ((_e1931.member[0].x - _e372) * _e375);
                                        let _e1944 = ((_e1931.member[0].y - _e372) * _e375);
                                        let _e1945 = ((_e1931.member[0].z - _e373) * _e375);
                                        let _e1946 = ((_e1931.member[0].w - _e373) * _e375);
                                        let _e1956 = ((_e1931.member[1].x - _e438) * _e441);
                                        let _e1957 = ((_e1931.member[1].y - _e438) * _e441);
                                        let _e1958 = ((_e1931.member[1].z - _e439) * _e441);
                                        let _e1959 = ((_e1931.member[1].w - _e439) * _e441);
                                        let _e1969 = ((_e1931.member[2].x - _e504) * _e507);
                                        let _e1970 = ((_e1931.member[2].y - _e504) * _e507);
                                        let _e1971 = ((_e1931.member[2].z - _e505) * _e507);
                                        let _e1972 = ((_e1931.member[2].w - _e505) * _e507);
                                        let _e1974 = select(_e1971, _e1969, (_e1969 < _e1971));
                                        let _e1976 = select(_e1972, _e1970, (_e1970 < _e1972));
                                        let _e1978 = select(_e1971, _e1969, (_e1969 > _e1971));
                                        let _e1980 = select(_e1972, _e1970, (_e1970 > _e1972));
                                        let _e1982 = select(_e1945, _e1943, (_e1943 < _e1945));
                                        let _e1984 = select(_e1946, _e1944, (_e1944 < _e1946));
                                        let _e1986 = select(_e1958, _e1956, (_e1956 < _e1958));
                                        let _e1988 = select(_e1959, _e1957, (_e1957 < _e1959));
                                        let _e1990 = select(_e1986, _e1982, (_e1982 > _e1986));
                                        let _e1992 = select(_e1988, _e1984, (_e1984 > _e1988));
                                        let _e1994 = select(_e1974, _e1990, (_e1990 > _e1974));
                                        let _e1996 = select(_e1976, _e1992, (_e1992 > _e1976));
                                        let _e1998 = select(_e1945, _e1943, (_e1943 > _e1945));
                                        let _e2000 = select(_e1946, _e1944, (_e1944 > _e1946));
                                        let _e2002 = select(_e1958, _e1956, (_e1956 > _e1958));
                                        let _e2004 = select(_e1959, _e1957, (_e1957 > _e1959));
                                        let _e2006 = select(_e2002, _e1998, (_e1998 < _e2002));
                                        let _e2008 = select(_e2004, _e2000, (_e2000 < _e2004));
                                        let _e2013 = -(_e1974);
                                        let _e2014 = -(_e1976);
                                        let _e2021 = (select(_e1978, _e2006, (_e2006 < _e1978)) + (select(_e2013, _e1978, (_e1978 > _e2013)) * 0.0000019073523f));
                                        let _e2022 = (select(_e1980, _e2008, (_e2008 < _e1980)) + (select(_e2014, _e1980, (_e1980 > _e2014)) * 0.0000019073523f));
                                        let _e2024 = select(_e610, _e1994, (_e1994 > _e610));
                                        let _e2026 = select(_e610, _e1996, (_e1996 > _e610));
                                        let _e2031 = (_e2024 <= select(_e1635.member_1, _e2021, (_e2021 < _e1635.member_1)));
                                        let _e2032 = (_e2026 <= select(_e1635.member_1, _e2022, (_e2022 < _e1635.member_1)));
                                        let _e2033 = (_e2024 <= _e2026);
                                        if _e2031 {
                                            if _e2032 {
                                                if _e2033 {
                                                    phi_4078_ = _e1931.member_2;
                                                } else {
                                                    phi_4078_ = _e1931.member_1;
                                                }
                                                let _e2037 = phi_4078_;
                                                let _e2058 = (_e695 % 128u);
                                                let _e2059 = (_e2058 < 128u);
                                                if _e2059 {
                                                } else {
                                                    phi_4951_ = true;
                                                    break;
                                                }
                                                local_8[_e2058] = _e2037.member_1;
                                                if _e2059 {
                                                } else {
                                                    phi_4951_ = true;
                                                    break;
                                                }
                                                local_7[_e2058] = _e2037.member.member.x;
                                                if _e2059 {
                                                } else {
                                                    phi_4951_ = true;
                                                    break;
                                                }
                                                local_6[_e2058] = _e2037.member.member.y;
                                                if _e2059 {
                                                } else {
                                                    phi_4951_ = true;
                                                    break;
                                                }
                                                local_5[_e2058] = _e2037.member.member.z;
                                                if _e2059 {
                                                } else {
                                                    phi_4951_ = true;
                                                    break;
                                                }
                                                local_4[_e2058] = _e2037.member.member_1.x;
                                                if _e2059 {
                                                } else {
                                                    phi_4951_ = true;
                                                    break;
                                                }
                                                local_3[_e2058] = _e2037.member.member_1.y;
                                                if _e2059 {
                                                } else {
                                                    phi_4951_ = true;
                                                    break;
                                                }
                                                local_2[_e2058] = _e2037.member.member_1.z;
                                                if _e2059 {
                                                } else {
                                                    phi_4951_ = true;
                                                    break;
                                                }
                                                local_9[_e2058] = select(_e2024, _e2026, _e2033);
                                                if _e2033 {
                                                    phi_4154_ = _e1931.member_1;
                                                } else {
                                                    phi_4154_ = _e1931.member_2;
                                                }
                                                let _e2072 = phi_4154_;
                                                phi_4155_ = (_e695 + 1u);
                                                phi_4156_ = _e2072;
                                            } else {
                                                phi_4155_ = u32();
                                                phi_4156_ = type_50();
                                            }
                                            let _e2074 = phi_4155_;
                                            let _e2076 = phi_4156_;
                                            phi_4158_ = _e2074;
                                            phi_4159_ = _e2076;
                                            phi_4160_ = select(true, false, _e2032);
                                        } else {
                                            phi_4158_ = u32();
                                            phi_4159_ = type_50();
                                            phi_4160_ = true;
                                        }
                                        let _e2079 = phi_4158_;
                                        let _e2081 = phi_4159_;
                                        let _e2083 = phi_4160_;
                                        if _e2083 {
                                            if _e2031 {
                                                phi_4169_ = _e1931.member_1;
                                            } else {
                                                phi_4169_ = _e1931.member_2;
                                            }
                                            let _e2087 = phi_4169_;
                                            phi_4174_ = select(_e2032, true, _e2031);
                                            phi_4176_ = _e2087;
                                        } else {
                                            phi_4174_ = _e693;
                                            phi_4176_ = _e2081;
                                        }
                                        let _e2090 = phi_4174_;
                                        let _e2092 = phi_4176_;
                                        phi_4180_ = _e2090;
                                        phi_4181_ = select(_e2079, _e695, _e2083);
                                        phi_4182_ = _e2092;
                                    }
                                    let _e2095 = phi_4180_;
                                    let _e2097 = phi_4181_;
                                    let _e2099 = phi_4182_;
                                    if _e701 {
                                        phi_4192_ = _e697;
                                    } else {
                                        phi_4192_ = _e2099;
                                    }
                                    let _e2101 = phi_4192_;
                                    phi_4954_ = _e1633;
                                    phi_4193_ = _e1635;
                                    phi_4194_ = (_e656 - 1u);
                                    phi_4195_ = select(_e2095, false, _e701);
                                    phi_4196_ = select(_e2097, _e695, _e701);
                                    phi_4197_ = _e2101;
                                } else {
                                    phi_4954_ = _e652;
                                    phi_4193_ = _e654;
                                    phi_4194_ = _e656;
                                    phi_4195_ = _e693;
                                    phi_4196_ = _e695;
                                    phi_4197_ = _e697;
                                }
                                let _e2105 = phi_4954_;
                                let _e2107 = phi_4193_;
                                let _e2109 = phi_4194_;
                                let _e2111 = phi_4195_;
                                let _e2113 = phi_4196_;
                                let _e2115 = phi_4197_;
                                phi_4953_ = _e2105;
                                phi_4198_ = _e2107;
                                phi_4199_ = _e2109;
                                phi_4200_ = _e2111;
                                phi_4201_ = _e2113;
                                phi_4202_ = _e2115;
                            } else {
                                phi_4953_ = _e652;
                                phi_4198_ = type_37();
                                phi_4199_ = u32();
                                phi_4200_ = bool();
                                phi_4201_ = u32();
                                phi_4202_ = type_50();
                            }
                            let _e2117 = phi_4953_;
                            let _e2119 = phi_4198_;
                            let _e2121 = phi_4199_;
                            let _e2123 = phi_4200_;
                            let _e2125 = phi_4201_;
                            let _e2127 = phi_4202_;
                            phi_4952_ = _e2117;
                            phi_1194_ = _e2119;
                            phi_1197_ = _e2121;
                            phi_1199_ = _e2123;
                            phi_1201_ = _e2125;
                            phi_1203_ = _e2127;
                            phi_4203_ = _e666;
                        } else {
                            phi_4952_ = _e652;
                            phi_1194_ = type_37();
                            phi_1197_ = u32();
                            phi_1199_ = bool();
                            phi_1201_ = u32();
                            phi_1203_ = type_50();
                            phi_4203_ = false;
                        }
                        let _e2129 = phi_4952_;
                        let _e2131 = phi_1194_;
                        let _e2133 = phi_1197_;
                        let _e2135 = phi_1199_;
                        let _e2137 = phi_1201_;
                        let _e2139 = phi_1203_;
                        let _e2141 = phi_4203_;
                        continue;
                        continuing {
                            phi_4745_ = _e2129;
                            phi_1193_ = _e2131;
                            phi_1196_ = _e2133;
                            phi_1198_ = _e2135;
                            phi_1200_ = _e2137;
                            phi_1202_ = _e2139;
                            phi_4951_ = _e2129;
                            break if !(_e2141);
                        }
                    }
                    let _e2144 = phi_4951_;
                    if _e2144 {
                        break;
                    }
                    let _e2146 = local_10;
                    if (_e2146.member.member_3 != 4294967295u) {
                        let _e2151 = -(_e512);
                        let _e2152 = bitcast<u32>(_e2146.member.member);
                        let _e2156 = (bitcast<i32>((_e2152 >> bitcast<u32>(23i))) & 255i);
                        let _e2157 = (_e2156 + _e2151);
                        if (_e2156 == 255i) {
                            phi_4262_ = _e2146.member.member;
                        } else {
                            if (_e2156 > 0i) {
                                if (_e2157 > 0i) {
                                    let _e2161 = (_e2157 < 255i);
                                    if _e2161 {
                                        phi_4241_ = bitcast<f32>((_e2152 + bitcast<u32>((_e2151 << bitcast<u32>(23i)))));
                                    } else {
                                        phi_4241_ = f32();
                                    }
                                    let _e2168 = phi_4241_;
                                    phi_4243_ = _e2168;
                                    phi_4244_ = select(true, false, _e2161);
                                } else {
                                    phi_4243_ = f32();
                                    phi_4244_ = true;
                                }
                                let _e2171 = phi_4243_;
                                let _e2173 = phi_4244_;
                                phi_4245_ = _e2171;
                                phi_4246_ = _e2173;
                            } else {
                                phi_4245_ = f32();
                                phi_4246_ = true;
                            }
                            let _e2175 = phi_4245_;
                            let _e2177 = phi_4246_;
                            if _e2177 {
                                let _e2178 = (_e2152 & 2147483648u);
                                let _e2185 = ((_e2152 & 8388607u) | (select(0u, 1u, ((_e2152 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                                let _e2189 = (_e2185 == 0u);
                                if _e2189 {
                                    phi_4697_ = bitcast<f32>(_e2178);
                                } else {
                                    let _e2194 = (select((bitcast<u32>(31i) - firstLeadingBit(_e2185)), 32u, _e2189) - 8u);
                                    let _e2197 = (_e2185 << bitcast<u32>((_e2194 & 31u)));
                                    let _e2199 = ((_e2157 + select(0i, 1i, (_e2156 == 0i))) - bitcast<i32>(_e2194));
                                    if (_e2199 >= 255i) {
                                        phi_4687_ = bitcast<f32>((_e2178 | 2139095040u));
                                        phi_4688_ = f32();
                                        phi_4689_ = true;
                                    } else {
                                        let _e2201 = (_e2199 > 0i);
                                        if _e2201 {
                                            phi_4681_ = bitcast<f32>(((_e2178 | (bitcast<u32>(_e2199) << bitcast<u32>(23i))) | (_e2197 & 8388607u)));
                                            phi_4682_ = f32();
                                        } else {
                                            if (_e2199 < -24i) {
                                                phi_4647_ = 26u;
                                            } else {
                                                phi_4647_ = bitcast<u32>((1i - _e2199));
                                            }
                                            let _e2206 = phi_4647_;
                                            let _e2207 = (_e2206 & 31u);
                                            let _e2209 = (_e2197 >> bitcast<u32>(_e2207));
                                            let _e2213 = (_e2197 & ((1u << bitcast<u32>(_e2207)) - 1u));
                                            let _e2217 = (1u << bitcast<u32>(((_e2206 - 1u) & 31u)));
                                            if (_e2213 > _e2217) {
                                                phi_4668_ = true;
                                            } else {
                                                if (_e2213 == _e2217) {
                                                    phi_4665_ = ((_e2209 & 1u) == 1u);
                                                } else {
                                                    phi_4665_ = false;
                                                }
                                                let _e2223 = phi_4665_;
                                                phi_4668_ = _e2223;
                                            }
                                            let _e2225 = phi_4668_;
                                            phi_4681_ = f32();
                                            phi_4682_ = bitcast<f32>((_e2178 | (_e2209 + select(0u, 1u, _e2225))));
                                        }
                                        let _e2238 = phi_4681_;
                                        let _e2240 = phi_4682_;
                                        phi_4687_ = _e2238;
                                        phi_4688_ = _e2240;
                                        phi_4689_ = _e2201;
                                    }
                                    let _e2244 = phi_4687_;
                                    let _e2246 = phi_4688_;
                                    let _e2248 = phi_4689_;
                                    phi_4697_ = select(_e2246, _e2244, _e2248);
                                }
                                let _e2252 = phi_4697_;
                                phi_4261_ = _e2252;
                            } else {
                                phi_4261_ = _e2175;
                            }
                            let _e2254 = phi_4261_;
                            phi_4262_ = _e2254;
                        }
                        let _e2256 = phi_4262_;
                        let _e2257 = bitcast<u32>(_e2256);
                        if ((_e2257 & 2147483647u) >= 2139095040u) {
                            phi_4274_ = bitcast<f32>(((_e2257 & 2147483648u) | 2139095039u));
                        } else {
                            phi_4274_ = _e2256;
                        }
                        let _e2264 = phi_4274_;
                        phi_4279_ = type_24(_e2264, _e2146.member.member_1, _e2146.member.member_2, _e2146.member.member_3);
                    } else {
                        phi_4279_ = type_24(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                    }
                    let _e2269 = phi_4279_;
                    if _e158 {
                    } else {
                        break;
                    }
                    global_6.member[_e156] = _e2269;
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn trace_closest_q10_lattice(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
