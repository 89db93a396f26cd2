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

struct type_31 {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: bool,
}

struct type_33 {
    member: array<type_21>,
}

struct type_37 {
    member: array<array<type_20, 8>>,
}

struct type_43 {
    member: array<vec4<u32>, 2>,
}

struct type_47 {
    member: array<array<u32, 7>>,
}

struct type_52 {
    member: type_24,
    member_1: u32,
}

struct type_53 {
    member: array<vec4<f32>, 3>,
    member_1: type_52,
    member_2: type_52,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_1: type_12;
@group(0) @binding(1) 
var<uniform> global_2: type_43;
@group(0) @binding(4) 
var<storage> global_3: type_33;
@group(0) @binding(2) 
var<storage> global_4: type_47;
@group(0) @binding(3) 
var<storage> global_5: type_4;
@group(0) @binding(5) 
var<storage, read_write> global_6: type_37;

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
    var local_9: array<type_20, 8>;
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
    var phi_2921_: type_31;
    var phi_2922_: type_31;
    var phi_2925_: type_31;
    var phi_2926_: type_31;
    var phi_2927_: bool;
    var phi_2931_: type_31;
    var phi_2940_: type_20;
    var phi_2952_: type_8;
    var phi_2955_: type_20;
    var phi_2953_: type_8;
    var phi_2978_: type_8;
    var phi_3010_: bool;
    var phi_3011_: bool;
    var phi_3032_: type_20;
    var phi_2956_: type_20;
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
    var phi_4451_: type_20;
    var phi_5514_: bool;

