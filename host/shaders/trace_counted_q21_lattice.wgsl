struct type_4 {
    member: array<u32>,
}

struct type_8 {
    member: u32,
    member_1: u32,
}

struct type_12 {
    member: vec4<u32>,
}

struct type_20 {
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

struct type_32 {
    member: type_24,
    member_1: f32,
}

struct type_36 {
    member: array<type_25>,
}

struct type_38 {
    member: type_32,
    member_1: u32,
    member_2: u32,
}

struct type_40 {
    member: array<vec4<u32>, 2>,
}

struct type_47 {
    member: array<array<u32, 7>>,
}

struct type_53 {
    member: type_28,
    member_1: u32,
}

struct type_56 {
    member: array<vec4<f32>, 3>,
    member_1: type_53,
    member_2: type_53,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_1: type_12;
@group(0) @binding(1) 
var<uniform> global_2: type_40;
@group(0) @binding(4) 
var<storage> global_3: type_36;
@group(0) @binding(2) 
var<storage> global_4: type_47;
@group(0) @binding(3) 
var<storage> global_5: type_4;
@group(0) @binding(5) 
var<storage, read_write> global_6: type_20;

fn function_() {
    var local: array<i32, 3>;
    var local_1: array<i32, 3>;
    var local_2: array<f32, 128>;
    var local_3: array<type_53, 128>;
    var local_4: array<u32, 3>;
    var local_5: array<array<f32, 3>, 3>;
    var local_6: array<f32, 4>;
    var phi_402_: i32;
    var phi_403_: i32;
    var phi_413_: bool;
    var phi_423_: u32;
    var phi_424_: u32;
    var phi_426_: bool;
    var phi_431_: u32;
    var phi_444_: i32;
    var phi_464_: i32;
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
    var phi_614_: f32;
    var phi_620_: f32;
    var phi_631_: f32;
    var phi_637_: f32;
    var phi_660_: f32;
    var phi_671_: f32;
    var phi_771_: f32;
    var phi_772_: f32;
    var phi_4517_: bool;
    var phi_1893_: type_38;
    var phi_1896_: type_53;
    var phi_1898_: u32;
    var phi_1900_: bool;
    var phi_1902_: u32;
    var phi_1913_: bool;
    var phi_1950_: type_53;
    var phi_1951_: bool;
    var phi_1952_: u32;
    var phi_3583_: u32;
    var phi_3589_: u32;
    var phi_3843_: u32;
    var phi_3844_: u32;
    var phi_3854_: u32;
    var phi_3856_: u32;
    var phi_3857_: bool;
    var phi_3877_: u32;
    var phi_3878_: u32;
    var phi_3882_: type_56;
    var phi_4226_: type_53;
    var phi_4259_: type_53;
    var phi_4260_: type_53;
    var phi_4261_: u32;
    var phi_4263_: type_53;
    var phi_4264_: u32;
    var phi_4265_: bool;
    var phi_4274_: type_53;
    var phi_4279_: type_53;
    var phi_4280_: bool;
    var phi_4514_: bool;
    var phi_1971_: type_38;
    var phi_1974_: type_8;
    var phi_1975_: type_8;
    var phi_1997_: type_8;
    var phi_2041_: u32;
    var phi_2047_: u32;
    var phi_2057_: u32;
    var phi_2073_: u32;
    var phi_2110_: u32;
    var phi_2116_: u32;
    var phi_2126_: u32;
    var phi_4499_: bool;
    var phi_2142_: type_8;
    var phi_2143_: type_8;
    var phi_2166_: type_8;
    var phi_2189_: u32;
    var phi_2204_: u32;
    var phi_2207_: type_8;
    var phi_2208_: type_8;
    var phi_2231_: type_8;
    var phi_2297_: u32;
    var phi_2277_: u32;
    var phi_2278_: u32;
    var phi_2301_: f32;
    var phi_4492_: bool;
    var phi_4571_: bool;
    var phi_4570_: bool;
    var phi_2801_: vec3<f32>;
    var phi_2802_: vec3<f32>;
    var phi_2833_: bool;
    var phi_2842_: vec3<f32>;
    var phi_2882_: type_24;
    var phi_2884_: type_24;
    var phi_2885_: bool;
    var phi_2889_: type_24;
    var phi_2890_: type_24;
    var phi_2891_: type_24;
    var phi_2892_: bool;
    var phi_2896_: type_24;
    var phi_2897_: bool;
    var phi_2901_: type_24;
    var phi_2902_: bool;
    var phi_2906_: type_24;
    var phi_2931_: bool;
    var phi_2932_: bool;
    var phi_2939_: type_38;
    var phi_2940_: type_38;
    var phi_2941_: type_38;
    var phi_4573_: bool;
    var phi_1972_: type_38;
    var phi_4572_: bool;
    var phi_4635_: bool;
    var phi_4282_: type_38;
    var phi_4283_: type_53;
    var phi_4284_: bool;
    var phi_4285_: u32;
    var phi_4634_: bool;
    var phi_4286_: type_38;
    var phi_4287_: type_53;
    var phi_4288_: u32;
    var phi_4289_: bool;
    var phi_4290_: u32;
    var phi_4633_: bool;
    var phi_4291_: type_38;
    var phi_4292_: type_53;
    var phi_4293_: u32;
    var phi_4294_: bool;
    var phi_4295_: u32;
    var phi_4632_: bool;
    var phi_1894_: type_38;
    var phi_1897_: type_53;
    var phi_1899_: u32;
    var phi_1901_: bool;
    var phi_1903_: u32;
    var phi_4296_: bool;
    var phi_4631_: bool;
    var local_7: type_38;
    var local_8: type_38;
    var local_9: type_38;

    switch bitcast<i32>(0u) {
        default: {
            let _e86 = global;
            let _e88 = arrayLength((&global_4.member));
            let _e91 = arrayLength((&global_5.member));
            let _e99 = global_2.member[0u][0u];
            let _e103 = global_2.member[0u][1u];
            let _e107 = global_2.member[0u][2u];
            let _e111 = global_2.member[0u][3u];
            let _e115 = global_2.member[1u][0u];
            let _e119 = global_2.member[1u][1u];
            let _e123 = global_2.member[1u][2u];
            let _e126 = global_1.member[0u];
            let _e127 = bitcast<i32>(_e126);
            let _e139 = bitcast<f32>((bitcast<u32>((bitcast<i32>(_e111) + 127i)) << bitcast<u32>(23i)));
            local_1 = array<i32, 3>(bitcast<i32>(_e99), bitcast<i32>(_e103), bitcast<i32>(_e107));
            local = array<i32, 3>(bitcast<i32>(_e115), bitcast<i32>(_e119), bitcast<i32>(_e123));
            let _e145 = (_e86.x + (_e86.y * 2097152u));
            let _e146 = (_e145 < arrayLength((&global_3.member)));
            if _e146 {
                let _e147 = (_e145 < arrayLength((&global_6.member)));
                if _e147 {
                    if _e146 {
                    } else {
                        break;
                    }
                    let _e155 = global_3.member[_e145].member_2[0u];
                    let _e157 = (bitcast<u32>(_e155) & 2147483647u);
                    let _e162 = global_3.member[_e145].member_2[1u];
                    let _e164 = (bitcast<u32>(_e162) & 2147483647u);
                    let _e169 = global_3.member[_e145].member_2[2u];
                    let _e171 = (bitcast<u32>(_e169) & 2147483647u);
                    let _e176 = global_3.member[_e145].member[0u];
                    let _e178 = (bitcast<u32>(_e176) & 2147483647u);
                    let _e183 = global_3.member[_e145].member[1u];
                    let _e185 = (bitcast<u32>(_e183) & 2147483647u);
                    let _e190 = global_3.member[_e145].member[2u];
                    let _e192 = (bitcast<u32>(_e190) & 2147483647u);
                    let _e194 = select(_e164, _e157, (_e164 < _e157));
                    let _e196 = select(_e171, _e194, (_e171 < _e194));
                    let _e198 = select(_e178, _e196, (_e178 < _e196));
                    let _e200 = select(_e185, _e198, (_e185 < _e198));
                    let _e202 = select(_e192, _e200, (_e192 < _e200));
                    let _e206 = global_3.member[_e145].member_1;
                    let _e208 = (bitcast<u32>(_e206) & 2147483647u);
                    let _e215 = global_3.member[_e145].member_3;
                    let _e221 = (((select(_e208, _e202, (_e208 < _e202)) < 2139095040u) && ((bitcast<u32>(_e215) & 2147483647u) <= 2139095040u)) && (_e196 > 0u));
                    if _e221 {
                        let _e224 = (bitcast<u32>(bitcast<f32>(_e196)) & 2147483647u);
                        if (_e224 >= 8388608u) {
                            phi_402_ = (bitcast<i32>((_e224 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_402_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e224)), 32u, (_e224 == 0u))));
                        }
                        let _e238 = phi_402_;
                        phi_403_ = _e238;
                    } else {
                        phi_403_ = 0i;
                    }
                    let _e240 = phi_403_;
                    let _e241 = (_e157 == _e196);
                    if _e241 {
                        phi_413_ = true;
                    } else {
                        phi_413_ = (_e164 == _e196);
                    }
                    let _e244 = phi_413_;
                    let _e245 = select(1u, 0u, _e241);
                    if _e244 {
                        let _e246 = (_e245 + 1u);
                        phi_423_ = _e246;
                        phi_424_ = _e246;
                        phi_426_ = select(true, false, (_e246 == 2u));
                    } else {
                        phi_423_ = u32();
                        phi_424_ = 0u;
                        phi_426_ = true;
                    }
                    let _e250 = phi_423_;
                    let _e252 = phi_424_;
                    let _e254 = phi_426_;
                    if _e254 {
                        phi_431_ = (_e252 + 1u);
                    } else {
                        phi_431_ = 0u;
                    }
                    let _e258 = phi_431_;
                    let _e259 = select(_e250, _e252, _e254);
                    let _e260 = select(_e245, select(2u, _e245, _e244), _e254);
                    if (_e127 < -126i) {
                        phi_444_ = -126i;
                    } else {
                        phi_444_ = select(_e127, 127i, (_e127 > 127i));
                    }
                    let _e265 = phi_444_;
                    let _e270 = bitcast<f32>((bitcast<u32>((_e265 + 127i)) << bitcast<u32>(23i)));
                    let _e276 = bitcast<f32>((bitcast<u32>(((_e127 - _e265) + 127i)) << bitcast<u32>(23i)));
                    let _e277 = -(_e240);
                    if (_e277 < -126i) {
                        phi_464_ = -126i;
                    } else {
                        phi_464_ = select(_e277, 127i, (_e277 > 127i));
                    }
                    let _e282 = phi_464_;
                    let _e287 = bitcast<f32>((bitcast<u32>((_e282 + 127i)) << bitcast<u32>(23i)));
                    let _e293 = bitcast<f32>((bitcast<u32>(((_e277 - _e282) + 127i)) << bitcast<u32>(23i)));
                    let _e297 = global_3.member[_e145].member;
                    let _e298 = (_e259 == 0u);
                    if _e298 {
                        phi_482_ = _e297[0];
                    } else {
                        phi_482_ = _e297[1];
                    }
                    let _e302 = phi_482_;
                    let _e303 = (_e259 == 2u);
                    if _e303 {
                        phi_488_ = _e297[2];
                    } else {
                        phi_488_ = _e302;
                    }
                    let _e306 = phi_488_;
                    let _e308 = ((_e306 * _e270) * _e276);
                    let _e309 = global_3.member[_e145].member_2;
                    if _e298 {
                        phi_499_ = _e309[0];
                    } else {
                        phi_499_ = _e309[1];
                    }
                    let _e313 = phi_499_;
                    if _e303 {
                        phi_505_ = _e309[2];
                    } else {
                        phi_505_ = _e313;
                    }
                    let _e316 = phi_505_;
                    let _e318 = ((_e316 * _e287) * _e293);
                    let _e322 = (bitcast<f32>((bitcast<u32>(_e318) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e322 {
                        let _e326 = (bitcast<f32>((bitcast<u32>(_e308) & 2147483647u)) * 0.00000011920929f);
                        phi_528_ = select(0.00000000000011368684f, _e326, (_e326 > 0.00000000000011368684f));
                    } else {
                        phi_528_ = 0f;
                    }
                    let _e330 = phi_528_;
                    let _e331 = (_e308 + _e330);
                    let _e332 = (_e308 - _e330);
                    let _e333 = select(_e318, 0f, _e322);
                    if _e322 {
                        phi_539_ = 38685626000000000000000000f;
                    } else {
                        phi_539_ = (1f / _e318);
                    }
                    let _e336 = phi_539_;
                    let _e337 = (_e258 == 0u);
                    if _e337 {
                        phi_548_ = _e297[0];
                    } else {
                        phi_548_ = _e297[1];
                    }
                    let _e341 = phi_548_;
                    let _e342 = (_e258 == 2u);
                    if _e342 {
                        phi_554_ = _e297[2];
                    } else {
                        phi_554_ = _e341;
                    }
                    let _e345 = phi_554_;
                    let _e347 = ((_e345 * _e270) * _e276);
                    if _e337 {
                        phi_565_ = _e309[0];
                    } else {
                        phi_565_ = _e309[1];
                    }
                    let _e351 = phi_565_;
                    if _e342 {
                        phi_571_ = _e309[2];
                    } else {
                        phi_571_ = _e351;
                    }
                    let _e354 = phi_571_;
                    let _e356 = ((_e354 * _e287) * _e293);
                    let _e360 = (bitcast<f32>((bitcast<u32>(_e356) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e360 {
                        let _e364 = (bitcast<f32>((bitcast<u32>(_e347) & 2147483647u)) * 0.00000011920929f);
                        phi_594_ = select(0.00000000000011368684f, _e364, (_e364 > 0.00000000000011368684f));
                    } else {
                        phi_594_ = 0f;
                    }
                    let _e368 = phi_594_;
                    let _e369 = (_e347 + _e368);
                    let _e370 = (_e347 - _e368);
                    let _e371 = select(_e356, 0f, _e360);
                    if _e360 {
                        phi_605_ = 38685626000000000000000000f;
                    } else {
                        phi_605_ = (1f / _e356);
                    }
                    let _e374 = phi_605_;
                    let _e375 = (_e260 == 0u);
                    if _e375 {
                        phi_614_ = _e297[0];
                    } else {
                        phi_614_ = _e297[1];
                    }
                    let _e379 = phi_614_;
                    let _e380 = (_e260 == 2u);
                    if _e380 {
                        phi_620_ = _e297[2];
                    } else {
                        phi_620_ = _e379;
                    }
                    let _e383 = phi_620_;
                    let _e385 = ((_e383 * _e270) * _e276);
                    if _e375 {
                        phi_631_ = _e309[0];
                    } else {
                        phi_631_ = _e309[1];
                    }
                    let _e389 = phi_631_;
                    if _e380 {
                        phi_637_ = _e309[2];
                    } else {
                        phi_637_ = _e389;
                    }
                    let _e392 = phi_637_;
                    let _e394 = ((_e392 * _e287) * _e293);
                    let _e398 = (bitcast<f32>((bitcast<u32>(_e394) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e398 {
                        let _e402 = (bitcast<f32>((bitcast<u32>(_e385) & 2147483647u)) * 0.00000011920929f);
                        phi_660_ = select(0.00000000000011368684f, _e402, (_e402 > 0.00000000000011368684f));
                    } else {
                        phi_660_ = 0f;
                    }
                    let _e406 = phi_660_;
                    let _e407 = (_e385 + _e406);
                    let _e408 = (_e385 - _e406);
                    let _e409 = select(_e394, 0f, _e398);
                    if _e398 {
                        phi_671_ = 38685626000000000000000000f;
                    } else {
                        phi_671_ = (1f / _e394);
                    }
                    let _e412 = phi_671_;
                    let _e415 = bitcast<f32>((bitcast<u32>(_e308) & 2147483647u));
                    let _e418 = bitcast<f32>((bitcast<u32>(_e347) & 2147483647u));
                    let _e420 = select(_e418, _e415, (_e415 > _e418));
                    let _e423 = bitcast<f32>((bitcast<u32>(_e385) & 2147483647u));
                    let _e426 = (_e127 + _e240);
                    if (_e221 && (select(_e423, _e420, (_e420 > _e423)) <= 1099511600000f)) {
                        let _e429 = (_e426 / 3i);
                        let _e436 = bitcast<f32>((bitcast<u32>((_e429 + 127i)) << bitcast<u32>(23i)));
                        let _e443 = bitcast<f32>((bitcast<u32>(((_e426 - (2i * _e429)) + 127i)) << bitcast<u32>(23i)));
                        let _e444 = (((_e206 * _e436) * _e436) * _e443);
                        let _e446 = select(340282350000000000000000000000000000000f, _e444, (_e444 < 340282350000000000000000000000000000000f));
                        let _e451 = (((_e215 * _e436) * _e436) * _e443);
                        let _e453 = select(340282350000000000000000000000000000000f, _e451, (_e451 < 340282350000000000000000000000000000000f));
                        phi_771_ = select(-340282350000000000000000000000000000000f, _e453, (_e453 > -340282350000000000000000000000000000000f));
                        phi_772_ = select(-340282350000000000000000000000000000000f, _e446, (_e446 > -340282350000000000000000000000000000000f));
                    } else {
                        phi_771_ = 0f;
                        phi_772_ = 1f;
                    }
                    let _e457 = phi_771_;
                    let _e459 = phi_772_;
                    local_3 = array<type_53, 128>(type_53(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u));
                    local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    let _e464 = (_e259 % 3u);
                    let _e465 = (_e464 < 3u);
                    if _e465 {
                    } else {
                        break;
                    }
                    let _e467 = local_1[_e464];
                    let _e470 = (_e258 % 3u);
                    let _e471 = (_e470 < 3u);
                    if _e471 {
                    } else {
                        break;
                    }
                    let _e473 = local_1[_e470];
                    let _e476 = (_e260 % 3u);
                    let _e477 = (_e476 < 3u);
                    if _e477 {
                    } else {
                        break;
                    }
                    let _e479 = local_1[_e476];
                    if _e465 {
                    } else {
                        break;
                    }
                    let _e484 = local[_e464];
                    if _e471 {
                    } else {
                        break;
                    }
                    let _e488 = local[_e470];
                    if _e477 {
                    } else {
                        break;
                    }
                    let _e492 = local[_e476];
                    phi_4517_ = false;
                    phi_1893_ = type_38(type_32(type_24(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e457), 0u, 0u);
                    phi_1896_ = type_53(type_28(vec4<f32>((f32(_e467) * _e139), (f32(_e473) * _e139), (f32(_e479) * _e139), 0f), vec4<f32>((f32(_e484) * _e139), (f32(_e488) * _e139), (f32(_e492) * _e139), 0f)), select(0u, 2147483648u, (_e88 == 0u)));
                    phi_1898_ = ((3u * _e88) + 1u);
                    phi_1900_ = (_e459 <= _e457);
                    phi_1902_ = 0u;
                    loop {
                        let _e502 = phi_4517_;
                        let _e504 = phi_1893_;
                        let _e506 = phi_1896_;
                        let _e508 = phi_1898_;
                        let _e510 = phi_1900_;
                        let _e512 = phi_1902_;
                        local_7 = _e504;
                        local_8 = _e504;
                        if _e510 {
                            phi_1913_ = true;
                        } else {
                            phi_1913_ = (_e512 > 0u);
                        }
                        let _e515 = phi_1913_;
                        if _e515 {
                            let _e516 = (_e508 > 0u);
                            if _e516 {
                                if _e510 {
                                    phi_1950_ = _e506;
                                    phi_1951_ = _e510;
                                    phi_1952_ = _e512;
                                } else {
                                    let _e517 = (_e512 - 1u);
                                    let _e518 = (_e517 % 128u);
                                    let _e519 = (_e518 < 128u);
                                    if _e519 {
                                    } else {
                                        phi_4631_ = true;
                                        break;
                                    }
                                    let _e521 = local_3[_e518];
                                    if _e519 {
                                    } else {
                                        phi_4631_ = true;
                                        break;
                                    }
                                    let _e529 = local_2[_e518];
                                    phi_1950_ = type_53(type_28(_e521.member.member, _e521.member.member_1), _e521.member_1);
                                    phi_1951_ = (_e529 <= _e504.member.member_1);
                                    phi_1952_ = _e517;
                                }
                                let _e534 = phi_1950_;
                                let _e536 = phi_1951_;
                                let _e538 = phi_1952_;
                                if _e536 {
                                    let _e543 = (_e534.member_1 & 268435455u);
                                    if ((_e534.member_1 & 2147483648u) != 0u) {
                                        phi_4514_ = _e502;
                                        phi_1971_ = _e504;
                                        phi_1974_ = type_8(0u, ((_e534.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e1012 = phi_4514_;
                                            let _e1014 = phi_1971_;
                                            let _e1016 = phi_1974_;
                                            local_9 = _e1014;
                                            if (_e1016.member < _e1016.member_1) {
                                                phi_1975_ = type_8((_e1016.member + 1u), _e1016.member_1);
                                                phi_1997_ = type_8(1u, _e1016.member);
                                            } else {
                                                phi_1975_ = _e1016;
                                                phi_1997_ = type_8(0u, type_8().member_1);
                                            }
                                            let _e1029 = phi_1975_;
                                            let _e1031 = phi_1997_;
                                            let _e1035 = (bitcast<i32>(_e1031.member) != 0i);
                                            if _e1035 {
                                                let _e1041 = type_38(_e1014.member, _e1014.member_1, (_e1014.member_2 + 1u));
                                                let _e1046 = (_e534.member.member_1.x - _e534.member.member.x);
                                                let _e1049 = (_e534.member.member_1.y - _e534.member.member.y);
                                                let _e1052 = (_e534.member.member_1.z - _e534.member.member.z);
                                                let _e1054 = select(_e1049, _e1046, (_e1046 > _e1049));
                                                let _e1056 = select(_e1052, _e1054, (_e1054 > _e1052));
                                                let _e1058 = (_e1056 < (1024f * _e139));
                                                if _e1058 {
                                                    phi_2041_ = 0u;
                                                } else {
                                                    phi_2041_ = select(2u, 1u, (_e1056 < (2097152f * _e139)));
                                                }
                                                let _e1063 = phi_2041_;
                                                switch bitcast<i32>(_e1063) {
                                                    case 0: {
                                                        phi_2047_ = 1u;
                                                        break;
                                                    }
                                                    case 1: {
                                                        phi_2047_ = 2u;
                                                        break;
                                                    }
                                                    case 2: {
                                                        phi_2047_ = 3u;
                                                        break;
                                                    }
                                                    default: {
                                                        phi_2047_ = u32();
                                                        break;
                                                    }
                                                }
                                                let _e1066 = phi_2047_;
                                                switch bitcast<i32>(_e1063) {
                                                    case 0: {
                                                        phi_2057_ = 1u;
                                                        break;
                                                    }
                                                    case 1: {
                                                        phi_2057_ = 2u;
                                                        break;
                                                    }
                                                    case 2: {
                                                        phi_2057_ = 3u;
                                                        break;
                                                    }
                                                    default: {
                                                        phi_2057_ = u32();
                                                        break;
                                                    }
                                                }
                                                let _e1073 = phi_2057_;
                                                let _e1075 = ((_e543 + (_e1031.member_1 * ((3u * _e1066) + 1u))) + (3u * _e1073));
                                                let _e1076 = (_e1075 < _e91);
                                                if _e1076 {
                                                    if _e1076 {
                                                    } else {
                                                        phi_4572_ = true;
                                                        break;
                                                    }
                                                    let _e1078 = global_5.member[_e1075];
                                                    phi_2073_ = _e1078;
                                                } else {
                                                    phi_2073_ = 4294967295u;
                                                }
                                                let _e1080 = phi_2073_;
                                                local_4 = array<u32, 3>(_e259, _e258, _e260);
                                                if _e1058 {
                                                    phi_2110_ = 0u;
                                                } else {
                                                    phi_2110_ = select(2u, 1u, (_e1056 < (2097152f * _e139)));
                                                }
                                                let _e1086 = phi_2110_;
                                                switch bitcast<i32>(_e1086) {
                                                    case 0: {
                                                        phi_2116_ = 1u;
                                                        break;
                                                    }
                                                    case 1: {
                                                        phi_2116_ = 2u;
                                                        break;
                                                    }
                                                    case 2: {
                                                        phi_2116_ = 3u;
                                                        break;
                                                    }
                                                    default: {
                                                        phi_2116_ = u32();
                                                        break;
                                                    }
                                                }
                                                let _e1089 = phi_2116_;
                                                switch bitcast<i32>(_e1086) {
                                                    case 0: {
                                                        phi_2126_ = 1u;
                                                        break;
                                                    }
                                                    case 1: {
                                                        phi_2126_ = 2u;
                                                        break;
                                                    }
                                                    case 2: {
                                                        phi_2126_ = 3u;
                                                        break;
                                                    }
                                                    default: {
                                                        phi_2126_ = u32();
                                                        break;
                                                    }
                                                }
                                                let _e1096 = phi_2126_;
                                                local_6 = array<f32, 4>(_e534.member.member.x, _e534.member.member.y, _e534.member.member.z, _e534.member.member.w);
                                                local_5[0u] = array<f32, 3>(0f, 0f, 0f);
                                                local_5[1u] = array<f32, 3>(0f, 0f, 0f);
                                                local_5[2u] = array<f32, 3>(0f, 0f, 0f);
                                                phi_4499_ = _e1012;
                                                phi_2142_ = type_8(0u, 3u);
                                                loop {
                                                    let _e1110 = phi_4499_;
                                                    let _e1112 = phi_2142_;
                                                    if (_e1112.member < _e1112.member_1) {
                                                        phi_2143_ = type_8((_e1112.member + 1u), _e1112.member_1);
                                                        phi_2166_ = type_8(1u, _e1112.member);
                                                    } else {
                                                        phi_2143_ = _e1112;
                                                        phi_2166_ = type_8(0u, type_8().member_1);
                                                    }
                                                    let _e1125 = phi_2143_;
                                                    let _e1127 = phi_2166_;
                                                    let _e1131 = (bitcast<i32>(_e1127.member) != 0i);
                                                    if _e1131 {
                                                        let _e1133 = ((_e543 + (_e1031.member_1 * ((3u * _e1089) + 1u))) + (_e1127.member_1 * _e1096));
                                                        let _e1134 = (_e1133 < _e91);
                                                        if _e1134 {
                                                            if _e1134 {
                                                            } else {
                                                                phi_4570_ = true;
                                                                break;
                                                            }
                                                            let _e1136 = global_5.member[_e1133];
                                                            phi_2189_ = _e1136;
                                                        } else {
                                                            phi_2189_ = 0u;
                                                        }
                                                        let _e1138 = phi_2189_;
                                                        let _e1139 = (_e1133 + 1u);
                                                        let _e1140 = (_e1139 < _e91);
                                                        if _e1140 {
                                                            if _e1140 {
                                                            } else {
                                                                phi_4570_ = true;
                                                                break;
                                                            }
                                                            let _e1142 = global_5.member[_e1139];
                                                            phi_2204_ = _e1142;
                                                        } else {
                                                            phi_2204_ = 0u;
                                                        }
                                                        let _e1144 = phi_2204_;
                                                        phi_2207_ = type_8(0u, 3u);
                                                        loop {
                                                            let _e1146 = phi_2207_;
                                                            if (_e1146.member < _e1146.member_1) {
                                                                phi_2208_ = type_8((_e1146.member + 1u), _e1146.member_1);
                                                                phi_2231_ = type_8(1u, _e1146.member);
                                                            } else {
                                                                phi_2208_ = _e1146;
                                                                phi_2231_ = type_8(0u, type_8().member_1);
                                                            }
                                                            let _e1159 = phi_2208_;
                                                            let _e1161 = phi_2231_;
                                                            let _e1165 = (bitcast<i32>(_e1161.member) != 0i);
                                                            if _e1165 {
                                                                let _e1166 = (_e1161.member_1 < 3u);
                                                                if _e1166 {
                                                                } else {
                                                                    phi_4492_ = true;
                                                                    break;
                                                                }
                                                                let _e1168 = local_4[_e1161.member_1];
                                                                if (_e1161.member_1 < 4u) {
                                                                } else {
                                                                    phi_4492_ = true;
                                                                    break;
                                                                }
                                                                let _e1171 = local_6[_e1161.member_1];
                                                                switch bitcast<i32>(_e1086) {
                                                                    case 0: {
                                                                        phi_2301_ = (_e1171 + (f32(((_e1138 >> bitcast<u32>(((10u * _e1168) & 31u))) & 1023u)) * _e139));
                                                                        break;
                                                                    }
                                                                    case 1: {
                                                                        if (_e1168 == 0u) {
                                                                            phi_2278_ = _e1138;
                                                                        } else {
                                                                            if (_e1168 == 1u) {
                                                                                phi_2277_ = ((_e1138 >> bitcast<u32>(21i)) | (_e1144 << bitcast<u32>(11i)));
                                                                            } else {
                                                                                phi_2277_ = (_e1144 >> bitcast<u32>(10i));
                                                                            }
                                                                            let _e1192 = phi_2277_;
                                                                            phi_2278_ = _e1192;
                                                                        }
                                                                        let _e1194 = phi_2278_;
                                                                        phi_2301_ = (_e1171 + (f32((_e1194 & 2097151u)) * _e139));
                                                                        break;
                                                                    }
                                                                    case 2: {
                                                                        let _e1173 = (_e1133 + _e1168);
                                                                        let _e1174 = (_e1173 < _e91);
                                                                        if _e1174 {
                                                                            if _e1174 {
                                                                            } else {
                                                                                phi_4492_ = true;
                                                                                break;
                                                                            }
                                                                            let _e1176 = global_5.member[_e1173];
                                                                            phi_2297_ = _e1176;
                                                                        } else {
                                                                            phi_2297_ = 0u;
                                                                        }
                                                                        let _e1178 = phi_2297_;
                                                                        phi_2301_ = (f32(bitcast<i32>(_e1178)) * _e139);
                                                                        break;
                                                                    }
                                                                    default: {
                                                                        phi_2301_ = f32();
                                                                        break;
                                                                    }
                                                                }
                                                                let _e1208 = phi_2301_;
                                                                if (_e1127.member_1 < 3u) {
                                                                } else {
                                                                    phi_4492_ = true;
                                                                    break;
                                                                }
                                                                if _e1166 {
                                                                } else {
                                                                    phi_4492_ = true;
                                                                    break;
                                                                }
                                                                local_5[_e1127.member_1][_e1161.member_1] = _e1208;
                                                            }
                                                            continue;
                                                            continuing {
                                                                phi_2207_ = _e1159;
                                                                phi_4492_ = _e1110;
                                                                break if !(_e1165);
                                                            }
                                                        }
                                                        let _e1214 = phi_4492_;
                                                        phi_4570_ = _e1214;
                                                        if _e1214 {
                                                            break;
                                                        }
                                                        phi_4571_ = _e1214;
                                                    } else {
                                                        phi_4571_ = _e1110;
                                                    }
                                                    let _e1216 = phi_4571_;
                                                    continue;
                                                    continuing {
                                                        phi_4499_ = _e1216;
                                                        phi_2142_ = _e1125;
                                                        phi_4570_ = _e1216;
                                                        break if !(_e1131);
                                                    }
                                                }
                                                let _e1219 = phi_4570_;
                                                phi_4572_ = _e1219;
                                                if _e1219 {
                                                    break;
                                                }
                                                let _e1220 = local_5;
                                                let _e1237 = (_e1220[0][2] - _e385);
                                                let _e1240 = (((_e1220[0][0] - _e308) * _e409) - (_e1237 * _e333));
                                                let _e1243 = (((_e1220[0][1] - _e347) * _e409) - (_e1237 * _e371));
                                                let _e1246 = (_e1220[1][2] - _e385);
                                                let _e1249 = (((_e1220[1][0] - _e308) * _e409) - (_e1246 * _e333));
                                                let _e1252 = (((_e1220[1][1] - _e347) * _e409) - (_e1246 * _e371));
                                                let _e1255 = (_e1220[2][2] - _e385);
                                                let _e1258 = (((_e1220[2][0] - _e308) * _e409) - (_e1255 * _e333));
                                                let _e1261 = (((_e1220[2][1] - _e347) * _e409) - (_e1255 * _e371));
                                                let _e1262 = (_e1258 * _e1252);
                                                let _e1263 = (_e1261 * _e1249);
                                                let _e1264 = (_e1240 * _e1261);
                                                let _e1265 = (_e1243 * _e1258);
                                                let _e1266 = (_e1249 * _e1243);
                                                let _e1267 = (_e1252 * _e1240);
                                                let _e1272 = (((_e1262 >= _e1263) && (_e1264 >= _e1265)) && (_e1266 >= _e1267));
                                                if (_e1272 || (((_e1262 <= _e1263) && (_e1264 <= _e1265)) && (_e1266 <= _e1267))) {
                                                    let _e1279 = select(-1f, 1f, _e1272);
                                                    let _e1281 = ((_e1262 - _e1263) * _e1279);
                                                    let _e1283 = select(0f, _e1281, (_e1281 > 0f));
                                                    let _e1285 = ((_e1264 - _e1265) * _e1279);
                                                    let _e1287 = select(0f, _e1285, (_e1285 > 0f));
                                                    let _e1289 = ((_e1266 - _e1267) * _e1279);
                                                    let _e1291 = select(0f, _e1289, (_e1289 > 0f));
                                                    let _e1293 = ((_e1283 + _e1287) + _e1291);
                                                    if (_e1293 < 0.000000000000000000000000000000000000011754944f) {
                                                        phi_2896_ = type_24();
                                                        phi_2897_ = true;
                                                    } else {
                                                        let _e1296 = select(_e1220[1][0], _e1220[0][0], (_e1220[0][0] < _e1220[1][0]));
                                                        let _e1300 = select(_e1220[1][0], _e1220[0][0], (_e1220[0][0] > _e1220[1][0]));
                                                        let _e1304 = select(_e1220[1][1], _e1220[0][1], (_e1220[0][1] < _e1220[1][1]));
                                                        let _e1308 = select(_e1220[1][1], _e1220[0][1], (_e1220[0][1] > _e1220[1][1]));
                                                        let _e1312 = select(_e1220[1][2], _e1220[0][2], (_e1220[0][2] < _e1220[1][2]));
                                                        let _e1316 = select(_e1220[1][2], _e1220[0][2], (_e1220[0][2] > _e1220[1][2]));
                                                        let _e1321 = ((select(_e1220[2][0], _e1296, (_e1296 < _e1220[2][0])) - _e331) * _e336);
                                                        let _e1322 = ((select(_e1220[2][0], _e1300, (_e1300 > _e1220[2][0])) - _e332) * _e336);
                                                        let _e1325 = ((select(_e1220[2][1], _e1304, (_e1304 < _e1220[2][1])) - _e369) * _e374);
                                                        let _e1326 = ((select(_e1220[2][1], _e1308, (_e1308 > _e1220[2][1])) - _e370) * _e374);
                                                        let _e1329 = ((select(_e1220[2][2], _e1312, (_e1312 < _e1220[2][2])) - _e407) * _e412);
                                                        let _e1330 = ((select(_e1220[2][2], _e1316, (_e1316 > _e1220[2][2])) - _e408) * _e412);
                                                        let _e1332 = select(_e1330, _e1329, (_e1329 < _e1330));
                                                        let _e1334 = select(_e1330, _e1329, (_e1329 > _e1330));
                                                        let _e1336 = select(_e1322, _e1321, (_e1321 < _e1322));
                                                        let _e1338 = select(_e1326, _e1325, (_e1325 < _e1326));
                                                        let _e1340 = select(_e1338, _e1336, (_e1336 > _e1338));
                                                        let _e1342 = select(_e1332, _e1340, (_e1340 > _e1332));
                                                        let _e1344 = select(_e1322, _e1321, (_e1321 > _e1322));
                                                        let _e1346 = select(_e1326, _e1325, (_e1325 > _e1326));
                                                        let _e1348 = select(_e1346, _e1344, (_e1344 < _e1346));
                                                        let _e1350 = select(_e1334, _e1348, (_e1348 < _e1334));
                                                        let _e1351 = -(_e1332);
                                                        let _e1357 = select(_e459, _e1342, (_e1342 > _e459));
                                                        if (_e1357 > (_e1350 + (select(_e1351, _e1334, (_e1334 > _e1351)) * 0.0000019073523f))) {
                                                            phi_2891_ = type_24();
                                                            phi_2892_ = true;
                                                        } else {
                                                            let _e1359 = (_e1357 > _e1014.member.member_1);
                                                            if _e1359 {
                                                                phi_2890_ = type_24();
                                                            } else {
                                                                let _e1363 = (_e1220[1][0] - _e1220[0][0]);
                                                                let _e1364 = (_e1220[1][1] - _e1220[0][1]);
                                                                let _e1365 = (_e1220[1][2] - _e1220[0][2]);
                                                                let _e1366 = vec3<f32>(_e1363, _e1364, _e1365);
                                                                let _e1367 = (_e1220[2][0] - _e1220[1][0]);
                                                                let _e1368 = (_e1220[2][1] - _e1220[1][1]);
                                                                let _e1369 = (_e1220[2][2] - _e1220[1][2]);
                                                                let _e1370 = vec3<f32>(_e1367, _e1368, _e1369);
                                                                let _e1371 = (_e1220[0][0] - _e1220[2][0]);
                                                                let _e1372 = (_e1220[0][1] - _e1220[2][1]);
                                                                let _e1373 = (_e1220[0][2] - _e1220[2][2]);
                                                                let _e1374 = vec3<f32>(_e1371, _e1372, _e1373);
                                                                let _e1377 = bitcast<f32>((bitcast<u32>(_e1363) & 2147483647u));
                                                                let _e1380 = bitcast<f32>((bitcast<u32>(_e1364) & 2147483647u));
                                                                let _e1382 = select(_e1380, _e1377, (_e1377 > _e1380));
                                                                let _e1385 = bitcast<f32>((bitcast<u32>(_e1365) & 2147483647u));
                                                                let _e1387 = select(_e1385, _e1382, (_e1382 > _e1385));
                                                                let _e1390 = bitcast<f32>((bitcast<u32>(_e1367) & 2147483647u));
                                                                let _e1393 = bitcast<f32>((bitcast<u32>(_e1368) & 2147483647u));
                                                                let _e1395 = select(_e1393, _e1390, (_e1390 > _e1393));
                                                                let _e1398 = bitcast<f32>((bitcast<u32>(_e1369) & 2147483647u));
                                                                let _e1400 = select(_e1398, _e1395, (_e1395 > _e1398));
                                                                let _e1403 = bitcast<f32>((bitcast<u32>(_e1371) & 2147483647u));
                                                                let _e1406 = bitcast<f32>((bitcast<u32>(_e1372) & 2147483647u));
                                                                let _e1408 = select(_e1406, _e1403, (_e1403 > _e1406));
                                                                let _e1411 = bitcast<f32>((bitcast<u32>(_e1373) & 2147483647u));
                                                                let _e1413 = select(_e1411, _e1408, (_e1408 > _e1411));
                                                                let _e1415 = select(_e1400, _e1387, (_e1387 > _e1400));
                                                                let _e1417 = select(_e1413, _e1415, (_e1415 > _e1413));
                                                                if (_e1387 == _e1417) {
                                                                    phi_2801_ = _e1370;
                                                                    phi_2802_ = _e1374;
                                                                } else {
                                                                    let _e1420 = vec3((_e1400 == _e1417));
                                                                    phi_2801_ = select(_e1366, _e1374, _e1420);
                                                                    phi_2802_ = select(_e1370, _e1366, _e1420);
                                                                }
                                                                let _e1424 = phi_2801_;
                                                                let _e1426 = phi_2802_;
                                                                let _e1433 = ((_e1424.y * _e1426.z) - (_e1426.y * _e1424.z));
                                                                let _e1438 = ((_e1424.z * _e1426.x) - (_e1426.z * _e1424.x));
                                                                let _e1441 = ((_e1424.x * _e1426.y) - (_e1426.x * _e1424.y));
                                                                if (_e1283 >= _e1287) {
                                                                    phi_2833_ = select(true, false, (_e1283 >= _e1291));
                                                                } else {
                                                                    phi_2833_ = true;
                                                                }
                                                                let _e1446 = phi_2833_;
                                                                if _e1446 {
                                                                    phi_2842_ = select(vec3<f32>(_e1220[2][0], _e1220[2][1], _e1220[2][2]), vec3<f32>(_e1220[1][0], _e1220[1][1], _e1220[1][2]), vec3((_e1287 >= _e1291)));
                                                                } else {
                                                                    phi_2842_ = vec3<f32>(_e1220[0][0], _e1220[0][1], _e1220[0][2]);
                                                                }
                                                                let _e1451 = phi_2842_;
                                                                let _e1468 = ((((_e1433 * (_e1451.x - _e308)) + (_e1438 * (_e1451.y - _e347))) + (_e1441 * (_e1451.z - _e385))) / (((_e1433 * _e333) + (_e1438 * _e371)) + (_e1441 * _e409)));
                                                                let _e1470 = select(_e1350, _e1468, (_e1468 < _e1350));
                                                                let _e1472 = select(_e1342, _e1470, (_e1470 > _e1342));
                                                                if (_e1472 >= _e459) {
                                                                    let _e1474 = (_e1472 <= _e1014.member.member_1);
                                                                    if _e1474 {
                                                                        let _e1475 = (1f / _e1293);
                                                                        phi_2882_ = type_24(_e1472, (_e1287 * _e1475), (_e1291 * _e1475), _e1080);
                                                                    } else {
                                                                        phi_2882_ = type_24();
                                                                    }
                                                                    let _e1480 = phi_2882_;
                                                                    phi_2884_ = _e1480;
                                                                    phi_2885_ = select(true, false, _e1474);
                                                                } else {
                                                                    phi_2884_ = type_24();
                                                                    phi_2885_ = true;
                                                                }
                                                                let _e1483 = phi_2884_;
                                                                let _e1485 = phi_2885_;
                                                                if _e1485 {
                                                                    phi_2889_ = type_24(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                } else {
                                                                    phi_2889_ = _e1483;
                                                                }
                                                                let _e1487 = phi_2889_;
                                                                phi_2890_ = _e1487;
                                                            }
                                                            let _e1489 = phi_2890_;
                                                            phi_2891_ = _e1489;
                                                            phi_2892_ = _e1359;
                                                        }
                                                        let _e1491 = phi_2891_;
                                                        let _e1493 = phi_2892_;
                                                        phi_2896_ = _e1491;
                                                        phi_2897_ = _e1493;
                                                    }
                                                    let _e1495 = phi_2896_;
                                                    let _e1497 = phi_2897_;
                                                    phi_2901_ = _e1495;
                                                    phi_2902_ = _e1497;
                                                } else {
                                                    phi_2901_ = type_24();
                                                    phi_2902_ = true;
                                                }
                                                let _e1499 = phi_2901_;
                                                let _e1501 = phi_2902_;
                                                if _e1501 {
                                                    phi_2906_ = type_24(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                } else {
                                                    phi_2906_ = _e1499;
                                                }
                                                let _e1503 = phi_2906_;
                                                if (_e1503.member_3 != 4294967295u) {
                                                    if (_e1080 != 4294967295u) {
                                                        if (_e1503.member < _e1014.member.member.member) {
                                                            phi_2932_ = true;
                                                        } else {
                                                            if (_e1503.member == _e1014.member.member.member) {
                                                                phi_2931_ = (_e1503.member_3 < _e1014.member.member.member_3);
                                                            } else {
                                                                phi_2931_ = false;
                                                            }
                                                            let _e1518 = phi_2931_;
                                                            phi_2932_ = _e1518;
                                                        }
                                                        let _e1520 = phi_2932_;
                                                        if _e1520 {
                                                            phi_2939_ = type_38(type_32(_e1503, _e1503.member), _e1041.member_1, _e1041.member_2);
                                                        } else {
                                                            phi_2939_ = _e1041;
                                                        }
                                                        let _e1527 = phi_2939_;
                                                        phi_2940_ = _e1527;
                                                    } else {
                                                        phi_2940_ = _e1041;
                                                    }
                                                    let _e1529 = phi_2940_;
                                                    phi_2941_ = _e1529;
                                                } else {
                                                    phi_2941_ = _e1041;
                                                }
                                                let _e1531 = phi_2941_;
                                                phi_4573_ = _e1219;
                                                phi_1972_ = _e1531;
                                            } else {
                                                phi_4573_ = _e1012;
                                                phi_1972_ = type_38();
                                            }
                                            let _e1533 = phi_4573_;
                                            let _e1535 = phi_1972_;
                                            continue;
                                            continuing {
                                                phi_4514_ = _e1533;
                                                phi_1971_ = _e1535;
                                                phi_1974_ = _e1029;
                                                phi_4572_ = _e1533;
                                                break if !(_e1035);
                                            }
                                        }
                                        let _e1538 = phi_4572_;
                                        phi_4631_ = _e1538;
                                        if _e1538 {
                                            break;
                                        }
                                        phi_4635_ = _e1538;
                                        let _e1716 = local_9;
                                        phi_4282_ = _e1716;
                                        phi_4283_ = _e534;
                                        phi_4284_ = false;
                                        phi_4285_ = _e538;
                                    } else {
                                        if (_e534.member_1 >= _e88) {
                                            phi_3882_ = type_56(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), type_53(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u), type_53(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u));
                                        } else {
                                            if (_e534.member_1 < _e88) {
                                            } else {
                                                phi_4631_ = true;
                                                break;
                                            }
                                            let _e558 = ((1u + (_e259 * 2u)) % 7u);
                                            if (_e558 < 7u) {
                                            } else {
                                                phi_4631_ = true;
                                                break;
                                            }
                                            let _e563 = global_4.member[_e534.member_1][_e558];
                                            let _e566 = ((1u + (_e258 * 2u)) % 7u);
                                            if (_e566 < 7u) {
                                            } else {
                                                phi_4631_ = true;
                                                break;
                                            }
                                            let _e571 = global_4.member[_e534.member_1][_e566];
                                            let _e574 = ((1u + (_e260 * 2u)) % 7u);
                                            if (_e574 < 7u) {
                                            } else {
                                                phi_4631_ = true;
                                                break;
                                            }
                                            let _e579 = global_4.member[_e534.member_1][_e574];
                                            let _e582 = (((_e259 + 1u) * 2u) % 7u);
                                            if (_e582 < 7u) {
                                            } else {
                                                phi_4631_ = true;
                                                break;
                                            }
                                            let _e587 = global_4.member[_e534.member_1][_e582];
                                            let _e590 = (((_e258 + 1u) * 2u) % 7u);
                                            if (_e590 < 7u) {
                                            } else {
                                                phi_4631_ = true;
                                                break;
                                            }
                                            let _e595 = global_4.member[_e534.member_1][_e590];
                                            let _e598 = (((_e260 + 1u) * 2u) % 7u);
                                            if (_e598 < 7u) {
                                            } else {
                                                phi_4631_ = true;
                                                break;
                                            }
                                            let _e603 = global_4.member[_e534.member_1][_e598];
                                            let _e626 = (bitcast<f32>((bitcast<u32>((_e534.member.member_1.x - _e534.member.member.x)) & 2139095040u)) * 0.0000009536743f);
                                            let _e627 = (bitcast<f32>((bitcast<u32>((_e534.member.member_1.y - _e534.member.member.y)) & 2139095040u)) * 0.0000009536743f);
                                            let _e628 = (bitcast<f32>((bitcast<u32>((_e534.member.member_1.z - _e534.member.member.z)) & 2139095040u)) * 0.0000009536743f);
                                            let _e630 = select(_e139, _e626, (_e626 > _e139));
                                            let _e632 = select(_e139, _e627, (_e627 > _e139));
                                            let _e634 = select(_e139, _e628, (_e628 > _e139));
                                            let _e659 = bitcast<u32>((f32(bitcast<i32>((_e563 & 2097151u))) * _e630));
                                            let _e664 = (bitcast<i32>((_e563 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e667 = bitcast<f32>((_e659 & bitcast<u32>(_e664)));
                                            let _e668 = bitcast<u32>((f32(bitcast<i32>((_e571 & 2097151u))) * _e632));
                                            let _e673 = (bitcast<i32>((_e571 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e676 = bitcast<f32>((_e668 & bitcast<u32>(_e673)));
                                            let _e677 = bitcast<u32>((f32(bitcast<i32>((_e579 & 2097151u))) * _e634));
                                            let _e682 = (bitcast<i32>((_e579 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e685 = bitcast<f32>((_e677 & bitcast<u32>(_e682)));
                                            let _e689 = bitcast<f32>((_e659 & bitcast<u32>(~(_e664))));
                                            let _e693 = bitcast<f32>((_e668 & bitcast<u32>(~(_e673))));
                                            let _e697 = bitcast<f32>((_e677 & bitcast<u32>(~(_e682))));
                                            let _e698 = bitcast<u32>((f32(bitcast<i32>((_e587 & 2097151u))) * _e630));
                                            let _e703 = (bitcast<i32>((_e587 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e706 = bitcast<f32>((_e698 & bitcast<u32>(_e703)));
                                            let _e707 = bitcast<u32>((f32(bitcast<i32>((_e595 & 2097151u))) * _e632));
                                            let _e712 = (bitcast<i32>((_e595 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e715 = bitcast<f32>((_e707 & bitcast<u32>(_e712)));
                                            let _e716 = bitcast<u32>((f32(bitcast<i32>((_e603 & 2097151u))) * _e634));
                                            let _e721 = (bitcast<i32>((_e603 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e724 = bitcast<f32>((_e716 & bitcast<u32>(_e721)));
                                            let _e728 = bitcast<f32>((_e698 & bitcast<u32>(~(_e703))));
                                            let _e732 = bitcast<f32>((_e707 & bitcast<u32>(~(_e712))));
                                            let _e736 = bitcast<f32>((_e716 & bitcast<u32>(~(_e721))));
                                            let _e737 = (_e534.member.member.x + _e667);
                                            let _e738 = (_e534.member.member.y + _e676);
                                            let _e739 = (_e534.member.member.z + _e685);
                                            let _e742 = (_e534.member.member_1.x - _e706);
                                            let _e743 = (_e534.member.member_1.y - _e715);
                                            let _e744 = (_e534.member.member_1.z - _e724);
                                            let _e763 = (_e742 - _e737);
                                            let _e764 = (_e743 - _e738);
                                            let _e765 = (_e744 - _e739);
                                            let _e767 = select(_e764, _e763, (_e763 > _e764));
                                            let _e769 = select(_e765, _e767, (_e767 > _e765));
                                            if (_e769 < (1024f * _e139)) {
                                                phi_3583_ = 0u;
                                            } else {
                                                phi_3583_ = select(2u, 1u, (_e769 < (2097152f * _e139)));
                                            }
                                            let _e776 = phi_3583_;
                                            switch bitcast<i32>(_e776) {
                                                case 0: {
                                                    phi_3589_ = 1u;
                                                    break;
                                                }
                                                case 1: {
                                                    phi_3589_ = 2u;
                                                    break;
                                                }
                                                case 2: {
                                                    phi_3589_ = 3u;
                                                    break;
                                                }
                                                default: {
                                                    phi_3589_ = u32();
                                                    break;
                                                }
                                            }
                                            let _e779 = phi_3589_;
                                            let _e785 = global_4.member[_e534.member_1][0u];
                                            let _e789 = global_4.member[_e534.member_1][2u];
                                            let _e793 = global_4.member[_e534.member_1][4u];
                                            let _e797 = global_4.member[_e534.member_1][6u];
                                            let _e809 = (((_e789 >> bitcast<u32>(22i)) | ((_e793 >> bitcast<u32>(22i)) << bitcast<u32>(10i))) | ((_e797 >> bitcast<u32>(22i)) << bitcast<u32>(20i)));
                                            let _e810 = (_e785 & 268435455u);
                                            let _e811 = (_e809 & 268435455u);
                                            let _e814 = ((_e785 >> bitcast<u32>(28u)) & 7u);
                                            let _e822 = ((_e785 >> bitcast<u32>(31i)) | (((_e809 >> bitcast<u32>(28u)) & 3u) << bitcast<u32>(1i)));
                                            let _e823 = (_e814 != 0u);
                                            if (_e814 == 0u) {
                                                phi_3844_ = _e810;
                                            } else {
                                                if (_e814 == 7u) {
                                                    phi_3843_ = 2147483648u;
                                                } else {
                                                    phi_3843_ = ((2147483648u | (_e814 << bitcast<u32>(28u))) | (_e811 & 268435455u));
                                                }
                                                let _e832 = phi_3843_;
                                                phi_3844_ = _e832;
                                            }
                                            let _e834 = phi_3844_;
                                            if _e823 {
                                                let _e835 = (_e814 != 7u);
                                                if _e835 {
                                                    phi_3854_ = (_e811 + (_e814 * ((3u * _e779) + 1u)));
                                                } else {
                                                    phi_3854_ = u32();
                                                }
                                                let _e839 = phi_3854_;
                                                phi_3856_ = _e839;
                                                phi_3857_ = select(true, false, _e835);
                                            } else {
                                                phi_3856_ = u32();
                                                phi_3857_ = true;
                                            }
                                            let _e842 = phi_3856_;
                                            let _e844 = phi_3857_;
                                            if (_e822 == 0u) {
                                                phi_3878_ = (_e810 + select(0u, 1u, !(_e823)));
                                            } else {
                                                if (_e822 == 7u) {
                                                    phi_3877_ = 2147483648u;
                                                } else {
                                                    phi_3877_ = ((2147483648u | (_e822 << bitcast<u32>(28u))) | (select(_e842, _e811, _e844) & 268435455u));
                                                }
                                                let _e857 = phi_3877_;
                                                phi_3878_ = _e857;
                                            }
                                            let _e859 = phi_3878_;
                                            phi_3882_ = type_56(array<vec4<f32>, 3>(vec4<f32>(_e737, (_e534.member.member.x + _e689), _e742, (_e534.member.member_1.x - _e728)), vec4<f32>(_e738, (_e534.member.member.y + _e693), _e743, (_e534.member.member_1.y - _e732)), vec4<f32>(_e739, (_e534.member.member.z + _e697), _e744, (_e534.member.member_1.z - _e736))), type_53(type_28((_e534.member.member + vec4<f32>(_e667, _e676, _e685, 0f)), (_e534.member.member_1 - vec4<f32>(_e706, _e715, _e724, 0f))), _e834), type_53(type_28((_e534.member.member + vec4<f32>(_e689, _e693, _e697, 0f)), (_e534.member.member_1 - vec4<f32>(_e728, _e732, _e736, 0f))), _e859));
                                        }
                                        let _e864 = phi_3882_;
                                        let _e877 = ((_e864.member[0].x - _e331) * _e336);
                                        let _e878 = ((_e864.member[0].y - _e331) * _e336);
                                        let _e879 = ((_e864.member[0].z - _e332) * _e336);
                                        let _e880 = ((_e864.member[0].w - _e332) * _e336);
                                        let _e890 = ((_e864.member[1].x - _e369) * _e374);
                                        let _e891 = ((_e864.member[1].y - _e369) * _e374);
                                        let _e892 = ((_e864.member[1].z - _e370) * _e374);
                                        let _e893 = ((_e864.member[1].w - _e370) * _e374);
                                        let _e903 = ((_e864.member[2].x - _e407) * _e412);
                                        let _e904 = ((_e864.member[2].y - _e407) * _e412);
                                        let _e905 = ((_e864.member[2].z - _e408) * _e412);
                                        let _e906 = ((_e864.member[2].w - _e408) * _e412);
                                        let _e908 = select(_e905, _e903, (_e903 < _e905));
                                        let _e910 = select(_e906, _e904, (_e904 < _e906));
                                        let _e912 = select(_e905, _e903, (_e903 > _e905));
                                        let _e914 = select(_e906, _e904, (_e904 > _e906));
                                        let _e916 = select(_e879, _e877, (_e877 < _e879));
                                        let _e918 = select(_e880, _e878, (_e878 < _e880));
                                        let _e920 = select(_e892, _e890, (_e890 < _e892));
                                        let _e922 = select(_e893, _e891, (_e891 < _e893));
                                        let _e924 = select(_e920, _e916, (_e916 > _e920));
                                        let _e926 = select(_e922, _e918, (_e918 > _e922));
                                        let _e928 = select(_e908, _e924, (_e924 > _e908));
                                        let _e930 = select(_e910, _e926, (_e926 > _e910));
                                        let _e932 = select(_e879, _e877, (_e877 > _e879));
                                        let _e934 = select(_e880, _e878, (_e878 > _e880));
                                        let _e936 = select(_e892, _e890, (_e890 > _e892));
                                        let _e938 = select(_e893, _e891, (_e891 > _e893));
                                        let _e940 = select(_e936, _e932, (_e932 < _e936));
                                        let _e942 = select(_e938, _e934, (_e934 < _e938));
                                        let _e947 = -(_e908);
                                        let _e948 = -(_e910);
                                        let _e955 = (select(_e912, _e940, (_e940 < _e912)) + (select(_e947, _e912, (_e912 > _e947)) * 0.0000019073523f));
                                        let _e956 = (select(_e914, _e942, (_e942 < _e914)) + (select(_e948, _e914, (_e914 > _e948)) * 0.0000019073523f));
                                        let _e958 = select(_e459, _e928, (_e928 > _e459));
                                        let _e960 = select(_e459, _e930, (_e930 > _e459));
                                        let _e965 = (_e958 <= select(_e504.member.member_1, _e955, (_e955 < _e504.member.member_1)));
                                        let _e966 = (_e960 <= select(_e504.member.member_1, _e956, (_e956 < _e504.member.member_1)));
                                        let _e967 = (_e958 <= _e960);
                                        if _e965 {
                                            if _e966 {
                                                if _e967 {
                                                    phi_4226_ = _e864.member_2;
                                                } else {
                                                    phi_4226_ = _e864.member_1;
                                                }
                                                let _e971 = phi_4226_;
                                                let _e972 = (_e538 % 128u);
                                                let _e973 = (_e972 < 128u);
                                                if _e973 {
                                                } else {
                                                    phi_4631_ = true;
                                                    break;
                                                }
                                                local_3[_e972] = type_53(type_28(_e971.member.member, _e971.member.member_1), _e971.member_1);
                                                if _e973 {
                                                } else {
                                                    phi_4631_ = true;
                                                    break;
                                                }
                                                local_2[_e972] = select(_e960, _e958, (_e958 > _e960));
                                                if _e967 {
                                                    phi_4259_ = _e864.member_1;
                                                } else {
                                                    phi_4259_ = _e864.member_2;
                                                }
                                                let _e988 = phi_4259_;
                                                phi_4260_ = _e988;
                                                phi_4261_ = (_e538 + 1u);
                                            } else {
                                                phi_4260_ = type_53();
                                                phi_4261_ = u32();
                                            }
                                            let _e990 = phi_4260_;
                                            let _e992 = phi_4261_;
                                            phi_4263_ = _e990;
                                            phi_4264_ = _e992;
                                            phi_4265_ = select(true, false, _e966);
                                        } else {
                                            phi_4263_ = type_53();
                                            phi_4264_ = u32();
                                            phi_4265_ = true;
                                        }
                                        let _e995 = phi_4263_;
                                        let _e997 = phi_4264_;
                                        let _e999 = phi_4265_;
                                        if _e999 {
                                            if _e965 {
                                                phi_4274_ = _e864.member_1;
                                            } else {
                                                phi_4274_ = _e864.member_2;
                                            }
                                            let _e1003 = phi_4274_;
                                            phi_4279_ = _e1003;
                                            phi_4280_ = select(_e966, true, _e965);
                                        } else {
                                            phi_4279_ = _e995;
                                            phi_4280_ = _e536;
                                        }
                                        let _e1006 = phi_4279_;
                                        let _e1008 = phi_4280_;
                                        phi_4635_ = _e502;
                                        phi_4282_ = type_38(_e504.member, (_e504.member_1 + 1u), _e504.member_2);
                                        phi_4283_ = _e1006;
                                        phi_4284_ = _e1008;
                                        phi_4285_ = select(_e997, _e538, _e999);
                                    }
                                    let _e1540 = phi_4635_;
                                    let _e1542 = phi_4282_;
                                    let _e1544 = phi_4283_;
                                    let _e1546 = phi_4284_;
                                    let _e1548 = phi_4285_;
                                    phi_4634_ = _e1540;
                                    phi_4286_ = _e1542;
                                    phi_4287_ = _e1544;
                                    phi_4288_ = (_e508 - 1u);
                                    phi_4289_ = _e1546;
                                    phi_4290_ = _e1548;
                                } else {
                                    phi_4634_ = _e502;
                                    phi_4286_ = _e504;
                                    phi_4287_ = _e534;
                                    phi_4288_ = _e508;
                                    phi_4289_ = _e536;
                                    phi_4290_ = _e538;
                                }
                                let _e1550 = phi_4634_;
                                let _e1552 = phi_4286_;
                                let _e1554 = phi_4287_;
                                let _e1556 = phi_4288_;
                                let _e1558 = phi_4289_;
                                let _e1560 = phi_4290_;
                                phi_4633_ = _e1550;
                                phi_4291_ = _e1552;
                                phi_4292_ = _e1554;
                                phi_4293_ = _e1556;
                                phi_4294_ = _e1558;
                                phi_4295_ = _e1560;
                            } else {
                                phi_4633_ = _e502;
                                phi_4291_ = type_38();
                                phi_4292_ = type_53();
                                phi_4293_ = u32();
                                phi_4294_ = bool();
                                phi_4295_ = u32();
                            }
                            let _e1562 = phi_4633_;
                            let _e1564 = phi_4291_;
                            let _e1566 = phi_4292_;
                            let _e1568 = phi_4293_;
                            let _e1570 = phi_4294_;
                            let _e1572 = phi_4295_;
                            phi_4632_ = _e1562;
                            phi_1894_ = _e1564;
                            phi_1897_ = _e1566;
                            phi_1899_ = _e1568;
                            phi_1901_ = _e1570;
                            phi_1903_ = _e1572;
                            phi_4296_ = _e516;
                        } else {
                            phi_4632_ = _e502;
                            phi_1894_ = type_38();
                            phi_1897_ = type_53();
                            phi_1899_ = u32();
                            phi_1901_ = bool();
                            phi_1903_ = u32();
                            phi_4296_ = false;
                        }
                        let _e1574 = phi_4632_;
                        let _e1576 = phi_1894_;
                        let _e1578 = phi_1897_;
                        let _e1580 = phi_1899_;
                        let _e1582 = phi_1901_;
                        let _e1584 = phi_1903_;
                        let _e1586 = phi_4296_;
                        continue;
                        continuing {
                            phi_4517_ = _e1574;
                            phi_1893_ = _e1576;
                            phi_1896_ = _e1578;
                            phi_1898_ = _e1580;
                            phi_1900_ = _e1582;
                            phi_1902_ = _e1584;
                            phi_4631_ = _e1574;
                            break if !(_e1586);
                        }
                    }
                    let _e1589 = phi_4631_;
                    if _e1589 {
                        break;
                    }
                    let _e1591 = local_7;
                    let _e1594 = local_8;
                    if _e147 {
                    } else {
                        break;
                    }
                    global_6.member[_e145][0u] = _e1591.member_1;
                    global_6.member[_e145][1u] = _e1594.member_2;
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn trace_counted_q21_lattice(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
