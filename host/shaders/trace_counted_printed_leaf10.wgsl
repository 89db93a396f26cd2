struct type_4 {
    member: u32,
    member_1: u32,
}

struct type_8 {
    member: vec4<u32>,
}

struct type_17 {
    member: array<array<u32, 2>>,
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

struct type_28 {
    member: type_21,
    member_1: f32,
}

struct type_31 {
    member: array<type_22>,
}

struct type_33 {
    member: type_28,
    member_1: u32,
    member_2: u32,
}

struct type_35 {
    member: array<vec4<u32>, 2>,
}

struct type_37 {
    member: array<u32, 2>,
    member_1: array<u32, 2>,
    member_2: u32,
    member_3: u32,
}

struct type_39 {
    member: array<type_37>,
}

struct type_42 {
    member: array<f32, 3>,
    member_1: array<f32, 3>,
}

struct type_44 {
    member: array<u32, 3>,
    member_1: u32,
}

struct type_46 {
    member: array<type_44>,
}

struct type_50 {
    member: type_42,
    member_1: u32,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_1: type_8;
@group(0) @binding(1) 
var<uniform> global_2: type_35;
@group(0) @binding(4) 
var<storage> global_3: type_31;
@group(0) @binding(2) 
var<storage> global_4: type_39;
@group(0) @binding(5) 
var<storage, read_write> global_5: type_17;
@group(0) @binding(3) 
var<storage> global_6: type_46;

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
    var phi_328_: i32;
    var phi_329_: i32;
    var phi_339_: bool;
    var phi_349_: u32;
    var phi_350_: u32;
    var phi_352_: bool;
    var phi_357_: u32;
    var phi_369_: i32;
    var phi_389_: i32;
    var phi_407_: f32;
    var phi_413_: f32;
    var phi_424_: f32;
    var phi_430_: f32;
    var phi_453_: f32;
    var phi_464_: f32;
    var phi_473_: f32;
    var phi_479_: f32;
    var phi_490_: f32;
    var phi_496_: f32;
    var phi_519_: f32;
    var phi_530_: f32;
    var phi_539_: f32;
    var phi_545_: f32;
    var phi_556_: f32;
    var phi_562_: f32;
    var phi_585_: f32;
    var phi_596_: f32;
    var phi_696_: f32;
    var phi_697_: f32;
    var phi_2840_: bool;
    var phi_771_: type_33;
    var phi_774_: type_50;
    var phi_776_: u32;
    var phi_778_: bool;
    var phi_780_: u32;
    var phi_791_: bool;
    var phi_877_: type_50;
    var phi_878_: bool;
    var phi_879_: u32;
    var phi_1836_: type_37;
    var phi_2668_: type_50;
    var phi_2745_: type_50;
    var phi_2746_: type_50;
    var phi_2747_: u32;
    var phi_2749_: type_50;
    var phi_2750_: u32;
    var phi_2751_: bool;
    var phi_2758_: type_50;
    var phi_2763_: type_50;
    var phi_2764_: bool;
    var phi_898_: type_33;
    var phi_901_: type_4;
    var phi_902_: type_4;
    var phi_924_: type_4;
    var phi_952_: u32;
    var phi_968_: type_44;
    var phi_1674_: vec3<f32>;
    var phi_1675_: vec3<f32>;
    var phi_1706_: bool;
    var phi_1715_: vec3<f32>;
    var phi_1755_: type_21;
    var phi_1757_: type_21;
    var phi_1758_: bool;
    var phi_1762_: type_21;
    var phi_1763_: type_21;
    var phi_1764_: type_21;
    var phi_1765_: bool;
    var phi_1769_: type_21;
    var phi_1770_: bool;
    var phi_1774_: type_21;
    var phi_1775_: bool;
    var phi_1779_: type_21;
    var phi_1804_: bool;
    var phi_1805_: bool;
    var phi_1812_: type_33;
    var phi_1813_: type_33;
    var phi_1814_: type_33;
    var phi_899_: type_33;
    var phi_2834_: bool;
    var phi_2970_: bool;
    var phi_2766_: type_33;
    var phi_2767_: type_50;
    var phi_2768_: bool;
    var phi_2769_: u32;
    var phi_2969_: bool;
    var phi_2770_: type_33;
    var phi_2771_: type_50;
    var phi_2772_: u32;
    var phi_2773_: bool;
    var phi_2774_: u32;
    var phi_2968_: bool;
    var phi_2775_: type_33;
    var phi_2776_: type_50;
    var phi_2777_: u32;
    var phi_2778_: bool;
    var phi_2779_: u32;
    var phi_2967_: bool;
    var phi_772_: type_33;
    var phi_775_: type_50;
    var phi_777_: u32;
    var phi_779_: bool;
    var phi_781_: u32;
    var phi_2780_: bool;
    var phi_2966_: bool;
    var local_10: type_33;
    var local_11: type_33;
    var local_12: type_33;

