struct type_4 {
    member: u32,
    member_1: u32,
}

struct type_8 {
    member: vec4<u32>,
}

struct type_13 {
    member: array<f32, 9>,
    member_1: u32,
}

struct type_15 {
    member: array<type_13>,
}

struct type_21 {
    member: array<array<u32, 2>>,
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

struct type_32 {
    member: type_25,
    member_1: f32,
}

struct type_36 {
    member: array<type_26>,
}

struct type_38 {
    member: type_32,
    member_1: u32,
    member_2: u32,
}

struct type_40 {
    member: array<vec4<u32>, 2>,
}

struct type_42 {
    member: array<u32, 2>,
    member_1: array<u32, 2>,
    member_2: u32,
    member_3: u32,
}

struct type_44 {
    member: array<type_42>,
}

struct type_47 {
    member: array<f32, 3>,
    member_1: array<f32, 3>,
}

struct type_49 {
    member: type_47,
    member_1: u32,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_1: type_8;
@group(0) @binding(3) 
var<storage> global_2: type_15;
@group(0) @binding(1) 
var<uniform> global_3: type_40;
@group(0) @binding(4) 
var<storage> global_4: type_36;
@group(0) @binding(2) 
var<storage> global_5: type_44;
@group(0) @binding(5) 
var<storage, read_write> global_6: type_21;

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
    var phi_329_: i32;
    var phi_330_: i32;
    var phi_340_: bool;
    var phi_350_: u32;
    var phi_351_: u32;
    var phi_353_: bool;
    var phi_358_: u32;
    var phi_370_: i32;
    var phi_390_: i32;
    var phi_408_: f32;
    var phi_414_: f32;
    var phi_425_: f32;
    var phi_431_: f32;
    var phi_454_: f32;
    var phi_465_: f32;
    var phi_474_: f32;
    var phi_480_: f32;
    var phi_491_: f32;
    var phi_497_: f32;
    var phi_520_: f32;
    var phi_531_: f32;
    var phi_540_: f32;
    var phi_546_: f32;
    var phi_557_: f32;
    var phi_563_: f32;
    var phi_586_: f32;
    var phi_597_: f32;
    var phi_697_: f32;
    var phi_698_: f32;
    var phi_2941_: bool;
    var phi_772_: type_38;
    var phi_775_: type_49;
    var phi_777_: u32;
    var phi_779_: bool;
    var phi_781_: u32;
    var phi_792_: bool;
    var phi_878_: type_49;
    var phi_879_: bool;
    var phi_880_: u32;
    var phi_1937_: type_42;
    var phi_2769_: type_49;
    var phi_2846_: type_49;
    var phi_2847_: type_49;
    var phi_2848_: u32;
    var phi_2850_: type_49;
    var phi_2851_: u32;
    var phi_2852_: bool;
    var phi_2859_: type_49;
    var phi_2864_: type_49;
    var phi_2865_: bool;
    var phi_898_: type_38;
    var phi_901_: type_4;
    var phi_902_: type_4;
    var phi_924_: type_4;
    var phi_948_: u32;
    var phi_1037_: array<array<f32, 3>, 3>;
    var phi_1154_: bool;
    var phi_1183_: bool;
    var phi_1584_: f32;
    var phi_1585_: f32;
    var phi_1586_: f32;
    var phi_1587_: f32;
    var phi_1588_: vec3<f32>;
    var phi_1589_: vec3<f32>;
    var phi_1590_: vec3<f32>;
    var phi_1591_: vec3<f32>;
    var phi_1622_: bool;
    var phi_1631_: vec3<f32>;
    var phi_1798_: bool;
    var phi_1822_: f32;
    var phi_1823_: f32;
    var phi_1846_: type_25;
    var phi_1848_: type_25;
    var phi_1849_: bool;
    var phi_1853_: type_25;
    var phi_1854_: type_25;
    var phi_1855_: type_25;
    var phi_1856_: bool;
    var phi_1860_: type_25;
    var phi_1861_: bool;
    var phi_1862_: type_25;
    var phi_1863_: bool;
    var phi_1864_: bool;
    var phi_1865_: type_25;
    var phi_1866_: bool;
    var phi_1867_: bool;
    var phi_1875_: type_25;
    var phi_1876_: bool;
    var phi_1880_: type_25;
    var phi_1905_: bool;
    var phi_1906_: bool;
    var phi_1913_: type_38;
    var phi_1914_: type_38;
    var phi_1915_: type_38;
    var phi_899_: type_38;
    var phi_2935_: bool;
    var phi_3081_: bool;
    var phi_2867_: type_38;
    var phi_2868_: type_49;
    var phi_2869_: bool;
    var phi_2870_: u32;
    var phi_3080_: bool;
    var phi_2871_: type_38;
    var phi_2872_: type_49;
    var phi_2873_: u32;
    var phi_2874_: bool;
    var phi_2875_: u32;
    var phi_3079_: bool;
    var phi_2876_: type_38;
    var phi_2877_: type_49;
    var phi_2878_: u32;
    var phi_2879_: bool;
    var phi_2880_: u32;
    var phi_3078_: bool;
    var phi_773_: type_38;
    var phi_776_: type_49;
    var phi_778_: u32;
    var phi_780_: bool;
    var phi_782_: u32;
    var phi_2881_: bool;
    var phi_3077_: bool;
    var local_10: type_38;
    var local_11: type_38;
    var local_12: type_38;

