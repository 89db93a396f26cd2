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

struct type_24 {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: u32,
}

struct type_25 {
    member: array<f32, 3>,
    member_1: f32,
    member_2: array<f32, 3>,
    member_3: f32,
}

struct type_28 {
    member: vec4<f32>,
    member_1: vec4<f32>,
}

struct type_36 {
    member: array<type_25>,
}

struct type_38 {
    member: f32,
    member_1: bool,
}

struct type_40 {
    member: array<vec4<u32>, 2>,
}

struct type_44 {
    member: array<array<u32, 7>>,
}

struct type_49 {
    member: type_28,
    member_1: u32,
}

struct type_50 {
    member: array<vec4<f32>, 3>,
    member_1: type_49,
    member_2: type_49,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_1: type_11;
@group(0) @binding(3) 
var<storage> global_2: type_18;
@group(0) @binding(1) 
var<uniform> global_3: type_40;
@group(0) @binding(4) 
var<storage> global_4: type_36;
@group(0) @binding(5) 
var<storage, read_write> global_5: type_4;
@group(0) @binding(2) 
var<storage> global_6: type_44;

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
    var phi_358_: i32;
    var phi_359_: i32;
    var phi_369_: bool;
    var phi_379_: u32;
    var phi_380_: u32;
    var phi_382_: bool;
    var phi_387_: u32;
    var phi_399_: i32;
    var phi_419_: i32;
    var phi_437_: f32;
    var phi_443_: f32;
    var phi_454_: f32;
    var phi_460_: f32;
    var phi_483_: f32;
    var phi_494_: f32;
    var phi_503_: f32;
    var phi_509_: f32;
    var phi_520_: f32;
    var phi_526_: f32;
    var phi_549_: f32;
    var phi_560_: f32;
    var phi_569_: f32;
    var phi_575_: f32;
    var phi_586_: f32;
    var phi_592_: f32;
    var phi_615_: f32;
    var phi_626_: f32;
    var phi_726_: f32;
    var phi_727_: f32;
    var phi_3111_: bool;
    var phi_816_: type_38;
    var phi_819_: type_49;
    var phi_821_: u32;
    var phi_823_: bool;
    var phi_825_: u32;
    var phi_836_: bool;
    var phi_922_: type_49;
    var phi_923_: bool;
    var phi_924_: u32;
    var phi_2389_: u32;
    var phi_2390_: u32;
    var phi_2400_: u32;
    var phi_2402_: u32;
    var phi_2403_: bool;
    var phi_2423_: u32;
    var phi_2424_: u32;
    var phi_2428_: type_50;
    var phi_2772_: type_49;
    var phi_2849_: type_49;
    var phi_2850_: type_49;
    var phi_2851_: u32;
    var phi_2853_: type_49;
    var phi_2854_: u32;
    var phi_2855_: bool;
    var phi_2864_: type_49;
    var phi_2869_: type_49;
    var phi_2870_: bool;
    var phi_942_: type_38;
    var phi_945_: type_7;
    var phi_946_: type_7;
    var phi_968_: type_7;
    var phi_989_: u32;
    var phi_1078_: array<array<f32, 3>, 3>;
    var phi_1549_: vec3<f32>;
    var phi_1550_: vec3<f32>;
    var phi_1581_: bool;
    var phi_1590_: vec3<f32>;
    var phi_1630_: type_24;
    var phi_1632_: type_24;
    var phi_1633_: bool;
    var phi_1637_: type_24;
    var phi_1638_: type_24;
    var phi_1639_: type_24;
    var phi_1640_: bool;
    var phi_1644_: type_24;
    var phi_1645_: bool;
    var phi_1649_: type_24;
    var phi_1650_: bool;
    var phi_1654_: type_24;
    var phi_1665_: type_38;
    var phi_1666_: type_38;
    var phi_943_: type_38;
    var phi_3105_: bool;
    var local_10: type_38;
    var phi_3220_: bool;
    var phi_2872_: type_38;
    var phi_2873_: type_49;
    var phi_2874_: bool;
    var phi_2875_: u32;
    var phi_3219_: bool;
    var phi_2876_: type_38;
    var phi_2877_: type_49;
    var phi_2878_: u32;
    var phi_2879_: bool;
    var phi_2880_: u32;
    var phi_3218_: bool;
    var phi_2881_: type_38;
    var phi_2882_: type_49;
    var phi_2883_: u32;
    var phi_2884_: bool;
    var phi_2885_: u32;
    var phi_3217_: bool;
    var phi_817_: type_38;
    var phi_820_: type_49;
    var phi_822_: u32;
    var phi_824_: bool;
    var phi_826_: u32;
    var phi_2886_: bool;
    var phi_3216_: bool;
    var local_11: type_38;
    var local_12: type_38;

