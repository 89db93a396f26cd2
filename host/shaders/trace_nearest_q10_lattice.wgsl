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

struct type_35 {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: bool,
}

struct type_37 {
    member: array<type_25>,
}

struct type_41 {
    member: array<array<type_24, 8>>,
}

struct type_47 {
    member: array<vec4<u32>, 2>,
}

struct type_52 {
    member: type_28,
    member_1: u32,
}

struct type_53 {
    member: array<vec4<f32>, 3>,
    member_1: type_52,
    member_2: type_52,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_1: type_16;
@group(0) @binding(1) 
var<uniform> global_2: type_47;
@group(0) @binding(2) 
var<storage> global_3: type_13;
@group(0) @binding(4) 
var<storage> global_4: type_37;
@group(0) @binding(3) 
var<storage> global_5: type_4;
@group(0) @binding(5) 
var<storage, read_write> global_6: type_41;

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
    var local_9: array<type_24, 8>;
    var local_10: array<f32, 128>;
    var phi_520_: i32;
    var phi_521_: i32;
    var phi_531_: bool;
    var phi_541_: u32;
    var phi_542_: u32;
    var phi_544_: bool;
    var phi_549_: u32;
    var phi_562_: i32;
    var phi_582_: i32;
    var phi_600_: f32;
    var phi_606_: f32;
    var phi_646_: f32;
    var phi_652_: f32;
    var phi_725_: f32;
    var phi_731_: f32;
    var phi_771_: f32;
    var phi_777_: f32;
    var phi_850_: f32;
    var phi_856_: f32;
    var phi_896_: f32;
    var phi_902_: f32;
    var phi_1021_: i32;
    var phi_1043_: u32;
    var phi_1044_: u32;
    var phi_1081_: i32;
    var phi_1103_: u32;
    var phi_1104_: u32;
    var phi_1112_: f32;
    var phi_1113_: f32;
    var phi_5063_: bool;
    var phi_4918_: f32;
    var phi_1262_: bool;
    var phi_1265_: type_52;
    var phi_1267_: u32;
    var phi_1269_: u32;
    var phi_1280_: bool;
    var phi_1367_: bool;
    var phi_1368_: type_52;
    var phi_1369_: u32;
    var phi_3524_: u32;
    var phi_3530_: u32;
    var phi_3784_: u32;
    var phi_3785_: u32;
    var phi_3795_: u32;
    var phi_3797_: u32;
    var phi_3798_: bool;
    var phi_3818_: u32;
    var phi_3819_: u32;
    var phi_3823_: type_53;
    var phi_4186_: type_52;
    var phi_4262_: type_52;
    var phi_4263_: type_52;
    var phi_4264_: u32;
    var phi_4266_: type_52;
    var phi_4267_: u32;
    var phi_4268_: bool;
    var phi_4277_: type_52;
    var phi_4282_: bool;
    var phi_4283_: type_52;
    var phi_5060_: bool;
    var phi_5002_: f32;
    var phi_1388_: type_8;
    var phi_1389_: type_8;
    var phi_1412_: type_8;
    var phi_1453_: u32;
    var phi_1459_: u32;
    var phi_1469_: u32;
    var phi_1485_: u32;
    var phi_1518_: u32;
    var phi_1524_: u32;
    var phi_1990_: u32;
    var phi_2008_: u32;
    var phi_2026_: u32;
    var phi_2049_: u32;
    var phi_2067_: u32;
    var phi_2085_: u32;
    var phi_2108_: u32;
    var phi_2126_: u32;
    var phi_2144_: u32;
    var phi_1698_: u32;
    var phi_1713_: u32;
    var phi_1723_: u32;
    var phi_1744_: u32;
    var phi_1765_: u32;
    var phi_1795_: u32;
    var phi_1810_: u32;
    var phi_1820_: u32;
    var phi_1841_: u32;
    var phi_1862_: u32;
    var phi_1892_: u32;
    var phi_1907_: u32;
    var phi_1917_: u32;
    var phi_1938_: u32;
    var phi_1959_: u32;
    var phi_1551_: u32;
    var phi_1600_: u32;
    var phi_1649_: u32;
    var phi_2150_: array<array<f32, 3>, 3>;
    var phi_2681_: f32;
    var phi_2682_: f32;
    var phi_2683_: f32;
    var phi_2684_: f32;
    var phi_2685_: vec3<f32>;
    var phi_2686_: vec3<f32>;
    var phi_2687_: vec3<f32>;
    var phi_2688_: vec3<f32>;
    var phi_2879_: f32;
    var phi_2899_: type_35;
    var phi_2900_: type_35;
    var phi_2903_: type_35;
    var phi_2904_: type_35;
    var phi_2905_: bool;
    var phi_2909_: type_35;
    var phi_2918_: type_24;
    var phi_2930_: type_8;
    var phi_2933_: type_24;
    var phi_2931_: type_8;
    var phi_2956_: type_8;
    var phi_2988_: bool;
    var phi_2989_: bool;
    var phi_3010_: type_24;
    var phi_2934_: type_24;
    var phi_5030_: bool;
    var phi_5319_: f32;
    var phi_5318_: f32;
    var phi_5233_: bool;
    var phi_5317_: f32;
    var phi_5232_: bool;
    var phi_5316_: f32;
    var phi_5231_: bool;
    var phi_5235_: f32;
    var phi_5230_: bool;
    var phi_5439_: f32;
    var phi_5324_: bool;
    var phi_4285_: bool;
    var phi_4286_: type_52;
    var phi_4287_: u32;
    var phi_5438_: f32;
    var phi_5323_: bool;
    var phi_4288_: bool;
    var phi_4289_: type_52;
    var phi_4290_: u32;
    var phi_4291_: u32;
    var phi_5437_: f32;
    var phi_5322_: bool;
    var phi_4292_: bool;
    var phi_4293_: type_52;
    var phi_4294_: u32;
    var phi_4295_: u32;
    var phi_5436_: f32;
    var phi_5321_: bool;
    var phi_1263_: bool;
    var phi_1266_: type_52;
    var phi_1268_: u32;
    var phi_1270_: u32;
    var phi_4296_: bool;
    var phi_5320_: bool;
    var phi_4303_: type_8;
    var phi_4304_: type_8;
    var phi_4327_: type_8;
    var phi_4379_: f32;
    var phi_4381_: f32;
    var phi_4382_: bool;
    var phi_4383_: f32;
    var phi_4384_: bool;
    var phi_4815_: u32;
    var phi_4833_: bool;
    var phi_4836_: bool;
    var phi_4849_: f32;
    var phi_4850_: f32;
    var phi_4855_: f32;
    var phi_4856_: f32;
    var phi_4857_: bool;
    var phi_4865_: f32;
    var phi_4399_: f32;
    var phi_4400_: f32;
    var phi_4412_: f32;
    var phi_4417_: type_24;
    var phi_5418_: bool;

