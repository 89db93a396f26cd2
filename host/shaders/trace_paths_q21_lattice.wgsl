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

struct type_21 {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: u32,
}

struct type_23 {
    member: array<type_21>,
}

struct type_25 {
    member: array<f32, 3>,
    member_1: f32,
    member_2: array<f32, 3>,
    member_3: f32,
}

struct type_26 {
    member: type_25,
    member_1: array<f32, 3>,
    member_2: u32,
    member_3: array<f32, 3>,
    member_4: u32,
}

struct type_28 {
    member: array<type_26>,
}

struct type_33 {
    member: vec4<f32>,
    member_1: vec4<f32>,
}

struct type_36 {
    member: array<f32, 3>,
    member_1: u32,
    member_2: f32,
    member_3: array<u32, 3>,
}

struct type_38 {
    member: type_21,
    member_1: f32,
}

struct type_42 {
    member: array<vec4<u32>, 2>,
}

struct type_45 {
    member: array<i32>,
}

struct type_54 {
    member: array<array<u32, 7>>,
}

struct type_59 {
    member: type_33,
    member_1: u32,
}

struct type_62 {
    member: array<vec4<f32>, 3>,
    member_1: type_59,
    member_2: type_59,
}

struct type_69 {
    member: array<atomic<u32>>,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_1: type_12;
@group(0) @binding(1) 
var<uniform> global_2: type_42;
@group(0) @binding(2) 
var<uniform> global_3: type_42;
@group(0) @binding(5) 
var<storage> global_4: type_4;
@group(0) @binding(6) 
var<storage> global_5: type_45;
@group(0) @binding(7) 
var<storage> global_6: type_28;
@group(0) @binding(8) 
var<storage, read_write> global_7: type_23;
@group(0) @binding(9) 
var<storage, read_write> global_8: type_69;
@group(0) @binding(3) 
var<storage> global_9: type_54;
@group(0) @binding(4) 
var<storage> global_10: type_4;

fn function_() {
    var local: array<i32, 3>;
    var local_1: array<i32, 3>;
    var local_2: array<f32, 128>;
    var local_3: array<type_59, 128>;
    var local_4: array<u32, 3>;
    var local_5: array<array<f32, 3>, 3>;
    var local_6: array<f32, 4>;
    var phi_341_: u32;
    var phi_385_: i32;
    var phi_409_: type_36;
    var phi_515_: i32;
    var phi_516_: i32;
    var phi_526_: bool;
    var phi_536_: u32;
    var phi_537_: u32;
    var phi_539_: bool;
    var phi_544_: u32;
    var phi_577_: i32;
    var phi_595_: f32;
    var phi_601_: f32;
    var phi_612_: f32;
    var phi_618_: f32;
    var phi_641_: f32;
    var phi_652_: f32;
    var phi_661_: f32;
    var phi_667_: f32;
    var phi_678_: f32;
    var phi_684_: f32;
    var phi_707_: f32;
    var phi_718_: f32;
    var phi_727_: f32;
    var phi_733_: f32;
    var phi_744_: f32;
    var phi_750_: f32;
    var phi_773_: f32;
    var phi_784_: f32;
    var phi_884_: f32;
    var phi_885_: f32;
    var phi_5064_: bool;
    var phi_2005_: type_38;
    var phi_2008_: type_59;
    var phi_2010_: u32;
    var phi_2012_: bool;
    var phi_2014_: u32;
    var phi_2025_: bool;
    var phi_2062_: type_59;
    var phi_2063_: bool;
    var phi_2064_: u32;
    var phi_4011_: u32;
    var phi_4017_: u32;
    var phi_4271_: u32;
    var phi_4272_: u32;
    var phi_4282_: u32;
    var phi_4284_: u32;
    var phi_4285_: bool;
    var phi_4305_: u32;
    var phi_4306_: u32;
    var phi_4310_: type_62;
    var phi_4654_: type_59;
    var phi_4687_: type_59;
    var phi_4688_: type_59;
    var phi_4689_: u32;
    var phi_4691_: type_59;
    var phi_4692_: u32;
    var phi_4693_: bool;
    var phi_4702_: type_59;
    var phi_4707_: type_59;
    var phi_4708_: bool;
    var phi_5061_: bool;
    var phi_2083_: type_38;
    var phi_2086_: type_8;
    var phi_2087_: type_8;
    var phi_2109_: type_8;
    var phi_2150_: u32;
    var phi_2156_: u32;
    var phi_2166_: u32;
    var phi_2182_: u32;
    var phi_2219_: u32;
    var phi_2225_: u32;
    var phi_2235_: u32;
    var phi_5046_: bool;
    var phi_2251_: type_8;
    var phi_2252_: type_8;
    var phi_2275_: type_8;
    var phi_2298_: u32;
    var phi_2313_: u32;
    var phi_2316_: type_8;
    var phi_2317_: type_8;
    var phi_2340_: type_8;
    var phi_2406_: u32;
    var phi_2386_: u32;
    var phi_2387_: u32;
    var phi_2410_: f32;
    var phi_5039_: bool;
    var phi_5122_: bool;
    var phi_5121_: bool;
    var phi_2910_: vec3<f32>;
    var phi_2911_: vec3<f32>;
    var phi_2942_: bool;
    var phi_2951_: vec3<f32>;
    var phi_2991_: type_21;
    var phi_2993_: type_21;
    var phi_2994_: bool;
    var phi_2998_: type_21;
    var phi_2999_: type_21;
    var phi_3000_: type_21;
    var phi_3001_: bool;
    var phi_3005_: type_21;
    var phi_3006_: bool;
    var phi_3010_: type_21;
    var phi_3011_: bool;
    var phi_3015_: type_21;
    var phi_3038_: u32;
    var phi_3052_: i32;
    var phi_3072_: vec3<f32>;
    var phi_3073_: vec3<f32>;
    var phi_3089_: vec3<f32>;
    var phi_3090_: vec3<f32>;
    var phi_3106_: vec3<f32>;
    var phi_3107_: vec3<f32>;
    var phi_3143_: vec3<f32>;
    var phi_3325_: f32;
    var phi_3343_: bool;
    var phi_3344_: bool;
    var phi_3363_: bool;
    var phi_3364_: bool;
    var phi_3370_: type_38;
    var phi_3371_: type_38;
    var phi_3372_: type_38;
    var phi_5124_: bool;
    var phi_2084_: type_38;
    var phi_5123_: bool;
    var phi_5206_: bool;
    var phi_4710_: type_38;
    var phi_4711_: type_59;
    var phi_4712_: bool;
    var phi_4713_: u32;
    var phi_5205_: bool;
    var phi_4714_: type_38;
    var phi_4715_: type_59;
    var phi_4716_: u32;
    var phi_4717_: bool;
    var phi_4718_: u32;
    var phi_5204_: bool;
    var phi_4719_: type_38;
    var phi_4720_: type_59;
    var phi_4721_: u32;
    var phi_4722_: bool;
    var phi_4723_: u32;
    var phi_5203_: bool;
    var phi_2006_: type_38;
    var phi_2009_: type_59;
    var phi_2011_: u32;
    var phi_2013_: bool;
    var phi_2015_: u32;
    var phi_4724_: bool;
    var phi_5202_: bool;
    var local_7: type_38;
    var phi_4776_: type_21;
    var local_8: type_38;

    switch bitcast<i32>(0u) {
        default: {
            let _e97 = global;
            let _e99 = arrayLength((&global_9.member));
            let _e102 = arrayLength((&global_10.member));
            let _e114 = arrayLength((&global_8.member));
            let _e118 = global_3.member[0u][0u];
            let _e122 = global_3.member[0u][1u];
            let _e126 = global_3.member[0u][2u];
            let _e130 = global_3.member[0u][3u];
            let _e134 = global_3.member[1u][0u];
            let _e138 = global_3.member[1u][1u];
            let _e142 = global_3.member[1u][2u];
            let _e146 = (_e97.x + (_e97.y * 2097152u));
            let _e158 = bitcast<f32>((bitcast<u32>((bitcast<i32>(_e130) + 127i)) << bitcast<u32>(23i)));
            local_1 = array<i32, 3>(bitcast<i32>(_e118), bitcast<i32>(_e122), bitcast<i32>(_e126));
            local = array<i32, 3>(bitcast<i32>(_e134), bitcast<i32>(_e138), bitcast<i32>(_e142));
            let _e161 = (_e146 < arrayLength((&global_6.member)));
            if _e161 {
                if _e161 {
                } else {
                    break;
                }
                let _e165 = global_6.member[_e146].member_2;
                phi_341_ = _e165;
            } else {
                phi_341_ = 4294967295u;
            }
            let _e167 = phi_341_;
            let _e170 = global_1.member[0u];
            let _e174 = global_2.member[0u][0u];
            let _e178 = global_2.member[0u][1u];
            let _e182 = global_2.member[0u][2u];
            let _e186 = global_2.member[0u][3u];
            let _e190 = global_2.member[1u][0u];
            let _e194 = global_2.member[1u][1u];
            let _e198 = global_2.member[1u][2u];
            let _e202 = global_2.member[1u][3u];
            let _e203 = bitcast<f32>(_e174);
            let _e204 = bitcast<f32>(_e178);
            let _e205 = bitcast<f32>(_e182);
            let _e207 = bitcast<f32>(_e190);
            let _e208 = array<u32, 3>(_e194, _e198, _e202);
            let _e210 = bitcast<i32>(_e170);
            if (_e210 < -126i) {
                phi_385_ = -126i;
            } else {
                phi_385_ = select(_e210, 127i, (_e210 > 127i));
            }
            let _e215 = phi_385_;
            let _e220 = bitcast<f32>((bitcast<u32>((_e215 + 127i)) << bitcast<u32>(23i)));
            let _e226 = bitcast<f32>((bitcast<u32>(((_e210 - _e215) + 127i)) << bitcast<u32>(23i)));
            if (_e186 == 0u) {
                phi_409_ = type_36(array<f32, 3>(_e203, _e204, _e205), _e186, _e207, _e208);
            } else {
                phi_409_ = type_36(array<f32, 3>(((_e203 * _e220) * _e226), ((_e204 * _e220) * _e226), ((_e205 * _e220) * _e226)), _e186, ((_e207 * _e220) * _e226), _e208);
            }
            let _e239 = phi_409_;
            if _e161 {
                let _e240 = (_e146 < arrayLength((&global_7.member)));
                if _e240 {
                    if _e161 {
                    } else {
                        break;
                    }
                    let _e250 = global_6.member[_e146].member.member_2[0u];
                    let _e252 = (bitcast<u32>(_e250) & 2147483647u);
                    let _e258 = global_6.member[_e146].member.member_2[1u];
                    let _e260 = (bitcast<u32>(_e258) & 2147483647u);
                    let _e266 = global_6.member[_e146].member.member_2[2u];
                    let _e268 = (bitcast<u32>(_e266) & 2147483647u);
                    let _e274 = global_6.member[_e146].member.member[0u];
                    let _e276 = (bitcast<u32>(_e274) & 2147483647u);
                    let _e282 = global_6.member[_e146].member.member[1u];
                    let _e284 = (bitcast<u32>(_e282) & 2147483647u);
                    let _e290 = global_6.member[_e146].member.member[2u];
                    let _e292 = (bitcast<u32>(_e290) & 2147483647u);
                    let _e294 = select(_e260, _e252, (_e260 < _e252));
                    let _e296 = select(_e268, _e294, (_e268 < _e294));
                    let _e298 = select(_e276, _e296, (_e276 < _e296));
                    let _e300 = select(_e284, _e298, (_e284 < _e298));
                    let _e302 = select(_e292, _e300, (_e292 < _e300));
                    let _e307 = global_6.member[_e146].member.member_1;
                    let _e309 = (bitcast<u32>(_e307) & 2147483647u);
                    let _e317 = global_6.member[_e146].member.member_3;
                    let _e323 = (((select(_e309, _e302, (_e309 < _e302)) < 2139095040u) && ((bitcast<u32>(_e317) & 2147483647u) <= 2139095040u)) && (_e296 > 0u));
                    if _e323 {
                        let _e326 = (bitcast<u32>(bitcast<f32>(_e296)) & 2147483647u);
                        if (_e326 >= 8388608u) {
                            phi_515_ = (bitcast<i32>((_e326 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_515_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e326)), 32u, (_e326 == 0u))));
                        }
                        let _e340 = phi_515_;
                        phi_516_ = _e340;
                    } else {
                        phi_516_ = 0i;
                    }
                    let _e342 = phi_516_;
                    let _e343 = (_e252 == _e296);
                    if _e343 {
                        phi_526_ = true;
                    } else {
                        phi_526_ = (_e260 == _e296);
                    }
                    let _e346 = phi_526_;
                    let _e347 = select(1u, 0u, _e343);
                    if _e346 {
                        let _e348 = (_e347 + 1u);
                        phi_536_ = _e348;
                        phi_537_ = _e348;
                        phi_539_ = select(true, false, (_e348 == 2u));
                    } else {
                        phi_536_ = u32();
                        phi_537_ = 0u;
                        phi_539_ = true;
                    }
                    let _e352 = phi_536_;
                    let _e354 = phi_537_;
                    let _e356 = phi_539_;
                    if _e356 {
                        phi_544_ = (_e354 + 1u);
                    } else {
                        phi_544_ = 0u;
                    }
                    let _e360 = phi_544_;
                    let _e361 = select(_e352, _e354, _e356);
                    let _e362 = select(_e347, select(2u, _e347, _e346), _e356);
                    let _e363 = -(_e342);
                    if (_e363 < -126i) {
                        phi_577_ = -126i;
                    } else {
                        phi_577_ = select(_e363, 127i, (_e363 > 127i));
                    }
                    let _e368 = phi_577_;
                    let _e373 = bitcast<f32>((bitcast<u32>((_e368 + 127i)) << bitcast<u32>(23i)));
                    let _e379 = bitcast<f32>((bitcast<u32>(((_e363 - _e368) + 127i)) << bitcast<u32>(23i)));
                    let _e384 = global_6.member[_e146].member.member;
                    let _e385 = (_e361 == 0u);
                    if _e385 {
                        phi_595_ = _e384[0];
                    } else {
                        phi_595_ = _e384[1];
                    }
                    let _e389 = phi_595_;
                    let _e390 = (_e361 == 2u);
                    if _e390 {
                        phi_601_ = _e384[2];
                    } else {
                        phi_601_ = _e389;
                    }
                    let _e393 = phi_601_;
                    let _e394 = global_6.member[_e146].member.member_2;
                    if _e385 {
                        phi_612_ = _e394[0];
                    } else {
                        phi_612_ = _e394[1];
                    }
                    let _e398 = phi_612_;
                    if _e390 {
                        phi_618_ = _e394[2];
                    } else {
                        phi_618_ = _e398;
                    }
                    let _e401 = phi_618_;
                    let _e403 = ((_e401 * _e373) * _e379);
                    let _e407 = (bitcast<f32>((bitcast<u32>(_e403) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e407 {
                        let _e411 = (bitcast<f32>((bitcast<u32>(_e393) & 2147483647u)) * 0.00000011920929f);
                        phi_641_ = select(0.00000000000011368684f, _e411, (_e411 > 0.00000000000011368684f));
                    } else {
                        phi_641_ = 0f;
                    }
                    let _e415 = phi_641_;
                    let _e416 = (_e393 + _e415);
                    let _e417 = (_e393 - _e415);
                    let _e418 = select(_e403, 0f, _e407);
                    if _e407 {
                        phi_652_ = 38685626000000000000000000f;
                    } else {
                        phi_652_ = (1f / _e403);
                    }
                    let _e421 = phi_652_;
                    let _e422 = (_e360 == 0u);
                    if _e422 {
                        phi_661_ = _e384[0];
                    } else {
                        phi_661_ = _e384[1];
                    }
                    let _e426 = phi_661_;
                    let _e427 = (_e360 == 2u);
                    if _e427 {
                        phi_667_ = _e384[2];
                    } else {
                        phi_667_ = _e426;
                    }
                    let _e430 = phi_667_;
                    if _e422 {
                        phi_678_ = _e394[0];
                    } else {
                        phi_678_ = _e394[1];
                    }
                    let _e434 = phi_678_;
                    if _e427 {
                        phi_684_ = _e394[2];
                    } else {
                        phi_684_ = _e434;
                    }
                    let _e437 = phi_684_;
                    let _e439 = ((_e437 * _e373) * _e379);
                    let _e443 = (bitcast<f32>((bitcast<u32>(_e439) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e443 {
                        let _e447 = (bitcast<f32>((bitcast<u32>(_e430) & 2147483647u)) * 0.00000011920929f);
                        phi_707_ = select(0.00000000000011368684f, _e447, (_e447 > 0.00000000000011368684f));
                    } else {
                        phi_707_ = 0f;
                    }
                    let _e451 = phi_707_;
                    let _e452 = (_e430 + _e451);
                    let _e453 = (_e430 - _e451);
                    let _e454 = select(_e439, 0f, _e443);
                    if _e443 {
                        phi_718_ = 38685626000000000000000000f;
                    } else {
                        phi_718_ = (1f / _e439);
                    }
                    let _e457 = phi_718_;
                    let _e458 = (_e362 == 0u);
                    if _e458 {
                        phi_727_ = _e384[0];
                    } else {
                        phi_727_ = _e384[1];
                    }
                    let _e462 = phi_727_;
                    let _e463 = (_e362 == 2u);
                    if _e463 {
                        phi_733_ = _e384[2];
                    } else {
                        phi_733_ = _e462;
                    }
                    let _e466 = phi_733_;
                    if _e458 {
                        phi_744_ = _e394[0];
                    } else {
                        phi_744_ = _e394[1];
                    }
                    let _e470 = phi_744_;
                    if _e463 {
                        phi_750_ = _e394[2];
                    } else {
                        phi_750_ = _e470;
                    }
                    let _e473 = phi_750_;
                    let _e475 = ((_e473 * _e373) * _e379);
                    let _e479 = (bitcast<f32>((bitcast<u32>(_e475) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e479 {
                        let _e483 = (bitcast<f32>((bitcast<u32>(_e466) & 2147483647u)) * 0.00000011920929f);
                        phi_773_ = select(0.00000000000011368684f, _e483, (_e483 > 0.00000000000011368684f));
                    } else {
                        phi_773_ = 0f;
                    }
                    let _e487 = phi_773_;
                    let _e488 = (_e466 + _e487);
                    let _e489 = (_e466 - _e487);
                    let _e490 = select(_e475, 0f, _e479);
                    if _e479 {
                        phi_784_ = 38685626000000000000000000f;
                    } else {
                        phi_784_ = (1f / _e475);
                    }
                    let _e493 = phi_784_;
                    let _e496 = bitcast<f32>((bitcast<u32>(_e393) & 2147483647u));
                    let _e499 = bitcast<f32>((bitcast<u32>(_e430) & 2147483647u));
                    let _e501 = select(_e499, _e496, (_e496 > _e499));
                    let _e504 = bitcast<f32>((bitcast<u32>(_e466) & 2147483647u));
                    if (_e323 && (select(_e504, _e501, (_e501 > _e504)) <= 1099511600000f)) {
                        let _e509 = (_e342 / 3i);
                        let _e516 = bitcast<f32>((bitcast<u32>((_e509 + 127i)) << bitcast<u32>(23i)));
                        let _e523 = bitcast<f32>((bitcast<u32>(((_e342 - (2i * _e509)) + 127i)) << bitcast<u32>(23i)));
                        let _e524 = (((_e307 * _e516) * _e516) * _e523);
                        let _e526 = select(340282350000000000000000000000000000000f, _e524, (_e524 < 340282350000000000000000000000000000000f));
                        let _e531 = (((_e317 * _e516) * _e516) * _e523);
                        let _e533 = select(340282350000000000000000000000000000000f, _e531, (_e531 < 340282350000000000000000000000000000000f));
                        phi_884_ = select(-340282350000000000000000000000000000000f, _e533, (_e533 > -340282350000000000000000000000000000000f));
                        phi_885_ = select(-340282350000000000000000000000000000000f, _e526, (_e526 > -340282350000000000000000000000000000000f));
                    } else {
                        phi_884_ = 0f;
                        phi_885_ = 1f;
                    }
                    let _e537 = phi_884_;
                    let _e539 = phi_885_;
                    local_3 = array<type_59, 128>(type_59(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u));
                    local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    let _e543 = (_e361 % 3u);
                    let _e544 = (_e543 < 3u);
                    if _e544 {
                    } else {
                        break;
                    }
                    let _e546 = local_1[_e543];
                    let _e549 = (_e360 % 3u);
                    let _e550 = (_e549 < 3u);
                    if _e550 {
                    } else {
                        break;
                    }
                    let _e552 = local_1[_e549];
                    let _e555 = (_e362 % 3u);
                    let _e556 = (_e555 < 3u);
                    if _e556 {
                    } else {
                        break;
                    }
                    let _e558 = local_1[_e555];
                    if _e544 {
                    } else {
                        break;
                    }
                    let _e563 = local[_e543];
                    if _e550 {
                    } else {
                        break;
                    }
                    let _e567 = local[_e549];
                    if _e556 {
                    } else {
                        break;
                    }
                    let _e571 = local[_e555];
                    phi_5064_ = false;
                    phi_2005_ = type_38(type_21(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e537);
                    phi_2008_ = type_59(type_33(vec4<f32>((f32(_e546) * _e158), (f32(_e552) * _e158), (f32(_e558) * _e158), 0f), vec4<f32>((f32(_e563) * _e158), (f32(_e567) * _e158), (f32(_e571) * _e158), 0f)), select(0u, 2147483648u, (_e99 == 0u)));
                    phi_2010_ = ((3u * _e99) + 1u);
                    phi_2012_ = (_e539 <= _e537);
                    phi_2014_ = 0u;
                    loop {
                        let _e581 = phi_5064_;
                        let _e583 = phi_2005_;
                        let _e585 = phi_2008_;
                        let _e587 = phi_2010_;
                        let _e589 = phi_2012_;
                        let _e591 = phi_2014_;
                        local_7 = _e583;
                        if _e589 {
                            phi_2025_ = true;
                        } else {
                            phi_2025_ = (_e591 > 0u);
                        }
                        let _e594 = phi_2025_;
                        if _e594 {
                            let _e595 = (_e587 > 0u);
                            if _e595 {
                                if _e589 {
                                    phi_2062_ = _e585;
                                    phi_2063_ = _e589;
                                    phi_2064_ = _e591;
                                } else {
                                    let _e596 = (_e591 - 1u);
                                    let _e597 = (_e596 % 128u);
                                    let _e598 = (_e597 < 128u);
                                    if _e598 {
                                    } else {
                                        phi_5202_ = true;
                                        break;
                                    }
                                    let _e600 = local_3[_e597];
                                    if _e598 {
                                    } else {
                                        phi_5202_ = true;
                                        break;
                                    }
                                    let _e608 = local_2[_e597];
                                    phi_2062_ = type_59(type_33(_e600.member.member, _e600.member.member_1), _e600.member_1);
                                    phi_2063_ = (_e608 <= _e583.member_1);
                                    phi_2064_ = _e596;
                                }
                                let _e612 = phi_2062_;
                                let _e614 = phi_2063_;
                                let _e616 = phi_2064_;
                                if _e614 {
                                    let _e621 = (_e612.member_1 & 268435455u);
                                    if ((_e612.member_1 & 2147483648u) != 0u) {
                                        phi_5061_ = _e581;
                                        phi_2083_ = _e583;
                                        phi_2086_ = type_8(0u, ((_e612.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e1083 = phi_5061_;
                                            let _e1085 = phi_2083_;
                                            let _e1087 = phi_2086_;
                                            local_8 = _e1085;
                                            if (_e1087.member < _e1087.member_1) {
                                                phi_2087_ = type_8((_e1087.member + 1u), _e1087.member_1);
                                                phi_2109_ = type_8(1u, _e1087.member);
                                            } else {
                                                phi_2087_ = _e1087;
                                                phi_2109_ = type_8(0u, type_8().member_1);
                                            }
                                            let _e1100 = phi_2087_;
                                            let _e1102 = phi_2109_;
                                            let _e1106 = (bitcast<i32>(_e1102.member) != 0i);
                                            if _e1106 {
                                                let _e1111 = (_e612.member.member_1.x - _e612.member.member.x);
                                                let _e1114 = (_e612.member.member_1.y - _e612.member.member.y);
                                                let _e1117 = (_e612.member.member_1.z - _e612.member.member.z);
                                                let _e1119 = select(_e1114, _e1111, (_e1111 > _e1114));
                                                let _e1121 = select(_e1117, _e1119, (_e1119 > _e1117));
                                                let _e1123 = (_e1121 < (1024f * _e158));
                                                if _e1123 {
                                                    phi_2150_ = 0u;
                                                } else {
                                                    phi_2150_ = select(2u, 1u, (_e1121 < (2097152f * _e158)));
                                                }
                                                let _e1128 = phi_2150_;
                                                switch bitcast<i32>(_e1128) {
                                                    case 0: {
                                                        phi_2156_ = 1u;
                                                        break;
                                                    }
                                                    case 1: {
                                                        phi_2156_ = 2u;
                                                        break;
                                                    }
                                                    case 2: {
                                                        phi_2156_ = 3u;
                                                        break;
                                                    }
                                                    default: {
                                                        phi_2156_ = u32();
                                                        break;
                                                    }
                                                }
                                                let _e1131 = phi_2156_;
                                                switch bitcast<i32>(_e1128) {
                                                    case 0: {
                                                        phi_2166_ = 1u;
                                                        break;
                                                    }
                                                    case 1: {
                                                        phi_2166_ = 2u;
                                                        break;
                                                    }
                                                    case 2: {
                                                        phi_2166_ = 3u;
                                                        break;
                                                    }
                                                    default: {
                                                        phi_2166_ = u32();
                                                        break;
                                                    }
                                                }
                                                let _e1138 = phi_2166_;
                                                let _e1140 = ((_e621 + (_e1102.member_1 * ((3u * _e1131) + 1u))) + (3u * _e1138));
                                                let _e1141 = (_e1140 < _e102);
                                                if _e1141 {
                                                    if _e1141 {
                                                    } else {
                                                        phi_5123_ = true;
                                                        break;
                                                    }
                                                    let _e1143 = global_10.member[_e1140];
                                                    phi_2182_ = _e1143;
                                                } else {
                                                    phi_2182_ = 4294967295u;
                                                }
                                                let _e1145 = phi_2182_;
                                                local_4 = array<u32, 3>(_e361, _e360, _e362);
                                                if _e1123 {
                                                    phi_2219_ = 0u;
                                                } else {
                                                    phi_2219_ = select(2u, 1u, (_e1121 < (2097152f * _e158)));
                                                }
                                                let _e1151 = phi_2219_;
                                                switch bitcast<i32>(_e1151) {
                                                    case 0: {
                                                        phi_2225_ = 1u;
                                                        break;
                                                    }
                                                    case 1: {
                                                        phi_2225_ = 2u;
                                                        break;
                                                    }
                                                    case 2: {
                                                        phi_2225_ = 3u;
                                                        break;
                                                    }
                                                    default: {
                                                        phi_2225_ = u32();
                                                        break;
                                                    }
                                                }
                                                let _e1154 = phi_2225_;
                                                switch bitcast<i32>(_e1151) {
                                                    case 0: {
                                                        phi_2235_ = 1u;
                                                        break;
                                                    }
                                                    case 1: {
                                                        phi_2235_ = 2u;
                                                        break;
                                                    }
                                                    case 2: {
                                                        phi_2235_ = 3u;
                                                        break;
                                                    }
                                                    default: {
                                                        phi_2235_ = u32();
                                                        break;
                                                    }
                                                }
                                                let _e1161 = phi_2235_;
                                                local_6 = array<f32, 4>(_e612.member.member.x, _e612.member.member.y, _e612.member.member.z, _e612.member.member.w);
                                                local_5[0u] = array<f32, 3>(0f, 0f, 0f);
                                                local_5[1u] = array<f32, 3>(0f, 0f, 0f);
                                                local_5[2u] = array<f32, 3>(0f, 0f, 0f);
                                                phi_5046_ = _e1083;
                                                phi_2251_ = type_8(0u, 3u);
                                                loop {
                                                    let _e1175 = phi_5046_;
                                                    let _e1177 = phi_2251_;
                                                    if (_e1177.member < _e1177.member_1) {
                                                        phi_2252_ = type_8((_e1177.member + 1u), _e1177.member_1);
                                                        phi_2275_ = type_8(1u, _e1177.member);
                                                    } else {
                                                        phi_2252_ = _e1177;
                                                        phi_2275_ = type_8(0u, type_8().member_1);
                                                    }
                                                    let _e1190 = phi_2252_;
                                                    let _e1192 = phi_2275_;
                                                    let _e1196 = (bitcast<i32>(_e1192.member) != 0i);
                                                    if _e1196 {
                                                        let _e1198 = ((_e621 + (_e1102.member_1 * ((3u * _e1154) + 1u))) + (_e1192.member_1 * _e1161));
                                                        let _e1199 = (_e1198 < _e102);
                                                        if _e1199 {
                                                            if _e1199 {
                                                            } else {
                                                                phi_5121_ = true;
                                                                break;
                                                            }
                                                            let _e1201 = global_10.member[_e1198];
                                                            phi_2298_ = _e1201;
                                                        } else {
                                                            phi_2298_ = 0u;
                                                        }
                                                        let _e1203 = phi_2298_;
                                                        let _e1204 = (_e1198 + 1u);
                                                        let _e1205 = (_e1204 < _e102);
                                                        if _e1205 {
                                                            if _e1205 {
                                                            } else {
                                                                phi_5121_ = true;
                                                                break;
                                                            }
                                                            let _e1207 = global_10.member[_e1204];
                                                            phi_2313_ = _e1207;
                                                        } else {
                                                            phi_2313_ = 0u;
                                                        }
                                                        let _e1209 = phi_2313_;
                                                        phi_2316_ = type_8(0u, 3u);
                                                        loop {
                                                            let _e1211 = phi_2316_;
                                                            if (_e1211.member < _e1211.member_1) {
                                                                phi_2317_ = type_8((_e1211.member + 1u), _e1211.member_1);
                                                                phi_2340_ = type_8(1u, _e1211.member);
                                                            } else {
                                                                phi_2317_ = _e1211;
                                                                phi_2340_ = type_8(0u, type_8().member_1);
                                                            }
                                                            let _e1224 = phi_2317_;
                                                            let _e1226 = phi_2340_;
                                                            let _e1230 = (bitcast<i32>(_e1226.member) != 0i);
                                                            if _e1230 {
                                                                let _e1231 = (_e1226.member_1 < 3u);
                                                                if _e1231 {
                                                                } else {
                                                                    phi_5039_ = true;
                                                                    break;
                                                                }
                                                                let _e1233 = local_4[_e1226.member_1];
                                                                if (_e1226.member_1 < 4u) {
                                                                } else {
                                                                    phi_5039_ = true;
                                                                    break;
                                                                }
                                                                let _e1236 = local_6[_e1226.member_1];
                                                                switch bitcast<i32>(_e1151) {
                                                                    case 0: {
                                                                        phi_2410_ = (_e1236 + (f32(((_e1203 >> bitcast<u32>(((10u * _e1233) & 31u))) & 1023u)) * _e158));
                                                                        break;
                                                                    }
                                                                    case 1: {
                                                                        if (_e1233 == 0u) {
                                                                            phi_2387_ = _e1203;
                                                                        } else {
                                                                            if (_e1233 == 1u) {
                                                                                phi_2386_ = ((_e1203 >> bitcast<u32>(21i)) | (_e1209 << bitcast<u32>(11i)));
                                                                            } else {
                                                                                phi_2386_ = (_e1209 >> bitcast<u32>(10i));
                                                                            }
                                                                            let _e1257 = phi_2386_;
                                                                            phi_2387_ = _e1257;
                                                                        }
                                                                        let _e1259 = phi_2387_;
                                                                        phi_2410_ = (_e1236 + (f32((_e1259 & 2097151u)) * _e158));
                                                                        break;
                                                                    }
                                                                    case 2: {
                                                                        let _e1238 = (_e1198 + _e1233);
                                                                        let _e1239 = (_e1238 < _e102);
                                                                        if _e1239 {
                                                                            if _e1239 {
                                                                            } else {
                                                                                phi_5039_ = true;
                                                                                break;
                                                                            }
                                                                            let _e1241 = global_10.member[_e1238];
                                                                            phi_2406_ = _e1241;
                                                                        } else {
                                                                            phi_2406_ = 0u;
                                                                        }
                                                                        let _e1243 = phi_2406_;
                                                                        phi_2410_ = (f32(bitcast<i32>(_e1243)) * _e158);
                                                                        break;
                                                                    }
                                                                    default: {
                                                                        phi_2410_ = f32();
                                                                        break;
                                                                    }
                                                                }
                                                                let _e1273 = phi_2410_;
                                                                if (_e1192.member_1 < 3u) {
                                                                } else {
                                                                    phi_5039_ = true;
                                                                    break;
                                                                }
                                                                if _e1231 {
                                                                } else {
                                                                    phi_5039_ = true;
                                                                    break;
                                                                }
                                                                local_5[_e1192.member_1][_e1226.member_1] = _e1273;
                                                            }
                                                            continue;
                                                            continuing {
                                                                phi_2316_ = _e1224;
                                                                phi_5039_ = _e1175;
                                                                break if !(_e1230);
                                                            }
                                                        }
                                                        let _e1279 = phi_5039_;
                                                        phi_5121_ = _e1279;
                                                        if _e1279 {
                                                            break;
                                                        }
                                                        phi_5122_ = _e1279;
                                                    } else {
                                                        phi_5122_ = _e1175;
                                                    }
                                                    let _e1281 = phi_5122_;
                                                    continue;
                                                    continuing {
                                                        phi_5046_ = _e1281;
                                                        phi_2251_ = _e1190;
                                                        phi_5121_ = _e1281;
                                                        break if !(_e1196);
                                                    }
                                                }
                                                let _e1284 = phi_5121_;
                                                phi_5123_ = _e1284;
                                                if _e1284 {
                                                    break;
                                                }
                                                let _e1285 = local_5;
                                                let _e1301 = (_e1285[0][2] - _e466);
                                                let _e1304 = (((_e1285[0][0] - _e393) * _e490) - (_e1301 * _e418));
                                                let _e1307 = (((_e1285[0][1] - _e430) * _e490) - (_e1301 * _e454));
                                                let _e1310 = (_e1285[1][2] - _e466);
                                                let _e1313 = (((_e1285[1][0] - _e393) * _e490) - (_e1310 * _e418));
                                                let _e1316 = (((_e1285[1][1] - _e430) * _e490) - (_e1310 * _e454));
                                                let _e1319 = (_e1285[2][2] - _e466);
                                                let _e1322 = (((_e1285[2][0] - _e393) * _e490) - (_e1319 * _e418));
                                                let _e1325 = (((_e1285[2][1] - _e430) * _e490) - (_e1319 * _e454));
                                                let _e1326 = (_e1322 * _e1316);
                                                let _e1327 = (_e1325 * _e1313);
                                                let _e1328 = (_e1304 * _e1325);
                                                let _e1329 = (_e1307 * _e1322);
                                                let _e1330 = (_e1313 * _e1307);
                                                let _e1331 = (_e1316 * _e1304);
                                                let _e1336 = (((_e1326 >= _e1327) && (_e1328 >= _e1329)) && (_e1330 >= _e1331));
                                                if (_e1336 || (((_e1326 <= _e1327) && (_e1328 <= _e1329)) && (_e1330 <= _e1331))) {
                                                    let _e1343 = select(-1f, 1f, _e1336);
                                                    let _e1345 = ((_e1326 - _e1327) * _e1343);
                                                    let _e1347 = select(0f, _e1345, (_e1345 > 0f));
                                                    let _e1349 = ((_e1328 - _e1329) * _e1343);
                                                    let _e1351 = select(0f, _e1349, (_e1349 > 0f));
                                                    let _e1353 = ((_e1330 - _e1331) * _e1343);
                                                    let _e1355 = select(0f, _e1353, (_e1353 > 0f));
                                                    let _e1357 = ((_e1347 + _e1351) + _e1355);
                                                    if (_e1357 < 0.000000000000000000000000000000000000011754944f) {
                                                        phi_3005_ = type_21();
                                                        phi_3006_ = true;
                                                    } else {
                                                        let _e1360 = select(_e1285[1][0], _e1285[0][0], (_e1285[0][0] < _e1285[1][0]));
                                                        let _e1364 = select(_e1285[1][0], _e1285[0][0], (_e1285[0][0] > _e1285[1][0]));
                                                        let _e1368 = select(_e1285[1][1], _e1285[0][1], (_e1285[0][1] < _e1285[1][1]));
                                                        let _e1372 = select(_e1285[1][1], _e1285[0][1], (_e1285[0][1] > _e1285[1][1]));
                                                        let _e1376 = select(_e1285[1][2], _e1285[0][2], (_e1285[0][2] < _e1285[1][2]));
                                                        let _e1380 = select(_e1285[1][2], _e1285[0][2], (_e1285[0][2] > _e1285[1][2]));
                                                        let _e1385 = ((select(_e1285[2][0], _e1360, (_e1360 < _e1285[2][0])) - _e416) * _e421);
                                                        let _e1386 = ((select(_e1285[2][0], _e1364, (_e1364 > _e1285[2][0])) - _e417) * _e421);
                                                        let _e1389 = ((select(_e1285[2][1], _e1368, (_e1368 < _e1285[2][1])) - _e452) * _e457);
                                                        let _e1390 = ((select(_e1285[2][1], _e1372, (_e1372 > _e1285[2][1])) - _e453) * _e457);
                                                        let _e1393 = ((select(_e1285[2][2], _e1376, (_e1376 < _e1285[2][2])) - _e488) * _e493);
                                                        let _e1394 = ((select(_e1285[2][2], _e1380, (_e1380 > _e1285[2][2])) - _e489) * _e493);
                                                        let _e1396 = select(_e1394, _e1393, (_e1393 < _e1394));
                                                        let _e1398 = select(_e1394, _e1393, (_e1393 > _e1394));
                                                        let _e1400 = select(_e1386, _e1385, (_e1385 < _e1386));
                                                        let _e1402 = select(_e1390, _e1389, (_e1389 < _e1390));
                                                        let _e1404 = select(_e1402, _e1400, (_e1400 > _e1402));
                                                        let _e1406 = select(_e1396, _e1404, (_e1404 > _e1396));
                                                        let _e1408 = select(_e1386, _e1385, (_e1385 > _e1386));
                                                        let _e1410 = select(_e1390, _e1389, (_e1389 > _e1390));
                                                        let _e1412 = select(_e1410, _e1408, (_e1408 < _e1410));
                                                        let _e1414 = select(_e1398, _e1412, (_e1412 < _e1398));
                                                        let _e1415 = -(_e1396);
                                                        let _e1421 = select(_e539, _e1406, (_e1406 > _e539));
                                                        if (_e1421 > (_e1414 + (select(_e1415, _e1398, (_e1398 > _e1415)) * 0.0000019073523f))) {
                                                            phi_3000_ = type_21();
                                                            phi_3001_ = true;
                                                        } else {
                                                            let _e1423 = (_e1421 > _e1085.member_1);
                                                            if _e1423 {
                                                                phi_2999_ = type_21();
                                                            } else {
                                                                let _e1427 = (_e1285[1][0] - _e1285[0][0]);
                                                                let _e1428 = (_e1285[1][1] - _e1285[0][1]);
                                                                let _e1429 = (_e1285[1][2] - _e1285[0][2]);
                                                                let _e1430 = vec3<f32>(_e1427, _e1428, _e1429);
                                                                let _e1431 = (_e1285[2][0] - _e1285[1][0]);
                                                                let _e1432 = (_e1285[2][1] - _e1285[1][1]);
                                                                let _e1433 = (_e1285[2][2] - _e1285[1][2]);
                                                                let _e1434 = vec3<f32>(_e1431, _e1432, _e1433);
                                                                let _e1435 = (_e1285[0][0] - _e1285[2][0]);
                                                                let _e1436 = (_e1285[0][1] - _e1285[2][1]);
                                                                let _e1437 = (_e1285[0][2] - _e1285[2][2]);
                                                                let _e1438 = vec3<f32>(_e1435, _e1436, _e1437);
                                                                let _e1441 = bitcast<f32>((bitcast<u32>(_e1427) & 2147483647u));
                                                                let _e1444 = bitcast<f32>((bitcast<u32>(_e1428) & 2147483647u));
                                                                let _e1446 = select(_e1444, _e1441, (_e1441 > _e1444));
                                                                let _e1449 = bitcast<f32>((bitcast<u32>(_e1429) & 2147483647u));
                                                                let _e1451 = select(_e1449, _e1446, (_e1446 > _e1449));
                                                                let _e1454 = bitcast<f32>((bitcast<u32>(_e1431) & 2147483647u));
                                                                let _e1457 = bitcast<f32>((bitcast<u32>(_e1432) & 2147483647u));
                                                                let _e1459 = select(_e1457, _e1454, (_e1454 > _e1457));
                                                                let _e1462 = bitcast<f32>((bitcast<u32>(_e1433) & 2147483647u));
                                                                let _e1464 = select(_e1462, _e1459, (_e1459 > _e1462));
                                                                let _e1467 = bitcast<f32>((bitcast<u32>(_e1435) & 2147483647u));
                                                                let _e1470 = bitcast<f32>((bitcast<u32>(_e1436) & 2147483647u));
                                                                let _e1472 = select(_e1470, _e1467, (_e1467 > _e1470));
                                                                let _e1475 = bitcast<f32>((bitcast<u32>(_e1437) & 2147483647u));
                                                                let _e1477 = select(_e1475, _e1472, (_e1472 > _e1475));
                                                                let _e1479 = select(_e1464, _e1451, (_e1451 > _e1464));
                                                                let _e1481 = select(_e1477, _e1479, (_e1479 > _e1477));
                                                                if (_e1451 == _e1481) {
                                                                    phi_2910_ = _e1434;
                                                                    phi_2911_ = _e1438;
                                                                } else {
                                                                    let _e1484 = vec3((_e1464 == _e1481));
                                                                    phi_2910_ = select(_e1430, _e1438, _e1484);
                                                                    phi_2911_ = select(_e1434, _e1430, _e1484);
                                                                }
                                                                let _e1488 = phi_2910_;
                                                                let _e1490 = phi_2911_;
                                                                let _e1497 = ((_e1488.y * _e1490.z) - (_e1490.y * _e1488.z));
                                                                let _e1502 = ((_e1488.z * _e1490.x) - (_e1490.z * _e1488.x));
                                                                let _e1505 = ((_e1488.x * _e1490.y) - (_e1490.x * _e1488.y));
                                                                if (_e1347 >= _e1351) {
                                                                    phi_2942_ = select(true, false, (_e1347 >= _e1355));
                                                                } else {
                                                                    phi_2942_ = true;
                                                                }
                                                                let _e1510 = phi_2942_;
                                                                if _e1510 {
                                                                    phi_2951_ = select(vec3<f32>(_e1285[2][0], _e1285[2][1], _e1285[2][2]), vec3<f32>(_e1285[1][0], _e1285[1][1], _e1285[1][2]), vec3((_e1351 >= _e1355)));
                                                                } else {
                                                                    phi_2951_ = vec3<f32>(_e1285[0][0], _e1285[0][1], _e1285[0][2]);
                                                                }
                                                                let _e1515 = phi_2951_;
                                                                let _e1532 = ((((_e1497 * (_e1515.x - _e393)) + (_e1502 * (_e1515.y - _e430))) + (_e1505 * (_e1515.z - _e466))) / (((_e1497 * _e418) + (_e1502 * _e454)) + (_e1505 * _e490)));
                                                                let _e1534 = select(_e1414, _e1532, (_e1532 < _e1414));
                                                                let _e1536 = select(_e1406, _e1534, (_e1534 > _e1406));
                                                                if (_e1536 >= _e539) {
                                                                    let _e1538 = (_e1536 <= _e1085.member_1);
                                                                    if _e1538 {
                                                                        let _e1539 = (1f / _e1357);
                                                                        phi_2991_ = type_21(_e1536, (_e1351 * _e1539), (_e1355 * _e1539), _e1145);
                                                                    } else {
                                                                        phi_2991_ = type_21();
                                                                    }
                                                                    let _e1544 = phi_2991_;
                                                                    phi_2993_ = _e1544;
                                                                    phi_2994_ = select(true, false, _e1538);
                                                                } else {
                                                                    phi_2993_ = type_21();
                                                                    phi_2994_ = true;
                                                                }
                                                                let _e1547 = phi_2993_;
                                                                let _e1549 = phi_2994_;
                                                                if _e1549 {
                                                                    phi_2998_ = type_21(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                } else {
                                                                    phi_2998_ = _e1547;
                                                                }
                                                                let _e1551 = phi_2998_;
                                                                phi_2999_ = _e1551;
                                                            }
                                                            let _e1553 = phi_2999_;
                                                            phi_3000_ = _e1553;
                                                            phi_3001_ = _e1423;
                                                        }
                                                        let _e1555 = phi_3000_;
                                                        let _e1557 = phi_3001_;
                                                        phi_3005_ = _e1555;
                                                        phi_3006_ = _e1557;
                                                    }
                                                    let _e1559 = phi_3005_;
                                                    let _e1561 = phi_3006_;
                                                    phi_3010_ = _e1559;
                                                    phi_3011_ = _e1561;
                                                } else {
                                                    phi_3010_ = type_21();
                                                    phi_3011_ = true;
                                                }
                                                let _e1563 = phi_3010_;
                                                let _e1565 = phi_3011_;
                                                if _e1565 {
                                                    phi_3015_ = type_21(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                } else {
                                                    phi_3015_ = _e1563;
                                                }
                                                let _e1567 = phi_3015_;
                                                if (_e1567.member_3 != 4294967295u) {
                                                    if (_e1145 == _e167) {
                                                        phi_3344_ = false;
                                                    } else {
                                                        let _e1571 = (_e1145 < arrayLength((&global_4.member)));
                                                        if _e1571 {
                                                            if _e1571 {
                                                            } else {
                                                                phi_5123_ = true;
                                                                break;
                                                            }
                                                            let _e1573 = global_4.member[_e1145];
                                                            phi_3038_ = _e1573;
                                                        } else {
                                                            phi_3038_ = 4294967295u;
                                                        }
                                                        let _e1575 = phi_3038_;
                                                        let _e1576 = (_e1575 < arrayLength((&global_5.member)));
                                                        if _e1576 {
                                                            if _e1576 {
                                                            } else {
                                                                phi_5123_ = true;
                                                                break;
                                                            }
                                                            let _e1578 = global_5.member[_e1575];
                                                            phi_3052_ = _e1578;
                                                        } else {
                                                            phi_3052_ = 0i;
                                                        }
                                                        let _e1580 = phi_3052_;
                                                        let _e1581 = (_e1580 == 0i);
                                                        if _e1581 {
                                                            phi_3343_ = true;
                                                        } else {
                                                            if _e385 {
                                                                phi_3073_ = vec3<f32>(_e1285[0][0], _e1285[0][1], _e1285[0][2]);
                                                            } else {
                                                                if (_e361 == 1u) {
                                                                    phi_3072_ = vec3<f32>(_e1285[0][2], _e1285[0][0], _e1285[0][1]);
                                                                } else {
                                                                    phi_3072_ = vec3<f32>(_e1285[0][1], _e1285[0][2], _e1285[0][0]);
                                                                }
                                                                let _e1586 = phi_3072_;
                                                                phi_3073_ = _e1586;
                                                            }
                                                            let _e1589 = phi_3073_;
                                                            if _e385 {
                                                                phi_3090_ = vec3<f32>(_e1285[1][0], _e1285[1][1], _e1285[1][2]);
                                                            } else {
                                                                if (_e361 == 1u) {
                                                                    phi_3089_ = vec3<f32>(_e1285[1][2], _e1285[1][0], _e1285[1][1]);
                                                                } else {
                                                                    phi_3089_ = vec3<f32>(_e1285[1][1], _e1285[1][2], _e1285[1][0]);
                                                                }
                                                                let _e1594 = phi_3089_;
                                                                phi_3090_ = _e1594;
                                                            }
                                                            let _e1597 = phi_3090_;
                                                            if _e385 {
                                                                phi_3107_ = vec3<f32>(_e1285[2][0], _e1285[2][1], _e1285[2][2]);
                                                            } else {
                                                                if (_e361 == 1u) {
                                                                    phi_3106_ = vec3<f32>(_e1285[2][2], _e1285[2][0], _e1285[2][1]);
                                                                } else {
                                                                    phi_3106_ = vec3<f32>(_e1285[2][1], _e1285[2][2], _e1285[2][0]);
                                                                }
                                                                let _e1602 = phi_3106_;
                                                                phi_3107_ = _e1602;
                                                            }
                                                            let _e1605 = phi_3107_;
                                                            let _e1608 = (_e1597.x - _e1589.x);
                                                            let _e1611 = (_e1597.y - _e1589.y);
                                                            let _e1614 = (_e1597.z - _e1589.z);
                                                            let _e1616 = (_e1605.x - _e1589.x);
                                                            let _e1618 = (_e1605.y - _e1589.y);
                                                            let _e1620 = (_e1605.z - _e1589.z);
                                                            if (_e239.member_1 == 1u) {
                                                                phi_3143_ = (vec3<f32>(_e239.member[0], _e239.member[1], _e239.member[2]) - _e1589);
                                                            } else {
                                                                phi_3143_ = vec3<f32>(_e239.member[0], _e239.member[1], _e239.member[2]);
                                                            }
                                                            let _e1635 = phi_3143_;
                                                            let _e1641 = bitcast<f32>((bitcast<u32>((_e1608 * _e1618)) ^ _e239.member_3[0]));
                                                            let _e1645 = bitcast<f32>((bitcast<u32>((_e1611 * _e1616)) ^ _e239.member_3[0]));
                                                            let _e1649 = bitcast<f32>((bitcast<u32>((_e1611 * _e1620)) ^ _e239.member_3[0]));
                                                            let _e1653 = bitcast<f32>((bitcast<u32>((_e1614 * _e1618)) ^ _e239.member_3[0]));
                                                            let _e1657 = bitcast<f32>((bitcast<u32>((_e1614 * _e1616)) ^ _e239.member_3[0]));
                                                            let _e1661 = bitcast<f32>((bitcast<u32>((_e1608 * _e1620)) ^ _e239.member_3[0]));
                                                            let _e1662 = (_e1649 - _e1653);
                                                            let _e1663 = (_e1657 - _e1661);
                                                            let _e1664 = (_e1641 - _e1645);
                                                            let _e1688 = (bitcast<f32>((bitcast<u32>(_e1649) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1653) & 2147483647u)));
                                                            let _e1695 = (bitcast<f32>((bitcast<u32>(_e1657) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1661) & 2147483647u)));
                                                            let _e1702 = (bitcast<f32>((bitcast<u32>(_e1641) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1645) & 2147483647u)));
                                                            if (_e239.member_2 == 0f) {
                                                                phi_3325_ = 0f;
                                                            } else {
                                                                let _e1732 = bitcast<f32>((bitcast<u32>(_e1662) & 2147483647u));
                                                                let _e1735 = bitcast<f32>((bitcast<u32>(_e1663) & 2147483647u));
                                                                let _e1738 = bitcast<f32>((bitcast<u32>(_e1664) & 2147483647u));
                                                                let _e1740 = select(_e1738, _e1735, (_e1735 > _e1738));
                                                                let _e1744 = select(_e1738, _e1735, (_e1735 < _e1738));
                                                                let _e1748 = select(_e1735, _e1732, (_e1732 < _e1735));
                                                                let _e1750 = select(_e1735, _e1732, (_e1732 > _e1735));
                                                                let _e1752 = select(_e1738, _e1750, (_e1750 < _e1738));
                                                                phi_3325_ = bitcast<f32>((bitcast<u32>((_e239.member_2 * bitcast<f32>((bitcast<u32>(((((select(_e1740, _e1732, (_e1732 > _e1740)) + bitcast<f32>((bitcast<u32>((0.414214f * select(_e1752, _e1748, (_e1748 > _e1752)))) ^ _e239.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.317838f * select(_e1744, _e1732, (_e1732 < _e1744)))) ^ _e239.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.0000004768374f * ((_e1688 + _e1695) + _e1702))) ^ _e239.member_3[0]))) * 1.0000005f)) ^ _e239.member_3[0])))) ^ _e239.member_3[0]));
                                                            }
                                                            let _e1779 = phi_3325_;
                                                            phi_3343_ = (_e1581 || !(((((bitcast<f32>((bitcast<u32>((_e1635.x * _e1662)) ^ _e239.member_3[0])) + bitcast<f32>((bitcast<u32>((_e1635.y * _e1663)) ^ _e239.member_3[0]))) + bitcast<f32>((bitcast<u32>((_e1635.z * _e1664)) ^ _e239.member_3[0]))) * f32(-(_e1580))) > ((bitcast<f32>((bitcast<u32>((0.0000009536752f * ((bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1635.x) & 2147483647u)) * _e1688)) ^ _e239.member_3[0])) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1635.y) & 2147483647u)) * _e1695)) ^ _e239.member_3[0]))) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1635.z) & 2147483647u)) * _e1702)) ^ _e239.member_3[0]))))) ^ _e239.member_3[0])) + _e1779) + 0.0000000000000000000000000000000000001880791f))));
                                                        }
                                                        let _e1793 = phi_3343_;
                                                        phi_3344_ = _e1793;
                                                    }
                                                    let _e1795 = phi_3344_;
                                                    if _e1795 {
                                                        if (_e1567.member < _e1085.member.member) {
                                                            phi_3364_ = true;
                                                        } else {
                                                            if (_e1567.member == _e1085.member.member) {
                                                                phi_3363_ = (_e1567.member_3 < _e1085.member.member_3);
                                                            } else {
                                                                phi_3363_ = false;
                                                            }
                                                            let _e1805 = phi_3363_;
                                                            phi_3364_ = _e1805;
                                                        }
                                                        let _e1807 = phi_3364_;
                                                        if _e1807 {
                                                            phi_3370_ = type_38(_e1567, _e1567.member);
                                                        } else {
                                                            phi_3370_ = _e1085;
                                                        }
                                                        let _e1810 = phi_3370_;
                                                        phi_3371_ = _e1810;
                                                    } else {
                                                        phi_3371_ = _e1085;
                                                    }
                                                    let _e1812 = phi_3371_;
                                                    phi_3372_ = _e1812;
                                                } else {
                                                    phi_3372_ = _e1085;
                                                }
                                                let _e1814 = phi_3372_;
                                                phi_5124_ = _e1284;
                                                phi_2084_ = _e1814;
                                            } else {
                                                phi_5124_ = _e1083;
                                                phi_2084_ = type_38();
                                            }
                                            let _e1816 = phi_5124_;
                                            let _e1818 = phi_2084_;
                                            continue;
                                            continuing {
                                                phi_5061_ = _e1816;
                                                phi_2083_ = _e1818;
                                                phi_2086_ = _e1100;
                                                phi_5123_ = _e1816;
                                                break if !(_e1106);
                                            }
                                        }
                                        let _e1821 = phi_5123_;
                                        phi_5202_ = _e1821;
                                        if _e1821 {
                                            break;
                                        }
                                        phi_5206_ = _e1821;
                                        let _e2061 = local_8;
                                        phi_4710_ = _e2061;
                                        phi_4711_ = _e612;
                                        phi_4712_ = false;
                                        phi_4713_ = _e616;
                                    } else {
                                        if (_e612.member_1 >= _e99) {
                                            phi_4310_ = type_62(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), type_59(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u), type_59(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u));
                                        } else {
                                            if (_e612.member_1 < _e99) {
                                            } else {
                                                phi_5202_ = true;
                                                break;
                                            }
                                            let _e630 = ((1u + (_e361 * 2u)) % 7u);
                                            if (_e630 < 7u) {
                                            } else {
                                                phi_5202_ = true;
                                                break;
                                            }
                                            let _e635 = global_9.member[_e612.member_1][_e630];
                                            let _e638 = ((1u + (_e360 * 2u)) % 7u);
                                            if (_e638 < 7u) {
                                            } else {
                                                phi_5202_ = true;
                                                break;
                                            }
                                            let _e643 = global_9.member[_e612.member_1][_e638];
                                            let _e646 = ((1u + (_e362 * 2u)) % 7u);
                                            if (_e646 < 7u) {
                                            } else {
                                                phi_5202_ = true;
                                                break;
                                            }
                                            let _e651 = global_9.member[_e612.member_1][_e646];
                                            let _e654 = (((_e361 + 1u) * 2u) % 7u);
                                            if (_e654 < 7u) {
                                            } else {
                                                phi_5202_ = true;
                                                break;
                                            }
                                            let _e659 = global_9.member[_e612.member_1][_e654];
                                            let _e662 = (((_e360 + 1u) * 2u) % 7u);
                                            if (_e662 < 7u) {
                                            } else {
                                                phi_5202_ = true;
                                                break;
                                            }
                                            let _e667 = global_9.member[_e612.member_1][_e662];
                                            let _e670 = (((_e362 + 1u) * 2u) % 7u);
                                            if (_e670 < 7u) {
                                            } else {
                                                phi_5202_ = true;
                                                break;
                                            }
                                            let _e675 = global_9.member[_e612.member_1][_e670];
                                            let _e698 = (bitcast<f32>((bitcast<u32>((_e612.member.member_1.x - _e612.member.member.x)) & 2139095040u)) * 0.0000009536743f);
                                            let _e699 = (bitcast<f32>((bitcast<u32>((_e612.member.member_1.y - _e612.member.member.y)) & 2139095040u)) * 0.0000009536743f);
                                            let _e700 = (bitcast<f32>((bitcast<u32>((_e612.member.member_1.z - _e612.member.member.z)) & 2139095040u)) * 0.0000009536743f);
                                            let _e702 = select(_e158, _e698, (_e698 > _e158));
                                            let _e704 = select(_e158, _e699, (_e699 > _e158));
                                            let _e706 = select(_e158, _e700, (_e700 > _e158));
                                            let _e731 = bitcast<u32>((f32(bitcast<i32>((_e635 & 2097151u))) * _e702));
                                            let _e736 = (bitcast<i32>((_e635 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e739 = bitcast<f32>((_e731 & bitcast<u32>(_e736)));
                                            let _e740 = bitcast<u32>((f32(bitcast<i32>((_e643 & 2097151u))) * _e704));
                                            let _e745 = (bitcast<i32>((_e643 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e748 = bitcast<f32>((_e740 & bitcast<u32>(_e745)));
                                            let _e749 = bitcast<u32>((f32(bitcast<i32>((_e651 & 2097151u))) * _e706));
                                            let _e754 = (bitcast<i32>((_e651 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e757 = bitcast<f32>((_e749 & bitcast<u32>(_e754)));
                                            let _e761 = bitcast<f32>((_e731 & bitcast<u32>(~(_e736))));
                                            let _e765 = bitcast<f32>((_e740 & bitcast<u32>(~(_e745))));
                                            let _e769 = bitcast<f32>((_e749 & bitcast<u32>(~(_e754))));
                                            let _e770 = bitcast<u32>((f32(bitcast<i32>((_e659 & 2097151u))) * _e702));
                                            let _e775 = (bitcast<i32>((_e659 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e778 = bitcast<f32>((_e770 & bitcast<u32>(_e775)));
                                            let _e779 = bitcast<u32>((f32(bitcast<i32>((_e667 & 2097151u))) * _e704));
                                            let _e784 = (bitcast<i32>((_e667 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e787 = bitcast<f32>((_e779 & bitcast<u32>(_e784)));
                                            let _e788 = bitcast<u32>((f32(bitcast<i32>((_e675 & 2097151u))) * _e706));
                                            let _e793 = (bitcast<i32>((_e675 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e796 = bitcast<f32>((_e788 & bitcast<u32>(_e793)));
                                            let _e800 = bitcast<f32>((_e770 & bitcast<u32>(~(_e775))));
                                            let _e804 = bitcast<f32>((_e779 & bitcast<u32>(~(_e784))));
                                            let _e808 = bitcast<f32>((_e788 & bitcast<u32>(~(_e793))));
                                            let _e809 = (_e612.member.member.x + _e739);
                                            let _e810 = (_e612.member.member.y + _e748);
                                            let _e811 = (_e612.member.member.z + _e757);
                                            let _e814 = (_e612.member.member_1.x - _e778);
                                            let _e815 = (_e612.member.member_1.y - _e787);
                                            let _e816 = (_e612.member.member_1.z - _e796);
                                            let _e835 = (_e814 - _e809);
                                            let _e836 = (_e815 - _e810);
                                            let _e837 = (_e816 - _e811);
                                            let _e839 = select(_e836, _e835, (_e835 > _e836));
                                            let _e841 = select(_e837, _e839, (_e839 > _e837));
                                            if (_e841 < (1024f * _e158)) {
                                                phi_4011_ = 0u;
                                            } else {
                                                phi_4011_ = select(2u, 1u, (_e841 < (2097152f * _e158)));
                                            }
                                            let _e848 = phi_4011_;
                                            switch bitcast<i32>(_e848) {
                                                case 0: {
                                                    phi_4017_ = 1u;
                                                    break;
                                                }
                                                case 1: {
                                                    phi_4017_ = 2u;
                                                    break;
                                                }
                                                case 2: {
                                                    phi_4017_ = 3u;
                                                    break;
                                                }
                                                default: {
                                                    phi_4017_ = u32();
                                                    break;
                                                }
                                            }
                                            let _e851 = phi_4017_;
                                            let _e857 = global_9.member[_e612.member_1][0u];
                                            let _e861 = global_9.member[_e612.member_1][2u];
                                            let _e865 = global_9.member[_e612.member_1][4u];
                                            let _e869 = global_9.member[_e612.member_1][6u];
                                            let _e881 = (((_e861 >> bitcast<u32>(22i)) | ((_e865 >> bitcast<u32>(22i)) << bitcast<u32>(10i))) | ((_e869 >> bitcast<u32>(22i)) << bitcast<u32>(20i)));
                                            let _e882 = (_e857 & 268435455u);
                                            let _e883 = (_e881 & 268435455u);
                                            let _e886 = ((_e857 >> bitcast<u32>(28u)) & 7u);
                                            let _e894 = ((_e857 >> bitcast<u32>(31i)) | (((_e881 >> bitcast<u32>(28u)) & 3u) << bitcast<u32>(1i)));
                                            let _e895 = (_e886 != 0u);
                                            if (_e886 == 0u) {
                                                phi_4272_ = _e882;
                                            } else {
                                                if (_e886 == 7u) {
                                                    phi_4271_ = 2147483648u;
                                                } else {
                                                    phi_4271_ = ((2147483648u | (_e886 << bitcast<u32>(28u))) | (_e883 & 268435455u));
                                                }
                                                let _e904 = phi_4271_;
                                                phi_4272_ = _e904;
                                            }
                                            let _e906 = phi_4272_;
                                            if _e895 {
                                                let _e907 = (_e886 != 7u);
                                                if _e907 {
                                                    phi_4282_ = (_e883 + (_e886 * ((3u * _e851) + 1u)));
                                                } else {
                                                    phi_4282_ = u32();
                                                }
                                                let _e911 = phi_4282_;
                                                phi_4284_ = _e911;
                                                phi_4285_ = select(true, false, _e907);
                                            } else {
                                                phi_4284_ = u32();
                                                phi_4285_ = true;
                                            }
                                            let _e914 = phi_4284_;
                                            let _e916 = phi_4285_;
                                            if (_e894 == 0u) {
                                                phi_4306_ = (_e882 + select(0u, 1u, !(_e895)));
                                            } else {
                                                if (_e894 == 7u) {
                                                    phi_4305_ = 2147483648u;
                                                } else {
                                                    phi_4305_ = ((2147483648u | (_e894 << bitcast<u32>(28u))) | (select(_e914, _e883, _e916) & 268435455u));
                                                }
                                                let _e929 = phi_4305_;
                                                phi_4306_ = _e929;
                                            }
                                            let _e931 = phi_4306_;
                                            phi_4310_ = type_62(array<vec4<f32>, 3>(vec4<f32>(_e809, (_e612.member.member.x + _e761), _e814, (_e612.member.member_1.x - _e800)), vec4<f32>(_e810, (_e612.member.member.y + _e765), _e815, (_e612.member.member_1.y - _e804)), vec4<f32>(_e811, (_e612.member.member.z + _e769), _e816, (_e612.member.member_1.z - _e808))), type_59(type_33((_e612.member.member + vec4<f32>(_e739, _e748, _e757, 0f)), (_e612.member.member_1 - vec4<f32>(_e778, _e787, _e796, 0f))), _e906), type_59(type_33((_e612.member.member + vec4<f32>(_e761, _e765, _e769, 0f)), (_e612.member.member_1 - vec4<f32>(_e800, _e804, _e808, 0f))), _e931));
                                        }
                                        let _e936 = phi_4310_;
                                        let _e948 = ((_e936.member[0].x - _e416) * _e421);
                                        let _e949 = ((_e936.member[0].y - _e416) * _e421);
                                        let _e950 = ((_e936.member[0].z - _e417) * _e421);
                                        let _e951 = ((_e936.member[0].w - _e417) * _e421);
                                        let _e961 = ((_e936.member[1].x - _e452) * _e457);
                                        let _e962 = ((_e936.member[1].y - _e452) * _e457);
                                        let _e963 = ((_e936.member[1].z - _e453) * _e457);
                                        let _e964 = ((_e936.member[1].w - _e453) * _e457);
                                        let _e974 = ((_e936.member[2].x - _e488) * _e493);
                                        let _e975 = ((_e936.member[2].y - _e488) * _e493);
                                        let _e976 = ((_e936.member[2].z - _e489) * _e493);
                                        let _e977 = ((_e936.member[2].w - _e489) * _e493);
                                        let _e979 = select(_e976, _e974, (_e974 < _e976));
                                        let _e981 = select(_e977, _e975, (_e975 < _e977));
                                        let _e983 = select(_e976, _e974, (_e974 > _e976));
                                        let _e985 = select(_e977, _e975, (_e975 > _e977));
                                        let _e987 = select(_e950, _e948, (_e948 < _e950));
                                        let _e989 = select(_e951, _e949, (_e949 < _e951));
                                        let _e991 = select(_e963, _e961, (_e961 < _e963));
                                        let _e993 = select(_e964, _e962, (_e962 < _e964));
                                        let _e995 = select(_e991, _e987, (_e987 > _e991));
                                        let _e997 = select(_e993, _e989, (_e989 > _e993));
                                        let _e999 = select(_e979, _e995, (_e995 > _e979));
                                        let _e1001 = select(_e981, _e997, (_e997 > _e981));
                                        let _e1003 = select(_e950, _e948, (_e948 > _e950));
                                        let _e1005 = select(_e951, _e949, (_e949 > _e951));
                                        let _e1007 = select(_e963, _e961, (_e961 > _e963));
                                        let _e1009 = select(_e964, _e962, (_e962 > _e964));
                                        let _e1011 = select(_e1007, _e1003, (_e1003 < _e1007));
                                        let _e1013 = select(_e1009, _e1005, (_e1005 < _e1009));
                                        let _e1018 = -(_e979);
                                        let _e1019 = -(_e981);
                                        let _e1026 = (select(_e983, _e1011, (_e1011 < _e983)) + (select(_e1018, _e983, (_e983 > _e1018)) * 0.0000019073523f));
                                        let _e1027 = (select(_e985, _e1013, (_e1013 < _e985)) + (select(_e1019, _e985, (_e985 > _e1019)) * 0.0000019073523f));
                                        let _e1029 = select(_e539, _e999, (_e999 > _e539));
                                        let _e1031 = select(_e539, _e1001, (_e1001 > _e539));
                                        let _e1036 = (_e1029 <= select(_e583.member_1, _e1026, (_e1026 < _e583.member_1)));
                                        let _e1037 = (_e1031 <= select(_e583.member_1, _e1027, (_e1027 < _e583.member_1)));
                                        let _e1038 = (_e1029 <= _e1031);
                                        if _e1036 {
                                            if _e1037 {
                                                if _e1038 {
                                                    phi_4654_ = _e936.member_2;
                                                } else {
                                                    phi_4654_ = _e936.member_1;
                                                }
                                                let _e1042 = phi_4654_;
                                                let _e1043 = (_e616 % 128u);
                                                let _e1044 = (_e1043 < 128u);
                                                if _e1044 {
                                                } else {
                                                    phi_5202_ = true;
                                                    break;
                                                }
                                                local_3[_e1043] = type_59(type_33(_e1042.member.member, _e1042.member.member_1), _e1042.member_1);
                                                if _e1044 {
                                                } else {
                                                    phi_5202_ = true;
                                                    break;
                                                }
                                                local_2[_e1043] = select(_e1031, _e1029, (_e1029 > _e1031));
                                                if _e1038 {
                                                    phi_4687_ = _e936.member_1;
                                                } else {
                                                    phi_4687_ = _e936.member_2;
                                                }
                                                let _e1059 = phi_4687_;
                                                phi_4688_ = _e1059;
                                                phi_4689_ = (_e616 + 1u);
                                            } else {
                                                phi_4688_ = type_59();
                                                phi_4689_ = u32();
                                            }
                                            let _e1061 = phi_4688_;
                                            let _e1063 = phi_4689_;
                                            phi_4691_ = _e1061;
                                            phi_4692_ = _e1063;
                                            phi_4693_ = select(true, false, _e1037);
                                        } else {
                                            phi_4691_ = type_59();
                                            phi_4692_ = u32();
                                            phi_4693_ = true;
                                        }
                                        let _e1066 = phi_4691_;
                                        let _e1068 = phi_4692_;
                                        let _e1070 = phi_4693_;
                                        if _e1070 {
                                            if _e1036 {
                                                phi_4702_ = _e936.member_1;
                                            } else {
                                                phi_4702_ = _e936.member_2;
                                            }
                                            let _e1074 = phi_4702_;
                                            phi_4707_ = _e1074;
                                            phi_4708_ = select(_e1037, true, _e1036);
                                        } else {
                                            phi_4707_ = _e1066;
                                            phi_4708_ = _e614;
                                        }
                                        let _e1077 = phi_4707_;
                                        let _e1079 = phi_4708_;
                                        phi_5206_ = _e581;
                                        phi_4710_ = _e583;
                                        phi_4711_ = _e1077;
                                        phi_4712_ = _e1079;
                                        phi_4713_ = select(_e1068, _e616, _e1070);
                                    }
                                    let _e1823 = phi_5206_;
                                    let _e1825 = phi_4710_;
                                    let _e1827 = phi_4711_;
                                    let _e1829 = phi_4712_;
                                    let _e1831 = phi_4713_;
                                    phi_5205_ = _e1823;
                                    phi_4714_ = _e1825;
                                    phi_4715_ = _e1827;
                                    phi_4716_ = (_e587 - 1u);
                                    phi_4717_ = _e1829;
                                    phi_4718_ = _e1831;
                                } else {
                                    phi_5205_ = _e581;
                                    phi_4714_ = _e583;
                                    phi_4715_ = _e612;
                                    phi_4716_ = _e587;
                                    phi_4717_ = _e614;
                                    phi_4718_ = _e616;
                                }
                                let _e1833 = phi_5205_;
                                let _e1835 = phi_4714_;
                                let _e1837 = phi_4715_;
                                let _e1839 = phi_4716_;
                                let _e1841 = phi_4717_;
                                let _e1843 = phi_4718_;
                                phi_5204_ = _e1833;
                                phi_4719_ = _e1835;
                                phi_4720_ = _e1837;
                                phi_4721_ = _e1839;
                                phi_4722_ = _e1841;
                                phi_4723_ = _e1843;
                            } else {
                                phi_5204_ = _e581;
                                phi_4719_ = type_38();
                                phi_4720_ = type_59();
                                phi_4721_ = u32();
                                phi_4722_ = bool();
                                phi_4723_ = u32();
                            }
                            let _e1845 = phi_5204_;
                            let _e1847 = phi_4719_;
                            let _e1849 = phi_4720_;
                            let _e1851 = phi_4721_;
                            let _e1853 = phi_4722_;
                            let _e1855 = phi_4723_;
                            phi_5203_ = _e1845;
                            phi_2006_ = _e1847;
                            phi_2009_ = _e1849;
                            phi_2011_ = _e1851;
                            phi_2013_ = _e1853;
                            phi_2015_ = _e1855;
                            phi_4724_ = _e595;
                        } else {
                            phi_5203_ = _e581;
                            phi_2006_ = type_38();
                            phi_2009_ = type_59();
                            phi_2011_ = u32();
                            phi_2013_ = bool();
                            phi_2015_ = u32();
                            phi_4724_ = false;
                        }
                        let _e1857 = phi_5203_;
                        let _e1859 = phi_2006_;
                        let _e1861 = phi_2009_;
                        let _e1863 = phi_2011_;
                        let _e1865 = phi_2013_;
                        let _e1867 = phi_2015_;
                        let _e1869 = phi_4724_;
                        continue;
                        continuing {
                            phi_5064_ = _e1857;
                            phi_2005_ = _e1859;
                            phi_2008_ = _e1861;
                            phi_2010_ = _e1863;
                            phi_2012_ = _e1865;
                            phi_2014_ = _e1867;
                            phi_5202_ = _e1857;
                            break if !(_e1869);
                        }
                    }
                    let _e1872 = phi_5202_;
                    if _e1872 {
                        break;
                    }
                    let _e1874 = local_7;
                    if (_e1874.member.member_3 != 4294967295u) {
                        let _e1879 = (_e363 / 3i);
                        let _e1886 = bitcast<f32>((bitcast<u32>((_e1879 + 127i)) << bitcast<u32>(23i)));
                        let _e1894 = (((_e1874.member.member * _e1886) * _e1886) * bitcast<f32>((bitcast<u32>(((_e363 - (2i * _e1879)) + 127i)) << bitcast<u32>(23i))));
                        let _e1896 = select(340282350000000000000000000000000000000f, _e1894, (_e1894 < 340282350000000000000000000000000000000f));
                        phi_4776_ = type_21(select(-340282350000000000000000000000000000000f, _e1896, (_e1896 > -340282350000000000000000000000000000000f)), _e1874.member.member_1, _e1874.member.member_2, _e1874.member.member_3);
                    } else {
                        phi_4776_ = type_21(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                    }
                    let _e1903 = phi_4776_;
                    if _e240 {
                    } else {
                        break;
                    }
                    global_7.member[_e146] = _e1903;
                    if _e161 {
                    } else {
                        break;
                    }
                    let _e1907 = select(0u, 1u, (_e307 <= _e317));
                    if (_e1907 > 0u) {
                        let _e1909 = (1u < _e114);
                        if _e1909 {
                            if (0u < _e114) {
                            } else {
                                break;
                            }
                            let _e1913 = atomicAdd((&global_8.member[0u]), _e1907);
                            if ((_e1913 + _e1907) < _e1913) {
                                if _e1909 {
                                } else {
                                    break;
                                }
                                let _e1918 = atomicAdd((&global_8.member[1u]), 1u);
                            }
                        }
                    }
                    let _e1921 = select(0u, 1u, (_e1903.member_3 != 4294967295u));
                    if (_e1921 > 0u) {
                        let _e1923 = (3u < _e114);
                        if _e1923 {
                            if (2u < _e114) {
                            } else {
                                break;
                            }
                            let _e1927 = atomicAdd((&global_8.member[2u]), _e1921);
                            if ((_e1927 + _e1921) < _e1927) {
                                if _e1923 {
                                } else {
                                    break;
                                }
                                let _e1932 = atomicAdd((&global_8.member[3u]), 1u);
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
fn trace_paths_q21_lattice(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