    switch bitcast<i32>(0u) {
        default: {
            let _e76 = global;
            let _e79 = arrayLength((&global_5.member));
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
                let _e129 = (_e127 < arrayLength((&global_6.member)));
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
                            phi_329_ = (bitcast<i32>((_e206 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_329_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e206)), 32u, (_e206 == 0u))));
                        }
                        let _e220 = phi_329_;
                        phi_330_ = _e220;
                    } else {
                        phi_330_ = 0i;
                    }
                    let _e222 = phi_330_;
                    let _e223 = (_e139 == _e178);
                    if _e223 {
                        phi_340_ = true;
                    } else {
                        phi_340_ = (_e146 == _e178);
                    }
                    let _e226 = phi_340_;
                    let _e227 = select(1u, 0u, _e223);
                    if _e226 {
                        let _e228 = (_e227 + 1u);
                        phi_350_ = _e228;
                        phi_351_ = _e228;
                        phi_353_ = select(true, false, (_e228 == 2u));
                    } else {
                        phi_350_ = u32();
                        phi_351_ = 0u;
                        phi_353_ = true;
                    }
                    let _e232 = phi_350_;
                    let _e234 = phi_351_;
                    let _e236 = phi_353_;
                    if _e236 {
                        phi_358_ = (_e234 + 1u);
                    } else {
                        phi_358_ = 0u;
                    }
                    let _e240 = phi_358_;
                    let _e241 = select(_e232, _e234, _e236);
                    let _e242 = select(_e227, select(2u, _e227, _e226), _e236);
                    if (_e117 < -126i) {
                        phi_370_ = -126i;
                    } else {
                        phi_370_ = select(_e117, 127i, (_e117 > 127i));
                    }
                    let _e247 = phi_370_;
                    let _e252 = bitcast<f32>((bitcast<u32>((_e247 + 127i)) << bitcast<u32>(23i)));
                    let _e258 = bitcast<f32>((bitcast<u32>(((_e117 - _e247) + 127i)) << bitcast<u32>(23i)));
                    let _e259 = -(_e222);
                    if (_e259 < -126i) {
                        phi_390_ = -126i;
                    } else {
                        phi_390_ = select(_e259, 127i, (_e259 > 127i));
                    }
                    let _e264 = phi_390_;
                    let _e269 = bitcast<f32>((bitcast<u32>((_e264 + 127i)) << bitcast<u32>(23i)));
                    let _e275 = bitcast<f32>((bitcast<u32>(((_e259 - _e264) + 127i)) << bitcast<u32>(23i)));
                    let _e279 = global_4.member[_e127].member;
                    let _e280 = (_e241 == 0u);
                    if _e280 {
                        phi_408_ = _e279[0];
                    } else {
                        phi_408_ = _e279[1];
                    }
                    let _e284 = phi_408_;
                    let _e285 = (_e241 == 2u);
                    if _e285 {
                        phi_414_ = _e279[2];
                    } else {
                        phi_414_ = _e284;
                    }
                    let _e288 = phi_414_;
                    let _e290 = ((_e288 * _e252) * _e258);
                    let _e291 = global_4.member[_e127].member_2;
                    if _e280 {
                        phi_425_ = _e291[0];
                    } else {
                        phi_425_ = _e291[1];
                    }
                    let _e295 = phi_425_;
                    if _e285 {
                        phi_431_ = _e291[2];
                    } else {
                        phi_431_ = _e295;
                    }
                    let _e298 = phi_431_;
                    let _e300 = ((_e298 * _e269) * _e275);
                    let _e304 = (bitcast<f32>((bitcast<u32>(_e300) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e304 {
                        let _e308 = (bitcast<f32>((bitcast<u32>(_e290) & 2147483647u)) * 0.00000011920929f);
                        phi_454_ = select(0.00000000000011368684f, _e308, (_e308 > 0.00000000000011368684f));
                    } else {
                        phi_454_ = 0f;
                    }
                    let _e312 = phi_454_;
                    let _e313 = (_e290 + _e312);
                    let _e314 = (_e290 - _e312);
                    let _e315 = select(_e300, 0f, _e304);
                    if _e304 {
                        phi_465_ = 38685626000000000000000000f;
                    } else {
                        phi_465_ = (1f / _e300);
                    }
                    let _e318 = phi_465_;
                    let _e319 = (_e240 == 0u);
                    if _e319 {
                        phi_474_ = _e279[0];
                    } else {
                        phi_474_ = _e279[1];
                    }
                    let _e323 = phi_474_;
                    let _e324 = (_e240 == 2u);
                    if _e324 {
                        phi_480_ = _e279[2];
                    } else {
                        phi_480_ = _e323;
                    }
                    let _e327 = phi_480_;
                    let _e329 = ((_e327 * _e252) * _e258);
                    if _e319 {
                        phi_491_ = _e291[0];
                    } else {
                        phi_491_ = _e291[1];
                    }
                    let _e333 = phi_491_;
                    if _e324 {
                        phi_497_ = _e291[2];
                    } else {
                        phi_497_ = _e333;
                    }
                    let _e336 = phi_497_;
                    let _e338 = ((_e336 * _e269) * _e275);
                    let _e342 = (bitcast<f32>((bitcast<u32>(_e338) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e342 {
                        let _e346 = (bitcast<f32>((bitcast<u32>(_e329) & 2147483647u)) * 0.00000011920929f);
                        phi_520_ = select(0.00000000000011368684f, _e346, (_e346 > 0.00000000000011368684f));
                    } else {
                        phi_520_ = 0f;
                    }
                    let _e350 = phi_520_;
                    let _e351 = (_e329 + _e350);
                    let _e352 = (_e329 - _e350);
                    let _e353 = select(_e338, 0f, _e342);
                    if _e342 {
                        phi_531_ = 38685626000000000000000000f;
                    } else {
                        phi_531_ = (1f / _e338);
                    }
                    let _e356 = phi_531_;
                    let _e357 = (_e242 == 0u);
                    if _e357 {
                        phi_540_ = _e279[0];
                    } else {
                        phi_540_ = _e279[1];
                    }
                    let _e361 = phi_540_;
                    let _e362 = (_e242 == 2u);
                    if _e362 {
                        phi_546_ = _e279[2];
                    } else {
                        phi_546_ = _e361;
                    }
                    let _e365 = phi_546_;
                    let _e367 = ((_e365 * _e252) * _e258);
                    if _e357 {
                        phi_557_ = _e291[0];
                    } else {
                        phi_557_ = _e291[1];
                    }
                    let _e371 = phi_557_;
                    if _e362 {
                        phi_563_ = _e291[2];
                    } else {
                        phi_563_ = _e371;
                    }
                    let _e374 = phi_563_;
                    let _e376 = ((_e374 * _e269) * _e275);
                    let _e380 = (bitcast<f32>((bitcast<u32>(_e376) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e380 {
                        let _e384 = (bitcast<f32>((bitcast<u32>(_e367) & 2147483647u)) * 0.00000011920929f);
                        phi_586_ = select(0.00000000000011368684f, _e384, (_e384 > 0.00000000000011368684f));
                    } else {
                        phi_586_ = 0f;
                    }
                    let _e388 = phi_586_;
                    let _e389 = (_e367 + _e388);
                    let _e390 = (_e367 - _e388);
                    let _e391 = select(_e376, 0f, _e380);
                    if _e380 {
                        phi_597_ = 38685626000000000000000000f;
                    } else {
                        phi_597_ = (1f / _e376);
                    }
                    let _e394 = phi_597_;
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
                        phi_697_ = select(-340282350000000000000000000000000000000f, _e435, (_e435 > -340282350000000000000000000000000000000f));
                        phi_698_ = select(-340282350000000000000000000000000000000f, _e428, (_e428 > -340282350000000000000000000000000000000f));
                    } else {
                        phi_697_ = 0f;
                        phi_698_ = 1f;
                    }
                    let _e439 = phi_697_;
                    let _e441 = phi_698_;
                    local_6 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                    local_5 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_4 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_3 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_1 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_7 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_9 = array<f32, 3>(bitcast<f32>(_e89), bitcast<f32>(_e93), bitcast<f32>(_e97));
                    let _e447 = (_e241 % 3u);
                    let _e448 = (_e447 < 3u);
                    if _e448 {
                    } else {
                        break;
                    }
                    let _e450 = local_9[_e447];
                    let _e451 = (_e240 % 3u);
                    let _e452 = (_e451 < 3u);
                    if _e452 {
                    } else {
                        break;
                    }
                    let _e454 = local_9[_e451];
                    let _e455 = (_e242 % 3u);
                    let _e456 = (_e455 < 3u);
                    if _e456 {
                    } else {
                        break;
                    }
                    let _e458 = local_9[_e455];
                    local_8 = array<f32, 3>(bitcast<f32>(_e101), bitcast<f32>(_e105), bitcast<f32>(_e109));
                    if _e448 {
                    } else {
                        break;
                    }
                    let _e462 = local_8[_e447];
                    if _e452 {
                    } else {
                        break;
                    }
                    let _e464 = local_8[_e451];
                    if _e456 {
                    } else {
                        break;
                    }
                    let _e466 = local_8[_e455];
                    phi_2941_ = false;
                    phi_772_ = type_38(type_32(type_25(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e439), 0u, 0u);
                    phi_775_ = type_49(type_47(array<f32, 3>(_e450, _e454, _e458), array<f32, 3>(_e462, _e464, _e466)), select(0u, 2147483648u, (_e79 == 0u)));
                    phi_777_ = ((3u * _e79) + 1u);
                    phi_779_ = (_e441 <= _e439);
                    phi_781_ = 0u;
                    loop {
                        let _e474 = phi_2941_;
                        let _e476 = phi_772_;
                        let _e478 = phi_775_;
                        let _e480 = phi_777_;
                        let _e482 = phi_779_;
                        let _e484 = phi_781_;
                        local_10 = _e476;
                        local_11 = _e476;
                        if _e482 {
                            phi_792_ = true;
                        } else {
                            phi_792_ = (_e484 > 0u);
                        }
                        let _e487 = phi_792_;
                        if _e487 {
                            let _e488 = (_e480 > 0u);
                            if _e488 {
                                if _e482 {
                                    phi_878_ = _e478;
                                    phi_879_ = _e482;
                                    phi_880_ = _e484;
                                } else {
                                    let _e489 = (_e484 - 1u);
                                    let _e490 = (_e489 % 128u);
                                    let _e491 = (_e490 < 128u);
                                    if _e491 {
                                    } else {
                                        phi_3077_ = true;
                                        break;
                                    }
                                    let _e493 = local_6[_e490];
                                    if _e491 {
                                    } else {
                                        phi_3077_ = true;
                                        break;
                                    }
                                    let _e495 = local_5[_e490];
                                    if _e491 {
                                    } else {
                                        phi_3077_ = true;
                                        break;
                                    }
                                    let _e497 = local_4[_e490];
                                    if _e491 {
                                    } else {
                                        phi_3077_ = true;
                                        break;
                                    }
                                    let _e499 = local_3[_e490];
                                    if _e491 {
                                    } else {
                                        phi_3077_ = true;
                                        break;
                                    }
                                    let _e502 = local_2[_e490];
                                    if _e491 {
                                    } else {
                                        phi_3077_ = true;
                                        break;
                                    }
                                    let _e504 = local_1[_e490];
                                    if _e491 {
                                    } else {
                                        phi_3077_ = true;
                                        break;
                                    }
                                    let _e506 = local[_e490];
                                    if _e491 {
                                    } else {
                                        phi_3077_ = true;
                                        break;
                                    }
                                    let _e511 = local_7[_e490];
                                    phi_878_ = type_49(type_47(array<f32, 3>(_e495, _e497, _e499), array<f32, 3>(_e502, _e504, _e506)), _e493);
                                    phi_879_ = (_e511 <= _e476.member.member_1);
                                    phi_880_ = _e489;
                                }
                                let _e516 = phi_878_;
                                let _e518 = phi_879_;
                                let _e520 = phi_880_;
                                if _e518 {
                                    if ((_e516.member_1 & 2147483648u) != 0u) {
                                        phi_898_ = _e476;
                                        phi_901_ = type_4(0u, ((_e516.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e879 = phi_898_;
                                            let _e881 = phi_901_;
                                            local_12 = _e879;
                                            if (_e881.member < _e881.member_1) {
                                                phi_902_ = type_4((_e881.member + 1u), _e881.member_1);
                                                phi_924_ = type_4(1u, _e881.member);
                                            } else {
                                                phi_902_ = _e881;
                                                phi_924_ = type_4(0u, type_4().member_1);
                                            }
                                            let _e894 = phi_902_;
                                            let _e896 = phi_924_;
                                            let _e900 = (bitcast<i32>(_e896.member) != 0i);
                                            if _e900 {
                                                let _e906 = type_38(_e879.member, _e879.member_1, (_e879.member_2 + 1u));
                                                let _e907 = ((_e516.member_1 & 268435455u) + _e896.member_1);
                                                let _e908 = (_e907 < _e81);
                                                if _e908 {
                                                    if _e908 {
                                                    } else {
                                                        phi_2935_ = true;
                                                        break;
                                                    }
                                                    let _e912 = global_2.member[_e907].member_1;
                                                    phi_948_ = _e912;
                                                } else {
                                                    phi_948_ = 4294967295u;
                                                }
                                                let _e914 = phi_948_;
                                                if (_e907 >= _e81) {
                                                    phi_1037_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                } else {
                                                    if _e908 {
                                                    } else {
                                                        phi_2935_ = true;
                                                        break;
                                                    }
                                                    if (_e447 < 9u) {
                                                    } else {
                                                        phi_2935_ = true;
                                                        break;
                                                    }
                                                    let _e921 = global_2.member[_e907].member[_e447];
                                                    if (_e451 < 9u) {
                                                    } else {
                                                        phi_2935_ = true;
                                                        break;
                                                    }
                                                    let _e927 = global_2.member[_e907].member[_e451];
                                                    if (_e455 < 9u) {
                                                    } else {
                                                        phi_2935_ = true;
                                                        break;
                                                    }
                                                    let _e933 = global_2.member[_e907].member[_e455];
                                                    let _e935 = (3u + _e447);
                                                    if (_e935 < 9u) {
                                                    } else {
                                                        phi_2935_ = true;
                                                        break;
                                                    }
                                                    let _e941 = global_2.member[_e907].member[_e935];
                                                    let _e942 = (3u + _e451);
                                                    if (_e942 < 9u) {
                                                    } else {
                                                        phi_2935_ = true;
                                                        break;
                                                    }
                                                    let _e948 = global_2.member[_e907].member[_e942];
                                                    let _e949 = (3u + _e455);
                                                    if (_e949 < 9u) {
                                                    } else {
                                                        phi_2935_ = true;
                                                        break;
                                                    }
                                                    let _e955 = global_2.member[_e907].member[_e949];
                                                    let _e957 = (6u + _e447);
                                                    if (_e957 < 9u) {
                                                    } else {
                                                        phi_2935_ = true;
                                                        break;
                                                    }
                                                    let _e963 = global_2.member[_e907].member[_e957];
                                                    let _e964 = (6u + _e451);
                                                    if (_e964 < 9u) {
                                                    } else {
                                                        phi_2935_ = true;
                                                        break;
                                                    }
                                                    let _e970 = global_2.member[_e907].member[_e964];
                                                    let _e971 = (6u + _e455);
                                                    if (_e971 < 9u) {
                                                    } else {
                                                        phi_2935_ = true;
                                                        break;
                                                    }
                                                    let _e977 = global_2.member[_e907].member[_e971];
                                                    phi_1037_ = array<array<f32, 3>, 3>(array<f32, 3>(_e921, _e927, _e933), array<f32, 3>(_e941, _e948, _e955), array<f32, 3>(_e963, _e970, _e977));
                                                }
                                                let _e981 = phi_1037_;
                                                let _e990 = (_e981[0][2] - _e367);
                                                let _e993 = (((_e981[0][0] - _e290) * _e391) - (_e990 * _e315));
                                                let _e996 = (((_e981[0][1] - _e329) * _e391) - (_e990 * _e353));
                                                let _e1003 = (_e981[1][2] - _e367);
                                                let _e1006 = (((_e981[1][0] - _e290) * _e391) - (_e1003 * _e315));
                                                let _e1009 = (((_e981[1][1] - _e329) * _e391) - (_e1003 * _e353));
                                                let _e1016 = (_e981[2][2] - _e367);
                                                let _e1019 = (((_e981[2][0] - _e290) * _e391) - (_e1016 * _e315));
                                                let _e1022 = (((_e981[2][1] - _e329) * _e391) - (_e1016 * _e353));
                                                let _e1023 = (_e1019 * _e1009);
                                                let _e1024 = (_e1022 * _e1006);
                                                let _e1025 = (_e993 * _e1022);
                                                let _e1026 = (_e996 * _e1019);
                                                let _e1027 = (_e1006 * _e996);
                                                let _e1028 = (_e1009 * _e993);
                                                let _e1033 = (((_e1023 >= _e1024) && (_e1025 >= _e1026)) && (_e1027 >= _e1028));
                                                if (_e1033 || (((_e1023 <= _e1024) && (_e1025 <= _e1026)) && (_e1027 <= _e1028))) {
                                                    let _e1040 = select(-1f, 1f, _e1033);
                                                    let _e1042 = ((_e1023 - _e1024) * _e1040);
                                                    let _e1044 = select(0f, _e1042, (_e1042 > 0f));
                                                    let _e1046 = ((_e1025 - _e1026) * _e1040);
                                                    let _e1048 = select(0f, _e1046, (_e1046 > 0f));
                                                    let _e1050 = ((_e1027 - _e1028) * _e1040);
                                                    let _e1052 = select(0f, _e1050, (_e1050 > 0f));
                                                    let _e1054 = ((_e1044 + _e1048) + _e1052);
                                                    if (_e1054 < 0.000000000000000000000000000000000000011754944f) {
                                                        phi_1865_ = type_25();
                                                        phi_1866_ = true;
                                                        phi_1867_ = false;
                                                    } else {
                                                        let _e1057 = select(_e1006, _e993, (_e993 < _e1006));
                                                        if (select(_e1019, _e1057, (_e1057 < _e1019)) > 0f) {
                                                            phi_1154_ = true;
                                                        } else {
                                                            let _e1062 = select(_e1006, _e993, (_e993 > _e1006));
                                                            phi_1154_ = (select(_e1019, _e1062, (_e1062 > _e1019)) < 0f);
                                                        }
                                                        let _e1067 = phi_1154_;
                                                        if _e1067 {
                                                            phi_1862_ = type_25();
                                                            phi_1863_ = true;
                                                            phi_1864_ = false;
                                                        } else {
                                                            let _e1069 = select(_e1009, _e996, (_e996 < _e1009));
                                                            if (select(_e1022, _e1069, (_e1069 < _e1022)) > 0f) {
                                                                phi_1183_ = true;
                                                            } else {
                                                                let _e1074 = select(_e1009, _e996, (_e996 > _e1009));
                                                                phi_1183_ = (select(_e1022, _e1074, (_e1074 > _e1022)) < 0f);
                                                            }
                                                            let _e1079 = phi_1183_;
                                                            if _e1079 {
                                                                phi_1860_ = type_25();
                                                                phi_1861_ = false;
                                                            } else {
                                                                let _e1081 = select(_e981[1][0], _e981[0][0], (_e981[0][0] < _e981[1][0]));
                                                                let _e1085 = select(_e981[1][0], _e981[0][0], (_e981[0][0] > _e981[1][0]));
                                                                let _e1089 = select(_e981[1][1], _e981[0][1], (_e981[0][1] < _e981[1][1]));
                                                                let _e1093 = select(_e981[1][1], _e981[0][1], (_e981[0][1] > _e981[1][1]));
                                                                let _e1097 = select(_e981[1][2], _e981[0][2], (_e981[0][2] < _e981[1][2]));
                                                                let _e1101 = select(_e981[1][2], _e981[0][2], (_e981[0][2] > _e981[1][2]));
                                                                let _e1106 = ((select(_e981[2][0], _e1081, (_e1081 < _e981[2][0])) - _e313) * _e318);
                                                                let _e1107 = ((select(_e981[2][0], _e1085, (_e1085 > _e981[2][0])) - _e314) * _e318);
                                                                let _e1110 = ((select(_e981[2][1], _e1089, (_e1089 < _e981[2][1])) - _e351) * _e356);
                                                                let _e1111 = ((select(_e981[2][1], _e1093, (_e1093 > _e981[2][1])) - _e352) * _e356);
                                                                let _e1114 = ((select(_e981[2][2], _e1097, (_e1097 < _e981[2][2])) - _e389) * _e394);
                                                                let _e1115 = ((select(_e981[2][2], _e1101, (_e1101 > _e981[2][2])) - _e390) * _e394);
                                                                let _e1117 = select(_e1115, _e1114, (_e1114 < _e1115));
                                                                let _e1119 = select(_e1115, _e1114, (_e1114 > _e1115));
                                                                let _e1121 = select(_e1107, _e1106, (_e1106 < _e1107));
                                                                let _e1123 = select(_e1111, _e1110, (_e1110 < _e1111));
                                                                let _e1125 = select(_e1123, _e1121, (_e1121 > _e1123));
                                                                let _e1127 = select(_e1117, _e1125, (_e1125 > _e1117));
                                                                let _e1129 = select(_e1107, _e1106, (_e1106 > _e1107));
                                                                let _e1131 = select(_e1111, _e1110, (_e1110 > _e1111));
                                                                let _e1133 = select(_e1131, _e1129, (_e1129 < _e1131));
                                                                let _e1135 = select(_e1119, _e1133, (_e1133 < _e1119));
                                                                let _e1136 = -(_e1117);
                                                                let _e1142 = select(_e441, _e1127, (_e1127 > _e441));
                                                                if (_e1142 > (_e1135 + (select(_e1136, _e1119, (_e1119 > _e1136)) * 0.0000019073523f))) {
                                                                    phi_1855_ = type_25();
                                                                    phi_1856_ = true;
                                                                } else {
                                                                    let _e1144 = (_e1142 > _e879.member.member_1);
                                                                    if _e1144 {
                                                                        phi_1854_ = type_25();
                                                                    } else {
                                                                        let _e1145 = vec3<f32>(_e981[0][0], _e981[0][1], _e981[0][2]);
                                                                        let _e1146 = vec3<f32>(_e981[1][0], _e981[1][1], _e981[1][2]);
                                                                        let _e1147 = vec3<f32>(_e981[2][0], _e981[2][1], _e981[2][2]);
                                                                        let _e1148 = (_e981[1][0] - _e981[0][0]);
                                                                        let _e1149 = (_e981[1][1] - _e981[0][1]);
                                                                        let _e1150 = (_e981[1][2] - _e981[0][2]);
                                                                        let _e1151 = vec3<f32>(_e1148, _e1149, _e1150);
                                                                        let _e1152 = (_e981[2][0] - _e981[1][0]);
                                                                        let _e1153 = (_e981[2][1] - _e981[1][1]);
                                                                        let _e1154 = (_e981[2][2] - _e981[1][2]);
                                                                        let _e1155 = vec3<f32>(_e1152, _e1153, _e1154);
                                                                        let _e1156 = (_e981[0][0] - _e981[2][0]);
                                                                        let _e1157 = (_e981[0][1] - _e981[2][1]);
                                                                        let _e1158 = (_e981[0][2] - _e981[2][2]);
                                                                        let _e1159 = vec3<f32>(_e1156, _e1157, _e1158);
                                                                        let _e1162 = bitcast<f32>((bitcast<u32>(_e1148) & 2147483647u));
                                                                        let _e1165 = bitcast<f32>((bitcast<u32>(_e1149) & 2147483647u));
                                                                        let _e1167 = select(_e1165, _e1162, (_e1162 > _e1165));
                                                                        let _e1170 = bitcast<f32>((bitcast<u32>(_e1150) & 2147483647u));
                                                                        let _e1172 = select(_e1170, _e1167, (_e1167 > _e1170));
                                                                        let _e1175 = bitcast<f32>((bitcast<u32>(_e1152) & 2147483647u));
                                                                        let _e1178 = bitcast<f32>((bitcast<u32>(_e1153) & 2147483647u));
                                                                        let _e1180 = select(_e1178, _e1175, (_e1175 > _e1178));
                                                                        let _e1183 = bitcast<f32>((bitcast<u32>(_e1154) & 2147483647u));
                                                                        let _e1185 = select(_e1183, _e1180, (_e1180 > _e1183));
                                                                        let _e1188 = bitcast<f32>((bitcast<u32>(_e1156) & 2147483647u));
                                                                        let _e1191 = bitcast<f32>((bitcast<u32>(_e1157) & 2147483647u));
                                                                        let _e1193 = select(_e1191, _e1188, (_e1188 > _e1191));
                                                                        let _e1196 = bitcast<f32>((bitcast<u32>(_e1158) & 2147483647u));
                                                                        let _e1198 = select(_e1196, _e1193, (_e1193 > _e1196));
                                                                        let _e1200 = select(_e1185, _e1172, (_e1172 > _e1185));
                                                                        let _e1202 = select(_e1198, _e1200, (_e1200 > _e1198));
                                                                        if (_e1172 == _e1202) {
                                                                            phi_1584_ = _e1009;
                                                                            phi_1585_ = _e1006;
                                                                            phi_1586_ = _e996;
                                                                            phi_1587_ = _e993;
                                                                            phi_1588_ = _e1145;
                                                                            phi_1589_ = _e1159;
                                                                            phi_1590_ = _e1155;
                                                                            phi_1591_ = _e1151;
                                                                        } else {
                                                                            let _e1204 = (_e1185 == _e1202);
                                                                            let _e1209 = vec3(_e1204);
                                                                            phi_1584_ = select(_e996, _e1022, _e1204);
                                                                            phi_1585_ = select(_e993, _e1019, _e1204);
                                                                            phi_1586_ = select(_e1022, _e1009, _e1204);
                                                                            phi_1587_ = select(_e1019, _e1006, _e1204);
                                                                            phi_1588_ = select(_e1147, _e1146, _e1209);
                                                                            phi_1589_ = select(_e1155, _e1151, _e1209);
                                                                            phi_1590_ = select(_e1151, _e1159, _e1209);
                                                                            phi_1591_ = select(_e1159, _e1155, _e1209);
                                                                        }
                                                                        let _e1215 = phi_1584_;
                                                                        let _e1217 = phi_1585_;
                                                                        let _e1219 = phi_1586_;
                                                                        let _e1221 = phi_1587_;
                                                                        let _e1223 = phi_1588_;
                                                                        let _e1225 = phi_1589_;
                                                                        let _e1227 = phi_1590_;
                                                                        let _e1229 = phi_1591_;
                                                                        let _e1236 = ((_e1227.y * _e1225.z) - (_e1225.y * _e1227.z));
                                                                        let _e1241 = ((_e1227.z * _e1225.x) - (_e1225.z * _e1227.x));
                                                                        let _e1244 = ((_e1227.x * _e1225.y) - (_e1225.x * _e1227.y));
                                                                        if (_e1044 >= _e1048) {
                                                                            phi_1622_ = select(true, false, (_e1044 >= _e1052));
                                                                        } else {
                                                                            phi_1622_ = true;
                                                                        }
                                                                        let _e1249 = phi_1622_;
                                                                        if _e1249 {
                                                                            phi_1631_ = select(_e1147, _e1146, vec3((_e1048 >= _e1052)));
                                                                        } else {
                                                                            phi_1631_ = _e1145;
                                                                        }
                                                                        let _e1254 = phi_1631_;
                                                                        let _e1259 = (((_e1236 * _e315) + (_e1241 * _e353)) + (_e1244 * _e391));
                                                                        let _e1270 = (((_e1236 * (_e1254.x - _e290)) + (_e1241 * (_e1254.y - _e329))) + (_e1244 * (_e1254.z - _e367)));
                                                                        let _e1272 = (_e1217 - _e1221);
                                                                        let _e1273 = (_e1215 - _e1219);
                                                                        let _e1281 = (-(((_e1221 * _e1272) + (_e1219 * _e1273))) / ((_e1272 * _e1272) + (_e1273 * _e1273)));
                                                                        let _e1283 = select(1f, _e1281, (_e1281 < 1f));
                                                                        let _e1285 = select(0f, _e1283, (_e1283 > 0f));
                                                                        let _e1298 = ((_e1223.x + (_e1229.x * _e1285)) - _e290);
                                                                        let _e1299 = ((_e1223.y + (_e1229.y * _e1285)) - _e329);
                                                                        let _e1300 = ((_e1223.z + (_e1229.z * _e1285)) - _e367);
                                                                        let _e1301 = (_e1300 / _e391);
                                                                        let _e1313 = bitcast<f32>((bitcast<u32>(_e1298) & 2147483647u));
                                                                        let _e1316 = bitcast<f32>((bitcast<u32>(_e1299) & 2147483647u));
                                                                        let _e1318 = select(_e1316, _e1313, (_e1313 > _e1316));
                                                                        let _e1321 = bitcast<f32>((bitcast<u32>(_e1300) & 2147483647u));
                                                                        let _e1323 = select(_e1321, _e1318, (_e1318 > _e1321));
                                                                        let _e1329 = bitcast<f32>((bitcast<u32>(_e1236) & 2147483647u));
                                                                        let _e1332 = bitcast<f32>((bitcast<u32>(_e1241) & 2147483647u));
                                                                        let _e1334 = select(_e1332, _e1329, (_e1329 > _e1332));
                                                                        let _e1337 = bitcast<f32>((bitcast<u32>(_e1244) & 2147483647u));
                                                                        if (bitcast<f32>((bitcast<u32>(((((_e1236 * _e1298) + (_e1241 * _e1299)) + (_e1244 * _e1300)) - _e1270)) & 2147483647u)) <= ((0.0000009536743f * select(_e1202, _e1323, (_e1323 > _e1202))) * select(_e1337, _e1334, (_e1334 > _e1337)))) {
                                                                            let _e1347 = bitcast<f32>((bitcast<u32>(_e1227.x) & 2147483647u));
                                                                            let _e1350 = bitcast<f32>((bitcast<u32>(_e1227.y) & 2147483647u));
                                                                            let _e1352 = select(_e1350, _e1347, (_e1347 > _e1350));
                                                                            let _e1355 = bitcast<f32>((bitcast<u32>(_e1227.z) & 2147483647u));
                                                                            let _e1361 = bitcast<f32>((bitcast<u32>(_e1225.x) & 2147483647u));
                                                                            let _e1364 = bitcast<f32>((bitcast<u32>(_e1225.y) & 2147483647u));
                                                                            let _e1366 = select(_e1364, _e1361, (_e1361 > _e1364));
                                                                            let _e1369 = bitcast<f32>((bitcast<u32>(_e1225.z) & 2147483647u));
                                                                            phi_1798_ = select(true, false, (bitcast<f32>((bitcast<u32>(_e1259) & 2147483647u)) > ((0.0000038146973f * select(_e1355, _e1352, (_e1352 > _e1355))) * select(_e1369, _e1366, (_e1366 > _e1369)))));
                                                                        } else {
                                                                            phi_1798_ = true;
                                                                        }
                                                                        let _e1376 = phi_1798_;
                                                                        if _e1376 {
                                                                            let _e1387 = ((((_e1236 * (_e1298 - (_e315 * _e1301))) + (_e1241 * (_e1299 - (_e353 * _e1301)))) + (_e1244 * (_e1300 - _e1300))) / _e1259);
                                                                            if (bitcast<f32>((bitcast<u32>(_e1387) & 2147483647u)) <= _e1202) {
                                                                                phi_1822_ = (_e1301 + _e1387);
                                                                            } else {
                                                                                phi_1822_ = _e1301;
                                                                            }
                                                                            let _e1394 = phi_1822_;
                                                                            phi_1823_ = _e1394;
                                                                        } else {
                                                                            phi_1823_ = (_e1270 / _e1259);
                                                                        }
                                                                        let _e1396 = phi_1823_;
                                                                        let _e1398 = select(_e1135, _e1396, (_e1396 < _e1135));
                                                                        let _e1400 = select(_e1127, _e1398, (_e1398 > _e1127));
                                                                        if (_e1400 >= _e441) {
                                                                            let _e1402 = (_e1400 <= _e879.member.member_1);
                                                                            if _e1402 {
                                                                                let _e1403 = (1f / _e1054);
                                                                                phi_1846_ = type_25(_e1400, (_e1048 * _e1403), (_e1052 * _e1403), _e914);
                                                                            } else {
                                                                                phi_1846_ = type_25();
                                                                            }
                                                                            let _e1408 = phi_1846_;
                                                                            phi_1848_ = _e1408;
                                                                            phi_1849_ = select(true, false, _e1402);
                                                                        } else {
                                                                            phi_1848_ = type_25();
                                                                            phi_1849_ = true;
                                                                        }
                                                                        let _e1411 = phi_1848_;
                                                                        let _e1413 = phi_1849_;
                                                                        if _e1413 {
                                                                            phi_1853_ = type_25(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                        } else {
                                                                            phi_1853_ = _e1411;
                                                                        }
                                                                        let _e1415 = phi_1853_;
                                                                        phi_1854_ = _e1415;
                                                                    }
                                                                    let _e1417 = phi_1854_;
                                                                    phi_1855_ = _e1417;
                                                                    phi_1856_ = _e1144;
                                                                }
                                                                let _e1419 = phi_1855_;
                                                                let _e1421 = phi_1856_;
                                                                phi_1860_ = _e1419;
                                                                phi_1861_ = _e1421;
                                                            }
                                                            let _e1423 = phi_1860_;
                                                            let _e1425 = phi_1861_;
                                                            phi_1862_ = _e1423;
                                                            phi_1863_ = _e1079;
                                                            phi_1864_ = _e1425;
                                                        }
                                                        let _e1427 = phi_1862_;
                                                        let _e1429 = phi_1863_;
                                                        let _e1431 = phi_1864_;
                                                        phi_1865_ = _e1427;
                                                        phi_1866_ = _e1429;
                                                        phi_1867_ = _e1431;
                                                    }
                                                    let _e1433 = phi_1865_;
                                                    let _e1435 = phi_1866_;
                                                    let _e1437 = phi_1867_;
                                                    phi_1875_ = _e1433;
                                                    phi_1876_ = select(_e1437, true, _e1435);
                                                } else {
                                                    phi_1875_ = type_25();
                                                    phi_1876_ = true;
                                                }
                                                let _e1440 = phi_1875_;
                                                let _e1442 = phi_1876_;
                                                if _e1442 {
                                                    phi_1880_ = type_25(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                } else {
                                                    phi_1880_ = _e1440;
                                                }
                                                let _e1444 = phi_1880_;
                                                if (_e1444.member_3 != 4294967295u) {
                                                    if (_e914 != 4294967295u) {
                                                        if (_e1444.member < _e879.member.member.member) {
                                                            phi_1906_ = true;
                                                        } else {
                                                            if (_e1444.member == _e879.member.member.member) {
                                                                phi_1905_ = (_e1444.member_3 < _e879.member.member.member_3);
                                                            } else {
                                                                phi_1905_ = false;
                                                            }
                                                            let _e1459 = phi_1905_;
                                                            phi_1906_ = _e1459;
                                                        }
                                                        let _e1461 = phi_1906_;
                                                        if _e1461 {
                                                            phi_1913_ = type_38(type_32(_e1444, _e1444.member), _e906.member_1, _e906.member_2);
                                                        } else {
                                                            phi_1913_ = _e906;
                                                        }
                                                        let _e1468 = phi_1913_;
                                                        phi_1914_ = _e1468;
                                                    } else {
                                                        phi_1914_ = _e906;
                                                    }
                                                    let _e1470 = phi_1914_;
                                                    phi_1915_ = _e1470;
                                                } else {
                                                    phi_1915_ = _e906;
                                                }
                                                let _e1472 = phi_1915_;
                                                phi_899_ = _e1472;
                                            } else {
                                                phi_899_ = type_38();
                                            }
                                            let _e1474 = phi_899_;
                                            continue;
                                            continuing {
                                                phi_898_ = _e1474;
                                                phi_901_ = _e894;
                                                phi_2935_ = _e474;
                                                break if !(_e900);
                                            }
                                        }
                                        let _e1477 = phi_2935_;
                                        phi_3077_ = _e1477;
                                        if _e1477 {
                                            break;
                                        }
                                        phi_3081_ = _e1477;
                                        let _e1640 = local_12;
                                        phi_2867_ = _e1640;
                                        phi_2868_ = _e516;
                                        phi_2869_ = false;
                                        phi_2870_ = _e520;
                                    } else {
                                        let _e535 = (_e516.member_1 < _e79);
                                        if _e535 {
                                            if _e535 {
                                            } else {
                                                phi_3077_ = true;
                                                break;
                                            }
                                            let _e537 = global_5.member[_e516.member_1];
                                            phi_1937_ = _e537;
                                        } else {
                                            phi_1937_ = type_42(array<u32, 2>(0u, 0u), array<u32, 2>(0u, 0u), 2147483648u, 2147483648u);
                                        }
                                        let _e539 = phi_1937_;
                                        let _e554 = ((10u * _e241) & 31u);
                                        let _e557 = ((_e539.member[0] >> bitcast<u32>(_e554)) & 1023u);
                                        let _e562 = bitcast<f32>((bitcast<u32>(((_e516.member.member_1[0] - _e516.member.member[0]) * 0.0009775171f)) ^ _e113));
                                        let _e568 = (_e516.member.member[0] + bitcast<f32>((bitcast<u32>((f32(_e557) * _e562)) ^ _e113)));
                                        let _e572 = select(select(_e516.member.member_1[0], _e568, (_e568 < _e516.member.member_1[0])), _e516.member.member_1[0], (_e557 == 1023u));
                                        let _e574 = ((10u * _e240) & 31u);
                                        let _e577 = ((_e539.member[0] >> bitcast<u32>(_e574)) & 1023u);
                                        let _e582 = bitcast<f32>((bitcast<u32>(((_e516.member.member_1[1] - _e516.member.member[1]) * 0.0009775171f)) ^ _e113));
                                        let _e588 = (_e516.member.member[1] + bitcast<f32>((bitcast<u32>((f32(_e577) * _e582)) ^ _e113)));
                                        let _e592 = select(select(_e516.member.member_1[1], _e588, (_e588 < _e516.member.member_1[1])), _e516.member.member_1[1], (_e577 == 1023u));
                                        let _e594 = ((10u * _e242) & 31u);
                                        let _e597 = ((_e539.member[0] >> bitcast<u32>(_e594)) & 1023u);
                                        let _e602 = bitcast<f32>((bitcast<u32>(((_e516.member.member_1[2] - _e516.member.member[2]) * 0.0009775171f)) ^ _e113));
                                        let _e608 = (_e516.member.member[2] + bitcast<f32>((bitcast<u32>((f32(_e597) * _e602)) ^ _e113)));
                                        let _e612 = select(select(_e516.member.member_1[2], _e608, (_e608 < _e516.member.member_1[2])), _e516.member.member_1[2], (_e597 == 1023u));
                                        let _e615 = ((_e539.member[1] >> bitcast<u32>(_e554)) & 1023u);
                                        let _e621 = (_e516.member.member[0] + bitcast<f32>((bitcast<u32>((f32(_e615) * _e562)) ^ _e113)));
                                        let _e625 = select(select(_e516.member.member_1[0], _e621, (_e621 < _e516.member.member_1[0])), _e516.member.member_1[0], (_e615 == 1023u));
                                        let _e628 = ((_e539.member[1] >> bitcast<u32>(_e574)) & 1023u);
                                        let _e634 = (_e516.member.member[1] + bitcast<f32>((bitcast<u32>((f32(_e628) * _e582)) ^ _e113)));
                                        let _e638 = select(select(_e516.member.member_1[1], _e634, (_e634 < _e516.member.member_1[1])), _e516.member.member_1[1], (_e628 == 1023u));
                                        let _e641 = ((_e539.member[1] >> bitcast<u32>(_e594)) & 1023u);
                                        let _e647 = (_e516.member.member[2] + bitcast<f32>((bitcast<u32>((f32(_e641) * _e602)) ^ _e113)));
                                        let _e651 = select(select(_e516.member.member_1[2], _e647, (_e647 < _e516.member.member_1[2])), _e516.member.member_1[2], (_e641 == 1023u));
                                        let _e657 = ((_e539.member_1[0] >> bitcast<u32>(_e554)) & 1023u);
                                        let _e663 = (_e516.member.member[0] + bitcast<f32>((bitcast<u32>((f32(_e657) * _e562)) ^ _e113)));
                                        let _e667 = select(select(_e516.member.member_1[0], _e663, (_e663 < _e516.member.member_1[0])), _e516.member.member_1[0], (_e657 == 1023u));
                                        let _e670 = ((_e539.member_1[0] >> bitcast<u32>(_e574)) & 1023u);
                                        let _e676 = (_e516.member.member[1] + bitcast<f32>((bitcast<u32>((f32(_e670) * _e582)) ^ _e113)));
                                        let _e680 = select(select(_e516.member.member_1[1], _e676, (_e676 < _e516.member.member_1[1])), _e516.member.member_1[1], (_e670 == 1023u));
                                        let _e683 = ((_e539.member_1[0] >> bitcast<u32>(_e594)) & 1023u);
                                        let _e689 = (_e516.member.member[2] + bitcast<f32>((bitcast<u32>((f32(_e683) * _e602)) ^ _e113)));
                                        let _e693 = select(select(_e516.member.member_1[2], _e689, (_e689 < _e516.member.member_1[2])), _e516.member.member_1[2], (_e683 == 1023u));
                                        let _e696 = ((_e539.member_1[1] >> bitcast<u32>(_e554)) & 1023u);
                                        let _e702 = (_e516.member.member[0] + bitcast<f32>((bitcast<u32>((f32(_e696) * _e562)) ^ _e113)));
                                        let _e706 = select(select(_e516.member.member_1[0], _e702, (_e702 < _e516.member.member_1[0])), _e516.member.member_1[0], (_e696 == 1023u));
                                        let _e709 = ((_e539.member_1[1] >> bitcast<u32>(_e574)) & 1023u);
                                        let _e715 = (_e516.member.member[1] + bitcast<f32>((bitcast<u32>((f32(_e709) * _e582)) ^ _e113)));
                                        let _e719 = select(select(_e516.member.member_1[1], _e715, (_e715 < _e516.member.member_1[1])), _e516.member.member_1[1], (_e709 == 1023u));
                                        let _e722 = ((_e539.member_1[1] >> bitcast<u32>(_e594)) & 1023u);
                                        let _e728 = (_e516.member.member[2] + bitcast<f32>((bitcast<u32>((f32(_e722) * _e602)) ^ _e113)));
                                        let _e732 = select(select(_e516.member.member_1[2], _e728, (_e728 < _e516.member.member_1[2])), _e516.member.member_1[2], (_e722 == 1023u));
                                        let _e737 = type_49(type_47(array<f32, 3>(_e572, _e592, _e612), array<f32, 3>(_e625, _e638, _e651)), _e539.member_2);
                                        let _e742 = type_49(type_47(array<f32, 3>(_e667, _e680, _e693), array<f32, 3>(_e706, _e719, _e732)), _e539.member_3);
                                        let _e749 = ((_e572 - _e313) * _e318);
                                        let _e750 = ((_e667 - _e313) * _e318);
                                        let _e751 = ((_e625 - _e314) * _e318);
                                        let _e752 = ((_e706 - _e314) * _e318);
                                        let _e757 = ((_e592 - _e351) * _e356);
                                        let _e758 = ((_e680 - _e351) * _e356);
                                        let _e759 = ((_e638 - _e352) * _e356);
                                        let _e760 = ((_e719 - _e352) * _e356);
                                        let _e765 = ((_e612 - _e389) * _e394);
                                        let _e766 = ((_e693 - _e389) * _e394);
                                        let _e767 = ((_e651 - _e390) * _e394);
                                        let _e768 = ((_e732 - _e390) * _e394);
                                        let _e770 = select(_e767, _e765, (_e765 < _e767));
                                        let _e772 = select(_e768, _e766, (_e766 < _e768));
                                        let _e774 = select(_e767, _e765, (_e765 > _e767));
                                        let _e776 = select(_e768, _e766, (_e766 > _e768));
                                        let _e778 = select(_e751, _e749, (_e749 < _e751));
                                        let _e780 = select(_e752, _e750, (_e750 < _e752));
                                        let _e782 = select(_e759, _e757, (_e757 < _e759));
                                        let _e784 = select(_e760, _e758, (_e758 < _e760));
                                        let _e786 = select(_e782, _e778, (_e778 > _e782));
                                        let _e788 = select(_e784, _e780, (_e780 > _e784));
                                        let _e790 = select(_e770, _e786, (_e786 > _e770));
                                        let _e792 = select(_e772, _e788, (_e788 > _e772));
                                        let _e794 = select(_e751, _e749, (_e749 > _e751));
                                        let _e796 = select(_e752, _e750, (_e750 > _e752));
                                        let _e798 = select(_e759, _e757, (_e757 > _e759));
                                        let _e800 = select(_e760, _e758, (_e758 > _e760));
                                        let _e802 = select(_e798, _e794, (_e794 < _e798));
                                        let _e804 = select(_e800, _e796, (_e796 < _e800));
                                        let _e809 = -(_e770);
                                        let _e810 = -(_e772);
                                        let _e817 = (select(_e774, _e802, (_e802 < _e774)) + (select(_e809, _e774, (_e774 > _e809)) * 0.0000019073523f));
                                        let _e818 = (select(_e776, _e804, (_e804 < _e776)) + (select(_e810, _e776, (_e776 > _e810)) * 0.0000019073523f));
                                        let _e820 = select(_e441, _e790, (_e790 > _e441));
                                        let _e822 = select(_e441, _e792, (_e792 > _e441));
                                        let _e827 = (_e820 <= select(_e476.member.member_1, _e817, (_e817 < _e476.member.member_1)));
                                        let _e828 = (_e822 <= select(_e476.member.member_1, _e818, (_e818 < _e476.member.member_1)));
                                        let _e829 = (_e820 <= _e822);
                                        if _e827 {
                                            if _e828 {
                                                if _e829 {
                                                    phi_2769_ = _e742;
                                                } else {
                                                    phi_2769_ = _e737;
                                                }
                                                let _e831 = phi_2769_;
                                                let _e839 = (_e520 % 128u);
                                                let _e840 = (_e839 < 128u);
                                                if _e840 {
                                                } else {
                                                    phi_3077_ = true;
                                                    break;
                                                }
                                                local_6[_e839] = _e831.member_1;
                                                if _e840 {
                                                } else {
                                                    phi_3077_ = true;
                                                    break;
                                                }
                                                local_5[_e839] = _e831.member.member[0];
                                                if _e840 {
                                                } else {
                                                    phi_3077_ = true;
                                                    break;
                                                }
                                                local_4[_e839] = _e831.member.member[1];
                                                if _e840 {
                                                } else {
                                                    phi_3077_ = true;
                                                    break;
                                                }
                                                local_3[_e839] = _e831.member.member[2];
                                                if _e840 {
                                                } else {
                                                    phi_3077_ = true;
                                                    break;
                                                }
                                                local_2[_e839] = _e831.member.member_1[0];
                                                if _e840 {
                                                } else {
                                                    phi_3077_ = true;
                                                    break;
                                                }
                                                local_1[_e839] = _e831.member.member_1[1];
                                                if _e840 {
                                                } else {
                                                    phi_3077_ = true;
                                                    break;
                                                }
                                                local[_e839] = _e831.member.member_1[2];
                                                if _e840 {
                                                } else {
                                                    phi_3077_ = true;
                                                    break;
                                                }
                                                local_7[_e839] = select(_e822, _e820, (_e820 > _e822));
                                                if _e829 {
                                                    phi_2846_ = _e737;
                                                } else {
                                                    phi_2846_ = _e742;
                                                }
                                                let _e857 = phi_2846_;
                                                phi_2847_ = _e857;
                                                phi_2848_ = (_e520 + 1u);
                                            } else {
                                                phi_2847_ = type_49();
                                                phi_2848_ = u32();
                                            }
                                            let _e859 = phi_2847_;
                                            let _e861 = phi_2848_;
                                            phi_2850_ = _e859;
                                            phi_2851_ = _e861;
                                            phi_2852_ = select(true, false, _e828);
                                        } else {
                                            phi_2850_ = type_49();
                                            phi_2851_ = u32();
                                            phi_2852_ = true;
                                        }
                                        let _e864 = phi_2850_;
                                        let _e866 = phi_2851_;
                                        let _e868 = phi_2852_;
                                        if _e868 {
                                            if _e827 {
                                                phi_2859_ = _e737;
                                            } else {
                                                phi_2859_ = _e742;
                                            }
                                            let _e870 = phi_2859_;
                                            phi_2864_ = _e870;
                                            phi_2865_ = select(_e828, true, _e827);
                                        } else {
                                            phi_2864_ = _e864;
                                            phi_2865_ = _e518;
                                        }
                                        let _e873 = phi_2864_;
                                        let _e875 = phi_2865_;
                                        phi_3081_ = _e474;
                                        phi_2867_ = type_38(_e476.member, (_e476.member_1 + 1u), _e476.member_2);
                                        phi_2868_ = _e873;
                                        phi_2869_ = _e875;
                                        phi_2870_ = select(_e866, _e520, _e868);
                                    }
                                    let _e1479 = phi_3081_;
                                    let _e1481 = phi_2867_;
                                    let _e1483 = phi_2868_;
                                    let _e1485 = phi_2869_;
                                    let _e1487 = phi_2870_;
                                    phi_3080_ = _e1479;
                                    phi_2871_ = _e1481;
                                    phi_2872_ = _e1483;
                                    phi_2873_ = (_e480 - 1u);
                                    phi_2874_ = _e1485;
                                    phi_2875_ = _e1487;
                                } else {
                                    phi_3080_ = _e474;
                                    phi_2871_ = _e476;
                                    phi_2872_ = _e516;
                                    phi_2873_ = _e480;
                                    phi_2874_ = _e518;
                                    phi_2875_ = _e520;
                                }
                                let _e1489 = phi_3080_;
                                let _e1491 = phi_2871_;
                                let _e1493 = phi_2872_;
                                let _e1495 = phi_2873_;
                                let _e1497 = phi_2874_;
                                let _e1499 = phi_2875_;
                                phi_3079_ = _e1489;
                                phi_2876_ = _e1491;
                                phi_2877_ = _e1493;
                                phi_2878_ = _e1495;
                                phi_2879_ = _e1497;
                                phi_2880_ = _e1499;
                            } else {
                                phi_3079_ = _e474;
                                phi_2876_ = type_38();
                                phi_2877_ = type_49();
                                phi_2878_ = u32();
                                phi_2879_ = bool();
                                phi_2880_ = u32();
                            }
                            let _e1501 = phi_3079_;
                            let _e1503 = phi_2876_;
                            let _e1505 = phi_2877_;
                            let _e1507 = phi_2878_;
                            let _e1509 = phi_2879_;
                            let _e1511 = phi_2880_;
                            phi_3078_ = _e1501;
                            phi_773_ = _e1503;
                            phi_776_ = _e1505;
                            phi_778_ = _e1507;
                            phi_780_ = _e1509;
                            phi_782_ = _e1511;
                            phi_2881_ = _e488;
                        } else {
                            phi_3078_ = _e474;
                            phi_773_ = type_38();
                            phi_776_ = type_49();
                            phi_778_ = u32();
                            phi_780_ = bool();
                            phi_782_ = u32();
                            phi_2881_ = false;
                        }
                        let _e1513 = phi_3078_;
                        let _e1515 = phi_773_;
                        let _e1517 = phi_776_;
                        let _e1519 = phi_778_;
                        let _e1521 = phi_780_;
                        let _e1523 = phi_782_;
                        let _e1525 = phi_2881_;
                        continue;
                        continuing {
                            phi_2941_ = _e1513;
                            phi_772_ = _e1515;
                            phi_775_ = _e1517;
                            phi_777_ = _e1519;
                            phi_779_ = _e1521;
                            phi_781_ = _e1523;
                            phi_3077_ = _e1513;
                            break if !(_e1525);
                        }
                    }
                    let _e1528 = phi_3077_;
                    if _e1528 {
                        break;
                    }
                    let _e1530 = local_10;
                    let _e1533 = local_11;
                    if _e129 {
                    } else {
                        break;
                    }
                    global_6.member[_e127][0u] = _e1530.member_1;
                    global_6.member[_e127][1u] = _e1533.member_2;
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn trace_counted_printed_f32_(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
