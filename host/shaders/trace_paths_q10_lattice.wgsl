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

struct type_25 {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: u32,
}

struct type_27 {
    member: array<type_25>,
}

struct type_29 {
    member: array<f32, 3>,
    member_1: f32,
    member_2: array<f32, 3>,
    member_3: f32,
}

struct type_30 {
    member: type_29,
    member_1: array<f32, 3>,
    member_2: u32,
    member_3: array<f32, 3>,
    member_4: u32,
}

struct type_32 {
    member: array<type_30>,
}

struct type_37 {
    member: vec4<f32>,
    member_1: vec4<f32>,
}

struct type_40 {
    member: array<f32, 3>,
    member_1: u32,
    member_2: f32,
    member_3: array<u32, 3>,
}

struct type_42 {
    member: type_25,
    member_1: f32,
}

struct type_46 {
    member: array<vec4<u32>, 2>,
}

struct type_49 {
    member: array<i32>,
}

struct type_59 {
    member: type_37,
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
var<uniform> global_1: type_16;
@group(0) @binding(1) 
var<uniform> global_2: type_46;
@group(0) @binding(2) 
var<uniform> global_3: type_46;
@group(0) @binding(3) 
var<storage> global_4: type_13;
@group(0) @binding(5) 
var<storage> global_5: type_4;
@group(0) @binding(6) 
var<storage> global_6: type_49;
@group(0) @binding(7) 
var<storage> global_7: type_32;
@group(0) @binding(8) 
var<storage, read_write> global_8: type_27;
@group(0) @binding(9) 
var<storage, read_write> global_9: type_69;
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
    var phi_340_: u32;
    var phi_405_: type_40;
    var phi_511_: i32;
    var phi_512_: i32;
    var phi_522_: bool;
    var phi_532_: u32;
    var phi_533_: u32;
    var phi_535_: bool;
    var phi_540_: u32;
    var phi_585_: f32;
    var phi_591_: f32;
    var phi_602_: f32;
    var phi_608_: f32;
    var phi_631_: f32;
    var phi_642_: f32;
    var phi_651_: f32;
    var phi_657_: f32;
    var phi_668_: f32;
    var phi_674_: f32;
    var phi_697_: f32;
    var phi_708_: f32;
    var phi_717_: f32;
    var phi_723_: f32;
    var phi_734_: f32;
    var phi_740_: f32;
    var phi_763_: f32;
    var phi_774_: f32;
    var phi_874_: f32;
    var phi_875_: f32;
    var phi_5054_: bool;
    var phi_1995_: type_42;
    var phi_1998_: type_59;
    var phi_2000_: u32;
    var phi_2002_: bool;
    var phi_2004_: u32;
    var phi_2015_: bool;
    var phi_2052_: type_59;
    var phi_2053_: bool;
    var phi_2054_: u32;
    var phi_4001_: u32;
    var phi_4007_: u32;
    var phi_4261_: u32;
    var phi_4262_: u32;
    var phi_4272_: u32;
    var phi_4274_: u32;
    var phi_4275_: bool;
    var phi_4295_: u32;
    var phi_4296_: u32;
    var phi_4300_: type_62;
    var phi_4644_: type_59;
    var phi_4677_: type_59;
    var phi_4678_: type_59;
    var phi_4679_: u32;
    var phi_4681_: type_59;
    var phi_4682_: u32;
    var phi_4683_: bool;
    var phi_4692_: type_59;
    var phi_4697_: type_59;
    var phi_4698_: bool;
    var phi_5051_: bool;
    var phi_2073_: type_42;
    var phi_2076_: type_8;
    var phi_2077_: type_8;
    var phi_2099_: type_8;
    var phi_2140_: u32;
    var phi_2146_: u32;
    var phi_2156_: u32;
    var phi_2172_: u32;
    var phi_2209_: u32;
    var phi_2215_: u32;
    var phi_2225_: u32;
    var phi_5036_: bool;
    var phi_2241_: type_8;
    var phi_2242_: type_8;
    var phi_2265_: type_8;
    var phi_2288_: u32;
    var phi_2303_: u32;
    var phi_2306_: type_8;
    var phi_2307_: type_8;
    var phi_2330_: type_8;
    var phi_2396_: u32;
    var phi_2376_: u32;
    var phi_2377_: u32;
    var phi_2400_: f32;
    var phi_5029_: bool;
    var phi_5106_: bool;
    var phi_5105_: bool;
    var phi_2900_: vec3<f32>;
    var phi_2901_: vec3<f32>;
    var phi_2932_: bool;
    var phi_2941_: vec3<f32>;
    var phi_2981_: type_25;
    var phi_2983_: type_25;
    var phi_2984_: bool;
    var phi_2988_: type_25;
    var phi_2989_: type_25;
    var phi_2990_: type_25;
    var phi_2991_: bool;
    var phi_2995_: type_25;
    var phi_2996_: bool;
    var phi_3000_: type_25;
    var phi_3001_: bool;
    var phi_3005_: type_25;
    var phi_3028_: u32;
    var phi_3042_: i32;
    var phi_3062_: vec3<f32>;
    var phi_3063_: vec3<f32>;
    var phi_3079_: vec3<f32>;
    var phi_3080_: vec3<f32>;
    var phi_3096_: vec3<f32>;
    var phi_3097_: vec3<f32>;
    var phi_3133_: vec3<f32>;
    var phi_3315_: f32;
    var phi_3333_: bool;
    var phi_3334_: bool;
    var phi_3353_: bool;
    var phi_3354_: bool;
    var phi_3360_: type_42;
    var phi_3361_: type_42;
    var phi_3362_: type_42;
    var phi_5108_: bool;
    var phi_2074_: type_42;
    var phi_5107_: bool;
    var phi_5190_: bool;
    var phi_4700_: type_42;
    var phi_4701_: type_59;
    var phi_4702_: bool;
    var phi_4703_: u32;
    var phi_5189_: bool;
    var phi_4704_: type_42;
    var phi_4705_: type_59;
    var phi_4706_: u32;
    var phi_4707_: bool;
    var phi_4708_: u32;
    var phi_5188_: bool;
    var phi_4709_: type_42;
    var phi_4710_: type_59;
    var phi_4711_: u32;
    var phi_4712_: bool;
    var phi_4713_: u32;
    var phi_5187_: bool;
    var phi_1996_: type_42;
    var phi_1999_: type_59;
    var phi_2001_: u32;
    var phi_2003_: bool;
    var phi_2005_: u32;
    var phi_4714_: bool;
    var phi_5186_: bool;
    var local_7: type_42;
    var phi_4766_: type_25;
    var local_8: type_42;