    switch bitcast<i32>(0u) {
        default: {
            let _e81 = global;
            let _e83 = arrayLength((&global_6.member));
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
                let _e141 = (_e139 < arrayLength((&global_5.member)));
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
                            phi_358_ = (bitcast<i32>((_e218 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_358_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e218)), 32u, (_e218 == 0u))));
                        }
                        let _e232 = phi_358_;
                        phi_359_ = _e232;
                    } else {
                        phi_359_ = 0i;
                    }
                    let _e234 = phi_359_;
                    let _e235 = (_e151 == _e190);
                    if _e235 {
                        phi_369_ = true;
                    } else {
                        phi_369_ = (_e158 == _e190);
                    }
                    let _e238 = phi_369_;
                    let _e239 = select(1u, 0u, _e235);
                    if _e238 {
                        let _e240 = (_e239 + 1u);
                        phi_379_ = _e240;
                        phi_380_ = _e240;
                        phi_382_ = select(true, false, (_e240 == 2u));
                    } else {
                        phi_379_ = u32();
                        phi_380_ = 0u;
                        phi_382_ = true;
                    }
                    let _e244 = phi_379_;
                    let _e246 = phi_380_;
                    let _e248 = phi_382_;
                    if _e248 {
                        phi_387_ = (_e246 + 1u);
                    } else {
                        phi_387_ = 0u;
                    }
                    let _e252 = phi_387_;
                    let _e253 = select(_e244, _e246, _e248);
                    let _e254 = select(_e239, select(2u, _e239, _e238), _e248);
                    if (_e121 < -126i) {
                        phi_399_ = -126i;
                    } else {
                        phi_399_ = select(_e121, 127i, (_e121 > 127i));
                    }
                    let _e259 = phi_399_;
                    let _e264 = bitcast<f32>((bitcast<u32>((_e259 + 127i)) << bitcast<u32>(23i)));
                    let _e270 = bitcast<f32>((bitcast<u32>(((_e121 - _e259) + 127i)) << bitcast<u32>(23i)));
                    let _e271 = -(_e234);
                    if (_e271 < -126i) {
                        phi_419_ = -126i;
                    } else {
                        phi_419_ = select(_e271, 127i, (_e271 > 127i));
                    }
                    let _e276 = phi_419_;
                    let _e281 = bitcast<f32>((bitcast<u32>((_e276 + 127i)) << bitcast<u32>(23i)));
                    let _e287 = bitcast<f32>((bitcast<u32>(((_e271 - _e276) + 127i)) << bitcast<u32>(23i)));
                    let _e291 = global_4.member[_e139].member;
                    let _e292 = (_e253 == 0u);
                    if _e292 {
                        phi_437_ = _e291[0];
                    } else {
                        phi_437_ = _e291[1];
                    }
                    let _e296 = phi_437_;
                    let _e297 = (_e253 == 2u);
                    if _e297 {
                        phi_443_ = _e291[2];
                    } else {
                        phi_443_ = _e296;
                    }
                    let _e300 = phi_443_;
                    let _e302 = ((_e300 * _e264) * _e270);
                    let _e303 = global_4.member[_e139].member_2;
                    if _e292 {
                        phi_454_ = _e303[0];
                    } else {
                        phi_454_ = _e303[1];
                    }
                    let _e307 = phi_454_;
                    if _e297 {
                        phi_460_ = _e303[2];
                    } else {
                        phi_460_ = _e307;
                    }
                    let _e310 = phi_460_;
                    let _e312 = ((_e310 * _e281) * _e287);
                    let _e316 = (bitcast<f32>((bitcast<u32>(_e312) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e316 {
                        let _e320 = (bitcast<f32>((bitcast<u32>(_e302) & 2147483647u)) * 0.00000011920929f);
                        phi_483_ = select(0.00000000000011368684f, _e320, (_e320 > 0.00000000000011368684f));
                    } else {
                        phi_483_ = 0f;
                    }
                    let _e324 = phi_483_;
                    let _e325 = (_e302 + _e324);
                    let _e326 = (_e302 - _e324);
                    let _e327 = select(_e312, 0f, _e316);
                    if _e316 {
                        phi_494_ = 38685626000000000000000000f;
                    } else {
                        phi_494_ = (1f / _e312);
                    }
                    let _e330 = phi_494_;
                    let _e331 = (_e252 == 0u);
                    if _e331 {
                        phi_503_ = _e291[0];
                    } else {
                        phi_503_ = _e291[1];
                    }
                    let _e335 = phi_503_;
                    let _e336 = (_e252 == 2u);
                    if _e336 {
                        phi_509_ = _e291[2];
                    } else {
                        phi_509_ = _e335;
                    }
                    let _e339 = phi_509_;
                    let _e341 = ((_e339 * _e264) * _e270);
                    if _e331 {
                        phi_520_ = _e303[0];
                    } else {
                        phi_520_ = _e303[1];
                    }
                    let _e345 = phi_520_;
                    if _e336 {
                        phi_526_ = _e303[2];
                    } else {
                        phi_526_ = _e345;
                    }
                    let _e348 = phi_526_;
                    let _e350 = ((_e348 * _e281) * _e287);
                    let _e354 = (bitcast<f32>((bitcast<u32>(_e350) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e354 {
                        let _e358 = (bitcast<f32>((bitcast<u32>(_e341) & 2147483647u)) * 0.00000011920929f);
                        phi_549_ = select(0.00000000000011368684f, _e358, (_e358 > 0.00000000000011368684f));
                    } else {
                        phi_549_ = 0f;
                    }
                    let _e362 = phi_549_;
                    let _e363 = (_e341 + _e362);
                    let _e364 = (_e341 - _e362);
                    let _e365 = select(_e350, 0f, _e354);
                    if _e354 {
                        phi_560_ = 38685626000000000000000000f;
                    } else {
                        phi_560_ = (1f / _e350);
                    }
                    let _e368 = phi_560_;
                    let _e369 = (_e254 == 0u);
                    if _e369 {
                        phi_569_ = _e291[0];
                    } else {
                        phi_569_ = _e291[1];
                    }
                    let _e373 = phi_569_;
                    let _e374 = (_e254 == 2u);
                    if _e374 {
                        phi_575_ = _e291[2];
                    } else {
                        phi_575_ = _e373;
                    }
                    let _e377 = phi_575_;
                    let _e379 = ((_e377 * _e264) * _e270);
                    if _e369 {
                        phi_586_ = _e303[0];
                    } else {
                        phi_586_ = _e303[1];
                    }
                    let _e383 = phi_586_;
                    if _e374 {
                        phi_592_ = _e303[2];
                    } else {
                        phi_592_ = _e383;
                    }
                    let _e386 = phi_592_;
                    let _e388 = ((_e386 * _e281) * _e287);
                    let _e392 = (bitcast<f32>((bitcast<u32>(_e388) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e392 {
                        let _e396 = (bitcast<f32>((bitcast<u32>(_e379) & 2147483647u)) * 0.00000011920929f);
                        phi_615_ = select(0.00000000000011368684f, _e396, (_e396 > 0.00000000000011368684f));
                    } else {
                        phi_615_ = 0f;
                    }
                    let _e400 = phi_615_;
                    let _e401 = (_e379 + _e400);
                    let _e402 = (_e379 - _e400);
                    let _e403 = select(_e388, 0f, _e392);
                    if _e392 {
                        phi_626_ = 38685626000000000000000000f;
                    } else {
                        phi_626_ = (1f / _e388);
                    }
                    let _e406 = phi_626_;
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
                        phi_726_ = select(-340282350000000000000000000000000000000f, _e447, (_e447 > -340282350000000000000000000000000000000f));
                        phi_727_ = select(-340282350000000000000000000000000000000f, _e440, (_e440 > -340282350000000000000000000000000000000f));
                    } else {
                        phi_726_ = 0f;
                        phi_727_ = 1f;
                    }
                    let _e451 = phi_726_;
                    let _e453 = phi_727_;
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
                    phi_3111_ = false;
                    phi_816_ = type_38(_e451, false);
                    phi_819_ = type_49(type_28(vec4<f32>((f32(_e460) * _e133), (f32(_e466) * _e133), (f32(_e472) * _e133), 0f), vec4<f32>((f32(_e477) * _e133), (f32(_e481) * _e133), (f32(_e485) * _e133), 0f)), select(0u, 2147483648u, (_e83 == 0u)));
                    phi_821_ = ((3u * _e83) + 1u);
                    phi_823_ = (_e453 <= _e451);
                    phi_825_ = 0u;
                    loop {
                        let _e495 = phi_3111_;
                        let _e497 = phi_816_;
                        let _e499 = phi_819_;
                        let _e501 = phi_821_;
                        let _e503 = phi_823_;
                        let _e505 = phi_825_;
                        local_11 = _e497;
                        if _e503 {
                            phi_836_ = true;
                        } else {
                            phi_836_ = (_e505 > 0u);
                        }
                        let _e508 = phi_836_;
                        if _e508 {
                            let _e509 = (_e501 > 0u);
                            if _e509 {
                                if _e503 {
                                    phi_922_ = _e499;
                                    phi_923_ = _e503;
                                    phi_924_ = _e505;
                                } else {
                                    let _e510 = (_e505 - 1u);
                                    let _e511 = (_e510 % 128u);
                                    let _e512 = (_e511 < 128u);
                                    if _e512 {
                                    } else {
                                        phi_3216_ = true;
                                        break;
                                    }
                                    let _e514 = local_7[_e511];
                                    if _e512 {
                                    } else {
                                        phi_3216_ = true;
                                        break;
                                    }
                                    let _e516 = local_6[_e511];
                                    if _e512 {
                                    } else {
                                        phi_3216_ = true;
                                        break;
                                    }
                                    let _e518 = local_5[_e511];
                                    if _e512 {
                                    } else {
                                        phi_3216_ = true;
                                        break;
                                    }
                                    let _e520 = local_4[_e511];
                                    if _e512 {
                                    } else {
                                        phi_3216_ = true;
                                        break;
                                    }
                                    let _e522 = local_3[_e511];
                                    if _e512 {
                                    } else {
                                        phi_3216_ = true;
                                        break;
                                    }
                                    let _e524 = local_2[_e511];
                                    if _e512 {
                                    } else {
                                        phi_3216_ = true;
                                        break;
                                    }
                                    let _e529 = local_8[_e511];
                                    if _e512 {
                                    } else {
                                        phi_3216_ = true;
                                        break;
                                    }
                                    let _e532 = local_9[_e511];
                                    phi_922_ = type_49(type_28(vec4<f32>(_e514, _e516, _e518, 0f), vec4<f32>(_e520, _e522, _e524, 0f)), _e529);
                                    phi_923_ = (_e532 <= _e497.member);
                                    phi_924_ = _e510;
                                }
                                let _e536 = phi_922_;
                                let _e538 = phi_923_;
                                let _e540 = phi_924_;
                                if _e538 {
                                    if ((_e536.member_1 & 2147483648u) != 0u) {
                                        phi_942_ = _e497;
                                        phi_945_ = type_7(0u, ((_e536.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e1002 = phi_942_;
                                            let _e1004 = phi_945_;
                                            local_10 = _e1002;
                                            local_12 = _e1002;
                                            if (_e1004.member < _e1004.member_1) {
                                                phi_946_ = type_7((_e1004.member + 1u), _e1004.member_1);
                                                phi_968_ = type_7(1u, _e1004.member);
                                            } else {
                                                phi_946_ = _e1004;
                                                phi_968_ = type_7(0u, type_7().member_1);
                                            }
                                            let _e1017 = phi_946_;
                                            let _e1019 = phi_968_;
                                            let _e1023 = (bitcast<i32>(_e1019.member) != 0i);
                                            if _e1023 {
                                                let _e1024 = ((_e536.member_1 & 268435455u) + _e1019.member_1);
                                                let _e1025 = (_e1024 < _e85);
                                                if _e1025 {
                                                    if _e1025 {
                                                    } else {
                                                        phi_3105_ = true;
                                                        break;
                                                    }
                                                    let _e1029 = global_2.member[_e1024].member_1;
                                                    phi_989_ = _e1029;
                                                } else {
                                                    phi_989_ = 4294967295u;
                                                }
                                                let _e1031 = phi_989_;
                                                if (_e1024 >= _e85) {
                                                    phi_1078_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                } else {
                                                    if _e1025 {
                                                    } else {
                                                        phi_3105_ = true;
                                                        break;
                                                    }
                                                    if (_e457 < 9u) {
                                                    } else {
                                                        phi_3105_ = true;
                                                        break;
                                                    }
                                                    let _e1038 = global_2.member[_e1024].member[_e457];
                                                    if (_e463 < 9u) {
                                                    } else {
                                                        phi_3105_ = true;
                                                        break;
                                                    }
                                                    let _e1044 = global_2.member[_e1024].member[_e463];
                                                    if (_e469 < 9u) {
                                                    } else {
                                                        phi_3105_ = true;
                                                        break;
                                                    }
                                                    let _e1050 = global_2.member[_e1024].member[_e469];
                                                    let _e1052 = (3u + _e457);
                                                    if (_e1052 < 9u) {
                                                    } else {
                                                        phi_3105_ = true;
                                                        break;
                                                    }
                                                    let _e1058 = global_2.member[_e1024].member[_e1052];
                                                    let _e1059 = (3u + _e463);
                                                    if (_e1059 < 9u) {
                                                    } else {
                                                        phi_3105_ = true;
                                                        break;
                                                    }
                                                    let _e1065 = global_2.member[_e1024].member[_e1059];
                                                    let _e1066 = (3u + _e469);
                                                    if (_e1066 < 9u) {
                                                    } else {
                                                        phi_3105_ = true;
                                                        break;
                                                    }
                                                    let _e1072 = global_2.member[_e1024].member[_e1066];
                                                    let _e1074 = (6u + _e457);
                                                    if (_e1074 < 9u) {
                                                    } else {
                                                        phi_3105_ = true;
                                                        break;
                                                    }
                                                    let _e1080 = global_2.member[_e1024].member[_e1074];
                                                    let _e1081 = (6u + _e463);
                                                    if (_e1081 < 9u) {
                                                    } else {
                                                        phi_3105_ = true;
                                                        break;
                                                    }
                                                    let _e1087 = global_2.member[_e1024].member[_e1081];
                                                    let _e1088 = (6u + _e469);
                                                    if (_e1088 < 9u) {
                                                    } else {
                                                        phi_3105_ = true;
                                                        break;
                                                    }
                                                    let _e1094 = global_2.member[_e1024].member[_e1088];
                                                    phi_1078_ = array<array<f32, 3>, 3>(array<f32, 3>(_e1038, _e1044, _e1050), array<f32, 3>(_e1058, _e1065, _e1072), array<f32, 3>(_e1080, _e1087, _e1094));
                                                }
                                                let _e1098 = phi_1078_;
                                                let _e1106 = (_e1098[0][2] - _e379);
                                                let _e1109 = (((_e1098[0][0] - _e302) * _e403) - (_e1106 * _e327));
                                                let _e1112 = (((_e1098[0][1] - _e341) * _e403) - (_e1106 * _e365));
                                                let _e1119 = (_e1098[1][2] - _e379);
                                                let _e1122 = (((_e1098[1][0] - _e302) * _e403) - (_e1119 * _e327));
                                                let _e1125 = (((_e1098[1][1] - _e341) * _e403) - (_e1119 * _e365));
                                                let _e1132 = (_e1098[2][2] - _e379);
                                                let _e1135 = (((_e1098[2][0] - _e302) * _e403) - (_e1132 * _e327));
                                                let _e1138 = (((_e1098[2][1] - _e341) * _e403) - (_e1132 * _e365));
                                                let _e1139 = (_e1135 * _e1125);
                                                let _e1140 = (_e1138 * _e1122);
                                                let _e1141 = (_e1109 * _e1138);
                                                let _e1142 = (_e1112 * _e1135);
                                                let _e1143 = (_e1122 * _e1112);
                                                let _e1144 = (_e1125 * _e1109);
                                                let _e1149 = (((_e1139 >= _e1140) && (_e1141 >= _e1142)) && (_e1143 >= _e1144));
                                                if (_e1149 || (((_e1139 <= _e1140) && (_e1141 <= _e1142)) && (_e1143 <= _e1144))) {
                                                    let _e1156 = select(-1f, 1f, _e1149);
                                                    let _e1158 = ((_e1139 - _e1140) * _e1156);
                                                    let _e1160 = select(0f, _e1158, (_e1158 > 0f));
                                                    let _e1162 = ((_e1141 - _e1142) * _e1156);
                                                    let _e1164 = select(0f, _e1162, (_e1162 > 0f));
                                                    let _e1166 = ((_e1143 - _e1144) * _e1156);
                                                    let _e1168 = select(0f, _e1166, (_e1166 > 0f));
                                                    let _e1170 = ((_e1160 + _e1164) + _e1168);
                                                    if (_e1170 < 0.000000000000000000000000000000000000011754944f) {
                                                        phi_1644_ = type_24();
                                                        phi_1645_ = true;
                                                    } else {
                                                        let _e1173 = select(_e1098[1][0], _e1098[0][0], (_e1098[0][0] < _e1098[1][0]));
                                                        let _e1177 = select(_e1098[1][0], _e1098[0][0], (_e1098[0][0] > _e1098[1][0]));
                                                        let _e1181 = select(_e1098[1][1], _e1098[0][1], (_e1098[0][1] < _e1098[1][1]));
                                                        let _e1185 = select(_e1098[1][1], _e1098[0][1], (_e1098[0][1] > _e1098[1][1]));
                                                        let _e1189 = select(_e1098[1][2], _e1098[0][2], (_e1098[0][2] < _e1098[1][2]));
                                                        let _e1193 = select(_e1098[1][2], _e1098[0][2], (_e1098[0][2] > _e1098[1][2]));
                                                        let _e1198 = ((select(_e1098[2][0], _e1173, (_e1173 < _e1098[2][0])) - _e325) * _e330);
                                                        let _e1199 = ((select(_e1098[2][0], _e1177, (_e1177 > _e1098[2][0])) - _e326) * _e330);
                                                        let _e1202 = ((select(_e1098[2][1], _e1181, (_e1181 < _e1098[2][1])) - _e363) * _e368);
                                                        let _e1203 = ((select(_e1098[2][1], _e1185, (_e1185 > _e1098[2][1])) - _e364) * _e368);
                                                        let _e1206 = ((select(_e1098[2][2], _e1189, (_e1189 < _e1098[2][2])) - _e401) * _e406);
                                                        let _e1207 = ((select(_e1098[2][2], _e1193, (_e1193 > _e1098[2][2])) - _e402) * _e406);
                                                        let _e1209 = select(_e1207, _e1206, (_e1206 < _e1207));
                                                        let _e1211 = select(_e1207, _e1206, (_e1206 > _e1207));
                                                        let _e1213 = select(_e1199, _e1198, (_e1198 < _e1199));
                                                        let _e1215 = select(_e1203, _e1202, (_e1202 < _e1203));
                                                        let _e1217 = select(_e1215, _e1213, (_e1213 > _e1215));
                                                        let _e1219 = select(_e1209, _e1217, (_e1217 > _e1209));
                                                        let _e1221 = select(_e1199, _e1198, (_e1198 > _e1199));
                                                        let _e1223 = select(_e1203, _e1202, (_e1202 > _e1203));
                                                        let _e1225 = select(_e1223, _e1221, (_e1221 < _e1223));
                                                        let _e1227 = select(_e1211, _e1225, (_e1225 < _e1211));
                                                        let _e1228 = -(_e1209);
                                                        let _e1234 = select(_e453, _e1219, (_e1219 > _e453));
                                                        if (_e1234 > (_e1227 + (select(_e1228, _e1211, (_e1211 > _e1228)) * 0.0000019073523f))) {
                                                            phi_1639_ = type_24();
                                                            phi_1640_ = true;
                                                        } else {
                                                            let _e1236 = (_e1234 > _e1002.member);
                                                            if _e1236 {
                                                                phi_1638_ = type_24();
                                                            } else {
                                                                let _e1240 = (_e1098[1][0] - _e1098[0][0]);
                                                                let _e1241 = (_e1098[1][1] - _e1098[0][1]);
                                                                let _e1242 = (_e1098[1][2] - _e1098[0][2]);
                                                                let _e1243 = vec3<f32>(_e1240, _e1241, _e1242);
                                                                let _e1244 = (_e1098[2][0] - _e1098[1][0]);
                                                                let _e1245 = (_e1098[2][1] - _e1098[1][1]);
                                                                let _e1246 = (_e1098[2][2] - _e1098[1][2]);
                                                                let _e1247 = vec3<f32>(_e1244, _e1245, _e1246);
                                                                let _e1248 = (_e1098[0][0] - _e1098[2][0]);
                                                                let _e1249 = (_e1098[0][1] - _e1098[2][1]);
                                                                let _e1250 = (_e1098[0][2] - _e1098[2][2]);
                                                                let _e1251 = vec3<f32>(_e1248, _e1249, _e1250);
                                                                let _e1254 = bitcast<f32>((bitcast<u32>(_e1240) & 2147483647u));
                                                                let _e1257 = bitcast<f32>((bitcast<u32>(_e1241) & 2147483647u));
                                                                let _e1259 = select(_e1257, _e1254, (_e1254 > _e1257));
                                                                let _e1262 = bitcast<f32>((bitcast<u32>(_e1242) & 2147483647u));
                                                                let _e1264 = select(_e1262, _e1259, (_e1259 > _e1262));
                                                                let _e1267 = bitcast<f32>((bitcast<u32>(_e1244) & 2147483647u));
                                                                let _e1270 = bitcast<f32>((bitcast<u32>(_e1245) & 2147483647u));
                                                                let _e1272 = select(_e1270, _e1267, (_e1267 > _e1270));
                                                                let _e1275 = bitcast<f32>((bitcast<u32>(_e1246) & 2147483647u));
                                                                let _e1277 = select(_e1275, _e1272, (_e1272 > _e1275));
                                                                let _e1280 = bitcast<f32>((bitcast<u32>(_e1248) & 2147483647u));
                                                                let _e1283 = bitcast<f32>((bitcast<u32>(_e1249) & 2147483647u));
                                                                let _e1285 = select(_e1283, _e1280, (_e1280 > _e1283));
                                                                let _e1288 = bitcast<f32>((bitcast<u32>(_e1250) & 2147483647u));
                                                                let _e1290 = select(_e1288, _e1285, (_e1285 > _e1288));
                                                                let _e1292 = select(_e1277, _e1264, (_e1264 > _e1277));
                                                                let _e1294 = select(_e1290, _e1292, (_e1292 > _e1290));
                                                                if (_e1264 == _e1294) {
                                                                    phi_1549_ = _e1247;
                                                                    phi_1550_ = _e1251;
                                                                } else {
                                                                    let _e1297 = vec3((_e1277 == _e1294));
                                                                    phi_1549_ = select(_e1243, _e1251, _e1297);
                                                                    phi_1550_ = select(_e1247, _e1243, _e1297);
                                                                }
                                                                let _e1301 = phi_1549_;
                                                                let _e1303 = phi_1550_;
                                                                let _e1310 = ((_e1301.y * _e1303.z) - (_e1303.y * _e1301.z));
                                                                let _e1315 = ((_e1301.z * _e1303.x) - (_e1303.z * _e1301.x));
                                                                let _e1318 = ((_e1301.x * _e1303.y) - (_e1303.x * _e1301.y));
                                                                if (_e1160 >= _e1164) {
                                                                    phi_1581_ = select(true, false, (_e1160 >= _e1168));
                                                                } else {
                                                                    phi_1581_ = true;
                                                                }
                                                                let _e1323 = phi_1581_;
                                                                if _e1323 {
                                                                    phi_1590_ = select(vec3<f32>(_e1098[2][0], _e1098[2][1], _e1098[2][2]), vec3<f32>(_e1098[1][0], _e1098[1][1], _e1098[1][2]), vec3((_e1164 >= _e1168)));
                                                                } else {
                                                                    phi_1590_ = vec3<f32>(_e1098[0][0], _e1098[0][1], _e1098[0][2]);
                                                                }
                                                                let _e1328 = phi_1590_;
                                                                let _e1345 = ((((_e1310 * (_e1328.x - _e302)) + (_e1315 * (_e1328.y - _e341))) + (_e1318 * (_e1328.z - _e379))) / (((_e1310 * _e327) + (_e1315 * _e365)) + (_e1318 * _e403)));
                                                                let _e1347 = select(_e1227, _e1345, (_e1345 < _e1227));
                                                                let _e1349 = select(_e1219, _e1347, (_e1347 > _e1219));
                                                                if (_e1349 >= _e453) {
                                                                    let _e1351 = (_e1349 <= _e1002.member);
                                                                    if _e1351 {
                                                                        let _e1352 = (1f / _e1170);
                                                                        phi_1630_ = type_24(_e1349, (_e1164 * _e1352), (_e1168 * _e1352), _e1031);
                                                                    } else {
                                                                        phi_1630_ = type_24();
                                                                    }
                                                                    let _e1357 = phi_1630_;
                                                                    phi_1632_ = _e1357;
                                                                    phi_1633_ = select(true, false, _e1351);
                                                                } else {
                                                                    phi_1632_ = type_24();
                                                                    phi_1633_ = true;
                                                                }
                                                                let _e1360 = phi_1632_;
                                                                let _e1362 = phi_1633_;
                                                                if _e1362 {
                                                                    phi_1637_ = type_24(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                } else {
                                                                    phi_1637_ = _e1360;
                                                                }
                                                                let _e1364 = phi_1637_;
                                                                phi_1638_ = _e1364;
                                                            }
                                                            let _e1366 = phi_1638_;
                                                            phi_1639_ = _e1366;
                                                            phi_1640_ = _e1236;
                                                        }
                                                        let _e1368 = phi_1639_;
                                                        let _e1370 = phi_1640_;
                                                        phi_1644_ = _e1368;
                                                        phi_1645_ = _e1370;
                                                    }
                                                    let _e1372 = phi_1644_;
                                                    let _e1374 = phi_1645_;
                                                    phi_1649_ = _e1372;
                                                    phi_1650_ = _e1374;
                                                } else {
                                                    phi_1649_ = type_24();
                                                    phi_1650_ = true;
                                                }
                                                let _e1376 = phi_1649_;
                                                let _e1378 = phi_1650_;
                                                if _e1378 {
                                                    phi_1654_ = type_24(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                } else {
                                                    phi_1654_ = _e1376;
                                                }
                                                let _e1380 = phi_1654_;
                                                if (_e1380.member_3 != 4294967295u) {
                                                    if (_e1031 != 4294967295u) {
                                                        phi_1665_ = type_38(_e1002.member, true);
                                                    } else {
                                                        phi_1665_ = _e1002;
                                                    }
                                                    let _e1388 = phi_1665_;
                                                    phi_1666_ = _e1388;
                                                } else {
                                                    phi_1666_ = _e1002;
                                                }
                                                let _e1390 = phi_1666_;
                                                phi_943_ = _e1390;
                                            } else {
                                                phi_943_ = type_38();
                                            }
                                            let _e1392 = phi_943_;
                                            continue;
                                            continuing {
                                                phi_942_ = _e1392;
                                                phi_945_ = _e1017;
                                                phi_3105_ = _e495;
                                                break if !(_e1023);
                                            }
                                        }
                                        let _e1395 = phi_3105_;
                                        phi_3216_ = _e1395;
                                        if _e1395 {
                                            break;
                                        }
                                        let _e1397 = local_10;
                                        phi_3220_ = _e1395;
                                        let _e1544 = local_12;
                                        phi_2872_ = _e1544;
                                        phi_2873_ = _e536;
                                        phi_2874_ = false;
                                        phi_2875_ = select(_e540, 0u, _e1397.member_1);
                                    } else {
                                        if (_e536.member_1 >= _e83) {
                                            phi_2428_ = type_50(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), type_49(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u), type_49(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u));
                                        } else {
                                            if (_e536.member_1 < _e83) {
                                            } else {
                                                phi_3216_ = true;
                                                break;
                                            }
                                            let _e551 = (_e253 * 2u);
                                            let _e553 = ((1u + _e551) % 7u);
                                            if (_e553 < 7u) {
                                            } else {
                                                phi_3216_ = true;
                                                break;
                                            }
                                            let _e558 = global_6.member[_e536.member_1][_e553];
                                            let _e560 = ((_e551 + 2u) % 7u);
                                            if (_e560 < 7u) {
                                            } else {
                                                phi_3216_ = true;
                                                break;
                                            }
                                            let _e565 = global_6.member[_e536.member_1][_e560];
                                            let _e566 = (_e252 * 2u);
                                            let _e568 = ((1u + _e566) % 7u);
                                            if (_e568 < 7u) {
                                            } else {
                                                phi_3216_ = true;
                                                break;
                                            }
                                            let _e573 = global_6.member[_e536.member_1][_e568];
                                            let _e575 = ((_e566 + 2u) % 7u);
                                            if (_e575 < 7u) {
                                            } else {
                                                phi_3216_ = true;
                                                break;
                                            }
                                            let _e580 = global_6.member[_e536.member_1][_e575];
                                            let _e581 = (_e254 * 2u);
                                            let _e583 = ((1u + _e581) % 7u);
                                            if (_e583 < 7u) {
                                            } else {
                                                phi_3216_ = true;
                                                break;
                                            }
                                            let _e588 = global_6.member[_e536.member_1][_e583];
                                            let _e590 = ((_e581 + 2u) % 7u);
                                            if (_e590 < 7u) {
                                            } else {
                                                phi_3216_ = true;
                                                break;
                                            }
                                            let _e595 = global_6.member[_e536.member_1][_e590];
                                            let _e618 = (bitcast<f32>((bitcast<u32>((_e536.member.member_1.x - _e536.member.member.x)) & 2139095040u)) * 0.0000009536743f);
                                            let _e619 = (bitcast<f32>((bitcast<u32>((_e536.member.member_1.y - _e536.member.member.y)) & 2139095040u)) * 0.0000009536743f);
                                            let _e620 = (bitcast<f32>((bitcast<u32>((_e536.member.member_1.z - _e536.member.member.z)) & 2139095040u)) * 0.0000009536743f);
                                            let _e622 = select(_e133, _e618, (_e618 > _e133));
                                            let _e624 = select(_e133, _e619, (_e619 > _e133));
                                            let _e626 = select(_e133, _e620, (_e620 > _e133));
                                            let _e651 = bitcast<u32>((f32(bitcast<i32>((_e558 & 2097151u))) * _e622));
                                            let _e656 = (bitcast<i32>((_e558 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e659 = bitcast<f32>((_e651 & bitcast<u32>(_e656)));
                                            let _e660 = bitcast<u32>((f32(bitcast<i32>((_e573 & 2097151u))) * _e624));
                                            let _e665 = (bitcast<i32>((_e573 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e668 = bitcast<f32>((_e660 & bitcast<u32>(_e665)));
                                            let _e669 = bitcast<u32>((f32(bitcast<i32>((_e588 & 2097151u))) * _e626));
                                            let _e674 = (bitcast<i32>((_e588 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e677 = bitcast<f32>((_e669 & bitcast<u32>(_e674)));
                                            let _e681 = bitcast<f32>((_e651 & bitcast<u32>(~(_e656))));
                                            let _e685 = bitcast<f32>((_e660 & bitcast<u32>(~(_e665))));
                                            let _e689 = bitcast<f32>((_e669 & bitcast<u32>(~(_e674))));
                                            let _e690 = bitcast<u32>((f32(bitcast<i32>((_e565 & 2097151u))) * _e622));
                                            let _e695 = (bitcast<i32>((_e565 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e698 = bitcast<f32>((_e690 & bitcast<u32>(_e695)));
                                            let _e699 = bitcast<u32>((f32(bitcast<i32>((_e580 & 2097151u))) * _e624));
                                            let _e704 = (bitcast<i32>((_e580 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e707 = bitcast<f32>((_e699 & bitcast<u32>(_e704)));
                                            let _e708 = bitcast<u32>((f32(bitcast<i32>((_e595 & 2097151u))) * _e626));
                                            let _e713 = (bitcast<i32>((_e595 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e716 = bitcast<f32>((_e708 & bitcast<u32>(_e713)));
                                            let _e720 = bitcast<f32>((_e690 & bitcast<u32>(~(_e695))));
                                            let _e724 = bitcast<f32>((_e699 & bitcast<u32>(~(_e704))));
                                            let _e728 = bitcast<f32>((_e708 & bitcast<u32>(~(_e713))));
                                            let _e758 = global_6.member[_e536.member_1][0u];
                                            let _e762 = global_6.member[_e536.member_1][2u];
                                            let _e766 = global_6.member[_e536.member_1][4u];
                                            let _e770 = global_6.member[_e536.member_1][6u];
                                            let _e782 = (((_e762 >> bitcast<u32>(22i)) | ((_e766 >> bitcast<u32>(22i)) << bitcast<u32>(10i))) | ((_e770 >> bitcast<u32>(22i)) << bitcast<u32>(20i)));
                                            let _e783 = (_e758 & 268435455u);
                                            let _e784 = (_e782 & 268435455u);
                                            let _e787 = ((_e758 >> bitcast<u32>(28u)) & 7u);
                                            let _e795 = ((_e758 >> bitcast<u32>(31i)) | (((_e782 >> bitcast<u32>(28u)) & 3u) << bitcast<u32>(1i)));
                                            let _e796 = (_e787 != 0u);
                                            if (_e787 == 0u) {
                                                phi_2390_ = _e783;
                                            } else {
                                                if (_e787 == 7u) {
                                                    phi_2389_ = 2147483648u;
                                                } else {
                                                    phi_2389_ = ((2147483648u | (_e787 << bitcast<u32>(28u))) | (_e784 & 268435455u));
                                                }
                                                let _e805 = phi_2389_;
                                                phi_2390_ = _e805;
                                            }
                                            let _e807 = phi_2390_;
                                            if _e796 {
                                                let _e808 = (_e787 != 7u);
                                                if _e808 {
                                                    phi_2400_ = (_e784 + _e787);
                                                } else {
                                                    phi_2400_ = u32();
                                                }
                                                let _e811 = phi_2400_;
                                                phi_2402_ = _e811;
                                                phi_2403_ = select(true, false, _e808);
                                            } else {
                                                phi_2402_ = u32();
                                                phi_2403_ = true;
                                            }
                                            let _e814 = phi_2402_;
                                            let _e816 = phi_2403_;
                                            if (_e795 == 0u) {
                                                phi_2424_ = (_e783 + select(0u, 1u, !(_e796)));
                                            } else {
                                                if (_e795 == 7u) {
                                                    phi_2423_ = 2147483648u;
                                                } else {
                                                    phi_2423_ = ((2147483648u | (_e795 << bitcast<u32>(28u))) | (select(_e814, _e784, _e816) & 268435455u));
                                                }
                                                let _e829 = phi_2423_;
                                                phi_2424_ = _e829;
                                            }
                                            let _e831 = phi_2424_;
                                            phi_2428_ = type_50(array<vec4<f32>, 3>(vec4<f32>((_e536.member.member.x + _e659), (_e536.member.member.x + _e681), (_e536.member.member_1.x - _e698), (_e536.member.member_1.x - _e720)), vec4<f32>((_e536.member.member.y + _e668), (_e536.member.member.y + _e685), (_e536.member.member_1.y - _e707), (_e536.member.member_1.y - _e724)), vec4<f32>((_e536.member.member.z + _e677), (_e536.member.member.z + _e689), (_e536.member.member_1.z - _e716), (_e536.member.member_1.z - _e728))), type_49(type_28((_e536.member.member + vec4<f32>(_e659, _e668, _e677, 0f)), (_e536.member.member_1 - vec4<f32>(_e698, _e707, _e716, 0f))), _e807), type_49(type_28((_e536.member.member + vec4<f32>(_e681, _e685, _e689, 0f)), (_e536.member.member_1 - vec4<f32>(_e720, _e724, _e728, 0f))), _e831));
                                        }
                                        let _e836 = phi_2428_;
                                        let _e848 = ((_e836.member[0].x - _e325) * _e330);
                                        let _e849 = ((_e836.member[0].y - _e325) * _e330);
                                        let _e850 = ((_e836.member[0].z - _e326) * _e330);
                                        let _e851 = ((_e836.member[0].w - _e326) * _e330);
                                        let _e861 = ((_e836.member[1].x - _e363) * _e368);
                                        let _e862 = ((_e836.member[1].y - _e363) * _e368);
                                        let _e863 = ((_e836.member[1].z - _e364) * _e368);
                                        let _e864 = ((_e836.member[1].w - _e364) * _e368);
                                        let _e874 = ((_e836.member[2].x - _e401) * _e406);
                                        let _e875 = ((_e836.member[2].y - _e401) * _e406);
                                        let _e876 = ((_e836.member[2].z - _e402) * _e406);
                                        let _e877 = ((_e836.member[2].w - _e402) * _e406);
                                        let _e879 = select(_e876, _e874, (_e874 < _e876));
                                        let _e881 = select(_e877, _e875, (_e875 < _e877));
                                        let _e883 = select(_e876, _e874, (_e874 > _e876));
                                        let _e885 = select(_e877, _e875, (_e875 > _e877));
                                        let _e887 = select(_e850, _e848, (_e848 < _e850));
                                        let _e889 = select(_e851, _e849, (_e849 < _e851));
                                        let _e891 = select(_e863, _e861, (_e861 < _e863));
                                        let _e893 = select(_e864, _e862, (_e862 < _e864));
                                        let _e895 = select(_e891, _e887, (_e887 > _e891));
                                        let _e897 = select(_e893, _e889, (_e889 > _e893));
                                        let _e899 = select(_e879, _e895, (_e895 > _e879));
                                        let _e901 = select(_e881, _e897, (_e897 > _e881));
                                        let _e903 = select(_e850, _e848, (_e848 > _e850));
                                        let _e905 = select(_e851, _e849, (_e849 > _e851));
                                        let _e907 = select(_e863, _e861, (_e861 > _e863));
                                        let _e909 = select(_e864, _e862, (_e862 > _e864));
                                        let _e911 = select(_e907, _e903, (_e903 < _e907));
                                        let _e913 = select(_e909, _e905, (_e905 < _e909));
                                        let _e918 = -(_e879);
                                        let _e919 = -(_e881);
                                        let _e926 = (select(_e883, _e911, (_e911 < _e883)) + (select(_e918, _e883, (_e883 > _e918)) * 0.0000019073523f));
                                        let _e927 = (select(_e885, _e913, (_e913 < _e885)) + (select(_e919, _e885, (_e885 > _e919)) * 0.0000019073523f));
                                        let _e929 = select(_e453, _e899, (_e899 > _e453));
                                        let _e931 = select(_e453, _e901, (_e901 > _e453));
                                        let _e936 = (_e929 <= select(_e497.member, _e926, (_e926 < _e497.member)));
                                        let _e937 = (_e931 <= select(_e497.member, _e927, (_e927 < _e497.member)));
                                        let _e938 = (_e929 <= _e931);
                                        if _e936 {
                                            if _e937 {
                                                if _e938 {
                                                    phi_2772_ = _e836.member_2;
                                                } else {
                                                    phi_2772_ = _e836.member_1;
                                                }
                                                let _e942 = phi_2772_;
                                                let _e964 = (_e540 % 128u);
                                                let _e965 = (_e964 < 128u);
                                                if _e965 {
                                                } else {
                                                    phi_3216_ = true;
                                                    break;
                                                }
                                                local_8[_e964] = _e942.member_1;
                                                if _e965 {
                                                } else {
                                                    phi_3216_ = true;
                                                    break;
                                                }
                                                local_7[_e964] = _e942.member.member.x;
                                                if _e965 {
                                                } else {
                                                    phi_3216_ = true;
                                                    break;
                                                }
                                                local_6[_e964] = _e942.member.member.y;
                                                if _e965 {
                                                } else {
                                                    phi_3216_ = true;
                                                    break;
                                                }
                                                local_5[_e964] = _e942.member.member.z;
                                                if _e965 {
                                                } else {
                                                    phi_3216_ = true;
                                                    break;
                                                }
                                                local_4[_e964] = _e942.member.member_1.x;
                                                if _e965 {
                                                } else {
                                                    phi_3216_ = true;
                                                    break;
                                                }
                                                local_3[_e964] = _e942.member.member_1.y;
                                                if _e965 {
                                                } else {
                                                    phi_3216_ = true;
                                                    break;
                                                }
                                                local_2[_e964] = _e942.member.member_1.z;
                                                if _e965 {
                                                } else {
                                                    phi_3216_ = true;
                                                    break;
                                                }
                                                local_9[_e964] = select(_e931, _e929, (_e929 > _e931));
                                                if _e938 {
                                                    phi_2849_ = _e836.member_1;
                                                } else {
                                                    phi_2849_ = _e836.member_2;
                                                }
                                                let _e978 = phi_2849_;
                                                phi_2850_ = _e978;
                                                phi_2851_ = (_e540 + 1u);
                                            } else {
                                                phi_2850_ = type_49();
                                                phi_2851_ = u32();
                                            }
                                            let _e980 = phi_2850_;
                                            let _e982 = phi_2851_;
                                            phi_2853_ = _e980;
                                            phi_2854_ = _e982;
                                            phi_2855_ = select(true, false, _e937);
                                        } else {
                                            phi_2853_ = type_49();
                                            phi_2854_ = u32();
                                            phi_2855_ = true;
                                        }
                                        let _e985 = phi_2853_;
                                        let _e987 = phi_2854_;
                                        let _e989 = phi_2855_;
                                        if _e989 {
                                            if _e936 {
                                                phi_2864_ = _e836.member_1;
                                            } else {
                                                phi_2864_ = _e836.member_2;
                                            }
                                            let _e993 = phi_2864_;
                                            phi_2869_ = _e993;
                                            phi_2870_ = select(_e937, true, _e936);
                                        } else {
                                            phi_2869_ = _e985;
                                            phi_2870_ = _e538;
                                        }
                                        let _e996 = phi_2869_;
                                        let _e998 = phi_2870_;
                                        phi_3220_ = _e495;
                                        phi_2872_ = _e497;
                                        phi_2873_ = _e996;
                                        phi_2874_ = _e998;
                                        phi_2875_ = select(_e987, _e540, _e989);
                                    }
                                    let _e1401 = phi_3220_;
                                    let _e1403 = phi_2872_;
                                    let _e1405 = phi_2873_;
                                    let _e1407 = phi_2874_;
                                    let _e1409 = phi_2875_;
                                    phi_3219_ = _e1401;
                                    phi_2876_ = _e1403;
                                    phi_2877_ = _e1405;
                                    phi_2878_ = (_e501 - 1u);
                                    phi_2879_ = _e1407;
                                    phi_2880_ = _e1409;
                                } else {
                                    phi_3219_ = _e495;
                                    phi_2876_ = _e497;
                                    phi_2877_ = _e536;
                                    phi_2878_ = _e501;
                                    phi_2879_ = _e538;
                                    phi_2880_ = _e540;
                                }
                                let _e1411 = phi_3219_;
                                let _e1413 = phi_2876_;
                                let _e1415 = phi_2877_;
                                let _e1417 = phi_2878_;
                                let _e1419 = phi_2879_;
                                let _e1421 = phi_2880_;
                                phi_3218_ = _e1411;
                                phi_2881_ = _e1413;
                                phi_2882_ = _e1415;
                                phi_2883_ = _e1417;
                                phi_2884_ = _e1419;
                                phi_2885_ = _e1421;
                            } else {
                                phi_3218_ = _e495;
                                phi_2881_ = type_38();
                                phi_2882_ = type_49();
                                phi_2883_ = u32();
                                phi_2884_ = bool();
                                phi_2885_ = u32();
                            }
                            let _e1423 = phi_3218_;
                            let _e1425 = phi_2881_;
                            let _e1427 = phi_2882_;
                            let _e1429 = phi_2883_;
                            let _e1431 = phi_2884_;
                            let _e1433 = phi_2885_;
                            phi_3217_ = _e1423;
                            phi_817_ = _e1425;
                            phi_820_ = _e1427;
                            phi_822_ = _e1429;
                            phi_824_ = _e1431;
                            phi_826_ = _e1433;
                            phi_2886_ = _e509;
                        } else {
                            phi_3217_ = _e495;
                            phi_817_ = type_38();
                            phi_820_ = type_49();
                            phi_822_ = u32();
                            phi_824_ = bool();
                            phi_826_ = u32();
                            phi_2886_ = false;
                        }
                        let _e1435 = phi_3217_;
                        let _e1437 = phi_817_;
                        let _e1439 = phi_820_;
                        let _e1441 = phi_822_;
                        let _e1443 = phi_824_;
                        let _e1445 = phi_826_;
                        let _e1447 = phi_2886_;
                        continue;
                        continuing {
                            phi_3111_ = _e1435;
                            phi_816_ = _e1437;
                            phi_819_ = _e1439;
                            phi_821_ = _e1441;
                            phi_823_ = _e1443;
                            phi_825_ = _e1445;
                            phi_3216_ = _e1435;
                            break if !(_e1447);
                        }
                    }
                    let _e1450 = phi_3216_;
                    if _e1450 {
                        break;
                    }
                    let _e1452 = local_11;
                    if _e141 {
                    } else {
                        break;
                    }
                    global_5.member[_e139] = select(0u, 1u, _e1452.member_1);
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn trace_any_q21_f32_(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
