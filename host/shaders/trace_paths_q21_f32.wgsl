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

struct type_18 {
    member: array<f32, 9>,
    member_1: u32,
}

struct type_20 {
    member: array<type_18>,
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

struct type_39 {
    member: array<f32, 3>,
    member_1: u32,
    member_2: f32,
    member_3: array<u32, 3>,
}

struct type_41 {
    member: type_25,
    member_1: f32,
}

struct type_46 {
    member: array<vec4<u32>, 2>,
}

struct type_49 {
    member: array<i32>,
}

struct type_58 {
    member: array<array<u32, 7>>,
}

struct type_60 {
    member: type_37,
    member_1: u32,
}

struct type_63 {
    member: array<vec4<f32>, 3>,
    member_1: type_60,
    member_2: type_60,
}

struct type_68 {
    member: array<atomic<u32>>,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_1: type_12;
@group(0) @binding(1) 
var<uniform> global_2: type_46;
@group(0) @binding(2) 
var<uniform> global_3: type_46;
@group(0) @binding(4) 
var<storage> global_4: type_20;
@group(0) @binding(5) 
var<storage> global_5: type_4;
@group(0) @binding(6) 
var<storage> global_6: type_49;
@group(0) @binding(7) 
var<storage> global_7: type_32;
@group(0) @binding(8) 
var<storage, read_write> global_8: type_27;
@group(0) @binding(9) 
var<storage, read_write> global_9: type_68;
@group(0) @binding(3) 
var<storage> global_10: type_58;

fn function_() {
    var local: array<i32, 3>;
    var local_1: array<i32, 3>;
    var local_2: array<f32, 128>;
    var local_3: array<type_60, 128>;
    var phi_323_: u32;
    var phi_367_: i32;
    var phi_391_: type_39;
    var phi_497_: i32;
    var phi_498_: i32;
    var phi_508_: bool;
    var phi_518_: u32;
    var phi_519_: u32;
    var phi_521_: bool;
    var phi_526_: u32;
    var phi_559_: i32;
    var phi_577_: f32;
    var phi_583_: f32;
    var phi_594_: f32;
    var phi_600_: f32;
    var phi_623_: f32;
    var phi_634_: f32;
    var phi_643_: f32;
    var phi_649_: f32;
    var phi_660_: f32;
    var phi_666_: f32;
    var phi_689_: f32;
    var phi_700_: f32;
    var phi_709_: f32;
    var phi_715_: f32;
    var phi_726_: f32;
    var phi_732_: f32;
    var phi_755_: f32;
    var phi_766_: f32;
    var phi_866_: f32;
    var phi_867_: f32;
    var phi_4767_: bool;
    var phi_1987_: type_41;
    var phi_1990_: type_60;
    var phi_1992_: u32;
    var phi_1994_: bool;
    var phi_1996_: u32;
    var phi_2007_: bool;
    var phi_2044_: type_60;
    var phi_2045_: bool;
    var phi_2046_: u32;
    var phi_3997_: u32;
    var phi_3998_: u32;
    var phi_4008_: u32;
    var phi_4010_: u32;
    var phi_4011_: bool;
    var phi_4031_: u32;
    var phi_4032_: u32;
    var phi_4036_: type_63;
    var phi_4380_: type_60;
    var phi_4413_: type_60;
    var phi_4414_: type_60;
    var phi_4415_: u32;
    var phi_4417_: type_60;
    var phi_4418_: u32;
    var phi_4419_: bool;
    var phi_4428_: type_60;
    var phi_4433_: type_60;
    var phi_4434_: bool;
    var phi_2064_: type_41;
    var phi_2067_: type_8;
    var phi_2068_: type_8;
    var phi_2090_: type_8;
    var phi_2111_: u32;
    var phi_2200_: array<array<f32, 3>, 3>;
    var phi_2671_: vec3<f32>;
    var phi_2672_: vec3<f32>;
    var phi_2703_: bool;
    var phi_2712_: vec3<f32>;
    var phi_2752_: type_25;
    var phi_2754_: type_25;
    var phi_2755_: bool;
    var phi_2759_: type_25;
    var phi_2760_: type_25;
    var phi_2761_: type_25;
    var phi_2762_: bool;
    var phi_2766_: type_25;
    var phi_2767_: bool;
    var phi_2771_: type_25;
    var phi_2772_: bool;
    var phi_2776_: type_25;
    var phi_2799_: u32;
    var phi_2813_: i32;
    var phi_2833_: vec3<f32>;
    var phi_2834_: vec3<f32>;
    var phi_2850_: vec3<f32>;
    var phi_2851_: vec3<f32>;
    var phi_2867_: vec3<f32>;
    var phi_2868_: vec3<f32>;
    var phi_2904_: vec3<f32>;
    var phi_3086_: f32;
    var phi_3104_: bool;
    var phi_3105_: bool;
    var phi_3124_: bool;
    var phi_3125_: bool;
    var phi_3131_: type_41;
    var phi_3132_: type_41;
    var phi_3133_: type_41;
    var phi_2065_: type_41;
    var phi_4761_: bool;
    var phi_4903_: bool;
    var phi_4436_: type_41;
    var phi_4437_: type_60;
    var phi_4438_: bool;
    var phi_4439_: u32;
    var phi_4902_: bool;
    var phi_4440_: type_41;
    var phi_4441_: type_60;
    var phi_4442_: u32;
    var phi_4443_: bool;
    var phi_4444_: u32;
    var phi_4901_: bool;
    var phi_4445_: type_41;
    var phi_4446_: type_60;
    var phi_4447_: u32;
    var phi_4448_: bool;
    var phi_4449_: u32;
    var phi_4900_: bool;
    var phi_1988_: type_41;
    var phi_1991_: type_60;
    var phi_1993_: u32;
    var phi_1995_: bool;
    var phi_1997_: u32;
    var phi_4450_: bool;
    var phi_4899_: bool;
    var local_4: type_41;
    var phi_4502_: type_25;
    var local_5: type_41;

    switch bitcast<i32>(0u) {
        default: {
            let _e88 = global;
            let _e90 = arrayLength((&global_10.member));
            let _e92 = arrayLength((&global_4.member));
            let _e104 = arrayLength((&global_9.member));
            let _e108 = global_3.member[0u][0u];
            let _e112 = global_3.member[0u][1u];
            let _e116 = global_3.member[0u][2u];
            let _e120 = global_3.member[0u][3u];
            let _e124 = global_3.member[1u][0u];
            let _e128 = global_3.member[1u][1u];
            let _e132 = global_3.member[1u][2u];
            let _e136 = (_e88.x + (_e88.y * 2097152u));
            let _e148 = bitcast<f32>((bitcast<u32>((bitcast<i32>(_e120) + 127i)) << bitcast<u32>(23i)));
            local_1 = array<i32, 3>(bitcast<i32>(_e108), bitcast<i32>(_e112), bitcast<i32>(_e116));
            local = array<i32, 3>(bitcast<i32>(_e124), bitcast<i32>(_e128), bitcast<i32>(_e132));
            let _e151 = (_e136 < arrayLength((&global_7.member)));
            if _e151 {
                if _e151 {
                } else {
                    break;
                }
                let _e155 = global_7.member[_e136].member_2;
                phi_323_ = _e155;
            } else {
                phi_323_ = 4294967295u;
            }
            let _e157 = phi_323_;
            let _e160 = global_1.member[0u];
            let _e164 = global_2.member[0u][0u];
            let _e168 = global_2.member[0u][1u];
            let _e172 = global_2.member[0u][2u];
            let _e176 = global_2.member[0u][3u];
            let _e180 = global_2.member[1u][0u];
            let _e184 = global_2.member[1u][1u];
            let _e188 = global_2.member[1u][2u];
            let _e192 = global_2.member[1u][3u];
            let _e193 = bitcast<f32>(_e164);
            let _e194 = bitcast<f32>(_e168);
            let _e195 = bitcast<f32>(_e172);
            let _e197 = bitcast<f32>(_e180);
            let _e198 = array<u32, 3>(_e184, _e188, _e192);
            let _e200 = bitcast<i32>(_e160);
            if (_e200 < -126i) {
                phi_367_ = -126i;
            } else {
                phi_367_ = select(_e200, 127i, (_e200 > 127i));
            }
            let _e205 = phi_367_;
            let _e210 = bitcast<f32>((bitcast<u32>((_e205 + 127i)) << bitcast<u32>(23i)));
            let _e216 = bitcast<f32>((bitcast<u32>(((_e200 - _e205) + 127i)) << bitcast<u32>(23i)));
            if (_e176 == 0u) {
                phi_391_ = type_39(array<f32, 3>(_e193, _e194, _e195), _e176, _e197, _e198);
            } else {
                phi_391_ = type_39(array<f32, 3>(((_e193 * _e210) * _e216), ((_e194 * _e210) * _e216), ((_e195 * _e210) * _e216)), _e176, ((_e197 * _e210) * _e216), _e198);
            }
            let _e229 = phi_391_;
            if _e151 {
                let _e230 = (_e136 < arrayLength((&global_8.member)));
                if _e230 {
                    if _e151 {
                    } else {
                        break;
                    }
                    let _e240 = global_7.member[_e136].member.member_2[0u];
                    let _e242 = (bitcast<u32>(_e240) & 2147483647u);
                    let _e248 = global_7.member[_e136].member.member_2[1u];
                    let _e250 = (bitcast<u32>(_e248) & 2147483647u);
                    let _e256 = global_7.member[_e136].member.member_2[2u];
                    let _e258 = (bitcast<u32>(_e256) & 2147483647u);
                    let _e264 = global_7.member[_e136].member.member[0u];
                    let _e266 = (bitcast<u32>(_e264) & 2147483647u);
                    let _e272 = global_7.member[_e136].member.member[1u];
                    let _e274 = (bitcast<u32>(_e272) & 2147483647u);
                    let _e280 = global_7.member[_e136].member.member[2u];
                    let _e282 = (bitcast<u32>(_e280) & 2147483647u);
                    let _e284 = select(_e250, _e242, (_e250 < _e242));
                    let _e286 = select(_e258, _e284, (_e258 < _e284));
                    let _e288 = select(_e266, _e286, (_e266 < _e286));
                    let _e290 = select(_e274, _e288, (_e274 < _e288));
                    let _e292 = select(_e282, _e290, (_e282 < _e290));
                    let _e297 = global_7.member[_e136].member.member_1;
                    let _e299 = (bitcast<u32>(_e297) & 2147483647u);
                    let _e307 = global_7.member[_e136].member.member_3;
                    let _e313 = (((select(_e299, _e292, (_e299 < _e292)) < 2139095040u) && ((bitcast<u32>(_e307) & 2147483647u) <= 2139095040u)) && (_e286 > 0u));
                    if _e313 {
                        let _e316 = (bitcast<u32>(bitcast<f32>(_e286)) & 2147483647u);
                        if (_e316 >= 8388608u) {
                            phi_497_ = (bitcast<i32>((_e316 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_497_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e316)), 32u, (_e316 == 0u))));
                        }
                        let _e330 = phi_497_;
                        phi_498_ = _e330;
                    } else {
                        phi_498_ = 0i;
                    }
                    let _e332 = phi_498_;
                    let _e333 = (_e242 == _e286);
                    if _e333 {
                        phi_508_ = true;
                    } else {
                        phi_508_ = (_e250 == _e286);
                    }
                    let _e336 = phi_508_;
                    let _e337 = select(1u, 0u, _e333);
                    if _e336 {
                        let _e338 = (_e337 + 1u);
                        phi_518_ = _e338;
                        phi_519_ = _e338;
                        phi_521_ = select(true, false, (_e338 == 2u));
                    } else {
                        phi_518_ = u32();
                        phi_519_ = 0u;
                        phi_521_ = true;
                    }
                    let _e342 = phi_518_;
                    let _e344 = phi_519_;
                    let _e346 = phi_521_;
                    if _e346 {
                        phi_526_ = (_e344 + 1u);
                    } else {
                        phi_526_ = 0u;
                    }
                    let _e350 = phi_526_;
                    let _e351 = select(_e342, _e344, _e346);
                    let _e352 = select(_e337, select(2u, _e337, _e336), _e346);
                    let _e353 = -(_e332);
                    if (_e353 < -126i) {
                        phi_559_ = -126i;
                    } else {
                        phi_559_ = select(_e353, 127i, (_e353 > 127i));
                    }
                    let _e358 = phi_559_;
                    let _e363 = bitcast<f32>((bitcast<u32>((_e358 + 127i)) << bitcast<u32>(23i)));
                    let _e369 = bitcast<f32>((bitcast<u32>(((_e353 - _e358) + 127i)) << bitcast<u32>(23i)));
                    let _e374 = global_7.member[_e136].member.member;
                    let _e375 = (_e351 == 0u);
                    if _e375 {
                        phi_577_ = _e374[0];
                    } else {
                        phi_577_ = _e374[1];
                    }
                    let _e379 = phi_577_;
                    let _e380 = (_e351 == 2u);
                    if _e380 {
                        phi_583_ = _e374[2];
                    } else {
                        phi_583_ = _e379;
                    }
                    let _e383 = phi_583_;
                    let _e384 = global_7.member[_e136].member.member_2;
                    if _e375 {
                        phi_594_ = _e384[0];
                    } else {
                        phi_594_ = _e384[1];
                    }
                    let _e388 = phi_594_;
                    if _e380 {
                        phi_600_ = _e384[2];
                    } else {
                        phi_600_ = _e388;
                    }
                    let _e391 = phi_600_;
                    let _e393 = ((_e391 * _e363) * _e369);
                    let _e397 = (bitcast<f32>((bitcast<u32>(_e393) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e397 {
                        let _e401 = (bitcast<f32>((bitcast<u32>(_e383) & 2147483647u)) * 0.00000011920929f);
                        phi_623_ = select(0.00000000000011368684f, _e401, (_e401 > 0.00000000000011368684f));
                    } else {
                        phi_623_ = 0f;
                    }
                    let _e405 = phi_623_;
                    let _e406 = (_e383 + _e405);
                    let _e407 = (_e383 - _e405);
                    let _e408 = select(_e393, 0f, _e397);
                    if _e397 {
                        phi_634_ = 38685626000000000000000000f;
                    } else {
                        phi_634_ = (1f / _e393);
                    }
                    let _e411 = phi_634_;
                    let _e412 = (_e350 == 0u);
                    if _e412 {
                        phi_643_ = _e374[0];
                    } else {
                        phi_643_ = _e374[1];
                    }
                    let _e416 = phi_643_;
                    let _e417 = (_e350 == 2u);
                    if _e417 {
                        phi_649_ = _e374[2];
                    } else {
                        phi_649_ = _e416;
                    }
                    let _e420 = phi_649_;
                    if _e412 {
                        phi_660_ = _e384[0];
                    } else {
                        phi_660_ = _e384[1];
                    }
                    let _e424 = phi_660_;
                    if _e417 {
                        phi_666_ = _e384[2];
                    } else {
                        phi_666_ = _e424;
                    }
                    let _e427 = phi_666_;
                    let _e429 = ((_e427 * _e363) * _e369);
                    let _e433 = (bitcast<f32>((bitcast<u32>(_e429) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e433 {
                        let _e437 = (bitcast<f32>((bitcast<u32>(_e420) & 2147483647u)) * 0.00000011920929f);
                        phi_689_ = select(0.00000000000011368684f, _e437, (_e437 > 0.00000000000011368684f));
                    } else {
                        phi_689_ = 0f;
                    }
                    let _e441 = phi_689_;
                    let _e442 = (_e420 + _e441);
                    let _e443 = (_e420 - _e441);
                    let _e444 = select(_e429, 0f, _e433);
                    if _e433 {
                        phi_700_ = 38685626000000000000000000f;
                    } else {
                        phi_700_ = (1f / _e429);
                    }
                    let _e447 = phi_700_;
                    let _e448 = (_e352 == 0u);
                    if _e448 {
                        phi_709_ = _e374[0];
                    } else {
                        phi_709_ = _e374[1];
                    }
                    let _e452 = phi_709_;
                    let _e453 = (_e352 == 2u);
                    if _e453 {
                        phi_715_ = _e374[2];
                    } else {
                        phi_715_ = _e452;
                    }
                    let _e456 = phi_715_;
                    if _e448 {
                        phi_726_ = _e384[0];
                    } else {
                        phi_726_ = _e384[1];
                    }
                    let _e460 = phi_726_;
                    if _e453 {
                        phi_732_ = _e384[2];
                    } else {
                        phi_732_ = _e460;
                    }
                    let _e463 = phi_732_;
                    let _e465 = ((_e463 * _e363) * _e369);
                    let _e469 = (bitcast<f32>((bitcast<u32>(_e465) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e469 {
                        let _e473 = (bitcast<f32>((bitcast<u32>(_e456) & 2147483647u)) * 0.00000011920929f);
                        phi_755_ = select(0.00000000000011368684f, _e473, (_e473 > 0.00000000000011368684f));
                    } else {
                        phi_755_ = 0f;
                    }
                    let _e477 = phi_755_;
                    let _e478 = (_e456 + _e477);
                    let _e479 = (_e456 - _e477);
                    let _e480 = select(_e465, 0f, _e469);
                    if _e469 {
                        phi_766_ = 38685626000000000000000000f;
                    } else {
                        phi_766_ = (1f / _e465);
                    }
                    let _e483 = phi_766_;
                    let _e486 = bitcast<f32>((bitcast<u32>(_e383) & 2147483647u));
                    let _e489 = bitcast<f32>((bitcast<u32>(_e420) & 2147483647u));
                    let _e491 = select(_e489, _e486, (_e486 > _e489));
                    let _e494 = bitcast<f32>((bitcast<u32>(_e456) & 2147483647u));
                    if (_e313 && (select(_e494, _e491, (_e491 > _e494)) <= 1099511600000f)) {
                        let _e499 = (_e332 / 3i);
                        let _e506 = bitcast<f32>((bitcast<u32>((_e499 + 127i)) << bitcast<u32>(23i)));
                        let _e513 = bitcast<f32>((bitcast<u32>(((_e332 - (2i * _e499)) + 127i)) << bitcast<u32>(23i)));
                        let _e514 = (((_e297 * _e506) * _e506) * _e513);
                        let _e516 = select(340282350000000000000000000000000000000f, _e514, (_e514 < 340282350000000000000000000000000000000f));
                        let _e521 = (((_e307 * _e506) * _e506) * _e513);
                        let _e523 = select(340282350000000000000000000000000000000f, _e521, (_e521 < 340282350000000000000000000000000000000f));
                        phi_866_ = select(-340282350000000000000000000000000000000f, _e523, (_e523 > -340282350000000000000000000000000000000f));
                        phi_867_ = select(-340282350000000000000000000000000000000f, _e516, (_e516 > -340282350000000000000000000000000000000f));
                    } else {
                        phi_866_ = 0f;
                        phi_867_ = 1f;
                    }
                    let _e527 = phi_866_;
                    let _e529 = phi_867_;
                    local_3 = array<type_60, 128>(type_60(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u));
                    local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    let _e533 = (_e351 % 3u);
                    let _e534 = (_e533 < 3u);
                    if _e534 {
                    } else {
                        break;
                    }
                    let _e536 = local_1[_e533];
                    let _e539 = (_e350 % 3u);
                    let _e540 = (_e539 < 3u);
                    if _e540 {
                    } else {
                        break;
                    }
                    let _e542 = local_1[_e539];
                    let _e545 = (_e352 % 3u);
                    let _e546 = (_e545 < 3u);
                    if _e546 {
                    } else {
                        break;
                    }
                    let _e548 = local_1[_e545];
                    if _e534 {
                    } else {
                        break;
                    }
                    let _e553 = local[_e533];
                    if _e540 {
                    } else {
                        break;
                    }
                    let _e557 = local[_e539];
                    if _e546 {
                    } else {
                        break;
                    }
                    let _e561 = local[_e545];
                    phi_4767_ = false;
                    phi_1987_ = type_41(type_25(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e527);
                    phi_1990_ = type_60(type_37(vec4<f32>((f32(_e536) * _e148), (f32(_e542) * _e148), (f32(_e548) * _e148), 0f), vec4<f32>((f32(_e553) * _e148), (f32(_e557) * _e148), (f32(_e561) * _e148), 0f)), select(0u, 2147483648u, (_e90 == 0u)));
                    phi_1992_ = ((3u * _e90) + 1u);
                    phi_1994_ = (_e529 <= _e527);
                    phi_1996_ = 0u;
                    loop {
                        let _e571 = phi_4767_;
                        let _e573 = phi_1987_;
                        let _e575 = phi_1990_;
                        let _e577 = phi_1992_;
                        let _e579 = phi_1994_;
                        let _e581 = phi_1996_;
                        local_4 = _e573;
                        if _e579 {
                            phi_2007_ = true;
                        } else {
                            phi_2007_ = (_e581 > 0u);
                        }
                        let _e584 = phi_2007_;
                        if _e584 {
                            let _e585 = (_e577 > 0u);
                            if _e585 {
                                if _e579 {
                                    phi_2044_ = _e575;
                                    phi_2045_ = _e579;
                                    phi_2046_ = _e581;
                                } else {
                                    let _e586 = (_e581 - 1u);
                                    let _e587 = (_e586 % 128u);
                                    let _e588 = (_e587 < 128u);
                                    if _e588 {
                                    } else {
                                        phi_4899_ = true;
                                        break;
                                    }
                                    let _e590 = local_3[_e587];
                                    if _e588 {
                                    } else {
                                        phi_4899_ = true;
                                        break;
                                    }
                                    let _e598 = local_2[_e587];
                                    phi_2044_ = type_60(type_37(_e590.member.member, _e590.member.member_1), _e590.member_1);
                                    phi_2045_ = (_e598 <= _e573.member_1);
                                    phi_2046_ = _e586;
                                }
                                let _e602 = phi_2044_;
                                let _e604 = phi_2045_;
                                let _e606 = phi_2046_;
                                if _e604 {
                                    if ((_e602.member_1 & 2147483648u) != 0u) {
                                        phi_2064_ = _e573;
                                        phi_2067_ = type_8(0u, ((_e602.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e1052 = phi_2064_;
                                            let _e1054 = phi_2067_;
                                            local_5 = _e1052;
                                            if (_e1054.member < _e1054.member_1) {
                                                phi_2068_ = type_8((_e1054.member + 1u), _e1054.member_1);
                                                phi_2090_ = type_8(1u, _e1054.member);
                                            } else {
                                                phi_2068_ = _e1054;
                                                phi_2090_ = type_8(0u, type_8().member_1);
                                            }
                                            let _e1067 = phi_2068_;
                                            let _e1069 = phi_2090_;
                                            let _e1073 = (bitcast<i32>(_e1069.member) != 0i);
                                            if _e1073 {
                                                let _e1074 = ((_e602.member_1 & 268435455u) + _e1069.member_1);
                                                let _e1075 = (_e1074 < _e92);
                                                if _e1075 {
                                                    if _e1075 {
                                                    } else {
                                                        phi_4761_ = true;
                                                        break;
                                                    }
                                                    let _e1079 = global_4.member[_e1074].member_1;
                                                    phi_2111_ = _e1079;
                                                } else {
                                                    phi_2111_ = 4294967295u;
                                                }
                                                let _e1081 = phi_2111_;
                                                if (_e1074 >= _e92) {
                                                    phi_2200_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                } else {
                                                    if _e1075 {
                                                    } else {
                                                        phi_4761_ = true;
                                                        break;
                                                    }
                                                    if (_e533 < 9u) {
                                                    } else {
                                                        phi_4761_ = true;
                                                        break;
                                                    }
                                                    let _e1088 = global_4.member[_e1074].member[_e533];
                                                    if (_e539 < 9u) {
                                                    } else {
                                                        phi_4761_ = true;
                                                        break;
                                                    }
                                                    let _e1094 = global_4.member[_e1074].member[_e539];
                                                    if (_e545 < 9u) {
                                                    } else {
                                                        phi_4761_ = true;
                                                        break;
                                                    }
                                                    let _e1100 = global_4.member[_e1074].member[_e545];
                                                    let _e1102 = (3u + _e533);
                                                    if (_e1102 < 9u) {
                                                    } else {
                                                        phi_4761_ = true;
                                                        break;
                                                    }
                                                    let _e1108 = global_4.member[_e1074].member[_e1102];
                                                    let _e1109 = (3u + _e539);
                                                    if (_e1109 < 9u) {
                                                    } else {
                                                        phi_4761_ = true;
                                                        break;
                                                    }
                                                    let _e1115 = global_4.member[_e1074].member[_e1109];
                                                    let _e1116 = (3u + _e545);
                                                    if (_e1116 < 9u) {
                                                    } else {
                                                        phi_4761_ = true;
                                                        break;
                                                    }
                                                    let _e1122 = global_4.member[_e1074].member[_e1116];
                                                    let _e1124 = (6u + _e533);
                                                    if (_e1124 < 9u) {
                                                    } else {
                                                        phi_4761_ = true;
                                                        break;
                                                    }
                                                    let _e1130 = global_4.member[_e1074].member[_e1124];
                                                    let _e1131 = (6u + _e539);
                                                    if (_e1131 < 9u) {
                                                    } else {
                                                        phi_4761_ = true;
                                                        break;
                                                    }
                                                    let _e1137 = global_4.member[_e1074].member[_e1131];
                                                    let _e1138 = (6u + _e545);
                                                    if (_e1138 < 9u) {
                                                    } else {
                                                        phi_4761_ = true;
                                                        break;
                                                    }
                                                    let _e1144 = global_4.member[_e1074].member[_e1138];
                                                    phi_2200_ = array<array<f32, 3>, 3>(array<f32, 3>(_e1088, _e1094, _e1100), array<f32, 3>(_e1108, _e1115, _e1122), array<f32, 3>(_e1130, _e1137, _e1144));
                                                }
                                                let _e1148 = phi_2200_;
                                                let _e1156 = (_e1148[0][2] - _e456);
                                                let _e1159 = (((_e1148[0][0] - _e383) * _e480) - (_e1156 * _e408));
                                                let _e1162 = (((_e1148[0][1] - _e420) * _e480) - (_e1156 * _e444));
                                                let _e1169 = (_e1148[1][2] - _e456);
                                                let _e1172 = (((_e1148[1][0] - _e383) * _e480) - (_e1169 * _e408));
                                                let _e1175 = (((_e1148[1][1] - _e420) * _e480) - (_e1169 * _e444));
                                                let _e1182 = (_e1148[2][2] - _e456);
                                                let _e1185 = (((_e1148[2][0] - _e383) * _e480) - (_e1182 * _e408));
                                                let _e1188 = (((_e1148[2][1] - _e420) * _e480) - (_e1182 * _e444));
                                                let _e1189 = (_e1185 * _e1175);
                                                let _e1190 = (_e1188 * _e1172);
                                                let _e1191 = (_e1159 * _e1188);
                                                let _e1192 = (_e1162 * _e1185);
                                                let _e1193 = (_e1172 * _e1162);
                                                let _e1194 = (_e1175 * _e1159);
                                                let _e1199 = (((_e1189 >= _e1190) && (_e1191 >= _e1192)) && (_e1193 >= _e1194));
                                                if (_e1199 || (((_e1189 <= _e1190) && (_e1191 <= _e1192)) && (_e1193 <= _e1194))) {
                                                    let _e1206 = select(-1f, 1f, _e1199);
                                                    let _e1208 = ((_e1189 - _e1190) * _e1206);
                                                    let _e1210 = select(0f, _e1208, (_e1208 > 0f));
                                                    let _e1212 = ((_e1191 - _e1192) * _e1206);
                                                    let _e1214 = select(0f, _e1212, (_e1212 > 0f));
                                                    let _e1216 = ((_e1193 - _e1194) * _e1206);
                                                    let _e1218 = select(0f, _e1216, (_e1216 > 0f));
                                                    let _e1220 = ((_e1210 + _e1214) + _e1218);
                                                    if (_e1220 < 0.000000000000000000000000000000000000011754944f) {
                                                        phi_2766_ = type_25();
                                                        phi_2767_ = true;
                                                    } else {
                                                        let _e1223 = select(_e1148[1][0], _e1148[0][0], (_e1148[0][0] < _e1148[1][0]));
                                                        let _e1227 = select(_e1148[1][0], _e1148[0][0], (_e1148[0][0] > _e1148[1][0]));
                                                        let _e1231 = select(_e1148[1][1], _e1148[0][1], (_e1148[0][1] < _e1148[1][1]));
                                                        let _e1235 = select(_e1148[1][1], _e1148[0][1], (_e1148[0][1] > _e1148[1][1]));
                                                        let _e1239 = select(_e1148[1][2], _e1148[0][2], (_e1148[0][2] < _e1148[1][2]));
                                                        let _e1243 = select(_e1148[1][2], _e1148[0][2], (_e1148[0][2] > _e1148[1][2]));
                                                        let _e1248 = ((select(_e1148[2][0], _e1223, (_e1223 < _e1148[2][0])) - _e406) * _e411);
                                                        let _e1249 = ((select(_e1148[2][0], _e1227, (_e1227 > _e1148[2][0])) - _e407) * _e411);
                                                        let _e1252 = ((select(_e1148[2][1], _e1231, (_e1231 < _e1148[2][1])) - _e442) * _e447);
                                                        let _e1253 = ((select(_e1148[2][1], _e1235, (_e1235 > _e1148[2][1])) - _e443) * _e447);
                                                        let _e1256 = ((select(_e1148[2][2], _e1239, (_e1239 < _e1148[2][2])) - _e478) * _e483);
                                                        let _e1257 = ((select(_e1148[2][2], _e1243, (_e1243 > _e1148[2][2])) - _e479) * _e483);
                                                        let _e1259 = select(_e1257, _e1256, (_e1256 < _e1257));
                                                        let _e1261 = select(_e1257, _e1256, (_e1256 > _e1257));
                                                        let _e1263 = select(_e1249, _e1248, (_e1248 < _e1249));
                                                        let _e1265 = select(_e1253, _e1252, (_e1252 < _e1253));
                                                        let _e1267 = select(_e1265, _e1263, (_e1263 > _e1265));
                                                        let _e1269 = select(_e1259, _e1267, (_e1267 > _e1259));
                                                        let _e1271 = select(_e1249, _e1248, (_e1248 > _e1249));
                                                        let _e1273 = select(_e1253, _e1252, (_e1252 > _e1253));
                                                        let _e1275 = select(_e1273, _e1271, (_e1271 < _e1273));
                                                        let _e1277 = select(_e1261, _e1275, (_e1275 < _e1261));
                                                        let _e1278 = -(_e1259);
                                                        let _e1284 = select(_e529, _e1269, (_e1269 > _e529));
                                                        if (_e1284 > (_e1277 + (select(_e1278, _e1261, (_e1261 > _e1278)) * 0.0000019073523f))) {
                                                            phi_2761_ = type_25();
                                                            phi_2762_ = true;
                                                        } else {
                                                            let _e1286 = (_e1284 > _e1052.member_1);
                                                            if _e1286 {
                                                                phi_2760_ = type_25();
                                                            } else {
                                                                let _e1290 = (_e1148[1][0] - _e1148[0][0]);
                                                                let _e1291 = (_e1148[1][1] - _e1148[0][1]);
                                                                let _e1292 = (_e1148[1][2] - _e1148[0][2]);
                                                                let _e1293 = vec3<f32>(_e1290, _e1291, _e1292);
                                                                let _e1294 = (_e1148[2][0] - _e1148[1][0]);
                                                                let _e1295 = (_e1148[2][1] - _e1148[1][1]);
                                                                let _e1296 = (_e1148[2][2] - _e1148[1][2]);
                                                                let _e1297 = vec3<f32>(_e1294, _e1295, _e1296);
                                                                let _e1298 = (_e1148[0][0] - _e1148[2][0]);
                                                                let _e1299 = (_e1148[0][1] - _e1148[2][1]);
                                                                let _e1300 = (_e1148[0][2] - _e1148[2][2]);
                                                                let _e1301 = vec3<f32>(_e1298, _e1299, _e1300);
                                                                let _e1304 = bitcast<f32>((bitcast<u32>(_e1290) & 2147483647u));
                                                                let _e1307 = bitcast<f32>((bitcast<u32>(_e1291) & 2147483647u));
                                                                let _e1309 = select(_e1307, _e1304, (_e1304 > _e1307));
                                                                let _e1312 = bitcast<f32>((bitcast<u32>(_e1292) & 2147483647u));
                                                                let _e1314 = select(_e1312, _e1309, (_e1309 > _e1312));
                                                                let _e1317 = bitcast<f32>((bitcast<u32>(_e1294) & 2147483647u));
                                                                let _e1320 = bitcast<f32>((bitcast<u32>(_e1295) & 2147483647u));
                                                                let _e1322 = select(_e1320, _e1317, (_e1317 > _e1320));
                                                                let _e1325 = bitcast<f32>((bitcast<u32>(_e1296) & 2147483647u));
                                                                let _e1327 = select(_e1325, _e1322, (_e1322 > _e1325));
                                                                let _e1330 = bitcast<f32>((bitcast<u32>(_e1298) & 2147483647u));
                                                                let _e1333 = bitcast<f32>((bitcast<u32>(_e1299) & 2147483647u));
                                                                let _e1335 = select(_e1333, _e1330, (_e1330 > _e1333));
                                                                let _e1338 = bitcast<f32>((bitcast<u32>(_e1300) & 2147483647u));
                                                                let _e1340 = select(_e1338, _e1335, (_e1335 > _e1338));
                                                                let _e1342 = select(_e1327, _e1314, (_e1314 > _e1327));
                                                                let _e1344 = select(_e1340, _e1342, (_e1342 > _e1340));
                                                                if (_e1314 == _e1344) {
                                                                    phi_2671_ = _e1297;
                                                                    phi_2672_ = _e1301;
                                                                } else {
                                                                    let _e1347 = vec3((_e1327 == _e1344));
                                                                    phi_2671_ = select(_e1293, _e1301, _e1347);
                                                                    phi_2672_ = select(_e1297, _e1293, _e1347);
                                                                }
                                                                let _e1351 = phi_2671_;
                                                                let _e1353 = phi_2672_;
                                                                let _e1360 = ((_e1351.y * _e1353.z) - (_e1353.y * _e1351.z));
                                                                let _e1365 = ((_e1351.z * _e1353.x) - (_e1353.z * _e1351.x));
                                                                let _e1368 = ((_e1351.x * _e1353.y) - (_e1353.x * _e1351.y));
                                                                if (_e1210 >= _e1214) {
                                                                    phi_2703_ = select(true, false, (_e1210 >= _e1218));
                                                                } else {
                                                                    phi_2703_ = true;
                                                                }
                                                                let _e1373 = phi_2703_;
                                                                if _e1373 {
                                                                    phi_2712_ = select(vec3<f32>(_e1148[2][0], _e1148[2][1], _e1148[2][2]), vec3<f32>(_e1148[1][0], _e1148[1][1], _e1148[1][2]), vec3((_e1214 >= _e1218)));
                                                                } else {
                                                                    phi_2712_ = vec3<f32>(_e1148[0][0], _e1148[0][1], _e1148[0][2]);
                                                                }
                                                                let _e1378 = phi_2712_;
                                                                let _e1395 = ((((_e1360 * (_e1378.x - _e383)) + (_e1365 * (_e1378.y - _e420))) + (_e1368 * (_e1378.z - _e456))) / (((_e1360 * _e408) + (_e1365 * _e444)) + (_e1368 * _e480)));
                                                                let _e1397 = select(_e1277, _e1395, (_e1395 < _e1277));
                                                                let _e1399 = select(_e1269, _e1397, (_e1397 > _e1269));
                                                                if (_e1399 >= _e529) {
                                                                    let _e1401 = (_e1399 <= _e1052.member_1);
                                                                    if _e1401 {
                                                                        let _e1402 = (1f / _e1220);
                                                                        phi_2752_ = type_25(_e1399, (_e1214 * _e1402), (_e1218 * _e1402), _e1081);
                                                                    } else {
                                                                        phi_2752_ = type_25();
                                                                    }
                                                                    let _e1407 = phi_2752_;
                                                                    phi_2754_ = _e1407;
                                                                    phi_2755_ = select(true, false, _e1401);
                                                                } else {
                                                                    phi_2754_ = type_25();
                                                                    phi_2755_ = true;
                                                                }
                                                                let _e1410 = phi_2754_;
                                                                let _e1412 = phi_2755_;
                                                                if _e1412 {
                                                                    phi_2759_ = type_25(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                } else {
                                                                    phi_2759_ = _e1410;
                                                                }
                                                                let _e1414 = phi_2759_;
                                                                phi_2760_ = _e1414;
                                                            }
                                                            let _e1416 = phi_2760_;
                                                            phi_2761_ = _e1416;
                                                            phi_2762_ = _e1286;
                                                        }
                                                        let _e1418 = phi_2761_;
                                                        let _e1420 = phi_2762_;
                                                        phi_2766_ = _e1418;
                                                        phi_2767_ = _e1420;
                                                    }
                                                    let _e1422 = phi_2766_;
                                                    let _e1424 = phi_2767_;
                                                    phi_2771_ = _e1422;
                                                    phi_2772_ = _e1424;
                                                } else {
                                                    phi_2771_ = type_25();
                                                    phi_2772_ = true;
                                                }
                                                let _e1426 = phi_2771_;
                                                let _e1428 = phi_2772_;
                                                if _e1428 {
                                                    phi_2776_ = type_25(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                } else {
                                                    phi_2776_ = _e1426;
                                                }
                                                let _e1430 = phi_2776_;
                                                if (_e1430.member_3 != 4294967295u) {
                                                    if (_e1081 == _e157) {
                                                        phi_3105_ = false;
                                                    } else {
                                                        let _e1434 = (_e1081 < arrayLength((&global_5.member)));
                                                        if _e1434 {
                                                            if _e1434 {
                                                            } else {
                                                                phi_4761_ = true;
                                                                break;
                                                            }
                                                            let _e1436 = global_5.member[_e1081];
                                                            phi_2799_ = _e1436;
                                                        } else {
                                                            phi_2799_ = 4294967295u;
                                                        }
                                                        let _e1438 = phi_2799_;
                                                        let _e1439 = (_e1438 < arrayLength((&global_6.member)));
                                                        if _e1439 {
                                                            if _e1439 {
                                                            } else {
                                                                phi_4761_ = true;
                                                                break;
                                                            }
                                                            let _e1441 = global_6.member[_e1438];
                                                            phi_2813_ = _e1441;
                                                        } else {
                                                            phi_2813_ = 0i;
                                                        }
                                                        let _e1443 = phi_2813_;
                                                        let _e1444 = (_e1443 == 0i);
                                                        if _e1444 {
                                                            phi_3104_ = true;
                                                        } else {
                                                            if _e375 {
                                                                phi_2834_ = vec3<f32>(_e1148[0][0], _e1148[0][1], _e1148[0][2]);
                                                            } else {
                                                                if (_e351 == 1u) {
                                                                    phi_2833_ = vec3<f32>(_e1148[0][2], _e1148[0][0], _e1148[0][1]);
                                                                } else {
                                                                    phi_2833_ = vec3<f32>(_e1148[0][1], _e1148[0][2], _e1148[0][0]);
                                                                }
                                                                let _e1449 = phi_2833_;
                                                                phi_2834_ = _e1449;
                                                            }
                                                            let _e1452 = phi_2834_;
                                                            if _e375 {
                                                                phi_2851_ = vec3<f32>(_e1148[1][0], _e1148[1][1], _e1148[1][2]);
                                                            } else {
                                                                if (_e351 == 1u) {
                                                                    phi_2850_ = vec3<f32>(_e1148[1][2], _e1148[1][0], _e1148[1][1]);
                                                                } else {
                                                                    phi_2850_ = vec3<f32>(_e1148[1][1], _e1148[1][2], _e1148[1][0]);
                                                                }
                                                                let _e1457 = phi_2850_;
                                                                phi_2851_ = _e1457;
                                                            }
                                                            let _e1460 = phi_2851_;
                                                            if _e375 {
                                                                phi_2868_ = vec3<f32>(_e1148[2][0], _e1148[2][1], _e1148[2][2]);
                                                            } else {
                                                                if (_e351 == 1u) {
                                                                    phi_2867_ = vec3<f32>(_e1148[2][2], _e1148[2][0], _e1148[2][1]);
                                                                } else {
                                                                    phi_2867_ = vec3<f32>(_e1148[2][1], _e1148[2][2], _e1148[2][0]);
                                                                }
                                                                let _e1465 = phi_2867_;
                                                                phi_2868_ = _e1465;
                                                            }
                                                            let _e1468 = phi_2868_;
                                                            let _e1471 = (_e1460.x - _e1452.x);
                                                            let _e1474 = (_e1460.y - _e1452.y);
                                                            let _e1477 = (_e1460.z - _e1452.z);
                                                            let _e1479 = (_e1468.x - _e1452.x);
                                                            let _e1481 = (_e1468.y - _e1452.y);
                                                            let _e1483 = (_e1468.z - _e1452.z);
                                                            if (_e229.member_1 == 1u) {
                                                                phi_2904_ = (vec3<f32>(_e229.member[0], _e229.member[1], _e229.member[2]) - _e1452);
                                                            } else {
                                                                phi_2904_ = vec3<f32>(_e229.member[0], _e229.member[1], _e229.member[2]);
                                                            }
                                                            let _e1498 = phi_2904_;
                                                            let _e1504 = bitcast<f32>((bitcast<u32>((_e1471 * _e1481)) ^ _e229.member_3[0]));
                                                            let _e1508 = bitcast<f32>((bitcast<u32>((_e1474 * _e1479)) ^ _e229.member_3[0]));
                                                            let _e1512 = bitcast<f32>((bitcast<u32>((_e1474 * _e1483)) ^ _e229.member_3[0]));
                                                            let _e1516 = bitcast<f32>((bitcast<u32>((_e1477 * _e1481)) ^ _e229.member_3[0]));
                                                            let _e1520 = bitcast<f32>((bitcast<u32>((_e1477 * _e1479)) ^ _e229.member_3[0]));
                                                            let _e1524 = bitcast<f32>((bitcast<u32>((_e1471 * _e1483)) ^ _e229.member_3[0]));
                                                            let _e1525 = (_e1512 - _e1516);
                                                            let _e1526 = (_e1520 - _e1524);
                                                            let _e1527 = (_e1504 - _e1508);
                                                            let _e1551 = (bitcast<f32>((bitcast<u32>(_e1512) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1516) & 2147483647u)));
                                                            let _e1558 = (bitcast<f32>((bitcast<u32>(_e1520) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1524) & 2147483647u)));
                                                            let _e1565 = (bitcast<f32>((bitcast<u32>(_e1504) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1508) & 2147483647u)));
                                                            if (_e229.member_2 == 0f) {
                                                                phi_3086_ = 0f;
                                                            } else {
                                                                let _e1595 = bitcast<f32>((bitcast<u32>(_e1525) & 2147483647u));
                                                                let _e1598 = bitcast<f32>((bitcast<u32>(_e1526) & 2147483647u));
                                                                let _e1601 = bitcast<f32>((bitcast<u32>(_e1527) & 2147483647u));
                                                                let _e1603 = select(_e1601, _e1598, (_e1598 > _e1601));
                                                                let _e1607 = select(_e1601, _e1598, (_e1598 < _e1601));
                                                                let _e1611 = select(_e1598, _e1595, (_e1595 < _e1598));
                                                                let _e1613 = select(_e1598, _e1595, (_e1595 > _e1598));
                                                                let _e1615 = select(_e1601, _e1613, (_e1613 < _e1601));
                                                                phi_3086_ = bitcast<f32>((bitcast<u32>((_e229.member_2 * bitcast<f32>((bitcast<u32>(((((select(_e1603, _e1595, (_e1595 > _e1603)) + bitcast<f32>((bitcast<u32>((0.414214f * select(_e1615, _e1611, (_e1611 > _e1615)))) ^ _e229.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.317838f * select(_e1607, _e1595, (_e1595 < _e1607)))) ^ _e229.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.0000004768374f * ((_e1551 + _e1558) + _e1565))) ^ _e229.member_3[0]))) * 1.0000005f)) ^ _e229.member_3[0])))) ^ _e229.member_3[0]));
                                                            }
                                                            let _e1642 = phi_3086_;
                                                            phi_3104_ = (_e1444 || !(((((bitcast<f32>((bitcast<u32>((_e1498.x * _e1525)) ^ _e229.member_3[0])) + bitcast<f32>((bitcast<u32>((_e1498.y * _e1526)) ^ _e229.member_3[0]))) + bitcast<f32>((bitcast<u32>((_e1498.z * _e1527)) ^ _e229.member_3[0]))) * f32(-(_e1443))) > ((bitcast<f32>((bitcast<u32>((0.0000009536752f * ((bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1498.x) & 2147483647u)) * _e1551)) ^ _e229.member_3[0])) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1498.y) & 2147483647u)) * _e1558)) ^ _e229.member_3[0]))) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1498.z) & 2147483647u)) * _e1565)) ^ _e229.member_3[0]))))) ^ _e229.member_3[0])) + _e1642) + 0.0000000000000000000000000000000000001880791f))));
                                                        }
                                                        let _e1656 = phi_3104_;
                                                        phi_3105_ = _e1656;
                                                    }
                                                    let _e1658 = phi_3105_;
                                                    if _e1658 {
                                                        if (_e1430.member < _e1052.member.member) {
                                                            phi_3125_ = true;
                                                        } else {
                                                            if (_e1430.member == _e1052.member.member) {
                                                                phi_3124_ = (_e1430.member_3 < _e1052.member.member_3);
                                                            } else {
                                                                phi_3124_ = false;
                                                            }
                                                            let _e1668 = phi_3124_;
                                                            phi_3125_ = _e1668;
                                                        }
                                                        let _e1670 = phi_3125_;
                                                        if _e1670 {
                                                            phi_3131_ = type_41(_e1430, _e1430.member);
                                                        } else {
                                                            phi_3131_ = _e1052;
                                                        }
                                                        let _e1673 = phi_3131_;
                                                        phi_3132_ = _e1673;
                                                    } else {
                                                        phi_3132_ = _e1052;
                                                    }
                                                    let _e1675 = phi_3132_;
                                                    phi_3133_ = _e1675;
                                                } else {
                                                    phi_3133_ = _e1052;
                                                }
                                                let _e1677 = phi_3133_;
                                                phi_2065_ = _e1677;
                                            } else {
                                                phi_2065_ = type_41();
                                            }
                                            let _e1679 = phi_2065_;
                                            continue;
                                            continuing {
                                                phi_2064_ = _e1679;
                                                phi_2067_ = _e1067;
                                                phi_4761_ = _e571;
                                                break if !(_e1073);
                                            }
                                        }
                                        let _e1682 = phi_4761_;
                                        phi_4899_ = _e1682;
                                        if _e1682 {
                                            break;
                                        }
                                        phi_4903_ = _e1682;
                                        let _e1897 = local_5;
                                        phi_4436_ = _e1897;
                                        phi_4437_ = _e602;
                                        phi_4438_ = false;
                                        phi_4439_ = _e606;
                                    } else {
                                        if (_e602.member_1 >= _e90) {
                                            phi_4036_ = type_63(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), type_60(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u), type_60(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u));
                                        } else {
                                            if (_e602.member_1 < _e90) {
                                            } else {
                                                phi_4899_ = true;
                                                break;
                                            }
                                            let _e619 = ((1u + (_e351 * 2u)) % 7u);
                                            if (_e619 < 7u) {
                                            } else {
                                                phi_4899_ = true;
                                                break;
                                            }
                                            let _e624 = global_10.member[_e602.member_1][_e619];
                                            let _e627 = ((1u + (_e350 * 2u)) % 7u);
                                            if (_e627 < 7u) {
                                            } else {
                                                phi_4899_ = true;
                                                break;
                                            }
                                            let _e632 = global_10.member[_e602.member_1][_e627];
                                            let _e635 = ((1u + (_e352 * 2u)) % 7u);
                                            if (_e635 < 7u) {
                                            } else {
                                                phi_4899_ = true;
                                                break;
                                            }
                                            let _e640 = global_10.member[_e602.member_1][_e635];
                                            let _e643 = (((_e351 + 1u) * 2u) % 7u);
                                            if (_e643 < 7u) {
                                            } else {
                                                phi_4899_ = true;
                                                break;
                                            }
                                            let _e648 = global_10.member[_e602.member_1][_e643];
                                            let _e651 = (((_e350 + 1u) * 2u) % 7u);
                                            if (_e651 < 7u) {
                                            } else {
                                                phi_4899_ = true;
                                                break;
                                            }
                                            let _e656 = global_10.member[_e602.member_1][_e651];
                                            let _e659 = (((_e352 + 1u) * 2u) % 7u);
                                            if (_e659 < 7u) {
                                            } else {
                                                phi_4899_ = true;
                                                break;
                                            }
                                            let _e664 = global_10.member[_e602.member_1][_e659];
                                            let _e687 = (bitcast<f32>((bitcast<u32>((_e602.member.member_1.x - _e602.member.member.x)) & 2139095040u)) * 0.0000009536743f);
                                            let _e688 = (bitcast<f32>((bitcast<u32>((_e602.member.member_1.y - _e602.member.member.y)) & 2139095040u)) * 0.0000009536743f);
                                            let _e689 = (bitcast<f32>((bitcast<u32>((_e602.member.member_1.z - _e602.member.member.z)) & 2139095040u)) * 0.0000009536743f);
                                            let _e691 = select(_e148, _e687, (_e687 > _e148));
                                            let _e693 = select(_e148, _e688, (_e688 > _e148));
                                            let _e695 = select(_e148, _e689, (_e689 > _e148));
                                            let _e720 = bitcast<u32>((f32(bitcast<i32>((_e624 & 2097151u))) * _e691));
                                            let _e725 = (bitcast<i32>((_e624 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e728 = bitcast<f32>((_e720 & bitcast<u32>(_e725)));
                                            let _e729 = bitcast<u32>((f32(bitcast<i32>((_e632 & 2097151u))) * _e693));
                                            let _e734 = (bitcast<i32>((_e632 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e737 = bitcast<f32>((_e729 & bitcast<u32>(_e734)));
                                            let _e738 = bitcast<u32>((f32(bitcast<i32>((_e640 & 2097151u))) * _e695));
                                            let _e743 = (bitcast<i32>((_e640 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e746 = bitcast<f32>((_e738 & bitcast<u32>(_e743)));
                                            let _e750 = bitcast<f32>((_e720 & bitcast<u32>(~(_e725))));
                                            let _e754 = bitcast<f32>((_e729 & bitcast<u32>(~(_e734))));
                                            let _e758 = bitcast<f32>((_e738 & bitcast<u32>(~(_e743))));
                                            let _e759 = bitcast<u32>((f32(bitcast<i32>((_e648 & 2097151u))) * _e691));
                                            let _e764 = (bitcast<i32>((_e648 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e767 = bitcast<f32>((_e759 & bitcast<u32>(_e764)));
                                            let _e768 = bitcast<u32>((f32(bitcast<i32>((_e656 & 2097151u))) * _e693));
                                            let _e773 = (bitcast<i32>((_e656 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e776 = bitcast<f32>((_e768 & bitcast<u32>(_e773)));
                                            let _e777 = bitcast<u32>((f32(bitcast<i32>((_e664 & 2097151u))) * _e695));
                                            let _e782 = (bitcast<i32>((_e664 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e785 = bitcast<f32>((_e777 & bitcast<u32>(_e782)));
                                            let _e789 = bitcast<f32>((_e759 & bitcast<u32>(~(_e764))));
                                            let _e793 = bitcast<f32>((_e768 & bitcast<u32>(~(_e773))));
                                            let _e797 = bitcast<f32>((_e777 & bitcast<u32>(~(_e782))));
                                            let _e827 = global_10.member[_e602.member_1][0u];
                                            let _e831 = global_10.member[_e602.member_1][2u];
                                            let _e835 = global_10.member[_e602.member_1][4u];
                                            let _e839 = global_10.member[_e602.member_1][6u];
                                            let _e851 = (((_e831 >> bitcast<u32>(22i)) | ((_e835 >> bitcast<u32>(22i)) << bitcast<u32>(10i))) | ((_e839 >> bitcast<u32>(22i)) << bitcast<u32>(20i)));
                                            let _e852 = (_e827 & 268435455u);
                                            let _e853 = (_e851 & 268435455u);
                                            let _e856 = ((_e827 >> bitcast<u32>(28u)) & 7u);
                                            let _e864 = ((_e827 >> bitcast<u32>(31i)) | (((_e851 >> bitcast<u32>(28u)) & 3u) << bitcast<u32>(1i)));
                                            let _e865 = (_e856 != 0u);
                                            if (_e856 == 0u) {
                                                phi_3998_ = _e852;
                                            } else {
                                                if (_e856 == 7u) {
                                                    phi_3997_ = 2147483648u;
                                                } else {
                                                    phi_3997_ = ((2147483648u | (_e856 << bitcast<u32>(28u))) | (_e853 & 268435455u));
                                                }
                                                let _e874 = phi_3997_;
                                                phi_3998_ = _e874;
                                            }
                                            let _e876 = phi_3998_;
                                            if _e865 {
                                                let _e877 = (_e856 != 7u);
                                                if _e877 {
                                                    phi_4008_ = (_e853 + _e856);
                                                } else {
                                                    phi_4008_ = u32();
                                                }
                                                let _e880 = phi_4008_;
                                                phi_4010_ = _e880;
                                                phi_4011_ = select(true, false, _e877);
                                            } else {
                                                phi_4010_ = u32();
                                                phi_4011_ = true;
                                            }
                                            let _e883 = phi_4010_;
                                            let _e885 = phi_4011_;
                                            if (_e864 == 0u) {
                                                phi_4032_ = (_e852 + select(0u, 1u, !(_e865)));
                                            } else {
                                                if (_e864 == 7u) {
                                                    phi_4031_ = 2147483648u;
                                                } else {
                                                    phi_4031_ = ((2147483648u | (_e864 << bitcast<u32>(28u))) | (select(_e883, _e853, _e885) & 268435455u));
                                                }
                                                let _e898 = phi_4031_;
                                                phi_4032_ = _e898;
                                            }
                                            let _e900 = phi_4032_;
                                            phi_4036_ = type_63(array<vec4<f32>, 3>(vec4<f32>((_e602.member.member.x + _e728), (_e602.member.member.x + _e750), (_e602.member.member_1.x - _e767), (_e602.member.member_1.x - _e789)), vec4<f32>((_e602.member.member.y + _e737), (_e602.member.member.y + _e754), (_e602.member.member_1.y - _e776), (_e602.member.member_1.y - _e793)), vec4<f32>((_e602.member.member.z + _e746), (_e602.member.member.z + _e758), (_e602.member.member_1.z - _e785), (_e602.member.member_1.z - _e797))), type_60(type_37((_e602.member.member + vec4<f32>(_e728, _e737, _e746, 0f)), (_e602.member.member_1 - vec4<f32>(_e767, _e776, _e785, 0f))), _e876), type_60(type_37((_e602.member.member + vec4<f32>(_e750, _e754, _e758, 0f)), (_e602.member.member_1 - vec4<f32>(_e789, _e793, _e797, 0f))), _e900));
                                        }
                                        let _e905 = phi_4036_;
                                        let _e917 = ((_e905.member[0].x - _e406) * _e411);
                                        let _e918 = ((_e905.member[0].y - _e406) * _e411);
                                        let _e919 = ((_e905.member[0].z - _e407) * _e411);
                                        let _e920 = ((_e905.member[0].w - _e407) * _e411);
                                        let _e930 = ((_e905.member[1].x - _e442) * _e447);
                                        let _e931 = ((_e905.member[1].y - _e442) * _e447);
                                        let _e932 = ((_e905.member[1].z - _e443) * _e447);
                                        let _e933 = ((_e905.member[1].w - _e443) * _e447);
                                        let _e943 = ((_e905.member[2].x - _e478) * _e483);
                                        let _e944 = ((_e905.member[2].y - _e478) * _e483);
                                        let _e945 = ((_e905.member[2].z - _e479) * _e483);
                                        let _e946 = ((_e905.member[2].w - _e479) * _e483);
                                        let _e948 = select(_e945, _e943, (_e943 < _e945));
                                        let _e950 = select(_e946, _e944, (_e944 < _e946));
                                        let _e952 = select(_e945, _e943, (_e943 > _e945));
                                        let _e954 = select(_e946, _e944, (_e944 > _e946));
                                        let _e956 = select(_e919, _e917, (_e917 < _e919));
                                        let _e958 = select(_e920, _e918, (_e918 < _e920));
                                        let _e960 = select(_e932, _e930, (_e930 < _e932));
                                        let _e962 = select(_e933, _e931, (_e931 < _e933));
                                        let _e964 = select(_e960, _e956, (_e956 > _e960));
                                        let _e966 = select(_e962, _e958, (_e958 > _e962));
                                        let _e968 = select(_e948, _e964, (_e964 > _e948));
                                        let _e970 = select(_e950, _e966, (_e966 > _e950));
                                        let _e972 = select(_e919, _e917, (_e917 > _e919));
                                        let _e974 = select(_e920, _e918, (_e918 > _e920));
                                        let _e976 = select(_e932, _e930, (_e930 > _e932));
                                        let _e978 = select(_e933, _e931, (_e931 > _e933));
                                        let _e980 = select(_e976, _e972, (_e972 < _e976));
                                        let _e982 = select(_e978, _e974, (_e974 < _e978));
                                        let _e987 = -(_e948);
                                        let _e988 = -(_e950);
                                        let _e995 = (select(_e952, _e980, (_e980 < _e952)) + (select(_e987, _e952, (_e952 > _e987)) * 0.0000019073523f));
                                        let _e996 = (select(_e954, _e982, (_e982 < _e954)) + (select(_e988, _e954, (_e954 > _e988)) * 0.0000019073523f));
                                        let _e998 = select(_e529, _e968, (_e968 > _e529));
                                        let _e1000 = select(_e529, _e970, (_e970 > _e529));
                                        let _e1005 = (_e998 <= select(_e573.member_1, _e995, (_e995 < _e573.member_1)));
                                        let _e1006 = (_e1000 <= select(_e573.member_1, _e996, (_e996 < _e573.member_1)));
                                        let _e1007 = (_e998 <= _e1000);
                                        if _e1005 {
                                            if _e1006 {
                                                if _e1007 {
                                                    phi_4380_ = _e905.member_2;
                                                } else {
                                                    phi_4380_ = _e905.member_1;
                                                }
                                                let _e1011 = phi_4380_;
                                                let _e1012 = (_e606 % 128u);
                                                let _e1013 = (_e1012 < 128u);
                                                if _e1013 {
                                                } else {
                                                    phi_4899_ = true;
                                                    break;
                                                }
                                                local_3[_e1012] = type_60(type_37(_e1011.member.member, _e1011.member.member_1), _e1011.member_1);
                                                if _e1013 {
                                                } else {
                                                    phi_4899_ = true;
                                                    break;
                                                }
                                                local_2[_e1012] = select(_e1000, _e998, (_e998 > _e1000));
                                                if _e1007 {
                                                    phi_4413_ = _e905.member_1;
                                                } else {
                                                    phi_4413_ = _e905.member_2;
                                                }
                                                let _e1028 = phi_4413_;
                                                phi_4414_ = _e1028;
                                                phi_4415_ = (_e606 + 1u);
                                            } else {
                                                phi_4414_ = type_60();
                                                phi_4415_ = u32();
                                            }
                                            let _e1030 = phi_4414_;
                                            let _e1032 = phi_4415_;
                                            phi_4417_ = _e1030;
                                            phi_4418_ = _e1032;
                                            phi_4419_ = select(true, false, _e1006);
                                        } else {
                                            phi_4417_ = type_60();
                                            phi_4418_ = u32();
                                            phi_4419_ = true;
                                        }
                                        let _e1035 = phi_4417_;
                                        let _e1037 = phi_4418_;
                                        let _e1039 = phi_4419_;
                                        if _e1039 {
                                            if _e1005 {
                                                phi_4428_ = _e905.member_1;
                                            } else {
                                                phi_4428_ = _e905.member_2;
                                            }
                                            let _e1043 = phi_4428_;
                                            phi_4433_ = _e1043;
                                            phi_4434_ = select(_e1006, true, _e1005);
                                        } else {
                                            phi_4433_ = _e1035;
                                            phi_4434_ = _e604;
                                        }
                                        let _e1046 = phi_4433_;
                                        let _e1048 = phi_4434_;
                                        phi_4903_ = _e571;
                                        phi_4436_ = _e573;
                                        phi_4437_ = _e1046;
                                        phi_4438_ = _e1048;
                                        phi_4439_ = select(_e1037, _e606, _e1039);
                                    }
                                    let _e1684 = phi_4903_;
                                    let _e1686 = phi_4436_;
                                    let _e1688 = phi_4437_;
                                    let _e1690 = phi_4438_;
                                    let _e1692 = phi_4439_;
                                    phi_4902_ = _e1684;
                                    phi_4440_ = _e1686;
                                    phi_4441_ = _e1688;
                                    phi_4442_ = (_e577 - 1u);
                                    phi_4443_ = _e1690;
                                    phi_4444_ = _e1692;
                                } else {
                                    phi_4902_ = _e571;
                                    phi_4440_ = _e573;
                                    phi_4441_ = _e602;
                                    phi_4442_ = _e577;
                                    phi_4443_ = _e604;
                                    phi_4444_ = _e606;
                                }
                                let _e1694 = phi_4902_;
                                let _e1696 = phi_4440_;
                                let _e1698 = phi_4441_;
                                let _e1700 = phi_4442_;
                                let _e1702 = phi_4443_;
                                let _e1704 = phi_4444_;
                                phi_4901_ = _e1694;
                                phi_4445_ = _e1696;
                                phi_4446_ = _e1698;
                                phi_4447_ = _e1700;
                                phi_4448_ = _e1702;
                                phi_4449_ = _e1704;
                            } else {
                                phi_4901_ = _e571;
                                phi_4445_ = type_41();
                                phi_4446_ = type_60();
                                phi_4447_ = u32();
                                phi_4448_ = bool();
                                phi_4449_ = u32();
                            }
                            let _e1706 = phi_4901_;
                            let _e1708 = phi_4445_;
                            let _e1710 = phi_4446_;
                            let _e1712 = phi_4447_;
                            let _e1714 = phi_4448_;
                            let _e1716 = phi_4449_;
                            phi_4900_ = _e1706;
                            phi_1988_ = _e1708;
                            phi_1991_ = _e1710;
                            phi_1993_ = _e1712;
                            phi_1995_ = _e1714;
                            phi_1997_ = _e1716;
                            phi_4450_ = _e585;
                        } else {
                            phi_4900_ = _e571;
                            phi_1988_ = type_41();
                            phi_1991_ = type_60();
                            phi_1993_ = u32();
                            phi_1995_ = bool();
                            phi_1997_ = u32();
                            phi_4450_ = false;
                        }
                        let _e1718 = phi_4900_;
                        let _e1720 = phi_1988_;
                        let _e1722 = phi_1991_;
                        let _e1724 = phi_1993_;
                        let _e1726 = phi_1995_;
                        let _e1728 = phi_1997_;
                        let _e1730 = phi_4450_;
                        continue;
                        continuing {
                            phi_4767_ = _e1718;
                            phi_1987_ = _e1720;
                            phi_1990_ = _e1722;
                            phi_1992_ = _e1724;
                            phi_1994_ = _e1726;
                            phi_1996_ = _e1728;
                            phi_4899_ = _e1718;
                            break if !(_e1730);
                        }
                    }
                    let _e1733 = phi_4899_;
                    if _e1733 {
                        break;
                    }
                    let _e1735 = local_4;
                    if (_e1735.member.member_3 != 4294967295u) {
                        let _e1740 = (_e353 / 3i);
                        let _e1747 = bitcast<f32>((bitcast<u32>((_e1740 + 127i)) << bitcast<u32>(23i)));
                        let _e1755 = (((_e1735.member.member * _e1747) * _e1747) * bitcast<f32>((bitcast<u32>(((_e353 - (2i * _e1740)) + 127i)) << bitcast<u32>(23i))));
                        let _e1757 = select(340282350000000000000000000000000000000f, _e1755, (_e1755 < 340282350000000000000000000000000000000f));
                        phi_4502_ = type_25(select(-340282350000000000000000000000000000000f, _e1757, (_e1757 > -340282350000000000000000000000000000000f)), _e1735.member.member_1, _e1735.member.member_2, _e1735.member.member_3);
                    } else {
                        phi_4502_ = type_25(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                    }
                    let _e1764 = phi_4502_;
                    if _e230 {
                    } else {
                        break;
                    }
                    global_8.member[_e136] = _e1764;
                    if _e151 {
                    } else {
                        break;
                    }
                    let _e1768 = select(0u, 1u, (_e297 <= _e307));
                    if (_e1768 > 0u) {
                        let _e1770 = (1u < _e104);
                        if _e1770 {
                            if (0u < _e104) {
                            } else {
                                break;
                            }
                            let _e1774 = atomicAdd((&global_9.member[0u]), _e1768);
                            if ((_e1774 + _e1768) < _e1774) {
                                if _e1770 {
                                } else {
                                    break;
                                }
                                let _e1779 = atomicAdd((&global_9.member[1u]), 1u);
                            }
                        }
                    }
                    let _e1782 = select(0u, 1u, (_e1764.member_3 != 4294967295u));
                    if (_e1782 > 0u) {
                        let _e1784 = (3u < _e104);
                        if _e1784 {
                            if (2u < _e104) {
                            } else {
                                break;
                            }
                            let _e1788 = atomicAdd((&global_9.member[2u]), _e1782);
                            if ((_e1788 + _e1782) < _e1788) {
                                if _e1784 {
                                } else {
                                    break;
                                }
                                let _e1793 = atomicAdd((&global_9.member[3u]), 1u);
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
fn trace_paths_q21_f32_(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
