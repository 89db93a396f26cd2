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

struct type_26 {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: u32,
}

struct type_28 {
    member: array<type_26>,
}

struct type_30 {
    member: array<f32, 3>,
    member_1: f32,
    member_2: array<f32, 3>,
    member_3: f32,
}

struct type_31 {
    member: type_30,
    member_1: array<f32, 3>,
    member_2: u32,
    member_3: array<f32, 3>,
    member_4: u32,
}

struct type_33 {
    member: array<type_31>,
}

struct type_38 {
    member: vec4<f32>,
    member_1: vec4<f32>,
}

struct type_40 {
    member: array<f32, 3>,
    member_1: u32,
    member_2: f32,
    member_3: array<u32, 3>,
}

struct type_43 {
    member: type_26,
    member_1: f32,
}

struct type_48 {
    member: array<vec4<u32>, 2>,
}

struct type_51 {
    member: array<i32>,
}

struct type_57 {
    member: array<array<u32, 7>>,
}

struct type_62 {
    member: type_38,
    member_1: u32,
}

struct type_63 {
    member: array<vec4<f32>, 3>,
    member_1: type_62,
    member_2: type_62,
}

struct type_68 {
    member: array<atomic<u32>>,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_1: type_12;
@group(0) @binding(1) 
var<uniform> global_2: type_48;
@group(0) @binding(2) 
var<uniform> global_3: type_48;
@group(0) @binding(4) 
var<storage> global_4: type_20;
@group(0) @binding(5) 
var<storage> global_5: type_4;
@group(0) @binding(6) 
var<storage> global_6: type_51;
@group(0) @binding(7) 
var<storage> global_7: type_33;
@group(0) @binding(8) 
var<storage, read_write> global_8: type_28;
@group(0) @binding(9) 
var<storage, read_write> global_9: type_68;
@group(0) @binding(3) 
var<storage> global_10: type_57;

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
    var phi_326_: u32;
    var phi_370_: i32;
    var phi_394_: type_40;
    var phi_500_: i32;
    var phi_501_: i32;
    var phi_511_: bool;
    var phi_521_: u32;
    var phi_522_: u32;
    var phi_524_: bool;
    var phi_529_: u32;
    var phi_561_: i32;
    var phi_579_: f32;
    var phi_585_: f32;
    var phi_596_: f32;
    var phi_602_: f32;
    var phi_625_: f32;
    var phi_636_: f32;
    var phi_645_: f32;
    var phi_651_: f32;
    var phi_662_: f32;
    var phi_668_: f32;
    var phi_691_: f32;
    var phi_702_: f32;
    var phi_711_: f32;
    var phi_717_: f32;
    var phi_728_: f32;
    var phi_734_: f32;
    var phi_757_: f32;
    var phi_768_: f32;
    var phi_868_: f32;
    var phi_869_: f32;
    var phi_3970_: bool;
    var phi_958_: type_43;
    var phi_961_: type_62;
    var phi_963_: u32;
    var phi_965_: bool;
    var phi_967_: u32;
    var phi_978_: bool;
    var phi_1064_: type_62;
    var phi_1065_: bool;
    var phi_1066_: u32;
    var phi_3142_: u32;
    var phi_3143_: u32;
    var phi_3153_: u32;
    var phi_3155_: u32;
    var phi_3156_: bool;
    var phi_3176_: u32;
    var phi_3177_: u32;
    var phi_3181_: type_63;
    var phi_3525_: type_62;
    var phi_3602_: type_62;
    var phi_3603_: type_62;
    var phi_3604_: u32;
    var phi_3606_: type_62;
    var phi_3607_: u32;
    var phi_3608_: bool;
    var phi_3617_: type_62;
    var phi_3622_: type_62;
    var phi_3623_: bool;
    var phi_1084_: type_43;
    var phi_1087_: type_8;
    var phi_1088_: type_8;
    var phi_1110_: type_8;
    var phi_1131_: u32;
    var phi_1220_: array<array<f32, 3>, 3>;
    var phi_1337_: bool;
    var phi_1366_: bool;
    var phi_1767_: f32;
    var phi_1768_: f32;
    var phi_1769_: f32;
    var phi_1770_: f32;
    var phi_1771_: vec3<f32>;
    var phi_1772_: vec3<f32>;
    var phi_1773_: vec3<f32>;
    var phi_1774_: vec3<f32>;
    var phi_1805_: bool;
    var phi_1814_: vec3<f32>;
    var phi_1981_: bool;
    var phi_2005_: f32;
    var phi_2006_: f32;
    var phi_2029_: type_26;
    var phi_2031_: type_26;
    var phi_2032_: bool;
    var phi_2036_: type_26;
    var phi_2037_: type_26;
    var phi_2038_: type_26;
    var phi_2039_: bool;
    var phi_2043_: type_26;
    var phi_2044_: bool;
    var phi_2045_: type_26;
    var phi_2046_: bool;
    var phi_2047_: bool;
    var phi_2048_: type_26;
    var phi_2049_: bool;
    var phi_2050_: bool;
    var phi_2058_: type_26;
    var phi_2059_: bool;
    var phi_2063_: type_26;
    var phi_2086_: u32;
    var phi_2100_: i32;
    var phi_2120_: vec3<f32>;
    var phi_2121_: vec3<f32>;
    var phi_2137_: vec3<f32>;
    var phi_2138_: vec3<f32>;
    var phi_2154_: vec3<f32>;
    var phi_2155_: vec3<f32>;
    var phi_2191_: vec3<f32>;
    var phi_2373_: f32;
    var phi_2391_: bool;
    var phi_2392_: bool;
    var phi_2411_: bool;
    var phi_2412_: bool;
    var phi_2418_: type_43;
    var phi_2419_: type_43;
    var phi_2420_: type_43;
    var phi_1085_: type_43;
    var phi_3964_: bool;
    var phi_4134_: bool;
    var phi_3625_: type_43;
    var phi_3626_: type_62;
    var phi_3627_: bool;
    var phi_3628_: u32;
    var phi_4133_: bool;
    var phi_3629_: type_43;
    var phi_3630_: type_62;
    var phi_3631_: u32;
    var phi_3632_: bool;
    var phi_3633_: u32;
    var phi_4132_: bool;
    var phi_3634_: type_43;
    var phi_3635_: type_62;
    var phi_3636_: u32;
    var phi_3637_: bool;
    var phi_3638_: u32;
    var phi_4131_: bool;
    var phi_959_: type_43;
    var phi_962_: type_62;
    var phi_964_: u32;
    var phi_966_: bool;
    var phi_968_: u32;
    var phi_3639_: bool;
    var phi_4130_: bool;
    var local_10: type_43;
    var phi_3691_: type_26;
    var local_11: type_43;

