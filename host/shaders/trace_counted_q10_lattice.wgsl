struct type_4 {
    member: array<u32>,
}

struct type_8 {
    member: u32,
    member_1: u32,
}

struct type_13 {
    member: array<array<u32, 4>>,
}

struct type_16 {
    member: vec4<u32>,
}

struct type_24 {
    member: array<array<u32, 2>>,
}

struct type_28 {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: u32,
}

struct type_29 {
    member: array<f32, 3>,
    member_1: f32,
    member_2: array<f32, 3>,
    member_3: f32,
}

struct type_32 {
    member: vec4<f32>,
    member_1: vec4<f32>,
}

struct type_36 {
    member: type_28,
    member_1: f32,
}

struct type_40 {
    member: array<type_29>,
}

struct type_42 {
    member: type_36,
    member_1: u32,
    member_2: u32,
}

struct type_44 {
    member: array<vec4<u32>, 2>,
}

struct type_53 {
    member: type_32,
    member_1: u32,
}

struct type_56 {
    member: array<vec4<f32>, 3>,
    member_1: type_53,
    member_2: type_53,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_1: type_16;
@group(0) @binding(1) 
var<uniform> global_2: type_44;
@group(0) @binding(2) 
var<storage> global_3: type_13;
@group(0) @binding(4) 
var<storage> global_4: type_40;
@group(0) @binding(3) 
var<storage> global_5: type_4;
@group(0) @binding(5) 
var<storage, read_write> global_6: type_24;

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
    var phi_1893_: type_42;
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
    var phi_1971_: type_42;
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
    var phi_2882_: type_28;
    var phi_2884_: type_28;
    var phi_2885_: bool;
    var phi_2889_: type_28;
    var phi_2890_: type_28;
    var phi_2891_: type_28;
    var phi_2892_: bool;
    var phi_2896_: type_28;
    var phi_2897_: bool;
    var phi_2901_: type_28;
    var phi_2902_: bool;
    var phi_2906_: type_28;
    var phi_2931_: bool;
    var phi_2932_: bool;
    var phi_2939_: type_42;
    var phi_2940_: type_42;
    var phi_2941_: type_42;
    var phi_4573_: bool;
    var phi_1972_: type_42;
    var phi_4572_: bool;
    var phi_4635_: bool;
    var phi_4282_: type_42;
    var phi_4283_: type_53;
    var phi_4284_: bool;
    var phi_4285_: u32;
    var phi_4634_: bool;
    var phi_4286_: type_42;
    var phi_4287_: type_53;
    var phi_4288_: u32;
    var phi_4289_: bool;
    var phi_4290_: u32;
    var phi_4633_: bool;
    var phi_4291_: type_42;
    var phi_4292_: type_53;
    var phi_4293_: u32;
    var phi_4294_: bool;
    var phi_4295_: u32;
    var phi_4632_: bool;
    var phi_1894_: type_42;
    var phi_1897_: type_53;
    var phi_1899_: u32;
    var phi_1901_: bool;
    var phi_1903_: u32;
    var phi_4296_: bool;
    var phi_4631_: bool;
    var local_7: type_42;
    var local_8: type_42;
    var local_9: type_42;

