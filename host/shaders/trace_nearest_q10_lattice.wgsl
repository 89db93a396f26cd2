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
    var phi_513_: i32;
    var phi_514_: i32;
    var phi_524_: bool;
    var phi_534_: u32;
    var phi_535_: u32;
    var phi_537_: bool;
    var phi_542_: u32;
    var phi_555_: i32;
    var phi_575_: i32;
    var phi_593_: f32;
    var phi_599_: f32;
    var phi_639_: f32;
    var phi_645_: f32;
    var phi_718_: f32;
    var phi_724_: f32;
    var phi_764_: f32;
    var phi_770_: f32;
    var phi_843_: f32;
    var phi_849_: f32;
    var phi_889_: f32;
    var phi_895_: f32;
    var phi_1014_: i32;
    var phi_1036_: u32;
    var phi_1037_: u32;
    var phi_1074_: i32;
    var phi_1096_: u32;
    var phi_1097_: u32;
    var phi_1105_: f32;
    var phi_1106_: f32;
    var phi_5075_: bool;
    var phi_4988_: f32;
    var phi_1255_: u32;
    var phi_1258_: bool;
    var phi_1260_: u32;
    var phi_1262_: type_52;
    var phi_1273_: bool;
    var phi_1360_: bool;
    var phi_1361_: u32;
    var phi_1362_: type_52;
    var phi_5072_: bool;
    var phi_5013_: f32;
    var phi_1381_: type_8;
    var phi_1382_: type_8;
    var phi_1405_: type_8;
    var phi_1446_: u32;
    var phi_1452_: u32;
    var phi_1462_: u32;
    var phi_1478_: u32;
    var phi_1511_: u32;
    var phi_1517_: u32;
    var phi_1983_: u32;
    var phi_2001_: u32;
    var phi_2019_: u32;
    var phi_2042_: u32;
    var phi_2060_: u32;
    var phi_2078_: u32;
    var phi_2101_: u32;
    var phi_2119_: u32;
    var phi_2137_: u32;
    var phi_1691_: u32;
    var phi_1706_: u32;
    var phi_1716_: u32;
    var phi_1737_: u32;
    var phi_1758_: u32;
    var phi_1788_: u32;
    var phi_1803_: u32;
    var phi_1813_: u32;
    var phi_1834_: u32;
    var phi_1855_: u32;
    var phi_1885_: u32;
    var phi_1900_: u32;
    var phi_1910_: u32;
    var phi_1931_: u32;
    var phi_1952_: u32;
    var phi_1544_: u32;
    var phi_1593_: u32;
    var phi_1642_: u32;
    var phi_2143_: array<array<f32, 3>, 3>;
    var phi_4544_: bool;
    var phi_4559_: bool;
    var phi_4574_: bool;
    var phi_4589_: bool;
    var phi_4604_: bool;
    var phi_4619_: bool;
    var phi_2686_: f32;
    var phi_2687_: f32;
    var phi_2688_: f32;
    var phi_2689_: f32;
    var phi_2690_: vec3<f32>;
    var phi_2691_: vec3<f32>;
    var phi_2692_: vec3<f32>;
    var phi_2693_: vec3<f32>;
    var phi_4634_: bool;
    var phi_4649_: bool;
    var phi_4664_: bool;
    var phi_4679_: bool;
    var phi_4694_: bool;
    var phi_4709_: bool;
    var phi_2901_: f32;
    var phi_2921_: type_35;
    var phi_2922_: type_35;
    var phi_2925_: type_35;
    var phi_2926_: type_35;
    var phi_2927_: bool;
    var phi_2931_: type_35;
    var phi_2940_: type_24;
    var phi_2952_: type_8;
    var phi_2955_: type_24;
    var phi_2953_: type_8;
    var phi_2978_: type_8;
    var phi_3010_: bool;
    var phi_3011_: bool;
    var phi_3032_: type_24;
    var phi_2956_: type_24;
    var phi_5042_: bool;
    var phi_5413_: f32;
    var phi_5412_: f32;
    var phi_5257_: bool;
    var phi_5411_: f32;
    var phi_5256_: bool;
    var phi_5410_: f32;
    var phi_5255_: bool;
    var phi_5317_: f32;
    var phi_5254_: bool;
    var phi_5506_: bool;
    var phi_5316_: f32;
    var phi_3545_: u32;
    var phi_3551_: u32;
    var phi_3805_: u32;
    var phi_3806_: u32;
    var phi_3816_: u32;
    var phi_3818_: u32;
    var phi_3819_: bool;
    var phi_3839_: u32;
    var phi_3840_: u32;
    var phi_3844_: type_53;
    var phi_4207_: type_52;
    var phi_4283_: type_52;
    var phi_4284_: u32;
    var phi_4285_: type_52;
    var phi_4287_: u32;
    var phi_4288_: type_52;
    var phi_4289_: bool;
    var phi_4298_: type_52;
    var phi_4303_: bool;
    var phi_4305_: type_52;
    var phi_4309_: bool;
    var phi_4310_: u32;
    var phi_4311_: type_52;
    var phi_4321_: type_52;
    var phi_5534_: f32;
    var phi_5418_: bool;
    var phi_4322_: u32;
    var phi_4323_: bool;
    var phi_4324_: u32;
    var phi_4325_: type_52;
    var phi_5533_: f32;
    var phi_5417_: bool;
    var phi_4326_: u32;
    var phi_4327_: bool;
    var phi_4328_: u32;
    var phi_4329_: type_52;
    var phi_5532_: f32;
    var phi_5416_: bool;
    var phi_1256_: u32;
    var phi_1259_: bool;
    var phi_1261_: u32;
    var phi_1263_: type_52;
    var phi_4330_: bool;
    var phi_5415_: bool;
    var phi_4337_: type_8;
    var phi_4338_: type_8;
    var phi_4361_: type_8;
    var phi_4413_: f32;
    var phi_4415_: f32;
    var phi_4416_: bool;
    var phi_4417_: f32;
    var phi_4418_: bool;
    var phi_4885_: u32;
    var phi_4903_: bool;
    var phi_4906_: bool;
    var phi_4919_: f32;
    var phi_4920_: f32;
    var phi_4925_: f32;
    var phi_4926_: f32;
    var phi_4927_: bool;
    var phi_4935_: f32;
    var phi_4433_: f32;
    var phi_4434_: f32;
    var phi_4446_: f32;
    var phi_4451_: type_24;
    var phi_5514_: bool;

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
                            phi_513_ = (bitcast<i32>((_e239 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_513_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e239)), 32u, (_e239 == 0u))));
                        }
                        let _e253 = phi_513_;
                        phi_514_ = _e253;
                    } else {
                        phi_514_ = 0i;
                    }
                    let _e255 = phi_514_;
                    let _e256 = (_e172 == _e211);
                    if _e256 {
                        phi_524_ = true;
                    } else {
                        phi_524_ = (_e179 == _e211);
                    }
                    let _e259 = phi_524_;
                    let _e260 = select(1u, 0u, _e256);
                    if _e259 {
                        let _e261 = (_e260 + 1u);
                        phi_534_ = _e261;
                        phi_535_ = _e261;
                        phi_537_ = select(true, false, (_e261 == 2u));
                    } else {
                        phi_534_ = u32();
                        phi_535_ = 0u;
                        phi_537_ = true;
                    }
                    let _e265 = phi_534_;
                    let _e267 = phi_535_;
                    let _e269 = phi_537_;
                    if _e269 {
                        phi_542_ = (_e267 + 1u);
                    } else {
                        phi_542_ = 0u;
                    }
                    let _e273 = phi_542_;
                    let _e274 = select(_e265, _e267, _e269);
                    let _e275 = select(_e260, select(2u, _e260, _e259), _e269);
                    if (_e142 < -126i) {
                        phi_555_ = -126i;
                    } else {
                        phi_555_ = select(_e142, 127i, (_e142 > 127i));
                    }
                    let _e280 = phi_555_;
                    let _e285 = bitcast<f32>((bitcast<u32>((_e280 + 127i)) << bitcast<u32>(23i)));
                    let _e291 = bitcast<f32>((bitcast<u32>(((_e142 - _e280) + 127i)) << bitcast<u32>(23i)));
                    let _e292 = -(_e255);
                    if (_e292 < -126i) {
                        phi_575_ = -126i;
                    } else {
                        phi_575_ = select(_e292, 127i, (_e292 > 127i));
                    }
                    let _e297 = phi_575_;
                    let _e302 = bitcast<f32>((bitcast<u32>((_e297 + 127i)) << bitcast<u32>(23i)));
                    let _e308 = bitcast<f32>((bitcast<u32>(((_e292 - _e297) + 127i)) << bitcast<u32>(23i)));
                    let _e312 = global_4.member[_e160].member;
                    let _e313 = (_e274 == 0u);
                    if _e313 {
                        phi_593_ = _e312[0];
                    } else {
                        phi_593_ = _e312[1];
                    }
                    let _e317 = phi_593_;
                    let _e318 = (_e274 == 2u);
                    if _e318 {
                        phi_599_ = _e312[2];
                    } else {
                        phi_599_ = _e317;
                    }
                    let _e321 = phi_599_;
                    let _e322 = bitcast<u32>(_e321);
                    let _e324 = ((_e322 & 2139095040u) != 0u);
                    let _e338 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e322 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e322 & 2147483648u))), _e321, _e324) * _e285) * select(0.00000011920929f, 1f, _e324)) * _e291);
                    let _e339 = global_4.member[_e160].member_2;
                    if _e313 {
                        phi_639_ = _e339[0];
                    } else {
                        phi_639_ = _e339[1];
                    }
                    let _e343 = phi_639_;
                    if _e318 {
                        phi_645_ = _e339[2];
                    } else {
                        phi_645_ = _e343;
                    }
                    let _e346 = phi_645_;
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
                        phi_718_ = _e312[0];
                    } else {
                        phi_718_ = _e312[1];
                    }
                    let _e384 = phi_718_;
                    let _e385 = (_e273 == 2u);
                    if _e385 {
                        phi_724_ = _e312[2];
                    } else {
                        phi_724_ = _e384;
                    }
                    let _e388 = phi_724_;
                    let _e389 = bitcast<u32>(_e388);
                    let _e391 = ((_e389 & 2139095040u) != 0u);
                    let _e405 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e389 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e389 & 2147483648u))), _e388, _e391) * _e285) * select(0.00000011920929f, 1f, _e391)) * _e291);
                    if _e380 {
                        phi_764_ = _e339[0];
                    } else {
                        phi_764_ = _e339[1];
                    }
                    let _e409 = phi_764_;
                    if _e385 {
                        phi_770_ = _e339[2];
                    } else {
                        phi_770_ = _e409;
                    }
                    let _e412 = phi_770_;
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
                        phi_843_ = _e312[0];
                    } else {
                        phi_843_ = _e312[1];
                    }
                    let _e450 = phi_843_;
                    let _e451 = (_e275 == 2u);
                    if _e451 {
                        phi_849_ = _e312[2];
                    } else {
                        phi_849_ = _e450;
                    }
                    let _e454 = phi_849_;
                    let _e455 = bitcast<u32>(_e454);
                    let _e457 = ((_e455 & 2139095040u) != 0u);
                    let _e471 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e455 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e455 & 2147483648u))), _e454, _e457) * _e285) * select(0.00000011920929f, 1f, _e457)) * _e291);
                    if _e446 {
                        phi_889_ = _e339[0];
                    } else {
                        phi_889_ = _e339[1];
                    }
                    let _e475 = phi_889_;
                    if _e451 {
                        phi_895_ = _e339[2];
                    } else {
                        phi_895_ = _e475;
                    }
                    let _e478 = phi_895_;
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
                            phi_1014_ = 255i;
                        } else {
                            phi_1014_ = (((_e529 + select(0i, 1i, (_e529 == 0i))) - _e536) + _e516);
                        }
                        let _e544 = phi_1014_;
                        let _e554 = (_e544 <= 0i);
                        if _e554 {
                            phi_1037_ = u32();
                        } else {
                            if _e533 {
                                phi_1036_ = u32();
                            } else {
                                phi_1036_ = select(((bitcast<u32>(_e544) << bitcast<u32>(23i)) | ((_e526 << bitcast<u32>(((_e536 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e544 >= 255i));
                            }
                            let _e558 = phi_1036_;
                            phi_1037_ = _e558;
                        }
                        let _e560 = phi_1037_;
                        let _e572 = ((_e232 & 8388607u) | (select(0u, 1u, ((_e232 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                        let _e575 = bitcast<i32>((_e232 >> bitcast<u32>(23i)));
                        let _e579 = (_e572 == 0u);
                        let _e582 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e572)), 32u, _e579)) - 8i);
                        if (_e575 == 255i) {
                            phi_1074_ = 255i;
                        } else {
                            phi_1074_ = (((_e575 + select(0i, 1i, (_e575 == 0i))) - _e582) + _e516);
                        }
                        let _e590 = phi_1074_;
                        let _e600 = (_e590 <= 0i);
                        if _e600 {
                            phi_1097_ = u32();
                        } else {
                            if _e579 {
                                phi_1096_ = u32();
                            } else {
                                phi_1096_ = select(((bitcast<u32>(_e590) << bitcast<u32>(23i)) | ((_e572 << bitcast<u32>(((_e582 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e590 >= 255i));
                            }
                            let _e604 = phi_1096_;
                            phi_1097_ = _e604;
                        }
                        let _e606 = phi_1097_;
                        phi_1105_ = bitcast<f32>(((_e231 & 2147483648u) | select(_e606, 0u, select(_e579, true, _e600))));
                        phi_1106_ = bitcast<f32>(((_e222 & 2147483648u) | select(_e560, 0u, select(_e533, true, _e554))));
                    } else {
                        phi_1105_ = 0f;
                        phi_1106_ = 1f;
                    }
                    let _e612 = phi_1105_;
                    let _e614 = phi_1106_;
                    local_9 = array<type_24, 8>(type_24(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_24(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_24(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_24(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_24(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_24(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_24(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_24(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u));
                    local_8 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                    local_7 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_6 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_5 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_4 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_3 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_10 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    let _e617 = (_e274 % 3u);
                    let _e618 = (_e617 < 3u);
                    if _e618 {
                    } else {
                        break;
                    }
                    let _e620 = local_1[_e617];
                    let _e623 = (_e273 % 3u);
                    let _e624 = (_e623 < 3u);
                    if _e624 {
                    } else {
                        break;
                    }
                    let _e626 = local_1[_e623];
                    let _e629 = (_e275 % 3u);
                    let _e630 = (_e629 < 3u);
                    if _e630 {
                    } else {
                        break;
                    }
                    let _e632 = local_1[_e629];
                    if _e618 {
                    } else {
                        break;
                    }
                    let _e637 = local[_e617];
                    if _e624 {
                    } else {
                        break;
                    }
                    let _e641 = local[_e623];
                    if _e630 {
                    } else {
                        break;
                    }
                    let _e645 = local[_e629];
                    phi_5075_ = false;
                    phi_4988_ = _e612;
                    phi_1255_ = ((3u * _e103) + 1u);
                    phi_1258_ = (_e614 <= _e612);
                    phi_1260_ = 0u;
                    phi_1262_ = type_52(type_28(vec4<f32>((f32(_e620) * _e154), (f32(_e626) * _e154), (f32(_e632) * _e154), 0f), vec4<f32>((f32(_e637) * _e154), (f32(_e641) * _e154), (f32(_e645) * _e154), 0f)), select(0u, 2147483648u, (_e103 == 0u)));
                    loop {
                        let _e655 = phi_5075_;
                        let _e657 = phi_4988_;
                        let _e659 = phi_1255_;
                        let _e661 = phi_1258_;
                        let _e663 = phi_1260_;
                        let _e665 = phi_1262_;
                        if _e661 {
                            phi_1273_ = true;
                        } else {
                            phi_1273_ = (_e663 > 0u);
                        }
                        let _e668 = phi_1273_;
                        if _e668 {
                            let _e669 = (_e659 > 0u);
                            if _e669 {
                                if _e661 {
                                    phi_1360_ = _e661;
                                    phi_1361_ = _e663;
                                    phi_1362_ = _e665;
                                } else {
                                    let _e670 = (_e663 - 1u);
                                    let _e671 = (_e670 % 128u);
                                    let _e672 = (_e671 < 128u);
                                    if _e672 {
                                    } else {
                                        phi_5415_ = true;
                                        break;
                                    }
                                    let _e674 = local_7[_e671];
                                    if _e672 {
                                    } else {
                                        phi_5415_ = true;
                                        break;
                                    }
                                    let _e676 = local_6[_e671];
                                    if _e672 {
                                    } else {
                                        phi_5415_ = true;
                                        break;
                                    }
                                    let _e678 = local_5[_e671];
                                    if _e672 {
                                    } else {
                                        phi_5415_ = true;
                                        break;
                                    }
                                    let _e680 = local_4[_e671];
                                    if _e672 {
                                    } else {
                                        phi_5415_ = true;
                                        break;
                                    }
                                    let _e682 = local_3[_e671];
                                    if _e672 {
                                    } else {
                                        phi_5415_ = true;
                                        break;
                                    }
                                    let _e684 = local_2[_e671];
                                    if _e672 {
                                    } else {
                                        phi_5415_ = true;
                                        break;
                                    }
                                    let _e689 = local_8[_e671];
                                    if _e672 {
                                    } else {
                                        phi_5415_ = true;
                                        break;
                                    }
                                    let _e692 = local_10[_e671];
                                    phi_1360_ = (_e692 <= _e657);
                                    phi_1361_ = _e670;
                                    phi_1362_ = type_52(type_28(vec4<f32>(_e674, _e676, _e678, 0f), vec4<f32>(_e680, _e682, _e684, 0f)), _e689);
                                }
                                let _e695 = phi_1360_;
                                let _e697 = phi_1361_;
                                let _e699 = phi_1362_;
                                if _e695 {
                                    let _e703 = ((_e699.member_1 & 2147483648u) != 0u);
                                    let _e704 = (_e699.member_1 & 268435455u);
                                    if _e703 {
                                        phi_5072_ = _e655;
                                        phi_5013_ = _e657;
                                        phi_1381_ = type_8(0u, ((_e699.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e711 = phi_5072_;
                                            let _e713 = phi_5013_;
                                            let _e715 = phi_1381_;
                                            if (_e715.member < _e715.member_1) {
                                                phi_1382_ = type_8((_e715.member + 1u), _e715.member_1);
                                                phi_1405_ = type_8(1u, _e715.member);
                                            } else {
                                                phi_1382_ = _e715;
                                                phi_1405_ = type_8(0u, type_8().member_1);
                                            }
                                            let _e728 = phi_1382_;
                                            let _e730 = phi_1405_;
                                            let _e734 = (bitcast<i32>(_e730.member) != 0i);
                                            if _e734 {
                                                let _e739 = (_e699.member.member_1.x - _e699.member.member.x);
                                                let _e742 = (_e699.member.member_1.y - _e699.member.member.y);
                                                let _e745 = (_e699.member.member_1.z - _e699.member.member.z);
                                                let _e747 = select(_e742, _e739, (_e739 > _e742));
                                                let _e749 = select(_e745, _e747, (_e747 > _e745));
                                                let _e751 = (_e749 < (1024f * _e154));
                                                if _e751 {
                                                    phi_1446_ = 0u;
                                                } else {
                                                    phi_1446_ = select(2u, 1u, (_e749 < (2097152f * _e154)));
                                                }
                                                let _e756 = phi_1446_;
                                                switch bitcast<i32>(_e756) {
                                                    case 0: {
                                                        phi_1452_ = 1u;
                                                        break;
                                                    }
                                                    case 1: {
                                                        phi_1452_ = 2u;
                                                        break;
                                                    }
                                                    case 2: {
                                                        phi_1452_ = 3u;
                                                        break;
                                                    }
                                                    default: {
                                                        phi_1452_ = u32();
                                                        break;
                                                    }
                                                }
                                                let _e759 = phi_1452_;
                                                switch bitcast<i32>(_e756) {
                                                    case 0: {
                                                        phi_1462_ = 1u;
                                                        break;
                                                    }
                                                    case 1: {
                                                        phi_1462_ = 2u;
                                                        break;
                                                    }
                                                    case 2: {
                                                        phi_1462_ = 3u;
                                                        break;
                                                    }
                                                    default: {
                                                        phi_1462_ = u32();
                                                        break;
                                                    }
                                                }
                                                let _e766 = phi_1462_;
                                                let _e768 = ((_e704 + (_e730.member_1 * ((3u * _e759) + 1u))) + (3u * _e766));
                                                let _e769 = (_e768 < _e106);
                                                if _e769 {
                                                    if _e769 {
                                                    } else {
                                                        phi_5317_ = _e713;
                                                        phi_5254_ = true;
                                                        break;
                                                    }
                                                    let _e771 = global_5.member[_e768];
                                                    phi_1478_ = _e771;
                                                } else {
                                                    phi_1478_ = 4294967295u;
                                                }
                                                let _e773 = phi_1478_;
                                                if _e751 {
                                                    phi_1511_ = 0u;
                                                } else {
                                                    phi_1511_ = select(2u, 1u, (_e749 < (2097152f * _e154)));
                                                }
                                                let _e778 = phi_1511_;
                                                switch bitcast<i32>(_e778) {
                                                    case 0: {
                                                        phi_1517_ = 1u;
                                                        break;
                                                    }
                                                    case 1: {
                                                        phi_1517_ = 2u;
                                                        break;
                                                    }
                                                    case 2: {
                                                        phi_1517_ = 3u;
                                                        break;
                                                    }
                                                    default: {
                                                        phi_1517_ = u32();
                                                        break;
                                                    }
                                                }
                                                let _e781 = phi_1517_;
                                                let _e785 = (_e704 + (_e730.member_1 * ((3u * _e781) + 1u)));
                                                switch bitcast<i32>(_e778) {
                                                    case 0: {
                                                        let _e1060 = (_e785 < _e106);
                                                        if _e1060 {
                                                            if _e1060 {
                                                            } else {
                                                                phi_5317_ = _e713;
                                                                phi_5254_ = true;
                                                                break;
                                                            }
                                                            let _e1062 = global_5.member[_e785];
                                                            phi_1544_ = _e1062;
                                                        } else {
                                                            phi_1544_ = 0u;
                                                        }
                                                        let _e1064 = phi_1544_;
                                                        let _e1066 = ((10u * _e274) & 31u);
                                                        let _e1076 = ((10u * _e273) & 31u);
                                                        let _e1086 = ((10u * _e275) & 31u);
                                                        let _e1096 = (_e785 + 1u);
                                                        let _e1097 = (_e1096 < _e106);
                                                        if _e1097 {
                                                            if _e1097 {
                                                            } else {
                                                                phi_5317_ = _e713;
                                                                phi_5254_ = true;
                                                                break;
                                                            }
                                                            let _e1099 = global_5.member[_e1096];
                                                            phi_1593_ = _e1099;
                                                        } else {
                                                            phi_1593_ = 0u;
                                                        }
                                                        let _e1101 = phi_1593_;
                                                        let _e1127 = (_e785 + 2u);
                                                        let _e1128 = (_e1127 < _e106);
                                                        if _e1128 {
                                                            if _e1128 {
                                                            } else {
                                                                phi_5317_ = _e713;
                                                                phi_5254_ = true;
                                                                break;
                                                            }
                                                            let _e1130 = global_5.member[_e1127];
                                                            phi_1642_ = _e1130;
                                                        } else {
                                                            phi_1642_ = 0u;
                                                        }
                                                        let _e1132 = phi_1642_;
                                                        phi_2143_ = array<array<f32, 3>, 3>(array<f32, 3>((_e699.member.member.x + ((bitcast<f32>((1258291200u | ((_e1064 >> bitcast<u32>(_e1066)) & 1023u))) - 8388608f) * _e154)), (_e699.member.member.y + ((bitcast<f32>((1258291200u | ((_e1064 >> bitcast<u32>(_e1076)) & 1023u))) - 8388608f) * _e154)), (_e699.member.member.z + ((bitcast<f32>((1258291200u | ((_e1064 >> bitcast<u32>(_e1086)) & 1023u))) - 8388608f) * _e154))), array<f32, 3>((_e699.member.member.x + ((bitcast<f32>((1258291200u | ((_e1101 >> bitcast<u32>(_e1066)) & 1023u))) - 8388608f) * _e154)), (_e699.member.member.y + ((bitcast<f32>((1258291200u | ((_e1101 >> bitcast<u32>(_e1076)) & 1023u))) - 8388608f) * _e154)), (_e699.member.member.z + ((bitcast<f32>((1258291200u | ((_e1101 >> bitcast<u32>(_e1086)) & 1023u))) - 8388608f) * _e154))), array<f32, 3>((_e699.member.member.x + ((bitcast<f32>((1258291200u | ((_e1132 >> bitcast<u32>(_e1066)) & 1023u))) - 8388608f) * _e154)), (_e699.member.member.y + ((bitcast<f32>((1258291200u | ((_e1132 >> bitcast<u32>(_e1076)) & 1023u))) - 8388608f) * _e154)), (_e699.member.member.z + ((bitcast<f32>((1258291200u | ((_e1132 >> bitcast<u32>(_e1086)) & 1023u))) - 8388608f) * _e154))));
                                                        break;
                                                    }
                                                    case 1: {
                                                        let _e874 = (_e785 < _e106);
                                                        if _e874 {
                                                            if _e874 {
                                                            } else {
                                                                phi_5317_ = _e713;
                                                                phi_5254_ = true;
                                                                break;
                                                            }
                                                            let _e876 = global_5.member[_e785];
                                                            phi_1691_ = _e876;
                                                        } else {
                                                            phi_1691_ = 0u;
                                                        }
                                                        let _e878 = phi_1691_;
                                                        let _e879 = (_e785 + 1u);
                                                        let _e880 = (_e879 < _e106);
                                                        if _e880 {
                                                            if _e880 {
                                                            } else {
                                                                phi_5317_ = _e713;
                                                                phi_5254_ = true;
                                                                break;
                                                            }
                                                            let _e882 = global_5.member[_e879];
                                                            phi_1706_ = _e882;
                                                        } else {
                                                            phi_1706_ = 0u;
                                                        }
                                                        let _e884 = phi_1706_;
                                                        let _e885 = (_e274 == 1u);
                                                        if _e885 {
                                                            phi_1716_ = ((_e878 >> bitcast<u32>(21i)) | (_e884 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1716_ = (_e884 >> bitcast<u32>(10i));
                                                        }
                                                        let _e894 = phi_1716_;
                                                        let _e902 = (_e273 == 1u);
                                                        if _e902 {
                                                            phi_1737_ = ((_e878 >> bitcast<u32>(21i)) | (_e884 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1737_ = (_e884 >> bitcast<u32>(10i));
                                                        }
                                                        let _e911 = phi_1737_;
                                                        let _e919 = (_e275 == 1u);
                                                        if _e919 {
                                                            phi_1758_ = ((_e878 >> bitcast<u32>(21i)) | (_e884 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1758_ = (_e884 >> bitcast<u32>(10i));
                                                        }
                                                        let _e928 = phi_1758_;
                                                        let _e937 = (_e785 + 2u);
                                                        let _e938 = (_e937 < _e106);
                                                        if _e938 {
                                                            if _e938 {
                                                            } else {
                                                                phi_5317_ = _e713;
                                                                phi_5254_ = true;
                                                                break;
                                                            }
                                                            let _e940 = global_5.member[_e937];
                                                            phi_1788_ = _e940;
                                                        } else {
                                                            phi_1788_ = 0u;
                                                        }
                                                        let _e942 = phi_1788_;
                                                        let _e943 = (_e785 + 3u);
                                                        let _e944 = (_e943 < _e106);
                                                        if _e944 {
                                                            if _e944 {
                                                            } else {
                                                                phi_5317_ = _e713;
                                                                phi_5254_ = true;
                                                                break;
                                                            }
                                                            let _e946 = global_5.member[_e943];
                                                            phi_1803_ = _e946;
                                                        } else {
                                                            phi_1803_ = 0u;
                                                        }
                                                        let _e948 = phi_1803_;
                                                        if _e885 {
                                                            phi_1813_ = ((_e942 >> bitcast<u32>(21i)) | (_e948 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1813_ = (_e948 >> bitcast<u32>(10i));
                                                        }
                                                        let _e957 = phi_1813_;
                                                        if _e902 {
                                                            phi_1834_ = ((_e942 >> bitcast<u32>(21i)) | (_e948 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1834_ = (_e948 >> bitcast<u32>(10i));
                                                        }
                                                        let _e973 = phi_1834_;
                                                        if _e919 {
                                                            phi_1855_ = ((_e942 >> bitcast<u32>(21i)) | (_e948 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1855_ = (_e948 >> bitcast<u32>(10i));
                                                        }
                                                        let _e989 = phi_1855_;
                                                        let _e998 = (_e785 + 4u);
                                                        let _e999 = (_e998 < _e106);
                                                        if _e999 {
                                                            if _e999 {
                                                            } else {
                                                                phi_5317_ = _e713;
                                                                phi_5254_ = true;
                                                                break;
                                                            }
                                                            let _e1001 = global_5.member[_e998];
                                                            phi_1885_ = _e1001;
                                                        } else {
                                                            phi_1885_ = 0u;
                                                        }
                                                        let _e1003 = phi_1885_;
                                                        let _e1004 = (_e785 + 5u);
                                                        let _e1005 = (_e1004 < _e106);
                                                        if _e1005 {
                                                            if _e1005 {
                                                            } else {
                                                                phi_5317_ = _e713;
                                                                phi_5254_ = true;
                                                                break;
                                                            }
                                                            let _e1007 = global_5.member[_e1004];
                                                            phi_1900_ = _e1007;
                                                        } else {
                                                            phi_1900_ = 0u;
                                                        }
                                                        let _e1009 = phi_1900_;
                                                        if _e885 {
                                                            phi_1910_ = ((_e1003 >> bitcast<u32>(21i)) | (_e1009 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1910_ = (_e1009 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1018 = phi_1910_;
                                                        if _e902 {
                                                            phi_1931_ = ((_e1003 >> bitcast<u32>(21i)) | (_e1009 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1931_ = (_e1009 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1034 = phi_1931_;
                                                        if _e919 {
                                                            phi_1952_ = ((_e1003 >> bitcast<u32>(21i)) | (_e1009 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1952_ = (_e1009 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1050 = phi_1952_;
                                                        phi_2143_ = array<array<f32, 3>, 3>(array<f32, 3>((_e699.member.member.x + ((bitcast<f32>((1258291200u | (select(_e894, _e878, _e313) & 2097151u))) - 8388608f) * _e154)), (_e699.member.member.y + ((bitcast<f32>((1258291200u | (select(_e911, _e878, _e380) & 2097151u))) - 8388608f) * _e154)), (_e699.member.member.z + ((bitcast<f32>((1258291200u | (select(_e928, _e878, _e446) & 2097151u))) - 8388608f) * _e154))), array<f32, 3>((_e699.member.member.x + ((bitcast<f32>((1258291200u | (select(_e957, _e942, _e313) & 2097151u))) - 8388608f) * _e154)), (_e699.member.member.y + ((bitcast<f32>((1258291200u | (select(_e973, _e942, _e380) & 2097151u))) - 8388608f) * _e154)), (_e699.member.member.z + ((bitcast<f32>((1258291200u | (select(_e989, _e942, _e446) & 2097151u))) - 8388608f) * _e154))), array<f32, 3>((_e699.member.member.x + ((bitcast<f32>((1258291200u | (select(_e1018, _e1003, _e313) & 2097151u))) - 8388608f) * _e154)), (_e699.member.member.y + ((bitcast<f32>((1258291200u | (select(_e1034, _e1003, _e380) & 2097151u))) - 8388608f) * _e154)), (_e699.member.member.z + ((bitcast<f32>((1258291200u | (select(_e1050, _e1003, _e446) & 2097151u))) - 8388608f) * _e154))));
                                                        break;
                                                    }
                                                    case 2: {
                                                        let _e787 = (_e785 + _e274);
                                                        let _e788 = (_e787 < _e106);
                                                        if _e788 {
                                                            if _e788 {
                                                            } else {
                                                                phi_5317_ = _e713;
                                                                phi_5254_ = true;
                                                                break;
                                                            }
                                                            let _e790 = global_5.member[_e787];
                                                            phi_1983_ = _e790;
                                                        } else {
                                                            phi_1983_ = 0u;
                                                        }
                                                        let _e792 = phi_1983_;
                                                        let _e796 = (_e785 + _e273);
                                                        let _e797 = (_e796 < _e106);
                                                        if _e797 {
                                                            if _e797 {
                                                            } else {
                                                                phi_5317_ = _e713;
                                                                phi_5254_ = true;
                                                                break;
                                                            }
                                                            let _e799 = global_5.member[_e796];
                                                            phi_2001_ = _e799;
                                                        } else {
                                                            phi_2001_ = 0u;
                                                        }
                                                        let _e801 = phi_2001_;
                                                        let _e805 = (_e785 + _e275);
                                                        let _e806 = (_e805 < _e106);
                                                        if _e806 {
                                                            if _e806 {
                                                            } else {
                                                                phi_5317_ = _e713;
                                                                phi_5254_ = true;
                                                                break;
                                                            }
                                                            let _e808 = global_5.member[_e805];
                                                            phi_2019_ = _e808;
                                                        } else {
                                                            phi_2019_ = 0u;
                                                        }
                                                        let _e810 = phi_2019_;
                                                        let _e815 = (_e785 + 3u);
                                                        let _e816 = (_e815 + _e274);
                                                        let _e817 = (_e816 < _e106);
                                                        if _e817 {
                                                            if _e817 {
                                                            } else {
                                                                phi_5317_ = _e713;
                                                                phi_5254_ = true;
                                                                break;
                                                            }
                                                            let _e819 = global_5.member[_e816];
                                                            phi_2042_ = _e819;
                                                        } else {
                                                            phi_2042_ = 0u;
                                                        }
                                                        let _e821 = phi_2042_;
                                                        let _e825 = (_e815 + _e273);
                                                        let _e826 = (_e825 < _e106);
                                                        if _e826 {
                                                            if _e826 {
                                                            } else {
                                                                phi_5317_ = _e713;
                                                                phi_5254_ = true;
                                                                break;
                                                            }
                                                            let _e828 = global_5.member[_e825];
                                                            phi_2060_ = _e828;
                                                        } else {
                                                            phi_2060_ = 0u;
                                                        }
                                                        let _e830 = phi_2060_;
                                                        let _e834 = (_e815 + _e275);
                                                        let _e835 = (_e834 < _e106);
                                                        if _e835 {
                                                            if _e835 {
                                                            } else {
                                                                phi_5317_ = _e713;
                                                                phi_5254_ = true;
                                                                break;
                                                            }
                                                            let _e837 = global_5.member[_e834];
                                                            phi_2078_ = _e837;
                                                        } else {
                                                            phi_2078_ = 0u;
                                                        }
                                                        let _e839 = phi_2078_;
                                                        let _e844 = (_e785 + 6u);
                                                        let _e845 = (_e844 + _e274);
                                                        let _e846 = (_e845 < _e106);
                                                        if _e846 {
                                                            if _e846 {
                                                            } else {
                                                                phi_5317_ = _e713;
                                                                phi_5254_ = true;
                                                                break;
                                                            }
                                                            let _e848 = global_5.member[_e845];
                                                            phi_2101_ = _e848;
                                                        } else {
                                                            phi_2101_ = 0u;
                                                        }
                                                        let _e850 = phi_2101_;
                                                        let _e854 = (_e844 + _e273);
                                                        let _e855 = (_e854 < _e106);
                                                        if _e855 {
                                                            if _e855 {
                                                            } else {
                                                                phi_5317_ = _e713;
                                                                phi_5254_ = true;
                                                                break;
                                                            }
                                                            let _e857 = global_5.member[_e854];
                                                            phi_2119_ = _e857;
                                                        } else {
                                                            phi_2119_ = 0u;
                                                        }
                                                        let _e859 = phi_2119_;
                                                        let _e863 = (_e844 + _e275);
                                                        let _e864 = (_e863 < _e106);
                                                        if _e864 {
                                                            if _e864 {
                                                            } else {
                                                                phi_5317_ = _e713;
                                                                phi_5254_ = true;
                                                                break;
                                                            }
                                                            let _e866 = global_5.member[_e863];
                                                            phi_2137_ = _e866;
                                                        } else {
                                                            phi_2137_ = 0u;
                                                        }
                                                        let _e868 = phi_2137_;
                                                        phi_2143_ = array<array<f32, 3>, 3>(array<f32, 3>((f32(bitcast<i32>(_e792)) * _e154), (f32(bitcast<i32>(_e801)) * _e154), (f32(bitcast<i32>(_e810)) * _e154)), array<f32, 3>((f32(bitcast<i32>(_e821)) * _e154), (f32(bitcast<i32>(_e830)) * _e154), (f32(bitcast<i32>(_e839)) * _e154)), array<f32, 3>((f32(bitcast<i32>(_e850)) * _e154), (f32(bitcast<i32>(_e859)) * _e154), (f32(bitcast<i32>(_e868)) * _e154)));
                                                        break;
                                                    }
                                                    default: {
                                                        phi_2143_ = array<array<f32, 3>, 3>();
                                                        break;
                                                    }
                                                }
                                                let _e1160 = phi_2143_;
                                                let _e1175 = (_e1160[0][2] - _e471);
                                                let _e1178 = (((_e1160[0][0] - _e338) * _e507) - (_e1175 * _e375));
                                                let _e1181 = (((_e1160[0][1] - _e405) * _e507) - (_e1175 * _e441));
                                                let _e1184 = (_e1160[1][2] - _e471);
                                                let _e1187 = (((_e1160[1][0] - _e338) * _e507) - (_e1184 * _e375));
                                                let _e1190 = (((_e1160[1][1] - _e405) * _e507) - (_e1184 * _e441));
                                                let _e1193 = (_e1160[2][2] - _e471);
                                                let _e1196 = (((_e1160[2][0] - _e338) * _e507) - (_e1193 * _e375));
                                                let _e1199 = (((_e1160[2][1] - _e405) * _e507) - (_e1193 * _e441));
                                                let _e1200 = (_e1196 * _e1190);
                                                let _e1201 = (_e1199 * _e1187);
                                                let _e1202 = (_e1178 * _e1199);
                                                let _e1203 = (_e1181 * _e1196);
                                                let _e1204 = (_e1187 * _e1181);
                                                let _e1205 = (_e1190 * _e1178);
                                                let _e1210 = (((_e1200 >= _e1201) && (_e1202 >= _e1203)) && (_e1204 >= _e1205));
                                                let _e1216 = (_e1210 || (((_e1200 <= _e1201) && (_e1202 <= _e1203)) && (_e1204 <= _e1205)));
                                                if _e1216 {
                                                    let _e1218 = select(-1f, 1f, _e1210);
                                                    let _e1220 = ((_e1200 - _e1201) * _e1218);
                                                    let _e1222 = select(0f, _e1220, (_e1220 > 0f));
                                                    let _e1224 = ((_e1202 - _e1203) * _e1218);
                                                    let _e1226 = select(0f, _e1224, (_e1224 > 0f));
                                                    let _e1228 = ((_e1204 - _e1205) * _e1218);
                                                    let _e1230 = select(0f, _e1228, (_e1228 > 0f));
                                                    let _e1232 = ((_e1222 + _e1226) + _e1230);
                                                    let _e1234 = select(_e1160[1][0], _e1160[0][0], (_e1160[0][0] < _e1160[1][0]));
                                                    let _e1238 = select(_e1160[1][0], _e1160[0][0], (_e1160[0][0] > _e1160[1][0]));
                                                    let _e1242 = select(_e1160[1][1], _e1160[0][1], (_e1160[0][1] < _e1160[1][1]));
                                                    let _e1246 = select(_e1160[1][1], _e1160[0][1], (_e1160[0][1] > _e1160[1][1]));
                                                    let _e1250 = select(_e1160[1][2], _e1160[0][2], (_e1160[0][2] < _e1160[1][2]));
                                                    let _e1254 = select(_e1160[1][2], _e1160[0][2], (_e1160[0][2] > _e1160[1][2]));
                                                    let _e1259 = ((select(_e1160[2][0], _e1234, (_e1234 < _e1160[2][0])) - _e376) * _e379);
                                                    let _e1260 = ((select(_e1160[2][0], _e1238, (_e1238 > _e1160[2][0])) - _e377) * _e379);
                                                    let _e1263 = ((select(_e1160[2][1], _e1242, (_e1242 < _e1160[2][1])) - _e442) * _e445);
                                                    let _e1264 = ((select(_e1160[2][1], _e1246, (_e1246 > _e1160[2][1])) - _e443) * _e445);
                                                    let _e1267 = ((select(_e1160[2][2], _e1250, (_e1250 < _e1160[2][2])) - _e508) * _e511);
                                                    let _e1268 = ((select(_e1160[2][2], _e1254, (_e1254 > _e1160[2][2])) - _e509) * _e511);
                                                    let _e1270 = select(_e1268, _e1267, (_e1267 < _e1268));
                                                    let _e1272 = select(_e1268, _e1267, (_e1267 > _e1268));
                                                    let _e1274 = select(_e1260, _e1259, (_e1259 < _e1260));
                                                    let _e1276 = select(_e1264, _e1263, (_e1263 < _e1264));
                                                    let _e1278 = select(_e1276, _e1274, (_e1274 > _e1276));
                                                    let _e1280 = select(_e1270, _e1278, (_e1278 > _e1270));
                                                    let _e1282 = select(_e1260, _e1259, (_e1259 > _e1260));
                                                    let _e1284 = select(_e1264, _e1263, (_e1263 > _e1264));
                                                    let _e1286 = select(_e1284, _e1282, (_e1282 < _e1284));
                                                    let _e1288 = select(_e1272, _e1286, (_e1286 < _e1272));
                                                    let _e1289 = -(_e1270);
                                                    let _e1295 = select(_e614, _e1280, (_e1280 > _e614));
                                                    let _e1299 = select(_e1187, _e1178, (_e1178 < _e1187));
                                                    let _e1304 = select(_e1187, _e1178, (_e1178 > _e1187));
                                                    let _e1311 = select(_e1190, _e1181, (_e1181 < _e1190));
                                                    let _e1316 = select(_e1190, _e1181, (_e1181 > _e1190));
                                                    let _e1325 = (((((_e1216 && (_e1232 >= 0.000000000000000000000000000000000000011754944f)) && ((select(_e1196, _e1299, (_e1299 < _e1196)) <= 0f) && (select(_e1196, _e1304, (_e1304 > _e1196)) >= 0f))) && ((select(_e1199, _e1311, (_e1311 < _e1199)) <= 0f) && (select(_e1199, _e1316, (_e1316 > _e1199)) >= 0f))) && (_e1295 <= (_e1288 + (select(_e1289, _e1272, (_e1272 > _e1289)) * 0.0000019073523f)))) && (_e1295 <= _e713));
                                                    if _e1325 {
                                                        let _e1330 = (_e1160[1][0] - _e1160[0][0]);
                                                        let _e1331 = (_e1160[1][1] - _e1160[0][1]);
                                                        let _e1332 = (_e1160[1][2] - _e1160[0][2]);
                                                        let _e1333 = vec3<f32>(_e1330, _e1331, _e1332);
                                                        let _e1334 = (_e1160[2][0] - _e1160[1][0]);
                                                        let _e1335 = (_e1160[2][1] - _e1160[1][1]);
                                                        let _e1336 = (_e1160[2][2] - _e1160[1][2]);
                                                        let _e1337 = vec3<f32>(_e1334, _e1335, _e1336);
                                                        let _e1338 = (_e1160[0][0] - _e1160[2][0]);
                                                        let _e1339 = (_e1160[0][1] - _e1160[2][1]);
                                                        let _e1340 = (_e1160[0][2] - _e1160[2][2]);
                                                        let _e1341 = vec3<f32>(_e1338, _e1339, _e1340);
                                                        let _e1342 = abs(_e1330);
                                                        let _e1343 = abs(_e1331);
                                                        if (_e1342 != _e1342) {
                                                            phi_4544_ = true;
                                                        } else {
                                                            phi_4544_ = (_e1343 >= _e1342);
                                                        }
                                                        let _e1347 = phi_4544_;
                                                        let _e1348 = select(_e1342, _e1343, _e1347);
                                                        let _e1349 = abs(_e1332);
                                                        if (_e1348 != _e1348) {
                                                            phi_4559_ = true;
                                                        } else {
                                                            phi_4559_ = (_e1349 >= _e1348);
                                                        }
                                                        let _e1353 = phi_4559_;
                                                        let _e1354 = select(_e1348, _e1349, _e1353);
                                                        let _e1355 = abs(_e1334);
                                                        let _e1356 = abs(_e1335);
                                                        if (_e1355 != _e1355) {
                                                            phi_4574_ = true;
                                                        } else {
                                                            phi_4574_ = (_e1356 >= _e1355);
                                                        }
                                                        let _e1360 = phi_4574_;
                                                        let _e1361 = select(_e1355, _e1356, _e1360);
                                                        let _e1362 = abs(_e1336);
                                                        if (_e1361 != _e1361) {
                                                            phi_4589_ = true;
                                                        } else {
                                                            phi_4589_ = (_e1362 >= _e1361);
                                                        }
                                                        let _e1366 = phi_4589_;
                                                        let _e1367 = select(_e1361, _e1362, _e1366);
                                                        let _e1368 = abs(_e1338);
                                                        let _e1369 = abs(_e1339);
                                                        if (_e1368 != _e1368) {
                                                            phi_4604_ = true;
                                                        } else {
                                                            phi_4604_ = (_e1369 >= _e1368);
                                                        }
                                                        let _e1373 = phi_4604_;
                                                        let _e1374 = select(_e1368, _e1369, _e1373);
                                                        let _e1375 = abs(_e1340);
                                                        if (_e1374 != _e1374) {
                                                            phi_4619_ = true;
                                                        } else {
                                                            phi_4619_ = (_e1375 >= _e1374);
                                                        }
                                                        let _e1379 = phi_4619_;
                                                        let _e1380 = select(_e1374, _e1375, _e1379);
                                                        let _e1382 = select(_e1367, _e1354, (_e1354 > _e1367));
                                                        let _e1384 = select(_e1380, _e1382, (_e1382 > _e1380));
                                                        if (_e1354 == _e1384) {
                                                            phi_2686_ = _e1190;
                                                            phi_2687_ = _e1187;
                                                            phi_2688_ = _e1181;
                                                            phi_2689_ = _e1178;
                                                            phi_2690_ = vec3<f32>(_e1160[0][0], _e1160[0][1], _e1160[0][2]);
                                                            phi_2691_ = _e1341;
                                                            phi_2692_ = _e1337;
                                                            phi_2693_ = _e1333;
                                                        } else {
                                                            let _e1386 = (_e1367 == _e1384);
                                                            let _e1391 = vec3(_e1386);
                                                            phi_2686_ = select(_e1181, _e1199, _e1386);
                                                            phi_2687_ = select(_e1178, _e1196, _e1386);
                                                            phi_2688_ = select(_e1199, _e1190, _e1386);
                                                            phi_2689_ = select(_e1196, _e1187, _e1386);
                                                            phi_2690_ = select(vec3<f32>(_e1160[2][0], _e1160[2][1], _e1160[2][2]), vec3<f32>(_e1160[1][0], _e1160[1][1], _e1160[1][2]), _e1391);
                                                            phi_2691_ = select(_e1337, _e1333, _e1391);
                                                            phi_2692_ = select(_e1333, _e1341, _e1391);
                                                            phi_2693_ = select(_e1341, _e1337, _e1391);
                                                        }
                                                        let _e1397 = phi_2686_;
                                                        let _e1399 = phi_2687_;
                                                        let _e1401 = phi_2688_;
                                                        let _e1403 = phi_2689_;
                                                        let _e1405 = phi_2690_;
                                                        let _e1407 = phi_2691_;
                                                        let _e1409 = phi_2692_;
                                                        let _e1411 = phi_2693_;
                                                        let _e1418 = ((_e1409.y * _e1407.z) - (_e1407.y * _e1409.z));
                                                        let _e1423 = ((_e1409.z * _e1407.x) - (_e1407.z * _e1409.x));
                                                        let _e1426 = ((_e1409.x * _e1407.y) - (_e1407.x * _e1409.y));
                                                        let _e1429 = ((_e1222 >= _e1226) && (_e1222 >= _e1230));
                                                        let _e1430 = (_e1226 >= _e1230);
                                                        let _e1444 = (((_e1418 * (select(select(_e1160[2][0], _e1160[1][0], _e1430), _e1160[0][0], _e1429) - _e338)) + (_e1423 * (select(select(_e1160[2][1], _e1160[1][1], _e1430), _e1160[0][1], _e1429) - _e405))) + (_e1426 * (select(select(_e1160[2][2], _e1160[1][2], _e1430), _e1160[0][2], _e1429) - _e471)));
                                                        let _e1449 = (((_e1418 * _e375) + (_e1423 * _e441)) + (_e1426 * _e507));
                                                        let _e1450 = (_e1399 - _e1403);
                                                        let _e1451 = (_e1397 - _e1401);
                                                        let _e1454 = ((_e1450 * _e1450) + (_e1451 * _e1451));
                                                        let _e1461 = (-(((_e1403 * _e1450) + (_e1401 * _e1451))) / select(0.000000000000000000000000000000000000011754944f, _e1454, (_e1454 > 0.000000000000000000000000000000000000011754944f)));
                                                        let _e1463 = select(1f, _e1461, (_e1461 < 1f));
                                                        let _e1465 = select(0f, _e1463, (_e1463 > 0f));
                                                        let _e1474 = ((_e1405.x + (_e1411.x * _e1465)) - _e338);
                                                        let _e1477 = ((_e1405.y + (_e1411.y * _e1465)) - _e405);
                                                        let _e1480 = ((_e1405.z + (_e1411.z * _e1465)) - _e471);
                                                        let _e1483 = bitcast<f32>((bitcast<u32>(_e1474) & 2147483647u));
                                                        let _e1486 = bitcast<f32>((bitcast<u32>(_e1477) & 2147483647u));
                                                        let _e1488 = select(_e1486, _e1483, (_e1483 > _e1486));
                                                        let _e1491 = bitcast<f32>((bitcast<u32>(_e1480) & 2147483647u));
                                                        let _e1493 = select(_e1491, _e1488, (_e1488 > _e1491));
                                                        let _e1497 = abs(_e1418);
                                                        let _e1498 = abs(_e1423);
                                                        if (_e1497 != _e1497) {
                                                            phi_4634_ = true;
                                                        } else {
                                                            phi_4634_ = (_e1498 >= _e1497);
                                                        }
                                                        let _e1502 = phi_4634_;
                                                        let _e1503 = select(_e1497, _e1498, _e1502);
                                                        let _e1504 = abs(_e1426);
                                                        if (_e1503 != _e1503) {
                                                            phi_4649_ = true;
                                                        } else {
                                                            phi_4649_ = (_e1504 >= _e1503);
                                                        }
                                                        let _e1508 = phi_4649_;
                                                        let _e1524 = abs(_e1409.x);
                                                        let _e1525 = abs(_e1409.y);
                                                        if (_e1524 != _e1524) {
                                                            phi_4664_ = true;
                                                        } else {
                                                            phi_4664_ = (_e1525 >= _e1524);
                                                        }
                                                        let _e1529 = phi_4664_;
                                                        let _e1530 = select(_e1524, _e1525, _e1529);
                                                        let _e1531 = abs(_e1409.z);
                                                        if (_e1530 != _e1530) {
                                                            phi_4679_ = true;
                                                        } else {
                                                            phi_4679_ = (_e1531 >= _e1530);
                                                        }
                                                        let _e1535 = phi_4679_;
                                                        let _e1538 = abs(_e1407.x);
                                                        let _e1539 = abs(_e1407.y);
                                                        if (_e1538 != _e1538) {
                                                            phi_4694_ = true;
                                                        } else {
                                                            phi_4694_ = (_e1539 >= _e1538);
                                                        }
                                                        let _e1543 = phi_4694_;
                                                        let _e1544 = select(_e1538, _e1539, _e1543);
                                                        let _e1545 = abs(_e1407.z);
                                                        if (_e1544 != _e1544) {
                                                            phi_4709_ = true;
                                                        } else {
                                                            phi_4709_ = (_e1545 >= _e1544);
                                                        }
                                                        let _e1549 = phi_4709_;
                                                        let _e1554 = ((bitcast<f32>((bitcast<u32>(((((_e1418 * _e1474) + (_e1423 * _e1477)) + (_e1426 * _e1480)) - _e1444)) & 2147483647u)) <= ((0.0000009536743f * select(_e1384, _e1493, (_e1493 > _e1384))) * select(_e1503, _e1504, _e1508))) && !((bitcast<f32>((bitcast<u32>(_e1449) & 2147483647u)) <= ((0.0000038146973f * select(_e1530, _e1531, _e1535)) * select(_e1544, _e1545, _e1549)))));
                                                        let _e1555 = (_e1444 / _e1449);
                                                        if (_e1325 && !(_e1554)) {
                                                            let _e1558 = (_e1480 / _e507);
                                                            let _e1566 = (((_e1418 * (_e1474 - (_e375 * _e1558))) + (_e1423 * (_e1477 - (_e441 * _e1558)))) / _e1449);
                                                            phi_2901_ = select(select(_e1558, (_e1558 + _e1566), (bitcast<f32>((bitcast<u32>(_e1566) & 2147483647u)) <= _e1384)), _e1555, _e1554);
                                                        } else {
                                                            phi_2901_ = _e1555;
                                                        }
                                                        let _e1575 = phi_2901_;
                                                        let _e1577 = select(_e1288, _e1575, (_e1575 < _e1288));
                                                        let _e1579 = select(_e1280, _e1577, (_e1577 > _e1280));
                                                        let _e1580 = (1f / _e1232);
                                                        phi_2921_ = type_35(_e1579, (_e1226 * _e1580), (_e1230 * _e1580), ((_e1325 && (_e1579 >= _e614)) && (_e1579 <= _e713)));
                                                        phi_2922_ = type_35();
                                                    } else {
                                                        phi_2921_ = type_35();
                                                        phi_2922_ = type_35(0f, 0f, 0f, _e1325);
                                                    }
                                                    let _e1589 = phi_2921_;
                                                    let _e1591 = phi_2922_;
                                                    phi_2925_ = _e1589;
                                                    phi_2926_ = _e1591;
                                                    phi_2927_ = select(true, false, _e1325);
                                                } else {
                                                    phi_2925_ = type_35();
                                                    phi_2926_ = type_35(0f, 0f, 0f, _e1216);
                                                    phi_2927_ = true;
                                                }
                                                let _e1594 = phi_2925_;
                                                let _e1596 = phi_2926_;
                                                let _e1598 = phi_2927_;
                                                if _e1598 {
                                                    phi_2931_ = _e1596;
                                                } else {
                                                    phi_2931_ = _e1594;
                                                }
                                                let _e1600 = phi_2931_;
                                                if _e1600.member_3 {
                                                    phi_2940_ = type_24(_e1600.member, _e1600.member_1, _e1600.member_2, _e773);
                                                } else {
                                                    phi_2940_ = type_24(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                }
                                                let _e1607 = phi_2940_;
                                                if (_e1607.member_3 != 4294967295u) {
                                                    if (_e773 != 4294967295u) {
                                                        phi_2952_ = type_8(0u, 8u);
                                                        phi_2955_ = _e1607;
                                                        loop {
                                                            let _e1612 = phi_2952_;
                                                            let _e1614 = phi_2955_;
                                                            if (_e1612.member < _e1612.member_1) {
                                                                phi_2953_ = type_8((_e1612.member + 1u), _e1612.member_1);
                                                                phi_2978_ = type_8(1u, _e1612.member);
                                                            } else {
                                                                phi_2953_ = _e1612;
                                                                phi_2978_ = type_8(0u, type_8().member_1);
                                                            }
                                                            let _e1627 = phi_2953_;
                                                            let _e1629 = phi_2978_;
                                                            let _e1633 = (bitcast<i32>(_e1629.member) != 0i);
                                                            if _e1633 {
                                                                let _e1634 = (_e1629.member_1 < 8u);
                                                                if _e1634 {
                                                                } else {
                                                                    phi_5042_ = true;
                                                                    break;
                                                                }
                                                                let _e1639 = local_9[_e1629.member_1].member;
                                                                if (_e1614.member < _e1639) {
                                                                    phi_3011_ = true;
                                                                } else {
                                                                    let _e1641 = local_9[_e1629.member_1].member;
                                                                    if (_e1614.member == _e1641) {
                                                                        let _e1646 = local_9[_e1629.member_1].member_3;
                                                                        phi_3010_ = (_e1614.member_3 < _e1646);
                                                                    } else {
                                                                        phi_3010_ = false;
                                                                    }
                                                                    let _e1649 = phi_3010_;
                                                                    phi_3011_ = _e1649;
                                                                }
                                                                let _e1651 = phi_3011_;
                                                                if _e1651 {
                                                                    if _e1634 {
                                                                    } else {
                                                                        phi_5042_ = true;
                                                                        break;
                                                                    }
                                                                    let _e1652 = local_9[_e1629.member_1];
                                                                    local_9[_e1629.member_1] = type_24(_e1614.member, _e1614.member_1, _e1614.member_2, _e1614.member_3);
                                                                    phi_3032_ = type_24(_e1652.member, _e1652.member_1, _e1652.member_2, _e1652.member_3);
                                                                } else {
                                                                    phi_3032_ = _e1614;
                                                                }
                                                                let _e1663 = phi_3032_;
                                                                phi_2956_ = _e1663;
                                                            } else {
                                                                phi_2956_ = type_24();
                                                            }
                                                            let _e1665 = phi_2956_;
                                                            continue;
                                                            continuing {
                                                                phi_2952_ = _e1627;
                                                                phi_2955_ = _e1665;
                                                                phi_5042_ = _e711;
                                                                break if !(_e1633);
                                                            }
                                                        }
                                                        let _e1668 = phi_5042_;
                                                        phi_5317_ = _e713;
                                                        phi_5254_ = _e1668;
                                                        if _e1668 {
                                                            break;
                                                        }
                                                        let _e1671 = local_9[7u].member_3;
                                                        if (_e1671 != 4294967295u) {
                                                            let _e1675 = local_9[7u].member;
                                                            phi_5413_ = _e1675;
                                                        } else {
                                                            phi_5413_ = _e713;
                                                        }
                                                        let _e1677 = phi_5413_;
                                                        phi_5412_ = _e1677;
                                                        phi_5257_ = _e1668;
                                                    } else {
                                                        phi_5412_ = _e713;
                                                        phi_5257_ = _e711;
                                                    }
                                                    let _e1679 = phi_5412_;
                                                    let _e1681 = phi_5257_;
                                                    phi_5411_ = _e1679;
                                                    phi_5256_ = _e1681;
                                                } else {
                                                    phi_5411_ = _e713;
                                                    phi_5256_ = _e711;
                                                }
                                                let _e1683 = phi_5411_;
                                                let _e1685 = phi_5256_;
                                                phi_5410_ = _e1683;
                                                phi_5255_ = _e1685;
                                            } else {
                                                phi_5410_ = _e713;
                                                phi_5255_ = _e711;
                                            }
                                            let _e1687 = phi_5410_;
                                            let _e1689 = phi_5255_;
                                            continue;
                                            continuing {
                                                phi_5072_ = _e1689;
                                                phi_5013_ = _e1687;
                                                phi_1381_ = _e728;
                                                phi_5317_ = _e1687;
                                                phi_5254_ = _e1689;
                                                break if !(_e734);
                                            }
                                        }
                                        let _e1692 = phi_5317_;
                                        let _e1694 = phi_5254_;
                                        phi_5415_ = _e1694;
                                        if _e1694 {
                                            break;
                                        }
                                        phi_5506_ = _e1694;
                                        phi_5316_ = _e1692;
                                    } else {
                                        phi_5506_ = _e655;
                                        phi_5316_ = _e657;
                                    }
                                    let _e1696 = phi_5506_;
                                    let _e1698 = phi_5316_;
                                    if _e703 {
                                        phi_4309_ = bool();
                                        phi_4310_ = u32();
                                        phi_4311_ = type_52();
                                    } else {
                                        if (_e699.member_1 >= _e103) {
                                            phi_3844_ = type_53(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), type_52(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u), type_52(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u));
                                        } else {
                                            if (_e699.member_1 < _e103) {
                                            } else {
                                                phi_5415_ = true;
                                                break;
                                            }
                                            let _e1702 = ((1u + _e274) % 4u);
                                            if (_e1702 < 4u) {
                                            } else {
                                                phi_5415_ = true;
                                                break;
                                            }
                                            let _e1707 = global_3.member[_e699.member_1][_e1702];
                                            let _e1709 = (_e1707 >> bitcast<u32>(11u));
                                            let _e1711 = ((1u + _e273) % 4u);
                                            if (_e1711 < 4u) {
                                            } else {
                                                phi_5415_ = true;
                                                break;
                                            }
                                            let _e1716 = global_3.member[_e699.member_1][_e1711];
                                            let _e1718 = (_e1716 >> bitcast<u32>(11u));
                                            let _e1720 = ((1u + _e275) % 4u);
                                            if (_e1720 < 4u) {
                                            } else {
                                                phi_5415_ = true;
                                                break;
                                            }
                                            let _e1725 = global_3.member[_e699.member_1][_e1720];
                                            let _e1727 = (_e1725 >> bitcast<u32>(11u));
                                            let _e1750 = (bitcast<f32>((bitcast<u32>((_e699.member.member_1.x - _e699.member.member.x)) & 2139095040u)) * 0.001953125f);
                                            let _e1751 = (bitcast<f32>((bitcast<u32>((_e699.member.member_1.y - _e699.member.member.y)) & 2139095040u)) * 0.001953125f);
                                            let _e1752 = (bitcast<f32>((bitcast<u32>((_e699.member.member_1.z - _e699.member.member.z)) & 2139095040u)) * 0.001953125f);
                                            let _e1754 = select(_e154, _e1750, (_e1750 > _e154));
                                            let _e1756 = select(_e154, _e1751, (_e1751 > _e154));
                                            let _e1758 = select(_e154, _e1752, (_e1752 > _e154));
                                            let _e1789 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1707 & 1023u))) - 8388608f) * _e1754));
                                            let _e1794 = (bitcast<i32>((_e1707 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e1797 = bitcast<f32>((_e1789 & bitcast<u32>(_e1794)));
                                            let _e1798 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1716 & 1023u))) - 8388608f) * _e1756));
                                            let _e1803 = (bitcast<i32>((_e1716 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e1806 = bitcast<f32>((_e1798 & bitcast<u32>(_e1803)));
                                            let _e1807 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1725 & 1023u))) - 8388608f) * _e1758));
                                            let _e1812 = (bitcast<i32>((_e1725 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e1815 = bitcast<f32>((_e1807 & bitcast<u32>(_e1812)));
                                            let _e1819 = bitcast<f32>((_e1789 & bitcast<u32>(~(_e1794))));
                                            let _e1823 = bitcast<f32>((_e1798 & bitcast<u32>(~(_e1803))));
                                            let _e1827 = bitcast<f32>((_e1807 & bitcast<u32>(~(_e1812))));
                                            let _e1828 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1709 & 1023u))) - 8388608f) * _e1754));
                                            let _e1833 = (bitcast<i32>((_e1709 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e1836 = bitcast<f32>((_e1828 & bitcast<u32>(_e1833)));
                                            let _e1837 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1718 & 1023u))) - 8388608f) * _e1756));
                                            let _e1842 = (bitcast<i32>((_e1718 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e1845 = bitcast<f32>((_e1837 & bitcast<u32>(_e1842)));
                                            let _e1846 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1727 & 1023u))) - 8388608f) * _e1758));
                                            let _e1851 = (bitcast<i32>((_e1727 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e1854 = bitcast<f32>((_e1846 & bitcast<u32>(_e1851)));
                                            let _e1858 = bitcast<f32>((_e1828 & bitcast<u32>(~(_e1833))));
                                            let _e1862 = bitcast<f32>((_e1837 & bitcast<u32>(~(_e1842))));
                                            let _e1866 = bitcast<f32>((_e1846 & bitcast<u32>(~(_e1851))));
                                            let _e1867 = (_e699.member.member.x + _e1797);
                                            let _e1868 = (_e699.member.member.y + _e1806);
                                            let _e1869 = (_e699.member.member.z + _e1815);
                                            let _e1872 = (_e699.member.member_1.x - _e1836);
                                            let _e1873 = (_e699.member.member_1.y - _e1845);
                                            let _e1874 = (_e699.member.member_1.z - _e1854);
                                            let _e1893 = (_e1872 - _e1867);
                                            let _e1894 = (_e1873 - _e1868);
                                            let _e1895 = (_e1874 - _e1869);
                                            let _e1897 = select(_e1894, _e1893, (_e1893 > _e1894));
                                            let _e1899 = select(_e1895, _e1897, (_e1897 > _e1895));
                                            if (_e1899 < (1024f * _e154)) {
                                                phi_3545_ = 0u;
                                            } else {
                                                phi_3545_ = select(2u, 1u, (_e1899 < (2097152f * _e154)));
                                            }
                                            let _e1906 = phi_3545_;
                                            switch bitcast<i32>(_e1906) {
                                                case 0: {
                                                    phi_3551_ = 1u;
                                                    break;
                                                }
                                                case 1: {
                                                    phi_3551_ = 2u;
                                                    break;
                                                }
                                                case 2: {
                                                    phi_3551_ = 3u;
                                                    break;
                                                }
                                                default: {
                                                    phi_3551_ = u32();
                                                    break;
                                                }
                                            }
                                            let _e1909 = phi_3551_;
                                            let _e1915 = global_3.member[_e699.member_1][0u];
                                            let _e1919 = global_3.member[_e699.member_1][1u];
                                            let _e1923 = global_3.member[_e699.member_1][2u];
                                            let _e1927 = global_3.member[_e699.member_1][3u];
                                            let _e1939 = (((_e1919 >> bitcast<u32>(22i)) | ((_e1923 >> bitcast<u32>(22i)) << bitcast<u32>(10i))) | ((_e1927 >> bitcast<u32>(22i)) << bitcast<u32>(20i)));
                                            let _e1940 = (_e1915 & 268435455u);
                                            let _e1941 = (_e1939 & 268435455u);
                                            let _e1944 = ((_e1915 >> bitcast<u32>(28u)) & 7u);
                                            let _e1952 = ((_e1915 >> bitcast<u32>(31i)) | (((_e1939 >> bitcast<u32>(28u)) & 3u) << bitcast<u32>(1i)));
                                            let _e1953 = (_e1944 != 0u);
                                            if (_e1944 == 0u) {
                                                phi_3806_ = _e1940;
                                            } else {
                                                if (_e1944 == 7u) {
                                                    phi_3805_ = 2147483648u;
                                                } else {
                                                    phi_3805_ = ((2147483648u | (_e1944 << bitcast<u32>(28u))) | (_e1941 & 268435455u));
                                                }
                                                let _e1962 = phi_3805_;
                                                phi_3806_ = _e1962;
                                            }
                                            let _e1964 = phi_3806_;
                                            if _e1953 {
                                                let _e1965 = (_e1944 != 7u);
                                                if _e1965 {
                                                    phi_3816_ = (_e1941 + (_e1944 * ((3u * _e1909) + 1u)));
                                                } else {
                                                    phi_3816_ = u32();
                                                }
                                                let _e1969 = phi_3816_;
                                                phi_3818_ = _e1969;
                                                phi_3819_ = select(true, false, _e1965);
                                            } else {
                                                phi_3818_ = u32();
                                                phi_3819_ = true;
                                            }
                                            let _e1972 = phi_3818_;
                                            let _e1974 = phi_3819_;
                                            if (_e1952 == 0u) {
                                                phi_3840_ = (_e1940 + select(0u, 1u, !(_e1953)));
                                            } else {
                                                if (_e1952 == 7u) {
                                                    phi_3839_ = 2147483648u;
                                                } else {
                                                    phi_3839_ = ((2147483648u | (_e1952 << bitcast<u32>(28u))) | (select(_e1972, _e1941, _e1974) & 268435455u));
                                                }
                                                let _e1987 = phi_3839_;
                                                phi_3840_ = _e1987;
                                            }
                                            let _e1989 = phi_3840_;
                                            phi_3844_ = type_53(array<vec4<f32>, 3>(vec4<f32>(_e1867, (_e699.member.member.x + _e1819), _e1872, (_e699.member.member_1.x - _e1858)), vec4<f32>(_e1868, (_e699.member.member.y + _e1823), _e1873, (_e699.member.member_1.y - _e1862)), vec4<f32>(_e1869, (_e699.member.member.z + _e1827), _e1874, (_e699.member.member_1.z - _e1866))), type_52(type_28((_e699.member.member + vec4<f32>(_e1797, _e1806, _e1815, 0f)), (_e699.member.member_1 - vec4<f32>(_e1836, _e1845, _e1854, 0f))), _e1964), type_52(type_28((_e699.member.member + vec4<f32>(_e1819, _e1823, _e1827, 0f)), (_e699.member.member_1 - vec4<f32>(_e1858, _e1862, _e1866, 0f))), _e1989));
                                        }
                                        let _e1994 = phi_3844_;
                                        let _e2005 = ((_e1994.member[0].x - _e376) * _e379);
                                        let _e2006 = ((_e1994.member[0].y - _e376) * _e379);
                                        let _e2007 = ((_e1994.member[0].z - _e377) * _e379);
                                        let _e2008 = ((_e1994.member[0].w - _e377) * _e379);
                                        let _e2018 = ((_e1994.member[1].x - _e442) * _e445);
                                        let _e2019 = ((_e1994.member[1].y - _e442) * _e445);
                                        let _e2020 = ((_e1994.member[1].z - _e443) * _e445);
                                        let _e2021 = ((_e1994.member[1].w - _e443) * _e445);
                                        let _e2031 = ((_e1994.member[2].x - _e508) * _e511);
                                        let _e2032 = ((_e1994.member[2].y - _e508) * _e511);
                                        let _e2033 = ((_e1994.member[2].z - _e509) * _e511);
                                        let _e2034 = ((_e1994.member[2].w - _e509) * _e511);
                                        let _e2036 = select(_e2033, _e2031, (_e2031 < _e2033));
                                        let _e2038 = select(_e2034, _e2032, (_e2032 < _e2034));
                                        let _e2040 = select(_e2033, _e2031, (_e2031 > _e2033));
                                        let _e2042 = select(_e2034, _e2032, (_e2032 > _e2034));
                                        let _e2044 = select(_e2007, _e2005, (_e2005 < _e2007));
                                        let _e2046 = select(_e2008, _e2006, (_e2006 < _e2008));
                                        let _e2048 = select(_e2020, _e2018, (_e2018 < _e2020));
                                        let _e2050 = select(_e2021, _e2019, (_e2019 < _e2021));
                                        let _e2052 = select(_e2048, _e2044, (_e2044 > _e2048));
                                        let _e2054 = select(_e2050, _e2046, (_e2046 > _e2050));
                                        let _e2056 = select(_e2036, _e2052, (_e2052 > _e2036));
                                        let _e2058 = select(_e2038, _e2054, (_e2054 > _e2038));
                                        let _e2060 = select(_e2007, _e2005, (_e2005 > _e2007));
                                        let _e2062 = select(_e2008, _e2006, (_e2006 > _e2008));
                                        let _e2064 = select(_e2020, _e2018, (_e2018 > _e2020));
                                        let _e2066 = select(_e2021, _e2019, (_e2019 > _e2021));
                                        let _e2068 = select(_e2064, _e2060, (_e2060 < _e2064));
                                        let _e2070 = select(_e2066, _e2062, (_e2062 < _e2066));
                                        let _e2075 = -(_e2036);
                                        let _e2076 = -(_e2038);
                                        let _e2083 = (select(_e2040, _e2068, (_e2068 < _e2040)) + (select(_e2075, _e2040, (_e2040 > _e2075)) * 0.0000019073523f));
                                        let _e2084 = (select(_e2042, _e2070, (_e2070 < _e2042)) + (select(_e2076, _e2042, (_e2042 > _e2076)) * 0.0000019073523f));
                                        let _e2086 = select(_e614, _e2056, (_e2056 > _e614));
                                        let _e2088 = select(_e614, _e2058, (_e2058 > _e614));
                                        let _e2093 = (_e2086 <= select(_e1698, _e2083, (_e2083 < _e1698)));
                                        let _e2094 = (_e2088 <= select(_e1698, _e2084, (_e2084 < _e1698)));
                                        let _e2095 = (_e2086 <= _e2088);
                                        if _e2093 {
                                            if _e2094 {
                                                if _e2095 {
                                                    phi_4207_ = _e1994.member_2;
                                                } else {
                                                    phi_4207_ = _e1994.member_1;
                                                }
                                                let _e2099 = phi_4207_;
                                                let _e2120 = (_e697 % 128u);
                                                let _e2121 = (_e2120 < 128u);
                                                if _e2121 {
                                                } else {
                                                    phi_5415_ = true;
                                                    break;
                                                }
                                                local_8[_e2120] = _e2099.member_1;
                                                if _e2121 {
                                                } else {
                                                    phi_5415_ = true;
                                                    break;
                                                }
                                                local_7[_e2120] = _e2099.member.member.x;
                                                if _e2121 {
                                                } else {
                                                    phi_5415_ = true;
                                                    break;
                                                }
                                                local_6[_e2120] = _e2099.member.member.y;
                                                if _e2121 {
                                                } else {
                                                    phi_5415_ = true;
                                                    break;
                                                }
                                                local_5[_e2120] = _e2099.member.member.z;
                                                if _e2121 {
                                                } else {
                                                    phi_5415_ = true;
                                                    break;
                                                }
                                                local_4[_e2120] = _e2099.member.member_1.x;
                                                if _e2121 {
                                                } else {
                                                    phi_5415_ = true;
                                                    break;
                                                }
                                                local_3[_e2120] = _e2099.member.member_1.y;
                                                if _e2121 {
                                                } else {
                                                    phi_5415_ = true;
                                                    break;
                                                }
                                                local_2[_e2120] = _e2099.member.member_1.z;
                                                if _e2121 {
                                                } else {
                                                    phi_5415_ = true;
                                                    break;
                                                }
                                                local_10[_e2120] = select(_e2086, _e2088, _e2095);
                                                if _e2095 {
                                                    phi_4283_ = _e1994.member_1;
                                                } else {
                                                    phi_4283_ = _e1994.member_2;
                                                }
                                                let _e2134 = phi_4283_;
                                                phi_4284_ = (_e697 + 1u);
                                                phi_4285_ = _e2134;
                                            } else {
                                                phi_4284_ = u32();
                                                phi_4285_ = type_52();
                                            }
                                            let _e2136 = phi_4284_;
                                            let _e2138 = phi_4285_;
                                            phi_4287_ = _e2136;
                                            phi_4288_ = _e2138;
                                            phi_4289_ = select(true, false, _e2094);
                                        } else {
                                            phi_4287_ = u32();
                                            phi_4288_ = type_52();
                                            phi_4289_ = true;
                                        }
                                        let _e2141 = phi_4287_;
                                        let _e2143 = phi_4288_;
                                        let _e2145 = phi_4289_;
                                        if _e2145 {
                                            if _e2093 {
                                                phi_4298_ = _e1994.member_1;
                                            } else {
                                                phi_4298_ = _e1994.member_2;
                                            }
                                            let _e2149 = phi_4298_;
                                            phi_4303_ = select(_e2094, true, _e2093);
                                            phi_4305_ = _e2149;
                                        } else {
                                            phi_4303_ = _e695;
                                            phi_4305_ = _e2143;
                                        }
                                        let _e2152 = phi_4303_;
                                        let _e2154 = phi_4305_;
                                        phi_4309_ = _e2152;
                                        phi_4310_ = select(_e2141, _e697, _e2145);
                                        phi_4311_ = _e2154;
                                    }
                                    let _e2157 = phi_4309_;
                                    let _e2159 = phi_4310_;
                                    let _e2161 = phi_4311_;
                                    if _e703 {
                                        phi_4321_ = _e699;
                                    } else {
                                        phi_4321_ = _e2161;
                                    }
                                    let _e2163 = phi_4321_;
                                    phi_5534_ = _e1698;
                                    phi_5418_ = _e1696;
                                    phi_4322_ = (_e659 - 1u);
                                    phi_4323_ = select(_e2157, false, _e703);
                                    phi_4324_ = select(_e2159, _e697, _e703);
                                    phi_4325_ = _e2163;
                                } else {
                                    phi_5534_ = _e657;
                                    phi_5418_ = _e655;
                                    phi_4322_ = _e659;
                                    phi_4323_ = _e695;
                                    phi_4324_ = _e697;
                                    phi_4325_ = _e699;
                                }
                                let _e2167 = phi_5534_;
                                let _e2169 = phi_5418_;
                                let _e2171 = phi_4322_;
                                let _e2173 = phi_4323_;
                                let _e2175 = phi_4324_;
                                let _e2177 = phi_4325_;
                                phi_5533_ = _e2167;
                                phi_5417_ = _e2169;
                                phi_4326_ = _e2171;
                                phi_4327_ = _e2173;
                                phi_4328_ = _e2175;
                                phi_4329_ = _e2177;
                            } else {
                                phi_5533_ = _e657;
                                phi_5417_ = _e655;
                                phi_4326_ = u32();
                                phi_4327_ = bool();
                                phi_4328_ = u32();
                                phi_4329_ = type_52();
                            }
                            let _e2179 = phi_5533_;
                            let _e2181 = phi_5417_;
                            let _e2183 = phi_4326_;
                            let _e2185 = phi_4327_;
                            let _e2187 = phi_4328_;
                            let _e2189 = phi_4329_;
                            phi_5532_ = _e2179;
                            phi_5416_ = _e2181;
                            phi_1256_ = _e2183;
                            phi_1259_ = _e2185;
                            phi_1261_ = _e2187;
                            phi_1263_ = _e2189;
                            phi_4330_ = _e669;
                        } else {
                            phi_5532_ = _e657;
                            phi_5416_ = _e655;
                            phi_1256_ = u32();
                            phi_1259_ = bool();
                            phi_1261_ = u32();
                            phi_1263_ = type_52();
                            phi_4330_ = false;
                        }
                        let _e2191 = phi_5532_;
                        let _e2193 = phi_5416_;
                        let _e2195 = phi_1256_;
                        let _e2197 = phi_1259_;
                        let _e2199 = phi_1261_;
                        let _e2201 = phi_1263_;
                        let _e2203 = phi_4330_;
                        continue;
                        continuing {
                            phi_5075_ = _e2193;
                            phi_4988_ = _e2191;
                            phi_1255_ = _e2195;
                            phi_1258_ = _e2197;
                            phi_1260_ = _e2199;
                            phi_1262_ = _e2201;
                            phi_5415_ = _e2193;
                            break if !(_e2203);
                        }
                    }
                    let _e2206 = phi_5415_;
                    if _e2206 {
                        break;
                    }
                    phi_4337_ = type_8(0u, 8u);
                    loop {
                        let _e2208 = phi_4337_;
                        if (_e2208.member < _e2208.member_1) {
                            phi_4338_ = type_8((_e2208.member + 1u), _e2208.member_1);
                            phi_4361_ = type_8(1u, _e2208.member);
                        } else {
                            phi_4338_ = _e2208;
                            phi_4361_ = type_8(0u, type_8().member_1);
                        }
                        let _e2221 = phi_4338_;
                        let _e2223 = phi_4361_;
                        let _e2227 = (bitcast<i32>(_e2223.member) != 0i);
                        if _e2227 {
                            let _e2228 = (_e2223.member_1 < 8u);
                            if _e2228 {
                            } else {
                                phi_5514_ = true;
                                break;
                            }
                            let _e2230 = local_9[_e2223.member_1];
                            if (_e2230.member_3 != 4294967295u) {
                                let _e2236 = -(_e516);
                                let _e2237 = bitcast<u32>(_e2230.member);
                                let _e2241 = (bitcast<i32>((_e2237 >> bitcast<u32>(23i))) & 255i);
                                let _e2242 = (_e2241 + _e2236);
                                if (_e2241 == 255i) {
                                    phi_4434_ = _e2230.member;
                                } else {
                                    if (_e2241 > 0i) {
                                        if (_e2242 > 0i) {
                                            let _e2246 = (_e2242 < 255i);
                                            if _e2246 {
                                                phi_4413_ = bitcast<f32>((_e2237 + bitcast<u32>((_e2236 << bitcast<u32>(23i)))));
                                            } else {
                                                phi_4413_ = f32();
                                            }
                                            let _e2253 = phi_4413_;
                                            phi_4415_ = _e2253;
                                            phi_4416_ = select(true, false, _e2246);
                                        } else {
                                            phi_4415_ = f32();
                                            phi_4416_ = true;
                                        }
                                        let _e2256 = phi_4415_;
                                        let _e2258 = phi_4416_;
                                        phi_4417_ = _e2256;
                                        phi_4418_ = _e2258;
                                    } else {
                                        phi_4417_ = f32();
                                        phi_4418_ = true;
                                    }
                                    let _e2260 = phi_4417_;
                                    let _e2262 = phi_4418_;
                                    if _e2262 {
                                        let _e2263 = (_e2237 & 2147483648u);
                                        let _e2270 = ((_e2237 & 8388607u) | (select(0u, 1u, ((_e2237 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                                        let _e2274 = (_e2270 == 0u);
                                        if _e2274 {
                                            phi_4935_ = bitcast<f32>(_e2263);
                                        } else {
                                            let _e2279 = (select((bitcast<u32>(31i) - firstLeadingBit(_e2270)), 32u, _e2274) - 8u);
                                            let _e2282 = (_e2270 << bitcast<u32>((_e2279 & 31u)));
                                            let _e2284 = ((_e2242 + select(0i, 1i, (_e2241 == 0i))) - bitcast<i32>(_e2279));
                                            if (_e2284 >= 255i) {
                                                phi_4925_ = bitcast<f32>((_e2263 | 2139095040u));
                                                phi_4926_ = f32();
                                                phi_4927_ = true;
                                            } else {
                                                let _e2286 = (_e2284 > 0i);
                                                if _e2286 {
                                                    phi_4919_ = bitcast<f32>(((_e2263 | (bitcast<u32>(_e2284) << bitcast<u32>(23i))) | (_e2282 & 8388607u)));
                                                    phi_4920_ = f32();
                                                } else {
                                                    if (_e2284 < -24i) {
                                                        phi_4885_ = 26u;
                                                    } else {
                                                        phi_4885_ = bitcast<u32>((1i - _e2284));
                                                    }
                                                    let _e2291 = phi_4885_;
                                                    let _e2292 = (_e2291 & 31u);
                                                    let _e2294 = (_e2282 >> bitcast<u32>(_e2292));
                                                    let _e2298 = (_e2282 & ((1u << bitcast<u32>(_e2292)) - 1u));
                                                    let _e2302 = (1u << bitcast<u32>(((_e2291 - 1u) & 31u)));
                                                    if (_e2298 > _e2302) {
                                                        phi_4906_ = true;
                                                    } else {
                                                        if (_e2298 == _e2302) {
                                                            phi_4903_ = ((_e2294 & 1u) == 1u);
                                                        } else {
                                                            phi_4903_ = false;
                                                        }
                                                        let _e2308 = phi_4903_;
                                                        phi_4906_ = _e2308;
                                                    }
                                                    let _e2310 = phi_4906_;
                                                    phi_4919_ = f32();
                                                    phi_4920_ = bitcast<f32>((_e2263 | (_e2294 + select(0u, 1u, _e2310))));
                                                }
                                                let _e2323 = phi_4919_;
                                                let _e2325 = phi_4920_;
                                                phi_4925_ = _e2323;
                                                phi_4926_ = _e2325;
                                                phi_4927_ = _e2286;
                                            }
                                            let _e2329 = phi_4925_;
                                            let _e2331 = phi_4926_;
                                            let _e2333 = phi_4927_;
                                            phi_4935_ = select(_e2331, _e2329, _e2333);
                                        }
                                        let _e2337 = phi_4935_;
                                        phi_4433_ = _e2337;
                                    } else {
                                        phi_4433_ = _e2260;
                                    }
                                    let _e2339 = phi_4433_;
                                    phi_4434_ = _e2339;
                                }
                                let _e2341 = phi_4434_;
                                let _e2342 = bitcast<u32>(_e2341);
                                if ((_e2342 & 2147483647u) >= 2139095040u) {
                                    phi_4446_ = bitcast<f32>(((_e2342 & 2147483648u) | 2139095039u));
                                } else {
                                    phi_4446_ = _e2341;
                                }
                                let _e2349 = phi_4446_;
                                phi_4451_ = type_24(_e2349, _e2230.member_1, _e2230.member_2, _e2230.member_3);
                            } else {
                                phi_4451_ = type_24(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                            }
                            let _e2352 = phi_4451_;
                            if _e2228 {
                            } else {
                                phi_5514_ = true;
                                break;
                            }
                            local_9[_e2223.member_1] = type_24(_e2352.member, _e2352.member_1, _e2352.member_2, _e2352.member_3);
                        }
                        continue;
                        continuing {
                            phi_4337_ = _e2221;
                            phi_5514_ = _e2206;
                            break if !(_e2227);
                        }
                    }
                    let _e2360 = phi_5514_;
                    if _e2360 {
                        break;
                    }
                    let _e2361 = local_9;
                    if _e162 {
                    } else {
                        break;
                    }
                    global_6.member[_e160] = array<type_24, 8>(type_24(_e2361[0].member, _e2361[0].member_1, _e2361[0].member_2, _e2361[0].member_3), type_24(_e2361[1].member, _e2361[1].member_1, _e2361[1].member_2, _e2361[1].member_3), type_24(_e2361[2].member, _e2361[2].member_1, _e2361[2].member_2, _e2361[2].member_3), type_24(_e2361[3].member, _e2361[3].member_1, _e2361[3].member_2, _e2361[3].member_3), type_24(_e2361[4].member, _e2361[4].member_1, _e2361[4].member_2, _e2361[4].member_3), type_24(_e2361[5].member, _e2361[5].member_1, _e2361[5].member_2, _e2361[5].member_3), type_24(_e2361[6].member, _e2361[6].member_1, _e2361[6].member_2, _e2361[6].member_3), type_24(_e2361[7].member, _e2361[7].member_1, _e2361[7].member_2, _e2361[7].member_3));
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