    switch bitcast<i32>(0u) {
        default: {
            let _e97 = global;
            let _e99 = arrayLength((&global_4.member));
            let _e102 = arrayLength((&global_10.member));
            let _e114 = arrayLength((&global_9.member));
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
            let _e161 = (_e146 < arrayLength((&global_7.member)));
            if _e161 {
                if _e161 {
                } else {
                    break;
                }
                let _e165 = global_7.member[_e146].member_2;
                phi_340_ = _e165;
            } else {
                phi_340_ = 4294967295u;
            }
            let _e167 = phi_340_;
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
            let _e211 = (_e210 / 2i);
            let _e216 = bitcast<f32>((bitcast<u32>((_e211 + 127i)) << bitcast<u32>(23i)));
            let _e222 = bitcast<f32>((bitcast<u32>(((_e210 - _e211) + 127i)) << bitcast<u32>(23i)));
            if (_e186 == 0u) {
                phi_405_ = type_40(array<f32, 3>(_e203, _e204, _e205), _e186, _e207, _e208);
            } else {
                phi_405_ = type_40(array<f32, 3>(((_e203 * _e216) * _e222), ((_e204 * _e216) * _e222), ((_e205 * _e216) * _e222)), _e186, ((_e207 * _e216) * _e222), _e208);
            }
            let _e235 = phi_405_;
            if _e161 {
                let _e236 = (_e146 < arrayLength((&global_8.member)));
                if _e236 {
                    if _e161 {
                    } else {
                        break;
                    }
                    let _e246 = global_7.member[_e146].member.member_2[0u];
                    let _e248 = (bitcast<u32>(_e246) & 2147483647u);
                    let _e254 = global_7.member[_e146].member.member_2[1u];
                    let _e256 = (bitcast<u32>(_e254) & 2147483647u);
                    let _e262 = global_7.member[_e146].member.member_2[2u];
                    let _e264 = (bitcast<u32>(_e262) & 2147483647u);
                    let _e270 = global_7.member[_e146].member.member[0u];
                    let _e272 = (bitcast<u32>(_e270) & 2147483647u);
                    let _e278 = global_7.member[_e146].member.member[1u];
                    let _e280 = (bitcast<u32>(_e278) & 2147483647u);
                    let _e286 = global_7.member[_e146].member.member[2u];
                    let _e288 = (bitcast<u32>(_e286) & 2147483647u);
                    let _e290 = select(_e256, _e248, (_e256 < _e248));
                    let _e292 = select(_e264, _e290, (_e264 < _e290));
                    let _e294 = select(_e272, _e292, (_e272 < _e292));
                    let _e296 = select(_e280, _e294, (_e280 < _e294));
                    let _e298 = select(_e288, _e296, (_e288 < _e296));
                    let _e303 = global_7.member[_e146].member.member_1;
                    let _e305 = (bitcast<u32>(_e303) & 2147483647u);
                    let _e313 = global_7.member[_e146].member.member_3;
                    let _e319 = (((select(_e305, _e298, (_e305 < _e298)) < 2139095040u) && ((bitcast<u32>(_e313) & 2147483647u) <= 2139095040u)) && (_e292 > 0u));
                    if _e319 {
                        let _e322 = (bitcast<u32>(bitcast<f32>(_e292)) & 2147483647u);
                        if (_e322 >= 8388608u) {
                            phi_511_ = (bitcast<i32>((_e322 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_511_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e322)), 32u, (_e322 == 0u))));
                        }
                        let _e336 = phi_511_;
                        phi_512_ = _e336;
                    } else {
                        phi_512_ = 0i;
                    }
                    let _e338 = phi_512_;
                    let _e339 = (_e248 == _e292);
                    if _e339 {
                        phi_522_ = true;
                    } else {
                        phi_522_ = (_e256 == _e292);
                    }
                    let _e342 = phi_522_;
                    let _e343 = select(1u, 0u, _e339);
                    if _e342 {
                        let _e344 = (_e343 + 1u);
                        phi_532_ = _e344;
                        phi_533_ = _e344;
                        phi_535_ = select(true, false, (_e344 == 2u));
                    } else {
                        phi_532_ = u32();
                        phi_533_ = 0u;
                        phi_535_ = true;
                    }
                    let _e348 = phi_532_;
                    let _e350 = phi_533_;
                    let _e352 = phi_535_;
                    if _e352 {
                        phi_540_ = (_e350 + 1u);
                    } else {
                        phi_540_ = 0u;
                    }
                    let _e356 = phi_540_;
                    let _e357 = select(_e348, _e350, _e352);
                    let _e358 = select(_e343, select(2u, _e343, _e342), _e352);
                    let _e359 = -(_e338);
                    let _e360 = (_e359 / 2i);
                    let _e365 = bitcast<f32>((bitcast<u32>((_e360 + 127i)) << bitcast<u32>(23i)));
                    let _e371 = bitcast<f32>((bitcast<u32>(((_e359 - _e360) + 127i)) << bitcast<u32>(23i)));
                    let _e376 = global_7.member[_e146].member.member;
                    let _e377 = (_e357 == 0u);
                    if _e377 {
                        phi_585_ = _e376[0];
                    } else {
                        phi_585_ = _e376[1];
                    }
                    let _e381 = phi_585_;
                    let _e382 = (_e357 == 2u);
                    if _e382 {
                        phi_591_ = _e376[2];
                    } else {
                        phi_591_ = _e381;
                    }
                    let _e385 = phi_591_;
                    let _e386 = global_7.member[_e146].member.member_2;
                    if _e377 {
                        phi_602_ = _e386[0];
                    } else {
                        phi_602_ = _e386[1];
                    }
                    let _e390 = phi_602_;
                    if _e382 {
                        phi_608_ = _e386[2];
                    } else {
                        phi_608_ = _e390;
                    }
                    let _e393 = phi_608_;
                    let _e395 = ((_e393 * _e365) * _e371);
                    let _e399 = (bitcast<f32>((bitcast<u32>(_e395) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e399 {
                        let _e403 = (bitcast<f32>((bitcast<u32>(_e385) & 2147483647u)) * 0.00000011920929f);
                        phi_631_ = select(0.00000000000011368684f, _e403, (_e403 > 0.00000000000011368684f));
                    } else {
                        phi_631_ = 0f;
                    }
                    let _e407 = phi_631_;
                    let _e408 = (_e385 + _e407);
                    let _e409 = (_e385 - _e407);
                    let _e410 = select(_e395, 0f, _e399);
                    if _e399 {
                        phi_642_ = 38685626000000000000000000f;
                    } else {
                        phi_642_ = (1f / _e395);
                    }
                    let _e413 = phi_642_;
                    let _e414 = (_e356 == 0u);
                    if _e414 {
                        phi_651_ = _e376[0];
                    } else {
                        phi_651_ = _e376[1];
                    }
                    let _e418 = phi_651_;
                    let _e419 = (_e356 == 2u);
                    if _e419 {
                        phi_657_ = _e376[2];
                    } else {
                        phi_657_ = _e418;
                    }
                    let _e422 = phi_657_;
                    if _e414 {
                        phi_668_ = _e386[0];
                    } else {
                        phi_668_ = _e386[1];
                    }
                    let _e426 = phi_668_;
                    if _e419 {
                        phi_674_ = _e386[2];
                    } else {
                        phi_674_ = _e426;
                    }
                    let _e429 = phi_674_;
                    let _e431 = ((_e429 * _e365) * _e371);
                    let _e435 = (bitcast<f32>((bitcast<u32>(_e431) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e435 {
                        let _e439 = (bitcast<f32>((bitcast<u32>(_e422) & 2147483647u)) * 0.00000011920929f);
                        phi_697_ = select(0.00000000000011368684f, _e439, (_e439 > 0.00000000000011368684f));
                    } else {
                        phi_697_ = 0f;
                    }
                    let _e443 = phi_697_;
                    let _e444 = (_e422 + _e443);
                    let _e445 = (_e422 - _e443);
                    let _e446 = select(_e431, 0f, _e435);
                    if _e435 {
                        phi_708_ = 38685626000000000000000000f;
                    } else {
                        phi_708_ = (1f / _e431);
                    }
                    let _e449 = phi_708_;
                    let _e450 = (_e358 == 0u);
                    if _e450 {
                        phi_717_ = _e376[0];
                    } else {
                        phi_717_ = _e376[1];
                    }
                    let _e454 = phi_717_;
                    let _e455 = (_e358 == 2u);
                    if _e455 {
                        phi_723_ = _e376[2];
                    } else {
                        phi_723_ = _e454;
                    }
                    let _e458 = phi_723_;
                    if _e450 {
                        phi_734_ = _e386[0];
                    } else {
                        phi_734_ = _e386[1];
                    }
                    let _e462 = phi_734_;
                    if _e455 {
                        phi_740_ = _e386[2];
                    } else {
                        phi_740_ = _e462;
                    }
                    let _e465 = phi_740_;
                    let _e467 = ((_e465 * _e365) * _e371);
                    let _e471 = (bitcast<f32>((bitcast<u32>(_e467) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e471 {
                        let _e475 = (bitcast<f32>((bitcast<u32>(_e458) & 2147483647u)) * 0.00000011920929f);
                        phi_763_ = select(0.00000000000011368684f, _e475, (_e475 > 0.00000000000011368684f));
                    } else {
                        phi_763_ = 0f;
                    }
                    let _e479 = phi_763_;
                    let _e480 = (_e458 + _e479);
                    let _e481 = (_e458 - _e479);
                    let _e482 = select(_e467, 0f, _e471);
                    if _e471 {
                        phi_774_ = 38685626000000000000000000f;
                    } else {
                        phi_774_ = (1f / _e467);
                    }
                    let _e485 = phi_774_;
                    let _e488 = bitcast<f32>((bitcast<u32>(_e385) & 2147483647u));
                    let _e491 = bitcast<f32>((bitcast<u32>(_e422) & 2147483647u));
                    let _e493 = select(_e491, _e488, (_e488 > _e491));
                    let _e496 = bitcast<f32>((bitcast<u32>(_e458) & 2147483647u));
                    if (_e319 && (select(_e496, _e493, (_e493 > _e496)) <= 1099511600000f)) {
                        let _e501 = (_e338 / 3i);
                        let _e508 = bitcast<f32>((bitcast<u32>((_e501 + 127i)) << bitcast<u32>(23i)));
                        let _e515 = bitcast<f32>((bitcast<u32>(((_e338 - (2i * _e501)) + 127i)) << bitcast<u32>(23i)));
                        let _e516 = (((_e303 * _e508) * _e508) * _e515);
                        let _e518 = select(340282350000000000000000000000000000000f, _e516, (_e516 < 340282350000000000000000000000000000000f));
                        let _e523 = (((_e313 * _e508) * _e508) * _e515);
                        let _e525 = select(340282350000000000000000000000000000000f, _e523, (_e523 < 340282350000000000000000000000000000000f));
                        phi_874_ = select(-340282350000000000000000000000000000000f, _e525, (_e525 > -340282350000000000000000000000000000000f));
                        phi_875_ = select(-340282350000000000000000000000000000000f, _e518, (_e518 > -340282350000000000000000000000000000000f));
                    } else {
                        phi_874_ = 0f;
                        phi_875_ = 1f;
                    }
                    let _e529 = phi_874_;
                    let _e531 = phi_875_;
                    local_3 = array<type_59, 128>(type_59(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u));
                    local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    let _e535 = (_e357 % 3u);
                    let _e536 = (_e535 < 3u);
                    if _e536 {
                    } else {
                        break;
                    }
                    let _e538 = local_1[_e535];
                    let _e541 = (_e356 % 3u);
                    let _e542 = (_e541 < 3u);
                    if _e542 {
                    } else {
                        break;
                    }
                    let _e544 = local_1[_e541];
                    let _e547 = (_e358 % 3u);
                    let _e548 = (_e547 < 3u);
                    if _e548 {
                    } else {
                        break;
                    }
                    let _e550 = local_1[_e547];
                    if _e536 {
                    } else {
                        break;
                    }
                    let _e555 = local[_e535];
                    if _e542 {
                    } else {
                        break;
                    }
                    let _e559 = local[_e541];
                    if _e548 {
                    } else {
                        break;
                    }
                    let _e563 = local[_e547];
                    phi_5054_ = false;
                    phi_1995_ = type_42(type_25(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e529);
                    phi_1998_ = type_59(type_37(vec4<f32>((f32(_e538) * _e158), (f32(_e544) * _e158), (f32(_e550) * _e158), 0f), vec4<f32>((f32(_e555) * _e158), (f32(_e559) * _e158), (f32(_e563) * _e158), 0f)), select(0u, 2147483648u, (_e99 == 0u)));
                    phi_2000_ = ((3u * _e99) + 1u);
                    phi_2002_ = (_e531 <= _e529);
                    phi_2004_ = 0u;
                    loop {
                        let _e573 = phi_5054_;
                        let _e575 = phi_1995_;
                        let _e577 = phi_1998_;
                        let _e579 = phi_2000_;
                        let _e581 = phi_2002_;
                        let _e583 = phi_2004_;
                        local_7 = _e575;
                        if _e581 {
                            phi_2015_ = true;
                        } else {
                            phi_2015_ = (_e583 > 0u);
                        }
                        let _e586 = phi_2015_;
                        if _e586 {
                            let _e587 = (_e579 > 0u);
                            if _e587 {
                                if _e581 {
                                    phi_2052_ = _e577;
                                    phi_2053_ = _e581;
                                    phi_2054_ = _e583;
                                } else {
                                    let _e588 = (_e583 - 1u);
                                    let _e589 = (_e588 % 128u);
                                    let _e590 = (_e589 < 128u);
                                    if _e590 {
                                    } else {
                                        phi_5186_ = true;
                                        break;
                                    }
                                    let _e592 = local_3[_e589];
                                    if _e590 {
                                    } else {
                                        phi_5186_ = true;
                                        break;
                                    }
                                    let _e600 = local_2[_e589];
                                    phi_2052_ = type_59(type_37(_e592.member.member, _e592.member.member_1), _e592.member_1);
                                    phi_2053_ = (_e600 <= _e575.member_1);
                                    phi_2054_ = _e588;
                                }
                                let _e604 = phi_2052_;
                                let _e606 = phi_2053_;
                                let _e608 = phi_2054_;
                                if _e606 {
                                    let _e613 = (_e604.member_1 & 268435455u);
                                    if ((_e604.member_1 & 2147483648u) != 0u) {
                                        phi_5051_ = _e573;
                                        phi_2073_ = _e575;
                                        phi_2076_ = type_8(0u, ((_e604.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e1075 = phi_5051_;
                                            let _e1077 = phi_2073_;
                                            let _e1079 = phi_2076_;
                                            local_8 = _e1077;
                                            if (_e1079.member < _e1079.member_1) {
                                                phi_2077_ = type_8((_e1079.member + 1u), _e1079.member_1);
                                                phi_2099_ = type_8(1u, _e1079.member);
                                            } else {
                                                phi_2077_ = _e1079;
                                                phi_2099_ = type_8(0u, type_8().member_1);
                                            }
                                            let _e1092 = phi_2077_;
                                            let _e1094 = phi_2099_;
                                            let _e1098 = (bitcast<i32>(_e1094.member) != 0i);
                                            if _e1098 {
                                                let _e1103 = (_e604.member.member_1.x - _e604.member.member.x);
                                                let _e1106 = (_e604.member.member_1.y - _e604.member.member.y);
                                                let _e1109 = (_e604.member.member_1.z - _e604.member.member.z);
                                                let _e1111 = select(_e1106, _e1103, (_e1103 > _e1106));
                                                let _e1113 = select(_e1109, _e1111, (_e1111 > _e1109));
                                                let _e1115 = (_e1113 < (1024f * _e158));
                                                if _e1115 {
                                                    phi_2140_ = 0u;
                                                } else {
                                                    phi_2140_ = select(2u, 1u, (_e1113 < (2097152f * _e158)));
                                                }
                                                let _e1120 = phi_2140_;
                                                switch bitcast<i32>(_e1120) {
                                                    case 0: {
                                                        phi_2146_ = 1u;
                                                        break;
                                                    }
                                                    case 1: {
                                                        phi_2146_ = 2u;
                                                        break;
                                                    }
                                                    case 2: {
                                                        phi_2146_ = 3u;
                                                        break;
                                                    }
                                                    default: {
                                                        phi_2146_ = u32();
                                                        break;
                                                    }
                                                }
                                                let _e1123 = phi_2146_;
                                                switch bitcast<i32>(_e1120) {
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
                                                let _e1130 = phi_2156_;
                                                let _e1132 = ((_e613 + (_e1094.member_1 * ((3u * _e1123) + 1u))) + (3u * _e1130));
                                                let _e1133 = (_e1132 < _e102);
                                                if _e1133 {
                                                    if _e1133 {
                                                    } else {
                                                        phi_5107_ = true;
                                                        break;
                                                    }
                                                    let _e1135 = global_10.member[_e1132];
                                                    phi_2172_ = _e1135;
                                                } else {
                                                    phi_2172_ = 4294967295u;
                                                }
                                                let _e1137 = phi_2172_;
                                                local_4 = array<u32, 3>(_e357, _e356, _e358);
                                                if _e1115 {
                                                    phi_2209_ = 0u;
                                                } else {
                                                    phi_2209_ = select(2u, 1u, (_e1113 < (2097152f * _e158)));
                                                }
                                                let _e1143 = phi_2209_;
                                                switch bitcast<i32>(_e1143) {
                                                    case 0: {
                                                        phi_2215_ = 1u;
                                                        break;
                                                    }
                                                    case 1: {
                                                        phi_2215_ = 2u;
                                                        break;
                                                    }
                                                    case 2: {
                                                        phi_2215_ = 3u;
                                                        break;
                                                    }
                                                    default: {
                                                        phi_2215_ = u32();
                                                        break;
                                                    }
                                                }
                                                let _e1146 = phi_2215_;
                                                switch bitcast<i32>(_e1143) {
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
                                                let _e1153 = phi_2225_;
                                                local_6 = array<f32, 4>(_e604.member.member.x, _e604.member.member.y, _e604.member.member.z, _e604.member.member.w);
                                                local_5[0u] = array<f32, 3>(0f, 0f, 0f);
                                                local_5[1u] = array<f32, 3>(0f, 0f, 0f);
                                                local_5[2u] = array<f32, 3>(0f, 0f, 0f);
                                                phi_5036_ = _e1075;
                                                phi_2241_ = type_8(0u, 3u);
                                                loop {
                                                    let _e1167 = phi_5036_;
                                                    let _e1169 = phi_2241_;
                                                    if (_e1169.member < _e1169.member_1) {
                                                        phi_2242_ = type_8((_e1169.member + 1u), _e1169.member_1);
                                                        phi_2265_ = type_8(1u, _e1169.member);
                                                    } else {
                                                        phi_2242_ = _e1169;
                                                        phi_2265_ = type_8(0u, type_8().member_1);
                                                    }
                                                    let _e1182 = phi_2242_;
                                                    let _e1184 = phi_2265_;
                                                    let _e1188 = (bitcast<i32>(_e1184.member) != 0i);
                                                    if _e1188 {
                                                        let _e1190 = ((_e613 + (_e1094.member_1 * ((3u * _e1146) + 1u))) + (_e1184.member_1 * _e1153));
                                                        let _e1191 = (_e1190 < _e102);
                                                        if _e1191 {
                                                            if _e1191 {
                                                            } else {
                                                                phi_5105_ = true;
                                                                break;
                                                            }
                                                            let _e1193 = global_10.member[_e1190];
                                                            phi_2288_ = _e1193;
                                                        } else {
                                                            phi_2288_ = 0u;
                                                        }
                                                        let _e1195 = phi_2288_;
                                                        let _e1196 = (_e1190 + 1u);
                                                        let _e1197 = (_e1196 < _e102);
                                                        if _e1197 {
                                                            if _e1197 {
                                                            } else {
                                                                phi_5105_ = true;
                                                                break;
                                                            }
                                                            let _e1199 = global_10.member[_e1196];
                                                            phi_2303_ = _e1199;
                                                        } else {
                                                            phi_2303_ = 0u;
                                                        }
                                                        let _e1201 = phi_2303_;
                                                        phi_2306_ = type_8(0u, 3u);
                                                        loop {
                                                            let _e1203 = phi_2306_;
                                                            if (_e1203.member < _e1203.member_1) {
                                                                phi_2307_ = type_8((_e1203.member + 1u), _e1203.member_1);
                                                                phi_2330_ = type_8(1u, _e1203.member);
                                                            } else {
                                                                phi_2307_ = _e1203;
                                                                phi_2330_ = type_8(0u, type_8().member_1);
                                                            }
                                                            let _e1216 = phi_2307_;
                                                            let _e1218 = phi_2330_;
                                                            let _e1222 = (bitcast<i32>(_e1218.member) != 0i);
                                                            if _e1222 {
                                                                let _e1223 = (_e1218.member_1 < 3u);
                                                                if _e1223 {
                                                                } else {
                                                                    phi_5029_ = true;
                                                                    break;
                                                                }
                                                                let _e1225 = local_4[_e1218.member_1];
                                                                if (_e1218.member_1 < 4u) {
                                                                } else {
                                                                    phi_5029_ = true;
                                                                    break;
                                                                }
                                                                let _e1228 = local_6[_e1218.member_1];
                                                                switch bitcast<i32>(_e1143) {
                                                                    case 0: {
                                                                        phi_2400_ = (_e1228 + (f32(((_e1195 >> bitcast<u32>(((10u * _e1225) & 31u))) & 1023u)) * _e158));
                                                                        break;
                                                                    }
                                                                    case 1: {
                                                                        if (_e1225 == 0u) {
                                                                            phi_2377_ = _e1195;
                                                                        } else {
                                                                            if (_e1225 == 1u) {
                                                                                phi_2376_ = ((_e1195 >> bitcast<u32>(21i)) | (_e1201 << bitcast<u32>(11i)));
                                                                            } else {
                                                                                phi_2376_ = (_e1201 >> bitcast<u32>(10i));
                                                                            }
                                                                            let _e1249 = phi_2376_;
                                                                            phi_2377_ = _e1249;
                                                                        }
                                                                        let _e1251 = phi_2377_;
                                                                        phi_2400_ = (_e1228 + (f32((_e1251 & 2097151u)) * _e158));
                                                                        break;
                                                                    }
                                                                    case 2: {
                                                                        let _e1230 = (_e1190 + _e1225);
                                                                        let _e1231 = (_e1230 < _e102);
                                                                        if _e1231 {
                                                                            if _e1231 {
                                                                            } else {
                                                                                phi_5029_ = true;
                                                                                break;
                                                                            }
                                                                            let _e1233 = global_10.member[_e1230];
                                                                            phi_2396_ = _e1233;
                                                                        } else {
                                                                            phi_2396_ = 0u;
                                                                        }
                                                                        let _e1235 = phi_2396_;
                                                                        phi_2400_ = (f32(bitcast<i32>(_e1235)) * _e158);
                                                                        break;
                                                                    }
                                                                    default: {
                                                                        phi_2400_ = f32();
                                                                        break;
                                                                    }
                                                                }
                                                                let _e1265 = phi_2400_;
                                                                if (_e1184.member_1 < 3u) {
                                                                } else {
                                                                    phi_5029_ = true;
                                                                    break;
                                                                }
                                                                if _e1223 {
                                                                } else {
                                                                    phi_5029_ = true;
                                                                    break;
                                                                }
                                                                local_5[_e1184.member_1][_e1218.member_1] = _e1265;
                                                            }
                                                            continue;
                                                            continuing {
                                                                phi_2306_ = _e1216;
                                                                phi_5029_ = _e1167;
                                                                break if !(_e1222);
                                                            }
                                                        }
                                                        let _e1271 = phi_5029_;
                                                        phi_5105_ = _e1271;
                                                        if _e1271 {
                                                            break;
                                                        }
                                                        phi_5106_ = _e1271;
                                                    } else {
                                                        phi_5106_ = _e1167;
                                                    }
                                                    let _e1273 = phi_5106_;
                                                    continue;
                                                    continuing {
                                                        phi_5036_ = _e1273;
                                                        phi_2241_ = _e1182;
                                                        phi_5105_ = _e1273;
                                                        break if !(_e1188);
                                                    }
                                                }
                                                let _e1276 = phi_5105_;
                                                phi_5107_ = _e1276;
                                                if _e1276 {
                                                    break;
                                                }
                                                let _e1277 = local_5;
                                                let _e1293 = (_e1277[0][2] - _e458);
                                                let _e1296 = (((_e1277[0][0] - _e385) * _e482) - (_e1293 * _e410));
                                                let _e1299 = (((_e1277[0][1] - _e422) * _e482) - (_e1293 * _e446));
                                                let _e1302 = (_e1277[1][2] - _e458);
                                                let _e1305 = (((_e1277[1][0] - _e385) * _e482) - (_e1302 * _e410));
                                                let _e1308 = (((_e1277[1][1] - _e422) * _e482) - (_e1302 * _e446));
                                                let _e1311 = (_e1277[2][2] - _e458);
                                                let _e1314 = (((_e1277[2][0] - _e385) * _e482) - (_e1311 * _e410));
                                                let _e1317 = (((_e1277[2][1] - _e422) * _e482) - (_e1311 * _e446));
                                                let _e1318 = (_e1314 * _e1308);
                                                let _e1319 = (_e1317 * _e1305);
                                                let _e1320 = (_e1296 * _e1317);
                                                let _e1321 = (_e1299 * _e1314);
                                                let _e1322 = (_e1305 * _e1299);
                                                let _e1323 = (_e1308 * _e1296);
                                                let _e1328 = (((_e1318 >= _e1319) && (_e1320 >= _e1321)) && (_e1322 >= _e1323));
                                                if (_e1328 || (((_e1318 <= _e1319) && (_e1320 <= _e1321)) && (_e1322 <= _e1323))) {
                                                    let _e1335 = select(-1f, 1f, _e1328);
                                                    let _e1337 = ((_e1318 - _e1319) * _e1335);
                                                    let _e1339 = select(0f, _e1337, (_e1337 > 0f));
                                                    let _e1341 = ((_e1320 - _e1321) * _e1335);
                                                    let _e1343 = select(0f, _e1341, (_e1341 > 0f));
                                                    let _e1345 = ((_e1322 - _e1323) * _e1335);
                                                    let _e1347 = select(0f, _e1345, (_e1345 > 0f));
                                                    let _e1349 = ((_e1339 + _e1343) + _e1347);
                                                    if (_e1349 < 0.000000000000000000000000000000000000011754944f) {
                                                        phi_2995_ = type_25();
                                                        phi_2996_ = true;
                                                    } else {
                                                        let _e1352 = select(_e1277[1][0], _e1277[0][0], (_e1277[0][0] < _e1277[1][0]));
                                                        let _e1356 = select(_e1277[1][0], _e1277[0][0], (_e1277[0][0] > _e1277[1][0]));
                                                        let _e1360 = select(_e1277[1][1], _e1277[0][1], (_e1277[0][1] < _e1277[1][1]));
                                                        let _e1364 = select(_e1277[1][1], _e1277[0][1], (_e1277[0][1] > _e1277[1][1]));
                                                        let _e1368 = select(_e1277[1][2], _e1277[0][2], (_e1277[0][2] < _e1277[1][2]));
                                                        let _e1372 = select(_e1277[1][2], _e1277[0][2], (_e1277[0][2] > _e1277[1][2]));
                                                        let _e1377 = ((select(_e1277[2][0], _e1352, (_e1352 < _e1277[2][0])) - _e408) * _e413);
                                                        let _e1378 = ((select(_e1277[2][0], _e1356, (_e1356 > _e1277[2][0])) - _e409) * _e413);
                                                        let _e1381 = ((select(_e1277[2][1], _e1360, (_e1360 < _e1277[2][1])) - _e444) * _e449);
                                                        let _e1382 = ((select(_e1277[2][1], _e1364, (_e1364 > _e1277[2][1])) - _e445) * _e449);
                                                        let _e1385 = ((select(_e1277[2][2], _e1368, (_e1368 < _e1277[2][2])) - _e480) * _e485);
                                                        let _e1386 = ((select(_e1277[2][2], _e1372, (_e1372 > _e1277[2][2])) - _e481) * _e485);
                                                        let _e1388 = select(_e1386, _e1385, (_e1385 < _e1386));
                                                        let _e1390 = select(_e1386, _e1385, (_e1385 > _e1386));
                                                        let _e1392 = select(_e1378, _e1377, (_e1377 < _e1378));
                                                        let _e1394 = select(_e1382, _e1381, (_e1381 < _e1382));
                                                        let _e1396 = select(_e1394, _e1392, (_e1392 > _e1394));
                                                        let _e1398 = select(_e1388, _e1396, (_e1396 > _e1388));
                                                        let _e1400 = select(_e1378, _e1377, (_e1377 > _e1378));
                                                        let _e1402 = select(_e1382, _e1381, (_e1381 > _e1382));
                                                        let _e1404 = select(_e1402, _e1400, (_e1400 < _e1402));
                                                        let _e1406 = select(_e1390, _e1404, (_e1404 < _e1390));
                                                        let _e1407 = -(_e1388);
                                                        let _e1413 = select(_e531, _e1398, (_e1398 > _e531));
                                                        if (_e1413 > (_e1406 + (select(_e1407, _e1390, (_e1390 > _e1407)) * 0.0000019073523f))) {
                                                            phi_2990_ = type_25();
                                                            phi_2991_ = true;
                                                        } else {
                                                            let _e1415 = (_e1413 > _e1077.member_1);
                                                            if _e1415 {
                                                                phi_2989_ = type_25();
                                                            } else {
                                                                let _e1419 = (_e1277[1][0] - _e1277[0][0]);
                                                                let _e1420 = (_e1277[1][1] - _e1277[0][1]);
                                                                let _e1421 = (_e1277[1][2] - _e1277[0][2]);
                                                                let _e1422 = vec3<f32>(_e1419, _e1420, _e1421);
                                                                let _e1423 = (_e1277[2][0] - _e1277[1][0]);
                                                                let _e1424 = (_e1277[2][1] - _e1277[1][1]);
                                                                let _e1425 = (_e1277[2][2] - _e1277[1][2]);
                                                                let _e1426 = vec3<f32>(_e1423, _e1424, _e1425);
                                                                let _e1427 = (_e1277[0][0] - _e1277[2][0]);
                                                                let _e1428 = (_e1277[0][1] - _e1277[2][1]);
                                                                let _e1429 = (_e1277[0][2] - _e1277[2][2]);
                                                                let _e1430 = vec3<f32>(_e1427, _e1428, _e1429);
                                                                let _e1433 = bitcast<f32>((bitcast<u32>(_e1419) & 2147483647u));
                                                                let _e1436 = bitcast<f32>((bitcast<u32>(_e1420) & 2147483647u));
                                                                let _e1438 = select(_e1436, _e1433, (_e1433 > _e1436));
                                                                let _e1441 = bitcast<f32>((bitcast<u32>(_e1421) & 2147483647u));
                                                                let _e1443 = select(_e1441, _e1438, (_e1438 > _e1441));
                                                                let _e1446 = bitcast<f32>((bitcast<u32>(_e1423) & 2147483647u));
                                                                let _e1449 = bitcast<f32>((bitcast<u32>(_e1424) & 2147483647u));
                                                                let _e1451 = select(_e1449, _e1446, (_e1446 > _e1449));
                                                                let _e1454 = bitcast<f32>((bitcast<u32>(_e1425) & 2147483647u));
                                                                let _e1456 = select(_e1454, _e1451, (_e1451 > _e1454));
                                                                let _e1459 = bitcast<f32>((bitcast<u32>(_e1427) & 2147483647u));
                                                                let _e1462 = bitcast<f32>((bitcast<u32>(_e1428) & 2147483647u));
                                                                let _e1464 = select(_e1462, _e1459, (_e1459 > _e1462));
                                                                let _e1467 = bitcast<f32>((bitcast<u32>(_e1429) & 2147483647u));
                                                                let _e1469 = select(_e1467, _e1464, (_e1464 > _e1467));
                                                                let _e1471 = select(_e1456, _e1443, (_e1443 > _e1456));
                                                                let _e1473 = select(_e1469, _e1471, (_e1471 > _e1469));
                                                                if (_e1443 == _e1473) {
                                                                    phi_2900_ = _e1426;
                                                                    phi_2901_ = _e1430;
                                                                } else {
                                                                    let _e1476 = vec3((_e1456 == _e1473));
                                                                    phi_2900_ = select(_e1422, _e1430, _e1476);
                                                                    phi_2901_ = select(_e1426, _e1422, _e1476);
                                                                }
                                                                let _e1480 = phi_2900_;
                                                                let _e1482 = phi_2901_;
                                                                let _e1489 = ((_e1480.y * _e1482.z) - (_e1482.y * _e1480.z));
                                                                let _e1494 = ((_e1480.z * _e1482.x) - (_e1482.z * _e1480.x));
                                                                let _e1497 = ((_e1480.x * _e1482.y) - (_e1482.x * _e1480.y));
                                                                if (_e1339 >= _e1343) {
                                                                    phi_2932_ = select(true, false, (_e1339 >= _e1347));
                                                                } else {
                                                                    phi_2932_ = true;
                                                                }
                                                                let _e1502 = phi_2932_;
                                                                if _e1502 {
                                                                    phi_2941_ = select(vec3<f32>(_e1277[2][0], _e1277[2][1], _e1277[2][2]), vec3<f32>(_e1277[1][0], _e1277[1][1], _e1277[1][2]), vec3((_e1343 >= _e1347)));
                                                                } else {
                                                                    phi_2941_ = vec3<f32>(_e1277[0][0], _e1277[0][1], _e1277[0][2]);
                                                                }
                                                                let _e1507 = phi_2941_;
                                                                let _e1524 = ((((_e1489 * (_e1507.x - _e385)) + (_e1494 * (_e1507.y - _e422))) + (_e1497 * (_e1507.z - _e458))) / (((_e1489 * _e410) + (_e1494 * _e446)) + (_e1497 * _e482)));
                                                                let _e1526 = select(_e1406, _e1524, (_e1524 < _e1406));
                                                                let _e1528 = select(_e1398, _e1526, (_e1526 > _e1398));
                                                                if (_e1528 >= _e531) {
                                                                    let _e1530 = (_e1528 <= _e1077.member_1);
                                                                    if _e1530 {
                                                                        let _e1531 = (1f / _e1349);
                                                                        phi_2981_ = type_25(_e1528, (_e1343 * _e1531), (_e1347 * _e1531), _e1137);
                                                                    } else {
                                                                        phi_2981_ = type_25();
                                                                    }
                                                                    let _e1536 = phi_2981_;
                                                                    phi_2983_ = _e1536;
                                                                    phi_2984_ = select(true, false, _e1530);
                                                                } else {
                                                                    phi_2983_ = type_25();
                                                                    phi_2984_ = true;
                                                                }
                                                                let _e1539 = phi_2983_;
                                                                let _e1541 = phi_2984_;
                                                                if _e1541 {
                                                                    phi_2988_ = type_25(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                } else {
                                                                    phi_2988_ = _e1539;
                                                                }
                                                                let _e1543 = phi_2988_;
                                                                phi_2989_ = _e1543;
                                                            }
                                                            let _e1545 = phi_2989_;
                                                            phi_2990_ = _e1545;
                                                            phi_2991_ = _e1415;
                                                        }
                                                        let _e1547 = phi_2990_;
                                                        let _e1549 = phi_2991_;
                                                        phi_2995_ = _e1547;
                                                        phi_2996_ = _e1549;
                                                    }
                                                    let _e1551 = phi_2995_;
                                                    let _e1553 = phi_2996_;
                                                    phi_3000_ = _e1551;
                                                    phi_3001_ = _e1553;
                                                } else {
                                                    phi_3000_ = type_25();
                                                    phi_3001_ = true;
                                                }
                                                let _e1555 = phi_3000_;
                                                let _e1557 = phi_3001_;
                                                if _e1557 {
                                                    phi_3005_ = type_25(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                } else {
                                                    phi_3005_ = _e1555;
                                                }
                                                let _e1559 = phi_3005_;
                                                if (_e1559.member_3 != 4294967295u) {
                                                    if (_e1137 == _e167) {
                                                        phi_3334_ = false;
                                                    } else {
                                                        let _e1563 = (_e1137 < arrayLength((&global_5.member)));
                                                        if _e1563 {
                                                            if _e1563 {
                                                            } else {
                                                                phi_5107_ = true;
                                                                break;
                                                            }
                                                            let _e1565 = global_5.member[_e1137];
                                                            phi_3028_ = _e1565;
                                                        } else {
                                                            phi_3028_ = 4294967295u;
                                                        }
                                                        let _e1567 = phi_3028_;
                                                        let _e1568 = (_e1567 < arrayLength((&global_6.member)));
                                                        if _e1568 {
                                                            if _e1568 {
                                                            } else {
                                                                phi_5107_ = true;
                                                                break;
                                                            }
                                                            let _e1570 = global_6.member[_e1567];
                                                            phi_3042_ = _e1570;
                                                        } else {
                                                            phi_3042_ = 0i;
                                                        }
                                                        let _e1572 = phi_3042_;
                                                        let _e1573 = (_e1572 == 0i);
                                                        if _e1573 {
                                                            phi_3333_ = true;
                                                        } else {
                                                            if _e377 {
                                                                phi_3063_ = vec3<f32>(_e1277[0][0], _e1277[0][1], _e1277[0][2]);
                                                            } else {
                                                                if (_e357 == 1u) {
                                                                    phi_3062_ = vec3<f32>(_e1277[0][2], _e1277[0][0], _e1277[0][1]);
                                                                } else {
                                                                    phi_3062_ = vec3<f32>(_e1277[0][1], _e1277[0][2], _e1277[0][0]);
                                                                }
                                                                let _e1578 = phi_3062_;
                                                                phi_3063_ = _e1578;
                                                            }
                                                            let _e1581 = phi_3063_;
                                                            if _e377 {
                                                                phi_3080_ = vec3<f32>(_e1277[1][0], _e1277[1][1], _e1277[1][2]);
                                                            } else {
                                                                if (_e357 == 1u) {
                                                                    phi_3079_ = vec3<f32>(_e1277[1][2], _e1277[1][0], _e1277[1][1]);
                                                                } else {
                                                                    phi_3079_ = vec3<f32>(_e1277[1][1], _e1277[1][2], _e1277[1][0]);
                                                                }
                                                                let _e1586 = phi_3079_;
                                                                phi_3080_ = _e1586;
                                                            }
                                                            let _e1589 = phi_3080_;
                                                            if _e377 {
                                                                phi_3097_ = vec3<f32>(_e1277[2][0], _e1277[2][1], _e1277[2][2]);
                                                            } else {
                                                                if (_e357 == 1u) {
                                                                    phi_3096_ = vec3<f32>(_e1277[2][2], _e1277[2][0], _e1277[2][1]);
                                                                } else {
                                                                    phi_3096_ = vec3<f32>(_e1277[2][1], _e1277[2][2], _e1277[2][0]);
                                                                }
                                                                let _e1594 = phi_3096_;
                                                                phi_3097_ = _e1594;
                                                            }
                                                            let _e1597 = phi_3097_;
                                                            let _e1600 = (_e1589.x - _e1581.x);
                                                            let _e1603 = (_e1589.y - _e1581.y);
                                                            let _e1606 = (_e1589.z - _e1581.z);
                                                            let _e1608 = (_e1597.x - _e1581.x);
                                                            let _e1610 = (_e1597.y - _e1581.y);
                                                            let _e1612 = (_e1597.z - _e1581.z);
                                                            if (_e235.member_1 == 1u) {
                                                                phi_3133_ = (vec3<f32>(_e235.member[0], _e235.member[1], _e235.member[2]) - _e1581);
                                                            } else {
                                                                phi_3133_ = vec3<f32>(_e235.member[0], _e235.member[1], _e235.member[2]);
                                                            }
                                                            let _e1627 = phi_3133_;
                                                            let _e1633 = bitcast<f32>((bitcast<u32>((_e1600 * _e1610)) ^ _e235.member_3[0]));
                                                            let _e1637 = bitcast<f32>((bitcast<u32>((_e1603 * _e1608)) ^ _e235.member_3[0]));
                                                            let _e1641 = bitcast<f32>((bitcast<u32>((_e1603 * _e1612)) ^ _e235.member_3[0]));
                                                            let _e1645 = bitcast<f32>((bitcast<u32>((_e1606 * _e1610)) ^ _e235.member_3[0]));
                                                            let _e1649 = bitcast<f32>((bitcast<u32>((_e1606 * _e1608)) ^ _e235.member_3[0]));
                                                            let _e1653 = bitcast<f32>((bitcast<u32>((_e1600 * _e1612)) ^ _e235.member_3[0]));
                                                            let _e1654 = (_e1641 - _e1645);
                                                            let _e1655 = (_e1649 - _e1653);
                                                            let _e1656 = (_e1633 - _e1637);
                                                            let _e1680 = (bitcast<f32>((bitcast<u32>(_e1641) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1645) & 2147483647u)));
                                                            let _e1687 = (bitcast<f32>((bitcast<u32>(_e1649) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1653) & 2147483647u)));
                                                            let _e1694 = (bitcast<f32>((bitcast<u32>(_e1633) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1637) & 2147483647u)));
                                                            if (_e235.member_2 == 0f) {
                                                                phi_3315_ = 0f;
                                                            } else {
                                                                let _e1724 = bitcast<f32>((bitcast<u32>(_e1654) & 2147483647u));
                                                                let _e1727 = bitcast<f32>((bitcast<u32>(_e1655) & 2147483647u));
                                                                let _e1730 = bitcast<f32>((bitcast<u32>(_e1656) & 2147483647u));
                                                                let _e1732 = select(_e1730, _e1727, (_e1727 > _e1730));
                                                                let _e1736 = select(_e1730, _e1727, (_e1727 < _e1730));
                                                                let _e1740 = select(_e1727, _e1724, (_e1724 < _e1727));
                                                                let _e1742 = select(_e1727, _e1724, (_e1724 > _e1727));
                                                                let _e1744 = select(_e1730, _e1742, (_e1742 < _e1730));
                                                                phi_3315_ = bitcast<f32>((bitcast<u32>((_e235.member_2 * bitcast<f32>((bitcast<u32>(((((select(_e1732, _e1724, (_e1724 > _e1732)) + bitcast<f32>((bitcast<u32>((0.414214f * select(_e1744, _e1740, (_e1740 > _e1744)))) ^ _e235.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.317838f * select(_e1736, _e1724, (_e1724 < _e1736)))) ^ _e235.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.0000004768374f * ((_e1680 + _e1687) + _e1694))) ^ _e235.member_3[0]))) * 1.0000005f)) ^ _e235.member_3[0])))) ^ _e235.member_3[0]));
                                                            }
                                                            let _e1771 = phi_3315_;
                                                            phi_3333_ = (_e1573 || !(((((bitcast<f32>((bitcast<u32>((_e1627.x * _e1654)) ^ _e235.member_3[0])) + bitcast<f32>((bitcast<u32>((_e1627.y * _e1655)) ^ _e235.member_3[0]))) + bitcast<f32>((bitcast<u32>((_e1627.z * _e1656)) ^ _e235.member_3[0]))) * f32(-(_e1572))) > ((bitcast<f32>((bitcast<u32>((0.0000009536752f * ((bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1627.x) & 2147483647u)) * _e1680)) ^ _e235.member_3[0])) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1627.y) & 2147483647u)) * _e1687)) ^ _e235.member_3[0]))) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1627.z) & 2147483647u)) * _e1694)) ^ _e235.member_3[0]))))) ^ _e235.member_3[0])) + _e1771) + 0.0000000000000000000000000000000000001880791f))));
                                                        }
                                                        let _e1785 = phi_3333_;
                                                        phi_3334_ = _e1785;
                                                    }
                                                    let _e1787 = phi_3334_;
                                                    if _e1787 {
                                                        if (_e1559.member < _e1077.member.member) {
                                                            phi_3354_ = true;
                                                        } else {
                                                            if (_e1559.member == _e1077.member.member) {
                                                                phi_3353_ = (_e1559.member_3 < _e1077.member.member_3);
                                                            } else {
                                                                phi_3353_ = false;
                                                            }
                                                            let _e1797 = phi_3353_;
                                                            phi_3354_ = _e1797;
                                                        }
                                                        let _e1799 = phi_3354_;
                                                        if _e1799 {
                                                            phi_3360_ = type_42(_e1559, _e1559.member);
                                                        } else {
                                                            phi_3360_ = _e1077;
                                                        }
                                                        let _e1802 = phi_3360_;
                                                        phi_3361_ = _e1802;
                                                    } else {
                                                        phi_3361_ = _e1077;
                                                    }
                                                    let _e1804 = phi_3361_;
                                                    phi_3362_ = _e1804;
                                                } else {
                                                    phi_3362_ = _e1077;
                                                }
                                                let _e1806 = phi_3362_;
                                                phi_5108_ = _e1276;
                                                phi_2074_ = _e1806;
                                            } else {
                                                phi_5108_ = _e1075;
                                                phi_2074_ = type_42();
                                            }
                                            let _e1808 = phi_5108_;
                                            let _e1810 = phi_2074_;
                                            continue;
                                            continuing {
                                                phi_5051_ = _e1808;
                                                phi_2073_ = _e1810;
                                                phi_2076_ = _e1092;
                                                phi_5107_ = _e1808;
                                                break if !(_e1098);
                                            }
                                        }
                                        let _e1813 = phi_5107_;
                                        phi_5186_ = _e1813;
                                        if _e1813 {
                                            break;
                                        }
                                        phi_5190_ = _e1813;
                                        let _e2051 = local_8;
                                        phi_4700_ = _e2051;
                                        phi_4701_ = _e604;
                                        phi_4702_ = false;
                                        phi_4703_ = _e608;
                                    } else {
                                        if (_e604.member_1 >= _e99) {
                                            phi_4300_ = type_62(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), type_59(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u), type_59(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u));
                                        } else {
                                            if (_e604.member_1 < _e99) {
                                            } else {
                                                phi_5186_ = true;
                                                break;
                                            }
                                            let _e621 = ((1u + _e357) % 4u);
                                            if (_e621 < 4u) {
                                            } else {
                                                phi_5186_ = true;
                                                break;
                                            }
                                            let _e626 = global_4.member[_e604.member_1][_e621];
                                            let _e628 = ((1u + _e356) % 4u);
                                            if (_e628 < 4u) {
                                            } else {
                                                phi_5186_ = true;
                                                break;
                                            }
                                            let _e633 = global_4.member[_e604.member_1][_e628];
                                            let _e635 = ((1u + _e358) % 4u);
                                            if (_e635 < 4u) {
                                            } else {
                                                phi_5186_ = true;
                                                break;
                                            }
                                            let _e640 = global_4.member[_e604.member_1][_e635];
                                            let _e642 = ((_e357 + 1u) % 4u);
                                            if (_e642 < 4u) {
                                            } else {
                                                phi_5186_ = true;
                                                break;
                                            }
                                            let _e647 = global_4.member[_e604.member_1][_e642];
                                            let _e649 = (_e647 >> bitcast<u32>(11u));
                                            let _e651 = ((_e356 + 1u) % 4u);
                                            if (_e651 < 4u) {
                                            } else {
                                                phi_5186_ = true;
                                                break;
                                            }
                                            let _e656 = global_4.member[_e604.member_1][_e651];
                                            let _e658 = (_e656 >> bitcast<u32>(11u));
                                            let _e660 = ((_e358 + 1u) % 4u);
                                            if (_e660 < 4u) {
                                            } else {
                                                phi_5186_ = true;
                                                break;
                                            }
                                            let _e665 = global_4.member[_e604.member_1][_e660];
                                            let _e667 = (_e665 >> bitcast<u32>(11u));
                                            let _e690 = (bitcast<f32>((bitcast<u32>((_e604.member.member_1.x - _e604.member.member.x)) & 2139095040u)) * 0.001953125f);
                                            let _e691 = (bitcast<f32>((bitcast<u32>((_e604.member.member_1.y - _e604.member.member.y)) & 2139095040u)) * 0.001953125f);
                                            let _e692 = (bitcast<f32>((bitcast<u32>((_e604.member.member_1.z - _e604.member.member.z)) & 2139095040u)) * 0.001953125f);
                                            let _e694 = select(_e158, _e690, (_e690 > _e158));
                                            let _e696 = select(_e158, _e691, (_e691 > _e158));
                                            let _e698 = select(_e158, _e692, (_e692 > _e158));
                                            let _e723 = bitcast<u32>((f32(bitcast<i32>((_e626 & 1023u))) * _e694));
                                            let _e728 = (bitcast<i32>((_e626 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e731 = bitcast<f32>((_e723 & bitcast<u32>(_e728)));
                                            let _e732 = bitcast<u32>((f32(bitcast<i32>((_e633 & 1023u))) * _e696));
                                            let _e737 = (bitcast<i32>((_e633 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e740 = bitcast<f32>((_e732 & bitcast<u32>(_e737)));
                                            let _e741 = bitcast<u32>((f32(bitcast<i32>((_e640 & 1023u))) * _e698));
                                            let _e746 = (bitcast<i32>((_e640 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e749 = bitcast<f32>((_e741 & bitcast<u32>(_e746)));
                                            let _e753 = bitcast<f32>((_e723 & bitcast<u32>(~(_e728))));
                                            let _e757 = bitcast<f32>((_e732 & bitcast<u32>(~(_e737))));
                                            let _e761 = bitcast<f32>((_e741 & bitcast<u32>(~(_e746))));
                                            let _e762 = bitcast<u32>((f32(bitcast<i32>((_e649 & 1023u))) * _e694));
                                            let _e767 = (bitcast<i32>((_e649 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e770 = bitcast<f32>((_e762 & bitcast<u32>(_e767)));
                                            let _e771 = bitcast<u32>((f32(bitcast<i32>((_e658 & 1023u))) * _e696));
                                            let _e776 = (bitcast<i32>((_e658 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e779 = bitcast<f32>((_e771 & bitcast<u32>(_e776)));
                                            let _e780 = bitcast<u32>((f32(bitcast<i32>((_e667 & 1023u))) * _e698));
                                            let _e785 = (bitcast<i32>((_e667 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e788 = bitcast<f32>((_e780 & bitcast<u32>(_e785)));
                                            let _e792 = bitcast<f32>((_e762 & bitcast<u32>(~(_e767))));
                                            let _e796 = bitcast<f32>((_e771 & bitcast<u32>(~(_e776))));
                                            let _e800 = bitcast<f32>((_e780 & bitcast<u32>(~(_e785))));
                                            let _e801 = (_e604.member.member.x + _e731);
                                            let _e802 = (_e604.member.member.y + _e740);
                                            let _e803 = (_e604.member.member.z + _e749);
                                            let _e806 = (_e604.member.member_1.x - _e770);
                                            let _e807 = (_e604.member.member_1.y - _e779);
                                            let _e808 = (_e604.member.member_1.z - _e788);
                                            let _e827 = (_e806 - _e801);
                                            let _e828 = (_e807 - _e802);
                                            let _e829 = (_e808 - _e803);
                                            let _e831 = select(_e828, _e827, (_e827 > _e828));
                                            let _e833 = select(_e829, _e831, (_e831 > _e829));
                                            if (_e833 < (1024f * _e158)) {
                                                phi_4001_ = 0u;
                                            } else {
                                                phi_4001_ = select(2u, 1u, (_e833 < (2097152f * _e158)));
                                            }
                                            let _e840 = phi_4001_;
                                            switch bitcast<i32>(_e840) {
                                                case 0: {
                                                    phi_4007_ = 1u;
                                                    break;
                                                }
                                                case 1: {
                                                    phi_4007_ = 2u;
                                                    break;
                                                }
                                                case 2: {
                                                    phi_4007_ = 3u;
                                                    break;
                                                }
                                                default: {
                                                    phi_4007_ = u32();
                                                    break;
                                                }
                                            }
                                            let _e843 = phi_4007_;
                                            let _e849 = global_4.member[_e604.member_1][0u];
                                            let _e853 = global_4.member[_e604.member_1][1u];
                                            let _e857 = global_4.member[_e604.member_1][2u];
                                            let _e861 = global_4.member[_e604.member_1][3u];
                                            let _e873 = (((_e853 >> bitcast<u32>(22i)) | ((_e857 >> bitcast<u32>(22i)) << bitcast<u32>(10i))) | ((_e861 >> bitcast<u32>(22i)) << bitcast<u32>(20i)));
                                            let _e874 = (_e849 & 268435455u);
                                            let _e875 = (_e873 & 268435455u);
                                            let _e878 = ((_e849 >> bitcast<u32>(28u)) & 7u);
                                            let _e886 = ((_e849 >> bitcast<u32>(31i)) | (((_e873 >> bitcast<u32>(28u)) & 3u) << bitcast<u32>(1i)));
                                            let _e887 = (_e878 != 0u);
                                            if (_e878 == 0u) {
                                                phi_4262_ = _e874;
                                            } else {
                                                if (_e878 == 7u) {
                                                    phi_4261_ = 2147483648u;
                                                } else {
                                                    phi_4261_ = ((2147483648u | (_e878 << bitcast<u32>(28u))) | (_e875 & 268435455u));
                                                }
                                                let _e896 = phi_4261_;
                                                phi_4262_ = _e896;
                                            }
                                            let _e898 = phi_4262_;
                                            if _e887 {
                                                let _e899 = (_e878 != 7u);
                                                if _e899 {
                                                    phi_4272_ = (_e875 + (_e878 * ((3u * _e843) + 1u)));
                                                } else {
                                                    phi_4272_ = u32();
                                                }
                                                let _e903 = phi_4272_;
                                                phi_4274_ = _e903;
                                                phi_4275_ = select(true, false, _e899);
                                            } else {
                                                phi_4274_ = u32();
                                                phi_4275_ = true;
                                            }
                                            let _e906 = phi_4274_;
                                            let _e908 = phi_4275_;
                                            if (_e886 == 0u) {
                                                phi_4296_ = (_e874 + select(0u, 1u, !(_e887)));
                                            } else {
                                                if (_e886 == 7u) {
                                                    phi_4295_ = 2147483648u;
                                                } else {
                                                    phi_4295_ = ((2147483648u | (_e886 << bitcast<u32>(28u))) | (select(_e906, _e875, _e908) & 268435455u));
                                                }
                                                let _e921 = phi_4295_;
                                                phi_4296_ = _e921;
                                            }
                                            let _e923 = phi_4296_;
                                            phi_4300_ = type_62(array<vec4<f32>, 3>(vec4<f32>(_e801, (_e604.member.member.x + _e753), _e806, (_e604.member.member_1.x - _e792)), vec4<f32>(_e802, (_e604.member.member.y + _e757), _e807, (_e604.member.member_1.y - _e796)), vec4<f32>(_e803, (_e604.member.member.z + _e761), _e808, (_e604.member.member_1.z - _e800))), type_59(type_37((_e604.member.member + vec4<f32>(_e731, _e740, _e749, 0f)), (_e604.member.member_1 - vec4<f32>(_e770, _e779, _e788, 0f))), _e898), type_59(type_37((_e604.member.member + vec4<f32>(_e753, _e757, _e761, 0f)), (_e604.member.member_1 - vec4<f32>(_e792, _e796, _e800, 0f))), _e923));
                                        }
                                        let _e928 = phi_4300_;
                                        let _e940 = ((_e928.member[0].x - _e408) * _e413);
                                        let _e941 = ((_e928.member[0].y - _e408) * _e413);
                                        let _e942 = ((_e928.member[0].z - _e409) * _e413);
                                        let _e943 = ((_e928.member[0].w - _e409) * _e413);
                                        let _e953 = ((_e928.member[1].x - _e444) * _e449);
                                        let _e954 = ((_e928.member[1].y - _e444) * _e449);
                                        let _e955 = ((_e928.member[1].z - _e445) * _e449);
                                        let _e956 = ((_e928.member[1].w - _e445) * _e449);
                                        let _e966 = ((_e928.member[2].x - _e480) * _e485);
                                        let _e967 = ((_e928.member[2].y - _e480) * _e485);
                                        let _e968 = ((_e928.member[2].z - _e481) * _e485);
                                        let _e969 = ((_e928.member[2].w - _e481) * _e485);
                                        let _e971 = select(_e968, _e966, (_e966 < _e968));
                                        let _e973 = select(_e969, _e967, (_e967 < _e969));
                                        let _e975 = select(_e968, _e966, (_e966 > _e968));
                                        let _e977 = select(_e969, _e967, (_e967 > _e969));
                                        let _e979 = select(_e942, _e940, (_e940 < _e942));
                                        let _e981 = select(_e943, _e941, (_e941 < _e943));
                                        let _e983 = select(_e955, _e953, (_e953 < _e955));
                                        let _e985 = select(_e956, _e954, (_e954 < _e956));
                                        let _e987 = select(_e983, _e979, (_e979 > _e983));
                                        let _e989 = select(_e985, _e981, (_e981 > _e985));
                                        let _e991 = select(_e971, _e987, (_e987 > _e971));
                                        let _e993 = select(_e973, _e989, (_e989 > _e973));
                                        let _e995 = select(_e942, _e940, (_e940 > _e942));
                                        let _e997 = select(_e943, _e941, (_e941 > _e943));
                                        let _e999 = select(_e955, _e953, (_e953 > _e955));
                                        let _e1001 = select(_e956, _e954, (_e954 > _e956));
                                        let _e1003 = select(_e999, _e995, (_e995 < _e999));
                                        let _e1005 = select(_e1001, _e997, (_e997 < _e1001));
                                        let _e1010 = -(_e971);
                                        let _e1011 = -(_e973);
                                        let _e1018 = (select(_e975, _e1003, (_e1003 < _e975)) + (select(_e1010, _e975, (_e975 > _e1010)) * 0.0000019073523f));
                                        let _e1019 = (select(_e977, _e1005, (_e1005 < _e977)) + (select(_e1011, _e977, (_e977 > _e1011)) * 0.0000019073523f));
                                        let _e1021 = select(_e531, _e991, (_e991 > _e531));
                                        let _e1023 = select(_e531, _e993, (_e993 > _e531));
                                        let _e1028 = (_e1021 <= select(_e575.member_1, _e1018, (_e1018 < _e575.member_1)));
                                        let _e1029 = (_e1023 <= select(_e575.member_1, _e1019, (_e1019 < _e575.member_1)));
                                        let _e1030 = (_e1021 <= _e1023);
                                        if _e1028 {
                                            if _e1029 {
                                                if _e1030 {
                                                    phi_4644_ = _e928.member_2;
                                                } else {
                                                    phi_4644_ = _e928.member_1;
                                                }
                                                let _e1034 = phi_4644_;
                                                let _e1035 = (_e608 % 128u);
                                                let _e1036 = (_e1035 < 128u);
                                                if _e1036 {
                                                } else {
                                                    phi_5186_ = true;
                                                    break;
                                                }
                                                local_3[_e1035] = type_59(type_37(_e1034.member.member, _e1034.member.member_1), _e1034.member_1);
                                                if _e1036 {
                                                } else {
                                                    phi_5186_ = true;
                                                    break;
                                                }
                                                local_2[_e1035] = select(_e1023, _e1021, (_e1021 > _e1023));
                                                if _e1030 {
                                                    phi_4677_ = _e928.member_1;
                                                } else {
                                                    phi_4677_ = _e928.member_2;
                                                }
                                                let _e1051 = phi_4677_;
                                                phi_4678_ = _e1051;
                                                phi_4679_ = (_e608 + 1u);
                                            } else {
                                                phi_4678_ = type_59();
                                                phi_4679_ = u32();
                                            }
                                            let _e1053 = phi_4678_;
                                            let _e1055 = phi_4679_;
                                            phi_4681_ = _e1053;
                                            phi_4682_ = _e1055;
                                            phi_4683_ = select(true, false, _e1029);
                                        } else {
                                            phi_4681_ = type_59();
                                            phi_4682_ = u32();
                                            phi_4683_ = true;
                                        }
                                        let _e1058 = phi_4681_;
                                        let _e1060 = phi_4682_;
                                        let _e1062 = phi_4683_;
                                        if _e1062 {
                                            if _e1028 {
                                                phi_4692_ = _e928.member_1;
                                            } else {
                                                phi_4692_ = _e928.member_2;
                                            }
                                            let _e1066 = phi_4692_;
                                            phi_4697_ = _e1066;
                                            phi_4698_ = select(_e1029, true, _e1028);
                                        } else {
                                            phi_4697_ = _e1058;
                                            phi_4698_ = _e606;
                                        }
                                        let _e1069 = phi_4697_;
                                        let _e1071 = phi_4698_;
                                        phi_5190_ = _e573;
                                        phi_4700_ = _e575;
                                        phi_4701_ = _e1069;
                                        phi_4702_ = _e1071;
                                        phi_4703_ = select(_e1060, _e608, _e1062);
                                    }
                                    let _e1815 = phi_5190_;
                                    let _e1817 = phi_4700_;
                                    let _e1819 = phi_4701_;
                                    let _e1821 = phi_4702_;
                                    let _e1823 = phi_4703_;
                                    phi_5189_ = _e1815;
                                    phi_4704_ = _e1817;
                                    phi_4705_ = _e1819;
                                    phi_4706_ = (_e579 - 1u);
                                    phi_4707_ = _e1821;
                                    phi_4708_ = _e1823;
                                } else {
                                    phi_5189_ = _e573;
                                    phi_4704_ = _e575;
                                    phi_4705_ = _e604;
                                    phi_4706_ = _e579;
                                    phi_4707_ = _e606;
                                    phi_4708_ = _e608;
                                }
                                let _e1825 = phi_5189_;
                                let _e1827 = phi_4704_;
                                let _e1829 = phi_4705_;
                                let _e1831 = phi_4706_;
                                let _e1833 = phi_4707_;
                                let _e1835 = phi_4708_;
                                phi_5188_ = _e1825;
                                phi_4709_ = _e1827;
                                phi_4710_ = _e1829;
                                phi_4711_ = _e1831;
                                phi_4712_ = _e1833;
                                phi_4713_ = _e1835;
                            } else {
                                phi_5188_ = _e573;
                                phi_4709_ = type_42();
                                phi_4710_ = type_59();
                                phi_4711_ = u32();
                                phi_4712_ = bool();
                                phi_4713_ = u32();
                            }
                            let _e1837 = phi_5188_;
                            let _e1839 = phi_4709_;
                            let _e1841 = phi_4710_;
                            let _e1843 = phi_4711_;
                            let _e1845 = phi_4712_;
                            let _e1847 = phi_4713_;
                            phi_5187_ = _e1837;
                            phi_1996_ = _e1839;
                            phi_1999_ = _e1841;
                            phi_2001_ = _e1843;
                            phi_2003_ = _e1845;
                            phi_2005_ = _e1847;
                            phi_4714_ = _e587;
                        } else {
                            phi_5187_ = _e573;
                            phi_1996_ = type_42();
                            phi_1999_ = type_59();
                            phi_2001_ = u32();
                            phi_2003_ = bool();
                            phi_2005_ = u32();
                            phi_4714_ = false;
                        }
                        let _e1849 = phi_5187_;
                        let _e1851 = phi_1996_;
                        let _e1853 = phi_1999_;
                        let _e1855 = phi_2001_;
                        let _e1857 = phi_2003_;
                        let _e1859 = phi_2005_;
                        let _e1861 = phi_4714_;
                        continue;
                        continuing {
                            phi_5054_ = _e1849;
                            phi_1995_ = _e1851;
                            phi_1998_ = _e1853;
                            phi_2000_ = _e1855;
                            phi_2002_ = _e1857;
                            phi_2004_ = _e1859;
                            phi_5186_ = _e1849;
                            break if !(_e1861);
                        }
                    }
                    let _e1864 = phi_5186_;
                    if _e1864 {
                        break;
                    }
                    let _e1866 = local_7;
                    if (_e1866.member.member_3 != 4294967295u) {
                        let _e1871 = (_e359 / 3i);
                        let _e1878 = bitcast<f32>((bitcast<u32>((_e1871 + 127i)) << bitcast<u32>(23i)));
                        let _e1886 = (((_e1866.member.member * _e1878) * _e1878) * bitcast<f32>((bitcast<u32>(((_e359 - (2i * _e1871)) + 127i)) << bitcast<u32>(23i))));
                        let _e1888 = select(340282350000000000000000000000000000000f, _e1886, (_e1886 < 340282350000000000000000000000000000000f));
                        phi_4766_ = type_25(select(-340282350000000000000000000000000000000f, _e1888, (_e1888 > -340282350000000000000000000000000000000f)), _e1866.member.member_1, _e1866.member.member_2, _e1866.member.member_3);
                    } else {
                        phi_4766_ = type_25(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                    }
                    let _e1895 = phi_4766_;
                    if _e236 {
                    } else {
                        break;
                    }
                    global_8.member[_e146] = _e1895;
                    if _e161 {
                    } else {
                        break;
                    }
                    let _e1899 = select(0u, 1u, (_e303 <= _e313));
                    if (_e1899 > 0u) {
                        let _e1901 = (1u < _e114);
                        if _e1901 {
                            if (0u < _e114) {
                            } else {
                                break;
                            }
                            let _e1905 = atomicAdd((&global_9.member[0u]), _e1899);
                            if ((_e1905 + _e1899) < _e1905) {
                                if _e1901 {
                                } else {
                                    break;
                                }
                                let _e1910 = atomicAdd((&global_9.member[1u]), 1u);
                            }
                        }
                    }
                    let _e1913 = select(0u, 1u, (_e1895.member_3 != 4294967295u));
                    if (_e1913 > 0u) {
                        let _e1915 = (3u < _e114);
                        if _e1915 {
                            if (2u < _e114) {
                            } else {
                                break;
                            }
                            let _e1919 = atomicAdd((&global_9.member[2u]), _e1913);
                            if ((_e1919 + _e1913) < _e1919) {
                                if _e1915 {
                                } else {
                                    break;
                                }
                                let _e1924 = atomicAdd((&global_9.member[3u]), 1u);
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
fn trace_paths_q10_lattice(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
