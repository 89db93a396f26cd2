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
    var phi_323_: u32;
    var phi_367_: i32;
    var phi_391_: type_44;
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
    var phi_3843_: bool;
    var phi_956_: type_47;
    var phi_959_: type_62;
    var phi_961_: u32;
    var phi_963_: bool;
    var phi_965_: u32;
    var phi_976_: bool;
    var phi_1062_: type_62;
    var phi_1063_: bool;
    var phi_1064_: u32;
    var phi_3015_: u32;
    var phi_3016_: u32;
    var phi_3026_: u32;
    var phi_3028_: u32;
    var phi_3029_: bool;
    var phi_3049_: u32;
    var phi_3050_: u32;
    var phi_3054_: type_63;
    var phi_3398_: type_62;
    var phi_3475_: type_62;
    var phi_3476_: type_62;
    var phi_3477_: u32;
    var phi_3479_: type_62;
    var phi_3480_: u32;
    var phi_3481_: bool;
    var phi_3490_: type_62;
    var phi_3495_: type_62;
    var phi_3496_: bool;
    var phi_1082_: type_47;
    var phi_1085_: type_8;
    var phi_1086_: type_8;
    var phi_1108_: type_8;
    var phi_1129_: u32;
    var phi_1218_: array<array<f32, 3>, 3>;
    var phi_1689_: vec3<f32>;
    var phi_1690_: vec3<f32>;
    var phi_1721_: bool;
    var phi_1730_: vec3<f32>;
    var phi_1770_: type_30;
    var phi_1772_: type_30;
    var phi_1773_: bool;
    var phi_1777_: type_30;
    var phi_1778_: type_30;
    var phi_1779_: type_30;
    var phi_1780_: bool;
    var phi_1784_: type_30;
    var phi_1785_: bool;
    var phi_1789_: type_30;
    var phi_1790_: bool;
    var phi_1794_: type_30;
    var phi_1817_: u32;
    var phi_1831_: i32;
    var phi_1851_: vec3<f32>;
    var phi_1852_: vec3<f32>;
    var phi_1868_: vec3<f32>;
    var phi_1869_: vec3<f32>;
    var phi_1885_: vec3<f32>;
    var phi_1886_: vec3<f32>;
    var phi_1922_: vec3<f32>;
    var phi_2104_: f32;
    var phi_2122_: bool;
    var phi_2123_: bool;
    var phi_2142_: bool;
    var phi_2143_: bool;
    var phi_2149_: type_47;
    var phi_2150_: type_47;
    var phi_2151_: type_47;
    var phi_1083_: type_47;
    var phi_3837_: bool;
    var phi_3979_: bool;
    var phi_3498_: type_47;
    var phi_3499_: type_62;
    var phi_3500_: bool;
    var phi_3501_: u32;
    var phi_3978_: bool;
    var phi_3502_: type_47;
    var phi_3503_: type_62;
    var phi_3504_: u32;
    var phi_3505_: bool;
    var phi_3506_: u32;
    var phi_3977_: bool;
    var phi_3507_: type_47;
    var phi_3508_: type_62;
    var phi_3509_: u32;
    var phi_3510_: bool;
    var phi_3511_: u32;
    var phi_3976_: bool;
    var phi_957_: type_47;
    var phi_960_: type_62;
    var phi_962_: u32;
    var phi_964_: bool;
    var phi_966_: u32;
    var phi_3512_: bool;
    var phi_3975_: bool;
    var local_10: type_47;
    var phi_3564_: type_30;
    var local_11: type_47;

    switch bitcast<i32>(0u) {
        default: {
            let _e93 = global;
            let _e95 = arrayLength((&global_4.member));
            let _e97 = arrayLength((&global_5.member));
            let _e109 = arrayLength((&global_10.member));
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
            let _e156 = (_e141 < arrayLength((&global_8.member)));
            if _e156 {
                if _e156 {
                } else {
                    break;
                }
                let _e160 = global_8.member[_e141].member_2;
                phi_323_ = _e160;
            } else {
                phi_323_ = 4294967295u;
            }
            let _e162 = phi_323_;
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
                phi_367_ = -126i;
            } else {
                phi_367_ = select(_e205, 127i, (_e205 > 127i));
            }
            let _e210 = phi_367_;
            let _e215 = bitcast<f32>((bitcast<u32>((_e210 + 127i)) << bitcast<u32>(23i)));
            let _e221 = bitcast<f32>((bitcast<u32>(((_e205 - _e210) + 127i)) << bitcast<u32>(23i)));
            if (_e181 == 0u) {
                phi_391_ = type_44(array<f32, 3>(_e198, _e199, _e200), _e181, _e202, _e203);
            } else {
                phi_391_ = type_44(array<f32, 3>(((_e198 * _e215) * _e221), ((_e199 * _e215) * _e221), ((_e200 * _e215) * _e221)), _e181, ((_e202 * _e215) * _e221), _e203);
            }
            let _e234 = phi_391_;
            if _e156 {
                let _e235 = (_e141 < arrayLength((&global_9.member)));
                if _e235 {
                    if _e156 {
                    } else {
                        break;
                    }
                    let _e245 = global_8.member[_e141].member.member_2[0u];
                    let _e247 = (bitcast<u32>(_e245) & 2147483647u);
                    let _e253 = global_8.member[_e141].member.member_2[1u];
                    let _e255 = (bitcast<u32>(_e253) & 2147483647u);
                    let _e261 = global_8.member[_e141].member.member_2[2u];
                    let _e263 = (bitcast<u32>(_e261) & 2147483647u);
                    let _e269 = global_8.member[_e141].member.member[0u];
                    let _e271 = (bitcast<u32>(_e269) & 2147483647u);
                    let _e277 = global_8.member[_e141].member.member[1u];
                    let _e279 = (bitcast<u32>(_e277) & 2147483647u);
                    let _e285 = global_8.member[_e141].member.member[2u];
                    let _e287 = (bitcast<u32>(_e285) & 2147483647u);
                    let _e289 = select(_e255, _e247, (_e255 < _e247));
                    let _e291 = select(_e263, _e289, (_e263 < _e289));
                    let _e293 = select(_e271, _e291, (_e271 < _e291));
                    let _e295 = select(_e279, _e293, (_e279 < _e293));
                    let _e297 = select(_e287, _e295, (_e287 < _e295));
                    let _e302 = global_8.member[_e141].member.member_1;
                    let _e304 = (bitcast<u32>(_e302) & 2147483647u);
                    let _e312 = global_8.member[_e141].member.member_3;
                    let _e318 = (((select(_e304, _e297, (_e304 < _e297)) < 2139095040u) && ((bitcast<u32>(_e312) & 2147483647u) <= 2139095040u)) && (_e291 > 0u));
                    if _e318 {
                        let _e321 = (bitcast<u32>(bitcast<f32>(_e291)) & 2147483647u);
                        if (_e321 >= 8388608u) {
                            phi_497_ = (bitcast<i32>((_e321 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_497_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e321)), 32u, (_e321 == 0u))));
                        }
                        let _e335 = phi_497_;
                        phi_498_ = _e335;
                    } else {
                        phi_498_ = 0i;
                    }
                    let _e337 = phi_498_;
                    let _e338 = (_e247 == _e291);
                    if _e338 {
                        phi_508_ = true;
                    } else {
                        phi_508_ = (_e255 == _e291);
                    }
                    let _e341 = phi_508_;
                    let _e342 = select(1u, 0u, _e338);
                    if _e341 {
                        let _e343 = (_e342 + 1u);
                        phi_518_ = _e343;
                        phi_519_ = _e343;
                        phi_521_ = select(true, false, (_e343 == 2u));
                    } else {
                        phi_518_ = u32();
                        phi_519_ = 0u;
                        phi_521_ = true;
                    }
                    let _e347 = phi_518_;
                    let _e349 = phi_519_;
                    let _e351 = phi_521_;
                    if _e351 {
                        phi_526_ = (_e349 + 1u);
                    } else {
                        phi_526_ = 0u;
                    }
                    let _e355 = phi_526_;
                    let _e356 = select(_e347, _e349, _e351);
                    let _e357 = select(_e342, select(2u, _e342, _e341), _e351);
                    let _e358 = -(_e337);
                    if (_e358 < -126i) {
                        phi_559_ = -126i;
                    } else {
                        phi_559_ = select(_e358, 127i, (_e358 > 127i));
                    }
                    let _e363 = phi_559_;
                    let _e368 = bitcast<f32>((bitcast<u32>((_e363 + 127i)) << bitcast<u32>(23i)));
                    let _e374 = bitcast<f32>((bitcast<u32>(((_e358 - _e363) + 127i)) << bitcast<u32>(23i)));
                    let _e379 = global_8.member[_e141].member.member;
                    let _e380 = (_e356 == 0u);
                    if _e380 {
                        phi_577_ = _e379[0];
                    } else {
                        phi_577_ = _e379[1];
                    }
                    let _e384 = phi_577_;
                    let _e385 = (_e356 == 2u);
                    if _e385 {
                        phi_583_ = _e379[2];
                    } else {
                        phi_583_ = _e384;
                    }
                    let _e388 = phi_583_;
                    let _e389 = global_8.member[_e141].member.member_2;
                    if _e380 {
                        phi_594_ = _e389[0];
                    } else {
                        phi_594_ = _e389[1];
                    }
                    let _e393 = phi_594_;
                    if _e385 {
                        phi_600_ = _e389[2];
                    } else {
                        phi_600_ = _e393;
                    }
                    let _e396 = phi_600_;
                    let _e398 = ((_e396 * _e368) * _e374);
                    let _e402 = (bitcast<f32>((bitcast<u32>(_e398) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e402 {
                        let _e406 = (bitcast<f32>((bitcast<u32>(_e388) & 2147483647u)) * 0.00000011920929f);
                        phi_623_ = select(0.00000000000011368684f, _e406, (_e406 > 0.00000000000011368684f));
                    } else {
                        phi_623_ = 0f;
                    }
                    let _e410 = phi_623_;
                    let _e411 = (_e388 + _e410);
                    let _e412 = (_e388 - _e410);
                    let _e413 = select(_e398, 0f, _e402);
                    if _e402 {
                        phi_634_ = 38685626000000000000000000f;
                    } else {
                        phi_634_ = (1f / _e398);
                    }
                    let _e416 = phi_634_;
                    let _e417 = (_e355 == 0u);
                    if _e417 {
                        phi_643_ = _e379[0];
                    } else {
                        phi_643_ = _e379[1];
                    }
                    let _e421 = phi_643_;
                    let _e422 = (_e355 == 2u);
                    if _e422 {
                        phi_649_ = _e379[2];
                    } else {
                        phi_649_ = _e421;
                    }
                    let _e425 = phi_649_;
                    if _e417 {
                        phi_660_ = _e389[0];
                    } else {
                        phi_660_ = _e389[1];
                    }
                    let _e429 = phi_660_;
                    if _e422 {
                        phi_666_ = _e389[2];
                    } else {
                        phi_666_ = _e429;
                    }
                    let _e432 = phi_666_;
                    let _e434 = ((_e432 * _e368) * _e374);
                    let _e438 = (bitcast<f32>((bitcast<u32>(_e434) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e438 {
                        let _e442 = (bitcast<f32>((bitcast<u32>(_e425) & 2147483647u)) * 0.00000011920929f);
                        phi_689_ = select(0.00000000000011368684f, _e442, (_e442 > 0.00000000000011368684f));
                    } else {
                        phi_689_ = 0f;
                    }
                    let _e446 = phi_689_;
                    let _e447 = (_e425 + _e446);
                    let _e448 = (_e425 - _e446);
                    let _e449 = select(_e434, 0f, _e438);
                    if _e438 {
                        phi_700_ = 38685626000000000000000000f;
                    } else {
                        phi_700_ = (1f / _e434);
                    }
                    let _e452 = phi_700_;
                    let _e453 = (_e357 == 0u);
                    if _e453 {
                        phi_709_ = _e379[0];
                    } else {
                        phi_709_ = _e379[1];
                    }
                    let _e457 = phi_709_;
                    let _e458 = (_e357 == 2u);
                    if _e458 {
                        phi_715_ = _e379[2];
                    } else {
                        phi_715_ = _e457;
                    }
                    let _e461 = phi_715_;
                    if _e453 {
                        phi_726_ = _e389[0];
                    } else {
                        phi_726_ = _e389[1];
                    }
                    let _e465 = phi_726_;
                    if _e458 {
                        phi_732_ = _e389[2];
                    } else {
                        phi_732_ = _e465;
                    }
                    let _e468 = phi_732_;
                    let _e470 = ((_e468 * _e368) * _e374);
                    let _e474 = (bitcast<f32>((bitcast<u32>(_e470) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e474 {
                        let _e478 = (bitcast<f32>((bitcast<u32>(_e461) & 2147483647u)) * 0.00000011920929f);
                        phi_755_ = select(0.00000000000011368684f, _e478, (_e478 > 0.00000000000011368684f));
                    } else {
                        phi_755_ = 0f;
                    }
                    let _e482 = phi_755_;
                    let _e483 = (_e461 + _e482);
                    let _e484 = (_e461 - _e482);
                    let _e485 = select(_e470, 0f, _e474);
                    if _e474 {
                        phi_766_ = 38685626000000000000000000f;
                    } else {
                        phi_766_ = (1f / _e470);
                    }
                    let _e488 = phi_766_;
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
                        phi_866_ = select(-340282350000000000000000000000000000000f, _e528, (_e528 > -340282350000000000000000000000000000000f));
                        phi_867_ = select(-340282350000000000000000000000000000000f, _e521, (_e521 > -340282350000000000000000000000000000000f));
                    } else {
                        phi_866_ = 0f;
                        phi_867_ = 1f;
                    }
                    let _e532 = phi_866_;
                    let _e534 = phi_867_;
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
                    phi_3843_ = false;
                    phi_956_ = type_47(type_30(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e532);
                    phi_959_ = type_62(type_42(vec4<f32>((f32(_e541) * _e153), (f32(_e547) * _e153), (f32(_e553) * _e153), 0f), vec4<f32>((f32(_e558) * _e153), (f32(_e562) * _e153), (f32(_e566) * _e153), 0f)), select(0u, 2147483648u, (_e95 == 0u)));
                    phi_961_ = ((3u * _e95) + 1u);
                    phi_963_ = (_e534 <= _e532);
                    phi_965_ = 0u;
                    loop {
                        let _e576 = phi_3843_;
                        let _e578 = phi_956_;
                        let _e580 = phi_959_;
                        let _e582 = phi_961_;
                        let _e584 = phi_963_;
                        let _e586 = phi_965_;
                        local_10 = _e578;
                        if _e584 {
                            phi_976_ = true;
                        } else {
                            phi_976_ = (_e586 > 0u);
                        }
                        let _e589 = phi_976_;
                        if _e589 {
                            let _e590 = (_e582 > 0u);
                            if _e590 {
                                if _e584 {
                                    phi_1062_ = _e580;
                                    phi_1063_ = _e584;
                                    phi_1064_ = _e586;
                                } else {
                                    let _e591 = (_e586 - 1u);
                                    let _e592 = (_e591 % 128u);
                                    let _e593 = (_e592 < 128u);
                                    if _e593 {
                                    } else {
                                        phi_3975_ = true;
                                        break;
                                    }
                                    let _e595 = local_7[_e592];
                                    if _e593 {
                                    } else {
                                        phi_3975_ = true;
                                        break;
                                    }
                                    let _e597 = local_6[_e592];
                                    if _e593 {
                                    } else {
                                        phi_3975_ = true;
                                        break;
                                    }
                                    let _e599 = local_5[_e592];
                                    if _e593 {
                                    } else {
                                        phi_3975_ = true;
                                        break;
                                    }
                                    let _e601 = local_4[_e592];
                                    if _e593 {
                                    } else {
                                        phi_3975_ = true;
                                        break;
                                    }
                                    let _e603 = local_3[_e592];
                                    if _e593 {
                                    } else {
                                        phi_3975_ = true;
                                        break;
                                    }
                                    let _e605 = local_2[_e592];
                                    if _e593 {
                                    } else {
                                        phi_3975_ = true;
                                        break;
                                    }
                                    let _e610 = local_8[_e592];
                                    if _e593 {
                                    } else {
                                        phi_3975_ = true;
                                        break;
                                    }
                                    let _e613 = local_9[_e592];
                                    phi_1062_ = type_62(type_42(vec4<f32>(_e595, _e597, _e599, 0f), vec4<f32>(_e601, _e603, _e605, 0f)), _e610);
                                    phi_1063_ = (_e613 <= _e578.member_1);
                                    phi_1064_ = _e591;
                                }
                                let _e617 = phi_1062_;
                                let _e619 = phi_1063_;
                                let _e621 = phi_1064_;
                                if _e619 {
                                    if ((_e617.member_1 & 2147483648u) != 0u) {
                                        phi_1082_ = _e578;
                                        phi_1085_ = type_8(0u, ((_e617.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e1086 = phi_1082_;
                                            let _e1088 = phi_1085_;
                                            local_11 = _e1086;
                                            if (_e1088.member < _e1088.member_1) {
                                                phi_1086_ = type_8((_e1088.member + 1u), _e1088.member_1);
                                                phi_1108_ = type_8(1u, _e1088.member);
                                            } else {
                                                phi_1086_ = _e1088;
                                                phi_1108_ = type_8(0u, type_8().member_1);
                                            }
                                            let _e1101 = phi_1086_;
                                            let _e1103 = phi_1108_;
                                            let _e1107 = (bitcast<i32>(_e1103.member) != 0i);
                                            if _e1107 {
                                                let _e1108 = ((_e617.member_1 & 268435455u) + _e1103.member_1);
                                                let _e1109 = (_e1108 < _e97);
                                                if _e1109 {
                                                    if _e1109 {
                                                    } else {
                                                        phi_3837_ = true;
                                                        break;
                                                    }
                                                    let _e1113 = global_5.member[_e1108].member_1;
                                                    phi_1129_ = _e1113;
                                                } else {
                                                    phi_1129_ = 4294967295u;
                                                }
                                                let _e1115 = phi_1129_;
                                                if (_e1108 >= _e97) {
                                                    phi_1218_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                } else {
                                                    if _e1109 {
                                                    } else {
                                                        phi_3837_ = true;
                                                        break;
                                                    }
                                                    if (_e538 < 9u) {
                                                    } else {
                                                        phi_3837_ = true;
                                                        break;
                                                    }
                                                    let _e1122 = global_5.member[_e1108].member[_e538];
                                                    if (_e544 < 9u) {
                                                    } else {
                                                        phi_3837_ = true;
                                                        break;
                                                    }
                                                    let _e1128 = global_5.member[_e1108].member[_e544];
                                                    if (_e550 < 9u) {
                                                    } else {
                                                        phi_3837_ = true;
                                                        break;
                                                    }
                                                    let _e1134 = global_5.member[_e1108].member[_e550];
                                                    let _e1136 = (3u + _e538);
                                                    if (_e1136 < 9u) {
                                                    } else {
                                                        phi_3837_ = true;
                                                        break;
                                                    }
                                                    let _e1142 = global_5.member[_e1108].member[_e1136];
                                                    let _e1143 = (3u + _e544);
                                                    if (_e1143 < 9u) {
                                                    } else {
                                                        phi_3837_ = true;
                                                        break;
                                                    }
                                                    let _e1149 = global_5.member[_e1108].member[_e1143];
                                                    let _e1150 = (3u + _e550);
                                                    if (_e1150 < 9u) {
                                                    } else {
                                                        phi_3837_ = true;
                                                        break;
                                                    }
                                                    let _e1156 = global_5.member[_e1108].member[_e1150];
                                                    let _e1158 = (6u + _e538);
                                                    if (_e1158 < 9u) {
                                                    } else {
                                                        phi_3837_ = true;
                                                        break;
                                                    }
                                                    let _e1164 = global_5.member[_e1108].member[_e1158];
                                                    let _e1165 = (6u + _e544);
                                                    if (_e1165 < 9u) {
                                                    } else {
                                                        phi_3837_ = true;
                                                        break;
                                                    }
                                                    let _e1171 = global_5.member[_e1108].member[_e1165];
                                                    let _e1172 = (6u + _e550);
                                                    if (_e1172 < 9u) {
                                                    } else {
                                                        phi_3837_ = true;
                                                        break;
                                                    }
                                                    let _e1178 = global_5.member[_e1108].member[_e1172];
                                                    phi_1218_ = array<array<f32, 3>, 3>(array<f32, 3>(_e1122, _e1128, _e1134), array<f32, 3>(_e1142, _e1149, _e1156), array<f32, 3>(_e1164, _e1171, _e1178));
                                                }
                                                let _e1182 = phi_1218_;
                                                let _e1190 = (_e1182[0][2] - _e461);
                                                let _e1193 = (((_e1182[0][0] - _e388) * _e485) - (_e1190 * _e413));
                                                let _e1196 = (((_e1182[0][1] - _e425) * _e485) - (_e1190 * _e449));
                                                let _e1203 = (_e1182[1][2] - _e461);
                                                let _e1206 = (((_e1182[1][0] - _e388) * _e485) - (_e1203 * _e413));
                                                let _e1209 = (((_e1182[1][1] - _e425) * _e485) - (_e1203 * _e449));
                                                let _e1216 = (_e1182[2][2] - _e461);
                                                let _e1219 = (((_e1182[2][0] - _e388) * _e485) - (_e1216 * _e413));
                                                let _e1222 = (((_e1182[2][1] - _e425) * _e485) - (_e1216 * _e449));
                                                let _e1223 = (_e1219 * _e1209);
                                                let _e1224 = (_e1222 * _e1206);
                                                let _e1225 = (_e1193 * _e1222);
                                                let _e1226 = (_e1196 * _e1219);
                                                let _e1227 = (_e1206 * _e1196);
                                                let _e1228 = (_e1209 * _e1193);
                                                let _e1233 = (((_e1223 >= _e1224) && (_e1225 >= _e1226)) && (_e1227 >= _e1228));
                                                if (_e1233 || (((_e1223 <= _e1224) && (_e1225 <= _e1226)) && (_e1227 <= _e1228))) {
                                                    let _e1240 = select(-1f, 1f, _e1233);
                                                    let _e1242 = ((_e1223 - _e1224) * _e1240);
                                                    let _e1244 = select(0f, _e1242, (_e1242 > 0f));
                                                    let _e1246 = ((_e1225 - _e1226) * _e1240);
                                                    let _e1248 = select(0f, _e1246, (_e1246 > 0f));
                                                    let _e1250 = ((_e1227 - _e1228) * _e1240);
                                                    let _e1252 = select(0f, _e1250, (_e1250 > 0f));
                                                    let _e1254 = ((_e1244 + _e1248) + _e1252);
                                                    if (_e1254 < 0.000000000000000000000000000000000000011754944f) {
                                                        phi_1784_ = type_30();
                                                        phi_1785_ = true;
                                                    } else {
                                                        let _e1257 = select(_e1182[1][0], _e1182[0][0], (_e1182[0][0] < _e1182[1][0]));
                                                        let _e1261 = select(_e1182[1][0], _e1182[0][0], (_e1182[0][0] > _e1182[1][0]));
                                                        let _e1265 = select(_e1182[1][1], _e1182[0][1], (_e1182[0][1] < _e1182[1][1]));
                                                        let _e1269 = select(_e1182[1][1], _e1182[0][1], (_e1182[0][1] > _e1182[1][1]));
                                                        let _e1273 = select(_e1182[1][2], _e1182[0][2], (_e1182[0][2] < _e1182[1][2]));
                                                        let _e1277 = select(_e1182[1][2], _e1182[0][2], (_e1182[0][2] > _e1182[1][2]));
                                                        let _e1282 = ((select(_e1182[2][0], _e1257, (_e1257 < _e1182[2][0])) - _e411) * _e416);
                                                        let _e1283 = ((select(_e1182[2][0], _e1261, (_e1261 > _e1182[2][0])) - _e412) * _e416);
                                                        let _e1286 = ((select(_e1182[2][1], _e1265, (_e1265 < _e1182[2][1])) - _e447) * _e452);
                                                        let _e1287 = ((select(_e1182[2][1], _e1269, (_e1269 > _e1182[2][1])) - _e448) * _e452);
                                                        let _e1290 = ((select(_e1182[2][2], _e1273, (_e1273 < _e1182[2][2])) - _e483) * _e488);
                                                        let _e1291 = ((select(_e1182[2][2], _e1277, (_e1277 > _e1182[2][2])) - _e484) * _e488);
                                                        let _e1293 = select(_e1291, _e1290, (_e1290 < _e1291));
                                                        let _e1295 = select(_e1291, _e1290, (_e1290 > _e1291));
                                                        let _e1297 = select(_e1283, _e1282, (_e1282 < _e1283));
                                                        let _e1299 = select(_e1287, _e1286, (_e1286 < _e1287));
                                                        let _e1301 = select(_e1299, _e1297, (_e1297 > _e1299));
                                                        let _e1303 = select(_e1293, _e1301, (_e1301 > _e1293));
                                                        let _e1305 = select(_e1283, _e1282, (_e1282 > _e1283));
                                                        let _e1307 = select(_e1287, _e1286, (_e1286 > _e1287));
                                                        let _e1309 = select(_e1307, _e1305, (_e1305 < _e1307));
                                                        let _e1311 = select(_e1295, _e1309, (_e1309 < _e1295));
                                                        let _e1312 = -(_e1293);
                                                        let _e1318 = select(_e534, _e1303, (_e1303 > _e534));
                                                        if (_e1318 > (_e1311 + (select(_e1312, _e1295, (_e1295 > _e1312)) * 0.0000019073523f))) {
                                                            phi_1779_ = type_30();
                                                            phi_1780_ = true;
                                                        } else {
                                                            let _e1320 = (_e1318 > _e1086.member_1);
                                                            if _e1320 {
                                                                phi_1778_ = type_30();
                                                            } else {
                                                                let _e1324 = (_e1182[1][0] - _e1182[0][0]);
                                                                let _e1325 = (_e1182[1][1] - _e1182[0][1]);
                                                                let _e1326 = (_e1182[1][2] - _e1182[0][2]);
                                                                let _e1327 = vec3<f32>(_e1324, _e1325, _e1326);
                                                                let _e1328 = (_e1182[2][0] - _e1182[1][0]);
                                                                let _e1329 = (_e1182[2][1] - _e1182[1][1]);
                                                                let _e1330 = (_e1182[2][2] - _e1182[1][2]);
                                                                let _e1331 = vec3<f32>(_e1328, _e1329, _e1330);
                                                                let _e1332 = (_e1182[0][0] - _e1182[2][0]);
                                                                let _e1333 = (_e1182[0][1] - _e1182[2][1]);
                                                                let _e1334 = (_e1182[0][2] - _e1182[2][2]);
                                                                let _e1335 = vec3<f32>(_e1332, _e1333, _e1334);
                                                                let _e1338 = bitcast<f32>((bitcast<u32>(_e1324) & 2147483647u));
                                                                let _e1341 = bitcast<f32>((bitcast<u32>(_e1325) & 2147483647u));
                                                                let _e1343 = select(_e1341, _e1338, (_e1338 > _e1341));
                                                                let _e1346 = bitcast<f32>((bitcast<u32>(_e1326) & 2147483647u));
                                                                let _e1348 = select(_e1346, _e1343, (_e1343 > _e1346));
                                                                let _e1351 = bitcast<f32>((bitcast<u32>(_e1328) & 2147483647u));
                                                                let _e1354 = bitcast<f32>((bitcast<u32>(_e1329) & 2147483647u));
                                                                let _e1356 = select(_e1354, _e1351, (_e1351 > _e1354));
                                                                let _e1359 = bitcast<f32>((bitcast<u32>(_e1330) & 2147483647u));
                                                                let _e1361 = select(_e1359, _e1356, (_e1356 > _e1359));
                                                                let _e1364 = bitcast<f32>((bitcast<u32>(_e1332) & 2147483647u));
                                                                let _e1367 = bitcast<f32>((bitcast<u32>(_e1333) & 2147483647u));
                                                                let _e1369 = select(_e1367, _e1364, (_e1364 > _e1367));
                                                                let _e1372 = bitcast<f32>((bitcast<u32>(_e1334) & 2147483647u));
                                                                let _e1374 = select(_e1372, _e1369, (_e1369 > _e1372));
                                                                let _e1376 = select(_e1361, _e1348, (_e1348 > _e1361));
                                                                let _e1378 = select(_e1374, _e1376, (_e1376 > _e1374));
                                                                if (_e1348 == _e1378) {
                                                                    phi_1689_ = _e1331;
                                                                    phi_1690_ = _e1335;
                                                                } else {
                                                                    let _e1381 = vec3((_e1361 == _e1378));
                                                                    phi_1689_ = select(_e1327, _e1335, _e1381);
                                                                    phi_1690_ = select(_e1331, _e1327, _e1381);
                                                                }
                                                                let _e1385 = phi_1689_;
                                                                let _e1387 = phi_1690_;
                                                                let _e1394 = ((_e1385.y * _e1387.z) - (_e1387.y * _e1385.z));
                                                                let _e1399 = ((_e1385.z * _e1387.x) - (_e1387.z * _e1385.x));
                                                                let _e1402 = ((_e1385.x * _e1387.y) - (_e1387.x * _e1385.y));
                                                                if (_e1244 >= _e1248) {
                                                                    phi_1721_ = select(true, false, (_e1244 >= _e1252));
                                                                } else {
                                                                    phi_1721_ = true;
                                                                }
                                                                let _e1407 = phi_1721_;
                                                                if _e1407 {
                                                                    phi_1730_ = select(vec3<f32>(_e1182[2][0], _e1182[2][1], _e1182[2][2]), vec3<f32>(_e1182[1][0], _e1182[1][1], _e1182[1][2]), vec3((_e1248 >= _e1252)));
                                                                } else {
                                                                    phi_1730_ = vec3<f32>(_e1182[0][0], _e1182[0][1], _e1182[0][2]);
                                                                }
                                                                let _e1412 = phi_1730_;
                                                                let _e1429 = ((((_e1394 * (_e1412.x - _e388)) + (_e1399 * (_e1412.y - _e425))) + (_e1402 * (_e1412.z - _e461))) / (((_e1394 * _e413) + (_e1399 * _e449)) + (_e1402 * _e485)));
                                                                let _e1431 = select(_e1311, _e1429, (_e1429 < _e1311));
                                                                let _e1433 = select(_e1303, _e1431, (_e1431 > _e1303));
                                                                if (_e1433 >= _e534) {
                                                                    let _e1435 = (_e1433 <= _e1086.member_1);
                                                                    if _e1435 {
                                                                        let _e1436 = (1f / _e1254);
                                                                        phi_1770_ = type_30(_e1433, (_e1248 * _e1436), (_e1252 * _e1436), _e1115);
                                                                    } else {
                                                                        phi_1770_ = type_30();
                                                                    }
                                                                    let _e1441 = phi_1770_;
                                                                    phi_1772_ = _e1441;
                                                                    phi_1773_ = select(true, false, _e1435);
                                                                } else {
                                                                    phi_1772_ = type_30();
                                                                    phi_1773_ = true;
                                                                }
                                                                let _e1444 = phi_1772_;
                                                                let _e1446 = phi_1773_;
                                                                if _e1446 {
                                                                    phi_1777_ = type_30(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                } else {
                                                                    phi_1777_ = _e1444;
                                                                }
                                                                let _e1448 = phi_1777_;
                                                                phi_1778_ = _e1448;
                                                            }
                                                            let _e1450 = phi_1778_;
                                                            phi_1779_ = _e1450;
                                                            phi_1780_ = _e1320;
                                                        }
                                                        let _e1452 = phi_1779_;
                                                        let _e1454 = phi_1780_;
                                                        phi_1784_ = _e1452;
                                                        phi_1785_ = _e1454;
                                                    }
                                                    let _e1456 = phi_1784_;
                                                    let _e1458 = phi_1785_;
                                                    phi_1789_ = _e1456;
                                                    phi_1790_ = _e1458;
                                                } else {
                                                    phi_1789_ = type_30();
                                                    phi_1790_ = true;
                                                }
                                                let _e1460 = phi_1789_;
                                                let _e1462 = phi_1790_;
                                                if _e1462 {
                                                    phi_1794_ = type_30(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                } else {
                                                    phi_1794_ = _e1460;
                                                }
                                                let _e1464 = phi_1794_;
                                                if (_e1464.member_3 != 4294967295u) {
                                                    if (_e1115 == _e162) {
                                                        phi_2123_ = false;
                                                    } else {
                                                        let _e1468 = (_e1115 < arrayLength((&global_6.member)));
                                                        if _e1468 {
                                                            if _e1468 {
                                                            } else {
                                                                phi_3837_ = true;
                                                                break;
                                                            }
                                                            let _e1470 = global_6.member[_e1115];
                                                            phi_1817_ = _e1470;
                                                        } else {
                                                            phi_1817_ = 4294967295u;
                                                        }
                                                        let _e1472 = phi_1817_;
                                                        let _e1473 = (_e1472 < arrayLength((&global_7.member)));
                                                        if _e1473 {
                                                            if _e1473 {
                                                            } else {
                                                                phi_3837_ = true;
                                                                break;
                                                            }
                                                            let _e1475 = global_7.member[_e1472];
                                                            phi_1831_ = _e1475;
                                                        } else {
                                                            phi_1831_ = 0i;
                                                        }
                                                        let _e1477 = phi_1831_;
                                                        let _e1478 = (_e1477 == 0i);
                                                        if _e1478 {
                                                            phi_2122_ = true;
                                                        } else {
                                                            if _e380 {
                                                                phi_1852_ = vec3<f32>(_e1182[0][0], _e1182[0][1], _e1182[0][2]);
                                                            } else {
                                                                if (_e356 == 1u) {
                                                                    phi_1851_ = vec3<f32>(_e1182[0][2], _e1182[0][0], _e1182[0][1]);
                                                                } else {
                                                                    phi_1851_ = vec3<f32>(_e1182[0][1], _e1182[0][2], _e1182[0][0]);
                                                                }
                                                                let _e1483 = phi_1851_;
                                                                phi_1852_ = _e1483;
                                                            }
                                                            let _e1486 = phi_1852_;
                                                            if _e380 {
                                                                phi_1869_ = vec3<f32>(_e1182[1][0], _e1182[1][1], _e1182[1][2]);
                                                            } else {
                                                                if (_e356 == 1u) {
                                                                    phi_1868_ = vec3<f32>(_e1182[1][2], _e1182[1][0], _e1182[1][1]);
                                                                } else {
                                                                    phi_1868_ = vec3<f32>(_e1182[1][1], _e1182[1][2], _e1182[1][0]);
                                                                }
                                                                let _e1491 = phi_1868_;
                                                                phi_1869_ = _e1491;
                                                            }
                                                            let _e1494 = phi_1869_;
                                                            if _e380 {
                                                                phi_1886_ = vec3<f32>(_e1182[2][0], _e1182[2][1], _e1182[2][2]);
                                                            } else {
                                                                if (_e356 == 1u) {
                                                                    phi_1885_ = vec3<f32>(_e1182[2][2], _e1182[2][0], _e1182[2][1]);
                                                                } else {
                                                                    phi_1885_ = vec3<f32>(_e1182[2][1], _e1182[2][2], _e1182[2][0]);
                                                                }
                                                                let _e1499 = phi_1885_;
                                                                phi_1886_ = _e1499;
                                                            }
                                                            let _e1502 = phi_1886_;
                                                            let _e1505 = (_e1494.x - _e1486.x);
                                                            let _e1508 = (_e1494.y - _e1486.y);
                                                            let _e1511 = (_e1494.z - _e1486.z);
                                                            let _e1513 = (_e1502.x - _e1486.x);
                                                            let _e1515 = (_e1502.y - _e1486.y);
                                                            let _e1517 = (_e1502.z - _e1486.z);
                                                            if (_e234.member_1 == 1u) {
                                                                phi_1922_ = (vec3<f32>(_e234.member[0], _e234.member[1], _e234.member[2]) - _e1486);
                                                            } else {
                                                                phi_1922_ = vec3<f32>(_e234.member[0], _e234.member[1], _e234.member[2]);
                                                            }
                                                            let _e1532 = phi_1922_;
                                                            let _e1538 = bitcast<f32>((bitcast<u32>((_e1505 * _e1515)) ^ _e234.member_3[0]));
                                                            let _e1542 = bitcast<f32>((bitcast<u32>((_e1508 * _e1513)) ^ _e234.member_3[0]));
                                                            let _e1546 = bitcast<f32>((bitcast<u32>((_e1508 * _e1517)) ^ _e234.member_3[0]));
                                                            let _e1550 = bitcast<f32>((bitcast<u32>((_e1511 * _e1515)) ^ _e234.member_3[0]));
                                                            let _e1554 = bitcast<f32>((bitcast<u32>((_e1511 * _e1513)) ^ _e234.member_3[0]));
                                                            let _e1558 = bitcast<f32>((bitcast<u32>((_e1505 * _e1517)) ^ _e234.member_3[0]));
                                                            let _e1559 = (_e1546 - _e1550);
                                                            let _e1560 = (_e1554 - _e1558);
                                                            let _e1561 = (_e1538 - _e1542);
                                                            let _e1585 = (bitcast<f32>((bitcast<u32>(_e1546) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1550) & 2147483647u)));
                                                            let _e1592 = (bitcast<f32>((bitcast<u32>(_e1554) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1558) & 2147483647u)));
                                                            let _e1599 = (bitcast<f32>((bitcast<u32>(_e1538) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1542) & 2147483647u)));
                                                            if (_e234.member_2 == 0f) {
                                                                phi_2104_ = 0f;
                                                            } else {
                                                                let _e1629 = bitcast<f32>((bitcast<u32>(_e1559) & 2147483647u));
                                                                let _e1632 = bitcast<f32>((bitcast<u32>(_e1560) & 2147483647u));
                                                                let _e1635 = bitcast<f32>((bitcast<u32>(_e1561) & 2147483647u));
                                                                let _e1637 = select(_e1635, _e1632, (_e1632 > _e1635));
                                                                let _e1641 = select(_e1635, _e1632, (_e1632 < _e1635));
                                                                let _e1645 = select(_e1632, _e1629, (_e1629 < _e1632));
                                                                let _e1647 = select(_e1632, _e1629, (_e1629 > _e1632));
                                                                let _e1649 = select(_e1635, _e1647, (_e1647 < _e1635));
                                                                phi_2104_ = bitcast<f32>((bitcast<u32>((_e234.member_2 * bitcast<f32>((bitcast<u32>(((((select(_e1637, _e1629, (_e1629 > _e1637)) + bitcast<f32>((bitcast<u32>((0.414214f * select(_e1649, _e1645, (_e1645 > _e1649)))) ^ _e234.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.317838f * select(_e1641, _e1629, (_e1629 < _e1641)))) ^ _e234.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.0000004768374f * ((_e1585 + _e1592) + _e1599))) ^ _e234.member_3[0]))) * 1.0000005f)) ^ _e234.member_3[0])))) ^ _e234.member_3[0]));
                                                            }
                                                            let _e1676 = phi_2104_;
                                                            phi_2122_ = (_e1478 || !(((((bitcast<f32>((bitcast<u32>((_e1532.x * _e1559)) ^ _e234.member_3[0])) + bitcast<f32>((bitcast<u32>((_e1532.y * _e1560)) ^ _e234.member_3[0]))) + bitcast<f32>((bitcast<u32>((_e1532.z * _e1561)) ^ _e234.member_3[0]))) * f32(-(_e1477))) > ((bitcast<f32>((bitcast<u32>((0.0000009536752f * ((bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1532.x) & 2147483647u)) * _e1585)) ^ _e234.member_3[0])) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1532.y) & 2147483647u)) * _e1592)) ^ _e234.member_3[0]))) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1532.z) & 2147483647u)) * _e1599)) ^ _e234.member_3[0]))))) ^ _e234.member_3[0])) + _e1676) + 0.0000000000000000000000000000000000001880791f))));
                                                        }
                                                        let _e1690 = phi_2122_;
                                                        phi_2123_ = _e1690;
                                                    }
                                                    let _e1692 = phi_2123_;
                                                    if _e1692 {
                                                        if (_e1464.member < _e1086.member.member) {
                                                            phi_2143_ = true;
                                                        } else {
                                                            if (_e1464.member == _e1086.member.member) {
                                                                phi_2142_ = (_e1464.member_3 < _e1086.member.member_3);
                                                            } else {
                                                                phi_2142_ = false;
                                                            }
                                                            let _e1702 = phi_2142_;
                                                            phi_2143_ = _e1702;
                                                        }
                                                        let _e1704 = phi_2143_;
                                                        if _e1704 {
                                                            phi_2149_ = type_47(_e1464, _e1464.member);
                                                        } else {
                                                            phi_2149_ = _e1086;
                                                        }
                                                        let _e1707 = phi_2149_;
                                                        phi_2150_ = _e1707;
                                                    } else {
                                                        phi_2150_ = _e1086;
                                                    }
                                                    let _e1709 = phi_2150_;
                                                    phi_2151_ = _e1709;
                                                } else {
                                                    phi_2151_ = _e1086;
                                                }
                                                let _e1711 = phi_2151_;
                                                phi_1083_ = _e1711;
                                            } else {
                                                phi_1083_ = type_47();
                                            }
                                            let _e1713 = phi_1083_;
                                            continue;
                                            continuing {
                                                phi_1082_ = _e1713;
                                                phi_1085_ = _e1101;
                                                phi_3837_ = _e576;
                                                break if !(_e1107);
                                            }
                                        }
                                        let _e1716 = phi_3837_;
                                        phi_3975_ = _e1716;
                                        if _e1716 {
                                            break;
                                        }
                                        phi_3979_ = _e1716;
                                        let _e1931 = local_11;
                                        phi_3498_ = _e1931;
                                        phi_3499_ = _e617;
                                        phi_3500_ = false;
                                        phi_3501_ = _e621;
                                    } else {
                                        if (_e617.member_1 >= _e95) {
                                            phi_3054_ = type_63(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), type_62(type_42(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u), type_62(type_42(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u));
                                        } else {
                                            if (_e617.member_1 < _e95) {
                                            } else {
                                                phi_3975_ = true;
                                                break;
                                            }
                                            let _e633 = ((1u + _e356) % 4u);
                                            if (_e633 < 4u) {
                                            } else {
                                                phi_3975_ = true;
                                                break;
                                            }
                                            let _e638 = global_4.member[_e617.member_1][_e633];
                                            let _e640 = ((1u + _e355) % 4u);
                                            if (_e640 < 4u) {
                                            } else {
                                                phi_3975_ = true;
                                                break;
                                            }
                                            let _e645 = global_4.member[_e617.member_1][_e640];
                                            let _e647 = ((1u + _e357) % 4u);
                                            if (_e647 < 4u) {
                                            } else {
                                                phi_3975_ = true;
                                                break;
                                            }
                                            let _e652 = global_4.member[_e617.member_1][_e647];
                                            let _e654 = ((_e356 + 1u) % 4u);
                                            if (_e654 < 4u) {
                                            } else {
                                                phi_3975_ = true;
                                                break;
                                            }
                                            let _e659 = global_4.member[_e617.member_1][_e654];
                                            let _e661 = (_e659 >> bitcast<u32>(11u));
                                            let _e663 = ((_e355 + 1u) % 4u);
                                            if (_e663 < 4u) {
                                            } else {
                                                phi_3975_ = true;
                                                break;
                                            }
                                            let _e668 = global_4.member[_e617.member_1][_e663];
                                            let _e670 = (_e668 >> bitcast<u32>(11u));
                                            let _e672 = ((_e357 + 1u) % 4u);
                                            if (_e672 < 4u) {
                                            } else {
                                                phi_3975_ = true;
                                                break;
                                            }
                                            let _e677 = global_4.member[_e617.member_1][_e672];
                                            let _e679 = (_e677 >> bitcast<u32>(11u));
                                            let _e702 = (bitcast<f32>((bitcast<u32>((_e617.member.member_1.x - _e617.member.member.x)) & 2139095040u)) * 0.001953125f);
                                            let _e703 = (bitcast<f32>((bitcast<u32>((_e617.member.member_1.y - _e617.member.member.y)) & 2139095040u)) * 0.001953125f);
                                            let _e704 = (bitcast<f32>((bitcast<u32>((_e617.member.member_1.z - _e617.member.member.z)) & 2139095040u)) * 0.001953125f);
                                            let _e706 = select(_e153, _e702, (_e702 > _e153));
                                            let _e708 = select(_e153, _e703, (_e703 > _e153));
                                            let _e710 = select(_e153, _e704, (_e704 > _e153));
                                            let _e735 = bitcast<u32>((f32(bitcast<i32>((_e638 & 1023u))) * _e706));
                                            let _e740 = (bitcast<i32>((_e638 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e743 = bitcast<f32>((_e735 & bitcast<u32>(_e740)));
                                            let _e744 = bitcast<u32>((f32(bitcast<i32>((_e645 & 1023u))) * _e708));
                                            let _e749 = (bitcast<i32>((_e645 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e752 = bitcast<f32>((_e744 & bitcast<u32>(_e749)));
                                            let _e753 = bitcast<u32>((f32(bitcast<i32>((_e652 & 1023u))) * _e710));
                                            let _e758 = (bitcast<i32>((_e652 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e761 = bitcast<f32>((_e753 & bitcast<u32>(_e758)));
                                            let _e765 = bitcast<f32>((_e735 & bitcast<u32>(~(_e740))));
                                            let _e769 = bitcast<f32>((_e744 & bitcast<u32>(~(_e749))));
                                            let _e773 = bitcast<f32>((_e753 & bitcast<u32>(~(_e758))));
                                            let _e774 = bitcast<u32>((f32(bitcast<i32>((_e661 & 1023u))) * _e706));
                                            let _e779 = (bitcast<i32>((_e661 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e782 = bitcast<f32>((_e774 & bitcast<u32>(_e779)));
                                            let _e783 = bitcast<u32>((f32(bitcast<i32>((_e670 & 1023u))) * _e708));
                                            let _e788 = (bitcast<i32>((_e670 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e791 = bitcast<f32>((_e783 & bitcast<u32>(_e788)));
                                            let _e792 = bitcast<u32>((f32(bitcast<i32>((_e679 & 1023u))) * _e710));
                                            let _e797 = (bitcast<i32>((_e679 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e800 = bitcast<f32>((_e792 & bitcast<u32>(_e797)));
                                            let _e804 = bitcast<f32>((_e774 & bitcast<u32>(~(_e779))));
                                            let _e808 = bitcast<f32>((_e783 & bitcast<u32>(~(_e788))));
                                            let _e812 = bitcast<f32>((_e792 & bitcast<u32>(~(_e797))));
                                            let _e842 = global_4.member[_e617.member_1][0u];
                                            let _e846 = global_4.member[_e617.member_1][1u];
                                            let _e850 = global_4.member[_e617.member_1][2u];
                                            let _e854 = global_4.member[_e617.member_1][3u];
                                            let _e866 = (((_e846 >> bitcast<u32>(22i)) | ((_e850 >> bitcast<u32>(22i)) << bitcast<u32>(10i))) | ((_e854 >> bitcast<u32>(22i)) << bitcast<u32>(20i)));
                                            let _e867 = (_e842 & 268435455u);
                                            let _e868 = (_e866 & 268435455u);
                                            let _e871 = ((_e842 >> bitcast<u32>(28u)) & 7u);
                                            let _e879 = ((_e842 >> bitcast<u32>(31i)) | (((_e866 >> bitcast<u32>(28u)) & 3u) << bitcast<u32>(1i)));
                                            let _e880 = (_e871 != 0u);
                                            if (_e871 == 0u) {
                                                phi_3016_ = _e867;
                                            } else {
                                                if (_e871 == 7u) {
                                                    phi_3015_ = 2147483648u;
                                                } else {
                                                    phi_3015_ = ((2147483648u | (_e871 << bitcast<u32>(28u))) | (_e868 & 268435455u));
                                                }
                                                let _e889 = phi_3015_;
                                                phi_3016_ = _e889;
                                            }
                                            let _e891 = phi_3016_;
                                            if _e880 {
                                                let _e892 = (_e871 != 7u);
                                                if _e892 {
                                                    phi_3026_ = (_e868 + _e871);
                                                } else {
                                                    phi_3026_ = u32();
                                                }
                                                let _e895 = phi_3026_;
                                                phi_3028_ = _e895;
                                                phi_3029_ = select(true, false, _e892);
                                            } else {
                                                phi_3028_ = u32();
                                                phi_3029_ = true;
                                            }
                                            let _e898 = phi_3028_;
                                            let _e900 = phi_3029_;
                                            if (_e879 == 0u) {
                                                phi_3050_ = (_e867 + select(0u, 1u, !(_e880)));
                                            } else {
                                                if (_e879 == 7u) {
                                                    phi_3049_ = 2147483648u;
                                                } else {
                                                    phi_3049_ = ((2147483648u | (_e879 << bitcast<u32>(28u))) | (select(_e898, _e868, _e900) & 268435455u));
                                                }
                                                let _e913 = phi_3049_;
                                                phi_3050_ = _e913;
                                            }
                                            let _e915 = phi_3050_;
                                            phi_3054_ = type_63(array<vec4<f32>, 3>(vec4<f32>((_e617.member.member.x + _e743), (_e617.member.member.x + _e765), (_e617.member.member_1.x - _e782), (_e617.member.member_1.x - _e804)), vec4<f32>((_e617.member.member.y + _e752), (_e617.member.member.y + _e769), (_e617.member.member_1.y - _e791), (_e617.member.member_1.y - _e808)), vec4<f32>((_e617.member.member.z + _e761), (_e617.member.member.z + _e773), (_e617.member.member_1.z - _e800), (_e617.member.member_1.z - _e812))), type_62(type_42((_e617.member.member + vec4<f32>(_e743, _e752, _e761, 0f)), (_e617.member.member_1 - vec4<f32>(_e782, _e791, _e800, 0f))), _e891), type_62(type_42((_e617.member.member + vec4<f32>(_e765, _e769, _e773, 0f)), (_e617.member.member_1 - vec4<f32>(_e804, _e808, _e812, 0f))), _e915));
                                        }
                                        let _e920 = phi_3054_;
                                        let _e932 = ((_e920.member[0].x - _e411) * _e416);
                                        let _e933 = ((_e920.member[0].y - _e411) * _e416);
                                        let _e934 = ((_e920.member[0].z - _e412) * _e416);
                                        let _e935 = ((_e920.member[0].w - _e412) * _e416);
                                        let _e945 = ((_e920.member[1].x - _e447) * _e452);
                                        let _e946 = ((_e920.member[1].y - _e447) * _e452);
                                        let _e947 = ((_e920.member[1].z - _e448) * _e452);
                                        let _e948 = ((_e920.member[1].w - _e448) * _e452);
                                        let _e958 = ((_e920.member[2].x - _e483) * _e488);
                                        let _e959 = ((_e920.member[2].y - _e483) * _e488);
                                        let _e960 = ((_e920.member[2].z - _e484) * _e488);
                                        let _e961 = ((_e920.member[2].w - _e484) * _e488);
                                        let _e963 = select(_e960, _e958, (_e958 < _e960));
                                        let _e965 = select(_e961, _e959, (_e959 < _e961));
                                        let _e967 = select(_e960, _e958, (_e958 > _e960));
                                        let _e969 = select(_e961, _e959, (_e959 > _e961));
                                        let _e971 = select(_e934, _e932, (_e932 < _e934));
                                        let _e973 = select(_e935, _e933, (_e933 < _e935));
                                        let _e975 = select(_e947, _e945, (_e945 < _e947));
                                        let _e977 = select(_e948, _e946, (_e946 < _e948));
                                        let _e979 = select(_e975, _e971, (_e971 > _e975));
                                        let _e981 = select(_e977, _e973, (_e973 > _e977));
                                        let _e983 = select(_e963, _e979, (_e979 > _e963));
                                        let _e985 = select(_e965, _e981, (_e981 > _e965));
                                        let _e987 = select(_e934, _e932, (_e932 > _e934));
                                        let _e989 = select(_e935, _e933, (_e933 > _e935));
                                        let _e991 = select(_e947, _e945, (_e945 > _e947));
                                        let _e993 = select(_e948, _e946, (_e946 > _e948));
                                        let _e995 = select(_e991, _e987, (_e987 < _e991));
                                        let _e997 = select(_e993, _e989, (_e989 < _e993));
                                        let _e1002 = -(_e963);
                                        let _e1003 = -(_e965);
                                        let _e1010 = (select(_e967, _e995, (_e995 < _e967)) + (select(_e1002, _e967, (_e967 > _e1002)) * 0.0000019073523f));
                                        let _e1011 = (select(_e969, _e997, (_e997 < _e969)) + (select(_e1003, _e969, (_e969 > _e1003)) * 0.0000019073523f));
                                        let _e1013 = select(_e534, _e983, (_e983 > _e534));
                                        let _e1015 = select(_e534, _e985, (_e985 > _e534));
                                        let _e1020 = (_e1013 <= select(_e578.member_1, _e1010, (_e1010 < _e578.member_1)));
                                        let _e1021 = (_e1015 <= select(_e578.member_1, _e1011, (_e1011 < _e578.member_1)));
                                        let _e1022 = (_e1013 <= _e1015);
                                        if _e1020 {
                                            if _e1021 {
                                                if _e1022 {
                                                    phi_3398_ = _e920.member_2;
                                                } else {
                                                    phi_3398_ = _e920.member_1;
                                                }
                                                let _e1026 = phi_3398_;
                                                let _e1048 = (_e621 % 128u);
                                                let _e1049 = (_e1048 < 128u);
                                                if _e1049 {
                                                } else {
                                                    phi_3975_ = true;
                                                    break;
                                                }
                                                local_8[_e1048] = _e1026.member_1;
                                                if _e1049 {
                                                } else {
                                                    phi_3975_ = true;
                                                    break;
                                                }
                                                local_7[_e1048] = _e1026.member.member.x;
                                                if _e1049 {
                                                } else {
                                                    phi_3975_ = true;
                                                    break;
                                                }
                                                local_6[_e1048] = _e1026.member.member.y;
                                                if _e1049 {
                                                } else {
                                                    phi_3975_ = true;
                                                    break;
                                                }
                                                local_5[_e1048] = _e1026.member.member.z;
                                                if _e1049 {
                                                } else {
                                                    phi_3975_ = true;
                                                    break;
                                                }
                                                local_4[_e1048] = _e1026.member.member_1.x;
                                                if _e1049 {
                                                } else {
                                                    phi_3975_ = true;
                                                    break;
                                                }
                                                local_3[_e1048] = _e1026.member.member_1.y;
                                                if _e1049 {
                                                } else {
                                                    phi_3975_ = true;
                                                    break;
                                                }
                                                local_2[_e1048] = _e1026.member.member_1.z;
                                                if _e1049 {
                                                } else {
                                                    phi_3975_ = true;
                                                    break;
                                                }
                                                local_9[_e1048] = select(_e1015, _e1013, (_e1013 > _e1015));
                                                if _e1022 {
                                                    phi_3475_ = _e920.member_1;
                                                } else {
                                                    phi_3475_ = _e920.member_2;
                                                }
                                                let _e1062 = phi_3475_;
                                                phi_3476_ = _e1062;
                                                phi_3477_ = (_e621 + 1u);
                                            } else {
                                                phi_3476_ = type_62();
                                                phi_3477_ = u32();
                                            }
                                            let _e1064 = phi_3476_;
                                            let _e1066 = phi_3477_;
                                            phi_3479_ = _e1064;
                                            phi_3480_ = _e1066;
                                            phi_3481_ = select(true, false, _e1021);
                                        } else {
                                            phi_3479_ = type_62();
                                            phi_3480_ = u32();
                                            phi_3481_ = true;
                                        }
                                        let _e1069 = phi_3479_;
                                        let _e1071 = phi_3480_;
                                        let _e1073 = phi_3481_;
                                        if _e1073 {
                                            if _e1020 {
                                                phi_3490_ = _e920.member_1;
                                            } else {
                                                phi_3490_ = _e920.member_2;
                                            }
                                            let _e1077 = phi_3490_;
                                            phi_3495_ = _e1077;
                                            phi_3496_ = select(_e1021, true, _e1020);
                                        } else {
                                            phi_3495_ = _e1069;
                                            phi_3496_ = _e619;
                                        }
                                        let _e1080 = phi_3495_;
                                        let _e1082 = phi_3496_;
                                        phi_3979_ = _e576;
                                        phi_3498_ = _e578;
                                        phi_3499_ = _e1080;
                                        phi_3500_ = _e1082;
                                        phi_3501_ = select(_e1071, _e621, _e1073);
                                    }
                                    let _e1718 = phi_3979_;
                                    let _e1720 = phi_3498_;
                                    let _e1722 = phi_3499_;
                                    let _e1724 = phi_3500_;
                                    let _e1726 = phi_3501_;
                                    phi_3978_ = _e1718;
                                    phi_3502_ = _e1720;
                                    phi_3503_ = _e1722;
                                    phi_3504_ = (_e582 - 1u);
                                    phi_3505_ = _e1724;
                                    phi_3506_ = _e1726;
                                } else {
                                    phi_3978_ = _e576;
                                    phi_3502_ = _e578;
                                    phi_3503_ = _e617;
                                    phi_3504_ = _e582;
                                    phi_3505_ = _e619;
                                    phi_3506_ = _e621;
                                }
                                let _e1728 = phi_3978_;
                                let _e1730 = phi_3502_;
                                let _e1732 = phi_3503_;
                                let _e1734 = phi_3504_;
                                let _e1736 = phi_3505_;
                                let _e1738 = phi_3506_;
                                phi_3977_ = _e1728;
                                phi_3507_ = _e1730;
                                phi_3508_ = _e1732;
                                phi_3509_ = _e1734;
                                phi_3510_ = _e1736;
                                phi_3511_ = _e1738;
                            } else {
                                phi_3977_ = _e576;
                                phi_3507_ = type_47();
                                phi_3508_ = type_62();
                                phi_3509_ = u32();
                                phi_3510_ = bool();
                                phi_3511_ = u32();
                            }
                            let _e1740 = phi_3977_;
                            let _e1742 = phi_3507_;
                            let _e1744 = phi_3508_;
                            let _e1746 = phi_3509_;
                            let _e1748 = phi_3510_;
                            let _e1750 = phi_3511_;
                            phi_3976_ = _e1740;
                            phi_957_ = _e1742;
                            phi_960_ = _e1744;
                            phi_962_ = _e1746;
                            phi_964_ = _e1748;
                            phi_966_ = _e1750;
                            phi_3512_ = _e590;
                        } else {
                            phi_3976_ = _e576;
                            phi_957_ = type_47();
                            phi_960_ = type_62();
                            phi_962_ = u32();
                            phi_964_ = bool();
                            phi_966_ = u32();
                            phi_3512_ = false;
                        }
                        let _e1752 = phi_3976_;
                        let _e1754 = phi_957_;
                        let _e1756 = phi_960_;
                        let _e1758 = phi_962_;
                        let _e1760 = phi_964_;
                        let _e1762 = phi_966_;
                        let _e1764 = phi_3512_;
                        continue;
                        continuing {
                            phi_3843_ = _e1752;
                            phi_956_ = _e1754;
                            phi_959_ = _e1756;
                            phi_961_ = _e1758;
                            phi_963_ = _e1760;
                            phi_965_ = _e1762;
                            phi_3975_ = _e1752;
                            break if !(_e1764);
                        }
                    }
                    let _e1767 = phi_3975_;
                    if _e1767 {
                        break;
                    }
                    let _e1769 = local_10;
                    if (_e1769.member.member_3 != 4294967295u) {
                        let _e1774 = (_e358 / 3i);
                        let _e1781 = bitcast<f32>((bitcast<u32>((_e1774 + 127i)) << bitcast<u32>(23i)));
                        let _e1789 = (((_e1769.member.member * _e1781) * _e1781) * bitcast<f32>((bitcast<u32>(((_e358 - (2i * _e1774)) + 127i)) << bitcast<u32>(23i))));
                        let _e1791 = select(340282350000000000000000000000000000000f, _e1789, (_e1789 < 340282350000000000000000000000000000000f));
                        phi_3564_ = type_30(select(-340282350000000000000000000000000000000f, _e1791, (_e1791 > -340282350000000000000000000000000000000f)), _e1769.member.member_1, _e1769.member.member_2, _e1769.member.member_3);
                    } else {
                        phi_3564_ = type_30(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                    }
                    let _e1798 = phi_3564_;
                    if _e235 {
                    } else {
                        break;
                    }
                    global_9.member[_e141] = _e1798;
                    if _e156 {
                    } else {
                        break;
                    }
                    let _e1802 = select(0u, 1u, (_e302 <= _e312));
                    if (_e1802 > 0u) {
                        let _e1804 = (1u < _e109);
                        if _e1804 {
                            if (0u < _e109) {
                            } else {
                                break;
                            }
                            let _e1808 = atomicAdd((&global_10.member[0u]), _e1802);
                            if ((_e1808 + _e1802) < _e1808) {
                                if _e1804 {
                                } else {
                                    break;
                                }
                                let _e1813 = atomicAdd((&global_10.member[1u]), 1u);
                            }
                        }
                    }
                    let _e1816 = select(0u, 1u, (_e1798.member_3 != 4294967295u));
                    if (_e1816 > 0u) {
                        let _e1818 = (3u < _e109);
                        if _e1818 {
                            if (2u < _e109) {
                            } else {
                                break;
                            }
                            let _e1822 = atomicAdd((&global_10.member[2u]), _e1816);
                            if ((_e1822 + _e1816) < _e1822) {
                                if _e1818 {
                                } else {
                                    break;
                                }
                                let _e1827 = atomicAdd((&global_10.member[3u]), 1u);
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
