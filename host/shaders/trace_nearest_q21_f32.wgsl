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

struct type_25 {
    member: vec4<f32>,
    member_1: vec4<f32>,
}

struct type_32 {
    member: array<type_22>,
}

struct type_36 {
    member: array<array<type_21, 8>>,
}

struct type_42 {
    member: array<vec4<u32>, 2>,
}

struct type_49 {
    member: array<array<u32, 7>>,
}

struct type_51 {
    member: type_25,
    member_1: u32,
}

struct type_54 {
    member: array<vec4<f32>, 3>,
    member_1: type_51,
    member_2: type_51,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_1: type_8;
@group(0) @binding(3) 
var<storage> global_2: type_15;
@group(0) @binding(1) 
var<uniform> global_3: type_42;
@group(0) @binding(4) 
var<storage> global_4: type_32;
@group(0) @binding(2) 
var<storage> global_5: type_49;
@group(0) @binding(5) 
var<storage, read_write> global_6: type_36;

fn function_() {
    var local: array<i32, 3>;
    var local_1: array<i32, 3>;
    var local_2: array<type_21, 8>;
    var local_3: array<f32, 128>;
    var local_4: array<type_51, 128>;
    var phi_385_: i32;
    var phi_386_: i32;
    var phi_396_: bool;
    var phi_406_: u32;
    var phi_407_: u32;
    var phi_409_: bool;
    var phi_414_: u32;
    var phi_459_: f32;
    var phi_465_: f32;
    var phi_476_: f32;
    var phi_482_: f32;
    var phi_505_: f32;
    var phi_516_: f32;
    var phi_525_: f32;
    var phi_531_: f32;
    var phi_542_: f32;
    var phi_548_: f32;
    var phi_571_: f32;
    var phi_582_: f32;
    var phi_591_: f32;
    var phi_597_: f32;
    var phi_608_: f32;
    var phi_614_: f32;
    var phi_637_: f32;
    var phi_648_: f32;
    var phi_748_: f32;
    var phi_749_: f32;
    var phi_4572_: bool;
    var phi_4485_: f32;
    var phi_1922_: type_51;
    var phi_1925_: u32;
    var phi_1927_: bool;
    var phi_1929_: u32;
    var phi_1940_: bool;
    var phi_1978_: type_51;
    var phi_1979_: bool;
    var phi_1980_: u32;
    var phi_3676_: u32;
    var phi_3677_: u32;
    var phi_3687_: u32;
    var phi_3689_: u32;
    var phi_3690_: bool;
    var phi_3710_: u32;
    var phi_3711_: u32;
    var phi_3715_: type_54;
    var phi_4060_: type_51;
    var phi_4093_: type_51;
    var phi_4094_: type_51;
    var phi_4095_: u32;
    var phi_4097_: type_51;
    var phi_4098_: u32;
    var phi_4099_: bool;
    var phi_4108_: type_51;
    var phi_4113_: type_51;
    var phi_4114_: bool;
    var phi_4569_: bool;
    var phi_4559_: f32;
    var phi_1998_: type_4;
    var phi_1999_: type_4;
    var phi_2022_: type_4;
    var phi_2043_: u32;
    var phi_2132_: array<array<f32, 3>, 3>;
    var phi_2604_: vec3<f32>;
    var phi_2605_: vec3<f32>;
    var phi_2636_: bool;
    var phi_2645_: vec3<f32>;
    var phi_2685_: type_21;
    var phi_2687_: type_21;
    var phi_2688_: bool;
    var phi_2692_: type_21;
    var phi_2693_: type_21;
    var phi_2694_: type_21;
    var phi_2695_: bool;
    var phi_2699_: type_21;
    var phi_2700_: bool;
    var phi_2704_: type_21;
    var phi_2705_: bool;
    var phi_2709_: type_21;
    var phi_2721_: type_4;
    var phi_2724_: type_21;
    var phi_2722_: type_4;
    var phi_2747_: type_4;
    var phi_2779_: bool;
    var phi_2780_: bool;
    var phi_2801_: type_21;
    var phi_2725_: type_21;
    var phi_4560_: bool;
    var phi_4890_: f32;
    var phi_4889_: f32;
    var phi_4673_: bool;
    var phi_4888_: f32;
    var phi_4672_: bool;
    var phi_4887_: f32;
    var phi_4671_: bool;
    var phi_4827_: f32;
    var phi_4670_: bool;
    var phi_4792_: f32;
    var phi_4679_: bool;
    var phi_4116_: type_51;
    var phi_4117_: bool;
    var phi_4118_: u32;
    var phi_4791_: f32;
    var phi_4678_: bool;
    var phi_4119_: type_51;
    var phi_4120_: u32;
    var phi_4121_: bool;
    var phi_4122_: u32;
    var phi_4790_: f32;
    var phi_4677_: bool;
    var phi_4123_: type_51;
    var phi_4124_: u32;
    var phi_4125_: bool;
    var phi_4126_: u32;
    var phi_4789_: f32;
    var phi_4676_: bool;
    var phi_1923_: type_51;
    var phi_1926_: u32;
    var phi_1928_: bool;
    var phi_1930_: u32;
    var phi_4127_: bool;
    var phi_4675_: bool;
    var phi_4134_: type_4;
    var phi_4135_: type_4;
    var phi_4158_: type_4;
    var phi_4224_: type_21;
    var phi_4782_: bool;

    switch bitcast<i32>(0u) {
        default: {
            let _e80 = global;
            let _e82 = arrayLength((&global_5.member));
            let _e84 = arrayLength((&global_2.member));
            let _e92 = global_3.member[0u][0u];
            let _e96 = global_3.member[0u][1u];
            let _e100 = global_3.member[0u][2u];
            let _e104 = global_3.member[0u][3u];
            let _e108 = global_3.member[1u][0u];
            let _e112 = global_3.member[1u][1u];
            let _e116 = global_3.member[1u][2u];
            let _e119 = global_1.member[0u];
            let _e120 = bitcast<i32>(_e119);
            let _e132 = bitcast<f32>((bitcast<u32>((bitcast<i32>(_e104) + 127i)) << bitcast<u32>(23i)));
            local_1 = array<i32, 3>(bitcast<i32>(_e92), bitcast<i32>(_e96), bitcast<i32>(_e100));
            local = array<i32, 3>(bitcast<i32>(_e108), bitcast<i32>(_e112), bitcast<i32>(_e116));
            let _e138 = (_e80.x + (_e80.y * 2097152u));
            let _e139 = (_e138 < arrayLength((&global_4.member)));
            if _e139 {
                let _e140 = (_e138 < arrayLength((&global_6.member)));
                if _e140 {
                    if _e139 {
                    } else {
                        break;
                    }
                    let _e148 = global_4.member[_e138].member_2[0u];
                    let _e150 = (bitcast<u32>(_e148) & 2147483647u);
                    let _e155 = global_4.member[_e138].member_2[1u];
                    let _e157 = (bitcast<u32>(_e155) & 2147483647u);
                    let _e162 = global_4.member[_e138].member_2[2u];
                    let _e164 = (bitcast<u32>(_e162) & 2147483647u);
                    let _e169 = global_4.member[_e138].member[0u];
                    let _e171 = (bitcast<u32>(_e169) & 2147483647u);
                    let _e176 = global_4.member[_e138].member[1u];
                    let _e178 = (bitcast<u32>(_e176) & 2147483647u);
                    let _e183 = global_4.member[_e138].member[2u];
                    let _e185 = (bitcast<u32>(_e183) & 2147483647u);
                    let _e187 = select(_e157, _e150, (_e157 < _e150));
                    let _e189 = select(_e164, _e187, (_e164 < _e187));
                    let _e191 = select(_e171, _e189, (_e171 < _e189));
                    let _e193 = select(_e178, _e191, (_e178 < _e191));
                    let _e195 = select(_e185, _e193, (_e185 < _e193));
                    let _e199 = global_4.member[_e138].member_1;
                    let _e201 = (bitcast<u32>(_e199) & 2147483647u);
                    let _e208 = global_4.member[_e138].member_3;
                    let _e214 = (((select(_e201, _e195, (_e201 < _e195)) < 2139095040u) && ((bitcast<u32>(_e208) & 2147483647u) <= 2139095040u)) && (_e189 > 0u));
                    if _e214 {
                        let _e217 = (bitcast<u32>(bitcast<f32>(_e189)) & 2147483647u);
                        if (_e217 >= 8388608u) {
                            phi_385_ = (bitcast<i32>((_e217 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_385_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e217)), 32u, (_e217 == 0u))));
                        }
                        let _e231 = phi_385_;
                        phi_386_ = _e231;
                    } else {
                        phi_386_ = 0i;
                    }
                    let _e233 = phi_386_;
                    let _e234 = (_e150 == _e189);
                    if _e234 {
                        phi_396_ = true;
                    } else {
                        phi_396_ = (_e157 == _e189);
                    }
                    let _e237 = phi_396_;
                    let _e238 = select(1u, 0u, _e234);
                    if _e237 {
                        let _e239 = (_e238 + 1u);
                        phi_406_ = _e239;
                        phi_407_ = _e239;
                        phi_409_ = select(true, false, (_e239 == 2u));
                    } else {
                        phi_406_ = u32();
                        phi_407_ = 0u;
                        phi_409_ = true;
                    }
                    let _e243 = phi_406_;
                    let _e245 = phi_407_;
                    let _e247 = phi_409_;
                    if _e247 {
                        phi_414_ = (_e245 + 1u);
                    } else {
                        phi_414_ = 0u;
                    }
                    let _e251 = phi_414_;
                    let _e252 = select(_e243, _e245, _e247);
                    let _e253 = select(_e238, select(2u, _e238, _e237), _e247);
                    let _e254 = (_e120 / 2i);
                    let _e259 = bitcast<f32>((bitcast<u32>((_e254 + 127i)) << bitcast<u32>(23i)));
                    let _e265 = bitcast<f32>((bitcast<u32>(((_e120 - _e254) + 127i)) << bitcast<u32>(23i)));
                    let _e266 = -(_e233);
                    let _e267 = (_e266 / 2i);
                    let _e272 = bitcast<f32>((bitcast<u32>((_e267 + 127i)) << bitcast<u32>(23i)));
                    let _e278 = bitcast<f32>((bitcast<u32>(((_e266 - _e267) + 127i)) << bitcast<u32>(23i)));
                    let _e282 = global_4.member[_e138].member;
                    let _e283 = (_e252 == 0u);
                    if _e283 {
                        phi_459_ = _e282[0];
                    } else {
                        phi_459_ = _e282[1];
                    }
                    let _e287 = phi_459_;
                    let _e288 = (_e252 == 2u);
                    if _e288 {
                        phi_465_ = _e282[2];
                    } else {
                        phi_465_ = _e287;
                    }
                    let _e291 = phi_465_;
                    let _e293 = ((_e291 * _e259) * _e265);
                    let _e294 = global_4.member[_e138].member_2;
                    if _e283 {
                        phi_476_ = _e294[0];
                    } else {
                        phi_476_ = _e294[1];
                    }
                    let _e298 = phi_476_;
                    if _e288 {
                        phi_482_ = _e294[2];
                    } else {
                        phi_482_ = _e298;
                    }
                    let _e301 = phi_482_;
                    let _e303 = ((_e301 * _e272) * _e278);
                    let _e307 = (bitcast<f32>((bitcast<u32>(_e303) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e307 {
                        let _e311 = (bitcast<f32>((bitcast<u32>(_e293) & 2147483647u)) * 0.00000011920929f);
                        phi_505_ = select(0.00000000000011368684f, _e311, (_e311 > 0.00000000000011368684f));
                    } else {
                        phi_505_ = 0f;
                    }
                    let _e315 = phi_505_;
                    let _e316 = (_e293 + _e315);
                    let _e317 = (_e293 - _e315);
                    let _e318 = select(_e303, 0f, _e307);
                    if _e307 {
                        phi_516_ = 38685626000000000000000000f;
                    } else {
                        phi_516_ = (1f / _e303);
                    }
                    let _e321 = phi_516_;
                    let _e322 = (_e251 == 0u);
                    if _e322 {
                        phi_525_ = _e282[0];
                    } else {
                        phi_525_ = _e282[1];
                    }
                    let _e326 = phi_525_;
                    let _e327 = (_e251 == 2u);
                    if _e327 {
                        phi_531_ = _e282[2];
                    } else {
                        phi_531_ = _e326;
                    }
                    let _e330 = phi_531_;
                    let _e332 = ((_e330 * _e259) * _e265);
                    if _e322 {
                        phi_542_ = _e294[0];
                    } else {
                        phi_542_ = _e294[1];
                    }
                    let _e336 = phi_542_;
                    if _e327 {
                        phi_548_ = _e294[2];
                    } else {
                        phi_548_ = _e336;
                    }
                    let _e339 = phi_548_;
                    let _e341 = ((_e339 * _e272) * _e278);
                    let _e345 = (bitcast<f32>((bitcast<u32>(_e341) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e345 {
                        let _e349 = (bitcast<f32>((bitcast<u32>(_e332) & 2147483647u)) * 0.00000011920929f);
                        phi_571_ = select(0.00000000000011368684f, _e349, (_e349 > 0.00000000000011368684f));
                    } else {
                        phi_571_ = 0f;
                    }
                    let _e353 = phi_571_;
                    let _e354 = (_e332 + _e353);
                    let _e355 = (_e332 - _e353);
                    let _e356 = select(_e341, 0f, _e345);
                    if _e345 {
                        phi_582_ = 38685626000000000000000000f;
                    } else {
                        phi_582_ = (1f / _e341);
                    }
                    let _e359 = phi_582_;
                    let _e360 = (_e253 == 0u);
                    if _e360 {
                        phi_591_ = _e282[0];
                    } else {
                        phi_591_ = _e282[1];
                    }
                    let _e364 = phi_591_;
                    let _e365 = (_e253 == 2u);
                    if _e365 {
                        phi_597_ = _e282[2];
                    } else {
                        phi_597_ = _e364;
                    }
                    let _e368 = phi_597_;
                    let _e370 = ((_e368 * _e259) * _e265);
                    if _e360 {
                        phi_608_ = _e294[0];
                    } else {
                        phi_608_ = _e294[1];
                    }
                    let _e374 = phi_608_;
                    if _e365 {
                        phi_614_ = _e294[2];
                    } else {
                        phi_614_ = _e374;
                    }
                    let _e377 = phi_614_;
                    let _e379 = ((_e377 * _e272) * _e278);
                    let _e383 = (bitcast<f32>((bitcast<u32>(_e379) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e383 {
                        let _e387 = (bitcast<f32>((bitcast<u32>(_e370) & 2147483647u)) * 0.00000011920929f);
                        phi_637_ = select(0.00000000000011368684f, _e387, (_e387 > 0.00000000000011368684f));
                    } else {
                        phi_637_ = 0f;
                    }
                    let _e391 = phi_637_;
                    let _e392 = (_e370 + _e391);
                    let _e393 = (_e370 - _e391);
                    let _e394 = select(_e379, 0f, _e383);
                    if _e383 {
                        phi_648_ = 38685626000000000000000000f;
                    } else {
                        phi_648_ = (1f / _e379);
                    }
                    let _e397 = phi_648_;
                    let _e400 = bitcast<f32>((bitcast<u32>(_e293) & 2147483647u));
                    let _e403 = bitcast<f32>((bitcast<u32>(_e332) & 2147483647u));
                    let _e405 = select(_e403, _e400, (_e400 > _e403));
                    let _e408 = bitcast<f32>((bitcast<u32>(_e370) & 2147483647u));
                    let _e411 = (_e120 + _e233);
                    if (_e214 && (select(_e408, _e405, (_e405 > _e408)) <= 1099511600000f)) {
                        let _e414 = (_e411 / 3i);
                        let _e421 = bitcast<f32>((bitcast<u32>((_e414 + 127i)) << bitcast<u32>(23i)));
                        let _e428 = bitcast<f32>((bitcast<u32>(((_e411 - (2i * _e414)) + 127i)) << bitcast<u32>(23i)));
                        let _e429 = (((_e199 * _e421) * _e421) * _e428);
                        let _e431 = select(340282350000000000000000000000000000000f, _e429, (_e429 < 340282350000000000000000000000000000000f));
                        let _e436 = (((_e208 * _e421) * _e421) * _e428);
                        let _e438 = select(340282350000000000000000000000000000000f, _e436, (_e436 < 340282350000000000000000000000000000000f));
                        phi_748_ = select(-340282350000000000000000000000000000000f, _e438, (_e438 > -340282350000000000000000000000000000000f));
                        phi_749_ = select(-340282350000000000000000000000000000000f, _e431, (_e431 > -340282350000000000000000000000000000000f));
                    } else {
                        phi_748_ = 0f;
                        phi_749_ = 1f;
                    }
                    let _e442 = phi_748_;
                    let _e444 = phi_749_;
                    local_2 = array<type_21, 8>(type_21(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_21(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_21(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_21(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_21(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_21(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_21(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_21(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u));
                    local_4 = array<type_51, 128>(type_51(type_25(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_25(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_25(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_25(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_25(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_25(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_25(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_25(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_25(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_25(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_25(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_25(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_25(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_25(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_25(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_25(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_25(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_25(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_25(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_25(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_25(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_25(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_25(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_25(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_25(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_25(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_25(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_25(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_25(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_25(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_25(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_25(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_25(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_25(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_25(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_25(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_25(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_25(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_25(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_25(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_25(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_25(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_25(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_25(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_25(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_25(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_25(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_25(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_25(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_25(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_25(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_25(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_25(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_25(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_25(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_25(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_25(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_25(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_25(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_25(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_25(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_25(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_25(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_25(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_25(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_25(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_25(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_25(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_25(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_25(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_25(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_25(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_25(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_25(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_25(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_25(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_25(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_25(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_25(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_25(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_25(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_25(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_25(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_25(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_25(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_25(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_25(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_25(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_25(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_25(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_25(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_25(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_25(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_25(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_25(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_25(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_25(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_25(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_25(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_25(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_25(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_25(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_25(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_25(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_25(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_25(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_25(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_25(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_25(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_25(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_25(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_25(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_25(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_25(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_25(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_25(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_25(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_25(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_25(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_25(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_25(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_25(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_25(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_25(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_25(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_25(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_25(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_25(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u));
                    local_3 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    let _e447 = (_e252 % 3u);
                    let _e448 = (_e447 < 3u);
                    if _e448 {
                    } else {
                        break;
                    }
                    let _e450 = local_1[_e447];
                    let _e453 = (_e251 % 3u);
                    let _e454 = (_e453 < 3u);
                    if _e454 {
                    } else {
                        break;
                    }
                    let _e456 = local_1[_e453];
                    let _e459 = (_e253 % 3u);
                    let _e460 = (_e459 < 3u);
                    if _e460 {
                    } else {
                        break;
                    }
                    let _e462 = local_1[_e459];
                    if _e448 {
                    } else {
                        break;
                    }
                    let _e467 = local[_e447];
                    if _e454 {
                    } else {
                        break;
                    }
                    let _e471 = local[_e453];
                    if _e460 {
                    } else {
                        break;
                    }
                    let _e475 = local[_e459];
                    phi_4572_ = false;
                    phi_4485_ = _e442;
                    phi_1922_ = type_51(type_25(vec4<f32>((f32(_e450) * _e132), (f32(_e456) * _e132), (f32(_e462) * _e132), 0f), vec4<f32>((f32(_e467) * _e132), (f32(_e471) * _e132), (f32(_e475) * _e132), 0f)), select(0u, 2147483648u, (_e82 == 0u)));
                    phi_1925_ = ((3u * _e82) + 1u);
                    phi_1927_ = (_e444 <= _e442);
                    phi_1929_ = 0u;
                    loop {
                        let _e485 = phi_4572_;
                        let _e487 = phi_4485_;
                        let _e489 = phi_1922_;
                        let _e491 = phi_1925_;
                        let _e493 = phi_1927_;
                        let _e495 = phi_1929_;
                        if _e493 {
                            phi_1940_ = true;
                        } else {
                            phi_1940_ = (_e495 > 0u);
                        }
                        let _e498 = phi_1940_;
                        if _e498 {
                            let _e499 = (_e491 > 0u);
                            if _e499 {
                                if _e493 {
                                    phi_1978_ = _e489;
                                    phi_1979_ = _e493;
                                    phi_1980_ = _e495;
                                } else {
                                    let _e500 = (_e495 - 1u);
                                    let _e501 = (_e500 % 128u);
                                    let _e502 = (_e501 < 128u);
                                    if _e502 {
                                    } else {
                                        phi_4675_ = true;
                                        break;
                                    }
                                    let _e504 = local_4[_e501];
                                    if _e502 {
                                    } else {
                                        phi_4675_ = true;
                                        break;
                                    }
                                    let _e512 = local_3[_e501];
                                    phi_1978_ = type_51(type_25(_e504.member.member, _e504.member.member_1), _e504.member_1);
                                    phi_1979_ = (_e512 <= _e487);
                                    phi_1980_ = _e500;
                                }
                                let _e515 = phi_1978_;
                                let _e517 = phi_1979_;
                                let _e519 = phi_1980_;
                                if _e517 {
                                    if ((_e515.member_1 & 2147483648u) != 0u) {
                                        phi_4569_ = _e485;
                                        phi_4559_ = _e487;
                                        phi_1998_ = type_4(0u, ((_e515.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e964 = phi_4569_;
                                            let _e966 = phi_4559_;
                                            let _e968 = phi_1998_;
                                            if (_e968.member < _e968.member_1) {
                                                phi_1999_ = type_4((_e968.member + 1u), _e968.member_1);
                                                phi_2022_ = type_4(1u, _e968.member);
                                            } else {
                                                phi_1999_ = _e968;
                                                phi_2022_ = type_4(0u, type_4().member_1);
                                            }
                                            let _e981 = phi_1999_;
                                            let _e983 = phi_2022_;
                                            let _e987 = (bitcast<i32>(_e983.member) != 0i);
                                            if _e987 {
                                                let _e988 = ((_e515.member_1 & 268435455u) + _e983.member_1);
                                                let _e989 = (_e988 < _e84);
                                                if _e989 {
                                                    if _e989 {
                                                    } else {
                                                        phi_4827_ = _e966;
                                                        phi_4670_ = true;
                                                        break;
                                                    }
                                                    let _e993 = global_2.member[_e988].member_1;
                                                    phi_2043_ = _e993;
                                                } else {
                                                    phi_2043_ = 4294967295u;
                                                }
                                                let _e995 = phi_2043_;
                                                if (_e988 >= _e84) {
                                                    phi_2132_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                } else {
                                                    if _e989 {
                                                    } else {
                                                        phi_4827_ = _e966;
                                                        phi_4670_ = true;
                                                        break;
                                                    }
                                                    if (_e447 < 9u) {
                                                    } else {
                                                        phi_4827_ = _e966;
                                                        phi_4670_ = true;
                                                        break;
                                                    }
                                                    let _e1002 = global_2.member[_e988].member[_e447];
                                                    if (_e453 < 9u) {
                                                    } else {
                                                        phi_4827_ = _e966;
                                                        phi_4670_ = true;
                                                        break;
                                                    }
                                                    let _e1008 = global_2.member[_e988].member[_e453];
                                                    if (_e459 < 9u) {
                                                    } else {
                                                        phi_4827_ = _e966;
                                                        phi_4670_ = true;
                                                        break;
                                                    }
                                                    let _e1014 = global_2.member[_e988].member[_e459];
                                                    let _e1016 = (3u + _e447);
                                                    if (_e1016 < 9u) {
                                                    } else {
                                                        phi_4827_ = _e966;
                                                        phi_4670_ = true;
                                                        break;
                                                    }
                                                    let _e1022 = global_2.member[_e988].member[_e1016];
                                                    let _e1023 = (3u + _e453);
                                                    if (_e1023 < 9u) {
                                                    } else {
                                                        phi_4827_ = _e966;
                                                        phi_4670_ = true;
                                                        break;
                                                    }
                                                    let _e1029 = global_2.member[_e988].member[_e1023];
                                                    let _e1030 = (3u + _e459);
                                                    if (_e1030 < 9u) {
                                                    } else {
                                                        phi_4827_ = _e966;
                                                        phi_4670_ = true;
                                                        break;
                                                    }
                                                    let _e1036 = global_2.member[_e988].member[_e1030];
                                                    let _e1038 = (6u + _e447);
                                                    if (_e1038 < 9u) {
                                                    } else {
                                                        phi_4827_ = _e966;
                                                        phi_4670_ = true;
                                                        break;
                                                    }
                                                    let _e1044 = global_2.member[_e988].member[_e1038];
                                                    let _e1045 = (6u + _e453);
                                                    if (_e1045 < 9u) {
                                                    } else {
                                                        phi_4827_ = _e966;
                                                        phi_4670_ = true;
                                                        break;
                                                    }
                                                    let _e1051 = global_2.member[_e988].member[_e1045];
                                                    let _e1052 = (6u + _e459);
                                                    if (_e1052 < 9u) {
                                                    } else {
                                                        phi_4827_ = _e966;
                                                        phi_4670_ = true;
                                                        break;
                                                    }
                                                    let _e1058 = global_2.member[_e988].member[_e1052];
                                                    phi_2132_ = array<array<f32, 3>, 3>(array<f32, 3>(_e1002, _e1008, _e1014), array<f32, 3>(_e1022, _e1029, _e1036), array<f32, 3>(_e1044, _e1051, _e1058));
                                                }
                                                let _e1062 = phi_2132_;
                                                let _e1069 = (_e1062[0][2] - _e370);
                                                let _e1072 = (((_e1062[0][0] - _e293) * _e394) - (_e1069 * _e318));
                                                let _e1075 = (((_e1062[0][1] - _e332) * _e394) - (_e1069 * _e356));
                                                let _e1082 = (_e1062[1][2] - _e370);
                                                let _e1085 = (((_e1062[1][0] - _e293) * _e394) - (_e1082 * _e318));
                                                let _e1088 = (((_e1062[1][1] - _e332) * _e394) - (_e1082 * _e356));
                                                let _e1095 = (_e1062[2][2] - _e370);
                                                let _e1098 = (((_e1062[2][0] - _e293) * _e394) - (_e1095 * _e318));
                                                let _e1101 = (((_e1062[2][1] - _e332) * _e394) - (_e1095 * _e356));
                                                let _e1102 = (_e1098 * _e1088);
                                                let _e1103 = (_e1101 * _e1085);
                                                let _e1104 = (_e1072 * _e1101);
                                                let _e1105 = (_e1075 * _e1098);
                                                let _e1106 = (_e1085 * _e1075);
                                                let _e1107 = (_e1088 * _e1072);
                                                let _e1112 = (((_e1102 >= _e1103) && (_e1104 >= _e1105)) && (_e1106 >= _e1107));
                                                if (_e1112 || (((_e1102 <= _e1103) && (_e1104 <= _e1105)) && (_e1106 <= _e1107))) {
                                                    let _e1119 = select(-1f, 1f, _e1112);
                                                    let _e1121 = ((_e1102 - _e1103) * _e1119);
                                                    let _e1123 = select(0f, _e1121, (_e1121 > 0f));
                                                    let _e1125 = ((_e1104 - _e1105) * _e1119);
                                                    let _e1127 = select(0f, _e1125, (_e1125 > 0f));
                                                    let _e1129 = ((_e1106 - _e1107) * _e1119);
                                                    let _e1131 = select(0f, _e1129, (_e1129 > 0f));
                                                    let _e1133 = ((_e1123 + _e1127) + _e1131);
                                                    if (_e1133 < 0.000000000000000000000000000000000000011754944f) {
                                                        phi_2699_ = type_21();
                                                        phi_2700_ = true;
                                                    } else {
                                                        let _e1136 = select(_e1062[1][0], _e1062[0][0], (_e1062[0][0] < _e1062[1][0]));
                                                        let _e1140 = select(_e1062[1][0], _e1062[0][0], (_e1062[0][0] > _e1062[1][0]));
                                                        let _e1144 = select(_e1062[1][1], _e1062[0][1], (_e1062[0][1] < _e1062[1][1]));
                                                        let _e1148 = select(_e1062[1][1], _e1062[0][1], (_e1062[0][1] > _e1062[1][1]));
                                                        let _e1152 = select(_e1062[1][2], _e1062[0][2], (_e1062[0][2] < _e1062[1][2]));
                                                        let _e1156 = select(_e1062[1][2], _e1062[0][2], (_e1062[0][2] > _e1062[1][2]));
                                                        let _e1161 = ((select(_e1062[2][0], _e1136, (_e1136 < _e1062[2][0])) - _e316) * _e321);
                                                        let _e1162 = ((select(_e1062[2][0], _e1140, (_e1140 > _e1062[2][0])) - _e317) * _e321);
                                                        let _e1165 = ((select(_e1062[2][1], _e1144, (_e1144 < _e1062[2][1])) - _e354) * _e359);
                                                        let _e1166 = ((select(_e1062[2][1], _e1148, (_e1148 > _e1062[2][1])) - _e355) * _e359);
                                                        let _e1169 = ((select(_e1062[2][2], _e1152, (_e1152 < _e1062[2][2])) - _e392) * _e397);
                                                        let _e1170 = ((select(_e1062[2][2], _e1156, (_e1156 > _e1062[2][2])) - _e393) * _e397);
                                                        let _e1172 = select(_e1170, _e1169, (_e1169 < _e1170));
                                                        let _e1174 = select(_e1170, _e1169, (_e1169 > _e1170));
                                                        let _e1176 = select(_e1162, _e1161, (_e1161 < _e1162));
                                                        let _e1178 = select(_e1166, _e1165, (_e1165 < _e1166));
                                                        let _e1180 = select(_e1178, _e1176, (_e1176 > _e1178));
                                                        let _e1182 = select(_e1172, _e1180, (_e1180 > _e1172));
                                                        let _e1184 = select(_e1162, _e1161, (_e1161 > _e1162));
                                                        let _e1186 = select(_e1166, _e1165, (_e1165 > _e1166));
                                                        let _e1188 = select(_e1186, _e1184, (_e1184 < _e1186));
                                                        let _e1190 = select(_e1174, _e1188, (_e1188 < _e1174));
                                                        let _e1191 = -(_e1172);
                                                        let _e1197 = select(_e444, _e1182, (_e1182 > _e444));
                                                        if (_e1197 > (_e1190 + (select(_e1191, _e1174, (_e1174 > _e1191)) * 0.0000019073523f))) {
                                                            phi_2694_ = type_21();
                                                            phi_2695_ = true;
                                                        } else {
                                                            let _e1199 = (_e1197 > _e966);
                                                            if _e1199 {
                                                                phi_2693_ = type_21();
                                                            } else {
                                                                let _e1203 = (_e1062[1][0] - _e1062[0][0]);
                                                                let _e1204 = (_e1062[1][1] - _e1062[0][1]);
                                                                let _e1205 = (_e1062[1][2] - _e1062[0][2]);
                                                                let _e1206 = vec3<f32>(_e1203, _e1204, _e1205);
                                                                let _e1207 = (_e1062[2][0] - _e1062[1][0]);
                                                                let _e1208 = (_e1062[2][1] - _e1062[1][1]);
                                                                let _e1209 = (_e1062[2][2] - _e1062[1][2]);
                                                                let _e1210 = vec3<f32>(_e1207, _e1208, _e1209);
                                                                let _e1211 = (_e1062[0][0] - _e1062[2][0]);
                                                                let _e1212 = (_e1062[0][1] - _e1062[2][1]);
                                                                let _e1213 = (_e1062[0][2] - _e1062[2][2]);
                                                                let _e1214 = vec3<f32>(_e1211, _e1212, _e1213);
                                                                let _e1217 = bitcast<f32>((bitcast<u32>(_e1203) & 2147483647u));
                                                                let _e1220 = bitcast<f32>((bitcast<u32>(_e1204) & 2147483647u));
                                                                let _e1222 = select(_e1220, _e1217, (_e1217 > _e1220));
                                                                let _e1225 = bitcast<f32>((bitcast<u32>(_e1205) & 2147483647u));
                                                                let _e1227 = select(_e1225, _e1222, (_e1222 > _e1225));
                                                                let _e1230 = bitcast<f32>((bitcast<u32>(_e1207) & 2147483647u));
                                                                let _e1233 = bitcast<f32>((bitcast<u32>(_e1208) & 2147483647u));
                                                                let _e1235 = select(_e1233, _e1230, (_e1230 > _e1233));
                                                                let _e1238 = bitcast<f32>((bitcast<u32>(_e1209) & 2147483647u));
                                                                let _e1240 = select(_e1238, _e1235, (_e1235 > _e1238));
                                                                let _e1243 = bitcast<f32>((bitcast<u32>(_e1211) & 2147483647u));
                                                                let _e1246 = bitcast<f32>((bitcast<u32>(_e1212) & 2147483647u));
                                                                let _e1248 = select(_e1246, _e1243, (_e1243 > _e1246));
                                                                let _e1251 = bitcast<f32>((bitcast<u32>(_e1213) & 2147483647u));
                                                                let _e1253 = select(_e1251, _e1248, (_e1248 > _e1251));
                                                                let _e1255 = select(_e1240, _e1227, (_e1227 > _e1240));
                                                                let _e1257 = select(_e1253, _e1255, (_e1255 > _e1253));
                                                                if (_e1227 == _e1257) {
                                                                    phi_2604_ = _e1210;
                                                                    phi_2605_ = _e1214;
                                                                } else {
                                                                    let _e1260 = vec3((_e1240 == _e1257));
                                                                    phi_2604_ = select(_e1206, _e1214, _e1260);
                                                                    phi_2605_ = select(_e1210, _e1206, _e1260);
                                                                }
                                                                let _e1264 = phi_2604_;
                                                                let _e1266 = phi_2605_;
                                                                let _e1273 = ((_e1264.y * _e1266.z) - (_e1266.y * _e1264.z));
                                                                let _e1278 = ((_e1264.z * _e1266.x) - (_e1266.z * _e1264.x));
                                                                let _e1281 = ((_e1264.x * _e1266.y) - (_e1266.x * _e1264.y));
                                                                if (_e1123 >= _e1127) {
                                                                    phi_2636_ = select(true, false, (_e1123 >= _e1131));
                                                                } else {
                                                                    phi_2636_ = true;
                                                                }
                                                                let _e1286 = phi_2636_;
                                                                if _e1286 {
                                                                    phi_2645_ = select(vec3<f32>(_e1062[2][0], _e1062[2][1], _e1062[2][2]), vec3<f32>(_e1062[1][0], _e1062[1][1], _e1062[1][2]), vec3((_e1127 >= _e1131)));
                                                                } else {
                                                                    phi_2645_ = vec3<f32>(_e1062[0][0], _e1062[0][1], _e1062[0][2]);
                                                                }
                                                                let _e1291 = phi_2645_;
                                                                let _e1308 = ((((_e1273 * (_e1291.x - _e293)) + (_e1278 * (_e1291.y - _e332))) + (_e1281 * (_e1291.z - _e370))) / (((_e1273 * _e318) + (_e1278 * _e356)) + (_e1281 * _e394)));
                                                                let _e1310 = select(_e1190, _e1308, (_e1308 < _e1190));
                                                                let _e1312 = select(_e1182, _e1310, (_e1310 > _e1182));
                                                                if (_e1312 >= _e444) {
                                                                    let _e1314 = (_e1312 <= _e966);
                                                                    if _e1314 {
                                                                        let _e1315 = (1f / _e1133);
                                                                        phi_2685_ = type_21(_e1312, (_e1127 * _e1315), (_e1131 * _e1315), _e995);
                                                                    } else {
                                                                        phi_2685_ = type_21();
                                                                    }
                                                                    let _e1320 = phi_2685_;
                                                                    phi_2687_ = _e1320;
                                                                    phi_2688_ = select(true, false, _e1314);
                                                                } else {
                                                                    phi_2687_ = type_21();
                                                                    phi_2688_ = true;
                                                                }
                                                                let _e1323 = phi_2687_;
                                                                let _e1325 = phi_2688_;
                                                                if _e1325 {
                                                                    phi_2692_ = type_21(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                } else {
                                                                    phi_2692_ = _e1323;
                                                                }
                                                                let _e1327 = phi_2692_;
                                                                phi_2693_ = _e1327;
                                                            }
                                                            let _e1329 = phi_2693_;
                                                            phi_2694_ = _e1329;
                                                            phi_2695_ = _e1199;
                                                        }
                                                        let _e1331 = phi_2694_;
                                                        let _e1333 = phi_2695_;
                                                        phi_2699_ = _e1331;
                                                        phi_2700_ = _e1333;
                                                    }
                                                    let _e1335 = phi_2699_;
                                                    let _e1337 = phi_2700_;
                                                    phi_2704_ = _e1335;
                                                    phi_2705_ = _e1337;
                                                } else {
                                                    phi_2704_ = type_21();
                                                    phi_2705_ = true;
                                                }
                                                let _e1339 = phi_2704_;
                                                let _e1341 = phi_2705_;
                                                if _e1341 {
                                                    phi_2709_ = type_21(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                } else {
                                                    phi_2709_ = _e1339;
                                                }
                                                let _e1343 = phi_2709_;
                                                if (_e1343.member_3 != 4294967295u) {
                                                    if (_e995 != 4294967295u) {
                                                        phi_2721_ = type_4(0u, 8u);
                                                        phi_2724_ = _e1343;
                                                        loop {
                                                            let _e1348 = phi_2721_;
                                                            let _e1350 = phi_2724_;
                                                            if (_e1348.member < _e1348.member_1) {
                                                                phi_2722_ = type_4((_e1348.member + 1u), _e1348.member_1);
                                                                phi_2747_ = type_4(1u, _e1348.member);
                                                            } else {
                                                                phi_2722_ = _e1348;
                                                                phi_2747_ = type_4(0u, type_4().member_1);
                                                            }
                                                            let _e1363 = phi_2722_;
                                                            let _e1365 = phi_2747_;
                                                            let _e1369 = (bitcast<i32>(_e1365.member) != 0i);
                                                            if _e1369 {
                                                                let _e1370 = (_e1365.member_1 < 8u);
                                                                if _e1370 {
                                                                } else {
                                                                    phi_4560_ = true;
                                                                    break;
                                                                }
                                                                let _e1375 = local_2[_e1365.member_1].member;
                                                                if (_e1350.member < _e1375) {
                                                                    phi_2780_ = true;
                                                                } else {
                                                                    let _e1377 = local_2[_e1365.member_1].member;
                                                                    if (_e1350.member == _e1377) {
                                                                        let _e1382 = local_2[_e1365.member_1].member_3;
                                                                        phi_2779_ = (_e1350.member_3 < _e1382);
                                                                    } else {
                                                                        phi_2779_ = false;
                                                                    }
                                                                    let _e1385 = phi_2779_;
                                                                    phi_2780_ = _e1385;
                                                                }
                                                                let _e1387 = phi_2780_;
                                                                if _e1387 {
                                                                    if _e1370 {
                                                                    } else {
                                                                        phi_4560_ = true;
                                                                        break;
                                                                    }
                                                                    let _e1388 = local_2[_e1365.member_1];
                                                                    local_2[_e1365.member_1] = type_21(_e1350.member, _e1350.member_1, _e1350.member_2, _e1350.member_3);
                                                                    phi_2801_ = type_21(_e1388.member, _e1388.member_1, _e1388.member_2, _e1388.member_3);
                                                                } else {
                                                                    phi_2801_ = _e1350;
                                                                }
                                                                let _e1399 = phi_2801_;
                                                                phi_2725_ = _e1399;
                                                            } else {
                                                                phi_2725_ = type_21();
                                                            }
                                                            let _e1401 = phi_2725_;
                                                            continue;
                                                            continuing {
                                                                phi_2721_ = _e1363;
                                                                phi_2724_ = _e1401;
                                                                phi_4560_ = _e964;
                                                                break if !(_e1369);
                                                            }
                                                        }
                                                        let _e1404 = phi_4560_;
                                                        phi_4827_ = _e966;
                                                        phi_4670_ = _e1404;
                                                        if _e1404 {
                                                            break;
                                                        }
                                                        let _e1407 = local_2[7u].member_3;
                                                        if (_e1407 != 4294967295u) {
                                                            let _e1411 = local_2[7u].member;
                                                            phi_4890_ = _e1411;
                                                        } else {
                                                            phi_4890_ = _e966;
                                                        }
                                                        let _e1413 = phi_4890_;
                                                        phi_4889_ = _e1413;
                                                        phi_4673_ = _e1404;
                                                    } else {
                                                        phi_4889_ = _e966;
                                                        phi_4673_ = _e964;
                                                    }
                                                    let _e1415 = phi_4889_;
                                                    let _e1417 = phi_4673_;
                                                    phi_4888_ = _e1415;
                                                    phi_4672_ = _e1417;
                                                } else {
                                                    phi_4888_ = _e966;
                                                    phi_4672_ = _e964;
                                                }
                                                let _e1419 = phi_4888_;
                                                let _e1421 = phi_4672_;
                                                phi_4887_ = _e1419;
                                                phi_4671_ = _e1421;
                                            } else {
                                                phi_4887_ = _e966;
                                                phi_4671_ = _e964;
                                            }
                                            let _e1423 = phi_4887_;
                                            let _e1425 = phi_4671_;
                                            continue;
                                            continuing {
                                                phi_4569_ = _e1425;
                                                phi_4559_ = _e1423;
                                                phi_1998_ = _e981;
                                                phi_4827_ = _e1423;
                                                phi_4670_ = _e1425;
                                                break if !(_e987);
                                            }
                                        }
                                        let _e1428 = phi_4827_;
                                        let _e1430 = phi_4670_;
                                        phi_4675_ = _e1430;
                                        if _e1430 {
                                            break;
                                        }
                                        phi_4792_ = _e1428;
                                        phi_4679_ = _e1430;
                                        phi_4116_ = _e515;
                                        phi_4117_ = false;
                                        phi_4118_ = _e519;
                                    } else {
                                        if (_e515.member_1 >= _e82) {
                                            phi_3715_ = type_54(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), type_51(type_25(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u), type_51(type_25(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u));
                                        } else {
                                            if (_e515.member_1 < _e82) {
                                            } else {
                                                phi_4675_ = true;
                                                break;
                                            }
                                            let _e532 = ((1u + (_e252 * 2u)) % 7u);
                                            if (_e532 < 7u) {
                                            } else {
                                                phi_4675_ = true;
                                                break;
                                            }
                                            let _e537 = global_5.member[_e515.member_1][_e532];
                                            let _e540 = ((1u + (_e251 * 2u)) % 7u);
                                            if (_e540 < 7u) {
                                            } else {
                                                phi_4675_ = true;
                                                break;
                                            }
                                            let _e545 = global_5.member[_e515.member_1][_e540];
                                            let _e548 = ((1u + (_e253 * 2u)) % 7u);
                                            if (_e548 < 7u) {
                                            } else {
                                                phi_4675_ = true;
                                                break;
                                            }
                                            let _e553 = global_5.member[_e515.member_1][_e548];
                                            let _e556 = (((_e252 + 1u) * 2u) % 7u);
                                            if (_e556 < 7u) {
                                            } else {
                                                phi_4675_ = true;
                                                break;
                                            }
                                            let _e561 = global_5.member[_e515.member_1][_e556];
                                            let _e564 = (((_e251 + 1u) * 2u) % 7u);
                                            if (_e564 < 7u) {
                                            } else {
                                                phi_4675_ = true;
                                                break;
                                            }
                                            let _e569 = global_5.member[_e515.member_1][_e564];
                                            let _e572 = (((_e253 + 1u) * 2u) % 7u);
                                            if (_e572 < 7u) {
                                            } else {
                                                phi_4675_ = true;
                                                break;
                                            }
                                            let _e577 = global_5.member[_e515.member_1][_e572];
                                            let _e600 = (bitcast<f32>((bitcast<u32>((_e515.member.member_1.x - _e515.member.member.x)) & 2139095040u)) * 0.0000009536743f);
                                            let _e601 = (bitcast<f32>((bitcast<u32>((_e515.member.member_1.y - _e515.member.member.y)) & 2139095040u)) * 0.0000009536743f);
                                            let _e602 = (bitcast<f32>((bitcast<u32>((_e515.member.member_1.z - _e515.member.member.z)) & 2139095040u)) * 0.0000009536743f);
                                            let _e604 = select(_e132, _e600, (_e600 > _e132));
                                            let _e606 = select(_e132, _e601, (_e601 > _e132));
                                            let _e608 = select(_e132, _e602, (_e602 > _e132));
                                            let _e633 = bitcast<u32>((f32(bitcast<i32>((_e537 & 2097151u))) * _e604));
                                            let _e638 = (bitcast<i32>((_e537 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e641 = bitcast<f32>((_e633 & bitcast<u32>(_e638)));
                                            let _e642 = bitcast<u32>((f32(bitcast<i32>((_e545 & 2097151u))) * _e606));
                                            let _e647 = (bitcast<i32>((_e545 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e650 = bitcast<f32>((_e642 & bitcast<u32>(_e647)));
                                            let _e651 = bitcast<u32>((f32(bitcast<i32>((_e553 & 2097151u))) * _e608));
                                            let _e656 = (bitcast<i32>((_e553 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e659 = bitcast<f32>((_e651 & bitcast<u32>(_e656)));
                                            let _e663 = bitcast<f32>((_e633 & bitcast<u32>(~(_e638))));
                                            let _e667 = bitcast<f32>((_e642 & bitcast<u32>(~(_e647))));
                                            let _e671 = bitcast<f32>((_e651 & bitcast<u32>(~(_e656))));
                                            let _e672 = bitcast<u32>((f32(bitcast<i32>((_e561 & 2097151u))) * _e604));
                                            let _e677 = (bitcast<i32>((_e561 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e680 = bitcast<f32>((_e672 & bitcast<u32>(_e677)));
                                            let _e681 = bitcast<u32>((f32(bitcast<i32>((_e569 & 2097151u))) * _e606));
                                            let _e686 = (bitcast<i32>((_e569 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e689 = bitcast<f32>((_e681 & bitcast<u32>(_e686)));
                                            let _e690 = bitcast<u32>((f32(bitcast<i32>((_e577 & 2097151u))) * _e608));
                                            let _e695 = (bitcast<i32>((_e577 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e698 = bitcast<f32>((_e690 & bitcast<u32>(_e695)));
                                            let _e702 = bitcast<f32>((_e672 & bitcast<u32>(~(_e677))));
                                            let _e706 = bitcast<f32>((_e681 & bitcast<u32>(~(_e686))));
                                            let _e710 = bitcast<f32>((_e690 & bitcast<u32>(~(_e695))));
                                            let _e740 = global_5.member[_e515.member_1][0u];
                                            let _e744 = global_5.member[_e515.member_1][2u];
                                            let _e748 = global_5.member[_e515.member_1][4u];
                                            let _e752 = global_5.member[_e515.member_1][6u];
                                            let _e764 = (((_e744 >> bitcast<u32>(22i)) | ((_e748 >> bitcast<u32>(22i)) << bitcast<u32>(10i))) | ((_e752 >> bitcast<u32>(22i)) << bitcast<u32>(20i)));
                                            let _e765 = (_e740 & 268435455u);
                                            let _e766 = (_e764 & 268435455u);
                                            let _e769 = ((_e740 >> bitcast<u32>(28u)) & 7u);
                                            let _e777 = ((_e740 >> bitcast<u32>(31i)) | (((_e764 >> bitcast<u32>(28u)) & 3u) << bitcast<u32>(1i)));
                                            let _e778 = (_e769 != 0u);
                                            if (_e769 == 0u) {
                                                phi_3677_ = _e765;
                                            } else {
                                                if (_e769 == 7u) {
                                                    phi_3676_ = 2147483648u;
                                                } else {
                                                    phi_3676_ = ((2147483648u | (_e769 << bitcast<u32>(28u))) | (_e766 & 268435455u));
                                                }
                                                let _e787 = phi_3676_;
                                                phi_3677_ = _e787;
                                            }
                                            let _e789 = phi_3677_;
                                            if _e778 {
                                                let _e790 = (_e769 != 7u);
                                                if _e790 {
                                                    phi_3687_ = (_e766 + _e769);
                                                } else {
                                                    phi_3687_ = u32();
                                                }
                                                let _e793 = phi_3687_;
                                                phi_3689_ = _e793;
                                                phi_3690_ = select(true, false, _e790);
                                            } else {
                                                phi_3689_ = u32();
                                                phi_3690_ = true;
                                            }
                                            let _e796 = phi_3689_;
                                            let _e798 = phi_3690_;
                                            if (_e777 == 0u) {
                                                phi_3711_ = (_e765 + select(0u, 1u, !(_e778)));
                                            } else {
                                                if (_e777 == 7u) {
                                                    phi_3710_ = 2147483648u;
                                                } else {
                                                    phi_3710_ = ((2147483648u | (_e777 << bitcast<u32>(28u))) | (select(_e796, _e766, _e798) & 268435455u));
                                                }
                                                let _e811 = phi_3710_;
                                                phi_3711_ = _e811;
                                            }
                                            let _e813 = phi_3711_;
                                            phi_3715_ = type_54(array<vec4<f32>, 3>(vec4<f32>((_e515.member.member.x + _e641), (_e515.member.member.x + _e663), (_e515.member.member_1.x - _e680), (_e515.member.member_1.x - _e702)), vec4<f32>((_e515.member.member.y + _e650), (_e515.member.member.y + _e667), (_e515.member.member_1.y - _e689), (_e515.member.member_1.y - _e706)), vec4<f32>((_e515.member.member.z + _e659), (_e515.member.member.z + _e671), (_e515.member.member_1.z - _e698), (_e515.member.member_1.z - _e710))), type_51(type_25((_e515.member.member + vec4<f32>(_e641, _e650, _e659, 0f)), (_e515.member.member_1 - vec4<f32>(_e680, _e689, _e698, 0f))), _e789), type_51(type_25((_e515.member.member + vec4<f32>(_e663, _e667, _e671, 0f)), (_e515.member.member_1 - vec4<f32>(_e702, _e706, _e710, 0f))), _e813));
                                        }
                                        let _e818 = phi_3715_;
                                        let _e829 = ((_e818.member[0].x - _e316) * _e321);
                                        let _e830 = ((_e818.member[0].y - _e316) * _e321);
                                        let _e831 = ((_e818.member[0].z - _e317) * _e321);
                                        let _e832 = ((_e818.member[0].w - _e317) * _e321);
                                        let _e842 = ((_e818.member[1].x - _e354) * _e359);
                                        let _e843 = ((_e818.member[1].y - _e354) * _e359);
                                        let _e844 = ((_e818.member[1].z - _e355) * _e359);
                                        let _e845 = ((_e818.member[1].w - _e355) * _e359);
                                        let _e855 = ((_e818.member[2].x - _e392) * _e397);
                                        let _e856 = ((_e818.member[2].y - _e392) * _e397);
                                        let _e857 = ((_e818.member[2].z - _e393) * _e397);
                                        let _e858 = ((_e818.member[2].w - _e393) * _e397);
                                        let _e860 = select(_e857, _e855, (_e855 < _e857));
                                        let _e862 = select(_e858, _e856, (_e856 < _e858));
                                        let _e864 = select(_e857, _e855, (_e855 > _e857));
                                        let _e866 = select(_e858, _e856, (_e856 > _e858));
                                        let _e868 = select(_e831, _e829, (_e829 < _e831));
                                        let _e870 = select(_e832, _e830, (_e830 < _e832));
                                        let _e872 = select(_e844, _e842, (_e842 < _e844));
                                        let _e874 = select(_e845, _e843, (_e843 < _e845));
                                        let _e876 = select(_e872, _e868, (_e868 > _e872));
                                        let _e878 = select(_e874, _e870, (_e870 > _e874));
                                        let _e880 = select(_e860, _e876, (_e876 > _e860));
                                        let _e882 = select(_e862, _e878, (_e878 > _e862));
                                        let _e884 = select(_e831, _e829, (_e829 > _e831));
                                        let _e886 = select(_e832, _e830, (_e830 > _e832));
                                        let _e888 = select(_e844, _e842, (_e842 > _e844));
                                        let _e890 = select(_e845, _e843, (_e843 > _e845));
                                        let _e892 = select(_e888, _e884, (_e884 < _e888));
                                        let _e894 = select(_e890, _e886, (_e886 < _e890));
                                        let _e899 = -(_e860);
                                        let _e900 = -(_e862);
                                        let _e907 = (select(_e864, _e892, (_e892 < _e864)) + (select(_e899, _e864, (_e864 > _e899)) * 0.0000019073523f));
                                        let _e908 = (select(_e866, _e894, (_e894 < _e866)) + (select(_e900, _e866, (_e866 > _e900)) * 0.0000019073523f));
                                        let _e910 = select(_e444, _e880, (_e880 > _e444));
                                        let _e912 = select(_e444, _e882, (_e882 > _e444));
                                        let _e917 = (_e910 <= select(_e487, _e907, (_e907 < _e487)));
                                        let _e918 = (_e912 <= select(_e487, _e908, (_e908 < _e487)));
                                        let _e919 = (_e910 <= _e912);
                                        if _e917 {
                                            if _e918 {
                                                if _e919 {
                                                    phi_4060_ = _e818.member_2;
                                                } else {
                                                    phi_4060_ = _e818.member_1;
                                                }
                                                let _e923 = phi_4060_;
                                                let _e924 = (_e519 % 128u);
                                                let _e925 = (_e924 < 128u);
                                                if _e925 {
                                                } else {
                                                    phi_4675_ = true;
                                                    break;
                                                }
                                                local_4[_e924] = type_51(type_25(_e923.member.member, _e923.member.member_1), _e923.member_1);
                                                if _e925 {
                                                } else {
                                                    phi_4675_ = true;
                                                    break;
                                                }
                                                local_3[_e924] = select(_e912, _e910, (_e910 > _e912));
                                                if _e919 {
                                                    phi_4093_ = _e818.member_1;
                                                } else {
                                                    phi_4093_ = _e818.member_2;
                                                }
                                                let _e940 = phi_4093_;
                                                phi_4094_ = _e940;
                                                phi_4095_ = (_e519 + 1u);
                                            } else {
                                                phi_4094_ = type_51();
                                                phi_4095_ = u32();
                                            }
                                            let _e942 = phi_4094_;
                                            let _e944 = phi_4095_;
                                            phi_4097_ = _e942;
                                            phi_4098_ = _e944;
                                            phi_4099_ = select(true, false, _e918);
                                        } else {
                                            phi_4097_ = type_51();
                                            phi_4098_ = u32();
                                            phi_4099_ = true;
                                        }
                                        let _e947 = phi_4097_;
                                        let _e949 = phi_4098_;
                                        let _e951 = phi_4099_;
                                        if _e951 {
                                            if _e917 {
                                                phi_4108_ = _e818.member_1;
                                            } else {
                                                phi_4108_ = _e818.member_2;
                                            }
                                            let _e955 = phi_4108_;
                                            phi_4113_ = _e955;
                                            phi_4114_ = select(_e918, true, _e917);
                                        } else {
                                            phi_4113_ = _e947;
                                            phi_4114_ = _e517;
                                        }
                                        let _e958 = phi_4113_;
                                        let _e960 = phi_4114_;
                                        phi_4792_ = _e487;
                                        phi_4679_ = _e485;
                                        phi_4116_ = _e958;
                                        phi_4117_ = _e960;
                                        phi_4118_ = select(_e949, _e519, _e951);
                                    }
                                    let _e1432 = phi_4792_;
                                    let _e1434 = phi_4679_;
                                    let _e1436 = phi_4116_;
                                    let _e1438 = phi_4117_;
                                    let _e1440 = phi_4118_;
                                    phi_4791_ = _e1432;
                                    phi_4678_ = _e1434;
                                    phi_4119_ = _e1436;
                                    phi_4120_ = (_e491 - 1u);
                                    phi_4121_ = _e1438;
                                    phi_4122_ = _e1440;
                                } else {
                                    phi_4791_ = _e487;
                                    phi_4678_ = _e485;
                                    phi_4119_ = _e515;
                                    phi_4120_ = _e491;
                                    phi_4121_ = _e517;
                                    phi_4122_ = _e519;
                                }
                                let _e1442 = phi_4791_;
                                let _e1444 = phi_4678_;
                                let _e1446 = phi_4119_;
                                let _e1448 = phi_4120_;
                                let _e1450 = phi_4121_;
                                let _e1452 = phi_4122_;
                                phi_4790_ = _e1442;
                                phi_4677_ = _e1444;
                                phi_4123_ = _e1446;
                                phi_4124_ = _e1448;
                                phi_4125_ = _e1450;
                                phi_4126_ = _e1452;
                            } else {
                                phi_4790_ = _e487;
                                phi_4677_ = _e485;
                                phi_4123_ = type_51();
                                phi_4124_ = u32();
                                phi_4125_ = bool();
                                phi_4126_ = u32();
                            }
                            let _e1454 = phi_4790_;
                            let _e1456 = phi_4677_;
                            let _e1458 = phi_4123_;
                            let _e1460 = phi_4124_;
                            let _e1462 = phi_4125_;
                            let _e1464 = phi_4126_;
                            phi_4789_ = _e1454;
                            phi_4676_ = _e1456;
                            phi_1923_ = _e1458;
                            phi_1926_ = _e1460;
                            phi_1928_ = _e1462;
                            phi_1930_ = _e1464;
                            phi_4127_ = _e499;
                        } else {
                            phi_4789_ = _e487;
                            phi_4676_ = _e485;
                            phi_1923_ = type_51();
                            phi_1926_ = u32();
                            phi_1928_ = bool();
                            phi_1930_ = u32();
                            phi_4127_ = false;
                        }
                        let _e1466 = phi_4789_;
                        let _e1468 = phi_4676_;
                        let _e1470 = phi_1923_;
                        let _e1472 = phi_1926_;
                        let _e1474 = phi_1928_;
                        let _e1476 = phi_1930_;
                        let _e1478 = phi_4127_;
                        continue;
                        continuing {
                            phi_4572_ = _e1468;
                            phi_4485_ = _e1466;
                            phi_1922_ = _e1470;
                            phi_1925_ = _e1472;
                            phi_1927_ = _e1474;
                            phi_1929_ = _e1476;
                            phi_4675_ = _e1468;
                            break if !(_e1478);
                        }
                    }
                    let _e1481 = phi_4675_;
                    if _e1481 {
                        break;
                    }
                    phi_4134_ = type_4(0u, 8u);
                    loop {
                        let _e1483 = phi_4134_;
                        if (_e1483.member < _e1483.member_1) {
                            phi_4135_ = type_4((_e1483.member + 1u), _e1483.member_1);
                            phi_4158_ = type_4(1u, _e1483.member);
                        } else {
                            phi_4135_ = _e1483;
                            phi_4158_ = type_4(0u, type_4().member_1);
                        }
                        let _e1496 = phi_4135_;
                        let _e1498 = phi_4158_;
                        let _e1502 = (bitcast<i32>(_e1498.member) != 0i);
                        if _e1502 {
                            let _e1503 = (_e1498.member_1 < 8u);
                            if _e1503 {
                            } else {
                                phi_4782_ = true;
                                break;
                            }
                            let _e1505 = local_2[_e1498.member_1];
                            if (_e1505.member_3 != 4294967295u) {
                                let _e1511 = -(_e411);
                                let _e1512 = (_e1511 / 3i);
                                let _e1519 = bitcast<f32>((bitcast<u32>((_e1512 + 127i)) << bitcast<u32>(23i)));
                                let _e1527 = (((_e1505.member * _e1519) * _e1519) * bitcast<f32>((bitcast<u32>(((_e1511 - (2i * _e1512)) + 127i)) << bitcast<u32>(23i))));
                                let _e1529 = select(340282350000000000000000000000000000000f, _e1527, (_e1527 < 340282350000000000000000000000000000000f));
                                phi_4224_ = type_21(select(-340282350000000000000000000000000000000f, _e1529, (_e1529 > -340282350000000000000000000000000000000f)), _e1505.member_1, _e1505.member_2, _e1505.member_3);
                            } else {
                                phi_4224_ = type_21(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                            }
                            let _e1534 = phi_4224_;
                            if _e1503 {
                            } else {
                                phi_4782_ = true;
                                break;
                            }
                            local_2[_e1498.member_1] = type_21(_e1534.member, _e1534.member_1, _e1534.member_2, _e1534.member_3);
                        }
                        continue;
                        continuing {
                            phi_4134_ = _e1496;
                            phi_4782_ = _e1481;
                            break if !(_e1502);
                        }
                    }
                    let _e1542 = phi_4782_;
                    if _e1542 {
                        break;
                    }
                    let _e1543 = local_2;
                    if _e140 {
                    } else {
                        break;
                    }
                    global_6.member[_e138] = array<type_21, 8>(type_21(_e1543[0].member, _e1543[0].member_1, _e1543[0].member_2, _e1543[0].member_3), type_21(_e1543[1].member, _e1543[1].member_1, _e1543[1].member_2, _e1543[1].member_3), type_21(_e1543[2].member, _e1543[2].member_1, _e1543[2].member_2, _e1543[2].member_3), type_21(_e1543[3].member, _e1543[3].member_1, _e1543[3].member_2, _e1543[3].member_3), type_21(_e1543[4].member, _e1543[4].member_1, _e1543[4].member_2, _e1543[4].member_3), type_21(_e1543[5].member, _e1543[5].member_1, _e1543[5].member_2, _e1543[5].member_3), type_21(_e1543[6].member, _e1543[6].member_1, _e1543[6].member_2, _e1543[6].member_3), type_21(_e1543[7].member, _e1543[7].member_1, _e1543[7].member_2, _e1543[7].member_3));
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn trace_nearest_q21_f32_(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
