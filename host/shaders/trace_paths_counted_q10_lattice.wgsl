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

struct type_22 {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: u32,
}

struct type_24 {
    member: array<type_22>,
}

struct type_26 {
    member: array<f32, 3>,
    member_1: f32,
    member_2: array<f32, 3>,
    member_3: f32,
}

struct type_27 {
    member: type_26,
    member_1: array<f32, 3>,
    member_2: u32,
    member_3: array<f32, 3>,
    member_4: u32,
}

struct type_29 {
    member: array<type_27>,
}

struct type_34 {
    member: vec4<f32>,
    member_1: vec4<f32>,
}

struct type_38 {
    member: type_22,
    member_1: f32,
}

struct type_41 {
    member: type_38,
    member_1: u32,
    member_2: u32,
}

struct type_43 {
    member: array<vec4<u32>, 2>,
}

struct type_52 {
    member: type_34,
    member_1: u32,
}

struct type_55 {
    member: array<vec4<f32>, 3>,
    member_1: type_52,
    member_2: type_52,
}

struct type_62 {
    member: array<atomic<u32>>,
}

var<private> global: vec3<u32>;
@group(0) @binding(4) 
var<storage, read_write> global_1: type_24;
@group(0) @binding(0) 
var<uniform> global_2: type_43;
@group(0) @binding(1) 
var<storage> global_3: type_13;
@group(0) @binding(3) 
var<storage> global_4: type_29;
@group(0) @binding(5) 
var<storage, read_write> global_5: type_4;
@group(0) @binding(6) 
var<storage, read_write> global_6: type_62;
@group(0) @binding(2) 
var<storage> global_7: type_4;

