struct type_4 {
    member: array<u32>,
}

struct type_8 {
    member: u32,
    member_1: u32,
}

struct type_13 {
    member: vec4<u32>,
}

struct type_22 {
    member: array<array<f32, 4>, 3>,
    member_1: u32,
    member_2: u32,
    member_3: u32,
    member_4: u32,
}

struct type_24 {
    member: array<type_22>,
}

struct type_27 {
    member: vec3<f32>,
    member_1: vec3<f32>,
}

struct type_28 {
    member: array<u32, 4>,
    member_1: array<u32, 4>,
}

struct type_30 {
    member: array<type_28>,
}

struct type_34 {
    member: array<i32, 3>,
    member_1: array<i32, 3>,
}

struct type_40 {
    member: array<array<u32, 7>>,
}

struct type_45 {
    member: array<type_34>,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_1: type_13;
@group(0) @binding(1) 
var<uniform> global_2: type_13;
@group(0) @binding(2) 
var<uniform> global_3: type_13;
@group(0) @binding(3) 
var<storage> global_4: type_24;
@group(0) @binding(5) 
var<storage, read_write> global_5: type_45;
@group(0) @binding(6) 
var<storage, read_write> global_6: type_4;
@group(0) @binding(7) 
var<storage, read_write> global_7: type_30;
@group(0) @binding(4) 
var<storage, read_write> global_8: type_40;

fn function_() {
    var local: array<i32, 3>;
    var local_1: array<i32, 3>;
    var local_2: array<i32, 3>;
    var local_3: array<i32, 3>;
    var local_4: array<i32, 3>;
    var local_5: array<i32, 3>;
    var local_6: array<i32, 3>;
    var local_7: array<i32, 3>;
    var local_8: array<i32, 3>;
    var local_9: array<i32, 3>;
    var local_10: array<i32, 3>;
    var local_11: array<i32, 3>;
    var local_12: array<i32, 3>;
    var local_13: array<i32, 3>;
    var local_14: array<i32, 3>;
    var local_15: array<i32, 3>;
    var local_16: array<i32, 3>;
    var local_17: array<i32, 3>;
    var local_18: array<i32, 3>;
    var local_19: array<i32, 3>;
    var local_20: array<u32, 7>;
    var local_21: array<u32, 7>;
    var phi_184_: i32;
    var phi_230_: type_22;
    var phi_248_: type_27;
    var phi_266_: type_27;
    var phi_2559_: bool;
    var phi_443_: type_8;
    var phi_446_: u32;
    var phi_444_: type_8;
    var phi_469_: type_8;
    var phi_491_: type_22;
    var phi_499_: bool;
    var phi_517_: type_27;
    var phi_535_: type_27;
    var phi_807_: type_8;
    var phi_808_: type_8;
    var phi_831_: type_8;
    var phi_2550_: bool;
    var phi_1005_: type_8;
    var phi_1006_: type_8;
    var phi_1029_: type_8;
    var phi_2581_: bool;
    var phi_1234_: type_34;
    var phi_2600_: bool;
    var phi_1252_: u32;
    var phi_2599_: bool;
    var phi_447_: u32;
    var phi_1254_: bool;
    var phi_2598_: bool;
    var phi_1305_: type_27;
    var phi_1327_: type_27;
    var phi_1599_: type_8;
    var phi_1600_: type_8;
    var phi_1623_: type_8;
    var phi_2603_: bool;
    var phi_1797_: type_8;
    var phi_1798_: type_8;
    var phi_1821_: type_8;
    var phi_2619_: bool;
    var phi_2176_: u32;
    var phi_2182_: u32;
    var phi_2189_: type_8;
    var phi_2190_: type_8;
    var phi_2213_: type_8;
    var phi_2636_: bool;
    var phi_2651_: bool;
    var phi_2309_: u32;
    var phi_2315_: u32;
    var phi_2322_: type_8;
    var phi_2323_: type_8;
    var phi_2346_: type_8;
    var phi_2644_: bool;

    switch bitcast<i32>(0u) {
        default: {
            let _e72 = global;
            let _e74 = arrayLength((&global_4.member));
            let _e82 = arrayLength((&global_6.member));
            let _e85 = arrayLength((&global_7.member));
            let _e88 = global_3.member[0u];
            let _e92 = global_2.member[0u];
            let _e94 = (bitcast<i32>(_e88) + bitcast<i32>(_e92));
            if (_e94 < -126i) {
                phi_184_ = -126i;
            } else {
                phi_184_ = select(_e94, 127i, (_e94 > 127i));
            }
            let _e99 = phi_184_;
            let _e103 = (_e72.x + (_e72.y * 2097152u));
            let _e106 = global_1.member[0u];
            if (_e103 < _e106) {
                let _e108 = (_e103 < _e74);
                if _e108 {
                    let _e109 = (_e103 < arrayLength((&global_8.member)));
                    if _e109 {
                        let _e110 = (_e103 < arrayLength((&global_5.member)));
                        if _e110 {
                            let _e111 = (0u < _e74);
                            if _e111 {
                                if _e111 {
                                } else {
                                    break;
                                }
                                let _e114 = global_4.member[0u];
                                phi_230_ = _e114;
                            } else {
                                phi_230_ = type_22(array<array<f32, 4>, 3>(array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f)), 2147483648u, 2147483648u, 0u, 0u);
                            }
                            let _e116 = phi_230_;
                            if (_e116.member_1 == 2147483648u) {
                                phi_248_ = type_27(vec3<f32>(0f, 0f, 0f), vec3<f32>(0f, 0f, 0f));
                            } else {
                                phi_248_ = type_27(vec3<f32>(_e116.member[0][0], _e116.member[1][0], _e116.member[2][0]), vec3<f32>(_e116.member[0][2], _e116.member[1][2], _e116.member[2][2]));
                            }
                            let _e135 = phi_248_;
                            if (_e116.member_2 == 2147483648u) {
                                phi_266_ = _e135;
                            } else {
                                phi_266_ = type_27(vec3<f32>(_e116.member[0][1], _e116.member[1][1], _e116.member[2][1]), vec3<f32>(_e116.member[0][3], _e116.member[1][3], _e116.member[2][3]));
                            }
                            let _e154 = phi_266_;
                            let _e187 = bitcast<f32>((bitcast<u32>((127i - _e99)) << bitcast<u32>(23i)));
                            let _e188 = (select(_e154.member.x, _e135.member.x, (_e135.member.x < _e154.member.x)) * _e187);
                            let _e195 = select(0i, select(select(i32(_e188), i32(-2147483648), (_e188 < -2147483600f)), 2147483647i, (_e188 > 2147483500f)), (_e188 == _e188));
                            let _e200 = (select(_e154.member.y, _e135.member.y, (_e135.member.y < _e154.member.y)) * _e187);
                            let _e207 = select(0i, select(select(i32(_e200), i32(-2147483648), (_e200 < -2147483600f)), 2147483647i, (_e200 > 2147483500f)), (_e200 == _e200));
                            let _e212 = (select(_e154.member.z, _e135.member.z, (_e135.member.z < _e154.member.z)) * _e187);
                            let _e219 = select(0i, select(select(i32(_e212), i32(-2147483648), (_e212 < -2147483600f)), 2147483647i, (_e212 > 2147483500f)), (_e212 == _e212));
                            let _e224 = (select(_e154.member_1.x, _e135.member_1.x, (_e135.member_1.x > _e154.member_1.x)) * _e187);
                            let _e231 = select(0i, select(select(i32(_e224), i32(-2147483648), (_e224 < -2147483600f)), 2147483647i, (_e224 > 2147483500f)), (_e224 == _e224));
                            let _e236 = (select(_e154.member_1.y, _e135.member_1.y, (_e135.member_1.y > _e154.member_1.y)) * _e187);
                            let _e243 = select(0i, select(select(i32(_e236), i32(-2147483648), (_e236 < -2147483600f)), 2147483647i, (_e236 > 2147483500f)), (_e236 == _e236));
                            let _e248 = (select(_e154.member_1.z, _e135.member_1.z, (_e135.member_1.z > _e154.member_1.z)) * _e187);
                            let _e255 = select(0i, select(select(i32(_e248), i32(-2147483648), (_e248 < -2147483600f)), 2147483647i, (_e248 > 2147483500f)), (_e248 == _e248));
                            local_11 = array<i32, 3>((_e195 - select(0i, 1i, (f32(_e195) > _e188))), (_e207 - select(0i, 1i, (f32(_e207) > _e200))), (_e219 - select(0i, 1i, (f32(_e219) > _e212))));
                            local_10 = array<i32, 3>((_e231 + select(0i, 1i, (f32(_e231) < _e224))), (_e243 + select(0i, 1i, (f32(_e243) < _e236))), (_e255 + select(0i, 1i, (f32(_e255) < _e248))));
                            phi_2559_ = false;
                            phi_443_ = type_8(0u, 128u);
                            phi_446_ = 0u;
                            loop {
                                let _e263 = phi_2559_;
                                let _e265 = phi_443_;
                                let _e267 = phi_446_;
                                if (_e265.member < _e265.member_1) {
                                    phi_444_ = type_8((_e265.member + 1u), _e265.member_1);
                                    phi_469_ = type_8(1u, _e265.member);
                                } else {
                                    phi_444_ = _e265;
                                    phi_469_ = type_8(0u, type_8().member_1);
                                }
                                let _e280 = phi_444_;
                                let _e282 = phi_469_;
                                if (bitcast<i32>(_e282.member) != 0i) {
                                    let _e286 = (_e267 == _e103);
                                    if _e286 {
                                        phi_2600_ = _e263;
                                        phi_1252_ = u32();
                                    } else {
                                        let _e287 = (_e267 < _e74);
                                        if _e287 {
                                            if _e287 {
                                            } else {
                                                phi_2598_ = true;
                                                break;
                                            }
                                            let _e290 = global_4.member[_e267];
                                            phi_491_ = _e290;
                                        } else {
                                            phi_491_ = type_22(array<array<f32, 4>, 3>(array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f)), 2147483648u, 2147483648u, 0u, 0u);
                                        }
                                        let _e292 = phi_491_;
                                        if ((_e292.member_1 & 2147483648u) != 0u) {
                                            phi_499_ = false;
                                        } else {
                                            phi_499_ = (_e103 <= _e292.member_1);
                                        }
                                        let _e298 = phi_499_;
                                        if (_e292.member_1 == 2147483648u) {
                                            phi_517_ = type_27(vec3<f32>(0f, 0f, 0f), vec3<f32>(0f, 0f, 0f));
                                        } else {
                                            phi_517_ = type_27(vec3<f32>(_e292.member[0][0], _e292.member[1][0], _e292.member[2][0]), vec3<f32>(_e292.member[0][2], _e292.member[1][2], _e292.member[2][2]));
                                        }
                                        let _e316 = phi_517_;
                                        if (_e292.member_2 == 2147483648u) {
                                            phi_535_ = _e316;
                                        } else {
                                            phi_535_ = type_27(vec3<f32>(_e292.member[0][1], _e292.member[1][1], _e292.member[2][1]), vec3<f32>(_e292.member[0][3], _e292.member[1][3], _e292.member[2][3]));
                                        }
                                        let _e335 = phi_535_;
                                        let _e348 = (_e316.member.x * _e187);
                                        let _e355 = select(0i, select(select(i32(_e348), i32(-2147483648), (_e348 < -2147483600f)), 2147483647i, (_e348 > 2147483500f)), (_e348 == _e348));
                                        let _e360 = (_e316.member.y * _e187);
                                        let _e367 = select(0i, select(select(i32(_e360), i32(-2147483648), (_e360 < -2147483600f)), 2147483647i, (_e360 > 2147483500f)), (_e360 == _e360));
                                        let _e372 = (_e316.member.z * _e187);
                                        let _e379 = select(0i, select(select(i32(_e372), i32(-2147483648), (_e372 < -2147483600f)), 2147483647i, (_e372 > 2147483500f)), (_e372 == _e372));
                                        let _e384 = (_e316.member_1.x * _e187);
                                        let _e391 = select(0i, select(select(i32(_e384), i32(-2147483648), (_e384 < -2147483600f)), 2147483647i, (_e384 > 2147483500f)), (_e384 == _e384));
                                        let _e396 = (_e316.member_1.y * _e187);
                                        let _e403 = select(0i, select(select(i32(_e396), i32(-2147483648), (_e396 < -2147483600f)), 2147483647i, (_e396 > 2147483500f)), (_e396 == _e396));
                                        let _e408 = (_e316.member_1.z * _e187);
                                        let _e415 = select(0i, select(select(i32(_e408), i32(-2147483648), (_e408 < -2147483600f)), 2147483647i, (_e408 > 2147483500f)), (_e408 == _e408));
                                        local_15 = array<i32, 3>((_e355 - select(0i, 1i, (f32(_e355) > _e348))), (_e367 - select(0i, 1i, (f32(_e367) > _e360))), (_e379 - select(0i, 1i, (f32(_e379) > _e372))));
                                        local_14 = array<i32, 3>((_e391 + select(0i, 1i, (f32(_e391) < _e384))), (_e403 + select(0i, 1i, (f32(_e403) < _e396))), (_e415 + select(0i, 1i, (f32(_e415) < _e408))));
                                        let _e434 = (_e335.member.x * _e187);
                                        let _e441 = select(0i, select(select(i32(_e434), i32(-2147483648), (_e434 < -2147483600f)), 2147483647i, (_e434 > 2147483500f)), (_e434 == _e434));
                                        let _e446 = (_e335.member.y * _e187);
                                        let _e453 = select(0i, select(select(i32(_e446), i32(-2147483648), (_e446 < -2147483600f)), 2147483647i, (_e446 > 2147483500f)), (_e446 == _e446));
                                        let _e458 = (_e335.member.z * _e187);
                                        let _e465 = select(0i, select(select(i32(_e458), i32(-2147483648), (_e458 < -2147483600f)), 2147483647i, (_e458 > 2147483500f)), (_e458 == _e458));
                                        let _e470 = (_e335.member_1.x * _e187);
                                        let _e477 = select(0i, select(select(i32(_e470), i32(-2147483648), (_e470 < -2147483600f)), 2147483647i, (_e470 > 2147483500f)), (_e470 == _e470));
                                        let _e482 = (_e335.member_1.y * _e187);
                                        let _e489 = select(0i, select(select(i32(_e482), i32(-2147483648), (_e482 < -2147483600f)), 2147483647i, (_e482 > 2147483500f)), (_e482 == _e482));
                                        let _e494 = (_e335.member_1.z * _e187);
                                        let _e501 = select(0i, select(select(i32(_e494), i32(-2147483648), (_e494 < -2147483600f)), 2147483647i, (_e494 > 2147483500f)), (_e494 == _e494));
                                        local_13 = array<i32, 3>((_e441 - select(0i, 1i, (f32(_e441) > _e434))), (_e453 - select(0i, 1i, (f32(_e453) > _e446))), (_e465 - select(0i, 1i, (f32(_e465) > _e458))));
                                        local_12 = array<i32, 3>((_e477 + select(0i, 1i, (f32(_e477) < _e470))), (_e489 + select(0i, 1i, (f32(_e489) < _e482))), (_e501 + select(0i, 1i, (f32(_e501) < _e494))));
                                        local_21 = array<u32, 7>(0u, 0u, 0u, 0u, 0u, 0u, 0u);
                                        phi_807_ = type_8(0u, 3u);
                                        loop {
                                            let _e509 = phi_807_;
                                            if (_e509.member < _e509.member_1) {
                                                phi_808_ = type_8((_e509.member + 1u), _e509.member_1);
                                                phi_831_ = type_8(1u, _e509.member);
                                            } else {
                                                phi_808_ = _e509;
                                                phi_831_ = type_8(0u, type_8().member_1);
                                            }
                                            let _e522 = phi_808_;
                                            let _e524 = phi_831_;
                                            let _e528 = (bitcast<i32>(_e524.member) != 0i);
                                            if _e528 {
                                                let _e529 = (_e524.member_1 < 3u);
                                                if _e529 {
                                                } else {
                                                    phi_2550_ = true;
                                                    break;
                                                }
                                                let _e531 = local_11[_e524.member_1];
                                                if _e529 {
                                                } else {
                                                    phi_2550_ = true;
                                                    break;
                                                }
                                                let _e533 = local_10[_e524.member_1];
                                                let _e535 = bitcast<u32>((_e533 - _e531));
                                                let _e541 = (32u - select((bitcast<u32>(31i) - firstLeadingBit(_e535)), 32u, (_e535 == 0u)));
                                                if _e529 {
                                                } else {
                                                    phi_2550_ = true;
                                                    break;
                                                }
                                                let _e546 = local_15[_e524.member_1];
                                                let _e547 = (_e546 - _e531);
                                                if _e529 {
                                                } else {
                                                    phi_2550_ = true;
                                                    break;
                                                }
                                                let _e549 = local_13[_e524.member_1];
                                                let _e550 = (_e549 - _e531);
                                                let _e551 = (_e547 > _e550);
                                                let _e554 = ((select(21u, _e541, (_e541 > 21u)) - 21u) & 31u);
                                                if _e529 {
                                                } else {
                                                    phi_2550_ = true;
                                                    break;
                                                }
                                                let _e563 = local_14[_e524.member_1];
                                                let _e564 = (_e533 - _e563);
                                                if _e529 {
                                                } else {
                                                    phi_2550_ = true;
                                                    break;
                                                }
                                                let _e566 = local_12[_e524.member_1];
                                                let _e567 = (_e533 - _e566);
                                                let _e568 = (_e564 > _e567);
                                                let _e578 = (_e524.member_1 * 2u);
                                                let _e580 = ((1u + _e578) % 7u);
                                                if (_e580 < 7u) {
                                                } else {
                                                    phi_2550_ = true;
                                                    break;
                                                }
                                                local_21[_e580] = (((bitcast<u32>(select(_e550, _e547, _e551)) >> bitcast<u32>(_e554)) & 2097151u) | (select(0u, 1u, _e551) << bitcast<u32>(21u)));
                                                let _e584 = ((_e578 + 2u) % 7u);
                                                if (_e584 < 7u) {
                                                } else {
                                                    phi_2550_ = true;
                                                    break;
                                                }
                                                local_21[_e584] = (((bitcast<u32>(select(_e567, _e564, _e568)) >> bitcast<u32>(_e554)) & 2097151u) | (select(0u, 1u, _e568) << bitcast<u32>(21u)));
                                            }
                                            continue;
                                            continuing {
                                                phi_807_ = _e522;
                                                phi_2550_ = _e263;
                                                break if !(_e528);
                                            }
                                        }
                                        let _e589 = phi_2550_;
                                        phi_2598_ = _e589;
                                        if _e589 {
                                            break;
                                        }
                                        local_3 = array<i32, 3>(0i, 0i, 0i);
                                        local_2 = array<i32, 3>(0i, 0i, 0i);
                                        local_1 = array<i32, 3>(0i, 0i, 0i);
                                        local = array<i32, 3>(0i, 0i, 0i);
                                        phi_1005_ = type_8(0u, 3u);
                                        loop {
                                            let _e591 = phi_1005_;
                                            if (_e591.member < _e591.member_1) {
                                                phi_1006_ = type_8((_e591.member + 1u), _e591.member_1);
                                                phi_1029_ = type_8(1u, _e591.member);
                                            } else {
                                                phi_1006_ = _e591;
                                                phi_1029_ = type_8(0u, type_8().member_1);
                                            }
                                            let _e604 = phi_1006_;
                                            let _e606 = phi_1029_;
                                            let _e610 = (bitcast<i32>(_e606.member) != 0i);
                                            if _e610 {
                                                let _e611 = (_e606.member_1 * 2u);
                                                let _e613 = ((1u + _e611) % 7u);
                                                if (_e613 < 7u) {
                                                } else {
                                                    phi_2581_ = true;
                                                    break;
                                                }
                                                let _e616 = local_21[_e613];
                                                let _e618 = ((_e611 + 2u) % 7u);
                                                if (_e618 < 7u) {
                                                } else {
                                                    phi_2581_ = true;
                                                    break;
                                                }
                                                let _e621 = local_21[_e618];
                                                let _e622 = (_e606.member_1 < 3u);
                                                if _e622 {
                                                } else {
                                                    phi_2581_ = true;
                                                    break;
                                                }
                                                let _e624 = local_11[_e606.member_1];
                                                if _e622 {
                                                } else {
                                                    phi_2581_ = true;
                                                    break;
                                                }
                                                let _e626 = local_10[_e606.member_1];
                                                let _e628 = bitcast<u32>((_e626 - _e624));
                                                let _e634 = (32u - select((bitcast<u32>(31i) - firstLeadingBit(_e628)), 32u, (_e628 == 0u)));
                                                let _e639 = ((select(21u, _e634, (_e634 > 21u)) - 21u) & 31u);
                                                let _e643 = (_e624 + bitcast<i32>(((_e616 & 2097151u) << bitcast<u32>(_e639))));
                                                let _e648 = (_e626 - bitcast<i32>(((_e621 & 2097151u) << bitcast<u32>(_e639))));
                                                let _e652 = (((_e616 >> bitcast<u32>(21u)) & 1u) == 1u);
                                                let _e656 = (((_e621 >> bitcast<u32>(21u)) & 1u) == 1u);
                                                if _e622 {
                                                } else {
                                                    phi_2581_ = true;
                                                    break;
                                                }
                                                local_3[_e606.member_1] = select(_e624, _e643, _e652);
                                                if _e622 {
                                                } else {
                                                    phi_2581_ = true;
                                                    break;
                                                }
                                                local_1[_e606.member_1] = select(_e643, _e624, _e652);
                                                if _e622 {
                                                } else {
                                                    phi_2581_ = true;
                                                    break;
                                                }
                                                local_2[_e606.member_1] = select(_e626, _e648, _e656);
                                                if _e622 {
                                                } else {
                                                    phi_2581_ = true;
                                                    break;
                                                }
                                                local[_e606.member_1] = select(_e648, _e626, _e656);
                                            }
                                            continue;
                                            continuing {
                                                phi_1005_ = _e604;
                                                phi_2581_ = _e589;
                                                break if !(_e610);
                                            }
                                        }
                                        let _e667 = phi_2581_;
                                        phi_2598_ = _e667;
                                        if _e667 {
                                            break;
                                        }
                                        let _e668 = local;
                                        let _e669 = local_1;
                                        let _e670 = local_2;
                                        let _e671 = local_3;
                                        if _e298 {
                                            phi_1234_ = type_34(array<i32, 3>(_e671[0], _e671[1], _e671[2]), array<i32, 3>(_e670[0], _e670[1], _e670[2]));
                                        } else {
                                            phi_1234_ = type_34(array<i32, 3>(_e669[0], _e669[1], _e669[2]), array<i32, 3>(_e668[0], _e668[1], _e668[2]));
                                        }
                                        let _e691 = phi_1234_;
                                        local_11 = array<i32, 3>(_e691.member[0], _e691.member[1], _e691.member[2]);
                                        local_10 = array<i32, 3>(_e691.member_1[0], _e691.member_1[1], _e691.member_1[2]);
                                        phi_2600_ = _e667;
                                        phi_1252_ = select(_e292.member_2, _e292.member_1, _e298);
                                    }
                                    let _e704 = phi_2600_;
                                    let _e706 = phi_1252_;
                                    phi_2599_ = _e704;
                                    phi_447_ = _e706;
                                    phi_1254_ = select(true, false, _e286);
                                } else {
                                    phi_2599_ = _e263;
                                    phi_447_ = u32();
                                    phi_1254_ = false;
                                }
                                let _e709 = phi_2599_;
                                let _e711 = phi_447_;
                                let _e713 = phi_1254_;
                                continue;
                                continuing {
                                    phi_2559_ = _e709;
                                    phi_443_ = _e280;
                                    phi_446_ = _e711;
                                    phi_2598_ = _e709;
                                    break if !(_e713);
                                }
                            }
                            let _e716 = phi_2598_;
                            if _e716 {
                                break;
                            }
                            let _e717 = local_10;
                            let _e718 = local_11;
                            local_9 = _e718;
                            local_8 = _e717;
                            if _e108 {
                            } else {
                                break;
                            }
                            let _e722 = global_4.member[_e103].member_1;
                            if (_e722 == 2147483648u) {
                                phi_1305_ = type_27(vec3<f32>(0f, 0f, 0f), vec3<f32>(0f, 0f, 0f));
                            } else {
                                let _e728 = global_4.member[_e103].member[0u];
                                let _e733 = global_4.member[_e103].member[1u];
                                let _e738 = global_4.member[_e103].member[2u];
                                phi_1305_ = type_27(vec3<f32>(_e728[0], _e733[0], _e738[0]), vec3<f32>(_e728[2], _e733[2], _e738[2]));
                            }
                            let _e749 = phi_1305_;
                            let _e753 = global_4.member[_e103].member_2;
                            if (_e753 == 2147483648u) {
                                phi_1327_ = _e749;
                            } else {
                                let _e759 = global_4.member[_e103].member[0u];
                                let _e764 = global_4.member[_e103].member[1u];
                                let _e769 = global_4.member[_e103].member[2u];
                                phi_1327_ = type_27(vec3<f32>(_e759[1], _e764[1], _e769[1]), vec3<f32>(_e759[3], _e764[3], _e769[3]));
                            }
                            let _e780 = phi_1327_;
                            let _e793 = (_e749.member.x * _e187);
                            let _e800 = select(0i, select(select(i32(_e793), i32(-2147483648), (_e793 < -2147483600f)), 2147483647i, (_e793 > 2147483500f)), (_e793 == _e793));
                            let _e805 = (_e749.member.y * _e187);
                            let _e812 = select(0i, select(select(i32(_e805), i32(-2147483648), (_e805 < -2147483600f)), 2147483647i, (_e805 > 2147483500f)), (_e805 == _e805));
                            let _e817 = (_e749.member.z * _e187);
                            let _e824 = select(0i, select(select(i32(_e817), i32(-2147483648), (_e817 < -2147483600f)), 2147483647i, (_e817 > 2147483500f)), (_e817 == _e817));
                            let _e829 = (_e749.member_1.x * _e187);
                            let _e836 = select(0i, select(select(i32(_e829), i32(-2147483648), (_e829 < -2147483600f)), 2147483647i, (_e829 > 2147483500f)), (_e829 == _e829));
                            let _e841 = (_e749.member_1.y * _e187);
                            let _e848 = select(0i, select(select(i32(_e841), i32(-2147483648), (_e841 < -2147483600f)), 2147483647i, (_e841 > 2147483500f)), (_e841 == _e841));
                            let _e853 = (_e749.member_1.z * _e187);
                            let _e860 = select(0i, select(select(i32(_e853), i32(-2147483648), (_e853 < -2147483600f)), 2147483647i, (_e853 > 2147483500f)), (_e853 == _e853));
                            local_19 = array<i32, 3>((_e800 - select(0i, 1i, (f32(_e800) > _e793))), (_e812 - select(0i, 1i, (f32(_e812) > _e805))), (_e824 - select(0i, 1i, (f32(_e824) > _e817))));
                            local_18 = array<i32, 3>((_e836 + select(0i, 1i, (f32(_e836) < _e829))), (_e848 + select(0i, 1i, (f32(_e848) < _e841))), (_e860 + select(0i, 1i, (f32(_e860) < _e853))));
                            let _e879 = (_e780.member.x * _e187);
                            let _e886 = select(0i, select(select(i32(_e879), i32(-2147483648), (_e879 < -2147483600f)), 2147483647i, (_e879 > 2147483500f)), (_e879 == _e879));
                            let _e891 = (_e780.member.y * _e187);
                            let _e898 = select(0i, select(select(i32(_e891), i32(-2147483648), (_e891 < -2147483600f)), 2147483647i, (_e891 > 2147483500f)), (_e891 == _e891));
                            let _e903 = (_e780.member.z * _e187);
                            let _e910 = select(0i, select(select(i32(_e903), i32(-2147483648), (_e903 < -2147483600f)), 2147483647i, (_e903 > 2147483500f)), (_e903 == _e903));
                            let _e915 = (_e780.member_1.x * _e187);
                            let _e922 = select(0i, select(select(i32(_e915), i32(-2147483648), (_e915 < -2147483600f)), 2147483647i, (_e915 > 2147483500f)), (_e915 == _e915));
                            let _e927 = (_e780.member_1.y * _e187);
                            let _e934 = select(0i, select(select(i32(_e927), i32(-2147483648), (_e927 < -2147483600f)), 2147483647i, (_e927 > 2147483500f)), (_e927 == _e927));
                            let _e939 = (_e780.member_1.z * _e187);
                            let _e946 = select(0i, select(select(i32(_e939), i32(-2147483648), (_e939 < -2147483600f)), 2147483647i, (_e939 > 2147483500f)), (_e939 == _e939));
                            local_17 = array<i32, 3>((_e886 - select(0i, 1i, (f32(_e886) > _e879))), (_e898 - select(0i, 1i, (f32(_e898) > _e891))), (_e910 - select(0i, 1i, (f32(_e910) > _e903))));
                            local_16 = array<i32, 3>((_e922 + select(0i, 1i, (f32(_e922) < _e915))), (_e934 + select(0i, 1i, (f32(_e934) < _e927))), (_e946 + select(0i, 1i, (f32(_e946) < _e939))));
                            local_20 = array<u32, 7>(0u, 0u, 0u, 0u, 0u, 0u, 0u);
                            phi_1599_ = type_8(0u, 3u);
                            loop {
                                let _e954 = phi_1599_;
                                if (_e954.member < _e954.member_1) {
                                    phi_1600_ = type_8((_e954.member + 1u), _e954.member_1);
                                    phi_1623_ = type_8(1u, _e954.member);
                                } else {
                                    phi_1600_ = _e954;
                                    phi_1623_ = type_8(0u, type_8().member_1);
                                }
                                let _e967 = phi_1600_;
                                let _e969 = phi_1623_;
                                let _e973 = (bitcast<i32>(_e969.member) != 0i);
                                if _e973 {
                                    let _e974 = (_e969.member_1 < 3u);
                                    if _e974 {
                                    } else {
                                        phi_2603_ = true;
                                        break;
                                    }
                                    let _e976 = local_9[_e969.member_1];
                                    if _e974 {
                                    } else {
                                        phi_2603_ = true;
                                        break;
                                    }
                                    let _e978 = local_8[_e969.member_1];
                                    let _e980 = bitcast<u32>((_e978 - _e976));
                                    let _e986 = (32u - select((bitcast<u32>(31i) - firstLeadingBit(_e980)), 32u, (_e980 == 0u)));
                                    if _e974 {
                                    } else {
                                        phi_2603_ = true;
                                        break;
                                    }
                                    let _e991 = local_19[_e969.member_1];
                                    let _e992 = (_e991 - _e976);
                                    if _e974 {
                                    } else {
                                        phi_2603_ = true;
                                        break;
                                    }
                                    let _e994 = local_17[_e969.member_1];
                                    let _e995 = (_e994 - _e976);
                                    let _e996 = (_e992 > _e995);
                                    let _e999 = ((select(21u, _e986, (_e986 > 21u)) - 21u) & 31u);
                                    if _e974 {
                                    } else {
                                        phi_2603_ = true;
                                        break;
                                    }
                                    let _e1008 = local_18[_e969.member_1];
                                    let _e1009 = (_e978 - _e1008);
                                    if _e974 {
                                    } else {
                                        phi_2603_ = true;
                                        break;
                                    }
                                    let _e1011 = local_16[_e969.member_1];
                                    let _e1012 = (_e978 - _e1011);
                                    let _e1013 = (_e1009 > _e1012);
                                    let _e1023 = (_e969.member_1 * 2u);
                                    let _e1025 = ((1u + _e1023) % 7u);
                                    if (_e1025 < 7u) {
                                    } else {
                                        phi_2603_ = true;
                                        break;
                                    }
                                    local_20[_e1025] = (((bitcast<u32>(select(_e995, _e992, _e996)) >> bitcast<u32>(_e999)) & 2097151u) | (select(0u, 1u, _e996) << bitcast<u32>(21u)));
                                    let _e1029 = ((_e1023 + 2u) % 7u);
                                    if (_e1029 < 7u) {
                                    } else {
                                        phi_2603_ = true;
                                        break;
                                    }
                                    local_20[_e1029] = (((bitcast<u32>(select(_e1012, _e1009, _e1013)) >> bitcast<u32>(_e999)) & 2097151u) | (select(0u, 1u, _e1013) << bitcast<u32>(21u)));
                                }
                                continue;
                                continuing {
                                    phi_1599_ = _e967;
                                    phi_2603_ = _e716;
                                    break if !(_e973);
                                }
                            }
                            let _e1034 = phi_2603_;
                            if _e1034 {
                                break;
                            }
                            local_7 = array<i32, 3>(0i, 0i, 0i);
                            local_6 = array<i32, 3>(0i, 0i, 0i);
                            local_5 = array<i32, 3>(0i, 0i, 0i);
                            local_4 = array<i32, 3>(0i, 0i, 0i);
                            phi_1797_ = type_8(0u, 3u);
                            loop {
                                let _e1036 = phi_1797_;
                                if (_e1036.member < _e1036.member_1) {
                                    phi_1798_ = type_8((_e1036.member + 1u), _e1036.member_1);
                                    phi_1821_ = type_8(1u, _e1036.member);
                                } else {
                                    phi_1798_ = _e1036;
                                    phi_1821_ = type_8(0u, type_8().member_1);
                                }
                                let _e1049 = phi_1798_;
                                let _e1051 = phi_1821_;
                                let _e1055 = (bitcast<i32>(_e1051.member) != 0i);
                                if _e1055 {
                                    let _e1056 = (_e1051.member_1 * 2u);
                                    let _e1058 = ((1u + _e1056) % 7u);
                                    if (_e1058 < 7u) {
                                    } else {
                                        phi_2619_ = true;
                                        break;
                                    }
                                    let _e1061 = local_20[_e1058];
                                    let _e1063 = ((_e1056 + 2u) % 7u);
                                    if (_e1063 < 7u) {
                                    } else {
                                        phi_2619_ = true;
                                        break;
                                    }
                                    let _e1066 = local_20[_e1063];
                                    let _e1067 = (_e1051.member_1 < 3u);
                                    if _e1067 {
                                    } else {
                                        phi_2619_ = true;
                                        break;
                                    }
                                    let _e1069 = local_9[_e1051.member_1];
                                    if _e1067 {
                                    } else {
                                        phi_2619_ = true;
                                        break;
                                    }
                                    let _e1071 = local_8[_e1051.member_1];
                                    let _e1073 = bitcast<u32>((_e1071 - _e1069));
                                    let _e1079 = (32u - select((bitcast<u32>(31i) - firstLeadingBit(_e1073)), 32u, (_e1073 == 0u)));
                                    let _e1084 = ((select(21u, _e1079, (_e1079 > 21u)) - 21u) & 31u);
                                    let _e1088 = (_e1069 + bitcast<i32>(((_e1061 & 2097151u) << bitcast<u32>(_e1084))));
                                    let _e1093 = (_e1071 - bitcast<i32>(((_e1066 & 2097151u) << bitcast<u32>(_e1084))));
                                    let _e1097 = (((_e1061 >> bitcast<u32>(21u)) & 1u) == 1u);
                                    let _e1101 = (((_e1066 >> bitcast<u32>(21u)) & 1u) == 1u);
                                    if _e1067 {
                                    } else {
                                        phi_2619_ = true;
                                        break;
                                    }
                                    local_7[_e1051.member_1] = select(_e1069, _e1088, _e1097);
                                    if _e1067 {
                                    } else {
                                        phi_2619_ = true;
                                        break;
                                    }
                                    local_5[_e1051.member_1] = select(_e1088, _e1069, _e1097);
                                    if _e1067 {
                                    } else {
                                        phi_2619_ = true;
                                        break;
                                    }
                                    local_6[_e1051.member_1] = select(_e1071, _e1093, _e1101);
                                    if _e1067 {
                                    } else {
                                        phi_2619_ = true;
                                        break;
                                    }
                                    local_4[_e1051.member_1] = select(_e1093, _e1071, _e1101);
                                }
                                continue;
                                continuing {
                                    phi_1797_ = _e1049;
                                    phi_2619_ = _e1034;
                                    break if !(_e1055);
                                }
                            }
                            let _e1112 = phi_2619_;
                            if _e1112 {
                                break;
                            }
                            let _e1113 = local_4;
                            let _e1114 = local_5;
                            let _e1115 = local_6;
                            let _e1116 = local_7;
                            let _e1117 = local_20;
                            if _e109 {
                            } else {
                                break;
                            }
                            global_8.member[_e103] = array<u32, 7>(_e1117[0], _e1117[1], _e1117[2], _e1117[3], _e1117[4], _e1117[5], _e1117[6]);
                            if _e110 {
                            } else {
                                break;
                            }
                            global_5.member[_e103] = type_34(array<i32, 3>(_e718[0], _e718[1], _e718[2]), array<i32, 3>(_e717[0], _e717[1], _e717[2]));
                            if _e108 {
                            } else {
                                break;
                            }
                            if ((_e722 & 2147483648u) != 0u) {
                                let _e1159 = ((bitcast<u32>((_e1115[0] - _e1116[0])) | bitcast<u32>((_e1115[1] - _e1116[1]))) | bitcast<u32>((_e1115[2] - _e1116[2])));
                                if (_e1159 < 1024u) {
                                    phi_2176_ = 0u;
                                } else {
                                    phi_2176_ = select(2u, 1u, (_e1159 < 2097152u));
                                }
                                let _e1164 = phi_2176_;
                                switch bitcast<i32>(_e1164) {
                                    case 0: {
                                        phi_2182_ = 1u;
                                        break;
                                    }
                                    case 1: {
                                        phi_2182_ = 2u;
                                        break;
                                    }
                                    case 2: {
                                        phi_2182_ = 3u;
                                        break;
                                    }
                                    default: {
                                        phi_2182_ = u32();
                                        break;
                                    }
                                }
                                let _e1167 = phi_2182_;
                                phi_2189_ = type_8(0u, ((_e722 >> bitcast<u32>(28u)) & 7u));
                                loop {
                                    let _e1175 = phi_2189_;
                                    if (_e1175.member < _e1175.member_1) {
                                        phi_2190_ = type_8((_e1175.member + 1u), _e1175.member_1);
                                        phi_2213_ = type_8(1u, _e1175.member);
                                    } else {
                                        phi_2190_ = _e1175;
                                        phi_2213_ = type_8(0u, type_8().member_1);
                                    }
                                    let _e1188 = phi_2190_;
                                    let _e1190 = phi_2213_;
                                    let _e1194 = (bitcast<i32>(_e1190.member) != 0i);
                                    if _e1194 {
                                        let _e1196 = ((_e722 & 268435455u) + _e1190.member_1);
                                        let _e1197 = (_e1196 < _e82);
                                        if _e1197 {
                                            if _e1197 {
                                            } else {
                                                phi_2636_ = true;
                                                break;
                                            }
                                            global_6.member[_e1196] = ((3u * _e1167) + 1u);
                                        }
                                    }
                                    continue;
                                    continuing {
                                        phi_2189_ = _e1188;
                                        phi_2636_ = _e1112;
                                        break if !(_e1194);
                                    }
                                }
                                let _e1201 = phi_2636_;
                                if _e1201 {
                                    break;
                                }
                                phi_2651_ = _e1201;
                            } else {
                                phi_2651_ = _e1112;
                            }
                            let _e1203 = phi_2651_;
                            if _e108 {
                            } else {
                                break;
                            }
                            if ((_e753 & 2147483648u) != 0u) {
                                let _e1213 = ((bitcast<u32>((_e1113[0] - _e1114[0])) | bitcast<u32>((_e1113[1] - _e1114[1]))) | bitcast<u32>((_e1113[2] - _e1114[2])));
                                if (_e1213 < 1024u) {
                                    phi_2309_ = 0u;
                                } else {
                                    phi_2309_ = select(2u, 1u, (_e1213 < 2097152u));
                                }
                                let _e1218 = phi_2309_;
                                switch bitcast<i32>(_e1218) {
                                    case 0: {
                                        phi_2315_ = 1u;
                                        break;
                                    }
                                    case 1: {
                                        phi_2315_ = 2u;
                                        break;
                                    }
                                    case 2: {
                                        phi_2315_ = 3u;
                                        break;
                                    }
                                    default: {
                                        phi_2315_ = u32();
                                        break;
                                    }
                                }
                                let _e1221 = phi_2315_;
                                phi_2322_ = type_8(0u, ((_e753 >> bitcast<u32>(28u)) & 7u));
                                loop {
                                    let _e1229 = phi_2322_;
                                    if (_e1229.member < _e1229.member_1) {
                                        phi_2323_ = type_8((_e1229.member + 1u), _e1229.member_1);
                                        phi_2346_ = type_8(1u, _e1229.member);
                                    } else {
                                        phi_2323_ = _e1229;
                                        phi_2346_ = type_8(0u, type_8().member_1);
                                    }
                                    let _e1242 = phi_2323_;
                                    let _e1244 = phi_2346_;
                                    let _e1248 = (bitcast<i32>(_e1244.member) != 0i);
                                    if _e1248 {
                                        let _e1250 = ((_e753 & 268435455u) + _e1244.member_1);
                                        let _e1251 = (_e1250 < _e82);
                                        if _e1251 {
                                            if _e1251 {
                                            } else {
                                                phi_2644_ = true;
                                                break;
                                            }
                                            global_6.member[_e1250] = ((3u * _e1221) + 1u);
                                        }
                                    }
                                    continue;
                                    continuing {
                                        phi_2322_ = _e1242;
                                        phi_2644_ = _e1203;
                                        break if !(_e1248);
                                    }
                                }
                                let _e1255 = phi_2644_;
                                if _e1255 {
                                    break;
                                }
                            }
                            if (_e103 == 0u) {
                                if (_e85 == 0u) {
                                } else {
                                    if (0u < _e85) {
                                    } else {
                                        break;
                                    }
                                    global_7.member[0u] = type_28(array<u32, 4>(bitcast<u32>(_e718[0]), bitcast<u32>(_e718[1]), bitcast<u32>(_e718[2]), bitcast<u32>(_e99)), array<u32, 4>(bitcast<u32>(_e717[0]), bitcast<u32>(_e717[1]), bitcast<u32>(_e717[2]), 0u));
                                }
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
fn encode_q21_sizes(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
