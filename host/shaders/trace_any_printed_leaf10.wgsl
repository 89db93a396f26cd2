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

struct type_30 {
    member: array<type_22>,
}

struct type_32 {
    member: f32,
    member_1: bool,
}

struct type_34 {
    member: array<vec4<u32>, 2>,
}

struct type_36 {
    member: array<u32, 2>,
    member_1: array<u32, 2>,
    member_2: u32,
    member_3: u32,
}

struct type_38 {
    member: array<type_36>,
}

struct type_41 {
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
    member: type_41,
    member_1: u32,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_1: type_11;
@group(0) @binding(1) 
var<uniform> global_2: type_34;
@group(0) @binding(4) 
var<storage> global_3: type_30;
@group(0) @binding(5) 
var<storage, read_write> global_4: type_4;
@group(0) @binding(2) 
var<storage> global_5: type_38;
@group(0) @binding(3) 
var<storage> global_6: type_45;

fn function_() {
    var local: array<f32, 128>;
    var local_1: array<f32, 128>;
    var local_2: array<f32, 128>;
    var local_3: array<f32, 128>;
    var local_4: array<f32, 128>;
    var local_5: array<f32, 128>;
    var local_6: array<u32, 128>;
    var local_7: array<f32, 128>;
    var local_8: array<f32, 3>;
    var local_9: array<f32, 3>;
    var phi_326_: i32;
    var phi_327_: i32;
    var phi_337_: bool;
    var phi_347_: u32;
    var phi_348_: u32;
    var phi_350_: bool;
    var phi_355_: u32;
    var phi_367_: i32;
    var phi_387_: i32;
    var phi_405_: f32;
    var phi_411_: f32;
    var phi_422_: f32;
    var phi_428_: f32;
    var phi_451_: f32;
    var phi_462_: f32;
    var phi_471_: f32;
    var phi_477_: f32;
    var phi_488_: f32;
    var phi_494_: f32;
    var phi_517_: f32;
    var phi_528_: f32;
    var phi_537_: f32;
    var phi_543_: f32;
    var phi_554_: f32;
    var phi_560_: f32;
    var phi_583_: f32;
    var phi_594_: f32;
    var phi_694_: f32;
    var phi_695_: f32;
    var phi_2807_: bool;
    var phi_768_: type_32;
    var phi_771_: type_49;
    var phi_773_: u32;
    var phi_775_: bool;
    var phi_777_: u32;
    var phi_788_: bool;
    var phi_874_: type_49;
    var phi_875_: bool;
    var phi_876_: u32;
    var phi_1805_: type_36;
    var phi_2637_: type_49;
    var phi_2714_: type_49;
    var phi_2715_: type_49;
    var phi_2716_: u32;
    var phi_2718_: type_49;
    var phi_2719_: u32;
    var phi_2720_: bool;
    var phi_2727_: type_49;
    var phi_2732_: type_49;
    var phi_2733_: bool;
    var phi_895_: type_32;
    var phi_898_: type_7;
    var phi_899_: type_7;
    var phi_921_: type_7;
    var phi_946_: u32;
    var phi_962_: type_43;
    var phi_1668_: vec3<f32>;
    var phi_1669_: vec3<f32>;
    var phi_1700_: bool;
    var phi_1709_: vec3<f32>;
    var phi_1749_: type_21;
    var phi_1751_: type_21;
    var phi_1752_: bool;
    var phi_1756_: type_21;
    var phi_1757_: type_21;
    var phi_1758_: type_21;
    var phi_1759_: bool;
    var phi_1763_: type_21;
    var phi_1764_: bool;
    var phi_1768_: type_21;
    var phi_1769_: bool;
    var phi_1773_: type_21;
    var phi_1784_: type_32;
    var phi_1785_: type_32;
    var phi_896_: type_32;
    var phi_2801_: bool;
    var local_10: type_32;
    var phi_2934_: bool;
    var phi_2735_: type_32;
    var phi_2736_: type_49;
    var phi_2737_: bool;
    var phi_2738_: u32;
    var phi_2933_: bool;
    var phi_2739_: type_32;
    var phi_2740_: type_49;
    var phi_2741_: u32;
    var phi_2742_: bool;
    var phi_2743_: u32;
    var phi_2932_: bool;
    var phi_2744_: type_32;
    var phi_2745_: type_49;
    var phi_2746_: u32;
    var phi_2747_: bool;
    var phi_2748_: u32;
    var phi_2931_: bool;
    var phi_769_: type_32;
    var phi_772_: type_49;
    var phi_774_: u32;
    var phi_776_: bool;
    var phi_778_: u32;
    var phi_2749_: bool;
    var phi_2930_: bool;
    var local_11: type_32;
    var local_12: type_32;

    switch bitcast<i32>(0u) {
        default: {
            let _e72 = global;
            let _e75 = arrayLength((&global_5.member));
            let _e86 = global_2.member[0u][0u];
            let _e90 = global_2.member[0u][1u];
            let _e94 = global_2.member[0u][2u];
            let _e98 = global_2.member[1u][0u];
            let _e102 = global_2.member[1u][1u];
            let _e106 = global_2.member[1u][2u];
            let _e110 = global_2.member[1u][3u];
            let _e113 = global_1.member[0u];
            let _e114 = bitcast<i32>(_e113);
            let _e124 = (_e72.x + (_e72.y * 2097152u));
            let _e125 = (_e124 < arrayLength((&global_3.member)));
            if _e125 {
                let _e126 = (_e124 < arrayLength((&global_4.member)));
                if _e126 {
                    if _e125 {
                    } else {
                        break;
                    }
                    let _e134 = global_3.member[_e124].member_2[0u];
                    let _e136 = (bitcast<u32>(_e134) & 2147483647u);
                    let _e141 = global_3.member[_e124].member_2[1u];
                    let _e143 = (bitcast<u32>(_e141) & 2147483647u);
                    let _e148 = global_3.member[_e124].member_2[2u];
                    let _e150 = (bitcast<u32>(_e148) & 2147483647u);
                    let _e155 = global_3.member[_e124].member[0u];
                    let _e157 = (bitcast<u32>(_e155) & 2147483647u);
                    let _e162 = global_3.member[_e124].member[1u];
                    let _e164 = (bitcast<u32>(_e162) & 2147483647u);
                    let _e169 = global_3.member[_e124].member[2u];
                    let _e171 = (bitcast<u32>(_e169) & 2147483647u);
                    let _e173 = select(_e143, _e136, (_e143 < _e136));
                    let _e175 = select(_e150, _e173, (_e150 < _e173));
                    let _e177 = select(_e157, _e175, (_e157 < _e175));
                    let _e179 = select(_e164, _e177, (_e164 < _e177));
                    let _e181 = select(_e171, _e179, (_e171 < _e179));
                    let _e185 = global_3.member[_e124].member_1;
                    let _e187 = (bitcast<u32>(_e185) & 2147483647u);
                    let _e194 = global_3.member[_e124].member_3;
                    let _e200 = (((select(_e187, _e181, (_e187 < _e181)) < 2139095040u) && ((bitcast<u32>(_e194) & 2147483647u) <= 2139095040u)) && (_e175 > 0u));
                    if _e200 {
                        let _e203 = (bitcast<u32>(bitcast<f32>(_e175)) & 2147483647u);
                        if (_e203 >= 8388608u) {
                            phi_326_ = (bitcast<i32>((_e203 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_326_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e203)), 32u, (_e203 == 0u))));
                        }
                        let _e217 = phi_326_;
                        phi_327_ = _e217;
                    } else {
                        phi_327_ = 0i;
                    }
                    let _e219 = phi_327_;
                    let _e220 = (_e136 == _e175);
                    if _e220 {
                        phi_337_ = true;
                    } else {
                        phi_337_ = (_e143 == _e175);
                    }
                    let _e223 = phi_337_;
                    let _e224 = select(1u, 0u, _e220);
                    if _e223 {
                        let _e225 = (_e224 + 1u);
                        phi_347_ = _e225;
                        phi_348_ = _e225;
                        phi_350_ = select(true, false, (_e225 == 2u));
                    } else {
                        phi_347_ = u32();
                        phi_348_ = 0u;
                        phi_350_ = true;
                    }
                    let _e229 = phi_347_;
                    let _e231 = phi_348_;
                    let _e233 = phi_350_;
                    if _e233 {
                        phi_355_ = (_e231 + 1u);
                    } else {
                        phi_355_ = 0u;
                    }
                    let _e237 = phi_355_;
                    let _e238 = select(_e229, _e231, _e233);
                    let _e239 = select(_e224, select(2u, _e224, _e223), _e233);
                    if (_e114 < -126i) {
                        phi_367_ = -126i;
                    } else {
                        phi_367_ = select(_e114, 127i, (_e114 > 127i));
                    }
                    let _e244 = phi_367_;
                    let _e249 = bitcast<f32>((bitcast<u32>((_e244 + 127i)) << bitcast<u32>(23i)));
                    let _e255 = bitcast<f32>((bitcast<u32>(((_e114 - _e244) + 127i)) << bitcast<u32>(23i)));
                    let _e256 = -(_e219);
                    if (_e256 < -126i) {
                        phi_387_ = -126i;
                    } else {
                        phi_387_ = select(_e256, 127i, (_e256 > 127i));
                    }
                    let _e261 = phi_387_;
                    let _e266 = bitcast<f32>((bitcast<u32>((_e261 + 127i)) << bitcast<u32>(23i)));
                    let _e272 = bitcast<f32>((bitcast<u32>(((_e256 - _e261) + 127i)) << bitcast<u32>(23i)));
                    let _e276 = global_3.member[_e124].member;
                    let _e277 = (_e238 == 0u);
                    if _e277 {
                        phi_405_ = _e276[0];
                    } else {
                        phi_405_ = _e276[1];
                    }
                    let _e281 = phi_405_;
                    let _e282 = (_e238 == 2u);
                    if _e282 {
                        phi_411_ = _e276[2];
                    } else {
                        phi_411_ = _e281;
                    }
                    let _e285 = phi_411_;
                    let _e287 = ((_e285 * _e249) * _e255);
                    let _e288 = global_3.member[_e124].member_2;
                    if _e277 {
                        phi_422_ = _e288[0];
                    } else {
                        phi_422_ = _e288[1];
                    }
                    let _e292 = phi_422_;
                    if _e282 {
                        phi_428_ = _e288[2];
                    } else {
                        phi_428_ = _e292;
                    }
                    let _e295 = phi_428_;
                    let _e297 = ((_e295 * _e266) * _e272);
                    let _e301 = (bitcast<f32>((bitcast<u32>(_e297) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e301 {
                        let _e305 = (bitcast<f32>((bitcast<u32>(_e287) & 2147483647u)) * 0.00000011920929f);
                        phi_451_ = select(0.00000000000011368684f, _e305, (_e305 > 0.00000000000011368684f));
                    } else {
                        phi_451_ = 0f;
                    }
                    let _e309 = phi_451_;
                    let _e310 = (_e287 + _e309);
                    let _e311 = (_e287 - _e309);
                    let _e312 = select(_e297, 0f, _e301);
                    if _e301 {
                        phi_462_ = 38685626000000000000000000f;
                    } else {
                        phi_462_ = (1f / _e297);
                    }
                    let _e315 = phi_462_;
                    let _e316 = (_e237 == 0u);
                    if _e316 {
                        phi_471_ = _e276[0];
                    } else {
                        phi_471_ = _e276[1];
                    }
                    let _e320 = phi_471_;
                    let _e321 = (_e237 == 2u);
                    if _e321 {
                        phi_477_ = _e276[2];
                    } else {
                        phi_477_ = _e320;
                    }
                    let _e324 = phi_477_;
                    let _e326 = ((_e324 * _e249) * _e255);
                    if _e316 {
                        phi_488_ = _e288[0];
                    } else {
                        phi_488_ = _e288[1];
                    }
                    let _e330 = phi_488_;
                    if _e321 {
                        phi_494_ = _e288[2];
                    } else {
                        phi_494_ = _e330;
                    }
                    let _e333 = phi_494_;
                    let _e335 = ((_e333 * _e266) * _e272);
                    let _e339 = (bitcast<f32>((bitcast<u32>(_e335) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e339 {
                        let _e343 = (bitcast<f32>((bitcast<u32>(_e326) & 2147483647u)) * 0.00000011920929f);
                        phi_517_ = select(0.00000000000011368684f, _e343, (_e343 > 0.00000000000011368684f));
                    } else {
                        phi_517_ = 0f;
                    }
                    let _e347 = phi_517_;
                    let _e348 = (_e326 + _e347);
                    let _e349 = (_e326 - _e347);
                    let _e350 = select(_e335, 0f, _e339);
                    if _e339 {
                        phi_528_ = 38685626000000000000000000f;
                    } else {
                        phi_528_ = (1f / _e335);
                    }
                    let _e353 = phi_528_;
                    let _e354 = (_e239 == 0u);
                    if _e354 {
                        phi_537_ = _e276[0];
                    } else {
                        phi_537_ = _e276[1];
                    }
                    let _e358 = phi_537_;
                    let _e359 = (_e239 == 2u);
                    if _e359 {
                        phi_543_ = _e276[2];
                    } else {
                        phi_543_ = _e358;
                    }
                    let _e362 = phi_543_;
                    let _e364 = ((_e362 * _e249) * _e255);
                    if _e354 {
                        phi_554_ = _e288[0];
                    } else {
                        phi_554_ = _e288[1];
                    }
                    let _e368 = phi_554_;
                    if _e359 {
                        phi_560_ = _e288[2];
                    } else {
                        phi_560_ = _e368;
                    }
                    let _e371 = phi_560_;
                    let _e373 = ((_e371 * _e266) * _e272);
                    let _e377 = (bitcast<f32>((bitcast<u32>(_e373) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e377 {
                        let _e381 = (bitcast<f32>((bitcast<u32>(_e364) & 2147483647u)) * 0.00000011920929f);
                        phi_583_ = select(0.00000000000011368684f, _e381, (_e381 > 0.00000000000011368684f));
                    } else {
                        phi_583_ = 0f;
                    }
                    let _e385 = phi_583_;
                    let _e386 = (_e364 + _e385);
                    let _e387 = (_e364 - _e385);
                    let _e388 = select(_e373, 0f, _e377);
                    if _e377 {
                        phi_594_ = 38685626000000000000000000f;
                    } else {
                        phi_594_ = (1f / _e373);
                    }
                    let _e391 = phi_594_;
                    let _e394 = bitcast<f32>((bitcast<u32>(_e287) & 2147483647u));
                    let _e397 = bitcast<f32>((bitcast<u32>(_e326) & 2147483647u));
                    let _e399 = select(_e397, _e394, (_e394 > _e397));
                    let _e402 = bitcast<f32>((bitcast<u32>(_e364) & 2147483647u));
                    let _e405 = (_e114 + _e219);
                    if (_e200 && (select(_e402, _e399, (_e399 > _e402)) <= 1099511600000f)) {
                        let _e408 = (_e405 / 3i);
                        let _e415 = bitcast<f32>((bitcast<u32>((_e408 + 127i)) << bitcast<u32>(23i)));
                        let _e422 = bitcast<f32>((bitcast<u32>(((_e405 - (2i * _e408)) + 127i)) << bitcast<u32>(23i)));
                        let _e423 = (((_e185 * _e415) * _e415) * _e422);
                        let _e425 = select(340282350000000000000000000000000000000f, _e423, (_e423 < 340282350000000000000000000000000000000f));
                        let _e430 = (((_e194 * _e415) * _e415) * _e422);
                        let _e432 = select(340282350000000000000000000000000000000f, _e430, (_e430 < 340282350000000000000000000000000000000f));
                        phi_694_ = select(-340282350000000000000000000000000000000f, _e432, (_e432 > -340282350000000000000000000000000000000f));
                        phi_695_ = select(-340282350000000000000000000000000000000f, _e425, (_e425 > -340282350000000000000000000000000000000f));
                    } else {
                        phi_694_ = 0f;
                        phi_695_ = 1f;
                    }
                    let _e436 = phi_694_;
                    let _e438 = phi_695_;
                    local_6 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                    local_5 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_4 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_3 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_1 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_7 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_9 = array<f32, 3>(bitcast<f32>(_e86), bitcast<f32>(_e90), bitcast<f32>(_e94));
                    let _e443 = (_e238 % 3u);
                    let _e444 = (_e443 < 3u);
                    if _e444 {
                    } else {
                        break;
                    }
                    let _e446 = local_9[_e443];
                    let _e447 = (_e237 % 3u);
                    let _e448 = (_e447 < 3u);
                    if _e448 {
                    } else {
                        break;
                    }
                    let _e450 = local_9[_e447];
                    let _e451 = (_e239 % 3u);
                    let _e452 = (_e451 < 3u);
                    if _e452 {
                    } else {
                        break;
                    }
                    let _e454 = local_9[_e451];
                    local_8 = array<f32, 3>(bitcast<f32>(_e98), bitcast<f32>(_e102), bitcast<f32>(_e106));
                    if _e444 {
                    } else {
                        break;
                    }
                    let _e458 = local_8[_e443];
                    if _e448 {
                    } else {
                        break;
                    }
                    let _e460 = local_8[_e447];
                    if _e452 {
                    } else {
                        break;
                    }
                    let _e462 = local_8[_e451];
                    phi_2807_ = false;
                    phi_768_ = type_32(_e436, false);
                    phi_771_ = type_49(type_41(array<f32, 3>(_e446, _e450, _e454), array<f32, 3>(_e458, _e460, _e462)), select(0u, 2147483648u, (_e75 == 0u)));
                    phi_773_ = ((3u * _e75) + 1u);
                    phi_775_ = (_e438 <= _e436);
                    phi_777_ = 0u;
                    loop {
                        let _e470 = phi_2807_;
                        let _e472 = phi_768_;
                        let _e474 = phi_771_;
                        let _e476 = phi_773_;
                        let _e478 = phi_775_;
                        let _e480 = phi_777_;
                        local_11 = _e472;
                        if _e478 {
                            phi_788_ = true;
                        } else {
                            phi_788_ = (_e480 > 0u);
                        }
                        let _e483 = phi_788_;
                        if _e483 {
                            let _e484 = (_e476 > 0u);
                            if _e484 {
                                if _e478 {
                                    phi_874_ = _e474;
                                    phi_875_ = _e478;
                                    phi_876_ = _e480;
                                } else {
                                    let _e485 = (_e480 - 1u);
                                    let _e486 = (_e485 % 128u);
                                    let _e487 = (_e486 < 128u);
                                    if _e487 {
                                    } else {
                                        phi_2930_ = true;
                                        break;
                                    }
                                    let _e489 = local_6[_e486];
                                    if _e487 {
                                    } else {
                                        phi_2930_ = true;
                                        break;
                                    }
                                    let _e491 = local_5[_e486];
                                    if _e487 {
                                    } else {
                                        phi_2930_ = true;
                                        break;
                                    }
                                    let _e493 = local_4[_e486];
                                    if _e487 {
                                    } else {
                                        phi_2930_ = true;
                                        break;
                                    }
                                    let _e495 = local_3[_e486];
                                    if _e487 {
                                    } else {
                                        phi_2930_ = true;
                                        break;
                                    }
                                    let _e498 = local_2[_e486];
                                    if _e487 {
                                    } else {
                                        phi_2930_ = true;
                                        break;
                                    }
                                    let _e500 = local_1[_e486];
                                    if _e487 {
                                    } else {
                                        phi_2930_ = true;
                                        break;
                                    }
                                    let _e502 = local[_e486];
                                    if _e487 {
                                    } else {
                                        phi_2930_ = true;
                                        break;
                                    }
                                    let _e507 = local_7[_e486];
                                    phi_874_ = type_49(type_41(array<f32, 3>(_e491, _e493, _e495), array<f32, 3>(_e498, _e500, _e502)), _e489);
                                    phi_875_ = (_e507 <= _e472.member);
                                    phi_876_ = _e485;
                                }
                                let _e511 = phi_874_;
                                let _e513 = phi_875_;
                                let _e515 = phi_876_;
                                if _e513 {
                                    if ((_e511.member_1 & 2147483648u) != 0u) {
                                        phi_895_ = _e472;
                                        phi_898_ = type_7(0u, ((_e511.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e868 = phi_895_;
                                            let _e870 = phi_898_;
                                            local_10 = _e868;
                                            local_12 = _e868;
                                            if (_e870.member < _e870.member_1) {
                                                phi_899_ = type_7((_e870.member + 1u), _e870.member_1);
                                                phi_921_ = type_7(1u, _e870.member);
                                            } else {
                                                phi_899_ = _e870;
                                                phi_921_ = type_7(0u, type_7().member_1);
                                            }
                                            let _e883 = phi_899_;
                                            let _e885 = phi_921_;
                                            let _e889 = (bitcast<i32>(_e885.member) != 0i);
                                            if _e889 {
                                                let _e890 = ((_e511.member_1 & 268435455u) + _e885.member_1);
                                                let _e891 = (_e890 < arrayLength((&global_6.member)));
                                                if _e891 {
                                                    if _e891 {
                                                    } else {
                                                        phi_2801_ = true;
                                                        break;
                                                    }
                                                    let _e894 = global_6.member[_e890].member_1;
                                                    phi_946_ = _e894;
                                                } else {
                                                    phi_946_ = 4294967295u;
                                                }
                                                let _e896 = phi_946_;
                                                if _e891 {
                                                    if _e891 {
                                                    } else {
                                                        phi_2801_ = true;
                                                        break;
                                                    }
                                                    let _e898 = global_6.member[_e890];
                                                    phi_962_ = _e898;
                                                } else {
                                                    phi_962_ = type_43(array<u32, 3>(0u, 0u, 0u), 4294967295u);
                                                }
                                                let _e900 = phi_962_;
                                                let _e912 = ((10u * _e238) & 31u);
                                                let _e915 = ((_e900.member[0] >> bitcast<u32>(_e912)) & 1023u);
                                                let _e920 = bitcast<f32>((bitcast<u32>(((_e511.member.member_1[0] - _e511.member.member[0]) * 0.0009775171f)) ^ _e110));
                                                let _e926 = (_e511.member.member[0] + bitcast<f32>((bitcast<u32>((f32(_e915) * _e920)) ^ _e110)));
                                                let _e930 = select(select(_e511.member.member_1[0], _e926, (_e926 < _e511.member.member_1[0])), _e511.member.member_1[0], (_e915 == 1023u));
                                                let _e932 = ((10u * _e237) & 31u);
                                                let _e935 = ((_e900.member[0] >> bitcast<u32>(_e932)) & 1023u);
                                                let _e940 = bitcast<f32>((bitcast<u32>(((_e511.member.member_1[1] - _e511.member.member[1]) * 0.0009775171f)) ^ _e110));
                                                let _e946 = (_e511.member.member[1] + bitcast<f32>((bitcast<u32>((f32(_e935) * _e940)) ^ _e110)));
                                                let _e950 = select(select(_e511.member.member_1[1], _e946, (_e946 < _e511.member.member_1[1])), _e511.member.member_1[1], (_e935 == 1023u));
                                                let _e952 = ((10u * _e239) & 31u);
                                                let _e955 = ((_e900.member[0] >> bitcast<u32>(_e952)) & 1023u);
                                                let _e960 = bitcast<f32>((bitcast<u32>(((_e511.member.member_1[2] - _e511.member.member[2]) * 0.0009775171f)) ^ _e110));
                                                let _e966 = (_e511.member.member[2] + bitcast<f32>((bitcast<u32>((f32(_e955) * _e960)) ^ _e110)));
                                                let _e970 = select(select(_e511.member.member_1[2], _e966, (_e966 < _e511.member.member_1[2])), _e511.member.member_1[2], (_e955 == 1023u));
                                                let _e974 = ((_e900.member[1] >> bitcast<u32>(_e912)) & 1023u);
                                                let _e980 = (_e511.member.member[0] + bitcast<f32>((bitcast<u32>((f32(_e974) * _e920)) ^ _e110)));
                                                let _e984 = select(select(_e511.member.member_1[0], _e980, (_e980 < _e511.member.member_1[0])), _e511.member.member_1[0], (_e974 == 1023u));
                                                let _e987 = ((_e900.member[1] >> bitcast<u32>(_e932)) & 1023u);
                                                let _e993 = (_e511.member.member[1] + bitcast<f32>((bitcast<u32>((f32(_e987) * _e940)) ^ _e110)));
                                                let _e997 = select(select(_e511.member.member_1[1], _e993, (_e993 < _e511.member.member_1[1])), _e511.member.member_1[1], (_e987 == 1023u));
                                                let _e1000 = ((_e900.member[1] >> bitcast<u32>(_e952)) & 1023u);
                                                let _e1006 = (_e511.member.member[2] + bitcast<f32>((bitcast<u32>((f32(_e1000) * _e960)) ^ _e110)));
                                                let _e1010 = select(select(_e511.member.member_1[2], _e1006, (_e1006 < _e511.member.member_1[2])), _e511.member.member_1[2], (_e1000 == 1023u));
                                                let _e1014 = ((_e900.member[2] >> bitcast<u32>(_e912)) & 1023u);
                                                let _e1020 = (_e511.member.member[0] + bitcast<f32>((bitcast<u32>((f32(_e1014) * _e920)) ^ _e110)));
                                                let _e1024 = select(select(_e511.member.member_1[0], _e1020, (_e1020 < _e511.member.member_1[0])), _e511.member.member_1[0], (_e1014 == 1023u));
                                                let _e1027 = ((_e900.member[2] >> bitcast<u32>(_e932)) & 1023u);
                                                let _e1033 = (_e511.member.member[1] + bitcast<f32>((bitcast<u32>((f32(_e1027) * _e940)) ^ _e110)));
                                                let _e1037 = select(select(_e511.member.member_1[1], _e1033, (_e1033 < _e511.member.member_1[1])), _e511.member.member_1[1], (_e1027 == 1023u));
                                                let _e1040 = ((_e900.member[2] >> bitcast<u32>(_e952)) & 1023u);
                                                let _e1046 = (_e511.member.member[2] + bitcast<f32>((bitcast<u32>((f32(_e1040) * _e960)) ^ _e110)));
                                                let _e1050 = select(select(_e511.member.member_1[2], _e1046, (_e1046 < _e511.member.member_1[2])), _e511.member.member_1[2], (_e1040 == 1023u));
                                                let _e1054 = (_e970 - _e364);
                                                let _e1057 = (((_e930 - _e287) * _e388) - (_e1054 * _e312));
                                                let _e1060 = (((_e950 - _e326) * _e388) - (_e1054 * _e350));
                                                let _e1063 = (_e1010 - _e364);
                                                let _e1066 = (((_e984 - _e287) * _e388) - (_e1063 * _e312));
                                                let _e1069 = (((_e997 - _e326) * _e388) - (_e1063 * _e350));
                                                let _e1072 = (_e1050 - _e364);
                                                let _e1075 = (((_e1024 - _e287) * _e388) - (_e1072 * _e312));
                                                let _e1078 = (((_e1037 - _e326) * _e388) - (_e1072 * _e350));
                                                let _e1079 = (_e1075 * _e1069);
                                                let _e1080 = (_e1078 * _e1066);
                                                let _e1081 = (_e1057 * _e1078);
                                                let _e1082 = (_e1060 * _e1075);
                                                let _e1083 = (_e1066 * _e1060);
                                                let _e1084 = (_e1069 * _e1057);
                                                let _e1089 = (((_e1079 >= _e1080) && (_e1081 >= _e1082)) && (_e1083 >= _e1084));
                                                if (_e1089 || (((_e1079 <= _e1080) && (_e1081 <= _e1082)) && (_e1083 <= _e1084))) {
                                                    let _e1096 = select(-1f, 1f, _e1089);
                                                    let _e1098 = ((_e1079 - _e1080) * _e1096);
                                                    let _e1100 = select(0f, _e1098, (_e1098 > 0f));
                                                    let _e1102 = ((_e1081 - _e1082) * _e1096);
                                                    let _e1104 = select(0f, _e1102, (_e1102 > 0f));
                                                    let _e1106 = ((_e1083 - _e1084) * _e1096);
                                                    let _e1108 = select(0f, _e1106, (_e1106 > 0f));
                                                    let _e1110 = ((_e1100 + _e1104) + _e1108);
                                                    if (_e1110 < 0.000000000000000000000000000000000000011754944f) {
                                                        phi_1763_ = type_21();
                                                        phi_1764_ = true;
                                                    } else {
                                                        let _e1113 = select(_e984, _e930, (_e930 < _e984));
                                                        let _e1117 = select(_e984, _e930, (_e930 > _e984));
                                                        let _e1121 = select(_e997, _e950, (_e950 < _e997));
                                                        let _e1125 = select(_e997, _e950, (_e950 > _e997));
                                                        let _e1129 = select(_e1010, _e970, (_e970 < _e1010));
                                                        let _e1133 = select(_e1010, _e970, (_e970 > _e1010));
                                                        let _e1138 = ((select(_e1024, _e1113, (_e1113 < _e1024)) - _e310) * _e315);
                                                        let _e1139 = ((select(_e1024, _e1117, (_e1117 > _e1024)) - _e311) * _e315);
                                                        let _e1142 = ((select(_e1037, _e1121, (_e1121 < _e1037)) - _e348) * _e353);
                                                        let _e1143 = ((select(_e1037, _e1125, (_e1125 > _e1037)) - _e349) * _e353);
                                                        let _e1146 = ((select(_e1050, _e1129, (_e1129 < _e1050)) - _e386) * _e391);
                                                        let _e1147 = ((select(_e1050, _e1133, (_e1133 > _e1050)) - _e387) * _e391);
                                                        let _e1149 = select(_e1147, _e1146, (_e1146 < _e1147));
                                                        let _e1151 = select(_e1147, _e1146, (_e1146 > _e1147));
                                                        let _e1153 = select(_e1139, _e1138, (_e1138 < _e1139));
                                                        let _e1155 = select(_e1143, _e1142, (_e1142 < _e1143));
                                                        let _e1157 = select(_e1155, _e1153, (_e1153 > _e1155));
                                                        let _e1159 = select(_e1149, _e1157, (_e1157 > _e1149));
                                                        let _e1161 = select(_e1139, _e1138, (_e1138 > _e1139));
                                                        let _e1163 = select(_e1143, _e1142, (_e1142 > _e1143));
                                                        let _e1165 = select(_e1163, _e1161, (_e1161 < _e1163));
                                                        let _e1167 = select(_e1151, _e1165, (_e1165 < _e1151));
                                                        let _e1168 = -(_e1149);
                                                        let _e1174 = select(_e438, _e1159, (_e1159 > _e438));
                                                        if (_e1174 > (_e1167 + (select(_e1168, _e1151, (_e1151 > _e1168)) * 0.0000019073523f))) {
                                                            phi_1758_ = type_21();
                                                            phi_1759_ = true;
                                                        } else {
                                                            let _e1176 = (_e1174 > _e868.member);
                                                            if _e1176 {
                                                                phi_1757_ = type_21();
                                                            } else {
                                                                let _e1180 = (_e984 - _e930);
                                                                let _e1181 = (_e997 - _e950);
                                                                let _e1182 = (_e1010 - _e970);
                                                                let _e1183 = vec3<f32>(_e1180, _e1181, _e1182);
                                                                let _e1184 = (_e1024 - _e984);
                                                                let _e1185 = (_e1037 - _e997);
                                                                let _e1186 = (_e1050 - _e1010);
                                                                let _e1187 = vec3<f32>(_e1184, _e1185, _e1186);
                                                                let _e1188 = (_e930 - _e1024);
                                                                let _e1189 = (_e950 - _e1037);
                                                                let _e1190 = (_e970 - _e1050);
                                                                let _e1191 = vec3<f32>(_e1188, _e1189, _e1190);
                                                                let _e1194 = bitcast<f32>((bitcast<u32>(_e1180) & 2147483647u));
                                                                let _e1197 = bitcast<f32>((bitcast<u32>(_e1181) & 2147483647u));
                                                                let _e1199 = select(_e1197, _e1194, (_e1194 > _e1197));
                                                                let _e1202 = bitcast<f32>((bitcast<u32>(_e1182) & 2147483647u));
                                                                let _e1204 = select(_e1202, _e1199, (_e1199 > _e1202));
                                                                let _e1207 = bitcast<f32>((bitcast<u32>(_e1184) & 2147483647u));
                                                                let _e1210 = bitcast<f32>((bitcast<u32>(_e1185) & 2147483647u));
                                                                let _e1212 = select(_e1210, _e1207, (_e1207 > _e1210));
                                                                let _e1215 = bitcast<f32>((bitcast<u32>(_e1186) & 2147483647u));
                                                                let _e1217 = select(_e1215, _e1212, (_e1212 > _e1215));
                                                                let _e1220 = bitcast<f32>((bitcast<u32>(_e1188) & 2147483647u));
                                                                let _e1223 = bitcast<f32>((bitcast<u32>(_e1189) & 2147483647u));
                                                                let _e1225 = select(_e1223, _e1220, (_e1220 > _e1223));
                                                                let _e1228 = bitcast<f32>((bitcast<u32>(_e1190) & 2147483647u));
                                                                let _e1230 = select(_e1228, _e1225, (_e1225 > _e1228));
                                                                let _e1232 = select(_e1217, _e1204, (_e1204 > _e1217));
                                                                let _e1234 = select(_e1230, _e1232, (_e1232 > _e1230));
                                                                if (_e1204 == _e1234) {
                                                                    phi_1668_ = _e1187;
                                                                    phi_1669_ = _e1191;
                                                                } else {
                                                                    let _e1237 = vec3((_e1217 == _e1234));
                                                                    phi_1668_ = select(_e1183, _e1191, _e1237);
                                                                    phi_1669_ = select(_e1187, _e1183, _e1237);
                                                                }
                                                                let _e1241 = phi_1668_;
                                                                let _e1243 = phi_1669_;
                                                                let _e1250 = ((_e1241.y * _e1243.z) - (_e1243.y * _e1241.z));
                                                                let _e1255 = ((_e1241.z * _e1243.x) - (_e1243.z * _e1241.x));
                                                                let _e1258 = ((_e1241.x * _e1243.y) - (_e1243.x * _e1241.y));
                                                                if (_e1100 >= _e1104) {
                                                                    phi_1700_ = select(true, false, (_e1100 >= _e1108));
                                                                } else {
                                                                    phi_1700_ = true;
                                                                }
                                                                let _e1263 = phi_1700_;
                                                                if _e1263 {
                                                                    phi_1709_ = select(vec3<f32>(_e1024, _e1037, _e1050), vec3<f32>(_e984, _e997, _e1010), vec3((_e1104 >= _e1108)));
                                                                } else {
                                                                    phi_1709_ = vec3<f32>(_e930, _e950, _e970);
                                                                }
                                                                let _e1268 = phi_1709_;
                                                                let _e1285 = ((((_e1250 * (_e1268.x - _e287)) + (_e1255 * (_e1268.y - _e326))) + (_e1258 * (_e1268.z - _e364))) / (((_e1250 * _e312) + (_e1255 * _e350)) + (_e1258 * _e388)));
                                                                let _e1287 = select(_e1167, _e1285, (_e1285 < _e1167));
                                                                let _e1289 = select(_e1159, _e1287, (_e1287 > _e1159));
                                                                if (_e1289 >= _e438) {
                                                                    let _e1291 = (_e1289 <= _e868.member);
                                                                    if _e1291 {
                                                                        let _e1292 = (1f / _e1110);
                                                                        phi_1749_ = type_21(_e1289, (_e1104 * _e1292), (_e1108 * _e1292), _e896);
                                                                    } else {
                                                                        phi_1749_ = type_21();
                                                                    }
                                                                    let _e1297 = phi_1749_;
                                                                    phi_1751_ = _e1297;
                                                                    phi_1752_ = select(true, false, _e1291);
                                                                } else {
                                                                    phi_1751_ = type_21();
                                                                    phi_1752_ = true;
                                                                }
                                                                let _e1300 = phi_1751_;
                                                                let _e1302 = phi_1752_;
                                                                if _e1302 {
                                                                    phi_1756_ = type_21(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                } else {
                                                                    phi_1756_ = _e1300;
                                                                }
                                                                let _e1304 = phi_1756_;
                                                                phi_1757_ = _e1304;
                                                            }
                                                            let _e1306 = phi_1757_;
                                                            phi_1758_ = _e1306;
                                                            phi_1759_ = _e1176;
                                                        }
                                                        let _e1308 = phi_1758_;
                                                        let _e1310 = phi_1759_;
                                                        phi_1763_ = _e1308;
                                                        phi_1764_ = _e1310;
                                                    }
                                                    let _e1312 = phi_1763_;
                                                    let _e1314 = phi_1764_;
                                                    phi_1768_ = _e1312;
                                                    phi_1769_ = _e1314;
                                                } else {
                                                    phi_1768_ = type_21();
                                                    phi_1769_ = true;
                                                }
                                                let _e1316 = phi_1768_;
                                                let _e1318 = phi_1769_;
                                                if _e1318 {
                                                    phi_1773_ = type_21(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                } else {
                                                    phi_1773_ = _e1316;
                                                }
                                                let _e1320 = phi_1773_;
                                                if (_e1320.member_3 != 4294967295u) {
                                                    if (_e896 != 4294967295u) {
                                                        phi_1784_ = type_32(_e868.member, true);
                                                    } else {
                                                        phi_1784_ = _e868;
                                                    }
                                                    let _e1328 = phi_1784_;
                                                    phi_1785_ = _e1328;
                                                } else {
                                                    phi_1785_ = _e868;
                                                }
                                                let _e1330 = phi_1785_;
                                                phi_896_ = _e1330;
                                            } else {
                                                phi_896_ = type_32();
                                            }
                                            let _e1332 = phi_896_;
                                            continue;
                                            continuing {
                                                phi_895_ = _e1332;
                                                phi_898_ = _e883;
                                                phi_2801_ = _e470;
                                                break if !(_e889);
                                            }
                                        }
                                        let _e1335 = phi_2801_;
                                        phi_2930_ = _e1335;
                                        if _e1335 {
                                            break;
                                        }
                                        let _e1337 = local_10;
                                        phi_2934_ = _e1335;
                                        let _e1477 = local_12;
                                        phi_2735_ = _e1477;
                                        phi_2736_ = _e511;
                                        phi_2737_ = false;
                                        phi_2738_ = select(_e515, 0u, _e1337.member_1);
                                    } else {
                                        let _e525 = (_e511.member_1 < _e75);
                                        if _e525 {
                                            if _e525 {
                                            } else {
                                                phi_2930_ = true;
                                                break;
                                            }
                                            let _e527 = global_5.member[_e511.member_1];
                                            phi_1805_ = _e527;
                                        } else {
                                            phi_1805_ = type_36(array<u32, 2>(0u, 0u), array<u32, 2>(0u, 0u), 2147483648u, 2147483648u);
                                        }
                                        let _e529 = phi_1805_;
                                        let _e544 = ((10u * _e238) & 31u);
                                        let _e547 = ((_e529.member[0] >> bitcast<u32>(_e544)) & 1023u);
                                        let _e552 = bitcast<f32>((bitcast<u32>(((_e511.member.member_1[0] - _e511.member.member[0]) * 0.0009775171f)) ^ _e110));
                                        let _e558 = (_e511.member.member[0] + bitcast<f32>((bitcast<u32>((f32(_e547) * _e552)) ^ _e110)));
                                        let _e562 = select(select(_e511.member.member_1[0], _e558, (_e558 < _e511.member.member_1[0])), _e511.member.member_1[0], (_e547 == 1023u));
                                        let _e564 = ((10u * _e237) & 31u);
                                        let _e567 = ((_e529.member[0] >> bitcast<u32>(_e564)) & 1023u);
                                        let _e572 = bitcast<f32>((bitcast<u32>(((_e511.member.member_1[1] - _e511.member.member[1]) * 0.0009775171f)) ^ _e110));
                                        let _e578 = (_e511.member.member[1] + bitcast<f32>((bitcast<u32>((f32(_e567) * _e572)) ^ _e110)));
                                        let _e582 = select(select(_e511.member.member_1[1], _e578, (_e578 < _e511.member.member_1[1])), _e511.member.member_1[1], (_e567 == 1023u));
                                        let _e584 = ((10u * _e239) & 31u);
                                        let _e587 = ((_e529.member[0] >> bitcast<u32>(_e584)) & 1023u);
                                        let _e592 = bitcast<f32>((bitcast<u32>(((_e511.member.member_1[2] - _e511.member.member[2]) * 0.0009775171f)) ^ _e110));
                                        let _e598 = (_e511.member.member[2] + bitcast<f32>((bitcast<u32>((f32(_e587) * _e592)) ^ _e110)));
                                        let _e602 = select(select(_e511.member.member_1[2], _e598, (_e598 < _e511.member.member_1[2])), _e511.member.member_1[2], (_e587 == 1023u));
                                        let _e605 = ((_e529.member[1] >> bitcast<u32>(_e544)) & 1023u);
                                        let _e611 = (_e511.member.member[0] + bitcast<f32>((bitcast<u32>((f32(_e605) * _e552)) ^ _e110)));
                                        let _e615 = select(select(_e511.member.member_1[0], _e611, (_e611 < _e511.member.member_1[0])), _e511.member.member_1[0], (_e605 == 1023u));
                                        let _e618 = ((_e529.member[1] >> bitcast<u32>(_e564)) & 1023u);
                                        let _e624 = (_e511.member.member[1] + bitcast<f32>((bitcast<u32>((f32(_e618) * _e572)) ^ _e110)));
                                        let _e628 = select(select(_e511.member.member_1[1], _e624, (_e624 < _e511.member.member_1[1])), _e511.member.member_1[1], (_e618 == 1023u));
                                        let _e631 = ((_e529.member[1] >> bitcast<u32>(_e584)) & 1023u);
                                        let _e637 = (_e511.member.member[2] + bitcast<f32>((bitcast<u32>((f32(_e631) * _e592)) ^ _e110)));
                                        let _e641 = select(select(_e511.member.member_1[2], _e637, (_e637 < _e511.member.member_1[2])), _e511.member.member_1[2], (_e631 == 1023u));
                                        let _e647 = ((_e529.member_1[0] >> bitcast<u32>(_e544)) & 1023u);
                                        let _e653 = (_e511.member.member[0] + bitcast<f32>((bitcast<u32>((f32(_e647) * _e552)) ^ _e110)));
                                        let _e657 = select(select(_e511.member.member_1[0], _e653, (_e653 < _e511.member.member_1[0])), _e511.member.member_1[0], (_e647 == 1023u));
                                        let _e660 = ((_e529.member_1[0] >> bitcast<u32>(_e564)) & 1023u);
                                        let _e666 = (_e511.member.member[1] + bitcast<f32>((bitcast<u32>((f32(_e660) * _e572)) ^ _e110)));
                                        let _e670 = select(select(_e511.member.member_1[1], _e666, (_e666 < _e511.member.member_1[1])), _e511.member.member_1[1], (_e660 == 1023u));
                                        let _e673 = ((_e529.member_1[0] >> bitcast<u32>(_e584)) & 1023u);
                                        let _e679 = (_e511.member.member[2] + bitcast<f32>((bitcast<u32>((f32(_e673) * _e592)) ^ _e110)));
                                        let _e683 = select(select(_e511.member.member_1[2], _e679, (_e679 < _e511.member.member_1[2])), _e511.member.member_1[2], (_e673 == 1023u));
                                        let _e686 = ((_e529.member_1[1] >> bitcast<u32>(_e544)) & 1023u);
                                        let _e692 = (_e511.member.member[0] + bitcast<f32>((bitcast<u32>((f32(_e686) * _e552)) ^ _e110)));
                                        let _e696 = select(select(_e511.member.member_1[0], _e692, (_e692 < _e511.member.member_1[0])), _e511.member.member_1[0], (_e686 == 1023u));
                                        let _e699 = ((_e529.member_1[1] >> bitcast<u32>(_e564)) & 1023u);
                                        let _e705 = (_e511.member.member[1] + bitcast<f32>((bitcast<u32>((f32(_e699) * _e572)) ^ _e110)));
                                        let _e709 = select(select(_e511.member.member_1[1], _e705, (_e705 < _e511.member.member_1[1])), _e511.member.member_1[1], (_e699 == 1023u));
                                        let _e712 = ((_e529.member_1[1] >> bitcast<u32>(_e584)) & 1023u);
                                        let _e718 = (_e511.member.member[2] + bitcast<f32>((bitcast<u32>((f32(_e712) * _e592)) ^ _e110)));
                                        let _e722 = select(select(_e511.member.member_1[2], _e718, (_e718 < _e511.member.member_1[2])), _e511.member.member_1[2], (_e712 == 1023u));
                                        let _e727 = type_49(type_41(array<f32, 3>(_e562, _e582, _e602), array<f32, 3>(_e615, _e628, _e641)), _e529.member_2);
                                        let _e732 = type_49(type_41(array<f32, 3>(_e657, _e670, _e683), array<f32, 3>(_e696, _e709, _e722)), _e529.member_3);
                                        let _e738 = ((_e562 - _e310) * _e315);
                                        let _e739 = ((_e657 - _e310) * _e315);
                                        let _e740 = ((_e615 - _e311) * _e315);
                                        let _e741 = ((_e696 - _e311) * _e315);
                                        let _e746 = ((_e582 - _e348) * _e353);
                                        let _e747 = ((_e670 - _e348) * _e353);
                                        let _e748 = ((_e628 - _e349) * _e353);
                                        let _e749 = ((_e709 - _e349) * _e353);
                                        let _e754 = ((_e602 - _e386) * _e391);
                                        let _e755 = ((_e683 - _e386) * _e391);
                                        let _e756 = ((_e641 - _e387) * _e391);
                                        let _e757 = ((_e722 - _e387) * _e391);
                                        let _e759 = select(_e756, _e754, (_e754 < _e756));
                                        let _e761 = select(_e757, _e755, (_e755 < _e757));
                                        let _e763 = select(_e756, _e754, (_e754 > _e756));
                                        let _e765 = select(_e757, _e755, (_e755 > _e757));
                                        let _e767 = select(_e740, _e738, (_e738 < _e740));
                                        let _e769 = select(_e741, _e739, (_e739 < _e741));
                                        let _e771 = select(_e748, _e746, (_e746 < _e748));
                                        let _e773 = select(_e749, _e747, (_e747 < _e749));
                                        let _e775 = select(_e771, _e767, (_e767 > _e771));
                                        let _e777 = select(_e773, _e769, (_e769 > _e773));
                                        let _e779 = select(_e759, _e775, (_e775 > _e759));
                                        let _e781 = select(_e761, _e777, (_e777 > _e761));
                                        let _e783 = select(_e740, _e738, (_e738 > _e740));
                                        let _e785 = select(_e741, _e739, (_e739 > _e741));
                                        let _e787 = select(_e748, _e746, (_e746 > _e748));
                                        let _e789 = select(_e749, _e747, (_e747 > _e749));
                                        let _e791 = select(_e787, _e783, (_e783 < _e787));
                                        let _e793 = select(_e789, _e785, (_e785 < _e789));
                                        let _e798 = -(_e759);
                                        let _e799 = -(_e761);
                                        let _e806 = (select(_e763, _e791, (_e791 < _e763)) + (select(_e798, _e763, (_e763 > _e798)) * 0.0000019073523f));
                                        let _e807 = (select(_e765, _e793, (_e793 < _e765)) + (select(_e799, _e765, (_e765 > _e799)) * 0.0000019073523f));
                                        let _e809 = select(_e438, _e779, (_e779 > _e438));
                                        let _e811 = select(_e438, _e781, (_e781 > _e438));
                                        let _e816 = (_e809 <= select(_e472.member, _e806, (_e806 < _e472.member)));
                                        let _e817 = (_e811 <= select(_e472.member, _e807, (_e807 < _e472.member)));
                                        let _e818 = (_e809 <= _e811);
                                        if _e816 {
                                            if _e817 {
                                                if _e818 {
                                                    phi_2637_ = _e732;
                                                } else {
                                                    phi_2637_ = _e727;
                                                }
                                                let _e820 = phi_2637_;
                                                let _e828 = (_e515 % 128u);
                                                let _e829 = (_e828 < 128u);
                                                if _e829 {
                                                } else {
                                                    phi_2930_ = true;
                                                    break;
                                                }
                                                local_6[_e828] = _e820.member_1;
                                                if _e829 {
                                                } else {
                                                    phi_2930_ = true;
                                                    break;
                                                }
                                                local_5[_e828] = _e820.member.member[0];
                                                if _e829 {
                                                } else {
                                                    phi_2930_ = true;
                                                    break;
                                                }
                                                local_4[_e828] = _e820.member.member[1];
                                                if _e829 {
                                                } else {
                                                    phi_2930_ = true;
                                                    break;
                                                }
                                                local_3[_e828] = _e820.member.member[2];
                                                if _e829 {
                                                } else {
                                                    phi_2930_ = true;
                                                    break;
                                                }
                                                local_2[_e828] = _e820.member.member_1[0];
                                                if _e829 {
                                                } else {
                                                    phi_2930_ = true;
                                                    break;
                                                }
                                                local_1[_e828] = _e820.member.member_1[1];
                                                if _e829 {
                                                } else {
                                                    phi_2930_ = true;
                                                    break;
                                                }
                                                local[_e828] = _e820.member.member_1[2];
                                                if _e829 {
                                                } else {
                                                    phi_2930_ = true;
                                                    break;
                                                }
                                                local_7[_e828] = select(_e811, _e809, (_e809 > _e811));
                                                if _e818 {
                                                    phi_2714_ = _e727;
                                                } else {
                                                    phi_2714_ = _e732;
                                                }
                                                let _e846 = phi_2714_;
                                                phi_2715_ = _e846;
                                                phi_2716_ = (_e515 + 1u);
                                            } else {
                                                phi_2715_ = type_49();
                                                phi_2716_ = u32();
                                            }
                                            let _e848 = phi_2715_;
                                            let _e850 = phi_2716_;
                                            phi_2718_ = _e848;
                                            phi_2719_ = _e850;
                                            phi_2720_ = select(true, false, _e817);
                                        } else {
                                            phi_2718_ = type_49();
                                            phi_2719_ = u32();
                                            phi_2720_ = true;
                                        }
                                        let _e853 = phi_2718_;
                                        let _e855 = phi_2719_;
                                        let _e857 = phi_2720_;
                                        if _e857 {
                                            if _e816 {
                                                phi_2727_ = _e727;
                                            } else {
                                                phi_2727_ = _e732;
                                            }
                                            let _e859 = phi_2727_;
                                            phi_2732_ = _e859;
                                            phi_2733_ = select(_e817, true, _e816);
                                        } else {
                                            phi_2732_ = _e853;
                                            phi_2733_ = _e513;
                                        }
                                        let _e862 = phi_2732_;
                                        let _e864 = phi_2733_;
                                        phi_2934_ = _e470;
                                        phi_2735_ = _e472;
                                        phi_2736_ = _e862;
                                        phi_2737_ = _e864;
                                        phi_2738_ = select(_e855, _e515, _e857);
                                    }
                                    let _e1341 = phi_2934_;
                                    let _e1343 = phi_2735_;
                                    let _e1345 = phi_2736_;
                                    let _e1347 = phi_2737_;
                                    let _e1349 = phi_2738_;
                                    phi_2933_ = _e1341;
                                    phi_2739_ = _e1343;
                                    phi_2740_ = _e1345;
                                    phi_2741_ = (_e476 - 1u);
                                    phi_2742_ = _e1347;
                                    phi_2743_ = _e1349;
                                } else {
                                    phi_2933_ = _e470;
                                    phi_2739_ = _e472;
                                    phi_2740_ = _e511;
                                    phi_2741_ = _e476;
                                    phi_2742_ = _e513;
                                    phi_2743_ = _e515;
                                }
                                let _e1351 = phi_2933_;
                                let _e1353 = phi_2739_;
                                let _e1355 = phi_2740_;
                                let _e1357 = phi_2741_;
                                let _e1359 = phi_2742_;
                                let _e1361 = phi_2743_;
                                phi_2932_ = _e1351;
                                phi_2744_ = _e1353;
                                phi_2745_ = _e1355;
                                phi_2746_ = _e1357;
                                phi_2747_ = _e1359;
                                phi_2748_ = _e1361;
                            } else {
                                phi_2932_ = _e470;
                                phi_2744_ = type_32();
                                phi_2745_ = type_49();
                                phi_2746_ = u32();
                                phi_2747_ = bool();
                                phi_2748_ = u32();
                            }
                            let _e1363 = phi_2932_;
                            let _e1365 = phi_2744_;
                            let _e1367 = phi_2745_;
                            let _e1369 = phi_2746_;
                            let _e1371 = phi_2747_;
                            let _e1373 = phi_2748_;
                            phi_2931_ = _e1363;
                            phi_769_ = _e1365;
                            phi_772_ = _e1367;
                            phi_774_ = _e1369;
                            phi_776_ = _e1371;
                            phi_778_ = _e1373;
                            phi_2749_ = _e484;
                        } else {
                            phi_2931_ = _e470;
                            phi_769_ = type_32();
                            phi_772_ = type_49();
                            phi_774_ = u32();
                            phi_776_ = bool();
                            phi_778_ = u32();
                            phi_2749_ = false;
                        }
                        let _e1375 = phi_2931_;
                        let _e1377 = phi_769_;
                        let _e1379 = phi_772_;
                        let _e1381 = phi_774_;
                        let _e1383 = phi_776_;
                        let _e1385 = phi_778_;
                        let _e1387 = phi_2749_;
                        continue;
                        continuing {
                            phi_2807_ = _e1375;
                            phi_768_ = _e1377;
                            phi_771_ = _e1379;
                            phi_773_ = _e1381;
                            phi_775_ = _e1383;
                            phi_777_ = _e1385;
                            phi_2930_ = _e1375;
                            break if !(_e1387);
                        }
                    }
                    let _e1390 = phi_2930_;
                    if _e1390 {
                        break;
                    }
                    let _e1392 = local_11;
                    if _e126 {
                    } else {
                        break;
                    }
                    global_4.member[_e124] = select(0u, 1u, _e1392.member_1);
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
