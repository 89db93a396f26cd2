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
    var phi_401_: i32;
    var phi_402_: i32;
    var phi_412_: bool;
    var phi_422_: u32;
    var phi_423_: u32;
    var phi_425_: bool;
    var phi_430_: u32;
    var phi_475_: f32;
    var phi_481_: f32;
    var phi_492_: f32;
    var phi_498_: f32;
    var phi_521_: f32;
    var phi_532_: f32;
    var phi_541_: f32;
    var phi_547_: f32;
    var phi_558_: f32;
    var phi_564_: f32;
    var phi_587_: f32;
    var phi_598_: f32;
    var phi_607_: f32;
    var phi_613_: f32;
    var phi_624_: f32;
    var phi_630_: f32;
    var phi_653_: f32;
    var phi_664_: f32;
    var phi_764_: f32;
    var phi_765_: f32;
    var phi_4510_: bool;
    var phi_1886_: type_42;
    var phi_1889_: type_53;
    var phi_1891_: u32;
    var phi_1893_: bool;
    var phi_1895_: u32;
    var phi_1906_: bool;
    var phi_1943_: type_53;
    var phi_1944_: bool;
    var phi_1945_: u32;
    var phi_3576_: u32;
    var phi_3582_: u32;
    var phi_3836_: u32;
    var phi_3837_: u32;
    var phi_3847_: u32;
    var phi_3849_: u32;
    var phi_3850_: bool;
    var phi_3870_: u32;
    var phi_3871_: u32;
    var phi_3875_: type_56;
    var phi_4219_: type_53;
    var phi_4252_: type_53;
    var phi_4253_: type_53;
    var phi_4254_: u32;
    var phi_4256_: type_53;
    var phi_4257_: u32;
    var phi_4258_: bool;
    var phi_4267_: type_53;
    var phi_4272_: type_53;
    var phi_4273_: bool;
    var phi_4507_: bool;
    var phi_1964_: type_42;
    var phi_1967_: type_8;
    var phi_1968_: type_8;
    var phi_1990_: type_8;
    var phi_2034_: u32;
    var phi_2040_: u32;
    var phi_2050_: u32;
    var phi_2066_: u32;
    var phi_2103_: u32;
    var phi_2109_: u32;
    var phi_2119_: u32;
    var phi_4492_: bool;
    var phi_2135_: type_8;
    var phi_2136_: type_8;
    var phi_2159_: type_8;
    var phi_2182_: u32;
    var phi_2197_: u32;
    var phi_2200_: type_8;
    var phi_2201_: type_8;
    var phi_2224_: type_8;
    var phi_2290_: u32;
    var phi_2270_: u32;
    var phi_2271_: u32;
    var phi_2294_: f32;
    var phi_4485_: bool;
    var phi_4560_: bool;
    var phi_4559_: bool;
    var phi_2794_: vec3<f32>;
    var phi_2795_: vec3<f32>;
    var phi_2826_: bool;
    var phi_2835_: vec3<f32>;
    var phi_2875_: type_28;
    var phi_2877_: type_28;
    var phi_2878_: bool;
    var phi_2882_: type_28;
    var phi_2883_: type_28;
    var phi_2884_: type_28;
    var phi_2885_: bool;
    var phi_2889_: type_28;
    var phi_2890_: bool;
    var phi_2894_: type_28;
    var phi_2895_: bool;
    var phi_2899_: type_28;
    var phi_2924_: bool;
    var phi_2925_: bool;
    var phi_2932_: type_42;
    var phi_2933_: type_42;
    var phi_2934_: type_42;
    var phi_4562_: bool;
    var phi_1965_: type_42;
    var phi_4561_: bool;
    var phi_4624_: bool;
    var phi_4275_: type_42;
    var phi_4276_: type_53;
    var phi_4277_: bool;
    var phi_4278_: u32;
    var phi_4623_: bool;
    var phi_4279_: type_42;
    var phi_4280_: type_53;
    var phi_4281_: u32;
    var phi_4282_: bool;
    var phi_4283_: u32;
    var phi_4622_: bool;
    var phi_4284_: type_42;
    var phi_4285_: type_53;
    var phi_4286_: u32;
    var phi_4287_: bool;
    var phi_4288_: u32;
    var phi_4621_: bool;
    var phi_1887_: type_42;
    var phi_1890_: type_53;
    var phi_1892_: u32;
    var phi_1894_: bool;
    var phi_1896_: u32;
    var phi_4289_: bool;
    var phi_4620_: bool;
    var local_7: type_42;
    var local_8: type_42;
    var local_9: type_42;

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
                        phi_475_ = _e289[0];
                    } else {
                        phi_475_ = _e289[1];
                    }
                    let _e294 = phi_475_;
                    let _e295 = (_e259 == 2u);
                    if _e295 {
                        phi_481_ = _e289[2];
                    } else {
                        phi_481_ = _e294;
                    }
                    let _e298 = phi_481_;
                    let _e300 = ((_e298 * _e266) * _e272);
                    let _e301 = global_4.member[_e145].member_2;
                    if _e290 {
                        phi_492_ = _e301[0];
                    } else {
                        phi_492_ = _e301[1];
                    }
                    let _e305 = phi_492_;
                    if _e295 {
                        phi_498_ = _e301[2];
                    } else {
                        phi_498_ = _e305;
                    }
                    let _e308 = phi_498_;
                    let _e310 = ((_e308 * _e279) * _e285);
                    let _e314 = (bitcast<f32>((bitcast<u32>(_e310) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e314 {
                        let _e318 = (bitcast<f32>((bitcast<u32>(_e300) & 2147483647u)) * 0.00000011920929f);
                        phi_521_ = select(0.00000000000011368684f, _e318, (_e318 > 0.00000000000011368684f));
                    } else {
                        phi_521_ = 0f;
                    }
                    let _e322 = phi_521_;
                    let _e323 = (_e300 + _e322);
                    let _e324 = (_e300 - _e322);
                    let _e325 = select(_e310, 0f, _e314);
                    if _e314 {
                        phi_532_ = 38685626000000000000000000f;
                    } else {
                        phi_532_ = (1f / _e310);
                    }
                    let _e328 = phi_532_;
                    let _e329 = (_e258 == 0u);
                    if _e329 {
                        phi_541_ = _e289[0];
                    } else {
                        phi_541_ = _e289[1];
                    }
                    let _e333 = phi_541_;
                    let _e334 = (_e258 == 2u);
                    if _e334 {
                        phi_547_ = _e289[2];
                    } else {
                        phi_547_ = _e333;
                    }
                    let _e337 = phi_547_;
                    let _e339 = ((_e337 * _e266) * _e272);
                    if _e329 {
                        phi_558_ = _e301[0];
                    } else {
                        phi_558_ = _e301[1];
                    }
                    let _e343 = phi_558_;
                    if _e334 {
                        phi_564_ = _e301[2];
                    } else {
                        phi_564_ = _e343;
                    }
                    let _e346 = phi_564_;
                    let _e348 = ((_e346 * _e279) * _e285);
                    let _e352 = (bitcast<f32>((bitcast<u32>(_e348) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e352 {
                        let _e356 = (bitcast<f32>((bitcast<u32>(_e339) & 2147483647u)) * 0.00000011920929f);
                        phi_587_ = select(0.00000000000011368684f, _e356, (_e356 > 0.00000000000011368684f));
                    } else {
                        phi_587_ = 0f;
                    }
                    let _e360 = phi_587_;
                    let _e361 = (_e339 + _e360);
                    let _e362 = (_e339 - _e360);
                    let _e363 = select(_e348, 0f, _e352);
                    if _e352 {
                        phi_598_ = 38685626000000000000000000f;
                    } else {
                        phi_598_ = (1f / _e348);
                    }
                    let _e366 = phi_598_;
                    let _e367 = (_e260 == 0u);
                    if _e367 {
                        phi_607_ = _e289[0];
                    } else {
                        phi_607_ = _e289[1];
                    }
                    let _e371 = phi_607_;
                    let _e372 = (_e260 == 2u);
                    if _e372 {
                        phi_613_ = _e289[2];
                    } else {
                        phi_613_ = _e371;
                    }
                    let _e375 = phi_613_;
                    let _e377 = ((_e375 * _e266) * _e272);
                    if _e367 {
                        phi_624_ = _e301[0];
                    } else {
                        phi_624_ = _e301[1];
                    }
                    let _e381 = phi_624_;
                    if _e372 {
                        phi_630_ = _e301[2];
                    } else {
                        phi_630_ = _e381;
                    }
                    let _e384 = phi_630_;
                    let _e386 = ((_e384 * _e279) * _e285);
                    let _e390 = (bitcast<f32>((bitcast<u32>(_e386) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e390 {
                        let _e394 = (bitcast<f32>((bitcast<u32>(_e377) & 2147483647u)) * 0.00000011920929f);
                        phi_653_ = select(0.00000000000011368684f, _e394, (_e394 > 0.00000000000011368684f));
                    } else {
                        phi_653_ = 0f;
                    }
                    let _e398 = phi_653_;
                    let _e399 = (_e377 + _e398);
                    let _e400 = (_e377 - _e398);
                    let _e401 = select(_e386, 0f, _e390);
                    if _e390 {
                        phi_664_ = 38685626000000000000000000f;
                    } else {
                        phi_664_ = (1f / _e386);
                    }
                    let _e404 = phi_664_;
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
                        phi_764_ = select(-340282350000000000000000000000000000000f, _e445, (_e445 > -340282350000000000000000000000000000000f));
                        phi_765_ = select(-340282350000000000000000000000000000000f, _e438, (_e438 > -340282350000000000000000000000000000000f));
                    } else {
                        phi_764_ = 0f;
                        phi_765_ = 1f;
                    }
                    let _e449 = phi_764_;
                    let _e451 = phi_765_;
                    local_3 = array<type_53, 128>(type_53(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u));
                    local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    let _e456 = (_e259 % 3u);
                    let _e457 = (_e456 < 3u);
                    if _e457 {
                    } else {
                        break;
                    }
                    let _e459 = local_1[_e456];
                    let _e462 = (_e258 % 3u);
                    let _e463 = (_e462 < 3u);
                    if _e463 {
                    } else {
                        break;
                    }
                    let _e465 = local_1[_e462];
                    let _e468 = (_e260 % 3u);
                    let _e469 = (_e468 < 3u);
                    if _e469 {
                    } else {
                        break;
                    }
                    let _e471 = local_1[_e468];
                    if _e457 {
                    } else {
                        break;
                    }
                    let _e476 = local[_e456];
                    if _e463 {
                    } else {
                        break;
                    }
                    let _e480 = local[_e462];
                    if _e469 {
                    } else {
                        break;
                    }
                    let _e484 = local[_e468];
                    phi_4510_ = false;
                    phi_1886_ = type_42(type_36(type_28(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e449), 0u, 0u);
                    phi_1889_ = type_53(type_32(vec4<f32>((f32(_e459) * _e139), (f32(_e465) * _e139), (f32(_e471) * _e139), 0f), vec4<f32>((f32(_e476) * _e139), (f32(_e480) * _e139), (f32(_e484) * _e139), 0f)), select(0u, 2147483648u, (_e88 == 0u)));
                    phi_1891_ = ((3u * _e88) + 1u);
                    phi_1893_ = (_e451 <= _e449);
                    phi_1895_ = 0u;
                    loop {
                        let _e494 = phi_4510_;
                        let _e496 = phi_1886_;
                        let _e498 = phi_1889_;
                        let _e500 = phi_1891_;
                        let _e502 = phi_1893_;
                        let _e504 = phi_1895_;
                        local_7 = _e496;
                        local_8 = _e496;
                        if _e502 {
                            phi_1906_ = true;
                        } else {
                            phi_1906_ = (_e504 > 0u);
                        }
                        let _e507 = phi_1906_;
                        if _e507 {
                            let _e508 = (_e500 > 0u);
                            if _e508 {
                                if _e502 {
                                    phi_1943_ = _e498;
                                    phi_1944_ = _e502;
                                    phi_1945_ = _e504;
                                } else {
                                    let _e509 = (_e504 - 1u);
                                    let _e510 = (_e509 % 128u);
                                    let _e511 = (_e510 < 128u);
                                    if _e511 {
                                    } else {
                                        phi_4620_ = true;
                                        break;
                                    }
                                    let _e513 = local_3[_e510];
                                    if _e511 {
                                    } else {
                                        phi_4620_ = true;
                                        break;
                                    }
                                    let _e521 = local_2[_e510];
                                    phi_1943_ = type_53(type_32(_e513.member.member, _e513.member.member_1), _e513.member_1);
                                    phi_1944_ = (_e521 <= _e496.member.member_1);
                                    phi_1945_ = _e509;
                                }
                                let _e526 = phi_1943_;
                                let _e528 = phi_1944_;
                                let _e530 = phi_1945_;
                                if _e528 {
                                    let _e535 = (_e526.member_1 & 268435455u);
                                    if ((_e526.member_1 & 2147483648u) != 0u) {
                                        phi_4507_ = _e494;
                                        phi_1964_ = _e496;
                                        phi_1967_ = type_8(0u, ((_e526.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e1004 = phi_4507_;
                                            let _e1006 = phi_1964_;
                                            let _e1008 = phi_1967_;
                                            local_9 = _e1006;
                                            if (_e1008.member < _e1008.member_1) {
                                                phi_1968_ = type_8((_e1008.member + 1u), _e1008.member_1);
                                                phi_1990_ = type_8(1u, _e1008.member);
                                            } else {
                                                phi_1968_ = _e1008;
                                                phi_1990_ = type_8(0u, type_8().member_1);
                                            }
                                            let _e1021 = phi_1968_;
                                            let _e1023 = phi_1990_;
                                            let _e1027 = (bitcast<i32>(_e1023.member) != 0i);
                                            if _e1027 {
                                                let _e1033 = type_42(_e1006.member, _e1006.member_1, (_e1006.member_2 + 1u));
                                                let _e1038 = (_e526.member.member_1.x - _e526.member.member.x);
                                                let _e1041 = (_e526.member.member_1.y - _e526.member.member.y);
                                                let _e1044 = (_e526.member.member_1.z - _e526.member.member.z);
                                                let _e1046 = select(_e1041, _e1038, (_e1038 > _e1041));
                                                let _e1048 = select(_e1044, _e1046, (_e1046 > _e1044));
                                                let _e1050 = (_e1048 < (1024f * _e139));
                                                if _e1050 {
                                                    phi_2034_ = 0u;
                                                } else {
                                                    phi_2034_ = select(2u, 1u, (_e1048 < (2097152f * _e139)));
                                                }
                                                let _e1055 = phi_2034_;
                                                switch bitcast<i32>(_e1055) {
                                                    case 0: {
                                                        phi_2040_ = 1u;
                                                        break;
                                                    }
                                                    case 1: {
                                                        phi_2040_ = 2u;
                                                        break;
                                                    }
                                                    case 2: {
                                                        phi_2040_ = 3u;
                                                        break;
                                                    }
                                                    default: {
                                                        phi_2040_ = u32();
                                                        break;
                                                    }
                                                }
                                                let _e1058 = phi_2040_;
                                                switch bitcast<i32>(_e1055) {
                                                    case 0: {
                                                        phi_2050_ = 1u;
                                                        break;
                                                    }
                                                    case 1: {
                                                        phi_2050_ = 2u;
                                                        break;
                                                    }
                                                    case 2: {
                                                        phi_2050_ = 3u;
                                                        break;
                                                    }
                                                    default: {
                                                        phi_2050_ = u32();
                                                        break;
                                                    }
                                                }
                                                let _e1065 = phi_2050_;
                                                let _e1067 = ((_e535 + (_e1023.member_1 * ((3u * _e1058) + 1u))) + (3u * _e1065));
                                                let _e1068 = (_e1067 < _e91);
                                                if _e1068 {
                                                    if _e1068 {
                                                    } else {
                                                        phi_4561_ = true;
                                                        break;
                                                    }
                                                    let _e1070 = global_5.member[_e1067];
                                                    phi_2066_ = _e1070;
                                                } else {
                                                    phi_2066_ = 4294967295u;
                                                }
                                                let _e1072 = phi_2066_;
                                                local_4 = array<u32, 3>(_e259, _e258, _e260);
                                                if _e1050 {
                                                    phi_2103_ = 0u;
                                                } else {
                                                    phi_2103_ = select(2u, 1u, (_e1048 < (2097152f * _e139)));
                                                }
                                                let _e1078 = phi_2103_;
                                                switch bitcast<i32>(_e1078) {
                                                    case 0: {
                                                        phi_2109_ = 1u;
                                                        break;
                                                    }
                                                    case 1: {
                                                        phi_2109_ = 2u;
                                                        break;
                                                    }
                                                    case 2: {
                                                        phi_2109_ = 3u;
                                                        break;
                                                    }
                                                    default: {
                                                        phi_2109_ = u32();
                                                        break;
                                                    }
                                                }
                                                let _e1081 = phi_2109_;
                                                switch bitcast<i32>(_e1078) {
                                                    case 0: {
                                                        phi_2119_ = 1u;
                                                        break;
                                                    }
                                                    case 1: {
                                                        phi_2119_ = 2u;
                                                        break;
                                                    }
                                                    case 2: {
                                                        phi_2119_ = 3u;
                                                        break;
                                                    }
                                                    default: {
                                                        phi_2119_ = u32();
                                                        break;
                                                    }
                                                }
                                                let _e1088 = phi_2119_;
                                                local_6 = array<f32, 4>(_e526.member.member.x, _e526.member.member.y, _e526.member.member.z, _e526.member.member.w);
                                                local_5[0u] = array<f32, 3>(0f, 0f, 0f);
                                                local_5[1u] = array<f32, 3>(0f, 0f, 0f);
                                                local_5[2u] = array<f32, 3>(0f, 0f, 0f);
                                                phi_4492_ = _e1004;
                                                phi_2135_ = type_8(0u, 3u);
                                                loop {
                                                    let _e1102 = phi_4492_;
                                                    let _e1104 = phi_2135_;
                                                    if (_e1104.member < _e1104.member_1) {
                                                        phi_2136_ = type_8((_e1104.member + 1u), _e1104.member_1);
                                                        phi_2159_ = type_8(1u, _e1104.member);
                                                    } else {
                                                        phi_2136_ = _e1104;
                                                        phi_2159_ = type_8(0u, type_8().member_1);
                                                    }
                                                    let _e1117 = phi_2136_;
                                                    let _e1119 = phi_2159_;
                                                    let _e1123 = (bitcast<i32>(_e1119.member) != 0i);
                                                    if _e1123 {
                                                        let _e1125 = ((_e535 + (_e1023.member_1 * ((3u * _e1081) + 1u))) + (_e1119.member_1 * _e1088));
                                                        let _e1126 = (_e1125 < _e91);
                                                        if _e1126 {
                                                            if _e1126 {
                                                            } else {
                                                                phi_4559_ = true;
                                                                break;
                                                            }
                                                            let _e1128 = global_5.member[_e1125];
                                                            phi_2182_ = _e1128;
                                                        } else {
                                                            phi_2182_ = 0u;
                                                        }
                                                        let _e1130 = phi_2182_;
                                                        let _e1131 = (_e1125 + 1u);
                                                        let _e1132 = (_e1131 < _e91);
                                                        if _e1132 {
                                                            if _e1132 {
                                                            } else {
                                                                phi_4559_ = true;
                                                                break;
                                                            }
                                                            let _e1134 = global_5.member[_e1131];
                                                            phi_2197_ = _e1134;
                                                        } else {
                                                            phi_2197_ = 0u;
                                                        }
                                                        let _e1136 = phi_2197_;
                                                        phi_2200_ = type_8(0u, 3u);
                                                        loop {
                                                            let _e1138 = phi_2200_;
                                                            if (_e1138.member < _e1138.member_1) {
                                                                phi_2201_ = type_8((_e1138.member + 1u), _e1138.member_1);
                                                                phi_2224_ = type_8(1u, _e1138.member);
                                                            } else {
                                                                phi_2201_ = _e1138;
                                                                phi_2224_ = type_8(0u, type_8().member_1);
                                                            }
                                                            let _e1151 = phi_2201_;
                                                            let _e1153 = phi_2224_;
                                                            let _e1157 = (bitcast<i32>(_e1153.member) != 0i);
                                                            if _e1157 {
                                                                let _e1158 = (_e1153.member_1 < 3u);
                                                                if _e1158 {
                                                                } else {
                                                                    phi_4485_ = true;
                                                                    break;
                                                                }
                                                                let _e1160 = local_4[_e1153.member_1];
                                                                if (_e1153.member_1 < 4u) {
                                                                } else {
                                                                    phi_4485_ = true;
                                                                    break;
                                                                }
                                                                let _e1163 = local_6[_e1153.member_1];
                                                                switch bitcast<i32>(_e1078) {
                                                                    case 0: {
                                                                        phi_2294_ = (_e1163 + (f32(((_e1130 >> bitcast<u32>(((10u * _e1160) & 31u))) & 1023u)) * _e139));
                                                                        break;
                                                                    }
                                                                    case 1: {
                                                                        if (_e1160 == 0u) {
                                                                            phi_2271_ = _e1130;
                                                                        } else {
                                                                            if (_e1160 == 1u) {
                                                                                phi_2270_ = ((_e1130 >> bitcast<u32>(21i)) | (_e1136 << bitcast<u32>(11i)));
                                                                            } else {
                                                                                phi_2270_ = (_e1136 >> bitcast<u32>(10i));
                                                                            }
                                                                            let _e1184 = phi_2270_;
                                                                            phi_2271_ = _e1184;
                                                                        }
                                                                        let _e1186 = phi_2271_;
                                                                        phi_2294_ = (_e1163 + (f32((_e1186 & 2097151u)) * _e139));
                                                                        break;
                                                                    }
                                                                    case 2: {
                                                                        let _e1165 = (_e1125 + _e1160);
                                                                        let _e1166 = (_e1165 < _e91);
                                                                        if _e1166 {
                                                                            if _e1166 {
                                                                            } else {
                                                                                phi_4485_ = true;
                                                                                break;
                                                                            }
                                                                            let _e1168 = global_5.member[_e1165];
                                                                            phi_2290_ = _e1168;
                                                                        } else {
                                                                            phi_2290_ = 0u;
                                                                        }
                                                                        let _e1170 = phi_2290_;
                                                                        phi_2294_ = (f32(bitcast<i32>(_e1170)) * _e139);
                                                                        break;
                                                                    }
                                                                    default: {
                                                                        phi_2294_ = f32();
                                                                        break;
                                                                    }
                                                                }
                                                                let _e1200 = phi_2294_;
                                                                if (_e1119.member_1 < 3u) {
                                                                } else {
                                                                    phi_4485_ = true;
                                                                    break;
                                                                }
                                                                if _e1158 {
                                                                } else {
                                                                    phi_4485_ = true;
                                                                    break;
                                                                }
                                                                local_5[_e1119.member_1][_e1153.member_1] = _e1200;
                                                            }
                                                            continue;
                                                            continuing {
                                                                phi_2200_ = _e1151;
                                                                phi_4485_ = _e1102;
                                                                break if !(_e1157);
                                                            }
                                                        }
                                                        let _e1206 = phi_4485_;
                                                        phi_4559_ = _e1206;
                                                        if _e1206 {
                                                            break;
                                                        }
                                                        phi_4560_ = _e1206;
                                                    } else {
                                                        phi_4560_ = _e1102;
                                                    }
                                                    let _e1208 = phi_4560_;
                                                    continue;
                                                    continuing {
                                                        phi_4492_ = _e1208;
                                                        phi_2135_ = _e1117;
                                                        phi_4559_ = _e1208;
                                                        break if !(_e1123);
                                                    }
                                                }
                                                let _e1211 = phi_4559_;
                                                phi_4561_ = _e1211;
                                                if _e1211 {
                                                    break;
                                                }
                                                let _e1212 = local_5;
                                                let _e1229 = (_e1212[0][2] - _e377);
                                                let _e1232 = (((_e1212[0][0] - _e300) * _e401) - (_e1229 * _e325));
                                                let _e1235 = (((_e1212[0][1] - _e339) * _e401) - (_e1229 * _e363));
                                                let _e1238 = (_e1212[1][2] - _e377);
                                                let _e1241 = (((_e1212[1][0] - _e300) * _e401) - (_e1238 * _e325));
                                                let _e1244 = (((_e1212[1][1] - _e339) * _e401) - (_e1238 * _e363));
                                                let _e1247 = (_e1212[2][2] - _e377);
                                                let _e1250 = (((_e1212[2][0] - _e300) * _e401) - (_e1247 * _e325));
                                                let _e1253 = (((_e1212[2][1] - _e339) * _e401) - (_e1247 * _e363));
                                                let _e1254 = (_e1250 * _e1244);
                                                let _e1255 = (_e1253 * _e1241);
                                                let _e1256 = (_e1232 * _e1253);
                                                let _e1257 = (_e1235 * _e1250);
                                                let _e1258 = (_e1241 * _e1235);
                                                let _e1259 = (_e1244 * _e1232);
                                                let _e1264 = (((_e1254 >= _e1255) && (_e1256 >= _e1257)) && (_e1258 >= _e1259));
                                                if (_e1264 || (((_e1254 <= _e1255) && (_e1256 <= _e1257)) && (_e1258 <= _e1259))) {
                                                    let _e1271 = select(-1f, 1f, _e1264);
                                                    let _e1273 = ((_e1254 - _e1255) * _e1271);
                                                    let _e1275 = select(0f, _e1273, (_e1273 > 0f));
                                                    let _e1277 = ((_e1256 - _e1257) * _e1271);
                                                    let _e1279 = select(0f, _e1277, (_e1277 > 0f));
                                                    let _e1281 = ((_e1258 - _e1259) * _e1271);
                                                    let _e1283 = select(0f, _e1281, (_e1281 > 0f));
                                                    let _e1285 = ((_e1275 + _e1279) + _e1283);
                                                    if (_e1285 < 0.000000000000000000000000000000000000011754944f) {
                                                        phi_2889_ = type_28();
                                                        phi_2890_ = true;
                                                    } else {
                                                        let _e1288 = select(_e1212[1][0], _e1212[0][0], (_e1212[0][0] < _e1212[1][0]));
                                                        let _e1292 = select(_e1212[1][0], _e1212[0][0], (_e1212[0][0] > _e1212[1][0]));
                                                        let _e1296 = select(_e1212[1][1], _e1212[0][1], (_e1212[0][1] < _e1212[1][1]));
                                                        let _e1300 = select(_e1212[1][1], _e1212[0][1], (_e1212[0][1] > _e1212[1][1]));
                                                        let _e1304 = select(_e1212[1][2], _e1212[0][2], (_e1212[0][2] < _e1212[1][2]));
                                                        let _e1308 = select(_e1212[1][2], _e1212[0][2], (_e1212[0][2] > _e1212[1][2]));
                                                        let _e1313 = ((select(_e1212[2][0], _e1288, (_e1288 < _e1212[2][0])) - _e323) * _e328);
                                                        let _e1314 = ((select(_e1212[2][0], _e1292, (_e1292 > _e1212[2][0])) - _e324) * _e328);
                                                        let _e1317 = ((select(_e1212[2][1], _e1296, (_e1296 < _e1212[2][1])) - _e361) * _e366);
                                                        let _e1318 = ((select(_e1212[2][1], _e1300, (_e1300 > _e1212[2][1])) - _e362) * _e366);
                                                        let _e1321 = ((select(_e1212[2][2], _e1304, (_e1304 < _e1212[2][2])) - _e399) * _e404);
                                                        let _e1322 = ((select(_e1212[2][2], _e1308, (_e1308 > _e1212[2][2])) - _e400) * _e404);
                                                        let _e1324 = select(_e1322, _e1321, (_e1321 < _e1322));
                                                        let _e1326 = select(_e1322, _e1321, (_e1321 > _e1322));
                                                        let _e1328 = select(_e1314, _e1313, (_e1313 < _e1314));
                                                        let _e1330 = select(_e1318, _e1317, (_e1317 < _e1318));
                                                        let _e1332 = select(_e1330, _e1328, (_e1328 > _e1330));
                                                        let _e1334 = select(_e1324, _e1332, (_e1332 > _e1324));
                                                        let _e1336 = select(_e1314, _e1313, (_e1313 > _e1314));
                                                        let _e1338 = select(_e1318, _e1317, (_e1317 > _e1318));
                                                        let _e1340 = select(_e1338, _e1336, (_e1336 < _e1338));
                                                        let _e1342 = select(_e1326, _e1340, (_e1340 < _e1326));
                                                        let _e1343 = -(_e1324);
                                                        let _e1349 = select(_e451, _e1334, (_e1334 > _e451));
                                                        if (_e1349 > (_e1342 + (select(_e1343, _e1326, (_e1326 > _e1343)) * 0.0000019073523f))) {
                                                            phi_2884_ = type_28();
                                                            phi_2885_ = true;
                                                        } else {
                                                            let _e1351 = (_e1349 > _e1006.member.member_1);
                                                            if _e1351 {
                                                                phi_2883_ = type_28();
                                                            } else {
                                                                let _e1355 = (_e1212[1][0] - _e1212[0][0]);
                                                                let _e1356 = (_e1212[1][1] - _e1212[0][1]);
                                                                let _e1357 = (_e1212[1][2] - _e1212[0][2]);
                                                                let _e1358 = vec3<f32>(_e1355, _e1356, _e1357);
                                                                let _e1359 = (_e1212[2][0] - _e1212[1][0]);
                                                                let _e1360 = (_e1212[2][1] - _e1212[1][1]);
                                                                let _e1361 = (_e1212[2][2] - _e1212[1][2]);
                                                                let _e1362 = vec3<f32>(_e1359, _e1360, _e1361);
                                                                let _e1363 = (_e1212[0][0] - _e1212[2][0]);
                                                                let _e1364 = (_e1212[0][1] - _e1212[2][1]);
                                                                let _e1365 = (_e1212[0][2] - _e1212[2][2]);
                                                                let _e1366 = vec3<f32>(_e1363, _e1364, _e1365);
                                                                let _e1369 = bitcast<f32>((bitcast<u32>(_e1355) & 2147483647u));
                                                                let _e1372 = bitcast<f32>((bitcast<u32>(_e1356) & 2147483647u));
                                                                let _e1374 = select(_e1372, _e1369, (_e1369 > _e1372));
                                                                let _e1377 = bitcast<f32>((bitcast<u32>(_e1357) & 2147483647u));
                                                                let _e1379 = select(_e1377, _e1374, (_e1374 > _e1377));
                                                                let _e1382 = bitcast<f32>((bitcast<u32>(_e1359) & 2147483647u));
                                                                let _e1385 = bitcast<f32>((bitcast<u32>(_e1360) & 2147483647u));
                                                                let _e1387 = select(_e1385, _e1382, (_e1382 > _e1385));
                                                                let _e1390 = bitcast<f32>((bitcast<u32>(_e1361) & 2147483647u));
                                                                let _e1392 = select(_e1390, _e1387, (_e1387 > _e1390));
                                                                let _e1395 = bitcast<f32>((bitcast<u32>(_e1363) & 2147483647u));
                                                                let _e1398 = bitcast<f32>((bitcast<u32>(_e1364) & 2147483647u));
                                                                let _e1400 = select(_e1398, _e1395, (_e1395 > _e1398));
                                                                let _e1403 = bitcast<f32>((bitcast<u32>(_e1365) & 2147483647u));
                                                                let _e1405 = select(_e1403, _e1400, (_e1400 > _e1403));
                                                                let _e1407 = select(_e1392, _e1379, (_e1379 > _e1392));
                                                                let _e1409 = select(_e1405, _e1407, (_e1407 > _e1405));
                                                                if (_e1379 == _e1409) {
                                                                    phi_2794_ = _e1362;
                                                                    phi_2795_ = _e1366;
                                                                } else {
                                                                    let _e1412 = vec3((_e1392 == _e1409));
                                                                    phi_2794_ = select(_e1358, _e1366, _e1412);
                                                                    phi_2795_ = select(_e1362, _e1358, _e1412);
                                                                }
                                                                let _e1416 = phi_2794_;
                                                                let _e1418 = phi_2795_;
                                                                let _e1425 = ((_e1416.y * _e1418.z) - (_e1418.y * _e1416.z));
                                                                let _e1430 = ((_e1416.z * _e1418.x) - (_e1418.z * _e1416.x));
                                                                let _e1433 = ((_e1416.x * _e1418.y) - (_e1418.x * _e1416.y));
                                                                if (_e1275 >= _e1279) {
                                                                    phi_2826_ = select(true, false, (_e1275 >= _e1283));
                                                                } else {
                                                                    phi_2826_ = true;
                                                                }
                                                                let _e1438 = phi_2826_;
                                                                if _e1438 {
                                                                    phi_2835_ = select(vec3<f32>(_e1212[2][0], _e1212[2][1], _e1212[2][2]), vec3<f32>(_e1212[1][0], _e1212[1][1], _e1212[1][2]), vec3((_e1279 >= _e1283)));
                                                                } else {
                                                                    phi_2835_ = vec3<f32>(_e1212[0][0], _e1212[0][1], _e1212[0][2]);
                                                                }
                                                                let _e1443 = phi_2835_;
                                                                let _e1460 = ((((_e1425 * (_e1443.x - _e300)) + (_e1430 * (_e1443.y - _e339))) + (_e1433 * (_e1443.z - _e377))) / (((_e1425 * _e325) + (_e1430 * _e363)) + (_e1433 * _e401)));
                                                                let _e1462 = select(_e1342, _e1460, (_e1460 < _e1342));
                                                                let _e1464 = select(_e1334, _e1462, (_e1462 > _e1334));
                                                                if (_e1464 >= _e451) {
                                                                    let _e1466 = (_e1464 <= _e1006.member.member_1);
                                                                    if _e1466 {
                                                                        let _e1467 = (1f / _e1285);
                                                                        phi_2875_ = type_28(_e1464, (_e1279 * _e1467), (_e1283 * _e1467), _e1072);
                                                                    } else {
                                                                        phi_2875_ = type_28();
                                                                    }
                                                                    let _e1472 = phi_2875_;
                                                                    phi_2877_ = _e1472;
                                                                    phi_2878_ = select(true, false, _e1466);
                                                                } else {
                                                                    phi_2877_ = type_28();
                                                                    phi_2878_ = true;
                                                                }
                                                                let _e1475 = phi_2877_;
                                                                let _e1477 = phi_2878_;
                                                                if _e1477 {
                                                                    phi_2882_ = type_28(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                } else {
                                                                    phi_2882_ = _e1475;
                                                                }
                                                                let _e1479 = phi_2882_;
                                                                phi_2883_ = _e1479;
                                                            }
                                                            let _e1481 = phi_2883_;
                                                            phi_2884_ = _e1481;
                                                            phi_2885_ = _e1351;
                                                        }
                                                        let _e1483 = phi_2884_;
                                                        let _e1485 = phi_2885_;
                                                        phi_2889_ = _e1483;
                                                        phi_2890_ = _e1485;
                                                    }
                                                    let _e1487 = phi_2889_;
                                                    let _e1489 = phi_2890_;
                                                    phi_2894_ = _e1487;
                                                    phi_2895_ = _e1489;
                                                } else {
                                                    phi_2894_ = type_28();
                                                    phi_2895_ = true;
                                                }
                                                let _e1491 = phi_2894_;
                                                let _e1493 = phi_2895_;
                                                if _e1493 {
                                                    phi_2899_ = type_28(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                } else {
                                                    phi_2899_ = _e1491;
                                                }
                                                let _e1495 = phi_2899_;
                                                if (_e1495.member_3 != 4294967295u) {
                                                    if (_e1072 != 4294967295u) {
                                                        if (_e1495.member < _e1006.member.member.member) {
                                                            phi_2925_ = true;
                                                        } else {
                                                            if (_e1495.member == _e1006.member.member.member) {
                                                                phi_2924_ = (_e1495.member_3 < _e1006.member.member.member_3);
                                                            } else {
                                                                phi_2924_ = false;
                                                            }
                                                            let _e1510 = phi_2924_;
                                                            phi_2925_ = _e1510;
                                                        }
                                                        let _e1512 = phi_2925_;
                                                        if _e1512 {
                                                            phi_2932_ = type_42(type_36(_e1495, _e1495.member), _e1033.member_1, _e1033.member_2);
                                                        } else {
                                                            phi_2932_ = _e1033;
                                                        }
                                                        let _e1519 = phi_2932_;
                                                        phi_2933_ = _e1519;
                                                    } else {
                                                        phi_2933_ = _e1033;
                                                    }
                                                    let _e1521 = phi_2933_;
                                                    phi_2934_ = _e1521;
                                                } else {
                                                    phi_2934_ = _e1033;
                                                }
                                                let _e1523 = phi_2934_;
                                                phi_4562_ = _e1211;
                                                phi_1965_ = _e1523;
                                            } else {
                                                phi_4562_ = _e1004;
                                                phi_1965_ = type_42();
                                            }
                                            let _e1525 = phi_4562_;
                                            let _e1527 = phi_1965_;
                                            continue;
                                            continuing {
                                                phi_4507_ = _e1525;
                                                phi_1964_ = _e1527;
                                                phi_1967_ = _e1021;
                                                phi_4561_ = _e1525;
                                                break if !(_e1027);
                                            }
                                        }
                                        let _e1530 = phi_4561_;
                                        phi_4620_ = _e1530;
                                        if _e1530 {
                                            break;
                                        }
                                        phi_4624_ = _e1530;
                                        let _e1706 = local_9;
                                        phi_4275_ = _e1706;
                                        phi_4276_ = _e526;
                                        phi_4277_ = false;
                                        phi_4278_ = _e530;
                                    } else {
                                        if (_e526.member_1 >= _e88) {
                                            phi_3875_ = type_56(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), type_53(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u), type_53(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u));
                                        } else {
                                            if (_e526.member_1 < _e88) {
                                            } else {
                                                phi_4620_ = true;
                                                break;
                                            }
                                            let _e549 = ((1u + _e259) % 4u);
                                            if (_e549 < 4u) {
                                            } else {
                                                phi_4620_ = true;
                                                break;
                                            }
                                            let _e554 = global_3.member[_e526.member_1][_e549];
                                            let _e556 = ((1u + _e258) % 4u);
                                            if (_e556 < 4u) {
                                            } else {
                                                phi_4620_ = true;
                                                break;
                                            }
                                            let _e561 = global_3.member[_e526.member_1][_e556];
                                            let _e563 = ((1u + _e260) % 4u);
                                            if (_e563 < 4u) {
                                            } else {
                                                phi_4620_ = true;
                                                break;
                                            }
                                            let _e568 = global_3.member[_e526.member_1][_e563];
                                            let _e570 = ((_e259 + 1u) % 4u);
                                            if (_e570 < 4u) {
                                            } else {
                                                phi_4620_ = true;
                                                break;
                                            }
                                            let _e575 = global_3.member[_e526.member_1][_e570];
                                            let _e577 = (_e575 >> bitcast<u32>(11u));
                                            let _e579 = ((_e258 + 1u) % 4u);
                                            if (_e579 < 4u) {
                                            } else {
                                                phi_4620_ = true;
                                                break;
                                            }
                                            let _e584 = global_3.member[_e526.member_1][_e579];
                                            let _e586 = (_e584 >> bitcast<u32>(11u));
                                            let _e588 = ((_e260 + 1u) % 4u);
                                            if (_e588 < 4u) {
                                            } else {
                                                phi_4620_ = true;
                                                break;
                                            }
                                            let _e593 = global_3.member[_e526.member_1][_e588];
                                            let _e595 = (_e593 >> bitcast<u32>(11u));
                                            let _e618 = (bitcast<f32>((bitcast<u32>((_e526.member.member_1.x - _e526.member.member.x)) & 2139095040u)) * 0.001953125f);
                                            let _e619 = (bitcast<f32>((bitcast<u32>((_e526.member.member_1.y - _e526.member.member.y)) & 2139095040u)) * 0.001953125f);
                                            let _e620 = (bitcast<f32>((bitcast<u32>((_e526.member.member_1.z - _e526.member.member.z)) & 2139095040u)) * 0.001953125f);
                                            let _e622 = select(_e139, _e618, (_e618 > _e139));
                                            let _e624 = select(_e139, _e619, (_e619 > _e139));
                                            let _e626 = select(_e139, _e620, (_e620 > _e139));
                                            let _e651 = bitcast<u32>((f32(bitcast<i32>((_e554 & 1023u))) * _e622));
                                            let _e656 = (bitcast<i32>((_e554 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e659 = bitcast<f32>((_e651 & bitcast<u32>(_e656)));
                                            let _e660 = bitcast<u32>((f32(bitcast<i32>((_e561 & 1023u))) * _e624));
                                            let _e665 = (bitcast<i32>((_e561 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e668 = bitcast<f32>((_e660 & bitcast<u32>(_e665)));
                                            let _e669 = bitcast<u32>((f32(bitcast<i32>((_e568 & 1023u))) * _e626));
                                            let _e674 = (bitcast<i32>((_e568 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e677 = bitcast<f32>((_e669 & bitcast<u32>(_e674)));
                                            let _e681 = bitcast<f32>((_e651 & bitcast<u32>(~(_e656))));
                                            let _e685 = bitcast<f32>((_e660 & bitcast<u32>(~(_e665))));
                                            let _e689 = bitcast<f32>((_e669 & bitcast<u32>(~(_e674))));
                                            let _e690 = bitcast<u32>((f32(bitcast<i32>((_e577 & 1023u))) * _e622));
                                            let _e695 = (bitcast<i32>((_e577 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e698 = bitcast<f32>((_e690 & bitcast<u32>(_e695)));
                                            let _e699 = bitcast<u32>((f32(bitcast<i32>((_e586 & 1023u))) * _e624));
                                            let _e704 = (bitcast<i32>((_e586 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e707 = bitcast<f32>((_e699 & bitcast<u32>(_e704)));
                                            let _e708 = bitcast<u32>((f32(bitcast<i32>((_e595 & 1023u))) * _e626));
                                            let _e713 = (bitcast<i32>((_e595 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e716 = bitcast<f32>((_e708 & bitcast<u32>(_e713)));
                                            let _e720 = bitcast<f32>((_e690 & bitcast<u32>(~(_e695))));
                                            let _e724 = bitcast<f32>((_e699 & bitcast<u32>(~(_e704))));
                                            let _e728 = bitcast<f32>((_e708 & bitcast<u32>(~(_e713))));
                                            let _e729 = (_e526.member.member.x + _e659);
                                            let _e730 = (_e526.member.member.y + _e668);
                                            let _e731 = (_e526.member.member.z + _e677);
                                            let _e734 = (_e526.member.member_1.x - _e698);
                                            let _e735 = (_e526.member.member_1.y - _e707);
                                            let _e736 = (_e526.member.member_1.z - _e716);
                                            let _e755 = (_e734 - _e729);
                                            let _e756 = (_e735 - _e730);
                                            let _e757 = (_e736 - _e731);
                                            let _e759 = select(_e756, _e755, (_e755 > _e756));
                                            let _e761 = select(_e757, _e759, (_e759 > _e757));
                                            if (_e761 < (1024f * _e139)) {
                                                phi_3576_ = 0u;
                                            } else {
                                                phi_3576_ = select(2u, 1u, (_e761 < (2097152f * _e139)));
                                            }
                                            let _e768 = phi_3576_;
                                            switch bitcast<i32>(_e768) {
                                                case 0: {
                                                    phi_3582_ = 1u;
                                                    break;
                                                }
                                                case 1: {
                                                    phi_3582_ = 2u;
                                                    break;
                                                }
                                                case 2: {
                                                    phi_3582_ = 3u;
                                                    break;
                                                }
                                                default: {
                                                    phi_3582_ = u32();
                                                    break;
                                                }
                                            }
                                            let _e771 = phi_3582_;
                                            let _e777 = global_3.member[_e526.member_1][0u];
                                            let _e781 = global_3.member[_e526.member_1][1u];
                                            let _e785 = global_3.member[_e526.member_1][2u];
                                            let _e789 = global_3.member[_e526.member_1][3u];
                                            let _e801 = (((_e781 >> bitcast<u32>(22i)) | ((_e785 >> bitcast<u32>(22i)) << bitcast<u32>(10i))) | ((_e789 >> bitcast<u32>(22i)) << bitcast<u32>(20i)));
                                            let _e802 = (_e777 & 268435455u);
                                            let _e803 = (_e801 & 268435455u);
                                            let _e806 = ((_e777 >> bitcast<u32>(28u)) & 7u);
                                            let _e814 = ((_e777 >> bitcast<u32>(31i)) | (((_e801 >> bitcast<u32>(28u)) & 3u) << bitcast<u32>(1i)));
                                            let _e815 = (_e806 != 0u);
                                            if (_e806 == 0u) {
                                                phi_3837_ = _e802;
                                            } else {
                                                if (_e806 == 7u) {
                                                    phi_3836_ = 2147483648u;
                                                } else {
                                                    phi_3836_ = ((2147483648u | (_e806 << bitcast<u32>(28u))) | (_e803 & 268435455u));
                                                }
                                                let _e824 = phi_3836_;
                                                phi_3837_ = _e824;
                                            }
                                            let _e826 = phi_3837_;
                                            if _e815 {
                                                let _e827 = (_e806 != 7u);
                                                if _e827 {
                                                    phi_3847_ = (_e803 + (_e806 * ((3u * _e771) + 1u)));
                                                } else {
                                                    phi_3847_ = u32();
                                                }
                                                let _e831 = phi_3847_;
                                                phi_3849_ = _e831;
                                                phi_3850_ = select(true, false, _e827);
                                            } else {
                                                phi_3849_ = u32();
                                                phi_3850_ = true;
                                            }
                                            let _e834 = phi_3849_;
                                            let _e836 = phi_3850_;
                                            if (_e814 == 0u) {
                                                phi_3871_ = (_e802 + select(0u, 1u, !(_e815)));
                                            } else {
                                                if (_e814 == 7u) {
                                                    phi_3870_ = 2147483648u;
                                                } else {
                                                    phi_3870_ = ((2147483648u | (_e814 << bitcast<u32>(28u))) | (select(_e834, _e803, _e836) & 268435455u));
                                                }
                                                let _e849 = phi_3870_;
                                                phi_3871_ = _e849;
                                            }
                                            let _e851 = phi_3871_;
                                            phi_3875_ = type_56(array<vec4<f32>, 3>(vec4<f32>(_e729, (_e526.member.member.x + _e681), _e734, (_e526.member.member_1.x - _e720)), vec4<f32>(_e730, (_e526.member.member.y + _e685), _e735, (_e526.member.member_1.y - _e724)), vec4<f32>(_e731, (_e526.member.member.z + _e689), _e736, (_e526.member.member_1.z - _e728))), type_53(type_32((_e526.member.member + vec4<f32>(_e659, _e668, _e677, 0f)), (_e526.member.member_1 - vec4<f32>(_e698, _e707, _e716, 0f))), _e826), type_53(type_32((_e526.member.member + vec4<f32>(_e681, _e685, _e689, 0f)), (_e526.member.member_1 - vec4<f32>(_e720, _e724, _e728, 0f))), _e851));
                                        }
                                        let _e856 = phi_3875_;
                                        let _e869 = ((_e856.member[0].x - _e323) * _e328);
                                        let _e870 = ((_e856.member[0].y - _e323) * _e328);
                                        let _e871 = ((_e856.member[0].z - _e324) * _e328);
                                        let _e872 = ((_e856.member[0].w - _e324) * _e328);
                                        let _e882 = ((_e856.member[1].x - _e361) * _e366);
                                        let _e883 = ((_e856.member[1].y - _e361) * _e366);
                                        let _e884 = ((_e856.member[1].z - _e362) * _e366);
                                        let _e885 = ((_e856.member[1].w - _e362) * _e366);
                                        let _e895 = ((_e856.member[2].x - _e399) * _e404);
                                        let _e896 = ((_e856.member[2].y - _e399) * _e404);
                                        let _e897 = ((_e856.member[2].z - _e400) * _e404);
                                        let _e898 = ((_e856.member[2].w - _e400) * _e404);
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
                                        let _e950 = select(_e451, _e920, (_e920 > _e451));
                                        let _e952 = select(_e451, _e922, (_e922 > _e451));
                                        let _e957 = (_e950 <= select(_e496.member.member_1, _e947, (_e947 < _e496.member.member_1)));
                                        let _e958 = (_e952 <= select(_e496.member.member_1, _e948, (_e948 < _e496.member.member_1)));
                                        let _e959 = (_e950 <= _e952);
                                        if _e957 {
                                            if _e958 {
                                                if _e959 {
                                                    phi_4219_ = _e856.member_2;
                                                } else {
                                                    phi_4219_ = _e856.member_1;
                                                }
                                                let _e963 = phi_4219_;
                                                let _e964 = (_e530 % 128u);
                                                let _e965 = (_e964 < 128u);
                                                if _e965 {
                                                } else {
                                                    phi_4620_ = true;
                                                    break;
                                                }
                                                local_3[_e964] = type_53(type_32(_e963.member.member, _e963.member.member_1), _e963.member_1);
                                                if _e965 {
                                                } else {
                                                    phi_4620_ = true;
                                                    break;
                                                }
                                                local_2[_e964] = select(_e952, _e950, (_e950 > _e952));
                                                if _e959 {
                                                    phi_4252_ = _e856.member_1;
                                                } else {
                                                    phi_4252_ = _e856.member_2;
                                                }
                                                let _e980 = phi_4252_;
                                                phi_4253_ = _e980;
                                                phi_4254_ = (_e530 + 1u);
                                            } else {
                                                phi_4253_ = type_53();
                                                phi_4254_ = u32();
                                            }
                                            let _e982 = phi_4253_;
                                            let _e984 = phi_4254_;
                                            phi_4256_ = _e982;
                                            phi_4257_ = _e984;
                                            phi_4258_ = select(true, false, _e958);
                                        } else {
                                            phi_4256_ = type_53();
                                            phi_4257_ = u32();
                                            phi_4258_ = true;
                                        }
                                        let _e987 = phi_4256_;
                                        let _e989 = phi_4257_;
                                        let _e991 = phi_4258_;
                                        if _e991 {
                                            if _e957 {
                                                phi_4267_ = _e856.member_1;
                                            } else {
                                                phi_4267_ = _e856.member_2;
                                            }
                                            let _e995 = phi_4267_;
                                            phi_4272_ = _e995;
                                            phi_4273_ = select(_e958, true, _e957);
                                        } else {
                                            phi_4272_ = _e987;
                                            phi_4273_ = _e528;
                                        }
                                        let _e998 = phi_4272_;
                                        let _e1000 = phi_4273_;
                                        phi_4624_ = _e494;
                                        phi_4275_ = type_42(_e496.member, (_e496.member_1 + 1u), _e496.member_2);
                                        phi_4276_ = _e998;
                                        phi_4277_ = _e1000;
                                        phi_4278_ = select(_e989, _e530, _e991);
                                    }
                                    let _e1532 = phi_4624_;
                                    let _e1534 = phi_4275_;
                                    let _e1536 = phi_4276_;
                                    let _e1538 = phi_4277_;
                                    let _e1540 = phi_4278_;
                                    phi_4623_ = _e1532;
                                    phi_4279_ = _e1534;
                                    phi_4280_ = _e1536;
                                    phi_4281_ = (_e500 - 1u);
                                    phi_4282_ = _e1538;
                                    phi_4283_ = _e1540;
                                } else {
                                    phi_4623_ = _e494;
                                    phi_4279_ = _e496;
                                    phi_4280_ = _e526;
                                    phi_4281_ = _e500;
                                    phi_4282_ = _e528;
                                    phi_4283_ = _e530;
                                }
                                let _e1542 = phi_4623_;
                                let _e1544 = phi_4279_;
                                let _e1546 = phi_4280_;
                                let _e1548 = phi_4281_;
                                let _e1550 = phi_4282_;
                                let _e1552 = phi_4283_;
                                phi_4622_ = _e1542;
                                phi_4284_ = _e1544;
                                phi_4285_ = _e1546;
                                phi_4286_ = _e1548;
                                phi_4287_ = _e1550;
                                phi_4288_ = _e1552;
                            } else {
                                phi_4622_ = _e494;
                                phi_4284_ = type_42();
                                phi_4285_ = type_53();
                                phi_4286_ = u32();
                                phi_4287_ = bool();
                                phi_4288_ = u32();
                            }
                            let _e1554 = phi_4622_;
                            let _e1556 = phi_4284_;
                            let _e1558 = phi_4285_;
                            let _e1560 = phi_4286_;
                            let _e1562 = phi_4287_;
                            let _e1564 = phi_4288_;
                            phi_4621_ = _e1554;
                            phi_1887_ = _e1556;
                            phi_1890_ = _e1558;
                            phi_1892_ = _e1560;
                            phi_1894_ = _e1562;
                            phi_1896_ = _e1564;
                            phi_4289_ = _e508;
                        } else {
                            phi_4621_ = _e494;
                            phi_1887_ = type_42();
                            phi_1890_ = type_53();
                            phi_1892_ = u32();
                            phi_1894_ = bool();
                            phi_1896_ = u32();
                            phi_4289_ = false;
                        }
                        let _e1566 = phi_4621_;
                        let _e1568 = phi_1887_;
                        let _e1570 = phi_1890_;
                        let _e1572 = phi_1892_;
                        let _e1574 = phi_1894_;
                        let _e1576 = phi_1896_;
                        let _e1578 = phi_4289_;
                        continue;
                        continuing {
                            phi_4510_ = _e1566;
                            phi_1886_ = _e1568;
                            phi_1889_ = _e1570;
                            phi_1891_ = _e1572;
                            phi_1893_ = _e1574;
                            phi_1895_ = _e1576;
                            phi_4620_ = _e1566;
                            break if !(_e1578);
                        }
                    }
                    let _e1581 = phi_4620_;
                    if _e1581 {
                        break;
                    }
                    let _e1583 = local_7;
                    let _e1586 = local_8;
                    if _e147 {
                    } else {
                        break;
                    }
                    global_6.member[_e145][0u] = _e1583.member_1;
                    global_6.member[_e145][1u] = _e1586.member_2;
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