    switch bitcast<i32>(0u) {
        default: {
            let _e87 = global;
            let _e89 = arrayLength((&global_3.member));
            let _e92 = arrayLength((&global_5.member));
            let _e100 = global_2.member[0u][0u];
            let _e104 = global_2.member[0u][1u];
            let _e108 = global_2.member[0u][2u];
            let _e112 = global_2.member[0u][3u];
            let _e116 = global_2.member[1u][0u];
            let _e120 = global_2.member[1u][1u];
            let _e124 = global_2.member[1u][2u];
            let _e127 = global_1.member[0u];
            let _e128 = bitcast<i32>(_e127);
            let _e140 = bitcast<f32>((bitcast<u32>((bitcast<i32>(_e112) + 127i)) << bitcast<u32>(23i)));
            local_1 = array<i32, 3>(bitcast<i32>(_e100), bitcast<i32>(_e104), bitcast<i32>(_e108));
            local = array<i32, 3>(bitcast<i32>(_e116), bitcast<i32>(_e120), bitcast<i32>(_e124));
            let _e146 = (_e87.x + (_e87.y * 2097152u));
            let _e147 = (_e146 < arrayLength((&global_4.member)));
            if _e147 {
                let _e148 = (_e146 < arrayLength((&global_6.member)));
                if _e148 {
                    if _e147 {
                    } else {
                        break;
                    }
                    let _e156 = global_4.member[_e146].member_2[0u];
                    let _e158 = (bitcast<u32>(_e156) & 2147483647u);
                    let _e163 = global_4.member[_e146].member_2[1u];
                    let _e165 = (bitcast<u32>(_e163) & 2147483647u);
                    let _e170 = global_4.member[_e146].member_2[2u];
                    let _e172 = (bitcast<u32>(_e170) & 2147483647u);
                    let _e177 = global_4.member[_e146].member[0u];
                    let _e179 = (bitcast<u32>(_e177) & 2147483647u);
                    let _e184 = global_4.member[_e146].member[1u];
                    let _e186 = (bitcast<u32>(_e184) & 2147483647u);
                    let _e191 = global_4.member[_e146].member[2u];
                    let _e193 = (bitcast<u32>(_e191) & 2147483647u);
                    let _e195 = select(_e165, _e158, (_e165 < _e158));
                    let _e197 = select(_e172, _e195, (_e172 < _e195));
                    let _e199 = select(_e179, _e197, (_e179 < _e197));
                    let _e201 = select(_e186, _e199, (_e186 < _e199));
                    let _e203 = select(_e193, _e201, (_e193 < _e201));
                    let _e207 = global_4.member[_e146].member_1;
                    let _e209 = (bitcast<u32>(_e207) & 2147483647u);
                    let _e216 = global_4.member[_e146].member_3;
                    let _e222 = (((select(_e209, _e203, (_e209 < _e203)) < 2139095040u) && ((bitcast<u32>(_e216) & 2147483647u) <= 2139095040u)) && (_e197 > 0u));
                    if _e222 {
                        let _e225 = (bitcast<u32>(bitcast<f32>(_e197)) & 2147483647u);
                        if (_e225 >= 8388608u) {
                            phi_402_ = (bitcast<i32>((_e225 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_402_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e225)), 32u, (_e225 == 0u))));
                        }
                        let _e239 = phi_402_;
                        phi_403_ = _e239;
                    } else {
                        phi_403_ = 0i;
                    }
                    let _e241 = phi_403_;
                    let _e242 = (_e158 == _e197);
                    if _e242 {
                        phi_413_ = true;
                    } else {
                        phi_413_ = (_e165 == _e197);
                    }
                    let _e245 = phi_413_;
                    let _e246 = select(1u, 0u, _e242);
                    if _e245 {
                        let _e247 = (_e246 + 1u);
                        phi_423_ = _e247;
                        phi_424_ = _e247;
                        phi_426_ = select(true, false, (_e247 == 2u));
                    } else {
                        phi_423_ = u32();
                        phi_424_ = 0u;
                        phi_426_ = true;
                    }
                    let _e251 = phi_423_;
                    let _e253 = phi_424_;
                    let _e255 = phi_426_;
                    if _e255 {
                        phi_431_ = (_e253 + 1u);
                    } else {
                        phi_431_ = 0u;
                    }
                    let _e259 = phi_431_;
                    let _e260 = select(_e251, _e253, _e255);
                    let _e261 = select(_e246, select(2u, _e246, _e245), _e255);
                    if (_e128 < -126i) {
                        phi_444_ = -126i;
                    } else {
                        phi_444_ = select(_e128, 127i, (_e128 > 127i));
                    }
                    let _e266 = phi_444_;
                    let _e271 = bitcast<f32>((bitcast<u32>((_e266 + 127i)) << bitcast<u32>(23i)));
                    let _e277 = bitcast<f32>((bitcast<u32>(((_e128 - _e266) + 127i)) << bitcast<u32>(23i)));
                    let _e278 = -(_e241);
                    if (_e278 < -126i) {
                        phi_464_ = -126i;
                    } else {
                        phi_464_ = select(_e278, 127i, (_e278 > 127i));
                    }
                    let _e283 = phi_464_;
                    let _e288 = bitcast<f32>((bitcast<u32>((_e283 + 127i)) << bitcast<u32>(23i)));
                    let _e294 = bitcast<f32>((bitcast<u32>(((_e278 - _e283) + 127i)) << bitcast<u32>(23i)));
                    let _e298 = global_4.member[_e146].member;
                    let _e299 = (_e260 == 0u);
                    if _e299 {
                        phi_482_ = _e298[0];
                    } else {
                        phi_482_ = _e298[1];
                    }
                    let _e303 = phi_482_;
                    let _e304 = (_e260 == 2u);
                    if _e304 {
                        phi_488_ = _e298[2];
                    } else {
                        phi_488_ = _e303;
                    }
                    let _e307 = phi_488_;
                    let _e309 = ((_e307 * _e271) * _e277);
                    let _e310 = global_4.member[_e146].member_2;
                    if _e299 {
                        phi_499_ = _e310[0];
                    } else {
                        phi_499_ = _e310[1];
                    }
                    let _e314 = phi_499_;
                    if _e304 {
                        phi_505_ = _e310[2];
                    } else {
                        phi_505_ = _e314;
                    }
                    let _e317 = phi_505_;
                    let _e319 = ((_e317 * _e288) * _e294);
                    let _e323 = (bitcast<f32>((bitcast<u32>(_e319) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e323 {
                        let _e327 = (bitcast<f32>((bitcast<u32>(_e309) & 2147483647u)) * 0.00000011920929f);
                        phi_528_ = select(0.00000000000011368684f, _e327, (_e327 > 0.00000000000011368684f));
                    } else {
                        phi_528_ = 0f;
                    }
                    let _e331 = phi_528_;
                    let _e332 = (_e309 + _e331);
                    let _e333 = (_e309 - _e331);
                    let _e334 = select(_e319, 0f, _e323);
                    if _e323 {
                        phi_539_ = 38685626000000000000000000f;
                    } else {
                        phi_539_ = (1f / _e319);
                    }
                    let _e337 = phi_539_;
                    let _e338 = (_e259 == 0u);
                    if _e338 {
                        phi_548_ = _e298[0];
                    } else {
                        phi_548_ = _e298[1];
                    }
                    let _e342 = phi_548_;
                    let _e343 = (_e259 == 2u);
                    if _e343 {
                        phi_554_ = _e298[2];
                    } else {
                        phi_554_ = _e342;
                    }
                    let _e346 = phi_554_;
                    let _e348 = ((_e346 * _e271) * _e277);
                    if _e338 {
                        phi_565_ = _e310[0];
                    } else {
                        phi_565_ = _e310[1];
                    }
                    let _e352 = phi_565_;
                    if _e343 {
                        phi_571_ = _e310[2];
                    } else {
                        phi_571_ = _e352;
                    }
                    let _e355 = phi_571_;
                    let _e357 = ((_e355 * _e288) * _e294);
                    let _e361 = (bitcast<f32>((bitcast<u32>(_e357) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e361 {
                        let _e365 = (bitcast<f32>((bitcast<u32>(_e348) & 2147483647u)) * 0.00000011920929f);
                        phi_594_ = select(0.00000000000011368684f, _e365, (_e365 > 0.00000000000011368684f));
                    } else {
                        phi_594_ = 0f;
                    }
                    let _e369 = phi_594_;
                    let _e370 = (_e348 + _e369);
                    let _e371 = (_e348 - _e369);
                    let _e372 = select(_e357, 0f, _e361);
                    if _e361 {
                        phi_605_ = 38685626000000000000000000f;
                    } else {
                        phi_605_ = (1f / _e357);
                    }
                    let _e375 = phi_605_;
                    let _e376 = (_e261 == 0u);
                    if _e376 {
                        phi_614_ = _e298[0];
                    } else {
                        phi_614_ = _e298[1];
                    }
                    let _e380 = phi_614_;
                    let _e381 = (_e261 == 2u);
                    if _e381 {
                        phi_620_ = _e298[2];
                    } else {
                        phi_620_ = _e380;
                    }
                    let _e384 = phi_620_;
                    let _e386 = ((_e384 * _e271) * _e277);
                    if _e376 {
                        phi_631_ = _e310[0];
                    } else {
                        phi_631_ = _e310[1];
                    }
                    let _e390 = phi_631_;
                    if _e381 {
                        phi_637_ = _e310[2];
                    } else {
                        phi_637_ = _e390;
                    }
                    let _e393 = phi_637_;
                    let _e395 = ((_e393 * _e288) * _e294);
                    let _e399 = (bitcast<f32>((bitcast<u32>(_e395) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e399 {
                        let _e403 = (bitcast<f32>((bitcast<u32>(_e386) & 2147483647u)) * 0.00000011920929f);
                        phi_660_ = select(0.00000000000011368684f, _e403, (_e403 > 0.00000000000011368684f));
                    } else {
                        phi_660_ = 0f;
                    }
                    let _e407 = phi_660_;
                    let _e408 = (_e386 + _e407);
                    let _e409 = (_e386 - _e407);
                    let _e410 = select(_e395, 0f, _e399);
                    if _e399 {
                        phi_671_ = 38685626000000000000000000f;
                    } else {
                        phi_671_ = (1f / _e395);
                    }
                    let _e413 = phi_671_;
                    let _e416 = bitcast<f32>((bitcast<u32>(_e309) & 2147483647u));
                    let _e419 = bitcast<f32>((bitcast<u32>(_e348) & 2147483647u));
                    let _e421 = select(_e419, _e416, (_e416 > _e419));
                    let _e424 = bitcast<f32>((bitcast<u32>(_e386) & 2147483647u));
                    let _e427 = (_e128 + _e241);
                    if (_e222 && (select(_e424, _e421, (_e421 > _e424)) <= 1099511600000f)) {
                        let _e430 = (_e427 / 3i);
                        let _e437 = bitcast<f32>((bitcast<u32>((_e430 + 127i)) << bitcast<u32>(23i)));
                        let _e444 = bitcast<f32>((bitcast<u32>(((_e427 - (2i * _e430)) + 127i)) << bitcast<u32>(23i)));
                        let _e445 = (((_e207 * _e437) * _e437) * _e444);
                        let _e447 = select(340282350000000000000000000000000000000f, _e445, (_e445 < 340282350000000000000000000000000000000f));
                        let _e452 = (((_e216 * _e437) * _e437) * _e444);
                        let _e454 = select(340282350000000000000000000000000000000f, _e452, (_e452 < 340282350000000000000000000000000000000f));
                        phi_771_ = select(-340282350000000000000000000000000000000f, _e454, (_e454 > -340282350000000000000000000000000000000f));
                        phi_772_ = select(-340282350000000000000000000000000000000f, _e447, (_e447 > -340282350000000000000000000000000000000f));
                    } else {
                        phi_771_ = 0f;
                        phi_772_ = 1f;
                    }
                    let _e458 = phi_771_;
                    let _e460 = phi_772_;
                    local_3 = array<type_53, 128>(type_53(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u));
                    local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    let _e465 = (_e260 % 3u);
                    let _e466 = (_e465 < 3u);
                    if _e466 {
                    } else {
                        break;
                    }
                    let _e468 = local_1[_e465];
                    let _e471 = (_e259 % 3u);
                    let _e472 = (_e471 < 3u);
                    if _e472 {
                    } else {
                        break;
                    }
                    let _e474 = local_1[_e471];
                    let _e477 = (_e261 % 3u);
                    let _e478 = (_e477 < 3u);
                    if _e478 {
                    } else {
                        break;
                    }
                    let _e480 = local_1[_e477];
                    if _e466 {
                    } else {
                        break;
                    }
                    let _e485 = local[_e465];
                    if _e472 {
                    } else {
                        break;
                    }
                    let _e489 = local[_e471];
                    if _e478 {
                    } else {
                        break;
                    }
                    let _e493 = local[_e477];
                    phi_4517_ = false;
                    phi_1893_ = type_42(type_36(type_28(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e458), 0u, 0u);
                    phi_1896_ = type_53(type_32(vec4<f32>((f32(_e468) * _e140), (f32(_e474) * _e140), (f32(_e480) * _e140), 0f), vec4<f32>((f32(_e485) * _e140), (f32(_e489) * _e140), (f32(_e493) * _e140), 0f)), select(0u, 2147483648u, (_e89 == 0u)));
                    phi_1898_ = ((3u * _e89) + 1u);
                    phi_1900_ = (_e460 <= _e458);
                    phi_1902_ = 0u;
                    loop {
                        let _e503 = phi_4517_;
                        let _e505 = phi_1893_;
                        let _e507 = phi_1896_;
                        let _e509 = phi_1898_;
                        let _e511 = phi_1900_;
                        let _e513 = phi_1902_;
                        local_7 = _e505;
                        local_8 = _e505;
                        if _e511 {
                            phi_1913_ = true;
                        } else {
                            phi_1913_ = (_e513 > 0u);
                        }
                        let _e516 = phi_1913_;
                        if _e516 {
                            let _e517 = (_e509 > 0u);
                            if _e517 {
                                if _e511 {
                                    phi_1950_ = _e507;
                                    phi_1951_ = _e511;
                                    phi_1952_ = _e513;
                                } else {
                                    let _e518 = (_e513 - 1u);
                                    let _e519 = (_e518 % 128u);
                                    let _e520 = (_e519 < 128u);
                                    if _e520 {
                                    } else {
                                        phi_4631_ = true;
                                        break;
                                    }
                                    let _e522 = local_3[_e519];
                                    if _e520 {
                                    } else {
                                        phi_4631_ = true;
                                        break;
                                    }
                                    let _e530 = local_2[_e519];
                                    phi_1950_ = type_53(type_32(_e522.member.member, _e522.member.member_1), _e522.member_1);
                                    phi_1951_ = (_e530 <= _e505.member.member_1);
                                    phi_1952_ = _e518;
                                }
                                let _e535 = phi_1950_;
                                let _e537 = phi_1951_;
                                let _e539 = phi_1952_;
                                if _e537 {
                                    let _e544 = (_e535.member_1 & 268435455u);
                                    if ((_e535.member_1 & 2147483648u) != 0u) {
                                        phi_4514_ = _e503;
                                        phi_1971_ = _e505;
                                        phi_1974_ = type_8(0u, ((_e535.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e1013 = phi_4514_;
                                            let _e1015 = phi_1971_;
                                            let _e1017 = phi_1974_;
                                            local_9 = _e1015;
                                            if (_e1017.member < _e1017.member_1) {
                                                phi_1975_ = type_8((_e1017.member + 1u), _e1017.member_1);
                                                phi_1997_ = type_8(1u, _e1017.member);
                                            } else {
                                                phi_1975_ = _e1017;
                                                phi_1997_ = type_8(0u, type_8().member_1);
                                            }
                                            let _e1030 = phi_1975_;
                                            let _e1032 = phi_1997_;
                                            let _e1036 = (bitcast<i32>(_e1032.member) != 0i);
                                            if _e1036 {
                                                let _e1042 = type_42(_e1015.member, _e1015.member_1, (_e1015.member_2 + 1u));
                                                let _e1047 = (_e535.member.member_1.x - _e535.member.member.x);
                                                let _e1050 = (_e535.member.member_1.y - _e535.member.member.y);
                                                let _e1053 = (_e535.member.member_1.z - _e535.member.member.z);
                                                let _e1055 = select(_e1050, _e1047, (_e1047 > _e1050));
                                                let _e1057 = select(_e1053, _e1055, (_e1055 > _e1053));
                                                let _e1059 = (_e1057 < (1024f * _e140));
                                                if _e1059 {
                                                    phi_2041_ = 0u;
                                                } else {
                                                    phi_2041_ = select(2u, 1u, (_e1057 < (2097152f * _e140)));
                                                }
                                                let _e1064 = phi_2041_;
                                                switch bitcast<i32>(_e1064) {
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
                                                let _e1067 = phi_2047_;
                                                switch bitcast<i32>(_e1064) {
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
                                                let _e1074 = phi_2057_;
                                                let _e1076 = ((_e544 + (_e1032.member_1 * ((3u * _e1067) + 1u))) + (3u * _e1074));
                                                let _e1077 = (_e1076 < _e92);
                                                if _e1077 {
                                                    if _e1077 {
                                                    } else {
                                                        phi_4572_ = true;
                                                        break;
                                                    }
                                                    let _e1079 = global_5.member[_e1076];
                                                    phi_2073_ = _e1079;
                                                } else {
                                                    phi_2073_ = 4294967295u;
                                                }
                                                let _e1081 = phi_2073_;
                                                local_4 = array<u32, 3>(_e260, _e259, _e261);
                                                if _e1059 {
                                                    phi_2110_ = 0u;
                                                } else {
                                                    phi_2110_ = select(2u, 1u, (_e1057 < (2097152f * _e140)));
                                                }
                                                let _e1087 = phi_2110_;
                                                switch bitcast<i32>(_e1087) {
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
                                                let _e1090 = phi_2116_;
                                                switch bitcast<i32>(_e1087) {
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
                                                let _e1097 = phi_2126_;
                                                local_6 = array<f32, 4>(_e535.member.member.x, _e535.member.member.y, _e535.member.member.z, _e535.member.member.w);
                                                local_5[0u] = array<f32, 3>(0f, 0f, 0f);
                                                local_5[1u] = array<f32, 3>(0f, 0f, 0f);
                                                local_5[2u] = array<f32, 3>(0f, 0f, 0f);
                                                phi_4499_ = _e1013;
                                                phi_2142_ = type_8(0u, 3u);
                                                loop {
                                                    let _e1111 = phi_4499_;
                                                    let _e1113 = phi_2142_;
                                                    if (_e1113.member < _e1113.member_1) {
                                                        phi_2143_ = type_8((_e1113.member + 1u), _e1113.member_1);
                                                        phi_2166_ = type_8(1u, _e1113.member);
                                                    } else {
                                                        phi_2143_ = _e1113;
                                                        phi_2166_ = type_8(0u, type_8().member_1);
                                                    }
                                                    let _e1126 = phi_2143_;
                                                    let _e1128 = phi_2166_;
                                                    let _e1132 = (bitcast<i32>(_e1128.member) != 0i);
                                                    if _e1132 {
                                                        let _e1134 = ((_e544 + (_e1032.member_1 * ((3u * _e1090) + 1u))) + (_e1128.member_1 * _e1097));
                                                        let _e1135 = (_e1134 < _e92);
                                                        if _e1135 {
                                                            if _e1135 {
                                                            } else {
                                                                phi_4570_ = true;
                                                                break;
                                                            }
                                                            let _e1137 = global_5.member[_e1134];
                                                            phi_2189_ = _e1137;
                                                        } else {
                                                            phi_2189_ = 0u;
                                                        }
                                                        let _e1139 = phi_2189_;
                                                        let _e1140 = (_e1134 + 1u);
                                                        let _e1141 = (_e1140 < _e92);
                                                        if _e1141 {
                                                            if _e1141 {
                                                            } else {
                                                                phi_4570_ = true;
                                                                break;
                                                            }
                                                            let _e1143 = global_5.member[_e1140];
                                                            phi_2204_ = _e1143;
                                                        } else {
                                                            phi_2204_ = 0u;
                                                        }
                                                        let _e1145 = phi_2204_;
                                                        phi_2207_ = type_8(0u, 3u);
                                                        loop {
                                                            let _e1147 = phi_2207_;
                                                            if (_e1147.member < _e1147.member_1) {
                                                                phi_2208_ = type_8((_e1147.member + 1u), _e1147.member_1);
                                                                phi_2231_ = type_8(1u, _e1147.member);
                                                            } else {
                                                                phi_2208_ = _e1147;
                                                                phi_2231_ = type_8(0u, type_8().member_1);
                                                            }
                                                            let _e1160 = phi_2208_;
                                                            let _e1162 = phi_2231_;
                                                            let _e1166 = (bitcast<i32>(_e1162.member) != 0i);
                                                            if _e1166 {
                                                                let _e1167 = (_e1162.member_1 < 3u);
                                                                if _e1167 {
                                                                } else {
                                                                    phi_4492_ = true;
                                                                    break;
                                                                }
                                                                let _e1169 = local_4[_e1162.member_1];
                                                                if (_e1162.member_1 < 4u) {
                                                                } else {
                                                                    phi_4492_ = true;
                                                                    break;
                                                                }
                                                                let _e1172 = local_6[_e1162.member_1];
                                                                switch bitcast<i32>(_e1087) {
                                                                    case 0: {
                                                                        phi_2301_ = (_e1172 + (f32(((_e1139 >> bitcast<u32>(((10u * _e1169) & 31u))) & 1023u)) * _e140));
                                                                        break;
                                                                    }
                                                                    case 1: {
                                                                        if (_e1169 == 0u) {
                                                                            phi_2278_ = _e1139;
                                                                        } else {
                                                                            if (_e1169 == 1u) {
                                                                                phi_2277_ = ((_e1139 >> bitcast<u32>(21i)) | (_e1145 << bitcast<u32>(11i)));
                                                                            } else {
                                                                                phi_2277_ = (_e1145 >> bitcast<u32>(10i));
                                                                            }
                                                                            let _e1193 = phi_2277_;
                                                                            phi_2278_ = _e1193;
                                                                        }
                                                                        let _e1195 = phi_2278_;
                                                                        phi_2301_ = (_e1172 + (f32((_e1195 & 2097151u)) * _e140));
                                                                        break;
                                                                    }
                                                                    case 2: {
                                                                        let _e1174 = (_e1134 + _e1169);
                                                                        let _e1175 = (_e1174 < _e92);
                                                                        if _e1175 {
                                                                            if _e1175 {
                                                                            } else {
                                                                                phi_4492_ = true;
                                                                                break;
                                                                            }
                                                                            let _e1177 = global_5.member[_e1174];
                                                                            phi_2297_ = _e1177;
                                                                        } else {
                                                                            phi_2297_ = 0u;
                                                                        }
                                                                        let _e1179 = phi_2297_;
                                                                        phi_2301_ = (f32(bitcast<i32>(_e1179)) * _e140);
                                                                        break;
                                                                    }
                                                                    default: {
                                                                        phi_2301_ = f32();
                                                                        break;
                                                                    }
                                                                }
                                                                let _e1209 = phi_2301_;
                                                                if (_e1128.member_1 < 3u) {
                                                                } else {
                                                                    phi_4492_ = true;
                                                                    break;
                                                                }
                                                                if _e1167 {
                                                                } else {
                                                                    phi_4492_ = true;
                                                                    break;
                                                                }
                                                                local_5[_e1128.member_1][_e1162.member_1] = _e1209;
                                                            }
                                                            continue;
                                                            continuing {
                                                                phi_2207_ = _e1160;
                                                                phi_4492_ = _e1111;
                                                                break if !(_e1166);
                                                            }
                                                        }
                                                        let _e1215 = phi_4492_;
                                                        phi_4570_ = _e1215;
                                                        if _e1215 {
                                                            break;
                                                        }
                                                        phi_4571_ = _e1215;
                                                    } else {
                                                        phi_4571_ = _e1111;
                                                    }
                                                    let _e1217 = phi_4571_;
                                                    continue;
                                                    continuing {
                                                        phi_4499_ = _e1217;
                                                        phi_2142_ = _e1126;
                                                        phi_4570_ = _e1217;
                                                        break if !(_e1132);
                                                    }
                                                }
                                                let _e1220 = phi_4570_;
                                                phi_4572_ = _e1220;
                                                if _e1220 {
                                                    break;
                                                }
                                                let _e1221 = local_5;
                                                let _e1238 = (_e1221[0][2] - _e386);
                                                let _e1241 = (((_e1221[0][0] - _e309) * _e410) - (_e1238 * _e334));
                                                let _e1244 = (((_e1221[0][1] - _e348) * _e410) - (_e1238 * _e372));
                                                let _e1247 = (_e1221[1][2] - _e386);
                                                let _e1250 = (((_e1221[1][0] - _e309) * _e410) - (_e1247 * _e334));
                                                let _e1253 = (((_e1221[1][1] - _e348) * _e410) - (_e1247 * _e372));
                                                let _e1256 = (_e1221[2][2] - _e386);
                                                let _e1259 = (((_e1221[2][0] - _e309) * _e410) - (_e1256 * _e334));
                                                let _e1262 = (((_e1221[2][1] - _e348) * _e410) - (_e1256 * _e372));
                                                let _e1263 = (_e1259 * _e1253);
                                                let _e1264 = (_e1262 * _e1250);
                                                let _e1265 = (_e1241 * _e1262);
                                                let _e1266 = (_e1244 * _e1259);
                                                let _e1267 = (_e1250 * _e1244);
                                                let _e1268 = (_e1253 * _e1241);
                                                let _e1273 = (((_e1263 >= _e1264) && (_e1265 >= _e1266)) && (_e1267 >= _e1268));
                                                if (_e1273 || (((_e1263 <= _e1264) && (_e1265 <= _e1266)) && (_e1267 <= _e1268))) {
                                                    let _e1280 = select(-1f, 1f, _e1273);
                                                    let _e1282 = ((_e1263 - _e1264) * _e1280);
                                                    let _e1284 = select(0f, _e1282, (_e1282 > 0f));
                                                    let _e1286 = ((_e1265 - _e1266) * _e1280);
                                                    let _e1288 = select(0f, _e1286, (_e1286 > 0f));
                                                    let _e1290 = ((_e1267 - _e1268) * _e1280);
                                                    let _e1292 = select(0f, _e1290, (_e1290 > 0f));
                                                    let _e1294 = ((_e1284 + _e1288) + _e1292);
                                                    if (_e1294 < 0.000000000000000000000000000000000000011754944f) {
                                                        phi_2896_ = type_28();
                                                        phi_2897_ = true;
                                                    } else {
                                                        let _e1297 = select(_e1221[1][0], _e1221[0][0], (_e1221[0][0] < _e1221[1][0]));
                                                        let _e1301 = select(_e1221[1][0], _e1221[0][0], (_e1221[0][0] > _e1221[1][0]));
                                                        let _e1305 = select(_e1221[1][1], _e1221[0][1], (_e1221[0][1] < _e1221[1][1]));
                                                        let _e1309 = select(_e1221[1][1], _e1221[0][1], (_e1221[0][1] > _e1221[1][1]));
                                                        let _e1313 = select(_e1221[1][2], _e1221[0][2], (_e1221[0][2] < _e1221[1][2]));
                                                        let _e1317 = select(_e1221[1][2], _e1221[0][2], (_e1221[0][2] > _e1221[1][2]));
                                                        let _e1322 = ((select(_e1221[2][0], _e1297, (_e1297 < _e1221[2][0])) - _e332) * _e337);
                                                        let _e1323 = ((select(_e1221[2][0], _e1301, (_e1301 > _e1221[2][0])) - _e333) * _e337);
                                                        let _e1326 = ((select(_e1221[2][1], _e1305, (_e1305 < _e1221[2][1])) - _e370) * _e375);
                                                        let _e1327 = ((select(_e1221[2][1], _e1309, (_e1309 > _e1221[2][1])) - _e371) * _e375);
                                                        let _e1330 = ((select(_e1221[2][2], _e1313, (_e1313 < _e1221[2][2])) - _e408) * _e413);
                                                        let _e1331 = ((select(_e1221[2][2], _e1317, (_e1317 > _e1221[2][2])) - _e409) * _e413);
                                                        let _e1333 = select(_e1331, _e1330, (_e1330 < _e1331));
                                                        let _e1335 = select(_e1331, _e1330, (_e1330 > _e1331));
                                                        let _e1337 = select(_e1323, _e1322, (_e1322 < _e1323));
                                                        let _e1339 = select(_e1327, _e1326, (_e1326 < _e1327));
                                                        let _e1341 = select(_e1339, _e1337, (_e1337 > _e1339));
                                                        let _e1343 = select(_e1333, _e1341, (_e1341 > _e1333));
                                                        let _e1345 = select(_e1323, _e1322, (_e1322 > _e1323));
                                                        let _e1347 = select(_e1327, _e1326, (_e1326 > _e1327));
                                                        let _e1349 = select(_e1347, _e1345, (_e1345 < _e1347));
                                                        let _e1351 = select(_e1335, _e1349, (_e1349 < _e1335));
                                                        let _e1352 = -(_e1333);
                                                        let _e1358 = select(_e460, _e1343, (_e1343 > _e460));
                                                        if (_e1358 > (_e1351 + (select(_e1352, _e1335, (_e1335 > _e1352)) * 0.0000019073523f))) {
                                                            phi_2891_ = type_28();
                                                            phi_2892_ = true;
                                                        } else {
                                                            let _e1360 = (_e1358 > _e1015.member.member_1);
                                                            if _e1360 {
                                                                phi_2890_ = type_28();
                                                            } else {
                                                                let _e1364 = (_e1221[1][0] - _e1221[0][0]);
                                                                let _e1365 = (_e1221[1][1] - _e1221[0][1]);
                                                                let _e1366 = (_e1221[1][2] - _e1221[0][2]);
                                                                let _e1367 = vec3<f32>(_e1364, _e1365, _e1366);
                                                                let _e1368 = (_e1221[2][0] - _e1221[1][0]);
                                                                let _e1369 = (_e1221[2][1] - _e1221[1][1]);
                                                                let _e1370 = (_e1221[2][2] - _e1221[1][2]);
                                                                let _e1371 = vec3<f32>(_e1368, _e1369, _e1370);
                                                                let _e1372 = (_e1221[0][0] - _e1221[2][0]);
                                                                let _e1373 = (_e1221[0][1] - _e1221[2][1]);
                                                                let _e1374 = (_e1221[0][2] - _e1221[2][2]);
                                                                let _e1375 = vec3<f32>(_e1372, _e1373, _e1374);
                                                                let _e1378 = bitcast<f32>((bitcast<u32>(_e1364) & 2147483647u));
                                                                let _e1381 = bitcast<f32>((bitcast<u32>(_e1365) & 2147483647u));
                                                                let _e1383 = select(_e1381, _e1378, (_e1378 > _e1381));
                                                                let _e1386 = bitcast<f32>((bitcast<u32>(_e1366) & 2147483647u));
                                                                let _e1388 = select(_e1386, _e1383, (_e1383 > _e1386));
                                                                let _e1391 = bitcast<f32>((bitcast<u32>(_e1368) & 2147483647u));
                                                                let _e1394 = bitcast<f32>((bitcast<u32>(_e1369) & 2147483647u));
                                                                let _e1396 = select(_e1394, _e1391, (_e1391 > _e1394));
                                                                let _e1399 = bitcast<f32>((bitcast<u32>(_e1370) & 2147483647u));
                                                                let _e1401 = select(_e1399, _e1396, (_e1396 > _e1399));
                                                                let _e1404 = bitcast<f32>((bitcast<u32>(_e1372) & 2147483647u));
                                                                let _e1407 = bitcast<f32>((bitcast<u32>(_e1373) & 2147483647u));
                                                                let _e1409 = select(_e1407, _e1404, (_e1404 > _e1407));
                                                                let _e1412 = bitcast<f32>((bitcast<u32>(_e1374) & 2147483647u));
                                                                let _e1414 = select(_e1412, _e1409, (_e1409 > _e1412));
                                                                let _e1416 = select(_e1401, _e1388, (_e1388 > _e1401));
                                                                let _e1418 = select(_e1414, _e1416, (_e1416 > _e1414));
                                                                if (_e1388 == _e1418) {
                                                                    phi_2801_ = _e1371;
                                                                    phi_2802_ = _e1375;
                                                                } else {
                                                                    let _e1421 = vec3((_e1401 == _e1418));
                                                                    phi_2801_ = select(_e1367, _e1375, _e1421);
                                                                    phi_2802_ = select(_e1371, _e1367, _e1421);
                                                                }
                                                                let _e1425 = phi_2801_;
                                                                let _e1427 = phi_2802_;
                                                                let _e1434 = ((_e1425.y * _e1427.z) - (_e1427.y * _e1425.z));
                                                                let _e1439 = ((_e1425.z * _e1427.x) - (_e1427.z * _e1425.x));
                                                                let _e1442 = ((_e1425.x * _e1427.y) - (_e1427.x * _e1425.y));
                                                                if (_e1284 >= _e1288) {
                                                                    phi_2833_ = select(true, false, (_e1284 >= _e1292));
                                                                } else {
                                                                    phi_2833_ = true;
                                                                }
                                                                let _e1447 = phi_2833_;
                                                                if _e1447 {
                                                                    phi_2842_ = select(vec3<f32>(_e1221[2][0], _e1221[2][1], _e1221[2][2]), vec3<f32>(_e1221[1][0], _e1221[1][1], _e1221[1][2]), vec3((_e1288 >= _e1292)));
                                                                } else {
                                                                    phi_2842_ = vec3<f32>(_e1221[0][0], _e1221[0][1], _e1221[0][2]);
                                                                }
                                                                let _e1452 = phi_2842_;
                                                                let _e1469 = ((((_e1434 * (_e1452.x - _e309)) + (_e1439 * (_e1452.y - _e348))) + (_e1442 * (_e1452.z - _e386))) / (((_e1434 * _e334) + (_e1439 * _e372)) + (_e1442 * _e410)));
                                                                let _e1471 = select(_e1351, _e1469, (_e1469 < _e1351));
                                                                let _e1473 = select(_e1343, _e1471, (_e1471 > _e1343));
                                                                if (_e1473 >= _e460) {
                                                                    let _e1475 = (_e1473 <= _e1015.member.member_1);
                                                                    if _e1475 {
                                                                        let _e1476 = (1f / _e1294);
                                                                        phi_2882_ = type_28(_e1473, (_e1288 * _e1476), (_e1292 * _e1476), _e1081);
                                                                    } else {
                                                                        phi_2882_ = type_28();
                                                                    }
                                                                    let _e1481 = phi_2882_;
                                                                    phi_2884_ = _e1481;
                                                                    phi_2885_ = select(true, false, _e1475);
                                                                } else {
                                                                    phi_2884_ = type_28();
                                                                    phi_2885_ = true;
                                                                }
                                                                let _e1484 = phi_2884_;
                                                                let _e1486 = phi_2885_;
                                                                if _e1486 {
                                                                    phi_2889_ = type_28(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                } else {
                                                                    phi_2889_ = _e1484;
                                                                }
                                                                let _e1488 = phi_2889_;
                                                                phi_2890_ = _e1488;
                                                            }
                                                            let _e1490 = phi_2890_;
                                                            phi_2891_ = _e1490;
                                                            phi_2892_ = _e1360;
                                                        }
                                                        let _e1492 = phi_2891_;
                                                        let _e1494 = phi_2892_;
                                                        phi_2896_ = _e1492;
                                                        phi_2897_ = _e1494;
                                                    }
                                                    let _e1496 = phi_2896_;
                                                    let _e1498 = phi_2897_;
                                                    phi_2901_ = _e1496;
                                                    phi_2902_ = _e1498;
                                                } else {
                                                    phi_2901_ = type_28();
                                                    phi_2902_ = true;
                                                }
                                                let _e1500 = phi_2901_;
                                                let _e1502 = phi_2902_;
                                                if _e1502 {
                                                    phi_2906_ = type_28(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                } else {
                                                    phi_2906_ = _e1500;
                                                }
                                                let _e1504 = phi_2906_;
                                                if (_e1504.member_3 != 4294967295u) {
                                                    if (_e1081 != 4294967295u) {
                                                        if (_e1504.member < _e1015.member.member.member) {
                                                            phi_2932_ = true;
                                                        } else {
                                                            if (_e1504.member == _e1015.member.member.member) {
                                                                phi_2931_ = (_e1504.member_3 < _e1015.member.member.member_3);
                                                            } else {
                                                                phi_2931_ = false;
                                                            }
                                                            let _e1519 = phi_2931_;
                                                            phi_2932_ = _e1519;
                                                        }
                                                        let _e1521 = phi_2932_;
                                                        if _e1521 {
                                                            phi_2939_ = type_42(type_36(_e1504, _e1504.member), _e1042.member_1, _e1042.member_2);
                                                        } else {
                                                            phi_2939_ = _e1042;
                                                        }
                                                        let _e1528 = phi_2939_;
                                                        phi_2940_ = _e1528;
                                                    } else {
                                                        phi_2940_ = _e1042;
                                                    }
                                                    let _e1530 = phi_2940_;
                                                    phi_2941_ = _e1530;
                                                } else {
                                                    phi_2941_ = _e1042;
                                                }
                                                let _e1532 = phi_2941_;
                                                phi_4573_ = _e1220;
                                                phi_1972_ = _e1532;
                                            } else {
                                                phi_4573_ = _e1013;
                                                phi_1972_ = type_42();
                                            }
                                            let _e1534 = phi_4573_;
                                            let _e1536 = phi_1972_;
                                            continue;
                                            continuing {
                                                phi_4514_ = _e1534;
                                                phi_1971_ = _e1536;
                                                phi_1974_ = _e1030;
                                                phi_4572_ = _e1534;
                                                break if !(_e1036);
                                            }
                                        }
                                        let _e1539 = phi_4572_;
                                        phi_4631_ = _e1539;
                                        if _e1539 {
                                            break;
                                        }
                                        phi_4635_ = _e1539;
                                        let _e1717 = local_9;
                                        phi_4282_ = _e1717;
                                        phi_4283_ = _e535;
                                        phi_4284_ = false;
                                        phi_4285_ = _e539;
                                    } else {
                                        if (_e535.member_1 >= _e89) {
                                            phi_3882_ = type_56(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), type_53(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u), type_53(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u));
                                        } else {
                                            if (_e535.member_1 < _e89) {
                                            } else {
                                                phi_4631_ = true;
                                                break;
                                            }
                                            let _e558 = ((1u + _e260) % 4u);
                                            if (_e558 < 4u) {
                                            } else {
                                                phi_4631_ = true;
                                                break;
                                            }
                                            let _e563 = global_3.member[_e535.member_1][_e558];
                                            let _e565 = ((1u + _e259) % 4u);
                                            if (_e565 < 4u) {
                                            } else {
                                                phi_4631_ = true;
                                                break;
                                            }
                                            let _e570 = global_3.member[_e535.member_1][_e565];
                                            let _e572 = ((1u + _e261) % 4u);
                                            if (_e572 < 4u) {
                                            } else {
                                                phi_4631_ = true;
                                                break;
                                            }
                                            let _e577 = global_3.member[_e535.member_1][_e572];
                                            let _e579 = ((_e260 + 1u) % 4u);
                                            if (_e579 < 4u) {
                                            } else {
                                                phi_4631_ = true;
                                                break;
                                            }
                                            let _e584 = global_3.member[_e535.member_1][_e579];
                                            let _e586 = (_e584 >> bitcast<u32>(11u));
                                            let _e588 = ((_e259 + 1u) % 4u);
                                            if (_e588 < 4u) {
                                            } else {
                                                phi_4631_ = true;
                                                break;
                                            }
                                            let _e593 = global_3.member[_e535.member_1][_e588];
                                            let _e595 = (_e593 >> bitcast<u32>(11u));
                                            let _e597 = ((_e261 + 1u) % 4u);
                                            if (_e597 < 4u) {
                                            } else {
                                                phi_4631_ = true;
                                                break;
                                            }
                                            let _e602 = global_3.member[_e535.member_1][_e597];
                                            let _e604 = (_e602 >> bitcast<u32>(11u));
                                            let _e627 = (bitcast<f32>((bitcast<u32>((_e535.member.member_1.x - _e535.member.member.x)) & 2139095040u)) * 0.001953125f);
                                            let _e628 = (bitcast<f32>((bitcast<u32>((_e535.member.member_1.y - _e535.member.member.y)) & 2139095040u)) * 0.001953125f);
                                            let _e629 = (bitcast<f32>((bitcast<u32>((_e535.member.member_1.z - _e535.member.member.z)) & 2139095040u)) * 0.001953125f);
                                            let _e631 = select(_e140, _e627, (_e627 > _e140));
                                            let _e633 = select(_e140, _e628, (_e628 > _e140));
                                            let _e635 = select(_e140, _e629, (_e629 > _e140));
                                            let _e660 = bitcast<u32>((f32(bitcast<i32>((_e563 & 1023u))) * _e631));
                                            let _e665 = (bitcast<i32>((_e563 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e668 = bitcast<f32>((_e660 & bitcast<u32>(_e665)));
                                            let _e669 = bitcast<u32>((f32(bitcast<i32>((_e570 & 1023u))) * _e633));
                                            let _e674 = (bitcast<i32>((_e570 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e677 = bitcast<f32>((_e669 & bitcast<u32>(_e674)));
                                            let _e678 = bitcast<u32>((f32(bitcast<i32>((_e577 & 1023u))) * _e635));
                                            let _e683 = (bitcast<i32>((_e577 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e686 = bitcast<f32>((_e678 & bitcast<u32>(_e683)));
                                            let _e690 = bitcast<f32>((_e660 & bitcast<u32>(~(_e665))));
                                            let _e694 = bitcast<f32>((_e669 & bitcast<u32>(~(_e674))));
                                            let _e698 = bitcast<f32>((_e678 & bitcast<u32>(~(_e683))));
                                            let _e699 = bitcast<u32>((f32(bitcast<i32>((_e586 & 1023u))) * _e631));
                                            let _e704 = (bitcast<i32>((_e586 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e707 = bitcast<f32>((_e699 & bitcast<u32>(_e704)));
                                            let _e708 = bitcast<u32>((f32(bitcast<i32>((_e595 & 1023u))) * _e633));
                                            let _e713 = (bitcast<i32>((_e595 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e716 = bitcast<f32>((_e708 & bitcast<u32>(_e713)));
                                            let _e717 = bitcast<u32>((f32(bitcast<i32>((_e604 & 1023u))) * _e635));
                                            let _e722 = (bitcast<i32>((_e604 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e725 = bitcast<f32>((_e717 & bitcast<u32>(_e722)));
                                            let _e729 = bitcast<f32>((_e699 & bitcast<u32>(~(_e704))));
                                            let _e733 = bitcast<f32>((_e708 & bitcast<u32>(~(_e713))));
                                            let _e737 = bitcast<f32>((_e717 & bitcast<u32>(~(_e722))));
                                            let _e738 = (_e535.member.member.x + _e668);
                                            let _e739 = (_e535.member.member.y + _e677);
                                            let _e740 = (_e535.member.member.z + _e686);
                                            let _e743 = (_e535.member.member_1.x - _e707);
                                            let _e744 = (_e535.member.member_1.y - _e716);
                                            let _e745 = (_e535.member.member_1.z - _e725);
                                            let _e764 = (_e743 - _e738);
                                            let _e765 = (_e744 - _e739);
                                            let _e766 = (_e745 - _e740);
                                            let _e768 = select(_e765, _e764, (_e764 > _e765));
                                            let _e770 = select(_e766, _e768, (_e768 > _e766));
                                            if (_e770 < (1024f * _e140)) {
                                                phi_3583_ = 0u;
                                            } else {
                                                phi_3583_ = select(2u, 1u, (_e770 < (2097152f * _e140)));
                                            }
                                            let _e777 = phi_3583_;
                                            switch bitcast<i32>(_e777) {
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
                                            let _e780 = phi_3589_;
                                            let _e786 = global_3.member[_e535.member_1][0u];
                                            let _e790 = global_3.member[_e535.member_1][1u];
                                            let _e794 = global_3.member[_e535.member_1][2u];
                                            let _e798 = global_3.member[_e535.member_1][3u];
                                            let _e810 = (((_e790 >> bitcast<u32>(22i)) | ((_e794 >> bitcast<u32>(22i)) << bitcast<u32>(10i))) | ((_e798 >> bitcast<u32>(22i)) << bitcast<u32>(20i)));
                                            let _e811 = (_e786 & 268435455u);
                                            let _e812 = (_e810 & 268435455u);
                                            let _e815 = ((_e786 >> bitcast<u32>(28u)) & 7u);
                                            let _e823 = ((_e786 >> bitcast<u32>(31i)) | (((_e810 >> bitcast<u32>(28u)) & 3u) << bitcast<u32>(1i)));
                                            let _e824 = (_e815 != 0u);
                                            if (_e815 == 0u) {
                                                phi_3844_ = _e811;
                                            } else {
                                                if (_e815 == 7u) {
                                                    phi_3843_ = 2147483648u;
                                                } else {
                                                    phi_3843_ = ((2147483648u | (_e815 << bitcast<u32>(28u))) | (_e812 & 268435455u));
                                                }
                                                let _e833 = phi_3843_;
                                                phi_3844_ = _e833;
                                            }
                                            let _e835 = phi_3844_;
                                            if _e824 {
                                                let _e836 = (_e815 != 7u);
                                                if _e836 {
                                                    phi_3854_ = (_e812 + (_e815 * ((3u * _e780) + 1u)));
                                                } else {
                                                    phi_3854_ = u32();
                                                }
                                                let _e840 = phi_3854_;
                                                phi_3856_ = _e840;
                                                phi_3857_ = select(true, false, _e836);
                                            } else {
                                                phi_3856_ = u32();
                                                phi_3857_ = true;
                                            }
                                            let _e843 = phi_3856_;
                                            let _e845 = phi_3857_;
                                            if (_e823 == 0u) {
                                                phi_3878_ = (_e811 + select(0u, 1u, !(_e824)));
                                            } else {
                                                if (_e823 == 7u) {
                                                    phi_3877_ = 2147483648u;
                                                } else {
                                                    phi_3877_ = ((2147483648u | (_e823 << bitcast<u32>(28u))) | (select(_e843, _e812, _e845) & 268435455u));
                                                }
                                                let _e858 = phi_3877_;
                                                phi_3878_ = _e858;
                                            }
                                            let _e860 = phi_3878_;
                                            phi_3882_ = type_56(array<vec4<f32>, 3>(vec4<f32>(_e738, (_e535.member.member.x + _e690), _e743, (_e535.member.member_1.x - _e729)), vec4<f32>(_e739, (_e535.member.member.y + _e694), _e744, (_e535.member.member_1.y - _e733)), vec4<f32>(_e740, (_e535.member.member.z + _e698), _e745, (_e535.member.member_1.z - _e737))), type_53(type_32((_e535.member.member + vec4<f32>(_e668, _e677, _e686, 0f)), (_e535.member.member_1 - vec4<f32>(_e707, _e716, _e725, 0f))), _e835), type_53(type_32((_e535.member.member + vec4<f32>(_e690, _e694, _e698, 0f)), (_e535.member.member_1 - vec4<f32>(_e729, _e733, _e737, 0f))), _e860));
                                        }
                                        let _e865 = phi_3882_;
                                        let _e878 = ((_e865.member[0].x - _e332) * _e337);
                                        let _e879 = ((_e865.member[0].y - _e332) * _e337);
                                        let _e880 = ((_e865.member[0].z - _e333) * _e337);
                                        let _e881 = ((_e865.member[0].w - _e333) * _e337);
                                        let _e891 = ((_e865.member[1].x - _e370) * _e375);
                                        let _e892 = ((_e865.member[1].y - _e370) * _e375);
                                        let _e893 = ((_e865.member[1].z - _e371) * _e375);
                                        let _e894 = ((_e865.member[1].w - _e371) * _e375);
                                        let _e904 = ((_e865.member[2].x - _e408) * _e413);
                                        let _e905 = ((_e865.member[2].y - _e408) * _e413);
                                        let _e906 = ((_e865.member[2].z - _e409) * _e413);
                                        let _e907 = ((_e865.member[2].w - _e409) * _e413);
                                        let _e909 = select(_e906, _e904, (_e904 < _e906));
                                        let _e911 = select(_e907, _e905, (_e905 < _e907));
                                        let _e913 = select(_e906, _e904, (_e904 > _e906));
                                        let _e915 = select(_e907, _e905, (_e905 > _e907));
                                        let _e917 = select(_e880, _e878, (_e878 < _e880));
                                        let _e919 = select(_e881, _e879, (_e879 < _e881));
                                        let _e921 = select(_e893, _e891, (_e891 < _e893));
                                        let _e923 = select(_e894, _e892, (_e892 < _e894));
                                        let _e925 = select(_e921, _e917, (_e917 > _e921));
                                        let _e927 = select(_e923, _e919, (_e919 > _e923));
                                        let _e929 = select(_e909, _e925, (_e925 > _e909));
                                        let _e931 = select(_e911, _e927, (_e927 > _e911));
                                        let _e933 = select(_e880, _e878, (_e878 > _e880));
                                        let _e935 = select(_e881, _e879, (_e879 > _e881));
                                        let _e937 = select(_e893, _e891, (_e891 > _e893));
                                        let _e939 = select(_e894, _e892, (_e892 > _e894));
                                        let _e941 = select(_e937, _e933, (_e933 < _e937));
                                        let _e943 = select(_e939, _e935, (_e935 < _e939));
                                        let _e948 = -(_e909);
                                        let _e949 = -(_e911);
                                        let _e956 = (select(_e913, _e941, (_e941 < _e913)) + (select(_e948, _e913, (_e913 > _e948)) * 0.0000019073523f));
                                        let _e957 = (select(_e915, _e943, (_e943 < _e915)) + (select(_e949, _e915, (_e915 > _e949)) * 0.0000019073523f));
                                        let _e959 = select(_e460, _e929, (_e929 > _e460));
                                        let _e961 = select(_e460, _e931, (_e931 > _e460));
                                        let _e966 = (_e959 <= select(_e505.member.member_1, _e956, (_e956 < _e505.member.member_1)));
                                        let _e967 = (_e961 <= select(_e505.member.member_1, _e957, (_e957 < _e505.member.member_1)));
                                        let _e968 = (_e959 <= _e961);
                                        if _e966 {
                                            if _e967 {
                                                if _e968 {
                                                    phi_4226_ = _e865.member_2;
                                                } else {
                                                    phi_4226_ = _e865.member_1;
                                                }
                                                let _e972 = phi_4226_;
                                                let _e973 = (_e539 % 128u);
                                                let _e974 = (_e973 < 128u);
                                                if _e974 {
                                                } else {
                                                    phi_4631_ = true;
                                                    break;
                                                }
                                                local_3[_e973] = type_53(type_32(_e972.member.member, _e972.member.member_1), _e972.member_1);
                                                if _e974 {
                                                } else {
                                                    phi_4631_ = true;
                                                    break;
                                                }
                                                local_2[_e973] = select(_e961, _e959, (_e959 > _e961));
                                                if _e968 {
                                                    phi_4259_ = _e865.member_1;
                                                } else {
                                                    phi_4259_ = _e865.member_2;
                                                }
                                                let _e989 = phi_4259_;
                                                phi_4260_ = _e989;
                                                phi_4261_ = (_e539 + 1u);
                                            } else {
                                                phi_4260_ = type_53();
                                                phi_4261_ = u32();
                                            }
                                            let _e991 = phi_4260_;
                                            let _e993 = phi_4261_;
                                            phi_4263_ = _e991;
                                            phi_4264_ = _e993;
                                            phi_4265_ = select(true, false, _e967);
                                        } else {
                                            phi_4263_ = type_53();
                                            phi_4264_ = u32();
                                            phi_4265_ = true;
                                        }
                                        let _e996 = phi_4263_;
                                        let _e998 = phi_4264_;
                                        let _e1000 = phi_4265_;
                                        if _e1000 {
                                            if _e966 {
                                                phi_4274_ = _e865.member_1;
                                            } else {
                                                phi_4274_ = _e865.member_2;
                                            }
                                            let _e1004 = phi_4274_;
                                            phi_4279_ = _e1004;
                                            phi_4280_ = select(_e967, true, _e966);
                                        } else {
                                            phi_4279_ = _e996;
                                            phi_4280_ = _e537;
                                        }
                                        let _e1007 = phi_4279_;
                                        let _e1009 = phi_4280_;
                                        phi_4635_ = _e503;
                                        phi_4282_ = type_42(_e505.member, (_e505.member_1 + 1u), _e505.member_2);
                                        phi_4283_ = _e1007;
                                        phi_4284_ = _e1009;
                                        phi_4285_ = select(_e998, _e539, _e1000);
                                    }
                                    let _e1541 = phi_4635_;
                                    let _e1543 = phi_4282_;
                                    let _e1545 = phi_4283_;
                                    let _e1547 = phi_4284_;
                                    let _e1549 = phi_4285_;
                                    phi_4634_ = _e1541;
                                    phi_4286_ = _e1543;
                                    phi_4287_ = _e1545;
                                    phi_4288_ = (_e509 - 1u);
                                    phi_4289_ = _e1547;
                                    phi_4290_ = _e1549;
                                } else {
                                    phi_4634_ = _e503;
                                    phi_4286_ = _e505;
                                    phi_4287_ = _e535;
                                    phi_4288_ = _e509;
                                    phi_4289_ = _e537;
                                    phi_4290_ = _e539;
                                }
                                let _e1551 = phi_4634_;
                                let _e1553 = phi_4286_;
                                let _e1555 = phi_4287_;
                                let _e1557 = phi_4288_;
                                let _e1559 = phi_4289_;
                                let _e1561 = phi_4290_;
                                phi_4633_ = _e1551;
                                phi_4291_ = _e1553;
                                phi_4292_ = _e1555;
                                phi_4293_ = _e1557;
                                phi_4294_ = _e1559;
                                phi_4295_ = _e1561;
                            } else {
                                phi_4633_ = _e503;
                                phi_4291_ = type_42();
                                phi_4292_ = type_53();
                                phi_4293_ = u32();
                                phi_4294_ = bool();
                                phi_4295_ = u32();
                            }
                            let _e1563 = phi_4633_;
                            let _e1565 = phi_4291_;
                            let _e1567 = phi_4292_;
                            let _e1569 = phi_4293_;
                            let _e1571 = phi_4294_;
                            let _e1573 = phi_4295_;
                            phi_4632_ = _e1563;
                            phi_1894_ = _e1565;
                            phi_1897_ = _e1567;
                            phi_1899_ = _e1569;
                            phi_1901_ = _e1571;
                            phi_1903_ = _e1573;
                            phi_4296_ = _e517;
                        } else {
                            phi_4632_ = _e503;
                            phi_1894_ = type_42();
                            phi_1897_ = type_53();
                            phi_1899_ = u32();
                            phi_1901_ = bool();
                            phi_1903_ = u32();
                            phi_4296_ = false;
                        }
                        let _e1575 = phi_4632_;
                        let _e1577 = phi_1894_;
                        let _e1579 = phi_1897_;
                        let _e1581 = phi_1899_;
                        let _e1583 = phi_1901_;
                        let _e1585 = phi_1903_;
                        let _e1587 = phi_4296_;
                        continue;
                        continuing {
                            phi_4517_ = _e1575;
                            phi_1893_ = _e1577;
                            phi_1896_ = _e1579;
                            phi_1898_ = _e1581;
                            phi_1900_ = _e1583;
                            phi_1902_ = _e1585;
                            phi_4631_ = _e1575;
                            break if !(_e1587);
                        }
                    }
                    let _e1590 = phi_4631_;
                    if _e1590 {
                        break;
                    }
                    let _e1592 = local_7;
                    let _e1595 = local_8;
                    if _e148 {
                    } else {
                        break;
                    }
                    global_6.member[_e146][0u] = _e1592.member_1;
                    global_6.member[_e146][1u] = _e1595.member_2;
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn trace_counted_q10_lattice(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
