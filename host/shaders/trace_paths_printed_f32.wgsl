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

struct type_27 {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: u32,
}

struct type_29 {
    member: array<type_27>,
}

struct type_31 {
    member: array<f32, 3>,
    member_1: f32,
    member_2: array<f32, 3>,
    member_3: f32,
}

struct type_32 {
    member: type_31,
    member_1: array<f32, 3>,
    member_2: u32,
    member_3: array<f32, 3>,
    member_4: u32,
}

struct type_34 {
    member: array<type_32>,
}

struct type_40 {
    member: array<f32, 3>,
    member_1: u32,
    member_2: f32,
    member_3: array<u32, 3>,
}

struct type_43 {
    member: type_27,
    member_1: f32,
}

struct type_47 {
    member: array<vec4<u32>, 2>,
}

struct type_50 {
    member: array<i32>,
}

struct type_54 {
    member: array<u32, 2>,
    member_1: array<u32, 2>,
    member_2: u32,
    member_3: u32,
}

struct type_56 {
    member: array<type_54>,
}

struct type_60 {
    member: array<f32, 3>,
    member_1: array<f32, 3>,
}

struct type_62 {
    member: type_60,
    member_1: u32,
}

struct type_67 {
    member: array<atomic<u32>>,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_1: type_12;
@group(0) @binding(1) 
var<uniform> global_2: type_47;
@group(0) @binding(2) 
var<uniform> global_3: type_47;
@group(0) @binding(4) 
var<storage> global_4: type_20;
@group(0) @binding(5) 
var<storage> global_5: type_4;
@group(0) @binding(6) 
var<storage> global_6: type_50;
@group(0) @binding(7) 
var<storage> global_7: type_34;
@group(0) @binding(8) 
var<storage, read_write> global_8: type_29;
@group(0) @binding(9) 
var<storage, read_write> global_9: type_67;
@group(0) @binding(3) 
var<storage> global_10: type_56;

fn function_() {
    var local: array<f32, 128>;
    var local_1: array<f32, 128>;
    var local_2: array<f32, 128>;
    var local_3: array<f32, 128>;
    var local_4: array<f32, 128>;
    var local_5: array<f32, 128>;
    var local_6: array<u32, 128>;
    var local_7: array<f32, 3>;
    var local_8: array<f32, 3>;
    var local_9: array<f32, 128>;
    var local_10: array<f32, 3>;
    var local_11: array<f32, 3>;
    var local_12: array<f32, 3>;
    var local_13: array<f32, 3>;
    var local_14: array<u32, 3>;
    var local_15: array<u32, 3>;
    var local_16: array<f32, 3>;
    var local_17: array<f32, 3>;
    var phi_278_: u32;
    var phi_322_: i32;
    var phi_346_: type_40;
    var phi_452_: i32;
    var phi_453_: i32;
    var phi_463_: bool;
    var phi_473_: u32;
    var phi_474_: u32;
    var phi_476_: bool;
    var phi_481_: u32;
    var phi_514_: i32;
    var phi_532_: f32;
    var phi_538_: f32;
    var phi_549_: f32;
    var phi_555_: f32;
    var phi_578_: f32;
    var phi_589_: f32;
    var phi_598_: f32;
    var phi_604_: f32;
    var phi_615_: f32;
    var phi_621_: f32;
    var phi_644_: f32;
    var phi_655_: f32;
    var phi_664_: f32;
    var phi_670_: f32;
    var phi_681_: f32;
    var phi_687_: f32;
    var phi_710_: f32;
    var phi_721_: f32;
    var phi_821_: f32;
    var phi_822_: f32;
    var phi_3196_: bool;
    var phi_895_: type_43;
    var phi_898_: type_62;
    var phi_900_: u32;
    var phi_902_: bool;
    var phi_904_: u32;
    var phi_915_: bool;
    var phi_1001_: type_62;
    var phi_1002_: bool;
    var phi_1003_: u32;
    var phi_2124_: type_54;
    var phi_2133_: type_8;
    var phi_2134_: type_8;
    var phi_2157_: type_8;
    var phi_3189_: bool;
    var phi_2287_: type_8;
    var phi_2288_: type_8;
    var phi_2311_: type_8;
    var phi_3253_: bool;
    var phi_2874_: type_62;
    var phi_2951_: type_62;
    var phi_2952_: type_62;
    var phi_2953_: u32;
    var phi_2955_: type_62;
    var phi_2956_: u32;
    var phi_2957_: bool;
    var phi_2964_: type_62;
    var phi_2969_: type_62;
    var phi_2970_: bool;
    var phi_1021_: type_43;
    var phi_1024_: type_8;
    var phi_1025_: type_8;
    var phi_1047_: type_8;
    var phi_1068_: u32;
    var phi_1157_: array<array<f32, 3>, 3>;
    var phi_1628_: vec3<f32>;
    var phi_1629_: vec3<f32>;
    var phi_1660_: bool;
    var phi_1669_: vec3<f32>;
    var phi_1709_: type_27;
    var phi_1711_: type_27;
    var phi_1712_: bool;
    var phi_1716_: type_27;
    var phi_1717_: type_27;
    var phi_1718_: type_27;
    var phi_1719_: bool;
    var phi_1723_: type_27;
    var phi_1724_: bool;
    var phi_1728_: type_27;
    var phi_1729_: bool;
    var phi_1733_: type_27;
    var phi_1756_: u32;
    var phi_1770_: i32;
    var phi_1790_: vec3<f32>;
    var phi_1791_: vec3<f32>;
    var phi_1807_: vec3<f32>;
    var phi_1808_: vec3<f32>;
    var phi_1824_: vec3<f32>;
    var phi_1825_: vec3<f32>;
    var phi_1861_: vec3<f32>;
    var phi_2043_: f32;
    var phi_2061_: bool;
    var phi_2062_: bool;
    var phi_2081_: bool;
    var phi_2082_: bool;
    var phi_2088_: type_43;
    var phi_2089_: type_43;
    var phi_2090_: type_43;
    var phi_1022_: type_43;
    var phi_3261_: bool;
    var phi_3348_: bool;
    var phi_2972_: type_43;
    var phi_2973_: type_62;
    var phi_2974_: bool;
    var phi_2975_: u32;
    var phi_3347_: bool;
    var phi_2976_: type_43;
    var phi_2977_: type_62;
    var phi_2978_: u32;
    var phi_2979_: bool;
    var phi_2980_: u32;
    var phi_3346_: bool;
    var phi_2981_: type_43;
    var phi_2982_: type_62;
    var phi_2983_: u32;
    var phi_2984_: bool;
    var phi_2985_: u32;
    var phi_3345_: bool;
    var phi_896_: type_43;
    var phi_899_: type_62;
    var phi_901_: u32;
    var phi_903_: bool;
    var phi_905_: u32;
    var phi_2986_: bool;
    var phi_3344_: bool;
    var local_18: type_43;
    var phi_3038_: type_27;
    var local_19: type_43;

    switch bitcast<i32>(0u) {
        default: {
            let _e95 = global;
            let _e98 = arrayLength((&global_10.member));
            let _e100 = arrayLength((&global_4.member));
            let _e112 = arrayLength((&global_9.member));
            let _e116 = global_3.member[0u][0u];
            let _e120 = global_3.member[0u][1u];
            let _e124 = global_3.member[0u][2u];
            let _e128 = global_3.member[1u][0u];
            let _e132 = global_3.member[1u][1u];
            let _e136 = global_3.member[1u][2u];
            let _e140 = global_3.member[1u][3u];
            let _e144 = (_e95.x + (_e95.y * 2097152u));
            let _e151 = (_e144 < arrayLength((&global_7.member)));
            if _e151 {
                if _e151 {
                } else {
                    break;
                }
                let _e155 = global_7.member[_e144].member_2;
                phi_278_ = _e155;
            } else {
                phi_278_ = 4294967295u;
            }
            let _e157 = phi_278_;
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
                phi_322_ = -126i;
            } else {
                phi_322_ = select(_e200, 127i, (_e200 > 127i));
            }
            let _e205 = phi_322_;
            let _e210 = bitcast<f32>((bitcast<u32>((_e205 + 127i)) << bitcast<u32>(23i)));
            let _e216 = bitcast<f32>((bitcast<u32>(((_e200 - _e205) + 127i)) << bitcast<u32>(23i)));
            if (_e176 == 0u) {
                phi_346_ = type_40(array<f32, 3>(_e193, _e194, _e195), _e176, _e197, _e198);
            } else {
                phi_346_ = type_40(array<f32, 3>(((_e193 * _e210) * _e216), ((_e194 * _e210) * _e216), ((_e195 * _e210) * _e216)), _e176, ((_e197 * _e210) * _e216), _e198);
            }
            let _e229 = phi_346_;
            if _e151 {
                let _e230 = (_e144 < arrayLength((&global_8.member)));
                if _e230 {
                    if _e151 {
                    } else {
                        break;
                    }
                    let _e240 = global_7.member[_e144].member.member_2[0u];
                    let _e242 = (bitcast<u32>(_e240) & 2147483647u);
                    let _e248 = global_7.member[_e144].member.member_2[1u];
                    let _e250 = (bitcast<u32>(_e248) & 2147483647u);
                    let _e256 = global_7.member[_e144].member.member_2[2u];
                    let _e258 = (bitcast<u32>(_e256) & 2147483647u);
                    let _e264 = global_7.member[_e144].member.member[0u];
                    let _e266 = (bitcast<u32>(_e264) & 2147483647u);
                    let _e272 = global_7.member[_e144].member.member[1u];
                    let _e274 = (bitcast<u32>(_e272) & 2147483647u);
                    let _e280 = global_7.member[_e144].member.member[2u];
                    let _e282 = (bitcast<u32>(_e280) & 2147483647u);
                    let _e284 = select(_e250, _e242, (_e250 < _e242));
                    let _e286 = select(_e258, _e284, (_e258 < _e284));
                    let _e288 = select(_e266, _e286, (_e266 < _e286));
                    let _e290 = select(_e274, _e288, (_e274 < _e288));
                    let _e292 = select(_e282, _e290, (_e282 < _e290));
                    let _e297 = global_7.member[_e144].member.member_1;
                    let _e299 = (bitcast<u32>(_e297) & 2147483647u);
                    let _e307 = global_7.member[_e144].member.member_3;
                    let _e313 = (((select(_e299, _e292, (_e299 < _e292)) < 2139095040u) && ((bitcast<u32>(_e307) & 2147483647u) <= 2139095040u)) && (_e286 > 0u));
                    if _e313 {
                        let _e316 = (bitcast<u32>(bitcast<f32>(_e286)) & 2147483647u);
                        if (_e316 >= 8388608u) {
                            phi_452_ = (bitcast<i32>((_e316 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_452_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e316)), 32u, (_e316 == 0u))));
                        }
                        let _e330 = phi_452_;
                        phi_453_ = _e330;
                    } else {
                        phi_453_ = 0i;
                    }
                    let _e332 = phi_453_;
                    let _e333 = (_e242 == _e286);
                    if _e333 {
                        phi_463_ = true;
                    } else {
                        phi_463_ = (_e250 == _e286);
                    }
                    let _e336 = phi_463_;
                    let _e337 = select(1u, 0u, _e333);
                    if _e336 {
                        let _e338 = (_e337 + 1u);
                        phi_473_ = _e338;
                        phi_474_ = _e338;
                        phi_476_ = select(true, false, (_e338 == 2u));
                    } else {
                        phi_473_ = u32();
                        phi_474_ = 0u;
                        phi_476_ = true;
                    }
                    let _e342 = phi_473_;
                    let _e344 = phi_474_;
                    let _e346 = phi_476_;
                    if _e346 {
                        phi_481_ = (_e344 + 1u);
                    } else {
                        phi_481_ = 0u;
                    }
                    let _e350 = phi_481_;
                    let _e351 = select(_e342, _e344, _e346);
                    let _e352 = select(_e337, select(2u, _e337, _e336), _e346);
                    let _e353 = -(_e332);
                    if (_e353 < -126i) {
                        phi_514_ = -126i;
                    } else {
                        phi_514_ = select(_e353, 127i, (_e353 > 127i));
                    }
                    let _e358 = phi_514_;
                    let _e363 = bitcast<f32>((bitcast<u32>((_e358 + 127i)) << bitcast<u32>(23i)));
                    let _e369 = bitcast<f32>((bitcast<u32>(((_e353 - _e358) + 127i)) << bitcast<u32>(23i)));
                    let _e374 = global_7.member[_e144].member.member;
                    let _e375 = (_e351 == 0u);
                    if _e375 {
                        phi_532_ = _e374[0];
                    } else {
                        phi_532_ = _e374[1];
                    }
                    let _e379 = phi_532_;
                    let _e380 = (_e351 == 2u);
                    if _e380 {
                        phi_538_ = _e374[2];
                    } else {
                        phi_538_ = _e379;
                    }
                    let _e383 = phi_538_;
                    let _e384 = global_7.member[_e144].member.member_2;
                    if _e375 {
                        phi_549_ = _e384[0];
                    } else {
                        phi_549_ = _e384[1];
                    }
                    let _e388 = phi_549_;
                    if _e380 {
                        phi_555_ = _e384[2];
                    } else {
                        phi_555_ = _e388;
                    }
                    let _e391 = phi_555_;
                    let _e393 = ((_e391 * _e363) * _e369);
                    let _e397 = (bitcast<f32>((bitcast<u32>(_e393) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e397 {
                        let _e401 = (bitcast<f32>((bitcast<u32>(_e383) & 2147483647u)) * 0.00000011920929f);
                        phi_578_ = select(0.00000000000011368684f, _e401, (_e401 > 0.00000000000011368684f));
                    } else {
                        phi_578_ = 0f;
                    }
                    let _e405 = phi_578_;
                    let _e406 = (_e383 + _e405);
                    let _e407 = (_e383 - _e405);
                    let _e408 = select(_e393, 0f, _e397);
                    if _e397 {
                        phi_589_ = 38685626000000000000000000f;
                    } else {
                        phi_589_ = (1f / _e393);
                    }
                    let _e411 = phi_589_;
                    let _e412 = (_e350 == 0u);
                    if _e412 {
                        phi_598_ = _e374[0];
                    } else {
                        phi_598_ = _e374[1];
                    }
                    let _e416 = phi_598_;
                    let _e417 = (_e350 == 2u);
                    if _e417 {
                        phi_604_ = _e374[2];
                    } else {
                        phi_604_ = _e416;
                    }
                    let _e420 = phi_604_;
                    if _e412 {
                        phi_615_ = _e384[0];
                    } else {
                        phi_615_ = _e384[1];
                    }
                    let _e424 = phi_615_;
                    if _e417 {
                        phi_621_ = _e384[2];
                    } else {
                        phi_621_ = _e424;
                    }
                    let _e427 = phi_621_;
                    let _e429 = ((_e427 * _e363) * _e369);
                    let _e433 = (bitcast<f32>((bitcast<u32>(_e429) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e433 {
                        let _e437 = (bitcast<f32>((bitcast<u32>(_e420) & 2147483647u)) * 0.00000011920929f);
                        phi_644_ = select(0.00000000000011368684f, _e437, (_e437 > 0.00000000000011368684f));
                    } else {
                        phi_644_ = 0f;
                    }
                    let _e441 = phi_644_;
                    let _e442 = (_e420 + _e441);
                    let _e443 = (_e420 - _e441);
                    let _e444 = select(_e429, 0f, _e433);
                    if _e433 {
                        phi_655_ = 38685626000000000000000000f;
                    } else {
                        phi_655_ = (1f / _e429);
                    }
                    let _e447 = phi_655_;
                    let _e448 = (_e352 == 0u);
                    if _e448 {
                        phi_664_ = _e374[0];
                    } else {
                        phi_664_ = _e374[1];
                    }
                    let _e452 = phi_664_;
                    let _e453 = (_e352 == 2u);
                    if _e453 {
                        phi_670_ = _e374[2];
                    } else {
                        phi_670_ = _e452;
                    }
                    let _e456 = phi_670_;
                    if _e448 {
                        phi_681_ = _e384[0];
                    } else {
                        phi_681_ = _e384[1];
                    }
                    let _e460 = phi_681_;
                    if _e453 {
                        phi_687_ = _e384[2];
                    } else {
                        phi_687_ = _e460;
                    }
                    let _e463 = phi_687_;
                    let _e465 = ((_e463 * _e363) * _e369);
                    let _e469 = (bitcast<f32>((bitcast<u32>(_e465) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e469 {
                        let _e473 = (bitcast<f32>((bitcast<u32>(_e456) & 2147483647u)) * 0.00000011920929f);
                        phi_710_ = select(0.00000000000011368684f, _e473, (_e473 > 0.00000000000011368684f));
                    } else {
                        phi_710_ = 0f;
                    }
                    let _e477 = phi_710_;
                    let _e478 = (_e456 + _e477);
                    let _e479 = (_e456 - _e477);
                    let _e480 = select(_e465, 0f, _e469);
                    if _e469 {
                        phi_721_ = 38685626000000000000000000f;
                    } else {
                        phi_721_ = (1f / _e465);
                    }
                    let _e483 = phi_721_;
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
                        phi_821_ = select(-340282350000000000000000000000000000000f, _e523, (_e523 > -340282350000000000000000000000000000000f));
                        phi_822_ = select(-340282350000000000000000000000000000000f, _e516, (_e516 > -340282350000000000000000000000000000000f));
                    } else {
                        phi_821_ = 0f;
                        phi_822_ = 1f;
                    }
                    let _e527 = phi_821_;
                    let _e529 = phi_822_;
                    local_6 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                    local_5 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_4 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_3 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_1 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_9 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_17 = array<f32, 3>(bitcast<f32>(_e116), bitcast<f32>(_e120), bitcast<f32>(_e124));
                    let _e534 = (_e351 % 3u);
                    let _e535 = (_e534 < 3u);
                    if _e535 {
                    } else {
                        break;
                    }
                    let _e537 = local_17[_e534];
                    let _e538 = (_e350 % 3u);
                    let _e539 = (_e538 < 3u);
                    if _e539 {
                    } else {
                        break;
                    }
                    let _e541 = local_17[_e538];
                    let _e542 = (_e352 % 3u);
                    let _e543 = (_e542 < 3u);
                    if _e543 {
                    } else {
                        break;
                    }
                    let _e545 = local_17[_e542];
                    local_16 = array<f32, 3>(bitcast<f32>(_e128), bitcast<f32>(_e132), bitcast<f32>(_e136));
                    if _e535 {
                    } else {
                        break;
                    }
                    let _e549 = local_16[_e534];
                    if _e539 {
                    } else {
                        break;
                    }
                    let _e551 = local_16[_e538];
                    if _e543 {
                    } else {
                        break;
                    }
                    let _e553 = local_16[_e542];
                    phi_3196_ = false;
                    phi_895_ = type_43(type_27(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e527);
                    phi_898_ = type_62(type_60(array<f32, 3>(_e537, _e541, _e545), array<f32, 3>(_e549, _e551, _e553)), select(0u, 2147483648u, (_e98 == 0u)));
                    phi_900_ = ((3u * _e98) + 1u);
                    phi_902_ = (_e529 <= _e527);
                    phi_904_ = 0u;
                    loop {
                        let _e561 = phi_3196_;
                        let _e563 = phi_895_;
                        let _e565 = phi_898_;
                        let _e567 = phi_900_;
                        let _e569 = phi_902_;
                        let _e571 = phi_904_;
                        local_18 = _e563;
                        if _e569 {
                            phi_915_ = true;
                        } else {
                            phi_915_ = (_e571 > 0u);
                        }
                        let _e574 = phi_915_;
                        if _e574 {
                            let _e575 = (_e567 > 0u);
                            if _e575 {
                                if _e569 {
                                    phi_1001_ = _e565;
                                    phi_1002_ = _e569;
                                    phi_1003_ = _e571;
                                } else {
                                    let _e576 = (_e571 - 1u);
                                    let _e577 = (_e576 % 128u);
                                    let _e578 = (_e577 < 128u);
                                    if _e578 {
                                    } else {
                                        phi_3344_ = true;
                                        break;
                                    }
                                    let _e580 = local_6[_e577];
                                    if _e578 {
                                    } else {
                                        phi_3344_ = true;
                                        break;
                                    }
                                    let _e582 = local_5[_e577];
                                    if _e578 {
                                    } else {
                                        phi_3344_ = true;
                                        break;
                                    }
                                    let _e584 = local_4[_e577];
                                    if _e578 {
                                    } else {
                                        phi_3344_ = true;
                                        break;
                                    }
                                    let _e586 = local_3[_e577];
                                    if _e578 {
                                    } else {
                                        phi_3344_ = true;
                                        break;
                                    }
                                    let _e589 = local_2[_e577];
                                    if _e578 {
                                    } else {
                                        phi_3344_ = true;
                                        break;
                                    }
                                    let _e591 = local_1[_e577];
                                    if _e578 {
                                    } else {
                                        phi_3344_ = true;
                                        break;
                                    }
                                    let _e593 = local[_e577];
                                    if _e578 {
                                    } else {
                                        phi_3344_ = true;
                                        break;
                                    }
                                    let _e598 = local_9[_e577];
                                    phi_1001_ = type_62(type_60(array<f32, 3>(_e582, _e584, _e586), array<f32, 3>(_e589, _e591, _e593)), _e580);
                                    phi_1002_ = (_e598 <= _e563.member_1);
                                    phi_1003_ = _e576;
                                }
                                let _e602 = phi_1001_;
                                let _e604 = phi_1002_;
                                let _e606 = phi_1003_;
                                if _e604 {
                                    if ((_e602.member_1 & 2147483648u) != 0u) {
                                        phi_1021_ = _e563;
                                        phi_1024_ = type_8(0u, ((_e602.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e931 = phi_1021_;
                                            let _e933 = phi_1024_;
                                            local_19 = _e931;
                                            if (_e933.member < _e933.member_1) {
                                                phi_1025_ = type_8((_e933.member + 1u), _e933.member_1);
                                                phi_1047_ = type_8(1u, _e933.member);
                                            } else {
                                                phi_1025_ = _e933;
                                                phi_1047_ = type_8(0u, type_8().member_1);
                                            }
                                            let _e946 = phi_1025_;
                                            let _e948 = phi_1047_;
                                            let _e952 = (bitcast<i32>(_e948.member) != 0i);
                                            if _e952 {
                                                let _e953 = ((_e602.member_1 & 268435455u) + _e948.member_1);
                                                let _e954 = (_e953 < _e100);
                                                if _e954 {
                                                    if _e954 {
                                                    } else {
                                                        phi_3261_ = true;
                                                        break;
                                                    }
                                                    let _e958 = global_4.member[_e953].member_1;
                                                    phi_1068_ = _e958;
                                                } else {
                                                    phi_1068_ = 4294967295u;
                                                }
                                                let _e960 = phi_1068_;
                                                if (_e953 >= _e100) {
                                                    phi_1157_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                } else {
                                                    if _e954 {
                                                    } else {
                                                        phi_3261_ = true;
                                                        break;
                                                    }
                                                    if (_e534 < 9u) {
                                                    } else {
                                                        phi_3261_ = true;
                                                        break;
                                                    }
                                                    let _e967 = global_4.member[_e953].member[_e534];
                                                    if (_e538 < 9u) {
                                                    } else {
                                                        phi_3261_ = true;
                                                        break;
                                                    }
                                                    let _e973 = global_4.member[_e953].member[_e538];
                                                    if (_e542 < 9u) {
                                                    } else {
                                                        phi_3261_ = true;
                                                        break;
                                                    }
                                                    let _e979 = global_4.member[_e953].member[_e542];
                                                    let _e981 = (3u + _e534);
                                                    if (_e981 < 9u) {
                                                    } else {
                                                        phi_3261_ = true;
                                                        break;
                                                    }
                                                    let _e987 = global_4.member[_e953].member[_e981];
                                                    let _e988 = (3u + _e538);
                                                    if (_e988 < 9u) {
                                                    } else {
                                                        phi_3261_ = true;
                                                        break;
                                                    }
                                                    let _e994 = global_4.member[_e953].member[_e988];
                                                    let _e995 = (3u + _e542);
                                                    if (_e995 < 9u) {
                                                    } else {
                                                        phi_3261_ = true;
                                                        break;
                                                    }
                                                    let _e1001 = global_4.member[_e953].member[_e995];
                                                    let _e1003 = (6u + _e534);
                                                    if (_e1003 < 9u) {
                                                    } else {
                                                        phi_3261_ = true;
                                                        break;
                                                    }
                                                    let _e1009 = global_4.member[_e953].member[_e1003];
                                                    let _e1010 = (6u + _e538);
                                                    if (_e1010 < 9u) {
                                                    } else {
                                                        phi_3261_ = true;
                                                        break;
                                                    }
                                                    let _e1016 = global_4.member[_e953].member[_e1010];
                                                    let _e1017 = (6u + _e542);
                                                    if (_e1017 < 9u) {
                                                    } else {
                                                        phi_3261_ = true;
                                                        break;
                                                    }
                                                    let _e1023 = global_4.member[_e953].member[_e1017];
                                                    phi_1157_ = array<array<f32, 3>, 3>(array<f32, 3>(_e967, _e973, _e979), array<f32, 3>(_e987, _e994, _e1001), array<f32, 3>(_e1009, _e1016, _e1023));
                                                }
                                                let _e1027 = phi_1157_;
                                                let _e1035 = (_e1027[0][2] - _e456);
                                                let _e1038 = (((_e1027[0][0] - _e383) * _e480) - (_e1035 * _e408));
                                                let _e1041 = (((_e1027[0][1] - _e420) * _e480) - (_e1035 * _e444));
                                                let _e1048 = (_e1027[1][2] - _e456);
                                                let _e1051 = (((_e1027[1][0] - _e383) * _e480) - (_e1048 * _e408));
                                                let _e1054 = (((_e1027[1][1] - _e420) * _e480) - (_e1048 * _e444));
                                                let _e1061 = (_e1027[2][2] - _e456);
                                                let _e1064 = (((_e1027[2][0] - _e383) * _e480) - (_e1061 * _e408));
                                                let _e1067 = (((_e1027[2][1] - _e420) * _e480) - (_e1061 * _e444));
                                                let _e1068 = (_e1064 * _e1054);
                                                let _e1069 = (_e1067 * _e1051);
                                                let _e1070 = (_e1038 * _e1067);
                                                let _e1071 = (_e1041 * _e1064);
                                                let _e1072 = (_e1051 * _e1041);
                                                let _e1073 = (_e1054 * _e1038);
                                                let _e1078 = (((_e1068 >= _e1069) && (_e1070 >= _e1071)) && (_e1072 >= _e1073));
                                                if (_e1078 || (((_e1068 <= _e1069) && (_e1070 <= _e1071)) && (_e1072 <= _e1073))) {
                                                    let _e1085 = select(-1f, 1f, _e1078);
                                                    let _e1087 = ((_e1068 - _e1069) * _e1085);
                                                    let _e1089 = select(0f, _e1087, (_e1087 > 0f));
                                                    let _e1091 = ((_e1070 - _e1071) * _e1085);
                                                    let _e1093 = select(0f, _e1091, (_e1091 > 0f));
                                                    let _e1095 = ((_e1072 - _e1073) * _e1085);
                                                    let _e1097 = select(0f, _e1095, (_e1095 > 0f));
                                                    let _e1099 = ((_e1089 + _e1093) + _e1097);
                                                    if (_e1099 < 0.000000000000000000000000000000000000011754944f) {
                                                        phi_1723_ = type_27();
                                                        phi_1724_ = true;
                                                    } else {
                                                        let _e1102 = select(_e1027[1][0], _e1027[0][0], (_e1027[0][0] < _e1027[1][0]));
                                                        let _e1106 = select(_e1027[1][0], _e1027[0][0], (_e1027[0][0] > _e1027[1][0]));
                                                        let _e1110 = select(_e1027[1][1], _e1027[0][1], (_e1027[0][1] < _e1027[1][1]));
                                                        let _e1114 = select(_e1027[1][1], _e1027[0][1], (_e1027[0][1] > _e1027[1][1]));
                                                        let _e1118 = select(_e1027[1][2], _e1027[0][2], (_e1027[0][2] < _e1027[1][2]));
                                                        let _e1122 = select(_e1027[1][2], _e1027[0][2], (_e1027[0][2] > _e1027[1][2]));
                                                        let _e1127 = ((select(_e1027[2][0], _e1102, (_e1102 < _e1027[2][0])) - _e406) * _e411);
                                                        let _e1128 = ((select(_e1027[2][0], _e1106, (_e1106 > _e1027[2][0])) - _e407) * _e411);
                                                        let _e1131 = ((select(_e1027[2][1], _e1110, (_e1110 < _e1027[2][1])) - _e442) * _e447);
                                                        let _e1132 = ((select(_e1027[2][1], _e1114, (_e1114 > _e1027[2][1])) - _e443) * _e447);
                                                        let _e1135 = ((select(_e1027[2][2], _e1118, (_e1118 < _e1027[2][2])) - _e478) * _e483);
                                                        let _e1136 = ((select(_e1027[2][2], _e1122, (_e1122 > _e1027[2][2])) - _e479) * _e483);
                                                        let _e1138 = select(_e1136, _e1135, (_e1135 < _e1136));
                                                        let _e1140 = select(_e1136, _e1135, (_e1135 > _e1136));
                                                        let _e1142 = select(_e1128, _e1127, (_e1127 < _e1128));
                                                        let _e1144 = select(_e1132, _e1131, (_e1131 < _e1132));
                                                        let _e1146 = select(_e1144, _e1142, (_e1142 > _e1144));
                                                        let _e1148 = select(_e1138, _e1146, (_e1146 > _e1138));
                                                        let _e1150 = select(_e1128, _e1127, (_e1127 > _e1128));
                                                        let _e1152 = select(_e1132, _e1131, (_e1131 > _e1132));
                                                        let _e1154 = select(_e1152, _e1150, (_e1150 < _e1152));
                                                        let _e1156 = select(_e1140, _e1154, (_e1154 < _e1140));
                                                        let _e1157 = -(_e1138);
                                                        let _e1163 = select(_e529, _e1148, (_e1148 > _e529));
                                                        if (_e1163 > (_e1156 + (select(_e1157, _e1140, (_e1140 > _e1157)) * 0.0000019073523f))) {
                                                            phi_1718_ = type_27();
                                                            phi_1719_ = true;
                                                        } else {
                                                            let _e1165 = (_e1163 > _e931.member_1);
                                                            if _e1165 {
                                                                phi_1717_ = type_27();
                                                            } else {
                                                                let _e1169 = (_e1027[1][0] - _e1027[0][0]);
                                                                let _e1170 = (_e1027[1][1] - _e1027[0][1]);
                                                                let _e1171 = (_e1027[1][2] - _e1027[0][2]);
                                                                let _e1172 = vec3<f32>(_e1169, _e1170, _e1171);
                                                                let _e1173 = (_e1027[2][0] - _e1027[1][0]);
                                                                let _e1174 = (_e1027[2][1] - _e1027[1][1]);
                                                                let _e1175 = (_e1027[2][2] - _e1027[1][2]);
                                                                let _e1176 = vec3<f32>(_e1173, _e1174, _e1175);
                                                                let _e1177 = (_e1027[0][0] - _e1027[2][0]);
                                                                let _e1178 = (_e1027[0][1] - _e1027[2][1]);
                                                                let _e1179 = (_e1027[0][2] - _e1027[2][2]);
                                                                let _e1180 = vec3<f32>(_e1177, _e1178, _e1179);
                                                                let _e1183 = bitcast<f32>((bitcast<u32>(_e1169) & 2147483647u));
                                                                let _e1186 = bitcast<f32>((bitcast<u32>(_e1170) & 2147483647u));
                                                                let _e1188 = select(_e1186, _e1183, (_e1183 > _e1186));
                                                                let _e1191 = bitcast<f32>((bitcast<u32>(_e1171) & 2147483647u));
                                                                let _e1193 = select(_e1191, _e1188, (_e1188 > _e1191));
                                                                let _e1196 = bitcast<f32>((bitcast<u32>(_e1173) & 2147483647u));
                                                                let _e1199 = bitcast<f32>((bitcast<u32>(_e1174) & 2147483647u));
                                                                let _e1201 = select(_e1199, _e1196, (_e1196 > _e1199));
                                                                let _e1204 = bitcast<f32>((bitcast<u32>(_e1175) & 2147483647u));
                                                                let _e1206 = select(_e1204, _e1201, (_e1201 > _e1204));
                                                                let _e1209 = bitcast<f32>((bitcast<u32>(_e1177) & 2147483647u));
                                                                let _e1212 = bitcast<f32>((bitcast<u32>(_e1178) & 2147483647u));
                                                                let _e1214 = select(_e1212, _e1209, (_e1209 > _e1212));
                                                                let _e1217 = bitcast<f32>((bitcast<u32>(_e1179) & 2147483647u));
                                                                let _e1219 = select(_e1217, _e1214, (_e1214 > _e1217));
                                                                let _e1221 = select(_e1206, _e1193, (_e1193 > _e1206));
                                                                let _e1223 = select(_e1219, _e1221, (_e1221 > _e1219));
                                                                if (_e1193 == _e1223) {
                                                                    phi_1628_ = _e1176;
                                                                    phi_1629_ = _e1180;
                                                                } else {
                                                                    let _e1226 = vec3((_e1206 == _e1223));
                                                                    phi_1628_ = select(_e1172, _e1180, _e1226);
                                                                    phi_1629_ = select(_e1176, _e1172, _e1226);
                                                                }
                                                                let _e1230 = phi_1628_;
                                                                let _e1232 = phi_1629_;
                                                                let _e1239 = ((_e1230.y * _e1232.z) - (_e1232.y * _e1230.z));
                                                                let _e1244 = ((_e1230.z * _e1232.x) - (_e1232.z * _e1230.x));
                                                                let _e1247 = ((_e1230.x * _e1232.y) - (_e1232.x * _e1230.y));
                                                                if (_e1089 >= _e1093) {
                                                                    phi_1660_ = select(true, false, (_e1089 >= _e1097));
                                                                } else {
                                                                    phi_1660_ = true;
                                                                }
                                                                let _e1252 = phi_1660_;
                                                                if _e1252 {
                                                                    phi_1669_ = select(vec3<f32>(_e1027[2][0], _e1027[2][1], _e1027[2][2]), vec3<f32>(_e1027[1][0], _e1027[1][1], _e1027[1][2]), vec3((_e1093 >= _e1097)));
                                                                } else {
                                                                    phi_1669_ = vec3<f32>(_e1027[0][0], _e1027[0][1], _e1027[0][2]);
                                                                }
                                                                let _e1257 = phi_1669_;
                                                                let _e1274 = ((((_e1239 * (_e1257.x - _e383)) + (_e1244 * (_e1257.y - _e420))) + (_e1247 * (_e1257.z - _e456))) / (((_e1239 * _e408) + (_e1244 * _e444)) + (_e1247 * _e480)));
                                                                let _e1276 = select(_e1156, _e1274, (_e1274 < _e1156));
                                                                let _e1278 = select(_e1148, _e1276, (_e1276 > _e1148));
                                                                if (_e1278 >= _e529) {
                                                                    let _e1280 = (_e1278 <= _e931.member_1);
                                                                    if _e1280 {
                                                                        let _e1281 = (1f / _e1099);
                                                                        phi_1709_ = type_27(_e1278, (_e1093 * _e1281), (_e1097 * _e1281), _e960);
                                                                    } else {
                                                                        phi_1709_ = type_27();
                                                                    }
                                                                    let _e1286 = phi_1709_;
                                                                    phi_1711_ = _e1286;
                                                                    phi_1712_ = select(true, false, _e1280);
                                                                } else {
                                                                    phi_1711_ = type_27();
                                                                    phi_1712_ = true;
                                                                }
                                                                let _e1289 = phi_1711_;
                                                                let _e1291 = phi_1712_;
                                                                if _e1291 {
                                                                    phi_1716_ = type_27(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                } else {
                                                                    phi_1716_ = _e1289;
                                                                }
                                                                let _e1293 = phi_1716_;
                                                                phi_1717_ = _e1293;
                                                            }
                                                            let _e1295 = phi_1717_;
                                                            phi_1718_ = _e1295;
                                                            phi_1719_ = _e1165;
                                                        }
                                                        let _e1297 = phi_1718_;
                                                        let _e1299 = phi_1719_;
                                                        phi_1723_ = _e1297;
                                                        phi_1724_ = _e1299;
                                                    }
                                                    let _e1301 = phi_1723_;
                                                    let _e1303 = phi_1724_;
                                                    phi_1728_ = _e1301;
                                                    phi_1729_ = _e1303;
                                                } else {
                                                    phi_1728_ = type_27();
                                                    phi_1729_ = true;
                                                }
                                                let _e1305 = phi_1728_;
                                                let _e1307 = phi_1729_;
                                                if _e1307 {
                                                    phi_1733_ = type_27(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                } else {
                                                    phi_1733_ = _e1305;
                                                }
                                                let _e1309 = phi_1733_;
                                                if (_e1309.member_3 != 4294967295u) {
                                                    if (_e960 == _e157) {
                                                        phi_2062_ = false;
                                                    } else {
                                                        let _e1313 = (_e960 < arrayLength((&global_5.member)));
                                                        if _e1313 {
                                                            if _e1313 {
                                                            } else {
                                                                phi_3261_ = true;
                                                                break;
                                                            }
                                                            let _e1315 = global_5.member[_e960];
                                                            phi_1756_ = _e1315;
                                                        } else {
                                                            phi_1756_ = 4294967295u;
                                                        }
                                                        let _e1317 = phi_1756_;
                                                        let _e1318 = (_e1317 < arrayLength((&global_6.member)));
                                                        if _e1318 {
                                                            if _e1318 {
                                                            } else {
                                                                phi_3261_ = true;
                                                                break;
                                                            }
                                                            let _e1320 = global_6.member[_e1317];
                                                            phi_1770_ = _e1320;
                                                        } else {
                                                            phi_1770_ = 0i;
                                                        }
                                                        let _e1322 = phi_1770_;
                                                        let _e1323 = (_e1322 == 0i);
                                                        if _e1323 {
                                                            phi_2061_ = true;
                                                        } else {
                                                            if _e375 {
                                                                phi_1791_ = vec3<f32>(_e1027[0][0], _e1027[0][1], _e1027[0][2]);
                                                            } else {
                                                                if (_e351 == 1u) {
                                                                    phi_1790_ = vec3<f32>(_e1027[0][2], _e1027[0][0], _e1027[0][1]);
                                                                } else {
                                                                    phi_1790_ = vec3<f32>(_e1027[0][1], _e1027[0][2], _e1027[0][0]);
                                                                }
                                                                let _e1328 = phi_1790_;
                                                                phi_1791_ = _e1328;
                                                            }
                                                            let _e1331 = phi_1791_;
                                                            if _e375 {
                                                                phi_1808_ = vec3<f32>(_e1027[1][0], _e1027[1][1], _e1027[1][2]);
                                                            } else {
                                                                if (_e351 == 1u) {
                                                                    phi_1807_ = vec3<f32>(_e1027[1][2], _e1027[1][0], _e1027[1][1]);
                                                                } else {
                                                                    phi_1807_ = vec3<f32>(_e1027[1][1], _e1027[1][2], _e1027[1][0]);
                                                                }
                                                                let _e1336 = phi_1807_;
                                                                phi_1808_ = _e1336;
                                                            }
                                                            let _e1339 = phi_1808_;
                                                            if _e375 {
                                                                phi_1825_ = vec3<f32>(_e1027[2][0], _e1027[2][1], _e1027[2][2]);
                                                            } else {
                                                                if (_e351 == 1u) {
                                                                    phi_1824_ = vec3<f32>(_e1027[2][2], _e1027[2][0], _e1027[2][1]);
                                                                } else {
                                                                    phi_1824_ = vec3<f32>(_e1027[2][1], _e1027[2][2], _e1027[2][0]);
                                                                }
                                                                let _e1344 = phi_1824_;
                                                                phi_1825_ = _e1344;
                                                            }
                                                            let _e1347 = phi_1825_;
                                                            let _e1350 = (_e1339.x - _e1331.x);
                                                            let _e1353 = (_e1339.y - _e1331.y);
                                                            let _e1356 = (_e1339.z - _e1331.z);
                                                            let _e1358 = (_e1347.x - _e1331.x);
                                                            let _e1360 = (_e1347.y - _e1331.y);
                                                            let _e1362 = (_e1347.z - _e1331.z);
                                                            if (_e229.member_1 == 1u) {
                                                                phi_1861_ = (vec3<f32>(_e229.member[0], _e229.member[1], _e229.member[2]) - _e1331);
                                                            } else {
                                                                phi_1861_ = vec3<f32>(_e229.member[0], _e229.member[1], _e229.member[2]);
                                                            }
                                                            let _e1377 = phi_1861_;
                                                            let _e1383 = bitcast<f32>((bitcast<u32>((_e1350 * _e1360)) ^ _e229.member_3[0]));
                                                            let _e1387 = bitcast<f32>((bitcast<u32>((_e1353 * _e1358)) ^ _e229.member_3[0]));
                                                            let _e1391 = bitcast<f32>((bitcast<u32>((_e1353 * _e1362)) ^ _e229.member_3[0]));
                                                            let _e1395 = bitcast<f32>((bitcast<u32>((_e1356 * _e1360)) ^ _e229.member_3[0]));
                                                            let _e1399 = bitcast<f32>((bitcast<u32>((_e1356 * _e1358)) ^ _e229.member_3[0]));
                                                            let _e1403 = bitcast<f32>((bitcast<u32>((_e1350 * _e1362)) ^ _e229.member_3[0]));
                                                            let _e1404 = (_e1391 - _e1395);
                                                            let _e1405 = (_e1399 - _e1403);
                                                            let _e1406 = (_e1383 - _e1387);
                                                            let _e1430 = (bitcast<f32>((bitcast<u32>(_e1391) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1395) & 2147483647u)));
                                                            let _e1437 = (bitcast<f32>((bitcast<u32>(_e1399) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1403) & 2147483647u)));
                                                            let _e1444 = (bitcast<f32>((bitcast<u32>(_e1383) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1387) & 2147483647u)));
                                                            if (_e229.member_2 == 0f) {
                                                                phi_2043_ = 0f;
                                                            } else {
                                                                let _e1474 = bitcast<f32>((bitcast<u32>(_e1404) & 2147483647u));
                                                                let _e1477 = bitcast<f32>((bitcast<u32>(_e1405) & 2147483647u));
                                                                let _e1480 = bitcast<f32>((bitcast<u32>(_e1406) & 2147483647u));
                                                                let _e1482 = select(_e1480, _e1477, (_e1477 > _e1480));
                                                                let _e1486 = select(_e1480, _e1477, (_e1477 < _e1480));
                                                                let _e1490 = select(_e1477, _e1474, (_e1474 < _e1477));
                                                                let _e1492 = select(_e1477, _e1474, (_e1474 > _e1477));
                                                                let _e1494 = select(_e1480, _e1492, (_e1492 < _e1480));
                                                                phi_2043_ = bitcast<f32>((bitcast<u32>((_e229.member_2 * bitcast<f32>((bitcast<u32>(((((select(_e1482, _e1474, (_e1474 > _e1482)) + bitcast<f32>((bitcast<u32>((0.414214f * select(_e1494, _e1490, (_e1490 > _e1494)))) ^ _e229.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.317838f * select(_e1486, _e1474, (_e1474 < _e1486)))) ^ _e229.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.0000004768374f * ((_e1430 + _e1437) + _e1444))) ^ _e229.member_3[0]))) * 1.0000005f)) ^ _e229.member_3[0])))) ^ _e229.member_3[0]));
                                                            }
                                                            let _e1521 = phi_2043_;
                                                            phi_2061_ = (_e1323 || !(((((bitcast<f32>((bitcast<u32>((_e1377.x * _e1404)) ^ _e229.member_3[0])) + bitcast<f32>((bitcast<u32>((_e1377.y * _e1405)) ^ _e229.member_3[0]))) + bitcast<f32>((bitcast<u32>((_e1377.z * _e1406)) ^ _e229.member_3[0]))) * f32(-(_e1322))) > ((bitcast<f32>((bitcast<u32>((0.0000009536752f * ((bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1377.x) & 2147483647u)) * _e1430)) ^ _e229.member_3[0])) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1377.y) & 2147483647u)) * _e1437)) ^ _e229.member_3[0]))) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1377.z) & 2147483647u)) * _e1444)) ^ _e229.member_3[0]))))) ^ _e229.member_3[0])) + _e1521) + 0.0000000000000000000000000000000000001880791f))));
                                                        }
                                                        let _e1535 = phi_2061_;
                                                        phi_2062_ = _e1535;
                                                    }
                                                    let _e1537 = phi_2062_;
                                                    if _e1537 {
                                                        if (_e1309.member < _e931.member.member) {
                                                            phi_2082_ = true;
                                                        } else {
                                                            if (_e1309.member == _e931.member.member) {
                                                                phi_2081_ = (_e1309.member_3 < _e931.member.member_3);
                                                            } else {
                                                                phi_2081_ = false;
                                                            }
                                                            let _e1547 = phi_2081_;
                                                            phi_2082_ = _e1547;
                                                        }
                                                        let _e1549 = phi_2082_;
                                                        if _e1549 {
                                                            phi_2088_ = type_43(_e1309, _e1309.member);
                                                        } else {
                                                            phi_2088_ = _e931;
                                                        }
                                                        let _e1552 = phi_2088_;
                                                        phi_2089_ = _e1552;
                                                    } else {
                                                        phi_2089_ = _e931;
                                                    }
                                                    let _e1554 = phi_2089_;
                                                    phi_2090_ = _e1554;
                                                } else {
                                                    phi_2090_ = _e931;
                                                }
                                                let _e1556 = phi_2090_;
                                                phi_1022_ = _e1556;
                                            } else {
                                                phi_1022_ = type_43();
                                            }
                                            let _e1558 = phi_1022_;
                                            continue;
                                            continuing {
                                                phi_1021_ = _e1558;
                                                phi_1024_ = _e946;
                                                phi_3261_ = _e561;
                                                break if !(_e952);
                                            }
                                        }
                                        let _e1561 = phi_3261_;
                                        phi_3344_ = _e1561;
                                        if _e1561 {
                                            break;
                                        }
                                        phi_3348_ = _e1561;
                                        let _e1777 = local_19;
                                        phi_2972_ = _e1777;
                                        phi_2973_ = _e602;
                                        phi_2974_ = false;
                                        phi_2975_ = _e606;
                                    } else {
                                        local_8 = array<f32, 3>(_e602.member.member[0], _e602.member.member[1], _e602.member.member[2]);
                                        local_7 = array<f32, 3>(_e602.member.member_1[0], _e602.member.member_1[1], _e602.member.member_1[2]);
                                        let _e626 = (_e602.member_1 < _e98);
                                        if _e626 {
                                            if _e626 {
                                            } else {
                                                phi_3344_ = true;
                                                break;
                                            }
                                            let _e628 = global_10.member[_e602.member_1];
                                            phi_2124_ = _e628;
                                        } else {
                                            phi_2124_ = type_54(array<u32, 2>(0u, 0u), array<u32, 2>(0u, 0u), 2147483648u, 2147483648u);
                                        }
                                        let _e630 = phi_2124_;
                                        let _e632 = array<u32, 3>(_e351, _e350, _e352);
                                        local_15 = _e632;
                                        local_11 = array<f32, 3>(0f, 0f, 0f);
                                        local_10 = array<f32, 3>(0f, 0f, 0f);
                                        phi_2133_ = type_8(0u, 3u);
                                        loop {
                                            let _e634 = phi_2133_;
                                            if (_e634.member < _e634.member_1) {
                                                phi_2134_ = type_8((_e634.member + 1u), _e634.member_1);
                                                phi_2157_ = type_8(1u, _e634.member);
                                            } else {
                                                phi_2134_ = _e634;
                                                phi_2157_ = type_8(0u, type_8().member_1);
                                            }
                                            let _e647 = phi_2134_;
                                            let _e649 = phi_2157_;
                                            let _e653 = (bitcast<i32>(_e649.member) != 0i);
                                            if _e653 {
                                                let _e654 = (_e649.member_1 < 3u);
                                                if _e654 {
                                                } else {
                                                    phi_3189_ = true;
                                                    break;
                                                }
                                                let _e656 = local_15[_e649.member_1];
                                                if _e654 {
                                                } else {
                                                    phi_3189_ = true;
                                                    break;
                                                }
                                                let _e658 = local_8[_e649.member_1];
                                                if _e654 {
                                                } else {
                                                    phi_3189_ = true;
                                                    break;
                                                }
                                                let _e660 = local_7[_e649.member_1];
                                                let _e663 = ((10u * _e656) & 31u);
                                                let _e666 = ((_e630.member[0] >> bitcast<u32>(_e663)) & 1023u);
                                                let _e671 = bitcast<f32>((bitcast<u32>(((_e660 - _e658) * 0.0009775171f)) ^ _e140));
                                                let _e677 = (_e658 + bitcast<f32>((bitcast<u32>((f32(_e666) * _e671)) ^ _e140)));
                                                if _e654 {
                                                } else {
                                                    phi_3189_ = true;
                                                    break;
                                                }
                                                local_11[_e649.member_1] = select(select(_e660, _e677, (_e677 < _e660)), _e660, (_e666 == 1023u));
                                                let _e686 = ((_e630.member[1] >> bitcast<u32>(_e663)) & 1023u);
                                                let _e692 = (_e658 + bitcast<f32>((bitcast<u32>((f32(_e686) * _e671)) ^ _e140)));
                                                if _e654 {
                                                } else {
                                                    phi_3189_ = true;
                                                    break;
                                                }
                                                local_10[_e649.member_1] = select(select(_e660, _e692, (_e692 < _e660)), _e660, (_e686 == 1023u));
                                            }
                                            continue;
                                            continuing {
                                                phi_2133_ = _e647;
                                                phi_3189_ = _e561;
                                                break if !(_e653);
                                            }
                                        }
                                        let _e700 = phi_3189_;
                                        phi_3344_ = _e700;
                                        if _e700 {
                                            break;
                                        }
                                        let _e701 = local_10;
                                        let _e702 = local_11;
                                        local_14 = _e632;
                                        local_13 = array<f32, 3>(0f, 0f, 0f);
                                        local_12 = array<f32, 3>(0f, 0f, 0f);
                                        phi_2287_ = type_8(0u, 3u);
                                        loop {
                                            let _e711 = phi_2287_;
                                            if (_e711.member < _e711.member_1) {
                                                phi_2288_ = type_8((_e711.member + 1u), _e711.member_1);
                                                phi_2311_ = type_8(1u, _e711.member);
                                            } else {
                                                phi_2288_ = _e711;
                                                phi_2311_ = type_8(0u, type_8().member_1);
                                            }
                                            let _e724 = phi_2288_;
                                            let _e726 = phi_2311_;
                                            let _e730 = (bitcast<i32>(_e726.member) != 0i);
                                            if _e730 {
                                                let _e731 = (_e726.member_1 < 3u);
                                                if _e731 {
                                                } else {
                                                    phi_3253_ = true;
                                                    break;
                                                }
                                                let _e733 = local_14[_e726.member_1];
                                                if _e731 {
                                                } else {
                                                    phi_3253_ = true;
                                                    break;
                                                }
                                                let _e735 = local_8[_e726.member_1];
                                                if _e731 {
                                                } else {
                                                    phi_3253_ = true;
                                                    break;
                                                }
                                                let _e737 = local_7[_e726.member_1];
                                                let _e740 = ((10u * _e733) & 31u);
                                                let _e743 = ((_e630.member_1[0] >> bitcast<u32>(_e740)) & 1023u);
                                                let _e748 = bitcast<f32>((bitcast<u32>(((_e737 - _e735) * 0.0009775171f)) ^ _e140));
                                                let _e754 = (_e735 + bitcast<f32>((bitcast<u32>((f32(_e743) * _e748)) ^ _e140)));
                                                if _e731 {
                                                } else {
                                                    phi_3253_ = true;
                                                    break;
                                                }
                                                local_13[_e726.member_1] = select(select(_e737, _e754, (_e754 < _e737)), _e737, (_e743 == 1023u));
                                                let _e763 = ((_e630.member_1[1] >> bitcast<u32>(_e740)) & 1023u);
                                                let _e769 = (_e735 + bitcast<f32>((bitcast<u32>((f32(_e763) * _e748)) ^ _e140)));
                                                if _e731 {
                                                } else {
                                                    phi_3253_ = true;
                                                    break;
                                                }
                                                local_12[_e726.member_1] = select(select(_e737, _e769, (_e769 < _e737)), _e737, (_e763 == 1023u));
                                            }
                                            continue;
                                            continuing {
                                                phi_2287_ = _e724;
                                                phi_3253_ = _e700;
                                                break if !(_e730);
                                            }
                                        }
                                        let _e777 = phi_3253_;
                                        phi_3344_ = _e777;
                                        if _e777 {
                                            break;
                                        }
                                        let _e778 = local_12;
                                        let _e779 = local_13;
                                        let _e790 = type_62(type_60(array<f32, 3>(_e702[0], _e702[1], _e702[2]), array<f32, 3>(_e701[0], _e701[1], _e701[2])), _e630.member_2);
                                        let _e795 = type_62(type_60(array<f32, 3>(_e779[0], _e779[1], _e779[2]), array<f32, 3>(_e778[0], _e778[1], _e778[2])), _e630.member_3);
                                        let _e801 = ((_e702[0] - _e406) * _e411);
                                        let _e802 = ((_e779[0] - _e406) * _e411);
                                        let _e803 = ((_e701[0] - _e407) * _e411);
                                        let _e804 = ((_e778[0] - _e407) * _e411);
                                        let _e809 = ((_e702[1] - _e442) * _e447);
                                        let _e810 = ((_e779[1] - _e442) * _e447);
                                        let _e811 = ((_e701[1] - _e443) * _e447);
                                        let _e812 = ((_e778[1] - _e443) * _e447);
                                        let _e817 = ((_e702[2] - _e478) * _e483);
                                        let _e818 = ((_e779[2] - _e478) * _e483);
                                        let _e819 = ((_e701[2] - _e479) * _e483);
                                        let _e820 = ((_e778[2] - _e479) * _e483);
                                        let _e822 = select(_e819, _e817, (_e817 < _e819));
                                        let _e824 = select(_e820, _e818, (_e818 < _e820));
                                        let _e826 = select(_e819, _e817, (_e817 > _e819));
                                        let _e828 = select(_e820, _e818, (_e818 > _e820));
                                        let _e830 = select(_e803, _e801, (_e801 < _e803));
                                        let _e832 = select(_e804, _e802, (_e802 < _e804));
                                        let _e834 = select(_e811, _e809, (_e809 < _e811));
                                        let _e836 = select(_e812, _e810, (_e810 < _e812));
                                        let _e838 = select(_e834, _e830, (_e830 > _e834));
                                        let _e840 = select(_e836, _e832, (_e832 > _e836));
                                        let _e842 = select(_e822, _e838, (_e838 > _e822));
                                        let _e844 = select(_e824, _e840, (_e840 > _e824));
                                        let _e846 = select(_e803, _e801, (_e801 > _e803));
                                        let _e848 = select(_e804, _e802, (_e802 > _e804));
                                        let _e850 = select(_e811, _e809, (_e809 > _e811));
                                        let _e852 = select(_e812, _e810, (_e810 > _e812));
                                        let _e854 = select(_e850, _e846, (_e846 < _e850));
                                        let _e856 = select(_e852, _e848, (_e848 < _e852));
                                        let _e861 = -(_e822);
                                        let _e862 = -(_e824);
                                        let _e869 = (select(_e826, _e854, (_e854 < _e826)) + (select(_e861, _e826, (_e826 > _e861)) * 0.0000019073523f));
                                        let _e870 = (select(_e828, _e856, (_e856 < _e828)) + (select(_e862, _e828, (_e828 > _e862)) * 0.0000019073523f));
                                        let _e872 = select(_e529, _e842, (_e842 > _e529));
                                        let _e874 = select(_e529, _e844, (_e844 > _e529));
                                        let _e879 = (_e872 <= select(_e563.member_1, _e869, (_e869 < _e563.member_1)));
                                        let _e880 = (_e874 <= select(_e563.member_1, _e870, (_e870 < _e563.member_1)));
                                        let _e881 = (_e872 <= _e874);
                                        if _e879 {
                                            if _e880 {
                                                if _e881 {
                                                    phi_2874_ = _e795;
                                                } else {
                                                    phi_2874_ = _e790;
                                                }
                                                let _e883 = phi_2874_;
                                                let _e891 = (_e606 % 128u);
                                                let _e892 = (_e891 < 128u);
                                                if _e892 {
                                                } else {
                                                    phi_3344_ = true;
                                                    break;
                                                }
                                                local_6[_e891] = _e883.member_1;
                                                if _e892 {
                                                } else {
                                                    phi_3344_ = true;
                                                    break;
                                                }
                                                local_5[_e891] = _e883.member.member[0];
                                                if _e892 {
                                                } else {
                                                    phi_3344_ = true;
                                                    break;
                                                }
                                                local_4[_e891] = _e883.member.member[1];
                                                if _e892 {
                                                } else {
                                                    phi_3344_ = true;
                                                    break;
                                                }
                                                local_3[_e891] = _e883.member.member[2];
                                                if _e892 {
                                                } else {
                                                    phi_3344_ = true;
                                                    break;
                                                }
                                                local_2[_e891] = _e883.member.member_1[0];
                                                if _e892 {
                                                } else {
                                                    phi_3344_ = true;
                                                    break;
                                                }
                                                local_1[_e891] = _e883.member.member_1[1];
                                                if _e892 {
                                                } else {
                                                    phi_3344_ = true;
                                                    break;
                                                }
                                                local[_e891] = _e883.member.member_1[2];
                                                if _e892 {
                                                } else {
                                                    phi_3344_ = true;
                                                    break;
                                                }
                                                local_9[_e891] = select(_e874, _e872, (_e872 > _e874));
                                                if _e881 {
                                                    phi_2951_ = _e790;
                                                } else {
                                                    phi_2951_ = _e795;
                                                }
                                                let _e909 = phi_2951_;
                                                phi_2952_ = _e909;
                                                phi_2953_ = (_e606 + 1u);
                                            } else {
                                                phi_2952_ = type_62();
                                                phi_2953_ = u32();
                                            }
                                            let _e911 = phi_2952_;
                                            let _e913 = phi_2953_;
                                            phi_2955_ = _e911;
                                            phi_2956_ = _e913;
                                            phi_2957_ = select(true, false, _e880);
                                        } else {
                                            phi_2955_ = type_62();
                                            phi_2956_ = u32();
                                            phi_2957_ = true;
                                        }
                                        let _e916 = phi_2955_;
                                        let _e918 = phi_2956_;
                                        let _e920 = phi_2957_;
                                        if _e920 {
                                            if _e879 {
                                                phi_2964_ = _e790;
                                            } else {
                                                phi_2964_ = _e795;
                                            }
                                            let _e922 = phi_2964_;
                                            phi_2969_ = _e922;
                                            phi_2970_ = select(_e880, true, _e879);
                                        } else {
                                            phi_2969_ = _e916;
                                            phi_2970_ = _e604;
                                        }
                                        let _e925 = phi_2969_;
                                        let _e927 = phi_2970_;
                                        phi_3348_ = _e777;
                                        phi_2972_ = _e563;
                                        phi_2973_ = _e925;
                                        phi_2974_ = _e927;
                                        phi_2975_ = select(_e918, _e606, _e920);
                                    }
                                    let _e1563 = phi_3348_;
                                    let _e1565 = phi_2972_;
                                    let _e1567 = phi_2973_;
                                    let _e1569 = phi_2974_;
                                    let _e1571 = phi_2975_;
                                    phi_3347_ = _e1563;
                                    phi_2976_ = _e1565;
                                    phi_2977_ = _e1567;
                                    phi_2978_ = (_e567 - 1u);
                                    phi_2979_ = _e1569;
                                    phi_2980_ = _e1571;
                                } else {
                                    phi_3347_ = _e561;
                                    phi_2976_ = _e563;
                                    phi_2977_ = _e602;
                                    phi_2978_ = _e567;
                                    phi_2979_ = _e604;
                                    phi_2980_ = _e606;
                                }
                                let _e1573 = phi_3347_;
                                let _e1575 = phi_2976_;
                                let _e1577 = phi_2977_;
                                let _e1579 = phi_2978_;
                                let _e1581 = phi_2979_;
                                let _e1583 = phi_2980_;
                                phi_3346_ = _e1573;
                                phi_2981_ = _e1575;
                                phi_2982_ = _e1577;
                                phi_2983_ = _e1579;
                                phi_2984_ = _e1581;
                                phi_2985_ = _e1583;
                            } else {
                                phi_3346_ = _e561;
                                phi_2981_ = type_43();
                                phi_2982_ = type_62();
                                phi_2983_ = u32();
                                phi_2984_ = bool();
                                phi_2985_ = u32();
                            }
                            let _e1585 = phi_3346_;
                            let _e1587 = phi_2981_;
                            let _e1589 = phi_2982_;
                            let _e1591 = phi_2983_;
                            let _e1593 = phi_2984_;
                            let _e1595 = phi_2985_;
                            phi_3345_ = _e1585;
                            phi_896_ = _e1587;
                            phi_899_ = _e1589;
                            phi_901_ = _e1591;
                            phi_903_ = _e1593;
                            phi_905_ = _e1595;
                            phi_2986_ = _e575;
                        } else {
                            phi_3345_ = _e561;
                            phi_896_ = type_43();
                            phi_899_ = type_62();
                            phi_901_ = u32();
                            phi_903_ = bool();
                            phi_905_ = u32();
                            phi_2986_ = false;
                        }
                        let _e1597 = phi_3345_;
                        let _e1599 = phi_896_;
                        let _e1601 = phi_899_;
                        let _e1603 = phi_901_;
                        let _e1605 = phi_903_;
                        let _e1607 = phi_905_;
                        let _e1609 = phi_2986_;
                        continue;
                        continuing {
                            phi_3196_ = _e1597;
                            phi_895_ = _e1599;
                            phi_898_ = _e1601;
                            phi_900_ = _e1603;
                            phi_902_ = _e1605;
                            phi_904_ = _e1607;
                            phi_3344_ = _e1597;
                            break if !(_e1609);
                        }
                    }
                    let _e1612 = phi_3344_;
                    if _e1612 {
                        break;
                    }
                    let _e1614 = local_18;
                    if (_e1614.member.member_3 != 4294967295u) {
                        let _e1619 = (_e353 / 3i);
                        let _e1626 = bitcast<f32>((bitcast<u32>((_e1619 + 127i)) << bitcast<u32>(23i)));
                        let _e1634 = (((_e1614.member.member * _e1626) * _e1626) * bitcast<f32>((bitcast<u32>(((_e353 - (2i * _e1619)) + 127i)) << bitcast<u32>(23i))));
                        let _e1636 = select(340282350000000000000000000000000000000f, _e1634, (_e1634 < 340282350000000000000000000000000000000f));
                        phi_3038_ = type_27(select(-340282350000000000000000000000000000000f, _e1636, (_e1636 > -340282350000000000000000000000000000000f)), _e1614.member.member_1, _e1614.member.member_2, _e1614.member.member_3);
                    } else {
                        phi_3038_ = type_27(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                    }
                    let _e1643 = phi_3038_;
                    if _e230 {
                    } else {
                        break;
                    }
                    global_8.member[_e144] = _e1643;
                    if _e151 {
                    } else {
                        break;
                    }
                    let _e1647 = select(0u, 1u, (_e297 <= _e307));
                    if (_e1647 > 0u) {
                        let _e1649 = (1u < _e112);
                        if _e1649 {
                            if (0u < _e112) {
                            } else {
                                break;
                            }
                            let _e1653 = atomicAdd((&global_9.member[0u]), _e1647);
                            if ((_e1653 + _e1647) < _e1653) {
                                if _e1649 {
                                } else {
                                    break;
                                }
                                let _e1658 = atomicAdd((&global_9.member[1u]), 1u);
                            }
                        }
                    }
                    let _e1661 = select(0u, 1u, (_e1643.member_3 != 4294967295u));
                    if (_e1661 > 0u) {
                        let _e1663 = (3u < _e112);
                        if _e1663 {
                            if (2u < _e112) {
                            } else {
                                break;
                            }
                            let _e1667 = atomicAdd((&global_9.member[2u]), _e1661);
                            if ((_e1667 + _e1661) < _e1667) {
                                if _e1663 {
                                } else {
                                    break;
                                }
                                let _e1672 = atomicAdd((&global_9.member[3u]), 1u);
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
fn trace_paths_printed_f32_(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
