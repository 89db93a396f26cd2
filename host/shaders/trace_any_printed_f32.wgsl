struct type_4 {
    member: array<u32>,
}

struct type_7 {
    member: u32,
    member_1: u32,
}

struct type_11 {
    member: vec4<u32>,
}

struct type_16 {
    member: array<f32, 9>,
    member_1: u32,
}

struct type_18 {
    member: array<type_16>,
}

struct type_25 {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: u32,
}

struct type_26 {
    member: array<f32, 3>,
    member_1: f32,
    member_2: array<f32, 3>,
    member_3: f32,
}

struct type_35 {
    member: array<type_26>,
}

struct type_37 {
    member: f32,
    member_1: bool,
}

struct type_39 {
    member: array<vec4<u32>, 2>,
}

struct type_41 {
    member: array<u32, 2>,
    member_1: array<u32, 2>,
    member_2: u32,
    member_3: u32,
}

struct type_43 {
    member: array<type_41>,
}

struct type_46 {
    member: array<f32, 3>,
    member_1: array<f32, 3>,
}

struct type_48 {
    member: type_46,
    member_1: u32,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_1: type_11;
@group(0) @binding(3) 
var<storage> global_2: type_18;
@group(0) @binding(1) 
var<uniform> global_3: type_39;
@group(0) @binding(4) 
var<storage> global_4: type_35;
@group(0) @binding(5) 
var<storage, read_write> global_5: type_4;
@group(0) @binding(2) 
var<storage> global_6: type_43;

fn function_() {
    var local: array<f32, 128>;
    var local_1: array<f32, 128>;
    var local_2: array<f32, 128>;
    var local_3: array<f32, 128>;
    var local_4: array<f32, 128>;
    var local_5: array<f32, 128>;
    var local_6: array<u32, 128>;
    var local_7: array<f32, 128>;
    var local_8: array<f32, 3>;
    var local_9: array<f32, 3>;
    var phi_327_: i32;
    var phi_328_: i32;
    var phi_338_: bool;
    var phi_348_: u32;
    var phi_349_: u32;
    var phi_351_: bool;
    var phi_356_: u32;
    var phi_368_: i32;
    var phi_388_: i32;
    var phi_406_: f32;
    var phi_412_: f32;
    var phi_423_: f32;
    var phi_429_: f32;
    var phi_452_: f32;
    var phi_463_: f32;
    var phi_472_: f32;
    var phi_478_: f32;
    var phi_489_: f32;
    var phi_495_: f32;
    var phi_518_: f32;
    var phi_529_: f32;
    var phi_538_: f32;
    var phi_544_: f32;
    var phi_555_: f32;
    var phi_561_: f32;
    var phi_584_: f32;
    var phi_595_: f32;
    var phi_695_: f32;
    var phi_696_: f32;
    var phi_2908_: bool;
    var phi_769_: type_37;
    var phi_772_: type_48;
    var phi_774_: u32;
    var phi_776_: bool;
    var phi_778_: u32;
    var phi_789_: bool;
    var phi_875_: type_48;
    var phi_876_: bool;
    var phi_877_: u32;
    var phi_1906_: type_41;
    var phi_2738_: type_48;
    var phi_2815_: type_48;
    var phi_2816_: type_48;
    var phi_2817_: u32;
    var phi_2819_: type_48;
    var phi_2820_: u32;
    var phi_2821_: bool;
    var phi_2828_: type_48;
    var phi_2833_: type_48;
    var phi_2834_: bool;
    var phi_895_: type_37;
    var phi_898_: type_7;
    var phi_899_: type_7;
    var phi_921_: type_7;
    var phi_942_: u32;
    var phi_1031_: array<array<f32, 3>, 3>;
    var phi_1148_: bool;
    var phi_1177_: bool;
    var phi_1578_: f32;
    var phi_1579_: f32;
    var phi_1580_: f32;
    var phi_1581_: f32;
    var phi_1582_: vec3<f32>;
    var phi_1583_: vec3<f32>;
    var phi_1584_: vec3<f32>;
    var phi_1585_: vec3<f32>;
    var phi_1616_: bool;
    var phi_1625_: vec3<f32>;
    var phi_1792_: bool;
    var phi_1816_: f32;
    var phi_1817_: f32;
    var phi_1840_: type_25;
    var phi_1842_: type_25;
    var phi_1843_: bool;
    var phi_1847_: type_25;
    var phi_1848_: type_25;
    var phi_1849_: type_25;
    var phi_1850_: bool;
    var phi_1854_: type_25;
    var phi_1855_: bool;
    var phi_1856_: type_25;
    var phi_1857_: bool;
    var phi_1858_: bool;
    var phi_1859_: type_25;
    var phi_1860_: bool;
    var phi_1861_: bool;
    var phi_1869_: type_25;
    var phi_1870_: bool;
    var phi_1874_: type_25;
    var phi_1885_: type_37;
    var phi_1886_: type_37;
    var phi_896_: type_37;
    var phi_2902_: bool;
    var local_10: type_37;
    var phi_3045_: bool;
    var phi_2836_: type_37;
    var phi_2837_: type_48;
    var phi_2838_: bool;
    var phi_2839_: u32;
    var phi_3044_: bool;
    var phi_2840_: type_37;
    var phi_2841_: type_48;
    var phi_2842_: u32;
    var phi_2843_: bool;
    var phi_2844_: u32;
    var phi_3043_: bool;
    var phi_2845_: type_37;
    var phi_2846_: type_48;
    var phi_2847_: u32;
    var phi_2848_: bool;
    var phi_2849_: u32;
    var phi_3042_: bool;
    var phi_770_: type_37;
    var phi_773_: type_48;
    var phi_775_: u32;
    var phi_777_: bool;
    var phi_779_: u32;
    var phi_2850_: bool;
    var phi_3041_: bool;
    var local_11: type_37;
    var local_12: type_37;

    switch bitcast<i32>(0u) {
        default: {
            let _e76 = global;
            let _e79 = arrayLength((&global_6.member));
            let _e81 = arrayLength((&global_2.member));
            let _e89 = global_3.member[0u][0u];
            let _e93 = global_3.member[0u][1u];
            let _e97 = global_3.member[0u][2u];
            let _e101 = global_3.member[1u][0u];
            let _e105 = global_3.member[1u][1u];
            let _e109 = global_3.member[1u][2u];
            let _e113 = global_3.member[1u][3u];
            let _e116 = global_1.member[0u];
            let _e117 = bitcast<i32>(_e116);
            let _e127 = (_e76.x + (_e76.y * 2097152u));
            let _e128 = (_e127 < arrayLength((&global_4.member)));
            if _e128 {
                let _e129 = (_e127 < arrayLength((&global_5.member)));
                if _e129 {
                    if _e128 {
                    } else {
                        break;
                    }
                    let _e137 = global_4.member[_e127].member_2[0u];
                    let _e139 = (bitcast<u32>(_e137) & 2147483647u);
                    let _e144 = global_4.member[_e127].member_2[1u];
                    let _e146 = (bitcast<u32>(_e144) & 2147483647u);
                    let _e151 = global_4.member[_e127].member_2[2u];
                    let _e153 = (bitcast<u32>(_e151) & 2147483647u);
                    let _e158 = global_4.member[_e127].member[0u];
                    let _e160 = (bitcast<u32>(_e158) & 2147483647u);
                    let _e165 = global_4.member[_e127].member[1u];
                    let _e167 = (bitcast<u32>(_e165) & 2147483647u);
                    let _e172 = global_4.member[_e127].member[2u];
                    let _e174 = (bitcast<u32>(_e172) & 2147483647u);
                    let _e176 = select(_e146, _e139, (_e146 < _e139));
                    let _e178 = select(_e153, _e176, (_e153 < _e176));
                    let _e180 = select(_e160, _e178, (_e160 < _e178));
                    let _e182 = select(_e167, _e180, (_e167 < _e180));
                    let _e184 = select(_e174, _e182, (_e174 < _e182));
                    let _e188 = global_4.member[_e127].member_1;
                    let _e190 = (bitcast<u32>(_e188) & 2147483647u);
                    let _e197 = global_4.member[_e127].member_3;
                    let _e203 = (((select(_e190, _e184, (_e190 < _e184)) < 2139095040u) && ((bitcast<u32>(_e197) & 2147483647u) <= 2139095040u)) && (_e178 > 0u));
                    if _e203 {
                        let _e206 = (bitcast<u32>(bitcast<f32>(_e178)) & 2147483647u);
                        if (_e206 >= 8388608u) {
                            phi_327_ = (bitcast<i32>((_e206 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_327_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e206)), 32u, (_e206 == 0u))));
                        }
                        let _e220 = phi_327_;
                        phi_328_ = _e220;
                    } else {
                        phi_328_ = 0i;
                    }
                    let _e222 = phi_328_;
                    let _e223 = (_e139 == _e178);
                    if _e223 {
                        phi_338_ = true;
                    } else {
                        phi_338_ = (_e146 == _e178);
                    }
                    let _e226 = phi_338_;
                    let _e227 = select(1u, 0u, _e223);
                    if _e226 {
                        let _e228 = (_e227 + 1u);
                        phi_348_ = _e228;
                        phi_349_ = _e228;
                        phi_351_ = select(true, false, (_e228 == 2u));
                    } else {
                        phi_348_ = u32();
                        phi_349_ = 0u;
                        phi_351_ = true;
                    }
                    let _e232 = phi_348_;
                    let _e234 = phi_349_;
                    let _e236 = phi_351_;
                    if _e236 {
                        phi_356_ = (_e234 + 1u);
                    } else {
                        phi_356_ = 0u;
                    }
                    let _e240 = phi_356_;
                    let _e241 = select(_e232, _e234, _e236);
                    let _e242 = select(_e227, select(2u, _e227, _e226), _e236);
                    if (_e117 < -126i) {
                        phi_368_ = -126i;
                    } else {
                        phi_368_ = select(_e117, 127i, (_e117 > 127i));
                    }
                    let _e247 = phi_368_;
                    let _e252 = bitcast<f32>((bitcast<u32>((_e247 + 127i)) << bitcast<u32>(23i)));
                    let _e258 = bitcast<f32>((bitcast<u32>(((_e117 - _e247) + 127i)) << bitcast<u32>(23i)));
                    let _e259 = -(_e222);
                    if (_e259 < -126i) {
                        phi_388_ = -126i;
                    } else {
                        phi_388_ = select(_e259, 127i, (_e259 > 127i));
                    }
                    let _e264 = phi_388_;
                    let _e269 = bitcast<f32>((bitcast<u32>((_e264 + 127i)) << bitcast<u32>(23i)));
                    let _e275 = bitcast<f32>((bitcast<u32>(((_e259 - _e264) + 127i)) << bitcast<u32>(23i)));
                    let _e279 = global_4.member[_e127].member;
                    let _e280 = (_e241 == 0u);
                    if _e280 {
                        phi_406_ = _e279[0];
                    } else {
                        phi_406_ = _e279[1];
                    }
                    let _e284 = phi_406_;
                    let _e285 = (_e241 == 2u);
                    if _e285 {
                        phi_412_ = _e279[2];
                    } else {
                        phi_412_ = _e284;
                    }
                    let _e288 = phi_412_;
                    let _e290 = ((_e288 * _e252) * _e258);
                    let _e291 = global_4.member[_e127].member_2;
                    if _e280 {
                        phi_423_ = _e291[0];
                    } else {
                        phi_423_ = _e291[1];
                    }
                    let _e295 = phi_423_;
                    if _e285 {
                        phi_429_ = _e291[2];
                    } else {
                        phi_429_ = _e295;
                    }
                    let _e298 = phi_429_;
                    let _e300 = ((_e298 * _e269) * _e275);
                    let _e304 = (bitcast<f32>((bitcast<u32>(_e300) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e304 {
                        let _e308 = (bitcast<f32>((bitcast<u32>(_e290) & 2147483647u)) * 0.00000011920929f);
                        phi_452_ = select(0.00000000000011368684f, _e308, (_e308 > 0.00000000000011368684f));
                    } else {
                        phi_452_ = 0f;
                    }
                    let _e312 = phi_452_;
                    let _e313 = (_e290 + _e312);
                    let _e314 = (_e290 - _e312);
                    let _e315 = select(_e300, 0f, _e304);
                    if _e304 {
                        phi_463_ = 38685626000000000000000000f;
                    } else {
                        phi_463_ = (1f / _e300);
                    }
                    let _e318 = phi_463_;
                    let _e319 = (_e240 == 0u);
                    if _e319 {
                        phi_472_ = _e279[0];
                    } else {
                        phi_472_ = _e279[1];
                    }
                    let _e323 = phi_472_;
                    let _e324 = (_e240 == 2u);
                    if _e324 {
                        phi_478_ = _e279[2];
                    } else {
                        phi_478_ = _e323;
                    }
                    let _e327 = phi_478_;
                    let _e329 = ((_e327 * _e252) * _e258);
                    if _e319 {
                        phi_489_ = _e291[0];
                    } else {
                        phi_489_ = _e291[1];
                    }
                    let _e333 = phi_489_;
                    if _e324 {
                        phi_495_ = _e291[2];
                    } else {
                        phi_495_ = _e333;
                    }
                    let _e336 = phi_495_;
                    let _e338 = ((_e336 * _e269) * _e275);
                    let _e342 = (bitcast<f32>((bitcast<u32>(_e338) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e342 {
                        let _e346 = (bitcast<f32>((bitcast<u32>(_e329) & 2147483647u)) * 0.00000011920929f);
                        phi_518_ = select(0.00000000000011368684f, _e346, (_e346 > 0.00000000000011368684f));
                    } else {
                        phi_518_ = 0f;
                    }
                    let _e350 = phi_518_;
                    let _e351 = (_e329 + _e350);
                    let _e352 = (_e329 - _e350);
                    let _e353 = select(_e338, 0f, _e342);
                    if _e342 {
                        phi_529_ = 38685626000000000000000000f;
                    } else {
                        phi_529_ = (1f / _e338);
                    }
                    let _e356 = phi_529_;
                    let _e357 = (_e242 == 0u);
                    if _e357 {
                        phi_538_ = _e279[0];
                    } else {
                        phi_538_ = _e279[1];
                    }
                    let _e361 = phi_538_;
                    let _e362 = (_e242 == 2u);
                    if _e362 {
                        phi_544_ = _e279[2];
                    } else {
                        phi_544_ = _e361;
                    }
                    let _e365 = phi_544_;
                    let _e367 = ((_e365 * _e252) * _e258);
                    if _e357 {
                        phi_555_ = _e291[0];
                    } else {
                        phi_555_ = _e291[1];
                    }
                    let _e371 = phi_555_;
                    if _e362 {
                        phi_561_ = _e291[2];
                    } else {
                        phi_561_ = _e371;
                    }
                    let _e374 = phi_561_;
                    let _e376 = ((_e374 * _e269) * _e275);
                    let _e380 = (bitcast<f32>((bitcast<u32>(_e376) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e380 {
                        let _e384 = (bitcast<f32>((bitcast<u32>(_e367) & 2147483647u)) * 0.00000011920929f);
                        phi_584_ = select(0.00000000000011368684f, _e384, (_e384 > 0.00000000000011368684f));
                    } else {
                        phi_584_ = 0f;
                    }
                    let _e388 = phi_584_;
                    let _e389 = (_e367 + _e388);
                    let _e390 = (_e367 - _e388);
                    let _e391 = select(_e376, 0f, _e380);
                    if _e380 {
                        phi_595_ = 38685626000000000000000000f;
                    } else {
                        phi_595_ = (1f / _e376);
                    }
                    let _e394 = phi_595_;
                    let _e397 = bitcast<f32>((bitcast<u32>(_e290) & 2147483647u));
                    let _e400 = bitcast<f32>((bitcast<u32>(_e329) & 2147483647u));
                    let _e402 = select(_e400, _e397, (_e397 > _e400));
                    let _e405 = bitcast<f32>((bitcast<u32>(_e367) & 2147483647u));
                    let _e408 = (_e117 + _e222);
                    if (_e203 && (select(_e405, _e402, (_e402 > _e405)) <= 1099511600000f)) {
                        let _e411 = (_e408 / 3i);
                        let _e418 = bitcast<f32>((bitcast<u32>((_e411 + 127i)) << bitcast<u32>(23i)));
                        let _e425 = bitcast<f32>((bitcast<u32>(((_e408 - (2i * _e411)) + 127i)) << bitcast<u32>(23i)));
                        let _e426 = (((_e188 * _e418) * _e418) * _e425);
                        let _e428 = select(340282350000000000000000000000000000000f, _e426, (_e426 < 340282350000000000000000000000000000000f));
                        let _e433 = (((_e197 * _e418) * _e418) * _e425);
                        let _e435 = select(340282350000000000000000000000000000000f, _e433, (_e433 < 340282350000000000000000000000000000000f));
                        phi_695_ = select(-340282350000000000000000000000000000000f, _e435, (_e435 > -340282350000000000000000000000000000000f));
                        phi_696_ = select(-340282350000000000000000000000000000000f, _e428, (_e428 > -340282350000000000000000000000000000000f));
                    } else {
                        phi_695_ = 0f;
                        phi_696_ = 1f;
                    }
                    let _e439 = phi_695_;
                    let _e441 = phi_696_;
                    local_6 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                    local_5 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_4 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_3 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_1 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_7 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_9 = array<f32, 3>(bitcast<f32>(_e89), bitcast<f32>(_e93), bitcast<f32>(_e97));
                    let _e446 = (_e241 % 3u);
                    let _e447 = (_e446 < 3u);
                    if _e447 {
                    } else {
                        break;
                    }
                    let _e449 = local_9[_e446];
                    let _e450 = (_e240 % 3u);
                    let _e451 = (_e450 < 3u);
                    if _e451 {
                    } else {
                        break;
                    }
                    let _e453 = local_9[_e450];
                    let _e454 = (_e242 % 3u);
                    let _e455 = (_e454 < 3u);
                    if _e455 {
                    } else {
                        break;
                    }
                    let _e457 = local_9[_e454];
                    local_8 = array<f32, 3>(bitcast<f32>(_e101), bitcast<f32>(_e105), bitcast<f32>(_e109));
                    if _e447 {
                    } else {
                        break;
                    }
                    let _e461 = local_8[_e446];
                    if _e451 {
                    } else {
                        break;
                    }
                    let _e463 = local_8[_e450];
                    if _e455 {
                    } else {
                        break;
                    }
                    let _e465 = local_8[_e454];
                    phi_2908_ = false;
                    phi_769_ = type_37(_e439, false);
                    phi_772_ = type_48(type_46(array<f32, 3>(_e449, _e453, _e457), array<f32, 3>(_e461, _e463, _e465)), select(0u, 2147483648u, (_e79 == 0u)));
                    phi_774_ = ((3u * _e79) + 1u);
                    phi_776_ = (_e441 <= _e439);
                    phi_778_ = 0u;
                    loop {
                        let _e473 = phi_2908_;
                        let _e475 = phi_769_;
                        let _e477 = phi_772_;
                        let _e479 = phi_774_;
                        let _e481 = phi_776_;
                        let _e483 = phi_778_;
                        local_11 = _e475;
                        if _e481 {
                            phi_789_ = true;
                        } else {
                            phi_789_ = (_e483 > 0u);
                        }
                        let _e486 = phi_789_;
                        if _e486 {
                            let _e487 = (_e479 > 0u);
                            if _e487 {
                                if _e481 {
                                    phi_875_ = _e477;
                                    phi_876_ = _e481;
                                    phi_877_ = _e483;
                                } else {
                                    let _e488 = (_e483 - 1u);
                                    let _e489 = (_e488 % 128u);
                                    let _e490 = (_e489 < 128u);
                                    if _e490 {
                                    } else {
                                        phi_3041_ = true;
                                        break;
                                    }
                                    let _e492 = local_6[_e489];
                                    if _e490 {
                                    } else {
                                        phi_3041_ = true;
                                        break;
                                    }
                                    let _e494 = local_5[_e489];
                                    if _e490 {
                                    } else {
                                        phi_3041_ = true;
                                        break;
                                    }
                                    let _e496 = local_4[_e489];
                                    if _e490 {
                                    } else {
                                        phi_3041_ = true;
                                        break;
                                    }
                                    let _e498 = local_3[_e489];
                                    if _e490 {
                                    } else {
                                        phi_3041_ = true;
                                        break;
                                    }
                                    let _e501 = local_2[_e489];
                                    if _e490 {
                                    } else {
                                        phi_3041_ = true;
                                        break;
                                    }
                                    let _e503 = local_1[_e489];
                                    if _e490 {
                                    } else {
                                        phi_3041_ = true;
                                        break;
                                    }
                                    let _e505 = local[_e489];
                                    if _e490 {
                                    } else {
                                        phi_3041_ = true;
                                        break;
                                    }
                                    let _e510 = local_7[_e489];
                                    phi_875_ = type_48(type_46(array<f32, 3>(_e494, _e496, _e498), array<f32, 3>(_e501, _e503, _e505)), _e492);
                                    phi_876_ = (_e510 <= _e475.member);
                                    phi_877_ = _e488;
                                }
                                let _e514 = phi_875_;
                                let _e516 = phi_876_;
                                let _e518 = phi_877_;
                                if _e516 {
                                    if ((_e514.member_1 & 2147483648u) != 0u) {
                                        phi_895_ = _e475;
                                        phi_898_ = type_7(0u, ((_e514.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e870 = phi_895_;
                                            let _e872 = phi_898_;
                                            local_10 = _e870;
                                            local_12 = _e870;
                                            if (_e872.member < _e872.member_1) {
                                                phi_899_ = type_7((_e872.member + 1u), _e872.member_1);
                                                phi_921_ = type_7(1u, _e872.member);
                                            } else {
                                                phi_899_ = _e872;
                                                phi_921_ = type_7(0u, type_7().member_1);
                                            }
                                            let _e885 = phi_899_;
                                            let _e887 = phi_921_;
                                            let _e891 = (bitcast<i32>(_e887.member) != 0i);
                                            if _e891 {
                                                let _e892 = ((_e514.member_1 & 268435455u) + _e887.member_1);
                                                let _e893 = (_e892 < _e81);
                                                if _e893 {
                                                    if _e893 {
                                                    } else {
                                                        phi_2902_ = true;
                                                        break;
                                                    }
                                                    let _e897 = global_2.member[_e892].member_1;
                                                    phi_942_ = _e897;
                                                } else {
                                                    phi_942_ = 4294967295u;
                                                }
                                                let _e899 = phi_942_;
                                                if (_e892 >= _e81) {
                                                    phi_1031_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                } else {
                                                    if _e893 {
                                                    } else {
                                                        phi_2902_ = true;
                                                        break;
                                                    }
                                                    if (_e446 < 9u) {
                                                    } else {
                                                        phi_2902_ = true;
                                                        break;
                                                    }
                                                    let _e906 = global_2.member[_e892].member[_e446];
                                                    if (_e450 < 9u) {
                                                    } else {
                                                        phi_2902_ = true;
                                                        break;
                                                    }
                                                    let _e912 = global_2.member[_e892].member[_e450];
                                                    if (_e454 < 9u) {
                                                    } else {
                                                        phi_2902_ = true;
                                                        break;
                                                    }
                                                    let _e918 = global_2.member[_e892].member[_e454];
                                                    let _e920 = (3u + _e446);
                                                    if (_e920 < 9u) {
                                                    } else {
                                                        phi_2902_ = true;
                                                        break;
                                                    }
                                                    let _e926 = global_2.member[_e892].member[_e920];
                                                    let _e927 = (3u + _e450);
                                                    if (_e927 < 9u) {
                                                    } else {
                                                        phi_2902_ = true;
                                                        break;
                                                    }
                                                    let _e933 = global_2.member[_e892].member[_e927];
                                                    let _e934 = (3u + _e454);
                                                    if (_e934 < 9u) {
                                                    } else {
                                                        phi_2902_ = true;
                                                        break;
                                                    }
                                                    let _e940 = global_2.member[_e892].member[_e934];
                                                    let _e942 = (6u + _e446);
                                                    if (_e942 < 9u) {
                                                    } else {
                                                        phi_2902_ = true;
                                                        break;
                                                    }
                                                    let _e948 = global_2.member[_e892].member[_e942];
                                                    let _e949 = (6u + _e450);
                                                    if (_e949 < 9u) {
                                                    } else {
                                                        phi_2902_ = true;
                                                        break;
                                                    }
                                                    let _e955 = global_2.member[_e892].member[_e949];
                                                    let _e956 = (6u + _e454);
                                                    if (_e956 < 9u) {
                                                    } else {
                                                        phi_2902_ = true;
                                                        break;
                                                    }
                                                    let _e962 = global_2.member[_e892].member[_e956];
                                                    phi_1031_ = array<array<f32, 3>, 3>(array<f32, 3>(_e906, _e912, _e918), array<f32, 3>(_e926, _e933, _e940), array<f32, 3>(_e948, _e955, _e962));
                                                }
                                                let _e966 = phi_1031_;
                                                let _e974 = (_e966[0][2] - _e367);
                                                let _e977 = (((_e966[0][0] - _e290) * _e391) - (_e974 * _e315));
                                                let _e980 = (((_e966[0][1] - _e329) * _e391) - (_e974 * _e353));
                                                let _e987 = (_e966[1][2] - _e367);
                                                let _e990 = (((_e966[1][0] - _e290) * _e391) - (_e987 * _e315));
                                                let _e993 = (((_e966[1][1] - _e329) * _e391) - (_e987 * _e353));
                                                let _e1000 = (_e966[2][2] - _e367);
                                                let _e1003 = (((_e966[2][0] - _e290) * _e391) - (_e1000 * _e315));
                                                let _e1006 = (((_e966[2][1] - _e329) * _e391) - (_e1000 * _e353));
                                                let _e1007 = (_e1003 * _e993);
                                                let _e1008 = (_e1006 * _e990);
                                                let _e1009 = (_e977 * _e1006);
                                                let _e1010 = (_e980 * _e1003);
                                                let _e1011 = (_e990 * _e980);
                                                let _e1012 = (_e993 * _e977);
                                                let _e1017 = (((_e1007 >= _e1008) && (_e1009 >= _e1010)) && (_e1011 >= _e1012));
                                                if (_e1017 || (((_e1007 <= _e1008) && (_e1009 <= _e1010)) && (_e1011 <= _e1012))) {
                                                    let _e1024 = select(-1f, 1f, _e1017);
                                                    let _e1026 = ((_e1007 - _e1008) * _e1024);
                                                    let _e1028 = select(0f, _e1026, (_e1026 > 0f));
                                                    let _e1030 = ((_e1009 - _e1010) * _e1024);
                                                    let _e1032 = select(0f, _e1030, (_e1030 > 0f));
                                                    let _e1034 = ((_e1011 - _e1012) * _e1024);
                                                    let _e1036 = select(0f, _e1034, (_e1034 > 0f));
                                                    let _e1038 = ((_e1028 + _e1032) + _e1036);
                                                    if (_e1038 < 0.000000000000000000000000000000000000011754944f) {
                                                        phi_1859_ = type_25();
                                                        phi_1860_ = true;
                                                        phi_1861_ = false;
                                                    } else {
                                                        let _e1041 = select(_e990, _e977, (_e977 < _e990));
                                                        if (select(_e1003, _e1041, (_e1041 < _e1003)) > 0f) {
                                                            phi_1148_ = true;
                                                        } else {
                                                            let _e1046 = select(_e990, _e977, (_e977 > _e990));
                                                            phi_1148_ = (select(_e1003, _e1046, (_e1046 > _e1003)) < 0f);
                                                        }
                                                        let _e1051 = phi_1148_;
                                                        if _e1051 {
                                                            phi_1856_ = type_25();
                                                            phi_1857_ = true;
                                                            phi_1858_ = false;
                                                        } else {
                                                            let _e1053 = select(_e993, _e980, (_e980 < _e993));
                                                            if (select(_e1006, _e1053, (_e1053 < _e1006)) > 0f) {
                                                                phi_1177_ = true;
                                                            } else {
                                                                let _e1058 = select(_e993, _e980, (_e980 > _e993));
                                                                phi_1177_ = (select(_e1006, _e1058, (_e1058 > _e1006)) < 0f);
                                                            }
                                                            let _e1063 = phi_1177_;
                                                            if _e1063 {
                                                                phi_1854_ = type_25();
                                                                phi_1855_ = false;
                                                            } else {
                                                                let _e1065 = select(_e966[1][0], _e966[0][0], (_e966[0][0] < _e966[1][0]));
                                                                let _e1069 = select(_e966[1][0], _e966[0][0], (_e966[0][0] > _e966[1][0]));
                                                                let _e1073 = select(_e966[1][1], _e966[0][1], (_e966[0][1] < _e966[1][1]));
                                                                let _e1077 = select(_e966[1][1], _e966[0][1], (_e966[0][1] > _e966[1][1]));
                                                                let _e1081 = select(_e966[1][2], _e966[0][2], (_e966[0][2] < _e966[1][2]));
                                                                let _e1085 = select(_e966[1][2], _e966[0][2], (_e966[0][2] > _e966[1][2]));
                                                                let _e1090 = ((select(_e966[2][0], _e1065, (_e1065 < _e966[2][0])) - _e313) * _e318);
                                                                let _e1091 = ((select(_e966[2][0], _e1069, (_e1069 > _e966[2][0])) - _e314) * _e318);
                                                                let _e1094 = ((select(_e966[2][1], _e1073, (_e1073 < _e966[2][1])) - _e351) * _e356);
                                                                let _e1095 = ((select(_e966[2][1], _e1077, (_e1077 > _e966[2][1])) - _e352) * _e356);
                                                                let _e1098 = ((select(_e966[2][2], _e1081, (_e1081 < _e966[2][2])) - _e389) * _e394);
                                                                let _e1099 = ((select(_e966[2][2], _e1085, (_e1085 > _e966[2][2])) - _e390) * _e394);
                                                                let _e1101 = select(_e1099, _e1098, (_e1098 < _e1099));
                                                                let _e1103 = select(_e1099, _e1098, (_e1098 > _e1099));
                                                                let _e1105 = select(_e1091, _e1090, (_e1090 < _e1091));
                                                                let _e1107 = select(_e1095, _e1094, (_e1094 < _e1095));
                                                                let _e1109 = select(_e1107, _e1105, (_e1105 > _e1107));
                                                                let _e1111 = select(_e1101, _e1109, (_e1109 > _e1101));
                                                                let _e1113 = select(_e1091, _e1090, (_e1090 > _e1091));
                                                                let _e1115 = select(_e1095, _e1094, (_e1094 > _e1095));
                                                                let _e1117 = select(_e1115, _e1113, (_e1113 < _e1115));
                                                                let _e1119 = select(_e1103, _e1117, (_e1117 < _e1103));
                                                                let _e1120 = -(_e1101);
                                                                let _e1126 = select(_e441, _e1111, (_e1111 > _e441));
                                                                if (_e1126 > (_e1119 + (select(_e1120, _e1103, (_e1103 > _e1120)) * 0.0000019073523f))) {
                                                                    phi_1849_ = type_25();
                                                                    phi_1850_ = true;
                                                                } else {
                                                                    let _e1128 = (_e1126 > _e870.member);
                                                                    if _e1128 {
                                                                        phi_1848_ = type_25();
                                                                    } else {
                                                                        let _e1129 = vec3<f32>(_e966[0][0], _e966[0][1], _e966[0][2]);
                                                                        let _e1130 = vec3<f32>(_e966[1][0], _e966[1][1], _e966[1][2]);
                                                                        let _e1131 = vec3<f32>(_e966[2][0], _e966[2][1], _e966[2][2]);
                                                                        let _e1132 = (_e966[1][0] - _e966[0][0]);
                                                                        let _e1133 = (_e966[1][1] - _e966[0][1]);
                                                                        let _e1134 = (_e966[1][2] - _e966[0][2]);
                                                                        let _e1135 = vec3<f32>(_e1132, _e1133, _e1134);
                                                                        let _e1136 = (_e966[2][0] - _e966[1][0]);
                                                                        let _e1137 = (_e966[2][1] - _e966[1][1]);
                                                                        let _e1138 = (_e966[2][2] - _e966[1][2]);
                                                                        let _e1139 = vec3<f32>(_e1136, _e1137, _e1138);
                                                                        let _e1140 = (_e966[0][0] - _e966[2][0]);
                                                                        let _e1141 = (_e966[0][1] - _e966[2][1]);
                                                                        let _e1142 = (_e966[0][2] - _e966[2][2]);
                                                                        let _e1143 = vec3<f32>(_e1140, _e1141, _e1142);
                                                                        let _e1146 = bitcast<f32>((bitcast<u32>(_e1132) & 2147483647u));
                                                                        let _e1149 = bitcast<f32>((bitcast<u32>(_e1133) & 2147483647u));
                                                                        let _e1151 = select(_e1149, _e1146, (_e1146 > _e1149));
                                                                        let _e1154 = bitcast<f32>((bitcast<u32>(_e1134) & 2147483647u));
                                                                        let _e1156 = select(_e1154, _e1151, (_e1151 > _e1154));
                                                                        let _e1159 = bitcast<f32>((bitcast<u32>(_e1136) & 2147483647u));
                                                                        let _e1162 = bitcast<f32>((bitcast<u32>(_e1137) & 2147483647u));
                                                                        let _e1164 = select(_e1162, _e1159, (_e1159 > _e1162));
                                                                        let _e1167 = bitcast<f32>((bitcast<u32>(_e1138) & 2147483647u));
                                                                        let _e1169 = select(_e1167, _e1164, (_e1164 > _e1167));
                                                                        let _e1172 = bitcast<f32>((bitcast<u32>(_e1140) & 2147483647u));
                                                                        let _e1175 = bitcast<f32>((bitcast<u32>(_e1141) & 2147483647u));
                                                                        let _e1177 = select(_e1175, _e1172, (_e1172 > _e1175));
                                                                        let _e1180 = bitcast<f32>((bitcast<u32>(_e1142) & 2147483647u));
                                                                        let _e1182 = select(_e1180, _e1177, (_e1177 > _e1180));
                                                                        let _e1184 = select(_e1169, _e1156, (_e1156 > _e1169));
                                                                        let _e1186 = select(_e1182, _e1184, (_e1184 > _e1182));
                                                                        if (_e1156 == _e1186) {
                                                                            phi_1578_ = _e993;
                                                                            phi_1579_ = _e990;
                                                                            phi_1580_ = _e980;
                                                                            phi_1581_ = _e977;
                                                                            phi_1582_ = _e1129;
                                                                            phi_1583_ = _e1143;
                                                                            phi_1584_ = _e1139;
                                                                            phi_1585_ = _e1135;
                                                                        } else {
                                                                            let _e1188 = (_e1169 == _e1186);
                                                                            let _e1193 = vec3(_e1188);
                                                                            phi_1578_ = select(_e980, _e1006, _e1188);
                                                                            phi_1579_ = select(_e977, _e1003, _e1188);
                                                                            phi_1580_ = select(_e1006, _e993, _e1188);
                                                                            phi_1581_ = select(_e1003, _e990, _e1188);
                                                                            phi_1582_ = select(_e1131, _e1130, _e1193);
                                                                            phi_1583_ = select(_e1139, _e1135, _e1193);
                                                                            phi_1584_ = select(_e1135, _e1143, _e1193);
                                                                            phi_1585_ = select(_e1143, _e1139, _e1193);
                                                                        }
                                                                        let _e1199 = phi_1578_;
                                                                        let _e1201 = phi_1579_;
                                                                        let _e1203 = phi_1580_;
                                                                        let _e1205 = phi_1581_;
                                                                        let _e1207 = phi_1582_;
                                                                        let _e1209 = phi_1583_;
                                                                        let _e1211 = phi_1584_;
                                                                        let _e1213 = phi_1585_;
                                                                        let _e1220 = ((_e1211.y * _e1209.z) - (_e1209.y * _e1211.z));
                                                                        let _e1225 = ((_e1211.z * _e1209.x) - (_e1209.z * _e1211.x));
                                                                        let _e1228 = ((_e1211.x * _e1209.y) - (_e1209.x * _e1211.y));
                                                                        if (_e1028 >= _e1032) {
                                                                            phi_1616_ = select(true, false, (_e1028 >= _e1036));
                                                                        } else {
                                                                            phi_1616_ = true;
                                                                        }
                                                                        let _e1233 = phi_1616_;
                                                                        if _e1233 {
                                                                            phi_1625_ = select(_e1131, _e1130, vec3((_e1032 >= _e1036)));
                                                                        } else {
                                                                            phi_1625_ = _e1129;
                                                                        }
                                                                        let _e1238 = phi_1625_;
                                                                        let _e1243 = (((_e1220 * _e315) + (_e1225 * _e353)) + (_e1228 * _e391));
                                                                        let _e1254 = (((_e1220 * (_e1238.x - _e290)) + (_e1225 * (_e1238.y - _e329))) + (_e1228 * (_e1238.z - _e367)));
                                                                        let _e1256 = (_e1201 - _e1205);
                                                                        let _e1257 = (_e1199 - _e1203);
                                                                        let _e1265 = (-(((_e1205 * _e1256) + (_e1203 * _e1257))) / ((_e1256 * _e1256) + (_e1257 * _e1257)));
                                                                        let _e1267 = select(1f, _e1265, (_e1265 < 1f));
                                                                        let _e1269 = select(0f, _e1267, (_e1267 > 0f));
                                                                        let _e1282 = ((_e1207.x + (_e1213.x * _e1269)) - _e290);
                                                                        let _e1283 = ((_e1207.y + (_e1213.y * _e1269)) - _e329);
                                                                        let _e1284 = ((_e1207.z + (_e1213.z * _e1269)) - _e367);
                                                                        let _e1285 = (_e1284 / _e391);
                                                                        let _e1297 = bitcast<f32>((bitcast<u32>(_e1282) & 2147483647u));
                                                                        let _e1300 = bitcast<f32>((bitcast<u32>(_e1283) & 2147483647u));
                                                                        let _e1302 = select(_e1300, _e1297, (_e1297 > _e1300));
                                                                        let _e1305 = bitcast<f32>((bitcast<u32>(_e1284) & 2147483647u));
                                                                        let _e1307 = select(_e1305, _e1302, (_e1302 > _e1305));
                                                                        let _e1313 = bitcast<f32>((bitcast<u32>(_e1220) & 2147483647u));
                                                                        let _e1316 = bitcast<f32>((bitcast<u32>(_e1225) & 2147483647u));
                                                                        let _e1318 = select(_e1316, _e1313, (_e1313 > _e1316));
                                                                        let _e1321 = bitcast<f32>((bitcast<u32>(_e1228) & 2147483647u));
                                                                        if (bitcast<f32>((bitcast<u32>(((((_e1220 * _e1282) + (_e1225 * _e1283)) + (_e1228 * _e1284)) - _e1254)) & 2147483647u)) <= ((0.0000009536743f * select(_e1186, _e1307, (_e1307 > _e1186))) * select(_e1321, _e1318, (_e1318 > _e1321)))) {
                                                                            let _e1331 = bitcast<f32>((bitcast<u32>(_e1211.x) & 2147483647u));
                                                                            let _e1334 = bitcast<f32>((bitcast<u32>(_e1211.y) & 2147483647u));
                                                                            let _e1336 = select(_e1334, _e1331, (_e1331 > _e1334));
                                                                            let _e1339 = bitcast<f32>((bitcast<u32>(_e1211.z) & 2147483647u));
                                                                            let _e1345 = bitcast<f32>((bitcast<u32>(_e1209.x) & 2147483647u));
                                                                            let _e1348 = bitcast<f32>((bitcast<u32>(_e1209.y) & 2147483647u));
                                                                            let _e1350 = select(_e1348, _e1345, (_e1345 > _e1348));
                                                                            let _e1353 = bitcast<f32>((bitcast<u32>(_e1209.z) & 2147483647u));
                                                                            phi_1792_ = select(true, false, (bitcast<f32>((bitcast<u32>(_e1243) & 2147483647u)) > ((0.0000038146973f * select(_e1339, _e1336, (_e1336 > _e1339))) * select(_e1353, _e1350, (_e1350 > _e1353)))));
                                                                        } else {
                                                                            phi_1792_ = true;
                                                                        }
                                                                        let _e1360 = phi_1792_;
                                                                        if _e1360 {
                                                                            let _e1371 = ((((_e1220 * (_e1282 - (_e315 * _e1285))) + (_e1225 * (_e1283 - (_e353 * _e1285)))) + (_e1228 * (_e1284 - _e1284))) / _e1243);
                                                                            if (bitcast<f32>((bitcast<u32>(_e1371) & 2147483647u)) <= _e1186) {
                                                                                phi_1816_ = (_e1285 + _e1371);
                                                                            } else {
                                                                                phi_1816_ = _e1285;
                                                                            }
                                                                            let _e1378 = phi_1816_;
                                                                            phi_1817_ = _e1378;
                                                                        } else {
                                                                            phi_1817_ = (_e1254 / _e1243);
                                                                        }
                                                                        let _e1380 = phi_1817_;
                                                                        let _e1382 = select(_e1119, _e1380, (_e1380 < _e1119));
                                                                        let _e1384 = select(_e1111, _e1382, (_e1382 > _e1111));
                                                                        if (_e1384 >= _e441) {
                                                                            let _e1386 = (_e1384 <= _e870.member);
                                                                            if _e1386 {
                                                                                let _e1387 = (1f / _e1038);
                                                                                phi_1840_ = type_25(_e1384, (_e1032 * _e1387), (_e1036 * _e1387), _e899);
                                                                            } else {
                                                                                phi_1840_ = type_25();
                                                                            }
                                                                            let _e1392 = phi_1840_;
                                                                            phi_1842_ = _e1392;
                                                                            phi_1843_ = select(true, false, _e1386);
                                                                        } else {
                                                                            phi_1842_ = type_25();
                                                                            phi_1843_ = true;
                                                                        }
                                                                        let _e1395 = phi_1842_;
                                                                        let _e1397 = phi_1843_;
                                                                        if _e1397 {
                                                                            phi_1847_ = type_25(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                        } else {
                                                                            phi_1847_ = _e1395;
                                                                        }
                                                                        let _e1399 = phi_1847_;
                                                                        phi_1848_ = _e1399;
                                                                    }
                                                                    let _e1401 = phi_1848_;
                                                                    phi_1849_ = _e1401;
                                                                    phi_1850_ = _e1128;
                                                                }
                                                                let _e1403 = phi_1849_;
                                                                let _e1405 = phi_1850_;
                                                                phi_1854_ = _e1403;
                                                                phi_1855_ = _e1405;
                                                            }
                                                            let _e1407 = phi_1854_;
                                                            let _e1409 = phi_1855_;
                                                            phi_1856_ = _e1407;
                                                            phi_1857_ = _e1063;
                                                            phi_1858_ = _e1409;
                                                        }
                                                        let _e1411 = phi_1856_;
                                                        let _e1413 = phi_1857_;
                                                        let _e1415 = phi_1858_;
                                                        phi_1859_ = _e1411;
                                                        phi_1860_ = _e1413;
                                                        phi_1861_ = _e1415;
                                                    }
                                                    let _e1417 = phi_1859_;
                                                    let _e1419 = phi_1860_;
                                                    let _e1421 = phi_1861_;
                                                    phi_1869_ = _e1417;
                                                    phi_1870_ = select(_e1421, true, _e1419);
                                                } else {
                                                    phi_1869_ = type_25();
                                                    phi_1870_ = true;
                                                }
                                                let _e1424 = phi_1869_;
                                                let _e1426 = phi_1870_;
                                                if _e1426 {
                                                    phi_1874_ = type_25(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                } else {
                                                    phi_1874_ = _e1424;
                                                }
                                                let _e1428 = phi_1874_;
                                                if (_e1428.member_3 != 4294967295u) {
                                                    if (_e899 != 4294967295u) {
                                                        phi_1885_ = type_37(_e870.member, true);
                                                    } else {
                                                        phi_1885_ = _e870;
                                                    }
                                                    let _e1436 = phi_1885_;
                                                    phi_1886_ = _e1436;
                                                } else {
                                                    phi_1886_ = _e870;
                                                }
                                                let _e1438 = phi_1886_;
                                                phi_896_ = _e1438;
                                            } else {
                                                phi_896_ = type_37();
                                            }
                                            let _e1440 = phi_896_;
                                            continue;
                                            continuing {
                                                phi_895_ = _e1440;
                                                phi_898_ = _e885;
                                                phi_2902_ = _e473;
                                                break if !(_e891);
                                            }
                                        }
                                        let _e1443 = phi_2902_;
                                        phi_3041_ = _e1443;
                                        if _e1443 {
                                            break;
                                        }
                                        let _e1445 = local_10;
                                        phi_3045_ = _e1443;
                                        let _e1602 = local_12;
                                        phi_2836_ = _e1602;
                                        phi_2837_ = _e514;
                                        phi_2838_ = false;
                                        phi_2839_ = select(_e518, 0u, _e1445.member_1);
                                    } else {
                                        let _e527 = (_e514.member_1 < _e79);
                                        if _e527 {
                                            if _e527 {
                                            } else {
                                                phi_3041_ = true;
                                                break;
                                            }
                                            let _e529 = global_6.member[_e514.member_1];
                                            phi_1906_ = _e529;
                                        } else {
                                            phi_1906_ = type_41(array<u32, 2>(0u, 0u), array<u32, 2>(0u, 0u), 2147483648u, 2147483648u);
                                        }
                                        let _e531 = phi_1906_;
                                        let _e546 = ((10u * _e241) & 31u);
                                        let _e549 = ((_e531.member[0] >> bitcast<u32>(_e546)) & 1023u);
                                        let _e554 = bitcast<f32>((bitcast<u32>(((_e514.member.member_1[0] - _e514.member.member[0]) * 0.0009775171f)) ^ _e113));
                                        let _e560 = (_e514.member.member[0] + bitcast<f32>((bitcast<u32>((f32(_e549) * _e554)) ^ _e113)));
                                        let _e564 = select(select(_e514.member.member_1[0], _e560, (_e560 < _e514.member.member_1[0])), _e514.member.member_1[0], (_e549 == 1023u));
                                        let _e566 = ((10u * _e240) & 31u);
                                        let _e569 = ((_e531.member[0] >> bitcast<u32>(_e566)) & 1023u);
                                        let _e574 = bitcast<f32>((bitcast<u32>(((_e514.member.member_1[1] - _e514.member.member[1]) * 0.0009775171f)) ^ _e113));
                                        let _e580 = (_e514.member.member[1] + bitcast<f32>((bitcast<u32>((f32(_e569) * _e574)) ^ _e113)));
                                        let _e584 = select(select(_e514.member.member_1[1], _e580, (_e580 < _e514.member.member_1[1])), _e514.member.member_1[1], (_e569 == 1023u));
                                        let _e586 = ((10u * _e242) & 31u);
                                        let _e589 = ((_e531.member[0] >> bitcast<u32>(_e586)) & 1023u);
                                        let _e594 = bitcast<f32>((bitcast<u32>(((_e514.member.member_1[2] - _e514.member.member[2]) * 0.0009775171f)) ^ _e113));
                                        let _e600 = (_e514.member.member[2] + bitcast<f32>((bitcast<u32>((f32(_e589) * _e594)) ^ _e113)));
                                        let _e604 = select(select(_e514.member.member_1[2], _e600, (_e600 < _e514.member.member_1[2])), _e514.member.member_1[2], (_e589 == 1023u));
                                        let _e607 = ((_e531.member[1] >> bitcast<u32>(_e546)) & 1023u);
                                        let _e613 = (_e514.member.member[0] + bitcast<f32>((bitcast<u32>((f32(_e607) * _e554)) ^ _e113)));
                                        let _e617 = select(select(_e514.member.member_1[0], _e613, (_e613 < _e514.member.member_1[0])), _e514.member.member_1[0], (_e607 == 1023u));
                                        let _e620 = ((_e531.member[1] >> bitcast<u32>(_e566)) & 1023u);
                                        let _e626 = (_e514.member.member[1] + bitcast<f32>((bitcast<u32>((f32(_e620) * _e574)) ^ _e113)));
                                        let _e630 = select(select(_e514.member.member_1[1], _e626, (_e626 < _e514.member.member_1[1])), _e514.member.member_1[1], (_e620 == 1023u));
                                        let _e633 = ((_e531.member[1] >> bitcast<u32>(_e586)) & 1023u);
                                        let _e639 = (_e514.member.member[2] + bitcast<f32>((bitcast<u32>((f32(_e633) * _e594)) ^ _e113)));
                                        let _e643 = select(select(_e514.member.member_1[2], _e639, (_e639 < _e514.member.member_1[2])), _e514.member.member_1[2], (_e633 == 1023u));
                                        let _e649 = ((_e531.member_1[0] >> bitcast<u32>(_e546)) & 1023u);
                                        let _e655 = (_e514.member.member[0] + bitcast<f32>((bitcast<u32>((f32(_e649) * _e554)) ^ _e113)));
                                        let _e659 = select(select(_e514.member.member_1[0], _e655, (_e655 < _e514.member.member_1[0])), _e514.member.member_1[0], (_e649 == 1023u));
                                        let _e662 = ((_e531.member_1[0] >> bitcast<u32>(_e566)) & 1023u);
                                        let _e668 = (_e514.member.member[1] + bitcast<f32>((bitcast<u32>((f32(_e662) * _e574)) ^ _e113)));
                                        let _e672 = select(select(_e514.member.member_1[1], _e668, (_e668 < _e514.member.member_1[1])), _e514.member.member_1[1], (_e662 == 1023u));
                                        let _e675 = ((_e531.member_1[0] >> bitcast<u32>(_e586)) & 1023u);
                                        let _e681 = (_e514.member.member[2] + bitcast<f32>((bitcast<u32>((f32(_e675) * _e594)) ^ _e113)));
                                        let _e685 = select(select(_e514.member.member_1[2], _e681, (_e681 < _e514.member.member_1[2])), _e514.member.member_1[2], (_e675 == 1023u));
                                        let _e688 = ((_e531.member_1[1] >> bitcast<u32>(_e546)) & 1023u);
                                        let _e694 = (_e514.member.member[0] + bitcast<f32>((bitcast<u32>((f32(_e688) * _e554)) ^ _e113)));
                                        let _e698 = select(select(_e514.member.member_1[0], _e694, (_e694 < _e514.member.member_1[0])), _e514.member.member_1[0], (_e688 == 1023u));
                                        let _e701 = ((_e531.member_1[1] >> bitcast<u32>(_e566)) & 1023u);
                                        let _e707 = (_e514.member.member[1] + bitcast<f32>((bitcast<u32>((f32(_e701) * _e574)) ^ _e113)));
                                        let _e711 = select(select(_e514.member.member_1[1], _e707, (_e707 < _e514.member.member_1[1])), _e514.member.member_1[1], (_e701 == 1023u));
                                        let _e714 = ((_e531.member_1[1] >> bitcast<u32>(_e586)) & 1023u);
                                        let _e720 = (_e514.member.member[2] + bitcast<f32>((bitcast<u32>((f32(_e714) * _e594)) ^ _e113)));
                                        let _e724 = select(select(_e514.member.member_1[2], _e720, (_e720 < _e514.member.member_1[2])), _e514.member.member_1[2], (_e714 == 1023u));
                                        let _e729 = type_48(type_46(array<f32, 3>(_e564, _e584, _e604), array<f32, 3>(_e617, _e630, _e643)), _e531.member_2);
                                        let _e734 = type_48(type_46(array<f32, 3>(_e659, _e672, _e685), array<f32, 3>(_e698, _e711, _e724)), _e531.member_3);
                                        let _e740 = ((_e564 - _e313) * _e318);
                                        let _e741 = ((_e659 - _e313) * _e318);
                                        let _e742 = ((_e617 - _e314) * _e318);
                                        let _e743 = ((_e698 - _e314) * _e318);
                                        let _e748 = ((_e584 - _e351) * _e356);
                                        let _e749 = ((_e672 - _e351) * _e356);
                                        let _e750 = ((_e630 - _e352) * _e356);
                                        let _e751 = ((_e711 - _e352) * _e356);
                                        let _e756 = ((_e604 - _e389) * _e394);
                                        let _e757 = ((_e685 - _e389) * _e394);
                                        let _e758 = ((_e643 - _e390) * _e394);
                                        let _e759 = ((_e724 - _e390) * _e394);
                                        let _e761 = select(_e758, _e756, (_e756 < _e758));
                                        let _e763 = select(_e759, _e757, (_e757 < _e759));
                                        let _e765 = select(_e758, _e756, (_e756 > _e758));
                                        let _e767 = select(_e759, _e757, (_e757 > _e759));
                                        let _e769 = select(_e742, _e740, (_e740 < _e742));
                                        let _e771 = select(_e743, _e741, (_e741 < _e743));
                                        let _e773 = select(_e750, _e748, (_e748 < _e750));
                                        let _e775 = select(_e751, _e749, (_e749 < _e751));
                                        let _e777 = select(_e773, _e769, (_e769 > _e773));
                                        let _e779 = select(_e775, _e771, (_e771 > _e775));
                                        let _e781 = select(_e761, _e777, (_e777 > _e761));
                                        let _e783 = select(_e763, _e779, (_e779 > _e763));
                                        let _e785 = select(_e742, _e740, (_e740 > _e742));
                                        let _e787 = select(_e743, _e741, (_e741 > _e743));
                                        let _e789 = select(_e750, _e748, (_e748 > _e750));
                                        let _e791 = select(_e751, _e749, (_e749 > _e751));
                                        let _e793 = select(_e789, _e785, (_e785 < _e789));
                                        let _e795 = select(_e791, _e787, (_e787 < _e791));
                                        let _e800 = -(_e761);
                                        let _e801 = -(_e763);
                                        let _e808 = (select(_e765, _e793, (_e793 < _e765)) + (select(_e800, _e765, (_e765 > _e800)) * 0.0000019073523f));
                                        let _e809 = (select(_e767, _e795, (_e795 < _e767)) + (select(_e801, _e767, (_e767 > _e801)) * 0.0000019073523f));
                                        let _e811 = select(_e441, _e781, (_e781 > _e441));
                                        let _e813 = select(_e441, _e783, (_e783 > _e441));
                                        let _e818 = (_e811 <= select(_e475.member, _e808, (_e808 < _e475.member)));
                                        let _e819 = (_e813 <= select(_e475.member, _e809, (_e809 < _e475.member)));
                                        let _e820 = (_e811 <= _e813);
                                        if _e818 {
                                            if _e819 {
                                                if _e820 {
                                                    phi_2738_ = _e734;
                                                } else {
                                                    phi_2738_ = _e729;
                                                }
                                                let _e822 = phi_2738_;
                                                let _e830 = (_e518 % 128u);
                                                let _e831 = (_e830 < 128u);
                                                if _e831 {
                                                } else {
                                                    phi_3041_ = true;
                                                    break;
                                                }
                                                local_6[_e830] = _e822.member_1;
                                                if _e831 {
                                                } else {
                                                    phi_3041_ = true;
                                                    break;
                                                }
                                                local_5[_e830] = _e822.member.member[0];
                                                if _e831 {
                                                } else {
                                                    phi_3041_ = true;
                                                    break;
                                                }
                                                local_4[_e830] = _e822.member.member[1];
                                                if _e831 {
                                                } else {
                                                    phi_3041_ = true;
                                                    break;
                                                }
                                                local_3[_e830] = _e822.member.member[2];
                                                if _e831 {
                                                } else {
                                                    phi_3041_ = true;
                                                    break;
                                                }
                                                local_2[_e830] = _e822.member.member_1[0];
                                                if _e831 {
                                                } else {
                                                    phi_3041_ = true;
                                                    break;
                                                }
                                                local_1[_e830] = _e822.member.member_1[1];
                                                if _e831 {
                                                } else {
                                                    phi_3041_ = true;
                                                    break;
                                                }
                                                local[_e830] = _e822.member.member_1[2];
                                                if _e831 {
                                                } else {
                                                    phi_3041_ = true;
                                                    break;
                                                }
                                                local_7[_e830] = select(_e813, _e811, (_e811 > _e813));
                                                if _e820 {
                                                    phi_2815_ = _e729;
                                                } else {
                                                    phi_2815_ = _e734;
                                                }
                                                let _e848 = phi_2815_;
                                                phi_2816_ = _e848;
                                                phi_2817_ = (_e518 + 1u);
                                            } else {
                                                phi_2816_ = type_48();
                                                phi_2817_ = u32();
                                            }
                                            let _e850 = phi_2816_;
                                            let _e852 = phi_2817_;
                                            phi_2819_ = _e850;
                                            phi_2820_ = _e852;
                                            phi_2821_ = select(true, false, _e819);
                                        } else {
                                            phi_2819_ = type_48();
                                            phi_2820_ = u32();
                                            phi_2821_ = true;
                                        }
                                        let _e855 = phi_2819_;
                                        let _e857 = phi_2820_;
                                        let _e859 = phi_2821_;
                                        if _e859 {
                                            if _e818 {
                                                phi_2828_ = _e729;
                                            } else {
                                                phi_2828_ = _e734;
                                            }
                                            let _e861 = phi_2828_;
                                            phi_2833_ = _e861;
                                            phi_2834_ = select(_e819, true, _e818);
                                        } else {
                                            phi_2833_ = _e855;
                                            phi_2834_ = _e516;
                                        }
                                        let _e864 = phi_2833_;
                                        let _e866 = phi_2834_;
                                        phi_3045_ = _e473;
                                        phi_2836_ = _e475;
                                        phi_2837_ = _e864;
                                        phi_2838_ = _e866;
                                        phi_2839_ = select(_e857, _e518, _e859);
                                    }
                                    let _e1449 = phi_3045_;
                                    let _e1451 = phi_2836_;
                                    let _e1453 = phi_2837_;
                                    let _e1455 = phi_2838_;
                                    let _e1457 = phi_2839_;
                                    phi_3044_ = _e1449;
                                    phi_2840_ = _e1451;
                                    phi_2841_ = _e1453;
                                    phi_2842_ = (_e479 - 1u);
                                    phi_2843_ = _e1455;
                                    phi_2844_ = _e1457;
                                } else {
                                    phi_3044_ = _e473;
                                    phi_2840_ = _e475;
                                    phi_2841_ = _e514;
                                    phi_2842_ = _e479;
                                    phi_2843_ = _e516;
                                    phi_2844_ = _e518;
                                }
                                let _e1459 = phi_3044_;
                                let _e1461 = phi_2840_;
                                let _e1463 = phi_2841_;
                                let _e1465 = phi_2842_;
                                let _e1467 = phi_2843_;
                                let _e1469 = phi_2844_;
                                phi_3043_ = _e1459;
                                phi_2845_ = _e1461;
                                phi_2846_ = _e1463;
                                phi_2847_ = _e1465;
                                phi_2848_ = _e1467;
                                phi_2849_ = _e1469;
                            } else {
                                phi_3043_ = _e473;
                                phi_2845_ = type_37();
                                phi_2846_ = type_48();
                                phi_2847_ = u32();
                                phi_2848_ = bool();
                                phi_2849_ = u32();
                            }
                            let _e1471 = phi_3043_;
                            let _e1473 = phi_2845_;
                            let _e1475 = phi_2846_;
                            let _e1477 = phi_2847_;
                            let _e1479 = phi_2848_;
                            let _e1481 = phi_2849_;
                            phi_3042_ = _e1471;
                            phi_770_ = _e1473;
                            phi_773_ = _e1475;
                            phi_775_ = _e1477;
                            phi_777_ = _e1479;
                            phi_779_ = _e1481;
                            phi_2850_ = _e487;
                        } else {
                            phi_3042_ = _e473;
                            phi_770_ = type_37();
                            phi_773_ = type_48();
                            phi_775_ = u32();
                            phi_777_ = bool();
                            phi_779_ = u32();
                            phi_2850_ = false;
                        }
                        let _e1483 = phi_3042_;
                        let _e1485 = phi_770_;
                        let _e1487 = phi_773_;
                        let _e1489 = phi_775_;
                        let _e1491 = phi_777_;
                        let _e1493 = phi_779_;
                        let _e1495 = phi_2850_;
                        continue;
                        continuing {
                            phi_2908_ = _e1483;
                            phi_769_ = _e1485;
                            phi_772_ = _e1487;
                            phi_774_ = _e1489;
                            phi_776_ = _e1491;
                            phi_778_ = _e1493;
                            phi_3041_ = _e1483;
                            break if !(_e1495);
                        }
                    }
                    let _e1498 = phi_3041_;
                    if _e1498 {
                        break;
                    }
                    let _e1500 = local_11;
                    if _e129 {
                    } else {
                        break;
                    }
                    global_5.member[_e127] = select(0u, 1u, _e1500.member_1);
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn trace_any_printed_f32_(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
