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

struct type_31 {
    member: type_24,
    member_1: f32,
}

struct type_36 {
    member: array<type_25>,
}

struct type_38 {
    member: type_31,
    member_1: u32,
    member_2: u32,
}

struct type_40 {
    member: array<vec4<u32>, 2>,
}

struct type_47 {
    member: array<array<u32, 7>>,
}

struct type_49 {
    member: type_28,
    member_1: u32,
}

struct type_52 {
    member: array<vec4<f32>, 3>,
    member_1: type_49,
    member_2: type_49,
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
var<storage> global_5: type_47;
@group(0) @binding(5) 
var<storage, read_write> global_6: type_21;

fn function_() {
    var local: array<i32, 3>;
    var local_1: array<i32, 3>;
    var local_2: array<f32, 128>;
    var local_3: array<type_49, 128>;
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
    var phi_4214_: bool;
    var phi_1869_: type_38;
    var phi_1872_: type_49;
    var phi_1874_: u32;
    var phi_1876_: bool;
    var phi_1878_: u32;
    var phi_1889_: bool;
    var phi_1926_: type_49;
    var phi_1927_: bool;
    var phi_1928_: u32;
    var phi_3563_: u32;
    var phi_3564_: u32;
    var phi_3574_: u32;
    var phi_3576_: u32;
    var phi_3577_: bool;
    var phi_3597_: u32;
    var phi_3598_: u32;
    var phi_3602_: type_52;
    var phi_3946_: type_49;
    var phi_3979_: type_49;
    var phi_3980_: type_49;
    var phi_3981_: u32;
    var phi_3983_: type_49;
    var phi_3984_: u32;
    var phi_3985_: bool;
    var phi_3994_: type_49;
    var phi_3999_: type_49;
    var phi_4000_: bool;
    var phi_1946_: type_38;
    var phi_1949_: type_4;
    var phi_1950_: type_4;
    var phi_1972_: type_4;
    var phi_1996_: u32;
    var phi_2085_: array<array<f32, 3>, 3>;
    var phi_2556_: vec3<f32>;
    var phi_2557_: vec3<f32>;
    var phi_2588_: bool;
    var phi_2597_: vec3<f32>;
    var phi_2637_: type_24;
    var phi_2639_: type_24;
    var phi_2640_: bool;
    var phi_2644_: type_24;
    var phi_2645_: type_24;
    var phi_2646_: type_24;
    var phi_2647_: bool;
    var phi_2651_: type_24;
    var phi_2652_: bool;
    var phi_2656_: type_24;
    var phi_2657_: bool;
    var phi_2661_: type_24;
    var phi_2686_: bool;
    var phi_2687_: bool;
    var phi_2694_: type_38;
    var phi_2695_: type_38;
    var phi_2696_: type_38;
    var phi_1947_: type_38;
    var phi_4208_: bool;
    var phi_4326_: bool;
    var phi_4002_: type_38;
    var phi_4003_: type_49;
    var phi_4004_: bool;
    var phi_4005_: u32;
    var phi_4325_: bool;
    var phi_4006_: type_38;
    var phi_4007_: type_49;
    var phi_4008_: u32;
    var phi_4009_: bool;
    var phi_4010_: u32;
    var phi_4324_: bool;
    var phi_4011_: type_38;
    var phi_4012_: type_49;
    var phi_4013_: u32;
    var phi_4014_: bool;
    var phi_4015_: u32;
    var phi_4323_: bool;
    var phi_1870_: type_38;
    var phi_1873_: type_49;
    var phi_1875_: u32;
    var phi_1877_: bool;
    var phi_1879_: u32;
    var phi_4016_: bool;
    var phi_4322_: bool;
    var local_4: type_38;
    var local_5: type_38;
    var local_6: type_38;

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
                            phi_378_ = (bitcast<i32>((_e214 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_378_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e214)), 32u, (_e214 == 0u))));
                        }
                        let _e228 = phi_378_;
                        phi_379_ = _e228;
                    } else {
                        phi_379_ = 0i;
                    }
                    let _e230 = phi_379_;
                    let _e231 = (_e147 == _e186);
                    if _e231 {
                        phi_389_ = true;
                    } else {
                        phi_389_ = (_e154 == _e186);
                    }
                    let _e234 = phi_389_;
                    let _e235 = select(1u, 0u, _e231);
                    if _e234 {
                        let _e236 = (_e235 + 1u);
                        phi_399_ = _e236;
                        phi_400_ = _e236;
                        phi_402_ = select(true, false, (_e236 == 2u));
                    } else {
                        phi_399_ = u32();
                        phi_400_ = 0u;
                        phi_402_ = true;
                    }
                    let _e240 = phi_399_;
                    let _e242 = phi_400_;
                    let _e244 = phi_402_;
                    if _e244 {
                        phi_407_ = (_e242 + 1u);
                    } else {
                        phi_407_ = 0u;
                    }
                    let _e248 = phi_407_;
                    let _e249 = select(_e240, _e242, _e244);
                    let _e250 = select(_e235, select(2u, _e235, _e234), _e244);
                    if (_e117 < -126i) {
                        phi_420_ = -126i;
                    } else {
                        phi_420_ = select(_e117, 127i, (_e117 > 127i));
                    }
                    let _e255 = phi_420_;
                    let _e260 = bitcast<f32>((bitcast<u32>((_e255 + 127i)) << bitcast<u32>(23i)));
                    let _e266 = bitcast<f32>((bitcast<u32>(((_e117 - _e255) + 127i)) << bitcast<u32>(23i)));
                    let _e267 = -(_e230);
                    if (_e267 < -126i) {
                        phi_440_ = -126i;
                    } else {
                        phi_440_ = select(_e267, 127i, (_e267 > 127i));
                    }
                    let _e272 = phi_440_;
                    let _e277 = bitcast<f32>((bitcast<u32>((_e272 + 127i)) << bitcast<u32>(23i)));
                    let _e283 = bitcast<f32>((bitcast<u32>(((_e267 - _e272) + 127i)) << bitcast<u32>(23i)));
                    let _e287 = global_4.member[_e135].member;
                    let _e288 = (_e249 == 0u);
                    if _e288 {
                        phi_458_ = _e287[0];
                    } else {
                        phi_458_ = _e287[1];
                    }
                    let _e292 = phi_458_;
                    let _e293 = (_e249 == 2u);
                    if _e293 {
                        phi_464_ = _e287[2];
                    } else {
                        phi_464_ = _e292;
                    }
                    let _e296 = phi_464_;
                    let _e298 = ((_e296 * _e260) * _e266);
                    let _e299 = global_4.member[_e135].member_2;
                    if _e288 {
                        phi_475_ = _e299[0];
                    } else {
                        phi_475_ = _e299[1];
                    }
                    let _e303 = phi_475_;
                    if _e293 {
                        phi_481_ = _e299[2];
                    } else {
                        phi_481_ = _e303;
                    }
                    let _e306 = phi_481_;
                    let _e308 = ((_e306 * _e277) * _e283);
                    let _e312 = (bitcast<f32>((bitcast<u32>(_e308) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e312 {
                        let _e316 = (bitcast<f32>((bitcast<u32>(_e298) & 2147483647u)) * 0.00000011920929f);
                        phi_504_ = select(0.00000000000011368684f, _e316, (_e316 > 0.00000000000011368684f));
                    } else {
                        phi_504_ = 0f;
                    }
                    let _e320 = phi_504_;
                    let _e321 = (_e298 + _e320);
                    let _e322 = (_e298 - _e320);
                    let _e323 = select(_e308, 0f, _e312);
                    if _e312 {
                        phi_515_ = 38685626000000000000000000f;
                    } else {
                        phi_515_ = (1f / _e308);
                    }
                    let _e326 = phi_515_;
                    let _e327 = (_e248 == 0u);
                    if _e327 {
                        phi_524_ = _e287[0];
                    } else {
                        phi_524_ = _e287[1];
                    }
                    let _e331 = phi_524_;
                    let _e332 = (_e248 == 2u);
                    if _e332 {
                        phi_530_ = _e287[2];
                    } else {
                        phi_530_ = _e331;
                    }
                    let _e335 = phi_530_;
                    let _e337 = ((_e335 * _e260) * _e266);
                    if _e327 {
                        phi_541_ = _e299[0];
                    } else {
                        phi_541_ = _e299[1];
                    }
                    let _e341 = phi_541_;
                    if _e332 {
                        phi_547_ = _e299[2];
                    } else {
                        phi_547_ = _e341;
                    }
                    let _e344 = phi_547_;
                    let _e346 = ((_e344 * _e277) * _e283);
                    let _e350 = (bitcast<f32>((bitcast<u32>(_e346) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e350 {
                        let _e354 = (bitcast<f32>((bitcast<u32>(_e337) & 2147483647u)) * 0.00000011920929f);
                        phi_570_ = select(0.00000000000011368684f, _e354, (_e354 > 0.00000000000011368684f));
                    } else {
                        phi_570_ = 0f;
                    }
                    let _e358 = phi_570_;
                    let _e359 = (_e337 + _e358);
                    let _e360 = (_e337 - _e358);
                    let _e361 = select(_e346, 0f, _e350);
                    if _e350 {
                        phi_581_ = 38685626000000000000000000f;
                    } else {
                        phi_581_ = (1f / _e346);
                    }
                    let _e364 = phi_581_;
                    let _e365 = (_e250 == 0u);
                    if _e365 {
                        phi_590_ = _e287[0];
                    } else {
                        phi_590_ = _e287[1];
                    }
                    let _e369 = phi_590_;
                    let _e370 = (_e250 == 2u);
                    if _e370 {
                        phi_596_ = _e287[2];
                    } else {
                        phi_596_ = _e369;
                    }
                    let _e373 = phi_596_;
                    let _e375 = ((_e373 * _e260) * _e266);
                    if _e365 {
                        phi_607_ = _e299[0];
                    } else {
                        phi_607_ = _e299[1];
                    }
                    let _e379 = phi_607_;
                    if _e370 {
                        phi_613_ = _e299[2];
                    } else {
                        phi_613_ = _e379;
                    }
                    let _e382 = phi_613_;
                    let _e384 = ((_e382 * _e277) * _e283);
                    let _e388 = (bitcast<f32>((bitcast<u32>(_e384) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e388 {
                        let _e392 = (bitcast<f32>((bitcast<u32>(_e375) & 2147483647u)) * 0.00000011920929f);
                        phi_636_ = select(0.00000000000011368684f, _e392, (_e392 > 0.00000000000011368684f));
                    } else {
                        phi_636_ = 0f;
                    }
                    let _e396 = phi_636_;
                    let _e397 = (_e375 + _e396);
                    let _e398 = (_e375 - _e396);
                    let _e399 = select(_e384, 0f, _e388);
                    if _e388 {
                        phi_647_ = 38685626000000000000000000f;
                    } else {
                        phi_647_ = (1f / _e384);
                    }
                    let _e402 = phi_647_;
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
                        phi_747_ = select(-340282350000000000000000000000000000000f, _e443, (_e443 > -340282350000000000000000000000000000000f));
                        phi_748_ = select(-340282350000000000000000000000000000000f, _e436, (_e436 > -340282350000000000000000000000000000000f));
                    } else {
                        phi_747_ = 0f;
                        phi_748_ = 1f;
                    }
                    let _e447 = phi_747_;
                    let _e449 = phi_748_;
                    local_3 = array<type_49, 128>(type_49(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u));
                    local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    let _e454 = (_e249 % 3u);
                    let _e455 = (_e454 < 3u);
                    if _e455 {
                    } else {
                        break;
                    }
                    let _e457 = local_1[_e454];
                    let _e460 = (_e248 % 3u);
                    let _e461 = (_e460 < 3u);
                    if _e461 {
                    } else {
                        break;
                    }
                    let _e463 = local_1[_e460];
                    let _e466 = (_e250 % 3u);
                    let _e467 = (_e466 < 3u);
                    if _e467 {
                    } else {
                        break;
                    }
                    let _e469 = local_1[_e466];
                    if _e455 {
                    } else {
                        break;
                    }
                    let _e474 = local[_e454];
                    if _e461 {
                    } else {
                        break;
                    }
                    let _e478 = local[_e460];
                    if _e467 {
                    } else {
                        break;
                    }
                    let _e482 = local[_e466];
                    phi_4214_ = false;
                    phi_1869_ = type_38(type_31(type_24(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e447), 0u, 0u);
                    phi_1872_ = type_49(type_28(vec4<f32>((f32(_e457) * _e129), (f32(_e463) * _e129), (f32(_e469) * _e129), 0f), vec4<f32>((f32(_e474) * _e129), (f32(_e478) * _e129), (f32(_e482) * _e129), 0f)), select(0u, 2147483648u, (_e79 == 0u)));
                    phi_1874_ = ((3u * _e79) + 1u);
                    phi_1876_ = (_e449 <= _e447);
                    phi_1878_ = 0u;
                    loop {
                        let _e492 = phi_4214_;
                        let _e494 = phi_1869_;
                        let _e496 = phi_1872_;
                        let _e498 = phi_1874_;
                        let _e500 = phi_1876_;
                        let _e502 = phi_1878_;
                        local_4 = _e494;
                        local_5 = _e494;
                        if _e500 {
                            phi_1889_ = true;
                        } else {
                            phi_1889_ = (_e502 > 0u);
                        }
                        let _e505 = phi_1889_;
                        if _e505 {
                            let _e506 = (_e498 > 0u);
                            if _e506 {
                                if _e500 {
                                    phi_1926_ = _e496;
                                    phi_1927_ = _e500;
                                    phi_1928_ = _e502;
                                } else {
                                    let _e507 = (_e502 - 1u);
                                    let _e508 = (_e507 % 128u);
                                    let _e509 = (_e508 < 128u);
                                    if _e509 {
                                    } else {
                                        phi_4322_ = true;
                                        break;
                                    }
                                    let _e511 = local_3[_e508];
                                    if _e509 {
                                    } else {
                                        phi_4322_ = true;
                                        break;
                                    }
                                    let _e519 = local_2[_e508];
                                    phi_1926_ = type_49(type_28(_e511.member.member, _e511.member.member_1), _e511.member_1);
                                    phi_1927_ = (_e519 <= _e494.member.member_1);
                                    phi_1928_ = _e507;
                                }
                                let _e524 = phi_1926_;
                                let _e526 = phi_1927_;
                                let _e528 = phi_1928_;
                                if _e526 {
                                    if ((_e524.member_1 & 2147483648u) != 0u) {
                                        phi_1946_ = _e494;
                                        phi_1949_ = type_4(0u, ((_e524.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e981 = phi_1946_;
                                            let _e983 = phi_1949_;
                                            local_6 = _e981;
                                            if (_e983.member < _e983.member_1) {
                                                phi_1950_ = type_4((_e983.member + 1u), _e983.member_1);
                                                phi_1972_ = type_4(1u, _e983.member);
                                            } else {
                                                phi_1950_ = _e983;
                                                phi_1972_ = type_4(0u, type_4().member_1);
                                            }
                                            let _e996 = phi_1950_;
                                            let _e998 = phi_1972_;
                                            let _e1002 = (bitcast<i32>(_e998.member) != 0i);
                                            if _e1002 {
                                                let _e1008 = type_38(_e981.member, _e981.member_1, (_e981.member_2 + 1u));
                                                let _e1009 = ((_e524.member_1 & 268435455u) + _e998.member_1);
                                                let _e1010 = (_e1009 < _e81);
                                                if _e1010 {
                                                    if _e1010 {
                                                    } else {
                                                        phi_4208_ = true;
                                                        break;
                                                    }
                                                    let _e1014 = global_2.member[_e1009].member_1;
                                                    phi_1996_ = _e1014;
                                                } else {
                                                    phi_1996_ = 4294967295u;
                                                }
                                                let _e1016 = phi_1996_;
                                                if (_e1009 >= _e81) {
                                                    phi_2085_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                } else {
                                                    if _e1010 {
                                                    } else {
                                                        phi_4208_ = true;
                                                        break;
                                                    }
                                                    if (_e454 < 9u) {
                                                    } else {
                                                        phi_4208_ = true;
                                                        break;
                                                    }
                                                    let _e1023 = global_2.member[_e1009].member[_e454];
                                                    if (_e460 < 9u) {
                                                    } else {
                                                        phi_4208_ = true;
                                                        break;
                                                    }
                                                    let _e1029 = global_2.member[_e1009].member[_e460];
                                                    if (_e466 < 9u) {
                                                    } else {
                                                        phi_4208_ = true;
                                                        break;
                                                    }
                                                    let _e1035 = global_2.member[_e1009].member[_e466];
                                                    let _e1037 = (3u + _e454);
                                                    if (_e1037 < 9u) {
                                                    } else {
                                                        phi_4208_ = true;
                                                        break;
                                                    }
                                                    let _e1043 = global_2.member[_e1009].member[_e1037];
                                                    let _e1044 = (3u + _e460);
                                                    if (_e1044 < 9u) {
                                                    } else {
                                                        phi_4208_ = true;
                                                        break;
                                                    }
                                                    let _e1050 = global_2.member[_e1009].member[_e1044];
                                                    let _e1051 = (3u + _e466);
                                                    if (_e1051 < 9u) {
                                                    } else {
                                                        phi_4208_ = true;
                                                        break;
                                                    }
                                                    let _e1057 = global_2.member[_e1009].member[_e1051];
                                                    let _e1059 = (6u + _e454);
                                                    if (_e1059 < 9u) {
                                                    } else {
                                                        phi_4208_ = true;
                                                        break;
                                                    }
                                                    let _e1065 = global_2.member[_e1009].member[_e1059];
                                                    let _e1066 = (6u + _e460);
                                                    if (_e1066 < 9u) {
                                                    } else {
                                                        phi_4208_ = true;
                                                        break;
                                                    }
                                                    let _e1072 = global_2.member[_e1009].member[_e1066];
                                                    let _e1073 = (6u + _e466);
                                                    if (_e1073 < 9u) {
                                                    } else {
                                                        phi_4208_ = true;
                                                        break;
                                                    }
                                                    let _e1079 = global_2.member[_e1009].member[_e1073];
                                                    phi_2085_ = array<array<f32, 3>, 3>(array<f32, 3>(_e1023, _e1029, _e1035), array<f32, 3>(_e1043, _e1050, _e1057), array<f32, 3>(_e1065, _e1072, _e1079));
                                                }
                                                let _e1083 = phi_2085_;
                                                let _e1092 = (_e1083[0][2] - _e375);
                                                let _e1095 = (((_e1083[0][0] - _e298) * _e399) - (_e1092 * _e323));
                                                let _e1098 = (((_e1083[0][1] - _e337) * _e399) - (_e1092 * _e361));
                                                let _e1105 = (_e1083[1][2] - _e375);
                                                let _e1108 = (((_e1083[1][0] - _e298) * _e399) - (_e1105 * _e323));
                                                let _e1111 = (((_e1083[1][1] - _e337) * _e399) - (_e1105 * _e361));
                                                let _e1118 = (_e1083[2][2] - _e375);
                                                let _e1121 = (((_e1083[2][0] - _e298) * _e399) - (_e1118 * _e323));
                                                let _e1124 = (((_e1083[2][1] - _e337) * _e399) - (_e1118 * _e361));
                                                let _e1125 = (_e1121 * _e1111);
                                                let _e1126 = (_e1124 * _e1108);
                                                let _e1127 = (_e1095 * _e1124);
                                                let _e1128 = (_e1098 * _e1121);
                                                let _e1129 = (_e1108 * _e1098);
                                                let _e1130 = (_e1111 * _e1095);
                                                let _e1135 = (((_e1125 >= _e1126) && (_e1127 >= _e1128)) && (_e1129 >= _e1130));
                                                if (_e1135 || (((_e1125 <= _e1126) && (_e1127 <= _e1128)) && (_e1129 <= _e1130))) {
                                                    let _e1142 = select(-1f, 1f, _e1135);
                                                    let _e1144 = ((_e1125 - _e1126) * _e1142);
                                                    let _e1146 = select(0f, _e1144, (_e1144 > 0f));
                                                    let _e1148 = ((_e1127 - _e1128) * _e1142);
                                                    let _e1150 = select(0f, _e1148, (_e1148 > 0f));
                                                    let _e1152 = ((_e1129 - _e1130) * _e1142);
                                                    let _e1154 = select(0f, _e1152, (_e1152 > 0f));
                                                    let _e1156 = ((_e1146 + _e1150) + _e1154);
                                                    if (_e1156 < 0.000000000000000000000000000000000000011754944f) {
                                                        phi_2651_ = type_24();
                                                        phi_2652_ = true;
                                                    } else {
                                                        let _e1159 = select(_e1083[1][0], _e1083[0][0], (_e1083[0][0] < _e1083[1][0]));
                                                        let _e1163 = select(_e1083[1][0], _e1083[0][0], (_e1083[0][0] > _e1083[1][0]));
                                                        let _e1167 = select(_e1083[1][1], _e1083[0][1], (_e1083[0][1] < _e1083[1][1]));
                                                        let _e1171 = select(_e1083[1][1], _e1083[0][1], (_e1083[0][1] > _e1083[1][1]));
                                                        let _e1175 = select(_e1083[1][2], _e1083[0][2], (_e1083[0][2] < _e1083[1][2]));
                                                        let _e1179 = select(_e1083[1][2], _e1083[0][2], (_e1083[0][2] > _e1083[1][2]));
                                                        let _e1184 = ((select(_e1083[2][0], _e1159, (_e1159 < _e1083[2][0])) - _e321) * _e326);
                                                        let _e1185 = ((select(_e1083[2][0], _e1163, (_e1163 > _e1083[2][0])) - _e322) * _e326);
                                                        let _e1188 = ((select(_e1083[2][1], _e1167, (_e1167 < _e1083[2][1])) - _e359) * _e364);
                                                        let _e1189 = ((select(_e1083[2][1], _e1171, (_e1171 > _e1083[2][1])) - _e360) * _e364);
                                                        let _e1192 = ((select(_e1083[2][2], _e1175, (_e1175 < _e1083[2][2])) - _e397) * _e402);
                                                        let _e1193 = ((select(_e1083[2][2], _e1179, (_e1179 > _e1083[2][2])) - _e398) * _e402);
                                                        let _e1195 = select(_e1193, _e1192, (_e1192 < _e1193));
                                                        let _e1197 = select(_e1193, _e1192, (_e1192 > _e1193));
                                                        let _e1199 = select(_e1185, _e1184, (_e1184 < _e1185));
                                                        let _e1201 = select(_e1189, _e1188, (_e1188 < _e1189));
                                                        let _e1203 = select(_e1201, _e1199, (_e1199 > _e1201));
                                                        let _e1205 = select(_e1195, _e1203, (_e1203 > _e1195));
                                                        let _e1207 = select(_e1185, _e1184, (_e1184 > _e1185));
                                                        let _e1209 = select(_e1189, _e1188, (_e1188 > _e1189));
                                                        let _e1211 = select(_e1209, _e1207, (_e1207 < _e1209));
                                                        let _e1213 = select(_e1197, _e1211, (_e1211 < _e1197));
                                                        let _e1214 = -(_e1195);
                                                        let _e1220 = select(_e449, _e1205, (_e1205 > _e449));
                                                        if (_e1220 > (_e1213 + (select(_e1214, _e1197, (_e1197 > _e1214)) * 0.0000019073523f))) {
                                                            phi_2646_ = type_24();
                                                            phi_2647_ = true;
                                                        } else {
                                                            let _e1222 = (_e1220 > _e981.member.member_1);
                                                            if _e1222 {
                                                                phi_2645_ = type_24();
                                                            } else {
                                                                let _e1226 = (_e1083[1][0] - _e1083[0][0]);
                                                                let _e1227 = (_e1083[1][1] - _e1083[0][1]);
                                                                let _e1228 = (_e1083[1][2] - _e1083[0][2]);
                                                                let _e1229 = vec3<f32>(_e1226, _e1227, _e1228);
                                                                let _e1230 = (_e1083[2][0] - _e1083[1][0]);
                                                                let _e1231 = (_e1083[2][1] - _e1083[1][1]);
                                                                let _e1232 = (_e1083[2][2] - _e1083[1][2]);
                                                                let _e1233 = vec3<f32>(_e1230, _e1231, _e1232);
                                                                let _e1234 = (_e1083[0][0] - _e1083[2][0]);
                                                                let _e1235 = (_e1083[0][1] - _e1083[2][1]);
                                                                let _e1236 = (_e1083[0][2] - _e1083[2][2]);
                                                                let _e1237 = vec3<f32>(_e1234, _e1235, _e1236);
                                                                let _e1240 = bitcast<f32>((bitcast<u32>(_e1226) & 2147483647u));
                                                                let _e1243 = bitcast<f32>((bitcast<u32>(_e1227) & 2147483647u));
                                                                let _e1245 = select(_e1243, _e1240, (_e1240 > _e1243));
                                                                let _e1248 = bitcast<f32>((bitcast<u32>(_e1228) & 2147483647u));
                                                                let _e1250 = select(_e1248, _e1245, (_e1245 > _e1248));
                                                                let _e1253 = bitcast<f32>((bitcast<u32>(_e1230) & 2147483647u));
                                                                let _e1256 = bitcast<f32>((bitcast<u32>(_e1231) & 2147483647u));
                                                                let _e1258 = select(_e1256, _e1253, (_e1253 > _e1256));
                                                                let _e1261 = bitcast<f32>((bitcast<u32>(_e1232) & 2147483647u));
                                                                let _e1263 = select(_e1261, _e1258, (_e1258 > _e1261));
                                                                let _e1266 = bitcast<f32>((bitcast<u32>(_e1234) & 2147483647u));
                                                                let _e1269 = bitcast<f32>((bitcast<u32>(_e1235) & 2147483647u));
                                                                let _e1271 = select(_e1269, _e1266, (_e1266 > _e1269));
                                                                let _e1274 = bitcast<f32>((bitcast<u32>(_e1236) & 2147483647u));
                                                                let _e1276 = select(_e1274, _e1271, (_e1271 > _e1274));
                                                                let _e1278 = select(_e1263, _e1250, (_e1250 > _e1263));
                                                                let _e1280 = select(_e1276, _e1278, (_e1278 > _e1276));
                                                                if (_e1250 == _e1280) {
                                                                    phi_2556_ = _e1233;
                                                                    phi_2557_ = _e1237;
                                                                } else {
                                                                    let _e1283 = vec3((_e1263 == _e1280));
                                                                    phi_2556_ = select(_e1229, _e1237, _e1283);
                                                                    phi_2557_ = select(_e1233, _e1229, _e1283);
                                                                }
                                                                let _e1287 = phi_2556_;
                                                                let _e1289 = phi_2557_;
                                                                let _e1296 = ((_e1287.y * _e1289.z) - (_e1289.y * _e1287.z));
                                                                let _e1301 = ((_e1287.z * _e1289.x) - (_e1289.z * _e1287.x));
                                                                let _e1304 = ((_e1287.x * _e1289.y) - (_e1289.x * _e1287.y));
                                                                if (_e1146 >= _e1150) {
                                                                    phi_2588_ = select(true, false, (_e1146 >= _e1154));
                                                                } else {
                                                                    phi_2588_ = true;
                                                                }
                                                                let _e1309 = phi_2588_;
                                                                if _e1309 {
                                                                    phi_2597_ = select(vec3<f32>(_e1083[2][0], _e1083[2][1], _e1083[2][2]), vec3<f32>(_e1083[1][0], _e1083[1][1], _e1083[1][2]), vec3((_e1150 >= _e1154)));
                                                                } else {
                                                                    phi_2597_ = vec3<f32>(_e1083[0][0], _e1083[0][1], _e1083[0][2]);
                                                                }
                                                                let _e1314 = phi_2597_;
                                                                let _e1331 = ((((_e1296 * (_e1314.x - _e298)) + (_e1301 * (_e1314.y - _e337))) + (_e1304 * (_e1314.z - _e375))) / (((_e1296 * _e323) + (_e1301 * _e361)) + (_e1304 * _e399)));
                                                                let _e1333 = select(_e1213, _e1331, (_e1331 < _e1213));
                                                                let _e1335 = select(_e1205, _e1333, (_e1333 > _e1205));
                                                                if (_e1335 >= _e449) {
                                                                    let _e1337 = (_e1335 <= _e981.member.member_1);
                                                                    if _e1337 {
                                                                        let _e1338 = (1f / _e1156);
                                                                        phi_2637_ = type_24(_e1335, (_e1150 * _e1338), (_e1154 * _e1338), _e1016);
                                                                    } else {
                                                                        phi_2637_ = type_24();
                                                                    }
                                                                    let _e1343 = phi_2637_;
                                                                    phi_2639_ = _e1343;
                                                                    phi_2640_ = select(true, false, _e1337);
                                                                } else {
                                                                    phi_2639_ = type_24();
                                                                    phi_2640_ = true;
                                                                }
                                                                let _e1346 = phi_2639_;
                                                                let _e1348 = phi_2640_;
                                                                if _e1348 {
                                                                    phi_2644_ = type_24(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                } else {
                                                                    phi_2644_ = _e1346;
                                                                }
                                                                let _e1350 = phi_2644_;
                                                                phi_2645_ = _e1350;
                                                            }
                                                            let _e1352 = phi_2645_;
                                                            phi_2646_ = _e1352;
                                                            phi_2647_ = _e1222;
                                                        }
                                                        let _e1354 = phi_2646_;
                                                        let _e1356 = phi_2647_;
                                                        phi_2651_ = _e1354;
                                                        phi_2652_ = _e1356;
                                                    }
                                                    let _e1358 = phi_2651_;
                                                    let _e1360 = phi_2652_;
                                                    phi_2656_ = _e1358;
                                                    phi_2657_ = _e1360;
                                                } else {
                                                    phi_2656_ = type_24();
                                                    phi_2657_ = true;
                                                }
                                                let _e1362 = phi_2656_;
                                                let _e1364 = phi_2657_;
                                                if _e1364 {
                                                    phi_2661_ = type_24(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                } else {
                                                    phi_2661_ = _e1362;
                                                }
                                                let _e1366 = phi_2661_;
                                                if (_e1366.member_3 != 4294967295u) {
                                                    if (_e1016 != 4294967295u) {
                                                        if (_e1366.member < _e981.member.member.member) {
                                                            phi_2687_ = true;
                                                        } else {
                                                            if (_e1366.member == _e981.member.member.member) {
                                                                phi_2686_ = (_e1366.member_3 < _e981.member.member.member_3);
                                                            } else {
                                                                phi_2686_ = false;
                                                            }
                                                            let _e1381 = phi_2686_;
                                                            phi_2687_ = _e1381;
                                                        }
                                                        let _e1383 = phi_2687_;
                                                        if _e1383 {
                                                            phi_2694_ = type_38(type_31(_e1366, _e1366.member), _e1008.member_1, _e1008.member_2);
                                                        } else {
                                                            phi_2694_ = _e1008;
                                                        }
                                                        let _e1390 = phi_2694_;
                                                        phi_2695_ = _e1390;
                                                    } else {
                                                        phi_2695_ = _e1008;
                                                    }
                                                    let _e1392 = phi_2695_;
                                                    phi_2696_ = _e1392;
                                                } else {
                                                    phi_2696_ = _e1008;
                                                }
                                                let _e1394 = phi_2696_;
                                                phi_1947_ = _e1394;
                                            } else {
                                                phi_1947_ = type_38();
                                            }
                                            let _e1396 = phi_1947_;
                                            continue;
                                            continuing {
                                                phi_1946_ = _e1396;
                                                phi_1949_ = _e996;
                                                phi_4208_ = _e492;
                                                break if !(_e1002);
                                            }
                                        }
                                        let _e1399 = phi_4208_;
                                        phi_4322_ = _e1399;
                                        if _e1399 {
                                            break;
                                        }
                                        phi_4326_ = _e1399;
                                        let _e1552 = local_6;
                                        phi_4002_ = _e1552;
                                        phi_4003_ = _e524;
                                        phi_4004_ = false;
                                        phi_4005_ = _e528;
                                    } else {
                                        if (_e524.member_1 >= _e79) {
                                            phi_3602_ = type_52(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), type_49(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u), type_49(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u));
                                        } else {
                                            if (_e524.member_1 < _e79) {
                                            } else {
                                                phi_4322_ = true;
                                                break;
                                            }
                                            let _e547 = ((1u + (_e249 * 2u)) % 7u);
                                            if (_e547 < 7u) {
                                            } else {
                                                phi_4322_ = true;
                                                break;
                                            }
                                            let _e552 = global_5.member[_e524.member_1][_e547];
                                            let _e555 = ((1u + (_e248 * 2u)) % 7u);
                                            if (_e555 < 7u) {
                                            } else {
                                                phi_4322_ = true;
                                                break;
                                            }
                                            let _e560 = global_5.member[_e524.member_1][_e555];
                                            let _e563 = ((1u + (_e250 * 2u)) % 7u);
                                            if (_e563 < 7u) {
                                            } else {
                                                phi_4322_ = true;
                                                break;
                                            }
                                            let _e568 = global_5.member[_e524.member_1][_e563];
                                            let _e571 = (((_e249 + 1u) * 2u) % 7u);
                                            if (_e571 < 7u) {
                                            } else {
                                                phi_4322_ = true;
                                                break;
                                            }
                                            let _e576 = global_5.member[_e524.member_1][_e571];
                                            let _e579 = (((_e248 + 1u) * 2u) % 7u);
                                            if (_e579 < 7u) {
                                            } else {
                                                phi_4322_ = true;
                                                break;
                                            }
                                            let _e584 = global_5.member[_e524.member_1][_e579];
                                            let _e587 = (((_e250 + 1u) * 2u) % 7u);
                                            if (_e587 < 7u) {
                                            } else {
                                                phi_4322_ = true;
                                                break;
                                            }
                                            let _e592 = global_5.member[_e524.member_1][_e587];
                                            let _e615 = (bitcast<f32>((bitcast<u32>((_e524.member.member_1.x - _e524.member.member.x)) & 2139095040u)) * 0.0000009536743f);
                                            let _e616 = (bitcast<f32>((bitcast<u32>((_e524.member.member_1.y - _e524.member.member.y)) & 2139095040u)) * 0.0000009536743f);
                                            let _e617 = (bitcast<f32>((bitcast<u32>((_e524.member.member_1.z - _e524.member.member.z)) & 2139095040u)) * 0.0000009536743f);
                                            let _e619 = select(_e129, _e615, (_e615 > _e129));
                                            let _e621 = select(_e129, _e616, (_e616 > _e129));
                                            let _e623 = select(_e129, _e617, (_e617 > _e129));
                                            let _e648 = bitcast<u32>((f32(bitcast<i32>((_e552 & 2097151u))) * _e619));
                                            let _e653 = (bitcast<i32>((_e552 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e656 = bitcast<f32>((_e648 & bitcast<u32>(_e653)));
                                            let _e657 = bitcast<u32>((f32(bitcast<i32>((_e560 & 2097151u))) * _e621));
                                            let _e662 = (bitcast<i32>((_e560 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e665 = bitcast<f32>((_e657 & bitcast<u32>(_e662)));
                                            let _e666 = bitcast<u32>((f32(bitcast<i32>((_e568 & 2097151u))) * _e623));
                                            let _e671 = (bitcast<i32>((_e568 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e674 = bitcast<f32>((_e666 & bitcast<u32>(_e671)));
                                            let _e678 = bitcast<f32>((_e648 & bitcast<u32>(~(_e653))));
                                            let _e682 = bitcast<f32>((_e657 & bitcast<u32>(~(_e662))));
                                            let _e686 = bitcast<f32>((_e666 & bitcast<u32>(~(_e671))));
                                            let _e687 = bitcast<u32>((f32(bitcast<i32>((_e576 & 2097151u))) * _e619));
                                            let _e692 = (bitcast<i32>((_e576 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e695 = bitcast<f32>((_e687 & bitcast<u32>(_e692)));
                                            let _e696 = bitcast<u32>((f32(bitcast<i32>((_e584 & 2097151u))) * _e621));
                                            let _e701 = (bitcast<i32>((_e584 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e704 = bitcast<f32>((_e696 & bitcast<u32>(_e701)));
                                            let _e705 = bitcast<u32>((f32(bitcast<i32>((_e592 & 2097151u))) * _e623));
                                            let _e710 = (bitcast<i32>((_e592 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e713 = bitcast<f32>((_e705 & bitcast<u32>(_e710)));
                                            let _e717 = bitcast<f32>((_e687 & bitcast<u32>(~(_e692))));
                                            let _e721 = bitcast<f32>((_e696 & bitcast<u32>(~(_e701))));
                                            let _e725 = bitcast<f32>((_e705 & bitcast<u32>(~(_e710))));
                                            let _e755 = global_5.member[_e524.member_1][0u];
                                            let _e759 = global_5.member[_e524.member_1][2u];
                                            let _e763 = global_5.member[_e524.member_1][4u];
                                            let _e767 = global_5.member[_e524.member_1][6u];
                                            let _e779 = (((_e759 >> bitcast<u32>(22i)) | ((_e763 >> bitcast<u32>(22i)) << bitcast<u32>(10i))) | ((_e767 >> bitcast<u32>(22i)) << bitcast<u32>(20i)));
                                            let _e780 = (_e755 & 268435455u);
                                            let _e781 = (_e779 & 268435455u);
                                            let _e784 = ((_e755 >> bitcast<u32>(28u)) & 7u);
                                            let _e792 = ((_e755 >> bitcast<u32>(31i)) | (((_e779 >> bitcast<u32>(28u)) & 3u) << bitcast<u32>(1i)));
                                            let _e793 = (_e784 != 0u);
                                            if (_e784 == 0u) {
                                                phi_3564_ = _e780;
                                            } else {
                                                if (_e784 == 7u) {
                                                    phi_3563_ = 2147483648u;
                                                } else {
                                                    phi_3563_ = ((2147483648u | (_e784 << bitcast<u32>(28u))) | (_e781 & 268435455u));
                                                }
                                                let _e802 = phi_3563_;
                                                phi_3564_ = _e802;
                                            }
                                            let _e804 = phi_3564_;
                                            if _e793 {
                                                let _e805 = (_e784 != 7u);
                                                if _e805 {
                                                    phi_3574_ = (_e781 + _e784);
                                                } else {
                                                    phi_3574_ = u32();
                                                }
                                                let _e808 = phi_3574_;
                                                phi_3576_ = _e808;
                                                phi_3577_ = select(true, false, _e805);
                                            } else {
                                                phi_3576_ = u32();
                                                phi_3577_ = true;
                                            }
                                            let _e811 = phi_3576_;
                                            let _e813 = phi_3577_;
                                            if (_e792 == 0u) {
                                                phi_3598_ = (_e780 + select(0u, 1u, !(_e793)));
                                            } else {
                                                if (_e792 == 7u) {
                                                    phi_3597_ = 2147483648u;
                                                } else {
                                                    phi_3597_ = ((2147483648u | (_e792 << bitcast<u32>(28u))) | (select(_e811, _e781, _e813) & 268435455u));
                                                }
                                                let _e826 = phi_3597_;
                                                phi_3598_ = _e826;
                                            }
                                            let _e828 = phi_3598_;
                                            phi_3602_ = type_52(array<vec4<f32>, 3>(vec4<f32>((_e524.member.member.x + _e656), (_e524.member.member.x + _e678), (_e524.member.member_1.x - _e695), (_e524.member.member_1.x - _e717)), vec4<f32>((_e524.member.member.y + _e665), (_e524.member.member.y + _e682), (_e524.member.member_1.y - _e704), (_e524.member.member_1.y - _e721)), vec4<f32>((_e524.member.member.z + _e674), (_e524.member.member.z + _e686), (_e524.member.member_1.z - _e713), (_e524.member.member_1.z - _e725))), type_49(type_28((_e524.member.member + vec4<f32>(_e656, _e665, _e674, 0f)), (_e524.member.member_1 - vec4<f32>(_e695, _e704, _e713, 0f))), _e804), type_49(type_28((_e524.member.member + vec4<f32>(_e678, _e682, _e686, 0f)), (_e524.member.member_1 - vec4<f32>(_e717, _e721, _e725, 0f))), _e828));
                                        }
                                        let _e833 = phi_3602_;
                                        let _e846 = ((_e833.member[0].x - _e321) * _e326);
                                        let _e847 = ((_e833.member[0].y - _e321) * _e326);
                                        let _e848 = ((_e833.member[0].z - _e322) * _e326);
                                        let _e849 = ((_e833.member[0].w - _e322) * _e326);
                                        let _e859 = ((_e833.member[1].x - _e359) * _e364);
                                        let _e860 = ((_e833.member[1].y - _e359) * _e364);
                                        let _e861 = ((_e833.member[1].z - _e360) * _e364);
                                        let _e862 = ((_e833.member[1].w - _e360) * _e364);
                                        let _e872 = ((_e833.member[2].x - _e397) * _e402);
                                        let _e873 = ((_e833.member[2].y - _e397) * _e402);
                                        let _e874 = ((_e833.member[2].z - _e398) * _e402);
                                        let _e875 = ((_e833.member[2].w - _e398) * _e402);
                                        let _e877 = select(_e874, _e872, (_e872 < _e874));
                                        let _e879 = select(_e875, _e873, (_e873 < _e875));
                                        let _e881 = select(_e874, _e872, (_e872 > _e874));
                                        let _e883 = select(_e875, _e873, (_e873 > _e875));
                                        let _e885 = select(_e848, _e846, (_e846 < _e848));
                                        let _e887 = select(_e849, _e847, (_e847 < _e849));
                                        let _e889 = select(_e861, _e859, (_e859 < _e861));
                                        let _e891 = select(_e862, _e860, (_e860 < _e862));
                                        let _e893 = select(_e889, _e885, (_e885 > _e889));
                                        let _e895 = select(_e891, _e887, (_e887 > _e891));
                                        let _e897 = select(_e877, _e893, (_e893 > _e877));
                                        let _e899 = select(_e879, _e895, (_e895 > _e879));
                                        let _e901 = select(_e848, _e846, (_e846 > _e848));
                                        let _e903 = select(_e849, _e847, (_e847 > _e849));
                                        let _e905 = select(_e861, _e859, (_e859 > _e861));
                                        let _e907 = select(_e862, _e860, (_e860 > _e862));
                                        let _e909 = select(_e905, _e901, (_e901 < _e905));
                                        let _e911 = select(_e907, _e903, (_e903 < _e907));
                                        let _e916 = -(_e877);
                                        let _e917 = -(_e879);
                                        let _e924 = (select(_e881, _e909, (_e909 < _e881)) + (select(_e916, _e881, (_e881 > _e916)) * 0.0000019073523f));
                                        let _e925 = (select(_e883, _e911, (_e911 < _e883)) + (select(_e917, _e883, (_e883 > _e917)) * 0.0000019073523f));
                                        let _e927 = select(_e449, _e897, (_e897 > _e449));
                                        let _e929 = select(_e449, _e899, (_e899 > _e449));
                                        let _e934 = (_e927 <= select(_e494.member.member_1, _e924, (_e924 < _e494.member.member_1)));
                                        let _e935 = (_e929 <= select(_e494.member.member_1, _e925, (_e925 < _e494.member.member_1)));
                                        let _e936 = (_e927 <= _e929);
                                        if _e934 {
                                            if _e935 {
                                                if _e936 {
                                                    phi_3946_ = _e833.member_2;
                                                } else {
                                                    phi_3946_ = _e833.member_1;
                                                }
                                                let _e940 = phi_3946_;
                                                let _e941 = (_e528 % 128u);
                                                let _e942 = (_e941 < 128u);
                                                if _e942 {
                                                } else {
                                                    phi_4322_ = true;
                                                    break;
                                                }
                                                local_3[_e941] = type_49(type_28(_e940.member.member, _e940.member.member_1), _e940.member_1);
                                                if _e942 {
                                                } else {
                                                    phi_4322_ = true;
                                                    break;
                                                }
                                                local_2[_e941] = select(_e929, _e927, (_e927 > _e929));
                                                if _e936 {
                                                    phi_3979_ = _e833.member_1;
                                                } else {
                                                    phi_3979_ = _e833.member_2;
                                                }
                                                let _e957 = phi_3979_;
                                                phi_3980_ = _e957;
                                                phi_3981_ = (_e528 + 1u);
                                            } else {
                                                phi_3980_ = type_49();
                                                phi_3981_ = u32();
                                            }
                                            let _e959 = phi_3980_;
                                            let _e961 = phi_3981_;
                                            phi_3983_ = _e959;
                                            phi_3984_ = _e961;
                                            phi_3985_ = select(true, false, _e935);
                                        } else {
                                            phi_3983_ = type_49();
                                            phi_3984_ = u32();
                                            phi_3985_ = true;
                                        }
                                        let _e964 = phi_3983_;
                                        let _e966 = phi_3984_;
                                        let _e968 = phi_3985_;
                                        if _e968 {
                                            if _e934 {
                                                phi_3994_ = _e833.member_1;
                                            } else {
                                                phi_3994_ = _e833.member_2;
                                            }
                                            let _e972 = phi_3994_;
                                            phi_3999_ = _e972;
                                            phi_4000_ = select(_e935, true, _e934);
                                        } else {
                                            phi_3999_ = _e964;
                                            phi_4000_ = _e526;
                                        }
                                        let _e975 = phi_3999_;
                                        let _e977 = phi_4000_;
                                        phi_4326_ = _e492;
                                        phi_4002_ = type_38(_e494.member, (_e494.member_1 + 1u), _e494.member_2);
                                        phi_4003_ = _e975;
                                        phi_4004_ = _e977;
                                        phi_4005_ = select(_e966, _e528, _e968);
                                    }
                                    let _e1401 = phi_4326_;
                                    let _e1403 = phi_4002_;
                                    let _e1405 = phi_4003_;
                                    let _e1407 = phi_4004_;
                                    let _e1409 = phi_4005_;
                                    phi_4325_ = _e1401;
                                    phi_4006_ = _e1403;
                                    phi_4007_ = _e1405;
                                    phi_4008_ = (_e498 - 1u);
                                    phi_4009_ = _e1407;
                                    phi_4010_ = _e1409;
                                } else {
                                    phi_4325_ = _e492;
                                    phi_4006_ = _e494;
                                    phi_4007_ = _e524;
                                    phi_4008_ = _e498;
                                    phi_4009_ = _e526;
                                    phi_4010_ = _e528;
                                }
                                let _e1411 = phi_4325_;
                                let _e1413 = phi_4006_;
                                let _e1415 = phi_4007_;
                                let _e1417 = phi_4008_;
                                let _e1419 = phi_4009_;
                                let _e1421 = phi_4010_;
                                phi_4324_ = _e1411;
                                phi_4011_ = _e1413;
                                phi_4012_ = _e1415;
                                phi_4013_ = _e1417;
                                phi_4014_ = _e1419;
                                phi_4015_ = _e1421;
                            } else {
                                phi_4324_ = _e492;
                                phi_4011_ = type_38();
                                phi_4012_ = type_49();
                                phi_4013_ = u32();
                                phi_4014_ = bool();
                                phi_4015_ = u32();
                            }
                            let _e1423 = phi_4324_;
                            let _e1425 = phi_4011_;
                            let _e1427 = phi_4012_;
                            let _e1429 = phi_4013_;
                            let _e1431 = phi_4014_;
                            let _e1433 = phi_4015_;
                            phi_4323_ = _e1423;
                            phi_1870_ = _e1425;
                            phi_1873_ = _e1427;
                            phi_1875_ = _e1429;
                            phi_1877_ = _e1431;
                            phi_1879_ = _e1433;
                            phi_4016_ = _e506;
                        } else {
                            phi_4323_ = _e492;
                            phi_1870_ = type_38();
                            phi_1873_ = type_49();
                            phi_1875_ = u32();
                            phi_1877_ = bool();
                            phi_1879_ = u32();
                            phi_4016_ = false;
                        }
                        let _e1435 = phi_4323_;
                        let _e1437 = phi_1870_;
                        let _e1439 = phi_1873_;
                        let _e1441 = phi_1875_;
                        let _e1443 = phi_1877_;
                        let _e1445 = phi_1879_;
                        let _e1447 = phi_4016_;
                        continue;
                        continuing {
                            phi_4214_ = _e1435;
                            phi_1869_ = _e1437;
                            phi_1872_ = _e1439;
                            phi_1874_ = _e1441;
                            phi_1876_ = _e1443;
                            phi_1878_ = _e1445;
                            phi_4322_ = _e1435;
                            break if !(_e1447);
                        }
                    }
                    let _e1450 = phi_4322_;
                    if _e1450 {
                        break;
                    }
                    let _e1452 = local_4;
                    let _e1455 = local_5;
                    if _e137 {
                    } else {
                        break;
                    }
                    global_6.member[_e135][0u] = _e1452.member_1;
                    global_6.member[_e135][1u] = _e1455.member_2;
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn trace_counted_q21_f32_(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
