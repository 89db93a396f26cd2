struct type_4 {
    member: u32,
    member_1: u32,
}

struct type_8 {
    member: vec4<u32>,
}

struct type_18 {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: u32,
}

struct type_19 {
    member: array<f32, 3>,
    member_1: f32,
    member_2: array<f32, 3>,
    member_3: f32,
}

struct type_27 {
    member: array<type_19>,
}

struct type_31 {
    member: array<array<type_18, 8>>,
}

struct type_37 {
    member: array<vec4<u32>, 2>,
}

struct type_39 {
    member: array<u32, 2>,
    member_1: array<u32, 2>,
    member_2: u32,
    member_3: u32,
}

struct type_41 {
    member: array<type_39>,
}

struct type_44 {
    member: array<f32, 3>,
    member_1: array<f32, 3>,
}

struct type_46 {
    member: array<u32, 3>,
    member_1: u32,
}

struct type_48 {
    member: array<type_46>,
}

struct type_52 {
    member: type_44,
    member_1: u32,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_1: type_8;
@group(0) @binding(1) 
var<uniform> global_2: type_37;
@group(0) @binding(4) 
var<storage> global_3: type_27;
@group(0) @binding(2) 
var<storage> global_4: type_41;
@group(0) @binding(5) 
var<storage, read_write> global_5: type_31;
@group(0) @binding(3) 
var<storage> global_6: type_48;

fn function_() {
    var local: array<f32, 128>;
    var local_1: array<f32, 128>;
    var local_2: array<f32, 128>;
    var local_3: array<f32, 128>;
    var local_4: array<f32, 128>;
    var local_5: array<f32, 128>;
    var local_6: array<u32, 128>;
    var local_7: array<type_18, 8>;
    var local_8: array<f32, 128>;
    var local_9: array<f32, 3>;
    var local_10: array<f32, 3>;
    var phi_342_: i32;
    var phi_343_: i32;
    var phi_353_: bool;
    var phi_363_: u32;
    var phi_364_: u32;
    var phi_366_: bool;
    var phi_371_: u32;
    var phi_383_: i32;
    var phi_403_: i32;
    var phi_421_: f32;
    var phi_427_: f32;
    var phi_438_: f32;
    var phi_444_: f32;
    var phi_467_: f32;
    var phi_478_: f32;
    var phi_487_: f32;
    var phi_493_: f32;
    var phi_504_: f32;
    var phi_510_: f32;
    var phi_533_: f32;
    var phi_544_: f32;
    var phi_553_: f32;
    var phi_559_: f32;
    var phi_570_: f32;
    var phi_576_: f32;
    var phi_599_: f32;
    var phi_610_: f32;
    var phi_710_: f32;
    var phi_711_: f32;
    var phi_3468_: bool;
    var phi_3388_: f32;
    var phi_837_: type_52;
    var phi_840_: u32;
    var phi_842_: bool;
    var phi_844_: u32;
    var phi_855_: bool;
    var phi_942_: type_52;
    var phi_943_: bool;
    var phi_944_: u32;
    var phi_2226_: type_39;
    var phi_3059_: type_52;
    var phi_3136_: type_52;
    var phi_3137_: type_52;
    var phi_3138_: u32;
    var phi_3140_: type_52;
    var phi_3141_: u32;
    var phi_3142_: bool;
    var phi_3149_: type_52;
    var phi_3154_: type_52;
    var phi_3155_: bool;
    var phi_3465_: bool;
    var phi_3437_: f32;
    var phi_963_: type_4;
    var phi_964_: type_4;
    var phi_987_: type_4;
    var phi_1012_: u32;
    var phi_1028_: type_46;
    var phi_1405_: bool;
    var phi_1434_: bool;
    var phi_1811_: f32;
    var phi_1812_: f32;
    var phi_1813_: f32;
    var phi_1814_: f32;
    var phi_1815_: vec3<f32>;
    var phi_1816_: vec3<f32>;
    var phi_1817_: vec3<f32>;
    var phi_1818_: vec3<f32>;
    var phi_1849_: bool;
    var phi_1858_: vec3<f32>;
    var phi_2023_: f32;
    var phi_2025_: f32;
    var phi_2026_: bool;
    var phi_2046_: f32;
    var phi_2047_: f32;
    var phi_2070_: type_18;
    var phi_2072_: type_18;
    var phi_2073_: bool;
    var phi_2077_: type_18;
    var phi_2078_: type_18;
    var phi_2079_: type_18;
    var phi_2080_: bool;
    var phi_2084_: type_18;
    var phi_2085_: bool;
    var phi_2086_: type_18;
    var phi_2087_: bool;
    var phi_2088_: bool;
    var phi_2089_: type_18;
    var phi_2090_: bool;
    var phi_2091_: bool;
    var phi_2099_: type_18;
    var phi_2100_: bool;
    var phi_2104_: type_18;
    var phi_2116_: type_4;
    var phi_2119_: type_18;
    var phi_2117_: type_4;
    var phi_2142_: type_4;
    var phi_2174_: bool;
    var phi_2175_: bool;
    var phi_2196_: type_18;
    var phi_2120_: type_18;
    var phi_3438_: bool;
    var phi_3803_: f32;
    var phi_3802_: f32;
    var phi_3601_: bool;
    var phi_3801_: f32;
    var phi_3600_: bool;
    var phi_3800_: f32;
    var phi_3599_: bool;
    var phi_3712_: f32;
    var phi_3598_: bool;
    var phi_3677_: f32;
    var phi_3607_: bool;
    var phi_3157_: type_52;
    var phi_3158_: bool;
    var phi_3159_: u32;
    var phi_3676_: f32;
    var phi_3606_: bool;
    var phi_3160_: type_52;
    var phi_3161_: u32;
    var phi_3162_: bool;
    var phi_3163_: u32;
    var phi_3675_: f32;
    var phi_3605_: bool;
    var phi_3164_: type_52;
    var phi_3165_: u32;
    var phi_3166_: bool;
    var phi_3167_: u32;
    var phi_3674_: f32;
    var phi_3604_: bool;
    var phi_838_: type_52;
    var phi_841_: u32;
    var phi_843_: bool;
    var phi_845_: u32;
    var phi_3168_: bool;
    var phi_3603_: bool;
    var phi_3175_: type_4;
    var phi_3176_: type_4;
    var phi_3199_: type_4;
    var phi_3265_: type_18;
    var phi_3667_: bool;

    switch bitcast<i32>(0u) {
        default: {
            let _e79 = global;
            let _e82 = arrayLength((&global_4.member));
            let _e93 = global_2.member[0u][0u];
            let _e97 = global_2.member[0u][1u];
            let _e101 = global_2.member[0u][2u];
            let _e105 = global_2.member[1u][0u];
            let _e109 = global_2.member[1u][1u];
            let _e113 = global_2.member[1u][2u];
            let _e117 = global_2.member[1u][3u];
            let _e120 = global_1.member[0u];
            let _e121 = bitcast<i32>(_e120);
            let _e131 = (_e79.x + (_e79.y * 2097152u));
            let _e132 = (_e131 < arrayLength((&global_3.member)));
            if _e132 {
                let _e133 = (_e131 < arrayLength((&global_5.member)));
                if _e133 {
                    if _e132 {
                    } else {
                        break;
                    }
                    let _e141 = global_3.member[_e131].member_2[0u];
                    let _e143 = (bitcast<u32>(_e141) & 2147483647u);
                    let _e148 = global_3.member[_e131].member_2[1u];
                    let _e150 = (bitcast<u32>(_e148) & 2147483647u);
                    let _e155 = global_3.member[_e131].member_2[2u];
                    let _e157 = (bitcast<u32>(_e155) & 2147483647u);
                    let _e162 = global_3.member[_e131].member[0u];
                    let _e164 = (bitcast<u32>(_e162) & 2147483647u);
                    let _e169 = global_3.member[_e131].member[1u];
                    let _e171 = (bitcast<u32>(_e169) & 2147483647u);
                    let _e176 = global_3.member[_e131].member[2u];
                    let _e178 = (bitcast<u32>(_e176) & 2147483647u);
                    let _e180 = select(_e150, _e143, (_e150 < _e143));
                    let _e182 = select(_e157, _e180, (_e157 < _e180));
                    let _e184 = select(_e164, _e182, (_e164 < _e182));
                    let _e186 = select(_e171, _e184, (_e171 < _e184));
                    let _e188 = select(_e178, _e186, (_e178 < _e186));
                    let _e192 = global_3.member[_e131].member_1;
                    let _e194 = (bitcast<u32>(_e192) & 2147483647u);
                    let _e201 = global_3.member[_e131].member_3;
                    let _e207 = (((select(_e194, _e188, (_e194 < _e188)) < 2139095040u) && ((bitcast<u32>(_e201) & 2147483647u) <= 2139095040u)) && (_e182 > 0u));
                    if _e207 {
                        let _e210 = (bitcast<u32>(bitcast<f32>(_e182)) & 2147483647u);
                        if (_e210 >= 8388608u) {
                            phi_342_ = (bitcast<i32>((_e210 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_342_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e210)), 32u, (_e210 == 0u))));
                        }
                        let _e224 = phi_342_;
                        phi_343_ = _e224;
                    } else {
                        phi_343_ = 0i;
                    }
                    let _e226 = phi_343_;
                    let _e227 = (_e143 == _e182);
                    if _e227 {
                        phi_353_ = true;
                    } else {
                        phi_353_ = (_e150 == _e182);
                    }
                    let _e230 = phi_353_;
                    let _e231 = select(1u, 0u, _e227);
                    if _e230 {
                        let _e232 = (_e231 + 1u);
                        phi_363_ = _e232;
                        phi_364_ = _e232;
                        phi_366_ = select(true, false, (_e232 == 2u));
                    } else {
                        phi_363_ = u32();
                        phi_364_ = 0u;
                        phi_366_ = true;
                    }
                    let _e236 = phi_363_;
                    let _e238 = phi_364_;
                    let _e240 = phi_366_;
                    if _e240 {
                        phi_371_ = (_e238 + 1u);
                    } else {
                        phi_371_ = 0u;
                    }
                    let _e244 = phi_371_;
                    let _e245 = select(_e236, _e238, _e240);
                    let _e246 = select(_e231, select(2u, _e231, _e230), _e240);
                    if (_e121 < -126i) {
                        phi_383_ = -126i;
                    } else {
                        phi_383_ = select(_e121, 127i, (_e121 > 127i));
                    }
                    let _e251 = phi_383_;
                    let _e256 = bitcast<f32>((bitcast<u32>((_e251 + 127i)) << bitcast<u32>(23i)));
                    let _e262 = bitcast<f32>((bitcast<u32>(((_e121 - _e251) + 127i)) << bitcast<u32>(23i)));
                    let _e263 = -(_e226);
                    if (_e263 < -126i) {
                        phi_403_ = -126i;
                    } else {
                        phi_403_ = select(_e263, 127i, (_e263 > 127i));
                    }
                    let _e268 = phi_403_;
                    let _e273 = bitcast<f32>((bitcast<u32>((_e268 + 127i)) << bitcast<u32>(23i)));
                    let _e279 = bitcast<f32>((bitcast<u32>(((_e263 - _e268) + 127i)) << bitcast<u32>(23i)));
                    let _e283 = global_3.member[_e131].member;
                    let _e284 = (_e245 == 0u);
                    if _e284 {
                        phi_421_ = _e283[0];
                    } else {
                        phi_421_ = _e283[1];
                    }
                    let _e288 = phi_421_;
                    let _e289 = (_e245 == 2u);
                    if _e289 {
                        phi_427_ = _e283[2];
                    } else {
                        phi_427_ = _e288;
                    }
                    let _e292 = phi_427_;
                    let _e294 = ((_e292 * _e256) * _e262);
                    let _e295 = global_3.member[_e131].member_2;
                    if _e284 {
                        phi_438_ = _e295[0];
                    } else {
                        phi_438_ = _e295[1];
                    }
                    let _e299 = phi_438_;
                    if _e289 {
                        phi_444_ = _e295[2];
                    } else {
                        phi_444_ = _e299;
                    }
                    let _e302 = phi_444_;
                    let _e304 = ((_e302 * _e273) * _e279);
                    let _e308 = (bitcast<f32>((bitcast<u32>(_e304) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e308 {
                        let _e312 = (bitcast<f32>((bitcast<u32>(_e294) & 2147483647u)) * 0.00000011920929f);
                        phi_467_ = select(0.00000000000011368684f, _e312, (_e312 > 0.00000000000011368684f));
                    } else {
                        phi_467_ = 0f;
                    }
                    let _e316 = phi_467_;
                    let _e317 = (_e294 + _e316);
                    let _e318 = (_e294 - _e316);
                    let _e319 = select(_e304, 0f, _e308);
                    if _e308 {
                        phi_478_ = 38685626000000000000000000f;
                    } else {
                        phi_478_ = (1f / _e304);
                    }
                    let _e322 = phi_478_;
                    let _e323 = (_e244 == 0u);
                    if _e323 {
                        phi_487_ = _e283[0];
                    } else {
                        phi_487_ = _e283[1];
                    }
                    let _e327 = phi_487_;
                    let _e328 = (_e244 == 2u);
                    if _e328 {
                        phi_493_ = _e283[2];
                    } else {
                        phi_493_ = _e327;
                    }
                    let _e331 = phi_493_;
                    let _e333 = ((_e331 * _e256) * _e262);
                    if _e323 {
                        phi_504_ = _e295[0];
                    } else {
                        phi_504_ = _e295[1];
                    }
                    let _e337 = phi_504_;
                    if _e328 {
                        phi_510_ = _e295[2];
                    } else {
                        phi_510_ = _e337;
                    }
                    let _e340 = phi_510_;
                    let _e342 = ((_e340 * _e273) * _e279);
                    let _e346 = (bitcast<f32>((bitcast<u32>(_e342) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e346 {
                        let _e350 = (bitcast<f32>((bitcast<u32>(_e333) & 2147483647u)) * 0.00000011920929f);
                        phi_533_ = select(0.00000000000011368684f, _e350, (_e350 > 0.00000000000011368684f));
                    } else {
                        phi_533_ = 0f;
                    }
                    let _e354 = phi_533_;
                    let _e355 = (_e333 + _e354);
                    let _e356 = (_e333 - _e354);
                    let _e357 = select(_e342, 0f, _e346);
                    if _e346 {
                        phi_544_ = 38685626000000000000000000f;
                    } else {
                        phi_544_ = (1f / _e342);
                    }
                    let _e360 = phi_544_;
                    let _e361 = (_e246 == 0u);
                    if _e361 {
                        phi_553_ = _e283[0];
                    } else {
                        phi_553_ = _e283[1];
                    }
                    let _e365 = phi_553_;
                    let _e366 = (_e246 == 2u);
                    if _e366 {
                        phi_559_ = _e283[2];
                    } else {
                        phi_559_ = _e365;
                    }
                    let _e369 = phi_559_;
                    let _e371 = ((_e369 * _e256) * _e262);
                    if _e361 {
                        phi_570_ = _e295[0];
                    } else {
                        phi_570_ = _e295[1];
                    }
                    let _e375 = phi_570_;
                    if _e366 {
                        phi_576_ = _e295[2];
                    } else {
                        phi_576_ = _e375;
                    }
                    let _e378 = phi_576_;
                    let _e380 = ((_e378 * _e273) * _e279);
                    let _e384 = (bitcast<f32>((bitcast<u32>(_e380) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e384 {
                        let _e388 = (bitcast<f32>((bitcast<u32>(_e371) & 2147483647u)) * 0.00000011920929f);
                        phi_599_ = select(0.00000000000011368684f, _e388, (_e388 > 0.00000000000011368684f));
                    } else {
                        phi_599_ = 0f;
                    }
                    let _e392 = phi_599_;
                    let _e393 = (_e371 + _e392);
                    let _e394 = (_e371 - _e392);
                    let _e395 = select(_e380, 0f, _e384);
                    if _e384 {
                        phi_610_ = 38685626000000000000000000f;
                    } else {
                        phi_610_ = (1f / _e380);
                    }
                    let _e398 = phi_610_;
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
                        phi_710_ = select(-340282350000000000000000000000000000000f, _e439, (_e439 > -340282350000000000000000000000000000000f));
                        phi_711_ = select(-340282350000000000000000000000000000000f, _e432, (_e432 > -340282350000000000000000000000000000000f));
                    } else {
                        phi_710_ = 0f;
                        phi_711_ = 1f;
                    }
                    let _e443 = phi_710_;
                    let _e445 = phi_711_;
                    local_7 = array<type_18, 8>(type_18(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_18(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_18(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_18(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_18(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_18(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_18(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_18(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u));
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
                    phi_3468_ = false;
                    phi_3388_ = _e443;
                    phi_837_ = type_52(type_44(array<f32, 3>(_e452, _e456, _e460), array<f32, 3>(_e464, _e466, _e468)), select(0u, 2147483648u, (_e82 == 0u)));
                    phi_840_ = ((3u * _e82) + 1u);
                    phi_842_ = (_e445 <= _e443);
                    phi_844_ = 0u;
                    loop {
                        let _e476 = phi_3468_;
                        let _e478 = phi_3388_;
                        let _e480 = phi_837_;
                        let _e482 = phi_840_;
                        let _e484 = phi_842_;
                        let _e486 = phi_844_;
                        if _e484 {
                            phi_855_ = true;
                        } else {
                            phi_855_ = (_e486 > 0u);
                        }
                        let _e489 = phi_855_;
                        if _e489 {
                            let _e490 = (_e482 > 0u);
                            if _e490 {
                                if _e484 {
                                    phi_942_ = _e480;
                                    phi_943_ = _e484;
                                    phi_944_ = _e486;
                                } else {
                                    let _e491 = (_e486 - 1u);
                                    let _e492 = (_e491 % 128u);
                                    let _e493 = (_e492 < 128u);
                                    if _e493 {
                                    } else {
                                        phi_3603_ = true;
                                        break;
                                    }
                                    let _e495 = local_6[_e492];
                                    if _e493 {
                                    } else {
                                        phi_3603_ = true;
                                        break;
                                    }
                                    let _e497 = local_5[_e492];
                                    if _e493 {
                                    } else {
                                        phi_3603_ = true;
                                        break;
                                    }
                                    let _e499 = local_4[_e492];
                                    if _e493 {
                                    } else {
                                        phi_3603_ = true;
                                        break;
                                    }
                                    let _e501 = local_3[_e492];
                                    if _e493 {
                                    } else {
                                        phi_3603_ = true;
                                        break;
                                    }
                                    let _e504 = local_2[_e492];
                                    if _e493 {
                                    } else {
                                        phi_3603_ = true;
                                        break;
                                    }
                                    let _e506 = local_1[_e492];
                                    if _e493 {
                                    } else {
                                        phi_3603_ = true;
                                        break;
                                    }
                                    let _e508 = local[_e492];
                                    if _e493 {
                                    } else {
                                        phi_3603_ = true;
                                        break;
                                    }
                                    let _e513 = local_8[_e492];
                                    phi_942_ = type_52(type_44(array<f32, 3>(_e497, _e499, _e501), array<f32, 3>(_e504, _e506, _e508)), _e495);
                                    phi_943_ = (_e513 <= _e478);
                                    phi_944_ = _e491;
                                }
                                let _e516 = phi_942_;
                                let _e518 = phi_943_;
                                let _e520 = phi_944_;
                                if _e518 {
                                    if ((_e516.member_1 & 2147483648u) != 0u) {
                                        phi_3465_ = _e476;
                                        phi_3437_ = _e478;
                                        phi_963_ = type_4(0u, ((_e516.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e872 = phi_3465_;
                                            let _e874 = phi_3437_;
                                            let _e876 = phi_963_;
                                            if (_e876.member < _e876.member_1) {
                                                phi_964_ = type_4((_e876.member + 1u), _e876.member_1);
                                                phi_987_ = type_4(1u, _e876.member);
                                            } else {
                                                phi_964_ = _e876;
                                                phi_987_ = type_4(0u, type_4().member_1);
                                            }
                                            let _e889 = phi_964_;
                                            let _e891 = phi_987_;
                                            let _e895 = (bitcast<i32>(_e891.member) != 0i);
                                            if _e895 {
                                                let _e896 = ((_e516.member_1 & 268435455u) + _e891.member_1);
                                                let _e897 = (_e896 < arrayLength((&global_6.member)));
                                                if _e897 {
                                                    if _e897 {
                                                    } else {
                                                        phi_3712_ = _e874;
                                                        phi_3598_ = true;
                                                        break;
                                                    }
                                                    let _e900 = global_6.member[_e896].member_1;
                                                    phi_1012_ = _e900;
                                                } else {
                                                    phi_1012_ = 4294967295u;
                                                }
                                                let _e902 = phi_1012_;
                                                if _e897 {
                                                    if _e897 {
                                                    } else {
                                                        phi_3712_ = _e874;
                                                        phi_3598_ = true;
                                                        break;
                                                    }
                                                    let _e904 = global_6.member[_e896];
                                                    phi_1028_ = _e904;
                                                } else {
                                                    phi_1028_ = type_46(array<u32, 3>(0u, 0u, 0u), 4294967295u);
                                                }
                                                let _e906 = phi_1028_;
                                                let _e918 = ((10u * _e245) & 31u);
                                                let _e921 = ((_e906.member[0] >> bitcast<u32>(_e918)) & 1023u);
                                                let _e926 = bitcast<f32>((bitcast<u32>(((_e516.member.member_1[0] - _e516.member.member[0]) * 0.0009775171f)) ^ _e117));
                                                let _e932 = (_e516.member.member[0] + bitcast<f32>((bitcast<u32>((f32(_e921) * _e926)) ^ _e117)));
                                                let _e936 = select(select(_e516.member.member_1[0], _e932, (_e932 < _e516.member.member_1[0])), _e516.member.member_1[0], (_e921 == 1023u));
                                                let _e938 = ((10u * _e244) & 31u);
                                                let _e941 = ((_e906.member[0] >> bitcast<u32>(_e938)) & 1023u);
                                                let _e946 = bitcast<f32>((bitcast<u32>(((_e516.member.member_1[1] - _e516.member.member[1]) * 0.0009775171f)) ^ _e117));
                                                let _e952 = (_e516.member.member[1] + bitcast<f32>((bitcast<u32>((f32(_e941) * _e946)) ^ _e117)));
                                                let _e956 = select(select(_e516.member.member_1[1], _e952, (_e952 < _e516.member.member_1[1])), _e516.member.member_1[1], (_e941 == 1023u));
                                                let _e958 = ((10u * _e246) & 31u);
                                                let _e961 = ((_e906.member[0] >> bitcast<u32>(_e958)) & 1023u);
                                                let _e966 = bitcast<f32>((bitcast<u32>(((_e516.member.member_1[2] - _e516.member.member[2]) * 0.0009775171f)) ^ _e117));
                                                let _e972 = (_e516.member.member[2] + bitcast<f32>((bitcast<u32>((f32(_e961) * _e966)) ^ _e117)));
                                                let _e976 = select(select(_e516.member.member_1[2], _e972, (_e972 < _e516.member.member_1[2])), _e516.member.member_1[2], (_e961 == 1023u));
                                                let _e980 = ((_e906.member[1] >> bitcast<u32>(_e918)) & 1023u);
                                                let _e986 = (_e516.member.member[0] + bitcast<f32>((bitcast<u32>((f32(_e980) * _e926)) ^ _e117)));
                                                let _e990 = select(select(_e516.member.member_1[0], _e986, (_e986 < _e516.member.member_1[0])), _e516.member.member_1[0], (_e980 == 1023u));
                                                let _e993 = ((_e906.member[1] >> bitcast<u32>(_e938)) & 1023u);
                                                let _e999 = (_e516.member.member[1] + bitcast<f32>((bitcast<u32>((f32(_e993) * _e946)) ^ _e117)));
                                                let _e1003 = select(select(_e516.member.member_1[1], _e999, (_e999 < _e516.member.member_1[1])), _e516.member.member_1[1], (_e993 == 1023u));
                                                let _e1006 = ((_e906.member[1] >> bitcast<u32>(_e958)) & 1023u);
                                                let _e1012 = (_e516.member.member[2] + bitcast<f32>((bitcast<u32>((f32(_e1006) * _e966)) ^ _e117)));
                                                let _e1016 = select(select(_e516.member.member_1[2], _e1012, (_e1012 < _e516.member.member_1[2])), _e516.member.member_1[2], (_e1006 == 1023u));
                                                let _e1020 = ((_e906.member[2] >> bitcast<u32>(_e918)) & 1023u);
                                                let _e1026 = (_e516.member.member[0] + bitcast<f32>((bitcast<u32>((f32(_e1020) * _e926)) ^ _e117)));
                                                let _e1030 = select(select(_e516.member.member_1[0], _e1026, (_e1026 < _e516.member.member_1[0])), _e516.member.member_1[0], (_e1020 == 1023u));
                                                let _e1033 = ((_e906.member[2] >> bitcast<u32>(_e938)) & 1023u);
                                                let _e1039 = (_e516.member.member[1] + bitcast<f32>((bitcast<u32>((f32(_e1033) * _e946)) ^ _e117)));
                                                let _e1043 = select(select(_e516.member.member_1[1], _e1039, (_e1039 < _e516.member.member_1[1])), _e516.member.member_1[1], (_e1033 == 1023u));
                                                let _e1046 = ((_e906.member[2] >> bitcast<u32>(_e958)) & 1023u);
                                                let _e1052 = (_e516.member.member[2] + bitcast<f32>((bitcast<u32>((f32(_e1046) * _e966)) ^ _e117)));
                                                let _e1056 = select(select(_e516.member.member_1[2], _e1052, (_e1052 < _e516.member.member_1[2])), _e516.member.member_1[2], (_e1046 == 1023u));
                                                let _e1059 = (_e976 - _e371);
                                                let _e1062 = (((_e936 - _e294) * _e395) - (_e1059 * _e319));
                                                let _e1065 = (((_e956 - _e333) * _e395) - (_e1059 * _e357));
                                                let _e1068 = (_e1016 - _e371);
                                                let _e1071 = (((_e990 - _e294) * _e395) - (_e1068 * _e319));
                                                let _e1074 = (((_e1003 - _e333) * _e395) - (_e1068 * _e357));
                                                let _e1077 = (_e1056 - _e371);
                                                let _e1080 = (((_e1030 - _e294) * _e395) - (_e1077 * _e319));
                                                let _e1083 = (((_e1043 - _e333) * _e395) - (_e1077 * _e357));
                                                let _e1084 = (_e1080 * _e1074);
                                                let _e1085 = (_e1083 * _e1071);
                                                let _e1086 = (_e1062 * _e1083);
                                                let _e1087 = (_e1065 * _e1080);
                                                let _e1088 = (_e1071 * _e1065);
                                                let _e1089 = (_e1074 * _e1062);
                                                let _e1094 = (((_e1084 >= _e1085) && (_e1086 >= _e1087)) && (_e1088 >= _e1089));
                                                if (_e1094 || (((_e1084 <= _e1085) && (_e1086 <= _e1087)) && (_e1088 <= _e1089))) {
                                                    let _e1101 = select(-1f, 1f, _e1094);
                                                    let _e1103 = ((_e1084 - _e1085) * _e1101);
                                                    let _e1105 = select(0f, _e1103, (_e1103 > 0f));
                                                    let _e1107 = ((_e1086 - _e1087) * _e1101);
                                                    let _e1109 = select(0f, _e1107, (_e1107 > 0f));
                                                    let _e1111 = ((_e1088 - _e1089) * _e1101);
                                                    let _e1113 = select(0f, _e1111, (_e1111 > 0f));
                                                    let _e1115 = ((_e1105 + _e1109) + _e1113);
                                                    if (_e1115 < 0.000000000000000000000000000000000000011754944f) {
                                                        phi_2089_ = type_18();
                                                        phi_2090_ = true;
                                                        phi_2091_ = false;
                                                    } else {
                                                        let _e1118 = select(_e1071, _e1062, (_e1062 < _e1071));
                                                        if (select(_e1080, _e1118, (_e1118 < _e1080)) > 0f) {
                                                            phi_1405_ = true;
                                                        } else {
                                                            let _e1123 = select(_e1071, _e1062, (_e1062 > _e1071));
                                                            phi_1405_ = (select(_e1080, _e1123, (_e1123 > _e1080)) < 0f);
                                                        }
                                                        let _e1128 = phi_1405_;
                                                        if _e1128 {
                                                            phi_2086_ = type_18();
                                                            phi_2087_ = true;
                                                            phi_2088_ = false;
                                                        } else {
                                                            let _e1130 = select(_e1074, _e1065, (_e1065 < _e1074));
                                                            if (select(_e1083, _e1130, (_e1130 < _e1083)) > 0f) {
                                                                phi_1434_ = true;
                                                            } else {
                                                                let _e1135 = select(_e1074, _e1065, (_e1065 > _e1074));
                                                                phi_1434_ = (select(_e1083, _e1135, (_e1135 > _e1083)) < 0f);
                                                            }
                                                            let _e1140 = phi_1434_;
                                                            if _e1140 {
                                                                phi_2084_ = type_18();
                                                                phi_2085_ = false;
                                                            } else {
                                                                let _e1142 = select(_e990, _e936, (_e936 < _e990));
                                                                let _e1146 = select(_e990, _e936, (_e936 > _e990));
                                                                let _e1150 = select(_e1003, _e956, (_e956 < _e1003));
                                                                let _e1154 = select(_e1003, _e956, (_e956 > _e1003));
                                                                let _e1158 = select(_e1016, _e976, (_e976 < _e1016));
                                                                let _e1162 = select(_e1016, _e976, (_e976 > _e1016));
                                                                let _e1167 = ((select(_e1030, _e1142, (_e1142 < _e1030)) - _e317) * _e322);
                                                                let _e1168 = ((select(_e1030, _e1146, (_e1146 > _e1030)) - _e318) * _e322);
                                                                let _e1171 = ((select(_e1043, _e1150, (_e1150 < _e1043)) - _e355) * _e360);
                                                                let _e1172 = ((select(_e1043, _e1154, (_e1154 > _e1043)) - _e356) * _e360);
                                                                let _e1175 = ((select(_e1056, _e1158, (_e1158 < _e1056)) - _e393) * _e398);
                                                                let _e1176 = ((select(_e1056, _e1162, (_e1162 > _e1056)) - _e394) * _e398);
                                                                let _e1178 = select(_e1176, _e1175, (_e1175 < _e1176));
                                                                let _e1180 = select(_e1176, _e1175, (_e1175 > _e1176));
                                                                let _e1182 = select(_e1168, _e1167, (_e1167 < _e1168));
                                                                let _e1184 = select(_e1172, _e1171, (_e1171 < _e1172));
                                                                let _e1186 = select(_e1184, _e1182, (_e1182 > _e1184));
                                                                let _e1188 = select(_e1178, _e1186, (_e1186 > _e1178));
                                                                let _e1190 = select(_e1168, _e1167, (_e1167 > _e1168));
                                                                let _e1192 = select(_e1172, _e1171, (_e1171 > _e1172));
                                                                let _e1194 = select(_e1192, _e1190, (_e1190 < _e1192));
                                                                let _e1196 = select(_e1180, _e1194, (_e1194 < _e1180));
                                                                let _e1197 = -(_e1178);
                                                                let _e1203 = select(_e445, _e1188, (_e1188 > _e445));
                                                                if (_e1203 > (_e1196 + (select(_e1197, _e1180, (_e1180 > _e1197)) * 0.0000019073523f))) {
                                                                    phi_2079_ = type_18();
                                                                    phi_2080_ = true;
                                                                } else {
                                                                    let _e1205 = (_e1203 > _e874);
                                                                    if _e1205 {
                                                                        phi_2078_ = type_18();
                                                                    } else {
                                                                        let _e1206 = vec3<f32>(_e936, _e956, _e976);
                                                                        let _e1207 = vec3<f32>(_e990, _e1003, _e1016);
                                                                        let _e1208 = vec3<f32>(_e1030, _e1043, _e1056);
                                                                        let _e1209 = (_e990 - _e936);
                                                                        let _e1210 = (_e1003 - _e956);
                                                                        let _e1211 = (_e1016 - _e976);
                                                                        let _e1212 = vec3<f32>(_e1209, _e1210, _e1211);
                                                                        let _e1213 = (_e1030 - _e990);
                                                                        let _e1214 = (_e1043 - _e1003);
                                                                        let _e1215 = (_e1056 - _e1016);
                                                                        let _e1216 = vec3<f32>(_e1213, _e1214, _e1215);
                                                                        let _e1217 = (_e936 - _e1030);
                                                                        let _e1218 = (_e956 - _e1043);
                                                                        let _e1219 = (_e976 - _e1056);
                                                                        let _e1220 = vec3<f32>(_e1217, _e1218, _e1219);
                                                                        let _e1223 = bitcast<f32>((bitcast<u32>(_e1209) & 2147483647u));
                                                                        let _e1226 = bitcast<f32>((bitcast<u32>(_e1210) & 2147483647u));
                                                                        let _e1228 = select(_e1226, _e1223, (_e1223 > _e1226));
                                                                        let _e1231 = bitcast<f32>((bitcast<u32>(_e1211) & 2147483647u));
                                                                        let _e1233 = select(_e1231, _e1228, (_e1228 > _e1231));
                                                                        let _e1236 = bitcast<f32>((bitcast<u32>(_e1213) & 2147483647u));
                                                                        let _e1239 = bitcast<f32>((bitcast<u32>(_e1214) & 2147483647u));
                                                                        let _e1241 = select(_e1239, _e1236, (_e1236 > _e1239));
                                                                        let _e1244 = bitcast<f32>((bitcast<u32>(_e1215) & 2147483647u));
                                                                        let _e1246 = select(_e1244, _e1241, (_e1241 > _e1244));
                                                                        let _e1249 = bitcast<f32>((bitcast<u32>(_e1217) & 2147483647u));
                                                                        let _e1252 = bitcast<f32>((bitcast<u32>(_e1218) & 2147483647u));
                                                                        let _e1254 = select(_e1252, _e1249, (_e1249 > _e1252));
                                                                        let _e1257 = bitcast<f32>((bitcast<u32>(_e1219) & 2147483647u));
                                                                        let _e1259 = select(_e1257, _e1254, (_e1254 > _e1257));
                                                                        let _e1261 = select(_e1246, _e1233, (_e1233 > _e1246));
                                                                        let _e1263 = select(_e1259, _e1261, (_e1261 > _e1259));
                                                                        if (_e1233 == _e1263) {
                                                                            phi_1811_ = _e1074;
                                                                            phi_1812_ = _e1071;
                                                                            phi_1813_ = _e1065;
                                                                            phi_1814_ = _e1062;
                                                                            phi_1815_ = _e1206;
                                                                            phi_1816_ = _e1220;
                                                                            phi_1817_ = _e1216;
                                                                            phi_1818_ = _e1212;
                                                                        } else {
                                                                            let _e1265 = (_e1246 == _e1263);
                                                                            let _e1270 = vec3(_e1265);
                                                                            phi_1811_ = select(_e1065, _e1083, _e1265);
                                                                            phi_1812_ = select(_e1062, _e1080, _e1265);
                                                                            phi_1813_ = select(_e1083, _e1074, _e1265);
                                                                            phi_1814_ = select(_e1080, _e1071, _e1265);
                                                                            phi_1815_ = select(_e1208, _e1207, _e1270);
                                                                            phi_1816_ = select(_e1216, _e1212, _e1270);
                                                                            phi_1817_ = select(_e1212, _e1220, _e1270);
                                                                            phi_1818_ = select(_e1220, _e1216, _e1270);
                                                                        }
                                                                        let _e1276 = phi_1811_;
                                                                        let _e1278 = phi_1812_;
                                                                        let _e1280 = phi_1813_;
                                                                        let _e1282 = phi_1814_;
                                                                        let _e1284 = phi_1815_;
                                                                        let _e1286 = phi_1816_;
                                                                        let _e1288 = phi_1817_;
                                                                        let _e1290 = phi_1818_;
                                                                        let _e1297 = ((_e1288.y * _e1286.z) - (_e1286.y * _e1288.z));
                                                                        let _e1302 = ((_e1288.z * _e1286.x) - (_e1286.z * _e1288.x));
                                                                        let _e1305 = ((_e1288.x * _e1286.y) - (_e1286.x * _e1288.y));
                                                                        if (_e1105 >= _e1109) {
                                                                            phi_1849_ = select(true, false, (_e1105 >= _e1113));
                                                                        } else {
                                                                            phi_1849_ = true;
                                                                        }
                                                                        let _e1310 = phi_1849_;
                                                                        if _e1310 {
                                                                            phi_1858_ = select(_e1208, _e1207, vec3((_e1109 >= _e1113)));
                                                                        } else {
                                                                            phi_1858_ = _e1206;
                                                                        }
                                                                        let _e1315 = phi_1858_;
                                                                        let _e1326 = (((_e1297 * (_e1315.x - _e294)) + (_e1302 * (_e1315.y - _e333))) + (_e1305 * (_e1315.z - _e371)));
                                                                        let _e1331 = (((_e1297 * _e319) + (_e1302 * _e357)) + (_e1305 * _e395));
                                                                        let _e1332 = (_e1278 - _e1282);
                                                                        let _e1333 = (_e1276 - _e1280);
                                                                        let _e1341 = (-(((_e1282 * _e1332) + (_e1280 * _e1333))) / ((_e1332 * _e1332) + (_e1333 * _e1333)));
                                                                        let _e1343 = select(1f, _e1341, (_e1341 < 1f));
                                                                        let _e1345 = select(0f, _e1343, (_e1343 > 0f));
                                                                        let _e1358 = ((_e1284.x + (_e1290.x * _e1345)) - _e294);
                                                                        let _e1359 = ((_e1284.y + (_e1290.y * _e1345)) - _e333);
                                                                        let _e1360 = ((_e1284.z + (_e1290.z * _e1345)) - _e371);
                                                                        let _e1361 = (_e1360 / _e395);
                                                                        let _e1373 = bitcast<f32>((bitcast<u32>(_e1358) & 2147483647u));
                                                                        let _e1376 = bitcast<f32>((bitcast<u32>(_e1359) & 2147483647u));
                                                                        let _e1378 = select(_e1376, _e1373, (_e1373 > _e1376));
                                                                        let _e1381 = bitcast<f32>((bitcast<u32>(_e1360) & 2147483647u));
                                                                        let _e1383 = select(_e1381, _e1378, (_e1378 > _e1381));
                                                                        let _e1389 = bitcast<f32>((bitcast<u32>(_e1297) & 2147483647u));
                                                                        let _e1392 = bitcast<f32>((bitcast<u32>(_e1302) & 2147483647u));
                                                                        let _e1394 = select(_e1392, _e1389, (_e1389 > _e1392));
                                                                        let _e1397 = bitcast<f32>((bitcast<u32>(_e1305) & 2147483647u));
                                                                        if (bitcast<f32>((bitcast<u32>(((((_e1297 * _e1358) + (_e1302 * _e1359)) + (_e1305 * _e1360)) - _e1326)) & 2147483647u)) <= ((0.0000009536743f * select(_e1263, _e1383, (_e1383 > _e1263))) * select(_e1397, _e1394, (_e1394 > _e1397)))) {
                                                                            let _e1407 = bitcast<f32>((bitcast<u32>(_e1288.x) & 2147483647u));
                                                                            let _e1410 = bitcast<f32>((bitcast<u32>(_e1288.y) & 2147483647u));
                                                                            let _e1412 = select(_e1410, _e1407, (_e1407 > _e1410));
                                                                            let _e1415 = bitcast<f32>((bitcast<u32>(_e1288.z) & 2147483647u));
                                                                            let _e1421 = bitcast<f32>((bitcast<u32>(_e1286.x) & 2147483647u));
                                                                            let _e1424 = bitcast<f32>((bitcast<u32>(_e1286.y) & 2147483647u));
                                                                            let _e1426 = select(_e1424, _e1421, (_e1421 > _e1424));
                                                                            let _e1429 = bitcast<f32>((bitcast<u32>(_e1286.z) & 2147483647u));
                                                                            let _e1433 = (bitcast<f32>((bitcast<u32>(_e1331) & 2147483647u)) > ((0.0000038146973f * select(_e1415, _e1412, (_e1412 > _e1415))) * select(_e1429, _e1426, (_e1426 > _e1429))));
                                                                            if _e1433 {
                                                                                phi_2023_ = (_e1326 / _e1331);
                                                                            } else {
                                                                                phi_2023_ = f32();
                                                                            }
                                                                            let _e1436 = phi_2023_;
                                                                            phi_2025_ = _e1436;
                                                                            phi_2026_ = select(true, false, _e1433);
                                                                        } else {
                                                                            phi_2025_ = f32();
                                                                            phi_2026_ = true;
                                                                        }
                                                                        let _e1439 = phi_2025_;
                                                                        let _e1441 = phi_2026_;
                                                                        if _e1441 {
                                                                            let _e1449 = (((_e1297 * (_e1358 - (_e319 * _e1361))) + (_e1302 * (_e1359 - (_e357 * _e1361)))) / _e1331);
                                                                            if (bitcast<f32>((bitcast<u32>(_e1449) & 2147483647u)) <= _e1263) {
                                                                                phi_2046_ = (_e1361 + _e1449);
                                                                            } else {
                                                                                phi_2046_ = _e1361;
                                                                            }
                                                                            let _e1456 = phi_2046_;
                                                                            phi_2047_ = _e1456;
                                                                        } else {
                                                                            phi_2047_ = _e1439;
                                                                        }
                                                                        let _e1458 = phi_2047_;
                                                                        let _e1460 = select(_e1196, _e1458, (_e1458 < _e1196));
                                                                        let _e1462 = select(_e1188, _e1460, (_e1460 > _e1188));
                                                                        if (_e1462 >= _e445) {
                                                                            let _e1464 = (_e1462 <= _e874);
                                                                            if _e1464 {
                                                                                let _e1465 = (1f / _e1115);
                                                                                phi_2070_ = type_18(_e1462, (_e1109 * _e1465), (_e1113 * _e1465), _e902);
                                                                            } else {
                                                                                phi_2070_ = type_18();
                                                                            }
                                                                            let _e1470 = phi_2070_;
                                                                            phi_2072_ = _e1470;
                                                                            phi_2073_ = select(true, false, _e1464);
                                                                        } else {
                                                                            phi_2072_ = type_18();
                                                                            phi_2073_ = true;
                                                                        }
                                                                        let _e1473 = phi_2072_;
                                                                        let _e1475 = phi_2073_;
                                                                        if _e1475 {
                                                                            phi_2077_ = type_18(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                        } else {
                                                                            phi_2077_ = _e1473;
                                                                        }
                                                                        let _e1477 = phi_2077_;
                                                                        phi_2078_ = _e1477;
                                                                    }
                                                                    let _e1479 = phi_2078_;
                                                                    phi_2079_ = _e1479;
                                                                    phi_2080_ = _e1205;
                                                                }
                                                                let _e1481 = phi_2079_;
                                                                let _e1483 = phi_2080_;
                                                                phi_2084_ = _e1481;
                                                                phi_2085_ = _e1483;
                                                            }
                                                            let _e1485 = phi_2084_;
                                                            let _e1487 = phi_2085_;
                                                            phi_2086_ = _e1485;
                                                            phi_2087_ = _e1140;
                                                            phi_2088_ = _e1487;
                                                        }
                                                        let _e1489 = phi_2086_;
                                                        let _e1491 = phi_2087_;
                                                        let _e1493 = phi_2088_;
                                                        phi_2089_ = _e1489;
                                                        phi_2090_ = _e1491;
                                                        phi_2091_ = _e1493;
                                                    }
                                                    let _e1495 = phi_2089_;
                                                    let _e1497 = phi_2090_;
                                                    let _e1499 = phi_2091_;
                                                    phi_2099_ = _e1495;
                                                    phi_2100_ = select(_e1499, true, _e1497);
                                                } else {
                                                    phi_2099_ = type_18();
                                                    phi_2100_ = true;
                                                }
                                                let _e1502 = phi_2099_;
                                                let _e1504 = phi_2100_;
                                                if _e1504 {
                                                    phi_2104_ = type_18(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                } else {
                                                    phi_2104_ = _e1502;
                                                }
                                                let _e1506 = phi_2104_;
                                                if (_e1506.member_3 != 4294967295u) {
                                                    if (_e902 != 4294967295u) {
                                                        phi_2116_ = type_4(0u, 8u);
                                                        phi_2119_ = _e1506;
                                                        loop {
                                                            let _e1511 = phi_2116_;
                                                            let _e1513 = phi_2119_;
                                                            if (_e1511.member < _e1511.member_1) {
                                                                phi_2117_ = type_4((_e1511.member + 1u), _e1511.member_1);
                                                                phi_2142_ = type_4(1u, _e1511.member);
                                                            } else {
                                                                phi_2117_ = _e1511;
                                                                phi_2142_ = type_4(0u, type_4().member_1);
                                                            }
                                                            let _e1526 = phi_2117_;
                                                            let _e1528 = phi_2142_;
                                                            let _e1532 = (bitcast<i32>(_e1528.member) != 0i);
                                                            if _e1532 {
                                                                let _e1533 = (_e1528.member_1 < 8u);
                                                                if _e1533 {
                                                                } else {
                                                                    phi_3438_ = true;
                                                                    break;
                                                                }
                                                                let _e1538 = local_7[_e1528.member_1].member;
                                                                if (_e1513.member < _e1538) {
                                                                    phi_2175_ = true;
                                                                } else {
                                                                    let _e1540 = local_7[_e1528.member_1].member;
                                                                    if (_e1513.member == _e1540) {
                                                                        let _e1545 = local_7[_e1528.member_1].member_3;
                                                                        phi_2174_ = (_e1513.member_3 < _e1545);
                                                                    } else {
                                                                        phi_2174_ = false;
                                                                    }
                                                                    let _e1548 = phi_2174_;
                                                                    phi_2175_ = _e1548;
                                                                }
                                                                let _e1550 = phi_2175_;
                                                                if _e1550 {
                                                                    if _e1533 {
                                                                    } else {
                                                                        phi_3438_ = true;
                                                                        break;
                                                                    }
                                                                    let _e1551 = local_7[_e1528.member_1];
                                                                    local_7[_e1528.member_1] = type_18(_e1513.member, _e1513.member_1, _e1513.member_2, _e1513.member_3);
                                                                    phi_2196_ = type_18(_e1551.member, _e1551.member_1, _e1551.member_2, _e1551.member_3);
                                                                } else {
                                                                    phi_2196_ = _e1513;
                                                                }
                                                                let _e1562 = phi_2196_;
                                                                phi_2120_ = _e1562;
                                                            } else {
                                                                phi_2120_ = type_18();
                                                            }
                                                            let _e1564 = phi_2120_;
                                                            continue;
                                                            continuing {
                                                                phi_2116_ = _e1526;
                                                                phi_2119_ = _e1564;
                                                                phi_3438_ = _e872;
                                                                break if !(_e1532);
                                                            }
                                                        }
                                                        let _e1567 = phi_3438_;
                                                        phi_3712_ = _e874;
                                                        phi_3598_ = _e1567;
                                                        if _e1567 {
                                                            break;
                                                        }
                                                        let _e1570 = local_7[7u].member_3;
                                                        if (_e1570 != 4294967295u) {
                                                            let _e1574 = local_7[7u].member;
                                                            phi_3803_ = _e1574;
                                                        } else {
                                                            phi_3803_ = _e874;
                                                        }
                                                        let _e1576 = phi_3803_;
                                                        phi_3802_ = _e1576;
                                                        phi_3601_ = _e1567;
                                                    } else {
                                                        phi_3802_ = _e874;
                                                        phi_3601_ = _e872;
                                                    }
                                                    let _e1578 = phi_3802_;
                                                    let _e1580 = phi_3601_;
                                                    phi_3801_ = _e1578;
                                                    phi_3600_ = _e1580;
                                                } else {
                                                    phi_3801_ = _e874;
                                                    phi_3600_ = _e872;
                                                }
                                                let _e1582 = phi_3801_;
                                                let _e1584 = phi_3600_;
                                                phi_3800_ = _e1582;
                                                phi_3599_ = _e1584;
                                            } else {
                                                phi_3800_ = _e874;
                                                phi_3599_ = _e872;
                                            }
                                            let _e1586 = phi_3800_;
                                            let _e1588 = phi_3599_;
                                            continue;
                                            continuing {
                                                phi_3465_ = _e1588;
                                                phi_3437_ = _e1586;
                                                phi_963_ = _e889;
                                                phi_3712_ = _e1586;
                                                phi_3598_ = _e1588;
                                                break if !(_e895);
                                            }
                                        }
                                        let _e1591 = phi_3712_;
                                        let _e1593 = phi_3598_;
                                        phi_3603_ = _e1593;
                                        if _e1593 {
                                            break;
                                        }
                                        phi_3677_ = _e1591;
                                        phi_3607_ = _e1593;
                                        phi_3157_ = _e516;
                                        phi_3158_ = false;
                                        phi_3159_ = _e520;
                                    } else {
                                        let _e530 = (_e516.member_1 < _e82);
                                        if _e530 {
                                            if _e530 {
                                            } else {
                                                phi_3603_ = true;
                                                break;
                                            }
                                            let _e532 = global_4.member[_e516.member_1];
                                            phi_2226_ = _e532;
                                        } else {
                                            phi_2226_ = type_39(array<u32, 2>(0u, 0u), array<u32, 2>(0u, 0u), 2147483648u, 2147483648u);
                                        }
                                        let _e534 = phi_2226_;
                                        let _e549 = ((10u * _e245) & 31u);
                                        let _e552 = ((_e534.member[0] >> bitcast<u32>(_e549)) & 1023u);
                                        let _e557 = bitcast<f32>((bitcast<u32>(((_e516.member.member_1[0] - _e516.member.member[0]) * 0.0009775171f)) ^ _e117));
                                        let _e563 = (_e516.member.member[0] + bitcast<f32>((bitcast<u32>((f32(_e552) * _e557)) ^ _e117)));
                                        let _e567 = select(select(_e516.member.member_1[0], _e563, (_e563 < _e516.member.member_1[0])), _e516.member.member_1[0], (_e552 == 1023u));
                                        let _e569 = ((10u * _e244) & 31u);
                                        let _e572 = ((_e534.member[0] >> bitcast<u32>(_e569)) & 1023u);
                                        let _e577 = bitcast<f32>((bitcast<u32>(((_e516.member.member_1[1] - _e516.member.member[1]) * 0.0009775171f)) ^ _e117));
                                        let _e583 = (_e516.member.member[1] + bitcast<f32>((bitcast<u32>((f32(_e572) * _e577)) ^ _e117)));
                                        let _e587 = select(select(_e516.member.member_1[1], _e583, (_e583 < _e516.member.member_1[1])), _e516.member.member_1[1], (_e572 == 1023u));
                                        let _e589 = ((10u * _e246) & 31u);
                                        let _e592 = ((_e534.member[0] >> bitcast<u32>(_e589)) & 1023u);
                                        let _e597 = bitcast<f32>((bitcast<u32>(((_e516.member.member_1[2] - _e516.member.member[2]) * 0.0009775171f)) ^ _e117));
                                        let _e603 = (_e516.member.member[2] + bitcast<f32>((bitcast<u32>((f32(_e592) * _e597)) ^ _e117)));
                                        let _e607 = select(select(_e516.member.member_1[2], _e603, (_e603 < _e516.member.member_1[2])), _e516.member.member_1[2], (_e592 == 1023u));
                                        let _e610 = ((_e534.member[1] >> bitcast<u32>(_e549)) & 1023u);
                                        let _e616 = (_e516.member.member[0] + bitcast<f32>((bitcast<u32>((f32(_e610) * _e557)) ^ _e117)));
                                        let _e620 = select(select(_e516.member.member_1[0], _e616, (_e616 < _e516.member.member_1[0])), _e516.member.member_1[0], (_e610 == 1023u));
                                        let _e623 = ((_e534.member[1] >> bitcast<u32>(_e569)) & 1023u);
                                        let _e629 = (_e516.member.member[1] + bitcast<f32>((bitcast<u32>((f32(_e623) * _e577)) ^ _e117)));
                                        let _e633 = select(select(_e516.member.member_1[1], _e629, (_e629 < _e516.member.member_1[1])), _e516.member.member_1[1], (_e623 == 1023u));
                                        let _e636 = ((_e534.member[1] >> bitcast<u32>(_e589)) & 1023u);
                                        let _e642 = (_e516.member.member[2] + bitcast<f32>((bitcast<u32>((f32(_e636) * _e597)) ^ _e117)));
                                        let _e646 = select(select(_e516.member.member_1[2], _e642, (_e642 < _e516.member.member_1[2])), _e516.member.member_1[2], (_e636 == 1023u));
                                        let _e652 = ((_e534.member_1[0] >> bitcast<u32>(_e549)) & 1023u);
                                        let _e658 = (_e516.member.member[0] + bitcast<f32>((bitcast<u32>((f32(_e652) * _e557)) ^ _e117)));
                                        let _e662 = select(select(_e516.member.member_1[0], _e658, (_e658 < _e516.member.member_1[0])), _e516.member.member_1[0], (_e652 == 1023u));
                                        let _e665 = ((_e534.member_1[0] >> bitcast<u32>(_e569)) & 1023u);
                                        let _e671 = (_e516.member.member[1] + bitcast<f32>((bitcast<u32>((f32(_e665) * _e577)) ^ _e117)));
                                        let _e675 = select(select(_e516.member.member_1[1], _e671, (_e671 < _e516.member.member_1[1])), _e516.member.member_1[1], (_e665 == 1023u));
                                        let _e678 = ((_e534.member_1[0] >> bitcast<u32>(_e589)) & 1023u);
                                        let _e684 = (_e516.member.member[2] + bitcast<f32>((bitcast<u32>((f32(_e678) * _e597)) ^ _e117)));
                                        let _e688 = select(select(_e516.member.member_1[2], _e684, (_e684 < _e516.member.member_1[2])), _e516.member.member_1[2], (_e678 == 1023u));
                                        let _e691 = ((_e534.member_1[1] >> bitcast<u32>(_e549)) & 1023u);
                                        let _e697 = (_e516.member.member[0] + bitcast<f32>((bitcast<u32>((f32(_e691) * _e557)) ^ _e117)));
                                        let _e701 = select(select(_e516.member.member_1[0], _e697, (_e697 < _e516.member.member_1[0])), _e516.member.member_1[0], (_e691 == 1023u));
                                        let _e704 = ((_e534.member_1[1] >> bitcast<u32>(_e569)) & 1023u);
                                        let _e710 = (_e516.member.member[1] + bitcast<f32>((bitcast<u32>((f32(_e704) * _e577)) ^ _e117)));
                                        let _e714 = select(select(_e516.member.member_1[1], _e710, (_e710 < _e516.member.member_1[1])), _e516.member.member_1[1], (_e704 == 1023u));
                                        let _e717 = ((_e534.member_1[1] >> bitcast<u32>(_e589)) & 1023u);
                                        let _e723 = (_e516.member.member[2] + bitcast<f32>((bitcast<u32>((f32(_e717) * _e597)) ^ _e117)));
                                        let _e727 = select(select(_e516.member.member_1[2], _e723, (_e723 < _e516.member.member_1[2])), _e516.member.member_1[2], (_e717 == 1023u));
                                        let _e732 = type_52(type_44(array<f32, 3>(_e567, _e587, _e607), array<f32, 3>(_e620, _e633, _e646)), _e534.member_2);
                                        let _e737 = type_52(type_44(array<f32, 3>(_e662, _e675, _e688), array<f32, 3>(_e701, _e714, _e727)), _e534.member_3);
                                        let _e742 = ((_e567 - _e317) * _e322);
                                        let _e743 = ((_e662 - _e317) * _e322);
                                        let _e744 = ((_e620 - _e318) * _e322);
                                        let _e745 = ((_e701 - _e318) * _e322);
                                        let _e750 = ((_e587 - _e355) * _e360);
                                        let _e751 = ((_e675 - _e355) * _e360);
                                        let _e752 = ((_e633 - _e356) * _e360);
                                        let _e753 = ((_e714 - _e356) * _e360);
                                        let _e758 = ((_e607 - _e393) * _e398);
                                        let _e759 = ((_e688 - _e393) * _e398);
                                        let _e760 = ((_e646 - _e394) * _e398);
                                        let _e761 = ((_e727 - _e394) * _e398);
                                        let _e763 = select(_e760, _e758, (_e758 < _e760));
                                        let _e765 = select(_e761, _e759, (_e759 < _e761));
                                        let _e767 = select(_e760, _e758, (_e758 > _e760));
                                        let _e769 = select(_e761, _e759, (_e759 > _e761));
                                        let _e771 = select(_e744, _e742, (_e742 < _e744));
                                        let _e773 = select(_e745, _e743, (_e743 < _e745));
                                        let _e775 = select(_e752, _e750, (_e750 < _e752));
                                        let _e777 = select(_e753, _e751, (_e751 < _e753));
                                        let _e779 = select(_e775, _e771, (_e771 > _e775));
                                        let _e781 = select(_e777, _e773, (_e773 > _e777));
                                        let _e783 = select(_e763, _e779, (_e779 > _e763));
                                        let _e785 = select(_e765, _e781, (_e781 > _e765));
                                        let _e787 = select(_e744, _e742, (_e742 > _e744));
                                        let _e789 = select(_e745, _e743, (_e743 > _e745));
                                        let _e791 = select(_e752, _e750, (_e750 > _e752));
                                        let _e793 = select(_e753, _e751, (_e751 > _e753));
                                        let _e795 = select(_e791, _e787, (_e787 < _e791));
                                        let _e797 = select(_e793, _e789, (_e789 < _e793));
                                        let _e802 = -(_e763);
                                        let _e803 = -(_e765);
                                        let _e810 = (select(_e767, _e795, (_e795 < _e767)) + (select(_e802, _e767, (_e767 > _e802)) * 0.0000019073523f));
                                        let _e811 = (select(_e769, _e797, (_e797 < _e769)) + (select(_e803, _e769, (_e769 > _e803)) * 0.0000019073523f));
                                        let _e813 = select(_e445, _e783, (_e783 > _e445));
                                        let _e815 = select(_e445, _e785, (_e785 > _e445));
                                        let _e820 = (_e813 <= select(_e478, _e810, (_e810 < _e478)));
                                        let _e821 = (_e815 <= select(_e478, _e811, (_e811 < _e478)));
                                        let _e822 = (_e813 <= _e815);
                                        if _e820 {
                                            if _e821 {
                                                if _e822 {
                                                    phi_3059_ = _e737;
                                                } else {
                                                    phi_3059_ = _e732;
                                                }
                                                let _e824 = phi_3059_;
                                                let _e832 = (_e520 % 128u);
                                                let _e833 = (_e832 < 128u);
                                                if _e833 {
                                                } else {
                                                    phi_3603_ = true;
                                                    break;
                                                }
                                                local_6[_e832] = _e824.member_1;
                                                if _e833 {
                                                } else {
                                                    phi_3603_ = true;
                                                    break;
                                                }
                                                local_5[_e832] = _e824.member.member[0];
                                                if _e833 {
                                                } else {
                                                    phi_3603_ = true;
                                                    break;
                                                }
                                                local_4[_e832] = _e824.member.member[1];
                                                if _e833 {
                                                } else {
                                                    phi_3603_ = true;
                                                    break;
                                                }
                                                local_3[_e832] = _e824.member.member[2];
                                                if _e833 {
                                                } else {
                                                    phi_3603_ = true;
                                                    break;
                                                }
                                                local_2[_e832] = _e824.member.member_1[0];
                                                if _e833 {
                                                } else {
                                                    phi_3603_ = true;
                                                    break;
                                                }
                                                local_1[_e832] = _e824.member.member_1[1];
                                                if _e833 {
                                                } else {
                                                    phi_3603_ = true;
                                                    break;
                                                }
                                                local[_e832] = _e824.member.member_1[2];
                                                if _e833 {
                                                } else {
                                                    phi_3603_ = true;
                                                    break;
                                                }
                                                local_8[_e832] = select(_e815, _e813, (_e813 > _e815));
                                                if _e822 {
                                                    phi_3136_ = _e732;
                                                } else {
                                                    phi_3136_ = _e737;
                                                }
                                                let _e850 = phi_3136_;
                                                phi_3137_ = _e850;
                                                phi_3138_ = (_e520 + 1u);
                                            } else {
                                                phi_3137_ = type_52();
                                                phi_3138_ = u32();
                                            }
                                            let _e852 = phi_3137_;
                                            let _e854 = phi_3138_;
                                            phi_3140_ = _e852;
                                            phi_3141_ = _e854;
                                            phi_3142_ = select(true, false, _e821);
                                        } else {
                                            phi_3140_ = type_52();
                                            phi_3141_ = u32();
                                            phi_3142_ = true;
                                        }
                                        let _e857 = phi_3140_;
                                        let _e859 = phi_3141_;
                                        let _e861 = phi_3142_;
                                        if _e861 {
                                            if _e820 {
                                                phi_3149_ = _e732;
                                            } else {
                                                phi_3149_ = _e737;
                                            }
                                            let _e863 = phi_3149_;
                                            phi_3154_ = _e863;
                                            phi_3155_ = select(_e821, true, _e820);
                                        } else {
                                            phi_3154_ = _e857;
                                            phi_3155_ = _e518;
                                        }
                                        let _e866 = phi_3154_;
                                        let _e868 = phi_3155_;
                                        phi_3677_ = _e478;
                                        phi_3607_ = _e476;
                                        phi_3157_ = _e866;
                                        phi_3158_ = _e868;
                                        phi_3159_ = select(_e859, _e520, _e861);
                                    }
                                    let _e1595 = phi_3677_;
                                    let _e1597 = phi_3607_;
                                    let _e1599 = phi_3157_;
                                    let _e1601 = phi_3158_;
                                    let _e1603 = phi_3159_;
                                    phi_3676_ = _e1595;
                                    phi_3606_ = _e1597;
                                    phi_3160_ = _e1599;
                                    phi_3161_ = (_e482 - 1u);
                                    phi_3162_ = _e1601;
                                    phi_3163_ = _e1603;
                                } else {
                                    phi_3676_ = _e478;
                                    phi_3606_ = _e476;
                                    phi_3160_ = _e516;
                                    phi_3161_ = _e482;
                                    phi_3162_ = _e518;
                                    phi_3163_ = _e520;
                                }
                                let _e1605 = phi_3676_;
                                let _e1607 = phi_3606_;
                                let _e1609 = phi_3160_;
                                let _e1611 = phi_3161_;
                                let _e1613 = phi_3162_;
                                let _e1615 = phi_3163_;
                                phi_3675_ = _e1605;
                                phi_3605_ = _e1607;
                                phi_3164_ = _e1609;
                                phi_3165_ = _e1611;
                                phi_3166_ = _e1613;
                                phi_3167_ = _e1615;
                            } else {
                                phi_3675_ = _e478;
                                phi_3605_ = _e476;
                                phi_3164_ = type_52();
                                phi_3165_ = u32();
                                phi_3166_ = bool();
                                phi_3167_ = u32();
                            }
                            let _e1617 = phi_3675_;
                            let _e1619 = phi_3605_;
                            let _e1621 = phi_3164_;
                            let _e1623 = phi_3165_;
                            let _e1625 = phi_3166_;
                            let _e1627 = phi_3167_;
                            phi_3674_ = _e1617;
                            phi_3604_ = _e1619;
                            phi_838_ = _e1621;
                            phi_841_ = _e1623;
                            phi_843_ = _e1625;
                            phi_845_ = _e1627;
                            phi_3168_ = _e490;
                        } else {
                            phi_3674_ = _e478;
                            phi_3604_ = _e476;
                            phi_838_ = type_52();
                            phi_841_ = u32();
                            phi_843_ = bool();
                            phi_845_ = u32();
                            phi_3168_ = false;
                        }
                        let _e1629 = phi_3674_;
                        let _e1631 = phi_3604_;
                        let _e1633 = phi_838_;
                        let _e1635 = phi_841_;
                        let _e1637 = phi_843_;
                        let _e1639 = phi_845_;
                        let _e1641 = phi_3168_;
                        continue;
                        continuing {
                            phi_3468_ = _e1631;
                            phi_3388_ = _e1629;
                            phi_837_ = _e1633;
                            phi_840_ = _e1635;
                            phi_842_ = _e1637;
                            phi_844_ = _e1639;
                            phi_3603_ = _e1631;
                            break if !(_e1641);
                        }
                    }
                    let _e1644 = phi_3603_;
                    if _e1644 {
                        break;
                    }
                    phi_3175_ = type_4(0u, 8u);
                    loop {
                        let _e1646 = phi_3175_;
                        if (_e1646.member < _e1646.member_1) {
                            phi_3176_ = type_4((_e1646.member + 1u), _e1646.member_1);
                            phi_3199_ = type_4(1u, _e1646.member);
                        } else {
                            phi_3176_ = _e1646;
                            phi_3199_ = type_4(0u, type_4().member_1);
                        }
                        let _e1659 = phi_3176_;
                        let _e1661 = phi_3199_;
                        let _e1665 = (bitcast<i32>(_e1661.member) != 0i);
                        if _e1665 {
                            let _e1666 = (_e1661.member_1 < 8u);
                            if _e1666 {
                            } else {
                                phi_3667_ = true;
                                break;
                            }
                            let _e1668 = local_7[_e1661.member_1];
                            if (_e1668.member_3 != 4294967295u) {
                                let _e1674 = -(_e412);
                                let _e1675 = (_e1674 / 3i);
                                let _e1682 = bitcast<f32>((bitcast<u32>((_e1675 + 127i)) << bitcast<u32>(23i)));
                                let _e1690 = (((_e1668.member * _e1682) * _e1682) * bitcast<f32>((bitcast<u32>(((_e1674 - (2i * _e1675)) + 127i)) << bitcast<u32>(23i))));
                                let _e1692 = select(340282350000000000000000000000000000000f, _e1690, (_e1690 < 340282350000000000000000000000000000000f));
                                phi_3265_ = type_18(select(-340282350000000000000000000000000000000f, _e1692, (_e1692 > -340282350000000000000000000000000000000f)), _e1668.member_1, _e1668.member_2, _e1668.member_3);
                            } else {
                                phi_3265_ = type_18(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                            }
                            let _e1697 = phi_3265_;
                            if _e1666 {
                            } else {
                                phi_3667_ = true;
                                break;
                            }
                            local_7[_e1661.member_1] = type_18(_e1697.member, _e1697.member_1, _e1697.member_2, _e1697.member_3);
                        }
                        continue;
                        continuing {
                            phi_3175_ = _e1659;
                            phi_3667_ = _e1644;
                            break if !(_e1665);
                        }
                    }
                    let _e1705 = phi_3667_;
                    if _e1705 {
                        break;
                    }
                    let _e1706 = local_7;
                    if _e133 {
                    } else {
                        break;
                    }
                    global_5.member[_e131] = array<type_18, 8>(type_18(_e1706[0].member, _e1706[0].member_1, _e1706[0].member_2, _e1706[0].member_3), type_18(_e1706[1].member, _e1706[1].member_1, _e1706[1].member_2, _e1706[1].member_3), type_18(_e1706[2].member, _e1706[2].member_1, _e1706[2].member_2, _e1706[2].member_3), type_18(_e1706[3].member, _e1706[3].member_1, _e1706[3].member_2, _e1706[3].member_3), type_18(_e1706[4].member, _e1706[4].member_1, _e1706[4].member_2, _e1706[4].member_3), type_18(_e1706[5].member, _e1706[5].member_1, _e1706[5].member_2, _e1706[5].member_3), type_18(_e1706[6].member, _e1706[6].member_1, _e1706[6].member_2, _e1706[6].member_3), type_18(_e1706[7].member, _e1706[7].member_1, _e1706[7].member_2, _e1706[7].member_3));
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn trace_nearest_printed_leaf10_(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