    switch bitcast<i32>(0u) {
        default: {
            let _e98 = global;
            let _e100 = arrayLength((&global_4.member));
            let _e103 = arrayLength((&global_5.member));
            let _e111 = global_2.member[0u][0u];
            let _e115 = global_2.member[0u][1u];
            let _e119 = global_2.member[0u][2u];
            let _e123 = global_2.member[0u][3u];
            let _e127 = global_2.member[1u][0u];
            let _e131 = global_2.member[1u][1u];
            let _e135 = global_2.member[1u][2u];
            let _e138 = global_1.member[0u];
            let _e139 = bitcast<i32>(_e138);
            let _e151 = bitcast<f32>((bitcast<u32>((bitcast<i32>(_e123) + 127i)) << bitcast<u32>(23i)));
            local_1 = array<i32, 3>(bitcast<i32>(_e111), bitcast<i32>(_e115), bitcast<i32>(_e119));
            local = array<i32, 3>(bitcast<i32>(_e127), bitcast<i32>(_e131), bitcast<i32>(_e135));
            let _e157 = (_e98.x + (_e98.y * 2097152u));
            let _e158 = (_e157 < arrayLength((&global_3.member)));
            if _e158 {
                let _e159 = (_e157 < arrayLength((&global_6.member)));
                if _e159 {
                    if _e158 {
                    } else {
                        break;
                    }
                    let _e167 = global_3.member[_e157].member_2[0u];
                    let _e169 = (bitcast<u32>(_e167) & 2147483647u);
                    let _e174 = global_3.member[_e157].member_2[1u];
                    let _e176 = (bitcast<u32>(_e174) & 2147483647u);
                    let _e181 = global_3.member[_e157].member_2[2u];
                    let _e183 = (bitcast<u32>(_e181) & 2147483647u);
                    let _e188 = global_3.member[_e157].member[0u];
                    let _e190 = (bitcast<u32>(_e188) & 2147483647u);
                    let _e195 = global_3.member[_e157].member[1u];
                    let _e197 = (bitcast<u32>(_e195) & 2147483647u);
                    let _e202 = global_3.member[_e157].member[2u];
                    let _e204 = (bitcast<u32>(_e202) & 2147483647u);
                    let _e206 = select(_e176, _e169, (_e176 < _e169));
                    let _e208 = select(_e183, _e206, (_e183 < _e206));
                    let _e210 = select(_e190, _e208, (_e190 < _e208));
                    let _e212 = select(_e197, _e210, (_e197 < _e210));
                    let _e214 = select(_e204, _e212, (_e204 < _e212));
                    let _e218 = global_3.member[_e157].member_1;
                    let _e219 = bitcast<u32>(_e218);
                    let _e220 = (_e219 & 2147483647u);
                    let _e227 = global_3.member[_e157].member_3;
                    let _e228 = bitcast<u32>(_e227);
                    let _e229 = (_e228 & 2147483647u);
                    let _e233 = (((select(_e220, _e214, (_e220 < _e214)) < 2139095040u) && (_e229 <= 2139095040u)) && (_e208 > 0u));
                    if _e233 {
                        let _e236 = (bitcast<u32>(bitcast<f32>(_e208)) & 2147483647u);
                        if (_e236 >= 8388608u) {
                            phi_513_ = (bitcast<i32>((_e236 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_513_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e236)), 32u, (_e236 == 0u))));
                        }
                        let _e250 = phi_513_;
                        phi_514_ = _e250;
                    } else {
                        phi_514_ = 0i;
                    }
                    let _e252 = phi_514_;
                    let _e253 = (_e169 == _e208);
                    if _e253 {
                        phi_524_ = true;
                    } else {
                        phi_524_ = (_e176 == _e208);
                    }
                    let _e256 = phi_524_;
                    let _e257 = select(1u, 0u, _e253);
                    if _e256 {
                        let _e258 = (_e257 + 1u);
                        phi_534_ = _e258;
                        phi_535_ = _e258;
                        phi_537_ = select(true, false, (_e258 == 2u));
                    } else {
                        phi_534_ = u32();
                        phi_535_ = 0u;
                        phi_537_ = true;
                    }
                    let _e262 = phi_534_;
                    let _e264 = phi_535_;
                    let _e266 = phi_537_;
                    if _e266 {
                        phi_542_ = (_e264 + 1u);
                    } else {
                        phi_542_ = 0u;
                    }
                    let _e270 = phi_542_;
                    let _e271 = select(_e262, _e264, _e266);
                    let _e272 = select(_e257, select(2u, _e257, _e256), _e266);
                    if (_e139 < -126i) {
                        phi_555_ = -126i;
                    } else {
                        phi_555_ = select(_e139, 127i, (_e139 > 127i));
                    }
                    let _e277 = phi_555_;
                    let _e282 = bitcast<f32>((bitcast<u32>((_e277 + 127i)) << bitcast<u32>(23i)));
                    let _e288 = bitcast<f32>((bitcast<u32>(((_e139 - _e277) + 127i)) << bitcast<u32>(23i)));
                    let _e289 = -(_e252);
                    if (_e289 < -126i) {
                        phi_575_ = -126i;
                    } else {
                        phi_575_ = select(_e289, 127i, (_e289 > 127i));
                    }
                    let _e294 = phi_575_;
                    let _e299 = bitcast<f32>((bitcast<u32>((_e294 + 127i)) << bitcast<u32>(23i)));
                    let _e305 = bitcast<f32>((bitcast<u32>(((_e289 - _e294) + 127i)) << bitcast<u32>(23i)));
                    let _e309 = global_3.member[_e157].member;
                    let _e310 = (_e271 == 0u);
                    if _e310 {
                        phi_593_ = _e309[0];
                    } else {
                        phi_593_ = _e309[1];
                    }
                    let _e314 = phi_593_;
                    let _e315 = (_e271 == 2u);
                    if _e315 {
                        phi_599_ = _e309[2];
                    } else {
                        phi_599_ = _e314;
                    }
                    let _e318 = phi_599_;
                    let _e319 = bitcast<u32>(_e318);
                    let _e321 = ((_e319 & 2139095040u) != 0u);
                    let _e335 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e319 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e319 & 2147483648u))), _e318, _e321) * _e282) * select(0.00000011920929f, 1f, _e321)) * _e288);
                    let _e336 = global_3.member[_e157].member_2;
                    if _e310 {
                        phi_639_ = _e336[0];
                    } else {
                        phi_639_ = _e336[1];
                    }
                    let _e340 = phi_639_;
                    if _e315 {
                        phi_645_ = _e336[2];
                    } else {
                        phi_645_ = _e340;
                    }
                    let _e343 = phi_645_;
                    let _e344 = bitcast<u32>(_e343);
                    let _e346 = ((_e344 & 2139095040u) != 0u);
                    let _e360 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e344 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e344 & 2147483648u))), _e343, _e346) * _e299) * select(0.00000011920929f, 1f, _e346)) * _e305);
                    let _e364 = (bitcast<f32>((bitcast<u32>(_e360) & 2147483647u)) >= 0.00000000000000000086736174f);
                    let _e367 = bitcast<f32>((bitcast<u32>(_e335) & 2147483647u));
                    let _e368 = (_e367 * 0.00000011920929f);
                    let _e371 = select(select(0.00000000000011368684f, _e368, (_e368 > 0.00000000000011368684f)), 0f, _e364);
                    let _e372 = select(0f, _e360, _e364);
                    let _e373 = (_e335 + _e371);
                    let _e374 = (_e335 - _e371);
                    let _e376 = select(38685626000000000000000000f, (1f / _e360), _e364);
                    let _e377 = (_e270 == 0u);
                    if _e377 {
                        phi_718_ = _e309[0];
                    } else {
                        phi_718_ = _e309[1];
                    }
                    let _e381 = phi_718_;
                    let _e382 = (_e270 == 2u);
                    if _e382 {
                        phi_724_ = _e309[2];
                    } else {
                        phi_724_ = _e381;
                    }
                    let _e385 = phi_724_;
                    let _e386 = bitcast<u32>(_e385);
                    let _e388 = ((_e386 & 2139095040u) != 0u);
                    let _e402 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e386 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e386 & 2147483648u))), _e385, _e388) * _e282) * select(0.00000011920929f, 1f, _e388)) * _e288);
                    if _e377 {
                        phi_764_ = _e336[0];
                    } else {
                        phi_764_ = _e336[1];
                    }
                    let _e406 = phi_764_;
                    if _e382 {
                        phi_770_ = _e336[2];
                    } else {
                        phi_770_ = _e406;
                    }
                    let _e409 = phi_770_;
                    let _e410 = bitcast<u32>(_e409);
                    let _e412 = ((_e410 & 2139095040u) != 0u);
                    let _e426 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e410 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e410 & 2147483648u))), _e409, _e412) * _e299) * select(0.00000011920929f, 1f, _e412)) * _e305);
                    let _e430 = (bitcast<f32>((bitcast<u32>(_e426) & 2147483647u)) >= 0.00000000000000000086736174f);
                    let _e433 = bitcast<f32>((bitcast<u32>(_e402) & 2147483647u));
                    let _e434 = (_e433 * 0.00000011920929f);
                    let _e437 = select(select(0.00000000000011368684f, _e434, (_e434 > 0.00000000000011368684f)), 0f, _e430);
                    let _e438 = select(0f, _e426, _e430);
                    let _e439 = (_e402 + _e437);
                    let _e440 = (_e402 - _e437);
                    let _e442 = select(38685626000000000000000000f, (1f / _e426), _e430);
                    let _e443 = (_e272 == 0u);
                    if _e443 {
                        phi_843_ = _e309[0];
                    } else {
                        phi_843_ = _e309[1];
                    }
                    let _e447 = phi_843_;
                    let _e448 = (_e272 == 2u);
                    if _e448 {
                        phi_849_ = _e309[2];
                    } else {
                        phi_849_ = _e447;
                    }
                    let _e451 = phi_849_;
                    let _e452 = bitcast<u32>(_e451);
                    let _e454 = ((_e452 & 2139095040u) != 0u);
                    let _e468 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e452 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e452 & 2147483648u))), _e451, _e454) * _e282) * select(0.00000011920929f, 1f, _e454)) * _e288);
                    if _e443 {
                        phi_889_ = _e336[0];
                    } else {
                        phi_889_ = _e336[1];
                    }
                    let _e472 = phi_889_;
                    if _e448 {
                        phi_895_ = _e336[2];
                    } else {
                        phi_895_ = _e472;
                    }
                    let _e475 = phi_895_;
                    let _e476 = bitcast<u32>(_e475);
                    let _e478 = ((_e476 & 2139095040u) != 0u);
                    let _e492 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e476 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e476 & 2147483648u))), _e475, _e478) * _e299) * select(0.00000011920929f, 1f, _e478)) * _e305);
                    let _e496 = (bitcast<f32>((bitcast<u32>(_e492) & 2147483647u)) >= 0.00000000000000000086736174f);
                    let _e499 = bitcast<f32>((bitcast<u32>(_e468) & 2147483647u));
                    let _e500 = (_e499 * 0.00000011920929f);
                    let _e503 = select(select(0.00000000000011368684f, _e500, (_e500 > 0.00000000000011368684f)), 0f, _e496);
                    let _e504 = select(0f, _e492, _e496);
                    let _e505 = (_e468 + _e503);
                    let _e506 = (_e468 - _e503);
                    let _e508 = select(38685626000000000000000000f, (1f / _e492), _e496);
                    let _e510 = select(_e433, _e367, (_e367 > _e433));
                    let _e513 = (_e139 + _e252);
                    if (_e233 && (select(_e499, _e510, (_e510 > _e499)) <= 1099511600000f)) {
                        let _e523 = ((_e220 & 8388607u) | (select(0u, 1u, ((_e220 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                        let _e526 = bitcast<i32>((_e220 >> bitcast<u32>(23i)));
                        let _e530 = (_e523 == 0u);
                        let _e533 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e523)), 32u, _e530)) - 8i);
                        if (_e526 == 255i) {
                            phi_1014_ = 255i;
                        } else {
                            phi_1014_ = (((_e526 + select(0i, 1i, (_e526 == 0i))) - _e533) + _e513);
                        }
                        let _e541 = phi_1014_;
                        let _e551 = (_e541 <= 0i);
                        if _e551 {
                            phi_1037_ = u32();
                        } else {
                            if _e530 {
                                phi_1036_ = u32();
                            } else {
                                phi_1036_ = select(((bitcast<u32>(_e541) << bitcast<u32>(23i)) | ((_e523 << bitcast<u32>(((_e533 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e541 >= 255i));
                            }
                            let _e555 = phi_1036_;
                            phi_1037_ = _e555;
                        }
                        let _e557 = phi_1037_;
                        let _e569 = ((_e229 & 8388607u) | (select(0u, 1u, ((_e229 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                        let _e572 = bitcast<i32>((_e229 >> bitcast<u32>(23i)));
                        let _e576 = (_e569 == 0u);
                        let _e579 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e569)), 32u, _e576)) - 8i);
                        if (_e572 == 255i) {
                            phi_1074_ = 255i;
                        } else {
                            phi_1074_ = (((_e572 + select(0i, 1i, (_e572 == 0i))) - _e579) + _e513);
                        }
                        let _e587 = phi_1074_;
                        let _e597 = (_e587 <= 0i);
                        if _e597 {
                            phi_1097_ = u32();
                        } else {
                            if _e576 {
                                phi_1096_ = u32();
                            } else {
                                phi_1096_ = select(((bitcast<u32>(_e587) << bitcast<u32>(23i)) | ((_e569 << bitcast<u32>(((_e579 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e587 >= 255i));
                            }
                            let _e601 = phi_1096_;
                            phi_1097_ = _e601;
                        }
                        let _e603 = phi_1097_;
                        phi_1105_ = bitcast<f32>(((_e228 & 2147483648u) | select(_e603, 0u, select(_e576, true, _e597))));
                        phi_1106_ = bitcast<f32>(((_e219 & 2147483648u) | select(_e557, 0u, select(_e530, true, _e551))));
                    } else {
                        phi_1105_ = 0f;
                        phi_1106_ = 1f;
                    }
                    let _e609 = phi_1105_;
                    let _e611 = phi_1106_;
                    local_9 = array<type_20, 8>(type_20(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_20(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_20(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_20(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_20(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_20(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_20(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_20(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u));
                    local_8 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                    local_7 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_6 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_5 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_4 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_3 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_10 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    let _e614 = (_e271 % 3u);
                    let _e615 = (_e614 < 3u);
                    if _e615 {
                    } else {
                        break;
                    }
                    let _e617 = local_1[_e614];
                    let _e620 = (_e270 % 3u);
                    let _e621 = (_e620 < 3u);
                    if _e621 {
                    } else {
                        break;
                    }
                    let _e623 = local_1[_e620];
                    let _e626 = (_e272 % 3u);
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
                    phi_5075_ = false;
                    phi_4988_ = _e609;
                    phi_1255_ = ((3u * _e100) + 1u);
                    phi_1258_ = (_e611 <= _e609);
                    phi_1260_ = 0u;
                    phi_1262_ = type_52(type_24(vec4<f32>((f32(_e617) * _e151), (f32(_e623) * _e151), (f32(_e629) * _e151), 0f), vec4<f32>((f32(_e634) * _e151), (f32(_e638) * _e151), (f32(_e642) * _e151), 0f)), select(0u, 2147483648u, (_e100 == 0u)));
                    loop {
                        let _e652 = phi_5075_;
                        let _e654 = phi_4988_;
                        let _e656 = phi_1255_;
                        let _e658 = phi_1258_;
                        let _e660 = phi_1260_;
                        let _e662 = phi_1262_;
                        if _e658 {
                            phi_1273_ = true;
                        } else {
                            phi_1273_ = (_e660 > 0u);
                        }
                        let _e665 = phi_1273_;
                        if _e665 {
                            let _e666 = (_e656 > 0u);
                            if _e666 {
                                if _e658 {
                                    phi_1360_ = _e658;
                                    phi_1361_ = _e660;
                                    phi_1362_ = _e662;
                                } else {
                                    let _e667 = (_e660 - 1u);
                                    let _e668 = (_e667 % 128u);
                                    let _e669 = (_e668 < 128u);
                                    if _e669 {
                                    } else {
                                        phi_5415_ = true;
                                        break;
                                    }
                                    let _e671 = local_7[_e668];
                                    if _e669 {
                                    } else {
                                        phi_5415_ = true;
                                        break;
                                    }
                                    let _e673 = local_6[_e668];
                                    if _e669 {
                                    } else {
                                        phi_5415_ = true;
                                        break;
                                    }
                                    let _e675 = local_5[_e668];
                                    if _e669 {
                                    } else {
                                        phi_5415_ = true;
                                        break;
                                    }
                                    let _e677 = local_4[_e668];
                                    if _e669 {
                                    } else {
                                        phi_5415_ = true;
                                        break;
                                    }
                                    let _e679 = local_3[_e668];
                                    if _e669 {
                                    } else {
                                        phi_5415_ = true;
                                        break;
                                    }
                                    let _e681 = local_2[_e668];
                                    if _e669 {
                                    } else {
                                        phi_5415_ = true;
                                        break;
                                    }
                                    let _e686 = local_8[_e668];
                                    if _e669 {
                                    } else {
                                        phi_5415_ = true;
                                        break;
                                    }
                                    let _e689 = local_10[_e668];
                                    phi_1360_ = (_e689 <= _e654);
                                    phi_1361_ = _e667;
                                    phi_1362_ = type_52(type_24(vec4<f32>(_e671, _e673, _e675, 0f), vec4<f32>(_e677, _e679, _e681, 0f)), _e686);
                                }
                                let _e692 = phi_1360_;
                                let _e694 = phi_1361_;
                                let _e696 = phi_1362_;
                                if _e692 {
                                    let _e700 = ((_e696.member_1 & 2147483648u) != 0u);
                                    let _e701 = (_e696.member_1 & 268435455u);
                                    if _e700 {
                                        phi_5072_ = _e652;
                                        phi_5013_ = _e654;
                                        phi_1381_ = type_8(0u, ((_e696.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e708 = phi_5072_;
                                            let _e710 = phi_5013_;
                                            let _e712 = phi_1381_;
                                            if (_e712.member < _e712.member_1) {
                                                phi_1382_ = type_8((_e712.member + 1u), _e712.member_1);
                                                phi_1405_ = type_8(1u, _e712.member);
                                            } else {
                                                phi_1382_ = _e712;
                                                phi_1405_ = type_8(0u, type_8().member_1);
                                            }
                                            let _e725 = phi_1382_;
                                            let _e727 = phi_1405_;
                                            let _e731 = (bitcast<i32>(_e727.member) != 0i);
                                            if _e731 {
                                                let _e736 = (_e696.member.member_1.x - _e696.member.member.x);
                                                let _e739 = (_e696.member.member_1.y - _e696.member.member.y);
                                                let _e742 = (_e696.member.member_1.z - _e696.member.member.z);
                                                let _e744 = select(_e739, _e736, (_e736 > _e739));
                                                let _e746 = select(_e742, _e744, (_e744 > _e742));
                                                let _e748 = (_e746 < (1024f * _e151));
                                                if _e748 {
                                                    phi_1446_ = 0u;
                                                } else {
                                                    phi_1446_ = select(2u, 1u, (_e746 < (2097152f * _e151)));
                                                }
                                                let _e753 = phi_1446_;
                                                switch bitcast<i32>(_e753) {
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
                                                let _e756 = phi_1452_;
                                                switch bitcast<i32>(_e753) {
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
                                                let _e763 = phi_1462_;
                                                let _e765 = ((_e701 + (_e727.member_1 * ((3u * _e756) + 1u))) + (3u * _e763));
                                                let _e766 = (_e765 < _e103);
                                                if _e766 {
                                                    if _e766 {
                                                    } else {
                                                        phi_5317_ = _e710;
                                                        phi_5254_ = true;
                                                        break;
                                                    }
                                                    let _e768 = global_5.member[_e765];
                                                    phi_1478_ = _e768;
                                                } else {
                                                    phi_1478_ = 4294967295u;
                                                }
                                                let _e770 = phi_1478_;
                                                if _e748 {
                                                    phi_1511_ = 0u;
                                                } else {
                                                    phi_1511_ = select(2u, 1u, (_e746 < (2097152f * _e151)));
                                                }
                                                let _e775 = phi_1511_;
                                                switch bitcast<i32>(_e775) {
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
                                                let _e778 = phi_1517_;
                                                let _e782 = (_e701 + (_e727.member_1 * ((3u * _e778) + 1u)));
                                                switch bitcast<i32>(_e775) {
                                                    case 0: {
                                                        let _e1057 = (_e782 < _e103);
                                                        if _e1057 {
                                                            if _e1057 {
                                                            } else {
                                                                phi_5317_ = _e710;
                                                                phi_5254_ = true;
                                                                break;
                                                            }
                                                            let _e1059 = global_5.member[_e782];
                                                            phi_1544_ = _e1059;
                                                        } else {
                                                            phi_1544_ = 0u;
                                                        }
                                                        let _e1061 = phi_1544_;
                                                        let _e1063 = ((10u * _e271) & 31u);
                                                        let _e1073 = ((10u * _e270) & 31u);
                                                        let _e1083 = ((10u * _e272) & 31u);
                                                        let _e1093 = (_e782 + 1u);
                                                        let _e1094 = (_e1093 < _e103);
                                                        if _e1094 {
                                                            if _e1094 {
                                                            } else {
                                                                phi_5317_ = _e710;
                                                                phi_5254_ = true;
                                                                break;
                                                            }
                                                            let _e1096 = global_5.member[_e1093];
                                                            phi_1593_ = _e1096;
                                                        } else {
                                                            phi_1593_ = 0u;
                                                        }
                                                        let _e1098 = phi_1593_;
                                                        let _e1124 = (_e782 + 2u);
                                                        let _e1125 = (_e1124 < _e103);
                                                        if _e1125 {
                                                            if _e1125 {
                                                            } else {
                                                                phi_5317_ = _e710;
                                                                phi_5254_ = true;
                                                                break;
                                                            }
                                                            let _e1127 = global_5.member[_e1124];
                                                            phi_1642_ = _e1127;
                                                        } else {
                                                            phi_1642_ = 0u;
                                                        }
                                                        let _e1129 = phi_1642_;
                                                        phi_2143_ = array<array<f32, 3>, 3>(array<f32, 3>((_e696.member.member.x + ((bitcast<f32>((1258291200u | ((_e1061 >> bitcast<u32>(_e1063)) & 1023u))) - 8388608f) * _e151)), (_e696.member.member.y + ((bitcast<f32>((1258291200u | ((_e1061 >> bitcast<u32>(_e1073)) & 1023u))) - 8388608f) * _e151)), (_e696.member.member.z + ((bitcast<f32>((1258291200u | ((_e1061 >> bitcast<u32>(_e1083)) & 1023u))) - 8388608f) * _e151))), array<f32, 3>((_e696.member.member.x + ((bitcast<f32>((1258291200u | ((_e1098 >> bitcast<u32>(_e1063)) & 1023u))) - 8388608f) * _e151)), (_e696.member.member.y + ((bitcast<f32>((1258291200u | ((_e1098 >> bitcast<u32>(_e1073)) & 1023u))) - 8388608f) * _e151)), (_e696.member.member.z + ((bitcast<f32>((1258291200u | ((_e1098 >> bitcast<u32>(_e1083)) & 1023u))) - 8388608f) * _e151))), array<f32, 3>((_e696.member.member.x + ((bitcast<f32>((1258291200u | ((_e1129 >> bitcast<u32>(_e1063)) & 1023u))) - 8388608f) * _e151)), (_e696.member.member.y + ((bitcast<f32>((1258291200u | ((_e1129 >> bitcast<u32>(_e1073)) & 1023u))) - 8388608f) * _e151)), (_e696.member.member.z + ((bitcast<f32>((1258291200u | ((_e1129 >> bitcast<u32>(_e1083)) & 1023u))) - 8388608f) * _e151))));
                                                        break;
                                                    }
                                                    case 1: {
                                                        let _e871 = (_e782 < _e103);
                                                        if _e871 {
                                                            if _e871 {
                                                            } else {
                                                                phi_5317_ = _e710;
                                                                phi_5254_ = true;
                                                                break;
                                                            }
                                                            let _e873 = global_5.member[_e782];
                                                            phi_1691_ = _e873;
                                                        } else {
                                                            phi_1691_ = 0u;
                                                        }
                                                        let _e875 = phi_1691_;
                                                        let _e876 = (_e782 + 1u);
                                                        let _e877 = (_e876 < _e103);
                                                        if _e877 {
                                                            if _e877 {
                                                            } else {
                                                                phi_5317_ = _e710;
                                                                phi_5254_ = true;
                                                                break;
                                                            }
                                                            let _e879 = global_5.member[_e876];
                                                            phi_1706_ = _e879;
                                                        } else {
                                                            phi_1706_ = 0u;
                                                        }
                                                        let _e881 = phi_1706_;
                                                        let _e882 = (_e271 == 1u);
                                                        if _e882 {
                                                            phi_1716_ = ((_e875 >> bitcast<u32>(21i)) | (_e881 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1716_ = (_e881 >> bitcast<u32>(10i));
                                                        }
                                                        let _e891 = phi_1716_;
                                                        let _e899 = (_e270 == 1u);
                                                        if _e899 {
                                                            phi_1737_ = ((_e875 >> bitcast<u32>(21i)) | (_e881 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1737_ = (_e881 >> bitcast<u32>(10i));
                                                        }
                                                        let _e908 = phi_1737_;
                                                        let _e916 = (_e272 == 1u);
                                                        if _e916 {
                                                            phi_1758_ = ((_e875 >> bitcast<u32>(21i)) | (_e881 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1758_ = (_e881 >> bitcast<u32>(10i));
                                                        }
                                                        let _e925 = phi_1758_;
                                                        let _e934 = (_e782 + 2u);
                                                        let _e935 = (_e934 < _e103);
                                                        if _e935 {
                                                            if _e935 {
                                                            } else {
                                                                phi_5317_ = _e710;
                                                                phi_5254_ = true;
                                                                break;
                                                            }
                                                            let _e937 = global_5.member[_e934];
                                                            phi_1788_ = _e937;
                                                        } else {
                                                            phi_1788_ = 0u;
                                                        }
                                                        let _e939 = phi_1788_;
                                                        let _e940 = (_e782 + 3u);
                                                        let _e941 = (_e940 < _e103);
                                                        if _e941 {
                                                            if _e941 {
                                                            } else {
                                                                phi_5317_ = _e710;
                                                                phi_5254_ = true;
                                                                break;
                                                            }
                                                            let _e943 = global_5.member[_e940];
                                                            phi_1803_ = _e943;
                                                        } else {
                                                            phi_1803_ = 0u;
                                                        }
                                                        let _e945 = phi_1803_;
                                                        if _e882 {
                                                            phi_1813_ = ((_e939 >> bitcast<u32>(21i)) | (_e945 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1813_ = (_e945 >> bitcast<u32>(10i));
                                                        }
                                                        let _e954 = phi_1813_;
                                                        if _e899 {
                                                            phi_1834_ = ((_e939 >> bitcast<u32>(21i)) | (_e945 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1834_ = (_e945 >> bitcast<u32>(10i));
                                                        }
                                                        let _e970 = phi_1834_;
                                                        if _e916 {
                                                            phi_1855_ = ((_e939 >> bitcast<u32>(21i)) | (_e945 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1855_ = (_e945 >> bitcast<u32>(10i));
                                                        }
                                                        let _e986 = phi_1855_;
                                                        let _e995 = (_e782 + 4u);
                                                        let _e996 = (_e995 < _e103);
                                                        if _e996 {
                                                            if _e996 {
                                                            } else {
                                                                phi_5317_ = _e710;
                                                                phi_5254_ = true;
                                                                break;
                                                            }
                                                            let _e998 = global_5.member[_e995];
                                                            phi_1885_ = _e998;
                                                        } else {
                                                            phi_1885_ = 0u;
                                                        }
                                                        let _e1000 = phi_1885_;
                                                        let _e1001 = (_e782 + 5u);
                                                        let _e1002 = (_e1001 < _e103);
                                                        if _e1002 {
                                                            if _e1002 {
                                                            } else {
                                                                phi_5317_ = _e710;
                                                                phi_5254_ = true;
                                                                break;
                                                            }
                                                            let _e1004 = global_5.member[_e1001];
                                                            phi_1900_ = _e1004;
                                                        } else {
                                                            phi_1900_ = 0u;
                                                        }
                                                        let _e1006 = phi_1900_;
                                                        if _e882 {
                                                            phi_1910_ = ((_e1000 >> bitcast<u32>(21i)) | (_e1006 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1910_ = (_e1006 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1015 = phi_1910_;
                                                        if _e899 {
                                                            phi_1931_ = ((_e1000 >> bitcast<u32>(21i)) | (_e1006 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1931_ = (_e1006 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1031 = phi_1931_;
                                                        if _e916 {
                                                            phi_1952_ = ((_e1000 >> bitcast<u32>(21i)) | (_e1006 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1952_ = (_e1006 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1047 = phi_1952_;
                                                        phi_2143_ = array<array<f32, 3>, 3>(array<f32, 3>((_e696.member.member.x + ((bitcast<f32>((1258291200u | (select(_e891, _e875, _e310) & 2097151u))) - 8388608f) * _e151)), (_e696.member.member.y + ((bitcast<f32>((1258291200u | (select(_e908, _e875, _e377) & 2097151u))) - 8388608f) * _e151)), (_e696.member.member.z + ((bitcast<f32>((1258291200u | (select(_e925, _e875, _e443) & 2097151u))) - 8388608f) * _e151))), array<f32, 3>((_e696.member.member.x + ((bitcast<f32>((1258291200u | (select(_e954, _e939, _e310) & 2097151u))) - 8388608f) * _e151)), (_e696.member.member.y + ((bitcast<f32>((1258291200u | (select(_e970, _e939, _e377) & 2097151u))) - 8388608f) * _e151)), (_e696.member.member.z + ((bitcast<f32>((1258291200u | (select(_e986, _e939, _e443) & 2097151u))) - 8388608f) * _e151))), array<f32, 3>((_e696.member.member.x + ((bitcast<f32>((1258291200u | (select(_e1015, _e1000, _e310) & 2097151u))) - 8388608f) * _e151)), (_e696.member.member.y + ((bitcast<f32>((1258291200u | (select(_e1031, _e1000, _e377) & 2097151u))) - 8388608f) * _e151)), (_e696.member.member.z + ((bitcast<f32>((1258291200u | (select(_e1047, _e1000, _e443) & 2097151u))) - 8388608f) * _e151))));
                                                        break;
                                                    }
                                                    case 2: {
                                                        let _e784 = (_e782 + _e271);
                                                        let _e785 = (_e784 < _e103);
                                                        if _e785 {
                                                            if _e785 {
                                                            } else {
                                                                phi_5317_ = _e710;
                                                                phi_5254_ = true;
                                                                break;
                                                            }
                                                            let _e787 = global_5.member[_e784];
                                                            phi_1983_ = _e787;
                                                        } else {
                                                            phi_1983_ = 0u;
                                                        }
                                                        let _e789 = phi_1983_;
                                                        let _e793 = (_e782 + _e270);
                                                        let _e794 = (_e793 < _e103);
                                                        if _e794 {
                                                            if _e794 {
                                                            } else {
                                                                phi_5317_ = _e710;
                                                                phi_5254_ = true;
                                                                break;
                                                            }
                                                            let _e796 = global_5.member[_e793];
                                                            phi_2001_ = _e796;
                                                        } else {
                                                            phi_2001_ = 0u;
                                                        }
                                                        let _e798 = phi_2001_;
                                                        let _e802 = (_e782 + _e272);
                                                        let _e803 = (_e802 < _e103);
                                                        if _e803 {
                                                            if _e803 {
                                                            } else {
                                                                phi_5317_ = _e710;
                                                                phi_5254_ = true;
                                                                break;
                                                            }
                                                            let _e805 = global_5.member[_e802];
                                                            phi_2019_ = _e805;
                                                        } else {
                                                            phi_2019_ = 0u;
                                                        }
                                                        let _e807 = phi_2019_;
                                                        let _e812 = (_e782 + 3u);
                                                        let _e813 = (_e812 + _e271);
                                                        let _e814 = (_e813 < _e103);
                                                        if _e814 {
                                                            if _e814 {
                                                            } else {
                                                                phi_5317_ = _e710;
                                                                phi_5254_ = true;
                                                                break;
                                                            }
                                                            let _e816 = global_5.member[_e813];
                                                            phi_2042_ = _e816;
                                                        } else {
                                                            phi_2042_ = 0u;
                                                        }
                                                        let _e818 = phi_2042_;
                                                        let _e822 = (_e812 + _e270);
                                                        let _e823 = (_e822 < _e103);
                                                        if _e823 {
                                                            if _e823 {
                                                            } else {
                                                                phi_5317_ = _e710;
                                                                phi_5254_ = true;
                                                                break;
                                                            }
                                                            let _e825 = global_5.member[_e822];
                                                            phi_2060_ = _e825;
                                                        } else {
                                                            phi_2060_ = 0u;
                                                        }
                                                        let _e827 = phi_2060_;
                                                        let _e831 = (_e812 + _e272);
                                                        let _e832 = (_e831 < _e103);
                                                        if _e832 {
                                                            if _e832 {
                                                            } else {
                                                                phi_5317_ = _e710;
                                                                phi_5254_ = true;
                                                                break;
                                                            }
                                                            let _e834 = global_5.member[_e831];
                                                            phi_2078_ = _e834;
                                                        } else {
                                                            phi_2078_ = 0u;
                                                        }
                                                        let _e836 = phi_2078_;
                                                        let _e841 = (_e782 + 6u);
                                                        let _e842 = (_e841 + _e271);
                                                        let _e843 = (_e842 < _e103);
                                                        if _e843 {
                                                            if _e843 {
                                                            } else {
                                                                phi_5317_ = _e710;
                                                                phi_5254_ = true;
                                                                break;
                                                            }
                                                            let _e845 = global_5.member[_e842];
                                                            phi_2101_ = _e845;
                                                        } else {
                                                            phi_2101_ = 0u;
                                                        }
                                                        let _e847 = phi_2101_;
                                                        let _e851 = (_e841 + _e270);
                                                        let _e852 = (_e851 < _e103);
                                                        if _e852 {
                                                            if _e852 {
                                                            } else {
                                                                phi_5317_ = _e710;
                                                                phi_5254_ = true;
                                                                break;
                                                            }
                                                            let _e854 = global_5.member[_e851];
                                                            phi_2119_ = _e854;
                                                        } else {
                                                            phi_2119_ = 0u;
                                                        }
                                                        let _e856 = phi_2119_;
                                                        let _e860 = (_e841 + _e272);
                                                        let _e861 = (_e860 < _e103);
                                                        if _e861 {
                                                            if _e861 {
                                                            } else {
                                                                phi_5317_ = _e710;
                                                                phi_5254_ = true;
                                                                break;
                                                            }
                                                            let _e863 = global_5.member[_e860];
                                                            phi_2137_ = _e863;
                                                        } else {
                                                            phi_2137_ = 0u;
                                                        }
                                                        let _e865 = phi_2137_;
                                                        phi_2143_ = array<array<f32, 3>, 3>(array<f32, 3>((f32(bitcast<i32>(_e789)) * _e151), (f32(bitcast<i32>(_e798)) * _e151), (f32(bitcast<i32>(_e807)) * _e151)), array<f32, 3>((f32(bitcast<i32>(_e818)) * _e151), (f32(bitcast<i32>(_e827)) * _e151), (f32(bitcast<i32>(_e836)) * _e151)), array<f32, 3>((f32(bitcast<i32>(_e847)) * _e151), (f32(bitcast<i32>(_e856)) * _e151), (f32(bitcast<i32>(_e865)) * _e151)));
                                                        break;
                                                    }
                                                    default: {
                                                        phi_2143_ = array<array<f32, 3>, 3>();
                                                        break;
                                                    }
                                                }
                                                let _e1157 = phi_2143_;
                                                let _e1172 = (_e1157[0][2] - _e468);
                                                let _e1175 = (((_e1157[0][0] - _e335) * _e504) - (_e1172 * _e372));
                                                let _e1178 = (((_e1157[0][1] - _e402) * _e504) - (_e1172 * _e438));
                                                let _e1181 = (_e1157[1][2] - _e468);
                                                let _e1184 = (((_e1157[1][0] - _e335) * _e504) - (_e1181 * _e372));
                                                let _e1187 = (((_e1157[1][1] - _e402) * _e504) - (_e1181 * _e438));
                                                let _e1190 = (_e1157[2][2] - _e468);
                                                let _e1193 = (((_e1157[2][0] - _e335) * _e504) - (_e1190 * _e372));
                                                let _e1196 = (((_e1157[2][1] - _e402) * _e504) - (_e1190 * _e438));
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
                                                    let _e1231 = select(_e1157[1][0], _e1157[0][0], (_e1157[0][0] < _e1157[1][0]));
                                                    let _e1235 = select(_e1157[1][0], _e1157[0][0], (_e1157[0][0] > _e1157[1][0]));
                                                    let _e1239 = select(_e1157[1][1], _e1157[0][1], (_e1157[0][1] < _e1157[1][1]));
                                                    let _e1243 = select(_e1157[1][1], _e1157[0][1], (_e1157[0][1] > _e1157[1][1]));
                                                    let _e1247 = select(_e1157[1][2], _e1157[0][2], (_e1157[0][2] < _e1157[1][2]));
                                                    let _e1251 = select(_e1157[1][2], _e1157[0][2], (_e1157[0][2] > _e1157[1][2]));
                                                    let _e1256 = ((select(_e1157[2][0], _e1231, (_e1231 < _e1157[2][0])) - _e373) * _e376);
                                                    let _e1257 = ((select(_e1157[2][0], _e1235, (_e1235 > _e1157[2][0])) - _e374) * _e376);
                                                    let _e1260 = ((select(_e1157[2][1], _e1239, (_e1239 < _e1157[2][1])) - _e439) * _e442);
                                                    let _e1261 = ((select(_e1157[2][1], _e1243, (_e1243 > _e1157[2][1])) - _e440) * _e442);
                                                    let _e1264 = ((select(_e1157[2][2], _e1247, (_e1247 < _e1157[2][2])) - _e505) * _e508);
                                                    let _e1265 = ((select(_e1157[2][2], _e1251, (_e1251 > _e1157[2][2])) - _e506) * _e508);
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
                                                    let _e1292 = select(_e611, _e1277, (_e1277 > _e611));
                                                    let _e1296 = select(_e1184, _e1175, (_e1175 < _e1184));
                                                    let _e1301 = select(_e1184, _e1175, (_e1175 > _e1184));
                                                    let _e1308 = select(_e1187, _e1178, (_e1178 < _e1187));
                                                    let _e1313 = select(_e1187, _e1178, (_e1178 > _e1187));
                                                    let _e1322 = (((((_e1213 && (_e1229 >= 0.000000000000000000000000000000000000011754944f)) && ((select(_e1193, _e1296, (_e1296 < _e1193)) <= 0f) && (select(_e1193, _e1301, (_e1301 > _e1193)) >= 0f))) && ((select(_e1196, _e1308, (_e1308 < _e1196)) <= 0f) && (select(_e1196, _e1313, (_e1313 > _e1196)) >= 0f))) && (_e1292 <= (_e1285 + (select(_e1286, _e1269, (_e1269 > _e1286)) * 0.0000019073523f)))) && (_e1292 <= _e710));
                                                    if _e1322 {
                                                        let _e1327 = (_e1157[1][0] - _e1157[0][0]);
                                                        let _e1328 = (_e1157[1][1] - _e1157[0][1]);
                                                        let _e1329 = (_e1157[1][2] - _e1157[0][2]);
                                                        let _e1330 = vec3<f32>(_e1327, _e1328, _e1329);
                                                        let _e1331 = (_e1157[2][0] - _e1157[1][0]);
                                                        let _e1332 = (_e1157[2][1] - _e1157[1][1]);
                                                        let _e1333 = (_e1157[2][2] - _e1157[1][2]);
                                                        let _e1334 = vec3<f32>(_e1331, _e1332, _e1333);
                                                        let _e1335 = (_e1157[0][0] - _e1157[2][0]);
                                                        let _e1336 = (_e1157[0][1] - _e1157[2][1]);
                                                        let _e1337 = (_e1157[0][2] - _e1157[2][2]);
                                                        let _e1338 = vec3<f32>(_e1335, _e1336, _e1337);
                                                        let _e1339 = abs(_e1327);
                                                        let _e1340 = abs(_e1328);
                                                        if (_e1339 != _e1339) {
                                                            phi_4544_ = true;
                                                        } else {
                                                            phi_4544_ = (_e1340 >= _e1339);
                                                        }
                                                        let _e1344 = phi_4544_;
                                                        let _e1345 = select(_e1339, _e1340, _e1344);
                                                        let _e1346 = abs(_e1329);
                                                        if (_e1345 != _e1345) {
                                                            phi_4559_ = true;
                                                        } else {
                                                            phi_4559_ = (_e1346 >= _e1345);
                                                        }
                                                        let _e1350 = phi_4559_;
                                                        let _e1351 = select(_e1345, _e1346, _e1350);
                                                        let _e1352 = abs(_e1331);
                                                        let _e1353 = abs(_e1332);
                                                        if (_e1352 != _e1352) {
                                                            phi_4574_ = true;
                                                        } else {
                                                            phi_4574_ = (_e1353 >= _e1352);
                                                        }
                                                        let _e1357 = phi_4574_;
                                                        let _e1358 = select(_e1352, _e1353, _e1357);
                                                        let _e1359 = abs(_e1333);
                                                        if (_e1358 != _e1358) {
                                                            phi_4589_ = true;
                                                        } else {
                                                            phi_4589_ = (_e1359 >= _e1358);
                                                        }
                                                        let _e1363 = phi_4589_;
                                                        let _e1364 = select(_e1358, _e1359, _e1363);
                                                        let _e1365 = abs(_e1335);
                                                        let _e1366 = abs(_e1336);
                                                        if (_e1365 != _e1365) {
                                                            phi_4604_ = true;
                                                        } else {
                                                            phi_4604_ = (_e1366 >= _e1365);
                                                        }
                                                        let _e1370 = phi_4604_;
                                                        let _e1371 = select(_e1365, _e1366, _e1370);
                                                        let _e1372 = abs(_e1337);
                                                        if (_e1371 != _e1371) {
                                                            phi_4619_ = true;
                                                        } else {
                                                            phi_4619_ = (_e1372 >= _e1371);
                                                        }
                                                        let _e1376 = phi_4619_;
                                                        let _e1377 = select(_e1371, _e1372, _e1376);
                                                        let _e1379 = select(_e1364, _e1351, (_e1351 > _e1364));
                                                        let _e1381 = select(_e1377, _e1379, (_e1379 > _e1377));
                                                        if (_e1351 == _e1381) {
                                                            phi_2686_ = _e1187;
                                                            phi_2687_ = _e1184;
                                                            phi_2688_ = _e1178;
                                                            phi_2689_ = _e1175;
                                                            phi_2690_ = vec3<f32>(_e1157[0][0], _e1157[0][1], _e1157[0][2]);
                                                            phi_2691_ = _e1338;
                                                            phi_2692_ = _e1334;
                                                            phi_2693_ = _e1330;
                                                        } else {
                                                            let _e1383 = (_e1364 == _e1381);
                                                            let _e1388 = vec3(_e1383);
                                                            phi_2686_ = select(_e1178, _e1196, _e1383);
                                                            phi_2687_ = select(_e1175, _e1193, _e1383);
                                                            phi_2688_ = select(_e1196, _e1187, _e1383);
                                                            phi_2689_ = select(_e1193, _e1184, _e1383);
                                                            phi_2690_ = select(vec3<f32>(_e1157[2][0], _e1157[2][1], _e1157[2][2]), vec3<f32>(_e1157[1][0], _e1157[1][1], _e1157[1][2]), _e1388);
                                                            phi_2691_ = select(_e1334, _e1330, _e1388);
                                                            phi_2692_ = select(_e1330, _e1338, _e1388);
                                                            phi_2693_ = select(_e1338, _e1334, _e1388);
                                                        }
                                                        let _e1394 = phi_2686_;
                                                        let _e1396 = phi_2687_;
                                                        let _e1398 = phi_2688_;
                                                        let _e1400 = phi_2689_;
                                                        let _e1402 = phi_2690_;
                                                        let _e1404 = phi_2691_;
                                                        let _e1406 = phi_2692_;
                                                        let _e1408 = phi_2693_;
                                                        let _e1415 = ((_e1406.y * _e1404.z) - (_e1404.y * _e1406.z));
                                                        let _e1420 = ((_e1406.z * _e1404.x) - (_e1404.z * _e1406.x));
                                                        let _e1423 = ((_e1406.x * _e1404.y) - (_e1404.x * _e1406.y));
                                                        let _e1426 = ((_e1219 >= _e1223) && (_e1219 >= _e1227));
                                                        let _e1427 = (_e1223 >= _e1227);
                                                        let _e1441 = (((_e1415 * (select(select(_e1157[2][0], _e1157[1][0], _e1427), _e1157[0][0], _e1426) - _e335)) + (_e1420 * (select(select(_e1157[2][1], _e1157[1][1], _e1427), _e1157[0][1], _e1426) - _e402))) + (_e1423 * (select(select(_e1157[2][2], _e1157[1][2], _e1427), _e1157[0][2], _e1426) - _e468)));
                                                        let _e1446 = (((_e1415 * _e372) + (_e1420 * _e438)) + (_e1423 * _e504));
                                                        let _e1447 = (_e1396 - _e1400);
                                                        let _e1448 = (_e1394 - _e1398);
                                                        let _e1451 = ((_e1447 * _e1447) + (_e1448 * _e1448));
                                                        let _e1458 = (-(((_e1400 * _e1447) + (_e1398 * _e1448))) / select(0.000000000000000000000000000000000000011754944f, _e1451, (_e1451 > 0.000000000000000000000000000000000000011754944f)));
                                                        let _e1460 = select(1f, _e1458, (_e1458 < 1f));
                                                        let _e1462 = select(0f, _e1460, (_e1460 > 0f));
                                                        let _e1471 = ((_e1402.x + (_e1408.x * _e1462)) - _e335);
                                                        let _e1474 = ((_e1402.y + (_e1408.y * _e1462)) - _e402);
                                                        let _e1477 = ((_e1402.z + (_e1408.z * _e1462)) - _e468);
                                                        let _e1480 = bitcast<f32>((bitcast<u32>(_e1471) & 2147483647u));
                                                        let _e1483 = bitcast<f32>((bitcast<u32>(_e1474) & 2147483647u));
                                                        let _e1485 = select(_e1483, _e1480, (_e1480 > _e1483));
                                                        let _e1488 = bitcast<f32>((bitcast<u32>(_e1477) & 2147483647u));
                                                        let _e1490 = select(_e1488, _e1485, (_e1485 > _e1488));
                                                        let _e1494 = abs(_e1415);
                                                        let _e1495 = abs(_e1420);
                                                        if (_e1494 != _e1494) {
                                                            phi_4634_ = true;
                                                        } else {
                                                            phi_4634_ = (_e1495 >= _e1494);
                                                        }
                                                        let _e1499 = phi_4634_;
                                                        let _e1500 = select(_e1494, _e1495, _e1499);
                                                        let _e1501 = abs(_e1423);
                                                        if (_e1500 != _e1500) {
                                                            phi_4649_ = true;
                                                        } else {
                                                            phi_4649_ = (_e1501 >= _e1500);
                                                        }
                                                        let _e1505 = phi_4649_;
                                                        let _e1521 = abs(_e1406.x);
                                                        let _e1522 = abs(_e1406.y);
                                                        if (_e1521 != _e1521) {
                                                            phi_4664_ = true;
                                                        } else {
                                                            phi_4664_ = (_e1522 >= _e1521);
                                                        }
                                                        let _e1526 = phi_4664_;
                                                        let _e1527 = select(_e1521, _e1522, _e1526);
                                                        let _e1528 = abs(_e1406.z);
                                                        if (_e1527 != _e1527) {
                                                            phi_4679_ = true;
                                                        } else {
                                                            phi_4679_ = (_e1528 >= _e1527);
                                                        }
                                                        let _e1532 = phi_4679_;
                                                        let _e1535 = abs(_e1404.x);
                                                        let _e1536 = abs(_e1404.y);
                                                        if (_e1535 != _e1535) {
                                                            phi_4694_ = true;
                                                        } else {
                                                            phi_4694_ = (_e1536 >= _e1535);
                                                        }
                                                        let _e1540 = phi_4694_;
                                                        let _e1541 = select(_e1535, _e1536, _e1540);
                                                        let _e1542 = abs(_e1404.z);
                                                        if (_e1541 != _e1541) {
                                                            phi_4709_ = true;
                                                        } else {
                                                            phi_4709_ = (_e1542 >= _e1541);
                                                        }
                                                        let _e1546 = phi_4709_;
                                                        let _e1551 = ((bitcast<f32>((bitcast<u32>(((((_e1415 * _e1471) + (_e1420 * _e1474)) + (_e1423 * _e1477)) - _e1441)) & 2147483647u)) <= ((0.0000009536743f * select(_e1381, _e1490, (_e1490 > _e1381))) * select(_e1500, _e1501, _e1505))) && !((bitcast<f32>((bitcast<u32>(_e1446) & 2147483647u)) <= ((0.0000038146973f * select(_e1527, _e1528, _e1532)) * select(_e1541, _e1542, _e1546)))));
                                                        let _e1552 = (_e1441 / _e1446);
                                                        if (_e1322 && !(_e1551)) {
                                                            let _e1555 = (_e1477 / _e504);
                                                            let _e1563 = (((_e1415 * (_e1471 - (_e372 * _e1555))) + (_e1420 * (_e1474 - (_e438 * _e1555)))) / _e1446);
                                                            phi_2901_ = select(select(_e1555, (_e1555 + _e1563), (bitcast<f32>((bitcast<u32>(_e1563) & 2147483647u)) <= _e1381)), _e1552, _e1551);
                                                        } else {
                                                            phi_2901_ = _e1552;
                                                        }
                                                        let _e1572 = phi_2901_;
                                                        let _e1574 = select(_e1285, _e1572, (_e1572 < _e1285));
                                                        let _e1576 = select(_e1277, _e1574, (_e1574 > _e1277));
                                                        let _e1577 = (1f / _e1229);
                                                        phi_2921_ = type_31(_e1576, (_e1223 * _e1577), (_e1227 * _e1577), ((_e1322 && (_e1576 >= _e611)) && (_e1576 <= _e710)));
                                                        phi_2922_ = type_31();
                                                    } else {
                                                        phi_2921_ = type_31();
                                                        phi_2922_ = type_31(0f, 0f, 0f, _e1322);
                                                    }
                                                    let _e1586 = phi_2921_;
                                                    let _e1588 = phi_2922_;
                                                    phi_2925_ = _e1586;
                                                    phi_2926_ = _e1588;
                                                    phi_2927_ = select(true, false, _e1322);
                                                } else {
                                                    phi_2925_ = type_31();
                                                    phi_2926_ = type_31(0f, 0f, 0f, _e1213);
                                                    phi_2927_ = true;
                                                }
                                                let _e1591 = phi_2925_;
                                                let _e1593 = phi_2926_;
                                                let _e1595 = phi_2927_;
                                                if _e1595 {
                                                    phi_2931_ = _e1593;
                                                } else {
                                                    phi_2931_ = _e1591;
                                                }
                                                let _e1597 = phi_2931_;
                                                if _e1597.member_3 {
                                                    phi_2940_ = type_20(_e1597.member, _e1597.member_1, _e1597.member_2, _e770);
                                                } else {
                                                    phi_2940_ = type_20(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                }
                                                let _e1604 = phi_2940_;
                                                if (_e1604.member_3 != 4294967295u) {
                                                    if (_e770 != 4294967295u) {
                                                        phi_2952_ = type_8(0u, 8u);
                                                        phi_2955_ = _e1604;
                                                        loop {
                                                            let _e1609 = phi_2952_;
                                                            let _e1611 = phi_2955_;
                                                            if (_e1609.member < _e1609.member_1) {
                                                                phi_2953_ = type_8((_e1609.member + 1u), _e1609.member_1);
                                                                phi_2978_ = type_8(1u, _e1609.member);
                                                            } else {
                                                                phi_2953_ = _e1609;
                                                                phi_2978_ = type_8(0u, type_8().member_1);
                                                            }
                                                            let _e1624 = phi_2953_;
                                                            let _e1626 = phi_2978_;
                                                            let _e1630 = (bitcast<i32>(_e1626.member) != 0i);
                                                            if _e1630 {
                                                                let _e1631 = (_e1626.member_1 < 8u);
                                                                if _e1631 {
                                                                } else {
                                                                    phi_5042_ = true;
                                                                    break;
                                                                }
                                                                let _e1636 = local_9[_e1626.member_1].member;
                                                                if (_e1611.member < _e1636) {
                                                                    phi_3011_ = true;
                                                                } else {
                                                                    let _e1638 = local_9[_e1626.member_1].member;
                                                                    if (_e1611.member == _e1638) {
                                                                        let _e1643 = local_9[_e1626.member_1].member_3;
                                                                        phi_3010_ = (_e1611.member_3 < _e1643);
                                                                    } else {
                                                                        phi_3010_ = false;
                                                                    }
                                                                    let _e1646 = phi_3010_;
                                                                    phi_3011_ = _e1646;
                                                                }
                                                                let _e1648 = phi_3011_;
                                                                if _e1648 {
                                                                    if _e1631 {
                                                                    } else {
                                                                        phi_5042_ = true;
                                                                        break;
                                                                    }
                                                                    let _e1649 = local_9[_e1626.member_1];
                                                                    local_9[_e1626.member_1] = type_20(_e1611.member, _e1611.member_1, _e1611.member_2, _e1611.member_3);
                                                                    phi_3032_ = type_20(_e1649.member, _e1649.member_1, _e1649.member_2, _e1649.member_3);
                                                                } else {
                                                                    phi_3032_ = _e1611;
                                                                }
                                                                let _e1660 = phi_3032_;
                                                                phi_2956_ = _e1660;
                                                            } else {
                                                                phi_2956_ = type_20();
                                                            }
                                                            let _e1662 = phi_2956_;
                                                            continue;
                                                            continuing {
                                                                phi_2952_ = _e1624;
                                                                phi_2955_ = _e1662;
                                                                phi_5042_ = _e708;
                                                                break if !(_e1630);
                                                            }
                                                        }
                                                        let _e1665 = phi_5042_;
                                                        phi_5317_ = _e710;
                                                        phi_5254_ = _e1665;
                                                        if _e1665 {
                                                            break;
                                                        }
                                                        let _e1668 = local_9[7u].member_3;
                                                        if (_e1668 != 4294967295u) {
                                                            let _e1672 = local_9[7u].member;
                                                            phi_5413_ = _e1672;
                                                        } else {
                                                            phi_5413_ = _e710;
                                                        }
                                                        let _e1674 = phi_5413_;
                                                        phi_5412_ = _e1674;
                                                        phi_5257_ = _e1665;
                                                    } else {
                                                        phi_5412_ = _e710;
                                                        phi_5257_ = _e708;
                                                    }
                                                    let _e1676 = phi_5412_;
                                                    let _e1678 = phi_5257_;
                                                    phi_5411_ = _e1676;
                                                    phi_5256_ = _e1678;
                                                } else {
                                                    phi_5411_ = _e710;
                                                    phi_5256_ = _e708;
                                                }
                                                let _e1680 = phi_5411_;
                                                let _e1682 = phi_5256_;
                                                phi_5410_ = _e1680;
                                                phi_5255_ = _e1682;
                                            } else {
                                                phi_5410_ = _e710;
                                                phi_5255_ = _e708;
                                            }
                                            let _e1684 = phi_5410_;
                                            let _e1686 = phi_5255_;
                                            continue;
                                            continuing {
                                                phi_5072_ = _e1686;
                                                phi_5013_ = _e1684;
                                                phi_1381_ = _e725;
                                                phi_5317_ = _e1684;
                                                phi_5254_ = _e1686;
                                                break if !(_e731);
                                            }
                                        }
                                        let _e1689 = phi_5317_;
                                        let _e1691 = phi_5254_;
                                        phi_5415_ = _e1691;
                                        if _e1691 {
                                            break;
                                        }
                                        phi_5506_ = _e1691;
                                        phi_5316_ = _e1689;
                                    } else {
                                        phi_5506_ = _e652;
                                        phi_5316_ = _e654;
                                    }
                                    let _e1693 = phi_5506_;
                                    let _e1695 = phi_5316_;
                                    if _e700 {
                                        phi_4309_ = bool();
                                        phi_4310_ = u32();
                                        phi_4311_ = type_52();
                                    } else {
                                        if (_e696.member_1 >= _e100) {
                                            phi_3844_ = type_53(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), type_52(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u), type_52(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u));
                                        } else {
                                            if (_e696.member_1 < _e100) {
                                            } else {
                                                phi_5415_ = true;
                                                break;
                                            }
                                            let _e1698 = (_e271 * 2u);
                                            let _e1700 = ((1u + _e1698) % 7u);
                                            if (_e1700 < 7u) {
                                            } else {
                                                phi_5415_ = true;
                                                break;
                                            }
                                            let _e1705 = global_4.member[_e696.member_1][_e1700];
                                            let _e1707 = ((_e1698 + 2u) % 7u);
                                            if (_e1707 < 7u) {
                                            } else {
                                                phi_5415_ = true;
                                                break;
                                            }
                                            let _e1712 = global_4.member[_e696.member_1][_e1707];
                                            let _e1713 = (_e270 * 2u);
                                            let _e1715 = ((1u + _e1713) % 7u);
                                            if (_e1715 < 7u) {
                                            } else {
                                                phi_5415_ = true;
                                                break;
                                            }
                                            let _e1720 = global_4.member[_e696.member_1][_e1715];
                                            let _e1722 = ((_e1713 + 2u) % 7u);
                                            if (_e1722 < 7u) {
                                            } else {
                                                phi_5415_ = true;
                                                break;
                                            }
                                            let _e1727 = global_4.member[_e696.member_1][_e1722];
                                            let _e1728 = (_e272 * 2u);
                                            let _e1730 = ((1u + _e1728) % 7u);
                                            if (_e1730 < 7u) {
                                            } else {
                                                phi_5415_ = true;
                                                break;
                                            }
                                            let _e1735 = global_4.member[_e696.member_1][_e1730];
                                            let _e1737 = ((_e1728 + 2u) % 7u);
                                            if (_e1737 < 7u) {
                                            } else {
                                                phi_5415_ = true;
                                                break;
                                            }
                                            let _e1742 = global_4.member[_e696.member_1][_e1737];
                                            let _e1765 = (bitcast<f32>((bitcast<u32>((_e696.member.member_1.x - _e696.member.member.x)) & 2139095040u)) * 0.0000009536743f);
                                            let _e1766 = (bitcast<f32>((bitcast<u32>((_e696.member.member_1.y - _e696.member.member.y)) & 2139095040u)) * 0.0000009536743f);
                                            let _e1767 = (bitcast<f32>((bitcast<u32>((_e696.member.member_1.z - _e696.member.member.z)) & 2139095040u)) * 0.0000009536743f);
                                            let _e1769 = select(_e151, _e1765, (_e1765 > _e151));
                                            let _e1771 = select(_e151, _e1766, (_e1766 > _e151));
                                            let _e1773 = select(_e151, _e1767, (_e1767 > _e151));
                                            let _e1804 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1705 & 2097151u))) - 8388608f) * _e1769));
                                            let _e1809 = (bitcast<i32>((_e1705 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e1812 = bitcast<f32>((_e1804 & bitcast<u32>(_e1809)));
                                            let _e1813 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1720 & 2097151u))) - 8388608f) * _e1771));
                                            let _e1818 = (bitcast<i32>((_e1720 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e1821 = bitcast<f32>((_e1813 & bitcast<u32>(_e1818)));
                                            let _e1822 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1735 & 2097151u))) - 8388608f) * _e1773));
                                            let _e1827 = (bitcast<i32>((_e1735 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e1830 = bitcast<f32>((_e1822 & bitcast<u32>(_e1827)));
                                            let _e1834 = bitcast<f32>((_e1804 & bitcast<u32>(~(_e1809))));
                                            let _e1838 = bitcast<f32>((_e1813 & bitcast<u32>(~(_e1818))));
                                            let _e1842 = bitcast<f32>((_e1822 & bitcast<u32>(~(_e1827))));
                                            let _e1843 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1712 & 2097151u))) - 8388608f) * _e1769));
                                            let _e1848 = (bitcast<i32>((_e1712 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e1851 = bitcast<f32>((_e1843 & bitcast<u32>(_e1848)));
                                            let _e1852 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1727 & 2097151u))) - 8388608f) * _e1771));
                                            let _e1857 = (bitcast<i32>((_e1727 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e1860 = bitcast<f32>((_e1852 & bitcast<u32>(_e1857)));
                                            let _e1861 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1742 & 2097151u))) - 8388608f) * _e1773));
                                            let _e1866 = (bitcast<i32>((_e1742 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e1869 = bitcast<f32>((_e1861 & bitcast<u32>(_e1866)));
                                            let _e1873 = bitcast<f32>((_e1843 & bitcast<u32>(~(_e1848))));
                                            let _e1877 = bitcast<f32>((_e1852 & bitcast<u32>(~(_e1857))));
                                            let _e1881 = bitcast<f32>((_e1861 & bitcast<u32>(~(_e1866))));
                                            let _e1882 = (_e696.member.member.x + _e1812);
                                            let _e1883 = (_e696.member.member.y + _e1821);
                                            let _e1884 = (_e696.member.member.z + _e1830);
                                            let _e1887 = (_e696.member.member_1.x - _e1851);
                                            let _e1888 = (_e696.member.member_1.y - _e1860);
                                            let _e1889 = (_e696.member.member_1.z - _e1869);
                                            let _e1908 = (_e1887 - _e1882);
                                            let _e1909 = (_e1888 - _e1883);
                                            let _e1910 = (_e1889 - _e1884);
                                            let _e1912 = select(_e1909, _e1908, (_e1908 > _e1909));
                                            let _e1914 = select(_e1910, _e1912, (_e1912 > _e1910));
                                            if (_e1914 < (1024f * _e151)) {
                                                phi_3545_ = 0u;
                                            } else {
                                                phi_3545_ = select(2u, 1u, (_e1914 < (2097152f * _e151)));
                                            }
                                            let _e1921 = phi_3545_;
                                            switch bitcast<i32>(_e1921) {
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
                                            let _e1924 = phi_3551_;
                                            let _e1930 = global_4.member[_e696.member_1][0u];
                                            let _e1934 = global_4.member[_e696.member_1][2u];
                                            let _e1938 = global_4.member[_e696.member_1][4u];
                                            let _e1942 = global_4.member[_e696.member_1][6u];
                                            let _e1954 = (((_e1934 >> bitcast<u32>(22i)) | ((_e1938 >> bitcast<u32>(22i)) << bitcast<u32>(10i))) | ((_e1942 >> bitcast<u32>(22i)) << bitcast<u32>(20i)));
                                            let _e1955 = (_e1930 & 268435455u);
                                            let _e1956 = (_e1954 & 268435455u);
                                            let _e1959 = ((_e1930 >> bitcast<u32>(28u)) & 7u);
                                            let _e1967 = ((_e1930 >> bitcast<u32>(31i)) | (((_e1954 >> bitcast<u32>(28u)) & 3u) << bitcast<u32>(1i)));
                                            let _e1968 = (_e1959 != 0u);
                                            if (_e1959 == 0u) {
                                                phi_3806_ = _e1955;
                                            } else {
                                                if (_e1959 == 7u) {
                                                    phi_3805_ = 2147483648u;
                                                } else {
                                                    phi_3805_ = ((2147483648u | (_e1959 << bitcast<u32>(28u))) | (_e1956 & 268435455u));
                                                }
                                                let _e1977 = phi_3805_;
                                                phi_3806_ = _e1977;
                                            }
                                            let _e1979 = phi_3806_;
                                            if _e1968 {
                                                let _e1980 = (_e1959 != 7u);
                                                if _e1980 {
                                                    phi_3816_ = (_e1956 + (_e1959 * ((3u * _e1924) + 1u)));
                                                } else {
                                                    phi_3816_ = u32();
                                                }
                                                let _e1984 = phi_3816_;
                                                phi_3818_ = _e1984;
                                                phi_3819_ = select(true, false, _e1980);
                                            } else {
                                                phi_3818_ = u32();
                                                phi_3819_ = true;
                                            }
                                            let _e1987 = phi_3818_;
                                            let _e1989 = phi_3819_;
                                            if (_e1967 == 0u) {
                                                phi_3840_ = (_e1955 + select(0u, 1u, !(_e1968)));
                                            } else {
                                                if (_e1967 == 7u) {
                                                    phi_3839_ = 2147483648u;
                                                } else {
                                                    phi_3839_ = ((2147483648u | (_e1967 << bitcast<u32>(28u))) | (select(_e1987, _e1956, _e1989) & 268435455u));
                                                }
                                                let _e2002 = phi_3839_;
                                                phi_3840_ = _e2002;
                                            }
                                            let _e2004 = phi_3840_;
                                            phi_3844_ = type_53(array<vec4<f32>, 3>(vec4<f32>(_e1882, (_e696.member.member.x + _e1834), _e1887, (_e696.member.member_1.x - _e1873)), vec4<f32>(_e1883, (_e696.member.member.y + _e1838), _e1888, (_e696.member.member_1.y - _e1877)), vec4<f32>(_e1884, (_e696.member.member.z + _e1842), _e1889, (_e696.member.member_1.z - _e1881))), type_52(type_24((_e696.member.member + vec4<f32>(_e1812, _e1821, _e1830, 0f)), (_e696.member.member_1 - vec4<f32>(_e1851, _e1860, _e1869, 0f))), _e1979), type_52(type_24((_e696.member.member + vec4<f32>(_e1834, _e1838, _e1842, 0f)), (_e696.member.member_1 - vec4<f32>(_e1873, _e1877, _e1881, 0f))), _e2004));
                                        }
                                        let _e2009 = phi_3844_;
                                        let _e2020 = ((_e2009.member[0].x - _e373) * _e376);
                                        let _e2021 = ((_e2009.member[0].y - _e373) * _e376);
                                        let _e2022 = ((_e2009.member[0].z - _e374) * _e376);
                                        let _e2023 = ((_e2009.member[0].w - _e374) * _e376);
                                        let _e2033 = ((_e2009.member[1].x - _e439) * _e442);
                                        let _e2034 = ((_e2009.member[1].y - _e439) * _e442);
                                        let _e2035 = ((_e2009.member[1].z - _e440) * _e442);
                                        let _e2036 = ((_e2009.member[1].w - _e440) * _e442);
                                        let _e2046 = ((_e2009.member[2].x - _e505) * _e508);
                                        let _e2047 = ((_e2009.member[2].y - _e505) * _e508);
                                        let _e2048 = ((_e2009.member[2].z - _e506) * _e508);
                                        let _e2049 = ((_e2009.member[2].w - _e506) * _e508);
                                        let _e2051 = select(_e2048, _e2046, (_e2046 < _e2048));
                                        let _e2053 = select(_e2049, _e2047, (_e2047 < _e2049));
                                        let _e2055 = select(_e2048, _e2046, (_e2046 > _e2048));
                                        let _e2057 = select(_e2049, _e2047, (_e2047 > _e2049));
                                        let _e2059 = select(_e2022, _e2020, (_e2020 < _e2022));
                                        let _e2061 = select(_e2023, _e2021, (_e2021 < _e2023));
                                        let _e2063 = select(_e2035, _e2033, (_e2033 < _e2035));
                                        let _e2065 = select(_e2036, _e2034, (_e2034 < _e2036));
                                        let _e2067 = select(_e2063, _e2059, (_e2059 > _e2063));
                                        let _e2069 = select(_e2065, _e2061, (_e2061 > _e2065));
                                        let _e2071 = select(_e2051, _e2067, (_e2067 > _e2051));
                                        let _e2073 = select(_e2053, _e2069, (_e2069 > _e2053));
                                        let _e2075 = select(_e2022, _e2020, (_e2020 > _e2022));
                                        let _e2077 = select(_e2023, _e2021, (_e2021 > _e2023));
                                        let _e2079 = select(_e2035, _e2033, (_e2033 > _e2035));
                                        let _e2081 = select(_e2036, _e2034, (_e2034 > _e2036));
                                        let _e2083 = select(_e2079, _e2075, (_e2075 < _e2079));
                                        let _e2085 = select(_e2081, _e2077, (_e2077 < _e2081));
                                        let _e2090 = -(_e2051);
                                        let _e2091 = -(_e2053);
                                        let _e2098 = (select(_e2055, _e2083, (_e2083 < _e2055)) + (select(_e2090, _e2055, (_e2055 > _e2090)) * 0.0000019073523f));
                                        let _e2099 = (select(_e2057, _e2085, (_e2085 < _e2057)) + (select(_e2091, _e2057, (_e2057 > _e2091)) * 0.0000019073523f));
                                        let _e2101 = select(_e611, _e2071, (_e2071 > _e611));
                                        let _e2103 = select(_e611, _e2073, (_e2073 > _e611));
                                        let _e2108 = (_e2101 <= select(_e1695, _e2098, (_e2098 < _e1695)));
                                        let _e2109 = (_e2103 <= select(_e1695, _e2099, (_e2099 < _e1695)));
                                        let _e2110 = (_e2101 <= _e2103);
                                        if _e2108 {
                                            if _e2109 {
                                                if _e2110 {
                                                    phi_4207_ = _e2009.member_2;
                                                } else {
                                                    phi_4207_ = _e2009.member_1;
                                                }
                                                let _e2114 = phi_4207_;
                                                let _e2135 = (_e694 % 128u);
                                                let _e2136 = (_e2135 < 128u);
                                                if _e2136 {
                                                } else {
                                                    phi_5415_ = true;
                                                    break;
                                                }
                                                local_8[_e2135] = _e2114.member_1;
                                                if _e2136 {
                                                } else {
                                                    phi_5415_ = true;
                                                    break;
                                                }
                                                local_7[_e2135] = _e2114.member.member.x;
                                                if _e2136 {
                                                } else {
                                                    phi_5415_ = true;
                                                    break;
                                                }
                                                local_6[_e2135] = _e2114.member.member.y;
                                                if _e2136 {
                                                } else {
                                                    phi_5415_ = true;
                                                    break;
                                                }
                                                local_5[_e2135] = _e2114.member.member.z;
                                                if _e2136 {
                                                } else {
                                                    phi_5415_ = true;
                                                    break;
                                                }
                                                local_4[_e2135] = _e2114.member.member_1.x;
                                                if _e2136 {
                                                } else {
                                                    phi_5415_ = true;
                                                    break;
                                                }
                                                local_3[_e2135] = _e2114.member.member_1.y;
                                                if _e2136 {
                                                } else {
                                                    phi_5415_ = true;
                                                    break;
                                                }
                                                local_2[_e2135] = _e2114.member.member_1.z;
                                                if _e2136 {
                                                } else {
                                                    phi_5415_ = true;
                                                    break;
                                                }
                                                local_10[_e2135] = select(_e2101, _e2103, _e2110);
                                                if _e2110 {
                                                    phi_4283_ = _e2009.member_1;
                                                } else {
                                                    phi_4283_ = _e2009.member_2;
                                                }
                                                let _e2149 = phi_4283_;
                                                phi_4284_ = (_e694 + 1u);
                                                phi_4285_ = _e2149;
                                            } else {
                                                phi_4284_ = u32();
                                                phi_4285_ = type_52();
                                            }
                                            let _e2151 = phi_4284_;
                                            let _e2153 = phi_4285_;
                                            phi_4287_ = _e2151;
                                            phi_4288_ = _e2153;
                                            phi_4289_ = select(true, false, _e2109);
                                        } else {
                                            phi_4287_ = u32();
                                            phi_4288_ = type_52();
                                            phi_4289_ = true;
                                        }
                                        let _e2156 = phi_4287_;
                                        let _e2158 = phi_4288_;
                                        let _e2160 = phi_4289_;
                                        if _e2160 {
                                            if _e2108 {
                                                phi_4298_ = _e2009.member_1;
                                            } else {
                                                phi_4298_ = _e2009.member_2;
                                            }
                                            let _e2164 = phi_4298_;
                                            phi_4303_ = select(_e2109, true, _e2108);
                                            phi_4305_ = _e2164;
                                        } else {
                                            phi_4303_ = _e692;
                                            phi_4305_ = _e2158;
                                        }
                                        let _e2167 = phi_4303_;
                                        let _e2169 = phi_4305_;
                                        phi_4309_ = _e2167;
                                        phi_4310_ = select(_e2156, _e694, _e2160);
                                        phi_4311_ = _e2169;
                                    }
                                    let _e2172 = phi_4309_;
                                    let _e2174 = phi_4310_;
                                    let _e2176 = phi_4311_;
                                    if _e700 {
                                        phi_4321_ = _e696;
                                    } else {
                                        phi_4321_ = _e2176;
                                    }
                                    let _e2178 = phi_4321_;
                                    phi_5534_ = _e1695;
                                    phi_5418_ = _e1693;
                                    phi_4322_ = (_e656 - 1u);
                                    phi_4323_ = select(_e2172, false, _e700);
                                    phi_4324_ = select(_e2174, _e694, _e700);
                                    phi_4325_ = _e2178;
                                } else {
                                    phi_5534_ = _e654;
                                    phi_5418_ = _e652;
                                    phi_4322_ = _e656;
                                    phi_4323_ = _e692;
                                    phi_4324_ = _e694;
                                    phi_4325_ = _e696;
                                }
                                let _e2182 = phi_5534_;
                                let _e2184 = phi_5418_;
                                let _e2186 = phi_4322_;
                                let _e2188 = phi_4323_;
                                let _e2190 = phi_4324_;
                                let _e2192 = phi_4325_;
                                phi_5533_ = _e2182;
                                phi_5417_ = _e2184;
                                phi_4326_ = _e2186;
                                phi_4327_ = _e2188;
                                phi_4328_ = _e2190;
                                phi_4329_ = _e2192;
                            } else {
                                phi_5533_ = _e654;
                                phi_5417_ = _e652;
                                phi_4326_ = u32();
                                phi_4327_ = bool();
                                phi_4328_ = u32();
                                phi_4329_ = type_52();
                            }
                            let _e2194 = phi_5533_;
                            let _e2196 = phi_5417_;
                            let _e2198 = phi_4326_;
                            let _e2200 = phi_4327_;
                            let _e2202 = phi_4328_;
                            let _e2204 = phi_4329_;
                            phi_5532_ = _e2194;
                            phi_5416_ = _e2196;
                            phi_1256_ = _e2198;
                            phi_1259_ = _e2200;
                            phi_1261_ = _e2202;
                            phi_1263_ = _e2204;
                            phi_4330_ = _e666;
                        } else {
                            phi_5532_ = _e654;
                            phi_5416_ = _e652;
                            phi_1256_ = u32();
                            phi_1259_ = bool();
                            phi_1261_ = u32();
                            phi_1263_ = type_52();
                            phi_4330_ = false;
                        }
                        let _e2206 = phi_5532_;
                        let _e2208 = phi_5416_;
                        let _e2210 = phi_1256_;
                        let _e2212 = phi_1259_;
                        let _e2214 = phi_1261_;
                        let _e2216 = phi_1263_;
                        let _e2218 = phi_4330_;
                        continue;
                        continuing {
                            phi_5075_ = _e2208;
                            phi_4988_ = _e2206;
                            phi_1255_ = _e2210;
                            phi_1258_ = _e2212;
                            phi_1260_ = _e2214;
                            phi_1262_ = _e2216;
                            phi_5415_ = _e2208;
                            break if !(_e2218);
                        }
                    }
                    let _e2221 = phi_5415_;
                    if _e2221 {
                        break;
                    }
                    phi_4337_ = type_8(0u, 8u);
                    loop {
                        let _e2223 = phi_4337_;
                        if (_e2223.member < _e2223.member_1) {
                            phi_4338_ = type_8((_e2223.member + 1u), _e2223.member_1);
                            phi_4361_ = type_8(1u, _e2223.member);
                        } else {
                            phi_4338_ = _e2223;
                            phi_4361_ = type_8(0u, type_8().member_1);
                        }
                        let _e2236 = phi_4338_;
                        let _e2238 = phi_4361_;
                        let _e2242 = (bitcast<i32>(_e2238.member) != 0i);
                        if _e2242 {
                            let _e2243 = (_e2238.member_1 < 8u);
                            if _e2243 {
                            } else {
                                phi_5514_ = true;
                                break;
                            }
                            let _e2245 = local_9[_e2238.member_1];
                            if (_e2245.member_3 != 4294967295u) {
                                let _e2251 = -(_e513);
                                let _e2252 = bitcast<u32>(_e2245.member);
                                let _e2256 = (bitcast<i32>((_e2252 >> bitcast<u32>(23i))) & 255i);
                                let _e2257 = (_e2256 + _e2251);
                                if (_e2256 == 255i) {
                                    phi_4434_ = _e2245.member;
                                } else {
                                    if (_e2256 > 0i) {
                                        if (_e2257 > 0i) {
                                            let _e2261 = (_e2257 < 255i);
                                            if _e2261 {
                                                phi_4413_ = bitcast<f32>((_e2252 + bitcast<u32>((_e2251 << bitcast<u32>(23i)))));
                                            } else {
                                                phi_4413_ = f32();
                                            }
                                            let _e2268 = phi_4413_;
                                            phi_4415_ = _e2268;
                                            phi_4416_ = select(true, false, _e2261);
                                        } else {
                                            phi_4415_ = f32();
                                            phi_4416_ = true;
                                        }
                                        let _e2271 = phi_4415_;
                                        let _e2273 = phi_4416_;
                                        phi_4417_ = _e2271;
                                        phi_4418_ = _e2273;
                                    } else {
                                        phi_4417_ = f32();
                                        phi_4418_ = true;
                                    }
                                    let _e2275 = phi_4417_;
                                    let _e2277 = phi_4418_;
                                    if _e2277 {
                                        let _e2278 = (_e2252 & 2147483648u);
                                        let _e2285 = ((_e2252 & 8388607u) | (select(0u, 1u, ((_e2252 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                                        let _e2289 = (_e2285 == 0u);
                                        if _e2289 {
                                            phi_4935_ = bitcast<f32>(_e2278);
                                        } else {
                                            let _e2294 = (select((bitcast<u32>(31i) - firstLeadingBit(_e2285)), 32u, _e2289) - 8u);
                                            let _e2297 = (_e2285 << bitcast<u32>((_e2294 & 31u)));
                                            let _e2299 = ((_e2257 + select(0i, 1i, (_e2256 == 0i))) - bitcast<i32>(_e2294));
                                            if (_e2299 >= 255i) {
                                                phi_4925_ = bitcast<f32>((_e2278 | 2139095040u));
                                                phi_4926_ = f32();
                                                phi_4927_ = true;
                                            } else {
                                                let _e2301 = (_e2299 > 0i);
                                                if _e2301 {
                                                    phi_4919_ = bitcast<f32>(((_e2278 | (bitcast<u32>(_e2299) << bitcast<u32>(23i))) | (_e2297 & 8388607u)));
                                                    phi_4920_ = f32();
                                                } else {
                                                    if (_e2299 < -24i) {
                                                        phi_4885_ = 26u;
                                                    } else {
                                                        phi_4885_ = bitcast<u32>((1i - _e2299));
                                                    }
                                                    let _e2306 = phi_4885_;
                                                    let _e2307 = (_e2306 & 31u);
                                                    let _e2309 = (_e2297 >> bitcast<u32>(_e2307));
                                                    let _e2313 = (_e2297 & ((1u << bitcast<u32>(_e2307)) - 1u));
                                                    let _e2317 = (1u << bitcast<u32>(((_e2306 - 1u) & 31u)));
                                                    if (_e2313 > _e2317) {
                                                        phi_4906_ = true;
                                                    } else {
                                                        if (_e2313 == _e2317) {
                                                            phi_4903_ = ((_e2309 & 1u) == 1u);
                                                        } else {
                                                            phi_4903_ = false;
                                                        }
                                                        let _e2323 = phi_4903_;
                                                        phi_4906_ = _e2323;
                                                    }
                                                    let _e2325 = phi_4906_;
                                                    phi_4919_ = f32();
                                                    phi_4920_ = bitcast<f32>((_e2278 | (_e2309 + select(0u, 1u, _e2325))));
                                                }
                                                let _e2338 = phi_4919_;
                                                let _e2340 = phi_4920_;
                                                phi_4925_ = _e2338;
                                                phi_4926_ = _e2340;
                                                phi_4927_ = _e2301;
                                            }
                                            let _e2344 = phi_4925_;
                                            let _e2346 = phi_4926_;
                                            let _e2348 = phi_4927_;
                                            phi_4935_ = select(_e2346, _e2344, _e2348);
                                        }
                                        let _e2352 = phi_4935_;
                                        phi_4433_ = _e2352;
                                    } else {
                                        phi_4433_ = _e2275;
                                    }
                                    let _e2354 = phi_4433_;
                                    phi_4434_ = _e2354;
                                }
                                let _e2356 = phi_4434_;
                                let _e2357 = bitcast<u32>(_e2356);
                                if ((_e2357 & 2147483647u) >= 2139095040u) {
                                    phi_4446_ = bitcast<f32>(((_e2357 & 2147483648u) | 2139095039u));
                                } else {
                                    phi_4446_ = _e2356;
                                }
                                let _e2364 = phi_4446_;
                                phi_4451_ = type_20(_e2364, _e2245.member_1, _e2245.member_2, _e2245.member_3);
                            } else {
                                phi_4451_ = type_20(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                            }
                            let _e2367 = phi_4451_;
                            if _e2243 {
                            } else {
                                phi_5514_ = true;
                                break;
                            }
                            local_9[_e2238.member_1] = type_20(_e2367.member, _e2367.member_1, _e2367.member_2, _e2367.member_3);
                        }
                        continue;
                        continuing {
                            phi_4337_ = _e2236;
                            phi_5514_ = _e2221;
                            break if !(_e2242);
                        }
                    }
                    let _e2375 = phi_5514_;
                    if _e2375 {
                        break;
                    }
                    let _e2376 = local_9;
                    if _e159 {
                    } else {
                        break;
                    }
                    global_6.member[_e157] = array<type_20, 8>(type_20(_e2376[0].member, _e2376[0].member_1, _e2376[0].member_2, _e2376[0].member_3), type_20(_e2376[1].member, _e2376[1].member_1, _e2376[1].member_2, _e2376[1].member_3), type_20(_e2376[2].member, _e2376[2].member_1, _e2376[2].member_2, _e2376[2].member_3), type_20(_e2376[3].member, _e2376[3].member_1, _e2376[3].member_2, _e2376[3].member_3), type_20(_e2376[4].member, _e2376[4].member_1, _e2376[4].member_2, _e2376[4].member_3), type_20(_e2376[5].member, _e2376[5].member_1, _e2376[5].member_2, _e2376[5].member_3), type_20(_e2376[6].member, _e2376[6].member_1, _e2376[6].member_2, _e2376[6].member_3), type_20(_e2376[7].member, _e2376[7].member_1, _e2376[7].member_2, _e2376[7].member_3));
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn trace_nearest_q21_lattice(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
