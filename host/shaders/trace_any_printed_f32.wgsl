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

struct type_35 {
    member: array<type_26>,
}

struct type_37 {
    member: f32,
    member_1: bool,
}

struct type_39 {
    member: array<vec4<u32>, 2>,
}

struct type_41 {
    member: array<u32, 2>,
    member_1: array<u32, 2>,
    member_2: u32,
    member_3: u32,
}

struct type_43 {
    member: array<type_41>,
}

struct type_48 {
    member: array<f32, 3>,
    member_1: array<f32, 3>,
}

struct type_50 {
    member: type_48,
    member_1: u32,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_1: type_11;
@group(0) @binding(3) 
var<storage> global_2: type_18;
@group(0) @binding(1) 
var<uniform> global_3: type_39;
@group(0) @binding(4) 
var<storage> global_4: type_35;
@group(0) @binding(5) 
var<storage, read_write> global_5: type_4;
@group(0) @binding(2) 
var<storage> global_6: type_43;

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
    var phi_334_: i32;
    var phi_335_: i32;
    var phi_345_: bool;
    var phi_355_: u32;
    var phi_356_: u32;
    var phi_358_: bool;
    var phi_363_: u32;
    var phi_376_: i32;
    var phi_396_: i32;
    var phi_414_: f32;
    var phi_420_: f32;
    var phi_431_: f32;
    var phi_437_: f32;
    var phi_460_: f32;
    var phi_471_: f32;
    var phi_480_: f32;
    var phi_486_: f32;
    var phi_497_: f32;
    var phi_503_: f32;
    var phi_526_: f32;
    var phi_537_: f32;
    var phi_546_: f32;
    var phi_552_: f32;
    var phi_563_: f32;
    var phi_569_: f32;
    var phi_592_: f32;
    var phi_603_: f32;
    var phi_703_: f32;
    var phi_704_: f32;
    var phi_2613_: bool;
    var phi_777_: type_37;
    var phi_780_: type_50;
    var phi_782_: u32;
    var phi_784_: bool;
    var phi_786_: u32;
    var phi_797_: bool;
    var phi_883_: type_50;
    var phi_884_: bool;
    var phi_885_: u32;
    var phi_1662_: type_41;
    var phi_1671_: type_7;
    var phi_1672_: type_7;
    var phi_1695_: type_7;
    var phi_2606_: bool;
    var phi_1825_: type_7;
    var phi_1826_: type_7;
    var phi_1849_: type_7;
    var phi_2666_: bool;
    var phi_2412_: type_50;
    var phi_2489_: type_50;
    var phi_2490_: type_50;
    var phi_2491_: u32;
    var phi_2493_: type_50;
    var phi_2494_: u32;
    var phi_2495_: bool;
    var phi_2502_: type_50;
    var phi_2507_: type_50;
    var phi_2508_: bool;
    var phi_903_: type_37;
    var phi_906_: type_7;
    var phi_907_: type_7;
    var phi_929_: type_7;
    var phi_950_: u32;
    var phi_1039_: array<array<f32, 3>, 3>;
    var phi_1510_: vec3<f32>;
    var phi_1511_: vec3<f32>;
    var phi_1542_: bool;
    var phi_1551_: vec3<f32>;
    var phi_1591_: type_25;
    var phi_1593_: type_25;
    var phi_1594_: bool;
    var phi_1598_: type_25;
    var phi_1599_: type_25;
    var phi_1600_: type_25;
    var phi_1601_: bool;
    var phi_1605_: type_25;
    var phi_1606_: bool;
    var phi_1610_: type_25;
    var phi_1611_: bool;
    var phi_1615_: type_25;
    var phi_1626_: type_37;
    var phi_1627_: type_37;
    var phi_904_: type_37;
    var phi_2674_: bool;
    var local_18: type_37;
    var phi_2738_: bool;
    var phi_2510_: type_37;
    var phi_2511_: type_50;
    var phi_2512_: bool;
    var phi_2513_: u32;
    var phi_2737_: bool;
    var phi_2514_: type_37;
    var phi_2515_: type_50;
    var phi_2516_: u32;
    var phi_2517_: bool;
    var phi_2518_: u32;
    var phi_2736_: bool;
    var phi_2519_: type_37;
    var phi_2520_: type_50;
    var phi_2521_: u32;
    var phi_2522_: bool;
    var phi_2523_: u32;
    var phi_2735_: bool;
    var phi_778_: type_37;
    var phi_781_: type_50;
    var phi_783_: u32;
    var phi_785_: bool;
    var phi_787_: u32;
    var phi_2524_: bool;
    var phi_2734_: bool;
    var local_19: type_37;
    var local_20: type_37;

