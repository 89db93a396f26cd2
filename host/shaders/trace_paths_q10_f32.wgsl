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

struct type_22 {
    member: array<f32, 9>,
    member_1: u32,
}

struct type_24 {
    member: array<type_22>,
}

struct type_30 {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: u32,
}

struct type_32 {
    member: array<type_30>,
}

struct type_34 {
    member: array<f32, 3>,
    member_1: f32,
    member_2: array<f32, 3>,
    member_3: f32,
}

struct type_35 {
    member: type_34,
    member_1: array<f32, 3>,
    member_2: u32,
    member_3: array<f32, 3>,
    member_4: u32,
}

struct type_37 {
    member: array<type_35>,
}

struct type_42 {
    member: vec4<f32>,
    member_1: vec4<f32>,
}

struct type_44 {
    member: array<f32, 3>,
    member_1: u32,
    member_2: f32,
    member_3: array<u32, 3>,
}

struct type_47 {
    member: type_30,
    member_1: f32,
}

struct type_52 {
    member: array<vec4<u32>, 2>,
}

struct type_55 {
    member: array<i32>,
}

struct type_62 {
    member: type_42,
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
var<uniform> global_1: type_16;
@group(0) @binding(1) 
var<uniform> global_2: type_52;
@group(0) @binding(2) 
var<uniform> global_3: type_52;
@group(0) @binding(3) 
var<storage> global_4: type_13;
@group(0) @binding(4) 
var<storage> global_5: type_24;
@group(0) @binding(5) 
var<storage> global_6: type_4;
@group(0) @binding(6) 
var<storage> global_7: type_55;
@group(0) @binding(7) 
var<storage> global_8: type_37;
@group(0) @binding(8) 
var<storage, read_write> global_9: type_32;
@group(0) @binding(9) 
var<storage, read_write> global_10: type_68;

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
    var phi_394_: type_44;
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
    var phi_958_: type_47;
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
    var phi_1084_: type_47;
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
    var phi_2029_: type_30;
    var phi_2031_: type_30;
    var phi_2032_: bool;
    var phi_2036_: type_30;
    var phi_2037_: type_30;
    var phi_2038_: type_30;
    var phi_2039_: bool;
    var phi_2043_: type_30;
    var phi_2044_: bool;
    var phi_2045_: type_30;
    var phi_2046_: bool;
    var phi_2047_: bool;
    var phi_2048_: type_30;
    var phi_2049_: bool;
    var phi_2050_: bool;
    var phi_2058_: type_30;
    var phi_2059_: bool;
    var phi_2063_: type_30;
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
    var phi_2418_: type_47;
    var phi_2419_: type_47;
    var phi_2420_: type_47;
    var phi_1085_: type_47;
    var phi_3964_: bool;
    var phi_4134_: bool;
    var phi_3625_: type_47;
    var phi_3626_: type_62;
    var phi_3627_: bool;
    var phi_3628_: u32;
    var phi_4133_: bool;
    var phi_3629_: type_47;
    var phi_3630_: type_62;
    var phi_3631_: u32;
    var phi_3632_: bool;
    var phi_3633_: u32;
    var phi_4132_: bool;
    var phi_3634_: type_47;
    var phi_3635_: type_62;
    var phi_3636_: u32;
    var phi_3637_: bool;
    var phi_3638_: u32;
    var phi_4131_: bool;
    var phi_959_: type_47;
    var phi_962_: type_62;
    var phi_964_: u32;
    var phi_966_: bool;
    var phi_968_: u32;
    var phi_3639_: bool;
    var phi_4130_: bool;
    var local_10: type_47;
    var phi_3691_: type_30;
    var local_11: type_47;

