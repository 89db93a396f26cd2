struct type_4 {
    member: u32,
    member_1: u32,
}

struct type_9 {
    member: array<array<u32, 4>>,
}

struct type_12 {
    member: vec4<u32>,
}

struct type_17 {
    member: array<f32, 9>,
    member_1: u32,
}

struct type_19 {
    member: array<type_17>,
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

struct type_29 {
    member: vec4<f32>,
    member_1: vec4<f32>,
}

struct type_36 {
    member: array<type_26>,
}

struct type_40 {
    member: array<array<type_25, 8>>,
}

struct type_46 {
    member: array<vec4<u32>, 2>,
}

struct type_51 {
    member: type_29,
    member_1: u32,
}

struct type_54 {
    member: array<vec4<f32>, 3>,
    member_1: type_51,
    member_2: type_51,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_1: type_12;
@group(0) @binding(3) 
var<storage> global_2: type_19;
@group(0) @binding(1) 
var<uniform> global_3: type_46;
@group(0) @binding(2) 
var<storage> global_4: type_9;
@group(0) @binding(4) 
var<storage> global_5: type_36;
@group(0) @binding(5) 
var<storage, read_write> global_6: type_40;

fn function_() {
    var local: array<i32, 3>;
    var local_1: array<i32, 3>;
    var local_2: array<type_25, 8>;
    var local_3: array<f32, 128>;
    var local_4: array<type_51, 128>;
    var phi_386_: i32;
    var phi_387_: i32;
    var phi_397_: bool;
    var phi_407_: u32;
    var phi_408_: u32;
    var phi_410_: bool;
    var phi_415_: u32;
    var phi_460_: f32;
    var phi_466_: f32;
    var phi_477_: f32;
    var phi_483_: f32;
    var phi_506_: f32;
    var phi_517_: f32;
    var phi_526_: f32;
    var phi_532_: f32;
    var phi_543_: f32;
    var phi_549_: f32;
    var phi_572_: f32;
    var phi_583_: f32;
    var phi_592_: f32;
    var phi_598_: f32;
    var phi_609_: f32;
    var phi_615_: f32;
    var phi_638_: f32;
    var phi_649_: f32;
    var phi_749_: f32;
    var phi_750_: f32;
    var phi_4573_: bool;
    var phi_4486_: f32;
    var phi_1923_: type_51;
    var phi_1926_: u32;
    var phi_1928_: bool;
    var phi_1930_: u32;
    var phi_1941_: bool;
    var phi_1979_: type_51;
    var phi_1980_: bool;
    var phi_1981_: u32;
    var phi_3677_: u32;
    var phi_3678_: u32;
    var phi_3688_: u32;
    var phi_3690_: u32;
    var phi_3691_: bool;
    var phi_3711_: u32;
    var phi_3712_: u32;
    var phi_3716_: type_54;
    var phi_4061_: type_51;
    var phi_4094_: type_51;
    var phi_4095_: type_51;
    var phi_4096_: u32;
    var phi_4098_: type_51;
    var phi_4099_: u32;
    var phi_4100_: bool;
    var phi_4109_: type_51;
    var phi_4114_: type_51;
    var phi_4115_: bool;
    var phi_4570_: bool;
    var phi_4560_: f32;
    var phi_1999_: type_4;
    var phi_2000_: type_4;
    var phi_2023_: type_4;
    var phi_2044_: u32;
    var phi_2133_: array<array<f32, 3>, 3>;
    var phi_2605_: vec3<f32>;
    var phi_2606_: vec3<f32>;
    var phi_2637_: bool;
    var phi_2646_: vec3<f32>;
    var phi_2686_: type_25;
    var phi_2688_: type_25;
    var phi_2689_: bool;
    var phi_2693_: type_25;
    var phi_2694_: type_25;
    var phi_2695_: type_25;
    var phi_2696_: bool;
    var phi_2700_: type_25;
    var phi_2701_: bool;
    var phi_2705_: type_25;
    var phi_2706_: bool;
    var phi_2710_: type_25;
    var phi_2722_: type_4;
    var phi_2725_: type_25;
    var phi_2723_: type_4;
    var phi_2748_: type_4;
    var phi_2780_: bool;
    var phi_2781_: bool;
    var phi_2802_: type_25;
    var phi_2726_: type_25;
    var phi_4561_: bool;
    var phi_4891_: f32;
    var phi_4890_: f32;
    var phi_4674_: bool;
    var phi_4889_: f32;
    var phi_4673_: bool;
    var phi_4888_: f32;
    var phi_4672_: bool;
    var phi_4828_: f32;
    var phi_4671_: bool;
    var phi_4793_: f32;
    var phi_4680_: bool;
    var phi_4117_: type_51;
    var phi_4118_: bool;
    var phi_4119_: u32;
    var phi_4792_: f32;
    var phi_4679_: bool;
    var phi_4120_: type_51;
    var phi_4121_: u32;
    var phi_4122_: bool;
    var phi_4123_: u32;
    var phi_4791_: f32;
    var phi_4678_: bool;
    var phi_4124_: type_51;
    var phi_4125_: u32;
    var phi_4126_: bool;
    var phi_4127_: u32;
    var phi_4790_: f32;
    var phi_4677_: bool;
    var phi_1924_: type_51;
    var phi_1927_: u32;
    var phi_1929_: bool;
    var phi_1931_: u32;
    var phi_4128_: bool;
    var phi_4676_: bool;
    var phi_4135_: type_4;
    var phi_4136_: type_4;
    var phi_4159_: type_4;
    var phi_4225_: type_25;
    var phi_4783_: bool;

    switch bitcast<i32>(0u) {
        default: {
            let _e81 = global;
            let _e83 = arrayLength((&global_4.member));
            let _e85 = arrayLength((&global_2.member));
            let _e93 = global_3.member[0u][0u];
            let _e97 = global_3.member[0u][1u];
            let _e101 = global_3.member[0u][2u];
            let _e105 = global_3.member[0u][3u];
            let _e109 = global_3.member[1u][0u];
            let _e113 = global_3.member[1u][1u];
            let _e117 = global_3.member[1u][2u];
            let _e120 = global_1.member[0u];
            let _e121 = bitcast<i32>(_e120);
            let _e133 = bitcast<f32>((bitcast<u32>((bitcast<i32>(_e105) + 127i)) << bitcast<u32>(23i)));
            local_1 = array<i32, 3>(bitcast<i32>(_e93), bitcast<i32>(_e97), bitcast<i32>(_e101));
            local = array<i32, 3>(bitcast<i32>(_e109), bitcast<i32>(_e113), bitcast<i32>(_e117));
            let _e139 = (_e81.x + (_e81.y * 2097152u));
            let _e140 = (_e139 < arrayLength((&global_5.member)));
            if _e140 {
                let _e141 = (_e139 < arrayLength((&global_6.member)));
                if _e141 {
                    if _e140 {
                    } else {
                        break;
                    }
                    let _e149 = global_5.member[_e139].member_2[0u];
                    let _e151 = (bitcast<u32>(_e149) & 2147483647u);
                    let _e156 = global_5.member[_e139].member_2[1u];
                    let _e158 = (bitcast<u32>(_e156) & 2147483647u);
                    let _e163 = global_5.member[_e139].member_2[2u];
                    let _e165 = (bitcast<u32>(_e163) & 2147483647u);
                    let _e170 = global_5.member[_e139].member[0u];
                    let _e172 = (bitcast<u32>(_e170) & 2147483647u);
                    let _e177 = global_5.member[_e139].member[1u];
                    let _e179 = (bitcast<u32>(_e177) & 2147483647u);
                    let _e184 = global_5.member[_e139].member[2u];
                    let _e186 = (bitcast<u32>(_e184) & 2147483647u);
                    let _e188 = select(_e158, _e151, (_e158 < _e151));
                    let _e190 = select(_e165, _e188, (_e165 < _e188));
                    let _e192 = select(_e172, _e190, (_e172 < _e190));
                    let _e194 = select(_e179, _e192, (_e179 < _e192));
                    let _e196 = select(_e186, _e194, (_e186 < _e194));
                    let _e200 = global_5.member[_e139].member_1;
                    let _e202 = (bitcast<u32>(_e200) & 2147483647u);
                    let _e209 = global_5.member[_e139].member_3;
                    let _e215 = (((select(_e202, _e196, (_e202 < _e196)) < 2139095040u) && ((bitcast<u32>(_e209) & 2147483647u) <= 2139095040u)) && (_e190 > 0u));
                    if _e215 {
                        let _e218 = (bitcast<u32>(bitcast<f32>(_e190)) & 2147483647u);
                        if (_e218 >= 8388608u) {
                            phi_386_ = (bitcast<i32>((_e218 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_386_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e218)), 32u, (_e218 == 0u))));
                        }
                        let _e232 = phi_386_;
                        phi_387_ = _e232;
                    } else {
                        phi_387_ = 0i;
                    }
                    let _e234 = phi_387_;
                    let _e235 = (_e151 == _e190);
                    if _e235 {
                        phi_397_ = true;
                    } else {
                        phi_397_ = (_e158 == _e190);
                    }
                    let _e238 = phi_397_;
                    let _e239 = select(1u, 0u, _e235);
                    if _e238 {
                        let _e240 = (_e239 + 1u);
                        phi_407_ = _e240;
                        phi_408_ = _e240;
                        phi_410_ = select(true, false, (_e240 == 2u));
                    } else {
                        phi_407_ = u32();
                        phi_408_ = 0u;
                        phi_410_ = true;
                    }
                    let _e244 = phi_407_;
                    let _e246 = phi_408_;
                    let _e248 = phi_410_;
                    if _e248 {
                        phi_415_ = (_e246 + 1u);
                    } else {
                        phi_415_ = 0u;
                    }
                    let _e252 = phi_415_;
                    let _e253 = select(_e244, _e246, _e248);
                    let _e254 = select(_e239, select(2u, _e239, _e238), _e248);
                    let _e255 = (_e121 / 2i);
                    let _e260 = bitcast<f32>((bitcast<u32>((_e255 + 127i)) << bitcast<u32>(23i)));
                    let _e266 = bitcast<f32>((bitcast<u32>(((_e121 - _e255) + 127i)) << bitcast<u32>(23i)));
                    let _e267 = -(_e234);
                    let _e268 = (_e267 / 2i);
                    let _e273 = bitcast<f32>((bitcast<u32>((_e268 + 127i)) << bitcast<u32>(23i)));
                    let _e279 = bitcast<f32>((bitcast<u32>(((_e267 - _e268) + 127i)) << bitcast<u32>(23i)));
                    let _e283 = global_5.member[_e139].member;
                    let _e284 = (_e253 == 0u);
                    if _e284 {
                        phi_460_ = _e283[0];
                    } else {
                        phi_460_ = _e283[1];
                    }
                    let _e288 = phi_460_;
                    let _e289 = (_e253 == 2u);
                    if _e289 {
                        phi_466_ = _e283[2];
                    } else {
                        phi_466_ = _e288;
                    }
                    let _e292 = phi_466_;
                    let _e294 = ((_e292 * _e260) * _e266);
                    let _e295 = global_5.member[_e139].member_2;
                    if _e284 {
                        phi_477_ = _e295[0];
                    } else {
                        phi_477_ = _e295[1];
                    }
                    let _e299 = phi_477_;
                    if _e289 {
                        phi_483_ = _e295[2];
                    } else {
                        phi_483_ = _e299;
                    }
                    let _e302 = phi_483_;
                    let _e304 = ((_e302 * _e273) * _e279);
                    let _e308 = (bitcast<f32>((bitcast<u32>(_e304) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e308 {
                        let _e312 = (bitcast<f32>((bitcast<u32>(_e294) & 2147483647u)) * 0.00000011920929f);
                        phi_506_ = select(0.00000000000011368684f, _e312, (_e312 > 0.00000000000011368684f));
                    } else {
                        phi_506_ = 0f;
                    }
                    let _e316 = phi_506_;
                    let _e317 = (_e294 + _e316);
                    let _e318 = (_e294 - _e316);
                    let _e319 = select(_e304, 0f, _e308);
                    if _e308 {
                        phi_517_ = 38685626000000000000000000f;
                    } else {
                        phi_517_ = (1f / _e304);
                    }
                    let _e322 = phi_517_;
                    let _e323 = (_e252 == 0u);
                    if _e323 {
                        phi_526_ = _e283[0];
                    } else {
                        phi_526_ = _e283[1];
                    }
                    let _e327 = phi_526_;
                    let _e328 = (_e252 == 2u);
                    if _e328 {
                        phi_532_ = _e283[2];
                    } else {
                        phi_532_ = _e327;
                    }
                    let _e331 = phi_532_;
                    let _e333 = ((_e331 * _e260) * _e266);
                    if _e323 {
                        phi_543_ = _e295[0];
                    } else {
                        phi_543_ = _e295[1];
                    }
                    let _e337 = phi_543_;
                    if _e328 {
                        phi_549_ = _e295[2];
                    } else {
                        phi_549_ = _e337;
                    }
                    let _e340 = phi_549_;
                    let _e342 = ((_e340 * _e273) * _e279);
                    let _e346 = (bitcast<f32>((bitcast<u32>(_e342) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e346 {
                        let _e350 = (bitcast<f32>((bitcast<u32>(_e333) & 2147483647u)) * 0.00000011920929f);
                        phi_572_ = select(0.00000000000011368684f, _e350, (_e350 > 0.00000000000011368684f));
                    } else {
                        phi_572_ = 0f;
                    }
                    let _e354 = phi_572_;
                    let _e355 = (_e333 + _e354);
                    let _e356 = (_e333 - _e354);
                    let _e357 = select(_e342, 0f, _e346);
                    if _e346 {
                        phi_583_ = 38685626000000000000000000f;
                    } else {
                        phi_583_ = (1f / _e342);
                    }
                    let _e360 = phi_583_;
                    let _e361 = (_e254 == 0u);
                    if _e361 {
                        phi_592_ = _e283[0];
                    } else {
                        phi_592_ = _e283[1];
                    }
                    let _e365 = phi_592_;
                    let _e366 = (_e254 == 2u);
                    if _e366 {
                        phi_598_ = _e283[2];
                    } else {
                        phi_598_ = _e365;
                    }
                    let _e369 = phi_598_;
                    let _e371 = ((_e369 * _e260) * _e266);
                    if _e361 {
                        phi_609_ = _e295[0];
                    } else {
                        phi_609_ = _e295[1];
                    }
                    let _e375 = phi_609_;
                    if _e366 {
                        phi_615_ = _e295[2];
                    } else {
                        phi_615_ = _e375;
                    }
                    let _e378 = phi_615_;
                    let _e380 = ((_e378 * _e273) * _e279);
                    let _e384 = (bitcast<f32>((bitcast<u32>(_e380) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e384 {
                        let _e388 = (bitcast<f32>((bitcast<u32>(_e371) & 2147483647u)) * 0.00000011920929f);
                        phi_638_ = select(0.00000000000011368684f, _e388, (_e388 > 0.00000000000011368684f));
                    } else {
                        phi_638_ = 0f;
                    }
                    let _e392 = phi_638_;
                    let _e393 = (_e371 + _e392);
                    let _e394 = (_e371 - _e392);
                    let _e395 = select(_e380, 0f, _e384);
                    if _e384 {
                        phi_649_ = 38685626000000000000000000f;
                    } else {
                        phi_649_ = (1f / _e380);
                    }
                    let _e398 = phi_649_;
                    let _e401 = bitcast<f32>((bitcast<u32>(_e294) & 2147483647u));
                    let _e404 = bitcast<f32>((bitcast<u32>(_e333) & 2147483647u));
                    let _e406 = select(_e404, _e401, (_e401 > _e404));
                    let _e409 = bitcast<f32>((bitcast<u32>(_e371) & 2147483647u));
                    let _e412 = (_e121 + _e234);
                    if (_e215 && (select(_e409, _e406, (_e406 > _e409)) <= 1099511600000f)) {
                        let _e415 = (_e412 / 3i);
                        let _e422 = bitcast<f32>((bitcast<u32>((_e415 + 127i)) << bitcast<u32>(23i)));
                        let _e429 = bitcast<f32>((bitcast<u32>(((_e412 - (2i * _e415)) + 127i)) << bitcast<u32>(23i)));
                        let _e430 = (((_e200 * _e422) * _e422) * _e429);
                        let _e432 = select(340282350000000000000000000000000000000f, _e430, (_e430 < 340282350000000000000000000000000000000f));
                        let _e437 = (((_e209 * _e422) * _e422) * _e429);
                        let _e439 = select(340282350000000000000000000000000000000f, _e437, (_e437 < 340282350000000000000000000000000000000f));
                        phi_749_ = select(-340282350000000000000000000000000000000f, _e439, (_e439 > -340282350000000000000000000000000000000f));
                        phi_750_ = select(-340282350000000000000000000000000000000f, _e432, (_e432 > -340282350000000000000000000000000000000f));
                    } else {
                        phi_749_ = 0f;
                        phi_750_ = 1f;
                    }
                    let _e443 = phi_749_;
                    let _e445 = phi_750_;
                    local_2 = array<type_25, 8>(type_25(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_25(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_25(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_25(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_25(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_25(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_25(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_25(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u));
                    local_4 = array<type_51, 128>(type_51(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u));
                    local_3 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    let _e448 = (_e253 % 3u);
                    let _e449 = (_e448 < 3u);
                    if _e449 {
                    } else {
                        break;
                    }
                    let _e451 = local_1[_e448];
                    let _e454 = (_e252 % 3u);
                    let _e455 = (_e454 < 3u);
                    if _e455 {
                    } else {
                        break;
                    }
                    let _e457 = local_1[_e454];
                    let _e460 = (_e254 % 3u);
                    let _e461 = (_e460 < 3u);
                    if _e461 {
                    } else {
                        break;
                    }
                    let _e463 = local_1[_e460];
                    if _e449 {
                    } else {
                        break;
                    }
                    let _e468 = local[_e448];
                    if _e455 {
                    } else {
                        break;
                    }
                    let _e472 = local[_e454];
                    if _e461 {
                    } else {
                        break;
                    }
                    let _e476 = local[_e460];
                    phi_4573_ = false;
                    phi_4486_ = _e443;
                    phi_1923_ = type_51(type_29(vec4<f32>((f32(_e451) * _e133), (f32(_e457) * _e133), (f32(_e463) * _e133), 0f), vec4<f32>((f32(_e468) * _e133), (f32(_e472) * _e133), (f32(_e476) * _e133), 0f)), select(0u, 2147483648u, (_e83 == 0u)));
                    phi_1926_ = ((3u * _e83) + 1u);
                    phi_1928_ = (_e445 <= _e443);
                    phi_1930_ = 0u;
                    loop {
                        let _e486 = phi_4573_;
                        let _e488 = phi_4486_;
                        let _e490 = phi_1923_;
                        let _e492 = phi_1926_;
                        let _e494 = phi_1928_;
                        let _e496 = phi_1930_;
                        if _e494 {
                            phi_1941_ = true;
                        } else {
                            phi_1941_ = (_e496 > 0u);
                        }
                        let _e499 = phi_1941_;
                        if _e499 {
                            let _e500 = (_e492 > 0u);
                            if _e500 {
                                if _e494 {
                                    phi_1979_ = _e490;
                                    phi_1980_ = _e494;
                                    phi_1981_ = _e496;
                                } else {
                                    let _e501 = (_e496 - 1u);
                                    let _e502 = (_e501 % 128u);
                                    let _e503 = (_e502 < 128u);
                                    if _e503 {
                                    } else {
                                        phi_4676_ = true;
                                        break;
                                    }
                                    let _e505 = local_4[_e502];
                                    if _e503 {
                                    } else {
                                        phi_4676_ = true;
                                        break;
                                    }
                                    let _e513 = local_3[_e502];
                                    phi_1979_ = type_51(type_29(_e505.member.member, _e505.member.member_1), _e505.member_1);
                                    phi_1980_ = (_e513 <= _e488);
                                    phi_1981_ = _e501;
                                }
                                let _e516 = phi_1979_;
                                let _e518 = phi_1980_;
                                let _e520 = phi_1981_;
                                if _e518 {
                                    if ((_e516.member_1 & 2147483648u) != 0u) {
                                        phi_4570_ = _e486;
                                        phi_4560_ = _e488;
                                        phi_1999_ = type_4(0u, ((_e516.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e965 = phi_4570_;
                                            let _e967 = phi_4560_;
                                            let _e969 = phi_1999_;
                                            if (_e969.member < _e969.member_1) {
                                                phi_2000_ = type_4((_e969.member + 1u), _e969.member_1);
                                                phi_2023_ = type_4(1u, _e969.member);
                                            } else {
                                                phi_2000_ = _e969;
                                                phi_2023_ = type_4(0u, type_4().member_1);
                                            }
                                            let _e982 = phi_2000_;
                                            let _e984 = phi_2023_;
                                            let _e988 = (bitcast<i32>(_e984.member) != 0i);
                                            if _e988 {
                                                let _e989 = ((_e516.member_1 & 268435455u) + _e984.member_1);
                                                let _e990 = (_e989 < _e85);
                                                if _e990 {
                                                    if _e990 {
                                                    } else {
                                                        phi_4828_ = _e967;
                                                        phi_4671_ = true;
                                                        break;
                                                    }
                                                    let _e994 = global_2.member[_e989].member_1;
                                                    phi_2044_ = _e994;
                                                } else {
                                                    phi_2044_ = 4294967295u;
                                                }
                                                let _e996 = phi_2044_;
                                                if (_e989 >= _e85) {
                                                    phi_2133_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                } else {
                                                    if _e990 {
                                                    } else {
                                                        phi_4828_ = _e967;
                                                        phi_4671_ = true;
                                                        break;
                                                    }
                                                    if (_e448 < 9u) {
                                                    } else {
                                                        phi_4828_ = _e967;
                                                        phi_4671_ = true;
                                                        break;
                                                    }
                                                    let _e1003 = global_2.member[_e989].member[_e448];
                                                    if (_e454 < 9u) {
                                                    } else {
                                                        phi_4828_ = _e967;
                                                        phi_4671_ = true;
                                                        break;
                                                    }
                                                    let _e1009 = global_2.member[_e989].member[_e454];
                                                    if (_e460 < 9u) {
                                                    } else {
                                                        phi_4828_ = _e967;
                                                        phi_4671_ = true;
                                                        break;
                                                    }
                                                    let _e1015 = global_2.member[_e989].member[_e460];
                                                    let _e1017 = (3u + _e448);
                                                    if (_e1017 < 9u) {
                                                    } else {
                                                        phi_4828_ = _e967;
                                                        phi_4671_ = true;
                                                        break;
                                                    }
                                                    let _e1023 = global_2.member[_e989].member[_e1017];
                                                    let _e1024 = (3u + _e454);
                                                    if (_e1024 < 9u) {
                                                    } else {
                                                        phi_4828_ = _e967;
                                                        phi_4671_ = true;
                                                        break;
                                                    }
                                                    let _e1030 = global_2.member[_e989].member[_e1024];
                                                    let _e1031 = (3u + _e460);
                                                    if (_e1031 < 9u) {
                                                    } else {
                                                        phi_4828_ = _e967;
                                                        phi_4671_ = true;
                                                        break;
                                                    }
                                                    let _e1037 = global_2.member[_e989].member[_e1031];
                                                    let _e1039 = (6u + _e448);
                                                    if (_e1039 < 9u) {
                                                    } else {
                                                        phi_4828_ = _e967;
                                                        phi_4671_ = true;
                                                        break;
                                                    }
                                                    let _e1045 = global_2.member[_e989].member[_e1039];
                                                    let _e1046 = (6u + _e454);
                                                    if (_e1046 < 9u) {
                                                    } else {
                                                        phi_4828_ = _e967;
                                                        phi_4671_ = true;
                                                        break;
                                                    }
                                                    let _e1052 = global_2.member[_e989].member[_e1046];
                                                    let _e1053 = (6u + _e460);
                                                    if (_e1053 < 9u) {
                                                    } else {
                                                        phi_4828_ = _e967;
                                                        phi_4671_ = true;
                                                        break;
                                                    }
                                                    let _e1059 = global_2.member[_e989].member[_e1053];
                                                    phi_2133_ = array<array<f32, 3>, 3>(array<f32, 3>(_e1003, _e1009, _e1015), array<f32, 3>(_e1023, _e1030, _e1037), array<f32, 3>(_e1045, _e1052, _e1059));
                                                }
                                                let _e1063 = phi_2133_;
                                                let _e1070 = (_e1063[0][2] - _e371);
                                                let _e1073 = (((_e1063[0][0] - _e294) * _e395) - (_e1070 * _e319));
                                                let _e1076 = (((_e1063[0][1] - _e333) * _e395) - (_e1070 * _e357));
                                                let _e1083 = (_e1063[1][2] - _e371);
                                                let _e1086 = (((_e1063[1][0] - _e294) * _e395) - (_e1083 * _e319));
                                                let _e1089 = (((_e1063[1][1] - _e333) * _e395) - (_e1083 * _e357));
                                                let _e1096 = (_e1063[2][2] - _e371);
                                                let _e1099 = (((_e1063[2][0] - _e294) * _e395) - (_e1096 * _e319));
                                                let _e1102 = (((_e1063[2][1] - _e333) * _e395) - (_e1096 * _e357));
                                                let _e1103 = (_e1099 * _e1089);
                                                let _e1104 = (_e1102 * _e1086);
                                                let _e1105 = (_e1073 * _e1102);
                                                let _e1106 = (_e1076 * _e1099);
                                                let _e1107 = (_e1086 * _e1076);
                                                let _e1108 = (_e1089 * _e1073);
                                                let _e1113 = (((_e1103 >= _e1104) && (_e1105 >= _e1106)) && (_e1107 >= _e1108));
                                                if (_e1113 || (((_e1103 <= _e1104) && (_e1105 <= _e1106)) && (_e1107 <= _e1108))) {
                                                    let _e1120 = select(-1f, 1f, _e1113);
                                                    let _e1122 = ((_e1103 - _e1104) * _e1120);
                                                    let _e1124 = select(0f, _e1122, (_e1122 > 0f));
                                                    let _e1126 = ((_e1105 - _e1106) * _e1120);
                                                    let _e1128 = select(0f, _e1126, (_e1126 > 0f));
                                                    let _e1130 = ((_e1107 - _e1108) * _e1120);
                                                    let _e1132 = select(0f, _e1130, (_e1130 > 0f));
                                                    let _e1134 = ((_e1124 + _e1128) + _e1132);
                                                    if (_e1134 < 0.000000000000000000000000000000000000011754944f) {
                                                        phi_2700_ = type_25();
                                                        phi_2701_ = true;
                                                    } else {
                                                        let _e1137 = select(_e1063[1][0], _e1063[0][0], (_e1063[0][0] < _e1063[1][0]));
                                                        let _e1141 = select(_e1063[1][0], _e1063[0][0], (_e1063[0][0] > _e1063[1][0]));
                                                        let _e1145 = select(_e1063[1][1], _e1063[0][1], (_e1063[0][1] < _e1063[1][1]));
                                                        let _e1149 = select(_e1063[1][1], _e1063[0][1], (_e1063[0][1] > _e1063[1][1]));
                                                        let _e1153 = select(_e1063[1][2], _e1063[0][2], (_e1063[0][2] < _e1063[1][2]));
                                                        let _e1157 = select(_e1063[1][2], _e1063[0][2], (_e1063[0][2] > _e1063[1][2]));
                                                        let _e1162 = ((select(_e1063[2][0], _e1137, (_e1137 < _e1063[2][0])) - _e317) * _e322);
                                                        let _e1163 = ((select(_e1063[2][0], _e1141, (_e1141 > _e1063[2][0])) - _e318) * _e322);
                                                        let _e1166 = ((select(_e1063[2][1], _e1145, (_e1145 < _e1063[2][1])) - _e355) * _e360);
                                                        let _e1167 = ((select(_e1063[2][1], _e1149, (_e1149 > _e1063[2][1])) - _e356) * _e360);
                                                        let _e1170 = ((select(_e1063[2][2], _e1153, (_e1153 < _e1063[2][2])) - _e393) * _e398);
                                                        let _e1171 = ((select(_e1063[2][2], _e1157, (_e1157 > _e1063[2][2])) - _e394) * _e398);
                                                        let _e1173 = select(_e1171, _e1170, (_e1170 < _e1171));
                                                        let _e1175 = select(_e1171, _e1170, (_e1170 > _e1171));
                                                        let _e1177 = select(_e1163, _e1162, (_e1162 < _e1163));
                                                        let _e1179 = select(_e1167, _e1166, (_e1166 < _e1167));
                                                        let _e1181 = select(_e1179, _e1177, (_e1177 > _e1179));
                                                        let _e1183 = select(_e1173, _e1181, (_e1181 > _e1173));
                                                        let _e1185 = select(_e1163, _e1162, (_e1162 > _e1163));
                                                        let _e1187 = select(_e1167, _e1166, (_e1166 > _e1167));
                                                        let _e1189 = select(_e1187, _e1185, (_e1185 < _e1187));
                                                        let _e1191 = select(_e1175, _e1189, (_e1189 < _e1175));
                                                        let _e1192 = -(_e1173);
                                                        let _e1198 = select(_e445, _e1183, (_e1183 > _e445));
                                                        if (_e1198 > (_e1191 + (select(_e1192, _e1175, (_e1175 > _e1192)) * 0.0000019073523f))) {
                                                            phi_2695_ = type_25();
                                                            phi_2696_ = true;
                                                        } else {
                                                            let _e1200 = (_e1198 > _e967);
                                                            if _e1200 {
                                                                phi_2694_ = type_25();
                                                            } else {
                                                                let _e1204 = (_e1063[1][0] - _e1063[0][0]);
                                                                let _e1205 = (_e1063[1][1] - _e1063[0][1]);
                                                                let _e1206 = (_e1063[1][2] - _e1063[0][2]);
                                                                let _e1207 = vec3<f32>(_e1204, _e1205, _e1206);
                                                                let _e1208 = (_e1063[2][0] - _e1063[1][0]);
                                                                let _e1209 = (_e1063[2][1] - _e1063[1][1]);
                                                                let _e1210 = (_e1063[2][2] - _e1063[1][2]);
                                                                let _e1211 = vec3<f32>(_e1208, _e1209, _e1210);
                                                                let _e1212 = (_e1063[0][0] - _e1063[2][0]);
                                                                let _e1213 = (_e1063[0][1] - _e1063[2][1]);
                                                                let _e1214 = (_e1063[0][2] - _e1063[2][2]);
                                                                let _e1215 = vec3<f32>(_e1212, _e1213, _e1214);
                                                                let _e1218 = bitcast<f32>((bitcast<u32>(_e1204) & 2147483647u));
                                                                let _e1221 = bitcast<f32>((bitcast<u32>(_e1205) & 2147483647u));
                                                                let _e1223 = select(_e1221, _e1218, (_e1218 > _e1221));
                                                                let _e1226 = bitcast<f32>((bitcast<u32>(_e1206) & 2147483647u));
                                                                let _e1228 = select(_e1226, _e1223, (_e1223 > _e1226));
                                                                let _e1231 = bitcast<f32>((bitcast<u32>(_e1208) & 2147483647u));
                                                                let _e1234 = bitcast<f32>((bitcast<u32>(_e1209) & 2147483647u));
                                                                let _e1236 = select(_e1234, _e1231, (_e1231 > _e1234));
                                                                let _e1239 = bitcast<f32>((bitcast<u32>(_e1210) & 2147483647u));
                                                                let _e1241 = select(_e1239, _e1236, (_e1236 > _e1239));
                                                                let _e1244 = bitcast<f32>((bitcast<u32>(_e1212) & 2147483647u));
                                                                let _e1247 = bitcast<f32>((bitcast<u32>(_e1213) & 2147483647u));
                                                                let _e1249 = select(_e1247, _e1244, (_e1244 > _e1247));
                                                                let _e1252 = bitcast<f32>((bitcast<u32>(_e1214) & 2147483647u));
                                                                let _e1254 = select(_e1252, _e1249, (_e1249 > _e1252));
                                                                let _e1256 = select(_e1241, _e1228, (_e1228 > _e1241));
                                                                let _e1258 = select(_e1254, _e1256, (_e1256 > _e1254));
                                                                if (_e1228 == _e1258) {
                                                                    phi_2605_ = _e1211;
                                                                    phi_2606_ = _e1215;
                                                                } else {
                                                                    let _e1261 = vec3((_e1241 == _e1258));
                                                                    phi_2605_ = select(_e1207, _e1215, _e1261);
                                                                    phi_2606_ = select(_e1211, _e1207, _e1261);
                                                                }
                                                                let _e1265 = phi_2605_;
                                                                let _e1267 = phi_2606_;
                                                                let _e1274 = ((_e1265.y * _e1267.z) - (_e1267.y * _e1265.z));
                                                                let _e1279 = ((_e1265.z * _e1267.x) - (_e1267.z * _e1265.x));
                                                                let _e1282 = ((_e1265.x * _e1267.y) - (_e1267.x * _e1265.y));
                                                                if (_e1124 >= _e1128) {
                                                                    phi_2637_ = select(true, false, (_e1124 >= _e1132));
                                                                } else {
                                                                    phi_2637_ = true;
                                                                }
                                                                let _e1287 = phi_2637_;
                                                                if _e1287 {
                                                                    phi_2646_ = select(vec3<f32>(_e1063[2][0], _e1063[2][1], _e1063[2][2]), vec3<f32>(_e1063[1][0], _e1063[1][1], _e1063[1][2]), vec3((_e1128 >= _e1132)));
                                                                } else {
                                                                    phi_2646_ = vec3<f32>(_e1063[0][0], _e1063[0][1], _e1063[0][2]);
                                                                }
                                                                let _e1292 = phi_2646_;
                                                                let _e1309 = ((((_e1274 * (_e1292.x - _e294)) + (_e1279 * (_e1292.y - _e333))) + (_e1282 * (_e1292.z - _e371))) / (((_e1274 * _e319) + (_e1279 * _e357)) + (_e1282 * _e395)));
                                                                let _e1311 = select(_e1191, _e1309, (_e1309 < _e1191));
                                                                let _e1313 = select(_e1183, _e1311, (_e1311 > _e1183));
                                                                if (_e1313 >= _e445) {
                                                                    let _e1315 = (_e1313 <= _e967);
                                                                    if _e1315 {
                                                                        let _e1316 = (1f / _e1134);
                                                                        phi_2686_ = type_25(_e1313, (_e1128 * _e1316), (_e1132 * _e1316), _e996);
                                                                    } else {
                                                                        phi_2686_ = type_25();
                                                                    }
                                                                    let _e1321 = phi_2686_;
                                                                    phi_2688_ = _e1321;
                                                                    phi_2689_ = select(true, false, _e1315);
                                                                } else {
                                                                    phi_2688_ = type_25();
                                                                    phi_2689_ = true;
                                                                }
                                                                let _e1324 = phi_2688_;
                                                                let _e1326 = phi_2689_;
                                                                if _e1326 {
                                                                    phi_2693_ = type_25(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                } else {
                                                                    phi_2693_ = _e1324;
                                                                }
                                                                let _e1328 = phi_2693_;
                                                                phi_2694_ = _e1328;
                                                            }
                                                            let _e1330 = phi_2694_;
                                                            phi_2695_ = _e1330;
                                                            phi_2696_ = _e1200;
                                                        }
                                                        let _e1332 = phi_2695_;
                                                        let _e1334 = phi_2696_;
                                                        phi_2700_ = _e1332;
                                                        phi_2701_ = _e1334;
                                                    }
                                                    let _e1336 = phi_2700_;
                                                    let _e1338 = phi_2701_;
                                                    phi_2705_ = _e1336;
                                                    phi_2706_ = _e1338;
                                                } else {
                                                    phi_2705_ = type_25();
                                                    phi_2706_ = true;
                                                }
                                                let _e1340 = phi_2705_;
                                                let _e1342 = phi_2706_;
                                                if _e1342 {
                                                    phi_2710_ = type_25(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                } else {
                                                    phi_2710_ = _e1340;
                                                }
                                                let _e1344 = phi_2710_;
                                                if (_e1344.member_3 != 4294967295u) {
                                                    if (_e996 != 4294967295u) {
                                                        phi_2722_ = type_4(0u, 8u);
                                                        phi_2725_ = _e1344;
                                                        loop {
                                                            let _e1349 = phi_2722_;
                                                            let _e1351 = phi_2725_;
                                                            if (_e1349.member < _e1349.member_1) {
                                                                phi_2723_ = type_4((_e1349.member + 1u), _e1349.member_1);
                                                                phi_2748_ = type_4(1u, _e1349.member);
                                                            } else {
                                                                phi_2723_ = _e1349;
                                                                phi_2748_ = type_4(0u, type_4().member_1);
                                                            }
                                                            let _e1364 = phi_2723_;
                                                            let _e1366 = phi_2748_;
                                                            let _e1370 = (bitcast<i32>(_e1366.member) != 0i);
                                                            if _e1370 {
                                                                let _e1371 = (_e1366.member_1 < 8u);
                                                                if _e1371 {
                                                                } else {
                                                                    phi_4561_ = true;
                                                                    break;
                                                                }
                                                                let _e1376 = local_2[_e1366.member_1].member;
                                                                if (_e1351.member < _e1376) {
                                                                    phi_2781_ = true;
                                                                } else {
                                                                    let _e1378 = local_2[_e1366.member_1].member;
                                                                    if (_e1351.member == _e1378) {
                                                                        let _e1383 = local_2[_e1366.member_1].member_3;
                                                                        phi_2780_ = (_e1351.member_3 < _e1383);
                                                                    } else {
                                                                        phi_2780_ = false;
                                                                    }
                                                                    let _e1386 = phi_2780_;
                                                                    phi_2781_ = _e1386;
                                                                }
                                                                let _e1388 = phi_2781_;
                                                                if _e1388 {
                                                                    if _e1371 {
                                                                    } else {
                                                                        phi_4561_ = true;
                                                                        break;
                                                                    }
                                                                    let _e1389 = local_2[_e1366.member_1];
                                                                    local_2[_e1366.member_1] = type_25(_e1351.member, _e1351.member_1, _e1351.member_2, _e1351.member_3);
                                                                    phi_2802_ = type_25(_e1389.member, _e1389.member_1, _e1389.member_2, _e1389.member_3);
                                                                } else {
                                                                    phi_2802_ = _e1351;
                                                                }
                                                                let _e1400 = phi_2802_;
                                                                phi_2726_ = _e1400;
                                                            } else {
                                                                phi_2726_ = type_25();
                                                            }
                                                            let _e1402 = phi_2726_;
                                                            continue;
                                                            continuing {
                                                                phi_2722_ = _e1364;
                                                                phi_2725_ = _e1402;
                                                                phi_4561_ = _e965;
                                                                break if !(_e1370);
                                                            }
                                                        }
                                                        let _e1405 = phi_4561_;
                                                        phi_4828_ = _e967;
                                                        phi_4671_ = _e1405;
                                                        if _e1405 {
                                                            break;
                                                        }
                                                        let _e1408 = local_2[7u].member_3;
                                                        if (_e1408 != 4294967295u) {
                                                            let _e1412 = local_2[7u].member;
                                                            phi_4891_ = _e1412;
                                                        } else {
                                                            phi_4891_ = _e967;
                                                        }
                                                        let _e1414 = phi_4891_;
                                                        phi_4890_ = _e1414;
                                                        phi_4674_ = _e1405;
                                                    } else {
                                                        phi_4890_ = _e967;
                                                        phi_4674_ = _e965;
                                                    }
                                                    let _e1416 = phi_4890_;
                                                    let _e1418 = phi_4674_;
                                                    phi_4889_ = _e1416;
                                                    phi_4673_ = _e1418;
                                                } else {
                                                    phi_4889_ = _e967;
                                                    phi_4673_ = _e965;
                                                }
                                                let _e1420 = phi_4889_;
                                                let _e1422 = phi_4673_;
                                                phi_4888_ = _e1420;
                                                phi_4672_ = _e1422;
                                            } else {
                                                phi_4888_ = _e967;
                                                phi_4672_ = _e965;
                                            }
                                            let _e1424 = phi_4888_;
                                            let _e1426 = phi_4672_;
                                            continue;
                                            continuing {
                                                phi_4570_ = _e1426;
                                                phi_4560_ = _e1424;
                                                phi_1999_ = _e982;
                                                phi_4828_ = _e1424;
                                                phi_4671_ = _e1426;
                                                break if !(_e988);
                                            }
                                        }
                                        let _e1429 = phi_4828_;
                                        let _e1431 = phi_4671_;
                                        phi_4676_ = _e1431;
                                        if _e1431 {
                                            break;
                                        }
                                        phi_4793_ = _e1429;
                                        phi_4680_ = _e1431;
                                        phi_4117_ = _e516;
                                        phi_4118_ = false;
                                        phi_4119_ = _e520;
                                    } else {
                                        if (_e516.member_1 >= _e83) {
                                            phi_3716_ = type_54(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), type_51(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u), type_51(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u));
                                        } else {
                                            if (_e516.member_1 < _e83) {
                                            } else {
                                                phi_4676_ = true;
                                                break;
                                            }
                                            let _e532 = ((1u + _e253) % 4u);
                                            if (_e532 < 4u) {
                                            } else {
                                                phi_4676_ = true;
                                                break;
                                            }
                                            let _e537 = global_4.member[_e516.member_1][_e532];
                                            let _e539 = ((1u + _e252) % 4u);
                                            if (_e539 < 4u) {
                                            } else {
                                                phi_4676_ = true;
                                                break;
                                            }
                                            let _e544 = global_4.member[_e516.member_1][_e539];
                                            let _e546 = ((1u + _e254) % 4u);
                                            if (_e546 < 4u) {
                                            } else {
                                                phi_4676_ = true;
                                                break;
                                            }
                                            let _e551 = global_4.member[_e516.member_1][_e546];
                                            let _e553 = ((_e253 + 1u) % 4u);
                                            if (_e553 < 4u) {
                                            } else {
                                                phi_4676_ = true;
                                                break;
                                            }
                                            let _e558 = global_4.member[_e516.member_1][_e553];
                                            let _e560 = (_e558 >> bitcast<u32>(11u));
                                            let _e562 = ((_e252 + 1u) % 4u);
                                            if (_e562 < 4u) {
                                            } else {
                                                phi_4676_ = true;
                                                break;
                                            }
                                            let _e567 = global_4.member[_e516.member_1][_e562];
                                            let _e569 = (_e567 >> bitcast<u32>(11u));
                                            let _e571 = ((_e254 + 1u) % 4u);
                                            if (_e571 < 4u) {
                                            } else {
                                                phi_4676_ = true;
                                                break;
                                            }
                                            let _e576 = global_4.member[_e516.member_1][_e571];
                                            let _e578 = (_e576 >> bitcast<u32>(11u));
                                            let _e601 = (bitcast<f32>((bitcast<u32>((_e516.member.member_1.x - _e516.member.member.x)) & 2139095040u)) * 0.001953125f);
                                            let _e602 = (bitcast<f32>((bitcast<u32>((_e516.member.member_1.y - _e516.member.member.y)) & 2139095040u)) * 0.001953125f);
                                            let _e603 = (bitcast<f32>((bitcast<u32>((_e516.member.member_1.z - _e516.member.member.z)) & 2139095040u)) * 0.001953125f);
                                            let _e605 = select(_e133, _e601, (_e601 > _e133));
                                            let _e607 = select(_e133, _e602, (_e602 > _e133));
                                            let _e609 = select(_e133, _e603, (_e603 > _e133));
                                            let _e634 = bitcast<u32>((f32(bitcast<i32>((_e537 & 1023u))) * _e605));
                                            let _e639 = (bitcast<i32>((_e537 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e642 = bitcast<f32>((_e634 & bitcast<u32>(_e639)));
                                            let _e643 = bitcast<u32>((f32(bitcast<i32>((_e544 & 1023u))) * _e607));
                                            let _e648 = (bitcast<i32>((_e544 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e651 = bitcast<f32>((_e643 & bitcast<u32>(_e648)));
                                            let _e652 = bitcast<u32>((f32(bitcast<i32>((_e551 & 1023u))) * _e609));
                                            let _e657 = (bitcast<i32>((_e551 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e660 = bitcast<f32>((_e652 & bitcast<u32>(_e657)));
                                            let _e664 = bitcast<f32>((_e634 & bitcast<u32>(~(_e639))));
                                            let _e668 = bitcast<f32>((_e643 & bitcast<u32>(~(_e648))));
                                            let _e672 = bitcast<f32>((_e652 & bitcast<u32>(~(_e657))));
                                            let _e673 = bitcast<u32>((f32(bitcast<i32>((_e560 & 1023u))) * _e605));
                                            let _e678 = (bitcast<i32>((_e560 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e681 = bitcast<f32>((_e673 & bitcast<u32>(_e678)));
                                            let _e682 = bitcast<u32>((f32(bitcast<i32>((_e569 & 1023u))) * _e607));
                                            let _e687 = (bitcast<i32>((_e569 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e690 = bitcast<f32>((_e682 & bitcast<u32>(_e687)));
                                            let _e691 = bitcast<u32>((f32(bitcast<i32>((_e578 & 1023u))) * _e609));
                                            let _e696 = (bitcast<i32>((_e578 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e699 = bitcast<f32>((_e691 & bitcast<u32>(_e696)));
                                            let _e703 = bitcast<f32>((_e673 & bitcast<u32>(~(_e678))));
                                            let _e707 = bitcast<f32>((_e682 & bitcast<u32>(~(_e687))));
                                            let _e711 = bitcast<f32>((_e691 & bitcast<u32>(~(_e696))));
                                            let _e741 = global_4.member[_e516.member_1][0u];
                                            let _e745 = global_4.member[_e516.member_1][1u];
                                            let _e749 = global_4.member[_e516.member_1][2u];
                                            let _e753 = global_4.member[_e516.member_1][3u];
                                            let _e765 = (((_e745 >> bitcast<u32>(22i)) | ((_e749 >> bitcast<u32>(22i)) << bitcast<u32>(10i))) | ((_e753 >> bitcast<u32>(22i)) << bitcast<u32>(20i)));
                                            let _e766 = (_e741 & 268435455u);
                                            let _e767 = (_e765 & 268435455u);
                                            let _e770 = ((_e741 >> bitcast<u32>(28u)) & 7u);
                                            let _e778 = ((_e741 >> bitcast<u32>(31i)) | (((_e765 >> bitcast<u32>(28u)) & 3u) << bitcast<u32>(1i)));
                                            let _e779 = (_e770 != 0u);
                                            if (_e770 == 0u) {
                                                phi_3678_ = _e766;
                                            } else {
                                                if (_e770 == 7u) {
                                                    phi_3677_ = 2147483648u;
                                                } else {
                                                    phi_3677_ = ((2147483648u | (_e770 << bitcast<u32>(28u))) | (_e767 & 268435455u));
                                                }
                                                let _e788 = phi_3677_;
                                                phi_3678_ = _e788;
                                            }
                                            let _e790 = phi_3678_;
                                            if _e779 {
                                                let _e791 = (_e770 != 7u);
                                                if _e791 {
                                                    phi_3688_ = (_e767 + _e770);
                                                } else {
                                                    phi_3688_ = u32();
                                                }
                                                let _e794 = phi_3688_;
                                                phi_3690_ = _e794;
                                                phi_3691_ = select(true, false, _e791);
                                            } else {
                                                phi_3690_ = u32();
                                                phi_3691_ = true;
                                            }
                                            let _e797 = phi_3690_;
                                            let _e799 = phi_3691_;
                                            if (_e778 == 0u) {
                                                phi_3712_ = (_e766 + select(0u, 1u, !(_e779)));
                                            } else {
                                                if (_e778 == 7u) {
                                                    phi_3711_ = 2147483648u;
                                                } else {
                                                    phi_3711_ = ((2147483648u | (_e778 << bitcast<u32>(28u))) | (select(_e797, _e767, _e799) & 268435455u));
                                                }
                                                let _e812 = phi_3711_;
                                                phi_3712_ = _e812;
                                            }
                                            let _e814 = phi_3712_;
                                            phi_3716_ = type_54(array<vec4<f32>, 3>(vec4<f32>((_e516.member.member.x + _e642), (_e516.member.member.x + _e664), (_e516.member.member_1.x - _e681), (_e516.member.member_1.x - _e703)), vec4<f32>((_e516.member.member.y + _e651), (_e516.member.member.y + _e668), (_e516.member.member_1.y - _e690), (_e516.member.member_1.y - _e707)), vec4<f32>((_e516.member.member.z + _e660), (_e516.member.member.z + _e672), (_e516.member.member_1.z - _e699), (_e516.member.member_1.z - _e711))), type_51(type_29((_e516.member.member + vec4<f32>(_e642, _e651, _e660, 0f)), (_e516.member.member_1 - vec4<f32>(_e681, _e690, _e699, 0f))), _e790), type_51(type_29((_e516.member.member + vec4<f32>(_e664, _e668, _e672, 0f)), (_e516.member.member_1 - vec4<f32>(_e703, _e707, _e711, 0f))), _e814));
                                        }
                                        let _e819 = phi_3716_;
                                        let _e830 = ((_e819.member[0].x - _e317) * _e322);
                                        let _e831 = ((_e819.member[0].y - _e317) * _e322);
                                        let _e832 = ((_e819.member[0].z - _e318) * _e322);
                                        let _e833 = ((_e819.member[0].w - _e318) * _e322);
                                        let _e843 = ((_e819.member[1].x - _e355) * _e360);
                                        let _e844 = ((_e819.member[1].y - _e355) * _e360);
                                        let _e845 = ((_e819.member[1].z - _e356) * _e360);
                                        let _e846 = ((_e819.member[1].w - _e356) * _e360);
                                        let _e856 = ((_e819.member[2].x - _e393) * _e398);
                                        let _e857 = ((_e819.member[2].y - _e393) * _e398);
                                        let _e858 = ((_e819.member[2].z - _e394) * _e398);
                                        let _e859 = ((_e819.member[2].w - _e394) * _e398);
                                        let _e861 = select(_e858, _e856, (_e856 < _e858));
                                        let _e863 = select(_e859, _e857, (_e857 < _e859));
                                        let _e865 = select(_e858, _e856, (_e856 > _e858));
                                        let _e867 = select(_e859, _e857, (_e857 > _e859));
                                        let _e869 = select(_e832, _e830, (_e830 < _e832));
                                        let _e871 = select(_e833, _e831, (_e831 < _e833));
                                        let _e873 = select(_e845, _e843, (_e843 < _e845));
                                        let _e875 = select(_e846, _e844, (_e844 < _e846));
                                        let _e877 = select(_e873, _e869, (_e869 > _e873));
                                        let _e879 = select(_e875, _e871, (_e871 > _e875));
                                        let _e881 = select(_e861, _e877, (_e877 > _e861));
                                        let _e883 = select(_e863, _e879, (_e879 > _e863));
                                        let _e885 = select(_e832, _e830, (_e830 > _e832));
                                        let _e887 = select(_e833, _e831, (_e831 > _e833));
                                        let _e889 = select(_e845, _e843, (_e843 > _e845));
                                        let _e891 = select(_e846, _e844, (_e844 > _e846));
                                        let _e893 = select(_e889, _e885, (_e885 < _e889));
                                        let _e895 = select(_e891, _e887, (_e887 < _e891));
                                        let _e900 = -(_e861);
                                        let _e901 = -(_e863);
                                        let _e908 = (select(_e865, _e893, (_e893 < _e865)) + (select(_e900, _e865, (_e865 > _e900)) * 0.0000019073523f));
                                        let _e909 = (select(_e867, _e895, (_e895 < _e867)) + (select(_e901, _e867, (_e867 > _e901)) * 0.0000019073523f));
                                        let _e911 = select(_e445, _e881, (_e881 > _e445));
                                        let _e913 = select(_e445, _e883, (_e883 > _e445));
                                        let _e918 = (_e911 <= select(_e488, _e908, (_e908 < _e488)));
                                        let _e919 = (_e913 <= select(_e488, _e909, (_e909 < _e488)));
                                        let _e920 = (_e911 <= _e913);
                                        if _e918 {
                                            if _e919 {
                                                if _e920 {
                                                    phi_4061_ = _e819.member_2;
                                                } else {
                                                    phi_4061_ = _e819.member_1;
                                                }
                                                let _e924 = phi_4061_;
                                                let _e925 = (_e520 % 128u);
                                                let _e926 = (_e925 < 128u);
                                                if _e926 {
                                                } else {
                                                    phi_4676_ = true;
                                                    break;
                                                }
                                                local_4[_e925] = type_51(type_29(_e924.member.member, _e924.member.member_1), _e924.member_1);
                                                if _e926 {
                                                } else {
                                                    phi_4676_ = true;
                                                    break;
                                                }
                                                local_3[_e925] = select(_e913, _e911, (_e911 > _e913));
                                                if _e920 {
                                                    phi_4094_ = _e819.member_1;
                                                } else {
                                                    phi_4094_ = _e819.member_2;
                                                }
                                                let _e941 = phi_4094_;
                                                phi_4095_ = _e941;
                                                phi_4096_ = (_e520 + 1u);
                                            } else {
                                                phi_4095_ = type_51();
                                                phi_4096_ = u32();
                                            }
                                            let _e943 = phi_4095_;
                                            let _e945 = phi_4096_;
                                            phi_4098_ = _e943;
                                            phi_4099_ = _e945;
                                            phi_4100_ = select(true, false, _e919);
                                        } else {
                                            phi_4098_ = type_51();
                                            phi_4099_ = u32();
                                            phi_4100_ = true;
                                        }
                                        let _e948 = phi_4098_;
                                        let _e950 = phi_4099_;
                                        let _e952 = phi_4100_;
                                        if _e952 {
                                            if _e918 {
                                                phi_4109_ = _e819.member_1;
                                            } else {
                                                phi_4109_ = _e819.member_2;
                                            }
                                            let _e956 = phi_4109_;
                                            phi_4114_ = _e956;
                                            phi_4115_ = select(_e919, true, _e918);
                                        } else {
                                            phi_4114_ = _e948;
                                            phi_4115_ = _e518;
                                        }
                                        let _e959 = phi_4114_;
                                        let _e961 = phi_4115_;
                                        phi_4793_ = _e488;
                                        phi_4680_ = _e486;
                                        phi_4117_ = _e959;
                                        phi_4118_ = _e961;
                                        phi_4119_ = select(_e950, _e520, _e952);
                                    }
                                    let _e1433 = phi_4793_;
                                    let _e1435 = phi_4680_;
                                    let _e1437 = phi_4117_;
                                    let _e1439 = phi_4118_;
                                    let _e1441 = phi_4119_;
                                    phi_4792_ = _e1433;
                                    phi_4679_ = _e1435;
                                    phi_4120_ = _e1437;
                                    phi_4121_ = (_e492 - 1u);
                                    phi_4122_ = _e1439;
                                    phi_4123_ = _e1441;
                                } else {
                                    phi_4792_ = _e488;
                                    phi_4679_ = _e486;
                                    phi_4120_ = _e516;
                                    phi_4121_ = _e492;
                                    phi_4122_ = _e518;
                                    phi_4123_ = _e520;
                                }
                                let _e1443 = phi_4792_;
                                let _e1445 = phi_4679_;
                                let _e1447 = phi_4120_;
                                let _e1449 = phi_4121_;
                                let _e1451 = phi_4122_;
                                let _e1453 = phi_4123_;
                                phi_4791_ = _e1443;
                                phi_4678_ = _e1445;
                                phi_4124_ = _e1447;
                                phi_4125_ = _e1449;
                                phi_4126_ = _e1451;
                                phi_4127_ = _e1453;
                            } else {
                                phi_4791_ = _e488;
                                phi_4678_ = _e486;
                                phi_4124_ = type_51();
                                phi_4125_ = u32();
                                phi_4126_ = bool();
                                phi_4127_ = u32();
                            }
                            let _e1455 = phi_4791_;
                            let _e1457 = phi_4678_;
                            let _e1459 = phi_4124_;
                            let _e1461 = phi_4125_;
                            let _e1463 = phi_4126_;
                            let _e1465 = phi_4127_;
                            phi_4790_ = _e1455;
                            phi_4677_ = _e1457;
                            phi_1924_ = _e1459;
                            phi_1927_ = _e1461;
                            phi_1929_ = _e1463;
                            phi_1931_ = _e1465;
                            phi_4128_ = _e500;
                        } else {
                            phi_4790_ = _e488;
                            phi_4677_ = _e486;
                            phi_1924_ = type_51();
                            phi_1927_ = u32();
                            phi_1929_ = bool();
                            phi_1931_ = u32();
                            phi_4128_ = false;
                        }
                        let _e1467 = phi_4790_;
                        let _e1469 = phi_4677_;
                        let _e1471 = phi_1924_;
                        let _e1473 = phi_1927_;
                        let _e1475 = phi_1929_;
                        let _e1477 = phi_1931_;
                        let _e1479 = phi_4128_;
                        continue;
                        continuing {
                            phi_4573_ = _e1469;
                            phi_4486_ = _e1467;
                            phi_1923_ = _e1471;
                            phi_1926_ = _e1473;
                            phi_1928_ = _e1475;
                            phi_1930_ = _e1477;
                            phi_4676_ = _e1469;
                            break if !(_e1479);
                        }
                    }
                    let _e1482 = phi_4676_;
                    if _e1482 {
                        break;
                    }
                    phi_4135_ = type_4(0u, 8u);
                    loop {
                        let _e1484 = phi_4135_;
                        if (_e1484.member < _e1484.member_1) {
                            phi_4136_ = type_4((_e1484.member + 1u), _e1484.member_1);
                            phi_4159_ = type_4(1u, _e1484.member);
                        } else {
                            phi_4136_ = _e1484;
                            phi_4159_ = type_4(0u, type_4().member_1);
                        }
                        let _e1497 = phi_4136_;
                        let _e1499 = phi_4159_;
                        let _e1503 = (bitcast<i32>(_e1499.member) != 0i);
                        if _e1503 {
                            let _e1504 = (_e1499.member_1 < 8u);
                            if _e1504 {
                            } else {
                                phi_4783_ = true;
                                break;
                            }
                            let _e1506 = local_2[_e1499.member_1];
                            if (_e1506.member_3 != 4294967295u) {
                                let _e1512 = -(_e412);
                                let _e1513 = (_e1512 / 3i);
                                let _e1520 = bitcast<f32>((bitcast<u32>((_e1513 + 127i)) << bitcast<u32>(23i)));
                                let _e1528 = (((_e1506.member * _e1520) * _e1520) * bitcast<f32>((bitcast<u32>(((_e1512 - (2i * _e1513)) + 127i)) << bitcast<u32>(23i))));
                                let _e1530 = select(340282350000000000000000000000000000000f, _e1528, (_e1528 < 340282350000000000000000000000000000000f));
                                phi_4225_ = type_25(select(-340282350000000000000000000000000000000f, _e1530, (_e1530 > -340282350000000000000000000000000000000f)), _e1506.member_1, _e1506.member_2, _e1506.member_3);
                            } else {
                                phi_4225_ = type_25(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                            }
                            let _e1535 = phi_4225_;
                            if _e1504 {
                            } else {
                                phi_4783_ = true;
                                break;
                            }
                            local_2[_e1499.member_1] = type_25(_e1535.member, _e1535.member_1, _e1535.member_2, _e1535.member_3);
                        }
                        continue;
                        continuing {
                            phi_4135_ = _e1497;
                            phi_4783_ = _e1482;
                            break if !(_e1503);
                        }
                    }
                    let _e1543 = phi_4783_;
                    if _e1543 {
                        break;
                    }
                    let _e1544 = local_2;
                    if _e141 {
                    } else {
                        break;
                    }
                    global_6.member[_e139] = array<type_25, 8>(type_25(_e1544[0].member, _e1544[0].member_1, _e1544[0].member_2, _e1544[0].member_3), type_25(_e1544[1].member, _e1544[1].member_1, _e1544[1].member_2, _e1544[1].member_3), type_25(_e1544[2].member, _e1544[2].member_1, _e1544[2].member_2, _e1544[2].member_3), type_25(_e1544[3].member, _e1544[3].member_1, _e1544[3].member_2, _e1544[3].member_3), type_25(_e1544[4].member, _e1544[4].member_1, _e1544[4].member_2, _e1544[4].member_3), type_25(_e1544[5].member, _e1544[5].member_1, _e1544[5].member_2, _e1544[5].member_3), type_25(_e1544[6].member, _e1544[6].member_1, _e1544[6].member_2, _e1544[6].member_3), type_25(_e1544[7].member, _e1544[7].member_1, _e1544[7].member_2, _e1544[7].member_3));
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn trace_nearest_q10_f32_(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
