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

struct type_32 {
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

struct type_52 {
    member: type_28,
    member_1: u32,
}

struct type_55 {
    member: array<vec4<f32>, 3>,
    member_1: type_52,
    member_2: type_52,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_1: type_12;
@group(0) @binding(1) 
var<uniform> global_2: type_39;
@group(0) @binding(4) 
var<storage> global_3: type_36;
@group(0) @binding(2) 
var<storage> global_4: type_46;
@group(0) @binding(3) 
var<storage> global_5: type_4;
@group(0) @binding(5) 
var<storage, read_write> global_6: type_22;

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
    var phi_1891_: type_32;
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
    var phi_1969_: type_32;
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
    var phi_2877_: type_20;
    var phi_2879_: type_20;
    var phi_2880_: bool;
    var phi_2884_: type_20;
    var phi_2885_: type_20;
    var phi_2886_: type_20;
    var phi_2887_: bool;
    var phi_2891_: type_20;
    var phi_2892_: bool;
    var phi_2896_: type_20;
    var phi_2897_: bool;
    var phi_2901_: type_20;
    var phi_2926_: bool;
    var phi_2927_: bool;
    var phi_2933_: type_32;
    var phi_2934_: type_32;
    var phi_2935_: type_32;
    var phi_4608_: bool;
    var phi_1970_: type_32;
    var phi_4607_: bool;
    var phi_4670_: bool;
    var phi_4273_: type_32;
    var phi_4274_: type_52;
    var phi_4275_: bool;
    var phi_4276_: u32;
    var phi_4669_: bool;
    var phi_4277_: type_32;
    var phi_4278_: type_52;
    var phi_4279_: u32;
    var phi_4280_: bool;
    var phi_4281_: u32;
    var phi_4668_: bool;
    var phi_4282_: type_32;
    var phi_4283_: type_52;
    var phi_4284_: u32;
    var phi_4285_: bool;
    var phi_4286_: u32;
    var phi_4667_: bool;
    var phi_1892_: type_32;
    var phi_1895_: type_52;
    var phi_1897_: u32;
    var phi_1899_: bool;
    var phi_1901_: u32;
    var phi_4287_: bool;
    var phi_4666_: bool;
    var local_7: type_32;
    var phi_4339_: type_20;
    var local_8: type_32;

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
                            phi_401_ = (bitcast<i32>((_e224 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_401_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e224)), 32u, (_e224 == 0u))));
                        }
                        let _e238 = phi_401_;
                        phi_402_ = _e238;
                    } else {
                        phi_402_ = 0i;
                    }
                    let _e240 = phi_402_;
                    let _e241 = (_e157 == _e196);
                    if _e241 {
                        phi_412_ = true;
                    } else {
                        phi_412_ = (_e164 == _e196);
                    }
                    let _e244 = phi_412_;
                    let _e245 = select(1u, 0u, _e241);
                    if _e244 {
                        let _e246 = (_e245 + 1u);
                        phi_422_ = _e246;
                        phi_423_ = _e246;
                        phi_425_ = select(true, false, (_e246 == 2u));
                    } else {
                        phi_422_ = u32();
                        phi_423_ = 0u;
                        phi_425_ = true;
                    }
                    let _e250 = phi_422_;
                    let _e252 = phi_423_;
                    let _e254 = phi_425_;
                    if _e254 {
                        phi_430_ = (_e252 + 1u);
                    } else {
                        phi_430_ = 0u;
                    }
                    let _e258 = phi_430_;
                    let _e259 = select(_e250, _e252, _e254);
                    let _e260 = select(_e245, select(2u, _e245, _e244), _e254);
                    if (_e127 < -126i) {
                        phi_443_ = -126i;
                    } else {
                        phi_443_ = select(_e127, 127i, (_e127 > 127i));
                    }
                    let _e265 = phi_443_;
                    let _e270 = bitcast<f32>((bitcast<u32>((_e265 + 127i)) << bitcast<u32>(23i)));
                    let _e276 = bitcast<f32>((bitcast<u32>(((_e127 - _e265) + 127i)) << bitcast<u32>(23i)));
                    let _e277 = -(_e240);
                    if (_e277 < -126i) {
                        phi_463_ = -126i;
                    } else {
                        phi_463_ = select(_e277, 127i, (_e277 > 127i));
                    }
                    let _e282 = phi_463_;
                    let _e287 = bitcast<f32>((bitcast<u32>((_e282 + 127i)) << bitcast<u32>(23i)));
                    let _e293 = bitcast<f32>((bitcast<u32>(((_e277 - _e282) + 127i)) << bitcast<u32>(23i)));
                    let _e297 = global_3.member[_e145].member;
                    let _e298 = (_e259 == 0u);
                    if _e298 {
                        phi_481_ = _e297[0];
                    } else {
                        phi_481_ = _e297[1];
                    }
                    let _e302 = phi_481_;
                    let _e303 = (_e259 == 2u);
                    if _e303 {
                        phi_487_ = _e297[2];
                    } else {
                        phi_487_ = _e302;
                    }
                    let _e306 = phi_487_;
                    let _e308 = ((_e306 * _e270) * _e276);
                    let _e309 = global_3.member[_e145].member_2;
                    if _e298 {
                        phi_498_ = _e309[0];
                    } else {
                        phi_498_ = _e309[1];
                    }
                    let _e313 = phi_498_;
                    if _e303 {
                        phi_504_ = _e309[2];
                    } else {
                        phi_504_ = _e313;
                    }
                    let _e316 = phi_504_;
                    let _e318 = ((_e316 * _e287) * _e293);
                    let _e322 = (bitcast<f32>((bitcast<u32>(_e318) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e322 {
                        let _e326 = (bitcast<f32>((bitcast<u32>(_e308) & 2147483647u)) * 0.00000011920929f);
                        phi_527_ = select(0.00000000000011368684f, _e326, (_e326 > 0.00000000000011368684f));
                    } else {
                        phi_527_ = 0f;
                    }
                    let _e330 = phi_527_;
                    let _e331 = (_e308 + _e330);
                    let _e332 = (_e308 - _e330);
                    let _e333 = select(_e318, 0f, _e322);
                    if _e322 {
                        phi_538_ = 38685626000000000000000000f;
                    } else {
                        phi_538_ = (1f / _e318);
                    }
                    let _e336 = phi_538_;
                    let _e337 = (_e258 == 0u);
                    if _e337 {
                        phi_547_ = _e297[0];
                    } else {
                        phi_547_ = _e297[1];
                    }
                    let _e341 = phi_547_;
                    let _e342 = (_e258 == 2u);
                    if _e342 {
                        phi_553_ = _e297[2];
                    } else {
                        phi_553_ = _e341;
                    }
                    let _e345 = phi_553_;
                    let _e347 = ((_e345 * _e270) * _e276);
                    if _e337 {
                        phi_564_ = _e309[0];
                    } else {
                        phi_564_ = _e309[1];
                    }
                    let _e351 = phi_564_;
                    if _e342 {
                        phi_570_ = _e309[2];
                    } else {
                        phi_570_ = _e351;
                    }
                    let _e354 = phi_570_;
                    let _e356 = ((_e354 * _e287) * _e293);
                    let _e360 = (bitcast<f32>((bitcast<u32>(_e356) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e360 {
                        let _e364 = (bitcast<f32>((bitcast<u32>(_e347) & 2147483647u)) * 0.00000011920929f);
                        phi_593_ = select(0.00000000000011368684f, _e364, (_e364 > 0.00000000000011368684f));
                    } else {
                        phi_593_ = 0f;
                    }
                    let _e368 = phi_593_;
                    let _e369 = (_e347 + _e368);
                    let _e370 = (_e347 - _e368);
                    let _e371 = select(_e356, 0f, _e360);
                    if _e360 {
                        phi_604_ = 38685626000000000000000000f;
                    } else {
                        phi_604_ = (1f / _e356);
                    }
                    let _e374 = phi_604_;
                    let _e375 = (_e260 == 0u);
                    if _e375 {
                        phi_613_ = _e297[0];
                    } else {
                        phi_613_ = _e297[1];
                    }
                    let _e379 = phi_613_;
                    let _e380 = (_e260 == 2u);
                    if _e380 {
                        phi_619_ = _e297[2];
                    } else {
                        phi_619_ = _e379;
                    }
                    let _e383 = phi_619_;
                    let _e385 = ((_e383 * _e270) * _e276);
                    if _e375 {
                        phi_630_ = _e309[0];
                    } else {
                        phi_630_ = _e309[1];
                    }
                    let _e389 = phi_630_;
                    if _e380 {
                        phi_636_ = _e309[2];
                    } else {
                        phi_636_ = _e389;
                    }
                    let _e392 = phi_636_;
                    let _e394 = ((_e392 * _e287) * _e293);
                    let _e398 = (bitcast<f32>((bitcast<u32>(_e394) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e398 {
                        let _e402 = (bitcast<f32>((bitcast<u32>(_e385) & 2147483647u)) * 0.00000011920929f);
                        phi_659_ = select(0.00000000000011368684f, _e402, (_e402 > 0.00000000000011368684f));
                    } else {
                        phi_659_ = 0f;
                    }
                    let _e406 = phi_659_;
                    let _e407 = (_e385 + _e406);
                    let _e408 = (_e385 - _e406);
                    let _e409 = select(_e394, 0f, _e398);
                    if _e398 {
                        phi_670_ = 38685626000000000000000000f;
                    } else {
                        phi_670_ = (1f / _e394);
                    }
                    let _e412 = phi_670_;
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
                        phi_770_ = select(-340282350000000000000000000000000000000f, _e453, (_e453 > -340282350000000000000000000000000000000f));
                        phi_771_ = select(-340282350000000000000000000000000000000f, _e446, (_e446 > -340282350000000000000000000000000000000f));
                    } else {
                        phi_770_ = 0f;
                        phi_771_ = 1f;
                    }
                    let _e457 = phi_770_;
                    let _e459 = phi_771_;
                    local_3 = array<type_52, 128>(type_52(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u));
                    local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    let _e463 = (_e259 % 3u);
                    let _e464 = (_e463 < 3u);
                    if _e464 {
                    } else {
                        break;
                    }
                    let _e466 = local_1[_e463];
                    let _e469 = (_e258 % 3u);
                    let _e470 = (_e469 < 3u);
                    if _e470 {
                    } else {
                        break;
                    }
                    let _e472 = local_1[_e469];
                    let _e475 = (_e260 % 3u);
                    let _e476 = (_e475 < 3u);
                    if _e476 {
                    } else {
                        break;
                    }
                    let _e478 = local_1[_e475];
                    if _e464 {
                    } else {
                        break;
                    }
                    let _e483 = local[_e463];
                    if _e470 {
                    } else {
                        break;
                    }
                    let _e487 = local[_e469];
                    if _e476 {
                    } else {
                        break;
                    }
                    let _e491 = local[_e475];
                    phi_4552_ = false;
                    phi_1891_ = type_32(type_20(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e457);
                    phi_1894_ = type_52(type_28(vec4<f32>((f32(_e466) * _e139), (f32(_e472) * _e139), (f32(_e478) * _e139), 0f), vec4<f32>((f32(_e483) * _e139), (f32(_e487) * _e139), (f32(_e491) * _e139), 0f)), select(0u, 2147483648u, (_e88 == 0u)));
                    phi_1896_ = ((3u * _e88) + 1u);
                    phi_1898_ = (_e459 <= _e457);
                    phi_1900_ = 0u;
                    loop {
                        let _e501 = phi_4552_;
                        let _e503 = phi_1891_;
                        let _e505 = phi_1894_;
                        let _e507 = phi_1896_;
                        let _e509 = phi_1898_;
                        let _e511 = phi_1900_;
                        local_7 = _e503;
                        if _e509 {
                            phi_1911_ = true;
                        } else {
                            phi_1911_ = (_e511 > 0u);
                        }
                        let _e514 = phi_1911_;
                        if _e514 {
                            let _e515 = (_e507 > 0u);
                            if _e515 {
                                if _e509 {
                                    phi_1948_ = _e505;
                                    phi_1949_ = _e509;
                                    phi_1950_ = _e511;
                                } else {
                                    let _e516 = (_e511 - 1u);
                                    let _e517 = (_e516 % 128u);
                                    let _e518 = (_e517 < 128u);
                                    if _e518 {
                                    } else {
                                        phi_4666_ = true;
                                        break;
                                    }
                                    let _e520 = local_3[_e517];
                                    if _e518 {
                                    } else {
                                        phi_4666_ = true;
                                        break;
                                    }
                                    let _e528 = local_2[_e517];
                                    phi_1948_ = type_52(type_28(_e520.member.member, _e520.member.member_1), _e520.member_1);
                                    phi_1949_ = (_e528 <= _e503.member_1);
                                    phi_1950_ = _e516;
                                }
                                let _e532 = phi_1948_;
                                let _e534 = phi_1949_;
                                let _e536 = phi_1950_;
                                if _e534 {
                                    let _e541 = (_e532.member_1 & 268435455u);
                                    if ((_e532.member_1 & 2147483648u) != 0u) {
                                        phi_4549_ = _e501;
                                        phi_1969_ = _e503;
                                        phi_1972_ = type_8(0u, ((_e532.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e1003 = phi_4549_;
                                            let _e1005 = phi_1969_;
                                            let _e1007 = phi_1972_;
                                            local_8 = _e1005;
                                            if (_e1007.member < _e1007.member_1) {
                                                phi_1973_ = type_8((_e1007.member + 1u), _e1007.member_1);
                                                phi_1995_ = type_8(1u, _e1007.member);
                                            } else {
                                                phi_1973_ = _e1007;
                                                phi_1995_ = type_8(0u, type_8().member_1);
                                            }
                                            let _e1020 = phi_1973_;
                                            let _e1022 = phi_1995_;
                                            let _e1026 = (bitcast<i32>(_e1022.member) != 0i);
                                            if _e1026 {
                                                let _e1031 = (_e532.member.member_1.x - _e532.member.member.x);
                                                let _e1034 = (_e532.member.member_1.y - _e532.member.member.y);
                                                let _e1037 = (_e532.member.member_1.z - _e532.member.member.z);
                                                let _e1039 = select(_e1034, _e1031, (_e1031 > _e1034));
                                                let _e1041 = select(_e1037, _e1039, (_e1039 > _e1037));
                                                let _e1043 = (_e1041 < (1024f * _e139));
                                                if _e1043 {
                                                    phi_2036_ = 0u;
                                                } else {
                                                    phi_2036_ = select(2u, 1u, (_e1041 < (2097152f * _e139)));
                                                }
                                                let _e1048 = phi_2036_;
                                                switch bitcast<i32>(_e1048) {
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
                                                let _e1051 = phi_2042_;
                                                switch bitcast<i32>(_e1048) {
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
                                                let _e1058 = phi_2052_;
                                                let _e1060 = ((_e541 + (_e1022.member_1 * ((3u * _e1051) + 1u))) + (3u * _e1058));
                                                let _e1061 = (_e1060 < _e91);
                                                if _e1061 {
                                                    if _e1061 {
                                                    } else {
                                                        phi_4607_ = true;
                                                        break;
                                                    }
                                                    let _e1063 = global_5.member[_e1060];
                                                    phi_2068_ = _e1063;
                                                } else {
                                                    phi_2068_ = 4294967295u;
                                                }
                                                let _e1065 = phi_2068_;
                                                local_4 = array<u32, 3>(_e259, _e258, _e260);
                                                if _e1043 {
                                                    phi_2105_ = 0u;
                                                } else {
                                                    phi_2105_ = select(2u, 1u, (_e1041 < (2097152f * _e139)));
                                                }
                                                let _e1071 = phi_2105_;
                                                switch bitcast<i32>(_e1071) {
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
                                                let _e1074 = phi_2111_;
                                                switch bitcast<i32>(_e1071) {
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
                                                let _e1081 = phi_2121_;
                                                local_6 = array<f32, 4>(_e532.member.member.x, _e532.member.member.y, _e532.member.member.z, _e532.member.member.w);
                                                local_5[0u] = array<f32, 3>(0f, 0f, 0f);
                                                local_5[1u] = array<f32, 3>(0f, 0f, 0f);
                                                local_5[2u] = array<f32, 3>(0f, 0f, 0f);
                                                phi_4534_ = _e1003;
                                                phi_2137_ = type_8(0u, 3u);
                                                loop {
                                                    let _e1095 = phi_4534_;
                                                    let _e1097 = phi_2137_;
                                                    if (_e1097.member < _e1097.member_1) {
                                                        phi_2138_ = type_8((_e1097.member + 1u), _e1097.member_1);
                                                        phi_2161_ = type_8(1u, _e1097.member);
                                                    } else {
                                                        phi_2138_ = _e1097;
                                                        phi_2161_ = type_8(0u, type_8().member_1);
                                                    }
                                                    let _e1110 = phi_2138_;
                                                    let _e1112 = phi_2161_;
                                                    let _e1116 = (bitcast<i32>(_e1112.member) != 0i);
                                                    if _e1116 {
                                                        let _e1118 = ((_e541 + (_e1022.member_1 * ((3u * _e1074) + 1u))) + (_e1112.member_1 * _e1081));
                                                        let _e1119 = (_e1118 < _e91);
                                                        if _e1119 {
                                                            if _e1119 {
                                                            } else {
                                                                phi_4605_ = true;
                                                                break;
                                                            }
                                                            let _e1121 = global_5.member[_e1118];
                                                            phi_2184_ = _e1121;
                                                        } else {
                                                            phi_2184_ = 0u;
                                                        }
                                                        let _e1123 = phi_2184_;
                                                        let _e1124 = (_e1118 + 1u);
                                                        let _e1125 = (_e1124 < _e91);
                                                        if _e1125 {
                                                            if _e1125 {
                                                            } else {
                                                                phi_4605_ = true;
                                                                break;
                                                            }
                                                            let _e1127 = global_5.member[_e1124];
                                                            phi_2199_ = _e1127;
                                                        } else {
                                                            phi_2199_ = 0u;
                                                        }
                                                        let _e1129 = phi_2199_;
                                                        phi_2202_ = type_8(0u, 3u);
                                                        loop {
                                                            let _e1131 = phi_2202_;
                                                            if (_e1131.member < _e1131.member_1) {
                                                                phi_2203_ = type_8((_e1131.member + 1u), _e1131.member_1);
                                                                phi_2226_ = type_8(1u, _e1131.member);
                                                            } else {
                                                                phi_2203_ = _e1131;
                                                                phi_2226_ = type_8(0u, type_8().member_1);
                                                            }
                                                            let _e1144 = phi_2203_;
                                                            let _e1146 = phi_2226_;
                                                            let _e1150 = (bitcast<i32>(_e1146.member) != 0i);
                                                            if _e1150 {
                                                                let _e1151 = (_e1146.member_1 < 3u);
                                                                if _e1151 {
                                                                } else {
                                                                    phi_4527_ = true;
                                                                    break;
                                                                }
                                                                let _e1153 = local_4[_e1146.member_1];
                                                                if (_e1146.member_1 < 4u) {
                                                                } else {
                                                                    phi_4527_ = true;
                                                                    break;
                                                                }
                                                                let _e1156 = local_6[_e1146.member_1];
                                                                switch bitcast<i32>(_e1071) {
                                                                    case 0: {
                                                                        phi_2296_ = (_e1156 + (f32(((_e1123 >> bitcast<u32>(((10u * _e1153) & 31u))) & 1023u)) * _e139));
                                                                        break;
                                                                    }
                                                                    case 1: {
                                                                        if (_e1153 == 0u) {
                                                                            phi_2273_ = _e1123;
                                                                        } else {
                                                                            if (_e1153 == 1u) {
                                                                                phi_2272_ = ((_e1123 >> bitcast<u32>(21i)) | (_e1129 << bitcast<u32>(11i)));
                                                                            } else {
                                                                                phi_2272_ = (_e1129 >> bitcast<u32>(10i));
                                                                            }
                                                                            let _e1177 = phi_2272_;
                                                                            phi_2273_ = _e1177;
                                                                        }
                                                                        let _e1179 = phi_2273_;
                                                                        phi_2296_ = (_e1156 + (f32((_e1179 & 2097151u)) * _e139));
                                                                        break;
                                                                    }
                                                                    case 2: {
                                                                        let _e1158 = (_e1118 + _e1153);
                                                                        let _e1159 = (_e1158 < _e91);
                                                                        if _e1159 {
                                                                            if _e1159 {
                                                                            } else {
                                                                                phi_4527_ = true;
                                                                                break;
                                                                            }
                                                                            let _e1161 = global_5.member[_e1158];
                                                                            phi_2292_ = _e1161;
                                                                        } else {
                                                                            phi_2292_ = 0u;
                                                                        }
                                                                        let _e1163 = phi_2292_;
                                                                        phi_2296_ = (f32(bitcast<i32>(_e1163)) * _e139);
                                                                        break;
                                                                    }
                                                                    default: {
                                                                        phi_2296_ = f32();
                                                                        break;
                                                                    }
                                                                }
                                                                let _e1193 = phi_2296_;
                                                                if (_e1112.member_1 < 3u) {
                                                                } else {
                                                                    phi_4527_ = true;
                                                                    break;
                                                                }
                                                                if _e1151 {
                                                                } else {
                                                                    phi_4527_ = true;
                                                                    break;
                                                                }
                                                                local_5[_e1112.member_1][_e1146.member_1] = _e1193;
                                                            }
                                                            continue;
                                                            continuing {
                                                                phi_2202_ = _e1144;
                                                                phi_4527_ = _e1095;
                                                                break if !(_e1150);
                                                            }
                                                        }
                                                        let _e1199 = phi_4527_;
                                                        phi_4605_ = _e1199;
                                                        if _e1199 {
                                                            break;
                                                        }
                                                        phi_4606_ = _e1199;
                                                    } else {
                                                        phi_4606_ = _e1095;
                                                    }
                                                    let _e1201 = phi_4606_;
                                                    continue;
                                                    continuing {
                                                        phi_4534_ = _e1201;
                                                        phi_2137_ = _e1110;
                                                        phi_4605_ = _e1201;
                                                        break if !(_e1116);
                                                    }
                                                }
                                                let _e1204 = phi_4605_;
                                                phi_4607_ = _e1204;
                                                if _e1204 {
                                                    break;
                                                }
                                                let _e1205 = local_5;
                                                let _e1221 = (_e1205[0][2] - _e385);
                                                let _e1224 = (((_e1205[0][0] - _e308) * _e409) - (_e1221 * _e333));
                                                let _e1227 = (((_e1205[0][1] - _e347) * _e409) - (_e1221 * _e371));
                                                let _e1230 = (_e1205[1][2] - _e385);
                                                let _e1233 = (((_e1205[1][0] - _e308) * _e409) - (_e1230 * _e333));
                                                let _e1236 = (((_e1205[1][1] - _e347) * _e409) - (_e1230 * _e371));
                                                let _e1239 = (_e1205[2][2] - _e385);
                                                let _e1242 = (((_e1205[2][0] - _e308) * _e409) - (_e1239 * _e333));
                                                let _e1245 = (((_e1205[2][1] - _e347) * _e409) - (_e1239 * _e371));
                                                let _e1246 = (_e1242 * _e1236);
                                                let _e1247 = (_e1245 * _e1233);
                                                let _e1248 = (_e1224 * _e1245);
                                                let _e1249 = (_e1227 * _e1242);
                                                let _e1250 = (_e1233 * _e1227);
                                                let _e1251 = (_e1236 * _e1224);
                                                let _e1256 = (((_e1246 >= _e1247) && (_e1248 >= _e1249)) && (_e1250 >= _e1251));
                                                if (_e1256 || (((_e1246 <= _e1247) && (_e1248 <= _e1249)) && (_e1250 <= _e1251))) {
                                                    let _e1263 = select(-1f, 1f, _e1256);
                                                    let _e1265 = ((_e1246 - _e1247) * _e1263);
                                                    let _e1267 = select(0f, _e1265, (_e1265 > 0f));
                                                    let _e1269 = ((_e1248 - _e1249) * _e1263);
                                                    let _e1271 = select(0f, _e1269, (_e1269 > 0f));
                                                    let _e1273 = ((_e1250 - _e1251) * _e1263);
                                                    let _e1275 = select(0f, _e1273, (_e1273 > 0f));
                                                    let _e1277 = ((_e1267 + _e1271) + _e1275);
                                                    if (_e1277 < 0.000000000000000000000000000000000000011754944f) {
                                                        phi_2891_ = type_20();
                                                        phi_2892_ = true;
                                                    } else {
                                                        let _e1280 = select(_e1205[1][0], _e1205[0][0], (_e1205[0][0] < _e1205[1][0]));
                                                        let _e1284 = select(_e1205[1][0], _e1205[0][0], (_e1205[0][0] > _e1205[1][0]));
                                                        let _e1288 = select(_e1205[1][1], _e1205[0][1], (_e1205[0][1] < _e1205[1][1]));
                                                        let _e1292 = select(_e1205[1][1], _e1205[0][1], (_e1205[0][1] > _e1205[1][1]));
                                                        let _e1296 = select(_e1205[1][2], _e1205[0][2], (_e1205[0][2] < _e1205[1][2]));
                                                        let _e1300 = select(_e1205[1][2], _e1205[0][2], (_e1205[0][2] > _e1205[1][2]));
                                                        let _e1305 = ((select(_e1205[2][0], _e1280, (_e1280 < _e1205[2][0])) - _e331) * _e336);
                                                        let _e1306 = ((select(_e1205[2][0], _e1284, (_e1284 > _e1205[2][0])) - _e332) * _e336);
                                                        let _e1309 = ((select(_e1205[2][1], _e1288, (_e1288 < _e1205[2][1])) - _e369) * _e374);
                                                        let _e1310 = ((select(_e1205[2][1], _e1292, (_e1292 > _e1205[2][1])) - _e370) * _e374);
                                                        let _e1313 = ((select(_e1205[2][2], _e1296, (_e1296 < _e1205[2][2])) - _e407) * _e412);
                                                        let _e1314 = ((select(_e1205[2][2], _e1300, (_e1300 > _e1205[2][2])) - _e408) * _e412);
                                                        let _e1316 = select(_e1314, _e1313, (_e1313 < _e1314));
                                                        let _e1318 = select(_e1314, _e1313, (_e1313 > _e1314));
                                                        let _e1320 = select(_e1306, _e1305, (_e1305 < _e1306));
                                                        let _e1322 = select(_e1310, _e1309, (_e1309 < _e1310));
                                                        let _e1324 = select(_e1322, _e1320, (_e1320 > _e1322));
                                                        let _e1326 = select(_e1316, _e1324, (_e1324 > _e1316));
                                                        let _e1328 = select(_e1306, _e1305, (_e1305 > _e1306));
                                                        let _e1330 = select(_e1310, _e1309, (_e1309 > _e1310));
                                                        let _e1332 = select(_e1330, _e1328, (_e1328 < _e1330));
                                                        let _e1334 = select(_e1318, _e1332, (_e1332 < _e1318));
                                                        let _e1335 = -(_e1316);
                                                        let _e1341 = select(_e459, _e1326, (_e1326 > _e459));
                                                        if (_e1341 > (_e1334 + (select(_e1335, _e1318, (_e1318 > _e1335)) * 0.0000019073523f))) {
                                                            phi_2886_ = type_20();
                                                            phi_2887_ = true;
                                                        } else {
                                                            let _e1343 = (_e1341 > _e1005.member_1);
                                                            if _e1343 {
                                                                phi_2885_ = type_20();
                                                            } else {
                                                                let _e1347 = (_e1205[1][0] - _e1205[0][0]);
                                                                let _e1348 = (_e1205[1][1] - _e1205[0][1]);
                                                                let _e1349 = (_e1205[1][2] - _e1205[0][2]);
                                                                let _e1350 = vec3<f32>(_e1347, _e1348, _e1349);
                                                                let _e1351 = (_e1205[2][0] - _e1205[1][0]);
                                                                let _e1352 = (_e1205[2][1] - _e1205[1][1]);
                                                                let _e1353 = (_e1205[2][2] - _e1205[1][2]);
                                                                let _e1354 = vec3<f32>(_e1351, _e1352, _e1353);
                                                                let _e1355 = (_e1205[0][0] - _e1205[2][0]);
                                                                let _e1356 = (_e1205[0][1] - _e1205[2][1]);
                                                                let _e1357 = (_e1205[0][2] - _e1205[2][2]);
                                                                let _e1358 = vec3<f32>(_e1355, _e1356, _e1357);
                                                                let _e1361 = bitcast<f32>((bitcast<u32>(_e1347) & 2147483647u));
                                                                let _e1364 = bitcast<f32>((bitcast<u32>(_e1348) & 2147483647u));
                                                                let _e1366 = select(_e1364, _e1361, (_e1361 > _e1364));
                                                                let _e1369 = bitcast<f32>((bitcast<u32>(_e1349) & 2147483647u));
                                                                let _e1371 = select(_e1369, _e1366, (_e1366 > _e1369));
                                                                let _e1374 = bitcast<f32>((bitcast<u32>(_e1351) & 2147483647u));
                                                                let _e1377 = bitcast<f32>((bitcast<u32>(_e1352) & 2147483647u));
                                                                let _e1379 = select(_e1377, _e1374, (_e1374 > _e1377));
                                                                let _e1382 = bitcast<f32>((bitcast<u32>(_e1353) & 2147483647u));
                                                                let _e1384 = select(_e1382, _e1379, (_e1379 > _e1382));
                                                                let _e1387 = bitcast<f32>((bitcast<u32>(_e1355) & 2147483647u));
                                                                let _e1390 = bitcast<f32>((bitcast<u32>(_e1356) & 2147483647u));
                                                                let _e1392 = select(_e1390, _e1387, (_e1387 > _e1390));
                                                                let _e1395 = bitcast<f32>((bitcast<u32>(_e1357) & 2147483647u));
                                                                let _e1397 = select(_e1395, _e1392, (_e1392 > _e1395));
                                                                let _e1399 = select(_e1384, _e1371, (_e1371 > _e1384));
                                                                let _e1401 = select(_e1397, _e1399, (_e1399 > _e1397));
                                                                if (_e1371 == _e1401) {
                                                                    phi_2796_ = _e1354;
                                                                    phi_2797_ = _e1358;
                                                                } else {
                                                                    let _e1404 = vec3((_e1384 == _e1401));
                                                                    phi_2796_ = select(_e1350, _e1358, _e1404);
                                                                    phi_2797_ = select(_e1354, _e1350, _e1404);
                                                                }
                                                                let _e1408 = phi_2796_;
                                                                let _e1410 = phi_2797_;
                                                                let _e1417 = ((_e1408.y * _e1410.z) - (_e1410.y * _e1408.z));
                                                                let _e1422 = ((_e1408.z * _e1410.x) - (_e1410.z * _e1408.x));
                                                                let _e1425 = ((_e1408.x * _e1410.y) - (_e1410.x * _e1408.y));
                                                                if (_e1267 >= _e1271) {
                                                                    phi_2828_ = select(true, false, (_e1267 >= _e1275));
                                                                } else {
                                                                    phi_2828_ = true;
                                                                }
                                                                let _e1430 = phi_2828_;
                                                                if _e1430 {
                                                                    phi_2837_ = select(vec3<f32>(_e1205[2][0], _e1205[2][1], _e1205[2][2]), vec3<f32>(_e1205[1][0], _e1205[1][1], _e1205[1][2]), vec3((_e1271 >= _e1275)));
                                                                } else {
                                                                    phi_2837_ = vec3<f32>(_e1205[0][0], _e1205[0][1], _e1205[0][2]);
                                                                }
                                                                let _e1435 = phi_2837_;
                                                                let _e1452 = ((((_e1417 * (_e1435.x - _e308)) + (_e1422 * (_e1435.y - _e347))) + (_e1425 * (_e1435.z - _e385))) / (((_e1417 * _e333) + (_e1422 * _e371)) + (_e1425 * _e409)));
                                                                let _e1454 = select(_e1334, _e1452, (_e1452 < _e1334));
                                                                let _e1456 = select(_e1326, _e1454, (_e1454 > _e1326));
                                                                if (_e1456 >= _e459) {
                                                                    let _e1458 = (_e1456 <= _e1005.member_1);
                                                                    if _e1458 {
                                                                        let _e1459 = (1f / _e1277);
                                                                        phi_2877_ = type_20(_e1456, (_e1271 * _e1459), (_e1275 * _e1459), _e1065);
                                                                    } else {
                                                                        phi_2877_ = type_20();
                                                                    }
                                                                    let _e1464 = phi_2877_;
                                                                    phi_2879_ = _e1464;
                                                                    phi_2880_ = select(true, false, _e1458);
                                                                } else {
                                                                    phi_2879_ = type_20();
                                                                    phi_2880_ = true;
                                                                }
                                                                let _e1467 = phi_2879_;
                                                                let _e1469 = phi_2880_;
                                                                if _e1469 {
                                                                    phi_2884_ = type_20(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                } else {
                                                                    phi_2884_ = _e1467;
                                                                }
                                                                let _e1471 = phi_2884_;
                                                                phi_2885_ = _e1471;
                                                            }
                                                            let _e1473 = phi_2885_;
                                                            phi_2886_ = _e1473;
                                                            phi_2887_ = _e1343;
                                                        }
                                                        let _e1475 = phi_2886_;
                                                        let _e1477 = phi_2887_;
                                                        phi_2891_ = _e1475;
                                                        phi_2892_ = _e1477;
                                                    }
                                                    let _e1479 = phi_2891_;
                                                    let _e1481 = phi_2892_;
                                                    phi_2896_ = _e1479;
                                                    phi_2897_ = _e1481;
                                                } else {
                                                    phi_2896_ = type_20();
                                                    phi_2897_ = true;
                                                }
                                                let _e1483 = phi_2896_;
                                                let _e1485 = phi_2897_;
                                                if _e1485 {
                                                    phi_2901_ = type_20(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                } else {
                                                    phi_2901_ = _e1483;
                                                }
                                                let _e1487 = phi_2901_;
                                                if (_e1487.member_3 != 4294967295u) {
                                                    if (_e1065 != 4294967295u) {
                                                        if (_e1487.member < _e1005.member.member) {
                                                            phi_2927_ = true;
                                                        } else {
                                                            if (_e1487.member == _e1005.member.member) {
                                                                phi_2926_ = (_e1487.member_3 < _e1005.member.member_3);
                                                            } else {
                                                                phi_2926_ = false;
                                                            }
                                                            let _e1500 = phi_2926_;
                                                            phi_2927_ = _e1500;
                                                        }
                                                        let _e1502 = phi_2927_;
                                                        if _e1502 {
                                                            phi_2933_ = type_32(_e1487, _e1487.member);
                                                        } else {
                                                            phi_2933_ = _e1005;
                                                        }
                                                        let _e1505 = phi_2933_;
                                                        phi_2934_ = _e1505;
                                                    } else {
                                                        phi_2934_ = _e1005;
                                                    }
                                                    let _e1507 = phi_2934_;
                                                    phi_2935_ = _e1507;
                                                } else {
                                                    phi_2935_ = _e1005;
                                                }
                                                let _e1509 = phi_2935_;
                                                phi_4608_ = _e1204;
                                                phi_1970_ = _e1509;
                                            } else {
                                                phi_4608_ = _e1003;
                                                phi_1970_ = type_32();
                                            }
                                            let _e1511 = phi_4608_;
                                            let _e1513 = phi_1970_;
                                            continue;
                                            continuing {
                                                phi_4549_ = _e1511;
                                                phi_1969_ = _e1513;
                                                phi_1972_ = _e1020;
                                                phi_4607_ = _e1511;
                                                break if !(_e1026);
                                            }
                                        }
                                        let _e1516 = phi_4607_;
                                        phi_4666_ = _e1516;
                                        if _e1516 {
                                            break;
                                        }
                                        phi_4670_ = _e1516;
                                        let _e1716 = local_8;
                                        phi_4273_ = _e1716;
                                        phi_4274_ = _e532;
                                        phi_4275_ = false;
                                        phi_4276_ = _e536;
                                    } else {
                                        if (_e532.member_1 >= _e88) {
                                            phi_3873_ = type_55(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), type_52(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u), type_52(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u));
                                        } else {
                                            if (_e532.member_1 < _e88) {
                                            } else {
                                                phi_4666_ = true;
                                                break;
                                            }
                                            let _e550 = ((1u + (_e259 * 2u)) % 7u);
                                            if (_e550 < 7u) {
                                            } else {
                                                phi_4666_ = true;
                                                break;
                                            }
                                            let _e555 = global_4.member[_e532.member_1][_e550];
                                            let _e558 = ((1u + (_e258 * 2u)) % 7u);
                                            if (_e558 < 7u) {
                                            } else {
                                                phi_4666_ = true;
                                                break;
                                            }
                                            let _e563 = global_4.member[_e532.member_1][_e558];
                                            let _e566 = ((1u + (_e260 * 2u)) % 7u);
                                            if (_e566 < 7u) {
                                            } else {
                                                phi_4666_ = true;
                                                break;
                                            }
                                            let _e571 = global_4.member[_e532.member_1][_e566];
                                            let _e574 = (((_e259 + 1u) * 2u) % 7u);
                                            if (_e574 < 7u) {
                                            } else {
                                                phi_4666_ = true;
                                                break;
                                            }
                                            let _e579 = global_4.member[_e532.member_1][_e574];
                                            let _e582 = (((_e258 + 1u) * 2u) % 7u);
                                            if (_e582 < 7u) {
                                            } else {
                                                phi_4666_ = true;
                                                break;
                                            }
                                            let _e587 = global_4.member[_e532.member_1][_e582];
                                            let _e590 = (((_e260 + 1u) * 2u) % 7u);
                                            if (_e590 < 7u) {
                                            } else {
                                                phi_4666_ = true;
                                                break;
                                            }
                                            let _e595 = global_4.member[_e532.member_1][_e590];
                                            let _e618 = (bitcast<f32>((bitcast<u32>((_e532.member.member_1.x - _e532.member.member.x)) & 2139095040u)) * 0.0000009536743f);
                                            let _e619 = (bitcast<f32>((bitcast<u32>((_e532.member.member_1.y - _e532.member.member.y)) & 2139095040u)) * 0.0000009536743f);
                                            let _e620 = (bitcast<f32>((bitcast<u32>((_e532.member.member_1.z - _e532.member.member.z)) & 2139095040u)) * 0.0000009536743f);
                                            let _e622 = select(_e139, _e618, (_e618 > _e139));
                                            let _e624 = select(_e139, _e619, (_e619 > _e139));
                                            let _e626 = select(_e139, _e620, (_e620 > _e139));
                                            let _e651 = bitcast<u32>((f32(bitcast<i32>((_e555 & 2097151u))) * _e622));
                                            let _e656 = (bitcast<i32>((_e555 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e659 = bitcast<f32>((_e651 & bitcast<u32>(_e656)));
                                            let _e660 = bitcast<u32>((f32(bitcast<i32>((_e563 & 2097151u))) * _e624));
                                            let _e665 = (bitcast<i32>((_e563 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e668 = bitcast<f32>((_e660 & bitcast<u32>(_e665)));
                                            let _e669 = bitcast<u32>((f32(bitcast<i32>((_e571 & 2097151u))) * _e626));
                                            let _e674 = (bitcast<i32>((_e571 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e677 = bitcast<f32>((_e669 & bitcast<u32>(_e674)));
                                            let _e681 = bitcast<f32>((_e651 & bitcast<u32>(~(_e656))));
                                            let _e685 = bitcast<f32>((_e660 & bitcast<u32>(~(_e665))));
                                            let _e689 = bitcast<f32>((_e669 & bitcast<u32>(~(_e674))));
                                            let _e690 = bitcast<u32>((f32(bitcast<i32>((_e579 & 2097151u))) * _e622));
                                            let _e695 = (bitcast<i32>((_e579 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e698 = bitcast<f32>((_e690 & bitcast<u32>(_e695)));
                                            let _e699 = bitcast<u32>((f32(bitcast<i32>((_e587 & 2097151u))) * _e624));
                                            let _e704 = (bitcast<i32>((_e587 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e707 = bitcast<f32>((_e699 & bitcast<u32>(_e704)));
                                            let _e708 = bitcast<u32>((f32(bitcast<i32>((_e595 & 2097151u))) * _e626));
                                            let _e713 = (bitcast<i32>((_e595 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e716 = bitcast<f32>((_e708 & bitcast<u32>(_e713)));
                                            let _e720 = bitcast<f32>((_e690 & bitcast<u32>(~(_e695))));
                                            let _e724 = bitcast<f32>((_e699 & bitcast<u32>(~(_e704))));
                                            let _e728 = bitcast<f32>((_e708 & bitcast<u32>(~(_e713))));
                                            let _e729 = (_e532.member.member.x + _e659);
                                            let _e730 = (_e532.member.member.y + _e668);
                                            let _e731 = (_e532.member.member.z + _e677);
                                            let _e734 = (_e532.member.member_1.x - _e698);
                                            let _e735 = (_e532.member.member_1.y - _e707);
                                            let _e736 = (_e532.member.member_1.z - _e716);
                                            let _e755 = (_e734 - _e729);
                                            let _e756 = (_e735 - _e730);
                                            let _e757 = (_e736 - _e731);
                                            let _e759 = select(_e756, _e755, (_e755 > _e756));
                                            let _e761 = select(_e757, _e759, (_e759 > _e757));
                                            if (_e761 < (1024f * _e139)) {
                                                phi_3574_ = 0u;
                                            } else {
                                                phi_3574_ = select(2u, 1u, (_e761 < (2097152f * _e139)));
                                            }
                                            let _e768 = phi_3574_;
                                            switch bitcast<i32>(_e768) {
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
                                            let _e771 = phi_3580_;
                                            let _e777 = global_4.member[_e532.member_1][0u];
                                            let _e781 = global_4.member[_e532.member_1][2u];
                                            let _e785 = global_4.member[_e532.member_1][4u];
                                            let _e789 = global_4.member[_e532.member_1][6u];
                                            let _e801 = (((_e781 >> bitcast<u32>(22i)) | ((_e785 >> bitcast<u32>(22i)) << bitcast<u32>(10i))) | ((_e789 >> bitcast<u32>(22i)) << bitcast<u32>(20i)));
                                            let _e802 = (_e777 & 268435455u);
                                            let _e803 = (_e801 & 268435455u);
                                            let _e806 = ((_e777 >> bitcast<u32>(28u)) & 7u);
                                            let _e814 = ((_e777 >> bitcast<u32>(31i)) | (((_e801 >> bitcast<u32>(28u)) & 3u) << bitcast<u32>(1i)));
                                            let _e815 = (_e806 != 0u);
                                            if (_e806 == 0u) {
                                                phi_3835_ = _e802;
                                            } else {
                                                if (_e806 == 7u) {
                                                    phi_3834_ = 2147483648u;
                                                } else {
                                                    phi_3834_ = ((2147483648u | (_e806 << bitcast<u32>(28u))) | (_e803 & 268435455u));
                                                }
                                                let _e824 = phi_3834_;
                                                phi_3835_ = _e824;
                                            }
                                            let _e826 = phi_3835_;
                                            if _e815 {
                                                let _e827 = (_e806 != 7u);
                                                if _e827 {
                                                    phi_3845_ = (_e803 + (_e806 * ((3u * _e771) + 1u)));
                                                } else {
                                                    phi_3845_ = u32();
                                                }
                                                let _e831 = phi_3845_;
                                                phi_3847_ = _e831;
                                                phi_3848_ = select(true, false, _e827);
                                            } else {
                                                phi_3847_ = u32();
                                                phi_3848_ = true;
                                            }
                                            let _e834 = phi_3847_;
                                            let _e836 = phi_3848_;
                                            if (_e814 == 0u) {
                                                phi_3869_ = (_e802 + select(0u, 1u, !(_e815)));
                                            } else {
                                                if (_e814 == 7u) {
                                                    phi_3868_ = 2147483648u;
                                                } else {
                                                    phi_3868_ = ((2147483648u | (_e814 << bitcast<u32>(28u))) | (select(_e834, _e803, _e836) & 268435455u));
                                                }
                                                let _e849 = phi_3868_;
                                                phi_3869_ = _e849;
                                            }
                                            let _e851 = phi_3869_;
                                            phi_3873_ = type_55(array<vec4<f32>, 3>(vec4<f32>(_e729, (_e532.member.member.x + _e681), _e734, (_e532.member.member_1.x - _e720)), vec4<f32>(_e730, (_e532.member.member.y + _e685), _e735, (_e532.member.member_1.y - _e724)), vec4<f32>(_e731, (_e532.member.member.z + _e689), _e736, (_e532.member.member_1.z - _e728))), type_52(type_28((_e532.member.member + vec4<f32>(_e659, _e668, _e677, 0f)), (_e532.member.member_1 - vec4<f32>(_e698, _e707, _e716, 0f))), _e826), type_52(type_28((_e532.member.member + vec4<f32>(_e681, _e685, _e689, 0f)), (_e532.member.member_1 - vec4<f32>(_e720, _e724, _e728, 0f))), _e851));
                                        }
                                        let _e856 = phi_3873_;
                                        let _e868 = ((_e856.member[0].x - _e331) * _e336);
                                        let _e869 = ((_e856.member[0].y - _e331) * _e336);
                                        let _e870 = ((_e856.member[0].z - _e332) * _e336);
                                        let _e871 = ((_e856.member[0].w - _e332) * _e336);
                                        let _e881 = ((_e856.member[1].x - _e369) * _e374);
                                        let _e882 = ((_e856.member[1].y - _e369) * _e374);
                                        let _e883 = ((_e856.member[1].z - _e370) * _e374);
                                        let _e884 = ((_e856.member[1].w - _e370) * _e374);
                                        let _e894 = ((_e856.member[2].x - _e407) * _e412);
                                        let _e895 = ((_e856.member[2].y - _e407) * _e412);
                                        let _e896 = ((_e856.member[2].z - _e408) * _e412);
                                        let _e897 = ((_e856.member[2].w - _e408) * _e412);
                                        let _e899 = select(_e896, _e894, (_e894 < _e896));
                                        let _e901 = select(_e897, _e895, (_e895 < _e897));
                                        let _e903 = select(_e896, _e894, (_e894 > _e896));
                                        let _e905 = select(_e897, _e895, (_e895 > _e897));
                                        let _e907 = select(_e870, _e868, (_e868 < _e870));
                                        let _e909 = select(_e871, _e869, (_e869 < _e871));
                                        let _e911 = select(_e883, _e881, (_e881 < _e883));
                                        let _e913 = select(_e884, _e882, (_e882 < _e884));
                                        let _e915 = select(_e911, _e907, (_e907 > _e911));
                                        let _e917 = select(_e913, _e909, (_e909 > _e913));
                                        let _e919 = select(_e899, _e915, (_e915 > _e899));
                                        let _e921 = select(_e901, _e917, (_e917 > _e901));
                                        let _e923 = select(_e870, _e868, (_e868 > _e870));
                                        let _e925 = select(_e871, _e869, (_e869 > _e871));
                                        let _e927 = select(_e883, _e881, (_e881 > _e883));
                                        let _e929 = select(_e884, _e882, (_e882 > _e884));
                                        let _e931 = select(_e927, _e923, (_e923 < _e927));
                                        let _e933 = select(_e929, _e925, (_e925 < _e929));
                                        let _e938 = -(_e899);
                                        let _e939 = -(_e901);
                                        let _e946 = (select(_e903, _e931, (_e931 < _e903)) + (select(_e938, _e903, (_e903 > _e938)) * 0.0000019073523f));
                                        let _e947 = (select(_e905, _e933, (_e933 < _e905)) + (select(_e939, _e905, (_e905 > _e939)) * 0.0000019073523f));
                                        let _e949 = select(_e459, _e919, (_e919 > _e459));
                                        let _e951 = select(_e459, _e921, (_e921 > _e459));
                                        let _e956 = (_e949 <= select(_e503.member_1, _e946, (_e946 < _e503.member_1)));
                                        let _e957 = (_e951 <= select(_e503.member_1, _e947, (_e947 < _e503.member_1)));
                                        let _e958 = (_e949 <= _e951);
                                        if _e956 {
                                            if _e957 {
                                                if _e958 {
                                                    phi_4217_ = _e856.member_2;
                                                } else {
                                                    phi_4217_ = _e856.member_1;
                                                }
                                                let _e962 = phi_4217_;
                                                let _e963 = (_e536 % 128u);
                                                let _e964 = (_e963 < 128u);
                                                if _e964 {
                                                } else {
                                                    phi_4666_ = true;
                                                    break;
                                                }
                                                local_3[_e963] = type_52(type_28(_e962.member.member, _e962.member.member_1), _e962.member_1);
                                                if _e964 {
                                                } else {
                                                    phi_4666_ = true;
                                                    break;
                                                }
                                                local_2[_e963] = select(_e951, _e949, (_e949 > _e951));
                                                if _e958 {
                                                    phi_4250_ = _e856.member_1;
                                                } else {
                                                    phi_4250_ = _e856.member_2;
                                                }
                                                let _e979 = phi_4250_;
                                                phi_4251_ = _e979;
                                                phi_4252_ = (_e536 + 1u);
                                            } else {
                                                phi_4251_ = type_52();
                                                phi_4252_ = u32();
                                            }
                                            let _e981 = phi_4251_;
                                            let _e983 = phi_4252_;
                                            phi_4254_ = _e981;
                                            phi_4255_ = _e983;
                                            phi_4256_ = select(true, false, _e957);
                                        } else {
                                            phi_4254_ = type_52();
                                            phi_4255_ = u32();
                                            phi_4256_ = true;
                                        }
                                        let _e986 = phi_4254_;
                                        let _e988 = phi_4255_;
                                        let _e990 = phi_4256_;
                                        if _e990 {
                                            if _e956 {
                                                phi_4265_ = _e856.member_1;
                                            } else {
                                                phi_4265_ = _e856.member_2;
                                            }
                                            let _e994 = phi_4265_;
                                            phi_4270_ = _e994;
                                            phi_4271_ = select(_e957, true, _e956);
                                        } else {
                                            phi_4270_ = _e986;
                                            phi_4271_ = _e534;
                                        }
                                        let _e997 = phi_4270_;
                                        let _e999 = phi_4271_;
                                        phi_4670_ = _e501;
                                        phi_4273_ = _e503;
                                        phi_4274_ = _e997;
                                        phi_4275_ = _e999;
                                        phi_4276_ = select(_e988, _e536, _e990);
                                    }
                                    let _e1518 = phi_4670_;
                                    let _e1520 = phi_4273_;
                                    let _e1522 = phi_4274_;
                                    let _e1524 = phi_4275_;
                                    let _e1526 = phi_4276_;
                                    phi_4669_ = _e1518;
                                    phi_4277_ = _e1520;
                                    phi_4278_ = _e1522;
                                    phi_4279_ = (_e507 - 1u);
                                    phi_4280_ = _e1524;
                                    phi_4281_ = _e1526;
                                } else {
                                    phi_4669_ = _e501;
                                    phi_4277_ = _e503;
                                    phi_4278_ = _e532;
                                    phi_4279_ = _e507;
                                    phi_4280_ = _e534;
                                    phi_4281_ = _e536;
                                }
                                let _e1528 = phi_4669_;
                                let _e1530 = phi_4277_;
                                let _e1532 = phi_4278_;
                                let _e1534 = phi_4279_;
                                let _e1536 = phi_4280_;
                                let _e1538 = phi_4281_;
                                phi_4668_ = _e1528;
                                phi_4282_ = _e1530;
                                phi_4283_ = _e1532;
                                phi_4284_ = _e1534;
                                phi_4285_ = _e1536;
                                phi_4286_ = _e1538;
                            } else {
                                phi_4668_ = _e501;
                                phi_4282_ = type_32();
                                phi_4283_ = type_52();
                                phi_4284_ = u32();
                                phi_4285_ = bool();
                                phi_4286_ = u32();
                            }
                            let _e1540 = phi_4668_;
                            let _e1542 = phi_4282_;
                            let _e1544 = phi_4283_;
                            let _e1546 = phi_4284_;
                            let _e1548 = phi_4285_;
                            let _e1550 = phi_4286_;
                            phi_4667_ = _e1540;
                            phi_1892_ = _e1542;
                            phi_1895_ = _e1544;
                            phi_1897_ = _e1546;
                            phi_1899_ = _e1548;
                            phi_1901_ = _e1550;
                            phi_4287_ = _e515;
                        } else {
                            phi_4667_ = _e501;
                            phi_1892_ = type_32();
                            phi_1895_ = type_52();
                            phi_1897_ = u32();
                            phi_1899_ = bool();
                            phi_1901_ = u32();
                            phi_4287_ = false;
                        }
                        let _e1552 = phi_4667_;
                        let _e1554 = phi_1892_;
                        let _e1556 = phi_1895_;
                        let _e1558 = phi_1897_;
                        let _e1560 = phi_1899_;
                        let _e1562 = phi_1901_;
                        let _e1564 = phi_4287_;
                        continue;
                        continuing {
                            phi_4552_ = _e1552;
                            phi_1891_ = _e1554;
                            phi_1894_ = _e1556;
                            phi_1896_ = _e1558;
                            phi_1898_ = _e1560;
                            phi_1900_ = _e1562;
                            phi_4666_ = _e1552;
                            break if !(_e1564);
                        }
                    }
                    let _e1567 = phi_4666_;
                    if _e1567 {
                        break;
                    }
                    let _e1569 = local_7;
                    if (_e1569.member.member_3 != 4294967295u) {
                        let _e1574 = -(_e426);
                        let _e1575 = (_e1574 / 3i);
                        let _e1582 = bitcast<f32>((bitcast<u32>((_e1575 + 127i)) << bitcast<u32>(23i)));
                        let _e1590 = (((_e1569.member.member * _e1582) * _e1582) * bitcast<f32>((bitcast<u32>(((_e1574 - (2i * _e1575)) + 127i)) << bitcast<u32>(23i))));
                        let _e1592 = select(340282350000000000000000000000000000000f, _e1590, (_e1590 < 340282350000000000000000000000000000000f));
                        phi_4339_ = type_20(select(-340282350000000000000000000000000000000f, _e1592, (_e1592 > -340282350000000000000000000000000000000f)), _e1569.member.member_1, _e1569.member.member_2, _e1569.member.member_3);
                    } else {
                        phi_4339_ = type_20(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                    }
                    let _e1599 = phi_4339_;
                    if _e147 {
                    } else {
                        break;
                    }
                    global_6.member[_e145] = _e1599;
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn trace_closest_q21_lattice(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
