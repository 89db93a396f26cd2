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

struct type_32 {
    member: type_25,
    member_1: f32,
}

struct type_36 {
    member: array<type_26>,
}

struct type_38 {
    member: type_32,
    member_1: u32,
    member_2: u32,
}

struct type_40 {
    member: array<vec4<u32>, 2>,
}

struct type_42 {
    member: array<u32, 2>,
    member_1: array<u32, 2>,
    member_2: u32,
    member_3: u32,
}

struct type_44 {
    member: array<type_42>,
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
var<uniform> global_3: type_40;
@group(0) @binding(4) 
var<storage> global_4: type_36;
@group(0) @binding(2) 
var<storage> global_5: type_44;
@group(0) @binding(5) 
var<storage, read_write> global_6: type_21;

fn function_() {
    var local: array<f32, 128>;
    var local_1: array<f32, 128>;
    var local_2: array<f32, 128>;
    var local_3: array<f32, 128>;
    var local_4: array<f32, 128>;
    var local_5: array<f32, 128>;
    var local_6: array<u32, 128>;
    var local_7: array<f32, 3>;
    var local_8: array<f32, 3>;
    var local_9: array<f32, 128>;
    var local_10: array<f32, 3>;
    var local_11: array<f32, 3>;
    var local_12: array<f32, 3>;
    var local_13: array<f32, 3>;
    var local_14: array<u32, 3>;
    var local_15: array<u32, 3>;
    var local_16: array<f32, 3>;
    var local_17: array<f32, 3>;
    var phi_336_: i32;
    var phi_337_: i32;
    var phi_347_: bool;
    var phi_357_: u32;
    var phi_358_: u32;
    var phi_360_: bool;
    var phi_365_: u32;
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
    var phi_2646_: bool;
    var phi_780_: type_38;
    var phi_783_: type_51;
    var phi_785_: u32;
    var phi_787_: bool;
    var phi_789_: u32;
    var phi_800_: bool;
    var phi_886_: type_51;
    var phi_887_: bool;
    var phi_888_: u32;
    var phi_1693_: type_42;
    var phi_1702_: type_4;
    var phi_1703_: type_4;
    var phi_1726_: type_4;
    var phi_2639_: bool;
    var phi_1856_: type_4;
    var phi_1857_: type_4;
    var phi_1880_: type_4;
    var phi_2699_: bool;
    var phi_2443_: type_51;
    var phi_2520_: type_51;
    var phi_2521_: type_51;
    var phi_2522_: u32;
    var phi_2524_: type_51;
    var phi_2525_: u32;
    var phi_2526_: bool;
    var phi_2533_: type_51;
    var phi_2538_: type_51;
    var phi_2539_: bool;
    var phi_906_: type_38;
    var phi_909_: type_4;
    var phi_910_: type_4;
    var phi_932_: type_4;
    var phi_956_: u32;
    var phi_1045_: array<array<f32, 3>, 3>;
    var phi_1516_: vec3<f32>;
    var phi_1517_: vec3<f32>;
    var phi_1548_: bool;
    var phi_1557_: vec3<f32>;
    var phi_1597_: type_25;
    var phi_1599_: type_25;
    var phi_1600_: bool;
    var phi_1604_: type_25;
    var phi_1605_: type_25;
    var phi_1606_: type_25;
    var phi_1607_: bool;
    var phi_1611_: type_25;
    var phi_1612_: bool;
    var phi_1616_: type_25;
    var phi_1617_: bool;
    var phi_1621_: type_25;
    var phi_1646_: bool;
    var phi_1647_: bool;
    var phi_1654_: type_38;
    var phi_1655_: type_38;
    var phi_1656_: type_38;
    var phi_907_: type_38;
    var phi_2707_: bool;
    var phi_2774_: bool;
    var phi_2541_: type_38;
    var phi_2542_: type_51;
    var phi_2543_: bool;
    var phi_2544_: u32;
    var phi_2773_: bool;
    var phi_2545_: type_38;
    var phi_2546_: type_51;
    var phi_2547_: u32;
    var phi_2548_: bool;
    var phi_2549_: u32;
    var phi_2772_: bool;
    var phi_2550_: type_38;
    var phi_2551_: type_51;
    var phi_2552_: u32;
    var phi_2553_: bool;
    var phi_2554_: u32;
    var phi_2771_: bool;
    var phi_781_: type_38;
    var phi_784_: type_51;
    var phi_786_: u32;
    var phi_788_: bool;
    var phi_790_: u32;
    var phi_2555_: bool;
    var phi_2770_: bool;
    var local_18: type_38;
    var local_19: type_38;
    var local_20: type_38;

    switch bitcast<i32>(0u) {
        default: {
            let _e84 = global;
            let _e87 = arrayLength((&global_5.member));
            let _e89 = arrayLength((&global_2.member));
            let _e97 = global_3.member[0u][0u];
            let _e101 = global_3.member[0u][1u];
            let _e105 = global_3.member[0u][2u];
            let _e109 = global_3.member[1u][0u];
            let _e113 = global_3.member[1u][1u];
            let _e117 = global_3.member[1u][2u];
            let _e121 = global_3.member[1u][3u];
            let _e124 = global_1.member[0u];
            let _e125 = bitcast<i32>(_e124);
            let _e135 = (_e84.x + (_e84.y * 2097152u));
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
                            phi_336_ = (bitcast<i32>((_e214 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_336_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e214)), 32u, (_e214 == 0u))));
                        }
                        let _e228 = phi_336_;
                        phi_337_ = _e228;
                    } else {
                        phi_337_ = 0i;
                    }
                    let _e230 = phi_337_;
                    let _e231 = (_e147 == _e186);
                    if _e231 {
                        phi_347_ = true;
                    } else {
                        phi_347_ = (_e154 == _e186);
                    }
                    let _e234 = phi_347_;
                    let _e235 = select(1u, 0u, _e231);
                    if _e234 {
                        let _e236 = (_e235 + 1u);
                        phi_357_ = _e236;
                        phi_358_ = _e236;
                        phi_360_ = select(true, false, (_e236 == 2u));
                    } else {
                        phi_357_ = u32();
                        phi_358_ = 0u;
                        phi_360_ = true;
                    }
                    let _e240 = phi_357_;
                    let _e242 = phi_358_;
                    let _e244 = phi_360_;
                    if _e244 {
                        phi_365_ = (_e242 + 1u);
                    } else {
                        phi_365_ = 0u;
                    }
                    let _e248 = phi_365_;
                    let _e249 = select(_e240, _e242, _e244);
                    let _e250 = select(_e235, select(2u, _e235, _e234), _e244);
                    if (_e125 < -126i) {
                        phi_378_ = -126i;
                    } else {
                        phi_378_ = select(_e125, 127i, (_e125 > 127i));
                    }
                    let _e255 = phi_378_;
                    let _e260 = bitcast<f32>((bitcast<u32>((_e255 + 127i)) << bitcast<u32>(23i)));
                    let _e266 = bitcast<f32>((bitcast<u32>(((_e125 - _e255) + 127i)) << bitcast<u32>(23i)));
                    let _e267 = -(_e230);
                    if (_e267 < -126i) {
                        phi_398_ = -126i;
                    } else {
                        phi_398_ = select(_e267, 127i, (_e267 > 127i));
                    }
                    let _e272 = phi_398_;
                    let _e277 = bitcast<f32>((bitcast<u32>((_e272 + 127i)) << bitcast<u32>(23i)));
                    let _e283 = bitcast<f32>((bitcast<u32>(((_e267 - _e272) + 127i)) << bitcast<u32>(23i)));
                    let _e287 = global_4.member[_e135].member;
                    let _e288 = (_e249 == 0u);
                    if _e288 {
                        phi_416_ = _e287[0];
                    } else {
                        phi_416_ = _e287[1];
                    }
                    let _e292 = phi_416_;
                    let _e293 = (_e249 == 2u);
                    if _e293 {
                        phi_422_ = _e287[2];
                    } else {
                        phi_422_ = _e292;
                    }
                    let _e296 = phi_422_;
                    let _e298 = ((_e296 * _e260) * _e266);
                    let _e299 = global_4.member[_e135].member_2;
                    if _e288 {
                        phi_433_ = _e299[0];
                    } else {
                        phi_433_ = _e299[1];
                    }
                    let _e303 = phi_433_;
                    if _e293 {
                        phi_439_ = _e299[2];
                    } else {
                        phi_439_ = _e303;
                    }
                    let _e306 = phi_439_;
                    let _e308 = ((_e306 * _e277) * _e283);
                    let _e312 = (bitcast<f32>((bitcast<u32>(_e308) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e312 {
                        let _e316 = (bitcast<f32>((bitcast<u32>(_e298) & 2147483647u)) * 0.00000011920929f);
                        phi_462_ = select(0.00000000000011368684f, _e316, (_e316 > 0.00000000000011368684f));
                    } else {
                        phi_462_ = 0f;
                    }
                    let _e320 = phi_462_;
                    let _e321 = (_e298 + _e320);
                    let _e322 = (_e298 - _e320);
                    let _e323 = select(_e308, 0f, _e312);
                    if _e312 {
                        phi_473_ = 38685626000000000000000000f;
                    } else {
                        phi_473_ = (1f / _e308);
                    }
                    let _e326 = phi_473_;
                    let _e327 = (_e248 == 0u);
                    if _e327 {
                        phi_482_ = _e287[0];
                    } else {
                        phi_482_ = _e287[1];
                    }
                    let _e331 = phi_482_;
                    let _e332 = (_e248 == 2u);
                    if _e332 {
                        phi_488_ = _e287[2];
                    } else {
                        phi_488_ = _e331;
                    }
                    let _e335 = phi_488_;
                    let _e337 = ((_e335 * _e260) * _e266);
                    if _e327 {
                        phi_499_ = _e299[0];
                    } else {
                        phi_499_ = _e299[1];
                    }
                    let _e341 = phi_499_;
                    if _e332 {
                        phi_505_ = _e299[2];
                    } else {
                        phi_505_ = _e341;
                    }
                    let _e344 = phi_505_;
                    let _e346 = ((_e344 * _e277) * _e283);
                    let _e350 = (bitcast<f32>((bitcast<u32>(_e346) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e350 {
                        let _e354 = (bitcast<f32>((bitcast<u32>(_e337) & 2147483647u)) * 0.00000011920929f);
                        phi_528_ = select(0.00000000000011368684f, _e354, (_e354 > 0.00000000000011368684f));
                    } else {
                        phi_528_ = 0f;
                    }
                    let _e358 = phi_528_;
                    let _e359 = (_e337 + _e358);
                    let _e360 = (_e337 - _e358);
                    let _e361 = select(_e346, 0f, _e350);
                    if _e350 {
                        phi_539_ = 38685626000000000000000000f;
                    } else {
                        phi_539_ = (1f / _e346);
                    }
                    let _e364 = phi_539_;
                    let _e365 = (_e250 == 0u);
                    if _e365 {
                        phi_548_ = _e287[0];
                    } else {
                        phi_548_ = _e287[1];
                    }
                    let _e369 = phi_548_;
                    let _e370 = (_e250 == 2u);
                    if _e370 {
                        phi_554_ = _e287[2];
                    } else {
                        phi_554_ = _e369;
                    }
                    let _e373 = phi_554_;
                    let _e375 = ((_e373 * _e260) * _e266);
                    if _e365 {
                        phi_565_ = _e299[0];
                    } else {
                        phi_565_ = _e299[1];
                    }
                    let _e379 = phi_565_;
                    if _e370 {
                        phi_571_ = _e299[2];
                    } else {
                        phi_571_ = _e379;
                    }
                    let _e382 = phi_571_;
                    let _e384 = ((_e382 * _e277) * _e283);
                    let _e388 = (bitcast<f32>((bitcast<u32>(_e384) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e388 {
                        let _e392 = (bitcast<f32>((bitcast<u32>(_e375) & 2147483647u)) * 0.00000011920929f);
                        phi_594_ = select(0.00000000000011368684f, _e392, (_e392 > 0.00000000000011368684f));
                    } else {
                        phi_594_ = 0f;
                    }
                    let _e396 = phi_594_;
                    let _e397 = (_e375 + _e396);
                    let _e398 = (_e375 - _e396);
                    let _e399 = select(_e384, 0f, _e388);
                    if _e388 {
                        phi_605_ = 38685626000000000000000000f;
                    } else {
                        phi_605_ = (1f / _e384);
                    }
                    let _e402 = phi_605_;
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
                        phi_705_ = select(-340282350000000000000000000000000000000f, _e443, (_e443 > -340282350000000000000000000000000000000f));
                        phi_706_ = select(-340282350000000000000000000000000000000f, _e436, (_e436 > -340282350000000000000000000000000000000f));
                    } else {
                        phi_705_ = 0f;
                        phi_706_ = 1f;
                    }
                    let _e447 = phi_705_;
                    let _e449 = phi_706_;
                    local_6 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                    local_5 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_4 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_3 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_1 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_9 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_17 = array<f32, 3>(bitcast<f32>(_e97), bitcast<f32>(_e101), bitcast<f32>(_e105));
                    let _e455 = (_e249 % 3u);
                    let _e456 = (_e455 < 3u);
                    if _e456 {
                    } else {
                        break;
                    }
                    let _e458 = local_17[_e455];
                    let _e459 = (_e248 % 3u);
                    let _e460 = (_e459 < 3u);
                    if _e460 {
                    } else {
                        break;
                    }
                    let _e462 = local_17[_e459];
                    let _e463 = (_e250 % 3u);
                    let _e464 = (_e463 < 3u);
                    if _e464 {
                    } else {
                        break;
                    }
                    let _e466 = local_17[_e463];
                    local_16 = array<f32, 3>(bitcast<f32>(_e109), bitcast<f32>(_e113), bitcast<f32>(_e117));
                    if _e456 {
                    } else {
                        break;
                    }
                    let _e470 = local_16[_e455];
                    if _e460 {
                    } else {
                        break;
                    }
                    let _e472 = local_16[_e459];
                    if _e464 {
                    } else {
                        break;
                    }
                    let _e474 = local_16[_e463];
                    phi_2646_ = false;
                    phi_780_ = type_38(type_32(type_25(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e447), 0u, 0u);
                    phi_783_ = type_51(type_49(array<f32, 3>(_e458, _e462, _e466), array<f32, 3>(_e470, _e472, _e474)), select(0u, 2147483648u, (_e87 == 0u)));
                    phi_785_ = ((3u * _e87) + 1u);
                    phi_787_ = (_e449 <= _e447);
                    phi_789_ = 0u;
                    loop {
                        let _e482 = phi_2646_;
                        let _e484 = phi_780_;
                        let _e486 = phi_783_;
                        let _e488 = phi_785_;
                        let _e490 = phi_787_;
                        let _e492 = phi_789_;
                        local_18 = _e484;
                        local_19 = _e484;
                        if _e490 {
                            phi_800_ = true;
                        } else {
                            phi_800_ = (_e492 > 0u);
                        }
                        let _e495 = phi_800_;
                        if _e495 {
                            let _e496 = (_e488 > 0u);
                            if _e496 {
                                if _e490 {
                                    phi_886_ = _e486;
                                    phi_887_ = _e490;
                                    phi_888_ = _e492;
                                } else {
                                    let _e497 = (_e492 - 1u);
                                    let _e498 = (_e497 % 128u);
                                    let _e499 = (_e498 < 128u);
                                    if _e499 {
                                    } else {
                                        phi_2770_ = true;
                                        break;
                                    }
                                    let _e501 = local_6[_e498];
                                    if _e499 {
                                    } else {
                                        phi_2770_ = true;
                                        break;
                                    }
                                    let _e503 = local_5[_e498];
                                    if _e499 {
                                    } else {
                                        phi_2770_ = true;
                                        break;
                                    }
                                    let _e505 = local_4[_e498];
                                    if _e499 {
                                    } else {
                                        phi_2770_ = true;
                                        break;
                                    }
                                    let _e507 = local_3[_e498];
                                    if _e499 {
                                    } else {
                                        phi_2770_ = true;
                                        break;
                                    }
                                    let _e510 = local_2[_e498];
                                    if _e499 {
                                    } else {
                                        phi_2770_ = true;
                                        break;
                                    }
                                    let _e512 = local_1[_e498];
                                    if _e499 {
                                    } else {
                                        phi_2770_ = true;
                                        break;
                                    }
                                    let _e514 = local[_e498];
                                    if _e499 {
                                    } else {
                                        phi_2770_ = true;
                                        break;
                                    }
                                    let _e519 = local_9[_e498];
                                    phi_886_ = type_51(type_49(array<f32, 3>(_e503, _e505, _e507), array<f32, 3>(_e510, _e512, _e514)), _e501);
                                    phi_887_ = (_e519 <= _e484.member.member_1);
                                    phi_888_ = _e497;
                                }
                                let _e524 = phi_886_;
                                let _e526 = phi_887_;
                                let _e528 = phi_888_;
                                if _e526 {
                                    if ((_e524.member_1 & 2147483648u) != 0u) {
                                        phi_906_ = _e484;
                                        phi_909_ = type_4(0u, ((_e524.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e860 = phi_906_;
                                            let _e862 = phi_909_;
                                            local_20 = _e860;
                                            if (_e862.member < _e862.member_1) {
                                                phi_910_ = type_4((_e862.member + 1u), _e862.member_1);
                                                phi_932_ = type_4(1u, _e862.member);
                                            } else {
                                                phi_910_ = _e862;
                                                phi_932_ = type_4(0u, type_4().member_1);
                                            }
                                            let _e875 = phi_910_;
                                            let _e877 = phi_932_;
                                            let _e881 = (bitcast<i32>(_e877.member) != 0i);
                                            if _e881 {
                                                let _e887 = type_38(_e860.member, _e860.member_1, (_e860.member_2 + 1u));
                                                let _e888 = ((_e524.member_1 & 268435455u) + _e877.member_1);
                                                let _e889 = (_e888 < _e89);
                                                if _e889 {
                                                    if _e889 {
                                                    } else {
                                                        phi_2707_ = true;
                                                        break;
                                                    }
                                                    let _e893 = global_2.member[_e888].member_1;
                                                    phi_956_ = _e893;
                                                } else {
                                                    phi_956_ = 4294967295u;
                                                }
                                                let _e895 = phi_956_;
                                                if (_e888 >= _e89) {
                                                    phi_1045_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                } else {
                                                    if _e889 {
                                                    } else {
                                                        phi_2707_ = true;
                                                        break;
                                                    }
                                                    if (_e455 < 9u) {
                                                    } else {
                                                        phi_2707_ = true;
                                                        break;
                                                    }
                                                    let _e902 = global_2.member[_e888].member[_e455];
                                                    if (_e459 < 9u) {
                                                    } else {
                                                        phi_2707_ = true;
                                                        break;
                                                    }
                                                    let _e908 = global_2.member[_e888].member[_e459];
                                                    if (_e463 < 9u) {
                                                    } else {
                                                        phi_2707_ = true;
                                                        break;
                                                    }
                                                    let _e914 = global_2.member[_e888].member[_e463];
                                                    let _e916 = (3u + _e455);
                                                    if (_e916 < 9u) {
                                                    } else {
                                                        phi_2707_ = true;
                                                        break;
                                                    }
                                                    let _e922 = global_2.member[_e888].member[_e916];
                                                    let _e923 = (3u + _e459);
                                                    if (_e923 < 9u) {
                                                    } else {
                                                        phi_2707_ = true;
                                                        break;
                                                    }
                                                    let _e929 = global_2.member[_e888].member[_e923];
                                                    let _e930 = (3u + _e463);
                                                    if (_e930 < 9u) {
                                                    } else {
                                                        phi_2707_ = true;
                                                        break;
                                                    }
                                                    let _e936 = global_2.member[_e888].member[_e930];
                                                    let _e938 = (6u + _e455);
                                                    if (_e938 < 9u) {
                                                    } else {
                                                        phi_2707_ = true;
                                                        break;
                                                    }
                                                    let _e944 = global_2.member[_e888].member[_e938];
                                                    let _e945 = (6u + _e459);
                                                    if (_e945 < 9u) {
                                                    } else {
                                                        phi_2707_ = true;
                                                        break;
                                                    }
                                                    let _e951 = global_2.member[_e888].member[_e945];
                                                    let _e952 = (6u + _e463);
                                                    if (_e952 < 9u) {
                                                    } else {
                                                        phi_2707_ = true;
                                                        break;
                                                    }
                                                    let _e958 = global_2.member[_e888].member[_e952];
                                                    phi_1045_ = array<array<f32, 3>, 3>(array<f32, 3>(_e902, _e908, _e914), array<f32, 3>(_e922, _e929, _e936), array<f32, 3>(_e944, _e951, _e958));
                                                }
                                                let _e962 = phi_1045_;
                                                let _e971 = (_e962[0][2] - _e375);
                                                let _e974 = (((_e962[0][0] - _e298) * _e399) - (_e971 * _e323));
                                                let _e977 = (((_e962[0][1] - _e337) * _e399) - (_e971 * _e361));
                                                let _e984 = (_e962[1][2] - _e375);
                                                let _e987 = (((_e962[1][0] - _e298) * _e399) - (_e984 * _e323));
                                                let _e990 = (((_e962[1][1] - _e337) * _e399) - (_e984 * _e361));
                                                let _e997 = (_e962[2][2] - _e375);
                                                let _e1000 = (((_e962[2][0] - _e298) * _e399) - (_e997 * _e323));
                                                let _e1003 = (((_e962[2][1] - _e337) * _e399) - (_e997 * _e361));
                                                let _e1004 = (_e1000 * _e990);
                                                let _e1005 = (_e1003 * _e987);
                                                let _e1006 = (_e974 * _e1003);
                                                let _e1007 = (_e977 * _e1000);
                                                let _e1008 = (_e987 * _e977);
                                                let _e1009 = (_e990 * _e974);
                                                let _e1014 = (((_e1004 >= _e1005) && (_e1006 >= _e1007)) && (_e1008 >= _e1009));
                                                if (_e1014 || (((_e1004 <= _e1005) && (_e1006 <= _e1007)) && (_e1008 <= _e1009))) {
                                                    let _e1021 = select(-1f, 1f, _e1014);
                                                    let _e1023 = ((_e1004 - _e1005) * _e1021);
                                                    let _e1025 = select(0f, _e1023, (_e1023 > 0f));
                                                    let _e1027 = ((_e1006 - _e1007) * _e1021);
                                                    let _e1029 = select(0f, _e1027, (_e1027 > 0f));
                                                    let _e1031 = ((_e1008 - _e1009) * _e1021);
                                                    let _e1033 = select(0f, _e1031, (_e1031 > 0f));
                                                    let _e1035 = ((_e1025 + _e1029) + _e1033);
                                                    if (_e1035 < 0.000000000000000000000000000000000000011754944f) {
                                                        phi_1611_ = type_25();
                                                        phi_1612_ = true;
                                                    } else {
                                                        let _e1038 = select(_e962[1][0], _e962[0][0], (_e962[0][0] < _e962[1][0]));
                                                        let _e1042 = select(_e962[1][0], _e962[0][0], (_e962[0][0] > _e962[1][0]));
                                                        let _e1046 = select(_e962[1][1], _e962[0][1], (_e962[0][1] < _e962[1][1]));
                                                        let _e1050 = select(_e962[1][1], _e962[0][1], (_e962[0][1] > _e962[1][1]));
                                                        let _e1054 = select(_e962[1][2], _e962[0][2], (_e962[0][2] < _e962[1][2]));
                                                        let _e1058 = select(_e962[1][2], _e962[0][2], (_e962[0][2] > _e962[1][2]));
                                                        let _e1063 = ((select(_e962[2][0], _e1038, (_e1038 < _e962[2][0])) - _e321) * _e326);
                                                        let _e1064 = ((select(_e962[2][0], _e1042, (_e1042 > _e962[2][0])) - _e322) * _e326);
                                                        let _e1067 = ((select(_e962[2][1], _e1046, (_e1046 < _e962[2][1])) - _e359) * _e364);
                                                        let _e1068 = ((select(_e962[2][1], _e1050, (_e1050 > _e962[2][1])) - _e360) * _e364);
                                                        let _e1071 = ((select(_e962[2][2], _e1054, (_e1054 < _e962[2][2])) - _e397) * _e402);
                                                        let _e1072 = ((select(_e962[2][2], _e1058, (_e1058 > _e962[2][2])) - _e398) * _e402);
                                                        let _e1074 = select(_e1072, _e1071, (_e1071 < _e1072));
                                                        let _e1076 = select(_e1072, _e1071, (_e1071 > _e1072));
                                                        let _e1078 = select(_e1064, _e1063, (_e1063 < _e1064));
                                                        let _e1080 = select(_e1068, _e1067, (_e1067 < _e1068));
                                                        let _e1082 = select(_e1080, _e1078, (_e1078 > _e1080));
                                                        let _e1084 = select(_e1074, _e1082, (_e1082 > _e1074));
                                                        let _e1086 = select(_e1064, _e1063, (_e1063 > _e1064));
                                                        let _e1088 = select(_e1068, _e1067, (_e1067 > _e1068));
                                                        let _e1090 = select(_e1088, _e1086, (_e1086 < _e1088));
                                                        let _e1092 = select(_e1076, _e1090, (_e1090 < _e1076));
                                                        let _e1093 = -(_e1074);
                                                        let _e1099 = select(_e449, _e1084, (_e1084 > _e449));
                                                        if (_e1099 > (_e1092 + (select(_e1093, _e1076, (_e1076 > _e1093)) * 0.0000019073523f))) {
                                                            phi_1606_ = type_25();
                                                            phi_1607_ = true;
                                                        } else {
                                                            let _e1101 = (_e1099 > _e860.member.member_1);
                                                            if _e1101 {
                                                                phi_1605_ = type_25();
                                                            } else {
                                                                let _e1105 = (_e962[1][0] - _e962[0][0]);
                                                                let _e1106 = (_e962[1][1] - _e962[0][1]);
                                                                let _e1107 = (_e962[1][2] - _e962[0][2]);
                                                                let _e1108 = vec3<f32>(_e1105, _e1106, _e1107);
                                                                let _e1109 = (_e962[2][0] - _e962[1][0]);
                                                                let _e1110 = (_e962[2][1] - _e962[1][1]);
                                                                let _e1111 = (_e962[2][2] - _e962[1][2]);
                                                                let _e1112 = vec3<f32>(_e1109, _e1110, _e1111);
                                                                let _e1113 = (_e962[0][0] - _e962[2][0]);
                                                                let _e1114 = (_e962[0][1] - _e962[2][1]);
                                                                let _e1115 = (_e962[0][2] - _e962[2][2]);
                                                                let _e1116 = vec3<f32>(_e1113, _e1114, _e1115);
                                                                let _e1119 = bitcast<f32>((bitcast<u32>(_e1105) & 2147483647u));
                                                                let _e1122 = bitcast<f32>((bitcast<u32>(_e1106) & 2147483647u));
                                                                let _e1124 = select(_e1122, _e1119, (_e1119 > _e1122));
                                                                let _e1127 = bitcast<f32>((bitcast<u32>(_e1107) & 2147483647u));
                                                                let _e1129 = select(_e1127, _e1124, (_e1124 > _e1127));
                                                                let _e1132 = bitcast<f32>((bitcast<u32>(_e1109) & 2147483647u));
                                                                let _e1135 = bitcast<f32>((bitcast<u32>(_e1110) & 2147483647u));
                                                                let _e1137 = select(_e1135, _e1132, (_e1132 > _e1135));
                                                                let _e1140 = bitcast<f32>((bitcast<u32>(_e1111) & 2147483647u));
                                                                let _e1142 = select(_e1140, _e1137, (_e1137 > _e1140));
                                                                let _e1145 = bitcast<f32>((bitcast<u32>(_e1113) & 2147483647u));
                                                                let _e1148 = bitcast<f32>((bitcast<u32>(_e1114) & 2147483647u));
                                                                let _e1150 = select(_e1148, _e1145, (_e1145 > _e1148));
                                                                let _e1153 = bitcast<f32>((bitcast<u32>(_e1115) & 2147483647u));
                                                                let _e1155 = select(_e1153, _e1150, (_e1150 > _e1153));
                                                                let _e1157 = select(_e1142, _e1129, (_e1129 > _e1142));
                                                                let _e1159 = select(_e1155, _e1157, (_e1157 > _e1155));
                                                                if (_e1129 == _e1159) {
                                                                    phi_1516_ = _e1112;
                                                                    phi_1517_ = _e1116;
                                                                } else {
                                                                    let _e1162 = vec3((_e1142 == _e1159));
                                                                    phi_1516_ = select(_e1108, _e1116, _e1162);
                                                                    phi_1517_ = select(_e1112, _e1108, _e1162);
                                                                }
                                                                let _e1166 = phi_1516_;
                                                                let _e1168 = phi_1517_;
                                                                let _e1175 = ((_e1166.y * _e1168.z) - (_e1168.y * _e1166.z));
                                                                let _e1180 = ((_e1166.z * _e1168.x) - (_e1168.z * _e1166.x));
                                                                let _e1183 = ((_e1166.x * _e1168.y) - (_e1168.x * _e1166.y));
                                                                if (_e1025 >= _e1029) {
                                                                    phi_1548_ = select(true, false, (_e1025 >= _e1033));
                                                                } else {
                                                                    phi_1548_ = true;
                                                                }
                                                                let _e1188 = phi_1548_;
                                                                if _e1188 {
                                                                    phi_1557_ = select(vec3<f32>(_e962[2][0], _e962[2][1], _e962[2][2]), vec3<f32>(_e962[1][0], _e962[1][1], _e962[1][2]), vec3((_e1029 >= _e1033)));
                                                                } else {
                                                                    phi_1557_ = vec3<f32>(_e962[0][0], _e962[0][1], _e962[0][2]);
                                                                }
                                                                let _e1193 = phi_1557_;
                                                                let _e1210 = ((((_e1175 * (_e1193.x - _e298)) + (_e1180 * (_e1193.y - _e337))) + (_e1183 * (_e1193.z - _e375))) / (((_e1175 * _e323) + (_e1180 * _e361)) + (_e1183 * _e399)));
                                                                let _e1212 = select(_e1092, _e1210, (_e1210 < _e1092));
                                                                let _e1214 = select(_e1084, _e1212, (_e1212 > _e1084));
                                                                if (_e1214 >= _e449) {
                                                                    let _e1216 = (_e1214 <= _e860.member.member_1);
                                                                    if _e1216 {
                                                                        let _e1217 = (1f / _e1035);
                                                                        phi_1597_ = type_25(_e1214, (_e1029 * _e1217), (_e1033 * _e1217), _e895);
                                                                    } else {
                                                                        phi_1597_ = type_25();
                                                                    }
                                                                    let _e1222 = phi_1597_;
                                                                    phi_1599_ = _e1222;
                                                                    phi_1600_ = select(true, false, _e1216);
                                                                } else {
                                                                    phi_1599_ = type_25();
                                                                    phi_1600_ = true;
                                                                }
                                                                let _e1225 = phi_1599_;
                                                                let _e1227 = phi_1600_;
                                                                if _e1227 {
                                                                    phi_1604_ = type_25(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                } else {
                                                                    phi_1604_ = _e1225;
                                                                }
                                                                let _e1229 = phi_1604_;
                                                                phi_1605_ = _e1229;
                                                            }
                                                            let _e1231 = phi_1605_;
                                                            phi_1606_ = _e1231;
                                                            phi_1607_ = _e1101;
                                                        }
                                                        let _e1233 = phi_1606_;
                                                        let _e1235 = phi_1607_;
                                                        phi_1611_ = _e1233;
                                                        phi_1612_ = _e1235;
                                                    }
                                                    let _e1237 = phi_1611_;
                                                    let _e1239 = phi_1612_;
                                                    phi_1616_ = _e1237;
                                                    phi_1617_ = _e1239;
                                                } else {
                                                    phi_1616_ = type_25();
                                                    phi_1617_ = true;
                                                }
                                                let _e1241 = phi_1616_;
                                                let _e1243 = phi_1617_;
                                                if _e1243 {
                                                    phi_1621_ = type_25(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                } else {
                                                    phi_1621_ = _e1241;
                                                }
                                                let _e1245 = phi_1621_;
                                                if (_e1245.member_3 != 4294967295u) {
                                                    if (_e895 != 4294967295u) {
                                                        if (_e1245.member < _e860.member.member.member) {
                                                            phi_1647_ = true;
                                                        } else {
                                                            if (_e1245.member == _e860.member.member.member) {
                                                                phi_1646_ = (_e1245.member_3 < _e860.member.member.member_3);
                                                            } else {
                                                                phi_1646_ = false;
                                                            }
                                                            let _e1260 = phi_1646_;
                                                            phi_1647_ = _e1260;
                                                        }
                                                        let _e1262 = phi_1647_;
                                                        if _e1262 {
                                                            phi_1654_ = type_38(type_32(_e1245, _e1245.member), _e887.member_1, _e887.member_2);
                                                        } else {
                                                            phi_1654_ = _e887;
                                                        }
                                                        let _e1269 = phi_1654_;
                                                        phi_1655_ = _e1269;
                                                    } else {
                                                        phi_1655_ = _e887;
                                                    }
                                                    let _e1271 = phi_1655_;
                                                    phi_1656_ = _e1271;
                                                } else {
                                                    phi_1656_ = _e887;
                                                }
                                                let _e1273 = phi_1656_;
                                                phi_907_ = _e1273;
                                            } else {
                                                phi_907_ = type_38();
                                            }
                                            let _e1275 = phi_907_;
                                            continue;
                                            continuing {
                                                phi_906_ = _e1275;
                                                phi_909_ = _e875;
                                                phi_2707_ = _e482;
                                                break if !(_e881);
                                            }
                                        }
                                        let _e1278 = phi_2707_;
                                        phi_2770_ = _e1278;
                                        if _e1278 {
                                            break;
                                        }
                                        phi_2774_ = _e1278;
                                        let _e1432 = local_20;
                                        phi_2541_ = _e1432;
                                        phi_2542_ = _e524;
                                        phi_2543_ = false;
                                        phi_2544_ = _e528;
                                    } else {
                                        local_8 = array<f32, 3>(_e524.member.member[0], _e524.member.member[1], _e524.member.member[2]);
                                        local_7 = array<f32, 3>(_e524.member.member_1[0], _e524.member.member_1[1], _e524.member.member_1[2]);
                                        let _e554 = (_e524.member_1 < _e87);
                                        if _e554 {
                                            if _e554 {
                                            } else {
                                                phi_2770_ = true;
                                                break;
                                            }
                                            let _e556 = global_5.member[_e524.member_1];
                                            phi_1693_ = _e556;
                                        } else {
                                            phi_1693_ = type_42(array<u32, 2>(0u, 0u), array<u32, 2>(0u, 0u), 2147483648u, 2147483648u);
                                        }
                                        let _e558 = phi_1693_;
                                        let _e560 = array<u32, 3>(_e249, _e248, _e250);
                                        local_15 = _e560;
                                        local_11 = array<f32, 3>(0f, 0f, 0f);
                                        local_10 = array<f32, 3>(0f, 0f, 0f);
                                        phi_1702_ = type_4(0u, 3u);
                                        loop {
                                            let _e562 = phi_1702_;
                                            if (_e562.member < _e562.member_1) {
                                                phi_1703_ = type_4((_e562.member + 1u), _e562.member_1);
                                                phi_1726_ = type_4(1u, _e562.member);
                                            } else {
                                                phi_1703_ = _e562;
                                                phi_1726_ = type_4(0u, type_4().member_1);
                                            }
                                            let _e575 = phi_1703_;
                                            let _e577 = phi_1726_;
                                            let _e581 = (bitcast<i32>(_e577.member) != 0i);
                                            if _e581 {
                                                let _e582 = (_e577.member_1 < 3u);
                                                if _e582 {
                                                } else {
                                                    phi_2639_ = true;
                                                    break;
                                                }
                                                let _e584 = local_15[_e577.member_1];
                                                if _e582 {
                                                } else {
                                                    phi_2639_ = true;
                                                    break;
                                                }
                                                let _e586 = local_8[_e577.member_1];
                                                if _e582 {
                                                } else {
                                                    phi_2639_ = true;
                                                    break;
                                                }
                                                let _e588 = local_7[_e577.member_1];
                                                let _e591 = ((10u * _e584) & 31u);
                                                let _e594 = ((_e558.member[0] >> bitcast<u32>(_e591)) & 1023u);
                                                let _e599 = bitcast<f32>((bitcast<u32>(((_e588 - _e586) * 0.0009775171f)) ^ _e121));
                                                let _e605 = (_e586 + bitcast<f32>((bitcast<u32>((f32(_e594) * _e599)) ^ _e121)));
                                                if _e582 {
                                                } else {
                                                    phi_2639_ = true;
                                                    break;
                                                }
                                                local_11[_e577.member_1] = select(select(_e588, _e605, (_e605 < _e588)), _e588, (_e594 == 1023u));
                                                let _e614 = ((_e558.member[1] >> bitcast<u32>(_e591)) & 1023u);
                                                let _e620 = (_e586 + bitcast<f32>((bitcast<u32>((f32(_e614) * _e599)) ^ _e121)));
                                                if _e582 {
                                                } else {
                                                    phi_2639_ = true;
                                                    break;
                                                }
                                                local_10[_e577.member_1] = select(select(_e588, _e620, (_e620 < _e588)), _e588, (_e614 == 1023u));
                                            }
                                            continue;
                                            continuing {
                                                phi_1702_ = _e575;
                                                phi_2639_ = _e482;
                                                break if !(_e581);
                                            }
                                        }
                                        let _e628 = phi_2639_;
                                        phi_2770_ = _e628;
                                        if _e628 {
                                            break;
                                        }
                                        let _e629 = local_10;
                                        let _e630 = local_11;
                                        local_14 = _e560;
                                        local_13 = array<f32, 3>(0f, 0f, 0f);
                                        local_12 = array<f32, 3>(0f, 0f, 0f);
                                        phi_1856_ = type_4(0u, 3u);
                                        loop {
                                            let _e639 = phi_1856_;
                                            if (_e639.member < _e639.member_1) {
                                                phi_1857_ = type_4((_e639.member + 1u), _e639.member_1);
                                                phi_1880_ = type_4(1u, _e639.member);
                                            } else {
                                                phi_1857_ = _e639;
                                                phi_1880_ = type_4(0u, type_4().member_1);
                                            }
                                            let _e652 = phi_1857_;
                                            let _e654 = phi_1880_;
                                            let _e658 = (bitcast<i32>(_e654.member) != 0i);
                                            if _e658 {
                                                let _e659 = (_e654.member_1 < 3u);
                                                if _e659 {
                                                } else {
                                                    phi_2699_ = true;
                                                    break;
                                                }
                                                let _e661 = local_14[_e654.member_1];
                                                if _e659 {
                                                } else {
                                                    phi_2699_ = true;
                                                    break;
                                                }
                                                let _e663 = local_8[_e654.member_1];
                                                if _e659 {
                                                } else {
                                                    phi_2699_ = true;
                                                    break;
                                                }
                                                let _e665 = local_7[_e654.member_1];
                                                let _e668 = ((10u * _e661) & 31u);
                                                let _e671 = ((_e558.member_1[0] >> bitcast<u32>(_e668)) & 1023u);
                                                let _e676 = bitcast<f32>((bitcast<u32>(((_e665 - _e663) * 0.0009775171f)) ^ _e121));
                                                let _e682 = (_e663 + bitcast<f32>((bitcast<u32>((f32(_e671) * _e676)) ^ _e121)));
                                                if _e659 {
                                                } else {
                                                    phi_2699_ = true;
                                                    break;
                                                }
                                                local_13[_e654.member_1] = select(select(_e665, _e682, (_e682 < _e665)), _e665, (_e671 == 1023u));
                                                let _e691 = ((_e558.member_1[1] >> bitcast<u32>(_e668)) & 1023u);
                                                let _e697 = (_e663 + bitcast<f32>((bitcast<u32>((f32(_e691) * _e676)) ^ _e121)));
                                                if _e659 {
                                                } else {
                                                    phi_2699_ = true;
                                                    break;
                                                }
                                                local_12[_e654.member_1] = select(select(_e665, _e697, (_e697 < _e665)), _e665, (_e691 == 1023u));
                                            }
                                            continue;
                                            continuing {
                                                phi_1856_ = _e652;
                                                phi_2699_ = _e628;
                                                break if !(_e658);
                                            }
                                        }
                                        let _e705 = phi_2699_;
                                        phi_2770_ = _e705;
                                        if _e705 {
                                            break;
                                        }
                                        let _e706 = local_12;
                                        let _e707 = local_13;
                                        let _e718 = type_51(type_49(array<f32, 3>(_e630[0], _e630[1], _e630[2]), array<f32, 3>(_e629[0], _e629[1], _e629[2])), _e558.member_2);
                                        let _e723 = type_51(type_49(array<f32, 3>(_e707[0], _e707[1], _e707[2]), array<f32, 3>(_e706[0], _e706[1], _e706[2])), _e558.member_3);
                                        let _e730 = ((_e630[0] - _e321) * _e326);
                                        let _e731 = ((_e707[0] - _e321) * _e326);
                                        let _e732 = ((_e629[0] - _e322) * _e326);
                                        let _e733 = ((_e706[0] - _e322) * _e326);
                                        let _e738 = ((_e630[1] - _e359) * _e364);
                                        let _e739 = ((_e707[1] - _e359) * _e364);
                                        let _e740 = ((_e629[1] - _e360) * _e364);
                                        let _e741 = ((_e706[1] - _e360) * _e364);
                                        let _e746 = ((_e630[2] - _e397) * _e402);
                                        let _e747 = ((_e707[2] - _e397) * _e402);
                                        let _e748 = ((_e629[2] - _e398) * _e402);
                                        let _e749 = ((_e706[2] - _e398) * _e402);
                                        let _e751 = select(_e748, _e746, (_e746 < _e748));
                                        let _e753 = select(_e749, _e747, (_e747 < _e749));
                                        let _e755 = select(_e748, _e746, (_e746 > _e748));
                                        let _e757 = select(_e749, _e747, (_e747 > _e749));
                                        let _e759 = select(_e732, _e730, (_e730 < _e732));
                                        let _e761 = select(_e733, _e731, (_e731 < _e733));
                                        let _e763 = select(_e740, _e738, (_e738 < _e740));
                                        let _e765 = select(_e741, _e739, (_e739 < _e741));
                                        let _e767 = select(_e763, _e759, (_e759 > _e763));
                                        let _e769 = select(_e765, _e761, (_e761 > _e765));
                                        let _e771 = select(_e751, _e767, (_e767 > _e751));
                                        let _e773 = select(_e753, _e769, (_e769 > _e753));
                                        let _e775 = select(_e732, _e730, (_e730 > _e732));
                                        let _e777 = select(_e733, _e731, (_e731 > _e733));
                                        let _e779 = select(_e740, _e738, (_e738 > _e740));
                                        let _e781 = select(_e741, _e739, (_e739 > _e741));
                                        let _e783 = select(_e779, _e775, (_e775 < _e779));
                                        let _e785 = select(_e781, _e777, (_e777 < _e781));
                                        let _e790 = -(_e751);
                                        let _e791 = -(_e753);
                                        let _e798 = (select(_e755, _e783, (_e783 < _e755)) + (select(_e790, _e755, (_e755 > _e790)) * 0.0000019073523f));
                                        let _e799 = (select(_e757, _e785, (_e785 < _e757)) + (select(_e791, _e757, (_e757 > _e791)) * 0.0000019073523f));
                                        let _e801 = select(_e449, _e771, (_e771 > _e449));
                                        let _e803 = select(_e449, _e773, (_e773 > _e449));
                                        let _e808 = (_e801 <= select(_e484.member.member_1, _e798, (_e798 < _e484.member.member_1)));
                                        let _e809 = (_e803 <= select(_e484.member.member_1, _e799, (_e799 < _e484.member.member_1)));
                                        let _e810 = (_e801 <= _e803);
                                        if _e808 {
                                            if _e809 {
                                                if _e810 {
                                                    phi_2443_ = _e723;
                                                } else {
                                                    phi_2443_ = _e718;
                                                }
                                                let _e812 = phi_2443_;
                                                let _e820 = (_e528 % 128u);
                                                let _e821 = (_e820 < 128u);
                                                if _e821 {
                                                } else {
                                                    phi_2770_ = true;
                                                    break;
                                                }
                                                local_6[_e820] = _e812.member_1;
                                                if _e821 {
                                                } else {
                                                    phi_2770_ = true;
                                                    break;
                                                }
                                                local_5[_e820] = _e812.member.member[0];
                                                if _e821 {
                                                } else {
                                                    phi_2770_ = true;
                                                    break;
                                                }
                                                local_4[_e820] = _e812.member.member[1];
                                                if _e821 {
                                                } else {
                                                    phi_2770_ = true;
                                                    break;
                                                }
                                                local_3[_e820] = _e812.member.member[2];
                                                if _e821 {
                                                } else {
                                                    phi_2770_ = true;
                                                    break;
                                                }
                                                local_2[_e820] = _e812.member.member_1[0];
                                                if _e821 {
                                                } else {
                                                    phi_2770_ = true;
                                                    break;
                                                }
                                                local_1[_e820] = _e812.member.member_1[1];
                                                if _e821 {
                                                } else {
                                                    phi_2770_ = true;
                                                    break;
                                                }
                                                local[_e820] = _e812.member.member_1[2];
                                                if _e821 {
                                                } else {
                                                    phi_2770_ = true;
                                                    break;
                                                }
                                                local_9[_e820] = select(_e803, _e801, (_e801 > _e803));
                                                if _e810 {
                                                    phi_2520_ = _e718;
                                                } else {
                                                    phi_2520_ = _e723;
                                                }
                                                let _e838 = phi_2520_;
                                                phi_2521_ = _e838;
                                                phi_2522_ = (_e528 + 1u);
                                            } else {
                                                phi_2521_ = type_51();
                                                phi_2522_ = u32();
                                            }
                                            let _e840 = phi_2521_;
                                            let _e842 = phi_2522_;
                                            phi_2524_ = _e840;
                                            phi_2525_ = _e842;
                                            phi_2526_ = select(true, false, _e809);
                                        } else {
                                            phi_2524_ = type_51();
                                            phi_2525_ = u32();
                                            phi_2526_ = true;
                                        }
                                        let _e845 = phi_2524_;
                                        let _e847 = phi_2525_;
                                        let _e849 = phi_2526_;
                                        if _e849 {
                                            if _e808 {
                                                phi_2533_ = _e718;
                                            } else {
                                                phi_2533_ = _e723;
                                            }
                                            let _e851 = phi_2533_;
                                            phi_2538_ = _e851;
                                            phi_2539_ = select(_e809, true, _e808);
                                        } else {
                                            phi_2538_ = _e845;
                                            phi_2539_ = _e526;
                                        }
                                        let _e854 = phi_2538_;
                                        let _e856 = phi_2539_;
                                        phi_2774_ = _e705;
                                        phi_2541_ = type_38(_e484.member, (_e484.member_1 + 1u), _e484.member_2);
                                        phi_2542_ = _e854;
                                        phi_2543_ = _e856;
                                        phi_2544_ = select(_e847, _e528, _e849);
                                    }
                                    let _e1280 = phi_2774_;
                                    let _e1282 = phi_2541_;
                                    let _e1284 = phi_2542_;
                                    let _e1286 = phi_2543_;
                                    let _e1288 = phi_2544_;
                                    phi_2773_ = _e1280;
                                    phi_2545_ = _e1282;
                                    phi_2546_ = _e1284;
                                    phi_2547_ = (_e488 - 1u);
                                    phi_2548_ = _e1286;
                                    phi_2549_ = _e1288;
                                } else {
                                    phi_2773_ = _e482;
                                    phi_2545_ = _e484;
                                    phi_2546_ = _e524;
                                    phi_2547_ = _e488;
                                    phi_2548_ = _e526;
                                    phi_2549_ = _e528;
                                }
                                let _e1290 = phi_2773_;
                                let _e1292 = phi_2545_;
                                let _e1294 = phi_2546_;
                                let _e1296 = phi_2547_;
                                let _e1298 = phi_2548_;
                                let _e1300 = phi_2549_;
                                phi_2772_ = _e1290;
                                phi_2550_ = _e1292;
                                phi_2551_ = _e1294;
                                phi_2552_ = _e1296;
                                phi_2553_ = _e1298;
                                phi_2554_ = _e1300;
                            } else {
                                phi_2772_ = _e482;
                                phi_2550_ = type_38();
                                phi_2551_ = type_51();
                                phi_2552_ = u32();
                                phi_2553_ = bool();
                                phi_2554_ = u32();
                            }
                            let _e1302 = phi_2772_;
                            let _e1304 = phi_2550_;
                            let _e1306 = phi_2551_;
                            let _e1308 = phi_2552_;
                            let _e1310 = phi_2553_;
                            let _e1312 = phi_2554_;
                            phi_2771_ = _e1302;
                            phi_781_ = _e1304;
                            phi_784_ = _e1306;
                            phi_786_ = _e1308;
                            phi_788_ = _e1310;
                            phi_790_ = _e1312;
                            phi_2555_ = _e496;
                        } else {
                            phi_2771_ = _e482;
                            phi_781_ = type_38();
                            phi_784_ = type_51();
                            phi_786_ = u32();
                            phi_788_ = bool();
                            phi_790_ = u32();
                            phi_2555_ = false;
                        }
                        let _e1314 = phi_2771_;
                        let _e1316 = phi_781_;
                        let _e1318 = phi_784_;
                        let _e1320 = phi_786_;
                        let _e1322 = phi_788_;
                        let _e1324 = phi_790_;
                        let _e1326 = phi_2555_;
                        continue;
                        continuing {
                            phi_2646_ = _e1314;
                            phi_780_ = _e1316;
                            phi_783_ = _e1318;
                            phi_785_ = _e1320;
                            phi_787_ = _e1322;
                            phi_789_ = _e1324;
                            phi_2770_ = _e1314;
                            break if !(_e1326);
                        }
                    }
                    let _e1329 = phi_2770_;
                    if _e1329 {
                        break;
                    }
                    let _e1331 = local_18;
                    let _e1334 = local_19;
                    if _e137 {
                    } else {
                        break;
                    }
                    global_6.member[_e135][0u] = _e1331.member_1;
                    global_6.member[_e135][1u] = _e1334.member_2;
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn trace_counted_printed_f32_(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
