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

struct type_23 {
    member: array<type_21>,
}

struct type_25 {
    member: array<f32, 3>,
    member_1: f32,
    member_2: array<f32, 3>,
    member_3: f32,
}

struct type_29 {
    member: vec4<f32>,
    member_1: vec4<f32>,
}

struct type_33 {
    member: type_21,
    member_1: f32,
}

struct type_38 {
    member: array<type_25>,
}

struct type_41 {
    member: array<vec4<u32>, 2>,
}

struct type_48 {
    member: array<array<u32, 7>>,
}

struct type_50 {
    member: type_29,
    member_1: u32,
}

struct type_51 {
    member: array<vec4<f32>, 3>,
    member_1: type_50,
    member_2: type_50,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_1: type_8;
@group(0) @binding(3) 
var<storage> global_2: type_15;
@group(0) @binding(1) 
var<uniform> global_3: type_41;
@group(0) @binding(4) 
var<storage> global_4: type_38;
@group(0) @binding(2) 
var<storage> global_5: type_48;
@group(0) @binding(5) 
var<storage, read_write> global_6: type_23;

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
    var local_9: array<f32, 128>;
    var phi_378_: i32;
    var phi_379_: i32;
    var phi_389_: bool;
    var phi_399_: u32;
    var phi_400_: u32;
    var phi_402_: bool;
    var phi_407_: u32;
    var phi_420_: i32;
    var phi_440_: i32;
    var phi_458_: f32;
    var phi_464_: f32;
    var phi_475_: f32;
    var phi_481_: f32;
    var phi_504_: f32;
    var phi_515_: f32;
    var phi_524_: f32;
    var phi_530_: f32;
    var phi_541_: f32;
    var phi_547_: f32;
    var phi_570_: f32;
    var phi_581_: f32;
    var phi_590_: f32;
    var phi_596_: f32;
    var phi_607_: f32;
    var phi_613_: f32;
    var phi_636_: f32;
    var phi_647_: f32;
    var phi_747_: f32;
    var phi_748_: f32;
    var phi_3326_: bool;
    var phi_837_: type_33;
    var phi_840_: type_50;
    var phi_842_: u32;
    var phi_844_: bool;
    var phi_846_: u32;
    var phi_857_: bool;
    var phi_943_: type_50;
    var phi_944_: bool;
    var phi_945_: u32;
    var phi_2573_: u32;
    var phi_2574_: u32;
    var phi_2584_: u32;
    var phi_2586_: u32;
    var phi_2587_: bool;
    var phi_2607_: u32;
    var phi_2608_: u32;
    var phi_2612_: type_51;
    var phi_2956_: type_50;
    var phi_3033_: type_50;
    var phi_3034_: type_50;
    var phi_3035_: u32;
    var phi_3037_: type_50;
    var phi_3038_: u32;
    var phi_3039_: bool;
    var phi_3048_: type_50;
    var phi_3053_: type_50;
    var phi_3054_: bool;
    var phi_963_: type_33;
    var phi_966_: type_4;
    var phi_967_: type_4;
    var phi_989_: type_4;
    var phi_1010_: u32;
    var phi_1099_: array<array<f32, 3>, 3>;
    var phi_1570_: vec3<f32>;
    var phi_1571_: vec3<f32>;
    var phi_1602_: bool;
    var phi_1611_: vec3<f32>;
    var phi_1651_: type_21;
    var phi_1653_: type_21;
    var phi_1654_: bool;
    var phi_1658_: type_21;
    var phi_1659_: type_21;
    var phi_1660_: type_21;
    var phi_1661_: bool;
    var phi_1665_: type_21;
    var phi_1666_: bool;
    var phi_1670_: type_21;
    var phi_1671_: bool;
    var phi_1675_: type_21;
    var phi_1700_: bool;
    var phi_1701_: bool;
    var phi_1707_: type_33;
    var phi_1708_: type_33;
    var phi_1709_: type_33;
    var phi_964_: type_33;
    var phi_3320_: bool;
    var phi_3438_: bool;
    var phi_3056_: type_33;
    var phi_3057_: type_50;
    var phi_3058_: bool;
    var phi_3059_: u32;
    var phi_3437_: bool;
    var phi_3060_: type_33;
    var phi_3061_: type_50;
    var phi_3062_: u32;
    var phi_3063_: bool;
    var phi_3064_: u32;
    var phi_3436_: bool;
    var phi_3065_: type_33;
    var phi_3066_: type_50;
    var phi_3067_: u32;
    var phi_3068_: bool;
    var phi_3069_: u32;
    var phi_3435_: bool;
    var phi_838_: type_33;
    var phi_841_: type_50;
    var phi_843_: u32;
    var phi_845_: bool;
    var phi_847_: u32;
    var phi_3070_: bool;
    var phi_3434_: bool;
    var local_10: type_33;
    var phi_3122_: type_21;
    var local_11: type_33;

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
                            phi_378_ = (bitcast<i32>((_e218 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_378_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e218)), 32u, (_e218 == 0u))));
                        }
                        let _e232 = phi_378_;
                        phi_379_ = _e232;
                    } else {
                        phi_379_ = 0i;
                    }
                    let _e234 = phi_379_;
                    let _e235 = (_e151 == _e190);
                    if _e235 {
                        phi_389_ = true;
                    } else {
                        phi_389_ = (_e158 == _e190);
                    }
                    let _e238 = phi_389_;
                    let _e239 = select(1u, 0u, _e235);
                    if _e238 {
                        let _e240 = (_e239 + 1u);
                        phi_399_ = _e240;
                        phi_400_ = _e240;
                        phi_402_ = select(true, false, (_e240 == 2u));
                    } else {
                        phi_399_ = u32();
                        phi_400_ = 0u;
                        phi_402_ = true;
                    }
                    let _e244 = phi_399_;
                    let _e246 = phi_400_;
                    let _e248 = phi_402_;
                    if _e248 {
                        phi_407_ = (_e246 + 1u);
                    } else {
                        phi_407_ = 0u;
                    }
                    let _e252 = phi_407_;
                    let _e253 = select(_e244, _e246, _e248);
                    let _e254 = select(_e239, select(2u, _e239, _e238), _e248);
                    if (_e121 < -126i) {
                        phi_420_ = -126i;
                    } else {
                        phi_420_ = select(_e121, 127i, (_e121 > 127i));
                    }
                    let _e259 = phi_420_;
                    let _e264 = bitcast<f32>((bitcast<u32>((_e259 + 127i)) << bitcast<u32>(23i)));
                    let _e270 = bitcast<f32>((bitcast<u32>(((_e121 - _e259) + 127i)) << bitcast<u32>(23i)));
                    let _e271 = -(_e234);
                    if (_e271 < -126i) {
                        phi_440_ = -126i;
                    } else {
                        phi_440_ = select(_e271, 127i, (_e271 > 127i));
                    }
                    let _e276 = phi_440_;
                    let _e281 = bitcast<f32>((bitcast<u32>((_e276 + 127i)) << bitcast<u32>(23i)));
                    let _e287 = bitcast<f32>((bitcast<u32>(((_e271 - _e276) + 127i)) << bitcast<u32>(23i)));
                    let _e291 = global_4.member[_e139].member;
                    let _e292 = (_e253 == 0u);
                    if _e292 {
                        phi_458_ = _e291[0];
                    } else {
                        phi_458_ = _e291[1];
                    }
                    let _e296 = phi_458_;
                    let _e297 = (_e253 == 2u);
                    if _e297 {
                        phi_464_ = _e291[2];
                    } else {
                        phi_464_ = _e296;
                    }
                    let _e300 = phi_464_;
                    let _e302 = ((_e300 * _e264) * _e270);
                    let _e303 = global_4.member[_e139].member_2;
                    if _e292 {
                        phi_475_ = _e303[0];
                    } else {
                        phi_475_ = _e303[1];
                    }
                    let _e307 = phi_475_;
                    if _e297 {
                        phi_481_ = _e303[2];
                    } else {
                        phi_481_ = _e307;
                    }
                    let _e310 = phi_481_;
                    let _e312 = ((_e310 * _e281) * _e287);
                    let _e316 = (bitcast<f32>((bitcast<u32>(_e312) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e316 {
                        let _e320 = (bitcast<f32>((bitcast<u32>(_e302) & 2147483647u)) * 0.00000011920929f);
                        phi_504_ = select(0.00000000000011368684f, _e320, (_e320 > 0.00000000000011368684f));
                    } else {
                        phi_504_ = 0f;
                    }
                    let _e324 = phi_504_;
                    let _e325 = (_e302 + _e324);
                    let _e326 = (_e302 - _e324);
                    let _e327 = select(_e312, 0f, _e316);
                    if _e316 {
                        phi_515_ = 38685626000000000000000000f;
                    } else {
                        phi_515_ = (1f / _e312);
                    }
                    let _e330 = phi_515_;
                    let _e331 = (_e252 == 0u);
                    if _e331 {
                        phi_524_ = _e291[0];
                    } else {
                        phi_524_ = _e291[1];
                    }
                    let _e335 = phi_524_;
                    let _e336 = (_e252 == 2u);
                    if _e336 {
                        phi_530_ = _e291[2];
                    } else {
                        phi_530_ = _e335;
                    }
                    let _e339 = phi_530_;
                    let _e341 = ((_e339 * _e264) * _e270);
                    if _e331 {
                        phi_541_ = _e303[0];
                    } else {
                        phi_541_ = _e303[1];
                    }
                    let _e345 = phi_541_;
                    if _e336 {
                        phi_547_ = _e303[2];
                    } else {
                        phi_547_ = _e345;
                    }
                    let _e348 = phi_547_;
                    let _e350 = ((_e348 * _e281) * _e287);
                    let _e354 = (bitcast<f32>((bitcast<u32>(_e350) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e354 {
                        let _e358 = (bitcast<f32>((bitcast<u32>(_e341) & 2147483647u)) * 0.00000011920929f);
                        phi_570_ = select(0.00000000000011368684f, _e358, (_e358 > 0.00000000000011368684f));
                    } else {
                        phi_570_ = 0f;
                    }
                    let _e362 = phi_570_;
                    let _e363 = (_e341 + _e362);
                    let _e364 = (_e341 - _e362);
                    let _e365 = select(_e350, 0f, _e354);
                    if _e354 {
                        phi_581_ = 38685626000000000000000000f;
                    } else {
                        phi_581_ = (1f / _e350);
                    }
                    let _e368 = phi_581_;
                    let _e369 = (_e254 == 0u);
                    if _e369 {
                        phi_590_ = _e291[0];
                    } else {
                        phi_590_ = _e291[1];
                    }
                    let _e373 = phi_590_;
                    let _e374 = (_e254 == 2u);
                    if _e374 {
                        phi_596_ = _e291[2];
                    } else {
                        phi_596_ = _e373;
                    }
                    let _e377 = phi_596_;
                    let _e379 = ((_e377 * _e264) * _e270);
                    if _e369 {
                        phi_607_ = _e303[0];
                    } else {
                        phi_607_ = _e303[1];
                    }
                    let _e383 = phi_607_;
                    if _e374 {
                        phi_613_ = _e303[2];
                    } else {
                        phi_613_ = _e383;
                    }
                    let _e386 = phi_613_;
                    let _e388 = ((_e386 * _e281) * _e287);
                    let _e392 = (bitcast<f32>((bitcast<u32>(_e388) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e392 {
                        let _e396 = (bitcast<f32>((bitcast<u32>(_e379) & 2147483647u)) * 0.00000011920929f);
                        phi_636_ = select(0.00000000000011368684f, _e396, (_e396 > 0.00000000000011368684f));
                    } else {
                        phi_636_ = 0f;
                    }
                    let _e400 = phi_636_;
                    let _e401 = (_e379 + _e400);
                    let _e402 = (_e379 - _e400);
                    let _e403 = select(_e388, 0f, _e392);
                    if _e392 {
                        phi_647_ = 38685626000000000000000000f;
                    } else {
                        phi_647_ = (1f / _e388);
                    }
                    let _e406 = phi_647_;
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
                        phi_747_ = select(-340282350000000000000000000000000000000f, _e447, (_e447 > -340282350000000000000000000000000000000f));
                        phi_748_ = select(-340282350000000000000000000000000000000f, _e440, (_e440 > -340282350000000000000000000000000000000f));
                    } else {
                        phi_747_ = 0f;
                        phi_748_ = 1f;
                    }
                    let _e451 = phi_747_;
                    let _e453 = phi_748_;
                    local_8 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                    local_7 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_6 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_5 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_4 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_3 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_9 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    let _e457 = (_e253 % 3u);
                    let _e458 = (_e457 < 3u);
                    if _e458 {
                    } else {
                        break;
                    }
                    let _e460 = local_1[_e457];
                    let _e463 = (_e252 % 3u);
                    let _e464 = (_e463 < 3u);
                    if _e464 {
                    } else {
                        break;
                    }
                    let _e466 = local_1[_e463];
                    let _e469 = (_e254 % 3u);
                    let _e470 = (_e469 < 3u);
                    if _e470 {
                    } else {
                        break;
                    }
                    let _e472 = local_1[_e469];
                    if _e458 {
                    } else {
                        break;
                    }
                    let _e477 = local[_e457];
                    if _e464 {
                    } else {
                        break;
                    }
                    let _e481 = local[_e463];
                    if _e470 {
                    } else {
                        break;
                    }
                    let _e485 = local[_e469];
                    phi_3326_ = false;
                    phi_837_ = type_33(type_21(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e451);
                    phi_840_ = type_50(type_29(vec4<f32>((f32(_e460) * _e133), (f32(_e466) * _e133), (f32(_e472) * _e133), 0f), vec4<f32>((f32(_e477) * _e133), (f32(_e481) * _e133), (f32(_e485) * _e133), 0f)), select(0u, 2147483648u, (_e83 == 0u)));
                    phi_842_ = ((3u * _e83) + 1u);
                    phi_844_ = (_e453 <= _e451);
                    phi_846_ = 0u;
                    loop {
                        let _e495 = phi_3326_;
                        let _e497 = phi_837_;
                        let _e499 = phi_840_;
                        let _e501 = phi_842_;
                        let _e503 = phi_844_;
                        let _e505 = phi_846_;
                        local_10 = _e497;
                        if _e503 {
                            phi_857_ = true;
                        } else {
                            phi_857_ = (_e505 > 0u);
                        }
                        let _e508 = phi_857_;
                        if _e508 {
                            let _e509 = (_e501 > 0u);
                            if _e509 {
                                if _e503 {
                                    phi_943_ = _e499;
                                    phi_944_ = _e503;
                                    phi_945_ = _e505;
                                } else {
                                    let _e510 = (_e505 - 1u);
                                    let _e511 = (_e510 % 128u);
                                    let _e512 = (_e511 < 128u);
                                    if _e512 {
                                    } else {
                                        phi_3434_ = true;
                                        break;
                                    }
                                    let _e514 = local_7[_e511];
                                    if _e512 {
                                    } else {
                                        phi_3434_ = true;
                                        break;
                                    }
                                    let _e516 = local_6[_e511];
                                    if _e512 {
                                    } else {
                                        phi_3434_ = true;
                                        break;
                                    }
                                    let _e518 = local_5[_e511];
                                    if _e512 {
                                    } else {
                                        phi_3434_ = true;
                                        break;
                                    }
                                    let _e520 = local_4[_e511];
                                    if _e512 {
                                    } else {
                                        phi_3434_ = true;
                                        break;
                                    }
                                    let _e522 = local_3[_e511];
                                    if _e512 {
                                    } else {
                                        phi_3434_ = true;
                                        break;
                                    }
                                    let _e524 = local_2[_e511];
                                    if _e512 {
                                    } else {
                                        phi_3434_ = true;
                                        break;
                                    }
                                    let _e529 = local_8[_e511];
                                    if _e512 {
                                    } else {
                                        phi_3434_ = true;
                                        break;
                                    }
                                    let _e532 = local_9[_e511];
                                    phi_943_ = type_50(type_29(vec4<f32>(_e514, _e516, _e518, 0f), vec4<f32>(_e520, _e522, _e524, 0f)), _e529);
                                    phi_944_ = (_e532 <= _e497.member_1);
                                    phi_945_ = _e510;
                                }
                                let _e536 = phi_943_;
                                let _e538 = phi_944_;
                                let _e540 = phi_945_;
                                if _e538 {
                                    if ((_e536.member_1 & 2147483648u) != 0u) {
                                        phi_963_ = _e497;
                                        phi_966_ = type_4(0u, ((_e536.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e1005 = phi_963_;
                                            let _e1007 = phi_966_;
                                            local_11 = _e1005;
                                            if (_e1007.member < _e1007.member_1) {
                                                phi_967_ = type_4((_e1007.member + 1u), _e1007.member_1);
                                                phi_989_ = type_4(1u, _e1007.member);
                                            } else {
                                                phi_967_ = _e1007;
                                                phi_989_ = type_4(0u, type_4().member_1);
                                            }
                                            let _e1020 = phi_967_;
                                            let _e1022 = phi_989_;
                                            let _e1026 = (bitcast<i32>(_e1022.member) != 0i);
                                            if _e1026 {
                                                let _e1027 = ((_e536.member_1 & 268435455u) + _e1022.member_1);
                                                let _e1028 = (_e1027 < _e85);
                                                if _e1028 {
                                                    if _e1028 {
                                                    } else {
                                                        phi_3320_ = true;
                                                        break;
                                                    }
                                                    let _e1032 = global_2.member[_e1027].member_1;
                                                    phi_1010_ = _e1032;
                                                } else {
                                                    phi_1010_ = 4294967295u;
                                                }
                                                let _e1034 = phi_1010_;
                                                if (_e1027 >= _e85) {
                                                    phi_1099_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                } else {
                                                    if _e1028 {
                                                    } else {
                                                        phi_3320_ = true;
                                                        break;
                                                    }
                                                    if (_e457 < 9u) {
                                                    } else {
                                                        phi_3320_ = true;
                                                        break;
                                                    }
                                                    let _e1041 = global_2.member[_e1027].member[_e457];
                                                    if (_e463 < 9u) {
                                                    } else {
                                                        phi_3320_ = true;
                                                        break;
                                                    }
                                                    let _e1047 = global_2.member[_e1027].member[_e463];
                                                    if (_e469 < 9u) {
                                                    } else {
                                                        phi_3320_ = true;
                                                        break;
                                                    }
                                                    let _e1053 = global_2.member[_e1027].member[_e469];
                                                    let _e1055 = (3u + _e457);
                                                    if (_e1055 < 9u) {
                                                    } else {
                                                        phi_3320_ = true;
                                                        break;
                                                    }
                                                    let _e1061 = global_2.member[_e1027].member[_e1055];
                                                    let _e1062 = (3u + _e463);
                                                    if (_e1062 < 9u) {
                                                    } else {
                                                        phi_3320_ = true;
                                                        break;
                                                    }
                                                    let _e1068 = global_2.member[_e1027].member[_e1062];
                                                    let _e1069 = (3u + _e469);
                                                    if (_e1069 < 9u) {
                                                    } else {
                                                        phi_3320_ = true;
                                                        break;
                                                    }
                                                    let _e1075 = global_2.member[_e1027].member[_e1069];
                                                    let _e1077 = (6u + _e457);
                                                    if (_e1077 < 9u) {
                                                    } else {
                                                        phi_3320_ = true;
                                                        break;
                                                    }
                                                    let _e1083 = global_2.member[_e1027].member[_e1077];
                                                    let _e1084 = (6u + _e463);
                                                    if (_e1084 < 9u) {
                                                    } else {
                                                        phi_3320_ = true;
                                                        break;
                                                    }
                                                    let _e1090 = global_2.member[_e1027].member[_e1084];
                                                    let _e1091 = (6u + _e469);
                                                    if (_e1091 < 9u) {
                                                    } else {
                                                        phi_3320_ = true;
                                                        break;
                                                    }
                                                    let _e1097 = global_2.member[_e1027].member[_e1091];
                                                    phi_1099_ = array<array<f32, 3>, 3>(array<f32, 3>(_e1041, _e1047, _e1053), array<f32, 3>(_e1061, _e1068, _e1075), array<f32, 3>(_e1083, _e1090, _e1097));
                                                }
                                                let _e1101 = phi_1099_;
                                                let _e1109 = (_e1101[0][2] - _e379);
                                                let _e1112 = (((_e1101[0][0] - _e302) * _e403) - (_e1109 * _e327));
                                                let _e1115 = (((_e1101[0][1] - _e341) * _e403) - (_e1109 * _e365));
                                                let _e1122 = (_e1101[1][2] - _e379);
                                                let _e1125 = (((_e1101[1][0] - _e302) * _e403) - (_e1122 * _e327));
                                                let _e1128 = (((_e1101[1][1] - _e341) * _e403) - (_e1122 * _e365));
                                                let _e1135 = (_e1101[2][2] - _e379);
                                                let _e1138 = (((_e1101[2][0] - _e302) * _e403) - (_e1135 * _e327));
                                                let _e1141 = (((_e1101[2][1] - _e341) * _e403) - (_e1135 * _e365));
                                                let _e1142 = (_e1138 * _e1128);
                                                let _e1143 = (_e1141 * _e1125);
                                                let _e1144 = (_e1112 * _e1141);
                                                let _e1145 = (_e1115 * _e1138);
                                                let _e1146 = (_e1125 * _e1115);
                                                let _e1147 = (_e1128 * _e1112);
                                                let _e1152 = (((_e1142 >= _e1143) && (_e1144 >= _e1145)) && (_e1146 >= _e1147));
                                                if (_e1152 || (((_e1142 <= _e1143) && (_e1144 <= _e1145)) && (_e1146 <= _e1147))) {
                                                    let _e1159 = select(-1f, 1f, _e1152);
                                                    let _e1161 = ((_e1142 - _e1143) * _e1159);
                                                    let _e1163 = select(0f, _e1161, (_e1161 > 0f));
                                                    let _e1165 = ((_e1144 - _e1145) * _e1159);
                                                    let _e1167 = select(0f, _e1165, (_e1165 > 0f));
                                                    let _e1169 = ((_e1146 - _e1147) * _e1159);
                                                    let _e1171 = select(0f, _e1169, (_e1169 > 0f));
                                                    let _e1173 = ((_e1163 + _e1167) + _e1171);
                                                    if (_e1173 < 0.000000000000000000000000000000000000011754944f) {
                                                        phi_1665_ = type_21();
                                                        phi_1666_ = true;
                                                    } else {
                                                        let _e1176 = select(_e1101[1][0], _e1101[0][0], (_e1101[0][0] < _e1101[1][0]));
                                                        let _e1180 = select(_e1101[1][0], _e1101[0][0], (_e1101[0][0] > _e1101[1][0]));
                                                        let _e1184 = select(_e1101[1][1], _e1101[0][1], (_e1101[0][1] < _e1101[1][1]));
                                                        let _e1188 = select(_e1101[1][1], _e1101[0][1], (_e1101[0][1] > _e1101[1][1]));
                                                        let _e1192 = select(_e1101[1][2], _e1101[0][2], (_e1101[0][2] < _e1101[1][2]));
                                                        let _e1196 = select(_e1101[1][2], _e1101[0][2], (_e1101[0][2] > _e1101[1][2]));
                                                        let _e1201 = ((select(_e1101[2][0], _e1176, (_e1176 < _e1101[2][0])) - _e325) * _e330);
                                                        let _e1202 = ((select(_e1101[2][0], _e1180, (_e1180 > _e1101[2][0])) - _e326) * _e330);
                                                        let _e1205 = ((select(_e1101[2][1], _e1184, (_e1184 < _e1101[2][1])) - _e363) * _e368);
                                                        let _e1206 = ((select(_e1101[2][1], _e1188, (_e1188 > _e1101[2][1])) - _e364) * _e368);
                                                        let _e1209 = ((select(_e1101[2][2], _e1192, (_e1192 < _e1101[2][2])) - _e401) * _e406);
                                                        let _e1210 = ((select(_e1101[2][2], _e1196, (_e1196 > _e1101[2][2])) - _e402) * _e406);
                                                        let _e1212 = select(_e1210, _e1209, (_e1209 < _e1210));
                                                        let _e1214 = select(_e1210, _e1209, (_e1209 > _e1210));
                                                        let _e1216 = select(_e1202, _e1201, (_e1201 < _e1202));
                                                        let _e1218 = select(_e1206, _e1205, (_e1205 < _e1206));
                                                        let _e1220 = select(_e1218, _e1216, (_e1216 > _e1218));
                                                        let _e1222 = select(_e1212, _e1220, (_e1220 > _e1212));
                                                        let _e1224 = select(_e1202, _e1201, (_e1201 > _e1202));
                                                        let _e1226 = select(_e1206, _e1205, (_e1205 > _e1206));
                                                        let _e1228 = select(_e1226, _e1224, (_e1224 < _e1226));
                                                        let _e1230 = select(_e1214, _e1228, (_e1228 < _e1214));
                                                        let _e1231 = -(_e1212);
                                                        let _e1237 = select(_e453, _e1222, (_e1222 > _e453));
                                                        if (_e1237 > (_e1230 + (select(_e1231, _e1214, (_e1214 > _e1231)) * 0.0000019073523f))) {
                                                            phi_1660_ = type_21();
                                                            phi_1661_ = true;
                                                        } else {
                                                            let _e1239 = (_e1237 > _e1005.member_1);
                                                            if _e1239 {
                                                                phi_1659_ = type_21();
                                                            } else {
                                                                let _e1243 = (_e1101[1][0] - _e1101[0][0]);
                                                                let _e1244 = (_e1101[1][1] - _e1101[0][1]);
                                                                let _e1245 = (_e1101[1][2] - _e1101[0][2]);
                                                                let _e1246 = vec3<f32>(_e1243, _e1244, _e1245);
                                                                let _e1247 = (_e1101[2][0] - _e1101[1][0]);
                                                                let _e1248 = (_e1101[2][1] - _e1101[1][1]);
                                                                let _e1249 = (_e1101[2][2] - _e1101[1][2]);
                                                                let _e1250 = vec3<f32>(_e1247, _e1248, _e1249);
                                                                let _e1251 = (_e1101[0][0] - _e1101[2][0]);
                                                                let _e1252 = (_e1101[0][1] - _e1101[2][1]);
                                                                let _e1253 = (_e1101[0][2] - _e1101[2][2]);
                                                                let _e1254 = vec3<f32>(_e1251, _e1252, _e1253);
                                                                let _e1257 = bitcast<f32>((bitcast<u32>(_e1243) & 2147483647u));
                                                                let _e1260 = bitcast<f32>((bitcast<u32>(_e1244) & 2147483647u));
                                                                let _e1262 = select(_e1260, _e1257, (_e1257 > _e1260));
                                                                let _e1265 = bitcast<f32>((bitcast<u32>(_e1245) & 2147483647u));
                                                                let _e1267 = select(_e1265, _e1262, (_e1262 > _e1265));
                                                                let _e1270 = bitcast<f32>((bitcast<u32>(_e1247) & 2147483647u));
                                                                let _e1273 = bitcast<f32>((bitcast<u32>(_e1248) & 2147483647u));
                                                                let _e1275 = select(_e1273, _e1270, (_e1270 > _e1273));
                                                                let _e1278 = bitcast<f32>((bitcast<u32>(_e1249) & 2147483647u));
                                                                let _e1280 = select(_e1278, _e1275, (_e1275 > _e1278));
                                                                let _e1283 = bitcast<f32>((bitcast<u32>(_e1251) & 2147483647u));
                                                                let _e1286 = bitcast<f32>((bitcast<u32>(_e1252) & 2147483647u));
                                                                let _e1288 = select(_e1286, _e1283, (_e1283 > _e1286));
                                                                let _e1291 = bitcast<f32>((bitcast<u32>(_e1253) & 2147483647u));
                                                                let _e1293 = select(_e1291, _e1288, (_e1288 > _e1291));
                                                                let _e1295 = select(_e1280, _e1267, (_e1267 > _e1280));
                                                                let _e1297 = select(_e1293, _e1295, (_e1295 > _e1293));
                                                                if (_e1267 == _e1297) {
                                                                    phi_1570_ = _e1250;
                                                                    phi_1571_ = _e1254;
                                                                } else {
                                                                    let _e1300 = vec3((_e1280 == _e1297));
                                                                    phi_1570_ = select(_e1246, _e1254, _e1300);
                                                                    phi_1571_ = select(_e1250, _e1246, _e1300);
                                                                }
                                                                let _e1304 = phi_1570_;
                                                                let _e1306 = phi_1571_;
                                                                let _e1313 = ((_e1304.y * _e1306.z) - (_e1306.y * _e1304.z));
                                                                let _e1318 = ((_e1304.z * _e1306.x) - (_e1306.z * _e1304.x));
                                                                let _e1321 = ((_e1304.x * _e1306.y) - (_e1306.x * _e1304.y));
                                                                if (_e1163 >= _e1167) {
                                                                    phi_1602_ = select(true, false, (_e1163 >= _e1171));
                                                                } else {
                                                                    phi_1602_ = true;
                                                                }
                                                                let _e1326 = phi_1602_;
                                                                if _e1326 {
                                                                    phi_1611_ = select(vec3<f32>(_e1101[2][0], _e1101[2][1], _e1101[2][2]), vec3<f32>(_e1101[1][0], _e1101[1][1], _e1101[1][2]), vec3((_e1167 >= _e1171)));
                                                                } else {
                                                                    phi_1611_ = vec3<f32>(_e1101[0][0], _e1101[0][1], _e1101[0][2]);
                                                                }
                                                                let _e1331 = phi_1611_;
                                                                let _e1348 = ((((_e1313 * (_e1331.x - _e302)) + (_e1318 * (_e1331.y - _e341))) + (_e1321 * (_e1331.z - _e379))) / (((_e1313 * _e327) + (_e1318 * _e365)) + (_e1321 * _e403)));
                                                                let _e1350 = select(_e1230, _e1348, (_e1348 < _e1230));
                                                                let _e1352 = select(_e1222, _e1350, (_e1350 > _e1222));
                                                                if (_e1352 >= _e453) {
                                                                    let _e1354 = (_e1352 <= _e1005.member_1);
                                                                    if _e1354 {
                                                                        let _e1355 = (1f / _e1173);
                                                                        phi_1651_ = type_21(_e1352, (_e1167 * _e1355), (_e1171 * _e1355), _e1034);
                                                                    } else {
                                                                        phi_1651_ = type_21();
                                                                    }
                                                                    let _e1360 = phi_1651_;
                                                                    phi_1653_ = _e1360;
                                                                    phi_1654_ = select(true, false, _e1354);
                                                                } else {
                                                                    phi_1653_ = type_21();
                                                                    phi_1654_ = true;
                                                                }
                                                                let _e1363 = phi_1653_;
                                                                let _e1365 = phi_1654_;
                                                                if _e1365 {
                                                                    phi_1658_ = type_21(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                } else {
                                                                    phi_1658_ = _e1363;
                                                                }
                                                                let _e1367 = phi_1658_;
                                                                phi_1659_ = _e1367;
                                                            }
                                                            let _e1369 = phi_1659_;
                                                            phi_1660_ = _e1369;
                                                            phi_1661_ = _e1239;
                                                        }
                                                        let _e1371 = phi_1660_;
                                                        let _e1373 = phi_1661_;
                                                        phi_1665_ = _e1371;
                                                        phi_1666_ = _e1373;
                                                    }
                                                    let _e1375 = phi_1665_;
                                                    let _e1377 = phi_1666_;
                                                    phi_1670_ = _e1375;
                                                    phi_1671_ = _e1377;
                                                } else {
                                                    phi_1670_ = type_21();
                                                    phi_1671_ = true;
                                                }
                                                let _e1379 = phi_1670_;
                                                let _e1381 = phi_1671_;
                                                if _e1381 {
                                                    phi_1675_ = type_21(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                } else {
                                                    phi_1675_ = _e1379;
                                                }
                                                let _e1383 = phi_1675_;
                                                if (_e1383.member_3 != 4294967295u) {
                                                    if (_e1034 != 4294967295u) {
                                                        if (_e1383.member < _e1005.member.member) {
                                                            phi_1701_ = true;
                                                        } else {
                                                            if (_e1383.member == _e1005.member.member) {
                                                                phi_1700_ = (_e1383.member_3 < _e1005.member.member_3);
                                                            } else {
                                                                phi_1700_ = false;
                                                            }
                                                            let _e1396 = phi_1700_;
                                                            phi_1701_ = _e1396;
                                                        }
                                                        let _e1398 = phi_1701_;
                                                        if _e1398 {
                                                            phi_1707_ = type_33(_e1383, _e1383.member);
                                                        } else {
                                                            phi_1707_ = _e1005;
                                                        }
                                                        let _e1401 = phi_1707_;
                                                        phi_1708_ = _e1401;
                                                    } else {
                                                        phi_1708_ = _e1005;
                                                    }
                                                    let _e1403 = phi_1708_;
                                                    phi_1709_ = _e1403;
                                                } else {
                                                    phi_1709_ = _e1005;
                                                }
                                                let _e1405 = phi_1709_;
                                                phi_964_ = _e1405;
                                            } else {
                                                phi_964_ = type_33();
                                            }
                                            let _e1407 = phi_964_;
                                            continue;
                                            continuing {
                                                phi_963_ = _e1407;
                                                phi_966_ = _e1020;
                                                phi_3320_ = _e495;
                                                break if !(_e1026);
                                            }
                                        }
                                        let _e1410 = phi_3320_;
                                        phi_3434_ = _e1410;
                                        if _e1410 {
                                            break;
                                        }
                                        phi_3438_ = _e1410;
                                        let _e1585 = local_11;
                                        phi_3056_ = _e1585;
                                        phi_3057_ = _e536;
                                        phi_3058_ = false;
                                        phi_3059_ = _e540;
                                    } else {
                                        if (_e536.member_1 >= _e83) {
                                            phi_2612_ = type_51(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), type_50(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u), type_50(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u));
                                        } else {
                                            if (_e536.member_1 < _e83) {
                                            } else {
                                                phi_3434_ = true;
                                                break;
                                            }
                                            let _e553 = ((1u + (_e253 * 2u)) % 7u);
                                            if (_e553 < 7u) {
                                            } else {
                                                phi_3434_ = true;
                                                break;
                                            }
                                            let _e558 = global_5.member[_e536.member_1][_e553];
                                            let _e561 = ((1u + (_e252 * 2u)) % 7u);
                                            if (_e561 < 7u) {
                                            } else {
                                                phi_3434_ = true;
                                                break;
                                            }
                                            let _e566 = global_5.member[_e536.member_1][_e561];
                                            let _e569 = ((1u + (_e254 * 2u)) % 7u);
                                            if (_e569 < 7u) {
                                            } else {
                                                phi_3434_ = true;
                                                break;
                                            }
                                            let _e574 = global_5.member[_e536.member_1][_e569];
                                            let _e577 = (((_e253 + 1u) * 2u) % 7u);
                                            if (_e577 < 7u) {
                                            } else {
                                                phi_3434_ = true;
                                                break;
                                            }
                                            let _e582 = global_5.member[_e536.member_1][_e577];
                                            let _e585 = (((_e252 + 1u) * 2u) % 7u);
                                            if (_e585 < 7u) {
                                            } else {
                                                phi_3434_ = true;
                                                break;
                                            }
                                            let _e590 = global_5.member[_e536.member_1][_e585];
                                            let _e593 = (((_e254 + 1u) * 2u) % 7u);
                                            if (_e593 < 7u) {
                                            } else {
                                                phi_3434_ = true;
                                                break;
                                            }
                                            let _e598 = global_5.member[_e536.member_1][_e593];
                                            let _e621 = (bitcast<f32>((bitcast<u32>((_e536.member.member_1.x - _e536.member.member.x)) & 2139095040u)) * 0.0000009536743f);
                                            let _e622 = (bitcast<f32>((bitcast<u32>((_e536.member.member_1.y - _e536.member.member.y)) & 2139095040u)) * 0.0000009536743f);
                                            let _e623 = (bitcast<f32>((bitcast<u32>((_e536.member.member_1.z - _e536.member.member.z)) & 2139095040u)) * 0.0000009536743f);
                                            let _e625 = select(_e133, _e621, (_e621 > _e133));
                                            let _e627 = select(_e133, _e622, (_e622 > _e133));
                                            let _e629 = select(_e133, _e623, (_e623 > _e133));
                                            let _e654 = bitcast<u32>((f32(bitcast<i32>((_e558 & 2097151u))) * _e625));
                                            let _e659 = (bitcast<i32>((_e558 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e662 = bitcast<f32>((_e654 & bitcast<u32>(_e659)));
                                            let _e663 = bitcast<u32>((f32(bitcast<i32>((_e566 & 2097151u))) * _e627));
                                            let _e668 = (bitcast<i32>((_e566 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e671 = bitcast<f32>((_e663 & bitcast<u32>(_e668)));
                                            let _e672 = bitcast<u32>((f32(bitcast<i32>((_e574 & 2097151u))) * _e629));
                                            let _e677 = (bitcast<i32>((_e574 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e680 = bitcast<f32>((_e672 & bitcast<u32>(_e677)));
                                            let _e684 = bitcast<f32>((_e654 & bitcast<u32>(~(_e659))));
                                            let _e688 = bitcast<f32>((_e663 & bitcast<u32>(~(_e668))));
                                            let _e692 = bitcast<f32>((_e672 & bitcast<u32>(~(_e677))));
                                            let _e693 = bitcast<u32>((f32(bitcast<i32>((_e582 & 2097151u))) * _e625));
                                            let _e698 = (bitcast<i32>((_e582 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e701 = bitcast<f32>((_e693 & bitcast<u32>(_e698)));
                                            let _e702 = bitcast<u32>((f32(bitcast<i32>((_e590 & 2097151u))) * _e627));
                                            let _e707 = (bitcast<i32>((_e590 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e710 = bitcast<f32>((_e702 & bitcast<u32>(_e707)));
                                            let _e711 = bitcast<u32>((f32(bitcast<i32>((_e598 & 2097151u))) * _e629));
                                            let _e716 = (bitcast<i32>((_e598 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e719 = bitcast<f32>((_e711 & bitcast<u32>(_e716)));
                                            let _e723 = bitcast<f32>((_e693 & bitcast<u32>(~(_e698))));
                                            let _e727 = bitcast<f32>((_e702 & bitcast<u32>(~(_e707))));
                                            let _e731 = bitcast<f32>((_e711 & bitcast<u32>(~(_e716))));
                                            let _e761 = global_5.member[_e536.member_1][0u];
                                            let _e765 = global_5.member[_e536.member_1][2u];
                                            let _e769 = global_5.member[_e536.member_1][4u];
                                            let _e773 = global_5.member[_e536.member_1][6u];
                                            let _e785 = (((_e765 >> bitcast<u32>(22i)) | ((_e769 >> bitcast<u32>(22i)) << bitcast<u32>(10i))) | ((_e773 >> bitcast<u32>(22i)) << bitcast<u32>(20i)));
                                            let _e786 = (_e761 & 268435455u);
                                            let _e787 = (_e785 & 268435455u);
                                            let _e790 = ((_e761 >> bitcast<u32>(28u)) & 7u);
                                            let _e798 = ((_e761 >> bitcast<u32>(31i)) | (((_e785 >> bitcast<u32>(28u)) & 3u) << bitcast<u32>(1i)));
                                            let _e799 = (_e790 != 0u);
                                            if (_e790 == 0u) {
                                                phi_2574_ = _e786;
                                            } else {
                                                if (_e790 == 7u) {
                                                    phi_2573_ = 2147483648u;
                                                } else {
                                                    phi_2573_ = ((2147483648u | (_e790 << bitcast<u32>(28u))) | (_e787 & 268435455u));
                                                }
                                                let _e808 = phi_2573_;
                                                phi_2574_ = _e808;
                                            }
                                            let _e810 = phi_2574_;
                                            if _e799 {
                                                let _e811 = (_e790 != 7u);
                                                if _e811 {
                                                    phi_2584_ = (_e787 + _e790);
                                                } else {
                                                    phi_2584_ = u32();
                                                }
                                                let _e814 = phi_2584_;
                                                phi_2586_ = _e814;
                                                phi_2587_ = select(true, false, _e811);
                                            } else {
                                                phi_2586_ = u32();
                                                phi_2587_ = true;
                                            }
                                            let _e817 = phi_2586_;
                                            let _e819 = phi_2587_;
                                            if (_e798 == 0u) {
                                                phi_2608_ = (_e786 + select(0u, 1u, !(_e799)));
                                            } else {
                                                if (_e798 == 7u) {
                                                    phi_2607_ = 2147483648u;
                                                } else {
                                                    phi_2607_ = ((2147483648u | (_e798 << bitcast<u32>(28u))) | (select(_e817, _e787, _e819) & 268435455u));
                                                }
                                                let _e832 = phi_2607_;
                                                phi_2608_ = _e832;
                                            }
                                            let _e834 = phi_2608_;
                                            phi_2612_ = type_51(array<vec4<f32>, 3>(vec4<f32>((_e536.member.member.x + _e662), (_e536.member.member.x + _e684), (_e536.member.member_1.x - _e701), (_e536.member.member_1.x - _e723)), vec4<f32>((_e536.member.member.y + _e671), (_e536.member.member.y + _e688), (_e536.member.member_1.y - _e710), (_e536.member.member_1.y - _e727)), vec4<f32>((_e536.member.member.z + _e680), (_e536.member.member.z + _e692), (_e536.member.member_1.z - _e719), (_e536.member.member_1.z - _e731))), type_50(type_29((_e536.member.member + vec4<f32>(_e662, _e671, _e680, 0f)), (_e536.member.member_1 - vec4<f32>(_e701, _e710, _e719, 0f))), _e810), type_50(type_29((_e536.member.member + vec4<f32>(_e684, _e688, _e692, 0f)), (_e536.member.member_1 - vec4<f32>(_e723, _e727, _e731, 0f))), _e834));
                                        }
                                        let _e839 = phi_2612_;
                                        let _e851 = ((_e839.member[0].x - _e325) * _e330);
                                        let _e852 = ((_e839.member[0].y - _e325) * _e330);
                                        let _e853 = ((_e839.member[0].z - _e326) * _e330);
                                        let _e854 = ((_e839.member[0].w - _e326) * _e330);
                                        let _e864 = ((_e839.member[1].x - _e363) * _e368);
                                        let _e865 = ((_e839.member[1].y - _e363) * _e368);
                                        let _e866 = ((_e839.member[1].z - _e364) * _e368);
                                        let _e867 = ((_e839.member[1].w - _e364) * _e368);
                                        let _e877 = ((_e839.member[2].x - _e401) * _e406);
                                        let _e878 = ((_e839.member[2].y - _e401) * _e406);
                                        let _e879 = ((_e839.member[2].z - _e402) * _e406);
                                        let _e880 = ((_e839.member[2].w - _e402) * _e406);
                                        let _e882 = select(_e879, _e877, (_e877 < _e879));
                                        let _e884 = select(_e880, _e878, (_e878 < _e880));
                                        let _e886 = select(_e879, _e877, (_e877 > _e879));
                                        let _e888 = select(_e880, _e878, (_e878 > _e880));
                                        let _e890 = select(_e853, _e851, (_e851 < _e853));
                                        let _e892 = select(_e854, _e852, (_e852 < _e854));
                                        let _e894 = select(_e866, _e864, (_e864 < _e866));
                                        let _e896 = select(_e867, _e865, (_e865 < _e867));
                                        let _e898 = select(_e894, _e890, (_e890 > _e894));
                                        let _e900 = select(_e896, _e892, (_e892 > _e896));
                                        let _e902 = select(_e882, _e898, (_e898 > _e882));
                                        let _e904 = select(_e884, _e900, (_e900 > _e884));
                                        let _e906 = select(_e853, _e851, (_e851 > _e853));
                                        let _e908 = select(_e854, _e852, (_e852 > _e854));
                                        let _e910 = select(_e866, _e864, (_e864 > _e866));
                                        let _e912 = select(_e867, _e865, (_e865 > _e867));
                                        let _e914 = select(_e910, _e906, (_e906 < _e910));
                                        let _e916 = select(_e912, _e908, (_e908 < _e912));
                                        let _e921 = -(_e882);
                                        let _e922 = -(_e884);
                                        let _e929 = (select(_e886, _e914, (_e914 < _e886)) + (select(_e921, _e886, (_e886 > _e921)) * 0.0000019073523f));
                                        let _e930 = (select(_e888, _e916, (_e916 < _e888)) + (select(_e922, _e888, (_e888 > _e922)) * 0.0000019073523f));
                                        let _e932 = select(_e453, _e902, (_e902 > _e453));
                                        let _e934 = select(_e453, _e904, (_e904 > _e453));
                                        let _e939 = (_e932 <= select(_e497.member_1, _e929, (_e929 < _e497.member_1)));
                                        let _e940 = (_e934 <= select(_e497.member_1, _e930, (_e930 < _e497.member_1)));
                                        let _e941 = (_e932 <= _e934);
                                        if _e939 {
                                            if _e940 {
                                                if _e941 {
                                                    phi_2956_ = _e839.member_2;
                                                } else {
                                                    phi_2956_ = _e839.member_1;
                                                }
                                                let _e945 = phi_2956_;
                                                let _e967 = (_e540 % 128u);
                                                let _e968 = (_e967 < 128u);
                                                if _e968 {
                                                } else {
                                                    phi_3434_ = true;
                                                    break;
                                                }
                                                local_8[_e967] = _e945.member_1;
                                                if _e968 {
                                                } else {
                                                    phi_3434_ = true;
                                                    break;
                                                }
                                                local_7[_e967] = _e945.member.member.x;
                                                if _e968 {
                                                } else {
                                                    phi_3434_ = true;
                                                    break;
                                                }
                                                local_6[_e967] = _e945.member.member.y;
                                                if _e968 {
                                                } else {
                                                    phi_3434_ = true;
                                                    break;
                                                }
                                                local_5[_e967] = _e945.member.member.z;
                                                if _e968 {
                                                } else {
                                                    phi_3434_ = true;
                                                    break;
                                                }
                                                local_4[_e967] = _e945.member.member_1.x;
                                                if _e968 {
                                                } else {
                                                    phi_3434_ = true;
                                                    break;
                                                }
                                                local_3[_e967] = _e945.member.member_1.y;
                                                if _e968 {
                                                } else {
                                                    phi_3434_ = true;
                                                    break;
                                                }
                                                local_2[_e967] = _e945.member.member_1.z;
                                                if _e968 {
                                                } else {
                                                    phi_3434_ = true;
                                                    break;
                                                }
                                                local_9[_e967] = select(_e934, _e932, (_e932 > _e934));
                                                if _e941 {
                                                    phi_3033_ = _e839.member_1;
                                                } else {
                                                    phi_3033_ = _e839.member_2;
                                                }
                                                let _e981 = phi_3033_;
                                                phi_3034_ = _e981;
                                                phi_3035_ = (_e540 + 1u);
                                            } else {
                                                phi_3034_ = type_50();
                                                phi_3035_ = u32();
                                            }
                                            let _e983 = phi_3034_;
                                            let _e985 = phi_3035_;
                                            phi_3037_ = _e983;
                                            phi_3038_ = _e985;
                                            phi_3039_ = select(true, false, _e940);
                                        } else {
                                            phi_3037_ = type_50();
                                            phi_3038_ = u32();
                                            phi_3039_ = true;
                                        }
                                        let _e988 = phi_3037_;
                                        let _e990 = phi_3038_;
                                        let _e992 = phi_3039_;
                                        if _e992 {
                                            if _e939 {
                                                phi_3048_ = _e839.member_1;
                                            } else {
                                                phi_3048_ = _e839.member_2;
                                            }
                                            let _e996 = phi_3048_;
                                            phi_3053_ = _e996;
                                            phi_3054_ = select(_e940, true, _e939);
                                        } else {
                                            phi_3053_ = _e988;
                                            phi_3054_ = _e538;
                                        }
                                        let _e999 = phi_3053_;
                                        let _e1001 = phi_3054_;
                                        phi_3438_ = _e495;
                                        phi_3056_ = _e497;
                                        phi_3057_ = _e999;
                                        phi_3058_ = _e1001;
                                        phi_3059_ = select(_e990, _e540, _e992);
                                    }
                                    let _e1412 = phi_3438_;
                                    let _e1414 = phi_3056_;
                                    let _e1416 = phi_3057_;
                                    let _e1418 = phi_3058_;
                                    let _e1420 = phi_3059_;
                                    phi_3437_ = _e1412;
                                    phi_3060_ = _e1414;
                                    phi_3061_ = _e1416;
                                    phi_3062_ = (_e501 - 1u);
                                    phi_3063_ = _e1418;
                                    phi_3064_ = _e1420;
                                } else {
                                    phi_3437_ = _e495;
                                    phi_3060_ = _e497;
                                    phi_3061_ = _e536;
                                    phi_3062_ = _e501;
                                    phi_3063_ = _e538;
                                    phi_3064_ = _e540;
                                }
                                let _e1422 = phi_3437_;
                                let _e1424 = phi_3060_;
                                let _e1426 = phi_3061_;
                                let _e1428 = phi_3062_;
                                let _e1430 = phi_3063_;
                                let _e1432 = phi_3064_;
                                phi_3436_ = _e1422;
                                phi_3065_ = _e1424;
                                phi_3066_ = _e1426;
                                phi_3067_ = _e1428;
                                phi_3068_ = _e1430;
                                phi_3069_ = _e1432;
                            } else {
                                phi_3436_ = _e495;
                                phi_3065_ = type_33();
                                phi_3066_ = type_50();
                                phi_3067_ = u32();
                                phi_3068_ = bool();
                                phi_3069_ = u32();
                            }
                            let _e1434 = phi_3436_;
                            let _e1436 = phi_3065_;
                            let _e1438 = phi_3066_;
                            let _e1440 = phi_3067_;
                            let _e1442 = phi_3068_;
                            let _e1444 = phi_3069_;
                            phi_3435_ = _e1434;
                            phi_838_ = _e1436;
                            phi_841_ = _e1438;
                            phi_843_ = _e1440;
                            phi_845_ = _e1442;
                            phi_847_ = _e1444;
                            phi_3070_ = _e509;
                        } else {
                            phi_3435_ = _e495;
                            phi_838_ = type_33();
                            phi_841_ = type_50();
                            phi_843_ = u32();
                            phi_845_ = bool();
                            phi_847_ = u32();
                            phi_3070_ = false;
                        }
                        let _e1446 = phi_3435_;
                        let _e1448 = phi_838_;
                        let _e1450 = phi_841_;
                        let _e1452 = phi_843_;
                        let _e1454 = phi_845_;
                        let _e1456 = phi_847_;
                        let _e1458 = phi_3070_;
                        continue;
                        continuing {
                            phi_3326_ = _e1446;
                            phi_837_ = _e1448;
                            phi_840_ = _e1450;
                            phi_842_ = _e1452;
                            phi_844_ = _e1454;
                            phi_846_ = _e1456;
                            phi_3434_ = _e1446;
                            break if !(_e1458);
                        }
                    }
                    let _e1461 = phi_3434_;
                    if _e1461 {
                        break;
                    }
                    let _e1463 = local_10;
                    if (_e1463.member.member_3 != 4294967295u) {
                        let _e1468 = -(_e420);
                        let _e1469 = (_e1468 / 3i);
                        let _e1476 = bitcast<f32>((bitcast<u32>((_e1469 + 127i)) << bitcast<u32>(23i)));
                        let _e1484 = (((_e1463.member.member * _e1476) * _e1476) * bitcast<f32>((bitcast<u32>(((_e1468 - (2i * _e1469)) + 127i)) << bitcast<u32>(23i))));
                        let _e1486 = select(340282350000000000000000000000000000000f, _e1484, (_e1484 < 340282350000000000000000000000000000000f));
                        phi_3122_ = type_21(select(-340282350000000000000000000000000000000f, _e1486, (_e1486 > -340282350000000000000000000000000000000f)), _e1463.member.member_1, _e1463.member.member_2, _e1463.member.member_3);
                    } else {
                        phi_3122_ = type_21(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                    }
                    let _e1493 = phi_3122_;
                    if _e141 {
                    } else {
                        break;
                    }
                    global_6.member[_e139] = _e1493;
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn trace_closest_q21_f32_(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
