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

struct type_21 {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: u32,
}

struct type_22 {
    member: array<f32, 3>,
    member_1: f32,
    member_2: array<f32, 3>,
    member_3: f32,
}

struct type_30 {
    member: array<type_22>,
}

struct type_32 {
    member: f32,
    member_1: bool,
}

struct type_34 {
    member: array<vec4<u32>, 2>,
}

struct type_36 {
    member: array<u32, 2>,
    member_1: array<u32, 2>,
    member_2: u32,
    member_3: u32,
}

struct type_38 {
    member: array<type_36>,
}

struct type_41 {
    member: array<f32, 3>,
    member_1: array<f32, 3>,
}

struct type_43 {
    member: array<u32, 3>,
    member_1: u32,
}

struct type_45 {
    member: array<type_43>,
}

struct type_49 {
    member: type_41,
    member_1: u32,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_1: type_11;
@group(0) @binding(1) 
var<uniform> global_2: type_34;
@group(0) @binding(4) 
var<storage> global_3: type_30;
@group(0) @binding(5) 
var<storage, read_write> global_4: type_4;
@group(0) @binding(2) 
var<storage> global_5: type_38;
@group(0) @binding(3) 
var<storage> global_6: type_45;

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
    var phi_332_: i32;
    var phi_333_: i32;
    var phi_343_: bool;
    var phi_353_: u32;
    var phi_354_: u32;
    var phi_356_: bool;
    var phi_361_: u32;
    var phi_373_: i32;
    var phi_393_: i32;
    var phi_411_: f32;
    var phi_417_: f32;
    var phi_428_: f32;
    var phi_434_: f32;
    var phi_457_: f32;
    var phi_468_: f32;
    var phi_477_: f32;
    var phi_483_: f32;
    var phi_494_: f32;
    var phi_500_: f32;
    var phi_523_: f32;
    var phi_534_: f32;
    var phi_543_: f32;
    var phi_549_: f32;
    var phi_560_: f32;
    var phi_566_: f32;
    var phi_589_: f32;
    var phi_600_: f32;
    var phi_700_: f32;
    var phi_701_: f32;
    var phi_3077_: bool;
    var phi_774_: type_32;
    var phi_777_: type_49;
    var phi_779_: u32;
    var phi_781_: bool;
    var phi_783_: u32;
    var phi_794_: bool;
    var phi_880_: type_49;
    var phi_881_: bool;
    var phi_882_: u32;
    var phi_2075_: type_36;
    var phi_2907_: type_49;
    var phi_2984_: type_49;
    var phi_2985_: type_49;
    var phi_2986_: u32;
    var phi_2988_: type_49;
    var phi_2989_: u32;
    var phi_2990_: bool;
    var phi_2997_: type_49;
    var phi_3002_: type_49;
    var phi_3003_: bool;
    var phi_901_: type_32;
    var phi_904_: type_7;
    var phi_905_: type_7;
    var phi_927_: type_7;
    var phi_952_: u32;
    var phi_968_: type_43;
    var phi_1344_: bool;
    var phi_1373_: bool;
    var phi_1750_: f32;
    var phi_1751_: f32;
    var phi_1752_: f32;
    var phi_1753_: f32;
    var phi_1754_: vec3<f32>;
    var phi_1755_: vec3<f32>;
    var phi_1756_: vec3<f32>;
    var phi_1757_: vec3<f32>;
    var phi_1788_: bool;
    var phi_1797_: vec3<f32>;
    var phi_1962_: f32;
    var phi_1964_: f32;
    var phi_1965_: bool;
    var phi_1985_: f32;
    var phi_1986_: f32;
    var phi_2009_: type_21;
    var phi_2011_: type_21;
    var phi_2012_: bool;
    var phi_2016_: type_21;
    var phi_2017_: type_21;
    var phi_2018_: type_21;
    var phi_2019_: bool;
    var phi_2023_: type_21;
    var phi_2024_: bool;
    var phi_2025_: type_21;
    var phi_2026_: bool;
    var phi_2027_: bool;
    var phi_2028_: type_21;
    var phi_2029_: bool;
    var phi_2030_: bool;
    var phi_2038_: type_21;
    var phi_2039_: bool;
    var phi_2043_: type_21;
    var phi_2054_: type_32;
    var phi_2055_: type_32;
    var phi_902_: type_32;
    var phi_3071_: bool;
    var local_10: type_32;
    var phi_3232_: bool;
    var phi_3005_: type_32;
    var phi_3006_: type_49;
    var phi_3007_: bool;
    var phi_3008_: u32;
    var phi_3231_: bool;
    var phi_3009_: type_32;
    var phi_3010_: type_49;
    var phi_3011_: u32;
    var phi_3012_: bool;
    var phi_3013_: u32;
    var phi_3230_: bool;
    var phi_3014_: type_32;
    var phi_3015_: type_49;
    var phi_3016_: u32;
    var phi_3017_: bool;
    var phi_3018_: u32;
    var phi_3229_: bool;
    var phi_775_: type_32;
    var phi_778_: type_49;
    var phi_780_: u32;
    var phi_782_: bool;
    var phi_784_: u32;
    var phi_3019_: bool;
    var phi_3228_: bool;
    var local_11: type_32;
    var local_12: type_32;

