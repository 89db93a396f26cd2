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

struct type_22 {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: u32,
}

struct type_23 {
    member: array<f32, 3>,
    member_1: f32,
    member_2: array<f32, 3>,
    member_3: f32,
}

struct type_32 {
    member: array<type_23>,
}

struct type_36 {
    member: array<array<type_22, 8>>,
}

struct type_42 {
    member: array<vec4<u32>, 2>,
}

struct type_44 {
    member: array<u32, 2>,
    member_1: array<u32, 2>,
    member_2: u32,
    member_3: u32,
}

struct type_46 {
    member: array<type_44>,
}

struct type_49 {
    member: array<f32, 3>,
    member_1: array<f32, 3>,
}

struct type_51 {
    member: type_49,
    member_1: u32,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_1: type_8;
@group(0) @binding(3) 
var<storage> global_2: type_15;
@group(0) @binding(1) 
var<uniform> global_3: type_42;
@group(0) @binding(4) 
var<storage> global_4: type_32;
@group(0) @binding(2) 
var<storage> global_5: type_46;
@group(0) @binding(5) 
var<storage, read_write> global_6: type_36;

fn function_() {
    var local: array<f32, 128>;
    var local_1: array<f32, 128>;
    var local_2: array<f32, 128>;
    var local_3: array<f32, 128>;
    var local_4: array<f32, 128>;
    var local_5: array<f32, 128>;
    var local_6: array<u32, 128>;
    var local_7: array<type_22, 8>;
    var local_8: array<f32, 128>;
    var local_9: array<f32, 3>;
    var local_10: array<f32, 3>;
    var phi_337_: i32;
    var phi_338_: i32;
    var phi_348_: bool;
    var phi_358_: u32;
    var phi_359_: u32;
    var phi_361_: bool;
    var phi_366_: u32;
    var phi_378_: i32;
    var phi_398_: i32;
    var phi_416_: f32;
    var phi_422_: f32;
    var phi_433_: f32;
    var phi_439_: f32;
    var phi_462_: f32;
    var phi_473_: f32;
    var phi_482_: f32;
    var phi_488_: f32;
    var phi_499_: f32;
    var phi_505_: f32;
    var phi_528_: f32;
    var phi_539_: f32;
    var phi_548_: f32;
    var phi_554_: f32;
    var phi_565_: f32;
    var phi_571_: f32;
    var phi_594_: f32;
    var phi_605_: f32;
    var phi_705_: f32;
    var phi_706_: f32;
    var phi_3263_: bool;
    var phi_3219_: f32;
    var phi_832_: type_51;
    var phi_835_: u32;
    var phi_837_: bool;
    var phi_839_: u32;
    var phi_850_: bool;
    var phi_937_: type_51;
    var phi_938_: bool;
    var phi_939_: u32;
    var phi_2057_: type_44;
    var phi_2890_: type_51;
    var phi_2967_: type_51;
    var phi_2968_: type_51;
    var phi_2969_: u32;
    var phi_2971_: type_51;
    var phi_2972_: u32;
    var phi_2973_: bool;
    var phi_2980_: type_51;
    var phi_2985_: type_51;
    var phi_2986_: bool;
    var phi_3260_: bool;
    var phi_3250_: f32;
    var phi_957_: type_4;
    var phi_958_: type_4;
    var phi_981_: type_4;
    var phi_1002_: u32;
    var phi_1091_: array<array<f32, 3>, 3>;
    var phi_1209_: bool;
    var phi_1238_: bool;
    var phi_1639_: f32;
    var phi_1640_: f32;
    var phi_1641_: f32;
    var phi_1642_: f32;
    var phi_1643_: vec3<f32>;
    var phi_1644_: vec3<f32>;
    var phi_1645_: vec3<f32>;
    var phi_1646_: vec3<f32>;
    var phi_1677_: bool;
    var phi_1686_: vec3<f32>;
    var phi_1853_: bool;
    var phi_1877_: f32;
    var phi_1878_: f32;
    var phi_1901_: type_22;
    var phi_1903_: type_22;
    var phi_1904_: bool;
    var phi_1908_: type_22;
    var phi_1909_: type_22;
    var phi_1910_: type_22;
    var phi_1911_: bool;
    var phi_1915_: type_22;
    var phi_1916_: bool;
    var phi_1917_: type_22;
    var phi_1918_: bool;
    var phi_1919_: bool;
    var phi_1920_: type_22;
    var phi_1921_: bool;
    var phi_1922_: bool;
    var phi_1930_: type_22;
    var phi_1931_: bool;
    var phi_1935_: type_22;
    var phi_1947_: type_4;
    var phi_1950_: type_22;
    var phi_1948_: type_4;
    var phi_1973_: type_4;
    var phi_2005_: bool;
    var phi_2006_: bool;
    var phi_2027_: type_22;
    var phi_1951_: type_22;
    var phi_3251_: bool;
    var phi_3598_: f32;
    var phi_3597_: f32;
    var phi_3396_: bool;
    var phi_3596_: f32;
    var phi_3395_: bool;
    var phi_3595_: f32;
    var phi_3394_: bool;
    var phi_3507_: f32;
    var phi_3393_: bool;
    var phi_3472_: f32;
    var phi_3402_: bool;
    var phi_2988_: type_51;
    var phi_2989_: bool;
    var phi_2990_: u32;
    var phi_3471_: f32;
    var phi_3401_: bool;
    var phi_2991_: type_51;
    var phi_2992_: u32;
    var phi_2993_: bool;
    var phi_2994_: u32;
    var phi_3470_: f32;
    var phi_3400_: bool;
    var phi_2995_: type_51;
    var phi_2996_: u32;
    var phi_2997_: bool;
    var phi_2998_: u32;
    var phi_3469_: f32;
    var phi_3399_: bool;
    var phi_833_: type_51;
    var phi_836_: u32;
    var phi_838_: bool;
    var phi_840_: u32;
    var phi_2999_: bool;
    var phi_3398_: bool;
    var phi_3006_: type_4;
    var phi_3007_: type_4;
    var phi_3030_: type_4;
    var phi_3096_: type_22;
    var phi_3462_: bool;

    switch bitcast<i32>(0u) {
        default: {
            let _e80 = global;
            let _e83 = arrayLength((&global_5.member));
            let _e85 = arrayLength((&global_2.member));
            let _e93 = global_3.member[0u][0u];
            let _e97 = global_3.member[0u][1u];
            let _e101 = global_3.member[0u][2u];
            let _e105 = global_3.member[1u][0u];
            let _e109 = global_3.member[1u][1u];
            let _e113 = global_3.member[1u][2u];
            let _e117 = global_3.member[1u][3u];
            let _e120 = global_1.member[0u];
            let _e121 = bitcast<i32>(_e120);
            let _e131 = (_e80.x + (_e80.y * 2097152u));
            let _e132 = (_e131 < arrayLength((&global_4.member)));
            if _e132 {
                let _e133 = (_e131 < arrayLength((&global_6.member)));
                if _e133 {
                    if _e132 {
                    } else {
                        break;
                    }
                    let _e141 = global_4.member[_e131].member_2[0u];
                    let _e143 = (bitcast<u32>(_e141) & 2147483647u);
                    let _e148 = global_4.member[_e131].member_2[1u];
                    let _e150 = (bitcast<u32>(_e148) & 2147483647u);
                    let _e155 = global_4.member[_e131].member_2[2u];
                    let _e157 = (bitcast<u32>(_e155) & 2147483647u);
                    let _e162 = global_4.member[_e131].member[0u];
                    let _e164 = (bitcast<u32>(_e162) & 2147483647u);
                    let _e169 = global_4.member[_e131].member[1u];
                    let _e171 = (bitcast<u32>(_e169) & 2147483647u);
                    let _e176 = global_4.member[_e131].member[2u];
                    let _e178 = (bitcast<u32>(_e176) & 2147483647u);
                    let _e180 = select(_e150, _e143, (_e150 < _e143));
                    let _e182 = select(_e157, _e180, (_e157 < _e180));
                    let _e184 = select(_e164, _e182, (_e164 < _e182));
                    let _e186 = select(_e171, _e184, (_e171 < _e184));
                    let _e188 = select(_e178, _e186, (_e178 < _e186));
                    let _e192 = global_4.member[_e131].member_1;
                    let _e194 = (bitcast<u32>(_e192) & 2147483647u);
                    let _e201 = global_4.member[_e131].member_3;
                    let _e207 = (((select(_e194, _e188, (_e194 < _e188)) < 2139095040u) && ((bitcast<u32>(_e201) & 2147483647u) <= 2139095040u)) && (_e182 > 0u));
                    if _e207 {
                        let _e210 = (bitcast<u32>(bitcast<f32>(_e182)) & 2147483647u);
                        if (_e210 >= 8388608u) {
                            phi_337_ = (bitcast<i32>((_e210 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_337_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e210)), 32u, (_e210 == 0u))));
                        }
                        let _e224 = phi_337_;
                        phi_338_ = _e224;
                    } else {
                        phi_338_ = 0i;
                    }
                    let _e226 = phi_338_;
                    let _e227 = (_e143 == _e182);
                    if _e227 {
                        phi_348_ = true;
                    } else {
                        phi_348_ = (_e150 == _e182);
                    }
                    let _e230 = phi_348_;
                    let _e231 = select(1u, 0u, _e227);
                    if _e230 {
                        let _e232 = (_e231 + 1u);
                        phi_358_ = _e232;
                        phi_359_ = _e232;
                        phi_361_ = select(true, false, (_e232 == 2u));
                    } else {
                        phi_358_ = u32();
                        phi_359_ = 0u;
                        phi_361_ = true;
                    }
                    let _e236 = phi_358_;
                    let _e238 = phi_359_;
                    let _e240 = phi_361_;
                    if _e240 {
                        phi_366_ = (_e238 + 1u);
                    } else {
                        phi_366_ = 0u;
                    }
                    let _e244 = phi_366_;
                    let _e245 = select(_e236, _e238, _e240);
                    let _e246 = select(_e231, select(2u, _e231, _e230), _e240);
                    if (_e121 < -126i) {
                        phi_378_ = -126i;
                    } else {
                        phi_378_ = select(_e121, 127i, (_e121 > 127i));
                    }
                    let _e251 = phi_378_;
                    let _e256 = bitcast<f32>((bitcast<u32>((_e251 + 127i)) << bitcast<u32>(23i)));
                    let _e262 = bitcast<f32>((bitcast<u32>(((_e121 - _e251) + 127i)) << bitcast<u32>(23i)));
                    let _e263 = -(_e226);
                    if (_e263 < -126i) {
                        phi_398_ = -126i;
                    } else {
                        phi_398_ = select(_e263, 127i, (_e263 > 127i));
                    }
                    let _e268 = phi_398_;
                    let _e273 = bitcast<f32>((bitcast<u32>((_e268 + 127i)) << bitcast<u32>(23i)));
                    let _e279 = bitcast<f32>((bitcast<u32>(((_e263 - _e268) + 127i)) << bitcast<u32>(23i)));
                    let _e283 = global_4.member[_e131].member;
                    let _e284 = (_e245 == 0u);
                    if _e284 {
                        phi_416_ = _e283[0];
                    } else {
                        phi_416_ = _e283[1];
                    }
                    let _e288 = phi_416_;
                    let _e289 = (_e245 == 2u);
                    if _e289 {
                        phi_422_ = _e283[2];
                    } else {
                        phi_422_ = _e288;
                    }
                    let _e292 = phi_422_;
                    let _e294 = ((_e292 * _e256) * _e262);
                    let _e295 = global_4.member[_e131].member_2;
                    if _e284 {
                        phi_433_ = _e295[0];
                    } else {
                        phi_433_ = _e295[1];
                    }
                    let _e299 = phi_433_;
                    if _e289 {
                        phi_439_ = _e295[2];
                    } else {
                        phi_439_ = _e299;
                    }
                    let _e302 = phi_439_;
                    let _e304 = ((_e302 * _e273) * _e279);
                    let _e308 = (bitcast<f32>((bitcast<u32>(_e304) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e308 {
                        let _e312 = (bitcast<f32>((bitcast<u32>(_e294) & 2147483647u)) * 0.00000011920929f);
                        phi_462_ = select(0.00000000000011368684f, _e312, (_e312 > 0.00000000000011368684f));
                    } else {
                        phi_462_ = 0f;
                    }
                    let _e316 = phi_462_;
                    let _e317 = (_e294 + _e316);
                    let _e318 = (_e294 - _e316);
                    let _e319 = select(_e304, 0f, _e308);
                    if _e308 {
                        phi_473_ = 38685626000000000000000000f;
                    } else {
                        phi_473_ = (1f / _e304);
                    }
                    let _e322 = phi_473_;
                    let _e323 = (_e244 == 0u);
                    if _e323 {
                        phi_482_ = _e283[0];
                    } else {
                        phi_482_ = _e283[1];
                    }
                    let _e327 = phi_482_;
                    let _e328 = (_e244 == 2u);
                    if _e328 {
                        phi_488_ = _e283[2];
                    } else {
                        phi_488_ = _e327;
                    }
                    let _e331 = phi_488_;
                    let _e333 = ((_e331 * _e256) * _e262);
                    if _e323 {
                        phi_499_ = _e295[0];
                    } else {
                        phi_499_ = _e295[1];
                    }
                    let _e337 = phi_499_;
                    if _e328 {
                        phi_505_ = _e295[2];
                    } else {
                        phi_505_ = _e337;
                    }
                    let _e340 = phi_505_;
                    let _e342 = ((_e340 * _e273) * _e279);
                    let _e346 = (bitcast<f32>((bitcast<u32>(_e342) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e346 {
                        let _e350 = (bitcast<f32>((bitcast<u32>(_e333) & 2147483647u)) * 0.00000011920929f);
                        phi_528_ = select(0.00000000000011368684f, _e350, (_e350 > 0.00000000000011368684f));
                    } else {
                        phi_528_ = 0f;
                    }
                    let _e354 = phi_528_;
                    let _e355 = (_e333 + _e354);
                    let _e356 = (_e333 - _e354);
                    let _e357 = select(_e342, 0f, _e346);
                    if _e346 {
                        phi_539_ = 38685626000000000000000000f;
                    } else {
                        phi_539_ = (1f / _e342);
                    }
                    let _e360 = phi_539_;
                    let _e361 = (_e246 == 0u);
                    if _e361 {
                        phi_548_ = _e283[0];
                    } else {
                        phi_548_ = _e283[1];
                    }
                    let _e365 = phi_548_;
                    let _e366 = (_e246 == 2u);
                    if _e366 {
                        phi_554_ = _e283[2];
                    } else {
                        phi_554_ = _e365;
                    }
                    let _e369 = phi_554_;
                    let _e371 = ((_e369 * _e256) * _e262);
                    if _e361 {
                        phi_565_ = _e295[0];
                    } else {
                        phi_565_ = _e295[1];
                    }
                    let _e375 = phi_565_;
                    if _e366 {
                        phi_571_ = _e295[2];
                    } else {
                        phi_571_ = _e375;
                    }
                    let _e378 = phi_571_;
                    let _e380 = ((_e378 * _e273) * _e279);
                    let _e384 = (bitcast<f32>((bitcast<u32>(_e380) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e384 {
                        let _e388 = (bitcast<f32>((bitcast<u32>(_e371) & 2147483647u)) * 0.00000011920929f);
                        phi_594_ = select(0.00000000000011368684f, _e388, (_e388 > 0.00000000000011368684f));
                    } else {
                        phi_594_ = 0f;
                    }
                    let _e392 = phi_594_;
                    let _e393 = (_e371 + _e392);
                    let _e394 = (_e371 - _e392);
                    let _e395 = select(_e380, 0f, _e384);
                    if _e384 {
                        phi_605_ = 38685626000000000000000000f;
                    } else {
                        phi_605_ = (1f / _e380);
                    }
                    let _e398 = phi_605_;
                    let _e401 = bitcast<f32>((bitcast<u32>(_e294) & 2147483647u));
                    let _e404 = bitcast<f32>((bitcast<u32>(_e333) & 2147483647u));
                    let _e406 = select(_e404, _e401, (_e401 > _e404));
                    let _e409 = bitcast<f32>((bitcast<u32>(_e371) & 2147483647u));
                    let _e412 = (_e121 + _e226);
                    if (_e207 && (select(_e409, _e406, (_e406 > _e409)) <= 1099511600000f)) {
                        let _e415 = (_e412 / 3i);
                        let _e422 = bitcast<f32>((bitcast<u32>((_e415 + 127i)) << bitcast<u32>(23i)));
                        let _e429 = bitcast<f32>((bitcast<u32>(((_e412 - (2i * _e415)) + 127i)) << bitcast<u32>(23i)));
                        let _e430 = (((_e192 * _e422) * _e422) * _e429);
                        let _e432 = select(340282350000000000000000000000000000000f, _e430, (_e430 < 340282350000000000000000000000000000000f));
                        let _e437 = (((_e201 * _e422) * _e422) * _e429);
                        let _e439 = select(340282350000000000000000000000000000000f, _e437, (_e437 < 340282350000000000000000000000000000000f));
                        phi_705_ = select(-340282350000000000000000000000000000000f, _e439, (_e439 > -340282350000000000000000000000000000000f));
                        phi_706_ = select(-340282350000000000000000000000000000000f, _e432, (_e432 > -340282350000000000000000000000000000000f));
                    } else {
                        phi_705_ = 0f;
                        phi_706_ = 1f;
                    }
                    let _e443 = phi_705_;
                    let _e445 = phi_706_;
                    local_7 = array<type_22, 8>(type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u));
                    local_6 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                    local_5 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_4 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_3 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_1 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_8 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_10 = array<f32, 3>(bitcast<f32>(_e93), bitcast<f32>(_e97), bitcast<f32>(_e101));
                    let _e449 = (_e245 % 3u);
                    let _e450 = (_e449 < 3u);
                    if _e450 {
                    } else {
                        break;
                    }
                    let _e452 = local_10[_e449];
                    let _e453 = (_e244 % 3u);
                    let _e454 = (_e453 < 3u);
                    if _e454 {
                    } else {
                        break;
                    }
                    let _e456 = local_10[_e453];
                    let _e457 = (_e246 % 3u);
                    let _e458 = (_e457 < 3u);
                    if _e458 {
                    } else {
                        break;
                    }
                    let _e460 = local_10[_e457];
                    local_9 = array<f32, 3>(bitcast<f32>(_e105), bitcast<f32>(_e109), bitcast<f32>(_e113));
                    if _e450 {
                    } else {
                        break;
                    }
                    let _e464 = local_9[_e449];
                    if _e454 {
                    } else {
                        break;
                    }
                    let _e466 = local_9[_e453];
                    if _e458 {
                    } else {
                        break;
                    }
                    let _e468 = local_9[_e457];
                    phi_3263_ = false;
                    phi_3219_ = _e443;
                    phi_832_ = type_51(type_49(array<f32, 3>(_e452, _e456, _e460), array<f32, 3>(_e464, _e466, _e468)), select(0u, 2147483648u, (_e83 == 0u)));
                    phi_835_ = ((3u * _e83) + 1u);
                    phi_837_ = (_e445 <= _e443);
                    phi_839_ = 0u;
                    loop {
                        let _e476 = phi_3263_;
                        let _e478 = phi_3219_;
                        let _e480 = phi_832_;
                        let _e482 = phi_835_;
                        let _e484 = phi_837_;
                        let _e486 = phi_839_;
                        if _e484 {
                            phi_850_ = true;
                        } else {
                            phi_850_ = (_e486 > 0u);
                        }
                        let _e489 = phi_850_;
                        if _e489 {
                            let _e490 = (_e482 > 0u);
                            if _e490 {
                                if _e484 {
                                    phi_937_ = _e480;
                                    phi_938_ = _e484;
                                    phi_939_ = _e486;
                                } else {
                                    let _e491 = (_e486 - 1u);
                                    let _e492 = (_e491 % 128u);
                                    let _e493 = (_e492 < 128u);
                                    if _e493 {
                                    } else {
                                        phi_3398_ = true;
                                        break;
                                    }
                                    let _e495 = local_6[_e492];
                                    if _e493 {
                                    } else {
                                        phi_3398_ = true;
                                        break;
                                    }
                                    let _e497 = local_5[_e492];
                                    if _e493 {
                                    } else {
                                        phi_3398_ = true;
                                        break;
                                    }
                                    let _e499 = local_4[_e492];
                                    if _e493 {
                                    } else {
                                        phi_3398_ = true;
                                        break;
                                    }
                                    let _e501 = local_3[_e492];
                                    if _e493 {
                                    } else {
                                        phi_3398_ = true;
                                        break;
                                    }
                                    let _e504 = local_2[_e492];
                                    if _e493 {
                                    } else {
                                        phi_3398_ = true;
                                        break;
                                    }
                                    let _e506 = local_1[_e492];
                                    if _e493 {
                                    } else {
                                        phi_3398_ = true;
                                        break;
                                    }
                                    let _e508 = local[_e492];
                                    if _e493 {
                                    } else {
                                        phi_3398_ = true;
                                        break;
                                    }
                                    let _e513 = local_8[_e492];
                                    phi_937_ = type_51(type_49(array<f32, 3>(_e497, _e499, _e501), array<f32, 3>(_e504, _e506, _e508)), _e495);
                                    phi_938_ = (_e513 <= _e478);
                                    phi_939_ = _e491;
                                }
                                let _e516 = phi_937_;
                                let _e518 = phi_938_;
                                let _e520 = phi_939_;
                                if _e518 {
                                    if ((_e516.member_1 & 2147483648u) != 0u) {
                                        phi_3260_ = _e476;
                                        phi_3250_ = _e478;
                                        phi_957_ = type_4(0u, ((_e516.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e871 = phi_3260_;
                                            let _e873 = phi_3250_;
                                            let _e875 = phi_957_;
                                            if (_e875.member < _e875.member_1) {
                                                phi_958_ = type_4((_e875.member + 1u), _e875.member_1);
                                                phi_981_ = type_4(1u, _e875.member);
                                            } else {
                                                phi_958_ = _e875;
                                                phi_981_ = type_4(0u, type_4().member_1);
                                            }
                                            let _e888 = phi_958_;
                                            let _e890 = phi_981_;
                                            let _e894 = (bitcast<i32>(_e890.member) != 0i);
                                            if _e894 {
                                                let _e895 = ((_e516.member_1 & 268435455u) + _e890.member_1);
                                                let _e896 = (_e895 < _e85);
                                                if _e896 {
                                                    if _e896 {
                                                    } else {
                                                        phi_3507_ = _e873;
                                                        phi_3393_ = true;
                                                        break;
                                                    }
                                                    let _e900 = global_2.member[_e895].member_1;
                                                    phi_1002_ = _e900;
                                                } else {
                                                    phi_1002_ = 4294967295u;
                                                }
                                                let _e902 = phi_1002_;
                                                if (_e895 >= _e85) {
                                                    phi_1091_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                } else {
                                                    if _e896 {
                                                    } else {
                                                        phi_3507_ = _e873;
                                                        phi_3393_ = true;
                                                        break;
                                                    }
                                                    if (_e449 < 9u) {
                                                    } else {
                                                        phi_3507_ = _e873;
                                                        phi_3393_ = true;
                                                        break;
                                                    }
                                                    let _e909 = global_2.member[_e895].member[_e449];
                                                    if (_e453 < 9u) {
                                                    } else {
                                                        phi_3507_ = _e873;
                                                        phi_3393_ = true;
                                                        break;
                                                    }
                                                    let _e915 = global_2.member[_e895].member[_e453];
                                                    if (_e457 < 9u) {
                                                    } else {
                                                        phi_3507_ = _e873;
                                                        phi_3393_ = true;
                                                        break;
                                                    }
                                                    let _e921 = global_2.member[_e895].member[_e457];
                                                    let _e923 = (3u + _e449);
                                                    if (_e923 < 9u) {
                                                    } else {
                                                        phi_3507_ = _e873;
                                                        phi_3393_ = true;
                                                        break;
                                                    }
                                                    let _e929 = global_2.member[_e895].member[_e923];
                                                    let _e930 = (3u + _e453);
                                                    if (_e930 < 9u) {
                                                    } else {
                                                        phi_3507_ = _e873;
                                                        phi_3393_ = true;
                                                        break;
                                                    }
                                                    let _e936 = global_2.member[_e895].member[_e930];
                                                    let _e937 = (3u + _e457);
                                                    if (_e937 < 9u) {
                                                    } else {
                                                        phi_3507_ = _e873;
                                                        phi_3393_ = true;
                                                        break;
                                                    }
                                                    let _e943 = global_2.member[_e895].member[_e937];
                                                    let _e945 = (6u + _e449);
                                                    if (_e945 < 9u) {
                                                    } else {
                                                        phi_3507_ = _e873;
                                                        phi_3393_ = true;
                                                        break;
                                                    }
                                                    let _e951 = global_2.member[_e895].member[_e945];
                                                    let _e952 = (6u + _e453);
                                                    if (_e952 < 9u) {
                                                    } else {
                                                        phi_3507_ = _e873;
                                                        phi_3393_ = true;
                                                        break;
                                                    }
                                                    let _e958 = global_2.member[_e895].member[_e952];
                                                    let _e959 = (6u + _e457);
                                                    if (_e959 < 9u) {
                                                    } else {
                                                        phi_3507_ = _e873;
                                                        phi_3393_ = true;
                                                        break;
                                                    }
                                                    let _e965 = global_2.member[_e895].member[_e959];
                                                    phi_1091_ = array<array<f32, 3>, 3>(array<f32, 3>(_e909, _e915, _e921), array<f32, 3>(_e929, _e936, _e943), array<f32, 3>(_e951, _e958, _e965));
                                                }
                                                let _e969 = phi_1091_;
                                                let _e976 = (_e969[0][2] - _e371);
                                                let _e979 = (((_e969[0][0] - _e294) * _e395) - (_e976 * _e319));
                                                let _e982 = (((_e969[0][1] - _e333) * _e395) - (_e976 * _e357));
                                                let _e989 = (_e969[1][2] - _e371);
                                                let _e992 = (((_e969[1][0] - _e294) * _e395) - (_e989 * _e319));
                                                let _e995 = (((_e969[1][1] - _e333) * _e395) - (_e989 * _e357));
                                                let _e1002 = (_e969[2][2] - _e371);
                                                let _e1005 = (((_e969[2][0] - _e294) * _e395) - (_e1002 * _e319));
                                                let _e1008 = (((_e969[2][1] - _e333) * _e395) - (_e1002 * _e357));
                                                let _e1009 = (_e1005 * _e995);
                                                let _e1010 = (_e1008 * _e992);
                                                let _e1011 = (_e979 * _e1008);
                                                let _e1012 = (_e982 * _e1005);
                                                let _e1013 = (_e992 * _e982);
                                                let _e1014 = (_e995 * _e979);
                                                let _e1019 = (((_e1009 >= _e1010) && (_e1011 >= _e1012)) && (_e1013 >= _e1014));
                                                if (_e1019 || (((_e1009 <= _e1010) && (_e1011 <= _e1012)) && (_e1013 <= _e1014))) {
                                                    let _e1026 = select(-1f, 1f, _e1019);
                                                    let _e1028 = ((_e1009 - _e1010) * _e1026);
                                                    let _e1030 = select(0f, _e1028, (_e1028 > 0f));
                                                    let _e1032 = ((_e1011 - _e1012) * _e1026);
                                                    let _e1034 = select(0f, _e1032, (_e1032 > 0f));
                                                    let _e1036 = ((_e1013 - _e1014) * _e1026);
                                                    let _e1038 = select(0f, _e1036, (_e1036 > 0f));
                                                    let _e1040 = ((_e1030 + _e1034) + _e1038);
                                                    if (_e1040 < 0.000000000000000000000000000000000000011754944f) {
                                                        phi_1920_ = type_22();
                                                        phi_1921_ = true;
                                                        phi_1922_ = false;
                                                    } else {
                                                        let _e1043 = select(_e992, _e979, (_e979 < _e992));
                                                        if (select(_e1005, _e1043, (_e1043 < _e1005)) > 0f) {
                                                            phi_1209_ = true;
                                                        } else {
                                                            let _e1048 = select(_e992, _e979, (_e979 > _e992));
                                                            phi_1209_ = (select(_e1005, _e1048, (_e1048 > _e1005)) < 0f);
                                                        }
                                                        let _e1053 = phi_1209_;
                                                        if _e1053 {
                                                            phi_1917_ = type_22();
                                                            phi_1918_ = true;
                                                            phi_1919_ = false;
                                                        } else {
                                                            let _e1055 = select(_e995, _e982, (_e982 < _e995));
                                                            if (select(_e1008, _e1055, (_e1055 < _e1008)) > 0f) {
                                                                phi_1238_ = true;
                                                            } else {
                                                                let _e1060 = select(_e995, _e982, (_e982 > _e995));
                                                                phi_1238_ = (select(_e1008, _e1060, (_e1060 > _e1008)) < 0f);
                                                            }
                                                            let _e1065 = phi_1238_;
                                                            if _e1065 {
                                                                phi_1915_ = type_22();
                                                                phi_1916_ = false;
                                                            } else {
                                                                let _e1067 = select(_e969[1][0], _e969[0][0], (_e969[0][0] < _e969[1][0]));
                                                                let _e1071 = select(_e969[1][0], _e969[0][0], (_e969[0][0] > _e969[1][0]));
                                                                let _e1075 = select(_e969[1][1], _e969[0][1], (_e969[0][1] < _e969[1][1]));
                                                                let _e1079 = select(_e969[1][1], _e969[0][1], (_e969[0][1] > _e969[1][1]));
                                                                let _e1083 = select(_e969[1][2], _e969[0][2], (_e969[0][2] < _e969[1][2]));
                                                                let _e1087 = select(_e969[1][2], _e969[0][2], (_e969[0][2] > _e969[1][2]));
                                                                let _e1092 = ((select(_e969[2][0], _e1067, (_e1067 < _e969[2][0])) - _e317) * _e322);
                                                                let _e1093 = ((select(_e969[2][0], _e1071, (_e1071 > _e969[2][0])) - _e318) * _e322);
                                                                let _e1096 = ((select(_e969[2][1], _e1075, (_e1075 < _e969[2][1])) - _e355) * _e360);
                                                                let _e1097 = ((select(_e969[2][1], _e1079, (_e1079 > _e969[2][1])) - _e356) * _e360);
                                                                let _e1100 = ((select(_e969[2][2], _e1083, (_e1083 < _e969[2][2])) - _e393) * _e398);
                                                                let _e1101 = ((select(_e969[2][2], _e1087, (_e1087 > _e969[2][2])) - _e394) * _e398);
                                                                let _e1103 = select(_e1101, _e1100, (_e1100 < _e1101));
                                                                let _e1105 = select(_e1101, _e1100, (_e1100 > _e1101));
                                                                let _e1107 = select(_e1093, _e1092, (_e1092 < _e1093));
                                                                let _e1109 = select(_e1097, _e1096, (_e1096 < _e1097));
                                                                let _e1111 = select(_e1109, _e1107, (_e1107 > _e1109));
                                                                let _e1113 = select(_e1103, _e1111, (_e1111 > _e1103));
                                                                let _e1115 = select(_e1093, _e1092, (_e1092 > _e1093));
                                                                let _e1117 = select(_e1097, _e1096, (_e1096 > _e1097));
                                                                let _e1119 = select(_e1117, _e1115, (_e1115 < _e1117));
                                                                let _e1121 = select(_e1105, _e1119, (_e1119 < _e1105));
                                                                let _e1122 = -(_e1103);
                                                                let _e1128 = select(_e445, _e1113, (_e1113 > _e445));
                                                                if (_e1128 > (_e1121 + (select(_e1122, _e1105, (_e1105 > _e1122)) * 0.0000019073523f))) {
                                                                    phi_1910_ = type_22();
                                                                    phi_1911_ = true;
                                                                } else {
                                                                    let _e1130 = (_e1128 > _e873);
                                                                    if _e1130 {
                                                                        phi_1909_ = type_22();
                                                                    } else {
                                                                        let _e1131 = vec3<f32>(_e969[0][0], _e969[0][1], _e969[0][2]);
                                                                        let _e1132 = vec3<f32>(_e969[1][0], _e969[1][1], _e969[1][2]);
                                                                        let _e1133 = vec3<f32>(_e969[2][0], _e969[2][1], _e969[2][2]);
                                                                        let _e1134 = (_e969[1][0] - _e969[0][0]);
                                                                        let _e1135 = (_e969[1][1] - _e969[0][1]);
                                                                        let _e1136 = (_e969[1][2] - _e969[0][2]);
                                                                        let _e1137 = vec3<f32>(_e1134, _e1135, _e1136);
                                                                        let _e1138 = (_e969[2][0] - _e969[1][0]);
                                                                        let _e1139 = (_e969[2][1] - _e969[1][1]);
                                                                        let _e1140 = (_e969[2][2] - _e969[1][2]);
                                                                        let _e1141 = vec3<f32>(_e1138, _e1139, _e1140);
                                                                        let _e1142 = (_e969[0][0] - _e969[2][0]);
                                                                        let _e1143 = (_e969[0][1] - _e969[2][1]);
                                                                        let _e1144 = (_e969[0][2] - _e969[2][2]);
                                                                        let _e1145 = vec3<f32>(_e1142, _e1143, _e1144);
                                                                        let _e1148 = bitcast<f32>((bitcast<u32>(_e1134) & 2147483647u));
                                                                        let _e1151 = bitcast<f32>((bitcast<u32>(_e1135) & 2147483647u));
                                                                        let _e1153 = select(_e1151, _e1148, (_e1148 > _e1151));
                                                                        let _e1156 = bitcast<f32>((bitcast<u32>(_e1136) & 2147483647u));
                                                                        let _e1158 = select(_e1156, _e1153, (_e1153 > _e1156));
                                                                        let _e1161 = bitcast<f32>((bitcast<u32>(_e1138) & 2147483647u));
                                                                        let _e1164 = bitcast<f32>((bitcast<u32>(_e1139) & 2147483647u));
                                                                        let _e1166 = select(_e1164, _e1161, (_e1161 > _e1164));
                                                                        let _e1169 = bitcast<f32>((bitcast<u32>(_e1140) & 2147483647u));
                                                                        let _e1171 = select(_e1169, _e1166, (_e1166 > _e1169));
                                                                        let _e1174 = bitcast<f32>((bitcast<u32>(_e1142) & 2147483647u));
                                                                        let _e1177 = bitcast<f32>((bitcast<u32>(_e1143) & 2147483647u));
                                                                        let _e1179 = select(_e1177, _e1174, (_e1174 > _e1177));
                                                                        let _e1182 = bitcast<f32>((bitcast<u32>(_e1144) & 2147483647u));
                                                                        let _e1184 = select(_e1182, _e1179, (_e1179 > _e1182));
                                                                        let _e1186 = select(_e1171, _e1158, (_e1158 > _e1171));
                                                                        let _e1188 = select(_e1184, _e1186, (_e1186 > _e1184));
                                                                        if (_e1158 == _e1188) {
                                                                            phi_1639_ = _e995;
                                                                            phi_1640_ = _e992;
                                                                            phi_1641_ = _e982;
                                                                            phi_1642_ = _e979;
                                                                            phi_1643_ = _e1131;
                                                                            phi_1644_ = _e1145;
                                                                            phi_1645_ = _e1141;
                                                                            phi_1646_ = _e1137;
                                                                        } else {
                                                                            let _e1190 = (_e1171 == _e1188);
                                                                            let _e1195 = vec3(_e1190);
                                                                            phi_1639_ = select(_e982, _e1008, _e1190);
                                                                            phi_1640_ = select(_e979, _e1005, _e1190);
                                                                            phi_1641_ = select(_e1008, _e995, _e1190);
                                                                            phi_1642_ = select(_e1005, _e992, _e1190);
                                                                            phi_1643_ = select(_e1133, _e1132, _e1195);
                                                                            phi_1644_ = select(_e1141, _e1137, _e1195);
                                                                            phi_1645_ = select(_e1137, _e1145, _e1195);
                                                                            phi_1646_ = select(_e1145, _e1141, _e1195);
                                                                        }
                                                                        let _e1201 = phi_1639_;
                                                                        let _e1203 = phi_1640_;
                                                                        let _e1205 = phi_1641_;
                                                                        let _e1207 = phi_1642_;
                                                                        let _e1209 = phi_1643_;
                                                                        let _e1211 = phi_1644_;
                                                                        let _e1213 = phi_1645_;
                                                                        let _e1215 = phi_1646_;
                                                                        let _e1222 = ((_e1213.y * _e1211.z) - (_e1211.y * _e1213.z));
                                                                        let _e1227 = ((_e1213.z * _e1211.x) - (_e1211.z * _e1213.x));
                                                                        let _e1230 = ((_e1213.x * _e1211.y) - (_e1211.x * _e1213.y));
                                                                        if (_e1030 >= _e1034) {
                                                                            phi_1677_ = select(true, false, (_e1030 >= _e1038));
                                                                        } else {
                                                                            phi_1677_ = true;
                                                                        }
                                                                        let _e1235 = phi_1677_;
                                                                        if _e1235 {
                                                                            phi_1686_ = select(_e1133, _e1132, vec3((_e1034 >= _e1038)));
                                                                        } else {
                                                                            phi_1686_ = _e1131;
                                                                        }
                                                                        let _e1240 = phi_1686_;
                                                                        let _e1245 = (((_e1222 * _e319) + (_e1227 * _e357)) + (_e1230 * _e395));
                                                                        let _e1256 = (((_e1222 * (_e1240.x - _e294)) + (_e1227 * (_e1240.y - _e333))) + (_e1230 * (_e1240.z - _e371)));
                                                                        let _e1258 = (_e1203 - _e1207);
                                                                        let _e1259 = (_e1201 - _e1205);
                                                                        let _e1267 = (-(((_e1207 * _e1258) + (_e1205 * _e1259))) / ((_e1258 * _e1258) + (_e1259 * _e1259)));
                                                                        let _e1269 = select(1f, _e1267, (_e1267 < 1f));
                                                                        let _e1271 = select(0f, _e1269, (_e1269 > 0f));
                                                                        let _e1284 = ((_e1209.x + (_e1215.x * _e1271)) - _e294);
                                                                        let _e1285 = ((_e1209.y + (_e1215.y * _e1271)) - _e333);
                                                                        let _e1286 = ((_e1209.z + (_e1215.z * _e1271)) - _e371);
                                                                        let _e1287 = (_e1286 / _e395);
                                                                        let _e1299 = bitcast<f32>((bitcast<u32>(_e1284) & 2147483647u));
                                                                        let _e1302 = bitcast<f32>((bitcast<u32>(_e1285) & 2147483647u));
                                                                        let _e1304 = select(_e1302, _e1299, (_e1299 > _e1302));
                                                                        let _e1307 = bitcast<f32>((bitcast<u32>(_e1286) & 2147483647u));
                                                                        let _e1309 = select(_e1307, _e1304, (_e1304 > _e1307));
                                                                        let _e1315 = bitcast<f32>((bitcast<u32>(_e1222) & 2147483647u));
                                                                        let _e1318 = bitcast<f32>((bitcast<u32>(_e1227) & 2147483647u));
                                                                        let _e1320 = select(_e1318, _e1315, (_e1315 > _e1318));
                                                                        let _e1323 = bitcast<f32>((bitcast<u32>(_e1230) & 2147483647u));
                                                                        if (bitcast<f32>((bitcast<u32>(((((_e1222 * _e1284) + (_e1227 * _e1285)) + (_e1230 * _e1286)) - _e1256)) & 2147483647u)) <= ((0.0000009536743f * select(_e1188, _e1309, (_e1309 > _e1188))) * select(_e1323, _e1320, (_e1320 > _e1323)))) {
                                                                            let _e1333 = bitcast<f32>((bitcast<u32>(_e1213.x) & 2147483647u));
                                                                            let _e1336 = bitcast<f32>((bitcast<u32>(_e1213.y) & 2147483647u));
                                                                            let _e1338 = select(_e1336, _e1333, (_e1333 > _e1336));
                                                                            let _e1341 = bitcast<f32>((bitcast<u32>(_e1213.z) & 2147483647u));
                                                                            let _e1347 = bitcast<f32>((bitcast<u32>(_e1211.x) & 2147483647u));
                                                                            let _e1350 = bitcast<f32>((bitcast<u32>(_e1211.y) & 2147483647u));
                                                                            let _e1352 = select(_e1350, _e1347, (_e1347 > _e1350));
                                                                            let _e1355 = bitcast<f32>((bitcast<u32>(_e1211.z) & 2147483647u));
                                                                            phi_1853_ = select(true, false, (bitcast<f32>((bitcast<u32>(_e1245) & 2147483647u)) > ((0.0000038146973f * select(_e1341, _e1338, (_e1338 > _e1341))) * select(_e1355, _e1352, (_e1352 > _e1355)))));
                                                                        } else {
                                                                            phi_1853_ = true;
                                                                        }
                                                                        let _e1362 = phi_1853_;
                                                                        if _e1362 {
                                                                            let _e1373 = ((((_e1222 * (_e1284 - (_e319 * _e1287))) + (_e1227 * (_e1285 - (_e357 * _e1287)))) + (_e1230 * (_e1286 - _e1286))) / _e1245);
                                                                            if (bitcast<f32>((bitcast<u32>(_e1373) & 2147483647u)) <= _e1188) {
                                                                                phi_1877_ = (_e1287 + _e1373);
                                                                            } else {
                                                                                phi_1877_ = _e1287;
                                                                            }
                                                                            let _e1380 = phi_1877_;
                                                                            phi_1878_ = _e1380;
                                                                        } else {
                                                                            phi_1878_ = (_e1256 / _e1245);
                                                                        }
                                                                        let _e1382 = phi_1878_;
                                                                        let _e1384 = select(_e1121, _e1382, (_e1382 < _e1121));
                                                                        let _e1386 = select(_e1113, _e1384, (_e1384 > _e1113));
                                                                        if (_e1386 >= _e445) {
                                                                            let _e1388 = (_e1386 <= _e873);
                                                                            if _e1388 {
                                                                                let _e1389 = (1f / _e1040);
                                                                                phi_1901_ = type_22(_e1386, (_e1034 * _e1389), (_e1038 * _e1389), _e902);
                                                                            } else {
                                                                                phi_1901_ = type_22();
                                                                            }
                                                                            let _e1394 = phi_1901_;
                                                                            phi_1903_ = _e1394;
                                                                            phi_1904_ = select(true, false, _e1388);
                                                                        } else {
                                                                            phi_1903_ = type_22();
                                                                            phi_1904_ = true;
                                                                        }
                                                                        let _e1397 = phi_1903_;
                                                                        let _e1399 = phi_1904_;
                                                                        if _e1399 {
                                                                            phi_1908_ = type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                        } else {
                                                                            phi_1908_ = _e1397;
                                                                        }
                                                                        let _e1401 = phi_1908_;
                                                                        phi_1909_ = _e1401;
                                                                    }
                                                                    let _e1403 = phi_1909_;
                                                                    phi_1910_ = _e1403;
                                                                    phi_1911_ = _e1130;
                                                                }
                                                                let _e1405 = phi_1910_;
                                                                let _e1407 = phi_1911_;
                                                                phi_1915_ = _e1405;
                                                                phi_1916_ = _e1407;
                                                            }
                                                            let _e1409 = phi_1915_;
                                                            let _e1411 = phi_1916_;
                                                            phi_1917_ = _e1409;
                                                            phi_1918_ = _e1065;
                                                            phi_1919_ = _e1411;
                                                        }
                                                        let _e1413 = phi_1917_;
                                                        let _e1415 = phi_1918_;
                                                        let _e1417 = phi_1919_;
                                                        phi_1920_ = _e1413;
                                                        phi_1921_ = _e1415;
                                                        phi_1922_ = _e1417;
                                                    }
                                                    let _e1419 = phi_1920_;
                                                    let _e1421 = phi_1921_;
                                                    let _e1423 = phi_1922_;
                                                    phi_1930_ = _e1419;
                                                    phi_1931_ = select(_e1423, true, _e1421);
                                                } else {
                                                    phi_1930_ = type_22();
                                                    phi_1931_ = true;
                                                }
                                                let _e1426 = phi_1930_;
                                                let _e1428 = phi_1931_;
                                                if _e1428 {
                                                    phi_1935_ = type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                } else {
                                                    phi_1935_ = _e1426;
                                                }
                                                let _e1430 = phi_1935_;
                                                if (_e1430.member_3 != 4294967295u) {
                                                    if (_e902 != 4294967295u) {
                                                        phi_1947_ = type_4(0u, 8u);
                                                        phi_1950_ = _e1430;
                                                        loop {
                                                            let _e1435 = phi_1947_;
                                                            let _e1437 = phi_1950_;
                                                            if (_e1435.member < _e1435.member_1) {
                                                                phi_1948_ = type_4((_e1435.member + 1u), _e1435.member_1);
                                                                phi_1973_ = type_4(1u, _e1435.member);
                                                            } else {
                                                                phi_1948_ = _e1435;
                                                                phi_1973_ = type_4(0u, type_4().member_1);
                                                            }
                                                            let _e1450 = phi_1948_;
                                                            let _e1452 = phi_1973_;
                                                            let _e1456 = (bitcast<i32>(_e1452.member) != 0i);
                                                            if _e1456 {
                                                                let _e1457 = (_e1452.member_1 < 8u);
                                                                if _e1457 {
                                                                } else {
                                                                    phi_3251_ = true;
                                                                    break;
                                                                }
                                                                let _e1462 = local_7[_e1452.member_1].member;
                                                                if (_e1437.member < _e1462) {
                                                                    phi_2006_ = true;
                                                                } else {
                                                                    let _e1464 = local_7[_e1452.member_1].member;
                                                                    if (_e1437.member == _e1464) {
                                                                        let _e1469 = local_7[_e1452.member_1].member_3;
                                                                        phi_2005_ = (_e1437.member_3 < _e1469);
                                                                    } else {
                                                                        phi_2005_ = false;
                                                                    }
                                                                    let _e1472 = phi_2005_;
                                                                    phi_2006_ = _e1472;
                                                                }
                                                                let _e1474 = phi_2006_;
                                                                if _e1474 {
                                                                    if _e1457 {
                                                                    } else {
                                                                        phi_3251_ = true;
                                                                        break;
                                                                    }
                                                                    let _e1475 = local_7[_e1452.member_1];
                                                                    local_7[_e1452.member_1] = type_22(_e1437.member, _e1437.member_1, _e1437.member_2, _e1437.member_3);
                                                                    phi_2027_ = type_22(_e1475.member, _e1475.member_1, _e1475.member_2, _e1475.member_3);
                                                                } else {
                                                                    phi_2027_ = _e1437;
                                                                }
                                                                let _e1486 = phi_2027_;
                                                                phi_1951_ = _e1486;
                                                            } else {
                                                                phi_1951_ = type_22();
                                                            }
                                                            let _e1488 = phi_1951_;
                                                            continue;
                                                            continuing {
                                                                phi_1947_ = _e1450;
                                                                phi_1950_ = _e1488;
                                                                phi_3251_ = _e871;
                                                                break if !(_e1456);
                                                            }
                                                        }
                                                        let _e1491 = phi_3251_;
                                                        phi_3507_ = _e873;
                                                        phi_3393_ = _e1491;
                                                        if _e1491 {
                                                            break;
                                                        }
                                                        let _e1494 = local_7[7u].member_3;
                                                        if (_e1494 != 4294967295u) {
                                                            let _e1498 = local_7[7u].member;
                                                            phi_3598_ = _e1498;
                                                        } else {
                                                            phi_3598_ = _e873;
                                                        }
                                                        let _e1500 = phi_3598_;
                                                        phi_3597_ = _e1500;
                                                        phi_3396_ = _e1491;
                                                    } else {
                                                        phi_3597_ = _e873;
                                                        phi_3396_ = _e871;
                                                    }
                                                    let _e1502 = phi_3597_;
                                                    let _e1504 = phi_3396_;
                                                    phi_3596_ = _e1502;
                                                    phi_3395_ = _e1504;
                                                } else {
                                                    phi_3596_ = _e873;
                                                    phi_3395_ = _e871;
                                                }
                                                let _e1506 = phi_3596_;
                                                let _e1508 = phi_3395_;
                                                phi_3595_ = _e1506;
                                                phi_3394_ = _e1508;
                                            } else {
                                                phi_3595_ = _e873;
                                                phi_3394_ = _e871;
                                            }
                                            let _e1510 = phi_3595_;
                                            let _e1512 = phi_3394_;
                                            continue;
                                            continuing {
                                                phi_3260_ = _e1512;
                                                phi_3250_ = _e1510;
                                                phi_957_ = _e888;
                                                phi_3507_ = _e1510;
                                                phi_3393_ = _e1512;
                                                break if !(_e894);
                                            }
                                        }
                                        let _e1515 = phi_3507_;
                                        let _e1517 = phi_3393_;
                                        phi_3398_ = _e1517;
                                        if _e1517 {
                                            break;
                                        }
                                        phi_3472_ = _e1515;
                                        phi_3402_ = _e1517;
                                        phi_2988_ = _e516;
                                        phi_2989_ = false;
                                        phi_2990_ = _e520;
                                    } else {
                                        let _e529 = (_e516.member_1 < _e83);
                                        if _e529 {
                                            if _e529 {
                                            } else {
                                                phi_3398_ = true;
                                                break;
                                            }
                                            let _e531 = global_5.member[_e516.member_1];
                                            phi_2057_ = _e531;
                                        } else {
                                            phi_2057_ = type_44(array<u32, 2>(0u, 0u), array<u32, 2>(0u, 0u), 2147483648u, 2147483648u);
                                        }
                                        let _e533 = phi_2057_;
                                        let _e548 = ((10u * _e245) & 31u);
                                        let _e551 = ((_e533.member[0] >> bitcast<u32>(_e548)) & 1023u);
                                        let _e556 = bitcast<f32>((bitcast<u32>(((_e516.member.member_1[0] - _e516.member.member[0]) * 0.0009775171f)) ^ _e117));
                                        let _e562 = (_e516.member.member[0] + bitcast<f32>((bitcast<u32>((f32(_e551) * _e556)) ^ _e117)));
                                        let _e566 = select(select(_e516.member.member_1[0], _e562, (_e562 < _e516.member.member_1[0])), _e516.member.member_1[0], (_e551 == 1023u));
                                        let _e568 = ((10u * _e244) & 31u);
                                        let _e571 = ((_e533.member[0] >> bitcast<u32>(_e568)) & 1023u);
                                        let _e576 = bitcast<f32>((bitcast<u32>(((_e516.member.member_1[1] - _e516.member.member[1]) * 0.0009775171f)) ^ _e117));
                                        let _e582 = (_e516.member.member[1] + bitcast<f32>((bitcast<u32>((f32(_e571) * _e576)) ^ _e117)));
                                        let _e586 = select(select(_e516.member.member_1[1], _e582, (_e582 < _e516.member.member_1[1])), _e516.member.member_1[1], (_e571 == 1023u));
                                        let _e588 = ((10u * _e246) & 31u);
                                        let _e591 = ((_e533.member[0] >> bitcast<u32>(_e588)) & 1023u);
                                        let _e596 = bitcast<f32>((bitcast<u32>(((_e516.member.member_1[2] - _e516.member.member[2]) * 0.0009775171f)) ^ _e117));
                                        let _e602 = (_e516.member.member[2] + bitcast<f32>((bitcast<u32>((f32(_e591) * _e596)) ^ _e117)));
                                        let _e606 = select(select(_e516.member.member_1[2], _e602, (_e602 < _e516.member.member_1[2])), _e516.member.member_1[2], (_e591 == 1023u));
                                        let _e609 = ((_e533.member[1] >> bitcast<u32>(_e548)) & 1023u);
                                        let _e615 = (_e516.member.member[0] + bitcast<f32>((bitcast<u32>((f32(_e609) * _e556)) ^ _e117)));
                                        let _e619 = select(select(_e516.member.member_1[0], _e615, (_e615 < _e516.member.member_1[0])), _e516.member.member_1[0], (_e609 == 1023u));
                                        let _e622 = ((_e533.member[1] >> bitcast<u32>(_e568)) & 1023u);
                                        let _e628 = (_e516.member.member[1] + bitcast<f32>((bitcast<u32>((f32(_e622) * _e576)) ^ _e117)));
                                        let _e632 = select(select(_e516.member.member_1[1], _e628, (_e628 < _e516.member.member_1[1])), _e516.member.member_1[1], (_e622 == 1023u));
                                        let _e635 = ((_e533.member[1] >> bitcast<u32>(_e588)) & 1023u);
                                        let _e641 = (_e516.member.member[2] + bitcast<f32>((bitcast<u32>((f32(_e635) * _e596)) ^ _e117)));
                                        let _e645 = select(select(_e516.member.member_1[2], _e641, (_e641 < _e516.member.member_1[2])), _e516.member.member_1[2], (_e635 == 1023u));
                                        let _e651 = ((_e533.member_1[0] >> bitcast<u32>(_e548)) & 1023u);
                                        let _e657 = (_e516.member.member[0] + bitcast<f32>((bitcast<u32>((f32(_e651) * _e556)) ^ _e117)));
                                        let _e661 = select(select(_e516.member.member_1[0], _e657, (_e657 < _e516.member.member_1[0])), _e516.member.member_1[0], (_e651 == 1023u));
                                        let _e664 = ((_e533.member_1[0] >> bitcast<u32>(_e568)) & 1023u);
                                        let _e670 = (_e516.member.member[1] + bitcast<f32>((bitcast<u32>((f32(_e664) * _e576)) ^ _e117)));
                                        let _e674 = select(select(_e516.member.member_1[1], _e670, (_e670 < _e516.member.member_1[1])), _e516.member.member_1[1], (_e664 == 1023u));
                                        let _e677 = ((_e533.member_1[0] >> bitcast<u32>(_e588)) & 1023u);
                                        let _e683 = (_e516.member.member[2] + bitcast<f32>((bitcast<u32>((f32(_e677) * _e596)) ^ _e117)));
                                        let _e687 = select(select(_e516.member.member_1[2], _e683, (_e683 < _e516.member.member_1[2])), _e516.member.member_1[2], (_e677 == 1023u));
                                        let _e690 = ((_e533.member_1[1] >> bitcast<u32>(_e548)) & 1023u);
                                        let _e696 = (_e516.member.member[0] + bitcast<f32>((bitcast<u32>((f32(_e690) * _e556)) ^ _e117)));
                                        let _e700 = select(select(_e516.member.member_1[0], _e696, (_e696 < _e516.member.member_1[0])), _e516.member.member_1[0], (_e690 == 1023u));
                                        let _e703 = ((_e533.member_1[1] >> bitcast<u32>(_e568)) & 1023u);
                                        let _e709 = (_e516.member.member[1] + bitcast<f32>((bitcast<u32>((f32(_e703) * _e576)) ^ _e117)));
                                        let _e713 = select(select(_e516.member.member_1[1], _e709, (_e709 < _e516.member.member_1[1])), _e516.member.member_1[1], (_e703 == 1023u));
                                        let _e716 = ((_e533.member_1[1] >> bitcast<u32>(_e588)) & 1023u);
                                        let _e722 = (_e516.member.member[2] + bitcast<f32>((bitcast<u32>((f32(_e716) * _e596)) ^ _e117)));
                                        let _e726 = select(select(_e516.member.member_1[2], _e722, (_e722 < _e516.member.member_1[2])), _e516.member.member_1[2], (_e716 == 1023u));
                                        let _e731 = type_51(type_49(array<f32, 3>(_e566, _e586, _e606), array<f32, 3>(_e619, _e632, _e645)), _e533.member_2);
                                        let _e736 = type_51(type_49(array<f32, 3>(_e661, _e674, _e687), array<f32, 3>(_e700, _e713, _e726)), _e533.member_3);
                                        let _e741 = ((_e566 - _e317) * _e322);
                                        let _e742 = ((_e661 - _e317) * _e322);
                                        let _e743 = ((_e619 - _e318) * _e322);
                                        let _e744 = ((_e700 - _e318) * _e322);
                                        let _e749 = ((_e586 - _e355) * _e360);
                                        let _e750 = ((_e674 - _e355) * _e360);
                                        let _e751 = ((_e632 - _e356) * _e360);
                                        let _e752 = ((_e713 - _e356) * _e360);
                                        let _e757 = ((_e606 - _e393) * _e398);
                                        let _e758 = ((_e687 - _e393) * _e398);
                                        let _e759 = ((_e645 - _e394) * _e398);
                                        let _e760 = ((_e726 - _e394) * _e398);
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
                                        let _e812 = select(_e445, _e782, (_e782 > _e445));
                                        let _e814 = select(_e445, _e784, (_e784 > _e445));
                                        let _e819 = (_e812 <= select(_e478, _e809, (_e809 < _e478)));
                                        let _e820 = (_e814 <= select(_e478, _e810, (_e810 < _e478)));
                                        let _e821 = (_e812 <= _e814);
                                        if _e819 {
                                            if _e820 {
                                                if _e821 {
                                                    phi_2890_ = _e736;
                                                } else {
                                                    phi_2890_ = _e731;
                                                }
                                                let _e823 = phi_2890_;
                                                let _e831 = (_e520 % 128u);
                                                let _e832 = (_e831 < 128u);
                                                if _e832 {
                                                } else {
                                                    phi_3398_ = true;
                                                    break;
                                                }
                                                local_6[_e831] = _e823.member_1;
                                                if _e832 {
                                                } else {
                                                    phi_3398_ = true;
                                                    break;
                                                }
                                                local_5[_e831] = _e823.member.member[0];
                                                if _e832 {
                                                } else {
                                                    phi_3398_ = true;
                                                    break;
                                                }
                                                local_4[_e831] = _e823.member.member[1];
                                                if _e832 {
                                                } else {
                                                    phi_3398_ = true;
                                                    break;
                                                }
                                                local_3[_e831] = _e823.member.member[2];
                                                if _e832 {
                                                } else {
                                                    phi_3398_ = true;
                                                    break;
                                                }
                                                local_2[_e831] = _e823.member.member_1[0];
                                                if _e832 {
                                                } else {
                                                    phi_3398_ = true;
                                                    break;
                                                }
                                                local_1[_e831] = _e823.member.member_1[1];
                                                if _e832 {
                                                } else {
                                                    phi_3398_ = true;
                                                    break;
                                                }
                                                local[_e831] = _e823.member.member_1[2];
                                                if _e832 {
                                                } else {
                                                    phi_3398_ = true;
                                                    break;
                                                }
                                                local_8[_e831] = select(_e814, _e812, (_e812 > _e814));
                                                if _e821 {
                                                    phi_2967_ = _e731;
                                                } else {
                                                    phi_2967_ = _e736;
                                                }
                                                let _e849 = phi_2967_;
                                                phi_2968_ = _e849;
                                                phi_2969_ = (_e520 + 1u);
                                            } else {
                                                phi_2968_ = type_51();
                                                phi_2969_ = u32();
                                            }
                                            let _e851 = phi_2968_;
                                            let _e853 = phi_2969_;
                                            phi_2971_ = _e851;
                                            phi_2972_ = _e853;
                                            phi_2973_ = select(true, false, _e820);
                                        } else {
                                            phi_2971_ = type_51();
                                            phi_2972_ = u32();
                                            phi_2973_ = true;
                                        }
                                        let _e856 = phi_2971_;
                                        let _e858 = phi_2972_;
                                        let _e860 = phi_2973_;
                                        if _e860 {
                                            if _e819 {
                                                phi_2980_ = _e731;
                                            } else {
                                                phi_2980_ = _e736;
                                            }
                                            let _e862 = phi_2980_;
                                            phi_2985_ = _e862;
                                            phi_2986_ = select(_e820, true, _e819);
                                        } else {
                                            phi_2985_ = _e856;
                                            phi_2986_ = _e518;
                                        }
                                        let _e865 = phi_2985_;
                                        let _e867 = phi_2986_;
                                        phi_3472_ = _e478;
                                        phi_3402_ = _e476;
                                        phi_2988_ = _e865;
                                        phi_2989_ = _e867;
                                        phi_2990_ = select(_e858, _e520, _e860);
                                    }
                                    let _e1519 = phi_3472_;
                                    let _e1521 = phi_3402_;
                                    let _e1523 = phi_2988_;
                                    let _e1525 = phi_2989_;
                                    let _e1527 = phi_2990_;
                                    phi_3471_ = _e1519;
                                    phi_3401_ = _e1521;
                                    phi_2991_ = _e1523;
                                    phi_2992_ = (_e482 - 1u);
                                    phi_2993_ = _e1525;
                                    phi_2994_ = _e1527;
                                } else {
                                    phi_3471_ = _e478;
                                    phi_3401_ = _e476;
                                    phi_2991_ = _e516;
                                    phi_2992_ = _e482;
                                    phi_2993_ = _e518;
                                    phi_2994_ = _e520;
                                }
                                let _e1529 = phi_3471_;
                                let _e1531 = phi_3401_;
                                let _e1533 = phi_2991_;
                                let _e1535 = phi_2992_;
                                let _e1537 = phi_2993_;
                                let _e1539 = phi_2994_;
                                phi_3470_ = _e1529;
                                phi_3400_ = _e1531;
                                phi_2995_ = _e1533;
                                phi_2996_ = _e1535;
                                phi_2997_ = _e1537;
                                phi_2998_ = _e1539;
                            } else {
                                phi_3470_ = _e478;
                                phi_3400_ = _e476;
                                phi_2995_ = type_51();
                                phi_2996_ = u32();
                                phi_2997_ = bool();
                                phi_2998_ = u32();
                            }
                            let _e1541 = phi_3470_;
                            let _e1543 = phi_3400_;
                            let _e1545 = phi_2995_;
                            let _e1547 = phi_2996_;
                            let _e1549 = phi_2997_;
                            let _e1551 = phi_2998_;
                            phi_3469_ = _e1541;
                            phi_3399_ = _e1543;
                            phi_833_ = _e1545;
                            phi_836_ = _e1547;
                            phi_838_ = _e1549;
                            phi_840_ = _e1551;
                            phi_2999_ = _e490;
                        } else {
                            phi_3469_ = _e478;
                            phi_3399_ = _e476;
                            phi_833_ = type_51();
                            phi_836_ = u32();
                            phi_838_ = bool();
                            phi_840_ = u32();
                            phi_2999_ = false;
                        }
                        let _e1553 = phi_3469_;
                        let _e1555 = phi_3399_;
                        let _e1557 = phi_833_;
                        let _e1559 = phi_836_;
                        let _e1561 = phi_838_;
                        let _e1563 = phi_840_;
                        let _e1565 = phi_2999_;
                        continue;
                        continuing {
                            phi_3263_ = _e1555;
                            phi_3219_ = _e1553;
                            phi_832_ = _e1557;
                            phi_835_ = _e1559;
                            phi_837_ = _e1561;
                            phi_839_ = _e1563;
                            phi_3398_ = _e1555;
                            break if !(_e1565);
                        }
                    }
                    let _e1568 = phi_3398_;
                    if _e1568 {
                        break;
                    }
                    phi_3006_ = type_4(0u, 8u);
                    loop {
                        let _e1570 = phi_3006_;
                        if (_e1570.member < _e1570.member_1) {
                            phi_3007_ = type_4((_e1570.member + 1u), _e1570.member_1);
                            phi_3030_ = type_4(1u, _e1570.member);
                        } else {
                            phi_3007_ = _e1570;
                            phi_3030_ = type_4(0u, type_4().member_1);
                        }
                        let _e1583 = phi_3007_;
                        let _e1585 = phi_3030_;
                        let _e1589 = (bitcast<i32>(_e1585.member) != 0i);
                        if _e1589 {
                            let _e1590 = (_e1585.member_1 < 8u);
                            if _e1590 {
                            } else {
                                phi_3462_ = true;
                                break;
                            }
                            let _e1592 = local_7[_e1585.member_1];
                            if (_e1592.member_3 != 4294967295u) {
                                let _e1598 = -(_e412);
                                let _e1599 = (_e1598 / 3i);
                                let _e1606 = bitcast<f32>((bitcast<u32>((_e1599 + 127i)) << bitcast<u32>(23i)));
                                let _e1614 = (((_e1592.member * _e1606) * _e1606) * bitcast<f32>((bitcast<u32>(((_e1598 - (2i * _e1599)) + 127i)) << bitcast<u32>(23i))));
                                let _e1616 = select(340282350000000000000000000000000000000f, _e1614, (_e1614 < 340282350000000000000000000000000000000f));
                                phi_3096_ = type_22(select(-340282350000000000000000000000000000000f, _e1616, (_e1616 > -340282350000000000000000000000000000000f)), _e1592.member_1, _e1592.member_2, _e1592.member_3);
                            } else {
                                phi_3096_ = type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                            }
                            let _e1621 = phi_3096_;
                            if _e1590 {
                            } else {
                                phi_3462_ = true;
                                break;
                            }
                            local_7[_e1585.member_1] = type_22(_e1621.member, _e1621.member_1, _e1621.member_2, _e1621.member_3);
                        }
                        continue;
                        continuing {
                            phi_3006_ = _e1583;
                            phi_3462_ = _e1568;
                            break if !(_e1589);
                        }
                    }
                    let _e1629 = phi_3462_;
                    if _e1629 {
                        break;
                    }
                    let _e1630 = local_7;
                    if _e133 {
                    } else {
                        break;
                    }
                    global_6.member[_e131] = array<type_22, 8>(type_22(_e1630[0].member, _e1630[0].member_1, _e1630[0].member_2, _e1630[0].member_3), type_22(_e1630[1].member, _e1630[1].member_1, _e1630[1].member_2, _e1630[1].member_3), type_22(_e1630[2].member, _e1630[2].member_1, _e1630[2].member_2, _e1630[2].member_3), type_22(_e1630[3].member, _e1630[3].member_1, _e1630[3].member_2, _e1630[3].member_3), type_22(_e1630[4].member, _e1630[4].member_1, _e1630[4].member_2, _e1630[4].member_3), type_22(_e1630[5].member, _e1630[5].member_1, _e1630[5].member_2, _e1630[5].member_3), type_22(_e1630[6].member, _e1630[6].member_1, _e1630[6].member_2, _e1630[6].member_3), type_22(_e1630[7].member, _e1630[7].member_1, _e1630[7].member_2, _e1630[7].member_3));
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn trace_nearest_printed_f32_(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
