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
    var phi_340_: u32;
    var phi_405_: type_36;
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
    var phi_1995_: type_38;
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
    var phi_2073_: type_38;
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
    var phi_2981_: type_21;
    var phi_2983_: type_21;
    var phi_2984_: bool;
    var phi_2988_: type_21;
    var phi_2989_: type_21;
    var phi_2990_: type_21;
    var phi_2991_: bool;
    var phi_2995_: type_21;
    var phi_2996_: bool;
    var phi_3000_: type_21;
    var phi_3001_: bool;
    var phi_3005_: type_21;
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
    var phi_3360_: type_38;
    var phi_3361_: type_38;
    var phi_3362_: type_38;
    var phi_5108_: bool;
    var phi_2074_: type_38;
    var phi_5107_: bool;
    var phi_5190_: bool;
    var phi_4700_: type_38;
    var phi_4701_: type_59;
    var phi_4702_: bool;
    var phi_4703_: u32;
    var phi_5189_: bool;
    var phi_4704_: type_38;
    var phi_4705_: type_59;
    var phi_4706_: u32;
    var phi_4707_: bool;
    var phi_4708_: u32;
    var phi_5188_: bool;
    var phi_4709_: type_38;
    var phi_4710_: type_59;
    var phi_4711_: u32;
    var phi_4712_: bool;
    var phi_4713_: u32;
    var phi_5187_: bool;
    var phi_1996_: type_38;
    var phi_1999_: type_59;
    var phi_2001_: u32;
    var phi_2003_: bool;
    var phi_2005_: u32;
    var phi_4714_: bool;
    var phi_5186_: bool;
    var local_7: type_38;
    var phi_4766_: type_21;
    var local_8: type_38;

    switch bitcast<i32>(0u) {
        default: {
            let _e96 = global;
            let _e98 = arrayLength((&global_9.member));
            let _e101 = arrayLength((&global_10.member));
            let _e113 = arrayLength((&global_8.member));
            let _e117 = global_3.member[0u][0u];
            let _e121 = global_3.member[0u][1u];
            let _e125 = global_3.member[0u][2u];
            let _e129 = global_3.member[0u][3u];
            let _e133 = global_3.member[1u][0u];
            let _e137 = global_3.member[1u][1u];
            let _e141 = global_3.member[1u][2u];
            let _e145 = (_e96.x + (_e96.y * 2097152u));
            let _e157 = bitcast<f32>((bitcast<u32>((bitcast<i32>(_e129) + 127i)) << bitcast<u32>(23i)));
            local_1 = array<i32, 3>(bitcast<i32>(_e117), bitcast<i32>(_e121), bitcast<i32>(_e125));
            local = array<i32, 3>(bitcast<i32>(_e133), bitcast<i32>(_e137), bitcast<i32>(_e141));
            let _e160 = (_e145 < arrayLength((&global_6.member)));
            if _e160 {
                if _e160 {
                } else {
                    break;
                }
                let _e164 = global_6.member[_e145].member_2;
                phi_340_ = _e164;
            } else {
                phi_340_ = 4294967295u;
            }
            let _e166 = phi_340_;
            let _e169 = global_1.member[0u];
            let _e173 = global_2.member[0u][0u];
            let _e177 = global_2.member[0u][1u];
            let _e181 = global_2.member[0u][2u];
            let _e185 = global_2.member[0u][3u];
            let _e189 = global_2.member[1u][0u];
            let _e193 = global_2.member[1u][1u];
            let _e197 = global_2.member[1u][2u];
            let _e201 = global_2.member[1u][3u];
            let _e202 = bitcast<f32>(_e173);
            let _e203 = bitcast<f32>(_e177);
            let _e204 = bitcast<f32>(_e181);
            let _e206 = bitcast<f32>(_e189);
            let _e207 = array<u32, 3>(_e193, _e197, _e201);
            let _e209 = bitcast<i32>(_e169);
            let _e210 = (_e209 / 2i);
            let _e215 = bitcast<f32>((bitcast<u32>((_e210 + 127i)) << bitcast<u32>(23i)));
            let _e221 = bitcast<f32>((bitcast<u32>(((_e209 - _e210) + 127i)) << bitcast<u32>(23i)));
            if (_e185 == 0u) {
                phi_405_ = type_36(array<f32, 3>(_e202, _e203, _e204), _e185, _e206, _e207);
            } else {
                phi_405_ = type_36(array<f32, 3>(((_e202 * _e215) * _e221), ((_e203 * _e215) * _e221), ((_e204 * _e215) * _e221)), _e185, ((_e206 * _e215) * _e221), _e207);
            }
            let _e234 = phi_405_;
            if _e160 {
                let _e235 = (_e145 < arrayLength((&global_7.member)));
                if _e235 {
                    if _e160 {
                    } else {
                        break;
                    }
                    let _e245 = global_6.member[_e145].member.member_2[0u];
                    let _e247 = (bitcast<u32>(_e245) & 2147483647u);
                    let _e253 = global_6.member[_e145].member.member_2[1u];
                    let _e255 = (bitcast<u32>(_e253) & 2147483647u);
                    let _e261 = global_6.member[_e145].member.member_2[2u];
                    let _e263 = (bitcast<u32>(_e261) & 2147483647u);
                    let _e269 = global_6.member[_e145].member.member[0u];
                    let _e271 = (bitcast<u32>(_e269) & 2147483647u);
                    let _e277 = global_6.member[_e145].member.member[1u];
                    let _e279 = (bitcast<u32>(_e277) & 2147483647u);
                    let _e285 = global_6.member[_e145].member.member[2u];
                    let _e287 = (bitcast<u32>(_e285) & 2147483647u);
                    let _e289 = select(_e255, _e247, (_e255 < _e247));
                    let _e291 = select(_e263, _e289, (_e263 < _e289));
                    let _e293 = select(_e271, _e291, (_e271 < _e291));
                    let _e295 = select(_e279, _e293, (_e279 < _e293));
                    let _e297 = select(_e287, _e295, (_e287 < _e295));
                    let _e302 = global_6.member[_e145].member.member_1;
                    let _e304 = (bitcast<u32>(_e302) & 2147483647u);
                    let _e312 = global_6.member[_e145].member.member_3;
                    let _e318 = (((select(_e304, _e297, (_e304 < _e297)) < 2139095040u) && ((bitcast<u32>(_e312) & 2147483647u) <= 2139095040u)) && (_e291 > 0u));
                    if _e318 {
                        let _e321 = (bitcast<u32>(bitcast<f32>(_e291)) & 2147483647u);
                        if (_e321 >= 8388608u) {
                            phi_511_ = (bitcast<i32>((_e321 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_511_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e321)), 32u, (_e321 == 0u))));
                        }
                        let _e335 = phi_511_;
                        phi_512_ = _e335;
                    } else {
                        phi_512_ = 0i;
                    }
                    let _e337 = phi_512_;
                    let _e338 = (_e247 == _e291);
                    if _e338 {
                        phi_522_ = true;
                    } else {
                        phi_522_ = (_e255 == _e291);
                    }
                    let _e341 = phi_522_;
                    let _e342 = select(1u, 0u, _e338);
                    if _e341 {
                        let _e343 = (_e342 + 1u);
                        phi_532_ = _e343;
                        phi_533_ = _e343;
                        phi_535_ = select(true, false, (_e343 == 2u));
                    } else {
                        phi_532_ = u32();
                        phi_533_ = 0u;
                        phi_535_ = true;
                    }
                    let _e347 = phi_532_;
                    let _e349 = phi_533_;
                    let _e351 = phi_535_;
                    if _e351 {
                        phi_540_ = (_e349 + 1u);
                    } else {
                        phi_540_ = 0u;
                    }
                    let _e355 = phi_540_;
                    let _e356 = select(_e347, _e349, _e351);
                    let _e357 = select(_e342, select(2u, _e342, _e341), _e351);
                    let _e358 = -(_e337);
                    let _e359 = (_e358 / 2i);
                    let _e364 = bitcast<f32>((bitcast<u32>((_e359 + 127i)) << bitcast<u32>(23i)));
                    let _e370 = bitcast<f32>((bitcast<u32>(((_e358 - _e359) + 127i)) << bitcast<u32>(23i)));
                    let _e375 = global_6.member[_e145].member.member;
                    let _e376 = (_e356 == 0u);
                    if _e376 {
                        phi_585_ = _e375[0];
                    } else {
                        phi_585_ = _e375[1];
                    }
                    let _e380 = phi_585_;
                    let _e381 = (_e356 == 2u);
                    if _e381 {
                        phi_591_ = _e375[2];
                    } else {
                        phi_591_ = _e380;
                    }
                    let _e384 = phi_591_;
                    let _e385 = global_6.member[_e145].member.member_2;
                    if _e376 {
                        phi_602_ = _e385[0];
                    } else {
                        phi_602_ = _e385[1];
                    }
                    let _e389 = phi_602_;
                    if _e381 {
                        phi_608_ = _e385[2];
                    } else {
                        phi_608_ = _e389;
                    }
                    let _e392 = phi_608_;
                    let _e394 = ((_e392 * _e364) * _e370);
                    let _e398 = (bitcast<f32>((bitcast<u32>(_e394) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e398 {
                        let _e402 = (bitcast<f32>((bitcast<u32>(_e384) & 2147483647u)) * 0.00000011920929f);
                        phi_631_ = select(0.00000000000011368684f, _e402, (_e402 > 0.00000000000011368684f));
                    } else {
                        phi_631_ = 0f;
                    }
                    let _e406 = phi_631_;
                    let _e407 = (_e384 + _e406);
                    let _e408 = (_e384 - _e406);
                    let _e409 = select(_e394, 0f, _e398);
                    if _e398 {
                        phi_642_ = 38685626000000000000000000f;
                    } else {
                        phi_642_ = (1f / _e394);
                    }
                    let _e412 = phi_642_;
                    let _e413 = (_e355 == 0u);
                    if _e413 {
                        phi_651_ = _e375[0];
                    } else {
                        phi_651_ = _e375[1];
                    }
                    let _e417 = phi_651_;
                    let _e418 = (_e355 == 2u);
                    if _e418 {
                        phi_657_ = _e375[2];
                    } else {
                        phi_657_ = _e417;
                    }
                    let _e421 = phi_657_;
                    if _e413 {
                        phi_668_ = _e385[0];
                    } else {
                        phi_668_ = _e385[1];
                    }
                    let _e425 = phi_668_;
                    if _e418 {
                        phi_674_ = _e385[2];
                    } else {
                        phi_674_ = _e425;
                    }
                    let _e428 = phi_674_;
                    let _e430 = ((_e428 * _e364) * _e370);
                    let _e434 = (bitcast<f32>((bitcast<u32>(_e430) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e434 {
                        let _e438 = (bitcast<f32>((bitcast<u32>(_e421) & 2147483647u)) * 0.00000011920929f);
                        phi_697_ = select(0.00000000000011368684f, _e438, (_e438 > 0.00000000000011368684f));
                    } else {
                        phi_697_ = 0f;
                    }
                    let _e442 = phi_697_;
                    let _e443 = (_e421 + _e442);
                    let _e444 = (_e421 - _e442);
                    let _e445 = select(_e430, 0f, _e434);
                    if _e434 {
                        phi_708_ = 38685626000000000000000000f;
                    } else {
                        phi_708_ = (1f / _e430);
                    }
                    let _e448 = phi_708_;
                    let _e449 = (_e357 == 0u);
                    if _e449 {
                        phi_717_ = _e375[0];
                    } else {
                        phi_717_ = _e375[1];
                    }
                    let _e453 = phi_717_;
                    let _e454 = (_e357 == 2u);
                    if _e454 {
                        phi_723_ = _e375[2];
                    } else {
                        phi_723_ = _e453;
                    }
                    let _e457 = phi_723_;
                    if _e449 {
                        phi_734_ = _e385[0];
                    } else {
                        phi_734_ = _e385[1];
                    }
                    let _e461 = phi_734_;
                    if _e454 {
                        phi_740_ = _e385[2];
                    } else {
                        phi_740_ = _e461;
                    }
                    let _e464 = phi_740_;
                    let _e466 = ((_e464 * _e364) * _e370);
                    let _e470 = (bitcast<f32>((bitcast<u32>(_e466) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e470 {
                        let _e474 = (bitcast<f32>((bitcast<u32>(_e457) & 2147483647u)) * 0.00000011920929f);
                        phi_763_ = select(0.00000000000011368684f, _e474, (_e474 > 0.00000000000011368684f));
                    } else {
                        phi_763_ = 0f;
                    }
                    let _e478 = phi_763_;
                    let _e479 = (_e457 + _e478);
                    let _e480 = (_e457 - _e478);
                    let _e481 = select(_e466, 0f, _e470);
                    if _e470 {
                        phi_774_ = 38685626000000000000000000f;
                    } else {
                        phi_774_ = (1f / _e466);
                    }
                    let _e484 = phi_774_;
                    let _e487 = bitcast<f32>((bitcast<u32>(_e384) & 2147483647u));
                    let _e490 = bitcast<f32>((bitcast<u32>(_e421) & 2147483647u));
                    let _e492 = select(_e490, _e487, (_e487 > _e490));
                    let _e495 = bitcast<f32>((bitcast<u32>(_e457) & 2147483647u));
                    if (_e318 && (select(_e495, _e492, (_e492 > _e495)) <= 1099511600000f)) {
                        let _e500 = (_e337 / 3i);
                        let _e507 = bitcast<f32>((bitcast<u32>((_e500 + 127i)) << bitcast<u32>(23i)));
                        let _e514 = bitcast<f32>((bitcast<u32>(((_e337 - (2i * _e500)) + 127i)) << bitcast<u32>(23i)));
                        let _e515 = (((_e302 * _e507) * _e507) * _e514);
                        let _e517 = select(340282350000000000000000000000000000000f, _e515, (_e515 < 340282350000000000000000000000000000000f));
                        let _e522 = (((_e312 * _e507) * _e507) * _e514);
                        let _e524 = select(340282350000000000000000000000000000000f, _e522, (_e522 < 340282350000000000000000000000000000000f));
                        phi_874_ = select(-340282350000000000000000000000000000000f, _e524, (_e524 > -340282350000000000000000000000000000000f));
                        phi_875_ = select(-340282350000000000000000000000000000000f, _e517, (_e517 > -340282350000000000000000000000000000000f));
                    } else {
                        phi_874_ = 0f;
                        phi_875_ = 1f;
                    }
                    let _e528 = phi_874_;
                    let _e530 = phi_875_;
                    local_3 = array<type_59, 128>(type_59(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u));
                    local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    let _e534 = (_e356 % 3u);
                    let _e535 = (_e534 < 3u);
                    if _e535 {
                    } else {
                        break;
                    }
                    let _e537 = local_1[_e534];
                    let _e540 = (_e355 % 3u);
                    let _e541 = (_e540 < 3u);
                    if _e541 {
                    } else {
                        break;
                    }
                    let _e543 = local_1[_e540];
                    let _e546 = (_e357 % 3u);
                    let _e547 = (_e546 < 3u);
                    if _e547 {
                    } else {
                        break;
                    }
                    let _e549 = local_1[_e546];
                    if _e535 {
                    } else {
                        break;
                    }
                    let _e554 = local[_e534];
                    if _e541 {
                    } else {
                        break;
                    }
                    let _e558 = local[_e540];
                    if _e547 {
                    } else {
                        break;
                    }
                    let _e562 = local[_e546];
                    phi_5054_ = false;
                    phi_1995_ = type_38(type_21(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e528);
                    phi_1998_ = type_59(type_33(vec4<f32>((f32(_e537) * _e157), (f32(_e543) * _e157), (f32(_e549) * _e157), 0f), vec4<f32>((f32(_e554) * _e157), (f32(_e558) * _e157), (f32(_e562) * _e157), 0f)), select(0u, 2147483648u, (_e98 == 0u)));
                    phi_2000_ = ((3u * _e98) + 1u);
                    phi_2002_ = (_e530 <= _e528);
                    phi_2004_ = 0u;
                    loop {
                        let _e572 = phi_5054_;
                        let _e574 = phi_1995_;
                        let _e576 = phi_1998_;
                        let _e578 = phi_2000_;
                        let _e580 = phi_2002_;
                        let _e582 = phi_2004_;
                        local_7 = _e574;
                        if _e580 {
                            phi_2015_ = true;
                        } else {
                            phi_2015_ = (_e582 > 0u);
                        }
                        let _e585 = phi_2015_;
                        if _e585 {
                            let _e586 = (_e578 > 0u);
                            if _e586 {
                                if _e580 {
                                    phi_2052_ = _e576;
                                    phi_2053_ = _e580;
                                    phi_2054_ = _e582;
                                } else {
                                    let _e587 = (_e582 - 1u);
                                    let _e588 = (_e587 % 128u);
                                    let _e589 = (_e588 < 128u);
                                    if _e589 {
                                    } else {
                                        phi_5186_ = true;
                                        break;
                                    }
                                    let _e591 = local_3[_e588];
                                    if _e589 {
                                    } else {
                                        phi_5186_ = true;
                                        break;
                                    }
                                    let _e599 = local_2[_e588];
                                    phi_2052_ = type_59(type_33(_e591.member.member, _e591.member.member_1), _e591.member_1);
                                    phi_2053_ = (_e599 <= _e574.member_1);
                                    phi_2054_ = _e587;
                                }
                                let _e603 = phi_2052_;
                                let _e605 = phi_2053_;
                                let _e607 = phi_2054_;
                                if _e605 {
                                    let _e612 = (_e603.member_1 & 268435455u);
                                    if ((_e603.member_1 & 2147483648u) != 0u) {
                                        phi_5051_ = _e572;
                                        phi_2073_ = _e574;
                                        phi_2076_ = type_8(0u, ((_e603.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e1074 = phi_5051_;
                                            let _e1076 = phi_2073_;
                                            let _e1078 = phi_2076_;
                                            local_8 = _e1076;
                                            if (_e1078.member < _e1078.member_1) {
                                                phi_2077_ = type_8((_e1078.member + 1u), _e1078.member_1);
                                                phi_2099_ = type_8(1u, _e1078.member);
                                            } else {
                                                phi_2077_ = _e1078;
                                                phi_2099_ = type_8(0u, type_8().member_1);
                                            }
                                            let _e1091 = phi_2077_;
                                            let _e1093 = phi_2099_;
                                            let _e1097 = (bitcast<i32>(_e1093.member) != 0i);
                                            if _e1097 {
                                                let _e1102 = (_e603.member.member_1.x - _e603.member.member.x);
                                                let _e1105 = (_e603.member.member_1.y - _e603.member.member.y);
                                                let _e1108 = (_e603.member.member_1.z - _e603.member.member.z);
                                                let _e1110 = select(_e1105, _e1102, (_e1102 > _e1105));
                                                let _e1112 = select(_e1108, _e1110, (_e1110 > _e1108));
                                                let _e1114 = (_e1112 < (1024f * _e157));
                                                if _e1114 {
                                                    phi_2140_ = 0u;
                                                } else {
                                                    phi_2140_ = select(2u, 1u, (_e1112 < (2097152f * _e157)));
                                                }
                                                let _e1119 = phi_2140_;
                                                switch bitcast<i32>(_e1119) {
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
                                                let _e1122 = phi_2146_;
                                                switch bitcast<i32>(_e1119) {
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
                                                let _e1129 = phi_2156_;
                                                let _e1131 = ((_e612 + (_e1093.member_1 * ((3u * _e1122) + 1u))) + (3u * _e1129));
                                                let _e1132 = (_e1131 < _e101);
                                                if _e1132 {
                                                    if _e1132 {
                                                    } else {
                                                        phi_5107_ = true;
                                                        break;
                                                    }
                                                    let _e1134 = global_10.member[_e1131];
                                                    phi_2172_ = _e1134;
                                                } else {
                                                    phi_2172_ = 4294967295u;
                                                }
                                                let _e1136 = phi_2172_;
                                                local_4 = array<u32, 3>(_e356, _e355, _e357);
                                                if _e1114 {
                                                    phi_2209_ = 0u;
                                                } else {
                                                    phi_2209_ = select(2u, 1u, (_e1112 < (2097152f * _e157)));
                                                }
                                                let _e1142 = phi_2209_;
                                                switch bitcast<i32>(_e1142) {
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
                                                let _e1145 = phi_2215_;
                                                switch bitcast<i32>(_e1142) {
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
                                                let _e1152 = phi_2225_;
                                                local_6 = array<f32, 4>(_e603.member.member.x, _e603.member.member.y, _e603.member.member.z, _e603.member.member.w);
                                                local_5[0u] = array<f32, 3>(0f, 0f, 0f);
                                                local_5[1u] = array<f32, 3>(0f, 0f, 0f);
                                                local_5[2u] = array<f32, 3>(0f, 0f, 0f);
                                                phi_5036_ = _e1074;
                                                phi_2241_ = type_8(0u, 3u);
                                                loop {
                                                    let _e1166 = phi_5036_;
                                                    let _e1168 = phi_2241_;
                                                    if (_e1168.member < _e1168.member_1) {
                                                        phi_2242_ = type_8((_e1168.member + 1u), _e1168.member_1);
                                                        phi_2265_ = type_8(1u, _e1168.member);
                                                    } else {
                                                        phi_2242_ = _e1168;
                                                        phi_2265_ = type_8(0u, type_8().member_1);
                                                    }
                                                    let _e1181 = phi_2242_;
                                                    let _e1183 = phi_2265_;
                                                    let _e1187 = (bitcast<i32>(_e1183.member) != 0i);
                                                    if _e1187 {
                                                        let _e1189 = ((_e612 + (_e1093.member_1 * ((3u * _e1145) + 1u))) + (_e1183.member_1 * _e1152));
                                                        let _e1190 = (_e1189 < _e101);
                                                        if _e1190 {
                                                            if _e1190 {
                                                            } else {
                                                                phi_5105_ = true;
                                                                break;
                                                            }
                                                            let _e1192 = global_10.member[_e1189];
                                                            phi_2288_ = _e1192;
                                                        } else {
                                                            phi_2288_ = 0u;
                                                        }
                                                        let _e1194 = phi_2288_;
                                                        let _e1195 = (_e1189 + 1u);
                                                        let _e1196 = (_e1195 < _e101);
                                                        if _e1196 {
                                                            if _e1196 {
                                                            } else {
                                                                phi_5105_ = true;
                                                                break;
                                                            }
                                                            let _e1198 = global_10.member[_e1195];
                                                            phi_2303_ = _e1198;
                                                        } else {
                                                            phi_2303_ = 0u;
                                                        }
                                                        let _e1200 = phi_2303_;
                                                        phi_2306_ = type_8(0u, 3u);
                                                        loop {
                                                            let _e1202 = phi_2306_;
                                                            if (_e1202.member < _e1202.member_1) {
                                                                phi_2307_ = type_8((_e1202.member + 1u), _e1202.member_1);
                                                                phi_2330_ = type_8(1u, _e1202.member);
                                                            } else {
                                                                phi_2307_ = _e1202;
                                                                phi_2330_ = type_8(0u, type_8().member_1);
                                                            }
                                                            let _e1215 = phi_2307_;
                                                            let _e1217 = phi_2330_;
                                                            let _e1221 = (bitcast<i32>(_e1217.member) != 0i);
                                                            if _e1221 {
                                                                let _e1222 = (_e1217.member_1 < 3u);
                                                                if _e1222 {
                                                                } else {
                                                                    phi_5029_ = true;
                                                                    break;
                                                                }
                                                                let _e1224 = local_4[_e1217.member_1];
                                                                if (_e1217.member_1 < 4u) {
                                                                } else {
                                                                    phi_5029_ = true;
                                                                    break;
                                                                }
                                                                let _e1227 = local_6[_e1217.member_1];
                                                                switch bitcast<i32>(_e1142) {
                                                                    case 0: {
                                                                        phi_2400_ = (_e1227 + (f32(((_e1194 >> bitcast<u32>(((10u * _e1224) & 31u))) & 1023u)) * _e157));
                                                                        break;
                                                                    }
                                                                    case 1: {
                                                                        if (_e1224 == 0u) {
                                                                            phi_2377_ = _e1194;
                                                                        } else {
                                                                            if (_e1224 == 1u) {
                                                                                phi_2376_ = ((_e1194 >> bitcast<u32>(21i)) | (_e1200 << bitcast<u32>(11i)));
                                                                            } else {
                                                                                phi_2376_ = (_e1200 >> bitcast<u32>(10i));
                                                                            }
                                                                            let _e1248 = phi_2376_;
                                                                            phi_2377_ = _e1248;
                                                                        }
                                                                        let _e1250 = phi_2377_;
                                                                        phi_2400_ = (_e1227 + (f32((_e1250 & 2097151u)) * _e157));
                                                                        break;
                                                                    }
                                                                    case 2: {
                                                                        let _e1229 = (_e1189 + _e1224);
                                                                        let _e1230 = (_e1229 < _e101);
                                                                        if _e1230 {
                                                                            if _e1230 {
                                                                            } else {
                                                                                phi_5029_ = true;
                                                                                break;
                                                                            }
                                                                            let _e1232 = global_10.member[_e1229];
                                                                            phi_2396_ = _e1232;
                                                                        } else {
                                                                            phi_2396_ = 0u;
                                                                        }
                                                                        let _e1234 = phi_2396_;
                                                                        phi_2400_ = (f32(bitcast<i32>(_e1234)) * _e157);
                                                                        break;
                                                                    }
                                                                    default: {
                                                                        phi_2400_ = f32();
                                                                        break;
                                                                    }
                                                                }
                                                                let _e1264 = phi_2400_;
                                                                if (_e1183.member_1 < 3u) {
                                                                } else {
                                                                    phi_5029_ = true;
                                                                    break;
                                                                }
                                                                if _e1222 {
                                                                } else {
                                                                    phi_5029_ = true;
                                                                    break;
                                                                }
                                                                local_5[_e1183.member_1][_e1217.member_1] = _e1264;
                                                            }
                                                            continue;
                                                            continuing {
                                                                phi_2306_ = _e1215;
                                                                phi_5029_ = _e1166;
                                                                break if !(_e1221);
                                                            }
                                                        }
                                                        let _e1270 = phi_5029_;
                                                        phi_5105_ = _e1270;
                                                        if _e1270 {
                                                            break;
                                                        }
                                                        phi_5106_ = _e1270;
                                                    } else {
                                                        phi_5106_ = _e1166;
                                                    }
                                                    let _e1272 = phi_5106_;
                                                    continue;
                                                    continuing {
                                                        phi_5036_ = _e1272;
                                                        phi_2241_ = _e1181;
                                                        phi_5105_ = _e1272;
                                                        break if !(_e1187);
                                                    }
                                                }
                                                let _e1275 = phi_5105_;
                                                phi_5107_ = _e1275;
                                                if _e1275 {
                                                    break;
                                                }
                                                let _e1276 = local_5;
                                                let _e1292 = (_e1276[0][2] - _e457);
                                                let _e1295 = (((_e1276[0][0] - _e384) * _e481) - (_e1292 * _e409));
                                                let _e1298 = (((_e1276[0][1] - _e421) * _e481) - (_e1292 * _e445));
                                                let _e1301 = (_e1276[1][2] - _e457);
                                                let _e1304 = (((_e1276[1][0] - _e384) * _e481) - (_e1301 * _e409));
                                                let _e1307 = (((_e1276[1][1] - _e421) * _e481) - (_e1301 * _e445));
                                                let _e1310 = (_e1276[2][2] - _e457);
                                                let _e1313 = (((_e1276[2][0] - _e384) * _e481) - (_e1310 * _e409));
                                                let _e1316 = (((_e1276[2][1] - _e421) * _e481) - (_e1310 * _e445));
                                                let _e1317 = (_e1313 * _e1307);
                                                let _e1318 = (_e1316 * _e1304);
                                                let _e1319 = (_e1295 * _e1316);
                                                let _e1320 = (_e1298 * _e1313);
                                                let _e1321 = (_e1304 * _e1298);
                                                let _e1322 = (_e1307 * _e1295);
                                                let _e1327 = (((_e1317 >= _e1318) && (_e1319 >= _e1320)) && (_e1321 >= _e1322));
                                                if (_e1327 || (((_e1317 <= _e1318) && (_e1319 <= _e1320)) && (_e1321 <= _e1322))) {
                                                    let _e1334 = select(-1f, 1f, _e1327);
                                                    let _e1336 = ((_e1317 - _e1318) * _e1334);
                                                    let _e1338 = select(0f, _e1336, (_e1336 > 0f));
                                                    let _e1340 = ((_e1319 - _e1320) * _e1334);
                                                    let _e1342 = select(0f, _e1340, (_e1340 > 0f));
                                                    let _e1344 = ((_e1321 - _e1322) * _e1334);
                                                    let _e1346 = select(0f, _e1344, (_e1344 > 0f));
                                                    let _e1348 = ((_e1338 + _e1342) + _e1346);
                                                    if (_e1348 < 0.000000000000000000000000000000000000011754944f) {
                                                        phi_2995_ = type_21();
                                                        phi_2996_ = true;
                                                    } else {
                                                        let _e1351 = select(_e1276[1][0], _e1276[0][0], (_e1276[0][0] < _e1276[1][0]));
                                                        let _e1355 = select(_e1276[1][0], _e1276[0][0], (_e1276[0][0] > _e1276[1][0]));
                                                        let _e1359 = select(_e1276[1][1], _e1276[0][1], (_e1276[0][1] < _e1276[1][1]));
                                                        let _e1363 = select(_e1276[1][1], _e1276[0][1], (_e1276[0][1] > _e1276[1][1]));
                                                        let _e1367 = select(_e1276[1][2], _e1276[0][2], (_e1276[0][2] < _e1276[1][2]));
                                                        let _e1371 = select(_e1276[1][2], _e1276[0][2], (_e1276[0][2] > _e1276[1][2]));
                                                        let _e1376 = ((select(_e1276[2][0], _e1351, (_e1351 < _e1276[2][0])) - _e407) * _e412);
                                                        let _e1377 = ((select(_e1276[2][0], _e1355, (_e1355 > _e1276[2][0])) - _e408) * _e412);
                                                        let _e1380 = ((select(_e1276[2][1], _e1359, (_e1359 < _e1276[2][1])) - _e443) * _e448);
                                                        let _e1381 = ((select(_e1276[2][1], _e1363, (_e1363 > _e1276[2][1])) - _e444) * _e448);
                                                        let _e1384 = ((select(_e1276[2][2], _e1367, (_e1367 < _e1276[2][2])) - _e479) * _e484);
                                                        let _e1385 = ((select(_e1276[2][2], _e1371, (_e1371 > _e1276[2][2])) - _e480) * _e484);
                                                        let _e1387 = select(_e1385, _e1384, (_e1384 < _e1385));
                                                        let _e1389 = select(_e1385, _e1384, (_e1384 > _e1385));
                                                        let _e1391 = select(_e1377, _e1376, (_e1376 < _e1377));
                                                        let _e1393 = select(_e1381, _e1380, (_e1380 < _e1381));
                                                        let _e1395 = select(_e1393, _e1391, (_e1391 > _e1393));
                                                        let _e1397 = select(_e1387, _e1395, (_e1395 > _e1387));
                                                        let _e1399 = select(_e1377, _e1376, (_e1376 > _e1377));
                                                        let _e1401 = select(_e1381, _e1380, (_e1380 > _e1381));
                                                        let _e1403 = select(_e1401, _e1399, (_e1399 < _e1401));
                                                        let _e1405 = select(_e1389, _e1403, (_e1403 < _e1389));
                                                        let _e1406 = -(_e1387);
                                                        let _e1412 = select(_e530, _e1397, (_e1397 > _e530));
                                                        if (_e1412 > (_e1405 + (select(_e1406, _e1389, (_e1389 > _e1406)) * 0.0000019073523f))) {
                                                            phi_2990_ = type_21();
                                                            phi_2991_ = true;
                                                        } else {
                                                            let _e1414 = (_e1412 > _e1076.member_1);
                                                            if _e1414 {
                                                                phi_2989_ = type_21();
                                                            } else {
                                                                let _e1418 = (_e1276[1][0] - _e1276[0][0]);
                                                                let _e1419 = (_e1276[1][1] - _e1276[0][1]);
                                                                let _e1420 = (_e1276[1][2] - _e1276[0][2]);
                                                                let _e1421 = vec3<f32>(_e1418, _e1419, _e1420);
                                                                let _e1422 = (_e1276[2][0] - _e1276[1][0]);
                                                                let _e1423 = (_e1276[2][1] - _e1276[1][1]);
                                                                let _e1424 = (_e1276[2][2] - _e1276[1][2]);
                                                                let _e1425 = vec3<f32>(_e1422, _e1423, _e1424);
                                                                let _e1426 = (_e1276[0][0] - _e1276[2][0]);
                                                                let _e1427 = (_e1276[0][1] - _e1276[2][1]);
                                                                let _e1428 = (_e1276[0][2] - _e1276[2][2]);
                                                                let _e1429 = vec3<f32>(_e1426, _e1427, _e1428);
                                                                let _e1432 = bitcast<f32>((bitcast<u32>(_e1418) & 2147483647u));
                                                                let _e1435 = bitcast<f32>((bitcast<u32>(_e1419) & 2147483647u));
                                                                let _e1437 = select(_e1435, _e1432, (_e1432 > _e1435));
                                                                let _e1440 = bitcast<f32>((bitcast<u32>(_e1420) & 2147483647u));
                                                                let _e1442 = select(_e1440, _e1437, (_e1437 > _e1440));
                                                                let _e1445 = bitcast<f32>((bitcast<u32>(_e1422) & 2147483647u));
                                                                let _e1448 = bitcast<f32>((bitcast<u32>(_e1423) & 2147483647u));
                                                                let _e1450 = select(_e1448, _e1445, (_e1445 > _e1448));
                                                                let _e1453 = bitcast<f32>((bitcast<u32>(_e1424) & 2147483647u));
                                                                let _e1455 = select(_e1453, _e1450, (_e1450 > _e1453));
                                                                let _e1458 = bitcast<f32>((bitcast<u32>(_e1426) & 2147483647u));
                                                                let _e1461 = bitcast<f32>((bitcast<u32>(_e1427) & 2147483647u));
                                                                let _e1463 = select(_e1461, _e1458, (_e1458 > _e1461));
                                                                let _e1466 = bitcast<f32>((bitcast<u32>(_e1428) & 2147483647u));
                                                                let _e1468 = select(_e1466, _e1463, (_e1463 > _e1466));
                                                                let _e1470 = select(_e1455, _e1442, (_e1442 > _e1455));
                                                                let _e1472 = select(_e1468, _e1470, (_e1470 > _e1468));
                                                                if (_e1442 == _e1472) {
                                                                    phi_2900_ = _e1425;
                                                                    phi_2901_ = _e1429;
                                                                } else {
                                                                    let _e1475 = vec3((_e1455 == _e1472));
                                                                    phi_2900_ = select(_e1421, _e1429, _e1475);
                                                                    phi_2901_ = select(_e1425, _e1421, _e1475);
                                                                }
                                                                let _e1479 = phi_2900_;
                                                                let _e1481 = phi_2901_;
                                                                let _e1488 = ((_e1479.y * _e1481.z) - (_e1481.y * _e1479.z));
                                                                let _e1493 = ((_e1479.z * _e1481.x) - (_e1481.z * _e1479.x));
                                                                let _e1496 = ((_e1479.x * _e1481.y) - (_e1481.x * _e1479.y));
                                                                if (_e1338 >= _e1342) {
                                                                    phi_2932_ = select(true, false, (_e1338 >= _e1346));
                                                                } else {
                                                                    phi_2932_ = true;
                                                                }
                                                                let _e1501 = phi_2932_;
                                                                if _e1501 {
                                                                    phi_2941_ = select(vec3<f32>(_e1276[2][0], _e1276[2][1], _e1276[2][2]), vec3<f32>(_e1276[1][0], _e1276[1][1], _e1276[1][2]), vec3((_e1342 >= _e1346)));
                                                                } else {
                                                                    phi_2941_ = vec3<f32>(_e1276[0][0], _e1276[0][1], _e1276[0][2]);
                                                                }
                                                                let _e1506 = phi_2941_;
                                                                let _e1523 = ((((_e1488 * (_e1506.x - _e384)) + (_e1493 * (_e1506.y - _e421))) + (_e1496 * (_e1506.z - _e457))) / (((_e1488 * _e409) + (_e1493 * _e445)) + (_e1496 * _e481)));
                                                                let _e1525 = select(_e1405, _e1523, (_e1523 < _e1405));
                                                                let _e1527 = select(_e1397, _e1525, (_e1525 > _e1397));
                                                                if (_e1527 >= _e530) {
                                                                    let _e1529 = (_e1527 <= _e1076.member_1);
                                                                    if _e1529 {
                                                                        let _e1530 = (1f / _e1348);
                                                                        phi_2981_ = type_21(_e1527, (_e1342 * _e1530), (_e1346 * _e1530), _e1136);
                                                                    } else {
                                                                        phi_2981_ = type_21();
                                                                    }
                                                                    let _e1535 = phi_2981_;
                                                                    phi_2983_ = _e1535;
                                                                    phi_2984_ = select(true, false, _e1529);
                                                                } else {
                                                                    phi_2983_ = type_21();
                                                                    phi_2984_ = true;
                                                                }
                                                                let _e1538 = phi_2983_;
                                                                let _e1540 = phi_2984_;
                                                                if _e1540 {
                                                                    phi_2988_ = type_21(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                } else {
                                                                    phi_2988_ = _e1538;
                                                                }
                                                                let _e1542 = phi_2988_;
                                                                phi_2989_ = _e1542;
                                                            }
                                                            let _e1544 = phi_2989_;
                                                            phi_2990_ = _e1544;
                                                            phi_2991_ = _e1414;
                                                        }
                                                        let _e1546 = phi_2990_;
                                                        let _e1548 = phi_2991_;
                                                        phi_2995_ = _e1546;
                                                        phi_2996_ = _e1548;
                                                    }
                                                    let _e1550 = phi_2995_;
                                                    let _e1552 = phi_2996_;
                                                    phi_3000_ = _e1550;
                                                    phi_3001_ = _e1552;
                                                } else {
                                                    phi_3000_ = type_21();
                                                    phi_3001_ = true;
                                                }
                                                let _e1554 = phi_3000_;
                                                let _e1556 = phi_3001_;
                                                if _e1556 {
                                                    phi_3005_ = type_21(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                } else {
                                                    phi_3005_ = _e1554;
                                                }
                                                let _e1558 = phi_3005_;
                                                if (_e1558.member_3 != 4294967295u) {
                                                    if (_e1136 == _e166) {
                                                        phi_3334_ = false;
                                                    } else {
                                                        let _e1562 = (_e1136 < arrayLength((&global_4.member)));
                                                        if _e1562 {
                                                            if _e1562 {
                                                            } else {
                                                                phi_5107_ = true;
                                                                break;
                                                            }
                                                            let _e1564 = global_4.member[_e1136];
                                                            phi_3028_ = _e1564;
                                                        } else {
                                                            phi_3028_ = 4294967295u;
                                                        }
                                                        let _e1566 = phi_3028_;
                                                        let _e1567 = (_e1566 < arrayLength((&global_5.member)));
                                                        if _e1567 {
                                                            if _e1567 {
                                                            } else {
                                                                phi_5107_ = true;
                                                                break;
                                                            }
                                                            let _e1569 = global_5.member[_e1566];
                                                            phi_3042_ = _e1569;
                                                        } else {
                                                            phi_3042_ = 0i;
                                                        }
                                                        let _e1571 = phi_3042_;
                                                        let _e1572 = (_e1571 == 0i);
                                                        if _e1572 {
                                                            phi_3333_ = true;
                                                        } else {
                                                            if _e376 {
                                                                phi_3063_ = vec3<f32>(_e1276[0][0], _e1276[0][1], _e1276[0][2]);
                                                            } else {
                                                                if (_e356 == 1u) {
                                                                    phi_3062_ = vec3<f32>(_e1276[0][2], _e1276[0][0], _e1276[0][1]);
                                                                } else {
                                                                    phi_3062_ = vec3<f32>(_e1276[0][1], _e1276[0][2], _e1276[0][0]);
                                                                }
                                                                let _e1577 = phi_3062_;
                                                                phi_3063_ = _e1577;
                                                            }
                                                            let _e1580 = phi_3063_;
                                                            if _e376 {
                                                                phi_3080_ = vec3<f32>(_e1276[1][0], _e1276[1][1], _e1276[1][2]);
                                                            } else {
                                                                if (_e356 == 1u) {
                                                                    phi_3079_ = vec3<f32>(_e1276[1][2], _e1276[1][0], _e1276[1][1]);
                                                                } else {
                                                                    phi_3079_ = vec3<f32>(_e1276[1][1], _e1276[1][2], _e1276[1][0]);
                                                                }
                                                                let _e1585 = phi_3079_;
                                                                phi_3080_ = _e1585;
                                                            }
                                                            let _e1588 = phi_3080_;
                                                            if _e376 {
                                                                phi_3097_ = vec3<f32>(_e1276[2][0], _e1276[2][1], _e1276[2][2]);
                                                            } else {
                                                                if (_e356 == 1u) {
                                                                    phi_3096_ = vec3<f32>(_e1276[2][2], _e1276[2][0], _e1276[2][1]);
                                                                } else {
                                                                    phi_3096_ = vec3<f32>(_e1276[2][1], _e1276[2][2], _e1276[2][0]);
                                                                }
                                                                let _e1593 = phi_3096_;
                                                                phi_3097_ = _e1593;
                                                            }
                                                            let _e1596 = phi_3097_;
                                                            let _e1599 = (_e1588.x - _e1580.x);
                                                            let _e1602 = (_e1588.y - _e1580.y);
                                                            let _e1605 = (_e1588.z - _e1580.z);
                                                            let _e1607 = (_e1596.x - _e1580.x);
                                                            let _e1609 = (_e1596.y - _e1580.y);
                                                            let _e1611 = (_e1596.z - _e1580.z);
                                                            if (_e234.member_1 == 1u) {
                                                                phi_3133_ = (vec3<f32>(_e234.member[0], _e234.member[1], _e234.member[2]) - _e1580);
                                                            } else {
                                                                phi_3133_ = vec3<f32>(_e234.member[0], _e234.member[1], _e234.member[2]);
                                                            }
                                                            let _e1626 = phi_3133_;
                                                            let _e1632 = bitcast<f32>((bitcast<u32>((_e1599 * _e1609)) ^ _e234.member_3[0]));
                                                            let _e1636 = bitcast<f32>((bitcast<u32>((_e1602 * _e1607)) ^ _e234.member_3[0]));
                                                            let _e1640 = bitcast<f32>((bitcast<u32>((_e1602 * _e1611)) ^ _e234.member_3[0]));
                                                            let _e1644 = bitcast<f32>((bitcast<u32>((_e1605 * _e1609)) ^ _e234.member_3[0]));
                                                            let _e1648 = bitcast<f32>((bitcast<u32>((_e1605 * _e1607)) ^ _e234.member_3[0]));
                                                            let _e1652 = bitcast<f32>((bitcast<u32>((_e1599 * _e1611)) ^ _e234.member_3[0]));
                                                            let _e1653 = (_e1640 - _e1644);
                                                            let _e1654 = (_e1648 - _e1652);
                                                            let _e1655 = (_e1632 - _e1636);
                                                            let _e1679 = (bitcast<f32>((bitcast<u32>(_e1640) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1644) & 2147483647u)));
                                                            let _e1686 = (bitcast<f32>((bitcast<u32>(_e1648) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1652) & 2147483647u)));
                                                            let _e1693 = (bitcast<f32>((bitcast<u32>(_e1632) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1636) & 2147483647u)));
                                                            if (_e234.member_2 == 0f) {
                                                                phi_3315_ = 0f;
                                                            } else {
                                                                let _e1723 = bitcast<f32>((bitcast<u32>(_e1653) & 2147483647u));
                                                                let _e1726 = bitcast<f32>((bitcast<u32>(_e1654) & 2147483647u));
                                                                let _e1729 = bitcast<f32>((bitcast<u32>(_e1655) & 2147483647u));
                                                                let _e1731 = select(_e1729, _e1726, (_e1726 > _e1729));
                                                                let _e1735 = select(_e1729, _e1726, (_e1726 < _e1729));
                                                                let _e1739 = select(_e1726, _e1723, (_e1723 < _e1726));
                                                                let _e1741 = select(_e1726, _e1723, (_e1723 > _e1726));
                                                                let _e1743 = select(_e1729, _e1741, (_e1741 < _e1729));
                                                                phi_3315_ = bitcast<f32>((bitcast<u32>((_e234.member_2 * bitcast<f32>((bitcast<u32>(((((select(_e1731, _e1723, (_e1723 > _e1731)) + bitcast<f32>((bitcast<u32>((0.414214f * select(_e1743, _e1739, (_e1739 > _e1743)))) ^ _e234.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.317838f * select(_e1735, _e1723, (_e1723 < _e1735)))) ^ _e234.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.0000004768374f * ((_e1679 + _e1686) + _e1693))) ^ _e234.member_3[0]))) * 1.0000005f)) ^ _e234.member_3[0])))) ^ _e234.member_3[0]));
                                                            }
                                                            let _e1770 = phi_3315_;
                                                            phi_3333_ = (_e1572 || !(((((bitcast<f32>((bitcast<u32>((_e1626.x * _e1653)) ^ _e234.member_3[0])) + bitcast<f32>((bitcast<u32>((_e1626.y * _e1654)) ^ _e234.member_3[0]))) + bitcast<f32>((bitcast<u32>((_e1626.z * _e1655)) ^ _e234.member_3[0]))) * f32(-(_e1571))) > ((bitcast<f32>((bitcast<u32>((0.0000009536752f * ((bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1626.x) & 2147483647u)) * _e1679)) ^ _e234.member_3[0])) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1626.y) & 2147483647u)) * _e1686)) ^ _e234.member_3[0]))) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1626.z) & 2147483647u)) * _e1693)) ^ _e234.member_3[0]))))) ^ _e234.member_3[0])) + _e1770) + 0.0000000000000000000000000000000000001880791f))));
                                                        }
                                                        let _e1784 = phi_3333_;
                                                        phi_3334_ = _e1784;
                                                    }
                                                    let _e1786 = phi_3334_;
                                                    if _e1786 {
                                                        if (_e1558.member < _e1076.member.member) {
                                                            phi_3354_ = true;
                                                        } else {
                                                            if (_e1558.member == _e1076.member.member) {
                                                                phi_3353_ = (_e1558.member_3 < _e1076.member.member_3);
                                                            } else {
                                                                phi_3353_ = false;
                                                            }
                                                            let _e1796 = phi_3353_;
                                                            phi_3354_ = _e1796;
                                                        }
                                                        let _e1798 = phi_3354_;
                                                        if _e1798 {
                                                            phi_3360_ = type_38(_e1558, _e1558.member);
                                                        } else {
                                                            phi_3360_ = _e1076;
                                                        }
                                                        let _e1801 = phi_3360_;
                                                        phi_3361_ = _e1801;
                                                    } else {
                                                        phi_3361_ = _e1076;
                                                    }
                                                    let _e1803 = phi_3361_;
                                                    phi_3362_ = _e1803;
                                                } else {
                                                    phi_3362_ = _e1076;
                                                }
                                                let _e1805 = phi_3362_;
                                                phi_5108_ = _e1275;
                                                phi_2074_ = _e1805;
                                            } else {
                                                phi_5108_ = _e1074;
                                                phi_2074_ = type_38();
                                            }
                                            let _e1807 = phi_5108_;
                                            let _e1809 = phi_2074_;
                                            continue;
                                            continuing {
                                                phi_5051_ = _e1807;
                                                phi_2073_ = _e1809;
                                                phi_2076_ = _e1091;
                                                phi_5107_ = _e1807;
                                                break if !(_e1097);
                                            }
                                        }
                                        let _e1812 = phi_5107_;
                                        phi_5186_ = _e1812;
                                        if _e1812 {
                                            break;
                                        }
                                        phi_5190_ = _e1812;
                                        let _e2050 = local_8;
                                        phi_4700_ = _e2050;
                                        phi_4701_ = _e603;
                                        phi_4702_ = false;
                                        phi_4703_ = _e607;
                                    } else {
                                        if (_e603.member_1 >= _e98) {
                                            phi_4300_ = type_62(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), type_59(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u), type_59(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u));
                                        } else {
                                            if (_e603.member_1 < _e98) {
                                            } else {
                                                phi_5186_ = true;
                                                break;
                                            }
                                            let _e621 = ((1u + (_e356 * 2u)) % 7u);
                                            if (_e621 < 7u) {
                                            } else {
                                                phi_5186_ = true;
                                                break;
                                            }
                                            let _e626 = global_9.member[_e603.member_1][_e621];
                                            let _e629 = ((1u + (_e355 * 2u)) % 7u);
                                            if (_e629 < 7u) {
                                            } else {
                                                phi_5186_ = true;
                                                break;
                                            }
                                            let _e634 = global_9.member[_e603.member_1][_e629];
                                            let _e637 = ((1u + (_e357 * 2u)) % 7u);
                                            if (_e637 < 7u) {
                                            } else {
                                                phi_5186_ = true;
                                                break;
                                            }
                                            let _e642 = global_9.member[_e603.member_1][_e637];
                                            let _e645 = (((_e356 + 1u) * 2u) % 7u);
                                            if (_e645 < 7u) {
                                            } else {
                                                phi_5186_ = true;
                                                break;
                                            }
                                            let _e650 = global_9.member[_e603.member_1][_e645];
                                            let _e653 = (((_e355 + 1u) * 2u) % 7u);
                                            if (_e653 < 7u) {
                                            } else {
                                                phi_5186_ = true;
                                                break;
                                            }
                                            let _e658 = global_9.member[_e603.member_1][_e653];
                                            let _e661 = (((_e357 + 1u) * 2u) % 7u);
                                            if (_e661 < 7u) {
                                            } else {
                                                phi_5186_ = true;
                                                break;
                                            }
                                            let _e666 = global_9.member[_e603.member_1][_e661];
                                            let _e689 = (bitcast<f32>((bitcast<u32>((_e603.member.member_1.x - _e603.member.member.x)) & 2139095040u)) * 0.0000009536743f);
                                            let _e690 = (bitcast<f32>((bitcast<u32>((_e603.member.member_1.y - _e603.member.member.y)) & 2139095040u)) * 0.0000009536743f);
                                            let _e691 = (bitcast<f32>((bitcast<u32>((_e603.member.member_1.z - _e603.member.member.z)) & 2139095040u)) * 0.0000009536743f);
                                            let _e693 = select(_e157, _e689, (_e689 > _e157));
                                            let _e695 = select(_e157, _e690, (_e690 > _e157));
                                            let _e697 = select(_e157, _e691, (_e691 > _e157));
                                            let _e722 = bitcast<u32>((f32(bitcast<i32>((_e626 & 2097151u))) * _e693));
                                            let _e727 = (bitcast<i32>((_e626 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e730 = bitcast<f32>((_e722 & bitcast<u32>(_e727)));
                                            let _e731 = bitcast<u32>((f32(bitcast<i32>((_e634 & 2097151u))) * _e695));
                                            let _e736 = (bitcast<i32>((_e634 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e739 = bitcast<f32>((_e731 & bitcast<u32>(_e736)));
                                            let _e740 = bitcast<u32>((f32(bitcast<i32>((_e642 & 2097151u))) * _e697));
                                            let _e745 = (bitcast<i32>((_e642 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e748 = bitcast<f32>((_e740 & bitcast<u32>(_e745)));
                                            let _e752 = bitcast<f32>((_e722 & bitcast<u32>(~(_e727))));
                                            let _e756 = bitcast<f32>((_e731 & bitcast<u32>(~(_e736))));
                                            let _e760 = bitcast<f32>((_e740 & bitcast<u32>(~(_e745))));
                                            let _e761 = bitcast<u32>((f32(bitcast<i32>((_e650 & 2097151u))) * _e693));
                                            let _e766 = (bitcast<i32>((_e650 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e769 = bitcast<f32>((_e761 & bitcast<u32>(_e766)));
                                            let _e770 = bitcast<u32>((f32(bitcast<i32>((_e658 & 2097151u))) * _e695));
                                            let _e775 = (bitcast<i32>((_e658 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e778 = bitcast<f32>((_e770 & bitcast<u32>(_e775)));
                                            let _e779 = bitcast<u32>((f32(bitcast<i32>((_e666 & 2097151u))) * _e697));
                                            let _e784 = (bitcast<i32>((_e666 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e787 = bitcast<f32>((_e779 & bitcast<u32>(_e784)));
                                            let _e791 = bitcast<f32>((_e761 & bitcast<u32>(~(_e766))));
                                            let _e795 = bitcast<f32>((_e770 & bitcast<u32>(~(_e775))));
                                            let _e799 = bitcast<f32>((_e779 & bitcast<u32>(~(_e784))));
                                            let _e800 = (_e603.member.member.x + _e730);
                                            let _e801 = (_e603.member.member.y + _e739);
                                            let _e802 = (_e603.member.member.z + _e748);
                                            let _e805 = (_e603.member.member_1.x - _e769);
                                            let _e806 = (_e603.member.member_1.y - _e778);
                                            let _e807 = (_e603.member.member_1.z - _e787);
                                            let _e826 = (_e805 - _e800);
                                            let _e827 = (_e806 - _e801);
                                            let _e828 = (_e807 - _e802);
                                            let _e830 = select(_e827, _e826, (_e826 > _e827));
                                            let _e832 = select(_e828, _e830, (_e830 > _e828));
                                            if (_e832 < (1024f * _e157)) {
                                                phi_4001_ = 0u;
                                            } else {
                                                phi_4001_ = select(2u, 1u, (_e832 < (2097152f * _e157)));
                                            }
                                            let _e839 = phi_4001_;
                                            switch bitcast<i32>(_e839) {
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
                                            let _e842 = phi_4007_;
                                            let _e848 = global_9.member[_e603.member_1][0u];
                                            let _e852 = global_9.member[_e603.member_1][2u];
                                            let _e856 = global_9.member[_e603.member_1][4u];
                                            let _e860 = global_9.member[_e603.member_1][6u];
                                            let _e872 = (((_e852 >> bitcast<u32>(22i)) | ((_e856 >> bitcast<u32>(22i)) << bitcast<u32>(10i))) | ((_e860 >> bitcast<u32>(22i)) << bitcast<u32>(20i)));
                                            let _e873 = (_e848 & 268435455u);
                                            let _e874 = (_e872 & 268435455u);
                                            let _e877 = ((_e848 >> bitcast<u32>(28u)) & 7u);
                                            let _e885 = ((_e848 >> bitcast<u32>(31i)) | (((_e872 >> bitcast<u32>(28u)) & 3u) << bitcast<u32>(1i)));
                                            let _e886 = (_e877 != 0u);
                                            if (_e877 == 0u) {
                                                phi_4262_ = _e873;
                                            } else {
                                                if (_e877 == 7u) {
                                                    phi_4261_ = 2147483648u;
                                                } else {
                                                    phi_4261_ = ((2147483648u | (_e877 << bitcast<u32>(28u))) | (_e874 & 268435455u));
                                                }
                                                let _e895 = phi_4261_;
                                                phi_4262_ = _e895;
                                            }
                                            let _e897 = phi_4262_;
                                            if _e886 {
                                                let _e898 = (_e877 != 7u);
                                                if _e898 {
                                                    phi_4272_ = (_e874 + (_e877 * ((3u * _e842) + 1u)));
                                                } else {
                                                    phi_4272_ = u32();
                                                }
                                                let _e902 = phi_4272_;
                                                phi_4274_ = _e902;
                                                phi_4275_ = select(true, false, _e898);
                                            } else {
                                                phi_4274_ = u32();
                                                phi_4275_ = true;
                                            }
                                            let _e905 = phi_4274_;
                                            let _e907 = phi_4275_;
                                            if (_e885 == 0u) {
                                                phi_4296_ = (_e873 + select(0u, 1u, !(_e886)));
                                            } else {
                                                if (_e885 == 7u) {
                                                    phi_4295_ = 2147483648u;
                                                } else {
                                                    phi_4295_ = ((2147483648u | (_e885 << bitcast<u32>(28u))) | (select(_e905, _e874, _e907) & 268435455u));
                                                }
                                                let _e920 = phi_4295_;
                                                phi_4296_ = _e920;
                                            }
                                            let _e922 = phi_4296_;
                                            phi_4300_ = type_62(array<vec4<f32>, 3>(vec4<f32>(_e800, (_e603.member.member.x + _e752), _e805, (_e603.member.member_1.x - _e791)), vec4<f32>(_e801, (_e603.member.member.y + _e756), _e806, (_e603.member.member_1.y - _e795)), vec4<f32>(_e802, (_e603.member.member.z + _e760), _e807, (_e603.member.member_1.z - _e799))), type_59(type_33((_e603.member.member + vec4<f32>(_e730, _e739, _e748, 0f)), (_e603.member.member_1 - vec4<f32>(_e769, _e778, _e787, 0f))), _e897), type_59(type_33((_e603.member.member + vec4<f32>(_e752, _e756, _e760, 0f)), (_e603.member.member_1 - vec4<f32>(_e791, _e795, _e799, 0f))), _e922));
                                        }
                                        let _e927 = phi_4300_;
                                        let _e939 = ((_e927.member[0].x - _e407) * _e412);
                                        let _e940 = ((_e927.member[0].y - _e407) * _e412);
                                        let _e941 = ((_e927.member[0].z - _e408) * _e412);
                                        let _e942 = ((_e927.member[0].w - _e408) * _e412);
                                        let _e952 = ((_e927.member[1].x - _e443) * _e448);
                                        let _e953 = ((_e927.member[1].y - _e443) * _e448);
                                        let _e954 = ((_e927.member[1].z - _e444) * _e448);
                                        let _e955 = ((_e927.member[1].w - _e444) * _e448);
                                        let _e965 = ((_e927.member[2].x - _e479) * _e484);
                                        let _e966 = ((_e927.member[2].y - _e479) * _e484);
                                        let _e967 = ((_e927.member[2].z - _e480) * _e484);
                                        let _e968 = ((_e927.member[2].w - _e480) * _e484);
                                        let _e970 = select(_e967, _e965, (_e965 < _e967));
                                        let _e972 = select(_e968, _e966, (_e966 < _e968));
                                        let _e974 = select(_e967, _e965, (_e965 > _e967));
                                        let _e976 = select(_e968, _e966, (_e966 > _e968));
                                        let _e978 = select(_e941, _e939, (_e939 < _e941));
                                        let _e980 = select(_e942, _e940, (_e940 < _e942));
                                        let _e982 = select(_e954, _e952, (_e952 < _e954));
                                        let _e984 = select(_e955, _e953, (_e953 < _e955));
                                        let _e986 = select(_e982, _e978, (_e978 > _e982));
                                        let _e988 = select(_e984, _e980, (_e980 > _e984));
                                        let _e990 = select(_e970, _e986, (_e986 > _e970));
                                        let _e992 = select(_e972, _e988, (_e988 > _e972));
                                        let _e994 = select(_e941, _e939, (_e939 > _e941));
                                        let _e996 = select(_e942, _e940, (_e940 > _e942));
                                        let _e998 = select(_e954, _e952, (_e952 > _e954));
                                        let _e1000 = select(_e955, _e953, (_e953 > _e955));
                                        let _e1002 = select(_e998, _e994, (_e994 < _e998));
                                        let _e1004 = select(_e1000, _e996, (_e996 < _e1000));
                                        let _e1009 = -(_e970);
                                        let _e1010 = -(_e972);
                                        let _e1017 = (select(_e974, _e1002, (_e1002 < _e974)) + (select(_e1009, _e974, (_e974 > _e1009)) * 0.0000019073523f));
                                        let _e1018 = (select(_e976, _e1004, (_e1004 < _e976)) + (select(_e1010, _e976, (_e976 > _e1010)) * 0.0000019073523f));
                                        let _e1020 = select(_e530, _e990, (_e990 > _e530));
                                        let _e1022 = select(_e530, _e992, (_e992 > _e530));
                                        let _e1027 = (_e1020 <= select(_e574.member_1, _e1017, (_e1017 < _e574.member_1)));
                                        let _e1028 = (_e1022 <= select(_e574.member_1, _e1018, (_e1018 < _e574.member_1)));
                                        let _e1029 = (_e1020 <= _e1022);
                                        if _e1027 {
                                            if _e1028 {
                                                if _e1029 {
                                                    phi_4644_ = _e927.member_2;
                                                } else {
                                                    phi_4644_ = _e927.member_1;
                                                }
                                                let _e1033 = phi_4644_;
                                                let _e1034 = (_e607 % 128u);
                                                let _e1035 = (_e1034 < 128u);
                                                if _e1035 {
                                                } else {
                                                    phi_5186_ = true;
                                                    break;
                                                }
                                                local_3[_e1034] = type_59(type_33(_e1033.member.member, _e1033.member.member_1), _e1033.member_1);
                                                if _e1035 {
                                                } else {
                                                    phi_5186_ = true;
                                                    break;
                                                }
                                                local_2[_e1034] = select(_e1022, _e1020, (_e1020 > _e1022));
                                                if _e1029 {
                                                    phi_4677_ = _e927.member_1;
                                                } else {
                                                    phi_4677_ = _e927.member_2;
                                                }
                                                let _e1050 = phi_4677_;
                                                phi_4678_ = _e1050;
                                                phi_4679_ = (_e607 + 1u);
                                            } else {
                                                phi_4678_ = type_59();
                                                phi_4679_ = u32();
                                            }
                                            let _e1052 = phi_4678_;
                                            let _e1054 = phi_4679_;
                                            phi_4681_ = _e1052;
                                            phi_4682_ = _e1054;
                                            phi_4683_ = select(true, false, _e1028);
                                        } else {
                                            phi_4681_ = type_59();
                                            phi_4682_ = u32();
                                            phi_4683_ = true;
                                        }
                                        let _e1057 = phi_4681_;
                                        let _e1059 = phi_4682_;
                                        let _e1061 = phi_4683_;
                                        if _e1061 {
                                            if _e1027 {
                                                phi_4692_ = _e927.member_1;
                                            } else {
                                                phi_4692_ = _e927.member_2;
                                            }
                                            let _e1065 = phi_4692_;
                                            phi_4697_ = _e1065;
                                            phi_4698_ = select(_e1028, true, _e1027);
                                        } else {
                                            phi_4697_ = _e1057;
                                            phi_4698_ = _e605;
                                        }
                                        let _e1068 = phi_4697_;
                                        let _e1070 = phi_4698_;
                                        phi_5190_ = _e572;
                                        phi_4700_ = _e574;
                                        phi_4701_ = _e1068;
                                        phi_4702_ = _e1070;
                                        phi_4703_ = select(_e1059, _e607, _e1061);
                                    }
                                    let _e1814 = phi_5190_;
                                    let _e1816 = phi_4700_;
                                    let _e1818 = phi_4701_;
                                    let _e1820 = phi_4702_;
                                    let _e1822 = phi_4703_;
                                    phi_5189_ = _e1814;
                                    phi_4704_ = _e1816;
                                    phi_4705_ = _e1818;
                                    phi_4706_ = (_e578 - 1u);
                                    phi_4707_ = _e1820;
                                    phi_4708_ = _e1822;
                                } else {
                                    phi_5189_ = _e572;
                                    phi_4704_ = _e574;
                                    phi_4705_ = _e603;
                                    phi_4706_ = _e578;
                                    phi_4707_ = _e605;
                                    phi_4708_ = _e607;
                                }
                                let _e1824 = phi_5189_;
                                let _e1826 = phi_4704_;
                                let _e1828 = phi_4705_;
                                let _e1830 = phi_4706_;
                                let _e1832 = phi_4707_;
                                let _e1834 = phi_4708_;
                                phi_5188_ = _e1824;
                                phi_4709_ = _e1826;
                                phi_4710_ = _e1828;
                                phi_4711_ = _e1830;
                                phi_4712_ = _e1832;
                                phi_4713_ = _e1834;
                            } else {
                                phi_5188_ = _e572;
                                phi_4709_ = type_38();
                                phi_4710_ = type_59();
                                phi_4711_ = u32();
                                phi_4712_ = bool();
                                phi_4713_ = u32();
                            }
                            let _e1836 = phi_5188_;
                            let _e1838 = phi_4709_;
                            let _e1840 = phi_4710_;
                            let _e1842 = phi_4711_;
                            let _e1844 = phi_4712_;
                            let _e1846 = phi_4713_;
                            phi_5187_ = _e1836;
                            phi_1996_ = _e1838;
                            phi_1999_ = _e1840;
                            phi_2001_ = _e1842;
                            phi_2003_ = _e1844;
                            phi_2005_ = _e1846;
                            phi_4714_ = _e586;
                        } else {
                            phi_5187_ = _e572;
                            phi_1996_ = type_38();
                            phi_1999_ = type_59();
                            phi_2001_ = u32();
                            phi_2003_ = bool();
                            phi_2005_ = u32();
                            phi_4714_ = false;
                        }
                        let _e1848 = phi_5187_;
                        let _e1850 = phi_1996_;
                        let _e1852 = phi_1999_;
                        let _e1854 = phi_2001_;
                        let _e1856 = phi_2003_;
                        let _e1858 = phi_2005_;
                        let _e1860 = phi_4714_;
                        continue;
                        continuing {
                            phi_5054_ = _e1848;
                            phi_1995_ = _e1850;
                            phi_1998_ = _e1852;
                            phi_2000_ = _e1854;
                            phi_2002_ = _e1856;
                            phi_2004_ = _e1858;
                            phi_5186_ = _e1848;
                            break if !(_e1860);
                        }
                    }
                    let _e1863 = phi_5186_;
                    if _e1863 {
                        break;
                    }
                    let _e1865 = local_7;
                    if (_e1865.member.member_3 != 4294967295u) {
                        let _e1870 = (_e358 / 3i);
                        let _e1877 = bitcast<f32>((bitcast<u32>((_e1870 + 127i)) << bitcast<u32>(23i)));
                        let _e1885 = (((_e1865.member.member * _e1877) * _e1877) * bitcast<f32>((bitcast<u32>(((_e358 - (2i * _e1870)) + 127i)) << bitcast<u32>(23i))));
                        let _e1887 = select(340282350000000000000000000000000000000f, _e1885, (_e1885 < 340282350000000000000000000000000000000f));
                        phi_4766_ = type_21(select(-340282350000000000000000000000000000000f, _e1887, (_e1887 > -340282350000000000000000000000000000000f)), _e1865.member.member_1, _e1865.member.member_2, _e1865.member.member_3);
                    } else {
                        phi_4766_ = type_21(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                    }
                    let _e1894 = phi_4766_;
                    if _e235 {
                    } else {
                        break;
                    }
                    global_7.member[_e145] = _e1894;
                    if _e160 {
                    } else {
                        break;
                    }
                    let _e1898 = select(0u, 1u, (_e302 <= _e312));
                    if (_e1898 > 0u) {
                        let _e1900 = (1u < _e113);
                        if _e1900 {
                            if (0u < _e113) {
                            } else {
                                break;
                            }
                            let _e1904 = atomicAdd((&global_8.member[0u]), _e1898);
                            if ((_e1904 + _e1898) < _e1904) {
                                if _e1900 {
                                } else {
                                    break;
                                }
                                let _e1909 = atomicAdd((&global_8.member[1u]), 1u);
                            }
                        }
                    }
                    let _e1912 = select(0u, 1u, (_e1894.member_3 != 4294967295u));
                    if (_e1912 > 0u) {
                        let _e1914 = (3u < _e113);
                        if _e1914 {
                            if (2u < _e113) {
                            } else {
                                break;
                            }
                            let _e1918 = atomicAdd((&global_8.member[2u]), _e1912);
                            if ((_e1918 + _e1912) < _e1918) {
                                if _e1914 {
                                } else {
                                    break;
                                }
                                let _e1923 = atomicAdd((&global_8.member[3u]), 1u);
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
