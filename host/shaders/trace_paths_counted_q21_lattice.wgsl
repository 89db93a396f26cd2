struct type_4 {
    member: array<u32>,
}

struct type_8 {
    member: u32,
    member_1: u32,
}

struct type_18 {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: u32,
}

struct type_20 {
    member: array<type_18>,
}

struct type_22 {
    member: array<f32, 3>,
    member_1: f32,
    member_2: array<f32, 3>,
    member_3: f32,
}

struct type_23 {
    member: type_22,
    member_1: array<f32, 3>,
    member_2: u32,
    member_3: array<f32, 3>,
    member_4: u32,
}

struct type_25 {
    member: array<type_23>,
}

struct type_30 {
    member: vec4<f32>,
    member_1: vec4<f32>,
}

struct type_34 {
    member: type_18,
    member_1: f32,
}

struct type_37 {
    member: type_34,
    member_1: u32,
    member_2: u32,
}

struct type_39 {
    member: array<vec4<u32>, 2>,
}

struct type_46 {
    member: array<array<u32, 7>>,
}

struct type_52 {
    member: type_30,
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
var<storage, read_write> global_1: type_20;
@group(0) @binding(0) 
var<uniform> global_2: type_39;
@group(0) @binding(3) 
var<storage> global_3: type_25;
@group(0) @binding(5) 
var<storage, read_write> global_4: type_4;
@group(0) @binding(6) 
var<storage, read_write> global_5: type_62;
@group(0) @binding(1) 
var<storage> global_6: type_46;
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
    var phi_1910_: type_37;
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
    var phi_1988_: type_37;
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
    var phi_2899_: type_18;
    var phi_2901_: type_18;
    var phi_2902_: bool;
    var phi_2906_: type_18;
    var phi_2907_: type_18;
    var phi_2908_: type_18;
    var phi_2909_: bool;
    var phi_2913_: type_18;
    var phi_2914_: bool;
    var phi_2918_: type_18;
    var phi_2919_: bool;
    var phi_2923_: type_18;
    var phi_2948_: bool;
    var phi_2949_: bool;
    var phi_2956_: type_37;
    var phi_2957_: type_37;
    var phi_2958_: type_37;
    var phi_4747_: bool;
    var phi_1989_: type_37;
    var phi_4746_: bool;
    var phi_4809_: bool;
    var phi_4299_: type_37;
    var phi_4300_: type_52;
    var phi_4301_: bool;
    var phi_4302_: u32;
    var phi_4808_: bool;
    var phi_4303_: type_37;
    var phi_4304_: type_52;
    var phi_4305_: u32;
    var phi_4306_: bool;
    var phi_4307_: u32;
    var phi_4807_: bool;
    var phi_4308_: type_37;
    var phi_4309_: type_52;
    var phi_4310_: u32;
    var phi_4311_: bool;
    var phi_4312_: u32;
    var phi_4806_: bool;
    var phi_1911_: type_37;
    var phi_1914_: type_52;
    var phi_1916_: u32;
    var phi_1918_: bool;
    var phi_1920_: u32;
    var phi_4313_: bool;
    var phi_4805_: bool;
    var local_7: type_37;
    var phi_4365_: type_18;
    var local_8: type_37;
    var local_9: type_37;