fn function_() {
    var local: array<i32, 3>;
    var local_1: array<i32, 3>;
    var local_2: array<f32, 128>;
    var local_3: array<type_52, 128>;
    var local_4: array<u32, 3>;
    var local_5: array<array<f32, 3>, 3>;
    var local_6: array<f32, 4>;
    var phi_411_: i32;
    var phi_412_: i32;
    var phi_422_: bool;
    var phi_432_: u32;
    var phi_433_: u32;
    var phi_435_: bool;
    var phi_440_: u32;
    var phi_473_: i32;
    var phi_491_: f32;
    var phi_497_: f32;
    var phi_508_: f32;
    var phi_514_: f32;
    var phi_537_: f32;
    var phi_548_: f32;
    var phi_557_: f32;
    var phi_563_: f32;
    var phi_574_: f32;
    var phi_580_: f32;
    var phi_603_: f32;
    var phi_614_: f32;
    var phi_623_: f32;
    var phi_629_: f32;
    var phi_640_: f32;
    var phi_646_: f32;
    var phi_669_: f32;
    var phi_680_: f32;
    var phi_780_: f32;
    var phi_781_: f32;
    var phi_4691_: bool;
    var phi_1910_: type_41;
    var phi_1913_: type_52;
    var phi_1915_: u32;
    var phi_1917_: bool;
    var phi_1919_: u32;
    var phi_1930_: bool;
    var phi_1967_: type_52;
    var phi_1968_: bool;
    var phi_1969_: u32;
    var phi_3600_: u32;
    var phi_3606_: u32;
    var phi_3860_: u32;
    var phi_3861_: u32;
    var phi_3871_: u32;
    var phi_3873_: u32;
    var phi_3874_: bool;
    var phi_3894_: u32;
    var phi_3895_: u32;
    var phi_3899_: type_55;
    var phi_4243_: type_52;
    var phi_4276_: type_52;
    var phi_4277_: type_52;
    var phi_4278_: u32;
    var phi_4280_: type_52;
    var phi_4281_: u32;
    var phi_4282_: bool;
    var phi_4291_: type_52;
    var phi_4296_: type_52;
    var phi_4297_: bool;
    var phi_4688_: bool;
    var phi_1988_: type_41;
    var phi_1991_: type_8;
    var phi_1992_: type_8;
    var phi_2014_: type_8;
    var phi_2058_: u32;
    var phi_2064_: u32;
    var phi_2074_: u32;
    var phi_2090_: u32;
    var phi_2127_: u32;
    var phi_2133_: u32;
    var phi_2143_: u32;
    var phi_4673_: bool;
    var phi_2159_: type_8;
    var phi_2160_: type_8;
    var phi_2183_: type_8;
    var phi_2206_: u32;
    var phi_2221_: u32;
    var phi_2224_: type_8;
    var phi_2225_: type_8;
    var phi_2248_: type_8;
    var phi_2314_: u32;
    var phi_2294_: u32;
    var phi_2295_: u32;
    var phi_2318_: f32;
    var phi_4666_: bool;
    var phi_4745_: bool;
    var phi_4744_: bool;
    var phi_2818_: vec3<f32>;
    var phi_2819_: vec3<f32>;
    var phi_2850_: bool;
    var phi_2859_: vec3<f32>;
    var phi_2899_: type_22;
    var phi_2901_: type_22;
    var phi_2902_: bool;
    var phi_2906_: type_22;
    var phi_2907_: type_22;
    var phi_2908_: type_22;
    var phi_2909_: bool;
    var phi_2913_: type_22;
    var phi_2914_: bool;
    var phi_2918_: type_22;
    var phi_2919_: bool;
    var phi_2923_: type_22;
    var phi_2948_: bool;
    var phi_2949_: bool;
    var phi_2956_: type_41;
    var phi_2957_: type_41;
    var phi_2958_: type_41;
    var phi_4747_: bool;
    var phi_1989_: type_41;
    var phi_4746_: bool;
    var phi_4809_: bool;
    var phi_4299_: type_41;
    var phi_4300_: type_52;
    var phi_4301_: bool;
    var phi_4302_: u32;
    var phi_4808_: bool;
    var phi_4303_: type_41;
    var phi_4304_: type_52;
    var phi_4305_: u32;
    var phi_4306_: bool;
    var phi_4307_: u32;
    var phi_4807_: bool;
    var phi_4308_: type_41;
    var phi_4309_: type_52;
    var phi_4310_: u32;
    var phi_4311_: bool;
    var phi_4312_: u32;
    var phi_4806_: bool;
    var phi_1911_: type_41;
    var phi_1914_: type_52;
    var phi_1916_: u32;
    var phi_1918_: bool;
    var phi_1920_: u32;
    var phi_4313_: bool;
    var phi_4805_: bool;
    var local_7: type_41;
    var phi_4365_: type_22;
    var local_8: type_41;
    var local_9: type_41;

    switch bitcast<i32>(0u) {
        default: {
            let _e89 = global;
            let _e91 = arrayLength((&global_3.member));
            let _e94 = arrayLength((&global_7.member));
            let _e102 = arrayLength((&global_6.member));
            let _e106 = global_2.member[0u][0u];
            let _e110 = global_2.member[0u][1u];
            let _e114 = global_2.member[0u][2u];
            let _e118 = global_2.member[0u][3u];
            let _e122 = global_2.member[1u][0u];
            let _e126 = global_2.member[1u][1u];
            let _e130 = global_2.member[1u][2u];
            let _e134 = (_e89.x + (_e89.y * 2097152u));
            let _e146 = bitcast<f32>((bitcast<u32>((bitcast<i32>(_e118) + 127i)) << bitcast<u32>(23i)));
            local_1 = array<i32, 3>(bitcast<i32>(_e106), bitcast<i32>(_e110), bitcast<i32>(_e114));
            local = array<i32, 3>(bitcast<i32>(_e122), bitcast<i32>(_e126), bitcast<i32>(_e130));
            let _e149 = (_e134 < arrayLength((&global_4.member)));
            if _e149 {
                let _e150 = (_e134 < arrayLength((&global_1.member)));
                if _e150 {
                    let _e151 = (_e134 < arrayLength((&global_5.member)));
                    if _e151 {
                        if _e149 {
                        } else {
                            break;
                        }
                        let _e161 = global_4.member[_e134].member.member_2[0u];
                        let _e163 = (bitcast<u32>(_e161) & 2147483647u);
                        let _e169 = global_4.member[_e134].member.member_2[1u];
                        let _e171 = (bitcast<u32>(_e169) & 2147483647u);
                        let _e177 = global_4.member[_e134].member.member_2[2u];
                        let _e179 = (bitcast<u32>(_e177) & 2147483647u);
                        let _e185 = global_4.member[_e134].member.member[0u];
                        let _e187 = (bitcast<u32>(_e185) & 2147483647u);
                        let _e193 = global_4.member[_e134].member.member[1u];
                        let _e195 = (bitcast<u32>(_e193) & 2147483647u);
                        let _e201 = global_4.member[_e134].member.member[2u];
                        let _e203 = (bitcast<u32>(_e201) & 2147483647u);
                        let _e205 = select(_e171, _e163, (_e171 < _e163));
                        let _e207 = select(_e179, _e205, (_e179 < _e205));
                        let _e209 = select(_e187, _e207, (_e187 < _e207));
                        let _e211 = select(_e195, _e209, (_e195 < _e209));
                        let _e213 = select(_e203, _e211, (_e203 < _e211));
                        let _e218 = global_4.member[_e134].member.member_1;
                        let _e220 = (bitcast<u32>(_e218) & 2147483647u);
                        let _e228 = global_4.member[_e134].member.member_3;
                        let _e234 = (((select(_e220, _e213, (_e220 < _e213)) < 2139095040u) && ((bitcast<u32>(_e228) & 2147483647u) <= 2139095040u)) && (_e207 > 0u));
                        if _e234 {
                            let _e237 = (bitcast<u32>(bitcast<f32>(_e207)) & 2147483647u);
                            if (_e237 >= 8388608u) {
                                phi_411_ = (bitcast<i32>((_e237 >> bitcast<u32>(23i))) - 127i);
                            } else {
                                phi_411_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e237)), 32u, (_e237 == 0u))));
                            }
                            let _e251 = phi_411_;
                            phi_412_ = _e251;
                        } else {
                            phi_412_ = 0i;
                        }
                        let _e253 = phi_412_;
                        let _e254 = (_e163 == _e207);
                        if _e254 {
                            phi_422_ = true;
                        } else {
                            phi_422_ = (_e171 == _e207);
                        }
                        let _e257 = phi_422_;
                        let _e258 = select(1u, 0u, _e254);
                        if _e257 {
                            let _e259 = (_e258 + 1u);
                            phi_432_ = _e259;
                            phi_433_ = _e259;
                            phi_435_ = select(true, false, (_e259 == 2u));
                        } else {
                            phi_432_ = u32();
                            phi_433_ = 0u;
                            phi_435_ = true;
                        }
                        let _e263 = phi_432_;
                        let _e265 = phi_433_;
                        let _e267 = phi_435_;
                        if _e267 {
                            phi_440_ = (_e265 + 1u);
                        } else {
                            phi_440_ = 0u;
                        }
                        let _e271 = phi_440_;
                        let _e272 = select(_e263, _e265, _e267);
                        let _e273 = select(_e258, select(2u, _e258, _e257), _e267);
                        let _e274 = -(_e253);
                        if (_e274 < -126i) {
                            phi_473_ = -126i;
                        } else {
                            phi_473_ = select(_e274, 127i, (_e274 > 127i));
                        }
                        let _e279 = phi_473_;
                        let _e284 = bitcast<f32>((bitcast<u32>((_e279 + 127i)) << bitcast<u32>(23i)));
                        let _e290 = bitcast<f32>((bitcast<u32>(((_e274 - _e279) + 127i)) << bitcast<u32>(23i)));
                        let _e295 = global_4.member[_e134].member.member;
                        let _e296 = (_e272 == 0u);
                        if _e296 {
                            phi_491_ = _e295[0];
                        } else {
                            phi_491_ = _e295[1];
                        }
                        let _e300 = phi_491_;
                        let _e301 = (_e272 == 2u);
                        if _e301 {
                            phi_497_ = _e295[2];
                        } else {
                            phi_497_ = _e300;
                        }
                        let _e304 = phi_497_;
                        let _e305 = global_4.member[_e134].member.member_2;
                        if _e296 {
                            phi_508_ = _e305[0];
                        } else {
                            phi_508_ = _e305[1];
                        }
                        let _e309 = phi_508_;
                        if _e301 {
                            phi_514_ = _e305[2];
                        } else {
                            phi_514_ = _e309;
                        }
                        let _e312 = phi_514_;
                        let _e314 = ((_e312 * _e284) * _e290);
                        let _e318 = (bitcast<f32>((bitcast<u32>(_e314) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e318 {
                            let _e322 = (bitcast<f32>((bitcast<u32>(_e304) & 2147483647u)) * 0.00000011920929f);
                            phi_537_ = select(0.00000000000011368684f, _e322, (_e322 > 0.00000000000011368684f));
                        } else {
                            phi_537_ = 0f;
                        }
                        let _e326 = phi_537_;
                        let _e327 = (_e304 + _e326);
                        let _e328 = (_e304 - _e326);
                        let _e329 = select(_e314, 0f, _e318);
                        if _e318 {
                            phi_548_ = 38685626000000000000000000f;
                        } else {
                            phi_548_ = (1f / _e314);
                        }
                        let _e332 = phi_548_;
                        let _e333 = (_e271 == 0u);
                        if _e333 {
                            phi_557_ = _e295[0];
                        } else {
                            phi_557_ = _e295[1];
                        }
                        let _e337 = phi_557_;
                        let _e338 = (_e271 == 2u);
                        if _e338 {
                            phi_563_ = _e295[2];
                        } else {
                            phi_563_ = _e337;
                        }
                        let _e341 = phi_563_;
                        if _e333 {
                            phi_574_ = _e305[0];
                        } else {
                            phi_574_ = _e305[1];
                        }
                        let _e345 = phi_574_;
                        if _e338 {
                            phi_580_ = _e305[2];
                        } else {
                            phi_580_ = _e345;
                        }
                        let _e348 = phi_580_;
                        let _e350 = ((_e348 * _e284) * _e290);
                        let _e354 = (bitcast<f32>((bitcast<u32>(_e350) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e354 {
                            let _e358 = (bitcast<f32>((bitcast<u32>(_e341) & 2147483647u)) * 0.00000011920929f);
                            phi_603_ = select(0.00000000000011368684f, _e358, (_e358 > 0.00000000000011368684f));
                        } else {
                            phi_603_ = 0f;
                        }
                        let _e362 = phi_603_;
                        let _e363 = (_e341 + _e362);
                        let _e364 = (_e341 - _e362);
                        let _e365 = select(_e350, 0f, _e354);
                        if _e354 {
                            phi_614_ = 38685626000000000000000000f;
                        } else {
                            phi_614_ = (1f / _e350);
                        }
                        let _e368 = phi_614_;
                        let _e369 = (_e273 == 0u);
                        if _e369 {
                            phi_623_ = _e295[0];
                        } else {
                            phi_623_ = _e295[1];
                        }
                        let _e373 = phi_623_;
                        let _e374 = (_e273 == 2u);
                        if _e374 {
                            phi_629_ = _e295[2];
                        } else {
                            phi_629_ = _e373;
                        }
                        let _e377 = phi_629_;
                        if _e369 {
                            phi_640_ = _e305[0];
                        } else {
                            phi_640_ = _e305[1];
                        }
                        let _e381 = phi_640_;
                        if _e374 {
                            phi_646_ = _e305[2];
                        } else {
                            phi_646_ = _e381;
                        }
                        let _e384 = phi_646_;
                        let _e386 = ((_e384 * _e284) * _e290);
                        let _e390 = (bitcast<f32>((bitcast<u32>(_e386) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e390 {
                            let _e394 = (bitcast<f32>((bitcast<u32>(_e377) & 2147483647u)) * 0.00000011920929f);
                            phi_669_ = select(0.00000000000011368684f, _e394, (_e394 > 0.00000000000011368684f));
                        } else {
                            phi_669_ = 0f;
                        }
                        let _e398 = phi_669_;
                        let _e399 = (_e377 + _e398);
                        let _e400 = (_e377 - _e398);
                        let _e401 = select(_e386, 0f, _e390);
                        if _e390 {
                            phi_680_ = 38685626000000000000000000f;
                        } else {
                            phi_680_ = (1f / _e386);
                        }
                        let _e404 = phi_680_;
                        let _e407 = bitcast<f32>((bitcast<u32>(_e304) & 2147483647u));
                        let _e410 = bitcast<f32>((bitcast<u32>(_e341) & 2147483647u));
                        let _e412 = select(_e410, _e407, (_e407 > _e410));
                        let _e415 = bitcast<f32>((bitcast<u32>(_e377) & 2147483647u));
                        if (_e234 && (select(_e415, _e412, (_e412 > _e415)) <= 1099511600000f)) {
                            let _e420 = (_e253 / 3i);
                            let _e427 = bitcast<f32>((bitcast<u32>((_e420 + 127i)) << bitcast<u32>(23i)));
                            let _e434 = bitcast<f32>((bitcast<u32>(((_e253 - (2i * _e420)) + 127i)) << bitcast<u32>(23i)));
                            let _e435 = (((_e218 * _e427) * _e427) * _e434);
                            let _e437 = select(340282350000000000000000000000000000000f, _e435, (_e435 < 340282350000000000000000000000000000000f));
                            let _e442 = (((_e228 * _e427) * _e427) * _e434);
                            let _e444 = select(340282350000000000000000000000000000000f, _e442, (_e442 < 340282350000000000000000000000000000000f));
                            phi_780_ = select(-340282350000000000000000000000000000000f, _e444, (_e444 > -340282350000000000000000000000000000000f));
                            phi_781_ = select(-340282350000000000000000000000000000000f, _e437, (_e437 > -340282350000000000000000000000000000000f));
                        } else {
                            phi_780_ = 0f;
                            phi_781_ = 1f;
                        }
                        let _e448 = phi_780_;
                        let _e450 = phi_781_;
                        if _e149 {
                        } else {
                            break;
                        }
                        let _e456 = global_4.member[_e134].member_2;
                        local_3 = array<type_52, 128>(type_52(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u));
                        local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        let _e459 = (_e272 % 3u);
                        let _e460 = (_e459 < 3u);
                        if _e460 {
                        } else {
                            break;
                        }
                        let _e462 = local_1[_e459];
                        let _e465 = (_e271 % 3u);
                        let _e466 = (_e465 < 3u);
                        if _e466 {
                        } else {
                            break;
                        }
                        let _e468 = local_1[_e465];
                        let _e471 = (_e273 % 3u);
                        let _e472 = (_e471 < 3u);
                        if _e472 {
                        } else {
                            break;
                        }
                        let _e474 = local_1[_e471];
                        if _e460 {
                        } else {
                            break;
                        }
                        let _e479 = local[_e459];
                        if _e466 {
                        } else {
                            break;
                        }
                        let _e483 = local[_e465];
                        if _e472 {
                        } else {
                            break;
                        }
                        let _e487 = local[_e471];
                        phi_4691_ = false;
                        phi_1910_ = type_41(type_38(type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e448), 0u, 0u);
                        phi_1913_ = type_52(type_34(vec4<f32>((f32(_e462) * _e146), (f32(_e468) * _e146), (f32(_e474) * _e146), 0f), vec4<f32>((f32(_e479) * _e146), (f32(_e483) * _e146), (f32(_e487) * _e146), 0f)), select(0u, 2147483648u, (_e91 == 0u)));
                        phi_1915_ = ((3u * _e91) + 1u);
                        phi_1917_ = (_e450 <= _e448);
                        phi_1919_ = 0u;
                        loop {
                            let _e497 = phi_4691_;
                            let _e499 = phi_1910_;
                            let _e501 = phi_1913_;
                            let _e503 = phi_1915_;
                            let _e505 = phi_1917_;
                            let _e507 = phi_1919_;
                            local_7 = _e499;
                            local_8 = _e499;
                            if _e505 {
                                phi_1930_ = true;
                            } else {
                                phi_1930_ = (_e507 > 0u);
                            }
                            let _e510 = phi_1930_;
                            if _e510 {
                                let _e511 = (_e503 > 0u);
                                if _e511 {
                                    if _e505 {
                                        phi_1967_ = _e501;
                                        phi_1968_ = _e505;
                                        phi_1969_ = _e507;
                                    } else {
                                        let _e512 = (_e507 - 1u);
                                        let _e513 = (_e512 % 128u);
                                        let _e514 = (_e513 < 128u);
                                        if _e514 {
                                        } else {
                                            phi_4805_ = true;
                                            break;
                                        }
                                        let _e516 = local_3[_e513];
                                        if _e514 {
                                        } else {
                                            phi_4805_ = true;
                                            break;
                                        }
                                        let _e524 = local_2[_e513];
                                        phi_1967_ = type_52(type_34(_e516.member.member, _e516.member.member_1), _e516.member_1);
                                        phi_1968_ = (_e524 <= _e499.member.member_1);
                                        phi_1969_ = _e512;
                                    }
                                    let _e529 = phi_1967_;
                                    let _e531 = phi_1968_;
                                    let _e533 = phi_1969_;
                                    if _e531 {
                                        let _e538 = (_e529.member_1 & 268435455u);
                                        if ((_e529.member_1 & 2147483648u) != 0u) {
                                            phi_4688_ = _e497;
                                            phi_1988_ = _e499;
                                            phi_1991_ = type_8(0u, ((_e529.member_1 >> bitcast<u32>(28u)) & 7u));
                                            loop {
                                                let _e1007 = phi_4688_;
                                                let _e1009 = phi_1988_;
                                                let _e1011 = phi_1991_;
                                                local_9 = _e1009;
                                                if (_e1011.member < _e1011.member_1) {
                                                    phi_1992_ = type_8((_e1011.member + 1u), _e1011.member_1);
                                                    phi_2014_ = type_8(1u, _e1011.member);
                                                } else {
                                                    phi_1992_ = _e1011;
                                                    phi_2014_ = type_8(0u, type_8().member_1);
                                                }
                                                let _e1024 = phi_1992_;
                                                let _e1026 = phi_2014_;
                                                let _e1030 = (bitcast<i32>(_e1026.member) != 0i);
                                                if _e1030 {
                                                    let _e1036 = type_41(_e1009.member, _e1009.member_1, (_e1009.member_2 + 1u));
                                                    let _e1041 = (_e529.member.member_1.x - _e529.member.member.x);
                                                    let _e1044 = (_e529.member.member_1.y - _e529.member.member.y);
                                                    let _e1047 = (_e529.member.member_1.z - _e529.member.member.z);
                                                    let _e1049 = select(_e1044, _e1041, (_e1041 > _e1044));
                                                    let _e1051 = select(_e1047, _e1049, (_e1049 > _e1047));
                                                    let _e1053 = (_e1051 < (1024f * _e146));
                                                    if _e1053 {
                                                        phi_2058_ = 0u;
                                                    } else {
                                                        phi_2058_ = select(2u, 1u, (_e1051 < (2097152f * _e146)));
                                                    }
                                                    let _e1058 = phi_2058_;
                                                    switch bitcast<i32>(_e1058) {
                                                        case 0: {
                                                            phi_2064_ = 1u;
                                                            break;
                                                        }
                                                        case 1: {
                                                            phi_2064_ = 2u;
                                                            break;
                                                        }
                                                        case 2: {
                                                            phi_2064_ = 3u;
                                                            break;
                                                        }
                                                        default: {
                                                            phi_2064_ = u32();
                                                            break;
                                                        }
                                                    }
                                                    let _e1061 = phi_2064_;
                                                    switch bitcast<i32>(_e1058) {
                                                        case 0: {
                                                            phi_2074_ = 1u;
                                                            break;
                                                        }
                                                        case 1: {
                                                            phi_2074_ = 2u;
                                                            break;
                                                        }
                                                        case 2: {
                                                            phi_2074_ = 3u;
                                                            break;
                                                        }
                                                        default: {
                                                            phi_2074_ = u32();
                                                            break;
                                                        }
                                                    }
                                                    let _e1068 = phi_2074_;
                                                    let _e1070 = ((_e538 + (_e1026.member_1 * ((3u * _e1061) + 1u))) + (3u * _e1068));
                                                    let _e1071 = (_e1070 < _e94);
                                                    if _e1071 {
                                                        if _e1071 {
                                                        } else {
                                                            phi_4746_ = true;
                                                            break;
                                                        }
                                                        let _e1073 = global_7.member[_e1070];
                                                        phi_2090_ = _e1073;
                                                    } else {
                                                        phi_2090_ = 4294967295u;
                                                    }
                                                    let _e1075 = phi_2090_;
                                                    local_4 = array<u32, 3>(_e272, _e271, _e273);
                                                    if _e1053 {
                                                        phi_2127_ = 0u;
                                                    } else {
                                                        phi_2127_ = select(2u, 1u, (_e1051 < (2097152f * _e146)));
                                                    }
                                                    let _e1081 = phi_2127_;
                                                    switch bitcast<i32>(_e1081) {
                                                        case 0: {
                                                            phi_2133_ = 1u;
                                                            break;
                                                        }
                                                        case 1: {
                                                            phi_2133_ = 2u;
                                                            break;
                                                        }
                                                        case 2: {
                                                            phi_2133_ = 3u;
                                                            break;
                                                        }
                                                        default: {
                                                            phi_2133_ = u32();
                                                            break;
                                                        }
                                                    }
                                                    let _e1084 = phi_2133_;
                                                    switch bitcast<i32>(_e1081) {
                                                        case 0: {
                                                            phi_2143_ = 1u;
                                                            break;
                                                        }
                                                        case 1: {
                                                            phi_2143_ = 2u;
                                                            break;
                                                        }
                                                        case 2: {
                                                            phi_2143_ = 3u;
                                                            break;
                                                        }
                                                        default: {
                                                            phi_2143_ = u32();
                                                            break;
                                                        }
                                                    }
                                                    let _e1091 = phi_2143_;
                                                    local_6 = array<f32, 4>(_e529.member.member.x, _e529.member.member.y, _e529.member.member.z, _e529.member.member.w);
                                                    local_5[0u] = array<f32, 3>(0f, 0f, 0f);
                                                    local_5[1u] = array<f32, 3>(0f, 0f, 0f);
                                                    local_5[2u] = array<f32, 3>(0f, 0f, 0f);
                                                    phi_4673_ = _e1007;
                                                    phi_2159_ = type_8(0u, 3u);
                                                    loop {
                                                        let _e1105 = phi_4673_;
                                                        let _e1107 = phi_2159_;
                                                        if (_e1107.member < _e1107.member_1) {
                                                            phi_2160_ = type_8((_e1107.member + 1u), _e1107.member_1);
                                                            phi_2183_ = type_8(1u, _e1107.member);
                                                        } else {
                                                            phi_2160_ = _e1107;
                                                            phi_2183_ = type_8(0u, type_8().member_1);
                                                        }
                                                        let _e1120 = phi_2160_;
                                                        let _e1122 = phi_2183_;
                                                        let _e1126 = (bitcast<i32>(_e1122.member) != 0i);
                                                        if _e1126 {
                                                            let _e1128 = ((_e538 + (_e1026.member_1 * ((3u * _e1084) + 1u))) + (_e1122.member_1 * _e1091));
                                                            let _e1129 = (_e1128 < _e94);
                                                            if _e1129 {
                                                                if _e1129 {
                                                                } else {
                                                                    phi_4744_ = true;
                                                                    break;
                                                                }
                                                                let _e1131 = global_7.member[_e1128];
                                                                phi_2206_ = _e1131;
                                                            } else {
                                                                phi_2206_ = 0u;
                                                            }
                                                            let _e1133 = phi_2206_;
                                                            let _e1134 = (_e1128 + 1u);
                                                            let _e1135 = (_e1134 < _e94);
                                                            if _e1135 {
                                                                if _e1135 {
                                                                } else {
                                                                    phi_4744_ = true;
                                                                    break;
                                                                }
                                                                let _e1137 = global_7.member[_e1134];
                                                                phi_2221_ = _e1137;
                                                            } else {
                                                                phi_2221_ = 0u;
                                                            }
                                                            let _e1139 = phi_2221_;
                                                            phi_2224_ = type_8(0u, 3u);
                                                            loop {
                                                                let _e1141 = phi_2224_;
                                                                if (_e1141.member < _e1141.member_1) {
                                                                    phi_2225_ = type_8((_e1141.member + 1u), _e1141.member_1);
                                                                    phi_2248_ = type_8(1u, _e1141.member);
                                                                } else {
                                                                    phi_2225_ = _e1141;
                                                                    phi_2248_ = type_8(0u, type_8().member_1);
                                                                }
                                                                let _e1154 = phi_2225_;
                                                                let _e1156 = phi_2248_;
                                                                let _e1160 = (bitcast<i32>(_e1156.member) != 0i);
                                                                if _e1160 {
                                                                    let _e1161 = (_e1156.member_1 < 3u);
                                                                    if _e1161 {
                                                                    } else {
                                                                        phi_4666_ = true;
                                                                        break;
                                                                    }
                                                                    let _e1163 = local_4[_e1156.member_1];
                                                                    if (_e1156.member_1 < 4u) {
                                                                    } else {
                                                                        phi_4666_ = true;
                                                                        break;
                                                                    }
                                                                    let _e1166 = local_6[_e1156.member_1];
                                                                    switch bitcast<i32>(_e1081) {
                                                                        case 0: {
                                                                            phi_2318_ = (_e1166 + (f32(((_e1133 >> bitcast<u32>(((10u * _e1163) & 31u))) & 1023u)) * _e146));
                                                                            break;
                                                                        }
                                                                        case 1: {
                                                                            if (_e1163 == 0u) {
                                                                                phi_2295_ = _e1133;
                                                                            } else {
                                                                                if (_e1163 == 1u) {
                                                                                    phi_2294_ = ((_e1133 >> bitcast<u32>(21i)) | (_e1139 << bitcast<u32>(11i)));
                                                                                } else {
                                                                                    phi_2294_ = (_e1139 >> bitcast<u32>(10i));
                                                                                }
                                                                                let _e1187 = phi_2294_;
                                                                                phi_2295_ = _e1187;
                                                                            }
                                                                            let _e1189 = phi_2295_;
                                                                            phi_2318_ = (_e1166 + (f32((_e1189 & 2097151u)) * _e146));
                                                                            break;
                                                                        }
                                                                        case 2: {
                                                                            let _e1168 = (_e1128 + _e1163);
                                                                            let _e1169 = (_e1168 < _e94);
                                                                            if _e1169 {
                                                                                if _e1169 {
                                                                                } else {
                                                                                    phi_4666_ = true;
                                                                                    break;
                                                                                }
                                                                                let _e1171 = global_7.member[_e1168];
                                                                                phi_2314_ = _e1171;
                                                                            } else {
                                                                                phi_2314_ = 0u;
                                                                            }
                                                                            let _e1173 = phi_2314_;
                                                                            phi_2318_ = (f32(bitcast<i32>(_e1173)) * _e146);
                                                                            break;
                                                                        }
                                                                        default: {
                                                                            phi_2318_ = f32();
                                                                            break;
                                                                        }
                                                                    }
                                                                    let _e1203 = phi_2318_;
                                                                    if (_e1122.member_1 < 3u) {
                                                                    } else {
                                                                        phi_4666_ = true;
                                                                        break;
                                                                    }
                                                                    if _e1161 {
                                                                    } else {
                                                                        phi_4666_ = true;
                                                                        break;
                                                                    }
                                                                    local_5[_e1122.member_1][_e1156.member_1] = _e1203;
                                                                }
                                                                continue;
                                                                continuing {
                                                                    phi_2224_ = _e1154;
                                                                    phi_4666_ = _e1105;
                                                                    break if !(_e1160);
                                                                }
                                                            }
                                                            let _e1209 = phi_4666_;
                                                            phi_4744_ = _e1209;
                                                            if _e1209 {
                                                                break;
                                                            }
                                                            phi_4745_ = _e1209;
                                                        } else {
                                                            phi_4745_ = _e1105;
                                                        }
                                                        let _e1211 = phi_4745_;
                                                        continue;
                                                        continuing {
                                                            phi_4673_ = _e1211;
                                                            phi_2159_ = _e1120;
                                                            phi_4744_ = _e1211;
                                                            break if !(_e1126);
                                                        }
                                                    }
                                                    let _e1214 = phi_4744_;
                                                    phi_4746_ = _e1214;
                                                    if _e1214 {
                                                        break;
                                                    }
                                                    let _e1215 = local_5;
                                                    let _e1232 = (_e1215[0][2] - _e377);
                                                    let _e1235 = (((_e1215[0][0] - _e304) * _e401) - (_e1232 * _e329));
                                                    let _e1238 = (((_e1215[0][1] - _e341) * _e401) - (_e1232 * _e365));
                                                    let _e1241 = (_e1215[1][2] - _e377);
                                                    let _e1244 = (((_e1215[1][0] - _e304) * _e401) - (_e1241 * _e329));
                                                    let _e1247 = (((_e1215[1][1] - _e341) * _e401) - (_e1241 * _e365));
                                                    let _e1250 = (_e1215[2][2] - _e377);
                                                    let _e1253 = (((_e1215[2][0] - _e304) * _e401) - (_e1250 * _e329));
                                                    let _e1256 = (((_e1215[2][1] - _e341) * _e401) - (_e1250 * _e365));
                                                    let _e1257 = (_e1253 * _e1247);
                                                    let _e1258 = (_e1256 * _e1244);
                                                    let _e1259 = (_e1235 * _e1256);
                                                    let _e1260 = (_e1238 * _e1253);
                                                    let _e1261 = (_e1244 * _e1238);
                                                    let _e1262 = (_e1247 * _e1235);
                                                    let _e1267 = (((_e1257 >= _e1258) && (_e1259 >= _e1260)) && (_e1261 >= _e1262));
                                                    if (_e1267 || (((_e1257 <= _e1258) && (_e1259 <= _e1260)) && (_e1261 <= _e1262))) {
                                                        let _e1274 = select(-1f, 1f, _e1267);
                                                        let _e1276 = ((_e1257 - _e1258) * _e1274);
                                                        let _e1278 = select(0f, _e1276, (_e1276 > 0f));
                                                        let _e1280 = ((_e1259 - _e1260) * _e1274);
                                                        let _e1282 = select(0f, _e1280, (_e1280 > 0f));
                                                        let _e1284 = ((_e1261 - _e1262) * _e1274);
                                                        let _e1286 = select(0f, _e1284, (_e1284 > 0f));
                                                        let _e1288 = ((_e1278 + _e1282) + _e1286);
                                                        if (_e1288 < 0.000000000000000000000000000000000000011754944f) {
                                                            phi_2913_ = type_22();
                                                            phi_2914_ = true;
                                                        } else {
                                                            let _e1291 = select(_e1215[1][0], _e1215[0][0], (_e1215[0][0] < _e1215[1][0]));
                                                            let _e1295 = select(_e1215[1][0], _e1215[0][0], (_e1215[0][0] > _e1215[1][0]));
                                                            let _e1299 = select(_e1215[1][1], _e1215[0][1], (_e1215[0][1] < _e1215[1][1]));
                                                            let _e1303 = select(_e1215[1][1], _e1215[0][1], (_e1215[0][1] > _e1215[1][1]));
                                                            let _e1307 = select(_e1215[1][2], _e1215[0][2], (_e1215[0][2] < _e1215[1][2]));
                                                            let _e1311 = select(_e1215[1][2], _e1215[0][2], (_e1215[0][2] > _e1215[1][2]));
                                                            let _e1316 = ((select(_e1215[2][0], _e1291, (_e1291 < _e1215[2][0])) - _e327) * _e332);
                                                            let _e1317 = ((select(_e1215[2][0], _e1295, (_e1295 > _e1215[2][0])) - _e328) * _e332);
                                                            let _e1320 = ((select(_e1215[2][1], _e1299, (_e1299 < _e1215[2][1])) - _e363) * _e368);
                                                            let _e1321 = ((select(_e1215[2][1], _e1303, (_e1303 > _e1215[2][1])) - _e364) * _e368);
                                                            let _e1324 = ((select(_e1215[2][2], _e1307, (_e1307 < _e1215[2][2])) - _e399) * _e404);
                                                            let _e1325 = ((select(_e1215[2][2], _e1311, (_e1311 > _e1215[2][2])) - _e400) * _e404);
                                                            let _e1327 = select(_e1325, _e1324, (_e1324 < _e1325));
                                                            let _e1329 = select(_e1325, _e1324, (_e1324 > _e1325));
                                                            let _e1331 = select(_e1317, _e1316, (_e1316 < _e1317));
                                                            let _e1333 = select(_e1321, _e1320, (_e1320 < _e1321));
                                                            let _e1335 = select(_e1333, _e1331, (_e1331 > _e1333));
                                                            let _e1337 = select(_e1327, _e1335, (_e1335 > _e1327));
                                                            let _e1339 = select(_e1317, _e1316, (_e1316 > _e1317));
                                                            let _e1341 = select(_e1321, _e1320, (_e1320 > _e1321));
                                                            let _e1343 = select(_e1341, _e1339, (_e1339 < _e1341));
                                                            let _e1345 = select(_e1329, _e1343, (_e1343 < _e1329));
                                                            let _e1346 = -(_e1327);
                                                            let _e1352 = select(_e450, _e1337, (_e1337 > _e450));
                                                            if (_e1352 > (_e1345 + (select(_e1346, _e1329, (_e1329 > _e1346)) * 0.0000019073523f))) {
                                                                phi_2908_ = type_22();
                                                                phi_2909_ = true;
                                                            } else {
                                                                let _e1354 = (_e1352 > _e1009.member.member_1);
                                                                if _e1354 {
                                                                    phi_2907_ = type_22();
                                                                } else {
                                                                    let _e1358 = (_e1215[1][0] - _e1215[0][0]);
                                                                    let _e1359 = (_e1215[1][1] - _e1215[0][1]);
                                                                    let _e1360 = (_e1215[1][2] - _e1215[0][2]);
                                                                    let _e1361 = vec3<f32>(_e1358, _e1359, _e1360);
                                                                    let _e1362 = (_e1215[2][0] - _e1215[1][0]);
                                                                    let _e1363 = (_e1215[2][1] - _e1215[1][1]);
                                                                    let _e1364 = (_e1215[2][2] - _e1215[1][2]);
                                                                    let _e1365 = vec3<f32>(_e1362, _e1363, _e1364);
                                                                    let _e1366 = (_e1215[0][0] - _e1215[2][0]);
                                                                    let _e1367 = (_e1215[0][1] - _e1215[2][1]);
                                                                    let _e1368 = (_e1215[0][2] - _e1215[2][2]);
                                                                    let _e1369 = vec3<f32>(_e1366, _e1367, _e1368);
                                                                    let _e1372 = bitcast<f32>((bitcast<u32>(_e1358) & 2147483647u));
                                                                    let _e1375 = bitcast<f32>((bitcast<u32>(_e1359) & 2147483647u));
                                                                    let _e1377 = select(_e1375, _e1372, (_e1372 > _e1375));
                                                                    let _e1380 = bitcast<f32>((bitcast<u32>(_e1360) & 2147483647u));
                                                                    let _e1382 = select(_e1380, _e1377, (_e1377 > _e1380));
                                                                    let _e1385 = bitcast<f32>((bitcast<u32>(_e1362) & 2147483647u));
                                                                    let _e1388 = bitcast<f32>((bitcast<u32>(_e1363) & 2147483647u));
                                                                    let _e1390 = select(_e1388, _e1385, (_e1385 > _e1388));
                                                                    let _e1393 = bitcast<f32>((bitcast<u32>(_e1364) & 2147483647u));
                                                                    let _e1395 = select(_e1393, _e1390, (_e1390 > _e1393));
                                                                    let _e1398 = bitcast<f32>((bitcast<u32>(_e1366) & 2147483647u));
                                                                    let _e1401 = bitcast<f32>((bitcast<u32>(_e1367) & 2147483647u));
                                                                    let _e1403 = select(_e1401, _e1398, (_e1398 > _e1401));
                                                                    let _e1406 = bitcast<f32>((bitcast<u32>(_e1368) & 2147483647u));
                                                                    let _e1408 = select(_e1406, _e1403, (_e1403 > _e1406));
                                                                    let _e1410 = select(_e1395, _e1382, (_e1382 > _e1395));
                                                                    let _e1412 = select(_e1408, _e1410, (_e1410 > _e1408));
                                                                    if (_e1382 == _e1412) {
                                                                        phi_2818_ = _e1365;
                                                                        phi_2819_ = _e1369;
                                                                    } else {
                                                                        let _e1415 = vec3((_e1395 == _e1412));
                                                                        phi_2818_ = select(_e1361, _e1369, _e1415);
                                                                        phi_2819_ = select(_e1365, _e1361, _e1415);
                                                                    }
                                                                    let _e1419 = phi_2818_;
                                                                    let _e1421 = phi_2819_;
                                                                    let _e1428 = ((_e1419.y * _e1421.z) - (_e1421.y * _e1419.z));
                                                                    let _e1433 = ((_e1419.z * _e1421.x) - (_e1421.z * _e1419.x));
                                                                    let _e1436 = ((_e1419.x * _e1421.y) - (_e1421.x * _e1419.y));
                                                                    if (_e1278 >= _e1282) {
                                                                        phi_2850_ = select(true, false, (_e1278 >= _e1286));
                                                                    } else {
                                                                        phi_2850_ = true;
                                                                    }
                                                                    let _e1441 = phi_2850_;
                                                                    if _e1441 {
                                                                        phi_2859_ = select(vec3<f32>(_e1215[2][0], _e1215[2][1], _e1215[2][2]), vec3<f32>(_e1215[1][0], _e1215[1][1], _e1215[1][2]), vec3((_e1282 >= _e1286)));
                                                                    } else {
                                                                        phi_2859_ = vec3<f32>(_e1215[0][0], _e1215[0][1], _e1215[0][2]);
                                                                    }
                                                                    let _e1446 = phi_2859_;
                                                                    let _e1463 = ((((_e1428 * (_e1446.x - _e304)) + (_e1433 * (_e1446.y - _e341))) + (_e1436 * (_e1446.z - _e377))) / (((_e1428 * _e329) + (_e1433 * _e365)) + (_e1436 * _e401)));
                                                                    let _e1465 = select(_e1345, _e1463, (_e1463 < _e1345));
                                                                    let _e1467 = select(_e1337, _e1465, (_e1465 > _e1337));
                                                                    if (_e1467 >= _e450) {
                                                                        let _e1469 = (_e1467 <= _e1009.member.member_1);
                                                                        if _e1469 {
                                                                            let _e1470 = (1f / _e1288);
                                                                            phi_2899_ = type_22(_e1467, (_e1282 * _e1470), (_e1286 * _e1470), _e1075);
                                                                        } else {
                                                                            phi_2899_ = type_22();
                                                                        }
                                                                        let _e1475 = phi_2899_;
                                                                        phi_2901_ = _e1475;
                                                                        phi_2902_ = select(true, false, _e1469);
                                                                    } else {
                                                                        phi_2901_ = type_22();
                                                                        phi_2902_ = true;
                                                                    }
                                                                    let _e1478 = phi_2901_;
                                                                    let _e1480 = phi_2902_;
                                                                    if _e1480 {
                                                                        phi_2906_ = type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                    } else {
                                                                        phi_2906_ = _e1478;
                                                                    }
                                                                    let _e1482 = phi_2906_;
                                                                    phi_2907_ = _e1482;
                                                                }
                                                                let _e1484 = phi_2907_;
                                                                phi_2908_ = _e1484;
                                                                phi_2909_ = _e1354;
                                                            }
                                                            let _e1486 = phi_2908_;
                                                            let _e1488 = phi_2909_;
                                                            phi_2913_ = _e1486;
                                                            phi_2914_ = _e1488;
                                                        }
                                                        let _e1490 = phi_2913_;
                                                        let _e1492 = phi_2914_;
                                                        phi_2918_ = _e1490;
                                                        phi_2919_ = _e1492;
                                                    } else {
                                                        phi_2918_ = type_22();
                                                        phi_2919_ = true;
                                                    }
                                                    let _e1494 = phi_2918_;
                                                    let _e1496 = phi_2919_;
                                                    if _e1496 {
                                                        phi_2923_ = type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                    } else {
                                                        phi_2923_ = _e1494;
                                                    }
                                                    let _e1498 = phi_2923_;
                                                    if (_e1498.member_3 != 4294967295u) {
                                                        if (_e1075 != _e456) {
                                                            if (_e1498.member < _e1009.member.member.member) {
                                                                phi_2949_ = true;
                                                            } else {
                                                                if (_e1498.member == _e1009.member.member.member) {
                                                                    phi_2948_ = (_e1498.member_3 < _e1009.member.member.member_3);
                                                                } else {
                                                                    phi_2948_ = false;
                                                                }
                                                                let _e1513 = phi_2948_;
                                                                phi_2949_ = _e1513;
                                                            }
                                                            let _e1515 = phi_2949_;
                                                            if _e1515 {
                                                                phi_2956_ = type_41(type_38(_e1498, _e1498.member), _e1036.member_1, _e1036.member_2);
                                                            } else {
                                                                phi_2956_ = _e1036;
                                                            }
                                                            let _e1522 = phi_2956_;
                                                            phi_2957_ = _e1522;
                                                        } else {
                                                            phi_2957_ = _e1036;
                                                        }
                                                        let _e1524 = phi_2957_;
                                                        phi_2958_ = _e1524;
                                                    } else {
                                                        phi_2958_ = _e1036;
                                                    }
                                                    let _e1526 = phi_2958_;
                                                    phi_4747_ = _e1214;
                                                    phi_1989_ = _e1526;
                                                } else {
                                                    phi_4747_ = _e1007;
                                                    phi_1989_ = type_41();
                                                }
                                                let _e1528 = phi_4747_;
                                                let _e1530 = phi_1989_;
                                                continue;
                                                continuing {
                                                    phi_4688_ = _e1528;
                                                    phi_1988_ = _e1530;
                                                    phi_1991_ = _e1024;
                                                    phi_4746_ = _e1528;
                                                    break if !(_e1030);
                                                }
                                            }
                                            let _e1533 = phi_4746_;
                                            phi_4805_ = _e1533;
                                            if _e1533 {
                                                break;
                                            }
                                            phi_4809_ = _e1533;
                                            let _e1775 = local_9;
                                            phi_4299_ = _e1775;
                                            phi_4300_ = _e529;
                                            phi_4301_ = false;
                                            phi_4302_ = _e533;
                                        } else {
                                            if (_e529.member_1 >= _e91) {
                                                phi_3899_ = type_55(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), type_52(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u), type_52(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u));
                                            } else {
                                                if (_e529.member_1 < _e91) {
                                                } else {
                                                    phi_4805_ = true;
                                                    break;
                                                }
                                                let _e552 = ((1u + _e272) % 4u);
                                                if (_e552 < 4u) {
                                                } else {
                                                    phi_4805_ = true;
                                                    break;
                                                }
                                                let _e557 = global_3.member[_e529.member_1][_e552];
                                                let _e559 = ((1u + _e271) % 4u);
                                                if (_e559 < 4u) {
                                                } else {
                                                    phi_4805_ = true;
                                                    break;
                                                }
                                                let _e564 = global_3.member[_e529.member_1][_e559];
                                                let _e566 = ((1u + _e273) % 4u);
                                                if (_e566 < 4u) {
                                                } else {
                                                    phi_4805_ = true;
                                                    break;
                                                }
                                                let _e571 = global_3.member[_e529.member_1][_e566];
                                                let _e573 = ((_e272 + 1u) % 4u);
                                                if (_e573 < 4u) {
                                                } else {
                                                    phi_4805_ = true;
                                                    break;
                                                }
                                                let _e578 = global_3.member[_e529.member_1][_e573];
                                                let _e580 = (_e578 >> bitcast<u32>(11u));
                                                let _e582 = ((_e271 + 1u) % 4u);
                                                if (_e582 < 4u) {
                                                } else {
                                                    phi_4805_ = true;
                                                    break;
                                                }
                                                let _e587 = global_3.member[_e529.member_1][_e582];
                                                let _e589 = (_e587 >> bitcast<u32>(11u));
                                                let _e591 = ((_e273 + 1u) % 4u);
                                                if (_e591 < 4u) {
                                                } else {
                                                    phi_4805_ = true;
                                                    break;
                                                }
                                                let _e596 = global_3.member[_e529.member_1][_e591];
                                                let _e598 = (_e596 >> bitcast<u32>(11u));
                                                let _e621 = (bitcast<f32>((bitcast<u32>((_e529.member.member_1.x - _e529.member.member.x)) & 2139095040u)) * 0.001953125f);
                                                let _e622 = (bitcast<f32>((bitcast<u32>((_e529.member.member_1.y - _e529.member.member.y)) & 2139095040u)) * 0.001953125f);
                                                let _e623 = (bitcast<f32>((bitcast<u32>((_e529.member.member_1.z - _e529.member.member.z)) & 2139095040u)) * 0.001953125f);
                                                let _e625 = select(_e146, _e621, (_e621 > _e146));
                                                let _e627 = select(_e146, _e622, (_e622 > _e146));
                                                let _e629 = select(_e146, _e623, (_e623 > _e146));
                                                let _e654 = bitcast<u32>((f32(bitcast<i32>((_e557 & 1023u))) * _e625));
                                                let _e659 = (bitcast<i32>((_e557 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                                let _e662 = bitcast<f32>((_e654 & bitcast<u32>(_e659)));
                                                let _e663 = bitcast<u32>((f32(bitcast<i32>((_e564 & 1023u))) * _e627));
                                                let _e668 = (bitcast<i32>((_e564 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                                let _e671 = bitcast<f32>((_e663 & bitcast<u32>(_e668)));
                                                let _e672 = bitcast<u32>((f32(bitcast<i32>((_e571 & 1023u))) * _e629));
                                                let _e677 = (bitcast<i32>((_e571 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                                let _e680 = bitcast<f32>((_e672 & bitcast<u32>(_e677)));
                                                let _e684 = bitcast<f32>((_e654 & bitcast<u32>(~(_e659))));
                                                let _e688 = bitcast<f32>((_e663 & bitcast<u32>(~(_e668))));
                                                let _e692 = bitcast<f32>((_e672 & bitcast<u32>(~(_e677))));
                                                let _e693 = bitcast<u32>((f32(bitcast<i32>((_e580 & 1023u))) * _e625));
                                                let _e698 = (bitcast<i32>((_e580 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                                let _e701 = bitcast<f32>((_e693 & bitcast<u32>(_e698)));
                                                let _e702 = bitcast<u32>((f32(bitcast<i32>((_e589 & 1023u))) * _e627));
                                                let _e707 = (bitcast<i32>((_e589 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                                let _e710 = bitcast<f32>((_e702 & bitcast<u32>(_e707)));
                                                let _e711 = bitcast<u32>((f32(bitcast<i32>((_e598 & 1023u))) * _e629));
                                                let _e716 = (bitcast<i32>((_e598 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                                let _e719 = bitcast<f32>((_e711 & bitcast<u32>(_e716)));
                                                let _e723 = bitcast<f32>((_e693 & bitcast<u32>(~(_e698))));
                                                let _e727 = bitcast<f32>((_e702 & bitcast<u32>(~(_e707))));
                                                let _e731 = bitcast<f32>((_e711 & bitcast<u32>(~(_e716))));
                                                let _e732 = (_e529.member.member.x + _e662);
                                                let _e733 = (_e529.member.member.y + _e671);
                                                let _e734 = (_e529.member.member.z + _e680);
                                                let _e737 = (_e529.member.member_1.x - _e701);
                                                let _e738 = (_e529.member.member_1.y - _e710);
                                                let _e739 = (_e529.member.member_1.z - _e719);
                                                let _e758 = (_e737 - _e732);
                                                let _e759 = (_e738 - _e733);
                                                let _e760 = (_e739 - _e734);
                                                let _e762 = select(_e759, _e758, (_e758 > _e759));
                                                let _e764 = select(_e760, _e762, (_e762 > _e760));
                                                if (_e764 < (1024f * _e146)) {
                                                    phi_3600_ = 0u;
                                                } else {
                                                    phi_3600_ = select(2u, 1u, (_e764 < (2097152f * _e146)));
                                                }
                                                let _e771 = phi_3600_;
                                                switch bitcast<i32>(_e771) {
                                                    case 0: {
                                                        phi_3606_ = 1u;
                                                        break;
                                                    }
                                                    case 1: {
                                                        phi_3606_ = 2u;
                                                        break;
                                                    }
                                                    case 2: {
                                                        phi_3606_ = 3u;
                                                        break;
                                                    }
                                                    default: {
                                                        phi_3606_ = u32();
                                                        break;
                                                    }
                                                }
                                                let _e774 = phi_3606_;
                                                let _e780 = global_3.member[_e529.member_1][0u];
                                                let _e784 = global_3.member[_e529.member_1][1u];
                                                let _e788 = global_3.member[_e529.member_1][2u];
                                                let _e792 = global_3.member[_e529.member_1][3u];
                                                let _e804 = (((_e784 >> bitcast<u32>(22i)) | ((_e788 >> bitcast<u32>(22i)) << bitcast<u32>(10i))) | ((_e792 >> bitcast<u32>(22i)) << bitcast<u32>(20i)));
                                                let _e805 = (_e780 & 268435455u);
                                                let _e806 = (_e804 & 268435455u);
                                                let _e809 = ((_e780 >> bitcast<u32>(28u)) & 7u);
                                                let _e817 = ((_e780 >> bitcast<u32>(31i)) | (((_e804 >> bitcast<u32>(28u)) & 3u) << bitcast<u32>(1i)));
                                                let _e818 = (_e809 != 0u);
                                                if (_e809 == 0u) {
                                                    phi_3861_ = _e805;
                                                } else {
                                                    if (_e809 == 7u) {
                                                        phi_3860_ = 2147483648u;
                                                    } else {
                                                        phi_3860_ = ((2147483648u | (_e809 << bitcast<u32>(28u))) | (_e806 & 268435455u));
                                                    }
                                                    let _e827 = phi_3860_;
                                                    phi_3861_ = _e827;
                                                }
                                                let _e829 = phi_3861_;
                                                if _e818 {
                                                    let _e830 = (_e809 != 7u);
                                                    if _e830 {
                                                        phi_3871_ = (_e806 + (_e809 * ((3u * _e774) + 1u)));
                                                    } else {
                                                        phi_3871_ = u32();
                                                    }
                                                    let _e834 = phi_3871_;
                                                    phi_3873_ = _e834;
                                                    phi_3874_ = select(true, false, _e830);
                                                } else {
                                                    phi_3873_ = u32();
                                                    phi_3874_ = true;
                                                }
                                                let _e837 = phi_3873_;
                                                let _e839 = phi_3874_;
                                                if (_e817 == 0u) {
                                                    phi_3895_ = (_e805 + select(0u, 1u, !(_e818)));
                                                } else {
                                                    if (_e817 == 7u) {
                                                        phi_3894_ = 2147483648u;
                                                    } else {
                                                        phi_3894_ = ((2147483648u | (_e817 << bitcast<u32>(28u))) | (select(_e837, _e806, _e839) & 268435455u));
                                                    }
                                                    let _e852 = phi_3894_;
                                                    phi_3895_ = _e852;
                                                }
                                                let _e854 = phi_3895_;
                                                phi_3899_ = type_55(array<vec4<f32>, 3>(vec4<f32>(_e732, (_e529.member.member.x + _e684), _e737, (_e529.member.member_1.x - _e723)), vec4<f32>(_e733, (_e529.member.member.y + _e688), _e738, (_e529.member.member_1.y - _e727)), vec4<f32>(_e734, (_e529.member.member.z + _e692), _e739, (_e529.member.member_1.z - _e731))), type_52(type_34((_e529.member.member + vec4<f32>(_e662, _e671, _e680, 0f)), (_e529.member.member_1 - vec4<f32>(_e701, _e710, _e719, 0f))), _e829), type_52(type_34((_e529.member.member + vec4<f32>(_e684, _e688, _e692, 0f)), (_e529.member.member_1 - vec4<f32>(_e723, _e727, _e731, 0f))), _e854));
                                            }
                                            let _e859 = phi_3899_;
                                            let _e872 = ((_e859.member[0].x - _e327) * _e332);
                                            let _e873 = ((_e859.member[0].y - _e327) * _e332);
                                            let _e874 = ((_e859.member[0].z - _e328) * _e332);
                                            let _e875 = ((_e859.member[0].w - _e328) * _e332);
                                            let _e885 = ((_e859.member[1].x - _e363) * _e368);
                                            let _e886 = ((_e859.member[1].y - _e363) * _e368);
                                            let _e887 = ((_e859.member[1].z - _e364) * _e368);
                                            let _e888 = ((_e859.member[1].w - _e364) * _e368);
                                            let _e898 = ((_e859.member[2].x - _e399) * _e404);
                                            let _e899 = ((_e859.member[2].y - _e399) * _e404);
                                            let _e900 = ((_e859.member[2].z - _e400) * _e404);
                                            let _e901 = ((_e859.member[2].w - _e400) * _e404);
                                            let _e903 = select(_e900, _e898, (_e898 < _e900));
                                            let _e905 = select(_e901, _e899, (_e899 < _e901));
                                            let _e907 = select(_e900, _e898, (_e898 > _e900));
                                            let _e909 = select(_e901, _e899, (_e899 > _e901));
                                            let _e911 = select(_e874, _e872, (_e872 < _e874));
                                            let _e913 = select(_e875, _e873, (_e873 < _e875));
                                            let _e915 = select(_e887, _e885, (_e885 < _e887));
                                            let _e917 = select(_e888, _e886, (_e886 < _e888));
                                            let _e919 = select(_e915, _e911, (_e911 > _e915));
                                            let _e921 = select(_e917, _e913, (_e913 > _e917));
                                            let _e923 = select(_e903, _e919, (_e919 > _e903));
                                            let _e925 = select(_e905, _e921, (_e921 > _e905));
                                            let _e927 = select(_e874, _e872, (_e872 > _e874));
                                            let _e929 = select(_e875, _e873, (_e873 > _e875));
                                            let _e931 = select(_e887, _e885, (_e885 > _e887));
                                            let _e933 = select(_e888, _e886, (_e886 > _e888));
                                            let _e935 = select(_e931, _e927, (_e927 < _e931));
                                            let _e937 = select(_e933, _e929, (_e929 < _e933));
                                            let _e942 = -(_e903);
                                            let _e943 = -(_e905);
                                            let _e950 = (select(_e907, _e935, (_e935 < _e907)) + (select(_e942, _e907, (_e907 > _e942)) * 0.0000019073523f));
                                            let _e951 = (select(_e909, _e937, (_e937 < _e909)) + (select(_e943, _e909, (_e909 > _e943)) * 0.0000019073523f));
                                            let _e953 = select(_e450, _e923, (_e923 > _e450));
                                            let _e955 = select(_e450, _e925, (_e925 > _e450));
                                            let _e960 = (_e953 <= select(_e499.member.member_1, _e950, (_e950 < _e499.member.member_1)));
                                            let _e961 = (_e955 <= select(_e499.member.member_1, _e951, (_e951 < _e499.member.member_1)));
                                            let _e962 = (_e953 <= _e955);
                                            if _e960 {
                                                if _e961 {
                                                    if _e962 {
                                                        phi_4243_ = _e859.member_2;
                                                    } else {
                                                        phi_4243_ = _e859.member_1;
                                                    }
                                                    let _e966 = phi_4243_;
                                                    let _e967 = (_e533 % 128u);
                                                    let _e968 = (_e967 < 128u);
                                                    if _e968 {
                                                    } else {
                                                        phi_4805_ = true;
                                                        break;
                                                    }
                                                    local_3[_e967] = type_52(type_34(_e966.member.member, _e966.member.member_1), _e966.member_1);
                                                    if _e968 {
                                                    } else {
                                                        phi_4805_ = true;
                                                        break;
                                                    }
                                                    local_2[_e967] = select(_e955, _e953, (_e953 > _e955));
                                                    if _e962 {
                                                        phi_4276_ = _e859.member_1;
                                                    } else {
                                                        phi_4276_ = _e859.member_2;
                                                    }
                                                    let _e983 = phi_4276_;
                                                    phi_4277_ = _e983;
                                                    phi_4278_ = (_e533 + 1u);
                                                } else {
                                                    phi_4277_ = type_52();
                                                    phi_4278_ = u32();
                                                }
                                                let _e985 = phi_4277_;
                                                let _e987 = phi_4278_;
                                                phi_4280_ = _e985;
                                                phi_4281_ = _e987;
                                                phi_4282_ = select(true, false, _e961);
                                            } else {
                                                phi_4280_ = type_52();
                                                phi_4281_ = u32();
                                                phi_4282_ = true;
                                            }
                                            let _e990 = phi_4280_;
                                            let _e992 = phi_4281_;
                                            let _e994 = phi_4282_;
                                            if _e994 {
                                                if _e960 {
                                                    phi_4291_ = _e859.member_1;
                                                } else {
                                                    phi_4291_ = _e859.member_2;
                                                }
                                                let _e998 = phi_4291_;
                                                phi_4296_ = _e998;
                                                phi_4297_ = select(_e961, true, _e960);
                                            } else {
                                                phi_4296_ = _e990;
                                                phi_4297_ = _e531;
                                            }
                                            let _e1001 = phi_4296_;
                                            let _e1003 = phi_4297_;
                                            phi_4809_ = _e497;
                                            phi_4299_ = type_41(_e499.member, (_e499.member_1 + 1u), _e499.member_2);
                                            phi_4300_ = _e1001;
                                            phi_4301_ = _e1003;
                                            phi_4302_ = select(_e992, _e533, _e994);
                                        }
                                        let _e1535 = phi_4809_;
                                        let _e1537 = phi_4299_;
                                        let _e1539 = phi_4300_;
                                        let _e1541 = phi_4301_;
                                        let _e1543 = phi_4302_;
                                        phi_4808_ = _e1535;
                                        phi_4303_ = _e1537;
                                        phi_4304_ = _e1539;
                                        phi_4305_ = (_e503 - 1u);
                                        phi_4306_ = _e1541;
                                        phi_4307_ = _e1543;
                                    } else {
                                        phi_4808_ = _e497;
                                        phi_4303_ = _e499;
                                        phi_4304_ = _e529;
                                        phi_4305_ = _e503;
                                        phi_4306_ = _e531;
                                        phi_4307_ = _e533;
                                    }
                                    let _e1545 = phi_4808_;
                                    let _e1547 = phi_4303_;
                                    let _e1549 = phi_4304_;
                                    let _e1551 = phi_4305_;
                                    let _e1553 = phi_4306_;
                                    let _e1555 = phi_4307_;
                                    phi_4807_ = _e1545;
                                    phi_4308_ = _e1547;
                                    phi_4309_ = _e1549;
                                    phi_4310_ = _e1551;
                                    phi_4311_ = _e1553;
                                    phi_4312_ = _e1555;
                                } else {
                                    phi_4807_ = _e497;
                                    phi_4308_ = type_41();
                                    phi_4309_ = type_52();
                                    phi_4310_ = u32();
                                    phi_4311_ = bool();
                                    phi_4312_ = u32();
                                }
                                let _e1557 = phi_4807_;
                                let _e1559 = phi_4308_;
                                let _e1561 = phi_4309_;
                                let _e1563 = phi_4310_;
                                let _e1565 = phi_4311_;
                                let _e1567 = phi_4312_;
                                phi_4806_ = _e1557;
                                phi_1911_ = _e1559;
                                phi_1914_ = _e1561;
                                phi_1916_ = _e1563;
                                phi_1918_ = _e1565;
                                phi_1920_ = _e1567;
                                phi_4313_ = _e511;
                            } else {
                                phi_4806_ = _e497;
                                phi_1911_ = type_41();
                                phi_1914_ = type_52();
                                phi_1916_ = u32();
                                phi_1918_ = bool();
                                phi_1920_ = u32();
                                phi_4313_ = false;
                            }
                            let _e1569 = phi_4806_;
                            let _e1571 = phi_1911_;
                            let _e1573 = phi_1914_;
                            let _e1575 = phi_1916_;
                            let _e1577 = phi_1918_;
                            let _e1579 = phi_1920_;
                            let _e1581 = phi_4313_;
                            continue;
                            continuing {
                                phi_4691_ = _e1569;
                                phi_1910_ = _e1571;
                                phi_1913_ = _e1573;
                                phi_1915_ = _e1575;
                                phi_1917_ = _e1577;
                                phi_1919_ = _e1579;
                                phi_4805_ = _e1569;
                                break if !(_e1581);
                            }
                        }
                        let _e1584 = phi_4805_;
                        if _e1584 {
                            break;
                        }
                        let _e1586 = local_7;
                        if (_e1586.member.member.member_3 != 4294967295u) {
                            let _e1592 = (_e274 / 3i);
                            let _e1599 = bitcast<f32>((bitcast<u32>((_e1592 + 127i)) << bitcast<u32>(23i)));
                            let _e1607 = (((_e1586.member.member.member * _e1599) * _e1599) * bitcast<f32>((bitcast<u32>(((_e274 - (2i * _e1592)) + 127i)) << bitcast<u32>(23i))));
                            let _e1609 = select(340282350000000000000000000000000000000f, _e1607, (_e1607 < 340282350000000000000000000000000000000f));
                            phi_4365_ = type_22(select(-340282350000000000000000000000000000000f, _e1609, (_e1609 > -340282350000000000000000000000000000000f)), _e1586.member.member.member_1, _e1586.member.member.member_2, _e1586.member.member.member_3);
                        } else {
                            phi_4365_ = type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                        }
                        let _e1616 = phi_4365_;
                        if _e150 {
                        } else {
                            break;
                        }
                        global_1.member[_e134] = _e1616;
                        let _e1620 = local_8;
                        if _e151 {
                        } else {
                            break;
                        }
                        global_5.member[_e134] = _e1620.member_1;
                        if _e149 {
                        } else {
                            break;
                        }
                        let _e1625 = select(0u, 1u, (_e218 <= _e228));
                        if (_e1625 > 0u) {
                            let _e1627 = (1u < _e102);
                            if _e1627 {
                                if (0u < _e102) {
                                } else {
                                    break;
                                }
                                let _e1631 = atomicAdd((&global_6.member[0u]), _e1625);
                                if ((_e1631 + _e1625) < _e1631) {
                                    if _e1627 {
                                    } else {
                                        break;
                                    }
                                    let _e1636 = atomicAdd((&global_6.member[1u]), 1u);
                                }
                            }
                        }
                        let _e1639 = select(0u, 1u, (_e1616.member_3 != 4294967295u));
                        if (_e1639 > 0u) {
                            let _e1641 = (3u < _e102);
                            if _e1641 {
                                if (2u < _e102) {
                                } else {
                                    break;
                                }
                                let _e1645 = atomicAdd((&global_6.member[2u]), _e1639);
                                if ((_e1645 + _e1639) < _e1645) {
                                    if _e1641 {
                                    } else {
                                        break;
                                    }
                                    let _e1650 = atomicAdd((&global_6.member[3u]), 1u);
                                }
                            }
                        }
                        if (_e1620.member_1 > 0u) {
                            let _e1652 = (5u < _e102);
                            if _e1652 {
                                if (4u < _e102) {
                                } else {
                                    break;
                                }
                                let _e1656 = atomicAdd((&global_6.member[4u]), _e1620.member_1);
                                if ((_e1656 + _e1620.member_1) < _e1656) {
                                    if _e1652 {
                                    } else {
                                        break;
                                    }
                                    let _e1661 = atomicAdd((&global_6.member[5u]), 1u);
                                }
                            }
                        }
                    }
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn trace_paths_counted_q10_lattice(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
