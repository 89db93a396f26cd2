struct type_4 {
    member: u32,
    member_1: u32,
}

struct type_8 {
    member: vec4<u32>,
}

struct type_14 {
    member: array<f32, 3>,
    member_1: f32,
    member_2: array<f32, 3>,
    member_3: f32,
}

struct type_15 {
    member: type_14,
    member_1: array<f32, 3>,
    member_2: u32,
    member_3: array<f32, 3>,
    member_4: u32,
}

struct type_17 {
    member: array<type_15>,
}

struct type_22 {
    member: array<f32, 3>,
    member_1: u32,
    member_2: array<f32, 3>,
    member_3: u32,
    member_4: array<f32, 3>,
    member_5: u32,
    member_6: array<f32, 3>,
    member_7: u32,
    member_8: array<f32, 3>,
    member_9: f32,
    member_10: array<f32, 3>,
    member_11: f32,
}

struct type_24 {
    member: array<type_22>,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_1: type_8;
@group(0) @binding(1) 
var<uniform> global_2: type_8;
@group(0) @binding(3) 
var<storage, read_write> global_3: type_17;
@group(0) @binding(2) 
var<storage> global_4: type_24;

fn function_() {
    var phi_174_: i32;
    var phi_526_: type_22;
    var phi_564_: u32;
    var phi_567_: type_4;
    var phi_568_: type_4;
    var phi_590_: type_4;
    var phi_603_: u32;
    var phi_565_: u32;
    var local: u32;
    var local_1: u32;
    var local_2: u32;
    var local_3: u32;
    var local_4: u32;
    var local_5: u32;
    var phi_638_: array<f32, 2>;
    var phi_772_: type_4;
    var phi_775_: u32;
    var phi_777_: u32;
    var phi_773_: type_4;
    var phi_800_: type_4;
    var phi_816_: u32;
    var phi_776_: u32;
    var phi_778_: u32;
    var local_6: u32;
    var phi_846_: i32;
    var phi_853_: i32;
    var phi_1170_: f32;
    var phi_1183_: f32;
    var phi_1127_: type_14;
    var phi_1128_: type_14;

    switch bitcast<i32>(0u) {
        default: {
            let _e65 = global;
            let _e67 = arrayLength((&global_4.member));
            let _e73 = (_e65.x + (_e65.y * 2097152u));
            let _e74 = (_e73 < arrayLength((&global_3.member)));
            if _e74 {
                if (_e67 == 0u) {
                } else {
                    if (0u < _e67) {
                    } else {
                        break;
                    }
                    let _e79 = global_1.member[0u];
                    let _e80 = bitcast<i32>(_e79);
                    if (_e80 < -126i) {
                        phi_174_ = -126i;
                    } else {
                        phi_174_ = select(_e80, 127i, (_e80 > 127i));
                    }
                    let _e85 = phi_174_;
                    let _e90 = bitcast<f32>((bitcast<u32>((_e85 + 127i)) << bitcast<u32>(23i)));
                    let _e96 = bitcast<f32>((bitcast<u32>(((_e80 - _e85) + 127i)) << bitcast<u32>(23i)));
                    let _e99 = global_4.member[0u];
                    let _e103 = global_4.member[0u].member;
                    let _e105 = bitcast<u32>(_e103[0]);
                    let _e107 = ((_e105 & 2139095040u) != 0u);
                    let _e123 = bitcast<u32>(_e103[1]);
                    let _e125 = ((_e123 & 2139095040u) != 0u);
                    let _e141 = bitcast<u32>(_e103[2]);
                    let _e143 = ((_e141 & 2139095040u) != 0u);
                    let _e171 = type_22(array<f32, 3>((((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e105 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e105 & 2147483648u))), _e103[0], _e107) * _e90) * select(0.00000011920929f, 1f, _e107)) * _e96), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e123 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e123 & 2147483648u))), _e103[1], _e125) * _e90) * select(0.00000011920929f, 1f, _e125)) * _e96), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e141 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e141 & 2147483648u))), _e103[2], _e143) * _e90) * select(0.00000011920929f, 1f, _e143)) * _e96)), _e99.member_1, _e99.member_2, _e99.member_3, _e99.member_4, _e99.member_5, _e99.member_6, _e99.member_7, _e99.member_8, _e99.member_9, _e99.member_10, _e99.member_11);
                    let _e175 = global_4.member[0u].member_9;
                    let _e176 = bitcast<u32>(_e175);
                    let _e178 = ((_e176 & 2139095040u) != 0u);
                    let _e205 = type_22(_e171.member, _e171.member_1, _e171.member_2, _e171.member_3, _e171.member_4, _e171.member_5, _e171.member_6, _e171.member_7, _e171.member_8, (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e176 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e176 & 2147483648u))), _e175, _e178) * _e90) * select(0.00000011920929f, 1f, _e178)) * _e96), _e171.member_10, _e171.member_11);
                    let _e209 = global_4.member[0u].member_1;
                    if (_e209 == 1u) {
                        let _e214 = global_4.member[0u].member_4;
                        let _e216 = bitcast<u32>(_e214[0]);
                        let _e218 = ((_e216 & 2139095040u) != 0u);
                        let _e234 = bitcast<u32>(_e214[1]);
                        let _e236 = ((_e234 & 2139095040u) != 0u);
                        let _e252 = bitcast<u32>(_e214[2]);
                        let _e254 = ((_e252 & 2139095040u) != 0u);
                        let _e282 = type_22(_e205.member, _e205.member_1, _e205.member_2, _e205.member_3, array<f32, 3>((((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e216 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e216 & 2147483648u))), _e214[0], _e218) * _e90) * select(0.00000011920929f, 1f, _e218)) * _e96), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e234 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e234 & 2147483648u))), _e214[1], _e236) * _e90) * select(0.00000011920929f, 1f, _e236)) * _e96), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e252 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e252 & 2147483648u))), _e214[2], _e254) * _e90) * select(0.00000011920929f, 1f, _e254)) * _e96)), _e205.member_5, _e205.member_6, _e205.member_7, _e205.member_8, _e205.member_9, _e205.member_10, _e205.member_11);
                        let _e286 = global_4.member[0u].member_6;
                        let _e288 = bitcast<u32>(_e286[0]);
                        let _e290 = ((_e288 & 2139095040u) != 0u);
                        let _e306 = bitcast<u32>(_e286[1]);
                        let _e308 = ((_e306 & 2139095040u) != 0u);
                        let _e324 = bitcast<u32>(_e286[2]);
                        let _e326 = ((_e324 & 2139095040u) != 0u);
                        phi_526_ = type_22(_e282.member, _e282.member_1, _e282.member_2, _e282.member_3, _e282.member_4, _e282.member_5, array<f32, 3>((((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e288 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e288 & 2147483648u))), _e286[0], _e290) * _e90) * select(0.00000011920929f, 1f, _e290)) * _e96), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e306 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e306 & 2147483648u))), _e286[1], _e308) * _e90) * select(0.00000011920929f, 1f, _e308)) * _e96), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e324 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e324 & 2147483648u))), _e286[2], _e326) * _e90) * select(0.00000011920929f, 1f, _e326)) * _e96)), _e282.member_7, _e282.member_8, _e282.member_9, _e282.member_10, _e282.member_11);
                    } else {
                        phi_526_ = _e205;
                    }
                    let _e356 = phi_526_;
                    let _e359 = global_2.member[0u];
                    let _e360 = (_e359 + _e73);
                    let _e363 = select(1u, _e356.member_7, (1u < _e356.member_7));
                    let _e366 = select(1u, _e356.member_3, (1u < _e356.member_3));
                    let _e367 = (_e363 == 0u);
                    if _e367 {
                        break;
                    }
                    let _e368 = (_e360 / _e363);
                    let _e369 = (_e366 == 0u);
                    if _e369 {
                        break;
                    }
                    if _e369 {
                        break;
                    }
                    if _e367 {
                        break;
                    }
                    let _e372 = (_e360 % _e363);
                    phi_564_ = 1u;
                    phi_567_ = type_4(0u, 16u);
                    loop {
                        let _e374 = phi_564_;
                        let _e376 = phi_567_;
                        local = _e374;
                        local_1 = _e374;
                        local_2 = _e374;
                        local_3 = _e374;
                        local_4 = _e374;
                        local_5 = _e374;
                        if (_e376.member < _e376.member_1) {
                            phi_568_ = type_4((_e376.member + 1u), _e376.member_1);
                            phi_590_ = type_4(1u, _e376.member);
                        } else {
                            phi_568_ = _e376;
                            phi_590_ = type_4(0u, type_4().member_1);
                        }
                        let _e389 = phi_568_;
                        let _e391 = phi_590_;
                        let _e394 = (bitcast<i32>(_e391.member) != 0i);
                        if _e394 {
                            if ((_e374 * _e374) < _e363) {
                                phi_603_ = (_e374 + 1u);
                            } else {
                                phi_603_ = _e374;
                            }
                            let _e399 = phi_603_;
                            phi_565_ = _e399;
                        } else {
                            phi_565_ = u32();
                        }
                        let _e401 = phi_565_;
                        continue;
                        continuing {
                            phi_564_ = _e401;
                            phi_567_ = _e389;
                            break if !(_e394);
                        }
                    }
                    let _e404 = local;
                    let _e406 = local_1;
                    if ((_e404 * _e406) == _e363) {
                        let _e421 = local_2;
                        let _e422 = (_e421 == 0u);
                        if _e422 {
                            break;
                        }
                        let _e424 = local_3;
                        let _e429 = local_4;
                        let _e430 = f32(_e429);
                        if _e422 {
                            break;
                        }
                        let _e433 = local_5;
                        phi_638_ = array<f32, 2>(((f32((_e372 % _e424)) + 0.5f) / _e430), ((f32((_e372 / _e433)) + 0.5f) / _e430));
                    } else {
                        phi_638_ = array<f32, 2>(((f32(_e372) + 0.5f) / f32(_e363)), (f32((((_e372 * 2654435769u) + 1327217884u) >> bitcast<u32>(8i))) * 0.000000059604645f));
                    }
                    let _e440 = phi_638_;
                    let _e448 = ((((f32((_e368 % _e366)) + _e440[0]) / f32(_e356.member_3)) * 2f) - 1f);
                    let _e455 = (1f - (((f32((_e368 / _e366)) + _e440[1]) / f32(_e356.member_5)) * 2f));
                    let _e470 = ((_e356.member_4[0] * _e448) + (_e356.member_6[0] * _e455));
                    let _e471 = ((_e356.member_4[1] * _e448) + (_e356.member_6[1] * _e455));
                    let _e472 = ((_e356.member_4[2] * _e448) + (_e356.member_6[2] * _e455));
                    if (_e356.member_1 == 1u) {
                        phi_1128_ = type_14(array<f32, 3>((_e356.member[0] + _e470), (_e356.member[1] + _e471), (_e356.member[2] + _e472)), 0f, _e356.member_2, 340282350000000000000000000000000000000f);
                    } else {
                        if (_e356.member_9 > 0f) {
                            if _e367 {
                                break;
                            }
                            if _e367 {
                                break;
                            }
                            let _e493 = ((_e368 ^ (_e368 >> bitcast<u32>(16i))) * 569420461u);
                            let _e497 = ((_e493 ^ (_e493 >> bitcast<u32>(15i))) * 3545902487u);
                            let _e500 = (_e497 ^ (_e497 >> bitcast<u32>(15i)));
                            let _e504 = ((_e500 ^ (_e500 >> bitcast<u32>(16i))) * 569420461u);
                            let _e508 = ((_e504 ^ (_e504 >> bitcast<u32>(15i))) * 3545902487u);
                            let _e511 = (_e508 ^ (_e508 >> bitcast<u32>(15i)));
                            let _e515 = ((_e511 ^ (_e511 >> bitcast<u32>(16i))) * 569420461u);
                            let _e519 = ((_e515 ^ (_e515 >> bitcast<u32>(15i))) * 3545902487u);
                            let _e522 = (_e519 ^ (_e519 >> bitcast<u32>(15i)));
                            let _e524 = (reverseBits(_e372) + _e522);
                            let _e526 = (_e524 ^ (_e524 * 1817228412u));
                            let _e528 = (_e526 ^ (_e526 * 3090095698u));
                            let _e530 = (_e528 ^ (_e528 * 3350193720u));
                            let _e533 = reverseBits((_e530 ^ (_e530 * 2367878886u)));
                            let _e535 = (_e522 ^ 1u);
                            let _e539 = ((_e535 ^ (_e535 >> bitcast<u32>(16i))) * 569420461u);
                            let _e543 = ((_e539 ^ (_e539 >> bitcast<u32>(15i))) * 3545902487u);
                            let _e548 = (reverseBits(reverseBits(_e533)) + (_e543 ^ (_e543 >> bitcast<u32>(15i))));
                            let _e550 = (_e548 ^ (_e548 * 1817228412u));
                            let _e552 = (_e550 ^ (_e550 * 3090095698u));
                            let _e554 = (_e552 ^ (_e552 * 3350193720u));
                            phi_772_ = type_4(0u, 32u);
                            phi_775_ = 2147483648u;
                            phi_777_ = 0u;
                            loop {
                                let _e559 = phi_772_;
                                let _e561 = phi_775_;
                                let _e563 = phi_777_;
                                local_6 = _e563;
                                if (_e559.member < _e559.member_1) {
                                    phi_773_ = type_4((_e559.member + 1u), _e559.member_1);
                                    phi_800_ = type_4(1u, _e559.member);
                                } else {
                                    phi_773_ = _e559;
                                    phi_800_ = type_4(0u, type_4().member_1);
                                }
                                let _e576 = phi_773_;
                                let _e578 = phi_800_;
                                let _e582 = (bitcast<i32>(_e578.member) != 0i);
                                if _e582 {
                                    if (((_e533 >> bitcast<u32>((_e578.member_1 & 31u))) & 1u) == 1u) {
                                        phi_816_ = (_e563 ^ _e561);
                                    } else {
                                        phi_816_ = _e563;
                                    }
                                    let _e590 = phi_816_;
                                    phi_776_ = (_e561 ^ (_e561 >> bitcast<u32>(1i)));
                                    phi_778_ = _e590;
                                } else {
                                    phi_776_ = u32();
                                    phi_778_ = u32();
                                }
                                let _e595 = phi_776_;
                                let _e597 = phi_778_;
                                continue;
                                continuing {
                                    phi_772_ = _e576;
                                    phi_775_ = _e595;
                                    phi_777_ = _e597;
                                    break if !(_e582);
                                }
                            }
                            let _e599 = (_e522 ^ 2u);
                            let _e603 = ((_e599 ^ (_e599 >> bitcast<u32>(16i))) * 569420461u);
                            let _e607 = ((_e603 ^ (_e603 >> bitcast<u32>(15i))) * 3545902487u);
                            let _e612 = local_6;
                            let _e614 = (reverseBits(_e612) + (_e607 ^ (_e607 >> bitcast<u32>(15i))));
                            let _e616 = (_e614 ^ (_e614 * 1817228412u));
                            let _e618 = (_e616 ^ (_e616 * 3090095698u));
                            let _e620 = (_e618 ^ (_e618 * 3350193720u));
                            let _e628 = bitcast<i32>(((2u * (reverseBits((_e554 ^ (_e554 * 2367878886u))) >> bitcast<u32>(16i))) + 1u));
                            let _e629 = (_e628 - 65536i);
                            let _e634 = bitcast<i32>(((2u * (reverseBits((_e620 ^ (_e620 * 2367878886u))) >> bitcast<u32>(16i))) + 1u));
                            let _e635 = (_e634 - 65536i);
                            let _e636 = (_e629 < 0i);
                            if _e636 {
                                phi_846_ = (65536i - _e628);
                            } else {
                                phi_846_ = _e629;
                            }
                            let _e639 = phi_846_;
                            let _e640 = bitcast<u32>(_e639);
                            let _e641 = (_e635 < 0i);
                            if _e641 {
                                phi_853_ = (65536i - _e634);
                            } else {
                                phi_853_ = _e635;
                            }
                            let _e644 = phi_853_;
                            let _e645 = bitcast<u32>(_e644);
                            let _e646 = (_e640 > _e645);
                            let _e647 = select(_e645, _e640, _e646);
                            let _e652 = select(1u, _e647, (1u < _e647));
                            if (_e652 == 0u) {
                                break;
                            }
                            let _e656 = (((select(_e640, _e645, _e646) << bitcast<u32>(16i)) / _e652) << bitcast<u32>(15i));
                            let _e658 = (_e656 >> bitcast<u32>(16i));
                            let _e659 = (_e656 & 65535u);
                            let _e664 = ((_e658 * _e659) + ((_e659 * _e659) >> bitcast<u32>(16i)));
                            let _e676 = ((((_e658 * _e658) + (_e664 >> bitcast<u32>(16i))) + (((_e659 * _e658) + (_e664 & 65535u)) >> bitcast<u32>(16i))) << bitcast<u32>(1i));
                            let _e678 = (_e676 >> bitcast<u32>(16i));
                            let _e679 = (_e676 & 65535u);
                            let _e684 = ((_e678 * 7711u) + ((_e679 * 7711u) >> bitcast<u32>(16i)));
                            let _e693 = (700062u - (((_e684 >> bitcast<u32>(16i)) + ((_e684 & 65535u) >> bitcast<u32>(16i))) << bitcast<u32>(1i)));
                            let _e695 = (_e693 >> bitcast<u32>(16i));
                            let _e696 = (_e693 & 65535u);
                            let _e701 = ((_e678 * _e696) + ((_e679 * _e696) >> bitcast<u32>(16i)));
                            let _e714 = (34046945u - ((((_e678 * _e695) + (_e701 >> bitcast<u32>(16i))) + (((_e679 * _e695) + (_e701 & 65535u)) >> bitcast<u32>(16i))) << bitcast<u32>(1i)));
                            let _e716 = (_e714 >> bitcast<u32>(16i));
                            let _e717 = (_e714 & 65535u);
                            let _e722 = ((_e678 * _e717) + ((_e679 * _e717) >> bitcast<u32>(16i)));
                            let _e735 = (662337939u - ((((_e678 * _e716) + (_e722 >> bitcast<u32>(16i))) + (((_e679 * _e716) + (_e722 & 65535u)) >> bitcast<u32>(16i))) << bitcast<u32>(1i)));
                            let _e740 = ((_e678 * 13011u) + ((_e679 * 13011u) >> bitcast<u32>(16i)));
                            let _e751 = (5348082u - (((_e678 + (_e740 >> bitcast<u32>(16i))) + ((_e679 + (_e740 & 65535u)) >> bitcast<u32>(16i))) << bitcast<u32>(1i)));
                            let _e753 = (_e751 >> bitcast<u32>(16i));
                            let _e754 = (_e751 & 65535u);
                            let _e759 = ((_e678 * _e754) + ((_e679 * _e754) >> bitcast<u32>(16i)));
                            let _e772 = (173399667u - ((((_e678 * _e753) + (_e759 >> bitcast<u32>(16i))) + (((_e679 * _e753) + (_e759 & 65535u)) >> bitcast<u32>(16i))) << bitcast<u32>(1i)));
                            let _e774 = (_e772 >> bitcast<u32>(16i));
                            let _e775 = (_e772 & 65535u);
                            let _e780 = ((_e678 * _e775) + ((_e679 * _e775) >> bitcast<u32>(16i)));
                            let _e793 = (1686629713u - ((((_e678 * _e774) + (_e780 >> bitcast<u32>(16i))) + (((_e679 * _e774) + (_e780 & 65535u)) >> bitcast<u32>(16i))) << bitcast<u32>(1i)));
                            let _e795 = (_e735 >> bitcast<u32>(16i));
                            let _e796 = (_e735 & 65535u);
                            let _e801 = ((_e678 * _e796) + ((_e679 * _e796) >> bitcast<u32>(16i)));
                            let _e814 = (2147483648u - ((((_e678 * _e795) + (_e801 >> bitcast<u32>(16i))) + (((_e679 * _e795) + (_e801 & 65535u)) >> bitcast<u32>(16i))) << bitcast<u32>(1i)));
                            let _e816 = (_e793 >> bitcast<u32>(16i));
                            let _e817 = (_e793 & 65535u);
                            let _e822 = ((_e658 * _e817) + ((_e659 * _e817) >> bitcast<u32>(16i)));
                            let _e834 = ((((_e658 * _e816) + (_e822 >> bitcast<u32>(16i))) + (((_e659 * _e816) + (_e822 & 65535u)) >> bitcast<u32>(16i))) << bitcast<u32>(1i));
                            let _e836 = (_e647 << bitcast<u32>(15i));
                            let _e838 = (_e836 >> bitcast<u32>(16i));
                            let _e839 = (_e836 & 65535u);
                            let _e841 = (_e814 >> bitcast<u32>(16i));
                            let _e842 = (_e814 & 65535u);
                            let _e847 = ((_e838 * _e842) + ((_e839 * _e842) >> bitcast<u32>(16i)));
                            let _e859 = ((((_e838 * _e841) + (_e847 >> bitcast<u32>(16i))) + (((_e839 * _e841) + (_e847 & 65535u)) >> bitcast<u32>(16i))) << bitcast<u32>(1i));
                            let _e861 = (_e834 >> bitcast<u32>(16i));
                            let _e862 = (_e834 & 65535u);
                            let _e867 = ((_e838 * _e862) + ((_e839 * _e862) >> bitcast<u32>(16i)));
                            let _e879 = ((((_e838 * _e861) + (_e867 >> bitcast<u32>(16i))) + (((_e839 * _e861) + (_e867 & 65535u)) >> bitcast<u32>(16i))) << bitcast<u32>(1i));
                            let _e884 = f32((select(_e879, _e859, _e646) >> bitcast<u32>(7i)));
                            if _e636 {
                                phi_1170_ = (_e884 * -0.000000059604645f);
                            } else {
                                phi_1170_ = (_e884 * 0.000000059604645f);
                            }
                            let _e888 = phi_1170_;
                            let _e891 = f32((select(_e859, _e879, _e646) >> bitcast<u32>(7i)));
                            if _e641 {
                                phi_1183_ = (_e891 * -0.000000059604645f);
                            } else {
                                phi_1183_ = (_e891 * 0.000000059604645f);
                            }
                            let _e895 = phi_1183_;
                            let _e910 = ((_e356.member_8[0] * _e888) + (_e356.member_10[0] * _e895));
                            let _e911 = ((_e356.member_8[1] * _e888) + (_e356.member_10[1] * _e895));
                            let _e912 = ((_e356.member_8[2] * _e888) + (_e356.member_10[2] * _e895));
                            phi_1127_ = type_14(array<f32, 3>((_e356.member[0] + (_e910 * _e356.member_9)), (_e356.member[1] + (_e911 * _e356.member_9)), (_e356.member[2] + (_e912 * _e356.member_9))), 0f, array<f32, 3>(((_e356.member_2[0] + _e470) - (_e910 * _e356.member_11)), ((_e356.member_2[1] + _e471) - (_e911 * _e356.member_11)), ((_e356.member_2[2] + _e472) - (_e912 * _e356.member_11))), 340282350000000000000000000000000000000f);
                        } else {
                            phi_1127_ = type_14(_e356.member, 0f, array<f32, 3>((_e356.member_2[0] + _e470), (_e356.member_2[1] + _e471), (_e356.member_2[2] + _e472)), 340282350000000000000000000000000000000f);
                        }
                        let _e933 = phi_1127_;
                        phi_1128_ = _e933;
                    }
                    let _e940 = phi_1128_;
                    if _e74 {
                    } else {
                        break;
                    }
                    global_3.member[_e73] = type_15(_e940, array<f32, 3>(1f, 1f, 1f), 4294967295u, array<f32, 3>(0f, 0f, 0f), _e360);
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn camera_rays(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
