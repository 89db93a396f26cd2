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

struct type_16 {
    member: array<f32, 9>,
    member_1: u32,
}

struct type_18 {
    member: array<type_16>,
}

struct type_26 {
    member: array<array<f32, 4>, 3>,
    member_1: u32,
    member_2: u32,
    member_3: u32,
    member_4: u32,
}

struct type_28 {
    member: array<type_26>,
}

struct type_35 {
    member: array<vec4<u32>, 2>,
}

struct type_39 {
    member: array<i32, 3>,
    member_1: array<i32, 3>,
}

struct type_45 {
    member: array<array<u32, 7>>,
}

struct type_50 {
    member: array<type_39>,
}

struct type_55 {
    member: u32,
    member_1: type_39,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_1: type_12;
@group(0) @binding(3) 
var<storage> global_2: type_18;
@group(0) @binding(2) 
var<storage> global_3: type_28;
@group(0) @binding(1) 
var<uniform> global_4: type_35;
@group(0) @binding(4) 
var<storage> global_5: type_50;
@group(0) @binding(5) 
var<storage> global_6: type_4;
@group(0) @binding(7) 
var<storage, read_write> global_7: type_4;
@group(0) @binding(6) 
var<storage, read_write> global_8: type_45;

fn function_() {
    var local: array<i32, 3>;
    var local_1: array<i32, 3>;
    var local_2: array<i32, 3>;
    var local_3: array<i32, 3>;
    var local_4: array<u32, 10>;
    var local_5: array<f32, 3>;
    var local_6: array<u32, 10>;
    var local_7: array<u32, 7>;
    var local_8: array<type_55, 2>;
    var local_9: type_39;
    var phi_253_: type_8;
    var phi_254_: type_8;
    var phi_277_: type_8;
    var phi_1663_: bool;
    var phi_507_: u32;
    var phi_509_: u32;
    var phi_510_: bool;
    var phi_526_: u32;
    var phi_528_: u32;
    var phi_529_: bool;
    var phi_534_: u32;
    var phi_546_: u32;
    var phi_562_: u32;
    var phi_577_: u32;
    var phi_592_: u32;
    var phi_694_: type_8;
    var phi_695_: type_8;
    var phi_718_: type_8;
    var phi_1680_: bool;
    var phi_1731_: bool;
    var phi_902_: type_8;
    var phi_903_: type_8;
    var phi_928_: type_8;
    var phi_1022_: u32;
    var phi_1028_: u32;
    var phi_1726_: bool;
    var phi_1035_: type_8;
    var phi_1036_: type_8;
    var phi_1059_: type_8;
    var phi_1149_: u32;
    var phi_1155_: u32;
    var phi_1174_: type_8;
    var phi_1175_: type_8;
    var phi_1198_: type_8;
    var phi_1410_: i32;
    var phi_1456_: i32;
    var phi_1503_: i32;
    var phi_1718_: bool;
    var phi_1563_: type_8;
    var phi_1564_: type_8;
    var phi_1587_: type_8;
    var phi_1736_: bool;
    var phi_1745_: bool;
    var phi_1744_: bool;
    var phi_1743_: bool;
    var phi_1742_: bool;
    var phi_1748_: bool;
    var phi_1747_: bool;
    var phi_1746_: bool;

    switch bitcast<i32>(0u) {
        default: {
            let _e66 = global;
            let _e78 = arrayLength((&global_6.member));
            let _e86 = global_4.member[0u][3u];
            let _e91 = (_e66.x + (_e66.y * 2097152u));
            let _e94 = global_1.member[0u];
            if (_e91 < _e94) {
                let _e96 = (_e91 < arrayLength((&global_3.member)));
                if _e96 {
                    let _e97 = (_e91 < arrayLength((&global_5.member)));
                    if _e97 {
                        let _e98 = (_e91 < arrayLength((&global_8.member)));
                        if _e98 {
                            if _e98 {
                            } else {
                                break;
                            }
                            if _e97 {
                            } else {
                                break;
                            }
                            local_3 = array<i32, 3>(0i, 0i, 0i);
                            local_2 = array<i32, 3>(0i, 0i, 0i);
                            local_1 = array<i32, 3>(0i, 0i, 0i);
                            local = array<i32, 3>(0i, 0i, 0i);
                            phi_253_ = type_8(0u, 3u);
                            loop {
                                let _e102 = phi_253_;
                                if (_e102.member < _e102.member_1) {
                                    phi_254_ = type_8((_e102.member + 1u), _e102.member_1);
                                    phi_277_ = type_8(1u, _e102.member);
                                } else {
                                    phi_254_ = _e102;
                                    phi_277_ = type_8(0u, type_8().member_1);
                                }
                                let _e115 = phi_254_;
                                let _e117 = phi_277_;
                                let _e121 = (bitcast<i32>(_e117.member) != 0i);
                                if _e121 {
                                    let _e122 = (_e117.member_1 * 2u);
                                    let _e124 = ((1u + _e122) % 7u);
                                    if (_e124 < 7u) {
                                    } else {
                                        phi_1663_ = true;
                                        break;
                                    }
                                    let _e129 = global_8.member[_e91][_e124];
                                    let _e131 = ((_e122 + 2u) % 7u);
                                    if (_e131 < 7u) {
                                    } else {
                                        phi_1663_ = true;
                                        break;
                                    }
                                    let _e136 = global_8.member[_e91][_e131];
                                    let _e137 = (_e117.member_1 < 3u);
                                    if _e137 {
                                    } else {
                                        phi_1663_ = true;
                                        break;
                                    }
                                    let _e141 = global_5.member[_e91].member[_e117.member_1];
                                    if _e137 {
                                    } else {
                                        phi_1663_ = true;
                                        break;
                                    }
                                    let _e145 = global_5.member[_e91].member_1[_e117.member_1];
                                    let _e147 = bitcast<u32>((_e145 - _e141));
                                    let _e153 = (32u - select((bitcast<u32>(31i) - firstLeadingBit(_e147)), 32u, (_e147 == 0u)));
                                    let _e158 = ((select(21u, _e153, (_e153 > 21u)) - 21u) & 31u);
                                    let _e162 = (_e141 + bitcast<i32>(((_e129 & 2097151u) << bitcast<u32>(_e158))));
                                    let _e167 = (_e145 - bitcast<i32>(((_e136 & 2097151u) << bitcast<u32>(_e158))));
                                    let _e171 = (((_e129 >> bitcast<u32>(21u)) & 1u) == 1u);
                                    let _e175 = (((_e136 >> bitcast<u32>(21u)) & 1u) == 1u);
                                    if _e137 {
                                    } else {
                                        phi_1663_ = true;
                                        break;
                                    }
                                    local_3[_e117.member_1] = select(_e141, _e162, _e171);
                                    if _e137 {
                                    } else {
                                        phi_1663_ = true;
                                        break;
                                    }
                                    local_1[_e117.member_1] = select(_e162, _e141, _e171);
                                    if _e137 {
                                    } else {
                                        phi_1663_ = true;
                                        break;
                                    }
                                    local_2[_e117.member_1] = select(_e145, _e167, _e175);
                                    if _e137 {
                                    } else {
                                        phi_1663_ = true;
                                        break;
                                    }
                                    local[_e117.member_1] = select(_e167, _e145, _e175);
                                }
                                continue;
                                continuing {
                                    phi_253_ = _e115;
                                    phi_1663_ = false;
                                    break if !(_e121);
                                }
                            }
                            let _e186 = phi_1663_;
                            if _e186 {
                                break;
                            }
                            let _e187 = local;
                            let _e188 = local_1;
                            let _e189 = local_2;
                            let _e190 = local_3;
                            if _e98 {
                            } else {
                                break;
                            }
                            let _e191 = global_8.member[_e91];
                            if _e96 {
                            } else {
                                break;
                            }
                            let _e194 = global_3.member[_e91].member_1;
                            let _e197 = global_3.member[_e91].member_2;
                            let _e199 = ((_e194 & 2147483648u) != 0u);
                            if _e199 {
                                let _e203 = (((_e194 >> bitcast<u32>(28u)) & 7u) > 0u);
                                if _e203 {
                                    phi_507_ = (_e194 & 268435455u);
                                } else {
                                    phi_507_ = u32();
                                }
                                let _e206 = phi_507_;
                                phi_509_ = _e206;
                                phi_510_ = select(true, false, _e203);
                            } else {
                                phi_509_ = u32();
                                phi_510_ = true;
                            }
                            let _e209 = phi_509_;
                            let _e211 = phi_510_;
                            if _e211 {
                                if ((_e197 & 2147483648u) != 0u) {
                                    let _e217 = (((_e197 >> bitcast<u32>(28u)) & 7u) > 0u);
                                    if _e217 {
                                        phi_526_ = (_e197 & 268435455u);
                                    } else {
                                        phi_526_ = u32();
                                    }
                                    let _e220 = phi_526_;
                                    phi_528_ = _e220;
                                    phi_529_ = select(true, false, _e217);
                                } else {
                                    phi_528_ = u32();
                                    phi_529_ = true;
                                }
                                let _e223 = phi_528_;
                                let _e225 = phi_529_;
                                phi_534_ = select(_e223, 0u, _e225);
                            } else {
                                phi_534_ = _e209;
                            }
                            let _e228 = phi_534_;
                            let _e229 = (_e228 < _e78);
                            if _e229 {
                                if _e229 {
                                } else {
                                    break;
                                }
                                let _e231 = global_6.member[_e228];
                                phi_546_ = _e231;
                            } else {
                                phi_546_ = 0u;
                            }
                            let _e233 = phi_546_;
                            if _e199 {
                                phi_562_ = select(_e197, 0u, ((_e197 & 2147483648u) != 0u));
                            } else {
                                phi_562_ = _e194;
                            }
                            let _e238 = phi_562_;
                            if _e199 {
                                let _e241 = ((_e194 >> bitcast<u32>(28u)) & 7u);
                                phi_577_ = select(_e241, 7u, (_e241 == 0u));
                            } else {
                                phi_577_ = 0u;
                            }
                            let _e245 = phi_577_;
                            if ((_e197 & 2147483648u) != 0u) {
                                let _e250 = ((_e197 >> bitcast<u32>(28u)) & 7u);
                                phi_592_ = select(_e250, 7u, (_e250 == 0u));
                            } else {
                                phi_592_ = 0u;
                            }
                            let _e254 = phi_592_;
                            local_7 = array<u32, 7>(_e191[0], _e191[1], _e191[2], _e191[3], _e191[4], _e191[5], _e191[6]);
                            local_7[0u] = (((_e238 & 268435455u) | (_e245 << bitcast<u32>(28u))) | (_e254 << bitcast<u32>(31i)));
                            phi_694_ = type_8(0u, 3u);
                            loop {
                                let _e278 = phi_694_;
                                if (_e278.member < _e278.member_1) {
                                    phi_695_ = type_8((_e278.member + 1u), _e278.member_1);
                                    phi_718_ = type_8(1u, _e278.member);
                                } else {
                                    phi_695_ = _e278;
                                    phi_718_ = type_8(0u, type_8().member_1);
                                }
                                let _e291 = phi_695_;
                                let _e293 = phi_718_;
                                let _e297 = (bitcast<i32>(_e293.member) != 0i);
                                if _e297 {
                                    let _e306 = (((_e293.member_1 + 1u) * 2u) % 7u);
                                    if (_e306 < 7u) {
                                    } else {
                                        phi_1680_ = true;
                                        break;
                                    }
                                    let _e309 = local_7[_e306];
                                    local_7[_e306] = (_e309 | ((((_e233 & 268435455u) | ((_e254 >> bitcast<u32>(1i)) << bitcast<u32>(28u))) >> bitcast<u32>(((10u * _e293.member_1) & 31u))) << bitcast<u32>(22i)));
                                }
                                continue;
                                continuing {
                                    phi_694_ = _e291;
                                    phi_1680_ = _e186;
                                    break if !(_e297);
                                }
                            }
                            let _e313 = phi_1680_;
                            if _e313 {
                                break;
                            }
                            let _e314 = local_7;
                            if _e98 {
                            } else {
                                break;
                            }
                            global_8.member[_e91] = array<u32, 7>(_e314[0], _e314[1], _e314[2], _e314[3], _e314[4], _e314[5], _e314[6]);
                            if _e96 {
                            } else {
                                break;
                            }
                            if _e96 {
                            } else {
                                break;
                            }
                            local_8[0u] = type_55(_e194, type_39(_e190, _e189));
                            local_8[1u] = type_55(_e197, type_39(_e188, _e187));
                            phi_1731_ = _e313;
                            phi_902_ = type_8(0u, 2u);
                            loop {
                                let _e330 = phi_1731_;
                                let _e332 = phi_902_;
                                if (_e332.member < _e332.member_1) {
                                    phi_903_ = type_8((_e332.member + 1u), _e332.member_1);
                                    phi_928_ = type_8(1u, _e332.member);
                                } else {
                                    phi_903_ = _e332;
                                    phi_928_ = type_8(0u, type_8().member_1);
                                }
                                let _e345 = phi_903_;
                                let _e347 = phi_928_;
                                let _e351 = (bitcast<i32>(_e347.member) != 0i);
                                if _e351 {
                                    if (_e347.member_1 < 2u) {
                                    } else {
                                        phi_1746_ = true;
                                        break;
                                    }
                                    let _e355 = local_8[_e347.member_1].member;
                                    let _e358 = local_8[_e347.member_1].member_1;
                                    local_9 = _e358;
                                    if ((_e355 & 2147483648u) != 0u) {
                                        let _e363 = local_9.member_1[0u];
                                        let _e366 = local_9.member[0u];
                                        let _e371 = local_9.member_1[1u];
                                        let _e374 = local_9.member[1u];
                                        let _e380 = local_9.member_1[2u];
                                        let _e383 = local_9.member[2u];
                                        let _e386 = ((bitcast<u32>((_e363 - _e366)) | bitcast<u32>((_e371 - _e374))) | bitcast<u32>((_e380 - _e383)));
                                        if (_e386 < 1024u) {
                                            phi_1022_ = 0u;
                                        } else {
                                            phi_1022_ = select(2u, 1u, (_e386 < 2097152u));
                                        }
                                        let _e391 = phi_1022_;
                                        switch bitcast<i32>(_e391) {
                                            case 0: {
                                                phi_1028_ = 1u;
                                                break;
                                            }
                                            case 1: {
                                                phi_1028_ = 2u;
                                                break;
                                            }
                                            case 2: {
                                                phi_1028_ = 3u;
                                                break;
                                            }
                                            default: {
                                                phi_1028_ = u32();
                                                break;
                                            }
                                        }
                                        let _e394 = phi_1028_;
                                        phi_1726_ = _e330;
                                        phi_1035_ = type_8(0u, ((_e355 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e402 = phi_1726_;
                                            let _e404 = phi_1035_;
                                            if (_e404.member < _e404.member_1) {
                                                phi_1036_ = type_8((_e404.member + 1u), _e404.member_1);
                                                phi_1059_ = type_8(1u, _e404.member);
                                            } else {
                                                phi_1036_ = _e404;
                                                phi_1059_ = type_8(0u, type_8().member_1);
                                            }
                                            let _e417 = phi_1036_;
                                            let _e419 = phi_1059_;
                                            let _e423 = (bitcast<i32>(_e419.member) != 0i);
                                            if _e423 {
                                                let _e425 = ((_e355 & 268435455u) + _e419.member_1);
                                                let _e426 = (_e425 < arrayLength((&global_2.member)));
                                                if _e426 {
                                                    let _e427 = (_e425 < _e78);
                                                    if _e427 {
                                                        if _e426 {
                                                        } else {
                                                            phi_1742_ = true;
                                                            break;
                                                        }
                                                        let _e432 = bitcast<f32>((bitcast<u32>((bitcast<i32>(_e86) + 127i)) << bitcast<u32>(23i)));
                                                        let _e433 = local_9.member_1[0u];
                                                        let _e434 = local_9.member[0u];
                                                        let _e437 = local_9.member_1[1u];
                                                        let _e438 = local_9.member[1u];
                                                        let _e442 = local_9.member_1[2u];
                                                        let _e443 = local_9.member[2u];
                                                        let _e446 = ((bitcast<u32>((_e433 - _e434)) | bitcast<u32>((_e437 - _e438))) | bitcast<u32>((_e442 - _e443)));
                                                        if (_e446 < 1024u) {
                                                            phi_1149_ = 0u;
                                                        } else {
                                                            phi_1149_ = select(2u, 1u, (_e446 < 2097152u));
                                                        }
                                                        let _e451 = phi_1149_;
                                                        switch bitcast<i32>(_e451) {
                                                            case 0: {
                                                                phi_1155_ = 1u;
                                                                break;
                                                            }
                                                            case 1: {
                                                                phi_1155_ = 2u;
                                                                break;
                                                            }
                                                            case 2: {
                                                                phi_1155_ = 3u;
                                                                break;
                                                            }
                                                            default: {
                                                                phi_1155_ = u32();
                                                                break;
                                                            }
                                                        }
                                                        let _e454 = phi_1155_;
                                                        let _e455 = (1f / _e432);
                                                        let _e456 = local_9.member[0u];
                                                        let _e459 = local_9.member[1u];
                                                        let _e462 = local_9.member[2u];
                                                        local_5[0u] = (f32(_e456) * _e432);
                                                        local_5[1u] = (f32(_e459) * _e432);
                                                        local_5[2u] = (f32(_e462) * _e432);
                                                        local_4 = array<u32, 10>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                                                        phi_1174_ = type_8(0u, 3u);
                                                        loop {
                                                            let _e469 = phi_1174_;
                                                            if (_e469.member < _e469.member_1) {
                                                                phi_1175_ = type_8((_e469.member + 1u), _e469.member_1);
                                                                phi_1198_ = type_8(1u, _e469.member);
                                                            } else {
                                                                phi_1175_ = _e469;
                                                                phi_1198_ = type_8(0u, type_8().member_1);
                                                            }
                                                            let _e482 = phi_1175_;
                                                            let _e484 = phi_1198_;
                                                            let _e488 = (bitcast<i32>(_e484.member) != 0i);
                                                            if _e488 {
                                                                let _e489 = (3u * _e484.member_1);
                                                                let _e490 = (_e489 + 1u);
                                                                let _e491 = (_e489 + 2u);
                                                                let _e492 = (_e484.member_1 * _e454);
                                                                switch bitcast<i32>(_e451) {
                                                                    case 0: {
                                                                        if (_e489 < 9u) {
                                                                        } else {
                                                                            phi_1718_ = true;
                                                                            break;
                                                                        }
                                                                        let _e671 = global_2.member[_e425].member[_e489];
                                                                        let _e672 = (_e489 % 3u);
                                                                        if (_e672 < 3u) {
                                                                        } else {
                                                                            phi_1718_ = true;
                                                                            break;
                                                                        }
                                                                        let _e675 = local_5[_e672];
                                                                        if (_e490 < 9u) {
                                                                        } else {
                                                                            phi_1718_ = true;
                                                                            break;
                                                                        }
                                                                        let _e685 = global_2.member[_e425].member[_e490];
                                                                        let _e686 = (_e490 % 3u);
                                                                        if (_e686 < 3u) {
                                                                        } else {
                                                                            phi_1718_ = true;
                                                                            break;
                                                                        }
                                                                        let _e689 = local_5[_e686];
                                                                        if (_e491 < 9u) {
                                                                        } else {
                                                                            phi_1718_ = true;
                                                                            break;
                                                                        }
                                                                        let _e702 = global_2.member[_e425].member[_e491];
                                                                        let _e703 = (_e491 % 3u);
                                                                        if (_e703 < 3u) {
                                                                        } else {
                                                                            phi_1718_ = true;
                                                                            break;
                                                                        }
                                                                        let _e706 = local_5[_e703];
                                                                        let _e714 = (_e492 % 10u);
                                                                        if (_e714 < 10u) {
                                                                        } else {
                                                                            phi_1718_ = true;
                                                                            break;
                                                                        }
                                                                        local_4[_e714] = (((bitcast<u32>((((_e671 - _e675) * _e455) + 8388608f)) & 4194303u) | ((bitcast<u32>((((_e685 - _e689) * _e455) + 8388608f)) & 4194303u) << bitcast<u32>(10i))) | ((bitcast<u32>((((_e702 - _e706) * _e455) + 8388608f)) & 4194303u) << bitcast<u32>(20i)));
                                                                        break;
                                                                    }
                                                                    case 1: {
                                                                        if (_e489 < 9u) {
                                                                        } else {
                                                                            phi_1718_ = true;
                                                                            break;
                                                                        }
                                                                        let _e608 = global_2.member[_e425].member[_e489];
                                                                        let _e609 = (_e489 % 3u);
                                                                        if (_e609 < 3u) {
                                                                        } else {
                                                                            phi_1718_ = true;
                                                                            break;
                                                                        }
                                                                        let _e612 = local_5[_e609];
                                                                        let _e618 = (_e490 < 9u);
                                                                        if _e618 {
                                                                        } else {
                                                                            phi_1718_ = true;
                                                                            break;
                                                                        }
                                                                        let _e622 = global_2.member[_e425].member[_e490];
                                                                        let _e623 = (_e490 % 3u);
                                                                        let _e624 = (_e623 < 3u);
                                                                        if _e624 {
                                                                        } else {
                                                                            phi_1718_ = true;
                                                                            break;
                                                                        }
                                                                        let _e626 = local_5[_e623];
                                                                        let _e634 = (_e492 % 10u);
                                                                        if (_e634 < 10u) {
                                                                        } else {
                                                                            phi_1718_ = true;
                                                                            break;
                                                                        }
                                                                        local_4[_e634] = ((bitcast<u32>((((_e608 - _e612) * _e455) + 8388608f)) & 4194303u) | ((bitcast<u32>((((_e622 - _e626) * _e455) + 8388608f)) & 4194303u) << bitcast<u32>(21i)));
                                                                        if _e618 {
                                                                        } else {
                                                                            phi_1718_ = true;
                                                                            break;
                                                                        }
                                                                        if _e624 {
                                                                        } else {
                                                                            phi_1718_ = true;
                                                                            break;
                                                                        }
                                                                        let _e638 = local_5[_e623];
                                                                        if (_e491 < 9u) {
                                                                        } else {
                                                                            phi_1718_ = true;
                                                                            break;
                                                                        }
                                                                        let _e650 = global_2.member[_e425].member[_e491];
                                                                        let _e651 = (_e491 % 3u);
                                                                        if (_e651 < 3u) {
                                                                        } else {
                                                                            phi_1718_ = true;
                                                                            break;
                                                                        }
                                                                        let _e654 = local_5[_e651];
                                                                        let _e663 = ((_e492 + 1u) % 10u);
                                                                        if (_e663 < 10u) {
                                                                        } else {
                                                                            phi_1718_ = true;
                                                                            break;
                                                                        }
                                                                        local_4[_e663] = (((bitcast<u32>((((_e622 - _e638) * _e455) + 8388608f)) & 4194303u) >> bitcast<u32>(11i)) | ((bitcast<u32>((((_e650 - _e654) * _e455) + 8388608f)) & 4194303u) << bitcast<u32>(10i)));
                                                                        break;
                                                                    }
                                                                    case 2: {
                                                                        if (_e489 < 9u) {
                                                                        } else {
                                                                            phi_1718_ = true;
                                                                            break;
                                                                        }
                                                                        let _e498 = global_2.member[_e425].member[_e489];
                                                                        let _e500 = (bitcast<u32>(_e432) & 2147483647u);
                                                                        let _e501 = (_e500 >= 8388608u);
                                                                        if _e501 {
                                                                            phi_1410_ = (bitcast<i32>((_e500 >> bitcast<u32>(23i))) - 127i);
                                                                        } else {
                                                                            phi_1410_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e500)), 32u, (_e500 == 0u))));
                                                                        }
                                                                        let _e514 = phi_1410_;
                                                                        let _e520 = (_e498 * bitcast<f32>((bitcast<u32>((127i - _e514)) << bitcast<u32>(23i))));
                                                                        let _e529 = (_e492 % 10u);
                                                                        if (_e529 < 10u) {
                                                                        } else {
                                                                            phi_1718_ = true;
                                                                            break;
                                                                        }
                                                                        local_4[_e529] = bitcast<u32>(select(0i, select(select(i32(_e520), i32(-2147483648), (_e520 < -2147483600f)), 2147483647i, (_e520 > 2147483500f)), (_e520 == _e520)));
                                                                        if (_e490 < 9u) {
                                                                        } else {
                                                                            phi_1718_ = true;
                                                                            break;
                                                                        }
                                                                        let _e536 = global_2.member[_e425].member[_e490];
                                                                        if _e501 {
                                                                            phi_1456_ = (bitcast<i32>((_e500 >> bitcast<u32>(23i))) - 127i);
                                                                        } else {
                                                                            phi_1456_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e500)), 32u, (_e500 == 0u))));
                                                                        }
                                                                        let _e549 = phi_1456_;
                                                                        let _e555 = (_e536 * bitcast<f32>((bitcast<u32>((127i - _e549)) << bitcast<u32>(23i))));
                                                                        let _e565 = ((_e492 + 1u) % 10u);
                                                                        if (_e565 < 10u) {
                                                                        } else {
                                                                            phi_1718_ = true;
                                                                            break;
                                                                        }
                                                                        local_4[_e565] = bitcast<u32>(select(0i, select(select(i32(_e555), i32(-2147483648), (_e555 < -2147483600f)), 2147483647i, (_e555 > 2147483500f)), (_e555 == _e555)));
                                                                        if (_e491 < 9u) {
                                                                        } else {
                                                                            phi_1718_ = true;
                                                                            break;
                                                                        }
                                                                        let _e572 = global_2.member[_e425].member[_e491];
                                                                        if _e501 {
                                                                            phi_1503_ = (bitcast<i32>((_e500 >> bitcast<u32>(23i))) - 127i);
                                                                        } else {
                                                                            phi_1503_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e500)), 32u, (_e500 == 0u))));
                                                                        }
                                                                        let _e585 = phi_1503_;
                                                                        let _e591 = (_e572 * bitcast<f32>((bitcast<u32>((127i - _e585)) << bitcast<u32>(23i))));
                                                                        let _e601 = ((_e492 + 2u) % 10u);
                                                                        if (_e601 < 10u) {
                                                                        } else {
                                                                            phi_1718_ = true;
                                                                            break;
                                                                        }
                                                                        local_4[_e601] = bitcast<u32>(select(0i, select(select(i32(_e591), i32(-2147483648), (_e591 < -2147483600f)), 2147483647i, (_e591 > 2147483500f)), (_e591 == _e591)));
                                                                        break;
                                                                    }
                                                                    default: {
                                                                        break;
                                                                    }
                                                                }
                                                            }
                                                            continue;
                                                            continuing {
                                                                phi_1174_ = _e482;
                                                                phi_1718_ = _e402;
                                                                break if !(_e488);
                                                            }
                                                        }
                                                        let _e720 = phi_1718_;
                                                        phi_1742_ = _e720;
                                                        if _e720 {
                                                            break;
                                                        }
                                                        let _e723 = global_2.member[_e425].member_1;
                                                        let _e725 = ((3u * _e454) % 10u);
                                                        if (_e725 < 10u) {
                                                        } else {
                                                            phi_1742_ = true;
                                                            break;
                                                        }
                                                        local_4[_e725] = _e723;
                                                        let _e728 = local_4;
                                                        local_6 = _e728;
                                                        phi_1563_ = type_8(0u, 10u);
                                                        loop {
                                                            let _e730 = phi_1563_;
                                                            if (_e730.member < _e730.member_1) {
                                                                phi_1564_ = type_8((_e730.member + 1u), _e730.member_1);
                                                                phi_1587_ = type_8(1u, _e730.member);
                                                            } else {
                                                                phi_1564_ = _e730;
                                                                phi_1587_ = type_8(0u, type_8().member_1);
                                                            }
                                                            let _e743 = phi_1564_;
                                                            let _e745 = phi_1587_;
                                                            let _e749 = (bitcast<i32>(_e745.member) != 0i);
                                                            if _e749 {
                                                                if _e427 {
                                                                } else {
                                                                    phi_1736_ = true;
                                                                    break;
                                                                }
                                                                let _e751 = global_6.member[_e425];
                                                                let _e752 = (_e751 + _e745.member_1);
                                                                if (_e745.member_1 < ((3u * _e394) + 1u)) {
                                                                    let _e754 = (_e752 < arrayLength((&global_7.member)));
                                                                    if _e754 {
                                                                        if (_e745.member_1 < 10u) {
                                                                        } else {
                                                                            phi_1736_ = true;
                                                                            break;
                                                                        }
                                                                        let _e757 = local_6[_e745.member_1];
                                                                        if _e754 {
                                                                        } else {
                                                                            phi_1736_ = true;
                                                                            break;
                                                                        }
                                                                        global_7.member[_e752] = _e757;
                                                                    }
                                                                }
                                                            }
                                                            continue;
                                                            continuing {
                                                                phi_1563_ = _e743;
                                                                phi_1736_ = _e720;
                                                                break if !(_e749);
                                                            }
                                                        }
                                                        let _e762 = phi_1736_;
                                                        phi_1742_ = _e762;
                                                        if _e762 {
                                                            break;
                                                        }
                                                        phi_1745_ = _e762;
                                                    } else {
                                                        phi_1745_ = _e402;
                                                    }
                                                    let _e764 = phi_1745_;
                                                    phi_1744_ = _e764;
                                                } else {
                                                    phi_1744_ = _e402;
                                                }
                                                let _e766 = phi_1744_;
                                                phi_1743_ = _e766;
                                            } else {
                                                phi_1743_ = _e402;
                                            }
                                            let _e768 = phi_1743_;
                                            continue;
                                            continuing {
                                                phi_1726_ = _e768;
                                                phi_1035_ = _e417;
                                                phi_1742_ = _e768;
                                                break if !(_e423);
                                            }
                                        }
                                        let _e771 = phi_1742_;
                                        phi_1746_ = _e771;
                                        if _e771 {
                                            break;
                                        }
                                        phi_1748_ = _e771;
                                    } else {
                                        phi_1748_ = _e330;
                                    }
                                    let _e773 = phi_1748_;
                                    phi_1747_ = _e773;
                                } else {
                                    phi_1747_ = _e330;
                                }
                                let _e775 = phi_1747_;
                                continue;
                                continuing {
                                    phi_1731_ = _e775;
                                    phi_902_ = _e345;
                                    phi_1746_ = _e775;
                                    break if !(_e351);
                                }
                            }
                            let _e778 = phi_1746_;
                            if _e778 {
                                break;
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
fn encode_q21_lattice(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
