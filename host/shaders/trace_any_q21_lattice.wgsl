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

struct type_21 {
    member: array<f32, 3>,
    member_1: f32,
    member_2: array<f32, 3>,
    member_3: f32,
}

struct type_24 {
    member: vec4<f32>,
    member_1: vec4<f32>,
}

struct type_31 {
    member: array<type_21>,
}

struct type_33 {
    member: f32,
    member_1: bool,
}

struct type_35 {
    member: array<vec4<u32>, 2>,
}

struct type_42 {
    member: array<array<u32, 7>>,
}

struct type_48 {
    member: type_24,
    member_1: u32,
}

struct type_51 {
    member: array<vec4<f32>, 3>,
    member_1: type_48,
    member_2: type_48,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_1: type_12;
@group(0) @binding(1) 
var<uniform> global_2: type_35;
@group(0) @binding(4) 
var<storage> global_3: type_31;
@group(0) @binding(5) 
var<storage, read_write> global_4: type_4;
@group(0) @binding(2) 
var<storage> global_5: type_42;
@group(0) @binding(3) 
var<storage> global_6: type_4;

fn function_() {
    var local: array<i32, 3>;
    var local_1: array<i32, 3>;
    var local_2: array<f32, 128>;
    var local_3: array<type_48, 128>;
    var local_4: array<u32, 3>;
    var local_5: array<array<f32, 3>, 3>;
    var local_6: array<f32, 4>;
    var phi_396_: i32;
    var phi_397_: i32;
    var phi_407_: bool;
    var phi_417_: u32;
    var phi_418_: u32;
    var phi_420_: bool;
    var phi_425_: u32;
    var phi_438_: i32;
    var phi_458_: i32;
    var phi_476_: f32;
    var phi_482_: f32;
    var phi_493_: f32;
    var phi_499_: f32;
    var phi_522_: f32;
    var phi_533_: f32;
    var phi_542_: f32;
    var phi_548_: f32;
    var phi_559_: f32;
    var phi_565_: f32;
    var phi_588_: f32;
    var phi_599_: f32;
    var phi_608_: f32;
    var phi_614_: f32;
    var phi_625_: f32;
    var phi_631_: f32;
    var phi_654_: f32;
    var phi_665_: f32;
    var phi_765_: f32;
    var phi_766_: f32;
    var phi_4480_: bool;
    var phi_1886_: type_33;
    var phi_1889_: type_48;
    var phi_1891_: u32;
    var phi_1893_: bool;
    var phi_1895_: u32;
    var phi_1906_: bool;
    var phi_1943_: type_48;
    var phi_1944_: bool;
    var phi_1945_: u32;
    var phi_3548_: u32;
    var phi_3554_: u32;
    var phi_3808_: u32;
    var phi_3809_: u32;
    var phi_3819_: u32;
    var phi_3821_: u32;
    var phi_3822_: bool;
    var phi_3842_: u32;
    var phi_3843_: u32;
    var phi_3847_: type_51;
    var phi_4191_: type_48;
    var phi_4224_: type_48;
    var phi_4225_: type_48;
    var phi_4226_: u32;
    var phi_4228_: type_48;
    var phi_4229_: u32;
    var phi_4230_: bool;
    var phi_4239_: type_48;
    var phi_4244_: type_48;
    var phi_4245_: bool;
    var phi_4477_: bool;
    var phi_1964_: type_33;
    var phi_1967_: type_8;
    var phi_1968_: type_8;
    var phi_1990_: type_8;
    var phi_2031_: u32;
    var phi_2037_: u32;
    var phi_2047_: u32;
    var phi_2063_: u32;
    var phi_2100_: u32;
    var phi_2106_: u32;
    var phi_2116_: u32;
    var phi_4462_: bool;
    var phi_2132_: type_8;
    var phi_2133_: type_8;
    var phi_2156_: type_8;
    var phi_2179_: u32;
    var phi_2194_: u32;
    var phi_2197_: type_8;
    var phi_2198_: type_8;
    var phi_2221_: type_8;
    var phi_2287_: u32;
    var phi_2267_: u32;
    var phi_2268_: u32;
    var phi_2291_: f32;
    var phi_4455_: bool;
    var phi_4534_: bool;
    var phi_4533_: bool;
    var phi_2791_: vec3<f32>;
    var phi_2792_: vec3<f32>;
    var phi_2823_: bool;
    var phi_2832_: vec3<f32>;
    var phi_2872_: type_20;
    var phi_2874_: type_20;
    var phi_2875_: bool;
    var phi_2879_: type_20;
    var phi_2880_: type_20;
    var phi_2881_: type_20;
    var phi_2882_: bool;
    var phi_2886_: type_20;
    var phi_2887_: bool;
    var phi_2891_: type_20;
    var phi_2892_: bool;
    var phi_2896_: type_20;
    var phi_2907_: type_33;
    var phi_2908_: type_33;
    var phi_4536_: bool;
    var phi_1965_: type_33;
    var phi_4535_: bool;
    var local_7: type_33;
    var phi_4595_: bool;
    var phi_4247_: type_33;
    var phi_4248_: type_48;
    var phi_4249_: bool;
    var phi_4250_: u32;
    var phi_4594_: bool;
    var phi_4251_: type_33;
    var phi_4252_: type_48;
    var phi_4253_: u32;
    var phi_4254_: bool;
    var phi_4255_: u32;
    var phi_4593_: bool;
    var phi_4256_: type_33;
    var phi_4257_: type_48;
    var phi_4258_: u32;
    var phi_4259_: bool;
    var phi_4260_: u32;
    var phi_4592_: bool;
    var phi_1887_: type_33;
    var phi_1890_: type_48;
    var phi_1892_: u32;
    var phi_1894_: bool;
    var phi_1896_: u32;
    var phi_4261_: bool;
    var phi_4591_: bool;
    var local_8: type_33;
    var local_9: type_33;

    switch bitcast<i32>(0u) {
        default: {
            let _e86 = global;
            let _e88 = arrayLength((&global_5.member));
            let _e91 = arrayLength((&global_6.member));
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
                let _e147 = (_e145 < arrayLength((&global_4.member)));
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
                            phi_396_ = (bitcast<i32>((_e224 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_396_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e224)), 32u, (_e224 == 0u))));
                        }
                        let _e238 = phi_396_;
                        phi_397_ = _e238;
                    } else {
                        phi_397_ = 0i;
                    }
                    let _e240 = phi_397_;
                    let _e241 = (_e157 == _e196);
                    if _e241 {
                        phi_407_ = true;
                    } else {
                        phi_407_ = (_e164 == _e196);
                    }
                    let _e244 = phi_407_;
                    let _e245 = select(1u, 0u, _e241);
                    if _e244 {
                        let _e246 = (_e245 + 1u);
                        phi_417_ = _e246;
                        phi_418_ = _e246;
                        phi_420_ = select(true, false, (_e246 == 2u));
                    } else {
                        phi_417_ = u32();
                        phi_418_ = 0u;
                        phi_420_ = true;
                    }
                    let _e250 = phi_417_;
                    let _e252 = phi_418_;
                    let _e254 = phi_420_;
                    if _e254 {
                        phi_425_ = (_e252 + 1u);
                    } else {
                        phi_425_ = 0u;
                    }
                    let _e258 = phi_425_;
                    let _e259 = select(_e250, _e252, _e254);
                    let _e260 = select(_e245, select(2u, _e245, _e244), _e254);
                    if (_e127 < -126i) {
                        phi_438_ = -126i;
                    } else {
                        phi_438_ = select(_e127, 127i, (_e127 > 127i));
                    }
                    let _e265 = phi_438_;
                    let _e270 = bitcast<f32>((bitcast<u32>((_e265 + 127i)) << bitcast<u32>(23i)));
                    let _e276 = bitcast<f32>((bitcast<u32>(((_e127 - _e265) + 127i)) << bitcast<u32>(23i)));
                    let _e277 = -(_e240);
                    if (_e277 < -126i) {
                        phi_458_ = -126i;
                    } else {
                        phi_458_ = select(_e277, 127i, (_e277 > 127i));
                    }
                    let _e282 = phi_458_;
                    let _e287 = bitcast<f32>((bitcast<u32>((_e282 + 127i)) << bitcast<u32>(23i)));
                    let _e293 = bitcast<f32>((bitcast<u32>(((_e277 - _e282) + 127i)) << bitcast<u32>(23i)));
                    let _e297 = global_3.member[_e145].member;
                    let _e298 = (_e259 == 0u);
                    if _e298 {
                        phi_476_ = _e297[0];
                    } else {
                        phi_476_ = _e297[1];
                    }
                    let _e302 = phi_476_;
                    let _e303 = (_e259 == 2u);
                    if _e303 {
                        phi_482_ = _e297[2];
                    } else {
                        phi_482_ = _e302;
                    }
                    let _e306 = phi_482_;
                    let _e308 = ((_e306 * _e270) * _e276);
                    let _e309 = global_3.member[_e145].member_2;
                    if _e298 {
                        phi_493_ = _e309[0];
                    } else {
                        phi_493_ = _e309[1];
                    }
                    let _e313 = phi_493_;
                    if _e303 {
                        phi_499_ = _e309[2];
                    } else {
                        phi_499_ = _e313;
                    }
                    let _e316 = phi_499_;
                    let _e318 = ((_e316 * _e287) * _e293);
                    let _e322 = (bitcast<f32>((bitcast<u32>(_e318) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e322 {
                        let _e326 = (bitcast<f32>((bitcast<u32>(_e308) & 2147483647u)) * 0.00000011920929f);
                        phi_522_ = select(0.00000000000011368684f, _e326, (_e326 > 0.00000000000011368684f));
                    } else {
                        phi_522_ = 0f;
                    }
                    let _e330 = phi_522_;
                    let _e331 = (_e308 + _e330);
                    let _e332 = (_e308 - _e330);
                    let _e333 = select(_e318, 0f, _e322);
                    if _e322 {
                        phi_533_ = 38685626000000000000000000f;
                    } else {
                        phi_533_ = (1f / _e318);
                    }
                    let _e336 = phi_533_;
                    let _e337 = (_e258 == 0u);
                    if _e337 {
                        phi_542_ = _e297[0];
                    } else {
                        phi_542_ = _e297[1];
                    }
                    let _e341 = phi_542_;
                    let _e342 = (_e258 == 2u);
                    if _e342 {
                        phi_548_ = _e297[2];
                    } else {
                        phi_548_ = _e341;
                    }
                    let _e345 = phi_548_;
                    let _e347 = ((_e345 * _e270) * _e276);
                    if _e337 {
                        phi_559_ = _e309[0];
                    } else {
                        phi_559_ = _e309[1];
                    }
                    let _e351 = phi_559_;
                    if _e342 {
                        phi_565_ = _e309[2];
                    } else {
                        phi_565_ = _e351;
                    }
                    let _e354 = phi_565_;
                    let _e356 = ((_e354 * _e287) * _e293);
                    let _e360 = (bitcast<f32>((bitcast<u32>(_e356) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e360 {
                        let _e364 = (bitcast<f32>((bitcast<u32>(_e347) & 2147483647u)) * 0.00000011920929f);
                        phi_588_ = select(0.00000000000011368684f, _e364, (_e364 > 0.00000000000011368684f));
                    } else {
                        phi_588_ = 0f;
                    }
                    let _e368 = phi_588_;
                    let _e369 = (_e347 + _e368);
                    let _e370 = (_e347 - _e368);
                    let _e371 = select(_e356, 0f, _e360);
                    if _e360 {
                        phi_599_ = 38685626000000000000000000f;
                    } else {
                        phi_599_ = (1f / _e356);
                    }
                    let _e374 = phi_599_;
                    let _e375 = (_e260 == 0u);
                    if _e375 {
                        phi_608_ = _e297[0];
                    } else {
                        phi_608_ = _e297[1];
                    }
                    let _e379 = phi_608_;
                    let _e380 = (_e260 == 2u);
                    if _e380 {
                        phi_614_ = _e297[2];
                    } else {
                        phi_614_ = _e379;
                    }
                    let _e383 = phi_614_;
                    let _e385 = ((_e383 * _e270) * _e276);
                    if _e375 {
                        phi_625_ = _e309[0];
                    } else {
                        phi_625_ = _e309[1];
                    }
                    let _e389 = phi_625_;
                    if _e380 {
                        phi_631_ = _e309[2];
                    } else {
                        phi_631_ = _e389;
                    }
                    let _e392 = phi_631_;
                    let _e394 = ((_e392 * _e287) * _e293);
                    let _e398 = (bitcast<f32>((bitcast<u32>(_e394) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e398 {
                        let _e402 = (bitcast<f32>((bitcast<u32>(_e385) & 2147483647u)) * 0.00000011920929f);
                        phi_654_ = select(0.00000000000011368684f, _e402, (_e402 > 0.00000000000011368684f));
                    } else {
                        phi_654_ = 0f;
                    }
                    let _e406 = phi_654_;
                    let _e407 = (_e385 + _e406);
                    let _e408 = (_e385 - _e406);
                    let _e409 = select(_e394, 0f, _e398);
                    if _e398 {
                        phi_665_ = 38685626000000000000000000f;
                    } else {
                        phi_665_ = (1f / _e394);
                    }
                    let _e412 = phi_665_;
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
                        phi_765_ = select(-340282350000000000000000000000000000000f, _e453, (_e453 > -340282350000000000000000000000000000000f));
                        phi_766_ = select(-340282350000000000000000000000000000000f, _e446, (_e446 > -340282350000000000000000000000000000000f));
                    } else {
                        phi_765_ = 0f;
                        phi_766_ = 1f;
                    }
                    let _e457 = phi_765_;
                    let _e459 = phi_766_;
                    local_3 = array<type_48, 128>(type_48(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u));
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
                    phi_4480_ = false;
                    phi_1886_ = type_33(_e457, false);
                    phi_1889_ = type_48(type_24(vec4<f32>((f32(_e466) * _e139), (f32(_e472) * _e139), (f32(_e478) * _e139), 0f), vec4<f32>((f32(_e483) * _e139), (f32(_e487) * _e139), (f32(_e491) * _e139), 0f)), select(0u, 2147483648u, (_e88 == 0u)));
                    phi_1891_ = ((3u * _e88) + 1u);
                    phi_1893_ = (_e459 <= _e457);
                    phi_1895_ = 0u;
                    loop {
                        let _e501 = phi_4480_;
                        let _e503 = phi_1886_;
                        let _e505 = phi_1889_;
                        let _e507 = phi_1891_;
                        let _e509 = phi_1893_;
                        let _e511 = phi_1895_;
                        local_8 = _e503;
                        if _e509 {
                            phi_1906_ = true;
                        } else {
                            phi_1906_ = (_e511 > 0u);
                        }
                        let _e514 = phi_1906_;
                        if _e514 {
                            let _e515 = (_e507 > 0u);
                            if _e515 {
                                if _e509 {
                                    phi_1943_ = _e505;
                                    phi_1944_ = _e509;
                                    phi_1945_ = _e511;
                                } else {
                                    let _e516 = (_e511 - 1u);
                                    let _e517 = (_e516 % 128u);
                                    let _e518 = (_e517 < 128u);
                                    if _e518 {
                                    } else {
                                        phi_4591_ = true;
                                        break;
                                    }
                                    let _e520 = local_3[_e517];
                                    if _e518 {
                                    } else {
                                        phi_4591_ = true;
                                        break;
                                    }
                                    let _e528 = local_2[_e517];
                                    phi_1943_ = type_48(type_24(_e520.member.member, _e520.member.member_1), _e520.member_1);
                                    phi_1944_ = (_e528 <= _e503.member);
                                    phi_1945_ = _e516;
                                }
                                let _e532 = phi_1943_;
                                let _e534 = phi_1944_;
                                let _e536 = phi_1945_;
                                if _e534 {
                                    let _e541 = (_e532.member_1 & 268435455u);
                                    if ((_e532.member_1 & 2147483648u) != 0u) {
                                        phi_4477_ = _e501;
                                        phi_1964_ = _e503;
                                        phi_1967_ = type_8(0u, ((_e532.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e1003 = phi_4477_;
                                            let _e1005 = phi_1964_;
                                            let _e1007 = phi_1967_;
                                            local_7 = _e1005;
                                            local_9 = _e1005;
                                            if (_e1007.member < _e1007.member_1) {
                                                phi_1968_ = type_8((_e1007.member + 1u), _e1007.member_1);
                                                phi_1990_ = type_8(1u, _e1007.member);
                                            } else {
                                                phi_1968_ = _e1007;
                                                phi_1990_ = type_8(0u, type_8().member_1);
                                            }
                                            let _e1020 = phi_1968_;
                                            let _e1022 = phi_1990_;
                                            let _e1026 = (bitcast<i32>(_e1022.member) != 0i);
                                            if _e1026 {
                                                let _e1031 = (_e532.member.member_1.x - _e532.member.member.x);
                                                let _e1034 = (_e532.member.member_1.y - _e532.member.member.y);
                                                let _e1037 = (_e532.member.member_1.z - _e532.member.member.z);
                                                let _e1039 = select(_e1034, _e1031, (_e1031 > _e1034));
                                                let _e1041 = select(_e1037, _e1039, (_e1039 > _e1037));
                                                let _e1043 = (_e1041 < (1024f * _e139));
                                                if _e1043 {
                                                    phi_2031_ = 0u;
                                                } else {
                                                    phi_2031_ = select(2u, 1u, (_e1041 < (2097152f * _e139)));
                                                }
                                                let _e1048 = phi_2031_;
                                                switch bitcast<i32>(_e1048) {
                                                    case 0: {
                                                        phi_2037_ = 1u;
                                                        break;
                                                    }
                                                    case 1: {
                                                        phi_2037_ = 2u;
                                                        break;
                                                    }
                                                    case 2: {
                                                        phi_2037_ = 3u;
                                                        break;
                                                    }
                                                    default: {
                                                        phi_2037_ = u32();
                                                        break;
                                                    }
                                                }
                                                let _e1051 = phi_2037_;
                                                switch bitcast<i32>(_e1048) {
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
                                                let _e1058 = phi_2047_;
                                                let _e1060 = ((_e541 + (_e1022.member_1 * ((3u * _e1051) + 1u))) + (3u * _e1058));
                                                let _e1061 = (_e1060 < _e91);
                                                if _e1061 {
                                                    if _e1061 {
                                                    } else {
                                                        phi_4535_ = true;
                                                        break;
                                                    }
                                                    let _e1063 = global_6.member[_e1060];
                                                    phi_2063_ = _e1063;
                                                } else {
                                                    phi_2063_ = 4294967295u;
                                                }
                                                let _e1065 = phi_2063_;
                                                local_4 = array<u32, 3>(_e259, _e258, _e260);
                                                if _e1043 {
                                                    phi_2100_ = 0u;
                                                } else {
                                                    phi_2100_ = select(2u, 1u, (_e1041 < (2097152f * _e139)));
                                                }
                                                let _e1071 = phi_2100_;
                                                switch bitcast<i32>(_e1071) {
                                                    case 0: {
                                                        phi_2106_ = 1u;
                                                        break;
                                                    }
                                                    case 1: {
                                                        phi_2106_ = 2u;
                                                        break;
                                                    }
                                                    case 2: {
                                                        phi_2106_ = 3u;
                                                        break;
                                                    }
                                                    default: {
                                                        phi_2106_ = u32();
                                                        break;
                                                    }
                                                }
                                                let _e1074 = phi_2106_;
                                                switch bitcast<i32>(_e1071) {
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
                                                let _e1081 = phi_2116_;
                                                local_6 = array<f32, 4>(_e532.member.member.x, _e532.member.member.y, _e532.member.member.z, _e532.member.member.w);
                                                local_5[0u] = array<f32, 3>(0f, 0f, 0f);
                                                local_5[1u] = array<f32, 3>(0f, 0f, 0f);
                                                local_5[2u] = array<f32, 3>(0f, 0f, 0f);
                                                phi_4462_ = _e1003;
                                                phi_2132_ = type_8(0u, 3u);
                                                loop {
                                                    let _e1095 = phi_4462_;
                                                    let _e1097 = phi_2132_;
                                                    if (_e1097.member < _e1097.member_1) {
                                                        phi_2133_ = type_8((_e1097.member + 1u), _e1097.member_1);
                                                        phi_2156_ = type_8(1u, _e1097.member);
                                                    } else {
                                                        phi_2133_ = _e1097;
                                                        phi_2156_ = type_8(0u, type_8().member_1);
                                                    }
                                                    let _e1110 = phi_2133_;
                                                    let _e1112 = phi_2156_;
                                                    let _e1116 = (bitcast<i32>(_e1112.member) != 0i);
                                                    if _e1116 {
                                                        let _e1118 = ((_e541 + (_e1022.member_1 * ((3u * _e1074) + 1u))) + (_e1112.member_1 * _e1081));
                                                        let _e1119 = (_e1118 < _e91);
                                                        if _e1119 {
                                                            if _e1119 {
                                                            } else {
                                                                phi_4533_ = true;
                                                                break;
                                                            }
                                                            let _e1121 = global_6.member[_e1118];
                                                            phi_2179_ = _e1121;
                                                        } else {
                                                            phi_2179_ = 0u;
                                                        }
                                                        let _e1123 = phi_2179_;
                                                        let _e1124 = (_e1118 + 1u);
                                                        let _e1125 = (_e1124 < _e91);
                                                        if _e1125 {
                                                            if _e1125 {
                                                            } else {
                                                                phi_4533_ = true;
                                                                break;
                                                            }
                                                            let _e1127 = global_6.member[_e1124];
                                                            phi_2194_ = _e1127;
                                                        } else {
                                                            phi_2194_ = 0u;
                                                        }
                                                        let _e1129 = phi_2194_;
                                                        phi_2197_ = type_8(0u, 3u);
                                                        loop {
                                                            let _e1131 = phi_2197_;
                                                            if (_e1131.member < _e1131.member_1) {
                                                                phi_2198_ = type_8((_e1131.member + 1u), _e1131.member_1);
                                                                phi_2221_ = type_8(1u, _e1131.member);
                                                            } else {
                                                                phi_2198_ = _e1131;
                                                                phi_2221_ = type_8(0u, type_8().member_1);
                                                            }
                                                            let _e1144 = phi_2198_;
                                                            let _e1146 = phi_2221_;
                                                            let _e1150 = (bitcast<i32>(_e1146.member) != 0i);
                                                            if _e1150 {
                                                                let _e1151 = (_e1146.member_1 < 3u);
                                                                if _e1151 {
                                                                } else {
                                                                    phi_4455_ = true;
                                                                    break;
                                                                }
                                                                let _e1153 = local_4[_e1146.member_1];
                                                                if (_e1146.member_1 < 4u) {
                                                                } else {
                                                                    phi_4455_ = true;
                                                                    break;
                                                                }
                                                                let _e1156 = local_6[_e1146.member_1];
                                                                switch bitcast<i32>(_e1071) {
                                                                    case 0: {
                                                                        phi_2291_ = (_e1156 + (f32(((_e1123 >> bitcast<u32>(((10u * _e1153) & 31u))) & 1023u)) * _e139));
                                                                        break;
                                                                    }
                                                                    case 1: {
                                                                        if (_e1153 == 0u) {
                                                                            phi_2268_ = _e1123;
                                                                        } else {
                                                                            if (_e1153 == 1u) {
                                                                                phi_2267_ = ((_e1123 >> bitcast<u32>(21i)) | (_e1129 << bitcast<u32>(11i)));
                                                                            } else {
                                                                                phi_2267_ = (_e1129 >> bitcast<u32>(10i));
                                                                            }
                                                                            let _e1177 = phi_2267_;
                                                                            phi_2268_ = _e1177;
                                                                        }
                                                                        let _e1179 = phi_2268_;
                                                                        phi_2291_ = (_e1156 + (f32((_e1179 & 2097151u)) * _e139));
                                                                        break;
                                                                    }
                                                                    case 2: {
                                                                        let _e1158 = (_e1118 + _e1153);
                                                                        let _e1159 = (_e1158 < _e91);
                                                                        if _e1159 {
                                                                            if _e1159 {
                                                                            } else {
                                                                                phi_4455_ = true;
                                                                                break;
                                                                            }
                                                                            let _e1161 = global_6.member[_e1158];
                                                                            phi_2287_ = _e1161;
                                                                        } else {
                                                                            phi_2287_ = 0u;
                                                                        }
                                                                        let _e1163 = phi_2287_;
                                                                        phi_2291_ = (f32(bitcast<i32>(_e1163)) * _e139);
                                                                        break;
                                                                    }
                                                                    default: {
                                                                        phi_2291_ = f32();
                                                                        break;
                                                                    }
                                                                }
                                                                let _e1193 = phi_2291_;
                                                                if (_e1112.member_1 < 3u) {
                                                                } else {
                                                                    phi_4455_ = true;
                                                                    break;
                                                                }
                                                                if _e1151 {
                                                                } else {
                                                                    phi_4455_ = true;
                                                                    break;
                                                                }
                                                                local_5[_e1112.member_1][_e1146.member_1] = _e1193;
                                                            }
                                                            continue;
                                                            continuing {
                                                                phi_2197_ = _e1144;
                                                                phi_4455_ = _e1095;
                                                                break if !(_e1150);
                                                            }
                                                        }
                                                        let _e1199 = phi_4455_;
                                                        phi_4533_ = _e1199;
                                                        if _e1199 {
                                                            break;
                                                        }
                                                        phi_4534_ = _e1199;
                                                    } else {
                                                        phi_4534_ = _e1095;
                                                    }
                                                    let _e1201 = phi_4534_;
                                                    continue;
                                                    continuing {
                                                        phi_4462_ = _e1201;
                                                        phi_2132_ = _e1110;
                                                        phi_4533_ = _e1201;
                                                        break if !(_e1116);
                                                    }
                                                }
                                                let _e1204 = phi_4533_;
                                                phi_4535_ = _e1204;
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
                                                        phi_2886_ = type_20();
                                                        phi_2887_ = true;
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
                                                            phi_2881_ = type_20();
                                                            phi_2882_ = true;
                                                        } else {
                                                            let _e1343 = (_e1341 > _e1005.member);
                                                            if _e1343 {
                                                                phi_2880_ = type_20();
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
                                                                    phi_2791_ = _e1354;
                                                                    phi_2792_ = _e1358;
                                                                } else {
                                                                    let _e1404 = vec3((_e1384 == _e1401));
                                                                    phi_2791_ = select(_e1350, _e1358, _e1404);
                                                                    phi_2792_ = select(_e1354, _e1350, _e1404);
                                                                }
                                                                let _e1408 = phi_2791_;
                                                                let _e1410 = phi_2792_;
                                                                let _e1417 = ((_e1408.y * _e1410.z) - (_e1410.y * _e1408.z));
                                                                let _e1422 = ((_e1408.z * _e1410.x) - (_e1410.z * _e1408.x));
                                                                let _e1425 = ((_e1408.x * _e1410.y) - (_e1410.x * _e1408.y));
                                                                if (_e1267 >= _e1271) {
                                                                    phi_2823_ = select(true, false, (_e1267 >= _e1275));
                                                                } else {
                                                                    phi_2823_ = true;
                                                                }
                                                                let _e1430 = phi_2823_;
                                                                if _e1430 {
                                                                    phi_2832_ = select(vec3<f32>(_e1205[2][0], _e1205[2][1], _e1205[2][2]), vec3<f32>(_e1205[1][0], _e1205[1][1], _e1205[1][2]), vec3((_e1271 >= _e1275)));
                                                                } else {
                                                                    phi_2832_ = vec3<f32>(_e1205[0][0], _e1205[0][1], _e1205[0][2]);
                                                                }
                                                                let _e1435 = phi_2832_;
                                                                let _e1452 = ((((_e1417 * (_e1435.x - _e308)) + (_e1422 * (_e1435.y - _e347))) + (_e1425 * (_e1435.z - _e385))) / (((_e1417 * _e333) + (_e1422 * _e371)) + (_e1425 * _e409)));
                                                                let _e1454 = select(_e1334, _e1452, (_e1452 < _e1334));
                                                                let _e1456 = select(_e1326, _e1454, (_e1454 > _e1326));
                                                                if (_e1456 >= _e459) {
                                                                    let _e1458 = (_e1456 <= _e1005.member);
                                                                    if _e1458 {
                                                                        let _e1459 = (1f / _e1277);
                                                                        phi_2872_ = type_20(_e1456, (_e1271 * _e1459), (_e1275 * _e1459), _e1065);
                                                                    } else {
                                                                        phi_2872_ = type_20();
                                                                    }
                                                                    let _e1464 = phi_2872_;
                                                                    phi_2874_ = _e1464;
                                                                    phi_2875_ = select(true, false, _e1458);
                                                                } else {
                                                                    phi_2874_ = type_20();
                                                                    phi_2875_ = true;
                                                                }
                                                                let _e1467 = phi_2874_;
                                                                let _e1469 = phi_2875_;
                                                                if _e1469 {
                                                                    phi_2879_ = type_20(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                } else {
                                                                    phi_2879_ = _e1467;
                                                                }
                                                                let _e1471 = phi_2879_;
                                                                phi_2880_ = _e1471;
                                                            }
                                                            let _e1473 = phi_2880_;
                                                            phi_2881_ = _e1473;
                                                            phi_2882_ = _e1343;
                                                        }
                                                        let _e1475 = phi_2881_;
                                                        let _e1477 = phi_2882_;
                                                        phi_2886_ = _e1475;
                                                        phi_2887_ = _e1477;
                                                    }
                                                    let _e1479 = phi_2886_;
                                                    let _e1481 = phi_2887_;
                                                    phi_2891_ = _e1479;
                                                    phi_2892_ = _e1481;
                                                } else {
                                                    phi_2891_ = type_20();
                                                    phi_2892_ = true;
                                                }
                                                let _e1483 = phi_2891_;
                                                let _e1485 = phi_2892_;
                                                if _e1485 {
                                                    phi_2896_ = type_20(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                } else {
                                                    phi_2896_ = _e1483;
                                                }
                                                let _e1487 = phi_2896_;
                                                if (_e1487.member_3 != 4294967295u) {
                                                    if (_e1065 != 4294967295u) {
                                                        phi_2907_ = type_33(_e1005.member, true);
                                                    } else {
                                                        phi_2907_ = _e1005;
                                                    }
                                                    let _e1495 = phi_2907_;
                                                    phi_2908_ = _e1495;
                                                } else {
                                                    phi_2908_ = _e1005;
                                                }
                                                let _e1497 = phi_2908_;
                                                phi_4536_ = _e1204;
                                                phi_1965_ = _e1497;
                                            } else {
                                                phi_4536_ = _e1003;
                                                phi_1965_ = type_33();
                                            }
                                            let _e1499 = phi_4536_;
                                            let _e1501 = phi_1965_;
                                            continue;
                                            continuing {
                                                phi_4477_ = _e1499;
                                                phi_1964_ = _e1501;
                                                phi_1967_ = _e1020;
                                                phi_4535_ = _e1499;
                                                break if !(_e1026);
                                            }
                                        }
                                        let _e1504 = phi_4535_;
                                        phi_4591_ = _e1504;
                                        if _e1504 {
                                            break;
                                        }
                                        let _e1506 = local_7;
                                        phi_4595_ = _e1504;
                                        let _e1678 = local_9;
                                        phi_4247_ = _e1678;
                                        phi_4248_ = _e532;
                                        phi_4249_ = false;
                                        phi_4250_ = select(_e536, 0u, _e1506.member_1);
                                    } else {
                                        if (_e532.member_1 >= _e88) {
                                            phi_3847_ = type_51(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), type_48(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u), type_48(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u));
                                        } else {
                                            if (_e532.member_1 < _e88) {
                                            } else {
                                                phi_4591_ = true;
                                                break;
                                            }
                                            let _e550 = ((1u + (_e259 * 2u)) % 7u);
                                            if (_e550 < 7u) {
                                            } else {
                                                phi_4591_ = true;
                                                break;
                                            }
                                            let _e555 = global_5.member[_e532.member_1][_e550];
                                            let _e558 = ((1u + (_e258 * 2u)) % 7u);
                                            if (_e558 < 7u) {
                                            } else {
                                                phi_4591_ = true;
                                                break;
                                            }
                                            let _e563 = global_5.member[_e532.member_1][_e558];
                                            let _e566 = ((1u + (_e260 * 2u)) % 7u);
                                            if (_e566 < 7u) {
                                            } else {
                                                phi_4591_ = true;
                                                break;
                                            }
                                            let _e571 = global_5.member[_e532.member_1][_e566];
                                            let _e574 = (((_e259 + 1u) * 2u) % 7u);
                                            if (_e574 < 7u) {
                                            } else {
                                                phi_4591_ = true;
                                                break;
                                            }
                                            let _e579 = global_5.member[_e532.member_1][_e574];
                                            let _e582 = (((_e258 + 1u) * 2u) % 7u);
                                            if (_e582 < 7u) {
                                            } else {
                                                phi_4591_ = true;
                                                break;
                                            }
                                            let _e587 = global_5.member[_e532.member_1][_e582];
                                            let _e590 = (((_e260 + 1u) * 2u) % 7u);
                                            if (_e590 < 7u) {
                                            } else {
                                                phi_4591_ = true;
                                                break;
                                            }
                                            let _e595 = global_5.member[_e532.member_1][_e590];
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
                                                phi_3548_ = 0u;
                                            } else {
                                                phi_3548_ = select(2u, 1u, (_e761 < (2097152f * _e139)));
                                            }
                                            let _e768 = phi_3548_;
                                            switch bitcast<i32>(_e768) {
                                                case 0: {
                                                    phi_3554_ = 1u;
                                                    break;
                                                }
                                                case 1: {
                                                    phi_3554_ = 2u;
                                                    break;
                                                }
                                                case 2: {
                                                    phi_3554_ = 3u;
                                                    break;
                                                }
                                                default: {
                                                    phi_3554_ = u32();
                                                    break;
                                                }
                                            }
                                            let _e771 = phi_3554_;
                                            let _e777 = global_5.member[_e532.member_1][0u];
                                            let _e781 = global_5.member[_e532.member_1][2u];
                                            let _e785 = global_5.member[_e532.member_1][4u];
                                            let _e789 = global_5.member[_e532.member_1][6u];
                                            let _e801 = (((_e781 >> bitcast<u32>(22i)) | ((_e785 >> bitcast<u32>(22i)) << bitcast<u32>(10i))) | ((_e789 >> bitcast<u32>(22i)) << bitcast<u32>(20i)));
                                            let _e802 = (_e777 & 268435455u);
                                            let _e803 = (_e801 & 268435455u);
                                            let _e806 = ((_e777 >> bitcast<u32>(28u)) & 7u);
                                            let _e814 = ((_e777 >> bitcast<u32>(31i)) | (((_e801 >> bitcast<u32>(28u)) & 3u) << bitcast<u32>(1i)));
                                            let _e815 = (_e806 != 0u);
                                            if (_e806 == 0u) {
                                                phi_3809_ = _e802;
                                            } else {
                                                if (_e806 == 7u) {
                                                    phi_3808_ = 2147483648u;
                                                } else {
                                                    phi_3808_ = ((2147483648u | (_e806 << bitcast<u32>(28u))) | (_e803 & 268435455u));
                                                }
                                                let _e824 = phi_3808_;
                                                phi_3809_ = _e824;
                                            }
                                            let _e826 = phi_3809_;
                                            if _e815 {
                                                let _e827 = (_e806 != 7u);
                                                if _e827 {
                                                    phi_3819_ = (_e803 + (_e806 * ((3u * _e771) + 1u)));
                                                } else {
                                                    phi_3819_ = u32();
                                                }
                                                let _e831 = phi_3819_;
                                                phi_3821_ = _e831;
                                                phi_3822_ = select(true, false, _e827);
                                            } else {
                                                phi_3821_ = u32();
                                                phi_3822_ = true;
                                            }
                                            let _e834 = phi_3821_;
                                            let _e836 = phi_3822_;
                                            if (_e814 == 0u) {
                                                phi_3843_ = (_e802 + select(0u, 1u, !(_e815)));
                                            } else {
                                                if (_e814 == 7u) {
                                                    phi_3842_ = 2147483648u;
                                                } else {
                                                    phi_3842_ = ((2147483648u | (_e814 << bitcast<u32>(28u))) | (select(_e834, _e803, _e836) & 268435455u));
                                                }
                                                let _e849 = phi_3842_;
                                                phi_3843_ = _e849;
                                            }
                                            let _e851 = phi_3843_;
                                            phi_3847_ = type_51(array<vec4<f32>, 3>(vec4<f32>(_e729, (_e532.member.member.x + _e681), _e734, (_e532.member.member_1.x - _e720)), vec4<f32>(_e730, (_e532.member.member.y + _e685), _e735, (_e532.member.member_1.y - _e724)), vec4<f32>(_e731, (_e532.member.member.z + _e689), _e736, (_e532.member.member_1.z - _e728))), type_48(type_24((_e532.member.member + vec4<f32>(_e659, _e668, _e677, 0f)), (_e532.member.member_1 - vec4<f32>(_e698, _e707, _e716, 0f))), _e826), type_48(type_24((_e532.member.member + vec4<f32>(_e681, _e685, _e689, 0f)), (_e532.member.member_1 - vec4<f32>(_e720, _e724, _e728, 0f))), _e851));
                                        }
                                        let _e856 = phi_3847_;
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
                                        let _e956 = (_e949 <= select(_e503.member, _e946, (_e946 < _e503.member)));
                                        let _e957 = (_e951 <= select(_e503.member, _e947, (_e947 < _e503.member)));
                                        let _e958 = (_e949 <= _e951);
                                        if _e956 {
                                            if _e957 {
                                                if _e958 {
                                                    phi_4191_ = _e856.member_2;
                                                } else {
                                                    phi_4191_ = _e856.member_1;
                                                }
                                                let _e962 = phi_4191_;
                                                let _e963 = (_e536 % 128u);
                                                let _e964 = (_e963 < 128u);
                                                if _e964 {
                                                } else {
                                                    phi_4591_ = true;
                                                    break;
                                                }
                                                local_3[_e963] = type_48(type_24(_e962.member.member, _e962.member.member_1), _e962.member_1);
                                                if _e964 {
                                                } else {
                                                    phi_4591_ = true;
                                                    break;
                                                }
                                                local_2[_e963] = select(_e951, _e949, (_e949 > _e951));
                                                if _e958 {
                                                    phi_4224_ = _e856.member_1;
                                                } else {
                                                    phi_4224_ = _e856.member_2;
                                                }
                                                let _e979 = phi_4224_;
                                                phi_4225_ = _e979;
                                                phi_4226_ = (_e536 + 1u);
                                            } else {
                                                phi_4225_ = type_48();
                                                phi_4226_ = u32();
                                            }
                                            let _e981 = phi_4225_;
                                            let _e983 = phi_4226_;
                                            phi_4228_ = _e981;
                                            phi_4229_ = _e983;
                                            phi_4230_ = select(true, false, _e957);
                                        } else {
                                            phi_4228_ = type_48();
                                            phi_4229_ = u32();
                                            phi_4230_ = true;
                                        }
                                        let _e986 = phi_4228_;
                                        let _e988 = phi_4229_;
                                        let _e990 = phi_4230_;
                                        if _e990 {
                                            if _e956 {
                                                phi_4239_ = _e856.member_1;
                                            } else {
                                                phi_4239_ = _e856.member_2;
                                            }
                                            let _e994 = phi_4239_;
                                            phi_4244_ = _e994;
                                            phi_4245_ = select(_e957, true, _e956);
                                        } else {
                                            phi_4244_ = _e986;
                                            phi_4245_ = _e534;
                                        }
                                        let _e997 = phi_4244_;
                                        let _e999 = phi_4245_;
                                        phi_4595_ = _e501;
                                        phi_4247_ = _e503;
                                        phi_4248_ = _e997;
                                        phi_4249_ = _e999;
                                        phi_4250_ = select(_e988, _e536, _e990);
                                    }
                                    let _e1510 = phi_4595_;
                                    let _e1512 = phi_4247_;
                                    let _e1514 = phi_4248_;
                                    let _e1516 = phi_4249_;
                                    let _e1518 = phi_4250_;
                                    phi_4594_ = _e1510;
                                    phi_4251_ = _e1512;
                                    phi_4252_ = _e1514;
                                    phi_4253_ = (_e507 - 1u);
                                    phi_4254_ = _e1516;
                                    phi_4255_ = _e1518;
                                } else {
                                    phi_4594_ = _e501;
                                    phi_4251_ = _e503;
                                    phi_4252_ = _e532;
                                    phi_4253_ = _e507;
                                    phi_4254_ = _e534;
                                    phi_4255_ = _e536;
                                }
                                let _e1520 = phi_4594_;
                                let _e1522 = phi_4251_;
                                let _e1524 = phi_4252_;
                                let _e1526 = phi_4253_;
                                let _e1528 = phi_4254_;
                                let _e1530 = phi_4255_;
                                phi_4593_ = _e1520;
                                phi_4256_ = _e1522;
                                phi_4257_ = _e1524;
                                phi_4258_ = _e1526;
                                phi_4259_ = _e1528;
                                phi_4260_ = _e1530;
                            } else {
                                phi_4593_ = _e501;
                                phi_4256_ = type_33();
                                phi_4257_ = type_48();
                                phi_4258_ = u32();
                                phi_4259_ = bool();
                                phi_4260_ = u32();
                            }
                            let _e1532 = phi_4593_;
                            let _e1534 = phi_4256_;
                            let _e1536 = phi_4257_;
                            let _e1538 = phi_4258_;
                            let _e1540 = phi_4259_;
                            let _e1542 = phi_4260_;
                            phi_4592_ = _e1532;
                            phi_1887_ = _e1534;
                            phi_1890_ = _e1536;
                            phi_1892_ = _e1538;
                            phi_1894_ = _e1540;
                            phi_1896_ = _e1542;
                            phi_4261_ = _e515;
                        } else {
                            phi_4592_ = _e501;
                            phi_1887_ = type_33();
                            phi_1890_ = type_48();
                            phi_1892_ = u32();
                            phi_1894_ = bool();
                            phi_1896_ = u32();
                            phi_4261_ = false;
                        }
                        let _e1544 = phi_4592_;
                        let _e1546 = phi_1887_;
                        let _e1548 = phi_1890_;
                        let _e1550 = phi_1892_;
                        let _e1552 = phi_1894_;
                        let _e1554 = phi_1896_;
                        let _e1556 = phi_4261_;
                        continue;
                        continuing {
                            phi_4480_ = _e1544;
                            phi_1886_ = _e1546;
                            phi_1889_ = _e1548;
                            phi_1891_ = _e1550;
                            phi_1893_ = _e1552;
                            phi_1895_ = _e1554;
                            phi_4591_ = _e1544;
                            break if !(_e1556);
                        }
                    }
                    let _e1559 = phi_4591_;
                    if _e1559 {
                        break;
                    }
                    let _e1561 = local_8;
                    if _e147 {
                    } else {
                        break;
                    }
                    global_4.member[_e145] = select(0u, 1u, _e1561.member_1);
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn trace_any_q21_lattice(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
