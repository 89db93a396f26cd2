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
    var phi_410_: i32;
    var phi_411_: i32;
    var phi_421_: bool;
    var phi_431_: u32;
    var phi_432_: u32;
    var phi_434_: bool;
    var phi_439_: u32;
    var phi_484_: f32;
    var phi_490_: f32;
    var phi_501_: f32;
    var phi_507_: f32;
    var phi_530_: f32;
    var phi_541_: f32;
    var phi_550_: f32;
    var phi_556_: f32;
    var phi_567_: f32;
    var phi_573_: f32;
    var phi_596_: f32;
    var phi_607_: f32;
    var phi_616_: f32;
    var phi_622_: f32;
    var phi_633_: f32;
    var phi_639_: f32;
    var phi_662_: f32;
    var phi_673_: f32;
    var phi_773_: f32;
    var phi_774_: f32;
    var phi_4684_: bool;
    var phi_1903_: type_37;
    var phi_1906_: type_52;
    var phi_1908_: u32;
    var phi_1910_: bool;
    var phi_1912_: u32;
    var phi_1923_: bool;
    var phi_1960_: type_52;
    var phi_1961_: bool;
    var phi_1962_: u32;
    var phi_3593_: u32;
    var phi_3599_: u32;
    var phi_3853_: u32;
    var phi_3854_: u32;
    var phi_3864_: u32;
    var phi_3866_: u32;
    var phi_3867_: bool;
    var phi_3887_: u32;
    var phi_3888_: u32;
    var phi_3892_: type_55;
    var phi_4236_: type_52;
    var phi_4269_: type_52;
    var phi_4270_: type_52;
    var phi_4271_: u32;
    var phi_4273_: type_52;
    var phi_4274_: u32;
    var phi_4275_: bool;
    var phi_4284_: type_52;
    var phi_4289_: type_52;
    var phi_4290_: bool;
    var phi_4681_: bool;
    var phi_1981_: type_37;
    var phi_1984_: type_8;
    var phi_1985_: type_8;
    var phi_2007_: type_8;
    var phi_2051_: u32;
    var phi_2057_: u32;
    var phi_2067_: u32;
    var phi_2083_: u32;
    var phi_2120_: u32;
    var phi_2126_: u32;
    var phi_2136_: u32;
    var phi_4666_: bool;
    var phi_2152_: type_8;
    var phi_2153_: type_8;
    var phi_2176_: type_8;
    var phi_2199_: u32;
    var phi_2214_: u32;
    var phi_2217_: type_8;
    var phi_2218_: type_8;
    var phi_2241_: type_8;
    var phi_2307_: u32;
    var phi_2287_: u32;
    var phi_2288_: u32;
    var phi_2311_: f32;
    var phi_4659_: bool;
    var phi_4734_: bool;
    var phi_4733_: bool;
    var phi_2811_: vec3<f32>;
    var phi_2812_: vec3<f32>;
    var phi_2843_: bool;
    var phi_2852_: vec3<f32>;
    var phi_2892_: type_18;
    var phi_2894_: type_18;
    var phi_2895_: bool;
    var phi_2899_: type_18;
    var phi_2900_: type_18;
    var phi_2901_: type_18;
    var phi_2902_: bool;
    var phi_2906_: type_18;
    var phi_2907_: bool;
    var phi_2911_: type_18;
    var phi_2912_: bool;
    var phi_2916_: type_18;
    var phi_2941_: bool;
    var phi_2942_: bool;
    var phi_2949_: type_37;
    var phi_2950_: type_37;
    var phi_2951_: type_37;
    var phi_4736_: bool;
    var phi_1982_: type_37;
    var phi_4735_: bool;
    var phi_4798_: bool;
    var phi_4292_: type_37;
    var phi_4293_: type_52;
    var phi_4294_: bool;
    var phi_4295_: u32;
    var phi_4797_: bool;
    var phi_4296_: type_37;
    var phi_4297_: type_52;
    var phi_4298_: u32;
    var phi_4299_: bool;
    var phi_4300_: u32;
    var phi_4796_: bool;
    var phi_4301_: type_37;
    var phi_4302_: type_52;
    var phi_4303_: u32;
    var phi_4304_: bool;
    var phi_4305_: u32;
    var phi_4795_: bool;
    var phi_1904_: type_37;
    var phi_1907_: type_52;
    var phi_1909_: u32;
    var phi_1911_: bool;
    var phi_1913_: u32;
    var phi_4306_: bool;
    var phi_4794_: bool;
    var local_7: type_37;
    var phi_4358_: type_18;
    var local_8: type_37;
    var local_9: type_37;

    switch bitcast<i32>(0u) {
        default: {
            let _e87 = global;
            let _e89 = arrayLength((&global_6.member));
            let _e92 = arrayLength((&global_7.member));
            let _e100 = arrayLength((&global_5.member));
            let _e104 = global_2.member[0u][0u];
            let _e108 = global_2.member[0u][1u];
            let _e112 = global_2.member[0u][2u];
            let _e116 = global_2.member[0u][3u];
            let _e120 = global_2.member[1u][0u];
            let _e124 = global_2.member[1u][1u];
            let _e128 = global_2.member[1u][2u];
            let _e132 = (_e87.x + (_e87.y * 2097152u));
            let _e144 = bitcast<f32>((bitcast<u32>((bitcast<i32>(_e116) + 127i)) << bitcast<u32>(23i)));
            local_1 = array<i32, 3>(bitcast<i32>(_e104), bitcast<i32>(_e108), bitcast<i32>(_e112));
            local = array<i32, 3>(bitcast<i32>(_e120), bitcast<i32>(_e124), bitcast<i32>(_e128));
            let _e147 = (_e132 < arrayLength((&global_3.member)));
            if _e147 {
                let _e148 = (_e132 < arrayLength((&global_1.member)));
                if _e148 {
                    let _e149 = (_e132 < arrayLength((&global_4.member)));
                    if _e149 {
                        if _e147 {
                        } else {
                            break;
                        }
                        let _e159 = global_3.member[_e132].member.member_2[0u];
                        let _e161 = (bitcast<u32>(_e159) & 2147483647u);
                        let _e167 = global_3.member[_e132].member.member_2[1u];
                        let _e169 = (bitcast<u32>(_e167) & 2147483647u);
                        let _e175 = global_3.member[_e132].member.member_2[2u];
                        let _e177 = (bitcast<u32>(_e175) & 2147483647u);
                        let _e183 = global_3.member[_e132].member.member[0u];
                        let _e185 = (bitcast<u32>(_e183) & 2147483647u);
                        let _e191 = global_3.member[_e132].member.member[1u];
                        let _e193 = (bitcast<u32>(_e191) & 2147483647u);
                        let _e199 = global_3.member[_e132].member.member[2u];
                        let _e201 = (bitcast<u32>(_e199) & 2147483647u);
                        let _e203 = select(_e169, _e161, (_e169 < _e161));
                        let _e205 = select(_e177, _e203, (_e177 < _e203));
                        let _e207 = select(_e185, _e205, (_e185 < _e205));
                        let _e209 = select(_e193, _e207, (_e193 < _e207));
                        let _e211 = select(_e201, _e209, (_e201 < _e209));
                        let _e216 = global_3.member[_e132].member.member_1;
                        let _e218 = (bitcast<u32>(_e216) & 2147483647u);
                        let _e226 = global_3.member[_e132].member.member_3;
                        let _e232 = (((select(_e218, _e211, (_e218 < _e211)) < 2139095040u) && ((bitcast<u32>(_e226) & 2147483647u) <= 2139095040u)) && (_e205 > 0u));
                        if _e232 {
                            let _e235 = (bitcast<u32>(bitcast<f32>(_e205)) & 2147483647u);
                            if (_e235 >= 8388608u) {
                                phi_410_ = (bitcast<i32>((_e235 >> bitcast<u32>(23i))) - 127i);
                            } else {
                                phi_410_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e235)), 32u, (_e235 == 0u))));
                            }
                            let _e249 = phi_410_;
                            phi_411_ = _e249;
                        } else {
                            phi_411_ = 0i;
                        }
                        let _e251 = phi_411_;
                        let _e252 = (_e161 == _e205);
                        if _e252 {
                            phi_421_ = true;
                        } else {
                            phi_421_ = (_e169 == _e205);
                        }
                        let _e255 = phi_421_;
                        let _e256 = select(1u, 0u, _e252);
                        if _e255 {
                            let _e257 = (_e256 + 1u);
                            phi_431_ = _e257;
                            phi_432_ = _e257;
                            phi_434_ = select(true, false, (_e257 == 2u));
                        } else {
                            phi_431_ = u32();
                            phi_432_ = 0u;
                            phi_434_ = true;
                        }
                        let _e261 = phi_431_;
                        let _e263 = phi_432_;
                        let _e265 = phi_434_;
                        if _e265 {
                            phi_439_ = (_e263 + 1u);
                        } else {
                            phi_439_ = 0u;
                        }
                        let _e269 = phi_439_;
                        let _e270 = select(_e261, _e263, _e265);
                        let _e271 = select(_e256, select(2u, _e256, _e255), _e265);
                        let _e272 = -(_e251);
                        let _e273 = (_e272 / 2i);
                        let _e278 = bitcast<f32>((bitcast<u32>((_e273 + 127i)) << bitcast<u32>(23i)));
                        let _e284 = bitcast<f32>((bitcast<u32>(((_e272 - _e273) + 127i)) << bitcast<u32>(23i)));
                        let _e289 = global_3.member[_e132].member.member;
                        let _e290 = (_e270 == 0u);
                        if _e290 {
                            phi_484_ = _e289[0];
                        } else {
                            phi_484_ = _e289[1];
                        }
                        let _e294 = phi_484_;
                        let _e295 = (_e270 == 2u);
                        if _e295 {
                            phi_490_ = _e289[2];
                        } else {
                            phi_490_ = _e294;
                        }
                        let _e298 = phi_490_;
                        let _e299 = global_3.member[_e132].member.member_2;
                        if _e290 {
                            phi_501_ = _e299[0];
                        } else {
                            phi_501_ = _e299[1];
                        }
                        let _e303 = phi_501_;
                        if _e295 {
                            phi_507_ = _e299[2];
                        } else {
                            phi_507_ = _e303;
                        }
                        let _e306 = phi_507_;
                        let _e308 = ((_e306 * _e278) * _e284);
                        let _e312 = (bitcast<f32>((bitcast<u32>(_e308) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e312 {
                            let _e316 = (bitcast<f32>((bitcast<u32>(_e298) & 2147483647u)) * 0.00000011920929f);
                            phi_530_ = select(0.00000000000011368684f, _e316, (_e316 > 0.00000000000011368684f));
                        } else {
                            phi_530_ = 0f;
                        }
                        let _e320 = phi_530_;
                        let _e321 = (_e298 + _e320);
                        let _e322 = (_e298 - _e320);
                        let _e323 = select(_e308, 0f, _e312);
                        if _e312 {
                            phi_541_ = 38685626000000000000000000f;
                        } else {
                            phi_541_ = (1f / _e308);
                        }
                        let _e326 = phi_541_;
                        let _e327 = (_e269 == 0u);
                        if _e327 {
                            phi_550_ = _e289[0];
                        } else {
                            phi_550_ = _e289[1];
                        }
                        let _e331 = phi_550_;
                        let _e332 = (_e269 == 2u);
                        if _e332 {
                            phi_556_ = _e289[2];
                        } else {
                            phi_556_ = _e331;
                        }
                        let _e335 = phi_556_;
                        if _e327 {
                            phi_567_ = _e299[0];
                        } else {
                            phi_567_ = _e299[1];
                        }
                        let _e339 = phi_567_;
                        if _e332 {
                            phi_573_ = _e299[2];
                        } else {
                            phi_573_ = _e339;
                        }
                        let _e342 = phi_573_;
                        let _e344 = ((_e342 * _e278) * _e284);
                        let _e348 = (bitcast<f32>((bitcast<u32>(_e344) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e348 {
                            let _e352 = (bitcast<f32>((bitcast<u32>(_e335) & 2147483647u)) * 0.00000011920929f);
                            phi_596_ = select(0.00000000000011368684f, _e352, (_e352 > 0.00000000000011368684f));
                        } else {
                            phi_596_ = 0f;
                        }
                        let _e356 = phi_596_;
                        let _e357 = (_e335 + _e356);
                        let _e358 = (_e335 - _e356);
                        let _e359 = select(_e344, 0f, _e348);
                        if _e348 {
                            phi_607_ = 38685626000000000000000000f;
                        } else {
                            phi_607_ = (1f / _e344);
                        }
                        let _e362 = phi_607_;
                        let _e363 = (_e271 == 0u);
                        if _e363 {
                            phi_616_ = _e289[0];
                        } else {
                            phi_616_ = _e289[1];
                        }
                        let _e367 = phi_616_;
                        let _e368 = (_e271 == 2u);
                        if _e368 {
                            phi_622_ = _e289[2];
                        } else {
                            phi_622_ = _e367;
                        }
                        let _e371 = phi_622_;
                        if _e363 {
                            phi_633_ = _e299[0];
                        } else {
                            phi_633_ = _e299[1];
                        }
                        let _e375 = phi_633_;
                        if _e368 {
                            phi_639_ = _e299[2];
                        } else {
                            phi_639_ = _e375;
                        }
                        let _e378 = phi_639_;
                        let _e380 = ((_e378 * _e278) * _e284);
                        let _e384 = (bitcast<f32>((bitcast<u32>(_e380) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e384 {
                            let _e388 = (bitcast<f32>((bitcast<u32>(_e371) & 2147483647u)) * 0.00000011920929f);
                            phi_662_ = select(0.00000000000011368684f, _e388, (_e388 > 0.00000000000011368684f));
                        } else {
                            phi_662_ = 0f;
                        }
                        let _e392 = phi_662_;
                        let _e393 = (_e371 + _e392);
                        let _e394 = (_e371 - _e392);
                        let _e395 = select(_e380, 0f, _e384);
                        if _e384 {
                            phi_673_ = 38685626000000000000000000f;
                        } else {
                            phi_673_ = (1f / _e380);
                        }
                        let _e398 = phi_673_;
                        let _e401 = bitcast<f32>((bitcast<u32>(_e298) & 2147483647u));
                        let _e404 = bitcast<f32>((bitcast<u32>(_e335) & 2147483647u));
                        let _e406 = select(_e404, _e401, (_e401 > _e404));
                        let _e409 = bitcast<f32>((bitcast<u32>(_e371) & 2147483647u));
                        if (_e232 && (select(_e409, _e406, (_e406 > _e409)) <= 1099511600000f)) {
                            let _e414 = (_e251 / 3i);
                            let _e421 = bitcast<f32>((bitcast<u32>((_e414 + 127i)) << bitcast<u32>(23i)));
                            let _e428 = bitcast<f32>((bitcast<u32>(((_e251 - (2i * _e414)) + 127i)) << bitcast<u32>(23i)));
                            let _e429 = (((_e216 * _e421) * _e421) * _e428);
                            let _e431 = select(340282350000000000000000000000000000000f, _e429, (_e429 < 340282350000000000000000000000000000000f));
                            let _e436 = (((_e226 * _e421) * _e421) * _e428);
                            let _e438 = select(340282350000000000000000000000000000000f, _e436, (_e436 < 340282350000000000000000000000000000000f));
                            phi_773_ = select(-340282350000000000000000000000000000000f, _e438, (_e438 > -340282350000000000000000000000000000000f));
                            phi_774_ = select(-340282350000000000000000000000000000000f, _e431, (_e431 > -340282350000000000000000000000000000000f));
                        } else {
                            phi_773_ = 0f;
                            phi_774_ = 1f;
                        }
                        let _e442 = phi_773_;
                        let _e444 = phi_774_;
                        if _e147 {
                        } else {
                            break;
                        }
                        let _e450 = global_3.member[_e132].member_2;
                        local_3 = array<type_52, 128>(type_52(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u));
                        local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        let _e453 = (_e270 % 3u);
                        let _e454 = (_e453 < 3u);
                        if _e454 {
                        } else {
                            break;
                        }
                        let _e456 = local_1[_e453];
                        let _e459 = (_e269 % 3u);
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
                        if _e454 {
                        } else {
                            break;
                        }
                        let _e473 = local[_e453];
                        if _e460 {
                        } else {
                            break;
                        }
                        let _e477 = local[_e459];
                        if _e466 {
                        } else {
                            break;
                        }
                        let _e481 = local[_e465];
                        phi_4684_ = false;
                        phi_1903_ = type_37(type_34(type_18(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e442), 0u, 0u);
                        phi_1906_ = type_52(type_30(vec4<f32>((f32(_e456) * _e144), (f32(_e462) * _e144), (f32(_e468) * _e144), 0f), vec4<f32>((f32(_e473) * _e144), (f32(_e477) * _e144), (f32(_e481) * _e144), 0f)), select(0u, 2147483648u, (_e89 == 0u)));
                        phi_1908_ = ((3u * _e89) + 1u);
                        phi_1910_ = (_e444 <= _e442);
                        phi_1912_ = 0u;
                        loop {
                            let _e491 = phi_4684_;
                            let _e493 = phi_1903_;
                            let _e495 = phi_1906_;
                            let _e497 = phi_1908_;
                            let _e499 = phi_1910_;
                            let _e501 = phi_1912_;
                            local_7 = _e493;
                            local_8 = _e493;
                            if _e499 {
                                phi_1923_ = true;
                            } else {
                                phi_1923_ = (_e501 > 0u);
                            }
                            let _e504 = phi_1923_;
                            if _e504 {
                                let _e505 = (_e497 > 0u);
                                if _e505 {
                                    if _e499 {
                                        phi_1960_ = _e495;
                                        phi_1961_ = _e499;
                                        phi_1962_ = _e501;
                                    } else {
                                        let _e506 = (_e501 - 1u);
                                        let _e507 = (_e506 % 128u);
                                        let _e508 = (_e507 < 128u);
                                        if _e508 {
                                        } else {
                                            phi_4794_ = true;
                                            break;
                                        }
                                        let _e510 = local_3[_e507];
                                        if _e508 {
                                        } else {
                                            phi_4794_ = true;
                                            break;
                                        }
                                        let _e518 = local_2[_e507];
                                        phi_1960_ = type_52(type_30(_e510.member.member, _e510.member.member_1), _e510.member_1);
                                        phi_1961_ = (_e518 <= _e493.member.member_1);
                                        phi_1962_ = _e506;
                                    }
                                    let _e523 = phi_1960_;
                                    let _e525 = phi_1961_;
                                    let _e527 = phi_1962_;
                                    if _e525 {
                                        let _e532 = (_e523.member_1 & 268435455u);
                                        if ((_e523.member_1 & 2147483648u) != 0u) {
                                            phi_4681_ = _e491;
                                            phi_1981_ = _e493;
                                            phi_1984_ = type_8(0u, ((_e523.member_1 >> bitcast<u32>(28u)) & 7u));
                                            loop {
                                                let _e1001 = phi_4681_;
                                                let _e1003 = phi_1981_;
                                                let _e1005 = phi_1984_;
                                                local_9 = _e1003;
                                                if (_e1005.member < _e1005.member_1) {
                                                    phi_1985_ = type_8((_e1005.member + 1u), _e1005.member_1);
                                                    phi_2007_ = type_8(1u, _e1005.member);
                                                } else {
                                                    phi_1985_ = _e1005;
                                                    phi_2007_ = type_8(0u, type_8().member_1);
                                                }
                                                let _e1018 = phi_1985_;
                                                let _e1020 = phi_2007_;
                                                let _e1024 = (bitcast<i32>(_e1020.member) != 0i);
                                                if _e1024 {
                                                    let _e1030 = type_37(_e1003.member, _e1003.member_1, (_e1003.member_2 + 1u));
                                                    let _e1035 = (_e523.member.member_1.x - _e523.member.member.x);
                                                    let _e1038 = (_e523.member.member_1.y - _e523.member.member.y);
                                                    let _e1041 = (_e523.member.member_1.z - _e523.member.member.z);
                                                    let _e1043 = select(_e1038, _e1035, (_e1035 > _e1038));
                                                    let _e1045 = select(_e1041, _e1043, (_e1043 > _e1041));
                                                    let _e1047 = (_e1045 < (1024f * _e144));
                                                    if _e1047 {
                                                        phi_2051_ = 0u;
                                                    } else {
                                                        phi_2051_ = select(2u, 1u, (_e1045 < (2097152f * _e144)));
                                                    }
                                                    let _e1052 = phi_2051_;
                                                    switch bitcast<i32>(_e1052) {
                                                        case 0: {
                                                            phi_2057_ = 1u;
                                                            break;
                                                        }
                                                        case 1: {
                                                            phi_2057_ = 2u;
                                                            break;
                                                        }
                                                        case 2: {
                                                            phi_2057_ = 3u;
                                                            break;
                                                        }
                                                        default: {
                                                            phi_2057_ = u32();
                                                            break;
                                                        }
                                                    }
                                                    let _e1055 = phi_2057_;
                                                    switch bitcast<i32>(_e1052) {
                                                        case 0: {
                                                            phi_2067_ = 1u;
                                                            break;
                                                        }
                                                        case 1: {
                                                            phi_2067_ = 2u;
                                                            break;
                                                        }
                                                        case 2: {
                                                            phi_2067_ = 3u;
                                                            break;
                                                        }
                                                        default: {
                                                            phi_2067_ = u32();
                                                            break;
                                                        }
                                                    }
                                                    let _e1062 = phi_2067_;
                                                    let _e1064 = ((_e532 + (_e1020.member_1 * ((3u * _e1055) + 1u))) + (3u * _e1062));
                                                    let _e1065 = (_e1064 < _e92);
                                                    if _e1065 {
                                                        if _e1065 {
                                                        } else {
                                                            phi_4735_ = true;
                                                            break;
                                                        }
                                                        let _e1067 = global_7.member[_e1064];
                                                        phi_2083_ = _e1067;
                                                    } else {
                                                        phi_2083_ = 4294967295u;
                                                    }
                                                    let _e1069 = phi_2083_;
                                                    local_4 = array<u32, 3>(_e270, _e269, _e271);
                                                    if _e1047 {
                                                        phi_2120_ = 0u;
                                                    } else {
                                                        phi_2120_ = select(2u, 1u, (_e1045 < (2097152f * _e144)));
                                                    }
                                                    let _e1075 = phi_2120_;
                                                    switch bitcast<i32>(_e1075) {
                                                        case 0: {
                                                            phi_2126_ = 1u;
                                                            break;
                                                        }
                                                        case 1: {
                                                            phi_2126_ = 2u;
                                                            break;
                                                        }
                                                        case 2: {
                                                            phi_2126_ = 3u;
                                                            break;
                                                        }
                                                        default: {
                                                            phi_2126_ = u32();
                                                            break;
                                                        }
                                                    }
                                                    let _e1078 = phi_2126_;
                                                    switch bitcast<i32>(_e1075) {
                                                        case 0: {
                                                            phi_2136_ = 1u;
                                                            break;
                                                        }
                                                        case 1: {
                                                            phi_2136_ = 2u;
                                                            break;
                                                        }
                                                        case 2: {
                                                            phi_2136_ = 3u;
                                                            break;
                                                        }
                                                        default: {
                                                            phi_2136_ = u32();
                                                            break;
                                                        }
                                                    }
                                                    let _e1085 = phi_2136_;
                                                    local_6 = array<f32, 4>(_e523.member.member.x, _e523.member.member.y, _e523.member.member.z, _e523.member.member.w);
                                                    local_5[0u] = array<f32, 3>(0f, 0f, 0f);
                                                    local_5[1u] = array<f32, 3>(0f, 0f, 0f);
                                                    local_5[2u] = array<f32, 3>(0f, 0f, 0f);
                                                    phi_4666_ = _e1001;
                                                    phi_2152_ = type_8(0u, 3u);
                                                    loop {
                                                        let _e1099 = phi_4666_;
                                                        let _e1101 = phi_2152_;
                                                        if (_e1101.member < _e1101.member_1) {
                                                            phi_2153_ = type_8((_e1101.member + 1u), _e1101.member_1);
                                                            phi_2176_ = type_8(1u, _e1101.member);
                                                        } else {
                                                            phi_2153_ = _e1101;
                                                            phi_2176_ = type_8(0u, type_8().member_1);
                                                        }
                                                        let _e1114 = phi_2153_;
                                                        let _e1116 = phi_2176_;
                                                        let _e1120 = (bitcast<i32>(_e1116.member) != 0i);
                                                        if _e1120 {
                                                            let _e1122 = ((_e532 + (_e1020.member_1 * ((3u * _e1078) + 1u))) + (_e1116.member_1 * _e1085));
                                                            let _e1123 = (_e1122 < _e92);
                                                            if _e1123 {
                                                                if _e1123 {
                                                                } else {
                                                                    phi_4733_ = true;
                                                                    break;
                                                                }
                                                                let _e1125 = global_7.member[_e1122];
                                                                phi_2199_ = _e1125;
                                                            } else {
                                                                phi_2199_ = 0u;
                                                            }
                                                            let _e1127 = phi_2199_;
                                                            let _e1128 = (_e1122 + 1u);
                                                            let _e1129 = (_e1128 < _e92);
                                                            if _e1129 {
                                                                if _e1129 {
                                                                } else {
                                                                    phi_4733_ = true;
                                                                    break;
                                                                }
                                                                let _e1131 = global_7.member[_e1128];
                                                                phi_2214_ = _e1131;
                                                            } else {
                                                                phi_2214_ = 0u;
                                                            }
                                                            let _e1133 = phi_2214_;
                                                            phi_2217_ = type_8(0u, 3u);
                                                            loop {
                                                                let _e1135 = phi_2217_;
                                                                if (_e1135.member < _e1135.member_1) {
                                                                    phi_2218_ = type_8((_e1135.member + 1u), _e1135.member_1);
                                                                    phi_2241_ = type_8(1u, _e1135.member);
                                                                } else {
                                                                    phi_2218_ = _e1135;
                                                                    phi_2241_ = type_8(0u, type_8().member_1);
                                                                }
                                                                let _e1148 = phi_2218_;
                                                                let _e1150 = phi_2241_;
                                                                let _e1154 = (bitcast<i32>(_e1150.member) != 0i);
                                                                if _e1154 {
                                                                    let _e1155 = (_e1150.member_1 < 3u);
                                                                    if _e1155 {
                                                                    } else {
                                                                        phi_4659_ = true;
                                                                        break;
                                                                    }
                                                                    let _e1157 = local_4[_e1150.member_1];
                                                                    if (_e1150.member_1 < 4u) {
                                                                    } else {
                                                                        phi_4659_ = true;
                                                                        break;
                                                                    }
                                                                    let _e1160 = local_6[_e1150.member_1];
                                                                    switch bitcast<i32>(_e1075) {
                                                                        case 0: {
                                                                            phi_2311_ = (_e1160 + (f32(((_e1127 >> bitcast<u32>(((10u * _e1157) & 31u))) & 1023u)) * _e144));
                                                                            break;
                                                                        }
                                                                        case 1: {
                                                                            if (_e1157 == 0u) {
                                                                                phi_2288_ = _e1127;
                                                                            } else {
                                                                                if (_e1157 == 1u) {
                                                                                    phi_2287_ = ((_e1127 >> bitcast<u32>(21i)) | (_e1133 << bitcast<u32>(11i)));
                                                                                } else {
                                                                                    phi_2287_ = (_e1133 >> bitcast<u32>(10i));
                                                                                }
                                                                                let _e1181 = phi_2287_;
                                                                                phi_2288_ = _e1181;
                                                                            }
                                                                            let _e1183 = phi_2288_;
                                                                            phi_2311_ = (_e1160 + (f32((_e1183 & 2097151u)) * _e144));
                                                                            break;
                                                                        }
                                                                        case 2: {
                                                                            let _e1162 = (_e1122 + _e1157);
                                                                            let _e1163 = (_e1162 < _e92);
                                                                            if _e1163 {
                                                                                if _e1163 {
                                                                                } else {
                                                                                    phi_4659_ = true;
                                                                                    break;
                                                                                }
                                                                                let _e1165 = global_7.member[_e1162];
                                                                                phi_2307_ = _e1165;
                                                                            } else {
                                                                                phi_2307_ = 0u;
                                                                            }
                                                                            let _e1167 = phi_2307_;
                                                                            phi_2311_ = (f32(bitcast<i32>(_e1167)) * _e144);
                                                                            break;
                                                                        }
                                                                        default: {
                                                                            phi_2311_ = f32();
                                                                            break;
                                                                        }
                                                                    }
                                                                    let _e1197 = phi_2311_;
                                                                    if (_e1116.member_1 < 3u) {
                                                                    } else {
                                                                        phi_4659_ = true;
                                                                        break;
                                                                    }
                                                                    if _e1155 {
                                                                    } else {
                                                                        phi_4659_ = true;
                                                                        break;
                                                                    }
                                                                    local_5[_e1116.member_1][_e1150.member_1] = _e1197;
                                                                }
                                                                continue;
                                                                continuing {
                                                                    phi_2217_ = _e1148;
                                                                    phi_4659_ = _e1099;
                                                                    break if !(_e1154);
                                                                }
                                                            }
                                                            let _e1203 = phi_4659_;
                                                            phi_4733_ = _e1203;
                                                            if _e1203 {
                                                                break;
                                                            }
                                                            phi_4734_ = _e1203;
                                                        } else {
                                                            phi_4734_ = _e1099;
                                                        }
                                                        let _e1205 = phi_4734_;
                                                        continue;
                                                        continuing {
                                                            phi_4666_ = _e1205;
                                                            phi_2152_ = _e1114;
                                                            phi_4733_ = _e1205;
                                                            break if !(_e1120);
                                                        }
                                                    }
                                                    let _e1208 = phi_4733_;
                                                    phi_4735_ = _e1208;
                                                    if _e1208 {
                                                        break;
                                                    }
                                                    let _e1209 = local_5;
                                                    let _e1226 = (_e1209[0][2] - _e371);
                                                    let _e1229 = (((_e1209[0][0] - _e298) * _e395) - (_e1226 * _e323));
                                                    let _e1232 = (((_e1209[0][1] - _e335) * _e395) - (_e1226 * _e359));
                                                    let _e1235 = (_e1209[1][2] - _e371);
                                                    let _e1238 = (((_e1209[1][0] - _e298) * _e395) - (_e1235 * _e323));
                                                    let _e1241 = (((_e1209[1][1] - _e335) * _e395) - (_e1235 * _e359));
                                                    let _e1244 = (_e1209[2][2] - _e371);
                                                    let _e1247 = (((_e1209[2][0] - _e298) * _e395) - (_e1244 * _e323));
                                                    let _e1250 = (((_e1209[2][1] - _e335) * _e395) - (_e1244 * _e359));
                                                    let _e1251 = (_e1247 * _e1241);
                                                    let _e1252 = (_e1250 * _e1238);
                                                    let _e1253 = (_e1229 * _e1250);
                                                    let _e1254 = (_e1232 * _e1247);
                                                    let _e1255 = (_e1238 * _e1232);
                                                    let _e1256 = (_e1241 * _e1229);
                                                    let _e1261 = (((_e1251 >= _e1252) && (_e1253 >= _e1254)) && (_e1255 >= _e1256));
                                                    if (_e1261 || (((_e1251 <= _e1252) && (_e1253 <= _e1254)) && (_e1255 <= _e1256))) {
                                                        let _e1268 = select(-1f, 1f, _e1261);
                                                        let _e1270 = ((_e1251 - _e1252) * _e1268);
                                                        let _e1272 = select(0f, _e1270, (_e1270 > 0f));
                                                        let _e1274 = ((_e1253 - _e1254) * _e1268);
                                                        let _e1276 = select(0f, _e1274, (_e1274 > 0f));
                                                        let _e1278 = ((_e1255 - _e1256) * _e1268);
                                                        let _e1280 = select(0f, _e1278, (_e1278 > 0f));
                                                        let _e1282 = ((_e1272 + _e1276) + _e1280);
                                                        if (_e1282 < 0.000000000000000000000000000000000000011754944f) {
                                                            phi_2906_ = type_18();
                                                            phi_2907_ = true;
                                                        } else {
                                                            let _e1285 = select(_e1209[1][0], _e1209[0][0], (_e1209[0][0] < _e1209[1][0]));
                                                            let _e1289 = select(_e1209[1][0], _e1209[0][0], (_e1209[0][0] > _e1209[1][0]));
                                                            let _e1293 = select(_e1209[1][1], _e1209[0][1], (_e1209[0][1] < _e1209[1][1]));
                                                            let _e1297 = select(_e1209[1][1], _e1209[0][1], (_e1209[0][1] > _e1209[1][1]));
                                                            let _e1301 = select(_e1209[1][2], _e1209[0][2], (_e1209[0][2] < _e1209[1][2]));
                                                            let _e1305 = select(_e1209[1][2], _e1209[0][2], (_e1209[0][2] > _e1209[1][2]));
                                                            let _e1310 = ((select(_e1209[2][0], _e1285, (_e1285 < _e1209[2][0])) - _e321) * _e326);
                                                            let _e1311 = ((select(_e1209[2][0], _e1289, (_e1289 > _e1209[2][0])) - _e322) * _e326);
                                                            let _e1314 = ((select(_e1209[2][1], _e1293, (_e1293 < _e1209[2][1])) - _e357) * _e362);
                                                            let _e1315 = ((select(_e1209[2][1], _e1297, (_e1297 > _e1209[2][1])) - _e358) * _e362);
                                                            let _e1318 = ((select(_e1209[2][2], _e1301, (_e1301 < _e1209[2][2])) - _e393) * _e398);
                                                            let _e1319 = ((select(_e1209[2][2], _e1305, (_e1305 > _e1209[2][2])) - _e394) * _e398);
                                                            let _e1321 = select(_e1319, _e1318, (_e1318 < _e1319));
                                                            let _e1323 = select(_e1319, _e1318, (_e1318 > _e1319));
                                                            let _e1325 = select(_e1311, _e1310, (_e1310 < _e1311));
                                                            let _e1327 = select(_e1315, _e1314, (_e1314 < _e1315));
                                                            let _e1329 = select(_e1327, _e1325, (_e1325 > _e1327));
                                                            let _e1331 = select(_e1321, _e1329, (_e1329 > _e1321));
                                                            let _e1333 = select(_e1311, _e1310, (_e1310 > _e1311));
                                                            let _e1335 = select(_e1315, _e1314, (_e1314 > _e1315));
                                                            let _e1337 = select(_e1335, _e1333, (_e1333 < _e1335));
                                                            let _e1339 = select(_e1323, _e1337, (_e1337 < _e1323));
                                                            let _e1340 = -(_e1321);
                                                            let _e1346 = select(_e444, _e1331, (_e1331 > _e444));
                                                            if (_e1346 > (_e1339 + (select(_e1340, _e1323, (_e1323 > _e1340)) * 0.0000019073523f))) {
                                                                phi_2901_ = type_18();
                                                                phi_2902_ = true;
                                                            } else {
                                                                let _e1348 = (_e1346 > _e1003.member.member_1);
                                                                if _e1348 {
                                                                    phi_2900_ = type_18();
                                                                } else {
                                                                    let _e1352 = (_e1209[1][0] - _e1209[0][0]);
                                                                    let _e1353 = (_e1209[1][1] - _e1209[0][1]);
                                                                    let _e1354 = (_e1209[1][2] - _e1209[0][2]);
                                                                    let _e1355 = vec3<f32>(_e1352, _e1353, _e1354);
                                                                    let _e1356 = (_e1209[2][0] - _e1209[1][0]);
                                                                    let _e1357 = (_e1209[2][1] - _e1209[1][1]);
                                                                    let _e1358 = (_e1209[2][2] - _e1209[1][2]);
                                                                    let _e1359 = vec3<f32>(_e1356, _e1357, _e1358);
                                                                    let _e1360 = (_e1209[0][0] - _e1209[2][0]);
                                                                    let _e1361 = (_e1209[0][1] - _e1209[2][1]);
                                                                    let _e1362 = (_e1209[0][2] - _e1209[2][2]);
                                                                    let _e1363 = vec3<f32>(_e1360, _e1361, _e1362);
                                                                    let _e1366 = bitcast<f32>((bitcast<u32>(_e1352) & 2147483647u));
                                                                    let _e1369 = bitcast<f32>((bitcast<u32>(_e1353) & 2147483647u));
                                                                    let _e1371 = select(_e1369, _e1366, (_e1366 > _e1369));
                                                                    let _e1374 = bitcast<f32>((bitcast<u32>(_e1354) & 2147483647u));
                                                                    let _e1376 = select(_e1374, _e1371, (_e1371 > _e1374));
                                                                    let _e1379 = bitcast<f32>((bitcast<u32>(_e1356) & 2147483647u));
                                                                    let _e1382 = bitcast<f32>((bitcast<u32>(_e1357) & 2147483647u));
                                                                    let _e1384 = select(_e1382, _e1379, (_e1379 > _e1382));
                                                                    let _e1387 = bitcast<f32>((bitcast<u32>(_e1358) & 2147483647u));
                                                                    let _e1389 = select(_e1387, _e1384, (_e1384 > _e1387));
                                                                    let _e1392 = bitcast<f32>((bitcast<u32>(_e1360) & 2147483647u));
                                                                    let _e1395 = bitcast<f32>((bitcast<u32>(_e1361) & 2147483647u));
                                                                    let _e1397 = select(_e1395, _e1392, (_e1392 > _e1395));
                                                                    let _e1400 = bitcast<f32>((bitcast<u32>(_e1362) & 2147483647u));
                                                                    let _e1402 = select(_e1400, _e1397, (_e1397 > _e1400));
                                                                    let _e1404 = select(_e1389, _e1376, (_e1376 > _e1389));
                                                                    let _e1406 = select(_e1402, _e1404, (_e1404 > _e1402));
                                                                    if (_e1376 == _e1406) {
                                                                        phi_2811_ = _e1359;
                                                                        phi_2812_ = _e1363;
                                                                    } else {
                                                                        let _e1409 = vec3((_e1389 == _e1406));
                                                                        phi_2811_ = select(_e1355, _e1363, _e1409);
                                                                        phi_2812_ = select(_e1359, _e1355, _e1409);
                                                                    }
                                                                    let _e1413 = phi_2811_;
                                                                    let _e1415 = phi_2812_;
                                                                    let _e1422 = ((_e1413.y * _e1415.z) - (_e1415.y * _e1413.z));
                                                                    let _e1427 = ((_e1413.z * _e1415.x) - (_e1415.z * _e1413.x));
                                                                    let _e1430 = ((_e1413.x * _e1415.y) - (_e1415.x * _e1413.y));
                                                                    if (_e1272 >= _e1276) {
                                                                        phi_2843_ = select(true, false, (_e1272 >= _e1280));
                                                                    } else {
                                                                        phi_2843_ = true;
                                                                    }
                                                                    let _e1435 = phi_2843_;
                                                                    if _e1435 {
                                                                        phi_2852_ = select(vec3<f32>(_e1209[2][0], _e1209[2][1], _e1209[2][2]), vec3<f32>(_e1209[1][0], _e1209[1][1], _e1209[1][2]), vec3((_e1276 >= _e1280)));
                                                                    } else {
                                                                        phi_2852_ = vec3<f32>(_e1209[0][0], _e1209[0][1], _e1209[0][2]);
                                                                    }
                                                                    let _e1440 = phi_2852_;
                                                                    let _e1457 = ((((_e1422 * (_e1440.x - _e298)) + (_e1427 * (_e1440.y - _e335))) + (_e1430 * (_e1440.z - _e371))) / (((_e1422 * _e323) + (_e1427 * _e359)) + (_e1430 * _e395)));
                                                                    let _e1459 = select(_e1339, _e1457, (_e1457 < _e1339));
                                                                    let _e1461 = select(_e1331, _e1459, (_e1459 > _e1331));
                                                                    if (_e1461 >= _e444) {
                                                                        let _e1463 = (_e1461 <= _e1003.member.member_1);
                                                                        if _e1463 {
                                                                            let _e1464 = (1f / _e1282);
                                                                            phi_2892_ = type_18(_e1461, (_e1276 * _e1464), (_e1280 * _e1464), _e1069);
                                                                        } else {
                                                                            phi_2892_ = type_18();
                                                                        }
                                                                        let _e1469 = phi_2892_;
                                                                        phi_2894_ = _e1469;
                                                                        phi_2895_ = select(true, false, _e1463);
                                                                    } else {
                                                                        phi_2894_ = type_18();
                                                                        phi_2895_ = true;
                                                                    }
                                                                    let _e1472 = phi_2894_;
                                                                    let _e1474 = phi_2895_;
                                                                    if _e1474 {
                                                                        phi_2899_ = type_18(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                    } else {
                                                                        phi_2899_ = _e1472;
                                                                    }
                                                                    let _e1476 = phi_2899_;
                                                                    phi_2900_ = _e1476;
                                                                }
                                                                let _e1478 = phi_2900_;
                                                                phi_2901_ = _e1478;
                                                                phi_2902_ = _e1348;
                                                            }
                                                            let _e1480 = phi_2901_;
                                                            let _e1482 = phi_2902_;
                                                            phi_2906_ = _e1480;
                                                            phi_2907_ = _e1482;
                                                        }
                                                        let _e1484 = phi_2906_;
                                                        let _e1486 = phi_2907_;
                                                        phi_2911_ = _e1484;
                                                        phi_2912_ = _e1486;
                                                    } else {
                                                        phi_2911_ = type_18();
                                                        phi_2912_ = true;
                                                    }
                                                    let _e1488 = phi_2911_;
                                                    let _e1490 = phi_2912_;
                                                    if _e1490 {
                                                        phi_2916_ = type_18(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                    } else {
                                                        phi_2916_ = _e1488;
                                                    }
                                                    let _e1492 = phi_2916_;
                                                    if (_e1492.member_3 != 4294967295u) {
                                                        if (_e1069 != _e450) {
                                                            if (_e1492.member < _e1003.member.member.member) {
                                                                phi_2942_ = true;
                                                            } else {
                                                                if (_e1492.member == _e1003.member.member.member) {
                                                                    phi_2941_ = (_e1492.member_3 < _e1003.member.member.member_3);
                                                                } else {
                                                                    phi_2941_ = false;
                                                                }
                                                                let _e1507 = phi_2941_;
                                                                phi_2942_ = _e1507;
                                                            }
                                                            let _e1509 = phi_2942_;
                                                            if _e1509 {
                                                                phi_2949_ = type_37(type_34(_e1492, _e1492.member), _e1030.member_1, _e1030.member_2);
                                                            } else {
                                                                phi_2949_ = _e1030;
                                                            }
                                                            let _e1516 = phi_2949_;
                                                            phi_2950_ = _e1516;
                                                        } else {
                                                            phi_2950_ = _e1030;
                                                        }
                                                        let _e1518 = phi_2950_;
                                                        phi_2951_ = _e1518;
                                                    } else {
                                                        phi_2951_ = _e1030;
                                                    }
                                                    let _e1520 = phi_2951_;
                                                    phi_4736_ = _e1208;
                                                    phi_1982_ = _e1520;
                                                } else {
                                                    phi_4736_ = _e1001;
                                                    phi_1982_ = type_37();
                                                }
                                                let _e1522 = phi_4736_;
                                                let _e1524 = phi_1982_;
                                                continue;
                                                continuing {
                                                    phi_4681_ = _e1522;
                                                    phi_1981_ = _e1524;
                                                    phi_1984_ = _e1018;
                                                    phi_4735_ = _e1522;
                                                    break if !(_e1024);
                                                }
                                            }
                                            let _e1527 = phi_4735_;
                                            phi_4794_ = _e1527;
                                            if _e1527 {
                                                break;
                                            }
                                            phi_4798_ = _e1527;
                                            let _e1768 = local_9;
                                            phi_4292_ = _e1768;
                                            phi_4293_ = _e523;
                                            phi_4294_ = false;
                                            phi_4295_ = _e527;
                                        } else {
                                            if (_e523.member_1 >= _e89) {
                                                phi_3892_ = type_55(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), type_52(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u), type_52(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u));
                                            } else {
                                                if (_e523.member_1 < _e89) {
                                                } else {
                                                    phi_4794_ = true;
                                                    break;
                                                }
                                                let _e547 = ((1u + (_e270 * 2u)) % 7u);
                                                if (_e547 < 7u) {
                                                } else {
                                                    phi_4794_ = true;
                                                    break;
                                                }
                                                let _e552 = global_6.member[_e523.member_1][_e547];
                                                let _e555 = ((1u + (_e269 * 2u)) % 7u);
                                                if (_e555 < 7u) {
                                                } else {
                                                    phi_4794_ = true;
                                                    break;
                                                }
                                                let _e560 = global_6.member[_e523.member_1][_e555];
                                                let _e563 = ((1u + (_e271 * 2u)) % 7u);
                                                if (_e563 < 7u) {
                                                } else {
                                                    phi_4794_ = true;
                                                    break;
                                                }
                                                let _e568 = global_6.member[_e523.member_1][_e563];
                                                let _e571 = (((_e270 + 1u) * 2u) % 7u);
                                                if (_e571 < 7u) {
                                                } else {
                                                    phi_4794_ = true;
                                                    break;
                                                }
                                                let _e576 = global_6.member[_e523.member_1][_e571];
                                                let _e579 = (((_e269 + 1u) * 2u) % 7u);
                                                if (_e579 < 7u) {
                                                } else {
                                                    phi_4794_ = true;
                                                    break;
                                                }
                                                let _e584 = global_6.member[_e523.member_1][_e579];
                                                let _e587 = (((_e271 + 1u) * 2u) % 7u);
                                                if (_e587 < 7u) {
                                                } else {
                                                    phi_4794_ = true;
                                                    break;
                                                }
                                                let _e592 = global_6.member[_e523.member_1][_e587];
                                                let _e615 = (bitcast<f32>((bitcast<u32>((_e523.member.member_1.x - _e523.member.member.x)) & 2139095040u)) * 0.0000009536743f);
                                                let _e616 = (bitcast<f32>((bitcast<u32>((_e523.member.member_1.y - _e523.member.member.y)) & 2139095040u)) * 0.0000009536743f);
                                                let _e617 = (bitcast<f32>((bitcast<u32>((_e523.member.member_1.z - _e523.member.member.z)) & 2139095040u)) * 0.0000009536743f);
                                                let _e619 = select(_e144, _e615, (_e615 > _e144));
                                                let _e621 = select(_e144, _e616, (_e616 > _e144));
                                                let _e623 = select(_e144, _e617, (_e617 > _e144));
                                                let _e648 = bitcast<u32>((f32(bitcast<i32>((_e552 & 2097151u))) * _e619));
                                                let _e653 = (bitcast<i32>((_e552 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                                let _e656 = bitcast<f32>((_e648 & bitcast<u32>(_e653)));
                                                let _e657 = bitcast<u32>((f32(bitcast<i32>((_e560 & 2097151u))) * _e621));
                                                let _e662 = (bitcast<i32>((_e560 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                                let _e665 = bitcast<f32>((_e657 & bitcast<u32>(_e662)));
                                                let _e666 = bitcast<u32>((f32(bitcast<i32>((_e568 & 2097151u))) * _e623));
                                                let _e671 = (bitcast<i32>((_e568 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                                let _e674 = bitcast<f32>((_e666 & bitcast<u32>(_e671)));
                                                let _e678 = bitcast<f32>((_e648 & bitcast<u32>(~(_e653))));
                                                let _e682 = bitcast<f32>((_e657 & bitcast<u32>(~(_e662))));
                                                let _e686 = bitcast<f32>((_e666 & bitcast<u32>(~(_e671))));
                                                let _e687 = bitcast<u32>((f32(bitcast<i32>((_e576 & 2097151u))) * _e619));
                                                let _e692 = (bitcast<i32>((_e576 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                                let _e695 = bitcast<f32>((_e687 & bitcast<u32>(_e692)));
                                                let _e696 = bitcast<u32>((f32(bitcast<i32>((_e584 & 2097151u))) * _e621));
                                                let _e701 = (bitcast<i32>((_e584 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                                let _e704 = bitcast<f32>((_e696 & bitcast<u32>(_e701)));
                                                let _e705 = bitcast<u32>((f32(bitcast<i32>((_e592 & 2097151u))) * _e623));
                                                let _e710 = (bitcast<i32>((_e592 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                                let _e713 = bitcast<f32>((_e705 & bitcast<u32>(_e710)));
                                                let _e717 = bitcast<f32>((_e687 & bitcast<u32>(~(_e692))));
                                                let _e721 = bitcast<f32>((_e696 & bitcast<u32>(~(_e701))));
                                                let _e725 = bitcast<f32>((_e705 & bitcast<u32>(~(_e710))));
                                                let _e726 = (_e523.member.member.x + _e656);
                                                let _e727 = (_e523.member.member.y + _e665);
                                                let _e728 = (_e523.member.member.z + _e674);
                                                let _e731 = (_e523.member.member_1.x - _e695);
                                                let _e732 = (_e523.member.member_1.y - _e704);
                                                let _e733 = (_e523.member.member_1.z - _e713);
                                                let _e752 = (_e731 - _e726);
                                                let _e753 = (_e732 - _e727);
                                                let _e754 = (_e733 - _e728);
                                                let _e756 = select(_e753, _e752, (_e752 > _e753));
                                                let _e758 = select(_e754, _e756, (_e756 > _e754));
                                                if (_e758 < (1024f * _e144)) {
                                                    phi_3593_ = 0u;
                                                } else {
                                                    phi_3593_ = select(2u, 1u, (_e758 < (2097152f * _e144)));
                                                }
                                                let _e765 = phi_3593_;
                                                switch bitcast<i32>(_e765) {
                                                    case 0: {
                                                        phi_3599_ = 1u;
                                                        break;
                                                    }
                                                    case 1: {
                                                        phi_3599_ = 2u;
                                                        break;
                                                    }
                                                    case 2: {
                                                        phi_3599_ = 3u;
                                                        break;
                                                    }
                                                    default: {
                                                        phi_3599_ = u32();
                                                        break;
                                                    }
                                                }
                                                let _e768 = phi_3599_;
                                                let _e774 = global_6.member[_e523.member_1][0u];
                                                let _e778 = global_6.member[_e523.member_1][2u];
                                                let _e782 = global_6.member[_e523.member_1][4u];
                                                let _e786 = global_6.member[_e523.member_1][6u];
                                                let _e798 = (((_e778 >> bitcast<u32>(22i)) | ((_e782 >> bitcast<u32>(22i)) << bitcast<u32>(10i))) | ((_e786 >> bitcast<u32>(22i)) << bitcast<u32>(20i)));
                                                let _e799 = (_e774 & 268435455u);
                                                let _e800 = (_e798 & 268435455u);
                                                let _e803 = ((_e774 >> bitcast<u32>(28u)) & 7u);
                                                let _e811 = ((_e774 >> bitcast<u32>(31i)) | (((_e798 >> bitcast<u32>(28u)) & 3u) << bitcast<u32>(1i)));
                                                let _e812 = (_e803 != 0u);
                                                if (_e803 == 0u) {
                                                    phi_3854_ = _e799;
                                                } else {
                                                    if (_e803 == 7u) {
                                                        phi_3853_ = 2147483648u;
                                                    } else {
                                                        phi_3853_ = ((2147483648u | (_e803 << bitcast<u32>(28u))) | (_e800 & 268435455u));
                                                    }
                                                    let _e821 = phi_3853_;
                                                    phi_3854_ = _e821;
                                                }
                                                let _e823 = phi_3854_;
                                                if _e812 {
                                                    let _e824 = (_e803 != 7u);
                                                    if _e824 {
                                                        phi_3864_ = (_e800 + (_e803 * ((3u * _e768) + 1u)));
                                                    } else {
                                                        phi_3864_ = u32();
                                                    }
                                                    let _e828 = phi_3864_;
                                                    phi_3866_ = _e828;
                                                    phi_3867_ = select(true, false, _e824);
                                                } else {
                                                    phi_3866_ = u32();
                                                    phi_3867_ = true;
                                                }
                                                let _e831 = phi_3866_;
                                                let _e833 = phi_3867_;
                                                if (_e811 == 0u) {
                                                    phi_3888_ = (_e799 + select(0u, 1u, !(_e812)));
                                                } else {
                                                    if (_e811 == 7u) {
                                                        phi_3887_ = 2147483648u;
                                                    } else {
                                                        phi_3887_ = ((2147483648u | (_e811 << bitcast<u32>(28u))) | (select(_e831, _e800, _e833) & 268435455u));
                                                    }
                                                    let _e846 = phi_3887_;
                                                    phi_3888_ = _e846;
                                                }
                                                let _e848 = phi_3888_;
                                                phi_3892_ = type_55(array<vec4<f32>, 3>(vec4<f32>(_e726, (_e523.member.member.x + _e678), _e731, (_e523.member.member_1.x - _e717)), vec4<f32>(_e727, (_e523.member.member.y + _e682), _e732, (_e523.member.member_1.y - _e721)), vec4<f32>(_e728, (_e523.member.member.z + _e686), _e733, (_e523.member.member_1.z - _e725))), type_52(type_30((_e523.member.member + vec4<f32>(_e656, _e665, _e674, 0f)), (_e523.member.member_1 - vec4<f32>(_e695, _e704, _e713, 0f))), _e823), type_52(type_30((_e523.member.member + vec4<f32>(_e678, _e682, _e686, 0f)), (_e523.member.member_1 - vec4<f32>(_e717, _e721, _e725, 0f))), _e848));
                                            }
                                            let _e853 = phi_3892_;
                                            let _e866 = ((_e853.member[0].x - _e321) * _e326);
                                            let _e867 = ((_e853.member[0].y - _e321) * _e326);
                                            let _e868 = ((_e853.member[0].z - _e322) * _e326);
                                            let _e869 = ((_e853.member[0].w - _e322) * _e326);
                                            let _e879 = ((_e853.member[1].x - _e357) * _e362);
                                            let _e880 = ((_e853.member[1].y - _e357) * _e362);
                                            let _e881 = ((_e853.member[1].z - _e358) * _e362);
                                            let _e882 = ((_e853.member[1].w - _e358) * _e362);
                                            let _e892 = ((_e853.member[2].x - _e393) * _e398);
                                            let _e893 = ((_e853.member[2].y - _e393) * _e398);
                                            let _e894 = ((_e853.member[2].z - _e394) * _e398);
                                            let _e895 = ((_e853.member[2].w - _e394) * _e398);
                                            let _e897 = select(_e894, _e892, (_e892 < _e894));
                                            let _e899 = select(_e895, _e893, (_e893 < _e895));
                                            let _e901 = select(_e894, _e892, (_e892 > _e894));
                                            let _e903 = select(_e895, _e893, (_e893 > _e895));
                                            let _e905 = select(_e868, _e866, (_e866 < _e868));
                                            let _e907 = select(_e869, _e867, (_e867 < _e869));
                                            let _e909 = select(_e881, _e879, (_e879 < _e881));
                                            let _e911 = select(_e882, _e880, (_e880 < _e882));
                                            let _e913 = select(_e909, _e905, (_e905 > _e909));
                                            let _e915 = select(_e911, _e907, (_e907 > _e911));
                                            let _e917 = select(_e897, _e913, (_e913 > _e897));
                                            let _e919 = select(_e899, _e915, (_e915 > _e899));
                                            let _e921 = select(_e868, _e866, (_e866 > _e868));
                                            let _e923 = select(_e869, _e867, (_e867 > _e869));
                                            let _e925 = select(_e881, _e879, (_e879 > _e881));
                                            let _e927 = select(_e882, _e880, (_e880 > _e882));
                                            let _e929 = select(_e925, _e921, (_e921 < _e925));
                                            let _e931 = select(_e927, _e923, (_e923 < _e927));
                                            let _e936 = -(_e897);
                                            let _e937 = -(_e899);
                                            let _e944 = (select(_e901, _e929, (_e929 < _e901)) + (select(_e936, _e901, (_e901 > _e936)) * 0.0000019073523f));
                                            let _e945 = (select(_e903, _e931, (_e931 < _e903)) + (select(_e937, _e903, (_e903 > _e937)) * 0.0000019073523f));
                                            let _e947 = select(_e444, _e917, (_e917 > _e444));
                                            let _e949 = select(_e444, _e919, (_e919 > _e444));
                                            let _e954 = (_e947 <= select(_e493.member.member_1, _e944, (_e944 < _e493.member.member_1)));
                                            let _e955 = (_e949 <= select(_e493.member.member_1, _e945, (_e945 < _e493.member.member_1)));
                                            let _e956 = (_e947 <= _e949);
                                            if _e954 {
                                                if _e955 {
                                                    if _e956 {
                                                        phi_4236_ = _e853.member_2;
                                                    } else {
                                                        phi_4236_ = _e853.member_1;
                                                    }
                                                    let _e960 = phi_4236_;
                                                    let _e961 = (_e527 % 128u);
                                                    let _e962 = (_e961 < 128u);
                                                    if _e962 {
                                                    } else {
                                                        phi_4794_ = true;
                                                        break;
                                                    }
                                                    local_3[_e961] = type_52(type_30(_e960.member.member, _e960.member.member_1), _e960.member_1);
                                                    if _e962 {
                                                    } else {
                                                        phi_4794_ = true;
                                                        break;
                                                    }
                                                    local_2[_e961] = select(_e949, _e947, (_e947 > _e949));
                                                    if _e956 {
                                                        phi_4269_ = _e853.member_1;
                                                    } else {
                                                        phi_4269_ = _e853.member_2;
                                                    }
                                                    let _e977 = phi_4269_;
                                                    phi_4270_ = _e977;
                                                    phi_4271_ = (_e527 + 1u);
                                                } else {
                                                    phi_4270_ = type_52();
                                                    phi_4271_ = u32();
                                                }
                                                let _e979 = phi_4270_;
                                                let _e981 = phi_4271_;
                                                phi_4273_ = _e979;
                                                phi_4274_ = _e981;
                                                phi_4275_ = select(true, false, _e955);
                                            } else {
                                                phi_4273_ = type_52();
                                                phi_4274_ = u32();
                                                phi_4275_ = true;
                                            }
                                            let _e984 = phi_4273_;
                                            let _e986 = phi_4274_;
                                            let _e988 = phi_4275_;
                                            if _e988 {
                                                if _e954 {
                                                    phi_4284_ = _e853.member_1;
                                                } else {
                                                    phi_4284_ = _e853.member_2;
                                                }
                                                let _e992 = phi_4284_;
                                                phi_4289_ = _e992;
                                                phi_4290_ = select(_e955, true, _e954);
                                            } else {
                                                phi_4289_ = _e984;
                                                phi_4290_ = _e525;
                                            }
                                            let _e995 = phi_4289_;
                                            let _e997 = phi_4290_;
                                            phi_4798_ = _e491;
                                            phi_4292_ = type_37(_e493.member, (_e493.member_1 + 1u), _e493.member_2);
                                            phi_4293_ = _e995;
                                            phi_4294_ = _e997;
                                            phi_4295_ = select(_e986, _e527, _e988);
                                        }
                                        let _e1529 = phi_4798_;
                                        let _e1531 = phi_4292_;
                                        let _e1533 = phi_4293_;
                                        let _e1535 = phi_4294_;
                                        let _e1537 = phi_4295_;
                                        phi_4797_ = _e1529;
                                        phi_4296_ = _e1531;
                                        phi_4297_ = _e1533;
                                        phi_4298_ = (_e497 - 1u);
                                        phi_4299_ = _e1535;
                                        phi_4300_ = _e1537;
                                    } else {
                                        phi_4797_ = _e491;
                                        phi_4296_ = _e493;
                                        phi_4297_ = _e523;
                                        phi_4298_ = _e497;
                                        phi_4299_ = _e525;
                                        phi_4300_ = _e527;
                                    }
                                    let _e1539 = phi_4797_;
                                    let _e1541 = phi_4296_;
                                    let _e1543 = phi_4297_;
                                    let _e1545 = phi_4298_;
                                    let _e1547 = phi_4299_;
                                    let _e1549 = phi_4300_;
                                    phi_4796_ = _e1539;
                                    phi_4301_ = _e1541;
                                    phi_4302_ = _e1543;
                                    phi_4303_ = _e1545;
                                    phi_4304_ = _e1547;
                                    phi_4305_ = _e1549;
                                } else {
                                    phi_4796_ = _e491;
                                    phi_4301_ = type_37();
                                    phi_4302_ = type_52();
                                    phi_4303_ = u32();
                                    phi_4304_ = bool();
                                    phi_4305_ = u32();
                                }
                                let _e1551 = phi_4796_;
                                let _e1553 = phi_4301_;
                                let _e1555 = phi_4302_;
                                let _e1557 = phi_4303_;
                                let _e1559 = phi_4304_;
                                let _e1561 = phi_4305_;
                                phi_4795_ = _e1551;
                                phi_1904_ = _e1553;
                                phi_1907_ = _e1555;
                                phi_1909_ = _e1557;
                                phi_1911_ = _e1559;
                                phi_1913_ = _e1561;
                                phi_4306_ = _e505;
                            } else {
                                phi_4795_ = _e491;
                                phi_1904_ = type_37();
                                phi_1907_ = type_52();
                                phi_1909_ = u32();
                                phi_1911_ = bool();
                                phi_1913_ = u32();
                                phi_4306_ = false;
                            }
                            let _e1563 = phi_4795_;
                            let _e1565 = phi_1904_;
                            let _e1567 = phi_1907_;
                            let _e1569 = phi_1909_;
                            let _e1571 = phi_1911_;
                            let _e1573 = phi_1913_;
                            let _e1575 = phi_4306_;
                            continue;
                            continuing {
                                phi_4684_ = _e1563;
                                phi_1903_ = _e1565;
                                phi_1906_ = _e1567;
                                phi_1908_ = _e1569;
                                phi_1910_ = _e1571;
                                phi_1912_ = _e1573;
                                phi_4794_ = _e1563;
                                break if !(_e1575);
                            }
                        }
                        let _e1578 = phi_4794_;
                        if _e1578 {
                            break;
                        }
                        let _e1580 = local_7;
                        if (_e1580.member.member.member_3 != 4294967295u) {
                            let _e1586 = (_e272 / 3i);
                            let _e1593 = bitcast<f32>((bitcast<u32>((_e1586 + 127i)) << bitcast<u32>(23i)));
                            let _e1601 = (((_e1580.member.member.member * _e1593) * _e1593) * bitcast<f32>((bitcast<u32>(((_e272 - (2i * _e1586)) + 127i)) << bitcast<u32>(23i))));
                            let _e1603 = select(340282350000000000000000000000000000000f, _e1601, (_e1601 < 340282350000000000000000000000000000000f));
                            phi_4358_ = type_18(select(-340282350000000000000000000000000000000f, _e1603, (_e1603 > -340282350000000000000000000000000000000f)), _e1580.member.member.member_1, _e1580.member.member.member_2, _e1580.member.member.member_3);
                        } else {
                            phi_4358_ = type_18(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                        }
                        let _e1610 = phi_4358_;
                        if _e148 {
                        } else {
                            break;
                        }
                        global_1.member[_e132] = _e1610;
                        let _e1614 = local_8;
                        if _e149 {
                        } else {
                            break;
                        }
                        global_4.member[_e132] = _e1614.member_1;
                        if _e147 {
                        } else {
                            break;
                        }
                        let _e1619 = select(0u, 1u, (_e216 <= _e226));
                        if (_e1619 > 0u) {
                            let _e1621 = (1u < _e100);
                            if _e1621 {
                                if (0u < _e100) {
                                } else {
                                    break;
                                }
                                let _e1625 = atomicAdd((&global_5.member[0u]), _e1619);
                                if ((_e1625 + _e1619) < _e1625) {
                                    if _e1621 {
                                    } else {
                                        break;
                                    }
                                    let _e1630 = atomicAdd((&global_5.member[1u]), 1u);
                                }
                            }
                        }
                        let _e1633 = select(0u, 1u, (_e1610.member_3 != 4294967295u));
                        if (_e1633 > 0u) {
                            let _e1635 = (3u < _e100);
                            if _e1635 {
                                if (2u < _e100) {
                                } else {
                                    break;
                                }
                                let _e1639 = atomicAdd((&global_5.member[2u]), _e1633);
                                if ((_e1639 + _e1633) < _e1639) {
                                    if _e1635 {
                                    } else {
                                        break;
                                    }
                                    let _e1644 = atomicAdd((&global_5.member[3u]), 1u);
                                }
                            }
                        }
                        if (_e1614.member_1 > 0u) {
                            let _e1646 = (5u < _e100);
                            if _e1646 {
                                if (4u < _e100) {
                                } else {
                                    break;
                                }
                                let _e1650 = atomicAdd((&global_5.member[4u]), _e1614.member_1);
                                if ((_e1650 + _e1614.member_1) < _e1650) {
                                    if _e1646 {
                                    } else {
                                        break;
                                    }
                                    let _e1655 = atomicAdd((&global_5.member[5u]), 1u);
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
