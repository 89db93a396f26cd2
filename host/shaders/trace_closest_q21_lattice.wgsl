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
    var phi_1884_: type_32;
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
    var phi_1962_: type_32;
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
    var phi_2870_: type_20;
    var phi_2872_: type_20;
    var phi_2873_: bool;
    var phi_2877_: type_20;
    var phi_2878_: type_20;
    var phi_2879_: type_20;
    var phi_2880_: bool;
    var phi_2884_: type_20;
    var phi_2885_: bool;
    var phi_2889_: type_20;
    var phi_2890_: bool;
    var phi_2894_: type_20;
    var phi_2919_: bool;
    var phi_2920_: bool;
    var phi_2926_: type_32;
    var phi_2927_: type_32;
    var phi_2928_: type_32;
    var phi_4597_: bool;
    var phi_1963_: type_32;
    var phi_4596_: bool;
    var phi_4659_: bool;
    var phi_4266_: type_32;
    var phi_4267_: type_52;
    var phi_4268_: bool;
    var phi_4269_: u32;
    var phi_4658_: bool;
    var phi_4270_: type_32;
    var phi_4271_: type_52;
    var phi_4272_: u32;
    var phi_4273_: bool;
    var phi_4274_: u32;
    var phi_4657_: bool;
    var phi_4275_: type_32;
    var phi_4276_: type_52;
    var phi_4277_: u32;
    var phi_4278_: bool;
    var phi_4279_: u32;
    var phi_4656_: bool;
    var phi_1885_: type_32;
    var phi_1888_: type_52;
    var phi_1890_: u32;
    var phi_1892_: bool;
    var phi_1894_: u32;
    var phi_4280_: bool;
    var phi_4655_: bool;
    var local_7: type_32;
    var phi_4332_: type_20;
    var local_8: type_32;

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
                            phi_400_ = (bitcast<i32>((_e223 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_400_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e223)), 32u, (_e223 == 0u))));
                        }
                        let _e237 = phi_400_;
                        phi_401_ = _e237;
                    } else {
                        phi_401_ = 0i;
                    }
                    let _e239 = phi_401_;
                    let _e240 = (_e156 == _e195);
                    if _e240 {
                        phi_411_ = true;
                    } else {
                        phi_411_ = (_e163 == _e195);
                    }
                    let _e243 = phi_411_;
                    let _e244 = select(1u, 0u, _e240);
                    if _e243 {
                        let _e245 = (_e244 + 1u);
                        phi_421_ = _e245;
                        phi_422_ = _e245;
                        phi_424_ = select(true, false, (_e245 == 2u));
                    } else {
                        phi_421_ = u32();
                        phi_422_ = 0u;
                        phi_424_ = true;
                    }
                    let _e249 = phi_421_;
                    let _e251 = phi_422_;
                    let _e253 = phi_424_;
                    if _e253 {
                        phi_429_ = (_e251 + 1u);
                    } else {
                        phi_429_ = 0u;
                    }
                    let _e257 = phi_429_;
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
                        phi_474_ = _e288[0];
                    } else {
                        phi_474_ = _e288[1];
                    }
                    let _e293 = phi_474_;
                    let _e294 = (_e258 == 2u);
                    if _e294 {
                        phi_480_ = _e288[2];
                    } else {
                        phi_480_ = _e293;
                    }
                    let _e297 = phi_480_;
                    let _e299 = ((_e297 * _e265) * _e271);
                    let _e300 = global_3.member[_e144].member_2;
                    if _e289 {
                        phi_491_ = _e300[0];
                    } else {
                        phi_491_ = _e300[1];
                    }
                    let _e304 = phi_491_;
                    if _e294 {
                        phi_497_ = _e300[2];
                    } else {
                        phi_497_ = _e304;
                    }
                    let _e307 = phi_497_;
                    let _e309 = ((_e307 * _e278) * _e284);
                    let _e313 = (bitcast<f32>((bitcast<u32>(_e309) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e313 {
                        let _e317 = (bitcast<f32>((bitcast<u32>(_e299) & 2147483647u)) * 0.00000011920929f);
                        phi_520_ = select(0.00000000000011368684f, _e317, (_e317 > 0.00000000000011368684f));
                    } else {
                        phi_520_ = 0f;
                    }
                    let _e321 = phi_520_;
                    let _e322 = (_e299 + _e321);
                    let _e323 = (_e299 - _e321);
                    let _e324 = select(_e309, 0f, _e313);
                    if _e313 {
                        phi_531_ = 38685626000000000000000000f;
                    } else {
                        phi_531_ = (1f / _e309);
                    }
                    let _e327 = phi_531_;
                    let _e328 = (_e257 == 0u);
                    if _e328 {
                        phi_540_ = _e288[0];
                    } else {
                        phi_540_ = _e288[1];
                    }
                    let _e332 = phi_540_;
                    let _e333 = (_e257 == 2u);
                    if _e333 {
                        phi_546_ = _e288[2];
                    } else {
                        phi_546_ = _e332;
                    }
                    let _e336 = phi_546_;
                    let _e338 = ((_e336 * _e265) * _e271);
                    if _e328 {
                        phi_557_ = _e300[0];
                    } else {
                        phi_557_ = _e300[1];
                    }
                    let _e342 = phi_557_;
                    if _e333 {
                        phi_563_ = _e300[2];
                    } else {
                        phi_563_ = _e342;
                    }
                    let _e345 = phi_563_;
                    let _e347 = ((_e345 * _e278) * _e284);
                    let _e351 = (bitcast<f32>((bitcast<u32>(_e347) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e351 {
                        let _e355 = (bitcast<f32>((bitcast<u32>(_e338) & 2147483647u)) * 0.00000011920929f);
                        phi_586_ = select(0.00000000000011368684f, _e355, (_e355 > 0.00000000000011368684f));
                    } else {
                        phi_586_ = 0f;
                    }
                    let _e359 = phi_586_;
                    let _e360 = (_e338 + _e359);
                    let _e361 = (_e338 - _e359);
                    let _e362 = select(_e347, 0f, _e351);
                    if _e351 {
                        phi_597_ = 38685626000000000000000000f;
                    } else {
                        phi_597_ = (1f / _e347);
                    }
                    let _e365 = phi_597_;
                    let _e366 = (_e259 == 0u);
                    if _e366 {
                        phi_606_ = _e288[0];
                    } else {
                        phi_606_ = _e288[1];
                    }
                    let _e370 = phi_606_;
                    let _e371 = (_e259 == 2u);
                    if _e371 {
                        phi_612_ = _e288[2];
                    } else {
                        phi_612_ = _e370;
                    }
                    let _e374 = phi_612_;
                    let _e376 = ((_e374 * _e265) * _e271);
                    if _e366 {
                        phi_623_ = _e300[0];
                    } else {
                        phi_623_ = _e300[1];
                    }
                    let _e380 = phi_623_;
                    if _e371 {
                        phi_629_ = _e300[2];
                    } else {
                        phi_629_ = _e380;
                    }
                    let _e383 = phi_629_;
                    let _e385 = ((_e383 * _e278) * _e284);
                    let _e389 = (bitcast<f32>((bitcast<u32>(_e385) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e389 {
                        let _e393 = (bitcast<f32>((bitcast<u32>(_e376) & 2147483647u)) * 0.00000011920929f);
                        phi_652_ = select(0.00000000000011368684f, _e393, (_e393 > 0.00000000000011368684f));
                    } else {
                        phi_652_ = 0f;
                    }
                    let _e397 = phi_652_;
                    let _e398 = (_e376 + _e397);
                    let _e399 = (_e376 - _e397);
                    let _e400 = select(_e385, 0f, _e389);
                    if _e389 {
                        phi_663_ = 38685626000000000000000000f;
                    } else {
                        phi_663_ = (1f / _e385);
                    }
                    let _e403 = phi_663_;
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
                        phi_763_ = select(-340282350000000000000000000000000000000f, _e444, (_e444 > -340282350000000000000000000000000000000f));
                        phi_764_ = select(-340282350000000000000000000000000000000f, _e437, (_e437 > -340282350000000000000000000000000000000f));
                    } else {
                        phi_763_ = 0f;
                        phi_764_ = 1f;
                    }
                    let _e448 = phi_763_;
                    let _e450 = phi_764_;
                    local_3 = array<type_52, 128>(type_52(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u));
                    local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    let _e454 = (_e258 % 3u);
                    let _e455 = (_e454 < 3u);
                    if _e455 {
                    } else {
                        break;
                    }
                    let _e457 = local_1[_e454];
                    let _e460 = (_e257 % 3u);
                    let _e461 = (_e460 < 3u);
                    if _e461 {
                    } else {
                        break;
                    }
                    let _e463 = local_1[_e460];
                    let _e466 = (_e259 % 3u);
                    let _e467 = (_e466 < 3u);
                    if _e467 {
                    } else {
                        break;
                    }
                    let _e469 = local_1[_e466];
                    if _e455 {
                    } else {
                        break;
                    }
                    let _e474 = local[_e454];
                    if _e461 {
                    } else {
                        break;
                    }
                    let _e478 = local[_e460];
                    if _e467 {
                    } else {
                        break;
                    }
                    let _e482 = local[_e466];
                    phi_4545_ = false;
                    phi_1884_ = type_32(type_20(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e448);
                    phi_1887_ = type_52(type_28(vec4<f32>((f32(_e457) * _e138), (f32(_e463) * _e138), (f32(_e469) * _e138), 0f), vec4<f32>((f32(_e474) * _e138), (f32(_e478) * _e138), (f32(_e482) * _e138), 0f)), select(0u, 2147483648u, (_e87 == 0u)));
                    phi_1889_ = ((3u * _e87) + 1u);
                    phi_1891_ = (_e450 <= _e448);
                    phi_1893_ = 0u;
                    loop {
                        let _e492 = phi_4545_;
                        let _e494 = phi_1884_;
                        let _e496 = phi_1887_;
                        let _e498 = phi_1889_;
                        let _e500 = phi_1891_;
                        let _e502 = phi_1893_;
                        local_7 = _e494;
                        if _e500 {
                            phi_1904_ = true;
                        } else {
                            phi_1904_ = (_e502 > 0u);
                        }
                        let _e505 = phi_1904_;
                        if _e505 {
                            let _e506 = (_e498 > 0u);
                            if _e506 {
                                if _e500 {
                                    phi_1941_ = _e496;
                                    phi_1942_ = _e500;
                                    phi_1943_ = _e502;
                                } else {
                                    let _e507 = (_e502 - 1u);
                                    let _e508 = (_e507 % 128u);
                                    let _e509 = (_e508 < 128u);
                                    if _e509 {
                                    } else {
                                        phi_4655_ = true;
                                        break;
                                    }
                                    let _e511 = local_3[_e508];
                                    if _e509 {
                                    } else {
                                        phi_4655_ = true;
                                        break;
                                    }
                                    let _e519 = local_2[_e508];
                                    phi_1941_ = type_52(type_28(_e511.member.member, _e511.member.member_1), _e511.member_1);
                                    phi_1942_ = (_e519 <= _e494.member_1);
                                    phi_1943_ = _e507;
                                }
                                let _e523 = phi_1941_;
                                let _e525 = phi_1942_;
                                let _e527 = phi_1943_;
                                if _e525 {
                                    let _e532 = (_e523.member_1 & 268435455u);
                                    if ((_e523.member_1 & 2147483648u) != 0u) {
                                        phi_4542_ = _e492;
                                        phi_1962_ = _e494;
                                        phi_1965_ = type_8(0u, ((_e523.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e994 = phi_4542_;
                                            let _e996 = phi_1962_;
                                            let _e998 = phi_1965_;
                                            local_8 = _e996;
                                            if (_e998.member < _e998.member_1) {
                                                phi_1966_ = type_8((_e998.member + 1u), _e998.member_1);
                                                phi_1988_ = type_8(1u, _e998.member);
                                            } else {
                                                phi_1966_ = _e998;
                                                phi_1988_ = type_8(0u, type_8().member_1);
                                            }
                                            let _e1011 = phi_1966_;
                                            let _e1013 = phi_1988_;
                                            let _e1017 = (bitcast<i32>(_e1013.member) != 0i);
                                            if _e1017 {
                                                let _e1022 = (_e523.member.member_1.x - _e523.member.member.x);
                                                let _e1025 = (_e523.member.member_1.y - _e523.member.member.y);
                                                let _e1028 = (_e523.member.member_1.z - _e523.member.member.z);
                                                let _e1030 = select(_e1025, _e1022, (_e1022 > _e1025));
                                                let _e1032 = select(_e1028, _e1030, (_e1030 > _e1028));
                                                let _e1034 = (_e1032 < (1024f * _e138));
                                                if _e1034 {
                                                    phi_2029_ = 0u;
                                                } else {
                                                    phi_2029_ = select(2u, 1u, (_e1032 < (2097152f * _e138)));
                                                }
                                                let _e1039 = phi_2029_;
                                                switch bitcast<i32>(_e1039) {
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
                                                let _e1042 = phi_2035_;
                                                switch bitcast<i32>(_e1039) {
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
                                                let _e1049 = phi_2045_;
                                                let _e1051 = ((_e532 + (_e1013.member_1 * ((3u * _e1042) + 1u))) + (3u * _e1049));
                                                let _e1052 = (_e1051 < _e90);
                                                if _e1052 {
                                                    if _e1052 {
                                                    } else {
                                                        phi_4596_ = true;
                                                        break;
                                                    }
                                                    let _e1054 = global_5.member[_e1051];
                                                    phi_2061_ = _e1054;
                                                } else {
                                                    phi_2061_ = 4294967295u;
                                                }
                                                let _e1056 = phi_2061_;
                                                local_4 = array<u32, 3>(_e258, _e257, _e259);
                                                if _e1034 {
                                                    phi_2098_ = 0u;
                                                } else {
                                                    phi_2098_ = select(2u, 1u, (_e1032 < (2097152f * _e138)));
                                                }
                                                let _e1062 = phi_2098_;
                                                switch bitcast<i32>(_e1062) {
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
                                                let _e1065 = phi_2104_;
                                                switch bitcast<i32>(_e1062) {
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
                                                let _e1072 = phi_2114_;
                                                local_6 = array<f32, 4>(_e523.member.member.x, _e523.member.member.y, _e523.member.member.z, _e523.member.member.w);
                                                local_5[0u] = array<f32, 3>(0f, 0f, 0f);
                                                local_5[1u] = array<f32, 3>(0f, 0f, 0f);
                                                local_5[2u] = array<f32, 3>(0f, 0f, 0f);
                                                phi_4527_ = _e994;
                                                phi_2130_ = type_8(0u, 3u);
                                                loop {
                                                    let _e1086 = phi_4527_;
                                                    let _e1088 = phi_2130_;
                                                    if (_e1088.member < _e1088.member_1) {
                                                        phi_2131_ = type_8((_e1088.member + 1u), _e1088.member_1);
                                                        phi_2154_ = type_8(1u, _e1088.member);
                                                    } else {
                                                        phi_2131_ = _e1088;
                                                        phi_2154_ = type_8(0u, type_8().member_1);
                                                    }
                                                    let _e1101 = phi_2131_;
                                                    let _e1103 = phi_2154_;
                                                    let _e1107 = (bitcast<i32>(_e1103.member) != 0i);
                                                    if _e1107 {
                                                        let _e1109 = ((_e532 + (_e1013.member_1 * ((3u * _e1065) + 1u))) + (_e1103.member_1 * _e1072));
                                                        let _e1110 = (_e1109 < _e90);
                                                        if _e1110 {
                                                            if _e1110 {
                                                            } else {
                                                                phi_4594_ = true;
                                                                break;
                                                            }
                                                            let _e1112 = global_5.member[_e1109];
                                                            phi_2177_ = _e1112;
                                                        } else {
                                                            phi_2177_ = 0u;
                                                        }
                                                        let _e1114 = phi_2177_;
                                                        let _e1115 = (_e1109 + 1u);
                                                        let _e1116 = (_e1115 < _e90);
                                                        if _e1116 {
                                                            if _e1116 {
                                                            } else {
                                                                phi_4594_ = true;
                                                                break;
                                                            }
                                                            let _e1118 = global_5.member[_e1115];
                                                            phi_2192_ = _e1118;
                                                        } else {
                                                            phi_2192_ = 0u;
                                                        }
                                                        let _e1120 = phi_2192_;
                                                        phi_2195_ = type_8(0u, 3u);
                                                        loop {
                                                            let _e1122 = phi_2195_;
                                                            if (_e1122.member < _e1122.member_1) {
                                                                phi_2196_ = type_8((_e1122.member + 1u), _e1122.member_1);
                                                                phi_2219_ = type_8(1u, _e1122.member);
                                                            } else {
                                                                phi_2196_ = _e1122;
                                                                phi_2219_ = type_8(0u, type_8().member_1);
                                                            }
                                                            let _e1135 = phi_2196_;
                                                            let _e1137 = phi_2219_;
                                                            let _e1141 = (bitcast<i32>(_e1137.member) != 0i);
                                                            if _e1141 {
                                                                let _e1142 = (_e1137.member_1 < 3u);
                                                                if _e1142 {
                                                                } else {
                                                                    phi_4520_ = true;
                                                                    break;
                                                                }
                                                                let _e1144 = local_4[_e1137.member_1];
                                                                if (_e1137.member_1 < 4u) {
                                                                } else {
                                                                    phi_4520_ = true;
                                                                    break;
                                                                }
                                                                let _e1147 = local_6[_e1137.member_1];
                                                                switch bitcast<i32>(_e1062) {
                                                                    case 0: {
                                                                        phi_2289_ = (_e1147 + (f32(((_e1114 >> bitcast<u32>(((10u * _e1144) & 31u))) & 1023u)) * _e138));
                                                                        break;
                                                                    }
                                                                    case 1: {
                                                                        if (_e1144 == 0u) {
                                                                            phi_2266_ = _e1114;
                                                                        } else {
                                                                            if (_e1144 == 1u) {
                                                                                phi_2265_ = ((_e1114 >> bitcast<u32>(21i)) | (_e1120 << bitcast<u32>(11i)));
                                                                            } else {
                                                                                phi_2265_ = (_e1120 >> bitcast<u32>(10i));
                                                                            }
                                                                            let _e1168 = phi_2265_;
                                                                            phi_2266_ = _e1168;
                                                                        }
                                                                        let _e1170 = phi_2266_;
                                                                        phi_2289_ = (_e1147 + (f32((_e1170 & 2097151u)) * _e138));
                                                                        break;
                                                                    }
                                                                    case 2: {
                                                                        let _e1149 = (_e1109 + _e1144);
                                                                        let _e1150 = (_e1149 < _e90);
                                                                        if _e1150 {
                                                                            if _e1150 {
                                                                            } else {
                                                                                phi_4520_ = true;
                                                                                break;
                                                                            }
                                                                            let _e1152 = global_5.member[_e1149];
                                                                            phi_2285_ = _e1152;
                                                                        } else {
                                                                            phi_2285_ = 0u;
                                                                        }
                                                                        let _e1154 = phi_2285_;
                                                                        phi_2289_ = (f32(bitcast<i32>(_e1154)) * _e138);
                                                                        break;
                                                                    }
                                                                    default: {
                                                                        phi_2289_ = f32();
                                                                        break;
                                                                    }
                                                                }
                                                                let _e1184 = phi_2289_;
                                                                if (_e1103.member_1 < 3u) {
                                                                } else {
                                                                    phi_4520_ = true;
                                                                    break;
                                                                }
                                                                if _e1142 {
                                                                } else {
                                                                    phi_4520_ = true;
                                                                    break;
                                                                }
                                                                local_5[_e1103.member_1][_e1137.member_1] = _e1184;
                                                            }
                                                            continue;
                                                            continuing {
                                                                phi_2195_ = _e1135;
                                                                phi_4520_ = _e1086;
                                                                break if !(_e1141);
                                                            }
                                                        }
                                                        let _e1190 = phi_4520_;
                                                        phi_4594_ = _e1190;
                                                        if _e1190 {
                                                            break;
                                                        }
                                                        phi_4595_ = _e1190;
                                                    } else {
                                                        phi_4595_ = _e1086;
                                                    }
                                                    let _e1192 = phi_4595_;
                                                    continue;
                                                    continuing {
                                                        phi_4527_ = _e1192;
                                                        phi_2130_ = _e1101;
                                                        phi_4594_ = _e1192;
                                                        break if !(_e1107);
                                                    }
                                                }
                                                let _e1195 = phi_4594_;
                                                phi_4596_ = _e1195;
                                                if _e1195 {
                                                    break;
                                                }
                                                let _e1196 = local_5;
                                                let _e1212 = (_e1196[0][2] - _e376);
                                                let _e1215 = (((_e1196[0][0] - _e299) * _e400) - (_e1212 * _e324));
                                                let _e1218 = (((_e1196[0][1] - _e338) * _e400) - (_e1212 * _e362));
                                                let _e1221 = (_e1196[1][2] - _e376);
                                                let _e1224 = (((_e1196[1][0] - _e299) * _e400) - (_e1221 * _e324));
                                                let _e1227 = (((_e1196[1][1] - _e338) * _e400) - (_e1221 * _e362));
                                                let _e1230 = (_e1196[2][2] - _e376);
                                                let _e1233 = (((_e1196[2][0] - _e299) * _e400) - (_e1230 * _e324));
                                                let _e1236 = (((_e1196[2][1] - _e338) * _e400) - (_e1230 * _e362));
                                                let _e1237 = (_e1233 * _e1227);
                                                let _e1238 = (_e1236 * _e1224);
                                                let _e1239 = (_e1215 * _e1236);
                                                let _e1240 = (_e1218 * _e1233);
                                                let _e1241 = (_e1224 * _e1218);
                                                let _e1242 = (_e1227 * _e1215);
                                                let _e1247 = (((_e1237 >= _e1238) && (_e1239 >= _e1240)) && (_e1241 >= _e1242));
                                                if (_e1247 || (((_e1237 <= _e1238) && (_e1239 <= _e1240)) && (_e1241 <= _e1242))) {
                                                    let _e1254 = select(-1f, 1f, _e1247);
                                                    let _e1256 = ((_e1237 - _e1238) * _e1254);
                                                    let _e1258 = select(0f, _e1256, (_e1256 > 0f));
                                                    let _e1260 = ((_e1239 - _e1240) * _e1254);
                                                    let _e1262 = select(0f, _e1260, (_e1260 > 0f));
                                                    let _e1264 = ((_e1241 - _e1242) * _e1254);
                                                    let _e1266 = select(0f, _e1264, (_e1264 > 0f));
                                                    let _e1268 = ((_e1258 + _e1262) + _e1266);
                                                    if (_e1268 < 0.000000000000000000000000000000000000011754944f) {
                                                        phi_2884_ = type_20();
                                                        phi_2885_ = true;
                                                    } else {
                                                        let _e1271 = select(_e1196[1][0], _e1196[0][0], (_e1196[0][0] < _e1196[1][0]));
                                                        let _e1275 = select(_e1196[1][0], _e1196[0][0], (_e1196[0][0] > _e1196[1][0]));
                                                        let _e1279 = select(_e1196[1][1], _e1196[0][1], (_e1196[0][1] < _e1196[1][1]));
                                                        let _e1283 = select(_e1196[1][1], _e1196[0][1], (_e1196[0][1] > _e1196[1][1]));
                                                        let _e1287 = select(_e1196[1][2], _e1196[0][2], (_e1196[0][2] < _e1196[1][2]));
                                                        let _e1291 = select(_e1196[1][2], _e1196[0][2], (_e1196[0][2] > _e1196[1][2]));
                                                        let _e1296 = ((select(_e1196[2][0], _e1271, (_e1271 < _e1196[2][0])) - _e322) * _e327);
                                                        let _e1297 = ((select(_e1196[2][0], _e1275, (_e1275 > _e1196[2][0])) - _e323) * _e327);
                                                        let _e1300 = ((select(_e1196[2][1], _e1279, (_e1279 < _e1196[2][1])) - _e360) * _e365);
                                                        let _e1301 = ((select(_e1196[2][1], _e1283, (_e1283 > _e1196[2][1])) - _e361) * _e365);
                                                        let _e1304 = ((select(_e1196[2][2], _e1287, (_e1287 < _e1196[2][2])) - _e398) * _e403);
                                                        let _e1305 = ((select(_e1196[2][2], _e1291, (_e1291 > _e1196[2][2])) - _e399) * _e403);
                                                        let _e1307 = select(_e1305, _e1304, (_e1304 < _e1305));
                                                        let _e1309 = select(_e1305, _e1304, (_e1304 > _e1305));
                                                        let _e1311 = select(_e1297, _e1296, (_e1296 < _e1297));
                                                        let _e1313 = select(_e1301, _e1300, (_e1300 < _e1301));
                                                        let _e1315 = select(_e1313, _e1311, (_e1311 > _e1313));
                                                        let _e1317 = select(_e1307, _e1315, (_e1315 > _e1307));
                                                        let _e1319 = select(_e1297, _e1296, (_e1296 > _e1297));
                                                        let _e1321 = select(_e1301, _e1300, (_e1300 > _e1301));
                                                        let _e1323 = select(_e1321, _e1319, (_e1319 < _e1321));
                                                        let _e1325 = select(_e1309, _e1323, (_e1323 < _e1309));
                                                        let _e1326 = -(_e1307);
                                                        let _e1332 = select(_e450, _e1317, (_e1317 > _e450));
                                                        if (_e1332 > (_e1325 + (select(_e1326, _e1309, (_e1309 > _e1326)) * 0.0000019073523f))) {
                                                            phi_2879_ = type_20();
                                                            phi_2880_ = true;
                                                        } else {
                                                            let _e1334 = (_e1332 > _e996.member_1);
                                                            if _e1334 {
                                                                phi_2878_ = type_20();
                                                            } else {
                                                                let _e1338 = (_e1196[1][0] - _e1196[0][0]);
                                                                let _e1339 = (_e1196[1][1] - _e1196[0][1]);
                                                                let _e1340 = (_e1196[1][2] - _e1196[0][2]);
                                                                let _e1341 = vec3<f32>(_e1338, _e1339, _e1340);
                                                                let _e1342 = (_e1196[2][0] - _e1196[1][0]);
                                                                let _e1343 = (_e1196[2][1] - _e1196[1][1]);
                                                                let _e1344 = (_e1196[2][2] - _e1196[1][2]);
                                                                let _e1345 = vec3<f32>(_e1342, _e1343, _e1344);
                                                                let _e1346 = (_e1196[0][0] - _e1196[2][0]);
                                                                let _e1347 = (_e1196[0][1] - _e1196[2][1]);
                                                                let _e1348 = (_e1196[0][2] - _e1196[2][2]);
                                                                let _e1349 = vec3<f32>(_e1346, _e1347, _e1348);
                                                                let _e1352 = bitcast<f32>((bitcast<u32>(_e1338) & 2147483647u));
                                                                let _e1355 = bitcast<f32>((bitcast<u32>(_e1339) & 2147483647u));
                                                                let _e1357 = select(_e1355, _e1352, (_e1352 > _e1355));
                                                                let _e1360 = bitcast<f32>((bitcast<u32>(_e1340) & 2147483647u));
                                                                let _e1362 = select(_e1360, _e1357, (_e1357 > _e1360));
                                                                let _e1365 = bitcast<f32>((bitcast<u32>(_e1342) & 2147483647u));
                                                                let _e1368 = bitcast<f32>((bitcast<u32>(_e1343) & 2147483647u));
                                                                let _e1370 = select(_e1368, _e1365, (_e1365 > _e1368));
                                                                let _e1373 = bitcast<f32>((bitcast<u32>(_e1344) & 2147483647u));
                                                                let _e1375 = select(_e1373, _e1370, (_e1370 > _e1373));
                                                                let _e1378 = bitcast<f32>((bitcast<u32>(_e1346) & 2147483647u));
                                                                let _e1381 = bitcast<f32>((bitcast<u32>(_e1347) & 2147483647u));
                                                                let _e1383 = select(_e1381, _e1378, (_e1378 > _e1381));
                                                                let _e1386 = bitcast<f32>((bitcast<u32>(_e1348) & 2147483647u));
                                                                let _e1388 = select(_e1386, _e1383, (_e1383 > _e1386));
                                                                let _e1390 = select(_e1375, _e1362, (_e1362 > _e1375));
                                                                let _e1392 = select(_e1388, _e1390, (_e1390 > _e1388));
                                                                if (_e1362 == _e1392) {
                                                                    phi_2789_ = _e1345;
                                                                    phi_2790_ = _e1349;
                                                                } else {
                                                                    let _e1395 = vec3((_e1375 == _e1392));
                                                                    phi_2789_ = select(_e1341, _e1349, _e1395);
                                                                    phi_2790_ = select(_e1345, _e1341, _e1395);
                                                                }
                                                                let _e1399 = phi_2789_;
                                                                let _e1401 = phi_2790_;
                                                                let _e1408 = ((_e1399.y * _e1401.z) - (_e1401.y * _e1399.z));
                                                                let _e1413 = ((_e1399.z * _e1401.x) - (_e1401.z * _e1399.x));
                                                                let _e1416 = ((_e1399.x * _e1401.y) - (_e1401.x * _e1399.y));
                                                                if (_e1258 >= _e1262) {
                                                                    phi_2821_ = select(true, false, (_e1258 >= _e1266));
                                                                } else {
                                                                    phi_2821_ = true;
                                                                }
                                                                let _e1421 = phi_2821_;
                                                                if _e1421 {
                                                                    phi_2830_ = select(vec3<f32>(_e1196[2][0], _e1196[2][1], _e1196[2][2]), vec3<f32>(_e1196[1][0], _e1196[1][1], _e1196[1][2]), vec3((_e1262 >= _e1266)));
                                                                } else {
                                                                    phi_2830_ = vec3<f32>(_e1196[0][0], _e1196[0][1], _e1196[0][2]);
                                                                }
                                                                let _e1426 = phi_2830_;
                                                                let _e1443 = ((((_e1408 * (_e1426.x - _e299)) + (_e1413 * (_e1426.y - _e338))) + (_e1416 * (_e1426.z - _e376))) / (((_e1408 * _e324) + (_e1413 * _e362)) + (_e1416 * _e400)));
                                                                let _e1445 = select(_e1325, _e1443, (_e1443 < _e1325));
                                                                let _e1447 = select(_e1317, _e1445, (_e1445 > _e1317));
                                                                if (_e1447 >= _e450) {
                                                                    let _e1449 = (_e1447 <= _e996.member_1);
                                                                    if _e1449 {
                                                                        let _e1450 = (1f / _e1268);
                                                                        phi_2870_ = type_20(_e1447, (_e1262 * _e1450), (_e1266 * _e1450), _e1056);
                                                                    } else {
                                                                        phi_2870_ = type_20();
                                                                    }
                                                                    let _e1455 = phi_2870_;
                                                                    phi_2872_ = _e1455;
                                                                    phi_2873_ = select(true, false, _e1449);
                                                                } else {
                                                                    phi_2872_ = type_20();
                                                                    phi_2873_ = true;
                                                                }
                                                                let _e1458 = phi_2872_;
                                                                let _e1460 = phi_2873_;
                                                                if _e1460 {
                                                                    phi_2877_ = type_20(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                } else {
                                                                    phi_2877_ = _e1458;
                                                                }
                                                                let _e1462 = phi_2877_;
                                                                phi_2878_ = _e1462;
                                                            }
                                                            let _e1464 = phi_2878_;
                                                            phi_2879_ = _e1464;
                                                            phi_2880_ = _e1334;
                                                        }
                                                        let _e1466 = phi_2879_;
                                                        let _e1468 = phi_2880_;
                                                        phi_2884_ = _e1466;
                                                        phi_2885_ = _e1468;
                                                    }
                                                    let _e1470 = phi_2884_;
                                                    let _e1472 = phi_2885_;
                                                    phi_2889_ = _e1470;
                                                    phi_2890_ = _e1472;
                                                } else {
                                                    phi_2889_ = type_20();
                                                    phi_2890_ = true;
                                                }
                                                let _e1474 = phi_2889_;
                                                let _e1476 = phi_2890_;
                                                if _e1476 {
                                                    phi_2894_ = type_20(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                } else {
                                                    phi_2894_ = _e1474;
                                                }
                                                let _e1478 = phi_2894_;
                                                if (_e1478.member_3 != 4294967295u) {
                                                    if (_e1056 != 4294967295u) {
                                                        if (_e1478.member < _e996.member.member) {
                                                            phi_2920_ = true;
                                                        } else {
                                                            if (_e1478.member == _e996.member.member) {
                                                                phi_2919_ = (_e1478.member_3 < _e996.member.member_3);
                                                            } else {
                                                                phi_2919_ = false;
                                                            }
                                                            let _e1491 = phi_2919_;
                                                            phi_2920_ = _e1491;
                                                        }
                                                        let _e1493 = phi_2920_;
                                                        if _e1493 {
                                                            phi_2926_ = type_32(_e1478, _e1478.member);
                                                        } else {
                                                            phi_2926_ = _e996;
                                                        }
                                                        let _e1496 = phi_2926_;
                                                        phi_2927_ = _e1496;
                                                    } else {
                                                        phi_2927_ = _e996;
                                                    }
                                                    let _e1498 = phi_2927_;
                                                    phi_2928_ = _e1498;
                                                } else {
                                                    phi_2928_ = _e996;
                                                }
                                                let _e1500 = phi_2928_;
                                                phi_4597_ = _e1195;
                                                phi_1963_ = _e1500;
                                            } else {
                                                phi_4597_ = _e994;
                                                phi_1963_ = type_32();
                                            }
                                            let _e1502 = phi_4597_;
                                            let _e1504 = phi_1963_;
                                            continue;
                                            continuing {
                                                phi_4542_ = _e1502;
                                                phi_1962_ = _e1504;
                                                phi_1965_ = _e1011;
                                                phi_4596_ = _e1502;
                                                break if !(_e1017);
                                            }
                                        }
                                        let _e1507 = phi_4596_;
                                        phi_4655_ = _e1507;
                                        if _e1507 {
                                            break;
                                        }
                                        phi_4659_ = _e1507;
                                        let _e1705 = local_8;
                                        phi_4266_ = _e1705;
                                        phi_4267_ = _e523;
                                        phi_4268_ = false;
                                        phi_4269_ = _e527;
                                    } else {
                                        if (_e523.member_1 >= _e87) {
                                            phi_3866_ = type_55(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), type_52(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u), type_52(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u));
                                        } else {
                                            if (_e523.member_1 < _e87) {
                                            } else {
                                                phi_4655_ = true;
                                                break;
                                            }
                                            let _e541 = ((1u + (_e258 * 2u)) % 7u);
                                            if (_e541 < 7u) {
                                            } else {
                                                phi_4655_ = true;
                                                break;
                                            }
                                            let _e546 = global_4.member[_e523.member_1][_e541];
                                            let _e549 = ((1u + (_e257 * 2u)) % 7u);
                                            if (_e549 < 7u) {
                                            } else {
                                                phi_4655_ = true;
                                                break;
                                            }
                                            let _e554 = global_4.member[_e523.member_1][_e549];
                                            let _e557 = ((1u + (_e259 * 2u)) % 7u);
                                            if (_e557 < 7u) {
                                            } else {
                                                phi_4655_ = true;
                                                break;
                                            }
                                            let _e562 = global_4.member[_e523.member_1][_e557];
                                            let _e565 = (((_e258 + 1u) * 2u) % 7u);
                                            if (_e565 < 7u) {
                                            } else {
                                                phi_4655_ = true;
                                                break;
                                            }
                                            let _e570 = global_4.member[_e523.member_1][_e565];
                                            let _e573 = (((_e257 + 1u) * 2u) % 7u);
                                            if (_e573 < 7u) {
                                            } else {
                                                phi_4655_ = true;
                                                break;
                                            }
                                            let _e578 = global_4.member[_e523.member_1][_e573];
                                            let _e581 = (((_e259 + 1u) * 2u) % 7u);
                                            if (_e581 < 7u) {
                                            } else {
                                                phi_4655_ = true;
                                                break;
                                            }
                                            let _e586 = global_4.member[_e523.member_1][_e581];
                                            let _e609 = (bitcast<f32>((bitcast<u32>((_e523.member.member_1.x - _e523.member.member.x)) & 2139095040u)) * 0.0000009536743f);
                                            let _e610 = (bitcast<f32>((bitcast<u32>((_e523.member.member_1.y - _e523.member.member.y)) & 2139095040u)) * 0.0000009536743f);
                                            let _e611 = (bitcast<f32>((bitcast<u32>((_e523.member.member_1.z - _e523.member.member.z)) & 2139095040u)) * 0.0000009536743f);
                                            let _e613 = select(_e138, _e609, (_e609 > _e138));
                                            let _e615 = select(_e138, _e610, (_e610 > _e138));
                                            let _e617 = select(_e138, _e611, (_e611 > _e138));
                                            let _e642 = bitcast<u32>((f32(bitcast<i32>((_e546 & 2097151u))) * _e613));
                                            let _e647 = (bitcast<i32>((_e546 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e650 = bitcast<f32>((_e642 & bitcast<u32>(_e647)));
                                            let _e651 = bitcast<u32>((f32(bitcast<i32>((_e554 & 2097151u))) * _e615));
                                            let _e656 = (bitcast<i32>((_e554 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e659 = bitcast<f32>((_e651 & bitcast<u32>(_e656)));
                                            let _e660 = bitcast<u32>((f32(bitcast<i32>((_e562 & 2097151u))) * _e617));
                                            let _e665 = (bitcast<i32>((_e562 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e668 = bitcast<f32>((_e660 & bitcast<u32>(_e665)));
                                            let _e672 = bitcast<f32>((_e642 & bitcast<u32>(~(_e647))));
                                            let _e676 = bitcast<f32>((_e651 & bitcast<u32>(~(_e656))));
                                            let _e680 = bitcast<f32>((_e660 & bitcast<u32>(~(_e665))));
                                            let _e681 = bitcast<u32>((f32(bitcast<i32>((_e570 & 2097151u))) * _e613));
                                            let _e686 = (bitcast<i32>((_e570 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e689 = bitcast<f32>((_e681 & bitcast<u32>(_e686)));
                                            let _e690 = bitcast<u32>((f32(bitcast<i32>((_e578 & 2097151u))) * _e615));
                                            let _e695 = (bitcast<i32>((_e578 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e698 = bitcast<f32>((_e690 & bitcast<u32>(_e695)));
                                            let _e699 = bitcast<u32>((f32(bitcast<i32>((_e586 & 2097151u))) * _e617));
                                            let _e704 = (bitcast<i32>((_e586 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e707 = bitcast<f32>((_e699 & bitcast<u32>(_e704)));
                                            let _e711 = bitcast<f32>((_e681 & bitcast<u32>(~(_e686))));
                                            let _e715 = bitcast<f32>((_e690 & bitcast<u32>(~(_e695))));
                                            let _e719 = bitcast<f32>((_e699 & bitcast<u32>(~(_e704))));
                                            let _e720 = (_e523.member.member.x + _e650);
                                            let _e721 = (_e523.member.member.y + _e659);
                                            let _e722 = (_e523.member.member.z + _e668);
                                            let _e725 = (_e523.member.member_1.x - _e689);
                                            let _e726 = (_e523.member.member_1.y - _e698);
                                            let _e727 = (_e523.member.member_1.z - _e707);
                                            let _e746 = (_e725 - _e720);
                                            let _e747 = (_e726 - _e721);
                                            let _e748 = (_e727 - _e722);
                                            let _e750 = select(_e747, _e746, (_e746 > _e747));
                                            let _e752 = select(_e748, _e750, (_e750 > _e748));
                                            if (_e752 < (1024f * _e138)) {
                                                phi_3567_ = 0u;
                                            } else {
                                                phi_3567_ = select(2u, 1u, (_e752 < (2097152f * _e138)));
                                            }
                                            let _e759 = phi_3567_;
                                            switch bitcast<i32>(_e759) {
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
                                            let _e762 = phi_3573_;
                                            let _e768 = global_4.member[_e523.member_1][0u];
                                            let _e772 = global_4.member[_e523.member_1][2u];
                                            let _e776 = global_4.member[_e523.member_1][4u];
                                            let _e780 = global_4.member[_e523.member_1][6u];
                                            let _e792 = (((_e772 >> bitcast<u32>(22i)) | ((_e776 >> bitcast<u32>(22i)) << bitcast<u32>(10i))) | ((_e780 >> bitcast<u32>(22i)) << bitcast<u32>(20i)));
                                            let _e793 = (_e768 & 268435455u);
                                            let _e794 = (_e792 & 268435455u);
                                            let _e797 = ((_e768 >> bitcast<u32>(28u)) & 7u);
                                            let _e805 = ((_e768 >> bitcast<u32>(31i)) | (((_e792 >> bitcast<u32>(28u)) & 3u) << bitcast<u32>(1i)));
                                            let _e806 = (_e797 != 0u);
                                            if (_e797 == 0u) {
                                                phi_3828_ = _e793;
                                            } else {
                                                if (_e797 == 7u) {
                                                    phi_3827_ = 2147483648u;
                                                } else {
                                                    phi_3827_ = ((2147483648u | (_e797 << bitcast<u32>(28u))) | (_e794 & 268435455u));
                                                }
                                                let _e815 = phi_3827_;
                                                phi_3828_ = _e815;
                                            }
                                            let _e817 = phi_3828_;
                                            if _e806 {
                                                let _e818 = (_e797 != 7u);
                                                if _e818 {
                                                    phi_3838_ = (_e794 + (_e797 * ((3u * _e762) + 1u)));
                                                } else {
                                                    phi_3838_ = u32();
                                                }
                                                let _e822 = phi_3838_;
                                                phi_3840_ = _e822;
                                                phi_3841_ = select(true, false, _e818);
                                            } else {
                                                phi_3840_ = u32();
                                                phi_3841_ = true;
                                            }
                                            let _e825 = phi_3840_;
                                            let _e827 = phi_3841_;
                                            if (_e805 == 0u) {
                                                phi_3862_ = (_e793 + select(0u, 1u, !(_e806)));
                                            } else {
                                                if (_e805 == 7u) {
                                                    phi_3861_ = 2147483648u;
                                                } else {
                                                    phi_3861_ = ((2147483648u | (_e805 << bitcast<u32>(28u))) | (select(_e825, _e794, _e827) & 268435455u));
                                                }
                                                let _e840 = phi_3861_;
                                                phi_3862_ = _e840;
                                            }
                                            let _e842 = phi_3862_;
                                            phi_3866_ = type_55(array<vec4<f32>, 3>(vec4<f32>(_e720, (_e523.member.member.x + _e672), _e725, (_e523.member.member_1.x - _e711)), vec4<f32>(_e721, (_e523.member.member.y + _e676), _e726, (_e523.member.member_1.y - _e715)), vec4<f32>(_e722, (_e523.member.member.z + _e680), _e727, (_e523.member.member_1.z - _e719))), type_52(type_28((_e523.member.member + vec4<f32>(_e650, _e659, _e668, 0f)), (_e523.member.member_1 - vec4<f32>(_e689, _e698, _e707, 0f))), _e817), type_52(type_28((_e523.member.member + vec4<f32>(_e672, _e676, _e680, 0f)), (_e523.member.member_1 - vec4<f32>(_e711, _e715, _e719, 0f))), _e842));
                                        }
                                        let _e847 = phi_3866_;
                                        let _e859 = ((_e847.member[0].x - _e322) * _e327);
                                        let _e860 = ((_e847.member[0].y - _e322) * _e327);
                                        let _e861 = ((_e847.member[0].z - _e323) * _e327);
                                        let _e862 = ((_e847.member[0].w - _e323) * _e327);
                                        let _e872 = ((_e847.member[1].x - _e360) * _e365);
                                        let _e873 = ((_e847.member[1].y - _e360) * _e365);
                                        let _e874 = ((_e847.member[1].z - _e361) * _e365);
                                        let _e875 = ((_e847.member[1].w - _e361) * _e365);
                                        let _e885 = ((_e847.member[2].x - _e398) * _e403);
                                        let _e886 = ((_e847.member[2].y - _e398) * _e403);
                                        let _e887 = ((_e847.member[2].z - _e399) * _e403);
                                        let _e888 = ((_e847.member[2].w - _e399) * _e403);
                                        let _e890 = select(_e887, _e885, (_e885 < _e887));
                                        let _e892 = select(_e888, _e886, (_e886 < _e888));
                                        let _e894 = select(_e887, _e885, (_e885 > _e887));
                                        let _e896 = select(_e888, _e886, (_e886 > _e888));
                                        let _e898 = select(_e861, _e859, (_e859 < _e861));
                                        let _e900 = select(_e862, _e860, (_e860 < _e862));
                                        let _e902 = select(_e874, _e872, (_e872 < _e874));
                                        let _e904 = select(_e875, _e873, (_e873 < _e875));
                                        let _e906 = select(_e902, _e898, (_e898 > _e902));
                                        let _e908 = select(_e904, _e900, (_e900 > _e904));
                                        let _e910 = select(_e890, _e906, (_e906 > _e890));
                                        let _e912 = select(_e892, _e908, (_e908 > _e892));
                                        let _e914 = select(_e861, _e859, (_e859 > _e861));
                                        let _e916 = select(_e862, _e860, (_e860 > _e862));
                                        let _e918 = select(_e874, _e872, (_e872 > _e874));
                                        let _e920 = select(_e875, _e873, (_e873 > _e875));
                                        let _e922 = select(_e918, _e914, (_e914 < _e918));
                                        let _e924 = select(_e920, _e916, (_e916 < _e920));
                                        let _e929 = -(_e890);
                                        let _e930 = -(_e892);
                                        let _e937 = (select(_e894, _e922, (_e922 < _e894)) + (select(_e929, _e894, (_e894 > _e929)) * 0.0000019073523f));
                                        let _e938 = (select(_e896, _e924, (_e924 < _e896)) + (select(_e930, _e896, (_e896 > _e930)) * 0.0000019073523f));
                                        let _e940 = select(_e450, _e910, (_e910 > _e450));
                                        let _e942 = select(_e450, _e912, (_e912 > _e450));
                                        let _e947 = (_e940 <= select(_e494.member_1, _e937, (_e937 < _e494.member_1)));
                                        let _e948 = (_e942 <= select(_e494.member_1, _e938, (_e938 < _e494.member_1)));
                                        let _e949 = (_e940 <= _e942);
                                        if _e947 {
                                            if _e948 {
                                                if _e949 {
                                                    phi_4210_ = _e847.member_2;
                                                } else {
                                                    phi_4210_ = _e847.member_1;
                                                }
                                                let _e953 = phi_4210_;
                                                let _e954 = (_e527 % 128u);
                                                let _e955 = (_e954 < 128u);
                                                if _e955 {
                                                } else {
                                                    phi_4655_ = true;
                                                    break;
                                                }
                                                local_3[_e954] = type_52(type_28(_e953.member.member, _e953.member.member_1), _e953.member_1);
                                                if _e955 {
                                                } else {
                                                    phi_4655_ = true;
                                                    break;
                                                }
                                                local_2[_e954] = select(_e942, _e940, (_e940 > _e942));
                                                if _e949 {
                                                    phi_4243_ = _e847.member_1;
                                                } else {
                                                    phi_4243_ = _e847.member_2;
                                                }
                                                let _e970 = phi_4243_;
                                                phi_4244_ = _e970;
                                                phi_4245_ = (_e527 + 1u);
                                            } else {
                                                phi_4244_ = type_52();
                                                phi_4245_ = u32();
                                            }
                                            let _e972 = phi_4244_;
                                            let _e974 = phi_4245_;
                                            phi_4247_ = _e972;
                                            phi_4248_ = _e974;
                                            phi_4249_ = select(true, false, _e948);
                                        } else {
                                            phi_4247_ = type_52();
                                            phi_4248_ = u32();
                                            phi_4249_ = true;
                                        }
                                        let _e977 = phi_4247_;
                                        let _e979 = phi_4248_;
                                        let _e981 = phi_4249_;
                                        if _e981 {
                                            if _e947 {
                                                phi_4258_ = _e847.member_1;
                                            } else {
                                                phi_4258_ = _e847.member_2;
                                            }
                                            let _e985 = phi_4258_;
                                            phi_4263_ = _e985;
                                            phi_4264_ = select(_e948, true, _e947);
                                        } else {
                                            phi_4263_ = _e977;
                                            phi_4264_ = _e525;
                                        }
                                        let _e988 = phi_4263_;
                                        let _e990 = phi_4264_;
                                        phi_4659_ = _e492;
                                        phi_4266_ = _e494;
                                        phi_4267_ = _e988;
                                        phi_4268_ = _e990;
                                        phi_4269_ = select(_e979, _e527, _e981);
                                    }
                                    let _e1509 = phi_4659_;
                                    let _e1511 = phi_4266_;
                                    let _e1513 = phi_4267_;
                                    let _e1515 = phi_4268_;
                                    let _e1517 = phi_4269_;
                                    phi_4658_ = _e1509;
                                    phi_4270_ = _e1511;
                                    phi_4271_ = _e1513;
                                    phi_4272_ = (_e498 - 1u);
                                    phi_4273_ = _e1515;
                                    phi_4274_ = _e1517;
                                } else {
                                    phi_4658_ = _e492;
                                    phi_4270_ = _e494;
                                    phi_4271_ = _e523;
                                    phi_4272_ = _e498;
                                    phi_4273_ = _e525;
                                    phi_4274_ = _e527;
                                }
                                let _e1519 = phi_4658_;
                                let _e1521 = phi_4270_;
                                let _e1523 = phi_4271_;
                                let _e1525 = phi_4272_;
                                let _e1527 = phi_4273_;
                                let _e1529 = phi_4274_;
                                phi_4657_ = _e1519;
                                phi_4275_ = _e1521;
                                phi_4276_ = _e1523;
                                phi_4277_ = _e1525;
                                phi_4278_ = _e1527;
                                phi_4279_ = _e1529;
                            } else {
                                phi_4657_ = _e492;
                                phi_4275_ = type_32();
                                phi_4276_ = type_52();
                                phi_4277_ = u32();
                                phi_4278_ = bool();
                                phi_4279_ = u32();
                            }
                            let _e1531 = phi_4657_;
                            let _e1533 = phi_4275_;
                            let _e1535 = phi_4276_;
                            let _e1537 = phi_4277_;
                            let _e1539 = phi_4278_;
                            let _e1541 = phi_4279_;
                            phi_4656_ = _e1531;
                            phi_1885_ = _e1533;
                            phi_1888_ = _e1535;
                            phi_1890_ = _e1537;
                            phi_1892_ = _e1539;
                            phi_1894_ = _e1541;
                            phi_4280_ = _e506;
                        } else {
                            phi_4656_ = _e492;
                            phi_1885_ = type_32();
                            phi_1888_ = type_52();
                            phi_1890_ = u32();
                            phi_1892_ = bool();
                            phi_1894_ = u32();
                            phi_4280_ = false;
                        }
                        let _e1543 = phi_4656_;
                        let _e1545 = phi_1885_;
                        let _e1547 = phi_1888_;
                        let _e1549 = phi_1890_;
                        let _e1551 = phi_1892_;
                        let _e1553 = phi_1894_;
                        let _e1555 = phi_4280_;
                        continue;
                        continuing {
                            phi_4545_ = _e1543;
                            phi_1884_ = _e1545;
                            phi_1887_ = _e1547;
                            phi_1889_ = _e1549;
                            phi_1891_ = _e1551;
                            phi_1893_ = _e1553;
                            phi_4655_ = _e1543;
                            break if !(_e1555);
                        }
                    }
                    let _e1558 = phi_4655_;
                    if _e1558 {
                        break;
                    }
                    let _e1560 = local_7;
                    if (_e1560.member.member_3 != 4294967295u) {
                        let _e1565 = -(_e417);
                        let _e1566 = (_e1565 / 3i);
                        let _e1573 = bitcast<f32>((bitcast<u32>((_e1566 + 127i)) << bitcast<u32>(23i)));
                        let _e1581 = (((_e1560.member.member * _e1573) * _e1573) * bitcast<f32>((bitcast<u32>(((_e1565 - (2i * _e1566)) + 127i)) << bitcast<u32>(23i))));
                        let _e1583 = select(340282350000000000000000000000000000000f, _e1581, (_e1581 < 340282350000000000000000000000000000000f));
                        phi_4332_ = type_20(select(-340282350000000000000000000000000000000f, _e1583, (_e1583 > -340282350000000000000000000000000000000f)), _e1560.member.member_1, _e1560.member.member_2, _e1560.member.member_3);
                    } else {
                        phi_4332_ = type_20(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                    }
                    let _e1590 = phi_4332_;
                    if _e146 {
                    } else {
                        break;
                    }
                    global_6.member[_e144] = _e1590;
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