    switch bitcast<i32>(0u) {
        default: {
            let _e95 = global;
            let _e97 = arrayLength((&global_4.member));
            let _e99 = arrayLength((&global_5.member));
            let _e111 = arrayLength((&global_10.member));
            let _e115 = global_3.member[0u][0u];
            let _e119 = global_3.member[0u][1u];
            let _e123 = global_3.member[0u][2u];
            let _e127 = global_3.member[0u][3u];
            let _e131 = global_3.member[1u][0u];
            let _e135 = global_3.member[1u][1u];
            let _e139 = global_3.member[1u][2u];
            let _e143 = (_e95.x + (_e95.y * 2097152u));
            let _e155 = bitcast<f32>((bitcast<u32>((bitcast<i32>(_e127) + 127i)) << bitcast<u32>(23i)));
            local_1 = array<i32, 3>(bitcast<i32>(_e115), bitcast<i32>(_e119), bitcast<i32>(_e123));
            local = array<i32, 3>(bitcast<i32>(_e131), bitcast<i32>(_e135), bitcast<i32>(_e139));
            let _e158 = (_e143 < arrayLength((&global_8.member)));
            if _e158 {
                if _e158 {
                } else {
                    break;
                }
                let _e162 = global_8.member[_e143].member_2;
                phi_326_ = _e162;
            } else {
                phi_326_ = 4294967295u;
            }
            let _e164 = phi_326_;
            let _e167 = global_1.member[0u];
            let _e171 = global_2.member[0u][0u];
            let _e175 = global_2.member[0u][1u];
            let _e179 = global_2.member[0u][2u];
            let _e183 = global_2.member[0u][3u];
            let _e187 = global_2.member[1u][0u];
            let _e191 = global_2.member[1u][1u];
            let _e195 = global_2.member[1u][2u];
            let _e199 = global_2.member[1u][3u];
            let _e200 = bitcast<f32>(_e171);
            let _e201 = bitcast<f32>(_e175);
            let _e202 = bitcast<f32>(_e179);
            let _e204 = bitcast<f32>(_e187);
            let _e205 = array<u32, 3>(_e191, _e195, _e199);
            let _e207 = bitcast<i32>(_e167);
            if (_e207 < -126i) {
                phi_370_ = -126i;
            } else {
                phi_370_ = select(_e207, 127i, (_e207 > 127i));
            }
            let _e212 = phi_370_;
            let _e217 = bitcast<f32>((bitcast<u32>((_e212 + 127i)) << bitcast<u32>(23i)));
            let _e223 = bitcast<f32>((bitcast<u32>(((_e207 - _e212) + 127i)) << bitcast<u32>(23i)));
            if (_e183 == 0u) {
                phi_394_ = type_44(array<f32, 3>(_e200, _e201, _e202), _e183, _e204, _e205);
            } else {
                phi_394_ = type_44(array<f32, 3>(((_e200 * _e217) * _e223), ((_e201 * _e217) * _e223), ((_e202 * _e217) * _e223)), _e183, ((_e204 * _e217) * _e223), _e205);
            }
            let _e236 = phi_394_;
            if _e158 {
                let _e237 = (_e143 < arrayLength((&global_9.member)));
                if _e237 {
                    if _e158 {
                    } else {
                        break;
                    }
                    let _e247 = global_8.member[_e143].member.member_2[0u];
                    let _e249 = (bitcast<u32>(_e247) & 2147483647u);
                    let _e255 = global_8.member[_e143].member.member_2[1u];
                    let _e257 = (bitcast<u32>(_e255) & 2147483647u);
                    let _e263 = global_8.member[_e143].member.member_2[2u];
                    let _e265 = (bitcast<u32>(_e263) & 2147483647u);
                    let _e271 = global_8.member[_e143].member.member[0u];
                    let _e273 = (bitcast<u32>(_e271) & 2147483647u);
                    let _e279 = global_8.member[_e143].member.member[1u];
                    let _e281 = (bitcast<u32>(_e279) & 2147483647u);
                    let _e287 = global_8.member[_e143].member.member[2u];
                    let _e289 = (bitcast<u32>(_e287) & 2147483647u);
                    let _e291 = select(_e257, _e249, (_e257 < _e249));
                    let _e293 = select(_e265, _e291, (_e265 < _e291));
                    let _e295 = select(_e273, _e293, (_e273 < _e293));
                    let _e297 = select(_e281, _e295, (_e281 < _e295));
                    let _e299 = select(_e289, _e297, (_e289 < _e297));
                    let _e304 = global_8.member[_e143].member.member_1;
                    let _e306 = (bitcast<u32>(_e304) & 2147483647u);
                    let _e314 = global_8.member[_e143].member.member_3;
                    let _e320 = (((select(_e306, _e299, (_e306 < _e299)) < 2139095040u) && ((bitcast<u32>(_e314) & 2147483647u) <= 2139095040u)) && (_e293 > 0u));
                    if _e320 {
                        let _e323 = (bitcast<u32>(bitcast<f32>(_e293)) & 2147483647u);
                        if (_e323 >= 8388608u) {
                            phi_500_ = (bitcast<i32>((_e323 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_500_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e323)), 32u, (_e323 == 0u))));
                        }
                        let _e337 = phi_500_;
                        phi_501_ = _e337;
                    } else {
                        phi_501_ = 0i;
                    }
                    let _e339 = phi_501_;
                    let _e340 = (_e249 == _e293);
                    if _e340 {
                        phi_511_ = true;
                    } else {
                        phi_511_ = (_e257 == _e293);
                    }
                    let _e343 = phi_511_;
                    let _e344 = select(1u, 0u, _e340);
                    if _e343 {
                        let _e345 = (_e344 + 1u);
                        phi_521_ = _e345;
                        phi_522_ = _e345;
                        phi_524_ = select(true, false, (_e345 == 2u));
                    } else {
                        phi_521_ = u32();
                        phi_522_ = 0u;
                        phi_524_ = true;
                    }
                    let _e349 = phi_521_;
                    let _e351 = phi_522_;
                    let _e353 = phi_524_;
                    if _e353 {
                        phi_529_ = (_e351 + 1u);
                    } else {
                        phi_529_ = 0u;
                    }
                    let _e357 = phi_529_;
                    let _e358 = select(_e349, _e351, _e353);
                    let _e359 = select(_e344, select(2u, _e344, _e343), _e353);
                    let _e360 = -(_e339);
                    if (_e360 < -126i) {
                        phi_561_ = -126i;
                    } else {
                        phi_561_ = select(_e360, 127i, (_e360 > 127i));
                    }
                    let _e365 = phi_561_;
                    let _e370 = bitcast<f32>((bitcast<u32>((_e365 + 127i)) << bitcast<u32>(23i)));
                    let _e376 = bitcast<f32>((bitcast<u32>(((_e360 - _e365) + 127i)) << bitcast<u32>(23i)));
                    let _e381 = global_8.member[_e143].member.member;
                    let _e382 = (_e358 == 0u);
                    if _e382 {
                        phi_579_ = _e381[0];
                    } else {
                        phi_579_ = _e381[1];
                    }
                    let _e386 = phi_579_;
                    let _e387 = (_e358 == 2u);
                    if _e387 {
                        phi_585_ = _e381[2];
                    } else {
                        phi_585_ = _e386;
                    }
                    let _e390 = phi_585_;
                    let _e391 = global_8.member[_e143].member.member_2;
                    if _e382 {
                        phi_596_ = _e391[0];
                    } else {
                        phi_596_ = _e391[1];
                    }
                    let _e395 = phi_596_;
                    if _e387 {
                        phi_602_ = _e391[2];
                    } else {
                        phi_602_ = _e395;
                    }
                    let _e398 = phi_602_;
                    let _e400 = ((_e398 * _e370) * _e376);
                    let _e404 = (bitcast<f32>((bitcast<u32>(_e400) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e404 {
                        let _e408 = (bitcast<f32>((bitcast<u32>(_e390) & 2147483647u)) * 0.00000011920929f);
                        phi_625_ = select(0.00000000000011368684f, _e408, (_e408 > 0.00000000000011368684f));
                    } else {
                        phi_625_ = 0f;
                    }
                    let _e412 = phi_625_;
                    let _e413 = (_e390 + _e412);
                    let _e414 = (_e390 - _e412);
                    let _e415 = select(_e400, 0f, _e404);
                    if _e404 {
                        phi_636_ = 38685626000000000000000000f;
                    } else {
                        phi_636_ = (1f / _e400);
                    }
                    let _e418 = phi_636_;
                    let _e419 = (_e357 == 0u);
                    if _e419 {
                        phi_645_ = _e381[0];
                    } else {
                        phi_645_ = _e381[1];
                    }
                    let _e423 = phi_645_;
                    let _e424 = (_e357 == 2u);
                    if _e424 {
                        phi_651_ = _e381[2];
                    } else {
                        phi_651_ = _e423;
                    }
                    let _e427 = phi_651_;
                    if _e419 {
                        phi_662_ = _e391[0];
                    } else {
                        phi_662_ = _e391[1];
                    }
                    let _e431 = phi_662_;
                    if _e424 {
                        phi_668_ = _e391[2];
                    } else {
                        phi_668_ = _e431;
                    }
                    let _e434 = phi_668_;
                    let _e436 = ((_e434 * _e370) * _e376);
                    let _e440 = (bitcast<f32>((bitcast<u32>(_e436) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e440 {
                        let _e444 = (bitcast<f32>((bitcast<u32>(_e427) & 2147483647u)) * 0.00000011920929f);
                        phi_691_ = select(0.00000000000011368684f, _e444, (_e444 > 0.00000000000011368684f));
                    } else {
                        phi_691_ = 0f;
                    }
                    let _e448 = phi_691_;
                    let _e449 = (_e427 + _e448);
                    let _e450 = (_e427 - _e448);
                    let _e451 = select(_e436, 0f, _e440);
                    if _e440 {
                        phi_702_ = 38685626000000000000000000f;
                    } else {
                        phi_702_ = (1f / _e436);
                    }
                    let _e454 = phi_702_;
                    let _e455 = (_e359 == 0u);
                    if _e455 {
                        phi_711_ = _e381[0];
                    } else {
                        phi_711_ = _e381[1];
                    }
                    let _e459 = phi_711_;
                    let _e460 = (_e359 == 2u);
                    if _e460 {
                        phi_717_ = _e381[2];
                    } else {
                        phi_717_ = _e459;
                    }
                    let _e463 = phi_717_;
                    if _e455 {
                        phi_728_ = _e391[0];
                    } else {
                        phi_728_ = _e391[1];
                    }
                    let _e467 = phi_728_;
                    if _e460 {
                        phi_734_ = _e391[2];
                    } else {
                        phi_734_ = _e467;
                    }
                    let _e470 = phi_734_;
                    let _e472 = ((_e470 * _e370) * _e376);
                    let _e476 = (bitcast<f32>((bitcast<u32>(_e472) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e476 {
                        let _e480 = (bitcast<f32>((bitcast<u32>(_e463) & 2147483647u)) * 0.00000011920929f);
                        phi_757_ = select(0.00000000000011368684f, _e480, (_e480 > 0.00000000000011368684f));
                    } else {
                        phi_757_ = 0f;
                    }
                    let _e484 = phi_757_;
                    let _e485 = (_e463 + _e484);
                    let _e486 = (_e463 - _e484);
                    let _e487 = select(_e472, 0f, _e476);
                    if _e476 {
                        phi_768_ = 38685626000000000000000000f;
                    } else {
                        phi_768_ = (1f / _e472);
                    }
                    let _e490 = phi_768_;
                    let _e493 = bitcast<f32>((bitcast<u32>(_e390) & 2147483647u));
                    let _e496 = bitcast<f32>((bitcast<u32>(_e427) & 2147483647u));
                    let _e498 = select(_e496, _e493, (_e493 > _e496));
                    let _e501 = bitcast<f32>((bitcast<u32>(_e463) & 2147483647u));
                    if (_e320 && (select(_e501, _e498, (_e498 > _e501)) <= 1099511600000f)) {
                        let _e506 = (_e339 / 3i);
                        let _e513 = bitcast<f32>((bitcast<u32>((_e506 + 127i)) << bitcast<u32>(23i)));
                        let _e520 = bitcast<f32>((bitcast<u32>(((_e339 - (2i * _e506)) + 127i)) << bitcast<u32>(23i)));
                        let _e521 = (((_e304 * _e513) * _e513) * _e520);
                        let _e523 = select(340282350000000000000000000000000000000f, _e521, (_e521 < 340282350000000000000000000000000000000f));
                        let _e528 = (((_e314 * _e513) * _e513) * _e520);
                        let _e530 = select(340282350000000000000000000000000000000f, _e528, (_e528 < 340282350000000000000000000000000000000f));
                        phi_868_ = select(-340282350000000000000000000000000000000f, _e530, (_e530 > -340282350000000000000000000000000000000f));
                        phi_869_ = select(-340282350000000000000000000000000000000f, _e523, (_e523 > -340282350000000000000000000000000000000f));
                    } else {
                        phi_868_ = 0f;
                        phi_869_ = 1f;
                    }
                    let _e534 = phi_868_;
                    let _e536 = phi_869_;
                    local_8 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                    local_7 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_6 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_5 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_4 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_3 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_9 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    let _e540 = (_e358 % 3u);
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
                    let _e552 = (_e359 % 3u);
                    let _e553 = (_e552 < 3u);
                    if _e553 {
                    } else {
                        break;
                    }
                    let _e555 = local_1[_e552];
                    if _e541 {
                    } else {
                        break;
                    }
                    let _e560 = local[_e540];
                    if _e547 {
                    } else {
                        break;
                    }
                    let _e564 = local[_e546];
                    if _e553 {
                    } else {
                        break;
                    }
                    let _e568 = local[_e552];
                    phi_3970_ = false;
                    phi_958_ = type_47(type_30(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e534);
                    phi_961_ = type_62(type_42(vec4<f32>((f32(_e543) * _e155), (f32(_e549) * _e155), (f32(_e555) * _e155), 0f), vec4<f32>((f32(_e560) * _e155), (f32(_e564) * _e155), (f32(_e568) * _e155), 0f)), select(0u, 2147483648u, (_e97 == 0u)));
                    phi_963_ = ((3u * _e97) + 1u);
                    phi_965_ = (_e536 <= _e534);
                    phi_967_ = 0u;
                    loop {
                        let _e578 = phi_3970_;
                        let _e580 = phi_958_;
                        let _e582 = phi_961_;
                        let _e584 = phi_963_;
                        let _e586 = phi_965_;
                        let _e588 = phi_967_;
                        local_10 = _e580;
                        if _e586 {
                            phi_978_ = true;
                        } else {
                            phi_978_ = (_e588 > 0u);
                        }
                        let _e591 = phi_978_;
                        if _e591 {
                            let _e592 = (_e584 > 0u);
                            if _e592 {
                                if _e586 {
                                    phi_1064_ = _e582;
                                    phi_1065_ = _e586;
                                    phi_1066_ = _e588;
                                } else {
                                    let _e593 = (_e588 - 1u);
                                    let _e594 = (_e593 % 128u);
                                    let _e595 = (_e594 < 128u);
                                    if _e595 {
                                    } else {
                                        phi_4130_ = true;
                                        break;
                                    }
                                    let _e597 = local_7[_e594];
                                    if _e595 {
                                    } else {
                                        phi_4130_ = true;
                                        break;
                                    }
                                    let _e599 = local_6[_e594];
                                    if _e595 {
                                    } else {
                                        phi_4130_ = true;
                                        break;
                                    }
                                    let _e601 = local_5[_e594];
                                    if _e595 {
                                    } else {
                                        phi_4130_ = true;
                                        break;
                                    }
                                    let _e603 = local_4[_e594];
                                    if _e595 {
                                    } else {
                                        phi_4130_ = true;
                                        break;
                                    }
                                    let _e605 = local_3[_e594];
                                    if _e595 {
                                    } else {
                                        phi_4130_ = true;
                                        break;
                                    }
                                    let _e607 = local_2[_e594];
                                    if _e595 {
                                    } else {
                                        phi_4130_ = true;
                                        break;
                                    }
                                    let _e612 = local_8[_e594];
                                    if _e595 {
                                    } else {
                                        phi_4130_ = true;
                                        break;
                                    }
                                    let _e615 = local_9[_e594];
                                    phi_1064_ = type_62(type_42(vec4<f32>(_e597, _e599, _e601, 0f), vec4<f32>(_e603, _e605, _e607, 0f)), _e612);
                                    phi_1065_ = (_e615 <= _e580.member_1);
                                    phi_1066_ = _e593;
                                }
                                let _e619 = phi_1064_;
                                let _e621 = phi_1065_;
                                let _e623 = phi_1066_;
                                if _e621 {
                                    if ((_e619.member_1 & 2147483648u) != 0u) {
                                        phi_1084_ = _e580;
                                        phi_1087_ = type_8(0u, ((_e619.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e1067 = phi_1084_;
                                            let _e1069 = phi_1087_;
                                            local_11 = _e1067;
                                            if (_e1069.member < _e1069.member_1) {
                                                phi_1088_ = type_8((_e1069.member + 1u), _e1069.member_1);
                                                phi_1110_ = type_8(1u, _e1069.member);
                                            } else {
                                                phi_1088_ = _e1069;
                                                phi_1110_ = type_8(0u, type_8().member_1);
                                            }
                                            let _e1082 = phi_1088_;
                                            let _e1084 = phi_1110_;
                                            let _e1088 = (bitcast<i32>(_e1084.member) != 0i);
                                            if _e1088 {
                                                let _e1089 = ((_e619.member_1 & 268435455u) + _e1084.member_1);
                                                let _e1090 = (_e1089 < _e99);
                                                if _e1090 {
                                                    if _e1090 {
                                                    } else {
                                                        phi_3964_ = true;
                                                        break;
                                                    }
                                                    let _e1094 = global_5.member[_e1089].member_1;
                                                    phi_1131_ = _e1094;
                                                } else {
                                                    phi_1131_ = 4294967295u;
                                                }
                                                let _e1096 = phi_1131_;
                                                if (_e1089 >= _e99) {
                                                    phi_1220_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                } else {
                                                    if _e1090 {
                                                    } else {
                                                        phi_3964_ = true;
                                                        break;
                                                    }
                                                    if (_e540 < 9u) {
                                                    } else {
                                                        phi_3964_ = true;
                                                        break;
                                                    }
                                                    let _e1103 = global_5.member[_e1089].member[_e540];
                                                    if (_e546 < 9u) {
                                                    } else {
                                                        phi_3964_ = true;
                                                        break;
                                                    }
                                                    let _e1109 = global_5.member[_e1089].member[_e546];
                                                    if (_e552 < 9u) {
                                                    } else {
                                                        phi_3964_ = true;
                                                        break;
                                                    }
                                                    let _e1115 = global_5.member[_e1089].member[_e552];
                                                    let _e1117 = (3u + _e540);
                                                    if (_e1117 < 9u) {
                                                    } else {
                                                        phi_3964_ = true;
                                                        break;
                                                    }
                                                    let _e1123 = global_5.member[_e1089].member[_e1117];
                                                    let _e1124 = (3u + _e546);
                                                    if (_e1124 < 9u) {
                                                    } else {
                                                        phi_3964_ = true;
                                                        break;
                                                    }
                                                    let _e1130 = global_5.member[_e1089].member[_e1124];
                                                    let _e1131 = (3u + _e552);
                                                    if (_e1131 < 9u) {
                                                    } else {
                                                        phi_3964_ = true;
                                                        break;
                                                    }
                                                    let _e1137 = global_5.member[_e1089].member[_e1131];
                                                    let _e1139 = (6u + _e540);
                                                    if (_e1139 < 9u) {
                                                    } else {
                                                        phi_3964_ = true;
                                                        break;
                                                    }
                                                    let _e1145 = global_5.member[_e1089].member[_e1139];
                                                    let _e1146 = (6u + _e546);
                                                    if (_e1146 < 9u) {
                                                    } else {
                                                        phi_3964_ = true;
                                                        break;
                                                    }
                                                    let _e1152 = global_5.member[_e1089].member[_e1146];
                                                    let _e1153 = (6u + _e552);
                                                    if (_e1153 < 9u) {
                                                    } else {
                                                        phi_3964_ = true;
                                                        break;
                                                    }
                                                    let _e1159 = global_5.member[_e1089].member[_e1153];
                                                    phi_1220_ = array<array<f32, 3>, 3>(array<f32, 3>(_e1103, _e1109, _e1115), array<f32, 3>(_e1123, _e1130, _e1137), array<f32, 3>(_e1145, _e1152, _e1159));
                                                }
                                                let _e1163 = phi_1220_;
                                                let _e1171 = (_e1163[0][2] - _e463);
                                                let _e1174 = (((_e1163[0][0] - _e390) * _e487) - (_e1171 * _e415));
                                                let _e1177 = (((_e1163[0][1] - _e427) * _e487) - (_e1171 * _e451));
                                                let _e1184 = (_e1163[1][2] - _e463);
                                                let _e1187 = (((_e1163[1][0] - _e390) * _e487) - (_e1184 * _e415));
                                                let _e1190 = (((_e1163[1][1] - _e427) * _e487) - (_e1184 * _e451));
                                                let _e1197 = (_e1163[2][2] - _e463);
                                                let _e1200 = (((_e1163[2][0] - _e390) * _e487) - (_e1197 * _e415));
                                                let _e1203 = (((_e1163[2][1] - _e427) * _e487) - (_e1197 * _e451));
                                                let _e1204 = (_e1200 * _e1190);
                                                let _e1205 = (_e1203 * _e1187);
                                                let _e1206 = (_e1174 * _e1203);
                                                let _e1207 = (_e1177 * _e1200);
                                                let _e1208 = (_e1187 * _e1177);
                                                let _e1209 = (_e1190 * _e1174);
                                                let _e1214 = (((_e1204 >= _e1205) && (_e1206 >= _e1207)) && (_e1208 >= _e1209));
                                                if (_e1214 || (((_e1204 <= _e1205) && (_e1206 <= _e1207)) && (_e1208 <= _e1209))) {
                                                    let _e1221 = select(-1f, 1f, _e1214);
                                                    let _e1223 = ((_e1204 - _e1205) * _e1221);
                                                    let _e1225 = select(0f, _e1223, (_e1223 > 0f));
                                                    let _e1227 = ((_e1206 - _e1207) * _e1221);
                                                    let _e1229 = select(0f, _e1227, (_e1227 > 0f));
                                                    let _e1231 = ((_e1208 - _e1209) * _e1221);
                                                    let _e1233 = select(0f, _e1231, (_e1231 > 0f));
                                                    let _e1235 = ((_e1225 + _e1229) + _e1233);
                                                    if (_e1235 < 0.000000000000000000000000000000000000011754944f) {
                                                        phi_2048_ = type_30();
                                                        phi_2049_ = true;
                                                        phi_2050_ = false;
                                                    } else {
                                                        let _e1238 = select(_e1187, _e1174, (_e1174 < _e1187));
                                                        if (select(_e1200, _e1238, (_e1238 < _e1200)) > 0f) {
                                                            phi_1337_ = true;
                                                        } else {
                                                            let _e1243 = select(_e1187, _e1174, (_e1174 > _e1187));
                                                            phi_1337_ = (select(_e1200, _e1243, (_e1243 > _e1200)) < 0f);
                                                        }
                                                        let _e1248 = phi_1337_;
                                                        if _e1248 {
                                                            phi_2045_ = type_30();
                                                            phi_2046_ = true;
                                                            phi_2047_ = false;
                                                        } else {
                                                            let _e1250 = select(_e1190, _e1177, (_e1177 < _e1190));
                                                            if (select(_e1203, _e1250, (_e1250 < _e1203)) > 0f) {
                                                                phi_1366_ = true;
                                                            } else {
                                                                let _e1255 = select(_e1190, _e1177, (_e1177 > _e1190));
                                                                phi_1366_ = (select(_e1203, _e1255, (_e1255 > _e1203)) < 0f);
                                                            }
                                                            let _e1260 = phi_1366_;
                                                            if _e1260 {
                                                                phi_2043_ = type_30();
                                                                phi_2044_ = false;
                                                            } else {
                                                                let _e1262 = select(_e1163[1][0], _e1163[0][0], (_e1163[0][0] < _e1163[1][0]));
                                                                let _e1266 = select(_e1163[1][0], _e1163[0][0], (_e1163[0][0] > _e1163[1][0]));
                                                                let _e1270 = select(_e1163[1][1], _e1163[0][1], (_e1163[0][1] < _e1163[1][1]));
                                                                let _e1274 = select(_e1163[1][1], _e1163[0][1], (_e1163[0][1] > _e1163[1][1]));
                                                                let _e1278 = select(_e1163[1][2], _e1163[0][2], (_e1163[0][2] < _e1163[1][2]));
                                                                let _e1282 = select(_e1163[1][2], _e1163[0][2], (_e1163[0][2] > _e1163[1][2]));
                                                                let _e1287 = ((select(_e1163[2][0], _e1262, (_e1262 < _e1163[2][0])) - _e413) * _e418);
                                                                let _e1288 = ((select(_e1163[2][0], _e1266, (_e1266 > _e1163[2][0])) - _e414) * _e418);
                                                                let _e1291 = ((select(_e1163[2][1], _e1270, (_e1270 < _e1163[2][1])) - _e449) * _e454);
                                                                let _e1292 = ((select(_e1163[2][1], _e1274, (_e1274 > _e1163[2][1])) - _e450) * _e454);
                                                                let _e1295 = ((select(_e1163[2][2], _e1278, (_e1278 < _e1163[2][2])) - _e485) * _e490);
                                                                let _e1296 = ((select(_e1163[2][2], _e1282, (_e1282 > _e1163[2][2])) - _e486) * _e490);
                                                                let _e1298 = select(_e1296, _e1295, (_e1295 < _e1296));
                                                                let _e1300 = select(_e1296, _e1295, (_e1295 > _e1296));
                                                                let _e1302 = select(_e1288, _e1287, (_e1287 < _e1288));
                                                                let _e1304 = select(_e1292, _e1291, (_e1291 < _e1292));
                                                                let _e1306 = select(_e1304, _e1302, (_e1302 > _e1304));
                                                                let _e1308 = select(_e1298, _e1306, (_e1306 > _e1298));
                                                                let _e1310 = select(_e1288, _e1287, (_e1287 > _e1288));
                                                                let _e1312 = select(_e1292, _e1291, (_e1291 > _e1292));
                                                                let _e1314 = select(_e1312, _e1310, (_e1310 < _e1312));
                                                                let _e1316 = select(_e1300, _e1314, (_e1314 < _e1300));
                                                                let _e1317 = -(_e1298);
                                                                let _e1323 = select(_e536, _e1308, (_e1308 > _e536));
                                                                if (_e1323 > (_e1316 + (select(_e1317, _e1300, (_e1300 > _e1317)) * 0.0000019073523f))) {
                                                                    phi_2038_ = type_30();
                                                                    phi_2039_ = true;
                                                                } else {
                                                                    let _e1325 = (_e1323 > _e1067.member_1);
                                                                    if _e1325 {
                                                                        phi_2037_ = type_30();
                                                                    } else {
                                                                        let _e1326 = vec3<f32>(_e1163[0][0], _e1163[0][1], _e1163[0][2]);
                                                                        let _e1327 = vec3<f32>(_e1163[1][0], _e1163[1][1], _e1163[1][2]);
                                                                        let _e1328 = vec3<f32>(_e1163[2][0], _e1163[2][1], _e1163[2][2]);
                                                                        let _e1329 = (_e1163[1][0] - _e1163[0][0]);
                                                                        let _e1330 = (_e1163[1][1] - _e1163[0][1]);
                                                                        let _e1331 = (_e1163[1][2] - _e1163[0][2]);
                                                                        let _e1332 = vec3<f32>(_e1329, _e1330, _e1331);
                                                                        let _e1333 = (_e1163[2][0] - _e1163[1][0]);
                                                                        let _e1334 = (_e1163[2][1] - _e1163[1][1]);
                                                                        let _e1335 = (_e1163[2][2] - _e1163[1][2]);
                                                                        let _e1336 = vec3<f32>(_e1333, _e1334, _e1335);
                                                                        let _e1337 = (_e1163[0][0] - _e1163[2][0]);
                                                                        let _e1338 = (_e1163[0][1] - _e1163[2][1]);
                                                                        let _e1339 = (_e1163[0][2] - _e1163[2][2]);
                                                                        let _e1340 = vec3<f32>(_e1337, _e1338, _e1339);
                                                                        let _e1343 = bitcast<f32>((bitcast<u32>(_e1329) & 2147483647u));
                                                                        let _e1346 = bitcast<f32>((bitcast<u32>(_e1330) & 2147483647u));
                                                                        let _e1348 = select(_e1346, _e1343, (_e1343 > _e1346));
                                                                        let _e1351 = bitcast<f32>((bitcast<u32>(_e1331) & 2147483647u));
                                                                        let _e1353 = select(_e1351, _e1348, (_e1348 > _e1351));
                                                                        let _e1356 = bitcast<f32>((bitcast<u32>(_e1333) & 2147483647u));
                                                                        let _e1359 = bitcast<f32>((bitcast<u32>(_e1334) & 2147483647u));
                                                                        let _e1361 = select(_e1359, _e1356, (_e1356 > _e1359));
                                                                        let _e1364 = bitcast<f32>((bitcast<u32>(_e1335) & 2147483647u));
                                                                        let _e1366 = select(_e1364, _e1361, (_e1361 > _e1364));
                                                                        let _e1369 = bitcast<f32>((bitcast<u32>(_e1337) & 2147483647u));
                                                                        let _e1372 = bitcast<f32>((bitcast<u32>(_e1338) & 2147483647u));
                                                                        let _e1374 = select(_e1372, _e1369, (_e1369 > _e1372));
                                                                        let _e1377 = bitcast<f32>((bitcast<u32>(_e1339) & 2147483647u));
                                                                        let _e1379 = select(_e1377, _e1374, (_e1374 > _e1377));
                                                                        let _e1381 = select(_e1366, _e1353, (_e1353 > _e1366));
                                                                        let _e1383 = select(_e1379, _e1381, (_e1381 > _e1379));
                                                                        if (_e1353 == _e1383) {
                                                                            phi_1767_ = _e1190;
                                                                            phi_1768_ = _e1187;
                                                                            phi_1769_ = _e1177;
                                                                            phi_1770_ = _e1174;
                                                                            phi_1771_ = _e1326;
                                                                            phi_1772_ = _e1340;
                                                                            phi_1773_ = _e1336;
                                                                            phi_1774_ = _e1332;
                                                                        } else {
                                                                            let _e1385 = (_e1366 == _e1383);
                                                                            let _e1390 = vec3(_e1385);
                                                                            phi_1767_ = select(_e1177, _e1203, _e1385);
                                                                            phi_1768_ = select(_e1174, _e1200, _e1385);
                                                                            phi_1769_ = select(_e1203, _e1190, _e1385);
                                                                            phi_1770_ = select(_e1200, _e1187, _e1385);
                                                                            phi_1771_ = select(_e1328, _e1327, _e1390);
                                                                            phi_1772_ = select(_e1336, _e1332, _e1390);
                                                                            phi_1773_ = select(_e1332, _e1340, _e1390);
                                                                            phi_1774_ = select(_e1340, _e1336, _e1390);
                                                                        }
                                                                        let _e1396 = phi_1767_;
                                                                        let _e1398 = phi_1768_;
                                                                        let _e1400 = phi_1769_;
                                                                        let _e1402 = phi_1770_;
                                                                        let _e1404 = phi_1771_;
                                                                        let _e1406 = phi_1772_;
                                                                        let _e1408 = phi_1773_;
                                                                        let _e1410 = phi_1774_;
                                                                        let _e1417 = ((_e1408.y * _e1406.z) - (_e1406.y * _e1408.z));
                                                                        let _e1422 = ((_e1408.z * _e1406.x) - (_e1406.z * _e1408.x));
                                                                        let _e1425 = ((_e1408.x * _e1406.y) - (_e1406.x * _e1408.y));
                                                                        if (_e1225 >= _e1229) {
                                                                            phi_1805_ = select(true, false, (_e1225 >= _e1233));
                                                                        } else {
                                                                            phi_1805_ = true;
                                                                        }
                                                                        let _e1430 = phi_1805_;
                                                                        if _e1430 {
                                                                            phi_1814_ = select(_e1328, _e1327, vec3((_e1229 >= _e1233)));
                                                                        } else {
                                                                            phi_1814_ = _e1326;
                                                                        }
                                                                        let _e1435 = phi_1814_;
                                                                        let _e1440 = (((_e1417 * _e415) + (_e1422 * _e451)) + (_e1425 * _e487));
                                                                        let _e1451 = (((_e1417 * (_e1435.x - _e390)) + (_e1422 * (_e1435.y - _e427))) + (_e1425 * (_e1435.z - _e463)));
                                                                        let _e1453 = (_e1398 - _e1402);
                                                                        let _e1454 = (_e1396 - _e1400);
                                                                        let _e1462 = (-(((_e1402 * _e1453) + (_e1400 * _e1454))) / ((_e1453 * _e1453) + (_e1454 * _e1454)));
                                                                        let _e1464 = select(1f, _e1462, (_e1462 < 1f));
                                                                        let _e1466 = select(0f, _e1464, (_e1464 > 0f));
                                                                        let _e1479 = ((_e1404.x + (_e1410.x * _e1466)) - _e390);
                                                                        let _e1480 = ((_e1404.y + (_e1410.y * _e1466)) - _e427);
                                                                        let _e1481 = ((_e1404.z + (_e1410.z * _e1466)) - _e463);
                                                                        let _e1482 = (_e1481 / _e487);
                                                                        let _e1494 = bitcast<f32>((bitcast<u32>(_e1479) & 2147483647u));
                                                                        let _e1497 = bitcast<f32>((bitcast<u32>(_e1480) & 2147483647u));
                                                                        let _e1499 = select(_e1497, _e1494, (_e1494 > _e1497));
                                                                        let _e1502 = bitcast<f32>((bitcast<u32>(_e1481) & 2147483647u));
                                                                        let _e1504 = select(_e1502, _e1499, (_e1499 > _e1502));
                                                                        let _e1510 = bitcast<f32>((bitcast<u32>(_e1417) & 2147483647u));
                                                                        let _e1513 = bitcast<f32>((bitcast<u32>(_e1422) & 2147483647u));
                                                                        let _e1515 = select(_e1513, _e1510, (_e1510 > _e1513));
                                                                        let _e1518 = bitcast<f32>((bitcast<u32>(_e1425) & 2147483647u));
                                                                        if (bitcast<f32>((bitcast<u32>(((((_e1417 * _e1479) + (_e1422 * _e1480)) + (_e1425 * _e1481)) - _e1451)) & 2147483647u)) <= ((0.0000009536743f * select(_e1383, _e1504, (_e1504 > _e1383))) * select(_e1518, _e1515, (_e1515 > _e1518)))) {
                                                                            let _e1528 = bitcast<f32>((bitcast<u32>(_e1408.x) & 2147483647u));
                                                                            let _e1531 = bitcast<f32>((bitcast<u32>(_e1408.y) & 2147483647u));
                                                                            let _e1533 = select(_e1531, _e1528, (_e1528 > _e1531));
                                                                            let _e1536 = bitcast<f32>((bitcast<u32>(_e1408.z) & 2147483647u));
                                                                            let _e1542 = bitcast<f32>((bitcast<u32>(_e1406.x) & 2147483647u));
                                                                            let _e1545 = bitcast<f32>((bitcast<u32>(_e1406.y) & 2147483647u));
                                                                            let _e1547 = select(_e1545, _e1542, (_e1542 > _e1545));
                                                                            let _e1550 = bitcast<f32>((bitcast<u32>(_e1406.z) & 2147483647u));
                                                                            phi_1981_ = select(true, false, (bitcast<f32>((bitcast<u32>(_e1440) & 2147483647u)) > ((0.0000038146973f * select(_e1536, _e1533, (_e1533 > _e1536))) * select(_e1550, _e1547, (_e1547 > _e1550)))));
                                                                        } else {
                                                                            phi_1981_ = true;
                                                                        }
                                                                        let _e1557 = phi_1981_;
                                                                        if _e1557 {
                                                                            let _e1568 = ((((_e1417 * (_e1479 - (_e415 * _e1482))) + (_e1422 * (_e1480 - (_e451 * _e1482)))) + (_e1425 * (_e1481 - _e1481))) / _e1440);
                                                                            if (bitcast<f32>((bitcast<u32>(_e1568) & 2147483647u)) <= _e1383) {
                                                                                phi_2005_ = (_e1482 + _e1568);
                                                                            } else {
                                                                                phi_2005_ = _e1482;
                                                                            }
                                                                            let _e1575 = phi_2005_;
                                                                            phi_2006_ = _e1575;
                                                                        } else {
                                                                            phi_2006_ = (_e1451 / _e1440);
                                                                        }
                                                                        let _e1577 = phi_2006_;
                                                                        let _e1579 = select(_e1316, _e1577, (_e1577 < _e1316));
                                                                        let _e1581 = select(_e1308, _e1579, (_e1579 > _e1308));
                                                                        if (_e1581 >= _e536) {
                                                                            let _e1583 = (_e1581 <= _e1067.member_1);
                                                                            if _e1583 {
                                                                                let _e1584 = (1f / _e1235);
                                                                                phi_2029_ = type_30(_e1581, (_e1229 * _e1584), (_e1233 * _e1584), _e1096);
                                                                            } else {
                                                                                phi_2029_ = type_30();
                                                                            }
                                                                            let _e1589 = phi_2029_;
                                                                            phi_2031_ = _e1589;
                                                                            phi_2032_ = select(true, false, _e1583);
                                                                        } else {
                                                                            phi_2031_ = type_30();
                                                                            phi_2032_ = true;
                                                                        }
                                                                        let _e1592 = phi_2031_;
                                                                        let _e1594 = phi_2032_;
                                                                        if _e1594 {
                                                                            phi_2036_ = type_30(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                        } else {
                                                                            phi_2036_ = _e1592;
                                                                        }
                                                                        let _e1596 = phi_2036_;
                                                                        phi_2037_ = _e1596;
                                                                    }
                                                                    let _e1598 = phi_2037_;
                                                                    phi_2038_ = _e1598;
                                                                    phi_2039_ = _e1325;
                                                                }
                                                                let _e1600 = phi_2038_;
                                                                let _e1602 = phi_2039_;
                                                                phi_2043_ = _e1600;
                                                                phi_2044_ = _e1602;
                                                            }
                                                            let _e1604 = phi_2043_;
                                                            let _e1606 = phi_2044_;
                                                            phi_2045_ = _e1604;
                                                            phi_2046_ = _e1260;
                                                            phi_2047_ = _e1606;
                                                        }
                                                        let _e1608 = phi_2045_;
                                                        let _e1610 = phi_2046_;
                                                        let _e1612 = phi_2047_;
                                                        phi_2048_ = _e1608;
                                                        phi_2049_ = _e1610;
                                                        phi_2050_ = _e1612;
                                                    }
                                                    let _e1614 = phi_2048_;
                                                    let _e1616 = phi_2049_;
                                                    let _e1618 = phi_2050_;
                                                    phi_2058_ = _e1614;
                                                    phi_2059_ = select(_e1618, true, _e1616);
                                                } else {
                                                    phi_2058_ = type_30();
                                                    phi_2059_ = true;
                                                }
                                                let _e1621 = phi_2058_;
                                                let _e1623 = phi_2059_;
                                                if _e1623 {
                                                    phi_2063_ = type_30(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                } else {
                                                    phi_2063_ = _e1621;
                                                }
                                                let _e1625 = phi_2063_;
                                                if (_e1625.member_3 != 4294967295u) {
                                                    if (_e1096 == _e164) {
                                                        phi_2392_ = false;
                                                    } else {
                                                        let _e1629 = (_e1096 < arrayLength((&global_6.member)));
                                                        if _e1629 {
                                                            if _e1629 {
                                                            } else {
                                                                phi_3964_ = true;
                                                                break;
                                                            }
                                                            let _e1631 = global_6.member[_e1096];
                                                            phi_2086_ = _e1631;
                                                        } else {
                                                            phi_2086_ = 4294967295u;
                                                        }
                                                        let _e1633 = phi_2086_;
                                                        let _e1634 = (_e1633 < arrayLength((&global_7.member)));
                                                        if _e1634 {
                                                            if _e1634 {
                                                            } else {
                                                                phi_3964_ = true;
                                                                break;
                                                            }
                                                            let _e1636 = global_7.member[_e1633];
                                                            phi_2100_ = _e1636;
                                                        } else {
                                                            phi_2100_ = 0i;
                                                        }
                                                        let _e1638 = phi_2100_;
                                                        let _e1639 = (_e1638 == 0i);
                                                        if _e1639 {
                                                            phi_2391_ = true;
                                                        } else {
                                                            if _e382 {
                                                                phi_2121_ = vec3<f32>(_e1163[0][0], _e1163[0][1], _e1163[0][2]);
                                                            } else {
                                                                if (_e358 == 1u) {
                                                                    phi_2120_ = vec3<f32>(_e1163[0][2], _e1163[0][0], _e1163[0][1]);
                                                                } else {
                                                                    phi_2120_ = vec3<f32>(_e1163[0][1], _e1163[0][2], _e1163[0][0]);
                                                                }
                                                                let _e1644 = phi_2120_;
                                                                phi_2121_ = _e1644;
                                                            }
                                                            let _e1647 = phi_2121_;
                                                            if _e382 {
                                                                phi_2138_ = vec3<f32>(_e1163[1][0], _e1163[1][1], _e1163[1][2]);
                                                            } else {
                                                                if (_e358 == 1u) {
                                                                    phi_2137_ = vec3<f32>(_e1163[1][2], _e1163[1][0], _e1163[1][1]);
                                                                } else {
                                                                    phi_2137_ = vec3<f32>(_e1163[1][1], _e1163[1][2], _e1163[1][0]);
                                                                }
                                                                let _e1652 = phi_2137_;
                                                                phi_2138_ = _e1652;
                                                            }
                                                            let _e1655 = phi_2138_;
                                                            if _e382 {
                                                                phi_2155_ = vec3<f32>(_e1163[2][0], _e1163[2][1], _e1163[2][2]);
                                                            } else {
                                                                if (_e358 == 1u) {
                                                                    phi_2154_ = vec3<f32>(_e1163[2][2], _e1163[2][0], _e1163[2][1]);
                                                                } else {
                                                                    phi_2154_ = vec3<f32>(_e1163[2][1], _e1163[2][2], _e1163[2][0]);
                                                                }
                                                                let _e1660 = phi_2154_;
                                                                phi_2155_ = _e1660;
                                                            }
                                                            let _e1663 = phi_2155_;
                                                            let _e1666 = (_e1655.x - _e1647.x);
                                                            let _e1669 = (_e1655.y - _e1647.y);
                                                            let _e1672 = (_e1655.z - _e1647.z);
                                                            let _e1674 = (_e1663.x - _e1647.x);
                                                            let _e1676 = (_e1663.y - _e1647.y);
                                                            let _e1678 = (_e1663.z - _e1647.z);
                                                            if (_e236.member_1 == 1u) {
                                                                phi_2191_ = (vec3<f32>(_e236.member[0], _e236.member[1], _e236.member[2]) - _e1647);
                                                            } else {
                                                                phi_2191_ = vec3<f32>(_e236.member[0], _e236.member[1], _e236.member[2]);
                                                            }
                                                            let _e1693 = phi_2191_;
                                                            let _e1699 = bitcast<f32>((bitcast<u32>((_e1666 * _e1676)) ^ _e236.member_3[0]));
                                                            let _e1703 = bitcast<f32>((bitcast<u32>((_e1669 * _e1674)) ^ _e236.member_3[0]));
                                                            let _e1707 = bitcast<f32>((bitcast<u32>((_e1669 * _e1678)) ^ _e236.member_3[0]));
                                                            let _e1711 = bitcast<f32>((bitcast<u32>((_e1672 * _e1676)) ^ _e236.member_3[0]));
                                                            let _e1715 = bitcast<f32>((bitcast<u32>((_e1672 * _e1674)) ^ _e236.member_3[0]));
                                                            let _e1719 = bitcast<f32>((bitcast<u32>((_e1666 * _e1678)) ^ _e236.member_3[0]));
                                                            let _e1720 = (_e1707 - _e1711);
                                                            let _e1721 = (_e1715 - _e1719);
                                                            let _e1722 = (_e1699 - _e1703);
                                                            let _e1746 = (bitcast<f32>((bitcast<u32>(_e1707) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1711) & 2147483647u)));
                                                            let _e1753 = (bitcast<f32>((bitcast<u32>(_e1715) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1719) & 2147483647u)));
                                                            let _e1760 = (bitcast<f32>((bitcast<u32>(_e1699) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1703) & 2147483647u)));
                                                            if (_e236.member_2 == 0f) {
                                                                phi_2373_ = 0f;
                                                            } else {
                                                                let _e1790 = bitcast<f32>((bitcast<u32>(_e1720) & 2147483647u));
                                                                let _e1793 = bitcast<f32>((bitcast<u32>(_e1721) & 2147483647u));
                                                                let _e1796 = bitcast<f32>((bitcast<u32>(_e1722) & 2147483647u));
                                                                let _e1798 = select(_e1796, _e1793, (_e1793 > _e1796));
                                                                let _e1802 = select(_e1796, _e1793, (_e1793 < _e1796));
                                                                let _e1806 = select(_e1793, _e1790, (_e1790 < _e1793));
                                                                let _e1808 = select(_e1793, _e1790, (_e1790 > _e1793));
                                                                let _e1810 = select(_e1796, _e1808, (_e1808 < _e1796));
                                                                phi_2373_ = bitcast<f32>((bitcast<u32>((_e236.member_2 * bitcast<f32>((bitcast<u32>(((((select(_e1798, _e1790, (_e1790 > _e1798)) + bitcast<f32>((bitcast<u32>((0.414214f * select(_e1810, _e1806, (_e1806 > _e1810)))) ^ _e236.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.317838f * select(_e1802, _e1790, (_e1790 < _e1802)))) ^ _e236.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.0000004768374f * ((_e1746 + _e1753) + _e1760))) ^ _e236.member_3[0]))) * 1.0000005f)) ^ _e236.member_3[0])))) ^ _e236.member_3[0]));
                                                            }
                                                            let _e1837 = phi_2373_;
                                                            phi_2391_ = (_e1639 || !(((((bitcast<f32>((bitcast<u32>((_e1693.x * _e1720)) ^ _e236.member_3[0])) + bitcast<f32>((bitcast<u32>((_e1693.y * _e1721)) ^ _e236.member_3[0]))) + bitcast<f32>((bitcast<u32>((_e1693.z * _e1722)) ^ _e236.member_3[0]))) * f32(-(_e1638))) > ((bitcast<f32>((bitcast<u32>((0.0000009536752f * ((bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1693.x) & 2147483647u)) * _e1746)) ^ _e236.member_3[0])) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1693.y) & 2147483647u)) * _e1753)) ^ _e236.member_3[0]))) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1693.z) & 2147483647u)) * _e1760)) ^ _e236.member_3[0]))))) ^ _e236.member_3[0])) + _e1837) + 0.0000000000000000000000000000000000001880791f))));
                                                        }
                                                        let _e1851 = phi_2391_;
                                                        phi_2392_ = _e1851;
                                                    }
                                                    let _e1853 = phi_2392_;
                                                    if _e1853 {
                                                        if (_e1625.member < _e1067.member.member) {
                                                            phi_2412_ = true;
                                                        } else {
                                                            if (_e1625.member == _e1067.member.member) {
                                                                phi_2411_ = (_e1625.member_3 < _e1067.member.member_3);
                                                            } else {
                                                                phi_2411_ = false;
                                                            }
                                                            let _e1863 = phi_2411_;
                                                            phi_2412_ = _e1863;
                                                        }
                                                        let _e1865 = phi_2412_;
                                                        if _e1865 {
                                                            phi_2418_ = type_47(_e1625, _e1625.member);
                                                        } else {
                                                            phi_2418_ = _e1067;
                                                        }
                                                        let _e1868 = phi_2418_;
                                                        phi_2419_ = _e1868;
                                                    } else {
                                                        phi_2419_ = _e1067;
                                                    }
                                                    let _e1870 = phi_2419_;
                                                    phi_2420_ = _e1870;
                                                } else {
                                                    phi_2420_ = _e1067;
                                                }
                                                let _e1872 = phi_2420_;
                                                phi_1085_ = _e1872;
                                            } else {
                                                phi_1085_ = type_47();
                                            }
                                            let _e1874 = phi_1085_;
                                            continue;
                                            continuing {
                                                phi_1084_ = _e1874;
                                                phi_1087_ = _e1082;
                                                phi_3964_ = _e578;
                                                break if !(_e1088);
                                            }
                                        }
                                        let _e1877 = phi_3964_;
                                        phi_4130_ = _e1877;
                                        if _e1877 {
                                            break;
                                        }
                                        phi_4134_ = _e1877;
                                        let _e2109 = local_11;
                                        phi_3625_ = _e2109;
                                        phi_3626_ = _e619;
                                        phi_3627_ = false;
                                        phi_3628_ = _e623;
                                    } else {
                                        if (_e619.member_1 >= _e97) {
                                            phi_3181_ = type_63(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), type_62(type_42(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u), type_62(type_42(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u));
                                        } else {
                                            if (_e619.member_1 < _e97) {
                                            } else {
                                                phi_4130_ = true;
                                                break;
                                            }
                                            let _e635 = ((1u + _e358) % 4u);
                                            if (_e635 < 4u) {
                                            } else {
                                                phi_4130_ = true;
                                                break;
                                            }
                                            let _e640 = global_4.member[_e619.member_1][_e635];
                                            let _e642 = (_e640 >> bitcast<u32>(11u));
                                            let _e644 = ((1u + _e357) % 4u);
                                            if (_e644 < 4u) {
                                            } else {
                                                phi_4130_ = true;
                                                break;
                                            }
                                            let _e649 = global_4.member[_e619.member_1][_e644];
                                            let _e651 = (_e649 >> bitcast<u32>(11u));
                                            let _e653 = ((1u + _e359) % 4u);
                                            if (_e653 < 4u) {
                                            } else {
                                                phi_4130_ = true;
                                                break;
                                            }
                                            let _e658 = global_4.member[_e619.member_1][_e653];
                                            let _e660 = (_e658 >> bitcast<u32>(11u));
                                            let _e683 = (bitcast<f32>((bitcast<u32>((_e619.member.member_1.x - _e619.member.member.x)) & 2139095040u)) * 0.001953125f);
                                            let _e684 = (bitcast<f32>((bitcast<u32>((_e619.member.member_1.y - _e619.member.member.y)) & 2139095040u)) * 0.001953125f);
                                            let _e685 = (bitcast<f32>((bitcast<u32>((_e619.member.member_1.z - _e619.member.member.z)) & 2139095040u)) * 0.001953125f);
                                            let _e687 = select(_e155, _e683, (_e683 > _e155));
                                            let _e689 = select(_e155, _e684, (_e684 > _e155));
                                            let _e691 = select(_e155, _e685, (_e685 > _e155));
                                            let _e716 = bitcast<u32>((f32(bitcast<i32>((_e640 & 1023u))) * _e687));
                                            let _e721 = (bitcast<i32>((_e640 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e724 = bitcast<f32>((_e716 & bitcast<u32>(_e721)));
                                            let _e725 = bitcast<u32>((f32(bitcast<i32>((_e649 & 1023u))) * _e689));
                                            let _e730 = (bitcast<i32>((_e649 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e733 = bitcast<f32>((_e725 & bitcast<u32>(_e730)));
                                            let _e734 = bitcast<u32>((f32(bitcast<i32>((_e658 & 1023u))) * _e691));
                                            let _e739 = (bitcast<i32>((_e658 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e742 = bitcast<f32>((_e734 & bitcast<u32>(_e739)));
                                            let _e746 = bitcast<f32>((_e716 & bitcast<u32>(~(_e721))));
                                            let _e750 = bitcast<f32>((_e725 & bitcast<u32>(~(_e730))));
                                            let _e754 = bitcast<f32>((_e734 & bitcast<u32>(~(_e739))));
                                            let _e755 = bitcast<u32>((f32(bitcast<i32>((_e642 & 1023u))) * _e687));
                                            let _e760 = (bitcast<i32>((_e642 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e763 = bitcast<f32>((_e755 & bitcast<u32>(_e760)));
                                            let _e764 = bitcast<u32>((f32(bitcast<i32>((_e651 & 1023u))) * _e689));
                                            let _e769 = (bitcast<i32>((_e651 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e772 = bitcast<f32>((_e764 & bitcast<u32>(_e769)));
                                            let _e773 = bitcast<u32>((f32(bitcast<i32>((_e660 & 1023u))) * _e691));
                                            let _e778 = (bitcast<i32>((_e660 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e781 = bitcast<f32>((_e773 & bitcast<u32>(_e778)));
                                            let _e785 = bitcast<f32>((_e755 & bitcast<u32>(~(_e760))));
                                            let _e789 = bitcast<f32>((_e764 & bitcast<u32>(~(_e769))));
                                            let _e793 = bitcast<f32>((_e773 & bitcast<u32>(~(_e778))));
                                            let _e823 = global_4.member[_e619.member_1][0u];
                                            let _e827 = global_4.member[_e619.member_1][1u];
                                            let _e831 = global_4.member[_e619.member_1][2u];
                                            let _e835 = global_4.member[_e619.member_1][3u];
                                            let _e847 = (((_e827 >> bitcast<u32>(22i)) | ((_e831 >> bitcast<u32>(22i)) << bitcast<u32>(10i))) | ((_e835 >> bitcast<u32>(22i)) << bitcast<u32>(20i)));
                                            let _e848 = (_e823 & 268435455u);
                                            let _e849 = (_e847 & 268435455u);
                                            let _e852 = ((_e823 >> bitcast<u32>(28u)) & 7u);
                                            let _e860 = ((_e823 >> bitcast<u32>(31i)) | (((_e847 >> bitcast<u32>(28u)) & 3u) << bitcast<u32>(1i)));
                                            let _e861 = (_e852 != 0u);
                                            if (_e852 == 0u) {
                                                phi_3143_ = _e848;
                                            } else {
                                                if (_e852 == 7u) {
                                                    phi_3142_ = 2147483648u;
                                                } else {
                                                    phi_3142_ = ((2147483648u | (_e852 << bitcast<u32>(28u))) | (_e849 & 268435455u));
                                                }
                                                let _e870 = phi_3142_;
                                                phi_3143_ = _e870;
                                            }
                                            let _e872 = phi_3143_;
                                            if _e861 {
                                                let _e873 = (_e852 != 7u);
                                                if _e873 {
                                                    phi_3153_ = (_e849 + _e852);
                                                } else {
                                                    phi_3153_ = u32();
                                                }
                                                let _e876 = phi_3153_;
                                                phi_3155_ = _e876;
                                                phi_3156_ = select(true, false, _e873);
                                            } else {
                                                phi_3155_ = u32();
                                                phi_3156_ = true;
                                            }
                                            let _e879 = phi_3155_;
                                            let _e881 = phi_3156_;
                                            if (_e860 == 0u) {
                                                phi_3177_ = (_e848 + select(0u, 1u, !(_e861)));
                                            } else {
                                                if (_e860 == 7u) {
                                                    phi_3176_ = 2147483648u;
                                                } else {
                                                    phi_3176_ = ((2147483648u | (_e860 << bitcast<u32>(28u))) | (select(_e879, _e849, _e881) & 268435455u));
                                                }
                                                let _e894 = phi_3176_;
                                                phi_3177_ = _e894;
                                            }
                                            let _e896 = phi_3177_;
                                            phi_3181_ = type_63(array<vec4<f32>, 3>(vec4<f32>((_e619.member.member.x + _e724), (_e619.member.member.x + _e746), (_e619.member.member_1.x - _e763), (_e619.member.member_1.x - _e785)), vec4<f32>((_e619.member.member.y + _e733), (_e619.member.member.y + _e750), (_e619.member.member_1.y - _e772), (_e619.member.member_1.y - _e789)), vec4<f32>((_e619.member.member.z + _e742), (_e619.member.member.z + _e754), (_e619.member.member_1.z - _e781), (_e619.member.member_1.z - _e793))), type_62(type_42((_e619.member.member + vec4<f32>(_e724, _e733, _e742, 0f)), (_e619.member.member_1 - vec4<f32>(_e763, _e772, _e781, 0f))), _e872), type_62(type_42((_e619.member.member + vec4<f32>(_e746, _e750, _e754, 0f)), (_e619.member.member_1 - vec4<f32>(_e785, _e789, _e793, 0f))), _e896));
                                        }
                                        let _e901 = phi_3181_;
                                        let _e913 = ((_e901.member[0].x - _e413) * _e418);
                                        let _e914 = ((_e901.member[0].y - _e413) * _e418);
                                        let _e915 = ((_e901.member[0].z - _e414) * _e418);
                                        let _e916 = ((_e901.member[0].w - _e414) * _e418);
                                        let _e926 = ((_e901.member[1].x - _e449) * _e454);
                                        let _e927 = ((_e901.member[1].y - _e449) * _e454);
                                        let _e928 = ((_e901.member[1].z - _e450) * _e454);
                                        let _e929 = ((_e901.member[1].w - _e450) * _e454);
                                        let _e939 = ((_e901.member[2].x - _e485) * _e490);
                                        let _e940 = ((_e901.member[2].y - _e485) * _e490);
                                        let _e941 = ((_e901.member[2].z - _e486) * _e490);
                                        let _e942 = ((_e901.member[2].w - _e486) * _e490);
                                        let _e944 = select(_e941, _e939, (_e939 < _e941));
                                        let _e946 = select(_e942, _e940, (_e940 < _e942));
                                        let _e948 = select(_e941, _e939, (_e939 > _e941));
                                        let _e950 = select(_e942, _e940, (_e940 > _e942));
                                        let _e952 = select(_e915, _e913, (_e913 < _e915));
                                        let _e954 = select(_e916, _e914, (_e914 < _e916));
                                        let _e956 = select(_e928, _e926, (_e926 < _e928));
                                        let _e958 = select(_e929, _e927, (_e927 < _e929));
                                        let _e960 = select(_e956, _e952, (_e952 > _e956));
                                        let _e962 = select(_e958, _e954, (_e954 > _e958));
                                        let _e964 = select(_e944, _e960, (_e960 > _e944));
                                        let _e966 = select(_e946, _e962, (_e962 > _e946));
                                        let _e968 = select(_e915, _e913, (_e913 > _e915));
                                        let _e970 = select(_e916, _e914, (_e914 > _e916));
                                        let _e972 = select(_e928, _e926, (_e926 > _e928));
                                        let _e974 = select(_e929, _e927, (_e927 > _e929));
                                        let _e976 = select(_e972, _e968, (_e968 < _e972));
                                        let _e978 = select(_e974, _e970, (_e970 < _e974));
                                        let _e983 = -(_e944);
                                        let _e984 = -(_e946);
                                        let _e991 = (select(_e948, _e976, (_e976 < _e948)) + (select(_e983, _e948, (_e948 > _e983)) * 0.0000019073523f));
                                        let _e992 = (select(_e950, _e978, (_e978 < _e950)) + (select(_e984, _e950, (_e950 > _e984)) * 0.0000019073523f));
                                        let _e994 = select(_e536, _e964, (_e964 > _e536));
                                        let _e996 = select(_e536, _e966, (_e966 > _e536));
                                        let _e1001 = (_e994 <= select(_e580.member_1, _e991, (_e991 < _e580.member_1)));
                                        let _e1002 = (_e996 <= select(_e580.member_1, _e992, (_e992 < _e580.member_1)));
                                        let _e1003 = (_e994 <= _e996);
                                        if _e1001 {
                                            if _e1002 {
                                                if _e1003 {
                                                    phi_3525_ = _e901.member_2;
                                                } else {
                                                    phi_3525_ = _e901.member_1;
                                                }
                                                let _e1007 = phi_3525_;
                                                let _e1029 = (_e623 % 128u);
                                                let _e1030 = (_e1029 < 128u);
                                                if _e1030 {
                                                } else {
                                                    phi_4130_ = true;
                                                    break;
                                                }
                                                local_8[_e1029] = _e1007.member_1;
                                                if _e1030 {
                                                } else {
                                                    phi_4130_ = true;
                                                    break;
                                                }
                                                local_7[_e1029] = _e1007.member.member.x;
                                                if _e1030 {
                                                } else {
                                                    phi_4130_ = true;
                                                    break;
                                                }
                                                local_6[_e1029] = _e1007.member.member.y;
                                                if _e1030 {
                                                } else {
                                                    phi_4130_ = true;
                                                    break;
                                                }
                                                local_5[_e1029] = _e1007.member.member.z;
                                                if _e1030 {
                                                } else {
                                                    phi_4130_ = true;
                                                    break;
                                                }
                                                local_4[_e1029] = _e1007.member.member_1.x;
                                                if _e1030 {
                                                } else {
                                                    phi_4130_ = true;
                                                    break;
                                                }
                                                local_3[_e1029] = _e1007.member.member_1.y;
                                                if _e1030 {
                                                } else {
                                                    phi_4130_ = true;
                                                    break;
                                                }
                                                local_2[_e1029] = _e1007.member.member_1.z;
                                                if _e1030 {
                                                } else {
                                                    phi_4130_ = true;
                                                    break;
                                                }
                                                local_9[_e1029] = select(_e996, _e994, (_e994 > _e996));
                                                if _e1003 {
                                                    phi_3602_ = _e901.member_1;
                                                } else {
                                                    phi_3602_ = _e901.member_2;
                                                }
                                                let _e1043 = phi_3602_;
                                                phi_3603_ = _e1043;
                                                phi_3604_ = (_e623 + 1u);
                                            } else {
                                                phi_3603_ = type_62();
                                                phi_3604_ = u32();
                                            }
                                            let _e1045 = phi_3603_;
                                            let _e1047 = phi_3604_;
                                            phi_3606_ = _e1045;
                                            phi_3607_ = _e1047;
                                            phi_3608_ = select(true, false, _e1002);
                                        } else {
                                            phi_3606_ = type_62();
                                            phi_3607_ = u32();
                                            phi_3608_ = true;
                                        }
                                        let _e1050 = phi_3606_;
                                        let _e1052 = phi_3607_;
                                        let _e1054 = phi_3608_;
                                        if _e1054 {
                                            if _e1001 {
                                                phi_3617_ = _e901.member_1;
                                            } else {
                                                phi_3617_ = _e901.member_2;
                                            }
                                            let _e1058 = phi_3617_;
                                            phi_3622_ = _e1058;
                                            phi_3623_ = select(_e1002, true, _e1001);
                                        } else {
                                            phi_3622_ = _e1050;
                                            phi_3623_ = _e621;
                                        }
                                        let _e1061 = phi_3622_;
                                        let _e1063 = phi_3623_;
                                        phi_4134_ = _e578;
                                        phi_3625_ = _e580;
                                        phi_3626_ = _e1061;
                                        phi_3627_ = _e1063;
                                        phi_3628_ = select(_e1052, _e623, _e1054);
                                    }
                                    let _e1879 = phi_4134_;
                                    let _e1881 = phi_3625_;
                                    let _e1883 = phi_3626_;
                                    let _e1885 = phi_3627_;
                                    let _e1887 = phi_3628_;
                                    phi_4133_ = _e1879;
                                    phi_3629_ = _e1881;
                                    phi_3630_ = _e1883;
                                    phi_3631_ = (_e584 - 1u);
                                    phi_3632_ = _e1885;
                                    phi_3633_ = _e1887;
                                } else {
                                    phi_4133_ = _e578;
                                    phi_3629_ = _e580;
                                    phi_3630_ = _e619;
                                    phi_3631_ = _e584;
                                    phi_3632_ = _e621;
                                    phi_3633_ = _e623;
                                }
                                let _e1889 = phi_4133_;
                                let _e1891 = phi_3629_;
                                let _e1893 = phi_3630_;
                                let _e1895 = phi_3631_;
                                let _e1897 = phi_3632_;
                                let _e1899 = phi_3633_;
                                phi_4132_ = _e1889;
                                phi_3634_ = _e1891;
                                phi_3635_ = _e1893;
                                phi_3636_ = _e1895;
                                phi_3637_ = _e1897;
                                phi_3638_ = _e1899;
                            } else {
                                phi_4132_ = _e578;
                                phi_3634_ = type_47();
                                phi_3635_ = type_62();
                                phi_3636_ = u32();
                                phi_3637_ = bool();
                                phi_3638_ = u32();
                            }
                            let _e1901 = phi_4132_;
                            let _e1903 = phi_3634_;
                            let _e1905 = phi_3635_;
                            let _e1907 = phi_3636_;
                            let _e1909 = phi_3637_;
                            let _e1911 = phi_3638_;
                            phi_4131_ = _e1901;
                            phi_959_ = _e1903;
                            phi_962_ = _e1905;
                            phi_964_ = _e1907;
                            phi_966_ = _e1909;
                            phi_968_ = _e1911;
                            phi_3639_ = _e592;
                        } else {
                            phi_4131_ = _e578;
                            phi_959_ = type_47();
                            phi_962_ = type_62();
                            phi_964_ = u32();
                            phi_966_ = bool();
                            phi_968_ = u32();
                            phi_3639_ = false;
                        }
                        let _e1913 = phi_4131_;
                        let _e1915 = phi_959_;
                        let _e1917 = phi_962_;
                        let _e1919 = phi_964_;
                        let _e1921 = phi_966_;
                        let _e1923 = phi_968_;
                        let _e1925 = phi_3639_;
                        continue;
                        continuing {
                            phi_3970_ = _e1913;
                            phi_958_ = _e1915;
                            phi_961_ = _e1917;
                            phi_963_ = _e1919;
                            phi_965_ = _e1921;
                            phi_967_ = _e1923;
                            phi_4130_ = _e1913;
                            break if !(_e1925);
                        }
                    }
                    let _e1928 = phi_4130_;
                    if _e1928 {
                        break;
                    }
                    let _e1930 = local_10;
                    if (_e1930.member.member_3 != 4294967295u) {
                        let _e1935 = (_e360 / 3i);
                        let _e1942 = bitcast<f32>((bitcast<u32>((_e1935 + 127i)) << bitcast<u32>(23i)));
                        let _e1950 = (((_e1930.member.member * _e1942) * _e1942) * bitcast<f32>((bitcast<u32>(((_e360 - (2i * _e1935)) + 127i)) << bitcast<u32>(23i))));
                        let _e1952 = select(340282350000000000000000000000000000000f, _e1950, (_e1950 < 340282350000000000000000000000000000000f));
                        phi_3691_ = type_30(select(-340282350000000000000000000000000000000f, _e1952, (_e1952 > -340282350000000000000000000000000000000f)), _e1930.member.member_1, _e1930.member.member_2, _e1930.member.member_3);
                    } else {
                        phi_3691_ = type_30(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                    }
                    let _e1959 = phi_3691_;
                    if _e237 {
                    } else {
                        break;
                    }
                    global_9.member[_e143] = _e1959;
                    if _e158 {
                    } else {
                        break;
                    }
                    let _e1963 = select(0u, 1u, (_e304 <= _e314));
                    if (_e1963 > 0u) {
                        let _e1965 = (1u < _e111);
                        if _e1965 {
                            if (0u < _e111) {
                            } else {
                                break;
                            }
                            let _e1969 = atomicAdd((&global_10.member[0u]), _e1963);
                            if ((_e1969 + _e1963) < _e1969) {
                                if _e1965 {
                                } else {
                                    break;
                                }
                                let _e1974 = atomicAdd((&global_10.member[1u]), 1u);
                            }
                        }
                    }
                    let _e1977 = select(0u, 1u, (_e1959.member_3 != 4294967295u));
                    if (_e1977 > 0u) {
                        let _e1979 = (3u < _e111);
                        if _e1979 {
                            if (2u < _e111) {
                            } else {
                                break;
                            }
                            let _e1983 = atomicAdd((&global_10.member[2u]), _e1977);
                            if ((_e1983 + _e1977) < _e1983) {
                                if _e1979 {
                                } else {
                                    break;
                                }
                                let _e1988 = atomicAdd((&global_10.member[3u]), 1u);
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
fn trace_paths_q10_f32_(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