    switch bitcast<i32>(0u) {
        default: {
            let _e88 = global;
            let _e90 = arrayLength((&global_6.member));
            let _e93 = arrayLength((&global_7.member));
            let _e101 = arrayLength((&global_5.member));
            let _e105 = global_2.member[0u][0u];
            let _e109 = global_2.member[0u][1u];
            let _e113 = global_2.member[0u][2u];
            let _e117 = global_2.member[0u][3u];
            let _e121 = global_2.member[1u][0u];
            let _e125 = global_2.member[1u][1u];
            let _e129 = global_2.member[1u][2u];
            let _e133 = (_e88.x + (_e88.y * 2097152u));
            let _e145 = bitcast<f32>((bitcast<u32>((bitcast<i32>(_e117) + 127i)) << bitcast<u32>(23i)));
            local_1 = array<i32, 3>(bitcast<i32>(_e105), bitcast<i32>(_e109), bitcast<i32>(_e113));
            local = array<i32, 3>(bitcast<i32>(_e121), bitcast<i32>(_e125), bitcast<i32>(_e129));
            let _e148 = (_e133 < arrayLength((&global_3.member)));
            if _e148 {
                let _e149 = (_e133 < arrayLength((&global_1.member)));
                if _e149 {
                    let _e150 = (_e133 < arrayLength((&global_4.member)));
                    if _e150 {
                        if _e148 {
                        } else {
                            break;
                        }
                        let _e160 = global_3.member[_e133].member.member_2[0u];
                        let _e162 = (bitcast<u32>(_e160) & 2147483647u);
                        let _e168 = global_3.member[_e133].member.member_2[1u];
                        let _e170 = (bitcast<u32>(_e168) & 2147483647u);
                        let _e176 = global_3.member[_e133].member.member_2[2u];
                        let _e178 = (bitcast<u32>(_e176) & 2147483647u);
                        let _e184 = global_3.member[_e133].member.member[0u];
                        let _e186 = (bitcast<u32>(_e184) & 2147483647u);
                        let _e192 = global_3.member[_e133].member.member[1u];
                        let _e194 = (bitcast<u32>(_e192) & 2147483647u);
                        let _e200 = global_3.member[_e133].member.member[2u];
                        let _e202 = (bitcast<u32>(_e200) & 2147483647u);
                        let _e204 = select(_e170, _e162, (_e170 < _e162));
                        let _e206 = select(_e178, _e204, (_e178 < _e204));
                        let _e208 = select(_e186, _e206, (_e186 < _e206));
                        let _e210 = select(_e194, _e208, (_e194 < _e208));
                        let _e212 = select(_e202, _e210, (_e202 < _e210));
                        let _e217 = global_3.member[_e133].member.member_1;
                        let _e219 = (bitcast<u32>(_e217) & 2147483647u);
                        let _e227 = global_3.member[_e133].member.member_3;
                        let _e233 = (((select(_e219, _e212, (_e219 < _e212)) < 2139095040u) && ((bitcast<u32>(_e227) & 2147483647u) <= 2139095040u)) && (_e206 > 0u));
                        if _e233 {
                            let _e236 = (bitcast<u32>(bitcast<f32>(_e206)) & 2147483647u);
                            if (_e236 >= 8388608u) {
                                phi_411_ = (bitcast<i32>((_e236 >> bitcast<u32>(23i))) - 127i);
                            } else {
                                phi_411_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e236)), 32u, (_e236 == 0u))));
                            }
                            let _e250 = phi_411_;
                            phi_412_ = _e250;
                        } else {
                            phi_412_ = 0i;
                        }
                        let _e252 = phi_412_;
                        let _e253 = (_e162 == _e206);
                        if _e253 {
                            phi_422_ = true;
                        } else {
                            phi_422_ = (_e170 == _e206);
                        }
                        let _e256 = phi_422_;
                        let _e257 = select(1u, 0u, _e253);
                        if _e256 {
                            let _e258 = (_e257 + 1u);
                            phi_432_ = _e258;
                            phi_433_ = _e258;
                            phi_435_ = select(true, false, (_e258 == 2u));
                        } else {
                            phi_432_ = u32();
                            phi_433_ = 0u;
                            phi_435_ = true;
                        }
                        let _e262 = phi_432_;
                        let _e264 = phi_433_;
                        let _e266 = phi_435_;
                        if _e266 {
                            phi_440_ = (_e264 + 1u);
                        } else {
                            phi_440_ = 0u;
                        }
                        let _e270 = phi_440_;
                        let _e271 = select(_e262, _e264, _e266);
                        let _e272 = select(_e257, select(2u, _e257, _e256), _e266);
                        let _e273 = -(_e252);
                        if (_e273 < -126i) {
                            phi_473_ = -126i;
                        } else {
                            phi_473_ = select(_e273, 127i, (_e273 > 127i));
                        }
                        let _e278 = phi_473_;
                        let _e283 = bitcast<f32>((bitcast<u32>((_e278 + 127i)) << bitcast<u32>(23i)));
                        let _e289 = bitcast<f32>((bitcast<u32>(((_e273 - _e278) + 127i)) << bitcast<u32>(23i)));
                        let _e294 = global_3.member[_e133].member.member;
                        let _e295 = (_e271 == 0u);
                        if _e295 {
                            phi_491_ = _e294[0];
                        } else {
                            phi_491_ = _e294[1];
                        }
                        let _e299 = phi_491_;
                        let _e300 = (_e271 == 2u);
                        if _e300 {
                            phi_497_ = _e294[2];
                        } else {
                            phi_497_ = _e299;
                        }
                        let _e303 = phi_497_;
                        let _e304 = global_3.member[_e133].member.member_2;
                        if _e295 {
                            phi_508_ = _e304[0];
                        } else {
                            phi_508_ = _e304[1];
                        }
                        let _e308 = phi_508_;
                        if _e300 {
                            phi_514_ = _e304[2];
                        } else {
                            phi_514_ = _e308;
                        }
                        let _e311 = phi_514_;
                        let _e313 = ((_e311 * _e283) * _e289);
                        let _e317 = (bitcast<f32>((bitcast<u32>(_e313) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e317 {
                            let _e321 = (bitcast<f32>((bitcast<u32>(_e303) & 2147483647u)) * 0.00000011920929f);
                            phi_537_ = select(0.00000000000011368684f, _e321, (_e321 > 0.00000000000011368684f));
                        } else {
                            phi_537_ = 0f;
                        }
                        let _e325 = phi_537_;
                        let _e326 = (_e303 + _e325);
                        let _e327 = (_e303 - _e325);
                        let _e328 = select(_e313, 0f, _e317);
                        if _e317 {
                            phi_548_ = 38685626000000000000000000f;
                        } else {
                            phi_548_ = (1f / _e313);
                        }
                        let _e331 = phi_548_;
                        let _e332 = (_e270 == 0u);
                        if _e332 {
                            phi_557_ = _e294[0];
                        } else {
                            phi_557_ = _e294[1];
                        }
                        let _e336 = phi_557_;
                        let _e337 = (_e270 == 2u);
                        if _e337 {
                            phi_563_ = _e294[2];
                        } else {
                            phi_563_ = _e336;
                        }
                        let _e340 = phi_563_;
                        if _e332 {
                            phi_574_ = _e304[0];
                        } else {
                            phi_574_ = _e304[1];
                        }
                        let _e344 = phi_574_;
                        if _e337 {
                            phi_580_ = _e304[2];
                        } else {
                            phi_580_ = _e344;
                        }
                        let _e347 = phi_580_;
                        let _e349 = ((_e347 * _e283) * _e289);
                        let _e353 = (bitcast<f32>((bitcast<u32>(_e349) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e353 {
                            let _e357 = (bitcast<f32>((bitcast<u32>(_e340) & 2147483647u)) * 0.00000011920929f);
                            phi_603_ = select(0.00000000000011368684f, _e357, (_e357 > 0.00000000000011368684f));
                        } else {
                            phi_603_ = 0f;
                        }
                        let _e361 = phi_603_;
                        let _e362 = (_e340 + _e361);
                        let _e363 = (_e340 - _e361);
                        let _e364 = select(_e349, 0f, _e353);
                        if _e353 {
                            phi_614_ = 38685626000000000000000000f;
                        } else {
                            phi_614_ = (1f / _e349);
                        }
                        let _e367 = phi_614_;
                        let _e368 = (_e272 == 0u);
                        if _e368 {
                            phi_623_ = _e294[0];
                        } else {
                            phi_623_ = _e294[1];
                        }
                        let _e372 = phi_623_;
                        let _e373 = (_e272 == 2u);
                        if _e373 {
                            phi_629_ = _e294[2];
                        } else {
                            phi_629_ = _e372;
                        }
                        let _e376 = phi_629_;
                        if _e368 {
                            phi_640_ = _e304[0];
                        } else {
                            phi_640_ = _e304[1];
                        }
                        let _e380 = phi_640_;
                        if _e373 {
                            phi_646_ = _e304[2];
                        } else {
                            phi_646_ = _e380;
                        }
                        let _e383 = phi_646_;
                        let _e385 = ((_e383 * _e283) * _e289);
                        let _e389 = (bitcast<f32>((bitcast<u32>(_e385) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e389 {
                            let _e393 = (bitcast<f32>((bitcast<u32>(_e376) & 2147483647u)) * 0.00000011920929f);
                            phi_669_ = select(0.00000000000011368684f, _e393, (_e393 > 0.00000000000011368684f));
                        } else {
                            phi_669_ = 0f;
                        }
                        let _e397 = phi_669_;
                        let _e398 = (_e376 + _e397);
                        let _e399 = (_e376 - _e397);
                        let _e400 = select(_e385, 0f, _e389);
                        if _e389 {
                            phi_680_ = 38685626000000000000000000f;
                        } else {
                            phi_680_ = (1f / _e385);
                        }
                        let _e403 = phi_680_;
                        let _e406 = bitcast<f32>((bitcast<u32>(_e303) & 2147483647u));
                        let _e409 = bitcast<f32>((bitcast<u32>(_e340) & 2147483647u));
                        let _e411 = select(_e409, _e406, (_e406 > _e409));
                        let _e414 = bitcast<f32>((bitcast<u32>(_e376) & 2147483647u));
                        if (_e233 && (select(_e414, _e411, (_e411 > _e414)) <= 1099511600000f)) {
                            let _e419 = (_e252 / 3i);
                            let _e426 = bitcast<f32>((bitcast<u32>((_e419 + 127i)) << bitcast<u32>(23i)));
                            let _e433 = bitcast<f32>((bitcast<u32>(((_e252 - (2i * _e419)) + 127i)) << bitcast<u32>(23i)));
                            let _e434 = (((_e217 * _e426) * _e426) * _e433);
                            let _e436 = select(340282350000000000000000000000000000000f, _e434, (_e434 < 340282350000000000000000000000000000000f));
                            let _e441 = (((_e227 * _e426) * _e426) * _e433);
                            let _e443 = select(340282350000000000000000000000000000000f, _e441, (_e441 < 340282350000000000000000000000000000000f));
                            phi_780_ = select(-340282350000000000000000000000000000000f, _e443, (_e443 > -340282350000000000000000000000000000000f));
                            phi_781_ = select(-340282350000000000000000000000000000000f, _e436, (_e436 > -340282350000000000000000000000000000000f));
                        } else {
                            phi_780_ = 0f;
                            phi_781_ = 1f;
                        }
                        let _e447 = phi_780_;
                        let _e449 = phi_781_;
                        if _e148 {
                        } else {
                            break;
                        }
                        let _e455 = global_3.member[_e133].member_2;
                        local_3 = array<type_52, 128>(type_52(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u));
                        local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        let _e458 = (_e271 % 3u);
                        let _e459 = (_e458 < 3u);
                        if _e459 {
                        } else {
                            break;
                        }
                        let _e461 = local_1[_e458];
                        let _e464 = (_e270 % 3u);
                        let _e465 = (_e464 < 3u);
                        if _e465 {
                        } else {
                            break;
                        }
                        let _e467 = local_1[_e464];
                        let _e470 = (_e272 % 3u);
                        let _e471 = (_e470 < 3u);
                        if _e471 {
                        } else {
                            break;
                        }
                        let _e473 = local_1[_e470];
                        if _e459 {
                        } else {
                            break;
                        }
                        let _e478 = local[_e458];
                        if _e465 {
                        } else {
                            break;
                        }
                        let _e482 = local[_e464];
                        if _e471 {
                        } else {
                            break;
                        }
                        let _e486 = local[_e470];
                        phi_4691_ = false;
                        phi_1910_ = type_37(type_34(type_18(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e447), 0u, 0u);
                        phi_1913_ = type_52(type_30(vec4<f32>((f32(_e461) * _e145), (f32(_e467) * _e145), (f32(_e473) * _e145), 0f), vec4<f32>((f32(_e478) * _e145), (f32(_e482) * _e145), (f32(_e486) * _e145), 0f)), select(0u, 2147483648u, (_e90 == 0u)));
                        phi_1915_ = ((3u * _e90) + 1u);
                        phi_1917_ = (_e449 <= _e447);
                        phi_1919_ = 0u;
                        loop {
                            let _e496 = phi_4691_;
                            let _e498 = phi_1910_;
                            let _e500 = phi_1913_;
                            let _e502 = phi_1915_;
                            let _e504 = phi_1917_;
                            let _e506 = phi_1919_;
                            local_7 = _e498;
                            local_8 = _e498;
                            if _e504 {
                                phi_1930_ = true;
                            } else {
                                phi_1930_ = (_e506 > 0u);
                            }
                            let _e509 = phi_1930_;
                            if _e509 {
                                let _e510 = (_e502 > 0u);
                                if _e510 {
                                    if _e504 {
                                        phi_1967_ = _e500;
                                        phi_1968_ = _e504;
                                        phi_1969_ = _e506;
                                    } else {
                                        let _e511 = (_e506 - 1u);
                                        let _e512 = (_e511 % 128u);
                                        let _e513 = (_e512 < 128u);
                                        if _e513 {
                                        } else {
                                            phi_4805_ = true;
                                            break;
                                        }
                                        let _e515 = local_3[_e512];
                                        if _e513 {
                                        } else {
                                            phi_4805_ = true;
                                            break;
                                        }
                                        let _e523 = local_2[_e512];
                                        phi_1967_ = type_52(type_30(_e515.member.member, _e515.member.member_1), _e515.member_1);
                                        phi_1968_ = (_e523 <= _e498.member.member_1);
                                        phi_1969_ = _e511;
                                    }
                                    let _e528 = phi_1967_;
                                    let _e530 = phi_1968_;
                                    let _e532 = phi_1969_;
                                    if _e530 {
                                        let _e537 = (_e528.member_1 & 268435455u);
                                        if ((_e528.member_1 & 2147483648u) != 0u) {
                                            phi_4688_ = _e496;
                                            phi_1988_ = _e498;
                                            phi_1991_ = type_8(0u, ((_e528.member_1 >> bitcast<u32>(28u)) & 7u));
                                            loop {
                                                let _e1006 = phi_4688_;
                                                let _e1008 = phi_1988_;
                                                let _e1010 = phi_1991_;
                                                local_9 = _e1008;
                                                if (_e1010.member < _e1010.member_1) {
                                                    phi_1992_ = type_8((_e1010.member + 1u), _e1010.member_1);
                                                    phi_2014_ = type_8(1u, _e1010.member);
                                                } else {
                                                    phi_1992_ = _e1010;
                                                    phi_2014_ = type_8(0u, type_8().member_1);
                                                }
                                                let _e1023 = phi_1992_;
                                                let _e1025 = phi_2014_;
                                                let _e1029 = (bitcast<i32>(_e1025.member) != 0i);
                                                if _e1029 {
                                                    let _e1035 = type_37(_e1008.member, _e1008.member_1, (_e1008.member_2 + 1u));
                                                    let _e1040 = (_e528.member.member_1.x - _e528.member.member.x);
                                                    let _e1043 = (_e528.member.member_1.y - _e528.member.member.y);
                                                    let _e1046 = (_e528.member.member_1.z - _e528.member.member.z);
                                                    let _e1048 = select(_e1043, _e1040, (_e1040 > _e1043));
                                                    let _e1050 = select(_e1046, _e1048, (_e1048 > _e1046));
                                                    let _e1052 = (_e1050 < (1024f * _e145));
                                                    if _e1052 {
                                                        phi_2058_ = 0u;
                                                    } else {
                                                        phi_2058_ = select(2u, 1u, (_e1050 < (2097152f * _e145)));
                                                    }
                                                    let _e1057 = phi_2058_;
                                                    switch bitcast<i32>(_e1057) {
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
                                                    let _e1060 = phi_2064_;
                                                    switch bitcast<i32>(_e1057) {
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
                                                    let _e1067 = phi_2074_;
                                                    let _e1069 = ((_e537 + (_e1025.member_1 * ((3u * _e1060) + 1u))) + (3u * _e1067));
                                                    let _e1070 = (_e1069 < _e93);
                                                    if _e1070 {
                                                        if _e1070 {
                                                        } else {
                                                            phi_4746_ = true;
                                                            break;
                                                        }
                                                        let _e1072 = global_7.member[_e1069];
                                                        phi_2090_ = _e1072;
                                                    } else {
                                                        phi_2090_ = 4294967295u;
                                                    }
                                                    let _e1074 = phi_2090_;
                                                    local_4 = array<u32, 3>(_e271, _e270, _e272);
                                                    if _e1052 {
                                                        phi_2127_ = 0u;
                                                    } else {
                                                        phi_2127_ = select(2u, 1u, (_e1050 < (2097152f * _e145)));
                                                    }
                                                    let _e1080 = phi_2127_;
                                                    switch bitcast<i32>(_e1080) {
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
                                                    let _e1083 = phi_2133_;
                                                    switch bitcast<i32>(_e1080) {
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
                                                    let _e1090 = phi_2143_;
                                                    local_6 = array<f32, 4>(_e528.member.member.x, _e528.member.member.y, _e528.member.member.z, _e528.member.member.w);
                                                    local_5[0u] = array<f32, 3>(0f, 0f, 0f);
                                                    local_5[1u] = array<f32, 3>(0f, 0f, 0f);
                                                    local_5[2u] = array<f32, 3>(0f, 0f, 0f);
                                                    phi_4673_ = _e1006;
                                                    phi_2159_ = type_8(0u, 3u);
                                                    loop {
                                                        let _e1104 = phi_4673_;
                                                        let _e1106 = phi_2159_;
                                                        if (_e1106.member < _e1106.member_1) {
                                                            phi_2160_ = type_8((_e1106.member + 1u), _e1106.member_1);
                                                            phi_2183_ = type_8(1u, _e1106.member);
                                                        } else {
                                                            phi_2160_ = _e1106;
                                                            phi_2183_ = type_8(0u, type_8().member_1);
                                                        }
                                                        let _e1119 = phi_2160_;
                                                        let _e1121 = phi_2183_;
                                                        let _e1125 = (bitcast<i32>(_e1121.member) != 0i);
                                                        if _e1125 {
                                                            let _e1127 = ((_e537 + (_e1025.member_1 * ((3u * _e1083) + 1u))) + (_e1121.member_1 * _e1090));
                                                            let _e1128 = (_e1127 < _e93);
                                                            if _e1128 {
                                                                if _e1128 {
                                                                } else {
                                                                    phi_4744_ = true;
                                                                    break;
                                                                }
                                                                let _e1130 = global_7.member[_e1127];
                                                                phi_2206_ = _e1130;
                                                            } else {
                                                                phi_2206_ = 0u;
                                                            }
                                                            let _e1132 = phi_2206_;
                                                            let _e1133 = (_e1127 + 1u);
                                                            let _e1134 = (_e1133 < _e93);
                                                            if _e1134 {
                                                                if _e1134 {
                                                                } else {
                                                                    phi_4744_ = true;
                                                                    break;
                                                                }
                                                                let _e1136 = global_7.member[_e1133];
                                                                phi_2221_ = _e1136;
                                                            } else {
                                                                phi_2221_ = 0u;
                                                            }
                                                            let _e1138 = phi_2221_;
                                                            phi_2224_ = type_8(0u, 3u);
                                                            loop {
                                                                let _e1140 = phi_2224_;
                                                                if (_e1140.member < _e1140.member_1) {
                                                                    phi_2225_ = type_8((_e1140.member + 1u), _e1140.member_1);
                                                                    phi_2248_ = type_8(1u, _e1140.member);
                                                                } else {
                                                                    phi_2225_ = _e1140;
                                                                    phi_2248_ = type_8(0u, type_8().member_1);
                                                                }
                                                                let _e1153 = phi_2225_;
                                                                let _e1155 = phi_2248_;
                                                                let _e1159 = (bitcast<i32>(_e1155.member) != 0i);
                                                                if _e1159 {
                                                                    let _e1160 = (_e1155.member_1 < 3u);
                                                                    if _e1160 {
                                                                    } else {
                                                                        phi_4666_ = true;
                                                                        break;
                                                                    }
                                                                    let _e1162 = local_4[_e1155.member_1];
                                                                    if (_e1155.member_1 < 4u) {
                                                                    } else {
                                                                        phi_4666_ = true;
                                                                        break;
                                                                    }
                                                                    let _e1165 = local_6[_e1155.member_1];
                                                                    switch bitcast<i32>(_e1080) {
                                                                        case 0: {
                                                                            phi_2318_ = (_e1165 + (f32(((_e1132 >> bitcast<u32>(((10u * _e1162) & 31u))) & 1023u)) * _e145));
                                                                            break;
                                                                        }
                                                                        case 1: {
                                                                            if (_e1162 == 0u) {
                                                                                phi_2295_ = _e1132;
                                                                            } else {
                                                                                if (_e1162 == 1u) {
                                                                                    phi_2294_ = ((_e1132 >> bitcast<u32>(21i)) | (_e1138 << bitcast<u32>(11i)));
                                                                                } else {
                                                                                    phi_2294_ = (_e1138 >> bitcast<u32>(10i));
                                                                                }
                                                                                let _e1186 = phi_2294_;
                                                                                phi_2295_ = _e1186;
                                                                            }
                                                                            let _e1188 = phi_2295_;
                                                                            phi_2318_ = (_e1165 + (f32((_e1188 & 2097151u)) * _e145));
                                                                            break;
                                                                        }
                                                                        case 2: {
                                                                            let _e1167 = (_e1127 + _e1162);
                                                                            let _e1168 = (_e1167 < _e93);
                                                                            if _e1168 {
                                                                                if _e1168 {
                                                                                } else {
                                                                                    phi_4666_ = true;
                                                                                    break;
                                                                                }
                                                                                let _e1170 = global_7.member[_e1167];
                                                                                phi_2314_ = _e1170;
                                                                            } else {
                                                                                phi_2314_ = 0u;
                                                                            }
                                                                            let _e1172 = phi_2314_;
                                                                            phi_2318_ = (f32(bitcast<i32>(_e1172)) * _e145);
                                                                            break;
                                                                        }
                                                                        default: {
                                                                            phi_2318_ = f32();
                                                                            break;
                                                                        }
                                                                    }
                                                                    let _e1202 = phi_2318_;
                                                                    if (_e1121.member_1 < 3u) {
                                                                    } else {
                                                                        phi_4666_ = true;
                                                                        break;
                                                                    }
                                                                    if _e1160 {
                                                                    } else {
                                                                        phi_4666_ = true;
                                                                        break;
                                                                    }
                                                                    local_5[_e1121.member_1][_e1155.member_1] = _e1202;
                                                                }
                                                                continue;
                                                                continuing {
                                                                    phi_2224_ = _e1153;
                                                                    phi_4666_ = _e1104;
                                                                    break if !(_e1159);
                                                                }
                                                            }
                                                            let _e1208 = phi_4666_;
                                                            phi_4744_ = _e1208;
                                                            if _e1208 {
                                                                break;
                                                            }
                                                            phi_4745_ = _e1208;
                                                        } else {
                                                            phi_4745_ = _e1104;
                                                        }
                                                        let _e1210 = phi_4745_;
                                                        continue;
                                                        continuing {
                                                            phi_4673_ = _e1210;
                                                            phi_2159_ = _e1119;
                                                            phi_4744_ = _e1210;
                                                            break if !(_e1125);
                                                        }
                                                    }
                                                    let _e1213 = phi_4744_;
                                                    phi_4746_ = _e1213;
                                                    if _e1213 {
                                                        break;
                                                    }
                                                    let _e1214 = local_5;
                                                    let _e1231 = (_e1214[0][2] - _e376);
                                                    let _e1234 = (((_e1214[0][0] - _e303) * _e400) - (_e1231 * _e328));
                                                    let _e1237 = (((_e1214[0][1] - _e340) * _e400) - (_e1231 * _e364));
                                                    let _e1240 = (_e1214[1][2] - _e376);
                                                    let _e1243 = (((_e1214[1][0] - _e303) * _e400) - (_e1240 * _e328));
                                                    let _e1246 = (((_e1214[1][1] - _e340) * _e400) - (_e1240 * _e364));
                                                    let _e1249 = (_e1214[2][2] - _e376);
                                                    let _e1252 = (((_e1214[2][0] - _e303) * _e400) - (_e1249 * _e328));
                                                    let _e1255 = (((_e1214[2][1] - _e340) * _e400) - (_e1249 * _e364));
                                                    let _e1256 = (_e1252 * _e1246);
                                                    let _e1257 = (_e1255 * _e1243);
                                                    let _e1258 = (_e1234 * _e1255);
                                                    let _e1259 = (_e1237 * _e1252);
                                                    let _e1260 = (_e1243 * _e1237);
                                                    let _e1261 = (_e1246 * _e1234);
                                                    let _e1266 = (((_e1256 >= _e1257) && (_e1258 >= _e1259)) && (_e1260 >= _e1261));
                                                    if (_e1266 || (((_e1256 <= _e1257) && (_e1258 <= _e1259)) && (_e1260 <= _e1261))) {
                                                        let _e1273 = select(-1f, 1f, _e1266);
                                                        let _e1275 = ((_e1256 - _e1257) * _e1273);
                                                        let _e1277 = select(0f, _e1275, (_e1275 > 0f));
                                                        let _e1279 = ((_e1258 - _e1259) * _e1273);
                                                        let _e1281 = select(0f, _e1279, (_e1279 > 0f));
                                                        let _e1283 = ((_e1260 - _e1261) * _e1273);
                                                        let _e1285 = select(0f, _e1283, (_e1283 > 0f));
                                                        let _e1287 = ((_e1277 + _e1281) + _e1285);
                                                        if (_e1287 < 0.000000000000000000000000000000000000011754944f) {
                                                            phi_2913_ = type_18();
                                                            phi_2914_ = true;
                                                        } else {
                                                            let _e1290 = select(_e1214[1][0], _e1214[0][0], (_e1214[0][0] < _e1214[1][0]));
                                                            let _e1294 = select(_e1214[1][0], _e1214[0][0], (_e1214[0][0] > _e1214[1][0]));
                                                            let _e1298 = select(_e1214[1][1], _e1214[0][1], (_e1214[0][1] < _e1214[1][1]));
                                                            let _e1302 = select(_e1214[1][1], _e1214[0][1], (_e1214[0][1] > _e1214[1][1]));
                                                            let _e1306 = select(_e1214[1][2], _e1214[0][2], (_e1214[0][2] < _e1214[1][2]));
                                                            let _e1310 = select(_e1214[1][2], _e1214[0][2], (_e1214[0][2] > _e1214[1][2]));
                                                            let _e1315 = ((select(_e1214[2][0], _e1290, (_e1290 < _e1214[2][0])) - _e326) * _e331);
                                                            let _e1316 = ((select(_e1214[2][0], _e1294, (_e1294 > _e1214[2][0])) - _e327) * _e331);
                                                            let _e1319 = ((select(_e1214[2][1], _e1298, (_e1298 < _e1214[2][1])) - _e362) * _e367);
                                                            let _e1320 = ((select(_e1214[2][1], _e1302, (_e1302 > _e1214[2][1])) - _e363) * _e367);
                                                            let _e1323 = ((select(_e1214[2][2], _e1306, (_e1306 < _e1214[2][2])) - _e398) * _e403);
                                                            let _e1324 = ((select(_e1214[2][2], _e1310, (_e1310 > _e1214[2][2])) - _e399) * _e403);
                                                            let _e1326 = select(_e1324, _e1323, (_e1323 < _e1324));
                                                            let _e1328 = select(_e1324, _e1323, (_e1323 > _e1324));
                                                            let _e1330 = select(_e1316, _e1315, (_e1315 < _e1316));
                                                            let _e1332 = select(_e1320, _e1319, (_e1319 < _e1320));
                                                            let _e1334 = select(_e1332, _e1330, (_e1330 > _e1332));
                                                            let _e1336 = select(_e1326, _e1334, (_e1334 > _e1326));
                                                            let _e1338 = select(_e1316, _e1315, (_e1315 > _e1316));
                                                            let _e1340 = select(_e1320, _e1319, (_e1319 > _e1320));
                                                            let _e1342 = select(_e1340, _e1338, (_e1338 < _e1340));
                                                            let _e1344 = select(_e1328, _e1342, (_e1342 < _e1328));
                                                            let _e1345 = -(_e1326);
                                                            let _e1351 = select(_e449, _e1336, (_e1336 > _e449));
                                                            if (_e1351 > (_e1344 + (select(_e1345, _e1328, (_e1328 > _e1345)) * 0.0000019073523f))) {
                                                                phi_2908_ = type_18();
                                                                phi_2909_ = true;
                                                            } else {
                                                                let _e1353 = (_e1351 > _e1008.member.member_1);
                                                                if _e1353 {
                                                                    phi_2907_ = type_18();
                                                                } else {
                                                                    let _e1357 = (_e1214[1][0] - _e1214[0][0]);
                                                                    let _e1358 = (_e1214[1][1] - _e1214[0][1]);
                                                                    let _e1359 = (_e1214[1][2] - _e1214[0][2]);
                                                                    let _e1360 = vec3<f32>(_e1357, _e1358, _e1359);
                                                                    let _e1361 = (_e1214[2][0] - _e1214[1][0]);
                                                                    let _e1362 = (_e1214[2][1] - _e1214[1][1]);
                                                                    let _e1363 = (_e1214[2][2] - _e1214[1][2]);
                                                                    let _e1364 = vec3<f32>(_e1361, _e1362, _e1363);
                                                                    let _e1365 = (_e1214[0][0] - _e1214[2][0]);
                                                                    let _e1366 = (_e1214[0][1] - _e1214[2][1]);
                                                                    let _e1367 = (_e1214[0][2] - _e1214[2][2]);
                                                                    let _e1368 = vec3<f32>(_e1365, _e1366, _e1367);
                                                                    let _e1371 = bitcast<f32>((bitcast<u32>(_e1357) & 2147483647u));
                                                                    let _e1374 = bitcast<f32>((bitcast<u32>(_e1358) & 2147483647u));
                                                                    let _e1376 = select(_e1374, _e1371, (_e1371 > _e1374));
                                                                    let _e1379 = bitcast<f32>((bitcast<u32>(_e1359) & 2147483647u));
                                                                    let _e1381 = select(_e1379, _e1376, (_e1376 > _e1379));
                                                                    let _e1384 = bitcast<f32>((bitcast<u32>(_e1361) & 2147483647u));
                                                                    let _e1387 = bitcast<f32>((bitcast<u32>(_e1362) & 2147483647u));
                                                                    let _e1389 = select(_e1387, _e1384, (_e1384 > _e1387));
                                                                    let _e1392 = bitcast<f32>((bitcast<u32>(_e1363) & 2147483647u));
                                                                    let _e1394 = select(_e1392, _e1389, (_e1389 > _e1392));
                                                                    let _e1397 = bitcast<f32>((bitcast<u32>(_e1365) & 2147483647u));
                                                                    let _e1400 = bitcast<f32>((bitcast<u32>(_e1366) & 2147483647u));
                                                                    let _e1402 = select(_e1400, _e1397, (_e1397 > _e1400));
                                                                    let _e1405 = bitcast<f32>((bitcast<u32>(_e1367) & 2147483647u));
                                                                    let _e1407 = select(_e1405, _e1402, (_e1402 > _e1405));
                                                                    let _e1409 = select(_e1394, _e1381, (_e1381 > _e1394));
                                                                    let _e1411 = select(_e1407, _e1409, (_e1409 > _e1407));
                                                                    if (_e1381 == _e1411) {
                                                                        phi_2818_ = _e1364;
                                                                        phi_2819_ = _e1368;
                                                                    } else {
                                                                        let _e1414 = vec3((_e1394 == _e1411));
                                                                        phi_2818_ = select(_e1360, _e1368, _e1414);
                                                                        phi_2819_ = select(_e1364, _e1360, _e1414);
                                                                    }
                                                                    let _e1418 = phi_2818_;
                                                                    let _e1420 = phi_2819_;
                                                                    let _e1427 = ((_e1418.y * _e1420.z) - (_e1420.y * _e1418.z));
                                                                    let _e1432 = ((_e1418.z * _e1420.x) - (_e1420.z * _e1418.x));
                                                                    let _e1435 = ((_e1418.x * _e1420.y) - (_e1420.x * _e1418.y));
                                                                    if (_e1277 >= _e1281) {
                                                                        phi_2850_ = select(true, false, (_e1277 >= _e1285));
                                                                    } else {
                                                                        phi_2850_ = true;
                                                                    }
                                                                    let _e1440 = phi_2850_;
                                                                    if _e1440 {
                                                                        phi_2859_ = select(vec3<f32>(_e1214[2][0], _e1214[2][1], _e1214[2][2]), vec3<f32>(_e1214[1][0], _e1214[1][1], _e1214[1][2]), vec3((_e1281 >= _e1285)));
                                                                    } else {
                                                                        phi_2859_ = vec3<f32>(_e1214[0][0], _e1214[0][1], _e1214[0][2]);
                                                                    }
                                                                    let _e1445 = phi_2859_;
                                                                    let _e1462 = ((((_e1427 * (_e1445.x - _e303)) + (_e1432 * (_e1445.y - _e340))) + (_e1435 * (_e1445.z - _e376))) / (((_e1427 * _e328) + (_e1432 * _e364)) + (_e1435 * _e400)));
                                                                    let _e1464 = select(_e1344, _e1462, (_e1462 < _e1344));
                                                                    let _e1466 = select(_e1336, _e1464, (_e1464 > _e1336));
                                                                    if (_e1466 >= _e449) {
                                                                        let _e1468 = (_e1466 <= _e1008.member.member_1);
                                                                        if _e1468 {
                                                                            let _e1469 = (1f / _e1287);
                                                                            phi_2899_ = type_18(_e1466, (_e1281 * _e1469), (_e1285 * _e1469), _e1074);
                                                                        } else {
                                                                            phi_2899_ = type_18();
                                                                        }
                                                                        let _e1474 = phi_2899_;
                                                                        phi_2901_ = _e1474;
                                                                        phi_2902_ = select(true, false, _e1468);
                                                                    } else {
                                                                        phi_2901_ = type_18();
                                                                        phi_2902_ = true;
                                                                    }
                                                                    let _e1477 = phi_2901_;
                                                                    let _e1479 = phi_2902_;
                                                                    if _e1479 {
                                                                        phi_2906_ = type_18(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                    } else {
                                                                        phi_2906_ = _e1477;
                                                                    }
                                                                    let _e1481 = phi_2906_;
                                                                    phi_2907_ = _e1481;
                                                                }
                                                                let _e1483 = phi_2907_;
                                                                phi_2908_ = _e1483;
                                                                phi_2909_ = _e1353;
                                                            }
                                                            let _e1485 = phi_2908_;
                                                            let _e1487 = phi_2909_;
                                                            phi_2913_ = _e1485;
                                                            phi_2914_ = _e1487;
                                                        }
                                                        let _e1489 = phi_2913_;
                                                        let _e1491 = phi_2914_;
                                                        phi_2918_ = _e1489;
                                                        phi_2919_ = _e1491;
                                                    } else {
                                                        phi_2918_ = type_18();
                                                        phi_2919_ = true;
                                                    }
                                                    let _e1493 = phi_2918_;
                                                    let _e1495 = phi_2919_;
                                                    if _e1495 {
                                                        phi_2923_ = type_18(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                    } else {
                                                        phi_2923_ = _e1493;
                                                    }
                                                    let _e1497 = phi_2923_;
                                                    if (_e1497.member_3 != 4294967295u) {
                                                        if (_e1074 != _e455) {
                                                            if (_e1497.member < _e1008.member.member.member) {
                                                                phi_2949_ = true;
                                                            } else {
                                                                if (_e1497.member == _e1008.member.member.member) {
                                                                    phi_2948_ = (_e1497.member_3 < _e1008.member.member.member_3);
                                                                } else {
                                                                    phi_2948_ = false;
                                                                }
                                                                let _e1512 = phi_2948_;
                                                                phi_2949_ = _e1512;
                                                            }
                                                            let _e1514 = phi_2949_;
                                                            if _e1514 {
                                                                phi_2956_ = type_37(type_34(_e1497, _e1497.member), _e1035.member_1, _e1035.member_2);
                                                            } else {
                                                                phi_2956_ = _e1035;
                                                            }
                                                            let _e1521 = phi_2956_;
                                                            phi_2957_ = _e1521;
                                                        } else {
                                                            phi_2957_ = _e1035;
                                                        }
                                                        let _e1523 = phi_2957_;
                                                        phi_2958_ = _e1523;
                                                    } else {
                                                        phi_2958_ = _e1035;
                                                    }
                                                    let _e1525 = phi_2958_;
                                                    phi_4747_ = _e1213;
                                                    phi_1989_ = _e1525;
                                                } else {
                                                    phi_4747_ = _e1006;
                                                    phi_1989_ = type_37();
                                                }
                                                let _e1527 = phi_4747_;
                                                let _e1529 = phi_1989_;
                                                continue;
                                                continuing {
                                                    phi_4688_ = _e1527;
                                                    phi_1988_ = _e1529;
                                                    phi_1991_ = _e1023;
                                                    phi_4746_ = _e1527;
                                                    break if !(_e1029);
                                                }
                                            }
                                            let _e1532 = phi_4746_;
                                            phi_4805_ = _e1532;
                                            if _e1532 {
                                                break;
                                            }
                                            phi_4809_ = _e1532;
                                            let _e1774 = local_9;
                                            phi_4299_ = _e1774;
                                            phi_4300_ = _e528;
                                            phi_4301_ = false;
                                            phi_4302_ = _e532;
                                        } else {
                                            if (_e528.member_1 >= _e90) {
                                                phi_3899_ = type_55(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), type_52(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u), type_52(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u));
                                            } else {
                                                if (_e528.member_1 < _e90) {
                                                } else {
                                                    phi_4805_ = true;
                                                    break;
                                                }
                                                let _e552 = ((1u + (_e271 * 2u)) % 7u);
                                                if (_e552 < 7u) {
                                                } else {
                                                    phi_4805_ = true;
                                                    break;
                                                }
                                                let _e557 = global_6.member[_e528.member_1][_e552];
                                                let _e560 = ((1u + (_e270 * 2u)) % 7u);
                                                if (_e560 < 7u) {
                                                } else {
                                                    phi_4805_ = true;
                                                    break;
                                                }
                                                let _e565 = global_6.member[_e528.member_1][_e560];
                                                let _e568 = ((1u + (_e272 * 2u)) % 7u);
                                                if (_e568 < 7u) {
                                                } else {
                                                    phi_4805_ = true;
                                                    break;
                                                }
                                                let _e573 = global_6.member[_e528.member_1][_e568];
                                                let _e576 = (((_e271 + 1u) * 2u) % 7u);
                                                if (_e576 < 7u) {
                                                } else {
                                                    phi_4805_ = true;
                                                    break;
                                                }
                                                let _e581 = global_6.member[_e528.member_1][_e576];
                                                let _e584 = (((_e270 + 1u) * 2u) % 7u);
                                                if (_e584 < 7u) {
                                                } else {
                                                    phi_4805_ = true;
                                                    break;
                                                }
                                                let _e589 = global_6.member[_e528.member_1][_e584];
                                                let _e592 = (((_e272 + 1u) * 2u) % 7u);
                                                if (_e592 < 7u) {
                                                } else {
                                                    phi_4805_ = true;
                                                    break;
                                                }
                                                let _e597 = global_6.member[_e528.member_1][_e592];
                                                let _e620 = (bitcast<f32>((bitcast<u32>((_e528.member.member_1.x - _e528.member.member.x)) & 2139095040u)) * 0.0000009536743f);
                                                let _e621 = (bitcast<f32>((bitcast<u32>((_e528.member.member_1.y - _e528.member.member.y)) & 2139095040u)) * 0.0000009536743f);
                                                let _e622 = (bitcast<f32>((bitcast<u32>((_e528.member.member_1.z - _e528.member.member.z)) & 2139095040u)) * 0.0000009536743f);
                                                let _e624 = select(_e145, _e620, (_e620 > _e145));
                                                let _e626 = select(_e145, _e621, (_e621 > _e145));
                                                let _e628 = select(_e145, _e622, (_e622 > _e145));
                                                let _e653 = bitcast<u32>((f32(bitcast<i32>((_e557 & 2097151u))) * _e624));
                                                let _e658 = (bitcast<i32>((_e557 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                                let _e661 = bitcast<f32>((_e653 & bitcast<u32>(_e658)));
                                                let _e662 = bitcast<u32>((f32(bitcast<i32>((_e565 & 2097151u))) * _e626));
                                                let _e667 = (bitcast<i32>((_e565 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                                let _e670 = bitcast<f32>((_e662 & bitcast<u32>(_e667)));
                                                let _e671 = bitcast<u32>((f32(bitcast<i32>((_e573 & 2097151u))) * _e628));
                                                let _e676 = (bitcast<i32>((_e573 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                                let _e679 = bitcast<f32>((_e671 & bitcast<u32>(_e676)));
                                                let _e683 = bitcast<f32>((_e653 & bitcast<u32>(~(_e658))));
                                                let _e687 = bitcast<f32>((_e662 & bitcast<u32>(~(_e667))));
                                                let _e691 = bitcast<f32>((_e671 & bitcast<u32>(~(_e676))));
                                                let _e692 = bitcast<u32>((f32(bitcast<i32>((_e581 & 2097151u))) * _e624));
                                                let _e697 = (bitcast<i32>((_e581 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                                let _e700 = bitcast<f32>((_e692 & bitcast<u32>(_e697)));
                                                let _e701 = bitcast<u32>((f32(bitcast<i32>((_e589 & 2097151u))) * _e626));
                                                let _e706 = (bitcast<i32>((_e589 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                                let _e709 = bitcast<f32>((_e701 & bitcast<u32>(_e706)));
                                                let _e710 = bitcast<u32>((f32(bitcast<i32>((_e597 & 2097151u))) * _e628));
                                                let _e715 = (bitcast<i32>((_e597 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                                let _e718 = bitcast<f32>((_e710 & bitcast<u32>(_e715)));
                                                let _e722 = bitcast<f32>((_e692 & bitcast<u32>(~(_e697))));
                                                let _e726 = bitcast<f32>((_e701 & bitcast<u32>(~(_e706))));
                                                let _e730 = bitcast<f32>((_e710 & bitcast<u32>(~(_e715))));
                                                let _e731 = (_e528.member.member.x + _e661);
                                                let _e732 = (_e528.member.member.y + _e670);
                                                let _e733 = (_e528.member.member.z + _e679);
                                                let _e736 = (_e528.member.member_1.x - _e700);
                                                let _e737 = (_e528.member.member_1.y - _e709);
                                                let _e738 = (_e528.member.member_1.z - _e718);
                                                let _e757 = (_e736 - _e731);
                                                let _e758 = (_e737 - _e732);
                                                let _e759 = (_e738 - _e733);
                                                let _e761 = select(_e758, _e757, (_e757 > _e758));
                                                let _e763 = select(_e759, _e761, (_e761 > _e759));
                                                if (_e763 < (1024f * _e145)) {
                                                    phi_3600_ = 0u;
                                                } else {
                                                    phi_3600_ = select(2u, 1u, (_e763 < (2097152f * _e145)));
                                                }
                                                let _e770 = phi_3600_;
                                                switch bitcast<i32>(_e770) {
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
                                                let _e773 = phi_3606_;
                                                let _e779 = global_6.member[_e528.member_1][0u];
                                                let _e783 = global_6.member[_e528.member_1][2u];
                                                let _e787 = global_6.member[_e528.member_1][4u];
                                                let _e791 = global_6.member[_e528.member_1][6u];
                                                let _e803 = (((_e783 >> bitcast<u32>(22i)) | ((_e787 >> bitcast<u32>(22i)) << bitcast<u32>(10i))) | ((_e791 >> bitcast<u32>(22i)) << bitcast<u32>(20i)));
                                                let _e804 = (_e779 & 268435455u);
                                                let _e805 = (_e803 & 268435455u);
                                                let _e808 = ((_e779 >> bitcast<u32>(28u)) & 7u);
                                                let _e816 = ((_e779 >> bitcast<u32>(31i)) | (((_e803 >> bitcast<u32>(28u)) & 3u) << bitcast<u32>(1i)));
                                                let _e817 = (_e808 != 0u);
                                                if (_e808 == 0u) {
                                                    phi_3861_ = _e804;
                                                } else {
                                                    if (_e808 == 7u) {
                                                        phi_3860_ = 2147483648u;
                                                    } else {
                                                        phi_3860_ = ((2147483648u | (_e808 << bitcast<u32>(28u))) | (_e805 & 268435455u));
                                                    }
                                                    let _e826 = phi_3860_;
                                                    phi_3861_ = _e826;
                                                }
                                                let _e828 = phi_3861_;
                                                if _e817 {
                                                    let _e829 = (_e808 != 7u);
                                                    if _e829 {
                                                        phi_3871_ = (_e805 + (_e808 * ((3u * _e773) + 1u)));
                                                    } else {
                                                        phi_3871_ = u32();
                                                    }
                                                    let _e833 = phi_3871_;
                                                    phi_3873_ = _e833;
                                                    phi_3874_ = select(true, false, _e829);
                                                } else {
                                                    phi_3873_ = u32();
                                                    phi_3874_ = true;
                                                }
                                                let _e836 = phi_3873_;
                                                let _e838 = phi_3874_;
                                                if (_e816 == 0u) {
                                                    phi_3895_ = (_e804 + select(0u, 1u, !(_e817)));
                                                } else {
                                                    if (_e816 == 7u) {
                                                        phi_3894_ = 2147483648u;
                                                    } else {
                                                        phi_3894_ = ((2147483648u | (_e816 << bitcast<u32>(28u))) | (select(_e836, _e805, _e838) & 268435455u));
                                                    }
                                                    let _e851 = phi_3894_;
                                                    phi_3895_ = _e851;
                                                }
                                                let _e853 = phi_3895_;
                                                phi_3899_ = type_55(array<vec4<f32>, 3>(vec4<f32>(_e731, (_e528.member.member.x + _e683), _e736, (_e528.member.member_1.x - _e722)), vec4<f32>(_e732, (_e528.member.member.y + _e687), _e737, (_e528.member.member_1.y - _e726)), vec4<f32>(_e733, (_e528.member.member.z + _e691), _e738, (_e528.member.member_1.z - _e730))), type_52(type_30((_e528.member.member + vec4<f32>(_e661, _e670, _e679, 0f)), (_e528.member.member_1 - vec4<f32>(_e700, _e709, _e718, 0f))), _e828), type_52(type_30((_e528.member.member + vec4<f32>(_e683, _e687, _e691, 0f)), (_e528.member.member_1 - vec4<f32>(_e722, _e726, _e730, 0f))), _e853));
                                            }
                                            let _e858 = phi_3899_;
                                            let _e871 = ((_e858.member[0].x - _e326) * _e331);
                                            let _e872 = ((_e858.member[0].y - _e326) * _e331);
                                            let _e873 = ((_e858.member[0].z - _e327) * _e331);
                                            let _e874 = ((_e858.member[0].w - _e327) * _e331);
                                            let _e884 = ((_e858.member[1].x - _e362) * _e367);
                                            let _e885 = ((_e858.member[1].y - _e362) * _e367);
                                            let _e886 = ((_e858.member[1].z - _e363) * _e367);
                                            let _e887 = ((_e858.member[1].w - _e363) * _e367);
                                            let _e897 = ((_e858.member[2].x - _e398) * _e403);
                                            let _e898 = ((_e858.member[2].y - _e398) * _e403);
                                            let _e899 = ((_e858.member[2].z - _e399) * _e403);
                                            let _e900 = ((_e858.member[2].w - _e399) * _e403);
                                            let _e902 = select(_e899, _e897, (_e897 < _e899));
                                            let _e904 = select(_e900, _e898, (_e898 < _e900));
                                            let _e906 = select(_e899, _e897, (_e897 > _e899));
                                            let _e908 = select(_e900, _e898, (_e898 > _e900));
                                            let _e910 = select(_e873, _e871, (_e871 < _e873));
                                            let _e912 = select(_e874, _e872, (_e872 < _e874));
                                            let _e914 = select(_e886, _e884, (_e884 < _e886));
                                            let _e916 = select(_e887, _e885, (_e885 < _e887));
                                            let _e918 = select(_e914, _e910, (_e910 > _e914));
                                            let _e920 = select(_e916, _e912, (_e912 > _e916));
                                            let _e922 = select(_e902, _e918, (_e918 > _e902));
                                            let _e924 = select(_e904, _e920, (_e920 > _e904));
                                            let _e926 = select(_e873, _e871, (_e871 > _e873));
                                            let _e928 = select(_e874, _e872, (_e872 > _e874));
                                            let _e930 = select(_e886, _e884, (_e884 > _e886));
                                            let _e932 = select(_e887, _e885, (_e885 > _e887));
                                            let _e934 = select(_e930, _e926, (_e926 < _e930));
                                            let _e936 = select(_e932, _e928, (_e928 < _e932));
                                            let _e941 = -(_e902);
                                            let _e942 = -(_e904);
                                            let _e949 = (select(_e906, _e934, (_e934 < _e906)) + (select(_e941, _e906, (_e906 > _e941)) * 0.0000019073523f));
                                            let _e950 = (select(_e908, _e936, (_e936 < _e908)) + (select(_e942, _e908, (_e908 > _e942)) * 0.0000019073523f));
                                            let _e952 = select(_e449, _e922, (_e922 > _e449));
                                            let _e954 = select(_e449, _e924, (_e924 > _e449));
                                            let _e959 = (_e952 <= select(_e498.member.member_1, _e949, (_e949 < _e498.member.member_1)));
                                            let _e960 = (_e954 <= select(_e498.member.member_1, _e950, (_e950 < _e498.member.member_1)));
                                            let _e961 = (_e952 <= _e954);
                                            if _e959 {
                                                if _e960 {
                                                    if _e961 {
                                                        phi_4243_ = _e858.member_2;
                                                    } else {
                                                        phi_4243_ = _e858.member_1;
                                                    }
                                                    let _e965 = phi_4243_;
                                                    let _e966 = (_e532 % 128u);
                                                    let _e967 = (_e966 < 128u);
                                                    if _e967 {
                                                    } else {
                                                        phi_4805_ = true;
                                                        break;
                                                    }
                                                    local_3[_e966] = type_52(type_30(_e965.member.member, _e965.member.member_1), _e965.member_1);
                                                    if _e967 {
                                                    } else {
                                                        phi_4805_ = true;
                                                        break;
                                                    }
                                                    local_2[_e966] = select(_e954, _e952, (_e952 > _e954));
                                                    if _e961 {
                                                        phi_4276_ = _e858.member_1;
                                                    } else {
                                                        phi_4276_ = _e858.member_2;
                                                    }
                                                    let _e982 = phi_4276_;
                                                    phi_4277_ = _e982;
                                                    phi_4278_ = (_e532 + 1u);
                                                } else {
                                                    phi_4277_ = type_52();
                                                    phi_4278_ = u32();
                                                }
                                                let _e984 = phi_4277_;
                                                let _e986 = phi_4278_;
                                                phi_4280_ = _e984;
                                                phi_4281_ = _e986;
                                                phi_4282_ = select(true, false, _e960);
                                            } else {
                                                phi_4280_ = type_52();
                                                phi_4281_ = u32();
                                                phi_4282_ = true;
                                            }
                                            let _e989 = phi_4280_;
                                            let _e991 = phi_4281_;
                                            let _e993 = phi_4282_;
                                            if _e993 {
                                                if _e959 {
                                                    phi_4291_ = _e858.member_1;
                                                } else {
                                                    phi_4291_ = _e858.member_2;
                                                }
                                                let _e997 = phi_4291_;
                                                phi_4296_ = _e997;
                                                phi_4297_ = select(_e960, true, _e959);
                                            } else {
                                                phi_4296_ = _e989;
                                                phi_4297_ = _e530;
                                            }
                                            let _e1000 = phi_4296_;
                                            let _e1002 = phi_4297_;
                                            phi_4809_ = _e496;
                                            phi_4299_ = type_37(_e498.member, (_e498.member_1 + 1u), _e498.member_2);
                                            phi_4300_ = _e1000;
                                            phi_4301_ = _e1002;
                                            phi_4302_ = select(_e991, _e532, _e993);
                                        }
                                        let _e1534 = phi_4809_;
                                        let _e1536 = phi_4299_;
                                        let _e1538 = phi_4300_;
                                        let _e1540 = phi_4301_;
                                        let _e1542 = phi_4302_;
                                        phi_4808_ = _e1534;
                                        phi_4303_ = _e1536;
                                        phi_4304_ = _e1538;
                                        phi_4305_ = (_e502 - 1u);
                                        phi_4306_ = _e1540;
                                        phi_4307_ = _e1542;
                                    } else {
                                        phi_4808_ = _e496;
                                        phi_4303_ = _e498;
                                        phi_4304_ = _e528;
                                        phi_4305_ = _e502;
                                        phi_4306_ = _e530;
                                        phi_4307_ = _e532;
                                    }
                                    let _e1544 = phi_4808_;
                                    let _e1546 = phi_4303_;
                                    let _e1548 = phi_4304_;
                                    let _e1550 = phi_4305_;
                                    let _e1552 = phi_4306_;
                                    let _e1554 = phi_4307_;
                                    phi_4807_ = _e1544;
                                    phi_4308_ = _e1546;
                                    phi_4309_ = _e1548;
                                    phi_4310_ = _e1550;
                                    phi_4311_ = _e1552;
                                    phi_4312_ = _e1554;
                                } else {
                                    phi_4807_ = _e496;
                                    phi_4308_ = type_37();
                                    phi_4309_ = type_52();
                                    phi_4310_ = u32();
                                    phi_4311_ = bool();
                                    phi_4312_ = u32();
                                }
                                let _e1556 = phi_4807_;
                                let _e1558 = phi_4308_;
                                let _e1560 = phi_4309_;
                                let _e1562 = phi_4310_;
                                let _e1564 = phi_4311_;
                                let _e1566 = phi_4312_;
                                phi_4806_ = _e1556;
                                phi_1911_ = _e1558;
                                phi_1914_ = _e1560;
                                phi_1916_ = _e1562;
                                phi_1918_ = _e1564;
                                phi_1920_ = _e1566;
                                phi_4313_ = _e510;
                            } else {
                                phi_4806_ = _e496;
                                phi_1911_ = type_37();
                                phi_1914_ = type_52();
                                phi_1916_ = u32();
                                phi_1918_ = bool();
                                phi_1920_ = u32();
                                phi_4313_ = false;
                            }
                            let _e1568 = phi_4806_;
                            let _e1570 = phi_1911_;
                            let _e1572 = phi_1914_;
                            let _e1574 = phi_1916_;
                            let _e1576 = phi_1918_;
                            let _e1578 = phi_1920_;
                            let _e1580 = phi_4313_;
                            continue;
                            continuing {
                                phi_4691_ = _e1568;
                                phi_1910_ = _e1570;
                                phi_1913_ = _e1572;
                                phi_1915_ = _e1574;
                                phi_1917_ = _e1576;
                                phi_1919_ = _e1578;
                                phi_4805_ = _e1568;
                                break if !(_e1580);
                            }
                        }
                        let _e1583 = phi_4805_;
                        if _e1583 {
                            break;
                        }
                        let _e1585 = local_7;
                        if (_e1585.member.member.member_3 != 4294967295u) {
                            let _e1591 = (_e273 / 3i);
                            let _e1598 = bitcast<f32>((bitcast<u32>((_e1591 + 127i)) << bitcast<u32>(23i)));
                            let _e1606 = (((_e1585.member.member.member * _e1598) * _e1598) * bitcast<f32>((bitcast<u32>(((_e273 - (2i * _e1591)) + 127i)) << bitcast<u32>(23i))));
                            let _e1608 = select(340282350000000000000000000000000000000f, _e1606, (_e1606 < 340282350000000000000000000000000000000f));
                            phi_4365_ = type_18(select(-340282350000000000000000000000000000000f, _e1608, (_e1608 > -340282350000000000000000000000000000000f)), _e1585.member.member.member_1, _e1585.member.member.member_2, _e1585.member.member.member_3);
                        } else {
                            phi_4365_ = type_18(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                        }
                        let _e1615 = phi_4365_;
                        if _e149 {
                        } else {
                            break;
                        }
                        global_1.member[_e133] = _e1615;
                        let _e1619 = local_8;
                        if _e150 {
                        } else {
                            break;
                        }
                        global_4.member[_e133] = _e1619.member_1;
                        if _e148 {
                        } else {
                            break;
                        }
                        let _e1624 = select(0u, 1u, (_e217 <= _e227));
                        if (_e1624 > 0u) {
                            let _e1626 = (1u < _e101);
                            if _e1626 {
                                if (0u < _e101) {
                                } else {
                                    break;
                                }
                                let _e1630 = atomicAdd((&global_5.member[0u]), _e1624);
                                if ((_e1630 + _e1624) < _e1630) {
                                    if _e1626 {
                                    } else {
                                        break;
                                    }
                                    let _e1635 = atomicAdd((&global_5.member[1u]), 1u);
                                }
                            }
                        }
                        let _e1638 = select(0u, 1u, (_e1615.member_3 != 4294967295u));
                        if (_e1638 > 0u) {
                            let _e1640 = (3u < _e101);
                            if _e1640 {
                                if (2u < _e101) {
                                } else {
                                    break;
                                }
                                let _e1644 = atomicAdd((&global_5.member[2u]), _e1638);
                                if ((_e1644 + _e1638) < _e1644) {
                                    if _e1640 {
                                    } else {
                                        break;
                                    }
                                    let _e1649 = atomicAdd((&global_5.member[3u]), 1u);
                                }
                            }
                        }
                        if (_e1619.member_1 > 0u) {
                            let _e1651 = (5u < _e101);
                            if _e1651 {
                                if (4u < _e101) {
                                } else {
                                    break;
                                }
                                let _e1655 = atomicAdd((&global_5.member[4u]), _e1619.member_1);
                                if ((_e1655 + _e1619.member_1) < _e1655) {
                                    if _e1651 {
                                    } else {
                                        break;
                                    }
                                    let _e1660 = atomicAdd((&global_5.member[5u]), 1u);
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
fn trace_paths_counted_q21_lattice(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