    switch bitcast<i32>(0u) {
        default: {
            let _e93 = global;
            let _e95 = arrayLength((&global_10.member));
            let _e97 = arrayLength((&global_4.member));
            let _e109 = arrayLength((&global_9.member));
            let _e113 = global_3.member[0u][0u];
            let _e117 = global_3.member[0u][1u];
            let _e121 = global_3.member[0u][2u];
            let _e125 = global_3.member[0u][3u];
            let _e129 = global_3.member[1u][0u];
            let _e133 = global_3.member[1u][1u];
            let _e137 = global_3.member[1u][2u];
            let _e141 = (_e93.x + (_e93.y * 2097152u));
            let _e153 = bitcast<f32>((bitcast<u32>((bitcast<i32>(_e125) + 127i)) << bitcast<u32>(23i)));
            local_1 = array<i32, 3>(bitcast<i32>(_e113), bitcast<i32>(_e117), bitcast<i32>(_e121));
            local = array<i32, 3>(bitcast<i32>(_e129), bitcast<i32>(_e133), bitcast<i32>(_e137));
            let _e156 = (_e141 < arrayLength((&global_7.member)));
            if _e156 {
                if _e156 {
                } else {
                    break;
                }
                let _e160 = global_7.member[_e141].member_2;
                phi_326_ = _e160;
            } else {
                phi_326_ = 4294967295u;
            }
            let _e162 = phi_326_;
            let _e165 = global_1.member[0u];
            let _e169 = global_2.member[0u][0u];
            let _e173 = global_2.member[0u][1u];
            let _e177 = global_2.member[0u][2u];
            let _e181 = global_2.member[0u][3u];
            let _e185 = global_2.member[1u][0u];
            let _e189 = global_2.member[1u][1u];
            let _e193 = global_2.member[1u][2u];
            let _e197 = global_2.member[1u][3u];
            let _e198 = bitcast<f32>(_e169);
            let _e199 = bitcast<f32>(_e173);
            let _e200 = bitcast<f32>(_e177);
            let _e202 = bitcast<f32>(_e185);
            let _e203 = array<u32, 3>(_e189, _e193, _e197);
            let _e205 = bitcast<i32>(_e165);
            if (_e205 < -126i) {
                phi_370_ = -126i;
            } else {
                phi_370_ = select(_e205, 127i, (_e205 > 127i));
            }
            let _e210 = phi_370_;
            let _e215 = bitcast<f32>((bitcast<u32>((_e210 + 127i)) << bitcast<u32>(23i)));
            let _e221 = bitcast<f32>((bitcast<u32>(((_e205 - _e210) + 127i)) << bitcast<u32>(23i)));
            if (_e181 == 0u) {
                phi_394_ = type_40(array<f32, 3>(_e198, _e199, _e200), _e181, _e202, _e203);
            } else {
                phi_394_ = type_40(array<f32, 3>(((_e198 * _e215) * _e221), ((_e199 * _e215) * _e221), ((_e200 * _e215) * _e221)), _e181, ((_e202 * _e215) * _e221), _e203);
            }
            let _e234 = phi_394_;
            if _e156 {
                let _e235 = (_e141 < arrayLength((&global_8.member)));
                if _e235 {
                    if _e156 {
                    } else {
                        break;
                    }
                    let _e245 = global_7.member[_e141].member.member_2[0u];
                    let _e247 = (bitcast<u32>(_e245) & 2147483647u);
                    let _e253 = global_7.member[_e141].member.member_2[1u];
                    let _e255 = (bitcast<u32>(_e253) & 2147483647u);
                    let _e261 = global_7.member[_e141].member.member_2[2u];
                    let _e263 = (bitcast<u32>(_e261) & 2147483647u);
                    let _e269 = global_7.member[_e141].member.member[0u];
                    let _e271 = (bitcast<u32>(_e269) & 2147483647u);
                    let _e277 = global_7.member[_e141].member.member[1u];
                    let _e279 = (bitcast<u32>(_e277) & 2147483647u);
                    let _e285 = global_7.member[_e141].member.member[2u];
                    let _e287 = (bitcast<u32>(_e285) & 2147483647u);
                    let _e289 = select(_e255, _e247, (_e255 < _e247));
                    let _e291 = select(_e263, _e289, (_e263 < _e289));
                    let _e293 = select(_e271, _e291, (_e271 < _e291));
                    let _e295 = select(_e279, _e293, (_e279 < _e293));
                    let _e297 = select(_e287, _e295, (_e287 < _e295));
                    let _e302 = global_7.member[_e141].member.member_1;
                    let _e304 = (bitcast<u32>(_e302) & 2147483647u);
                    let _e312 = global_7.member[_e141].member.member_3;
                    let _e318 = (((select(_e304, _e297, (_e304 < _e297)) < 2139095040u) && ((bitcast<u32>(_e312) & 2147483647u) <= 2139095040u)) && (_e291 > 0u));
                    if _e318 {
                        let _e321 = (bitcast<u32>(bitcast<f32>(_e291)) & 2147483647u);
                        if (_e321 >= 8388608u) {
                            phi_500_ = (bitcast<i32>((_e321 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_500_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e321)), 32u, (_e321 == 0u))));
                        }
                        let _e335 = phi_500_;
                        phi_501_ = _e335;
                    } else {
                        phi_501_ = 0i;
                    }
                    let _e337 = phi_501_;
                    let _e338 = (_e247 == _e291);
                    if _e338 {
                        phi_511_ = true;
                    } else {
                        phi_511_ = (_e255 == _e291);
                    }
                    let _e341 = phi_511_;
                    let _e342 = select(1u, 0u, _e338);
                    if _e341 {
                        let _e343 = (_e342 + 1u);
                        phi_521_ = _e343;
                        phi_522_ = _e343;
                        phi_524_ = select(true, false, (_e343 == 2u));
                    } else {
                        phi_521_ = u32();
                        phi_522_ = 0u;
                        phi_524_ = true;
                    }
                    let _e347 = phi_521_;
                    let _e349 = phi_522_;
                    let _e351 = phi_524_;
                    if _e351 {
                        phi_529_ = (_e349 + 1u);
                    } else {
                        phi_529_ = 0u;
                    }
                    let _e355 = phi_529_;
                    let _e356 = select(_e347, _e349, _e351);
                    let _e357 = select(_e342, select(2u, _e342, _e341), _e351);
                    let _e358 = -(_e337);
                    if (_e358 < -126i) {
                        phi_561_ = -126i;
                    } else {
                        phi_561_ = select(_e358, 127i, (_e358 > 127i));
                    }
                    let _e363 = phi_561_;
                    let _e368 = bitcast<f32>((bitcast<u32>((_e363 + 127i)) << bitcast<u32>(23i)));
                    let _e374 = bitcast<f32>((bitcast<u32>(((_e358 - _e363) + 127i)) << bitcast<u32>(23i)));
                    let _e379 = global_7.member[_e141].member.member;
                    let _e380 = (_e356 == 0u);
                    if _e380 {
                        phi_579_ = _e379[0];
                    } else {
                        phi_579_ = _e379[1];
                    }
                    let _e384 = phi_579_;
                    let _e385 = (_e356 == 2u);
                    if _e385 {
                        phi_585_ = _e379[2];
                    } else {
                        phi_585_ = _e384;
                    }
                    let _e388 = phi_585_;
                    let _e389 = global_7.member[_e141].member.member_2;
                    if _e380 {
                        phi_596_ = _e389[0];
                    } else {
                        phi_596_ = _e389[1];
                    }
                    let _e393 = phi_596_;
                    if _e385 {
                        phi_602_ = _e389[2];
                    } else {
                        phi_602_ = _e393;
                    }
                    let _e396 = phi_602_;
                    let _e398 = ((_e396 * _e368) * _e374);
                    let _e402 = (bitcast<f32>((bitcast<u32>(_e398) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e402 {
                        let _e406 = (bitcast<f32>((bitcast<u32>(_e388) & 2147483647u)) * 0.00000011920929f);
                        phi_625_ = select(0.00000000000011368684f, _e406, (_e406 > 0.00000000000011368684f));
                    } else {
                        phi_625_ = 0f;
                    }
                    let _e410 = phi_625_;
                    let _e411 = (_e388 + _e410);
                    let _e412 = (_e388 - _e410);
                    let _e413 = select(_e398, 0f, _e402);
                    if _e402 {
                        phi_636_ = 38685626000000000000000000f;
                    } else {
                        phi_636_ = (1f / _e398);
                    }
                    let _e416 = phi_636_;
                    let _e417 = (_e355 == 0u);
                    if _e417 {
                        phi_645_ = _e379[0];
                    } else {
                        phi_645_ = _e379[1];
                    }
                    let _e421 = phi_645_;
                    let _e422 = (_e355 == 2u);
                    if _e422 {
                        phi_651_ = _e379[2];
                    } else {
                        phi_651_ = _e421;
                    }
                    let _e425 = phi_651_;
                    if _e417 {
                        phi_662_ = _e389[0];
                    } else {
                        phi_662_ = _e389[1];
                    }
                    let _e429 = phi_662_;
                    if _e422 {
                        phi_668_ = _e389[2];
                    } else {
                        phi_668_ = _e429;
                    }
                    let _e432 = phi_668_;
                    let _e434 = ((_e432 * _e368) * _e374);
                    let _e438 = (bitcast<f32>((bitcast<u32>(_e434) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e438 {
                        let _e442 = (bitcast<f32>((bitcast<u32>(_e425) & 2147483647u)) * 0.00000011920929f);
                        phi_691_ = select(0.00000000000011368684f, _e442, (_e442 > 0.00000000000011368684f));
                    } else {
                        phi_691_ = 0f;
                    }
                    let _e446 = phi_691_;
                    let _e447 = (_e425 + _e446);
                    let _e448 = (_e425 - _e446);
                    let _e449 = select(_e434, 0f, _e438);
                    if _e438 {
                        phi_702_ = 38685626000000000000000000f;
                    } else {
                        phi_702_ = (1f / _e434);
                    }
                    let _e452 = phi_702_;
                    let _e453 = (_e357 == 0u);
                    if _e453 {
                        phi_711_ = _e379[0];
                    } else {
                        phi_711_ = _e379[1];
                    }
                    let _e457 = phi_711_;
                    let _e458 = (_e357 == 2u);
                    if _e458 {
                        phi_717_ = _e379[2];
                    } else {
                        phi_717_ = _e457;
                    }
                    let _e461 = phi_717_;
                    if _e453 {
                        phi_728_ = _e389[0];
                    } else {
                        phi_728_ = _e389[1];
                    }
                    let _e465 = phi_728_;
                    if _e458 {
                        phi_734_ = _e389[2];
                    } else {
                        phi_734_ = _e465;
                    }
                    let _e468 = phi_734_;
                    let _e470 = ((_e468 * _e368) * _e374);
                    let _e474 = (bitcast<f32>((bitcast<u32>(_e470) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e474 {
                        let _e478 = (bitcast<f32>((bitcast<u32>(_e461) & 2147483647u)) * 0.00000011920929f);
                        phi_757_ = select(0.00000000000011368684f, _e478, (_e478 > 0.00000000000011368684f));
                    } else {
                        phi_757_ = 0f;
                    }
                    let _e482 = phi_757_;
                    let _e483 = (_e461 + _e482);
                    let _e484 = (_e461 - _e482);
                    let _e485 = select(_e470, 0f, _e474);
                    if _e474 {
                        phi_768_ = 38685626000000000000000000f;
                    } else {
                        phi_768_ = (1f / _e470);
                    }
                    let _e488 = phi_768_;
                    let _e491 = bitcast<f32>((bitcast<u32>(_e388) & 2147483647u));
                    let _e494 = bitcast<f32>((bitcast<u32>(_e425) & 2147483647u));
                    let _e496 = select(_e494, _e491, (_e491 > _e494));
                    let _e499 = bitcast<f32>((bitcast<u32>(_e461) & 2147483647u));
                    if (_e318 && (select(_e499, _e496, (_e496 > _e499)) <= 1099511600000f)) {
                        let _e504 = (_e337 / 3i);
                        let _e511 = bitcast<f32>((bitcast<u32>((_e504 + 127i)) << bitcast<u32>(23i)));
                        let _e518 = bitcast<f32>((bitcast<u32>(((_e337 - (2i * _e504)) + 127i)) << bitcast<u32>(23i)));
                        let _e519 = (((_e302 * _e511) * _e511) * _e518);
                        let _e521 = select(340282350000000000000000000000000000000f, _e519, (_e519 < 340282350000000000000000000000000000000f));
                        let _e526 = (((_e312 * _e511) * _e511) * _e518);
                        let _e528 = select(340282350000000000000000000000000000000f, _e526, (_e526 < 340282350000000000000000000000000000000f));
                        phi_868_ = select(-340282350000000000000000000000000000000f, _e528, (_e528 > -340282350000000000000000000000000000000f));
                        phi_869_ = select(-340282350000000000000000000000000000000f, _e521, (_e521 > -340282350000000000000000000000000000000f));
                    } else {
                        phi_868_ = 0f;
                        phi_869_ = 1f;
                    }
                    let _e532 = phi_868_;
                    let _e534 = phi_869_;
                    local_8 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                    local_7 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_6 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_5 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_4 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_3 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_9 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    let _e538 = (_e356 % 3u);
                    let _e539 = (_e538 < 3u);
                    if _e539 {
                    } else {
                        break;
                    }
                    let _e541 = local_1[_e538];
                    let _e544 = (_e355 % 3u);
                    let _e545 = (_e544 < 3u);
                    if _e545 {
                    } else {
                        break;
                    }
                    let _e547 = local_1[_e544];
                    let _e550 = (_e357 % 3u);
                    let _e551 = (_e550 < 3u);
                    if _e551 {
                    } else {
                        break;
                    }
                    let _e553 = local_1[_e550];
                    if _e539 {
                    } else {
                        break;
                    }
                    let _e558 = local[_e538];
                    if _e545 {
                    } else {
                        break;
                    }
                    let _e562 = local[_e544];
                    if _e551 {
                    } else {
                        break;
                    }
                    let _e566 = local[_e550];
                    phi_3970_ = false;
                    phi_958_ = type_43(type_26(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e532);
                    phi_961_ = type_62(type_38(vec4<f32>((f32(_e541) * _e153), (f32(_e547) * _e153), (f32(_e553) * _e153), 0f), vec4<f32>((f32(_e558) * _e153), (f32(_e562) * _e153), (f32(_e566) * _e153), 0f)), select(0u, 2147483648u, (_e95 == 0u)));
                    phi_963_ = ((3u * _e95) + 1u);
                    phi_965_ = (_e534 <= _e532);
                    phi_967_ = 0u;
                    loop {
                        let _e576 = phi_3970_;
                        let _e578 = phi_958_;
                        let _e580 = phi_961_;
                        let _e582 = phi_963_;
                        let _e584 = phi_965_;
                        let _e586 = phi_967_;
                        local_10 = _e578;
                        if _e584 {
                            phi_978_ = true;
                        } else {
                            phi_978_ = (_e586 > 0u);
                        }
                        let _e589 = phi_978_;
                        if _e589 {
                            let _e590 = (_e582 > 0u);
                            if _e590 {
                                if _e584 {
                                    phi_1064_ = _e580;
                                    phi_1065_ = _e584;
                                    phi_1066_ = _e586;
                                } else {
                                    let _e591 = (_e586 - 1u);
                                    let _e592 = (_e591 % 128u);
                                    let _e593 = (_e592 < 128u);
                                    if _e593 {
                                    } else {
                                        phi_4130_ = true;
                                        break;
                                    }
                                    let _e595 = local_7[_e592];
                                    if _e593 {
                                    } else {
                                        phi_4130_ = true;
                                        break;
                                    }
                                    let _e597 = local_6[_e592];
                                    if _e593 {
                                    } else {
                                        phi_4130_ = true;
                                        break;
                                    }
                                    let _e599 = local_5[_e592];
                                    if _e593 {
                                    } else {
                                        phi_4130_ = true;
                                        break;
                                    }
                                    let _e601 = local_4[_e592];
                                    if _e593 {
                                    } else {
                                        phi_4130_ = true;
                                        break;
                                    }
                                    let _e603 = local_3[_e592];
                                    if _e593 {
                                    } else {
                                        phi_4130_ = true;
                                        break;
                                    }
                                    let _e605 = local_2[_e592];
                                    if _e593 {
                                    } else {
                                        phi_4130_ = true;
                                        break;
                                    }
                                    let _e610 = local_8[_e592];
                                    if _e593 {
                                    } else {
                                        phi_4130_ = true;
                                        break;
                                    }
                                    let _e613 = local_9[_e592];
                                    phi_1064_ = type_62(type_38(vec4<f32>(_e595, _e597, _e599, 0f), vec4<f32>(_e601, _e603, _e605, 0f)), _e610);
                                    phi_1065_ = (_e613 <= _e578.member_1);
                                    phi_1066_ = _e591;
                                }
                                let _e617 = phi_1064_;
                                let _e619 = phi_1065_;
                                let _e621 = phi_1066_;
                                if _e619 {
                                    if ((_e617.member_1 & 2147483648u) != 0u) {
                                        phi_1084_ = _e578;
                                        phi_1087_ = type_8(0u, ((_e617.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e1083 = phi_1084_;
                                            let _e1085 = phi_1087_;
                                            local_11 = _e1083;
                                            if (_e1085.member < _e1085.member_1) {
                                                phi_1088_ = type_8((_e1085.member + 1u), _e1085.member_1);
                                                phi_1110_ = type_8(1u, _e1085.member);
                                            } else {
                                                phi_1088_ = _e1085;
                                                phi_1110_ = type_8(0u, type_8().member_1);
                                            }
                                            let _e1098 = phi_1088_;
                                            let _e1100 = phi_1110_;
                                            let _e1104 = (bitcast<i32>(_e1100.member) != 0i);
                                            if _e1104 {
                                                let _e1105 = ((_e617.member_1 & 268435455u) + _e1100.member_1);
                                                let _e1106 = (_e1105 < _e97);
                                                if _e1106 {
                                                    if _e1106 {
                                                    } else {
                                                        phi_3964_ = true;
                                                        break;
                                                    }
                                                    let _e1110 = global_4.member[_e1105].member_1;
                                                    phi_1131_ = _e1110;
                                                } else {
                                                    phi_1131_ = 4294967295u;
                                                }
                                                let _e1112 = phi_1131_;
                                                if (_e1105 >= _e97) {
                                                    phi_1220_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                } else {
                                                    if _e1106 {
                                                    } else {
                                                        phi_3964_ = true;
                                                        break;
                                                    }
                                                    if (_e538 < 9u) {
                                                    } else {
                                                        phi_3964_ = true;
                                                        break;
                                                    }
                                                    let _e1119 = global_4.member[_e1105].member[_e538];
                                                    if (_e544 < 9u) {
                                                    } else {
                                                        phi_3964_ = true;
                                                        break;
                                                    }
                                                    let _e1125 = global_4.member[_e1105].member[_e544];
                                                    if (_e550 < 9u) {
                                                    } else {
                                                        phi_3964_ = true;
                                                        break;
                                                    }
                                                    let _e1131 = global_4.member[_e1105].member[_e550];
                                                    let _e1133 = (3u + _e538);
                                                    if (_e1133 < 9u) {
                                                    } else {
                                                        phi_3964_ = true;
                                                        break;
                                                    }
                                                    let _e1139 = global_4.member[_e1105].member[_e1133];
                                                    let _e1140 = (3u + _e544);
                                                    if (_e1140 < 9u) {
                                                    } else {
                                                        phi_3964_ = true;
                                                        break;
                                                    }
                                                    let _e1146 = global_4.member[_e1105].member[_e1140];
                                                    let _e1147 = (3u + _e550);
                                                    if (_e1147 < 9u) {
                                                    } else {
                                                        phi_3964_ = true;
                                                        break;
                                                    }
                                                    let _e1153 = global_4.member[_e1105].member[_e1147];
                                                    let _e1155 = (6u + _e538);
                                                    if (_e1155 < 9u) {
                                                    } else {
                                                        phi_3964_ = true;
                                                        break;
                                                    }
                                                    let _e1161 = global_4.member[_e1105].member[_e1155];
                                                    let _e1162 = (6u + _e544);
                                                    if (_e1162 < 9u) {
                                                    } else {
                                                        phi_3964_ = true;
                                                        break;
                                                    }
                                                    let _e1168 = global_4.member[_e1105].member[_e1162];
                                                    let _e1169 = (6u + _e550);
                                                    if (_e1169 < 9u) {
                                                    } else {
                                                        phi_3964_ = true;
                                                        break;
                                                    }
                                                    let _e1175 = global_4.member[_e1105].member[_e1169];
                                                    phi_1220_ = array<array<f32, 3>, 3>(array<f32, 3>(_e1119, _e1125, _e1131), array<f32, 3>(_e1139, _e1146, _e1153), array<f32, 3>(_e1161, _e1168, _e1175));
                                                }
                                                let _e1179 = phi_1220_;
                                                let _e1187 = (_e1179[0][2] - _e461);
                                                let _e1190 = (((_e1179[0][0] - _e388) * _e485) - (_e1187 * _e413));
                                                let _e1193 = (((_e1179[0][1] - _e425) * _e485) - (_e1187 * _e449));
                                                let _e1200 = (_e1179[1][2] - _e461);
                                                let _e1203 = (((_e1179[1][0] - _e388) * _e485) - (_e1200 * _e413));
                                                let _e1206 = (((_e1179[1][1] - _e425) * _e485) - (_e1200 * _e449));
                                                let _e1213 = (_e1179[2][2] - _e461);
                                                let _e1216 = (((_e1179[2][0] - _e388) * _e485) - (_e1213 * _e413));
                                                let _e1219 = (((_e1179[2][1] - _e425) * _e485) - (_e1213 * _e449));
                                                let _e1220 = (_e1216 * _e1206);
                                                let _e1221 = (_e1219 * _e1203);
                                                let _e1222 = (_e1190 * _e1219);
                                                let _e1223 = (_e1193 * _e1216);
                                                let _e1224 = (_e1203 * _e1193);
                                                let _e1225 = (_e1206 * _e1190);
                                                let _e1230 = (((_e1220 >= _e1221) && (_e1222 >= _e1223)) && (_e1224 >= _e1225));
                                                if (_e1230 || (((_e1220 <= _e1221) && (_e1222 <= _e1223)) && (_e1224 <= _e1225))) {
                                                    let _e1237 = select(-1f, 1f, _e1230);
                                                    let _e1239 = ((_e1220 - _e1221) * _e1237);
                                                    let _e1241 = select(0f, _e1239, (_e1239 > 0f));
                                                    let _e1243 = ((_e1222 - _e1223) * _e1237);
                                                    let _e1245 = select(0f, _e1243, (_e1243 > 0f));
                                                    let _e1247 = ((_e1224 - _e1225) * _e1237);
                                                    let _e1249 = select(0f, _e1247, (_e1247 > 0f));
                                                    let _e1251 = ((_e1241 + _e1245) + _e1249);
                                                    if (_e1251 < 0.000000000000000000000000000000000000011754944f) {
                                                        phi_2048_ = type_26();
                                                        phi_2049_ = true;
                                                        phi_2050_ = false;
                                                    } else {
                                                        let _e1254 = select(_e1203, _e1190, (_e1190 < _e1203));
                                                        if (select(_e1216, _e1254, (_e1254 < _e1216)) > 0f) {
                                                            phi_1337_ = true;
                                                        } else {
                                                            let _e1259 = select(_e1203, _e1190, (_e1190 > _e1203));
                                                            phi_1337_ = (select(_e1216, _e1259, (_e1259 > _e1216)) < 0f);
                                                        }
                                                        let _e1264 = phi_1337_;
                                                        if _e1264 {
                                                            phi_2045_ = type_26();
                                                            phi_2046_ = true;
                                                            phi_2047_ = false;
                                                        } else {
                                                            let _e1266 = select(_e1206, _e1193, (_e1193 < _e1206));
                                                            if (select(_e1219, _e1266, (_e1266 < _e1219)) > 0f) {
                                                                phi_1366_ = true;
                                                            } else {
                                                                let _e1271 = select(_e1206, _e1193, (_e1193 > _e1206));
                                                                phi_1366_ = (select(_e1219, _e1271, (_e1271 > _e1219)) < 0f);
                                                            }
                                                            let _e1276 = phi_1366_;
                                                            if _e1276 {
                                                                phi_2043_ = type_26();
                                                                phi_2044_ = false;
                                                            } else {
                                                                let _e1278 = select(_e1179[1][0], _e1179[0][0], (_e1179[0][0] < _e1179[1][0]));
                                                                let _e1282 = select(_e1179[1][0], _e1179[0][0], (_e1179[0][0] > _e1179[1][0]));
                                                                let _e1286 = select(_e1179[1][1], _e1179[0][1], (_e1179[0][1] < _e1179[1][1]));
                                                                let _e1290 = select(_e1179[1][1], _e1179[0][1], (_e1179[0][1] > _e1179[1][1]));
                                                                let _e1294 = select(_e1179[1][2], _e1179[0][2], (_e1179[0][2] < _e1179[1][2]));
                                                                let _e1298 = select(_e1179[1][2], _e1179[0][2], (_e1179[0][2] > _e1179[1][2]));
                                                                let _e1303 = ((select(_e1179[2][0], _e1278, (_e1278 < _e1179[2][0])) - _e411) * _e416);
                                                                let _e1304 = ((select(_e1179[2][0], _e1282, (_e1282 > _e1179[2][0])) - _e412) * _e416);
                                                                let _e1307 = ((select(_e1179[2][1], _e1286, (_e1286 < _e1179[2][1])) - _e447) * _e452);
                                                                let _e1308 = ((select(_e1179[2][1], _e1290, (_e1290 > _e1179[2][1])) - _e448) * _e452);
                                                                let _e1311 = ((select(_e1179[2][2], _e1294, (_e1294 < _e1179[2][2])) - _e483) * _e488);
                                                                let _e1312 = ((select(_e1179[2][2], _e1298, (_e1298 > _e1179[2][2])) - _e484) * _e488);
                                                                let _e1314 = select(_e1312, _e1311, (_e1311 < _e1312));
                                                                let _e1316 = select(_e1312, _e1311, (_e1311 > _e1312));
                                                                let _e1318 = select(_e1304, _e1303, (_e1303 < _e1304));
                                                                let _e1320 = select(_e1308, _e1307, (_e1307 < _e1308));
                                                                let _e1322 = select(_e1320, _e1318, (_e1318 > _e1320));
                                                                let _e1324 = select(_e1314, _e1322, (_e1322 > _e1314));
                                                                let _e1326 = select(_e1304, _e1303, (_e1303 > _e1304));
                                                                let _e1328 = select(_e1308, _e1307, (_e1307 > _e1308));
                                                                let _e1330 = select(_e1328, _e1326, (_e1326 < _e1328));
                                                                let _e1332 = select(_e1316, _e1330, (_e1330 < _e1316));
                                                                let _e1333 = -(_e1314);
                                                                let _e1339 = select(_e534, _e1324, (_e1324 > _e534));
                                                                if (_e1339 > (_e1332 + (select(_e1333, _e1316, (_e1316 > _e1333)) * 0.0000019073523f))) {
                                                                    phi_2038_ = type_26();
                                                                    phi_2039_ = true;
                                                                } else {
                                                                    let _e1341 = (_e1339 > _e1083.member_1);
                                                                    if _e1341 {
                                                                        phi_2037_ = type_26();
                                                                    } else {
                                                                        let _e1342 = vec3<f32>(_e1179[0][0], _e1179[0][1], _e1179[0][2]);
                                                                        let _e1343 = vec3<f32>(_e1179[1][0], _e1179[1][1], _e1179[1][2]);
                                                                        let _e1344 = vec3<f32>(_e1179[2][0], _e1179[2][1], _e1179[2][2]);
                                                                        let _e1345 = (_e1179[1][0] - _e1179[0][0]);
                                                                        let _e1346 = (_e1179[1][1] - _e1179[0][1]);
                                                                        let _e1347 = (_e1179[1][2] - _e1179[0][2]);
                                                                        let _e1348 = vec3<f32>(_e1345, _e1346, _e1347);
                                                                        let _e1349 = (_e1179[2][0] - _e1179[1][0]);
                                                                        let _e1350 = (_e1179[2][1] - _e1179[1][1]);
                                                                        let _e1351 = (_e1179[2][2] - _e1179[1][2]);
                                                                        let _e1352 = vec3<f32>(_e1349, _e1350, _e1351);
                                                                        let _e1353 = (_e1179[0][0] - _e1179[2][0]);
                                                                        let _e1354 = (_e1179[0][1] - _e1179[2][1]);
                                                                        let _e1355 = (_e1179[0][2] - _e1179[2][2]);
                                                                        let _e1356 = vec3<f32>(_e1353, _e1354, _e1355);
                                                                        let _e1359 = bitcast<f32>((bitcast<u32>(_e1345) & 2147483647u));
                                                                        let _e1362 = bitcast<f32>((bitcast<u32>(_e1346) & 2147483647u));
                                                                        let _e1364 = select(_e1362, _e1359, (_e1359 > _e1362));
                                                                        let _e1367 = bitcast<f32>((bitcast<u32>(_e1347) & 2147483647u));
                                                                        let _e1369 = select(_e1367, _e1364, (_e1364 > _e1367));
                                                                        let _e1372 = bitcast<f32>((bitcast<u32>(_e1349) & 2147483647u));
                                                                        let _e1375 = bitcast<f32>((bitcast<u32>(_e1350) & 2147483647u));
                                                                        let _e1377 = select(_e1375, _e1372, (_e1372 > _e1375));
                                                                        let _e1380 = bitcast<f32>((bitcast<u32>(_e1351) & 2147483647u));
                                                                        let _e1382 = select(_e1380, _e1377, (_e1377 > _e1380));
                                                                        let _e1385 = bitcast<f32>((bitcast<u32>(_e1353) & 2147483647u));
                                                                        let _e1388 = bitcast<f32>((bitcast<u32>(_e1354) & 2147483647u));
                                                                        let _e1390 = select(_e1388, _e1385, (_e1385 > _e1388));
                                                                        let _e1393 = bitcast<f32>((bitcast<u32>(_e1355) & 2147483647u));
                                                                        let _e1395 = select(_e1393, _e1390, (_e1390 > _e1393));
                                                                        let _e1397 = select(_e1382, _e1369, (_e1369 > _e1382));
                                                                        let _e1399 = select(_e1395, _e1397, (_e1397 > _e1395));
                                                                        if (_e1369 == _e1399) {
                                                                            phi_1767_ = _e1206;
                                                                            phi_1768_ = _e1203;
                                                                            phi_1769_ = _e1193;
                                                                            phi_1770_ = _e1190;
                                                                            phi_1771_ = _e1342;
                                                                            phi_1772_ = _e1356;
                                                                            phi_1773_ = _e1352;
                                                                            phi_1774_ = _e1348;
                                                                        } else {
                                                                            let _e1401 = (_e1382 == _e1399);
                                                                            let _e1406 = vec3(_e1401);
                                                                            phi_1767_ = select(_e1193, _e1219, _e1401);
                                                                            phi_1768_ = select(_e1190, _e1216, _e1401);
                                                                            phi_1769_ = select(_e1219, _e1206, _e1401);
                                                                            phi_1770_ = select(_e1216, _e1203, _e1401);
                                                                            phi_1771_ = select(_e1344, _e1343, _e1406);
                                                                            phi_1772_ = select(_e1352, _e1348, _e1406);
                                                                            phi_1773_ = select(_e1348, _e1356, _e1406);
                                                                            phi_1774_ = select(_e1356, _e1352, _e1406);
                                                                        }
                                                                        let _e1412 = phi_1767_;
                                                                        let _e1414 = phi_1768_;
                                                                        let _e1416 = phi_1769_;
                                                                        let _e1418 = phi_1770_;
                                                                        let _e1420 = phi_1771_;
                                                                        let _e1422 = phi_1772_;
                                                                        let _e1424 = phi_1773_;
                                                                        let _e1426 = phi_1774_;
                                                                        let _e1433 = ((_e1424.y * _e1422.z) - (_e1422.y * _e1424.z));
                                                                        let _e1438 = ((_e1424.z * _e1422.x) - (_e1422.z * _e1424.x));
                                                                        let _e1441 = ((_e1424.x * _e1422.y) - (_e1422.x * _e1424.y));
                                                                        if (_e1241 >= _e1245) {
                                                                            phi_1805_ = select(true, false, (_e1241 >= _e1249));
                                                                        } else {
                                                                            phi_1805_ = true;
                                                                        }
                                                                        let _e1446 = phi_1805_;
                                                                        if _e1446 {
                                                                            phi_1814_ = select(_e1344, _e1343, vec3((_e1245 >= _e1249)));
                                                                        } else {
                                                                            phi_1814_ = _e1342;
                                                                        }
                                                                        let _e1451 = phi_1814_;
                                                                        let _e1456 = (((_e1433 * _e413) + (_e1438 * _e449)) + (_e1441 * _e485));
                                                                        let _e1467 = (((_e1433 * (_e1451.x - _e388)) + (_e1438 * (_e1451.y - _e425))) + (_e1441 * (_e1451.z - _e461)));
                                                                        let _e1469 = (_e1414 - _e1418);
                                                                        let _e1470 = (_e1412 - _e1416);
                                                                        let _e1478 = (-(((_e1418 * _e1469) + (_e1416 * _e1470))) / ((_e1469 * _e1469) + (_e1470 * _e1470)));
                                                                        let _e1480 = select(1f, _e1478, (_e1478 < 1f));
                                                                        let _e1482 = select(0f, _e1480, (_e1480 > 0f));
                                                                        let _e1495 = ((_e1420.x + (_e1426.x * _e1482)) - _e388);
                                                                        let _e1496 = ((_e1420.y + (_e1426.y * _e1482)) - _e425);
                                                                        let _e1497 = ((_e1420.z + (_e1426.z * _e1482)) - _e461);
                                                                        let _e1498 = (_e1497 / _e485);
                                                                        let _e1510 = bitcast<f32>((bitcast<u32>(_e1495) & 2147483647u));
                                                                        let _e1513 = bitcast<f32>((bitcast<u32>(_e1496) & 2147483647u));
                                                                        let _e1515 = select(_e1513, _e1510, (_e1510 > _e1513));
                                                                        let _e1518 = bitcast<f32>((bitcast<u32>(_e1497) & 2147483647u));
                                                                        let _e1520 = select(_e1518, _e1515, (_e1515 > _e1518));
                                                                        let _e1526 = bitcast<f32>((bitcast<u32>(_e1433) & 2147483647u));
                                                                        let _e1529 = bitcast<f32>((bitcast<u32>(_e1438) & 2147483647u));
                                                                        let _e1531 = select(_e1529, _e1526, (_e1526 > _e1529));
                                                                        let _e1534 = bitcast<f32>((bitcast<u32>(_e1441) & 2147483647u));
                                                                        if (bitcast<f32>((bitcast<u32>(((((_e1433 * _e1495) + (_e1438 * _e1496)) + (_e1441 * _e1497)) - _e1467)) & 2147483647u)) <= ((0.0000009536743f * select(_e1399, _e1520, (_e1520 > _e1399))) * select(_e1534, _e1531, (_e1531 > _e1534)))) {
                                                                            let _e1544 = bitcast<f32>((bitcast<u32>(_e1424.x) & 2147483647u));
                                                                            let _e1547 = bitcast<f32>((bitcast<u32>(_e1424.y) & 2147483647u));
                                                                            let _e1549 = select(_e1547, _e1544, (_e1544 > _e1547));
                                                                            let _e1552 = bitcast<f32>((bitcast<u32>(_e1424.z) & 2147483647u));
                                                                            let _e1558 = bitcast<f32>((bitcast<u32>(_e1422.x) & 2147483647u));
                                                                            let _e1561 = bitcast<f32>((bitcast<u32>(_e1422.y) & 2147483647u));
                                                                            let _e1563 = select(_e1561, _e1558, (_e1558 > _e1561));
                                                                            let _e1566 = bitcast<f32>((bitcast<u32>(_e1422.z) & 2147483647u));
                                                                            phi_1981_ = select(true, false, (bitcast<f32>((bitcast<u32>(_e1456) & 2147483647u)) > ((0.0000038146973f * select(_e1552, _e1549, (_e1549 > _e1552))) * select(_e1566, _e1563, (_e1563 > _e1566)))));
                                                                        } else {
                                                                            phi_1981_ = true;
                                                                        }
                                                                        let _e1573 = phi_1981_;
                                                                        if _e1573 {
                                                                            let _e1584 = ((((_e1433 * (_e1495 - (_e413 * _e1498))) + (_e1438 * (_e1496 - (_e449 * _e1498)))) + (_e1441 * (_e1497 - _e1497))) / _e1456);
                                                                            if (bitcast<f32>((bitcast<u32>(_e1584) & 2147483647u)) <= _e1399) {
                                                                                phi_2005_ = (_e1498 + _e1584);
                                                                            } else {
                                                                                phi_2005_ = _e1498;
                                                                            }
                                                                            let _e1591 = phi_2005_;
                                                                            phi_2006_ = _e1591;
                                                                        } else {
                                                                            phi_2006_ = (_e1467 / _e1456);
                                                                        }
                                                                        let _e1593 = phi_2006_;
                                                                        let _e1595 = select(_e1332, _e1593, (_e1593 < _e1332));
                                                                        let _e1597 = select(_e1324, _e1595, (_e1595 > _e1324));
                                                                        if (_e1597 >= _e534) {
                                                                            let _e1599 = (_e1597 <= _e1083.member_1);
                                                                            if _e1599 {
                                                                                let _e1600 = (1f / _e1251);
                                                                                phi_2029_ = type_26(_e1597, (_e1245 * _e1600), (_e1249 * _e1600), _e1112);
                                                                            } else {
                                                                                phi_2029_ = type_26();
                                                                            }
                                                                            let _e1605 = phi_2029_;
                                                                            phi_2031_ = _e1605;
                                                                            phi_2032_ = select(true, false, _e1599);
                                                                        } else {
                                                                            phi_2031_ = type_26();
                                                                            phi_2032_ = true;
                                                                        }
                                                                        let _e1608 = phi_2031_;
                                                                        let _e1610 = phi_2032_;
                                                                        if _e1610 {
                                                                            phi_2036_ = type_26(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                        } else {
                                                                            phi_2036_ = _e1608;
                                                                        }
                                                                        let _e1612 = phi_2036_;
                                                                        phi_2037_ = _e1612;
                                                                    }
                                                                    let _e1614 = phi_2037_;
                                                                    phi_2038_ = _e1614;
                                                                    phi_2039_ = _e1341;
                                                                }
                                                                let _e1616 = phi_2038_;
                                                                let _e1618 = phi_2039_;
                                                                phi_2043_ = _e1616;
                                                                phi_2044_ = _e1618;
                                                            }
                                                            let _e1620 = phi_2043_;
                                                            let _e1622 = phi_2044_;
                                                            phi_2045_ = _e1620;
                                                            phi_2046_ = _e1276;
                                                            phi_2047_ = _e1622;
                                                        }
                                                        let _e1624 = phi_2045_;
                                                        let _e1626 = phi_2046_;
                                                        let _e1628 = phi_2047_;
                                                        phi_2048_ = _e1624;
                                                        phi_2049_ = _e1626;
                                                        phi_2050_ = _e1628;
                                                    }
                                                    let _e1630 = phi_2048_;
                                                    let _e1632 = phi_2049_;
                                                    let _e1634 = phi_2050_;
                                                    phi_2058_ = _e1630;
                                                    phi_2059_ = select(_e1634, true, _e1632);
                                                } else {
                                                    phi_2058_ = type_26();
                                                    phi_2059_ = true;
                                                }
                                                let _e1637 = phi_2058_;
                                                let _e1639 = phi_2059_;
                                                if _e1639 {
                                                    phi_2063_ = type_26(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                } else {
                                                    phi_2063_ = _e1637;
                                                }
                                                let _e1641 = phi_2063_;
                                                if (_e1641.member_3 != 4294967295u) {
                                                    if (_e1112 == _e162) {
                                                        phi_2392_ = false;
                                                    } else {
                                                        let _e1645 = (_e1112 < arrayLength((&global_5.member)));
                                                        if _e1645 {
                                                            if _e1645 {
                                                            } else {
                                                                phi_3964_ = true;
                                                                break;
                                                            }
                                                            let _e1647 = global_5.member[_e1112];
                                                            phi_2086_ = _e1647;
                                                        } else {
                                                            phi_2086_ = 4294967295u;
                                                        }
                                                        let _e1649 = phi_2086_;
                                                        let _e1650 = (_e1649 < arrayLength((&global_6.member)));
                                                        if _e1650 {
                                                            if _e1650 {
                                                            } else {
                                                                phi_3964_ = true;
                                                                break;
                                                            }
                                                            let _e1652 = global_6.member[_e1649];
                                                            phi_2100_ = _e1652;
                                                        } else {
                                                            phi_2100_ = 0i;
                                                        }
                                                        let _e1654 = phi_2100_;
                                                        let _e1655 = (_e1654 == 0i);
                                                        if _e1655 {
                                                            phi_2391_ = true;
                                                        } else {
                                                            if _e380 {
                                                                phi_2121_ = vec3<f32>(_e1179[0][0], _e1179[0][1], _e1179[0][2]);
                                                            } else {
                                                                if (_e356 == 1u) {
                                                                    phi_2120_ = vec3<f32>(_e1179[0][2], _e1179[0][0], _e1179[0][1]);
                                                                } else {
                                                                    phi_2120_ = vec3<f32>(_e1179[0][1], _e1179[0][2], _e1179[0][0]);
                                                                }
                                                                let _e1660 = phi_2120_;
                                                                phi_2121_ = _e1660;
                                                            }
                                                            let _e1663 = phi_2121_;
                                                            if _e380 {
                                                                phi_2138_ = vec3<f32>(_e1179[1][0], _e1179[1][1], _e1179[1][2]);
                                                            } else {
                                                                if (_e356 == 1u) {
                                                                    phi_2137_ = vec3<f32>(_e1179[1][2], _e1179[1][0], _e1179[1][1]);
                                                                } else {
                                                                    phi_2137_ = vec3<f32>(_e1179[1][1], _e1179[1][2], _e1179[1][0]);
                                                                }
                                                                let _e1668 = phi_2137_;
                                                                phi_2138_ = _e1668;
                                                            }
                                                            let _e1671 = phi_2138_;
                                                            if _e380 {
                                                                phi_2155_ = vec3<f32>(_e1179[2][0], _e1179[2][1], _e1179[2][2]);
                                                            } else {
                                                                if (_e356 == 1u) {
                                                                    phi_2154_ = vec3<f32>(_e1179[2][2], _e1179[2][0], _e1179[2][1]);
                                                                } else {
                                                                    phi_2154_ = vec3<f32>(_e1179[2][1], _e1179[2][2], _e1179[2][0]);
                                                                }
                                                                let _e1676 = phi_2154_;
                                                                phi_2155_ = _e1676;
                                                            }
                                                            let _e1679 = phi_2155_;
                                                            let _e1682 = (_e1671.x - _e1663.x);
                                                            let _e1685 = (_e1671.y - _e1663.y);
                                                            let _e1688 = (_e1671.z - _e1663.z);
                                                            let _e1690 = (_e1679.x - _e1663.x);
                                                            let _e1692 = (_e1679.y - _e1663.y);
                                                            let _e1694 = (_e1679.z - _e1663.z);
                                                            if (_e234.member_1 == 1u) {
                                                                phi_2191_ = (vec3<f32>(_e234.member[0], _e234.member[1], _e234.member[2]) - _e1663);
                                                            } else {
                                                                phi_2191_ = vec3<f32>(_e234.member[0], _e234.member[1], _e234.member[2]);
                                                            }
                                                            let _e1709 = phi_2191_;
                                                            let _e1715 = bitcast<f32>((bitcast<u32>((_e1682 * _e1692)) ^ _e234.member_3[0]));
                                                            let _e1719 = bitcast<f32>((bitcast<u32>((_e1685 * _e1690)) ^ _e234.member_3[0]));
                                                            let _e1723 = bitcast<f32>((bitcast<u32>((_e1685 * _e1694)) ^ _e234.member_3[0]));
                                                            let _e1727 = bitcast<f32>((bitcast<u32>((_e1688 * _e1692)) ^ _e234.member_3[0]));
                                                            let _e1731 = bitcast<f32>((bitcast<u32>((_e1688 * _e1690)) ^ _e234.member_3[0]));
                                                            let _e1735 = bitcast<f32>((bitcast<u32>((_e1682 * _e1694)) ^ _e234.member_3[0]));
                                                            let _e1736 = (_e1723 - _e1727);
                                                            let _e1737 = (_e1731 - _e1735);
                                                            let _e1738 = (_e1715 - _e1719);
                                                            let _e1762 = (bitcast<f32>((bitcast<u32>(_e1723) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1727) & 2147483647u)));
                                                            let _e1769 = (bitcast<f32>((bitcast<u32>(_e1731) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1735) & 2147483647u)));
                                                            let _e1776 = (bitcast<f32>((bitcast<u32>(_e1715) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1719) & 2147483647u)));
                                                            if (_e234.member_2 == 0f) {
                                                                phi_2373_ = 0f;
                                                            } else {
                                                                let _e1806 = bitcast<f32>((bitcast<u32>(_e1736) & 2147483647u));
                                                                let _e1809 = bitcast<f32>((bitcast<u32>(_e1737) & 2147483647u));
                                                                let _e1812 = bitcast<f32>((bitcast<u32>(_e1738) & 2147483647u));
                                                                let _e1814 = select(_e1812, _e1809, (_e1809 > _e1812));
                                                                let _e1818 = select(_e1812, _e1809, (_e1809 < _e1812));
                                                                let _e1822 = select(_e1809, _e1806, (_e1806 < _e1809));
                                                                let _e1824 = select(_e1809, _e1806, (_e1806 > _e1809));
                                                                let _e1826 = select(_e1812, _e1824, (_e1824 < _e1812));
                                                                phi_2373_ = bitcast<f32>((bitcast<u32>((_e234.member_2 * bitcast<f32>((bitcast<u32>(((((select(_e1814, _e1806, (_e1806 > _e1814)) + bitcast<f32>((bitcast<u32>((0.414214f * select(_e1826, _e1822, (_e1822 > _e1826)))) ^ _e234.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.317838f * select(_e1818, _e1806, (_e1806 < _e1818)))) ^ _e234.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.0000004768374f * ((_e1762 + _e1769) + _e1776))) ^ _e234.member_3[0]))) * 1.0000005f)) ^ _e234.member_3[0])))) ^ _e234.member_3[0]));
                                                            }
                                                            let _e1853 = phi_2373_;
                                                            phi_2391_ = (_e1655 || !(((((bitcast<f32>((bitcast<u32>((_e1709.x * _e1736)) ^ _e234.member_3[0])) + bitcast<f32>((bitcast<u32>((_e1709.y * _e1737)) ^ _e234.member_3[0]))) + bitcast<f32>((bitcast<u32>((_e1709.z * _e1738)) ^ _e234.member_3[0]))) * f32(-(_e1654))) > ((bitcast<f32>((bitcast<u32>((0.0000009536752f * ((bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1709.x) & 2147483647u)) * _e1762)) ^ _e234.member_3[0])) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1709.y) & 2147483647u)) * _e1769)) ^ _e234.member_3[0]))) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1709.z) & 2147483647u)) * _e1776)) ^ _e234.member_3[0]))))) ^ _e234.member_3[0])) + _e1853) + 0.0000000000000000000000000000000000001880791f))));
                                                        }
                                                        let _e1867 = phi_2391_;
                                                        phi_2392_ = _e1867;
                                                    }
                                                    let _e1869 = phi_2392_;
                                                    if _e1869 {
                                                        if (_e1641.member < _e1083.member.member) {
                                                            phi_2412_ = true;
                                                        } else {
                                                            if (_e1641.member == _e1083.member.member) {
                                                                phi_2411_ = (_e1641.member_3 < _e1083.member.member_3);
                                                            } else {
                                                                phi_2411_ = false;
                                                            }
                                                            let _e1879 = phi_2411_;
                                                            phi_2412_ = _e1879;
                                                        }
                                                        let _e1881 = phi_2412_;
                                                        if _e1881 {
                                                            phi_2418_ = type_43(_e1641, _e1641.member);
                                                        } else {
                                                            phi_2418_ = _e1083;
                                                        }
                                                        let _e1884 = phi_2418_;
                                                        phi_2419_ = _e1884;
                                                    } else {
                                                        phi_2419_ = _e1083;
                                                    }
                                                    let _e1886 = phi_2419_;
                                                    phi_2420_ = _e1886;
                                                } else {
                                                    phi_2420_ = _e1083;
                                                }
                                                let _e1888 = phi_2420_;
                                                phi_1085_ = _e1888;
                                            } else {
                                                phi_1085_ = type_43();
                                            }
                                            let _e1890 = phi_1085_;
                                            continue;
                                            continuing {
                                                phi_1084_ = _e1890;
                                                phi_1087_ = _e1098;
                                                phi_3964_ = _e576;
                                                break if !(_e1104);
                                            }
                                        }
                                        let _e1893 = phi_3964_;
                                        phi_4130_ = _e1893;
                                        if _e1893 {
                                            break;
                                        }
                                        phi_4134_ = _e1893;
                                        let _e2125 = local_11;
                                        phi_3625_ = _e2125;
                                        phi_3626_ = _e617;
                                        phi_3627_ = false;
                                        phi_3628_ = _e621;
                                    } else {
                                        if (_e617.member_1 >= _e95) {
                                            phi_3181_ = type_63(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), type_62(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u), type_62(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u));
                                        } else {
                                            if (_e617.member_1 < _e95) {
                                            } else {
                                                phi_4130_ = true;
                                                break;
                                            }
                                            let _e632 = (_e356 * 2u);
                                            let _e634 = ((1u + _e632) % 7u);
                                            if (_e634 < 7u) {
                                            } else {
                                                phi_4130_ = true;
                                                break;
                                            }
                                            let _e639 = global_10.member[_e617.member_1][_e634];
                                            let _e641 = ((_e632 + 2u) % 7u);
                                            if (_e641 < 7u) {
                                            } else {
                                                phi_4130_ = true;
                                                break;
                                            }
                                            let _e646 = global_10.member[_e617.member_1][_e641];
                                            let _e647 = (_e355 * 2u);
                                            let _e649 = ((1u + _e647) % 7u);
                                            if (_e649 < 7u) {
                                            } else {
                                                phi_4130_ = true;
                                                break;
                                            }
                                            let _e654 = global_10.member[_e617.member_1][_e649];
                                            let _e656 = ((_e647 + 2u) % 7u);
                                            if (_e656 < 7u) {
                                            } else {
                                                phi_4130_ = true;
                                                break;
                                            }
                                            let _e661 = global_10.member[_e617.member_1][_e656];
                                            let _e662 = (_e357 * 2u);
                                            let _e664 = ((1u + _e662) % 7u);
                                            if (_e664 < 7u) {
                                            } else {
                                                phi_4130_ = true;
                                                break;
                                            }
                                            let _e669 = global_10.member[_e617.member_1][_e664];
                                            let _e671 = ((_e662 + 2u) % 7u);
                                            if (_e671 < 7u) {
                                            } else {
                                                phi_4130_ = true;
                                                break;
                                            }
                                            let _e676 = global_10.member[_e617.member_1][_e671];
                                            let _e699 = (bitcast<f32>((bitcast<u32>((_e617.member.member_1.x - _e617.member.member.x)) & 2139095040u)) * 0.0000009536743f);
                                            let _e700 = (bitcast<f32>((bitcast<u32>((_e617.member.member_1.y - _e617.member.member.y)) & 2139095040u)) * 0.0000009536743f);
                                            let _e701 = (bitcast<f32>((bitcast<u32>((_e617.member.member_1.z - _e617.member.member.z)) & 2139095040u)) * 0.0000009536743f);
                                            let _e703 = select(_e153, _e699, (_e699 > _e153));
                                            let _e705 = select(_e153, _e700, (_e700 > _e153));
                                            let _e707 = select(_e153, _e701, (_e701 > _e153));
                                            let _e732 = bitcast<u32>((f32(bitcast<i32>((_e639 & 2097151u))) * _e703));
                                            let _e737 = (bitcast<i32>((_e639 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e740 = bitcast<f32>((_e732 & bitcast<u32>(_e737)));
                                            let _e741 = bitcast<u32>((f32(bitcast<i32>((_e654 & 2097151u))) * _e705));
                                            let _e746 = (bitcast<i32>((_e654 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e749 = bitcast<f32>((_e741 & bitcast<u32>(_e746)));
                                            let _e750 = bitcast<u32>((f32(bitcast<i32>((_e669 & 2097151u))) * _e707));
                                            let _e755 = (bitcast<i32>((_e669 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e758 = bitcast<f32>((_e750 & bitcast<u32>(_e755)));
                                            let _e762 = bitcast<f32>((_e732 & bitcast<u32>(~(_e737))));
                                            let _e766 = bitcast<f32>((_e741 & bitcast<u32>(~(_e746))));
                                            let _e770 = bitcast<f32>((_e750 & bitcast<u32>(~(_e755))));
                                            let _e771 = bitcast<u32>((f32(bitcast<i32>((_e646 & 2097151u))) * _e703));
                                            let _e776 = (bitcast<i32>((_e646 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e779 = bitcast<f32>((_e771 & bitcast<u32>(_e776)));
                                            let _e780 = bitcast<u32>((f32(bitcast<i32>((_e661 & 2097151u))) * _e705));
                                            let _e785 = (bitcast<i32>((_e661 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e788 = bitcast<f32>((_e780 & bitcast<u32>(_e785)));
                                            let _e789 = bitcast<u32>((f32(bitcast<i32>((_e676 & 2097151u))) * _e707));
                                            let _e794 = (bitcast<i32>((_e676 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e797 = bitcast<f32>((_e789 & bitcast<u32>(_e794)));
                                            let _e801 = bitcast<f32>((_e771 & bitcast<u32>(~(_e776))));
                                            let _e805 = bitcast<f32>((_e780 & bitcast<u32>(~(_e785))));
                                            let _e809 = bitcast<f32>((_e789 & bitcast<u32>(~(_e794))));
                                            let _e839 = global_10.member[_e617.member_1][0u];
                                            let _e843 = global_10.member[_e617.member_1][2u];
                                            let _e847 = global_10.member[_e617.member_1][4u];
                                            let _e851 = global_10.member[_e617.member_1][6u];
                                            let _e863 = (((_e843 >> bitcast<u32>(22i)) | ((_e847 >> bitcast<u32>(22i)) << bitcast<u32>(10i))) | ((_e851 >> bitcast<u32>(22i)) << bitcast<u32>(20i)));
                                            let _e864 = (_e839 & 268435455u);
                                            let _e865 = (_e863 & 268435455u);
                                            let _e868 = ((_e839 >> bitcast<u32>(28u)) & 7u);
                                            let _e876 = ((_e839 >> bitcast<u32>(31i)) | (((_e863 >> bitcast<u32>(28u)) & 3u) << bitcast<u32>(1i)));
                                            let _e877 = (_e868 != 0u);
                                            if (_e868 == 0u) {
                                                phi_3143_ = _e864;
                                            } else {
                                                if (_e868 == 7u) {
                                                    phi_3142_ = 2147483648u;
                                                } else {
                                                    phi_3142_ = ((2147483648u | (_e868 << bitcast<u32>(28u))) | (_e865 & 268435455u));
                                                }
                                                let _e886 = phi_3142_;
                                                phi_3143_ = _e886;
                                            }
                                            let _e888 = phi_3143_;
                                            if _e877 {
                                                let _e889 = (_e868 != 7u);
                                                if _e889 {
                                                    phi_3153_ = (_e865 + _e868);
                                                } else {
                                                    phi_3153_ = u32();
                                                }
                                                let _e892 = phi_3153_;
                                                phi_3155_ = _e892;
                                                phi_3156_ = select(true, false, _e889);
                                            } else {
                                                phi_3155_ = u32();
                                                phi_3156_ = true;
                                            }
                                            let _e895 = phi_3155_;
                                            let _e897 = phi_3156_;
                                            if (_e876 == 0u) {
                                                phi_3177_ = (_e864 + select(0u, 1u, !(_e877)));
                                            } else {
                                                if (_e876 == 7u) {
                                                    phi_3176_ = 2147483648u;
                                                } else {
                                                    phi_3176_ = ((2147483648u | (_e876 << bitcast<u32>(28u))) | (select(_e895, _e865, _e897) & 268435455u));
                                                }
                                                let _e910 = phi_3176_;
                                                phi_3177_ = _e910;
                                            }
                                            let _e912 = phi_3177_;
                                            phi_3181_ = type_63(array<vec4<f32>, 3>(vec4<f32>((_e617.member.member.x + _e740), (_e617.member.member.x + _e762), (_e617.member.member_1.x - _e779), (_e617.member.member_1.x - _e801)), vec4<f32>((_e617.member.member.y + _e749), (_e617.member.member.y + _e766), (_e617.member.member_1.y - _e788), (_e617.member.member_1.y - _e805)), vec4<f32>((_e617.member.member.z + _e758), (_e617.member.member.z + _e770), (_e617.member.member_1.z - _e797), (_e617.member.member_1.z - _e809))), type_62(type_38((_e617.member.member + vec4<f32>(_e740, _e749, _e758, 0f)), (_e617.member.member_1 - vec4<f32>(_e779, _e788, _e797, 0f))), _e888), type_62(type_38((_e617.member.member + vec4<f32>(_e762, _e766, _e770, 0f)), (_e617.member.member_1 - vec4<f32>(_e801, _e805, _e809, 0f))), _e912));
                                        }
                                        let _e917 = phi_3181_;
                                        let _e929 = ((_e917.member[0].x - _e411) * _e416);
                                        let _e930 = ((_e917.member[0].y - _e411) * _e416);
                                        let _e931 = ((_e917.member[0].z - _e412) * _e416);
                                        let _e932 = ((_e917.member[0].w - _e412) * _e416);
                                        let _e942 = ((_e917.member[1].x - _e447) * _e452);
                                        let _e943 = ((_e917.member[1].y - _e447) * _e452);
                                        let _e944 = ((_e917.member[1].z - _e448) * _e452);
                                        let _e945 = ((_e917.member[1].w - _e448) * _e452);
                                        let _e955 = ((_e917.member[2].x - _e483) * _e488);
                                        let _e956 = ((_e917.member[2].y - _e483) * _e488);
                                        let _e957 = ((_e917.member[2].z - _e484) * _e488);
                                        let _e958 = ((_e917.member[2].w - _e484) * _e488);
                                        let _e960 = select(_e957, _e955, (_e955 < _e957));
                                        let _e962 = select(_e958, _e956, (_e956 < _e958));
                                        let _e964 = select(_e957, _e955, (_e955 > _e957));
                                        let _e966 = select(_e958, _e956, (_e956 > _e958));
                                        let _e968 = select(_e931, _e929, (_e929 < _e931));
                                        let _e970 = select(_e932, _e930, (_e930 < _e932));
                                        let _e972 = select(_e944, _e942, (_e942 < _e944));
                                        let _e974 = select(_e945, _e943, (_e943 < _e945));
                                        let _e976 = select(_e972, _e968, (_e968 > _e972));
                                        let _e978 = select(_e974, _e970, (_e970 > _e974));
                                        let _e980 = select(_e960, _e976, (_e976 > _e960));
                                        let _e982 = select(_e962, _e978, (_e978 > _e962));
                                        let _e984 = select(_e931, _e929, (_e929 > _e931));
                                        let _e986 = select(_e932, _e930, (_e930 > _e932));
                                        let _e988 = select(_e944, _e942, (_e942 > _e944));
                                        let _e990 = select(_e945, _e943, (_e943 > _e945));
                                        let _e992 = select(_e988, _e984, (_e984 < _e988));
                                        let _e994 = select(_e990, _e986, (_e986 < _e990));
                                        let _e999 = -(_e960);
                                        let _e1000 = -(_e962);
                                        let _e1007 = (select(_e964, _e992, (_e992 < _e964)) + (select(_e999, _e964, (_e964 > _e999)) * 0.0000019073523f));
                                        let _e1008 = (select(_e966, _e994, (_e994 < _e966)) + (select(_e1000, _e966, (_e966 > _e1000)) * 0.0000019073523f));
                                        let _e1010 = select(_e534, _e980, (_e980 > _e534));
                                        let _e1012 = select(_e534, _e982, (_e982 > _e534));
                                        let _e1017 = (_e1010 <= select(_e578.member_1, _e1007, (_e1007 < _e578.member_1)));
                                        let _e1018 = (_e1012 <= select(_e578.member_1, _e1008, (_e1008 < _e578.member_1)));
                                        let _e1019 = (_e1010 <= _e1012);
                                        if _e1017 {
                                            if _e1018 {
                                                if _e1019 {
                                                    phi_3525_ = _e917.member_2;
                                                } else {
                                                    phi_3525_ = _e917.member_1;
                                                }
                                                let _e1023 = phi_3525_;
                                                let _e1045 = (_e621 % 128u);
                                                let _e1046 = (_e1045 < 128u);
                                                if _e1046 {
                                                } else {
                                                    phi_4130_ = true;
                                                    break;
                                                }
                                                local_8[_e1045] = _e1023.member_1;
                                                if _e1046 {
                                                } else {
                                                    phi_4130_ = true;
                                                    break;
                                                }
                                                local_7[_e1045] = _e1023.member.member.x;
                                                if _e1046 {
                                                } else {
                                                    phi_4130_ = true;
                                                    break;
                                                }
                                                local_6[_e1045] = _e1023.member.member.y;
                                                if _e1046 {
                                                } else {
                                                    phi_4130_ = true;
                                                    break;
                                                }
                                                local_5[_e1045] = _e1023.member.member.z;
                                                if _e1046 {
                                                } else {
                                                    phi_4130_ = true;
                                                    break;
                                                }
                                                local_4[_e1045] = _e1023.member.member_1.x;
                                                if _e1046 {
                                                } else {
                                                    phi_4130_ = true;
                                                    break;
                                                }
                                                local_3[_e1045] = _e1023.member.member_1.y;
                                                if _e1046 {
                                                } else {
                                                    phi_4130_ = true;
                                                    break;
                                                }
                                                local_2[_e1045] = _e1023.member.member_1.z;
                                                if _e1046 {
                                                } else {
                                                    phi_4130_ = true;
                                                    break;
                                                }
                                                local_9[_e1045] = select(_e1012, _e1010, (_e1010 > _e1012));
                                                if _e1019 {
                                                    phi_3602_ = _e917.member_1;
                                                } else {
                                                    phi_3602_ = _e917.member_2;
                                                }
                                                let _e1059 = phi_3602_;
                                                phi_3603_ = _e1059;
                                                phi_3604_ = (_e621 + 1u);
                                            } else {
                                                phi_3603_ = type_62();
                                                phi_3604_ = u32();
                                            }
                                            let _e1061 = phi_3603_;
                                            let _e1063 = phi_3604_;
                                            phi_3606_ = _e1061;
                                            phi_3607_ = _e1063;
                                            phi_3608_ = select(true, false, _e1018);
                                        } else {
                                            phi_3606_ = type_62();
                                            phi_3607_ = u32();
                                            phi_3608_ = true;
                                        }
                                        let _e1066 = phi_3606_;
                                        let _e1068 = phi_3607_;
                                        let _e1070 = phi_3608_;
                                        if _e1070 {
                                            if _e1017 {
                                                phi_3617_ = _e917.member_1;
                                            } else {
                                                phi_3617_ = _e917.member_2;
                                            }
                                            let _e1074 = phi_3617_;
                                            phi_3622_ = _e1074;
                                            phi_3623_ = select(_e1018, true, _e1017);
                                        } else {
                                            phi_3622_ = _e1066;
                                            phi_3623_ = _e619;
                                        }
                                        let _e1077 = phi_3622_;
                                        let _e1079 = phi_3623_;
                                        phi_4134_ = _e576;
                                        phi_3625_ = _e578;
                                        phi_3626_ = _e1077;
                                        phi_3627_ = _e1079;
                                        phi_3628_ = select(_e1068, _e621, _e1070);
                                    }
                                    let _e1895 = phi_4134_;
                                    let _e1897 = phi_3625_;
                                    let _e1899 = phi_3626_;
                                    let _e1901 = phi_3627_;
                                    let _e1903 = phi_3628_;
                                    phi_4133_ = _e1895;
                                    phi_3629_ = _e1897;
                                    phi_3630_ = _e1899;
                                    phi_3631_ = (_e582 - 1u);
                                    phi_3632_ = _e1901;
                                    phi_3633_ = _e1903;
                                } else {
                                    phi_4133_ = _e576;
                                    phi_3629_ = _e578;
                                    phi_3630_ = _e617;
                                    phi_3631_ = _e582;
                                    phi_3632_ = _e619;
                                    phi_3633_ = _e621;
                                }
                                let _e1905 = phi_4133_;
                                let _e1907 = phi_3629_;
                                let _e1909 = phi_3630_;
                                let _e1911 = phi_3631_;
                                let _e1913 = phi_3632_;
                                let _e1915 = phi_3633_;
                                phi_4132_ = _e1905;
                                phi_3634_ = _e1907;
                                phi_3635_ = _e1909;
                                phi_3636_ = _e1911;
                                phi_3637_ = _e1913;
                                phi_3638_ = _e1915;
                            } else {
                                phi_4132_ = _e576;
                                phi_3634_ = type_43();
                                phi_3635_ = type_62();
                                phi_3636_ = u32();
                                phi_3637_ = bool();
                                phi_3638_ = u32();
                            }
                            let _e1917 = phi_4132_;
                            let _e1919 = phi_3634_;
                            let _e1921 = phi_3635_;
                            let _e1923 = phi_3636_;
                            let _e1925 = phi_3637_;
                            let _e1927 = phi_3638_;
                            phi_4131_ = _e1917;
                            phi_959_ = _e1919;
                            phi_962_ = _e1921;
                            phi_964_ = _e1923;
                            phi_966_ = _e1925;
                            phi_968_ = _e1927;
                            phi_3639_ = _e590;
                        } else {
                            phi_4131_ = _e576;
                            phi_959_ = type_43();
                            phi_962_ = type_62();
                            phi_964_ = u32();
                            phi_966_ = bool();
                            phi_968_ = u32();
                            phi_3639_ = false;
                        }
                        let _e1929 = phi_4131_;
                        let _e1931 = phi_959_;
                        let _e1933 = phi_962_;
                        let _e1935 = phi_964_;
                        let _e1937 = phi_966_;
                        let _e1939 = phi_968_;
                        let _e1941 = phi_3639_;
                        continue;
                        continuing {
                            phi_3970_ = _e1929;
                            phi_958_ = _e1931;
                            phi_961_ = _e1933;
                            phi_963_ = _e1935;
                            phi_965_ = _e1937;
                            phi_967_ = _e1939;
                            phi_4130_ = _e1929;
                            break if !(_e1941);
                        }
                    }
                    let _e1944 = phi_4130_;
                    if _e1944 {
                        break;
                    }
                    let _e1946 = local_10;
                    if (_e1946.member.member_3 != 4294967295u) {
                        let _e1951 = (_e358 / 3i);
                        let _e1958 = bitcast<f32>((bitcast<u32>((_e1951 + 127i)) << bitcast<u32>(23i)));
                        let _e1966 = (((_e1946.member.member * _e1958) * _e1958) * bitcast<f32>((bitcast<u32>(((_e358 - (2i * _e1951)) + 127i)) << bitcast<u32>(23i))));
                        let _e1968 = select(340282350000000000000000000000000000000f, _e1966, (_e1966 < 340282350000000000000000000000000000000f));
                        phi_3691_ = type_26(select(-340282350000000000000000000000000000000f, _e1968, (_e1968 > -340282350000000000000000000000000000000f)), _e1946.member.member_1, _e1946.member.member_2, _e1946.member.member_3);
                    } else {
                        phi_3691_ = type_26(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                    }
                    let _e1975 = phi_3691_;
                    if _e235 {
                    } else {
                        break;
                    }
                    global_8.member[_e141] = _e1975;
                    if _e156 {
                    } else {
                        break;
                    }
                    let _e1979 = select(0u, 1u, (_e302 <= _e312));
                    if (_e1979 > 0u) {
                        let _e1981 = (1u < _e109);
                        if _e1981 {
                            if (0u < _e109) {
                            } else {
                                break;
                            }
                            let _e1985 = atomicAdd((&global_9.member[0u]), _e1979);
                            if ((_e1985 + _e1979) < _e1985) {
                                if _e1981 {
                                } else {
                                    break;
                                }
                                let _e1990 = atomicAdd((&global_9.member[1u]), 1u);
                            }
                        }
                    }
                    let _e1993 = select(0u, 1u, (_e1975.member_3 != 4294967295u));
                    if (_e1993 > 0u) {
                        let _e1995 = (3u < _e109);
                        if _e1995 {
                            if (2u < _e109) {
                            } else {
                                break;
                            }
                            let _e1999 = atomicAdd((&global_9.member[2u]), _e1993);
                            if ((_e1999 + _e1993) < _e1999) {
                                if _e1995 {
                                } else {
                                    break;
                                }
                                let _e2004 = atomicAdd((&global_9.member[3u]), 1u);
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
