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
    var phi_400_: i32;
    var phi_401_: i32;
    var phi_411_: bool;
    var phi_421_: u32;
    var phi_422_: u32;
    var phi_424_: bool;
    var phi_429_: u32;
    var phi_474_: f32;
    var phi_480_: f32;
    var phi_491_: f32;
    var phi_497_: f32;
    var phi_520_: f32;
    var phi_531_: f32;
    var phi_540_: f32;
    var phi_546_: f32;
    var phi_557_: f32;
    var phi_563_: f32;
    var phi_586_: f32;
    var phi_597_: f32;
    var phi_606_: f32;
    var phi_612_: f32;
    var phi_623_: f32;
    var phi_629_: f32;
    var phi_652_: f32;
    var phi_663_: f32;
    var phi_763_: f32;
    var phi_764_: f32;
    var phi_4545_: bool;
    var phi_1884_: type_36;
    var phi_1887_: type_52;
    var phi_1889_: u32;
    var phi_1891_: bool;
    var phi_1893_: u32;
    var phi_1904_: bool;
    var phi_1941_: type_52;
    var phi_1942_: bool;
    var phi_1943_: u32;
    var phi_3567_: u32;
    var phi_3573_: u32;
    var phi_3827_: u32;
    var phi_3828_: u32;
    var phi_3838_: u32;
    var phi_3840_: u32;
    var phi_3841_: bool;
    var phi_3861_: u32;
    var phi_3862_: u32;
    var phi_3866_: type_55;
    var phi_4210_: type_52;
    var phi_4243_: type_52;
    var phi_4244_: type_52;
    var phi_4245_: u32;
    var phi_4247_: type_52;
    var phi_4248_: u32;
    var phi_4249_: bool;
    var phi_4258_: type_52;
    var phi_4263_: type_52;
    var phi_4264_: bool;
    var phi_4542_: bool;
    var phi_1962_: type_36;
    var phi_1965_: type_8;
    var phi_1966_: type_8;
    var phi_1988_: type_8;
    var phi_2029_: u32;
    var phi_2035_: u32;
    var phi_2045_: u32;
    var phi_2061_: u32;
    var phi_2098_: u32;
    var phi_2104_: u32;
    var phi_2114_: u32;
    var phi_4527_: bool;
    var phi_2130_: type_8;
    var phi_2131_: type_8;
    var phi_2154_: type_8;
    var phi_2177_: u32;
    var phi_2192_: u32;
    var phi_2195_: type_8;
    var phi_2196_: type_8;
    var phi_2219_: type_8;
    var phi_2285_: u32;
    var phi_2265_: u32;
    var phi_2266_: u32;
    var phi_2289_: f32;
    var phi_4520_: bool;
    var phi_4595_: bool;
    var phi_4594_: bool;
    var phi_2789_: vec3<f32>;
    var phi_2790_: vec3<f32>;
    var phi_2821_: bool;
    var phi_2830_: vec3<f32>;
    var phi_2870_: type_24;
    var phi_2872_: type_24;
    var phi_2873_: bool;
    var phi_2877_: type_24;
    var phi_2878_: type_24;
    var phi_2879_: type_24;
    var phi_2880_: bool;
    var phi_2884_: type_24;
    var phi_2885_: bool;
    var phi_2889_: type_24;
    var phi_2890_: bool;
    var phi_2894_: type_24;
    var phi_2919_: bool;
    var phi_2920_: bool;
    var phi_2926_: type_36;
    var phi_2927_: type_36;
    var phi_2928_: type_36;
    var phi_4597_: bool;
    var phi_1963_: type_36;
    var phi_4596_: bool;
    var phi_4659_: bool;
    var phi_4266_: type_36;
    var phi_4267_: type_52;
    var phi_4268_: bool;
    var phi_4269_: u32;
    var phi_4658_: bool;
    var phi_4270_: type_36;
    var phi_4271_: type_52;
    var phi_4272_: u32;
    var phi_4273_: bool;
    var phi_4274_: u32;
    var phi_4657_: bool;
    var phi_4275_: type_36;
    var phi_4276_: type_52;
    var phi_4277_: u32;
    var phi_4278_: bool;
    var phi_4279_: u32;
    var phi_4656_: bool;
    var phi_1885_: type_36;
    var phi_1888_: type_52;
    var phi_1890_: u32;
    var phi_1892_: bool;
    var phi_1894_: u32;
    var phi_4280_: bool;
    var phi_4655_: bool;
    var local_7: type_36;
    var phi_4332_: type_24;
    var local_8: type_36;

    switch bitcast<i32>(0u) {
        default: {
            let _e86 = global;
            let _e88 = arrayLength((&global_3.member));
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
            let _e146 = (_e145 < arrayLength((&global_4.member)));
            if _e146 {
                let _e147 = (_e145 < arrayLength((&global_6.member)));
                if _e147 {
                    if _e146 {
                    } else {
                        break;
                    }
                    let _e155 = global_4.member[_e145].member_2[0u];
                    let _e157 = (bitcast<u32>(_e155) & 2147483647u);
                    let _e162 = global_4.member[_e145].member_2[1u];
                    let _e164 = (bitcast<u32>(_e162) & 2147483647u);
                    let _e169 = global_4.member[_e145].member_2[2u];
                    let _e171 = (bitcast<u32>(_e169) & 2147483647u);
                    let _e176 = global_4.member[_e145].member[0u];
                    let _e178 = (bitcast<u32>(_e176) & 2147483647u);
                    let _e183 = global_4.member[_e145].member[1u];
                    let _e185 = (bitcast<u32>(_e183) & 2147483647u);
                    let _e190 = global_4.member[_e145].member[2u];
                    let _e192 = (bitcast<u32>(_e190) & 2147483647u);
                    let _e194 = select(_e164, _e157, (_e164 < _e157));
                    let _e196 = select(_e171, _e194, (_e171 < _e194));
                    let _e198 = select(_e178, _e196, (_e178 < _e196));
                    let _e200 = select(_e185, _e198, (_e185 < _e198));
                    let _e202 = select(_e192, _e200, (_e192 < _e200));
                    let _e206 = global_4.member[_e145].member_1;
                    let _e208 = (bitcast<u32>(_e206) & 2147483647u);
                    let _e215 = global_4.member[_e145].member_3;
                    let _e221 = (((select(_e208, _e202, (_e208 < _e202)) < 2139095040u) && ((bitcast<u32>(_e215) & 2147483647u) <= 2139095040u)) && (_e196 > 0u));
                    if _e221 {
                        let _e224 = (bitcast<u32>(bitcast<f32>(_e196)) & 2147483647u);
                        if (_e224 >= 8388608u) {
                            phi_400_ = (bitcast<i32>((_e224 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_400_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e224)), 32u, (_e224 == 0u))));
                        }
                        let _e238 = phi_400_;
                        phi_401_ = _e238;
                    } else {
                        phi_401_ = 0i;
                    }
                    let _e240 = phi_401_;
                    let _e241 = (_e157 == _e196);
                    if _e241 {
                        phi_411_ = true;
                    } else {
                        phi_411_ = (_e164 == _e196);
                    }
                    let _e244 = phi_411_;
                    let _e245 = select(1u, 0u, _e241);
                    if _e244 {
                        let _e246 = (_e245 + 1u);
                        phi_421_ = _e246;
                        phi_422_ = _e246;
                        phi_424_ = select(true, false, (_e246 == 2u));
                    } else {
                        phi_421_ = u32();
                        phi_422_ = 0u;
                        phi_424_ = true;
                    }
                    let _e250 = phi_421_;
                    let _e252 = phi_422_;
                    let _e254 = phi_424_;
                    if _e254 {
                        phi_429_ = (_e252 + 1u);
                    } else {
                        phi_429_ = 0u;
                    }
                    let _e258 = phi_429_;
                    let _e259 = select(_e250, _e252, _e254);
                    let _e260 = select(_e245, select(2u, _e245, _e244), _e254);
                    let _e261 = (_e127 / 2i);
                    let _e266 = bitcast<f32>((bitcast<u32>((_e261 + 127i)) << bitcast<u32>(23i)));
                    let _e272 = bitcast<f32>((bitcast<u32>(((_e127 - _e261) + 127i)) << bitcast<u32>(23i)));
                    let _e273 = -(_e240);
                    let _e274 = (_e273 / 2i);
                    let _e279 = bitcast<f32>((bitcast<u32>((_e274 + 127i)) << bitcast<u32>(23i)));
                    let _e285 = bitcast<f32>((bitcast<u32>(((_e273 - _e274) + 127i)) << bitcast<u32>(23i)));
                    let _e289 = global_4.member[_e145].member;
                    let _e290 = (_e259 == 0u);
                    if _e290 {
                        phi_474_ = _e289[0];
                    } else {
                        phi_474_ = _e289[1];
                    }
                    let _e294 = phi_474_;
                    let _e295 = (_e259 == 2u);
                    if _e295 {
                        phi_480_ = _e289[2];
                    } else {
                        phi_480_ = _e294;
                    }
                    let _e298 = phi_480_;
                    let _e300 = ((_e298 * _e266) * _e272);
                    let _e301 = global_4.member[_e145].member_2;
                    if _e290 {
                        phi_491_ = _e301[0];
                    } else {
                        phi_491_ = _e301[1];
                    }
                    let _e305 = phi_491_;
                    if _e295 {
                        phi_497_ = _e301[2];
                    } else {
                        phi_497_ = _e305;
                    }
                    let _e308 = phi_497_;
                    let _e310 = ((_e308 * _e279) * _e285);
                    let _e314 = (bitcast<f32>((bitcast<u32>(_e310) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e314 {
                        let _e318 = (bitcast<f32>((bitcast<u32>(_e300) & 2147483647u)) * 0.00000011920929f);
                        phi_520_ = select(0.00000000000011368684f, _e318, (_e318 > 0.00000000000011368684f));
                    } else {
                        phi_520_ = 0f;
                    }
                    let _e322 = phi_520_;
                    let _e323 = (_e300 + _e322);
                    let _e324 = (_e300 - _e322);
                    let _e325 = select(_e310, 0f, _e314);
                    if _e314 {
                        phi_531_ = 38685626000000000000000000f;
                    } else {
                        phi_531_ = (1f / _e310);
                    }
                    let _e328 = phi_531_;
                    let _e329 = (_e258 == 0u);
                    if _e329 {
                        phi_540_ = _e289[0];
                    } else {
                        phi_540_ = _e289[1];
                    }
                    let _e333 = phi_540_;
                    let _e334 = (_e258 == 2u);
                    if _e334 {
                        phi_546_ = _e289[2];
                    } else {
                        phi_546_ = _e333;
                    }
                    let _e337 = phi_546_;
                    let _e339 = ((_e337 * _e266) * _e272);
                    if _e329 {
                        phi_557_ = _e301[0];
                    } else {
                        phi_557_ = _e301[1];
                    }
                    let _e343 = phi_557_;
                    if _e334 {
                        phi_563_ = _e301[2];
                    } else {
                        phi_563_ = _e343;
                    }
                    let _e346 = phi_563_;
                    let _e348 = ((_e346 * _e279) * _e285);
                    let _e352 = (bitcast<f32>((bitcast<u32>(_e348) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e352 {
                        let _e356 = (bitcast<f32>((bitcast<u32>(_e339) & 2147483647u)) * 0.00000011920929f);
                        phi_586_ = select(0.00000000000011368684f, _e356, (_e356 > 0.00000000000011368684f));
                    } else {
                        phi_586_ = 0f;
                    }
                    let _e360 = phi_586_;
                    let _e361 = (_e339 + _e360);
                    let _e362 = (_e339 - _e360);
                    let _e363 = select(_e348, 0f, _e352);
                    if _e352 {
                        phi_597_ = 38685626000000000000000000f;
                    } else {
                        phi_597_ = (1f / _e348);
                    }
                    let _e366 = phi_597_;
                    let _e367 = (_e260 == 0u);
                    if _e367 {
                        phi_606_ = _e289[0];
                    } else {
                        phi_606_ = _e289[1];
                    }
                    let _e371 = phi_606_;
                    let _e372 = (_e260 == 2u);
                    if _e372 {
                        phi_612_ = _e289[2];
                    } else {
                        phi_612_ = _e371;
                    }
                    let _e375 = phi_612_;
                    let _e377 = ((_e375 * _e266) * _e272);
                    if _e367 {
                        phi_623_ = _e301[0];
                    } else {
                        phi_623_ = _e301[1];
                    }
                    let _e381 = phi_623_;
                    if _e372 {
                        phi_629_ = _e301[2];
                    } else {
                        phi_629_ = _e381;
                    }
                    let _e384 = phi_629_;
                    let _e386 = ((_e384 * _e279) * _e285);
                    let _e390 = (bitcast<f32>((bitcast<u32>(_e386) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e390 {
                        let _e394 = (bitcast<f32>((bitcast<u32>(_e377) & 2147483647u)) * 0.00000011920929f);
                        phi_652_ = select(0.00000000000011368684f, _e394, (_e394 > 0.00000000000011368684f));
                    } else {
                        phi_652_ = 0f;
                    }
                    let _e398 = phi_652_;
                    let _e399 = (_e377 + _e398);
                    let _e400 = (_e377 - _e398);
                    let _e401 = select(_e386, 0f, _e390);
                    if _e390 {
                        phi_663_ = 38685626000000000000000000f;
                    } else {
                        phi_663_ = (1f / _e386);
                    }
                    let _e404 = phi_663_;
                    let _e407 = bitcast<f32>((bitcast<u32>(_e300) & 2147483647u));
                    let _e410 = bitcast<f32>((bitcast<u32>(_e339) & 2147483647u));
                    let _e412 = select(_e410, _e407, (_e407 > _e410));
                    let _e415 = bitcast<f32>((bitcast<u32>(_e377) & 2147483647u));
                    let _e418 = (_e127 + _e240);
                    if (_e221 && (select(_e415, _e412, (_e412 > _e415)) <= 1099511600000f)) {
                        let _e421 = (_e418 / 3i);
                        let _e428 = bitcast<f32>((bitcast<u32>((_e421 + 127i)) << bitcast<u32>(23i)));
                        let _e435 = bitcast<f32>((bitcast<u32>(((_e418 - (2i * _e421)) + 127i)) << bitcast<u32>(23i)));
                        let _e436 = (((_e206 * _e428) * _e428) * _e435);
                        let _e438 = select(340282350000000000000000000000000000000f, _e436, (_e436 < 340282350000000000000000000000000000000f));
                        let _e443 = (((_e215 * _e428) * _e428) * _e435);
                        let _e445 = select(340282350000000000000000000000000000000f, _e443, (_e443 < 340282350000000000000000000000000000000f));
                        phi_763_ = select(-340282350000000000000000000000000000000f, _e445, (_e445 > -340282350000000000000000000000000000000f));
                        phi_764_ = select(-340282350000000000000000000000000000000f, _e438, (_e438 > -340282350000000000000000000000000000000f));
                    } else {
                        phi_763_ = 0f;
                        phi_764_ = 1f;
                    }
                    let _e449 = phi_763_;
                    let _e451 = phi_764_;
                    local_3 = array<type_52, 128>(type_52(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u));
                    local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    let _e455 = (_e259 % 3u);
                    let _e456 = (_e455 < 3u);
                    if _e456 {
                    } else {
                        break;
                    }
                    let _e458 = local_1[_e455];
                    let _e461 = (_e258 % 3u);
                    let _e462 = (_e461 < 3u);
                    if _e462 {
                    } else {
                        break;
                    }
                    let _e464 = local_1[_e461];
                    let _e467 = (_e260 % 3u);
                    let _e468 = (_e467 < 3u);
                    if _e468 {
                    } else {
                        break;
                    }
                    let _e470 = local_1[_e467];
                    if _e456 {
                    } else {
                        break;
                    }
                    let _e475 = local[_e455];
                    if _e462 {
                    } else {
                        break;
                    }
                    let _e479 = local[_e461];
                    if _e468 {
                    } else {
                        break;
                    }
                    let _e483 = local[_e467];
                    phi_4545_ = false;
                    phi_1884_ = type_36(type_24(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e449);
                    phi_1887_ = type_52(type_32(vec4<f32>((f32(_e458) * _e139), (f32(_e464) * _e139), (f32(_e470) * _e139), 0f), vec4<f32>((f32(_e475) * _e139), (f32(_e479) * _e139), (f32(_e483) * _e139), 0f)), select(0u, 2147483648u, (_e88 == 0u)));
                    phi_1889_ = ((3u * _e88) + 1u);
                    phi_1891_ = (_e451 <= _e449);
                    phi_1893_ = 0u;
                    loop {
                        let _e493 = phi_4545_;
                        let _e495 = phi_1884_;
                        let _e497 = phi_1887_;
                        let _e499 = phi_1889_;
                        let _e501 = phi_1891_;
                        let _e503 = phi_1893_;
                        local_7 = _e495;
                        if _e501 {
                            phi_1904_ = true;
                        } else {
                            phi_1904_ = (_e503 > 0u);
                        }
                        let _e506 = phi_1904_;
                        if _e506 {
                            let _e507 = (_e499 > 0u);
                            if _e507 {
                                if _e501 {
                                    phi_1941_ = _e497;
                                    phi_1942_ = _e501;
                                    phi_1943_ = _e503;
                                } else {
                                    let _e508 = (_e503 - 1u);
                                    let _e509 = (_e508 % 128u);
                                    let _e510 = (_e509 < 128u);
                                    if _e510 {
                                    } else {
                                        phi_4655_ = true;
                                        break;
                                    }
                                    let _e512 = local_3[_e509];
                                    if _e510 {
                                    } else {
                                        phi_4655_ = true;
                                        break;
                                    }
                                    let _e520 = local_2[_e509];
                                    phi_1941_ = type_52(type_32(_e512.member.member, _e512.member.member_1), _e512.member_1);
                                    phi_1942_ = (_e520 <= _e495.member_1);
                                    phi_1943_ = _e508;
                                }
                                let _e524 = phi_1941_;
                                let _e526 = phi_1942_;
                                let _e528 = phi_1943_;
                                if _e526 {
                                    let _e533 = (_e524.member_1 & 268435455u);
                                    if ((_e524.member_1 & 2147483648u) != 0u) {
                                        phi_4542_ = _e493;
                                        phi_1962_ = _e495;
                                        phi_1965_ = type_8(0u, ((_e524.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e995 = phi_4542_;
                                            let _e997 = phi_1962_;
                                            let _e999 = phi_1965_;
                                            local_8 = _e997;
                                            if (_e999.member < _e999.member_1) {
                                                phi_1966_ = type_8((_e999.member + 1u), _e999.member_1);
                                                phi_1988_ = type_8(1u, _e999.member);
                                            } else {
                                                phi_1966_ = _e999;
                                                phi_1988_ = type_8(0u, type_8().member_1);
                                            }
                                            let _e1012 = phi_1966_;
                                            let _e1014 = phi_1988_;
                                            let _e1018 = (bitcast<i32>(_e1014.member) != 0i);
                                            if _e1018 {
                                                let _e1023 = (_e524.member.member_1.x - _e524.member.member.x);
                                                let _e1026 = (_e524.member.member_1.y - _e524.member.member.y);
                                                let _e1029 = (_e524.member.member_1.z - _e524.member.member.z);
                                                let _e1031 = select(_e1026, _e1023, (_e1023 > _e1026));
                                                let _e1033 = select(_e1029, _e1031, (_e1031 > _e1029));
                                                let _e1035 = (_e1033 < (1024f * _e139));
                                                if _e1035 {
                                                    phi_2029_ = 0u;
                                                } else {
                                                    phi_2029_ = select(2u, 1u, (_e1033 < (2097152f * _e139)));
                                                }
                                                let _e1040 = phi_2029_;
                                                switch bitcast<i32>(_e1040) {
                                                    case 0: {
                                                        phi_2035_ = 1u;
                                                        break;
                                                    }
                                                    case 1: {
                                                        phi_2035_ = 2u;
                                                        break;
                                                    }
                                                    case 2: {
                                                        phi_2035_ = 3u;
                                                        break;
                                                    }
                                                    default: {
                                                        phi_2035_ = u32();
                                                        break;
                                                    }
                                                }
                                                let _e1043 = phi_2035_;
                                                switch bitcast<i32>(_e1040) {
                                                    case 0: {
                                                        phi_2045_ = 1u;
                                                        break;
                                                    }
                                                    case 1: {
                                                        phi_2045_ = 2u;
                                                        break;
                                                    }
                                                    case 2: {
                                                        phi_2045_ = 3u;
                                                        break;
                                                    }
                                                    default: {
                                                        phi_2045_ = u32();
                                                        break;
                                                    }
                                                }
                                                let _e1050 = phi_2045_;
                                                let _e1052 = ((_e533 + (_e1014.member_1 * ((3u * _e1043) + 1u))) + (3u * _e1050));
                                                let _e1053 = (_e1052 < _e91);
                                                if _e1053 {
                                                    if _e1053 {
                                                    } else {
                                                        phi_4596_ = true;
                                                        break;
                                                    }
                                                    let _e1055 = global_5.member[_e1052];
                                                    phi_2061_ = _e1055;
                                                } else {
                                                    phi_2061_ = 4294967295u;
                                                }
                                                let _e1057 = phi_2061_;
                                                local_4 = array<u32, 3>(_e259, _e258, _e260);
                                                if _e1035 {
                                                    phi_2098_ = 0u;
                                                } else {
                                                    phi_2098_ = select(2u, 1u, (_e1033 < (2097152f * _e139)));
                                                }
                                                let _e1063 = phi_2098_;
                                                switch bitcast<i32>(_e1063) {
                                                    case 0: {
                                                        phi_2104_ = 1u;
                                                        break;
                                                    }
                                                    case 1: {
                                                        phi_2104_ = 2u;
                                                        break;
                                                    }
                                                    case 2: {
                                                        phi_2104_ = 3u;
                                                        break;
                                                    }
                                                    default: {
                                                        phi_2104_ = u32();
                                                        break;
                                                    }
                                                }
                                                let _e1066 = phi_2104_;
                                                switch bitcast<i32>(_e1063) {
                                                    case 0: {
                                                        phi_2114_ = 1u;
                                                        break;
                                                    }
                                                    case 1: {
                                                        phi_2114_ = 2u;
                                                        break;
                                                    }
                                                    case 2: {
                                                        phi_2114_ = 3u;
                                                        break;
                                                    }
                                                    default: {
                                                        phi_2114_ = u32();
                                                        break;
                                                    }
                                                }
                                                let _e1073 = phi_2114_;
                                                local_6 = array<f32, 4>(_e524.member.member.x, _e524.member.member.y, _e524.member.member.z, _e524.member.member.w);
                                                local_5[0u] = array<f32, 3>(0f, 0f, 0f);
                                                local_5[1u] = array<f32, 3>(0f, 0f, 0f);
                                                local_5[2u] = array<f32, 3>(0f, 0f, 0f);
                                                phi_4527_ = _e995;
                                                phi_2130_ = type_8(0u, 3u);
                                                loop {
                                                    let _e1087 = phi_4527_;
                                                    let _e1089 = phi_2130_;
                                                    if (_e1089.member < _e1089.member_1) {
                                                        phi_2131_ = type_8((_e1089.member + 1u), _e1089.member_1);
                                                        phi_2154_ = type_8(1u, _e1089.member);
                                                    } else {
                                                        phi_2131_ = _e1089;
                                                        phi_2154_ = type_8(0u, type_8().member_1);
                                                    }
                                                    let _e1102 = phi_2131_;
                                                    let _e1104 = phi_2154_;
                                                    let _e1108 = (bitcast<i32>(_e1104.member) != 0i);
                                                    if _e1108 {
                                                        let _e1110 = ((_e533 + (_e1014.member_1 * ((3u * _e1066) + 1u))) + (_e1104.member_1 * _e1073));
                                                        let _e1111 = (_e1110 < _e91);
                                                        if _e1111 {
                                                            if _e1111 {
                                                            } else {
                                                                phi_4594_ = true;
                                                                break;
                                                            }
                                                            let _e1113 = global_5.member[_e1110];
                                                            phi_2177_ = _e1113;
                                                        } else {
                                                            phi_2177_ = 0u;
                                                        }
                                                        let _e1115 = phi_2177_;
                                                        let _e1116 = (_e1110 + 1u);
                                                        let _e1117 = (_e1116 < _e91);
                                                        if _e1117 {
                                                            if _e1117 {
                                                            } else {
                                                                phi_4594_ = true;
                                                                break;
                                                            }
                                                            let _e1119 = global_5.member[_e1116];
                                                            phi_2192_ = _e1119;
                                                        } else {
                                                            phi_2192_ = 0u;
                                                        }
                                                        let _e1121 = phi_2192_;
                                                        phi_2195_ = type_8(0u, 3u);
                                                        loop {
                                                            let _e1123 = phi_2195_;
                                                            if (_e1123.member < _e1123.member_1) {
                                                                phi_2196_ = type_8((_e1123.member + 1u), _e1123.member_1);
                                                                phi_2219_ = type_8(1u, _e1123.member);
                                                            } else {
                                                                phi_2196_ = _e1123;
                                                                phi_2219_ = type_8(0u, type_8().member_1);
                                                            }
                                                            let _e1136 = phi_2196_;
                                                            let _e1138 = phi_2219_;
                                                            let _e1142 = (bitcast<i32>(_e1138.member) != 0i);
                                                            if _e1142 {
                                                                let _e1143 = (_e1138.member_1 < 3u);
                                                                if _e1143 {
                                                                } else {
                                                                    phi_4520_ = true;
                                                                    break;
                                                                }
                                                                let _e1145 = local_4[_e1138.member_1];
                                                                if (_e1138.member_1 < 4u) {
                                                                } else {
                                                                    phi_4520_ = true;
                                                                    break;
                                                                }
                                                                let _e1148 = local_6[_e1138.member_1];
                                                                switch bitcast<i32>(_e1063) {
                                                                    case 0: {
                                                                        phi_2289_ = (_e1148 + (f32(((_e1115 >> bitcast<u32>(((10u * _e1145) & 31u))) & 1023u)) * _e139));
                                                                        break;
                                                                    }
                                                                    case 1: {
                                                                        if (_e1145 == 0u) {
                                                                            phi_2266_ = _e1115;
                                                                        } else {
                                                                            if (_e1145 == 1u) {
                                                                                phi_2265_ = ((_e1115 >> bitcast<u32>(21i)) | (_e1121 << bitcast<u32>(11i)));
                                                                            } else {
                                                                                phi_2265_ = (_e1121 >> bitcast<u32>(10i));
                                                                            }
                                                                            let _e1169 = phi_2265_;
                                                                            phi_2266_ = _e1169;
                                                                        }
                                                                        let _e1171 = phi_2266_;
                                                                        phi_2289_ = (_e1148 + (f32((_e1171 & 2097151u)) * _e139));
                                                                        break;
                                                                    }
                                                                    case 2: {
                                                                        let _e1150 = (_e1110 + _e1145);
                                                                        let _e1151 = (_e1150 < _e91);
                                                                        if _e1151 {
                                                                            if _e1151 {
                                                                            } else {
                                                                                phi_4520_ = true;
                                                                                break;
                                                                            }
                                                                            let _e1153 = global_5.member[_e1150];
                                                                            phi_2285_ = _e1153;
                                                                        } else {
                                                                            phi_2285_ = 0u;
                                                                        }
                                                                        let _e1155 = phi_2285_;
                                                                        phi_2289_ = (f32(bitcast<i32>(_e1155)) * _e139);
                                                                        break;
                                                                    }
                                                                    default: {
                                                                        phi_2289_ = f32();
                                                                        break;
                                                                    }
                                                                }
                                                                let _e1185 = phi_2289_;
                                                                if (_e1104.member_1 < 3u) {
                                                                } else {
                                                                    phi_4520_ = true;
                                                                    break;
                                                                }
                                                                if _e1143 {
                                                                } else {
                                                                    phi_4520_ = true;
                                                                    break;
                                                                }
                                                                local_5[_e1104.member_1][_e1138.member_1] = _e1185;
                                                            }
                                                            continue;
                                                            continuing {
                                                                phi_2195_ = _e1136;
                                                                phi_4520_ = _e1087;
                                                                break if !(_e1142);
                                                            }
                                                        }
                                                        let _e1191 = phi_4520_;
                                                        phi_4594_ = _e1191;
                                                        if _e1191 {
                                                            break;
                                                        }
                                                        phi_4595_ = _e1191;
                                                    } else {
                                                        phi_4595_ = _e1087;
                                                    }
                                                    let _e1193 = phi_4595_;
                                                    continue;
                                                    continuing {
                                                        phi_4527_ = _e1193;
                                                        phi_2130_ = _e1102;
                                                        phi_4594_ = _e1193;
                                                        break if !(_e1108);
                                                    }
                                                }
                                                let _e1196 = phi_4594_;
                                                phi_4596_ = _e1196;
                                                if _e1196 {
                                                    break;
                                                }
                                                let _e1197 = local_5;
                                                let _e1213 = (_e1197[0][2] - _e377);
                                                let _e1216 = (((_e1197[0][0] - _e300) * _e401) - (_e1213 * _e325));
                                                let _e1219 = (((_e1197[0][1] - _e339) * _e401) - (_e1213 * _e363));
                                                let _e1222 = (_e1197[1][2] - _e377);
                                                let _e1225 = (((_e1197[1][0] - _e300) * _e401) - (_e1222 * _e325));
                                                let _e1228 = (((_e1197[1][1] - _e339) * _e401) - (_e1222 * _e363));
                                                let _e1231 = (_e1197[2][2] - _e377);
                                                let _e1234 = (((_e1197[2][0] - _e300) * _e401) - (_e1231 * _e325));
                                                let _e1237 = (((_e1197[2][1] - _e339) * _e401) - (_e1231 * _e363));
                                                let _e1238 = (_e1234 * _e1228);
                                                let _e1239 = (_e1237 * _e1225);
                                                let _e1240 = (_e1216 * _e1237);
                                                let _e1241 = (_e1219 * _e1234);
                                                let _e1242 = (_e1225 * _e1219);
                                                let _e1243 = (_e1228 * _e1216);
                                                let _e1248 = (((_e1238 >= _e1239) && (_e1240 >= _e1241)) && (_e1242 >= _e1243));
                                                if (_e1248 || (((_e1238 <= _e1239) && (_e1240 <= _e1241)) && (_e1242 <= _e1243))) {
                                                    let _e1255 = select(-1f, 1f, _e1248);
                                                    let _e1257 = ((_e1238 - _e1239) * _e1255);
                                                    let _e1259 = select(0f, _e1257, (_e1257 > 0f));
                                                    let _e1261 = ((_e1240 - _e1241) * _e1255);
                                                    let _e1263 = select(0f, _e1261, (_e1261 > 0f));
                                                    let _e1265 = ((_e1242 - _e1243) * _e1255);
                                                    let _e1267 = select(0f, _e1265, (_e1265 > 0f));
                                                    let _e1269 = ((_e1259 + _e1263) + _e1267);
                                                    if (_e1269 < 0.000000000000000000000000000000000000011754944f) {
                                                        phi_2884_ = type_24();
                                                        phi_2885_ = true;
                                                    } else {
                                                        let _e1272 = select(_e1197[1][0], _e1197[0][0], (_e1197[0][0] < _e1197[1][0]));
                                                        let _e1276 = select(_e1197[1][0], _e1197[0][0], (_e1197[0][0] > _e1197[1][0]));
                                                        let _e1280 = select(_e1197[1][1], _e1197[0][1], (_e1197[0][1] < _e1197[1][1]));
                                                        let _e1284 = select(_e1197[1][1], _e1197[0][1], (_e1197[0][1] > _e1197[1][1]));
                                                        let _e1288 = select(_e1197[1][2], _e1197[0][2], (_e1197[0][2] < _e1197[1][2]));
                                                        let _e1292 = select(_e1197[1][2], _e1197[0][2], (_e1197[0][2] > _e1197[1][2]));
                                                        let _e1297 = ((select(_e1197[2][0], _e1272, (_e1272 < _e1197[2][0])) - _e323) * _e328);
                                                        let _e1298 = ((select(_e1197[2][0], _e1276, (_e1276 > _e1197[2][0])) - _e324) * _e328);
                                                        let _e1301 = ((select(_e1197[2][1], _e1280, (_e1280 < _e1197[2][1])) - _e361) * _e366);
                                                        let _e1302 = ((select(_e1197[2][1], _e1284, (_e1284 > _e1197[2][1])) - _e362) * _e366);
                                                        let _e1305 = ((select(_e1197[2][2], _e1288, (_e1288 < _e1197[2][2])) - _e399) * _e404);
                                                        let _e1306 = ((select(_e1197[2][2], _e1292, (_e1292 > _e1197[2][2])) - _e400) * _e404);
                                                        let _e1308 = select(_e1306, _e1305, (_e1305 < _e1306));
                                                        let _e1310 = select(_e1306, _e1305, (_e1305 > _e1306));
                                                        let _e1312 = select(_e1298, _e1297, (_e1297 < _e1298));
                                                        let _e1314 = select(_e1302, _e1301, (_e1301 < _e1302));
                                                        let _e1316 = select(_e1314, _e1312, (_e1312 > _e1314));
                                                        let _e1318 = select(_e1308, _e1316, (_e1316 > _e1308));
                                                        let _e1320 = select(_e1298, _e1297, (_e1297 > _e1298));
                                                        let _e1322 = select(_e1302, _e1301, (_e1301 > _e1302));
                                                        let _e1324 = select(_e1322, _e1320, (_e1320 < _e1322));
                                                        let _e1326 = select(_e1310, _e1324, (_e1324 < _e1310));
                                                        let _e1327 = -(_e1308);
                                                        let _e1333 = select(_e451, _e1318, (_e1318 > _e451));
                                                        if (_e1333 > (_e1326 + (select(_e1327, _e1310, (_e1310 > _e1327)) * 0.0000019073523f))) {
                                                            phi_2879_ = type_24();
                                                            phi_2880_ = true;
                                                        } else {
                                                            let _e1335 = (_e1333 > _e997.member_1);
                                                            if _e1335 {
                                                                phi_2878_ = type_24();
                                                            } else {
                                                                let _e1339 = (_e1197[1][0] - _e1197[0][0]);
                                                                let _e1340 = (_e1197[1][1] - _e1197[0][1]);
                                                                let _e1341 = (_e1197[1][2] - _e1197[0][2]);
                                                                let _e1342 = vec3<f32>(_e1339, _e1340, _e1341);
                                                                let _e1343 = (_e1197[2][0] - _e1197[1][0]);
                                                                let _e1344 = (_e1197[2][1] - _e1197[1][1]);
                                                                let _e1345 = (_e1197[2][2] - _e1197[1][2]);
                                                                let _e1346 = vec3<f32>(_e1343, _e1344, _e1345);
                                                                let _e1347 = (_e1197[0][0] - _e1197[2][0]);
                                                                let _e1348 = (_e1197[0][1] - _e1197[2][1]);
                                                                let _e1349 = (_e1197[0][2] - _e1197[2][2]);
                                                                let _e1350 = vec3<f32>(_e1347, _e1348, _e1349);
                                                                let _e1353 = bitcast<f32>((bitcast<u32>(_e1339) & 2147483647u));
                                                                let _e1356 = bitcast<f32>((bitcast<u32>(_e1340) & 2147483647u));
                                                                let _e1358 = select(_e1356, _e1353, (_e1353 > _e1356));
                                                                let _e1361 = bitcast<f32>((bitcast<u32>(_e1341) & 2147483647u));
                                                                let _e1363 = select(_e1361, _e1358, (_e1358 > _e1361));
                                                                let _e1366 = bitcast<f32>((bitcast<u32>(_e1343) & 2147483647u));
                                                                let _e1369 = bitcast<f32>((bitcast<u32>(_e1344) & 2147483647u));
                                                                let _e1371 = select(_e1369, _e1366, (_e1366 > _e1369));
                                                                let _e1374 = bitcast<f32>((bitcast<u32>(_e1345) & 2147483647u));
                                                                let _e1376 = select(_e1374, _e1371, (_e1371 > _e1374));
                                                                let _e1379 = bitcast<f32>((bitcast<u32>(_e1347) & 2147483647u));
                                                                let _e1382 = bitcast<f32>((bitcast<u32>(_e1348) & 2147483647u));
                                                                let _e1384 = select(_e1382, _e1379, (_e1379 > _e1382));
                                                                let _e1387 = bitcast<f32>((bitcast<u32>(_e1349) & 2147483647u));
                                                                let _e1389 = select(_e1387, _e1384, (_e1384 > _e1387));
                                                                let _e1391 = select(_e1376, _e1363, (_e1363 > _e1376));
                                                                let _e1393 = select(_e1389, _e1391, (_e1391 > _e1389));
                                                                if (_e1363 == _e1393) {
                                                                    phi_2789_ = _e1346;
                                                                    phi_2790_ = _e1350;
                                                                } else {
                                                                    let _e1396 = vec3((_e1376 == _e1393));
                                                                    phi_2789_ = select(_e1342, _e1350, _e1396);
                                                                    phi_2790_ = select(_e1346, _e1342, _e1396);
                                                                }
                                                                let _e1400 = phi_2789_;
                                                                let _e1402 = phi_2790_;
                                                                let _e1409 = ((_e1400.y * _e1402.z) - (_e1402.y * _e1400.z));
                                                                let _e1414 = ((_e1400.z * _e1402.x) - (_e1402.z * _e1400.x));
                                                                let _e1417 = ((_e1400.x * _e1402.y) - (_e1402.x * _e1400.y));
                                                                if (_e1259 >= _e1263) {
                                                                    phi_2821_ = select(true, false, (_e1259 >= _e1267));
                                                                } else {
                                                                    phi_2821_ = true;
                                                                }
                                                                let _e1422 = phi_2821_;
                                                                if _e1422 {
                                                                    phi_2830_ = select(vec3<f32>(_e1197[2][0], _e1197[2][1], _e1197[2][2]), vec3<f32>(_e1197[1][0], _e1197[1][1], _e1197[1][2]), vec3((_e1263 >= _e1267)));
                                                                } else {
                                                                    phi_2830_ = vec3<f32>(_e1197[0][0], _e1197[0][1], _e1197[0][2]);
                                                                }
                                                                let _e1427 = phi_2830_;
                                                                let _e1444 = ((((_e1409 * (_e1427.x - _e300)) + (_e1414 * (_e1427.y - _e339))) + (_e1417 * (_e1427.z - _e377))) / (((_e1409 * _e325) + (_e1414 * _e363)) + (_e1417 * _e401)));
                                                                let _e1446 = select(_e1326, _e1444, (_e1444 < _e1326));
                                                                let _e1448 = select(_e1318, _e1446, (_e1446 > _e1318));
                                                                if (_e1448 >= _e451) {
                                                                    let _e1450 = (_e1448 <= _e997.member_1);
                                                                    if _e1450 {
                                                                        let _e1451 = (1f / _e1269);
                                                                        phi_2870_ = type_24(_e1448, (_e1263 * _e1451), (_e1267 * _e1451), _e1057);
                                                                    } else {
                                                                        phi_2870_ = type_24();
                                                                    }
                                                                    let _e1456 = phi_2870_;
                                                                    phi_2872_ = _e1456;
                                                                    phi_2873_ = select(true, false, _e1450);
                                                                } else {
                                                                    phi_2872_ = type_24();
                                                                    phi_2873_ = true;
                                                                }
                                                                let _e1459 = phi_2872_;
                                                                let _e1461 = phi_2873_;
                                                                if _e1461 {
                                                                    phi_2877_ = type_24(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                } else {
                                                                    phi_2877_ = _e1459;
                                                                }
                                                                let _e1463 = phi_2877_;
                                                                phi_2878_ = _e1463;
                                                            }
                                                            let _e1465 = phi_2878_;
                                                            phi_2879_ = _e1465;
                                                            phi_2880_ = _e1335;
                                                        }
                                                        let _e1467 = phi_2879_;
                                                        let _e1469 = phi_2880_;
                                                        phi_2884_ = _e1467;
                                                        phi_2885_ = _e1469;
                                                    }
                                                    let _e1471 = phi_2884_;
                                                    let _e1473 = phi_2885_;
                                                    phi_2889_ = _e1471;
                                                    phi_2890_ = _e1473;
                                                } else {
                                                    phi_2889_ = type_24();
                                                    phi_2890_ = true;
                                                }
                                                let _e1475 = phi_2889_;
                                                let _e1477 = phi_2890_;
                                                if _e1477 {
                                                    phi_2894_ = type_24(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                } else {
                                                    phi_2894_ = _e1475;
                                                }
                                                let _e1479 = phi_2894_;
                                                if (_e1479.member_3 != 4294967295u) {
                                                    if (_e1057 != 4294967295u) {
                                                        if (_e1479.member < _e997.member.member) {
                                                            phi_2920_ = true;
                                                        } else {
                                                            if (_e1479.member == _e997.member.member) {
                                                                phi_2919_ = (_e1479.member_3 < _e997.member.member_3);
                                                            } else {
                                                                phi_2919_ = false;
                                                            }
                                                            let _e1492 = phi_2919_;
                                                            phi_2920_ = _e1492;
                                                        }
                                                        let _e1494 = phi_2920_;
                                                        if _e1494 {
                                                            phi_2926_ = type_36(_e1479, _e1479.member);
                                                        } else {
                                                            phi_2926_ = _e997;
                                                        }
                                                        let _e1497 = phi_2926_;
                                                        phi_2927_ = _e1497;
                                                    } else {
                                                        phi_2927_ = _e997;
                                                    }
                                                    let _e1499 = phi_2927_;
                                                    phi_2928_ = _e1499;
                                                } else {
                                                    phi_2928_ = _e997;
                                                }
                                                let _e1501 = phi_2928_;
                                                phi_4597_ = _e1196;
                                                phi_1963_ = _e1501;
                                            } else {
                                                phi_4597_ = _e995;
                                                phi_1963_ = type_36();
                                            }
                                            let _e1503 = phi_4597_;
                                            let _e1505 = phi_1963_;
                                            continue;
                                            continuing {
                                                phi_4542_ = _e1503;
                                                phi_1962_ = _e1505;
                                                phi_1965_ = _e1012;
                                                phi_4596_ = _e1503;
                                                break if !(_e1018);
                                            }
                                        }
                                        let _e1508 = phi_4596_;
                                        phi_4655_ = _e1508;
                                        if _e1508 {
                                            break;
                                        }
                                        phi_4659_ = _e1508;
                                        let _e1706 = local_8;
                                        phi_4266_ = _e1706;
                                        phi_4267_ = _e524;
                                        phi_4268_ = false;
                                        phi_4269_ = _e528;
                                    } else {
                                        if (_e524.member_1 >= _e88) {
                                            phi_3866_ = type_55(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), type_52(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u), type_52(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u));
                                        } else {
                                            if (_e524.member_1 < _e88) {
                                            } else {
                                                phi_4655_ = true;
                                                break;
                                            }
                                            let _e541 = ((1u + _e259) % 4u);
                                            if (_e541 < 4u) {
                                            } else {
                                                phi_4655_ = true;
                                                break;
                                            }
                                            let _e546 = global_3.member[_e524.member_1][_e541];
                                            let _e548 = ((1u + _e258) % 4u);
                                            if (_e548 < 4u) {
                                            } else {
                                                phi_4655_ = true;
                                                break;
                                            }
                                            let _e553 = global_3.member[_e524.member_1][_e548];
                                            let _e555 = ((1u + _e260) % 4u);
                                            if (_e555 < 4u) {
                                            } else {
                                                phi_4655_ = true;
                                                break;
                                            }
                                            let _e560 = global_3.member[_e524.member_1][_e555];
                                            let _e562 = ((_e259 + 1u) % 4u);
                                            if (_e562 < 4u) {
                                            } else {
                                                phi_4655_ = true;
                                                break;
                                            }
                                            let _e567 = global_3.member[_e524.member_1][_e562];
                                            let _e569 = (_e567 >> bitcast<u32>(11u));
                                            let _e571 = ((_e258 + 1u) % 4u);
                                            if (_e571 < 4u) {
                                            } else {
                                                phi_4655_ = true;
                                                break;
                                            }
                                            let _e576 = global_3.member[_e524.member_1][_e571];
                                            let _e578 = (_e576 >> bitcast<u32>(11u));
                                            let _e580 = ((_e260 + 1u) % 4u);
                                            if (_e580 < 4u) {
                                            } else {
                                                phi_4655_ = true;
                                                break;
                                            }
                                            let _e585 = global_3.member[_e524.member_1][_e580];
                                            let _e587 = (_e585 >> bitcast<u32>(11u));
                                            let _e610 = (bitcast<f32>((bitcast<u32>((_e524.member.member_1.x - _e524.member.member.x)) & 2139095040u)) * 0.001953125f);
                                            let _e611 = (bitcast<f32>((bitcast<u32>((_e524.member.member_1.y - _e524.member.member.y)) & 2139095040u)) * 0.001953125f);
                                            let _e612 = (bitcast<f32>((bitcast<u32>((_e524.member.member_1.z - _e524.member.member.z)) & 2139095040u)) * 0.001953125f);
                                            let _e614 = select(_e139, _e610, (_e610 > _e139));
                                            let _e616 = select(_e139, _e611, (_e611 > _e139));
                                            let _e618 = select(_e139, _e612, (_e612 > _e139));
                                            let _e643 = bitcast<u32>((f32(bitcast<i32>((_e546 & 1023u))) * _e614));
                                            let _e648 = (bitcast<i32>((_e546 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e651 = bitcast<f32>((_e643 & bitcast<u32>(_e648)));
                                            let _e652 = bitcast<u32>((f32(bitcast<i32>((_e553 & 1023u))) * _e616));
                                            let _e657 = (bitcast<i32>((_e553 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e660 = bitcast<f32>((_e652 & bitcast<u32>(_e657)));
                                            let _e661 = bitcast<u32>((f32(bitcast<i32>((_e560 & 1023u))) * _e618));
                                            let _e666 = (bitcast<i32>((_e560 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e669 = bitcast<f32>((_e661 & bitcast<u32>(_e666)));
                                            let _e673 = bitcast<f32>((_e643 & bitcast<u32>(~(_e648))));
                                            let _e677 = bitcast<f32>((_e652 & bitcast<u32>(~(_e657))));
                                            let _e681 = bitcast<f32>((_e661 & bitcast<u32>(~(_e666))));
                                            let _e682 = bitcast<u32>((f32(bitcast<i32>((_e569 & 1023u))) * _e614));
                                            let _e687 = (bitcast<i32>((_e569 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e690 = bitcast<f32>((_e682 & bitcast<u32>(_e687)));
                                            let _e691 = bitcast<u32>((f32(bitcast<i32>((_e578 & 1023u))) * _e616));
                                            let _e696 = (bitcast<i32>((_e578 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e699 = bitcast<f32>((_e691 & bitcast<u32>(_e696)));
                                            let _e700 = bitcast<u32>((f32(bitcast<i32>((_e587 & 1023u))) * _e618));
                                            let _e705 = (bitcast<i32>((_e587 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e708 = bitcast<f32>((_e700 & bitcast<u32>(_e705)));
                                            let _e712 = bitcast<f32>((_e682 & bitcast<u32>(~(_e687))));
                                            let _e716 = bitcast<f32>((_e691 & bitcast<u32>(~(_e696))));
                                            let _e720 = bitcast<f32>((_e700 & bitcast<u32>(~(_e705))));
                                            let _e721 = (_e524.member.member.x + _e651);
                                            let _e722 = (_e524.member.member.y + _e660);
                                            let _e723 = (_e524.member.member.z + _e669);
                                            let _e726 = (_e524.member.member_1.x - _e690);
                                            let _e727 = (_e524.member.member_1.y - _e699);
                                            let _e728 = (_e524.member.member_1.z - _e708);
                                            let _e747 = (_e726 - _e721);
                                            let _e748 = (_e727 - _e722);
                                            let _e749 = (_e728 - _e723);
                                            let _e751 = select(_e748, _e747, (_e747 > _e748));
                                            let _e753 = select(_e749, _e751, (_e751 > _e749));
                                            if (_e753 < (1024f * _e139)) {
                                                phi_3567_ = 0u;
                                            } else {
                                                phi_3567_ = select(2u, 1u, (_e753 < (2097152f * _e139)));
                                            }
                                            let _e760 = phi_3567_;
                                            switch bitcast<i32>(_e760) {
                                                case 0: {
                                                    phi_3573_ = 1u;
                                                    break;
                                                }
                                                case 1: {
                                                    phi_3573_ = 2u;
                                                    break;
                                                }
                                                case 2: {
                                                    phi_3573_ = 3u;
                                                    break;
                                                }
                                                default: {
                                                    phi_3573_ = u32();
                                                    break;
                                                }
                                            }
                                            let _e763 = phi_3573_;
                                            let _e769 = global_3.member[_e524.member_1][0u];
                                            let _e773 = global_3.member[_e524.member_1][1u];
                                            let _e777 = global_3.member[_e524.member_1][2u];
                                            let _e781 = global_3.member[_e524.member_1][3u];
                                            let _e793 = (((_e773 >> bitcast<u32>(22i)) | ((_e777 >> bitcast<u32>(22i)) << bitcast<u32>(10i))) | ((_e781 >> bitcast<u32>(22i)) << bitcast<u32>(20i)));
                                            let _e794 = (_e769 & 268435455u);
                                            let _e795 = (_e793 & 268435455u);
                                            let _e798 = ((_e769 >> bitcast<u32>(28u)) & 7u);
                                            let _e806 = ((_e769 >> bitcast<u32>(31i)) | (((_e793 >> bitcast<u32>(28u)) & 3u) << bitcast<u32>(1i)));
                                            let _e807 = (_e798 != 0u);
                                            if (_e798 == 0u) {
                                                phi_3828_ = _e794;
                                            } else {
                                                if (_e798 == 7u) {
                                                    phi_3827_ = 2147483648u;
                                                } else {
                                                    phi_3827_ = ((2147483648u | (_e798 << bitcast<u32>(28u))) | (_e795 & 268435455u));
                                                }
                                                let _e816 = phi_3827_;
                                                phi_3828_ = _e816;
                                            }
                                            let _e818 = phi_3828_;
                                            if _e807 {
                                                let _e819 = (_e798 != 7u);
                                                if _e819 {
                                                    phi_3838_ = (_e795 + (_e798 * ((3u * _e763) + 1u)));
                                                } else {
                                                    phi_3838_ = u32();
                                                }
                                                let _e823 = phi_3838_;
                                                phi_3840_ = _e823;
                                                phi_3841_ = select(true, false, _e819);
                                            } else {
                                                phi_3840_ = u32();
                                                phi_3841_ = true;
                                            }
                                            let _e826 = phi_3840_;
                                            let _e828 = phi_3841_;
                                            if (_e806 == 0u) {
                                                phi_3862_ = (_e794 + select(0u, 1u, !(_e807)));
                                            } else {
                                                if (_e806 == 7u) {
                                                    phi_3861_ = 2147483648u;
                                                } else {
                                                    phi_3861_ = ((2147483648u | (_e806 << bitcast<u32>(28u))) | (select(_e826, _e795, _e828) & 268435455u));
                                                }
                                                let _e841 = phi_3861_;
                                                phi_3862_ = _e841;
                                            }
                                            let _e843 = phi_3862_;
                                            phi_3866_ = type_55(array<vec4<f32>, 3>(vec4<f32>(_e721, (_e524.member.member.x + _e673), _e726, (_e524.member.member_1.x - _e712)), vec4<f32>(_e722, (_e524.member.member.y + _e677), _e727, (_e524.member.member_1.y - _e716)), vec4<f32>(_e723, (_e524.member.member.z + _e681), _e728, (_e524.member.member_1.z - _e720))), type_52(type_32((_e524.member.member + vec4<f32>(_e651, _e660, _e669, 0f)), (_e524.member.member_1 - vec4<f32>(_e690, _e699, _e708, 0f))), _e818), type_52(type_32((_e524.member.member + vec4<f32>(_e673, _e677, _e681, 0f)), (_e524.member.member_1 - vec4<f32>(_e712, _e716, _e720, 0f))), _e843));
                                        }
                                        let _e848 = phi_3866_;
                                        let _e860 = ((_e848.member[0].x - _e323) * _e328);
                                        let _e861 = ((_e848.member[0].y - _e323) * _e328);
                                        let _e862 = ((_e848.member[0].z - _e324) * _e328);
                                        let _e863 = ((_e848.member[0].w - _e324) * _e328);
                                        let _e873 = ((_e848.member[1].x - _e361) * _e366);
                                        let _e874 = ((_e848.member[1].y - _e361) * _e366);
                                        let _e875 = ((_e848.member[1].z - _e362) * _e366);
                                        let _e876 = ((_e848.member[1].w - _e362) * _e366);
                                        let _e886 = ((_e848.member[2].x - _e399) * _e404);
                                        let _e887 = ((_e848.member[2].y - _e399) * _e404);
                                        let _e888 = ((_e848.member[2].z - _e400) * _e404);
                                        let _e889 = ((_e848.member[2].w - _e400) * _e404);
                                        let _e891 = select(_e888, _e886, (_e886 < _e888));
                                        let _e893 = select(_e889, _e887, (_e887 < _e889));
                                        let _e895 = select(_e888, _e886, (_e886 > _e888));
                                        let _e897 = select(_e889, _e887, (_e887 > _e889));
                                        let _e899 = select(_e862, _e860, (_e860 < _e862));
                                        let _e901 = select(_e863, _e861, (_e861 < _e863));
                                        let _e903 = select(_e875, _e873, (_e873 < _e875));
                                        let _e905 = select(_e876, _e874, (_e874 < _e876));
                                        let _e907 = select(_e903, _e899, (_e899 > _e903));
                                        let _e909 = select(_e905, _e901, (_e901 > _e905));
                                        let _e911 = select(_e891, _e907, (_e907 > _e891));
                                        let _e913 = select(_e893, _e909, (_e909 > _e893));
                                        let _e915 = select(_e862, _e860, (_e860 > _e862));
                                        let _e917 = select(_e863, _e861, (_e861 > _e863));
                                        let _e919 = select(_e875, _e873, (_e873 > _e875));
                                        let _e921 = select(_e876, _e874, (_e874 > _e876));
                                        let _e923 = select(_e919, _e915, (_e915 < _e919));
                                        let _e925 = select(_e921, _e917, (_e917 < _e921));
                                        let _e930 = -(_e891);
                                        let _e931 = -(_e893);
                                        let _e938 = (select(_e895, _e923, (_e923 < _e895)) + (select(_e930, _e895, (_e895 > _e930)) * 0.0000019073523f));
                                        let _e939 = (select(_e897, _e925, (_e925 < _e897)) + (select(_e931, _e897, (_e897 > _e931)) * 0.0000019073523f));
                                        let _e941 = select(_e451, _e911, (_e911 > _e451));
                                        let _e943 = select(_e451, _e913, (_e913 > _e451));
                                        let _e948 = (_e941 <= select(_e495.member_1, _e938, (_e938 < _e495.member_1)));
                                        let _e949 = (_e943 <= select(_e495.member_1, _e939, (_e939 < _e495.member_1)));
                                        let _e950 = (_e941 <= _e943);
                                        if _e948 {
                                            if _e949 {
                                                if _e950 {
                                                    phi_4210_ = _e848.member_2;
                                                } else {
                                                    phi_4210_ = _e848.member_1;
                                                }
                                                let _e954 = phi_4210_;
                                                let _e955 = (_e528 % 128u);
                                                let _e956 = (_e955 < 128u);
                                                if _e956 {
                                                } else {
                                                    phi_4655_ = true;
                                                    break;
                                                }
                                                local_3[_e955] = type_52(type_32(_e954.member.member, _e954.member.member_1), _e954.member_1);
                                                if _e956 {
                                                } else {
                                                    phi_4655_ = true;
                                                    break;
                                                }
                                                local_2[_e955] = select(_e943, _e941, (_e941 > _e943));
                                                if _e950 {
                                                    phi_4243_ = _e848.member_1;
                                                } else {
                                                    phi_4243_ = _e848.member_2;
                                                }
                                                let _e971 = phi_4243_;
                                                phi_4244_ = _e971;
                                                phi_4245_ = (_e528 + 1u);
                                            } else {
                                                phi_4244_ = type_52();
                                                phi_4245_ = u32();
                                            }
                                            let _e973 = phi_4244_;
                                            let _e975 = phi_4245_;
                                            phi_4247_ = _e973;
                                            phi_4248_ = _e975;
                                            phi_4249_ = select(true, false, _e949);
                                        } else {
                                            phi_4247_ = type_52();
                                            phi_4248_ = u32();
                                            phi_4249_ = true;
                                        }
                                        let _e978 = phi_4247_;
                                        let _e980 = phi_4248_;
                                        let _e982 = phi_4249_;
                                        if _e982 {
                                            if _e948 {
                                                phi_4258_ = _e848.member_1;
                                            } else {
                                                phi_4258_ = _e848.member_2;
                                            }
                                            let _e986 = phi_4258_;
                                            phi_4263_ = _e986;
                                            phi_4264_ = select(_e949, true, _e948);
                                        } else {
                                            phi_4263_ = _e978;
                                            phi_4264_ = _e526;
                                        }
                                        let _e989 = phi_4263_;
                                        let _e991 = phi_4264_;
                                        phi_4659_ = _e493;
                                        phi_4266_ = _e495;
                                        phi_4267_ = _e989;
                                        phi_4268_ = _e991;
                                        phi_4269_ = select(_e980, _e528, _e982);
                                    }
                                    let _e1510 = phi_4659_;
                                    let _e1512 = phi_4266_;
                                    let _e1514 = phi_4267_;
                                    let _e1516 = phi_4268_;
                                    let _e1518 = phi_4269_;
                                    phi_4658_ = _e1510;
                                    phi_4270_ = _e1512;
                                    phi_4271_ = _e1514;
                                    phi_4272_ = (_e499 - 1u);
                                    phi_4273_ = _e1516;
                                    phi_4274_ = _e1518;
                                } else {
                                    phi_4658_ = _e493;
                                    phi_4270_ = _e495;
                                    phi_4271_ = _e524;
                                    phi_4272_ = _e499;
                                    phi_4273_ = _e526;
                                    phi_4274_ = _e528;
                                }
                                let _e1520 = phi_4658_;
                                let _e1522 = phi_4270_;
                                let _e1524 = phi_4271_;
                                let _e1526 = phi_4272_;
                                let _e1528 = phi_4273_;
                                let _e1530 = phi_4274_;
                                phi_4657_ = _e1520;
                                phi_4275_ = _e1522;
                                phi_4276_ = _e1524;
                                phi_4277_ = _e1526;
                                phi_4278_ = _e1528;
                                phi_4279_ = _e1530;
                            } else {
                                phi_4657_ = _e493;
                                phi_4275_ = type_36();
                                phi_4276_ = type_52();
                                phi_4277_ = u32();
                                phi_4278_ = bool();
                                phi_4279_ = u32();
                            }
                            let _e1532 = phi_4657_;
                            let _e1534 = phi_4275_;
                            let _e1536 = phi_4276_;
                            let _e1538 = phi_4277_;
                            let _e1540 = phi_4278_;
                            let _e1542 = phi_4279_;
                            phi_4656_ = _e1532;
                            phi_1885_ = _e1534;
                            phi_1888_ = _e1536;
                            phi_1890_ = _e1538;
                            phi_1892_ = _e1540;
                            phi_1894_ = _e1542;
                            phi_4280_ = _e507;
                        } else {
                            phi_4656_ = _e493;
                            phi_1885_ = type_36();
                            phi_1888_ = type_52();
                            phi_1890_ = u32();
                            phi_1892_ = bool();
                            phi_1894_ = u32();
                            phi_4280_ = false;
                        }
                        let _e1544 = phi_4656_;
                        let _e1546 = phi_1885_;
                        let _e1548 = phi_1888_;
                        let _e1550 = phi_1890_;
                        let _e1552 = phi_1892_;
                        let _e1554 = phi_1894_;
                        let _e1556 = phi_4280_;
                        continue;
                        continuing {
                            phi_4545_ = _e1544;
                            phi_1884_ = _e1546;
                            phi_1887_ = _e1548;
                            phi_1889_ = _e1550;
                            phi_1891_ = _e1552;
                            phi_1893_ = _e1554;
                            phi_4655_ = _e1544;
                            break if !(_e1556);
                        }
                    }
                    let _e1559 = phi_4655_;
                    if _e1559 {
                        break;
                    }
                    let _e1561 = local_7;
                    if (_e1561.member.member_3 != 4294967295u) {
                        let _e1566 = -(_e418);
                        let _e1567 = (_e1566 / 3i);
                        let _e1574 = bitcast<f32>((bitcast<u32>((_e1567 + 127i)) << bitcast<u32>(23i)));
                        let _e1582 = (((_e1561.member.member * _e1574) * _e1574) * bitcast<f32>((bitcast<u32>(((_e1566 - (2i * _e1567)) + 127i)) << bitcast<u32>(23i))));
                        let _e1584 = select(340282350000000000000000000000000000000f, _e1582, (_e1582 < 340282350000000000000000000000000000000f));
                        phi_4332_ = type_24(select(-340282350000000000000000000000000000000f, _e1584, (_e1584 > -340282350000000000000000000000000000000f)), _e1561.member.member_1, _e1561.member.member_2, _e1561.member.member_3);
                    } else {
                        phi_4332_ = type_24(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                    }
                    let _e1591 = phi_4332_;
                    if _e147 {
                    } else {
                        break;
                    }
                    global_6.member[_e145] = _e1591;
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
