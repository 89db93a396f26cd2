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

struct type_31 {
    member: type_22,
    member_1: array<f32, 3>,
    member_2: u32,
}

struct type_33 {
    member: array<type_31>,
}

struct type_37 {
    member: array<f32, 3>,
    member_1: u32,
    member_2: f32,
    member_3: array<u32, 3>,
}

struct type_42 {
    member: f32,
    member_1: bool,
}

struct type_44 {
    member: array<vec4<u32>, 2>,
}

struct type_47 {
    member: array<i32>,
}

struct type_53 {
    member: array<array<u32, 7>>,
}

struct type_61 {
    member: type_30,
    member_1: u32,
}

struct type_62 {
    member: array<vec4<f32>, 3>,
    member_1: type_61,
    member_2: type_61,
}

struct type_69 {
    member: array<atomic<u32>>,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_1: type_12;
@group(0) @binding(8) 
var<storage, read_write> global_2: type_25;
@group(0) @binding(1) 
var<uniform> global_3: type_44;
@group(0) @binding(2) 
var<uniform> global_4: type_44;
@group(0) @binding(5) 
var<storage> global_5: type_4;
@group(0) @binding(6) 
var<storage> global_6: type_47;
@group(0) @binding(9) 
var<storage, read_write> global_7: type_69;
@group(0) @binding(3) 
var<storage> global_8: type_53;
@group(0) @binding(7) 
var<storage> global_9: type_33;
@group(0) @binding(4) 
var<storage> global_10: type_4;

fn function_() {
    var local: array<i32, 3>;
    var local_1: array<i32, 3>;
    var local_2: array<f32, 128>;
    var local_3: array<f32, 128>;
    var local_4: array<f32, 128>;
    var local_5: array<f32, 128>;
    var local_6: array<f32, 128>;
    var local_7: array<f32, 128>;
    var local_8: array<u32, 128>;
    var local_9: array<f32, 128>;
    var local_10: array<u32, 3>;
    var local_11: array<array<f32, 3>, 3>;
    var local_12: array<f32, 4>;
    var phi_341_: u32;
    var phi_385_: i32;
    var phi_409_: type_37;
    var phi_559_: i32;
    var phi_560_: i32;
    var phi_570_: bool;
    var phi_580_: u32;
    var phi_581_: u32;
    var phi_583_: bool;
    var phi_588_: u32;
    var phi_621_: i32;
    var phi_639_: f32;
    var phi_645_: f32;
    var phi_656_: f32;
    var phi_662_: f32;
    var phi_685_: f32;
    var phi_696_: f32;
    var phi_705_: f32;
    var phi_711_: f32;
    var phi_722_: f32;
    var phi_728_: f32;
    var phi_751_: f32;
    var phi_762_: f32;
    var phi_771_: f32;
    var phi_777_: f32;
    var phi_788_: f32;
    var phi_794_: f32;
    var phi_817_: f32;
    var phi_828_: f32;
    var phi_928_: f32;
    var phi_929_: f32;
    var phi_3940_: bool;
    var phi_1018_: type_42;
    var phi_1021_: type_61;
    var phi_1023_: u32;
    var phi_1025_: bool;
    var phi_1027_: u32;
    var phi_1038_: bool;
    var phi_1124_: type_61;
    var phi_1125_: bool;
    var phi_1126_: u32;
    var phi_2910_: u32;
    var phi_2916_: u32;
    var phi_3170_: u32;
    var phi_3171_: u32;
    var phi_3181_: u32;
    var phi_3183_: u32;
    var phi_3184_: bool;
    var phi_3204_: u32;
    var phi_3205_: u32;
    var phi_3209_: type_62;
    var phi_3553_: type_61;
    var phi_3630_: type_61;
    var phi_3631_: type_61;
    var phi_3632_: u32;
    var phi_3634_: type_61;
    var phi_3635_: u32;
    var phi_3636_: bool;
    var phi_3645_: type_61;
    var phi_3650_: type_61;
    var phi_3651_: bool;
    var phi_3937_: bool;
    var phi_1145_: type_42;
    var phi_1148_: type_8;
    var phi_1149_: type_8;
    var phi_1171_: type_8;
    var phi_1212_: u32;
    var phi_1218_: u32;
    var phi_1228_: u32;
    var phi_1244_: u32;
    var phi_1281_: u32;
    var phi_1287_: u32;
    var phi_1297_: u32;
    var phi_3922_: bool;
    var phi_1313_: type_8;
    var phi_1314_: type_8;
    var phi_1337_: type_8;
    var phi_1360_: u32;
    var phi_1375_: u32;
    var phi_1378_: type_8;
    var phi_1379_: type_8;
    var phi_1402_: type_8;
    var phi_1468_: u32;
    var phi_1448_: u32;
    var phi_1449_: u32;
    var phi_1472_: f32;
    var phi_3915_: bool;
    var phi_4001_: bool;
    var phi_4000_: bool;
    var phi_1972_: vec3<f32>;
    var phi_1973_: vec3<f32>;
    var phi_2004_: bool;
    var phi_2013_: vec3<f32>;
    var phi_2053_: type_21;
    var phi_2055_: type_21;
    var phi_2056_: bool;
    var phi_2060_: type_21;
    var phi_2061_: type_21;
    var phi_2062_: type_21;
    var phi_2063_: bool;
    var phi_2067_: type_21;
    var phi_2068_: bool;
    var phi_2072_: type_21;
    var phi_2073_: bool;
    var phi_2077_: type_21;
    var phi_2100_: u32;
    var phi_2114_: i32;
    var phi_2134_: vec3<f32>;
    var phi_2135_: vec3<f32>;
    var phi_2151_: vec3<f32>;
    var phi_2152_: vec3<f32>;
    var phi_2168_: vec3<f32>;
    var phi_2169_: vec3<f32>;
    var phi_2205_: vec3<f32>;
    var phi_2387_: f32;
    var phi_2405_: bool;
    var phi_2406_: bool;
    var phi_2411_: type_42;
    var phi_2412_: type_42;
    var phi_4003_: bool;
    var phi_1146_: type_42;
    var phi_4002_: bool;
    var local_13: type_42;
    var phi_4082_: bool;
    var phi_3653_: type_42;
    var phi_3654_: type_61;
    var phi_3655_: bool;
    var phi_3656_: u32;
    var phi_4081_: bool;
    var phi_3657_: type_42;
    var phi_3658_: type_61;
    var phi_3659_: u32;
    var phi_3660_: bool;
    var phi_3661_: u32;
    var phi_4080_: bool;
    var phi_3662_: type_42;
    var phi_3663_: type_61;
    var phi_3664_: u32;
    var phi_3665_: bool;
    var phi_3666_: u32;
    var phi_4079_: bool;
    var phi_1019_: type_42;
    var phi_1022_: type_61;
    var phi_1024_: u32;
    var phi_1026_: bool;
    var phi_1028_: u32;
    var phi_3667_: bool;
    var phi_4078_: bool;
    var local_14: type_42;
    var local_15: type_42;

    switch bitcast<i32>(0u) {
        default: {
            let _e101 = global;
            let _e103 = arrayLength((&global_8.member));
            let _e106 = arrayLength((&global_10.member));
            let _e118 = arrayLength((&global_7.member));
            let _e122 = global_4.member[0u][0u];
            let _e126 = global_4.member[0u][1u];
            let _e130 = global_4.member[0u][2u];
            let _e134 = global_4.member[0u][3u];
            let _e138 = global_4.member[1u][0u];
            let _e142 = global_4.member[1u][1u];
            let _e146 = global_4.member[1u][2u];
            let _e150 = (_e101.x + (_e101.y * 2097152u));
            let _e162 = bitcast<f32>((bitcast<u32>((bitcast<i32>(_e134) + 127i)) << bitcast<u32>(23i)));
            local_1 = array<i32, 3>(bitcast<i32>(_e122), bitcast<i32>(_e126), bitcast<i32>(_e130));
            local = array<i32, 3>(bitcast<i32>(_e138), bitcast<i32>(_e142), bitcast<i32>(_e146));
            let _e165 = (_e150 < arrayLength((&global_9.member)));
            if _e165 {
                if _e165 {
                } else {
                    break;
                }
                let _e169 = global_9.member[_e150].member_2;
                phi_341_ = _e169;
            } else {
                phi_341_ = 4294967295u;
            }
            let _e171 = phi_341_;
            let _e174 = global_1.member[0u];
            let _e178 = global_3.member[0u][0u];
            let _e182 = global_3.member[0u][1u];
            let _e186 = global_3.member[0u][2u];
            let _e190 = global_3.member[0u][3u];
            let _e194 = global_3.member[1u][0u];
            let _e198 = global_3.member[1u][1u];
            let _e202 = global_3.member[1u][2u];
            let _e206 = global_3.member[1u][3u];
            let _e207 = bitcast<f32>(_e178);
            let _e208 = bitcast<f32>(_e182);
            let _e209 = bitcast<f32>(_e186);
            let _e211 = bitcast<f32>(_e194);
            let _e212 = array<u32, 3>(_e198, _e202, _e206);
            let _e214 = bitcast<i32>(_e174);
            if (_e214 < -126i) {
                phi_385_ = -126i;
            } else {
                phi_385_ = select(_e214, 127i, (_e214 > 127i));
            }
            let _e219 = phi_385_;
            let _e224 = bitcast<f32>((bitcast<u32>((_e219 + 127i)) << bitcast<u32>(23i)));
            let _e230 = bitcast<f32>((bitcast<u32>(((_e214 - _e219) + 127i)) << bitcast<u32>(23i)));
            if (_e190 == 0u) {
                phi_409_ = type_37(array<f32, 3>(_e207, _e208, _e209), _e190, _e211, _e212);
            } else {
                phi_409_ = type_37(array<f32, 3>(((_e207 * _e224) * _e230), ((_e208 * _e224) * _e230), ((_e209 * _e224) * _e230)), _e190, ((_e211 * _e224) * _e230), _e212);
            }
            let _e243 = phi_409_;
            if _e165 {
                let _e244 = (_e150 < arrayLength((&global_2.member)));
                if _e244 {
                    if _e165 {
                    } else {
                        break;
                    }
                    let _e249 = global_9.member[_e150].member.member_1;
                    let _e254 = global_9.member[_e150].member.member_3;
                    if (_e249 <= _e254) {
                        let _e256 = (1u < _e118);
                        if _e256 {
                            if (0u < _e118) {
                            } else {
                                break;
                            }
                            let _e260 = atomicAdd((&global_7.member[0u]), 1u);
                            if ((_e260 + 1u) < _e260) {
                                if _e256 {
                                } else {
                                    break;
                                }
                                let _e265 = atomicAdd((&global_7.member[1u]), 1u);
                            }
                        }
                        if _e165 {
                        } else {
                            break;
                        }
                        let _e275 = global_9.member[_e150].member.member_2[0u];
                        let _e277 = (bitcast<u32>(_e275) & 2147483647u);
                        let _e283 = global_9.member[_e150].member.member_2[1u];
                        let _e285 = (bitcast<u32>(_e283) & 2147483647u);
                        let _e291 = global_9.member[_e150].member.member_2[2u];
                        let _e293 = (bitcast<u32>(_e291) & 2147483647u);
                        let _e299 = global_9.member[_e150].member.member[0u];
                        let _e301 = (bitcast<u32>(_e299) & 2147483647u);
                        let _e307 = global_9.member[_e150].member.member[1u];
                        let _e309 = (bitcast<u32>(_e307) & 2147483647u);
                        let _e315 = global_9.member[_e150].member.member[2u];
                        let _e317 = (bitcast<u32>(_e315) & 2147483647u);
                        let _e319 = select(_e285, _e277, (_e285 < _e277));
                        let _e321 = select(_e293, _e319, (_e293 < _e319));
                        let _e323 = select(_e301, _e321, (_e301 < _e321));
                        let _e325 = select(_e309, _e323, (_e309 < _e323));
                        let _e327 = select(_e317, _e325, (_e317 < _e325));
                        let _e329 = (bitcast<u32>(_e249) & 2147483647u);
                        let _e338 = (((select(_e329, _e327, (_e329 < _e327)) < 2139095040u) && ((bitcast<u32>(_e254) & 2147483647u) <= 2139095040u)) && (_e321 > 0u));
                        if _e338 {
                            let _e341 = (bitcast<u32>(bitcast<f32>(_e321)) & 2147483647u);
                            if (_e341 >= 8388608u) {
                                phi_559_ = (bitcast<i32>((_e341 >> bitcast<u32>(23i))) - 127i);
                            } else {
                                phi_559_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e341)), 32u, (_e341 == 0u))));
                            }
                            let _e355 = phi_559_;
                            phi_560_ = _e355;
                        } else {
                            phi_560_ = 0i;
                        }
                        let _e357 = phi_560_;
                        let _e358 = (_e277 == _e321);
                        if _e358 {
                            phi_570_ = true;
                        } else {
                            phi_570_ = (_e285 == _e321);
                        }
                        let _e361 = phi_570_;
                        let _e362 = select(1u, 0u, _e358);
                        if _e361 {
                            let _e363 = (_e362 + 1u);
                            phi_580_ = _e363;
                            phi_581_ = _e363;
                            phi_583_ = select(true, false, (_e363 == 2u));
                        } else {
                            phi_580_ = u32();
                            phi_581_ = 0u;
                            phi_583_ = true;
                        }
                        let _e367 = phi_580_;
                        let _e369 = phi_581_;
                        let _e371 = phi_583_;
                        if _e371 {
                            phi_588_ = (_e369 + 1u);
                        } else {
                            phi_588_ = 0u;
                        }
                        let _e375 = phi_588_;
                        let _e376 = select(_e367, _e369, _e371);
                        let _e377 = select(_e362, select(2u, _e362, _e361), _e371);
                        let _e378 = -(_e357);
                        if (_e378 < -126i) {
                            phi_621_ = -126i;
                        } else {
                            phi_621_ = select(_e378, 127i, (_e378 > 127i));
                        }
                        let _e383 = phi_621_;
                        let _e388 = bitcast<f32>((bitcast<u32>((_e383 + 127i)) << bitcast<u32>(23i)));
                        let _e394 = bitcast<f32>((bitcast<u32>(((_e378 - _e383) + 127i)) << bitcast<u32>(23i)));
                        let _e399 = global_9.member[_e150].member.member;
                        let _e400 = (_e376 == 0u);
                        if _e400 {
                            phi_639_ = _e399[0];
                        } else {
                            phi_639_ = _e399[1];
                        }
                        let _e404 = phi_639_;
                        let _e405 = (_e376 == 2u);
                        if _e405 {
                            phi_645_ = _e399[2];
                        } else {
                            phi_645_ = _e404;
                        }
                        let _e408 = phi_645_;
                        let _e409 = global_9.member[_e150].member.member_2;
                        if _e400 {
                            phi_656_ = _e409[0];
                        } else {
                            phi_656_ = _e409[1];
                        }
                        let _e413 = phi_656_;
                        if _e405 {
                            phi_662_ = _e409[2];
                        } else {
                            phi_662_ = _e413;
                        }
                        let _e416 = phi_662_;
                        let _e418 = ((_e416 * _e388) * _e394);
                        let _e422 = (bitcast<f32>((bitcast<u32>(_e418) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e422 {
                            let _e426 = (bitcast<f32>((bitcast<u32>(_e408) & 2147483647u)) * 0.00000011920929f);
                            phi_685_ = select(0.00000000000011368684f, _e426, (_e426 > 0.00000000000011368684f));
                        } else {
                            phi_685_ = 0f;
                        }
                        let _e430 = phi_685_;
                        let _e431 = (_e408 + _e430);
                        let _e432 = (_e408 - _e430);
                        let _e433 = select(_e418, 0f, _e422);
                        if _e422 {
                            phi_696_ = 38685626000000000000000000f;
                        } else {
                            phi_696_ = (1f / _e418);
                        }
                        let _e436 = phi_696_;
                        let _e437 = (_e375 == 0u);
                        if _e437 {
                            phi_705_ = _e399[0];
                        } else {
                            phi_705_ = _e399[1];
                        }
                        let _e441 = phi_705_;
                        let _e442 = (_e375 == 2u);
                        if _e442 {
                            phi_711_ = _e399[2];
                        } else {
                            phi_711_ = _e441;
                        }
                        let _e445 = phi_711_;
                        if _e437 {
                            phi_722_ = _e409[0];
                        } else {
                            phi_722_ = _e409[1];
                        }
                        let _e449 = phi_722_;
                        if _e442 {
                            phi_728_ = _e409[2];
                        } else {
                            phi_728_ = _e449;
                        }
                        let _e452 = phi_728_;
                        let _e454 = ((_e452 * _e388) * _e394);
                        let _e458 = (bitcast<f32>((bitcast<u32>(_e454) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e458 {
                            let _e462 = (bitcast<f32>((bitcast<u32>(_e445) & 2147483647u)) * 0.00000011920929f);
                            phi_751_ = select(0.00000000000011368684f, _e462, (_e462 > 0.00000000000011368684f));
                        } else {
                            phi_751_ = 0f;
                        }
                        let _e466 = phi_751_;
                        let _e467 = (_e445 + _e466);
                        let _e468 = (_e445 - _e466);
                        let _e469 = select(_e454, 0f, _e458);
                        if _e458 {
                            phi_762_ = 38685626000000000000000000f;
                        } else {
                            phi_762_ = (1f / _e454);
                        }
                        let _e472 = phi_762_;
                        let _e473 = (_e377 == 0u);
                        if _e473 {
                            phi_771_ = _e399[0];
                        } else {
                            phi_771_ = _e399[1];
                        }
                        let _e477 = phi_771_;
                        let _e478 = (_e377 == 2u);
                        if _e478 {
                            phi_777_ = _e399[2];
                        } else {
                            phi_777_ = _e477;
                        }
                        let _e481 = phi_777_;
                        if _e473 {
                            phi_788_ = _e409[0];
                        } else {
                            phi_788_ = _e409[1];
                        }
                        let _e485 = phi_788_;
                        if _e478 {
                            phi_794_ = _e409[2];
                        } else {
                            phi_794_ = _e485;
                        }
                        let _e488 = phi_794_;
                        let _e490 = ((_e488 * _e388) * _e394);
                        let _e494 = (bitcast<f32>((bitcast<u32>(_e490) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e494 {
                            let _e498 = (bitcast<f32>((bitcast<u32>(_e481) & 2147483647u)) * 0.00000011920929f);
                            phi_817_ = select(0.00000000000011368684f, _e498, (_e498 > 0.00000000000011368684f));
                        } else {
                            phi_817_ = 0f;
                        }
                        let _e502 = phi_817_;
                        let _e503 = (_e481 + _e502);
                        let _e504 = (_e481 - _e502);
                        let _e505 = select(_e490, 0f, _e494);
                        if _e494 {
                            phi_828_ = 38685626000000000000000000f;
                        } else {
                            phi_828_ = (1f / _e490);
                        }
                        let _e508 = phi_828_;
                        let _e511 = bitcast<f32>((bitcast<u32>(_e408) & 2147483647u));
                        let _e514 = bitcast<f32>((bitcast<u32>(_e445) & 2147483647u));
                        let _e516 = select(_e514, _e511, (_e511 > _e514));
                        let _e519 = bitcast<f32>((bitcast<u32>(_e481) & 2147483647u));
                        if (_e338 && (select(_e519, _e516, (_e516 > _e519)) <= 1099511600000f)) {
                            let _e524 = (_e357 / 3i);
                            let _e531 = bitcast<f32>((bitcast<u32>((_e524 + 127i)) << bitcast<u32>(23i)));
                            let _e538 = bitcast<f32>((bitcast<u32>(((_e357 - (2i * _e524)) + 127i)) << bitcast<u32>(23i)));
                            let _e539 = (((_e249 * _e531) * _e531) * _e538);
                            let _e541 = select(340282350000000000000000000000000000000f, _e539, (_e539 < 340282350000000000000000000000000000000f));
                            let _e546 = (((_e254 * _e531) * _e531) * _e538);
                            let _e548 = select(340282350000000000000000000000000000000f, _e546, (_e546 < 340282350000000000000000000000000000000f));
                            phi_928_ = select(-340282350000000000000000000000000000000f, _e548, (_e548 > -340282350000000000000000000000000000000f));
                            phi_929_ = select(-340282350000000000000000000000000000000f, _e541, (_e541 > -340282350000000000000000000000000000000f));
                        } else {
                            phi_928_ = 0f;
                            phi_929_ = 1f;
                        }
                        let _e552 = phi_928_;
                        let _e554 = phi_929_;
                        local_8 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                        local_7 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_6 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_5 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_4 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_3 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_9 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        let _e558 = (_e376 % 3u);
                        let _e559 = (_e558 < 3u);
                        if _e559 {
                        } else {
                            break;
                        }
                        let _e561 = local_1[_e558];
                        let _e564 = (_e375 % 3u);
                        let _e565 = (_e564 < 3u);
                        if _e565 {
                        } else {
                            break;
                        }
                        let _e567 = local_1[_e564];
                        let _e570 = (_e377 % 3u);
                        let _e571 = (_e570 < 3u);
                        if _e571 {
                        } else {
                            break;
                        }
                        let _e573 = local_1[_e570];
                        if _e559 {
                        } else {
                            break;
                        }
                        let _e578 = local[_e558];
                        if _e565 {
                        } else {
                            break;
                        }
                        let _e582 = local[_e564];
                        if _e571 {
                        } else {
                            break;
                        }
                        let _e586 = local[_e570];
                        phi_3940_ = false;
                        phi_1018_ = type_42(_e552, false);
                        phi_1021_ = type_61(type_30(vec4<f32>((f32(_e561) * _e162), (f32(_e567) * _e162), (f32(_e573) * _e162), 0f), vec4<f32>((f32(_e578) * _e162), (f32(_e582) * _e162), (f32(_e586) * _e162), 0f)), select(0u, 2147483648u, (_e103 == 0u)));
                        phi_1023_ = ((3u * _e103) + 1u);
                        phi_1025_ = (_e554 <= _e552);
                        phi_1027_ = 0u;
                        loop {
                            let _e596 = phi_3940_;
                            let _e598 = phi_1018_;
                            let _e600 = phi_1021_;
                            let _e602 = phi_1023_;
                            let _e604 = phi_1025_;
                            let _e606 = phi_1027_;
                            local_14 = _e598;
                            if _e604 {
                                phi_1038_ = true;
                            } else {
                                phi_1038_ = (_e606 > 0u);
                            }
                            let _e609 = phi_1038_;
                            if _e609 {
                                let _e610 = (_e602 > 0u);
                                if _e610 {
                                    if _e604 {
                                        phi_1124_ = _e600;
                                        phi_1125_ = _e604;
                                        phi_1126_ = _e606;
                                    } else {
                                        let _e611 = (_e606 - 1u);
                                        let _e612 = (_e611 % 128u);
                                        let _e613 = (_e612 < 128u);
                                        if _e613 {
                                        } else {
                                            phi_4078_ = true;
                                            break;
                                        }
                                        let _e615 = local_7[_e612];
                                        if _e613 {
                                        } else {
                                            phi_4078_ = true;
                                            break;
                                        }
                                        let _e617 = local_6[_e612];
                                        if _e613 {
                                        } else {
                                            phi_4078_ = true;
                                            break;
                                        }
                                        let _e619 = local_5[_e612];
                                        if _e613 {
                                        } else {
                                            phi_4078_ = true;
                                            break;
                                        }
                                        let _e621 = local_4[_e612];
                                        if _e613 {
                                        } else {
                                            phi_4078_ = true;
                                            break;
                                        }
                                        let _e623 = local_3[_e612];
                                        if _e613 {
                                        } else {
                                            phi_4078_ = true;
                                            break;
                                        }
                                        let _e625 = local_2[_e612];
                                        if _e613 {
                                        } else {
                                            phi_4078_ = true;
                                            break;
                                        }
                                        let _e630 = local_8[_e612];
                                        if _e613 {
                                        } else {
                                            phi_4078_ = true;
                                            break;
                                        }
                                        let _e633 = local_9[_e612];
                                        phi_1124_ = type_61(type_30(vec4<f32>(_e615, _e617, _e619, 0f), vec4<f32>(_e621, _e623, _e625, 0f)), _e630);
                                        phi_1125_ = (_e633 <= _e598.member);
                                        phi_1126_ = _e611;
                                    }
                                    let _e637 = phi_1124_;
                                    let _e639 = phi_1125_;
                                    let _e641 = phi_1126_;
                                    if _e639 {
                                        let _e646 = (_e637.member_1 & 268435455u);
                                        if ((_e637.member_1 & 2147483648u) != 0u) {
                                            phi_3937_ = _e596;
                                            phi_1145_ = _e598;
                                            phi_1148_ = type_8(0u, ((_e637.member_1 >> bitcast<u32>(28u)) & 7u));
                                            loop {
                                                let _e1124 = phi_3937_;
                                                let _e1126 = phi_1145_;
                                                let _e1128 = phi_1148_;
                                                local_13 = _e1126;
                                                local_15 = _e1126;
                                                if (_e1128.member < _e1128.member_1) {
                                                    phi_1149_ = type_8((_e1128.member + 1u), _e1128.member_1);
                                                    phi_1171_ = type_8(1u, _e1128.member);
                                                } else {
                                                    phi_1149_ = _e1128;
                                                    phi_1171_ = type_8(0u, type_8().member_1);
                                                }
                                                let _e1141 = phi_1149_;
                                                let _e1143 = phi_1171_;
                                                let _e1147 = (bitcast<i32>(_e1143.member) != 0i);
                                                if _e1147 {
                                                    let _e1152 = (_e637.member.member_1.x - _e637.member.member.x);
                                                    let _e1155 = (_e637.member.member_1.y - _e637.member.member.y);
                                                    let _e1158 = (_e637.member.member_1.z - _e637.member.member.z);
                                                    let _e1160 = select(_e1155, _e1152, (_e1152 > _e1155));
                                                    let _e1162 = select(_e1158, _e1160, (_e1160 > _e1158));
                                                    let _e1164 = (_e1162 < (1024f * _e162));
                                                    if _e1164 {
                                                        phi_1212_ = 0u;
                                                    } else {
                                                        phi_1212_ = select(2u, 1u, (_e1162 < (2097152f * _e162)));
                                                    }
                                                    let _e1169 = phi_1212_;
                                                    switch bitcast<i32>(_e1169) {
                                                        case 0: {
                                                            phi_1218_ = 1u;
                                                            break;
                                                        }
                                                        case 1: {
                                                            phi_1218_ = 2u;
                                                            break;
                                                        }
                                                        case 2: {
                                                            phi_1218_ = 3u;
                                                            break;
                                                        }
                                                        default: {
                                                            phi_1218_ = u32();
                                                            break;
                                                        }
                                                    }
                                                    let _e1172 = phi_1218_;
                                                    switch bitcast<i32>(_e1169) {
                                                        case 0: {
                                                            phi_1228_ = 1u;
                                                            break;
                                                        }
                                                        case 1: {
                                                            phi_1228_ = 2u;
                                                            break;
                                                        }
                                                        case 2: {
                                                            phi_1228_ = 3u;
                                                            break;
                                                        }
                                                        default: {
                                                            phi_1228_ = u32();
                                                            break;
                                                        }
                                                    }
                                                    let _e1179 = phi_1228_;
                                                    let _e1181 = ((_e646 + (_e1143.member_1 * ((3u * _e1172) + 1u))) + (3u * _e1179));
                                                    let _e1182 = (_e1181 < _e106);
                                                    if _e1182 {
                                                        if _e1182 {
                                                        } else {
                                                            phi_4002_ = true;
                                                            break;
                                                        }
                                                        let _e1184 = global_10.member[_e1181];
                                                        phi_1244_ = _e1184;
                                                    } else {
                                                        phi_1244_ = 4294967295u;
                                                    }
                                                    let _e1186 = phi_1244_;
                                                    local_10 = array<u32, 3>(_e376, _e375, _e377);
                                                    if _e1164 {
                                                        phi_1281_ = 0u;
                                                    } else {
                                                        phi_1281_ = select(2u, 1u, (_e1162 < (2097152f * _e162)));
                                                    }
                                                    let _e1192 = phi_1281_;
                                                    switch bitcast<i32>(_e1192) {
                                                        case 0: {
                                                            phi_1287_ = 1u;
                                                            break;
                                                        }
                                                        case 1: {
                                                            phi_1287_ = 2u;
                                                            break;
                                                        }
                                                        case 2: {
                                                            phi_1287_ = 3u;
                                                            break;
                                                        }
                                                        default: {
                                                            phi_1287_ = u32();
                                                            break;
                                                        }
                                                    }
                                                    let _e1195 = phi_1287_;
                                                    switch bitcast<i32>(_e1192) {
                                                        case 0: {
                                                            phi_1297_ = 1u;
                                                            break;
                                                        }
                                                        case 1: {
                                                            phi_1297_ = 2u;
                                                            break;
                                                        }
                                                        case 2: {
                                                            phi_1297_ = 3u;
                                                            break;
                                                        }
                                                        default: {
                                                            phi_1297_ = u32();
                                                            break;
                                                        }
                                                    }
                                                    let _e1202 = phi_1297_;
                                                    local_12 = array<f32, 4>(_e637.member.member.x, _e637.member.member.y, _e637.member.member.z, _e637.member.member.w);
                                                    local_11[0u] = array<f32, 3>(0f, 0f, 0f);
                                                    local_11[1u] = array<f32, 3>(0f, 0f, 0f);
                                                    local_11[2u] = array<f32, 3>(0f, 0f, 0f);
                                                    phi_3922_ = _e1124;
                                                    phi_1313_ = type_8(0u, 3u);
                                                    loop {
                                                        let _e1216 = phi_3922_;
                                                        let _e1218 = phi_1313_;
                                                        if (_e1218.member < _e1218.member_1) {
                                                            phi_1314_ = type_8((_e1218.member + 1u), _e1218.member_1);
                                                            phi_1337_ = type_8(1u, _e1218.member);
                                                        } else {
                                                            phi_1314_ = _e1218;
                                                            phi_1337_ = type_8(0u, type_8().member_1);
                                                        }
                                                        let _e1231 = phi_1314_;
                                                        let _e1233 = phi_1337_;
                                                        let _e1237 = (bitcast<i32>(_e1233.member) != 0i);
                                                        if _e1237 {
                                                            let _e1239 = ((_e646 + (_e1143.member_1 * ((3u * _e1195) + 1u))) + (_e1233.member_1 * _e1202));
                                                            let _e1240 = (_e1239 < _e106);
                                                            if _e1240 {
                                                                if _e1240 {
                                                                } else {
                                                                    phi_4000_ = true;
                                                                    break;
                                                                }
                                                                let _e1242 = global_10.member[_e1239];
                                                                phi_1360_ = _e1242;
                                                            } else {
                                                                phi_1360_ = 0u;
                                                            }
                                                            let _e1244 = phi_1360_;
                                                            let _e1245 = (_e1239 + 1u);
                                                            let _e1246 = (_e1245 < _e106);
                                                            if _e1246 {
                                                                if _e1246 {
                                                                } else {
                                                                    phi_4000_ = true;
                                                                    break;
                                                                }
                                                                let _e1248 = global_10.member[_e1245];
                                                                phi_1375_ = _e1248;
                                                            } else {
                                                                phi_1375_ = 0u;
                                                            }
                                                            let _e1250 = phi_1375_;
                                                            phi_1378_ = type_8(0u, 3u);
                                                            loop {
                                                                let _e1252 = phi_1378_;
                                                                if (_e1252.member < _e1252.member_1) {
                                                                    phi_1379_ = type_8((_e1252.member + 1u), _e1252.member_1);
                                                                    phi_1402_ = type_8(1u, _e1252.member);
                                                                } else {
                                                                    phi_1379_ = _e1252;
                                                                    phi_1402_ = type_8(0u, type_8().member_1);
                                                                }
                                                                let _e1265 = phi_1379_;
                                                                let _e1267 = phi_1402_;
                                                                let _e1271 = (bitcast<i32>(_e1267.member) != 0i);
                                                                if _e1271 {
                                                                    let _e1272 = (_e1267.member_1 < 3u);
                                                                    if _e1272 {
                                                                    } else {
                                                                        phi_3915_ = true;
                                                                        break;
                                                                    }
                                                                    let _e1274 = local_10[_e1267.member_1];
                                                                    if (_e1267.member_1 < 4u) {
                                                                    } else {
                                                                        phi_3915_ = true;
                                                                        break;
                                                                    }
                                                                    let _e1277 = local_12[_e1267.member_1];
                                                                    switch bitcast<i32>(_e1192) {
                                                                        case 0: {
                                                                            phi_1472_ = (_e1277 + (f32(((_e1244 >> bitcast<u32>(((10u * _e1274) & 31u))) & 1023u)) * _e162));
                                                                            break;
                                                                        }
                                                                        case 1: {
                                                                            if (_e1274 == 0u) {
                                                                                phi_1449_ = _e1244;
                                                                            } else {
                                                                                if (_e1274 == 1u) {
                                                                                    phi_1448_ = ((_e1244 >> bitcast<u32>(21i)) | (_e1250 << bitcast<u32>(11i)));
                                                                                } else {
                                                                                    phi_1448_ = (_e1250 >> bitcast<u32>(10i));
                                                                                }
                                                                                let _e1298 = phi_1448_;
                                                                                phi_1449_ = _e1298;
                                                                            }
                                                                            let _e1300 = phi_1449_;
                                                                            phi_1472_ = (_e1277 + (f32((_e1300 & 2097151u)) * _e162));
                                                                            break;
                                                                        }
                                                                        case 2: {
                                                                            let _e1279 = (_e1239 + _e1274);
                                                                            let _e1280 = (_e1279 < _e106);
                                                                            if _e1280 {
                                                                                if _e1280 {
                                                                                } else {
                                                                                    phi_3915_ = true;
                                                                                    break;
                                                                                }
                                                                                let _e1282 = global_10.member[_e1279];
                                                                                phi_1468_ = _e1282;
                                                                            } else {
                                                                                phi_1468_ = 0u;
                                                                            }
                                                                            let _e1284 = phi_1468_;
                                                                            phi_1472_ = (f32(bitcast<i32>(_e1284)) * _e162);
                                                                            break;
                                                                        }
                                                                        default: {
                                                                            phi_1472_ = f32();
                                                                            break;
                                                                        }
                                                                    }
                                                                    let _e1314 = phi_1472_;
                                                                    if (_e1233.member_1 < 3u) {
                                                                    } else {
                                                                        phi_3915_ = true;
                                                                        break;
                                                                    }
                                                                    if _e1272 {
                                                                    } else {
                                                                        phi_3915_ = true;
                                                                        break;
                                                                    }
                                                                    local_11[_e1233.member_1][_e1267.member_1] = _e1314;
                                                                }
                                                                continue;
                                                                continuing {
                                                                    phi_1378_ = _e1265;
                                                                    phi_3915_ = _e1216;
                                                                    break if !(_e1271);
                                                                }
                                                            }
                                                            let _e1320 = phi_3915_;
                                                            phi_4000_ = _e1320;
                                                            if _e1320 {
                                                                break;
                                                            }
                                                            phi_4001_ = _e1320;
                                                        } else {
                                                            phi_4001_ = _e1216;
                                                        }
                                                        let _e1322 = phi_4001_;
                                                        continue;
                                                        continuing {
                                                            phi_3922_ = _e1322;
                                                            phi_1313_ = _e1231;
                                                            phi_4000_ = _e1322;
                                                            break if !(_e1237);
                                                        }
                                                    }
                                                    let _e1325 = phi_4000_;
                                                    phi_4002_ = _e1325;
                                                    if _e1325 {
                                                        break;
                                                    }
                                                    let _e1326 = local_11;
                                                    let _e1342 = (_e1326[0][2] - _e481);
                                                    let _e1345 = (((_e1326[0][0] - _e408) * _e505) - (_e1342 * _e433));
                                                    let _e1348 = (((_e1326[0][1] - _e445) * _e505) - (_e1342 * _e469));
                                                    let _e1351 = (_e1326[1][2] - _e481);
                                                    let _e1354 = (((_e1326[1][0] - _e408) * _e505) - (_e1351 * _e433));
                                                    let _e1357 = (((_e1326[1][1] - _e445) * _e505) - (_e1351 * _e469));
                                                    let _e1360 = (_e1326[2][2] - _e481);
                                                    let _e1363 = (((_e1326[2][0] - _e408) * _e505) - (_e1360 * _e433));
                                                    let _e1366 = (((_e1326[2][1] - _e445) * _e505) - (_e1360 * _e469));
                                                    let _e1367 = (_e1363 * _e1357);
                                                    let _e1368 = (_e1366 * _e1354);
                                                    let _e1369 = (_e1345 * _e1366);
                                                    let _e1370 = (_e1348 * _e1363);
                                                    let _e1371 = (_e1354 * _e1348);
                                                    let _e1372 = (_e1357 * _e1345);
                                                    let _e1377 = (((_e1367 >= _e1368) && (_e1369 >= _e1370)) && (_e1371 >= _e1372));
                                                    if (_e1377 || (((_e1367 <= _e1368) && (_e1369 <= _e1370)) && (_e1371 <= _e1372))) {
                                                        let _e1384 = select(-1f, 1f, _e1377);
                                                        let _e1386 = ((_e1367 - _e1368) * _e1384);
                                                        let _e1388 = select(0f, _e1386, (_e1386 > 0f));
                                                        let _e1390 = ((_e1369 - _e1370) * _e1384);
                                                        let _e1392 = select(0f, _e1390, (_e1390 > 0f));
                                                        let _e1394 = ((_e1371 - _e1372) * _e1384);
                                                        let _e1396 = select(0f, _e1394, (_e1394 > 0f));
                                                        let _e1398 = ((_e1388 + _e1392) + _e1396);
                                                        if (_e1398 < 0.000000000000000000000000000000000000011754944f) {
                                                            phi_2067_ = type_21();
                                                            phi_2068_ = true;
                                                        } else {
                                                            let _e1401 = select(_e1326[1][0], _e1326[0][0], (_e1326[0][0] < _e1326[1][0]));
                                                            let _e1405 = select(_e1326[1][0], _e1326[0][0], (_e1326[0][0] > _e1326[1][0]));
                                                            let _e1409 = select(_e1326[1][1], _e1326[0][1], (_e1326[0][1] < _e1326[1][1]));
                                                            let _e1413 = select(_e1326[1][1], _e1326[0][1], (_e1326[0][1] > _e1326[1][1]));
                                                            let _e1417 = select(_e1326[1][2], _e1326[0][2], (_e1326[0][2] < _e1326[1][2]));
                                                            let _e1421 = select(_e1326[1][2], _e1326[0][2], (_e1326[0][2] > _e1326[1][2]));
                                                            let _e1426 = ((select(_e1326[2][0], _e1401, (_e1401 < _e1326[2][0])) - _e431) * _e436);
                                                            let _e1427 = ((select(_e1326[2][0], _e1405, (_e1405 > _e1326[2][0])) - _e432) * _e436);
                                                            let _e1430 = ((select(_e1326[2][1], _e1409, (_e1409 < _e1326[2][1])) - _e467) * _e472);
                                                            let _e1431 = ((select(_e1326[2][1], _e1413, (_e1413 > _e1326[2][1])) - _e468) * _e472);
                                                            let _e1434 = ((select(_e1326[2][2], _e1417, (_e1417 < _e1326[2][2])) - _e503) * _e508);
                                                            let _e1435 = ((select(_e1326[2][2], _e1421, (_e1421 > _e1326[2][2])) - _e504) * _e508);
                                                            let _e1437 = select(_e1435, _e1434, (_e1434 < _e1435));
                                                            let _e1439 = select(_e1435, _e1434, (_e1434 > _e1435));
                                                            let _e1441 = select(_e1427, _e1426, (_e1426 < _e1427));
                                                            let _e1443 = select(_e1431, _e1430, (_e1430 < _e1431));
                                                            let _e1445 = select(_e1443, _e1441, (_e1441 > _e1443));
                                                            let _e1447 = select(_e1437, _e1445, (_e1445 > _e1437));
                                                            let _e1449 = select(_e1427, _e1426, (_e1426 > _e1427));
                                                            let _e1451 = select(_e1431, _e1430, (_e1430 > _e1431));
                                                            let _e1453 = select(_e1451, _e1449, (_e1449 < _e1451));
                                                            let _e1455 = select(_e1439, _e1453, (_e1453 < _e1439));
                                                            let _e1456 = -(_e1437);
                                                            let _e1462 = select(_e554, _e1447, (_e1447 > _e554));
                                                            if (_e1462 > (_e1455 + (select(_e1456, _e1439, (_e1439 > _e1456)) * 0.0000019073523f))) {
                                                                phi_2062_ = type_21();
                                                                phi_2063_ = true;
                                                            } else {
                                                                let _e1464 = (_e1462 > _e1126.member);
                                                                if _e1464 {
                                                                    phi_2061_ = type_21();
                                                                } else {
                                                                    let _e1468 = (_e1326[1][0] - _e1326[0][0]);
                                                                    let _e1469 = (_e1326[1][1] - _e1326[0][1]);
                                                                    let _e1470 = (_e1326[1][2] - _e1326[0][2]);
                                                                    let _e1471 = vec3<f32>(_e1468, _e1469, _e1470);
                                                                    let _e1472 = (_e1326[2][0] - _e1326[1][0]);
                                                                    let _e1473 = (_e1326[2][1] - _e1326[1][1]);
                                                                    let _e1474 = (_e1326[2][2] - _e1326[1][2]);
                                                                    let _e1475 = vec3<f32>(_e1472, _e1473, _e1474);
                                                                    let _e1476 = (_e1326[0][0] - _e1326[2][0]);
                                                                    let _e1477 = (_e1326[0][1] - _e1326[2][1]);
                                                                    let _e1478 = (_e1326[0][2] - _e1326[2][2]);
                                                                    let _e1479 = vec3<f32>(_e1476, _e1477, _e1478);
                                                                    let _e1482 = bitcast<f32>((bitcast<u32>(_e1468) & 2147483647u));
                                                                    let _e1485 = bitcast<f32>((bitcast<u32>(_e1469) & 2147483647u));
                                                                    let _e1487 = select(_e1485, _e1482, (_e1482 > _e1485));
                                                                    let _e1490 = bitcast<f32>((bitcast<u32>(_e1470) & 2147483647u));
                                                                    let _e1492 = select(_e1490, _e1487, (_e1487 > _e1490));
                                                                    let _e1495 = bitcast<f32>((bitcast<u32>(_e1472) & 2147483647u));
                                                                    let _e1498 = bitcast<f32>((bitcast<u32>(_e1473) & 2147483647u));
                                                                    let _e1500 = select(_e1498, _e1495, (_e1495 > _e1498));
                                                                    let _e1503 = bitcast<f32>((bitcast<u32>(_e1474) & 2147483647u));
                                                                    let _e1505 = select(_e1503, _e1500, (_e1500 > _e1503));
                                                                    let _e1508 = bitcast<f32>((bitcast<u32>(_e1476) & 2147483647u));
                                                                    let _e1511 = bitcast<f32>((bitcast<u32>(_e1477) & 2147483647u));
                                                                    let _e1513 = select(_e1511, _e1508, (_e1508 > _e1511));
                                                                    let _e1516 = bitcast<f32>((bitcast<u32>(_e1478) & 2147483647u));
                                                                    let _e1518 = select(_e1516, _e1513, (_e1513 > _e1516));
                                                                    let _e1520 = select(_e1505, _e1492, (_e1492 > _e1505));
                                                                    let _e1522 = select(_e1518, _e1520, (_e1520 > _e1518));
                                                                    if (_e1492 == _e1522) {
                                                                        phi_1972_ = _e1475;
                                                                        phi_1973_ = _e1479;
                                                                    } else {
                                                                        let _e1525 = vec3((_e1505 == _e1522));
                                                                        phi_1972_ = select(_e1471, _e1479, _e1525);
                                                                        phi_1973_ = select(_e1475, _e1471, _e1525);
                                                                    }
                                                                    let _e1529 = phi_1972_;
                                                                    let _e1531 = phi_1973_;
                                                                    let _e1538 = ((_e1529.y * _e1531.z) - (_e1531.y * _e1529.z));
                                                                    let _e1543 = ((_e1529.z * _e1531.x) - (_e1531.z * _e1529.x));
                                                                    let _e1546 = ((_e1529.x * _e1531.y) - (_e1531.x * _e1529.y));
                                                                    if (_e1388 >= _e1392) {
                                                                        phi_2004_ = select(true, false, (_e1388 >= _e1396));
                                                                    } else {
                                                                        phi_2004_ = true;
                                                                    }
                                                                    let _e1551 = phi_2004_;
                                                                    if _e1551 {
                                                                        phi_2013_ = select(vec3<f32>(_e1326[2][0], _e1326[2][1], _e1326[2][2]), vec3<f32>(_e1326[1][0], _e1326[1][1], _e1326[1][2]), vec3((_e1392 >= _e1396)));
                                                                    } else {
                                                                        phi_2013_ = vec3<f32>(_e1326[0][0], _e1326[0][1], _e1326[0][2]);
                                                                    }
                                                                    let _e1556 = phi_2013_;
                                                                    let _e1573 = ((((_e1538 * (_e1556.x - _e408)) + (_e1543 * (_e1556.y - _e445))) + (_e1546 * (_e1556.z - _e481))) / (((_e1538 * _e433) + (_e1543 * _e469)) + (_e1546 * _e505)));
                                                                    let _e1575 = select(_e1455, _e1573, (_e1573 < _e1455));
                                                                    let _e1577 = select(_e1447, _e1575, (_e1575 > _e1447));
                                                                    if (_e1577 >= _e554) {
                                                                        let _e1579 = (_e1577 <= _e1126.member);
                                                                        if _e1579 {
                                                                            let _e1580 = (1f / _e1398);
                                                                            phi_2053_ = type_21(_e1577, (_e1392 * _e1580), (_e1396 * _e1580), _e1186);
                                                                        } else {
                                                                            phi_2053_ = type_21();
                                                                        }
                                                                        let _e1585 = phi_2053_;
                                                                        phi_2055_ = _e1585;
                                                                        phi_2056_ = select(true, false, _e1579);
                                                                    } else {
                                                                        phi_2055_ = type_21();
                                                                        phi_2056_ = true;
                                                                    }
                                                                    let _e1588 = phi_2055_;
                                                                    let _e1590 = phi_2056_;
                                                                    if _e1590 {
                                                                        phi_2060_ = type_21(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                    } else {
                                                                        phi_2060_ = _e1588;
                                                                    }
                                                                    let _e1592 = phi_2060_;
                                                                    phi_2061_ = _e1592;
                                                                }
                                                                let _e1594 = phi_2061_;
                                                                phi_2062_ = _e1594;
                                                                phi_2063_ = _e1464;
                                                            }
                                                            let _e1596 = phi_2062_;
                                                            let _e1598 = phi_2063_;
                                                            phi_2067_ = _e1596;
                                                            phi_2068_ = _e1598;
                                                        }
                                                        let _e1600 = phi_2067_;
                                                        let _e1602 = phi_2068_;
                                                        phi_2072_ = _e1600;
                                                        phi_2073_ = _e1602;
                                                    } else {
                                                        phi_2072_ = type_21();
                                                        phi_2073_ = true;
                                                    }
                                                    let _e1604 = phi_2072_;
                                                    let _e1606 = phi_2073_;
                                                    if _e1606 {
                                                        phi_2077_ = type_21(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                    } else {
                                                        phi_2077_ = _e1604;
                                                    }
                                                    let _e1608 = phi_2077_;
                                                    if (_e1608.member_3 != 4294967295u) {
                                                        if (_e1186 == _e171) {
                                                            phi_2406_ = false;
                                                        } else {
                                                            let _e1612 = (_e1186 < arrayLength((&global_5.member)));
                                                            if _e1612 {
                                                                if _e1612 {
                                                                } else {
                                                                    phi_4002_ = true;
                                                                    break;
                                                                }
                                                                let _e1614 = global_5.member[_e1186];
                                                                phi_2100_ = _e1614;
                                                            } else {
                                                                phi_2100_ = 4294967295u;
                                                            }
                                                            let _e1616 = phi_2100_;
                                                            let _e1617 = (_e1616 < arrayLength((&global_6.member)));
                                                            if _e1617 {
                                                                if _e1617 {
                                                                } else {
                                                                    phi_4002_ = true;
                                                                    break;
                                                                }
                                                                let _e1619 = global_6.member[_e1616];
                                                                phi_2114_ = _e1619;
                                                            } else {
                                                                phi_2114_ = 0i;
                                                            }
                                                            let _e1621 = phi_2114_;
                                                            let _e1622 = (_e1621 == 0i);
                                                            if _e1622 {
                                                                phi_2405_ = true;
                                                            } else {
                                                                if _e400 {
                                                                    phi_2135_ = vec3<f32>(_e1326[0][0], _e1326[0][1], _e1326[0][2]);
                                                                } else {
                                                                    if (_e376 == 1u) {
                                                                        phi_2134_ = vec3<f32>(_e1326[0][2], _e1326[0][0], _e1326[0][1]);
                                                                    } else {
                                                                        phi_2134_ = vec3<f32>(_e1326[0][1], _e1326[0][2], _e1326[0][0]);
                                                                    }
                                                                    let _e1627 = phi_2134_;
                                                                    phi_2135_ = _e1627;
                                                                }
                                                                let _e1630 = phi_2135_;
                                                                if _e400 {
                                                                    phi_2152_ = vec3<f32>(_e1326[1][0], _e1326[1][1], _e1326[1][2]);
                                                                } else {
                                                                    if (_e376 == 1u) {
                                                                        phi_2151_ = vec3<f32>(_e1326[1][2], _e1326[1][0], _e1326[1][1]);
                                                                    } else {
                                                                        phi_2151_ = vec3<f32>(_e1326[1][1], _e1326[1][2], _e1326[1][0]);
                                                                    }
                                                                    let _e1635 = phi_2151_;
                                                                    phi_2152_ = _e1635;
                                                                }
                                                                let _e1638 = phi_2152_;
                                                                if _e400 {
                                                                    phi_2169_ = vec3<f32>(_e1326[2][0], _e1326[2][1], _e1326[2][2]);
                                                                } else {
                                                                    if (_e376 == 1u) {
                                                                        phi_2168_ = vec3<f32>(_e1326[2][2], _e1326[2][0], _e1326[2][1]);
                                                                    } else {
                                                                        phi_2168_ = vec3<f32>(_e1326[2][1], _e1326[2][2], _e1326[2][0]);
                                                                    }
                                                                    let _e1643 = phi_2168_;
                                                                    phi_2169_ = _e1643;
                                                                }
                                                                let _e1646 = phi_2169_;
                                                                let _e1649 = (_e1638.x - _e1630.x);
                                                                let _e1652 = (_e1638.y - _e1630.y);
                                                                let _e1655 = (_e1638.z - _e1630.z);
                                                                let _e1657 = (_e1646.x - _e1630.x);
                                                                let _e1659 = (_e1646.y - _e1630.y);
                                                                let _e1661 = (_e1646.z - _e1630.z);
                                                                if (_e243.member_1 == 1u) {
                                                                    phi_2205_ = (vec3<f32>(_e243.member[0], _e243.member[1], _e243.member[2]) - _e1630);
                                                                } else {
                                                                    phi_2205_ = vec3<f32>(_e243.member[0], _e243.member[1], _e243.member[2]);
                                                                }
                                                                let _e1676 = phi_2205_;
                                                                let _e1682 = bitcast<f32>((bitcast<u32>((_e1649 * _e1659)) ^ _e243.member_3[0]));
                                                                let _e1686 = bitcast<f32>((bitcast<u32>((_e1652 * _e1657)) ^ _e243.member_3[0]));
                                                                let _e1690 = bitcast<f32>((bitcast<u32>((_e1652 * _e1661)) ^ _e243.member_3[0]));
                                                                let _e1694 = bitcast<f32>((bitcast<u32>((_e1655 * _e1659)) ^ _e243.member_3[0]));
                                                                let _e1698 = bitcast<f32>((bitcast<u32>((_e1655 * _e1657)) ^ _e243.member_3[0]));
                                                                let _e1702 = bitcast<f32>((bitcast<u32>((_e1649 * _e1661)) ^ _e243.member_3[0]));
                                                                let _e1703 = (_e1690 - _e1694);
                                                                let _e1704 = (_e1698 - _e1702);
                                                                let _e1705 = (_e1682 - _e1686);
                                                                let _e1729 = (bitcast<f32>((bitcast<u32>(_e1690) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1694) & 2147483647u)));
                                                                let _e1736 = (bitcast<f32>((bitcast<u32>(_e1698) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1702) & 2147483647u)));
                                                                let _e1743 = (bitcast<f32>((bitcast<u32>(_e1682) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1686) & 2147483647u)));
                                                                if (_e243.member_2 == 0f) {
                                                                    phi_2387_ = 0f;
                                                                } else {
                                                                    let _e1773 = bitcast<f32>((bitcast<u32>(_e1703) & 2147483647u));
                                                                    let _e1776 = bitcast<f32>((bitcast<u32>(_e1704) & 2147483647u));
                                                                    let _e1779 = bitcast<f32>((bitcast<u32>(_e1705) & 2147483647u));
                                                                    let _e1781 = select(_e1779, _e1776, (_e1776 > _e1779));
                                                                    let _e1785 = select(_e1779, _e1776, (_e1776 < _e1779));
                                                                    let _e1789 = select(_e1776, _e1773, (_e1773 < _e1776));
                                                                    let _e1791 = select(_e1776, _e1773, (_e1773 > _e1776));
                                                                    let _e1793 = select(_e1779, _e1791, (_e1791 < _e1779));
                                                                    phi_2387_ = bitcast<f32>((bitcast<u32>((_e243.member_2 * bitcast<f32>((bitcast<u32>(((((select(_e1781, _e1773, (_e1773 > _e1781)) + bitcast<f32>((bitcast<u32>((0.414214f * select(_e1793, _e1789, (_e1789 > _e1793)))) ^ _e243.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.317838f * select(_e1785, _e1773, (_e1773 < _e1785)))) ^ _e243.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.0000004768374f * ((_e1729 + _e1736) + _e1743))) ^ _e243.member_3[0]))) * 1.0000005f)) ^ _e243.member_3[0])))) ^ _e243.member_3[0]));
                                                                }
                                                                let _e1820 = phi_2387_;
                                                                phi_2405_ = (_e1622 || !(((((bitcast<f32>((bitcast<u32>((_e1676.x * _e1703)) ^ _e243.member_3[0])) + bitcast<f32>((bitcast<u32>((_e1676.y * _e1704)) ^ _e243.member_3[0]))) + bitcast<f32>((bitcast<u32>((_e1676.z * _e1705)) ^ _e243.member_3[0]))) * f32(-(_e1621))) > ((bitcast<f32>((bitcast<u32>((0.0000009536752f * ((bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1676.x) & 2147483647u)) * _e1729)) ^ _e243.member_3[0])) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1676.y) & 2147483647u)) * _e1736)) ^ _e243.member_3[0]))) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1676.z) & 2147483647u)) * _e1743)) ^ _e243.member_3[0]))))) ^ _e243.member_3[0])) + _e1820) + 0.0000000000000000000000000000000000001880791f))));
                                                            }
                                                            let _e1834 = phi_2405_;
                                                            phi_2406_ = _e1834;
                                                        }
                                                        let _e1836 = phi_2406_;
                                                        if _e1836 {
                                                            phi_2411_ = type_42(_e1126.member, true);
                                                        } else {
                                                            phi_2411_ = _e1126;
                                                        }
                                                        let _e1841 = phi_2411_;
                                                        phi_2412_ = _e1841;
                                                    } else {
                                                        phi_2412_ = _e1126;
                                                    }
                                                    let _e1843 = phi_2412_;
                                                    phi_4003_ = _e1325;
                                                    phi_1146_ = _e1843;
                                                } else {
                                                    phi_4003_ = _e1124;
                                                    phi_1146_ = type_42();
                                                }
                                                let _e1845 = phi_4003_;
                                                let _e1847 = phi_1146_;
                                                continue;
                                                continuing {
                                                    phi_3937_ = _e1845;
                                                    phi_1145_ = _e1847;
                                                    phi_1148_ = _e1141;
                                                    phi_4002_ = _e1845;
                                                    break if !(_e1147);
                                                }
                                            }
                                            let _e1850 = phi_4002_;
                                            phi_4078_ = _e1850;
                                            if _e1850 {
                                                break;
                                            }
                                            let _e1852 = local_13;
                                            phi_4082_ = _e1850;
                                            let _e2064 = local_15;
                                            phi_3653_ = _e2064;
                                            phi_3654_ = _e637;
                                            phi_3655_ = false;
                                            phi_3656_ = select(_e641, 0u, _e1852.member_1);
                                        } else {
                                            if (_e637.member_1 >= _e103) {
                                                phi_3209_ = type_62(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), type_61(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u), type_61(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u));
                                            } else {
                                                if (_e637.member_1 < _e103) {
                                                } else {
                                                    phi_4078_ = true;
                                                    break;
                                                }
                                                let _e653 = (_e376 * 2u);
                                                let _e655 = ((1u + _e653) % 7u);
                                                if (_e655 < 7u) {
                                                } else {
                                                    phi_4078_ = true;
                                                    break;
                                                }
                                                let _e660 = global_8.member[_e637.member_1][_e655];
                                                let _e662 = ((_e653 + 2u) % 7u);
                                                if (_e662 < 7u) {
                                                } else {
                                                    phi_4078_ = true;
                                                    break;
                                                }
                                                let _e667 = global_8.member[_e637.member_1][_e662];
                                                let _e668 = (_e375 * 2u);
                                                let _e670 = ((1u + _e668) % 7u);
                                                if (_e670 < 7u) {
                                                } else {
                                                    phi_4078_ = true;
                                                    break;
                                                }
                                                let _e675 = global_8.member[_e637.member_1][_e670];
                                                let _e677 = ((_e668 + 2u) % 7u);
                                                if (_e677 < 7u) {
                                                } else {
                                                    phi_4078_ = true;
                                                    break;
                                                }
                                                let _e682 = global_8.member[_e637.member_1][_e677];
                                                let _e683 = (_e377 * 2u);
                                                let _e685 = ((1u + _e683) % 7u);
                                                if (_e685 < 7u) {
                                                } else {
                                                    phi_4078_ = true;
                                                    break;
                                                }
                                                let _e690 = global_8.member[_e637.member_1][_e685];
                                                let _e692 = ((_e683 + 2u) % 7u);
                                                if (_e692 < 7u) {
                                                } else {
                                                    phi_4078_ = true;
                                                    break;
                                                }
                                                let _e697 = global_8.member[_e637.member_1][_e692];
                                                let _e720 = (bitcast<f32>((bitcast<u32>((_e637.member.member_1.x - _e637.member.member.x)) & 2139095040u)) * 0.0000009536743f);
                                                let _e721 = (bitcast<f32>((bitcast<u32>((_e637.member.member_1.y - _e637.member.member.y)) & 2139095040u)) * 0.0000009536743f);
                                                let _e722 = (bitcast<f32>((bitcast<u32>((_e637.member.member_1.z - _e637.member.member.z)) & 2139095040u)) * 0.0000009536743f);
                                                let _e724 = select(_e162, _e720, (_e720 > _e162));
                                                let _e726 = select(_e162, _e721, (_e721 > _e162));
                                                let _e728 = select(_e162, _e722, (_e722 > _e162));
                                                let _e753 = bitcast<u32>((f32(bitcast<i32>((_e660 & 2097151u))) * _e724));
                                                let _e758 = (bitcast<i32>((_e660 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                                let _e761 = bitcast<f32>((_e753 & bitcast<u32>(_e758)));
                                                let _e762 = bitcast<u32>((f32(bitcast<i32>((_e675 & 2097151u))) * _e726));
                                                let _e767 = (bitcast<i32>((_e675 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                                let _e770 = bitcast<f32>((_e762 & bitcast<u32>(_e767)));
                                                let _e771 = bitcast<u32>((f32(bitcast<i32>((_e690 & 2097151u))) * _e728));
                                                let _e776 = (bitcast<i32>((_e690 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                                let _e779 = bitcast<f32>((_e771 & bitcast<u32>(_e776)));
                                                let _e783 = bitcast<f32>((_e753 & bitcast<u32>(~(_e758))));
                                                let _e787 = bitcast<f32>((_e762 & bitcast<u32>(~(_e767))));
                                                let _e791 = bitcast<f32>((_e771 & bitcast<u32>(~(_e776))));
                                                let _e792 = bitcast<u32>((f32(bitcast<i32>((_e667 & 2097151u))) * _e724));
                                                let _e797 = (bitcast<i32>((_e667 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                                let _e800 = bitcast<f32>((_e792 & bitcast<u32>(_e797)));
                                                let _e801 = bitcast<u32>((f32(bitcast<i32>((_e682 & 2097151u))) * _e726));
                                                let _e806 = (bitcast<i32>((_e682 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                                let _e809 = bitcast<f32>((_e801 & bitcast<u32>(_e806)));
                                                let _e810 = bitcast<u32>((f32(bitcast<i32>((_e697 & 2097151u))) * _e728));
                                                let _e815 = (bitcast<i32>((_e697 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                                let _e818 = bitcast<f32>((_e810 & bitcast<u32>(_e815)));
                                                let _e822 = bitcast<f32>((_e792 & bitcast<u32>(~(_e797))));
                                                let _e826 = bitcast<f32>((_e801 & bitcast<u32>(~(_e806))));
                                                let _e830 = bitcast<f32>((_e810 & bitcast<u32>(~(_e815))));
                                                let _e831 = (_e637.member.member.x + _e761);
                                                let _e832 = (_e637.member.member.y + _e770);
                                                let _e833 = (_e637.member.member.z + _e779);
                                                let _e836 = (_e637.member.member_1.x - _e800);
                                                let _e837 = (_e637.member.member_1.y - _e809);
                                                let _e838 = (_e637.member.member_1.z - _e818);
                                                let _e857 = (_e836 - _e831);
                                                let _e858 = (_e837 - _e832);
                                                let _e859 = (_e838 - _e833);
                                                let _e861 = select(_e858, _e857, (_e857 > _e858));
                                                let _e863 = select(_e859, _e861, (_e861 > _e859));
                                                if (_e863 < (1024f * _e162)) {
                                                    phi_2910_ = 0u;
                                                } else {
                                                    phi_2910_ = select(2u, 1u, (_e863 < (2097152f * _e162)));
                                                }
                                                let _e870 = phi_2910_;
                                                switch bitcast<i32>(_e870) {
                                                    case 0: {
                                                        phi_2916_ = 1u;
                                                        break;
                                                    }
                                                    case 1: {
                                                        phi_2916_ = 2u;
                                                        break;
                                                    }
                                                    case 2: {
                                                        phi_2916_ = 3u;
                                                        break;
                                                    }
                                                    default: {
                                                        phi_2916_ = u32();
                                                        break;
                                                    }
                                                }
                                                let _e873 = phi_2916_;
                                                let _e879 = global_8.member[_e637.member_1][0u];
                                                let _e883 = global_8.member[_e637.member_1][2u];
                                                let _e887 = global_8.member[_e637.member_1][4u];
                                                let _e891 = global_8.member[_e637.member_1][6u];
                                                let _e903 = (((_e883 >> bitcast<u32>(22i)) | ((_e887 >> bitcast<u32>(22i)) << bitcast<u32>(10i))) | ((_e891 >> bitcast<u32>(22i)) << bitcast<u32>(20i)));
                                                let _e904 = (_e879 & 268435455u);
                                                let _e905 = (_e903 & 268435455u);
                                                let _e908 = ((_e879 >> bitcast<u32>(28u)) & 7u);
                                                let _e916 = ((_e879 >> bitcast<u32>(31i)) | (((_e903 >> bitcast<u32>(28u)) & 3u) << bitcast<u32>(1i)));
                                                let _e917 = (_e908 != 0u);
                                                if (_e908 == 0u) {
                                                    phi_3171_ = _e904;
                                                } else {
                                                    if (_e908 == 7u) {
                                                        phi_3170_ = 2147483648u;
                                                    } else {
                                                        phi_3170_ = ((2147483648u | (_e908 << bitcast<u32>(28u))) | (_e905 & 268435455u));
                                                    }
                                                    let _e926 = phi_3170_;
                                                    phi_3171_ = _e926;
                                                }
                                                let _e928 = phi_3171_;
                                                if _e917 {
                                                    let _e929 = (_e908 != 7u);
                                                    if _e929 {
                                                        phi_3181_ = (_e905 + (_e908 * ((3u * _e873) + 1u)));
                                                    } else {
                                                        phi_3181_ = u32();
                                                    }
                                                    let _e933 = phi_3181_;
                                                    phi_3183_ = _e933;
                                                    phi_3184_ = select(true, false, _e929);
                                                } else {
                                                    phi_3183_ = u32();
                                                    phi_3184_ = true;
                                                }
                                                let _e936 = phi_3183_;
                                                let _e938 = phi_3184_;
                                                if (_e916 == 0u) {
                                                    phi_3205_ = (_e904 + select(0u, 1u, !(_e917)));
                                                } else {
                                                    if (_e916 == 7u) {
                                                        phi_3204_ = 2147483648u;
                                                    } else {
                                                        phi_3204_ = ((2147483648u | (_e916 << bitcast<u32>(28u))) | (select(_e936, _e905, _e938) & 268435455u));
                                                    }
                                                    let _e951 = phi_3204_;
                                                    phi_3205_ = _e951;
                                                }
                                                let _e953 = phi_3205_;
                                                phi_3209_ = type_62(array<vec4<f32>, 3>(vec4<f32>(_e831, (_e637.member.member.x + _e783), _e836, (_e637.member.member_1.x - _e822)), vec4<f32>(_e832, (_e637.member.member.y + _e787), _e837, (_e637.member.member_1.y - _e826)), vec4<f32>(_e833, (_e637.member.member.z + _e791), _e838, (_e637.member.member_1.z - _e830))), type_61(type_30((_e637.member.member + vec4<f32>(_e761, _e770, _e779, 0f)), (_e637.member.member_1 - vec4<f32>(_e800, _e809, _e818, 0f))), _e928), type_61(type_30((_e637.member.member + vec4<f32>(_e783, _e787, _e791, 0f)), (_e637.member.member_1 - vec4<f32>(_e822, _e826, _e830, 0f))), _e953));
                                            }
                                            let _e958 = phi_3209_;
                                            let _e970 = ((_e958.member[0].x - _e431) * _e436);
                                            let _e971 = ((_e958.member[0].y - _e431) * _e436);
                                            let _e972 = ((_e958.member[0].z - _e432) * _e436);
                                            let _e973 = ((_e958.member[0].w - _e432) * _e436);
                                            let _e983 = ((_e958.member[1].x - _e467) * _e472);
                                            let _e984 = ((_e958.member[1].y - _e467) * _e472);
                                            let _e985 = ((_e958.member[1].z - _e468) * _e472);
                                            let _e986 = ((_e958.member[1].w - _e468) * _e472);
                                            let _e996 = ((_e958.member[2].x - _e503) * _e508);
                                            let _e997 = ((_e958.member[2].y - _e503) * _e508);
                                            let _e998 = ((_e958.member[2].z - _e504) * _e508);
                                            let _e999 = ((_e958.member[2].w - _e504) * _e508);
                                            let _e1001 = select(_e998, _e996, (_e996 < _e998));
                                            let _e1003 = select(_e999, _e997, (_e997 < _e999));
                                            let _e1005 = select(_e998, _e996, (_e996 > _e998));
                                            let _e1007 = select(_e999, _e997, (_e997 > _e999));
                                            let _e1009 = select(_e972, _e970, (_e970 < _e972));
                                            let _e1011 = select(_e973, _e971, (_e971 < _e973));
                                            let _e1013 = select(_e985, _e983, (_e983 < _e985));
                                            let _e1015 = select(_e986, _e984, (_e984 < _e986));
                                            let _e1017 = select(_e1013, _e1009, (_e1009 > _e1013));
                                            let _e1019 = select(_e1015, _e1011, (_e1011 > _e1015));
                                            let _e1021 = select(_e1001, _e1017, (_e1017 > _e1001));
                                            let _e1023 = select(_e1003, _e1019, (_e1019 > _e1003));
                                            let _e1025 = select(_e972, _e970, (_e970 > _e972));
                                            let _e1027 = select(_e973, _e971, (_e971 > _e973));
                                            let _e1029 = select(_e985, _e983, (_e983 > _e985));
                                            let _e1031 = select(_e986, _e984, (_e984 > _e986));
                                            let _e1033 = select(_e1029, _e1025, (_e1025 < _e1029));
                                            let _e1035 = select(_e1031, _e1027, (_e1027 < _e1031));
                                            let _e1040 = -(_e1001);
                                            let _e1041 = -(_e1003);
                                            let _e1048 = (select(_e1005, _e1033, (_e1033 < _e1005)) + (select(_e1040, _e1005, (_e1005 > _e1040)) * 0.0000019073523f));
                                            let _e1049 = (select(_e1007, _e1035, (_e1035 < _e1007)) + (select(_e1041, _e1007, (_e1007 > _e1041)) * 0.0000019073523f));
                                            let _e1051 = select(_e554, _e1021, (_e1021 > _e554));
                                            let _e1053 = select(_e554, _e1023, (_e1023 > _e554));
                                            let _e1058 = (_e1051 <= select(_e598.member, _e1048, (_e1048 < _e598.member)));
                                            let _e1059 = (_e1053 <= select(_e598.member, _e1049, (_e1049 < _e598.member)));
                                            let _e1060 = (_e1051 <= _e1053);
                                            if _e1058 {
                                                if _e1059 {
                                                    if _e1060 {
                                                        phi_3553_ = _e958.member_2;
                                                    } else {
                                                        phi_3553_ = _e958.member_1;
                                                    }
                                                    let _e1064 = phi_3553_;
                                                    let _e1086 = (_e641 % 128u);
                                                    let _e1087 = (_e1086 < 128u);
                                                    if _e1087 {
                                                    } else {
                                                        phi_4078_ = true;
                                                        break;
                                                    }
                                                    local_8[_e1086] = _e1064.member_1;
                                                    if _e1087 {
                                                    } else {
                                                        phi_4078_ = true;
                                                        break;
                                                    }
                                                    local_7[_e1086] = _e1064.member.member.x;
                                                    if _e1087 {
                                                    } else {
                                                        phi_4078_ = true;
                                                        break;
                                                    }
                                                    local_6[_e1086] = _e1064.member.member.y;
                                                    if _e1087 {
                                                    } else {
                                                        phi_4078_ = true;
                                                        break;
                                                    }
                                                    local_5[_e1086] = _e1064.member.member.z;
                                                    if _e1087 {
                                                    } else {
                                                        phi_4078_ = true;
                                                        break;
                                                    }
                                                    local_4[_e1086] = _e1064.member.member_1.x;
                                                    if _e1087 {
                                                    } else {
                                                        phi_4078_ = true;
                                                        break;
                                                    }
                                                    local_3[_e1086] = _e1064.member.member_1.y;
                                                    if _e1087 {
                                                    } else {
                                                        phi_4078_ = true;
                                                        break;
                                                    }
                                                    local_2[_e1086] = _e1064.member.member_1.z;
                                                    if _e1087 {
                                                    } else {
                                                        phi_4078_ = true;
                                                        break;
                                                    }
                                                    local_9[_e1086] = select(_e1053, _e1051, (_e1051 > _e1053));
                                                    if _e1060 {
                                                        phi_3630_ = _e958.member_1;
                                                    } else {
                                                        phi_3630_ = _e958.member_2;
                                                    }
                                                    let _e1100 = phi_3630_;
                                                    phi_3631_ = _e1100;
                                                    phi_3632_ = (_e641 + 1u);
                                                } else {
                                                    phi_3631_ = type_61();
                                                    phi_3632_ = u32();
                                                }
                                                let _e1102 = phi_3631_;
                                                let _e1104 = phi_3632_;
                                                phi_3634_ = _e1102;
                                                phi_3635_ = _e1104;
                                                phi_3636_ = select(true, false, _e1059);
                                            } else {
                                                phi_3634_ = type_61();
                                                phi_3635_ = u32();
                                                phi_3636_ = true;
                                            }
                                            let _e1107 = phi_3634_;
                                            let _e1109 = phi_3635_;
                                            let _e1111 = phi_3636_;
                                            if _e1111 {
                                                if _e1058 {
                                                    phi_3645_ = _e958.member_1;
                                                } else {
                                                    phi_3645_ = _e958.member_2;
                                                }
                                                let _e1115 = phi_3645_;
                                                phi_3650_ = _e1115;
                                                phi_3651_ = select(_e1059, true, _e1058);
                                            } else {
                                                phi_3650_ = _e1107;
                                                phi_3651_ = _e639;
                                            }
                                            let _e1118 = phi_3650_;
                                            let _e1120 = phi_3651_;
                                            phi_4082_ = _e596;
                                            phi_3653_ = _e598;
                                            phi_3654_ = _e1118;
                                            phi_3655_ = _e1120;
                                            phi_3656_ = select(_e1109, _e641, _e1111);
                                        }
                                        let _e1856 = phi_4082_;
                                        let _e1858 = phi_3653_;
                                        let _e1860 = phi_3654_;
                                        let _e1862 = phi_3655_;
                                        let _e1864 = phi_3656_;
                                        phi_4081_ = _e1856;
                                        phi_3657_ = _e1858;
                                        phi_3658_ = _e1860;
                                        phi_3659_ = (_e602 - 1u);
                                        phi_3660_ = _e1862;
                                        phi_3661_ = _e1864;
                                    } else {
                                        phi_4081_ = _e596;
                                        phi_3657_ = _e598;
                                        phi_3658_ = _e637;
                                        phi_3659_ = _e602;
                                        phi_3660_ = _e639;
                                        phi_3661_ = _e641;
                                    }
                                    let _e1866 = phi_4081_;
                                    let _e1868 = phi_3657_;
                                    let _e1870 = phi_3658_;
                                    let _e1872 = phi_3659_;
                                    let _e1874 = phi_3660_;
                                    let _e1876 = phi_3661_;
                                    phi_4080_ = _e1866;
                                    phi_3662_ = _e1868;
                                    phi_3663_ = _e1870;
                                    phi_3664_ = _e1872;
                                    phi_3665_ = _e1874;
                                    phi_3666_ = _e1876;
                                } else {
                                    phi_4080_ = _e596;
                                    phi_3662_ = type_42();
                                    phi_3663_ = type_61();
                                    phi_3664_ = u32();
                                    phi_3665_ = bool();
                                    phi_3666_ = u32();
                                }
                                let _e1878 = phi_4080_;
                                let _e1880 = phi_3662_;
                                let _e1882 = phi_3663_;
                                let _e1884 = phi_3664_;
                                let _e1886 = phi_3665_;
                                let _e1888 = phi_3666_;
                                phi_4079_ = _e1878;
                                phi_1019_ = _e1880;
                                phi_1022_ = _e1882;
                                phi_1024_ = _e1884;
                                phi_1026_ = _e1886;
                                phi_1028_ = _e1888;
                                phi_3667_ = _e610;
                            } else {
                                phi_4079_ = _e596;
                                phi_1019_ = type_42();
                                phi_1022_ = type_61();
                                phi_1024_ = u32();
                                phi_1026_ = bool();
                                phi_1028_ = u32();
                                phi_3667_ = false;
                            }
                            let _e1890 = phi_4079_;
                            let _e1892 = phi_1019_;
                            let _e1894 = phi_1022_;
                            let _e1896 = phi_1024_;
                            let _e1898 = phi_1026_;
                            let _e1900 = phi_1028_;
                            let _e1902 = phi_3667_;
                            continue;
                            continuing {
                                phi_3940_ = _e1890;
                                phi_1018_ = _e1892;
                                phi_1021_ = _e1894;
                                phi_1023_ = _e1896;
                                phi_1025_ = _e1898;
                                phi_1027_ = _e1900;
                                phi_4078_ = _e1890;
                                break if !(_e1902);
                            }
                        }
                        let _e1905 = phi_4078_;
                        if _e1905 {
                            break;
                        }
                        let _e1907 = local_14;
                        if _e1907.member_1 {
                        } else {
                            if _e244 {
                            } else {
                                break;
                            }
                            let _e1911 = global_2.member[_e150];
                            if _e165 {
                            } else {
                                break;
                            }
                            let _e1915 = global_9.member[_e150].member_1;
                            if _e244 {
                            } else {
                                break;
                            }
                            global_2.member[_e150] = type_23(_e1911.member, _e1911.member_1, _e1911.member_2, array<f32, 3>((_e1911.member_3[0] + (_e1915[0] * _e1911.member_1[0])), (_e1911.member_3[1] + (_e1915[1] * _e1911.member_1[1])), (_e1911.member_3[2] + (_e1915[2] * _e1911.member_1[2]))), _e1911.member_4);
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
fn trace_shadows_q21_lattice(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
