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
    member: array<array<f32, 4>, 3>,
    member_1: u32,
    member_2: u32,
    member_3: u32,
    member_4: u32,
}

struct type_27 {
    member: array<type_25>,
}

struct type_30 {
    member: vec3<f32>,
    member_1: vec3<f32>,
}

struct type_31 {
    member: array<u32, 4>,
    member_1: array<u32, 4>,
}

struct type_33 {
    member: array<type_31>,
}

struct type_38 {
    member: array<i32, 3>,
    member_1: array<i32, 3>,
}

struct type_44 {
    member: array<type_38>,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_1: type_16;
@group(0) @binding(1) 
var<uniform> global_2: type_16;
@group(0) @binding(2) 
var<uniform> global_3: type_16;
@group(0) @binding(3) 
var<storage> global_4: type_27;
@group(0) @binding(4) 
var<storage, read_write> global_5: type_13;
@group(0) @binding(5) 
var<storage, read_write> global_6: type_44;
@group(0) @binding(6) 
var<storage, read_write> global_7: type_4;
@group(0) @binding(7) 
var<storage, read_write> global_8: type_33;

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
    var local_20: array<u32, 4>;
    var local_21: array<u32, 4>;
    var phi_183_: i32;
    var phi_229_: type_25;
    var phi_247_: type_30;
    var phi_265_: type_30;
    var phi_2540_: bool;
    var phi_442_: type_8;
    var phi_445_: u32;
    var phi_443_: type_8;
    var phi_468_: type_8;
    var phi_490_: type_25;
    var phi_498_: bool;
    var phi_516_: type_30;
    var phi_534_: type_30;
    var phi_806_: type_8;
    var phi_807_: type_8;
    var phi_830_: type_8;
    var phi_2531_: bool;
    var phi_1004_: type_8;
    var phi_1005_: type_8;
    var phi_1028_: type_8;
    var phi_2562_: bool;
    var phi_1233_: type_38;
    var phi_2581_: bool;
    var phi_1251_: u32;
    var phi_2580_: bool;
    var phi_446_: u32;
    var phi_1253_: bool;
    var phi_2579_: bool;
    var phi_1304_: type_30;
    var phi_1326_: type_30;
    var phi_1598_: type_8;
    var phi_1599_: type_8;
    var phi_1622_: type_8;
    var phi_2584_: bool;
    var phi_1796_: type_8;
    var phi_1797_: type_8;
    var phi_1820_: type_8;
    var phi_2600_: bool;
    var phi_2166_: u32;
    var phi_2172_: u32;
    var phi_2179_: type_8;
    var phi_2180_: type_8;
    var phi_2203_: type_8;
    var phi_2617_: bool;
    var phi_2632_: bool;
    var phi_2299_: u32;
    var phi_2305_: u32;
    var phi_2312_: type_8;
    var phi_2313_: type_8;
    var phi_2336_: type_8;
    var phi_2625_: bool;