    switch bitcast<i32>(0u) {
        default: {
            let _e75 = global;
            let _e78 = arrayLength((&global_5.member));
            let _e89 = global_2.member[0u][0u];
            let _e93 = global_2.member[0u][1u];
            let _e97 = global_2.member[0u][2u];
            let _e101 = global_2.member[1u][0u];
            let _e105 = global_2.member[1u][1u];
            let _e109 = global_2.member[1u][2u];
            let _e113 = global_2.member[1u][3u];
            let _e116 = global_1.member[0u];
            let _e117 = bitcast<i32>(_e116);
            let _e127 = (_e75.x + (_e75.y * 2097152u));
            let _e128 = (_e127 < arrayLength((&global_3.member)));
            if _e128 {
                let _e129 = (_e127 < arrayLength((&global_4.member)));
                if _e129 {
                    if _e128 {
                    } else {
                        break;
                    }
                    let _e137 = global_3.member[_e127].member_2[0u];
                    let _e139 = (bitcast<u32>(_e137) & 2147483647u);
                    let _e144 = global_3.member[_e127].member_2[1u];
                    let _e146 = (bitcast<u32>(_e144) & 2147483647u);
                    let _e151 = global_3.member[_e127].member_2[2u];
                    let _e153 = (bitcast<u32>(_e151) & 2147483647u);
                    let _e158 = global_3.member[_e127].member[0u];
                    let _e160 = (bitcast<u32>(_e158) & 2147483647u);
                    let _e165 = global_3.member[_e127].member[1u];
                    let _e167 = (bitcast<u32>(_e165) & 2147483647u);
                    let _e172 = global_3.member[_e127].member[2u];
                    let _e174 = (bitcast<u32>(_e172) & 2147483647u);
                    let _e176 = select(_e146, _e139, (_e146 < _e139));
                    let _e178 = select(_e153, _e176, (_e153 < _e176));
                    let _e180 = select(_e160, _e178, (_e160 < _e178));
                    let _e182 = select(_e167, _e180, (_e167 < _e180));
                    let _e184 = select(_e174, _e182, (_e174 < _e182));
                    let _e188 = global_3.member[_e127].member_1;
                    let _e190 = (bitcast<u32>(_e188) & 2147483647u);
                    let _e197 = global_3.member[_e127].member_3;
                    let _e203 = (((select(_e190, _e184, (_e190 < _e184)) < 2139095040u) && ((bitcast<u32>(_e197) & 2147483647u) <= 2139095040u)) && (_e178 > 0u));
                    if _e203 {
                        let _e206 = (bitcast<u32>(bitcast<f32>(_e178)) & 2147483647u);
                        if (_e206 >= 8388608u) {
                            phi_332_ = (bitcast<i32>((_e206 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_332_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e206)), 32u, (_e206 == 0u))));
                        }
                        let _e220 = phi_332_;
                        phi_333_ = _e220;
                    } else {
                        phi_333_ = 0i;
                    }
                    let _e222 = phi_333_;
                    let _e223 = (_e139 == _e178);
                    if _e223 {
                        phi_343_ = true;
                    } else {
                        phi_343_ = (_e146 == _e178);
                    }
                    let _e226 = phi_343_;
                    let _e227 = select(1u, 0u, _e223);
                    if _e226 {
                        let _e228 = (_e227 + 1u);
                        phi_353_ = _e228;
                        phi_354_ = _e228;
                        phi_356_ = select(true, false, (_e228 == 2u));
                    } else {
                        phi_353_ = u32();
                        phi_354_ = 0u;
                        phi_356_ = true;
                    }
                    let _e232 = phi_353_;
                    let _e234 = phi_354_;
                    let _e236 = phi_356_;
                    if _e236 {
                        phi_361_ = (_e234 + 1u);
                    } else {
                        phi_361_ = 0u;
                    }
                    let _e240 = phi_361_;
                    let _e241 = select(_e232, _e234, _e236);
                    let _e242 = select(_e227, select(2u, _e227, _e226), _e236);
                    if (_e117 < -126i) {
                        phi_373_ = -126i;
                    } else {
                        phi_373_ = select(_e117, 127i, (_e117 > 127i));
                    }
                    let _e247 = phi_373_;
                    let _e252 = bitcast<f32>((bitcast<u32>((_e247 + 127i)) << bitcast<u32>(23i)));
                    let _e258 = bitcast<f32>((bitcast<u32>(((_e117 - _e247) + 127i)) << bitcast<u32>(23i)));
                    let _e259 = -(_e222);
                    if (_e259 < -126i) {
                        phi_393_ = -126i;
                    } else {
                        phi_393_ = select(_e259, 127i, (_e259 > 127i));
                    }
                    let _e264 = phi_393_;
                    let _e269 = bitcast<f32>((bitcast<u32>((_e264 + 127i)) << bitcast<u32>(23i)));
                    let _e275 = bitcast<f32>((bitcast<u32>(((_e259 - _e264) + 127i)) << bitcast<u32>(23i)));
                    let _e279 = global_3.member[_e127].member;
                    let _e280 = (_e241 == 0u);
                    if _e280 {
                        phi_411_ = _e279[0];
                    } else {
                        phi_411_ = _e279[1];
                    }
                    let _e284 = phi_411_;
                    let _e285 = (_e241 == 2u);
                    if _e285 {
                        phi_417_ = _e279[2];
                    } else {
                        phi_417_ = _e284;
                    }
                    let _e288 = phi_417_;
                    let _e290 = ((_e288 * _e252) * _e258);
                    let _e291 = global_3.member[_e127].member_2;
                    if _e280 {
                        phi_428_ = _e291[0];
                    } else {
                        phi_428_ = _e291[1];
                    }
                    let _e295 = phi_428_;
                    if _e285 {
                        phi_434_ = _e291[2];
                    } else {
                        phi_434_ = _e295;
                    }
                    let _e298 = phi_434_;
                    let _e300 = ((_e298 * _e269) * _e275);
                    let _e304 = (bitcast<f32>((bitcast<u32>(_e300) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e304 {
                        let _e308 = (bitcast<f32>((bitcast<u32>(_e290) & 2147483647u)) * 0.00000011920929f);
                        phi_457_ = select(0.00000000000011368684f, _e308, (_e308 > 0.00000000000011368684f));
                    } else {
                        phi_457_ = 0f;
                    }
                    let _e312 = phi_457_;
                    let _e313 = (_e290 + _e312);
                    let _e314 = (_e290 - _e312);
                    let _e315 = select(_e300, 0f, _e304);
                    if _e304 {
                        phi_468_ = 38685626000000000000000000f;
                    } else {
                        phi_468_ = (1f / _e300);
                    }
                    let _e318 = phi_468_;
                    let _e319 = (_e240 == 0u);
                    if _e319 {
                        phi_477_ = _e279[0];
                    } else {
                        phi_477_ = _e279[1];
                    }
                    let _e323 = phi_477_;
                    let _e324 = (_e240 == 2u);
                    if _e324 {
                        phi_483_ = _e279[2];
                    } else {
                        phi_483_ = _e323;
                    }
                    let _e327 = phi_483_;
                    let _e329 = ((_e327 * _e252) * _e258);
                    if _e319 {
                        phi_494_ = _e291[0];
                    } else {
                        phi_494_ = _e291[1];
                    }
                    let _e333 = phi_494_;
                    if _e324 {
                        phi_500_ = _e291[2];
                    } else {
                        phi_500_ = _e333;
                    }
                    let _e336 = phi_500_;
                    let _e338 = ((_e336 * _e269) * _e275);
                    let _e342 = (bitcast<f32>((bitcast<u32>(_e338) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e342 {
                        let _e346 = (bitcast<f32>((bitcast<u32>(_e329) & 2147483647u)) * 0.00000011920929f);
                        phi_523_ = select(0.00000000000011368684f, _e346, (_e346 > 0.00000000000011368684f));
                    } else {
                        phi_523_ = 0f;
                    }
                    let _e350 = phi_523_;
                    let _e351 = (_e329 + _e350);
                    let _e352 = (_e329 - _e350);
                    let _e353 = select(_e338, 0f, _e342);
                    if _e342 {
                        phi_534_ = 38685626000000000000000000f;
                    } else {
                        phi_534_ = (1f / _e338);
                    }
                    let _e356 = phi_534_;
                    let _e357 = (_e242 == 0u);
                    if _e357 {
                        phi_543_ = _e279[0];
                    } else {
                        phi_543_ = _e279[1];
                    }
                    let _e361 = phi_543_;
                    let _e362 = (_e242 == 2u);
                    if _e362 {
                        phi_549_ = _e279[2];
                    } else {
                        phi_549_ = _e361;
                    }
                    let _e365 = phi_549_;
                    let _e367 = ((_e365 * _e252) * _e258);
                    if _e357 {
                        phi_560_ = _e291[0];
                    } else {
                        phi_560_ = _e291[1];
                    }
                    let _e371 = phi_560_;
                    if _e362 {
                        phi_566_ = _e291[2];
                    } else {
                        phi_566_ = _e371;
                    }
                    let _e374 = phi_566_;
                    let _e376 = ((_e374 * _e269) * _e275);
                    let _e380 = (bitcast<f32>((bitcast<u32>(_e376) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e380 {
                        let _e384 = (bitcast<f32>((bitcast<u32>(_e367) & 2147483647u)) * 0.00000011920929f);
                        phi_589_ = select(0.00000000000011368684f, _e384, (_e384 > 0.00000000000011368684f));
                    } else {
                        phi_589_ = 0f;
                    }
                    let _e388 = phi_589_;
                    let _e389 = (_e367 + _e388);
                    let _e390 = (_e367 - _e388);
                    let _e391 = select(_e376, 0f, _e380);
                    if _e380 {
                        phi_600_ = 38685626000000000000000000f;
                    } else {
                        phi_600_ = (1f / _e376);
                    }
                    let _e394 = phi_600_;
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
                        phi_700_ = select(-340282350000000000000000000000000000000f, _e435, (_e435 > -340282350000000000000000000000000000000f));
                        phi_701_ = select(-340282350000000000000000000000000000000f, _e428, (_e428 > -340282350000000000000000000000000000000f));
                    } else {
                        phi_700_ = 0f;
                        phi_701_ = 1f;
                    }
                    let _e439 = phi_700_;
                    let _e441 = phi_701_;
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
                    phi_3077_ = false;
                    phi_774_ = type_32(_e439, false);
                    phi_777_ = type_49(type_41(array<f32, 3>(_e449, _e453, _e457), array<f32, 3>(_e461, _e463, _e465)), select(0u, 2147483648u, (_e78 == 0u)));
                    phi_779_ = ((3u * _e78) + 1u);
                    phi_781_ = (_e441 <= _e439);
                    phi_783_ = 0u;
                    loop {
                        let _e473 = phi_3077_;
                        let _e475 = phi_774_;
                        let _e477 = phi_777_;
                        let _e479 = phi_779_;
                        let _e481 = phi_781_;
                        let _e483 = phi_783_;
                        local_11 = _e475;
                        if _e481 {
                            phi_794_ = true;
                        } else {
                            phi_794_ = (_e483 > 0u);
                        }
                        let _e486 = phi_794_;
                        if _e486 {
                            let _e487 = (_e479 > 0u);
                            if _e487 {
                                if _e481 {
                                    phi_880_ = _e477;
                                    phi_881_ = _e481;
                                    phi_882_ = _e483;
                                } else {
                                    let _e488 = (_e483 - 1u);
                                    let _e489 = (_e488 % 128u);
                                    let _e490 = (_e489 < 128u);
                                    if _e490 {
                                    } else {
                                        phi_3228_ = true;
                                        break;
                                    }
                                    let _e492 = local_6[_e489];
                                    if _e490 {
                                    } else {
                                        phi_3228_ = true;
                                        break;
                                    }
                                    let _e494 = local_5[_e489];
                                    if _e490 {
                                    } else {
                                        phi_3228_ = true;
                                        break;
                                    }
                                    let _e496 = local_4[_e489];
                                    if _e490 {
                                    } else {
                                        phi_3228_ = true;
                                        break;
                                    }
                                    let _e498 = local_3[_e489];
                                    if _e490 {
                                    } else {
                                        phi_3228_ = true;
                                        break;
                                    }
                                    let _e501 = local_2[_e489];
                                    if _e490 {
                                    } else {
                                        phi_3228_ = true;
                                        break;
                                    }
                                    let _e503 = local_1[_e489];
                                    if _e490 {
                                    } else {
                                        phi_3228_ = true;
                                        break;
                                    }
                                    let _e505 = local[_e489];
                                    if _e490 {
                                    } else {
                                        phi_3228_ = true;
                                        break;
                                    }
                                    let _e510 = local_7[_e489];
                                    phi_880_ = type_49(type_41(array<f32, 3>(_e494, _e496, _e498), array<f32, 3>(_e501, _e503, _e505)), _e492);
                                    phi_881_ = (_e510 <= _e475.member);
                                    phi_882_ = _e488;
                                }
                                let _e514 = phi_880_;
                                let _e516 = phi_881_;
                                let _e518 = phi_882_;
                                if _e516 {
                                    if ((_e514.member_1 & 2147483648u) != 0u) {
                                        phi_901_ = _e475;
                                        phi_904_ = type_7(0u, ((_e514.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e871 = phi_901_;
                                            let _e873 = phi_904_;
                                            local_10 = _e871;
                                            local_12 = _e871;
                                            if (_e873.member < _e873.member_1) {
                                                phi_905_ = type_7((_e873.member + 1u), _e873.member_1);
                                                phi_927_ = type_7(1u, _e873.member);
                                            } else {
                                                phi_905_ = _e873;
                                                phi_927_ = type_7(0u, type_7().member_1);
                                            }
                                            let _e886 = phi_905_;
                                            let _e888 = phi_927_;
                                            let _e892 = (bitcast<i32>(_e888.member) != 0i);
                                            if _e892 {
                                                let _e893 = ((_e514.member_1 & 268435455u) + _e888.member_1);
                                                let _e894 = (_e893 < arrayLength((&global_6.member)));
                                                if _e894 {
                                                    if _e894 {
                                                    } else {
                                                        phi_3071_ = true;
                                                        break;
                                                    }
                                                    let _e897 = global_6.member[_e893].member_1;
                                                    phi_952_ = _e897;
                                                } else {
                                                    phi_952_ = 4294967295u;
                                                }
                                                let _e899 = phi_952_;
                                                if _e894 {
                                                    if _e894 {
                                                    } else {
                                                        phi_3071_ = true;
                                                        break;
                                                    }
                                                    let _e901 = global_6.member[_e893];
                                                    phi_968_ = _e901;
                                                } else {
                                                    phi_968_ = type_43(array<u32, 3>(0u, 0u, 0u), 4294967295u);
                                                }
                                                let _e903 = phi_968_;
                                                let _e915 = ((10u * _e241) & 31u);
                                                let _e918 = ((_e903.member[0] >> bitcast<u32>(_e915)) & 1023u);
                                                let _e923 = bitcast<f32>((bitcast<u32>(((_e514.member.member_1[0] - _e514.member.member[0]) * 0.0009775171f)) ^ _e113));
                                                let _e929 = (_e514.member.member[0] + bitcast<f32>((bitcast<u32>((f32(_e918) * _e923)) ^ _e113)));
                                                let _e933 = select(select(_e514.member.member_1[0], _e929, (_e929 < _e514.member.member_1[0])), _e514.member.member_1[0], (_e918 == 1023u));
                                                let _e935 = ((10u * _e240) & 31u);
                                                let _e938 = ((_e903.member[0] >> bitcast<u32>(_e935)) & 1023u);
                                                let _e943 = bitcast<f32>((bitcast<u32>(((_e514.member.member_1[1] - _e514.member.member[1]) * 0.0009775171f)) ^ _e113));
                                                let _e949 = (_e514.member.member[1] + bitcast<f32>((bitcast<u32>((f32(_e938) * _e943)) ^ _e113)));
                                                let _e953 = select(select(_e514.member.member_1[1], _e949, (_e949 < _e514.member.member_1[1])), _e514.member.member_1[1], (_e938 == 1023u));
                                                let _e955 = ((10u * _e242) & 31u);
                                                let _e958 = ((_e903.member[0] >> bitcast<u32>(_e955)) & 1023u);
                                                let _e963 = bitcast<f32>((bitcast<u32>(((_e514.member.member_1[2] - _e514.member.member[2]) * 0.0009775171f)) ^ _e113));
                                                let _e969 = (_e514.member.member[2] + bitcast<f32>((bitcast<u32>((f32(_e958) * _e963)) ^ _e113)));
                                                let _e973 = select(select(_e514.member.member_1[2], _e969, (_e969 < _e514.member.member_1[2])), _e514.member.member_1[2], (_e958 == 1023u));
                                                let _e977 = ((_e903.member[1] >> bitcast<u32>(_e915)) & 1023u);
                                                let _e983 = (_e514.member.member[0] + bitcast<f32>((bitcast<u32>((f32(_e977) * _e923)) ^ _e113)));
                                                let _e987 = select(select(_e514.member.member_1[0], _e983, (_e983 < _e514.member.member_1[0])), _e514.member.member_1[0], (_e977 == 1023u));
                                                let _e990 = ((_e903.member[1] >> bitcast<u32>(_e935)) & 1023u);
                                                let _e996 = (_e514.member.member[1] + bitcast<f32>((bitcast<u32>((f32(_e990) * _e943)) ^ _e113)));
                                                let _e1000 = select(select(_e514.member.member_1[1], _e996, (_e996 < _e514.member.member_1[1])), _e514.member.member_1[1], (_e990 == 1023u));
                                                let _e1003 = ((_e903.member[1] >> bitcast<u32>(_e955)) & 1023u);
                                                let _e1009 = (_e514.member.member[2] + bitcast<f32>((bitcast<u32>((f32(_e1003) * _e963)) ^ _e113)));
                                                let _e1013 = select(select(_e514.member.member_1[2], _e1009, (_e1009 < _e514.member.member_1[2])), _e514.member.member_1[2], (_e1003 == 1023u));
                                                let _e1017 = ((_e903.member[2] >> bitcast<u32>(_e915)) & 1023u);
                                                let _e1023 = (_e514.member.member[0] + bitcast<f32>((bitcast<u32>((f32(_e1017) * _e923)) ^ _e113)));
                                                let _e1027 = select(select(_e514.member.member_1[0], _e1023, (_e1023 < _e514.member.member_1[0])), _e514.member.member_1[0], (_e1017 == 1023u));
                                                let _e1030 = ((_e903.member[2] >> bitcast<u32>(_e935)) & 1023u);
                                                let _e1036 = (_e514.member.member[1] + bitcast<f32>((bitcast<u32>((f32(_e1030) * _e943)) ^ _e113)));
                                                let _e1040 = select(select(_e514.member.member_1[1], _e1036, (_e1036 < _e514.member.member_1[1])), _e514.member.member_1[1], (_e1030 == 1023u));
                                                let _e1043 = ((_e903.member[2] >> bitcast<u32>(_e955)) & 1023u);
                                                let _e1049 = (_e514.member.member[2] + bitcast<f32>((bitcast<u32>((f32(_e1043) * _e963)) ^ _e113)));
                                                let _e1053 = select(select(_e514.member.member_1[2], _e1049, (_e1049 < _e514.member.member_1[2])), _e514.member.member_1[2], (_e1043 == 1023u));
                                                let _e1057 = (_e973 - _e367);
                                                let _e1060 = (((_e933 - _e290) * _e391) - (_e1057 * _e315));
                                                let _e1063 = (((_e953 - _e329) * _e391) - (_e1057 * _e353));
                                                let _e1066 = (_e1013 - _e367);
                                                let _e1069 = (((_e987 - _e290) * _e391) - (_e1066 * _e315));
                                                let _e1072 = (((_e1000 - _e329) * _e391) - (_e1066 * _e353));
                                                let _e1075 = (_e1053 - _e367);
                                                let _e1078 = (((_e1027 - _e290) * _e391) - (_e1075 * _e315));
                                                let _e1081 = (((_e1040 - _e329) * _e391) - (_e1075 * _e353));
                                                let _e1082 = (_e1078 * _e1072);
                                                let _e1083 = (_e1081 * _e1069);
                                                let _e1084 = (_e1060 * _e1081);
                                                let _e1085 = (_e1063 * _e1078);
                                                let _e1086 = (_e1069 * _e1063);
                                                let _e1087 = (_e1072 * _e1060);
                                                let _e1092 = (((_e1082 >= _e1083) && (_e1084 >= _e1085)) && (_e1086 >= _e1087));
                                                if (_e1092 || (((_e1082 <= _e1083) && (_e1084 <= _e1085)) && (_e1086 <= _e1087))) {
                                                    let _e1099 = select(-1f, 1f, _e1092);
                                                    let _e1101 = ((_e1082 - _e1083) * _e1099);
                                                    let _e1103 = select(0f, _e1101, (_e1101 > 0f));
                                                    let _e1105 = ((_e1084 - _e1085) * _e1099);
                                                    let _e1107 = select(0f, _e1105, (_e1105 > 0f));
                                                    let _e1109 = ((_e1086 - _e1087) * _e1099);
                                                    let _e1111 = select(0f, _e1109, (_e1109 > 0f));
                                                    let _e1113 = ((_e1103 + _e1107) + _e1111);
                                                    if (_e1113 < 0.000000000000000000000000000000000000011754944f) {
                                                        phi_2028_ = type_21();
                                                        phi_2029_ = true;
                                                        phi_2030_ = false;
                                                    } else {
                                                        let _e1116 = select(_e1069, _e1060, (_e1060 < _e1069));
                                                        if (select(_e1078, _e1116, (_e1116 < _e1078)) > 0f) {
                                                            phi_1344_ = true;
                                                        } else {
                                                            let _e1121 = select(_e1069, _e1060, (_e1060 > _e1069));
                                                            phi_1344_ = (select(_e1078, _e1121, (_e1121 > _e1078)) < 0f);
                                                        }
                                                        let _e1126 = phi_1344_;
                                                        if _e1126 {
                                                            phi_2025_ = type_21();
                                                            phi_2026_ = true;
                                                            phi_2027_ = false;
                                                        } else {
                                                            let _e1128 = select(_e1072, _e1063, (_e1063 < _e1072));
                                                            if (select(_e1081, _e1128, (_e1128 < _e1081)) > 0f) {
                                                                phi_1373_ = true;
                                                            } else {
                                                                let _e1133 = select(_e1072, _e1063, (_e1063 > _e1072));
                                                                phi_1373_ = (select(_e1081, _e1133, (_e1133 > _e1081)) < 0f);
                                                            }
                                                            let _e1138 = phi_1373_;
                                                            if _e1138 {
                                                                phi_2023_ = type_21();
                                                                phi_2024_ = false;
                                                            } else {
                                                                let _e1140 = select(_e987, _e933, (_e933 < _e987));
                                                                let _e1144 = select(_e987, _e933, (_e933 > _e987));
                                                                let _e1148 = select(_e1000, _e953, (_e953 < _e1000));
                                                                let _e1152 = select(_e1000, _e953, (_e953 > _e1000));
                                                                let _e1156 = select(_e1013, _e973, (_e973 < _e1013));
                                                                let _e1160 = select(_e1013, _e973, (_e973 > _e1013));
                                                                let _e1165 = ((select(_e1027, _e1140, (_e1140 < _e1027)) - _e313) * _e318);
                                                                let _e1166 = ((select(_e1027, _e1144, (_e1144 > _e1027)) - _e314) * _e318);
                                                                let _e1169 = ((select(_e1040, _e1148, (_e1148 < _e1040)) - _e351) * _e356);
                                                                let _e1170 = ((select(_e1040, _e1152, (_e1152 > _e1040)) - _e352) * _e356);
                                                                let _e1173 = ((select(_e1053, _e1156, (_e1156 < _e1053)) - _e389) * _e394);
                                                                let _e1174 = ((select(_e1053, _e1160, (_e1160 > _e1053)) - _e390) * _e394);
                                                                let _e1176 = select(_e1174, _e1173, (_e1173 < _e1174));
                                                                let _e1178 = select(_e1174, _e1173, (_e1173 > _e1174));
                                                                let _e1180 = select(_e1166, _e1165, (_e1165 < _e1166));
                                                                let _e1182 = select(_e1170, _e1169, (_e1169 < _e1170));
                                                                let _e1184 = select(_e1182, _e1180, (_e1180 > _e1182));
                                                                let _e1186 = select(_e1176, _e1184, (_e1184 > _e1176));
                                                                let _e1188 = select(_e1166, _e1165, (_e1165 > _e1166));
                                                                let _e1190 = select(_e1170, _e1169, (_e1169 > _e1170));
                                                                let _e1192 = select(_e1190, _e1188, (_e1188 < _e1190));
                                                                let _e1194 = select(_e1178, _e1192, (_e1192 < _e1178));
                                                                let _e1195 = -(_e1176);
                                                                let _e1201 = select(_e441, _e1186, (_e1186 > _e441));
                                                                if (_e1201 > (_e1194 + (select(_e1195, _e1178, (_e1178 > _e1195)) * 0.0000019073523f))) {
                                                                    phi_2018_ = type_21();
                                                                    phi_2019_ = true;
                                                                } else {
                                                                    let _e1203 = (_e1201 > _e871.member);
                                                                    if _e1203 {
                                                                        phi_2017_ = type_21();
                                                                    } else {
                                                                        let _e1204 = vec3<f32>(_e933, _e953, _e973);
                                                                        let _e1205 = vec3<f32>(_e987, _e1000, _e1013);
                                                                        let _e1206 = vec3<f32>(_e1027, _e1040, _e1053);
                                                                        let _e1207 = (_e987 - _e933);
                                                                        let _e1208 = (_e1000 - _e953);
                                                                        let _e1209 = (_e1013 - _e973);
                                                                        let _e1210 = vec3<f32>(_e1207, _e1208, _e1209);
                                                                        let _e1211 = (_e1027 - _e987);
                                                                        let _e1212 = (_e1040 - _e1000);
                                                                        let _e1213 = (_e1053 - _e1013);
                                                                        let _e1214 = vec3<f32>(_e1211, _e1212, _e1213);
                                                                        let _e1215 = (_e933 - _e1027);
                                                                        let _e1216 = (_e953 - _e1040);
                                                                        let _e1217 = (_e973 - _e1053);
                                                                        let _e1218 = vec3<f32>(_e1215, _e1216, _e1217);
                                                                        let _e1221 = bitcast<f32>((bitcast<u32>(_e1207) & 2147483647u));
                                                                        let _e1224 = bitcast<f32>((bitcast<u32>(_e1208) & 2147483647u));
                                                                        let _e1226 = select(_e1224, _e1221, (_e1221 > _e1224));
                                                                        let _e1229 = bitcast<f32>((bitcast<u32>(_e1209) & 2147483647u));
                                                                        let _e1231 = select(_e1229, _e1226, (_e1226 > _e1229));
                                                                        let _e1234 = bitcast<f32>((bitcast<u32>(_e1211) & 2147483647u));
                                                                        let _e1237 = bitcast<f32>((bitcast<u32>(_e1212) & 2147483647u));
                                                                        let _e1239 = select(_e1237, _e1234, (_e1234 > _e1237));
                                                                        let _e1242 = bitcast<f32>((bitcast<u32>(_e1213) & 2147483647u));
                                                                        let _e1244 = select(_e1242, _e1239, (_e1239 > _e1242));
                                                                        let _e1247 = bitcast<f32>((bitcast<u32>(_e1215) & 2147483647u));
                                                                        let _e1250 = bitcast<f32>((bitcast<u32>(_e1216) & 2147483647u));
                                                                        let _e1252 = select(_e1250, _e1247, (_e1247 > _e1250));
                                                                        let _e1255 = bitcast<f32>((bitcast<u32>(_e1217) & 2147483647u));
                                                                        let _e1257 = select(_e1255, _e1252, (_e1252 > _e1255));
                                                                        let _e1259 = select(_e1244, _e1231, (_e1231 > _e1244));
                                                                        let _e1261 = select(_e1257, _e1259, (_e1259 > _e1257));
                                                                        if (_e1231 == _e1261) {
                                                                            phi_1750_ = _e1072;
                                                                            phi_1751_ = _e1069;
                                                                            phi_1752_ = _e1063;
                                                                            phi_1753_ = _e1060;
                                                                            phi_1754_ = _e1204;
                                                                            phi_1755_ = _e1218;
                                                                            phi_1756_ = _e1214;
                                                                            phi_1757_ = _e1210;
                                                                        } else {
                                                                            let _e1263 = (_e1244 == _e1261);
                                                                            let _e1268 = vec3(_e1263);
                                                                            phi_1750_ = select(_e1063, _e1081, _e1263);
                                                                            phi_1751_ = select(_e1060, _e1078, _e1263);
                                                                            phi_1752_ = select(_e1081, _e1072, _e1263);
                                                                            phi_1753_ = select(_e1078, _e1069, _e1263);
                                                                            phi_1754_ = select(_e1206, _e1205, _e1268);
                                                                            phi_1755_ = select(_e1214, _e1210, _e1268);
                                                                            phi_1756_ = select(_e1210, _e1218, _e1268);
                                                                            phi_1757_ = select(_e1218, _e1214, _e1268);
                                                                        }
                                                                        let _e1274 = phi_1750_;
                                                                        let _e1276 = phi_1751_;
                                                                        let _e1278 = phi_1752_;
                                                                        let _e1280 = phi_1753_;
                                                                        let _e1282 = phi_1754_;
                                                                        let _e1284 = phi_1755_;
                                                                        let _e1286 = phi_1756_;
                                                                        let _e1288 = phi_1757_;
                                                                        let _e1295 = ((_e1286.y * _e1284.z) - (_e1284.y * _e1286.z));
                                                                        let _e1300 = ((_e1286.z * _e1284.x) - (_e1284.z * _e1286.x));
                                                                        let _e1303 = ((_e1286.x * _e1284.y) - (_e1284.x * _e1286.y));
                                                                        if (_e1103 >= _e1107) {
                                                                            phi_1788_ = select(true, false, (_e1103 >= _e1111));
                                                                        } else {
                                                                            phi_1788_ = true;
                                                                        }
                                                                        let _e1308 = phi_1788_;
                                                                        if _e1308 {
                                                                            phi_1797_ = select(_e1206, _e1205, vec3((_e1107 >= _e1111)));
                                                                        } else {
                                                                            phi_1797_ = _e1204;
                                                                        }
                                                                        let _e1313 = phi_1797_;
                                                                        let _e1324 = (((_e1295 * (_e1313.x - _e290)) + (_e1300 * (_e1313.y - _e329))) + (_e1303 * (_e1313.z - _e367)));
                                                                        let _e1329 = (((_e1295 * _e315) + (_e1300 * _e353)) + (_e1303 * _e391));
                                                                        let _e1330 = (_e1276 - _e1280);
                                                                        let _e1331 = (_e1274 - _e1278);
                                                                        let _e1339 = (-(((_e1280 * _e1330) + (_e1278 * _e1331))) / ((_e1330 * _e1330) + (_e1331 * _e1331)));
                                                                        let _e1341 = select(1f, _e1339, (_e1339 < 1f));
                                                                        let _e1343 = select(0f, _e1341, (_e1341 > 0f));
                                                                        let _e1356 = ((_e1282.x + (_e1288.x * _e1343)) - _e290);
                                                                        let _e1357 = ((_e1282.y + (_e1288.y * _e1343)) - _e329);
                                                                        let _e1358 = ((_e1282.z + (_e1288.z * _e1343)) - _e367);
                                                                        let _e1359 = (_e1358 / _e391);
                                                                        let _e1371 = bitcast<f32>((bitcast<u32>(_e1356) & 2147483647u));
                                                                        let _e1374 = bitcast<f32>((bitcast<u32>(_e1357) & 2147483647u));
                                                                        let _e1376 = select(_e1374, _e1371, (_e1371 > _e1374));
                                                                        let _e1379 = bitcast<f32>((bitcast<u32>(_e1358) & 2147483647u));
                                                                        let _e1381 = select(_e1379, _e1376, (_e1376 > _e1379));
                                                                        let _e1387 = bitcast<f32>((bitcast<u32>(_e1295) & 2147483647u));
                                                                        let _e1390 = bitcast<f32>((bitcast<u32>(_e1300) & 2147483647u));
                                                                        let _e1392 = select(_e1390, _e1387, (_e1387 > _e1390));
                                                                        let _e1395 = bitcast<f32>((bitcast<u32>(_e1303) & 2147483647u));
                                                                        if (bitcast<f32>((bitcast<u32>(((((_e1295 * _e1356) + (_e1300 * _e1357)) + (_e1303 * _e1358)) - _e1324)) & 2147483647u)) <= ((0.0000009536743f * select(_e1261, _e1381, (_e1381 > _e1261))) * select(_e1395, _e1392, (_e1392 > _e1395)))) {
                                                                            let _e1405 = bitcast<f32>((bitcast<u32>(_e1286.x) & 2147483647u));
                                                                            let _e1408 = bitcast<f32>((bitcast<u32>(_e1286.y) & 2147483647u));
                                                                            let _e1410 = select(_e1408, _e1405, (_e1405 > _e1408));
                                                                            let _e1413 = bitcast<f32>((bitcast<u32>(_e1286.z) & 2147483647u));
                                                                            let _e1419 = bitcast<f32>((bitcast<u32>(_e1284.x) & 2147483647u));
                                                                            let _e1422 = bitcast<f32>((bitcast<u32>(_e1284.y) & 2147483647u));
                                                                            let _e1424 = select(_e1422, _e1419, (_e1419 > _e1422));
                                                                            let _e1427 = bitcast<f32>((bitcast<u32>(_e1284.z) & 2147483647u));
                                                                            let _e1431 = (bitcast<f32>((bitcast<u32>(_e1329) & 2147483647u)) > ((0.0000038146973f * select(_e1413, _e1410, (_e1410 > _e1413))) * select(_e1427, _e1424, (_e1424 > _e1427))));
                                                                            if _e1431 {
                                                                                phi_1962_ = (_e1324 / _e1329);
                                                                            } else {
                                                                                phi_1962_ = f32();
                                                                            }
                                                                            let _e1434 = phi_1962_;
                                                                            phi_1964_ = _e1434;
                                                                            phi_1965_ = select(true, false, _e1431);
                                                                        } else {
                                                                            phi_1964_ = f32();
                                                                            phi_1965_ = true;
                                                                        }
                                                                        let _e1437 = phi_1964_;
                                                                        let _e1439 = phi_1965_;
                                                                        if _e1439 {
                                                                            let _e1447 = (((_e1295 * (_e1356 - (_e315 * _e1359))) + (_e1300 * (_e1357 - (_e353 * _e1359)))) / _e1329);
                                                                            if (bitcast<f32>((bitcast<u32>(_e1447) & 2147483647u)) <= _e1261) {
                                                                                phi_1985_ = (_e1359 + _e1447);
                                                                            } else {
                                                                                phi_1985_ = _e1359;
                                                                            }
                                                                            let _e1454 = phi_1985_;
                                                                            phi_1986_ = _e1454;
                                                                        } else {
                                                                            phi_1986_ = _e1437;
                                                                        }
                                                                        let _e1456 = phi_1986_;
                                                                        let _e1458 = select(_e1194, _e1456, (_e1456 < _e1194));
                                                                        let _e1460 = select(_e1186, _e1458, (_e1458 > _e1186));
                                                                        if (_e1460 >= _e441) {
                                                                            let _e1462 = (_e1460 <= _e871.member);
                                                                            if _e1462 {
                                                                                let _e1463 = (1f / _e1113);
                                                                                phi_2009_ = type_21(_e1460, (_e1107 * _e1463), (_e1111 * _e1463), _e899);
                                                                            } else {
                                                                                phi_2009_ = type_21();
                                                                            }
                                                                            let _e1468 = phi_2009_;
                                                                            phi_2011_ = _e1468;
                                                                            phi_2012_ = select(true, false, _e1462);
                                                                        } else {
                                                                            phi_2011_ = type_21();
                                                                            phi_2012_ = true;
                                                                        }
                                                                        let _e1471 = phi_2011_;
                                                                        let _e1473 = phi_2012_;
                                                                        if _e1473 {
                                                                            phi_2016_ = type_21(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                        } else {
                                                                            phi_2016_ = _e1471;
                                                                        }
                                                                        let _e1475 = phi_2016_;
                                                                        phi_2017_ = _e1475;
                                                                    }
                                                                    let _e1477 = phi_2017_;
                                                                    phi_2018_ = _e1477;
                                                                    phi_2019_ = _e1203;
                                                                }
                                                                let _e1479 = phi_2018_;
                                                                let _e1481 = phi_2019_;
                                                                phi_2023_ = _e1479;
                                                                phi_2024_ = _e1481;
                                                            }
                                                            let _e1483 = phi_2023_;
                                                            let _e1485 = phi_2024_;
                                                            phi_2025_ = _e1483;
                                                            phi_2026_ = _e1138;
                                                            phi_2027_ = _e1485;
                                                        }
                                                        let _e1487 = phi_2025_;
                                                        let _e1489 = phi_2026_;
                                                        let _e1491 = phi_2027_;
                                                        phi_2028_ = _e1487;
                                                        phi_2029_ = _e1489;
                                                        phi_2030_ = _e1491;
                                                    }
                                                    let _e1493 = phi_2028_;
                                                    let _e1495 = phi_2029_;
                                                    let _e1497 = phi_2030_;
                                                    phi_2038_ = _e1493;
                                                    phi_2039_ = select(_e1497, true, _e1495);
                                                } else {
                                                    phi_2038_ = type_21();
                                                    phi_2039_ = true;
                                                }
                                                let _e1500 = phi_2038_;
                                                let _e1502 = phi_2039_;
                                                if _e1502 {
                                                    phi_2043_ = type_21(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                } else {
                                                    phi_2043_ = _e1500;
                                                }
                                                let _e1504 = phi_2043_;
                                                if (_e1504.member_3 != 4294967295u) {
                                                    if (_e899 != 4294967295u) {
                                                        phi_2054_ = type_32(_e871.member, true);
                                                    } else {
                                                        phi_2054_ = _e871;
                                                    }
                                                    let _e1512 = phi_2054_;
                                                    phi_2055_ = _e1512;
                                                } else {
                                                    phi_2055_ = _e871;
                                                }
                                                let _e1514 = phi_2055_;
                                                phi_902_ = _e1514;
                                            } else {
                                                phi_902_ = type_32();
                                            }
                                            let _e1516 = phi_902_;
                                            continue;
                                            continuing {
                                                phi_901_ = _e1516;
                                                phi_904_ = _e886;
                                                phi_3071_ = _e473;
                                                break if !(_e892);
                                            }
                                        }
                                        let _e1519 = phi_3071_;
                                        phi_3228_ = _e1519;
                                        if _e1519 {
                                            break;
                                        }
                                        let _e1521 = local_10;
                                        phi_3232_ = _e1519;
                                        let _e1680 = local_12;
                                        phi_3005_ = _e1680;
                                        phi_3006_ = _e514;
                                        phi_3007_ = false;
                                        phi_3008_ = select(_e518, 0u, _e1521.member_1);
                                    } else {
                                        let _e528 = (_e514.member_1 < _e78);
                                        if _e528 {
                                            if _e528 {
                                            } else {
                                                phi_3228_ = true;
                                                break;
                                            }
                                            let _e530 = global_5.member[_e514.member_1];
                                            phi_2075_ = _e530;
                                        } else {
                                            phi_2075_ = type_36(array<u32, 2>(0u, 0u), array<u32, 2>(0u, 0u), 2147483648u, 2147483648u);
                                        }
                                        let _e532 = phi_2075_;
                                        let _e547 = ((10u * _e241) & 31u);
                                        let _e550 = ((_e532.member[0] >> bitcast<u32>(_e547)) & 1023u);
                                        let _e555 = bitcast<f32>((bitcast<u32>(((_e514.member.member_1[0] - _e514.member.member[0]) * 0.0009775171f)) ^ _e113));
                                        let _e561 = (_e514.member.member[0] + bitcast<f32>((bitcast<u32>((f32(_e550) * _e555)) ^ _e113)));
                                        let _e565 = select(select(_e514.member.member_1[0], _e561, (_e561 < _e514.member.member_1[0])), _e514.member.member_1[0], (_e550 == 1023u));
                                        let _e567 = ((10u * _e240) & 31u);
                                        let _e570 = ((_e532.member[0] >> bitcast<u32>(_e567)) & 1023u);
                                        let _e575 = bitcast<f32>((bitcast<u32>(((_e514.member.member_1[1] - _e514.member.member[1]) * 0.0009775171f)) ^ _e113));
                                        let _e581 = (_e514.member.member[1] + bitcast<f32>((bitcast<u32>((f32(_e570) * _e575)) ^ _e113)));
                                        let _e585 = select(select(_e514.member.member_1[1], _e581, (_e581 < _e514.member.member_1[1])), _e514.member.member_1[1], (_e570 == 1023u));
                                        let _e587 = ((10u * _e242) & 31u);
                                        let _e590 = ((_e532.member[0] >> bitcast<u32>(_e587)) & 1023u);
                                        let _e595 = bitcast<f32>((bitcast<u32>(((_e514.member.member_1[2] - _e514.member.member[2]) * 0.0009775171f)) ^ _e113));
                                        let _e601 = (_e514.member.member[2] + bitcast<f32>((bitcast<u32>((f32(_e590) * _e595)) ^ _e113)));
                                        let _e605 = select(select(_e514.member.member_1[2], _e601, (_e601 < _e514.member.member_1[2])), _e514.member.member_1[2], (_e590 == 1023u));
                                        let _e608 = ((_e532.member[1] >> bitcast<u32>(_e547)) & 1023u);
                                        let _e614 = (_e514.member.member[0] + bitcast<f32>((bitcast<u32>((f32(_e608) * _e555)) ^ _e113)));
                                        let _e618 = select(select(_e514.member.member_1[0], _e614, (_e614 < _e514.member.member_1[0])), _e514.member.member_1[0], (_e608 == 1023u));
                                        let _e621 = ((_e532.member[1] >> bitcast<u32>(_e567)) & 1023u);
                                        let _e627 = (_e514.member.member[1] + bitcast<f32>((bitcast<u32>((f32(_e621) * _e575)) ^ _e113)));
                                        let _e631 = select(select(_e514.member.member_1[1], _e627, (_e627 < _e514.member.member_1[1])), _e514.member.member_1[1], (_e621 == 1023u));
                                        let _e634 = ((_e532.member[1] >> bitcast<u32>(_e587)) & 1023u);
                                        let _e640 = (_e514.member.member[2] + bitcast<f32>((bitcast<u32>((f32(_e634) * _e595)) ^ _e113)));
                                        let _e644 = select(select(_e514.member.member_1[2], _e640, (_e640 < _e514.member.member_1[2])), _e514.member.member_1[2], (_e634 == 1023u));
                                        let _e650 = ((_e532.member_1[0] >> bitcast<u32>(_e547)) & 1023u);
                                        let _e656 = (_e514.member.member[0] + bitcast<f32>((bitcast<u32>((f32(_e650) * _e555)) ^ _e113)));
                                        let _e660 = select(select(_e514.member.member_1[0], _e656, (_e656 < _e514.member.member_1[0])), _e514.member.member_1[0], (_e650 == 1023u));
                                        let _e663 = ((_e532.member_1[0] >> bitcast<u32>(_e567)) & 1023u);
                                        let _e669 = (_e514.member.member[1] + bitcast<f32>((bitcast<u32>((f32(_e663) * _e575)) ^ _e113)));
                                        let _e673 = select(select(_e514.member.member_1[1], _e669, (_e669 < _e514.member.member_1[1])), _e514.member.member_1[1], (_e663 == 1023u));
                                        let _e676 = ((_e532.member_1[0] >> bitcast<u32>(_e587)) & 1023u);
                                        let _e682 = (_e514.member.member[2] + bitcast<f32>((bitcast<u32>((f32(_e676) * _e595)) ^ _e113)));
                                        let _e686 = select(select(_e514.member.member_1[2], _e682, (_e682 < _e514.member.member_1[2])), _e514.member.member_1[2], (_e676 == 1023u));
                                        let _e689 = ((_e532.member_1[1] >> bitcast<u32>(_e547)) & 1023u);
                                        let _e695 = (_e514.member.member[0] + bitcast<f32>((bitcast<u32>((f32(_e689) * _e555)) ^ _e113)));
                                        let _e699 = select(select(_e514.member.member_1[0], _e695, (_e695 < _e514.member.member_1[0])), _e514.member.member_1[0], (_e689 == 1023u));
                                        let _e702 = ((_e532.member_1[1] >> bitcast<u32>(_e567)) & 1023u);
                                        let _e708 = (_e514.member.member[1] + bitcast<f32>((bitcast<u32>((f32(_e702) * _e575)) ^ _e113)));
                                        let _e712 = select(select(_e514.member.member_1[1], _e708, (_e708 < _e514.member.member_1[1])), _e514.member.member_1[1], (_e702 == 1023u));
                                        let _e715 = ((_e532.member_1[1] >> bitcast<u32>(_e587)) & 1023u);
                                        let _e721 = (_e514.member.member[2] + bitcast<f32>((bitcast<u32>((f32(_e715) * _e595)) ^ _e113)));
                                        let _e725 = select(select(_e514.member.member_1[2], _e721, (_e721 < _e514.member.member_1[2])), _e514.member.member_1[2], (_e715 == 1023u));
                                        let _e730 = type_49(type_41(array<f32, 3>(_e565, _e585, _e605), array<f32, 3>(_e618, _e631, _e644)), _e532.member_2);
                                        let _e735 = type_49(type_41(array<f32, 3>(_e660, _e673, _e686), array<f32, 3>(_e699, _e712, _e725)), _e532.member_3);
                                        let _e741 = ((_e565 - _e313) * _e318);
                                        let _e742 = ((_e660 - _e313) * _e318);
                                        let _e743 = ((_e618 - _e314) * _e318);
                                        let _e744 = ((_e699 - _e314) * _e318);
                                        let _e749 = ((_e585 - _e351) * _e356);
                                        let _e750 = ((_e673 - _e351) * _e356);
                                        let _e751 = ((_e631 - _e352) * _e356);
                                        let _e752 = ((_e712 - _e352) * _e356);
                                        let _e757 = ((_e605 - _e389) * _e394);
                                        let _e758 = ((_e686 - _e389) * _e394);
                                        let _e759 = ((_e644 - _e390) * _e394);
                                        let _e760 = ((_e725 - _e390) * _e394);
                                        let _e762 = select(_e759, _e757, (_e757 < _e759));
                                        let _e764 = select(_e760, _e758, (_e758 < _e760));
                                        let _e766 = select(_e759, _e757, (_e757 > _e759));
                                        let _e768 = select(_e760, _e758, (_e758 > _e760));
                                        let _e770 = select(_e743, _e741, (_e741 < _e743));
                                        let _e772 = select(_e744, _e742, (_e742 < _e744));
                                        let _e774 = select(_e751, _e749, (_e749 < _e751));
                                        let _e776 = select(_e752, _e750, (_e750 < _e752));
                                        let _e778 = select(_e774, _e770, (_e770 > _e774));
                                        let _e780 = select(_e776, _e772, (_e772 > _e776));
                                        let _e782 = select(_e762, _e778, (_e778 > _e762));
                                        let _e784 = select(_e764, _e780, (_e780 > _e764));
                                        let _e786 = select(_e743, _e741, (_e741 > _e743));
                                        let _e788 = select(_e744, _e742, (_e742 > _e744));
                                        let _e790 = select(_e751, _e749, (_e749 > _e751));
                                        let _e792 = select(_e752, _e750, (_e750 > _e752));
                                        let _e794 = select(_e790, _e786, (_e786 < _e790));
                                        let _e796 = select(_e792, _e788, (_e788 < _e792));
                                        let _e801 = -(_e762);
                                        let _e802 = -(_e764);
                                        let _e809 = (select(_e766, _e794, (_e794 < _e766)) + (select(_e801, _e766, (_e766 > _e801)) * 0.0000019073523f));
                                        let _e810 = (select(_e768, _e796, (_e796 < _e768)) + (select(_e802, _e768, (_e768 > _e802)) * 0.0000019073523f));
                                        let _e812 = select(_e441, _e782, (_e782 > _e441));
                                        let _e814 = select(_e441, _e784, (_e784 > _e441));
                                        let _e819 = (_e812 <= select(_e475.member, _e809, (_e809 < _e475.member)));
                                        let _e820 = (_e814 <= select(_e475.member, _e810, (_e810 < _e475.member)));
                                        let _e821 = (_e812 <= _e814);
                                        if _e819 {
                                            if _e820 {
                                                if _e821 {
                                                    phi_2907_ = _e735;
                                                } else {
                                                    phi_2907_ = _e730;
                                                }
                                                let _e823 = phi_2907_;
                                                let _e831 = (_e518 % 128u);
                                                let _e832 = (_e831 < 128u);
                                                if _e832 {
                                                } else {
                                                    phi_3228_ = true;
                                                    break;
                                                }
                                                local_6[_e831] = _e823.member_1;
                                                if _e832 {
                                                } else {
                                                    phi_3228_ = true;
                                                    break;
                                                }
                                                local_5[_e831] = _e823.member.member[0];
                                                if _e832 {
                                                } else {
                                                    phi_3228_ = true;
                                                    break;
                                                }
                                                local_4[_e831] = _e823.member.member[1];
                                                if _e832 {
                                                } else {
                                                    phi_3228_ = true;
                                                    break;
                                                }
                                                local_3[_e831] = _e823.member.member[2];
                                                if _e832 {
                                                } else {
                                                    phi_3228_ = true;
                                                    break;
                                                }
                                                local_2[_e831] = _e823.member.member_1[0];
                                                if _e832 {
                                                } else {
                                                    phi_3228_ = true;
                                                    break;
                                                }
                                                local_1[_e831] = _e823.member.member_1[1];
                                                if _e832 {
                                                } else {
                                                    phi_3228_ = true;
                                                    break;
                                                }
                                                local[_e831] = _e823.member.member_1[2];
                                                if _e832 {
                                                } else {
                                                    phi_3228_ = true;
                                                    break;
                                                }
                                                local_7[_e831] = select(_e814, _e812, (_e812 > _e814));
                                                if _e821 {
                                                    phi_2984_ = _e730;
                                                } else {
                                                    phi_2984_ = _e735;
                                                }
                                                let _e849 = phi_2984_;
                                                phi_2985_ = _e849;
                                                phi_2986_ = (_e518 + 1u);
                                            } else {
                                                phi_2985_ = type_49();
                                                phi_2986_ = u32();
                                            }
                                            let _e851 = phi_2985_;
                                            let _e853 = phi_2986_;
                                            phi_2988_ = _e851;
                                            phi_2989_ = _e853;
                                            phi_2990_ = select(true, false, _e820);
                                        } else {
                                            phi_2988_ = type_49();
                                            phi_2989_ = u32();
                                            phi_2990_ = true;
                                        }
                                        let _e856 = phi_2988_;
                                        let _e858 = phi_2989_;
                                        let _e860 = phi_2990_;
                                        if _e860 {
                                            if _e819 {
                                                phi_2997_ = _e730;
                                            } else {
                                                phi_2997_ = _e735;
                                            }
                                            let _e862 = phi_2997_;
                                            phi_3002_ = _e862;
                                            phi_3003_ = select(_e820, true, _e819);
                                        } else {
                                            phi_3002_ = _e856;
                                            phi_3003_ = _e516;
                                        }
                                        let _e865 = phi_3002_;
                                        let _e867 = phi_3003_;
                                        phi_3232_ = _e473;
                                        phi_3005_ = _e475;
                                        phi_3006_ = _e865;
                                        phi_3007_ = _e867;
                                        phi_3008_ = select(_e858, _e518, _e860);
                                    }
                                    let _e1525 = phi_3232_;
                                    let _e1527 = phi_3005_;
                                    let _e1529 = phi_3006_;
                                    let _e1531 = phi_3007_;
                                    let _e1533 = phi_3008_;
                                    phi_3231_ = _e1525;
                                    phi_3009_ = _e1527;
                                    phi_3010_ = _e1529;
                                    phi_3011_ = (_e479 - 1u);
                                    phi_3012_ = _e1531;
                                    phi_3013_ = _e1533;
                                } else {
                                    phi_3231_ = _e473;
                                    phi_3009_ = _e475;
                                    phi_3010_ = _e514;
                                    phi_3011_ = _e479;
                                    phi_3012_ = _e516;
                                    phi_3013_ = _e518;
                                }
                                let _e1535 = phi_3231_;
                                let _e1537 = phi_3009_;
                                let _e1539 = phi_3010_;
                                let _e1541 = phi_3011_;
                                let _e1543 = phi_3012_;
                                let _e1545 = phi_3013_;
                                phi_3230_ = _e1535;
                                phi_3014_ = _e1537;
                                phi_3015_ = _e1539;
                                phi_3016_ = _e1541;
                                phi_3017_ = _e1543;
                                phi_3018_ = _e1545;
                            } else {
                                phi_3230_ = _e473;
                                phi_3014_ = type_32();
                                phi_3015_ = type_49();
                                phi_3016_ = u32();
                                phi_3017_ = bool();
                                phi_3018_ = u32();
                            }
                            let _e1547 = phi_3230_;
                            let _e1549 = phi_3014_;
                            let _e1551 = phi_3015_;
                            let _e1553 = phi_3016_;
                            let _e1555 = phi_3017_;
                            let _e1557 = phi_3018_;
                            phi_3229_ = _e1547;
                            phi_775_ = _e1549;
                            phi_778_ = _e1551;
                            phi_780_ = _e1553;
                            phi_782_ = _e1555;
                            phi_784_ = _e1557;
                            phi_3019_ = _e487;
                        } else {
                            phi_3229_ = _e473;
                            phi_775_ = type_32();
                            phi_778_ = type_49();
                            phi_780_ = u32();
                            phi_782_ = bool();
                            phi_784_ = u32();
                            phi_3019_ = false;
                        }
                        let _e1559 = phi_3229_;
                        let _e1561 = phi_775_;
                        let _e1563 = phi_778_;
                        let _e1565 = phi_780_;
                        let _e1567 = phi_782_;
                        let _e1569 = phi_784_;
                        let _e1571 = phi_3019_;
                        continue;
                        continuing {
                            phi_3077_ = _e1559;
                            phi_774_ = _e1561;
                            phi_777_ = _e1563;
                            phi_779_ = _e1565;
                            phi_781_ = _e1567;
                            phi_783_ = _e1569;
                            phi_3228_ = _e1559;
                            break if !(_e1571);
                        }
                    }
                    let _e1574 = phi_3228_;
                    if _e1574 {
                        break;
                    }
                    let _e1576 = local_11;
                    if _e129 {
                    } else {
                        break;
                    }
                    global_4.member[_e127] = select(0u, 1u, _e1576.member_1);
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn trace_any_printed_leaf10_(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
