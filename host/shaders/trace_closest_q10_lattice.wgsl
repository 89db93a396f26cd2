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
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: u32,
}

struct type_26 {
    member: array<type_24>,
}

struct type_28 {
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
    member: type_24,
    member_1: f32,
}

struct type_40 {
    member: array<type_28>,
}

struct type_43 {
    member: array<vec4<u32>, 2>,
}

struct type_52 {
    member: type_32,
    member_1: u32,
}

struct type_55 {
    member: array<vec4<f32>, 3>,
    member_1: type_52,
    member_2: type_52,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_1: type_16;
@group(0) @binding(1) 
var<uniform> global_2: type_43;
@group(0) @binding(2) 
var<storage> global_3: type_13;
@group(0) @binding(4) 
var<storage> global_4: type_40;
@group(0) @binding(3) 
var<storage> global_5: type_4;
@group(0) @binding(5) 
var<storage, read_write> global_6: type_26;

fn function_() {
    var local: array<i32, 3>;
    var local_1: array<i32, 3>;
    var local_2: array<f32, 128>;
    var local_3: array<type_52, 128>;
    var local_4: array<u32, 3>;
    var local_5: array<array<f32, 3>, 3>;
    var local_6: array<f32, 4>;
    var phi_401_: i32;
    var phi_402_: i32;
    var phi_412_: bool;
    var phi_422_: u32;
    var phi_423_: u32;
    var phi_425_: bool;
    var phi_430_: u32;
    var phi_443_: i32;
    var phi_463_: i32;
    var phi_481_: f32;
    var phi_487_: f32;
    var phi_498_: f32;
    var phi_504_: f32;
    var phi_527_: f32;
    var phi_538_: f32;
    var phi_547_: f32;
    var phi_553_: f32;
    var phi_564_: f32;
    var phi_570_: f32;
    var phi_593_: f32;
    var phi_604_: f32;
    var phi_613_: f32;
    var phi_619_: f32;
    var phi_630_: f32;
    var phi_636_: f32;
    var phi_659_: f32;
    var phi_670_: f32;
    var phi_770_: f32;
    var phi_771_: f32;
    var phi_4552_: bool;
    var phi_1891_: type_36;
    var phi_1894_: type_52;
    var phi_1896_: u32;
    var phi_1898_: bool;
    var phi_1900_: u32;
    var phi_1911_: bool;
    var phi_1948_: type_52;
    var phi_1949_: bool;
    var phi_1950_: u32;
    var phi_3574_: u32;
    var phi_3580_: u32;
    var phi_3834_: u32;
    var phi_3835_: u32;
    var phi_3845_: u32;
    var phi_3847_: u32;
    var phi_3848_: bool;
    var phi_3868_: u32;
    var phi_3869_: u32;
    var phi_3873_: type_55;
    var phi_4217_: type_52;
    var phi_4250_: type_52;
    var phi_4251_: type_52;
    var phi_4252_: u32;
    var phi_4254_: type_52;
    var phi_4255_: u32;
    var phi_4256_: bool;
    var phi_4265_: type_52;
    var phi_4270_: type_52;
    var phi_4271_: bool;
    var phi_4549_: bool;
    var phi_1969_: type_36;
    var phi_1972_: type_8;
    var phi_1973_: type_8;
    var phi_1995_: type_8;
    var phi_2036_: u32;
    var phi_2042_: u32;
    var phi_2052_: u32;
    var phi_2068_: u32;
    var phi_2105_: u32;
    var phi_2111_: u32;
    var phi_2121_: u32;
    var phi_4534_: bool;
    var phi_2137_: type_8;
    var phi_2138_: type_8;
    var phi_2161_: type_8;
    var phi_2184_: u32;
    var phi_2199_: u32;
    var phi_2202_: type_8;
    var phi_2203_: type_8;
    var phi_2226_: type_8;
    var phi_2292_: u32;
    var phi_2272_: u32;
    var phi_2273_: u32;
    var phi_2296_: f32;
    var phi_4527_: bool;
    var phi_4606_: bool;
    var phi_4605_: bool;
    var phi_2796_: vec3<f32>;
    var phi_2797_: vec3<f32>;
    var phi_2828_: bool;
    var phi_2837_: vec3<f32>;
    var phi_2877_: type_24;
    var phi_2879_: type_24;
    var phi_2880_: bool;
    var phi_2884_: type_24;
    var phi_2885_: type_24;
    var phi_2886_: type_24;
    var phi_2887_: bool;
    var phi_2891_: type_24;
    var phi_2892_: bool;
    var phi_2896_: type_24;
    var phi_2897_: bool;
    var phi_2901_: type_24;
    var phi_2926_: bool;
    var phi_2927_: bool;
    var phi_2933_: type_36;
    var phi_2934_: type_36;
    var phi_2935_: type_36;
    var phi_4608_: bool;
    var phi_1970_: type_36;
    var phi_4607_: bool;
    var phi_4670_: bool;
    var phi_4273_: type_36;
    var phi_4274_: type_52;
    var phi_4275_: bool;
    var phi_4276_: u32;
    var phi_4669_: bool;
    var phi_4277_: type_36;
    var phi_4278_: type_52;
    var phi_4279_: u32;
    var phi_4280_: bool;
    var phi_4281_: u32;
    var phi_4668_: bool;
    var phi_4282_: type_36;
    var phi_4283_: type_52;
    var phi_4284_: u32;
    var phi_4285_: bool;
    var phi_4286_: u32;
    var phi_4667_: bool;
    var phi_1892_: type_36;
    var phi_1895_: type_52;
    var phi_1897_: u32;
    var phi_1899_: bool;
    var phi_1901_: u32;
    var phi_4287_: bool;
    var phi_4666_: bool;
    var local_7: type_36;
    var phi_4339_: type_24;
    var local_8: type_36;

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
                            phi_401_ = (bitcast<i32>((_e225 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_401_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e225)), 32u, (_e225 == 0u))));
                        }
                        let _e239 = phi_401_;
                        phi_402_ = _e239;
                    } else {
                        phi_402_ = 0i;
                    }
                    let _e241 = phi_402_;
                    let _e242 = (_e158 == _e197);
                    if _e242 {
                        phi_412_ = true;
                    } else {
                        phi_412_ = (_e165 == _e197);
                    }
                    let _e245 = phi_412_;
                    let _e246 = select(1u, 0u, _e242);
                    if _e245 {
                        let _e247 = (_e246 + 1u);
                        phi_422_ = _e247;
                        phi_423_ = _e247;
                        phi_425_ = select(true, false, (_e247 == 2u));
                    } else {
                        phi_422_ = u32();
                        phi_423_ = 0u;
                        phi_425_ = true;
                    }
                    let _e251 = phi_422_;
                    let _e253 = phi_423_;
                    let _e255 = phi_425_;
                    if _e255 {
                        phi_430_ = (_e253 + 1u);
                    } else {
                        phi_430_ = 0u;
                    }
                    let _e259 = phi_430_;
                    let _e260 = select(_e251, _e253, _e255);
                    let _e261 = select(_e246, select(2u, _e246, _e245), _e255);
                    if (_e128 < -126i) {
                        phi_443_ = -126i;
                    } else {
                        phi_443_ = select(_e128, 127i, (_e128 > 127i));
                    }
                    let _e266 = phi_443_;
                    let _e271 = bitcast<f32>((bitcast<u32>((_e266 + 127i)) << bitcast<u32>(23i)));
                    let _e277 = bitcast<f32>((bitcast<u32>(((_e128 - _e266) + 127i)) << bitcast<u32>(23i)));
                    let _e278 = -(_e241);
                    if (_e278 < -126i) {
                        phi_463_ = -126i;
                    } else {
                        phi_463_ = select(_e278, 127i, (_e278 > 127i));
                    }
                    let _e283 = phi_463_;
                    let _e288 = bitcast<f32>((bitcast<u32>((_e283 + 127i)) << bitcast<u32>(23i)));
                    let _e294 = bitcast<f32>((bitcast<u32>(((_e278 - _e283) + 127i)) << bitcast<u32>(23i)));
                    let _e298 = global_4.member[_e146].member;
                    let _e299 = (_e260 == 0u);
                    if _e299 {
                        phi_481_ = _e298[0];
                    } else {
                        phi_481_ = _e298[1];
                    }
                    let _e303 = phi_481_;
                    let _e304 = (_e260 == 2u);
                    if _e304 {
                        phi_487_ = _e298[2];
                    } else {
                        phi_487_ = _e303;
                    }
                    let _e307 = phi_487_;
                    let _e309 = ((_e307 * _e271) * _e277);
                    let _e310 = global_4.member[_e146].member_2;
                    if _e299 {
                        phi_498_ = _e310[0];
                    } else {
                        phi_498_ = _e310[1];
                    }
                    let _e314 = phi_498_;
                    if _e304 {
                        phi_504_ = _e310[2];
                    } else {
                        phi_504_ = _e314;
                    }
                    let _e317 = phi_504_;
                    let _e319 = ((_e317 * _e288) * _e294);
                    let _e323 = (bitcast<f32>((bitcast<u32>(_e319) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e323 {
                        let _e327 = (bitcast<f32>((bitcast<u32>(_e309) & 2147483647u)) * 0.00000011920929f);
                        phi_527_ = select(0.00000000000011368684f, _e327, (_e327 > 0.00000000000011368684f));
                    } else {
                        phi_527_ = 0f;
                    }
                    let _e331 = phi_527_;
                    let _e332 = (_e309 + _e331);
                    let _e333 = (_e309 - _e331);
                    let _e334 = select(_e319, 0f, _e323);
                    if _e323 {
                        phi_538_ = 38685626000000000000000000f;
                    } else {
                        phi_538_ = (1f / _e319);
                    }
                    let _e337 = phi_538_;
                    let _e338 = (_e259 == 0u);
                    if _e338 {
                        phi_547_ = _e298[0];
                    } else {
                        phi_547_ = _e298[1];
                    }
                    let _e342 = phi_547_;
                    let _e343 = (_e259 == 2u);
                    if _e343 {
                        phi_553_ = _e298[2];
                    } else {
                        phi_553_ = _e342;
                    }
                    let _e346 = phi_553_;
                    let _e348 = ((_e346 * _e271) * _e277);
                    if _e338 {
                        phi_564_ = _e310[0];
                    } else {
                        phi_564_ = _e310[1];
                    }
                    let _e352 = phi_564_;
                    if _e343 {
                        phi_570_ = _e310[2];
                    } else {
                        phi_570_ = _e352;
                    }
                    let _e355 = phi_570_;
                    let _e357 = ((_e355 * _e288) * _e294);
                    let _e361 = (bitcast<f32>((bitcast<u32>(_e357) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e361 {
                        let _e365 = (bitcast<f32>((bitcast<u32>(_e348) & 2147483647u)) * 0.00000011920929f);
                        phi_593_ = select(0.00000000000011368684f, _e365, (_e365 > 0.00000000000011368684f));
                    } else {
                        phi_593_ = 0f;
                    }
                    let _e369 = phi_593_;
                    let _e370 = (_e348 + _e369);
                    let _e371 = (_e348 - _e369);
                    let _e372 = select(_e357, 0f, _e361);
                    if _e361 {
                        phi_604_ = 38685626000000000000000000f;
                    } else {
                        phi_604_ = (1f / _e357);
                    }
                    let _e375 = phi_604_;
                    let _e376 = (_e261 == 0u);
                    if _e376 {
                        phi_613_ = _e298[0];
                    } else {
                        phi_613_ = _e298[1];
                    }
                    let _e380 = phi_613_;
                    let _e381 = (_e261 == 2u);
                    if _e381 {
                        phi_619_ = _e298[2];
                    } else {
                        phi_619_ = _e380;
                    }
                    let _e384 = phi_619_;
                    let _e386 = ((_e384 * _e271) * _e277);
                    if _e376 {
                        phi_630_ = _e310[0];
                    } else {
                        phi_630_ = _e310[1];
                    }
                    let _e390 = phi_630_;
                    if _e381 {
                        phi_636_ = _e310[2];
                    } else {
                        phi_636_ = _e390;
                    }
                    let _e393 = phi_636_;
                    let _e395 = ((_e393 * _e288) * _e294);
                    let _e399 = (bitcast<f32>((bitcast<u32>(_e395) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e399 {
                        let _e403 = (bitcast<f32>((bitcast<u32>(_e386) & 2147483647u)) * 0.00000011920929f);
                        phi_659_ = select(0.00000000000011368684f, _e403, (_e403 > 0.00000000000011368684f));
                    } else {
                        phi_659_ = 0f;
                    }
                    let _e407 = phi_659_;
                    let _e408 = (_e386 + _e407);
                    let _e409 = (_e386 - _e407);
                    let _e410 = select(_e395, 0f, _e399);
                    if _e399 {
                        phi_670_ = 38685626000000000000000000f;
                    } else {
                        phi_670_ = (1f / _e395);
                    }
                    let _e413 = phi_670_;
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
                        phi_770_ = select(-340282350000000000000000000000000000000f, _e454, (_e454 > -340282350000000000000000000000000000000f));
                        phi_771_ = select(-340282350000000000000000000000000000000f, _e447, (_e447 > -340282350000000000000000000000000000000f));
                    } else {
                        phi_770_ = 0f;
                        phi_771_ = 1f;
                    }
                    let _e458 = phi_770_;
                    let _e460 = phi_771_;
                    local_3 = array<type_52, 128>(type_52(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u));
                    local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    let _e464 = (_e260 % 3u);
                    let _e465 = (_e464 < 3u);
                    if _e465 {
                    } else {
                        break;
                    }
                    let _e467 = local_1[_e464];
                    let _e470 = (_e259 % 3u);
                    let _e471 = (_e470 < 3u);
                    if _e471 {
                    } else {
                        break;
                    }
                    let _e473 = local_1[_e470];
                    let _e476 = (_e261 % 3u);
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
                    phi_4552_ = false;
                    phi_1891_ = type_36(type_24(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e458);
                    phi_1894_ = type_52(type_32(vec4<f32>((f32(_e467) * _e140), (f32(_e473) * _e140), (f32(_e479) * _e140), 0f), vec4<f32>((f32(_e484) * _e140), (f32(_e488) * _e140), (f32(_e492) * _e140), 0f)), select(0u, 2147483648u, (_e89 == 0u)));
                    phi_1896_ = ((3u * _e89) + 1u);
                    phi_1898_ = (_e460 <= _e458);
                    phi_1900_ = 0u;
                    loop {
                        let _e502 = phi_4552_;
                        let _e504 = phi_1891_;
                        let _e506 = phi_1894_;
                        let _e508 = phi_1896_;
                        let _e510 = phi_1898_;
                        let _e512 = phi_1900_;
                        local_7 = _e504;
                        if _e510 {
                            phi_1911_ = true;
                        } else {
                            phi_1911_ = (_e512 > 0u);
                        }
                        let _e515 = phi_1911_;
                        if _e515 {
                            let _e516 = (_e508 > 0u);
                            if _e516 {
                                if _e510 {
                                    phi_1948_ = _e506;
                                    phi_1949_ = _e510;
                                    phi_1950_ = _e512;
                                } else {
                                    let _e517 = (_e512 - 1u);
                                    let _e518 = (_e517 % 128u);
                                    let _e519 = (_e518 < 128u);
                                    if _e519 {
                                    } else {
                                        phi_4666_ = true;
                                        break;
                                    }
                                    let _e521 = local_3[_e518];
                                    if _e519 {
                                    } else {
                                        phi_4666_ = true;
                                        break;
                                    }
                                    let _e529 = local_2[_e518];
                                    phi_1948_ = type_52(type_32(_e521.member.member, _e521.member.member_1), _e521.member_1);
                                    phi_1949_ = (_e529 <= _e504.member_1);
                                    phi_1950_ = _e517;
                                }
                                let _e533 = phi_1948_;
                                let _e535 = phi_1949_;
                                let _e537 = phi_1950_;
                                if _e535 {
                                    let _e542 = (_e533.member_1 & 268435455u);
                                    if ((_e533.member_1 & 2147483648u) != 0u) {
                                        phi_4549_ = _e502;
                                        phi_1969_ = _e504;
                                        phi_1972_ = type_8(0u, ((_e533.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e1004 = phi_4549_;
                                            let _e1006 = phi_1969_;
                                            let _e1008 = phi_1972_;
                                            local_8 = _e1006;
                                            if (_e1008.member < _e1008.member_1) {
                                                phi_1973_ = type_8((_e1008.member + 1u), _e1008.member_1);
                                                phi_1995_ = type_8(1u, _e1008.member);
                                            } else {
                                                phi_1973_ = _e1008;
                                                phi_1995_ = type_8(0u, type_8().member_1);
                                            }
                                            let _e1021 = phi_1973_;
                                            let _e1023 = phi_1995_;
                                            let _e1027 = (bitcast<i32>(_e1023.member) != 0i);
                                            if _e1027 {
                                                let _e1032 = (_e533.member.member_1.x - _e533.member.member.x);
                                                let _e1035 = (_e533.member.member_1.y - _e533.member.member.y);
                                                let _e1038 = (_e533.member.member_1.z - _e533.member.member.z);
                                                let _e1040 = select(_e1035, _e1032, (_e1032 > _e1035));
                                                let _e1042 = select(_e1038, _e1040, (_e1040 > _e1038));
                                                let _e1044 = (_e1042 < (1024f * _e140));
                                                if _e1044 {
                                                    phi_2036_ = 0u;
                                                } else {
                                                    phi_2036_ = select(2u, 1u, (_e1042 < (2097152f * _e140)));
                                                }
                                                let _e1049 = phi_2036_;
                                                switch bitcast<i32>(_e1049) {
                                                    case 0: {
                                                        phi_2042_ = 1u;
                                                        break;
                                                    }
                                                    case 1: {
                                                        phi_2042_ = 2u;
                                                        break;
                                                    }
                                                    case 2: {
                                                        phi_2042_ = 3u;
                                                        break;
                                                    }
                                                    default: {
                                                        phi_2042_ = u32();
                                                        break;
                                                    }
                                                }
                                                let _e1052 = phi_2042_;
                                                switch bitcast<i32>(_e1049) {
                                                    case 0: {
                                                        phi_2052_ = 1u;
                                                        break;
                                                    }
                                                    case 1: {
                                                        phi_2052_ = 2u;
                                                        break;
                                                    }
                                                    case 2: {
                                                        phi_2052_ = 3u;
                                                        break;
                                                    }
                                                    default: {
                                                        phi_2052_ = u32();
                                                        break;
                                                    }
                                                }
                                                let _e1059 = phi_2052_;
                                                let _e1061 = ((_e542 + (_e1023.member_1 * ((3u * _e1052) + 1u))) + (3u * _e1059));
                                                let _e1062 = (_e1061 < _e92);
                                                if _e1062 {
                                                    if _e1062 {
                                                    } else {
                                                        phi_4607_ = true;
                                                        break;
                                                    }
                                                    let _e1064 = global_5.member[_e1061];
                                                    phi_2068_ = _e1064;
                                                } else {
                                                    phi_2068_ = 4294967295u;
                                                }
                                                let _e1066 = phi_2068_;
                                                local_4 = array<u32, 3>(_e260, _e259, _e261);
                                                if _e1044 {
                                                    phi_2105_ = 0u;
                                                } else {
                                                    phi_2105_ = select(2u, 1u, (_e1042 < (2097152f * _e140)));
                                                }
                                                let _e1072 = phi_2105_;
                                                switch bitcast<i32>(_e1072) {
                                                    case 0: {
                                                        phi_2111_ = 1u;
                                                        break;
                                                    }
                                                    case 1: {
                                                        phi_2111_ = 2u;
                                                        break;
                                                    }
                                                    case 2: {
                                                        phi_2111_ = 3u;
                                                        break;
                                                    }
                                                    default: {
                                                        phi_2111_ = u32();
                                                        break;
                                                    }
                                                }
                                                let _e1075 = phi_2111_;
                                                switch bitcast<i32>(_e1072) {
                                                    case 0: {
                                                        phi_2121_ = 1u;
                                                        break;
                                                    }
                                                    case 1: {
                                                        phi_2121_ = 2u;
                                                        break;
                                                    }
                                                    case 2: {
                                                        phi_2121_ = 3u;
                                                        break;
                                                    }
                                                    default: {
                                                        phi_2121_ = u32();
                                                        break;
                                                    }
                                                }
                                                let _e1082 = phi_2121_;
                                                local_6 = array<f32, 4>(_e533.member.member.x, _e533.member.member.y, _e533.member.member.z, _e533.member.member.w);
                                                local_5[0u] = array<f32, 3>(0f, 0f, 0f);
                                                local_5[1u] = array<f32, 3>(0f, 0f, 0f);
                                                local_5[2u] = array<f32, 3>(0f, 0f, 0f);
                                                phi_4534_ = _e1004;
                                                phi_2137_ = type_8(0u, 3u);
                                                loop {
                                                    let _e1096 = phi_4534_;
                                                    let _e1098 = phi_2137_;
                                                    if (_e1098.member < _e1098.member_1) {
                                                        phi_2138_ = type_8((_e1098.member + 1u), _e1098.member_1);
                                                        phi_2161_ = type_8(1u, _e1098.member);
                                                    } else {
                                                        phi_2138_ = _e1098;
                                                        phi_2161_ = type_8(0u, type_8().member_1);
                                                    }
                                                    let _e1111 = phi_2138_;
                                                    let _e1113 = phi_2161_;
                                                    let _e1117 = (bitcast<i32>(_e1113.member) != 0i);
                                                    if _e1117 {
                                                        let _e1119 = ((_e542 + (_e1023.member_1 * ((3u * _e1075) + 1u))) + (_e1113.member_1 * _e1082));
                                                        let _e1120 = (_e1119 < _e92);
                                                        if _e1120 {
                                                            if _e1120 {
                                                            } else {
                                                                phi_4605_ = true;
                                                                break;
                                                            }
                                                            let _e1122 = global_5.member[_e1119];
                                                            phi_2184_ = _e1122;
                                                        } else {
                                                            phi_2184_ = 0u;
                                                        }
                                                        let _e1124 = phi_2184_;
                                                        let _e1125 = (_e1119 + 1u);
                                                        let _e1126 = (_e1125 < _e92);
                                                        if _e1126 {
                                                            if _e1126 {
                                                            } else {
                                                                phi_4605_ = true;
                                                                break;
                                                            }
                                                            let _e1128 = global_5.member[_e1125];
                                                            phi_2199_ = _e1128;
                                                        } else {
                                                            phi_2199_ = 0u;
                                                        }
                                                        let _e1130 = phi_2199_;
                                                        phi_2202_ = type_8(0u, 3u);
                                                        loop {
                                                            let _e1132 = phi_2202_;
                                                            if (_e1132.member < _e1132.member_1) {
                                                                phi_2203_ = type_8((_e1132.member + 1u), _e1132.member_1);
                                                                phi_2226_ = type_8(1u, _e1132.member);
                                                            } else {
                                                                phi_2203_ = _e1132;
                                                                phi_2226_ = type_8(0u, type_8().member_1);
                                                            }
                                                            let _e1145 = phi_2203_;
                                                            let _e1147 = phi_2226_;
                                                            let _e1151 = (bitcast<i32>(_e1147.member) != 0i);
                                                            if _e1151 {
                                                                let _e1152 = (_e1147.member_1 < 3u);
                                                                if _e1152 {
                                                                } else {
                                                                    phi_4527_ = true;
                                                                    break;
                                                                }
                                                                let _e1154 = local_4[_e1147.member_1];
                                                                if (_e1147.member_1 < 4u) {
                                                                } else {
                                                                    phi_4527_ = true;
                                                                    break;
                                                                }
                                                                let _e1157 = local_6[_e1147.member_1];
                                                                switch bitcast<i32>(_e1072) {
                                                                    case 0: {
                                                                        phi_2296_ = (_e1157 + (f32(((_e1124 >> bitcast<u32>(((10u * _e1154) & 31u))) & 1023u)) * _e140));
                                                                        break;
                                                                    }
                                                                    case 1: {
                                                                        if (_e1154 == 0u) {
                                                                            phi_2273_ = _e1124;
                                                                        } else {
                                                                            if (_e1154 == 1u) {
                                                                                phi_2272_ = ((_e1124 >> bitcast<u32>(21i)) | (_e1130 << bitcast<u32>(11i)));
                                                                            } else {
                                                                                phi_2272_ = (_e1130 >> bitcast<u32>(10i));
                                                                            }
                                                                            let _e1178 = phi_2272_;
                                                                            phi_2273_ = _e1178;
                                                                        }
                                                                        let _e1180 = phi_2273_;
                                                                        phi_2296_ = (_e1157 + (f32((_e1180 & 2097151u)) * _e140));
                                                                        break;
                                                                    }
                                                                    case 2: {
                                                                        let _e1159 = (_e1119 + _e1154);
                                                                        let _e1160 = (_e1159 < _e92);
                                                                        if _e1160 {
                                                                            if _e1160 {
                                                                            } else {
                                                                                phi_4527_ = true;
                                                                                break;
                                                                            }
                                                                            let _e1162 = global_5.member[_e1159];
                                                                            phi_2292_ = _e1162;
                                                                        } else {
                                                                            phi_2292_ = 0u;
                                                                        }
                                                                        let _e1164 = phi_2292_;
                                                                        phi_2296_ = (f32(bitcast<i32>(_e1164)) * _e140);
                                                                        break;
                                                                    }
                                                                    default: {
                                                                        phi_2296_ = f32();
                                                                        break;
                                                                    }
                                                                }
                                                                let _e1194 = phi_2296_;
                                                                if (_e1113.member_1 < 3u) {
                                                                } else {
                                                                    phi_4527_ = true;
                                                                    break;
                                                                }
                                                                if _e1152 {
                                                                } else {
                                                                    phi_4527_ = true;
                                                                    break;
                                                                }
                                                                local_5[_e1113.member_1][_e1147.member_1] = _e1194;
                                                            }
                                                            continue;
                                                            continuing {
                                                                phi_2202_ = _e1145;
                                                                phi_4527_ = _e1096;
                                                                break if !(_e1151);
                                                            }
                                                        }
                                                        let _e1200 = phi_4527_;
                                                        phi_4605_ = _e1200;
                                                        if _e1200 {
                                                            break;
                                                        }
                                                        phi_4606_ = _e1200;
                                                    } else {
                                                        phi_4606_ = _e1096;
                                                    }
                                                    let _e1202 = phi_4606_;
                                                    continue;
                                                    continuing {
                                                        phi_4534_ = _e1202;
                                                        phi_2137_ = _e1111;
                                                        phi_4605_ = _e1202;
                                                        break if !(_e1117);
                                                    }
                                                }
                                                let _e1205 = phi_4605_;
                                                phi_4607_ = _e1205;
                                                if _e1205 {
                                                    break;
                                                }
                                                let _e1206 = local_5;
                                                let _e1222 = (_e1206[0][2] - _e386);
                                                let _e1225 = (((_e1206[0][0] - _e309) * _e410) - (_e1222 * _e334));
                                                let _e1228 = (((_e1206[0][1] - _e348) * _e410) - (_e1222 * _e372));
                                                let _e1231 = (_e1206[1][2] - _e386);
                                                let _e1234 = (((_e1206[1][0] - _e309) * _e410) - (_e1231 * _e334));
                                                let _e1237 = (((_e1206[1][1] - _e348) * _e410) - (_e1231 * _e372));
                                                let _e1240 = (_e1206[2][2] - _e386);
                                                let _e1243 = (((_e1206[2][0] - _e309) * _e410) - (_e1240 * _e334));
                                                let _e1246 = (((_e1206[2][1] - _e348) * _e410) - (_e1240 * _e372));
                                                let _e1247 = (_e1243 * _e1237);
                                                let _e1248 = (_e1246 * _e1234);
                                                let _e1249 = (_e1225 * _e1246);
                                                let _e1250 = (_e1228 * _e1243);
                                                let _e1251 = (_e1234 * _e1228);
                                                let _e1252 = (_e1237 * _e1225);
                                                let _e1257 = (((_e1247 >= _e1248) && (_e1249 >= _e1250)) && (_e1251 >= _e1252));
                                                if (_e1257 || (((_e1247 <= _e1248) && (_e1249 <= _e1250)) && (_e1251 <= _e1252))) {
                                                    let _e1264 = select(-1f, 1f, _e1257);
                                                    let _e1266 = ((_e1247 - _e1248) * _e1264);
                                                    let _e1268 = select(0f, _e1266, (_e1266 > 0f));
                                                    let _e1270 = ((_e1249 - _e1250) * _e1264);
                                                    let _e1272 = select(0f, _e1270, (_e1270 > 0f));
                                                    let _e1274 = ((_e1251 - _e1252) * _e1264);
                                                    let _e1276 = select(0f, _e1274, (_e1274 > 0f));
                                                    let _e1278 = ((_e1268 + _e1272) + _e1276);
                                                    if (_e1278 < 0.000000000000000000000000000000000000011754944f) {
                                                        phi_2891_ = type_24();
                                                        phi_2892_ = true;
                                                    } else {
                                                        let _e1281 = select(_e1206[1][0], _e1206[0][0], (_e1206[0][0] < _e1206[1][0]));
                                                        let _e1285 = select(_e1206[1][0], _e1206[0][0], (_e1206[0][0] > _e1206[1][0]));
                                                        let _e1289 = select(_e1206[1][1], _e1206[0][1], (_e1206[0][1] < _e1206[1][1]));
                                                        let _e1293 = select(_e1206[1][1], _e1206[0][1], (_e1206[0][1] > _e1206[1][1]));
                                                        let _e1297 = select(_e1206[1][2], _e1206[0][2], (_e1206[0][2] < _e1206[1][2]));
                                                        let _e1301 = select(_e1206[1][2], _e1206[0][2], (_e1206[0][2] > _e1206[1][2]));
                                                        let _e1306 = ((select(_e1206[2][0], _e1281, (_e1281 < _e1206[2][0])) - _e332) * _e337);
                                                        let _e1307 = ((select(_e1206[2][0], _e1285, (_e1285 > _e1206[2][0])) - _e333) * _e337);
                                                        let _e1310 = ((select(_e1206[2][1], _e1289, (_e1289 < _e1206[2][1])) - _e370) * _e375);
                                                        let _e1311 = ((select(_e1206[2][1], _e1293, (_e1293 > _e1206[2][1])) - _e371) * _e375);
                                                        let _e1314 = ((select(_e1206[2][2], _e1297, (_e1297 < _e1206[2][2])) - _e408) * _e413);
                                                        let _e1315 = ((select(_e1206[2][2], _e1301, (_e1301 > _e1206[2][2])) - _e409) * _e413);
                                                        let _e1317 = select(_e1315, _e1314, (_e1314 < _e1315));
                                                        let _e1319 = select(_e1315, _e1314, (_e1314 > _e1315));
                                                        let _e1321 = select(_e1307, _e1306, (_e1306 < _e1307));
                                                        let _e1323 = select(_e1311, _e1310, (_e1310 < _e1311));
                                                        let _e1325 = select(_e1323, _e1321, (_e1321 > _e1323));
                                                        let _e1327 = select(_e1317, _e1325, (_e1325 > _e1317));
                                                        let _e1329 = select(_e1307, _e1306, (_e1306 > _e1307));
                                                        let _e1331 = select(_e1311, _e1310, (_e1310 > _e1311));
                                                        let _e1333 = select(_e1331, _e1329, (_e1329 < _e1331));
                                                        let _e1335 = select(_e1319, _e1333, (_e1333 < _e1319));
                                                        let _e1336 = -(_e1317);
                                                        let _e1342 = select(_e460, _e1327, (_e1327 > _e460));
                                                        if (_e1342 > (_e1335 + (select(_e1336, _e1319, (_e1319 > _e1336)) * 0.0000019073523f))) {
                                                            phi_2886_ = type_24();
                                                            phi_2887_ = true;
                                                        } else {
                                                            let _e1344 = (_e1342 > _e1006.member_1);
                                                            if _e1344 {
                                                                phi_2885_ = type_24();
                                                            } else {
                                                                let _e1348 = (_e1206[1][0] - _e1206[0][0]);
                                                                let _e1349 = (_e1206[1][1] - _e1206[0][1]);
                                                                let _e1350 = (_e1206[1][2] - _e1206[0][2]);
                                                                let _e1351 = vec3<f32>(_e1348, _e1349, _e1350);
                                                                let _e1352 = (_e1206[2][0] - _e1206[1][0]);
                                                                let _e1353 = (_e1206[2][1] - _e1206[1][1]);
                                                                let _e1354 = (_e1206[2][2] - _e1206[1][2]);
                                                                let _e1355 = vec3<f32>(_e1352, _e1353, _e1354);
                                                                let _e1356 = (_e1206[0][0] - _e1206[2][0]);
                                                                let _e1357 = (_e1206[0][1] - _e1206[2][1]);
                                                                let _e1358 = (_e1206[0][2] - _e1206[2][2]);
                                                                let _e1359 = vec3<f32>(_e1356, _e1357, _e1358);
                                                                let _e1362 = bitcast<f32>((bitcast<u32>(_e1348) & 2147483647u));
                                                                let _e1365 = bitcast<f32>((bitcast<u32>(_e1349) & 2147483647u));
                                                                let _e1367 = select(_e1365, _e1362, (_e1362 > _e1365));
                                                                let _e1370 = bitcast<f32>((bitcast<u32>(_e1350) & 2147483647u));
                                                                let _e1372 = select(_e1370, _e1367, (_e1367 > _e1370));
                                                                let _e1375 = bitcast<f32>((bitcast<u32>(_e1352) & 2147483647u));
                                                                let _e1378 = bitcast<f32>((bitcast<u32>(_e1353) & 2147483647u));
                                                                let _e1380 = select(_e1378, _e1375, (_e1375 > _e1378));
                                                                let _e1383 = bitcast<f32>((bitcast<u32>(_e1354) & 2147483647u));
                                                                let _e1385 = select(_e1383, _e1380, (_e1380 > _e1383));
                                                                let _e1388 = bitcast<f32>((bitcast<u32>(_e1356) & 2147483647u));
                                                                let _e1391 = bitcast<f32>((bitcast<u32>(_e1357) & 2147483647u));
                                                                let _e1393 = select(_e1391, _e1388, (_e1388 > _e1391));
                                                                let _e1396 = bitcast<f32>((bitcast<u32>(_e1358) & 2147483647u));
                                                                let _e1398 = select(_e1396, _e1393, (_e1393 > _e1396));
                                                                let _e1400 = select(_e1385, _e1372, (_e1372 > _e1385));
                                                                let _e1402 = select(_e1398, _e1400, (_e1400 > _e1398));
                                                                if (_e1372 == _e1402) {
                                                                    phi_2796_ = _e1355;
                                                                    phi_2797_ = _e1359;
                                                                } else {
                                                                    let _e1405 = vec3((_e1385 == _e1402));
                                                                    phi_2796_ = select(_e1351, _e1359, _e1405);
                                                                    phi_2797_ = select(_e1355, _e1351, _e1405);
                                                                }
                                                                let _e1409 = phi_2796_;
                                                                let _e1411 = phi_2797_;
                                                                let _e1418 = ((_e1409.y * _e1411.z) - (_e1411.y * _e1409.z));
                                                                let _e1423 = ((_e1409.z * _e1411.x) - (_e1411.z * _e1409.x));
                                                                let _e1426 = ((_e1409.x * _e1411.y) - (_e1411.x * _e1409.y));
                                                                if (_e1268 >= _e1272) {
                                                                    phi_2828_ = select(true, false, (_e1268 >= _e1276));
                                                                } else {
                                                                    phi_2828_ = true;
                                                                }
                                                                let _e1431 = phi_2828_;
                                                                if _e1431 {
                                                                    phi_2837_ = select(vec3<f32>(_e1206[2][0], _e1206[2][1], _e1206[2][2]), vec3<f32>(_e1206[1][0], _e1206[1][1], _e1206[1][2]), vec3((_e1272 >= _e1276)));
                                                                } else {
                                                                    phi_2837_ = vec3<f32>(_e1206[0][0], _e1206[0][1], _e1206[0][2]);
                                                                }
                                                                let _e1436 = phi_2837_;
                                                                let _e1453 = ((((_e1418 * (_e1436.x - _e309)) + (_e1423 * (_e1436.y - _e348))) + (_e1426 * (_e1436.z - _e386))) / (((_e1418 * _e334) + (_e1423 * _e372)) + (_e1426 * _e410)));
                                                                let _e1455 = select(_e1335, _e1453, (_e1453 < _e1335));
                                                                let _e1457 = select(_e1327, _e1455, (_e1455 > _e1327));
                                                                if (_e1457 >= _e460) {
                                                                    let _e1459 = (_e1457 <= _e1006.member_1);
                                                                    if _e1459 {
                                                                        let _e1460 = (1f / _e1278);
                                                                        phi_2877_ = type_24(_e1457, (_e1272 * _e1460), (_e1276 * _e1460), _e1066);
                                                                    } else {
                                                                        phi_2877_ = type_24();
                                                                    }
                                                                    let _e1465 = phi_2877_;
                                                                    phi_2879_ = _e1465;
                                                                    phi_2880_ = select(true, false, _e1459);
                                                                } else {
                                                                    phi_2879_ = type_24();
                                                                    phi_2880_ = true;
                                                                }
                                                                let _e1468 = phi_2879_;
                                                                let _e1470 = phi_2880_;
                                                                if _e1470 {
                                                                    phi_2884_ = type_24(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                } else {
                                                                    phi_2884_ = _e1468;
                                                                }
                                                                let _e1472 = phi_2884_;
                                                                phi_2885_ = _e1472;
                                                            }
                                                            let _e1474 = phi_2885_;
                                                            phi_2886_ = _e1474;
                                                            phi_2887_ = _e1344;
                                                        }
                                                        let _e1476 = phi_2886_;
                                                        let _e1478 = phi_2887_;
                                                        phi_2891_ = _e1476;
                                                        phi_2892_ = _e1478;
                                                    }
                                                    let _e1480 = phi_2891_;
                                                    let _e1482 = phi_2892_;
                                                    phi_2896_ = _e1480;
                                                    phi_2897_ = _e1482;
                                                } else {
                                                    phi_2896_ = type_24();
                                                    phi_2897_ = true;
                                                }
                                                let _e1484 = phi_2896_;
                                                let _e1486 = phi_2897_;
                                                if _e1486 {
                                                    phi_2901_ = type_24(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                } else {
                                                    phi_2901_ = _e1484;
                                                }
                                                let _e1488 = phi_2901_;
                                                if (_e1488.member_3 != 4294967295u) {
                                                    if (_e1066 != 4294967295u) {
                                                        if (_e1488.member < _e1006.member.member) {
                                                            phi_2927_ = true;
                                                        } else {
                                                            if (_e1488.member == _e1006.member.member) {
                                                                phi_2926_ = (_e1488.member_3 < _e1006.member.member_3);
                                                            } else {
                                                                phi_2926_ = false;
                                                            }
                                                            let _e1501 = phi_2926_;
                                                            phi_2927_ = _e1501;
                                                        }
                                                        let _e1503 = phi_2927_;
                                                        if _e1503 {
                                                            phi_2933_ = type_36(_e1488, _e1488.member);
                                                        } else {
                                                            phi_2933_ = _e1006;
                                                        }
                                                        let _e1506 = phi_2933_;
                                                        phi_2934_ = _e1506;
                                                    } else {
                                                        phi_2934_ = _e1006;
                                                    }
                                                    let _e1508 = phi_2934_;
                                                    phi_2935_ = _e1508;
                                                } else {
                                                    phi_2935_ = _e1006;
                                                }
                                                let _e1510 = phi_2935_;
                                                phi_4608_ = _e1205;
                                                phi_1970_ = _e1510;
                                            } else {
                                                phi_4608_ = _e1004;
                                                phi_1970_ = type_36();
                                            }
                                            let _e1512 = phi_4608_;
                                            let _e1514 = phi_1970_;
                                            continue;
                                            continuing {
                                                phi_4549_ = _e1512;
                                                phi_1969_ = _e1514;
                                                phi_1972_ = _e1021;
                                                phi_4607_ = _e1512;
                                                break if !(_e1027);
                                            }
                                        }
                                        let _e1517 = phi_4607_;
                                        phi_4666_ = _e1517;
                                        if _e1517 {
                                            break;
                                        }
                                        phi_4670_ = _e1517;
                                        let _e1717 = local_8;
                                        phi_4273_ = _e1717;
                                        phi_4274_ = _e533;
                                        phi_4275_ = false;
                                        phi_4276_ = _e537;
                                    } else {
                                        if (_e533.member_1 >= _e89) {
                                            phi_3873_ = type_55(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), type_52(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u), type_52(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u));
                                        } else {
                                            if (_e533.member_1 < _e89) {
                                            } else {
                                                phi_4666_ = true;
                                                break;
                                            }
                                            let _e550 = ((1u + _e260) % 4u);
                                            if (_e550 < 4u) {
                                            } else {
                                                phi_4666_ = true;
                                                break;
                                            }
                                            let _e555 = global_3.member[_e533.member_1][_e550];
                                            let _e557 = ((1u + _e259) % 4u);
                                            if (_e557 < 4u) {
                                            } else {
                                                phi_4666_ = true;
                                                break;
                                            }
                                            let _e562 = global_3.member[_e533.member_1][_e557];
                                            let _e564 = ((1u + _e261) % 4u);
                                            if (_e564 < 4u) {
                                            } else {
                                                phi_4666_ = true;
                                                break;
                                            }
                                            let _e569 = global_3.member[_e533.member_1][_e564];
                                            let _e571 = ((_e260 + 1u) % 4u);
                                            if (_e571 < 4u) {
                                            } else {
                                                phi_4666_ = true;
                                                break;
                                            }
                                            let _e576 = global_3.member[_e533.member_1][_e571];
                                            let _e578 = (_e576 >> bitcast<u32>(11u));
                                            let _e580 = ((_e259 + 1u) % 4u);
                                            if (_e580 < 4u) {
                                            } else {
                                                phi_4666_ = true;
                                                break;
                                            }
                                            let _e585 = global_3.member[_e533.member_1][_e580];
                                            let _e587 = (_e585 >> bitcast<u32>(11u));
                                            let _e589 = ((_e261 + 1u) % 4u);
                                            if (_e589 < 4u) {
                                            } else {
                                                phi_4666_ = true;
                                                break;
                                            }
                                            let _e594 = global_3.member[_e533.member_1][_e589];
                                            let _e596 = (_e594 >> bitcast<u32>(11u));
                                            let _e619 = (bitcast<f32>((bitcast<u32>((_e533.member.member_1.x - _e533.member.member.x)) & 2139095040u)) * 0.001953125f);
                                            let _e620 = (bitcast<f32>((bitcast<u32>((_e533.member.member_1.y - _e533.member.member.y)) & 2139095040u)) * 0.001953125f);
                                            let _e621 = (bitcast<f32>((bitcast<u32>((_e533.member.member_1.z - _e533.member.member.z)) & 2139095040u)) * 0.001953125f);
                                            let _e623 = select(_e140, _e619, (_e619 > _e140));
                                            let _e625 = select(_e140, _e620, (_e620 > _e140));
                                            let _e627 = select(_e140, _e621, (_e621 > _e140));
                                            let _e652 = bitcast<u32>((f32(bitcast<i32>((_e555 & 1023u))) * _e623));
                                            let _e657 = (bitcast<i32>((_e555 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e660 = bitcast<f32>((_e652 & bitcast<u32>(_e657)));
                                            let _e661 = bitcast<u32>((f32(bitcast<i32>((_e562 & 1023u))) * _e625));
                                            let _e666 = (bitcast<i32>((_e562 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e669 = bitcast<f32>((_e661 & bitcast<u32>(_e666)));
                                            let _e670 = bitcast<u32>((f32(bitcast<i32>((_e569 & 1023u))) * _e627));
                                            let _e675 = (bitcast<i32>((_e569 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e678 = bitcast<f32>((_e670 & bitcast<u32>(_e675)));
                                            let _e682 = bitcast<f32>((_e652 & bitcast<u32>(~(_e657))));
                                            let _e686 = bitcast<f32>((_e661 & bitcast<u32>(~(_e666))));
                                            let _e690 = bitcast<f32>((_e670 & bitcast<u32>(~(_e675))));
                                            let _e691 = bitcast<u32>((f32(bitcast<i32>((_e578 & 1023u))) * _e623));
                                            let _e696 = (bitcast<i32>((_e578 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e699 = bitcast<f32>((_e691 & bitcast<u32>(_e696)));
                                            let _e700 = bitcast<u32>((f32(bitcast<i32>((_e587 & 1023u))) * _e625));
                                            let _e705 = (bitcast<i32>((_e587 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e708 = bitcast<f32>((_e700 & bitcast<u32>(_e705)));
                                            let _e709 = bitcast<u32>((f32(bitcast<i32>((_e596 & 1023u))) * _e627));
                                            let _e714 = (bitcast<i32>((_e596 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e717 = bitcast<f32>((_e709 & bitcast<u32>(_e714)));
                                            let _e721 = bitcast<f32>((_e691 & bitcast<u32>(~(_e696))));
                                            let _e725 = bitcast<f32>((_e700 & bitcast<u32>(~(_e705))));
                                            let _e729 = bitcast<f32>((_e709 & bitcast<u32>(~(_e714))));
                                            let _e730 = (_e533.member.member.x + _e660);
                                            let _e731 = (_e533.member.member.y + _e669);
                                            let _e732 = (_e533.member.member.z + _e678);
                                            let _e735 = (_e533.member.member_1.x - _e699);
                                            let _e736 = (_e533.member.member_1.y - _e708);
                                            let _e737 = (_e533.member.member_1.z - _e717);
                                            let _e756 = (_e735 - _e730);
                                            let _e757 = (_e736 - _e731);
                                            let _e758 = (_e737 - _e732);
                                            let _e760 = select(_e757, _e756, (_e756 > _e757));
                                            let _e762 = select(_e758, _e760, (_e760 > _e758));
                                            if (_e762 < (1024f * _e140)) {
                                                phi_3574_ = 0u;
                                            } else {
                                                phi_3574_ = select(2u, 1u, (_e762 < (2097152f * _e140)));
                                            }
                                            let _e769 = phi_3574_;
                                            switch bitcast<i32>(_e769) {
                                                case 0: {
                                                    phi_3580_ = 1u;
                                                    break;
                                                }
                                                case 1: {
                                                    phi_3580_ = 2u;
                                                    break;
                                                }
                                                case 2: {
                                                    phi_3580_ = 3u;
                                                    break;
                                                }
                                                default: {
                                                    phi_3580_ = u32();
                                                    break;
                                                }
                                            }
                                            let _e772 = phi_3580_;
                                            let _e778 = global_3.member[_e533.member_1][0u];
                                            let _e782 = global_3.member[_e533.member_1][1u];
                                            let _e786 = global_3.member[_e533.member_1][2u];
                                            let _e790 = global_3.member[_e533.member_1][3u];
                                            let _e802 = (((_e782 >> bitcast<u32>(22i)) | ((_e786 >> bitcast<u32>(22i)) << bitcast<u32>(10i))) | ((_e790 >> bitcast<u32>(22i)) << bitcast<u32>(20i)));
                                            let _e803 = (_e778 & 268435455u);
                                            let _e804 = (_e802 & 268435455u);
                                            let _e807 = ((_e778 >> bitcast<u32>(28u)) & 7u);
                                            let _e815 = ((_e778 >> bitcast<u32>(31i)) | (((_e802 >> bitcast<u32>(28u)) & 3u) << bitcast<u32>(1i)));
                                            let _e816 = (_e807 != 0u);
                                            if (_e807 == 0u) {
                                                phi_3835_ = _e803;
                                            } else {
                                                if (_e807 == 7u) {
                                                    phi_3834_ = 2147483648u;
                                                } else {
                                                    phi_3834_ = ((2147483648u | (_e807 << bitcast<u32>(28u))) | (_e804 & 268435455u));
                                                }
                                                let _e825 = phi_3834_;
                                                phi_3835_ = _e825;
                                            }
                                            let _e827 = phi_3835_;
                                            if _e816 {
                                                let _e828 = (_e807 != 7u);
                                                if _e828 {
                                                    phi_3845_ = (_e804 + (_e807 * ((3u * _e772) + 1u)));
                                                } else {
                                                    phi_3845_ = u32();
                                                }
                                                let _e832 = phi_3845_;
                                                phi_3847_ = _e832;
                                                phi_3848_ = select(true, false, _e828);
                                            } else {
                                                phi_3847_ = u32();
                                                phi_3848_ = true;
                                            }
                                            let _e835 = phi_3847_;
                                            let _e837 = phi_3848_;
                                            if (_e815 == 0u) {
                                                phi_3869_ = (_e803 + select(0u, 1u, !(_e816)));
                                            } else {
                                                if (_e815 == 7u) {
                                                    phi_3868_ = 2147483648u;
                                                } else {
                                                    phi_3868_ = ((2147483648u | (_e815 << bitcast<u32>(28u))) | (select(_e835, _e804, _e837) & 268435455u));
                                                }
                                                let _e850 = phi_3868_;
                                                phi_3869_ = _e850;
                                            }
                                            let _e852 = phi_3869_;
                                            phi_3873_ = type_55(array<vec4<f32>, 3>(vec4<f32>(_e730, (_e533.member.member.x + _e682), _e735, (_e533.member.member_1.x - _e721)), vec4<f32>(_e731, (_e533.member.member.y + _e686), _e736, (_e533.member.member_1.y - _e725)), vec4<f32>(_e732, (_e533.member.member.z + _e690), _e737, (_e533.member.member_1.z - _e729))), type_52(type_32((_e533.member.member + vec4<f32>(_e660, _e669, _e678, 0f)), (_e533.member.member_1 - vec4<f32>(_e699, _e708, _e717, 0f))), _e827), type_52(type_32((_e533.member.member + vec4<f32>(_e682, _e686, _e690, 0f)), (_e533.member.member_1 - vec4<f32>(_e721, _e725, _e729, 0f))), _e852));
                                        }
                                        let _e857 = phi_3873_;
                                        let _e869 = ((_e857.member[0].x - _e332) * _e337);
                                        let _e870 = ((_e857.member[0].y - _e332) * _e337);
                                        let _e871 = ((_e857.member[0].z - _e333) * _e337);
                                        let _e872 = ((_e857.member[0].w - _e333) * _e337);
                                        let _e882 = ((_e857.member[1].x - _e370) * _e375);
                                        let _e883 = ((_e857.member[1].y - _e370) * _e375);
                                        let _e884 = ((_e857.member[1].z - _e371) * _e375);
                                        let _e885 = ((_e857.member[1].w - _e371) * _e375);
                                        let _e895 = ((_e857.member[2].x - _e408) * _e413);
                                        let _e896 = ((_e857.member[2].y - _e408) * _e413);
                                        let _e897 = ((_e857.member[2].z - _e409) * _e413);
                                        let _e898 = ((_e857.member[2].w - _e409) * _e413);
                                        let _e900 = select(_e897, _e895, (_e895 < _e897));
                                        let _e902 = select(_e898, _e896, (_e896 < _e898));
                                        let _e904 = select(_e897, _e895, (_e895 > _e897));
                                        let _e906 = select(_e898, _e896, (_e896 > _e898));
                                        let _e908 = select(_e871, _e869, (_e869 < _e871));
                                        let _e910 = select(_e872, _e870, (_e870 < _e872));
                                        let _e912 = select(_e884, _e882, (_e882 < _e884));
                                        let _e914 = select(_e885, _e883, (_e883 < _e885));
                                        let _e916 = select(_e912, _e908, (_e908 > _e912));
                                        let _e918 = select(_e914, _e910, (_e910 > _e914));
                                        let _e920 = select(_e900, _e916, (_e916 > _e900));
                                        let _e922 = select(_e902, _e918, (_e918 > _e902));
                                        let _e924 = select(_e871, _e869, (_e869 > _e871));
                                        let _e926 = select(_e872, _e870, (_e870 > _e872));
                                        let _e928 = select(_e884, _e882, (_e882 > _e884));
                                        let _e930 = select(_e885, _e883, (_e883 > _e885));
                                        let _e932 = select(_e928, _e924, (_e924 < _e928));
                                        let _e934 = select(_e930, _e926, (_e926 < _e930));
                                        let _e939 = -(_e900);
                                        let _e940 = -(_e902);
                                        let _e947 = (select(_e904, _e932, (_e932 < _e904)) + (select(_e939, _e904, (_e904 > _e939)) * 0.0000019073523f));
                                        let _e948 = (select(_e906, _e934, (_e934 < _e906)) + (select(_e940, _e906, (_e906 > _e940)) * 0.0000019073523f));
                                        let _e950 = select(_e460, _e920, (_e920 > _e460));
                                        let _e952 = select(_e460, _e922, (_e922 > _e460));
                                        let _e957 = (_e950 <= select(_e504.member_1, _e947, (_e947 < _e504.member_1)));
                                        let _e958 = (_e952 <= select(_e504.member_1, _e948, (_e948 < _e504.member_1)));
                                        let _e959 = (_e950 <= _e952);
                                        if _e957 {
                                            if _e958 {
                                                if _e959 {
                                                    phi_4217_ = _e857.member_2;
                                                } else {
                                                    phi_4217_ = _e857.member_1;
                                                }
                                                let _e963 = phi_4217_;
                                                let _e964 = (_e537 % 128u);
                                                let _e965 = (_e964 < 128u);
                                                if _e965 {
                                                } else {
                                                    phi_4666_ = true;
                                                    break;
                                                }
                                                local_3[_e964] = type_52(type_32(_e963.member.member, _e963.member.member_1), _e963.member_1);
                                                if _e965 {
                                                } else {
                                                    phi_4666_ = true;
                                                    break;
                                                }
                                                local_2[_e964] = select(_e952, _e950, (_e950 > _e952));
                                                if _e959 {
                                                    phi_4250_ = _e857.member_1;
                                                } else {
                                                    phi_4250_ = _e857.member_2;
                                                }
                                                let _e980 = phi_4250_;
                                                phi_4251_ = _e980;
                                                phi_4252_ = (_e537 + 1u);
                                            } else {
                                                phi_4251_ = type_52();
                                                phi_4252_ = u32();
                                            }
                                            let _e982 = phi_4251_;
                                            let _e984 = phi_4252_;
                                            phi_4254_ = _e982;
                                            phi_4255_ = _e984;
                                            phi_4256_ = select(true, false, _e958);
                                        } else {
                                            phi_4254_ = type_52();
                                            phi_4255_ = u32();
                                            phi_4256_ = true;
                                        }
                                        let _e987 = phi_4254_;
                                        let _e989 = phi_4255_;
                                        let _e991 = phi_4256_;
                                        if _e991 {
                                            if _e957 {
                                                phi_4265_ = _e857.member_1;
                                            } else {
                                                phi_4265_ = _e857.member_2;
                                            }
                                            let _e995 = phi_4265_;
                                            phi_4270_ = _e995;
                                            phi_4271_ = select(_e958, true, _e957);
                                        } else {
                                            phi_4270_ = _e987;
                                            phi_4271_ = _e535;
                                        }
                                        let _e998 = phi_4270_;
                                        let _e1000 = phi_4271_;
                                        phi_4670_ = _e502;
                                        phi_4273_ = _e504;
                                        phi_4274_ = _e998;
                                        phi_4275_ = _e1000;
                                        phi_4276_ = select(_e989, _e537, _e991);
                                    }
                                    let _e1519 = phi_4670_;
                                    let _e1521 = phi_4273_;
                                    let _e1523 = phi_4274_;
                                    let _e1525 = phi_4275_;
                                    let _e1527 = phi_4276_;
                                    phi_4669_ = _e1519;
                                    phi_4277_ = _e1521;
                                    phi_4278_ = _e1523;
                                    phi_4279_ = (_e508 - 1u);
                                    phi_4280_ = _e1525;
                                    phi_4281_ = _e1527;
                                } else {
                                    phi_4669_ = _e502;
                                    phi_4277_ = _e504;
                                    phi_4278_ = _e533;
                                    phi_4279_ = _e508;
                                    phi_4280_ = _e535;
                                    phi_4281_ = _e537;
                                }
                                let _e1529 = phi_4669_;
                                let _e1531 = phi_4277_;
                                let _e1533 = phi_4278_;
                                let _e1535 = phi_4279_;
                                let _e1537 = phi_4280_;
                                let _e1539 = phi_4281_;
                                phi_4668_ = _e1529;
                                phi_4282_ = _e1531;
                                phi_4283_ = _e1533;
                                phi_4284_ = _e1535;
                                phi_4285_ = _e1537;
                                phi_4286_ = _e1539;
                            } else {
                                phi_4668_ = _e502;
                                phi_4282_ = type_36();
                                phi_4283_ = type_52();
                                phi_4284_ = u32();
                                phi_4285_ = bool();
                                phi_4286_ = u32();
                            }
                            let _e1541 = phi_4668_;
                            let _e1543 = phi_4282_;
                            let _e1545 = phi_4283_;
                            let _e1547 = phi_4284_;
                            let _e1549 = phi_4285_;
                            let _e1551 = phi_4286_;
                            phi_4667_ = _e1541;
                            phi_1892_ = _e1543;
                            phi_1895_ = _e1545;
                            phi_1897_ = _e1547;
                            phi_1899_ = _e1549;
                            phi_1901_ = _e1551;
                            phi_4287_ = _e516;
                        } else {
                            phi_4667_ = _e502;
                            phi_1892_ = type_36();
                            phi_1895_ = type_52();
                            phi_1897_ = u32();
                            phi_1899_ = bool();
                            phi_1901_ = u32();
                            phi_4287_ = false;
                        }
                        let _e1553 = phi_4667_;
                        let _e1555 = phi_1892_;
                        let _e1557 = phi_1895_;
                        let _e1559 = phi_1897_;
                        let _e1561 = phi_1899_;
                        let _e1563 = phi_1901_;
                        let _e1565 = phi_4287_;
                        continue;
                        continuing {
                            phi_4552_ = _e1553;
                            phi_1891_ = _e1555;
                            phi_1894_ = _e1557;
                            phi_1896_ = _e1559;
                            phi_1898_ = _e1561;
                            phi_1900_ = _e1563;
                            phi_4666_ = _e1553;
                            break if !(_e1565);
                        }
                    }
                    let _e1568 = phi_4666_;
                    if _e1568 {
                        break;
                    }
                    let _e1570 = local_7;
                    if (_e1570.member.member_3 != 4294967295u) {
                        let _e1575 = -(_e427);
                        let _e1576 = (_e1575 / 3i);
                        let _e1583 = bitcast<f32>((bitcast<u32>((_e1576 + 127i)) << bitcast<u32>(23i)));
                        let _e1591 = (((_e1570.member.member * _e1583) * _e1583) * bitcast<f32>((bitcast<u32>(((_e1575 - (2i * _e1576)) + 127i)) << bitcast<u32>(23i))));
                        let _e1593 = select(340282350000000000000000000000000000000f, _e1591, (_e1591 < 340282350000000000000000000000000000000f));
                        phi_4339_ = type_24(select(-340282350000000000000000000000000000000f, _e1593, (_e1593 > -340282350000000000000000000000000000000f)), _e1570.member.member_1, _e1570.member.member_2, _e1570.member.member_3);
                    } else {
                        phi_4339_ = type_24(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                    }
                    let _e1600 = phi_4339_;
                    if _e148 {
                    } else {
                        break;
                    }
                    global_6.member[_e146] = _e1600;
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn trace_closest_q10_lattice(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
