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

struct type_60 {
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
var<storage> global_10: type_60;

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
    var phi_391_: type_40;
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
    var phi_956_: type_43;
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
    var phi_1082_: type_43;
    var phi_1085_: type_8;
    var phi_1086_: type_8;
    var phi_1108_: type_8;
    var phi_1129_: u32;
    var phi_1218_: array<array<f32, 3>, 3>;
    var phi_1689_: vec3<f32>;
    var phi_1690_: vec3<f32>;
    var phi_1721_: bool;
    var phi_1730_: vec3<f32>;
    var phi_1770_: type_26;
    var phi_1772_: type_26;
    var phi_1773_: bool;
    var phi_1777_: type_26;
    var phi_1778_: type_26;
    var phi_1779_: type_26;
    var phi_1780_: bool;
    var phi_1784_: type_26;
    var phi_1785_: bool;
    var phi_1789_: type_26;
    var phi_1790_: bool;
    var phi_1794_: type_26;
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
    var phi_2149_: type_43;
    var phi_2150_: type_43;
    var phi_2151_: type_43;
    var phi_1083_: type_43;
    var phi_3837_: bool;
    var phi_3979_: bool;
    var phi_3498_: type_43;
    var phi_3499_: type_62;
    var phi_3500_: bool;
    var phi_3501_: u32;
    var phi_3978_: bool;
    var phi_3502_: type_43;
    var phi_3503_: type_62;
    var phi_3504_: u32;
    var phi_3505_: bool;
    var phi_3506_: u32;
    var phi_3977_: bool;
    var phi_3507_: type_43;
    var phi_3508_: type_62;
    var phi_3509_: u32;
    var phi_3510_: bool;
    var phi_3511_: u32;
    var phi_3976_: bool;
    var phi_957_: type_43;
    var phi_960_: type_62;
    var phi_962_: u32;
    var phi_964_: bool;
    var phi_966_: u32;
    var phi_3512_: bool;
    var phi_3975_: bool;
    var local_10: type_43;
    var phi_3564_: type_26;
    var local_11: type_43;