    switch bitcast<i32>(0u) {
        default: {
            let _e72 = global;
            let _e75 = arrayLength((&global_4.member));
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
                let _e126 = (_e124 < arrayLength((&global_5.member)));
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
                            phi_328_ = (bitcast<i32>((_e203 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_328_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e203)), 32u, (_e203 == 0u))));
                        }
                        let _e217 = phi_328_;
                        phi_329_ = _e217;
                    } else {
                        phi_329_ = 0i;
                    }
                    let _e219 = phi_329_;
                    let _e220 = (_e136 == _e175);
                    if _e220 {
                        phi_339_ = true;
                    } else {
                        phi_339_ = (_e143 == _e175);
                    }
                    let _e223 = phi_339_;
                    let _e224 = select(1u, 0u, _e220);
                    if _e223 {
                        let _e225 = (_e224 + 1u);
                        phi_349_ = _e225;
                        phi_350_ = _e225;
                        phi_352_ = select(true, false, (_e225 == 2u));
                    } else {
                        phi_349_ = u32();
                        phi_350_ = 0u;
                        phi_352_ = true;
                    }
                    let _e229 = phi_349_;
                    let _e231 = phi_350_;
                    let _e233 = phi_352_;
                    if _e233 {
                        phi_357_ = (_e231 + 1u);
                    } else {
                        phi_357_ = 0u;
                    }
                    let _e237 = phi_357_;
                    let _e238 = select(_e229, _e231, _e233);
                    let _e239 = select(_e224, select(2u, _e224, _e223), _e233);
                    if (_e114 < -126i) {
                        phi_369_ = -126i;
                    } else {
                        phi_369_ = select(_e114, 127i, (_e114 > 127i));
                    }
                    let _e244 = phi_369_;
                    let _e249 = bitcast<f32>((bitcast<u32>((_e244 + 127i)) << bitcast<u32>(23i)));
                    let _e255 = bitcast<f32>((bitcast<u32>(((_e114 - _e244) + 127i)) << bitcast<u32>(23i)));
                    let _e256 = -(_e219);
                    if (_e256 < -126i) {
                        phi_389_ = -126i;
                    } else {
                        phi_389_ = select(_e256, 127i, (_e256 > 127i));
                    }
                    let _e261 = phi_389_;
                    let _e266 = bitcast<f32>((bitcast<u32>((_e261 + 127i)) << bitcast<u32>(23i)));
                    let _e272 = bitcast<f32>((bitcast<u32>(((_e256 - _e261) + 127i)) << bitcast<u32>(23i)));
                    let _e276 = global_3.member[_e124].member;
                    let _e277 = (_e238 == 0u);
                    if _e277 {
                        phi_407_ = _e276[0];
                    } else {
                        phi_407_ = _e276[1];
                    }
                    let _e281 = phi_407_;
                    let _e282 = (_e238 == 2u);
                    if _e282 {
                        phi_413_ = _e276[2];
                    } else {
                        phi_413_ = _e281;
                    }
                    let _e285 = phi_413_;
                    let _e287 = ((_e285 * _e249) * _e255);
                    let _e288 = global_3.member[_e124].member_2;
                    if _e277 {
                        phi_424_ = _e288[0];
                    } else {
                        phi_424_ = _e288[1];
                    }
                    let _e292 = phi_424_;
                    if _e282 {
                        phi_430_ = _e288[2];
                    } else {
                        phi_430_ = _e292;
                    }
                    let _e295 = phi_430_;
                    let _e297 = ((_e295 * _e266) * _e272);
                    let _e301 = (bitcast<f32>((bitcast<u32>(_e297) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e301 {
                        let _e305 = (bitcast<f32>((bitcast<u32>(_e287) & 2147483647u)) * 0.00000011920929f);
                        phi_453_ = select(0.00000000000011368684f, _e305, (_e305 > 0.00000000000011368684f));
                    } else {
                        phi_453_ = 0f;
                    }
                    let _e309 = phi_453_;
                    let _e310 = (_e287 + _e309);
                    let _e311 = (_e287 - _e309);
                    let _e312 = select(_e297, 0f, _e301);
                    if _e301 {
                        phi_464_ = 38685626000000000000000000f;
                    } else {
                        phi_464_ = (1f / _e297);
                    }
                    let _e315 = phi_464_;
                    let _e316 = (_e237 == 0u);
                    if _e316 {
                        phi_473_ = _e276[0];
                    } else {
                        phi_473_ = _e276[1];
                    }
                    let _e320 = phi_473_;
                    let _e321 = (_e237 == 2u);
                    if _e321 {
                        phi_479_ = _e276[2];
                    } else {
                        phi_479_ = _e320;
                    }
                    let _e324 = phi_479_;
                    let _e326 = ((_e324 * _e249) * _e255);
                    if _e316 {
                        phi_490_ = _e288[0];
                    } else {
                        phi_490_ = _e288[1];
                    }
                    let _e330 = phi_490_;
                    if _e321 {
                        phi_496_ = _e288[2];
                    } else {
                        phi_496_ = _e330;
                    }
                    let _e333 = phi_496_;
                    let _e335 = ((_e333 * _e266) * _e272);
                    let _e339 = (bitcast<f32>((bitcast<u32>(_e335) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e339 {
                        let _e343 = (bitcast<f32>((bitcast<u32>(_e326) & 2147483647u)) * 0.00000011920929f);
                        phi_519_ = select(0.00000000000011368684f, _e343, (_e343 > 0.00000000000011368684f));
                    } else {
                        phi_519_ = 0f;
                    }
                    let _e347 = phi_519_;
                    let _e348 = (_e326 + _e347);
                    let _e349 = (_e326 - _e347);
                    let _e350 = select(_e335, 0f, _e339);
                    if _e339 {
                        phi_530_ = 38685626000000000000000000f;
                    } else {
                        phi_530_ = (1f / _e335);
                    }
                    let _e353 = phi_530_;
                    let _e354 = (_e239 == 0u);
                    if _e354 {
                        phi_539_ = _e276[0];
                    } else {
                        phi_539_ = _e276[1];
                    }
                    let _e358 = phi_539_;
                    let _e359 = (_e239 == 2u);
                    if _e359 {
                        phi_545_ = _e276[2];
                    } else {
                        phi_545_ = _e358;
                    }
                    let _e362 = phi_545_;
                    let _e364 = ((_e362 * _e249) * _e255);
                    if _e354 {
                        phi_556_ = _e288[0];
                    } else {
                        phi_556_ = _e288[1];
                    }
                    let _e368 = phi_556_;
                    if _e359 {
                        phi_562_ = _e288[2];
                    } else {
                        phi_562_ = _e368;
                    }
                    let _e371 = phi_562_;
                    let _e373 = ((_e371 * _e266) * _e272);
                    let _e377 = (bitcast<f32>((bitcast<u32>(_e373) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e377 {
                        let _e381 = (bitcast<f32>((bitcast<u32>(_e364) & 2147483647u)) * 0.00000011920929f);
                        phi_585_ = select(0.00000000000011368684f, _e381, (_e381 > 0.00000000000011368684f));
                    } else {
                        phi_585_ = 0f;
                    }
                    let _e385 = phi_585_;
                    let _e386 = (_e364 + _e385);
                    let _e387 = (_e364 - _e385);
                    let _e388 = select(_e373, 0f, _e377);
                    if _e377 {
                        phi_596_ = 38685626000000000000000000f;
                    } else {
                        phi_596_ = (1f / _e373);
                    }
                    let _e391 = phi_596_;
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
                        phi_696_ = select(-340282350000000000000000000000000000000f, _e432, (_e432 > -340282350000000000000000000000000000000f));
                        phi_697_ = select(-340282350000000000000000000000000000000f, _e425, (_e425 > -340282350000000000000000000000000000000f));
                    } else {
                        phi_696_ = 0f;
                        phi_697_ = 1f;
                    }
                    let _e436 = phi_696_;
                    let _e438 = phi_697_;
                    local_6 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                    local_5 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_4 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_3 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_1 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_7 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_9 = array<f32, 3>(bitcast<f32>(_e86), bitcast<f32>(_e90), bitcast<f32>(_e94));
                    let _e444 = (_e238 % 3u);
                    let _e445 = (_e444 < 3u);
                    if _e445 {
                    } else {
                        break;
                    }
                    let _e447 = local_9[_e444];
                    let _e448 = (_e237 % 3u);
                    let _e449 = (_e448 < 3u);
                    if _e449 {
                    } else {
                        break;
                    }
                    let _e451 = local_9[_e448];
                    let _e452 = (_e239 % 3u);
                    let _e453 = (_e452 < 3u);
                    if _e453 {
                    } else {
                        break;
                    }
                    let _e455 = local_9[_e452];
                    local_8 = array<f32, 3>(bitcast<f32>(_e98), bitcast<f32>(_e102), bitcast<f32>(_e106));
                    if _e445 {
                    } else {
                        break;
                    }
                    let _e459 = local_8[_e444];
                    if _e449 {
                    } else {
                        break;
                    }
                    let _e461 = local_8[_e448];
                    if _e453 {
                    } else {
                        break;
                    }
                    let _e463 = local_8[_e452];
                    phi_2840_ = false;
                    phi_771_ = type_33(type_28(type_21(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e436), 0u, 0u);
                    phi_774_ = type_50(type_42(array<f32, 3>(_e447, _e451, _e455), array<f32, 3>(_e459, _e461, _e463)), select(0u, 2147483648u, (_e75 == 0u)));
                    phi_776_ = ((3u * _e75) + 1u);
                    phi_778_ = (_e438 <= _e436);
                    phi_780_ = 0u;
                    loop {
                        let _e471 = phi_2840_;
                        let _e473 = phi_771_;
                        let _e475 = phi_774_;
                        let _e477 = phi_776_;
                        let _e479 = phi_778_;
                        let _e481 = phi_780_;
                        local_10 = _e473;
                        local_11 = _e473;
                        if _e479 {
                            phi_791_ = true;
                        } else {
                            phi_791_ = (_e481 > 0u);
                        }
                        let _e484 = phi_791_;
                        if _e484 {
                            let _e485 = (_e477 > 0u);
                            if _e485 {
                                if _e479 {
                                    phi_877_ = _e475;
                                    phi_878_ = _e479;
                                    phi_879_ = _e481;
                                } else {
                                    let _e486 = (_e481 - 1u);
                                    let _e487 = (_e486 % 128u);
                                    let _e488 = (_e487 < 128u);
                                    if _e488 {
                                    } else {
                                        phi_2966_ = true;
                                        break;
                                    }
                                    let _e490 = local_6[_e487];
                                    if _e488 {
                                    } else {
                                        phi_2966_ = true;
                                        break;
                                    }
                                    let _e492 = local_5[_e487];
                                    if _e488 {
                                    } else {
                                        phi_2966_ = true;
                                        break;
                                    }
                                    let _e494 = local_4[_e487];
                                    if _e488 {
                                    } else {
                                        phi_2966_ = true;
                                        break;
                                    }
                                    let _e496 = local_3[_e487];
                                    if _e488 {
                                    } else {
                                        phi_2966_ = true;
                                        break;
                                    }
                                    let _e499 = local_2[_e487];
                                    if _e488 {
                                    } else {
                                        phi_2966_ = true;
                                        break;
                                    }
                                    let _e501 = local_1[_e487];
                                    if _e488 {
                                    } else {
                                        phi_2966_ = true;
                                        break;
                                    }
                                    let _e503 = local[_e487];
                                    if _e488 {
                                    } else {
                                        phi_2966_ = true;
                                        break;
                                    }
                                    let _e508 = local_7[_e487];
                                    phi_877_ = type_50(type_42(array<f32, 3>(_e492, _e494, _e496), array<f32, 3>(_e499, _e501, _e503)), _e490);
                                    phi_878_ = (_e508 <= _e473.member.member_1);
                                    phi_879_ = _e486;
                                }
                                let _e513 = phi_877_;
                                let _e515 = phi_878_;
                                let _e517 = phi_879_;
                                if _e515 {
                                    if ((_e513.member_1 & 2147483648u) != 0u) {
                                        phi_898_ = _e473;
                                        phi_901_ = type_4(0u, ((_e513.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e877 = phi_898_;
                                            let _e879 = phi_901_;
                                            local_12 = _e877;
                                            if (_e879.member < _e879.member_1) {
                                                phi_902_ = type_4((_e879.member + 1u), _e879.member_1);
                                                phi_924_ = type_4(1u, _e879.member);
                                            } else {
                                                phi_902_ = _e879;
                                                phi_924_ = type_4(0u, type_4().member_1);
                                            }
                                            let _e892 = phi_902_;
                                            let _e894 = phi_924_;
                                            let _e898 = (bitcast<i32>(_e894.member) != 0i);
                                            if _e898 {
                                                let _e904 = type_33(_e877.member, _e877.member_1, (_e877.member_2 + 1u));
                                                let _e905 = ((_e513.member_1 & 268435455u) + _e894.member_1);
                                                let _e906 = (_e905 < arrayLength((&global_6.member)));
                                                if _e906 {
                                                    if _e906 {
                                                    } else {
                                                        phi_2834_ = true;
                                                        break;
                                                    }
                                                    let _e909 = global_6.member[_e905].member_1;
                                                    phi_952_ = _e909;
                                                } else {
                                                    phi_952_ = 4294967295u;
                                                }
                                                let _e911 = phi_952_;
                                                if _e906 {
                                                    if _e906 {
                                                    } else {
                                                        phi_2834_ = true;
                                                        break;
                                                    }
                                                    let _e913 = global_6.member[_e905];
                                                    phi_968_ = _e913;
                                                } else {
                                                    phi_968_ = type_44(array<u32, 3>(0u, 0u, 0u), 4294967295u);
                                                }
                                                let _e915 = phi_968_;
                                                let _e927 = ((10u * _e238) & 31u);
                                                let _e930 = ((_e915.member[0] >> bitcast<u32>(_e927)) & 1023u);
                                                let _e935 = bitcast<f32>((bitcast<u32>(((_e513.member.member_1[0] - _e513.member.member[0]) * 0.0009775171f)) ^ _e110));
                                                let _e941 = (_e513.member.member[0] + bitcast<f32>((bitcast<u32>((f32(_e930) * _e935)) ^ _e110)));
                                                let _e945 = select(select(_e513.member.member_1[0], _e941, (_e941 < _e513.member.member_1[0])), _e513.member.member_1[0], (_e930 == 1023u));
                                                let _e947 = ((10u * _e237) & 31u);
                                                let _e950 = ((_e915.member[0] >> bitcast<u32>(_e947)) & 1023u);
                                                let _e955 = bitcast<f32>((bitcast<u32>(((_e513.member.member_1[1] - _e513.member.member[1]) * 0.0009775171f)) ^ _e110));
                                                let _e961 = (_e513.member.member[1] + bitcast<f32>((bitcast<u32>((f32(_e950) * _e955)) ^ _e110)));
                                                let _e965 = select(select(_e513.member.member_1[1], _e961, (_e961 < _e513.member.member_1[1])), _e513.member.member_1[1], (_e950 == 1023u));
                                                let _e967 = ((10u * _e239) & 31u);
                                                let _e970 = ((_e915.member[0] >> bitcast<u32>(_e967)) & 1023u);
                                                let _e975 = bitcast<f32>((bitcast<u32>(((_e513.member.member_1[2] - _e513.member.member[2]) * 0.0009775171f)) ^ _e110));
                                                let _e981 = (_e513.member.member[2] + bitcast<f32>((bitcast<u32>((f32(_e970) * _e975)) ^ _e110)));
                                                let _e985 = select(select(_e513.member.member_1[2], _e981, (_e981 < _e513.member.member_1[2])), _e513.member.member_1[2], (_e970 == 1023u));
                                                let _e989 = ((_e915.member[1] >> bitcast<u32>(_e927)) & 1023u);
                                                let _e995 = (_e513.member.member[0] + bitcast<f32>((bitcast<u32>((f32(_e989) * _e935)) ^ _e110)));
                                                let _e999 = select(select(_e513.member.member_1[0], _e995, (_e995 < _e513.member.member_1[0])), _e513.member.member_1[0], (_e989 == 1023u));
                                                let _e1002 = ((_e915.member[1] >> bitcast<u32>(_e947)) & 1023u);
                                                let _e1008 = (_e513.member.member[1] + bitcast<f32>((bitcast<u32>((f32(_e1002) * _e955)) ^ _e110)));
                                                let _e1012 = select(select(_e513.member.member_1[1], _e1008, (_e1008 < _e513.member.member_1[1])), _e513.member.member_1[1], (_e1002 == 1023u));
                                                let _e1015 = ((_e915.member[1] >> bitcast<u32>(_e967)) & 1023u);
                                                let _e1021 = (_e513.member.member[2] + bitcast<f32>((bitcast<u32>((f32(_e1015) * _e975)) ^ _e110)));
                                                let _e1025 = select(select(_e513.member.member_1[2], _e1021, (_e1021 < _e513.member.member_1[2])), _e513.member.member_1[2], (_e1015 == 1023u));
                                                let _e1029 = ((_e915.member[2] >> bitcast<u32>(_e927)) & 1023u);
                                                let _e1035 = (_e513.member.member[0] + bitcast<f32>((bitcast<u32>((f32(_e1029) * _e935)) ^ _e110)));
                                                let _e1039 = select(select(_e513.member.member_1[0], _e1035, (_e1035 < _e513.member.member_1[0])), _e513.member.member_1[0], (_e1029 == 1023u));
                                                let _e1042 = ((_e915.member[2] >> bitcast<u32>(_e947)) & 1023u);
                                                let _e1048 = (_e513.member.member[1] + bitcast<f32>((bitcast<u32>((f32(_e1042) * _e955)) ^ _e110)));
                                                let _e1052 = select(select(_e513.member.member_1[1], _e1048, (_e1048 < _e513.member.member_1[1])), _e513.member.member_1[1], (_e1042 == 1023u));
                                                let _e1055 = ((_e915.member[2] >> bitcast<u32>(_e967)) & 1023u);
                                                let _e1061 = (_e513.member.member[2] + bitcast<f32>((bitcast<u32>((f32(_e1055) * _e975)) ^ _e110)));
                                                let _e1065 = select(select(_e513.member.member_1[2], _e1061, (_e1061 < _e513.member.member_1[2])), _e513.member.member_1[2], (_e1055 == 1023u));
                                                let _e1070 = (_e985 - _e364);
                                                let _e1073 = (((_e945 - _e287) * _e388) - (_e1070 * _e312));
                                                let _e1076 = (((_e965 - _e326) * _e388) - (_e1070 * _e350));
                                                let _e1079 = (_e1025 - _e364);
                                                let _e1082 = (((_e999 - _e287) * _e388) - (_e1079 * _e312));
                                                let _e1085 = (((_e1012 - _e326) * _e388) - (_e1079 * _e350));
                                                let _e1088 = (_e1065 - _e364);
                                                let _e1091 = (((_e1039 - _e287) * _e388) - (_e1088 * _e312));
                                                let _e1094 = (((_e1052 - _e326) * _e388) - (_e1088 * _e350));
                                                let _e1095 = (_e1091 * _e1085);
                                                let _e1096 = (_e1094 * _e1082);
                                                let _e1097 = (_e1073 * _e1094);
                                                let _e1098 = (_e1076 * _e1091);
                                                let _e1099 = (_e1082 * _e1076);
                                                let _e1100 = (_e1085 * _e1073);
                                                let _e1105 = (((_e1095 >= _e1096) && (_e1097 >= _e1098)) && (_e1099 >= _e1100));
                                                if (_e1105 || (((_e1095 <= _e1096) && (_e1097 <= _e1098)) && (_e1099 <= _e1100))) {
                                                    let _e1112 = select(-1f, 1f, _e1105);
                                                    let _e1114 = ((_e1095 - _e1096) * _e1112);
                                                    let _e1116 = select(0f, _e1114, (_e1114 > 0f));
                                                    let _e1118 = ((_e1097 - _e1098) * _e1112);
                                                    let _e1120 = select(0f, _e1118, (_e1118 > 0f));
                                                    let _e1122 = ((_e1099 - _e1100) * _e1112);
                                                    let _e1124 = select(0f, _e1122, (_e1122 > 0f));
                                                    let _e1126 = ((_e1116 + _e1120) + _e1124);
                                                    if (_e1126 < 0.000000000000000000000000000000000000011754944f) {
                                                        phi_1769_ = type_21();
                                                        phi_1770_ = true;
                                                    } else {
                                                        let _e1129 = select(_e999, _e945, (_e945 < _e999));
                                                        let _e1133 = select(_e999, _e945, (_e945 > _e999));
                                                        let _e1137 = select(_e1012, _e965, (_e965 < _e1012));
                                                        let _e1141 = select(_e1012, _e965, (_e965 > _e1012));
                                                        let _e1145 = select(_e1025, _e985, (_e985 < _e1025));
                                                        let _e1149 = select(_e1025, _e985, (_e985 > _e1025));
                                                        let _e1154 = ((select(_e1039, _e1129, (_e1129 < _e1039)) - _e310) * _e315);
                                                        let _e1155 = ((select(_e1039, _e1133, (_e1133 > _e1039)) - _e311) * _e315);
                                                        let _e1158 = ((select(_e1052, _e1137, (_e1137 < _e1052)) - _e348) * _e353);
                                                        let _e1159 = ((select(_e1052, _e1141, (_e1141 > _e1052)) - _e349) * _e353);
                                                        let _e1162 = ((select(_e1065, _e1145, (_e1145 < _e1065)) - _e386) * _e391);
                                                        let _e1163 = ((select(_e1065, _e1149, (_e1149 > _e1065)) - _e387) * _e391);
                                                        let _e1165 = select(_e1163, _e1162, (_e1162 < _e1163));
                                                        let _e1167 = select(_e1163, _e1162, (_e1162 > _e1163));
                                                        let _e1169 = select(_e1155, _e1154, (_e1154 < _e1155));
                                                        let _e1171 = select(_e1159, _e1158, (_e1158 < _e1159));
                                                        let _e1173 = select(_e1171, _e1169, (_e1169 > _e1171));
                                                        let _e1175 = select(_e1165, _e1173, (_e1173 > _e1165));
                                                        let _e1177 = select(_e1155, _e1154, (_e1154 > _e1155));
                                                        let _e1179 = select(_e1159, _e1158, (_e1158 > _e1159));
                                                        let _e1181 = select(_e1179, _e1177, (_e1177 < _e1179));
                                                        let _e1183 = select(_e1167, _e1181, (_e1181 < _e1167));
                                                        let _e1184 = -(_e1165);
                                                        let _e1190 = select(_e438, _e1175, (_e1175 > _e438));
                                                        if (_e1190 > (_e1183 + (select(_e1184, _e1167, (_e1167 > _e1184)) * 0.0000019073523f))) {
                                                            phi_1764_ = type_21();
                                                            phi_1765_ = true;
                                                        } else {
                                                            let _e1192 = (_e1190 > _e877.member.member_1);
                                                            if _e1192 {
                                                                phi_1763_ = type_21();
                                                            } else {
                                                                let _e1196 = (_e999 - _e945);
                                                                let _e1197 = (_e1012 - _e965);
                                                                let _e1198 = (_e1025 - _e985);
                                                                let _e1199 = vec3<f32>(_e1196, _e1197, _e1198);
                                                                let _e1200 = (_e1039 - _e999);
                                                                let _e1201 = (_e1052 - _e1012);
                                                                let _e1202 = (_e1065 - _e1025);
                                                                let _e1203 = vec3<f32>(_e1200, _e1201, _e1202);
                                                                let _e1204 = (_e945 - _e1039);
                                                                let _e1205 = (_e965 - _e1052);
                                                                let _e1206 = (_e985 - _e1065);
                                                                let _e1207 = vec3<f32>(_e1204, _e1205, _e1206);
                                                                let _e1210 = bitcast<f32>((bitcast<u32>(_e1196) & 2147483647u));
                                                                let _e1213 = bitcast<f32>((bitcast<u32>(_e1197) & 2147483647u));
                                                                let _e1215 = select(_e1213, _e1210, (_e1210 > _e1213));
                                                                let _e1218 = bitcast<f32>((bitcast<u32>(_e1198) & 2147483647u));
                                                                let _e1220 = select(_e1218, _e1215, (_e1215 > _e1218));
                                                                let _e1223 = bitcast<f32>((bitcast<u32>(_e1200) & 2147483647u));
                                                                let _e1226 = bitcast<f32>((bitcast<u32>(_e1201) & 2147483647u));
                                                                let _e1228 = select(_e1226, _e1223, (_e1223 > _e1226));
                                                                let _e1231 = bitcast<f32>((bitcast<u32>(_e1202) & 2147483647u));
                                                                let _e1233 = select(_e1231, _e1228, (_e1228 > _e1231));
                                                                let _e1236 = bitcast<f32>((bitcast<u32>(_e1204) & 2147483647u));
                                                                let _e1239 = bitcast<f32>((bitcast<u32>(_e1205) & 2147483647u));
                                                                let _e1241 = select(_e1239, _e1236, (_e1236 > _e1239));
                                                                let _e1244 = bitcast<f32>((bitcast<u32>(_e1206) & 2147483647u));
                                                                let _e1246 = select(_e1244, _e1241, (_e1241 > _e1244));
                                                                let _e1248 = select(_e1233, _e1220, (_e1220 > _e1233));
                                                                let _e1250 = select(_e1246, _e1248, (_e1248 > _e1246));
                                                                if (_e1220 == _e1250) {
                                                                    phi_1674_ = _e1203;
                                                                    phi_1675_ = _e1207;
                                                                } else {
                                                                    let _e1253 = vec3((_e1233 == _e1250));
                                                                    phi_1674_ = select(_e1199, _e1207, _e1253);
                                                                    phi_1675_ = select(_e1203, _e1199, _e1253);
                                                                }
                                                                let _e1257 = phi_1674_;
                                                                let _e1259 = phi_1675_;
                                                                let _e1266 = ((_e1257.y * _e1259.z) - (_e1259.y * _e1257.z));
                                                                let _e1271 = ((_e1257.z * _e1259.x) - (_e1259.z * _e1257.x));
                                                                let _e1274 = ((_e1257.x * _e1259.y) - (_e1259.x * _e1257.y));
                                                                if (_e1116 >= _e1120) {
                                                                    phi_1706_ = select(true, false, (_e1116 >= _e1124));
                                                                } else {
                                                                    phi_1706_ = true;
                                                                }
                                                                let _e1279 = phi_1706_;
                                                                if _e1279 {
                                                                    phi_1715_ = select(vec3<f32>(_e1039, _e1052, _e1065), vec3<f32>(_e999, _e1012, _e1025), vec3((_e1120 >= _e1124)));
                                                                } else {
                                                                    phi_1715_ = vec3<f32>(_e945, _e965, _e985);
                                                                }
                                                                let _e1284 = phi_1715_;
                                                                let _e1301 = ((((_e1266 * (_e1284.x - _e287)) + (_e1271 * (_e1284.y - _e326))) + (_e1274 * (_e1284.z - _e364))) / (((_e1266 * _e312) + (_e1271 * _e350)) + (_e1274 * _e388)));
                                                                let _e1303 = select(_e1183, _e1301, (_e1301 < _e1183));
                                                                let _e1305 = select(_e1175, _e1303, (_e1303 > _e1175));
                                                                if (_e1305 >= _e438) {
                                                                    let _e1307 = (_e1305 <= _e877.member.member_1);
                                                                    if _e1307 {
                                                                        let _e1308 = (1f / _e1126);
                                                                        phi_1755_ = type_21(_e1305, (_e1120 * _e1308), (_e1124 * _e1308), _e911);
                                                                    } else {
                                                                        phi_1755_ = type_21();
                                                                    }
                                                                    let _e1313 = phi_1755_;
                                                                    phi_1757_ = _e1313;
                                                                    phi_1758_ = select(true, false, _e1307);
                                                                } else {
                                                                    phi_1757_ = type_21();
                                                                    phi_1758_ = true;
                                                                }
                                                                let _e1316 = phi_1757_;
                                                                let _e1318 = phi_1758_;
                                                                if _e1318 {
                                                                    phi_1762_ = type_21(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                } else {
                                                                    phi_1762_ = _e1316;
                                                                }
                                                                let _e1320 = phi_1762_;
                                                                phi_1763_ = _e1320;
                                                            }
                                                            let _e1322 = phi_1763_;
                                                            phi_1764_ = _e1322;
                                                            phi_1765_ = _e1192;
                                                        }
                                                        let _e1324 = phi_1764_;
                                                        let _e1326 = phi_1765_;
                                                        phi_1769_ = _e1324;
                                                        phi_1770_ = _e1326;
                                                    }
                                                    let _e1328 = phi_1769_;
                                                    let _e1330 = phi_1770_;
                                                    phi_1774_ = _e1328;
                                                    phi_1775_ = _e1330;
                                                } else {
                                                    phi_1774_ = type_21();
                                                    phi_1775_ = true;
                                                }
                                                let _e1332 = phi_1774_;
                                                let _e1334 = phi_1775_;
                                                if _e1334 {
                                                    phi_1779_ = type_21(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                } else {
                                                    phi_1779_ = _e1332;
                                                }
                                                let _e1336 = phi_1779_;
                                                if (_e1336.member_3 != 4294967295u) {
                                                    if (_e911 != 4294967295u) {
                                                        if (_e1336.member < _e877.member.member.member) {
                                                            phi_1805_ = true;
                                                        } else {
                                                            if (_e1336.member == _e877.member.member.member) {
                                                                phi_1804_ = (_e1336.member_3 < _e877.member.member.member_3);
                                                            } else {
                                                                phi_1804_ = false;
                                                            }
                                                            let _e1351 = phi_1804_;
                                                            phi_1805_ = _e1351;
                                                        }
                                                        let _e1353 = phi_1805_;
                                                        if _e1353 {
                                                            phi_1812_ = type_33(type_28(_e1336, _e1336.member), _e904.member_1, _e904.member_2);
                                                        } else {
                                                            phi_1812_ = _e904;
                                                        }
                                                        let _e1360 = phi_1812_;
                                                        phi_1813_ = _e1360;
                                                    } else {
                                                        phi_1813_ = _e904;
                                                    }
                                                    let _e1362 = phi_1813_;
                                                    phi_1814_ = _e1362;
                                                } else {
                                                    phi_1814_ = _e904;
                                                }
                                                let _e1364 = phi_1814_;
                                                phi_899_ = _e1364;
                                            } else {
                                                phi_899_ = type_33();
                                            }
                                            let _e1366 = phi_899_;
                                            continue;
                                            continuing {
                                                phi_898_ = _e1366;
                                                phi_901_ = _e892;
                                                phi_2834_ = _e471;
                                                break if !(_e898);
                                            }
                                        }
                                        let _e1369 = phi_2834_;
                                        phi_2966_ = _e1369;
                                        if _e1369 {
                                            break;
                                        }
                                        phi_2970_ = _e1369;
                                        let _e1515 = local_12;
                                        phi_2766_ = _e1515;
                                        phi_2767_ = _e513;
                                        phi_2768_ = false;
                                        phi_2769_ = _e517;
                                    } else {
                                        let _e533 = (_e513.member_1 < _e75);
                                        if _e533 {
                                            if _e533 {
                                            } else {
                                                phi_2966_ = true;
                                                break;
                                            }
                                            let _e535 = global_4.member[_e513.member_1];
                                            phi_1836_ = _e535;
                                        } else {
                                            phi_1836_ = type_37(array<u32, 2>(0u, 0u), array<u32, 2>(0u, 0u), 2147483648u, 2147483648u);
                                        }
                                        let _e537 = phi_1836_;
                                        let _e552 = ((10u * _e238) & 31u);
                                        let _e555 = ((_e537.member[0] >> bitcast<u32>(_e552)) & 1023u);
                                        let _e560 = bitcast<f32>((bitcast<u32>(((_e513.member.member_1[0] - _e513.member.member[0]) * 0.0009775171f)) ^ _e110));
                                        let _e566 = (_e513.member.member[0] + bitcast<f32>((bitcast<u32>((f32(_e555) * _e560)) ^ _e110)));
                                        let _e570 = select(select(_e513.member.member_1[0], _e566, (_e566 < _e513.member.member_1[0])), _e513.member.member_1[0], (_e555 == 1023u));
                                        let _e572 = ((10u * _e237) & 31u);
                                        let _e575 = ((_e537.member[0] >> bitcast<u32>(_e572)) & 1023u);
                                        let _e580 = bitcast<f32>((bitcast<u32>(((_e513.member.member_1[1] - _e513.member.member[1]) * 0.0009775171f)) ^ _e110));
                                        let _e586 = (_e513.member.member[1] + bitcast<f32>((bitcast<u32>((f32(_e575) * _e580)) ^ _e110)));
                                        let _e590 = select(select(_e513.member.member_1[1], _e586, (_e586 < _e513.member.member_1[1])), _e513.member.member_1[1], (_e575 == 1023u));
                                        let _e592 = ((10u * _e239) & 31u);
                                        let _e595 = ((_e537.member[0] >> bitcast<u32>(_e592)) & 1023u);
                                        let _e600 = bitcast<f32>((bitcast<u32>(((_e513.member.member_1[2] - _e513.member.member[2]) * 0.0009775171f)) ^ _e110));
                                        let _e606 = (_e513.member.member[2] + bitcast<f32>((bitcast<u32>((f32(_e595) * _e600)) ^ _e110)));
                                        let _e610 = select(select(_e513.member.member_1[2], _e606, (_e606 < _e513.member.member_1[2])), _e513.member.member_1[2], (_e595 == 1023u));
                                        let _e613 = ((_e537.member[1] >> bitcast<u32>(_e552)) & 1023u);
                                        let _e619 = (_e513.member.member[0] + bitcast<f32>((bitcast<u32>((f32(_e613) * _e560)) ^ _e110)));
                                        let _e623 = select(select(_e513.member.member_1[0], _e619, (_e619 < _e513.member.member_1[0])), _e513.member.member_1[0], (_e613 == 1023u));
                                        let _e626 = ((_e537.member[1] >> bitcast<u32>(_e572)) & 1023u);
                                        let _e632 = (_e513.member.member[1] + bitcast<f32>((bitcast<u32>((f32(_e626) * _e580)) ^ _e110)));
                                        let _e636 = select(select(_e513.member.member_1[1], _e632, (_e632 < _e513.member.member_1[1])), _e513.member.member_1[1], (_e626 == 1023u));
                                        let _e639 = ((_e537.member[1] >> bitcast<u32>(_e592)) & 1023u);
                                        let _e645 = (_e513.member.member[2] + bitcast<f32>((bitcast<u32>((f32(_e639) * _e600)) ^ _e110)));
                                        let _e649 = select(select(_e513.member.member_1[2], _e645, (_e645 < _e513.member.member_1[2])), _e513.member.member_1[2], (_e639 == 1023u));
                                        let _e655 = ((_e537.member_1[0] >> bitcast<u32>(_e552)) & 1023u);
                                        let _e661 = (_e513.member.member[0] + bitcast<f32>((bitcast<u32>((f32(_e655) * _e560)) ^ _e110)));
                                        let _e665 = select(select(_e513.member.member_1[0], _e661, (_e661 < _e513.member.member_1[0])), _e513.member.member_1[0], (_e655 == 1023u));
                                        let _e668 = ((_e537.member_1[0] >> bitcast<u32>(_e572)) & 1023u);
                                        let _e674 = (_e513.member.member[1] + bitcast<f32>((bitcast<u32>((f32(_e668) * _e580)) ^ _e110)));
                                        let _e678 = select(select(_e513.member.member_1[1], _e674, (_e674 < _e513.member.member_1[1])), _e513.member.member_1[1], (_e668 == 1023u));
                                        let _e681 = ((_e537.member_1[0] >> bitcast<u32>(_e592)) & 1023u);
                                        let _e687 = (_e513.member.member[2] + bitcast<f32>((bitcast<u32>((f32(_e681) * _e600)) ^ _e110)));
                                        let _e691 = select(select(_e513.member.member_1[2], _e687, (_e687 < _e513.member.member_1[2])), _e513.member.member_1[2], (_e681 == 1023u));
                                        let _e694 = ((_e537.member_1[1] >> bitcast<u32>(_e552)) & 1023u);
                                        let _e700 = (_e513.member.member[0] + bitcast<f32>((bitcast<u32>((f32(_e694) * _e560)) ^ _e110)));
                                        let _e704 = select(select(_e513.member.member_1[0], _e700, (_e700 < _e513.member.member_1[0])), _e513.member.member_1[0], (_e694 == 1023u));
                                        let _e707 = ((_e537.member_1[1] >> bitcast<u32>(_e572)) & 1023u);
                                        let _e713 = (_e513.member.member[1] + bitcast<f32>((bitcast<u32>((f32(_e707) * _e580)) ^ _e110)));
                                        let _e717 = select(select(_e513.member.member_1[1], _e713, (_e713 < _e513.member.member_1[1])), _e513.member.member_1[1], (_e707 == 1023u));
                                        let _e720 = ((_e537.member_1[1] >> bitcast<u32>(_e592)) & 1023u);
                                        let _e726 = (_e513.member.member[2] + bitcast<f32>((bitcast<u32>((f32(_e720) * _e600)) ^ _e110)));
                                        let _e730 = select(select(_e513.member.member_1[2], _e726, (_e726 < _e513.member.member_1[2])), _e513.member.member_1[2], (_e720 == 1023u));
                                        let _e735 = type_50(type_42(array<f32, 3>(_e570, _e590, _e610), array<f32, 3>(_e623, _e636, _e649)), _e537.member_2);
                                        let _e740 = type_50(type_42(array<f32, 3>(_e665, _e678, _e691), array<f32, 3>(_e704, _e717, _e730)), _e537.member_3);
                                        let _e747 = ((_e570 - _e310) * _e315);
                                        let _e748 = ((_e665 - _e310) * _e315);
                                        let _e749 = ((_e623 - _e311) * _e315);
                                        let _e750 = ((_e704 - _e311) * _e315);
                                        let _e755 = ((_e590 - _e348) * _e353);
                                        let _e756 = ((_e678 - _e348) * _e353);
                                        let _e757 = ((_e636 - _e349) * _e353);
                                        let _e758 = ((_e717 - _e349) * _e353);
                                        let _e763 = ((_e610 - _e386) * _e391);
                                        let _e764 = ((_e691 - _e386) * _e391);
                                        let _e765 = ((_e649 - _e387) * _e391);
                                        let _e766 = ((_e730 - _e387) * _e391);
                                        let _e768 = select(_e765, _e763, (_e763 < _e765));
                                        let _e770 = select(_e766, _e764, (_e764 < _e766));
                                        let _e772 = select(_e765, _e763, (_e763 > _e765));
                                        let _e774 = select(_e766, _e764, (_e764 > _e766));
                                        let _e776 = select(_e749, _e747, (_e747 < _e749));
                                        let _e778 = select(_e750, _e748, (_e748 < _e750));
                                        let _e780 = select(_e757, _e755, (_e755 < _e757));
                                        let _e782 = select(_e758, _e756, (_e756 < _e758));
                                        let _e784 = select(_e780, _e776, (_e776 > _e780));
                                        let _e786 = select(_e782, _e778, (_e778 > _e782));
                                        let _e788 = select(_e768, _e784, (_e784 > _e768));
                                        let _e790 = select(_e770, _e786, (_e786 > _e770));
                                        let _e792 = select(_e749, _e747, (_e747 > _e749));
                                        let _e794 = select(_e750, _e748, (_e748 > _e750));
                                        let _e796 = select(_e757, _e755, (_e755 > _e757));
                                        let _e798 = select(_e758, _e756, (_e756 > _e758));
                                        let _e800 = select(_e796, _e792, (_e792 < _e796));
                                        let _e802 = select(_e798, _e794, (_e794 < _e798));
                                        let _e807 = -(_e768);
                                        let _e808 = -(_e770);
                                        let _e815 = (select(_e772, _e800, (_e800 < _e772)) + (select(_e807, _e772, (_e772 > _e807)) * 0.0000019073523f));
                                        let _e816 = (select(_e774, _e802, (_e802 < _e774)) + (select(_e808, _e774, (_e774 > _e808)) * 0.0000019073523f));
                                        let _e818 = select(_e438, _e788, (_e788 > _e438));
                                        let _e820 = select(_e438, _e790, (_e790 > _e438));
                                        let _e825 = (_e818 <= select(_e473.member.member_1, _e815, (_e815 < _e473.member.member_1)));
                                        let _e826 = (_e820 <= select(_e473.member.member_1, _e816, (_e816 < _e473.member.member_1)));
                                        let _e827 = (_e818 <= _e820);
                                        if _e825 {
                                            if _e826 {
                                                if _e827 {
                                                    phi_2668_ = _e740;
                                                } else {
                                                    phi_2668_ = _e735;
                                                }
                                                let _e829 = phi_2668_;
                                                let _e837 = (_e517 % 128u);
                                                let _e838 = (_e837 < 128u);
                                                if _e838 {
                                                } else {
                                                    phi_2966_ = true;
                                                    break;
                                                }
                                                local_6[_e837] = _e829.member_1;
                                                if _e838 {
                                                } else {
                                                    phi_2966_ = true;
                                                    break;
                                                }
                                                local_5[_e837] = _e829.member.member[0];
                                                if _e838 {
                                                } else {
                                                    phi_2966_ = true;
                                                    break;
                                                }
                                                local_4[_e837] = _e829.member.member[1];
                                                if _e838 {
                                                } else {
                                                    phi_2966_ = true;
                                                    break;
                                                }
                                                local_3[_e837] = _e829.member.member[2];
                                                if _e838 {
                                                } else {
                                                    phi_2966_ = true;
                                                    break;
                                                }
                                                local_2[_e837] = _e829.member.member_1[0];
                                                if _e838 {
                                                } else {
                                                    phi_2966_ = true;
                                                    break;
                                                }
                                                local_1[_e837] = _e829.member.member_1[1];
                                                if _e838 {
                                                } else {
                                                    phi_2966_ = true;
                                                    break;
                                                }
                                                local[_e837] = _e829.member.member_1[2];
                                                if _e838 {
                                                } else {
                                                    phi_2966_ = true;
                                                    break;
                                                }
                                                local_7[_e837] = select(_e820, _e818, (_e818 > _e820));
                                                if _e827 {
                                                    phi_2745_ = _e735;
                                                } else {
                                                    phi_2745_ = _e740;
                                                }
                                                let _e855 = phi_2745_;
                                                phi_2746_ = _e855;
                                                phi_2747_ = (_e517 + 1u);
                                            } else {
                                                phi_2746_ = type_50();
                                                phi_2747_ = u32();
                                            }
                                            let _e857 = phi_2746_;
                                            let _e859 = phi_2747_;
                                            phi_2749_ = _e857;
                                            phi_2750_ = _e859;
                                            phi_2751_ = select(true, false, _e826);
                                        } else {
                                            phi_2749_ = type_50();
                                            phi_2750_ = u32();
                                            phi_2751_ = true;
                                        }
                                        let _e862 = phi_2749_;
                                        let _e864 = phi_2750_;
                                        let _e866 = phi_2751_;
                                        if _e866 {
                                            if _e825 {
                                                phi_2758_ = _e735;
                                            } else {
                                                phi_2758_ = _e740;
                                            }
                                            let _e868 = phi_2758_;
                                            phi_2763_ = _e868;
                                            phi_2764_ = select(_e826, true, _e825);
                                        } else {
                                            phi_2763_ = _e862;
                                            phi_2764_ = _e515;
                                        }
                                        let _e871 = phi_2763_;
                                        let _e873 = phi_2764_;
                                        phi_2970_ = _e471;
                                        phi_2766_ = type_33(_e473.member, (_e473.member_1 + 1u), _e473.member_2);
                                        phi_2767_ = _e871;
                                        phi_2768_ = _e873;
                                        phi_2769_ = select(_e864, _e517, _e866);
                                    }
                                    let _e1371 = phi_2970_;
                                    let _e1373 = phi_2766_;
                                    let _e1375 = phi_2767_;
                                    let _e1377 = phi_2768_;
                                    let _e1379 = phi_2769_;
                                    phi_2969_ = _e1371;
                                    phi_2770_ = _e1373;
                                    phi_2771_ = _e1375;
                                    phi_2772_ = (_e477 - 1u);
                                    phi_2773_ = _e1377;
                                    phi_2774_ = _e1379;
                                } else {
                                    phi_2969_ = _e471;
                                    phi_2770_ = _e473;
                                    phi_2771_ = _e513;
                                    phi_2772_ = _e477;
                                    phi_2773_ = _e515;
                                    phi_2774_ = _e517;
                                }
                                let _e1381 = phi_2969_;
                                let _e1383 = phi_2770_;
                                let _e1385 = phi_2771_;
                                let _e1387 = phi_2772_;
                                let _e1389 = phi_2773_;
                                let _e1391 = phi_2774_;
                                phi_2968_ = _e1381;
                                phi_2775_ = _e1383;
                                phi_2776_ = _e1385;
                                phi_2777_ = _e1387;
                                phi_2778_ = _e1389;
                                phi_2779_ = _e1391;
                            } else {
                                phi_2968_ = _e471;
                                phi_2775_ = type_33();
                                phi_2776_ = type_50();
                                phi_2777_ = u32();
                                phi_2778_ = bool();
                                phi_2779_ = u32();
                            }
                            let _e1393 = phi_2968_;
                            let _e1395 = phi_2775_;
                            let _e1397 = phi_2776_;
                            let _e1399 = phi_2777_;
                            let _e1401 = phi_2778_;
                            let _e1403 = phi_2779_;
                            phi_2967_ = _e1393;
                            phi_772_ = _e1395;
                            phi_775_ = _e1397;
                            phi_777_ = _e1399;
                            phi_779_ = _e1401;
                            phi_781_ = _e1403;
                            phi_2780_ = _e485;
                        } else {
                            phi_2967_ = _e471;
                            phi_772_ = type_33();
                            phi_775_ = type_50();
                            phi_777_ = u32();
                            phi_779_ = bool();
                            phi_781_ = u32();
                            phi_2780_ = false;
                        }
                        let _e1405 = phi_2967_;
                        let _e1407 = phi_772_;
                        let _e1409 = phi_775_;
                        let _e1411 = phi_777_;
                        let _e1413 = phi_779_;
                        let _e1415 = phi_781_;
                        let _e1417 = phi_2780_;
                        continue;
                        continuing {
                            phi_2840_ = _e1405;
                            phi_771_ = _e1407;
                            phi_774_ = _e1409;
                            phi_776_ = _e1411;
                            phi_778_ = _e1413;
                            phi_780_ = _e1415;
                            phi_2966_ = _e1405;
                            break if !(_e1417);
                        }
                    }
                    let _e1420 = phi_2966_;
                    if _e1420 {
                        break;
                    }
                    let _e1422 = local_10;
                    let _e1425 = local_11;
                    if _e126 {
                    } else {
                        break;
                    }
                    global_5.member[_e124][0u] = _e1422.member_1;
                    global_5.member[_e124][1u] = _e1425.member_2;
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn trace_counted_printed_leaf10_(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
