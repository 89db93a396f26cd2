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

struct type_25 {
    member: vec4<f32>,
    member_1: vec4<f32>,
}

struct type_32 {
    member: array<type_22>,
}

struct type_36 {
    member: array<array<type_21, 8>>,
}

struct type_42 {
    member: array<vec4<u32>, 2>,
}

struct type_49 {
    member: array<array<u32, 7>>,
}

struct type_51 {
    member: type_25,
    member_1: u32,
}

struct type_54 {
    member: array<vec4<f32>, 3>,
    member_1: type_51,
    member_2: type_51,
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
var<storage> global_5: type_49;
@group(0) @binding(5) 
var<storage, read_write> global_6: type_36;

fn function_() {
    var local: array<i32, 3>;
    var local_1: array<i32, 3>;
    var local_2: array<type_21, 8>;
    var local_3: array<f32, 128>;
    var local_4: array<type_51, 128>;
    var phi_386_: i32;
    var phi_387_: i32;
    var phi_397_: bool;
    var phi_407_: u32;
    var phi_408_: u32;
    var phi_410_: bool;
    var phi_415_: u32;
    var phi_428_: i32;
    var phi_448_: i32;
    var phi_466_: f32;
    var phi_472_: f32;
    var phi_483_: f32;
    var phi_489_: f32;
    var phi_512_: f32;
    var phi_523_: f32;
    var phi_532_: f32;
    var phi_538_: f32;
    var phi_549_: f32;
    var phi_555_: f32;
    var phi_578_: f32;
    var phi_589_: f32;
    var phi_598_: f32;
    var phi_604_: f32;
    var phi_615_: f32;
    var phi_621_: f32;
    var phi_644_: f32;
    var phi_655_: f32;
    var phi_755_: f32;
    var phi_756_: f32;
    var phi_4579_: bool;
    var phi_4492_: f32;
    var phi_1929_: type_51;
    var phi_1932_: u32;
    var phi_1934_: bool;
    var phi_1936_: u32;
    var phi_1947_: bool;
    var phi_1985_: type_51;
    var phi_1986_: bool;
    var phi_1987_: u32;
    var phi_3683_: u32;
    var phi_3684_: u32;
    var phi_3694_: u32;
    var phi_3696_: u32;
    var phi_3697_: bool;
    var phi_3717_: u32;
    var phi_3718_: u32;
    var phi_3722_: type_54;
    var phi_4067_: type_51;
    var phi_4100_: type_51;
    var phi_4101_: type_51;
    var phi_4102_: u32;
    var phi_4104_: type_51;
    var phi_4105_: u32;
    var phi_4106_: bool;
    var phi_4115_: type_51;
    var phi_4120_: type_51;
    var phi_4121_: bool;
    var phi_4576_: bool;
    var phi_4566_: f32;
    var phi_2005_: type_4;
    var phi_2006_: type_4;
    var phi_2029_: type_4;
    var phi_2050_: u32;
    var phi_2139_: array<array<f32, 3>, 3>;
    var phi_2611_: vec3<f32>;
    var phi_2612_: vec3<f32>;
    var phi_2643_: bool;
    var phi_2652_: vec3<f32>;
    var phi_2692_: type_21;
    var phi_2694_: type_21;
    var phi_2695_: bool;
    var phi_2699_: type_21;
    var phi_2700_: type_21;
    var phi_2701_: type_21;
    var phi_2702_: bool;
    var phi_2706_: type_21;
    var phi_2707_: bool;
    var phi_2711_: type_21;
    var phi_2712_: bool;
    var phi_2716_: type_21;
    var phi_2728_: type_4;
    var phi_2731_: type_21;
    var phi_2729_: type_4;
    var phi_2754_: type_4;
    var phi_2786_: bool;
    var phi_2787_: bool;
    var phi_2808_: type_21;
    var phi_2732_: type_21;
    var phi_4567_: bool;
    var phi_4901_: f32;
    var phi_4900_: f32;
    var phi_4684_: bool;
    var phi_4899_: f32;
    var phi_4683_: bool;
    var phi_4898_: f32;
    var phi_4682_: bool;
    var phi_4838_: f32;
    var phi_4681_: bool;
    var phi_4803_: f32;
    var phi_4690_: bool;
    var phi_4123_: type_51;
    var phi_4124_: bool;
    var phi_4125_: u32;
    var phi_4802_: f32;
    var phi_4689_: bool;
    var phi_4126_: type_51;
    var phi_4127_: u32;
    var phi_4128_: bool;
    var phi_4129_: u32;
    var phi_4801_: f32;
    var phi_4688_: bool;
    var phi_4130_: type_51;
    var phi_4131_: u32;
    var phi_4132_: bool;
    var phi_4133_: u32;
    var phi_4800_: f32;
    var phi_4687_: bool;
    var phi_1930_: type_51;
    var phi_1933_: u32;
    var phi_1935_: bool;
    var phi_1937_: u32;
    var phi_4134_: bool;
    var phi_4686_: bool;
    var phi_4141_: type_4;
    var phi_4142_: type_4;
    var phi_4165_: type_4;
    var phi_4231_: type_21;
    var phi_4793_: bool;

    switch bitcast<i32>(0u) {
        default: {
            let _e81 = global;
            let _e83 = arrayLength((&global_5.member));
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
            let _e140 = (_e139 < arrayLength((&global_4.member)));
            if _e140 {
                let _e141 = (_e139 < arrayLength((&global_6.member)));
                if _e141 {
                    if _e140 {
                    } else {
                        break;
                    }
                    let _e149 = global_4.member[_e139].member_2[0u];
                    let _e151 = (bitcast<u32>(_e149) & 2147483647u);
                    let _e156 = global_4.member[_e139].member_2[1u];
                    let _e158 = (bitcast<u32>(_e156) & 2147483647u);
                    let _e163 = global_4.member[_e139].member_2[2u];
                    let _e165 = (bitcast<u32>(_e163) & 2147483647u);
                    let _e170 = global_4.member[_e139].member[0u];
                    let _e172 = (bitcast<u32>(_e170) & 2147483647u);
                    let _e177 = global_4.member[_e139].member[1u];
                    let _e179 = (bitcast<u32>(_e177) & 2147483647u);
                    let _e184 = global_4.member[_e139].member[2u];
                    let _e186 = (bitcast<u32>(_e184) & 2147483647u);
                    let _e188 = select(_e158, _e151, (_e158 < _e151));
                    let _e190 = select(_e165, _e188, (_e165 < _e188));
                    let _e192 = select(_e172, _e190, (_e172 < _e190));
                    let _e194 = select(_e179, _e192, (_e179 < _e192));
                    let _e196 = select(_e186, _e194, (_e186 < _e194));
                    let _e200 = global_4.member[_e139].member_1;
                    let _e202 = (bitcast<u32>(_e200) & 2147483647u);
                    let _e209 = global_4.member[_e139].member_3;
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
                    if (_e121 < -126i) {
                        phi_428_ = -126i;
                    } else {
                        phi_428_ = select(_e121, 127i, (_e121 > 127i));
                    }
                    let _e259 = phi_428_;
                    let _e264 = bitcast<f32>((bitcast<u32>((_e259 + 127i)) << bitcast<u32>(23i)));
                    let _e270 = bitcast<f32>((bitcast<u32>(((_e121 - _e259) + 127i)) << bitcast<u32>(23i)));
                    let _e271 = -(_e234);
                    if (_e271 < -126i) {
                        phi_448_ = -126i;
                    } else {
                        phi_448_ = select(_e271, 127i, (_e271 > 127i));
                    }
                    let _e276 = phi_448_;
                    let _e281 = bitcast<f32>((bitcast<u32>((_e276 + 127i)) << bitcast<u32>(23i)));
                    let _e287 = bitcast<f32>((bitcast<u32>(((_e271 - _e276) + 127i)) << bitcast<u32>(23i)));
                    let _e291 = global_4.member[_e139].member;
                    let _e292 = (_e253 == 0u);
                    if _e292 {
                        phi_466_ = _e291[0];
                    } else {
                        phi_466_ = _e291[1];
                    }
                    let _e296 = phi_466_;
                    let _e297 = (_e253 == 2u);
                    if _e297 {
                        phi_472_ = _e291[2];
                    } else {
                        phi_472_ = _e296;
                    }
                    let _e300 = phi_472_;
                    let _e302 = ((_e300 * _e264) * _e270);
                    let _e303 = global_4.member[_e139].member_2;
                    if _e292 {
                        phi_483_ = _e303[0];
                    } else {
                        phi_483_ = _e303[1];
                    }
                    let _e307 = phi_483_;
                    if _e297 {
                        phi_489_ = _e303[2];
                    } else {
                        phi_489_ = _e307;
                    }
                    let _e310 = phi_489_;
                    let _e312 = ((_e310 * _e281) * _e287);
                    let _e316 = (bitcast<f32>((bitcast<u32>(_e312) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e316 {
                        let _e320 = (bitcast<f32>((bitcast<u32>(_e302) & 2147483647u)) * 0.00000011920929f);
                        phi_512_ = select(0.00000000000011368684f, _e320, (_e320 > 0.00000000000011368684f));
                    } else {
                        phi_512_ = 0f;
                    }
                    let _e324 = phi_512_;
                    let _e325 = (_e302 + _e324);
                    let _e326 = (_e302 - _e324);
                    let _e327 = select(_e312, 0f, _e316);
                    if _e316 {
                        phi_523_ = 38685626000000000000000000f;
                    } else {
                        phi_523_ = (1f / _e312);
                    }
                    let _e330 = phi_523_;
                    let _e331 = (_e252 == 0u);
                    if _e331 {
                        phi_532_ = _e291[0];
                    } else {
                        phi_532_ = _e291[1];
                    }
                    let _e335 = phi_532_;
                    let _e336 = (_e252 == 2u);
                    if _e336 {
                        phi_538_ = _e291[2];
                    } else {
                        phi_538_ = _e335;
                    }
                    let _e339 = phi_538_;
                    let _e341 = ((_e339 * _e264) * _e270);
                    if _e331 {
                        phi_549_ = _e303[0];
                    } else {
                        phi_549_ = _e303[1];
                    }
                    let _e345 = phi_549_;
                    if _e336 {
                        phi_555_ = _e303[2];
                    } else {
                        phi_555_ = _e345;
                    }
                    let _e348 = phi_555_;
                    let _e350 = ((_e348 * _e281) * _e287);
                    let _e354 = (bitcast<f32>((bitcast<u32>(_e350) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e354 {
                        let _e358 = (bitcast<f32>((bitcast<u32>(_e341) & 2147483647u)) * 0.00000011920929f);
                        phi_578_ = select(0.00000000000011368684f, _e358, (_e358 > 0.00000000000011368684f));
                    } else {
                        phi_578_ = 0f;
                    }
                    let _e362 = phi_578_;
                    let _e363 = (_e341 + _e362);
                    let _e364 = (_e341 - _e362);
                    let _e365 = select(_e350, 0f, _e354);
                    if _e354 {
                        phi_589_ = 38685626000000000000000000f;
                    } else {
                        phi_589_ = (1f / _e350);
                    }
                    let _e368 = phi_589_;
                    let _e369 = (_e254 == 0u);
                    if _e369 {
                        phi_598_ = _e291[0];
                    } else {
                        phi_598_ = _e291[1];
                    }
                    let _e373 = phi_598_;
                    let _e374 = (_e254 == 2u);
                    if _e374 {
                        phi_604_ = _e291[2];
                    } else {
                        phi_604_ = _e373;
                    }
                    let _e377 = phi_604_;
                    let _e379 = ((_e377 * _e264) * _e270);
                    if _e369 {
                        phi_615_ = _e303[0];
                    } else {
                        phi_615_ = _e303[1];
                    }
                    let _e383 = phi_615_;
                    if _e374 {
                        phi_621_ = _e303[2];
                    } else {
                        phi_621_ = _e383;
                    }
                    let _e386 = phi_621_;
                    let _e388 = ((_e386 * _e281) * _e287);
                    let _e392 = (bitcast<f32>((bitcast<u32>(_e388) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e392 {
                        let _e396 = (bitcast<f32>((bitcast<u32>(_e379) & 2147483647u)) * 0.00000011920929f);
                        phi_644_ = select(0.00000000000011368684f, _e396, (_e396 > 0.00000000000011368684f));
                    } else {
                        phi_644_ = 0f;
                    }
                    let _e400 = phi_644_;
                    let _e401 = (_e379 + _e400);
                    let _e402 = (_e379 - _e400);
                    let _e403 = select(_e388, 0f, _e392);
                    if _e392 {
                        phi_655_ = 38685626000000000000000000f;
                    } else {
                        phi_655_ = (1f / _e388);
                    }
                    let _e406 = phi_655_;
                    let _e409 = bitcast<f32>((bitcast<u32>(_e302) & 2147483647u));
                    let _e412 = bitcast<f32>((bitcast<u32>(_e341) & 2147483647u));
                    let _e414 = select(_e412, _e409, (_e409 > _e412));
                    let _e417 = bitcast<f32>((bitcast<u32>(_e379) & 2147483647u));
                    let _e420 = (_e121 + _e234);
                    if (_e215 && (select(_e417, _e414, (_e414 > _e417)) <= 1099511600000f)) {
                        let _e423 = (_e420 / 3i);
                        let _e430 = bitcast<f32>((bitcast<u32>((_e423 + 127i)) << bitcast<u32>(23i)));
                        let _e437 = bitcast<f32>((bitcast<u32>(((_e420 - (2i * _e423)) + 127i)) << bitcast<u32>(23i)));
                        let _e438 = (((_e200 * _e430) * _e430) * _e437);
                        let _e440 = select(340282350000000000000000000000000000000f, _e438, (_e438 < 340282350000000000000000000000000000000f));
                        let _e445 = (((_e209 * _e430) * _e430) * _e437);
                        let _e447 = select(340282350000000000000000000000000000000f, _e445, (_e445 < 340282350000000000000000000000000000000f));
                        phi_755_ = select(-340282350000000000000000000000000000000f, _e447, (_e447 > -340282350000000000000000000000000000000f));
                        phi_756_ = select(-340282350000000000000000000000000000000f, _e440, (_e440 > -340282350000000000000000000000000000000f));
                    } else {
                        phi_755_ = 0f;
                        phi_756_ = 1f;
                    }
                    let _e451 = phi_755_;
                    let _e453 = phi_756_;
                    local_2 = array<type_21, 8>(type_21(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_21(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_21(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_21(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_21(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_21(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_21(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_21(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u));
                    local_4 = array<type_51, 128>(type_51(type_25(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_25(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_25(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_25(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_25(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_25(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_25(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_25(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_25(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_25(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_25(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_25(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_25(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_25(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_25(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_25(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_25(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_25(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_25(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_25(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_25(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_25(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_25(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_25(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_25(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_25(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_25(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_25(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_25(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_25(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_25(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_25(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_25(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_25(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_25(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_25(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_25(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_25(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_25(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_25(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_25(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_25(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_25(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_25(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_25(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_25(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_25(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_25(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_25(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_25(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_25(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_25(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_25(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_25(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_25(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_25(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_25(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_25(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_25(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_25(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_25(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_25(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_25(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_25(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_25(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_25(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_25(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_25(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_25(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_25(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_25(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_25(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_25(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_25(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_25(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_25(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_25(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_25(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_25(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_25(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_25(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_25(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_25(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_25(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_25(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_25(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_25(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_25(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_25(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_25(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_25(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_25(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_25(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_25(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_25(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_25(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_25(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_25(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_25(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_25(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_25(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_25(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_25(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_25(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_25(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_25(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_25(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_25(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_25(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_25(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_25(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_25(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_25(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_25(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_25(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_25(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_25(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_25(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_25(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_25(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_25(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_25(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_25(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_25(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_25(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_25(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_25(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_25(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u));
                    local_3 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    let _e456 = (_e253 % 3u);
                    let _e457 = (_e456 < 3u);
                    if _e457 {
                    } else {
                        break;
                    }
                    let _e459 = local_1[_e456];
                    let _e462 = (_e252 % 3u);
                    let _e463 = (_e462 < 3u);
                    if _e463 {
                    } else {
                        break;
                    }
                    let _e465 = local_1[_e462];
                    let _e468 = (_e254 % 3u);
                    let _e469 = (_e468 < 3u);
                    if _e469 {
                    } else {
                        break;
                    }
                    let _e471 = local_1[_e468];
                    if _e457 {
                    } else {
                        break;
                    }
                    let _e476 = local[_e456];
                    if _e463 {
                    } else {
                        break;
                    }
                    let _e480 = local[_e462];
                    if _e469 {
                    } else {
                        break;
                    }
                    let _e484 = local[_e468];
                    phi_4579_ = false;
                    phi_4492_ = _e451;
                    phi_1929_ = type_51(type_25(vec4<f32>((f32(_e459) * _e133), (f32(_e465) * _e133), (f32(_e471) * _e133), 0f), vec4<f32>((f32(_e476) * _e133), (f32(_e480) * _e133), (f32(_e484) * _e133), 0f)), select(0u, 2147483648u, (_e83 == 0u)));
                    phi_1932_ = ((3u * _e83) + 1u);
                    phi_1934_ = (_e453 <= _e451);
                    phi_1936_ = 0u;
                    loop {
                        let _e494 = phi_4579_;
                        let _e496 = phi_4492_;
                        let _e498 = phi_1929_;
                        let _e500 = phi_1932_;
                        let _e502 = phi_1934_;
                        let _e504 = phi_1936_;
                        if _e502 {
                            phi_1947_ = true;
                        } else {
                            phi_1947_ = (_e504 > 0u);
                        }
                        let _e507 = phi_1947_;
                        if _e507 {
                            let _e508 = (_e500 > 0u);
                            if _e508 {
                                if _e502 {
                                    phi_1985_ = _e498;
                                    phi_1986_ = _e502;
                                    phi_1987_ = _e504;
                                } else {
                                    let _e509 = (_e504 - 1u);
                                    let _e510 = (_e509 % 128u);
                                    let _e511 = (_e510 < 128u);
                                    if _e511 {
                                    } else {
                                        phi_4686_ = true;
                                        break;
                                    }
                                    let _e513 = local_4[_e510];
                                    if _e511 {
                                    } else {
                                        phi_4686_ = true;
                                        break;
                                    }
                                    let _e521 = local_3[_e510];
                                    phi_1985_ = type_51(type_25(_e513.member.member, _e513.member.member_1), _e513.member_1);
                                    phi_1986_ = (_e521 <= _e496);
                                    phi_1987_ = _e509;
                                }
                                let _e524 = phi_1985_;
                                let _e526 = phi_1986_;
                                let _e528 = phi_1987_;
                                if _e526 {
                                    if ((_e524.member_1 & 2147483648u) != 0u) {
                                        phi_4576_ = _e494;
                                        phi_4566_ = _e496;
                                        phi_2005_ = type_4(0u, ((_e524.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e973 = phi_4576_;
                                            let _e975 = phi_4566_;
                                            let _e977 = phi_2005_;
                                            if (_e977.member < _e977.member_1) {
                                                phi_2006_ = type_4((_e977.member + 1u), _e977.member_1);
                                                phi_2029_ = type_4(1u, _e977.member);
                                            } else {
                                                phi_2006_ = _e977;
                                                phi_2029_ = type_4(0u, type_4().member_1);
                                            }
                                            let _e990 = phi_2006_;
                                            let _e992 = phi_2029_;
                                            let _e996 = (bitcast<i32>(_e992.member) != 0i);
                                            if _e996 {
                                                let _e997 = ((_e524.member_1 & 268435455u) + _e992.member_1);
                                                let _e998 = (_e997 < _e85);
                                                if _e998 {
                                                    if _e998 {
                                                    } else {
                                                        phi_4838_ = _e975;
                                                        phi_4681_ = true;
                                                        break;
                                                    }
                                                    let _e1002 = global_2.member[_e997].member_1;
                                                    phi_2050_ = _e1002;
                                                } else {
                                                    phi_2050_ = 4294967295u;
                                                }
                                                let _e1004 = phi_2050_;
                                                if (_e997 >= _e85) {
                                                    phi_2139_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                } else {
                                                    if _e998 {
                                                    } else {
                                                        phi_4838_ = _e975;
                                                        phi_4681_ = true;
                                                        break;
                                                    }
                                                    if (_e456 < 9u) {
                                                    } else {
                                                        phi_4838_ = _e975;
                                                        phi_4681_ = true;
                                                        break;
                                                    }
                                                    let _e1011 = global_2.member[_e997].member[_e456];
                                                    if (_e462 < 9u) {
                                                    } else {
                                                        phi_4838_ = _e975;
                                                        phi_4681_ = true;
                                                        break;
                                                    }
                                                    let _e1017 = global_2.member[_e997].member[_e462];
                                                    if (_e468 < 9u) {
                                                    } else {
                                                        phi_4838_ = _e975;
                                                        phi_4681_ = true;
                                                        break;
                                                    }
                                                    let _e1023 = global_2.member[_e997].member[_e468];
                                                    let _e1025 = (3u + _e456);
                                                    if (_e1025 < 9u) {
                                                    } else {
                                                        phi_4838_ = _e975;
                                                        phi_4681_ = true;
                                                        break;
                                                    }
                                                    let _e1031 = global_2.member[_e997].member[_e1025];
                                                    let _e1032 = (3u + _e462);
                                                    if (_e1032 < 9u) {
                                                    } else {
                                                        phi_4838_ = _e975;
                                                        phi_4681_ = true;
                                                        break;
                                                    }
                                                    let _e1038 = global_2.member[_e997].member[_e1032];
                                                    let _e1039 = (3u + _e468);
                                                    if (_e1039 < 9u) {
                                                    } else {
                                                        phi_4838_ = _e975;
                                                        phi_4681_ = true;
                                                        break;
                                                    }
                                                    let _e1045 = global_2.member[_e997].member[_e1039];
                                                    let _e1047 = (6u + _e456);
                                                    if (_e1047 < 9u) {
                                                    } else {
                                                        phi_4838_ = _e975;
                                                        phi_4681_ = true;
                                                        break;
                                                    }
                                                    let _e1053 = global_2.member[_e997].member[_e1047];
                                                    let _e1054 = (6u + _e462);
                                                    if (_e1054 < 9u) {
                                                    } else {
                                                        phi_4838_ = _e975;
                                                        phi_4681_ = true;
                                                        break;
                                                    }
                                                    let _e1060 = global_2.member[_e997].member[_e1054];
                                                    let _e1061 = (6u + _e468);
                                                    if (_e1061 < 9u) {
                                                    } else {
                                                        phi_4838_ = _e975;
                                                        phi_4681_ = true;
                                                        break;
                                                    }
                                                    let _e1067 = global_2.member[_e997].member[_e1061];
                                                    phi_2139_ = array<array<f32, 3>, 3>(array<f32, 3>(_e1011, _e1017, _e1023), array<f32, 3>(_e1031, _e1038, _e1045), array<f32, 3>(_e1053, _e1060, _e1067));
                                                }
                                                let _e1071 = phi_2139_;
                                                let _e1078 = (_e1071[0][2] - _e379);
                                                let _e1081 = (((_e1071[0][0] - _e302) * _e403) - (_e1078 * _e327));
                                                let _e1084 = (((_e1071[0][1] - _e341) * _e403) - (_e1078 * _e365));
                                                let _e1091 = (_e1071[1][2] - _e379);
                                                let _e1094 = (((_e1071[1][0] - _e302) * _e403) - (_e1091 * _e327));
                                                let _e1097 = (((_e1071[1][1] - _e341) * _e403) - (_e1091 * _e365));
                                                let _e1104 = (_e1071[2][2] - _e379);
                                                let _e1107 = (((_e1071[2][0] - _e302) * _e403) - (_e1104 * _e327));
                                                let _e1110 = (((_e1071[2][1] - _e341) * _e403) - (_e1104 * _e365));
                                                let _e1111 = (_e1107 * _e1097);
                                                let _e1112 = (_e1110 * _e1094);
                                                let _e1113 = (_e1081 * _e1110);
                                                let _e1114 = (_e1084 * _e1107);
                                                let _e1115 = (_e1094 * _e1084);
                                                let _e1116 = (_e1097 * _e1081);
                                                let _e1121 = (((_e1111 >= _e1112) && (_e1113 >= _e1114)) && (_e1115 >= _e1116));
                                                if (_e1121 || (((_e1111 <= _e1112) && (_e1113 <= _e1114)) && (_e1115 <= _e1116))) {
                                                    let _e1128 = select(-1f, 1f, _e1121);
                                                    let _e1130 = ((_e1111 - _e1112) * _e1128);
                                                    let _e1132 = select(0f, _e1130, (_e1130 > 0f));
                                                    let _e1134 = ((_e1113 - _e1114) * _e1128);
                                                    let _e1136 = select(0f, _e1134, (_e1134 > 0f));
                                                    let _e1138 = ((_e1115 - _e1116) * _e1128);
                                                    let _e1140 = select(0f, _e1138, (_e1138 > 0f));
                                                    let _e1142 = ((_e1132 + _e1136) + _e1140);
                                                    if (_e1142 < 0.000000000000000000000000000000000000011754944f) {
                                                        phi_2706_ = type_21();
                                                        phi_2707_ = true;
                                                    } else {
                                                        let _e1145 = select(_e1071[1][0], _e1071[0][0], (_e1071[0][0] < _e1071[1][0]));
                                                        let _e1149 = select(_e1071[1][0], _e1071[0][0], (_e1071[0][0] > _e1071[1][0]));
                                                        let _e1153 = select(_e1071[1][1], _e1071[0][1], (_e1071[0][1] < _e1071[1][1]));
                                                        let _e1157 = select(_e1071[1][1], _e1071[0][1], (_e1071[0][1] > _e1071[1][1]));
                                                        let _e1161 = select(_e1071[1][2], _e1071[0][2], (_e1071[0][2] < _e1071[1][2]));
                                                        let _e1165 = select(_e1071[1][2], _e1071[0][2], (_e1071[0][2] > _e1071[1][2]));
                                                        let _e1170 = ((select(_e1071[2][0], _e1145, (_e1145 < _e1071[2][0])) - _e325) * _e330);
                                                        let _e1171 = ((select(_e1071[2][0], _e1149, (_e1149 > _e1071[2][0])) - _e326) * _e330);
                                                        let _e1174 = ((select(_e1071[2][1], _e1153, (_e1153 < _e1071[2][1])) - _e363) * _e368);
                                                        let _e1175 = ((select(_e1071[2][1], _e1157, (_e1157 > _e1071[2][1])) - _e364) * _e368);
                                                        let _e1178 = ((select(_e1071[2][2], _e1161, (_e1161 < _e1071[2][2])) - _e401) * _e406);
                                                        let _e1179 = ((select(_e1071[2][2], _e1165, (_e1165 > _e1071[2][2])) - _e402) * _e406);
                                                        let _e1181 = select(_e1179, _e1178, (_e1178 < _e1179));
                                                        let _e1183 = select(_e1179, _e1178, (_e1178 > _e1179));
                                                        let _e1185 = select(_e1171, _e1170, (_e1170 < _e1171));
                                                        let _e1187 = select(_e1175, _e1174, (_e1174 < _e1175));
                                                        let _e1189 = select(_e1187, _e1185, (_e1185 > _e1187));
                                                        let _e1191 = select(_e1181, _e1189, (_e1189 > _e1181));
                                                        let _e1193 = select(_e1171, _e1170, (_e1170 > _e1171));
                                                        let _e1195 = select(_e1175, _e1174, (_e1174 > _e1175));
                                                        let _e1197 = select(_e1195, _e1193, (_e1193 < _e1195));
                                                        let _e1199 = select(_e1183, _e1197, (_e1197 < _e1183));
                                                        let _e1200 = -(_e1181);
                                                        let _e1206 = select(_e453, _e1191, (_e1191 > _e453));
                                                        if (_e1206 > (_e1199 + (select(_e1200, _e1183, (_e1183 > _e1200)) * 0.0000019073523f))) {
                                                            phi_2701_ = type_21();
                                                            phi_2702_ = true;
                                                        } else {
                                                            let _e1208 = (_e1206 > _e975);
                                                            if _e1208 {
                                                                phi_2700_ = type_21();
                                                            } else {
                                                                let _e1212 = (_e1071[1][0] - _e1071[0][0]);
                                                                let _e1213 = (_e1071[1][1] - _e1071[0][1]);
                                                                let _e1214 = (_e1071[1][2] - _e1071[0][2]);
                                                                let _e1215 = vec3<f32>(_e1212, _e1213, _e1214);
                                                                let _e1216 = (_e1071[2][0] - _e1071[1][0]);
                                                                let _e1217 = (_e1071[2][1] - _e1071[1][1]);
                                                                let _e1218 = (_e1071[2][2] - _e1071[1][2]);
                                                                let _e1219 = vec3<f32>(_e1216, _e1217, _e1218);
                                                                let _e1220 = (_e1071[0][0] - _e1071[2][0]);
                                                                let _e1221 = (_e1071[0][1] - _e1071[2][1]);
                                                                let _e1222 = (_e1071[0][2] - _e1071[2][2]);
                                                                let _e1223 = vec3<f32>(_e1220, _e1221, _e1222);
                                                                let _e1226 = bitcast<f32>((bitcast<u32>(_e1212) & 2147483647u));
                                                                let _e1229 = bitcast<f32>((bitcast<u32>(_e1213) & 2147483647u));
                                                                let _e1231 = select(_e1229, _e1226, (_e1226 > _e1229));
                                                                let _e1234 = bitcast<f32>((bitcast<u32>(_e1214) & 2147483647u));
                                                                let _e1236 = select(_e1234, _e1231, (_e1231 > _e1234));
                                                                let _e1239 = bitcast<f32>((bitcast<u32>(_e1216) & 2147483647u));
                                                                let _e1242 = bitcast<f32>((bitcast<u32>(_e1217) & 2147483647u));
                                                                let _e1244 = select(_e1242, _e1239, (_e1239 > _e1242));
                                                                let _e1247 = bitcast<f32>((bitcast<u32>(_e1218) & 2147483647u));
                                                                let _e1249 = select(_e1247, _e1244, (_e1244 > _e1247));
                                                                let _e1252 = bitcast<f32>((bitcast<u32>(_e1220) & 2147483647u));
                                                                let _e1255 = bitcast<f32>((bitcast<u32>(_e1221) & 2147483647u));
                                                                let _e1257 = select(_e1255, _e1252, (_e1252 > _e1255));
                                                                let _e1260 = bitcast<f32>((bitcast<u32>(_e1222) & 2147483647u));
                                                                let _e1262 = select(_e1260, _e1257, (_e1257 > _e1260));
                                                                let _e1264 = select(_e1249, _e1236, (_e1236 > _e1249));
                                                                let _e1266 = select(_e1262, _e1264, (_e1264 > _e1262));
                                                                if (_e1236 == _e1266) {
                                                                    phi_2611_ = _e1219;
                                                                    phi_2612_ = _e1223;
                                                                } else {
                                                                    let _e1269 = vec3((_e1249 == _e1266));
                                                                    phi_2611_ = select(_e1215, _e1223, _e1269);
                                                                    phi_2612_ = select(_e1219, _e1215, _e1269);
                                                                }
                                                                let _e1273 = phi_2611_;
                                                                let _e1275 = phi_2612_;
                                                                let _e1282 = ((_e1273.y * _e1275.z) - (_e1275.y * _e1273.z));
                                                                let _e1287 = ((_e1273.z * _e1275.x) - (_e1275.z * _e1273.x));
                                                                let _e1290 = ((_e1273.x * _e1275.y) - (_e1275.x * _e1273.y));
                                                                if (_e1132 >= _e1136) {
                                                                    phi_2643_ = select(true, false, (_e1132 >= _e1140));
                                                                } else {
                                                                    phi_2643_ = true;
                                                                }
                                                                let _e1295 = phi_2643_;
                                                                if _e1295 {
                                                                    phi_2652_ = select(vec3<f32>(_e1071[2][0], _e1071[2][1], _e1071[2][2]), vec3<f32>(_e1071[1][0], _e1071[1][1], _e1071[1][2]), vec3((_e1136 >= _e1140)));
                                                                } else {
                                                                    phi_2652_ = vec3<f32>(_e1071[0][0], _e1071[0][1], _e1071[0][2]);
                                                                }
                                                                let _e1300 = phi_2652_;
                                                                let _e1317 = ((((_e1282 * (_e1300.x - _e302)) + (_e1287 * (_e1300.y - _e341))) + (_e1290 * (_e1300.z - _e379))) / (((_e1282 * _e327) + (_e1287 * _e365)) + (_e1290 * _e403)));
                                                                let _e1319 = select(_e1199, _e1317, (_e1317 < _e1199));
                                                                let _e1321 = select(_e1191, _e1319, (_e1319 > _e1191));
                                                                if (_e1321 >= _e453) {
                                                                    let _e1323 = (_e1321 <= _e975);
                                                                    if _e1323 {
                                                                        let _e1324 = (1f / _e1142);
                                                                        phi_2692_ = type_21(_e1321, (_e1136 * _e1324), (_e1140 * _e1324), _e1004);
                                                                    } else {
                                                                        phi_2692_ = type_21();
                                                                    }
                                                                    let _e1329 = phi_2692_;
                                                                    phi_2694_ = _e1329;
                                                                    phi_2695_ = select(true, false, _e1323);
                                                                } else {
                                                                    phi_2694_ = type_21();
                                                                    phi_2695_ = true;
                                                                }
                                                                let _e1332 = phi_2694_;
                                                                let _e1334 = phi_2695_;
                                                                if _e1334 {
                                                                    phi_2699_ = type_21(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                } else {
                                                                    phi_2699_ = _e1332;
                                                                }
                                                                let _e1336 = phi_2699_;
                                                                phi_2700_ = _e1336;
                                                            }
                                                            let _e1338 = phi_2700_;
                                                            phi_2701_ = _e1338;
                                                            phi_2702_ = _e1208;
                                                        }
                                                        let _e1340 = phi_2701_;
                                                        let _e1342 = phi_2702_;
                                                        phi_2706_ = _e1340;
                                                        phi_2707_ = _e1342;
                                                    }
                                                    let _e1344 = phi_2706_;
                                                    let _e1346 = phi_2707_;
                                                    phi_2711_ = _e1344;
                                                    phi_2712_ = _e1346;
                                                } else {
                                                    phi_2711_ = type_21();
                                                    phi_2712_ = true;
                                                }
                                                let _e1348 = phi_2711_;
                                                let _e1350 = phi_2712_;
                                                if _e1350 {
                                                    phi_2716_ = type_21(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                } else {
                                                    phi_2716_ = _e1348;
                                                }
                                                let _e1352 = phi_2716_;
                                                if (_e1352.member_3 != 4294967295u) {
                                                    if (_e1004 != 4294967295u) {
                                                        phi_2728_ = type_4(0u, 8u);
                                                        phi_2731_ = _e1352;
                                                        loop {
                                                            let _e1357 = phi_2728_;
                                                            let _e1359 = phi_2731_;
                                                            if (_e1357.member < _e1357.member_1) {
                                                                phi_2729_ = type_4((_e1357.member + 1u), _e1357.member_1);
                                                                phi_2754_ = type_4(1u, _e1357.member);
                                                            } else {
                                                                phi_2729_ = _e1357;
                                                                phi_2754_ = type_4(0u, type_4().member_1);
                                                            }
                                                            let _e1372 = phi_2729_;
                                                            let _e1374 = phi_2754_;
                                                            let _e1378 = (bitcast<i32>(_e1374.member) != 0i);
                                                            if _e1378 {
                                                                let _e1379 = (_e1374.member_1 < 8u);
                                                                if _e1379 {
                                                                } else {
                                                                    phi_4567_ = true;
                                                                    break;
                                                                }
                                                                let _e1384 = local_2[_e1374.member_1].member;
                                                                if (_e1359.member < _e1384) {
                                                                    phi_2787_ = true;
                                                                } else {
                                                                    let _e1386 = local_2[_e1374.member_1].member;
                                                                    if (_e1359.member == _e1386) {
                                                                        let _e1391 = local_2[_e1374.member_1].member_3;
                                                                        phi_2786_ = (_e1359.member_3 < _e1391);
                                                                    } else {
                                                                        phi_2786_ = false;
                                                                    }
                                                                    let _e1394 = phi_2786_;
                                                                    phi_2787_ = _e1394;
                                                                }
                                                                let _e1396 = phi_2787_;
                                                                if _e1396 {
                                                                    if _e1379 {
                                                                    } else {
                                                                        phi_4567_ = true;
                                                                        break;
                                                                    }
                                                                    let _e1397 = local_2[_e1374.member_1];
                                                                    local_2[_e1374.member_1] = type_21(_e1359.member, _e1359.member_1, _e1359.member_2, _e1359.member_3);
                                                                    phi_2808_ = type_21(_e1397.member, _e1397.member_1, _e1397.member_2, _e1397.member_3);
                                                                } else {
                                                                    phi_2808_ = _e1359;
                                                                }
                                                                let _e1408 = phi_2808_;
                                                                phi_2732_ = _e1408;
                                                            } else {
                                                                phi_2732_ = type_21();
                                                            }
                                                            let _e1410 = phi_2732_;
                                                            continue;
                                                            continuing {
                                                                phi_2728_ = _e1372;
                                                                phi_2731_ = _e1410;
                                                                phi_4567_ = _e973;
                                                                break if !(_e1378);
                                                            }
                                                        }
                                                        let _e1413 = phi_4567_;
                                                        phi_4838_ = _e975;
                                                        phi_4681_ = _e1413;
                                                        if _e1413 {
                                                            break;
                                                        }
                                                        let _e1416 = local_2[7u].member_3;
                                                        if (_e1416 != 4294967295u) {
                                                            let _e1420 = local_2[7u].member;
                                                            phi_4901_ = _e1420;
                                                        } else {
                                                            phi_4901_ = _e975;
                                                        }
                                                        let _e1422 = phi_4901_;
                                                        phi_4900_ = _e1422;
                                                        phi_4684_ = _e1413;
                                                    } else {
                                                        phi_4900_ = _e975;
                                                        phi_4684_ = _e973;
                                                    }
                                                    let _e1424 = phi_4900_;
                                                    let _e1426 = phi_4684_;
                                                    phi_4899_ = _e1424;
                                                    phi_4683_ = _e1426;
                                                } else {
                                                    phi_4899_ = _e975;
                                                    phi_4683_ = _e973;
                                                }
                                                let _e1428 = phi_4899_;
                                                let _e1430 = phi_4683_;
                                                phi_4898_ = _e1428;
                                                phi_4682_ = _e1430;
                                            } else {
                                                phi_4898_ = _e975;
                                                phi_4682_ = _e973;
                                            }
                                            let _e1432 = phi_4898_;
                                            let _e1434 = phi_4682_;
                                            continue;
                                            continuing {
                                                phi_4576_ = _e1434;
                                                phi_4566_ = _e1432;
                                                phi_2005_ = _e990;
                                                phi_4838_ = _e1432;
                                                phi_4681_ = _e1434;
                                                break if !(_e996);
                                            }
                                        }
                                        let _e1437 = phi_4838_;
                                        let _e1439 = phi_4681_;
                                        phi_4686_ = _e1439;
                                        if _e1439 {
                                            break;
                                        }
                                        phi_4803_ = _e1437;
                                        phi_4690_ = _e1439;
                                        phi_4123_ = _e524;
                                        phi_4124_ = false;
                                        phi_4125_ = _e528;
                                    } else {
                                        if (_e524.member_1 >= _e83) {
                                            phi_3722_ = type_54(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), type_51(type_25(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u), type_51(type_25(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u));
                                        } else {
                                            if (_e524.member_1 < _e83) {
                                            } else {
                                                phi_4686_ = true;
                                                break;
                                            }
                                            let _e541 = ((1u + (_e253 * 2u)) % 7u);
                                            if (_e541 < 7u) {
                                            } else {
                                                phi_4686_ = true;
                                                break;
                                            }
                                            let _e546 = global_5.member[_e524.member_1][_e541];
                                            let _e549 = ((1u + (_e252 * 2u)) % 7u);
                                            if (_e549 < 7u) {
                                            } else {
                                                phi_4686_ = true;
                                                break;
                                            }
                                            let _e554 = global_5.member[_e524.member_1][_e549];
                                            let _e557 = ((1u + (_e254 * 2u)) % 7u);
                                            if (_e557 < 7u) {
                                            } else {
                                                phi_4686_ = true;
                                                break;
                                            }
                                            let _e562 = global_5.member[_e524.member_1][_e557];
                                            let _e565 = (((_e253 + 1u) * 2u) % 7u);
                                            if (_e565 < 7u) {
                                            } else {
                                                phi_4686_ = true;
                                                break;
                                            }
                                            let _e570 = global_5.member[_e524.member_1][_e565];
                                            let _e573 = (((_e252 + 1u) * 2u) % 7u);
                                            if (_e573 < 7u) {
                                            } else {
                                                phi_4686_ = true;
                                                break;
                                            }
                                            let _e578 = global_5.member[_e524.member_1][_e573];
                                            let _e581 = (((_e254 + 1u) * 2u) % 7u);
                                            if (_e581 < 7u) {
                                            } else {
                                                phi_4686_ = true;
                                                break;
                                            }
                                            let _e586 = global_5.member[_e524.member_1][_e581];
                                            let _e609 = (bitcast<f32>((bitcast<u32>((_e524.member.member_1.x - _e524.member.member.x)) & 2139095040u)) * 0.0000009536743f);
                                            let _e610 = (bitcast<f32>((bitcast<u32>((_e524.member.member_1.y - _e524.member.member.y)) & 2139095040u)) * 0.0000009536743f);
                                            let _e611 = (bitcast<f32>((bitcast<u32>((_e524.member.member_1.z - _e524.member.member.z)) & 2139095040u)) * 0.0000009536743f);
                                            let _e613 = select(_e133, _e609, (_e609 > _e133));
                                            let _e615 = select(_e133, _e610, (_e610 > _e133));
                                            let _e617 = select(_e133, _e611, (_e611 > _e133));
                                            let _e642 = bitcast<u32>((f32(bitcast<i32>((_e546 & 2097151u))) * _e613));
                                            let _e647 = (bitcast<i32>((_e546 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e650 = bitcast<f32>((_e642 & bitcast<u32>(_e647)));
                                            let _e651 = bitcast<u32>((f32(bitcast<i32>((_e554 & 2097151u))) * _e615));
                                            let _e656 = (bitcast<i32>((_e554 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e659 = bitcast<f32>((_e651 & bitcast<u32>(_e656)));
                                            let _e660 = bitcast<u32>((f32(bitcast<i32>((_e562 & 2097151u))) * _e617));
                                            let _e665 = (bitcast<i32>((_e562 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e668 = bitcast<f32>((_e660 & bitcast<u32>(_e665)));
                                            let _e672 = bitcast<f32>((_e642 & bitcast<u32>(~(_e647))));
                                            let _e676 = bitcast<f32>((_e651 & bitcast<u32>(~(_e656))));
                                            let _e680 = bitcast<f32>((_e660 & bitcast<u32>(~(_e665))));
                                            let _e681 = bitcast<u32>((f32(bitcast<i32>((_e570 & 2097151u))) * _e613));
                                            let _e686 = (bitcast<i32>((_e570 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e689 = bitcast<f32>((_e681 & bitcast<u32>(_e686)));
                                            let _e690 = bitcast<u32>((f32(bitcast<i32>((_e578 & 2097151u))) * _e615));
                                            let _e695 = (bitcast<i32>((_e578 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e698 = bitcast<f32>((_e690 & bitcast<u32>(_e695)));
                                            let _e699 = bitcast<u32>((f32(bitcast<i32>((_e586 & 2097151u))) * _e617));
                                            let _e704 = (bitcast<i32>((_e586 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e707 = bitcast<f32>((_e699 & bitcast<u32>(_e704)));
                                            let _e711 = bitcast<f32>((_e681 & bitcast<u32>(~(_e686))));
                                            let _e715 = bitcast<f32>((_e690 & bitcast<u32>(~(_e695))));
                                            let _e719 = bitcast<f32>((_e699 & bitcast<u32>(~(_e704))));
                                            let _e749 = global_5.member[_e524.member_1][0u];
                                            let _e753 = global_5.member[_e524.member_1][2u];
                                            let _e757 = global_5.member[_e524.member_1][4u];
                                            let _e761 = global_5.member[_e524.member_1][6u];
                                            let _e773 = (((_e753 >> bitcast<u32>(22i)) | ((_e757 >> bitcast<u32>(22i)) << bitcast<u32>(10i))) | ((_e761 >> bitcast<u32>(22i)) << bitcast<u32>(20i)));
                                            let _e774 = (_e749 & 268435455u);
                                            let _e775 = (_e773 & 268435455u);
                                            let _e778 = ((_e749 >> bitcast<u32>(28u)) & 7u);
                                            let _e786 = ((_e749 >> bitcast<u32>(31i)) | (((_e773 >> bitcast<u32>(28u)) & 3u) << bitcast<u32>(1i)));
                                            let _e787 = (_e778 != 0u);
                                            if (_e778 == 0u) {
                                                phi_3684_ = _e774;
                                            } else {
                                                if (_e778 == 7u) {
                                                    phi_3683_ = 2147483648u;
                                                } else {
                                                    phi_3683_ = ((2147483648u | (_e778 << bitcast<u32>(28u))) | (_e775 & 268435455u));
                                                }
                                                let _e796 = phi_3683_;
                                                phi_3684_ = _e796;
                                            }
                                            let _e798 = phi_3684_;
                                            if _e787 {
                                                let _e799 = (_e778 != 7u);
                                                if _e799 {
                                                    phi_3694_ = (_e775 + _e778);
                                                } else {
                                                    phi_3694_ = u32();
                                                }
                                                let _e802 = phi_3694_;
                                                phi_3696_ = _e802;
                                                phi_3697_ = select(true, false, _e799);
                                            } else {
                                                phi_3696_ = u32();
                                                phi_3697_ = true;
                                            }
                                            let _e805 = phi_3696_;
                                            let _e807 = phi_3697_;
                                            if (_e786 == 0u) {
                                                phi_3718_ = (_e774 + select(0u, 1u, !(_e787)));
                                            } else {
                                                if (_e786 == 7u) {
                                                    phi_3717_ = 2147483648u;
                                                } else {
                                                    phi_3717_ = ((2147483648u | (_e786 << bitcast<u32>(28u))) | (select(_e805, _e775, _e807) & 268435455u));
                                                }
                                                let _e820 = phi_3717_;
                                                phi_3718_ = _e820;
                                            }
                                            let _e822 = phi_3718_;
                                            phi_3722_ = type_54(array<vec4<f32>, 3>(vec4<f32>((_e524.member.member.x + _e650), (_e524.member.member.x + _e672), (_e524.member.member_1.x - _e689), (_e524.member.member_1.x - _e711)), vec4<f32>((_e524.member.member.y + _e659), (_e524.member.member.y + _e676), (_e524.member.member_1.y - _e698), (_e524.member.member_1.y - _e715)), vec4<f32>((_e524.member.member.z + _e668), (_e524.member.member.z + _e680), (_e524.member.member_1.z - _e707), (_e524.member.member_1.z - _e719))), type_51(type_25((_e524.member.member + vec4<f32>(_e650, _e659, _e668, 0f)), (_e524.member.member_1 - vec4<f32>(_e689, _e698, _e707, 0f))), _e798), type_51(type_25((_e524.member.member + vec4<f32>(_e672, _e676, _e680, 0f)), (_e524.member.member_1 - vec4<f32>(_e711, _e715, _e719, 0f))), _e822));
                                        }
                                        let _e827 = phi_3722_;
                                        let _e838 = ((_e827.member[0].x - _e325) * _e330);
                                        let _e839 = ((_e827.member[0].y - _e325) * _e330);
                                        let _e840 = ((_e827.member[0].z - _e326) * _e330);
                                        let _e841 = ((_e827.member[0].w - _e326) * _e330);
                                        let _e851 = ((_e827.member[1].x - _e363) * _e368);
                                        let _e852 = ((_e827.member[1].y - _e363) * _e368);
                                        let _e853 = ((_e827.member[1].z - _e364) * _e368);
                                        let _e854 = ((_e827.member[1].w - _e364) * _e368);
                                        let _e864 = ((_e827.member[2].x - _e401) * _e406);
                                        let _e865 = ((_e827.member[2].y - _e401) * _e406);
                                        let _e866 = ((_e827.member[2].z - _e402) * _e406);
                                        let _e867 = ((_e827.member[2].w - _e402) * _e406);
                                        let _e869 = select(_e866, _e864, (_e864 < _e866));
                                        let _e871 = select(_e867, _e865, (_e865 < _e867));
                                        let _e873 = select(_e866, _e864, (_e864 > _e866));
                                        let _e875 = select(_e867, _e865, (_e865 > _e867));
                                        let _e877 = select(_e840, _e838, (_e838 < _e840));
                                        let _e879 = select(_e841, _e839, (_e839 < _e841));
                                        let _e881 = select(_e853, _e851, (_e851 < _e853));
                                        let _e883 = select(_e854, _e852, (_e852 < _e854));
                                        let _e885 = select(_e881, _e877, (_e877 > _e881));
                                        let _e887 = select(_e883, _e879, (_e879 > _e883));
                                        let _e889 = select(_e869, _e885, (_e885 > _e869));
                                        let _e891 = select(_e871, _e887, (_e887 > _e871));
                                        let _e893 = select(_e840, _e838, (_e838 > _e840));
                                        let _e895 = select(_e841, _e839, (_e839 > _e841));
                                        let _e897 = select(_e853, _e851, (_e851 > _e853));
                                        let _e899 = select(_e854, _e852, (_e852 > _e854));
                                        let _e901 = select(_e897, _e893, (_e893 < _e897));
                                        let _e903 = select(_e899, _e895, (_e895 < _e899));
                                        let _e908 = -(_e869);
                                        let _e909 = -(_e871);
                                        let _e916 = (select(_e873, _e901, (_e901 < _e873)) + (select(_e908, _e873, (_e873 > _e908)) * 0.0000019073523f));
                                        let _e917 = (select(_e875, _e903, (_e903 < _e875)) + (select(_e909, _e875, (_e875 > _e909)) * 0.0000019073523f));
                                        let _e919 = select(_e453, _e889, (_e889 > _e453));
                                        let _e921 = select(_e453, _e891, (_e891 > _e453));
                                        let _e926 = (_e919 <= select(_e496, _e916, (_e916 < _e496)));
                                        let _e927 = (_e921 <= select(_e496, _e917, (_e917 < _e496)));
                                        let _e928 = (_e919 <= _e921);
                                        if _e926 {
                                            if _e927 {
                                                if _e928 {
                                                    phi_4067_ = _e827.member_2;
                                                } else {
                                                    phi_4067_ = _e827.member_1;
                                                }
                                                let _e932 = phi_4067_;
                                                let _e933 = (_e528 % 128u);
                                                let _e934 = (_e933 < 128u);
                                                if _e934 {
                                                } else {
                                                    phi_4686_ = true;
                                                    break;
                                                }
                                                local_4[_e933] = type_51(type_25(_e932.member.member, _e932.member.member_1), _e932.member_1);
                                                if _e934 {
                                                } else {
                                                    phi_4686_ = true;
                                                    break;
                                                }
                                                local_3[_e933] = select(_e921, _e919, (_e919 > _e921));
                                                if _e928 {
                                                    phi_4100_ = _e827.member_1;
                                                } else {
                                                    phi_4100_ = _e827.member_2;
                                                }
                                                let _e949 = phi_4100_;
                                                phi_4101_ = _e949;
                                                phi_4102_ = (_e528 + 1u);
                                            } else {
                                                phi_4101_ = type_51();
                                                phi_4102_ = u32();
                                            }
                                            let _e951 = phi_4101_;
                                            let _e953 = phi_4102_;
                                            phi_4104_ = _e951;
                                            phi_4105_ = _e953;
                                            phi_4106_ = select(true, false, _e927);
                                        } else {
                                            phi_4104_ = type_51();
                                            phi_4105_ = u32();
                                            phi_4106_ = true;
                                        }
                                        let _e956 = phi_4104_;
                                        let _e958 = phi_4105_;
                                        let _e960 = phi_4106_;
                                        if _e960 {
                                            if _e926 {
                                                phi_4115_ = _e827.member_1;
                                            } else {
                                                phi_4115_ = _e827.member_2;
                                            }
                                            let _e964 = phi_4115_;
                                            phi_4120_ = _e964;
                                            phi_4121_ = select(_e927, true, _e926);
                                        } else {
                                            phi_4120_ = _e956;
                                            phi_4121_ = _e526;
                                        }
                                        let _e967 = phi_4120_;
                                        let _e969 = phi_4121_;
                                        phi_4803_ = _e496;
                                        phi_4690_ = _e494;
                                        phi_4123_ = _e967;
                                        phi_4124_ = _e969;
                                        phi_4125_ = select(_e958, _e528, _e960);
                                    }
                                    let _e1441 = phi_4803_;
                                    let _e1443 = phi_4690_;
                                    let _e1445 = phi_4123_;
                                    let _e1447 = phi_4124_;
                                    let _e1449 = phi_4125_;
                                    phi_4802_ = _e1441;
                                    phi_4689_ = _e1443;
                                    phi_4126_ = _e1445;
                                    phi_4127_ = (_e500 - 1u);
                                    phi_4128_ = _e1447;
                                    phi_4129_ = _e1449;
                                } else {
                                    phi_4802_ = _e496;
                                    phi_4689_ = _e494;
                                    phi_4126_ = _e524;
                                    phi_4127_ = _e500;
                                    phi_4128_ = _e526;
                                    phi_4129_ = _e528;
                                }
                                let _e1451 = phi_4802_;
                                let _e1453 = phi_4689_;
                                let _e1455 = phi_4126_;
                                let _e1457 = phi_4127_;
                                let _e1459 = phi_4128_;
                                let _e1461 = phi_4129_;
                                phi_4801_ = _e1451;
                                phi_4688_ = _e1453;
                                phi_4130_ = _e1455;
                                phi_4131_ = _e1457;
                                phi_4132_ = _e1459;
                                phi_4133_ = _e1461;
                            } else {
                                phi_4801_ = _e496;
                                phi_4688_ = _e494;
                                phi_4130_ = type_51();
                                phi_4131_ = u32();
                                phi_4132_ = bool();
                                phi_4133_ = u32();
                            }
                            let _e1463 = phi_4801_;
                            let _e1465 = phi_4688_;
                            let _e1467 = phi_4130_;
                            let _e1469 = phi_4131_;
                            let _e1471 = phi_4132_;
                            let _e1473 = phi_4133_;
                            phi_4800_ = _e1463;
                            phi_4687_ = _e1465;
                            phi_1930_ = _e1467;
                            phi_1933_ = _e1469;
                            phi_1935_ = _e1471;
                            phi_1937_ = _e1473;
                            phi_4134_ = _e508;
                        } else {
                            phi_4800_ = _e496;
                            phi_4687_ = _e494;
                            phi_1930_ = type_51();
                            phi_1933_ = u32();
                            phi_1935_ = bool();
                            phi_1937_ = u32();
                            phi_4134_ = false;
                        }
                        let _e1475 = phi_4800_;
                        let _e1477 = phi_4687_;
                        let _e1479 = phi_1930_;
                        let _e1481 = phi_1933_;
                        let _e1483 = phi_1935_;
                        let _e1485 = phi_1937_;
                        let _e1487 = phi_4134_;
                        continue;
                        continuing {
                            phi_4579_ = _e1477;
                            phi_4492_ = _e1475;
                            phi_1929_ = _e1479;
                            phi_1932_ = _e1481;
                            phi_1934_ = _e1483;
                            phi_1936_ = _e1485;
                            phi_4686_ = _e1477;
                            break if !(_e1487);
                        }
                    }
                    let _e1490 = phi_4686_;
                    if _e1490 {
                        break;
                    }
                    phi_4141_ = type_4(0u, 8u);
                    loop {
                        let _e1492 = phi_4141_;
                        if (_e1492.member < _e1492.member_1) {
                            phi_4142_ = type_4((_e1492.member + 1u), _e1492.member_1);
                            phi_4165_ = type_4(1u, _e1492.member);
                        } else {
                            phi_4142_ = _e1492;
                            phi_4165_ = type_4(0u, type_4().member_1);
                        }
                        let _e1505 = phi_4142_;
                        let _e1507 = phi_4165_;
                        let _e1511 = (bitcast<i32>(_e1507.member) != 0i);
                        if _e1511 {
                            let _e1512 = (_e1507.member_1 < 8u);
                            if _e1512 {
                            } else {
                                phi_4793_ = true;
                                break;
                            }
                            let _e1514 = local_2[_e1507.member_1];
                            if (_e1514.member_3 != 4294967295u) {
                                let _e1520 = -(_e420);
                                let _e1521 = (_e1520 / 3i);
                                let _e1528 = bitcast<f32>((bitcast<u32>((_e1521 + 127i)) << bitcast<u32>(23i)));
                                let _e1536 = (((_e1514.member * _e1528) * _e1528) * bitcast<f32>((bitcast<u32>(((_e1520 - (2i * _e1521)) + 127i)) << bitcast<u32>(23i))));
                                let _e1538 = select(340282350000000000000000000000000000000f, _e1536, (_e1536 < 340282350000000000000000000000000000000f));
                                phi_4231_ = type_21(select(-340282350000000000000000000000000000000f, _e1538, (_e1538 > -340282350000000000000000000000000000000f)), _e1514.member_1, _e1514.member_2, _e1514.member_3);
                            } else {
                                phi_4231_ = type_21(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                            }
                            let _e1543 = phi_4231_;
                            if _e1512 {
                            } else {
                                phi_4793_ = true;
                                break;
                            }
                            local_2[_e1507.member_1] = type_21(_e1543.member, _e1543.member_1, _e1543.member_2, _e1543.member_3);
                        }
                        continue;
                        continuing {
                            phi_4141_ = _e1505;
                            phi_4793_ = _e1490;
                            break if !(_e1511);
                        }
                    }
                    let _e1551 = phi_4793_;
                    if _e1551 {
                        break;
                    }
                    let _e1552 = local_2;
                    if _e141 {
                    } else {
                        break;
                    }
                    global_6.member[_e139] = array<type_21, 8>(type_21(_e1552[0].member, _e1552[0].member_1, _e1552[0].member_2, _e1552[0].member_3), type_21(_e1552[1].member, _e1552[1].member_1, _e1552[1].member_2, _e1552[1].member_3), type_21(_e1552[2].member, _e1552[2].member_1, _e1552[2].member_2, _e1552[2].member_3), type_21(_e1552[3].member, _e1552[3].member_1, _e1552[3].member_2, _e1552[3].member_3), type_21(_e1552[4].member, _e1552[4].member_1, _e1552[4].member_2, _e1552[4].member_3), type_21(_e1552[5].member, _e1552[5].member_1, _e1552[5].member_2, _e1552[5].member_3), type_21(_e1552[6].member, _e1552[6].member_1, _e1552[6].member_2, _e1552[6].member_3), type_21(_e1552[7].member, _e1552[7].member_1, _e1552[7].member_2, _e1552[7].member_3));
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn trace_nearest_q21_f32_(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
