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
    var phi_1903_: type_41;
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
    var phi_1981_: type_41;
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
    var phi_2892_: type_22;
    var phi_2894_: type_22;
    var phi_2895_: bool;
    var phi_2899_: type_22;
    var phi_2900_: type_22;
    var phi_2901_: type_22;
    var phi_2902_: bool;
    var phi_2906_: type_22;
    var phi_2907_: bool;
    var phi_2911_: type_22;
    var phi_2912_: bool;
    var phi_2916_: type_22;
    var phi_2941_: bool;
    var phi_2942_: bool;
    var phi_2949_: type_41;
    var phi_2950_: type_41;
    var phi_2951_: type_41;
    var phi_4736_: bool;
    var phi_1982_: type_41;
    var phi_4735_: bool;
    var phi_4798_: bool;
    var phi_4292_: type_41;
    var phi_4293_: type_52;
    var phi_4294_: bool;
    var phi_4295_: u32;
    var phi_4797_: bool;
    var phi_4296_: type_41;
    var phi_4297_: type_52;
    var phi_4298_: u32;
    var phi_4299_: bool;
    var phi_4300_: u32;
    var phi_4796_: bool;
    var phi_4301_: type_41;
    var phi_4302_: type_52;
    var phi_4303_: u32;
    var phi_4304_: bool;
    var phi_4305_: u32;
    var phi_4795_: bool;
    var phi_1904_: type_41;
    var phi_1907_: type_52;
    var phi_1909_: u32;
    var phi_1911_: bool;
    var phi_1913_: u32;
    var phi_4306_: bool;
    var phi_4794_: bool;
    var local_7: type_41;
    var phi_4358_: type_22;
    var local_8: type_41;
    var local_9: type_41;

    switch bitcast<i32>(0u) {
        default: {
            let _e88 = global;
            let _e90 = arrayLength((&global_3.member));
            let _e93 = arrayLength((&global_7.member));
            let _e101 = arrayLength((&global_6.member));
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
            let _e148 = (_e133 < arrayLength((&global_4.member)));
            if _e148 {
                let _e149 = (_e133 < arrayLength((&global_1.member)));
                if _e149 {
                    let _e150 = (_e133 < arrayLength((&global_5.member)));
                    if _e150 {
                        if _e148 {
                        } else {
                            break;
                        }
                        let _e160 = global_4.member[_e133].member.member_2[0u];
                        let _e162 = (bitcast<u32>(_e160) & 2147483647u);
                        let _e168 = global_4.member[_e133].member.member_2[1u];
                        let _e170 = (bitcast<u32>(_e168) & 2147483647u);
                        let _e176 = global_4.member[_e133].member.member_2[2u];
                        let _e178 = (bitcast<u32>(_e176) & 2147483647u);
                        let _e184 = global_4.member[_e133].member.member[0u];
                        let _e186 = (bitcast<u32>(_e184) & 2147483647u);
                        let _e192 = global_4.member[_e133].member.member[1u];
                        let _e194 = (bitcast<u32>(_e192) & 2147483647u);
                        let _e200 = global_4.member[_e133].member.member[2u];
                        let _e202 = (bitcast<u32>(_e200) & 2147483647u);
                        let _e204 = select(_e170, _e162, (_e170 < _e162));
                        let _e206 = select(_e178, _e204, (_e178 < _e204));
                        let _e208 = select(_e186, _e206, (_e186 < _e206));
                        let _e210 = select(_e194, _e208, (_e194 < _e208));
                        let _e212 = select(_e202, _e210, (_e202 < _e210));
                        let _e217 = global_4.member[_e133].member.member_1;
                        let _e219 = (bitcast<u32>(_e217) & 2147483647u);
                        let _e227 = global_4.member[_e133].member.member_3;
                        let _e233 = (((select(_e219, _e212, (_e219 < _e212)) < 2139095040u) && ((bitcast<u32>(_e227) & 2147483647u) <= 2139095040u)) && (_e206 > 0u));
                        if _e233 {
                            let _e236 = (bitcast<u32>(bitcast<f32>(_e206)) & 2147483647u);
                            if (_e236 >= 8388608u) {
                                phi_410_ = (bitcast<i32>((_e236 >> bitcast<u32>(23i))) - 127i);
                            } else {
                                phi_410_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e236)), 32u, (_e236 == 0u))));
                            }
                            let _e250 = phi_410_;
                            phi_411_ = _e250;
                        } else {
                            phi_411_ = 0i;
                        }
                        let _e252 = phi_411_;
                        let _e253 = (_e162 == _e206);
                        if _e253 {
                            phi_421_ = true;
                        } else {
                            phi_421_ = (_e170 == _e206);
                        }
                        let _e256 = phi_421_;
                        let _e257 = select(1u, 0u, _e253);
                        if _e256 {
                            let _e258 = (_e257 + 1u);
                            phi_431_ = _e258;
                            phi_432_ = _e258;
                            phi_434_ = select(true, false, (_e258 == 2u));
                        } else {
                            phi_431_ = u32();
                            phi_432_ = 0u;
                            phi_434_ = true;
                        }
                        let _e262 = phi_431_;
                        let _e264 = phi_432_;
                        let _e266 = phi_434_;
                        if _e266 {
                            phi_439_ = (_e264 + 1u);
                        } else {
                            phi_439_ = 0u;
                        }
                        let _e270 = phi_439_;
                        let _e271 = select(_e262, _e264, _e266);
                        let _e272 = select(_e257, select(2u, _e257, _e256), _e266);
                        let _e273 = -(_e252);
                        let _e274 = (_e273 / 2i);
                        let _e279 = bitcast<f32>((bitcast<u32>((_e274 + 127i)) << bitcast<u32>(23i)));
                        let _e285 = bitcast<f32>((bitcast<u32>(((_e273 - _e274) + 127i)) << bitcast<u32>(23i)));
                        let _e290 = global_4.member[_e133].member.member;
                        let _e291 = (_e271 == 0u);
                        if _e291 {
                            phi_484_ = _e290[0];
                        } else {
                            phi_484_ = _e290[1];
                        }
                        let _e295 = phi_484_;
                        let _e296 = (_e271 == 2u);
                        if _e296 {
                            phi_490_ = _e290[2];
                        } else {
                            phi_490_ = _e295;
                        }
                        let _e299 = phi_490_;
                        let _e300 = global_4.member[_e133].member.member_2;
                        if _e291 {
                            phi_501_ = _e300[0];
                        } else {
                            phi_501_ = _e300[1];
                        }
                        let _e304 = phi_501_;
                        if _e296 {
                            phi_507_ = _e300[2];
                        } else {
                            phi_507_ = _e304;
                        }
                        let _e307 = phi_507_;
                        let _e309 = ((_e307 * _e279) * _e285);
                        let _e313 = (bitcast<f32>((bitcast<u32>(_e309) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e313 {
                            let _e317 = (bitcast<f32>((bitcast<u32>(_e299) & 2147483647u)) * 0.00000011920929f);
                            phi_530_ = select(0.00000000000011368684f, _e317, (_e317 > 0.00000000000011368684f));
                        } else {
                            phi_530_ = 0f;
                        }
                        let _e321 = phi_530_;
                        let _e322 = (_e299 + _e321);
                        let _e323 = (_e299 - _e321);
                        let _e324 = select(_e309, 0f, _e313);
                        if _e313 {
                            phi_541_ = 38685626000000000000000000f;
                        } else {
                            phi_541_ = (1f / _e309);
                        }
                        let _e327 = phi_541_;
                        let _e328 = (_e270 == 0u);
                        if _e328 {
                            phi_550_ = _e290[0];
                        } else {
                            phi_550_ = _e290[1];
                        }
                        let _e332 = phi_550_;
                        let _e333 = (_e270 == 2u);
                        if _e333 {
                            phi_556_ = _e290[2];
                        } else {
                            phi_556_ = _e332;
                        }
                        let _e336 = phi_556_;
                        if _e328 {
                            phi_567_ = _e300[0];
                        } else {
                            phi_567_ = _e300[1];
                        }
                        let _e340 = phi_567_;
                        if _e333 {
                            phi_573_ = _e300[2];
                        } else {
                            phi_573_ = _e340;
                        }
                        let _e343 = phi_573_;
                        let _e345 = ((_e343 * _e279) * _e285);
                        let _e349 = (bitcast<f32>((bitcast<u32>(_e345) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e349 {
                            let _e353 = (bitcast<f32>((bitcast<u32>(_e336) & 2147483647u)) * 0.00000011920929f);
                            phi_596_ = select(0.00000000000011368684f, _e353, (_e353 > 0.00000000000011368684f));
                        } else {
                            phi_596_ = 0f;
                        }
                        let _e357 = phi_596_;
                        let _e358 = (_e336 + _e357);
                        let _e359 = (_e336 - _e357);
                        let _e360 = select(_e345, 0f, _e349);
                        if _e349 {
                            phi_607_ = 38685626000000000000000000f;
                        } else {
                            phi_607_ = (1f / _e345);
                        }
                        let _e363 = phi_607_;
                        let _e364 = (_e272 == 0u);
                        if _e364 {
                            phi_616_ = _e290[0];
                        } else {
                            phi_616_ = _e290[1];
                        }
                        let _e368 = phi_616_;
                        let _e369 = (_e272 == 2u);
                        if _e369 {
                            phi_622_ = _e290[2];
                        } else {
                            phi_622_ = _e368;
                        }
                        let _e372 = phi_622_;
                        if _e364 {
                            phi_633_ = _e300[0];
                        } else {
                            phi_633_ = _e300[1];
                        }
                        let _e376 = phi_633_;
                        if _e369 {
                            phi_639_ = _e300[2];
                        } else {
                            phi_639_ = _e376;
                        }
                        let _e379 = phi_639_;
                        let _e381 = ((_e379 * _e279) * _e285);
                        let _e385 = (bitcast<f32>((bitcast<u32>(_e381) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e385 {
                            let _e389 = (bitcast<f32>((bitcast<u32>(_e372) & 2147483647u)) * 0.00000011920929f);
                            phi_662_ = select(0.00000000000011368684f, _e389, (_e389 > 0.00000000000011368684f));
                        } else {
                            phi_662_ = 0f;
                        }
                        let _e393 = phi_662_;
                        let _e394 = (_e372 + _e393);
                        let _e395 = (_e372 - _e393);
                        let _e396 = select(_e381, 0f, _e385);
                        if _e385 {
                            phi_673_ = 38685626000000000000000000f;
                        } else {
                            phi_673_ = (1f / _e381);
                        }
                        let _e399 = phi_673_;
                        let _e402 = bitcast<f32>((bitcast<u32>(_e299) & 2147483647u));
                        let _e405 = bitcast<f32>((bitcast<u32>(_e336) & 2147483647u));
                        let _e407 = select(_e405, _e402, (_e402 > _e405));
                        let _e410 = bitcast<f32>((bitcast<u32>(_e372) & 2147483647u));
                        if (_e233 && (select(_e410, _e407, (_e407 > _e410)) <= 1099511600000f)) {
                            let _e415 = (_e252 / 3i);
                            let _e422 = bitcast<f32>((bitcast<u32>((_e415 + 127i)) << bitcast<u32>(23i)));
                            let _e429 = bitcast<f32>((bitcast<u32>(((_e252 - (2i * _e415)) + 127i)) << bitcast<u32>(23i)));
                            let _e430 = (((_e217 * _e422) * _e422) * _e429);
                            let _e432 = select(340282350000000000000000000000000000000f, _e430, (_e430 < 340282350000000000000000000000000000000f));
                            let _e437 = (((_e227 * _e422) * _e422) * _e429);
                            let _e439 = select(340282350000000000000000000000000000000f, _e437, (_e437 < 340282350000000000000000000000000000000f));
                            phi_773_ = select(-340282350000000000000000000000000000000f, _e439, (_e439 > -340282350000000000000000000000000000000f));
                            phi_774_ = select(-340282350000000000000000000000000000000f, _e432, (_e432 > -340282350000000000000000000000000000000f));
                        } else {
                            phi_773_ = 0f;
                            phi_774_ = 1f;
                        }
                        let _e443 = phi_773_;
                        let _e445 = phi_774_;
                        if _e148 {
                        } else {
                            break;
                        }
                        let _e451 = global_4.member[_e133].member_2;
                        local_3 = array<type_52, 128>(type_52(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_52(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u));
                        local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        let _e454 = (_e271 % 3u);
                        let _e455 = (_e454 < 3u);
                        if _e455 {
                        } else {
                            break;
                        }
                        let _e457 = local_1[_e454];
                        let _e460 = (_e270 % 3u);
                        let _e461 = (_e460 < 3u);
                        if _e461 {
                        } else {
                            break;
                        }
                        let _e463 = local_1[_e460];
                        let _e466 = (_e272 % 3u);
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
                        phi_4684_ = false;
                        phi_1903_ = type_41(type_38(type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e443), 0u, 0u);
                        phi_1906_ = type_52(type_34(vec4<f32>((f32(_e457) * _e145), (f32(_e463) * _e145), (f32(_e469) * _e145), 0f), vec4<f32>((f32(_e474) * _e145), (f32(_e478) * _e145), (f32(_e482) * _e145), 0f)), select(0u, 2147483648u, (_e90 == 0u)));
                        phi_1908_ = ((3u * _e90) + 1u);
                        phi_1910_ = (_e445 <= _e443);
                        phi_1912_ = 0u;
                        loop {
                            let _e492 = phi_4684_;
                            let _e494 = phi_1903_;
                            let _e496 = phi_1906_;
                            let _e498 = phi_1908_;
                            let _e500 = phi_1910_;
                            let _e502 = phi_1912_;
                            local_7 = _e494;
                            local_8 = _e494;
                            if _e500 {
                                phi_1923_ = true;
                            } else {
                                phi_1923_ = (_e502 > 0u);
                            }
                            let _e505 = phi_1923_;
                            if _e505 {
                                let _e506 = (_e498 > 0u);
                                if _e506 {
                                    if _e500 {
                                        phi_1960_ = _e496;
                                        phi_1961_ = _e500;
                                        phi_1962_ = _e502;
                                    } else {
                                        let _e507 = (_e502 - 1u);
                                        let _e508 = (_e507 % 128u);
                                        let _e509 = (_e508 < 128u);
                                        if _e509 {
                                        } else {
                                            phi_4794_ = true;
                                            break;
                                        }
                                        let _e511 = local_3[_e508];
                                        if _e509 {
                                        } else {
                                            phi_4794_ = true;
                                            break;
                                        }
                                        let _e519 = local_2[_e508];
                                        phi_1960_ = type_52(type_34(_e511.member.member, _e511.member.member_1), _e511.member_1);
                                        phi_1961_ = (_e519 <= _e494.member.member_1);
                                        phi_1962_ = _e507;
                                    }
                                    let _e524 = phi_1960_;
                                    let _e526 = phi_1961_;
                                    let _e528 = phi_1962_;
                                    if _e526 {
                                        let _e533 = (_e524.member_1 & 268435455u);
                                        if ((_e524.member_1 & 2147483648u) != 0u) {
                                            phi_4681_ = _e492;
                                            phi_1981_ = _e494;
                                            phi_1984_ = type_8(0u, ((_e524.member_1 >> bitcast<u32>(28u)) & 7u));
                                            loop {
                                                let _e1002 = phi_4681_;
                                                let _e1004 = phi_1981_;
                                                let _e1006 = phi_1984_;
                                                local_9 = _e1004;
                                                if (_e1006.member < _e1006.member_1) {
                                                    phi_1985_ = type_8((_e1006.member + 1u), _e1006.member_1);
                                                    phi_2007_ = type_8(1u, _e1006.member);
                                                } else {
                                                    phi_1985_ = _e1006;
                                                    phi_2007_ = type_8(0u, type_8().member_1);
                                                }
                                                let _e1019 = phi_1985_;
                                                let _e1021 = phi_2007_;
                                                let _e1025 = (bitcast<i32>(_e1021.member) != 0i);
                                                if _e1025 {
                                                    let _e1031 = type_41(_e1004.member, _e1004.member_1, (_e1004.member_2 + 1u));
                                                    let _e1036 = (_e524.member.member_1.x - _e524.member.member.x);
                                                    let _e1039 = (_e524.member.member_1.y - _e524.member.member.y);
                                                    let _e1042 = (_e524.member.member_1.z - _e524.member.member.z);
                                                    let _e1044 = select(_e1039, _e1036, (_e1036 > _e1039));
                                                    let _e1046 = select(_e1042, _e1044, (_e1044 > _e1042));
                                                    let _e1048 = (_e1046 < (1024f * _e145));
                                                    if _e1048 {
                                                        phi_2051_ = 0u;
                                                    } else {
                                                        phi_2051_ = select(2u, 1u, (_e1046 < (2097152f * _e145)));
                                                    }
                                                    let _e1053 = phi_2051_;
                                                    switch bitcast<i32>(_e1053) {
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
                                                    let _e1056 = phi_2057_;
                                                    switch bitcast<i32>(_e1053) {
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
                                                    let _e1063 = phi_2067_;
                                                    let _e1065 = ((_e533 + (_e1021.member_1 * ((3u * _e1056) + 1u))) + (3u * _e1063));
                                                    let _e1066 = (_e1065 < _e93);
                                                    if _e1066 {
                                                        if _e1066 {
                                                        } else {
                                                            phi_4735_ = true;
                                                            break;
                                                        }
                                                        let _e1068 = global_7.member[_e1065];
                                                        phi_2083_ = _e1068;
                                                    } else {
                                                        phi_2083_ = 4294967295u;
                                                    }
                                                    let _e1070 = phi_2083_;
                                                    local_4 = array<u32, 3>(_e271, _e270, _e272);
                                                    if _e1048 {
                                                        phi_2120_ = 0u;
                                                    } else {
                                                        phi_2120_ = select(2u, 1u, (_e1046 < (2097152f * _e145)));
                                                    }
                                                    let _e1076 = phi_2120_;
                                                    switch bitcast<i32>(_e1076) {
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
                                                    let _e1079 = phi_2126_;
                                                    switch bitcast<i32>(_e1076) {
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
                                                    let _e1086 = phi_2136_;
                                                    local_6 = array<f32, 4>(_e524.member.member.x, _e524.member.member.y, _e524.member.member.z, _e524.member.member.w);
                                                    local_5[0u] = array<f32, 3>(0f, 0f, 0f);
                                                    local_5[1u] = array<f32, 3>(0f, 0f, 0f);
                                                    local_5[2u] = array<f32, 3>(0f, 0f, 0f);
                                                    phi_4666_ = _e1002;
                                                    phi_2152_ = type_8(0u, 3u);
                                                    loop {
                                                        let _e1100 = phi_4666_;
                                                        let _e1102 = phi_2152_;
                                                        if (_e1102.member < _e1102.member_1) {
                                                            phi_2153_ = type_8((_e1102.member + 1u), _e1102.member_1);
                                                            phi_2176_ = type_8(1u, _e1102.member);
                                                        } else {
                                                            phi_2153_ = _e1102;
                                                            phi_2176_ = type_8(0u, type_8().member_1);
                                                        }
                                                        let _e1115 = phi_2153_;
                                                        let _e1117 = phi_2176_;
                                                        let _e1121 = (bitcast<i32>(_e1117.member) != 0i);
                                                        if _e1121 {
                                                            let _e1123 = ((_e533 + (_e1021.member_1 * ((3u * _e1079) + 1u))) + (_e1117.member_1 * _e1086));
                                                            let _e1124 = (_e1123 < _e93);
                                                            if _e1124 {
                                                                if _e1124 {
                                                                } else {
                                                                    phi_4733_ = true;
                                                                    break;
                                                                }
                                                                let _e1126 = global_7.member[_e1123];
                                                                phi_2199_ = _e1126;
                                                            } else {
                                                                phi_2199_ = 0u;
                                                            }
                                                            let _e1128 = phi_2199_;
                                                            let _e1129 = (_e1123 + 1u);
                                                            let _e1130 = (_e1129 < _e93);
                                                            if _e1130 {
                                                                if _e1130 {
                                                                } else {
                                                                    phi_4733_ = true;
                                                                    break;
                                                                }
                                                                let _e1132 = global_7.member[_e1129];
                                                                phi_2214_ = _e1132;
                                                            } else {
                                                                phi_2214_ = 0u;
                                                            }
                                                            let _e1134 = phi_2214_;
                                                            phi_2217_ = type_8(0u, 3u);
                                                            loop {
                                                                let _e1136 = phi_2217_;
                                                                if (_e1136.member < _e1136.member_1) {
                                                                    phi_2218_ = type_8((_e1136.member + 1u), _e1136.member_1);
                                                                    phi_2241_ = type_8(1u, _e1136.member);
                                                                } else {
                                                                    phi_2218_ = _e1136;
                                                                    phi_2241_ = type_8(0u, type_8().member_1);
                                                                }
                                                                let _e1149 = phi_2218_;
                                                                let _e1151 = phi_2241_;
                                                                let _e1155 = (bitcast<i32>(_e1151.member) != 0i);
                                                                if _e1155 {
                                                                    let _e1156 = (_e1151.member_1 < 3u);
                                                                    if _e1156 {
                                                                    } else {
                                                                        phi_4659_ = true;
                                                                        break;
                                                                    }
                                                                    let _e1158 = local_4[_e1151.member_1];
                                                                    if (_e1151.member_1 < 4u) {
                                                                    } else {
                                                                        phi_4659_ = true;
                                                                        break;
                                                                    }
                                                                    let _e1161 = local_6[_e1151.member_1];
                                                                    switch bitcast<i32>(_e1076) {
                                                                        case 0: {
                                                                            phi_2311_ = (_e1161 + (f32(((_e1128 >> bitcast<u32>(((10u * _e1158) & 31u))) & 1023u)) * _e145));
                                                                            break;
                                                                        }
                                                                        case 1: {
                                                                            if (_e1158 == 0u) {
                                                                                phi_2288_ = _e1128;
                                                                            } else {
                                                                                if (_e1158 == 1u) {
                                                                                    phi_2287_ = ((_e1128 >> bitcast<u32>(21i)) | (_e1134 << bitcast<u32>(11i)));
                                                                                } else {
                                                                                    phi_2287_ = (_e1134 >> bitcast<u32>(10i));
                                                                                }
                                                                                let _e1182 = phi_2287_;
                                                                                phi_2288_ = _e1182;
                                                                            }
                                                                            let _e1184 = phi_2288_;
                                                                            phi_2311_ = (_e1161 + (f32((_e1184 & 2097151u)) * _e145));
                                                                            break;
                                                                        }
                                                                        case 2: {
                                                                            let _e1163 = (_e1123 + _e1158);
                                                                            let _e1164 = (_e1163 < _e93);
                                                                            if _e1164 {
                                                                                if _e1164 {
                                                                                } else {
                                                                                    phi_4659_ = true;
                                                                                    break;
                                                                                }
                                                                                let _e1166 = global_7.member[_e1163];
                                                                                phi_2307_ = _e1166;
                                                                            } else {
                                                                                phi_2307_ = 0u;
                                                                            }
                                                                            let _e1168 = phi_2307_;
                                                                            phi_2311_ = (f32(bitcast<i32>(_e1168)) * _e145);
                                                                            break;
                                                                        }
                                                                        default: {
                                                                            phi_2311_ = f32();
                                                                            break;
                                                                        }
                                                                    }
                                                                    let _e1198 = phi_2311_;
                                                                    if (_e1117.member_1 < 3u) {
                                                                    } else {
                                                                        phi_4659_ = true;
                                                                        break;
                                                                    }
                                                                    if _e1156 {
                                                                    } else {
                                                                        phi_4659_ = true;
                                                                        break;
                                                                    }
                                                                    local_5[_e1117.member_1][_e1151.member_1] = _e1198;
                                                                }
                                                                continue;
                                                                continuing {
                                                                    phi_2217_ = _e1149;
                                                                    phi_4659_ = _e1100;
                                                                    break if !(_e1155);
                                                                }
                                                            }
                                                            let _e1204 = phi_4659_;
                                                            phi_4733_ = _e1204;
                                                            if _e1204 {
                                                                break;
                                                            }
                                                            phi_4734_ = _e1204;
                                                        } else {
                                                            phi_4734_ = _e1100;
                                                        }
                                                        let _e1206 = phi_4734_;
                                                        continue;
                                                        continuing {
                                                            phi_4666_ = _e1206;
                                                            phi_2152_ = _e1115;
                                                            phi_4733_ = _e1206;
                                                            break if !(_e1121);
                                                        }
                                                    }
                                                    let _e1209 = phi_4733_;
                                                    phi_4735_ = _e1209;
                                                    if _e1209 {
                                                        break;
                                                    }
                                                    let _e1210 = local_5;
                                                    let _e1227 = (_e1210[0][2] - _e372);
                                                    let _e1230 = (((_e1210[0][0] - _e299) * _e396) - (_e1227 * _e324));
                                                    let _e1233 = (((_e1210[0][1] - _e336) * _e396) - (_e1227 * _e360));
                                                    let _e1236 = (_e1210[1][2] - _e372);
                                                    let _e1239 = (((_e1210[1][0] - _e299) * _e396) - (_e1236 * _e324));
                                                    let _e1242 = (((_e1210[1][1] - _e336) * _e396) - (_e1236 * _e360));
                                                    let _e1245 = (_e1210[2][2] - _e372);
                                                    let _e1248 = (((_e1210[2][0] - _e299) * _e396) - (_e1245 * _e324));
                                                    let _e1251 = (((_e1210[2][1] - _e336) * _e396) - (_e1245 * _e360));
                                                    let _e1252 = (_e1248 * _e1242);
                                                    let _e1253 = (_e1251 * _e1239);
                                                    let _e1254 = (_e1230 * _e1251);
                                                    let _e1255 = (_e1233 * _e1248);
                                                    let _e1256 = (_e1239 * _e1233);
                                                    let _e1257 = (_e1242 * _e1230);
                                                    let _e1262 = (((_e1252 >= _e1253) && (_e1254 >= _e1255)) && (_e1256 >= _e1257));
                                                    if (_e1262 || (((_e1252 <= _e1253) && (_e1254 <= _e1255)) && (_e1256 <= _e1257))) {
                                                        let _e1269 = select(-1f, 1f, _e1262);
                                                        let _e1271 = ((_e1252 - _e1253) * _e1269);
                                                        let _e1273 = select(0f, _e1271, (_e1271 > 0f));
                                                        let _e1275 = ((_e1254 - _e1255) * _e1269);
                                                        let _e1277 = select(0f, _e1275, (_e1275 > 0f));
                                                        let _e1279 = ((_e1256 - _e1257) * _e1269);
                                                        let _e1281 = select(0f, _e1279, (_e1279 > 0f));
                                                        let _e1283 = ((_e1273 + _e1277) + _e1281);
                                                        if (_e1283 < 0.000000000000000000000000000000000000011754944f) {
                                                            phi_2906_ = type_22();
                                                            phi_2907_ = true;
                                                        } else {
                                                            let _e1286 = select(_e1210[1][0], _e1210[0][0], (_e1210[0][0] < _e1210[1][0]));
                                                            let _e1290 = select(_e1210[1][0], _e1210[0][0], (_e1210[0][0] > _e1210[1][0]));
                                                            let _e1294 = select(_e1210[1][1], _e1210[0][1], (_e1210[0][1] < _e1210[1][1]));
                                                            let _e1298 = select(_e1210[1][1], _e1210[0][1], (_e1210[0][1] > _e1210[1][1]));
                                                            let _e1302 = select(_e1210[1][2], _e1210[0][2], (_e1210[0][2] < _e1210[1][2]));
                                                            let _e1306 = select(_e1210[1][2], _e1210[0][2], (_e1210[0][2] > _e1210[1][2]));
                                                            let _e1311 = ((select(_e1210[2][0], _e1286, (_e1286 < _e1210[2][0])) - _e322) * _e327);
                                                            let _e1312 = ((select(_e1210[2][0], _e1290, (_e1290 > _e1210[2][0])) - _e323) * _e327);
                                                            let _e1315 = ((select(_e1210[2][1], _e1294, (_e1294 < _e1210[2][1])) - _e358) * _e363);
                                                            let _e1316 = ((select(_e1210[2][1], _e1298, (_e1298 > _e1210[2][1])) - _e359) * _e363);
                                                            let _e1319 = ((select(_e1210[2][2], _e1302, (_e1302 < _e1210[2][2])) - _e394) * _e399);
                                                            let _e1320 = ((select(_e1210[2][2], _e1306, (_e1306 > _e1210[2][2])) - _e395) * _e399);
                                                            let _e1322 = select(_e1320, _e1319, (_e1319 < _e1320));
                                                            let _e1324 = select(_e1320, _e1319, (_e1319 > _e1320));
                                                            let _e1326 = select(_e1312, _e1311, (_e1311 < _e1312));
                                                            let _e1328 = select(_e1316, _e1315, (_e1315 < _e1316));
                                                            let _e1330 = select(_e1328, _e1326, (_e1326 > _e1328));
                                                            let _e1332 = select(_e1322, _e1330, (_e1330 > _e1322));
                                                            let _e1334 = select(_e1312, _e1311, (_e1311 > _e1312));
                                                            let _e1336 = select(_e1316, _e1315, (_e1315 > _e1316));
                                                            let _e1338 = select(_e1336, _e1334, (_e1334 < _e1336));
                                                            let _e1340 = select(_e1324, _e1338, (_e1338 < _e1324));
                                                            let _e1341 = -(_e1322);
                                                            let _e1347 = select(_e445, _e1332, (_e1332 > _e445));
                                                            if (_e1347 > (_e1340 + (select(_e1341, _e1324, (_e1324 > _e1341)) * 0.0000019073523f))) {
                                                                phi_2901_ = type_22();
                                                                phi_2902_ = true;
                                                            } else {
                                                                let _e1349 = (_e1347 > _e1004.member.member_1);
                                                                if _e1349 {
                                                                    phi_2900_ = type_22();
                                                                } else {
                                                                    let _e1353 = (_e1210[1][0] - _e1210[0][0]);
                                                                    let _e1354 = (_e1210[1][1] - _e1210[0][1]);
                                                                    let _e1355 = (_e1210[1][2] - _e1210[0][2]);
                                                                    let _e1356 = vec3<f32>(_e1353, _e1354, _e1355);
                                                                    let _e1357 = (_e1210[2][0] - _e1210[1][0]);
                                                                    let _e1358 = (_e1210[2][1] - _e1210[1][1]);
                                                                    let _e1359 = (_e1210[2][2] - _e1210[1][2]);
                                                                    let _e1360 = vec3<f32>(_e1357, _e1358, _e1359);
                                                                    let _e1361 = (_e1210[0][0] - _e1210[2][0]);
                                                                    let _e1362 = (_e1210[0][1] - _e1210[2][1]);
                                                                    let _e1363 = (_e1210[0][2] - _e1210[2][2]);
                                                                    let _e1364 = vec3<f32>(_e1361, _e1362, _e1363);
                                                                    let _e1367 = bitcast<f32>((bitcast<u32>(_e1353) & 2147483647u));
                                                                    let _e1370 = bitcast<f32>((bitcast<u32>(_e1354) & 2147483647u));
                                                                    let _e1372 = select(_e1370, _e1367, (_e1367 > _e1370));
                                                                    let _e1375 = bitcast<f32>((bitcast<u32>(_e1355) & 2147483647u));
                                                                    let _e1377 = select(_e1375, _e1372, (_e1372 > _e1375));
                                                                    let _e1380 = bitcast<f32>((bitcast<u32>(_e1357) & 2147483647u));
                                                                    let _e1383 = bitcast<f32>((bitcast<u32>(_e1358) & 2147483647u));
                                                                    let _e1385 = select(_e1383, _e1380, (_e1380 > _e1383));
                                                                    let _e1388 = bitcast<f32>((bitcast<u32>(_e1359) & 2147483647u));
                                                                    let _e1390 = select(_e1388, _e1385, (_e1385 > _e1388));
                                                                    let _e1393 = bitcast<f32>((bitcast<u32>(_e1361) & 2147483647u));
                                                                    let _e1396 = bitcast<f32>((bitcast<u32>(_e1362) & 2147483647u));
                                                                    let _e1398 = select(_e1396, _e1393, (_e1393 > _e1396));
                                                                    let _e1401 = bitcast<f32>((bitcast<u32>(_e1363) & 2147483647u));
                                                                    let _e1403 = select(_e1401, _e1398, (_e1398 > _e1401));
                                                                    let _e1405 = select(_e1390, _e1377, (_e1377 > _e1390));
                                                                    let _e1407 = select(_e1403, _e1405, (_e1405 > _e1403));
                                                                    if (_e1377 == _e1407) {
                                                                        phi_2811_ = _e1360;
                                                                        phi_2812_ = _e1364;
                                                                    } else {
                                                                        let _e1410 = vec3((_e1390 == _e1407));
                                                                        phi_2811_ = select(_e1356, _e1364, _e1410);
                                                                        phi_2812_ = select(_e1360, _e1356, _e1410);
                                                                    }
                                                                    let _e1414 = phi_2811_;
                                                                    let _e1416 = phi_2812_;
                                                                    let _e1423 = ((_e1414.y * _e1416.z) - (_e1416.y * _e1414.z));
                                                                    let _e1428 = ((_e1414.z * _e1416.x) - (_e1416.z * _e1414.x));
                                                                    let _e1431 = ((_e1414.x * _e1416.y) - (_e1416.x * _e1414.y));
                                                                    if (_e1273 >= _e1277) {
                                                                        phi_2843_ = select(true, false, (_e1273 >= _e1281));
                                                                    } else {
                                                                        phi_2843_ = true;
                                                                    }
                                                                    let _e1436 = phi_2843_;
                                                                    if _e1436 {
                                                                        phi_2852_ = select(vec3<f32>(_e1210[2][0], _e1210[2][1], _e1210[2][2]), vec3<f32>(_e1210[1][0], _e1210[1][1], _e1210[1][2]), vec3((_e1277 >= _e1281)));
                                                                    } else {
                                                                        phi_2852_ = vec3<f32>(_e1210[0][0], _e1210[0][1], _e1210[0][2]);
                                                                    }
                                                                    let _e1441 = phi_2852_;
                                                                    let _e1458 = ((((_e1423 * (_e1441.x - _e299)) + (_e1428 * (_e1441.y - _e336))) + (_e1431 * (_e1441.z - _e372))) / (((_e1423 * _e324) + (_e1428 * _e360)) + (_e1431 * _e396)));
                                                                    let _e1460 = select(_e1340, _e1458, (_e1458 < _e1340));
                                                                    let _e1462 = select(_e1332, _e1460, (_e1460 > _e1332));
                                                                    if (_e1462 >= _e445) {
                                                                        let _e1464 = (_e1462 <= _e1004.member.member_1);
                                                                        if _e1464 {
                                                                            let _e1465 = (1f / _e1283);
                                                                            phi_2892_ = type_22(_e1462, (_e1277 * _e1465), (_e1281 * _e1465), _e1070);
                                                                        } else {
                                                                            phi_2892_ = type_22();
                                                                        }
                                                                        let _e1470 = phi_2892_;
                                                                        phi_2894_ = _e1470;
                                                                        phi_2895_ = select(true, false, _e1464);
                                                                    } else {
                                                                        phi_2894_ = type_22();
                                                                        phi_2895_ = true;
                                                                    }
                                                                    let _e1473 = phi_2894_;
                                                                    let _e1475 = phi_2895_;
                                                                    if _e1475 {
                                                                        phi_2899_ = type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                    } else {
                                                                        phi_2899_ = _e1473;
                                                                    }
                                                                    let _e1477 = phi_2899_;
                                                                    phi_2900_ = _e1477;
                                                                }
                                                                let _e1479 = phi_2900_;
                                                                phi_2901_ = _e1479;
                                                                phi_2902_ = _e1349;
                                                            }
                                                            let _e1481 = phi_2901_;
                                                            let _e1483 = phi_2902_;
                                                            phi_2906_ = _e1481;
                                                            phi_2907_ = _e1483;
                                                        }
                                                        let _e1485 = phi_2906_;
                                                        let _e1487 = phi_2907_;
                                                        phi_2911_ = _e1485;
                                                        phi_2912_ = _e1487;
                                                    } else {
                                                        phi_2911_ = type_22();
                                                        phi_2912_ = true;
                                                    }
                                                    let _e1489 = phi_2911_;
                                                    let _e1491 = phi_2912_;
                                                    if _e1491 {
                                                        phi_2916_ = type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                    } else {
                                                        phi_2916_ = _e1489;
                                                    }
                                                    let _e1493 = phi_2916_;
                                                    if (_e1493.member_3 != 4294967295u) {
                                                        if (_e1070 != _e451) {
                                                            if (_e1493.member < _e1004.member.member.member) {
                                                                phi_2942_ = true;
                                                            } else {
                                                                if (_e1493.member == _e1004.member.member.member) {
                                                                    phi_2941_ = (_e1493.member_3 < _e1004.member.member.member_3);
                                                                } else {
                                                                    phi_2941_ = false;
                                                                }
                                                                let _e1508 = phi_2941_;
                                                                phi_2942_ = _e1508;
                                                            }
                                                            let _e1510 = phi_2942_;
                                                            if _e1510 {
                                                                phi_2949_ = type_41(type_38(_e1493, _e1493.member), _e1031.member_1, _e1031.member_2);
                                                            } else {
                                                                phi_2949_ = _e1031;
                                                            }
                                                            let _e1517 = phi_2949_;
                                                            phi_2950_ = _e1517;
                                                        } else {
                                                            phi_2950_ = _e1031;
                                                        }
                                                        let _e1519 = phi_2950_;
                                                        phi_2951_ = _e1519;
                                                    } else {
                                                        phi_2951_ = _e1031;
                                                    }
                                                    let _e1521 = phi_2951_;
                                                    phi_4736_ = _e1209;
                                                    phi_1982_ = _e1521;
                                                } else {
                                                    phi_4736_ = _e1002;
                                                    phi_1982_ = type_41();
                                                }
                                                let _e1523 = phi_4736_;
                                                let _e1525 = phi_1982_;
                                                continue;
                                                continuing {
                                                    phi_4681_ = _e1523;
                                                    phi_1981_ = _e1525;
                                                    phi_1984_ = _e1019;
                                                    phi_4735_ = _e1523;
                                                    break if !(_e1025);
                                                }
                                            }
                                            let _e1528 = phi_4735_;
                                            phi_4794_ = _e1528;
                                            if _e1528 {
                                                break;
                                            }
                                            phi_4798_ = _e1528;
                                            let _e1769 = local_9;
                                            phi_4292_ = _e1769;
                                            phi_4293_ = _e524;
                                            phi_4294_ = false;
                                            phi_4295_ = _e528;
                                        } else {
                                            if (_e524.member_1 >= _e90) {
                                                phi_3892_ = type_55(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), type_52(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u), type_52(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u));
                                            } else {
                                                if (_e524.member_1 < _e90) {
                                                } else {
                                                    phi_4794_ = true;
                                                    break;
                                                }
                                                let _e547 = ((1u + _e271) % 4u);
                                                if (_e547 < 4u) {
                                                } else {
                                                    phi_4794_ = true;
                                                    break;
                                                }
                                                let _e552 = global_3.member[_e524.member_1][_e547];
                                                let _e554 = ((1u + _e270) % 4u);
                                                if (_e554 < 4u) {
                                                } else {
                                                    phi_4794_ = true;
                                                    break;
                                                }
                                                let _e559 = global_3.member[_e524.member_1][_e554];
                                                let _e561 = ((1u + _e272) % 4u);
                                                if (_e561 < 4u) {
                                                } else {
                                                    phi_4794_ = true;
                                                    break;
                                                }
                                                let _e566 = global_3.member[_e524.member_1][_e561];
                                                let _e568 = ((_e271 + 1u) % 4u);
                                                if (_e568 < 4u) {
                                                } else {
                                                    phi_4794_ = true;
                                                    break;
                                                }
                                                let _e573 = global_3.member[_e524.member_1][_e568];
                                                let _e575 = (_e573 >> bitcast<u32>(11u));
                                                let _e577 = ((_e270 + 1u) % 4u);
                                                if (_e577 < 4u) {
                                                } else {
                                                    phi_4794_ = true;
                                                    break;
                                                }
                                                let _e582 = global_3.member[_e524.member_1][_e577];
                                                let _e584 = (_e582 >> bitcast<u32>(11u));
                                                let _e586 = ((_e272 + 1u) % 4u);
                                                if (_e586 < 4u) {
                                                } else {
                                                    phi_4794_ = true;
                                                    break;
                                                }
                                                let _e591 = global_3.member[_e524.member_1][_e586];
                                                let _e593 = (_e591 >> bitcast<u32>(11u));
                                                let _e616 = (bitcast<f32>((bitcast<u32>((_e524.member.member_1.x - _e524.member.member.x)) & 2139095040u)) * 0.001953125f);
                                                let _e617 = (bitcast<f32>((bitcast<u32>((_e524.member.member_1.y - _e524.member.member.y)) & 2139095040u)) * 0.001953125f);
                                                let _e618 = (bitcast<f32>((bitcast<u32>((_e524.member.member_1.z - _e524.member.member.z)) & 2139095040u)) * 0.001953125f);
                                                let _e620 = select(_e145, _e616, (_e616 > _e145));
                                                let _e622 = select(_e145, _e617, (_e617 > _e145));
                                                let _e624 = select(_e145, _e618, (_e618 > _e145));
                                                let _e649 = bitcast<u32>((f32(bitcast<i32>((_e552 & 1023u))) * _e620));
                                                let _e654 = (bitcast<i32>((_e552 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                                let _e657 = bitcast<f32>((_e649 & bitcast<u32>(_e654)));
                                                let _e658 = bitcast<u32>((f32(bitcast<i32>((_e559 & 1023u))) * _e622));
                                                let _e663 = (bitcast<i32>((_e559 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                                let _e666 = bitcast<f32>((_e658 & bitcast<u32>(_e663)));
                                                let _e667 = bitcast<u32>((f32(bitcast<i32>((_e566 & 1023u))) * _e624));
                                                let _e672 = (bitcast<i32>((_e566 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                                let _e675 = bitcast<f32>((_e667 & bitcast<u32>(_e672)));
                                                let _e679 = bitcast<f32>((_e649 & bitcast<u32>(~(_e654))));
                                                let _e683 = bitcast<f32>((_e658 & bitcast<u32>(~(_e663))));
                                                let _e687 = bitcast<f32>((_e667 & bitcast<u32>(~(_e672))));
                                                let _e688 = bitcast<u32>((f32(bitcast<i32>((_e575 & 1023u))) * _e620));
                                                let _e693 = (bitcast<i32>((_e575 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                                let _e696 = bitcast<f32>((_e688 & bitcast<u32>(_e693)));
                                                let _e697 = bitcast<u32>((f32(bitcast<i32>((_e584 & 1023u))) * _e622));
                                                let _e702 = (bitcast<i32>((_e584 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                                let _e705 = bitcast<f32>((_e697 & bitcast<u32>(_e702)));
                                                let _e706 = bitcast<u32>((f32(bitcast<i32>((_e593 & 1023u))) * _e624));
                                                let _e711 = (bitcast<i32>((_e593 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                                let _e714 = bitcast<f32>((_e706 & bitcast<u32>(_e711)));
                                                let _e718 = bitcast<f32>((_e688 & bitcast<u32>(~(_e693))));
                                                let _e722 = bitcast<f32>((_e697 & bitcast<u32>(~(_e702))));
                                                let _e726 = bitcast<f32>((_e706 & bitcast<u32>(~(_e711))));
                                                let _e727 = (_e524.member.member.x + _e657);
                                                let _e728 = (_e524.member.member.y + _e666);
                                                let _e729 = (_e524.member.member.z + _e675);
                                                let _e732 = (_e524.member.member_1.x - _e696);
                                                let _e733 = (_e524.member.member_1.y - _e705);
                                                let _e734 = (_e524.member.member_1.z - _e714);
                                                let _e753 = (_e732 - _e727);
                                                let _e754 = (_e733 - _e728);
                                                let _e755 = (_e734 - _e729);
                                                let _e757 = select(_e754, _e753, (_e753 > _e754));
                                                let _e759 = select(_e755, _e757, (_e757 > _e755));
                                                if (_e759 < (1024f * _e145)) {
                                                    phi_3593_ = 0u;
                                                } else {
                                                    phi_3593_ = select(2u, 1u, (_e759 < (2097152f * _e145)));
                                                }
                                                let _e766 = phi_3593_;
                                                switch bitcast<i32>(_e766) {
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
                                                let _e769 = phi_3599_;
                                                let _e775 = global_3.member[_e524.member_1][0u];
                                                let _e779 = global_3.member[_e524.member_1][1u];
                                                let _e783 = global_3.member[_e524.member_1][2u];
                                                let _e787 = global_3.member[_e524.member_1][3u];
                                                let _e799 = (((_e779 >> bitcast<u32>(22i)) | ((_e783 >> bitcast<u32>(22i)) << bitcast<u32>(10i))) | ((_e787 >> bitcast<u32>(22i)) << bitcast<u32>(20i)));
                                                let _e800 = (_e775 & 268435455u);
                                                let _e801 = (_e799 & 268435455u);
                                                let _e804 = ((_e775 >> bitcast<u32>(28u)) & 7u);
                                                let _e812 = ((_e775 >> bitcast<u32>(31i)) | (((_e799 >> bitcast<u32>(28u)) & 3u) << bitcast<u32>(1i)));
                                                let _e813 = (_e804 != 0u);
                                                if (_e804 == 0u) {
                                                    phi_3854_ = _e800;
                                                } else {
                                                    if (_e804 == 7u) {
                                                        phi_3853_ = 2147483648u;
                                                    } else {
                                                        phi_3853_ = ((2147483648u | (_e804 << bitcast<u32>(28u))) | (_e801 & 268435455u));
                                                    }
                                                    let _e822 = phi_3853_;
                                                    phi_3854_ = _e822;
                                                }
                                                let _e824 = phi_3854_;
                                                if _e813 {
                                                    let _e825 = (_e804 != 7u);
                                                    if _e825 {
                                                        phi_3864_ = (_e801 + (_e804 * ((3u * _e769) + 1u)));
                                                    } else {
                                                        phi_3864_ = u32();
                                                    }
                                                    let _e829 = phi_3864_;
                                                    phi_3866_ = _e829;
                                                    phi_3867_ = select(true, false, _e825);
                                                } else {
                                                    phi_3866_ = u32();
                                                    phi_3867_ = true;
                                                }
                                                let _e832 = phi_3866_;
                                                let _e834 = phi_3867_;
                                                if (_e812 == 0u) {
                                                    phi_3888_ = (_e800 + select(0u, 1u, !(_e813)));
                                                } else {
                                                    if (_e812 == 7u) {
                                                        phi_3887_ = 2147483648u;
                                                    } else {
                                                        phi_3887_ = ((2147483648u | (_e812 << bitcast<u32>(28u))) | (select(_e832, _e801, _e834) & 268435455u));
                                                    }
                                                    let _e847 = phi_3887_;
                                                    phi_3888_ = _e847;
                                                }
                                                let _e849 = phi_3888_;
                                                phi_3892_ = type_55(array<vec4<f32>, 3>(vec4<f32>(_e727, (_e524.member.member.x + _e679), _e732, (_e524.member.member_1.x - _e718)), vec4<f32>(_e728, (_e524.member.member.y + _e683), _e733, (_e524.member.member_1.y - _e722)), vec4<f32>(_e729, (_e524.member.member.z + _e687), _e734, (_e524.member.member_1.z - _e726))), type_52(type_34((_e524.member.member + vec4<f32>(_e657, _e666, _e675, 0f)), (_e524.member.member_1 - vec4<f32>(_e696, _e705, _e714, 0f))), _e824), type_52(type_34((_e524.member.member + vec4<f32>(_e679, _e683, _e687, 0f)), (_e524.member.member_1 - vec4<f32>(_e718, _e722, _e726, 0f))), _e849));
                                            }
                                            let _e854 = phi_3892_;
                                            let _e867 = ((_e854.member[0].x - _e322) * _e327);
                                            let _e868 = ((_e854.member[0].y - _e322) * _e327);
                                            let _e869 = ((_e854.member[0].z - _e323) * _e327);
                                            let _e870 = ((_e854.member[0].w - _e323) * _e327);
                                            let _e880 = ((_e854.member[1].x - _e358) * _e363);
                                            let _e881 = ((_e854.member[1].y - _e358) * _e363);
                                            let _e882 = ((_e854.member[1].z - _e359) * _e363);
                                            let _e883 = ((_e854.member[1].w - _e359) * _e363);
                                            let _e893 = ((_e854.member[2].x - _e394) * _e399);
                                            let _e894 = ((_e854.member[2].y - _e394) * _e399);
                                            let _e895 = ((_e854.member[2].z - _e395) * _e399);
                                            let _e896 = ((_e854.member[2].w - _e395) * _e399);
                                            let _e898 = select(_e895, _e893, (_e893 < _e895));
                                            let _e900 = select(_e896, _e894, (_e894 < _e896));
                                            let _e902 = select(_e895, _e893, (_e893 > _e895));
                                            let _e904 = select(_e896, _e894, (_e894 > _e896));
                                            let _e906 = select(_e869, _e867, (_e867 < _e869));
                                            let _e908 = select(_e870, _e868, (_e868 < _e870));
                                            let _e910 = select(_e882, _e880, (_e880 < _e882));
                                            let _e912 = select(_e883, _e881, (_e881 < _e883));
                                            let _e914 = select(_e910, _e906, (_e906 > _e910));
                                            let _e916 = select(_e912, _e908, (_e908 > _e912));
                                            let _e918 = select(_e898, _e914, (_e914 > _e898));
                                            let _e920 = select(_e900, _e916, (_e916 > _e900));
                                            let _e922 = select(_e869, _e867, (_e867 > _e869));
                                            let _e924 = select(_e870, _e868, (_e868 > _e870));
                                            let _e926 = select(_e882, _e880, (_e880 > _e882));
                                            let _e928 = select(_e883, _e881, (_e881 > _e883));
                                            let _e930 = select(_e926, _e922, (_e922 < _e926));
                                            let _e932 = select(_e928, _e924, (_e924 < _e928));
                                            let _e937 = -(_e898);
                                            let _e938 = -(_e900);
                                            let _e945 = (select(_e902, _e930, (_e930 < _e902)) + (select(_e937, _e902, (_e902 > _e937)) * 0.0000019073523f));
                                            let _e946 = (select(_e904, _e932, (_e932 < _e904)) + (select(_e938, _e904, (_e904 > _e938)) * 0.0000019073523f));
                                            let _e948 = select(_e445, _e918, (_e918 > _e445));
                                            let _e950 = select(_e445, _e920, (_e920 > _e445));
                                            let _e955 = (_e948 <= select(_e494.member.member_1, _e945, (_e945 < _e494.member.member_1)));
                                            let _e956 = (_e950 <= select(_e494.member.member_1, _e946, (_e946 < _e494.member.member_1)));
                                            let _e957 = (_e948 <= _e950);
                                            if _e955 {
                                                if _e956 {
                                                    if _e957 {
                                                        phi_4236_ = _e854.member_2;
                                                    } else {
                                                        phi_4236_ = _e854.member_1;
                                                    }
                                                    let _e961 = phi_4236_;
                                                    let _e962 = (_e528 % 128u);
                                                    let _e963 = (_e962 < 128u);
                                                    if _e963 {
                                                    } else {
                                                        phi_4794_ = true;
                                                        break;
                                                    }
                                                    local_3[_e962] = type_52(type_34(_e961.member.member, _e961.member.member_1), _e961.member_1);
                                                    if _e963 {
                                                    } else {
                                                        phi_4794_ = true;
                                                        break;
                                                    }
                                                    local_2[_e962] = select(_e950, _e948, (_e948 > _e950));
                                                    if _e957 {
                                                        phi_4269_ = _e854.member_1;
                                                    } else {
                                                        phi_4269_ = _e854.member_2;
                                                    }
                                                    let _e978 = phi_4269_;
                                                    phi_4270_ = _e978;
                                                    phi_4271_ = (_e528 + 1u);
                                                } else {
                                                    phi_4270_ = type_52();
                                                    phi_4271_ = u32();
                                                }
                                                let _e980 = phi_4270_;
                                                let _e982 = phi_4271_;
                                                phi_4273_ = _e980;
                                                phi_4274_ = _e982;
                                                phi_4275_ = select(true, false, _e956);
                                            } else {
                                                phi_4273_ = type_52();
                                                phi_4274_ = u32();
                                                phi_4275_ = true;
                                            }
                                            let _e985 = phi_4273_;
                                            let _e987 = phi_4274_;
                                            let _e989 = phi_4275_;
                                            if _e989 {
                                                if _e955 {
                                                    phi_4284_ = _e854.member_1;
                                                } else {
                                                    phi_4284_ = _e854.member_2;
                                                }
                                                let _e993 = phi_4284_;
                                                phi_4289_ = _e993;
                                                phi_4290_ = select(_e956, true, _e955);
                                            } else {
                                                phi_4289_ = _e985;
                                                phi_4290_ = _e526;
                                            }
                                            let _e996 = phi_4289_;
                                            let _e998 = phi_4290_;
                                            phi_4798_ = _e492;
                                            phi_4292_ = type_41(_e494.member, (_e494.member_1 + 1u), _e494.member_2);
                                            phi_4293_ = _e996;
                                            phi_4294_ = _e998;
                                            phi_4295_ = select(_e987, _e528, _e989);
                                        }
                                        let _e1530 = phi_4798_;
                                        let _e1532 = phi_4292_;
                                        let _e1534 = phi_4293_;
                                        let _e1536 = phi_4294_;
                                        let _e1538 = phi_4295_;
                                        phi_4797_ = _e1530;
                                        phi_4296_ = _e1532;
                                        phi_4297_ = _e1534;
                                        phi_4298_ = (_e498 - 1u);
                                        phi_4299_ = _e1536;
                                        phi_4300_ = _e1538;
                                    } else {
                                        phi_4797_ = _e492;
                                        phi_4296_ = _e494;
                                        phi_4297_ = _e524;
                                        phi_4298_ = _e498;
                                        phi_4299_ = _e526;
                                        phi_4300_ = _e528;
                                    }
                                    let _e1540 = phi_4797_;
                                    let _e1542 = phi_4296_;
                                    let _e1544 = phi_4297_;
                                    let _e1546 = phi_4298_;
                                    let _e1548 = phi_4299_;
                                    let _e1550 = phi_4300_;
                                    phi_4796_ = _e1540;
                                    phi_4301_ = _e1542;
                                    phi_4302_ = _e1544;
                                    phi_4303_ = _e1546;
                                    phi_4304_ = _e1548;
                                    phi_4305_ = _e1550;
                                } else {
                                    phi_4796_ = _e492;
                                    phi_4301_ = type_41();
                                    phi_4302_ = type_52();
                                    phi_4303_ = u32();
                                    phi_4304_ = bool();
                                    phi_4305_ = u32();
                                }
                                let _e1552 = phi_4796_;
                                let _e1554 = phi_4301_;
                                let _e1556 = phi_4302_;
                                let _e1558 = phi_4303_;
                                let _e1560 = phi_4304_;
                                let _e1562 = phi_4305_;
                                phi_4795_ = _e1552;
                                phi_1904_ = _e1554;
                                phi_1907_ = _e1556;
                                phi_1909_ = _e1558;
                                phi_1911_ = _e1560;
                                phi_1913_ = _e1562;
                                phi_4306_ = _e506;
                            } else {
                                phi_4795_ = _e492;
                                phi_1904_ = type_41();
                                phi_1907_ = type_52();
                                phi_1909_ = u32();
                                phi_1911_ = bool();
                                phi_1913_ = u32();
                                phi_4306_ = false;
                            }
                            let _e1564 = phi_4795_;
                            let _e1566 = phi_1904_;
                            let _e1568 = phi_1907_;
                            let _e1570 = phi_1909_;
                            let _e1572 = phi_1911_;
                            let _e1574 = phi_1913_;
                            let _e1576 = phi_4306_;
                            continue;
                            continuing {
                                phi_4684_ = _e1564;
                                phi_1903_ = _e1566;
                                phi_1906_ = _e1568;
                                phi_1908_ = _e1570;
                                phi_1910_ = _e1572;
                                phi_1912_ = _e1574;
                                phi_4794_ = _e1564;
                                break if !(_e1576);
                            }
                        }
                        let _e1579 = phi_4794_;
                        if _e1579 {
                            break;
                        }
                        let _e1581 = local_7;
                        if (_e1581.member.member.member_3 != 4294967295u) {
                            let _e1587 = (_e273 / 3i);
                            let _e1594 = bitcast<f32>((bitcast<u32>((_e1587 + 127i)) << bitcast<u32>(23i)));
                            let _e1602 = (((_e1581.member.member.member * _e1594) * _e1594) * bitcast<f32>((bitcast<u32>(((_e273 - (2i * _e1587)) + 127i)) << bitcast<u32>(23i))));
                            let _e1604 = select(340282350000000000000000000000000000000f, _e1602, (_e1602 < 340282350000000000000000000000000000000f));
                            phi_4358_ = type_22(select(-340282350000000000000000000000000000000f, _e1604, (_e1604 > -340282350000000000000000000000000000000f)), _e1581.member.member.member_1, _e1581.member.member.member_2, _e1581.member.member.member_3);
                        } else {
                            phi_4358_ = type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                        }
                        let _e1611 = phi_4358_;
                        if _e149 {
                        } else {
                            break;
                        }
                        global_1.member[_e133] = _e1611;
                        let _e1615 = local_8;
                        if _e150 {
                        } else {
                            break;
                        }
                        global_5.member[_e133] = _e1615.member_1;
                        if _e148 {
                        } else {
                            break;
                        }
                        let _e1620 = select(0u, 1u, (_e217 <= _e227));
                        if (_e1620 > 0u) {
                            let _e1622 = (1u < _e101);
                            if _e1622 {
                                if (0u < _e101) {
                                } else {
                                    break;
                                }
                                let _e1626 = atomicAdd((&global_6.member[0u]), _e1620);
                                if ((_e1626 + _e1620) < _e1626) {
                                    if _e1622 {
                                    } else {
                                        break;
                                    }
                                    let _e1631 = atomicAdd((&global_6.member[1u]), 1u);
                                }
                            }
                        }
                        let _e1634 = select(0u, 1u, (_e1611.member_3 != 4294967295u));
                        if (_e1634 > 0u) {
                            let _e1636 = (3u < _e101);
                            if _e1636 {
                                if (2u < _e101) {
                                } else {
                                    break;
                                }
                                let _e1640 = atomicAdd((&global_6.member[2u]), _e1634);
                                if ((_e1640 + _e1634) < _e1640) {
                                    if _e1636 {
                                    } else {
                                        break;
                                    }
                                    let _e1645 = atomicAdd((&global_6.member[3u]), 1u);
                                }
                            }
                        }
                        if (_e1615.member_1 > 0u) {
                            let _e1647 = (5u < _e101);
                            if _e1647 {
                                if (4u < _e101) {
                                } else {
                                    break;
                                }
                                let _e1651 = atomicAdd((&global_6.member[4u]), _e1615.member_1);
                                if ((_e1651 + _e1615.member_1) < _e1651) {
                                    if _e1647 {
                                    } else {
                                        break;
                                    }
                                    let _e1656 = atomicAdd((&global_6.member[5u]), 1u);
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