    switch bitcast<i32>(0u) {
        default: {
            let _e92 = global;
            let _e94 = arrayLength((&global_10.member));
            let _e96 = arrayLength((&global_4.member));
            let _e108 = arrayLength((&global_9.member));
            let _e112 = global_3.member[0u][0u];
            let _e116 = global_3.member[0u][1u];
            let _e120 = global_3.member[0u][2u];
            let _e124 = global_3.member[0u][3u];
            let _e128 = global_3.member[1u][0u];
            let _e132 = global_3.member[1u][1u];
            let _e136 = global_3.member[1u][2u];
            let _e140 = (_e92.x + (_e92.y * 2097152u));
            let _e152 = bitcast<f32>((bitcast<u32>((bitcast<i32>(_e124) + 127i)) << bitcast<u32>(23i)));
            local_1 = array<i32, 3>(bitcast<i32>(_e112), bitcast<i32>(_e116), bitcast<i32>(_e120));
            local = array<i32, 3>(bitcast<i32>(_e128), bitcast<i32>(_e132), bitcast<i32>(_e136));
            let _e155 = (_e140 < arrayLength((&global_7.member)));
            if _e155 {
                if _e155 {
                } else {
                    break;
                }
                let _e159 = global_7.member[_e140].member_2;
                phi_323_ = _e159;
            } else {
                phi_323_ = 4294967295u;
            }
            let _e161 = phi_323_;
            let _e164 = global_1.member[0u];
            let _e168 = global_2.member[0u][0u];
            let _e172 = global_2.member[0u][1u];
            let _e176 = global_2.member[0u][2u];
            let _e180 = global_2.member[0u][3u];
            let _e184 = global_2.member[1u][0u];
            let _e188 = global_2.member[1u][1u];
            let _e192 = global_2.member[1u][2u];
            let _e196 = global_2.member[1u][3u];
            let _e197 = bitcast<f32>(_e168);
            let _e198 = bitcast<f32>(_e172);
            let _e199 = bitcast<f32>(_e176);
            let _e201 = bitcast<f32>(_e184);
            let _e202 = array<u32, 3>(_e188, _e192, _e196);
            let _e204 = bitcast<i32>(_e164);
            if (_e204 < -126i) {
                phi_367_ = -126i;
            } else {
                phi_367_ = select(_e204, 127i, (_e204 > 127i));
            }
            let _e209 = phi_367_;
            let _e214 = bitcast<f32>((bitcast<u32>((_e209 + 127i)) << bitcast<u32>(23i)));
            let _e220 = bitcast<f32>((bitcast<u32>(((_e204 - _e209) + 127i)) << bitcast<u32>(23i)));
            if (_e180 == 0u) {
                phi_391_ = type_40(array<f32, 3>(_e197, _e198, _e199), _e180, _e201, _e202);
            } else {
                phi_391_ = type_40(array<f32, 3>(((_e197 * _e214) * _e220), ((_e198 * _e214) * _e220), ((_e199 * _e214) * _e220)), _e180, ((_e201 * _e214) * _e220), _e202);
            }
            let _e233 = phi_391_;
            if _e155 {
                let _e234 = (_e140 < arrayLength((&global_8.member)));
                if _e234 {
                    if _e155 {
                    } else {
                        break;
                    }
                    let _e244 = global_7.member[_e140].member.member_2[0u];
                    let _e246 = (bitcast<u32>(_e244) & 2147483647u);
                    let _e252 = global_7.member[_e140].member.member_2[1u];
                    let _e254 = (bitcast<u32>(_e252) & 2147483647u);
                    let _e260 = global_7.member[_e140].member.member_2[2u];
                    let _e262 = (bitcast<u32>(_e260) & 2147483647u);
                    let _e268 = global_7.member[_e140].member.member[0u];
                    let _e270 = (bitcast<u32>(_e268) & 2147483647u);
                    let _e276 = global_7.member[_e140].member.member[1u];
                    let _e278 = (bitcast<u32>(_e276) & 2147483647u);
                    let _e284 = global_7.member[_e140].member.member[2u];
                    let _e286 = (bitcast<u32>(_e284) & 2147483647u);
                    let _e288 = select(_e254, _e246, (_e254 < _e246));
                    let _e290 = select(_e262, _e288, (_e262 < _e288));
                    let _e292 = select(_e270, _e290, (_e270 < _e290));
                    let _e294 = select(_e278, _e292, (_e278 < _e292));
                    let _e296 = select(_e286, _e294, (_e286 < _e294));
                    let _e301 = global_7.member[_e140].member.member_1;
                    let _e303 = (bitcast<u32>(_e301) & 2147483647u);
                    let _e311 = global_7.member[_e140].member.member_3;
                    let _e317 = (((select(_e303, _e296, (_e303 < _e296)) < 2139095040u) && ((bitcast<u32>(_e311) & 2147483647u) <= 2139095040u)) && (_e290 > 0u));
                    if _e317 {
                        let _e320 = (bitcast<u32>(bitcast<f32>(_e290)) & 2147483647u);
                        if (_e320 >= 8388608u) {
                            phi_497_ = (bitcast<i32>((_e320 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_497_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e320)), 32u, (_e320 == 0u))));
                        }
                        let _e334 = phi_497_;
                        phi_498_ = _e334;
                    } else {
                        phi_498_ = 0i;
                    }
                    let _e336 = phi_498_;
                    let _e337 = (_e246 == _e290);
                    if _e337 {
                        phi_508_ = true;
                    } else {
                        phi_508_ = (_e254 == _e290);
                    }
                    let _e340 = phi_508_;
                    let _e341 = select(1u, 0u, _e337);
                    if _e340 {
                        let _e342 = (_e341 + 1u);
                        phi_518_ = _e342;
                        phi_519_ = _e342;
                        phi_521_ = select(true, false, (_e342 == 2u));
                    } else {
                        phi_518_ = u32();
                        phi_519_ = 0u;
                        phi_521_ = true;
                    }
                    let _e346 = phi_518_;
                    let _e348 = phi_519_;
                    let _e350 = phi_521_;
                    if _e350 {
                        phi_526_ = (_e348 + 1u);
                    } else {
                        phi_526_ = 0u;
                    }
                    let _e354 = phi_526_;
                    let _e355 = select(_e346, _e348, _e350);
                    let _e356 = select(_e341, select(2u, _e341, _e340), _e350);
                    let _e357 = -(_e336);
                    if (_e357 < -126i) {
                        phi_559_ = -126i;
                    } else {
                        phi_559_ = select(_e357, 127i, (_e357 > 127i));
                    }
                    let _e362 = phi_559_;
                    let _e367 = bitcast<f32>((bitcast<u32>((_e362 + 127i)) << bitcast<u32>(23i)));
                    let _e373 = bitcast<f32>((bitcast<u32>(((_e357 - _e362) + 127i)) << bitcast<u32>(23i)));
                    let _e378 = global_7.member[_e140].member.member;
                    let _e379 = (_e355 == 0u);
                    if _e379 {
                        phi_577_ = _e378[0];
                    } else {
                        phi_577_ = _e378[1];
                    }
                    let _e383 = phi_577_;
                    let _e384 = (_e355 == 2u);
                    if _e384 {
                        phi_583_ = _e378[2];
                    } else {
                        phi_583_ = _e383;
                    }
                    let _e387 = phi_583_;
                    let _e388 = global_7.member[_e140].member.member_2;
                    if _e379 {
                        phi_594_ = _e388[0];
                    } else {
                        phi_594_ = _e388[1];
                    }
                    let _e392 = phi_594_;
                    if _e384 {
                        phi_600_ = _e388[2];
                    } else {
                        phi_600_ = _e392;
                    }
                    let _e395 = phi_600_;
                    let _e397 = ((_e395 * _e367) * _e373);
                    let _e401 = (bitcast<f32>((bitcast<u32>(_e397) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e401 {
                        let _e405 = (bitcast<f32>((bitcast<u32>(_e387) & 2147483647u)) * 0.00000011920929f);
                        phi_623_ = select(0.00000000000011368684f, _e405, (_e405 > 0.00000000000011368684f));
                    } else {
                        phi_623_ = 0f;
                    }
                    let _e409 = phi_623_;
                    let _e410 = (_e387 + _e409);
                    let _e411 = (_e387 - _e409);
                    let _e412 = select(_e397, 0f, _e401);
                    if _e401 {
                        phi_634_ = 38685626000000000000000000f;
                    } else {
                        phi_634_ = (1f / _e397);
                    }
                    let _e415 = phi_634_;
                    let _e416 = (_e354 == 0u);
                    if _e416 {
                        phi_643_ = _e378[0];
                    } else {
                        phi_643_ = _e378[1];
                    }
                    let _e420 = phi_643_;
                    let _e421 = (_e354 == 2u);
                    if _e421 {
                        phi_649_ = _e378[2];
                    } else {
                        phi_649_ = _e420;
                    }
                    let _e424 = phi_649_;
                    if _e416 {
                        phi_660_ = _e388[0];
                    } else {
                        phi_660_ = _e388[1];
                    }
                    let _e428 = phi_660_;
                    if _e421 {
                        phi_666_ = _e388[2];
                    } else {
                        phi_666_ = _e428;
                    }
                    let _e431 = phi_666_;
                    let _e433 = ((_e431 * _e367) * _e373);
                    let _e437 = (bitcast<f32>((bitcast<u32>(_e433) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e437 {
                        let _e441 = (bitcast<f32>((bitcast<u32>(_e424) & 2147483647u)) * 0.00000011920929f);
                        phi_689_ = select(0.00000000000011368684f, _e441, (_e441 > 0.00000000000011368684f));
                    } else {
                        phi_689_ = 0f;
                    }
                    let _e445 = phi_689_;
                    let _e446 = (_e424 + _e445);
                    let _e447 = (_e424 - _e445);
                    let _e448 = select(_e433, 0f, _e437);
                    if _e437 {
                        phi_700_ = 38685626000000000000000000f;
                    } else {
                        phi_700_ = (1f / _e433);
                    }
                    let _e451 = phi_700_;
                    let _e452 = (_e356 == 0u);
                    if _e452 {
                        phi_709_ = _e378[0];
                    } else {
                        phi_709_ = _e378[1];
                    }
                    let _e456 = phi_709_;
                    let _e457 = (_e356 == 2u);
                    if _e457 {
                        phi_715_ = _e378[2];
                    } else {
                        phi_715_ = _e456;
                    }
                    let _e460 = phi_715_;
                    if _e452 {
                        phi_726_ = _e388[0];
                    } else {
                        phi_726_ = _e388[1];
                    }
                    let _e464 = phi_726_;
                    if _e457 {
                        phi_732_ = _e388[2];
                    } else {
                        phi_732_ = _e464;
                    }
                    let _e467 = phi_732_;
                    let _e469 = ((_e467 * _e367) * _e373);
                    let _e473 = (bitcast<f32>((bitcast<u32>(_e469) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e473 {
                        let _e477 = (bitcast<f32>((bitcast<u32>(_e460) & 2147483647u)) * 0.00000011920929f);
                        phi_755_ = select(0.00000000000011368684f, _e477, (_e477 > 0.00000000000011368684f));
                    } else {
                        phi_755_ = 0f;
                    }
                    let _e481 = phi_755_;
                    let _e482 = (_e460 + _e481);
                    let _e483 = (_e460 - _e481);
                    let _e484 = select(_e469, 0f, _e473);
                    if _e473 {
                        phi_766_ = 38685626000000000000000000f;
                    } else {
                        phi_766_ = (1f / _e469);
                    }
                    let _e487 = phi_766_;
                    let _e490 = bitcast<f32>((bitcast<u32>(_e387) & 2147483647u));
                    let _e493 = bitcast<f32>((bitcast<u32>(_e424) & 2147483647u));
                    let _e495 = select(_e493, _e490, (_e490 > _e493));
                    let _e498 = bitcast<f32>((bitcast<u32>(_e460) & 2147483647u));
                    if (_e317 && (select(_e498, _e495, (_e495 > _e498)) <= 1099511600000f)) {
                        let _e503 = (_e336 / 3i);
                        let _e510 = bitcast<f32>((bitcast<u32>((_e503 + 127i)) << bitcast<u32>(23i)));
                        let _e517 = bitcast<f32>((bitcast<u32>(((_e336 - (2i * _e503)) + 127i)) << bitcast<u32>(23i)));
                        let _e518 = (((_e301 * _e510) * _e510) * _e517);
                        let _e520 = select(340282350000000000000000000000000000000f, _e518, (_e518 < 340282350000000000000000000000000000000f));
                        let _e525 = (((_e311 * _e510) * _e510) * _e517);
                        let _e527 = select(340282350000000000000000000000000000000f, _e525, (_e525 < 340282350000000000000000000000000000000f));
                        phi_866_ = select(-340282350000000000000000000000000000000f, _e527, (_e527 > -340282350000000000000000000000000000000f));
                        phi_867_ = select(-340282350000000000000000000000000000000f, _e520, (_e520 > -340282350000000000000000000000000000000f));
                    } else {
                        phi_866_ = 0f;
                        phi_867_ = 1f;
                    }
                    let _e531 = phi_866_;
                    let _e533 = phi_867_;
                    local_8 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                    local_7 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_6 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_5 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_4 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_3 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_9 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    let _e537 = (_e355 % 3u);
                    let _e538 = (_e537 < 3u);
                    if _e538 {
                    } else {
                        break;
                    }
                    let _e540 = local_1[_e537];
                    let _e543 = (_e354 % 3u);
                    let _e544 = (_e543 < 3u);
                    if _e544 {
                    } else {
                        break;
                    }
                    let _e546 = local_1[_e543];
                    let _e549 = (_e356 % 3u);
                    let _e550 = (_e549 < 3u);
                    if _e550 {
                    } else {
                        break;
                    }
                    let _e552 = local_1[_e549];
                    if _e538 {
                    } else {
                        break;
                    }
                    let _e557 = local[_e537];
                    if _e544 {
                    } else {
                        break;
                    }
                    let _e561 = local[_e543];
                    if _e550 {
                    } else {
                        break;
                    }
                    let _e565 = local[_e549];
                    phi_3843_ = false;
                    phi_956_ = type_43(type_26(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e531);
                    phi_959_ = type_62(type_38(vec4<f32>((f32(_e540) * _e152), (f32(_e546) * _e152), (f32(_e552) * _e152), 0f), vec4<f32>((f32(_e557) * _e152), (f32(_e561) * _e152), (f32(_e565) * _e152), 0f)), select(0u, 2147483648u, (_e94 == 0u)));
                    phi_961_ = ((3u * _e94) + 1u);
                    phi_963_ = (_e533 <= _e531);
                    phi_965_ = 0u;
                    loop {
                        let _e575 = phi_3843_;
                        let _e577 = phi_956_;
                        let _e579 = phi_959_;
                        let _e581 = phi_961_;
                        let _e583 = phi_963_;
                        let _e585 = phi_965_;
                        local_10 = _e577;
                        if _e583 {
                            phi_976_ = true;
                        } else {
                            phi_976_ = (_e585 > 0u);
                        }
                        let _e588 = phi_976_;
                        if _e588 {
                            let _e589 = (_e581 > 0u);
                            if _e589 {
                                if _e583 {
                                    phi_1062_ = _e579;
                                    phi_1063_ = _e583;
                                    phi_1064_ = _e585;
                                } else {
                                    let _e590 = (_e585 - 1u);
                                    let _e591 = (_e590 % 128u);
                                    let _e592 = (_e591 < 128u);
                                    if _e592 {
                                    } else {
                                        phi_3975_ = true;
                                        break;
                                    }
                                    let _e594 = local_7[_e591];
                                    if _e592 {
                                    } else {
                                        phi_3975_ = true;
                                        break;
                                    }
                                    let _e596 = local_6[_e591];
                                    if _e592 {
                                    } else {
                                        phi_3975_ = true;
                                        break;
                                    }
                                    let _e598 = local_5[_e591];
                                    if _e592 {
                                    } else {
                                        phi_3975_ = true;
                                        break;
                                    }
                                    let _e600 = local_4[_e591];
                                    if _e592 {
                                    } else {
                                        phi_3975_ = true;
                                        break;
                                    }
                                    let _e602 = local_3[_e591];
                                    if _e592 {
                                    } else {
                                        phi_3975_ = true;
                                        break;
                                    }
                                    let _e604 = local_2[_e591];
                                    if _e592 {
                                    } else {
                                        phi_3975_ = true;
                                        break;
                                    }
                                    let _e609 = local_8[_e591];
                                    if _e592 {
                                    } else {
                                        phi_3975_ = true;
                                        break;
                                    }
                                    let _e612 = local_9[_e591];
                                    phi_1062_ = type_62(type_38(vec4<f32>(_e594, _e596, _e598, 0f), vec4<f32>(_e600, _e602, _e604, 0f)), _e609);
                                    phi_1063_ = (_e612 <= _e577.member_1);
                                    phi_1064_ = _e590;
                                }
                                let _e616 = phi_1062_;
                                let _e618 = phi_1063_;
                                let _e620 = phi_1064_;
                                if _e618 {
                                    if ((_e616.member_1 & 2147483648u) != 0u) {
                                        phi_1082_ = _e577;
                                        phi_1085_ = type_8(0u, ((_e616.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e1085 = phi_1082_;
                                            let _e1087 = phi_1085_;
                                            local_11 = _e1085;
                                            if (_e1087.member < _e1087.member_1) {
                                                phi_1086_ = type_8((_e1087.member + 1u), _e1087.member_1);
                                                phi_1108_ = type_8(1u, _e1087.member);
                                            } else {
                                                phi_1086_ = _e1087;
                                                phi_1108_ = type_8(0u, type_8().member_1);
                                            }
                                            let _e1100 = phi_1086_;
                                            let _e1102 = phi_1108_;
                                            let _e1106 = (bitcast<i32>(_e1102.member) != 0i);
                                            if _e1106 {
                                                let _e1107 = ((_e616.member_1 & 268435455u) + _e1102.member_1);
                                                let _e1108 = (_e1107 < _e96);
                                                if _e1108 {
                                                    if _e1108 {
                                                    } else {
                                                        phi_3837_ = true;
                                                        break;
                                                    }
                                                    let _e1112 = global_4.member[_e1107].member_1;
                                                    phi_1129_ = _e1112;
                                                } else {
                                                    phi_1129_ = 4294967295u;
                                                }
                                                let _e1114 = phi_1129_;
                                                if (_e1107 >= _e96) {
                                                    phi_1218_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                } else {
                                                    if _e1108 {
                                                    } else {
                                                        phi_3837_ = true;
                                                        break;
                                                    }
                                                    if (_e537 < 9u) {
                                                    } else {
                                                        phi_3837_ = true;
                                                        break;
                                                    }
                                                    let _e1121 = global_4.member[_e1107].member[_e537];
                                                    if (_e543 < 9u) {
                                                    } else {
                                                        phi_3837_ = true;
                                                        break;
                                                    }
                                                    let _e1127 = global_4.member[_e1107].member[_e543];
                                                    if (_e549 < 9u) {
                                                    } else {
                                                        phi_3837_ = true;
                                                        break;
                                                    }
                                                    let _e1133 = global_4.member[_e1107].member[_e549];
                                                    let _e1135 = (3u + _e537);
                                                    if (_e1135 < 9u) {
                                                    } else {
                                                        phi_3837_ = true;
                                                        break;
                                                    }
                                                    let _e1141 = global_4.member[_e1107].member[_e1135];
                                                    let _e1142 = (3u + _e543);
                                                    if (_e1142 < 9u) {
                                                    } else {
                                                        phi_3837_ = true;
                                                        break;
                                                    }
                                                    let _e1148 = global_4.member[_e1107].member[_e1142];
                                                    let _e1149 = (3u + _e549);
                                                    if (_e1149 < 9u) {
                                                    } else {
                                                        phi_3837_ = true;
                                                        break;
                                                    }
                                                    let _e1155 = global_4.member[_e1107].member[_e1149];
                                                    let _e1157 = (6u + _e537);
                                                    if (_e1157 < 9u) {
                                                    } else {
                                                        phi_3837_ = true;
                                                        break;
                                                    }
                                                    let _e1163 = global_4.member[_e1107].member[_e1157];
                                                    let _e1164 = (6u + _e543);
                                                    if (_e1164 < 9u) {
                                                    } else {
                                                        phi_3837_ = true;
                                                        break;
                                                    }
                                                    let _e1170 = global_4.member[_e1107].member[_e1164];
                                                    let _e1171 = (6u + _e549);
                                                    if (_e1171 < 9u) {
                                                    } else {
                                                        phi_3837_ = true;
                                                        break;
                                                    }
                                                    let _e1177 = global_4.member[_e1107].member[_e1171];
                                                    phi_1218_ = array<array<f32, 3>, 3>(array<f32, 3>(_e1121, _e1127, _e1133), array<f32, 3>(_e1141, _e1148, _e1155), array<f32, 3>(_e1163, _e1170, _e1177));
                                                }
                                                let _e1181 = phi_1218_;
                                                let _e1189 = (_e1181[0][2] - _e460);
                                                let _e1192 = (((_e1181[0][0] - _e387) * _e484) - (_e1189 * _e412));
                                                let _e1195 = (((_e1181[0][1] - _e424) * _e484) - (_e1189 * _e448));
                                                let _e1202 = (_e1181[1][2] - _e460);
                                                let _e1205 = (((_e1181[1][0] - _e387) * _e484) - (_e1202 * _e412));
                                                let _e1208 = (((_e1181[1][1] - _e424) * _e484) - (_e1202 * _e448));
                                                let _e1215 = (_e1181[2][2] - _e460);
                                                let _e1218 = (((_e1181[2][0] - _e387) * _e484) - (_e1215 * _e412));
                                                let _e1221 = (((_e1181[2][1] - _e424) * _e484) - (_e1215 * _e448));
                                                let _e1222 = (_e1218 * _e1208);
                                                let _e1223 = (_e1221 * _e1205);
                                                let _e1224 = (_e1192 * _e1221);
                                                let _e1225 = (_e1195 * _e1218);
                                                let _e1226 = (_e1205 * _e1195);
                                                let _e1227 = (_e1208 * _e1192);
                                                let _e1232 = (((_e1222 >= _e1223) && (_e1224 >= _e1225)) && (_e1226 >= _e1227));
                                                if (_e1232 || (((_e1222 <= _e1223) && (_e1224 <= _e1225)) && (_e1226 <= _e1227))) {
                                                    let _e1239 = select(-1f, 1f, _e1232);
                                                    let _e1241 = ((_e1222 - _e1223) * _e1239);
                                                    let _e1243 = select(0f, _e1241, (_e1241 > 0f));
                                                    let _e1245 = ((_e1224 - _e1225) * _e1239);
                                                    let _e1247 = select(0f, _e1245, (_e1245 > 0f));
                                                    let _e1249 = ((_e1226 - _e1227) * _e1239);
                                                    let _e1251 = select(0f, _e1249, (_e1249 > 0f));
                                                    let _e1253 = ((_e1243 + _e1247) + _e1251);
                                                    if (_e1253 < 0.000000000000000000000000000000000000011754944f) {
                                                        phi_1784_ = type_26();
                                                        phi_1785_ = true;
                                                    } else {
                                                        let _e1256 = select(_e1181[1][0], _e1181[0][0], (_e1181[0][0] < _e1181[1][0]));
                                                        let _e1260 = select(_e1181[1][0], _e1181[0][0], (_e1181[0][0] > _e1181[1][0]));
                                                        let _e1264 = select(_e1181[1][1], _e1181[0][1], (_e1181[0][1] < _e1181[1][1]));
                                                        let _e1268 = select(_e1181[1][1], _e1181[0][1], (_e1181[0][1] > _e1181[1][1]));
                                                        let _e1272 = select(_e1181[1][2], _e1181[0][2], (_e1181[0][2] < _e1181[1][2]));
                                                        let _e1276 = select(_e1181[1][2], _e1181[0][2], (_e1181[0][2] > _e1181[1][2]));
                                                        let _e1281 = ((select(_e1181[2][0], _e1256, (_e1256 < _e1181[2][0])) - _e410) * _e415);
                                                        let _e1282 = ((select(_e1181[2][0], _e1260, (_e1260 > _e1181[2][0])) - _e411) * _e415);
                                                        let _e1285 = ((select(_e1181[2][1], _e1264, (_e1264 < _e1181[2][1])) - _e446) * _e451);
                                                        let _e1286 = ((select(_e1181[2][1], _e1268, (_e1268 > _e1181[2][1])) - _e447) * _e451);
                                                        let _e1289 = ((select(_e1181[2][2], _e1272, (_e1272 < _e1181[2][2])) - _e482) * _e487);
                                                        let _e1290 = ((select(_e1181[2][2], _e1276, (_e1276 > _e1181[2][2])) - _e483) * _e487);
                                                        let _e1292 = select(_e1290, _e1289, (_e1289 < _e1290));
                                                        let _e1294 = select(_e1290, _e1289, (_e1289 > _e1290));
                                                        let _e1296 = select(_e1282, _e1281, (_e1281 < _e1282));
                                                        let _e1298 = select(_e1286, _e1285, (_e1285 < _e1286));
                                                        let _e1300 = select(_e1298, _e1296, (_e1296 > _e1298));
                                                        let _e1302 = select(_e1292, _e1300, (_e1300 > _e1292));
                                                        let _e1304 = select(_e1282, _e1281, (_e1281 > _e1282));
                                                        let _e1306 = select(_e1286, _e1285, (_e1285 > _e1286));
                                                        let _e1308 = select(_e1306, _e1304, (_e1304 < _e1306));
                                                        let _e1310 = select(_e1294, _e1308, (_e1308 < _e1294));
                                                        let _e1311 = -(_e1292);
                                                        let _e1317 = select(_e533, _e1302, (_e1302 > _e533));
                                                        if (_e1317 > (_e1310 + (select(_e1311, _e1294, (_e1294 > _e1311)) * 0.0000019073523f))) {
                                                            phi_1779_ = type_26();
                                                            phi_1780_ = true;
                                                        } else {
                                                            let _e1319 = (_e1317 > _e1085.member_1);
                                                            if _e1319 {
                                                                phi_1778_ = type_26();
                                                            } else {
                                                                let _e1323 = (_e1181[1][0] - _e1181[0][0]);
                                                                let _e1324 = (_e1181[1][1] - _e1181[0][1]);
                                                                let _e1325 = (_e1181[1][2] - _e1181[0][2]);
                                                                let _e1326 = vec3<f32>(_e1323, _e1324, _e1325);
                                                                let _e1327 = (_e1181[2][0] - _e1181[1][0]);
                                                                let _e1328 = (_e1181[2][1] - _e1181[1][1]);
                                                                let _e1329 = (_e1181[2][2] - _e1181[1][2]);
                                                                let _e1330 = vec3<f32>(_e1327, _e1328, _e1329);
                                                                let _e1331 = (_e1181[0][0] - _e1181[2][0]);
                                                                let _e1332 = (_e1181[0][1] - _e1181[2][1]);
                                                                let _e1333 = (_e1181[0][2] - _e1181[2][2]);
                                                                let _e1334 = vec3<f32>(_e1331, _e1332, _e1333);
                                                                let _e1337 = bitcast<f32>((bitcast<u32>(_e1323) & 2147483647u));
                                                                let _e1340 = bitcast<f32>((bitcast<u32>(_e1324) & 2147483647u));
                                                                let _e1342 = select(_e1340, _e1337, (_e1337 > _e1340));
                                                                let _e1345 = bitcast<f32>((bitcast<u32>(_e1325) & 2147483647u));
                                                                let _e1347 = select(_e1345, _e1342, (_e1342 > _e1345));
                                                                let _e1350 = bitcast<f32>((bitcast<u32>(_e1327) & 2147483647u));
                                                                let _e1353 = bitcast<f32>((bitcast<u32>(_e1328) & 2147483647u));
                                                                let _e1355 = select(_e1353, _e1350, (_e1350 > _e1353));
                                                                let _e1358 = bitcast<f32>((bitcast<u32>(_e1329) & 2147483647u));
                                                                let _e1360 = select(_e1358, _e1355, (_e1355 > _e1358));
                                                                let _e1363 = bitcast<f32>((bitcast<u32>(_e1331) & 2147483647u));
                                                                let _e1366 = bitcast<f32>((bitcast<u32>(_e1332) & 2147483647u));
                                                                let _e1368 = select(_e1366, _e1363, (_e1363 > _e1366));
                                                                let _e1371 = bitcast<f32>((bitcast<u32>(_e1333) & 2147483647u));
                                                                let _e1373 = select(_e1371, _e1368, (_e1368 > _e1371));
                                                                let _e1375 = select(_e1360, _e1347, (_e1347 > _e1360));
                                                                let _e1377 = select(_e1373, _e1375, (_e1375 > _e1373));
                                                                if (_e1347 == _e1377) {
                                                                    phi_1689_ = _e1330;
                                                                    phi_1690_ = _e1334;
                                                                } else {
                                                                    let _e1380 = vec3((_e1360 == _e1377));
                                                                    phi_1689_ = select(_e1326, _e1334, _e1380);
                                                                    phi_1690_ = select(_e1330, _e1326, _e1380);
                                                                }
                                                                let _e1384 = phi_1689_;
                                                                let _e1386 = phi_1690_;
                                                                let _e1393 = ((_e1384.y * _e1386.z) - (_e1386.y * _e1384.z));
                                                                let _e1398 = ((_e1384.z * _e1386.x) - (_e1386.z * _e1384.x));
                                                                let _e1401 = ((_e1384.x * _e1386.y) - (_e1386.x * _e1384.y));
                                                                if (_e1243 >= _e1247) {
                                                                    phi_1721_ = select(true, false, (_e1243 >= _e1251));
                                                                } else {
                                                                    phi_1721_ = true;
                                                                }
                                                                let _e1406 = phi_1721_;
                                                                if _e1406 {
                                                                    phi_1730_ = select(vec3<f32>(_e1181[2][0], _e1181[2][1], _e1181[2][2]), vec3<f32>(_e1181[1][0], _e1181[1][1], _e1181[1][2]), vec3((_e1247 >= _e1251)));
                                                                } else {
                                                                    phi_1730_ = vec3<f32>(_e1181[0][0], _e1181[0][1], _e1181[0][2]);
                                                                }
                                                                let _e1411 = phi_1730_;
                                                                let _e1428 = ((((_e1393 * (_e1411.x - _e387)) + (_e1398 * (_e1411.y - _e424))) + (_e1401 * (_e1411.z - _e460))) / (((_e1393 * _e412) + (_e1398 * _e448)) + (_e1401 * _e484)));
                                                                let _e1430 = select(_e1310, _e1428, (_e1428 < _e1310));
                                                                let _e1432 = select(_e1302, _e1430, (_e1430 > _e1302));
                                                                if (_e1432 >= _e533) {
                                                                    let _e1434 = (_e1432 <= _e1085.member_1);
                                                                    if _e1434 {
                                                                        let _e1435 = (1f / _e1253);
                                                                        phi_1770_ = type_26(_e1432, (_e1247 * _e1435), (_e1251 * _e1435), _e1114);
                                                                    } else {
                                                                        phi_1770_ = type_26();
                                                                    }
                                                                    let _e1440 = phi_1770_;
                                                                    phi_1772_ = _e1440;
                                                                    phi_1773_ = select(true, false, _e1434);
                                                                } else {
                                                                    phi_1772_ = type_26();
                                                                    phi_1773_ = true;
                                                                }
                                                                let _e1443 = phi_1772_;
                                                                let _e1445 = phi_1773_;
                                                                if _e1445 {
                                                                    phi_1777_ = type_26(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                } else {
                                                                    phi_1777_ = _e1443;
                                                                }
                                                                let _e1447 = phi_1777_;
                                                                phi_1778_ = _e1447;
                                                            }
                                                            let _e1449 = phi_1778_;
                                                            phi_1779_ = _e1449;
                                                            phi_1780_ = _e1319;
                                                        }
                                                        let _e1451 = phi_1779_;
                                                        let _e1453 = phi_1780_;
                                                        phi_1784_ = _e1451;
                                                        phi_1785_ = _e1453;
                                                    }
                                                    let _e1455 = phi_1784_;
                                                    let _e1457 = phi_1785_;
                                                    phi_1789_ = _e1455;
                                                    phi_1790_ = _e1457;
                                                } else {
                                                    phi_1789_ = type_26();
                                                    phi_1790_ = true;
                                                }
                                                let _e1459 = phi_1789_;
                                                let _e1461 = phi_1790_;
                                                if _e1461 {
                                                    phi_1794_ = type_26(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                } else {
                                                    phi_1794_ = _e1459;
                                                }
                                                let _e1463 = phi_1794_;
                                                if (_e1463.member_3 != 4294967295u) {
                                                    if (_e1114 == _e161) {
                                                        phi_2123_ = false;
                                                    } else {
                                                        let _e1467 = (_e1114 < arrayLength((&global_5.member)));
                                                        if _e1467 {
                                                            if _e1467 {
                                                            } else {
                                                                phi_3837_ = true;
                                                                break;
                                                            }
                                                            let _e1469 = global_5.member[_e1114];
                                                            phi_1817_ = _e1469;
                                                        } else {
                                                            phi_1817_ = 4294967295u;
                                                        }
                                                        let _e1471 = phi_1817_;
                                                        let _e1472 = (_e1471 < arrayLength((&global_6.member)));
                                                        if _e1472 {
                                                            if _e1472 {
                                                            } else {
                                                                phi_3837_ = true;
                                                                break;
                                                            }
                                                            let _e1474 = global_6.member[_e1471];
                                                            phi_1831_ = _e1474;
                                                        } else {
                                                            phi_1831_ = 0i;
                                                        }
                                                        let _e1476 = phi_1831_;
                                                        let _e1477 = (_e1476 == 0i);
                                                        if _e1477 {
                                                            phi_2122_ = true;
                                                        } else {
                                                            if _e379 {
                                                                phi_1852_ = vec3<f32>(_e1181[0][0], _e1181[0][1], _e1181[0][2]);
                                                            } else {
                                                                if (_e355 == 1u) {
                                                                    phi_1851_ = vec3<f32>(_e1181[0][2], _e1181[0][0], _e1181[0][1]);
                                                                } else {
                                                                    phi_1851_ = vec3<f32>(_e1181[0][1], _e1181[0][2], _e1181[0][0]);
                                                                }
                                                                let _e1482 = phi_1851_;
                                                                phi_1852_ = _e1482;
                                                            }
                                                            let _e1485 = phi_1852_;
                                                            if _e379 {
                                                                phi_1869_ = vec3<f32>(_e1181[1][0], _e1181[1][1], _e1181[1][2]);
                                                            } else {
                                                                if (_e355 == 1u) {
                                                                    phi_1868_ = vec3<f32>(_e1181[1][2], _e1181[1][0], _e1181[1][1]);
                                                                } else {
                                                                    phi_1868_ = vec3<f32>(_e1181[1][1], _e1181[1][2], _e1181[1][0]);
                                                                }
                                                                let _e1490 = phi_1868_;
                                                                phi_1869_ = _e1490;
                                                            }
                                                            let _e1493 = phi_1869_;
                                                            if _e379 {
                                                                phi_1886_ = vec3<f32>(_e1181[2][0], _e1181[2][1], _e1181[2][2]);
                                                            } else {
                                                                if (_e355 == 1u) {
                                                                    phi_1885_ = vec3<f32>(_e1181[2][2], _e1181[2][0], _e1181[2][1]);
                                                                } else {
                                                                    phi_1885_ = vec3<f32>(_e1181[2][1], _e1181[2][2], _e1181[2][0]);
                                                                }
                                                                let _e1498 = phi_1885_;
                                                                phi_1886_ = _e1498;
                                                            }
                                                            let _e1501 = phi_1886_;
                                                            let _e1504 = (_e1493.x - _e1485.x);
                                                            let _e1507 = (_e1493.y - _e1485.y);
                                                            let _e1510 = (_e1493.z - _e1485.z);
                                                            let _e1512 = (_e1501.x - _e1485.x);
                                                            let _e1514 = (_e1501.y - _e1485.y);
                                                            let _e1516 = (_e1501.z - _e1485.z);
                                                            if (_e233.member_1 == 1u) {
                                                                phi_1922_ = (vec3<f32>(_e233.member[0], _e233.member[1], _e233.member[2]) - _e1485);
                                                            } else {
                                                                phi_1922_ = vec3<f32>(_e233.member[0], _e233.member[1], _e233.member[2]);
                                                            }
                                                            let _e1531 = phi_1922_;
                                                            let _e1537 = bitcast<f32>((bitcast<u32>((_e1504 * _e1514)) ^ _e233.member_3[0]));
                                                            let _e1541 = bitcast<f32>((bitcast<u32>((_e1507 * _e1512)) ^ _e233.member_3[0]));
                                                            let _e1545 = bitcast<f32>((bitcast<u32>((_e1507 * _e1516)) ^ _e233.member_3[0]));
                                                            let _e1549 = bitcast<f32>((bitcast<u32>((_e1510 * _e1514)) ^ _e233.member_3[0]));
                                                            let _e1553 = bitcast<f32>((bitcast<u32>((_e1510 * _e1512)) ^ _e233.member_3[0]));
                                                            let _e1557 = bitcast<f32>((bitcast<u32>((_e1504 * _e1516)) ^ _e233.member_3[0]));
                                                            let _e1558 = (_e1545 - _e1549);
                                                            let _e1559 = (_e1553 - _e1557);
                                                            let _e1560 = (_e1537 - _e1541);
                                                            let _e1584 = (bitcast<f32>((bitcast<u32>(_e1545) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1549) & 2147483647u)));
                                                            let _e1591 = (bitcast<f32>((bitcast<u32>(_e1553) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1557) & 2147483647u)));
                                                            let _e1598 = (bitcast<f32>((bitcast<u32>(_e1537) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1541) & 2147483647u)));
                                                            if (_e233.member_2 == 0f) {
                                                                phi_2104_ = 0f;
                                                            } else {
                                                                let _e1628 = bitcast<f32>((bitcast<u32>(_e1558) & 2147483647u));
                                                                let _e1631 = bitcast<f32>((bitcast<u32>(_e1559) & 2147483647u));
                                                                let _e1634 = bitcast<f32>((bitcast<u32>(_e1560) & 2147483647u));
                                                                let _e1636 = select(_e1634, _e1631, (_e1631 > _e1634));
                                                                let _e1640 = select(_e1634, _e1631, (_e1631 < _e1634));
                                                                let _e1644 = select(_e1631, _e1628, (_e1628 < _e1631));
                                                                let _e1646 = select(_e1631, _e1628, (_e1628 > _e1631));
                                                                let _e1648 = select(_e1634, _e1646, (_e1646 < _e1634));
                                                                phi_2104_ = bitcast<f32>((bitcast<u32>((_e233.member_2 * bitcast<f32>((bitcast<u32>(((((select(_e1636, _e1628, (_e1628 > _e1636)) + bitcast<f32>((bitcast<u32>((0.414214f * select(_e1648, _e1644, (_e1644 > _e1648)))) ^ _e233.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.317838f * select(_e1640, _e1628, (_e1628 < _e1640)))) ^ _e233.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.0000004768374f * ((_e1584 + _e1591) + _e1598))) ^ _e233.member_3[0]))) * 1.0000005f)) ^ _e233.member_3[0])))) ^ _e233.member_3[0]));
                                                            }
                                                            let _e1675 = phi_2104_;
                                                            phi_2122_ = (_e1477 || !(((((bitcast<f32>((bitcast<u32>((_e1531.x * _e1558)) ^ _e233.member_3[0])) + bitcast<f32>((bitcast<u32>((_e1531.y * _e1559)) ^ _e233.member_3[0]))) + bitcast<f32>((bitcast<u32>((_e1531.z * _e1560)) ^ _e233.member_3[0]))) * f32(-(_e1476))) > ((bitcast<f32>((bitcast<u32>((0.0000009536752f * ((bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1531.x) & 2147483647u)) * _e1584)) ^ _e233.member_3[0])) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1531.y) & 2147483647u)) * _e1591)) ^ _e233.member_3[0]))) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1531.z) & 2147483647u)) * _e1598)) ^ _e233.member_3[0]))))) ^ _e233.member_3[0])) + _e1675) + 0.0000000000000000000000000000000000001880791f))));
                                                        }
                                                        let _e1689 = phi_2122_;
                                                        phi_2123_ = _e1689;
                                                    }
                                                    let _e1691 = phi_2123_;
                                                    if _e1691 {
                                                        if (_e1463.member < _e1085.member.member) {
                                                            phi_2143_ = true;
                                                        } else {
                                                            if (_e1463.member == _e1085.member.member) {
                                                                phi_2142_ = (_e1463.member_3 < _e1085.member.member_3);
                                                            } else {
                                                                phi_2142_ = false;
                                                            }
                                                            let _e1701 = phi_2142_;
                                                            phi_2143_ = _e1701;
                                                        }
                                                        let _e1703 = phi_2143_;
                                                        if _e1703 {
                                                            phi_2149_ = type_43(_e1463, _e1463.member);
                                                        } else {
                                                            phi_2149_ = _e1085;
                                                        }
                                                        let _e1706 = phi_2149_;
                                                        phi_2150_ = _e1706;
                                                    } else {
                                                        phi_2150_ = _e1085;
                                                    }
                                                    let _e1708 = phi_2150_;
                                                    phi_2151_ = _e1708;
                                                } else {
                                                    phi_2151_ = _e1085;
                                                }
                                                let _e1710 = phi_2151_;
                                                phi_1083_ = _e1710;
                                            } else {
                                                phi_1083_ = type_43();
                                            }
                                            let _e1712 = phi_1083_;
                                            continue;
                                            continuing {
                                                phi_1082_ = _e1712;
                                                phi_1085_ = _e1100;
                                                phi_3837_ = _e575;
                                                break if !(_e1106);
                                            }
                                        }
                                        let _e1715 = phi_3837_;
                                        phi_3975_ = _e1715;
                                        if _e1715 {
                                            break;
                                        }
                                        phi_3979_ = _e1715;
                                        let _e1930 = local_11;
                                        phi_3498_ = _e1930;
                                        phi_3499_ = _e616;
                                        phi_3500_ = false;
                                        phi_3501_ = _e620;
                                    } else {
                                        if (_e616.member_1 >= _e94) {
                                            phi_3054_ = type_63(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), type_62(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u), type_62(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u));
                                        } else {
                                            if (_e616.member_1 < _e94) {
                                            } else {
                                                phi_3975_ = true;
                                                break;
                                            }
                                            let _e633 = ((1u + (_e355 * 2u)) % 7u);
                                            if (_e633 < 7u) {
                                            } else {
                                                phi_3975_ = true;
                                                break;
                                            }
                                            let _e638 = global_10.member[_e616.member_1][_e633];
                                            let _e641 = ((1u + (_e354 * 2u)) % 7u);
                                            if (_e641 < 7u) {
                                            } else {
                                                phi_3975_ = true;
                                                break;
                                            }
                                            let _e646 = global_10.member[_e616.member_1][_e641];
                                            let _e649 = ((1u + (_e356 * 2u)) % 7u);
                                            if (_e649 < 7u) {
                                            } else {
                                                phi_3975_ = true;
                                                break;
                                            }
                                            let _e654 = global_10.member[_e616.member_1][_e649];
                                            let _e657 = (((_e355 + 1u) * 2u) % 7u);
                                            if (_e657 < 7u) {
                                            } else {
                                                phi_3975_ = true;
                                                break;
                                            }
                                            let _e662 = global_10.member[_e616.member_1][_e657];
                                            let _e665 = (((_e354 + 1u) * 2u) % 7u);
                                            if (_e665 < 7u) {
                                            } else {
                                                phi_3975_ = true;
                                                break;
                                            }
                                            let _e670 = global_10.member[_e616.member_1][_e665];
                                            let _e673 = (((_e356 + 1u) * 2u) % 7u);
                                            if (_e673 < 7u) {
                                            } else {
                                                phi_3975_ = true;
                                                break;
                                            }
                                            let _e678 = global_10.member[_e616.member_1][_e673];
                                            let _e701 = (bitcast<f32>((bitcast<u32>((_e616.member.member_1.x - _e616.member.member.x)) & 2139095040u)) * 0.0000009536743f);
                                            let _e702 = (bitcast<f32>((bitcast<u32>((_e616.member.member_1.y - _e616.member.member.y)) & 2139095040u)) * 0.0000009536743f);
                                            let _e703 = (bitcast<f32>((bitcast<u32>((_e616.member.member_1.z - _e616.member.member.z)) & 2139095040u)) * 0.0000009536743f);
                                            let _e705 = select(_e152, _e701, (_e701 > _e152));
                                            let _e707 = select(_e152, _e702, (_e702 > _e152));
                                            let _e709 = select(_e152, _e703, (_e703 > _e152));
                                            let _e734 = bitcast<u32>((f32(bitcast<i32>((_e638 & 2097151u))) * _e705));
                                            let _e739 = (bitcast<i32>((_e638 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e742 = bitcast<f32>((_e734 & bitcast<u32>(_e739)));
                                            let _e743 = bitcast<u32>((f32(bitcast<i32>((_e646 & 2097151u))) * _e707));
                                            let _e748 = (bitcast<i32>((_e646 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e751 = bitcast<f32>((_e743 & bitcast<u32>(_e748)));
                                            let _e752 = bitcast<u32>((f32(bitcast<i32>((_e654 & 2097151u))) * _e709));
                                            let _e757 = (bitcast<i32>((_e654 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e760 = bitcast<f32>((_e752 & bitcast<u32>(_e757)));
                                            let _e764 = bitcast<f32>((_e734 & bitcast<u32>(~(_e739))));
                                            let _e768 = bitcast<f32>((_e743 & bitcast<u32>(~(_e748))));
                                            let _e772 = bitcast<f32>((_e752 & bitcast<u32>(~(_e757))));
                                            let _e773 = bitcast<u32>((f32(bitcast<i32>((_e662 & 2097151u))) * _e705));
                                            let _e778 = (bitcast<i32>((_e662 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e781 = bitcast<f32>((_e773 & bitcast<u32>(_e778)));
                                            let _e782 = bitcast<u32>((f32(bitcast<i32>((_e670 & 2097151u))) * _e707));
                                            let _e787 = (bitcast<i32>((_e670 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e790 = bitcast<f32>((_e782 & bitcast<u32>(_e787)));
                                            let _e791 = bitcast<u32>((f32(bitcast<i32>((_e678 & 2097151u))) * _e709));
                                            let _e796 = (bitcast<i32>((_e678 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e799 = bitcast<f32>((_e791 & bitcast<u32>(_e796)));
                                            let _e803 = bitcast<f32>((_e773 & bitcast<u32>(~(_e778))));
                                            let _e807 = bitcast<f32>((_e782 & bitcast<u32>(~(_e787))));
                                            let _e811 = bitcast<f32>((_e791 & bitcast<u32>(~(_e796))));
                                            let _e841 = global_10.member[_e616.member_1][0u];
                                            let _e845 = global_10.member[_e616.member_1][2u];
                                            let _e849 = global_10.member[_e616.member_1][4u];
                                            let _e853 = global_10.member[_e616.member_1][6u];
                                            let _e865 = (((_e845 >> bitcast<u32>(22i)) | ((_e849 >> bitcast<u32>(22i)) << bitcast<u32>(10i))) | ((_e853 >> bitcast<u32>(22i)) << bitcast<u32>(20i)));
                                            let _e866 = (_e841 & 268435455u);
                                            let _e867 = (_e865 & 268435455u);
                                            let _e870 = ((_e841 >> bitcast<u32>(28u)) & 7u);
                                            let _e878 = ((_e841 >> bitcast<u32>(31i)) | (((_e865 >> bitcast<u32>(28u)) & 3u) << bitcast<u32>(1i)));
                                            let _e879 = (_e870 != 0u);
                                            if (_e870 == 0u) {
                                                phi_3016_ = _e866;
                                            } else {
                                                if (_e870 == 7u) {
                                                    phi_3015_ = 2147483648u;
                                                } else {
                                                    phi_3015_ = ((2147483648u | (_e870 << bitcast<u32>(28u))) | (_e867 & 268435455u));
                                                }
                                                let _e888 = phi_3015_;
                                                phi_3016_ = _e888;
                                            }
                                            let _e890 = phi_3016_;
                                            if _e879 {
                                                let _e891 = (_e870 != 7u);
                                                if _e891 {
                                                    phi_3026_ = (_e867 + _e870);
                                                } else {
                                                    phi_3026_ = u32();
                                                }
                                                let _e894 = phi_3026_;
                                                phi_3028_ = _e894;
                                                phi_3029_ = select(true, false, _e891);
                                            } else {
                                                phi_3028_ = u32();
                                                phi_3029_ = true;
                                            }
                                            let _e897 = phi_3028_;
                                            let _e899 = phi_3029_;
                                            if (_e878 == 0u) {
                                                phi_3050_ = (_e866 + select(0u, 1u, !(_e879)));
                                            } else {
                                                if (_e878 == 7u) {
                                                    phi_3049_ = 2147483648u;
                                                } else {
                                                    phi_3049_ = ((2147483648u | (_e878 << bitcast<u32>(28u))) | (select(_e897, _e867, _e899) & 268435455u));
                                                }
                                                let _e912 = phi_3049_;
                                                phi_3050_ = _e912;
                                            }
                                            let _e914 = phi_3050_;
                                            phi_3054_ = type_63(array<vec4<f32>, 3>(vec4<f32>((_e616.member.member.x + _e742), (_e616.member.member.x + _e764), (_e616.member.member_1.x - _e781), (_e616.member.member_1.x - _e803)), vec4<f32>((_e616.member.member.y + _e751), (_e616.member.member.y + _e768), (_e616.member.member_1.y - _e790), (_e616.member.member_1.y - _e807)), vec4<f32>((_e616.member.member.z + _e760), (_e616.member.member.z + _e772), (_e616.member.member_1.z - _e799), (_e616.member.member_1.z - _e811))), type_62(type_38((_e616.member.member + vec4<f32>(_e742, _e751, _e760, 0f)), (_e616.member.member_1 - vec4<f32>(_e781, _e790, _e799, 0f))), _e890), type_62(type_38((_e616.member.member + vec4<f32>(_e764, _e768, _e772, 0f)), (_e616.member.member_1 - vec4<f32>(_e803, _e807, _e811, 0f))), _e914));
                                        }
                                        let _e919 = phi_3054_;
                                        let _e931 = ((_e919.member[0].x - _e410) * _e415);
                                        let _e932 = ((_e919.member[0].y - _e410) * _e415);
                                        let _e933 = ((_e919.member[0].z - _e411) * _e415);
                                        let _e934 = ((_e919.member[0].w - _e411) * _e415);
                                        let _e944 = ((_e919.member[1].x - _e446) * _e451);
                                        let _e945 = ((_e919.member[1].y - _e446) * _e451);
                                        let _e946 = ((_e919.member[1].z - _e447) * _e451);
                                        let _e947 = ((_e919.member[1].w - _e447) * _e451);
                                        let _e957 = ((_e919.member[2].x - _e482) * _e487);
                                        let _e958 = ((_e919.member[2].y - _e482) * _e487);
                                        let _e959 = ((_e919.member[2].z - _e483) * _e487);
                                        let _e960 = ((_e919.member[2].w - _e483) * _e487);
                                        let _e962 = select(_e959, _e957, (_e957 < _e959));
                                        let _e964 = select(_e960, _e958, (_e958 < _e960));
                                        let _e966 = select(_e959, _e957, (_e957 > _e959));
                                        let _e968 = select(_e960, _e958, (_e958 > _e960));
                                        let _e970 = select(_e933, _e931, (_e931 < _e933));
                                        let _e972 = select(_e934, _e932, (_e932 < _e934));
                                        let _e974 = select(_e946, _e944, (_e944 < _e946));
                                        let _e976 = select(_e947, _e945, (_e945 < _e947));
                                        let _e978 = select(_e974, _e970, (_e970 > _e974));
                                        let _e980 = select(_e976, _e972, (_e972 > _e976));
                                        let _e982 = select(_e962, _e978, (_e978 > _e962));
                                        let _e984 = select(_e964, _e980, (_e980 > _e964));
                                        let _e986 = select(_e933, _e931, (_e931 > _e933));
                                        let _e988 = select(_e934, _e932, (_e932 > _e934));
                                        let _e990 = select(_e946, _e944, (_e944 > _e946));
                                        let _e992 = select(_e947, _e945, (_e945 > _e947));
                                        let _e994 = select(_e990, _e986, (_e986 < _e990));
                                        let _e996 = select(_e992, _e988, (_e988 < _e992));
                                        let _e1001 = -(_e962);
                                        let _e1002 = -(_e964);
                                        let _e1009 = (select(_e966, _e994, (_e994 < _e966)) + (select(_e1001, _e966, (_e966 > _e1001)) * 0.0000019073523f));
                                        let _e1010 = (select(_e968, _e996, (_e996 < _e968)) + (select(_e1002, _e968, (_e968 > _e1002)) * 0.0000019073523f));
                                        let _e1012 = select(_e533, _e982, (_e982 > _e533));
                                        let _e1014 = select(_e533, _e984, (_e984 > _e533));
                                        let _e1019 = (_e1012 <= select(_e577.member_1, _e1009, (_e1009 < _e577.member_1)));
                                        let _e1020 = (_e1014 <= select(_e577.member_1, _e1010, (_e1010 < _e577.member_1)));
                                        let _e1021 = (_e1012 <= _e1014);
                                        if _e1019 {
                                            if _e1020 {
                                                if _e1021 {
                                                    phi_3398_ = _e919.member_2;
                                                } else {
                                                    phi_3398_ = _e919.member_1;
                                                }
                                                let _e1025 = phi_3398_;
                                                let _e1047 = (_e620 % 128u);
                                                let _e1048 = (_e1047 < 128u);
                                                if _e1048 {
                                                } else {
                                                    phi_3975_ = true;
                                                    break;
                                                }
                                                local_8[_e1047] = _e1025.member_1;
                                                if _e1048 {
                                                } else {
                                                    phi_3975_ = true;
                                                    break;
                                                }
                                                local_7[_e1047] = _e1025.member.member.x;
                                                if _e1048 {
                                                } else {
                                                    phi_3975_ = true;
                                                    break;
                                                }
                                                local_6[_e1047] = _e1025.member.member.y;
                                                if _e1048 {
                                                } else {
                                                    phi_3975_ = true;
                                                    break;
                                                }
                                                local_5[_e1047] = _e1025.member.member.z;
                                                if _e1048 {
                                                } else {
                                                    phi_3975_ = true;
                                                    break;
                                                }
                                                local_4[_e1047] = _e1025.member.member_1.x;
                                                if _e1048 {
                                                } else {
                                                    phi_3975_ = true;
                                                    break;
                                                }
                                                local_3[_e1047] = _e1025.member.member_1.y;
                                                if _e1048 {
                                                } else {
                                                    phi_3975_ = true;
                                                    break;
                                                }
                                                local_2[_e1047] = _e1025.member.member_1.z;
                                                if _e1048 {
                                                } else {
                                                    phi_3975_ = true;
                                                    break;
                                                }
                                                local_9[_e1047] = select(_e1014, _e1012, (_e1012 > _e1014));
                                                if _e1021 {
                                                    phi_3475_ = _e919.member_1;
                                                } else {
                                                    phi_3475_ = _e919.member_2;
                                                }
                                                let _e1061 = phi_3475_;
                                                phi_3476_ = _e1061;
                                                phi_3477_ = (_e620 + 1u);
                                            } else {
                                                phi_3476_ = type_62();
                                                phi_3477_ = u32();
                                            }
                                            let _e1063 = phi_3476_;
                                            let _e1065 = phi_3477_;
                                            phi_3479_ = _e1063;
                                            phi_3480_ = _e1065;
                                            phi_3481_ = select(true, false, _e1020);
                                        } else {
                                            phi_3479_ = type_62();
                                            phi_3480_ = u32();
                                            phi_3481_ = true;
                                        }
                                        let _e1068 = phi_3479_;
                                        let _e1070 = phi_3480_;
                                        let _e1072 = phi_3481_;
                                        if _e1072 {
                                            if _e1019 {
                                                phi_3490_ = _e919.member_1;
                                            } else {
                                                phi_3490_ = _e919.member_2;
                                            }
                                            let _e1076 = phi_3490_;
                                            phi_3495_ = _e1076;
                                            phi_3496_ = select(_e1020, true, _e1019);
                                        } else {
                                            phi_3495_ = _e1068;
                                            phi_3496_ = _e618;
                                        }
                                        let _e1079 = phi_3495_;
                                        let _e1081 = phi_3496_;
                                        phi_3979_ = _e575;
                                        phi_3498_ = _e577;
                                        phi_3499_ = _e1079;
                                        phi_3500_ = _e1081;
                                        phi_3501_ = select(_e1070, _e620, _e1072);
                                    }
                                    let _e1717 = phi_3979_;
                                    let _e1719 = phi_3498_;
                                    let _e1721 = phi_3499_;
                                    let _e1723 = phi_3500_;
                                    let _e1725 = phi_3501_;
                                    phi_3978_ = _e1717;
                                    phi_3502_ = _e1719;
                                    phi_3503_ = _e1721;
                                    phi_3504_ = (_e581 - 1u);
                                    phi_3505_ = _e1723;
                                    phi_3506_ = _e1725;
                                } else {
                                    phi_3978_ = _e575;
                                    phi_3502_ = _e577;
                                    phi_3503_ = _e616;
                                    phi_3504_ = _e581;
                                    phi_3505_ = _e618;
                                    phi_3506_ = _e620;
                                }
                                let _e1727 = phi_3978_;
                                let _e1729 = phi_3502_;
                                let _e1731 = phi_3503_;
                                let _e1733 = phi_3504_;
                                let _e1735 = phi_3505_;
                                let _e1737 = phi_3506_;
                                phi_3977_ = _e1727;
                                phi_3507_ = _e1729;
                                phi_3508_ = _e1731;
                                phi_3509_ = _e1733;
                                phi_3510_ = _e1735;
                                phi_3511_ = _e1737;
                            } else {
                                phi_3977_ = _e575;
                                phi_3507_ = type_43();
                                phi_3508_ = type_62();
                                phi_3509_ = u32();
                                phi_3510_ = bool();
                                phi_3511_ = u32();
                            }
                            let _e1739 = phi_3977_;
                            let _e1741 = phi_3507_;
                            let _e1743 = phi_3508_;
                            let _e1745 = phi_3509_;
                            let _e1747 = phi_3510_;
                            let _e1749 = phi_3511_;
                            phi_3976_ = _e1739;
                            phi_957_ = _e1741;
                            phi_960_ = _e1743;
                            phi_962_ = _e1745;
                            phi_964_ = _e1747;
                            phi_966_ = _e1749;
                            phi_3512_ = _e589;
                        } else {
                            phi_3976_ = _e575;
                            phi_957_ = type_43();
                            phi_960_ = type_62();
                            phi_962_ = u32();
                            phi_964_ = bool();
                            phi_966_ = u32();
                            phi_3512_ = false;
                        }
                        let _e1751 = phi_3976_;
                        let _e1753 = phi_957_;
                        let _e1755 = phi_960_;
                        let _e1757 = phi_962_;
                        let _e1759 = phi_964_;
                        let _e1761 = phi_966_;
                        let _e1763 = phi_3512_;
                        continue;
                        continuing {
                            phi_3843_ = _e1751;
                            phi_956_ = _e1753;
                            phi_959_ = _e1755;
                            phi_961_ = _e1757;
                            phi_963_ = _e1759;
                            phi_965_ = _e1761;
                            phi_3975_ = _e1751;
                            break if !(_e1763);
                        }
                    }
                    let _e1766 = phi_3975_;
                    if _e1766 {
                        break;
                    }
                    let _e1768 = local_10;
                    if (_e1768.member.member_3 != 4294967295u) {
                        let _e1773 = (_e357 / 3i);
                        let _e1780 = bitcast<f32>((bitcast<u32>((_e1773 + 127i)) << bitcast<u32>(23i)));
                        let _e1788 = (((_e1768.member.member * _e1780) * _e1780) * bitcast<f32>((bitcast<u32>(((_e357 - (2i * _e1773)) + 127i)) << bitcast<u32>(23i))));
                        let _e1790 = select(340282350000000000000000000000000000000f, _e1788, (_e1788 < 340282350000000000000000000000000000000f));
                        phi_3564_ = type_26(select(-340282350000000000000000000000000000000f, _e1790, (_e1790 > -340282350000000000000000000000000000000f)), _e1768.member.member_1, _e1768.member.member_2, _e1768.member.member_3);
                    } else {
                        phi_3564_ = type_26(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                    }
                    let _e1797 = phi_3564_;
                    if _e234 {
                    } else {
                        break;
                    }
                    global_8.member[_e140] = _e1797;
                    if _e155 {
                    } else {
                        break;
                    }
                    let _e1801 = select(0u, 1u, (_e301 <= _e311));
                    if (_e1801 > 0u) {
                        let _e1803 = (1u < _e108);
                        if _e1803 {
                            if (0u < _e108) {
                            } else {
                                break;
                            }
                            let _e1807 = atomicAdd((&global_9.member[0u]), _e1801);
                            if ((_e1807 + _e1801) < _e1807) {
                                if _e1803 {
                                } else {
                                    break;
                                }
                                let _e1812 = atomicAdd((&global_9.member[1u]), 1u);
                            }
                        }
                    }
                    let _e1815 = select(0u, 1u, (_e1797.member_3 != 4294967295u));
                    if (_e1815 > 0u) {
                        let _e1817 = (3u < _e108);
                        if _e1817 {
                            if (2u < _e108) {
                            } else {
                                break;
                            }
                            let _e1821 = atomicAdd((&global_9.member[2u]), _e1815);
                            if ((_e1821 + _e1815) < _e1821) {
                                if _e1817 {
                                } else {
                                    break;
                                }
                                let _e1826 = atomicAdd((&global_9.member[3u]), 1u);
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