    switch bitcast<i32>(0u) {
        default: {
            let _e101 = global;
            let _e103 = arrayLength((&global_3.member));
            let _e106 = arrayLength((&global_5.member));
            let _e114 = global_2.member[0u][0u];
            let _e118 = global_2.member[0u][1u];
            let _e122 = global_2.member[0u][2u];
            let _e126 = global_2.member[0u][3u];
            let _e130 = global_2.member[1u][0u];
            let _e134 = global_2.member[1u][1u];
            let _e138 = global_2.member[1u][2u];
            let _e141 = global_1.member[0u];
            let _e142 = bitcast<i32>(_e141);
            let _e154 = bitcast<f32>((bitcast<u32>((bitcast<i32>(_e126) + 127i)) << bitcast<u32>(23i)));
            local_1 = array<i32, 3>(bitcast<i32>(_e114), bitcast<i32>(_e118), bitcast<i32>(_e122));
            local = array<i32, 3>(bitcast<i32>(_e130), bitcast<i32>(_e134), bitcast<i32>(_e138));
            let _e160 = (_e101.x + (_e101.y * 2097152u));
            let _e161 = (_e160 < arrayLength((&global_4.member)));
            if _e161 {
                let _e162 = (_e160 < arrayLength((&global_6.member)));
                if _e162 {
                    if _e161 {
                    } else {
                        break;
                    }
                    let _e170 = global_4.member[_e160].member_2[0u];
                    let _e172 = (bitcast<u32>(_e170) & 2147483647u);
                    let _e177 = global_4.member[_e160].member_2[1u];
                    let _e179 = (bitcast<u32>(_e177) & 2147483647u);
                    let _e184 = global_4.member[_e160].member_2[2u];
                    let _e186 = (bitcast<u32>(_e184) & 2147483647u);
                    let _e191 = global_4.member[_e160].member[0u];
                    let _e193 = (bitcast<u32>(_e191) & 2147483647u);
                    let _e198 = global_4.member[_e160].member[1u];
                    let _e200 = (bitcast<u32>(_e198) & 2147483647u);
                    let _e205 = global_4.member[_e160].member[2u];
                    let _e207 = (bitcast<u32>(_e205) & 2147483647u);
                    let _e209 = select(_e179, _e172, (_e179 < _e172));
                    let _e211 = select(_e186, _e209, (_e186 < _e209));
                    let _e213 = select(_e193, _e211, (_e193 < _e211));
                    let _e215 = select(_e200, _e213, (_e200 < _e213));
                    let _e217 = select(_e207, _e215, (_e207 < _e215));
                    let _e221 = global_4.member[_e160].member_1;
                    let _e222 = bitcast<u32>(_e221);
                    let _e223 = (_e222 & 2147483647u);
                    let _e230 = global_4.member[_e160].member_3;
                    let _e231 = bitcast<u32>(_e230);
                    let _e232 = (_e231 & 2147483647u);
                    let _e236 = (((select(_e223, _e217, (_e223 < _e217)) < 2139095040u) && (_e232 <= 2139095040u)) && (_e211 > 0u));
                    if _e236 {
                        let _e239 = (bitcast<u32>(bitcast<f32>(_e211)) & 2147483647u);
                        if (_e239 >= 8388608u) {
                            phi_520_ = (bitcast<i32>((_e239 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_520_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e239)), 32u, (_e239 == 0u))));
                        }
                        let _e253 = phi_520_;
                        phi_521_ = _e253;
                    } else {
                        phi_521_ = 0i;
                    }
                    let _e255 = phi_521_;
                    let _e256 = (_e172 == _e211);
                    if _e256 {
                        phi_531_ = true;
                    } else {
                        phi_531_ = (_e179 == _e211);
                    }
                    let _e259 = phi_531_;
                    let _e260 = select(1u, 0u, _e256);
                    if _e259 {
                        let _e261 = (_e260 + 1u);
                        phi_541_ = _e261;
                        phi_542_ = _e261;
                        phi_544_ = select(true, false, (_e261 == 2u));
                    } else {
                        phi_541_ = u32();
                        phi_542_ = 0u;
                        phi_544_ = true;
                    }
                    let _e265 = phi_541_;
                    let _e267 = phi_542_;
                    let _e269 = phi_544_;
                    if _e269 {
                        phi_549_ = (_e267 + 1u);
                    } else {
                        phi_549_ = 0u;
                    }
                    let _e273 = phi_549_;
                    let _e274 = select(_e265, _e267, _e269);
                    let _e275 = select(_e260, select(2u, _e260, _e259), _e269);
                    if (_e142 < -126i) {
                        phi_562_ = -126i;
                    } else {
                        phi_562_ = select(_e142, 127i, (_e142 > 127i));
                    }
                    let _e280 = phi_562_;
                    let _e285 = bitcast<f32>((bitcast<u32>((_e280 + 127i)) << bitcast<u32>(23i)));
                    let _e291 = bitcast<f32>((bitcast<u32>(((_e142 - _e280) + 127i)) << bitcast<u32>(23i)));
                    let _e292 = -(_e255);
                    if (_e292 < -126i) {
                        phi_582_ = -126i;
                    } else {
                        phi_582_ = select(_e292, 127i, (_e292 > 127i));
                    }
                    let _e297 = phi_582_;
                    let _e302 = bitcast<f32>((bitcast<u32>((_e297 + 127i)) << bitcast<u32>(23i)));
                    let _e308 = bitcast<f32>((bitcast<u32>(((_e292 - _e297) + 127i)) << bitcast<u32>(23i)));
                    let _e312 = global_4.member[_e160].member;
                    let _e313 = (_e274 == 0u);
                    if _e313 {
                        phi_600_ = _e312[0];
                    } else {
                        phi_600_ = _e312[1];
                    }
                    let _e317 = phi_600_;
                    let _e318 = (_e274 == 2u);
                    if _e318 {
                        phi_606_ = _e312[2];
                    } else {
                        phi_606_ = _e317;
                    }
                    let _e321 = phi_606_;
                    let _e322 = bitcast<u32>(_e321);
                    let _e324 = ((_e322 & 2139095040u) != 0u);
                    let _e338 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e322 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e322 & 2147483648u))), _e321, _e324) * _e285) * select(0.00000011920929f, 1f, _e324)) * _e291);
                    let _e339 = global_4.member[_e160].member_2;
                    if _e313 {
                        phi_646_ = _e339[0];
                    } else {
                        phi_646_ = _e339[1];
                    }
                    let _e343 = phi_646_;
                    if _e318 {
                        phi_652_ = _e339[2];
                    } else {
                        phi_652_ = _e343;
                    }
                    let _e346 = phi_652_;
                    let _e347 = bitcast<u32>(_e346);
                    let _e349 = ((_e347 & 2139095040u) != 0u);
                    let _e363 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e347 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e347 & 2147483648u))), _e346, _e349) * _e302) * select(0.00000011920929f, 1f, _e349)) * _e308);
                    let _e367 = (bitcast<f32>((bitcast<u32>(_e363) & 2147483647u)) >= 0.00000000000000000086736174f);
                    let _e370 = bitcast<f32>((bitcast<u32>(_e338) & 2147483647u));
                    let _e371 = (_e370 * 0.00000011920929f);
                    let _e374 = select(select(0.00000000000011368684f, _e371, (_e371 > 0.00000000000011368684f)), 0f, _e367);
                    let _e375 = select(0f, _e363, _e367);
                    let _e376 = (_e338 + _e374);
                    let _e377 = (_e338 - _e374);
                    let _e379 = select(38685626000000000000000000f, (1f / _e363), _e367);
                    let _e380 = (_e273 == 0u);
                    if _e380 {
                        phi_725_ = _e312[0];
                    } else {
                        phi_725_ = _e312[1];
                    }
                    let _e384 = phi_725_;
                    let _e385 = (_e273 == 2u);
                    if _e385 {
                        phi_731_ = _e312[2];
                    } else {
                        phi_731_ = _e384;
                    }
                    let _e388 = phi_731_;
                    let _e389 = bitcast<u32>(_e388);
                    let _e391 = ((_e389 & 2139095040u) != 0u);
                    let _e405 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e389 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e389 & 2147483648u))), _e388, _e391) * _e285) * select(0.00000011920929f, 1f, _e391)) * _e291);
                    if _e380 {
                        phi_771_ = _e339[0];
                    } else {
                        phi_771_ = _e339[1];
                    }
                    let _e409 = phi_771_;
                    if _e385 {
                        phi_777_ = _e339[2];
                    } else {
                        phi_777_ = _e409;
                    }
                    let _e412 = phi_777_;
                    let _e413 = bitcast<u32>(_e412);
                    let _e415 = ((_e413 & 2139095040u) != 0u);
                    let _e429 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e413 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e413 & 2147483648u))), _e412, _e415) * _e302) * select(0.00000011920929f, 1f, _e415)) * _e308);
                    let _e433 = (bitcast<f32>((bitcast<u32>(_e429) & 2147483647u)) >= 0.00000000000000000086736174f);
                    let _e436 = bitcast<f32>((bitcast<u32>(_e405) & 2147483647u));
                    let _e437 = (_e436 * 0.00000011920929f);
                    let _e440 = select(select(0.00000000000011368684f, _e437, (_e437 > 0.00000000000011368684f)), 0f, _e433);
                    let _e441 = select(0f, _e429, _e433);
                    let _e442 = (_e405 + _e440);
                    let _e443 = (_e405 - _e440);
                    let _e445 = select(38685626000000000000000000f, (1f / _e429), _e433);
                    let _e446 = (_e275 == 0u);
                    if _e446 {
                        phi_850_ = _e312[0];
                    } else {
                        phi_850_ = _e312[1];
                    }
                    let _e450 = phi_850_;
                    let _e451 = (_e275 == 2u);
                    if _e451 {
                        phi_856_ = _e312[2];
                    } else {
                        phi_856_ = _e450;
                    }
                    let _e454 = phi_856_;
                    let _e455 = bitcast<u32>(_e454);
                    let _e457 = ((_e455 & 2139095040u) != 0u);
                    let _e471 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e455 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e455 & 2147483648u))), _e454, _e457) * _e285) * select(0.00000011920929f, 1f, _e457)) * _e291);
                    if _e446 {
                        phi_896_ = _e339[0];
                    } else {
                        phi_896_ = _e339[1];
                    }
                    let _e475 = phi_896_;
                    if _e451 {
                        phi_902_ = _e339[2];
                    } else {
                        phi_902_ = _e475;
                    }
                    let _e478 = phi_902_;
                    let _e479 = bitcast<u32>(_e478);
                    let _e481 = ((_e479 & 2139095040u) != 0u);
                    let _e495 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e479 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e479 & 2147483648u))), _e478, _e481) * _e302) * select(0.00000011920929f, 1f, _e481)) * _e308);
                    let _e499 = (bitcast<f32>((bitcast<u32>(_e495) & 2147483647u)) >= 0.00000000000000000086736174f);
                    let _e502 = bitcast<f32>((bitcast<u32>(_e471) & 2147483647u));
                    let _e503 = (_e502 * 0.00000011920929f);
                    let _e506 = select(select(0.00000000000011368684f, _e503, (_e503 > 0.00000000000011368684f)), 0f, _e499);
                    let _e507 = select(0f, _e495, _e499);
                    let _e508 = (_e471 + _e506);
                    let _e509 = (_e471 - _e506);
                    let _e511 = select(38685626000000000000000000f, (1f / _e495), _e499);
                    let _e513 = select(_e436, _e370, (_e370 > _e436));
                    let _e516 = (_e142 + _e255);
                    if (_e236 && (select(_e502, _e513, (_e513 > _e502)) <= 1099511600000f)) {
                        let _e526 = ((_e223 & 8388607u) | (select(0u, 1u, ((_e223 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                        let _e529 = bitcast<i32>((_e223 >> bitcast<u32>(23i)));
                        let _e533 = (_e526 == 0u);
                        let _e536 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e526)), 32u, _e533)) - 8i);
                        if (_e529 == 255i) {
                            phi_1021_ = 255i;
                        } else {
                            phi_1021_ = (((_e529 + select(0i, 1i, (_e529 == 0i))) - _e536) + _e516);
                        }
                        let _e544 = phi_1021_;
                        let _e554 = (_e544 <= 0i);
                        if _e554 {
                            phi_1044_ = u32();
                        } else {
                            if _e533 {
                                phi_1043_ = u32();
                            } else {
                                phi_1043_ = select(((bitcast<u32>(_e544) << bitcast<u32>(23i)) | ((_e526 << bitcast<u32>(((_e536 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e544 >= 255i));
                            }
                            let _e558 = phi_1043_;
                            phi_1044_ = _e558;
                        }
                        let _e560 = phi_1044_;
                        let _e572 = ((_e232 & 8388607u) | (select(0u, 1u, ((_e232 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                        let _e575 = bitcast<i32>((_e232 >> bitcast<u32>(23i)));
                        let _e579 = (_e572 == 0u);
                        let _e582 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e572)), 32u, _e579)) - 8i);
                        if (_e575 == 255i) {
                            phi_1081_ = 255i;
                        } else {
                            phi_1081_ = (((_e575 + select(0i, 1i, (_e575 == 0i))) - _e582) + _e516);
                        }
                        let _e590 = phi_1081_;
                        let _e600 = (_e590 <= 0i);
                        if _e600 {
                            phi_1104_ = u32();
                        } else {
                            if _e579 {
                                phi_1103_ = u32();
                            } else {
                                phi_1103_ = select(((bitcast<u32>(_e590) << bitcast<u32>(23i)) | ((_e572 << bitcast<u32>(((_e582 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e590 >= 255i));
                            }
                            let _e604 = phi_1103_;
                            phi_1104_ = _e604;
                        }
                        let _e606 = phi_1104_;
                        phi_1112_ = bitcast<f32>(((_e231 & 2147483648u) | select(_e606, 0u, select(_e579, true, _e600))));
                        phi_1113_ = bitcast<f32>(((_e222 & 2147483648u) | select(_e560, 0u, select(_e533, true, _e554))));
                    } else {
                        phi_1112_ = 0f;
                        phi_1113_ = 1f;
                    }
                    let _e612 = phi_1112_;
                    let _e614 = phi_1113_;
                    local_9 = array<type_24, 8>(type_24(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_24(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_24(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_24(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_24(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_24(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_24(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_24(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u));
                    local_8 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                    local_7 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_6 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_5 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_4 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_3 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_10 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    let _e619 = (_e274 % 3u);
                    let _e620 = (_e619 < 3u);
                    if _e620 {
                    } else {
                        break;
                    }
                    let _e622 = local_1[_e619];
                    let _e625 = (_e273 % 3u);
                    let _e626 = (_e625 < 3u);
                    if _e626 {
                    } else {
                        break;
                    }
                    let _e628 = local_1[_e625];
                    let _e631 = (_e275 % 3u);
                    let _e632 = (_e631 < 3u);
                    if _e632 {
                    } else {
                        break;
                    }
                    let _e634 = local_1[_e631];
                    if _e620 {
                    } else {
                        break;
                    }
                    let _e639 = local[_e619];
                    if _e626 {
                    } else {
                        break;
                    }
                    let _e643 = local[_e625];
                    if _e632 {
                    } else {
                        break;
                    }
                    let _e647 = local[_e631];
                    phi_5063_ = false;
                    phi_4918_ = _e612;
                    phi_1262_ = (_e614 <= _e612);
                    phi_1265_ = type_52(type_28(vec4<f32>((f32(_e622) * _e154), (f32(_e628) * _e154), (f32(_e634) * _e154), 0f), vec4<f32>((f32(_e639) * _e154), (f32(_e643) * _e154), (f32(_e647) * _e154), 0f)), select(0u, 2147483648u, (_e103 == 0u)));
                    phi_1267_ = 0u;
                    phi_1269_ = ((3u * _e103) + 1u);
                    loop {
                        let _e655 = phi_5063_;
                        let _e657 = phi_4918_;
                        let _e659 = phi_1262_;
                        let _e661 = phi_1265_;
                        let _e663 = phi_1267_;
                        let _e665 = phi_1269_;
                        if _e659 {
                            phi_1280_ = true;
                        } else {
                            phi_1280_ = (_e663 > 0u);
                        }
                        let _e668 = phi_1280_;
                        if _e668 {
                            let _e669 = (_e665 > 0u);
                            if _e669 {
                                if _e659 {
                                    phi_1367_ = _e659;
                                    phi_1368_ = _e661;
                                    phi_1369_ = _e663;
                                } else {
                                    let _e670 = (_e663 - 1u);
                                    let _e671 = (_e670 % 128u);
                                    let _e672 = (_e671 < 128u);
                                    if _e672 {
                                    } else {
                                        phi_5320_ = true;
                                        break;
                                    }
                                    let _e674 = local_7[_e671];
                                    if _e672 {
                                    } else {
                                        phi_5320_ = true;
                                        break;
                                    }
                                    let _e676 = local_6[_e671];
                                    if _e672 {
                                    } else {
                                        phi_5320_ = true;
                                        break;
                                    }
                                    let _e678 = local_5[_e671];
                                    if _e672 {
                                    } else {
                                        phi_5320_ = true;
                                        break;
                                    }
                                    let _e680 = local_4[_e671];
                                    if _e672 {
                                    } else {
                                        phi_5320_ = true;
                                        break;
                                    }
                                    let _e682 = local_3[_e671];
                                    if _e672 {
                                    } else {
                                        phi_5320_ = true;
                                        break;
                                    }
                                    let _e684 = local_2[_e671];
                                    if _e672 {
                                    } else {
                                        phi_5320_ = true;
                                        break;
                                    }
                                    let _e689 = local_8[_e671];
                                    if _e672 {
                                    } else {
                                        phi_5320_ = true;
                                        break;
                                    }
                                    let _e692 = local_10[_e671];
                                    phi_1367_ = (_e692 <= _e657);
                                    phi_1368_ = type_52(type_28(vec4<f32>(_e674, _e676, _e678, 0f), vec4<f32>(_e680, _e682, _e684, 0f)), _e689);
                                    phi_1369_ = _e670;
                                }
                                let _e695 = phi_1367_;
                                let _e697 = phi_1368_;
                                let _e699 = phi_1369_;
                                if _e695 {
                                    let _e704 = (_e697.member_1 & 268435455u);
                                    if ((_e697.member_1 & 2147483648u) != 0u) {
                                        phi_5060_ = _e655;
                                        phi_5002_ = _e657;
                                        phi_1388_ = type_8(0u, ((_e697.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e1168 = phi_5060_;
                                            let _e1170 = phi_5002_;
                                            let _e1172 = phi_1388_;
                                            if (_e1172.member < _e1172.member_1) {
                                                phi_1389_ = type_8((_e1172.member + 1u), _e1172.member_1);
                                                phi_1412_ = type_8(1u, _e1172.member);
                                            } else {
                                                phi_1389_ = _e1172;
                                                phi_1412_ = type_8(0u, type_8().member_1);
                                            }
                                            let _e1185 = phi_1389_;
                                            let _e1187 = phi_1412_;
                                            let _e1191 = (bitcast<i32>(_e1187.member) != 0i);
                                            if _e1191 {
                                                let _e1196 = (_e697.member.member_1.x - _e697.member.member.x);
                                                let _e1199 = (_e697.member.member_1.y - _e697.member.member.y);
                                                let _e1202 = (_e697.member.member_1.z - _e697.member.member.z);
                                                let _e1204 = select(_e1199, _e1196, (_e1196 > _e1199));
                                                let _e1206 = select(_e1202, _e1204, (_e1204 > _e1202));
                                                let _e1208 = (_e1206 < (1024f * _e154));
                                                if _e1208 {
                                                    phi_1453_ = 0u;
                                                } else {
                                                    phi_1453_ = select(2u, 1u, (_e1206 < (2097152f * _e154)));
                                                }
                                                let _e1213 = phi_1453_;
                                                switch bitcast<i32>(_e1213) {
                                                    case 0: {
                                                        phi_1459_ = 1u;
                                                        break;
                                                    }
                                                    case 1: {
                                                        phi_1459_ = 2u;
                                                        break;
                                                    }
                                                    case 2: {
                                                        phi_1459_ = 3u;
                                                        break;
                                                    }
                                                    default: {
                                                        phi_1459_ = u32();
                                                        break;
                                                    }
                                                }
                                                let _e1216 = phi_1459_;
                                                switch bitcast<i32>(_e1213) {
                                                    case 0: {
                                                        phi_1469_ = 1u;
                                                        break;
                                                    }
                                                    case 1: {
                                                        phi_1469_ = 2u;
                                                        break;
                                                    }
                                                    case 2: {
                                                        phi_1469_ = 3u;
                                                        break;
                                                    }
                                                    default: {
                                                        phi_1469_ = u32();
                                                        break;
                                                    }
                                                }
                                                let _e1223 = phi_1469_;
                                                let _e1225 = ((_e704 + (_e1187.member_1 * ((3u * _e1216) + 1u))) + (3u * _e1223));
                                                let _e1226 = (_e1225 < _e106);
                                                if _e1226 {
                                                    if _e1226 {
                                                    } else {
                                                        phi_5235_ = _e1170;
                                                        phi_5230_ = true;
                                                        break;
                                                    }
                                                    let _e1228 = global_5.member[_e1225];
                                                    phi_1485_ = _e1228;
                                                } else {
                                                    phi_1485_ = 4294967295u;
                                                }
                                                let _e1230 = phi_1485_;
                                                if _e1208 {
                                                    phi_1518_ = 0u;
                                                } else {
                                                    phi_1518_ = select(2u, 1u, (_e1206 < (2097152f * _e154)));
                                                }
                                                let _e1235 = phi_1518_;
                                                switch bitcast<i32>(_e1235) {
                                                    case 0: {
                                                        phi_1524_ = 1u;
                                                        break;
                                                    }
                                                    case 1: {
                                                        phi_1524_ = 2u;
                                                        break;
                                                    }
                                                    case 2: {
                                                        phi_1524_ = 3u;
                                                        break;
                                                    }
                                                    default: {
                                                        phi_1524_ = u32();
                                                        break;
                                                    }
                                                }
                                                let _e1238 = phi_1524_;
                                                let _e1242 = (_e704 + (_e1187.member_1 * ((3u * _e1238) + 1u)));
                                                switch bitcast<i32>(_e1235) {
                                                    case 0: {
                                                        let _e1517 = (_e1242 < _e106);
                                                        if _e1517 {
                                                            if _e1517 {
                                                            } else {
                                                                phi_5235_ = _e1170;
                                                                phi_5230_ = true;
                                                                break;
                                                            }
                                                            let _e1519 = global_5.member[_e1242];
                                                            phi_1551_ = _e1519;
                                                        } else {
                                                            phi_1551_ = 0u;
                                                        }
                                                        let _e1521 = phi_1551_;
                                                        let _e1523 = ((10u * _e274) & 31u);
                                                        let _e1533 = ((10u * _e273) & 31u);
                                                        let _e1543 = ((10u * _e275) & 31u);
                                                        let _e1553 = (_e1242 + 1u);
                                                        let _e1554 = (_e1553 < _e106);
                                                        if _e1554 {
                                                            if _e1554 {
                                                            } else {
                                                                phi_5235_ = _e1170;
                                                                phi_5230_ = true;
                                                                break;
                                                            }
                                                            let _e1556 = global_5.member[_e1553];
                                                            phi_1600_ = _e1556;
                                                        } else {
                                                            phi_1600_ = 0u;
                                                        }
                                                        let _e1558 = phi_1600_;
                                                        let _e1584 = (_e1242 + 2u);
                                                        let _e1585 = (_e1584 < _e106);
                                                        if _e1585 {
                                                            if _e1585 {
                                                            } else {
                                                                phi_5235_ = _e1170;
                                                                phi_5230_ = true;
                                                                break;
                                                            }
                                                            let _e1587 = global_5.member[_e1584];
                                                            phi_1649_ = _e1587;
                                                        } else {
                                                            phi_1649_ = 0u;
                                                        }
                                                        let _e1589 = phi_1649_;
                                                        phi_2150_ = array<array<f32, 3>, 3>(array<f32, 3>((_e697.member.member.x + ((bitcast<f32>((1258291200u | ((_e1521 >> bitcast<u32>(_e1523)) & 1023u))) - 8388608f) * _e154)), (_e697.member.member.y + ((bitcast<f32>((1258291200u | ((_e1521 >> bitcast<u32>(_e1533)) & 1023u))) - 8388608f) * _e154)), (_e697.member.member.z + ((bitcast<f32>((1258291200u | ((_e1521 >> bitcast<u32>(_e1543)) & 1023u))) - 8388608f) * _e154))), array<f32, 3>((_e697.member.member.x + ((bitcast<f32>((1258291200u | ((_e1558 >> bitcast<u32>(_e1523)) & 1023u))) - 8388608f) * _e154)), (_e697.member.member.y + ((bitcast<f32>((1258291200u | ((_e1558 >> bitcast<u32>(_e1533)) & 1023u))) - 8388608f) * _e154)), (_e697.member.member.z + ((bitcast<f32>((1258291200u | ((_e1558 >> bitcast<u32>(_e1543)) & 1023u))) - 8388608f) * _e154))), array<f32, 3>((_e697.member.member.x + ((bitcast<f32>((1258291200u | ((_e1589 >> bitcast<u32>(_e1523)) & 1023u))) - 8388608f) * _e154)), (_e697.member.member.y + ((bitcast<f32>((1258291200u | ((_e1589 >> bitcast<u32>(_e1533)) & 1023u))) - 8388608f) * _e154)), (_e697.member.member.z + ((bitcast<f32>((1258291200u | ((_e1589 >> bitcast<u32>(_e1543)) & 1023u))) - 8388608f) * _e154))));
                                                        break;
                                                    }
                                                    case 1: {
                                                        let _e1331 = (_e1242 < _e106);
                                                        if _e1331 {
                                                            if _e1331 {
                                                            } else {
                                                                phi_5235_ = _e1170;
                                                                phi_5230_ = true;
                                                                break;
                                                            }
                                                            let _e1333 = global_5.member[_e1242];
                                                            phi_1698_ = _e1333;
                                                        } else {
                                                            phi_1698_ = 0u;
                                                        }
                                                        let _e1335 = phi_1698_;
                                                        let _e1336 = (_e1242 + 1u);
                                                        let _e1337 = (_e1336 < _e106);
                                                        if _e1337 {
                                                            if _e1337 {
                                                            } else {
                                                                phi_5235_ = _e1170;
                                                                phi_5230_ = true;
                                                                break;
                                                            }
                                                            let _e1339 = global_5.member[_e1336];
                                                            phi_1713_ = _e1339;
                                                        } else {
                                                            phi_1713_ = 0u;
                                                        }
                                                        let _e1341 = phi_1713_;
                                                        let _e1342 = (_e274 == 1u);
                                                        if _e1342 {
                                                            phi_1723_ = ((_e1335 >> bitcast<u32>(21i)) | (_e1341 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1723_ = (_e1341 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1351 = phi_1723_;
                                                        let _e1359 = (_e273 == 1u);
                                                        if _e1359 {
                                                            phi_1744_ = ((_e1335 >> bitcast<u32>(21i)) | (_e1341 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1744_ = (_e1341 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1368 = phi_1744_;
                                                        let _e1376 = (_e275 == 1u);
                                                        if _e1376 {
                                                            phi_1765_ = ((_e1335 >> bitcast<u32>(21i)) | (_e1341 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1765_ = (_e1341 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1385 = phi_1765_;
                                                        let _e1394 = (_e1242 + 2u);
                                                        let _e1395 = (_e1394 < _e106);
                                                        if _e1395 {
                                                            if _e1395 {
                                                            } else {
                                                                phi_5235_ = _e1170;
                                                                phi_5230_ = true;
                                                                break;
                                                            }
                                                            let _e1397 = global_5.member[_e1394];
                                                            phi_1795_ = _e1397;
                                                        } else {
                                                            phi_1795_ = 0u;
                                                        }
                                                        let _e1399 = phi_1795_;
                                                        let _e1400 = (_e1242 + 3u);
                                                        let _e1401 = (_e1400 < _e106);
                                                        if _e1401 {
                                                            if _e1401 {
                                                            } else {
                                                                phi_5235_ = _e1170;
                                                                phi_5230_ = true;
                                                                break;
                                                            }
                                                            let _e1403 = global_5.member[_e1400];
                                                            phi_1810_ = _e1403;
                                                        } else {
                                                            phi_1810_ = 0u;
                                                        }
                                                        let _e1405 = phi_1810_;
                                                        if _e1342 {
                                                            phi_1820_ = ((_e1399 >> bitcast<u32>(21i)) | (_e1405 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1820_ = (_e1405 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1414 = phi_1820_;
                                                        if _e1359 {
                                                            phi_1841_ = ((_e1399 >> bitcast<u32>(21i)) | (_e1405 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1841_ = (_e1405 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1430 = phi_1841_;
                                                        if _e1376 {
                                                            phi_1862_ = ((_e1399 >> bitcast<u32>(21i)) | (_e1405 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1862_ = (_e1405 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1446 = phi_1862_;
                                                        let _e1455 = (_e1242 + 4u);
                                                        let _e1456 = (_e1455 < _e106);
                                                        if _e1456 {
                                                            if _e1456 {
                                                            } else {
                                                                phi_5235_ = _e1170;
                                                                phi_5230_ = true;
                                                                break;
                                                            }
                                                            let _e1458 = global_5.member[_e1455];
                                                            phi_1892_ = _e1458;
                                                        } else {
                                                            phi_1892_ = 0u;
                                                        }
                                                        let _e1460 = phi_1892_;
                                                        let _e1461 = (_e1242 + 5u);
                                                        let _e1462 = (_e1461 < _e106);
                                                        if _e1462 {
                                                            if _e1462 {
                                                            } else {
                                                                phi_5235_ = _e1170;
                                                                phi_5230_ = true;
                                                                break;
                                                            }
                                                            let _e1464 = global_5.member[_e1461];
                                                            phi_1907_ = _e1464;
                                                        } else {
                                                            phi_1907_ = 0u;
                                                        }
                                                        let _e1466 = phi_1907_;
                                                        if _e1342 {
                                                            phi_1917_ = ((_e1460 >> bitcast<u32>(21i)) | (_e1466 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1917_ = (_e1466 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1475 = phi_1917_;
                                                        if _e1359 {
                                                            phi_1938_ = ((_e1460 >> bitcast<u32>(21i)) | (_e1466 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1938_ = (_e1466 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1491 = phi_1938_;
                                                        if _e1376 {
                                                            phi_1959_ = ((_e1460 >> bitcast<u32>(21i)) | (_e1466 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1959_ = (_e1466 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1507 = phi_1959_;
                                                        phi_2150_ = array<array<f32, 3>, 3>(array<f32, 3>((_e697.member.member.x + ((bitcast<f32>((1258291200u | (select(_e1351, _e1335, _e313) & 2097151u))) - 8388608f) * _e154)), (_e697.member.member.y + ((bitcast<f32>((1258291200u | (select(_e1368, _e1335, _e380) & 2097151u))) - 8388608f) * _e154)), (_e697.member.member.z + ((bitcast<f32>((1258291200u | (select(_e1385, _e1335, _e446) & 2097151u))) - 8388608f) * _e154))), array<f32, 3>((_e697.member.member.x + ((bitcast<f32>((1258291200u | (select(_e1414, _e1399, _e313) & 2097151u))) - 8388608f) * _e154)), (_e697.member.member.y + ((bitcast<f32>((1258291200u | (select(_e1430, _e1399, _e380) & 2097151u))) - 8388608f) * _e154)), (_e697.member.member.z + ((bitcast<f32>((1258291200u | (select(_e1446, _e1399, _e446) & 2097151u))) - 8388608f) * _e154))), array<f32, 3>((_e697.member.member.x + ((bitcast<f32>((1258291200u | (select(_e1475, _e1460, _e313) & 2097151u))) - 8388608f) * _e154)), (_e697.member.member.y + ((bitcast<f32>((1258291200u | (select(_e1491, _e1460, _e380) & 2097151u))) - 8388608f) * _e154)), (_e697.member.member.z + ((bitcast<f32>((1258291200u | (select(_e1507, _e1460, _e446) & 2097151u))) - 8388608f) * _e154))));
                                                        break;
                                                    }
                                                    case 2: {
                                                        let _e1244 = (_e1242 + _e274);
                                                        let _e1245 = (_e1244 < _e106);
                                                        if _e1245 {
                                                            if _e1245 {
                                                            } else {
                                                                phi_5235_ = _e1170;
                                                                phi_5230_ = true;
                                                                break;
                                                            }
                                                            let _e1247 = global_5.member[_e1244];
                                                            phi_1990_ = _e1247;
                                                        } else {
                                                            phi_1990_ = 0u;
                                                        }
                                                        let _e1249 = phi_1990_;
                                                        let _e1253 = (_e1242 + _e273);
                                                        let _e1254 = (_e1253 < _e106);
                                                        if _e1254 {
                                                            if _e1254 {
                                                            } else {
                                                                phi_5235_ = _e1170;
                                                                phi_5230_ = true;
                                                                break;
                                                            }
                                                            let _e1256 = global_5.member[_e1253];
                                                            phi_2008_ = _e1256;
                                                        } else {
                                                            phi_2008_ = 0u;
                                                        }
                                                        let _e1258 = phi_2008_;
                                                        let _e1262 = (_e1242 + _e275);
                                                        let _e1263 = (_e1262 < _e106);
                                                        if _e1263 {
                                                            if _e1263 {
                                                            } else {
                                                                phi_5235_ = _e1170;
                                                                phi_5230_ = true;
                                                                break;
                                                            }
                                                            let _e1265 = global_5.member[_e1262];
                                                            phi_2026_ = _e1265;
                                                        } else {
                                                            phi_2026_ = 0u;
                                                        }
                                                        let _e1267 = phi_2026_;
                                                        let _e1272 = (_e1242 + 3u);
                                                        let _e1273 = (_e1272 + _e274);
                                                        let _e1274 = (_e1273 < _e106);
                                                        if _e1274 {
                                                            if _e1274 {
                                                            } else {
                                                                phi_5235_ = _e1170;
                                                                phi_5230_ = true;
                                                                break;
                                                            }
                                                            let _e1276 = global_5.member[_e1273];
                                                            phi_2049_ = _e1276;
                                                        } else {
                                                            phi_2049_ = 0u;
                                                        }
                                                        let _e1278 = phi_2049_;
                                                        let _e1282 = (_e1272 + _e273);
                                                        let _e1283 = (_e1282 < _e106);
                                                        if _e1283 {
                                                            if _e1283 {
                                                            } else {
                                                                phi_5235_ = _e1170;
                                                                phi_5230_ = true;
                                                                break;
                                                            }
                                                            let _e1285 = global_5.member[_e1282];
                                                            phi_2067_ = _e1285;
                                                        } else {
                                                            phi_2067_ = 0u;
                                                        }
                                                        let _e1287 = phi_2067_;
                                                        let _e1291 = (_e1272 + _e275);
                                                        let _e1292 = (_e1291 < _e106);
                                                        if _e1292 {
                                                            if _e1292 {
                                                            } else {
                                                                phi_5235_ = _e1170;
                                                                phi_5230_ = true;
                                                                break;
                                                            }
                                                            let _e1294 = global_5.member[_e1291];
                                                            phi_2085_ = _e1294;
                                                        } else {
                                                            phi_2085_ = 0u;
                                                        }
                                                        let _e1296 = phi_2085_;
                                                        let _e1301 = (_e1242 + 6u);
                                                        let _e1302 = (_e1301 + _e274);
                                                        let _e1303 = (_e1302 < _e106);
                                                        if _e1303 {
                                                            if _e1303 {
                                                            } else {
                                                                phi_5235_ = _e1170;
                                                                phi_5230_ = true;
                                                                break;
                                                            }
                                                            let _e1305 = global_5.member[_e1302];
                                                            phi_2108_ = _e1305;
                                                        } else {
                                                            phi_2108_ = 0u;
                                                        }
                                                        let _e1307 = phi_2108_;
                                                        let _e1311 = (_e1301 + _e273);
                                                        let _e1312 = (_e1311 < _e106);
                                                        if _e1312 {
                                                            if _e1312 {
                                                            } else {
                                                                phi_5235_ = _e1170;
                                                                phi_5230_ = true;
                                                                break;
                                                            }
                                                            let _e1314 = global_5.member[_e1311];
                                                            phi_2126_ = _e1314;
                                                        } else {
                                                            phi_2126_ = 0u;
                                                        }
                                                        let _e1316 = phi_2126_;
                                                        let _e1320 = (_e1301 + _e275);
                                                        let _e1321 = (_e1320 < _e106);
                                                        if _e1321 {
                                                            if _e1321 {
                                                            } else {
                                                                phi_5235_ = _e1170;
                                                                phi_5230_ = true;
                                                                break;
                                                            }
                                                            let _e1323 = global_5.member[_e1320];
                                                            phi_2144_ = _e1323;
                                                        } else {
                                                            phi_2144_ = 0u;
                                                        }
                                                        let _e1325 = phi_2144_;
                                                        phi_2150_ = array<array<f32, 3>, 3>(array<f32, 3>((f32(bitcast<i32>(_e1249)) * _e154), (f32(bitcast<i32>(_e1258)) * _e154), (f32(bitcast<i32>(_e1267)) * _e154)), array<f32, 3>((f32(bitcast<i32>(_e1278)) * _e154), (f32(bitcast<i32>(_e1287)) * _e154), (f32(bitcast<i32>(_e1296)) * _e154)), array<f32, 3>((f32(bitcast<i32>(_e1307)) * _e154), (f32(bitcast<i32>(_e1316)) * _e154), (f32(bitcast<i32>(_e1325)) * _e154)));
                                                        break;
                                                    }
                                                    default: {
                                                        phi_2150_ = array<array<f32, 3>, 3>();
                                                        break;
                                                    }
                                                }
                                                let _e1617 = phi_2150_;
                                                let _e1632 = (_e1617[0][2] - _e471);
                                                let _e1635 = (((_e1617[0][0] - _e338) * _e507) - (_e1632 * _e375));
                                                let _e1638 = (((_e1617[0][1] - _e405) * _e507) - (_e1632 * _e441));
                                                let _e1641 = (_e1617[1][2] - _e471);
                                                let _e1644 = (((_e1617[1][0] - _e338) * _e507) - (_e1641 * _e375));
                                                let _e1647 = (((_e1617[1][1] - _e405) * _e507) - (_e1641 * _e441));
                                                let _e1650 = (_e1617[2][2] - _e471);
                                                let _e1653 = (((_e1617[2][0] - _e338) * _e507) - (_e1650 * _e375));
                                                let _e1656 = (((_e1617[2][1] - _e405) * _e507) - (_e1650 * _e441));
                                                let _e1657 = (_e1653 * _e1647);
                                                let _e1658 = (_e1656 * _e1644);
                                                let _e1659 = (_e1635 * _e1656);
                                                let _e1660 = (_e1638 * _e1653);
                                                let _e1661 = (_e1644 * _e1638);
                                                let _e1662 = (_e1647 * _e1635);
                                                let _e1667 = (((_e1657 >= _e1658) && (_e1659 >= _e1660)) && (_e1661 >= _e1662));
                                                let _e1673 = (_e1667 || (((_e1657 <= _e1658) && (_e1659 <= _e1660)) && (_e1661 <= _e1662)));
                                                if _e1673 {
                                                    let _e1675 = select(-1f, 1f, _e1667);
                                                    let _e1677 = ((_e1657 - _e1658) * _e1675);
                                                    let _e1679 = select(0f, _e1677, (_e1677 > 0f));
                                                    let _e1681 = ((_e1659 - _e1660) * _e1675);
                                                    let _e1683 = select(0f, _e1681, (_e1681 > 0f));
                                                    let _e1685 = ((_e1661 - _e1662) * _e1675);
                                                    let _e1687 = select(0f, _e1685, (_e1685 > 0f));
                                                    let _e1689 = ((_e1679 + _e1683) + _e1687);
                                                    let _e1691 = select(_e1617[1][0], _e1617[0][0], (_e1617[0][0] < _e1617[1][0]));
                                                    let _e1695 = select(_e1617[1][0], _e1617[0][0], (_e1617[0][0] > _e1617[1][0]));
                                                    let _e1699 = select(_e1617[1][1], _e1617[0][1], (_e1617[0][1] < _e1617[1][1]));
                                                    let _e1703 = select(_e1617[1][1], _e1617[0][1], (_e1617[0][1] > _e1617[1][1]));
                                                    let _e1707 = select(_e1617[1][2], _e1617[0][2], (_e1617[0][2] < _e1617[1][2]));
                                                    let _e1711 = select(_e1617[1][2], _e1617[0][2], (_e1617[0][2] > _e1617[1][2]));
                                                    let _e1716 = ((select(_e1617[2][0], _e1691, (_e1691 < _e1617[2][0])) - _e376) * _e379);
                                                    let _e1717 = ((select(_e1617[2][0], _e1695, (_e1695 > _e1617[2][0])) - _e377) * _e379);
                                                    let _e1720 = ((select(_e1617[2][1], _e1699, (_e1699 < _e1617[2][1])) - _e442) * _e445);
                                                    let _e1721 = ((select(_e1617[2][1], _e1703, (_e1703 > _e1617[2][1])) - _e443) * _e445);
                                                    let _e1724 = ((select(_e1617[2][2], _e1707, (_e1707 < _e1617[2][2])) - _e508) * _e511);
                                                    let _e1725 = ((select(_e1617[2][2], _e1711, (_e1711 > _e1617[2][2])) - _e509) * _e511);
                                                    let _e1727 = select(_e1725, _e1724, (_e1724 < _e1725));
                                                    let _e1729 = select(_e1725, _e1724, (_e1724 > _e1725));
                                                    let _e1731 = select(_e1717, _e1716, (_e1716 < _e1717));
                                                    let _e1733 = select(_e1721, _e1720, (_e1720 < _e1721));
                                                    let _e1735 = select(_e1733, _e1731, (_e1731 > _e1733));
                                                    let _e1737 = select(_e1727, _e1735, (_e1735 > _e1727));
                                                    let _e1739 = select(_e1717, _e1716, (_e1716 > _e1717));
                                                    let _e1741 = select(_e1721, _e1720, (_e1720 > _e1721));
                                                    let _e1743 = select(_e1741, _e1739, (_e1739 < _e1741));
                                                    let _e1745 = select(_e1729, _e1743, (_e1743 < _e1729));
                                                    let _e1746 = -(_e1727);
                                                    let _e1752 = select(_e614, _e1737, (_e1737 > _e614));
                                                    let _e1756 = select(_e1644, _e1635, (_e1635 < _e1644));
                                                    let _e1761 = select(_e1644, _e1635, (_e1635 > _e1644));
                                                    let _e1768 = select(_e1647, _e1638, (_e1638 < _e1647));
                                                    let _e1773 = select(_e1647, _e1638, (_e1638 > _e1647));
                                                    let _e1782 = (((((_e1673 && (_e1689 >= 0.000000000000000000000000000000000000011754944f)) && ((select(_e1653, _e1756, (_e1756 < _e1653)) <= 0f) && (select(_e1653, _e1761, (_e1761 > _e1653)) >= 0f))) && ((select(_e1656, _e1768, (_e1768 < _e1656)) <= 0f) && (select(_e1656, _e1773, (_e1773 > _e1656)) >= 0f))) && (_e1752 <= (_e1745 + (select(_e1746, _e1729, (_e1729 > _e1746)) * 0.0000019073523f)))) && (_e1752 <= _e1170));
                                                    if _e1782 {
                                                        let _e1787 = (_e1617[1][0] - _e1617[0][0]);
                                                        let _e1788 = (_e1617[1][1] - _e1617[0][1]);
                                                        let _e1789 = (_e1617[1][2] - _e1617[0][2]);
                                                        let _e1790 = vec3<f32>(_e1787, _e1788, _e1789);
                                                        let _e1791 = (_e1617[2][0] - _e1617[1][0]);
                                                        let _e1792 = (_e1617[2][1] - _e1617[1][1]);
                                                        let _e1793 = (_e1617[2][2] - _e1617[1][2]);
                                                        let _e1794 = vec3<f32>(_e1791, _e1792, _e1793);
                                                        let _e1795 = (_e1617[0][0] - _e1617[2][0]);
                                                        let _e1796 = (_e1617[0][1] - _e1617[2][1]);
                                                        let _e1797 = (_e1617[0][2] - _e1617[2][2]);
                                                        let _e1798 = vec3<f32>(_e1795, _e1796, _e1797);
                                                        let _e1801 = bitcast<f32>((bitcast<u32>(_e1787) & 2147483647u));
                                                        let _e1804 = bitcast<f32>((bitcast<u32>(_e1788) & 2147483647u));
                                                        let _e1806 = select(_e1804, _e1801, (_e1801 > _e1804));
                                                        let _e1809 = bitcast<f32>((bitcast<u32>(_e1789) & 2147483647u));
                                                        let _e1811 = select(_e1809, _e1806, (_e1806 > _e1809));
                                                        let _e1814 = bitcast<f32>((bitcast<u32>(_e1791) & 2147483647u));
                                                        let _e1817 = bitcast<f32>((bitcast<u32>(_e1792) & 2147483647u));
                                                        let _e1819 = select(_e1817, _e1814, (_e1814 > _e1817));
                                                        let _e1822 = bitcast<f32>((bitcast<u32>(_e1793) & 2147483647u));
                                                        let _e1824 = select(_e1822, _e1819, (_e1819 > _e1822));
                                                        let _e1827 = bitcast<f32>((bitcast<u32>(_e1795) & 2147483647u));
                                                        let _e1830 = bitcast<f32>((bitcast<u32>(_e1796) & 2147483647u));
                                                        let _e1832 = select(_e1830, _e1827, (_e1827 > _e1830));
                                                        let _e1835 = bitcast<f32>((bitcast<u32>(_e1797) & 2147483647u));
                                                        let _e1837 = select(_e1835, _e1832, (_e1832 > _e1835));
                                                        let _e1839 = select(_e1824, _e1811, (_e1811 > _e1824));
                                                        let _e1841 = select(_e1837, _e1839, (_e1839 > _e1837));
                                                        if (_e1811 == _e1841) {
                                                            phi_2681_ = _e1647;
                                                            phi_2682_ = _e1644;
                                                            phi_2683_ = _e1638;
                                                            phi_2684_ = _e1635;
                                                            phi_2685_ = vec3<f32>(_e1617[0][0], _e1617[0][1], _e1617[0][2]);
                                                            phi_2686_ = _e1798;
                                                            phi_2687_ = _e1794;
                                                            phi_2688_ = _e1790;
                                                        } else {
                                                            let _e1843 = (_e1824 == _e1841);
                                                            let _e1848 = vec3(_e1843);
                                                            phi_2681_ = select(_e1638, _e1656, _e1843);
                                                            phi_2682_ = select(_e1635, _e1653, _e1843);
                                                            phi_2683_ = select(_e1656, _e1647, _e1843);
                                                            phi_2684_ = select(_e1653, _e1644, _e1843);
                                                            phi_2685_ = select(vec3<f32>(_e1617[2][0], _e1617[2][1], _e1617[2][2]), vec3<f32>(_e1617[1][0], _e1617[1][1], _e1617[1][2]), _e1848);
                                                            phi_2686_ = select(_e1794, _e1790, _e1848);
                                                            phi_2687_ = select(_e1790, _e1798, _e1848);
                                                            phi_2688_ = select(_e1798, _e1794, _e1848);
                                                        }
                                                        let _e1854 = phi_2681_;
                                                        let _e1856 = phi_2682_;
                                                        let _e1858 = phi_2683_;
                                                        let _e1860 = phi_2684_;
                                                        let _e1862 = phi_2685_;
                                                        let _e1864 = phi_2686_;
                                                        let _e1866 = phi_2687_;
                                                        let _e1868 = phi_2688_;
                                                        let _e1875 = ((_e1866.y * _e1864.z) - (_e1864.y * _e1866.z));
                                                        let _e1880 = ((_e1866.z * _e1864.x) - (_e1864.z * _e1866.x));
                                                        let _e1883 = ((_e1866.x * _e1864.y) - (_e1864.x * _e1866.y));
                                                        let _e1886 = ((_e1679 >= _e1683) && (_e1679 >= _e1687));
                                                        let _e1887 = (_e1683 >= _e1687);
                                                        let _e1901 = (((_e1875 * (select(select(_e1617[2][0], _e1617[1][0], _e1887), _e1617[0][0], _e1886) - _e338)) + (_e1880 * (select(select(_e1617[2][1], _e1617[1][1], _e1887), _e1617[0][1], _e1886) - _e405))) + (_e1883 * (select(select(_e1617[2][2], _e1617[1][2], _e1887), _e1617[0][2], _e1886) - _e471)));
                                                        let _e1906 = (((_e1875 * _e375) + (_e1880 * _e441)) + (_e1883 * _e507));
                                                        let _e1907 = (_e1856 - _e1860);
                                                        let _e1908 = (_e1854 - _e1858);
                                                        let _e1911 = ((_e1907 * _e1907) + (_e1908 * _e1908));
                                                        let _e1918 = (-(((_e1860 * _e1907) + (_e1858 * _e1908))) / select(0.000000000000000000000000000000000000011754944f, _e1911, (_e1911 > 0.000000000000000000000000000000000000011754944f)));
                                                        let _e1920 = select(1f, _e1918, (_e1918 < 1f));
                                                        let _e1922 = select(0f, _e1920, (_e1920 > 0f));
                                                        let _e1931 = ((_e1862.x + (_e1868.x * _e1922)) - _e338);
                                                        let _e1934 = ((_e1862.y + (_e1868.y * _e1922)) - _e405);
                                                        let _e1937 = ((_e1862.z + (_e1868.z * _e1922)) - _e471);
                                                        let _e1940 = bitcast<f32>((bitcast<u32>(_e1931) & 2147483647u));
                                                        let _e1943 = bitcast<f32>((bitcast<u32>(_e1934) & 2147483647u));
                                                        let _e1945 = select(_e1943, _e1940, (_e1940 > _e1943));
                                                        let _e1948 = bitcast<f32>((bitcast<u32>(_e1937) & 2147483647u));
                                                        let _e1950 = select(_e1948, _e1945, (_e1945 > _e1948));
                                                        let _e1956 = bitcast<f32>((bitcast<u32>(_e1875) & 2147483647u));
                                                        let _e1959 = bitcast<f32>((bitcast<u32>(_e1880) & 2147483647u));
                                                        let _e1961 = select(_e1959, _e1956, (_e1956 > _e1959));
                                                        let _e1964 = bitcast<f32>((bitcast<u32>(_e1883) & 2147483647u));
                                                        let _e1983 = bitcast<f32>((bitcast<u32>(_e1866.x) & 2147483647u));
                                                        let _e1986 = bitcast<f32>((bitcast<u32>(_e1866.y) & 2147483647u));
                                                        let _e1988 = select(_e1986, _e1983, (_e1983 > _e1986));
                                                        let _e1991 = bitcast<f32>((bitcast<u32>(_e1866.z) & 2147483647u));
                                                        let _e1997 = bitcast<f32>((bitcast<u32>(_e1864.x) & 2147483647u));
                                                        let _e2000 = bitcast<f32>((bitcast<u32>(_e1864.y) & 2147483647u));
                                                        let _e2002 = select(_e2000, _e1997, (_e1997 > _e2000));
                                                        let _e2005 = bitcast<f32>((bitcast<u32>(_e1864.z) & 2147483647u));
                                                        let _e2011 = ((bitcast<f32>((bitcast<u32>(((((_e1875 * _e1931) + (_e1880 * _e1934)) + (_e1883 * _e1937)) - _e1901)) & 2147483647u)) <= ((0.0000009536743f * select(_e1841, _e1950, (_e1950 > _e1841))) * select(_e1964, _e1961, (_e1961 > _e1964)))) && !((bitcast<f32>((bitcast<u32>(_e1906) & 2147483647u)) <= ((0.0000038146973f * select(_e1991, _e1988, (_e1988 > _e1991))) * select(_e2005, _e2002, (_e2002 > _e2005))))));
                                                        let _e2012 = (_e1901 / _e1906);
                                                        if (_e1782 && !(_e2011)) {
                                                            let _e2015 = (_e1937 / _e507);
                                                            let _e2023 = (((_e1875 * (_e1931 - (_e375 * _e2015))) + (_e1880 * (_e1934 - (_e441 * _e2015)))) / _e1906);
                                                            phi_2879_ = select(select(_e2015, (_e2015 + _e2023), (bitcast<f32>((bitcast<u32>(_e2023) & 2147483647u)) <= _e1841)), _e2012, _e2011);
                                                        } else {
                                                            phi_2879_ = _e2012;
                                                        }
                                                        let _e2032 = phi_2879_;
                                                        let _e2034 = select(_e1745, _e2032, (_e2032 < _e1745));
                                                        let _e2036 = select(_e1737, _e2034, (_e2034 > _e1737));
                                                        let _e2037 = (1f / _e1689);
                                                        phi_2899_ = type_35(_e2036, (_e1683 * _e2037), (_e1687 * _e2037), ((_e1782 && (_e2036 >= _e614)) && (_e2036 <= _e1170)));
                                                        phi_2900_ = type_35();
                                                    } else {
                                                        phi_2899_ = type_35();
                                                        phi_2900_ = type_35(0f, 0f, 0f, _e1782);
                                                    }
                                                    let _e2046 = phi_2899_;
                                                    let _e2048 = phi_2900_;
                                                    phi_2903_ = _e2046;
                                                    phi_2904_ = _e2048;
                                                    phi_2905_ = select(true, false, _e1782);
                                                } else {
                                                    phi_2903_ = type_35();
                                                    phi_2904_ = type_35(0f, 0f, 0f, _e1673);
                                                    phi_2905_ = true;
                                                }
                                                let _e2051 = phi_2903_;
                                                let _e2053 = phi_2904_;
                                                let _e2055 = phi_2905_;
                                                if _e2055 {
                                                    phi_2909_ = _e2053;
                                                } else {
                                                    phi_2909_ = _e2051;
                                                }
                                                let _e2057 = phi_2909_;
                                                if _e2057.member_3 {
                                                    phi_2918_ = type_24(_e2057.member, _e2057.member_1, _e2057.member_2, _e1230);
                                                } else {
                                                    phi_2918_ = type_24(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                }
                                                let _e2064 = phi_2918_;
                                                if (_e2064.member_3 != 4294967295u) {
                                                    if (_e1230 != 4294967295u) {
                                                        phi_2930_ = type_8(0u, 8u);
                                                        phi_2933_ = _e2064;
                                                        loop {
                                                            let _e2069 = phi_2930_;
                                                            let _e2071 = phi_2933_;
                                                            if (_e2069.member < _e2069.member_1) {
                                                                phi_2931_ = type_8((_e2069.member + 1u), _e2069.member_1);
                                                                phi_2956_ = type_8(1u, _e2069.member);
                                                            } else {
                                                                phi_2931_ = _e2069;
                                                                phi_2956_ = type_8(0u, type_8().member_1);
                                                            }
                                                            let _e2084 = phi_2931_;
                                                            let _e2086 = phi_2956_;
                                                            let _e2090 = (bitcast<i32>(_e2086.member) != 0i);
                                                            if _e2090 {
                                                                let _e2091 = (_e2086.member_1 < 8u);
                                                                if _e2091 {
                                                                } else {
                                                                    phi_5030_ = true;
                                                                    break;
                                                                }
                                                                let _e2096 = local_9[_e2086.member_1].member;
                                                                if (_e2071.member < _e2096) {
                                                                    phi_2989_ = true;
                                                                } else {
                                                                    let _e2098 = local_9[_e2086.member_1].member;
                                                                    if (_e2071.member == _e2098) {
                                                                        let _e2103 = local_9[_e2086.member_1].member_3;
                                                                        phi_2988_ = (_e2071.member_3 < _e2103);
                                                                    } else {
                                                                        phi_2988_ = false;
                                                                    }
                                                                    let _e2106 = phi_2988_;
                                                                    phi_2989_ = _e2106;
                                                                }
                                                                let _e2108 = phi_2989_;
                                                                if _e2108 {
                                                                    if _e2091 {
                                                                    } else {
                                                                        phi_5030_ = true;
                                                                        break;
                                                                    }
                                                                    let _e2109 = local_9[_e2086.member_1];
                                                                    local_9[_e2086.member_1] = type_24(_e2071.member, _e2071.member_1, _e2071.member_2, _e2071.member_3);
                                                                    phi_3010_ = type_24(_e2109.member, _e2109.member_1, _e2109.member_2, _e2109.member_3);
                                                                } else {
                                                                    phi_3010_ = _e2071;
                                                                }
                                                                let _e2120 = phi_3010_;
                                                                phi_2934_ = _e2120;
                                                            } else {
                                                                phi_2934_ = type_24();
                                                            }
                                                            let _e2122 = phi_2934_;
                                                            continue;
                                                            continuing {
                                                                phi_2930_ = _e2084;
                                                                phi_2933_ = _e2122;
                                                                phi_5030_ = _e1168;
                                                                break if !(_e2090);
                                                            }
                                                        }
                                                        let _e2125 = phi_5030_;
                                                        phi_5235_ = _e1170;
                                                        phi_5230_ = _e2125;
                                                        if _e2125 {
                                                            break;
                                                        }
                                                        let _e2128 = local_9[7u].member_3;
                                                        if (_e2128 != 4294967295u) {
                                                            let _e2132 = local_9[7u].member;
                                                            phi_5319_ = _e2132;
                                                        } else {
                                                            phi_5319_ = _e1170;
                                                        }
                                                        let _e2134 = phi_5319_;
                                                        phi_5318_ = _e2134;
                                                        phi_5233_ = _e2125;
                                                    } else {
                                                        phi_5318_ = _e1170;
                                                        phi_5233_ = _e1168;
                                                    }
                                                    let _e2136 = phi_5318_;
                                                    let _e2138 = phi_5233_;
                                                    phi_5317_ = _e2136;
                                                    phi_5232_ = _e2138;
                                                } else {
                                                    phi_5317_ = _e1170;
                                                    phi_5232_ = _e1168;
                                                }
                                                let _e2140 = phi_5317_;
                                                let _e2142 = phi_5232_;
                                                phi_5316_ = _e2140;
                                                phi_5231_ = _e2142;
                                            } else {
                                                phi_5316_ = _e1170;
                                                phi_5231_ = _e1168;
                                            }
                                            let _e2144 = phi_5316_;
                                            let _e2146 = phi_5231_;
                                            continue;
                                            continuing {
                                                phi_5060_ = _e2146;
                                                phi_5002_ = _e2144;
                                                phi_1388_ = _e1185;
                                                phi_5235_ = _e2144;
                                                phi_5230_ = _e2146;
                                                break if !(_e1191);
                                            }
                                        }
                                        let _e2149 = phi_5235_;
                                        let _e2151 = phi_5230_;
                                        phi_5320_ = _e2151;
                                        if _e2151 {
                                            break;
                                        }
                                        phi_5439_ = _e2149;
                                        phi_5324_ = _e2151;
                                        phi_4285_ = false;
                                        phi_4286_ = _e697;
                                        phi_4287_ = select(_e699, 0u, (_e614 > _e2149));
                                    } else {
                                        if (_e697.member_1 >= _e103) {
                                            phi_3823_ = type_53(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), type_52(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u), type_52(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u));
                                        } else {
                                            if (_e697.member_1 < _e103) {
                                            } else {
                                                phi_5320_ = true;
                                                break;
                                            }
                                            let _e712 = ((1u + _e274) % 4u);
                                            if (_e712 < 4u) {
                                            } else {
                                                phi_5320_ = true;
                                                break;
                                            }
                                            let _e717 = global_3.member[_e697.member_1][_e712];
                                            let _e719 = (_e717 >> bitcast<u32>(11u));
                                            let _e721 = ((1u + _e273) % 4u);
                                            if (_e721 < 4u) {
                                            } else {
                                                phi_5320_ = true;
                                                break;
                                            }
                                            let _e726 = global_3.member[_e697.member_1][_e721];
                                            let _e728 = (_e726 >> bitcast<u32>(11u));
                                            let _e730 = ((1u + _e275) % 4u);
                                            if (_e730 < 4u) {
                                            } else {
                                                phi_5320_ = true;
                                                break;
                                            }
                                            let _e735 = global_3.member[_e697.member_1][_e730];
                                            let _e737 = (_e735 >> bitcast<u32>(11u));
                                            let _e760 = (bitcast<f32>((bitcast<u32>((_e697.member.member_1.x - _e697.member.member.x)) & 2139095040u)) * 0.001953125f);
                                            let _e761 = (bitcast<f32>((bitcast<u32>((_e697.member.member_1.y - _e697.member.member.y)) & 2139095040u)) * 0.001953125f);
                                            let _e762 = (bitcast<f32>((bitcast<u32>((_e697.member.member_1.z - _e697.member.member.z)) & 2139095040u)) * 0.001953125f);
                                            let _e764 = select(_e154, _e760, (_e760 > _e154));
                                            let _e766 = select(_e154, _e761, (_e761 > _e154));
                                            let _e768 = select(_e154, _e762, (_e762 > _e154));
                                            let _e799 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e717 & 1023u))) - 8388608f) * _e764));
                                            let _e804 = (bitcast<i32>((_e717 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e807 = bitcast<f32>((_e799 & bitcast<u32>(_e804)));
                                            let _e808 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e726 & 1023u))) - 8388608f) * _e766));
                                            let _e813 = (bitcast<i32>((_e726 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e816 = bitcast<f32>((_e808 & bitcast<u32>(_e813)));
                                            let _e817 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e735 & 1023u))) - 8388608f) * _e768));
                                            let _e822 = (bitcast<i32>((_e735 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e825 = bitcast<f32>((_e817 & bitcast<u32>(_e822)));
                                            let _e829 = bitcast<f32>((_e799 & bitcast<u32>(~(_e804))));
                                            let _e833 = bitcast<f32>((_e808 & bitcast<u32>(~(_e813))));
                                            let _e837 = bitcast<f32>((_e817 & bitcast<u32>(~(_e822))));
                                            let _e838 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e719 & 1023u))) - 8388608f) * _e764));
                                            let _e843 = (bitcast<i32>((_e719 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e846 = bitcast<f32>((_e838 & bitcast<u32>(_e843)));
                                            let _e847 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e728 & 1023u))) - 8388608f) * _e766));
                                            let _e852 = (bitcast<i32>((_e728 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e855 = bitcast<f32>((_e847 & bitcast<u32>(_e852)));
                                            let _e856 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e737 & 1023u))) - 8388608f) * _e768));
                                            let _e861 = (bitcast<i32>((_e737 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e864 = bitcast<f32>((_e856 & bitcast<u32>(_e861)));
                                            let _e868 = bitcast<f32>((_e838 & bitcast<u32>(~(_e843))));
                                            let _e872 = bitcast<f32>((_e847 & bitcast<u32>(~(_e852))));
                                            let _e876 = bitcast<f32>((_e856 & bitcast<u32>(~(_e861))));
                                            let _e877 = (_e697.member.member.x + _e807);
                                            let _e878 = (_e697.member.member.y + _e816);
                                            let _e879 = (_e697.member.member.z + _e825);
                                            let _e882 = (_e697.member.member_1.x - _e846);
                                            let _e883 = (_e697.member.member_1.y - _e855);
                                            let _e884 = (_e697.member.member_1.z - _e864);
                                            let _e903 = (_e882 - _e877);
                                            let _e904 = (_e883 - _e878);
                                            let _e905 = (_e884 - _e879);
                                            let _e907 = select(_e904, _e903, (_e903 > _e904));
                                            let _e909 = select(_e905, _e907, (_e907 > _e905));
                                            if (_e909 < (1024f * _e154)) {
                                                phi_3524_ = 0u;
                                            } else {
                                                phi_3524_ = select(2u, 1u, (_e909 < (2097152f * _e154)));
                                            }
                                            let _e916 = phi_3524_;
                                            switch bitcast<i32>(_e916) {
                                                case 0: {
                                                    phi_3530_ = 1u;
                                                    break;
                                                }
                                                case 1: {
                                                    phi_3530_ = 2u;
                                                    break;
                                                }
                                                case 2: {
                                                    phi_3530_ = 3u;
                                                    break;
                                                }
                                                default: {
                                                    phi_3530_ = u32();
                                                    break;
                                                }
                                            }
                                            let _e919 = phi_3530_;
                                            let _e925 = global_3.member[_e697.member_1][0u];
                                            let _e929 = global_3.member[_e697.member_1][1u];
                                            let _e933 = global_3.member[_e697.member_1][2u];
                                            let _e937 = global_3.member[_e697.member_1][3u];
                                            let _e949 = (((_e929 >> bitcast<u32>(22i)) | ((_e933 >> bitcast<u32>(22i)) << bitcast<u32>(10i))) | ((_e937 >> bitcast<u32>(22i)) << bitcast<u32>(20i)));
                                            let _e950 = (_e925 & 268435455u);
                                            let _e951 = (_e949 & 268435455u);
                                            let _e954 = ((_e925 >> bitcast<u32>(28u)) & 7u);
                                            let _e962 = ((_e925 >> bitcast<u32>(31i)) | (((_e949 >> bitcast<u32>(28u)) & 3u) << bitcast<u32>(1i)));
                                            let _e963 = (_e954 != 0u);
                                            if (_e954 == 0u) {
                                                phi_3785_ = _e950;
                                            } else {
                                                if (_e954 == 7u) {
                                                    phi_3784_ = 2147483648u;
                                                } else {
                                                    phi_3784_ = ((2147483648u | (_e954 << bitcast<u32>(28u))) | (_e951 & 268435455u));
                                                }
                                                let _e972 = phi_3784_;
                                                phi_3785_ = _e972;
                                            }
                                            let _e974 = phi_3785_;
                                            if _e963 {
                                                let _e975 = (_e954 != 7u);
                                                if _e975 {
                                                    phi_3795_ = (_e951 + (_e954 * ((3u * _e919) + 1u)));
                                                } else {
                                                    phi_3795_ = u32();
                                                }
                                                let _e979 = phi_3795_;
                                                phi_3797_ = _e979;
                                                phi_3798_ = select(true, false, _e975);
                                            } else {
                                                phi_3797_ = u32();
                                                phi_3798_ = true;
                                            }
                                            let _e982 = phi_3797_;
                                            let _e984 = phi_3798_;
                                            if (_e962 == 0u) {
                                                phi_3819_ = (_e950 + select(0u, 1u, !(_e963)));
                                            } else {
                                                if (_e962 == 7u) {
                                                    phi_3818_ = 2147483648u;
                                                } else {
                                                    phi_3818_ = ((2147483648u | (_e962 << bitcast<u32>(28u))) | (select(_e982, _e951, _e984) & 268435455u));
                                                }
                                                let _e997 = phi_3818_;
                                                phi_3819_ = _e997;
                                            }
                                            let _e999 = phi_3819_;
                                            phi_3823_ = type_53(array<vec4<f32>, 3>(vec4<f32>(_e877, (_e697.member.member.x + _e829), _e882, (_e697.member.member_1.x - _e868)), vec4<f32>(_e878, (_e697.member.member.y + _e833), _e883, (_e697.member.member_1.y - _e872)), vec4<f32>(_e879, (_e697.member.member.z + _e837), _e884, (_e697.member.member_1.z - _e876))), type_52(type_28((_e697.member.member + vec4<f32>(_e807, _e816, _e825, 0f)), (_e697.member.member_1 - vec4<f32>(_e846, _e855, _e864, 0f))), _e974), type_52(type_28((_e697.member.member + vec4<f32>(_e829, _e833, _e837, 0f)), (_e697.member.member_1 - vec4<f32>(_e868, _e872, _e876, 0f))), _e999));
                                        }
                                        let _e1004 = phi_3823_;
                                        let _e1015 = ((_e1004.member[0].x - _e376) * _e379);
                                        let _e1016 = ((_e1004.member[0].y - _e376) * _e379);
                                        let _e1017 = ((_e1004.member[0].z - _e377) * _e379);
                                        let _e1018 = ((_e1004.member[0].w - _e377) * _e379);
                                        let _e1028 = ((_e1004.member[1].x - _e442) * _e445);
                                        let _e1029 = ((_e1004.member[1].y - _e442) * _e445);
                                        let _e1030 = ((_e1004.member[1].z - _e443) * _e445);
                                        let _e1031 = ((_e1004.member[1].w - _e443) * _e445);
                                        let _e1041 = ((_e1004.member[2].x - _e508) * _e511);
                                        let _e1042 = ((_e1004.member[2].y - _e508) * _e511);
                                        let _e1043 = ((_e1004.member[2].z - _e509) * _e511);
                                        let _e1044 = ((_e1004.member[2].w - _e509) * _e511);
                                        let _e1046 = select(_e1043, _e1041, (_e1041 < _e1043));
                                        let _e1048 = select(_e1044, _e1042, (_e1042 < _e1044));
                                        let _e1050 = select(_e1043, _e1041, (_e1041 > _e1043));
                                        let _e1052 = select(_e1044, _e1042, (_e1042 > _e1044));
                                        let _e1054 = select(_e1017, _e1015, (_e1015 < _e1017));
                                        let _e1056 = select(_e1018, _e1016, (_e1016 < _e1018));
                                        let _e1058 = select(_e1030, _e1028, (_e1028 < _e1030));
                                        let _e1060 = select(_e1031, _e1029, (_e1029 < _e1031));
                                        let _e1062 = select(_e1058, _e1054, (_e1054 > _e1058));
                                        let _e1064 = select(_e1060, _e1056, (_e1056 > _e1060));
                                        let _e1066 = select(_e1046, _e1062, (_e1062 > _e1046));
                                        let _e1068 = select(_e1048, _e1064, (_e1064 > _e1048));
                                        let _e1070 = select(_e1017, _e1015, (_e1015 > _e1017));
                                        let _e1072 = select(_e1018, _e1016, (_e1016 > _e1018));
                                        let _e1074 = select(_e1030, _e1028, (_e1028 > _e1030));
                                        let _e1076 = select(_e1031, _e1029, (_e1029 > _e1031));
                                        let _e1078 = select(_e1074, _e1070, (_e1070 < _e1074));
                                        let _e1080 = select(_e1076, _e1072, (_e1072 < _e1076));
                                        let _e1085 = -(_e1046);
                                        let _e1086 = -(_e1048);
                                        let _e1093 = (select(_e1050, _e1078, (_e1078 < _e1050)) + (select(_e1085, _e1050, (_e1050 > _e1085)) * 0.0000019073523f));
                                        let _e1094 = (select(_e1052, _e1080, (_e1080 < _e1052)) + (select(_e1086, _e1052, (_e1052 > _e1086)) * 0.0000019073523f));
                                        let _e1096 = select(_e614, _e1066, (_e1066 > _e614));
                                        let _e1098 = select(_e614, _e1068, (_e1068 > _e614));
                                        let _e1103 = (_e1096 <= select(_e657, _e1093, (_e1093 < _e657)));
                                        let _e1104 = (_e1098 <= select(_e657, _e1094, (_e1094 < _e657)));
                                        let _e1105 = (_e1096 <= _e1098);
                                        if _e1103 {
                                            if _e1104 {
                                                if _e1105 {
                                                    phi_4186_ = _e1004.member_2;
                                                } else {
                                                    phi_4186_ = _e1004.member_1;
                                                }
                                                let _e1109 = phi_4186_;
                                                let _e1130 = (_e699 % 128u);
                                                let _e1131 = (_e1130 < 128u);
                                                if _e1131 {
                                                } else {
                                                    phi_5320_ = true;
                                                    break;
                                                }
                                                local_8[_e1130] = _e1109.member_1;
                                                if _e1131 {
                                                } else {
                                                    phi_5320_ = true;
                                                    break;
                                                }
                                                local_7[_e1130] = _e1109.member.member.x;
                                                if _e1131 {
                                                } else {
                                                    phi_5320_ = true;
                                                    break;
                                                }
                                                local_6[_e1130] = _e1109.member.member.y;
                                                if _e1131 {
                                                } else {
                                                    phi_5320_ = true;
                                                    break;
                                                }
                                                local_5[_e1130] = _e1109.member.member.z;
                                                if _e1131 {
                                                } else {
                                                    phi_5320_ = true;
                                                    break;
                                                }
                                                local_4[_e1130] = _e1109.member.member_1.x;
                                                if _e1131 {
                                                } else {
                                                    phi_5320_ = true;
                                                    break;
                                                }
                                                local_3[_e1130] = _e1109.member.member_1.y;
                                                if _e1131 {
                                                } else {
                                                    phi_5320_ = true;
                                                    break;
                                                }
                                                local_2[_e1130] = _e1109.member.member_1.z;
                                                if _e1131 {
                                                } else {
                                                    phi_5320_ = true;
                                                    break;
                                                }
                                                local_10[_e1130] = select(_e1096, _e1098, _e1105);
                                                if _e1105 {
                                                    phi_4262_ = _e1004.member_1;
                                                } else {
                                                    phi_4262_ = _e1004.member_2;
                                                }
                                                let _e1144 = phi_4262_;
                                                phi_4263_ = _e1144;
                                                phi_4264_ = (_e699 + 1u);
                                            } else {
                                                phi_4263_ = type_52();
                                                phi_4264_ = u32();
                                            }
                                            let _e1146 = phi_4263_;
                                            let _e1148 = phi_4264_;
                                            phi_4266_ = _e1146;
                                            phi_4267_ = _e1148;
                                            phi_4268_ = select(true, false, _e1104);
                                        } else {
                                            phi_4266_ = type_52();
                                            phi_4267_ = u32();
                                            phi_4268_ = true;
                                        }
                                        let _e1151 = phi_4266_;
                                        let _e1153 = phi_4267_;
                                        let _e1155 = phi_4268_;
                                        if _e1155 {
                                            if _e1103 {
                                                phi_4277_ = _e1004.member_1;
                                            } else {
                                                phi_4277_ = _e1004.member_2;
                                            }
                                            let _e1159 = phi_4277_;
                                            phi_4282_ = select(_e1104, true, _e1103);
                                            phi_4283_ = _e1159;
                                        } else {
                                            phi_4282_ = _e695;
                                            phi_4283_ = _e1151;
                                        }
                                        let _e1162 = phi_4282_;
                                        let _e1164 = phi_4283_;
                                        phi_5439_ = _e657;
                                        phi_5324_ = _e655;
                                        phi_4285_ = _e1162;
                                        phi_4286_ = _e1164;
                                        phi_4287_ = select(_e1153, _e699, _e1155);
                                    }
                                    let _e2155 = phi_5439_;
                                    let _e2157 = phi_5324_;
                                    let _e2159 = phi_4285_;
                                    let _e2161 = phi_4286_;
                                    let _e2163 = phi_4287_;
                                    phi_5438_ = _e2155;
                                    phi_5323_ = _e2157;
                                    phi_4288_ = _e2159;
                                    phi_4289_ = _e2161;
                                    phi_4290_ = _e2163;
                                    phi_4291_ = (_e665 - 1u);
                                } else {
                                    phi_5438_ = _e657;
                                    phi_5323_ = _e655;
                                    phi_4288_ = _e695;
                                    phi_4289_ = _e697;
                                    phi_4290_ = _e699;
                                    phi_4291_ = _e665;
                                }
                                let _e2165 = phi_5438_;
                                let _e2167 = phi_5323_;
                                let _e2169 = phi_4288_;
                                let _e2171 = phi_4289_;
                                let _e2173 = phi_4290_;
                                let _e2175 = phi_4291_;
                                phi_5437_ = _e2165;
                                phi_5322_ = _e2167;
                                phi_4292_ = _e2169;
                                phi_4293_ = _e2171;
                                phi_4294_ = _e2173;
                                phi_4295_ = _e2175;
                            } else {
                                phi_5437_ = _e657;
                                phi_5322_ = _e655;
                                phi_4292_ = bool();
                                phi_4293_ = type_52();
                                phi_4294_ = u32();
                                phi_4295_ = u32();
                            }
                            let _e2177 = phi_5437_;
                            let _e2179 = phi_5322_;
                            let _e2181 = phi_4292_;
                            let _e2183 = phi_4293_;
                            let _e2185 = phi_4294_;
                            let _e2187 = phi_4295_;
                            phi_5436_ = _e2177;
                            phi_5321_ = _e2179;
                            phi_1263_ = _e2181;
                            phi_1266_ = _e2183;
                            phi_1268_ = _e2185;
                            phi_1270_ = _e2187;
                            phi_4296_ = _e669;
                        } else {
                            phi_5436_ = _e657;
                            phi_5321_ = _e655;
                            phi_1263_ = bool();
                            phi_1266_ = type_52();
                            phi_1268_ = u32();
                            phi_1270_ = u32();
                            phi_4296_ = false;
                        }
                        let _e2189 = phi_5436_;
                        let _e2191 = phi_5321_;
                        let _e2193 = phi_1263_;
                        let _e2195 = phi_1266_;
                        let _e2197 = phi_1268_;
                        let _e2199 = phi_1270_;
                        let _e2201 = phi_4296_;
                        continue;
                        continuing {
                            phi_5063_ = _e2191;
                            phi_4918_ = _e2189;
                            phi_1262_ = _e2193;
                            phi_1265_ = _e2195;
                            phi_1267_ = _e2197;
                            phi_1269_ = _e2199;
                            phi_5320_ = _e2191;
                            break if !(_e2201);
                        }
                    }
                    let _e2204 = phi_5320_;
                    if _e2204 {
                        break;
                    }
                    phi_4303_ = type_8(0u, 8u);
                    loop {
                        let _e2206 = phi_4303_;
                        if (_e2206.member < _e2206.member_1) {
                            phi_4304_ = type_8((_e2206.member + 1u), _e2206.member_1);
                            phi_4327_ = type_8(1u, _e2206.member);
                        } else {
                            phi_4304_ = _e2206;
                            phi_4327_ = type_8(0u, type_8().member_1);
                        }
                        let _e2219 = phi_4304_;
                        let _e2221 = phi_4327_;
                        let _e2225 = (bitcast<i32>(_e2221.member) != 0i);
                        if _e2225 {
                            let _e2226 = (_e2221.member_1 < 8u);
                            if _e2226 {
                            } else {
                                phi_5418_ = true;
                                break;
                            }
                            let _e2228 = local_9[_e2221.member_1];
                            if (_e2228.member_3 != 4294967295u) {
                                let _e2234 = -(_e516);
                                let _e2235 = bitcast<u32>(_e2228.member);
                                let _e2239 = (bitcast<i32>((_e2235 >> bitcast<u32>(23i))) & 255i);
                                let _e2240 = (_e2239 + _e2234);
                                if (_e2239 == 255i) {
                                    phi_4400_ = _e2228.member;
                                } else {
                                    if (_e2239 > 0i) {
                                        if (_e2240 > 0i) {
                                            let _e2244 = (_e2240 < 255i);
                                            if _e2244 {
                                                phi_4379_ = bitcast<f32>((_e2235 + bitcast<u32>((_e2234 << bitcast<u32>(23i)))));
                                            } else {
                                                phi_4379_ = f32();
                                            }
                                            let _e2251 = phi_4379_;
                                            phi_4381_ = _e2251;
                                            phi_4382_ = select(true, false, _e2244);
                                        } else {
                                            phi_4381_ = f32();
                                            phi_4382_ = true;
                                        }
                                        let _e2254 = phi_4381_;
                                        let _e2256 = phi_4382_;
                                        phi_4383_ = _e2254;
                                        phi_4384_ = _e2256;
                                    } else {
                                        phi_4383_ = f32();
                                        phi_4384_ = true;
                                    }
                                    let _e2258 = phi_4383_;
                                    let _e2260 = phi_4384_;
                                    if _e2260 {
                                        let _e2261 = (_e2235 & 2147483648u);
                                        let _e2268 = ((_e2235 & 8388607u) | (select(0u, 1u, ((_e2235 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                                        let _e2272 = (_e2268 == 0u);
                                        if _e2272 {
                                            phi_4865_ = bitcast<f32>(_e2261);
                                        } else {
                                            let _e2277 = (select((bitcast<u32>(31i) - firstLeadingBit(_e2268)), 32u, _e2272) - 8u);
                                            let _e2280 = (_e2268 << bitcast<u32>((_e2277 & 31u)));
                                            let _e2282 = ((_e2240 + select(0i, 1i, (_e2239 == 0i))) - bitcast<i32>(_e2277));
                                            if (_e2282 >= 255i) {
                                                phi_4855_ = bitcast<f32>((_e2261 | 2139095040u));
                                                phi_4856_ = f32();
                                                phi_4857_ = true;
                                            } else {
                                                let _e2284 = (_e2282 > 0i);
                                                if _e2284 {
                                                    phi_4849_ = bitcast<f32>(((_e2261 | (bitcast<u32>(_e2282) << bitcast<u32>(23i))) | (_e2280 & 8388607u)));
                                                    phi_4850_ = f32();
                                                } else {
                                                    if (_e2282 < -24i) {
                                                        phi_4815_ = 26u;
                                                    } else {
                                                        phi_4815_ = bitcast<u32>((1i - _e2282));
                                                    }
                                                    let _e2289 = phi_4815_;
                                                    let _e2290 = (_e2289 & 31u);
                                                    let _e2292 = (_e2280 >> bitcast<u32>(_e2290));
                                                    let _e2296 = (_e2280 & ((1u << bitcast<u32>(_e2290)) - 1u));
                                                    let _e2300 = (1u << bitcast<u32>(((_e2289 - 1u) & 31u)));
                                                    if (_e2296 > _e2300) {
                                                        phi_4836_ = true;
                                                    } else {
                                                        if (_e2296 == _e2300) {
                                                            phi_4833_ = ((_e2292 & 1u) == 1u);
                                                        } else {
                                                            phi_4833_ = false;
                                                        }
                                                        let _e2306 = phi_4833_;
                                                        phi_4836_ = _e2306;
                                                    }
                                                    let _e2308 = phi_4836_;
                                                    phi_4849_ = f32();
                                                    phi_4850_ = bitcast<f32>((_e2261 | (_e2292 + select(0u, 1u, _e2308))));
                                                }
                                                let _e2321 = phi_4849_;
                                                let _e2323 = phi_4850_;
                                                phi_4855_ = _e2321;
                                                phi_4856_ = _e2323;
                                                phi_4857_ = _e2284;
                                            }
                                            let _e2327 = phi_4855_;
                                            let _e2329 = phi_4856_;
                                            let _e2331 = phi_4857_;
                                            phi_4865_ = select(_e2329, _e2327, _e2331);
                                        }
                                        let _e2335 = phi_4865_;
                                        phi_4399_ = _e2335;
                                    } else {
                                        phi_4399_ = _e2258;
                                    }
                                    let _e2337 = phi_4399_;
                                    phi_4400_ = _e2337;
                                }
                                let _e2339 = phi_4400_;
                                let _e2340 = bitcast<u32>(_e2339);
                                if ((_e2340 & 2147483647u) >= 2139095040u) {
                                    phi_4412_ = bitcast<f32>(((_e2340 & 2147483648u) | 2139095039u));
                                } else {
                                    phi_4412_ = _e2339;
                                }
                                let _e2347 = phi_4412_;
                                phi_4417_ = type_24(_e2347, _e2228.member_1, _e2228.member_2, _e2228.member_3);
                            } else {
                                phi_4417_ = type_24(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                            }
                            let _e2350 = phi_4417_;
                            if _e2226 {
                            } else {
                                phi_5418_ = true;
                                break;
                            }
                            local_9[_e2221.member_1] = type_24(_e2350.member, _e2350.member_1, _e2350.member_2, _e2350.member_3);
                        }
                        continue;
                        continuing {
                            phi_4303_ = _e2219;
                            phi_5418_ = _e2204;
                            break if !(_e2225);
                        }
                    }
                    let _e2358 = phi_5418_;
                    if _e2358 {
                        break;
                    }
                    let _e2359 = local_9;
                    if _e162 {
                    } else {
                        break;
                    }
                    global_6.member[_e160] = array<type_24, 8>(type_24(_e2359[0].member, _e2359[0].member_1, _e2359[0].member_2, _e2359[0].member_3), type_24(_e2359[1].member, _e2359[1].member_1, _e2359[1].member_2, _e2359[1].member_3), type_24(_e2359[2].member, _e2359[2].member_1, _e2359[2].member_2, _e2359[2].member_3), type_24(_e2359[3].member, _e2359[3].member_1, _e2359[3].member_2, _e2359[3].member_3), type_24(_e2359[4].member, _e2359[4].member_1, _e2359[4].member_2, _e2359[4].member_3), type_24(_e2359[5].member, _e2359[5].member_1, _e2359[5].member_2, _e2359[5].member_3), type_24(_e2359[6].member, _e2359[6].member_1, _e2359[6].member_2, _e2359[6].member_3), type_24(_e2359[7].member, _e2359[7].member_1, _e2359[7].member_2, _e2359[7].member_3));
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn trace_nearest_q10_lattice(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