    switch bitcast<i32>(0u) {
        default: {
            let _e84 = global;
            let _e87 = arrayLength((&global_6.member));
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
                let _e137 = (_e135 < arrayLength((&global_5.member)));
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
                            phi_334_ = (bitcast<i32>((_e214 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_334_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e214)), 32u, (_e214 == 0u))));
                        }
                        let _e228 = phi_334_;
                        phi_335_ = _e228;
                    } else {
                        phi_335_ = 0i;
                    }
                    let _e230 = phi_335_;
                    let _e231 = (_e147 == _e186);
                    if _e231 {
                        phi_345_ = true;
                    } else {
                        phi_345_ = (_e154 == _e186);
                    }
                    let _e234 = phi_345_;
                    let _e235 = select(1u, 0u, _e231);
                    if _e234 {
                        let _e236 = (_e235 + 1u);
                        phi_355_ = _e236;
                        phi_356_ = _e236;
                        phi_358_ = select(true, false, (_e236 == 2u));
                    } else {
                        phi_355_ = u32();
                        phi_356_ = 0u;
                        phi_358_ = true;
                    }
                    let _e240 = phi_355_;
                    let _e242 = phi_356_;
                    let _e244 = phi_358_;
                    if _e244 {
                        phi_363_ = (_e242 + 1u);
                    } else {
                        phi_363_ = 0u;
                    }
                    let _e248 = phi_363_;
                    let _e249 = select(_e240, _e242, _e244);
                    let _e250 = select(_e235, select(2u, _e235, _e234), _e244);
                    if (_e125 < -126i) {
                        phi_376_ = -126i;
                    } else {
                        phi_376_ = select(_e125, 127i, (_e125 > 127i));
                    }
                    let _e255 = phi_376_;
                    let _e260 = bitcast<f32>((bitcast<u32>((_e255 + 127i)) << bitcast<u32>(23i)));
                    let _e266 = bitcast<f32>((bitcast<u32>(((_e125 - _e255) + 127i)) << bitcast<u32>(23i)));
                    let _e267 = -(_e230);
                    if (_e267 < -126i) {
                        phi_396_ = -126i;
                    } else {
                        phi_396_ = select(_e267, 127i, (_e267 > 127i));
                    }
                    let _e272 = phi_396_;
                    let _e277 = bitcast<f32>((bitcast<u32>((_e272 + 127i)) << bitcast<u32>(23i)));
                    let _e283 = bitcast<f32>((bitcast<u32>(((_e267 - _e272) + 127i)) << bitcast<u32>(23i)));
                    let _e287 = global_4.member[_e135].member;
                    let _e288 = (_e249 == 0u);
                    if _e288 {
                        phi_414_ = _e287[0];
                    } else {
                        phi_414_ = _e287[1];
                    }
                    let _e292 = phi_414_;
                    let _e293 = (_e249 == 2u);
                    if _e293 {
                        phi_420_ = _e287[2];
                    } else {
                        phi_420_ = _e292;
                    }
                    let _e296 = phi_420_;
                    let _e298 = ((_e296 * _e260) * _e266);
                    let _e299 = global_4.member[_e135].member_2;
                    if _e288 {
                        phi_431_ = _e299[0];
                    } else {
                        phi_431_ = _e299[1];
                    }
                    let _e303 = phi_431_;
                    if _e293 {
                        phi_437_ = _e299[2];
                    } else {
                        phi_437_ = _e303;
                    }
                    let _e306 = phi_437_;
                    let _e308 = ((_e306 * _e277) * _e283);
                    let _e312 = (bitcast<f32>((bitcast<u32>(_e308) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e312 {
                        let _e316 = (bitcast<f32>((bitcast<u32>(_e298) & 2147483647u)) * 0.00000011920929f);
                        phi_460_ = select(0.00000000000011368684f, _e316, (_e316 > 0.00000000000011368684f));
                    } else {
                        phi_460_ = 0f;
                    }
                    let _e320 = phi_460_;
                    let _e321 = (_e298 + _e320);
                    let _e322 = (_e298 - _e320);
                    let _e323 = select(_e308, 0f, _e312);
                    if _e312 {
                        phi_471_ = 38685626000000000000000000f;
                    } else {
                        phi_471_ = (1f / _e308);
                    }
                    let _e326 = phi_471_;
                    let _e327 = (_e248 == 0u);
                    if _e327 {
                        phi_480_ = _e287[0];
                    } else {
                        phi_480_ = _e287[1];
                    }
                    let _e331 = phi_480_;
                    let _e332 = (_e248 == 2u);
                    if _e332 {
                        phi_486_ = _e287[2];
                    } else {
                        phi_486_ = _e331;
                    }
                    let _e335 = phi_486_;
                    let _e337 = ((_e335 * _e260) * _e266);
                    if _e327 {
                        phi_497_ = _e299[0];
                    } else {
                        phi_497_ = _e299[1];
                    }
                    let _e341 = phi_497_;
                    if _e332 {
                        phi_503_ = _e299[2];
                    } else {
                        phi_503_ = _e341;
                    }
                    let _e344 = phi_503_;
                    let _e346 = ((_e344 * _e277) * _e283);
                    let _e350 = (bitcast<f32>((bitcast<u32>(_e346) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e350 {
                        let _e354 = (bitcast<f32>((bitcast<u32>(_e337) & 2147483647u)) * 0.00000011920929f);
                        phi_526_ = select(0.00000000000011368684f, _e354, (_e354 > 0.00000000000011368684f));
                    } else {
                        phi_526_ = 0f;
                    }
                    let _e358 = phi_526_;
                    let _e359 = (_e337 + _e358);
                    let _e360 = (_e337 - _e358);
                    let _e361 = select(_e346, 0f, _e350);
                    if _e350 {
                        phi_537_ = 38685626000000000000000000f;
                    } else {
                        phi_537_ = (1f / _e346);
                    }
                    let _e364 = phi_537_;
                    let _e365 = (_e250 == 0u);
                    if _e365 {
                        phi_546_ = _e287[0];
                    } else {
                        phi_546_ = _e287[1];
                    }
                    let _e369 = phi_546_;
                    let _e370 = (_e250 == 2u);
                    if _e370 {
                        phi_552_ = _e287[2];
                    } else {
                        phi_552_ = _e369;
                    }
                    let _e373 = phi_552_;
                    let _e375 = ((_e373 * _e260) * _e266);
                    if _e365 {
                        phi_563_ = _e299[0];
                    } else {
                        phi_563_ = _e299[1];
                    }
                    let _e379 = phi_563_;
                    if _e370 {
                        phi_569_ = _e299[2];
                    } else {
                        phi_569_ = _e379;
                    }
                    let _e382 = phi_569_;
                    let _e384 = ((_e382 * _e277) * _e283);
                    let _e388 = (bitcast<f32>((bitcast<u32>(_e384) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e388 {
                        let _e392 = (bitcast<f32>((bitcast<u32>(_e375) & 2147483647u)) * 0.00000011920929f);
                        phi_592_ = select(0.00000000000011368684f, _e392, (_e392 > 0.00000000000011368684f));
                    } else {
                        phi_592_ = 0f;
                    }
                    let _e396 = phi_592_;
                    let _e397 = (_e375 + _e396);
                    let _e398 = (_e375 - _e396);
                    let _e399 = select(_e384, 0f, _e388);
                    if _e388 {
                        phi_603_ = 38685626000000000000000000f;
                    } else {
                        phi_603_ = (1f / _e384);
                    }
                    let _e402 = phi_603_;
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
                        phi_703_ = select(-340282350000000000000000000000000000000f, _e443, (_e443 > -340282350000000000000000000000000000000f));
                        phi_704_ = select(-340282350000000000000000000000000000000f, _e436, (_e436 > -340282350000000000000000000000000000000f));
                    } else {
                        phi_703_ = 0f;
                        phi_704_ = 1f;
                    }
                    let _e447 = phi_703_;
                    let _e449 = phi_704_;
                    local_6 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                    local_5 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_4 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_3 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_1 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_9 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_17 = array<f32, 3>(bitcast<f32>(_e97), bitcast<f32>(_e101), bitcast<f32>(_e105));
                    let _e454 = (_e249 % 3u);
                    let _e455 = (_e454 < 3u);
                    if _e455 {
                    } else {
                        break;
                    }
                    let _e457 = local_17[_e454];
                    let _e458 = (_e248 % 3u);
                    let _e459 = (_e458 < 3u);
                    if _e459 {
                    } else {
                        break;
                    }
                    let _e461 = local_17[_e458];
                    let _e462 = (_e250 % 3u);
                    let _e463 = (_e462 < 3u);
                    if _e463 {
                    } else {
                        break;
                    }
                    let _e465 = local_17[_e462];
                    local_16 = array<f32, 3>(bitcast<f32>(_e109), bitcast<f32>(_e113), bitcast<f32>(_e117));
                    if _e455 {
                    } else {
                        break;
                    }
                    let _e469 = local_16[_e454];
                    if _e459 {
                    } else {
                        break;
                    }
                    let _e471 = local_16[_e458];
                    if _e463 {
                    } else {
                        break;
                    }
                    let _e473 = local_16[_e462];
                    phi_2613_ = false;
                    phi_777_ = type_37(_e447, false);
                    phi_780_ = type_50(type_48(array<f32, 3>(_e457, _e461, _e465), array<f32, 3>(_e469, _e471, _e473)), select(0u, 2147483648u, (_e87 == 0u)));
                    phi_782_ = ((3u * _e87) + 1u);
                    phi_784_ = (_e449 <= _e447);
                    phi_786_ = 0u;
                    loop {
                        let _e481 = phi_2613_;
                        let _e483 = phi_777_;
                        let _e485 = phi_780_;
                        let _e487 = phi_782_;
                        let _e489 = phi_784_;
                        let _e491 = phi_786_;
                        local_19 = _e483;
                        if _e489 {
                            phi_797_ = true;
                        } else {
                            phi_797_ = (_e491 > 0u);
                        }
                        let _e494 = phi_797_;
                        if _e494 {
                            let _e495 = (_e487 > 0u);
                            if _e495 {
                                if _e489 {
                                    phi_883_ = _e485;
                                    phi_884_ = _e489;
                                    phi_885_ = _e491;
                                } else {
                                    let _e496 = (_e491 - 1u);
                                    let _e497 = (_e496 % 128u);
                                    let _e498 = (_e497 < 128u);
                                    if _e498 {
                                    } else {
                                        phi_2734_ = true;
                                        break;
                                    }
                                    let _e500 = local_6[_e497];
                                    if _e498 {
                                    } else {
                                        phi_2734_ = true;
                                        break;
                                    }
                                    let _e502 = local_5[_e497];
                                    if _e498 {
                                    } else {
                                        phi_2734_ = true;
                                        break;
                                    }
                                    let _e504 = local_4[_e497];
                                    if _e498 {
                                    } else {
                                        phi_2734_ = true;
                                        break;
                                    }
                                    let _e506 = local_3[_e497];
                                    if _e498 {
                                    } else {
                                        phi_2734_ = true;
                                        break;
                                    }
                                    let _e509 = local_2[_e497];
                                    if _e498 {
                                    } else {
                                        phi_2734_ = true;
                                        break;
                                    }
                                    let _e511 = local_1[_e497];
                                    if _e498 {
                                    } else {
                                        phi_2734_ = true;
                                        break;
                                    }
                                    let _e513 = local[_e497];
                                    if _e498 {
                                    } else {
                                        phi_2734_ = true;
                                        break;
                                    }
                                    let _e518 = local_9[_e497];
                                    phi_883_ = type_50(type_48(array<f32, 3>(_e502, _e504, _e506), array<f32, 3>(_e509, _e511, _e513)), _e500);
                                    phi_884_ = (_e518 <= _e483.member);
                                    phi_885_ = _e496;
                                }
                                let _e522 = phi_883_;
                                let _e524 = phi_884_;
                                let _e526 = phi_885_;
                                if _e524 {
                                    if ((_e522.member_1 & 2147483648u) != 0u) {
                                        phi_903_ = _e483;
                                        phi_906_ = type_7(0u, ((_e522.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e851 = phi_903_;
                                            let _e853 = phi_906_;
                                            local_18 = _e851;
                                            local_20 = _e851;
                                            if (_e853.member < _e853.member_1) {
                                                phi_907_ = type_7((_e853.member + 1u), _e853.member_1);
                                                phi_929_ = type_7(1u, _e853.member);
                                            } else {
                                                phi_907_ = _e853;
                                                phi_929_ = type_7(0u, type_7().member_1);
                                            }
                                            let _e866 = phi_907_;
                                            let _e868 = phi_929_;
                                            let _e872 = (bitcast<i32>(_e868.member) != 0i);
                                            if _e872 {
                                                let _e873 = ((_e522.member_1 & 268435455u) + _e868.member_1);
                                                let _e874 = (_e873 < _e89);
                                                if _e874 {
                                                    if _e874 {
                                                    } else {
                                                        phi_2674_ = true;
                                                        break;
                                                    }
                                                    let _e878 = global_2.member[_e873].member_1;
                                                    phi_950_ = _e878;
                                                } else {
                                                    phi_950_ = 4294967295u;
                                                }
                                                let _e880 = phi_950_;
                                                if (_e873 >= _e89) {
                                                    phi_1039_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                } else {
                                                    if _e874 {
                                                    } else {
                                                        phi_2674_ = true;
                                                        break;
                                                    }
                                                    if (_e454 < 9u) {
                                                    } else {
                                                        phi_2674_ = true;
                                                        break;
                                                    }
                                                    let _e887 = global_2.member[_e873].member[_e454];
                                                    if (_e458 < 9u) {
                                                    } else {
                                                        phi_2674_ = true;
                                                        break;
                                                    }
                                                    let _e893 = global_2.member[_e873].member[_e458];
                                                    if (_e462 < 9u) {
                                                    } else {
                                                        phi_2674_ = true;
                                                        break;
                                                    }
                                                    let _e899 = global_2.member[_e873].member[_e462];
                                                    let _e901 = (3u + _e454);
                                                    if (_e901 < 9u) {
                                                    } else {
                                                        phi_2674_ = true;
                                                        break;
                                                    }
                                                    let _e907 = global_2.member[_e873].member[_e901];
                                                    let _e908 = (3u + _e458);
                                                    if (_e908 < 9u) {
                                                    } else {
                                                        phi_2674_ = true;
                                                        break;
                                                    }
                                                    let _e914 = global_2.member[_e873].member[_e908];
                                                    let _e915 = (3u + _e462);
                                                    if (_e915 < 9u) {
                                                    } else {
                                                        phi_2674_ = true;
                                                        break;
                                                    }
                                                    let _e921 = global_2.member[_e873].member[_e915];
                                                    let _e923 = (6u + _e454);
                                                    if (_e923 < 9u) {
                                                    } else {
                                                        phi_2674_ = true;
                                                        break;
                                                    }
                                                    let _e929 = global_2.member[_e873].member[_e923];
                                                    let _e930 = (6u + _e458);
                                                    if (_e930 < 9u) {
                                                    } else {
                                                        phi_2674_ = true;
                                                        break;
                                                    }
                                                    let _e936 = global_2.member[_e873].member[_e930];
                                                    let _e937 = (6u + _e462);
                                                    if (_e937 < 9u) {
                                                    } else {
                                                        phi_2674_ = true;
                                                        break;
                                                    }
                                                    let _e943 = global_2.member[_e873].member[_e937];
                                                    phi_1039_ = array<array<f32, 3>, 3>(array<f32, 3>(_e887, _e893, _e899), array<f32, 3>(_e907, _e914, _e921), array<f32, 3>(_e929, _e936, _e943));
                                                }
                                                let _e947 = phi_1039_;
                                                let _e955 = (_e947[0][2] - _e375);
                                                let _e958 = (((_e947[0][0] - _e298) * _e399) - (_e955 * _e323));
                                                let _e961 = (((_e947[0][1] - _e337) * _e399) - (_e955 * _e361));
                                                let _e968 = (_e947[1][2] - _e375);
                                                let _e971 = (((_e947[1][0] - _e298) * _e399) - (_e968 * _e323));
                                                let _e974 = (((_e947[1][1] - _e337) * _e399) - (_e968 * _e361));
                                                let _e981 = (_e947[2][2] - _e375);
                                                let _e984 = (((_e947[2][0] - _e298) * _e399) - (_e981 * _e323));
                                                let _e987 = (((_e947[2][1] - _e337) * _e399) - (_e981 * _e361));
                                                let _e988 = (_e984 * _e974);
                                                let _e989 = (_e987 * _e971);
                                                let _e990 = (_e958 * _e987);
                                                let _e991 = (_e961 * _e984);
                                                let _e992 = (_e971 * _e961);
                                                let _e993 = (_e974 * _e958);
                                                let _e998 = (((_e988 >= _e989) && (_e990 >= _e991)) && (_e992 >= _e993));
                                                if (_e998 || (((_e988 <= _e989) && (_e990 <= _e991)) && (_e992 <= _e993))) {
                                                    let _e1005 = select(-1f, 1f, _e998);
                                                    let _e1007 = ((_e988 - _e989) * _e1005);
                                                    let _e1009 = select(0f, _e1007, (_e1007 > 0f));
                                                    let _e1011 = ((_e990 - _e991) * _e1005);
                                                    let _e1013 = select(0f, _e1011, (_e1011 > 0f));
                                                    let _e1015 = ((_e992 - _e993) * _e1005);
                                                    let _e1017 = select(0f, _e1015, (_e1015 > 0f));
                                                    let _e1019 = ((_e1009 + _e1013) + _e1017);
                                                    if (_e1019 < 0.000000000000000000000000000000000000011754944f) {
                                                        phi_1605_ = type_25();
                                                        phi_1606_ = true;
                                                    } else {
                                                        let _e1022 = select(_e947[1][0], _e947[0][0], (_e947[0][0] < _e947[1][0]));
                                                        let _e1026 = select(_e947[1][0], _e947[0][0], (_e947[0][0] > _e947[1][0]));
                                                        let _e1030 = select(_e947[1][1], _e947[0][1], (_e947[0][1] < _e947[1][1]));
                                                        let _e1034 = select(_e947[1][1], _e947[0][1], (_e947[0][1] > _e947[1][1]));
                                                        let _e1038 = select(_e947[1][2], _e947[0][2], (_e947[0][2] < _e947[1][2]));
                                                        let _e1042 = select(_e947[1][2], _e947[0][2], (_e947[0][2] > _e947[1][2]));
                                                        let _e1047 = ((select(_e947[2][0], _e1022, (_e1022 < _e947[2][0])) - _e321) * _e326);
                                                        let _e1048 = ((select(_e947[2][0], _e1026, (_e1026 > _e947[2][0])) - _e322) * _e326);
                                                        let _e1051 = ((select(_e947[2][1], _e1030, (_e1030 < _e947[2][1])) - _e359) * _e364);
                                                        let _e1052 = ((select(_e947[2][1], _e1034, (_e1034 > _e947[2][1])) - _e360) * _e364);
                                                        let _e1055 = ((select(_e947[2][2], _e1038, (_e1038 < _e947[2][2])) - _e397) * _e402);
                                                        let _e1056 = ((select(_e947[2][2], _e1042, (_e1042 > _e947[2][2])) - _e398) * _e402);
                                                        let _e1058 = select(_e1056, _e1055, (_e1055 < _e1056));
                                                        let _e1060 = select(_e1056, _e1055, (_e1055 > _e1056));
                                                        let _e1062 = select(_e1048, _e1047, (_e1047 < _e1048));
                                                        let _e1064 = select(_e1052, _e1051, (_e1051 < _e1052));
                                                        let _e1066 = select(_e1064, _e1062, (_e1062 > _e1064));
                                                        let _e1068 = select(_e1058, _e1066, (_e1066 > _e1058));
                                                        let _e1070 = select(_e1048, _e1047, (_e1047 > _e1048));
                                                        let _e1072 = select(_e1052, _e1051, (_e1051 > _e1052));
                                                        let _e1074 = select(_e1072, _e1070, (_e1070 < _e1072));
                                                        let _e1076 = select(_e1060, _e1074, (_e1074 < _e1060));
                                                        let _e1077 = -(_e1058);
                                                        let _e1083 = select(_e449, _e1068, (_e1068 > _e449));
                                                        if (_e1083 > (_e1076 + (select(_e1077, _e1060, (_e1060 > _e1077)) * 0.0000019073523f))) {
                                                            phi_1600_ = type_25();
                                                            phi_1601_ = true;
                                                        } else {
                                                            let _e1085 = (_e1083 > _e851.member);
                                                            if _e1085 {
                                                                phi_1599_ = type_25();
                                                            } else {
                                                                let _e1089 = (_e947[1][0] - _e947[0][0]);
                                                                let _e1090 = (_e947[1][1] - _e947[0][1]);
                                                                let _e1091 = (_e947[1][2] - _e947[0][2]);
                                                                let _e1092 = vec3<f32>(_e1089, _e1090, _e1091);
                                                                let _e1093 = (_e947[2][0] - _e947[1][0]);
                                                                let _e1094 = (_e947[2][1] - _e947[1][1]);
                                                                let _e1095 = (_e947[2][2] - _e947[1][2]);
                                                                let _e1096 = vec3<f32>(_e1093, _e1094, _e1095);
                                                                let _e1097 = (_e947[0][0] - _e947[2][0]);
                                                                let _e1098 = (_e947[0][1] - _e947[2][1]);
                                                                let _e1099 = (_e947[0][2] - _e947[2][2]);
                                                                let _e1100 = vec3<f32>(_e1097, _e1098, _e1099);
                                                                let _e1103 = bitcast<f32>((bitcast<u32>(_e1089) & 2147483647u));
                                                                let _e1106 = bitcast<f32>((bitcast<u32>(_e1090) & 2147483647u));
                                                                let _e1108 = select(_e1106, _e1103, (_e1103 > _e1106));
                                                                let _e1111 = bitcast<f32>((bitcast<u32>(_e1091) & 2147483647u));
                                                                let _e1113 = select(_e1111, _e1108, (_e1108 > _e1111));
                                                                let _e1116 = bitcast<f32>((bitcast<u32>(_e1093) & 2147483647u));
                                                                let _e1119 = bitcast<f32>((bitcast<u32>(_e1094) & 2147483647u));
                                                                let _e1121 = select(_e1119, _e1116, (_e1116 > _e1119));
                                                                let _e1124 = bitcast<f32>((bitcast<u32>(_e1095) & 2147483647u));
                                                                let _e1126 = select(_e1124, _e1121, (_e1121 > _e1124));
                                                                let _e1129 = bitcast<f32>((bitcast<u32>(_e1097) & 2147483647u));
                                                                let _e1132 = bitcast<f32>((bitcast<u32>(_e1098) & 2147483647u));
                                                                let _e1134 = select(_e1132, _e1129, (_e1129 > _e1132));
                                                                let _e1137 = bitcast<f32>((bitcast<u32>(_e1099) & 2147483647u));
                                                                let _e1139 = select(_e1137, _e1134, (_e1134 > _e1137));
                                                                let _e1141 = select(_e1126, _e1113, (_e1113 > _e1126));
                                                                let _e1143 = select(_e1139, _e1141, (_e1141 > _e1139));
                                                                if (_e1113 == _e1143) {
                                                                    phi_1510_ = _e1096;
                                                                    phi_1511_ = _e1100;
                                                                } else {
                                                                    let _e1146 = vec3((_e1126 == _e1143));
                                                                    phi_1510_ = select(_e1092, _e1100, _e1146);
                                                                    phi_1511_ = select(_e1096, _e1092, _e1146);
                                                                }
                                                                let _e1150 = phi_1510_;
                                                                let _e1152 = phi_1511_;
                                                                let _e1159 = ((_e1150.y * _e1152.z) - (_e1152.y * _e1150.z));
                                                                let _e1164 = ((_e1150.z * _e1152.x) - (_e1152.z * _e1150.x));
                                                                let _e1167 = ((_e1150.x * _e1152.y) - (_e1152.x * _e1150.y));
                                                                if (_e1009 >= _e1013) {
                                                                    phi_1542_ = select(true, false, (_e1009 >= _e1017));
                                                                } else {
                                                                    phi_1542_ = true;
                                                                }
                                                                let _e1172 = phi_1542_;
                                                                if _e1172 {
                                                                    phi_1551_ = select(vec3<f32>(_e947[2][0], _e947[2][1], _e947[2][2]), vec3<f32>(_e947[1][0], _e947[1][1], _e947[1][2]), vec3((_e1013 >= _e1017)));
                                                                } else {
                                                                    phi_1551_ = vec3<f32>(_e947[0][0], _e947[0][1], _e947[0][2]);
                                                                }
                                                                let _e1177 = phi_1551_;
                                                                let _e1194 = ((((_e1159 * (_e1177.x - _e298)) + (_e1164 * (_e1177.y - _e337))) + (_e1167 * (_e1177.z - _e375))) / (((_e1159 * _e323) + (_e1164 * _e361)) + (_e1167 * _e399)));
                                                                let _e1196 = select(_e1076, _e1194, (_e1194 < _e1076));
                                                                let _e1198 = select(_e1068, _e1196, (_e1196 > _e1068));
                                                                if (_e1198 >= _e449) {
                                                                    let _e1200 = (_e1198 <= _e851.member);
                                                                    if _e1200 {
                                                                        let _e1201 = (1f / _e1019);
                                                                        phi_1591_ = type_25(_e1198, (_e1013 * _e1201), (_e1017 * _e1201), _e880);
                                                                    } else {
                                                                        phi_1591_ = type_25();
                                                                    }
                                                                    let _e1206 = phi_1591_;
                                                                    phi_1593_ = _e1206;
                                                                    phi_1594_ = select(true, false, _e1200);
                                                                } else {
                                                                    phi_1593_ = type_25();
                                                                    phi_1594_ = true;
                                                                }
                                                                let _e1209 = phi_1593_;
                                                                let _e1211 = phi_1594_;
                                                                if _e1211 {
                                                                    phi_1598_ = type_25(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                } else {
                                                                    phi_1598_ = _e1209;
                                                                }
                                                                let _e1213 = phi_1598_;
                                                                phi_1599_ = _e1213;
                                                            }
                                                            let _e1215 = phi_1599_;
                                                            phi_1600_ = _e1215;
                                                            phi_1601_ = _e1085;
                                                        }
                                                        let _e1217 = phi_1600_;
                                                        let _e1219 = phi_1601_;
                                                        phi_1605_ = _e1217;
                                                        phi_1606_ = _e1219;
                                                    }
                                                    let _e1221 = phi_1605_;
                                                    let _e1223 = phi_1606_;
                                                    phi_1610_ = _e1221;
                                                    phi_1611_ = _e1223;
                                                } else {
                                                    phi_1610_ = type_25();
                                                    phi_1611_ = true;
                                                }
                                                let _e1225 = phi_1610_;
                                                let _e1227 = phi_1611_;
                                                if _e1227 {
                                                    phi_1615_ = type_25(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                } else {
                                                    phi_1615_ = _e1225;
                                                }
                                                let _e1229 = phi_1615_;
                                                if (_e1229.member_3 != 4294967295u) {
                                                    if (_e880 != 4294967295u) {
                                                        phi_1626_ = type_37(_e851.member, true);
                                                    } else {
                                                        phi_1626_ = _e851;
                                                    }
                                                    let _e1237 = phi_1626_;
                                                    phi_1627_ = _e1237;
                                                } else {
                                                    phi_1627_ = _e851;
                                                }
                                                let _e1239 = phi_1627_;
                                                phi_904_ = _e1239;
                                            } else {
                                                phi_904_ = type_37();
                                            }
                                            let _e1241 = phi_904_;
                                            continue;
                                            continuing {
                                                phi_903_ = _e1241;
                                                phi_906_ = _e866;
                                                phi_2674_ = _e481;
                                                break if !(_e872);
                                            }
                                        }
                                        let _e1244 = phi_2674_;
                                        phi_2734_ = _e1244;
                                        if _e1244 {
                                            break;
                                        }
                                        let _e1246 = local_18;
                                        phi_2738_ = _e1244;
                                        let _e1394 = local_20;
                                        phi_2510_ = _e1394;
                                        phi_2511_ = _e522;
                                        phi_2512_ = false;
                                        phi_2513_ = select(_e526, 0u, _e1246.member_1);
                                    } else {
                                        local_8 = array<f32, 3>(_e522.member.member[0], _e522.member.member[1], _e522.member.member[2]);
                                        local_7 = array<f32, 3>(_e522.member.member_1[0], _e522.member.member_1[1], _e522.member.member_1[2]);
                                        let _e546 = (_e522.member_1 < _e87);
                                        if _e546 {
                                            if _e546 {
                                            } else {
                                                phi_2734_ = true;
                                                break;
                                            }
                                            let _e548 = global_6.member[_e522.member_1];
                                            phi_1662_ = _e548;
                                        } else {
                                            phi_1662_ = type_41(array<u32, 2>(0u, 0u), array<u32, 2>(0u, 0u), 2147483648u, 2147483648u);
                                        }
                                        let _e550 = phi_1662_;
                                        let _e552 = array<u32, 3>(_e249, _e248, _e250);
                                        local_15 = _e552;
                                        local_11 = array<f32, 3>(0f, 0f, 0f);
                                        local_10 = array<f32, 3>(0f, 0f, 0f);
                                        phi_1671_ = type_7(0u, 3u);
                                        loop {
                                            let _e554 = phi_1671_;
                                            if (_e554.member < _e554.member_1) {
                                                phi_1672_ = type_7((_e554.member + 1u), _e554.member_1);
                                                phi_1695_ = type_7(1u, _e554.member);
                                            } else {
                                                phi_1672_ = _e554;
                                                phi_1695_ = type_7(0u, type_7().member_1);
                                            }
                                            let _e567 = phi_1672_;
                                            let _e569 = phi_1695_;
                                            let _e573 = (bitcast<i32>(_e569.member) != 0i);
                                            if _e573 {
                                                let _e574 = (_e569.member_1 < 3u);
                                                if _e574 {
                                                } else {
                                                    phi_2606_ = true;
                                                    break;
                                                }
                                                let _e576 = local_15[_e569.member_1];
                                                if _e574 {
                                                } else {
                                                    phi_2606_ = true;
                                                    break;
                                                }
                                                let _e578 = local_8[_e569.member_1];
                                                if _e574 {
                                                } else {
                                                    phi_2606_ = true;
                                                    break;
                                                }
                                                let _e580 = local_7[_e569.member_1];
                                                let _e583 = ((10u * _e576) & 31u);
                                                let _e586 = ((_e550.member[0] >> bitcast<u32>(_e583)) & 1023u);
                                                let _e591 = bitcast<f32>((bitcast<u32>(((_e580 - _e578) * 0.0009775171f)) ^ _e121));
                                                let _e597 = (_e578 + bitcast<f32>((bitcast<u32>((f32(_e586) * _e591)) ^ _e121)));
                                                if _e574 {
                                                } else {
                                                    phi_2606_ = true;
                                                    break;
                                                }
                                                local_11[_e569.member_1] = select(select(_e580, _e597, (_e597 < _e580)), _e580, (_e586 == 1023u));
                                                let _e606 = ((_e550.member[1] >> bitcast<u32>(_e583)) & 1023u);
                                                let _e612 = (_e578 + bitcast<f32>((bitcast<u32>((f32(_e606) * _e591)) ^ _e121)));
                                                if _e574 {
                                                } else {
                                                    phi_2606_ = true;
                                                    break;
                                                }
                                                local_10[_e569.member_1] = select(select(_e580, _e612, (_e612 < _e580)), _e580, (_e606 == 1023u));
                                            }
                                            continue;
                                            continuing {
                                                phi_1671_ = _e567;
                                                phi_2606_ = _e481;
                                                break if !(_e573);
                                            }
                                        }
                                        let _e620 = phi_2606_;
                                        phi_2734_ = _e620;
                                        if _e620 {
                                            break;
                                        }
                                        let _e621 = local_10;
                                        let _e622 = local_11;
                                        local_14 = _e552;
                                        local_13 = array<f32, 3>(0f, 0f, 0f);
                                        local_12 = array<f32, 3>(0f, 0f, 0f);
                                        phi_1825_ = type_7(0u, 3u);
                                        loop {
                                            let _e631 = phi_1825_;
                                            if (_e631.member < _e631.member_1) {
                                                phi_1826_ = type_7((_e631.member + 1u), _e631.member_1);
                                                phi_1849_ = type_7(1u, _e631.member);
                                            } else {
                                                phi_1826_ = _e631;
                                                phi_1849_ = type_7(0u, type_7().member_1);
                                            }
                                            let _e644 = phi_1826_;
                                            let _e646 = phi_1849_;
                                            let _e650 = (bitcast<i32>(_e646.member) != 0i);
                                            if _e650 {
                                                let _e651 = (_e646.member_1 < 3u);
                                                if _e651 {
                                                } else {
                                                    phi_2666_ = true;
                                                    break;
                                                }
                                                let _e653 = local_14[_e646.member_1];
                                                if _e651 {
                                                } else {
                                                    phi_2666_ = true;
                                                    break;
                                                }
                                                let _e655 = local_8[_e646.member_1];
                                                if _e651 {
                                                } else {
                                                    phi_2666_ = true;
                                                    break;
                                                }
                                                let _e657 = local_7[_e646.member_1];
                                                let _e660 = ((10u * _e653) & 31u);
                                                let _e663 = ((_e550.member_1[0] >> bitcast<u32>(_e660)) & 1023u);
                                                let _e668 = bitcast<f32>((bitcast<u32>(((_e657 - _e655) * 0.0009775171f)) ^ _e121));
                                                let _e674 = (_e655 + bitcast<f32>((bitcast<u32>((f32(_e663) * _e668)) ^ _e121)));
                                                if _e651 {
                                                } else {
                                                    phi_2666_ = true;
                                                    break;
                                                }
                                                local_13[_e646.member_1] = select(select(_e657, _e674, (_e674 < _e657)), _e657, (_e663 == 1023u));
                                                let _e683 = ((_e550.member_1[1] >> bitcast<u32>(_e660)) & 1023u);
                                                let _e689 = (_e655 + bitcast<f32>((bitcast<u32>((f32(_e683) * _e668)) ^ _e121)));
                                                if _e651 {
                                                } else {
                                                    phi_2666_ = true;
                                                    break;
                                                }
                                                local_12[_e646.member_1] = select(select(_e657, _e689, (_e689 < _e657)), _e657, (_e683 == 1023u));
                                            }
                                            continue;
                                            continuing {
                                                phi_1825_ = _e644;
                                                phi_2666_ = _e620;
                                                break if !(_e650);
                                            }
                                        }
                                        let _e697 = phi_2666_;
                                        phi_2734_ = _e697;
                                        if _e697 {
                                            break;
                                        }
                                        let _e698 = local_12;
                                        let _e699 = local_13;
                                        let _e710 = type_50(type_48(array<f32, 3>(_e622[0], _e622[1], _e622[2]), array<f32, 3>(_e621[0], _e621[1], _e621[2])), _e550.member_2);
                                        let _e715 = type_50(type_48(array<f32, 3>(_e699[0], _e699[1], _e699[2]), array<f32, 3>(_e698[0], _e698[1], _e698[2])), _e550.member_3);
                                        let _e721 = ((_e622[0] - _e321) * _e326);
                                        let _e722 = ((_e699[0] - _e321) * _e326);
                                        let _e723 = ((_e621[0] - _e322) * _e326);
                                        let _e724 = ((_e698[0] - _e322) * _e326);
                                        let _e729 = ((_e622[1] - _e359) * _e364);
                                        let _e730 = ((_e699[1] - _e359) * _e364);
                                        let _e731 = ((_e621[1] - _e360) * _e364);
                                        let _e732 = ((_e698[1] - _e360) * _e364);
                                        let _e737 = ((_e622[2] - _e397) * _e402);
                                        let _e738 = ((_e699[2] - _e397) * _e402);
                                        let _e739 = ((_e621[2] - _e398) * _e402);
                                        let _e740 = ((_e698[2] - _e398) * _e402);
                                        let _e742 = select(_e739, _e737, (_e737 < _e739));
                                        let _e744 = select(_e740, _e738, (_e738 < _e740));
                                        let _e746 = select(_e739, _e737, (_e737 > _e739));
                                        let _e748 = select(_e740, _e738, (_e738 > _e740));
                                        let _e750 = select(_e723, _e721, (_e721 < _e723));
                                        let _e752 = select(_e724, _e722, (_e722 < _e724));
                                        let _e754 = select(_e731, _e729, (_e729 < _e731));
                                        let _e756 = select(_e732, _e730, (_e730 < _e732));
                                        let _e758 = select(_e754, _e750, (_e750 > _e754));
                                        let _e760 = select(_e756, _e752, (_e752 > _e756));
                                        let _e762 = select(_e742, _e758, (_e758 > _e742));
                                        let _e764 = select(_e744, _e760, (_e760 > _e744));
                                        let _e766 = select(_e723, _e721, (_e721 > _e723));
                                        let _e768 = select(_e724, _e722, (_e722 > _e724));
                                        let _e770 = select(_e731, _e729, (_e729 > _e731));
                                        let _e772 = select(_e732, _e730, (_e730 > _e732));
                                        let _e774 = select(_e770, _e766, (_e766 < _e770));
                                        let _e776 = select(_e772, _e768, (_e768 < _e772));
                                        let _e781 = -(_e742);
                                        let _e782 = -(_e744);
                                        let _e789 = (select(_e746, _e774, (_e774 < _e746)) + (select(_e781, _e746, (_e746 > _e781)) * 0.0000019073523f));
                                        let _e790 = (select(_e748, _e776, (_e776 < _e748)) + (select(_e782, _e748, (_e748 > _e782)) * 0.0000019073523f));
                                        let _e792 = select(_e449, _e762, (_e762 > _e449));
                                        let _e794 = select(_e449, _e764, (_e764 > _e449));
                                        let _e799 = (_e792 <= select(_e483.member, _e789, (_e789 < _e483.member)));
                                        let _e800 = (_e794 <= select(_e483.member, _e790, (_e790 < _e483.member)));
                                        let _e801 = (_e792 <= _e794);
                                        if _e799 {
                                            if _e800 {
                                                if _e801 {
                                                    phi_2412_ = _e715;
                                                } else {
                                                    phi_2412_ = _e710;
                                                }
                                                let _e803 = phi_2412_;
                                                let _e811 = (_e526 % 128u);
                                                let _e812 = (_e811 < 128u);
                                                if _e812 {
                                                } else {
                                                    phi_2734_ = true;
                                                    break;
                                                }
                                                local_6[_e811] = _e803.member_1;
                                                if _e812 {
                                                } else {
                                                    phi_2734_ = true;
                                                    break;
                                                }
                                                local_5[_e811] = _e803.member.member[0];
                                                if _e812 {
                                                } else {
                                                    phi_2734_ = true;
                                                    break;
                                                }
                                                local_4[_e811] = _e803.member.member[1];
                                                if _e812 {
                                                } else {
                                                    phi_2734_ = true;
                                                    break;
                                                }
                                                local_3[_e811] = _e803.member.member[2];
                                                if _e812 {
                                                } else {
                                                    phi_2734_ = true;
                                                    break;
                                                }
                                                local_2[_e811] = _e803.member.member_1[0];
                                                if _e812 {
                                                } else {
                                                    phi_2734_ = true;
                                                    break;
                                                }
                                                local_1[_e811] = _e803.member.member_1[1];
                                                if _e812 {
                                                } else {
                                                    phi_2734_ = true;
                                                    break;
                                                }
                                                local[_e811] = _e803.member.member_1[2];
                                                if _e812 {
                                                } else {
                                                    phi_2734_ = true;
                                                    break;
                                                }
                                                local_9[_e811] = select(_e794, _e792, (_e792 > _e794));
                                                if _e801 {
                                                    phi_2489_ = _e710;
                                                } else {
                                                    phi_2489_ = _e715;
                                                }
                                                let _e829 = phi_2489_;
                                                phi_2490_ = _e829;
                                                phi_2491_ = (_e526 + 1u);
                                            } else {
                                                phi_2490_ = type_50();
                                                phi_2491_ = u32();
                                            }
                                            let _e831 = phi_2490_;
                                            let _e833 = phi_2491_;
                                            phi_2493_ = _e831;
                                            phi_2494_ = _e833;
                                            phi_2495_ = select(true, false, _e800);
                                        } else {
                                            phi_2493_ = type_50();
                                            phi_2494_ = u32();
                                            phi_2495_ = true;
                                        }
                                        let _e836 = phi_2493_;
                                        let _e838 = phi_2494_;
                                        let _e840 = phi_2495_;
                                        if _e840 {
                                            if _e799 {
                                                phi_2502_ = _e710;
                                            } else {
                                                phi_2502_ = _e715;
                                            }
                                            let _e842 = phi_2502_;
                                            phi_2507_ = _e842;
                                            phi_2508_ = select(_e800, true, _e799);
                                        } else {
                                            phi_2507_ = _e836;
                                            phi_2508_ = _e524;
                                        }
                                        let _e845 = phi_2507_;
                                        let _e847 = phi_2508_;
                                        phi_2738_ = _e697;
                                        phi_2510_ = _e483;
                                        phi_2511_ = _e845;
                                        phi_2512_ = _e847;
                                        phi_2513_ = select(_e838, _e526, _e840);
                                    }
                                    let _e1250 = phi_2738_;
                                    let _e1252 = phi_2510_;
                                    let _e1254 = phi_2511_;
                                    let _e1256 = phi_2512_;
                                    let _e1258 = phi_2513_;
                                    phi_2737_ = _e1250;
                                    phi_2514_ = _e1252;
                                    phi_2515_ = _e1254;
                                    phi_2516_ = (_e487 - 1u);
                                    phi_2517_ = _e1256;
                                    phi_2518_ = _e1258;
                                } else {
                                    phi_2737_ = _e481;
                                    phi_2514_ = _e483;
                                    phi_2515_ = _e522;
                                    phi_2516_ = _e487;
                                    phi_2517_ = _e524;
                                    phi_2518_ = _e526;
                                }
                                let _e1260 = phi_2737_;
                                let _e1262 = phi_2514_;
                                let _e1264 = phi_2515_;
                                let _e1266 = phi_2516_;
                                let _e1268 = phi_2517_;
                                let _e1270 = phi_2518_;
                                phi_2736_ = _e1260;
                                phi_2519_ = _e1262;
                                phi_2520_ = _e1264;
                                phi_2521_ = _e1266;
                                phi_2522_ = _e1268;
                                phi_2523_ = _e1270;
                            } else {
                                phi_2736_ = _e481;
                                phi_2519_ = type_37();
                                phi_2520_ = type_50();
                                phi_2521_ = u32();
                                phi_2522_ = bool();
                                phi_2523_ = u32();
                            }
                            let _e1272 = phi_2736_;
                            let _e1274 = phi_2519_;
                            let _e1276 = phi_2520_;
                            let _e1278 = phi_2521_;
                            let _e1280 = phi_2522_;
                            let _e1282 = phi_2523_;
                            phi_2735_ = _e1272;
                            phi_778_ = _e1274;
                            phi_781_ = _e1276;
                            phi_783_ = _e1278;
                            phi_785_ = _e1280;
                            phi_787_ = _e1282;
                            phi_2524_ = _e495;
                        } else {
                            phi_2735_ = _e481;
                            phi_778_ = type_37();
                            phi_781_ = type_50();
                            phi_783_ = u32();
                            phi_785_ = bool();
                            phi_787_ = u32();
                            phi_2524_ = false;
                        }
                        let _e1284 = phi_2735_;
                        let _e1286 = phi_778_;
                        let _e1288 = phi_781_;
                        let _e1290 = phi_783_;
                        let _e1292 = phi_785_;
                        let _e1294 = phi_787_;
                        let _e1296 = phi_2524_;
                        continue;
                        continuing {
                            phi_2613_ = _e1284;
                            phi_777_ = _e1286;
                            phi_780_ = _e1288;
                            phi_782_ = _e1290;
                            phi_784_ = _e1292;
                            phi_786_ = _e1294;
                            phi_2734_ = _e1284;
                            break if !(_e1296);
                        }
                    }
                    let _e1299 = phi_2734_;
                    if _e1299 {
                        break;
                    }
                    let _e1301 = local_19;
                    if _e137 {
                    } else {
                        break;
                    }
                    global_5.member[_e135] = select(0u, 1u, _e1301.member_1);
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn trace_any_printed_f32_(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
