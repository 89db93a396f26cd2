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
    var phi_1886_: type_38;
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
    var phi_1964_: type_38;
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
    var phi_2875_: type_24;
    var phi_2877_: type_24;
    var phi_2878_: bool;
    var phi_2882_: type_24;
    var phi_2883_: type_24;
    var phi_2884_: type_24;
    var phi_2885_: bool;
    var phi_2889_: type_24;
    var phi_2890_: bool;
    var phi_2894_: type_24;
    var phi_2895_: bool;
    var phi_2899_: type_24;
    var phi_2924_: bool;
    var phi_2925_: bool;
    var phi_2932_: type_38;
    var phi_2933_: type_38;
    var phi_2934_: type_38;
    var phi_4562_: bool;
    var phi_1965_: type_38;
    var phi_4561_: bool;
    var phi_4624_: bool;
    var phi_4275_: type_38;
    var phi_4276_: type_53;
    var phi_4277_: bool;
    var phi_4278_: u32;
    var phi_4623_: bool;
    var phi_4279_: type_38;
    var phi_4280_: type_53;
    var phi_4281_: u32;
    var phi_4282_: bool;
    var phi_4283_: u32;
    var phi_4622_: bool;
    var phi_4284_: type_38;
    var phi_4285_: type_53;
    var phi_4286_: u32;
    var phi_4287_: bool;
    var phi_4288_: u32;
    var phi_4621_: bool;
    var phi_1887_: type_38;
    var phi_1890_: type_53;
    var phi_1892_: u32;
    var phi_1894_: bool;
    var phi_1896_: u32;
    var phi_4289_: bool;
    var phi_4620_: bool;
    var local_7: type_38;
    var local_8: type_38;
    var local_9: type_38;

    switch bitcast<i32>(0u) {
        default: {
            let _e85 = global;
            let _e87 = arrayLength((&global_4.member));
            let _e90 = arrayLength((&global_5.member));
            let _e98 = global_2.member[0u][0u];
            let _e102 = global_2.member[0u][1u];
            let _e106 = global_2.member[0u][2u];
            let _e110 = global_2.member[0u][3u];
            let _e114 = global_2.member[1u][0u];
            let _e118 = global_2.member[1u][1u];
            let _e122 = global_2.member[1u][2u];
            let _e125 = global_1.member[0u];
            let _e126 = bitcast<i32>(_e125);
            let _e138 = bitcast<f32>((bitcast<u32>((bitcast<i32>(_e110) + 127i)) << bitcast<u32>(23i)));
            local_1 = array<i32, 3>(bitcast<i32>(_e98), bitcast<i32>(_e102), bitcast<i32>(_e106));
            local = array<i32, 3>(bitcast<i32>(_e114), bitcast<i32>(_e118), bitcast<i32>(_e122));
            let _e144 = (_e85.x + (_e85.y * 2097152u));
            let _e145 = (_e144 < arrayLength((&global_3.member)));
            if _e145 {
                let _e146 = (_e144 < arrayLength((&global_6.member)));
                if _e146 {
                    if _e145 {
                    } else {
                        break;
                    }
                    let _e154 = global_3.member[_e144].member_2[0u];
                    let _e156 = (bitcast<u32>(_e154) & 2147483647u);
                    let _e161 = global_3.member[_e144].member_2[1u];
                    let _e163 = (bitcast<u32>(_e161) & 2147483647u);
                    let _e168 = global_3.member[_e144].member_2[2u];
                    let _e170 = (bitcast<u32>(_e168) & 2147483647u);
                    let _e175 = global_3.member[_e144].member[0u];
                    let _e177 = (bitcast<u32>(_e175) & 2147483647u);
                    let _e182 = global_3.member[_e144].member[1u];
                    let _e184 = (bitcast<u32>(_e182) & 2147483647u);
                    let _e189 = global_3.member[_e144].member[2u];
                    let _e191 = (bitcast<u32>(_e189) & 2147483647u);
                    let _e193 = select(_e163, _e156, (_e163 < _e156));
                    let _e195 = select(_e170, _e193, (_e170 < _e193));
                    let _e197 = select(_e177, _e195, (_e177 < _e195));
                    let _e199 = select(_e184, _e197, (_e184 < _e197));
                    let _e201 = select(_e191, _e199, (_e191 < _e199));
                    let _e205 = global_3.member[_e144].member_1;
                    let _e207 = (bitcast<u32>(_e205) & 2147483647u);
                    let _e214 = global_3.member[_e144].member_3;
                    let _e220 = (((select(_e207, _e201, (_e207 < _e201)) < 2139095040u) && ((bitcast<u32>(_e214) & 2147483647u) <= 2139095040u)) && (_e195 > 0u));
                    if _e220 {
                        let _e223 = (bitcast<u32>(bitcast<f32>(_e195)) & 2147483647u);
                        if (_e223 >= 8388608u) {
                            phi_401_ = (bitcast<i32>((_e223 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_401_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e223)), 32u, (_e223 == 0u))));
                        }
                        let _e237 = phi_401_;
                        phi_402_ = _e237;
                    } else {
                        phi_402_ = 0i;
                    }
                    let _e239 = phi_402_;
                    let _e240 = (_e156 == _e195);
                    if _e240 {
                        phi_412_ = true;
                    } else {
                        phi_412_ = (_e163 == _e195);
                    }
                    let _e243 = phi_412_;
                    let _e244 = select(1u, 0u, _e240);
                    if _e243 {
                        let _e245 = (_e244 + 1u);
                        phi_422_ = _e245;
                        phi_423_ = _e245;
                        phi_425_ = select(true, false, (_e245 == 2u));
                    } else {
                        phi_422_ = u32();
                        phi_423_ = 0u;
                        phi_425_ = true;
                    }
                    let _e249 = phi_422_;
                    let _e251 = phi_423_;
                    let _e253 = phi_425_;
                    if _e253 {
                        phi_430_ = (_e251 + 1u);
                    } else {
                        phi_430_ = 0u;
                    }
                    let _e257 = phi_430_;
                    let _e258 = select(_e249, _e251, _e253);
                    let _e259 = select(_e244, select(2u, _e244, _e243), _e253);
                    let _e260 = (_e126 / 2i);
                    let _e265 = bitcast<f32>((bitcast<u32>((_e260 + 127i)) << bitcast<u32>(23i)));
                    let _e271 = bitcast<f32>((bitcast<u32>(((_e126 - _e260) + 127i)) << bitcast<u32>(23i)));
                    let _e272 = -(_e239);
                    let _e273 = (_e272 / 2i);
                    let _e278 = bitcast<f32>((bitcast<u32>((_e273 + 127i)) << bitcast<u32>(23i)));
                    let _e284 = bitcast<f32>((bitcast<u32>(((_e272 - _e273) + 127i)) << bitcast<u32>(23i)));
                    let _e288 = global_3.member[_e144].member;
                    let _e289 = (_e258 == 0u);
                    if _e289 {
                        phi_475_ = _e288[0];
                    } else {
                        phi_475_ = _e288[1];
                    }
                    let _e293 = phi_475_;
                    let _e294 = (_e258 == 2u);
                    if _e294 {
                        phi_481_ = _e288[2];
                    } else {
                        phi_481_ = _e293;
                    }
                    let _e297 = phi_481_;
                    let _e299 = ((_e297 * _e265) * _e271);
                    let _e300 = global_3.member[_e144].member_2;
                    if _e289 {
                        phi_492_ = _e300[0];
                    } else {
                        phi_492_ = _e300[1];
                    }
                    let _e304 = phi_492_;
                    if _e294 {
                        phi_498_ = _e300[2];
                    } else {
                        phi_498_ = _e304;
                    }
                    let _e307 = phi_498_;
                    let _e309 = ((_e307 * _e278) * _e284);
                    let _e313 = (bitcast<f32>((bitcast<u32>(_e309) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e313 {
                        let _e317 = (bitcast<f32>((bitcast<u32>(_e299) & 2147483647u)) * 0.00000011920929f);
                        phi_521_ = select(0.00000000000011368684f, _e317, (_e317 > 0.00000000000011368684f));
                    } else {
                        phi_521_ = 0f;
                    }
                    let _e321 = phi_521_;
                    let _e322 = (_e299 + _e321);
                    let _e323 = (_e299 - _e321);
                    let _e324 = select(_e309, 0f, _e313);
                    if _e313 {
                        phi_532_ = 38685626000000000000000000f;
                    } else {
                        phi_532_ = (1f / _e309);
                    }
                    let _e327 = phi_532_;
                    let _e328 = (_e257 == 0u);
                    if _e328 {
                        phi_541_ = _e288[0];
                    } else {
                        phi_541_ = _e288[1];
                    }
                    let _e332 = phi_541_;
                    let _e333 = (_e257 == 2u);
                    if _e333 {
                        phi_547_ = _e288[2];
                    } else {
                        phi_547_ = _e332;
                    }
                    let _e336 = phi_547_;
                    let _e338 = ((_e336 * _e265) * _e271);
                    if _e328 {
                        phi_558_ = _e300[0];
                    } else {
                        phi_558_ = _e300[1];
                    }
                    let _e342 = phi_558_;
                    if _e333 {
                        phi_564_ = _e300[2];
                    } else {
                        phi_564_ = _e342;
                    }
                    let _e345 = phi_564_;
                    let _e347 = ((_e345 * _e278) * _e284);
                    let _e351 = (bitcast<f32>((bitcast<u32>(_e347) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e351 {
                        let _e355 = (bitcast<f32>((bitcast<u32>(_e338) & 2147483647u)) * 0.00000011920929f);
                        phi_587_ = select(0.00000000000011368684f, _e355, (_e355 > 0.00000000000011368684f));
                    } else {
                        phi_587_ = 0f;
                    }
                    let _e359 = phi_587_;
                    let _e360 = (_e338 + _e359);
                    let _e361 = (_e338 - _e359);
                    let _e362 = select(_e347, 0f, _e351);
                    if _e351 {
                        phi_598_ = 38685626000000000000000000f;
                    } else {
                        phi_598_ = (1f / _e347);
                    }
                    let _e365 = phi_598_;
                    let _e366 = (_e259 == 0u);
                    if _e366 {
                        phi_607_ = _e288[0];
                    } else {
                        phi_607_ = _e288[1];
                    }
                    let _e370 = phi_607_;
                    let _e371 = (_e259 == 2u);
                    if _e371 {
                        phi_613_ = _e288[2];
                    } else {
                        phi_613_ = _e370;
                    }
                    let _e374 = phi_613_;
                    let _e376 = ((_e374 * _e265) * _e271);
                    if _e366 {
                        phi_624_ = _e300[0];
                    } else {
                        phi_624_ = _e300[1];
                    }
                    let _e380 = phi_624_;
                    if _e371 {
                        phi_630_ = _e300[2];
                    } else {
                        phi_630_ = _e380;
                    }
                    let _e383 = phi_630_;
                    let _e385 = ((_e383 * _e278) * _e284);
                    let _e389 = (bitcast<f32>((bitcast<u32>(_e385) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e389 {
                        let _e393 = (bitcast<f32>((bitcast<u32>(_e376) & 2147483647u)) * 0.00000011920929f);
                        phi_653_ = select(0.00000000000011368684f, _e393, (_e393 > 0.00000000000011368684f));
                    } else {
                        phi_653_ = 0f;
                    }
                    let _e397 = phi_653_;
                    let _e398 = (_e376 + _e397);
                    let _e399 = (_e376 - _e397);
                    let _e400 = select(_e385, 0f, _e389);
                    if _e389 {
                        phi_664_ = 38685626000000000000000000f;
                    } else {
                        phi_664_ = (1f / _e385);
                    }
                    let _e403 = phi_664_;
                    let _e406 = bitcast<f32>((bitcast<u32>(_e299) & 2147483647u));
                    let _e409 = bitcast<f32>((bitcast<u32>(_e338) & 2147483647u));
                    let _e411 = select(_e409, _e406, (_e406 > _e409));
                    let _e414 = bitcast<f32>((bitcast<u32>(_e376) & 2147483647u));
                    let _e417 = (_e126 + _e239);
                    if (_e220 && (select(_e414, _e411, (_e411 > _e414)) <= 1099511600000f)) {
                        let _e420 = (_e417 / 3i);
                        let _e427 = bitcast<f32>((bitcast<u32>((_e420 + 127i)) << bitcast<u32>(23i)));
                        let _e434 = bitcast<f32>((bitcast<u32>(((_e417 - (2i * _e420)) + 127i)) << bitcast<u32>(23i)));
                        let _e435 = (((_e205 * _e427) * _e427) * _e434);
                        let _e437 = select(340282350000000000000000000000000000000f, _e435, (_e435 < 340282350000000000000000000000000000000f));
                        let _e442 = (((_e214 * _e427) * _e427) * _e434);
                        let _e444 = select(340282350000000000000000000000000000000f, _e442, (_e442 < 340282350000000000000000000000000000000f));
                        phi_764_ = select(-340282350000000000000000000000000000000f, _e444, (_e444 > -340282350000000000000000000000000000000f));
                        phi_765_ = select(-340282350000000000000000000000000000000f, _e437, (_e437 > -340282350000000000000000000000000000000f));
                    } else {
                        phi_764_ = 0f;
                        phi_765_ = 1f;
                    }
                    let _e448 = phi_764_;
                    let _e450 = phi_765_;
                    local_3 = array<type_53, 128>(type_53(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_53(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u));
                    local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    let _e455 = (_e258 % 3u);
                    let _e456 = (_e455 < 3u);
                    if _e456 {
                    } else {
                        break;
                    }
                    let _e458 = local_1[_e455];
                    let _e461 = (_e257 % 3u);
                    let _e462 = (_e461 < 3u);
                    if _e462 {
                    } else {
                        break;
                    }
                    let _e464 = local_1[_e461];
                    let _e467 = (_e259 % 3u);
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
                    phi_4510_ = false;
                    phi_1886_ = type_38(type_32(type_24(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e448), 0u, 0u);
                    phi_1889_ = type_53(type_28(vec4<f32>((f32(_e458) * _e138), (f32(_e464) * _e138), (f32(_e470) * _e138), 0f), vec4<f32>((f32(_e475) * _e138), (f32(_e479) * _e138), (f32(_e483) * _e138), 0f)), select(0u, 2147483648u, (_e87 == 0u)));
                    phi_1891_ = ((3u * _e87) + 1u);
                    phi_1893_ = (_e450 <= _e448);
                    phi_1895_ = 0u;
                    loop {
                        let _e493 = phi_4510_;
                        let _e495 = phi_1886_;
                        let _e497 = phi_1889_;
                        let _e499 = phi_1891_;
                        let _e501 = phi_1893_;
                        let _e503 = phi_1895_;
                        local_7 = _e495;
                        local_8 = _e495;
                        if _e501 {
                            phi_1906_ = true;
                        } else {
                            phi_1906_ = (_e503 > 0u);
                        }
                        let _e506 = phi_1906_;
                        if _e506 {
                            let _e507 = (_e499 > 0u);
                            if _e507 {
                                if _e501 {
                                    phi_1943_ = _e497;
                                    phi_1944_ = _e501;
                                    phi_1945_ = _e503;
                                } else {
                                    let _e508 = (_e503 - 1u);
                                    let _e509 = (_e508 % 128u);
                                    let _e510 = (_e509 < 128u);
                                    if _e510 {
                                    } else {
                                        phi_4620_ = true;
                                        break;
                                    }
                                    let _e512 = local_3[_e509];
                                    if _e510 {
                                    } else {
                                        phi_4620_ = true;
                                        break;
                                    }
                                    let _e520 = local_2[_e509];
                                    phi_1943_ = type_53(type_28(_e512.member.member, _e512.member.member_1), _e512.member_1);
                                    phi_1944_ = (_e520 <= _e495.member.member_1);
                                    phi_1945_ = _e508;
                                }
                                let _e525 = phi_1943_;
                                let _e527 = phi_1944_;
                                let _e529 = phi_1945_;
                                if _e527 {
                                    let _e534 = (_e525.member_1 & 268435455u);
                                    if ((_e525.member_1 & 2147483648u) != 0u) {
                                        phi_4507_ = _e493;
                                        phi_1964_ = _e495;
                                        phi_1967_ = type_8(0u, ((_e525.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e1003 = phi_4507_;
                                            let _e1005 = phi_1964_;
                                            let _e1007 = phi_1967_;
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
                                                let _e1032 = type_38(_e1005.member, _e1005.member_1, (_e1005.member_2 + 1u));
                                                let _e1037 = (_e525.member.member_1.x - _e525.member.member.x);
                                                let _e1040 = (_e525.member.member_1.y - _e525.member.member.y);
                                                let _e1043 = (_e525.member.member_1.z - _e525.member.member.z);
                                                let _e1045 = select(_e1040, _e1037, (_e1037 > _e1040));
                                                let _e1047 = select(_e1043, _e1045, (_e1045 > _e1043));
                                                let _e1049 = (_e1047 < (1024f * _e138));
                                                if _e1049 {
                                                    phi_2034_ = 0u;
                                                } else {
                                                    phi_2034_ = select(2u, 1u, (_e1047 < (2097152f * _e138)));
                                                }
                                                let _e1054 = phi_2034_;
                                                switch bitcast<i32>(_e1054) {
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
                                                let _e1057 = phi_2040_;
                                                switch bitcast<i32>(_e1054) {
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
                                                let _e1064 = phi_2050_;
                                                let _e1066 = ((_e534 + (_e1022.member_1 * ((3u * _e1057) + 1u))) + (3u * _e1064));
                                                let _e1067 = (_e1066 < _e90);
                                                if _e1067 {
                                                    if _e1067 {
                                                    } else {
                                                        phi_4561_ = true;
                                                        break;
                                                    }
                                                    let _e1069 = global_5.member[_e1066];
                                                    phi_2066_ = _e1069;
                                                } else {
                                                    phi_2066_ = 4294967295u;
                                                }
                                                let _e1071 = phi_2066_;
                                                local_4 = array<u32, 3>(_e258, _e257, _e259);
                                                if _e1049 {
                                                    phi_2103_ = 0u;
                                                } else {
                                                    phi_2103_ = select(2u, 1u, (_e1047 < (2097152f * _e138)));
                                                }
                                                let _e1077 = phi_2103_;
                                                switch bitcast<i32>(_e1077) {
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
                                                let _e1080 = phi_2109_;
                                                switch bitcast<i32>(_e1077) {
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
                                                let _e1087 = phi_2119_;
                                                local_6 = array<f32, 4>(_e525.member.member.x, _e525.member.member.y, _e525.member.member.z, _e525.member.member.w);
                                                local_5[0u] = array<f32, 3>(0f, 0f, 0f);
                                                local_5[1u] = array<f32, 3>(0f, 0f, 0f);
                                                local_5[2u] = array<f32, 3>(0f, 0f, 0f);
                                                phi_4492_ = _e1003;
                                                phi_2135_ = type_8(0u, 3u);
                                                loop {
                                                    let _e1101 = phi_4492_;
                                                    let _e1103 = phi_2135_;
                                                    if (_e1103.member < _e1103.member_1) {
                                                        phi_2136_ = type_8((_e1103.member + 1u), _e1103.member_1);
                                                        phi_2159_ = type_8(1u, _e1103.member);
                                                    } else {
                                                        phi_2136_ = _e1103;
                                                        phi_2159_ = type_8(0u, type_8().member_1);
                                                    }
                                                    let _e1116 = phi_2136_;
                                                    let _e1118 = phi_2159_;
                                                    let _e1122 = (bitcast<i32>(_e1118.member) != 0i);
                                                    if _e1122 {
                                                        let _e1124 = ((_e534 + (_e1022.member_1 * ((3u * _e1080) + 1u))) + (_e1118.member_1 * _e1087));
                                                        let _e1125 = (_e1124 < _e90);
                                                        if _e1125 {
                                                            if _e1125 {
                                                            } else {
                                                                phi_4559_ = true;
                                                                break;
                                                            }
                                                            let _e1127 = global_5.member[_e1124];
                                                            phi_2182_ = _e1127;
                                                        } else {
                                                            phi_2182_ = 0u;
                                                        }
                                                        let _e1129 = phi_2182_;
                                                        let _e1130 = (_e1124 + 1u);
                                                        let _e1131 = (_e1130 < _e90);
                                                        if _e1131 {
                                                            if _e1131 {
                                                            } else {
                                                                phi_4559_ = true;
                                                                break;
                                                            }
                                                            let _e1133 = global_5.member[_e1130];
                                                            phi_2197_ = _e1133;
                                                        } else {
                                                            phi_2197_ = 0u;
                                                        }
                                                        let _e1135 = phi_2197_;
                                                        phi_2200_ = type_8(0u, 3u);
                                                        loop {
                                                            let _e1137 = phi_2200_;
                                                            if (_e1137.member < _e1137.member_1) {
                                                                phi_2201_ = type_8((_e1137.member + 1u), _e1137.member_1);
                                                                phi_2224_ = type_8(1u, _e1137.member);
                                                            } else {
                                                                phi_2201_ = _e1137;
                                                                phi_2224_ = type_8(0u, type_8().member_1);
                                                            }
                                                            let _e1150 = phi_2201_;
                                                            let _e1152 = phi_2224_;
                                                            let _e1156 = (bitcast<i32>(_e1152.member) != 0i);
                                                            if _e1156 {
                                                                let _e1157 = (_e1152.member_1 < 3u);
                                                                if _e1157 {
                                                                } else {
                                                                    phi_4485_ = true;
                                                                    break;
                                                                }
                                                                let _e1159 = local_4[_e1152.member_1];
                                                                if (_e1152.member_1 < 4u) {
                                                                } else {
                                                                    phi_4485_ = true;
                                                                    break;
                                                                }
                                                                let _e1162 = local_6[_e1152.member_1];
                                                                switch bitcast<i32>(_e1077) {
                                                                    case 0: {
                                                                        phi_2294_ = (_e1162 + (f32(((_e1129 >> bitcast<u32>(((10u * _e1159) & 31u))) & 1023u)) * _e138));
                                                                        break;
                                                                    }
                                                                    case 1: {
                                                                        if (_e1159 == 0u) {
                                                                            phi_2271_ = _e1129;
                                                                        } else {
                                                                            if (_e1159 == 1u) {
                                                                                phi_2270_ = ((_e1129 >> bitcast<u32>(21i)) | (_e1135 << bitcast<u32>(11i)));
                                                                            } else {
                                                                                phi_2270_ = (_e1135 >> bitcast<u32>(10i));
                                                                            }
                                                                            let _e1183 = phi_2270_;
                                                                            phi_2271_ = _e1183;
                                                                        }
                                                                        let _e1185 = phi_2271_;
                                                                        phi_2294_ = (_e1162 + (f32((_e1185 & 2097151u)) * _e138));
                                                                        break;
                                                                    }
                                                                    case 2: {
                                                                        let _e1164 = (_e1124 + _e1159);
                                                                        let _e1165 = (_e1164 < _e90);
                                                                        if _e1165 {
                                                                            if _e1165 {
                                                                            } else {
                                                                                phi_4485_ = true;
                                                                                break;
                                                                            }
                                                                            let _e1167 = global_5.member[_e1164];
                                                                            phi_2290_ = _e1167;
                                                                        } else {
                                                                            phi_2290_ = 0u;
                                                                        }
                                                                        let _e1169 = phi_2290_;
                                                                        phi_2294_ = (f32(bitcast<i32>(_e1169)) * _e138);
                                                                        break;
                                                                    }
                                                                    default: {
                                                                        phi_2294_ = f32();
                                                                        break;
                                                                    }
                                                                }
                                                                let _e1199 = phi_2294_;
                                                                if (_e1118.member_1 < 3u) {
                                                                } else {
                                                                    phi_4485_ = true;
                                                                    break;
                                                                }
                                                                if _e1157 {
                                                                } else {
                                                                    phi_4485_ = true;
                                                                    break;
                                                                }
                                                                local_5[_e1118.member_1][_e1152.member_1] = _e1199;
                                                            }
                                                            continue;
                                                            continuing {
                                                                phi_2200_ = _e1150;
                                                                phi_4485_ = _e1101;
                                                                break if !(_e1156);
                                                            }
                                                        }
                                                        let _e1205 = phi_4485_;
                                                        phi_4559_ = _e1205;
                                                        if _e1205 {
                                                            break;
                                                        }
                                                        phi_4560_ = _e1205;
                                                    } else {
                                                        phi_4560_ = _e1101;
                                                    }
                                                    let _e1207 = phi_4560_;
                                                    continue;
                                                    continuing {
                                                        phi_4492_ = _e1207;
                                                        phi_2135_ = _e1116;
                                                        phi_4559_ = _e1207;
                                                        break if !(_e1122);
                                                    }
                                                }
                                                let _e1210 = phi_4559_;
                                                phi_4561_ = _e1210;
                                                if _e1210 {
                                                    break;
                                                }
                                                let _e1211 = local_5;
                                                let _e1228 = (_e1211[0][2] - _e376);
                                                let _e1231 = (((_e1211[0][0] - _e299) * _e400) - (_e1228 * _e324));
                                                let _e1234 = (((_e1211[0][1] - _e338) * _e400) - (_e1228 * _e362));
                                                let _e1237 = (_e1211[1][2] - _e376);
                                                let _e1240 = (((_e1211[1][0] - _e299) * _e400) - (_e1237 * _e324));
                                                let _e1243 = (((_e1211[1][1] - _e338) * _e400) - (_e1237 * _e362));
                                                let _e1246 = (_e1211[2][2] - _e376);
                                                let _e1249 = (((_e1211[2][0] - _e299) * _e400) - (_e1246 * _e324));
                                                let _e1252 = (((_e1211[2][1] - _e338) * _e400) - (_e1246 * _e362));
                                                let _e1253 = (_e1249 * _e1243);
                                                let _e1254 = (_e1252 * _e1240);
                                                let _e1255 = (_e1231 * _e1252);
                                                let _e1256 = (_e1234 * _e1249);
                                                let _e1257 = (_e1240 * _e1234);
                                                let _e1258 = (_e1243 * _e1231);
                                                let _e1263 = (((_e1253 >= _e1254) && (_e1255 >= _e1256)) && (_e1257 >= _e1258));
                                                if (_e1263 || (((_e1253 <= _e1254) && (_e1255 <= _e1256)) && (_e1257 <= _e1258))) {
                                                    let _e1270 = select(-1f, 1f, _e1263);
                                                    let _e1272 = ((_e1253 - _e1254) * _e1270);
                                                    let _e1274 = select(0f, _e1272, (_e1272 > 0f));
                                                    let _e1276 = ((_e1255 - _e1256) * _e1270);
                                                    let _e1278 = select(0f, _e1276, (_e1276 > 0f));
                                                    let _e1280 = ((_e1257 - _e1258) * _e1270);
                                                    let _e1282 = select(0f, _e1280, (_e1280 > 0f));
                                                    let _e1284 = ((_e1274 + _e1278) + _e1282);
                                                    if (_e1284 < 0.000000000000000000000000000000000000011754944f) {
                                                        phi_2889_ = type_24();
                                                        phi_2890_ = true;
                                                    } else {
                                                        let _e1287 = select(_e1211[1][0], _e1211[0][0], (_e1211[0][0] < _e1211[1][0]));
                                                        let _e1291 = select(_e1211[1][0], _e1211[0][0], (_e1211[0][0] > _e1211[1][0]));
                                                        let _e1295 = select(_e1211[1][1], _e1211[0][1], (_e1211[0][1] < _e1211[1][1]));
                                                        let _e1299 = select(_e1211[1][1], _e1211[0][1], (_e1211[0][1] > _e1211[1][1]));
                                                        let _e1303 = select(_e1211[1][2], _e1211[0][2], (_e1211[0][2] < _e1211[1][2]));
                                                        let _e1307 = select(_e1211[1][2], _e1211[0][2], (_e1211[0][2] > _e1211[1][2]));
                                                        let _e1312 = ((select(_e1211[2][0], _e1287, (_e1287 < _e1211[2][0])) - _e322) * _e327);
                                                        let _e1313 = ((select(_e1211[2][0], _e1291, (_e1291 > _e1211[2][0])) - _e323) * _e327);
                                                        let _e1316 = ((select(_e1211[2][1], _e1295, (_e1295 < _e1211[2][1])) - _e360) * _e365);
                                                        let _e1317 = ((select(_e1211[2][1], _e1299, (_e1299 > _e1211[2][1])) - _e361) * _e365);
                                                        let _e1320 = ((select(_e1211[2][2], _e1303, (_e1303 < _e1211[2][2])) - _e398) * _e403);
                                                        let _e1321 = ((select(_e1211[2][2], _e1307, (_e1307 > _e1211[2][2])) - _e399) * _e403);
                                                        let _e1323 = select(_e1321, _e1320, (_e1320 < _e1321));
                                                        let _e1325 = select(_e1321, _e1320, (_e1320 > _e1321));
                                                        let _e1327 = select(_e1313, _e1312, (_e1312 < _e1313));
                                                        let _e1329 = select(_e1317, _e1316, (_e1316 < _e1317));
                                                        let _e1331 = select(_e1329, _e1327, (_e1327 > _e1329));
                                                        let _e1333 = select(_e1323, _e1331, (_e1331 > _e1323));
                                                        let _e1335 = select(_e1313, _e1312, (_e1312 > _e1313));
                                                        let _e1337 = select(_e1317, _e1316, (_e1316 > _e1317));
                                                        let _e1339 = select(_e1337, _e1335, (_e1335 < _e1337));
                                                        let _e1341 = select(_e1325, _e1339, (_e1339 < _e1325));
                                                        let _e1342 = -(_e1323);
                                                        let _e1348 = select(_e450, _e1333, (_e1333 > _e450));
                                                        if (_e1348 > (_e1341 + (select(_e1342, _e1325, (_e1325 > _e1342)) * 0.0000019073523f))) {
                                                            phi_2884_ = type_24();
                                                            phi_2885_ = true;
                                                        } else {
                                                            let _e1350 = (_e1348 > _e1005.member.member_1);
                                                            if _e1350 {
                                                                phi_2883_ = type_24();
                                                            } else {
                                                                let _e1354 = (_e1211[1][0] - _e1211[0][0]);
                                                                let _e1355 = (_e1211[1][1] - _e1211[0][1]);
                                                                let _e1356 = (_e1211[1][2] - _e1211[0][2]);
                                                                let _e1357 = vec3<f32>(_e1354, _e1355, _e1356);
                                                                let _e1358 = (_e1211[2][0] - _e1211[1][0]);
                                                                let _e1359 = (_e1211[2][1] - _e1211[1][1]);
                                                                let _e1360 = (_e1211[2][2] - _e1211[1][2]);
                                                                let _e1361 = vec3<f32>(_e1358, _e1359, _e1360);
                                                                let _e1362 = (_e1211[0][0] - _e1211[2][0]);
                                                                let _e1363 = (_e1211[0][1] - _e1211[2][1]);
                                                                let _e1364 = (_e1211[0][2] - _e1211[2][2]);
                                                                let _e1365 = vec3<f32>(_e1362, _e1363, _e1364);
                                                                let _e1368 = bitcast<f32>((bitcast<u32>(_e1354) & 2147483647u));
                                                                let _e1371 = bitcast<f32>((bitcast<u32>(_e1355) & 2147483647u));
                                                                let _e1373 = select(_e1371, _e1368, (_e1368 > _e1371));
                                                                let _e1376 = bitcast<f32>((bitcast<u32>(_e1356) & 2147483647u));
                                                                let _e1378 = select(_e1376, _e1373, (_e1373 > _e1376));
                                                                let _e1381 = bitcast<f32>((bitcast<u32>(_e1358) & 2147483647u));
                                                                let _e1384 = bitcast<f32>((bitcast<u32>(_e1359) & 2147483647u));
                                                                let _e1386 = select(_e1384, _e1381, (_e1381 > _e1384));
                                                                let _e1389 = bitcast<f32>((bitcast<u32>(_e1360) & 2147483647u));
                                                                let _e1391 = select(_e1389, _e1386, (_e1386 > _e1389));
                                                                let _e1394 = bitcast<f32>((bitcast<u32>(_e1362) & 2147483647u));
                                                                let _e1397 = bitcast<f32>((bitcast<u32>(_e1363) & 2147483647u));
                                                                let _e1399 = select(_e1397, _e1394, (_e1394 > _e1397));
                                                                let _e1402 = bitcast<f32>((bitcast<u32>(_e1364) & 2147483647u));
                                                                let _e1404 = select(_e1402, _e1399, (_e1399 > _e1402));
                                                                let _e1406 = select(_e1391, _e1378, (_e1378 > _e1391));
                                                                let _e1408 = select(_e1404, _e1406, (_e1406 > _e1404));
                                                                if (_e1378 == _e1408) {
                                                                    phi_2794_ = _e1361;
                                                                    phi_2795_ = _e1365;
                                                                } else {
                                                                    let _e1411 = vec3((_e1391 == _e1408));
                                                                    phi_2794_ = select(_e1357, _e1365, _e1411);
                                                                    phi_2795_ = select(_e1361, _e1357, _e1411);
                                                                }
                                                                let _e1415 = phi_2794_;
                                                                let _e1417 = phi_2795_;
                                                                let _e1424 = ((_e1415.y * _e1417.z) - (_e1417.y * _e1415.z));
                                                                let _e1429 = ((_e1415.z * _e1417.x) - (_e1417.z * _e1415.x));
                                                                let _e1432 = ((_e1415.x * _e1417.y) - (_e1417.x * _e1415.y));
                                                                if (_e1274 >= _e1278) {
                                                                    phi_2826_ = select(true, false, (_e1274 >= _e1282));
                                                                } else {
                                                                    phi_2826_ = true;
                                                                }
                                                                let _e1437 = phi_2826_;
                                                                if _e1437 {
                                                                    phi_2835_ = select(vec3<f32>(_e1211[2][0], _e1211[2][1], _e1211[2][2]), vec3<f32>(_e1211[1][0], _e1211[1][1], _e1211[1][2]), vec3((_e1278 >= _e1282)));
                                                                } else {
                                                                    phi_2835_ = vec3<f32>(_e1211[0][0], _e1211[0][1], _e1211[0][2]);
                                                                }
                                                                let _e1442 = phi_2835_;
                                                                let _e1459 = ((((_e1424 * (_e1442.x - _e299)) + (_e1429 * (_e1442.y - _e338))) + (_e1432 * (_e1442.z - _e376))) / (((_e1424 * _e324) + (_e1429 * _e362)) + (_e1432 * _e400)));
                                                                let _e1461 = select(_e1341, _e1459, (_e1459 < _e1341));
                                                                let _e1463 = select(_e1333, _e1461, (_e1461 > _e1333));
                                                                if (_e1463 >= _e450) {
                                                                    let _e1465 = (_e1463 <= _e1005.member.member_1);
                                                                    if _e1465 {
                                                                        let _e1466 = (1f / _e1284);
                                                                        phi_2875_ = type_24(_e1463, (_e1278 * _e1466), (_e1282 * _e1466), _e1071);
                                                                    } else {
                                                                        phi_2875_ = type_24();
                                                                    }
                                                                    let _e1471 = phi_2875_;
                                                                    phi_2877_ = _e1471;
                                                                    phi_2878_ = select(true, false, _e1465);
                                                                } else {
                                                                    phi_2877_ = type_24();
                                                                    phi_2878_ = true;
                                                                }
                                                                let _e1474 = phi_2877_;
                                                                let _e1476 = phi_2878_;
                                                                if _e1476 {
                                                                    phi_2882_ = type_24(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                } else {
                                                                    phi_2882_ = _e1474;
                                                                }
                                                                let _e1478 = phi_2882_;
                                                                phi_2883_ = _e1478;
                                                            }
                                                            let _e1480 = phi_2883_;
                                                            phi_2884_ = _e1480;
                                                            phi_2885_ = _e1350;
                                                        }
                                                        let _e1482 = phi_2884_;
                                                        let _e1484 = phi_2885_;
                                                        phi_2889_ = _e1482;
                                                        phi_2890_ = _e1484;
                                                    }
                                                    let _e1486 = phi_2889_;
                                                    let _e1488 = phi_2890_;
                                                    phi_2894_ = _e1486;
                                                    phi_2895_ = _e1488;
                                                } else {
                                                    phi_2894_ = type_24();
                                                    phi_2895_ = true;
                                                }
                                                let _e1490 = phi_2894_;
                                                let _e1492 = phi_2895_;
                                                if _e1492 {
                                                    phi_2899_ = type_24(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                } else {
                                                    phi_2899_ = _e1490;
                                                }
                                                let _e1494 = phi_2899_;
                                                if (_e1494.member_3 != 4294967295u) {
                                                    if (_e1071 != 4294967295u) {
                                                        if (_e1494.member < _e1005.member.member.member) {
                                                            phi_2925_ = true;
                                                        } else {
                                                            if (_e1494.member == _e1005.member.member.member) {
                                                                phi_2924_ = (_e1494.member_3 < _e1005.member.member.member_3);
                                                            } else {
                                                                phi_2924_ = false;
                                                            }
                                                            let _e1509 = phi_2924_;
                                                            phi_2925_ = _e1509;
                                                        }
                                                        let _e1511 = phi_2925_;
                                                        if _e1511 {
                                                            phi_2932_ = type_38(type_32(_e1494, _e1494.member), _e1032.member_1, _e1032.member_2);
                                                        } else {
                                                            phi_2932_ = _e1032;
                                                        }
                                                        let _e1518 = phi_2932_;
                                                        phi_2933_ = _e1518;
                                                    } else {
                                                        phi_2933_ = _e1032;
                                                    }
                                                    let _e1520 = phi_2933_;
                                                    phi_2934_ = _e1520;
                                                } else {
                                                    phi_2934_ = _e1032;
                                                }
                                                let _e1522 = phi_2934_;
                                                phi_4562_ = _e1210;
                                                phi_1965_ = _e1522;
                                            } else {
                                                phi_4562_ = _e1003;
                                                phi_1965_ = type_38();
                                            }
                                            let _e1524 = phi_4562_;
                                            let _e1526 = phi_1965_;
                                            continue;
                                            continuing {
                                                phi_4507_ = _e1524;
                                                phi_1964_ = _e1526;
                                                phi_1967_ = _e1020;
                                                phi_4561_ = _e1524;
                                                break if !(_e1026);
                                            }
                                        }
                                        let _e1529 = phi_4561_;
                                        phi_4620_ = _e1529;
                                        if _e1529 {
                                            break;
                                        }
                                        phi_4624_ = _e1529;
                                        let _e1705 = local_9;
                                        phi_4275_ = _e1705;
                                        phi_4276_ = _e525;
                                        phi_4277_ = false;
                                        phi_4278_ = _e529;
                                    } else {
                                        if (_e525.member_1 >= _e87) {
                                            phi_3875_ = type_56(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), type_53(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u), type_53(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u));
                                        } else {
                                            if (_e525.member_1 < _e87) {
                                            } else {
                                                phi_4620_ = true;
                                                break;
                                            }
                                            let _e549 = ((1u + (_e258 * 2u)) % 7u);
                                            if (_e549 < 7u) {
                                            } else {
                                                phi_4620_ = true;
                                                break;
                                            }
                                            let _e554 = global_4.member[_e525.member_1][_e549];
                                            let _e557 = ((1u + (_e257 * 2u)) % 7u);
                                            if (_e557 < 7u) {
                                            } else {
                                                phi_4620_ = true;
                                                break;
                                            }
                                            let _e562 = global_4.member[_e525.member_1][_e557];
                                            let _e565 = ((1u + (_e259 * 2u)) % 7u);
                                            if (_e565 < 7u) {
                                            } else {
                                                phi_4620_ = true;
                                                break;
                                            }
                                            let _e570 = global_4.member[_e525.member_1][_e565];
                                            let _e573 = (((_e258 + 1u) * 2u) % 7u);
                                            if (_e573 < 7u) {
                                            } else {
                                                phi_4620_ = true;
                                                break;
                                            }
                                            let _e578 = global_4.member[_e525.member_1][_e573];
                                            let _e581 = (((_e257 + 1u) * 2u) % 7u);
                                            if (_e581 < 7u) {
                                            } else {
                                                phi_4620_ = true;
                                                break;
                                            }
                                            let _e586 = global_4.member[_e525.member_1][_e581];
                                            let _e589 = (((_e259 + 1u) * 2u) % 7u);
                                            if (_e589 < 7u) {
                                            } else {
                                                phi_4620_ = true;
                                                break;
                                            }
                                            let _e594 = global_4.member[_e525.member_1][_e589];
                                            let _e617 = (bitcast<f32>((bitcast<u32>((_e525.member.member_1.x - _e525.member.member.x)) & 2139095040u)) * 0.0000009536743f);
                                            let _e618 = (bitcast<f32>((bitcast<u32>((_e525.member.member_1.y - _e525.member.member.y)) & 2139095040u)) * 0.0000009536743f);
                                            let _e619 = (bitcast<f32>((bitcast<u32>((_e525.member.member_1.z - _e525.member.member.z)) & 2139095040u)) * 0.0000009536743f);
                                            let _e621 = select(_e138, _e617, (_e617 > _e138));
                                            let _e623 = select(_e138, _e618, (_e618 > _e138));
                                            let _e625 = select(_e138, _e619, (_e619 > _e138));
                                            let _e650 = bitcast<u32>((f32(bitcast<i32>((_e554 & 2097151u))) * _e621));
                                            let _e655 = (bitcast<i32>((_e554 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e658 = bitcast<f32>((_e650 & bitcast<u32>(_e655)));
                                            let _e659 = bitcast<u32>((f32(bitcast<i32>((_e562 & 2097151u))) * _e623));
                                            let _e664 = (bitcast<i32>((_e562 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e667 = bitcast<f32>((_e659 & bitcast<u32>(_e664)));
                                            let _e668 = bitcast<u32>((f32(bitcast<i32>((_e570 & 2097151u))) * _e625));
                                            let _e673 = (bitcast<i32>((_e570 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e676 = bitcast<f32>((_e668 & bitcast<u32>(_e673)));
                                            let _e680 = bitcast<f32>((_e650 & bitcast<u32>(~(_e655))));
                                            let _e684 = bitcast<f32>((_e659 & bitcast<u32>(~(_e664))));
                                            let _e688 = bitcast<f32>((_e668 & bitcast<u32>(~(_e673))));
                                            let _e689 = bitcast<u32>((f32(bitcast<i32>((_e578 & 2097151u))) * _e621));
                                            let _e694 = (bitcast<i32>((_e578 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e697 = bitcast<f32>((_e689 & bitcast<u32>(_e694)));
                                            let _e698 = bitcast<u32>((f32(bitcast<i32>((_e586 & 2097151u))) * _e623));
                                            let _e703 = (bitcast<i32>((_e586 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e706 = bitcast<f32>((_e698 & bitcast<u32>(_e703)));
                                            let _e707 = bitcast<u32>((f32(bitcast<i32>((_e594 & 2097151u))) * _e625));
                                            let _e712 = (bitcast<i32>((_e594 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e715 = bitcast<f32>((_e707 & bitcast<u32>(_e712)));
                                            let _e719 = bitcast<f32>((_e689 & bitcast<u32>(~(_e694))));
                                            let _e723 = bitcast<f32>((_e698 & bitcast<u32>(~(_e703))));
                                            let _e727 = bitcast<f32>((_e707 & bitcast<u32>(~(_e712))));
                                            let _e728 = (_e525.member.member.x + _e658);
                                            let _e729 = (_e525.member.member.y + _e667);
                                            let _e730 = (_e525.member.member.z + _e676);
                                            let _e733 = (_e525.member.member_1.x - _e697);
                                            let _e734 = (_e525.member.member_1.y - _e706);
                                            let _e735 = (_e525.member.member_1.z - _e715);
                                            let _e754 = (_e733 - _e728);
                                            let _e755 = (_e734 - _e729);
                                            let _e756 = (_e735 - _e730);
                                            let _e758 = select(_e755, _e754, (_e754 > _e755));
                                            let _e760 = select(_e756, _e758, (_e758 > _e756));
                                            if (_e760 < (1024f * _e138)) {
                                                phi_3576_ = 0u;
                                            } else {
                                                phi_3576_ = select(2u, 1u, (_e760 < (2097152f * _e138)));
                                            }
                                            let _e767 = phi_3576_;
                                            switch bitcast<i32>(_e767) {
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
                                            let _e770 = phi_3582_;
                                            let _e776 = global_4.member[_e525.member_1][0u];
                                            let _e780 = global_4.member[_e525.member_1][2u];
                                            let _e784 = global_4.member[_e525.member_1][4u];
                                            let _e788 = global_4.member[_e525.member_1][6u];
                                            let _e800 = (((_e780 >> bitcast<u32>(22i)) | ((_e784 >> bitcast<u32>(22i)) << bitcast<u32>(10i))) | ((_e788 >> bitcast<u32>(22i)) << bitcast<u32>(20i)));
                                            let _e801 = (_e776 & 268435455u);
                                            let _e802 = (_e800 & 268435455u);
                                            let _e805 = ((_e776 >> bitcast<u32>(28u)) & 7u);
                                            let _e813 = ((_e776 >> bitcast<u32>(31i)) | (((_e800 >> bitcast<u32>(28u)) & 3u) << bitcast<u32>(1i)));
                                            let _e814 = (_e805 != 0u);
                                            if (_e805 == 0u) {
                                                phi_3837_ = _e801;
                                            } else {
                                                if (_e805 == 7u) {
                                                    phi_3836_ = 2147483648u;
                                                } else {
                                                    phi_3836_ = ((2147483648u | (_e805 << bitcast<u32>(28u))) | (_e802 & 268435455u));
                                                }
                                                let _e823 = phi_3836_;
                                                phi_3837_ = _e823;
                                            }
                                            let _e825 = phi_3837_;
                                            if _e814 {
                                                let _e826 = (_e805 != 7u);
                                                if _e826 {
                                                    phi_3847_ = (_e802 + (_e805 * ((3u * _e770) + 1u)));
                                                } else {
                                                    phi_3847_ = u32();
                                                }
                                                let _e830 = phi_3847_;
                                                phi_3849_ = _e830;
                                                phi_3850_ = select(true, false, _e826);
                                            } else {
                                                phi_3849_ = u32();
                                                phi_3850_ = true;
                                            }
                                            let _e833 = phi_3849_;
                                            let _e835 = phi_3850_;
                                            if (_e813 == 0u) {
                                                phi_3871_ = (_e801 + select(0u, 1u, !(_e814)));
                                            } else {
                                                if (_e813 == 7u) {
                                                    phi_3870_ = 2147483648u;
                                                } else {
                                                    phi_3870_ = ((2147483648u | (_e813 << bitcast<u32>(28u))) | (select(_e833, _e802, _e835) & 268435455u));
                                                }
                                                let _e848 = phi_3870_;
                                                phi_3871_ = _e848;
                                            }
                                            let _e850 = phi_3871_;
                                            phi_3875_ = type_56(array<vec4<f32>, 3>(vec4<f32>(_e728, (_e525.member.member.x + _e680), _e733, (_e525.member.member_1.x - _e719)), vec4<f32>(_e729, (_e525.member.member.y + _e684), _e734, (_e525.member.member_1.y - _e723)), vec4<f32>(_e730, (_e525.member.member.z + _e688), _e735, (_e525.member.member_1.z - _e727))), type_53(type_28((_e525.member.member + vec4<f32>(_e658, _e667, _e676, 0f)), (_e525.member.member_1 - vec4<f32>(_e697, _e706, _e715, 0f))), _e825), type_53(type_28((_e525.member.member + vec4<f32>(_e680, _e684, _e688, 0f)), (_e525.member.member_1 - vec4<f32>(_e719, _e723, _e727, 0f))), _e850));
                                        }
                                        let _e855 = phi_3875_;
                                        let _e868 = ((_e855.member[0].x - _e322) * _e327);
                                        let _e869 = ((_e855.member[0].y - _e322) * _e327);
                                        let _e870 = ((_e855.member[0].z - _e323) * _e327);
                                        let _e871 = ((_e855.member[0].w - _e323) * _e327);
                                        let _e881 = ((_e855.member[1].x - _e360) * _e365);
                                        let _e882 = ((_e855.member[1].y - _e360) * _e365);
                                        let _e883 = ((_e855.member[1].z - _e361) * _e365);
                                        let _e884 = ((_e855.member[1].w - _e361) * _e365);
                                        let _e894 = ((_e855.member[2].x - _e398) * _e403);
                                        let _e895 = ((_e855.member[2].y - _e398) * _e403);
                                        let _e896 = ((_e855.member[2].z - _e399) * _e403);
                                        let _e897 = ((_e855.member[2].w - _e399) * _e403);
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
                                        let _e949 = select(_e450, _e919, (_e919 > _e450));
                                        let _e951 = select(_e450, _e921, (_e921 > _e450));
                                        let _e956 = (_e949 <= select(_e495.member.member_1, _e946, (_e946 < _e495.member.member_1)));
                                        let _e957 = (_e951 <= select(_e495.member.member_1, _e947, (_e947 < _e495.member.member_1)));
                                        let _e958 = (_e949 <= _e951);
                                        if _e956 {
                                            if _e957 {
                                                if _e958 {
                                                    phi_4219_ = _e855.member_2;
                                                } else {
                                                    phi_4219_ = _e855.member_1;
                                                }
                                                let _e962 = phi_4219_;
                                                let _e963 = (_e529 % 128u);
                                                let _e964 = (_e963 < 128u);
                                                if _e964 {
                                                } else {
                                                    phi_4620_ = true;
                                                    break;
                                                }
                                                local_3[_e963] = type_53(type_28(_e962.member.member, _e962.member.member_1), _e962.member_1);
                                                if _e964 {
                                                } else {
                                                    phi_4620_ = true;
                                                    break;
                                                }
                                                local_2[_e963] = select(_e951, _e949, (_e949 > _e951));
                                                if _e958 {
                                                    phi_4252_ = _e855.member_1;
                                                } else {
                                                    phi_4252_ = _e855.member_2;
                                                }
                                                let _e979 = phi_4252_;
                                                phi_4253_ = _e979;
                                                phi_4254_ = (_e529 + 1u);
                                            } else {
                                                phi_4253_ = type_53();
                                                phi_4254_ = u32();
                                            }
                                            let _e981 = phi_4253_;
                                            let _e983 = phi_4254_;
                                            phi_4256_ = _e981;
                                            phi_4257_ = _e983;
                                            phi_4258_ = select(true, false, _e957);
                                        } else {
                                            phi_4256_ = type_53();
                                            phi_4257_ = u32();
                                            phi_4258_ = true;
                                        }
                                        let _e986 = phi_4256_;
                                        let _e988 = phi_4257_;
                                        let _e990 = phi_4258_;
                                        if _e990 {
                                            if _e956 {
                                                phi_4267_ = _e855.member_1;
                                            } else {
                                                phi_4267_ = _e855.member_2;
                                            }
                                            let _e994 = phi_4267_;
                                            phi_4272_ = _e994;
                                            phi_4273_ = select(_e957, true, _e956);
                                        } else {
                                            phi_4272_ = _e986;
                                            phi_4273_ = _e527;
                                        }
                                        let _e997 = phi_4272_;
                                        let _e999 = phi_4273_;
                                        phi_4624_ = _e493;
                                        phi_4275_ = type_38(_e495.member, (_e495.member_1 + 1u), _e495.member_2);
                                        phi_4276_ = _e997;
                                        phi_4277_ = _e999;
                                        phi_4278_ = select(_e988, _e529, _e990);
                                    }
                                    let _e1531 = phi_4624_;
                                    let _e1533 = phi_4275_;
                                    let _e1535 = phi_4276_;
                                    let _e1537 = phi_4277_;
                                    let _e1539 = phi_4278_;
                                    phi_4623_ = _e1531;
                                    phi_4279_ = _e1533;
                                    phi_4280_ = _e1535;
                                    phi_4281_ = (_e499 - 1u);
                                    phi_4282_ = _e1537;
                                    phi_4283_ = _e1539;
                                } else {
                                    phi_4623_ = _e493;
                                    phi_4279_ = _e495;
                                    phi_4280_ = _e525;
                                    phi_4281_ = _e499;
                                    phi_4282_ = _e527;
                                    phi_4283_ = _e529;
                                }
                                let _e1541 = phi_4623_;
                                let _e1543 = phi_4279_;
                                let _e1545 = phi_4280_;
                                let _e1547 = phi_4281_;
                                let _e1549 = phi_4282_;
                                let _e1551 = phi_4283_;
                                phi_4622_ = _e1541;
                                phi_4284_ = _e1543;
                                phi_4285_ = _e1545;
                                phi_4286_ = _e1547;
                                phi_4287_ = _e1549;
                                phi_4288_ = _e1551;
                            } else {
                                phi_4622_ = _e493;
                                phi_4284_ = type_38();
                                phi_4285_ = type_53();
                                phi_4286_ = u32();
                                phi_4287_ = bool();
                                phi_4288_ = u32();
                            }
                            let _e1553 = phi_4622_;
                            let _e1555 = phi_4284_;
                            let _e1557 = phi_4285_;
                            let _e1559 = phi_4286_;
                            let _e1561 = phi_4287_;
                            let _e1563 = phi_4288_;
                            phi_4621_ = _e1553;
                            phi_1887_ = _e1555;
                            phi_1890_ = _e1557;
                            phi_1892_ = _e1559;
                            phi_1894_ = _e1561;
                            phi_1896_ = _e1563;
                            phi_4289_ = _e507;
                        } else {
                            phi_4621_ = _e493;
                            phi_1887_ = type_38();
                            phi_1890_ = type_53();
                            phi_1892_ = u32();
                            phi_1894_ = bool();
                            phi_1896_ = u32();
                            phi_4289_ = false;
                        }
                        let _e1565 = phi_4621_;
                        let _e1567 = phi_1887_;
                        let _e1569 = phi_1890_;
                        let _e1571 = phi_1892_;
                        let _e1573 = phi_1894_;
                        let _e1575 = phi_1896_;
                        let _e1577 = phi_4289_;
                        continue;
                        continuing {
                            phi_4510_ = _e1565;
                            phi_1886_ = _e1567;
                            phi_1889_ = _e1569;
                            phi_1891_ = _e1571;
                            phi_1893_ = _e1573;
                            phi_1895_ = _e1575;
                            phi_4620_ = _e1565;
                            break if !(_e1577);
                        }
                    }
                    let _e1580 = phi_4620_;
                    if _e1580 {
                        break;
                    }
                    let _e1582 = local_7;
                    let _e1585 = local_8;
                    if _e146 {
                    } else {
                        break;
                    }
                    global_6.member[_e144][0u] = _e1582.member_1;
                    global_6.member[_e144][1u] = _e1585.member_2;
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
