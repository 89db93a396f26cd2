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

struct type_20 {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: u32,
}

struct type_22 {
    member: array<type_20>,
}

struct type_24 {
    member: array<f32, 3>,
    member_1: f32,
    member_2: array<f32, 3>,
    member_3: f32,
}

struct type_28 {
    member: vec4<f32>,
    member_1: vec4<f32>,
}

struct type_31 {
    member: type_20,
    member_1: f32,
}

struct type_36 {
    member: array<type_24>,
}

struct type_39 {
    member: array<vec4<u32>, 2>,
}

struct type_46 {
    member: array<array<u32, 7>>,
}

struct type_48 {
    member: type_28,
    member_1: u32,
}

struct type_51 {
    member: array<vec4<f32>, 3>,
    member_1: type_48,
    member_2: type_48,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_1: type_8;
@group(0) @binding(3) 
var<storage> global_2: type_15;
@group(0) @binding(1) 
var<uniform> global_3: type_39;
@group(0) @binding(4) 
var<storage> global_4: type_36;
@group(0) @binding(2) 
var<storage> global_5: type_46;
@group(0) @binding(5) 
var<storage, read_write> global_6: type_22;

fn function_() {
    var local: array<i32, 3>;
    var local_1: array<i32, 3>;
    var local_2: array<f32, 128>;
    var local_3: array<type_48, 128>;
    var phi_377_: i32;
    var phi_378_: i32;
    var phi_388_: bool;
    var phi_398_: u32;
    var phi_399_: u32;
    var phi_401_: bool;
    var phi_406_: u32;
    var phi_419_: i32;
    var phi_439_: i32;
    var phi_457_: f32;
    var phi_463_: f32;
    var phi_474_: f32;
    var phi_480_: f32;
    var phi_503_: f32;
    var phi_514_: f32;
    var phi_523_: f32;
    var phi_529_: f32;
    var phi_540_: f32;
    var phi_546_: f32;
    var phi_569_: f32;
    var phi_580_: f32;
    var phi_589_: f32;
    var phi_595_: f32;
    var phi_606_: f32;
    var phi_612_: f32;
    var phi_635_: f32;
    var phi_646_: f32;
    var phi_746_: f32;
    var phi_747_: f32;
    var phi_4249_: bool;
    var phi_1867_: type_31;
    var phi_1870_: type_48;
    var phi_1872_: u32;
    var phi_1874_: bool;
    var phi_1876_: u32;
    var phi_1887_: bool;
    var phi_1924_: type_48;
    var phi_1925_: bool;
    var phi_1926_: u32;
    var phi_3554_: u32;
    var phi_3555_: u32;
    var phi_3565_: u32;
    var phi_3567_: u32;
    var phi_3568_: bool;
    var phi_3588_: u32;
    var phi_3589_: u32;
    var phi_3593_: type_51;
    var phi_3937_: type_48;
    var phi_3970_: type_48;
    var phi_3971_: type_48;
    var phi_3972_: u32;
    var phi_3974_: type_48;
    var phi_3975_: u32;
    var phi_3976_: bool;
    var phi_3985_: type_48;
    var phi_3990_: type_48;
    var phi_3991_: bool;
    var phi_1944_: type_31;
    var phi_1947_: type_4;
    var phi_1948_: type_4;
    var phi_1970_: type_4;
    var phi_1991_: u32;
    var phi_2080_: array<array<f32, 3>, 3>;
    var phi_2551_: vec3<f32>;
    var phi_2552_: vec3<f32>;
    var phi_2583_: bool;
    var phi_2592_: vec3<f32>;
    var phi_2632_: type_20;
    var phi_2634_: type_20;
    var phi_2635_: bool;
    var phi_2639_: type_20;
    var phi_2640_: type_20;
    var phi_2641_: type_20;
    var phi_2642_: bool;
    var phi_2646_: type_20;
    var phi_2647_: bool;
    var phi_2651_: type_20;
    var phi_2652_: bool;
    var phi_2656_: type_20;
    var phi_2681_: bool;
    var phi_2682_: bool;
    var phi_2688_: type_31;
    var phi_2689_: type_31;
    var phi_2690_: type_31;
    var phi_1945_: type_31;
    var phi_4243_: bool;
    var phi_4361_: bool;
    var phi_3993_: type_31;
    var phi_3994_: type_48;
    var phi_3995_: bool;
    var phi_3996_: u32;
    var phi_4360_: bool;
    var phi_3997_: type_31;
    var phi_3998_: type_48;
    var phi_3999_: u32;
    var phi_4000_: bool;
    var phi_4001_: u32;
    var phi_4359_: bool;
    var phi_4002_: type_31;
    var phi_4003_: type_48;
    var phi_4004_: u32;
    var phi_4005_: bool;
    var phi_4006_: u32;
    var phi_4358_: bool;
    var phi_1868_: type_31;
    var phi_1871_: type_48;
    var phi_1873_: u32;
    var phi_1875_: bool;
    var phi_1877_: u32;
    var phi_4007_: bool;
    var phi_4357_: bool;
    var local_4: type_31;
    var phi_4059_: type_20;
    var local_5: type_31;

    switch bitcast<i32>(0u) {
        default: {
            let _e77 = global;
            let _e79 = arrayLength((&global_5.member));
            let _e81 = arrayLength((&global_2.member));
            let _e89 = global_3.member[0u][0u];
            let _e93 = global_3.member[0u][1u];
            let _e97 = global_3.member[0u][2u];
            let _e101 = global_3.member[0u][3u];
            let _e105 = global_3.member[1u][0u];
            let _e109 = global_3.member[1u][1u];
            let _e113 = global_3.member[1u][2u];
            let _e116 = global_1.member[0u];
            let _e117 = bitcast<i32>(_e116);
            let _e129 = bitcast<f32>((bitcast<u32>((bitcast<i32>(_e101) + 127i)) << bitcast<u32>(23i)));
            local_1 = array<i32, 3>(bitcast<i32>(_e89), bitcast<i32>(_e93), bitcast<i32>(_e97));
            local = array<i32, 3>(bitcast<i32>(_e105), bitcast<i32>(_e109), bitcast<i32>(_e113));
            let _e135 = (_e77.x + (_e77.y * 2097152u));
            let _e136 = (_e135 < arrayLength((&global_4.member)));
            if _e136 {
                let _e137 = (_e135 < arrayLength((&global_6.member)));
                if _e137 {
                    if _e136 {
                    } else {
                        break;
                    }
                    let _e145 = global_4.member[_e135].member_2[0u];
                    let _e147 = (bitcast<u32>(_e145) & 2147483647u);
                    let _e152 = global_4.member[_e135].member_2[1u];
                    let _e154 = (bitcast<u32>(_e152) & 2147483647u);
                    let _e159 = global_4.member[_e135].member_2[2u];
                    let _e161 = (bitcast<u32>(_e159) & 2147483647u);
                    let _e166 = global_4.member[_e135].member[0u];
                    let _e168 = (bitcast<u32>(_e166) & 2147483647u);
                    let _e173 = global_4.member[_e135].member[1u];
                    let _e175 = (bitcast<u32>(_e173) & 2147483647u);
                    let _e180 = global_4.member[_e135].member[2u];
                    let _e182 = (bitcast<u32>(_e180) & 2147483647u);
                    let _e184 = select(_e154, _e147, (_e154 < _e147));
                    let _e186 = select(_e161, _e184, (_e161 < _e184));
                    let _e188 = select(_e168, _e186, (_e168 < _e186));
                    let _e190 = select(_e175, _e188, (_e175 < _e188));
                    let _e192 = select(_e182, _e190, (_e182 < _e190));
                    let _e196 = global_4.member[_e135].member_1;
                    let _e198 = (bitcast<u32>(_e196) & 2147483647u);
                    let _e205 = global_4.member[_e135].member_3;
                    let _e211 = (((select(_e198, _e192, (_e198 < _e192)) < 2139095040u) && ((bitcast<u32>(_e205) & 2147483647u) <= 2139095040u)) && (_e186 > 0u));
                    if _e211 {
                        let _e214 = (bitcast<u32>(bitcast<f32>(_e186)) & 2147483647u);
                        if (_e214 >= 8388608u) {
                            phi_377_ = (bitcast<i32>((_e214 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_377_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e214)), 32u, (_e214 == 0u))));
                        }
                        let _e228 = phi_377_;
                        phi_378_ = _e228;
                    } else {
                        phi_378_ = 0i;
                    }
                    let _e230 = phi_378_;
                    let _e231 = (_e147 == _e186);
                    if _e231 {
                        phi_388_ = true;
                    } else {
                        phi_388_ = (_e154 == _e186);
                    }
                    let _e234 = phi_388_;
                    let _e235 = select(1u, 0u, _e231);
                    if _e234 {
                        let _e236 = (_e235 + 1u);
                        phi_398_ = _e236;
                        phi_399_ = _e236;
                        phi_401_ = select(true, false, (_e236 == 2u));
                    } else {
                        phi_398_ = u32();
                        phi_399_ = 0u;
                        phi_401_ = true;
                    }
                    let _e240 = phi_398_;
                    let _e242 = phi_399_;
                    let _e244 = phi_401_;
                    if _e244 {
                        phi_406_ = (_e242 + 1u);
                    } else {
                        phi_406_ = 0u;
                    }
                    let _e248 = phi_406_;
                    let _e249 = select(_e240, _e242, _e244);
                    let _e250 = select(_e235, select(2u, _e235, _e234), _e244);
                    if (_e117 < -126i) {
                        phi_419_ = -126i;
                    } else {
                        phi_419_ = select(_e117, 127i, (_e117 > 127i));
                    }
                    let _e255 = phi_419_;
                    let _e260 = bitcast<f32>((bitcast<u32>((_e255 + 127i)) << bitcast<u32>(23i)));
                    let _e266 = bitcast<f32>((bitcast<u32>(((_e117 - _e255) + 127i)) << bitcast<u32>(23i)));
                    let _e267 = -(_e230);
                    if (_e267 < -126i) {
                        phi_439_ = -126i;
                    } else {
                        phi_439_ = select(_e267, 127i, (_e267 > 127i));
                    }
                    let _e272 = phi_439_;
                    let _e277 = bitcast<f32>((bitcast<u32>((_e272 + 127i)) << bitcast<u32>(23i)));
                    let _e283 = bitcast<f32>((bitcast<u32>(((_e267 - _e272) + 127i)) << bitcast<u32>(23i)));
                    let _e287 = global_4.member[_e135].member;
                    let _e288 = (_e249 == 0u);
                    if _e288 {
                        phi_457_ = _e287[0];
                    } else {
                        phi_457_ = _e287[1];
                    }
                    let _e292 = phi_457_;
                    let _e293 = (_e249 == 2u);
                    if _e293 {
                        phi_463_ = _e287[2];
                    } else {
                        phi_463_ = _e292;
                    }
                    let _e296 = phi_463_;
                    let _e298 = ((_e296 * _e260) * _e266);
                    let _e299 = global_4.member[_e135].member_2;
                    if _e288 {
                        phi_474_ = _e299[0];
                    } else {
                        phi_474_ = _e299[1];
                    }
                    let _e303 = phi_474_;
                    if _e293 {
                        phi_480_ = _e299[2];
                    } else {
                        phi_480_ = _e303;
                    }
                    let _e306 = phi_480_;
                    let _e308 = ((_e306 * _e277) * _e283);
                    let _e312 = (bitcast<f32>((bitcast<u32>(_e308) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e312 {
                        let _e316 = (bitcast<f32>((bitcast<u32>(_e298) & 2147483647u)) * 0.00000011920929f);
                        phi_503_ = select(0.00000000000011368684f, _e316, (_e316 > 0.00000000000011368684f));
                    } else {
                        phi_503_ = 0f;
                    }
                    let _e320 = phi_503_;
                    let _e321 = (_e298 + _e320);
                    let _e322 = (_e298 - _e320);
                    let _e323 = select(_e308, 0f, _e312);
                    if _e312 {
                        phi_514_ = 38685626000000000000000000f;
                    } else {
                        phi_514_ = (1f / _e308);
                    }
                    let _e326 = phi_514_;
                    let _e327 = (_e248 == 0u);
                    if _e327 {
                        phi_523_ = _e287[0];
                    } else {
                        phi_523_ = _e287[1];
                    }
                    let _e331 = phi_523_;
                    let _e332 = (_e248 == 2u);
                    if _e332 {
                        phi_529_ = _e287[2];
                    } else {
                        phi_529_ = _e331;
                    }
                    let _e335 = phi_529_;
                    let _e337 = ((_e335 * _e260) * _e266);
                    if _e327 {
                        phi_540_ = _e299[0];
                    } else {
                        phi_540_ = _e299[1];
                    }
                    let _e341 = phi_540_;
                    if _e332 {
                        phi_546_ = _e299[2];
                    } else {
                        phi_546_ = _e341;
                    }
                    let _e344 = phi_546_;
                    let _e346 = ((_e344 * _e277) * _e283);
                    let _e350 = (bitcast<f32>((bitcast<u32>(_e346) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e350 {
                        let _e354 = (bitcast<f32>((bitcast<u32>(_e337) & 2147483647u)) * 0.00000011920929f);
                        phi_569_ = select(0.00000000000011368684f, _e354, (_e354 > 0.00000000000011368684f));
                    } else {
                        phi_569_ = 0f;
                    }
                    let _e358 = phi_569_;
                    let _e359 = (_e337 + _e358);
                    let _e360 = (_e337 - _e358);
                    let _e361 = select(_e346, 0f, _e350);
                    if _e350 {
                        phi_580_ = 38685626000000000000000000f;
                    } else {
                        phi_580_ = (1f / _e346);
                    }
                    let _e364 = phi_580_;
                    let _e365 = (_e250 == 0u);
                    if _e365 {
                        phi_589_ = _e287[0];
                    } else {
                        phi_589_ = _e287[1];
                    }
                    let _e369 = phi_589_;
                    let _e370 = (_e250 == 2u);
                    if _e370 {
                        phi_595_ = _e287[2];
                    } else {
                        phi_595_ = _e369;
                    }
                    let _e373 = phi_595_;
                    let _e375 = ((_e373 * _e260) * _e266);
                    if _e365 {
                        phi_606_ = _e299[0];
                    } else {
                        phi_606_ = _e299[1];
                    }
                    let _e379 = phi_606_;
                    if _e370 {
                        phi_612_ = _e299[2];
                    } else {
                        phi_612_ = _e379;
                    }
                    let _e382 = phi_612_;
                    let _e384 = ((_e382 * _e277) * _e283);
                    let _e388 = (bitcast<f32>((bitcast<u32>(_e384) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e388 {
                        let _e392 = (bitcast<f32>((bitcast<u32>(_e375) & 2147483647u)) * 0.00000011920929f);
                        phi_635_ = select(0.00000000000011368684f, _e392, (_e392 > 0.00000000000011368684f));
                    } else {
                        phi_635_ = 0f;
                    }
                    let _e396 = phi_635_;
                    let _e397 = (_e375 + _e396);
                    let _e398 = (_e375 - _e396);
                    let _e399 = select(_e384, 0f, _e388);
                    if _e388 {
                        phi_646_ = 38685626000000000000000000f;
                    } else {
                        phi_646_ = (1f / _e384);
                    }
                    let _e402 = phi_646_;
                    let _e405 = bitcast<f32>((bitcast<u32>(_e298) & 2147483647u));
                    let _e408 = bitcast<f32>((bitcast<u32>(_e337) & 2147483647u));
                    let _e410 = select(_e408, _e405, (_e405 > _e408));
                    let _e413 = bitcast<f32>((bitcast<u32>(_e375) & 2147483647u));
                    let _e416 = (_e117 + _e230);
                    if (_e211 && (select(_e413, _e410, (_e410 > _e413)) <= 1099511600000f)) {
                        let _e419 = (_e416 / 3i);
                        let _e426 = bitcast<f32>((bitcast<u32>((_e419 + 127i)) << bitcast<u32>(23i)));
                        let _e433 = bitcast<f32>((bitcast<u32>(((_e416 - (2i * _e419)) + 127i)) << bitcast<u32>(23i)));
                        let _e434 = (((_e196 * _e426) * _e426) * _e433);
                        let _e436 = select(340282350000000000000000000000000000000f, _e434, (_e434 < 340282350000000000000000000000000000000f));
                        let _e441 = (((_e205 * _e426) * _e426) * _e433);
                        let _e443 = select(340282350000000000000000000000000000000f, _e441, (_e441 < 340282350000000000000000000000000000000f));
                        phi_746_ = select(-340282350000000000000000000000000000000f, _e443, (_e443 > -340282350000000000000000000000000000000f));
                        phi_747_ = select(-340282350000000000000000000000000000000f, _e436, (_e436 > -340282350000000000000000000000000000000f));
                    } else {
                        phi_746_ = 0f;
                        phi_747_ = 1f;
                    }
                    let _e447 = phi_746_;
                    let _e449 = phi_747_;
                    local_3 = array<type_48, 128>(type_48(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u));
                    local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    let _e453 = (_e249 % 3u);
                    let _e454 = (_e453 < 3u);
                    if _e454 {
                    } else {
                        break;
                    }
                    let _e456 = local_1[_e453];
                    let _e459 = (_e248 % 3u);
                    let _e460 = (_e459 < 3u);
                    if _e460 {
                    } else {
                        break;
                    }
                    let _e462 = local_1[_e459];
                    let _e465 = (_e250 % 3u);
                    let _e466 = (_e465 < 3u);
                    if _e466 {
                    } else {
                        break;
                    }
                    let _e468 = local_1[_e465];
                    if _e454 {
                    } else {
                        break;
                    }
                    let _e473 = local[_e453];
                    if _e460 {
                    } else {
                        break;
                    }
                    let _e477 = local[_e459];
                    if _e466 {
                    } else {
                        break;
                    }
                    let _e481 = local[_e465];
                    phi_4249_ = false;
                    phi_1867_ = type_31(type_20(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e447);
                    phi_1870_ = type_48(type_28(vec4<f32>((f32(_e456) * _e129), (f32(_e462) * _e129), (f32(_e468) * _e129), 0f), vec4<f32>((f32(_e473) * _e129), (f32(_e477) * _e129), (f32(_e481) * _e129), 0f)), select(0u, 2147483648u, (_e79 == 0u)));
                    phi_1872_ = ((3u * _e79) + 1u);
                    phi_1874_ = (_e449 <= _e447);
                    phi_1876_ = 0u;
                    loop {
                        let _e491 = phi_4249_;
                        let _e493 = phi_1867_;
                        let _e495 = phi_1870_;
                        let _e497 = phi_1872_;
                        let _e499 = phi_1874_;
                        let _e501 = phi_1876_;
                        local_4 = _e493;
                        if _e499 {
                            phi_1887_ = true;
                        } else {
                            phi_1887_ = (_e501 > 0u);
                        }
                        let _e504 = phi_1887_;
                        if _e504 {
                            let _e505 = (_e497 > 0u);
                            if _e505 {
                                if _e499 {
                                    phi_1924_ = _e495;
                                    phi_1925_ = _e499;
                                    phi_1926_ = _e501;
                                } else {
                                    let _e506 = (_e501 - 1u);
                                    let _e507 = (_e506 % 128u);
                                    let _e508 = (_e507 < 128u);
                                    if _e508 {
                                    } else {
                                        phi_4357_ = true;
                                        break;
                                    }
                                    let _e510 = local_3[_e507];
                                    if _e508 {
                                    } else {
                                        phi_4357_ = true;
                                        break;
                                    }
                                    let _e518 = local_2[_e507];
                                    phi_1924_ = type_48(type_28(_e510.member.member, _e510.member.member_1), _e510.member_1);
                                    phi_1925_ = (_e518 <= _e493.member_1);
                                    phi_1926_ = _e506;
                                }
                                let _e522 = phi_1924_;
                                let _e524 = phi_1925_;
                                let _e526 = phi_1926_;
                                if _e524 {
                                    if ((_e522.member_1 & 2147483648u) != 0u) {
                                        phi_1944_ = _e493;
                                        phi_1947_ = type_4(0u, ((_e522.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e972 = phi_1944_;
                                            let _e974 = phi_1947_;
                                            local_5 = _e972;
                                            if (_e974.member < _e974.member_1) {
                                                phi_1948_ = type_4((_e974.member + 1u), _e974.member_1);
                                                phi_1970_ = type_4(1u, _e974.member);
                                            } else {
                                                phi_1948_ = _e974;
                                                phi_1970_ = type_4(0u, type_4().member_1);
                                            }
                                            let _e987 = phi_1948_;
                                            let _e989 = phi_1970_;
                                            let _e993 = (bitcast<i32>(_e989.member) != 0i);
                                            if _e993 {
                                                let _e994 = ((_e522.member_1 & 268435455u) + _e989.member_1);
                                                let _e995 = (_e994 < _e81);
                                                if _e995 {
                                                    if _e995 {
                                                    } else {
                                                        phi_4243_ = true;
                                                        break;
                                                    }
                                                    let _e999 = global_2.member[_e994].member_1;
                                                    phi_1991_ = _e999;
                                                } else {
                                                    phi_1991_ = 4294967295u;
                                                }
                                                let _e1001 = phi_1991_;
                                                if (_e994 >= _e81) {
                                                    phi_2080_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                } else {
                                                    if _e995 {
                                                    } else {
                                                        phi_4243_ = true;
                                                        break;
                                                    }
                                                    if (_e453 < 9u) {
                                                    } else {
                                                        phi_4243_ = true;
                                                        break;
                                                    }
                                                    let _e1008 = global_2.member[_e994].member[_e453];
                                                    if (_e459 < 9u) {
                                                    } else {
                                                        phi_4243_ = true;
                                                        break;
                                                    }
                                                    let _e1014 = global_2.member[_e994].member[_e459];
                                                    if (_e465 < 9u) {
                                                    } else {
                                                        phi_4243_ = true;
                                                        break;
                                                    }
                                                    let _e1020 = global_2.member[_e994].member[_e465];
                                                    let _e1022 = (3u + _e453);
                                                    if (_e1022 < 9u) {
                                                    } else {
                                                        phi_4243_ = true;
                                                        break;
                                                    }
                                                    let _e1028 = global_2.member[_e994].member[_e1022];
                                                    let _e1029 = (3u + _e459);
                                                    if (_e1029 < 9u) {
                                                    } else {
                                                        phi_4243_ = true;
                                                        break;
                                                    }
                                                    let _e1035 = global_2.member[_e994].member[_e1029];
                                                    let _e1036 = (3u + _e465);
                                                    if (_e1036 < 9u) {
                                                    } else {
                                                        phi_4243_ = true;
                                                        break;
                                                    }
                                                    let _e1042 = global_2.member[_e994].member[_e1036];
                                                    let _e1044 = (6u + _e453);
                                                    if (_e1044 < 9u) {
                                                    } else {
                                                        phi_4243_ = true;
                                                        break;
                                                    }
                                                    let _e1050 = global_2.member[_e994].member[_e1044];
                                                    let _e1051 = (6u + _e459);
                                                    if (_e1051 < 9u) {
                                                    } else {
                                                        phi_4243_ = true;
                                                        break;
                                                    }
                                                    let _e1057 = global_2.member[_e994].member[_e1051];
                                                    let _e1058 = (6u + _e465);
                                                    if (_e1058 < 9u) {
                                                    } else {
                                                        phi_4243_ = true;
                                                        break;
                                                    }
                                                    let _e1064 = global_2.member[_e994].member[_e1058];
                                                    phi_2080_ = array<array<f32, 3>, 3>(array<f32, 3>(_e1008, _e1014, _e1020), array<f32, 3>(_e1028, _e1035, _e1042), array<f32, 3>(_e1050, _e1057, _e1064));
                                                }
                                                let _e1068 = phi_2080_;
                                                let _e1076 = (_e1068[0][2] - _e375);
                                                let _e1079 = (((_e1068[0][0] - _e298) * _e399) - (_e1076 * _e323));
                                                let _e1082 = (((_e1068[0][1] - _e337) * _e399) - (_e1076 * _e361));
                                                let _e1089 = (_e1068[1][2] - _e375);
                                                let _e1092 = (((_e1068[1][0] - _e298) * _e399) - (_e1089 * _e323));
                                                let _e1095 = (((_e1068[1][1] - _e337) * _e399) - (_e1089 * _e361));
                                                let _e1102 = (_e1068[2][2] - _e375);
                                                let _e1105 = (((_e1068[2][0] - _e298) * _e399) - (_e1102 * _e323));
                                                let _e1108 = (((_e1068[2][1] - _e337) * _e399) - (_e1102 * _e361));
                                                let _e1109 = (_e1105 * _e1095);
                                                let _e1110 = (_e1108 * _e1092);
                                                let _e1111 = (_e1079 * _e1108);
                                                let _e1112 = (_e1082 * _e1105);
                                                let _e1113 = (_e1092 * _e1082);
                                                let _e1114 = (_e1095 * _e1079);
                                                let _e1119 = (((_e1109 >= _e1110) && (_e1111 >= _e1112)) && (_e1113 >= _e1114));
                                                if (_e1119 || (((_e1109 <= _e1110) && (_e1111 <= _e1112)) && (_e1113 <= _e1114))) {
                                                    let _e1126 = select(-1f, 1f, _e1119);
                                                    let _e1128 = ((_e1109 - _e1110) * _e1126);
                                                    let _e1130 = select(0f, _e1128, (_e1128 > 0f));
                                                    let _e1132 = ((_e1111 - _e1112) * _e1126);
                                                    let _e1134 = select(0f, _e1132, (_e1132 > 0f));
                                                    let _e1136 = ((_e1113 - _e1114) * _e1126);
                                                    let _e1138 = select(0f, _e1136, (_e1136 > 0f));
                                                    let _e1140 = ((_e1130 + _e1134) + _e1138);
                                                    if (_e1140 < 0.000000000000000000000000000000000000011754944f) {
                                                        phi_2646_ = type_20();
                                                        phi_2647_ = true;
                                                    } else {
                                                        let _e1143 = select(_e1068[1][0], _e1068[0][0], (_e1068[0][0] < _e1068[1][0]));
                                                        let _e1147 = select(_e1068[1][0], _e1068[0][0], (_e1068[0][0] > _e1068[1][0]));
                                                        let _e1151 = select(_e1068[1][1], _e1068[0][1], (_e1068[0][1] < _e1068[1][1]));
                                                        let _e1155 = select(_e1068[1][1], _e1068[0][1], (_e1068[0][1] > _e1068[1][1]));
                                                        let _e1159 = select(_e1068[1][2], _e1068[0][2], (_e1068[0][2] < _e1068[1][2]));
                                                        let _e1163 = select(_e1068[1][2], _e1068[0][2], (_e1068[0][2] > _e1068[1][2]));
                                                        let _e1168 = ((select(_e1068[2][0], _e1143, (_e1143 < _e1068[2][0])) - _e321) * _e326);
                                                        let _e1169 = ((select(_e1068[2][0], _e1147, (_e1147 > _e1068[2][0])) - _e322) * _e326);
                                                        let _e1172 = ((select(_e1068[2][1], _e1151, (_e1151 < _e1068[2][1])) - _e359) * _e364);
                                                        let _e1173 = ((select(_e1068[2][1], _e1155, (_e1155 > _e1068[2][1])) - _e360) * _e364);
                                                        let _e1176 = ((select(_e1068[2][2], _e1159, (_e1159 < _e1068[2][2])) - _e397) * _e402);
                                                        let _e1177 = ((select(_e1068[2][2], _e1163, (_e1163 > _e1068[2][2])) - _e398) * _e402);
                                                        let _e1179 = select(_e1177, _e1176, (_e1176 < _e1177));
                                                        let _e1181 = select(_e1177, _e1176, (_e1176 > _e1177));
                                                        let _e1183 = select(_e1169, _e1168, (_e1168 < _e1169));
                                                        let _e1185 = select(_e1173, _e1172, (_e1172 < _e1173));
                                                        let _e1187 = select(_e1185, _e1183, (_e1183 > _e1185));
                                                        let _e1189 = select(_e1179, _e1187, (_e1187 > _e1179));
                                                        let _e1191 = select(_e1169, _e1168, (_e1168 > _e1169));
                                                        let _e1193 = select(_e1173, _e1172, (_e1172 > _e1173));
                                                        let _e1195 = select(_e1193, _e1191, (_e1191 < _e1193));
                                                        let _e1197 = select(_e1181, _e1195, (_e1195 < _e1181));
                                                        let _e1198 = -(_e1179);
                                                        let _e1204 = select(_e449, _e1189, (_e1189 > _e449));
                                                        if (_e1204 > (_e1197 + (select(_e1198, _e1181, (_e1181 > _e1198)) * 0.0000019073523f))) {
                                                            phi_2641_ = type_20();
                                                            phi_2642_ = true;
                                                        } else {
                                                            let _e1206 = (_e1204 > _e972.member_1);
                                                            if _e1206 {
                                                                phi_2640_ = type_20();
                                                            } else {
                                                                let _e1210 = (_e1068[1][0] - _e1068[0][0]);
                                                                let _e1211 = (_e1068[1][1] - _e1068[0][1]);
                                                                let _e1212 = (_e1068[1][2] - _e1068[0][2]);
                                                                let _e1213 = vec3<f32>(_e1210, _e1211, _e1212);
                                                                let _e1214 = (_e1068[2][0] - _e1068[1][0]);
                                                                let _e1215 = (_e1068[2][1] - _e1068[1][1]);
                                                                let _e1216 = (_e1068[2][2] - _e1068[1][2]);
                                                                let _e1217 = vec3<f32>(_e1214, _e1215, _e1216);
                                                                let _e1218 = (_e1068[0][0] - _e1068[2][0]);
                                                                let _e1219 = (_e1068[0][1] - _e1068[2][1]);
                                                                let _e1220 = (_e1068[0][2] - _e1068[2][2]);
                                                                let _e1221 = vec3<f32>(_e1218, _e1219, _e1220);
                                                                let _e1224 = bitcast<f32>((bitcast<u32>(_e1210) & 2147483647u));
                                                                let _e1227 = bitcast<f32>((bitcast<u32>(_e1211) & 2147483647u));
                                                                let _e1229 = select(_e1227, _e1224, (_e1224 > _e1227));
                                                                let _e1232 = bitcast<f32>((bitcast<u32>(_e1212) & 2147483647u));
                                                                let _e1234 = select(_e1232, _e1229, (_e1229 > _e1232));
                                                                let _e1237 = bitcast<f32>((bitcast<u32>(_e1214) & 2147483647u));
                                                                let _e1240 = bitcast<f32>((bitcast<u32>(_e1215) & 2147483647u));
                                                                let _e1242 = select(_e1240, _e1237, (_e1237 > _e1240));
                                                                let _e1245 = bitcast<f32>((bitcast<u32>(_e1216) & 2147483647u));
                                                                let _e1247 = select(_e1245, _e1242, (_e1242 > _e1245));
                                                                let _e1250 = bitcast<f32>((bitcast<u32>(_e1218) & 2147483647u));
                                                                let _e1253 = bitcast<f32>((bitcast<u32>(_e1219) & 2147483647u));
                                                                let _e1255 = select(_e1253, _e1250, (_e1250 > _e1253));
                                                                let _e1258 = bitcast<f32>((bitcast<u32>(_e1220) & 2147483647u));
                                                                let _e1260 = select(_e1258, _e1255, (_e1255 > _e1258));
                                                                let _e1262 = select(_e1247, _e1234, (_e1234 > _e1247));
                                                                let _e1264 = select(_e1260, _e1262, (_e1262 > _e1260));
                                                                if (_e1234 == _e1264) {
                                                                    phi_2551_ = _e1217;
                                                                    phi_2552_ = _e1221;
                                                                } else {
                                                                    let _e1267 = vec3((_e1247 == _e1264));
                                                                    phi_2551_ = select(_e1213, _e1221, _e1267);
                                                                    phi_2552_ = select(_e1217, _e1213, _e1267);
                                                                }
                                                                let _e1271 = phi_2551_;
                                                                let _e1273 = phi_2552_;
                                                                let _e1280 = ((_e1271.y * _e1273.z) - (_e1273.y * _e1271.z));
                                                                let _e1285 = ((_e1271.z * _e1273.x) - (_e1273.z * _e1271.x));
                                                                let _e1288 = ((_e1271.x * _e1273.y) - (_e1273.x * _e1271.y));
                                                                if (_e1130 >= _e1134) {
                                                                    phi_2583_ = select(true, false, (_e1130 >= _e1138));
                                                                } else {
                                                                    phi_2583_ = true;
                                                                }
                                                                let _e1293 = phi_2583_;
                                                                if _e1293 {
                                                                    phi_2592_ = select(vec3<f32>(_e1068[2][0], _e1068[2][1], _e1068[2][2]), vec3<f32>(_e1068[1][0], _e1068[1][1], _e1068[1][2]), vec3((_e1134 >= _e1138)));
                                                                } else {
                                                                    phi_2592_ = vec3<f32>(_e1068[0][0], _e1068[0][1], _e1068[0][2]);
                                                                }
                                                                let _e1298 = phi_2592_;
                                                                let _e1315 = ((((_e1280 * (_e1298.x - _e298)) + (_e1285 * (_e1298.y - _e337))) + (_e1288 * (_e1298.z - _e375))) / (((_e1280 * _e323) + (_e1285 * _e361)) + (_e1288 * _e399)));
                                                                let _e1317 = select(_e1197, _e1315, (_e1315 < _e1197));
                                                                let _e1319 = select(_e1189, _e1317, (_e1317 > _e1189));
                                                                if (_e1319 >= _e449) {
                                                                    let _e1321 = (_e1319 <= _e972.member_1);
                                                                    if _e1321 {
                                                                        let _e1322 = (1f / _e1140);
                                                                        phi_2632_ = type_20(_e1319, (_e1134 * _e1322), (_e1138 * _e1322), _e1001);
                                                                    } else {
                                                                        phi_2632_ = type_20();
                                                                    }
                                                                    let _e1327 = phi_2632_;
                                                                    phi_2634_ = _e1327;
                                                                    phi_2635_ = select(true, false, _e1321);
                                                                } else {
                                                                    phi_2634_ = type_20();
                                                                    phi_2635_ = true;
                                                                }
                                                                let _e1330 = phi_2634_;
                                                                let _e1332 = phi_2635_;
                                                                if _e1332 {
                                                                    phi_2639_ = type_20(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                } else {
                                                                    phi_2639_ = _e1330;
                                                                }
                                                                let _e1334 = phi_2639_;
                                                                phi_2640_ = _e1334;
                                                            }
                                                            let _e1336 = phi_2640_;
                                                            phi_2641_ = _e1336;
                                                            phi_2642_ = _e1206;
                                                        }
                                                        let _e1338 = phi_2641_;
                                                        let _e1340 = phi_2642_;
                                                        phi_2646_ = _e1338;
                                                        phi_2647_ = _e1340;
                                                    }
                                                    let _e1342 = phi_2646_;
                                                    let _e1344 = phi_2647_;
                                                    phi_2651_ = _e1342;
                                                    phi_2652_ = _e1344;
                                                } else {
                                                    phi_2651_ = type_20();
                                                    phi_2652_ = true;
                                                }
                                                let _e1346 = phi_2651_;
                                                let _e1348 = phi_2652_;
                                                if _e1348 {
                                                    phi_2656_ = type_20(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                } else {
                                                    phi_2656_ = _e1346;
                                                }
                                                let _e1350 = phi_2656_;
                                                if (_e1350.member_3 != 4294967295u) {
                                                    if (_e1001 != 4294967295u) {
                                                        if (_e1350.member < _e972.member.member) {
                                                            phi_2682_ = true;
                                                        } else {
                                                            if (_e1350.member == _e972.member.member) {
                                                                phi_2681_ = (_e1350.member_3 < _e972.member.member_3);
                                                            } else {
                                                                phi_2681_ = false;
                                                            }
                                                            let _e1363 = phi_2681_;
                                                            phi_2682_ = _e1363;
                                                        }
                                                        let _e1365 = phi_2682_;
                                                        if _e1365 {
                                                            phi_2688_ = type_31(_e1350, _e1350.member);
                                                        } else {
                                                            phi_2688_ = _e972;
                                                        }
                                                        let _e1368 = phi_2688_;
                                                        phi_2689_ = _e1368;
                                                    } else {
                                                        phi_2689_ = _e972;
                                                    }
                                                    let _e1370 = phi_2689_;
                                                    phi_2690_ = _e1370;
                                                } else {
                                                    phi_2690_ = _e972;
                                                }
                                                let _e1372 = phi_2690_;
                                                phi_1945_ = _e1372;
                                            } else {
                                                phi_1945_ = type_31();
                                            }
                                            let _e1374 = phi_1945_;
                                            continue;
                                            continuing {
                                                phi_1944_ = _e1374;
                                                phi_1947_ = _e987;
                                                phi_4243_ = _e491;
                                                break if !(_e993);
                                            }
                                        }
                                        let _e1377 = phi_4243_;
                                        phi_4357_ = _e1377;
                                        if _e1377 {
                                            break;
                                        }
                                        phi_4361_ = _e1377;
                                        let _e1552 = local_5;
                                        phi_3993_ = _e1552;
                                        phi_3994_ = _e522;
                                        phi_3995_ = false;
                                        phi_3996_ = _e526;
                                    } else {
                                        if (_e522.member_1 >= _e79) {
                                            phi_3593_ = type_51(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), type_48(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u), type_48(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u));
                                        } else {
                                            if (_e522.member_1 < _e79) {
                                            } else {
                                                phi_4357_ = true;
                                                break;
                                            }
                                            let _e539 = ((1u + (_e249 * 2u)) % 7u);
                                            if (_e539 < 7u) {
                                            } else {
                                                phi_4357_ = true;
                                                break;
                                            }
                                            let _e544 = global_5.member[_e522.member_1][_e539];
                                            let _e547 = ((1u + (_e248 * 2u)) % 7u);
                                            if (_e547 < 7u) {
                                            } else {
                                                phi_4357_ = true;
                                                break;
                                            }
                                            let _e552 = global_5.member[_e522.member_1][_e547];
                                            let _e555 = ((1u + (_e250 * 2u)) % 7u);
                                            if (_e555 < 7u) {
                                            } else {
                                                phi_4357_ = true;
                                                break;
                                            }
                                            let _e560 = global_5.member[_e522.member_1][_e555];
                                            let _e563 = (((_e249 + 1u) * 2u) % 7u);
                                            if (_e563 < 7u) {
                                            } else {
                                                phi_4357_ = true;
                                                break;
                                            }
                                            let _e568 = global_5.member[_e522.member_1][_e563];
                                            let _e571 = (((_e248 + 1u) * 2u) % 7u);
                                            if (_e571 < 7u) {
                                            } else {
                                                phi_4357_ = true;
                                                break;
                                            }
                                            let _e576 = global_5.member[_e522.member_1][_e571];
                                            let _e579 = (((_e250 + 1u) * 2u) % 7u);
                                            if (_e579 < 7u) {
                                            } else {
                                                phi_4357_ = true;
                                                break;
                                            }
                                            let _e584 = global_5.member[_e522.member_1][_e579];
                                            let _e607 = (bitcast<f32>((bitcast<u32>((_e522.member.member_1.x - _e522.member.member.x)) & 2139095040u)) * 0.0000009536743f);
                                            let _e608 = (bitcast<f32>((bitcast<u32>((_e522.member.member_1.y - _e522.member.member.y)) & 2139095040u)) * 0.0000009536743f);
                                            let _e609 = (bitcast<f32>((bitcast<u32>((_e522.member.member_1.z - _e522.member.member.z)) & 2139095040u)) * 0.0000009536743f);
                                            let _e611 = select(_e129, _e607, (_e607 > _e129));
                                            let _e613 = select(_e129, _e608, (_e608 > _e129));
                                            let _e615 = select(_e129, _e609, (_e609 > _e129));
                                            let _e640 = bitcast<u32>((f32(bitcast<i32>((_e544 & 2097151u))) * _e611));
                                            let _e645 = (bitcast<i32>((_e544 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e648 = bitcast<f32>((_e640 & bitcast<u32>(_e645)));
                                            let _e649 = bitcast<u32>((f32(bitcast<i32>((_e552 & 2097151u))) * _e613));
                                            let _e654 = (bitcast<i32>((_e552 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e657 = bitcast<f32>((_e649 & bitcast<u32>(_e654)));
                                            let _e658 = bitcast<u32>((f32(bitcast<i32>((_e560 & 2097151u))) * _e615));
                                            let _e663 = (bitcast<i32>((_e560 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e666 = bitcast<f32>((_e658 & bitcast<u32>(_e663)));
                                            let _e670 = bitcast<f32>((_e640 & bitcast<u32>(~(_e645))));
                                            let _e674 = bitcast<f32>((_e649 & bitcast<u32>(~(_e654))));
                                            let _e678 = bitcast<f32>((_e658 & bitcast<u32>(~(_e663))));
                                            let _e679 = bitcast<u32>((f32(bitcast<i32>((_e568 & 2097151u))) * _e611));
                                            let _e684 = (bitcast<i32>((_e568 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e687 = bitcast<f32>((_e679 & bitcast<u32>(_e684)));
                                            let _e688 = bitcast<u32>((f32(bitcast<i32>((_e576 & 2097151u))) * _e613));
                                            let _e693 = (bitcast<i32>((_e576 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e696 = bitcast<f32>((_e688 & bitcast<u32>(_e693)));
                                            let _e697 = bitcast<u32>((f32(bitcast<i32>((_e584 & 2097151u))) * _e615));
                                            let _e702 = (bitcast<i32>((_e584 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e705 = bitcast<f32>((_e697 & bitcast<u32>(_e702)));
                                            let _e709 = bitcast<f32>((_e679 & bitcast<u32>(~(_e684))));
                                            let _e713 = bitcast<f32>((_e688 & bitcast<u32>(~(_e693))));
                                            let _e717 = bitcast<f32>((_e697 & bitcast<u32>(~(_e702))));
                                            let _e747 = global_5.member[_e522.member_1][0u];
                                            let _e751 = global_5.member[_e522.member_1][2u];
                                            let _e755 = global_5.member[_e522.member_1][4u];
                                            let _e759 = global_5.member[_e522.member_1][6u];
                                            let _e771 = (((_e751 >> bitcast<u32>(22i)) | ((_e755 >> bitcast<u32>(22i)) << bitcast<u32>(10i))) | ((_e759 >> bitcast<u32>(22i)) << bitcast<u32>(20i)));
                                            let _e772 = (_e747 & 268435455u);
                                            let _e773 = (_e771 & 268435455u);
                                            let _e776 = ((_e747 >> bitcast<u32>(28u)) & 7u);
                                            let _e784 = ((_e747 >> bitcast<u32>(31i)) | (((_e771 >> bitcast<u32>(28u)) & 3u) << bitcast<u32>(1i)));
                                            let _e785 = (_e776 != 0u);
                                            if (_e776 == 0u) {
                                                phi_3555_ = _e772;
                                            } else {
                                                if (_e776 == 7u) {
                                                    phi_3554_ = 2147483648u;
                                                } else {
                                                    phi_3554_ = ((2147483648u | (_e776 << bitcast<u32>(28u))) | (_e773 & 268435455u));
                                                }
                                                let _e794 = phi_3554_;
                                                phi_3555_ = _e794;
                                            }
                                            let _e796 = phi_3555_;
                                            if _e785 {
                                                let _e797 = (_e776 != 7u);
                                                if _e797 {
                                                    phi_3565_ = (_e773 + _e776);
                                                } else {
                                                    phi_3565_ = u32();
                                                }
                                                let _e800 = phi_3565_;
                                                phi_3567_ = _e800;
                                                phi_3568_ = select(true, false, _e797);
                                            } else {
                                                phi_3567_ = u32();
                                                phi_3568_ = true;
                                            }
                                            let _e803 = phi_3567_;
                                            let _e805 = phi_3568_;
                                            if (_e784 == 0u) {
                                                phi_3589_ = (_e772 + select(0u, 1u, !(_e785)));
                                            } else {
                                                if (_e784 == 7u) {
                                                    phi_3588_ = 2147483648u;
                                                } else {
                                                    phi_3588_ = ((2147483648u | (_e784 << bitcast<u32>(28u))) | (select(_e803, _e773, _e805) & 268435455u));
                                                }
                                                let _e818 = phi_3588_;
                                                phi_3589_ = _e818;
                                            }
                                            let _e820 = phi_3589_;
                                            phi_3593_ = type_51(array<vec4<f32>, 3>(vec4<f32>((_e522.member.member.x + _e648), (_e522.member.member.x + _e670), (_e522.member.member_1.x - _e687), (_e522.member.member_1.x - _e709)), vec4<f32>((_e522.member.member.y + _e657), (_e522.member.member.y + _e674), (_e522.member.member_1.y - _e696), (_e522.member.member_1.y - _e713)), vec4<f32>((_e522.member.member.z + _e666), (_e522.member.member.z + _e678), (_e522.member.member_1.z - _e705), (_e522.member.member_1.z - _e717))), type_48(type_28((_e522.member.member + vec4<f32>(_e648, _e657, _e666, 0f)), (_e522.member.member_1 - vec4<f32>(_e687, _e696, _e705, 0f))), _e796), type_48(type_28((_e522.member.member + vec4<f32>(_e670, _e674, _e678, 0f)), (_e522.member.member_1 - vec4<f32>(_e709, _e713, _e717, 0f))), _e820));
                                        }
                                        let _e825 = phi_3593_;
                                        let _e837 = ((_e825.member[0].x - _e321) * _e326);
                                        let _e838 = ((_e825.member[0].y - _e321) * _e326);
                                        let _e839 = ((_e825.member[0].z - _e322) * _e326);
                                        let _e840 = ((_e825.member[0].w - _e322) * _e326);
                                        let _e850 = ((_e825.member[1].x - _e359) * _e364);
                                        let _e851 = ((_e825.member[1].y - _e359) * _e364);
                                        let _e852 = ((_e825.member[1].z - _e360) * _e364);
                                        let _e853 = ((_e825.member[1].w - _e360) * _e364);
                                        let _e863 = ((_e825.member[2].x - _e397) * _e402);
                                        let _e864 = ((_e825.member[2].y - _e397) * _e402);
                                        let _e865 = ((_e825.member[2].z - _e398) * _e402);
                                        let _e866 = ((_e825.member[2].w - _e398) * _e402);
                                        let _e868 = select(_e865, _e863, (_e863 < _e865));
                                        let _e870 = select(_e866, _e864, (_e864 < _e866));
                                        let _e872 = select(_e865, _e863, (_e863 > _e865));
                                        let _e874 = select(_e866, _e864, (_e864 > _e866));
                                        let _e876 = select(_e839, _e837, (_e837 < _e839));
                                        let _e878 = select(_e840, _e838, (_e838 < _e840));
                                        let _e880 = select(_e852, _e850, (_e850 < _e852));
                                        let _e882 = select(_e853, _e851, (_e851 < _e853));
                                        let _e884 = select(_e880, _e876, (_e876 > _e880));
                                        let _e886 = select(_e882, _e878, (_e878 > _e882));
                                        let _e888 = select(_e868, _e884, (_e884 > _e868));
                                        let _e890 = select(_e870, _e886, (_e886 > _e870));
                                        let _e892 = select(_e839, _e837, (_e837 > _e839));
                                        let _e894 = select(_e840, _e838, (_e838 > _e840));
                                        let _e896 = select(_e852, _e850, (_e850 > _e852));
                                        let _e898 = select(_e853, _e851, (_e851 > _e853));
                                        let _e900 = select(_e896, _e892, (_e892 < _e896));
                                        let _e902 = select(_e898, _e894, (_e894 < _e898));
                                        let _e907 = -(_e868);
                                        let _e908 = -(_e870);
                                        let _e915 = (select(_e872, _e900, (_e900 < _e872)) + (select(_e907, _e872, (_e872 > _e907)) * 0.0000019073523f));
                                        let _e916 = (select(_e874, _e902, (_e902 < _e874)) + (select(_e908, _e874, (_e874 > _e908)) * 0.0000019073523f));
                                        let _e918 = select(_e449, _e888, (_e888 > _e449));
                                        let _e920 = select(_e449, _e890, (_e890 > _e449));
                                        let _e925 = (_e918 <= select(_e493.member_1, _e915, (_e915 < _e493.member_1)));
                                        let _e926 = (_e920 <= select(_e493.member_1, _e916, (_e916 < _e493.member_1)));
                                        let _e927 = (_e918 <= _e920);
                                        if _e925 {
                                            if _e926 {
                                                if _e927 {
                                                    phi_3937_ = _e825.member_2;
                                                } else {
                                                    phi_3937_ = _e825.member_1;
                                                }
                                                let _e931 = phi_3937_;
                                                let _e932 = (_e526 % 128u);
                                                let _e933 = (_e932 < 128u);
                                                if _e933 {
                                                } else {
                                                    phi_4357_ = true;
                                                    break;
                                                }
                                                local_3[_e932] = type_48(type_28(_e931.member.member, _e931.member.member_1), _e931.member_1);
                                                if _e933 {
                                                } else {
                                                    phi_4357_ = true;
                                                    break;
                                                }
                                                local_2[_e932] = select(_e920, _e918, (_e918 > _e920));
                                                if _e927 {
                                                    phi_3970_ = _e825.member_1;
                                                } else {
                                                    phi_3970_ = _e825.member_2;
                                                }
                                                let _e948 = phi_3970_;
                                                phi_3971_ = _e948;
                                                phi_3972_ = (_e526 + 1u);
                                            } else {
                                                phi_3971_ = type_48();
                                                phi_3972_ = u32();
                                            }
                                            let _e950 = phi_3971_;
                                            let _e952 = phi_3972_;
                                            phi_3974_ = _e950;
                                            phi_3975_ = _e952;
                                            phi_3976_ = select(true, false, _e926);
                                        } else {
                                            phi_3974_ = type_48();
                                            phi_3975_ = u32();
                                            phi_3976_ = true;
                                        }
                                        let _e955 = phi_3974_;
                                        let _e957 = phi_3975_;
                                        let _e959 = phi_3976_;
                                        if _e959 {
                                            if _e925 {
                                                phi_3985_ = _e825.member_1;
                                            } else {
                                                phi_3985_ = _e825.member_2;
                                            }
                                            let _e963 = phi_3985_;
                                            phi_3990_ = _e963;
                                            phi_3991_ = select(_e926, true, _e925);
                                        } else {
                                            phi_3990_ = _e955;
                                            phi_3991_ = _e524;
                                        }
                                        let _e966 = phi_3990_;
                                        let _e968 = phi_3991_;
                                        phi_4361_ = _e491;
                                        phi_3993_ = _e493;
                                        phi_3994_ = _e966;
                                        phi_3995_ = _e968;
                                        phi_3996_ = select(_e957, _e526, _e959);
                                    }
                                    let _e1379 = phi_4361_;
                                    let _e1381 = phi_3993_;
                                    let _e1383 = phi_3994_;
                                    let _e1385 = phi_3995_;
                                    let _e1387 = phi_3996_;
                                    phi_4360_ = _e1379;
                                    phi_3997_ = _e1381;
                                    phi_3998_ = _e1383;
                                    phi_3999_ = (_e497 - 1u);
                                    phi_4000_ = _e1385;
                                    phi_4001_ = _e1387;
                                } else {
                                    phi_4360_ = _e491;
                                    phi_3997_ = _e493;
                                    phi_3998_ = _e522;
                                    phi_3999_ = _e497;
                                    phi_4000_ = _e524;
                                    phi_4001_ = _e526;
                                }
                                let _e1389 = phi_4360_;
                                let _e1391 = phi_3997_;
                                let _e1393 = phi_3998_;
                                let _e1395 = phi_3999_;
                                let _e1397 = phi_4000_;
                                let _e1399 = phi_4001_;
                                phi_4359_ = _e1389;
                                phi_4002_ = _e1391;
                                phi_4003_ = _e1393;
                                phi_4004_ = _e1395;
                                phi_4005_ = _e1397;
                                phi_4006_ = _e1399;
                            } else {
                                phi_4359_ = _e491;
                                phi_4002_ = type_31();
                                phi_4003_ = type_48();
                                phi_4004_ = u32();
                                phi_4005_ = bool();
                                phi_4006_ = u32();
                            }
                            let _e1401 = phi_4359_;
                            let _e1403 = phi_4002_;
                            let _e1405 = phi_4003_;
                            let _e1407 = phi_4004_;
                            let _e1409 = phi_4005_;
                            let _e1411 = phi_4006_;
                            phi_4358_ = _e1401;
                            phi_1868_ = _e1403;
                            phi_1871_ = _e1405;
                            phi_1873_ = _e1407;
                            phi_1875_ = _e1409;
                            phi_1877_ = _e1411;
                            phi_4007_ = _e505;
                        } else {
                            phi_4358_ = _e491;
                            phi_1868_ = type_31();
                            phi_1871_ = type_48();
                            phi_1873_ = u32();
                            phi_1875_ = bool();
                            phi_1877_ = u32();
                            phi_4007_ = false;
                        }
                        let _e1413 = phi_4358_;
                        let _e1415 = phi_1868_;
                        let _e1417 = phi_1871_;
                        let _e1419 = phi_1873_;
                        let _e1421 = phi_1875_;
                        let _e1423 = phi_1877_;
                        let _e1425 = phi_4007_;
                        continue;
                        continuing {
                            phi_4249_ = _e1413;
                            phi_1867_ = _e1415;
                            phi_1870_ = _e1417;
                            phi_1872_ = _e1419;
                            phi_1874_ = _e1421;
                            phi_1876_ = _e1423;
                            phi_4357_ = _e1413;
                            break if !(_e1425);
                        }
                    }
                    let _e1428 = phi_4357_;
                    if _e1428 {
                        break;
                    }
                    let _e1430 = local_4;
                    if (_e1430.member.member_3 != 4294967295u) {
                        let _e1435 = -(_e416);
                        let _e1436 = (_e1435 / 3i);
                        let _e1443 = bitcast<f32>((bitcast<u32>((_e1436 + 127i)) << bitcast<u32>(23i)));
                        let _e1451 = (((_e1430.member.member * _e1443) * _e1443) * bitcast<f32>((bitcast<u32>(((_e1435 - (2i * _e1436)) + 127i)) << bitcast<u32>(23i))));
                        let _e1453 = select(340282350000000000000000000000000000000f, _e1451, (_e1451 < 340282350000000000000000000000000000000f));
                        phi_4059_ = type_20(select(-340282350000000000000000000000000000000f, _e1453, (_e1453 > -340282350000000000000000000000000000000f)), _e1430.member.member_1, _e1430.member.member_2, _e1430.member.member_3);
                    } else {
                        phi_4059_ = type_20(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                    }
                    let _e1460 = phi_4059_;
                    if _e137 {
                    } else {
                        break;
                    }
                    global_6.member[_e135] = _e1460;
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
