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
    var phi_2899_: type_31;
    var phi_2900_: type_31;
    var phi_2903_: type_31;
    var phi_2904_: type_31;
    var phi_2905_: bool;
    var phi_2909_: type_31;
    var phi_2918_: type_20;
    var phi_2930_: type_8;
    var phi_2933_: type_20;
    var phi_2931_: type_8;
    var phi_2956_: type_8;
    var phi_2988_: bool;
    var phi_2989_: bool;
    var phi_3010_: type_20;
    var phi_2934_: type_20;
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
    var phi_4417_: type_20;
    var phi_5418_: bool;

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
                            phi_520_ = (bitcast<i32>((_e236 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_520_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e236)), 32u, (_e236 == 0u))));
                        }
                        let _e250 = phi_520_;
                        phi_521_ = _e250;
                    } else {
                        phi_521_ = 0i;
                    }
                    let _e252 = phi_521_;
                    let _e253 = (_e169 == _e208);
                    if _e253 {
                        phi_531_ = true;
                    } else {
                        phi_531_ = (_e176 == _e208);
                    }
                    let _e256 = phi_531_;
                    let _e257 = select(1u, 0u, _e253);
                    if _e256 {
                        let _e258 = (_e257 + 1u);
                        phi_541_ = _e258;
                        phi_542_ = _e258;
                        phi_544_ = select(true, false, (_e258 == 2u));
                    } else {
                        phi_541_ = u32();
                        phi_542_ = 0u;
                        phi_544_ = true;
                    }
                    let _e262 = phi_541_;
                    let _e264 = phi_542_;
                    let _e266 = phi_544_;
                    if _e266 {
                        phi_549_ = (_e264 + 1u);
                    } else {
                        phi_549_ = 0u;
                    }
                    let _e270 = phi_549_;
                    let _e271 = select(_e262, _e264, _e266);
                    let _e272 = select(_e257, select(2u, _e257, _e256), _e266);
                    if (_e139 < -126i) {
                        phi_562_ = -126i;
                    } else {
                        phi_562_ = select(_e139, 127i, (_e139 > 127i));
                    }
                    let _e277 = phi_562_;
                    let _e282 = bitcast<f32>((bitcast<u32>((_e277 + 127i)) << bitcast<u32>(23i)));
                    let _e288 = bitcast<f32>((bitcast<u32>(((_e139 - _e277) + 127i)) << bitcast<u32>(23i)));
                    let _e289 = -(_e252);
                    if (_e289 < -126i) {
                        phi_582_ = -126i;
                    } else {
                        phi_582_ = select(_e289, 127i, (_e289 > 127i));
                    }
                    let _e294 = phi_582_;
                    let _e299 = bitcast<f32>((bitcast<u32>((_e294 + 127i)) << bitcast<u32>(23i)));
                    let _e305 = bitcast<f32>((bitcast<u32>(((_e289 - _e294) + 127i)) << bitcast<u32>(23i)));
                    let _e309 = global_3.member[_e157].member;
                    let _e310 = (_e271 == 0u);
                    if _e310 {
                        phi_600_ = _e309[0];
                    } else {
                        phi_600_ = _e309[1];
                    }
                    let _e314 = phi_600_;
                    let _e315 = (_e271 == 2u);
                    if _e315 {
                        phi_606_ = _e309[2];
                    } else {
                        phi_606_ = _e314;
                    }
                    let _e318 = phi_606_;
                    let _e319 = bitcast<u32>(_e318);
                    let _e321 = ((_e319 & 2139095040u) != 0u);
                    let _e335 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e319 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e319 & 2147483648u))), _e318, _e321) * _e282) * select(0.00000011920929f, 1f, _e321)) * _e288);
                    let _e336 = global_3.member[_e157].member_2;
                    if _e310 {
                        phi_646_ = _e336[0];
                    } else {
                        phi_646_ = _e336[1];
                    }
                    let _e340 = phi_646_;
                    if _e315 {
                        phi_652_ = _e336[2];
                    } else {
                        phi_652_ = _e340;
                    }
                    let _e343 = phi_652_;
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
                        phi_725_ = _e309[0];
                    } else {
                        phi_725_ = _e309[1];
                    }
                    let _e381 = phi_725_;
                    let _e382 = (_e270 == 2u);
                    if _e382 {
                        phi_731_ = _e309[2];
                    } else {
                        phi_731_ = _e381;
                    }
                    let _e385 = phi_731_;
                    let _e386 = bitcast<u32>(_e385);
                    let _e388 = ((_e386 & 2139095040u) != 0u);
                    let _e402 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e386 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e386 & 2147483648u))), _e385, _e388) * _e282) * select(0.00000011920929f, 1f, _e388)) * _e288);
                    if _e377 {
                        phi_771_ = _e336[0];
                    } else {
                        phi_771_ = _e336[1];
                    }
                    let _e406 = phi_771_;
                    if _e382 {
                        phi_777_ = _e336[2];
                    } else {
                        phi_777_ = _e406;
                    }
                    let _e409 = phi_777_;
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
                        phi_850_ = _e309[0];
                    } else {
                        phi_850_ = _e309[1];
                    }
                    let _e447 = phi_850_;
                    let _e448 = (_e272 == 2u);
                    if _e448 {
                        phi_856_ = _e309[2];
                    } else {
                        phi_856_ = _e447;
                    }
                    let _e451 = phi_856_;
                    let _e452 = bitcast<u32>(_e451);
                    let _e454 = ((_e452 & 2139095040u) != 0u);
                    let _e468 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e452 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e452 & 2147483648u))), _e451, _e454) * _e282) * select(0.00000011920929f, 1f, _e454)) * _e288);
                    if _e443 {
                        phi_896_ = _e336[0];
                    } else {
                        phi_896_ = _e336[1];
                    }
                    let _e472 = phi_896_;
                    if _e448 {
                        phi_902_ = _e336[2];
                    } else {
                        phi_902_ = _e472;
                    }
                    let _e475 = phi_902_;
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
                            phi_1021_ = 255i;
                        } else {
                            phi_1021_ = (((_e526 + select(0i, 1i, (_e526 == 0i))) - _e533) + _e513);
                        }
                        let _e541 = phi_1021_;
                        let _e551 = (_e541 <= 0i);
                        if _e551 {
                            phi_1044_ = u32();
                        } else {
                            if _e530 {
                                phi_1043_ = u32();
                            } else {
                                phi_1043_ = select(((bitcast<u32>(_e541) << bitcast<u32>(23i)) | ((_e523 << bitcast<u32>(((_e533 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e541 >= 255i));
                            }
                            let _e555 = phi_1043_;
                            phi_1044_ = _e555;
                        }
                        let _e557 = phi_1044_;
                        let _e569 = ((_e229 & 8388607u) | (select(0u, 1u, ((_e229 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                        let _e572 = bitcast<i32>((_e229 >> bitcast<u32>(23i)));
                        let _e576 = (_e569 == 0u);
                        let _e579 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e569)), 32u, _e576)) - 8i);
                        if (_e572 == 255i) {
                            phi_1081_ = 255i;
                        } else {
                            phi_1081_ = (((_e572 + select(0i, 1i, (_e572 == 0i))) - _e579) + _e513);
                        }
                        let _e587 = phi_1081_;
                        let _e597 = (_e587 <= 0i);
                        if _e597 {
                            phi_1104_ = u32();
                        } else {
                            if _e576 {
                                phi_1103_ = u32();
                            } else {
                                phi_1103_ = select(((bitcast<u32>(_e587) << bitcast<u32>(23i)) | ((_e569 << bitcast<u32>(((_e579 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e587 >= 255i));
                            }
                            let _e601 = phi_1103_;
                            phi_1104_ = _e601;
                        }
                        let _e603 = phi_1104_;
                        phi_1112_ = bitcast<f32>(((_e228 & 2147483648u) | select(_e603, 0u, select(_e576, true, _e597))));
                        phi_1113_ = bitcast<f32>(((_e219 & 2147483648u) | select(_e557, 0u, select(_e530, true, _e551))));
                    } else {
                        phi_1112_ = 0f;
                        phi_1113_ = 1f;
                    }
                    let _e609 = phi_1112_;
                    let _e611 = phi_1113_;
                    local_9 = array<type_20, 8>(type_20(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_20(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_20(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_20(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_20(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_20(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_20(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_20(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u));
                    local_8 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                    local_7 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_6 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_5 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_4 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_3 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_10 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    let _e616 = (_e271 % 3u);
                    let _e617 = (_e616 < 3u);
                    if _e617 {
                    } else {
                        break;
                    }
                    let _e619 = local_1[_e616];
                    let _e622 = (_e270 % 3u);
                    let _e623 = (_e622 < 3u);
                    if _e623 {
                    } else {
                        break;
                    }
                    let _e625 = local_1[_e622];
                    let _e628 = (_e272 % 3u);
                    let _e629 = (_e628 < 3u);
                    if _e629 {
                    } else {
                        break;
                    }
                    let _e631 = local_1[_e628];
                    if _e617 {
                    } else {
                        break;
                    }
                    let _e636 = local[_e616];
                    if _e623 {
                    } else {
                        break;
                    }
                    let _e640 = local[_e622];
                    if _e629 {
                    } else {
                        break;
                    }
                    let _e644 = local[_e628];
                    phi_5063_ = false;
                    phi_4918_ = _e609;
                    phi_1262_ = (_e611 <= _e609);
                    phi_1265_ = type_52(type_24(vec4<f32>((f32(_e619) * _e151), (f32(_e625) * _e151), (f32(_e631) * _e151), 0f), vec4<f32>((f32(_e636) * _e151), (f32(_e640) * _e151), (f32(_e644) * _e151), 0f)), select(0u, 2147483648u, (_e100 == 0u)));
                    phi_1267_ = 0u;
                    phi_1269_ = ((3u * _e100) + 1u);
                    loop {
                        let _e652 = phi_5063_;
                        let _e654 = phi_4918_;
                        let _e656 = phi_1262_;
                        let _e658 = phi_1265_;
                        let _e660 = phi_1267_;
                        let _e662 = phi_1269_;
                        if _e656 {
                            phi_1280_ = true;
                        } else {
                            phi_1280_ = (_e660 > 0u);
                        }
                        let _e665 = phi_1280_;
                        if _e665 {
                            let _e666 = (_e662 > 0u);
                            if _e666 {
                                if _e656 {
                                    phi_1367_ = _e656;
                                    phi_1368_ = _e658;
                                    phi_1369_ = _e660;
                                } else {
                                    let _e667 = (_e660 - 1u);
                                    let _e668 = (_e667 % 128u);
                                    let _e669 = (_e668 < 128u);
                                    if _e669 {
                                    } else {
                                        phi_5320_ = true;
                                        break;
                                    }
                                    let _e671 = local_7[_e668];
                                    if _e669 {
                                    } else {
                                        phi_5320_ = true;
                                        break;
                                    }
                                    let _e673 = local_6[_e668];
                                    if _e669 {
                                    } else {
                                        phi_5320_ = true;
                                        break;
                                    }
                                    let _e675 = local_5[_e668];
                                    if _e669 {
                                    } else {
                                        phi_5320_ = true;
                                        break;
                                    }
                                    let _e677 = local_4[_e668];
                                    if _e669 {
                                    } else {
                                        phi_5320_ = true;
                                        break;
                                    }
                                    let _e679 = local_3[_e668];
                                    if _e669 {
                                    } else {
                                        phi_5320_ = true;
                                        break;
                                    }
                                    let _e681 = local_2[_e668];
                                    if _e669 {
                                    } else {
                                        phi_5320_ = true;
                                        break;
                                    }
                                    let _e686 = local_8[_e668];
                                    if _e669 {
                                    } else {
                                        phi_5320_ = true;
                                        break;
                                    }
                                    let _e689 = local_10[_e668];
                                    phi_1367_ = (_e689 <= _e654);
                                    phi_1368_ = type_52(type_24(vec4<f32>(_e671, _e673, _e675, 0f), vec4<f32>(_e677, _e679, _e681, 0f)), _e686);
                                    phi_1369_ = _e667;
                                }
                                let _e692 = phi_1367_;
                                let _e694 = phi_1368_;
                                let _e696 = phi_1369_;
                                if _e692 {
                                    let _e701 = (_e694.member_1 & 268435455u);
                                    if ((_e694.member_1 & 2147483648u) != 0u) {
                                        phi_5060_ = _e652;
                                        phi_5002_ = _e654;
                                        phi_1388_ = type_8(0u, ((_e694.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e1183 = phi_5060_;
                                            let _e1185 = phi_5002_;
                                            let _e1187 = phi_1388_;
                                            if (_e1187.member < _e1187.member_1) {
                                                phi_1389_ = type_8((_e1187.member + 1u), _e1187.member_1);
                                                phi_1412_ = type_8(1u, _e1187.member);
                                            } else {
                                                phi_1389_ = _e1187;
                                                phi_1412_ = type_8(0u, type_8().member_1);
                                            }
                                            let _e1200 = phi_1389_;
                                            let _e1202 = phi_1412_;
                                            let _e1206 = (bitcast<i32>(_e1202.member) != 0i);
                                            if _e1206 {
                                                let _e1211 = (_e694.member.member_1.x - _e694.member.member.x);
                                                let _e1214 = (_e694.member.member_1.y - _e694.member.member.y);
                                                let _e1217 = (_e694.member.member_1.z - _e694.member.member.z);
                                                let _e1219 = select(_e1214, _e1211, (_e1211 > _e1214));
                                                let _e1221 = select(_e1217, _e1219, (_e1219 > _e1217));
                                                let _e1223 = (_e1221 < (1024f * _e151));
                                                if _e1223 {
                                                    phi_1453_ = 0u;
                                                } else {
                                                    phi_1453_ = select(2u, 1u, (_e1221 < (2097152f * _e151)));
                                                }
                                                let _e1228 = phi_1453_;
                                                switch bitcast<i32>(_e1228) {
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
                                                let _e1231 = phi_1459_;
                                                switch bitcast<i32>(_e1228) {
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
                                                let _e1238 = phi_1469_;
                                                let _e1240 = ((_e701 + (_e1202.member_1 * ((3u * _e1231) + 1u))) + (3u * _e1238));
                                                let _e1241 = (_e1240 < _e103);
                                                if _e1241 {
                                                    if _e1241 {
                                                    } else {
                                                        phi_5235_ = _e1185;
                                                        phi_5230_ = true;
                                                        break;
                                                    }
                                                    let _e1243 = global_5.member[_e1240];
                                                    phi_1485_ = _e1243;
                                                } else {
                                                    phi_1485_ = 4294967295u;
                                                }
                                                let _e1245 = phi_1485_;
                                                if _e1223 {
                                                    phi_1518_ = 0u;
                                                } else {
                                                    phi_1518_ = select(2u, 1u, (_e1221 < (2097152f * _e151)));
                                                }
                                                let _e1250 = phi_1518_;
                                                switch bitcast<i32>(_e1250) {
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
                                                let _e1253 = phi_1524_;
                                                let _e1257 = (_e701 + (_e1202.member_1 * ((3u * _e1253) + 1u)));
                                                switch bitcast<i32>(_e1250) {
                                                    case 0: {
                                                        let _e1532 = (_e1257 < _e103);
                                                        if _e1532 {
                                                            if _e1532 {
                                                            } else {
                                                                phi_5235_ = _e1185;
                                                                phi_5230_ = true;
                                                                break;
                                                            }
                                                            let _e1534 = global_5.member[_e1257];
                                                            phi_1551_ = _e1534;
                                                        } else {
                                                            phi_1551_ = 0u;
                                                        }
                                                        let _e1536 = phi_1551_;
                                                        let _e1538 = ((10u * _e271) & 31u);
                                                        let _e1548 = ((10u * _e270) & 31u);
                                                        let _e1558 = ((10u * _e272) & 31u);
                                                        let _e1568 = (_e1257 + 1u);
                                                        let _e1569 = (_e1568 < _e103);
                                                        if _e1569 {
                                                            if _e1569 {
                                                            } else {
                                                                phi_5235_ = _e1185;
                                                                phi_5230_ = true;
                                                                break;
                                                            }
                                                            let _e1571 = global_5.member[_e1568];
                                                            phi_1600_ = _e1571;
                                                        } else {
                                                            phi_1600_ = 0u;
                                                        }
                                                        let _e1573 = phi_1600_;
                                                        let _e1599 = (_e1257 + 2u);
                                                        let _e1600 = (_e1599 < _e103);
                                                        if _e1600 {
                                                            if _e1600 {
                                                            } else {
                                                                phi_5235_ = _e1185;
                                                                phi_5230_ = true;
                                                                break;
                                                            }
                                                            let _e1602 = global_5.member[_e1599];
                                                            phi_1649_ = _e1602;
                                                        } else {
                                                            phi_1649_ = 0u;
                                                        }
                                                        let _e1604 = phi_1649_;
                                                        phi_2150_ = array<array<f32, 3>, 3>(array<f32, 3>((_e694.member.member.x + ((bitcast<f32>((1258291200u | ((_e1536 >> bitcast<u32>(_e1538)) & 1023u))) - 8388608f) * _e151)), (_e694.member.member.y + ((bitcast<f32>((1258291200u | ((_e1536 >> bitcast<u32>(_e1548)) & 1023u))) - 8388608f) * _e151)), (_e694.member.member.z + ((bitcast<f32>((1258291200u | ((_e1536 >> bitcast<u32>(_e1558)) & 1023u))) - 8388608f) * _e151))), array<f32, 3>((_e694.member.member.x + ((bitcast<f32>((1258291200u | ((_e1573 >> bitcast<u32>(_e1538)) & 1023u))) - 8388608f) * _e151)), (_e694.member.member.y + ((bitcast<f32>((1258291200u | ((_e1573 >> bitcast<u32>(_e1548)) & 1023u))) - 8388608f) * _e151)), (_e694.member.member.z + ((bitcast<f32>((1258291200u | ((_e1573 >> bitcast<u32>(_e1558)) & 1023u))) - 8388608f) * _e151))), array<f32, 3>((_e694.member.member.x + ((bitcast<f32>((1258291200u | ((_e1604 >> bitcast<u32>(_e1538)) & 1023u))) - 8388608f) * _e151)), (_e694.member.member.y + ((bitcast<f32>((1258291200u | ((_e1604 >> bitcast<u32>(_e1548)) & 1023u))) - 8388608f) * _e151)), (_e694.member.member.z + ((bitcast<f32>((1258291200u | ((_e1604 >> bitcast<u32>(_e1558)) & 1023u))) - 8388608f) * _e151))));
                                                        break;
                                                    }
                                                    case 1: {
                                                        let _e1346 = (_e1257 < _e103);
                                                        if _e1346 {
                                                            if _e1346 {
                                                            } else {
                                                                phi_5235_ = _e1185;
                                                                phi_5230_ = true;
                                                                break;
                                                            }
                                                            let _e1348 = global_5.member[_e1257];
                                                            phi_1698_ = _e1348;
                                                        } else {
                                                            phi_1698_ = 0u;
                                                        }
                                                        let _e1350 = phi_1698_;
                                                        let _e1351 = (_e1257 + 1u);
                                                        let _e1352 = (_e1351 < _e103);
                                                        if _e1352 {
                                                            if _e1352 {
                                                            } else {
                                                                phi_5235_ = _e1185;
                                                                phi_5230_ = true;
                                                                break;
                                                            }
                                                            let _e1354 = global_5.member[_e1351];
                                                            phi_1713_ = _e1354;
                                                        } else {
                                                            phi_1713_ = 0u;
                                                        }
                                                        let _e1356 = phi_1713_;
                                                        let _e1357 = (_e271 == 1u);
                                                        if _e1357 {
                                                            phi_1723_ = ((_e1350 >> bitcast<u32>(21i)) | (_e1356 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1723_ = (_e1356 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1366 = phi_1723_;
                                                        let _e1374 = (_e270 == 1u);
                                                        if _e1374 {
                                                            phi_1744_ = ((_e1350 >> bitcast<u32>(21i)) | (_e1356 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1744_ = (_e1356 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1383 = phi_1744_;
                                                        let _e1391 = (_e272 == 1u);
                                                        if _e1391 {
                                                            phi_1765_ = ((_e1350 >> bitcast<u32>(21i)) | (_e1356 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1765_ = (_e1356 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1400 = phi_1765_;
                                                        let _e1409 = (_e1257 + 2u);
                                                        let _e1410 = (_e1409 < _e103);
                                                        if _e1410 {
                                                            if _e1410 {
                                                            } else {
                                                                phi_5235_ = _e1185;
                                                                phi_5230_ = true;
                                                                break;
                                                            }
                                                            let _e1412 = global_5.member[_e1409];
                                                            phi_1795_ = _e1412;
                                                        } else {
                                                            phi_1795_ = 0u;
                                                        }
                                                        let _e1414 = phi_1795_;
                                                        let _e1415 = (_e1257 + 3u);
                                                        let _e1416 = (_e1415 < _e103);
                                                        if _e1416 {
                                                            if _e1416 {
                                                            } else {
                                                                phi_5235_ = _e1185;
                                                                phi_5230_ = true;
                                                                break;
                                                            }
                                                            let _e1418 = global_5.member[_e1415];
                                                            phi_1810_ = _e1418;
                                                        } else {
                                                            phi_1810_ = 0u;
                                                        }
                                                        let _e1420 = phi_1810_;
                                                        if _e1357 {
                                                            phi_1820_ = ((_e1414 >> bitcast<u32>(21i)) | (_e1420 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1820_ = (_e1420 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1429 = phi_1820_;
                                                        if _e1374 {
                                                            phi_1841_ = ((_e1414 >> bitcast<u32>(21i)) | (_e1420 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1841_ = (_e1420 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1445 = phi_1841_;
                                                        if _e1391 {
                                                            phi_1862_ = ((_e1414 >> bitcast<u32>(21i)) | (_e1420 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1862_ = (_e1420 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1461 = phi_1862_;
                                                        let _e1470 = (_e1257 + 4u);
                                                        let _e1471 = (_e1470 < _e103);
                                                        if _e1471 {
                                                            if _e1471 {
                                                            } else {
                                                                phi_5235_ = _e1185;
                                                                phi_5230_ = true;
                                                                break;
                                                            }
                                                            let _e1473 = global_5.member[_e1470];
                                                            phi_1892_ = _e1473;
                                                        } else {
                                                            phi_1892_ = 0u;
                                                        }
                                                        let _e1475 = phi_1892_;
                                                        let _e1476 = (_e1257 + 5u);
                                                        let _e1477 = (_e1476 < _e103);
                                                        if _e1477 {
                                                            if _e1477 {
                                                            } else {
                                                                phi_5235_ = _e1185;
                                                                phi_5230_ = true;
                                                                break;
                                                            }
                                                            let _e1479 = global_5.member[_e1476];
                                                            phi_1907_ = _e1479;
                                                        } else {
                                                            phi_1907_ = 0u;
                                                        }
                                                        let _e1481 = phi_1907_;
                                                        if _e1357 {
                                                            phi_1917_ = ((_e1475 >> bitcast<u32>(21i)) | (_e1481 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1917_ = (_e1481 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1490 = phi_1917_;
                                                        if _e1374 {
                                                            phi_1938_ = ((_e1475 >> bitcast<u32>(21i)) | (_e1481 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1938_ = (_e1481 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1506 = phi_1938_;
                                                        if _e1391 {
                                                            phi_1959_ = ((_e1475 >> bitcast<u32>(21i)) | (_e1481 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1959_ = (_e1481 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1522 = phi_1959_;
                                                        phi_2150_ = array<array<f32, 3>, 3>(array<f32, 3>((_e694.member.member.x + ((bitcast<f32>((1258291200u | (select(_e1366, _e1350, _e310) & 2097151u))) - 8388608f) * _e151)), (_e694.member.member.y + ((bitcast<f32>((1258291200u | (select(_e1383, _e1350, _e377) & 2097151u))) - 8388608f) * _e151)), (_e694.member.member.z + ((bitcast<f32>((1258291200u | (select(_e1400, _e1350, _e443) & 2097151u))) - 8388608f) * _e151))), array<f32, 3>((_e694.member.member.x + ((bitcast<f32>((1258291200u | (select(_e1429, _e1414, _e310) & 2097151u))) - 8388608f) * _e151)), (_e694.member.member.y + ((bitcast<f32>((1258291200u | (select(_e1445, _e1414, _e377) & 2097151u))) - 8388608f) * _e151)), (_e694.member.member.z + ((bitcast<f32>((1258291200u | (select(_e1461, _e1414, _e443) & 2097151u))) - 8388608f) * _e151))), array<f32, 3>((_e694.member.member.x + ((bitcast<f32>((1258291200u | (select(_e1490, _e1475, _e310) & 2097151u))) - 8388608f) * _e151)), (_e694.member.member.y + ((bitcast<f32>((1258291200u | (select(_e1506, _e1475, _e377) & 2097151u))) - 8388608f) * _e151)), (_e694.member.member.z + ((bitcast<f32>((1258291200u | (select(_e1522, _e1475, _e443) & 2097151u))) - 8388608f) * _e151))));
                                                        break;
                                                    }
                                                    case 2: {
                                                        let _e1259 = (_e1257 + _e271);
                                                        let _e1260 = (_e1259 < _e103);
                                                        if _e1260 {
                                                            if _e1260 {
                                                            } else {
                                                                phi_5235_ = _e1185;
                                                                phi_5230_ = true;
                                                                break;
                                                            }
                                                            let _e1262 = global_5.member[_e1259];
                                                            phi_1990_ = _e1262;
                                                        } else {
                                                            phi_1990_ = 0u;
                                                        }
                                                        let _e1264 = phi_1990_;
                                                        let _e1268 = (_e1257 + _e270);
                                                        let _e1269 = (_e1268 < _e103);
                                                        if _e1269 {
                                                            if _e1269 {
                                                            } else {
                                                                phi_5235_ = _e1185;
                                                                phi_5230_ = true;
                                                                break;
                                                            }
                                                            let _e1271 = global_5.member[_e1268];
                                                            phi_2008_ = _e1271;
                                                        } else {
                                                            phi_2008_ = 0u;
                                                        }
                                                        let _e1273 = phi_2008_;
                                                        let _e1277 = (_e1257 + _e272);
                                                        let _e1278 = (_e1277 < _e103);
                                                        if _e1278 {
                                                            if _e1278 {
                                                            } else {
                                                                phi_5235_ = _e1185;
                                                                phi_5230_ = true;
                                                                break;
                                                            }
                                                            let _e1280 = global_5.member[_e1277];
                                                            phi_2026_ = _e1280;
                                                        } else {
                                                            phi_2026_ = 0u;
                                                        }
                                                        let _e1282 = phi_2026_;
                                                        let _e1287 = (_e1257 + 3u);
                                                        let _e1288 = (_e1287 + _e271);
                                                        let _e1289 = (_e1288 < _e103);
                                                        if _e1289 {
                                                            if _e1289 {
                                                            } else {
                                                                phi_5235_ = _e1185;
                                                                phi_5230_ = true;
                                                                break;
                                                            }
                                                            let _e1291 = global_5.member[_e1288];
                                                            phi_2049_ = _e1291;
                                                        } else {
                                                            phi_2049_ = 0u;
                                                        }
                                                        let _e1293 = phi_2049_;
                                                        let _e1297 = (_e1287 + _e270);
                                                        let _e1298 = (_e1297 < _e103);
                                                        if _e1298 {
                                                            if _e1298 {
                                                            } else {
                                                                phi_5235_ = _e1185;
                                                                phi_5230_ = true;
                                                                break;
                                                            }
                                                            let _e1300 = global_5.member[_e1297];
                                                            phi_2067_ = _e1300;
                                                        } else {
                                                            phi_2067_ = 0u;
                                                        }
                                                        let _e1302 = phi_2067_;
                                                        let _e1306 = (_e1287 + _e272);
                                                        let _e1307 = (_e1306 < _e103);
                                                        if _e1307 {
                                                            if _e1307 {
                                                            } else {
                                                                phi_5235_ = _e1185;
                                                                phi_5230_ = true;
                                                                break;
                                                            }
                                                            let _e1309 = global_5.member[_e1306];
                                                            phi_2085_ = _e1309;
                                                        } else {
                                                            phi_2085_ = 0u;
                                                        }
                                                        let _e1311 = phi_2085_;
                                                        let _e1316 = (_e1257 + 6u);
                                                        let _e1317 = (_e1316 + _e271);
                                                        let _e1318 = (_e1317 < _e103);
                                                        if _e1318 {
                                                            if _e1318 {
                                                            } else {
                                                                phi_5235_ = _e1185;
                                                                phi_5230_ = true;
                                                                break;
                                                            }
                                                            let _e1320 = global_5.member[_e1317];
                                                            phi_2108_ = _e1320;
                                                        } else {
                                                            phi_2108_ = 0u;
                                                        }
                                                        let _e1322 = phi_2108_;
                                                        let _e1326 = (_e1316 + _e270);
                                                        let _e1327 = (_e1326 < _e103);
                                                        if _e1327 {
                                                            if _e1327 {
                                                            } else {
                                                                phi_5235_ = _e1185;
                                                                phi_5230_ = true;
                                                                break;
                                                            }
                                                            let _e1329 = global_5.member[_e1326];
                                                            phi_2126_ = _e1329;
                                                        } else {
                                                            phi_2126_ = 0u;
                                                        }
                                                        let _e1331 = phi_2126_;
                                                        let _e1335 = (_e1316 + _e272);
                                                        let _e1336 = (_e1335 < _e103);
                                                        if _e1336 {
                                                            if _e1336 {
                                                            } else {
                                                                phi_5235_ = _e1185;
                                                                phi_5230_ = true;
                                                                break;
                                                            }
                                                            let _e1338 = global_5.member[_e1335];
                                                            phi_2144_ = _e1338;
                                                        } else {
                                                            phi_2144_ = 0u;
                                                        }
                                                        let _e1340 = phi_2144_;
                                                        phi_2150_ = array<array<f32, 3>, 3>(array<f32, 3>((f32(bitcast<i32>(_e1264)) * _e151), (f32(bitcast<i32>(_e1273)) * _e151), (f32(bitcast<i32>(_e1282)) * _e151)), array<f32, 3>((f32(bitcast<i32>(_e1293)) * _e151), (f32(bitcast<i32>(_e1302)) * _e151), (f32(bitcast<i32>(_e1311)) * _e151)), array<f32, 3>((f32(bitcast<i32>(_e1322)) * _e151), (f32(bitcast<i32>(_e1331)) * _e151), (f32(bitcast<i32>(_e1340)) * _e151)));
                                                        break;
                                                    }
                                                    default: {
                                                        phi_2150_ = array<array<f32, 3>, 3>();
                                                        break;
                                                    }
                                                }
                                                let _e1632 = phi_2150_;
                                                let _e1647 = (_e1632[0][2] - _e468);
                                                let _e1650 = (((_e1632[0][0] - _e335) * _e504) - (_e1647 * _e372));
                                                let _e1653 = (((_e1632[0][1] - _e402) * _e504) - (_e1647 * _e438));
                                                let _e1656 = (_e1632[1][2] - _e468);
                                                let _e1659 = (((_e1632[1][0] - _e335) * _e504) - (_e1656 * _e372));
                                                let _e1662 = (((_e1632[1][1] - _e402) * _e504) - (_e1656 * _e438));
                                                let _e1665 = (_e1632[2][2] - _e468);
                                                let _e1668 = (((_e1632[2][0] - _e335) * _e504) - (_e1665 * _e372));
                                                let _e1671 = (((_e1632[2][1] - _e402) * _e504) - (_e1665 * _e438));
                                                let _e1672 = (_e1668 * _e1662);
                                                let _e1673 = (_e1671 * _e1659);
                                                let _e1674 = (_e1650 * _e1671);
                                                let _e1675 = (_e1653 * _e1668);
                                                let _e1676 = (_e1659 * _e1653);
                                                let _e1677 = (_e1662 * _e1650);
                                                let _e1682 = (((_e1672 >= _e1673) && (_e1674 >= _e1675)) && (_e1676 >= _e1677));
                                                let _e1688 = (_e1682 || (((_e1672 <= _e1673) && (_e1674 <= _e1675)) && (_e1676 <= _e1677)));
                                                if _e1688 {
                                                    let _e1690 = select(-1f, 1f, _e1682);
                                                    let _e1692 = ((_e1672 - _e1673) * _e1690);
                                                    let _e1694 = select(0f, _e1692, (_e1692 > 0f));
                                                    let _e1696 = ((_e1674 - _e1675) * _e1690);
                                                    let _e1698 = select(0f, _e1696, (_e1696 > 0f));
                                                    let _e1700 = ((_e1676 - _e1677) * _e1690);
                                                    let _e1702 = select(0f, _e1700, (_e1700 > 0f));
                                                    let _e1704 = ((_e1694 + _e1698) + _e1702);
                                                    let _e1706 = select(_e1632[1][0], _e1632[0][0], (_e1632[0][0] < _e1632[1][0]));
                                                    let _e1710 = select(_e1632[1][0], _e1632[0][0], (_e1632[0][0] > _e1632[1][0]));
                                                    let _e1714 = select(_e1632[1][1], _e1632[0][1], (_e1632[0][1] < _e1632[1][1]));
                                                    let _e1718 = select(_e1632[1][1], _e1632[0][1], (_e1632[0][1] > _e1632[1][1]));
                                                    let _e1722 = select(_e1632[1][2], _e1632[0][2], (_e1632[0][2] < _e1632[1][2]));
                                                    let _e1726 = select(_e1632[1][2], _e1632[0][2], (_e1632[0][2] > _e1632[1][2]));
                                                    let _e1731 = ((select(_e1632[2][0], _e1706, (_e1706 < _e1632[2][0])) - _e373) * _e376);
                                                    let _e1732 = ((select(_e1632[2][0], _e1710, (_e1710 > _e1632[2][0])) - _e374) * _e376);
                                                    let _e1735 = ((select(_e1632[2][1], _e1714, (_e1714 < _e1632[2][1])) - _e439) * _e442);
                                                    let _e1736 = ((select(_e1632[2][1], _e1718, (_e1718 > _e1632[2][1])) - _e440) * _e442);
                                                    let _e1739 = ((select(_e1632[2][2], _e1722, (_e1722 < _e1632[2][2])) - _e505) * _e508);
                                                    let _e1740 = ((select(_e1632[2][2], _e1726, (_e1726 > _e1632[2][2])) - _e506) * _e508);
                                                    let _e1742 = select(_e1740, _e1739, (_e1739 < _e1740));
                                                    let _e1744 = select(_e1740, _e1739, (_e1739 > _e1740));
                                                    let _e1746 = select(_e1732, _e1731, (_e1731 < _e1732));
                                                    let _e1748 = select(_e1736, _e1735, (_e1735 < _e1736));
                                                    let _e1750 = select(_e1748, _e1746, (_e1746 > _e1748));
                                                    let _e1752 = select(_e1742, _e1750, (_e1750 > _e1742));
                                                    let _e1754 = select(_e1732, _e1731, (_e1731 > _e1732));
                                                    let _e1756 = select(_e1736, _e1735, (_e1735 > _e1736));
                                                    let _e1758 = select(_e1756, _e1754, (_e1754 < _e1756));
                                                    let _e1760 = select(_e1744, _e1758, (_e1758 < _e1744));
                                                    let _e1761 = -(_e1742);
                                                    let _e1767 = select(_e611, _e1752, (_e1752 > _e611));
                                                    let _e1771 = select(_e1659, _e1650, (_e1650 < _e1659));
                                                    let _e1776 = select(_e1659, _e1650, (_e1650 > _e1659));
                                                    let _e1783 = select(_e1662, _e1653, (_e1653 < _e1662));
                                                    let _e1788 = select(_e1662, _e1653, (_e1653 > _e1662));
                                                    let _e1797 = (((((_e1688 && (_e1704 >= 0.000000000000000000000000000000000000011754944f)) && ((select(_e1668, _e1771, (_e1771 < _e1668)) <= 0f) && (select(_e1668, _e1776, (_e1776 > _e1668)) >= 0f))) && ((select(_e1671, _e1783, (_e1783 < _e1671)) <= 0f) && (select(_e1671, _e1788, (_e1788 > _e1671)) >= 0f))) && (_e1767 <= (_e1760 + (select(_e1761, _e1744, (_e1744 > _e1761)) * 0.0000019073523f)))) && (_e1767 <= _e1185));
                                                    if _e1797 {
                                                        let _e1802 = (_e1632[1][0] - _e1632[0][0]);
                                                        let _e1803 = (_e1632[1][1] - _e1632[0][1]);
                                                        let _e1804 = (_e1632[1][2] - _e1632[0][2]);
                                                        let _e1805 = vec3<f32>(_e1802, _e1803, _e1804);
                                                        let _e1806 = (_e1632[2][0] - _e1632[1][0]);
                                                        let _e1807 = (_e1632[2][1] - _e1632[1][1]);
                                                        let _e1808 = (_e1632[2][2] - _e1632[1][2]);
                                                        let _e1809 = vec3<f32>(_e1806, _e1807, _e1808);
                                                        let _e1810 = (_e1632[0][0] - _e1632[2][0]);
                                                        let _e1811 = (_e1632[0][1] - _e1632[2][1]);
                                                        let _e1812 = (_e1632[0][2] - _e1632[2][2]);
                                                        let _e1813 = vec3<f32>(_e1810, _e1811, _e1812);
                                                        let _e1816 = bitcast<f32>((bitcast<u32>(_e1802) & 2147483647u));
                                                        let _e1819 = bitcast<f32>((bitcast<u32>(_e1803) & 2147483647u));
                                                        let _e1821 = select(_e1819, _e1816, (_e1816 > _e1819));
                                                        let _e1824 = bitcast<f32>((bitcast<u32>(_e1804) & 2147483647u));
                                                        let _e1826 = select(_e1824, _e1821, (_e1821 > _e1824));
                                                        let _e1829 = bitcast<f32>((bitcast<u32>(_e1806) & 2147483647u));
                                                        let _e1832 = bitcast<f32>((bitcast<u32>(_e1807) & 2147483647u));
                                                        let _e1834 = select(_e1832, _e1829, (_e1829 > _e1832));
                                                        let _e1837 = bitcast<f32>((bitcast<u32>(_e1808) & 2147483647u));
                                                        let _e1839 = select(_e1837, _e1834, (_e1834 > _e1837));
                                                        let _e1842 = bitcast<f32>((bitcast<u32>(_e1810) & 2147483647u));
                                                        let _e1845 = bitcast<f32>((bitcast<u32>(_e1811) & 2147483647u));
                                                        let _e1847 = select(_e1845, _e1842, (_e1842 > _e1845));
                                                        let _e1850 = bitcast<f32>((bitcast<u32>(_e1812) & 2147483647u));
                                                        let _e1852 = select(_e1850, _e1847, (_e1847 > _e1850));
                                                        let _e1854 = select(_e1839, _e1826, (_e1826 > _e1839));
                                                        let _e1856 = select(_e1852, _e1854, (_e1854 > _e1852));
                                                        if (_e1826 == _e1856) {
                                                            phi_2681_ = _e1662;
                                                            phi_2682_ = _e1659;
                                                            phi_2683_ = _e1653;
                                                            phi_2684_ = _e1650;
                                                            phi_2685_ = vec3<f32>(_e1632[0][0], _e1632[0][1], _e1632[0][2]);
                                                            phi_2686_ = _e1813;
                                                            phi_2687_ = _e1809;
                                                            phi_2688_ = _e1805;
                                                        } else {
                                                            let _e1858 = (_e1839 == _e1856);
                                                            let _e1863 = vec3(_e1858);
                                                            phi_2681_ = select(_e1653, _e1671, _e1858);
                                                            phi_2682_ = select(_e1650, _e1668, _e1858);
                                                            phi_2683_ = select(_e1671, _e1662, _e1858);
                                                            phi_2684_ = select(_e1668, _e1659, _e1858);
                                                            phi_2685_ = select(vec3<f32>(_e1632[2][0], _e1632[2][1], _e1632[2][2]), vec3<f32>(_e1632[1][0], _e1632[1][1], _e1632[1][2]), _e1863);
                                                            phi_2686_ = select(_e1809, _e1805, _e1863);
                                                            phi_2687_ = select(_e1805, _e1813, _e1863);
                                                            phi_2688_ = select(_e1813, _e1809, _e1863);
                                                        }
                                                        let _e1869 = phi_2681_;
                                                        let _e1871 = phi_2682_;
                                                        let _e1873 = phi_2683_;
                                                        let _e1875 = phi_2684_;
                                                        let _e1877 = phi_2685_;
                                                        let _e1879 = phi_2686_;
                                                        let _e1881 = phi_2687_;
                                                        let _e1883 = phi_2688_;
                                                        let _e1890 = ((_e1881.y * _e1879.z) - (_e1879.y * _e1881.z));
                                                        let _e1895 = ((_e1881.z * _e1879.x) - (_e1879.z * _e1881.x));
                                                        let _e1898 = ((_e1881.x * _e1879.y) - (_e1879.x * _e1881.y));
                                                        let _e1901 = ((_e1694 >= _e1698) && (_e1694 >= _e1702));
                                                        let _e1902 = (_e1698 >= _e1702);
                                                        let _e1916 = (((_e1890 * (select(select(_e1632[2][0], _e1632[1][0], _e1902), _e1632[0][0], _e1901) - _e335)) + (_e1895 * (select(select(_e1632[2][1], _e1632[1][1], _e1902), _e1632[0][1], _e1901) - _e402))) + (_e1898 * (select(select(_e1632[2][2], _e1632[1][2], _e1902), _e1632[0][2], _e1901) - _e468)));
                                                        let _e1921 = (((_e1890 * _e372) + (_e1895 * _e438)) + (_e1898 * _e504));
                                                        let _e1922 = (_e1871 - _e1875);
                                                        let _e1923 = (_e1869 - _e1873);
                                                        let _e1926 = ((_e1922 * _e1922) + (_e1923 * _e1923));
                                                        let _e1933 = (-(((_e1875 * _e1922) + (_e1873 * _e1923))) / select(0.000000000000000000000000000000000000011754944f, _e1926, (_e1926 > 0.000000000000000000000000000000000000011754944f)));
                                                        let _e1935 = select(1f, _e1933, (_e1933 < 1f));
                                                        let _e1937 = select(0f, _e1935, (_e1935 > 0f));
                                                        let _e1946 = ((_e1877.x + (_e1883.x * _e1937)) - _e335);
                                                        let _e1949 = ((_e1877.y + (_e1883.y * _e1937)) - _e402);
                                                        let _e1952 = ((_e1877.z + (_e1883.z * _e1937)) - _e468);
                                                        let _e1955 = bitcast<f32>((bitcast<u32>(_e1946) & 2147483647u));
                                                        let _e1958 = bitcast<f32>((bitcast<u32>(_e1949) & 2147483647u));
                                                        let _e1960 = select(_e1958, _e1955, (_e1955 > _e1958));
                                                        let _e1963 = bitcast<f32>((bitcast<u32>(_e1952) & 2147483647u));
                                                        let _e1965 = select(_e1963, _e1960, (_e1960 > _e1963));
                                                        let _e1971 = bitcast<f32>((bitcast<u32>(_e1890) & 2147483647u));
                                                        let _e1974 = bitcast<f32>((bitcast<u32>(_e1895) & 2147483647u));
                                                        let _e1976 = select(_e1974, _e1971, (_e1971 > _e1974));
                                                        let _e1979 = bitcast<f32>((bitcast<u32>(_e1898) & 2147483647u));
                                                        let _e1998 = bitcast<f32>((bitcast<u32>(_e1881.x) & 2147483647u));
                                                        let _e2001 = bitcast<f32>((bitcast<u32>(_e1881.y) & 2147483647u));
                                                        let _e2003 = select(_e2001, _e1998, (_e1998 > _e2001));
                                                        let _e2006 = bitcast<f32>((bitcast<u32>(_e1881.z) & 2147483647u));
                                                        let _e2012 = bitcast<f32>((bitcast<u32>(_e1879.x) & 2147483647u));
                                                        let _e2015 = bitcast<f32>((bitcast<u32>(_e1879.y) & 2147483647u));
                                                        let _e2017 = select(_e2015, _e2012, (_e2012 > _e2015));
                                                        let _e2020 = bitcast<f32>((bitcast<u32>(_e1879.z) & 2147483647u));
                                                        let _e2026 = ((bitcast<f32>((bitcast<u32>(((((_e1890 * _e1946) + (_e1895 * _e1949)) + (_e1898 * _e1952)) - _e1916)) & 2147483647u)) <= ((0.0000009536743f * select(_e1856, _e1965, (_e1965 > _e1856))) * select(_e1979, _e1976, (_e1976 > _e1979)))) && !((bitcast<f32>((bitcast<u32>(_e1921) & 2147483647u)) <= ((0.0000038146973f * select(_e2006, _e2003, (_e2003 > _e2006))) * select(_e2020, _e2017, (_e2017 > _e2020))))));
                                                        let _e2027 = (_e1916 / _e1921);
                                                        if (_e1797 && !(_e2026)) {
                                                            let _e2030 = (_e1952 / _e504);
                                                            let _e2038 = (((_e1890 * (_e1946 - (_e372 * _e2030))) + (_e1895 * (_e1949 - (_e438 * _e2030)))) / _e1921);
                                                            phi_2879_ = select(select(_e2030, (_e2030 + _e2038), (bitcast<f32>((bitcast<u32>(_e2038) & 2147483647u)) <= _e1856)), _e2027, _e2026);
                                                        } else {
                                                            phi_2879_ = _e2027;
                                                        }
                                                        let _e2047 = phi_2879_;
                                                        let _e2049 = select(_e1760, _e2047, (_e2047 < _e1760));
                                                        let _e2051 = select(_e1752, _e2049, (_e2049 > _e1752));
                                                        let _e2052 = (1f / _e1704);
                                                        phi_2899_ = type_31(_e2051, (_e1698 * _e2052), (_e1702 * _e2052), ((_e1797 && (_e2051 >= _e611)) && (_e2051 <= _e1185)));
                                                        phi_2900_ = type_31();
                                                    } else {
                                                        phi_2899_ = type_31();
                                                        phi_2900_ = type_31(0f, 0f, 0f, _e1797);
                                                    }
                                                    let _e2061 = phi_2899_;
                                                    let _e2063 = phi_2900_;
                                                    phi_2903_ = _e2061;
                                                    phi_2904_ = _e2063;
                                                    phi_2905_ = select(true, false, _e1797);
                                                } else {
                                                    phi_2903_ = type_31();
                                                    phi_2904_ = type_31(0f, 0f, 0f, _e1688);
                                                    phi_2905_ = true;
                                                }
                                                let _e2066 = phi_2903_;
                                                let _e2068 = phi_2904_;
                                                let _e2070 = phi_2905_;
                                                if _e2070 {
                                                    phi_2909_ = _e2068;
                                                } else {
                                                    phi_2909_ = _e2066;
                                                }
                                                let _e2072 = phi_2909_;
                                                if _e2072.member_3 {
                                                    phi_2918_ = type_20(_e2072.member, _e2072.member_1, _e2072.member_2, _e1245);
                                                } else {
                                                    phi_2918_ = type_20(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                }
                                                let _e2079 = phi_2918_;
                                                if (_e2079.member_3 != 4294967295u) {
                                                    if (_e1245 != 4294967295u) {
                                                        phi_2930_ = type_8(0u, 8u);
                                                        phi_2933_ = _e2079;
                                                        loop {
                                                            let _e2084 = phi_2930_;
                                                            let _e2086 = phi_2933_;
                                                            if (_e2084.member < _e2084.member_1) {
                                                                phi_2931_ = type_8((_e2084.member + 1u), _e2084.member_1);
                                                                phi_2956_ = type_8(1u, _e2084.member);
                                                            } else {
                                                                phi_2931_ = _e2084;
                                                                phi_2956_ = type_8(0u, type_8().member_1);
                                                            }
                                                            let _e2099 = phi_2931_;
                                                            let _e2101 = phi_2956_;
                                                            let _e2105 = (bitcast<i32>(_e2101.member) != 0i);
                                                            if _e2105 {
                                                                let _e2106 = (_e2101.member_1 < 8u);
                                                                if _e2106 {
                                                                } else {
                                                                    phi_5030_ = true;
                                                                    break;
                                                                }
                                                                let _e2111 = local_9[_e2101.member_1].member;
                                                                if (_e2086.member < _e2111) {
                                                                    phi_2989_ = true;
                                                                } else {
                                                                    let _e2113 = local_9[_e2101.member_1].member;
                                                                    if (_e2086.member == _e2113) {
                                                                        let _e2118 = local_9[_e2101.member_1].member_3;
                                                                        phi_2988_ = (_e2086.member_3 < _e2118);
                                                                    } else {
                                                                        phi_2988_ = false;
                                                                    }
                                                                    let _e2121 = phi_2988_;
                                                                    phi_2989_ = _e2121;
                                                                }
                                                                let _e2123 = phi_2989_;
                                                                if _e2123 {
                                                                    if _e2106 {
                                                                    } else {
                                                                        phi_5030_ = true;
                                                                        break;
                                                                    }
                                                                    let _e2124 = local_9[_e2101.member_1];
                                                                    local_9[_e2101.member_1] = type_20(_e2086.member, _e2086.member_1, _e2086.member_2, _e2086.member_3);
                                                                    phi_3010_ = type_20(_e2124.member, _e2124.member_1, _e2124.member_2, _e2124.member_3);
                                                                } else {
                                                                    phi_3010_ = _e2086;
                                                                }
                                                                let _e2135 = phi_3010_;
                                                                phi_2934_ = _e2135;
                                                            } else {
                                                                phi_2934_ = type_20();
                                                            }
                                                            let _e2137 = phi_2934_;
                                                            continue;
                                                            continuing {
                                                                phi_2930_ = _e2099;
                                                                phi_2933_ = _e2137;
                                                                phi_5030_ = _e1183;
                                                                break if !(_e2105);
                                                            }
                                                        }
                                                        let _e2140 = phi_5030_;
                                                        phi_5235_ = _e1185;
                                                        phi_5230_ = _e2140;
                                                        if _e2140 {
                                                            break;
                                                        }
                                                        let _e2143 = local_9[7u].member_3;
                                                        if (_e2143 != 4294967295u) {
                                                            let _e2147 = local_9[7u].member;
                                                            phi_5319_ = _e2147;
                                                        } else {
                                                            phi_5319_ = _e1185;
                                                        }
                                                        let _e2149 = phi_5319_;
                                                        phi_5318_ = _e2149;
                                                        phi_5233_ = _e2140;
                                                    } else {
                                                        phi_5318_ = _e1185;
                                                        phi_5233_ = _e1183;
                                                    }
                                                    let _e2151 = phi_5318_;
                                                    let _e2153 = phi_5233_;
                                                    phi_5317_ = _e2151;
                                                    phi_5232_ = _e2153;
                                                } else {
                                                    phi_5317_ = _e1185;
                                                    phi_5232_ = _e1183;
                                                }
                                                let _e2155 = phi_5317_;
                                                let _e2157 = phi_5232_;
                                                phi_5316_ = _e2155;
                                                phi_5231_ = _e2157;
                                            } else {
                                                phi_5316_ = _e1185;
                                                phi_5231_ = _e1183;
                                            }
                                            let _e2159 = phi_5316_;
                                            let _e2161 = phi_5231_;
                                            continue;
                                            continuing {
                                                phi_5060_ = _e2161;
                                                phi_5002_ = _e2159;
                                                phi_1388_ = _e1200;
                                                phi_5235_ = _e2159;
                                                phi_5230_ = _e2161;
                                                break if !(_e1206);
                                            }
                                        }
                                        let _e2164 = phi_5235_;
                                        let _e2166 = phi_5230_;
                                        phi_5320_ = _e2166;
                                        if _e2166 {
                                            break;
                                        }
                                        phi_5439_ = _e2164;
                                        phi_5324_ = _e2166;
                                        phi_4285_ = false;
                                        phi_4286_ = _e694;
                                        phi_4287_ = select(_e696, 0u, (_e611 > _e2164));
                                    } else {
                                        if (_e694.member_1 >= _e100) {
                                            phi_3823_ = type_53(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), type_52(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u), type_52(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u));
                                        } else {
                                            if (_e694.member_1 < _e100) {
                                            } else {
                                                phi_5320_ = true;
                                                break;
                                            }
                                            let _e708 = (_e271 * 2u);
                                            let _e710 = ((1u + _e708) % 7u);
                                            if (_e710 < 7u) {
                                            } else {
                                                phi_5320_ = true;
                                                break;
                                            }
                                            let _e715 = global_4.member[_e694.member_1][_e710];
                                            let _e717 = ((_e708 + 2u) % 7u);
                                            if (_e717 < 7u) {
                                            } else {
                                                phi_5320_ = true;
                                                break;
                                            }
                                            let _e722 = global_4.member[_e694.member_1][_e717];
                                            let _e723 = (_e270 * 2u);
                                            let _e725 = ((1u + _e723) % 7u);
                                            if (_e725 < 7u) {
                                            } else {
                                                phi_5320_ = true;
                                                break;
                                            }
                                            let _e730 = global_4.member[_e694.member_1][_e725];
                                            let _e732 = ((_e723 + 2u) % 7u);
                                            if (_e732 < 7u) {
                                            } else {
                                                phi_5320_ = true;
                                                break;
                                            }
                                            let _e737 = global_4.member[_e694.member_1][_e732];
                                            let _e738 = (_e272 * 2u);
                                            let _e740 = ((1u + _e738) % 7u);
                                            if (_e740 < 7u) {
                                            } else {
                                                phi_5320_ = true;
                                                break;
                                            }
                                            let _e745 = global_4.member[_e694.member_1][_e740];
                                            let _e747 = ((_e738 + 2u) % 7u);
                                            if (_e747 < 7u) {
                                            } else {
                                                phi_5320_ = true;
                                                break;
                                            }
                                            let _e752 = global_4.member[_e694.member_1][_e747];
                                            let _e775 = (bitcast<f32>((bitcast<u32>((_e694.member.member_1.x - _e694.member.member.x)) & 2139095040u)) * 0.0000009536743f);
                                            let _e776 = (bitcast<f32>((bitcast<u32>((_e694.member.member_1.y - _e694.member.member.y)) & 2139095040u)) * 0.0000009536743f);
                                            let _e777 = (bitcast<f32>((bitcast<u32>((_e694.member.member_1.z - _e694.member.member.z)) & 2139095040u)) * 0.0000009536743f);
                                            let _e779 = select(_e151, _e775, (_e775 > _e151));
                                            let _e781 = select(_e151, _e776, (_e776 > _e151));
                                            let _e783 = select(_e151, _e777, (_e777 > _e151));
                                            let _e814 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e715 & 2097151u))) - 8388608f) * _e779));
                                            let _e819 = (bitcast<i32>((_e715 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e822 = bitcast<f32>((_e814 & bitcast<u32>(_e819)));
                                            let _e823 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e730 & 2097151u))) - 8388608f) * _e781));
                                            let _e828 = (bitcast<i32>((_e730 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e831 = bitcast<f32>((_e823 & bitcast<u32>(_e828)));
                                            let _e832 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e745 & 2097151u))) - 8388608f) * _e783));
                                            let _e837 = (bitcast<i32>((_e745 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e840 = bitcast<f32>((_e832 & bitcast<u32>(_e837)));
                                            let _e844 = bitcast<f32>((_e814 & bitcast<u32>(~(_e819))));
                                            let _e848 = bitcast<f32>((_e823 & bitcast<u32>(~(_e828))));
                                            let _e852 = bitcast<f32>((_e832 & bitcast<u32>(~(_e837))));
                                            let _e853 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e722 & 2097151u))) - 8388608f) * _e779));
                                            let _e858 = (bitcast<i32>((_e722 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e861 = bitcast<f32>((_e853 & bitcast<u32>(_e858)));
                                            let _e862 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e737 & 2097151u))) - 8388608f) * _e781));
                                            let _e867 = (bitcast<i32>((_e737 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e870 = bitcast<f32>((_e862 & bitcast<u32>(_e867)));
                                            let _e871 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e752 & 2097151u))) - 8388608f) * _e783));
                                            let _e876 = (bitcast<i32>((_e752 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e879 = bitcast<f32>((_e871 & bitcast<u32>(_e876)));
                                            let _e883 = bitcast<f32>((_e853 & bitcast<u32>(~(_e858))));
                                            let _e887 = bitcast<f32>((_e862 & bitcast<u32>(~(_e867))));
                                            let _e891 = bitcast<f32>((_e871 & bitcast<u32>(~(_e876))));
                                            let _e892 = (_e694.member.member.x + _e822);
                                            let _e893 = (_e694.member.member.y + _e831);
                                            let _e894 = (_e694.member.member.z + _e840);
                                            let _e897 = (_e694.member.member_1.x - _e861);
                                            let _e898 = (_e694.member.member_1.y - _e870);
                                            let _e899 = (_e694.member.member_1.z - _e879);
                                            let _e918 = (_e897 - _e892);
                                            let _e919 = (_e898 - _e893);
                                            let _e920 = (_e899 - _e894);
                                            let _e922 = select(_e919, _e918, (_e918 > _e919));
                                            let _e924 = select(_e920, _e922, (_e922 > _e920));
                                            if (_e924 < (1024f * _e151)) {
                                                phi_3524_ = 0u;
                                            } else {
                                                phi_3524_ = select(2u, 1u, (_e924 < (2097152f * _e151)));
                                            }
                                            let _e931 = phi_3524_;
                                            switch bitcast<i32>(_e931) {
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
                                            let _e934 = phi_3530_;
                                            let _e940 = global_4.member[_e694.member_1][0u];
                                            let _e944 = global_4.member[_e694.member_1][2u];
                                            let _e948 = global_4.member[_e694.member_1][4u];
                                            let _e952 = global_4.member[_e694.member_1][6u];
                                            let _e964 = (((_e944 >> bitcast<u32>(22i)) | ((_e948 >> bitcast<u32>(22i)) << bitcast<u32>(10i))) | ((_e952 >> bitcast<u32>(22i)) << bitcast<u32>(20i)));
                                            let _e965 = (_e940 & 268435455u);
                                            let _e966 = (_e964 & 268435455u);
                                            let _e969 = ((_e940 >> bitcast<u32>(28u)) & 7u);
                                            let _e977 = ((_e940 >> bitcast<u32>(31i)) | (((_e964 >> bitcast<u32>(28u)) & 3u) << bitcast<u32>(1i)));
                                            let _e978 = (_e969 != 0u);
                                            if (_e969 == 0u) {
                                                phi_3785_ = _e965;
                                            } else {
                                                if (_e969 == 7u) {
                                                    phi_3784_ = 2147483648u;
                                                } else {
                                                    phi_3784_ = ((2147483648u | (_e969 << bitcast<u32>(28u))) | (_e966 & 268435455u));
                                                }
                                                let _e987 = phi_3784_;
                                                phi_3785_ = _e987;
                                            }
                                            let _e989 = phi_3785_;
                                            if _e978 {
                                                let _e990 = (_e969 != 7u);
                                                if _e990 {
                                                    phi_3795_ = (_e966 + (_e969 * ((3u * _e934) + 1u)));
                                                } else {
                                                    phi_3795_ = u32();
                                                }
                                                let _e994 = phi_3795_;
                                                phi_3797_ = _e994;
                                                phi_3798_ = select(true, false, _e990);
                                            } else {
                                                phi_3797_ = u32();
                                                phi_3798_ = true;
                                            }
                                            let _e997 = phi_3797_;
                                            let _e999 = phi_3798_;
                                            if (_e977 == 0u) {
                                                phi_3819_ = (_e965 + select(0u, 1u, !(_e978)));
                                            } else {
                                                if (_e977 == 7u) {
                                                    phi_3818_ = 2147483648u;
                                                } else {
                                                    phi_3818_ = ((2147483648u | (_e977 << bitcast<u32>(28u))) | (select(_e997, _e966, _e999) & 268435455u));
                                                }
                                                let _e1012 = phi_3818_;
                                                phi_3819_ = _e1012;
                                            }
                                            let _e1014 = phi_3819_;
                                            phi_3823_ = type_53(array<vec4<f32>, 3>(vec4<f32>(_e892, (_e694.member.member.x + _e844), _e897, (_e694.member.member_1.x - _e883)), vec4<f32>(_e893, (_e694.member.member.y + _e848), _e898, (_e694.member.member_1.y - _e887)), vec4<f32>(_e894, (_e694.member.member.z + _e852), _e899, (_e694.member.member_1.z - _e891))), type_52(type_24((_e694.member.member + vec4<f32>(_e822, _e831, _e840, 0f)), (_e694.member.member_1 - vec4<f32>(_e861, _e870, _e879, 0f))), _e989), type_52(type_24((_e694.member.member + vec4<f32>(_e844, _e848, _e852, 0f)), (_e694.member.member_1 - vec4<f32>(_e883, _e887, _e891, 0f))), _e1014));
                                        }
                                        let _e1019 = phi_3823_;
                                        let _e1030 = ((_e1019.member[0].x - _e373) * _e376);
                                        let _e1031 = ((_e1019.member[0].y - _e373) * _e376);
                                        let _e1032 = ((_e1019.member[0].z - _e374) * _e376);
                                        let _e1033 = ((_e1019.member[0].w - _e374) * _e376);
                                        let _e1043 = ((_e1019.member[1].x - _e439) * _e442);
                                        let _e1044 = ((_e1019.member[1].y - _e439) * _e442);
                                        let _e1045 = ((_e1019.member[1].z - _e440) * _e442);
                                        let _e1046 = ((_e1019.member[1].w - _e440) * _e442);
                                        let _e1056 = ((_e1019.member[2].x - _e505) * _e508);
                                        let _e1057 = ((_e1019.member[2].y - _e505) * _e508);
                                        let _e1058 = ((_e1019.member[2].z - _e506) * _e508);
                                        let _e1059 = ((_e1019.member[2].w - _e506) * _e508);
                                        let _e1061 = select(_e1058, _e1056, (_e1056 < _e1058));
                                        let _e1063 = select(_e1059, _e1057, (_e1057 < _e1059));
                                        let _e1065 = select(_e1058, _e1056, (_e1056 > _e1058));
                                        let _e1067 = select(_e1059, _e1057, (_e1057 > _e1059));
                                        let _e1069 = select(_e1032, _e1030, (_e1030 < _e1032));
                                        let _e1071 = select(_e1033, _e1031, (_e1031 < _e1033));
                                        let _e1073 = select(_e1045, _e1043, (_e1043 < _e1045));
                                        let _e1075 = select(_e1046, _e1044, (_e1044 < _e1046));
                                        let _e1077 = select(_e1073, _e1069, (_e1069 > _e1073));
                                        let _e1079 = select(_e1075, _e1071, (_e1071 > _e1075));
                                        let _e1081 = select(_e1061, _e1077, (_e1077 > _e1061));
                                        let _e1083 = select(_e1063, _e1079, (_e1079 > _e1063));
                                        let _e1085 = select(_e1032, _e1030, (_e1030 > _e1032));
                                        let _e1087 = select(_e1033, _e1031, (_e1031 > _e1033));
                                        let _e1089 = select(_e1045, _e1043, (_e1043 > _e1045));
                                        let _e1091 = select(_e1046, _e1044, (_e1044 > _e1046));
                                        let _e1093 = select(_e1089, _e1085, (_e1085 < _e1089));
                                        let _e1095 = select(_e1091, _e1087, (_e1087 < _e1091));
                                        let _e1100 = -(_e1061);
                                        let _e1101 = -(_e1063);
                                        let _e1108 = (select(_e1065, _e1093, (_e1093 < _e1065)) + (select(_e1100, _e1065, (_e1065 > _e1100)) * 0.0000019073523f));
                                        let _e1109 = (select(_e1067, _e1095, (_e1095 < _e1067)) + (select(_e1101, _e1067, (_e1067 > _e1101)) * 0.0000019073523f));
                                        let _e1111 = select(_e611, _e1081, (_e1081 > _e611));
                                        let _e1113 = select(_e611, _e1083, (_e1083 > _e611));
                                        let _e1118 = (_e1111 <= select(_e654, _e1108, (_e1108 < _e654)));
                                        let _e1119 = (_e1113 <= select(_e654, _e1109, (_e1109 < _e654)));
                                        let _e1120 = (_e1111 <= _e1113);
                                        if _e1118 {
                                            if _e1119 {
                                                if _e1120 {
                                                    phi_4186_ = _e1019.member_2;
                                                } else {
                                                    phi_4186_ = _e1019.member_1;
                                                }
                                                let _e1124 = phi_4186_;
                                                let _e1145 = (_e696 % 128u);
                                                let _e1146 = (_e1145 < 128u);
                                                if _e1146 {
                                                } else {
                                                    phi_5320_ = true;
                                                    break;
                                                }
                                                local_8[_e1145] = _e1124.member_1;
                                                if _e1146 {
                                                } else {
                                                    phi_5320_ = true;
                                                    break;
                                                }
                                                local_7[_e1145] = _e1124.member.member.x;
                                                if _e1146 {
                                                } else {
                                                    phi_5320_ = true;
                                                    break;
                                                }
                                                local_6[_e1145] = _e1124.member.member.y;
                                                if _e1146 {
                                                } else {
                                                    phi_5320_ = true;
                                                    break;
                                                }
                                                local_5[_e1145] = _e1124.member.member.z;
                                                if _e1146 {
                                                } else {
                                                    phi_5320_ = true;
                                                    break;
                                                }
                                                local_4[_e1145] = _e1124.member.member_1.x;
                                                if _e1146 {
                                                } else {
                                                    phi_5320_ = true;
                                                    break;
                                                }
                                                local_3[_e1145] = _e1124.member.member_1.y;
                                                if _e1146 {
                                                } else {
                                                    phi_5320_ = true;
                                                    break;
                                                }
                                                local_2[_e1145] = _e1124.member.member_1.z;
                                                if _e1146 {
                                                } else {
                                                    phi_5320_ = true;
                                                    break;
                                                }
                                                local_10[_e1145] = select(_e1111, _e1113, _e1120);
                                                if _e1120 {
                                                    phi_4262_ = _e1019.member_1;
                                                } else {
                                                    phi_4262_ = _e1019.member_2;
                                                }
                                                let _e1159 = phi_4262_;
                                                phi_4263_ = _e1159;
                                                phi_4264_ = (_e696 + 1u);
                                            } else {
                                                phi_4263_ = type_52();
                                                phi_4264_ = u32();
                                            }
                                            let _e1161 = phi_4263_;
                                            let _e1163 = phi_4264_;
                                            phi_4266_ = _e1161;
                                            phi_4267_ = _e1163;
                                            phi_4268_ = select(true, false, _e1119);
                                        } else {
                                            phi_4266_ = type_52();
                                            phi_4267_ = u32();
                                            phi_4268_ = true;
                                        }
                                        let _e1166 = phi_4266_;
                                        let _e1168 = phi_4267_;
                                        let _e1170 = phi_4268_;
                                        if _e1170 {
                                            if _e1118 {
                                                phi_4277_ = _e1019.member_1;
                                            } else {
                                                phi_4277_ = _e1019.member_2;
                                            }
                                            let _e1174 = phi_4277_;
                                            phi_4282_ = select(_e1119, true, _e1118);
                                            phi_4283_ = _e1174;
                                        } else {
                                            phi_4282_ = _e692;
                                            phi_4283_ = _e1166;
                                        }
                                        let _e1177 = phi_4282_;
                                        let _e1179 = phi_4283_;
                                        phi_5439_ = _e654;
                                        phi_5324_ = _e652;
                                        phi_4285_ = _e1177;
                                        phi_4286_ = _e1179;
                                        phi_4287_ = select(_e1168, _e696, _e1170);
                                    }
                                    let _e2170 = phi_5439_;
                                    let _e2172 = phi_5324_;
                                    let _e2174 = phi_4285_;
                                    let _e2176 = phi_4286_;
                                    let _e2178 = phi_4287_;
                                    phi_5438_ = _e2170;
                                    phi_5323_ = _e2172;
                                    phi_4288_ = _e2174;
                                    phi_4289_ = _e2176;
                                    phi_4290_ = _e2178;
                                    phi_4291_ = (_e662 - 1u);
                                } else {
                                    phi_5438_ = _e654;
                                    phi_5323_ = _e652;
                                    phi_4288_ = _e692;
                                    phi_4289_ = _e694;
                                    phi_4290_ = _e696;
                                    phi_4291_ = _e662;
                                }
                                let _e2180 = phi_5438_;
                                let _e2182 = phi_5323_;
                                let _e2184 = phi_4288_;
                                let _e2186 = phi_4289_;
                                let _e2188 = phi_4290_;
                                let _e2190 = phi_4291_;
                                phi_5437_ = _e2180;
                                phi_5322_ = _e2182;
                                phi_4292_ = _e2184;
                                phi_4293_ = _e2186;
                                phi_4294_ = _e2188;
                                phi_4295_ = _e2190;
                            } else {
                                phi_5437_ = _e654;
                                phi_5322_ = _e652;
                                phi_4292_ = bool();
                                phi_4293_ = type_52();
                                phi_4294_ = u32();
                                phi_4295_ = u32();
                            }
                            let _e2192 = phi_5437_;
                            let _e2194 = phi_5322_;
                            let _e2196 = phi_4292_;
                            let _e2198 = phi_4293_;
                            let _e2200 = phi_4294_;
                            let _e2202 = phi_4295_;
                            phi_5436_ = _e2192;
                            phi_5321_ = _e2194;
                            phi_1263_ = _e2196;
                            phi_1266_ = _e2198;
                            phi_1268_ = _e2200;
                            phi_1270_ = _e2202;
                            phi_4296_ = _e666;
                        } else {
                            phi_5436_ = _e654;
                            phi_5321_ = _e652;
                            phi_1263_ = bool();
                            phi_1266_ = type_52();
                            phi_1268_ = u32();
                            phi_1270_ = u32();
                            phi_4296_ = false;
                        }
                        let _e2204 = phi_5436_;
                        let _e2206 = phi_5321_;
                        let _e2208 = phi_1263_;
                        let _e2210 = phi_1266_;
                        let _e2212 = phi_1268_;
                        let _e2214 = phi_1270_;
                        let _e2216 = phi_4296_;
                        continue;
                        continuing {
                            phi_5063_ = _e2206;
                            phi_4918_ = _e2204;
                            phi_1262_ = _e2208;
                            phi_1265_ = _e2210;
                            phi_1267_ = _e2212;
                            phi_1269_ = _e2214;
                            phi_5320_ = _e2206;
                            break if !(_e2216);
                        }
                    }
                    let _e2219 = phi_5320_;
                    if _e2219 {
                        break;
                    }
                    phi_4303_ = type_8(0u, 8u);
                    loop {
                        let _e2221 = phi_4303_;
                        if (_e2221.member < _e2221.member_1) {
                            phi_4304_ = type_8((_e2221.member + 1u), _e2221.member_1);
                            phi_4327_ = type_8(1u, _e2221.member);
                        } else {
                            phi_4304_ = _e2221;
                            phi_4327_ = type_8(0u, type_8().member_1);
                        }
                        let _e2234 = phi_4304_;
                        let _e2236 = phi_4327_;
                        let _e2240 = (bitcast<i32>(_e2236.member) != 0i);
                        if _e2240 {
                            let _e2241 = (_e2236.member_1 < 8u);
                            if _e2241 {
                            } else {
                                phi_5418_ = true;
                                break;
                            }
                            let _e2243 = local_9[_e2236.member_1];
                            if (_e2243.member_3 != 4294967295u) {
                                let _e2249 = -(_e513);
                                let _e2250 = bitcast<u32>(_e2243.member);
                                let _e2254 = (bitcast<i32>((_e2250 >> bitcast<u32>(23i))) & 255i);
                                let _e2255 = (_e2254 + _e2249);
                                if (_e2254 == 255i) {
                                    phi_4400_ = _e2243.member;
                                } else {
                                    if (_e2254 > 0i) {
                                        if (_e2255 > 0i) {
                                            let _e2259 = (_e2255 < 255i);
                                            if _e2259 {
                                                phi_4379_ = bitcast<f32>((_e2250 + bitcast<u32>((_e2249 << bitcast<u32>(23i)))));
                                            } else {
                                                phi_4379_ = f32();
                                            }
                                            let _e2266 = phi_4379_;
                                            phi_4381_ = _e2266;
                                            phi_4382_ = select(true, false, _e2259);
                                        } else {
                                            phi_4381_ = f32();
                                            phi_4382_ = true;
                                        }
                                        let _e2269 = phi_4381_;
                                        let _e2271 = phi_4382_;
                                        phi_4383_ = _e2269;
                                        phi_4384_ = _e2271;
                                    } else {
                                        phi_4383_ = f32();
                                        phi_4384_ = true;
                                    }
                                    let _e2273 = phi_4383_;
                                    let _e2275 = phi_4384_;
                                    if _e2275 {
                                        let _e2276 = (_e2250 & 2147483648u);
                                        let _e2283 = ((_e2250 & 8388607u) | (select(0u, 1u, ((_e2250 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                                        let _e2287 = (_e2283 == 0u);
                                        if _e2287 {
                                            phi_4865_ = bitcast<f32>(_e2276);
                                        } else {
                                            let _e2292 = (select((bitcast<u32>(31i) - firstLeadingBit(_e2283)), 32u, _e2287) - 8u);
                                            let _e2295 = (_e2283 << bitcast<u32>((_e2292 & 31u)));
                                            let _e2297 = ((_e2255 + select(0i, 1i, (_e2254 == 0i))) - bitcast<i32>(_e2292));
                                            if (_e2297 >= 255i) {
                                                phi_4855_ = bitcast<f32>((_e2276 | 2139095040u));
                                                phi_4856_ = f32();
                                                phi_4857_ = true;
                                            } else {
                                                let _e2299 = (_e2297 > 0i);
                                                if _e2299 {
                                                    phi_4849_ = bitcast<f32>(((_e2276 | (bitcast<u32>(_e2297) << bitcast<u32>(23i))) | (_e2295 & 8388607u)));
                                                    phi_4850_ = f32();
                                                } else {
                                                    if (_e2297 < -24i) {
                                                        phi_4815_ = 26u;
                                                    } else {
                                                        phi_4815_ = bitcast<u32>((1i - _e2297));
                                                    }
                                                    let _e2304 = phi_4815_;
                                                    let _e2305 = (_e2304 & 31u);
                                                    let _e2307 = (_e2295 >> bitcast<u32>(_e2305));
                                                    let _e2311 = (_e2295 & ((1u << bitcast<u32>(_e2305)) - 1u));
                                                    let _e2315 = (1u << bitcast<u32>(((_e2304 - 1u) & 31u)));
                                                    if (_e2311 > _e2315) {
                                                        phi_4836_ = true;
                                                    } else {
                                                        if (_e2311 == _e2315) {
                                                            phi_4833_ = ((_e2307 & 1u) == 1u);
                                                        } else {
                                                            phi_4833_ = false;
                                                        }
                                                        let _e2321 = phi_4833_;
                                                        phi_4836_ = _e2321;
                                                    }
                                                    let _e2323 = phi_4836_;
                                                    phi_4849_ = f32();
                                                    phi_4850_ = bitcast<f32>((_e2276 | (_e2307 + select(0u, 1u, _e2323))));
                                                }
                                                let _e2336 = phi_4849_;
                                                let _e2338 = phi_4850_;
                                                phi_4855_ = _e2336;
                                                phi_4856_ = _e2338;
                                                phi_4857_ = _e2299;
                                            }
                                            let _e2342 = phi_4855_;
                                            let _e2344 = phi_4856_;
                                            let _e2346 = phi_4857_;
                                            phi_4865_ = select(_e2344, _e2342, _e2346);
                                        }
                                        let _e2350 = phi_4865_;
                                        phi_4399_ = _e2350;
                                    } else {
                                        phi_4399_ = _e2273;
                                    }
                                    let _e2352 = phi_4399_;
                                    phi_4400_ = _e2352;
                                }
                                let _e2354 = phi_4400_;
                                let _e2355 = bitcast<u32>(_e2354);
                                if ((_e2355 & 2147483647u) >= 2139095040u) {
                                    phi_4412_ = bitcast<f32>(((_e2355 & 2147483648u) | 2139095039u));
                                } else {
                                    phi_4412_ = _e2354;
                                }
                                let _e2362 = phi_4412_;
                                phi_4417_ = type_20(_e2362, _e2243.member_1, _e2243.member_2, _e2243.member_3);
                            } else {
                                phi_4417_ = type_20(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                            }
                            let _e2365 = phi_4417_;
                            if _e2241 {
                            } else {
                                phi_5418_ = true;
                                break;
                            }
                            local_9[_e2236.member_1] = type_20(_e2365.member, _e2365.member_1, _e2365.member_2, _e2365.member_3);
                        }
                        continue;
                        continuing {
                            phi_4303_ = _e2234;
                            phi_5418_ = _e2219;
                            break if !(_e2240);
                        }
                    }
                    let _e2373 = phi_5418_;
                    if _e2373 {
                        break;
                    }
                    let _e2374 = local_9;
                    if _e159 {
                    } else {
                        break;
                    }
                    global_6.member[_e157] = array<type_20, 8>(type_20(_e2374[0].member, _e2374[0].member_1, _e2374[0].member_2, _e2374[0].member_3), type_20(_e2374[1].member, _e2374[1].member_1, _e2374[1].member_2, _e2374[1].member_3), type_20(_e2374[2].member, _e2374[2].member_1, _e2374[2].member_2, _e2374[2].member_3), type_20(_e2374[3].member, _e2374[3].member_1, _e2374[3].member_2, _e2374[3].member_3), type_20(_e2374[4].member, _e2374[4].member_1, _e2374[4].member_2, _e2374[4].member_3), type_20(_e2374[5].member, _e2374[5].member_1, _e2374[5].member_2, _e2374[5].member_3), type_20(_e2374[6].member, _e2374[6].member_1, _e2374[6].member_2, _e2374[6].member_3), type_20(_e2374[7].member, _e2374[7].member_1, _e2374[7].member_2, _e2374[7].member_3));
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