    switch bitcast<i32>(0u) {
        default: {
            let _e73 = global;
            let _e75 = arrayLength((&global_4.member));
            let _e83 = arrayLength((&global_7.member));
            let _e86 = arrayLength((&global_8.member));
            let _e89 = global_3.member[0u];
            let _e93 = global_2.member[0u];
            let _e95 = (bitcast<i32>(_e89) + bitcast<i32>(_e93));
            if (_e95 < -126i) {
                phi_183_ = -126i;
            } else {
                phi_183_ = select(_e95, 127i, (_e95 > 127i));
            }
            let _e100 = phi_183_;
            let _e104 = (_e73.x + (_e73.y * 2097152u));
            let _e107 = global_1.member[0u];
            if (_e104 < _e107) {
                let _e109 = (_e104 < _e75);
                if _e109 {
                    let _e110 = (_e104 < arrayLength((&global_5.member)));
                    if _e110 {
                        let _e111 = (_e104 < arrayLength((&global_6.member)));
                        if _e111 {
                            let _e112 = (0u < _e75);
                            if _e112 {
                                if _e112 {
                                } else {
                                    break;
                                }
                                let _e115 = global_4.member[0u];
                                phi_229_ = _e115;
                            } else {
                                phi_229_ = type_25(array<array<f32, 4>, 3>(array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f)), 2147483648u, 2147483648u, 0u, 0u);
                            }
                            let _e117 = phi_229_;
                            if (_e117.member_1 == 2147483648u) {
                                phi_247_ = type_30(vec3<f32>(0f, 0f, 0f), vec3<f32>(0f, 0f, 0f));
                            } else {
                                phi_247_ = type_30(vec3<f32>(_e117.member[0][0], _e117.member[1][0], _e117.member[2][0]), vec3<f32>(_e117.member[0][2], _e117.member[1][2], _e117.member[2][2]));
                            }
                            let _e136 = phi_247_;
                            if (_e117.member_2 == 2147483648u) {
                                phi_265_ = _e136;
                            } else {
                                phi_265_ = type_30(vec3<f32>(_e117.member[0][1], _e117.member[1][1], _e117.member[2][1]), vec3<f32>(_e117.member[0][3], _e117.member[1][3], _e117.member[2][3]));
                            }
                            let _e155 = phi_265_;
                            let _e188 = bitcast<f32>((bitcast<u32>((127i - _e100)) << bitcast<u32>(23i)));
                            let _e189 = (select(_e155.member.x, _e136.member.x, (_e136.member.x < _e155.member.x)) * _e188);
                            let _e196 = select(0i, select(select(i32(_e189), i32(-2147483648), (_e189 < -2147483600f)), 2147483647i, (_e189 > 2147483500f)), (_e189 == _e189));
                            let _e201 = (select(_e155.member.y, _e136.member.y, (_e136.member.y < _e155.member.y)) * _e188);
                            let _e208 = select(0i, select(select(i32(_e201), i32(-2147483648), (_e201 < -2147483600f)), 2147483647i, (_e201 > 2147483500f)), (_e201 == _e201));
                            let _e213 = (select(_e155.member.z, _e136.member.z, (_e136.member.z < _e155.member.z)) * _e188);
                            let _e220 = select(0i, select(select(i32(_e213), i32(-2147483648), (_e213 < -2147483600f)), 2147483647i, (_e213 > 2147483500f)), (_e213 == _e213));
                            let _e225 = (select(_e155.member_1.x, _e136.member_1.x, (_e136.member_1.x > _e155.member_1.x)) * _e188);
                            let _e232 = select(0i, select(select(i32(_e225), i32(-2147483648), (_e225 < -2147483600f)), 2147483647i, (_e225 > 2147483500f)), (_e225 == _e225));
                            let _e237 = (select(_e155.member_1.y, _e136.member_1.y, (_e136.member_1.y > _e155.member_1.y)) * _e188);
                            let _e244 = select(0i, select(select(i32(_e237), i32(-2147483648), (_e237 < -2147483600f)), 2147483647i, (_e237 > 2147483500f)), (_e237 == _e237));
                            let _e249 = (select(_e155.member_1.z, _e136.member_1.z, (_e136.member_1.z > _e155.member_1.z)) * _e188);
                            let _e256 = select(0i, select(select(i32(_e249), i32(-2147483648), (_e249 < -2147483600f)), 2147483647i, (_e249 > 2147483500f)), (_e249 == _e249));
                            local_11 = array<i32, 3>((_e196 - select(0i, 1i, (f32(_e196) > _e189))), (_e208 - select(0i, 1i, (f32(_e208) > _e201))), (_e220 - select(0i, 1i, (f32(_e220) > _e213))));
                            local_10 = array<i32, 3>((_e232 + select(0i, 1i, (f32(_e232) < _e225))), (_e244 + select(0i, 1i, (f32(_e244) < _e237))), (_e256 + select(0i, 1i, (f32(_e256) < _e249))));
                            phi_2540_ = false;
                            phi_442_ = type_8(0u, 128u);
                            phi_445_ = 0u;
                            loop {
                                let _e264 = phi_2540_;
                                let _e266 = phi_442_;
                                let _e268 = phi_445_;
                                if (_e266.member < _e266.member_1) {
                                    phi_443_ = type_8((_e266.member + 1u), _e266.member_1);
                                    phi_468_ = type_8(1u, _e266.member);
                                } else {
                                    phi_443_ = _e266;
                                    phi_468_ = type_8(0u, type_8().member_1);
                                }
                                let _e281 = phi_443_;
                                let _e283 = phi_468_;
                                if (bitcast<i32>(_e283.member) != 0i) {
                                    let _e287 = (_e268 == _e104);
                                    if _e287 {
                                        phi_2581_ = _e264;
                                        phi_1251_ = u32();
                                    } else {
                                        let _e288 = (_e268 < _e75);
                                        if _e288 {
                                            if _e288 {
                                            } else {
                                                phi_2579_ = true;
                                                break;
                                            }
                                            let _e291 = global_4.member[_e268];
                                            phi_490_ = _e291;
                                        } else {
                                            phi_490_ = type_25(array<array<f32, 4>, 3>(array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f)), 2147483648u, 2147483648u, 0u, 0u);
                                        }
                                        let _e293 = phi_490_;
                                        if ((_e293.member_1 & 2147483648u) != 0u) {
                                            phi_498_ = false;
                                        } else {
                                            phi_498_ = (_e104 <= _e293.member_1);
                                        }
                                        let _e299 = phi_498_;
                                        if (_e293.member_1 == 2147483648u) {
                                            phi_516_ = type_30(vec3<f32>(0f, 0f, 0f), vec3<f32>(0f, 0f, 0f));
                                        } else {
                                            phi_516_ = type_30(vec3<f32>(_e293.member[0][0], _e293.member[1][0], _e293.member[2][0]), vec3<f32>(_e293.member[0][2], _e293.member[1][2], _e293.member[2][2]));
                                        }
                                        let _e317 = phi_516_;
                                        if (_e293.member_2 == 2147483648u) {
                                            phi_534_ = _e317;
                                        } else {
                                            phi_534_ = type_30(vec3<f32>(_e293.member[0][1], _e293.member[1][1], _e293.member[2][1]), vec3<f32>(_e293.member[0][3], _e293.member[1][3], _e293.member[2][3]));
                                        }
                                        let _e336 = phi_534_;
                                        let _e349 = (_e317.member.x * _e188);
                                        let _e356 = select(0i, select(select(i32(_e349), i32(-2147483648), (_e349 < -2147483600f)), 2147483647i, (_e349 > 2147483500f)), (_e349 == _e349));
                                        let _e361 = (_e317.member.y * _e188);
                                        let _e368 = select(0i, select(select(i32(_e361), i32(-2147483648), (_e361 < -2147483600f)), 2147483647i, (_e361 > 2147483500f)), (_e361 == _e361));
                                        let _e373 = (_e317.member.z * _e188);
                                        let _e380 = select(0i, select(select(i32(_e373), i32(-2147483648), (_e373 < -2147483600f)), 2147483647i, (_e373 > 2147483500f)), (_e373 == _e373));
                                        let _e385 = (_e317.member_1.x * _e188);
                                        let _e392 = select(0i, select(select(i32(_e385), i32(-2147483648), (_e385 < -2147483600f)), 2147483647i, (_e385 > 2147483500f)), (_e385 == _e385));
                                        let _e397 = (_e317.member_1.y * _e188);
                                        let _e404 = select(0i, select(select(i32(_e397), i32(-2147483648), (_e397 < -2147483600f)), 2147483647i, (_e397 > 2147483500f)), (_e397 == _e397));
                                        let _e409 = (_e317.member_1.z * _e188);
                                        let _e416 = select(0i, select(select(i32(_e409), i32(-2147483648), (_e409 < -2147483600f)), 2147483647i, (_e409 > 2147483500f)), (_e409 == _e409));
                                        local_15 = array<i32, 3>((_e356 - select(0i, 1i, (f32(_e356) > _e349))), (_e368 - select(0i, 1i, (f32(_e368) > _e361))), (_e380 - select(0i, 1i, (f32(_e380) > _e373))));
                                        local_14 = array<i32, 3>((_e392 + select(0i, 1i, (f32(_e392) < _e385))), (_e404 + select(0i, 1i, (f32(_e404) < _e397))), (_e416 + select(0i, 1i, (f32(_e416) < _e409))));
                                        let _e435 = (_e336.member.x * _e188);
                                        let _e442 = select(0i, select(select(i32(_e435), i32(-2147483648), (_e435 < -2147483600f)), 2147483647i, (_e435 > 2147483500f)), (_e435 == _e435));
                                        let _e447 = (_e336.member.y * _e188);
                                        let _e454 = select(0i, select(select(i32(_e447), i32(-2147483648), (_e447 < -2147483600f)), 2147483647i, (_e447 > 2147483500f)), (_e447 == _e447));
                                        let _e459 = (_e336.member.z * _e188);
                                        let _e466 = select(0i, select(select(i32(_e459), i32(-2147483648), (_e459 < -2147483600f)), 2147483647i, (_e459 > 2147483500f)), (_e459 == _e459));
                                        let _e471 = (_e336.member_1.x * _e188);
                                        let _e478 = select(0i, select(select(i32(_e471), i32(-2147483648), (_e471 < -2147483600f)), 2147483647i, (_e471 > 2147483500f)), (_e471 == _e471));
                                        let _e483 = (_e336.member_1.y * _e188);
                                        let _e490 = select(0i, select(select(i32(_e483), i32(-2147483648), (_e483 < -2147483600f)), 2147483647i, (_e483 > 2147483500f)), (_e483 == _e483));
                                        let _e495 = (_e336.member_1.z * _e188);
                                        let _e502 = select(0i, select(select(i32(_e495), i32(-2147483648), (_e495 < -2147483600f)), 2147483647i, (_e495 > 2147483500f)), (_e495 == _e495));
                                        local_13 = array<i32, 3>((_e442 - select(0i, 1i, (f32(_e442) > _e435))), (_e454 - select(0i, 1i, (f32(_e454) > _e447))), (_e466 - select(0i, 1i, (f32(_e466) > _e459))));
                                        local_12 = array<i32, 3>((_e478 + select(0i, 1i, (f32(_e478) < _e471))), (_e490 + select(0i, 1i, (f32(_e490) < _e483))), (_e502 + select(0i, 1i, (f32(_e502) < _e495))));
                                        local_21 = array<u32, 4>(0u, 0u, 0u, 0u);
                                        phi_806_ = type_8(0u, 3u);
                                        loop {
                                            let _e510 = phi_806_;
                                            if (_e510.member < _e510.member_1) {
                                                phi_807_ = type_8((_e510.member + 1u), _e510.member_1);
                                                phi_830_ = type_8(1u, _e510.member);
                                            } else {
                                                phi_807_ = _e510;
                                                phi_830_ = type_8(0u, type_8().member_1);
                                            }
                                            let _e523 = phi_807_;
                                            let _e525 = phi_830_;
                                            let _e529 = (bitcast<i32>(_e525.member) != 0i);
                                            if _e529 {
                                                let _e530 = (_e525.member_1 < 3u);
                                                if _e530 {
                                                } else {
                                                    phi_2531_ = true;
                                                    break;
                                                }
                                                let _e532 = local_11[_e525.member_1];
                                                if _e530 {
                                                } else {
                                                    phi_2531_ = true;
                                                    break;
                                                }
                                                let _e534 = local_10[_e525.member_1];
                                                let _e536 = bitcast<u32>((_e534 - _e532));
                                                let _e542 = (32u - select((bitcast<u32>(31i) - firstLeadingBit(_e536)), 32u, (_e536 == 0u)));
                                                if _e530 {
                                                } else {
                                                    phi_2531_ = true;
                                                    break;
                                                }
                                                let _e547 = local_15[_e525.member_1];
                                                let _e548 = (_e547 - _e532);
                                                if _e530 {
                                                } else {
                                                    phi_2531_ = true;
                                                    break;
                                                }
                                                let _e550 = local_13[_e525.member_1];
                                                let _e551 = (_e550 - _e532);
                                                let _e552 = (_e548 > _e551);
                                                let _e555 = ((select(10u, _e542, (_e542 > 10u)) - 10u) & 31u);
                                                if _e530 {
                                                } else {
                                                    phi_2531_ = true;
                                                    break;
                                                }
                                                let _e564 = local_14[_e525.member_1];
                                                let _e565 = (_e534 - _e564);
                                                if _e530 {
                                                } else {
                                                    phi_2531_ = true;
                                                    break;
                                                }
                                                let _e567 = local_12[_e525.member_1];
                                                let _e568 = (_e534 - _e567);
                                                let _e569 = (_e565 > _e568);
                                                let _e582 = ((1u + _e525.member_1) % 4u);
                                                if (_e582 < 4u) {
                                                } else {
                                                    phi_2531_ = true;
                                                    break;
                                                }
                                                local_21[_e582] = ((((bitcast<u32>(select(_e551, _e548, _e552)) >> bitcast<u32>(_e555)) & 1023u) | (select(0u, 1u, _e552) << bitcast<u32>(10u))) | ((((bitcast<u32>(select(_e568, _e565, _e569)) >> bitcast<u32>(_e555)) & 1023u) | (select(0u, 1u, _e569) << bitcast<u32>(10u))) << bitcast<u32>(11u)));
                                            }
                                            continue;
                                            continuing {
                                                phi_806_ = _e523;
                                                phi_2531_ = _e264;
                                                break if !(_e529);
                                            }
                                        }
                                        let _e588 = phi_2531_;
                                        phi_2579_ = _e588;
                                        if _e588 {
                                            break;
                                        }
                                        local_3 = array<i32, 3>(0i, 0i, 0i);
                                        local_2 = array<i32, 3>(0i, 0i, 0i);
                                        local_1 = array<i32, 3>(0i, 0i, 0i);
                                        local = array<i32, 3>(0i, 0i, 0i);
                                        phi_1004_ = type_8(0u, 3u);
                                        loop {
                                            let _e590 = phi_1004_;
                                            if (_e590.member < _e590.member_1) {
                                                phi_1005_ = type_8((_e590.member + 1u), _e590.member_1);
                                                phi_1028_ = type_8(1u, _e590.member);
                                            } else {
                                                phi_1005_ = _e590;
                                                phi_1028_ = type_8(0u, type_8().member_1);
                                            }
                                            let _e603 = phi_1005_;
                                            let _e605 = phi_1028_;
                                            let _e609 = (bitcast<i32>(_e605.member) != 0i);
                                            if _e609 {
                                                let _e611 = ((1u + _e605.member_1) % 4u);
                                                if (_e611 < 4u) {
                                                } else {
                                                    phi_2562_ = true;
                                                    break;
                                                }
                                                let _e614 = local_21[_e611];
                                                let _e616 = ((_e605.member_1 + 1u) % 4u);
                                                if (_e616 < 4u) {
                                                } else {
                                                    phi_2562_ = true;
                                                    break;
                                                }
                                                let _e619 = local_21[_e616];
                                                let _e620 = (_e605.member_1 < 3u);
                                                if _e620 {
                                                } else {
                                                    phi_2562_ = true;
                                                    break;
                                                }
                                                let _e622 = local_11[_e605.member_1];
                                                if _e620 {
                                                } else {
                                                    phi_2562_ = true;
                                                    break;
                                                }
                                                let _e624 = local_10[_e605.member_1];
                                                let _e626 = (_e619 >> bitcast<u32>(11u));
                                                let _e628 = bitcast<u32>((_e624 - _e622));
                                                let _e634 = (32u - select((bitcast<u32>(31i) - firstLeadingBit(_e628)), 32u, (_e628 == 0u)));
                                                let _e639 = ((select(10u, _e634, (_e634 > 10u)) - 10u) & 31u);
                                                let _e643 = (_e622 + bitcast<i32>(((_e614 & 1023u) << bitcast<u32>(_e639))));
                                                let _e648 = (_e624 - bitcast<i32>(((_e626 & 1023u) << bitcast<u32>(_e639))));
                                                let _e652 = (((_e614 >> bitcast<u32>(10u)) & 1u) == 1u);
                                                let _e656 = (((_e626 >> bitcast<u32>(10u)) & 1u) == 1u);
                                                if _e620 {
                                                } else {
                                                    phi_2562_ = true;
                                                    break;
                                                }
                                                local_3[_e605.member_1] = select(_e622, _e643, _e652);
                                                if _e620 {
                                                } else {
                                                    phi_2562_ = true;
                                                    break;
                                                }
                                                local_1[_e605.member_1] = select(_e643, _e622, _e652);
                                                if _e620 {
                                                } else {
                                                    phi_2562_ = true;
                                                    break;
                                                }
                                                local_2[_e605.member_1] = select(_e624, _e648, _e656);
                                                if _e620 {
                                                } else {
                                                    phi_2562_ = true;
                                                    break;
                                                }
                                                local[_e605.member_1] = select(_e648, _e624, _e656);
                                            }
                                            continue;
                                            continuing {
                                                phi_1004_ = _e603;
                                                phi_2562_ = _e588;
                                                break if !(_e609);
                                            }
                                        }
                                        let _e667 = phi_2562_;
                                        phi_2579_ = _e667;
                                        if _e667 {
                                            break;
                                        }
                                        let _e668 = local;
                                        let _e669 = local_1;
                                        let _e670 = local_2;
                                        let _e671 = local_3;
                                        if _e299 {
                                            phi_1233_ = type_38(array<i32, 3>(_e671[0], _e671[1], _e671[2]), array<i32, 3>(_e670[0], _e670[1], _e670[2]));
                                        } else {
                                            phi_1233_ = type_38(array<i32, 3>(_e669[0], _e669[1], _e669[2]), array<i32, 3>(_e668[0], _e668[1], _e668[2]));
                                        }
                                        let _e691 = phi_1233_;
                                        local_11 = array<i32, 3>(_e691.member[0], _e691.member[1], _e691.member[2]);
                                        local_10 = array<i32, 3>(_e691.member_1[0], _e691.member_1[1], _e691.member_1[2]);
                                        phi_2581_ = _e667;
                                        phi_1251_ = select(_e293.member_2, _e293.member_1, _e299);
                                    }
                                    let _e704 = phi_2581_;
                                    let _e706 = phi_1251_;
                                    phi_2580_ = _e704;
                                    phi_446_ = _e706;
                                    phi_1253_ = select(true, false, _e287);
                                } else {
                                    phi_2580_ = _e264;
                                    phi_446_ = u32();
                                    phi_1253_ = false;
                                }
                                let _e709 = phi_2580_;
                                let _e711 = phi_446_;
                                let _e713 = phi_1253_;
                                continue;
                                continuing {
                                    phi_2540_ = _e709;
                                    phi_442_ = _e281;
                                    phi_445_ = _e711;
                                    phi_2579_ = _e709;
                                    break if !(_e713);
                                }
                            }
                            let _e716 = phi_2579_;
                            if _e716 {
                                break;
                            }
                            let _e717 = local_10;
                            let _e718 = local_11;
                            local_9 = _e718;
                            local_8 = _e717;
                            if _e109 {
                            } else {
                                break;
                            }
                            let _e722 = global_4.member[_e104].member_1;
                            if (_e722 == 2147483648u) {
                                phi_1304_ = type_30(vec3<f32>(0f, 0f, 0f), vec3<f32>(0f, 0f, 0f));
                            } else {
                                let _e728 = global_4.member[_e104].member[0u];
                                let _e733 = global_4.member[_e104].member[1u];
                                let _e738 = global_4.member[_e104].member[2u];
                                phi_1304_ = type_30(vec3<f32>(_e728[0], _e733[0], _e738[0]), vec3<f32>(_e728[2], _e733[2], _e738[2]));
                            }
                            let _e749 = phi_1304_;
                            let _e753 = global_4.member[_e104].member_2;
                            if (_e753 == 2147483648u) {
                                phi_1326_ = _e749;
                            } else {
                                let _e759 = global_4.member[_e104].member[0u];
                                let _e764 = global_4.member[_e104].member[1u];
                                let _e769 = global_4.member[_e104].member[2u];
                                phi_1326_ = type_30(vec3<f32>(_e759[1], _e764[1], _e769[1]), vec3<f32>(_e759[3], _e764[3], _e769[3]));
                            }
                            let _e780 = phi_1326_;
                            let _e793 = (_e749.member.x * _e188);
                            let _e800 = select(0i, select(select(i32(_e793), i32(-2147483648), (_e793 < -2147483600f)), 2147483647i, (_e793 > 2147483500f)), (_e793 == _e793));
                            let _e805 = (_e749.member.y * _e188);
                            let _e812 = select(0i, select(select(i32(_e805), i32(-2147483648), (_e805 < -2147483600f)), 2147483647i, (_e805 > 2147483500f)), (_e805 == _e805));
                            let _e817 = (_e749.member.z * _e188);
                            let _e824 = select(0i, select(select(i32(_e817), i32(-2147483648), (_e817 < -2147483600f)), 2147483647i, (_e817 > 2147483500f)), (_e817 == _e817));
                            let _e829 = (_e749.member_1.x * _e188);
                            let _e836 = select(0i, select(select(i32(_e829), i32(-2147483648), (_e829 < -2147483600f)), 2147483647i, (_e829 > 2147483500f)), (_e829 == _e829));
                            let _e841 = (_e749.member_1.y * _e188);
                            let _e848 = select(0i, select(select(i32(_e841), i32(-2147483648), (_e841 < -2147483600f)), 2147483647i, (_e841 > 2147483500f)), (_e841 == _e841));
                            let _e853 = (_e749.member_1.z * _e188);
                            let _e860 = select(0i, select(select(i32(_e853), i32(-2147483648), (_e853 < -2147483600f)), 2147483647i, (_e853 > 2147483500f)), (_e853 == _e853));
                            local_19 = array<i32, 3>((_e800 - select(0i, 1i, (f32(_e800) > _e793))), (_e812 - select(0i, 1i, (f32(_e812) > _e805))), (_e824 - select(0i, 1i, (f32(_e824) > _e817))));
                            local_18 = array<i32, 3>((_e836 + select(0i, 1i, (f32(_e836) < _e829))), (_e848 + select(0i, 1i, (f32(_e848) < _e841))), (_e860 + select(0i, 1i, (f32(_e860) < _e853))));
                            let _e879 = (_e780.member.x * _e188);
                            let _e886 = select(0i, select(select(i32(_e879), i32(-2147483648), (_e879 < -2147483600f)), 2147483647i, (_e879 > 2147483500f)), (_e879 == _e879));
                            let _e891 = (_e780.member.y * _e188);
                            let _e898 = select(0i, select(select(i32(_e891), i32(-2147483648), (_e891 < -2147483600f)), 2147483647i, (_e891 > 2147483500f)), (_e891 == _e891));
                            let _e903 = (_e780.member.z * _e188);
                            let _e910 = select(0i, select(select(i32(_e903), i32(-2147483648), (_e903 < -2147483600f)), 2147483647i, (_e903 > 2147483500f)), (_e903 == _e903));
                            let _e915 = (_e780.member_1.x * _e188);
                            let _e922 = select(0i, select(select(i32(_e915), i32(-2147483648), (_e915 < -2147483600f)), 2147483647i, (_e915 > 2147483500f)), (_e915 == _e915));
                            let _e927 = (_e780.member_1.y * _e188);
                            let _e934 = select(0i, select(select(i32(_e927), i32(-2147483648), (_e927 < -2147483600f)), 2147483647i, (_e927 > 2147483500f)), (_e927 == _e927));
                            let _e939 = (_e780.member_1.z * _e188);
                            let _e946 = select(0i, select(select(i32(_e939), i32(-2147483648), (_e939 < -2147483600f)), 2147483647i, (_e939 > 2147483500f)), (_e939 == _e939));
                            local_17 = array<i32, 3>((_e886 - select(0i, 1i, (f32(_e886) > _e879))), (_e898 - select(0i, 1i, (f32(_e898) > _e891))), (_e910 - select(0i, 1i, (f32(_e910) > _e903))));
                            local_16 = array<i32, 3>((_e922 + select(0i, 1i, (f32(_e922) < _e915))), (_e934 + select(0i, 1i, (f32(_e934) < _e927))), (_e946 + select(0i, 1i, (f32(_e946) < _e939))));
                            local_20 = array<u32, 4>(0u, 0u, 0u, 0u);
                            phi_1598_ = type_8(0u, 3u);
                            loop {
                                let _e954 = phi_1598_;
                                if (_e954.member < _e954.member_1) {
                                    phi_1599_ = type_8((_e954.member + 1u), _e954.member_1);
                                    phi_1622_ = type_8(1u, _e954.member);
                                } else {
                                    phi_1599_ = _e954;
                                    phi_1622_ = type_8(0u, type_8().member_1);
                                }
                                let _e967 = phi_1599_;
                                let _e969 = phi_1622_;
                                let _e973 = (bitcast<i32>(_e969.member) != 0i);
                                if _e973 {
                                    let _e974 = (_e969.member_1 < 3u);
                                    if _e974 {
                                    } else {
                                        phi_2584_ = true;
                                        break;
                                    }
                                    let _e976 = local_9[_e969.member_1];
                                    if _e974 {
                                    } else {
                                        phi_2584_ = true;
                                        break;
                                    }
                                    let _e978 = local_8[_e969.member_1];
                                    let _e980 = bitcast<u32>((_e978 - _e976));
                                    let _e986 = (32u - select((bitcast<u32>(31i) - firstLeadingBit(_e980)), 32u, (_e980 == 0u)));
                                    if _e974 {
                                    } else {
                                        phi_2584_ = true;
                                        break;
                                    }
                                    let _e991 = local_19[_e969.member_1];
                                    let _e992 = (_e991 - _e976);
                                    if _e974 {
                                    } else {
                                        phi_2584_ = true;
                                        break;
                                    }
                                    let _e994 = local_17[_e969.member_1];
                                    let _e995 = (_e994 - _e976);
                                    let _e996 = (_e992 > _e995);
                                    let _e999 = ((select(10u, _e986, (_e986 > 10u)) - 10u) & 31u);
                                    if _e974 {
                                    } else {
                                        phi_2584_ = true;
                                        break;
                                    }
                                    let _e1008 = local_18[_e969.member_1];
                                    let _e1009 = (_e978 - _e1008);
                                    if _e974 {
                                    } else {
                                        phi_2584_ = true;
                                        break;
                                    }
                                    let _e1011 = local_16[_e969.member_1];
                                    let _e1012 = (_e978 - _e1011);
                                    let _e1013 = (_e1009 > _e1012);
                                    let _e1026 = ((1u + _e969.member_1) % 4u);
                                    if (_e1026 < 4u) {
                                    } else {
                                        phi_2584_ = true;
                                        break;
                                    }
                                    local_20[_e1026] = ((((bitcast<u32>(select(_e995, _e992, _e996)) >> bitcast<u32>(_e999)) & 1023u) | (select(0u, 1u, _e996) << bitcast<u32>(10u))) | ((((bitcast<u32>(select(_e1012, _e1009, _e1013)) >> bitcast<u32>(_e999)) & 1023u) | (select(0u, 1u, _e1013) << bitcast<u32>(10u))) << bitcast<u32>(11u)));
                                }
                                continue;
                                continuing {
                                    phi_1598_ = _e967;
                                    phi_2584_ = _e716;
                                    break if !(_e973);
                                }
                            }
                            let _e1032 = phi_2584_;
                            if _e1032 {
                                break;
                            }
                            local_7 = array<i32, 3>(0i, 0i, 0i);
                            local_6 = array<i32, 3>(0i, 0i, 0i);
                            local_5 = array<i32, 3>(0i, 0i, 0i);
                            local_4 = array<i32, 3>(0i, 0i, 0i);
                            phi_1796_ = type_8(0u, 3u);
                            loop {
                                let _e1034 = phi_1796_;
                                if (_e1034.member < _e1034.member_1) {
                                    phi_1797_ = type_8((_e1034.member + 1u), _e1034.member_1);
                                    phi_1820_ = type_8(1u, _e1034.member);
                                } else {
                                    phi_1797_ = _e1034;
                                    phi_1820_ = type_8(0u, type_8().member_1);
                                }
                                let _e1047 = phi_1797_;
                                let _e1049 = phi_1820_;
                                let _e1053 = (bitcast<i32>(_e1049.member) != 0i);
                                if _e1053 {
                                    let _e1055 = ((1u + _e1049.member_1) % 4u);
                                    if (_e1055 < 4u) {
                                    } else {
                                        phi_2600_ = true;
                                        break;
                                    }
                                    let _e1058 = local_20[_e1055];
                                    let _e1060 = ((_e1049.member_1 + 1u) % 4u);
                                    if (_e1060 < 4u) {
                                    } else {
                                        phi_2600_ = true;
                                        break;
                                    }
                                    let _e1063 = local_20[_e1060];
                                    let _e1064 = (_e1049.member_1 < 3u);
                                    if _e1064 {
                                    } else {
                                        phi_2600_ = true;
                                        break;
                                    }
                                    let _e1066 = local_9[_e1049.member_1];
                                    if _e1064 {
                                    } else {
                                        phi_2600_ = true;
                                        break;
                                    }
                                    let _e1068 = local_8[_e1049.member_1];
                                    let _e1070 = (_e1063 >> bitcast<u32>(11u));
                                    let _e1072 = bitcast<u32>((_e1068 - _e1066));
                                    let _e1078 = (32u - select((bitcast<u32>(31i) - firstLeadingBit(_e1072)), 32u, (_e1072 == 0u)));
                                    let _e1083 = ((select(10u, _e1078, (_e1078 > 10u)) - 10u) & 31u);
                                    let _e1087 = (_e1066 + bitcast<i32>(((_e1058 & 1023u) << bitcast<u32>(_e1083))));
                                    let _e1092 = (_e1068 - bitcast<i32>(((_e1070 & 1023u) << bitcast<u32>(_e1083))));
                                    let _e1096 = (((_e1058 >> bitcast<u32>(10u)) & 1u) == 1u);
                                    let _e1100 = (((_e1070 >> bitcast<u32>(10u)) & 1u) == 1u);
                                    if _e1064 {
                                    } else {
                                        phi_2600_ = true;
                                        break;
                                    }
                                    local_7[_e1049.member_1] = select(_e1066, _e1087, _e1096);
                                    if _e1064 {
                                    } else {
                                        phi_2600_ = true;
                                        break;
                                    }
                                    local_5[_e1049.member_1] = select(_e1087, _e1066, _e1096);
                                    if _e1064 {
                                    } else {
                                        phi_2600_ = true;
                                        break;
                                    }
                                    local_6[_e1049.member_1] = select(_e1068, _e1092, _e1100);
                                    if _e1064 {
                                    } else {
                                        phi_2600_ = true;
                                        break;
                                    }
                                    local_4[_e1049.member_1] = select(_e1092, _e1068, _e1100);
                                }
                                continue;
                                continuing {
                                    phi_1796_ = _e1047;
                                    phi_2600_ = _e1032;
                                    break if !(_e1053);
                                }
                            }
                            let _e1111 = phi_2600_;
                            if _e1111 {
                                break;
                            }
                            let _e1112 = local_4;
                            let _e1113 = local_5;
                            let _e1114 = local_6;
                            let _e1115 = local_7;
                            let _e1116 = local_20;
                            if _e110 {
                            } else {
                                break;
                            }
                            global_5.member[_e104] = array<u32, 4>(_e1116[0], _e1116[1], _e1116[2], _e1116[3]);
                            if _e111 {
                            } else {
                                break;
                            }
                            global_6.member[_e104] = type_38(array<i32, 3>(_e718[0], _e718[1], _e718[2]), array<i32, 3>(_e717[0], _e717[1], _e717[2]));
                            if _e109 {
                            } else {
                                break;
                            }
                            if ((_e722 & 2147483648u) != 0u) {
                                let _e1155 = ((bitcast<u32>((_e1114[0] - _e1115[0])) | bitcast<u32>((_e1114[1] - _e1115[1]))) | bitcast<u32>((_e1114[2] - _e1115[2])));
                                if (_e1155 < 1024u) {
                                    phi_2166_ = 0u;
                                } else {
                                    phi_2166_ = select(2u, 1u, (_e1155 < 2097152u));
                                }
                                let _e1160 = phi_2166_;
                                switch bitcast<i32>(_e1160) {
                                    case 0: {
                                        phi_2172_ = 1u;
                                        break;
                                    }
                                    case 1: {
                                        phi_2172_ = 2u;
                                        break;
                                    }
                                    case 2: {
                                        phi_2172_ = 3u;
                                        break;
                                    }
                                    default: {
                                        phi_2172_ = u32();
                                        break;
                                    }
                                }
                                let _e1163 = phi_2172_;
                                phi_2179_ = type_8(0u, ((_e722 >> bitcast<u32>(28u)) & 7u));
                                loop {
                                    let _e1171 = phi_2179_;
                                    if (_e1171.member < _e1171.member_1) {
                                        phi_2180_ = type_8((_e1171.member + 1u), _e1171.member_1);
                                        phi_2203_ = type_8(1u, _e1171.member);
                                    } else {
                                        phi_2180_ = _e1171;
                                        phi_2203_ = type_8(0u, type_8().member_1);
                                    }
                                    let _e1184 = phi_2180_;
                                    let _e1186 = phi_2203_;
                                    let _e1190 = (bitcast<i32>(_e1186.member) != 0i);
                                    if _e1190 {
                                        let _e1192 = ((_e722 & 268435455u) + _e1186.member_1);
                                        let _e1193 = (_e1192 < _e83);
                                        if _e1193 {
                                            if _e1193 {
                                            } else {
                                                phi_2617_ = true;
                                                break;
                                            }
                                            global_7.member[_e1192] = ((3u * _e1163) + 1u);
                                        }
                                    }
                                    continue;
                                    continuing {
                                        phi_2179_ = _e1184;
                                        phi_2617_ = _e1111;
                                        break if !(_e1190);
                                    }
                                }
                                let _e1197 = phi_2617_;
                                if _e1197 {
                                    break;
                                }
                                phi_2632_ = _e1197;
                            } else {
                                phi_2632_ = _e1111;
                            }
                            let _e1199 = phi_2632_;
                            if _e109 {
                            } else {
                                break;
                            }
                            if ((_e753 & 2147483648u) != 0u) {
                                let _e1209 = ((bitcast<u32>((_e1112[0] - _e1113[0])) | bitcast<u32>((_e1112[1] - _e1113[1]))) | bitcast<u32>((_e1112[2] - _e1113[2])));
                                if (_e1209 < 1024u) {
                                    phi_2299_ = 0u;
                                } else {
                                    phi_2299_ = select(2u, 1u, (_e1209 < 2097152u));
                                }
                                let _e1214 = phi_2299_;
                                switch bitcast<i32>(_e1214) {
                                    case 0: {
                                        phi_2305_ = 1u;
                                        break;
                                    }
                                    case 1: {
                                        phi_2305_ = 2u;
                                        break;
                                    }
                                    case 2: {
                                        phi_2305_ = 3u;
                                        break;
                                    }
                                    default: {
                                        phi_2305_ = u32();
                                        break;
                                    }
                                }
                                let _e1217 = phi_2305_;
                                phi_2312_ = type_8(0u, ((_e753 >> bitcast<u32>(28u)) & 7u));
                                loop {
                                    let _e1225 = phi_2312_;
                                    if (_e1225.member < _e1225.member_1) {
                                        phi_2313_ = type_8((_e1225.member + 1u), _e1225.member_1);
                                        phi_2336_ = type_8(1u, _e1225.member);
                                    } else {
                                        phi_2313_ = _e1225;
                                        phi_2336_ = type_8(0u, type_8().member_1);
                                    }
                                    let _e1238 = phi_2313_;
                                    let _e1240 = phi_2336_;
                                    let _e1244 = (bitcast<i32>(_e1240.member) != 0i);
                                    if _e1244 {
                                        let _e1246 = ((_e753 & 268435455u) + _e1240.member_1);
                                        let _e1247 = (_e1246 < _e83);
                                        if _e1247 {
                                            if _e1247 {
                                            } else {
                                                phi_2625_ = true;
                                                break;
                                            }
                                            global_7.member[_e1246] = ((3u * _e1217) + 1u);
                                        }
                                    }
                                    continue;
                                    continuing {
                                        phi_2312_ = _e1238;
                                        phi_2625_ = _e1199;
                                        break if !(_e1244);
                                    }
                                }
                                let _e1251 = phi_2625_;
                                if _e1251 {
                                    break;
                                }
                            }
                            if (_e104 == 0u) {
                                if (_e86 == 0u) {
                                } else {
                                    if (0u < _e86) {
                                    } else {
                                        break;
                                    }
                                    global_8.member[0u] = type_31(array<u32, 4>(bitcast<u32>(_e718[0]), bitcast<u32>(_e718[1]), bitcast<u32>(_e718[2]), bitcast<u32>(_e100)), array<u32, 4>(bitcast<u32>(_e717[0]), bitcast<u32>(_e717[1]), bitcast<u32>(_e717[2]), 0u));
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
fn encode_q10_sizes(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
