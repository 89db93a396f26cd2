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

struct type_29 {
    member: array<type_22>,
}

struct type_31 {
    member: f32,
    member_1: bool,
}

struct type_33 {
    member: array<vec4<u32>, 2>,
}

struct type_35 {
    member: array<u32, 2>,
    member_1: array<u32, 2>,
    member_2: u32,
    member_3: u32,
}

struct type_37 {
    member: array<type_35>,
}

struct type_40 {
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
    member: type_40,
    member_1: u32,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_1: type_11;
@group(0) @binding(1) 
var<uniform> global_2: type_33;
@group(0) @binding(4) 
var<storage> global_3: type_29;
@group(0) @binding(5) 
var<storage, read_write> global_4: type_4;
@group(0) @binding(2) 
var<storage> global_5: type_37;
@group(0) @binding(3) 
var<storage> global_6: type_45;

fn function_() {
    var local: array<f32, 3>;
    var local_1: array<f32, 3>;
    var local_2: array<f32, 3>;
    var local_3: array<f32, 3>;
    var local_4: array<f32, 128>;
    var local_5: array<type_49, 128>;
    var local_6: array<f32, 3>;
    var local_7: array<f32, 3>;
    var local_8: array<f32, 3>;
    var local_9: array<f32, 3>;
    var local_10: array<u32, 3>;
    var local_11: array<u32, 3>;
    var local_12: array<u32, 3>;
    var local_13: array<array<f32, 3>, 3>;
    var local_14: array<u32, 3>;
    var local_15: array<f32, 3>;
    var local_16: array<f32, 3>;
    var phi_342_: i32;
    var phi_343_: i32;
    var phi_353_: bool;
    var phi_363_: u32;
    var phi_364_: u32;
    var phi_366_: bool;
    var phi_371_: u32;
    var phi_384_: i32;
    var phi_404_: i32;
    var phi_422_: f32;
    var phi_428_: f32;
    var phi_439_: f32;
    var phi_445_: f32;
    var phi_468_: f32;
    var phi_479_: f32;
    var phi_488_: f32;
    var phi_494_: f32;
    var phi_505_: f32;
    var phi_511_: f32;
    var phi_534_: f32;
    var phi_545_: f32;
    var phi_554_: f32;
    var phi_560_: f32;
    var phi_571_: f32;
    var phi_577_: f32;
    var phi_600_: f32;
    var phi_611_: f32;
    var phi_711_: f32;
    var phi_712_: f32;
    var phi_4715_: bool;
    var phi_2840_: type_31;
    var phi_2843_: type_49;
    var phi_2845_: u32;
    var phi_2847_: bool;
    var phi_2849_: u32;
    var phi_2860_: bool;
    var phi_2905_: type_49;
    var phi_2906_: bool;
    var phi_2907_: u32;
    var phi_3802_: type_35;
    var phi_3811_: type_7;
    var phi_3812_: type_7;
    var phi_3835_: type_7;
    var phi_4708_: bool;
    var phi_3965_: type_7;
    var phi_3966_: type_7;
    var phi_3989_: type_7;
    var phi_4768_: bool;
    var phi_4552_: type_49;
    var phi_4591_: type_49;
    var phi_4592_: type_49;
    var phi_4593_: u32;
    var phi_4595_: type_49;
    var phi_4596_: u32;
    var phi_4597_: bool;
    var phi_4604_: type_49;
    var phi_4609_: type_49;
    var phi_4610_: bool;
    var phi_4785_: bool;
    var phi_2926_: type_31;
    var phi_2929_: type_7;
    var phi_2930_: type_7;
    var phi_2952_: type_7;
    var phi_2994_: u32;
    var phi_3018_: type_43;
    var phi_4781_: bool;
    var phi_3029_: type_7;
    var phi_3030_: type_7;
    var phi_3053_: type_7;
    var phi_3063_: type_7;
    var phi_3064_: type_7;
    var phi_3087_: type_7;
    var phi_4776_: bool;
    var phi_4789_: bool;
    var phi_4788_: bool;
    var phi_3650_: vec3<f32>;
    var phi_3651_: vec3<f32>;
    var phi_3682_: bool;
    var phi_3691_: vec3<f32>;
    var phi_3731_: type_21;
    var phi_3733_: type_21;
    var phi_3734_: bool;
    var phi_3738_: type_21;
    var phi_3739_: type_21;
    var phi_3740_: type_21;
    var phi_3741_: bool;
    var phi_3745_: type_21;
    var phi_3746_: bool;
    var phi_3750_: type_21;
    var phi_3751_: bool;
    var phi_3755_: type_21;
    var phi_3766_: type_31;
    var phi_3767_: type_31;
    var phi_4791_: bool;
    var phi_2927_: type_31;
    var phi_4790_: bool;
    var local_17: type_31;
    var phi_4850_: bool;
    var phi_4612_: type_31;
    var phi_4613_: type_49;
    var phi_4614_: bool;
    var phi_4615_: u32;
    var phi_4849_: bool;
    var phi_4616_: type_31;
    var phi_4617_: type_49;
    var phi_4618_: u32;
    var phi_4619_: bool;
    var phi_4620_: u32;
    var phi_4848_: bool;
    var phi_4621_: type_31;
    var phi_4622_: type_49;
    var phi_4623_: u32;
    var phi_4624_: bool;
    var phi_4625_: u32;
    var phi_4847_: bool;
    var phi_2841_: type_31;
    var phi_2844_: type_49;
    var phi_2846_: u32;
    var phi_2848_: bool;
    var phi_2850_: u32;
    var phi_4626_: bool;
    var phi_4846_: bool;
    var local_18: type_31;
    var local_19: type_31;

    switch bitcast<i32>(0u) {
        default: {
            let _e83 = global;
            let _e86 = arrayLength((&global_5.member));
            let _e97 = global_2.member[0u][0u];
            let _e101 = global_2.member[0u][1u];
            let _e105 = global_2.member[0u][2u];
            let _e109 = global_2.member[1u][0u];
            let _e113 = global_2.member[1u][1u];
            let _e117 = global_2.member[1u][2u];
            let _e121 = global_2.member[1u][3u];
            let _e124 = global_1.member[0u];
            let _e125 = bitcast<i32>(_e124);
            let _e135 = (_e83.x + (_e83.y * 2097152u));
            let _e136 = (_e135 < arrayLength((&global_3.member)));
            if _e136 {
                let _e137 = (_e135 < arrayLength((&global_4.member)));
                if _e137 {
                    if _e136 {
                    } else {
                        break;
                    }
                    let _e145 = global_3.member[_e135].member_2[0u];
                    let _e147 = (bitcast<u32>(_e145) & 2147483647u);
                    let _e152 = global_3.member[_e135].member_2[1u];
                    let _e154 = (bitcast<u32>(_e152) & 2147483647u);
                    let _e159 = global_3.member[_e135].member_2[2u];
                    let _e161 = (bitcast<u32>(_e159) & 2147483647u);
                    let _e166 = global_3.member[_e135].member[0u];
                    let _e168 = (bitcast<u32>(_e166) & 2147483647u);
                    let _e173 = global_3.member[_e135].member[1u];
                    let _e175 = (bitcast<u32>(_e173) & 2147483647u);
                    let _e180 = global_3.member[_e135].member[2u];
                    let _e182 = (bitcast<u32>(_e180) & 2147483647u);
                    let _e184 = select(_e154, _e147, (_e154 < _e147));
                    let _e186 = select(_e161, _e184, (_e161 < _e184));
                    let _e188 = select(_e168, _e186, (_e168 < _e186));
                    let _e190 = select(_e175, _e188, (_e175 < _e188));
                    let _e192 = select(_e182, _e190, (_e182 < _e190));
                    let _e196 = global_3.member[_e135].member_1;
                    let _e198 = (bitcast<u32>(_e196) & 2147483647u);
                    let _e205 = global_3.member[_e135].member_3;
                    let _e211 = (((select(_e198, _e192, (_e198 < _e192)) < 2139095040u) && ((bitcast<u32>(_e205) & 2147483647u) <= 2139095040u)) && (_e186 > 0u));
                    if _e211 {
                        let _e214 = (bitcast<u32>(bitcast<f32>(_e186)) & 2147483647u);
                        if (_e214 >= 8388608u) {
                            phi_342_ = (bitcast<i32>((_e214 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_342_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e214)), 32u, (_e214 == 0u))));
                        }
                        let _e228 = phi_342_;
                        phi_343_ = _e228;
                    } else {
                        phi_343_ = 0i;
                    }
                    let _e230 = phi_343_;
                    let _e231 = (_e147 == _e186);
                    if _e231 {
                        phi_353_ = true;
                    } else {
                        phi_353_ = (_e154 == _e186);
                    }
                    let _e234 = phi_353_;
                    let _e235 = select(1u, 0u, _e231);
                    if _e234 {
                        let _e236 = (_e235 + 1u);
                        phi_363_ = _e236;
                        phi_364_ = _e236;
                        phi_366_ = select(true, false, (_e236 == 2u));
                    } else {
                        phi_363_ = u32();
                        phi_364_ = 0u;
                        phi_366_ = true;
                    }
                    let _e240 = phi_363_;
                    let _e242 = phi_364_;
                    let _e244 = phi_366_;
                    if _e244 {
                        phi_371_ = (_e242 + 1u);
                    } else {
                        phi_371_ = 0u;
                    }
                    let _e248 = phi_371_;
                    let _e249 = select(_e240, _e242, _e244);
                    let _e250 = select(_e235, select(2u, _e235, _e234), _e244);
                    if (_e125 < -126i) {
                        phi_384_ = -126i;
                    } else {
                        phi_384_ = select(_e125, 127i, (_e125 > 127i));
                    }
                    let _e255 = phi_384_;
                    let _e260 = bitcast<f32>((bitcast<u32>((_e255 + 127i)) << bitcast<u32>(23i)));
                    let _e266 = bitcast<f32>((bitcast<u32>(((_e125 - _e255) + 127i)) << bitcast<u32>(23i)));
                    let _e267 = -(_e230);
                    if (_e267 < -126i) {
                        phi_404_ = -126i;
                    } else {
                        phi_404_ = select(_e267, 127i, (_e267 > 127i));
                    }
                    let _e272 = phi_404_;
                    let _e277 = bitcast<f32>((bitcast<u32>((_e272 + 127i)) << bitcast<u32>(23i)));
                    let _e283 = bitcast<f32>((bitcast<u32>(((_e267 - _e272) + 127i)) << bitcast<u32>(23i)));
                    let _e287 = global_3.member[_e135].member;
                    let _e288 = (_e249 == 0u);
                    if _e288 {
                        phi_422_ = _e287[0];
                    } else {
                        phi_422_ = _e287[1];
                    }
                    let _e292 = phi_422_;
                    let _e293 = (_e249 == 2u);
                    if _e293 {
                        phi_428_ = _e287[2];
                    } else {
                        phi_428_ = _e292;
                    }
                    let _e296 = phi_428_;
                    let _e298 = ((_e296 * _e260) * _e266);
                    let _e299 = global_3.member[_e135].member_2;
                    if _e288 {
                        phi_439_ = _e299[0];
                    } else {
                        phi_439_ = _e299[1];
                    }
                    let _e303 = phi_439_;
                    if _e293 {
                        phi_445_ = _e299[2];
                    } else {
                        phi_445_ = _e303;
                    }
                    let _e306 = phi_445_;
                    let _e308 = ((_e306 * _e277) * _e283);
                    let _e312 = (bitcast<f32>((bitcast<u32>(_e308) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e312 {
                        let _e316 = (bitcast<f32>((bitcast<u32>(_e298) & 2147483647u)) * 0.00000011920929f);
                        phi_468_ = select(0.00000000000011368684f, _e316, (_e316 > 0.00000000000011368684f));
                    } else {
                        phi_468_ = 0f;
                    }
                    let _e320 = phi_468_;
                    let _e321 = (_e298 + _e320);
                    let _e322 = (_e298 - _e320);
                    let _e323 = select(_e308, 0f, _e312);
                    if _e312 {
                        phi_479_ = 38685626000000000000000000f;
                    } else {
                        phi_479_ = (1f / _e308);
                    }
                    let _e326 = phi_479_;
                    let _e327 = (_e248 == 0u);
                    if _e327 {
                        phi_488_ = _e287[0];
                    } else {
                        phi_488_ = _e287[1];
                    }
                    let _e331 = phi_488_;
                    let _e332 = (_e248 == 2u);
                    if _e332 {
                        phi_494_ = _e287[2];
                    } else {
                        phi_494_ = _e331;
                    }
                    let _e335 = phi_494_;
                    let _e337 = ((_e335 * _e260) * _e266);
                    if _e327 {
                        phi_505_ = _e299[0];
                    } else {
                        phi_505_ = _e299[1];
                    }
                    let _e341 = phi_505_;
                    if _e332 {
                        phi_511_ = _e299[2];
                    } else {
                        phi_511_ = _e341;
                    }
                    let _e344 = phi_511_;
                    let _e346 = ((_e344 * _e277) * _e283);
                    let _e350 = (bitcast<f32>((bitcast<u32>(_e346) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e350 {
                        let _e354 = (bitcast<f32>((bitcast<u32>(_e337) & 2147483647u)) * 0.00000011920929f);
                        phi_534_ = select(0.00000000000011368684f, _e354, (_e354 > 0.00000000000011368684f));
                    } else {
                        phi_534_ = 0f;
                    }
                    let _e358 = phi_534_;
                    let _e359 = (_e337 + _e358);
                    let _e360 = (_e337 - _e358);
                    let _e361 = select(_e346, 0f, _e350);
                    if _e350 {
                        phi_545_ = 38685626000000000000000000f;
                    } else {
                        phi_545_ = (1f / _e346);
                    }
                    let _e364 = phi_545_;
                    let _e365 = (_e250 == 0u);
                    if _e365 {
                        phi_554_ = _e287[0];
                    } else {
                        phi_554_ = _e287[1];
                    }
                    let _e369 = phi_554_;
                    let _e370 = (_e250 == 2u);
                    if _e370 {
                        phi_560_ = _e287[2];
                    } else {
                        phi_560_ = _e369;
                    }
                    let _e373 = phi_560_;
                    let _e375 = ((_e373 * _e260) * _e266);
                    if _e365 {
                        phi_571_ = _e299[0];
                    } else {
                        phi_571_ = _e299[1];
                    }
                    let _e379 = phi_571_;
                    if _e370 {
                        phi_577_ = _e299[2];
                    } else {
                        phi_577_ = _e379;
                    }
                    let _e382 = phi_577_;
                    let _e384 = ((_e382 * _e277) * _e283);
                    let _e388 = (bitcast<f32>((bitcast<u32>(_e384) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e388 {
                        let _e392 = (bitcast<f32>((bitcast<u32>(_e375) & 2147483647u)) * 0.00000011920929f);
                        phi_600_ = select(0.00000000000011368684f, _e392, (_e392 > 0.00000000000011368684f));
                    } else {
                        phi_600_ = 0f;
                    }
                    let _e396 = phi_600_;
                    let _e397 = (_e375 + _e396);
                    let _e398 = (_e375 - _e396);
                    let _e399 = select(_e384, 0f, _e388);
                    if _e388 {
                        phi_611_ = 38685626000000000000000000f;
                    } else {
                        phi_611_ = (1f / _e384);
                    }
                    let _e402 = phi_611_;
                    let _e405 = bitcast<f32>((bitcast<u32>(_e298) & 2147483647u));
                    let _e408 = bitcast<f32>((bitcast<u32>(_e337) & 2147483647u));
                    let _e410 = select(_e408, _e405, (_e405 > _e408));
                    let _e413 = bitcast<f32>((bitcast<u32>(_e375) & 2147483647u));
                    let _e416 = (_e125 + _e230);
                    if (_e211 && (select(_e413, _e410, (_e410 > _e413)) <= 1099511600000f)) {
                        let _e419 = (_e416 / 3i);
                        let _e426 = bitcast<f32>((bitcast<u32>((_e419 + 127i)) << bitcast<u32>(23i)));
                        let _e433 = bitcast<f32>((bitcast<u32>(((_e416 - (2i * _e419)) + 127i)) << bitcast<u32>(23i)));
                        let _e434 = (((_e196 * _e426) * _e426) * _e433);
                        let _e436 = select(340282350000000000000000000000000000000f, _e434, (_e434 < 340282350000000000000000000000000000000f));
                        let _e441 = (((_e205 * _e426) * _e426) * _e433);
                        let _e443 = select(340282350000000000000000000000000000000f, _e441, (_e441 < 340282350000000000000000000000000000000f));
                        phi_711_ = select(-340282350000000000000000000000000000000f, _e443, (_e443 > -340282350000000000000000000000000000000f));
                        phi_712_ = select(-340282350000000000000000000000000000000f, _e436, (_e436 > -340282350000000000000000000000000000000f));
                    } else {
                        phi_711_ = 0f;
                        phi_712_ = 1f;
                    }
                    let _e447 = phi_711_;
                    let _e449 = phi_712_;
                    local_5 = array<type_49, 128>(type_49(type_40(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_49(type_40(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_49(type_40(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_49(type_40(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_49(type_40(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_49(type_40(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_49(type_40(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_49(type_40(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_49(type_40(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_49(type_40(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_49(type_40(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_49(type_40(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_49(type_40(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_49(type_40(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_49(type_40(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_49(type_40(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_49(type_40(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_49(type_40(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_49(type_40(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_49(type_40(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_49(type_40(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_49(type_40(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_49(type_40(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_49(type_40(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_49(type_40(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_49(type_40(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_49(type_40(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_49(type_40(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_49(type_40(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_49(type_40(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_49(type_40(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_49(type_40(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_49(type_40(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_49(type_40(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_49(type_40(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_49(type_40(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_49(type_40(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_49(type_40(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_49(type_40(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_49(type_40(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_49(type_40(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_49(type_40(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_49(type_40(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_49(type_40(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_49(type_40(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_49(type_40(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_49(type_40(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_49(type_40(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_49(type_40(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_49(type_40(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_49(type_40(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_49(type_40(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_49(type_40(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_49(type_40(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_49(type_40(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_49(type_40(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_49(type_40(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_49(type_40(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_49(type_40(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_49(type_40(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_49(type_40(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_49(type_40(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_49(type_40(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_49(type_40(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_49(type_40(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_49(type_40(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_49(type_40(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_49(type_40(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_49(type_40(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_49(type_40(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_49(type_40(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_49(type_40(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_49(type_40(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_49(type_40(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_49(type_40(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_49(type_40(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_49(type_40(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_49(type_40(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_49(type_40(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_49(type_40(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_49(type_40(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_49(type_40(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_49(type_40(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_49(type_40(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_49(type_40(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_49(type_40(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_49(type_40(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_49(type_40(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_49(type_40(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_49(type_40(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_49(type_40(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_49(type_40(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_49(type_40(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_49(type_40(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_49(type_40(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_49(type_40(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_49(type_40(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_49(type_40(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_49(type_40(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_49(type_40(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_49(type_40(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_49(type_40(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_49(type_40(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_49(type_40(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_49(type_40(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_49(type_40(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_49(type_40(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_49(type_40(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_49(type_40(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_49(type_40(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_49(type_40(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_49(type_40(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_49(type_40(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_49(type_40(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_49(type_40(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_49(type_40(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_49(type_40(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_49(type_40(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_49(type_40(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_49(type_40(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_49(type_40(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_49(type_40(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_49(type_40(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_49(type_40(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_49(type_40(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_49(type_40(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_49(type_40(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_49(type_40(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u));
                    local_4 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_16 = array<f32, 3>(bitcast<f32>(_e97), bitcast<f32>(_e101), bitcast<f32>(_e105));
                    let _e454 = (_e249 % 3u);
                    let _e455 = (_e454 < 3u);
                    if _e455 {
                    } else {
                        break;
                    }
                    let _e457 = local_16[_e454];
                    let _e458 = (_e248 % 3u);
                    let _e459 = (_e458 < 3u);
                    if _e459 {
                    } else {
                        break;
                    }
                    let _e461 = local_16[_e458];
                    let _e462 = (_e250 % 3u);
                    let _e463 = (_e462 < 3u);
                    if _e463 {
                    } else {
                        break;
                    }
                    let _e465 = local_16[_e462];
                    local_15 = array<f32, 3>(bitcast<f32>(_e109), bitcast<f32>(_e113), bitcast<f32>(_e117));
                    if _e455 {
                    } else {
                        break;
                    }
                    let _e469 = local_15[_e454];
                    if _e459 {
                    } else {
                        break;
                    }
                    let _e471 = local_15[_e458];
                    if _e463 {
                    } else {
                        break;
                    }
                    let _e473 = local_15[_e462];
                    phi_4715_ = false;
                    phi_2840_ = type_31(_e447, false);
                    phi_2843_ = type_49(type_40(array<f32, 3>(_e457, _e461, _e465), array<f32, 3>(_e469, _e471, _e473)), select(0u, 2147483648u, (_e86 == 0u)));
                    phi_2845_ = ((3u * _e86) + 1u);
                    phi_2847_ = (_e449 <= _e447);
                    phi_2849_ = 0u;
                    loop {
                        let _e481 = phi_4715_;
                        let _e483 = phi_2840_;
                        let _e485 = phi_2843_;
                        let _e487 = phi_2845_;
                        let _e489 = phi_2847_;
                        let _e491 = phi_2849_;
                        local_18 = _e483;
                        if _e489 {
                            phi_2860_ = true;
                        } else {
                            phi_2860_ = (_e491 > 0u);
                        }
                        let _e494 = phi_2860_;
                        if _e494 {
                            let _e495 = (_e487 > 0u);
                            if _e495 {
                                if _e489 {
                                    phi_2905_ = _e485;
                                    phi_2906_ = _e489;
                                    phi_2907_ = _e491;
                                } else {
                                    let _e496 = (_e491 - 1u);
                                    let _e497 = (_e496 % 128u);
                                    let _e498 = (_e497 < 128u);
                                    if _e498 {
                                    } else {
                                        phi_4846_ = true;
                                        break;
                                    }
                                    let _e500 = local_5[_e497];
                                    if _e498 {
                                    } else {
                                        phi_4846_ = true;
                                        break;
                                    }
                                    let _e516 = local_4[_e497];
                                    phi_2905_ = type_49(type_40(array<f32, 3>(_e500.member.member[0], _e500.member.member[1], _e500.member.member[2]), array<f32, 3>(_e500.member.member_1[0], _e500.member.member_1[1], _e500.member.member_1[2])), _e500.member_1);
                                    phi_2906_ = (_e516 <= _e483.member);
                                    phi_2907_ = _e496;
                                }
                                let _e520 = phi_2905_;
                                let _e522 = phi_2906_;
                                let _e524 = phi_2907_;
                                if _e522 {
                                    if ((_e520.member_1 & 2147483648u) != 0u) {
                                        phi_4785_ = _e481;
                                        phi_2926_ = _e483;
                                        phi_2929_ = type_7(0u, ((_e520.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e846 = phi_4785_;
                                            let _e848 = phi_2926_;
                                            let _e850 = phi_2929_;
                                            local_17 = _e848;
                                            local_19 = _e848;
                                            if (_e850.member < _e850.member_1) {
                                                phi_2930_ = type_7((_e850.member + 1u), _e850.member_1);
                                                phi_2952_ = type_7(1u, _e850.member);
                                            } else {
                                                phi_2930_ = _e850;
                                                phi_2952_ = type_7(0u, type_7().member_1);
                                            }
                                            let _e863 = phi_2930_;
                                            let _e865 = phi_2952_;
                                            let _e869 = (bitcast<i32>(_e865.member) != 0i);
                                            if _e869 {
                                                local_1 = array<f32, 3>(_e520.member.member[0], _e520.member.member[1], _e520.member.member[2]);
                                                local = array<f32, 3>(_e520.member.member_1[0], _e520.member.member_1[1], _e520.member.member_1[2]);
                                                let _e880 = ((_e520.member_1 & 268435455u) + _e865.member_1);
                                                let _e881 = (_e880 < arrayLength((&global_6.member)));
                                                if _e881 {
                                                    if _e881 {
                                                    } else {
                                                        phi_4790_ = true;
                                                        break;
                                                    }
                                                    let _e884 = global_6.member[_e880].member_1;
                                                    phi_2994_ = _e884;
                                                } else {
                                                    phi_2994_ = 4294967295u;
                                                }
                                                let _e886 = phi_2994_;
                                                local_12 = array<u32, 3>(_e249, _e248, _e250);
                                                if _e881 {
                                                    if _e881 {
                                                    } else {
                                                        phi_4790_ = true;
                                                        break;
                                                    }
                                                    let _e889 = global_6.member[_e880];
                                                    phi_3018_ = _e889;
                                                } else {
                                                    phi_3018_ = type_43(array<u32, 3>(0u, 0u, 0u), 4294967295u);
                                                }
                                                let _e891 = phi_3018_;
                                                local_14 = array<u32, 3>(_e891.member[0], _e891.member[1], _e891.member[2]);
                                                local_13[0u] = array<f32, 3>(0f, 0f, 0f);
                                                local_13[1u] = array<f32, 3>(0f, 0f, 0f);
                                                local_13[2u] = array<f32, 3>(0f, 0f, 0f);
                                                phi_4781_ = _e846;
                                                phi_3029_ = type_7(0u, 3u);
                                                loop {
                                                    let _e901 = phi_4781_;
                                                    let _e903 = phi_3029_;
                                                    if (_e903.member < _e903.member_1) {
                                                        phi_3030_ = type_7((_e903.member + 1u), _e903.member_1);
                                                        phi_3053_ = type_7(1u, _e903.member);
                                                    } else {
                                                        phi_3030_ = _e903;
                                                        phi_3053_ = type_7(0u, type_7().member_1);
                                                    }
                                                    let _e916 = phi_3030_;
                                                    let _e918 = phi_3053_;
                                                    let _e922 = (bitcast<i32>(_e918.member) != 0i);
                                                    if _e922 {
                                                        phi_3063_ = type_7(0u, 3u);
                                                        loop {
                                                            let _e924 = phi_3063_;
                                                            if (_e924.member < _e924.member_1) {
                                                                phi_3064_ = type_7((_e924.member + 1u), _e924.member_1);
                                                                phi_3087_ = type_7(1u, _e924.member);
                                                            } else {
                                                                phi_3064_ = _e924;
                                                                phi_3087_ = type_7(0u, type_7().member_1);
                                                            }
                                                            let _e937 = phi_3064_;
                                                            let _e939 = phi_3087_;
                                                            let _e943 = (bitcast<i32>(_e939.member) != 0i);
                                                            if _e943 {
                                                                let _e944 = (_e918.member_1 < 3u);
                                                                if _e944 {
                                                                } else {
                                                                    phi_4776_ = true;
                                                                    break;
                                                                }
                                                                let _e946 = local_14[_e918.member_1];
                                                                let _e947 = (_e939.member_1 < 3u);
                                                                if _e947 {
                                                                } else {
                                                                    phi_4776_ = true;
                                                                    break;
                                                                }
                                                                let _e949 = local_12[_e939.member_1];
                                                                let _e954 = ((_e946 >> bitcast<u32>(((10u * _e949) & 31u))) & 1023u);
                                                                if _e947 {
                                                                } else {
                                                                    phi_4776_ = true;
                                                                    break;
                                                                }
                                                                let _e956 = local_1[_e939.member_1];
                                                                if _e947 {
                                                                } else {
                                                                    phi_4776_ = true;
                                                                    break;
                                                                }
                                                                let _e958 = local[_e939.member_1];
                                                                let _e969 = (_e956 + bitcast<f32>((bitcast<u32>((f32(_e954) * bitcast<f32>((bitcast<u32>(((_e958 - _e956) * 0.0009775171f)) ^ _e121)))) ^ _e121)));
                                                                if _e944 {
                                                                } else {
                                                                    phi_4776_ = true;
                                                                    break;
                                                                }
                                                                if _e947 {
                                                                } else {
                                                                    phi_4776_ = true;
                                                                    break;
                                                                }
                                                                local_13[_e918.member_1][_e939.member_1] = select(select(_e958, _e969, (_e969 < _e958)), _e958, (_e954 == 1023u));
                                                            }
                                                            continue;
                                                            continuing {
                                                                phi_3063_ = _e937;
                                                                phi_4776_ = _e901;
                                                                break if !(_e943);
                                                            }
                                                        }
                                                        let _e978 = phi_4776_;
                                                        phi_4788_ = _e978;
                                                        if _e978 {
                                                            break;
                                                        }
                                                        phi_4789_ = _e978;
                                                    } else {
                                                        phi_4789_ = _e901;
                                                    }
                                                    let _e980 = phi_4789_;
                                                    continue;
                                                    continuing {
                                                        phi_4781_ = _e980;
                                                        phi_3029_ = _e916;
                                                        phi_4788_ = _e980;
                                                        break if !(_e922);
                                                    }
                                                }
                                                let _e983 = phi_4788_;
                                                phi_4790_ = _e983;
                                                if _e983 {
                                                    break;
                                                }
                                                let _e984 = local_13;
                                                let _e1000 = (_e984[0][2] - _e375);
                                                let _e1003 = (((_e984[0][0] - _e298) * _e399) - (_e1000 * _e323));
                                                let _e1006 = (((_e984[0][1] - _e337) * _e399) - (_e1000 * _e361));
                                                let _e1009 = (_e984[1][2] - _e375);
                                                let _e1012 = (((_e984[1][0] - _e298) * _e399) - (_e1009 * _e323));
                                                let _e1015 = (((_e984[1][1] - _e337) * _e399) - (_e1009 * _e361));
                                                let _e1018 = (_e984[2][2] - _e375);
                                                let _e1021 = (((_e984[2][0] - _e298) * _e399) - (_e1018 * _e323));
                                                let _e1024 = (((_e984[2][1] - _e337) * _e399) - (_e1018 * _e361));
                                                let _e1025 = (_e1021 * _e1015);
                                                let _e1026 = (_e1024 * _e1012);
                                                let _e1027 = (_e1003 * _e1024);
                                                let _e1028 = (_e1006 * _e1021);
                                                let _e1029 = (_e1012 * _e1006);
                                                let _e1030 = (_e1015 * _e1003);
                                                let _e1035 = (((_e1025 >= _e1026) && (_e1027 >= _e1028)) && (_e1029 >= _e1030));
                                                if (_e1035 || (((_e1025 <= _e1026) && (_e1027 <= _e1028)) && (_e1029 <= _e1030))) {
                                                    let _e1042 = select(-1f, 1f, _e1035);
                                                    let _e1044 = ((_e1025 - _e1026) * _e1042);
                                                    let _e1046 = select(0f, _e1044, (_e1044 > 0f));
                                                    let _e1048 = ((_e1027 - _e1028) * _e1042);
                                                    let _e1050 = select(0f, _e1048, (_e1048 > 0f));
                                                    let _e1052 = ((_e1029 - _e1030) * _e1042);
                                                    let _e1054 = select(0f, _e1052, (_e1052 > 0f));
                                                    let _e1056 = ((_e1046 + _e1050) + _e1054);
                                                    if (_e1056 < 0.000000000000000000000000000000000000011754944f) {
                                                        phi_3745_ = type_21();
                                                        phi_3746_ = true;
                                                    } else {
                                                        let _e1059 = select(_e984[1][0], _e984[0][0], (_e984[0][0] < _e984[1][0]));
                                                        let _e1063 = select(_e984[1][0], _e984[0][0], (_e984[0][0] > _e984[1][0]));
                                                        let _e1067 = select(_e984[1][1], _e984[0][1], (_e984[0][1] < _e984[1][1]));
                                                        let _e1071 = select(_e984[1][1], _e984[0][1], (_e984[0][1] > _e984[1][1]));
                                                        let _e1075 = select(_e984[1][2], _e984[0][2], (_e984[0][2] < _e984[1][2]));
                                                        let _e1079 = select(_e984[1][2], _e984[0][2], (_e984[0][2] > _e984[1][2]));
                                                        let _e1084 = ((select(_e984[2][0], _e1059, (_e1059 < _e984[2][0])) - _e321) * _e326);
                                                        let _e1085 = ((select(_e984[2][0], _e1063, (_e1063 > _e984[2][0])) - _e322) * _e326);
                                                        let _e1088 = ((select(_e984[2][1], _e1067, (_e1067 < _e984[2][1])) - _e359) * _e364);
                                                        let _e1089 = ((select(_e984[2][1], _e1071, (_e1071 > _e984[2][1])) - _e360) * _e364);
                                                        let _e1092 = ((select(_e984[2][2], _e1075, (_e1075 < _e984[2][2])) - _e397) * _e402);
                                                        let _e1093 = ((select(_e984[2][2], _e1079, (_e1079 > _e984[2][2])) - _e398) * _e402);
                                                        let _e1095 = select(_e1093, _e1092, (_e1092 < _e1093));
                                                        let _e1097 = select(_e1093, _e1092, (_e1092 > _e1093));
                                                        let _e1099 = select(_e1085, _e1084, (_e1084 < _e1085));
                                                        let _e1101 = select(_e1089, _e1088, (_e1088 < _e1089));
                                                        let _e1103 = select(_e1101, _e1099, (_e1099 > _e1101));
                                                        let _e1105 = select(_e1095, _e1103, (_e1103 > _e1095));
                                                        let _e1107 = select(_e1085, _e1084, (_e1084 > _e1085));
                                                        let _e1109 = select(_e1089, _e1088, (_e1088 > _e1089));
                                                        let _e1111 = select(_e1109, _e1107, (_e1107 < _e1109));
                                                        let _e1113 = select(_e1097, _e1111, (_e1111 < _e1097));
                                                        let _e1114 = -(_e1095);
                                                        let _e1120 = select(_e449, _e1105, (_e1105 > _e449));
                                                        if (_e1120 > (_e1113 + (select(_e1114, _e1097, (_e1097 > _e1114)) * 0.0000019073523f))) {
                                                            phi_3740_ = type_21();
                                                            phi_3741_ = true;
                                                        } else {
                                                            let _e1122 = (_e1120 > _e848.member);
                                                            if _e1122 {
                                                                phi_3739_ = type_21();
                                                            } else {
                                                                let _e1126 = (_e984[1][0] - _e984[0][0]);
                                                                let _e1127 = (_e984[1][1] - _e984[0][1]);
                                                                let _e1128 = (_e984[1][2] - _e984[0][2]);
                                                                let _e1129 = vec3<f32>(_e1126, _e1127, _e1128);
                                                                let _e1130 = (_e984[2][0] - _e984[1][0]);
                                                                let _e1131 = (_e984[2][1] - _e984[1][1]);
                                                                let _e1132 = (_e984[2][2] - _e984[1][2]);
                                                                let _e1133 = vec3<f32>(_e1130, _e1131, _e1132);
                                                                let _e1134 = (_e984[0][0] - _e984[2][0]);
                                                                let _e1135 = (_e984[0][1] - _e984[2][1]);
                                                                let _e1136 = (_e984[0][2] - _e984[2][2]);
                                                                let _e1137 = vec3<f32>(_e1134, _e1135, _e1136);
                                                                let _e1140 = bitcast<f32>((bitcast<u32>(_e1126) & 2147483647u));
                                                                let _e1143 = bitcast<f32>((bitcast<u32>(_e1127) & 2147483647u));
                                                                let _e1145 = select(_e1143, _e1140, (_e1140 > _e1143));
                                                                let _e1148 = bitcast<f32>((bitcast<u32>(_e1128) & 2147483647u));
                                                                let _e1150 = select(_e1148, _e1145, (_e1145 > _e1148));
                                                                let _e1153 = bitcast<f32>((bitcast<u32>(_e1130) & 2147483647u));
                                                                let _e1156 = bitcast<f32>((bitcast<u32>(_e1131) & 2147483647u));
                                                                let _e1158 = select(_e1156, _e1153, (_e1153 > _e1156));
                                                                let _e1161 = bitcast<f32>((bitcast<u32>(_e1132) & 2147483647u));
                                                                let _e1163 = select(_e1161, _e1158, (_e1158 > _e1161));
                                                                let _e1166 = bitcast<f32>((bitcast<u32>(_e1134) & 2147483647u));
                                                                let _e1169 = bitcast<f32>((bitcast<u32>(_e1135) & 2147483647u));
                                                                let _e1171 = select(_e1169, _e1166, (_e1166 > _e1169));
                                                                let _e1174 = bitcast<f32>((bitcast<u32>(_e1136) & 2147483647u));
                                                                let _e1176 = select(_e1174, _e1171, (_e1171 > _e1174));
                                                                let _e1178 = select(_e1163, _e1150, (_e1150 > _e1163));
                                                                let _e1180 = select(_e1176, _e1178, (_e1178 > _e1176));
                                                                if (_e1150 == _e1180) {
                                                                    phi_3650_ = _e1133;
                                                                    phi_3651_ = _e1137;
                                                                } else {
                                                                    let _e1183 = vec3((_e1163 == _e1180));
                                                                    phi_3650_ = select(_e1129, _e1137, _e1183);
                                                                    phi_3651_ = select(_e1133, _e1129, _e1183);
                                                                }
                                                                let _e1187 = phi_3650_;
                                                                let _e1189 = phi_3651_;
                                                                let _e1196 = ((_e1187.y * _e1189.z) - (_e1189.y * _e1187.z));
                                                                let _e1201 = ((_e1187.z * _e1189.x) - (_e1189.z * _e1187.x));
                                                                let _e1204 = ((_e1187.x * _e1189.y) - (_e1189.x * _e1187.y));
                                                                if (_e1046 >= _e1050) {
                                                                    phi_3682_ = select(true, false, (_e1046 >= _e1054));
                                                                } else {
                                                                    phi_3682_ = true;
                                                                }
                                                                let _e1209 = phi_3682_;
                                                                if _e1209 {
                                                                    phi_3691_ = select(vec3<f32>(_e984[2][0], _e984[2][1], _e984[2][2]), vec3<f32>(_e984[1][0], _e984[1][1], _e984[1][2]), vec3((_e1050 >= _e1054)));
                                                                } else {
                                                                    phi_3691_ = vec3<f32>(_e984[0][0], _e984[0][1], _e984[0][2]);
                                                                }
                                                                let _e1214 = phi_3691_;
                                                                let _e1231 = ((((_e1196 * (_e1214.x - _e298)) + (_e1201 * (_e1214.y - _e337))) + (_e1204 * (_e1214.z - _e375))) / (((_e1196 * _e323) + (_e1201 * _e361)) + (_e1204 * _e399)));
                                                                let _e1233 = select(_e1113, _e1231, (_e1231 < _e1113));
                                                                let _e1235 = select(_e1105, _e1233, (_e1233 > _e1105));
                                                                if (_e1235 >= _e449) {
                                                                    let _e1237 = (_e1235 <= _e848.member);
                                                                    if _e1237 {
                                                                        let _e1238 = (1f / _e1056);
                                                                        phi_3731_ = type_21(_e1235, (_e1050 * _e1238), (_e1054 * _e1238), _e886);
                                                                    } else {
                                                                        phi_3731_ = type_21();
                                                                    }
                                                                    let _e1243 = phi_3731_;
                                                                    phi_3733_ = _e1243;
                                                                    phi_3734_ = select(true, false, _e1237);
                                                                } else {
                                                                    phi_3733_ = type_21();
                                                                    phi_3734_ = true;
                                                                }
                                                                let _e1246 = phi_3733_;
                                                                let _e1248 = phi_3734_;
                                                                if _e1248 {
                                                                    phi_3738_ = type_21(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                } else {
                                                                    phi_3738_ = _e1246;
                                                                }
                                                                let _e1250 = phi_3738_;
                                                                phi_3739_ = _e1250;
                                                            }
                                                            let _e1252 = phi_3739_;
                                                            phi_3740_ = _e1252;
                                                            phi_3741_ = _e1122;
                                                        }
                                                        let _e1254 = phi_3740_;
                                                        let _e1256 = phi_3741_;
                                                        phi_3745_ = _e1254;
                                                        phi_3746_ = _e1256;
                                                    }
                                                    let _e1258 = phi_3745_;
                                                    let _e1260 = phi_3746_;
                                                    phi_3750_ = _e1258;
                                                    phi_3751_ = _e1260;
                                                } else {
                                                    phi_3750_ = type_21();
                                                    phi_3751_ = true;
                                                }
                                                let _e1262 = phi_3750_;
                                                let _e1264 = phi_3751_;
                                                if _e1264 {
                                                    phi_3755_ = type_21(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                } else {
                                                    phi_3755_ = _e1262;
                                                }
                                                let _e1266 = phi_3755_;
                                                if (_e1266.member_3 != 4294967295u) {
                                                    if (_e886 != 4294967295u) {
                                                        phi_3766_ = type_31(_e848.member, true);
                                                    } else {
                                                        phi_3766_ = _e848;
                                                    }
                                                    let _e1274 = phi_3766_;
                                                    phi_3767_ = _e1274;
                                                } else {
                                                    phi_3767_ = _e848;
                                                }
                                                let _e1276 = phi_3767_;
                                                phi_4791_ = _e983;
                                                phi_2927_ = _e1276;
                                            } else {
                                                phi_4791_ = _e846;
                                                phi_2927_ = type_31();
                                            }
                                            let _e1278 = phi_4791_;
                                            let _e1280 = phi_2927_;
                                            continue;
                                            continuing {
                                                phi_4785_ = _e1278;
                                                phi_2926_ = _e1280;
                                                phi_2929_ = _e863;
                                                phi_4790_ = _e1278;
                                                break if !(_e869);
                                            }
                                        }
                                        let _e1283 = phi_4790_;
                                        phi_4846_ = _e1283;
                                        if _e1283 {
                                            break;
                                        }
                                        let _e1285 = local_17;
                                        phi_4850_ = _e1283;
                                        let _e1445 = local_19;
                                        phi_4612_ = _e1445;
                                        phi_4613_ = _e520;
                                        phi_4614_ = false;
                                        phi_4615_ = select(_e524, 0u, _e1285.member_1);
                                    } else {
                                        local_3 = array<f32, 3>(_e520.member.member[0], _e520.member.member[1], _e520.member.member[2]);
                                        local_2 = array<f32, 3>(_e520.member.member_1[0], _e520.member.member_1[1], _e520.member.member_1[2]);
                                        let _e544 = (_e520.member_1 < _e86);
                                        if _e544 {
                                            if _e544 {
                                            } else {
                                                phi_4846_ = true;
                                                break;
                                            }
                                            let _e546 = global_5.member[_e520.member_1];
                                            phi_3802_ = _e546;
                                        } else {
                                            phi_3802_ = type_35(array<u32, 2>(0u, 0u), array<u32, 2>(0u, 0u), 2147483648u, 2147483648u);
                                        }
                                        let _e548 = phi_3802_;
                                        let _e550 = array<u32, 3>(_e249, _e248, _e250);
                                        local_11 = _e550;
                                        local_7 = array<f32, 3>(0f, 0f, 0f);
                                        local_6 = array<f32, 3>(0f, 0f, 0f);
                                        phi_3811_ = type_7(0u, 3u);
                                        loop {
                                            let _e552 = phi_3811_;
                                            if (_e552.member < _e552.member_1) {
                                                phi_3812_ = type_7((_e552.member + 1u), _e552.member_1);
                                                phi_3835_ = type_7(1u, _e552.member);
                                            } else {
                                                phi_3812_ = _e552;
                                                phi_3835_ = type_7(0u, type_7().member_1);
                                            }
                                            let _e565 = phi_3812_;
                                            let _e567 = phi_3835_;
                                            let _e571 = (bitcast<i32>(_e567.member) != 0i);
                                            if _e571 {
                                                let _e572 = (_e567.member_1 < 3u);
                                                if _e572 {
                                                } else {
                                                    phi_4708_ = true;
                                                    break;
                                                }
                                                let _e574 = local_11[_e567.member_1];
                                                if _e572 {
                                                } else {
                                                    phi_4708_ = true;
                                                    break;
                                                }
                                                let _e576 = local_3[_e567.member_1];
                                                if _e572 {
                                                } else {
                                                    phi_4708_ = true;
                                                    break;
                                                }
                                                let _e578 = local_2[_e567.member_1];
                                                let _e581 = ((10u * _e574) & 31u);
                                                let _e584 = ((_e548.member[0] >> bitcast<u32>(_e581)) & 1023u);
                                                let _e589 = bitcast<f32>((bitcast<u32>(((_e578 - _e576) * 0.0009775171f)) ^ _e121));
                                                let _e595 = (_e576 + bitcast<f32>((bitcast<u32>((f32(_e584) * _e589)) ^ _e121)));
                                                if _e572 {
                                                } else {
                                                    phi_4708_ = true;
                                                    break;
                                                }
                                                local_7[_e567.member_1] = select(select(_e578, _e595, (_e595 < _e578)), _e578, (_e584 == 1023u));
                                                let _e604 = ((_e548.member[1] >> bitcast<u32>(_e581)) & 1023u);
                                                let _e610 = (_e576 + bitcast<f32>((bitcast<u32>((f32(_e604) * _e589)) ^ _e121)));
                                                if _e572 {
                                                } else {
                                                    phi_4708_ = true;
                                                    break;
                                                }
                                                local_6[_e567.member_1] = select(select(_e578, _e610, (_e610 < _e578)), _e578, (_e604 == 1023u));
                                            }
                                            continue;
                                            continuing {
                                                phi_3811_ = _e565;
                                                phi_4708_ = _e481;
                                                break if !(_e571);
                                            }
                                        }
                                        let _e618 = phi_4708_;
                                        phi_4846_ = _e618;
                                        if _e618 {
                                            break;
                                        }
                                        let _e619 = local_6;
                                        let _e620 = local_7;
                                        local_10 = _e550;
                                        local_9 = array<f32, 3>(0f, 0f, 0f);
                                        local_8 = array<f32, 3>(0f, 0f, 0f);
                                        phi_3965_ = type_7(0u, 3u);
                                        loop {
                                            let _e629 = phi_3965_;
                                            if (_e629.member < _e629.member_1) {
                                                phi_3966_ = type_7((_e629.member + 1u), _e629.member_1);
                                                phi_3989_ = type_7(1u, _e629.member);
                                            } else {
                                                phi_3966_ = _e629;
                                                phi_3989_ = type_7(0u, type_7().member_1);
                                            }
                                            let _e642 = phi_3966_;
                                            let _e644 = phi_3989_;
                                            let _e648 = (bitcast<i32>(_e644.member) != 0i);
                                            if _e648 {
                                                let _e649 = (_e644.member_1 < 3u);
                                                if _e649 {
                                                } else {
                                                    phi_4768_ = true;
                                                    break;
                                                }
                                                let _e651 = local_10[_e644.member_1];
                                                if _e649 {
                                                } else {
                                                    phi_4768_ = true;
                                                    break;
                                                }
                                                let _e653 = local_3[_e644.member_1];
                                                if _e649 {
                                                } else {
                                                    phi_4768_ = true;
                                                    break;
                                                }
                                                let _e655 = local_2[_e644.member_1];
                                                let _e658 = ((10u * _e651) & 31u);
                                                let _e661 = ((_e548.member_1[0] >> bitcast<u32>(_e658)) & 1023u);
                                                let _e666 = bitcast<f32>((bitcast<u32>(((_e655 - _e653) * 0.0009775171f)) ^ _e121));
                                                let _e672 = (_e653 + bitcast<f32>((bitcast<u32>((f32(_e661) * _e666)) ^ _e121)));
                                                if _e649 {
                                                } else {
                                                    phi_4768_ = true;
                                                    break;
                                                }
                                                local_9[_e644.member_1] = select(select(_e655, _e672, (_e672 < _e655)), _e655, (_e661 == 1023u));
                                                let _e681 = ((_e548.member_1[1] >> bitcast<u32>(_e658)) & 1023u);
                                                let _e687 = (_e653 + bitcast<f32>((bitcast<u32>((f32(_e681) * _e666)) ^ _e121)));
                                                if _e649 {
                                                } else {
                                                    phi_4768_ = true;
                                                    break;
                                                }
                                                local_8[_e644.member_1] = select(select(_e655, _e687, (_e687 < _e655)), _e655, (_e681 == 1023u));
                                            }
                                            continue;
                                            continuing {
                                                phi_3965_ = _e642;
                                                phi_4768_ = _e618;
                                                break if !(_e648);
                                            }
                                        }
                                        let _e695 = phi_4768_;
                                        phi_4846_ = _e695;
                                        if _e695 {
                                            break;
                                        }
                                        let _e696 = local_8;
                                        let _e697 = local_9;
                                        let _e708 = type_49(type_40(array<f32, 3>(_e620[0], _e620[1], _e620[2]), array<f32, 3>(_e619[0], _e619[1], _e619[2])), _e548.member_2);
                                        let _e713 = type_49(type_40(array<f32, 3>(_e697[0], _e697[1], _e697[2]), array<f32, 3>(_e696[0], _e696[1], _e696[2])), _e548.member_3);
                                        let _e719 = ((_e620[0] - _e321) * _e326);
                                        let _e720 = ((_e697[0] - _e321) * _e326);
                                        let _e721 = ((_e619[0] - _e322) * _e326);
                                        let _e722 = ((_e696[0] - _e322) * _e326);
                                        let _e727 = ((_e620[1] - _e359) * _e364);
                                        let _e728 = ((_e697[1] - _e359) * _e364);
                                        let _e729 = ((_e619[1] - _e360) * _e364);
                                        let _e730 = ((_e696[1] - _e360) * _e364);
                                        let _e735 = ((_e620[2] - _e397) * _e402);
                                        let _e736 = ((_e697[2] - _e397) * _e402);
                                        let _e737 = ((_e619[2] - _e398) * _e402);
                                        let _e738 = ((_e696[2] - _e398) * _e402);
                                        let _e740 = select(_e737, _e735, (_e735 < _e737));
                                        let _e742 = select(_e738, _e736, (_e736 < _e738));
                                        let _e744 = select(_e737, _e735, (_e735 > _e737));
                                        let _e746 = select(_e738, _e736, (_e736 > _e738));
                                        let _e748 = select(_e721, _e719, (_e719 < _e721));
                                        let _e750 = select(_e722, _e720, (_e720 < _e722));
                                        let _e752 = select(_e729, _e727, (_e727 < _e729));
                                        let _e754 = select(_e730, _e728, (_e728 < _e730));
                                        let _e756 = select(_e752, _e748, (_e748 > _e752));
                                        let _e758 = select(_e754, _e750, (_e750 > _e754));
                                        let _e760 = select(_e740, _e756, (_e756 > _e740));
                                        let _e762 = select(_e742, _e758, (_e758 > _e742));
                                        let _e764 = select(_e721, _e719, (_e719 > _e721));
                                        let _e766 = select(_e722, _e720, (_e720 > _e722));
                                        let _e768 = select(_e729, _e727, (_e727 > _e729));
                                        let _e770 = select(_e730, _e728, (_e728 > _e730));
                                        let _e772 = select(_e768, _e764, (_e764 < _e768));
                                        let _e774 = select(_e770, _e766, (_e766 < _e770));
                                        let _e779 = -(_e740);
                                        let _e780 = -(_e742);
                                        let _e787 = (select(_e744, _e772, (_e772 < _e744)) + (select(_e779, _e744, (_e744 > _e779)) * 0.0000019073523f));
                                        let _e788 = (select(_e746, _e774, (_e774 < _e746)) + (select(_e780, _e746, (_e746 > _e780)) * 0.0000019073523f));
                                        let _e790 = select(_e449, _e760, (_e760 > _e449));
                                        let _e792 = select(_e449, _e762, (_e762 > _e449));
                                        let _e797 = (_e790 <= select(_e483.member, _e787, (_e787 < _e483.member)));
                                        let _e798 = (_e792 <= select(_e483.member, _e788, (_e788 < _e483.member)));
                                        let _e799 = (_e790 <= _e792);
                                        if _e797 {
                                            if _e798 {
                                                if _e799 {
                                                    phi_4552_ = _e713;
                                                } else {
                                                    phi_4552_ = _e708;
                                                }
                                                let _e801 = phi_4552_;
                                                let _e802 = (_e524 % 128u);
                                                let _e803 = (_e802 < 128u);
                                                if _e803 {
                                                } else {
                                                    phi_4846_ = true;
                                                    break;
                                                }
                                                local_5[_e802] = type_49(type_40(array<f32, 3>(_e801.member.member[0], _e801.member.member[1], _e801.member.member[2]), array<f32, 3>(_e801.member.member_1[0], _e801.member.member_1[1], _e801.member.member_1[2])), _e801.member_1);
                                                if _e803 {
                                                } else {
                                                    phi_4846_ = true;
                                                    break;
                                                }
                                                local_4[_e802] = select(_e792, _e790, (_e790 > _e792));
                                                if _e799 {
                                                    phi_4591_ = _e708;
                                                } else {
                                                    phi_4591_ = _e713;
                                                }
                                                let _e824 = phi_4591_;
                                                phi_4592_ = _e824;
                                                phi_4593_ = (_e524 + 1u);
                                            } else {
                                                phi_4592_ = type_49();
                                                phi_4593_ = u32();
                                            }
                                            let _e826 = phi_4592_;
                                            let _e828 = phi_4593_;
                                            phi_4595_ = _e826;
                                            phi_4596_ = _e828;
                                            phi_4597_ = select(true, false, _e798);
                                        } else {
                                            phi_4595_ = type_49();
                                            phi_4596_ = u32();
                                            phi_4597_ = true;
                                        }
                                        let _e831 = phi_4595_;
                                        let _e833 = phi_4596_;
                                        let _e835 = phi_4597_;
                                        if _e835 {
                                            if _e797 {
                                                phi_4604_ = _e708;
                                            } else {
                                                phi_4604_ = _e713;
                                            }
                                            let _e837 = phi_4604_;
                                            phi_4609_ = _e837;
                                            phi_4610_ = select(_e798, true, _e797);
                                        } else {
                                            phi_4609_ = _e831;
                                            phi_4610_ = _e522;
                                        }
                                        let _e840 = phi_4609_;
                                        let _e842 = phi_4610_;
                                        phi_4850_ = _e695;
                                        phi_4612_ = _e483;
                                        phi_4613_ = _e840;
                                        phi_4614_ = _e842;
                                        phi_4615_ = select(_e833, _e524, _e835);
                                    }
                                    let _e1289 = phi_4850_;
                                    let _e1291 = phi_4612_;
                                    let _e1293 = phi_4613_;
                                    let _e1295 = phi_4614_;
                                    let _e1297 = phi_4615_;
                                    phi_4849_ = _e1289;
                                    phi_4616_ = _e1291;
                                    phi_4617_ = _e1293;
                                    phi_4618_ = (_e487 - 1u);
                                    phi_4619_ = _e1295;
                                    phi_4620_ = _e1297;
                                } else {
                                    phi_4849_ = _e481;
                                    phi_4616_ = _e483;
                                    phi_4617_ = _e520;
                                    phi_4618_ = _e487;
                                    phi_4619_ = _e522;
                                    phi_4620_ = _e524;
                                }
                                let _e1299 = phi_4849_;
                                let _e1301 = phi_4616_;
                                let _e1303 = phi_4617_;
                                let _e1305 = phi_4618_;
                                let _e1307 = phi_4619_;
                                let _e1309 = phi_4620_;
                                phi_4848_ = _e1299;
                                phi_4621_ = _e1301;
                                phi_4622_ = _e1303;
                                phi_4623_ = _e1305;
                                phi_4624_ = _e1307;
                                phi_4625_ = _e1309;
                            } else {
                                phi_4848_ = _e481;
                                phi_4621_ = type_31();
                                phi_4622_ = type_49();
                                phi_4623_ = u32();
                                phi_4624_ = bool();
                                phi_4625_ = u32();
                            }
                            let _e1311 = phi_4848_;
                            let _e1313 = phi_4621_;
                            let _e1315 = phi_4622_;
                            let _e1317 = phi_4623_;
                            let _e1319 = phi_4624_;
                            let _e1321 = phi_4625_;
                            phi_4847_ = _e1311;
                            phi_2841_ = _e1313;
                            phi_2844_ = _e1315;
                            phi_2846_ = _e1317;
                            phi_2848_ = _e1319;
                            phi_2850_ = _e1321;
                            phi_4626_ = _e495;
                        } else {
                            phi_4847_ = _e481;
                            phi_2841_ = type_31();
                            phi_2844_ = type_49();
                            phi_2846_ = u32();
                            phi_2848_ = bool();
                            phi_2850_ = u32();
                            phi_4626_ = false;
                        }
                        let _e1323 = phi_4847_;
                        let _e1325 = phi_2841_;
                        let _e1327 = phi_2844_;
                        let _e1329 = phi_2846_;
                        let _e1331 = phi_2848_;
                        let _e1333 = phi_2850_;
                        let _e1335 = phi_4626_;
                        continue;
                        continuing {
                            phi_4715_ = _e1323;
                            phi_2840_ = _e1325;
                            phi_2843_ = _e1327;
                            phi_2845_ = _e1329;
                            phi_2847_ = _e1331;
                            phi_2849_ = _e1333;
                            phi_4846_ = _e1323;
                            break if !(_e1335);
                        }
                    }
                    let _e1338 = phi_4846_;
                    if _e1338 {
                        break;
                    }
                    let _e1340 = local_18;
                    if _e137 {
                    } else {
                        break;
                    }
                    global_4.member[_e135] = select(0u, 1u, _e1340.member_1);
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
